/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * History term with mass-conserving cavitation (multigrid/content.h), with s =
 * dT/dT_old, kappa = s/(1 + s), b2 = s^2/(1 + s):
 *
 *     F = -(B + kappa q^k)/dT,   B = (1 + b2) q^k - b2 q^{k-1},
 *     if the node was cavitated  B = max(B, q^k/2)
 *
 * which is that of BDF2 except for the limits. With equal steps B equals A of
 * the previous step, so that the stored mass telescopes.
 */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "multigrid/field.h"
#include "simulation/internal.h"
#include "simulation/mirror.h"

/* ------------------------------------------ Lubricant upstream of the inlet */

bool ovr_conserves(const ovr_simulation *sim)
{
    return sim->options.cavitation == OVR_CAVITATION_CONSERVING;
}

/* Time at which material that is `distance` upstream of the inlet at T reaches
 * the inlet; if the surfaces do not move, some later time. */
static double time_of_arrival(const ovr_simulation *sim, double T,
                              double distance)
{
    enum { DOUBLINGS = 10, HALVINGS = 50 };
    double to = ovr_history_integral(sim->histories.speed, T) + distance;
    double low = T, high = T + distance,
           Cu = ovr_history_value(sim->histories.speed, T);
    if (!ovr_history_varies(sim->histories.speed))
        return T + distance / Cu;
    for (int k = 0; k < DOUBLINGS; k++)
        if (ovr_history_integral(sim->histories.speed, high) < to)
            high = T + 2 * (high - T);
    for (int k = 0; k < HALVINGS; k++) {
        double middle = 0.5 * (low + high);
        *(ovr_history_integral(sim->histories.speed, middle) < to
              ? &low
              : &high) = middle;
    }
    return 0.5 * (low + high);
}

bool ovr_arrival_closes(const ovr_simulation *sim)
{
    const ovr_arrival *a = &sim->arrival;
    return a->supply && (a->closed || a->reservoir < 0);
}

void ovr_arrival_ghosts(const ovr_simulation *sim, double T, size_t ghosts,
                        double *last)
{
    const ovr_arrival *a = &sim->arrival;
    for (size_t g = 0; g < ghosts; g++) {
        double distance = (double)(g + 1) * ovr_mesh(sim);
        last[-(ptrdiff_t)g] = a->supply(a->data,
                                        time_of_arrival(sim, T, distance));
    }
}

/* ------------------------------------------------- Along the characteristic */

/*
 * Mass-conserving cavitation along the characteristic (multigrid/content.h has
 * it with a wedge).  All content moves along the characteristic, so the history
 * term applies to the content that arrives at a node; a = travel in the step:
 *
 *     A_i = (1 + kappa) q_i - kappa q^k(X_i - a),   B_i = B(X_i - a),
 *     B(X) = (1 + b2) q^k(X) - b2 q^{k-1}(X - a_old),
 *     if the node was cavitated  B = max(B, q^k/2)
 *
 * and with equal steps B is A of the step before.  q^{k-1}(X - a_old) is the
 * content that arrived at the nodes in the previous step, so that interpolation
 * is needed over the travel of one step only.
 *
 * Cells are moved by whole mesh sizes plus a fraction p. The fraction is
 * computed from fluxes f_{i+1/2} through the faces, which conserve mass for any
 * f,
 *
 *     q(X_i - p D) = q_i - f_{i+1/2} + f_{i-1/2},
 *
 * by six-point Lagrange interpolation between five full cells. Elsewhere,
 * because contents jump at a meniscus, f = p (q_i + (1 - p) s_i/2) with van
 * Leer's limited slope s_i, which creates no new extremes and no negative
 * contents. Therefore
 *
 *     D sum (A - B) = dT (inflow - outflow) + residuals
 *
 * where the flows are the Poiseuille flow plus D/dT times the content that
 * crosses the first and last face of rows 1..n-2, for any travel.  A and B are
 * contents half a step downstream; for contents at the nodes, (1 + kappa) q -
 * kappa q^{k-1} etc., the flows are, with X_B and X_q the parts of B and q that
 * cross the face,
 *
 *     Q = D (X_B + kappa X_q^k - b2 X_q^{k-1})/dT,
 *
 * which are reported. The content that crosses the first face is the supply if
 * the inlet is closed, and otherwise that of the flooded gap upstream. In the
 * step in which the inlet closes or opens, Q = D X_B/dT there.
 */

