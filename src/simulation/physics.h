/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A physical model ("physics") is a record of functions that extends Reynolds
 * equation, film thickness equation and force balance. Steady solve, time step,
 * observation, checkpoint and case call the functions of all models in a list
 * (src/physics/list.c) without naming any of them. A new model consists of a
 * file with its record and an entry in that list.
 *
 * A record has up to four parts: case, solve, step and output. A part or a
 * function may be absent. A simulation contains the active models in the order
 * of the list and calls functions of these only. `own` is the model's private
 * data in a simulation.
 *
 * Contributions to the gap (heights), the elastic influence and the shear
 * stress (friction) are summed over the list. Functions that "replace" the
 * standard method: only the last one in the list is called, in place of the
 * standard method.
 */
#ifndef OVR_SIMULATION_PHYSICS_H
#define OVR_SIMULATION_PHYSICS_H

#include "base/parameter.h"
#include "contact/heat_numbers.h"
#include "simulation/internal.h"
#include "simulation/solver.h"
#include "surface/two_columns.h"

/* In place of a key in an error: the message itself begins with its place. */
#define OVR_HAS_PLACE ""

/* Properties of a body; NAN: unknown. */
typedef struct ovr_physics_body {
    double modulus, poisson;
    double yield; /* yield stress (von Mises) relative to p_h; 0: none */
    ovr_thermal thermal;
} ovr_physics_body;

/* M(t): ratio of the surface temperature after a heat pulse to that of a
 * half-space (contact/layers.h). */
typedef struct ovr_warmth {
    double (*at)(const void *data, double t);
    const void *data;
} ovr_warmth;

struct ovr_change; /* change of a key that is a history */

/* Arguments for resolving a model in a case: the contact and the known data of
 * the run. */
typedef struct ovr_physics_case {
    const struct ovr_setup *setup; /* defined in a higher layer */
    const ovr_contact *contact;
    const ovr_lubricant *lubricant;
    const struct ovr_oil *oil;       /* lubricant in SI units */
    ovr_options *options;            /* options that can still be changed */
    struct ovr_passes_setup *passes; /* passes; can still be changed */
    bool transient;
    double end;                         /* end time of a run; 0: none */
    const ovr_history *speed, *sliding; /* NULL: constant */
    ovr_physics_body body[2];
    double raceway;    /* raceway circumference of a bearing in b; NAN: none */
    unsigned physics;  /* bits of the models switched on by a key */
    double substrate;  /* reduced modulus E' of the bodies as given, Pa */
    bool by_substrate; /* b and p_h are those of the bodies without layers */
    ovr_arena *arena;  /* memory with the lifetime of the form */
    size_t features;   /* number of features of both surfaces, on the grid or
                        * not */
    const struct ovr_feature_form *const *feature;

    /* Reads the file that is the value of a key in the model's sections. */
    ovr_status (*read)(void *data, const char *key, const char *file,
                       ovr_two_columns *columns, ovr_error *err);

    /* True if a section is in the case; or, with `key`, if that key is set. */
    bool (*given)(void *data, const char *section, const char *key);

    /* Creates the history of a section; NULL if it is constant. */
    ovr_status (*history)(void *data, const char *section,
                          const struct ovr_change *change,
                          ovr_history **history, ovr_error *err);
    void *data;
} ovr_physics_case;

/* Callback for a line of the report of `check`: a name and a text. */
typedef void ovr_physics_line(void *data, const char *name, const char *text);

/* Callback that receives a note or a warning. */
typedef void ovr_physics_message(void *data, bool warning, const char *text);

/* Fields that exist only with a physical model. */
typedef enum ovr_physics_field {
    OVR_FIELD_TEMPERATURE_1, /* temperature of surface 1, K */
    OVR_FIELD_TEMPERATURE_2,
    OVR_FIELD_TEMPERATURE_MEAN, /* mean across the film */
    OVR_FIELD_TEMPERATURE_MIDDLE,
    OVR_FIELD_HEAT_FLUX_1, /* heat flux into surface 1 */
    OVR_FIELD_HEAT_FLUX_2
} ovr_physics_field;

/* Text about these fields, and their names separated by ", ". */
typedef struct ovr_own_fields {
    const char *are, *names;
} ovr_own_fields;

/* Effects of a form on the run. */
typedef struct ovr_physics_effects {
    unsigned bits;       /* bits in addition to the model's own */
    unsigned features;   /* model features (conflicts.h) that are switched on */
    const char *fields;  /* additional fields of a result file, separated by ",
                          * " */
    double width_across; /* period across the rolling direction in b; 0: none */
    double arrives;      /* supplied film thickness at T = 0; INFINITY: flooded
                          */
} ovr_physics_effects;

