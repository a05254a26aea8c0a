/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One level of a hierarchy: film, residual, load, and its fields in the order
 * of the nodes. */
#include <math.h>
#include <string.h>

#include "multigrid/content.h"
#include "multigrid/field.h"
#include "multigrid/flow.h"
#include "multigrid/hierarchy.h"
#include "multigrid/mixed_contact.h"

#define ROW(name, memory, ...) {#name, OVR_##memory, __VA_ARGS__},

const ovr_field_row ovr_field_rows[OVR_FIELD_COUNT] = {OVR_LEVEL_FIELDS(ROW)};

void ovr_level_properties(const ovr_hierarchy *grids, ovr_level *level)
{
    const ovr_kernels *run = grids->kernels;
    ovr_fields f = level->f;
    const double *gap = f.gap;
    if (grids->conserving)
        f.q = f.full;
    if (grids->touch.at) {
        ovr_asperity_split(grids, level);
        gap = ovr_asperity_gap(grids, level);
    }
    run->film(&grids->fluid, grids->H0, &level->lanes, gap, f.w, &f);
    ovr_flow_store(run, &grids->fluid, level->grid.D, &level->lanes, &f);
    if (grids->conserving)
        ovr_content_settle(grids, level);
}

void ovr_level_set_asperity_pressure(const ovr_hierarchy *grids,
                                     const ovr_level *level,
                                     const double *ordered)
{
    ovr_level_write(grids, level, ordered, level->asperity_P);
    if (!grids->touch.at) /* with asperity contact, `pressed` contains the total
                           * pressure */
        ovr_level_deform(grids, level, level->asperity_P, level->pressed);
}

/* Adds the deformation by the additional pressure to w, halos included. */
static void press(const ovr_hierarchy *grids, const ovr_level *level)
{
    size_t halo = OVR_HALO * level->lanes.V;
    size_t n = level->lanes.S * level->lanes.V + 2 * halo;
    double *w = level->f.w - halo;
    grids->kernels->combine(n, 1, w, 1, level->pressed - halo, w);
}

void ovr_level_film(const ovr_hierarchy *grids, ovr_level *level)
{
    if (grids->touch.at) {
        ovr_asperity_deform(grids, level);
    } else {
        ovr_level_deform(grids, level, level->f.P, level->f.w);
        if (level->asperity_P)
            press(grids, level);
    }
    ovr_level_properties(grids, level);
}

void ovr_level_residual(const ovr_hierarchy *grids, ovr_level *level)
{
    if (grids->conserving) {
        grids->kernels->content_residual(&level->lanes, &level->weights,
                                         &level->f);
        return;
    }
    grids->kernels->residual(&level->lanes, &level->weights, &level->f);
}

void ovr_level_refresh(const ovr_hierarchy *grids, ovr_level *level)
{
    ovr_level_film(grids, level);
    ovr_level_residual(grids, level);
}

double ovr_level_imbalance(const ovr_hierarchy *grids, const ovr_level *level)
{
    const ovr_kernels *run = grids->kernels;
    double sum = grids->conserving
                     ? run->content_imbalance(&level->lanes, &level->f)
                     : run->imbalance(&level->lanes, &level->weights,
                                      &level->f);
    if (grids->touch.at)
        sum += ovr_asperity_defect(grids, level) / level->grid.D;
    return sum * level->grid.D / fabs(ovr_level_centre(level, level->f.H));
}

double ovr_level_load(const ovr_hierarchy *grids, const ovr_level *level)
{
    double sum = grids->kernels->sum(&level->lanes, level->f.P);
    if (level->asperity_P)
        sum += grids->kernels->sum(&level->lanes, level->asperity_P);
    return level->grid.D * sum;
}

void ovr_level_clear(const ovr_level *level, double *values)
{
    memset(values, 0, level->lanes.S * level->lanes.V * sizeof *values);
}

/* The index is limited because X = 0 can be next to an end of the domain. */
double ovr_level_centre(const ovr_level *level, const double *values)
{
    double at = -level->grid.X_a / level->grid.D, s, v[4];
    size_t i = (size_t)at, last = level->grid.n - 3;
    i = i < 1 ? 1 : i > last ? last : i;
    for (size_t k = 0; k < 4; k++)
        v[k] = values[ovr_lanes_place(&level->lanes, i + k - 1)];
    s = at - (double)i;
    return -s * (s - 1) * (s - 2) / 6 * v[0] +
           (s + 1) * (s - 1) * (s - 2) / 2 * v[1] -
           (s + 1) * s * (s - 2) / 2 * v[2] + (s + 1) * s * (s - 1) / 6 * v[3];
}

bool ovr_hierarchy_stops(ovr_hierarchy *grids)
{
    ovr_stopping *s = &grids->stopping;
    if (!s->now && s->asked)
        s->now = s->asked(s->data);
    if (!s->now && s->limit > 0 && s->work > s->limit)
        s->now = s->spent = true;
    return s->now;
}

void ovr_hierarchy_allow(ovr_hierarchy *grids, double limit)
{
    ovr_stopping *s = &grids->stopping;
    s->work = 0;
    s->limit = limit;
    if (s->spent)
        s->now = s->spent = false;
}

bool ovr_hierarchy_spent(ovr_hierarchy *grids)
{
    bool spent = grids->stopping.spent;
    if (spent)
        ovr_hierarchy_allow(grids, 0);
    return spent;
}

double ovr_hierarchy_narrow(ovr_hierarchy *grids, double share)
{
    ovr_stopping *s = &grids->stopping;
    double limit = s->limit;
    if (limit > 0)
        s->limit = fmin(limit, s->work + share * limit);
    return limit;
}

bool ovr_hierarchy_widen(ovr_hierarchy *grids, double limit)
{
    ovr_stopping *s = &grids->stopping;
    bool reached = s->spent && s->work <= limit;
    s->limit = limit;
    if (reached)
        s->now = s->spent = false;
    return reached;
}
