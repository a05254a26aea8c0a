/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/rough.h"

#include <math.h>
#include <stdio.h>

#include "contact/contact.h"
#include "contact/film_formula.h"
#include "run/run.h"
#include "support/test.h"

typedef struct surface {
    double Rq, rolloff, shortest;
    int seed;
} surface;

static ovr_case *make_case(const test_rough *r, const surface *s)
{
    char text[1000];
    ovr_error err = {0};
    snprintf(text, sizeof text,
             "[contact]\nM = %.17g\nL = %.17g\nslide_to_roll = %g\n"
             "[lubricant]\nalpha = %.17g 1/Pa\n"
             "[domain]\ninlet = -4\noutlet = 1.5\nlevel = %d\norder = 4\n"
             "[time]\nend = 14\nstep = grid\nscheme = characteristic\n"
             "[feature rough]\nshape = roughness\nRq = %.17g\nlength = 8\n"
             "hurst = %g\nrolloff = %g\nshortest = %g\nseed = %d\n"
             "start = -4.01\n",
             r->M, r->L, r->slide, r->alpha, r->level, s->Rq, r->hurst,
             s->rolloff, s->shortest, s->seed);
    return ovr_case_read_text(text, "rough.ini", NULL, NULL, &err);
}

static int predict(test_rough *r, const surface *s)
{
    ovr_case *c = make_case(r, s);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &r->err) : NULL;
    int done = setup && !ovr_setup_prepare(setup, NULL, &r->err) &&
               !ovr_setup_rough_film(setup, NULL, &r->predicted, &r->err);
    if (done)
        r->smooth = ovr_film_fitted(r->M, r->L,
                                    ovr_density(setup->lubricant, 1))
                        .minimum;
    ovr_setup_free(setup);
    ovr_case_free(c);
    return done;
}

static void run(test_rough *r, const surface *s)
{
    ovr_case *c = make_case(r, s);
    ovr_run_options how = {0};
    ovr_run *run = c ? ovr_run_create(c, &how, NULL, &r->err) : NULL;
    r->status = run ? ovr_run_execute(run, &r->err) : OVR_BAD_INPUT;
    if (!r->status) {
        const ovr_statistics *total = ovr_simulation_statistics(
            ovr_run_get_info(run)->sim);
        r->film_Rq = total->extreme.film_Rq;
        r->H_min = total->extreme.H_min_located;
    }
    ovr_run_free(run);
    ovr_case_free(c);
}

test_rough test_rough_run(uint64_t seed, double slide, int level)
{
    uint64_t state = seed;
    test_rough r = {.slide = slide, .status = OVR_BAD_INPUT};
    surface s = {.Rq = 0.001, .seed = (int)seed};
    double share;
    do {
        r.M = 20 * pow(10, test_random(&state, 0, 1));
        r.L = 4 * pow(3.5, test_random(&state, 0, 1));
        r.alpha = test_random(&state, 15, 25) * 1e-9;
    } while (r.L * sqrt(r.M / 6.283185307179586) / r.alpha > 4e9);
    r.hurst = test_random(&state, 0.5, 1);
    s.rolloff = 0.5 * pow(8, test_random(&state, 0, 1));
    s.shortest = fmax(0.15, s.rolloff / 8);
    share = test_random(&state, 0.05, 0.5);
    r.level = level + (r.M > 100);
    if (!predict(&r, &s))
        return r;
    s.Rq *= share * r.smooth / (r.smooth - r.predicted.H_min);
    if (predict(&r, &s))
        run(&r, &s);
    return r;
}
