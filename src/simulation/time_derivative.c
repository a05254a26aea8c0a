/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Time in the discrete Reynolds equation (multigrid/reynolds.h): the operator
 * and the history term of a step.
 *
 * Backward Euler:  cT = 1/dT,   F = -q^k/dT BDF2, s = dT/dT_old:
 *     cT dT = (1 + 2s)/(1 + s),  F dT = -(1 + s) q^k + s^2/(1 + s) q^{k-1}
 * At the first step the past is the steady solution, whatever its spacing.
 *
 * Along the characteristic dX/dT = Cu (after Venner & Lubrecht) wedge and
 * squeeze terms together are the derivative of q along the path of a particle:
 * there is no wedge on the left, and q^k, q^{k-1} at the departure points X -
 * a1, X - a2 of the characteristic on the right.  With dT = D and Cu = 1 the
 * departure points are nodes.
 */
#include "simulation/scheme.h"

#include <math.h>

#include "contact/contact.h"
#include "simulation/fourth.h"
#include "simulation/internal.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"

/* -------------------------------------------------------------- Differences */

static void backward_euler(double dT, double dT_old, double *cT, double c[2])
{
    (void)dT_old;
    *cT = 1 / dT;
    c[0] = -1 / dT;
    c[1] = 0;
}

static void bdf2(double dT, double dT_old, double *cT, double c[2])
{
    double s = dT_old > 0 ? dT / dT_old : 1;
    *cT = (1 + 2 * s) / (1 + s) / dT;
    c[0] = -(1 + s) / dT;
    c[1] = s * s / (1 + s) / dT;
}

void ovr_history_term(ovr_simulation *sim, double *F)
{
    ovr_fourth_sides(sim, F);
    ovr_nodes_write(sim, sim->finest, F, sim->finest->f.F);
}

/* time_derivative.c */
static void history_at_nodes(ovr_simulation *sim, const double c[2], double T)
{
    (void)T;
    double *F = ovr_work_take(sim);
    sim->grids.kernels->combine(sim->now.n, c[0], sim->past.q[0], c[1],
                                sim->past.q[1], F);
    ovr_history_term(sim, F);
    ovr_work_give(sim, F);
}

static void history_at_departures(ovr_simulation *sim, const double c[2],
                                  double T)
{
    const double a[2] = {ovr_travel_since(sim, 0, T),
                         ovr_travel_since(sim, 1, T)};
    double *F = ovr_work_take(sim);
    ovr_inflow_history(sim, c, a, F);
    ovr_history_term(sim, F);
    ovr_work_give(sim, F);
}

void ovr_time_derivative(ovr_simulation *sim, double dT)
{
    const ovr_discretization *scheme = sim->scheme;
    OVR_LAST_PHYSICS(sim, p, in_step, history);
    double T = sim->past.T[0] + dT, c[2];
    ovr_operator op = {
        .speed = fabs(ovr_history_value(sim->histories.speed, T)),
        .transient = true,
        .characteristic = scheme->characteristic};
    scheme->difference(dT, sim->past.dT, &op.cT, c);
    if (!scheme->characteristic)
        ovr_reynolds_wedge(&op, scheme->order == 2, op.speed);
    OVR_EACH_PHYSICS(sim, each, in_step, operate)
        each->is->in_step->operate(sim, each->own, dT, &op);
    if (p->is)
        p->is->in_step->history(sim, p->own, dT, c);
    else
        scheme->history(sim, c, T);
    ovr_hierarchy_operator(&sim->grids, &op);
}

/* ------------------------------------------------------------------ Records */

static double linear_extrapolation(const ovr_past *past, double h, double e[3])
{
    double h1 = past->T[0] - past->T[1];
    e[0] = 1 + h / h1;
    e[1] = -h / h1;
    e[2] = 0;
    return h / (h + h1);
}

static double quadratic_extrapolation(const ovr_past *past, double h,
                                      double e[3])
{
    double h1 = past->T[0] - past->T[1], h2 = past->T[1] - past->T[2];
    e[0] = (h + h1) * (h + h1 + h2) / (h1 * (h1 + h2));
    e[1] = -h * (h + h1 + h2) / (h1 * h2);
    e[2] = h * (h + h1) / ((h1 + h2) * h2);
    return h * (h + h1) / ((2 * h + h1) * (h + h1 + h2));
}

