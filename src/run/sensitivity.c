/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Elasticities e = ln(Q(x(1 + h))/Q(x(1 - h)))/ln((1 + h)/(1 - h)) for h = 2 %
 * and 1 %; near x = 0 and for temperatures, slopes with steps of fixed size.
 * Derivatives of the discrete solution (by an adjoint method) are not used,
 * because within one mesh size they depend on the grid.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "base/text.h"
#include "case/case.h"
#include "run/comparison.h"
#include "run/trials.h"

enum { KEYS = 64, QUANTITIES = 3, STEPS = 4, LEVELS = 2 };

/* A key and the values at which the case is solved. */
typedef struct moved {
    char *where;
    const char *suffix; /* " kN/m", or "" */
    double value, step; /* step relative to the value, or absolute */
    bool absolute;
} moved;

struct ovr_sensitivity {
    ovr_arena arena;
    ovr_sensitivity_row *row;
    size_t rows;
};

typedef struct working {
    ovr_sensitivity *to;
    ovr_sensitivity_options how;
    ovr_case *base;
    ovr_trials *trials;
    moved key[KEYS];
    size_t keys;
    int level; /* level of the case; 0: unknown */
    ovr_error *err;
} working;

/* ------------------------------------------------------------------- keys */

static bool is_size(const char *key)
{
    static const char *const sizes[] = {"depth",     "height",     "width",
                                        "amplitude", "wavelength", "Rq"};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
        if (!strcmp(sizes[k], key))
            return true;
    return false;
}

/* True if the key is among those varied by default. */
static bool is_usual(const ovr_case_entry *e)
{
    if (!strcmp(e->section, "contact") || !strcmp(e->section, "lubricant") ||
        !strcmp(e->section, "body"))
        return e->number != 0;
    return !strcmp(e->section, "feature") && is_size(e->key) && e->number != 0;
}

static ovr_status add_key(working *w, const ovr_case_entry *e)
{
    moved *m = &w->key[w->keys];
    const char *unit = ovr_amount_read(e->text, &m->value);
    char *suffix, where[300];
    if (w->keys == KEYS || !unit)
        return OVR_OK;
    suffix = ovr_arena_take(&w->to->arena, strlen(unit) + 2, 1, w->err);
    snprintf(where, sizeof where, "%s%s%s.%s", e->section, e->name ? "." : "",
             e->name ? e->name : "", e->key);
    m->where = ovr_arena_text(&w->to->arena, where, w->err);
    if (ovr_arena_status(&w->to->arena))
        return OVR_NO_MEMORY;
    if (*unit) {
        suffix[0] = ' ';
        strcpy(suffix + 1, unit);
    }
    m->suffix = suffix;
    m->absolute = !(fabs(m->value) > 0) || !strcmp(e->key, "slide_to_roll") ||
                  !strcmp(unit, "degC");
    m->step = !strcmp(unit, "degC") ? 2 : 0.02;
    w->keys++;
    return OVR_OK;
}

static ovr_status add_requested_key(working *w, ovr_line asked)
{
    ovr_case_entry e;
    if (!ovr_case_entry_of(w->base, asked.text, asked.size, &e))
        return ovr_fail_about(w->err, "sensitivity",
                              "%.*s: is not a key of this case; keys are "
                              "section.key, such as contact.load",
                              (int)asked.size, asked.text);
    if (!e.text || strcmp(ovr_parameter_at(e.parameter).type, "number") != 0 ||
        !isfinite(e.number))
        return ovr_fail_about(w->err, "sensitivity",
                              "%.*s: is not set to a number in this case",
                              (int)asked.size, asked.text);
    return add_key(w, &e);
}

static ovr_status add_keys(working *w)
{
    const char *list = w->how.keys;
    ovr_status status = OVR_OK;
    while (list && *list && !status) {
        size_t size = strcspn(list, ",");
        ovr_line one = ovr_trim((ovr_line){list, size, 0});
        status = one.size ? add_requested_key(w, one) : OVR_OK;
        list += size + (list[size] == ',');
    }
    for (size_t k = 0; !w->how.keys && !status && k < ovr_case_entries(w->base);
         k++) {
        ovr_case_entry e = ovr_case_entry_at(w->base, k);
        if (e.given && e.applies && isfinite(e.number) && is_usual(&e) &&
            !strcmp(ovr_parameter_at(e.parameter).type, "number"))
            status = add_key(w, &e);
    }
    if (!status && !w->keys)
        status = ovr_fail_about(w->err, "sensitivity",
                                "the case sets no number of the contact that "
                                "could be varied; name keys");
    return status;
}

/* ------------------------------------------------------------------- runs */

/* Returns the value at step s: 2 % up and down, 1 % up and down. */
static double value_at(const moved *m, int s)
{
    double step = (s % 2 ? -1 : 1) * m->step / (s < 2 ? 1 : 2);
    return m->absolute ? m->value + step : m->value * (1 + step);
}

