/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * q = rho H of past times at the departure points of the characteristic.
 *
 * Between nodes: Lagrange interpolation on six nodes (order 6; the scheme has
 * order 2), shifted at the outlet to stay on the grid. Upstream of the inlet: P
 * = 0, so q = H = H0 + X^2/2 - S - w (curvature.h) with w summed directly for
 * the few ghost nodes needed.
 */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "multigrid/field.h"
#include "simulation/mirror.h"

enum { POINTS = 6, BEFORE = 2 };

ovr_status ovr_inflow_take(ovr_simulation *sim, ovr_error *err)
{
    ovr_inflow *inflow = &sim->inflow;
    size_t n = sim->now.n;
    if (!sim->scheme->characteristic)
        return OVR_OK;
    inflow->kernel = ovr_field(&sim->arena, n + OVR_GHOSTS + 1, err);
    inflow->X = ovr_field(&sim->arena, OVR_GHOSTS, err);
    inflow->S = ovr_field(&sim->arena, OVR_GHOSTS, err);
    inflow->extended = ovr_field(&sim->arena, n + OVR_GHOSTS, err);
    return ovr_arena_status(&sim->arena);
}

void ovr_inflow_fill(ovr_simulation *sim)
{
    ovr_inflow *inflow = &sim->inflow;
    size_t n = sim->now.n;
    if (sim->options.scheme != OVR_CHARACTERISTIC)
        return;
    for (size_t d = 0; d <= n + OVR_GHOSTS; d++)
        inflow->kernel[d] = ovr_influence_at(&sim->grids.influence, (double)d,
                                             ovr_mesh(sim));
}

bool ovr_inflow_reaches(const ovr_simulation *sim, double travel)
{
    return fabs(travel) / ovr_mesh(sim) < OVR_GHOSTS - POINTS;
}

/* Returns the pressure on the solids, starting at the inlet; uses the array for
 * q as workspace. */
static const double *pressure_of(const ovr_simulation *sim, int past, bool back)
{
    double *workspace = sim->inflow.extended + OVR_GHOSTS;
    const double *P = sim->past.P[past];
    const double *asperity_P = past ? sim->asperity_P_before[past - 1]
                                    : sim->asperity_P;
    size_t n = sim->now.n;
    if (!back && !asperity_P)
        return P;
    for (size_t i = 0; i < n; i++) {
        size_t from = back ? n - 1 - i : i;
        workspace[i] = P[from] + (asperity_P ? asperity_P[from] : 0);
    }
    return workspace;
}

/* Computes q at the ghost nodes nearest to the inlet, stored before
 * extended[OVR_GHOSTS]. The inlet is on the right if `back`. */
static void ghost_film(ovr_simulation *sim, int past, size_t ghosts, bool back)
{
    const ovr_inflow *inflow = &sim->inflow;
    const double *P = pressure_of(sim, past, back);
    const ovr_smooth smooth = ovr_simulation_smooth(sim, sim->past.T[past]);
    size_t n = sim->now.n;
    double out = back ? ovr_mesh(sim) : -ovr_mesh(sim);
    if (ovr_conserves(sim) && ovr_arrival_closes(sim)) {
        ovr_arrival_ghosts(sim, sim->past.T[past], ghosts,
                           inflow->extended + OVR_GHOSTS - 1);
        return;
    }
    for (size_t g = 0; g < ghosts; g++)
        inflow->X[g] = sim->now.X[back ? n - 1 : 0] + (double)(g + 1) * out;
    if (ovr_has_heights(sim))
        ovr_surface_heights(sim, sim->past.T[past], ghosts, inflow->X,
                            inflow->S);
    for (size_t g = 0; g < ghosts; g++) {
        double X = inflow->X[g];
        double w = sim->grids.kernels->gain(n, inflow->kernel + g + 1, P, NULL);
        inflow->extended[OVR_GHOSTS - 1 - g] = sim->past.H0[past] +
                                               ovr_smooth_at(&smooth, X) -
                                               inflow->S[g] - w;
    }
}

void ovr_inflow_ghosts(ovr_simulation *sim, int past, size_t ghosts)
{
    ghost_film(sim, past, ghosts, false);
}

void ovr_lagrange(double at, double weight[POINTS])
{
    for (int k = 0; k < POINTS; k++) {
        weight[k] = 1;
        for (int j = 0; j < POINTS; j++)
            if (j != k)
                weight[k] *= (at - j) / (k - j);
    }
}

/* Distance to a departure point in mesh sizes, and rounded up to whole nodes.
 */
typedef struct departure_offset {
    double meshes;
    size_t shift;
    bool on_node, back; /* back: the following data belong to the mirror image
                         */
} departure_offset;

static departure_offset offset_of(const ovr_simulation *sim, double a)
{
    double meshes = fabs(a) / ovr_mesh(sim), whole = nearbyint(meshes);
    bool on_node = fabs(meshes - whole) < 1e-9;
    if (!on_node)
        whole = ceil(meshes);
    return (departure_offset){meshes, (size_t)whole, on_node, a < 0};
}

