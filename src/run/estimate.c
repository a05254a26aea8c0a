/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Estimates discretization errors on request by solving the case one and two
 * levels coarser, with time steps scaled accordingly, up to the same time. For
 * a value v on levels l, l - 1, l - 2 with the differences d1 = |v_l - v_{l-1}|
 * and d2 = |v_{l-1} - v_{l-2}|, the observed order is q = log2(d2/d1), and the
 * error by Richardson extrapolation is
 *
 *     e = max(d1, d2 2^-p)/(2^min(p, q) - 1),    q no less than 1/2:
 *
 * Thus neither the order p of the scheme nor the observed order is exceeded.
 * For transient runs p = 1, because extremes are sampled at nodes and steps.
 * Solutions of fourth order have p = 2, but 3 for H_cen and 2.5 for H_min at
 * the end of a run, and 2 for H_min of a steady state. On 122 random runs the
 * orders were 2.6 and 2.5 in the median, and 2.3 of the smallest H_min of a
 * run. For transient runs e is multiplied by 1.25, Roache's safety factor for
 * three grids (J. Fluids Eng. 116, 1994).
 *
 * Thick steady films of fourth order end at a flat pressure. The end is a node,
 * which moves irregularly from level to level. Its position adds an error of
 * second order, which d1 contains only if the end has moved. Therefore e is at
 * least d2/4.
 *
 * There is no estimate (e is NAN) if the differences have no plausible order:
 * d1 and d2 have different signs, or q is not between 3/4 and the scheme's
 * order (at least two) plus one. Two values may then agree by chance, or the
 * coarser levels may not resolve the solution. Nor is there an estimate of
 * pressures in transient runs from only two levels. Differences that are both
 * below 3e-4 of the value are accepted with any order. So are film thicknesses
 * of fourth order, where errors of different orders cancel, if d2 is below a
 * tenth of the value and d1 below 0.4 d2. Narrow pressure peaks grow on finer
 * levels, some of them only there. For transient pressures that are not
 * resolved (ovr_maximum_is_resolved), q is therefore 1/2, the order of a
 * spike's height, independent of the differences.
 *
 * Each level has its own passes, fed by the layers of its own preceding pass,
 * so that errors carried by the lubricant from pass to pass are included.
 */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "case/resolve.h"
#include "case/setup.h"
#include "physics/heat/heat.h"
#include "run/internal.h"
#include "run/pass_series.h"
#include "simulation/internal.h"
#include "simulation/scheme.h"
#include "simulation/simulation.h"

/* ----------------------------------------------------------------- Estimate */

/* NEGLIGIBLE: relative differences at the level of the solver's tolerance.
 * SMALL: relative differences that need not decrease from level to level. */
static const double NEGLIGIBLE = 1e-6, SMALL = 3e-4;
static const double MIN_ORDER = 0.75, SAFETY = 1.25;
static const double PEAK_ORDER = 0.5;
/* Limits for corrected (fourth-order) films: d2 relative to the value, d1
 * relative to d2. */
static const double NEAR = 0.1, NEARER = 0.4;

enum { LEVELS = OVR_PASS_LEVELS };

/* A level's values at the time at which the finest run ended. */
typedef struct level_run {
    ovr_pass_level *pass; /* values of one of several passes; NULL: there is
                           * only one */
    bool solved;
    double end;
    ovr_observation seen;
    ovr_statistics total;
} level_run;

static ovr_status keep(void *data, const ovr_simulation *sim, ovr_error *err)
{
    level_run *r = data;
    (void)err;
    r->seen = *ovr_simulation_observation(sim);
    r->total = *ovr_simulation_statistics(sim);
    r->solved = true;
    return OVR_OK;
}

/* Returns the end time of the finest run, at which the last, longer step of a
 * coarser level is cut. */
static double end_of(void *data, double after)
{
    const level_run *r = data;
    return r->end > after ? r->end : INFINITY;
}

/* Stops the run when the caller requests it. It is the last of the
 * observers. */
static ovr_status stop_on_request(void *data, const ovr_simulation *sim,
                                  ovr_error *err)
{
    const ovr_run *run = data;
    if (!run->how.interrupt || !run->how.interrupt(run->how.data))
        return OVR_OK;
    return ovr_fail(err, OVR_STOPPED,
                    "stopped at T = %g of the run for the error estimate",
                    ovr_simulation_state(sim)->T);
}

