/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/full.h"

#include <math.h>

#include "contact/film_formula.h"
#include "multigrid/coarsest.h"
#include "multigrid/fas.h"

/* State of a solution by nested iteration. */
typedef struct nested {
    ovr_hierarchy *grids;
    const ovr_target *target;
    const ovr_full *how;
    int *cycles;
    bool reporting; /* the full load is applied; progress is reported */
} nested;

/* Full weighting, in place. For the gap, the effect of the weighting on X^2/2
 * (D^2/4 with the fine D) is subtracted. */
static void coarsen(const ovr_level *fine, size_t field, double *g)
{
    size_t last = (fine->grid.n - 1) / 2;
    double shift = field == OVR_FIELD_gap ? 0.25 * fine->grid.D * fine->grid.D
                                          : 0;
    for (size_t I = 1; I < last; I++)
        g[I] = 0.25 * (g[2 * I - 1] + 2 * g[2 * I] + g[2 * I + 1]) - shift;
    g[last] = g[2 * last];
}

/* Restricts a field from the finest level to all others, so that no level
 * aliases roughness. */
static void carry_down(ovr_hierarchy *grids, size_t field)
{
    double *g = grids->scratch[0];
    ovr_level *level = &grids->level[grids->finest];
    ovr_level_read(grids, level, level->f.all[field], g);
    for (; level->number > grids->coarsest; level--) {
        coarsen(level, field, g);
        ovr_level_write(grids, level - 1, g, (level - 1)->f.all[field]);
    }
}

void ovr_full_prepare(ovr_hierarchy *grids, double force)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (ovr_field_rows[k].carried)
            carry_down(grids, k);
    for (int l = grids->coarsest; l <= grids->finest; l++) {
        ovr_level_clear(&grids->level[l], grids->level[l].f.F);
        grids->level[l].force = force;
    }
}

/* For load Cw, speed Cu and curvature c relative to their reference values, M
 * is proportional to Cw sqrt(c/Cu), L to (Cu c)^(1/4), and the film thickness
 * unit b^2/R to Cw. */
double ovr_target_film(const ovr_target *target, double fraction)
{
    double Cw = target->Cw, Cu = target->Cu;
    double M = fraction * target->M * Cw / sqrt(Cu / target->c);
    return Cw * ovr_film_central_moes(M, target->L * pow(Cu * target->c, 0.25));
}

/* p_h is proportional to the square root of the load. */
static ovr_fluid target_fluid(const ovr_target *target, double fraction)
{
    double ratio = 1 / fraction, root = sqrt(ratio);
    ovr_fluid fluid = target->fluid;
    fluid.lambda = fluid.lambda * ratio * ratio;
    fluid.lubricant.alphabar /= root;
    fluid.lubricant.P0 *= root;
    fluid.lubricant.A *= root;
    fluid.lubricant.Sigma0 *= ratio;
    return fluid;
}

static bool thins(const nested *a)
{
    return a->target->fluid.lubricant.rheology != OVR_NEWTONIAN;
}

static ovr_fluid newtonian(ovr_fluid fluid)
{
    fluid.lubricant.Sigma0 = INFINITY;
    return fluid;
}

/* Fluid during nested iteration: Newtonian if the rheological model is applied
 * last. */
static ovr_fluid fluid_at(const nested *a, double fraction)
{
    ovr_fluid fluid = target_fluid(a->target, fraction);
    return a->how->thin_last ? newtonian(fluid) : fluid;
}

/*
 * Initial guess: Hertz's semi-ellipse, but at least as wide as the film,
 * sqrt(H/c), if the film is thicker than the deformation. H0 is the film
 * thickness by formula plus the rigid-body approach of the dry contact, Cw
 * (-0.5966 + ln(a)/2) for half-width a.
 */
static void hertzian_start(const nested *a, ovr_level *level, double fraction)
{
    ovr_hierarchy *grids = a->grids;
    double Cw = a->target->Cw, H = ovr_target_film(a->target, fraction);
    double width = sqrt((H > Cw ? H : Cw) / a->target->c),
           *P = grids->scratch[0];
    for (size_t i = 0; i < level->grid.n; i++) {
        double x = level->grid.X[i] / width;
        P[i] = x * x < 1 ? Cw / width * sqrt(1 - x * x) : 0;
    }
    P[0] = P[level->grid.n - 1] = 0;
    ovr_level_write(grids, level, P, level->f.P);
    grids->H0 = H + Cw * (-0.5966 + 0.5 * log(width));
}

