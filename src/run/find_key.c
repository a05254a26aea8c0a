/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The value of a key for which a number of the run has a value. */
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/entries.h"
#include "base/error.h"
#include "base/given.h"
#include "base/quantity.h"
#include "case/parameters.h"
#include "mathematics/search.h"
#include "overroll/text.h"
#include "run/comparison.h"
#include "run/find_table.h"
#include "run/trials.h"

enum {
    MAX = 2 * OVR_SEARCH_MAX,
    NAMES = 400,
    TEXT_CAPACITY = 1000,
    QUESTION_MAX = 1 << 20
};

struct ovr_find {
    ovr_arena arena;
    ovr_find_options how;
    ovr_case *base;
    ovr_find_info info;
    double from, to;
    const char *suffix; /* " kN/m", or "" */
    char variant[40];   /* of result files: what differs from the case */
    bool checked;       /* the quantity is one of the runs' */
    ovr_find_evaluation *made;
    ovr_trial answer;
    bool answered;
    ovr_find_table table;
    char message[TEXT_CAPACITY];
};

/* Notes what is to be known beside the answer: said, and kept in its
 * message. */
OVR_PRINTF(2, 3)
static void tell(ovr_find *f, const char *format, ...)
{
    char text[600];
    size_t used = strlen(f->message);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    snprintf(f->message + used, sizeof f->message - used, "%s%s",
             used ? "; " : "", text);
    if (f->how.say)
        f->how.say(f->how.data, OVR_SAY_WARNING, text);
}

/* ---------------------------------------------------------------- reading */

static bool row_of(const char *where, ovr_parameter_info *info)
{
    const char *dot = strrchr(where, '.');
    size_t section = strcspn(where, ". ");
    for (size_t k = 0; dot && k < ovr_parameter_count(); k++) {
        *info = ovr_parameter_at(k);
        if (strlen(info->section) == section &&
            !strncmp(info->section, where, section) &&
            ovr_parameter_is(ovr_parameter_row(k, NULL), dot + 1))
            return true;
    }
    return false;
}

/* The key must be one number, and take both ends. */
static ovr_status take_ends(ovr_find *f, ovr_error *err)
{
    const char *unit[2];
    double end[2];
    ovr_parameter_info row = {.bare = ""};
    bool known = row_of(f->info.key, &row);
    if (known && !strcmp(row.type, "whole number"))
        return ovr_fail_about(err, "key",
                              "%s: whole numbers are tried one by one: use a "
                              "study",
                              f->info.key);
    if (known && strcmp(row.type, "number") != 0)
        return ovr_fail_about(err, "key", "%s is a %s, not a number",
                              f->info.key, row.type);
    for (int k = 0; k < 2; k++) {
        const char *text = k ? f->how.high : f->how.low;
        unit[k] = ovr_amount_read(text, &end[k]);
        if (!unit[k] || !isfinite(end[k]))
            return ovr_fail_about(err, "between",
                                  "%s between '%.60s': a number is needed",
                                  f->info.key, text);
    }
    if (*unit[0] && strcmp(unit[0], unit[1]) != 0)
        return ovr_fail_about(err, "between",
                              "%s between %s and %s: one unit is needed",
                              f->info.key, f->how.low, f->how.high);
    if (!(fabs(end[0] - end[1]) > 0))
        return ovr_fail_about(err, "between",
                              "%s between %s and %s: two numbers are needed",
                              f->info.key, f->how.low, f->how.high);
    f->from = fmin(end[0], end[1]);
    f->to = fmax(end[0], end[1]);
    f->info.unit = *unit[1] || !known ? unit[1] : row.bare;
    char *suffix = ovr_arena_take(&f->arena, strlen(unit[1]) + 2, 1, err);
    if (!suffix)
        return OVR_NO_MEMORY;
    if (*unit[1])
        sprintf(suffix, " %s", unit[1]);
    f->suffix = suffix;
    return OVR_OK;
}

static ovr_status set_key(ovr_find *f, ovr_case *c, double x, ovr_error *err)
{
    char text[120];
    snprintf(text, sizeof text, "%.17g%.60s", x, f->suffix);
    return ovr_case_set(c, f->info.key, text, "between", err);
}

