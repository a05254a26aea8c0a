/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The quantities that find accepts before the first run are at least the
 * numbers of the summary of the solved run. */
#include <stdio.h>
#include <string.h>

#include "overroll/overroll.h"
#include "run/find.h"
#include "run/internal.h"
#include "support/test.h"

enum { KEYS = 1200 };

typedef struct keys {
    char key[KEYS][64];
    size_t count;
} keys;

static void keep(void *data, const ovr_summary_line *line)
{
    keys *k = data;
    if (!line->key || line->form > OVR_SUMMARY_FLAG)
        return;
    assert_true(k->count < KEYS);
    snprintf(k->key[k->count++], sizeof *k->key, "%s", line->key);
}

static bool has(const keys *k, const char *key)
{
    for (size_t j = 0; j < k->count; j++)
        if (!strcmp(k->key[j], key))
            return true;
    return false;
}

static ovr_case *read(const char *text)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "a.ini", NULL, NULL, &err);
    CHECK_OK(err.status, &err);
    assert_non_null(c);
    return c;
}

static void solved(const char *text, const ovr_run_options *how, keys *to)
{
    ovr_error err = {0};
    ovr_case *c = read(text);
    ovr_run *run = ovr_run_create(c, how, NULL, &err);
    CHECK_OK(err.status, &err);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    ovr_run_summary(ovr_run_get_info(run), keep, to);
    ovr_run_free(run);
    ovr_case_free(c);
}

static void unsolved(const char *text, const ovr_run_options *how, keys *to)
{
    ovr_error err = {0};
    ovr_case *c = read(text);
    ovr_run *run = ovr_run_unsolved(c, how, &err);
    CHECK_OK(err.status, &err);
    ovr_run_keys(ovr_run_get_info(run), keep, to);
    ovr_run_free(run);
    ovr_case_free(c);
}

static void compare(const char *text, bool steady, const char *output,
                    const char *must)
{
    ovr_run_options how = {0};
    static keys before, after;
    before.count = after.count = 0;
    how.steady = steady;
    unsolved(text, &how, &before);
    how.output = output;
    solved(text, &how, &after);
    assert_true(after.count > 60);
    if (!has(&after, must))
        fail_msg("the run has no %s", must);
    for (size_t k = 0; k < after.count; k++)
        if (!has(&before, after.key[k]))
            fail_msg("find would refuse %s", after.key[k]);
}

#define CONTACT                                                                \
    "[contact]\nload = 300 kN/m\nradius = 8 mm\nmodulus = 226 GPa\n"           \
    "mean_speed = 3 m/s\nslide_to_roll = 0.1\nwidth = 10 mm\n"
#define OIL                                                                    \
    "[lubricant]\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\np0 = 198 MPa\n"      \
    "z = 0.68\nrheology = eyring\neyring_stress = 5 MPa\n"
#define LEVEL "[domain]\nlevel = 4\n"
#define ROUGH                                                                  \
    "[feature r]\nsurface = 1\nshape = wave\namplitude = 0.01\n"               \
    "wavelength = 1\n"

TEST(steady_contacts)
{
    compare("[contact]\nM = 20\nL = 10\n" LEVEL, true, NULL, "H_min");
    compare(CONTACT OIL LEVEL, true, NULL, "load_N");
}

TEST(runs_in_time)
{
    compare(CONTACT OIL LEVEL ROUGH "[time]\nend = 0.3\n", false, NULL,
            "lambda_ratio_min");
}

TEST(stresses_of_layers_with_fatigue_and_yield)
{
    compare("[contact]\nload = 300 kN/m\nmean_speed = 3 m/s\n"
            "slide_to_roll = 0.1\n" OIL
            "[body 1]\nmaterial = steel\nradius = 35 mm\nyield = 1 GPa\n"
            "[body 2]\nmaterial = steel\nradius = 35 mm\n"
            "[coating 1]\nmaterial = dlc\nthickness = 3 um\n"
            "[domain]\nlevel = 6\n[stress]\nsurface = 1\n",
            false, NULL, "layer_von_mises_max");
    compare(CONTACT OIL LEVEL "[body 1]\nyield = 1 GPa\n[stress]\n"
                              "surface = 1\n[fatigue]\n[time]\nend = 3\n",
            false, NULL, "yielding_share");
}

TEST(machine_elements)
{
    compare("[gear]\nteeth_1 = 25\nteeth_2 = 57\nmodule = 2.5 mm\n"
            "face = 20 mm\nspeed = 3000 rpm\ntorque = 80 N.m\n"
            "[contact]\nmodulus = 226 GPa\n" OIL LEVEL "[time]\nend = 0.3\n",
            false, NULL, "efficiency");
}

TEST_IN_FOLDER(several_passes)
{
    compare("[contact]\nload = 300 kN/m\nradius = 8 mm\nmodulus = 226 GPa\n"
            "mean_speed = 3 m/s\n[lubricant]\nviscosity = 40 mPa.s\n"
            "alpha = 17 1/GPa\n" LEVEL "[cavitation]\nmodel = conserving\n"
            "[supply]\nmodel = film\nthickness_1 = 0.2 um\n"
            "thickness_2 = 0.2 um\n[passes]\nnumber = 2\nloss = 0.1\n",
            false, test_path(*state, "a.h5"), "pass");
}
