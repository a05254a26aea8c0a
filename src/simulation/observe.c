/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Observation of the state after a solve or step. */
#include "simulation/observe.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "contact/contact.h"
#include "simulation/internal.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/refined.h"

/* ------------------------------------------------------ extremes of a curve */

double ovr_vertex(const double *X, const double *v, size_t i, double *value)
{
    double left = X[i] - X[i - 1], right = X[i + 1] - X[i];
    double up = (v[i] - v[i - 1]) / left, down = (v[i + 1] - v[i]) / right;
    double curvature = 2 * (down - up) / (left + right);
    double slope = (up * right + down * left) / (left + right);
    double shift = curvature != 0 ? -slope / curvature : 0;
    double gain = shift * (slope + 0.5 * shift * curvature);
    if (!(-left <= shift && shift <= right) ||
        !(fabs(gain) <= 0.05 * fabs(v[i])))
        shift = gain = 0;
    *value = v[i] + gain;
    return X[i] + shift;
}

/* Returns zero if the mesh resolves the maximum of P at node i: the mean of the
 * adjacent nodes is at least 90 % of it. Otherwise returns the height expected
 * on finer grids: the maximum and half its difference from that mean. At a
 * surface feature, the pressure of a Newtonian film has a logarithmic
 * singularity; there the ratio is about 0.6 on any mesh. */
static double unresolved_height(const double *P, size_t i)
{
    double step = P[i] - (P[i - 1] + P[i + 1]) / 2;
    return step > 0.1 * P[i] ? P[i] + 0.5 * step : 0;
}

/* Sets the largest of these heights; `high` is the node of P_max. */
static void observe_unresolved(const ovr_solution *now, size_t high,
                               ovr_observation *o)
{
    const double *P = now->P;
    size_t highest = high;
    o->P_unresolved = unresolved_height(P, high);
    for (size_t i = 1; o->maxima > 1 && i + 1 < now->n; i++) {
        if (!(P[i] > P[i - 1] && P[i] >= P[i + 1]))
            continue;
        double height = unresolved_height(P, i);
        if (height > o->P_unresolved) {
            o->P_unresolved = height;
            highest = i;
        }
    }
    o->X_unresolved = now->X[highest];
    o->P_max_resolved = ovr_is_resolved(o->P_max, o->P_unresolved);
}

bool ovr_is_resolved(double P_max, double P_unresolved)
{
    return !(P_unresolved > 1.02 * P_max);
}

int ovr_prominent_maxima(size_t n, const double *P, size_t *last)
{
    double low = P[0]; /* minimum since the last prominent maximum */
    int count = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        low = P[i] < low ? P[i] : low;
        if (!(P[i] > P[i - 1] && P[i] >= P[i + 1]))
            continue;
        if (P[i] > low + OVR_PROMINENCE)
            count++;
        else if (!count || !(P[i] > P[*last]))
            continue; /* none, or a lower one of the same peak */
        *last = i;
        low = P[i];
    }
    return count;
}

/* Range of nodes: first <= i < end */
typedef struct inside {
    size_t first, end;
} inside;

static inside nodes_inside(const ovr_solution *now, double window)
{
    inside in = {0, now->n};
    while (in.first < in.end && !(fabs(now->X[in.first]) < window))
        in.first++;
    while (in.end > in.first && !(fabs(now->X[in.end - 1]) < window))
        in.end--;
    return in;
}

/* Mean film thickness of the range; and the root mean square deviation of rho
 * H, which is unaffected by compression and flow there, relative to the mean
 * density. */
static double mean_film(const ovr_simulation *sim, inside in, double *roughness)
{
    enum { WIDTH, FILM, DENSITY, CONTENT, SQUARES, SUMS };
    const ovr_solution *now = &sim->now;
    double sum[SUMS];
    sim->grids.kernels->film_sums(in.end - in.first, now->weights + in.first,
                                  now->q + in.first, now->H + in.first, sum);
    double squares = sum[SQUARES] * sum[WIDTH] - sum[CONTENT] * sum[CONTENT];
    *roughness = sqrt(fmax(squares, 0)) / sum[DENSITY];
    return sum[FILM] / sum[WIDTH];
}

/* True at nodes with fluid or asperity pressure, and next to these. */
static bool bears(const double *P, size_t i)
{
    return P[i - 1] > 0 || P[i] > 0 || P[i + 1] > 0;
}

