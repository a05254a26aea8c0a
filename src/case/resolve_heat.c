/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [heat]: its numbers, and what else of the case goes with it. */
#include <math.h>

#include "case/resolve.h"
#include "contact/heat_numbers.h"
#include "contact/oil.h"

static const double S0_USUAL = 1.1; /* of mineral oils */

/* -d ln eta/dT at the oil's temperature where its data sheet knows two
 * viscosities: that of nu, and of the density. */
static double fall_of_viscosity(const ovr_resolved *r)
{
    const ovr_oil *oil = &r->values.oil;
    const double step = 0.5; /* K */
    double T = oil->temperature;
    return log(ovr_walther(oil->nu_40, oil->nu_100, T - step) /
               ovr_walther(oil->nu_40, oil->nu_100, T + step)) /
               (2 * step) +
           r->values.heat.expansion;
}

/* Completes what is not given: by the data sheet, else S0 of the usual oil. */
static void complete(const ovr_resolved *r, ovr_heat_form *form)
{
    const ovr_oil *oil = &r->values.oil;
    bool sheet = oil->nu_40 > 0 && oil->nu_100 > 0;
    if (!isnan(form->S0) || !isnan(form->beta))
        return;
    if (sheet)
        form->beta = fall_of_viscosity(r);
    else if (r->lubricant.viscosity_law == OVR_ROELANDS)
        form->S0 = S0_USUAL;
}

ovr_status ovr_resolve_heat(ovr_resolved *r, ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_heat_form *form = &v->heat;
    ovr_error why = {0};
    if (!v->heat_model)
        return OVR_OK;
    form->temperature = v->oil.temperature;
    complete(r, form);
    for (int k = 0; k < 2; k++)
        form->body[k] = r->body[k].thermal;
    if (ovr_heat_make(form, &r->contact, &r->lubricant, &r->heat, &why))
        return ovr_fail_in(err, r->c, ovr_block_of(r, "heat"),
                           ovr_block_of(r, "lubricant"), &why);
    r->setup.heat = &r->heat;
    ovr_resolved_turn_on(r, &ovr_physics_heat, &r->heat);
    return OVR_OK;
}