static ovr_status try_ends(ovr_find *f, ovr_error *err)
{
    const double ends[] = {f->from, f->to};
    ovr_case *c = ovr_case_apart(f->base, err);
    ovr_status status = c ? OVR_OK : OVR_BAD_INPUT;
    ovr_case_entry e;
    for (int k = 0; k < 2 && !status; k++)
        status = set_key(f, c, ends[k], err);
    if (!status && !f->info.exact &&
        ovr_case_entry_of(c, "domain.level", strlen("domain.level"), &e) &&
        e.applies && e.text && !strcmp(e.text, "auto"))
        status = ovr_fail_about(err, "level",
                                "level = auto may differ from run to run: "
                                "give a level");
    ovr_case_free(c);
    return status;
}

static ovr_status take_condition(ovr_find *f, ovr_error *err)
{
    const char *which = f->how.which;
    ovr_comparison said;
    if (ovr_comparison_read(f->how.condition, &said, &f->arena, err))
        return OVR_BAD_INPUT;
    f->info.quantity = said.quantity;
    f->info.sense = said.sense;
    f->info.target = said.target;
    if (which && strcmp(which, "largest") != 0 &&
        strcmp(which, "smallest") != 0)
        return ovr_fail_about(err, "which",
                              "'%.40s' must be largest or smallest", which);
    if (which && !said.sense)
        return ovr_fail_about(err, "which",
                              "the %s %s so that %s is a value: say at most or "
                              "at least",
                              which, f->info.key, said.quantity);
    if (!which && said.sense)
        return ovr_fail_about(err, "which",
                              "%s so that %s is at most or at least a value: "
                              "say largest or smallest",
                              f->info.key, said.quantity);
    return OVR_OK;
}

/* --------------------------------------------------------------- quantities */

typedef struct names {
    const char *name[NAMES];
    size_t count;
} names;

static void add_name(names *n, const char *name)
{
    if (name && n->count < NAMES)
        n->name[n->count++] = name;
}

static void add_line(void *data, const ovr_summary_line *line)
{
    add_name(data, line->key);
}

static bool is_there(const names *n, const char *name)
{
    for (size_t k = 0; k < n->count; k++)
        if (!strcmp(n->name[k], name))
            return true;
    return false;
}

static ovr_status no_quantity(const char *quantity, const names *n,
                              ovr_error *err)
{
    const char *meant = ovr_suggest(quantity, n->name, n->count);
    if (!meant)
        return ovr_fail_about(err, "condition", "%s: is no number of this run",
                              quantity);
    ovr_fail_about(err, "condition",
                   "%s: is no number of this run; did you mean %s?", quantity,
                   meant);
    return OVR_BAD_INPUT;
}

/* Looks a quantity up among those of formulas, or one that runs are known to
 * have; a name near to one of them is a slip, anything else the first run
 * tells. */
static ovr_status look_up(ovr_find *f, ovr_error *err)
{
    names scales = {.count = 0}, all;
    const ovr_observable *o;
    ovr_extreme e;
    ovr_setup *setup = ovr_case_resolve(f->base, NULL, NULL);
    if (setup)
        ovr_setup_scales(setup, add_line, &scales);
    all = scales;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        add_name(&all, o->key), add_name(&all, o->key_si);
    for (size_t k = 0; ovr_extreme_at(k, &e); k++) {
        add_name(&all, ovr_arena_text(&f->arena, e.key, NULL));
        add_name(&all, ovr_arena_text(&f->arena, e.key_si, NULL));
    }
    f->info.exact = is_there(&scales, f->info.quantity);
    ovr_setup_free(setup);
    if (!is_there(&all, f->info.quantity) &&
        ovr_suggest(f->info.quantity, all.name, all.count) &&
        !strchr(f->info.quantity, '_'))
        return no_quantity(f->info.quantity, &all, err);
    return OVR_OK;
}

/* The first run says what numbers there are. */
static ovr_status check_quantity(ovr_find *f, const ovr_trial *t,
                                 ovr_error *err)
{
    names n = {.count = 0};
    bool known;
    double value = ovr_trial_number(t, f->info.quantity, &known);
    f->checked = true;
    if (known && isfinite(value))
        return OVR_OK;
    if (known)
        return ovr_fail_about(err, "condition",
                              "%s is not known in this case (null)",
                              f->info.quantity);
    for (size_t k = 0; k < t->lines; k++)
        add_name(&n, t->key[k]);
    return no_quantity(f->info.quantity, &n, err);
}

