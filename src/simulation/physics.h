/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A physics is a record of functions: what beyond Reynolds' equation, film and
 * force balance a contact has.  Steady solve, step, observation, checkpoint
 * and case go through the list of physics (src/physics/list.c) and name none of
 * them; a new one is a file with its record and a row in that list.
 *
 * It has up to four parts: in the case, the solve, a step and the output.  A
 * part or a function of a part may be absent.  A simulation holds those of the
 * list that are on, in the order of the list, and calls no function of the
 * others.  `own` is what the physics has made for itself in this simulation.
 *
 * Contributions are sums over the list: to the gap (heights), to the elastic
 * influence, to the shear stress (friction).  Where the words are "in its own
 * way" the last of the list that has the function does it, and the ordinary way
 * is not gone.
 */
#ifndef OVR_SIMULATION_PHYSICS_H
#define OVR_SIMULATION_PHYSICS_H

#include "base/parameter.h"
#include "overroll/heat.h"
#include "simulation/internal.h"
#include "simulation/solver.h"

/* An error that begins with its place is about this. */
#define OVR_SAYS_WHERE ""

/* A body, NAN what is not known of it. */
typedef struct ovr_physics_body {
    double modulus, poisson;
    double yield; /* Mises, p_h; 0: none */
    ovr_thermal thermal;
} ovr_physics_body;

/* A text file of two columns, converted to SI by the units in its header:
 * dimensions of the columns, and an example of a header. */
typedef struct ovr_physics_columns {
    const char *name[2];
    ovr_dimension of[2];
    const char *example;
    size_t count;
    double *x, *y;
} ovr_physics_columns;

/* A pulse of heat leaves a surface so much warmer than that of a half-space at
 * t, M(t) (contact/layers.h). */
typedef struct ovr_warmth {
    double (*at)(const void *data, double t);
    const void *data;
} ovr_warmth;

struct ovr_change; /* of a section that is a history */

/* A physics is resolved with this: the contact and what is known of the run.
 */
typedef struct ovr_physics_case {
    const struct ovr_setup *setup; /* of which the floors above know */
    const ovr_contact *contact;
    const ovr_lubricant *lubricant;
    const struct ovr_oil *oil;       /* in SI */
    ovr_options *options;            /* which it may still choose */
    struct ovr_passes_setup *passes; /* likewise */
    bool transient;
    double end;                         /* of a run that has one; else 0 */
    const ovr_history *speed, *sliding; /* NULL: constant */
    ovr_physics_body body[2];
    double raceway;    /* circumference of a bearing's, b; NAN: there is none */
    unsigned physics;  /* bits of those that a key switches on */
    double substrate;  /* E' of the bodies as they are given, Pa */
    bool by_substrate; /* b and ph are those of the bodies without layers */
    ovr_arena *arena;  /* lives as long as the form */
    size_t features;   /* of both surfaces, on the mesh or not */
    const struct ovr_feature_form *const *feature;

    /* Reads the file that a key of the physics' sections names. */
    ovr_status (*read)(void *data, const char *key, const char *file,
                       ovr_physics_columns *columns, ovr_error *err);

    /* True if a section is in the case; if a key of it is set. */
    bool (*given)(void *data, const char *section, const char *key);

    /* Makes the history of a section; NULL where it is constant. */
    ovr_status (*history)(void *data, const char *section,
                          const struct ovr_change *change,
                          ovr_history **history, ovr_error *err);
    void *data;
} ovr_physics_case;

/* Receives a line of the report of `check`: a name and a text. */
typedef void ovr_physics_line(void *data, const char *name, const char *text);

/* Callback that receives a note or a warning. */
typedef void ovr_physics_message(void *data, bool warning, const char *text);

/* Fields that have no values without a physics. */
typedef enum ovr_physics_field {
    OVR_FIELD_TEMPERATURE_1, /* of the surfaces, K */
    OVR_FIELD_TEMPERATURE_2,
    OVR_FIELD_TEMPERATURE_MEAN, /* over the film */
    OVR_FIELD_TEMPERATURE_MIDDLE,
    OVR_FIELD_HEAT_FLUX_1, /* into the surfaces */
    OVR_FIELD_HEAT_FLUX_2
} ovr_physics_field;

/* Fields in words, and by their names, ", " between them. */
typedef struct ovr_own_fields {
    const char *are, *names;
} ovr_own_fields;

/* Statements of a form about its run. */
typedef struct ovr_physics_statement {
    unsigned bits;       /* in addition to the physics' own */
    unsigned features;   /* of the model (conflicts.h) that it turns on */
    const char *fields;  /* that a file has in addition, ", " between them */
    double width_across; /* period across rolling, b; 0: none */
    double arrives;      /* film at T = 0; INFINITY: as much as is taken */
} ovr_physics_statement;

