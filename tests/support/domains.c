/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "domains.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/run.h"
#include "test.h"

enum { STEPS = 60, MAX = 2 * (STEPS + 1), CAPACITY = 4000 };

typedef struct text {
    uint64_t state;
    int length;
    char all[CAPACITY];
} text;

__attribute__((format(printf, 2, 3))) static void add(text *t,
                                                      const char *words, ...)
{
    va_list values;
    va_start(values, words);
    t->length += vsnprintf(t->all + t->length, CAPACITY - (size_t)t->length,
                           words, values);
    va_end(values);
    assert_true(t->length < CAPACITY);
}

static double between(text *t, double low, double high)
{
    return low * pow(high / low, test_random(&t->state, 0, 1));
}

typedef struct way {
    const char *section;
    double range;   /* values are from 1/range to range */
    double slowest; /* minimum time between two values, b/um */
} way;

static void add_table(text *t, const way *w, const char *folder)
{
    const char *path = test_path(folder, w->section);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    for (int k = 0; k < 6; k++)
        fprintf(out, "%g %.6g\n", w->slowest * k,
                between(t, 1 / w->range, w->range));
    fclose(out);
    add(t, "history = table\nfile = %s\n", path);
}

/* Adds a random history of load, speed or radius; `must`: not constant. */
static void add_history(text *t, way w, bool must, const char *folder)
{
    int kind = (int)test_random(&t->state, must ? 1 : 0, 4);
    double from = between(t, 1 / w.range, w.range);
    double to = between(t, 1 / w.range, w.range);
    if (kind == 0)
        return;
    add(t, "[%s]\n", w.section);
    if (kind == 1)
        add(t,
            "history = sine\namplitude = %.6g\nperiod = %.6g\n"
            "start = %.6g\n",
            fmin(1 - 1 / w.range, fabs(from - 1)),
            test_random(&t->state, 3 * w.slowest, 5 + 3 * w.slowest),
            test_random(&t->state, -3, 0));
    else if (kind == 2)
        add_table(t, &w, folder);
    else
        add(t,
            "history = ramp\nfrom = %.6g\nto = %.6g\nstart = %.6g\n"
            "duration = %.6g\n",
            from, to, test_random(&t->state, 0.1, 1.5),
            test_random(&t->state, w.slowest, w.slowest + 2));
}

static void draw(text *t, uint64_t seed, bool jumps, const char *folder)
{
    t->state = seed;
    t->length = 0;
    double M = between(t, 5, 200), L = test_random(&t->state, 0, 14);
    bool passes = !jumps && test_random(&t->state, 0, 1) < 0.25;
    add(t, "[contact]\nM = %.6g\nL = %.6g\n[time]\nend = %g\nstep = 0.05\n", M,
        L, 0.05 * STEPS);
    if (passes) {
        double first = between(t, 1 / sqrt(5), sqrt(5));
        double second = between(t, 1 / sqrt(5), sqrt(5));
        add(t,
            "[cavitation]\nmodel = conserving\n[passes]\nnumber = 2\n"
            "replenish = 500\nloads = %.6g, %.6g\n",
            first, second);
    } else if (jumps) {
        double from = between(t, 1 / sqrt(5), sqrt(5));
        double to = between(t, 1 / sqrt(5), sqrt(5));
        add(t,
            "[load]\nhistory = step\nfrom = %.6g\nto = %.6g\n"
            "start = %.6g\n",
            from, to, test_random(&t->state, 0.1, 1.5));
    } else {
        add_history(t, (way){"load", sqrt(5), 0.6}, true, folder);
    }
    add_history(t, (way){"speed", 3, 0.6}, false, folder);
    if (!passes && !jumps) /* passes use mass-conserving cavitation, which needs
                              short steps if the radius varies at T = 0 */
        add_history(t, (way){"radius", 1.4, 3}, false, folder);
}

typedef struct seen {
    int count;
    long halved;
    bool other_mean; /* the start was solved with the mean of faces = gap */
    double T[MAX], H_cen[MAX], P_max[MAX];
} seen;

static ovr_status observe(void *data, const ovr_simulation *sim, ovr_error *err)
{
    seen *s = data;
    const ovr_observation *o = ovr_simulation_observation(sim);
    (void)err;
    assert_true(s->count < MAX);
    s->T[s->count] = ovr_simulation_state(sim)->T;
    s->H_cen[s->count] = o->H_cen;
    s->P_max[s->count++] = o->P_max;
    s->halved = ovr_simulation_statistics(sim)->substeps;
    return OVR_OK;
}

static void listen(void *data, ovr_message_kind kind, const char *words)
{
    seen *s = data;
    (void)kind;
    s->other_mean = s->other_mean || strstr(words, "domain.faces = gap");
}

typedef struct domain {
    double inlet, outlet, mesh;
    int level;
    bool convected;
} domain;

