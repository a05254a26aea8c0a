/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The gap of smooth surfaces whose radius varies, c = R0/R(T):
 *     gap = c X^2/2                                    imposed from outside
 *     gap = sum_k c_k X^2/2 - (dc_k/dT) X^3/(6 v_k)    convected with surface k
 * v_k = u_k/um0.  A surface whose curvature varies along its material is about
 * the contact z = c X^2/2 + (dc/ds) X^3/6, and the contact sees dc/dT =
 * -v dc/ds: what the cubic's motion squeezes is what c(T) pumps.  Without the
 * cubic the film is pumped, to first order in dc/dT.
 *
 * Where only R is known all of the curvature moves with the mean speed, v = Cu.
 * A change without duration has no slope: it is imposed.
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

/* The cubic of both surfaces together, from the rates of their curvature; c_2 =
 * c - c_1. */
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
