/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strip of a simulation (solver.h): grids of src/strip, their time steps,
 * and the values at all nodes in the order of files. */
#ifndef OVR_PHYSICS_STRIP_STRIP_H
#define OVR_PHYSICS_STRIP_STRIP_H

#include "simulation/physics.h"
#include "strip/march.h"

/* --------------------------------------------------------------- the case */

typedef struct ovr_strip_form {
    double width; /* period across, b */
    int lines;    /* 0: from the mesh size along x */
    int ends;     /* 1: periodic; 0: no strip */
    double shown; /* Y of the line in tables and pictures; NAN: the first
                     feature */
    int threads;
    double M; /* Moes number, for the coarsest grid */
    double seconds, cycle_seconds;
} ovr_strip_form;

extern const ovr_section ovr_strip_section;

void ovr_strip_choose(const void *form, ovr_options *options);
ovr_status ovr_strip_resolve(const ovr_physics_case *of, void *form, bool *on,
                             ovr_error *err);
ovr_status ovr_strip_on_mesh(const ovr_physics_case *of, void *form, double D,
                             ovr_error *err);

/* Nodes along x of the coarsest grid: heavily loaded contacts need more. */
size_t ovr_strip_coarsest(double M);

void ovr_strip_state(const void *form, ovr_physics_effects *effects);
void ovr_strip_describe(const ovr_physics_case *of, const void *form,
                        ovr_physics_line *line, void *data);
double ovr_strip_seconds(const void *form);
double ovr_strip_cycle_seconds(const void *form);
size_t ovr_strip_lines_across(const void *form, double D);

/* Lines of the finest grid on a mesh size D along x. */
size_t ovr_strip_lines(const ovr_strip_form *form, double D);

/* ------------------------------------------------------------- the solver */

/* Places in ovr_observation.more. */
enum {
    OVR_STRIP_Y_MIN = 16,
    OVR_STRIP_Y_MAX,
    OVR_STRIP_FILM_LOW,
    OVR_STRIP_FILM_HIGH,
    OVR_STRIP_FILM_SPREAD,
    OVR_STRIP_PRESSURE_SPREAD,
    OVR_STRIP_Y_LEAST /* Y of the minimum film thickness over the run */
};

typedef struct ovr_strip_solver {
    const ovr_strip_form *form;
    ovr_strip strip;
    ovr_strip_march march;
    size_t n, lines, shown;
    size_t middle;  /* last node with X <= 0 */
    double *X, *Y;  /* nodes along x; lines, from -W/2 on */
    double *across; /* heights of a line contact, for copying to all lines */
    double *along;  /* nodes at which heights are requested */
    double *S, *S_before; /* heights, line after line */
    double *located[2];   /* minimum film thickness and maximum pressure of each
                             line */
    /* Mean of rho H up to `middle` now, one and two steps ago.  Mass flow at
     * both ends of that part. */
    double mass[3], flow[2];
    double grown; /* part of their heights that features have */
    /* Part of the heights that growing features have reached; NAN: none grew */
    double reached;
    double least[2]; /* minimum film thickness over the run, and its Y */
} ovr_strip_solver;

/* Returns the strip, or NULL for a line contact. */
ovr_strip_solver *ovr_strip_of(const ovr_simulation *sim);

/* The finest grid. */
static inline const ovr_strip_level *ovr_strip_finest(const ovr_strip_solver *s)
{
    return &s->strip.level[s->strip.finest];
}

/* Copies line j to `now` and to the heights of the simulation. */
void ovr_strip_show(ovr_simulation *sim, const ovr_strip_solver *s, size_t j);

/* An ovr_strip_gap: of the smooth surfaces minus the heights on them. */
void ovr_strip_gap_of(void *data, double T, const ovr_strip_grid *g,
                      ptrdiff_t from, size_t n, double *gap);

/* Keeps the heights that belong to the gap at T. */
void ovr_strip_keep_heights(const ovr_simulation *sim, ovr_strip_solver *s,
                            double T);

/* The fluid of the conditions at T. */
void ovr_strip_set_fluid(ovr_simulation *sim, ovr_strip_solver *s, double T);

/* -INFINITY where a film is no number. */
double ovr_strip_smallest_film(ovr_strip_solver *s);

/* The steady film (start.c); returns the tolerance. */
double ovr_strip_steady_film(ovr_simulation *sim, void *own,
                             ovr_outcome *outcome);
ovr_status ovr_strip_explain(const ovr_simulation *sim, const void *own,
                             const ovr_outcome *outcome, ovr_error *err);

/* Observes all lines. */
void ovr_strip_observe(ovr_simulation *sim, void *own, ovr_observation *o);
void ovr_strip_unknown(ovr_observation *o);

enum { OVR_STRIP_QUANTITIES = 7 };
extern const ovr_observable ovr_strip_quantities[OVR_STRIP_QUANTITIES];

#endif
