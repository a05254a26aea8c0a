/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "adaptive.h"

#include <math.h>
#include <stdio.h>

#include "overroll/case.h"
#include "overroll/simulation.h"
#include "test.h"

enum { MOST = 60000 };

typedef struct series {
    size_t n;
    double T[MOST], H[MOST];
    long cycles;
} series;

static series finest, steps_of_mesh, adaptive; /* large */

static ovr_status look(void *data, const ovr_simulation *sim, ovr_error *err)
{
    const ovr_observation *o = ovr_simulation_observation(sim);
    series *s = data;
    (void)err;
    assert_true(s->n < MOST);
    s->T[s->n] = o->T;
    s->H[s->n++] = o->H_cen;
    return OVR_OK;
}

static void run(const char *text, series *s)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    assert_non_null(setup);
    ovr_simulation *sim = ovr_setup_simulation(setup, NULL, &err);
    CHECK_OK(sim ? ovr_simulation_steady(sim, &err) : OVR_BAD_INPUT, &err);
    ovr_observer observer = {look, NULL, s};
    ovr_march march = *setup->march;
    march.count = 1;
    march.observers = &observer;
    s->n = 0;
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
    s->cycles = ovr_simulation_statistics(sim)->cycles;
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
}

/* rms in time of the relative error of H_cen, the finest series linear. */
static double error_of(const series *s)
{
    double sum = 0, length = 0;
    size_t j = 0;
    for (size_t i = 1; i < s->n; i++) {
        while (j + 2 < finest.n && finest.T[j + 1] < s->T[i])
            j++;
        double part = (s->T[i] - finest.T[j]) / (finest.T[j + 1] - finest.T[j]);
        double H = finest.H[j] + part * (finest.H[j + 1] - finest.H[j]);
        double e = s->H[i] / H - 1, dT = s->T[i] - s->T[i - 1];
        sum += dT * e * e;
        length += dT;
    }
    return sqrt(sum / length);
}

/* The case without its steps. */
static void make_case(uint64_t *state, int level, char *text, size_t room)
{
    double D = 5.5 / (7 << level), M = 10 * pow(10, test_random(state, 0, 1));
    double L = test_random(state, 4, 12);
    double width = 12 * D * pow(4, test_random(state, 0, 1));
    double slip = test_random(state, 0, 1) < 0.5 ? 0
                                                 : test_random(state, -1, 1.6);
    double depth = ovr_film_central_moes(M, L) * test_random(state, 0.1, 0.6);
    double start = -4.2 - width, end = (1.2 - start) / (1 + slip / 2) + 0.5;
    snprintf(text, room,
             "[contact]\nM = %.6g\nL = %.6g\nslide_to_roll = %.6g\n"
             "[domain]\ninlet = -4\nlevel = %d\n[feature d]\nshape = dent\n"
             "width = %.6g\ndepth = %.6g\nstart = %.6g\n"
             "[time]\nscheme = upstream2\nend = %.6g\n",
             M, L, slip, level, width, depth, start, end);
}

enum { WANTED = 3 };
static const double wanted[WANTED] = {3e-2, 1e-2, 3e-3};

/* Cycles at an error, on the line through two runs in logarithms. */
static double cycles_at(double error, const double e[WANTED],
                        const double cycles[WANTED])
{
    int k = error > e[1] ? 0 : 1;
    double slope = log(cycles[k + 1] / cycles[k]) / log(e[k + 1] / e[k]);
    return cycles[k] * pow(error / e[k], slope);
}

test_adaptive test_adaptive_cases(uint64_t seed, int cases, int level)
{
    uint64_t state = seed;
    test_adaptive all = {0};
    char plain[700], text[800];
    printf("seed %llu\n", (unsigned long long)seed);
    for (int k = 0; k < cases; k++) {
        make_case(&state, level, plain, sizeof plain);
        snprintf(text, sizeof text, "%sstep = %.15g\n", plain,
                 5.5 / (7 << level) / 8);
        run(text, &finest);
        run(plain, &steps_of_mesh);
        double of_mesh = error_of(&steps_of_mesh);
        double e[WANTED], cycles[WANTED];
        printf("  %2d: dT = D %.1e in %ld cycles;", k, of_mesh,
               steps_of_mesh.cycles);
        for (int i = 0; i < WANTED; i++) {
            snprintf(text, sizeof text, "%sstep = adaptive\nerror = %g\n",
                     plain, wanted[i]);
            run(text, &adaptive);
            e[i] = error_of(&adaptive);
            cycles[i] = (double)adaptive.cycles;
            printf(" wanted %.0e: %.1e in %.0f", wanted[i], e[i], cycles[i]);
            all.worst = fmax(all.worst, e[i] / wanted[i]);
        }
        printf("\n");
        if (e[2] < e[1] && e[1] < e[0]) {
            all.cycles += cycles_at(of_mesh, e, cycles);
            all.cycles_of_mesh += (double)steps_of_mesh.cycles;
        }
    }
    printf(
        "largest error %.2g times the wanted one; at the error of dT = D %.0f "
        "cycles instead of %.0f\n",
        all.worst, all.cycles, all.cycles_of_mesh);
    return all;
}
