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

/* Points 5, 80 degC, mineral oil, steel, S0 = 1.1. */
ovr_heat_form test_heat_form(void);

/* By Moes numbers; tau0 in Pa, 0: Newtonian; NULL: the form above. */
test_hot test_hot_make(double M, double L, double S, double tau0,
                       const ovr_heat_form *form);

/* With these options; with test_options on this level; or the test fails. */
ovr_simulation *test_hot_made(const test_hot *hot, const ovr_options *options);
ovr_simulation *test_hot_simulation(const test_hot *hot, int level);

#endif