/* Part in the case. */
typedef struct ovr_physics_in_case {
    /* sections whose rows fill the form, a struct of this size that is
     * initialized to zero; none: the keys are options of any simulation, or
     * there are no keys. Help and files list them after the case section of
     * that name, or last if NULL */
    const ovr_section *section;
    size_t sections, form;
    const char *behind;

    /* Sets options from the form, before the other options are resolved. */
    void (*choose)(const void *form, ovr_options *options);

    /* For a section with named blocks: returns in *into the part of the form
     * for the block `name`, initialized with defaults. */
    ovr_status (*block)(void *form, const char *name, void **into,
                        ovr_error *err);

    /* Ratio of the E' of equivalent homogeneous bodies (same contact width at
     * the same load) to the E' of the given bodies. b and p_h of the contact
     * are those of the equivalent bodies. The form is in units of the contact
     * with the ratio found last. */
    ovr_status (*stiffness)(const ovr_physics_case *of, void *form,
                            double *ratio, ovr_error *err);

    /* Resolves the form in units of the contact; *on: the model is active. An
     * error names a key of its rows or of [lubricant], a block, a section,
     * "section.key", or OVR_HAS_PLACE. */
    ovr_status (*resolve)(const ovr_physics_case *of, void *form, bool *on,
                          ovr_error *err);

    /* Resolves numbers that depend on the mesh size, after the domain is known.
     */
    ovr_status (*on_mesh)(const ovr_physics_case *of, void *form, double mesh,
                          ovr_error *err);

    /* Frees memory of the form that is not in the arena. */
    void (*drop)(void *form);

    /* Sets end and step of a run that the model defines in place of [time], and
     * its scheme if *scheme < 0. Returns false if it defines none. */
    bool (*march)(const void *form, ovr_march *march, int *scheme);

    /* Number of lines across the rolling direction, for mesh size D along x. */
    size_t (*lines_across)(const void *form, double D);

    /* Fields that exist only with this model; NULL: none. */
    const ovr_own_fields *own_fields;

    /* Reason why the default step of a run is one mesh size; NULL: it may be
     * longer. */
    const char *one_mesh;

    /* Relative film thickness error added in a run, per step length in b/um. */
    double lag;

    /* True if the model uses a feature itself, which is then not on the grid.
     */
    bool (*keeps)(const void *form, const struct ovr_feature_form *feature);

    /* Calls `line` for each number of the form that is shown to users. */
    void (*describe)(const ovr_physics_case *of, const void *form,
                     ovr_physics_line *line, void *data);

    /* Memory in bytes in addition to that of the simulation, for a prepared
     * case. */
    double (*memory)(const void *form);

    /* Approximate additional CPU seconds per node and step; and per pass. */
    double node_seconds;
    double (*seconds)(const void *form);

    /* CPU seconds of a cycle of a steady solve by a solver of its own. */
    double (*cycle_seconds)(const void *form);

    /* Layers on a body, in units b and p_h; NULL: none. */
    const struct ovr_coated *(*layers)(const void *form, int body);

    /* Fills in the effects of an active form; they are initialized to zero and
     * `arrives` to INFINITY. */
    void (*effects)(const void *form, ovr_physics_effects *effects);
} ovr_physics_in_case;

