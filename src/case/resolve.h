/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The files that resolve a case share this. */
#ifndef OVR_CASE_RESOLVE_H
#define OVR_CASE_RESOLVE_H

#include "case/case.h"
#include "case/settings.h"
#include "simulation/physics.h"

/* A physics of the list in a case. */
typedef struct ovr_resolved_physics {
    void *form;
    bool on;
} ovr_resolved_physics;

/* A setup with the memory behind it. */
typedef struct ovr_resolved ovr_resolved;
struct ovr_resolved {
    ovr_setup setup;
    const ovr_case *c;
    ovr_settings values;
    ovr_contact contact;
    ovr_lubricant lubricant;
    ovr_body_form body[2];
    ovr_law_table *tables[2]; /* of viscosity, of density; or NULL */
    ovr_march march;
    ovr_flow_law *flow_law;
    ovr_resolved_physics physics[OVR_MAX_PHYSICS]; /* as in the list */
    size_t features; /* all there are, on the mesh (the setup's) or not */
    const ovr_feature_form *const *feature;
    struct {
        ovr_gear *gear; /* one of them at most */
        ovr_cam *cam;
        ovr_bearing *bearing;
        double end;  /* of its histories, b/um */
        bool stands; /* a steady solve at one of its moments */
    } element;
    bool alpha_estimated; /* from the viscosity */
    double inlet_kept; /* inlet that a feature further downstream prevented; 0:
                          none */
    double substrate;  /* E' of the bodies, which a physics may change */
    double half_width; /* the largest dry one of run and passes, in b */
    const char
        *step_reason; /* of step = auto, why a step is one mesh; or NULL */
    double pass_load; /* by which a pass's load was scaled; 0: by nothing */
    bool ran;         /* by a physics, which sets end and steps of the run */
    bool recorded;    /* its domain is that of a file resumed */
    ovr_arena arena;
};

/* The block of a plain section. */
const ovr_block *ovr_block_of(const ovr_resolved *r, const char *section);
const ovr_slot *ovr_slot_of(const ovr_resolved *r, const char *section,
                            const char *key);

/* Stores the values of a block in the struct of its rows, physical
 * numbers scaled by the contact. */
ovr_status ovr_block_fill(ovr_resolved *r, const ovr_block *block, void *into,
                          ovr_error *err);

/* The same of a plain section whose values are the settings'. */
ovr_status ovr_section_fill(ovr_resolved *r, const char *section,
                            ovr_error *err);

/* The error `why` with the place of the key it is about before it, given in
 * `block` or the other (or NULL); else that of the block, or of the case. */
ovr_status ovr_fail_in(ovr_error *err, const ovr_case *c,
                       const ovr_block *block, const ovr_block *other,
                       const ovr_error *why);

/* Resolves [contact], [body 1], [body 2] and [lubricant] except its flow law:
 * the contact, and with it the scales of all that follows. */
ovr_status ovr_resolve_contact(ovr_resolved *r, ovr_error *err);

/* The bodies' yield strength relative to the Hertzian pressure. */
ovr_status ovr_resolve_yield(ovr_resolved *r, ovr_error *err);

/* Makes the contact again, where a physics changes how stiff the bodies are,
 * with the modulus that follows. */
ovr_status ovr_resolve_stiffness(ovr_resolved *r, ovr_error *err);

/* Fills the forms of the physics that have sections, once the contact is known;
 * resolves them. */
ovr_status ovr_resolve_forms(ovr_resolved *r, ovr_error *err);

/* Sets end and steps of a run determined by a physical model; false: none
 * does. */
bool ovr_resolved_march(ovr_resolved *r);
ovr_status ovr_resolve_physics(ovr_resolved *r, ovr_error *err);

/* Passes the grid to the physical models. */
ovr_status ovr_resolve_on_mesh(ovr_resolved *r, ovr_error *err);

/* True if the k-th physics of the list is on, turned on or chosen by the
 * options; that which makes the nodes of the solution, known once it is solved,
 * or NULL. */
bool ovr_setup_has(const ovr_setup *setup, int k);
const ovr_physics *ovr_setup_makes_nodes(const ovr_setup *setup);

/* Adds the physical models of the case to a simulation. */
ovr_status ovr_setup_add_physics(const ovr_setup *setup, ovr_simulation *sim,
                                 ovr_error *err);

/* Collected from the physics that are on: the features of the model that they
 * turn on (simulation/conflicts.h) and the fields that they store in addition
 * to the usual ones. */
unsigned ovr_resolved_features(const ovr_resolved *r);
unsigned ovr_resolved_fields(const ovr_resolved *r);

/* Fields that [output] asks for and that have no values, as a physics is off:
 * the first such. */
unsigned ovr_resolved_no_fields(const ovr_resolved *r, const ovr_physics **off);

/* Returns the reason for steps of one mesh size, or NULL. */
const char *ovr_resolved_one_mesh(const ovr_resolved *r);

/* Returns the width of a strip, b; 0 for line contacts. */
double ovr_resolved_width(const ovr_resolved *r);

/* Returns the lines of a strip on the mesh size D; 1 for line contacts. */
size_t ovr_resolved_lines(const ovr_resolved *r, double D);

/* Returns the film that arrives at T = 0, INFINITY for flooded inlets. */
double ovr_resolved_supply(const ovr_resolved *r);

/* Frees what their forms hold. */
void ovr_resolved_drop(ovr_resolved *r);

/* Applies the settings of the physical models that are not options, after the
 * time histories. */
void ovr_setup_equip(const ovr_setup *setup, ovr_simulation *sim);

/* [time], the time histories, and the resulting scheme. */
ovr_status ovr_resolve_time(ovr_resolved *r, ovr_error *err);

/* step = auto, the surfaces being made. */
void ovr_resolve_step(ovr_resolved *r);

/* end = auto, likewise. */
ovr_status ovr_resolve_end(ovr_resolved *r, ovr_error *err);

/* The flow law of [lubricant], for a contact that is resolved. */
ovr_status ovr_resolve_flow(ovr_resolved *r, ovr_error *err);

/* Creates the history of a section with the keys of [load]; *history is NULL if
 * it is constant. */
ovr_status ovr_resolve_history(ovr_resolved *r, const char *section,
                               const ovr_change *change, ovr_history **history,
                               ovr_error *err);

#endif
