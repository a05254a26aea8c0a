/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Effect of the order of the MLMI transfers on H_m, P_s and H0 at M = 20, L =
 * 10, first-order wedge: differences from the automatic order. The paper used
 * sixth order up to level 12 and tenth order above. */
#include "support/contact.h"
#include "support/test.h"

#include <math.h>
#include <stdio.h>

#include "support/steady.h"

static test_solution solve(int level, int order, int range)
{
    ovr_options o = test_options();
    o.level = level;
    o.scheme = OVR_UPSTREAM1;
    o.stop = level > 10 ? OVR_STOP_TRUNCATION : OVR_STOP_NEGLIGIBLE;
    o.mlmi_order = order;
    o.mlmi_range = range;
    return test_steady(20, 10, &o);
}

static const struct {
    int order, range;
} choices[] = {{4, 8}, {6, 10}, {6, 16}, {8, 16}, {10, 16}, {12, 24}};
enum { CHOICES = sizeof choices / sizeof *choices };

static void print_row(int level, size_t k, const test_solution *s,
                      const test_solution *automatic)
{
    print_message("| %d | %d | %d | %.1e | %.1e | %.1e | %s |\n", level,
                  choices[k].order, choices[k].range,
                  s->o.H_min - automatic->o.H_min,
                  s->o.P_spike - automatic->o.P_spike,
                  s->o.H0 - automatic->o.H0, s->status ? "not converged" : "");
}

TEST(test_orders)
{
    int last = test_levels(8) < 14 ? test_levels(8) : 14;
    print_message("\n|| MLMI order p, range m: change of the solution\n"
                  "| level | p | m | H_m | P_s | H0 | |\n"
                  "|--:|--:|--:|--:|--:|--:|:--|\n");
    for (int level = 8; level <= last; level += 2) {
        test_solution automatic = solve(level, 0, 0);
        assert_int_equal(automatic.status, OVR_OK);
        for (size_t k = 0; k < CHOICES; k++) {
            test_solution s = solve(level, choices[k].order, choices[k].range);
            print_row(level, k, &s, &automatic);
            if (level > 12 || choices[k].order < 6)
                continue;
            assert_int_equal(s.status, OVR_OK);
            CHECK_NEAR(s.o.H_min, automatic.o.H_min, 1e-5);
            CHECK_NEAR(s.o.P_spike, automatic.o.P_spike, 1e-3);
        }
    }
}
