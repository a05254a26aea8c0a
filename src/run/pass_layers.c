/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lubricant layers left by one pass and entering the next.
 *
 *     u1 h1 + u2 h2 = f,   h1 = s h',  h2 = (1 - s) h'
 *
 * f is the outflow at X_b and s the split ratio (share of surface 1). Each
 * layer is convected with its surface: lubricant that leaves at time T lies at
 * x = X_b minus the distance moved by the surface up to T. The next pass uses
 * the same coordinate, so its features start at the same position. Layers are
 * interpolated linearly and extended with constant thickness. A pass starts
 * from a steady film with the mean layer thickness between inlet and outlet at
 * T = 0, because the thickness at the inlet may belong to a feature's wake.
 * Between two passes
 *
 *     h <- (1 - loss) h,   or   h <- h_ff x/(1 + x^g)^(1/g),  x = h/h_ff,
 *     h <- h + replenish,   h <- h_ff - (h_ff - h) exp(-t/recovery)
 *
 * h_ff is the layer left by a flooded contact (that of the first pass). x^-g
 * grows by 1 per pass. t = spacing/u_k is the time between two rolling bodies.
 * A surface that belongs to a new body in each pass carries the layer from
 * before the features.
 *
 * Method: uses the history of the result file or of the running simulation.
 * Accuracy: one time step. Source: the second law has the form known from point
 * contacts (Chevalier et al. 1998, Damiens et al. 2004); its exponent is an
 * input.
 */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "physics/supply/supply.h"
#include "results/results.h"
#include "run/pass_series.h"

/* ---------------------------------------------------- History at the outlet */

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

/* Enlarges the history to at least `rows` rows and keeps the existing ones. */
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

/* True if the result contains the quantity, that is, if its physical model is
 * active. */
static bool is_there(const ovr_result *result, const ovr_observable *which)
{
    const ovr_variable *v;
    bool there = false;
    for (size_t k = 0; !there && (v = ovr_result_column(result, k)); k++)
        there = strcmp(v->name, which->name) == 0;
    return there || !which->needs;
}

/* Reads a column of the history from a file. */
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

/* Reads all rows of a file. */
static ovr_status pass_history_read(ovr_pass_history *h, ovr_result *result,
                                    ovr_error *err)
{
    size_t rows = ovr_result_get_info(result)->steps;
    ovr_status status = OVR_OK;
    if (!rows) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "has no history, because the run ended before its first step");
        return OVR_BAD_INPUT;
    }
    status = reserve(h, rows, err);
    for (int k = 0; !status && k < OVR_SEEN_MAX; k++)
        status = read_column(h, k, rows, result, err);
    h->n = status ? 0 : rows;
    return status;
}

static ovr_status record_row(void *data, const ovr_simulation *sim,
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
    return (ovr_observer){record_row, NULL, h};
}

/* ------------------------------------------------------------------- Layers */

/* ------------------------------------------------------------------ Layers */

/* Returns the film thickness h' that leaves at flow f. */
static double outflow_thickness(const ovr_setup *s, double T, double f)
{
    const ovr_contact *c = s->contact;
    double split = s->passes->split;
    double u1 = ovr_surface_speed(s->speed, s->sliding, c->u1_ratio, 1, T);
    double u2 = ovr_surface_speed(s->speed, s->sliding, c->u2_ratio, 2, T);
    return f / (split * fmax(0, u1) + (1 - split) * fmax(0, u2));
}

static double left_at(const ovr_setup *s, const ovr_pass_history *h, size_t j)
{
    return outflow_thickness(s, h->of[OVR_SEEN_TIME][j],
                             h->of[OVR_SEEN_OUTFLOW][j]);
}

/* Returns the film thickness h' of a lubricant content q at the reference
 * speeds. */
static double reference_thickness(const ovr_setup *s, double q)
{
    double split = s->passes->split;
    return q / (split * fmax(0, s->contact->u1_ratio) +
                (1 - split) * fmax(0, s->contact->u2_ratio));
}