static void add(size_t n, double c, const double *restrict x,
                double *restrict F)
{
    for (size_t i = 0; i < n; i++)
        F[i] += c * x[i];
}

/* F_i += c q(X_i - a), for q stored after the ghost nodes in `extended` */
static void add_at_departures(const ovr_simulation *sim,
                              const departure_offset *to, double c, double *F)
{
    const double *q = sim->inflow.extended;
    double weight[POINTS];
    size_t n = sim->now.n;
    const double *departure = q + OVR_GHOSTS - to->shift;
    if (to->on_node && !to->back) {
        add(n, c, departure, F);
        return;
    }
    if (to->on_node) {
        for (size_t i = 0; i < n; i++)
            F[n - 1 - i] += c * departure[i];
        return;
    }
    for (size_t i = 0; i < n; i++) {
        const double *first = departure + i - BEFORE;
        const double *last = q + OVR_GHOSTS + n - POINTS;
        size_t inward = first > last ? (size_t)(first - last) : 0;
        double sum = 0;
        if (i == 0 || inward)
            ovr_lagrange(BEFORE + (double)inward +
                             ((double)to->shift - to->meshes),
                         weight);
        for (int k = 0; k < POINTS; k++)
            sum += weight[k] * *(first - inward + k);
        F[to->back ? n - 1 - i : i] += c * sum;
    }
}

/* F_i += c q(X_i - a) */
static void add_departure(ovr_simulation *sim, int past, double c, double a,
                          double *F)
{
    double *q = sim->inflow.extended;
    size_t n = sim->now.n;
    const departure_offset to = offset_of(sim, a);
    ghost_film(sim, past, to.shift + (to.on_node ? 0 : BEFORE), to.back);
    if (to.back)
        ovr_mirror(n, sim->past.q[past], q + OVR_GHOSTS);
    else
        memcpy(q + OVR_GHOSTS, sim->past.q[past], n * sizeof(double));
    add_at_departures(sim, &to, c, F);
}

size_t ovr_inflow_departure(const ovr_simulation *sim, const double *q,
                            double c, double a, double *F)
{
    double *extended = sim->inflow.extended;
    const departure_offset to = offset_of(sim, a);
    memset(extended, 0, OVR_GHOSTS * sizeof *extended);
    memcpy(extended + OVR_GHOSTS, q, sim->now.n * sizeof *q);
    add_at_departures(sim, &to, c, F);
    return to.shift + BEFORE;
}

void ovr_inflow_history(ovr_simulation *sim, const double c[2],
                        const double a[2], double *F)
{
    memset(F, 0, sim->now.n * sizeof *F);
    add_departure(sim, 0, c[0], a[0], F);
    add_departure(sim, 1, c[1], a[1], F);
}

bool ovr_inflow_prediction(ovr_simulation *sim, double T, const double e[3],
                           double *q)
{
    for (int k = 0; k < 3; k++)
        if (!ovr_inflow_reaches(sim, ovr_travel_since(sim, k, T)))
            return false;
    memset(q, 0, sim->now.n * sizeof *q);
    for (int k = 0; k < 3; k++)
        add_departure(sim, k, e[k], ovr_travel_since(sim, k, T), q);
    return true;
}

bool ovr_inflow_third(ovr_simulation *sim, const double *q, double T, double dT,
                      double *third)
{
    const ovr_past *past = &sim->past;
    size_t n = sim->now.n;
    double t[4] = {T}, weight[4];
    for (int k = 1; k < 4; k++) {
        bool known = past->T[k - 1] < t[k - 1];
        t[k] = known ? past->T[k - 1] : t[k - 1] - dT;
    }
    for (int k = 0; k < 4; k++) {
        weight[k] = 1;
        for (int j = 0; j < 4; j++)
            if (j != k)
                weight[k] /= t[k] - t[j];
    }
    double now = ovr_history_integral(sim->histories.speed, T);
    if (!ovr_inflow_reaches(
            sim, now - ovr_history_integral(sim->histories.speed, t[3])))
        return false;
    for (size_t i = 0; i < n; i++)
        third[i] = weight[0] * q[i];
    for (int k = 1; k < 4; k++)
        add_departure(sim, k - 1, weight[k],
                      now - ovr_history_integral(sim->histories.speed, t[k]),
                      third);
    return true;
}

/* Before the first step, the past is assumed to be as long as the step. */
double ovr_travel_since(const ovr_simulation *sim, int past, double T)
{
    const ovr_past *known = &sim->past;
    double since = past == 0 || known->dT > 0 ? known->T[past]
                                              : 2 * known->T[0] - T;
    return ovr_history_integral(sim->histories.speed, T) -
           ovr_history_integral(sim->histories.speed, since);
}