/* Solves a case (go) or only determines its domain and grid. */
static bool solve(const char *words, seen *s, domain *d, const char *folder,
                  bool go, ovr_error *err)
{
    ovr_run_options how = {0};
    ovr_case *c = ovr_case_read_text(words, "case", NULL, NULL, err);
    how.data = s;
    how.observe = observe;
    how.say = listen;
    how.output = test_path(folder, "out.h5");
    how.force = true;
    ovr_run *run = c ? ovr_run_create(c, &how, NULL, err) : NULL;
    if (run) {
        const ovr_setup *setup = ovr_run_get_info(run)->setup;
        *d = (domain){setup->options->inlet, setup->options->outlet,
                      setup->mesh, setup->options->level, setup->convected};
    }
    s->count = 0;
    s->halved = 0;
    s->other_mean = false;
    bool done = run && (!go || !ovr_run_execute(run, err));
    ovr_run_free(run);
    ovr_case_free(c);
    return done;
}

static int level_of(double length)
{
    const double mesh = 0.02;
    int level = 5;
    while (length / (7 << level) > mesh)
        level++;
    return level;
}

typedef struct worst {
    double H_cen, P_max;
} worst;

static double largest(const seen *s)
{
    double maximum = 0;
    for (int k = 0; k < s->count; k++)
        maximum = fmax(maximum, s->P_max[k]);
    return maximum;
}

/* Returns the maximum differences, of H_cen relative to H_cen or, after a jump
 * of the speed that nearly breaks the film, to a fifth of the mean. */
static worst compare(const seen *a, const seen *b)
{
    worst w = {0, fabs(largest(a) / largest(b) - 1)};
    double mean = 0;
    assert_int_equal(a->count, b->count);
    for (int k = 0; k < b->count; k++)
        mean += b->H_cen[k] / b->count;
    for (int k = 0; k < a->count; k++) {
        double film = fmax(b->H_cen[k], 0.2 * mean);
        CHECK_NEAR(a->T[k], b->T[k], 1e-9);
        w.H_cen = fmax(w.H_cen, fabs(a->H_cen[k] - b->H_cen[k]) / film);
    }
    return w;
}

/* The algebraic error of the default tolerance, 7e-4 of a film thickness, is
 * larger than the effect of the domain. */
#define CLOSE "[solver]\ntolerance = 1e-7\n"

/* Runs a case on its domain and on a domain twice as wide with the same nodes.
 * Returns false if both are not comparable. Halved time steps on one domain
 * differ by up to half a film thickness after jumps. Another mean between nodes
 * at the start differs by 1.6e-2 of a film thickness at M = 220 on level 7. */
static bool try(text *t, const char *folder, worst *w)
{
    static seen near, far;
    domain d, wide;
    ovr_error err = {0};
    char words[CAPACITY + 300];
    if (!solve(t->all, &near, &d, folder, false, &err))
        return false;
    int level = level_of(d.outlet - d.inlet);
    snprintf(words, sizeof words, "%s[domain]\nlevel = %d\n" CLOSE, t->all,
             level);
    if (!solve(words, &near, &d, folder, true, &err)) {
        print_message("    %s\n", err.message);
        return false;
    }
    int before = (int)ceil(-d.inlet / d.mesh), all = 7 << (level + 1);
    double inlet = d.inlet - before * d.mesh;
    snprintf(words, sizeof words,
             "%s[domain]\nlevel = %d\ninlet = %.17g\noutlet = %.17g\n" CLOSE,
             t->all, level + 1, inlet, inlet + all * d.mesh);
    if (!solve(words, &far, &wide, folder, true, &err)) {
        print_message("    twice as wide: %s\n", err.message);
        return false;
    }
    if (d.convected && !wide.convected) {
        print_message("    curvature is not convected on the wide domain\n");
        return false;
    }
    if (near.halved || far.halved) {
        print_message("    %ld and %ld steps were halved\n", near.halved,
                      far.halved);
        return false;
    }
    if (near.other_mean != far.other_mean) {
        print_message("    the starts have different means between nodes\n");
        return false;
    }
    *w = compare(&near, &far);
    print_message("    [%.4g, %.4g], level %d: H_cen %.2g, P_max %.2g\n",
                  d.inlet, d.outlet, level, w->H_cen, w->P_max);
    return true;
}

void test_domains_survey(uint64_t seed, int runs, bool jumps)
{
    void *folder;
    worst all = {0, 0};
    int missed = 0, far = 0, again = 0;
    test_make_folder(&folder);
    for (int k = 0; k < runs; seed++) {
        static text t;
        worst w = {0, 0};
        draw(&t, seed, jumps, folder);
        print_message("  seed %llu\n", (unsigned long long)seed);
        if (!try(&t, folder, &w)) {
            again++;
            continue;
        }
        if (w.H_cen > 5e-4 || w.P_max > 2e-3) {
            print_message("%s\n", t.all);
            missed++;
        }
        far += w.H_cen > 2e-3 || w.P_max > 2e-3;
        all.H_cen = fmax(all.H_cen, w.H_cen);
        all.P_max = fmax(all.P_max, w.P_max);
        k++;
    }
    test_remove_folder(&folder);
    print_message("    %d runs (%d drawn again): H_cen %.2g, P_max %.2g at "
                  "most, %d beyond\n",
                  runs, again, all.H_cen, all.P_max, missed);
    if (jumps) {
        assert_true(all.H_cen < 2e-3 && all.P_max < 5e-3);
        assert_true(10 * missed <= runs);
        return;
    }
    assert_int_equal(far, 0);
    assert_true(50 * missed <= runs);
}