/* Returns the layer thickness that enters the next pass, from the thickness h
 * left by this one, after side flow, loss and replenishment. `ratio`:
 * u_k/u_m. */
static double entering_layer(const ovr_passes_setup *p, double h,
                             double flooded, double ratio)
{
    double g = p->side_flow, x = h / flooded;
    if (isfinite(g) && x > 0)
        h = flooded * x / pow(1 + pow(x, g), 1 / g);
    h = (1 - p->loss) * h + p->replenish;
    if (isfinite(p->recovery) && h < flooded)
        h = flooded - (flooded - h) * exp(-p->spacing / ratio / p->recovery);
    return h;
}

/* Returns the history row with the layer on surface k at the position of row
 * j. */
static size_t layer_row(const ovr_setup *s, int k, size_t j)
{
    return s->passes->again & 1 << k ? j : 0;
}

/* A finished pass, with working arrays at its times: positions and thicknesses
 * of a layer, and the lost flow of both layers. */
typedef struct ended {
    const ovr_setup *s;
    const ovr_pass_history *h;
    double flooded; /* flow rate of a flooded contact */
    double *x, *thick, *lost;
} ended;

/* Creates the layer on surface k for the next pass. */
static ovr_layer *make_layer(const ended *e, int k,
                             const ovr_allocator *allocator, ovr_error *err)
{
    static const double apart = 1e-9;
    const ovr_setup *s = e->s;
    const ovr_pass_history *h = e->h;
    const ovr_contact *c = s->contact;
    double *x = e->x, *thick = e->thick;
    const double ratio = k ? c->u2_ratio : c->u1_ratio;
    const double share = k ? 1 - s->passes->split : s->passes->split;
    const double full = share * reference_thickness(s, e->flooded);
    size_t end = h->n, first = end;
    for (size_t j = 0; j < h->n; j++) {
        double T = h->of[OVR_SEEN_TIME][j];
        double u = ovr_surface_speed(s->speed, s->sliding, ratio, k + 1, T);
        double left = share * left_at(s, h, layer_row(s, k, j));
        double place = s->options->outlet -
                       ovr_surface_distance(s->speed, s->sliding, ratio, k + 1,
                                            T);
        if (!isfinite(left) || (first < end && place > x[first] - apart))
            continue;
        x[--first] = place;
        thick[first] = entering_layer(s->passes, fmax(0, left), full, ratio);
        e->lost[j] += fmax(0, u) * (left - thick[first]);
    }
    if (first == end)
        x[--first] = s->options->outlet, thick[first] = 0;
    return ovr_layer_make(end - first, x + first, thick + first,
                          s->options->inlet, allocator, err);
}

/* --------------------------------------------------------------------- Row */

/* Returns the time average over the times at which the value is known; NAN if
 * there are none. */
