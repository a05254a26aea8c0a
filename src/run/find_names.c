/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks before anything is solved that the quantity of a search is a number of
 * its runs. The names are taken from the summary of a run without solution. */
#include <math.h>
#include <string.h>

#include "base/entries.h"
#include "base/error.h"
#include "overroll/text.h"
#include "physics/mixed/mixed.h"
#include "run/find.h"
#include "run/internal.h"
#include "simulation/internal.h"

enum { NAMES = 1200 };

typedef struct names {
    const char *name[NAMES];
    size_t count;
    ovr_arena *arena;
} names;

static void add_name(names *n, const char *name)
{
    if (name && n->count < NAMES)
        n->name[n->count++] = name;
}

/* Adds the key of a number. Keys may be temporary. */
static void add_line(void *data, const ovr_summary_line *line)
{
    names *n = data;
    if (line->key && line->form <= OVR_SUMMARY_FLAG)
        add_name(n, ovr_arena_text(n->arena, line->key, NULL));
}

static bool is_there(const names *n, const char *name)
{
    for (size_t k = 0; k < n->count; k++)
        if (!strcmp(n->name[k], name))
            return true;
    return false;
}

/* Returns the longest name with which the word begins ("H_min" of
 * "H_minimum"), or NULL. Shorter names than 4 characters do not count. */
static const char *beginning(const char *word, const names *n)
{
    const char *longest = NULL;
    size_t most = 3;
    for (size_t k = 0; k < n->count; k++) {
        size_t size = strlen(n->name[k]);
        if (size > most && !strncmp(word, n->name[k], size)) {
            longest = n->name[k];
            most = size;
        }
    }
    return longest;
}

/* Returns the extreme over the run of a quantity, "H_min_overall", or NULL. */
static const char *extreme_of(const char *quantity, const names *n)
{
    size_t size = strlen(quantity);
    for (size_t k = 0; k < n->count; k++)
        if (!strncmp(n->name[k], quantity, size) &&
            !strcmp(n->name[k] + size, "_overall"))
            return n->name[k];
    return NULL;
}

/* Reports an unknown quantity. A quantity of other cases has a full name.
 * Suggests a similar name; of a quantity that has an extreme over the run,
 * both. */
static ovr_status fail_unknown(const char *quantity, const names *n,
                               ovr_error *err)
{
    const char *meant = ovr_suggest(quantity, n->name, n->count), *extreme;
    const ovr_quantity_name name = ovr_quantity_named(quantity);
    if (strcmp(name.text, quantity) != 0)
        return ovr_fail_about(err, "condition",
                              "%s: is not a result of this run; %s needs "
                              "another section in the case",
                              quantity, name.text);
    if (!meant)
        meant = beginning(quantity, n);
    extreme = meant ? extreme_of(meant, n) : NULL;
    if (extreme)
        return ovr_fail_about(err, "condition",
                              "%s: is not a result of this run; did you mean "
                              "%s, or %s (at the end of the run)?",
                              quantity, extreme, meant);
    if (meant)
        return ovr_fail_about(err, "condition",
                              "%s: is not a result of this run; did you mean "
                              "%s?",
                              quantity, meant);
    return ovr_fail_about(err, "condition",
                          "%s: is not a result of this run; 'overroll run "
                          "CASE --json' prints all names",
                          quantity);
}

/* Creates a run at an end of the range, without files. */
static ovr_run *create_run(const ovr_find *f, ovr_case **c)
{
    const double ends[] = {f->from, f->to};
    ovr_run_options how = {0};
    ovr_run *run = NULL;
    how.steady = f->how.steady;
    how.no_thread = true;
    for (int k = 0; k < 2 && !run; k++) {
        ovr_case_free(*c);
        *c = ovr_case_apart(f->base, NULL);
        if (*c && !ovr_find_set(f, *c, ends[k], NULL))
            run = ovr_run_unsolved(*c, &how, NULL);
    }
    return run;
}

static bool has_boundary(const ovr_setup *setup)
{
    const ovr_boundary_form *form = ovr_setup_form(setup, "boundary");
    return form && form->law;
}

/* Checks that the case has the roughness that a lambda ratio needs. */
static ovr_status check_roughness(const ovr_run *run, const char *quantity,
                                  ovr_error *err)
{
    const bool whole = !strcmp(quantity, "lambda_ratio") ||
                       !strcmp(quantity, "lambda_ratio_at_H_min");
    const bool on_grid = run->sim->shapes.roughness > 0;
    if (on_grid || (whole && run->setup->Rq > 0))
        return OVR_OK;
    if (whole && !has_boundary(run->setup))
        return ovr_fail_about(err, "condition",
                              "%s needs the roughness of the surfaces; set "
                              "contact.Rq_1 and contact.Rq_2",
                              quantity);
    if (!whole && !strcmp(quantity, "lambda_ratio_min"))
        return ovr_fail_about(err, "condition",
                              "%s needs roughness on the grid ([feature] with "
                              "shape = roughness, profile, areal or wave); for "
                              "contact.Rq_1 and contact.Rq_2 use lambda_ratio",
                              quantity);
    return OVR_OK;
}

ovr_status ovr_find_quantity(ovr_find *f, const char *quantity, ovr_error *err)
{
    names scales = {.arena = &f->arena}, all;
    ovr_case *c = NULL;
    ovr_status status = OVR_OK;
    ovr_setup *setup = ovr_case_resolve(f->base, NULL, NULL);
    if (setup)
        ovr_setup_scales(setup, add_line, &scales);
    ovr_setup_free(setup);
    f->info.exact = is_there(&scales, quantity);
    if (f->info.exact || f->how.run)
        return OVR_OK;
    ovr_run *run = create_run(f, &c);
    if (run) {
        all = scales;
        ovr_run_keys(&run->info, add_line, &all);
        status = is_there(&all, quantity) ? check_roughness(run, quantity, err)
                                          : fail_unknown(quantity, &all, err);
    }
    ovr_run_free(run);
    ovr_case_free(c);
    return status;
}

ovr_status ovr_find_check(ovr_find *f, const ovr_trial *t, ovr_error *err)
{
    names n = {.count = 0};
    bool known;
    double value = ovr_trial_number(t, f->info.quantity, &known);
    f->checked = true;
    if (known && isfinite(value))
        return OVR_OK;
    if (known)
        return ovr_fail_about(err, "condition",
                              "%s is unknown in this case (null in --json)",
                              f->info.quantity);
    for (size_t k = 0; k < t->lines; k++)
        add_name(&n, t->key[k]);
    return fail_unknown(f->info.quantity, &n, err);
}
