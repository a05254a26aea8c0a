/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "thinning.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "overroll/case.h"
#include "overroll/simulation.h"
#include "test.h"

typedef struct draft {
    uint64_t state;
    char text[4000];
    int length;
} draft;

static double draw(draft *d, double low, double high)
{
    return test_random(&d->state, low, high);
}

static bool chance(draft *d, double share)
{
    return draw(d, 0, 1) < share;
}

__attribute__((format(printf, 2, 3))) static void say(draft *d,
                                                      const char *words, ...)
{
    va_list values;
    va_start(values, words);
    d->length += vsnprintf(d->text + d->length,
                           sizeof d->text - (size_t)d->length, words, values);
    va_end(values);
    assert_true((size_t)d->length < sizeof d->text);
}

/* rate, stress of a law with a knee at 5 MPa and a plateau that rises slowly */
static void write_points(const char *path)
{
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fprintf(out, "rate [1/s], stress [MPa]\n");
    for (int k = 0; k < 40; k++) {
        double y = exp(-4 + 0.4 * k);
        fprintf(out, "%.9g, %.9g\n", 1e5 * y,
                5 * y * pow(1 + pow(y, 1.5), -0.6 / 1.5));
    }
    fclose(out);
}

static void lubricant(draft *d)
{
    double stress = exp(draw(d, log(2), log(15))), n = draw(d, 0.3, 0.8);
    int law = (int)draw(d, 0, 4);
    say(d, "[lubricant]\nalpha = 17 1/GPa\np0 = 198 MPa\nz = 0.68\n");
    if (law == 0)
        say(d, "rheology = eyring\neyring_stress = %.6g MPa\n", stress);
    else if (law == 3)
        say(d, "rheology = table\nrheology_file = thinning.csv\n");
    else
        say(d,
            "rheology = carreau\ncarreau_form = %s\ncarreau_n = %.6g\n"
            "carreau_stress = %.6g MPa\n",
            law == 1 ? "rate" : "stress", n, stress);
}

static void feature(draft *d, int surface, double H, double D)
{
    static const char *const shapes[] = {"dent", "bump", "ridge"};
    int shape = (int)draw(d, 0, 3);
    say(d,
        "[feature d%d]\nsurface = %d\nshape = %s\n%s = %.6g\nwidth = %.6g\n"
        "arrival = %.6g\n",
        surface, surface, shapes[shape], shape ? "height" : "depth",
        H * draw(d, 0.05, 0.35), fmax(12 * D, draw(d, 0.2, 1)),
        draw(d, 0.5, 4));
}

static void roughness(draft *d, int surface, double H, double D)
{
    say(d,
        "[feature r%d]\nsurface = %d\nshape = roughness\nRq = %.6g\n"
        "rolloff = %.6g\nshortest = %.6g\nlength = %.6g\nseed = %d\n"
        "start = %.6g\n",
        surface, surface, H * draw(d, 0.01, 0.06), draw(d, 0.4, 1.2), 12 * D,
        draw(d, 2, 5), (int)draw(d, 1, 1e6), draw(d, -4, -1));
}

/* [load], [speed] or [sliding] about `mean`: ramp, sine or step. */
static void history(draft *d, const char *section, double least, double most,
                    double swing)
{
    int kind = (int)draw(d, 0, 3);
    say(d, "[%s]\n", section);
    if (kind == 0)
        say(d, "history = sine\namplitude = %.6g\nperiod = %.6g\n",
            draw(d, 0, swing), draw(d, 1, 4));
    else
        say(d, "history = %s\nto = %.6g\nstart = %.6g\n%s",
            kind == 1 ? "ramp" : "step", draw(d, least, most), draw(d, 0.2, 2),
            kind == 1 ? "duration = 1\n" : "");
}

static void make_case(draft *d, int level)
{
    double D = 5.5 / (7 << level), M = 5 * pow(40, draw(d, 0, 1));
    double L = draw(d, 2.5, 14), H = ovr_film_central_moes(M, L);
    say(d,
        "[contact]\nM = %.6g\nL = %.6g\nmodulus = 226 GPa\n"
        "slide_to_roll = %.6g\n[domain]\nlevel = %d\ninlet = -4\n"
        "outlet = 1.5\n[time]\nend = 4\n",
        M, L, draw(d, -2, 2), level);
    lubricant(d);
    for (int surface = 1; surface <= 2; surface++) {
        if (chance(d, 0.7))
            feature(d, surface, H, D);
        if (chance(d, 0.6))
            roughness(d, surface, H, D);
    }
    if (chance(d, 0.4)) /* jumps by half fail in Newtonian films too */
        history(d, "load", 0.9, 1.1, 0.3);
    if (chance(d, 0.4))
        history(d, "speed", 0.5, 2, 0.3);
    if (chance(d, 0.5))
        history(d, "sliding", -2, 2, 2);
}

static ovr_status run(const draft *d, test_thinned *found, ovr_error *err)
{
    ovr_case *c = ovr_case_read_text(d->text, "case", NULL, NULL, err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, err) : NULL;
    ovr_status status = setup ? ovr_setup_prepare(setup, NULL, err)
                              : OVR_BAD_INPUT;
    ovr_simulation *sim = status ? NULL
                                 : ovr_setup_simulation(setup, NULL, err);
    if (sim) {
        status = ovr_simulation_steady(sim, err);
        if (!status)
            status = ovr_simulation_march(sim, setup->march, err);
        const ovr_statistics *s = ovr_simulation_statistics(sim);
        *found = (test_thinned){s->steps, s->cycles, s->retries, s->substeps,
                                s->marked};
    }
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return status;
}

test_thinned test_thinning(uint64_t seed, int level)
{
    static draft d;
    ovr_error err = {0};
    test_thinned found = {0};
    d = (draft){.state = seed * 0x9e3779b97f4a7c15};
    write_points("thinning.csv");
    make_case(&d, level);
    if (run(&d, &found, &err) || found.marked)
        print_message("    seed %llu: %ld steps marked; %s\n%s\n",
                      (unsigned long long)seed, found.marked, err.message,
                      d.text);
    assert_int_equal(err.status, OVR_OK);
    return found;
}

void test_thinning_survey(uint64_t seed, int runs, int level)
{
    test_thinned all = {0};
    long marked = 0, retried = 0;
    for (int k = 0; k < runs; k++) {
        test_thinned one = test_thinning(seed + (uint64_t)k, level + k % 2);
        all.steps += one.steps;
        all.cycles += one.cycles;
        all.substeps += one.substeps;
        retried += one.retries > 0;
        marked += one.marked > 0;
    }
    print_message("    seeds %llu on: %d runs, %ld steps, %.2f cycles each; "
                  "%ld runs with steps tried again, %ld steps halved, %ld runs "
                  "with marked steps\n",
                  (unsigned long long)seed, runs, all.steps,
                  (double)all.cycles / (double)all.steps, retried, all.substeps,
                  marked);
    assert_true(50 * marked <= runs);
}