/* Number of cells on either side that determine the high-order flux through a
 * face. */
enum { SIDE = 2, FACE = 2 * SIDE + 1, POINTS = 6 };

ovr_status ovr_carriage_take(ovr_simulation *sim, ovr_error *err)
{
    ovr_carriage *c = &sim->arrival.carriage;
    size_t n = sim->now.n;
    *c = (ovr_carriage){0};
    if (!sim->scheme->characteristic)
        return OVR_OK;
    c->came = ovr_field(&sim->arena, n, err);
    c->coming = ovr_field(&sim->arena, n, err);
    c->coming_twice = ovr_field(&sim->arena, n, err);
    c->extended = ovr_field(&sim->arena, n + OVR_GHOSTS, err);
    return ovr_arena_status(&sim->arena);
}

/* -------------------------------------------------------- convected content */

/* A travel in whole mesh sizes plus a fraction; weights of five cells in the
 * content that crosses a face. */
typedef struct move {
    ptrdiff_t whole;
    double part, weight[FACE];
} move;

static move move_of(const ovr_simulation *sim, double a)
{
    const double rounding = 1e-9;
    double meshes = a / ovr_mesh(sim), whole = floor(meshes + rounding);
    move m = {.whole = (ptrdiff_t)whole, .part = meshes - whole};
    double point[POINTS];
    if (m.part < rounding)
        m.part = 0;
    ovr_lagrange(SIDE + 1 - m.part, point);
    m.weight[0] = point[0];
    for (int k = 1; k < FACE; k++)
        m.weight[k] = m.weight[k - 1] + point[k] - (k == SIDE + 1);
    return m;
}

/* Slope of the content in a cell from its neighbours; zero at an extreme. */
static double limited_slope(const double *q)
{
    double before = q[0] - q[-1], after = q[1] - q[0];
    double product = before * after;
    return product > 0 ? 2 * product / (before + after) : 0;
}

/* Content that crosses from cell *q into the next. */
static double crosses(const move *m, const double *q, bool smooth)
{
    double sum = 0;
    if (!smooth)
        return m->part * (*q + 0.5 * (1 - m->part) * limited_slope(q));
    for (ptrdiff_t k = 0; k < FACE; k++)
        sum += m->weight[k] * q[k - SIDE];
    return sum;
}

static double sum_of(const double *q, ptrdiff_t first, ptrdiff_t last)
{
    double sum = 0;
    for (ptrdiff_t i = first; i <= last; i++)
        sum += q[i];
    return sum;
}

/* Moves contents q, with ghost cells before them, to the nodes; across[0] is
 * the content that crosses the first face of row 1, across[1] the last face of
 * row n - 2, in cells. */
static void carry(const ovr_simulation *sim, const move *m, const double *q,
                  double *to, double across[2])
{
    const double *P = sim->past.P[0];
    ptrdiff_t n = (ptrdiff_t)sim->now.n, s = m->whole, wet = 0;
    bool open = !ovr_arrival_closes(sim);
    double before = 0;
    across[0] = sum_of(q, 1 - s, 0);
    across[1] = sum_of(q, n - 1 - s, n - 2);
    if (m->part == 0) {
        memcpy(to, q - s, (size_t)n * sizeof *q);
        return;
    }
    for (ptrdiff_t j = -s - SIDE; j < n - 1 - s; j++) {
        ptrdiff_t ahead = j + SIDE;
        bool full = ahead <= 0 ? open : ahead < n && P[ahead] > 0;
        wet = full ? wet + 1 : 0;
        if (j < -s)
            continue;
        double f = crosses(m, q + j, wet >= FACE);
        if (j == -s)
            across[0] += f;
        else
            to[j + s] = q[j] - f + before;
        if (j == n - 2 - s)
            across[1] += f;
        before = f;
    }
    to[0] = q[-s];
    to[n - 1] = q[n - 1 - s];
}

