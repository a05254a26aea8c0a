/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A simulation is made of this; shared by the files of this floor only. */
#ifndef OVR_SIMULATION_INTERNAL_H
#define OVR_SIMULATION_INTERNAL_H

#include "base/arena.h"
#include "contact/curvature.h"
#include "multigrid/fourth_order.h"
#include "multigrid/full.h"
#include "multigrid/spike.h"
#include "multigrid/starved.h"
#include "simulation/scheme.h"
#include "simulation/simulation.h"
#include "simulation/solution.h"

/* Integral of P at nominal load: pi/2 in Hertz's scaling. */
#define OVR_NOMINAL_LOAD 1.57079632679489661923

#define OVR_FIELD_AGES(name, ...) double *name[OVR_PAST];

/* Formulas to extrapolate what moves with the features (guess.c). */
enum { OVR_GUESSES = 8 };

/* The past that the time derivative and the extrapolation need: fields of
 * multigrid/fields.h one, two, ... steps ago. */
typedef struct ovr_past {
    union {
        struct {
            OVR_LEVEL_FIELDS(OVR_FIELD_AGES)
        };
        double *all[OVR_FIELD_COUNT][OVR_PAST];
    };
    double H0[OVR_PAST];
    double T[OVR_PAST];
    double dT;      /* length of the last step */
    int steps;      /* how many steps lie behind P[0], 3 at most */
    int still;      /* steps in a row that changed nothing */
    double dT_next; /* adaptive: the step asked for next */
    double change;  /* largest change of P, or of S, in the last step */
    bool backward;  /* um < 0, or had been when it stopped (mirror.h) */
    /* of P, of late, by each formula of guess.c; 0: not known */
    double guess_error[OVR_GUESSES];
} ovr_past;

/* The characteristic scheme needs this beyond the inlet (characteristic.c). */
enum { OVR_GHOSTS = 256 };
typedef struct ovr_inflow {
    double *kernel;   /* K/pi at 0..n+OVR_GHOSTS meshes */
    double *X, *S;    /* at X_a - D, X_a - 2 D, ... */
    double *extended; /* q with ghosts before it */
} ovr_inflow;

/* Oil that is carried along the characteristic (content_history.c). */
typedef struct ovr_carriage {
    double *came;   /* at the nodes now: the content of a step ago there, */
    double *coming; /* and that of now, in a step's time; two steps ago */
    double *coming_twice;
    double *extended; /* the history with ghosts before it */
    /* cells across the first and the last face, a step ago and in this one;
     * whether the inlet was closed then */
    double crossed[2], crossing[2];
    bool closed, closes;
    double flow[2]; /* there, in a time */
    double arrives; /* would flow in, of the film that is supplied */
} ovr_carriage;

/* Memory that step.c has for the finest level, while it is not there. */
typedef struct ovr_last_newton {
    bool taken, mine[OVR_FIELD_COUNT];
    double *field[OVR_FIELD_COUNT], *borne, *pressed;
} ovr_last_newton;

/* The film that arrives (supply.c). */
typedef struct ovr_arrival {
    ovr_supply *supply; /* NULL: flooded */
    void *data;
    double before;    /* in the inlet reservoir at the start */
    double reservoir; /* now */
    bool closed;      /* only what arrives flows in */
    double flooded;   /* central film of the flooded start */
    double flow;      /* what that takes, rho H */
    double q, face;   /* of this step: at X_a, half a mesh further */
    double *kept;     /* contents of a solution on a path, and its inlet */
    bool closed_kept;
    ovr_carriage carriage;
} ovr_arrival;

/* A physics (physics.h) of a simulation; is NULL behind the last. */
typedef struct ovr_physics ovr_physics;
enum { OVR_MAX_PHYSICS = 16 };
typedef struct ovr_present {
    const ovr_physics *is;
    void *own;
} ovr_present;

/* Loss of rolling friction by the domain's inlet (contact/starvation.h) and its
 * arguments at the last observation. */
