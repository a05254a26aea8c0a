/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/fourth_order.h"

#include <math.h>
#include <string.h>

#include "multigrid/field.h"
#include "multigrid/flow.h"

enum {
    MASKS = 3, /* number of corrections that compute the mask */
    TRIES = 8  /* number of corrections that must reduce the residual by a third
                */
};

ovr_status ovr_correction_prepare(ovr_hierarchy *grids, ovr_correction *c,
                                  ovr_arena *arena, ovr_error *err)
{
    size_t capacity = grids->level[grids->finest].grid.n + OVR_MAX_LANES;
    return OVR_TAKE_FIELDS(arena, capacity, err, &c->F, &c->gap, &c->mask,
                           &c->gap_only);
}

/* Number of values of a field with its halo, as one array. */
static size_t length(const ovr_level *level)
{
    return (level->lanes.S + 2 * OVR_HALO) * level->lanes.V;
}

static double *begin(const ovr_level *level, double *values)
{
    return values - OVR_HALO * (ptrdiff_t)level->lanes.V;
}

static void evaluate(const ovr_hierarchy *grids, const ovr_correction *c,
                     double Cu, bool backward, bool mask)
{
    const ovr_kernels *run = grids->kernels;
    const ovr_fluid *fluid = &grids->fluid;
    const ovr_level *level = &grids->level[grids->finest];
    const ptrdiff_t ends = (ptrdiff_t)level->grid.n + OVR_HALO,
                    centre = (ptrdiff_t)ceil(-level->grid.X[0] / level->grid.D);
    const ovr_fourth how = {
        .fluid = fluid,
        .D = level->grid.D,
        .Cu = Cu,
        .first = backward ? (ptrdiff_t)level->grid.n - 1 - centre : -ends,
        .end = backward ? ends : centre,
        .log_eps = grids->band.b[0],
        .flux = grids->band.b[1],
        .rise = grids->band.b[2],
        .mask = c->mask,
        .F = c->F,
        .gap = c->gap,
        .linear = grids->influence.linear,
        .reduced = fluid->logarithmic && !ovr_flow_is_shear_thinning(fluid) &&
                   !fluid->law,
        .local = level->local};
    if (mask)
        run->fourth_mask(&level->lanes, level->f.P, c->mask);
    run->fourth_order(&level->lanes, &how, &level->f, level->f.w);
}

void ovr_fourth_evaluate(const ovr_hierarchy *grids, const ovr_correction *c,
                         double Cu, bool backward)
{
    evaluate(grids, c, Cu, backward, true);
}

/* Computes the correction from the present solution, and updates right-hand
 * sides, film and residual; the deformation is already that of P. */
static void correct(ovr_hierarchy *grids, const ovr_correction *c, bool mask)
{
    ovr_level *level = &grids->level[grids->finest];
    evaluate(grids, c, grids->op.speed, false, mask);
    memcpy(level->f.F, c->F, level->lanes.S * level->lanes.V * sizeof(double));
    grids->kernels->combine(length(level), 1, begin(level, c->gap_only), 1,
                            begin(level, c->gap), begin(level, level->f.gap));
    ovr_level_properties(grids, level);
    ovr_level_residual(grids, level);
}

/* A solution with corrections after each cycle. */
typedef struct correcting {
    const ovr_correction *correction;
    int done; /* number of corrections */
} correcting;

static bool correct_after(void *data, ovr_hierarchy *grids, ovr_level *level,
                          ovr_cycle_end end)
{
    correcting *c = data;
    (void)level;
    if (end == OVR_AFTER_CYCLE)
        correct(grids, c->correction, ++c->done < MASKS);
    return false; /* film and residual are up to date */
}

bool ovr_fourth_solve(ovr_hierarchy *grids, const ovr_correction *c,
                      const ovr_full *how, ovr_defect *d, int *cycles)
{
    ovr_level *level = &grids->level[grids->finest];
    correcting data = {.correction = c};
    const ovr_attached attached = {correct_after, &data, how->cycling.attached};
    ovr_full own = *how;
    own.cycling.attached = &attached;
    own.fixed = false;
    own.min_cycles = 2;
    own.trial = TRIES;
    memcpy(begin(level, c->gap_only), begin(level, level->f.gap),
           length(level) * sizeof(double));
    correct(grids, c, true);
    *d = ovr_full_cycles(grids, level, &own, cycles);
    return ovr_below(*d, how->tolerance(how->data, level, d->centre));
}
