/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the value of a key for which a number of the run reaches a target. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/given.h"
#include "run/find.h"

/* Prints a note and appends it to the message of the answer. */
OVR_PRINTF(2, 3)
static void add_note(ovr_find *f, const char *format, ...)
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
        f->how.say(f->how.data, OVR_MESSAGE_WARNING, text);
}

/* Notes that a quantity of a run in time is its value at the end, if the run
 * has also the extreme of that quantity. */
static void note_end(const ovr_find *f, const ovr_trial *t)
{
    const char *asked = f->info.quantity;
    const ovr_observable *o;
    ovr_extreme e;
    char text[400];
    for (size_t k = 0; (o = ovr_observable_at(k)); k++) {
        const size_t length = o->key ? strlen(o->key) : 0;
        const bool si = o->key_si && !strcmp(o->key_si, asked);
        bool known = false;
        if (!length || (!si && strcmp(o->key, asked) != 0))
            continue;
        for (size_t j = 0; ovr_extreme_at(j, &e); j++) {
            const char *whole = si ? e.key_si : e.key;
            if (strncmp(e.key, o->key, length) != 0 ||
                strcmp(e.key + length, "_overall") != 0)
                continue;
            ovr_trial_number(t, whole, &known);
            snprintf(text, sizeof text,
                     "%.60s is the value at the end of the run; %.60s is the "
                     "%.160s",
                     asked, whole, e.long_name);
            if (known && f->how.say)
                f->how.say(f->how.data, OVR_MESSAGE_NOTE, text);
        }
    }
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
    if (f->info.evaluations == OVR_FIND_MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the search did not end within %d evaluations; use a "
                        "narrower range or a larger tolerance",
                        OVR_FIND_MAX);
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

/* Writes a number with the fewest digits that reproduce it exactly. */
static void write_exact(char *text, size_t capacity, double x)
{
    for (int digits = 6; digits <= 17; digits++) {
        snprintf(text, capacity, "%.*g", digits, x);
        if (strtod(text, NULL) == x)
            return;
    }
}

/* Returns the path of the result of a run at x, "FOLDER/depth=0.25~um.h5". The
 * name contains the level if it differs from that of the case. */
static const char *result_path(ovr_find *f, double x, ovr_error *err)
{
    const char *dot = strrchr(f->info.key, '.');
    size_t capacity = strlen(f->how.results) + 300;
    char *path = ovr_arena_take(&f->arena, capacity, 1, err);
    char unit[80], number[40];
    if (!path)
        return NULL;
    write_exact(number, sizeof number, x);
    snprintf(unit, sizeof unit, "%s", *f->suffix ? f->suffix + 1 : "");
    for (char *c = unit; *c; c++)
        if (strchr("/ .*^", *c))
            *c = '~';
    snprintf(path, capacity, "%s/%.60s=%s%s%s.h5", f->how.results,
             dot ? dot + 1 : f->info.key, number, unit, f->variant);
    return path;
}

/* Creates trials of the case at n values of the key. */
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
        good = cases[made] && !ovr_find_set(f, cases[made], x[made], err);
        made += cases[made] != NULL;
    }
    if (good)
        t = ovr_trials_create(n, cases, plan, err);
    for (size_t k = 0; !t && k < made; k++)
        ovr_case_free(cases[k]);
    if (t && ovr_trials_execute(t, err)) {
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
            if (!one->failed && !f->checked) {
                status = ovr_find_check(f, one, err);
                if (!status)
                    note_end(f, one);
            }
            if (!status)
                status = keep(f, missing[k], one, err);
        }
        ovr_trials_free(t);
    }
    for (size_t k = 0; !status && k < n; k++)
        q[k] = quantity_at(f, x[k]);
    return status;
}

/* ----------------------------------------------------------------- results */

static const char *first_failure(const ovr_find *f)
{
    for (size_t k = 0; k < f->info.evaluations; k++)
        if (*f->made[k].message)
            return f->made[k].message;
    return "";
}

/* Writes what to change if the target is beyond the values of a monotonic
 * quantity. A range that would have to be several times as long is not
 * proposed. */
static void write_remedy(const ovr_find *f, const ovr_search_result *r,
                         char *to, size_t size)
{
    const ovr_find_info *i = &f->info;
    const bool above = i->target > r->maximum, up = above == r->rises;
    const double gap = above ? i->target - r->maximum : r->minimum - i->target;
    *to = '\0';
    if (!r->monotone || !(gap > 0))
        return;
    if (gap > 3 * (r->maximum - r->minimum))
        snprintf(to, size,
                 "; it hardly changes with %s: change the limit or vary "
                 "another key",
                 i->key);
    else
        snprintf(to, size,
                 "; it %s with %s: extend the range %s %g%s, or change the "
                 "limit",
                 r->rises ? "rises" : "falls", i->key, up ? "above" : "below",
                 up ? r->to : r->from, f->suffix);
}

static ovr_status fail_missed(const ovr_find *f, const ovr_search_result *r,
                              ovr_error *err)
{
    const ovr_find_info *i = &f->info;
    const double first = quantity_at(f, r->from), last = quantity_at(f, r->to);
    const char *failure = first_failure(f);
    char remedy[300], between[80] = "";
    write_remedy(f, r, remedy, sizeof remedy);
    if (!r->monotone)
        snprintf(between, sizeof between, ", %.6g to %.6g between them",
                 r->minimum, r->maximum);
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s is %.6g at %g%s and %.6g at %g%s%s; it does not "
                    "reach %.6g%s%s%.300s",
                    i->quantity, first, r->from, f->suffix, last, r->to,
                    f->suffix, between, i->target, remedy,
                    *failure ? "; the first run that failed: " : "", failure);
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
                    "%s is %.6g at %zu values, between %s; use a narrower "
                    "range, or 'largest' or 'smallest'",
                    f->info.quantity, f->info.target, r->places, places);
}

