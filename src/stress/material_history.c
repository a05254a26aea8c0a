/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Stress histories of the material.
 *
 * A point of the surface is at X = reference + xi + U(T).  At each time the
 * nodes are shifted by the fraction of D that places them on material points of
 * every level (field.c), so that no interpolation is needed, in rolling or
 * sliding. For the path (d, tau) of each point the extents in 16 half
 * directions are stored, together with the maximum von Mises and Tresca
 * stresses and the range of h. These are maxima and minima, so that the order
 * of times does not matter.
 *
 * A path at depth z is smooth on the scale of z: if it is sampled at distances
 * s, its maximum is too low by at most (s/z)^2/14. Levels are sampled when the
 * distance moved exceeds 1/64 of their shallowest depth (an error of 2e-5), or
 * every step.
 *
 * Before the first time and after the last the contact is assumed to be steady:
 * the fields of that time are applied at all earlier or later positions.
 */
#include "stress/material_history.h"
#include "base/given.h"
#include "stress/stress.h"

#include <math.h>
#include <string.h>

static const double samples_of_depth = 64;
/* Features at a larger distance from X = 0 have no effect on a path. */
static const double near_contact = 2;
enum { WHOLE = 1 << (OVR_STRESS_LEVELS - 1) };

ovr_material_range ovr_material_range_default(void)
{
    const ovr_material_range defaults = {
        .from = -2, .to = 2, .reach = 2.5, .poisson = 0.3};
    return defaults;
}

/* ------------------------------------------------------------ one moment */

/* Position of the nodes in the material: with nodes shifted by `shift`, node i
 * of level c is at the material point with number `i - meshes 2^(5-c)`. */
typedef struct place {
    double shift;
    long meshes;
} place;

static place find_place(const ovr_material_history *p, double U)
{
    double D = p->stress->options.mesh;
    double t = (U + p->range.reference - p->stress->start) / D;
    double whole = floor(t / WHOLE);
    return (place){t - whole * WHOLE, (long)whole};
}

/* Nodes of a row within reach at one time: n from the first on. */
typedef struct seen {
    ovr_stress_row row;
    size_t first, n;
    double T;
} seen;

/* Computes the stresses at a depth's nodes from the fields solved last. */
static seen evaluate_row(ovr_material_history *p, size_t depth, double T)
{
    seen s = {.row = ovr_stress_at(p->stress, depth), .T = T};
    const ovr_stress_row *row = &s.row;
    const ovr_node_states to = {p->d,        p->tau,       p->h,
                                p->in_plane, p->von_mises, p->tresca};
    double low = ceil((-p->range.reach - row->start) / row->step);
    double high = floor((p->range.reach - row->start) / row->step);
    low = fmax(low, 0);
    high = fmin(high, (double)row->count - 1);
    s.first = low > 0 ? (size_t)low : 0;
    s.n = high >= low ? (size_t)(high - low) + 1 : 0;
    p->stress->loops->states(
        s.n, row->shear + 2 * s.first, row->mean + 2 * s.first,
        &p->constants[ovr_material_history_layer(p, row->z)], &to);
    return s;
}

static double place_of(const seen *s, size_t i)
{
    return s->row.start + (double)(s->first + i) * s->row.step;
}

static void note_extreme(const ovr_stress_loops *loops, const seen *s,
                         const float *v, ovr_stress_extreme *extreme)
{
    double maximum = loops->largest(s->n, v);
    if (!(maximum > extreme->value))
        return;
    size_t i = 0;
    while (i + 1 < s->n && (double)v[i] < maximum)
        i++;
    *extreme = (ovr_stress_extreme){maximum, place_of(s, i), s->row.z, s->T};
}

typedef enum noted { SHEAR, ACROSS, ALONG } noted;

/* Records |tau|, sigma_z = -d - h, or sigma_x = d - h including stresses
 * without load. */
static void note_value(const ovr_material_history *p, const seen *s,
                       noted which, ovr_stress_extreme *extreme)
{
    const ovr_state_constants *c =
        &p->constants[ovr_material_history_layer(p, s->row.z)];
    for (size_t i = 0; i < s->n; i++) {
        double d = (double)p->d[i], h = (double)p->h[i], value;
        value = which == SHEAR    ? fabs((double)p->tau[i])
                : which == ACROSS ? -d - h
                                  : d - h + (double)c->half + (double)c->mean;
        if (value > extreme->value)
            *extreme = (ovr_stress_extreme){value, place_of(s, i), s->row.z,
                                            s->T};
    }
}