/* -------------------------------------------------------------- evaluations */

static ovr_find_evaluation *made_at(const ovr_find *f, double x)
{
    for (size_t k = 0; k < f->info.evaluations; k++)
        if (f->made[k].value == x)
            return &f->made[k];
    return NULL;
}

static double quantity_at(const ovr_find *f, double x)
{
    const ovr_find_evaluation *made = made_at(f, x);
    return made ? made->quantity : NAN;
}

static ovr_status keep(ovr_find *f, double x, const ovr_trial *t,
                       ovr_error *err)
{
    ovr_find_evaluation *e = &f->made[f->info.evaluations];
    double order = ovr_trial_number(t, "order", NULL);
    double level = ovr_trial_number(t, "level", NULL);
    double marked = ovr_trial_number(t, "steps_marked", NULL);
    if (f->info.evaluations == MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the search took more than %d evaluations without an "
                        "end: give narrower ends or a larger tolerance",
                        MAX);
    *e = (ovr_find_evaluation){.value = x, .quantity = NAN};
    e->message = "";
    if (t->failed)
        e->message = ovr_arena_text(&f->arena, t->message, err);
    else
        e->quantity = ovr_trial_number(t, f->info.quantity, NULL);
    e->order = isfinite(order) ? (int)order : 0;
    e->level = isfinite(level) ? (int)level : 0;
    e->marked = isfinite(marked) ? (long)marked : 0;
    e->converged = !t->failed && (f->info.exact ||
                                  ovr_trial_number(t, "converged", NULL) > 0);
    e->seconds = ovr_trial_number(t, "seconds", NULL);
    f->info.evaluations++;
    f->info.marked = f->info.marked || e->marked > 0;
    return e->message ? ovr_find_table_add(&f->table, e, err) : OVR_NO_MEMORY;
}

static ovr_trial_plan plan_of(const ovr_find *f)
{
    return (ovr_trial_plan){.workers = f->how.workers,
                            .steady = f->how.steady,
                            .formulas = f->info.exact,
                            .data = f->how.data,
                            .stop = f->how.stop,
                            .run = f->how.run};
}

/* Writes as few digits as give the number back. */
static void put_exact(char *text, size_t capacity, double x)
{
    for (int digits = 6; digits <= 17; digits++) {
        snprintf(text, capacity, "%.*g", digits, x);
        if (strtod(text, NULL) == x)
            return;
    }
}

/* "FOLDER/depth=0.25~um.h5" of a run at x; the level stands in it where it is
 * another one than the case's. */
static const char *result_path(ovr_find *f, double x, ovr_error *err)
{
    const char *dot = strrchr(f->info.key, '.');
    size_t capacity = strlen(f->how.results) + 300;
    char *path = ovr_arena_take(&f->arena, capacity, 1, err);
    char unit[80], number[40];
    if (!path)
        return NULL;
    put_exact(number, sizeof number, x);
    snprintf(unit, sizeof unit, "%s", *f->suffix ? f->suffix + 1 : "");
    for (char *c = unit; *c; c++)
        if (strchr("/ .*^", *c))
            *c = '~';
    snprintf(path, capacity, "%s/%.60s=%s%s%s.h5", f->how.results,
             dot ? dot + 1 : f->info.key, number, unit, f->variant);
    return path;
}

/* Runs of the case at several values. */
static ovr_trials *trials_at(ovr_find *f, size_t n, const double *x,
                             const ovr_trial_plan *as_planned, ovr_error *err)
{
    ovr_case *cases[OVR_SEARCH_MAX] = {NULL};
    const char *files[OVR_SEARCH_MAX];
    ovr_trial_plan with_files = *as_planned, *plan = &with_files;
    ovr_trials *t = NULL;
    size_t made = 0;
    bool good = true;
    for (size_t k = 0; f->how.results && !plan->formulas && k < n; k++) {
        files[k] = result_path(f, x[k], err);
        plan->files = files;
        if (!files[k])
            return NULL;
    }
    while (good && made < n) {
        cases[made] = ovr_case_apart(f->base, err);
        good = cases[made] && !set_key(f, cases[made], x[made], err);
        made += cases[made] != NULL;
    }
    if (good)
        t = ovr_trials_create(n, cases, plan, err);
    for (size_t k = 0; !t && k < made; k++)
        ovr_case_free(cases[k]);
    if (t && ovr_trials_go(t, err)) {
        ovr_trials_free(t);
        return NULL;
    }
    return t;
}

