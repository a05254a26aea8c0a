/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/pass_history.h"

#include <math.h>
#include <string.h>

static const char *const names[OVR_PASS_QUANTITIES] = {
    [OVR_SEEN_TIME] = "time",
    [OVR_SEEN_SUPPLY] = "supply",
    [OVR_SEEN_INFLOW_RATIO] = "supply_ratio",
    [OVR_SEEN_OUTFLOW] = "outflow",
    [OVR_SEEN_RESERVOIR] = "oil_waiting",
    [OVR_SEEN_SPEED] = "speed_ratio"};

static const ovr_observable *named(const char *name)
{
    const ovr_observable *o;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if (o->name && strcmp(o->name, name) == 0)
            break;
    return o;
}

ovr_pass_history ovr_pass_history_make(const ovr_allocator *allocator)
{
    ovr_pass_history h = {.arena = ovr_arena_make(allocator)};
    ovr_pass_column c;
    for (int k = 0; k < OVR_PASS_QUANTITIES; k++)
        h.which[k] = named(names[k]);
    for (size_t k = 0; ovr_pass_column_at(k, &c); k++)
        h.which[OVR_PASS_QUANTITIES + k] = c.of;
    return h;
}

/* Space for so many rows; the rows of before are kept. */
static ovr_status reserve(ovr_pass_history *h, size_t rows, ovr_error *err)
{
    for (int k = 0; k < OVR_SEEN_MAX; k++) {
        double *of = h->which[k]
                         ? ovr_arena_take(&h->arena, rows, sizeof *of, err)
                         : NULL;
        if (!h->which[k])
            continue;
        if (!of)
            return OVR_NO_MEMORY;
        if (h->n)
            memcpy(of, h->of[k], h->n * sizeof *of);
        h->of[k] = of;
    }
    h->capacity = rows;
    return OVR_OK;
}

/* What belongs to a physics that is off has no column. */
static bool is_there(const ovr_result *result, const ovr_observable *which)
{
    const ovr_variable *v;
    bool there = false;
    for (size_t k = 0; !there && (v = ovr_result_column(result, k)); k++)
        there = strcmp(v->name, which->name) == 0;
    return there || !which->needs;
}

/* A column of a file. */
static ovr_status read_column(ovr_pass_history *h, int k, size_t rows,
                              ovr_result *result, ovr_error *err)
{
    if (!h->which[k])
        return OVR_OK;
    if (is_there(result, h->which[k]))
        return ovr_result_history(result, h->which[k]->name, OVR_HERTZIAN,
                                  h->of[k], err);
    for (size_t j = 0; j < rows; j++)
        h->of[k][j] = NAN;
    return OVR_OK;
}

ovr_status ovr_pass_history_read(ovr_pass_history *h, ovr_result *result,
                                 ovr_error *err)
{
    size_t rows = ovr_result_about(result)->steps;
    ovr_status status = OVR_OK;
    if (!rows) {
        ovr_fail(
            err, OVR_BAD_INPUT,
            "has no row of its history: the run ended before its first step");
        return OVR_BAD_INPUT;
    }
    status = reserve(h, rows, err);
    for (int k = 0; !status && k < OVR_SEEN_MAX; k++)
        status = read_column(h, k, rows, result, err);
    h->n = status ? 0 : rows;
    return status;
}

static ovr_status take_down(void *data, const ovr_simulation *sim,
                            ovr_error *err)
{
    enum { FIRST = 256 };
    ovr_pass_history *h = data;
    const ovr_observation *seen = ovr_simulation_observation(sim);
    if (h->n == h->capacity && reserve(h, h->n ? 2 * h->n : FIRST, err))
        return OVR_NO_MEMORY;
    for (int k = 0; k < OVR_SEEN_MAX; k++)
        if (h->which[k])
            h->of[k][h->n] = ovr_observable_value(h->which[k], seen);
    h->n++;
    return OVR_OK;
}

ovr_observer ovr_pass_history_observer(ovr_pass_history *h)
{
    return (ovr_observer){take_down, NULL, h};
}
