/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/starved.h"

#include <math.h>

#include "multigrid/coarsest.h"
#include "multigrid/content.h"
#include "multigrid/fas.h"

static size_t place(const ovr_level *level, size_t i)
{
    return ovr_lanes_place(&level->lanes, i);
}

double ovr_content_leaving(const ovr_level *level)
{
    return level->f.q[place(level, level->grid.n - 2)];
}

/* Parameters for cycles that stall: twice the sweeps, then also a finer
 * coarsest grid. */
static void try_harder(const ovr_hierarchy *grids, const ovr_level *level,
                       ovr_cycling *c)
{
    int finer = c->bottom + 1;
    bool more = c->sweeps_after > 1 && finer < level->number &&
                finer < grids->coarsest + grids->newton.levels;
    c->sweeps_before = c->sweeps_after = 2;
    if (!more)
        return;
    c->bottom = finer;
    c->newton_steps = 2;
}

ovr_defect ovr_content_cycles(ovr_hierarchy *grids, const ovr_full *how,
                              ovr_level *level, int *cycles)
{
    enum { PATIENCE = 8 };
    ovr_cycling cycling = how->cycling;
    double before;
    ovr_defect d;
    ovr_level_refresh(grids, level);
    d = ovr_cycle_defect(grids, level);
    before = d.imbalance;
    for (int k = 0; k < how->max_cycles && d.imbalance < 1e6; k++) {
        if (ovr_below(d, how->tolerance(how->data, level, d.centre)))
            break;
        if (k % PATIENCE == PATIENCE - 1) {
            if (d.imbalance > 0.1 * before)
                try_harder(grids, level, &cycling);
            before = d.imbalance;
        }
        ovr_cycle(grids, level, cycling);
        d = ovr_cycle_defect(grids, level);
        ++*cycles;
    }
    return d;
}

/* Mass flow rate at X = 0. */
static double central_flow(const ovr_level *level)
{
    return ovr_level_centre(level, level->f.q);
}

/* Sets the contents of cavitated nodes to those of a constant flow rate. */
static void fill_dry(const ovr_level *level, double q)
{
    for (size_t i = 1; i < level->grid.n; i++)
        if (!ovr_lanes_has(&level->lanes, level->f.wet, i))
            level->f.q[place(level, i)] = q;
}

/* Starts mass-conserving cavitation from the pressure of the Reynolds equation.
 */
static void conserve(ovr_hierarchy *grids, ovr_level *level)
{
    double q = central_flow(level);
    grids->conserving = level->leads = true;
    ovr_content_by_pressure(grids, level);
    ovr_content_open(level);
    fill_dry(level, q);
}

/* Parameters for cycles that diverged: small, halved corrections. */
static ovr_full damped(const ovr_full *how)
{
    ovr_full to = *how;
    to.cycling.sweeps_before = to.cycling.sweeps_after = 2;
    to.cycling.smoothing.limit = 0.05;
    to.cycling.correction = 0.5;
    return to;
}

ovr_defect ovr_flooded(ovr_hierarchy *grids, const ovr_full *how, int *cycles)
{
    const double enough = 1e-4;
    const ovr_full again = damped(how);
    ovr_level *level = &grids->level[grids->finest];
    const double H0 = grids->H0;
    grids->supplied = false;
    ovr_level_read(grids, level, level->f.P, how->saved);
    conserve(grids, level);
    ovr_defect d = ovr_content_cycles(grids, how, level, cycles);
    if (how->fixed || ovr_below(d, enough))
        return d;
    grids->conserving = false;
    grids->H0 = H0;
    ovr_level_write(grids, level, how->saved, level->f.P);
    ovr_level_refresh(grids, level);
    conserve(grids, level);
    return ovr_content_cycles(grids, &again, level, cycles);
}

/* ------------------------------------------------- flooded on a coarse level
 */

static ovr_defect newton(ovr_hierarchy *grids, ovr_level *level, double limit,
                         int steps)
{
    const double enough = 1e-9;
    ovr_defect d;
    ovr_level_refresh(grids, level);
    d = ovr_cycle_defect(grids, level);
    for (int step = 0; step < steps && !ovr_below(d, enough); step++) {
        if (!ovr_newton_step(grids, level, limit))
            break;
        ovr_level_refresh(grids, level);
        d = ovr_cycle_defect(grids, level);
    }
    return d;
}