/* Solves the run on a coarser level up to the end time of the original run. */
static ovr_status solve(ovr_run *run, ovr_setup *setup, ovr_simulation *coarse,
                        level_run *r, ovr_error *err)
{
    ovr_observer observer[3] = {{keep, end_of, r}};
    ovr_simulation_stop(coarse, run->how.interrupt, run->how.data);
    ovr_march march = *setup->march;
    ovr_status status = ovr_simulation_steady(coarse, err);
    march.count = 1;
    if (r->pass)
        observer[march.count++] = ovr_pass_history_observer(&r->pass->seen);
    observer[march.count++] = (ovr_observer){stop_on_request, NULL, run};
    march.observers = observer;
    march.end = r->end;
    march.until_steady = false;
    if (!status && setup->transient)
        return ovr_simulation_march(coarse, &march, err);
    for (size_t k = 0; !status && k < march.count; k++)
        status = observer[k].observe(observer[k].data, coarse, err);
    return status;
}

/* Sets time steps that have the same length in D as on the finest level. */
static void set_steps(const ovr_run *run, ovr_setup *setup)
{
    ovr_march *march = setup->march;
    double dT = run->setup->march->dT;
    march->dT = dT > 0 ? dT * setup->mesh / run->setup->mesh : 0;
}

/* Adds the layers of the preceding pass on this level to the setup, before one
 * of several passes begins. */
static ovr_status begin(const ovr_run *run, ovr_setup *setup,
                        ovr_pass_level *pass, ovr_error *err)
{
    const ovr_allocator *allocator = &run->arena.allocator;
    ovr_status status =
        pass ? ovr_setup_pass(setup, run->passes->now, allocator, err) : OVR_OK;
    if (!status)
        status = ovr_setup_prepare(setup, allocator, err);
    if (!status)
        set_steps(run, setup);
    if (pass && !status) {
        ovr_pass_level_feed(pass, setup);
        ovr_pass_level_begin(pass, allocator);
    }
    return status;
}

static ovr_status run_coarser(ovr_run *run, int down, level_run *r,
                              ovr_error *err)
{
    const ovr_allocator *allocator = &run->arena.allocator;
    ovr_pass_level *pass = run->passes ? &run->passes->level[down] : NULL;
    ovr_setup *setup = ovr_case_resolve(run->c, allocator, err);
    r->pass = pass;
    ovr_simulation *coarse = NULL;
    ovr_status status = OVR_BAD_INPUT;
    if (setup) {
        ovr_heat *heat = ovr_setup_heat(setup);
        if (heat)
            heat->points = ovr_simulation_heat_points(run->sim);
        setup->options->level = ovr_simulation_options(run->sim)->level - down;
        if (!begin(run, setup, pass, err))
            coarse = ovr_setup_simulation(setup, allocator, err);
    }
    if (coarse) {
        ovr_run_surface(run, coarse);
        r->end = ovr_simulation_state(run->sim)->T;
        status = solve(run, setup, coarse, r, err);
    }
    if (pass && !status)
        status = ovr_pass_level_end(pass, setup, err);
    ovr_simulation_free(coarse);
    ovr_setup_free(setup);
    return status;
}

/* ------------------------------------------------------------ the errors */

/* Expected order of the differences between levels, and how they are judged. */
typedef struct measure {
    double order, safety;
    bool in_time, corrected; /* run in time; fourth-order corrections */
    bool peak;               /* the maximum of P is not resolved */
} measure;

/* True if the differences decrease with a plausible order. `turns`: d1 and d2
 * have different signs. */
static bool has_plausible_order(const measure *m, double d1, double d2,
                                bool turns)
{
    double q = log2(d2 / d1);
    return !turns && q >= MIN_ORDER && q <= fmax(m->order, 2) + 1;
}

/* True if the differences have no plausible order but are small enough for a
 * corrected film. */
static bool is_small_enough(const measure *m, double size, double d1, double d2)
{
    return m->corrected && d2 <= NEAR * size && d1 <= NEARER * d2;
}

/* Estimates the error of a value from its values v on the levels, finest first.
 * The last is NAN if only one coarser level was solved. */
