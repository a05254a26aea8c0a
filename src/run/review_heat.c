/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the model of heat ends: surfaces too slow for heat that flows inward
 * only, or that slide too fast for the steps, before a run; films hotter than
 * what laws are measured for and domains that cut off what is warm, after it.
 */
#include <math.h>
#include <stdio.h>

#include "case/resolve.h"
#include "run/internal.h"

/* u_k/um0 at T. */
static double speed_of(const ovr_setup *s, int k, double T)
{
    double Cu = ovr_history_value(s->speed, T);
    double V = s->sliding ? ovr_history_value(s->sliding, T)
                          : Cu * (s->contact->u1_ratio - s->contact->u2_ratio);
    return Cu + (k ? -V : V) / 2;
}

/* The least Peclet number of a surface, and when. */
static double least_peclet(const ovr_setup *s, int k, double *T)
{
    const int times = 500;
    double nominal = fabs(k ? s->contact->u2_ratio : s->contact->u1_ratio);
    double of_um = nominal > 0 ? s->heat->peclet[k] / nominal : 0, least;
    double end = s->transient && isfinite(s->march->end) ? s->march->end : 0;
    *T = 0;
    least = of_um * fabs(speed_of(s, k, 0));
    for (int i = 1; i <= times && end > 0; i++) {
        double here = of_um * fabs(speed_of(s, k, end * i / times));
        if (here < least) {
            least = here;
            *T = end * i / times;
        }
    }
    return least;
}

/* Viscosities follow temperatures a step behind: where surfaces slide very
 * fast that makes what they carry along hotter still. */
static void review_slip(const ovr_setup *s, ovr_listener *listener, void *data)
{
    const int times = 500;
    const double much = 3;
    double end = isfinite(s->march->end) ? s->march->end : 0, most = 0, T = 0;
    char text[OVR_MESSAGE_SIZE];
    for (int i = 0; i <= times; i++) {
        double at = end * i / times;
        double slip = fabs(speed_of(s, 0, at) - speed_of(s, 1, at));
        if (slip > most) {
            most = slip;
            T = at;
        }
    }
    if (!(most > much))
        return;
    snprintf(text, sizeof text,
             "heat: the surfaces slide by %.3g um at T = %.4g: beyond %g um "
             "temperatures may swing from step to step; compare with steps of "
             "half the length",
             most, T, much);
    listener(data, OVR_SAY_WARNING, text);
}

/* Below it heat flows along the surface too. */
void ovr_review_peclet(const ovr_setup *setup, ovr_listener *listener,
                       void *data)
{
    char text[OVR_MESSAGE_SIZE];
    for (int k = 0; setup->heat && listener && k < 2; k++) {
        double T, Pe = least_peclet(setup, k, &T);
        double least = setup->heat->least_peclet;
        if (!(Pe < least))
            continue;
        if (setup->transient)
            snprintf(text, sizeof text,
                     "heat: surface %d has the Peclet number %.3g at T = %.4g: "
                     "below %g heat would flow along the surface too, which is "
                     "left out; a steady start takes it as %g",
                     k + 1, Pe, T, least, least);
        else
            snprintf(text, sizeof text,
                     "heat: surface %d has the Peclet number %.3g; a steady "
                     "solution takes it as %g, below which heat would flow "
                     "along the surface too",
                     k + 1, Pe, least);
        listener(data, OVR_SAY_WARNING, text);
    }
    if (setup->heat && setup->transient && listener)
        review_slip(setup, listener, data);
}

/* Laws of viscosity and temperature are measured over some hundred kelvins. */
static void warn_of_rise(ovr_run *run)
{
    const double most = 100;
    double rise = ovr_simulation_statistics(run->sim)->T_rise;
    char text[OVR_MESSAGE_SIZE];
    if (!(rise > most))
        return;
    snprintf(text, sizeof text,
             "heat: the film is up to %.3g K hotter than the supply, further "
             "than laws of viscosity are measured",
             rise);
    ovr_run_message(run, OVR_SAY_WARNING, text);
}

static void warn_of_lag(ovr_run *run)
{
    const ovr_statistics *s = ovr_simulation_statistics(run->sim);
    char text[OVR_MESSAGE_SIZE];
    if (!s->lagging)
        return;
    snprintf(text, sizeof text,
             "heat: in %ld of %ld steps temperatures are not those of the film "
             "(they lag behind it, or energy does not close to a tenth of what "
             "is made): what follows from these steps may be far off; take "
             "shorter ones, [time] step, or a finer level",
             s->lagging, s->steps);
    ovr_run_message(run, OVR_SAY_WARNING, text);
}

/* The heat flux into a surface near the end of the domain by which it comes in,
 * over the largest. */
static double flux_at_entry(ovr_run *run, int k, bool at_outlet)
{
    static const char *const names[2] = {"heat_flux_1", "heat_flux_2"};
    size_t n = ovr_simulation_state(run->sim)->n, near = 1 + n / 100;
    double *room = ovr_arena_take(&run->arena, n, sizeof *room, NULL), most = 0;
    const double *q;
    if (!room)
        return 0;
    q = ovr_observable_field(names[k])->field(run->sim, room);
    for (size_t i = 0; i < n; i++)
        most = fmax(most, fabs(q[i]));
    return most > 0 ? fabs(q[at_outlet ? n - 1 - near : near]) / most : 0;
}

static void warn_of_domain(ovr_run *run)
{
    const double most = 0.05;
    double T = ovr_simulation_state(run->sim)->T;
    char text[OVR_MESSAGE_SIZE];
    for (int k = 0; k < 2; k++) {
        bool at_outlet = speed_of(run->setup, k, T) < 0;
        const char *end = at_outlet ? "outlet" : "inlet";
        double share = flux_at_entry(run, k, at_outlet);
        if (!(share > most))
            continue;
        snprintf(
            text, sizeof text,
            "heat: the domain is too short for it to leave: surface %d "
            "comes in at the %s as if from afar, where it takes up %.0f %% "
            "of the largest heat flux; move the %s out",
            k + 1, end, 100 * share, end);
        ovr_run_message(run, OVR_SAY_WARNING, text);
    }
}

void ovr_run_review_heat(ovr_run *run)
{
    if (!run->setup->heat || !ovr_simulation_state(run->sim)->n)
        return;
    warn_of_lag(run);
    warn_of_rise(run);
    warn_of_domain(run);
}