static ovr_case *case_at(const working *w, const moved *m, int s, int coarser)
{
    char text[120];
    ovr_case *c = ovr_case_apart(w->base, w->err);
    ovr_status status = OVR_OK;
    snprintf(text, sizeof text, "%.17g%.60s", value_at(m, s), m->suffix);
    if (c)
        status = ovr_case_set(c, m->where, text, "sensitivity", w->err);
    snprintf(text, sizeof text, "%d", w->level - 1);
    if (c && !status && coarser)
        status = ovr_case_set(c, "domain.level", text, "sensitivity", w->err);
    if (!status)
        return c;
    ovr_case_free(c);
    return NULL;
}

/* Returns the index of a trial; trials are ordered by key, level and step. */
static size_t place_of(const working *w, size_t key, int coarser, int s)
{
    size_t levels = w->how.estimate ? LEVELS : 1;
    return (key * levels + (size_t)coarser) * STEPS + (size_t)s;
}

static ovr_trials *run_all(working *w)
{
    const ovr_trial_plan plan = {.workers = w->how.workers,
                                 .steady = w->how.steady,
                                 .data = w->how.data,
                                 .stop = w->how.stop,
                                 .run = w->how.run};
    size_t count = place_of(w, w->keys, 0, 0), made = 0;
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_case **cases = ovr_arena_take(&arena, count, sizeof *cases, w->err);
    ovr_trials *t = NULL;
    for (bool good = cases; good && made < count; made += good) {
        int s = (int)(made % STEPS);
        int coarser = w->how.estimate && made / STEPS % LEVELS;
        size_t key = made / place_of(w, 1, 0, 0);
        cases[made] = case_at(w, &w->key[key], s, coarser);
        good = cases[made] != NULL;
    }
    if (cases && made == count)
        t = ovr_trials_create(count, cases, &plan, w->err);
    for (size_t k = 0; !t && k < made; k++)
        ovr_case_free(cases[k]);
    ovr_arena_release(&arena);
    if (t && ovr_trials_execute(t, w->err)) {
        ovr_trials_free(t);
        t = NULL;
    }
    return t;
}

static bool orders_differ(const ovr_trials *t)
{
    double minimum = INFINITY, maximum = 0;
    for (size_t k = 0; k < ovr_trials_count(t); k++) {
        double order = ovr_trial_number(ovr_trials_at(t, k), "order", NULL);
        minimum = fmin(minimum, order); /* NAN is ignored */
        maximum = fmax(maximum, order);
    }
    return minimum < maximum;
}

/* Solves all trials with the same order. If order = auto chooses different
 * orders, all are repeated with order 2. */
static ovr_trials *run_alike(working *w)
{
    ovr_trials *t = run_all(w);
    if (!t || !orders_differ(t))
        return t;
    if (w->how.say)
        w->how.say(w->how.data, OVR_MESSAGE_WARNING,
                   "order = auto chose different orders; all runs are "
                   "repeated with order = 2");
    ovr_trials_free(t);
    return ovr_case_set(w->base, "domain.order", "2", "sensitivity", w->err)
               ? NULL
               : run_all(w);
}

/* ------------------------------------------------------------------- slopes */

/* The interpolated minimum film thickness has no key in SI: computed from the
 * dimensionless one and the film scale, which varies with the key. */
static const char located[] = "H_min_located_m";
static double number_of(const ovr_trial *t, const char *quantity)
{
    if (t->failed)
        return NAN;
    if (quantity != located)
        return ovr_trial_number(t, quantity, NULL);
    return ovr_trial_number(t, "H_min_located", NULL) *
           ovr_trial_number(t, "film_scale_m", NULL);
}

/* Returns the elasticity from the larger (smaller = 0) or the smaller (1)
 * step. */
static double slope(const working *w, size_t key, int coarser, int smaller,
                    const char *quantity)
{
    const moved *m = &w->key[key];
    double q[2], x[2];
    for (int side = 0; side < 2; side++) {
        int s = 2 * smaller + side;
        size_t place = place_of(w, key, coarser, s);
        q[side] = number_of(ovr_trials_at(w->trials, place), quantity);
        x[side] = value_at(m, s);
    }
    if (m->absolute)
        return (q[0] - q[1]) / (x[0] - x[1]);
    return log(q[0] / q[1]) / log(x[0] / x[1]);
}

static const char *failure(const working *w, size_t key)
{
    for (int s = 0; s < STEPS; s++) {
        const ovr_trial *one = ovr_trials_at(w->trials, place_of(w, key, 0, s));
        if (one->failed)
            return ovr_arena_text(&w->to->arena, one->message, NULL);
    }
    return "unknown in this case";
}

