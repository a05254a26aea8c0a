/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parameters of mass-conserving cavitation and lubricant supply in a case
 * (supply.c). */
#ifndef OVR_PHYSICS_SUPPLY_SUPPLY_H
#define OVR_PHYSICS_SUPPLY_SUPPLY_H

#include "contact/history.h"
#include "overroll/case.h"
#include "simulation/arrival.h"
#include "simulation/physics.h"
#include "surface/layer.h"

typedef struct ovr_supply_case {
    int cavitation;                 /* ovr_cavitation */
    int film;                       /* 0: flooded */
    double thickness[2], reservoir; /* b^2/R, b^3/R */
    const char *profile[2];         /* files with the supplied film along each
                                     * surface */
    ovr_change change;

    ovr_layer *layer[2];  /* supplied film along each surface; NULL: constant */
    ovr_history *history; /* NULL: constant */
    double start;         /* rho H of the steady start; NAN: the supply at that
                           * time */
    const ovr_contact *contact;
    const ovr_options *options;
    const ovr_history *speed, *sliding;
} ovr_supply_case;

extern const ovr_physics ovr_physics_conserving;
extern const ovr_section ovr_supply_sections[2];

/* Sets the supply of a contact with OVR_CAVITATION_CONSERVING. Supply in excess
 * of the flooded flow rate accumulates in the inlet reservoir, whose initial
 * volume is `reservoir` (b^3/R). When the reservoir is empty, the inflow is the
 * supply. INFINITY: always flooded. `supply` is borrowed (NULL: flooded). */
void ovr_simulation_supply(ovr_simulation *sim, ovr_supply *supply, void *data,
                           double reservoir);

/* Supplied content rho H at the inlet at time T. */
double ovr_supply_arriving(const ovr_supply_case *supply, double T);

/* Replaces the supply of the case, after the domain is known, by the film left
 * on the surfaces by the previous pass. The supply takes ownership of the
 * layers. */
void ovr_supply_feed(ovr_supply_case *supply, ovr_layer *layer[2],
                     double reservoir);

/* The following are functions of a physical model (physics.h). */
void ovr_supply_choose(const void *form, ovr_options *options);
ovr_status ovr_supply_resolve(const ovr_physics_case *of, void *form, bool *on,
                              ovr_error *err);
void ovr_supply_drop(void *form);
void ovr_supply_state(const void *form, ovr_physics_effects *effects);

/* The lubricant supply; film = false: flooded. */
ovr_supply_case *ovr_setup_supply(const ovr_setup *setup);

#endif
