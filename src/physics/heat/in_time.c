/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transient heat (equations in in_time.h). */
#include "physics/heat/in_time.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/larger.h"
#include "contact/contact.h"
#include "multigrid/expansion.h"
#include "physics/heat/skew.h"
#include "simulation/mirror.h"

/* Viscosities are updated by this fraction of the temperature change in a step.
 */
static const double SHARE = 0.5;

/* Maximum number of further passes over the temperatures of a step; maximum
 * number of passes caused by a changed pressure only. */
enum { PASSES = 6, MOVED = 2 };

/* Number of fields stored in addition to temperatures. */
enum { FIELDS = OVR_HEAT_KEPT - OVR_CROSS_FILM_MAX };

/* --------------------------------------------------------------- creation */

ovr_status ovr_heat_steps_take(ovr_simulation *sim, ovr_error *err)
{
    ovr_heated *h = sim->heated;
    ovr_heat_steps *s = ovr_arena_take(&sim->arena, 1, sizeof *s, err);
    if (!s)
        return OVR_NO_MEMORY;
    h->steps = s;
    OVR_TAKE_NODES(sim, err, &s->F, &s->P_T, &s->heated_P);
    sim->F_before_heat = s->F;
    for (int j = 0; j < h->cross_film.n; j++)
        OVR_TAKE_NODES(sim, err, &s->T_before[j], &s->change[j]);
    for (int j = 0; j < h->cross_film.n + FIELDS; j++)
        OVR_TAKE_NODES(sim, err, &s->kept[j]);
    for (int k = 0; k < 2; k++) {
        OVR_TAKE_NODES(sim, err, &s->q_before[k]);
        ovr_heat_surface_take(sim, k, err);
    }
    return ovr_arena_status(&sim->arena);
}

/* -------------------------------------------------- last completed time */

/* The k-th array of `kept`. */
static double *kept_of(const ovr_heated *h, int k)
{
    double *const fields[] = {h->th,    h->shift, h->drag,     h->skewed,
                              h->swell, h->skew,  h->skew_by_P};
    return k < h->cross_film.n ? h->used[k] : fields[k - h->cross_film.n];
}

static void keep(const ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    for (int k = 0; k < h->cross_film.n + FIELDS; k++)
        memcpy(h->steps->kept[k], kept_of(h, k), sim->now.n * sizeof(double));
}

static void swap_trial(ovr_heated *h)
{
    ovr_heat_steps *s = h->steps;
    for (int j = 0; j < h->cross_film.n; j++)
        ovr_swap(&h->T[j], &s->T_before[j]);
    for (int k = 0; k < 2; k++)
        ovr_swap(&h->q[k], &s->q_before[k]);
    s->trying = !s->trying;
}

/* Restores temperatures and viscosities of the last completed time. */
static void withdraw(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    if (!h->steps->trying)
        return;
    swap_trial(h);
    for (int k = 0; k < h->cross_film.n + FIELDS; k++)
        memcpy(kept_of(h, k), h->steps->kept[k], sim->now.n * sizeof(double));
}

void ovr_heat_begin(ovr_simulation *sim, void *own)
{
    const ovr_heated *h = own;
    ovr_heat_steps *s = h->steps;
    s->trying = false;
    s->dT = s->stored = 0;
    s->max_balanced = h->balanced;
    memset(s->P_T, 0, sim->now.n * sizeof *s->P_T);
    for (int j = 0; j < h->cross_film.n; j++)
        memset(s->change[j], 0, sim->now.n * sizeof *s->change[j]);
    keep(sim);
}

void ovr_heat_step_back(ovr_simulation *sim, void *own)
{
    (void)own;
    withdraw(sim);
    ovr_heat_speeds(sim, sim->past.T[0]);
    ovr_heat_give(sim);
}

/* ----------------------------------------------------------------- a step */

