/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/ground.h"

#include <math.h>
#include <stdio.h>

#include "contact/film_formula.h"
#include "overroll/overroll.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;

typedef struct surface {
    double shortest;
    int seed;
} surface;

/* Returns the ratio of rms slope and Rq for a spectrum q^(-1 - 2h) between two
 * wavelengths. */
static double slope_of(double longest, double shortest)
{
    const double h = 0.8;
    double a = 2 * pi / longest, b = 2 * pi / shortest;
    double heights = (pow(a, -2 * h) - pow(b, -2 * h)) / (2 * h);
    double slopes = (pow(b, 2 - 2 * h) - pow(a, 2 - 2 * h)) / (2 - 2 * h);
    return sqrt(slopes / heights);
}

/* Returns the longest wavelength for this ratio, at most 300 um, by bisection.
 */
static double longest_of(double slope, double shortest)
{
    double low = 1.1 * shortest, high = 300;
    for (int k = 0; k < 60; k++) {
        double middle = sqrt(low * high);
        if (slope_of(middle, shortest) > slope)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static ovr_case *make_case(const test_ground *g, const surface s[2],
                           double speed)
{
    char text[2400], law[80] = "", layer[120] = "";
    ovr_error err = {0};
    if (g->stress > 0)
        snprintf(law, sizeof law, "rheology = eyring\neyring_stress = %g MPa\n",
                 g->stress);
    if (g->layer > 0)
        snprintf(layer, sizeof layer,
                 "[boundary]\nlaw = layer\nof = unresolved\nlayer = %g nm\n"
                 "layer_decay = %g nm\nfriction = 0.1\n",
                 g->layer, g->layer / 3);
    int used = snprintf(
        text, sizeof text,
        "[contact]\nhertz_pressure = %g GPa\nradius = 6.84 mm\n"
        "modulus = 226 GPa\nmean_speed = %.9g m/s\nslide_to_roll = %g\n"
        "[lubricant]\nviscosity = 11 mPa.s\nalpha = 16 1/GPa\n%s%s"
        "[domain]\noutlet = 2.5\nlevel = %d\n[time]\nend = %g\nscheme = "
        "characteristic\n"
        "step = grid\n%s",
        g->ph, speed, g->slide, law,
        g->hot ? "[heat]\nmodel = lobatto\ntemperature = 60 degC\n" : "",
        g->level, g->inside ? 1e-3 : 5.5 / (1 - fabs(g->slide) / 2), layer);
    for (int k = 0; k < 2; k++)
        used += snprintf(text + used, sizeof text - (size_t)used,
                         "[feature f%d]\nsurface = %d\nshape = roughness\n"
                         "Rq = %.9g um\nlength = 12\nhurst = 0.8\n"
                         "rolloff = %.9g um\nshortest = %.9g um\nseed = %d\n"
                         "start = %s\n",
                         k + 1, k + 1, g->Rq[k], g->longest[k], s[k].shortest,
                         s[k].seed, g->inside ? "2.6" : "inlet");
    return ovr_case_read_text(text, "ground.ini", NULL, NULL, &err);
}

/* Returns the central film thickness in um at this speed by Moes' formula. */
static double film_at(test_ground *g, const surface s[2], double speed)
{
    double h = NAN;
    ovr_case *c = make_case(g, s, speed);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &g->err) : NULL;
    if (setup)
        h = 1e6 * setup->contact->height *
            ovr_film_central_moes(setup->contact->M, setup->contact->L);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return h;
}

static void run(test_ground *g, const surface s[2], double speed)
{
    ovr_case *c = make_case(g, s, speed);
    enum { SHARE = 0 };
    ovr_run_options how = {0};
    ovr_run *run = c ? ovr_run_create(c, &how, NULL, &g->err) : NULL;
    g->status = run ? ovr_run_execute(run, &g->err) : OVR_BAD_INPUT;
    if (run) {
        const ovr_simulation *sim = ovr_run_get_info(run)->sim;
        const ovr_statistics *total = ovr_simulation_statistics(sim);
        g->share = g->layer > 0 ? total->mean.more[SHARE] : 0;
        g->H_min = total->extreme.H_min_located;
        g->P_max = total->extreme.P_max;
        g->steps = (int)total->steps;
        g->cycles = (int)total->cycles;
        g->retries = (int)total->retries;
        g->marked = (int)total->marked;
        g->T = ovr_simulation_state(sim)->T;
    }
    ovr_run_free(run);
    ovr_case_free(c);
}

static test_ground go(uint64_t seed, double from, double to, int level,
                      bool inside, double layer)
{
    uint64_t state = seed;
    bool eyring = seed % 2;
    test_ground g = {.level = level,
                     .status = OVR_BAD_INPUT,
                     .hot = seed % 10 == 9,
                     .inside = inside,
                     .layer = layer,
                     .lambda = from *
                               pow(to / from, test_random(&state, 0, 1))};
    state = seed;
    surface s[2];
    double Rq, speed = 1;
    g.ph = eyring ? test_random(&state, 0.5, 1.5)
                  : test_random(&state, 0.4, 0.7);
    g.stress = eyring ? test_random(&state, 3, 8) : 0;
    g.slide = test_random(&state, -1, 1);
    for (int k = 0; k < 2; k++) {
        g.Rq[k] = 0.05 * pow(8, test_random(&state, 0, 1));
        g.slope[k] = 0.01 * pow(8, test_random(&state, 0, 1));
        s[k] = (surface){test_random(&state, 2.5, 10), (int)(2 * seed) + k};
        g.longest[k] = longest_of(g.slope[k] / g.Rq[k], s[k].shortest);
    }
    Rq = sqrt(g.Rq[0] * g.Rq[0] + g.Rq[1] * g.Rq[1]);
    for (int k = 0; k < 20; k++) /* h is proportional to about u^0.7 */
        speed *= pow(g.lambda * Rq / film_at(&g, s, speed), 1 / 0.7);
    run(&g, s, speed);
    return g;
}

test_ground test_ground_run(uint64_t seed, double from, double to, int level)
{
    return go(seed, from, to, level, false, 0);
}

test_ground test_ground_start(uint64_t seed, double from, double to, int level)
{
    return go(seed, from, to, level, true, 0);
}

test_ground test_ground_touching(uint64_t seed, double from, double to,
                                 int level, double layer)
{
    return go(2 * seed + 1, from, to, level, false, layer);
}

static void print(uint64_t seed, const test_ground *g)
{
    print_message("    seed %d lambda %.2f tau0 %.1f MPa%s ph %.2f SRR %+.2f "
                  "Rq %.2f %.2f slopes %.3f %.3f: to T %.2f, %d steps, %d "
                  "cycles, %d retries, %d marked, H_min %.1e, P %.1f, share "
                  "%.1e%s%s\n",
                  (int)seed, g->lambda, g->stress, g->hot ? ", hot" : "", g->ph,
                  g->slide, g->Rq[0], g->Rq[1], g->slope[0], g->slope[1], g->T,
                  g->steps, g->cycles, g->retries, g->marked, g->H_min,
                  g->P_max, g->share, g->status ? "\n    " : "",
                  g->status ? g->err.message : "");
}

test_ground_tally test_ground_survey(uint64_t seed, int runs, double from,
                                     double to, int level, double layer)
{
    test_ground_tally all = {0};
    long steps = 0, cycles = 0;
    for (uint64_t k = seed; k < seed + (uint64_t)runs; k++) {
        test_ground g = test_ground_touching(k, from, to, level, layer);
        double each = (double)g.cycles / fmax(g.steps, 1);
        print(k, &g);
        all.failed += g.status != OVR_OK;
        all.max_cycles = fmax(all.max_cycles, each);
        if (g.retries > all.max_retries)
            all.max_retries = g.retries;
        steps += g.steps;
        cycles += g.cycles;
    }
    all.cycles = (double)cycles / fmax((double)steps, 1);
    print_message("    seeds %d on, level %d, lambda %g to %g, a layer of %g "
                  "nm: %d of %d failed; %.2f Newton steps per time step, %.2f "
                  "in the worst run\n",
                  (int)seed, level, from, to, layer, all.failed, runs,
                  all.cycles, all.max_cycles);
    return all;
}

double test_ground_share(double amplitude, double decay, int level)
{
    enum { SHARE = 0 };
    char text[1000];
    ovr_error err = {0};
    ovr_run_options how = {0};
    snprintf(text, sizeof text,
             "[contact]\nhertz_pressure = 1 GPa\nradius = 6.84 mm\n"
             "modulus = 227 GPa\nmean_speed = 3.22 m/s\nslide_to_roll = 0.3\n"
             "viscosity = 10 mPa.s\nalpha = 20 1/GPa\n"
             "[lubricant]\nrheology = eyring\neyring_stress = 5 MPa\n"
             "[domain]\ninlet = -3\noutlet = 2\nlevel = %d\n"
             "[time]\nend = 4.6\nscheme = characteristic\nstep = grid\n"
             "[boundary]\nof = unresolved\nlaw = exponential\n"
             "amplitude = %g\ndecay = %g nm\n"
             "[feature f1]\nshape = roughness\nRq = 137 nm\nlength = 8\n"
             "shortest = 0.15\nrolloff = 1\nseed = 1\nstart = inlet\n"
             "[feature f2]\nshape = roughness\nsurface = 2\nRq = 137 nm\n"
             "length = 8\nshortest = 0.15\nrolloff = 1\nseed = 2\n"
             "start = inlet\n",
             level, amplitude, decay);
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_run *run = c ? ovr_run_create(c, &how, NULL, &err) : NULL;
    CHECK_OK(run ? OVR_OK : err.status, &err);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    double share =
        ovr_simulation_statistics(ovr_run_get_info(run)->sim)->mean.more[SHARE];
    ovr_run_free(run);
    ovr_case_free(c);
    return share;
}
