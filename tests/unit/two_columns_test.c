/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reader of tables of two columns gives the same numbers for all
 * separators, decimal signs, encodings, orders of the columns and line ends. It
 * names the line of an error. */
#include "support/test.h"

#include <string.h>

#include "surface/two_columns.h"

static ovr_arena arena;

static ovr_two_columns curve(void)
{
    return (ovr_two_columns){.name = {"pressure", "density"},
                             .header = {OVR_PRESSURE, OVR_MASS_DENSITY},
                             .example = "pressure [MPa], density [kg/m3]"};
}

static ovr_status parse(ovr_two_columns *c, const char *text, size_t size,
                        ovr_error *err)
{
    return ovr_two_columns_read(c, "t.csv", (ovr_bytes){text, size}, &arena,
                                err);
}

static void same(const char *text, size_t size)
{
    ovr_two_columns c = curve();
    ovr_error err = {0};
    CHECK_OK(parse(&c, text, size, &err), &err);
    assert_int_equal(c.count, 3);
    const double x[] = {0.1, 50, 1200}, y[] = {870.5, 890, 1000.25};
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(c.x[k], 1e6 * x[k], 1e-9 * 1e6 * x[k]);
        CHECK_NEAR(c.y[k], y[k], 1e-12 * y[k]);
    }
    assert_true(c.named);
    CHECK_NEAR(c.rounding, 0.01, 1e-15);
}

static void all(const char *text)
{
    same(text, strlen(text));
}

TEST(tables_read_the_same_however_written)
{
    arena = ovr_arena_make(NULL);
    all("pressure [MPa], density [kg/m3]\n0.1, 870.5\n50, 890\n1200, 1000.25");
    all("# pressure [MPa] density [kg/m3]\r\n.1 870.5\r\n\r\n50 890\r\n"
        "  1.2e3   1000.25 # last\r\n");
    all("\xEF\xBB\xBFp (MPa);rho (kg/m3)\r0,1;870,5\r50;890;\r1200;1000,25\r");
    all("p (MPa)\trho (kg/m3)\n0,1\t870,5\n50\t890\n1200\t1000,25\n");
    all("p (MPa)\trho (kg/m3)\n0.1,\t870.5\n50,\t890\n1200,\t1000.25\n");
    all("\"p (MPa)\",\"rho (kg/m3)\"\n\"0,1\",\"870,5\"\n\"50\",\"890\"\n"
        "\"1200\",\"1000,25\"\n");
    all("measured by someone\n\nrho [kg/m3]; p [GPa]\n870.5; 1e-4\n"
        "890; 0.05\n1000.25; 1.2\n");
    const char *text = "p [MPa] rho [kg/m3]\n0.1 870.5\n50 890\n1200 1000.25\n";
    char wide[256] = "\xFF\xFE";
    for (size_t k = 0; text[k]; k++)
        wide[2 + 2 * k] = text[k];
    same(wide, 2 + 2 * strlen(text));
    ovr_arena_release(&arena);
}

static void refused(const char *text, const char *why)
{
    ovr_two_columns c = curve();
    ovr_error err = {0};
    parse(&c, text, strlen(text), &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, why);
}

TEST(wrong_rows_are_named_by_their_line)
{
    arena = ovr_arena_make(NULL);
    refused("1 2\n", "t.csv:1: the header must name the units");
    refused("p [MPa], rho\n\n1 2\n", "t.csv:3: the header names a unit of the "
                                     "pressure and none of the density");
    refused("MPa kg/m3\n1 2\n# no\n3\n", "t.csv:4: must be two numbers");
    refused("MPa kg/m3\n1 2\n3 4 5\n", "t.csv:3: must be two numbers");
    refused("MPa kg/m3\n1 2\nnan 4\n", "t.csv:3: must be two numbers");
    refused("MPa kg/m3\n1;2\n3,5\n", "separated as in the first row");
    refused("MPa kg/m3\n1 2\n2 3\n2 4\n",
            "t.csv:4: the pressure must increase: 2 follows 2");
    refused("kg/m3 MPa\n1 2\n3 1\n",
            "t.csv:3: the pressure must increase: 1 follows 2");
    ovr_arena_release(&arena);
}

TEST(numbers_without_header_have_the_units_of_the_key)
{
    ovr_two_columns c = {.name = {"angle", "lift"},
                         .unit = {2, 1e-3},
                         .minimum = -1,
                         .maximum = 9,
                         .of = " mm",
                         .header = {OVR_ANGLE, OVR_LENGTH},
                         .optional = true};
    ovr_error err = {0};
    arena = ovr_arena_make(NULL);
    CHECK_OK(parse(&c, "no units\n1;2,5e-1", 17, &err), &err);
    assert_true(c.count == 1 && !c.named && c.line[0] == 2);
    assert_true(c.x[0] == 2 && c.y[0] == 0.25e-3);
    CHECK_NEAR(c.rounding, 1e-5, 1e-18); /* 0.01 mm */
    parse(&c, "1 2\n2 9.5\n", 10, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "t.csv:2: value 9.5 must be -1 to 9 mm");
    ovr_arena_release(&arena);
}
