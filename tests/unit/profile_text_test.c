/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Special cases of text files, and samples of real ones. */
#include "support/test.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "overroll/overroll.h"
#include "surface/profile.h"

static ovr_profile_source source;
static ovr_profile *profile;
static const ovr_profile_view *view;

static int begin(void **state)
{
    (void)state;
    source = ovr_profile_source_default();
    source.file = "it";
    profile = NULL;
    return 0;
}

static int end(void **state)
{
    (void)state;
    ovr_profile_free(profile);
    return 0;
}

static void read_bytes(const char *data, size_t size)
{
    ovr_error err;
    ovr_profile_free(profile);
    profile = ovr_profile_parse(&source, data, size, NULL, &err);
    if (!profile)
        fail_msg("%s", err.message);
    view = ovr_profile_get_view(profile);
}

static void read_text(const char *text)
{
    read_bytes(text, strlen(text));
}

static void check_point(size_t i, double x, double z)
{
    CHECK_NEAR(view->x[i], x, 1e-15);
    CHECK_NEAR(view->z[i], z, 1e-15);
}

static void check_note(const char *part)
{
    if (!strstr(view->notes, part))
        fail_msg("notes lack '%s':\n%s", part, view->notes);
}

TEST_WITH(headers_contain_units, begin, end)
{
    static const char *const headers[] = {"X_(microns),Z_(nm)\n",
                                          "[um];[nm]\n",
                                          "x in um, y in nm\n",
                                          "Lateral um,Raw Nanometer\n",
                                          "x [um]  z [nm]\n",
                                          "# x_unit: um\n# z_unit: nm\nx,z\n",
                                          "unit_x = um\nunit_z = nm\n",
                                          "x (\xC2\xB5m),z (nm)\n",
                                          "x (\xCE\xBCm),z (nm)\n",
                                          "x (\xB5m);z (nm)\n",
                                          "made 2024\nx, z\num, nm\n",
                                          "\"x / um\",\"z / nm\"\n",
                                          "Scan 5 mm, tip 2 mm\nx um\tz nm\n"};
    for (size_t k = 0; k < sizeof headers / sizeof headers[0]; k++) {
        char text[200];
        snprintf(text, sizeof text, "%s0;0\n1,5;-3\n2;4\n", headers[k]);
        read_text(text);
        check_point(1, 1.5e-6, -3e-9);
    }
}

/* Names end where columns or separators go on. */
TEST_WITH(headers_may_be_narrower_or_wider, begin, end)
{
    static const char *const texts[] = {
        "Lateral um,Raw Micrometer,\n0,1\n2,3\n",
        "Lateral um,Raw Micrometer,\n0,1,\n2,3,\n",
        "Lateral um,Raw Micrometer,\n0,1,,\n2,3,,\n",
        "Lateral um,Raw Micrometer,\n0,1,9\n2,3,9\n",
        "Lateral um,Raw Micrometer,,,\r\n0,1,9\r\n2,3,9\r\n",
        "Lateral um,Raw Micrometer,,\n0;1\n2;3\n",
        "Title,,\nLateral um,Raw Micrometer,\n,,\n0,1,,9\n2,3,,9\n"};
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
        read_text(texts[k]);
        check_point(1, 2e-6, 3e-6);
        check_note("header: \"Raw Micrometer\"");
    }
}

/* Quotation marks around names are no part of them; around a comma they keep a
 * name together. */
TEST_WITH(names_may_be_quoted, begin, end)
{
    static const char *const texts[] = {
        "\"X (um)\",\"Z (um)\"\n0,1\n2,3\n", "\"X (um)\",Z (um)\n0,1\n2,3\n",
        "X (um),\"Z (um)\"\n0,1\n2,3\n", "# \"X (um)\";\"Z (um)\"\n0;1\n2;3\n",
        "\"file, of today\"\n\"X (um)\",\"Z (um)\"\n0,1\n2,3\n"};
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
        read_text(texts[k]);
        check_point(1, 2e-6, 3e-6);
        check_note("x in um (header: \"X (um)\")");
        check_note("z in um (header: \"Z (um)\")");
    }
    read_text("\"X, along (um)\",\"Z (um)\"\n0,1\n2,3\n");
    check_point(1, 2e-6, 3e-6);
    check_note("x in um (header: \"X, along (um)\")");
}

