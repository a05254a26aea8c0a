/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a pass leaves for the next one.
 *
 *     u1 h1 + u2 h2 = f,   h1 = s h',  h2 = (1 - s) h'
 *
 * f the flow that leaves at X_b, s the split.  A layer rides on its surface:
 * what leaves at time T lies at x = X_b - (way of the surface up to T), in the
 * place that it has at T = 0, and so has the next pass, whose features begin
 * where they did.  Between two of these points it is linear, beyond them as
 * thick as there.  Between two passes
 *
 *     h <- (1 - loss) h,   or   h <- h_ff x/(1 + x^g)^(1/g),  x = h/h_ff,
 *     h <- h + replenish
 *
 * h_ff the layer that a flooded contact leaves; x^-g grows by 1 a pass.
 *
 * Method: the history of the result file.  Accuracy: that of a step.
 * Source: the second law has the form known of point contacts (Chevalier et
 * al. 1998, Damiens et al. 2004), its exponent is the user's.
 */
#include <math.h>
#include <string.h>

#include "run/passes.h"

enum {
    TIME,
    FILM,
    LEAST,
    PRESSURE,
    FILM_RATIO,
    MENISCUS,
    SUPPLY,
    SUPPLY_RATIO,
    INFLOW,
    OUTFLOW,
    WAITING,
    SPEED,
    HISTORIES
};
static const char *const names[HISTORIES] = {"time",
                                             "central_film_thickness",
                                             "min_film_thickness",
                                             "max_pressure",
                                             "film_ratio",
                                             "meniscus",
                                             "supply",
                                             "supply_ratio",
                                             "inflow",
                                             "outflow",
                                             "oil_waiting",
                                             "speed_ratio"};

typedef struct pass_history {
    size_t n;
    double *of[HISTORIES];
} pass_history;

static ovr_status read_history(ovr_result *result, ovr_arena *arena,
                               pass_history *h, ovr_error *err)
{
    ovr_status status = OVR_OK;
    h->n = ovr_result_about(result)->steps;
    if (!h->n) {
        ovr_fail(err, OVR_BAD_INPUT, "has no row of its history");
        return OVR_BAD_INPUT;
    }
    for (int k = 0; !status && k < HISTORIES; k++) {
        h->of[k] = ovr_arena_take(arena, h->n, sizeof **h->of, err);
        if (!h->of[k])
            return OVR_NO_MEMORY;
        status = ovr_result_history(result, names[k], OVR_HERTZIAN, h->of[k],
                                    err);
    }
    return status;
}

/* ------------------------------------------------------------------ layers */

/* h', where the film leaves with the flow f. */
static double leaving(const ovr_setup *s, double T, double f)
{
    const ovr_contact *c = s->contact;
    double split = s->passes->split;
    double u1 = ovr_surface_speed(s->speed, s->sliding, c->u1_ratio, 1, T);
    double u2 = ovr_surface_speed(s->speed, s->sliding, c->u2_ratio, 2, T);
    return f / (split * fmax(0, u1) + (1 - split) * fmax(0, u2));
}

/* The same at nominal speeds, of a content. */
static double nominally(const ovr_setup *s, double q)
{
    double split = s->passes->split;
    return q / (split * fmax(0, s->contact->u1_ratio) +
                (1 - split) * fmax(0, s->contact->u2_ratio));
}

static double after(const ovr_passes_setup *p, double h, double flooded)
{
    double g = p->side_flow, x = h / flooded;
    if (isfinite(g) && x > 0)
        h = flooded * x / pow(1 + pow(x, g), 1 / g);
    return (1 - p->loss) * h + p->replenish;
}

/* Surface k; what is lost of it goes to lost[j], as a flow at each time. */
static ovr_layer *make_layer(const ovr_setup *s, const pass_history *h, int k,
                             double flooded, double *x, double *thick,
                             double *lost, const ovr_allocator *allocator,
                             ovr_error *err)
{
    static const double apart = 1e-9;
    const ovr_contact *c = s->contact;
    const double ratio = k ? c->u2_ratio : c->u1_ratio;
    const double share = k ? 1 - s->passes->split : s->passes->split;
    const double full = share * nominally(s, flooded);
    size_t end = h->n, first = end;
    for (size_t j = 0; j < h->n; j++) {
        double T = h->of[TIME][j];
        double u = ovr_surface_speed(s->speed, s->sliding, ratio, k + 1, T);
        double left = share * leaving(s, T, h->of[OUTFLOW][j]);
        double place = s->options->outlet -
                       ovr_surface_way(s->speed, s->sliding, ratio, k + 1, T);
        if (!isfinite(left) || (first < end && place > x[first] - apart))
            continue;
        x[--first] = place;
        thick[first] = after(s->passes, fmax(0, left), full);
        lost[j] += fmax(0, u) * (left - thick[first]);
    }
    if (first == end)
        x[--first] = s->options->outlet, thick[first] = 0;
    return ovr_layer_make(end - first, x + first, thick + first,
                          s->options->inlet, allocator, err);
}