/* Part in the creation of a simulation and in the steady solution. */
typedef struct ovr_physics_in_solve {
    /* The steady solution has its own nodes: a result file can be opened only
     * after the solve, and runs cannot be resumed. */
    bool makes_nodes;

    /* True if the options select the model. */
    bool (*chosen)(const ovr_options *options);

    /* Sets properties of the grids before they are built. */
    void (*prepare)(ovr_hierarchy *grids);

    /* Allocates memory from the simulation. Only pointers may be written,
     * because the memory may only be counted. `form` is the form of the case,
     * or NULL if the options selected the model. */
    ovr_status (*take)(ovr_simulation *sim, const void *form, void **own,
                       ovr_error *err);

    /* Applies the settings of the form that are not options, after the time
     * histories have been set. */
    void (*equip)(ovr_simulation *sim, void *form);

    /* Frees memory outside the simulation. */
    void (*release)(void *own);

    /* Solver that replaces that of the line contact (solver.h). */
    const ovr_solver *solver;

    /* Adds parts to the elastic influence. */
    void (*influence)(const ovr_simulation *sim, void *own,
                      ovr_influence *influence);

    /* Returns the temperature of surface k after a heat pulse relative to that
     * of a half-space. */
    void (*warmth)(const ovr_simulation *sim, const void *own, int k,
                   ovr_warmth *to);

    /* Adds to the heights of surface 1 or 2, or to their sum (0), at any X,
     * outward positive.  The heights are subtracted from the smooth gap.
     * Heights of a surface move with it; the sum may include others. */
    void (*heights)(const ovr_simulation *sim, const void *own, int surface,
                    double T, size_t n, const double *X, double *S);

    /* Resets the state before each attempt, as if the model were off. */
    void (*forget)(ovr_simulation *sim, void *own);

    /* Called before the equation of the steady start is set. */
    void (*before_start)(ovr_simulation *sim, void *own);

    /* Replaces the solution of the film from scratch. */
    ovr_defect (*solve)(ovr_simulation *sim, void *own, const ovr_full *how,
                        int *cycles);

    /* Completes the film found by this model, as far as cycles alone can. */
    ovr_defect (*complete)(ovr_simulation *sim, void *own, const ovr_full *how,
                           int *cycles);

    /* Solves film and model alternately until both are converged; called again
     * whenever the film has changed. */
    void (*couple)(ovr_simulation *sim, void *own, const ovr_full *how,
                   ovr_outcome *outcome);

    /* Computes the final film from the present one, the initial guess. Returns
     * false if the model does not do this. */
    bool (*proceed)(ovr_simulation *sim, void *own, const ovr_full *how,
                    ovr_outcome *outcome);

    /* Returns an error with the reason why a steady start did not converge, if
     * the reason is this model. */
    ovr_status (*explain)(const ovr_simulation *sim, const void *own,
                          const ovr_outcome *outcome, ovr_error *err);

    /* Final processing of the steady solution. */
    void (*finish)(ovr_simulation *sim, void *own, const ovr_full *how,
                   ovr_outcome *outcome);

    /* Fails if the converged and observed steady solution is outside the range
     * of validity of the model. */
    ovr_status (*refuse)(const ovr_simulation *sim, const void *own,
                         ovr_error *err);

    /* Called when the steady solution becomes the past of a run. */
    void (*begin)(ovr_simulation *sim, void *own);
} ovr_physics_in_solve;

/* Part in time steps, and in checkpoints between them. */
typedef struct ovr_physics_in_step {
    /* Fails if a step, or the steady start, is not possible. */
    ovr_status (*check)(const ovr_simulation *sim, const void *own,
                        ovr_error *err);

    /* Called before the equation of a step to T is set. */
    void (*before_step)(ovr_simulation *sim, void *own, double T);

    /* Changes the operator for a step dT; dT = 0: steady start. */
    void (*operate)(const ovr_simulation *sim, const void *own, double dT,
                    ovr_operator *op);

    /* Replaces the history term; c are the weights of the past. */
    void (*history)(ovr_simulation *sim, void *own, double dT,
                    const double c[2]);

    /* Called after the equation of the step dT is set. */
    void (*step)(ovr_simulation *sim, void *own, double dT);

    /* Called when the initial guess of an attempt has been set. `corrected`:
     * with fourth-order corrections. */
    void (*attempt)(ovr_simulation *sim, void *own, bool corrected);

    /* Called after a cycle of the step: updates the model with the new film, if
     * necessary, and recomputes film and residual. */
    void (*update)(ovr_simulation *sim, void *own);

    /* During continuation (continuation.c): stores the model's data of the last
     * solution on the finest level; restores those data, whose pressure was P.
     */
    void (*keep)(ovr_simulation *sim, void *own);
    void (*go_back)(ovr_simulation *sim, void *own, const double *P);

    /* Called after the step dT is accepted and before it becomes the past. */
    void (*accepted)(ovr_simulation *sim, void *own, double dT);

    /* Writes advice for a step that did not converge, appended to the reason; H
     * is the film thickness of the reference contact. */
    void (*advise)(const ovr_simulation *sim, double H, size_t size,
                   char *text);

    /* True if the run has nothing further to compute. */
    bool (*over)(const ovr_simulation *sim, const void *own);

    /* Restores the last completed time: called before pressure and gap are
     * restored, and after. */
    void (*before_back)(ovr_simulation *sim, void *own);
    void (*step_back)(ovr_simulation *sim, void *own);

    /* Visits the model's data that belong to the state between two steps;
     * computes dependent data after they have been read, before step_back. */
    void (*visit)(ovr_simulation *sim, void *own, ovr_pieces *state);
    void (*restored)(ovr_simulation *sim, void *own);

    /* Restores observations that cannot be computed from the state. */
    void (*recalled)(ovr_observation *o, const ovr_observation *saved);
} ovr_physics_in_step;