/* Part in the case. */
typedef struct ovr_physics_in_case {
    /* Sections whose rows fill the form, of so many bytes, which begins as
     * zeros; none: its keys are options of any simulation, or it has none.
     * Help and files have them behind the case's section of that name; NULL:
     * behind all. */
    const ovr_section *section;
    size_t sections, form;
    const char *behind;

    /* Writes the choices of the form into the options, before the rest is
     * resolved. */
    void (*choose)(const void *form, ovr_options *options);

    /* Finds in a section with names where in the form goes what a block of this
     * name says, with what holds where it says nothing. */
    ovr_status (*block)(void *form, const char *name, void **into,
                        ovr_error *err);

    /* E' of the homogeneous bodies that touch over the same width under the
     * same load, over that of the bodies as they are given: the contact's b and
     * ph are those of the former.  The form is in the units of the contact as
     * it would be with what was found last. */
    ovr_status (*stiffness)(const ovr_physics_case *of, void *form,
                            double *ratio, ovr_error *err);

    /* Resolves what the form means, in the units of the contact; whether it is
     * on.  An error is about a key of its rows or of [lubricant], about a name
     * of a block, about a section, about "section.key", or OVR_SAYS_WHERE. */
    ovr_status (*resolve)(const ovr_physics_case *of, void *form, bool *on,
                          ovr_error *err);

    /* Resolves what it means on a mesh of that size, once the domain is
     * known. */
    ovr_status (*on_mesh)(const ovr_physics_case *of, void *form, double mesh,
                          ovr_error *err);

    /* Frees what the form holds that is no memory of the arena. */
    void (*drop)(void *form);

    /* Sets end and step of a run that it makes by itself, in place of [time],
     * and its scheme where that is below 0; false: it makes none. */
    bool (*march)(const void *form, ovr_march *march, int *scheme);

    /* Lines across rolling on a mesh size D along x. */
    size_t (*lines_across)(const void *form, double D);

    /* Fields that have no values without it; NULL: none. */
    const ovr_own_fields *own_fields;

    /* Why a step of a run is one mesh by itself; NULL: it may be longer. */
    const char *one_mesh;

    /* The relative error that it adds to a film per b/um of step, in a run. */
    double lag;

    /* True if it has a feature for itself, which is then not on the mesh. */
    bool (*keeps)(const void *form, const struct ovr_feature_form *feature);

    /* Passes one line for each number of the form that is shown to users. */
    void (*tell)(const ovr_physics_case *of, const void *form,
                 ovr_physics_line *line, void *data);

    /* Bytes that it takes beside the simulation's, of a case that is prepared.
     */
    double (*memory)(const void *form);

    /* Seconds of one core that a node takes more in a step with it, and those
     * that a pass takes beside, about. */
    double node_seconds;
    double (*seconds)(const void *form);

    /* The layers on a body, in b and ph; NULL: none. */
    const struct ovr_coated *(*layers)(const void *form, int body);

    /* Fills in the statements of the form, of one that is on; defaults: zero,
     * `arrives` INFINITY. */
    void (*says)(const void *form, ovr_physics_statement *says);
} ovr_physics_in_case;

