/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: tables of two columns (histories, lift of a cam, load shares of
 * a gear, lubricant properties, supplied layers, stresses against depth) and
 * tables of a study. Any file is read or rejected with a message of one line;
 * the last byte selects the kind. */
#include "fuzz/folder.h"

#include <math.h>

#include "overroll/overroll.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define OIL "[lubricant]\nviscosity = 10 mPa.s\nalpha = 16 1/GPa\n"
#define GRID "[contact]\nmodulus = 226 GPa\n[domain]\nlevel = 4\n"
#define RUN                                                                    \
    GRID "[contact]\nload = 60 kN/m\nradius = 10 mm\nmean_speed = 2 m/s\n"     \
         "[time]\nend = 1\n"

static const char *const cases[] = {
    RUN OIL "[load]\nhistory = table\nfile = t.csv\n",
    RUN OIL "[sliding]\nhistory = table\nfile = t.csv\n",
    GRID OIL "[cam]\nfollower = flat\nbase_radius = 34 mm\nface = 12 mm\n"
             "speed = 1500 rpm\nlaw = table\nfile = t.csv\n"
             "spring = 30 N/mm\npreload = 250 N\nmass = 100 g\n",
    GRID OIL "[gear]\nmodule = 3 mm\nteeth_1 = 20\nteeth_2 = 40\n"
             "face = 20 mm\nspeed = 3000 rpm\ntorque = 100 N.m\n"
             "sharing = table\nfile = t.csv\n",
    RUN OIL "rheology = table\nrheology_file = t.csv\n",
    RUN "[lubricant]\nviscosity_law = table\nviscosity_file = t.csv\n",
    RUN OIL "density_law = table\ndensity_file = t.csv\n",
    RUN OIL "[cavitation]\nmodel = conserving\n[supply]\nmodel = film\n"
            "thickness_2 = 1 um\nprofile_1 = t.csv\n",
    RUN OIL "[boundary]\nlaw = table\nfile = t.csv\nof = all\n",
    RUN OIL "[stress]\nsurface = 1\n[fatigue]\ncriterion = circle\n"
            "alpha = 0.3\nresidual_table = t.csv\n",
};
enum { CASES = sizeof cases / sizeof *cases };

static void as_column(const char *text)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "case", ".", NULL, &err);
    fuzz_fail_unless(c != NULL);
    ovr_setup *setup = ovr_case_resolve(c, NULL, &err);
    fuzz_fail_unless(setup || fuzz_is_line(&err));
    ovr_setup_free(setup);
    ovr_case_free(c);
}

static void as_study(void)
{
    ovr_error err = {0};
    const ovr_table_column *column;
    ovr_table *table = ovr_table_read("t.csv", &err);
    fuzz_fail_unless(table || fuzz_is_line(&err));
    size_t cells = 0, known = 0;
    for (size_t k = 0; table && (column = ovr_table_at(table, k)); k++)
        for (size_t row = 0; row < ovr_table_rows(table); row++, cells++)
            known += isnan(column->number[row]) ? 0 : 1;
    fuzz_fail_unless(known <= cells); /* every number was there to read */
    ovr_table_free(table);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (!size)
        return 0;
    unsigned as = data[size - 1] % (CASES + 1);
    fuzz_put("t.csv", data, size - 1);
    if (as < CASES)
        as_column(cases[as]);
    else
        as_study();
    return 0;
}
