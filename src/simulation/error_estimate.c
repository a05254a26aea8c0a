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
 * The characteristic scheme is judged as BDF2: pessimistic, as its error is
 * that of the change seen by a particle.
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

double ovr_step_error(const ovr_simulation *sim, double h)
{
    const ovr_past *past = &sim->past;
    double e[3], rms;
    if (past->steps < sim->scheme->order)
        return 0;
    double factor = sim->scheme->extrapolation(past, h, e);
    rms = sim->grids.kernels->deviation(sim->now.n, e, sim->now.P, sim->now.q,
                                        past->q);
    double H = ovr_level_centre(sim->finest, sim->finest->f.H);
    return factor * rms / fabs(H);
}