static ovr_status evaluate(void *data, size_t n, const double *x, double *q,
                           ovr_error *err)
{
    ovr_find *f = data;
    const ovr_trial_plan plan = plan_of(f);
    double missing[OVR_SEARCH_MAX];
    size_t count = 0;
    ovr_status status = OVR_OK;
    for (size_t k = 0; k < n; k++)
        if (!made_at(f, x[k]))
            missing[count++] = x[k];
    if (count) {
        ovr_error why = {0};
        ovr_trials *t = trials_at(f, count, missing, &plan, &why);
        if (!t)
            return ovr_fail(err, why.status, "%s", why.message);
        for (size_t k = 0; !status && k < count; k++) {
            const ovr_trial *one = ovr_trials_at(t, k);
            if (!one->failed && !f->checked)
                status = check_quantity(f, one, err);
            if (!status)
                status = keep(f, missing[k], one, err);
        }
        ovr_trials_free(t);
    }
    for (size_t k = 0; !status && k < n; k++)
        q[k] = quantity_at(f, x[k]);
    return status;
}

/* ----------------------------------------------------------------- answers */

static const char *first_failure(const ovr_find *f)
{
    for (size_t k = 0; k < f->info.evaluations; k++)
        if (*f->made[k].message)
            return f->made[k].message;
    return "";
}

static ovr_status fail_missed(const ovr_find *f, const ovr_search_result *r,
                              ovr_error *err)
{
    const ovr_find_info *i = &f->info;
    bool above = i->target > r->maximum, up = above == r->rises;
    const char *failure = first_failure(f);
    char beyond[200] = "";
    if (r->monotone && (above || i->target < r->minimum))
        snprintf(beyond, sizeof beyond, "; it %s with %s: go %s %g%s",
                 r->rises ? "rises" : "falls", i->key, up ? "beyond" : "below",
                 up ? r->to : r->from, f->suffix);
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s is %.6g to %.6g between %g and %g%s: %.6g is not among "
                    "them%s%s%.300s",
                    i->quantity, r->minimum, r->maximum, r->from, r->to,
                    f->suffix, i->target, beyond,
                    *failure ? "; runs failed: " : "", failure);
}

static ovr_status fail_several(const ovr_find *f, const ovr_search_result *r,
                               ovr_error *err)
{
    char places[500] = "";
    size_t used = 0;
    for (size_t k = 0; k < r->places && used < 400; k++)
        used += (size_t)snprintf(places + used, sizeof places - used,
                                 "%s%.4g and %.4g%s", k ? ", " : "",
                                 r->place[k][0], r->place[k][1], f->suffix);
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s is %.6g at %zu places, between %s: give narrower ends, "
                    "or ask for the largest or smallest",
                    f->info.quantity, f->info.target, r->places, places);
}

/* Why there is no answer; OVR_OK: there is one. */
static ovr_status judge(ovr_find *f, const ovr_search_result *r, ovr_error *err)
{
    const ovr_find_info *i = &f->info;
    switch (r->end) {
    case OVR_SEARCH_FOUND: return OVR_OK;
    case OVR_SEARCH_MISSED:
        f->info.end = OVR_FIND_MISSED;
        return fail_missed(f, r, err);
    case OVR_SEARCH_BEYOND:
        f->info.end = OVR_FIND_MISSED;
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s %s %.6g holds at %g%s itself: go %s", i->quantity,
                        i->sense > 0 ? "at least" : "at most", i->target,
                        *i->which == 'l' ? r->to : r->from, f->suffix,
                        *i->which == 'l' ? "beyond" : "below");
    case OVR_SEARCH_SEVERAL:
        f->info.end = OVR_FIND_SEVERAL;
        return fail_several(f, r, err);
    default: break;
    }
    f->info.end = OVR_FIND_FAILED;
    return ovr_fail(err, OVR_NOT_CONVERGED, "%s: %.700s",
                    r->end == OVR_SEARCH_NOTHING
                        ? "all runs failed"
                        : "runs failed where the answer lies",
                    first_failure(f));
}