/* ------------------------------------------------------------------- supply */

/* Content that the supply would add to the first row if the inlet were open. */
static double arriving(const ovr_simulation *sim, const move *m)
{
    double q[OVR_GHOSTS];
    size_t s = (size_t)m->whole;
    double *last = q + OVR_GHOSTS - 1;
    const ovr_arrival *a = &sim->arrival;
    ovr_arrival_ghosts(sim, sim->past.T[0], s, last - 1);
    *last = a->supply(a->data, sim->past.T[0]);
    return sum_of(last, 1 - (ptrdiff_t)s, 0) + m->part * last[-(ptrdiff_t)s];
}

/* Fills the ghost cells before row 1: q and its previous content, from the gap
 * upstream of the inlet or from the supply, which does not change on its way.
 */
static void fill_ghosts(ovr_simulation *sim, const move *m, const move *old,
                        double *q, double *came)
{
    ptrdiff_t ghosts = m->whole + SIDE + 1;
    if (!ovr_arrival_closes(sim)) {
        size_t more = (size_t)(ghosts + old->whole + SIDE + 1);
        memcpy(q, sim->past.q[1], (SIDE + 1) * sizeof *q);
        ovr_inflow_ghosts(sim, 1, more);
        for (ptrdiff_t g = 0; g <= ghosts; g++) {
            const double *departure = q - g - old->whole;
            bool between = old->part > 0;
            came[-g] = *departure - crosses(old, departure, between) +
                       crosses(old, departure - 1, between);
        }
        ovr_inflow_ghosts(sim, 0, (size_t)ghosts);
        *q = *sim->past.q[0];
        return;
    }
    ovr_arrival_ghosts(sim, sim->past.T[0], (size_t)ghosts, q - 1);
    *q = sim->arrival.supply(sim->arrival.data, sim->past.T[0]);
    memcpy(came - ghosts, q - ghosts, (size_t)(ghosts + 1) * sizeof *q);
}

/* ------------------------------------------------------------------- a step */

/* Present contents of the cells, and the contents that arrived there one step
 * ago. Before the first step, a steady state of the same duration is assumed.
 */
static void fill_nodes(ovr_simulation *sim, const move *m, double *q,
                       double *came)
{
    ovr_carriage *c = &sim->arrival.carriage;
    size_t bytes = (sim->now.n - 1) * sizeof *q;
    memcpy(q + 1, sim->past.q[0] + 1, bytes);
    if (!(sim->past.dT > 0)) {
        carry(sim, m, q, c->came, c->crossed);
        c->closed = ovr_arrival_closes(sim);
    }
    memcpy(came + 1, c->came + 1, bytes);
}

/* Computes B at the cells; overwrites the previous contents. */
static void weigh(const ovr_simulation *sim, ptrdiff_t ghosts, double b2,
                  const double *q, double *came)
{
    const double *P = sim->past.P[0];
    bool open = !ovr_arrival_closes(sim);
    for (ptrdiff_t i = -ghosts; i < (ptrdiff_t)sim->now.n; i++) {
        double linear = (1 + b2) * q[i] - b2 * came[i], half = 0.5 * q[i];
        bool dry = i > 0 ? !(P[i] > 0) : !open;
        came[i] = dry && linear < half ? half : linear;
    }
}

