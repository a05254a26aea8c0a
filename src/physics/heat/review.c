/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Warnings about the heat model. Before a run: surfaces that do not reach a
 * steady temperature. After a run: temperatures that the grid does not resolve,
 * or outside the measured range of viscosity laws. Domains with heated ends. */
#include <math.h>
#include <stdio.h>

#include "case/resolve.h"
#include "contact/contact.h"
#include "physics/companion.h"
#include "physics/heat/heat.h"
#include "physics/heat/solids.h"
#include "simulation/simulation.h"

/* u_k/um0 at T. */
static double speed_of(const ovr_setup *s, int k, double T)
{
    return ovr_speed_at(s->contact, s->speed, s->sliding, k, T);
}

/* A surface with low speed at the start, or during the run. */
typedef struct slowness {
    double Pe, u, T; /* minimum at the start, or over all times; time of the
                      * minimum */
    double lasts;    /* duration below the smallest Peclet number of the model
                      */
} slowness;

static slowness find_slowness(const ovr_setup *s, int k)
{
    const int times = 500;
    const ovr_heat *heat = ovr_setup_heat(s);
    const double minimum = heat->min_peclet, kappa = heat->diffusion[k];
    double end = s->transient && isfinite(s->march->end) ? s->march->end : 0;
    slowness slow = {.Pe = INFINITY};
    for (int i = 0; i <= (end > 0 ? times : 0); i++) {
        double T = end * i / times, u = speed_of(s, k, T);
        double Pe = fabs(u) / kappa;
        if (Pe < minimum)
            slow.lasts += end / times;
        if (Pe < slow.Pe)
            slow = (slowness){Pe, u, T, slow.lasts};
    }
    return slow;
}

/* Warns if a surface has no steady temperature, or none within its memory;
 * surfaces that reverse are slow only for a short time. */
static void review_speed(const ovr_setup *s, int k, ovr_listener *listener,
                         void *data)
{
    const double passing = 1, second = s->contact->b / s->contact->um;
    const ovr_heat *heat = ovr_setup_heat(s);
    const double kappa = heat->diffusion[k] * s->contact->um * s->contact->b;
    slowness slow = find_slowness(s, k);
    double reach = ovr_solid_reach(heat, k, slow.u);
    char when[40] = "";
    if (!(slow.Pe < heat->min_peclet) || (slow.T > 0 && slow.lasts < passing))
        return;
    if (slow.T > 0)
        snprintf(when, sizeof when, " at T = %.4g", slow.T);
    if (slow.u == 0)
        ovr_warn(listener, data,
                 "heat: surface %d does not move%s and has no steady "
                 "temperature: it rises with the logarithm of time. The "
                 "steady solution is the state after %.3g s; a contact of "
                 "width w reaches its final temperature after about "
                 "w^2/kappa, %.3g s for 10 mm",
                 k + 1, when, reach * second, 1e-4 / kappa);
    else
        ovr_warn(listener, data,
                 "heat: the temperature of surface %d is too low, because its "
                 "Peclet number %.3g%s is below 0.05: the temperature needs "
                 "%.3g s to become steady, and the model covers %.3g s",
                 k + 1, slow.Pe, when,
                 20 * kappa / pow(slow.u * s->contact->um, 2), reach * second);
}

static void review_before(const ovr_setup *setup, ovr_listener *listener,
                          void *data)
{
    for (int k = 0; k < 2; k++)
        review_speed(setup, k, listener, data);
}

/* Warns if the temperature rise exceeds some hundred kelvins, the measured
 * range of viscosity-temperature laws. */
static void warn_of_rise(const ovr_accompanied_run *run)
{
    const double maximum = 100;
    double rise = ovr_simulation_statistics(run->sim)->extreme.T_max_rise;
    if (!(rise > maximum))
        return;
    ovr_warn(run->say, run->listener,
             "heat: the film is up to %.3g K hotter than the supply, beyond "
             "the measured range of viscosity laws",
             rise);
}

static void warn_of_lag(const ovr_accompanied_run *run)
{
    const ovr_statistics *s = ovr_simulation_statistics(run->sim);
    if (!s->lagging)
        return;
    ovr_warn(run->say, run->listener,
             "heat: results after %ld of %ld steps may be wrong, because the "
             "temperatures of these steps are inconsistent with the film or "
             "violate the energy balance by more than 10 %%; set a shorter "
             "time.step or a finer domain.level",
             s->lagging, s->steps);
}

static const double negligible = 1; /* temperature rise, K */

bool ovr_heat_is_balanced(double energy_defect, double rise)
{
    const double maximum = 0.05;
    return !(fabs(energy_defect) > maximum && rise > negligible);
}

/* False if finer grids would give a maximum film temperature that is higher by
 * more than 10 %. */
static bool is_peak_resolved(double finer, double rise)
{
    return !(finer > 1.1 * rise && finer > negligible);
}

