/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicted film thickness of rough surfaces (amplitude reduction) compared
 * with runs: 20 random rolling surfaces (support/rough.h), from which the
 * errors in `check` and overroll(1) were measured, and 20 sliding ones. */
#include <math.h>
#include <stdio.h>

#include "support/rough.h"
#include "support/test.h"

typedef struct errors {
    double Rq, H_min;   /* largest */
    double each[20][2]; /* of Rq and H_min */
    int count;
    double low, high;        /* of the ratio of Rq */
    double thinner, thicker; /* difference from the prediction, relative to the
                                smooth film thickness */
} errors;

static void compare(uint64_t seed, double slide, errors *maximum)
{
    test_rough r = test_rough_run(seed, slide, 8);
    double ratio = r.film_Rq / r.predicted.film_Rq;
    double film = (r.H_min - r.predicted.H_min) / r.smooth;
    CHECK_OK(r.status, &r.err);
    print_message("# seed %d: M %5.1f L %5.2f slide %4.1f Rq %.4g: film's "
                  "%.4g, foreseen %.4g (%.3f); smallest film %.4g, foreseen "
                  "%.4g (%+.3f of the smooth)\n",
                  (int)seed, r.M, r.L, slide, r.predicted.Rq, r.film_Rq,
                  r.predicted.film_Rq, ratio, r.H_min, r.predicted.H_min, film);
    maximum->each[maximum->count][0] = fabs(ratio - 1);
    maximum->each[maximum->count++][1] = fabs(film);
    maximum->Rq = fmax(maximum->Rq, fabs(ratio - 1));
    maximum->H_min = fmax(maximum->H_min, fabs(film));
    maximum->low = fmin(maximum->low, ratio);
    maximum->high = fmax(maximum->high, ratio);
    maximum->thinner = fmax(maximum->thinner, -film);
    maximum->thicker = fmax(maximum->thicker, film);
}

static void survey(uint64_t seed, int count, double slide, errors *maximum)
{
    *maximum = (errors){.low = INFINITY};
    for (int k = 0; k < count; k++)
        compare(seed + (uint64_t)k, slide, maximum);
    print_message("# seeds %d on, %d surfaces, slide-to-roll ratio %g: Rq to "
                  "%.3f (ratio %.2f to %.2f), smallest film to %.3f of the "
                  "smooth one\n",
                  (int)seed, count, slide, maximum->Rq, maximum->low,
                  maximum->high, maximum->H_min);
}

/* The number of errors of Rq (0) or H_min (1) below a bound. */
static int below(const errors *all, int which, double bound)
{
    int count = 0;
    for (int k = 0; k < all->count; k++)
        count += all->each[k][which] < bound;
    return count;
}

/* The errors stated: half of them within 2 %, all within 12 %. */
TEST(rolling)
{
    errors maximum;
    survey(101, 20, 0, &maximum);
    assert_true(below(&maximum, 0, 0.02) >= 10);
    assert_true(below(&maximum, 1, 0.02) >= 10);
    assert_true(maximum.Rq < 0.12);
    assert_true(maximum.H_min < 0.12);
}

/* The errors of sliding surfaces stated in overroll(1). With the linear theory
 * of sliding waves Rq was 0.906 to 1.269 times the prediction. The minimum film
 * thickness was 0.091 of the smooth one thicker to 0.028 thinner. */
TEST(sliding)
{
    static const double slide[] = {-1, -0.5, 0.5, 1};
    for (int k = 0; k < 4; k++) {
        errors maximum;
        survey(201, 5, slide[k], &maximum);
        assert_true(maximum.low > 0.9 && maximum.high < 1.3);
        assert_true(maximum.thinner < 0.03 && maximum.thicker < 0.1);
    }
}
