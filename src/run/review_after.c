/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Warnings about a completed run. */
#include <math.h>

#include "case/domain.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "elements/run_element.h"
#include "physics/plastic/plastic.h"
#include "physics/supply/supply.h"
#include "run/internal.h"
#include "run/review.h"
#include "run/summary_lines.h"
#include "simulation/simulation.h"
#include "surface/surfaces.h"

/* ------------------------------------------------------------- shear stress */

/* Shear stress of the fluid relative to its pressure at the end of a run: the
 * largest ratio at nodes with at least a fifth of p_h, and the fraction of
 * these nodes where the ratio exceeds 0.1, which lubricants do not sustain. A
 * Newtonian isothermal film has such stresses wherever it slides under
 * pressure. Film thickness and pressure are not affected, so the warning
 * belongs to friction. */

static const double CARRIED = 0.1, CARRIES = 0.2;

/* Fills shear_over_pressure and unbearable_share. */
static void run_shear(ovr_run *run)
{
    const ovr_state *state = ovr_simulation_state(run->sim);
    const double *stress = ovr_film_stress(run->sim);
    double kappa = run->setup->contact->kappa;
    double maximum = 0, count = 0, beyond = 0;
    for (size_t i = 0; i + 1 < state->n; i++) {
        double P = (state->P[i] + state->P[i + 1]) / 2;
        double t = kappa * fabs(stress[i]);
        if (P < CARRIES)
            continue;
        count++;
        beyond += t > CARRIED * P;
        maximum = fmax(maximum, t / P);
    }
    run->info.shear_over_pressure = isnan(kappa) ? NAN : maximum;
    run->info.unbearable_share = isnan(kappa) || count == 0 ? NAN
                                                            : beyond / count;
}

/* Warns if fourth order was requested or chosen and not reached. */
static void warn_of_order(const ovr_review *r, const ovr_simulation *sim)
{
    const ovr_block *domain = ovr_case_find_block(r->c, "domain", NULL);
    int maximum = r->setup->options->max_cycles;
    if (ovr_setup_corrected(r->setup))
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "the solution is of second order, because the fourth-order "
            "corrections did not converge on this grid%s; use level = %d",
            maximum ? " within max_cycles" : "", ovr_level_resolving(sim));
    else if (ovr_block_get(domain, "order")->given)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "the solution is of second order: fourth-order corrections need "
            "constant load, speed and radius and cavitation.model = "
            "reynolds, or scheme = characteristic and a speed that never "
            "reverses");
}

/* Warns of unusual pressures. For a steady solution the extremes are those of
 * its only state. */
static void warn_of_pressure(const ovr_review *r, const ovr_statistics *total)
{
    double ph = r->setup->contact->ph, bearable = r->setup->bearable;
    if (total->extreme.P_max * ph > bearable)
        ovr_review_add(r, OVR_MESSAGE_WARNING,
                       "the pressure of %.3g GPa at X = %.4g, T = %.4g exceeds "
                       "bearable_pressure = %.3g GPa%s",
                       total->extreme.P_max * ph * 1e-9, total->where.P_max,
                       total->when.P_max, bearable * 1e-9,
                       ovr_setup_plastic(r->setup)
                           ? ""
                           : ": the body would yield; see [plastic]");
}

/* Warns of films thinner than molecules, which are not a continuum. Asperities
 * of [boundary] do not need a continuum. */
static void warn_of_thin_film(const ovr_review *r, const ovr_statistics *total)
{
    double h = total->extreme.H_min_located * r->setup->contact->height;
    if (!(h < OVR_MOLECULE) ||
        (ovr_setup_physics(r->setup) & OVR_PHYSICS_BOUNDARY))
        return;
    ovr_review_add(
        r, OVR_MESSAGE_WARNING,
        "the minimum film thickness of %.2g nm at X = %.4g, T = %.4g is "
        "below the size of lubricant molecules (1 nm); the surfaces touch "
        "there, see [boundary]",
        1e9 * h, total->where.H_min_located, total->when.H_min_located);
}

/* The pressure of a Newtonian film at a surface feature, or in the spike at the
 * outlet, grows with the logarithm of the mesh size. */
static void warn_of_spike(const ovr_review *r, const ovr_statistics *total)
{
    bool thins = r->setup->lubricant->rheology != OVR_NEWTONIAN;
    ovr_words remedy = {""}, place = {""};
    if (!total->P_max_unresolved)
        return;
    if (!thins)
        ovr_words_add(&remedy, "set lubricant.rheology = eyring, as lubricants "
                               "shear-thin at such pressure gradients, or ");
    ovr_words_add(&remedy, "use a finer grid (domain.level = %d)",
                  r->setup->options->level + 1);
    if (total->X_unresolved != total->where.P_max ||
        total->T_unresolved != total->when.P_max)
        ovr_words_add(&place, "at X = %.4g, T = %.4g", total->X_unresolved,
                      total->T_unresolved);
    ovr_review_add(
        r, OVR_MESSAGE_WARNING,
        "the maximum pressure %.4g p_h at X = %.4g, T = %.4g is not resolved, "
        "nor are stresses close to the surface: the pressure spike %s is "
        "a few mesh sizes wide%s; %s",
        total->extreme.P_max, total->where.P_max, total->when.P_max,
        place.text[0] ? place.text : "there",
        thins ? ""
              : ", and its height grows without limit on finer grids because "
                "the lubricant is Newtonian",
        remedy.text);
}

