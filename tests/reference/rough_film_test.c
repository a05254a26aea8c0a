/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicted film thickness of rough surfaces (amplitude reduction) compared
 * with runs: a tenth of verify/rough_film_test.c, two levels coarser, whose
 * film thicknesses are within 0.03 of those of the survey. */
#include <math.h>

#include "support/rough.h"
#include "support/test.h"

TEST(films_are_predicted)
{
    static const uint64_t seeds[] = {101, 104};
    for (int k = 0; k < 2; k++) {
        test_rough r = test_rough_run(seeds[k], 0, 6);
        CHECK_OK(r.status, &r.err);
        assert_null(r.predicted.why);
        assert_null(r.predicted.but);
        CHECK_CLOSE(r.film_Rq, r.predicted.film_Rq, 0.08);
        CHECK_NEAR(r.H_min, r.predicted.H_min, 0.12 * r.smooth);
        assert_true(r.film_Rq < 0.8 * r.predicted.Rq); /* reduced amplitude */
        assert_true(r.H_min < 0.95 * r.smooth);
    }
}
