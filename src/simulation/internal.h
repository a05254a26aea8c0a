/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A simulation is made of this; shared by the files of this floor only. */
#ifndef OVR_SIMULATION_INTERNAL_H
#define OVR_SIMULATION_INTERNAL_H

#include "base/arena.h"
#include "multigrid/fourth_order.h"
#include "multigrid/full.h"
#include "multigrid/spike.h"
#include "multigrid/starved.h"
#include "simulation/arrival.h"
#include "simulation/characteristic.h"
#include "simulation/past.h"
#include "simulation/restart.h"
#include "simulation/scheme.h"
#include "simulation/shapes.h"
#include "simulation/simulation.h"
#include "simulation/solution.h"

/* Integral of P at nominal load: pi/2 in Hertz's scaling. */
#define OVR_NOMINAL_LOAD 1.57079632679489661923

/* Memory that step.c has for the finest level, while it is not there. */
typedef struct ovr_last_newton {
    bool taken, mine[OVR_FIELD_COUNT];
    double *field[OVR_FIELD_COUNT], *borne, *pressed;
} ovr_last_newton;

/* A physics (physics.h) of a simulation; is NULL behind the last. */
typedef struct ovr_physics ovr_physics;
enum { OVR_MAX_PHYSICS = 16 };
typedef struct ovr_present {
    const ovr_physics *is;
    void *own;
} ovr_present;

/* The physics of a simulation. */
typedef struct ovr_physics_set {
    const ovr_physics *const *list; /* all there are, NULL after the last */
    ovr_present on[OVR_MAX_PHYSICS + 1]; /* those in use */
    const ovr_present *solver; /* the one with a solver, or NULL: the line */
    unsigned features; /* conflicts.h: physics that options do not contain */
} ovr_physics_set;

/* Operating conditions in time, relative to the nominal ones (NULL: constant),
 * and the rolling direction. */
typedef struct ovr_histories {
    const ovr_history *load, *speed, *sliding;
    const ovr_history *radius, *radius_1;
    bool convected; /* the curvature moves with the material */
    bool backward;  /* um < 0 in the solution now (mirror.h) */
    bool mirrored;  /* the grids hold the mirror image */
} ovr_histories;

/* Limits of a time step. */
typedef struct ovr_step_limits {
    double largest_error; /* adaptive: larger errors reject the step */
    double step_work;     /* node cycles of a step; 0: a minute of CPU */
    double work_done;     /* node cycles of all steps since the start */
} ovr_step_limits;

/* Loss of rolling friction by the domain's inlet (contact/starvation.h) and its
 * arguments at the last observation. */
typedef struct ovr_inlet_share {
    double M, L, X, loss;
    double power; /* rolling power missing in the domain */
} ovr_inlet_share;

/* Shear of the film, for friction. */
typedef struct ovr_shear {
    double *stress;      /* mean over the film, at half nodes */
    double *film_stress; /* mean shear stress of the oil alone, or NULL */
    ovr_inlet_share inlet_share;
} ovr_shear;

/* Work arrays of a solution's nodes, a stack: given back in the reverse order
 * of taking, by the function that took them. */
enum { OVR_WORK_ARRAYS = 4 };
typedef struct ovr_work {
    double *array[OVR_WORK_ARRAYS];
    int taken;
} ovr_work;

/* The steady solve. */
typedef struct ovr_start {
    int strategy;  /* of steady.c, by which the solution was found */
    bool grown;    /* by it features grow (continuation.c) */
    long settling; /* cycles of continuation.c */
    double *saved; /* a P to go back to: of the level below */
    double *saved_before, *lacking; /* continuation.c */
    ovr_refinement refinement[OVR_LEVELS];
    int refinements;
    ovr_stopping stopping;
} ovr_start;

struct ovr_simulation {
    ovr_arena arena;
    ovr_physics_set physics;
    ovr_contact contact;
    ovr_lubricant lubricant;
    ovr_options options;
    const ovr_discretization *scheme;
    ovr_hierarchy grids;
    ovr_level *finest;

    ovr_histories histories;
    ovr_shapes shapes;
    ovr_solution now;
    ovr_work *work;
    ovr_past past;
    ovr_inflow inflow;
    ovr_arrival arrival;
    ovr_start start;
    ovr_last_newton last_newton;
    bool started;
    bool restored;     /* the state is a checkpoint's, no step made since */
    ovr_target target; /* the steady start */
    int order;         /* reached by it */
    ovr_step_limits limits;
    ovr_shear shear;
    /* beside the film's pressure, one, two and three steps ago; or NULL */
    double *borne, *borne_before[2];
    struct ovr_heated *heated; /* temperatures (physics/heat), or NULL */
    /* F of a step without the part that heat adds in each cycle, or NULL */
    double *F_before_heat;
    size_t maximum; /* nodes that a solution may have */

    ovr_state state;
    ovr_observation observation;
    ovr_statistics statistics;
    bool busy; /* is being solved, or marched */
};

/* Observers and surfaces that are called meanwhile may not solve: begin fails
 * then, naming what was asked for. */
ovr_status ovr_simulation_begin(ovr_simulation *sim, const char *what,
                                ovr_error *err);
void ovr_simulation_end(ovr_simulation *sim);

/* Asked between the cycles of the steady solve, which ends with OVR_STOPPED and
 * without a state once it is true. */
void ovr_simulation_stop(ovr_simulation *sim, bool (*stop)(void *data),
                         void *data);

/* A set-up that only counts what it takes; NULL: options that are refused. */
ovr_simulation *ovr_simulation_counted(const ovr_options *options);

