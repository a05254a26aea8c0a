/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "physics/mixed/nested.h"

#include <math.h>

#include "multigrid/mixed_contact.h"
#include "simulation/steady.h"

/* Residual below which a level of a mixed contact is solved. */
static const double enough = 1e-4;

/* Film thickness with A(H) = P, by bisection. */
static double film_of(const ovr_asperity_law *law, double P)
{
    double low = 0, high = 1, A, slope;
    for (int k = 0; k < 60; k++) {
        double H = k < 20 ? high : 0.5 * (low + high);
        ovr_asperity_law_at(law, H, &A, &slope);
        if (A > P)
            low = H;
        else
            high = H;
        if (k < 20 && A > P)
            high *= 2;
    }
    return high;
}

/* Sets all levels to the contact to be solved. */
static void prepare(ovr_simulation *sim)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_simulation_gap(sim, 0);
    ovr_full_prepare(grids, sim->target.force);
    grids->fluid = sim->target.fluid;
    ovr_asperity_settle(grids);
    grids->touch.share = 1;
}

/* Starts a level from a contact whose load is carried by asperities: Hertzian
 * pressure, a film thickness that supports its mean, and almost no fluid
 * pressure. */
static void start_dry(ovr_simulation *sim, const ovr_asperity_law *law,
                      const ovr_level *level)
{
    const double mean = acos(-1.0) / 4, oil = 1e-3;
    const ovr_target *target = &sim->target;
    ovr_hierarchy *grids = &sim->grids;
    double width = sqrt(target->Cw / target->c);
    double root = sqrt(target->Cw * target->c);
    double *A = ovr_work_take(sim), *film = ovr_work_take(sim);
    for (size_t i = 0; i < level->grid.n; i++) {
        double x = level->grid.X[i] / width;
        double P = x * x < 1 ? root * sqrt(1 - x * x) : 0;
        A[i] = (1 - oil) * P;
        film[i] = oil * P;
    }
    grids->H0 = film_of(law, mean * root) +
                target->Cw * (-0.5966 + 0.5 * log(width));
    ovr_level_set_asperity_pressure(grids, level, A);
    ovr_level_write(grids, level, film, level->f.P);
    ovr_work_give(sim, film);
    ovr_work_give(sim, A);
}

bool ovr_mixed_from_dry(ovr_simulation *sim, const ovr_asperity_law *law,
                        const ovr_full *how, ovr_defect *d, int *cycles)
{
    enum { PATIENT = 200, TRIAL = 60 };
    ovr_full patient = *how;
    prepare(sim);
    start_dry(sim, law, sim->finest);
    if (!how->fixed && !sim->options.max_cycles) {
        patient.max_cycles = PATIENT;
        patient.trial = TRIAL;
    }
    *d = ovr_steady_cycles(sim, &patient, cycles);
    return ovr_below(*d, enough);
}

/* Starts the level that is now the finest from the full film. */
static void start_apart(ovr_simulation *sim, const ovr_level *level,
                        const ovr_full *how, int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_asperity_clear(level);
    grids->touch.at = NULL;
    ovr_full_multigrid(grids, &sim->target, *how, cycles);
    grids->touch.at = ovr_asperity_law_at;
}

static bool solve_level(ovr_simulation *sim, ovr_level *level,
                        const ovr_full *how, ovr_defect *d, int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_asperity_settle(grids);
    ovr_level_refresh(grids, level);
    *d = ovr_full_cycles(grids, level, how, cycles);
    return ovr_below(*d, enough);
}

/* Solves a level without a solution on a coarser one. */
static bool solve_first(ovr_simulation *sim, const ovr_asperity_law *law,
                        bool dry_first, ovr_level *level, const ovr_full *how,
                        ovr_defect *d, int *cycles)
{
    for (int k = 0; k < 2; k++) {
        if ((k == 0) == dry_first)
            start_dry(sim, law, level);
        else
            start_apart(sim, level, how, cycles);
        if (solve_level(sim, level, how, d, cycles))
            return true;
    }
    return false;
}

/* Solves the next finer level, by one interpolation of the coarse solution or
 * else by the other: which one converges is a matter of chance. */
static bool refine(ovr_simulation *sim, ovr_level *level, const ovr_full *how,
                   ovr_defect *d, int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    const double H0 = grids->H0;
    ovr_asperity_move(grids, level->number);
    for (int smooth = 0; smooth < 2; smooth++) {
        grids->H0 = H0;
        ovr_asperity_refine(grids, level - 1, level, smooth);
        if (solve_level(sim, level, how, d, cycles))
            return true;
    }
    return false;
}

/* Coarser levels are solved to this tolerance. */
static double tolerance(const void *data, const ovr_level *level, double H)
{
    (void)data;
    (void)level;
    (void)H;
    return 0.1 * enough;
}

static bool can_nest(const ovr_simulation *sim, const ovr_full *how)
{
    return !how->fixed && !sim->start.grown && !sim->grids.content;
}

bool ovr_mixed_nested(ovr_simulation *sim, const ovr_asperity_law *law,
                      bool dry_first, const ovr_full *how, ovr_defect *d,
                      int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_full brief = *how;
    const int top = grids->finest;
    int l = top;
    bool found = false;
    if (!can_nest(sim, how))
        return false;
    brief.watch = NULL;
    brief.tolerance = tolerance;
    prepare(sim);
    while (!found && l-- > grids->touch.coarsest) {
        ovr_asperity_move(grids, l);
        found = solve_first(sim, law, dry_first, &grids->level[l], &brief, d,
                            cycles);
    }
    while (found && l < top) {
        const ovr_full *to = ++l < top ? &brief : how;
        found = refine(sim, &grids->level[l], to, d, cycles);
    }
    if (grids->finest != top)
        ovr_asperity_move(grids, top);
    return found;
}
