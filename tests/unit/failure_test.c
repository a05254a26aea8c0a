/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Why a solve failed is told without infinite numbers and such that are none,
 * whatever it ended in. */
#include "support/test.h"

#include <math.h>
#include <string.h>

#include "simulation/internal.h"
#include "support/contact.h"

static void has_no_such_word(const char *message)
{
    static const char *const words[] = {"nan", "inf"};
    assert_true(strlen(message) > 20);
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strstr(message, words[k]))
            fail_msg("%s", message);
}

TEST(what_diverged_is_told_in_words)
{
    const double ends[] = {NAN, -NAN, INFINITY, 1e-3};
    ovr_error err = {0};
    ovr_options o = test_options();
    o.level = 6;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++)
        for (int load = 0; load < 2; load++) {
            ovr_outcome end = {.defect = {ends[k], 1e-3, 0.1}, .cycles = 50};
            if (load)
                end.defect = (ovr_defect){1e-3, ends[k], 0.1};
            ovr_failure_steady(sim, &end, 1e-5, &err);
            has_no_such_word(err.message);
            ovr_failure_step(sim, &end, 0.5, &err);
            has_no_such_word(err.message);
        }
    ovr_simulation_free(sim);
}
