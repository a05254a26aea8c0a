/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Observes what there is after a solve or step. */
#include "simulation/observe.h"

#include <math.h>

#include "contact/contact.h"
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

/* Returns whether the mesh resolves the maximum of v at node i: on average, the
 * values two nodes away are at least two thirds of it.  The pressure of a
 * Newtonian film at a surface feature is singular like the logarithm of the
 * distance; there, the ratio is about a half on any mesh. */
static bool maximum_is_resolved(size_t n, const double *v, size_t i)
{
    double left = i > 1 ? v[i - 2] : v[0];
    double right = i + 2 < n ? v[i + 2] : v[n - 1];
    return !((left + right) / 2 < 2.0 / 3 * v[i]);
}

int ovr_prominent_maxima(size_t n, const double *P, size_t *last)
{
    double low = P[0]; /* lowest since the last that stood out */
    int count = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        low = P[i] < low ? P[i] : low;
        if (!(P[i] > P[i - 1] && P[i] >= P[i + 1]))
            continue;
        if (P[i] > low + OVR_PROMINENCE)
            count++;
        else if (!count || !(P[i] > P[*last]))
            continue; /* nothing, or a lower one of the same maximum */
        *last = i;
        low = P[i];
    }
    return count;
}

/* The nodes in a window, from `first` to before `behind`. */
typedef struct inside {
    size_t first, behind;
} inside;

static inside nodes_inside(const ovr_solution *now, double window)
{
    inside in = {0, now->n};
    while (in.first < in.behind && !(fabs(now->X[in.first]) < window))
        in.first++;
    while (in.behind > in.first && !(fabs(now->X[in.behind - 1]) < window))
        in.behind--;
    return in;
}

/* The film's mean in the window; and the root mean square of rho H, which
 * neither compresses nor flows there, about its mean, over the mean density. */
static double mean_film(const ovr_simulation *sim, inside in, double *roughness)
{
    enum { WIDTH, FILM, DENSITY, CONTENT, SQUARES, SUMS };
    const ovr_solution *now = &sim->now;
    double sum[SUMS];
    sim->grids.kernels->film_sums(in.behind - in.first, now->weights + in.first,
                                  now->q + in.first, now->H + in.first, sum);
    double squares = sum[SQUARES] * sum[WIDTH] - sum[CONTENT] * sum[CONTENT];
    *roughness = sqrt(fmax(squares, 0)) / sum[DENSITY];
    return sum[FILM] / sum[WIDTH];
}

/* True at nodes with pressure, of the film or of asperities, and next to
 * them. */
static bool bears(const double *P, size_t i)
{
    return P[i - 1] > 0 || P[i] > 0 || P[i + 1] > 0;
}

/* Finds the minimum film thickness: the smallest gap that bears load.  Rough
 * surfaces may be closer to each other in the cavity. */
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
    if (!low) /* a film without pressure */
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
    /* less than that of the nominal contact where the contact is narrower */
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

/* Maxima that stand out, and the last of them along the flow. */
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
    if (maxima > 1) /* most of them may be noise */
        maxima = ovr_prominent_maxima(n, P, last);
    if (sim->histories.backward)
        *last = n - 1 - *last;
    ovr_work_give(sim, image);
    return maxima;
}

/* The cavitated node behind the last wet one along the flow. */
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
    o->P_max_resolved = maximum_is_resolved(n, P, high);
    o->P_cen = ovr_value_at(&sim->now, P, 0);
    o->maxima = maxima;
    o->X_cavitation = sim->now.X[film_end(sim)];
    o->P_spike = o->X_spike = NAN;
    o->P_spike_resolved = true;
    o->P_spike_located = o->X_spike_located = NAN;
    if (maxima >= 2 && exit * sim->now.X[spike] > 0) {
        o->P_spike = P[spike];
        o->P_spike_resolved = maximum_is_resolved(n, P, spike);
        o->X_spike = sim->now.X[spike];
        o->X_spike_located = ovr_vertex(sim->now.X, P, spike,
                                        &o->P_spike_located);
    }
    double *solid = ovr_work_take(sim);
    o->load = ovr_integral(sim, ovr_solid_pressure(sim, solid));
    ovr_work_give(sim, solid);
}

/* Node by node, with what flows beside the film's own; either way. */
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

/* The same inside, where it has two nodes upstream, over all that is wet. */
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

/* True if what a failed solve left is no approximation of a film: somewhere it
 * is not open, or R is of the size of the flow itself. */
static bool is_meaningless(const ovr_simulation *sim,
                           const ovr_outcome *outcome)
{
    if (outcome->converged || outcome->marked)
        return false;
    return !ovr_surfaces_apart(sim) || !(fabs(outcome->defect.imbalance) <= 1);
}

/* Replaces numbers that follow from the film by NAN; counts and flags stay. */
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
    o->residual = outcome->defect.imbalance;
    o->order = sim->order;
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
