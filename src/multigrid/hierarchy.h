/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Levels: grids with fields on them (fields.h), level l with n = 7 2^l + 1
 * nodes on the same domain (the paper's numbering).
 *
 * On every level the film is
 *     H_i = H0 + gap_i - w_i(P),   w the deformation by that level's kernel.
 * On the finest level gap = X^2/2 - S.  On coarser levels of a cycle gap and F
 * are the right-hand sides of the full approximation scheme (fas.h), so that
 * roughness is never sampled on a coarse grid.
 *
 * The arrays of a level are stored in lanes (lanes.h), whose number depends on
 * the kernels. ovr_level_read and ovr_level_write convert to and from the order
 * of the nodes.
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
 * A grid covers the whole domain or a window of its parent, the next coarser
 * grid. Node 2 k lies on the parent's node first + k.
 */

typedef struct ovr_grid {
    size_t n;
    double D;     /* mesh size */
    double X_a;   /* X of node 0 */
    double *X;    /* X of all nodes, set by ovr_grid_fill */
    size_t first; /* parent's node at the position of node 0 */
} ovr_grid;

/* Part of a parent: a number of grid intervals from node `first` on. */
typedef struct ovr_window {
    size_t first, meshes;
} ovr_window;

/* Creates the grid of a window of the parent, with half its mesh size. */
ovr_status ovr_grid_refine(ovr_grid *grid, const ovr_grid *parent,
                           ovr_window window, ovr_arena *arena, ovr_error *err);

/* The smallest mesh size in the grid; other modules use it instead of D. */
double ovr_grid_mesh(const ovr_grid *grid);

/* Weights of the trapezoidal rule. */
void ovr_grid_weights(const ovr_grid *grid, double *weights);

/* Integral of |a - b| over the grid; a has a stride. Both functions are zero at
 * the ends. */
double ovr_grid_distance(const ovr_grid *grid, const double *a, size_t stride,
                         const double *b);

/* Number of nodes of a grid over the whole domain, in the paper's numbering. */
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
    double force;      /* required value of D sum P on this level */
    double k[6];       /* deformation kernel at 0..5 mesh sizes, over pi */
    double local;      /* C of fourth_order.h */
    ovr_shares shares; /* distribution of changes in the line relaxation */
    ovr_weights weights;
    ovr_mlmi mlmi;
    /* mass-conserving cavitation (content.h). The right-hand sides are not
     * those of a coarser grid; the inlet is closed; weights of row 1 with an
     * open inlet */
    bool leads, closed;
    double opened[3];
    /* pressure on the solids in addition to the film pressure, and its
     * deformation; NULL: none */
    double *asperity_P, *pressed;
} ovr_level;

typedef struct ovr_newton {
    double *matrix, *change; /* matrix with the right-hand side; solution */
    double *kernel[3];       /* K/pi of the coarsest levels */
    int levels;              /* number of these levels */
    /* mass-conserving cavitation, in the order of the nodes: 1 at pressurized
     * nodes, else 0 */
    double *wet;
} ovr_newton;

/* Asperity pressure in mixed lubrication (mixed_contact.h). */
typedef struct ovr_asperity {
    /* computes A >= 0 and -dA/dH >= 0 for film thickness H; NULL: no asperity
     * contact */
    void (*at)(const void *law, double H, double *A, double *slope);
    const void *law;
    double share; /* fraction of the asperity pressure applied, during
                   * continuation */
    /* for Newton's method, by node: A, -dA/dH, total pressure, and its excess
     * over P_f + A at any node */
    double *A, *g, *whole, *excess;
    unsigned char *dry, *opened; /* opened: cavitated, but assumed to be
                                  * pressurized on trial */
    int rising; /* number of consecutive steps in which cavitated nodes should
                 * become pressurized */
    int failures, omitted; /* numbers of failed and omitted solves by GMRES with
                              the elastic band (tripoles.h) */
    struct ovr_tripoles *tripoles;
    bool lifted; /* `lifted`: some film thickness exceeds that of its pressures
                  * (mixed_contact.h) */
    double *lift, *gap;    /* the excess; the gap including it, in lanes */
    double *kernel, *step; /* as in ovr_newton, for the finest level */
    /* Coarser levels, for nested iteration: the fields of a level that is not
     * in use are stored here (mixed_contact.h) */
    int coarsest; /* 0: none */
    double *kept_P[OVR_LEVELS], *kept_pressed[OVR_LEVELS];
} ovr_asperity;

/* Interruption of long solves. `asked` is called between the cycles. After it
 * returns true, cycles do nothing and residuals are infinite, so that all
 * iterations end. A solve also stops when its work exceeds a limit. Work is
 * counted in node cycles, so that the same input stops at the same cycle. A
 * cycle costs the number of nodes of its level, plus n^3/5000 for the dense
 * solve of n coarsest nodes. */
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
    int ordered; /* finest level without lanes */
    /* mass-conserving cavitation (content.h): enabled at creation; active at
     * present; the supply is given, and inlets may be closed */
    bool content, conserving, supplied;
    bool skewed; /* fields skew and skew_by_P exist */
    ovr_influence influence;

    ovr_band band;      /* work arrays of the finest size */
    double *scratch[2]; /* scratch arrays; not preserved between functions */
    ovr_fields natural; /* fields in the order of the nodes, for levels up to
                         * `ordered` */
    ovr_newton newton;
    ovr_asperity touch;
    ovr_stopping stopping;
} ovr_hierarchy;

