/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case says this of oil that is conserved, and of the film that arrives
 * (supply.c). */
#ifndef OVR_PHYSICS_SUPPLY_SUPPLY_H
#define OVR_PHYSICS_SUPPLY_SUPPLY_H

#include "contact/history.h"
#include "overroll/case.h"
#include "simulation/physics.h"
#include "surface/layer.h"

typedef struct ovr_supply_case {
    int cavitation;                 /* ovr_cavitation */
    int film;                       /* 0: flooded */
    double thickness[2], reservoir; /* b^2/R, b^3/R */
    const char *profile[2];         /* files of it along the surfaces */
    ovr_change change;

    ovr_layer *layer[2];  /* along the surfaces; NULL: constant */
    ovr_history *history; /* NULL: constant */
    double start;         /* rho H that the steady start takes; NAN: what
                             arrives then */
    const ovr_contact *contact;
    const ovr_options *options;
    const ovr_history *speed, *sliding;
} ovr_supply_case;

extern const ovr_physics ovr_physics_conserving;
extern const ovr_section ovr_supply_sections[2];

/* rho H that arrives at the inlet at T. */
double ovr_supply_arriving(const ovr_supply_case *supply, double T);

/* Replaces the supply of the case after the domain is known: what a pass has
 * left on the surfaces; the layers are the supply's from now on. */
void ovr_supply_feed(ovr_supply_case *supply, ovr_layer *layer[2],
                     double reservoir);

/* These are functions of a physics (physics.h). */
void ovr_supply_choose(const void *form, ovr_options *options);
ovr_status ovr_supply_resolve(const ovr_physics_case *of, void *form, bool *on,
                              ovr_error *err);
void ovr_supply_drop(void *form);
void ovr_supply_state(const void *form, ovr_physics_statement *says);

/* The oil that arrives, film = false: flooded. */
ovr_supply_case *ovr_setup_supply(const ovr_setup *setup);

#endif
