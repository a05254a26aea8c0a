/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/fourth_content.h"

#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "simulation/mirror.h"

ovr_status ovr_fourth_content_take(ovr_simulation *sim, ovr_fourth_content *of,
                                   ovr_error *err)
{
    return OVR_TAKE_NODES(sim, err, &of->mask, &of->begun, &of->flux,
                          &of->excess, &of->bend, &of->workspace[0],
                          &of->workspace[1]);
}

/* ---------------------------------------------------- extent of the film */

/* Positions where the full film begins and ends, in mesh sizes. They are
 * interpolated between nodes, so that nothing jumps when the phase of a node
 * changes. */
typedef struct film {
    double begin, end;
} film;

/* The cell before the first pressurized node is filled in part, on its
 * downstream side. */
static double beginning(const ovr_solution *s, size_t first)
{
    if (first <= 1)
        return -INFINITY;
    double before = first > 2 ? s->q[first - 2] : 0;
    double margin = s->H[first - 1] - before;
    double part = margin > 0 ? (s->q[first - 1] - before) / margin : 1;
    return (double)first - 0.5 - fmin(fmax(part, 0), 1);
}

/* Same as film_end in fourth.c. */
static double ending(const ovr_solution *s, size_t last)
{
    const double *P = s->P + last;
    double bend = P[-1] - 2 * P[0];
    return (double)last + (bend > P[0] ? P[0] / bend : 1);
}

/* Finds the full film with the maximum pressure. */
static film film_of(const ovr_simulation *sim)
{
    const ovr_solution *s = &sim->now;
    size_t first = sim->grids.kernels->extreme(s->n, -1, s->P), last = first;
    while (first > 0 && s->P[first - 1] > 0)
        first--;
    while (last + 1 < s->n && s->P[last + 1] > 0)
        last++;
    return (film){beginning(s, first), ending(s, last)};
}

/* Increases from 0 within three mesh sizes of an end to 1 over the length
 * `over`. */
static double away(double meshes, double over)
{
    const double sharp = 3;
    return fmin(fmax((meshes - sharp) / over, 0), 1);
}

static void fade(const ovr_simulation *sim, ovr_fourth_content *of)
{
    const double begins = 8, ends = 4;
    const film f = film_of(sim);
    size_t n = sim->now.n;
    for (size_t i = 0; i < n; i++) {
        bool inside = i >= OVR_FOURTH_MARGIN && i + OVR_FOURTH_MARGIN < n;
        of->begun[i] = inside ? away((double)i - f.begin, begins) : 0;
        of->mask[i] = fmin(of->begun[i], away(f.end - (double)i, ends));
    }
}

/* ----------------------------------------------------------- corrections */

/* Computes f and f2 of fourth_content.h, at half nodes. */
static const double *flows(ovr_simulation *sim, ovr_fourth_content *of,
                           const double **second)
{
    const ovr_solution *s = &sim->now;
    ovr_nodes_read(sim, sim->finest, sim->grids.band.b[1], of->flux);
    for (size_t i = 0; i + 1 < s->n; i++) {
        double twice = s->flow ? s->flow[i] : s->eps[i] + s->eps[i + 1];
        of->workspace[0][i] = twice * (s->P[i + 1] - s->P[i]) / (2 * s->D);
    }
    *second = of->workspace[0];
    return of->flux;
}

void ovr_fourth_content_evaluate(ovr_simulation *sim, ovr_fourth_content *of,
                                 const ovr_correction *c, double Cu, double *F,
                                 double *gap)
{
    const double *q = sim->now.q, *m = of->mask, *second;
    size_t n = sim->now.n;
    ovr_fourth_evaluate(&sim->grids, c, 0, false);
    const double *f = flows(sim, of, &second);
    double *phi = of->excess;
    fade(sim, of);
    memset(phi, 0, n * sizeof *phi);
    for (size_t i = OVR_FOURTH_MARGIN; i + OVR_FOURTH_MARGIN < n; i++) {
        double minimum = fmin(m[i], m[i + 1]);
        double wedge = (3 * q[i + 1] - 5 * q[i] + q[i - 1] + q[i - 2]) / 12;
        double pressed = (26 * f[i] - f[i + 1] - f[i - 1]) / 24 - second[i];
        if (minimum > 0)
            phi[i] = minimum * (pressed - Cu * wedge);
    }
    F[0] = 0;
    for (size_t i = 1; i < n; i++)
        F[i] = -(phi[i] - phi[i - 1]) / sim->now.D;
    ovr_nodes_read(sim, sim->finest, c->gap, gap);
}