static void report(const nested *a, const ovr_level *level,
                   ovr_full_event event, const ovr_full_status *status)
{
    if (a->reporting && a->how->watch)
        a->how->watch(a->how->data, level, event, status);
}

static bool is_done(const nested *a, const ovr_level *level, ovr_defect d)
{
    return ovr_below(d, a->how->tolerance(a->how->data, level, d.centre));
}

/* Newton's method on the coarsest grid; to the final tolerance if there is no
 * finer grid. */
static ovr_defect solve_coarsest(const nested *a, ovr_level *level)
{
    enum { STEPS = 100 };
    const double enough = 1e-8;
    bool finest = level->number == a->grids->finest;
    ovr_defect d = {INFINITY, INFINITY, 0};
    for (int step = 0; step < STEPS; step++) {
        ovr_level_refresh(a->grids, level);
        d = ovr_cycle_defect(a->grids, level);
        if ((step && ovr_below(d, enough) &&
             (!finest || is_done(a, level, d))) ||
            !ovr_newton_step(a->grids, level, a->how->cycling.newton_limit))
            break;
    }
    return d;
}

/* Largest residuals of the last `trial` cycles, and of the same number before.
 */
typedef struct progress {
    double before, now;
} progress;

/* Called after each cycle. The maximum is used because in a limit cycle R is
 * often small, but its maximum is not. */
static bool gains(progress *p, const ovr_full_status *c, int trial)
{
    p->now = fmax(p->now, c->defect.imbalance);
    if (!trial || c->cycles % trial)
        return true;
    bool enough = !(p->now > p->before * 2 / 3);
    *p = (progress){p->now, 0};
    return enough;
}

/* Performs cycles on a level until the tolerance is reached. */
static ovr_full_status cycle_until_done(const nested *a, ovr_level *level)
{
    enum { ON_THE_WAY = 20 };
    const ovr_full *how = a->how;
    bool finest = level->number == a->grids->finest;
    int maximum = finest || how->fixed ? how->max_cycles : ON_THE_WAY;
    ovr_full_status c = {.defect = ovr_cycle_defect(a->grids, level)};
    progress trial = {INFINITY, c.defect.imbalance};
    bool gained = true;
    while (c.cycles < maximum && c.defect.imbalance < 1e6 && gained) {
        double before = c.defect.imbalance;
        if (!how->fixed && c.cycles >= how->min_cycles &&
            is_done(a, level, c.defect))
            break;
        report(a, level, OVR_FULL_CYCLES, &c);
        ovr_cycle(a->grids, level, how->cycling);
        c.defect = ovr_cycle_defect(a->grids, level);
        c.factor = c.defect.imbalance / before;
        c.cycles++;
        gained = gains(&trial, &c, how->trial);
    }
    *a->cycles += c.cycles;
    return c;
}

ovr_defect ovr_full_cycles(ovr_hierarchy *grids, ovr_level *level,
                           const ovr_full *how, int *cycles)
{
    const nested a = {.grids = grids, .how = how, .cycles = cycles};
    return cycle_until_done(&a, level).defect;
}

/* Refines a solved level up to level `top`. */
static ovr_defect refine_to(const nested *a, ovr_level *level, int top)
{
    ovr_full_status c = {.defect = ovr_cycle_defect(a->grids, level)};
    while (level->number < top && c.defect.imbalance < 1e6) {
        report(a, level, OVR_FULL_BEGINS, &c);
        ovr_fas_refine(a->grids, level, level + 1);
        level++;
        ovr_level_refresh(a->grids, level);
        c = cycle_until_done(a, level);
        report(a, level, OVR_FULL_ENDS, &c);
    }
    return c.defect;
}

/*
 * Continuation in load on one level, from a solution at the fraction `from` to
 * the full load. The pressure, nearly Hertzian, hardly changes. The film
 * thickness decreases uniformly, so H0 follows the film thickness formula.
 */