void ovr_heat_step(ovr_simulation *sim, void *own, double dT)
{
    ovr_heated *h = own;
    ovr_heat_steps *s = h->steps;
    double D = ovr_mesh(sim), T = sim->past.T[0];
    double distance = ovr_history_integral(sim->histories.speed, T + dT) -
                      ovr_history_integral(sim->histories.speed, T);
    double slip = sim->histories.sliding
                      ? ovr_history_integral(sim->histories.sliding, T + dT) -
                            ovr_history_integral(sim->histories.sliding, T)
                      : distance *
                            (sim->contact.u1_ratio - sim->contact.u2_ratio);
    withdraw(sim);
    s->dT = dT;
    ovr_heat_speeds(sim, T + dT);
    for (int k = 0; k < 2; k++) {
        ovr_heat_surface_step(sim, k, dT,
                              (distance + (k ? -slip : slip) / 2) / D);
        ovr_heat_surface_predict(sim, k, h->q[k]);
    }
    ovr_nodes_read(sim, sim->finest, sim->finest->f.F, s->F);
}

/* Limits the change of P from its last value: by the change there and at the
 * neighbours in the previous step, plus a tolerance. */
static void hold_guess(ovr_simulation *sim)
{
    const double share = 0.05, low = 0.01 /* ph */, again = 0.7;
    const double *P1 = sim->past.P[0], *P2 = sim->past.P[1];
    double *P = sim->now.P, before = 0, here = fabs(P1[0] - P2[0]);
    size_t n = sim->now.n;
    for (size_t i = 0; sim->past.steps && i < n; i++) {
        double after = i + 1 < n ? fabs(P1[i + 1] - P2[i + 1]) : 0;
        double change = before > here ? before : here;
        change = after > change ? after : change;
        double far = share * (P1[i] + low) + again * change, d = P[i] - P1[i];
        P[i] = P1[i] + (d > far ? far : d < -far ? -far : d);
        before = here;
        here = after;
    }
}

/* Limits the film thickness to at least half of the previous one at the node or
 * its neighbours: a poor guess may have no film, which would be heated without
 * bounds. */
static void hold_film(ovr_simulation *sim)
{
    const double share = 0.5;
    const double *before = sim->past.q[0];
    ovr_solution *now = &sim->now;
    for (size_t i = 1; i + 1 < now->n; i++) {
        double minimum = share *
                         ovr_smaller(before[i],
                                     ovr_smaller(before[i - 1], before[i + 1]));
        if (!(now->P[i] > 0) || now->q[i] >= minimum)
            continue;
        now->H[i] = now->H[i] != 0 ? minimum * now->H[i] / now->q[i] : minimum;
        now->q[i] = minimum;
    }
}

/* Solves all nodes except the first node of the film, whose temperatures are
 * those of the surfaces. */
static void solve_nodes(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    size_t entry = sim->histories.backward ? sim->now.n - 1 : 0;
    sim->grids.kernels->heat_cross_film(&h->film);
    if (sim->histories.backward)
        ovr_column_heat(&h->film, 0);
    h->mean[entry] = h->q[0][entry] = h->q[1][entry] = 0;
    for (int j = 0; j < h->cross_film.n; j++)
        h->T[j][entry] = 0;
}

/* Computes temperatures with the flow at the temperatures `used`. */
static void pass(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    ovr_heat_steps *s = h->steps;
    ovr_columns *c = &h->film;
    ovr_heat_film(sim);
    c->dT = s->dT;
    c->min_u = 0;
    c->P_T = s->P_T;
    c->mean = h->mean;
    for (int j = 0; j < h->cross_film.n; j++) {
        ovr_film_departures(c->n, s->dT / ovr_mesh(sim), c->u[j],
                            s->T_before[j], h->departure[j]);
        c->departure[j] = h->departure[j];
        c->T[j] = h->T[j];
    }
    for (int k = 0; k < 2; k++) {
        c->past[k] = s->surface[k].past;
        c->into[k] = h->q[k];
        c->resistance[k] = h->numbers.solid[k] * 4 / 3 * sqrt(s->dT) *
                           (1 + s->surface[k].memory.more[0]);
    }
    solve_nodes(sim);
}