/* Part in the making of a simulation and in the steady solution. */
typedef struct ovr_physics_in_solve {
    /* The nodes of the steady solution are its own: a file can be opened once
     * it is solved, and there is nothing to resume. */
    bool makes_nodes;

    /* True if the options choose it. */
    bool (*chosen)(const ovr_options *options);

    /* Sets properties of the grids before they are built. */
    void (*prepare)(ovr_hierarchy *grids);

    /* Memory of the simulation, of which nothing is written yet but pointers:
     * it may be counted only.  The form is that of the case, NULL where the
     * options have chosen. */
    ovr_status (*take)(ovr_simulation *sim, const void *form, void **own,
                       ovr_error *err);

    /* Applies the settings of the form that are not options, after the time
     * histories. */
    void (*equip)(ovr_simulation *sim, void *form);

    /* Frees what is not of the simulation's memory. */
    void (*release)(void *own);

    /* Solves film and pressure in place of the line's solver (solver.h). */
    const ovr_solver *solver;

    /* Adds to the elastic influence of a pressure. */
    void (*influence)(const ovr_simulation *sim, void *own,
                      ovr_influence *influence);

    /* Returns the temperature of surface k after a heat pulse relative to that
     * of a half-space. */
    void (*warmth)(const ovr_simulation *sim, const void *own, int k,
                   ovr_warmth *to);

    /* Adds to the heights of surface 1 or 2, or to their sum (0), at any X,
     * outward positive.  The gap is the gap of the smooth surfaces minus the
     * sum.  Heights of a surface move with it; the sum may include others. */
    void (*heights)(const ovr_simulation *sim, const void *own, int surface,
                    double T, size_t n, const double *X, double *S);

    /* Forgets before each attempt: as if it were off. */
    void (*forget)(ovr_simulation *sim, void *own);

    /* Before the equation of the steady start is set. */
    void (*before_start)(ovr_simulation *sim, void *own);

    /* The film from nothing, in its own way. */
    ovr_defect (*solve)(ovr_simulation *sim, void *own, const ovr_full *how,
                        int *cycles);

    /* Completes the film that was found by this physics, as far as that needs
     * no more than cycles. */
    ovr_defect (*complete)(ovr_simulation *sim, void *own, const ovr_full *how,
                           int *cycles);

    /* Solves film and physics in turn until neither changes; called again
     * whenever the film has become another one. */
    void (*couple)(ovr_simulation *sim, void *own, const ovr_full *how,
                   ovr_outcome *outcome);

    /* Computes the final film from the present one, which is its initial guess;
     * false where there is none. */
    bool (*proceed)(ovr_simulation *sim, void *own, const ovr_full *how,
                    ovr_outcome *outcome);

    /* True if the steady start has used up the cycles that it may take. */
    bool (*exhausted)(const ovr_simulation *sim, const void *own);

    /* Fails with the reason why a steady start did not converge, if that lies
     * in this physics. */
    ovr_status (*explain)(const ovr_simulation *sim, const void *own,
                          const ovr_outcome *outcome, ovr_error *err);

    /* Final processing. */
    void (*finish)(ovr_simulation *sim, void *own, const ovr_full *how,
                   ovr_outcome *outcome);

    /* Fails if the steady solution, converged and observed, is outside what
     * the model holds for. */
    ovr_status (*refuse)(const ovr_simulation *sim, const void *own,
                         ovr_error *err);

    /* The steady solution is the past that a run begins from. */
    void (*begin)(ovr_simulation *sim, void *own);
} ovr_physics_in_solve;

/* Part in steps, and in the checkpoint between two of them. */
typedef struct ovr_physics_in_step {
    /* Fails if a step, or the steady start, may not be made at all. */
    ovr_status (*check)(const ovr_simulation *sim, const void *own,
                        ovr_error *err);

    /* Before the equation of a step to T is set. */
    void (*before_step)(ovr_simulation *sim, void *own, double T);

    /* Changes the operator of a step of dT; dT = 0: of the steady start. */
    void (*operate)(const ovr_simulation *sim, const void *own, double dT,
                    ovr_operator *op);

    /* The history term, in its own way; c weighs the past. */
    void (*history)(ovr_simulation *sim, void *own, double dT,
                    const double c[2]);

    /* The equation of the step of dT is set. */
    void (*step)(ovr_simulation *sim, void *own, double dT);

    /* The guess that the cycles of an attempt begin from is in place. */
    void (*attempt)(ovr_simulation *sim, void *own, bool first);

    /* Called after a cycle of it: solves itself with the film that this has
     * made, where it has to, and makes film and residual again. */
    void (*anew)(ovr_simulation *sim, void *own);

    /* Called on a path of solutions (continuation.c): keeps what it has on the
     * finest level of the one that was found last; goes back to that, whose
     * pressure was P. */
    void (*keep)(ovr_simulation *sim, void *own);
    void (*go_back)(ovr_simulation *sim, void *own, const double *P);

    /* The step of dT is taken, and not yet the past. */
    void (*taken)(ovr_simulation *sim, void *own, double dT);

    /* A remedy for a step that did not converge, by the film of the nominal
     * contact: text that follows the reason. */
    void (*advise)(const ovr_simulation *sim, double H, size_t size,
                   char *text);

    /* True if nothing is left that a run would be for. */
    bool (*over)(const ovr_simulation *sim, const void *own);

    /* Back to the last time reached: before its pressure and gap are in place
     * again, and once they are. */
    void (*before_back)(ovr_simulation *sim, void *own);
    void (*step_back)(ovr_simulation *sim, void *own);

    /* Shows what of it makes up the state between two steps; what follows from
     * that once it is there, before step_back. */
    void (*visit)(ovr_simulation *sim, void *own, ovr_pieces *state);
    void (*restored)(ovr_simulation *sim, void *own);

    /* Restores observations that cannot be computed from the state.
     */
    void (*recalled)(ovr_observation *o, const ovr_observation *saved);
} ovr_physics_in_step;