/* Finds the minimum film thickness: the smallest gap that bears load.  In the
 * cavitated region the gap of rough surfaces can be smaller. */
static void observe_minimum(const ovr_simulation *sim, ovr_observation *o)
{
    const double *X = sim->now.X, *H = sim->now.H;
    double *solid = ovr_work_take(sim);
    const double *P = ovr_solid_pressure(sim, solid);
    size_t n = sim->now.n, low = 0;
    size_t smallest = 1 + sim->grids.kernels->extreme(n - 2, 1, H + 1);
    o->H_min_cavity = o->X_min_cavity = NAN;
    if (bears(P, smallest))
        low = smallest;
    for (size_t i = 1; i + 1 < n && low != smallest; i++)
        if (bears(P, i) && (!low || H[i] < H[low]))
            low = i;
    if (!low) /* no pressurized node */
        low = smallest;
    if (low != smallest)
        o->X_min_cavity = ovr_vertex(X, H, smallest, &o->H_min_cavity);
    o->H_min = H[low];
    o->X_min = X[low];
    o->X_min_located = ovr_vertex(X, H, low, &o->H_min_located);
    ovr_work_give(sim, solid);
}

static void observe_film(const ovr_simulation *sim, ovr_observation *o)
{
    const double *H = sim->now.H, T = sim->state.T;
    /* smaller than that of the reference contact if the contact is narrower */
    double narrower = fmin(1,
                           sqrt(ovr_history_value(sim->histories.load, T) *
                                ovr_history_value(sim->histories.radius, T)));
    const inside in = nodes_inside(&sim->now, OVR_ROUGH_WINDOW * narrower);
    observe_minimum(sim, o);
    o->H_cen = ovr_value_at(&sim->now, H, 0);
    o->H_mean = mean_film(sim, in, &o->film_Rq);
    if (!sim->shapes.heights)
        o->film_Rq = NAN;
    o->lambda_ratio = sim->shapes.roughness > 0
                          ? o->H_mean / sim->shapes.roughness
                          : NAN;
    o->H0 = sim->grids.H0;
}

/* Number of prominent maxima; and the last of them in the direction of flow. */
static int maxima_of(const ovr_simulation *sim, size_t *last)
{
    const ovr_kernels *run = sim->grids.kernels;
    const double *P = sim->now.P;
    size_t n = sim->now.n;
    int maxima;
    double *image = ovr_work_take(sim);
    if (sim->histories.backward) {
        ovr_mirror(n, P, image);
        P = image;
    }
    maxima = run->peaks(n, P, last);
    if (maxima > 1) /* several maxima may be numerical noise */
        maxima = ovr_prominent_maxima(n, P, last);
    if (sim->histories.backward)
        *last = n - 1 - *last;
    ovr_work_give(sim, image);
    return maxima;
}

/* The first cavitated node downstream of the film. */
static size_t film_end(const ovr_simulation *sim)
{
    const double *P = sim->now.P;
    size_t n = sim->now.n, i = sim->histories.backward ? 1 : n - 2;
    if (sim->histories.backward) {
        while (i < n - 1 && !(P[i] > 0))
            i++;
        return i - 1;
    }
    while (i > 0 && !(P[i] > 0))
        i--;
    return i + 1;
}

static void observe_pressure(const ovr_simulation *sim, ovr_observation *o)
{
    const ovr_kernels *run = sim->grids.kernels;
    const double *P = sim->now.P;
    size_t n = sim->now.n, spike = 0;
    size_t high = 1 + run->extreme(n - 2, -1, P + 1);
    int maxima = maxima_of(sim, &spike);
    double exit = sim->histories.backward ? -1 : 1;
    o->P_max = P[high];
    o->X_P_max = sim->now.X[high];
    o->X_P_max_located = ovr_vertex(sim->now.X, P, high, &o->P_max_located);
    o->P_cen = ovr_value_at(&sim->now, P, 0);
    o->maxima = maxima;
    observe_unresolved(&sim->now, high, o);
    o->X_cavitation = sim->now.X[film_end(sim)];
    o->P_spike = o->X_spike = NAN;
    o->P_spike_resolved = true;
    o->P_spike_located = o->X_spike_located = NAN;
    if (maxima >= 2 && exit * sim->now.X[spike] > 0) {
        o->P_spike = P[spike];
        o->P_spike_resolved = !(unresolved_height(P, spike) > 0);
        o->X_spike = sim->now.X[spike];
        o->X_spike_located = ovr_vertex(sim->now.X, P, spike,
                                        &o->P_spike_located);
    }
    double *solid = ovr_work_take(sim);
    o->load = ovr_integral(sim, ovr_solid_pressure(sim, solid));
    ovr_work_give(sim, solid);
}