static void take_result(ovr_find *f, const ovr_search_result *r)
{
    ovr_find_info *i = &f->info;
    double relative = r->scatter / fabs(i->target);
    i->value = r->value;
    i->at_value = r->at_value;
    i->low = r->low;
    i->high = r->high;
    i->slope = r->slope;
    i->scatter = i->exact ? NAN : relative;
    i->monotone = r->monotone;
    if (r->end != OVR_SEARCH_FOUND)
        return;
    i->end = r->scatters ? OVR_FIND_SCATTERED : OVR_FIND_FOUND;
    if (r->from > f->from)
        tell(f, "below %g%s: %.300s", r->from, f->suffix, first_failure(f));
    if (r->to < f->to)
        tell(f, "above %g%s: %.300s", r->to, f->suffix, first_failure(f));
    if (r->places > 1)
        for (size_t k = 0; k < r->places; k++)
            tell(f, "%s passes %g between %.4g and %.4g%s", i->quantity,
                 i->target, r->place[k][0], r->place[k][1], f->suffix);
    else if (!r->monotone)
        tell(f,
             "%s does not go one way between %g and %g%s: there may be "
             "other answers",
             i->quantity, f->from, f->to, f->suffix);
    if (r->scatters)
        tell(f, "%s scatters by %.2g %% from mesh to mesh: %s to %.2g %%",
             i->quantity, 100 * relative, i->key,
             100 * fabs(r->scatter / (r->slope * r->value)));
    if (i->marked)
        tell(f, "some runs have steps accepted above the tolerance");
}

/* Where no order of convergence is seen, or nobody looks for one, the error is
 * the difference that one level coarser makes. */
static double coarser_error(ovr_find *f)
{
    const ovr_trial_plan plan = plan_of(f);
    double level = ovr_trial_number(&f->answer, "level", NULL), q = NAN;
    char text[20];
    ovr_trials *t = NULL;
    if (!(level > 2))
        return NAN;
    snprintf(text, sizeof text, "%d", (int)level - 1);
    snprintf(f->variant, sizeof f->variant, "_level%s", text);
    if (!ovr_case_set(f->base, "domain.level", text, "find", NULL))
        t = trials_at(f, 1, &f->info.value, &plan, NULL);
    if (t && !ovr_trials_at(t, 0)->failed)
        q = ovr_trial_number(ovr_trials_at(t, 0), f->info.quantity, NULL);
    ovr_trials_free(t);
    snprintf(f->variant, sizeof f->variant, "%s",
             f->info.pinned ? "_order2" : "");
    snprintf(text, sizeof text, "%d", (int)level);
    ovr_case_set(f->base, "domain.level", text, "find", NULL);
    if (isfinite(q))
        tell(f,
             "%s falls in no known order with the level: its error is what "
             "one level coarser makes",
             f->info.quantity);
    return fabs((q - f->info.at_value) / f->info.slope);
}

/* The run at the answer once more, with its discretization error; key by key
 * in SI it is that of the number in Hertzian units. */
static ovr_status run_answer(ovr_find *f, ovr_error *err)
{
    ovr_find_info *i = &f->info;
    ovr_trial_plan plan = plan_of(f);
    char key[160], bare[OVR_QUANTITY_CAPACITY];
    ovr_trials *t;
    plan.estimate = !i->exact;
    t = trials_at(f, 1, &i->value, &plan, err);
    if (!t)
        return err ? err->status : OVR_NOT_CONVERGED;
    f->answer = *ovr_trials_at(t, 0);
    f->answered = !f->answer.failed;
    ovr_trials_free(t);
    snprintf(key, sizeof key, "%s_error_relative",
             ovr_quantity_bare(i->quantity, bare));
    i->error = fabs(ovr_trial_number(&f->answer, key, NULL) * i->at_value /
                    i->slope);
    if (!i->exact && isnan(i->error))
        i->error = coarser_error(f);
    if (!i->exact && isnan(i->error))
        tell(f, "the discretization error of %s is not known", i->quantity);
    return OVR_OK;
}

