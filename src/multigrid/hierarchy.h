/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Levels: grids with fields on them (fields.h), level l with
 * n = 7 2^l + 1 nodes on the same domain (the paper's numbering).
 *
 * On every level the film is
 *     H_i = H0 + gap_i - w_i(P),   w the deformation by that level's kernel.
 * On the finest level gap = X^2/2 - S.  On coarser levels of a cycle gap and F
 * are the right-hand sides of the full approximation scheme (fas.h), so that
 * roughness is never sampled on a coarse grid.
 *
 * The arrays of a level are in lanes (lanes.h), of whatever number the
 * kernels have; ovr_level_read and ovr_level_write go from and to the order of
 * the nodes.
 */
#ifndef OVR_MULTIGRID_HIERARCHY_H
#define OVR_MULTIGRID_HIERARCHY_H

#include "base/arena.h"
#include "multigrid/deformation.h"
#include "multigrid/influence.h"
#include "multigrid/kernels.h"
#include "multigrid/reynolds.h"

/*
 * A grid: nodes X_i = X_a + i D, i = 0..n-1.
 *
 * It covers the whole domain or a window of its parent, the next coarser grid:
 * its node 2 k lies on the parent's node first + k.
 */

typedef struct ovr_grid {
    size_t n;
    double D;     /* mesh size */
    double X_a;   /* of node 0 */
    double *X;    /* of all nodes, after ovr_grid_fill */
    size_t first; /* node of the parent where node 0 lies */
} ovr_grid;

/* Part of a parent: so many mesh sizes from its node `first` on. */
typedef struct ovr_window {
    size_t first, meshes;
} ovr_window;

/* A window of the parent with half its mesh size. */
ovr_status ovr_grid_refine(ovr_grid *grid, const ovr_grid *parent,
                           ovr_window window, ovr_arena *arena, ovr_error *err);

/* The smallest mesh: what floors above ask for in place of D. */
double ovr_grid_mesh(const ovr_grid *grid);

/* Weights of the trapezoidal rule. */
void ovr_grid_weights(const ovr_grid *grid, double *weights);

/* Integral of |a - b| over the grid, a at every so many of its values; both
 * zero at the ends. */
double ovr_grid_distance(const ovr_grid *grid, const double *a, size_t stride,
                         const double *b);

/* Nodes of a grid over the whole domain in the paper's numbering. */
static inline size_t ovr_level_nodes(int number)
{
    return ((size_t)7 << number) + 1;
}

enum { OVR_LEVELS = 24 };

typedef struct ovr_level {
    int number;
    ovr_grid grid;
    ovr_lanes lanes;
    ovr_fields f;
    double force;      /* asked for value of D sum P on this level */
    double k[6];       /* deformation kernel at 0..5 mesh sizes, over pi */
    double local;      /* C of fourth_order.h */
    ovr_shares shares; /* of a distributed change */
    ovr_weights weights;
    ovr_mlmi mlmi;
    /* where cavitation is mass-conserving (content.h): its right-hand sides are
     * its own, no coarser grid's; its inlet is closed; weights of row 1 when
     * open */
    bool leads, closed;
    double opened[3];
    /* pressure that the solids feel beside the film's, what it presses them in;
     * NULL: none */
    double *borne, *pressed;
} ovr_level;

typedef struct ovr_newton {
    double *matrix, *change; /* with the right-hand side; the solution */
    double *kernel[3];       /* K/pi of the coarsest levels */
    int levels;              /* of those, how many */
    /* mass-conserving cavitation, in the order of the nodes: 1 where wet, else
     * 0 */
    double *wet;
} ovr_newton;

/* Pressure that surfaces bear where they touch (mixed_contact.h). */
typedef struct ovr_asperity {
    /* A >= 0 and -dA/dH >= 0 of a film H; NULL: they do not touch */
    void (*at)(const void *law, double H, double *A, double *slope);
    const void *law;
    double share; /* of it that counts, on the way to the whole */
    /* of Newton's method, by node: A, -dA/dH, the whole pressure, what that is
     * above P_f + A, dry or not */
    double *A, *g, *whole, *excess;
    unsigned char *dry, *opened; /* held, but taken for wet on trial */
    int rising; /* steps in a row in which cavitated nodes asked for to rise */
    int failures, omitted; /* of GMRES with the elastic band (tripoles.h) */
    struct ovr_tripoles *tripoles;
    bool
        lifted; /* some film is above that of its pressures (mixed_contact.h) */
    double *lift, *gap;    /* by how much; the gap with it, in lanes */
    double *kernel, *step; /* as those of ovr_newton, of the finest level */
} ovr_asperity;

/* Asked between the cycles of a long solve.  Once it is to stop, cycles do
 * nothing and defects are infinite: whoever iterates gives up by himself.  A
 * solve also stops when its work exceeds a limit.  Work is counted in node
 * cycles, so that the same input stops at the same cycle.  A cycle costs the
 * nodes of its level and n^3/5000 for the dense solve of n coarsest nodes. */
typedef struct ovr_stopping {
    bool (*asked)(void *data); /* NULL: continue */
    void *data;
    bool now;
    double work, limit; /* node cycles (limit 0: unlimited) */
    bool spent;         /* stopped by the limit */
} ovr_stopping;

typedef struct ovr_hierarchy {
    int coarsest, finest; /* level numbers in use */
    ovr_level level[OVR_LEVELS];
    const ovr_kernels *kernels;
    ovr_fluid fluid;
    ovr_operator op;
    double H0;
    int ordered; /* the finest level that is not relaxed in lanes */
    /* mass-conserving cavitation (content.h): asked for when it was built, at
     * the moment; what arrives is given, and inlets may be closed */
    bool content, conserving, supplied;
    bool skewed; /* fields skew and skew_by_P exist */
    ovr_influence influence;

    ovr_band band;      /* work arrays of the finest size */
    double *scratch[2]; /* two of them, for as long as a function */
    ovr_fields natural; /* fields in the order of the nodes, of `ordered` */
    ovr_newton newton;
    ovr_asperity touch;
    ovr_stopping stopping;
} ovr_hierarchy;

/* Replaces the logarithmic mean between nodes by that of the gap, for good. */
void ovr_hierarchy_by_gap(ovr_hierarchy *grids);

/* Asks, until it is to stop. */
bool ovr_hierarchy_stops(ovr_hierarchy *grids);

/* Starts to count work, up to a limit in node cycles (0: none). */
void ovr_hierarchy_allow(ovr_hierarchy *grids, double limit);

/* Returns true if the limit was exceeded.  Further work has no limit then. */
bool ovr_hierarchy_spent(ovr_hierarchy *grids);

/* Limits the work that follows to a share of the limit.  Returns the limit,
 * which ovr_hierarchy_widen restores.  That returns true if the work reached
 * the narrower limit and not the other. */
double ovr_hierarchy_narrow(ovr_hierarchy *grids, double share);
bool ovr_hierarchy_widen(ovr_hierarchy *grids, double limit);

/* Levels coarsest..finest on [X_a, X_b], with MLMI's order and range on each.
 */
typedef struct ovr_hierarchy_form {
    int coarsest, finest;
    double X_a, X_b;
    ovr_mlmi_form mlmi[OVR_LEVELS];
} ovr_hierarchy_form;

/* Builds them; the caller has set kernels, fluid and the options. */
ovr_status ovr_hierarchy_build(ovr_hierarchy *grids,
                               const ovr_hierarchy_form *form, ovr_arena *arena,
                               ovr_error *err);

/* A level on the grid that it has: memory and lanes; its numbers, MLMI's
 * weights like those of a coarser level or NULL; the equation's weights. */
ovr_status ovr_level_build(const ovr_hierarchy *grids, ovr_level *level,
                           ovr_mlmi_form mlmi, ovr_arena *arena,
                           ovr_error *err);
void ovr_level_fill(const ovr_hierarchy *grids, ovr_level *level,
                    const ovr_level *like);
void ovr_level_operator(const ovr_operator *op, ovr_level *level);

/* Writes the numbers that do not change, for which there is memory now. */
void ovr_hierarchy_fill(ovr_hierarchy *grids);

/* Other kernels than those it was built with, before anything is solved. */
void ovr_hierarchy_kernels(ovr_hierarchy *grids, const ovr_kernels *kernels);

/* Sets the operator and with it the weights and shares on every level. */
void ovr_hierarchy_operator(ovr_hierarchy *grids, const ovr_operator *op);

/* w for a pressure in the lanes of a level, whose halo is filled. */
void ovr_level_deform(const ovr_hierarchy *grids, const ovr_level *level,
                      double *P, double *w);

/* Film and properties for the P a level has now; its residual and the phase
 * of its nodes; all of these. */
void ovr_level_film(const ovr_hierarchy *grids, ovr_level *level);
/* The same for the deformation it has. */
void ovr_level_properties(const ovr_hierarchy *grids, ovr_level *level);
void ovr_level_residual(const ovr_hierarchy *grids, ovr_level *level);
void ovr_level_refresh(const ovr_hierarchy *grids, ovr_level *level);

/* Allocates the skew of the flow by temperatures (reynolds_row.h) on all levels
 * and sets the weights of its wedge. */
ovr_status ovr_hierarchy_skew(ovr_hierarchy *grids, bool second_order,
                              ovr_arena *arena, ovr_error *err);

/* Memory for what bears it by a law of the film; the caller sets that.  The
 * finest level is solved by Newton's method then. */
ovr_status ovr_hierarchy_take_asperities(ovr_hierarchy *grids, ovr_arena *arena,
                                         ovr_error *err);

/* Sets it, in the order of the nodes. */
void ovr_level_set_asperity_pressure(const ovr_hierarchy *grids,
                                     const ovr_level *level,
                                     const double *ordered);

/* Relative mass-flow imbalance R of a level whose residual is up to date. */
double ovr_level_imbalance(const ovr_hierarchy *grids, const ovr_level *level);

/* D (sum of P, and of what else is borne): both ends are zero. */
double ovr_level_load(const ovr_hierarchy *grids, const ovr_level *level);

/* n values of one of the level's arrays, to or from the order of the nodes. */
void ovr_level_read(const ovr_hierarchy *grids, const ovr_level *level,
                    const double *values, double *ordered);
void ovr_level_write(const ovr_hierarchy *grids, const ovr_level *level,
                     const double *ordered, double *values);

/* Zero in all of one of its arrays. */
void ovr_level_clear(const ovr_level *level, double *values);

/* All that a smoother may want (`ordered` in fields.h), to grids->natural. */
const ovr_fields *ovr_level_ordered(const ovr_hierarchy *grids,
                                    const ovr_level *level);

/* Value at X = 0 by the cubic through the four nodes about it. */
double ovr_level_centre(const ovr_level *level, const double *values);

#endif