/* Part in observations and files. */
typedef struct ovr_physics_in_output {
    /* Content convected with the film at half node i + 1/2, where the scheme
     * has q. */
    double (*carried)(const ovr_simulation *sim, const void *own, size_t i,
                      double q);

    /* Returns the additional flow at a half node: that of the discrete scheme,
     * or the mean of both nodes. */
    double (*flow)(const ovr_simulation *sim, const void *own, size_t i,
                   bool mean);

    /* Adds to rho H^3/eta and to the density at a node the differences from the
     * values that follow from pressure and film thickness. */
    void (*oil)(const ovr_simulation *sim, const void *own, size_t i,
                double *eps, double *rho);

    /* Changes viscosity or density at the nodes from values at the supply
     * temperature to those at the actual temperature; either may be NULL. */
    void (*warm)(const ovr_simulation *sim, const void *own, double *viscosity,
                 double *density);

    /* Values of a field at the nodes, in `workspace`; NULL: the model does not
     * have the field. */
    const double *(*field)(const ovr_simulation *sim, const void *own,
                           ovr_physics_field which, double *workspace);

    /* Replaces the mean shear stress over the film at half nodes. */
    void (*stress)(ovr_simulation *sim, void *own, const ovr_sheared *film,
                   const ovr_fluid *fluid, double *t);

    /* Adds to the mean shear stress t at half nodes. */
    void (*friction)(ovr_simulation *sim, void *own, double *t);

    /* Reduces `apart`, the fraction of the surface on which fluid shear acts,
     * and adds to the power dissipated in the film at the nodes (in b/R um
     * p_h), which is the heat source. */
    void (*heat)(ovr_simulation *sim, void *own, double *apart, double *power);

    /* Fills in the model's observations; `unknown` sets them to unknown, before
     * that and if the model is off. */
    void (*observe)(ovr_simulation *sim, void *own, ovr_observation *o);
    void (*unknown)(ovr_observation *o);

    /* True if the last observed step must be flagged because the model's
     * results are inconsistent. */
    bool (*marks)(ovr_simulation *sim, void *own);

    /* Quantities per step defined by the model: rows after those of the film
     * (observables.h), members of ovr_observation or of its `more`. */
    const ovr_observable *quantity;
    size_t quantities;

    /* Called after a solve or run; reports notes and warnings. */
    void (*review)(const ovr_simulation *sim, const void *own,
                   ovr_physics_message *say, void *data);

    /* A companion, which runs with the solver and writes to the result file
     * (physics/companion.h). */
    const struct ovr_companion *companion;
} ovr_physics_in_output;

struct ovr_physics {
    const char *name;
    unsigned bit; /* bit of the quantities that require the model; 0: none */
    const ovr_physics_in_case *in_case;
    const ovr_physics_in_solve *in_solve;
    const ovr_physics_in_step *in_step;
    const ovr_physics_in_output *in_output;
};

/* Sets the quantities of a model in its record. */
#define OVR_QUANTITIES(rows)                                                   \
    .quantity = (rows), .quantities = sizeof(rows) / sizeof *(rows)

/* All models, NULL after the last. In an object file of its own in the library,
 * so that a program can be linked with another list. */
extern const ovr_physics *const ovr_physics_list[];

/* NOLINTBEGIN(bugprone-macro-parentheses): names of variables and members */

/* Loops over the active models of a simulation that have the function. */
#define OVR_EACH_PHYSICS(sim, p, part, function)                               \
    for (const ovr_present *p = (sim)->physics.on; p->is; p++)                 \
        if (p->is->part && p->is->part->function)

/* The last active model that has the function, or one whose `is` is NULL. */
#define OVR_LAST_PHYSICS(sim, p, part, function)                               \
    const ovr_present *p = &(sim)->physics.on[OVR_MAX_PHYSICS];                \
    OVR_EACH_PHYSICS(sim, each_##p, part, function)                            \
    p = each_##p

/* NOLINTEND(bugprone-macro-parentheses) */

/* Creates the models selected by the options, before and after the grids are
 * built; adds one model by its form. */
void ovr_physics_prepare(ovr_simulation *sim);
ovr_status ovr_physics_choose(ovr_simulation *sim, ovr_error *err);
ovr_status ovr_physics_add(ovr_simulation *sim, const ovr_physics *physics,
                           const void *form, ovr_error *err);

/* Allocates memory for the pressure on the solids in addition to the fluid
 * pressure. */
ovr_status ovr_physics_take_asperity_pressure(ovr_simulation *sim,
                                              ovr_error *err);

/* Sets the pressure on the solids to zero; stores the pressure of the finest
 * level as that of the previous time; restores the stored pressure. */
void ovr_physics_clear_asperity_pressure(ovr_simulation *sim);
void ovr_physics_keep_asperity_pressure(ovr_simulation *sim);
void ovr_physics_restore_asperity_pressure(ovr_simulation *sim);

/* Collects the messages of all physical models after a solution or run. */
void ovr_physics_review(const ovr_simulation *sim, ovr_physics_message *say,
                        void *data);

/* Fails if a step, or the steady start, is not possible with one of the models.
 */
ovr_status ovr_physics_check(const ovr_simulation *sim, ovr_error *err);

#endif
