/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "histories.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/film_formula.h"
#include "newton.h"
#include "simulation/simulation.h"
#include "test.h"

typedef struct run {
    double M, L, outlet, steps_of_mesh;
    int level;
    bool dented;
    test_feature dent;
    ovr_history *load, *speed;
} run;

static ovr_history *draw_history(uint64_t *seed)
{
    ovr_history_form f = ovr_history_form_default();
    ovr_error err = {0};
    int kind = (int)test_random(seed, 0, 4);
    double by = test_random(seed, -0.5, 0.5);
    double start = test_random(seed, 0.05, 0.5);
    if (kind == 1) {
        f.kind = OVR_HISTORY_SINE;
        f.amplitude = by;
        f.period = test_random(seed, 1, 3);
    } else if (kind > 1) {
        f.kind = kind == 2 ? OVR_HISTORY_STEP : OVR_HISTORY_RAMP;
        f.from = 1;
        f.to = 1 + by;
        f.start = start;
        if (kind == 3)
            f.duration = test_random(seed, 0.05, 0.5);
    }
    ovr_history *made = ovr_history_create(&f, NULL, &err);
    CHECK_OK(err.status, &err);
    return made;
}

static run draw(uint64_t *seed)
{
    run r = {.M = 5 * pow(200, test_random(seed, 0, 1)),
             .L = test_random(seed, 2, 14),
             .outlet = test_random(seed, 1.5, 3),
             .steps_of_mesh = 0.5 * pow(8, test_random(seed, 0, 1)),
             .level = test_random(seed, 0, 1) < 0.5 ? 7 : 8,
             .dented = test_random(seed, 0, 3) < 1};
    double film = ovr_film_central_moes(r.M, r.L);
    double u = test_random(seed, 0.2, 1.8);
    r.dent = (test_feature){'l',
                            -film * test_random(seed, 0.1, 1),
                            test_random(seed, 0.15, 0.6),
                            test_random(seed, -1.8, -1),
                            u,
                            0};
    r.load = draw_history(seed);
    r.speed = draw_history(seed);
    return r;
}

static ovr_simulation *begin(run *r, ovr_error *err)
{
    ovr_options o = test_options();
    o.level = r->level;
    o.outlet = r->outlet;
    ovr_simulation *sim = test_simulation(r->M, r->L, &o);
    ovr_simulation_histories(sim, r->load, r->speed);
    if (r->dented) {
        ovr_simulation_surface(sim, test_feature_heights, &r->dent);
        ovr_simulation_moving(sim, r->dent.u);
    }
    ovr_simulation_steady(sim, err);
    return sim;
}

/* State before a step: pressure, and q of the two previous times. */
typedef struct past {
    double *P, *q[2], H0, T, dT;
} past;

static past make_past(size_t n)
{
    double *all = calloc(3 * n, sizeof *all);
    assert_non_null(all);
    return (past){.P = all, .q = {all + n, all + 2 * n}};
}

static void keep(past *p, const ovr_state *s, double dT)
{
    size_t bytes = s->n * sizeof(double);
    memcpy(p->q[1], dT > 0 ? p->q[0] : s->q, bytes);
    memcpy(p->q[0], s->q, bytes);
    memcpy(p->P, s->P, bytes);
    p->H0 = s->H0;
    p->T = s->T;
    p->dT = dT;
}

/* Solves a step of dT from that state by the dense Newton method. Returns true
 * if it converges to a positive film thickness. */
static bool dense_step(const run *r, const past *p, double dT)
{
    dense *d = dense_make(r->M, r->L, r->level, OVR_UPSTREAM2);
    double T = p->T + dT, Cu = ovr_history_value(r->speed, T);
    test_feature dent = r->dent;
    dense_outlet(d, r->outlet);
    if (r->dented) {
        test_feature_heights(&dent, T, d->n, d->X, d->H);
        dense_surface(d, d->H);
    }
    for (int k = 0; k < 3; k++)
        d->w[k] *= Cu;
    for (int k = 0; k < 2; k++)
        d->first[k] *= Cu;
    d->cT = 1.5 / dT;
    d->force *= ovr_history_value(r->load, T);
    for (size_t i = 0; i < d->n; i++) {
        d->F[i] = (-2 * p->q[0][i] + 0.5 * p->q[1][i]) / dT;
        d->P[i] = p->P[i];
    }
    d->H0 = p->H0;
    bool solved = dense_converges(d, 60);
    for (size_t i = 0; i < d->n; i++)
        solved = solved && d->H[i] > 0;
    dense_free(d);
    return solved;
}

static void print_end(const run *r, const past *p, const char *what,
                      bool missed)
{
    print_message("    M %.5g L %.4g outlet %.3f level %d dT %.3g D%s, after T "
                  "= %.4f: %s%s\n",
                  r->M, r->L, r->outlet, r->level, r->steps_of_mesh,
                  r->dented ? ", dent" : "", p->T, what,
                  missed ? " (the dense Newton method converges)" : "");
}

/* Marches to the end, or to a step that fails or is flagged. */
static void march(const run *r, ovr_simulation *sim, bool check,
                  test_histories *all)
{
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    double dT = r->steps_of_mesh * s->D;
    ovr_error err = {0};
    past p = make_past(s->n);
    bool stopped = false;
    keep(&p, s, 0);
    while (s->T < 1.2 && !stopped) {
        stopped = ovr_simulation_step(sim, dT, &err) || o->marked;
        if (stopped)
            continue;
        all->maximum = o->cycles > all->maximum ? o->cycles : all->maximum;
        keep(&p, s, dT);
    }
    if (stopped) {
        bool missed = check && dense_step(r, &p, dT);
        all->refused++;
        all->touching += strstr(err.message, "touch") != NULL;
        all->missed += missed;
        print_end(r, &p, err.status ? err.message : "marked", missed);
    }
    free(p.P);
}

static void add(test_histories *all, ovr_statistics start, ovr_statistics end)
{
    all->runs++;
    all->steps += end.steps;
    all->cycles += end.cycles - start.cycles;
    all->retries += end.retries;
    all->substeps += end.substeps;
    all->marked += end.marked;
}

test_histories test_histories_run(uint64_t seed, long runs, bool check)
{
    test_histories all = {0};
    long again = 0;
    print_message("    seed %llu\n", (unsigned long long)seed);
    while (all.runs < runs) {
        ovr_error err = {0};
        run r = draw(&seed);
        ovr_simulation *sim = begin(&r, &err);
        ovr_statistics start = *ovr_simulation_statistics(sim);
        again += err.status != OVR_OK;
        if (!err.status) {
            march(&r, sim, check, &all);
            add(&all, start, *ovr_simulation_statistics(sim));
        }
        ovr_simulation_free(sim);
        ovr_history_free(r.load);
        ovr_history_free(r.speed);
    }
    print_message("    %ld runs (%ld drawn again), %ld steps, %.2f cycles per "
                  "step (at most %ld), %ld retries, %ld halved, %ld failed or "
                  "flagged (%ld in contact), of which %ld have a solution\n",
                  all.runs, again, all.steps,
                  (double)all.cycles / (double)all.steps, all.maximum,
                  all.retries, all.substeps, all.refused, all.touching,
                  all.missed);
    return all;
}