bool ovr_heat_is_resolved(const ovr_observation *o)
{
    return !o->converged ||
           (ovr_heat_is_balanced(o->energy_defect, o->T_max_rise) &&
            is_peak_resolved(o->T_max_finer, o->T_max_rise));
}

bool ovr_heat_maximum_is_resolved(const ovr_statistics *s)
{
    double rise = s->extreme.T_max_rise;
    return ovr_heat_is_balanced(s->defect_at_T_max, rise) &&
           is_peak_resolved(s->T_max_finer, rise);
}

static void warn_of_imbalance(const ovr_accompanied_run *run, double T,
                              double energy_defect)
{
    ovr_warn(run->say, run->listener,
             "heat: temperatures are not resolved, because the energy balance "
             "of the film at T = %.4g has an error of %.0f %%; use a finer "
             "grid (domain.level = %d)",
             T, 100 * fabs(energy_defect), run->setup->options->level + 1);
}

/* Warns of temperatures that are not resolved, at the end of the run or at the
 * maximum of the run. */
static void warn_of_resolution(const ovr_accompanied_run *run)
{
    const ovr_observation *o = ovr_simulation_observation(run->sim);
    const ovr_statistics *s = ovr_simulation_statistics(run->sim);
    double rise = s->extreme.T_max_rise;
    bool last = !ovr_heat_is_resolved(o);
    if (!last && ovr_heat_maximum_is_resolved(s))
        return;
    if (last && !ovr_heat_is_balanced(o->energy_defect, o->T_max_rise))
        warn_of_imbalance(run, o->T, o->energy_defect);
    else if (!ovr_heat_is_balanced(s->defect_at_T_max, rise))
        warn_of_imbalance(run, s->when.T_max_rise, s->defect_at_T_max);
    else
        ovr_warn(run->say, run->listener,
                 "heat: the maximum film temperature is not resolved, because "
                 "a peak of temperature at T = %.4g is only a few nodes wide "
                 "and higher on finer grids; use a finer grid (domain.level)",
                 last ? o->T : s->T_T_max_finer);
}

/* Warns by x of heated.h if there are too few points across the film; prints
 * the friction error in per cent. */
static void warn_of_points(const ovr_accompanied_run *run)
{
    const ovr_statistics *s = ovr_simulation_statistics(run->sim);
    const double valid = 10; /* per cent */
    double off = 400 * s->last_cross_film * s->last_cross_film;
    if (!(s->last_cross_film > 0) || ovr_simulation_heat_points(run->sim) != 5)
        return;
    if (off > valid)
        ovr_warn(run->say, run->listener,
                 "heat: friction and surface temperatures may be wrong by more "
                 "than %.0f %%, because heat.points is 5; set heat.points = 7",
                 valid);
    else
        ovr_warn(run->say, run->listener,
                 "heat: friction is about %.1f %% too low and surface "
                 "temperatures are wrong by up to twice that, because "
                 "heat.points is 5; set heat.points = 7",
                 off);
}

/* Heat flux into a surface near the end of the domain where it enters, relative
 * to the maximum. */
static double flux_at_entry(const ovr_accompanied_run *run, int k,
                            bool at_outlet)
{
    static const char *const names[2] = {"heat_flux_1", "heat_flux_2"};
    size_t n = ovr_simulation_state(run->sim)->n, near = 1 + n / 100;
    double *workspace = ovr_arena_take(run->arena, n, sizeof *workspace, NULL),
           maximum = 0;
    const double *q;
    if (!workspace)
        return 0;
    q = ovr_observable_field(names[k])->field(run->sim, workspace);
    for (size_t i = 0; i < n; i++)
        maximum = fmax(maximum, fabs(q[i]));
    return maximum > 0 ? fabs(q[at_outlet ? n - 1 - near : near]) / maximum : 0;
}

static void warn_of_domain(const ovr_accompanied_run *run)
{
    const double maximum = 0.05;
    double T = ovr_simulation_state(run->sim)->T;
    for (int k = 0; k < 2; k++) {
        bool at_outlet = speed_of(run->setup, k, T) < 0;
        const char *end = at_outlet ? "outlet" : "inlet";
        double share = flux_at_entry(run, k, at_outlet);
        if (!(share > maximum))
            continue;
        ovr_warn(
            run->say, run->listener,
            "heat: temperatures are wrong because the domain is too short: "
            "surface %d enters at the %s with its bulk temperature, where it "
            "already receives %.0f %% of the maximum heat flux; move the %s "
            "out",
            k + 1, end, 100 * share, end);
    }
}

static void review(const ovr_accompanied_run *run)
{
    if (!ovr_simulation_state(run->sim)->n)
        return;
    warn_of_lag(run);
    warn_of_resolution(run);
    warn_of_points(run);
    warn_of_rise(run);
    warn_of_domain(run);
}

const ovr_companion ovr_heat_companion = {.review_before = review_before,
                                          .review = review};