typedef struct ovr_inlet_share {
    double M, L, X, loss;
    double power; /* rolling power missing in the domain */
} ovr_inlet_share;

/* Work arrays of a solution's nodes, a stack: given back in the reverse order
 * of taking, by the function that took them. */
enum { OVR_WORK_ARRAYS = 4 };
typedef struct ovr_work {
    double *array[OVR_WORK_ARRAYS];
    int taken;
} ovr_work;

struct ovr_simulation {
    ovr_arena arena;
    const ovr_physics *const *list; /* all there are, NULL behind the last */
    ovr_present physics[OVR_MAX_PHYSICS + 1]; /* those that are on */
    ovr_contact contact;
    ovr_lubricant lubricant;
    ovr_options options;
    const ovr_discretization *scheme;
    ovr_hierarchy grids;
    ovr_level *finest;

    ovr_heights *heights;
    void *heights_data;
    ovr_heights *sides[2]; /* heights of surface 1 and 2, or both NULL */
    ovr_heights *sides_of; /* the heights whose parts these are, and data */
    void *sides_data;
    /* Features that vary across, of the same data, or NULL.  `Y` belongs to the
     * line that `now` holds (solver.h). */
    ovr_heights_across *across;
    double Y;
    const ovr_present *solver; /* a physics with a solver, or NULL: the line */
    ovr_heights *standing;     /* of what stands still, or NULL */
    void *standing_data;
    bool standing_given;
    const ovr_history *load, *speed, *sliding;
    const ovr_history *radius, *radius_1;
    bool convected;   /* the curvature, with the material */
    double moving;    /* u_k/um of the features; NAN: nobody told */
    double roughness; /* composite Rq of both surfaces; 0: not known */

    double *S;
    ovr_solution now;
    ovr_work *work;
    ovr_past past;
    ovr_inflow inflow;
    ovr_arrival arrival;
    ovr_last_newton last_newton;
    bool started;
    bool restored;     /* the state is a checkpoint's, no step made since */
    bool backward;     /* of what is solved now: um < 0 (mirror.h) */
    bool mirrored;     /* the grids hold the mirror image */
    int strategy;      /* of steady.c, by which the steady solution was found */
    bool grown;        /* by it features grow (growth.c) */
    long settling;     /* cycles of growth.c in this steady solve */
    ovr_target target; /* the steady start */
    int order;         /* reached by it */
    unsigned
        features; /* conflicts.h, of physics that the options do not know */
    double largest_error; /* adaptive: a step with more is not accepted */
    double *S_past;       /* surface one step ago */
    double *stress;       /* mean over the film, at half nodes */
    ovr_inlet_share inlet_share;
    double *film_stress; /* mean shear stress of the oil alone, or NULL */
    /* beside the film's pressure, one, two and three steps ago; or NULL */
    double *borne, *borne_before[2];
    struct ovr_heated *heated; /* temperatures (physics/heat), or NULL */
    /* F of a step without the part that heat adds in each cycle, or NULL */
    double *F_before_heat;
    size_t maximum; /* nodes that a solution may have */

    double *saved; /* a P to go back to: steady, of the level below */
    double *saved_before, *lacking; /* continuation.c */
    ovr_refinement refinement[OVR_LEVELS];
    int refinements;
    ovr_state state;
    ovr_observation observation;
    ovr_statistics statistics;
    ovr_stopping stopping; /* of the steady solve */
    bool busy;             /* is being solved, or marched */
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

/* Height of what is on both surfaces at T: features, and what physics add. */
void ovr_surface_heights(const ovr_simulation *sim, double T, size_t n,
                         const double *X, double *S);

/* Computes the heights that move with surface 1 or 2 at the nodes and at the
 * time of S.  Returns false if it is smooth. */
bool ovr_heights_of(const ovr_simulation *sim, int surface, double *S);

/* The pressure that the solids feel: the film's, where there is none other;
 * else in `workspace`. */
const double *ovr_solid_pressure(const ovr_simulation *sim, double *workspace);

/* True if there is anything but the smooth surfaces. */
bool ovr_has_heights(const ovr_simulation *sim);

/* Sets S and the finest gap X^2/2 - S at time T. */
void ovr_simulation_gap(ovr_simulation *sim, double T);

/* Tells of the smooth surfaces at T whether they open all over the domain. */
ovr_smooth ovr_simulation_smooth(const ovr_simulation *sim, double T);
ovr_status ovr_smooth_check(const ovr_simulation *sim, double T,
                            ovr_error *err);

/* Load, speed and radius of the steady start, at least the smallest share of
 * load and speed; films that are foreseen go by them. */
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
} ovr_outcome;

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