/* Part in observations and files. */
typedef struct ovr_physics_in_output {
    /* The content that the film carries along at the half node i + 1/2, which
     * the scheme takes to be q. */
    double (*carried)(const ovr_simulation *sim, const void *own, size_t i,
                      double q);

    /* Returns the additional flow at a half node: as the scheme has it, or
     * the mean of both nodes. */
    double (*flow)(const ovr_simulation *sim, const void *own, size_t i,
                   bool mean);

    /* The differences of rho H^3/eta and of the density of the oil at a node
     * from those of its pressure and film. */
    void (*oil)(const ovr_simulation *sim, const void *own, size_t i,
                double *eps, double *rho);

    /* Viscosity or density at the nodes, of the pressure, becomes that of the
     * temperature; either may be NULL. */
    void (*warm)(const ovr_simulation *sim, const void *own, double *viscosity,
                 double *density);

    /* Values of a field at the nodes, in `workspace`; NULL: has none. */
    const double *(*field)(const ovr_simulation *sim, const void *own,
                           ovr_physics_field which, double *workspace);

    /* Mean shear stress over the film at half nodes, in its own way. */
    void (*stress)(ovr_simulation *sim, void *own, const ovr_sheared *film,
                   const ovr_fluid *fluid, double *t);

    /* Adds to it; to the power that is made in the film at the nodes, over
     * b/R um ph, which heat takes up. */
    void (*friction)(ovr_simulation *sim, void *own, double *t);

    /* Reduces `apart`, the share of the surfaces that the film drags on, and
     * adds to the power made in the film in addition, at the nodes. */
    void (*heat)(ovr_simulation *sim, void *own, double *apart, double *power);

    /* Fills in what is observed; before that, and where the physics is off,
     * what is not known. */
    void (*observe)(ovr_simulation *sim, void *own, ovr_observation *o);
    void (*unknown)(ovr_observation *o);

    /* True if the step that was observed last is marked: what it found does not
     * belong together. */
    bool (*marks)(ovr_simulation *sim, void *own);

    /* Numbers a step that are its own: rows behind those of the film
     * (observables.h), of members of ovr_observation or of its `more`. */
    const ovr_observable *quantity;
    size_t quantities;

    /* Called after a solve or run. */
    void (*review)(const ovr_simulation *sim, const void *own,
                   ovr_physics_message *say, void *data);

    /* A companion runs with the solver and writes into the result file
     * (physics/companion.h). */
    const struct ovr_companion *companion;
} ovr_physics_in_output;

struct ovr_physics {
    const char *name;
    unsigned bit; /* of the quantities that need it; 0: they need nothing */
    const ovr_physics_in_case *in_case;
    const ovr_physics_in_solve *in_solve;
    const ovr_physics_in_step *in_step;
    const ovr_physics_in_output *in_output;
};

/* The quantities of a physics, in its record. */
#define OVR_QUANTITIES(rows)                                                   \
    .quantity = (rows), .quantities = sizeof(rows) / sizeof *(rows)

/* All there are, NULL behind the last.  Its own object in the library, so that
 * a program may be linked with a list of its own. */
extern const ovr_physics *const ovr_physics_list[];

/* NOLINTBEGIN(bugprone-macro-parentheses): names of variables and members */

/* Those of a simulation that have the function. */
#define OVR_EACH_PHYSICS(sim, p, part, function)                               \
    for (const ovr_present *p = (sim)->physics.on; p->is; p++)                 \
        if (p->is->part && p->is->part->function)

/* The last of them that has it, or none (is NULL). */
#define OVR_LAST_PHYSICS(sim, p, part, function)                               \
    const ovr_present *p = &(sim)->physics.on[OVR_MAX_PHYSICS];                \
    OVR_EACH_PHYSICS(sim, each_##p, part, function)                            \
    p = each_##p

/* NOLINTEND(bugprone-macro-parentheses) */

/* Those that the options choose, before the grids are built and once they are;
 * one more, by its form. */
void ovr_physics_prepare(ovr_simulation *sim);
ovr_status ovr_physics_choose(ovr_simulation *sim, ovr_error *err);
ovr_status ovr_physics_add(ovr_simulation *sim, const ovr_physics *physics,
                           const void *form, ovr_error *err);

/* Memory for the pressure that the solids feel beside the film's. */
ovr_status ovr_physics_take_asperity_pressure(ovr_simulation *sim,
                                              ovr_error *err);

/* None of it; that of the finest level becomes the one of the last time
 * reached; goes back to that. */
void ovr_physics_clear_asperity_pressure(ovr_simulation *sim);
void ovr_physics_keep_asperity_pressure(ovr_simulation *sim);
void ovr_physics_restore_asperity_pressure(ovr_simulation *sim);

/* Collects the messages of all physical models after a solution or run. */
void ovr_physics_review(const ovr_simulation *sim, ovr_physics_message *say,
                        void *data);

/* Fails if a step, or the steady start, may not be made at all. */
ovr_status ovr_physics_check(const ovr_simulation *sim, ovr_error *err);

#endif
