/* SPDX-License-Identifier: GPL-3.0-or-later */

#include "physics/mixed/wear.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "case/setup.h"
#include "physics/companion.h"
#include "physics/mixed/mixed.h"
#include "results/results.h"
#include "surface/profile.h"

/* --------------------------------------------------------------- Wear depth */

static const double LARGEST_JUMP = 0.02; /* relative to Rq */

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
        wear->pair.z[k] = wear->now.z[k];
    }
    if (ovr_rough_pair_reserve(&wear->pair, &wear->bears.table, arena, err) ||
        ovr_asperity_table_take(&wear->spare, wear->pair.points, arena, err))
        return OVR_NO_MEMORY;
    wear->w = ovr_arena_take(arena, wear->pair.points, sizeof *wear->w, err);
    return ovr_arena_status(arena);
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

/* Computes the contact model for the new heights in the memory of the spare
 * table. If there is no model, the last one is kept. */
static void find_law(ovr_wear *wear)
{
    ovr_arena none = ovr_arena_make(NULL); /* memory is already allocated */
    ovr_error err = {0};
    const ovr_asperity_table last = wear->bears.table;
    if (ovr_rough_pair_law(&wear->pair, &wear->spare, &none, &err)) {
        wear->lost = true;
    } else {
        wear->bears.table = wear->spare;
        wear->spare = last;
    }
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

/* Integral of A over the last film. */
static double asperity_load(const ovr_wear *wear)
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

/* The weights belong to the pressures of the last film, so the model of that
 * film is restored first. */
void ovr_wear_step(ovr_wear *wear, double part)
{
    ovr_wear_back(wear);
    double N = part * passes_of(wear), all = asperity_load(wear);
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
    /* unused between computations of the model */
    ovr_height *heights = (ovr_height *)wear->pair.workspace;
    if (!z)
        return (ovr_core){NAN, NAN, NAN, NAN, NAN};
    for (size_t i = 0; i < wear->pair.n; i++)
        heights[i] = (ovr_height){z[i], 1};
    return ovr_material_ratio(wear->pair.n, heights);
}

/* -------------------------------------------------------- Profiles of a run */

/* Warning about weak asperity contact models, and profiles of worn surfaces
 * before and after: in the group `wear` of the result file and as
 * OUT-profile-1.csv etc., for `overroll profile`. */

/* Coordinates x of the period's n points, in b. */
static double *places(const ovr_accompanied_run *run,
                      const ovr_rough_pair *pair, ovr_error *err)
{
    double *x = ovr_arena_take(run->arena, pair->n, sizeof *x, err);
    for (size_t i = 0; x && i < pair->n; i++)
        x[i] = pair->length * (double)i / (double)pair->n;
    return x;
}

enum { PROFILES = 4 };
static const char *const names[PROFILES] = {
    "profile_1_before", "profile_1_after", "profile_2_before",
    "profile_2_after"};
static const char *const meanings[PROFILES] = {
    "profile of surface 1 before wear", "surface 1 as it is worn",
    "profile of surface 2 before wear", "surface 2 as it is worn"};

/* Heights of profile k; NULL for a smooth surface. */
static const double *heights_of(const ovr_wear *wear, int k)
{
    return k % 2 ? wear->now.z[k / 2] : wear->given->pair.z[k / 2];
}

/* Path OUT-profile-1-before.csv for OUT.h5. */
static void path_of(const ovr_accompanied_run *run, int k, char *path,
                    size_t capacity)
{
    const char *output = run->output, *dot = strrchr(output, '.');
    if (!dot || strchr(dot, '/'))
        dot = output + strlen(output);
    snprintf(path, capacity, "%.*s-profile-%d-%s.csv", (int)(dot - output),
             output, k / 2 + 1, k % 2 ? "after" : "before");
}

/* Before the solve: existing profile files are replaced only with --force. */
static ovr_status make(const ovr_accompanied_run *run, void **own,
                       ovr_error *err)
{
    const ovr_wear *wear = ovr_wear_of(run->sim);
    *own = NULL;
    for (int k = 0; k < PROFILES && wear && run->output; k++) {
        char path[4500];
        path_of(run, k, path, sizeof path);
        if (!run->force && !run->resumed && wear->given->pair.z[k / 2] &&
            access(path, F_OK) == 0)
            return ovr_fail(err, OVR_BAD_INPUT,
                            "%s: exists already; --force replaces it", path);
    }
    return OVR_OK;
}

/* Saves in metres. */
static ovr_status save(const ovr_accompanied_run *run, const ovr_wear *wear,
                       const double *x, int k, ovr_error *err)
{
    const ovr_contact *c = run->setup->contact;
    char path[4500];
    ovr_profile *p = ovr_profile_create(wear->pair.n, x, heights_of(wear, k),
                                        false, &run->arena->allocator, err);
    if (!p)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < wear->pair.n; i++) {
        p->x[i] *= c->b;
        p->z[i] *= c->height;
    }
    path_of(run, k, path, sizeof path);
    ovr_status status = ovr_profile_save(p, path, err);
    ovr_profile_free(p);
    return status;
}

static ovr_status write_group(ovr_writer *writer, const ovr_wear *wear,
                              const double *x, ovr_error *err)
{
    ovr_group_array array[PROFILES];
    const ovr_group_axis along = {"profile_x", "position along the profiles",
                                  OVR_KIND_LENGTH, wear->pair.n, x};
    size_t count = 0;
    for (int k = 0; k < PROFILES; k++) {
        const double *z = heights_of(wear, k);
        if (z)
            array[count++] = (ovr_group_array){.name = names[k],
                                               .long_name = meanings[k],
                                               .kind = OVR_KIND_HEIGHT,
                                               .rank = 1,
                                               .along = {0},
                                               .doubles = z};
    }
    const ovr_group group = {"wear", 1, count, 0, &along, array, NULL};
    return ovr_writer_group(writer, &group, true, err);
}

static ovr_status finish(void *own, const ovr_accompanied_run *run,
                         ovr_error *err)
{
    const ovr_wear *wear = ovr_wear_of(run->sim);
    (void)own;
    if (!wear || !run->output)
        return OVR_OK;
    double *x = places(run, &wear->pair, err);
    ovr_status status = x ? OVR_OK : OVR_NO_MEMORY;
    if (!status && run->writer)
        status = write_group(run->writer, wear, x, err);
    for (int k = 0; !status && k < PROFILES; k++)
        if (wear->now.z[k / 2])
            status = save(run, wear, x, k, err);
    return status;
}

static void review_before(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const ovr_boundary_form *f = ovr_setup_form(setup, "boundary");
    if (!f || !f->law || !ovr_boundary_is_weak(f, 1))
        return;
    ovr_warn(
        say, data,
        "asperity load share and friction of thin films will be wrong: the "
        "[boundary] law carries %.3g p_h at zero film thickness, at "
        "most %.2g of the load; films at which it carries more than "
        "half of that are rejected. Set boundary.law = exponential with Rq and "
        "slope, or constants that carry p_h at zero film thickness",
        f->at_no_film, f->share_at_no_film);
}

const ovr_companion ovr_wear_companion = {
    .review_before = review_before, .make = make, .finish = finish};