static void carriage_history(ovr_simulation *sim, double dT, const double c[2])
{
    ovr_carriage *own = &sim->arrival.carriage;
    double *F = ovr_work_take(sim), *kept = ovr_work_take(sim);
    double *q = sim->inflow.extended + OVR_GHOSTS;
    double *B = own->extended + OVR_GHOSTS;
    double b2 = c[1] * dT, kappa = -c[0] * dT - 1 - b2;
    double T = sim->past.T[0] + dT, across[2], D = ovr_mesh(sim);
    const move m = move_of(sim, ovr_travel_since(sim, 0, T));
    const move old = move_of(sim, ovr_travel_since(sim, 1, T) -
                                      ovr_travel_since(sim, 0, T));
    fill_ghosts(sim, &m, &old, q, B);
    fill_nodes(sim, &m, q, B);
    carry(sim, &m, q, own->coming, own->crossing);
    if (sim->order == 4)
        carry(sim, &m, B, own->coming_twice, across);
    weigh(sim, m.whole + SIDE + 1, b2, q, B);
    carry(sim, &m, B, F, across);
    own->closes = ovr_arrival_closes(sim);
    for (int k = 0; k < 2; k++) {
        double later = kappa * own->crossing[k] - b2 * own->crossed[k];
        bool reverses = k == 0 && own->closes != own->closed;
        own->flow[k] = D * (across[k] + (reverses ? 0 : later)) / dT;
    }
    own->arrives = own->flow[0];
    if (sim->arrival.supply && !own->closes)
        own->arrives = D * arriving(sim, &m) / dT;
    for (size_t i = 0; i < sim->now.n; i++) {
        kept[i] = kappa / dT * own->coming[i];
        F[i] = -F[i] / dT - kept[i];
    }
    ovr_nodes_write(sim, sim->finest, kept, sim->finest->f.kept);
    ovr_history_term(sim, F);
    ovr_work_give(sim, kept);
    ovr_work_give(sim, F);
}

void ovr_carriage_move(ovr_simulation *sim, double T, const double *x,
                       double *to)
{
    const move m = move_of(sim, ovr_travel_since(sim, 0, T));
    double *extended = sim->inflow.extended, across[2];
    memset(extended, 0, OVR_GHOSTS * sizeof *x);
    memcpy(extended + OVR_GHOSTS, x, sim->now.n * sizeof *x);
    carry(sim, &m, extended + OVR_GHOSTS, to, across);
}

void ovr_carriage_taken(ovr_simulation *sim)
{
    ovr_carriage *c = &sim->arrival.carriage;
    double *came = c->came;
    c->came = c->coming;
    c->coming = came;
    memcpy(c->crossed, c->crossing, sizeof c->crossed);
    c->closed = c->closes;
}

void ovr_carriage_visit(ovr_simulation *sim, ovr_pieces *state)
{
    ovr_carriage *c = &sim->arrival.carriage;
    if (!sim->scheme->characteristic)
        return;
    ovr_show(state, "content_came", c->came, sim->now.n * sizeof *c->came);
    OVR_SHOW(state, "content_crossed", c->crossed);
    OVR_SHOW(state, "content_closed", c->closed);
    OVR_SHOW(state, "content_flow", c->flow);
}

/* ------------------------------------------------------------- At the nodes */

void ovr_content_history(ovr_simulation *sim, double dT, const double c[2])
{
    const double *const *q = (const double *const *)sim->past.q;
    const double *P = sim->past.P[0];
    if (sim->scheme->characteristic) {
        carriage_history(sim, dT, c);
        return;
    }
    double *F = ovr_work_take(sim), *kept = ovr_work_take(sim);
    double b2 = c[1] * dT, kappa = -c[0] * dT - 1 - b2;
    if (sim->scheme->order == 1)
        kappa = 0;
    double half = -(0.5 + kappa) / dT, keeps = kappa / dT;
    for (size_t i = 0; i < sim->now.n; i++) {
        double linear = (1 + b2) * q[0][i] - b2 * q[1][i];
        bool limited = !(P[i] > 0) && linear < 0.5 * q[0][i];
        F[i] = limited ? half * q[0][i] : c[0] * q[0][i] + c[1] * q[1][i];
        kept[i] = keeps * q[0][i];
    }
    ovr_level_write(&sim->grids, sim->finest, F, sim->finest->f.F);
    ovr_level_write(&sim->grids, sim->finest, kept, sim->finest->f.kept);
    ovr_work_give(sim, kept);
    ovr_work_give(sim, F);
}
