/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keeps of the quantities over a whole run, step by step: extremes, with where
 * and when, and means.  The row of a quantity selects what is stored. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "simulation/internal.h"
#include "simulation/observe.h"

/* A member that is a double, of an observation or what has its members. */
static double *member(ovr_observation *of, size_t offset)
{
    return (double *)(void *)((char *)of + offset);
}

static double number(const ovr_observation *of, size_t offset)
{
    return *(const double *)(const void *)((const char *)of + offset);
}

/* What was not known until now is kept as it is. */
static bool is_beyond(ovr_sense what, double value, double kept)
{
    if (isnan(kept))
        return !isnan(value);
    switch (what) {
    case OVR_SMALLEST: return value < kept;
    case OVR_LARGEST: return value > kept;
    default: return fabs(value) > fabs(kept);
    }
}

static void take_extreme(ovr_statistics *s, const ovr_observable *row,
                         const ovr_observation *o, bool first)
{
    double value = number(o, row->offset);
    if (!first &&
        !is_beyond(row->extreme, value, number(&s->extreme, row->offset)))
        return;
    *member(&s->extreme, row->offset) = value;
    *member(&s->when, row->offset) = o->T;
    *member(&s->where, row->offset) = row->place ? number(o, row->place) : NAN;
}

/* `part` of the time up to now is the step's. */
static void take_mean(ovr_statistics *s, const ovr_observable *row,
                      const ovr_observation *o, double part)
{
    double *mean = member(&s->mean, row->offset);
    double value = number(o, row->offset);
    if (part > 0)
        *mean = part < 1 ? *mean + part * (value - *mean) : value;
}

/* A value is weighted by the preceding step, or the start value before the
 * first step. Repeated observations of a continued run are ignored. */
void ovr_statistics_take(ovr_statistics *s, const ovr_observation *o,
                         bool first)
{
    double part = first ? 1 : (o->T - s->averaged) / o->T;
    const ovr_observable *row;
    for (size_t k = 0; (row = ovr_observable_at(k)); k++) {
        if (row->extreme_key)
            take_extreme(s, row, o, first);
        if (row->mean_key)
            take_mean(s, row, o, part);
    }
    s->averaged = o->T;
    if (s->when.H_min_located == o->T)
        s->H_mean_at_H_min = o->H_mean;
    if (s->when.P_max == o->T)
        s->P_max_unresolved = !o->P_max_resolved;
}

void ovr_statistics_unknown(ovr_statistics *s)
{
    ovr_extreme e;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        *ovr_kept_number(&e, s) = NAN;
}

/* ------------------------------------------------------------------- list */

#define PUT(text, ...) snprintf(text, sizeof(text), __VA_ARGS__)

/* The length of "P_max" in "P_max_overall". */
static int stem(const char *key)
{
    const char *end = strstr(key, "_overall");
    return (int)(end && end != key && !end[8] ? (size_t)(end - key)
                                              : strlen(key));
}

/* True if `name` begins with `word`, so that the word need not be added. */
static bool begins(const char *name, const char *word)
{
    return !strncmp(name, word, strlen(word));
}

/* Writes the label: "minimum film thickness" of the quantity of that name,
 * "maximum asperity load share", "mean central film thickness". */
static void label(const ovr_observable *row, ovr_kept_part part,
                  ovr_extreme *to)
{
    static const char *const senses[] = {[OVR_SMALLEST] = "minimum ",
                                         [OVR_LARGEST] = "maximum ",
                                         [OVR_OF_MAGNITUDE] = "largest "};
    const char *word = part == OVR_KEPT_MEAN ? "mean " : senses[row->extreme];
    PUT(to->label, "%s%s", begins(row->long_name, word) ? "" : word,
        row->long_name);
}

/* Writes the key of a part that is kept, from the key of the extreme or the
 * mean, and its name. */
static void name(const ovr_observable *row, ovr_kept_part part, ovr_extreme *to)
{
    const char *key = row->extreme_key, *suffix;
    *to = (ovr_extreme){.kind = row->kind, .part = part, .of = row};
    label(row, part, to);
    PUT(to->long_name, "%s%s over the run",
        part == OVR_KEPT_PLACE  ? "position of the "
        : part == OVR_KEPT_TIME ? "time of the "
                                : "",
        to->label);
    switch (part) {
    case OVR_KEPT_EXTREME: PUT(to->key, "%s", key); break;
    case OVR_KEPT_PLACE:
        to->kind = OVR_KIND_LENGTH;
        PUT(to->key, "X_%s", key);
        break;
    case OVR_KEPT_TIME:
        to->kind = OVR_KIND_TIME;
        PUT(to->key, "T_%.*s", stem(key), key);
        break;
    case OVR_KEPT_MEAN: PUT(to->key, "%s", row->mean_key);
    }
    suffix = ovr_kind_about(to->kind)->suffix;
    if (*suffix)
        PUT(to->key_si, "%s%s", to->key, suffix);
}

static bool is_kept(const ovr_observable *row, ovr_kept_part part)
{
    switch (part) {
    case OVR_KEPT_PLACE: return row->extreme_key && row->place;
    case OVR_KEPT_MEAN: return row->mean_key != NULL;
    default: return row->extreme_key != NULL;
    }
}

bool ovr_extreme_at(size_t k, ovr_extreme *to)
{
    const ovr_observable *row;
    for (size_t r = 0; to && (row = ovr_observable_at(r)); r++)
        for (int part = OVR_KEPT_EXTREME; part <= OVR_KEPT_MEAN; part++)
            if (is_kept(row, (ovr_kept_part)part) && k-- == 0) {
                name(row, (ovr_kept_part)part, to);
                return true;
            }
    return false;
}

double *ovr_kept_number(const ovr_extreme *which, ovr_statistics *of)
{
    ovr_observation *const in[] = {[OVR_KEPT_EXTREME] = &of->extreme,
                                   [OVR_KEPT_PLACE] = &of->where,
                                   [OVR_KEPT_TIME] = &of->when,
                                   [OVR_KEPT_MEAN] = &of->mean};
    return member(in[which->part], which->of->offset);
}

double ovr_extreme_value(const ovr_extreme *which, const ovr_statistics *from)
{
    if (!which || !which->of || !from)
        return NAN;
    const ovr_observation *const in[] = {[OVR_KEPT_EXTREME] = &from->extreme,
                                         [OVR_KEPT_PLACE] = &from->where,
                                         [OVR_KEPT_TIME] = &from->when,
                                         [OVR_KEPT_MEAN] = &from->mean};
    return number(in[which->part], which->of->offset);
}
