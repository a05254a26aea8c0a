/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Discretization errors on request: the same case one and two levels coarser.
 * Of a value v on levels l, l - 1, l - 2, with the differences d1 = |v_l -
 * v_{l-1}| and d2 = |v_{l-1} - v_{l-2}|, the order seen is q = log2(d2/d1), and
 * the error, that of Richardson's extrapolation,
 *
 *     e = max(d1, d2 2^-p)/(2^min(p, q) - 1),    q no less than 1/2:
 *
 * no better than the order p of the scheme says, nor than the levels show, and
 * not misled by a d1 that is small by chance.  An extreme over time is that of
 * something that passes, seen at nodes and steps: of it p = 1.
 *
 * Of several passes each level has its own: what its passes leave feeds its
 * next ones, so that the errors that oil carries from pass to pass are seen.
 *
 * Where d1 is more than 0.6 of d2 the value does not converge with the level
 * (yet), or by less than order 3/4, and where the two differ in sign by much it
 * is far from its limit: e says little then.  Narrow peaks of pressure grow so,
 * some of them on finer levels only, where nothing warns of them.
 */
#include <math.h>
#include <stdio.h>

#include "case/feed.h"
#include "run/internal.h"
#include "run/passes.h"
#include "simulation/scheme.h"

/* Relative differences that are of the solver's tolerances, not of the mesh;
 * such that need not shrink to be called converged. */
static const double NEGLIGIBLE = 1e-6;
static const double FILM_CONVERGED = 5e-3, PRESSURE_CONVERGED = 5e-4;
static const double TURNS_BY = 0.01;
static const double SHRINKS = 0.6;

enum { LEVELS = OVR_PASS_LEVELS };

/* What a level says at the time at which the finest run ended: its steps are
 * longer, so two of its steps are kept. */
typedef struct level_run {
    int steps;
    double T[2];
    ovr_observation seen[2];
    ovr_statistics total;
} level_run;

static ovr_status keep(void *data, const ovr_simulation *sim, ovr_error *err)
{
    level_run *r = data;
    (void)err;
    r->T[0] = r->T[1];
    r->seen[0] = r->seen[1];
    r->seen[1] = *ovr_simulation_observation(sim);
    r->T[1] = r->seen[1].T;
    r->total = *ovr_simulation_statistics(sim);
    r->steps++;
    return OVR_OK;
}

static double at(const level_run *r, double T, double before, double now)
{
    double span = r->T[1] - r->T[0];
    return r->steps > 1 && span > 0
               ? before + (T - r->T[0]) / span * (now - before)
               : now;
}

/* The coarser run to the same time, whatever would have ended it. */
static ovr_status solve(ovr_setup *setup, ovr_simulation *coarse, double end,
                        level_run *r, ovr_pass_level *pass, ovr_error *err)
{
    ovr_observer observer[2] = {{keep, NULL, r}};
    ovr_march march = *setup->march;
    ovr_status status = ovr_simulation_steady(coarse, err);
    if (pass)
        observer[1] = ovr_pass_history_observer(&pass->seen);
    march.count = pass ? 2 : 1;
    march.observers = observer;
    march.end = end;
    march.until_steady = false;
    if (!status && setup->transient)
        return ovr_simulation_march(coarse, &march, err);
    for (size_t k = 0; !status && k < march.count; k++)
        status = observer[k].observe(observer[k].data, coarse, err);
    return status;
}

/* Its pass, of several, before it begins. */
static ovr_status begin(const ovr_run *run, ovr_setup *setup,
                        ovr_pass_level *pass, ovr_error *err)
{
    const ovr_allocator *allocator = &run->arena.allocator;
    ovr_status status =
        pass ? ovr_setup_load(setup, run->passes->now, allocator, err) : OVR_OK;
    if (!status)
        status = ovr_setup_prepare(setup, allocator, err);
    if (pass && !status) {
        ovr_pass_level_feed(pass, setup);
        ovr_pass_level_begin(pass, allocator);
    }
    return status;
}