/* Replaces the logarithmic mean between nodes by the mean of the gap,
 * permanently. */
void ovr_hierarchy_by_gap(ovr_hierarchy *grids);

/* Calls `asked` unless the solve has already been stopped; returns true to
 * stop. */
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

/* Levels coarsest..finest on [X_a, X_b], with order and range of the MLMI on
 * each. */
typedef struct ovr_hierarchy_form {
    int coarsest, finest;
    double X_a, X_b;
    ovr_mlmi_form mlmi[OVR_LEVELS];
} ovr_hierarchy_form;

/* Builds the levels; the caller has set kernels, fluid and options. */
ovr_status ovr_hierarchy_build(ovr_hierarchy *grids,
                               const ovr_hierarchy_form *form, ovr_arena *arena,
                               ovr_error *err);

/* Builds a level on its grid: allocates memory and lanes; computes its numbers
 * (MLMI weights are copied from a coarser level unless that is NULL); computes
 * the weights of the equation. */
ovr_status ovr_level_build(const ovr_hierarchy *grids, ovr_level *level,
                           ovr_mlmi_form mlmi, ovr_arena *arena,
                           ovr_error *err);
void ovr_level_fill(const ovr_hierarchy *grids, ovr_level *level,
                    const ovr_level *like);
void ovr_level_operator(const ovr_operator *op, ovr_level *level);

/* Computes the constant numbers in the allocated memory. */
void ovr_hierarchy_fill(ovr_hierarchy *grids);

/* Changes the kernels, before anything is solved. */
void ovr_hierarchy_kernels(ovr_hierarchy *grids, const ovr_kernels *kernels);

/* Sets the operator, and computes weights and shares of every level from it. */
void ovr_hierarchy_operator(ovr_hierarchy *grids, const ovr_operator *op);

/* Computes w for a pressure in the lanes of a level, whose halo is filled. */
void ovr_level_deform(const ovr_hierarchy *grids, const ovr_level *level,
                      double *P, double *w);

/* Computes film thickness and properties from P; the residual and the phase of
 * the nodes; or all of these. */
void ovr_level_film(const ovr_hierarchy *grids, ovr_level *level);
/* Computes film thickness and properties from the present deformation. */
void ovr_level_properties(const ovr_hierarchy *grids, ovr_level *level);
void ovr_level_residual(const ovr_hierarchy *grids, ovr_level *level);
void ovr_level_refresh(const ovr_hierarchy *grids, ovr_level *level);

/* Allocates the skew of the flow by temperatures (reynolds_row.h) on all levels
 * and sets the weights of its wedge. */
ovr_status ovr_hierarchy_skew(ovr_hierarchy *grids, bool second_order,
                              ovr_arena *arena, ovr_error *err);

/* Allocates memory for an asperity contact model, which the caller sets. The
 * finest level is then solved by Newton's method. */
ovr_status ovr_hierarchy_take_asperities(ovr_hierarchy *grids, ovr_arena *arena,
                                         ovr_error *err);

/* Allocates memory for asperity contact on up to `depth` coarser levels. */
ovr_status ovr_hierarchy_take_coarse_asperities(ovr_hierarchy *grids, int depth,
                                                ovr_arena *arena,
                                                ovr_error *err);

/* Sets the asperity pressure, in the order of the nodes. */
void ovr_level_set_asperity_pressure(const ovr_hierarchy *grids,
                                     const ovr_level *level,
                                     const double *ordered);

/* Relative mass-flow imbalance R of a level whose residual is up to date. */
double ovr_level_imbalance(const ovr_hierarchy *grids, const ovr_level *level);

/* D sum of P and asperity pressure; both are zero at the ends. */
double ovr_level_load(const ovr_hierarchy *grids, const ovr_level *level);

/* Copies n values of one of the level's arrays, to or from the order of the
 * nodes. */
void ovr_level_read(const ovr_hierarchy *grids, const ovr_level *level,
                    const double *values, double *ordered);
void ovr_level_write(const ovr_hierarchy *grids, const ovr_level *level,
                     const double *ordered, double *values);

/* Sets one of the level's arrays to zero. */
void ovr_level_clear(const ovr_level *level, double *values);

/* Copies all fields marked `ordered` (fields.h) to grids->natural, for
 * smoothers without lanes. */
const ovr_fields *ovr_level_ordered(const ovr_hierarchy *grids,
                                    const ovr_level *level);

/* Value at X = 0, interpolated by the cubic through the four nearest nodes. */
double ovr_level_centre(const ovr_level *level, const double *values);

#endif