/* Maximum change of ln of the heat source between T and `used`. */
static double lag(const ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    double maximum = 0, pressed = ovr_heat_pressed(sim);
    for (int j = 0; j < h->cross_film.n; j++)
        for (size_t i = 0; i < sim->now.n; i++)
            if (sim->now.P[i] > pressed)
                maximum = ovr_larger(maximum,
                                     h->film.fall[i] *
                                         fabs(h->T[j][i] - h->used[j][i]));
    return maximum;
}

/* Computes the temperatures of the step for the present film and its rate of
 * pressure change. */
static void heat(ovr_simulation *sim)
{
    const double *P = sim->now.P, *before = sim->past.P[0];
    ovr_heat_steps *s = sim->heated->steps;
    for (size_t i = 0; i < sim->now.n; i++)
        s->P_T[i] = sim->past.steps ? (P[i] - before[i]) / s->dT : 0;
    pass(sim);
    s->lag = lag(sim);
    s->stored = ovr_heat_stored(sim);
}

/* Solves for the temperatures with the initial guess. */
static void solve(ovr_simulation *sim)
{
    hold_film(sim);
    memcpy(sim->heated->steps->heated_P, sim->now.P,
           sim->now.n * sizeof *sim->now.P);
    heat(sim);
}

/* Updates the film with temperatures changed by half of the difference. */
static void apply(ovr_simulation *sim)
{
    ovr_heat_relax(sim, SHARE);
    ovr_heat_apply(sim);
    ovr_level_properties(&sim->grids, sim->finest);
    ovr_level_residual(&sim->grids, sim->finest);
}

/* Extrapolates the temperatures used by their change in the previous step. */
static void extrapolate_used(ovr_simulation *sim)
{
    const double maximum = 0.15;
    ovr_heated *h = sim->heated;
    double old = sim->past.dT, factor = old > 0 ? h->steps->dT / old : 0;
    for (int j = 0; j < h->cross_film.n; j++)
        for (size_t i = 0; i < sim->now.n; i++) {
            double change = factor * h->steps->change[j][i];
            double fall = h->film.fall[i] * fabs(change);
            h->used[j][i] += fall > maximum ? change * maximum / fall : change;
        }
}

void ovr_heat_try(ovr_simulation *sim, void *own, bool corrected)
{
    ovr_heated *h = own;
    (void)corrected;
    ovr_level_refresh(&sim->grids, sim->finest);
    withdraw(sim);
    ovr_simulation_read(sim);
    hold_guess(sim);
    swap_trial(h);
    h->steps->passes = PASSES;
    solve(sim);
    extrapolate_used(sim);
    apply(sim);
}

/* True if the viscosities of a film lag, or if a cycle has changed the film
 * much since the last temperature solve. The second condition increases the
 * cycles for a hot dent from 572 to 675 (level 7) and reduces the error of the
 * central film thickness from 8.7e-4 to 1.9e-4. */
static bool is_inconsistent(const ovr_simulation *sim)
{
    const double enough = 0.15, far = 3e-4 /* ph */;
    const ovr_heat_steps *s = sim->heated->steps;
    return s->lag > enough || (s->passes > PASSES - MOVED &&
                               sim->grids.kernels->difference(
                                   sim->now.n, sim->now.P, s->heated_P) > far);
}

void ovr_heat_update(ovr_simulation *sim, void *own)
{
    ovr_heat_steps *s = ((ovr_heated *)own)->steps;
    if (!s->trying) /* cycles of a steady film in pseudo-time (continuation.c)
                     */
        return;
    ovr_simulation_read(sim);
    if (s->passes > 0 && is_inconsistent(sim)) {
        s->passes--;
        solve(sim);
        apply(sim);
        return;
    }
    if (ovr_heat_skew_follow(sim))
        ovr_level_residual(&sim->grids, sim->finest);
}

/* True if the compression heating of the final film differs from that of the
 * guess by more than this fraction of the total power. */
static bool has_other_compression(const ovr_simulation *sim)
{
    const double share = 0.02;
    const ovr_heated *h = sim->heated;
    const ovr_heat_steps *s = h->steps;
    const ovr_solution *now = &sim->now;
    const double *before = sim->past.P[0];
    double power = 0;
    for (size_t i = 1; sim->past.steps && i + 1 < now->n; i++)
        power += now->weights[i] * now->H[i] *
                 fabs((now->P[i] - before[i]) / s->dT - s->P_T[i]) *
                 expansion_at(&h->numbers, now->P[i]);
    return h->numbers.T0 * power > share * s->max_balanced;
}