/* Mean flow node by node, including flow from physical models; for both rolling
 * directions. */
static double mean_flow_by_nodes(const ovr_simulation *sim, double Cu)
{
    const double *P = sim->now.P;
    double sum = 0, count = 0;
    for (size_t i = 1; i + 2 < sim->now.n; i++)
        if (P[i] > 0 && P[i + 1] > 0) {
            sum += ovr_flux(sim, Cu, i);
            count++;
        }
    return count > 0 ? sum / count : 0;
}

/* Mean flow over all pressurized half nodes that have two upstream nodes. */
static double mean_flow(const ovr_simulation *sim)
{
    double Cu = ovr_history_value(sim->histories.speed, sim->state.T);
    const double *upstream = sim->scheme->upstream;
    const double u[2] = {upstream[0] * Cu, upstream[1] * Cu};
    double patches;
    OVR_LAST_PHYSICS(sim, beside, in_output, flow);
    if (ovr_refined_mean_flow(sim, &patches))
        return patches;
    if (beside->is || sim->histories.backward)
        return mean_flow_by_nodes(sim, Cu);
    return sim->grids.kernels->mean_flow(sim->now.n, u, sim->now.X, sim->now.P,
                                         sim->now.q, sim->now.eps,
                                         sim->now.flow);
}

/* True if the result of a failed solve does not approximate a film: H <= 0
 * somewhere, or R is as large as the flow. */
static bool is_meaningless(const ovr_simulation *sim,
                           const ovr_outcome *outcome)
{
    if (outcome->converged || outcome->marked)
        return false;
    return !ovr_surfaces_apart(sim) || !(fabs(outcome->defect.imbalance) <= 1);
}

/* Replaces quantities that depend on the film by NAN; counts and flags are
 * kept. */
static void withhold(ovr_observation *o)
{
    const ovr_observation given = *o;
    const ovr_observable *row;
    for (size_t k = 0; (row = ovr_observable_at(k)); k++)
        if (row->axes == OVR_AT_STEPS && row->kind != OVR_KIND_COUNT &&
            row->kind != OVR_KIND_FLAG && !row->field)
            *(double *)(void *)((char *)o + row->offset) = NAN;
    o->T = given.T;
    o->dT = given.dT;
    o->load_ratio = given.load_ratio;
    o->speed_ratio = given.speed_ratio;
    o->radius_ratio = given.radius_ratio;
    o->sliding = given.sliding;
    o->residual = given.residual;
    o->H_cen = o->H_mean = o->lambda_ratio = NAN;
    o->P_unresolved = 0;
}

void ovr_observe_line(ovr_simulation *sim, ovr_observation *o)
{
    observe_film(sim, o);
    observe_pressure(sim, o);
    o->mass_flow = mean_flow(sim);
    ovr_observe_friction(sim, o);
}

void ovr_observe(ovr_simulation *sim, double dT, const ovr_outcome *outcome)
{
    ovr_observation *o = &sim->observation;
    const ovr_state *state = &sim->state;
    ovr_publish_state(sim);
    *o = (ovr_observation){.T = state->T, .dT = dT};
    for (int k = 0; sim->physics.list[k]; k++) {
        const ovr_physics_in_output *of = sim->physics.list[k]->in_output;
        if (of && of->unknown)
            of->unknown(o);
    }
    o->load_ratio = ovr_history_value(sim->histories.load, state->T);
    o->speed_ratio = ovr_history_value(sim->histories.speed, state->T);
    o->radius_ratio = ovr_history_value(sim->histories.radius, state->T);
    if (sim->physics.solver) {
        sim->physics.solver->is->in_solve->solver->observe(
            sim, sim->physics.solver->own, o);
    } else {
        ovr_observe_line(sim, o);
        o->mass_balance = dT > 0 ? ovr_mass_balance(sim) : 0;
    }
    o->load_error = o->load / OVR_NOMINAL_LOAD - o->load_ratio;
    /* NAN: diverged, or not computed */
    o->residual = isfinite(outcome->defect.imbalance)
                      ? outcome->defect.imbalance
                      : NAN;
    o->order = outcome->uncorrected ? sim->scheme->order : sim->order;
    o->cycles = outcome->cycles;
    o->retries = outcome->retries;
    o->converged = outcome->converged;
    o->marked = outcome->marked;
    OVR_EACH_PHYSICS(sim, p, in_output, observe)
        p->is->in_output->observe(sim, p->own, o);
    if (is_meaningless(sim, outcome))
        withhold(o);
    ovr_statistics_take(&sim->statistics, o, state->step == 0);
}

