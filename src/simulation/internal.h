/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Members of a simulation; for the files of this layer only. */
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

/* Integral of P at the reference load: pi/2 in Hertzian units. */
#define OVR_NOMINAL_LOAD 1.57079632679489661923

/* Memory of step.c for Newton's method on the finest level, while the level
 * does not use it. */
typedef struct ovr_last_newton {
    bool taken, mine[OVR_FIELD_COUNT];
    double *field[OVR_FIELD_COUNT], *asperity_P, *pressed;
} ovr_last_newton;

/* A physical model (physics.h) in a simulation; `is` is NULL after the last. */
typedef struct ovr_physics ovr_physics;
enum { OVR_MAX_PHYSICS = 16 };
typedef struct ovr_present {
    const ovr_physics *is;
    void *own;
} ovr_present;

/* The physical models of a simulation. */
typedef struct ovr_physics_set {
    const ovr_physics *const *list; /* all available models, NULL after the last
                                     */
    ovr_present on[OVR_MAX_PHYSICS + 1]; /* models in use */
    const ovr_present *solver; /* the model with a solver of its own; NULL:
                                * solver of the line contact */
    unsigned features; /* features (conflicts.h) of models that are not selected
                        * by options */
} ovr_physics_set;

/* Time histories of operating conditions relative to the reference values
 * (NULL: constant), and the direction of rolling. */
typedef struct ovr_histories {
    const ovr_history *load, *speed, *sliding;
    const ovr_history *radius, *radius_1;
    bool convected; /* the curvature moves with the material */
    bool backward;  /* um < 0 in the present solution (mirror.h) */
    bool mirrored;  /* the grids contain the mirror image */
} ovr_histories;

/* Limits of a time step. */
typedef struct ovr_step_limits {
    double largest_error; /* adaptive: steps with larger errors are rejected */
    double step_work;     /* maximum node cycles of a step; 0: a minute of CPU
                           * time */
    double work_done;     /* node cycles of all steps since the start */
} ovr_step_limits;

/* Reduction of rolling friction by the finite inlet of the domain
 * (contact/starvation.h), and its arguments at the last observation. */
typedef struct ovr_inlet_share {
    double M, L, X, loss;
    double power; /* rolling power missing in the domain */
} ovr_inlet_share;

/* Shear stresses for friction. */
typedef struct ovr_shear {
    double *stress;      /* mean over the film, at half nodes */
    double *film_stress; /* mean shear stress of the lubricant alone, or NULL */
    ovr_inlet_share inlet_share;
} ovr_shear;

/* Stack of work arrays of the solution's size. A function that takes arrays
 * returns them in reverse order. */
enum { OVR_WORK_ARRAYS = 4 };
typedef struct ovr_work {
    double *array[OVR_WORK_ARRAYS];
    int taken;
} ovr_work;

/* The steady solve. */
typedef struct ovr_start {
    int strategy;  /* strategy in steady.c that found the solution */
    bool grown;    /* features grow in this strategy (continuation.c) */
    long settling; /* number of cycles in continuation.c */
    double *saved; /* P to be restored: solution of the next coarser level */
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
    bool restored;     /* the state is from a checkpoint, and no step has been
                        * made since */
    ovr_target target; /* conditions of the steady start */
    int order;         /* order of the steady solution */
    ovr_step_limits limits;
    ovr_shear shear;
    /* pressure on the solids in addition to the fluid pressure, one, two and
     * three steps ago; or NULL */
    double *asperity_P, *asperity_P_before[2];
    struct ovr_heated *heated; /* temperatures (physics/heat), or NULL */
    /* F of a step without the heat terms that change in each cycle, or NULL */
    double *F_before_heat;
    size_t maximum; /* maximum number of nodes of a solution */

    ovr_state state;
    ovr_observation observation;
    ovr_statistics statistics;
    bool busy; /* a solve or a run is in progress */
};

/* Observers and surface functions called during a solve must not start another
 * one: `begin` then fails, and the message names `what`. */
ovr_status ovr_simulation_begin(ovr_simulation *sim, const char *what,
                                ovr_error *err);
void ovr_simulation_end(ovr_simulation *sim);

/* Sets a function called between the cycles of the steady solve. If it returns
 * true, the solve ends with OVR_STOPPED and without a state. */
void ovr_simulation_stop(ovr_simulation *sim, bool (*stop)(void *data),
                         void *data);

/* Creates a simulation that only counts its memory; NULL if options are
 * invalid. */
ovr_simulation *ovr_simulation_counted(const ovr_options *options);

/* Fills the automatic options from the contact; OVR_BAD_INPUT names an option
 * that is out of range. The second function sets the domain only. */
ovr_status ovr_options_resolve(const ovr_contact *contact, ovr_options *options,
                               ovr_error *err);
void ovr_options_domain(const ovr_contact *contact, ovr_options *options);

/* Order and range of the MLMI on a level. */
ovr_mlmi_form ovr_options_mlmi(const ovr_options *options, int level);

/* Mesh size of the finest grid of the whole domain; used for time steps,
 * guesses and tolerances. */
double ovr_mesh(const ovr_simulation *sim);

/* Computes the numbers that depend on grids and elastic influence. */
void ovr_simulation_fill(ovr_simulation *sim);

