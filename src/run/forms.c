/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/forms.h"

#include "case/setup.h"
#include "simulation/heat_case.h"

ovr_heat *ovr_setup_heat(const ovr_setup *setup)
{
    ovr_heat_case *form = ovr_setup_form(setup, "heat");
    return form && form->model ? &form->heat : NULL;
}

ovr_supply_case *ovr_setup_supply(const ovr_setup *setup)
{
    return ovr_setup_form(setup, "supply");
}

const ovr_stress_setup *ovr_setup_stress(const ovr_setup *setup)
{
    return ovr_setup_form(setup, "stress");
}

ovr_plastic_setup *ovr_setup_plastic(const ovr_setup *setup)
{
    ovr_plastic_setup *form = ovr_setup_form(setup, "plastic");
    return form && form->surfaces ? form : NULL;
}

ovr_status ovr_setup_pass(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err)
{
    ovr_plastic_setup *plastic = ovr_setup_plastic(setup);
    if (plastic)
        plastic->rests = plastic->elastic && pass == 1;
    return ovr_setup_load(setup, pass, allocator, err);
}
