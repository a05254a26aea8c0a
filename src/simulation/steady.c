/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The steady solution by full multigrid: Newton on the coarsest grid from the
 * Hertzian pressure, then on each finer grid cubic interpolation and cycles.
 */
#include <math.h>
#include <string.h>

#include "multigrid/coarsest.h"
#include "multigrid/fas.h"
#include "simulation/internal.h"

static const double half_pi = 1.57079632679489661923;

static ovr_operator steady_operator(ovr_scheme scheme, double Cu)
{
    ovr_operator op = {
        .w = {1.5 * Cu, -2 * Cu, 0.5 * Cu}, .w_first = {Cu, -Cu}, .speed = Cu};
    if (scheme == OVR_UPSTREAM1) {
        op.w[0] = Cu;
        op.w[1] = -Cu;
        op.w[2] = 0;
    }
    return op;
}

/* Full weighting of the gap; the weights' own effect on X^2/2, D^2/4 with the
 * fine D, is taken out again. */
static void coarsen_gap(const ovr_level *fine, ovr_level *coarse)
{
    const double *g = fine->gap;
    size_t last = coarse->n - 1;
    double shift = 0.25 * fine->D * fine->D;
    coarse->gap[0] = g[0];
    coarse->gap[last] = g[2 * last];
    for (size_t I = 1; I < last; I++)
        coarse->gap[I] = 0.25 * (g[2 * I - 1] + 2 * g[2 * I] + g[2 * I + 1]) -
                         shift;
}

/* gap, F and force of every level as if it were the finest; roughness comes
 * down by full weighting so that no level aliases it. */
static void prepare_levels(ovr_simulation *sim, double force)
{
    ovr_hierarchy *grids = &sim->grids;
    for (int l = grids->finest; l >= grids->coarsest; l--) {
        ovr_level *level = &grids->level[l];
        memset(level->f.F, 0, level->n * sizeof(double));
        level->force = force;
        if (l < grids->finest)
            coarsen_gap(level + 1, level);
    }
}

/* Hertzian pressure; H0 from the film of the elastic asymptotes above the
 * rigid approach of the dry contact. */
static void hertzian_start(ovr_simulation *sim, ovr_level *level)
{
    double M = sim->contact.M, L = sim->contact.L;
    double piezo = 1.311 * pow(M, -0.125) * pow(L, 0.75);
    double iso = 2.05 * pow(M, -0.2);
    double film = (piezo > iso ? piezo : iso) * half_pi / (4 * M);
    for (size_t i = 0; i < level->n; i++) {
        double X = sim->grids.X_a + (double)i * level->D;
        level->f.P[i] = X * X < 1 ? sqrt(1 - X * X) : 0;
    }
    sim->grids.H0 = film - 0.5966;
}

bool ovr_below(ovr_defect d, double tolerance)
{
    return d.imbalance <= tolerance && d.load <= 10 * tolerance;
}

static ovr_defect solve_coarsest(ovr_simulation *sim, ovr_level *level)
{
    enum { STEPS = 100 };
    ovr_hierarchy *grids = &sim->grids;
    ovr_defect d = {INFINITY, INFINITY, 0};
    for (int step = 0; step < STEPS; step++) {
        ovr_level_refresh(grids, level);
        d = ovr_cycle_defect(grids, level);
        if ((step && ovr_below(d, 1e-8)) ||
            !ovr_newton_step(grids, level, grids->newton_limit))
            break;
    }
    return d;
}

/* Cycles on a level until below tolerance. */
static ovr_defect cycle_until(ovr_simulation *sim, ovr_level *level,
                              double tolerance, int most, int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_defect d = ovr_cycle_defect(grids, level);
    bool fixed = sim->options.stop == OVR_STOP_FIXED;
    for (int c = 0; c < most && (fixed || !ovr_below(d, tolerance)); c++) {
        ovr_cycle(grids, level);
        d = ovr_cycle_defect(grids, level);
        ++*cycles;
        if (!(d.imbalance < 1e6))
            break;
    }
    return d;
}

static double tolerance_at(const ovr_simulation *sim, const ovr_level *level)
{
    const ovr_options *o = &sim->options;
    if (level != sim->finest)
        return ovr_truncation_tolerance(level->D);
    if (o->tolerance > 0)
        return o->tolerance;
    return o->stop == OVR_STOP_TRUNCATION ? ovr_truncation_tolerance(level->D)
                                          : ovr_negligible_tolerance(level->D);
}

static int most_cycles(const ovr_options *o, int level)
{
    enum { ON_THE_WAY = 20 };
    if (o->stop == OVR_STOP_FIXED)
        return o->cycles;
    return level == o->level ? o->max_cycles : ON_THE_WAY;
}

static ovr_defect full_multigrid(ovr_simulation *sim, int *cycles)
{
    const ovr_options *o = &sim->options;
    ovr_hierarchy *grids = &sim->grids;
    ovr_level *level = &grids->level[grids->coarsest];
    hertzian_start(sim, level);
    ovr_defect d = solve_coarsest(sim, level);
    while (level->number < grids->finest && d.imbalance < 1e6) {
        ovr_fas_refine(level, level + 1);
        level++;
        ovr_level_refresh(grids, level);
        d = cycle_until(sim, level, tolerance_at(sim, level),
                        most_cycles(o, level->number), cycles);
    }
    return d;
}

/* The past of a run that was steady before T = 0. */
static void begin_history(ovr_simulation *sim)
{
    ovr_past *past = &sim->past;
    size_t bytes = sim->finest->n * sizeof(double);
    for (int k = 0; k < 2; k++)
        memcpy(past->q[k], sim->finest->f.q, bytes);
    for (int k = 0; k < 3; k++) {
        memcpy(past->P[k], sim->finest->f.P, bytes);
        past->H0[k] = sim->grids.H0;
        past->T[k] = 0;
    }
    past->dT = 0;
    past->steps = 0;
}

ovr_status ovr_simulation_steady(ovr_simulation *sim, ovr_error *err)
{
    double Cu = ovr_history_value(sim->speed, 0);
    double Cw = ovr_history_value(sim->load, 0);
    double tolerance = tolerance_at(sim, sim->finest);
    ovr_operator op = steady_operator(sim->options.scheme, Cu);
    ovr_outcome outcome = {0};
    ovr_simulation_defaults(sim);
    ovr_simulation_gap(sim, 0);
    ovr_hierarchy_operator(&sim->grids, &op);
    prepare_levels(sim, half_pi * Cw);
    outcome.defect = full_multigrid(sim, &outcome.cycles);
    outcome.converged = ovr_below(outcome.defect, tolerance);
    sim->statistics = (ovr_statistics){.cycles = outcome.cycles};
    sim->state = (ovr_state){0};
    ovr_observe(sim, 0, &outcome);
    begin_history(sim);
    sim->started = outcome.converged;
    if (!outcome.converged)
        return ovr_fail(err, OVR_NOT_CONVERGED,
                        "the steady solution did not converge: relative "
                        "mass-flow imbalance %.1e (wanted %.1e), load off by "
                        "%.1e after %d cycles",
                        outcome.defect.imbalance, tolerance,
                        outcome.defect.load, outcome.cycles);
    return OVR_OK;
}
