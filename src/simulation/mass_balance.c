/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Mass balance of a step, computed with independent quadrature rules: the
 * discrete equation conserves its own fluxes to the algebraic error on any
 * mesh, so its balance does not measure the discretization error.
 *
 *     error = [inflow - outflow]_{mean of both times}
 *             - (stored mass now - before)/dT,
 *             relative to the flow in the contact
 *     flux  = Cu (q_i + q_{i+1})/2 - eps_{i+1/2} (P_{i+1} - P_i)/D
 *     mass  = sum of weights q over the nodes between the two half nodes
 *
 * from half node 1/2 to the last one that is pressurized at both times. All
 * rules are of second order in D and dT, and so is the error.  The flow in the
 * contact is the mean absolute flow over these half nodes: in steady rolling
 * the mass flow rate, under varying load also the squeeze flow (the net inflow
 * can then be zero). If um reverses, the balance covers the pressurized film
 * around X = 0 at both times, and the error is relative to at least H_cen, the
 * flow at the reference speed.
 */
#include <math.h>

#include "contact/contact.h"
#include "contact/history.h"
#include "multigrid/flow.h"
#include "simulation/observe.h"
#include "simulation/physics.h"

/* -------------------------------------------------- Flow through half nodes */

/* 2 E of half node i + 1/2 */
static double twice_flow(const ovr_solution *now, size_t i)
{
    return now->flow ? now->flow[i] : now->eps[i] + now->eps[i + 1];
}

double ovr_upstream(const ovr_simulation *sim, const double *q, size_t i)
{
    const double *u = sim->scheme->upstream;
    if (sim->histories.backward && i + 2 == sim->now.n)
        return sim->scheme->order == 2 ? 0.5 * (q[i] + q[i + 1]) : q[i + 1];
    if (sim->histories.backward)
        return u[0] * q[i + 1] + u[1] * q[i + 2];
    if (i == 0)
        return sim->scheme->order == 2 ? 0.5 * (q[0] + q[1]) : q[0];
    return u[0] * q[i] + u[1] * q[i - 1];
}

/* Content convected with the film at half node i + 1/2. */
static double carried(const ovr_simulation *sim, size_t i)
{
    double q = ovr_upstream(sim, sim->now.q, i);
    OVR_EACH_PHYSICS(sim, p, in_output, carried)
        q = p->is->in_output->carried(sim, p->own, i, q);
    return q;
}

double ovr_flow_of_physics(const ovr_simulation *sim, size_t i, bool mean)
{
    double flow = 0;
    OVR_EACH_PHYSICS(sim, p, in_output, flow)
        flow += p->is->in_output->flow(sim, p->own, i, mean);
    return flow;
}

/* Mass flow of the discrete scheme at half node i + 1/2: upstream wedge and
 * Poiseuille flow. */
double ovr_flux(const ovr_simulation *sim, double Cu, size_t i)
{
    const double *P = sim->now.P, *X = sim->now.X;
    return Cu * carried(sim, i) + ovr_flow_of_physics(sim, i, false) -
           0.5 * twice_flow(&sim->now, i) * (P[i + 1] - P[i]) /
               (X[i + 1] - X[i]);
}

/* ------------------------------------------------------------------ Balance */

/* E at half node i + 1/2 and time T, with the present temperatures. */
static double poiseuille(const ovr_simulation *sim, double T, const double *P,
                         const double *q, size_t i)
{
    ovr_fluid fluid = sim->grids.fluid;
    ovr_pair nodes;
    fluid.sliding = ovr_sliding(sim, T);
    for (size_t k = 0; k < 2; k++) {
        double thinner = 1, lighter = 1;
        OVR_EACH_PHYSICS(sim, p, in_output, oil)
            p->is->in_output->oil(sim, p->own, i + k, &thinner, &lighter);
        double rho = lighter * ovr_density(&sim->lubricant, P[i + k]);
        nodes.P[k] = P[i + k];
        nodes.q[k] = q[i + k];
        nodes.H[k] = q[i + k] / rho;
        nodes.eps[k] = thinner * ovr_flow(&fluid, P[i + k], nodes.H[k]);
    }
    return ovr_flow_between(&fluid, sim->now.X[i + 1] - sim->now.X[i], &nodes);
}

