/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Gap of smooth surfaces with time-varying radius, c = R0/R(T):
 *     gap = c X^2/2                                    imposed from outside
 *     gap = sum_k c_k X^2/2 - (dc_k/dT) X^3/(6 v_k)    convected with surface k
 * v_k = u_k/um0.  Near the contact, a surface whose curvature varies along the
 * material has the shape z = c X^2/2 + (dc/ds) X^3/6, and dc/dT = -v dc/ds. The
 * squeeze flow due to the motion of the cubic term cancels that due to c(T);
 * without the cubic term there would be a squeeze flow of first order in dc/dT.
 *
 * If only R is known, all of the curvature moves with the entrainment speed, v
 * = Cu. A jump has no slope and is imposed from outside.
 */
#include "contact/curvature.h"
#include "contact/contact.h"

#include <math.h>

static double curvature(const ovr_history *radius, double T)
{
    return 1 / ovr_history_value(radius, T);
}

/* dc/dT */
static double rate(const ovr_history *radius, double T)
{
    double c = curvature(radius, T);
    return -c * c * ovr_history_slope(radius, T);
}

/* Cubic coefficient of both surfaces, from the rates of change of their
 * curvatures; c_2 = c - c_1. */
static double cubic(const ovr_curving *g, double T)
{
    double all = rate(g->radius, T), one;
    if (!g->radius_1)
        return all == 0 ? 0 : all / (6 * ovr_history_value(g->speed, T));
    one = rate(g->radius_1, T);
    double rates[2] = {one, all - one}, sum = 0;
    for (int k = 0; k < 2; k++)
        if (rates[k] != 0)
            sum += rates[k] / (6 * ovr_surface_speed(g->speed, g->sliding,
                                                     g->ratio[k], k + 1, T));
    return sum;
}

ovr_smooth ovr_smooth_of(const ovr_curving *curving, double T)
{
    return (ovr_smooth){.half = 0.5 * curvature(curving->radius, T),
                        .cubic = curving->convected ? cubic(curving, T) : 0};
}

bool ovr_smooth_opens(const ovr_smooth *smooth, double X)
{
    return smooth->half > 0 && isfinite(smooth->half) &&
           3 * fabs(smooth->cubic * X) < 2 * smooth->half;
}

ovr_instant ovr_instant_of(const ovr_contact *contact, double Cw, double Cu,
                           double c)
{
    return (ovr_instant){.M = contact->M * Cw / sqrt(Cu / c),
                         .L = contact->L * sqrt(sqrt(Cu * c)),
                         .s = sqrt(Cw / c)};
}
