/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Thermal steel contacts: E' = 226 GPa, R = 12.7 mm, alpha = 22 1/GPa. */
#ifndef TESTS_SUPPORT_HOT_H
#define TESTS_SUPPORT_HOT_H

#include "contact/heat_numbers.h"
#include "overroll/simulation.h"

typedef struct test_hot {
    ovr_contact contact;
    ovr_lubricant oil;
    ovr_heat heat;
} test_hot;

/* Returns heat parameters: 5 points, 80 degC, mineral oil, steel, S0 = 1.1. */
ovr_heat_form test_heat_form(void);

/* Makes a contact of Moes' numbers and slide-to-roll ratio S. tau0 is in Pa, 0:
 * Newtonian; form = NULL: test_heat_form. */
test_hot test_hot_make(double M, double L, double S, double tau0,
                       const ovr_heat_form *form);

/* Creates a simulation with these options, or with test_options on this level;
 * or fails the test. */
ovr_simulation *test_hot_made(const test_hot *hot, const ovr_options *options);
ovr_simulation *test_hot_simulation(const test_hot *hot, int level);

#endif
