/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/forms.h"

#include "case/setup.h"
#include "simulation/heat_case.h"

ovr_heat *ovr_setup_heat(const ovr_setup *setup)
{
    ovr_heat_case *form = ovr_setup_form(setup, &ovr_physics_heat);
    return form && form->model ? &form->heat : NULL;
}

ovr_supply_case *ovr_setup_supply(const ovr_setup *setup)
{
    return ovr_setup_form(setup, &ovr_physics_conserving);
}
