/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/hot.h"

#include <math.h>

#include "contact/contact.h"
#include "physics/heat/heat.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"

ovr_heat_form test_heat_form(void)
{
    static const ovr_thermal steel = {46, 460, 7850},
                             mineral = {.14, 2000, 870};
    return (ovr_heat_form){.points = 5,
                           .temperature = 353,
                           .bulk = {NAN, NAN},
                           .oil = mineral,
                           .body = {steel, steel},
                           .expansion = 6.5e-4,
                           .S0 = 1.1,
                           .beta = NAN};
}

test_hot test_hot_make(double M, double L, double S, double tau0,
                       const ovr_heat_form *form)
{
    ovr_conditions c = ovr_conditions_default();
    ovr_flow_form eyring = ovr_flow_form_default();
    ovr_heat_form usual = test_heat_form();
    ovr_error err = {0};
    test_hot hot;
    c.M = M, c.L = L, c.slide_to_roll = S;
    c.alpha = 2.2e-8, c.modulus = 226e9, c.radius = 0.0127;
    /* Roelands' relation gives z = 0.68. */
    c.viscosity = exp(2.2e-8 * 1.98e8 / 0.68 - 9.67);
    CHECK_OK(ovr_contact_resolve(&c, &hot.contact, &err), &err);
    CHECK_OK(ovr_lubricant_make(&hot.contact, OVR_ROELANDS,
                                OVR_DOWSON_HIGGINSON, NAN, 0.68, &hot.oil,
                                &err),
             &err);
    eyring.rheology = OVR_EYRING;
    eyring.stress = tau0;
    if (tau0 > 0)
        CHECK_OK(ovr_lubricant_flow(&hot.contact, &eyring, &hot.oil, &err),
                 &err);
    CHECK_OK(ovr_heat_make(form ? form : &usual, &hot.contact, &hot.oil,
                           &hot.heat, &err),
             &err);
    return hot;
}

ovr_simulation *test_hot_made(const test_hot *hot, const ovr_options *options)
{
    ovr_error err = {0};
    ovr_simulation *sim = ovr_simulation_create(&hot->contact, &hot->oil,
                                                options, NULL, &err);
    assert_non_null(sim);
    CHECK_OK(ovr_physics_add(sim, &ovr_physics_heat, &hot->heat, &err), &err);
    return sim;
}

ovr_simulation *test_hot_simulation(const test_hot *hot, int level)
{
    ovr_options options = test_options();
    options.level = level;
    return test_hot_made(hot, &options);
}