static void warn_of_roughness(const ovr_review *r, const ovr_statistics *total)
{
    double Rq = r->setup->surfaces ? ovr_surfaces_roughness(r->setup->surfaces)
                                   : 0;
    double height = r->setup->contact->height;
    ovr_words um = {""};
    if (isfinite(height))
        ovr_words_add(&um, " (%s)", ovr_metres(Rq * height).text);
    if (total->extreme.H_min_located < Rq)
        ovr_review_add(r, OVR_MESSAGE_WARNING,
                       "minimum film thickness H = %.3g (X = %.4g, T = %.4g) "
                       "is below the composite roughness Rq = %.3g b^2/R%s of "
                       "the whole surfaces; asperities would touch, see "
                       "[boundary]",
                       total->extreme.H_min_located, total->where.H_min_located,
                       total->when.H_min_located, Rq, um.text);
}

/* Warns if the film extends to the outlet boundary, where the pressure is set
 * to zero. If the speed reverses, the last node is the inlet. */
static void warn_of_full_outlet(const ovr_review *r,
                                const ovr_statistics *total)
{
    const ovr_setup *s = r->setup;
    double end = fabs(total->extreme.X_cavitation);
    bool reverses = fabs(s->options->inlet + s->options->outlet) < s->mesh;
    if (reverses || !(end > s->options->outlet - 0.5 * s->mesh))
        return;
    ovr_review_add(r, OVR_MESSAGE_WARNING,
                   "the film reaches the outlet boundary X = %.4g at T = %.4g, "
                   "which cuts off its pressure; set domain.outlet = %.4g",
                   s->options->outlet, total->when.X_cavitation,
                   1.5 * s->options->outlet);
}

/* Warns of many cycles: 3 per step are usual, and the steady start has
 * additional ones. */
static void warn_of_cycles(const ovr_review *r, const ovr_statistics *total)
{
    const long far = 20, start = 500;
    if (total->steps > 0 && total->cycles > far * total->steps + start)
        ovr_review_add(r, OVR_MESSAGE_WARNING,
                       "%ld cycles for %ld time steps (3 per step are usual); "
                       "the grid barely resolves this run, use a higher level",
                       total->cycles, total->steps);
}

static void warn_of_extremes(const ovr_review *r, const ovr_statistics *total)
{
    if (!(total->extreme.H_min_located > 0)) /* no solution */
        return;
    warn_of_pressure(r, total);
    warn_of_spike(r, total);
    warn_of_thin_film(r, total);
    warn_of_roughness(r, total);
    warn_of_full_outlet(r, total);
    warn_of_cycles(r, total);
}

/* Warns if the film is not steady when end = auto stops, some time after the
 * last feature has left. */
static void warn_of_unrest(const ovr_review *r, double T, bool settled)
{
    const ovr_march *march = r->setup->march;
    if (march->steady_from > 0 && !settled && T > 0.999 * march->end)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "all features had left at T = %.4g, but the film is still not "
            "steady at T = %.4g, where end = auto stops",
            march->steady_from, march->end);
}

void ovr_run_review_after(ovr_run *run)
{
    ovr_review r = {run->c, run->setup, ovr_run_message, run};
    const ovr_simulation *sim = run->sim;
    const ovr_state *state = ovr_simulation_state(sim);
    double H_cen = ovr_simulation_observation(sim)->H_cen;
    const char *strategy = ovr_simulation_strategy(sim);
    if (run->setup->options->order == 4 && ovr_simulation_order(sim) != 4)
        warn_of_order(&r, sim);
    if (ovr_mesh_too_coarse(sim))
        ovr_review_add(&r, OVR_MESSAGE_WARNING,
                       "the film thickness may be wrong by tens of per cent: "
                       "the film is too thin for the grid, and the pressure "
                       "builds up within one or two mesh sizes; use level = %d",
                       ovr_level_resolving(sim));
    if (*strategy)
        ovr_review_add(&r, OVR_MESSAGE_NOTE,
                       "the steady solution needed another strategy: %s",
                       strategy);
    if (state->n && H_cen > 0 && ovr_setup_supply(r.setup)->film &&
        isnan(ovr_simulation_observation(sim)->meniscus) &&
        r.setup->resolved->inlet_kept >= 0)
        ovr_review_inlet(&r, state, H_cen);
    ovr_companions_review(run);
    warn_of_extremes(&r, ovr_simulation_statistics(sim));
    if (run->info.transient && ovr_simulation_statistics(sim)->steps > 0)
        ovr_review_element_after(r.setup, ovr_simulation_statistics(sim),
                                 ovr_run_message, run);
    warn_of_unrest(&r, state->T, ovr_simulation_statistics(sim)->settled);
    run->info.lambda_ratio = ovr_simulation_statistics(sim)->mean.lambda_ratio;
    if (state->n && H_cen > 0)
        run_shear(run);
}
