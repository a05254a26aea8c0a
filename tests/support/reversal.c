/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reversal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/film_formula.h"
#include "newton.h"
#include "simulation/simulation.h"
#include "test.h"

typedef struct run {
    const test_reversal *of;
    ovr_history *speed, *sliding;
    ovr_simulation *sim;
    const ovr_state *state;
    const ovr_observation *seen;
    test_feature features[3];
    size_t count;
} run;

/* Makes a sine that starts long before T = 0, with any phase at T = 0. */
static ovr_history *make_speed(const test_reversal *r)
{
    ovr_history_form f = ovr_history_form_default();
    ovr_error err = {0};
    f.kind = OVR_HISTORY_SINE;
    f.mean = r->mean;
    f.amplitude = r->swing;
    f.period = r->period;
    f.start = -(100 + 0.25 + r->phase / (4 * acos(0))) * r->period;
    ovr_history *made = ovr_history_create(&f, NULL, &err);
    CHECK_OK(err.status, &err);
    return made;
}

/* Computes the heights of features that are convected by the mean speed. */
static void heights(void *data, double T, size_t n, const double *X, double *S)
{
    const run *r = data;
    double part[n ? n : 1];
    memset(S, 0, n * sizeof *S);
    for (size_t k = 0; k < r->count; k++) {
        test_feature f = r->features[k];
        f.start += f.u * ovr_history_integral(r->speed, T);
        f.u = 0;
        test_feature_heights(&f, T, n, X, part);
        for (size_t i = 0; i < n; i++)
            S[i] += part[i];
    }
}

static ovr_history *constant(double value)
{
    ovr_history_form f = ovr_history_form_default();
    f.kind = OVR_HISTORY_STEP;
    f.from = f.to = value;
    return ovr_history_create(&f, NULL, NULL);
}

static ovr_simulation *make(run *r, ovr_error *err)
{
    test_contact c = test_contact_make(r->of->M, r->of->L);
    ovr_options o = test_options();
    o.outlet = 4;
    o.level = r->of->level;
    o.scheme = r->of->scheme;
    if (r->of->order)
        o.order = r->of->order;
    o.tolerance = r->of->tolerance;
    if (r->of->eyring > 0) {
        c.lubricant.rheology = OVR_EYRING;
        c.lubricant.Sigma0 = r->of->eyring;
    }
    r->sim = ovr_simulation_create(&c.contact, &c.lubricant, &o, NULL, err);
    assert_non_null(r->sim);
    r->state = ovr_simulation_state(r->sim);
    r->seen = ovr_simulation_observation(r->sim);
    ovr_simulation_histories(r->sim, NULL, r->speed);
    ovr_simulation_sliding(r->sim, r->sliding);
    if (r->count) {
        ovr_simulation_surface(r->sim, heights, r);
        ovr_simulation_moving(r->sim, r->features[0].u);
    }
    ovr_simulation_steady(r->sim, err);
    return r->sim;
}

static run begin(const test_reversal *of)
{
    run r = {.of = of, .speed = make_speed(of)};
    if (of->feature.kind)
        r.features[r.count++] = of->feature;
    if (of->slide != 0)
        r.sliding = constant(of->slide);
    return r;
}

static void end(run *r)
{
    ovr_simulation_free(r->sim);
    ovr_history_free(r->speed);
    ovr_history_free(r->sliding);
}

static double step_of(const run *r)
{
    double meshes = r->of->steps_of_mesh > 0 ? r->of->steps_of_mesh : 1;
    return meshes * r->state->D;
}

static bool runs(const run *r)
{
    return r->state->T < r->of->end - 1e-6 * r->state->D;
}

static void step(run *r)
{
    ovr_error err = {0};
    CHECK_OK(ovr_simulation_step(r->sim, step_of(r), &err), &err);
    CHECK_OK(r->seen->marked, &err);
}

static double speed_at(const run *r, double T)
{
    return ovr_history_value(r->speed, T);
}

static void compare(test_apart *a, size_t n, const double *P,
                    const double *other, bool mirrored)
{
    for (size_t i = 0; i < n; i++)
        a->P = fmax(a->P, fabs(P[i] - other[mirrored ? n - 1 - i : i]));
}

/* ------------------------------------------------------- the dense Newton */

/* Sets operator, surface and time derivative for a step of dT to T; dT = 0:
 * steady. */
