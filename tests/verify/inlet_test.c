/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Inlet boundary for all contacts with known film thickness: an automatic
 * domain gives the film thickness of a domain four times as long (M >= 100:
 * twice) within 3e-4, and the loss due to an inlet at -4 is known within a
 * factor of 1.5, both converged in the grid. */
#include <math.h>
#include <stdio.h>

#include "../support/contact.h"
#include "../support/test.h"
#include "contact/film_formula.h"
#include "contact/starvation.h"
#include "overroll/contact.h"
#include "simulation/simulation.h"

static const double loads[] = {1, 2, 3, 5, 10, 20, 50, 100, 300, 1000};
static const double materials[] = {0, 1, 2.5, 5, 10, 15};
enum { LOADS = 10, MATERIALS = 6 };

/* Returns H_cen at fourth order with D of a twentieth of the length of the
 * pressure rise in the inlet, or NAN if this order was not reached. */
static double film(double M, double L, double X_a, double X_b, double *begun)
{
    ovr_error err = {0};
    ovr_options o = ovr_options_default();
    double H = ovr_film_central_moes(M, L);
    double mesh = 0.05 * pow(fmin(H, 0.5), 2. / 3);
    o.inlet = X_a;
    o.outlet = X_b;
    o.level = 1;
    if (isfinite(X_a) && X_a < 0)
        while ((X_b - X_a) / (7 << o.level) > mesh)
            o.level++;
    else
        o.level = 5;
    ovr_simulation *sim = test_simulation(M, L, &o);
    if (begun) {
        *begun = ovr_simulation_options(sim)->inlet;
        begun[1] = ovr_simulation_options(sim)->outlet;
        ovr_simulation_free(sim);
        return 0;
    }
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    H = ovr_simulation_order(sim) == 4 ? ovr_simulation_observation(sim)->H_cen
                                       : NAN;
    ovr_simulation_free(sim);
    return H;
}

TEST(automatic_domains)
{
    double worst = 0;
    int lower = 0;
    for (int i = 0; i < LOADS; i++)
        for (int j = 0; j < MATERIALS; j++) {
            double M = loads[i], L = materials[j], X[2];
            film(M, L, NAN, NAN, X);
            double far = M < 100 ? 4 * X[0] : 2 * X[0];
            double error = film(M, L, X[0], X[1], NULL) /
                               film(M, L, far, X[1] + 1, NULL) -
                           1;
            printf("M = %g, L = %g: [%.4g, %.4g] %.2g\n", M, L, X[0], X[1],
                   error);
            lower += isnan(error);
            worst = fmax(worst, fabs(error));
        }
    printf("largest %.3g, %d of %d without fourth order\n", worst, lower,
           LOADS * MATERIALS);
    assert_true(worst < 3e-4);
    assert_true(lower <= 2);
}

/* Losses below 2e-5 are not compared, because the discretization error is
 * larger. */
TEST(losses)
{
    double worst = 1;
    for (int i = 0; i < LOADS; i++)
        for (int j = 0; j < MATERIALS; j++) {
            double M = loads[i], L = materials[j], X[2];
            double told = ovr_inlet_loss(M, L, -4);
            film(M, L, NAN, NAN, X);
            if (told < 2e-5)
                continue;
            double lost = 1 - film(M, L, -4, X[1], NULL) /
                                  film(M, L, fmin(X[0], -8), X[1], NULL);
            double ratio = lost / (told - ovr_inlet_loss(M, L, fmin(X[0], -8)));
            printf("M = %g, L = %g: %.3g lost, %.3g told\n", M, L, lost, told);
            worst = fmax(worst, isnan(ratio) ? 1 : fmax(ratio, 1 / ratio));
        }
    printf("largest ratio %.3g\n", worst);
    assert_true(worst < 1.5);
}