/* True if cavitation is mass-conserving (multigrid/content.h). */
bool ovr_conserves(const ovr_simulation *sim);

/* The steady film where cavitation is mass-conserving, corrected where that
 * applies; one without corrections again. */
ovr_defect ovr_fourth_conserved(ovr_simulation *sim, const ovr_full *how,
                                ovr_defect solved, int *cycles);
void ovr_fourth_leave(ovr_simulation *sim);

/* Computes the corrections anew of a steady film that another physics has
 * changed; leaves them out where that did not converge, true if there were any.
 */
void ovr_fourth_renew(ovr_simulation *sim);
bool ovr_fourth_give_up(ovr_simulation *sim);

/* Adds them to the right-hand side and to the discrete gap at the nodes. */
void ovr_fourth_sides(const ovr_simulation *sim, double *F);
void ovr_fourth_gap(const ovr_simulation *sim, double *gap);

/* The history term where cavitation is mass-conserving (content_history.c). */
void ovr_content_history(ovr_simulation *sim, double dT, const double c[2]);

/* The pieces of memory that make up a state, shown one after the other by name
 * (ovr_simulation_visit): once one of them failed no other is. */
typedef struct ovr_pieces {
    ovr_visit *visit;
    void *context;
    ovr_error *err;
    ovr_status status;
} ovr_pieces;
void ovr_show(ovr_pieces *state, const char *name, void *memory, size_t bytes);

/* A number; "NAME_3", an array of the solution's nodes. */
#define OVR_SHOW(state, name, number)                                          \
    ovr_show(state, name, &(number), sizeof(number))
void ovr_show_nodes(const ovr_simulation *sim, ovr_pieces *state,
                    const char *name, int number, double *values);

/* The same along the characteristic (content_history.c): memory, the history
 * term, a step that is taken, its checkpoint. */
ovr_status ovr_carriage_take(ovr_simulation *sim, ovr_error *err);
void ovr_carriage_history(ovr_simulation *sim, double dT, const double c[2]);
void ovr_carriage_taken(ovr_simulation *sim);

/* x at the departure points, from the last time reached to T; nothing is before
 * the inlet.
 */
void ovr_carriage_move(ovr_simulation *sim, double T, const double *x,
                       double *to);
void ovr_carriage_visit(ovr_simulation *sim, ovr_pieces *state);

/* True if only what arrives enters in the step to come; q at X_a - D, X_a - 2
 * D, ... at T, of what arrives later, written downwards from `last`. */
bool ovr_arrival_closes(const ovr_simulation *sim);
void ovr_arrival_ghosts(const ovr_simulation *sim, double T, size_t ghosts,
                        double *last);

/* Memory for the characteristic scheme, and its history term:
 *     F_i = c1 q^k(X_i - a1) + c2 q^{k-1}(X_i - a2). */
ovr_status ovr_inflow_take(ovr_simulation *sim, ovr_error *err);
void ovr_inflow_fill(ovr_simulation *sim);
void ovr_inflow_history(ovr_simulation *sim, const double c[2],
                        const double a[2], double *F);

/* q of a past time at so many ghosts before the inlet, in extended[]. */
void ovr_inflow_ghosts(ovr_simulation *sim, int past, size_t ghosts);

/* Weights of six points at the place `at` among them, counted from 0. */
void ovr_lagrange(double at, double weight[6]);

/* q at T as the past predicts it along the characteristics: the sum of e_k
 * q^{k}(X_i - a_k); false if that is further than the ghosts reach. */