static const ovr_discretization records[] = {
    [OVR_UPSTREAM1] = {"upstream1",
                       1,
                       {1, 0},
                       false,
                       backward_euler,
                       history_at_nodes,
                       linear_extrapolation},
    [OVR_UPSTREAM2] = {"upstream2",
                       2,
                       {1.5, -0.5},
                       false,
                       bdf2,
                       history_at_nodes,
                       quadratic_extrapolation},
    [OVR_CHARACTERISTIC] = {"characteristic",
                            2,
                            {1.5, -0.5},
                            true,
                            bdf2,
                            history_at_departures,
                            quadratic_extrapolation},
};

const ovr_discretization *ovr_scheme_record(ovr_scheme scheme)
{
    size_t k = (size_t)scheme;
    return k < sizeof records / sizeof *records ? &records[k] : NULL;
}

const char *ovr_smoother_name(ovr_smoother smoother)
{
    switch (smoother) {
    case OVR_LINE: return "line";
    case OVR_HYBRID: return "hybrid";
    case OVR_GAUSS_SEIDEL: return "gauss-seidel";
    case OVR_DIPOLE: return "dipole";
    }
    return "";
}

const char *ovr_scheme_name(ovr_scheme scheme)
{
    const ovr_discretization *record = ovr_scheme_record(scheme);
    return record ? record->name : NULL;
}

/* ---------------------------------------------------------- Error of a step */

/*
 * Local error of a step, from the difference between the solution q and the
 * polynomial through its past, q_p (Milne's device).  With steps h, h1, h2
 * (newest first):
 *
 *   backward Euler  error h^2/2 q'',  q - q_p = h (h + h1)/2 q'' (linear)
 *                   error = (q - q_p) h/(h + h1)
 *   BDF2            error h^2 (h + h1)^2/(6 (2h + h1)) q''',
 *                   q - q_p = h (h + h1)(h + h1 + h2)/6 q''' (quadratic)
 *                   error = (q - q_p) h (h + h1)/((2h + h1)(h + h1 + h2))
 *
 * Convected films accumulate the errors of all steps: a film that passes the
 * contact in a time of about 1 has those of 1/h steps. The error of a step of h
 * is therefore counted as
 *     E = 0.4/(h H_cen) int |error| dX
 * over pressurized nodes with a film thickness below 3 H_cen; errors of the
 * thicker film upstream are smoothed by the contact pressure. The integral is
 * used because errors of opposite sign at a dent cancel on their way. The
 * factor 0.4 is measured: on random dents of 12 nodes a width or more, rolling
 * and sliding, the error of H_cen over the run, rms in time, is 0.1 to 3 E
 * (verify/adaptive_test).
 *
 * Upstream schemes difference in time at fixed X, and their error depends on
 * changes there, including those by moving features. The error of the
 * characteristic scheme depends on changes along the path of a particle: q_p is
 * computed from the past at the departure points. Exchanging the two
 * definitions of q_p increases the number of cycles for the same error: on 12
 * such dents the characteristic scheme 2.5 times as many (4.4 E at most instead
 * of 3.2), upstream2, along um or with sliding features, 1.7 times as many.
 * With 0.08 in place of 0.4 the characteristic scheme's errors are 3.9 E at
 * most.
 */

/* int |q - q_p| dX */
static double deviation(ovr_simulation *sim, double h, const double e[3])
{
    const double thickest = 3, once[3] = {1, 0, 0};
    double maximum = thickest * ovr_value_at(&sim->now, sim->now.H, 0);
    double *moved = ovr_work_take(sim);
    bool moves = sim->scheme->characteristic &&
                 ovr_inflow_prediction(sim, sim->past.T[0] + h, e, moved);
    double *const predicted[3] = {moved, moved, moved};
    double off = sim->grids.kernels->deviation(
        sim->now.n, moves ? once : e, maximum, sim->now.weights, sim->now.P,
        sim->now.q, moves ? predicted : sim->past.q);
    ovr_work_give(sim, moved);
    return off;
}

double ovr_step_error(ovr_simulation *sim, double h)
{
    const ovr_past *past = &sim->past;
    double share = sim->scheme->characteristic ? 0.08 : 0.4, e[3];
    if (past->steps < sim->scheme->order || isinf(sim->limits.largest_error))
        return 0;
    double factor = sim->scheme->extrapolation(past, h, e);
    double H = ovr_value_at(&sim->now, sim->now.H, 0);
    return share * factor * deviation(sim, h, e) / (fabs(H) * h);
}
