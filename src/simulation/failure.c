/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Messages about the reason why a solve failed: the property of contact or grid
 * that prevents a solution, if known; otherwise the convergence reached.
 *
 * The pressure builds up within a length of about H^(2/3) upstream of the
 * contact. A mesh size above 0.3 of this length resolves the build-up poorly;
 * above 0.7 there is no solution with a film, or one with a large error
 * (measured on 2,000 random contacts). With 0.2, contacts with M = 1400 to 5000
 * and L = 1 to 15 have a solution (0.23 and 0.29 failed at M = 2000).
 */
#include <math.h>
#include <stdio.h>

#include "contact/film_formula.h"
#include "simulation/physics.h"

static const double resolved = 0.3, too_coarse = 0.7;

/* Added to the message of a solve that reached its limit of work. */
static const char spent[] = " within 20 times the predicted work";

static double inlet_rise(const ovr_simulation *sim)
{
    return pow(ovr_target_film(&sim->target, 1), 2. / 3);
}

/* Mesh size relative to the length of the pressure build-up. */
static double inlet_mesh(const ovr_simulation *sim)
{
    return ovr_spacing(&sim->now, ovr_node_after(&sim->now, -1));
}

bool ovr_mesh_too_coarse(const ovr_simulation *sim)
{
    return inlet_mesh(sim) > too_coarse * inlet_rise(sim);
}

bool ovr_surfaces_apart(const ovr_simulation *sim)
{
    return sim->grids.kernels->positive(sim->now.n, sim->now.H);
}

bool ovr_below_rounding(const ovr_simulation *sim, const ovr_defect *defect)
{
    double minimum = ovr_negligible_tolerance(sim, ovr_mesh(sim),
                                              defect->centre);
    return sim->options.tolerance > 0 && sim->options.tolerance < minimum &&
           ovr_below(*defect, minimum);
}

static ovr_status rounding(const ovr_simulation *sim, const ovr_defect *defect,
                           ovr_error *err)
{
    return ovr_fail(
        err, OVR_NOT_CONVERGED,
        "tolerance = %.1e is below rounding error on this grid: the residual "
        "stalls at %.1e; use tolerance = %.1e",
        sim->options.tolerance, defect->imbalance,
        ovr_negligible_tolerance(sim, ovr_mesh(sim), defect->centre));
}

int ovr_level_resolving(const ovr_simulation *sim)
{
    double film = ovr_target_film(&sim->target, 1);
    double largest = ovr_resolving_mesh(sim->contact.M, film);
    return sim->finest->number +
           (int)fmax(1, ceil(log2(inlet_mesh(sim) / largest)));
}

/* Names the level that resolves the film or, if it is beyond all usual levels,
 * the conditions to change. */
static ovr_status too_thin(const ovr_simulation *sim, ovr_error *err)
{
    enum { FINEST = 14 };
    double rise = inlet_rise(sim), D = inlet_mesh(sim);
    int level = ovr_level_resolving(sim);
    char remedy[160];
    if (level <= FINEST)
        snprintf(remedy, sizeof remedy, "level %d resolves it", level);
    else
        snprintf(remedy, sizeof remedy,
                 "no level up to %d resolves it; use a higher speed or "
                 "viscosity%s",
                 FINEST,
                 sim->grids.touch.at ? " (asperities carry nearly all of the "
                                       "load)"
                                     : "");
    return ovr_fail(err, OVR_IMPOSSIBLE,
                    "the film is too thin for the grid: by the film thickness "
                    "formula H = %.1e, so that the pressure builds up within "
                    "%.1e b, but the mesh size is %.1e; %s",
                    ovr_target_film(&sim->target, 1), rise, D, remedy);
}

/* True if the surfaces overlap. In solves with touching surfaces R was 1e-5 to
 * 20, in diverged ones 1e6. If the overlap exceeds the feature heights plus a
 * nominal film thickness, the solve has diverged, too. Smooth surfaces have a
 * film at every load. */
static bool surfaces_overlap(const ovr_simulation *sim, const ovr_defect *d)
{
    if (!sim->shapes.heights)
        return false;
    size_t low = sim->grids.kernels->extreme(sim->now.n, 1, sim->now.H);
    double deep = -sim->now.H[low];
    double film = ovr_film_central_moes(sim->contact.M, sim->contact.L);
    return deep >= 0 && fabs(d->imbalance) < 1e3 &&
           deep < fabs(sim->shapes.S[low]) + film;
}

static ovr_status touching(const ovr_simulation *sim, double T, ovr_error *err)
{
    size_t low = sim->grids.kernels->extreme(sim->now.n, 1, sim->now.H);
    return ovr_fail(
        err, OVR_IMPOSSIBLE,
        "the surfaces touch at T = %g: film thickness H = %.1e at "
        "X = %.3f (surface height %.1e)%s; lower features or a "
        "higher level may help",
        T, sim->now.H[low], sim->now.X[low], sim->shapes.S[low],
        sim->grids.touch.at
            ? "; the asperity contact model carries too little load there"
            : "; asperity contact is modelled only with [boundary]");
}

static ovr_status too_few_cycles(const ovr_simulation *sim, ovr_error *err)
{
    const ovr_refinement *last =
        &sim->start.refinement[sim->start.refinements - 1];
    return ovr_fail(err, OVR_NOT_CONVERGED,
                    "%d cycles per refinement did not reach the "
                    "discretization error: algebraic error %.1e, "
                    "difference from the next coarser level %.1e",
                    sim->options.cycles, last->algebraic, last->difference);
}