static void set_dense(run *r, dense *d, double T, double dT, double *q[2])
{
    double Cu = speed_at(r, T), c[3] = {1, -1, 0};
    bool second = r->of->scheme == OVR_UPSTREAM2;
    const double w[2][3] = {{1, -1, 0}, {1.5, -2, 0.5}};
    d->backward = Cu < 0;
    for (int k = 0; k < 3; k++)
        d->w[k] = fabs(Cu) * w[second][k];
    d->first[0] = fabs(Cu);
    d->first[1] = -fabs(Cu);
    if (r->count)
        heights(r, T, d->n, d->X, d->H);
    else
        memset(d->H, 0, d->n * sizeof *d->H);
    dense_surface(d, d->H);
    if (second) {
        c[0] = 1.5;
        c[1] = -2;
        c[2] = 0.5;
    }
    d->cT = dT > 0 ? c[0] / dT : 0;
    for (size_t i = 0; dT > 0 && i < d->n; i++)
        d->F[i] = (c[1] * q[0][i] + c[2] * q[1][i]) / dT;
}

test_apart test_reversal_against_dense(const test_reversal *of)
{
    run r = begin(of);
    ovr_error err = {0};
    test_apart apart = {0};
    make(&r, &err);
    CHECK_OK(err.status, &err);
    size_t n = r.state->n;
    dense *d = dense_make(of->M, of->L, of->level, of->scheme);
    double *q[2] = {calloc(n, sizeof(double)), calloc(n, sizeof(double))};
    assert_true(q[0] && q[1]);
    dense_outlet(d, 4);
    d->primal_dual = true;
    set_dense(&r, d, 0, 0, q);
    dense_solve(d);
    compare(&apart, n, r.state->P, d->P, false);
    memcpy(q[0], d->q, n * sizeof(double));
    while (runs(&r)) {
        double *oldest = q[1], dT = step_of(&r), T = r.state->T + dT;
        bool first = r.state->step == 0;
        memcpy(oldest, first ? q[0] : oldest, n * sizeof(double));
        set_dense(&r, d, T, dT, q);
        dense_solve(d);
        q[1] = q[0];
        q[0] = memcpy(oldest, d->q, n * sizeof(double));
        apart.reversals += speed_at(&r, T) * speed_at(&r, T - dT) < 0;
        step(&r);
        compare(&apart, n, r.state->P, d->P, false);
        apart.H = fmax(apart.H, fabs(r.state->H[n / 2] / d->H[n / 2] - 1));
    }
    dense_free(d);
    free(q[0]);
    free(q[1]);
    end(&r);
    return apart;
}

/* -------------------------------------------------------- the mirror image */

test_apart test_reversal_against_mirror(const test_reversal *of)
{
    test_reversal other = *of;
    other.mean = -of->mean;
    other.swing = -of->swing;
    other.slide = -of->slide;
    other.feature.start = -of->feature.start;
    run a = begin(of), b = begin(&other);
    ovr_error err = {0};
    test_apart apart = {0};
    make(&a, &err);
    make(&b, &err);
    CHECK_OK(err.status, &err);
    while (runs(&a)) {
        double Cu = speed_at(&a, a.state->T);
        step(&a);
        step(&b);
        apart.reversals += Cu * speed_at(&a, a.state->T) < 0;
        compare(&apart, a.state->n, a.state->P, b.state->P, true);
        apart.H = fmax(apart.H, fabs(a.seen->H_min / b.seen->H_min - 1));
        apart.H = fmax(apart.H, fabs(a.seen->H_cen / b.seen->H_cen - 1));
        CHECK_NEAR(a.seen->X_min, -b.seen->X_min, 1e-9);
        CHECK_NEAR(a.seen->X_cavitation, -b.seen->X_cavitation, 1e-9);
        CHECK_NEAR(a.seen->mass_flow, -b.seen->mass_flow, 1e-9);
        CHECK_NEAR(a.seen->F_roll, -b.seen->F_roll, 1e-9);
        CHECK_NEAR(a.seen->F_slide, -b.seen->F_slide, 1e-9);
        CHECK_NEAR(a.seen->power_in, b.seen->power_in, 1e-9);
        CHECK_NEAR(a.seen->power_dissipated, b.seen->power_dissipated, 1e-9);
        CHECK_NEAR(a.seen->mass_balance, b.seen->mass_balance, 1e-6);
        assert_int_equal(isnan(a.seen->X_spike), isnan(b.seen->X_spike));
        if (!isnan(a.seen->X_spike))
            CHECK_NEAR(a.seen->X_spike, -b.seen->X_spike, 1e-9);
    }
    end(&a);
    end(&b);
    return apart;
}

