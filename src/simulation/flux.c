/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The flow through half nodes, as the scheme has it. */
#include "simulation/physics.h"

/* 2 E of half node i + 1/2 */
static double twice_flow(const ovr_solution *now, size_t i)
{
    return now->flow ? now->flow[i] : now->eps[i] + now->eps[i + 1];
}

double ovr_upstream(const ovr_simulation *sim, const double *q, size_t i)
{
    const double *u = sim->scheme->upstream;
    if (sim->backward && i + 2 == sim->now.n)
        return sim->scheme->order == 2 ? 0.5 * (q[i] + q[i + 1]) : q[i + 1];
    if (sim->backward)
        return u[0] * q[i + 1] + u[1] * q[i + 2];
    if (i == 0)
        return sim->scheme->order == 2 ? 0.5 * (q[0] + q[1]) : q[0];
    return u[0] * q[i] + u[1] * q[i - 1];
}

/* Content that the film carries along at half node i + 1/2. */
static double carried(const ovr_simulation *sim, size_t i)
{
    double q = ovr_upstream(sim, sim->now.q, i);
    OVR_EACH_PHYSICS(sim, p, carried)
        q = p->is->carried(sim, p->own, i, q);
    return q;
}

double ovr_flow_beside(const ovr_simulation *sim, size_t i, bool mean)
{
    double flow = 0;
    OVR_EACH_PHYSICS(sim, p, flow)
        flow += p->is->flow(sim, p->own, i, mean);
    return flow;
}

/* The scheme's own flux at half node i + 1/2: upstream wedge and Poiseuille
 * flow. */
double ovr_flux(const ovr_simulation *sim, double Cu, size_t i)
{
    const double *P = sim->now.P, *X = sim->now.X;
    return Cu * carried(sim, i) + ovr_flow_beside(sim, i, false) -
           0.5 * twice_flow(&sim->now, i) * (P[i + 1] - P[i]) /
               (X[i + 1] - X[i]);
}