static void fill_row(working *w, size_t key, const char *quantity)
{
    const moved *m = &w->key[key];
    const ovr_quantity_name name = ovr_quantity_named(
        quantity == located ? "H_min_located" : quantity);
    ovr_sensitivity_row *r = &w->to->row[w->to->rows++];
    double coarse = slope(w, key, 0, 0, quantity);
    *r = (ovr_sensitivity_row){
        .key = m->where,
        .quantity = quantity,
        .name = ovr_arena_text(&w->to->arena, name.text, w->err),
        .unit = m->absolute ? m->suffix + !!*m->suffix : NULL,
        .step = m->step};
    r->slope = slope(w, key, 0, 1, quantity);
    r->doubt = fabs(r->slope - coarse);
    r->coarser = w->how.estimate ? slope(w, key, 1, 1, quantity) : NAN;
    double scale = m->absolute ? 0 : 0.02;
    if (isnan(r->doubt))
        r->why_none = failure(w, key);
    else if (r->doubt > scale + 0.1 * fabs(r->slope) && fabs(r->slope) > 0)
        r->why_none = "two difference steps disagree; use a finer level";
    else if (isfinite(r->coarser) && fabs(r->slope) > scale &&
             !(r->coarser / r->slope > 1 / 1.5 && r->coarser / r->slope < 1.5))
        r->why_none = "two levels disagree; use a finer level";
}

/* Chooses the quantities. Numbers in SI are used if the contact is physical,
 * because the film scale varies with the key. */
static size_t choose(const ovr_trials *t, bool transient,
                     const char *chosen[QUANTITIES])
{
    static const char *const names[2][QUANTITIES][2] = {
        {{"H_min_located", located},
         {"H_cen", "central_film_m"},
         {"P_max", "max_pressure_Pa"}},
        {{"H_min_overall", "H_min_overall_m"},
         {"P_max_overall", "P_max_overall_Pa"},
         {"mu_slide_max", "mu_slide_max"}}};
    size_t count = 0;
    bool physical = false;
    for (size_t k = 0; k < ovr_trials_count(t); k++)
        physical = physical || isfinite(ovr_trial_number(ovr_trials_at(t, k),
                                                         "film_scale_m", NULL));
    for (int q = 0; q < QUANTITIES; q++) {
        double v = NAN;
        for (size_t k = 0; k < ovr_trials_count(t) && isnan(v); k++)
            v = number_of(ovr_trials_at(t, k), names[transient][q][physical]);
        if (isfinite(v) && v != 0)
            chosen[count++] = names[transient][q][physical];
    }
    return count;
}

static ovr_status work(working *w)
{
    const char *quantity[QUANTITIES];
    size_t quantities;
    bool transient = false;
    ovr_trials *t = w->trials = run_alike(w);
    if (!t)
        return OVR_BAD_INPUT;
    for (size_t k = 0; k < ovr_trials_count(t); k++)
        transient = transient || isfinite(ovr_trial_number(ovr_trials_at(t, k),
                                                           "steps", NULL));
    quantities = choose(t, transient, quantity);
    w->to->row = ovr_arena_take(&w->to->arena, w->keys * QUANTITIES,
                                sizeof *w->to->row, w->err);
    for (size_t k = 0; w->to->row && k < w->keys; k++)
        for (size_t q = 0; q < quantities; q++)
            fill_row(w, k, quantity[q]);
    ovr_status status = w->to->row ? OVR_OK : OVR_NO_MEMORY;
    if (!status && !quantities)
        status = ovr_fail(w->err, OVR_NOT_CONVERGED, "all runs failed: %.600s",
                          failure(w, 0));
    ovr_trials_free(t);
    return status;
}

/* Reads the level of the case; it must be above 2 if errors are estimated. */
static ovr_status read_level(working *w)
{
    ovr_case_entry e;
    double level = ovr_case_entry_of(w->base, "domain.level",
                                     strlen("domain.level"), &e) &&
                           e.applies
                       ? e.number
                       : NAN;
    w->level = level > 2 ? (int)level : 0;
    if (w->how.estimate && !w->level)
        return ovr_fail_about(w->err, "level",
                              "there is no coarser level for comparison; set "
                              "domain.level above 2");
    return OVR_OK;
}

ovr_sensitivity *ovr_sensitivity_create(ovr_case *c,
                                        const ovr_sensitivity_options *options,
                                        ovr_error *err)
{
    if (!c || !options)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_sensitivity *to = ovr_arena_take(&arena, 1, sizeof *to, err);
    working w = {.to = to, .err = err};
    ovr_status status = OVR_NO_MEMORY;
    if (!to)
        return NULL;
    to->arena = arena;
    status = OVR_TAKE(ovr_sensitivity_options, &w.how, options, err);
    w.base = status ? NULL : ovr_case_apart(c, err);
    if (!w.base)
        status = OVR_NO_MEMORY;
    if (!status)
        status = add_keys(&w);
    if (!status)
        status = read_level(&w);
    if (!status)
        status = work(&w);
    ovr_case_free(w.base);
    if (!status)
        return to;
    ovr_sensitivity_free(to);
    return NULL;
}

void ovr_sensitivity_free(ovr_sensitivity *sensitivity)
{
    if (sensitivity) {
        ovr_arena arena = sensitivity->arena;
        ovr_arena_release(&arena);
    }
}

const ovr_sensitivity_row *
ovr_sensitivity_at(const ovr_sensitivity *sensitivity, size_t k)
{
    if (!sensitivity || k >= sensitivity->rows)
        return NULL;
    return &sensitivity->row[k];
}