/* Records the extremes of the layers; a row below all layers belongs to the
 * body. */
static void note_layers(ovr_material_history *p, const seen *s)
{
    const ovr_layered *layers = p->stress->options.layers;
    ovr_layer_extremes *of = &p->layers;
    double z = s->row.z;
    int layer = ovr_material_history_layer(p, z);
    if (z == p->stress->z[0])
        note_value(p, s, ALONG, &of->surface);
    if (layer == layers->layers)
        return;
    note_extreme(p->stress->loops, s, p->von_mises, &of->von_mises[layer]);
    if (z < ovr_layered_bottom(layers, layer) * (1 - 2 * OVR_BESIDE))
        return;
    note_value(p, s, SHEAR, &of->shear[layer]);
    note_value(p, s, ACROSS, &of->tension);
}

static void note_extremes(ovr_material_history *p, const seen *s)
{
    const ovr_stress_loops *loops = p->stress->loops;
    if (p->stress->options.layers)
        note_layers(p, s);
    if (s->row.z < p->range.least_depth * (1 - 1e-9))
        return;
    note_extreme(loops, s, p->in_plane, &p->numbers.shear);
    note_extreme(loops, s, p->von_mises, &p->numbers.von_mises);
}

/* ------------------------------------------------------ strips of pressure */

/* Maximum width of a strip: two contact widths, so that the whole contact is
 * included. */
static const double widest_strip = 4;

static void note_strip(ovr_material_history *p, const double *P, double T)
{
    double D = p->stress->options.mesh;
    ovr_strip worst = {.excess = p->strip.value};
    if (p->sums.sum && ovr_strip_find(&p->sums, P, p->range.least_depth / D,
                                      widest_strip / D, &worst))
        p->strip = (ovr_stress_extreme){
            worst.excess, p->stress->options.inlet + worst.middle * D,
            worst.width * D, T};
}

/* --------------------------------------------------- a step of the material
 * history */

static void widen(ovr_material_history *p, size_t depth, size_t from, size_t to,
                  size_t n)
{
    const ovr_stress_loops *loops = p->stress->loops;
    size_t pitch = p->grid[p->stress->depth[depth].level].points;
    float *row = p->row[depth] + to;
    for (int m = 0; m < OVR_HALF_DIRECTIONS; m++)
        loops->extents(n, p->d + from, p->tau + from, p->cosine[m], p->sine[m],
                       row + (size_t)(OVR_ROW_HIGH + m) * pitch,
                       row + (size_t)(OVR_ROW_LOW + m) * pitch);
    loops->raise(n, p->von_mises + from, row + OVR_ROW_VON_MISES * pitch);
    loops->raise(n, p->tresca + from, row + OVR_ROW_TRESCA * pitch);
    loops->raise(n, p->h + from, row + OVR_ROW_H_MAX * pitch);
    loops->lower(n, p->h + from, row + OVR_ROW_H_MIN * pitch);
}

/* Material point of the grid at node 0. */
static long point_at(const ovr_material_history *p, int c, place at)
{
    return -at.meshes * (WHOLE >> c) - p->grid[c].first;
}

static void follow_depth(ovr_material_history *p, size_t depth, place at,
                         double T)
{
    const seen s = evaluate_row(p, depth, T);
    if (!s.n)
        return;
    note_extremes(p, &s);
    long k = (long)s.first + point_at(p, s.row.level, at);
    long skip = k < 0 ? -k : 0, n = (long)s.n - skip;
    long maximum = (long)p->grid[s.row.level].points - (k + skip);
    long count = n < maximum ? n : maximum;
    if (count > 0)
        widen(p, depth, (size_t)skip, (size_t)(k + skip), (size_t)count);
}

static unsigned levels_due(ovr_material_history *p, double dU)
{
    unsigned due = 0;
    for (int c = 0; c < OVR_STRESS_LEVELS; c++) {
        double limit = p->grid[c].top / samples_of_depth * (1 + 1e-9);
        p->numbers.distance[c] += dU;
        if (p->grid[c].top > 0 && p->numbers.distance[c] + dU > limit) {
            p->numbers.distance[c] = 0;
            due |= 1u << c;
        }
    }
    p->numbers.widest = fmax(p->numbers.widest, dU);
    return due;
}