bool ovr_inflow_prediction(ovr_simulation *sim, double T, const double e[3],
                           double *q);

/* F_i += c q(X_i - a) of any q; worth nothing before the node returned, whose
 * departure point is inside. */
size_t ovr_inflow_departure(const ovr_simulation *sim, const double *q,
                            double c, double a, double *F);

/* q[t, t-1, t-2, t-3] of the newest solution, at T, and the past before it: the
 * third divided difference along the characteristics, at the nodes.  What is
 * before the start is a step of dT before what follows it.  False, and nothing
 * done, if that is further than the ghosts reach. */
bool ovr_inflow_third(ovr_simulation *sim, double T, double dT, double *third);

/* The way of a particle since the k-th time of the past, at T. */
double ovr_travel_since(const ovr_simulation *sim, int past, double T);

/* True if a characteristic step of this length has enough ghosts. */
bool ovr_inflow_reaches(const ovr_simulation *sim, double travel);

/* P and H0 at T + dT before the step is solved: extrapolated, or those of the
 * last time.  Whether it is close: not just the trend, but what moves has
 * been moved on. */
bool ovr_guess(ovr_simulation *sim, double dT, bool extrapolated);

/* What each formula would have guessed for the step of dT that was solved just
 * now, before it becomes the past. */
void ovr_guess_learn(ovr_simulation *sim, double dT);

/* The errors of steps like this one of h add this to the film on its way
 * through the contact, relative to H_cen; 0 when there is no past to judge
 * by. */
double ovr_step_error(ovr_simulation *sim, double h);

/* One step to the time `next`, observed; *error is its local error.  A step
 * whose error is above sim->largest_error is taken back, with OVR_OK and *taken
 * false. */
ovr_status ovr_simulation_attempt(ovr_simulation *sim, double next, bool *taken,
                                  double *error, ovr_error *err);

/* The scheme's own mass flow at the half node i + 1/2; Cu = um/um0. */
double ovr_flux(const ovr_simulation *sim, double Cu, size_t i);

/* The scheme takes this of a content q at i + 1/2, from upstream; what flows
 * there beside the film's own (physics.h). */
double ovr_upstream(const ovr_simulation *sim, const double *q, size_t i);
double ovr_flow_beside(const ovr_simulation *sim, size_t i, bool mean);

/* Relative error of the mass balance over the step just made. */
double ovr_mass_balance(const ovr_simulation *sim);

/* V = (u1 - u2)/um0 at T. */
double ovr_sliding(const ovr_simulation *sim, double T);

/* Friction of the film that was read last (friction.c), its coefficients and
 * powers; shear stress in the film at a surface, at half nodes. */
void ovr_observe_friction(ovr_simulation *sim, ovr_observation *o);

/* Computes forces, coefficients and power_in from F_slide, F_roll and the
 * forces on slopes. */
void ovr_friction_forces(const ovr_simulation *sim, ovr_observation *o);
const double *ovr_wall_stress(const ovr_simulation *sim, int surface,
                              double *workspace);

/* Pressure, H0, gap and film of the last time reached. */
void ovr_simulation_step_back(ovr_simulation *sim);

/* P, H, q and eps of the finest level, in the order of the nodes. */
void ovr_simulation_read(ovr_simulation *sim);

/* Points the public state at the solution. */
void ovr_publish_state(ovr_simulation *sim);

/* Takes what is observed into the extremes and means of the run; none of them
 * is known; where one of them is (overall.c). */
void ovr_statistics_take(ovr_statistics *s, const ovr_observation *o,
                         bool first);
void ovr_statistics_unknown(ovr_statistics *s);
double *ovr_kept_number(const ovr_extreme *which, ovr_statistics *of);

/* Film, pressure, mass flow and friction of the line that `now` holds. */
void ovr_observe_line(ovr_simulation *sim, ovr_observation *o);

/* Fills the state's fields and the observation from the finest level. */
void ovr_observe(ovr_simulation *sim, double dT, const ovr_outcome *outcome);

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
