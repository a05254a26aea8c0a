/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/wear.h"

#include <math.h>
#include <string.h>

static const double LARGEST_JUMP = 0.02; /* of Rq */

ovr_status ovr_wear_take(ovr_wear *wear, const ovr_boundary_form *given,
                         const ovr_contact *contact, ovr_arena *arena,
                         ovr_error *err)
{
    const double ratio[2] = {contact->u1_ratio, contact->u2_ratio};
    double V = fabs(ratio[0] - ratio[1]);
    size_t n = given->pair.n;
    wear->given = given;
    wear->pair = (ovr_rough_pair){
        .n = n, .length = given->pair.length, .modulus = given->pair.modulus};
    for (int k = 0; k < 2; k++) {
        wear->c[k] = given->wear[k] > 0 && V > 0
                         ? given->wear[k] * contact->ph / contact->kappa * V /
                               fabs(ratio[k])
                         : 0;
        if (!given->pair.z[k])
            continue;
        wear->now.z[k] = ovr_arena_take(arena, n, sizeof(double), err);
        wear->before.z[k] = ovr_arena_take(arena, n, sizeof(double), err);
        if (!wear->now.z[k] || !wear->before.z[k])
            return OVR_NO_MEMORY;
        wear->pair.z[k] = wear->now.z[k];
    }
    if (ovr_rough_pair_reserve(&wear->pair, &wear->bears.table, arena, err))
        return OVR_NO_MEMORY;
    wear->w = ovr_arena_take(arena, wear->pair.points, sizeof *wear->w, err);
    return wear->w ? OVR_OK : OVR_NO_MEMORY;
}

static void copy(const ovr_wear *wear, ovr_worn *to, const ovr_worn *from)
{
    to->passes = from->passes;
    for (int k = 0; k < 2; k++) {
        to->depth[k] = from->depth[k];
        if (to->z[k])
            memcpy(to->z[k], from->z[k], wear->pair.n * sizeof *to->z[k]);
    }
}

/* The table keeps its space; without a law for the new heights the last one
 * stays. */
static void find_law(ovr_wear *wear)
{
    ovr_arena none = ovr_arena_make(NULL); /* there is space */
    ovr_error err = {0};
    if (ovr_rough_pair_law(&wear->pair, &wear->bears.table, &none, &err))
        wear->lost = true;
    ovr_arena_release(&none);
}

void ovr_wear_begin(ovr_wear *wear)
{
    const ovr_worn fresh = {
        .z = {wear->given->pair.z[0], wear->given->pair.z[1]}};
    copy(wear, &wear->before, &fresh);
    copy(wear, &wear->now, &fresh);
    wear->bears.layer = wear->given->bears.layer;
    wear->bears.layer_decay = wear->given->bears.layer_decay;
    wear->share = wear->change = NAN;
    wear->lost = false;
    memset(wear->w, 0, wear->pair.points * sizeof *wear->w);
    find_law(wear);
}

void ovr_wear_see(ovr_wear *wear, size_t n, const double *A,
                  const double *weights, double share)
{
    memset(wear->w, 0, wear->pair.points * sizeof *wear->w);
    for (size_t i = 0; i < n; i++)
        if (A[i] > 0)
            ovr_rough_pair_weigh(&wear->pair, A[i], weights[i], wear->w);
    wear->change = fabs(share / wear->share - 1);
    wear->share = share;
}

/* int A dX of the film reached last. */
static double borne(const ovr_wear *wear)
{
    double sum = 0;
    for (size_t j = 0; j < wear->pair.points; j++)
        sum += wear->w[j] * wear->pair.p[j];
    return sum;
}

static double passes_of(const ovr_wear *wear)
{
    double left = wear->given->passes - wear->before.passes;
    double deepest = ovr_rough_pair_deepest(&wear->pair, wear->c, wear->w);
    double maximum = LARGEST_JUMP * wear->given->pair.Rq;
    double jump = wear->given->jump > 0 ? wear->given->jump
                  : deepest > 0         ? maximum / deepest
                                        : INFINITY;
    return fmin(left, jump);
}

/* The weights are those of the pressures before: the law goes back to them
 * first. */
void ovr_wear_step(ovr_wear *wear, double part)
{
    ovr_wear_back(wear);
    double N = part * passes_of(wear), all = borne(wear);
    double c[2] = {N * wear->c[0], N * wear->c[1]};
    ovr_rough_pair_wear(&wear->pair, c, wear->w);
    wear->now.passes += N;
    for (int k = 0; k < 2; k++)
        wear->now.depth[k] += wear->now.z[k] ? c[k] * all : 0;
    find_law(wear);
}

void ovr_wear_taken(ovr_wear *wear)
{
    copy(wear, &wear->before, &wear->now);
}

void ovr_wear_back(ovr_wear *wear)
{
    if (wear->now.passes == wear->before.passes)
        return;
    copy(wear, &wear->now, &wear->before);
    find_law(wear);
}

bool ovr_wear_over(const ovr_wear *wear)
{
    const double rounding = 1e-9;
    bool settled = wear->before.passes > 0 && wear->given->settled > 0 &&
                   wear->change < wear->given->settled;
    return settled ||
           wear->before.passes >= wear->given->passes * (1 - rounding);
}

void ovr_wear_visit(ovr_wear *wear, ovr_pieces *state)
{
    size_t bytes = wear->pair.n * sizeof(double);
    OVR_SHOW(state, "worn_passes", wear->before.passes);
    OVR_SHOW(state, "worn_depth", wear->before.depth);
    OVR_SHOW(state, "worn_share", wear->share);
    OVR_SHOW(state, "worn_change", wear->change);
    ovr_show(state, "worn_w", wear->w, wear->pair.points * sizeof *wear->w);
    if (wear->before.z[0])
        ovr_show(state, "worn_1", wear->before.z[0], bytes);
    if (wear->before.z[1])
        ovr_show(state, "worn_2", wear->before.z[1], bytes);
}

ovr_core ovr_wear_core(const ovr_wear *wear, int surface, bool given)
{
    const double *z = given ? wear->given->pair.z[surface]
                            : wear->now.z[surface];
    ovr_height *heights = (ovr_height *)wear->pair.workspace; /* between laws */
    if (!z)
        return (ovr_core){NAN, NAN, NAN, NAN, NAN};
    for (size_t i = 0; i < wear->pair.n; i++)
        heights[i] = (ovr_height){z[i], 1};
    return ovr_material_ratio(wear->pair.n, heights);
}
