/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameters of heat in a case (heat.c). */
#ifndef OVR_PHYSICS_HEAT_HEAT_H
#define OVR_PHYSICS_HEAT_HEAT_H

#include "contact/heat_numbers.h"
#include "overroll/case.h"
#include "simulation/physics.h"

/* The numbers are the first member, because without a resolved case they are
 * the whole form. */
typedef struct ovr_heat_case {
    ovr_heat heat;
    int model; /* 0: none */
    ovr_heat_form given;
} ovr_heat_case;

/* Heat of second-order solutions, steady and in time: temperatures of film and
 * surfaces, and their effect on the viscosity. An automatic order (0) becomes
 * 2. */
extern const ovr_physics ovr_physics_heat;
extern const ovr_section ovr_heat_section;

ovr_status ovr_heat_resolve(const ovr_physics_case *of, void *form, bool *on,
                            ovr_error *err);

/* False if the error of the energy balance exceeds 5 % in a film with a
 * temperature rise above 1 K. */
bool ovr_heat_is_balanced(double energy_defect, double rise);

/* False if the grid does not resolve a converged film that is 1 K hotter than
 * its supply: its energy is not balanced, or T_max_finer exceeds 1.1 times
 * T_max_rise. */
bool ovr_heat_is_resolved(const ovr_observation *o);

/* False if the grid does not resolve the maximum temperature of a run. */
bool ovr_heat_maximum_is_resolved(const ovr_statistics *s);

/* The heat parameters of a setup, which can still be changed; NULL: no heat. */
ovr_heat *ovr_setup_heat(const ovr_setup *setup);

#endif