static ovr_defect raise_load(const nested *a, ovr_level *level, double from)
{
    ovr_hierarchy *grids = a->grids;
    double factor = a->how->load_factor, *saved = a->how->saved;
    ovr_defect d = ovr_cycle_defect(grids, level);
    while (from < 1 && factor > 1.01) {
        double to = fmin(from * factor, 1), H0 = grids->H0;
        ovr_level_read(grids, level, level->f.P, saved);
        grids->fluid = fluid_at(a, to);
        grids->H0 += ovr_target_film(a->target, to) -
                     ovr_target_film(a->target, from);
        ovr_level_refresh(grids, level);
        d = cycle_until_done(a, level).defect;
        if (ovr_below(d, 1e-2) && d.load < 1e-2) {
            from = to;
            continue;
        }
        factor = sqrt(factor);
        ovr_level_write(grids, level, saved, level->f.P);
        grids->H0 = H0;
    }
    return d;
}

/*
 * Continuation on one level from the Newtonian solution to that of the
 * rheological model: in one step, or in several steps of tau0. A step that
 * fails is halved in ln tau0.
 */
static ovr_defect thin_out(const nested *a, ovr_level *level, ovr_fluid fluid,
                           bool newton)
{
    ovr_hierarchy *grids = a->grids;
    double from = 1e3, step = from, *saved = a->how->saved;
    double tolerance = newton ? 1e-4 : 1e-2;
    ovr_defect d = ovr_cycle_defect(grids, level);
    while (from > 1 && step > 1.05) {
        double to = fmax(from / step, 1), H0 = grids->H0;
        ovr_level_read(grids, level, level->f.P, saved);
        grids->fluid.lubricant.Sigma0 = to * fluid.lubricant.Sigma0;
        ovr_level_refresh(grids, level);
        d = newton ? solve_coarsest(a, level)
                   : cycle_until_done(a, level).defect;
        if (ovr_below(d, tolerance)) {
            from = to;
            continue;
        }
        step = sqrt(step);
        ovr_level_write(grids, level, saved, level->f.P);
        grids->H0 = H0;
    }
    grids->fluid = fluid;
    return d;
}

/* Solves the coarsest grid at the largest fraction of the load for which the
 * film is thicker than about D^1.5 (measured) and Newton's method converges. */
static double solve_easy_load(const nested *a, ovr_level *level)
{
    const double minimum = 1e-3;
    double fraction = 1;
    while (fraction > minimum &&
           ovr_target_film(a->target, fraction) < pow(level->grid.D, 1.5))
        fraction *= 0.9;
    for (;; fraction *= 0.7) {
        ovr_fluid fluid = target_fluid(a->target, fraction);
        a->grids->fluid = thins(a) ? newtonian(fluid) : fluid;
        hertzian_start(a, level, fraction);
        ovr_defect d = solve_coarsest(a, level);
        if (thins(a) && !a->how->thin_last && ovr_below(d, 1e-4))
            d = thin_out(a, level, fluid, true);
        if (ovr_below(d, 1e-4) || fraction < minimum)
            return fraction;
    }
}

/* The level on which the load is increased. */
static int load_level(const nested *a)
{
    const ovr_hierarchy *grids = a->grids;
    double rise = pow(ovr_target_film(a->target, 1), 2. / 3) /
                  sqrt(a->target->c);
    int level = grids->coarsest;
    while (level < grids->finest &&
           grids->level[level].grid.D > a->how->mesh * rise)
        level++;
    return level;
}

ovr_defect ovr_full_multigrid(ovr_hierarchy *grids, const ovr_target *target,
                              ovr_full how, int *cycles)
{
    nested a = {grids, target, &how, cycles, false};
    ovr_level *level = &grids->level[how.cycling.bottom];
    ovr_full_prepare(grids, target->force);
    double fraction = solve_easy_load(&a, level);
    ovr_defect d = ovr_cycle_defect(grids, level);
    if (fraction < 1) {
        int top = load_level(&a);
        if (top > level->number) {
            refine_to(&a, level, top);
            level = &grids->level[top];
        }
        d = raise_load(&a, level, fraction);
        grids->fluid = fluid_at(&a, 1);
    }
    a.reporting = true;
    if (level->number < grids->finest)
        d = refine_to(&a, level, grids->finest);
    if (how.thin_last)
        d = thin_out(&a, &grids->level[grids->finest], target_fluid(target, 1),
                     false);
    return d;
}
