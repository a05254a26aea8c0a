/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case says this of heat (heat.c). */
#ifndef OVR_PHYSICS_HEAT_HEAT_H
#define OVR_PHYSICS_HEAT_HEAT_H

#include "contact/heat_numbers.h"
#include "overroll/case.h"
#include "simulation/physics.h"

/* The numbers come first: where no case is resolved they are the whole form. */
typedef struct ovr_heat_case {
    ovr_heat heat;
    int model; /* 0: none */
    ovr_heat_form given;
} ovr_heat_case;

extern const ovr_section ovr_heat_section;

ovr_status ovr_heat_resolve(const ovr_physics_case *of, void *form, bool *on,
                            ovr_error *err);

/* The numbers of heat, which a run may still choose; NULL: there is none. */
ovr_heat *ovr_setup_heat(const ovr_setup *setup);

#endif
