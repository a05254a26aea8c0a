/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is observed after a solve or step. */
#include <math.h>

#include "simulation/internal.h"

/* Vertex of the parabola through (i-1, i, i+1): position in meshes from i,
 * and value. */
static double vertex(const double *v, size_t i, double *value)
{
    double slope = 0.5 * (v[i + 1] - v[i - 1]);
    double curvature = v[i + 1] - 2 * v[i] + v[i - 1];
    double shift = curvature != 0 ? -slope / curvature : 0;
    if (!(fabs(shift) <= 1))
        shift = 0;
    *value = v[i] + shift * (slope + 0.5 * shift * curvature);
    return shift;
}

static void observe_film(const ovr_simulation *sim, ovr_observation *o)
{
    const double *H = sim->finest->f.H;
    size_t n = sim->finest->n, low = 1;
    for (size_t i = 2; i + 1 < n; i++)
        if (H[i] < H[low])
            low = i;
    o->H_min = H[low];
    o->X_min = sim->X[low];
    o->X_min_located = o->X_min +
                       sim->finest->D * vertex(H, low, &o->H_min_located);
    o->H_cen = ovr_level_centre(&sim->grids, sim->finest, H);
    o->H0 = sim->grids.H0;
}

static void observe_pressure(const ovr_simulation *sim, ovr_observation *o)
{
    const double *P = sim->finest->f.P;
    size_t n = sim->finest->n, high = 1, spike = 0, wet = 0;
    int maxima = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        if (P[i] > P[high])
            high = i;
        if (P[i] > 0)
            wet = i;
        if (P[i] > P[i - 1] && P[i] >= P[i + 1]) {
            maxima++;
            if (sim->X[i] > 0)
                spike = i;
        }
    }
    o->P_max = P[high];
    o->X_P_max = sim->X[high];
    o->P_cen = ovr_level_centre(&sim->grids, sim->finest, P);
    o->maxima = maxima;
    o->X_cavitation = sim->X[wet + 1];
    o->P_spike = o->X_spike = NAN;
    o->P_spike_located = o->X_spike_located = NAN;
    if (maxima >= 2 && spike) {
        o->P_spike = P[spike];
        o->X_spike = sim->X[spike];
        o->X_spike_located =
            o->X_spike + sim->finest->D * vertex(P, spike, &o->P_spike_located);
    }
    o->load = ovr_level_load(&sim->grids, sim->finest);
}

/* The scheme's own flux at half node i + 1/2: upstream wedge and Poiseuille
 * flow. */
static double flux(const ovr_simulation *sim, double Cu, size_t i)
{
    const ovr_fields *f = &sim->finest->f;
    double upstream = f->q[i];
    if (sim->options.scheme != OVR_UPSTREAM1)
        upstream = i ? 1.5 * f->q[i] - 0.5 * f->q[i - 1]
                     : 0.5 * (f->q[0] + f->q[1]);
    return Cu * upstream - 0.5 * (f->eps[i] + f->eps[i + 1]) *
                               (f->P[i + 1] - f->P[i]) / sim->finest->D;
}

/* Mean over the wet half nodes: both neighbours under pressure. */
static double mean_flow(const ovr_simulation *sim)
{
    const double *P = sim->finest->f.P;
    double sum = 0, Cu = ovr_history_value(sim->speed, sim->state.T);
    size_t count = 0;
    for (size_t i = 1; i + 2 < sim->finest->n; i++)
        if (P[i] > 0 && P[i + 1] > 0) {
            sum += flux(sim, Cu, i);
            count++;
        }
    return count ? sum / (double)count : 0;
}

void ovr_simulation_fields(const ovr_simulation *sim, double *rho, double *eta,
                           double *flow)
{
    const ovr_fields *f = &sim->finest->f;
    double Cu = ovr_history_value(sim->speed, sim->state.T);
    for (size_t i = 0; i < sim->finest->n; i++) {
        if (rho)
            rho[i] = ovr_density(&sim->lubricant, f->P[i]);
        if (eta)
            eta[i] = ovr_viscosity(&sim->lubricant, f->P[i]);
        if (flow && i + 1 < sim->finest->n)
            flow[i] = flux(sim, Cu, i);
    }
}

static void observe_extremes(ovr_simulation *sim)
{
    ovr_statistics *s = &sim->statistics;
    const ovr_observation *o = &sim->observation;
    if (sim->state.step == 0 || o->H_min_located < s->H_min) {
        s->H_min = o->H_min_located;
        s->T_H_min = o->T;
    }
}

void ovr_publish_state(ovr_simulation *sim)
{
    ovr_state *state = &sim->state;
    state->n = sim->finest->n;
    state->D = sim->finest->D;
    state->X = sim->X;
    state->P = sim->finest->f.P;
    state->H = sim->finest->f.H;
    state->S = sim->S;
    state->H0 = sim->grids.H0;
}

void ovr_observe(ovr_simulation *sim, double dT, const ovr_outcome *outcome)
{
    ovr_observation *o = &sim->observation;
    const ovr_state *state = &sim->state;
    ovr_publish_state(sim);
    *o = (ovr_observation){.T = state->T, .dT = dT};
    observe_film(sim, o);
    observe_pressure(sim, o);
    o->load_ratio = ovr_history_value(sim->load, state->T);
    o->speed_ratio = ovr_history_value(sim->speed, state->T);
    o->mass_flow = mean_flow(sim);
    o->mass_balance = dT > 0 ? ovr_mass_balance(sim) : 0;
    o->load_error = o->load / OVR_NOMINAL_LOAD - o->load_ratio;
    o->residual = outcome->defect.imbalance;
    o->cycles = outcome->cycles;
    o->retries = outcome->retries;
    o->converged = outcome->converged;
    o->marked = outcome->marked;
    observe_extremes(sim);
}
