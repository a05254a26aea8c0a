/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fitted film thickness formulas compared with solutions: a tenth of the survey
 * to which they were fitted (tests/verify/film_fit_test.c), within the errors
 * printed by check. */
#include <math.h>

#include "contact/film_formula.h"
#include "overroll/contact.h"
#include "support/films.h"
#include "support/test.h"

enum { COUNT = 26 };

TEST(fitted_films_are_the_solved_ones)
{
    test_film film[COUNT];
    size_t n = test_films(COUNT, 9, film);
    double central = 0, minimum = 0;
    assert_true(n >= COUNT - 1);
    for (size_t k = 0; k < n; k++) {
        test_film *f = &film[k];
        ovr_film_fit fit = ovr_film_fitted(f->M, f->L, f->density);
        central = fmax(central, fabs(fit.central / f->central - 1));
        minimum = fmax(minimum, fabs(fit.minimum / f->minimum - 1));
    }
    print_message("# %zu contacts: central %.2f %%, minimum %.2f %%\n", n,
                  100 * central, 100 * minimum);
    assert_true(central < 0.026 && minimum < 0.017);
}

TEST(none_is_given_outside_of_the_survey)
{
    assert_true(isnan(ovr_film_fitted(1.9, 5, 1.2).central));
    assert_true(isnan(ovr_film_fitted(20, 0, 1).minimum));
    assert_true(isnan(ovr_film_fitted(20, 26, 1).minimum));
}