/* Computes G from the values at the departure points one and two steps ago
 * (times h[0] and h[1] before now); stores the previous value in `before`. */
static void bend(ovr_simulation *sim, ovr_fourth_content *of,
                 const double *const came[2], const double h[2], double *before)
{
    const double *q = sim->now.q;
    for (size_t i = 0; i < sim->now.n; i++) {
        double late = (q[i] - came[0][i]) / h[0];
        double early = (came[0][i] - came[1][i]) / h[1];
        double m = of->mask[i];
        before[i] = of->bend[i];
        of->bend[i] = m > 0 ? m * (late - early) / (h[0] + h[1]) : 0;
    }
}

void ovr_fourth_content_third(ovr_simulation *sim, ovr_fourth_content *of,
                              double T, double dT, double *third)
{
    const ovr_carriage *c = &sim->arrival.carriage;
    const double *const came[2] = {c->coming, c->coming_twice};
    const double *past = sim->past.T;
    double h[3] = {dT, dT, dT};
    for (int k = 1; k < 3; k++)
        h[k] = past[k] < past[k - 1] ? past[k - 1] - past[k] : h[k - 1];
    bend(sim, of, came, h, of->workspace[0]);
    ovr_carriage_move(sim, T, of->workspace[0], of->workspace[1]);
    for (size_t i = 0; i < sim->now.n; i++)
        third[i] = (of->bend[i] - of->workspace[1][i]) / (h[0] + h[1] + h[2]);
}

void ovr_fourth_content_begin(ovr_simulation *sim, ovr_fourth_content *of,
                              double dT, double *third)
{
    const double *const came[2] = {of->workspace[0], of->workspace[1]};
    const double h[2] = {dT, dT};
    double T = sim->past.T[0] + dT, a = ovr_travel_since(sim, 0, T);
    size_t unknown = OVR_FOURTH_MARGIN + 2 * (size_t)ceil(a / ovr_mesh(sim)) +
                     4;
    fade(sim, of);
    ovr_carriage_move(sim, T, sim->now.q, of->workspace[0]);
    ovr_carriage_move(sim, T, of->workspace[0], of->workspace[1]);
    bend(sim, of, came, h, third);
    memset(of->bend, 0, unknown * sizeof *of->bend);
    ovr_carriage_move(sim, T, of->bend, of->workspace[0]);
    for (size_t i = 0; i < sim->now.n; i++)
        third[i] = (of->bend[i] - of->workspace[0][i]) / (3 * dT);
}

/* ------------------------------------------------------------ steady start */

/* Contents that have moved from outside of the domain are unknown: psi is
 * omitted there. */
void ovr_fourth_content_rest(ovr_simulation *sim, ovr_fourth_content *of,
                             double dT, const double *start,
                             const double *constant, double *psi)
{
    double T = sim->past.T[0] + dT, a = ovr_travel_since(sim, 0, T);
    double *once = of->workspace[0], *twice = of->workspace[1];
    double *bend = ovr_work_take(sim), *moved = ovr_work_take(sim), sum = 0;
    size_t n = sim->now.n;
    size_t unknown = OVR_FOURTH_MARGIN + 3 * (size_t)ceil(a / ovr_mesh(sim)) +
                     4;
    ovr_carriage_move(sim, T, start, once);
    ovr_carriage_move(sim, T, once, twice);
    for (size_t i = 0; i < n; i++)
        bend[i] = of->mask[i] * (start[i] - 2 * once[i] + twice[i]) /
                  (2 * dT * dT);
    ovr_carriage_move(sim, T, bend, moved);
    psi[n - 1] = psi[n - 2] = 0;
    for (size_t i = n - 2; i > 0; i--) {
        double step = (1.5 * start[i] - 2 * once[i] + 0.5 * twice[i]) / dT;
        double third = 2. / 3 * dT * (bend[i] - moved[i]);
        sum += constant[i] - step - third;
        psi[i - 1] = i > unknown ? -sim->now.D * sum : 0;
    }
    ovr_work_give(sim, moved);
    ovr_work_give(sim, bend);
}

void ovr_fourth_content_rows(const ovr_simulation *sim,
                             const ovr_fourth_content *of, const double *psi,
                             double *R)
{
    size_t n = sim->now.n;
    double before = 0;
    R[0] = R[n - 1] = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        double flow = fmin(of->begun[i], of->begun[i + 1]) * psi[i];
        R[i] = (flow - before) / sim->now.D;
        before = flow;
    }
}