/* ---------------------------------------------- extremes and means of a run */

/* Extremes of quantities over a run, with place and time, and means. The table
 * row of a quantity selects what is stored. */

/* Address of a member of type double in an observation or a struct with the
 * same members. */
static double *member(ovr_observation *of, size_t offset)
{
    return (double *)(void *)((char *)of + offset);
}

static double number(const ovr_observation *of, size_t offset)
{
    return *(const double *)(const void *)((const char *)of + offset);
}

/* A value is also stored if the stored one is unknown. */
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

/* Bit of a quantity in flagged_extremes. */
static unsigned long long bit_of(const ovr_observable *row)
{
    const ovr_observable *other;
    int bit = 0;
    for (size_t k = 0; (other = ovr_observable_at(k)) && other != row; k++)
        bit += other->extreme_key != NULL;
    return 1ULL << bit % 64;
}

static void update_extreme(ovr_statistics *s, const ovr_observable *row,
                           const ovr_observation *o, bool first)
{
    double value = number(o, row->offset);
    if (!first &&
        !is_beyond(row->extreme, value, number(&s->extreme, row->offset)))
        return;
    *member(&s->extreme, row->offset) = value;
    *member(&s->when, row->offset) = o->T;
    if (s->flagged_extremes)
        s->flagged_extremes &= ~bit_of(row);
    *member(&s->where, row->offset) = row->place ? number(o, row->place) : NAN;
}

/* Updates a mean; `part` is the fraction of the elapsed time in this step. */
static void update_mean(ovr_statistics *s, const ovr_observable *row,
                        const ovr_observation *o, double part)
{
    double *mean = member(&s->mean, row->offset);
    double value = number(o, row->offset);
    if (part > 0)
        *mean = part < 1 ? *mean + part * (value - *mean) : value;
}

void ovr_statistics_flag(ovr_statistics *s, const ovr_observation *o)
{
    const ovr_observable *row;
    for (size_t k = 0; (row = ovr_observable_at(k)); k++)
        if (row->extreme_key && number(&s->when, row->offset) == o->T)
            s->flagged_extremes |= bit_of(row);
}

bool ovr_extreme_is_flagged(const ovr_extreme *which, const ovr_statistics *of)
{
    return which->part == OVR_KEPT_EXTREME &&
           of->flagged_extremes & bit_of(which->of);
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
            update_extreme(s, row, o, first);
        if (row->mean_key)
            update_mean(s, row, o, part);
    }
    s->averaged = o->T;
    if (s->when.H_min_located == o->T)
        s->H_mean_at_H_min = o->H_mean;
    if (first || o->P_unresolved > s->P_unresolved) {
        s->P_unresolved = o->P_unresolved;
        s->X_unresolved = o->X_unresolved;
        s->T_unresolved = o->T;
    }
    if (first || o->T_max_finer > s->T_max_finer) {
        s->T_max_finer = o->T_max_finer;
        s->T_T_max_finer = o->T;
    }
    if (first || s->when.T_max_rise == o->T)
        s->defect_at_T_max = o->energy_defect;
    s->P_max_unresolved = !ovr_is_resolved(s->extreme.P_max, s->P_unresolved);
    if (o->marked)
        ovr_statistics_flag(s, o);
}

void ovr_statistics_unknown(ovr_statistics *s)
{
    ovr_extreme e;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        *ovr_kept_number(&e, s) = NAN;
}

/* ------------------------------------------------------------------- list */

#define PUT(text, ...) snprintf(text, sizeof(text), __VA_ARGS__)

/* Length of the stem of a key: of "P_max" in "P_max_overall". */
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