void ovr_material_history_step(ovr_material_history *history, const double *P,
                               const double *Q, const ovr_moment *moment)
{
    if (!history || !moment)
        return;
    note_strip(history, P, moment->T);
    unsigned due = levels_due(history, moment->dU);
    place at = find_place(history, moment->U);
    if (!due)
        return;
    ovr_stress_solve(history->stress, P, Q, at.shift, due);
    for (size_t j = 0; j < history->stress->depths; j++)
        if (due >> history->stress->depth[j].level & 1)
            follow_depth(history, j, at, moment->T);
}

/* ----------------------------------------------- start and end of a history */

/* Values of a row at n nodes at one time. */
static void row_values(const ovr_material_history *p, int row, size_t n,
                       float *v)
{
    const float *of[] = {p->von_mises, p->tresca, p->h, p->h};
    if (row >= OVR_ROW_VON_MISES) {
        memcpy(v, of[row - OVR_ROW_VON_MISES], n * sizeof *v);
        return;
    }
    int m = row % OVR_HALF_DIRECTIONS;
    float c = p->cosine[m], s = p->sine[m];
    for (size_t i = 0; i < n; i++)
        v[i] = p->d[i] * c + p->tau[i] * s;
}

static bool is_low(int row)
{
    return row == OVR_ROW_H_MIN ||
           (row >= OVR_ROW_LOW && row < OVR_ROW_VON_MISES);
}

static float beyond(float a, float b, bool low)
{
    return (low ? b < a : b > a) ? b : a;
}

/* Replaces each value by the maximum (minimum) of `first` and all values before
 * it, or after it if the points are swept downward; returns that of all values.
 */
static float run_through(float *v, size_t n, float first, bool low, bool upward)
{
    float carry = first;
    for (size_t i = 0; i < n; i++) {
        float *at = v + (upward ? i : n - 1 - i);
        carry = *at = beyond(carry, *at, low);
    }
    return carry;
}

/* Nodes of a depth at the start or end of a run. Node i = 0 ... n - 1 is at
 * material point k + i, or between it and the next point. Upward, a point
 * includes its own node and all nodes before it. Downward, it includes all
 * nodes after it. */
typedef struct closing {
    size_t depth, n;
    long k;
    bool upward;
} closing;

/* Sweeps one row, whose values are in v; returns the maximum (minimum) of all.
 */
static float sweep_row(const ovr_material_history *p, const closing *c, int r,
                       float *v)
{
    const ovr_stress_loops *loops = p->stress->loops;
    long points = (long)p->grid[p->stress->depth[c->depth].level].points;
    long first = c->k > 0 ? c->k : 0, last = c->k + (long)c->n;
    long behind = last < points ? last : points;
    float *row = p->row[c->depth] + (size_t)r * (size_t)points;
    int layer = ovr_material_history_layer(p, p->stress->z[c->depth]);
    bool low = is_low(r);
    float all = run_through(v, c->n, p->rest[layer][r], low, c->upward);
    if (first < behind)
        (low ? loops->lower : loops->raise)((size_t)(behind - first),
                                            v + (first - c->k), row + first);
    long from = c->upward ? (last > 0 ? last : 0) : 0;
    long to = c->upward ? points : c->k;
    for (long at = from; at < to && at < points; at++)
        row[at] = beyond(row[at], all, low);
    return all;
}

/* Processes one depth, whose nodes are `between` material points or on them. At
 * the beginning, the total is the smooth stress history. */
static void close_depth(ovr_material_history *p, closing c, place at,
                        bool between, bool begin)
{
    const seen s = evaluate_row(p, c.depth, 0);
    c.n = s.n;
    c.k = (long)s.first + point_at(p, s.row.level, at) + (between && c.upward);
    for (int r = 0; r < OVR_ROWS; r++) {
        row_values(p, r, c.n, p->in_plane);
        float all = sweep_row(p, &c, r, p->in_plane);
        float *smooth = &p->smooth[c.depth * OVR_ROWS + (size_t)r];
        if (begin)
            *smooth = beyond(*smooth, all, is_low(r));
    }
}

/* Applies the contact at all earlier or later positions of every point, one
 * mesh size apart: level c has 2^c shifts. */
