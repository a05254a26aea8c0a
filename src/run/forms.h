/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The forms of physics that this floor and those above look at. */
#ifndef OVR_RUN_FORMS_H
#define OVR_RUN_FORMS_H

#include "overroll/case.h"
#include "run/plastic_case.h"
#include "run/stress_case.h"
#include "simulation/supply_case.h"

/* The numbers of heat, which a run may still choose; NULL: there is none. */
ovr_heat *ovr_setup_heat(const ovr_setup *setup);

/* The oil that arrives, film = false: flooded. */
ovr_supply_case *ovr_setup_supply(const ovr_setup *setup);

/* Stresses, surfaces = 0: there are none. */
const ovr_stress_setup *ovr_setup_stress(const ovr_setup *setup);

/* NULL: nothing yields. */
ovr_plastic_setup *ovr_setup_plastic(const ovr_setup *setup);

/* Takes the place of the load: that of a pass; whether bodies yield in it. */
ovr_status ovr_setup_pass(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err);

#endif