double test_reversal_film(const test_reversal *of)
{
    run r = begin(of);
    ovr_error err = {0};
    make(&r, &err);
    CHECK_OK(err.status, &err);
    while (runs(&r))
        step(&r);
    double H = r.seen->H_min_located;
    end(&r);
    return H;
}

/* --------------------------------------------------------------- random runs
 */

static test_reversal draw(uint64_t *seed, double longest)
{
    test_reversal r = {.M = 5 * pow(40, test_random(seed, 0, 1)),
                       .L = test_random(seed, 2.5, 14),
                       .mean = test_random(seed, -0.6, 0.6),
                       .swing = 1,
                       .period = test_random(seed, 2, longest),
                       .phase = test_random(seed, 0, 4 * acos(0)),
                       .scheme = (ovr_scheme)(int)test_random(seed, 0, 3)};
    r.end = 1.25 * r.period;
    r.level = r.M > 100 ? 9 : 8;
    return r;
}

static void draw_features(uint64_t *seed, run *r)
{
    double film = ovr_film_central_moes(r->of->M, r->of->L);
    double slip = test_random(seed, -1, 1);
    if (test_random(seed, 0, 1) < 0.5)
        return;
    r->count = 1 + (size_t)test_random(seed, 0, 3);
    for (size_t k = 0; k < r->count; k++) {
        bool dent = test_random(seed, 0, 1) < 0.5;
        double by = dent ? -test_random(seed, 0, 1.5)
                         : test_random(seed, 0, 0.4);
        r->features[k] = (test_feature){
            'l',
            by * film,
            test_random(seed, 0.2, 1),
            test_random(seed, -3, 3),
            1 + (test_random(seed, 0, 1) < 0.5 ? slip : -slip) / 2,
            0};
    }
}

static void print_step(const run *r, const char *what)
{
    const test_reversal *of = r->of;
    print_message("    %s, M %.5g L %.4g, Cu = %.3f + cos, period %.3f, level "
                  "%d, %zu features, after T = %.4f, Cu %.4f: %s\n",
                  ovr_scheme_name(of->scheme), of->M, of->L, of->mean,
                  of->period, of->level, r->count, r->state->T,
                  speed_at(r, r->state->T), what);
}

static void march(run *r, test_reversals *all)
{
    const ovr_statistics *s = ovr_simulation_statistics(r->sim);
    ovr_error err = {0};
    long begun = s->cycles;
    bool failed = false;
    while (runs(r) && !failed) {
        double Cu = speed_at(r, r->state->T);
        failed = ovr_simulation_step(r->sim, step_of(r), &err) != OVR_OK;
        if (failed || r->seen->marked)
            print_step(r, failed ? err.message : "marked");
        all->reversals += Cu * speed_at(r, r->state->T) < 0;
        all->load = fmax(all->load, fabs(r->seen->load_error));
    }
    all->failed += failed;
    all->steps += s->steps;
    all->cycles += s->cycles - begun;
    all->retries += s->retries;
    all->marked += s->marked;
}

test_reversals test_reversals_run(uint64_t seed, long count, double longest)
{
    test_reversals all = {0};
    long again = 0;
    print_message("    seed %llu\n", (unsigned long long)seed);
    while (all.runs < count) {
        test_reversal of = draw(&seed, longest);
        ovr_error err = {0};
        run r = begin(&of);
        draw_features(&seed, &r);
        make(&r, &err);
        again += err.status != OVR_OK;
        if (!err.status) {
            all.runs++;
            march(&r, &all);
        }
        end(&r);
    }
    print_message("    %ld runs (%ld drawn again), %ld steps, %ld reversals, "
                  "%.2f cycles per step, %ld retries, %ld flagged, %ld failed, "
                  "load error at most %.1e\n",
                  all.runs, again, all.steps, all.reversals,
                  (double)all.cycles / (double)all.steps, all.retries,
                  all.marked, all.failed, all.load);
    return all;
}