/* True if the solutions have different orders. */
static bool orders_differ(const ovr_find *f)
{
    int minimum = 1000, maximum = 0;
    for (size_t k = 0; k < f->info.evaluations; k++)
        if (!isnan(f->made[k].quantity) && f->made[k].order) {
            minimum = f->made[k].order < minimum ? f->made[k].order : minimum;
            maximum = f->made[k].order > maximum ? f->made[k].order : maximum;
        }
    return minimum < maximum;
}

/* All of order 2 from here on; what is so already stays. */
static ovr_status pin_order(ovr_find *f, ovr_error *err)
{
    size_t kept = 0;
    f->info.pinned = true;
    tell(f, "order = auto came to different orders: all again with order = 2");
    for (size_t k = 0; k < f->info.evaluations; k++)
        if (f->made[k].order == 2)
            f->made[kept++] = f->made[k];
    f->info.evaluations = kept;
    snprintf(f->variant, sizeof f->variant, "_order2");
    return ovr_case_set(f->base, "domain.order", "2", "find", err);
}

static int by_value(const void *a, const void *b)
{
    const ovr_find_evaluation *p = a, *q = b;
    return (p->value > q->value) - (p->value < q->value);
}

ovr_status ovr_find_go(ovr_find *f, ovr_error *err)
{
    ovr_search_result r;
    ovr_status status;
    if (!f)
        return ovr_fail_null(err, __func__);
    const size_t workers = f->how.workers > 1 ? (size_t)f->how.workers : 1;
    const ovr_search search = {
        .from = f->from,
        .to = f->to,
        .target = f->info.target,
        .sense = f->info.sense,
        .which = !f->info.which          ? 0
                 : *f->info.which == 'l' ? 1
                                         : -1,
        .tolerance = f->info.exact          ? 1e-12
                     : f->how.tolerance > 0 ? f->how.tolerance
                                            : 1e-3,
        .scan = workers > OVR_SEARCH_SCAN ? workers : OVR_SEARCH_SCAN,
        .exact = f->info.exact,
        .evaluate = evaluate,
        .data = f};
    status = ovr_search_run(&search, &r, err);
    if (!status && !f->info.pinned && orders_differ(f) &&
        !(status = pin_order(f, err)))
        status = ovr_search_run(&search, &r, err);
    if (!status) {
        take_result(f, &r);
        status = judge(f, &r, err);
        if (!status)
            status = run_answer(f, err);
        else if (err)
            snprintf(f->message, sizeof f->message, "%.*s",
                     (int)sizeof f->message - 1, err->message);
    } else {
        f->info.end = OVR_FIND_FAILED;
    }
    qsort(f->made, f->info.evaluations, sizeof *f->made, by_value);
    return status;
}

/* ----------------------------------------------------------------- making */

static ovr_status take_options(ovr_find *f, const ovr_find_options *options,
                               ovr_error *err)
{
    ovr_find_options *o = &f->how;
    const char **const texts[] = {&o->key,       &o->low,   &o->high,
                                  &o->condition, &o->which, &o->table,
                                  &o->results};
    if (OVR_TAKE(ovr_find_options, o, options, err))
        return OVR_BAD_INPUT;
    if (!o->key || !o->low || !o->high || !o->condition)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "find needs a key, both ends and a condition");
    if (o->tolerance != 0 && !(o->tolerance >= 1e-9 && o->tolerance <= 0.5))
        return ovr_fail_about(err, "tolerance",
                              "tolerance: must be 1e-9 to 0.5");
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        if (*texts[k] &&
            !(*texts[k] = ovr_arena_text(&f->arena, *texts[k], err)))
            return OVR_NO_MEMORY;
    return OVR_OK;
}

/* The case and what is asked, as it lies beside the results. */
static char *question_of(ovr_find *f, ovr_error *err)
{
    const ovr_find_options *o = &f->how;
    const char *text = ovr_case_text(f->base, err);
    size_t capacity = (text ? strlen(text) : 0) + 2000;
    char *all = text ? ovr_arena_take(&f->arena, capacity, 1, err) : NULL;
    if (all)
        snprintf(all, capacity,
                 "%s# find %.20s %.300s between %.100s and %.100s so that "
                 "%.400s%s\n",
                 text, o->which ? o->which : "", o->key, o->low, o->high,
                 o->condition, o->steady ? ", steady" : "");
    return all;
}