/* Text about the convergence reached; special text if the solve diverged. */
typedef struct ending {
    char words[96];
} ending;

static ending ending_of(const ovr_defect *d)
{
    ending e;
    if (isfinite(d->imbalance) && d->load == 0) /* not measured */
        snprintf(e.words, sizeof e.words, "relative mass-flow imbalance %.1e",
                 d->imbalance);
    else if (isfinite(d->imbalance) && isfinite(d->load))
        snprintf(e.words, sizeof e.words,
                 "relative mass-flow imbalance %.1e, load error %.1e",
                 d->imbalance, d->load);
    else
        snprintf(e.words, sizeof e.words,
                 "it diverged, the mass-flow imbalance is not finite");
    return e;
}

/* Cycles are limited by the case. */
static const char *limit_of(const ovr_simulation *sim, size_t size, char *text)
{
    text[0] = '\0';
    if (sim->options.max_cycles)
        snprintf(text, size, " with solver.max_cycles = %d",
                 sim->options.max_cycles);
    return text;
}

ovr_reached ovr_failure_reached(const ovr_simulation *sim,
                                const ovr_outcome *outcome)
{
    const double R = outcome->defect.imbalance;
    ovr_reached r;
    char limit[50], imbalance[60] = "";
    if (isfinite(R))
        snprintf(imbalance, sizeof imbalance,
                 ", relative mass-flow imbalance %.1e", R);
    snprintf(r.text, sizeof r.text, "%s%s", limit_of(sim, sizeof limit, limit),
             imbalance);
    return r;
}

/* Suggests a remedy for a steady solve. */
static void instead_steady(const ovr_simulation *sim, bool rough, size_t size,
                           char *text)
{
    double film = ovr_target_film(&sim->target, 1);
    if (rough)
        snprintf(text, size,
                 "features that start upstream of the inlet, or grow in time, "
                 "are easier to solve");
    else if (inlet_mesh(sim) > ovr_resolving_mesh(sim->contact.M, film))
        snprintf(text, size,
                 "domain.level = %d resolves the pressure build-up at the "
                 "inlet",
                 ovr_level_resolving(sim));
    else
        snprintf(text, size,
                 "a finer [domain] level, a shear-thinning oil or a lower load "
                 "may help");
}

ovr_status ovr_failure_steady(const ovr_simulation *sim,
                              const ovr_outcome *outcome, double tolerance,
                              ovr_error *err)
{
    bool fixed = sim->options.stop == OVR_STOP_FIXED;
    if (fixed && sim->start.refinements > 0 && ovr_surfaces_apart(sim))
        return too_few_cycles(sim, err);
    if (ovr_below_rounding(sim, &outcome->defect))
        return rounding(sim, &outcome->defect, err);
    if (inlet_mesh(sim) > resolved * inlet_rise(sim))
        return too_thin(sim, err);
    OVR_EACH_PHYSICS(sim, p, in_solve, explain)
        if (p->is->in_solve->explain(sim, p->own, outcome, err))
            return OVR_NOT_CONVERGED;
    if (outcome->rough && surfaces_overlap(sim, &outcome->defect))
        return touching(sim, 0, err);
    char limit[50], text[120], tried[40] = "";
    if (outcome->retries)
        snprintf(tried, sizeof tried, " with any of %d strategies",
                 outcome->retries + 1);
    instead_steady(sim, outcome->rough, sizeof text, text);
    return ovr_fail(err, OVR_NOT_CONVERGED,
                    "the steady solution did not converge%s: %s after %d "
                    "cycles (target %.1e)%s%s; %s",
                    tried, ending_of(&outcome->defect).words, outcome->cycles,
                    tolerance, outcome->spent ? spent : "",
                    limit_of(sim, sizeof limit, limit), text);
}

/* Suggests a remedy, from the contact at reference load and speed. */
static void instead(const ovr_simulation *sim, size_t size, char *text)
{
    static const char *const remedies[2][2] = {
        {"; a finer domain.level or shear thinning (lubricant.rheology) may "
         "help",
         "; a finer domain.level may help"},
        {"; lower features, a finer domain.level or shear thinning "
         "(lubricant.rheology) may help",
         "; lower features or a finer domain.level may help"}};
    const bool features = sim->shapes.heights != NULL;
    const bool thins = sim->target.fluid.lubricant.rheology != OVR_NEWTONIAN;
    double H = ovr_film_central_moes(sim->contact.M, sim->contact.L);
    text[0] = '\0';
    OVR_EACH_PHYSICS(sim, p, in_step, advise)
        p->is->in_step->advise(sim, H, size, text);
    if (!*text)
        snprintf(text, size, "%s", remedies[features][thins]);
}

ovr_status ovr_failure_step(const ovr_simulation *sim,
                            const ovr_outcome *outcome, double T,
                            ovr_error *err)
{
    char text[400];
    instead(sim, sizeof text, text);
    if (!sim->grids.touch.at && surfaces_overlap(sim, &outcome->defect))
        return touching(sim, T, err);
    return ovr_fail(err, OVR_NOT_CONVERGED,
                    "the step %ld to T = %g did not converge, and neither "
                    "did steps down to 1/%d of the mesh size%s: %s after %d "
                    "cycles%s",
                    sim->state.step + 1, T, 1 << OVR_HALVINGS,
                    outcome->spent ? spent : "",
                    ending_of(&outcome->defect).words, outcome->cycles, text);
}
