/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines of equal value: circles, saddles, nothing to draw. */
#include <math.h>

#include "pictures/contour.h"
#include "support/test.h"

enum { N = 80 };

static ovr_series drawn(const double *values, double level, ovr_arena *arena)
{
    ovr_error err;
    ovr_cells cells = {N, N, values, -2, 2, -2, 2};
    ovr_series s;
    CHECK_OK(ovr_contour(&cells, level, arena, &s, &err), &err);
    return s;
}

static double middle(int k)
{
    return -2 + 4 * (k + 0.5) / N;
}

static void a_cone_has_circles(void **state)
{
    static double v[N * N];
    ovr_arena arena = ovr_arena_make(NULL);
    (void)state;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++)
            v[j * N + i] = hypot(middle(i), middle(j));
    ovr_series s = drawn(v, 1.3, &arena);
    double length = 0;
    assert_true(s.n > 0);
    for (size_t k = 0; k < s.n; k += 3) {
        CHECK_NEAR(hypot(s.x[k], s.y[k]), 1.3, 1e-3);
        assert_true(isnan(s.x[k + 2]));
        length += hypot(s.x[k + 1] - s.x[k], s.y[k + 1] - s.y[k]);
    }
    CHECK_CLOSE(length, 2 * acos(-1) * 1.3, 1e-3); /* closed, and once */
    assert_int_equal(drawn(v, 5, &arena).n, 0);
    ovr_arena_release(&arena);
}

/* x y = 0 near its saddle: two lines, each piece in one of them. */
static void a_saddle_has_two_lines(void **state)
{
    static double v[N * N];
    ovr_arena arena = ovr_arena_make(NULL);
    (void)state;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++)
            v[j * N + i] = middle(i) * middle(j);
    for (double level = -0.01; level < 0.02; level += 0.02) {
        ovr_series s = drawn(v, level, &arena);
        double length = 0;
        for (size_t k = 0; k < s.n; k += 3) {
            CHECK_NEAR(s.x[k] * s.y[k], level, 2e-3);
            length += hypot(s.x[k + 1] - s.x[k], s.y[k + 1] - s.y[k]);
        }
        CHECK_CLOSE(length, 4 * 1.975, 0.05);
    }
    ovr_arena_release(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cone_has_circles),
        cmocka_unit_test(a_saddle_has_two_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
