/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The forms of physics that this floor and those above look at. */
#ifndef OVR_RUN_FORMS_H
#define OVR_RUN_FORMS_H

#include "overroll/case.h"
#include "simulation/supply_case.h"

/* The numbers of heat, which a run may still choose; NULL: there is none. */
ovr_heat *ovr_setup_heat(const ovr_setup *setup);

/* The oil that arrives, film = false: flooded. */
ovr_supply_case *ovr_setup_supply(const ovr_setup *setup);

#endif