/* Makes the nodes of the finest grid of the whole domain the solution's nodes.
 */
void ovr_whole_domain(ovr_simulation *sim);

/* Integral over the domain of a field given at the solution's nodes. */
double ovr_integral(const ovr_simulation *sim, const double *f);

/* Tolerances of R for mesh size D and film thickness H: a fraction of the
 * discretization error; the smallest one that rounding of the residual permits.
 */
double ovr_truncation_tolerance(const ovr_simulation *sim, double D, double H);
double ovr_negligible_tolerance(const ovr_simulation *sim, double D, double H);

/* Parameters of ordinary cycles whose coarsest level is `finer_bottom` levels
 * above the coarsest grid. */
ovr_cycling ovr_simulation_cycling(const ovr_simulation *sim, int finer_bottom);

/* Pressure on the solids: the fluid pressure, or its sum with other pressures,
 * stored in `workspace`. */
const double *ovr_solid_pressure(const ovr_simulation *sim, double *workspace);

/* Sets load, speed and radius of the steady start, with lower bounds for load
 * and speed. Predicted film thicknesses use these values. */
void ovr_steady_conditions(ovr_simulation *sim);

/* Result of a solve or step. */
typedef struct ovr_outcome {
    ovr_defect defect;
    int cycles, retries;
    double error; /* local error of a step */
    bool converged, marked;
    bool rough;       /* a steady solve whose film contains features */
    bool spent;       /* ended by the work limit */
    bool uncorrected; /* a step of a run of order 4 without its corrections */
} ovr_outcome;

/* Returns the number of node cycles that take a minute of CPU time. */
double ovr_minute_of_work(const ovr_simulation *sim);

/* True if the mesh is too coarse for the film, with any solution strategy. */
bool ovr_mesh_too_coarse(const ovr_simulation *sim);

/* Returns a finer level that resolves the inlet. */
int ovr_level_resolving(const ovr_simulation *sim);

/* True if H > 0 at all nodes last read. */
bool ovr_surfaces_apart(const ovr_simulation *sim);

/* True if the tolerance is below the rounding error of R, and R has reached its
 * minimum. */
bool ovr_below_rounding(const ovr_simulation *sim, const ovr_defect *defect);

/* Above this R the result of a step is not close to a solution; runs recover
 * from smaller errors. */
#define OVR_ACCEPTABLE 1e-2

/* Maximum number of times a step is halved. */
enum { OVR_HALVINGS = 4 };

/* Returns an error with the reason why a solve, or the step to T, failed. The
 * finest level must still contain the result of the last attempt. */
ovr_status ovr_failure_steady(const ovr_simulation *sim,
                              const ovr_outcome *outcome, double tolerance,
                              ovr_error *err);
ovr_status ovr_failure_step(const ovr_simulation *sim,
                            const ovr_outcome *outcome, double T,
                            ovr_error *err);

/* Part of such a message: ", relative mass-flow imbalance R" if R is finite,
 * and the limit of cycles if the case sets one. */
typedef struct ovr_reached {
    char text[120];
} ovr_reached;
ovr_reached ovr_failure_reached(const ovr_simulation *sim,
                                const ovr_outcome *outcome);

/* Computes the history term F of the finest grid and the operator for a step dT
 * to T + dT (time_derivative.c). */
void ovr_time_derivative(ovr_simulation *sim, double dT);

/* Sets the right-hand side to F plus the terms that do not depend on the time
 * scheme. */
void ovr_history_term(ovr_simulation *sim, double *F);

/* Makes and observes a step to the time `next`; *error is its local error. A
 * step whose error exceeds sim->limits.largest_error is undone: OVR_OK is
 * returned and *taken is false. */
ovr_status ovr_simulation_attempt(ovr_simulation *sim, double next, bool *taken,
                                  double *error, ovr_error *err);

/* V = (u1 - u2)/um0 at T. */
double ovr_sliding(const ovr_simulation *sim, double T);

/* Restores pressure, H0, gap and film of the last completed time. */
void ovr_simulation_step_back(ovr_simulation *sim);

/* Reads P, H, q and eps of the finest level in the order of the nodes. */
void ovr_simulation_read(ovr_simulation *sim);

/* Allocates arrays for the solution's nodes and stores them in the pointers of
 * the list, which ends with NULL. */
ovr_status ovr_simulation_take(ovr_simulation *sim, double **const to[],
                               ovr_error *err);
#define OVR_TAKE_NODES(sim, err, ...)                                          \
    ovr_simulation_take(sim, (double **const[]){__VA_ARGS__, NULL}, err)

/* Returns the next work array, whose values are undefined; puts an array back
 * on the stack. With OVR_CHECKED the values are NAN, and returning arrays in
 * the wrong order ends the program. */
double *ovr_work_take(const ovr_simulation *sim);
void ovr_work_give(const ovr_simulation *sim, const double *array);

static inline void ovr_swap(double **a, double **b)
{
    double *kept = *a;
    *a = *b;
    *b = kept;
}

/* Returns the longest adaptive step in mesh sizes (march.c).  Initial guesses
 * are extrapolated for all steps up to this length (guess.c); starting from the
 * last state would take four to five times as many cycles. */
double ovr_longest_step(const ovr_simulation *sim);

#endif
