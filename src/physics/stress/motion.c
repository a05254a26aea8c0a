/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The way that the material of a surface has come, and its speed:
 *
 *     U_k = u_k/um int Cu dT;  with [sliding] V:  U_k = int (Cu +- V/2) dT
 *
 * exact for every history, so that material is followed through changes of
 * speed, halts and reversals as through steady motion.
 */
#include <math.h>

#include "contact/contact.h"
#include "contact/reversal.h"
#include "physics/stress/stress.h"
#include "surface/surfaces.h"

/* A motion is looked at in so many moments. */
enum { LOOKS = 2000 };

double ovr_stress_way(const ovr_setup *setup, const ovr_stress_plan *plan,
                      double T)
{
    return ovr_surface_way(setup->speed, setup->sliding, plan->ratio,
                           plan->surface, T);
}

static double speed_of(const ovr_setup *setup, const ovr_stress_plan *plan,
                       double T)
{
    double Cu = ovr_history_value(setup->speed, T);
    if (!setup->sliding)
        return plan->ratio * Cu;
    return Cu + (plan->surface == 1 ? 0.5 : -0.5) *
                    ovr_history_value(setup->sliding, T);
}

/* Where it stands still, it goes on as it would by slide_to_roll. */
static int direction_at(const ovr_setup *setup, const ovr_stress_plan *plan,
                        double T)
{
    double u = speed_of(setup, plan, T);
    return u < 0 || (u == 0 && plan->ratio < 0) ? -1 : 1;
}

bool ovr_stress_wanders(const ovr_setup *setup)
{
    return setup->sliding || ovr_history_reverses(setup->speed);
}

int ovr_stress_direction(const ovr_setup *setup, const ovr_stress_plan *plan)
{
    bool forward = false, backward = false;
    if (!ovr_stress_wanders(setup))
        return plan->ratio < 0 ? -1 : 1;
    for (int k = 0; k <= LOOKS; k++) {
        double u = speed_of(setup, plan, setup->march->end * k / LOOKS);
        forward = forward || u > 0;
        backward = backward || u < 0;
    }
    return forward == backward ? 0 : forward ? 1 : -1;
}

double ovr_stress_fastest(const ovr_setup *setup)
{
    const ovr_contact *c = setup->contact;
    double fastest = fmax(1, fmax(fabs(c->u1_ratio), fabs(c->u2_ratio)));
    for (int k = 0; setup->sliding && k <= LOOKS; k++) {
        double T = setup->march->end * k / LOOKS;
        fastest = fmax(fastest,
                       fabs(ovr_history_value(setup->speed, T)) +
                           fabs(ovr_history_value(setup->sliding, T)) / 2);
    }
    return fastest;
}

/* The way of the fastest of the film and both surfaces. */
static double widest_way(const ovr_setup *setup, double before, double T)
{
    double film = ovr_history_integral(setup->speed, T) -
                  ovr_history_integral(setup->speed, before);
    double half;
    if (!setup->sliding)
        return ovr_stress_fastest(setup) * fabs(film);
    half = (ovr_history_integral(setup->sliding, T) -
            ovr_history_integral(setup->sliding, before)) /
           2;
    return fabs(film) + fabs(half);
}

/* A feature that does not come to X = 0 is on its way at the end. */
static double struck_in_sliding(const ovr_setup *setup,
                                const ovr_stress_plan *plan, size_t feature)
{
    const ovr_options *o = setup->options;
    double end = setup->march->end;
    double T = ovr_surfaces_times(setup->surfaces, feature, o->inlet, o->outlet,
                                  end)
                   .centre;
    return -ovr_stress_way(setup, plan, fmin(T, end));
}

double ovr_stress_struck(const ovr_setup *setup, const ovr_stress_plan *plan,
                         size_t feature)
{
    double speed = ovr_surfaces_info(setup->surfaces, feature).speed;
    double centre = ovr_surfaces_centre(setup->surfaces, feature, 0);
    double end = ovr_history_integral(setup->speed, setup->march->end);
    double way = speed != 0 ? fmax(-centre / speed, 0) : end / 2;
    if (ovr_stress_wanders(setup))
        return struck_in_sliding(setup, plan, feature);
    return -plan->ratio * way;
}

/* A feature where pressure is: from 1 b before the contact to its exit. */
static bool disturbed(const ovr_setup *setup, double T)
{
    const double inlet = -2, outlet = 1.25;
    size_t n = setup->surfaces ? ovr_surfaces_count(setup->surfaces) : 0;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
        double X = ovr_surfaces_centre(setup->surfaces, k, T);
        if (info.grows && T <= 0)
            continue;
        if (!isfinite(info.behind) || !isfinite(info.ahead) ||
            (X - info.behind < outlet && X + info.ahead > inlet))
            return true;
    }
    return false;
}

ovr_moment ovr_stress_moment(const ovr_setup *setup,
                             const ovr_stress_plan *plan, double T,
                             double before)
{
    return (ovr_moment){.T = T,
                        .U = ovr_stress_way(setup, plan, T),
                        .dU = widest_way(setup, before, T),
                        .direction = direction_at(setup, plan, T),
                        .disturbed = disturbed(setup, T)};
}
