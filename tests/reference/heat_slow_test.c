/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Thermal contacts with low Peclet numbers: temperatures compared with the full
 * solution for the same heat flux, and runs at constant conditions that remain
 * steady. */
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdlib.h>

#include "physics/heat/heated.h"
#include "support/contact.h"
#include "support/hot.h"
#include "support/test.h"

static const double PI = 3.14159265358979323846;

/* M = 12, L = 8 with solids along which heat spreads faster than in steel. */
static ovr_simulation *contact(double S, double spreads, int level)
{
    test_hot hot = test_hot_make(12, 8, S, 5e6, NULL);
    ovr_error err = {0};
    for (int k = 0; k < 2; k++) {
        hot.heat.diffusion[k] *= spreads;
        hot.heat.peclet[k] /= spreads;
    }
    ovr_simulation *sim = test_hot_simulation(&hot, level);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    return sim;
}

/* -------------------------------------------------------- the full solution */

/* int e^(Pe s/2) K0(Pe |s|/2) ds from one node to the next: near 0, where K0 is
 * -ln(x/2) - 0.5772..., with that taken out. */
static double kernel(double Pe, double from, double D)
{
    enum { PARTS = 64 };
    double sum = 0, maximum = fmax(fabs(from), fabs(from + D));
    bool near = maximum < 1.5 * D;
    for (int k = 0; k < PARTS; k++) {
        double s = from + (k + 0.5) * D / PARTS, x = fabs(Pe * s) / 2;
        sum += exp(Pe * s / 2) * gsl_sf_bessel_K0(x);
        if (near)
            sum += log(x);
    }
    sum *= D / PARTS;
    if (near) /* int ln(Pe s/2) ds from 0 to D */
        sum -= D * (log(fabs(Pe) * D / 2) - 1);
    return sum;
}

/* The largest rise of surface k by Carslaw and Jaeger's solution for the flux
 * that it takes up, a constant one about each node. */
static double full(const ovr_simulation *sim, int k)
{
    const ovr_heated *h = sim->heated;
    double D = ovr_simulation_state(sim)->D, u = h->u1 - k * h->V, maximum = 0;
    double kappa = h->numbers.diffusion[k], Pe = u / kappa;
    size_t n = sim->now.n;
    double *half = calloc(2 * n, sizeof *half); /* between half nodes */
    for (size_t m = 0; m < 2 * n; m++) {
        half[m] = kernel(Pe, ((double)m - (double)n) * D, D);
    }
    for (size_t i = 0; i < n; i++) {
        double T = 0;
        for (size_t j = 0; j < n; j++) /* half the cell on either side */
            T += h->q[k][j] * (half[n + i - j] + half[n + i - j - 1]) / 2;
        maximum = fmax(maximum, T);
    }
    free(half);
    return maximum / PI * h->numbers.solid[k] / sqrt(kappa / PI) +
           h->numbers.bulk[k];
}

TEST(as_the_full_solution)
{
    static const double spreads[] = {0.5, 2, 6, 15};
    for (int a = 0; a < 4; a++)
        for (double S = 0.5; S < 4; S += 2.5) {
            ovr_simulation *sim = contact(S, spreads[a], 7);
            const ovr_observation *o = ovr_simulation_observation(sim);
            double T[2] = {full(sim, 0), full(sim, 1)};
            print_message(
                "Pe %.2f %.2f: T_1 %+.1e, T_2 %+.1e off\n",
                sim->heated->numbers.peclet[0], sim->heated->numbers.peclet[1],
                o->T_1_max_rise / T[0] - 1, o->T_2_max_rise / T[1] - 1);
            CHECK_CLOSE(o->T_1_max_rise, T[0], 5e-4);
            CHECK_CLOSE(o->T_2_max_rise, T[1], 5e-4);
            ovr_simulation_free(sim);
        }
}

/* ------------------------------------------------------------- in time */

/* As long as both surfaces take to cross the contact and more. */
static void stays(double S, double spreads, double film, double T)
{
    ovr_simulation *sim = contact(S, spreads, 6);
    const ovr_observation *o = ovr_simulation_observation(sim), first = *o;
    double D = ovr_simulation_state(sim)->D, off[4];
    ovr_error err = {0};
    while (o->T < 6)
        CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
    off[0] = o->H_cen / first.H_cen - 1;
    off[1] = o->T_max_rise / first.T_max_rise - 1;
    off[2] = o->T_1_max_rise / first.T_1_max_rise - 1;
    off[3] = o->T_2_max_rise / first.T_2_max_rise - 1;
    print_message("S %g, Pe %.2f %.2f: H_cen %.1e, T %.1e %.1e %.1e off\n", S,
                  sim->heated->numbers.peclet[0],
                  sim->heated->numbers.peclet[1], off[0], off[1], off[2],
                  off[3]);
    CHECK_NEAR(off[0], 0, film);
    for (int k = 1; k < 4; k++)
        CHECK_NEAR(off[k], 0, T);
    ovr_simulation_free(sim);
}

TEST(constant_conditions_stay)
{
    stays(0.5, 0.5, 1e-5, 1e-3);
    stays(0.5, 1.5, 1e-5, 1e-3);
    stays(0.5, 7, 1e-5, 5e-3); /* Pe 0.4 and 0.24 */
    /* against each other: layers of the film cross up to 2.5 nodes a step, of
     * which a march makes as many: 2e-4 of the film at level 5, less on finer
     * grids, without heat along x too */
    stays(3, 1, 1e-4, 1e-3);
    stays(3, 4, 1e-4, 1e-3);
    stays(2, 1, 1e-4, 1e-2); /* surface 2 stands still */
}
