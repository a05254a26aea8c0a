/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The solution passed to observers, on nodes at unequal distances. */
#include "simulation/solution.h"

#include "support/test.h"

static const double nodes[] = {-4, -2, -1, -0.5, -0.25, 0.5, 0.75, 1, 1.5};
static const ovr_solution solution = {.n = sizeof nodes / sizeof *nodes,
                                      .X = nodes};

static double cubic(double X)
{
    return 2 + X * (0.5 + X * (-1 + 3 * X));
}

TEST(cubics_are_exact)
{
    double f[sizeof nodes / sizeof *nodes];
    for (size_t i = 0; i < solution.n; i++)
        f[i] = cubic(nodes[i]);
    for (int k = 0; k <= 100; k++) {
        double X = -4 + 5.5 * k / 100;
        CHECK_NEAR(ovr_value_at(&solution, f, X), cubic(X), 1e-12);
    }
    for (size_t i = 0; i < solution.n; i++)
        assert_true(ovr_value_at(&solution, f, nodes[i]) == f[i]);
}

TEST(nodes_are_found)
{
    assert_int_equal(ovr_node_after(&solution, -9), 1);
    assert_int_equal(ovr_node_after(&solution, -4), 1);
    assert_int_equal(ovr_node_after(&solution, 0), 5);
    assert_int_equal(ovr_node_after(&solution, 0.5), 6);
    assert_int_equal(ovr_node_after(&solution, 9), 8);
    assert_true(ovr_spacing(&solution, 5) == 0.75);
}