void ovr_heat_accepted(ovr_simulation *sim, void *own, double dT)
{
    ovr_heated *h = own;
    ovr_heat_steps *s = h->steps;
    (void)dT;
    if (has_other_compression(sim))
        heat(sim);
    for (int k = 0; k < 2; k++)
        ovr_heat_surface_store(sim, k, h->q[k]);
    for (int j = 0; j < h->cross_film.n; j++)
        sim->grids.kernels->combine(sim->now.n, 1, h->T[j], -1, s->T_before[j],
                                    s->change[j]);
    s->trying = false;
    keep(sim);
}

/* ------------------------------------------------------------ flagged steps */

/* True if the load jumped within the last quarter of b/um or five steps:
 * compression heating then appears late and at another pressure. */
static bool load_jumped(const ovr_simulation *sim, double T)
{
    const double while_after = 0.25, steps = 5, much = 0.01;
    double since = T - ovr_larger(while_after, steps * sim->past.dT);
    double before = ovr_history_value(sim->histories.load,
                                      ovr_larger(since, 0));
    double now = ovr_history_value(sim->histories.load, T);
    return fabs(now - before) > much * ovr_larger(now, before);
}

bool ovr_heat_is_stale(ovr_simulation *sim, void *own)
{
    const double far = 1, open = 0.1;
    const ovr_observation *o = &sim->observation;
    const ovr_heated *h = own;
    ovr_heat_steps *s = h->steps;
    double left = fabs(h->left);
    s->max_balanced = ovr_larger(s->max_balanced, h->balanced);
    bool lags = s->lag > far ||
                (left > open * s->max_balanced && !load_jumped(sim, o->T));
    sim->statistics.lagging += lags;
    return lags;
}

/* -------------------------------------------------------------- saved state */

void ovr_heat_visit(ovr_simulation *sim, void *own, ovr_pieces *state)
{
    ovr_heated *h = own;
    int points = h->cross_film.n;
    OVR_SHOW(state, "heat_points", points);
    if (!state->status && points != h->cross_film.n && !h->chooses)
        state->status = ovr_fail(
            state->err, OVR_BAD_INPUT,
            "the state has %d points across the film, but this run has %d",
            points, h->cross_film.n);
    if (state->status)
        return;
    if (points != h->cross_film.n)
        ovr_cross_film_make(points, &h->cross_film);
    OVR_SHOW(state, "heat_stored", h->steps->stored);
    OVR_SHOW(state, "heat_most_balanced", h->steps->max_balanced);
    ovr_show_nodes(sim, state, "pressing", 1, h->steps->P_T);
    for (int j = 0; j < points; j++)
        ovr_show_nodes(sim, state, "temperature", j + 1, h->T[j]);
    for (int j = 0; j < points; j++)
        ovr_show_nodes(sim, state, "temperature_change", j + 1,
                       h->steps->change[j]);
    for (int k = 0; k < points + FIELDS; k++)
        ovr_show_nodes(sim, state, "viscosity_by", k + 1, kept_of(h, k));
    for (int k = 0; k < 2; k++) {
        ovr_show_nodes(sim, state, "heat_flux", k + 1, h->q[k]);
        ovr_heat_surface_visit(sim, k, state);
    }
}

void ovr_heat_restored(ovr_simulation *sim, void *own)
{
    ovr_heated *h = own;
    h->steps->trying = false;
    h->steps->dT = sim->past.dT;
    h->skew_share = 1;
    for (size_t i = 0; i < sim->now.n; i++) {
        h->mean[i] = 0;
        for (int j = 0; j < h->cross_film.n; j++)
            h->mean[i] += h->cross_film.w[j] * h->T[j][i];
    }
    if (!(h->steps->dT > 0)) { /* steady start */
        ovr_heat_march_begin(sim);
        ovr_heat_march_columns(sim);
    }
    keep(sim);
}