static double central_flux(const ovr_simulation *sim, double T, const double *P,
                           const double *q, size_t i)
{
    double Cu = ovr_history_value(sim->histories.speed, T);
    return 0.5 * Cu * (q[i] + q[i + 1]) + ovr_flow_of_physics(sim, i, true) -
           poiseuille(sim, T, P, q, i) * (P[i + 1] - P[i]) /
               (sim->now.X[i + 1] - sim->now.X[i]);
}

static size_t last_wet(const double *P, size_t n)
{
    size_t i = n - 2;
    while (i > 1 && !(P[i] > 0))
        i--;
    return i;
}

/* Range of half nodes between nodes that are pressurized at both times. */
typedef struct stretch {
    size_t first, last;
} stretch;

/* The range that starts at the inlet. */
static stretch from_inlet(const ovr_past *past, size_t n)
{
    size_t last = last_wet(past->P[0], n), before = last_wet(past->P[1], n);
    return (stretch){0, (before < last ? before : last) - 1};
}

/* The connected range around X = 0, without the nodes next to the ends, where
 * temperatures jump. */
static stretch about_middle(const ovr_past *past, size_t n)
{
    enum { BESIDE = 4 };
    const double *now = past->P[0], *then = past->P[1];
    stretch s = {n / 2, n / 2};
    while (s.first > BESIDE && now[s.first - 1] > 0 && then[s.first - 1] > 0)
        s.first--;
    while (s.last < n - 1 - BESIDE && now[s.last + 1] > 0 &&
           then[s.last + 1] > 0)
        s.last++;
    s.last--;
    return s;
}

/* Integral of the absolute flow over these half nodes, including flow from
 * physical models. */
static double flow_size(const ovr_simulation *sim, double Cu, stretch s)
{
    const double *P = sim->now.P, *q = sim->now.q, *eps = sim->now.eps;
    const double *X = sim->now.X, *flow = sim->now.flow;
    double sum = 0;
    for (size_t i = s.first; i <= s.last; i++) {
        double twice = flow ? flow[i] : eps[i] + eps[i + 1];
        double through = Cu * (q[i] + q[i + 1]) / 2 +
                         ovr_flow_of_physics(sim, i, true);
        sum += fabs(through * (X[i + 1] - X[i]) -
                    twice / 2 * (P[i + 1] - P[i]));
    }
    return sum;
}

/* Mean absolute flow over these half nodes at the end of the step. */
static double own_flow(const ovr_simulation *sim, double Cu, stretch s)
{
    enum { NODES = 16 }; /* more than the number of vector elements */
    const ovr_solution *now = &sim->now;
    size_t first = s.first, n = s.last - first + 2;
    const double *flow = now->flow ? now->flow + first : NULL;
    double length = now->X[s.last + 1] - now->X[first];
    OVR_LAST_PHYSICS(sim, p, in_output, flow);
    if (p->is || n < NODES)
        return flow_size(sim, Cu, s) / length;
    return sim->grids.kernels->flow_size(n, Cu, now->X + first, now->P + first,
                                         now->q + first, now->eps + first,
                                         flow) /
           length;
}

double ovr_mass_balance(const ovr_simulation *sim)
{
    const ovr_past *past = &sim->past;
    bool reverses = ovr_history_reverses(sim->histories.speed);
    stretch s = (reverses ? about_middle : from_inlet)(past, sim->now.n);
    double dT = past->dT, in[2], out[2], stored, scale;
    if (!(dT > 0) || s.last < s.first + 2)
        return 0;
    for (int k = 0; k < 2; k++) {
        double T = past->T[k];
        in[k] = central_flux(sim, T, past->P[k], past->q[k], s.first);
        out[k] = central_flux(sim, T, past->P[k], past->q[k], s.last);
    }
    stored = sim->grids.kernels->gain(
        s.last - s.first, sim->now.weights + s.first + 1,
        past->q[0] + s.first + 1, past->q[1] + s.first + 1);
    double net = 0.5 * (in[0] - out[0] + in[1] - out[1]);
    scale = own_flow(sim, ovr_history_value(sim->histories.speed, past->T[0]),
                     s);
    if (reverses)
        scale = fmax(scale, sim->observation.H_cen);
    double error = net - stored / dT;
    return scale > 0 ? error / scale : error;
}
