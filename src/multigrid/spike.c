/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/spike.h"

#include <math.h>

/* The first EXITS patches extend across the film rupture. They have space for
 * EXIT_LENGTH downstream of the spike and BEYOND further mesh sizes. */
#define EXIT_LENGTH 0.8
enum { EXITS = 3, BEYOND = 12 };

size_t ovr_spike_max(int k, double half, const ovr_grid *base)
{
    double meshes = 2 * half + 3 * OVR_PATCH_UNIT;
    if (k <= EXITS)
        meshes += EXITS * BEYOND + EXIT_LENGTH / ldexp(base->D, 1 - k);
    meshes = fmin(meshes, (double)(base->n - 1) / 2);
    return 2 * ((size_t)meshes / OVR_PATCH_UNIT) * OVR_PATCH_UNIT + 1;
}

typedef struct spike {
    double P, X;
} spike;

/* Finds the spike in the last part. */
static spike find(const ovr_patch *part)
{
    const double *P = part->P, *X = part->level->grid.X;
    size_t top = 0, bend = part->from;
    double sharpest = 0;
    for (size_t i = part->from; i <= part->to; i++) {
        double second = P[i - 1] - 2 * P[i] + P[i + 1];
        if (X[i] < 0.3 || !(P[i] > 0))
            continue;
        if (P[i] > P[i - 1] && P[i] >= P[i + 1] && (!top || P[i] > P[top]))
            top = i;
        if (second < sharpest) {
            sharpest = second;
            bend = i;
        }
    }
    return top ? (spike){P[top], X[top]} : (spike){NAN, X[bend]};
}

/* First cavitated node downstream of the film. */
static double rupture(const ovr_patch *base)
{
    size_t i = base->to;
    while (i > base->from && !(base->P[i] > 0))
        i--;
    return base->level->grid.X[i + 1];
}

/* Places a patch around X; the first patches extend across the film rupture. A
 * window without intervals means that there is no space. */
static ovr_window lay(const ovr_composite *c, const ovr_spike_search *how,
                      double X)
{
    const ovr_patch *parent = &c->part[c->patches];
    const ovr_grid *grid = &parent->level->grid;
    int k = c->patches + 1;
    double minimum = OVR_PATCH_MARGIN + (parent->opens ? OVR_PATCH_EDGE : 0);
    double maximum = (double)grid->n - 1 - OVR_PATCH_MARGIN -
                     (parent->closes ? OVR_PATCH_EDGE : 0);
    double at = (X - grid->X_a) / grid->D, left = floor(at) - how->half;
    double right = ceil(at) + how->half, exit = rupture(&c->part[0]);
    if (k <= EXITS)
        right = fmax(right, ceil((exit - grid->X_a) / grid->D) +
                                BEYOND * (EXITS + 1 - k));
    left = fmax(left - OVR_PATCH_EDGE / 2., minimum);
    right = fmin(right + OVR_PATCH_EDGE / 2., maximum);
    double units = ceil((right - left) / OVR_PATCH_UNIT);
    double margin = floor((maximum - left) / OVR_PATCH_UNIT);
    double taken = (double)ovr_spike_max(k, how->half, &c->part[0].level->grid);
    units = fmin(fmin(units, margin),
                 floor((taken - 1) / (2 * OVR_PATCH_UNIT)));
    if (!(units * OVR_PATCH_UNIT >= OVR_PATCH_MIN))
        return (ovr_window){0, 0};
    return (ovr_window){(size_t)left, (size_t)units * OVR_PATCH_UNIT};
}

static void rigid(const ovr_spike_search *how, ovr_patch *part)
{
    const ovr_grid *grid = &part->level->grid;
    how->rigid(how->data, grid->n, grid->X, part->rigid);
}

static ovr_status add(ovr_composite *c, const ovr_spike_search *how,
                      ovr_window w, ovr_error *err)
{
    if (ovr_composite_add(c, w, err))
        return OVR_NO_MEMORY;
    ovr_patch *patch = &c->part[c->patches];
    rigid(how, patch);
    if (how->fourth && c->patches == 1) {
        rigid(how, &c->part[0]);
        ovr_base_fourth(c->grids, &c->part[0], patch);
    }
    if (how->fourth)
        ovr_patch_fourth(patch, patch - 1);
    ovr_composite_start(c);
    return OVR_OK;
}

/* True if another level is needed after the last one changed the spike from
 * `before`; *small counts how often it changed little. */
static bool needs_level(const ovr_composite *c, const ovr_spike_search *how,
                        spike before, ovr_spike_found *found, int *small)
{
    const ovr_patch *last = &c->part[c->patches];
    double change = fabs(found->P - before.P) / fabs(found->P);
    found->change = c->patches ? change : NAN;
    *small = c->patches && !(change > how->change) ? *small + 1 : 0;
    if (last->level->number >= how->level || c->patches + 1 >= OVR_LEVELS)
        return false;
    return !(how->change > 0) || *small < 2;
}

/* Performs cycles until the tolerance is reached. */
static void finish(ovr_composite *c, const ovr_spike_search *how,
                   ovr_spike_found *found, int *cycles)
{
    found->defect = ovr_composite_defect(c);
    for (int k = 0; k < how->max_cycles; k++) {
        if (ovr_below(found->defect, how->tolerance) ||
            !(found->defect.imbalance < 1e6))
            break;
        ovr_composite_cycle(c, &how->cycling);
        found->defect = ovr_composite_defect(c);
        ++*cycles;
    }
}

ovr_status ovr_spike_solve(ovr_composite *c, const ovr_spike_search *how,
                           ovr_spike_found *found, int *cycles, ovr_error *err)
{
    spike now = find(&c->part[0]), before = {NAN, 0};
    int small = 0;
    *found = (ovr_spike_found){.level = c->part[0].level->number,
                               .P = now.P,
                               .X = now.X,
                               .change = NAN};
    while (needs_level(c, how, before, found, &small)) {
        ovr_window w = lay(c, how, now.X);
        if (!w.meshes)
            break;
        if (add(c, how, w, err))
            return OVR_NO_MEMORY;
        ovr_composite_cycle(c, &how->cycling);
        ++*cycles;
        before = now;
        now = find(&c->part[c->patches]);
        found->level = c->part[c->patches].level->number;
        found->P = now.P;
        found->X = now.X;
    }
    finish(c, how, found, cycles);
    found->D = c->part[c->patches].level->grid.D;
    now = find(&c->part[c->patches]);
    found->P = now.P;
    found->X = now.X;
    return OVR_OK;
}