static double mean(const ovr_pass_history *h, const double *v)
{
    const double *T = h->of[OVR_SEEN_TIME];
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

static double extreme(const ovr_pass_history *h, const double *v, double sign)
{
    double maximum = NAN;
    for (size_t j = 0; j < h->n; j++)
        if (!(sign * v[j] <= sign * maximum) && isfinite(v[j]))
            maximum = v[j];
    return maximum;
}

static double over_pass(const ovr_pass_history *h, const double *v,
                        unsigned how)
{
    switch (how) {
    case OVR_PASS_SMALLEST: return extreme(h, v, -1);
    case OVR_PASS_LARGEST: return extreme(h, v, 1);
    case OVR_PASS_END: return v[h->n - 1];
    default: return mean(h, v);
    }
}

static void fill_row(const ovr_pass_history *h, const double *lost,
                     ovr_pass_row *row)
{
    ovr_pass_column c;
    for (size_t k = 0; ovr_pass_column_at(k, &c); k++)
        row->value[k] =
            c.of ? over_pass(h, h->of[OVR_PASS_QUANTITIES + k], c.how) : NAN;
    row->value[OVR_PASS_LOST] = mean(h, lost);
    row->value[OVR_PASS_STEPS] = (double)h->n - 1;
}

/* ----------------------------------------------------------- Complete pass */

/* Returns the flooded flow rate: from the supply ratio if the film is supplied,
 * otherwise the outflow. */
static double flooded_flow(const ovr_pass_history *h)
{
    double supply = h->of[OVR_SEEN_SUPPLY][0];
    double ratio = h->of[OVR_SEEN_INFLOW_RATIO][0];
    double flow = h->of[OVR_SEEN_OUTFLOW][0] / h->of[OVR_SEEN_SPEED][0];
    if (supply > 0 && ratio > 0)
        return supply / ratio;
    return isnan(supply) && flow > 0 ? flow : NAN;
}

ovr_status ovr_pass_end_make(const ovr_setup *s, ovr_pass_history *h,
                             ovr_pass_end *end, const ovr_allocator *allocator,
                             ovr_error *err)
{
    const double *reservoir = h->of[OVR_SEEN_RESERVOIR];
    double *x = ovr_arena_take(&h->arena, 3 * h->n + 2, sizeof *x, err);
    double *lost = x ? x + 2 * h->n + 2 : NULL;
    *end = (ovr_pass_end){.flooded = end->flooded,
                          .reservoir = ovr_setup_supply(s)->reservoir};
    if (!x)
        return OVR_NO_MEMORY;
    if (isnan(end->flooded))
        end->flooded = flooded_flow(h);
    const ended e = {s, h, end->flooded, x, x + h->n + 1, lost};
    for (int k = 0; k < 2; k++)
        end->layer[k] = make_layer(&e, k, allocator, err);
    if (isfinite(reservoir[h->n - 1]))
        end->reservoir = reservoir[h->n - 1];
    fill_row(h, lost, &end->row);
    if (end->layer[0] && end->layer[1])
        return OVR_OK;
    ovr_pass_end_free(end);
    return OVR_NO_MEMORY;
}

void ovr_pass_end_free(ovr_pass_end *end)
{
    ovr_layer_free(end->layer[0]);
    ovr_layer_free(end->layer[1]);
    end->layer[0] = end->layer[1] = NULL;
}

/* ------------------------------------------------------------- From its file
 */

/* Reads the estimated errors of a pass (of a steady one, those of the final
 * state) and the fatigue numbers. */
static void read_summary(ovr_result *result, ovr_pass_row *row)
{
    static const struct {
        const char *key;
        ovr_pass_beside to;
    } of[] = {{"H_cen_mean_error", OVR_PASS_FILM_ERROR},
              {"H_min_error", OVR_PASS_MIN_ERROR},
              {"P_max_error", OVR_PASS_PRESSURE_ERROR},
              {"H_min_overall_error", OVR_PASS_MIN_ERROR},
              {"P_max_overall_error", OVR_PASS_PRESSURE_ERROR},
              {"X_meniscus_mean_error", OVR_PASS_MENISCUS_ERROR},
              {"equivalent_length", OVR_PASS_LENGTH},
              {"risk_smooth", OVR_PASS_RISK},
              {"life_ratio", OVR_PASS_RATIO}};
    size_t count = 0;
    const ovr_group_attribute *line = ovr_result_attributes(result, "summary",
                                                            &count);
    for (size_t k = 0; k < sizeof of / sizeof *of; k++)
        for (size_t i = 0; i < count; i++)
            if (strcmp(line[i].name, of[k].key) == 0)
                row->value[of[k].to] = line[i].number;
}

ovr_status ovr_pass_read(const char *file, const ovr_setup *setup,
                         ovr_pass_end *end, const ovr_allocator *allocator,
                         ovr_error *err)
{
    ovr_result *result = ovr_result_open(file, allocator, err);
    ovr_pass_history h = ovr_pass_history_make(allocator);
    ovr_error why = {0};
    ovr_status status = result ? pass_history_read(&h, result, &why) : OVR_IO;
    if (result && status)
        ovr_fail(err, status, "%s: %.900s", file, why.message);
    else if (result)
        status = ovr_pass_end_make(setup, &h, end, allocator, err);
    if (!status)
        read_summary(result, &end->row);
    ovr_result_close(result);
    ovr_arena_release(&h.arena);
    return status;
}