static void close_run(ovr_material_history *p, const double *P, const double *Q,
                      const ovr_moment *moment, bool begin)
{
    place at = find_place(p, moment->U);
    bool upward = begin ? moment->direction > 0 : moment->direction < 0;
    for (unsigned s = 0; s < WHOLE; s++) {
        unsigned levels = 0;
        for (unsigned c = 0; c < OVR_STRESS_LEVELS; c++)
            levels |= s < 1u << c ? 1u << c : 0;
        ovr_stress_solve(p->stress, P, Q, at.shift + s, levels);
        for (size_t j = 0; j < p->stress->depths; j++)
            if (levels >> p->stress->depth[j].level & 1)
                close_depth(p, (closing){.depth = j, .upward = upward}, at,
                            s > 0, begin);
    }
}

/* Marks points with a part of their path before the first or after the last
 * time, if that part was not in a smooth contact. */
static void mark(ovr_material_history *p, const ovr_moment *moment, bool begin)
{
    double step = ldexp(p->stress->options.mesh, p->finest);
    for (size_t k = 0; moment->disturbed && k < p->points; k++) {
        double xi = (double)(p->first + (long)k) * step;
        double X = p->range.reference + xi + moment->U;
        double ahead = moment->direction * X;
        if (begin ? ahead > -near_contact : ahead < near_contact)
            p->complete[k] = 0;
    }
}

/* Records the extremes of the first time. */
static void record_extremes(ovr_material_history *p, const double *P,
                            const double *Q, const ovr_moment *moment)
{
    ovr_stress_solve(p->stress, P, Q, 0, OVR_STRESS_ALL_LEVELS);
    for (size_t j = 0; j < p->stress->depths; j++) {
        const seen s = evaluate_row(p, j, moment->T);
        note_extremes(p, &s);
    }
}

void ovr_material_history_begin(ovr_material_history *history, const double *P,
                                const double *Q, const ovr_moment *moment)
{
    if (!history || !P || !moment)
        return;
    note_strip(history, P, moment->T);
    record_extremes(history, P, Q, moment);
    close_run(history, P, Q, moment, true);
    mark(history, moment, true);
}

void ovr_material_history_end(ovr_material_history *history, const double *P,
                              const double *Q, const ovr_moment *moment)
{
    if (!history || !P || !moment)
        return;
    close_run(history, P, Q, moment, false);
    mark(history, moment, false);
}

/* ----------------------------------------------------------------- results */

static ovr_stress_extreme root(ovr_stress_extreme of_square)
{
    of_square.value = sqrt(of_square.value);
    return of_square;
}

ovr_layer_extremes ovr_material_history_layers(const ovr_material_history *p)
{
    ovr_layer_extremes of = p->layers;
    for (int j = 0; j < OVR_LAYERS_MAX; j++)
        of.von_mises[j] = root(of.von_mises[j]);
    return of;
}

ovr_stress_extreme
ovr_material_history_max_shear(const ovr_material_history *history)
{
    if (!history)
        return (ovr_stress_extreme){0};
    return root(history->numbers.shear);
}

ovr_stress_extreme
ovr_material_history_von_mises(const ovr_material_history *history)
{
    if (!history)
        return (ovr_stress_extreme){0};
    return root(history->numbers.von_mises);
}

ovr_stress_extreme
ovr_material_history_strip(const ovr_material_history *history)
{
    if (!history || !history->sums.sum)
        return (ovr_stress_extreme){NAN, NAN, NAN, NAN};
    return history->strip;
}

double ovr_material_history_widest(const ovr_material_history *history)
{
    if (!history)
        return NAN;
    return history->numbers.widest;
}

ovr_material ovr_material_history_points(const ovr_material_history *history)
{
    if (!history)
        return (ovr_material){0};
    double step = ldexp(history->stress->options.mesh, history->finest);
    return (ovr_material){history->points,
                          history->stress->depths,
                          (double)history->first * step,
                          step,
                          history->stress->z,
                          history->complete};
}

double ovr_material_history_reference(const ovr_material_history *history)
{
    return history->range.reference;
}

size_t ovr_material_history_state(ovr_material_history *history,
                                  const ovr_memory_piece **pieces)
{
    if (!history || !pieces)
        return 0;
    *pieces = history->piece;
    return history->pieces;
}