/* Each text, and all parts of the one message about it. */
TEST_WITH(all_missing_keys_are_in_one_message, begin, end)
{
    static const char *const cases[][6] = {
        {"0,1\n2,3\n", "unit of x", "unit of z", "unit_x = um", "unit_z = um",
         NULL},
        {"1\n2\n3\n", "spacing = 0.5 um", "unit_z = um", NULL},
        {"0,1,2\n3,4,5\n", "column_x = 1", "column_z = 2", "unit_x = um",
         "unit_z = um", NULL},
        {"x furlong,z [parsec]\n0,1\n2,3\n", "unknown unit 'furlong'",
         "unknown unit 'parsec'", NULL},
        {"unit_x = cubit\nunit_z = um\n0,1\n2,3\n", "unknown unit 'cubit' of x",
         NULL}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        ovr_error err;
        const char *text = cases[k][0];
        ovr_profile *p = ovr_profile_parse(&source, text, strlen(text), NULL,
                                           &err);
        assert_null(p);
        for (int i = 1; cases[k][i]; i++)
            CHECK_ERROR(&err, OVR_BAD_INPUT, cases[k][i]);
    }
}

TEST_WITH(one_unit_may_stand_for_both, begin, end)
{
    read_text("units: um\n0 1\n1 2\n");
    check_point(1, 1e-6, 2e-6);
}

TEST_WITH(units_of_the_caller_come_first, begin, end)
{
    source.unit_x = "mm", source.unit_z = "inch";
    read_text("x um,z um\n0,1\n1,2\n");
    check_point(1, 1e-3, 2 * 0.0254);
    source.unit_x = "b", source.unit_z = "b^2/R";
    read_text("0,1\n1,2\n");
    assert_true(view->scaled_x && view->scaled_z);
    check_point(1, 1, 2);
}

TEST_WITH(columns_are_found_and_chosen, begin, end)
{
    read_text("index,x in um,y in um\n0,5,6\n1,7,8\n");
    check_point(1, 7e-6, 8e-6);
    read_text("z um;time;x um\n6;0;5\n8;0;7\n");
    check_point(1, 7e-6, 8e-6);
    source.column_x = 3, source.column_z = 2;
    read_text("a mm,b mm,c mm\n0,5,6\n1,7,8\n");
    check_point(1, 8e-3, 7e-3);
}

TEST_WITH(one_column_needs_a_spacing, begin, end)
{
    source.spacing = 2e-6;
    read_text("height (nm)\n1\n2\n4\n");
    check_point(2, 4e-6, 4e-9);
    source.spacing = NAN;
    read_text("dx = 0.5 um\nheight (nm)\n1\n2\n4\n");
    check_point(2, 1e-6, 4e-9);
    source.unit_z = "um", source.spacing = 1e-6;
    read_text("3\n0.1\n0.2\n0.4\n");
    assert_int_equal(view->n, 3);
    check_note("count line");
}

TEST_WITH(separators_may_trail, begin, end)
{
    read_text("x um,z um,\n0,1,\n1,2,\n");
    check_point(1, 1e-6, 2e-6);
    read_text("x um;z um;\n0;1;\n1;;\n2;3;\n");
    assert_true(isnan(view->z[1]));
}

TEST_WITH(counts_are_not_points, begin, end)
{
    read_text("x um,z um\n3\n0,1\n1,2\n2,3\n");
    assert_int_equal(view->n, 3);
    check_note("count line states 3");
    read_text("x um,z um\n5\n0,1\n1,2\n2,3\n");
    check_note("there are 3");
}

TEST_WITH(missing_heights_are_marked, begin, end)
{
    read_text("x um,z um\n0,1\n1,NaN\n2,BAD\n3,---\n4,\n5,nan\n6,2\n");
    assert_int_equal(view->n, 7);
    assert_int_equal(view->missing, 5);
}

TEST_WITH(rounded_x_is_put_right, begin, end)
{
    char text[4000];
    size_t used = 0;
    used += (size_t)snprintf(text, sizeof text, "x mm,z um\n");
    for (int i = 0; i < 50; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%.3f,%d\n",
                                 i * 0.0004, i);
    read_text(text);
    assert_int_equal(view->n, 50);
    assert_true(view->uniform);
    CHECK_NEAR(view->x[49] - view->x[0], 49 * 0.0004e-3, 2e-7);
    check_note("rounding");
    read_text("x um,z um\n0,1\n1,2\n1,4\n7,3\n");
    assert_int_equal(view->n, 3);
    check_point(1, 1e-6, 3e-6);
    check_note("averaged");
}