static ovr_status run_coarser(const ovr_run *run, int down, level_run *r,
                              ovr_error *err)
{
    const ovr_allocator *allocator = &run->arena.allocator;
    ovr_pass_level *pass = run->passes ? &run->passes->level[down] : NULL;
    ovr_setup *setup = ovr_case_resolve(run->c, allocator, err);
    ovr_simulation *coarse = NULL;
    ovr_status status = OVR_BAD_INPUT;
    if (setup) {
        setup->options->level = ovr_simulation_options(run->sim)->level - down;
        if (!begin(run, setup, pass, err))
            coarse = ovr_setup_simulation(setup, allocator, err);
    }
    if (coarse) {
        ovr_run_surface(run, coarse);
        status = solve(setup, coarse, ovr_simulation_state(run->sim)->T, r,
                       pass, err);
    }
    if (pass && !status)
        status = ovr_pass_level_end(pass, setup, err);
    ovr_simulation_free(coarse);
    ovr_setup_free(setup);
    return status;
}

/* ------------------------------------------------------------ the errors */

static bool turns(const double v[LEVELS])
{
    double last = v[0] - v[1], before = v[1] - v[2];
    return last * before < 0 && fabs(last) > TURNS_BY * fabs(v[0]);
}

/* v: finest first; NAN at the end where only one coarser level was solved. */
static ovr_run_error judge(const char *key, ovr_unit_kind kind, double order,
                           const double v[LEVELS])
{
    ovr_run_error e = {key, kind, {v[0], v[1], v[2]}, NAN, NAN, true};
    double d1 = fabs(v[0] - v[1]), d2 = fabs(v[1] - v[2]);
    double converged = kind == OVR_KIND_HEIGHT ? FILM_CONVERGED
                                               : PRESSURE_CONVERGED;
    double least = NEGLIGIBLE * fabs(v[0]), q = fmin(order, 1);
    if (d2 >= 0) {
        e.order = d1 > least && d2 > least ? log2(d2 / d1) : NAN;
        q = isnan(e.order) ? order : fmax(0.5, fmin(order, e.order));
        e.converges = (d1 <= SHRINKS * d2 && !turns(v)) ||
                      d1 <= converged * fabs(v[0]);
        d1 = fmax(d1, d2 * exp2(-order));
    }
    e.error = d1 / (exp2(q) - 1) + least;
    return e;
}

static void add(ovr_run_errors *errors, ovr_run_error e)
{
    if (isfinite(e.error) && errors->count < OVR_RUN_ERRORS)
        errors->of[errors->count++] = e;
}

/* At the end of the run. */
static void judge_end(ovr_run_errors *errors, const level_run *r, double T,
                      double order)
{
    static const struct {
        const char *key;
        ovr_unit_kind kind;
        size_t offset;
    } rows[] = {
        {"H_min", OVR_KIND_HEIGHT, offsetof(ovr_observation, H_min_located)},
        {"H_cen", OVR_KIND_HEIGHT, offsetof(ovr_observation, H_cen)},
        {"P_max", OVR_KIND_PRESSURE, offsetof(ovr_observation, P_max)}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        double v[LEVELS];
        for (int i = 0; i < LEVELS; i++) {
            const char *before = (const char *)&r[i].seen[0] + rows[k].offset;
            const char *now = (const char *)&r[i].seen[1] + rows[k].offset;
            v[i] = r[i].steps
                       ? at(&r[i], T, *(const double *)(const void *)before,
                            *(const double *)(const void *)now)
                       : NAN;
        }
        add(errors, judge(rows[k].key, rows[k].kind, order, v));
    }
}