/* Returns an error with the reason if there is no answer. */
static ovr_status check_answer(ovr_find *f, const ovr_search_result *r,
                               ovr_error *err)
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
                        "the condition %s %s %.6g already holds at %g%s; "
                        "extend the range %s it",
                        i->quantity, i->sense > 0 ? "at least" : "at most",
                        i->target, *i->which == 'l' ? r->to : r->from,
                        f->suffix, *i->which == 'l' ? "above" : "below");
    case OVR_SEARCH_SEVERAL:
        f->info.end = OVR_FIND_SEVERAL;
        return fail_several(f, r, err);
    default: break;
    }
    f->info.end = OVR_FIND_FAILED;
    return ovr_fail(err, OVR_NOT_CONVERGED, "%s: %.700s",
                    r->end == OVR_SEARCH_NOTHING
                        ? "all runs failed"
                        : "runs failed near the answer",
                    first_failure(f));
}

static void store_result(ovr_find *f, const ovr_search_result *r)
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
        add_note(f, "below %g%s: %.300s", r->from, f->suffix, first_failure(f));
    if (r->to < f->to)
        add_note(f, "above %g%s: %.300s", r->to, f->suffix, first_failure(f));
    if (r->places > 1)
        for (size_t k = 0; k < r->places; k++)
            add_note(f, "%s passes %g between %.4g and %.4g%s", i->quantity,
                     i->target, r->place[k][0], r->place[k][1], f->suffix);
    else if (!r->monotone)
        add_note(f,
                 "%s is not monotonic between %g and %g%s; other answers may "
                 "exist",
                 i->quantity, f->from, f->to, f->suffix);
    if (r->scatters)
        add_note(f,
                 "%s varies by %.2g %% from grid to grid, which limits %s to "
                 "%.2g %%",
                 i->quantity, 100 * relative, i->key,
                 100 * fabs(r->scatter / (r->slope * r->value)));
    if (i->marked)
        add_note(f, "some runs have steps accepted above the tolerance");
}

/* Returns the difference from one level coarser as the error, if no order of
 * convergence was observed or requested. */
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
        add_note(f,
                 "%s does not converge with a known order; its error is the "
                 "difference from one level coarser",
                 f->info.quantity);
    return fabs((q - f->info.at_value) / f->info.slope);
}

/* Repeats the run at the answer and estimates its discretization error. The
 * error of a number in SI is that of the same number in Hertzian units. */
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
        add_note(f, "the discretization error of %s is unknown", i->quantity);
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

/* Sets order 2 for all further runs. Evaluations of order 2 are kept. */
static ovr_status pin_order(ovr_find *f, ovr_error *err)
{
    size_t kept = 0;
    f->info.pinned = true;
    add_note(f,
             "order = auto chose different orders; all runs are repeated with "
             "order = 2");
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

ovr_status ovr_find_execute(ovr_find *f, ovr_error *err)
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
        store_result(f, &r);
        status = check_answer(f, &r, err);
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

/* ------------------------------------------------------------------ access */

const ovr_find_info *ovr_find_get_info(const ovr_find *find)
{
    return find ? &find->info : NULL;
}

ovr_find_evaluation ovr_find_evaluation_at(const ovr_find *find, size_t k)
{
    const ovr_find_evaluation none = {
        .value = NAN, .quantity = NAN, .seconds = NAN, .message = ""};
    return find && k < find->info.evaluations ? find->made[k] : none;
}

static void report_search(const ovr_find_info *i, ovr_summary_taker *take,
                          void *data)
{
    const bool found = i->end == OVR_FIND_FOUND || i->end == OVR_FIND_SCATTERED;
    const char *relation = !i->sense      ? "is"
                           : i->sense > 0 ? "at least"
                                          : "at most";
    const ovr_summary_line lines[] = {
        {.key = "key", .form = OVR_SUMMARY_TEXT, .text = i->key},
        {.key = "value", .number = i->value},
        {.key = "unit", .form = OVR_SUMMARY_TEXT, .text = i->unit},
        {.key = "low", .number = i->low},
        {.key = "high", .number = i->high},
        {.key = "quantity", .form = OVR_SUMMARY_TEXT, .text = i->quantity},
        {.key = "relation", .form = OVR_SUMMARY_TEXT, .text = relation},
        {.key = "which", .form = OVR_SUMMARY_TEXT, .text = i->which},
        {.key = "target", .number = i->target},
        {.key = "at_value", .number = i->at_value},
        {.key = "slope", .number = i->slope},
        {.key = "key_error_discretization", .number = i->error},
        {.key = "scatter", .number = i->scatter},
        {.key = "monotone", .form = OVR_SUMMARY_FLAG, .number = i->monotone},
        {.key = "order_pinned", .form = OVR_SUMMARY_FLAG, .number = i->pinned},
        {.key = "found", .form = OVR_SUMMARY_FLAG, .number = found},
        {.key = "message", .form = OVR_SUMMARY_TEXT, .text = i->message}};
    for (size_t k = 0; k < sizeof lines / sizeof *lines; k++)
        take(data, &lines[k]);
}

void ovr_find_summary(const ovr_find *find, bool answer,
                      ovr_summary_taker *take, void *data)
{
    if (!find || !take)
        return;
    if (!answer) {
        report_search(&find->info, take, data);
        return;
    }
    const ovr_summary_line found = {.key = find->info.key,
                                    .number = find->info.value};
    take(data, &found);
    for (size_t k = 0; find->answered && k < find->answer.lines; k++) {
        const ovr_summary_line line = {.key = find->answer.key[k],
                                       .number = find->answer.number[k]};
        take(data, &line);
    }
}
