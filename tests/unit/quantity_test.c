/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers with units: accepted and rejected text, and messages. */
#include "support/test.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "overroll/text.h"

static double read_as(const char *text, ovr_dimension dimension)
{
    ovr_quantity q;
    ovr_error err = {0};
    if (ovr_quantity_read(text, dimension, false, &q, &err))
        fail_msg("%s", err.message);
    return q.value;
}

TEST(units_become_si)
{
    assert_true(read_as("22 1/GPa", OVR_PER_PRESSURE) == 2.2e-8);
    assert_true(read_as("17 1/GPa", OVR_PER_PRESSURE) == 1.7e-8);
    assert_true(read_as("17GPa^-1", OVR_PER_PRESSURE) == 1.7e-8);
    assert_true(read_as("40 mPa.s", OVR_DYNAMIC_VISCOSITY) == 0.04);
    assert_true(read_as("40 cP", OVR_DYNAMIC_VISCOSITY) == 0.04);
    assert_true(read_as("1.2 um", OVR_LENGTH) == 1.2e-6);
    assert_true(read_as("1.2 \302\265m", OVR_LENGTH) == 1.2e-6);
    assert_true(read_as("1.2\t\316\274m", OVR_LENGTH) == 1.2e-6);
    assert_true(read_as("300 N/mm", OVR_LINE_LOAD) == 3e5);
    assert_true(read_as("198 MPa", OVR_PRESSURE) == 1.98e8);
    assert_true(read_as("-2.5e+2 mm/s", OVR_SPEED) == -0.25);
    assert_true(read_as(".5 ms", OVR_DURATION) == 0.0005);
    assert_true(read_as("200 N/mm2", OVR_PRESSURE) == 2e8);
    assert_true(read_as("200 N/mm^2", OVR_PRESSURE) == 2e8);
    assert_true(read_as("200 N/mm\302\262", OVR_PRESSURE) == 2e8);
    assert_true(read_as("0.02 mm\302\262/N", OVR_PER_PRESSURE) == 2e-8);
    assert_true(read_as("5 %", OVR_SHARE) == 0.05);
    assert_true(read_as("-5%", OVR_SHARE) == -0.05);
    assert_true(read_as("0.05", OVR_SHARE) == 0.05);
    assert_true(read_as("5.", OVR_PURE) == 5);
    assert_true(read_as("-0", OVR_PURE) == 0);
}

static void refuse(const char *text, ovr_dimension dimension, const char *says)
{
    ovr_quantity q;
    ovr_error err = {0};
    if (!ovr_quantity_read(text, dimension, false, &q, &err))
        fail_msg("'%s' was read as %g", text, q.value);
    if (!strstr(err.message, says))
        fail_msg("'%s' does not say '%s'", err.message, says);
}

TEST(nonsense_is_refused)
{
    refuse("", OVR_PURE, "missing");
    refuse("nan", OVR_PURE, "not a number");
    refuse("inf", OVR_PURE, "not a number");
    refuse("-infinity", OVR_PURE, "not a number");
    refuse("0x10", OVR_PURE, "without a unit");
    refuse("1e999", OVR_PURE, "beyond the range");
    refuse("1e-999", OVR_PURE, "beyond the range");
    refuse("1e308 GPa", OVR_PRESSURE, "beyond the range");
    refuse("1,5", OVR_PURE, "comma");
    refuse("1.2.3", OVR_PURE, "without a unit");
    refuse("--1", OVR_PURE, "not a number");
    refuse(".", OVR_PURE, "not a number");
    refuse("1 2", OVR_PURE, "without a unit");
    refuse("5 mm", OVR_PURE, "without a unit");
    refuse("5", OVR_LENGTH, "needs a unit; allowed: m, mm, um, nm");
    refuse("5 GPa", OVR_LENGTH, "wrong unit 'GPa'; allowed: m,");
    refuse("5 furlong", OVR_LENGTH, "unknown unit 'furlong'");
    refuse("5 %", OVR_PURE, "without a unit");
    refuse("5 mm", OVR_SHARE, "without a unit, or in %");
    refuse("5 MM", OVR_LENGTH, "unknown unit");
    refuse("5 Mpa", OVR_PRESSURE, "unknown unit 'Mpa'; did you mean 'MPa'?");
    refuse("40 mPas", OVR_DYNAMIC_VISCOSITY, "did you mean 'mPa.s'?");
    refuse("40 mPas", OVR_DYNAMIC_VISCOSITY, "allowed: Pa.s, mPa.s, cP");
}

TEST(bare_numbers_only_where_allowed)
{
    ovr_quantity q;
    assert_int_equal(ovr_quantity_read("3", OVR_LENGTH, true, &q, NULL), 0);
    assert_null(q.unit);
    assert_int_equal(ovr_quantity_read("3 mm", OVR_LENGTH, true, &q, NULL), 0);
    assert_string_equal(q.unit, "mm");
}

TEST(every_dimension_lists_units_it_accepts)
{
    for (ovr_dimension d = OVR_LENGTH; d <= OVR_DURATION; d++) {
        char list[100];
        snprintf(list, sizeof list, "%s", ovr_units_allowed(d));
        for (char *u = strtok(list, ", "); u; u = strtok(NULL, ", "))
            assert_true(ovr_unit_value(u, d) > 0);
        assert_true(ovr_unit_value(ovr_unit_si(d), d) == 1);
    }
    assert_true(isnan(ovr_unit_value("mm", OVR_PRESSURE)));
}

TEST(locale_does_not_matter)
{
    if (!test_decimal_comma())
        skip();
    assert_true(read_as("1.5", OVR_PURE) == 1.5);
    setlocale(LC_ALL, "C");
}

TEST(near_names_are_suggested)
{
    static const char *const names[] = {"viscosity", "alpha", "p0",
                                        "viscosity_law"};
    assert_string_equal(ovr_suggest("viscocity", names, 4), "viscosity");
    assert_string_equal(ovr_suggest("VISCOSITY", names, 4), "viscosity");
    assert_string_equal(ovr_suggest("aplha", names, 4), "alpha");
    assert_null(ovr_suggest("temperature", names, 4));
    assert_string_equal(ovr_suggest("law", names, 4), "viscosity_law");
    assert_null(ovr_suggest("la", names, 4));
    assert_null(ovr_suggest("", names, 4));
}