/* Fills the automatic options from the contact; OVR_BAD_INPUT names what is
 * out of range.  The domain alone is filled in by the second. */
ovr_status ovr_options_resolve(const ovr_contact *contact, ovr_options *options,
                               ovr_error *err);
void ovr_options_domain(const ovr_contact *contact, ovr_options *options);

/* MLMI order and range of a level. */
ovr_mlmi_form ovr_options_mlmi(const ovr_options *options, int level);

/* Mesh of the finest grid of the whole domain: what steps in time, guesses and
 * tolerances go by. */
double ovr_mesh(const ovr_simulation *sim);

/* Writes the numbers that follow from grids and elastic influence. */
void ovr_simulation_fill(ovr_simulation *sim);

/* The solution is that of the nodes of the whole domain's finest grid. */
void ovr_whole_domain(ovr_simulation *sim);

/* Integral over the domain of a field of the solution's nodes. */
double ovr_integral(const ovr_simulation *sim, const double *f);

/* Tolerances on R for a mesh size D and a film H: a fraction of the
 * discretization error, and the smallest that the residual's rounding allows.
 */
double ovr_truncation_tolerance(const ovr_simulation *sim, double D, double H);
double ovr_negligible_tolerance(const ovr_simulation *sim, double D, double H);

/* Ordinary cycles, that end so many levels above the coarsest. */
ovr_cycling ovr_simulation_cycling(const ovr_simulation *sim, int finer_bottom);

/* The pressure that the solids feel: the film's, where there is none other;
 * else in `workspace`. */
const double *ovr_solid_pressure(const ovr_simulation *sim, double *workspace);

/* Load, speed and radius of the steady start, at least the smallest share of
 * load and speed; films that are predicted go by them. */
void ovr_steady_conditions(ovr_simulation *sim);

/* Keeps records of full multigrid (steady.c). */
void ovr_refinement_watch(void *data, const ovr_level *level,
                          ovr_full_event event, const ovr_full_status *status);

/* The end of a solve or step. */
typedef struct ovr_outcome {
    ovr_defect defect;
    int cycles, retries;
    double error; /* local, of a step */
    bool converged, marked;
    bool spent; /* ended by the limit of work */
} ovr_outcome;

/* Returns the work of a minute of CPU, in node cycles. */
double ovr_minute_of_work(const ovr_simulation *sim);

/* The mesh is too coarse for the film for any way of solving. */
bool ovr_mesh_too_coarse(const ovr_simulation *sim);

/* A finer level, on which that length is resolved. */
int ovr_level_resolving(const ovr_simulation *sim);

/* H > 0 at every node of what was read last. */
bool ovr_surfaces_apart(const ovr_simulation *sim);

/* The tolerance asked for is below the rounding of R, and R as small as it
 * gets. */
bool ovr_below_rounding(const ovr_simulation *sim, const ovr_defect *defect);

/* Beyond this R the result of a step is no longer near a solution: runs
 * recover from less. */
#define OVR_ACCEPTABLE 1e-2

/* A step is halved so often. */
enum { OVR_HALVINGS = 4 };

/* Reports why a solve, or the step to T, failed, and returns the status; the
 * finest level still has what the last attempt left. */
ovr_status ovr_failure_steady(const ovr_simulation *sim,
                              const ovr_outcome *outcome, double tolerance,
                              ovr_error *err);
ovr_status ovr_failure_step(const ovr_simulation *sim,
                            const ovr_outcome *outcome, double T,
                            ovr_error *err);

/* The history term F of the finest grid and the operator for a step of dT to
 * T + dT (time_derivative.c). */
void ovr_time_derivative(ovr_simulation *sim, double dT);

/* Sets F, to which what belongs to no scheme is added. */
void ovr_history_term(ovr_simulation *sim, double *F);

/* One step to the time `next`, observed; *error is its local error.  A step
 * whose error is above sim->limits.largest_error is taken back, with OVR_OK and
 * *taken false. */
ovr_status ovr_simulation_attempt(ovr_simulation *sim, double next, bool *taken,
                                  double *error, ovr_error *err);

/* V = (u1 - u2)/um0 at T. */
double ovr_sliding(const ovr_simulation *sim, double T);

/* Pressure, H0, gap and film of the last time reached. */
void ovr_simulation_step_back(ovr_simulation *sim);

/* P, H, q and eps of the finest level, in the order of the nodes. */
void ovr_simulation_read(ovr_simulation *sim);

/* Arrays of the solution's nodes in the simulation's memory, to where the
 * pointers point; NULL behind the last. */
ovr_status ovr_simulation_take(ovr_simulation *sim, double **const to[],
                               ovr_error *err);
#define OVR_TAKE_NODES(sim, err, ...)                                          \
    ovr_simulation_take(sim, (double **const[]){__VA_ARGS__, NULL}, err)

/* The next work array, with undefined values; back to the stack.  With
 * OVR_CHECKED they are NAN, and giving back another than the last that was
 * taken ends the program. */
double *ovr_work_take(const ovr_simulation *sim);
void ovr_work_give(const ovr_simulation *sim, const double *array);

static inline void ovr_swap(double **a, double **b)
{
    double *kept = *a;
    *a = *b;
    *b = kept;
}

/* Returns the longest adaptive step in mesh sizes (march.c).  A guess is
 * extrapolated over all steps up to it (guess.c): beginning from the last state
 * instead takes four to five times the cycles. */
double ovr_longest_step(const ovr_simulation *sim);

#endif