TEST_WITH(backwards_is_turned_round, begin, end)
{
    read_text("x um,z um\n3,1\n1,2\n0,4\n");
    check_point(0, 0, 4e-6);
    check_point(2, 3e-6, 1e-6);
    check_note("was reversed");
}

TEST_WITH(locale_does_not_matter, begin, end)
{
    if (!test_decimal_comma())
        skip();
    read_text("x um,z um\n0.5,1.25\n1.5,2e0\n");
    setlocale(LC_ALL, "C");
    check_point(0, 0.5e-6, 1.25e-6);
}

TEST_WITH(exponents_of_fortran_too, begin, end)
{
    read_text("x m z m\n 0.5D-6 +1.25E-06\n 1.5d-6 -2.e-6\n");
    check_point(0, 0.5e-6, 1.25e-6);
    check_point(1, 1.5e-6, -2e-6);
}

/* As found in the wild (an indentation in a disc; an interferometer's csv). */
TEST_WITH(samples_of_real_files, begin, end)
{
    static const char wide[] = "\xFF\xFE"
                               "i\0n\0d\0e\0x\0,\0x\0 \0i\0n\0 \0"
                               "\xB5\0m\0,\0y\0 \0i\0n\0 \0\xB5\0m\0\r\0\n\0"
                               "0\0,\0-\0"
                               "9\0"
                               "9\0.\0"
                               "5\0,\0-\0"
                               "1\0.\0"
                               "4\0\r\0\n\0"
                               "1\0,\0-\0"
                               "9\0"
                               "8\0.\0"
                               "5\0,\0-\0"
                               "1\0.\0"
                               "3\0\r\0\n\0";
    read_bytes(wide, sizeof wide - 1);
    check_point(1, -98.5e-6, -1.3e-6);
    check_note("UTF-16");
    check_note("x in um");
    source.unit_z = "um";
    read_text("X_(microns),y1\n0.0386,2.10425\n0.0772,2.08494\n"
              "0.1158,2.06564\n0.1544,2.04633\n0.1931,2.04633\n");
    check_point(4, 0.1931e-6, 2.04633e-6);
    assert_true(view->uniform);
    source.unit_z = NULL;
    read_text("aISO-1.0\nManufacID = ISOTC213\nCreateDate = 040120100853\n"
              "ModDate = 050320101353\nNumPoints = 3\nNumProfiles = 2\n"
              "Xscale = 1.0E-6\nYscale = 1.0E-6\nZscale = 1.0E-6\n"
              "Zresolution = 1.0E-9\nCompression = 0\nDataType = 7\n"
              "CheckType = 0\n*\n1.00000 0.99874 0.99495\n"
              "0.98865 BAD 0.96858\n*\n< OperatorName > T < / OperatorName >\n"
              "*");
    check_point(2, 2e-6, 0.99495e-6);
    check_note("row 1 of 2");
    source.row = 2;
    read_text("aISO-1.0\nNumPoints=3\nNumProfiles=2\nXscale=1e-6\n"
              "Zscale=1e-6\n*\n1 2 3\n4 5 6\n*\n");
    check_point(0, 0, 4e-6);
}

/* Columns are those of text, which holds one line. */
TEST_WITH(of_another_kind_of_file, begin, end)
{
    static const char text[] = "x um,z um\n1,2\n2,3\n",
                      areal[] = "aISO-1.0\nNumPoints=2\nNumProfiles=2\n"
                                "Xscale=1e-6\nZscale=1e-6\n*\n1 2\n4 5\n*\n";
    ovr_error err = {0};
    source.row = 2;
    assert_null(ovr_profile_parse(&source, text, sizeof text - 1, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "row: the file contains line 1 only");
    source.row = 0;
    source.column_z = 2;
    assert_null(
        ovr_profile_parse(&source, areal, sizeof areal - 1, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT,
                "column_z: has no effect, because only text files have "
                "columns");
}
