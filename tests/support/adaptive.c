/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "adaptive.h"

#include <math.h>
#include <stdio.h>

#include "contact/film_formula.h"
#include "overroll/contact.h"
#include "series.h"
#include "test.h"

static test_series finest, steps_of_mesh, adaptive; /* large */

/* Draws a case without time.step. */
static void make_case(uint64_t *state, int level, const char *scheme,
                      char *text, size_t capacity)
{
    double D = 5.5 / (7 << level), M = 10 * pow(10, test_random(state, 0, 1));
    double L = test_random(state, 4, 12);
    double width = 12 * D * pow(4, test_random(state, 0, 1));
    double slip = test_random(state, 0, 1) < 0.5 ? 0
                                                 : test_random(state, -1, 1.6);
    double depth = ovr_film_central_moes(M, L) * test_random(state, 0.1, 0.6);
    double start = -4.2 - width, end = (1.2 - start) / (1 + slip / 2) + 0.5;
    snprintf(text, capacity,
             "[contact]\nM = %.6g\nL = %.6g\nslide_to_roll = %.6g\n"
             "[domain]\ninlet = -4\nlevel = %d\n[feature d]\nshape = dent\n"
             "width = %.6g\ndepth = %.6g\nstart = %.6g\n"
             "[time]\nscheme = %s\nend = %.6g\n",
             M, L, slip, level, width, depth, start, scheme, end);
}

enum { TARGET = 3 };
static const double target[TARGET] = {3e-2, 1e-2, 3e-3};

/* Interpolates the number of cycles for an error, linearly in logarithms. */
static double cycles_at(double error, const double e[TARGET],
                        const double cycles[TARGET])
{
    int k = error > e[1] ? 0 : 1;
    double slope = log(cycles[k + 1] / cycles[k]) / log(e[k + 1] / e[k]);
    return cycles[k] * pow(error / e[k], slope);
}

test_adaptive test_adaptive_cases(uint64_t seed, int cases, int level,
                                  const char *scheme)
{
    uint64_t state = seed;
    test_adaptive all = {0};
    char plain[700], text[800];
    printf("%s, seed %llu\n", scheme, (unsigned long long)seed);
    for (int k = 0; k < cases; k++) {
        make_case(&state, level, scheme, plain, sizeof plain);
        snprintf(text, sizeof text, "%sstep = %.15g\n", plain,
                 5.5 / (7 << level) / 8);
        test_series_run(text, NULL, &finest);
        test_series_run(plain, NULL, &steps_of_mesh);
        double of_mesh = test_series_error(&steps_of_mesh, &finest);
        double e[TARGET], cycles[TARGET];
        printf("  %2d: dT = D %.1e in %ld cycles;", k, of_mesh,
               steps_of_mesh.cycles);
        for (int i = 0; i < TARGET; i++) {
            snprintf(text, sizeof text, "%sstep = adaptive\nerror = %g\n",
                     plain, target[i]);
            test_series_run(text, NULL, &adaptive);
            e[i] = test_series_error(&adaptive, &finest);
            cycles[i] = (double)adaptive.cycles;
            printf(" target %.0e: %.1e in %.0f", target[i], e[i], cycles[i]);
            all.worst = fmax(all.worst, e[i] / target[i]);
        }
        printf("\n");
        if (e[2] < e[1] && e[1] < e[0] && e[2] <= of_mesh && of_mesh <= e[0]) {
            all.compared++;
            all.cycles += cycles_at(of_mesh, e, cycles);
            all.cycles_of_mesh += (double)steps_of_mesh.cycles;
        }
    }
    printf("largest error %.2g times the target; at the error of dT = D %.0f "
           "cycles instead of %.0f in %d cases\n",
           all.worst, all.cycles, all.cycles_of_mesh, all.compared);
    return all;
}
