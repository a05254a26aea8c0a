/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Search for a value: roots in closed form, inequalities, several answers,
 * missing values, and values with scatter. */
#include "support/test.h"

#include <math.h>

#include "mathematics/search.h"

typedef struct seen {
    double (*of)(double x);
    long evaluations, batches;
} seen;

static ovr_status evaluate(void *data, size_t n, const double *x, double *q,
                           ovr_error *err)
{
    seen *s = data;
    (void)err;
    s->batches++;
    for (size_t k = 0; k < n; k++, s->evaluations++)
        q[k] = s->of(x[k]);
    return OVR_OK;
}

static ovr_search_result find(ovr_search search, double (*of)(double), seen *s)
{
    ovr_search_result r;
    ovr_error err = {0};
    *s = (seen){.of = of};
    search.evaluate = evaluate;
    search.data = s;
    CHECK_OK(ovr_search_run(&search, &r, &err), &err);
    return r;
}

static double cube(double x)
{
    return x * x * x;
}

static double inverse(double x)
{
    return 1 / x;
}

static double hump(double x)
{
    return x * (2 - x);
}

TEST(roots)
{
    const double tolerances[] = {1e-3, 1e-6, 1e-9};
    seen s;
    for (int k = 0; k < 3; k++) {
        double tolerance = tolerances[k];
        ovr_search_result r = find(
            (ovr_search){
                .from = -1, .to = 3, .target = 5, .tolerance = tolerance},
            cube, &s);
        assert_int_equal(r.end, OVR_SEARCH_FOUND);
        CHECK_CLOSE(r.value, cbrt(5), tolerance);
        assert_true(r.low <= cbrt(5) && cbrt(5) <= r.high);
        CHECK_CLOSE(r.slope, 3 * pow(r.value, 2), 10 * tolerance);
        assert_true(r.monotone && r.rises && !r.scatters);
        assert_true(s.evaluations <= (k == 0 ? 18 : 24));
        r = find(
            (ovr_search){
                .from = 0.02, .to = 50, .target = 3, .tolerance = tolerance},
            inverse, &s);
        CHECK_CLOSE(r.value, 1.0 / 3, tolerance);
        CHECK_CLOSE(r.slope, -9, 30 * tolerance);
        assert_true(r.monotone && !r.rises);
    }
}

/* The answer satisfies the inequality, and a step further does not. */
TEST(inequalities)
{
    seen s;
    for (int sense = -1; sense <= 1; sense += 2)
        for (int which = -1; which <= 1; which += 2) {
            bool possible = sense == -which; /* the cube rises */
            ovr_search search = {.from = 0.1,
                                 .to = 3,
                                 .target = 5,
                                 .sense = sense,
                                 .which = which,
                                 .tolerance = 1e-4};
            ovr_search_result r = find(search, cube, &s);
            assert_int_equal(r.end,
                             possible ? OVR_SEARCH_FOUND : OVR_SEARCH_BEYOND);
            if (!possible)
                continue;
            CHECK_CLOSE(r.value, cbrt(5), 1e-4);
            assert_true(sense > 0 ? r.at_value >= 5 : r.at_value <= 5);
            assert_true(r.at_value == cube(r.value));
        }
}

TEST(several)
{
    seen s;
    ovr_search search = {.from = 0, .to = 2, .target = 0.6, .tolerance = 1e-6};
    ovr_search_result r = find(search, hump, &s);
    assert_int_equal(r.end, OVR_SEARCH_SEVERAL);
    assert_int_equal(r.places, 2);
    assert_false(r.monotone);
    search.sense = 1;
    for (search.which = -1; search.which <= 1; search.which += 2) {
        r = find(search, hump, &s);
        assert_int_equal(r.end, OVR_SEARCH_FOUND);
        CHECK_CLOSE(r.value, 1 + search.which * sqrt(0.4), 1e-6);
    }
    search.sense = 0;
    search.which = 0;
    search.target = 2;
    r = find(search, hump, &s);
    assert_int_equal(r.end, OVR_SEARCH_MISSED);
    assert_true(r.minimum == 0 && r.maximum == 1);
}

static double fails_above(double x)
{
    return x > 1.9 ? NAN : cube(x);
}

static double fails_within(double x)
{
    return x > 1.1 && x < 1.3 ? NAN : cube(x);
}

static double fails_everywhere(double x)
{
    return x * NAN;
}

TEST(missing)
{
    seen s;
    ovr_search search = {.from = 0.5, .to = 3, .target = 5, .tolerance = 1e-6};
    ovr_search_result r = find(search, fails_above, &s);
    assert_int_equal(r.end, OVR_SEARCH_FOUND);
    CHECK_CLOSE(r.value, cbrt(5), 1e-6);
    search.target = 10; /* above all that there is */
    r = find(search, fails_above, &s);
    assert_int_equal(r.end, OVR_SEARCH_MISSED);
    assert_true(r.to <= 1.9 && r.to > 1.8);
    search.target = 2; /* at 1.26 */
    r = find(search, fails_within, &s);
    assert_int_equal(r.end, OVR_SEARCH_BROKEN);
    search.target = 3; /* at 1.44, near it */
    r = find(search, fails_within, &s);
    assert_int_equal(r.end, OVR_SEARCH_FOUND);
    CHECK_CLOSE(r.value, cbrt(3), 1e-6);
    r = find(search, fails_everywhere, &s);
    assert_int_equal(r.end, OVR_SEARCH_NOTHING);
}

/* Noise of 1 %, the same at the same x. */
static double rough(double x)
{
    double noise = sin(1e7 * x) + sin(3.3e7 * x);
    return cube(x) * (1 + 0.01 * noise);
}

TEST(scatter)
{
    seen s;
    ovr_search search = {.from = 0.5, .to = 3, .target = 5, .tolerance = 1e-3};
    ovr_search_result r = find(search, rough, &s);
    assert_int_equal(r.end, OVR_SEARCH_FOUND);
    assert_true(r.scatters);
    assert_true(r.scatter > 0.005 && r.scatter < 0.5);
    CHECK_CLOSE(r.value, cbrt(5), 3 * r.scatter / (3 * pow(cbrt(5), 2)));
    search.tolerance = 0.1; /* worse than the noise */
    r = find(search, rough, &s);
    assert_false(r.scatters);
    CHECK_CLOSE(r.value, cbrt(5), 0.1);
}

static ovr_status stops(void *data, size_t n, const double *x, double *q,
                        ovr_error *err)
{
    (void)data, (void)n, (void)x, (void)q;
    return ovr_fail(err, OVR_STOPPED, "enough");
}

TEST(stopped)
{
    ovr_search search = {
        .from = 0, .to = 1, .tolerance = 1e-3, .evaluate = stops};
    ovr_search_result r;
    ovr_error err = {0};
    CHECK_STATUS(ovr_search_run(&search, &r, &err), OVR_STOPPED, &err);
}

/* The scan is one batch, as wide as asked. */
TEST(in_parallel)
{
    seen s;
    ovr_search search = {
        .from = 1, .to = 2, .target = 10, .tolerance = 1e-3, .scan = 12};
    find(search, cube, &s);
    assert_int_equal(s.batches, 1);
    assert_int_equal(s.evaluations, 12);
}
