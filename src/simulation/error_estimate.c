/* SPDX-License-Identifier: GPL-3.0-or-later */
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
 * What moves carries the errors of its steps along and gathers more: the film
 * that has passed the contact, in a time of about 1, has those of 1/h steps.
 * The error of a step of h is therefore counted as
 *     E = 0.4/(h H_cen) int |error| dX
 * over the nodes that are wet and have a film below 3 H_cen, as thicker ones
 * before the contact are smoothed by its pressure.  The integral, as errors
 * beside a dent of either sign cancel on their way; 0.4 measured: on random
 * dents of 12 nodes a width or more, rolling and sliding, the error of H_cen
 * over the run, rms in time, is 0.1 to 3 E (verify/adaptive_test).
 *
 * Upstream schemes difference in time at fixed X and err by the change there,
 * of what moves too.  The characteristic scheme errs by the change that a
 * particle sees: q_p is that of the past at the departure points of the
 * characteristics. Each with the other's q_p takes more cycles for its error:
 * on 12 such dents the characteristic scheme 2.5 times as many (4.4 E at most
 * instead of 3.2), upstream2, along um or what slides, 1.7 times as many.  With
 * 0.08 in place of 0.4 the characteristic scheme's errors are 3.9 E at most.
 */
#include <math.h>

#include "simulation/internal.h"

double ovr_linear_extrapolation(const ovr_past *past, double h, double e[3])
{
    double h1 = past->T[0] - past->T[1];
    e[0] = 1 + h / h1;
    e[1] = -h / h1;
    e[2] = 0;
    return h / (h + h1);
}

double ovr_quadratic_extrapolation(const ovr_past *past, double h, double e[3])
{
    double h1 = past->T[0] - past->T[1], h2 = past->T[1] - past->T[2];
    e[0] = (h + h1) * (h + h1 + h2) / (h1 * (h1 + h2));
    e[1] = -h * (h + h1 + h2) / (h1 * h2);
    e[2] = h * (h + h1) / ((h1 + h2) * h2);
    return h * (h + h1) / ((2 * h + h1) * (h + h1 + h2));
}

/* int |q - q_p| dX */
static double deviation(ovr_simulation *sim, double h, const double e[3])
{
    const double thickest = 3, once[3] = {1, 0, 0};
    double maximum = thickest * ovr_value_at(&sim->now, sim->now.H, 0);
    double *predicted = NULL;
    if (sim->scheme->characteristic)
        predicted = ovr_inflow_prediction(sim, sim->past.T[0] + h, e);
    double *const moved[3] = {predicted, predicted, predicted};
    return sim->grids.kernels->deviation(
        sim->now.n, predicted ? once : e, maximum, sim->now.weights, sim->now.P,
        sim->now.q, predicted ? moved : sim->past.q);
}

double ovr_step_error(ovr_simulation *sim, double h)
{
    const ovr_past *past = &sim->past;
    double share = sim->scheme->characteristic ? 0.08 : 0.4, e[3];
    if (past->steps < sim->scheme->order || isinf(sim->largest_error))
        return 0;
    double factor = sim->scheme->extrapolation(past, h, e);
    double H = ovr_value_at(&sim->now, sim->now.H, 0);
    return share * factor * deviation(sim, h, e) / (fabs(H) * h);
}
