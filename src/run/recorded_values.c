/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A run goes on as it began: keys that its case does not give have the values
 * that its file recorded, not today's defaults, and a key that the file does
 * not know means what the program did then.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/case.h"
#include "case/resolve.h"
#include "contact/film_formula.h"
#include "run/internal.h"

enum { NAME_CAPACITY = 512 };

/* What the program did before it had a key. */
static const struct {
    const char *name, *text;
} once[] = {{"domain.order", "2"},
            {"time.scheme", "upstream2"},
            {"time.step", "grid"},
            {"domain.faces", "arithmetic"}};

/* The first section is that of the key today; it may be recorded under the one
 * it once belonged to. */
static const struct {
    const char *now, *before;
} sections[] = {{"paper.", "solver."}};

static const char *in_list(const ovr_restart_info *of, const char *name)
{
    for (size_t k = 0; k < of->value_count; k++)
        if (!strcmp(of->values[k].name, name))
            return of->values[k].text;
    return NULL;
}

static bool is_in_list(const ovr_restart_info *of, const char *name,
                       const char *text)
{
    const char *found = in_list(of, name);
    return found && !strcmp(found, text);
}

/* True if a key was left to a version that knew no other mean between nodes
 * than the arithmetic one: 0.2.0 or before. */
static bool was_auto(const ovr_restart_info *of, const char *name)
{
    return is_in_list(of, name, "auto") && !in_list(of, "domain.faces");
}

/* `auto` chose second order then, with heat or mass-conserving cavitation. */
static const char *order_once(const ovr_restart_info *of)
{
    if (was_auto(of, "domain.order") &&
        (is_in_list(of, "heat.model", "lobatto") ||
         is_in_list(of, "cavitation.model", "conserving")))
        return "2";
    return in_list(of, "domain.order");
}

/* The scheme that `auto` chose then had separate terms under histories, with
 * heat or mass-conserving cavitation. */
static const char *scheme_once(const ovr_restart_info *of)
{
    static const char *const histories[] = {
        "load.history", "speed.history", "radius.history", "radius_1.history"};
    const char *text = in_list(of, "time.scheme");
    if (!was_auto(of, "time.scheme"))
        return text;
    if (is_in_list(of, "heat.model", "lobatto") ||
        is_in_list(of, "cavitation.model", "conserving"))
        return "upstream2";
    for (size_t k = 0; k < sizeof histories / sizeof *histories; k++) {
        const char *history = in_list(of, histories[k]);
        if (history && strcmp(history, "constant") != 0)
            return "upstream2";
    }
    return text;
}

static const char *recorded(const ovr_restart_info *of, const char *name,
                            const char *former)
{
    const char *text = !strcmp(name, "time.scheme")    ? scheme_once(of)
                       : !strcmp(name, "domain.order") ? order_once(of)
                                                       : in_list(of, name);
    for (size_t k = 0; !text && k < sizeof sections / sizeof *sections; k++) {
        size_t length = strlen(sections[k].now);
        char before[NAME_CAPACITY];
        if (strncmp(name, sections[k].now, length) != 0)
            continue;
        int capacity = snprintf(before, sizeof before, "%s%s",
                                sections[k].before, name + length);
        text = capacity < NAME_CAPACITY ? in_list(of, before) : NULL;
    }
    if (!text && former)
        text = in_list(of, former);
    for (size_t k = 0; !text && k < sizeof once / sizeof *once; k++)
        if (!strcmp(name, once[k].name))
            text = once[k].text;
    return text;
}

static void put_name(const ovr_case_entry *e, const char *key,
                     char name[NAME_CAPACITY])
{
    snprintf(name, NAME_CAPACITY, e->name ? "%s %s.%s" : "%s%s.%s", e->section,
             e->name ? e->name : "", key);
}

ovr_status ovr_recorded_values(ovr_case *c, const ovr_restart_info *of,
                               const char *path, ovr_error *err)
{
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry e = ovr_case_entry_at(c, k);
        const char *old = ovr_parameter_row(e.parameter, NULL)->once;
        char name[NAME_CAPACITY], former[NAME_CAPACITY];
        if (e.given)
            continue;
        put_name(&e, e.key, name);
        put_name(&e, old ? old : e.key, former);
        const char *text = recorded(of, name, old ? former : NULL);
        if (text && (!e.text || strcmp(text, e.text) != 0) &&
            ovr_case_set(c, name, text, path, err))
            return OVR_BAD_INPUT;
    }
    ovr_case_mark_stored(c);
    return OVR_OK;
}

/* Version 0.1.0 took this for inlet = auto. */
static double inlet_once(const ovr_contact *contact)
{
    double H = ovr_film_central_moes(contact->M, contact->L), X_a = -2, s, loss;
    do {
        s = sqrt(2 * H) / fabs(X_a);
        loss = fmax(pow(s, 2.5), 2 * s * s * H * H / (1 + H * H));
        X_a *= loss > 1e-3 ? 1.02 : 1;
    } while (loss > 1e-3);
    return X_a;
}

void ovr_recorded_domain(ovr_setup *setup, const ovr_restart_info *of)
{
    ovr_options *o = setup->options;
    ((ovr_resolved *)setup)->recorded = true;
    if (!of->has_state)
        return;
    if (of->level > 0) {
        o->inlet = of->inlet;
        o->outlet = of->outlet;
        o->level = of->level;
    } else if (isnan(o->inlet)) {
        o->inlet = inlet_once(setup->contact);
    }
}