/* Returns the level on which the supply is reduced, with its flooded solution,
 * computed from every second node of the next finer level. */
static ovr_level *start_level(ovr_hierarchy *grids, double force, double limit)
{
    enum { STEPS = 60 };
    ovr_level *level = &grids->level[grids->finest];
    int start = grids->coarsest + grids->newton.levels - 1;
    ovr_full_prepare(grids, force);
    for (; level->number > start; level--)
        for (size_t I = 0; I < (level - 1)->grid.n; I++)
            (level - 1)->f.P[place(level - 1, I)] =
                level->f.P[place(level, 2 * I)];
    if (level->number == grids->finest)
        return level;
    grids->conserving = false;
    newton(grids, level, limit, STEPS);
    conserve(grids, level);
    newton(grids, level, limit, STEPS);
    return level;
}

/* ---------------------------------------------------------- reduced supply */

static void close_inlet(const ovr_hierarchy *grids, ovr_level *level, double q)
{
    double source = grids->op.speed * q / level->grid.D;
    ovr_content_close(level, source, q);
}

/* Scales the film with the supply. Upstream, where the gap is wider than twice
 * the supply, the film is cavitated. */
static void scale_film(ovr_hierarchy *grids, ovr_level *level, double q,
                       double before)
{
    double H = ovr_level_centre(level, level->f.H), fall = (1 - q / before) * H;
    grids->H0 -= fall;
    for (size_t i = 1; i + 1 < level->grid.n; i++) {
        size_t at = place(level, i);
        if (level->grid.X[i] < 0 && level->f.H[at] - fall > 2 * q) {
            level->f.P[at] = 0;
            ovr_content_mark(level, level->f.wet, i, false);
        }
    }
    fill_dry(level, q);
    close_inlet(grids, level, q);
}

/* One step of the supply by Newton's method. If it does not converge, restores
 * the state and returns false. */
static bool step(ovr_hierarchy *grids, ovr_level *level, double limit,
                 double before, double q)
{
    enum { STEPS = 60 };
    double *P = grids->scratch[0], *content = grids->scratch[1];
    double H0 = grids->H0;
    bool closed = level->closed;
    ovr_level_read(grids, level, level->f.P, P);
    ovr_level_read(grids, level, level->f.q, content);
    scale_film(grids, level, q, before);
    if (ovr_below(newton(grids, level, limit, STEPS), 1e-6))
        return true;
    ovr_level_write(grids, level, P, level->f.P);
    ovr_level_write(grids, level, content, level->f.q);
    ovr_content_by_pressure(grids, level);
    grids->H0 = H0;
    if (closed)
        close_inlet(grids, level, before);
    else
        ovr_content_open(level);
    ovr_level_refresh(grids, level);
    return false;
}

/* Changes the supply *q to the target by factors up to `factor`, smaller after
 * a failure. */
static bool travel(ovr_hierarchy *grids, ovr_level *level, double limit,
                   double *q, double target, double factor)
{
    const double minimum = 0.98;
    while (*q != target && factor < minimum) {
        double next = target < *q ? fmax(target, factor * *q)
                                  : fmin(target, *q / factor);
        if (step(grids, level, limit, *q, next))
            *q = next;
        else
            factor = sqrt(factor);
    }
    return *q == target;
}

/* A supply just below the flooded flow may have to be approached from below,
 * because its meniscus is far upstream. */
static void reduce(ovr_hierarchy *grids, ovr_level *level, double limit,
                   double target)
{
    double q = central_flow(level);
    if (!travel(grids, level, limit, &q, target, 0.5) &&
        travel(grids, level, limit, &q, 0.7 * target, 0.5))
        travel(grids, level, limit, &q, target, 0.95);
}

/* Supply of each level. */
typedef struct shares {
    double q, ratio, c;
} shares;

static double supply_of(const shares *s, const ovr_level *level, int finest)
{
    double error = ldexp(s->c, -2 * level->number) - ldexp(s->c, -2 * finest);
    return s->q * (1 - error);
}

/* Nested iteration from the start level, where the flooded solution is computed
 * again. */
