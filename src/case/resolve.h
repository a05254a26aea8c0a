/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shared by the files that resolve a case. */
#ifndef OVR_CASE_RESOLVE_H
#define OVR_CASE_RESOLVE_H

#include "case/case.h"
#include "case/settings.h"
#include "simulation/physics.h"

/* A physical model of the list, in a case. */
typedef struct ovr_resolved_physics {
    void *form;
    bool on;
} ovr_resolved_physics;

/* A setup with its memory. */
typedef struct ovr_resolved ovr_resolved;
struct ovr_resolved {
    ovr_setup setup;
    const ovr_case *c;
    ovr_settings values;
    ovr_contact contact;
    ovr_lubricant lubricant;
    ovr_body_form body[2];
    ovr_law_table *tables[2]; /* tables of viscosity and density; or NULL */
    ovr_flow_law *flow_law;
    ovr_resolved_physics physics[OVR_MAX_PHYSICS]; /* in the order of the
                                                    * list */
    size_t features; /* all features, whether on the grid (as in the setup) or
                      * not */
    const ovr_feature_form *const *feature;
    struct {
        ovr_gear *gear; /* at most one of the three elements */
        ovr_cam *cam;
        ovr_bearing *bearing;
        double end;  /* end of the element's histories, b/u_m */
        bool stands; /* steady solution at one position of the element */
    } element;
    bool alpha_estimated; /* estimated from the viscosity */
    double inlet_kept; /* inlet position that was not used because of a feature;
                        * 0: none */
    double substrate;  /* E' of the bodies without coatings */
    double half_width; /* maximum dry half-width over run and passes, in b */
    double prepared;   /* multiplications, about, by which heights were
                        * prepared */
    const char *step_reason; /* with step = auto: reason for steps of one mesh
                              * size; or NULL */
    double pass_load;        /* factor of the load of a pass; 0: none */
    bool ran;      /* a physical model sets end and steps of the run */
    bool recorded; /* the domain is that of a resumed file */
    ovr_arena arena;
};

/* Returns the block of a section without a name. */
const ovr_block *ovr_block_of(const ovr_resolved *r, const char *section);
const ovr_slot *ovr_slot_of(const ovr_resolved *r, const char *section,
                            const char *key);

/* Stores the values of a block in the struct of its rows. Physical numbers are
 * scaled by the contact. */
ovr_status ovr_block_fill(ovr_resolved *r, const ovr_block *block, void *into,
                          ovr_error *err);

/* Stores the values of a section without a name in the settings. */
ovr_status ovr_section_fill(ovr_resolved *r, const char *section,
                            ovr_error *err);

/* Adds the place of the key to the error `why`: a key of `block` or of `other`
 * (may be NULL). Without a key, adds the place of the block, or of the case. */
ovr_status ovr_fail_in(ovr_error *err, const ovr_case *c,
                       const ovr_block *block, const ovr_block *other,
                       const ovr_error *why);

/* Resolves [contact], [body 1], [body 2] and [lubricant] except the rheological
 * model. The contact determines the scales of all other values. */
ovr_status ovr_resolve_contact(ovr_resolved *r, ovr_error *err);

/* Computes the bodies' yield strength relative to the maximum Hertzian
 * pressure. */
ovr_status ovr_resolve_yield(ovr_resolved *r, ovr_error *err);

/* Recomputes the contact with the modulus that results from coatings, if a
 * physical model changes the stiffness of the bodies. */
ovr_status ovr_resolve_stiffness(ovr_resolved *r, ovr_error *err);

/* Fills and resolves the data of physical models that have sections, once the
 * contact is known. */
ovr_status ovr_resolve_forms(ovr_resolved *r, ovr_error *err);

/* Sets end and steps of a run if a physical model determines them; false if
 * none does. Resolves the physical models. */
bool ovr_resolved_march(ovr_resolved *r);
ovr_status ovr_resolve_physics(ovr_resolved *r, ovr_error *err);

/* Passes the grid to the physical models. */
ovr_status ovr_resolve_on_mesh(ovr_resolved *r, ovr_error *err);

/* True if the k-th physical model of the list is on, by its section or by the
 * options. The second function returns the model that creates nodes during the
 * solution, or NULL. */
bool ovr_setup_has(const ovr_setup *setup, int k);
const ovr_physics *ovr_setup_makes_nodes(const ovr_setup *setup);

/* Adds the physical models of the case to a simulation. */
ovr_status ovr_setup_add_physics(const ovr_setup *setup, ovr_simulation *sim,
                                 ovr_error *err);

/* Collect from the active physical models the features of the model that they
 * turn on (simulation/conflicts.h) and the fields that they store in addition
 * to the usual ones. */
unsigned ovr_resolved_features(const ovr_resolved *r);
unsigned ovr_resolved_fields(const ovr_resolved *r);

/* Returns requested output fields without values because a physical model is
 * off, and the first such model. */
unsigned ovr_resolved_no_fields(const ovr_resolved *r, const ovr_physics **off);

/* Returns the reason for steps of one mesh size, or NULL. */
const char *ovr_resolved_one_mesh(const ovr_resolved *r);

/* Returns the width of a strip in b; 0 for line contacts. */
double ovr_resolved_width(const ovr_resolved *r);

/* Returns the number of lines of a strip with mesh size D; 1 for line
 * contacts. */
size_t ovr_resolved_lines(const ovr_resolved *r, double D);

/* Returns the supplied film thickness at T = 0; INFINITY for flooded inlets. */
double ovr_resolved_supply(const ovr_resolved *r);

/* Frees the data of the physical models. */
void ovr_resolved_drop(ovr_resolved *r);

/* Applies the settings of the physical models that are not options, after the
 * time histories. */
void ovr_setup_equip(const ovr_setup *setup, ovr_simulation *sim);

/* Resolves [time] and the time histories, and chooses the scheme. */
ovr_status ovr_resolve_time(ovr_resolved *r, ovr_error *err);

/* Resolves step = auto. The surfaces must have been created. */
void ovr_resolve_step(ovr_resolved *r);

/* Resolves end = auto. The surfaces must have been created. */
ovr_status ovr_resolve_end(ovr_resolved *r, ovr_error *err);

/* Resolves the rheological model of [lubricant]. The contact must be
 * resolved. */
ovr_status ovr_resolve_flow(ovr_resolved *r, ovr_error *err);

/* Creates the history of a section with the keys of [load]; *history is NULL if
 * it is constant. */
ovr_status ovr_resolve_history(ovr_resolved *r, const char *section,
                               const ovr_change *change, ovr_history **history,
                               ovr_error *err);

#endif
