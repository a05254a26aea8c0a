/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Table 1 of the paper: computing time against n with 2 V or 2 W cycles per
 * refinement. The ratio of successive rows (about 2 for O(n ln n)) and the
 * speed-up relative to the machine of the paper are printed. Times are not
 * checked. */
#include "support/contact.h"
#include "support/test.h"

#include <stdio.h>

#include "support/reference.h"
#include "support/steady.h"

enum { FIRST = 5, PRINTED_LAST = 14 };

static ovr_options fixed(int level, int index, bool paper)
{
    ovr_options o = test_options();
    o.level = level;
    o.scheme = OVR_UPSTREAM1;
    o.cycle_index = index;
    o.stop = OVR_STOP_FIXED;
    o.cycles = 2;
    if (paper) {
        o.smoother = OVR_HYBRID;
        o.coarsest_level = 1;
        o.paper_balance = true;
    }
    return o;
}

/* The shortest of three. */
static double best_time(int level, int index, bool paper, test_solution *s)
{
    ovr_options o = fixed(level, index, paper);
    double best = 1e9;
    for (int k = 0; k < 3; k++) {
        *s = test_steady(20, 10, &o);
        if (s->seconds < best)
            best = s->seconds;
    }
    return best;
}

static void print_times(int level, int index, double seconds, double before)
{
    print_message(" %.2f | ", 1e3 * seconds);
    if (before > 0)
        print_message("%.2f ", seconds / before);
    if (level <= PRINTED_LAST) {
        const double *then = index == 1 ? printed_2V : printed_2W;
        print_message("| %.0f | %.0f |", then[level - FIRST],
                      then[level - FIRST] / seconds);
    } else {
        print_message("| | |");
    }
}

static void table(bool paper)
{
    double before[3] = {0};
    int last = test_levels(9);
    print_message("\n|| %s, ms, ratio to the row above, paper s, times as "
                  "fast\n"
                  "| level | n | 2V | ratio | paper | speed-up | 2W | ratio "
                  "| paper | speed-up |\n"
                  "|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
                  paper ? "the paper's algorithm: hybrid, 15 nodes, H0 relaxed"
                        : "line smoother, dense coarsest grid");
    for (int level = FIRST; level <= last; level++) {
        print_message("| %d | %d |", level, (7 << level) + 1);
        for (int index = 1; index <= 2; index++) {
            test_solution s;
            double seconds = best_time(level, index, paper, &s);
            print_times(level, index, seconds, before[index]);
            before[index] = seconds;
            if (!paper || (index == 2 && level >= 6))
                assert_int_equal(s.status, OVR_OK);
        }
        print_message("\n");
    }
}

TEST(test_paper)
{
    table(true);
}

TEST(test_line)
{
    table(false);
}

/* What 2 W cycles leave is far below the discretization error, and so the
 * film is that of the exact discrete solution. */
TEST(test_two_w_suffice)
{
    for (int level = 7; level <= 9; level++) {
        ovr_options o = fixed(level, 2, true);
        test_solution s = test_steady(20, 10, &o);
        CHECK_OK(s.status, NULL);
        assert_true(s.finest.cycles == 2);
        assert_true(s.finest.algebraic < 0.1 * s.finest.difference);
        CHECK_NEAR(s.o.H_min, exact_row(1, level)->H_m, 1e-4);
        CHECK_NEAR(s.o.H_cen, exact_row(1, level)->H_cen, 1e-5);
    }
}

/* On fine grids too W cycles leave less than V cycles do: coarse grids are
 * solved twice. */
TEST(test_two_w_leave_less)
{
    double left[2];
    for (int index = 1; index <= 2; index++) {
        ovr_options o = fixed(13, index, false);
        test_solution s = test_steady(20, 10, &o);
        CHECK_OK(s.status, NULL);
        left[index - 1] = s.finest.algebraic;
    }
    print_message("level 13: 2 V leave %.1e, 2 W %.1e\n", left[0], left[1]);
    assert_true(left[1] < 0.1 * left[0]);
}

/* Low loads: 2 V cycles are enough, as the paper says. */
TEST(test_two_v_at_low_load)
{
    const double ML[][2] = {{5, 2.5}, {5, 10}, {10, 2.5}, {10, 10}};
    for (size_t k = 0; k < sizeof ML / sizeof *ML; k++) {
        ovr_options o = fixed(9, 1, true);
        test_solution s = test_steady(ML[k][0], ML[k][1], &o);
        CHECK_OK(s.status, NULL);
        assert_true(s.finest.algebraic < 0.5 * s.finest.difference);
    }
}