/* Over the whole run; places and times are none. */
static void judge_extremes(ovr_run_errors *errors, const level_run *r)
{
    const ovr_extreme *row;
    for (size_t k = 0; (row = ovr_extreme_at(k)); k++) {
        double v[LEVELS];
        for (int i = 0; i < LEVELS; i++)
            v[i] = r[i].steps ? ovr_extreme_value(row, &r[i].total) : NAN;
        if (row->kind == OVR_KIND_HEIGHT || row->kind == OVR_KIND_PRESSURE)
            add(errors, judge(row->key, row->kind, 1, v));
    }
}

/* Means over a pass, of several. */
static void judge_means(ovr_run_errors *errors, const ovr_passes *passes,
                        const level_run *r, double order)
{
    static const struct {
        const char *key;
        ovr_unit_kind kind;
        ovr_pass_column of;
    } rows[] = {{"H_cen_mean", OVR_KIND_HEIGHT, OVR_PASS_FILM},
                {"X_meniscus_mean", OVR_KIND_LENGTH, OVR_PASS_MENISCUS}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        double v[LEVELS];
        for (int i = 0; i < LEVELS; i++)
            v[i] = r[i].steps ? passes->level[i].end.row.value[rows[k].of]
                              : NAN;
        add(errors, judge(rows[k].key, rows[k].kind, order, v));
    }
}

/* The order of what is left at the end: of a steady state that of the
 * solution, of a moving one no more than the scheme's. */
static double order_of(const ovr_run *run)
{
    const ovr_options *o = ovr_simulation_options(run->sim);
    int scheme = ovr_scheme_record(o->scheme)->order;
    int reached = ovr_simulation_order(run->sim);
    return run->info.transient ? scheme : reached > scheme ? reached : scheme;
}

static void warn(ovr_run *run, const ovr_run_error *e, int level)
{
    char text[OVR_MESSAGE_SIZE], where[40];
    if (e->converges)
        return;
    snprintf(
        text, sizeof text,
        "%s%s does not converge with the level: %.4g, %.4g, %.4g at levels "
        "%d, %d, %d; its estimated error says little (narrow peaks of "
        "pressure grow so)",
        ovr_run_where(run, where), e->key, e->value[2], e->value[1],
        e->value[0], level - 2, level - 1, level);
    ovr_run_message(run, OVR_SAY_WARNING, text);
}

const char *ovr_run_where(const ovr_run *run, char room[40])
{
    *room = '\0';
    if (run->passes)
        snprintf(room, 40, "pass %d: ", run->info.pass);
    return room;
}

/* The levels below, as far as they can be solved. */
static ovr_status run_levels(const ovr_run *run, level_run r[LEVELS],
                             ovr_error *err)
{
    ovr_passes *p = run->passes;
    int level = ovr_simulation_options(run->sim)->level;
    ovr_status status = keep(&r[0], run->sim, err);
    ovr_error why = {0};
    if (!status && p)
        status = ovr_pass_level_end(&p->level[0], run->setup, err);
    if (!status)
        status = run_coarser(run, 1, &r[1], err);
    if (status)
        return status;
    if (level < 3 || (p && p->level[2].lost) ||
        run_coarser(run, 2, &r[2], &why)) {
        r[2].steps = 0;
        if (p)
            p->level[2].lost = true;
    }
    return OVR_OK;
}

ovr_status ovr_run_estimate(ovr_run *run, ovr_error *err)
{
    ovr_run_errors *errors = &run->error;
    level_run r[LEVELS] = {{0}};
    ovr_status status = run_levels(run, r, err);
    int level = ovr_simulation_options(run->sim)->level;
    *errors = (ovr_run_errors){0};
    if (status)
        return status;
    errors->level = level - 1;
    judge_end(errors, r, r[0].T[1], order_of(run));
    if (run->info.transient)
        judge_extremes(errors, r);
    if (run->passes)
        judge_means(errors, run->passes, r, order_of(run));
    for (size_t k = 0; k < errors->count; k++)
        warn(run, &errors->of[k], level);
    return OVR_OK;
}