/* --------------------------------------------------------------------- row */

/* Mean over the time for which it is known; NAN: never. */
static double mean(const pass_history *h, const double *v)
{
    const double *T = h->of[TIME];
    double sum = 0, span = 0;
    if (h->n == 1)
        return v[0];
    for (size_t j = 1; j < h->n; j++)
        if (isfinite(v[j]) && isfinite(v[j - 1])) {
            sum += 0.5 * (v[j] + v[j - 1]) * (T[j] - T[j - 1]);
            span += T[j] - T[j - 1];
        }
    return span > 0 ? sum / span : NAN;
}

static double extreme(const pass_history *h, const double *v, double sign)
{
    double most = NAN;
    for (size_t j = 0; j < h->n; j++)
        if (!(sign * v[j] <= sign * most) && isfinite(v[j]))
            most = v[j];
    return most;
}

static void fill_row(const pass_history *h, const double *lost,
                     ovr_pass_row *row)
{
    double *to = row->value;
    to[OVR_PASS_FILM] = mean(h, h->of[FILM]);
    to[OVR_PASS_LEAST_CENTRAL] = extreme(h, h->of[FILM], -1);
    to[OVR_PASS_LEAST] = extreme(h, h->of[LEAST], -1);
    to[OVR_PASS_PRESSURE] = extreme(h, h->of[PRESSURE], 1);
    to[OVR_PASS_FILM_RATIO] = mean(h, h->of[FILM_RATIO]);
    to[OVR_PASS_MENISCUS] = mean(h, h->of[MENISCUS]);
    to[OVR_PASS_SUPPLY] = mean(h, h->of[SUPPLY]);
    to[OVR_PASS_SUPPLY_RATIO] = mean(h, h->of[SUPPLY_RATIO]);
    to[OVR_PASS_INFLOW] = mean(h, h->of[INFLOW]);
    to[OVR_PASS_OUTFLOW] = mean(h, h->of[OUTFLOW]);
    to[OVR_PASS_LOST] = mean(h, lost);
    to[OVR_PASS_WAITING] = h->of[WAITING][h->n - 1];
    to[OVR_PASS_STEPS] = (double)h->n - 1;
}

/* ------------------------------------------------------------------- whole */

/* Of a film that arrives by its ratio, of a flooded contact what leaves it. */
static double flooded_flow(const pass_history *h)
{
    double supply = h->of[SUPPLY][0], ratio = h->of[SUPPLY_RATIO][0];
    double flow = h->of[OUTFLOW][0] / h->of[SPEED][0];
    if (supply > 0 && ratio > 0)
        return supply / ratio;
    return isnan(supply) && flow > 0 ? flow : NAN;
}

static ovr_status make_end(const ovr_setup *s, const pass_history *h,
                           ovr_arena *arena, ovr_pass_end *end,
                           const ovr_allocator *allocator, ovr_error *err)
{
    double *x = ovr_arena_take(arena, 3 * h->n + 2, sizeof *x, err);
    double *lost = x ? x + 2 * h->n + 2 : NULL;
    if (!x)
        return OVR_NO_MEMORY;
    if (isnan(end->flooded))
        end->flooded = flooded_flow(h);
    for (int k = 0; k < 2; k++)
        end->layer[k] = make_layer(s, h, k, end->flooded, x, x + h->n + 1, lost,
                                   allocator, err);
    end->waiting = s->supply->waiting;
    if (isfinite(h->of[WAITING][h->n - 1]))
        end->waiting = h->of[WAITING][h->n - 1];
    fill_row(h, lost, &end->row);
    if (end->layer[0] && end->layer[1])
        return OVR_OK;
    ovr_layer_free(end->layer[0]);
    ovr_layer_free(end->layer[1]);
    return OVR_NO_MEMORY;
}

ovr_status ovr_pass_read(const char *file, const ovr_setup *setup,
                         double flooded, ovr_pass_end *end,
                         const ovr_allocator *allocator, ovr_error *err)
{
    ovr_result *result = ovr_result_open(file, allocator, err);
    ovr_arena arena = ovr_arena_make(allocator);
    pass_history h = {0};
    ovr_error why = {0};
    ovr_status status = result ? read_history(result, &arena, &h, &why)
                               : OVR_IO;
    *end = (ovr_pass_end){.flooded = flooded};
    if (result && status)
        ovr_fail(err, status, "%s: %.900s", file, why.message);
    else if (result)
        status = make_end(setup, &h, &arena, end, allocator, err);
    ovr_result_close(result);
    ovr_arena_release(&arena);
    return status;
}