static ovr_defect nested(ovr_hierarchy *grids, const ovr_full *how, double q,
                         double flow, int *cycles)
{
    const double limit = how->cycling.newton_limit;
    ovr_level *level = &grids->level[grids->finest];
    double here, before;
    ovr_defect d;
    grids->supplied = false;
    ovr_content_open(level);
    level = start_level(grids, level->force, limit);
    grids->supplied = true;
    here = central_flow(level);
    shares s = {.q = q};
    if (level->number < grids->finest)
        s.c = (1 - here / flow) /
              (ldexp(1, -2 * level->number) - ldexp(1, -2 * grids->finest));
    before = supply_of(&s, level, grids->finest);
    reduce(grids, level, limit, before);
    d = ovr_cycle_defect(grids, level);
    while (level->number < grids->finest) {
        double next = supply_of(&s, level + 1, grids->finest);
        ovr_fas_refine(grids, level, level + 1);
        level++;
        grids->H0 += (next / before - 1) *
                     ovr_level_centre(level - 1, (level - 1)->f.H);
        fill_dry(level, next);
        close_inlet(grids, level, next);
        before = next;
        d = ovr_content_cycles(grids, how, level, cycles);
    }
    return level->number == grids->finest && d.imbalance > 0
               ? ovr_content_cycles(grids, how, level, cycles)
               : d;
}

/* ------------------------------------------------------ just below flooded */

static bool is_solved(const ovr_full *how, const ovr_level *level, ovr_defect d)
{
    return ovr_below(d, how->tolerance(how->data, level, d.centre));
}

/* Increases the supply slightly on the finest level. */
static void raise_supply(ovr_hierarchy *grids, ovr_level *level, double before,
                         double q)
{
    grids->H0 += (q / before - 1) * ovr_level_centre(level, level->f.H);
    fill_dry(level, q);
    close_inlet(grids, level, q);
}

/* Restores a solution: nodes with P > 0 are pressurized; in cavitated nodes the
 * flow rate is constant. */
static void restore(ovr_hierarchy *grids, ovr_level *level, const double *P,
                    double H0, double q)
{
    ovr_level_write(grids, level, P, level->f.P);
    grids->H0 = H0;
    ovr_content_by_pressure(grids, level);
    fill_dry(level, q);
    close_inlet(grids, level, q);
}

/* Increases the supply from nine tenths of the flooded flow in steps of a
 * fraction of the remaining difference, which is halved if a step fails. Close
 * to the flooded flow the meniscus is far upstream in a nearly parallel gap
 * and moves by many mesh sizes for a small change of the supply. */
static ovr_defect approach(ovr_hierarchy *grids, const ovr_full *how,
                           double target, double flow, int *cycles)
{
    const double from = 0.9, beyond = 1.0025, maximum = 0.25, minimum = 0.01;
    ovr_level *level = &grids->level[grids->finest];
    double q = from * target, part = maximum;
    ovr_defect d = nested(grids, how, q, flow, cycles);
    if (!is_solved(how, level, d))
        return d;
    while (q < target && part > minimum) {
        double next = fmin(target, q + part * (beyond * flow - q));
        double H0 = grids->H0;
        ovr_level_read(grids, level, level->f.P, how->saved);
        raise_supply(grids, level, q, next);
        d = ovr_content_cycles(grids, how, level, cycles);
        if (is_solved(how, level, d)) {
            q = next;
            part = fmin(1.5 * part, maximum);
            continue;
        }
        restore(grids, level, how->saved, H0, q);
        part *= 0.5;
    }
    if (q < target) /* the solution is not that of this supply */
        d.imbalance = INFINITY;
    return d;
}

ovr_defect ovr_starve(ovr_hierarchy *grids, const ovr_full *how, double q,
                      int *cycles)
{
    ovr_level *level = &grids->level[grids->finest];
    double flow = ovr_content_leaving(level), H0 = grids->H0;
    ovr_level_read(grids, level, level->f.P, how->saved);
    ovr_defect d = nested(grids, how, q, flow, cycles);
    if (is_solved(how, level, d))
        return d;
    ovr_level_write(grids, level, how->saved, level->f.P);
    grids->H0 = H0;
    return approach(grids, how, q, flow, cycles);
}