static ovr_run_error estimate_error(const char *key, ovr_unit_kind kind,
                                    const measure *m, const double v[LEVELS])
{
    ovr_run_error e = {key, kind, {v[0], v[1], v[2]}, NAN, NAN, true};
    bool film = kind != OVR_KIND_PRESSURE;
    double size = fabs(v[0]), minimum = NEGLIGIBLE * size,
           q = fmin(m->order, 1);
    double d1 = fabs(v[0] - v[1]), d2 = fabs(v[1] - v[2]), d = d1;
    bool turns = (v[0] - v[1]) * (v[1] - v[2]) < 0;
    if (isnan(d2))
        e.converges = film || !m->in_time;
    else {
        e.order = d1 > minimum && d2 > minimum ? log2(d2 / d1) : NAN;
        e.converges = fmax(d1, d2) <= SMALL * size ||
                      has_plausible_order(m, d1, d2, turns);
        q = isnan(e.order) ? m->order : fmax(0.5, fmin(m->order, e.order));
        d = fmax(d1, d2 * exp2(-m->order));
    }
    if (!film && m->in_time && m->peak)
        q = PEAK_ORDER;
    e.converges = e.converges || (film && is_small_enough(m, size, d1, d2));
    if (e.converges)
        e.error = m->safety * d / (exp2(q) - 1) + minimum;
    return e;
}

static void add(ovr_run_errors *errors, ovr_run_error e)
{
    bool known = isfinite(e.value[0]) && isfinite(e.value[1]);
    if (known && errors->count < OVR_RUN_ERRORS)
        errors->of[errors->count++] = e;
}

static const ovr_observable *observable_of(const char *key)
{
    const ovr_observable *o;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if (o->key && !strcmp(o->key, key))
            break;
    return o;
}

/* True if the position of the film end matters: where M is below 1, H_cen
 * changes by up to 2e-4 when the end moves by a node. */
static bool is_thick(const level_run *r, const measure *m)
{
    const double thick = 1;
    return m->corrected && !m->in_time && r[2].solved && r->seen.H_cen > thick;
}

/* Reads the number at the end of the run. */
static void estimate_end(ovr_run_errors *errors, const level_run *r,
                         const measure *m)
{
    /* minimum film thickness interpolated between nodes */
    static const char *const rows[][2] = {
        {"H_min", "H_min_located"}, {"H_cen", "H_cen"}, {"P_max", "P_max"}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const ovr_observable *o = observable_of(rows[k][1]);
        double v[LEVELS];
        for (int i = 0; i < LEVELS; i++)
            v[i] = r[i].solved ? ovr_observable_value(o, &r[i].seen) : NAN;
        measure end = *m;
        if (m->corrected && k == 0)
            end.order = m->in_time ? 2.5 : 2;
        if (m->corrected && k == 1 && m->in_time)
            end.order = 3;
        ovr_run_error e = estimate_error(rows[k][0], o->kind, &end, v);
        if (k == 1 && e.converges && is_thick(r, m))
            e.error = fmax(e.error, fabs(v[1] - v[2]) / 4);
        add(errors, e);
    }
}

/* Estimates errors of the extremes of film thickness and pressure over the run,
 * and of the extremes of active physical models. */
static void estimate_extremes(ovr_run_errors *errors, const level_run *r,
                              const measure *m, unsigned physics)
{
    ovr_extreme e;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++) {
        double v[LEVELS];
        for (int i = 0; i < LEVELS; i++)
            v[i] = r[i].solved ? ovr_extreme_value(&e, &r[i].total) : NAN;
        if (e.part == OVR_KEPT_EXTREME && !(e.of->needs & ~physics) &&
            (e.kind == OVR_KIND_HEIGHT || e.kind == OVR_KIND_PRESSURE))
            add(errors, estimate_error(e.of->extreme_key, e.kind, m, v));
    }
}

/* Estimates errors of the means over one of several passes. */
static void estimate_means(ovr_run_errors *errors, const ovr_passes *passes,
                           const level_run *r, const measure *m)
{
    static const struct {
        const char *key;
        ovr_unit_kind kind;
        const char *of;
    } rows[] = {{"H_cen_mean", OVR_KIND_HEIGHT, "central_film_thickness"},
                {"X_meniscus_mean", OVR_KIND_LENGTH, "meniscus"}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        size_t of = ovr_pass_column_named(rows[k].of);
        double v[LEVELS];
        for (int i = 0; i < LEVELS; i++)
            v[i] = r[i].solved ? passes->level[i].end.row.value[of] : NAN;
        add(errors, estimate_error(rows[k].key, rows[k].kind, m, v));
    }
}