/* The folder of results, which holds those of one question only. */
static ovr_status open_results(ovr_find *f, ovr_error *err)
{
    const char *folder = f->how.results;
    size_t capacity = strlen(folder) + 40;
    char *path = ovr_arena_take(&f->arena, capacity, 1, err);
    char *table = ovr_arena_take(&f->arena, capacity, 1, err);
    char *asked = path && table ? question_of(f, err) : NULL;
    const char *found = NULL;
    if (!asked)
        return OVR_NO_MEMORY;
    snprintf(path, capacity, "%s/question.ini", folder);
    snprintf(table, capacity, "%s/find.csv", folder);
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        return ovr_fail_about(err, "results", "%s: cannot be made: %s", folder,
                              strerror(errno));
    if (access(path, F_OK) == 0) {
        found = ovr_text_file(path, "question", QUESTION_MAX, &f->arena, err);
        if (!found)
            return OVR_BAD_INPUT;
        if (strcmp(found, asked) != 0)
            return ovr_fail_about(err, "results",
                                  "%s: holds the results of another question "
                                  "or case (question.ini): give another folder",
                                  folder);
    } else {
        FILE *to = fopen(path, "w");
        bool good = to && fputs(asked, to) >= 0;
        if (to && fclose(to) != 0)
            good = false;
        if (!good)
            return ovr_fail_about(err, "results", "%s: cannot be written: %s",
                                  path, strerror(errno));
    }
    if (!f->how.table) {
        f->how.table = table;
        f->how.go_on = true;
    }
    return OVR_OK;
}

static ovr_status prepare(ovr_find *f, ovr_case *c,
                          const ovr_find_options *options, ovr_error *err)
{
    ovr_find_info *i = &f->info;
    ovr_status status = take_options(f, options, err);
    *i = (ovr_find_info){.message = f->message};
    i->value = i->at_value = i->low = i->high = NAN;
    i->slope = i->error = i->scatter = NAN;
    i->key = f->how.key;
    i->which = f->how.which;
    if (status)
        return status;
    f->made = ovr_arena_take(&f->arena, MAX, sizeof *f->made, err);
    f->base = f->made ? ovr_case_apart(c, err) : NULL;
    if (!f->base)
        return OVR_NO_MEMORY;
    if (take_ends(f, err) || take_condition(f, err) || look_up(f, err) ||
        try_ends(f, err))
        return OVR_BAD_INPUT;
    if (f->how.results && open_results(f, err))
        return OVR_BAD_INPUT;
    if (!f->how.table)
        return OVR_OK;
    f->table = (ovr_find_table){
        .path = f->how.table, .made = f->made, .maximum = MAX};
    status = ovr_find_table_open(&f->table, f->how.go_on, &f->arena, err);
    i->evaluations = f->table.count;
    for (size_t k = 0; k < i->evaluations; k++)
        i->marked = i->marked || f->made[k].marked > 0;
    return status;
}

ovr_find *ovr_find_create(ovr_case *c, const ovr_find_options *options,
                          ovr_error *err)
{
    if (!c || !options)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_find *f = ovr_arena_take(&arena, 1, sizeof *f, err);
    if (!f)
        return NULL;
    f->arena = arena;
    f->table.file = NULL;
    if (prepare(f, c, options, err)) {
        ovr_find_free(f);
        return NULL;
    }
    return f;
}

void ovr_find_free(ovr_find *find)
{
    if (!find)
        return;
    ovr_find_table_close(&find->table);
    ovr_case_free(find->base);
    ovr_arena arena = find->arena;
    ovr_arena_release(&arena);
}

const ovr_find_info *ovr_find_about(const ovr_find *find)
{
    if (!find)
        return NULL;
    return &find->info;
}

ovr_find_evaluation ovr_find_evaluation_at(const ovr_find *find, size_t k)
{
    const ovr_find_evaluation none = {
        .value = NAN, .quantity = NAN, .seconds = NAN, .message = ""};
    return find && k < find->info.evaluations ? find->made[k] : none;
}

void ovr_find_summary(const ovr_find *find, ovr_summary_taker *take, void *data)
{
    if (!find || !take || !find->answered)
        return;
    for (size_t k = 0; k < find->answer.lines; k++) {
        const ovr_summary_line line = {.key = find->answer.key[k],
                                       .number = find->answer.number[k]};
        take(data, &line);
    }
}