/* Uses the order of the solution for a steady state. */
static measure measure_of(const ovr_run *run)
{
    const ovr_options *o = ovr_simulation_options(run->sim);
    int scheme = ovr_scheme_record(o->scheme)->order;
    int reached = ovr_simulation_order(run->sim);
    const ovr_statistics *total = ovr_simulation_statistics(run->sim);
    bool peak = !ovr_simulation_observation(run->sim)->P_max_resolved ||
                total->P_max_unresolved;
    if (run->info.transient)
        return (measure){reached == 4 ? 2 : 1, SAFETY, true, reached == 4,
                         peak};
    return (measure){reached > scheme ? reached : scheme, 1, false,
                     reached == 4, peak};
}

static void warn(ovr_run *run, const ovr_run_error *e, int level)
{
    if (e->converges)
        return;
    if (isnan(e->value[2]))
        ovr_run_warn(run,
                     "%s: no error estimate from the two values %.4g, %.4g at "
                     "levels %d, %d, because level %d cannot be solved",
                     e->key, e->value[1], e->value[0], level - 1, level,
                     level - 2);
    else
        ovr_run_warn(
            run,
            "%s: no error estimate, because the values %.4g, %.4g, %.4g at "
            "levels %d, %d, %d do not converge with a known order",
            e->key, e->value[2], e->value[1], e->value[0], level - 2, level - 1,
            level);
}

/* Solves the run on the coarser levels; stops at the first that fails. */
static ovr_status run_levels(ovr_run *run, level_run r[LEVELS], ovr_error *err)
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
    if (level < 3 || (p && p->level[2].lost))
        status = OVR_BAD_INPUT;
    else
        status = run_coarser(run, 2, &r[2], &why);
    if (status == OVR_STOPPED)
        return ovr_fail(err, OVR_STOPPED, "%s", why.message);
    if (status) {
        r[2].solved = false;
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
    const measure m = measure_of(run);
    estimate_end(errors, r, &m);
    if (run->info.transient)
        estimate_extremes(errors, r, &m, ovr_setup_physics(run->info.setup));
    if (run->passes)
        estimate_means(errors, run->passes, r, &m);
    for (size_t k = 0; k < errors->count; k++)
        warn(run, &errors->of[k], level);
    return OVR_OK;
}

/* -------------------------------------------------- Confirmation of a level */

/*
 * A level chosen before the run is confirmed after it, by the estimate of the
 * discretization error, of the films where friction counts too, as that is not
 * estimated.  Warns if the error is larger than requested, with the level that
 * would reach the target if the error fell as D^2.
 */

static const char *const names[] = {"H_cen", "H_min",
                                    "the effect of the features", "both films"};

/* Returns the relative error of a number, INFINITY if it was not estimated. */
static double error_of(const ovr_run_errors *e, const char *key)
{
    for (size_t k = 0; k < e->count; k++)
        if (!strcmp(e->of[k].key, key))
            return e->of[k].error / fabs(e->of[k].value[0]);
    return INFINITY;
}

static double relative_error(const ovr_run *run)
{
    const ovr_run_errors *e = &run->error;
    ovr_accuracy of = run->setup->accuracy_of;
    double central = error_of(e, "H_cen");
    double minimum = error_of(e,
                              run->info.transient ? "H_min_overall" : "H_min");
    if (of != OVR_ACCURACY_ALL)
        return of == OVR_ACCURACY_H_CEN ? central : minimum;
    return isnan(central + minimum) ? NAN : fmax(central, minimum);
}

static void doubt(ovr_run *run, const char *why)
{
    const ovr_setup *s = run->setup;
    ovr_run_warn(
        run,
        "level %d was chosen for an error of %.2g of %s, which cannot be "
        "confirmed: %.800s",
        s->options->level, s->accuracy, names[s->accuracy_of], why);
}

ovr_status ovr_run_confirm(ovr_run *run, ovr_error *err)
{
    const ovr_setup *s = run->setup;
    int level = s->options->level;
    ovr_error why = {0};
    ovr_status status = ovr_run_estimate(run, &why);
    if (status == OVR_STOPPED)
        return ovr_fail(err, OVR_STOPPED, "%s", why.message);
    if (status) {
        doubt(run, why.message);
        return OVR_OK;
    }
    double error = relative_error(run);
    if (isnan(error))
        doubt(
            run,
            "the values at coarser levels do not converge with a known order");
    if (isnan(error) || error <= s->accuracy)
        return OVR_OK;
    ovr_run_warn(run,
                 "level %d was chosen for an error of %.2g of %s, but the "
                 "estimate after the run is %.2g; use level %d",
                 level, s->accuracy, names[s->accuracy_of], error,
                 level + (int)ceil(log2(error / s->accuracy) / 2));
    return OVR_OK;
}
