/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mixed lubrication beside its numbers: a warning of weak asperity laws, and of
 * surfaces that wear both profiles before and after, in the group `wear` of the
 * result file and as OUT-profile-1.csv and the like, for `overroll profile`. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "case/setup.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/review.h"
#include "simulation/boundary.h"
#include "simulation/wear.h"
#include "surface/profile.h"

/* x of the period's n places, in b. */
static double *places(ovr_run *run, const ovr_rough_pair *pair, ovr_error *err)
{
    double *x = ovr_arena_take(&run->arena, pair->n, sizeof *x, err);
    for (size_t i = 0; x && i < pair->n; i++)
        x[i] = pair->length * (double)i / (double)pair->n;
    return x;
}

enum { PROFILES = 4 };
static const char *const names[PROFILES] = {
    "profile_1_before", "profile_1_after", "profile_2_before",
    "profile_2_after"};
static const char *const meanings[PROFILES] = {
    "surface 1 before it wore", "surface 1 as it is worn",
    "surface 2 before it wore", "surface 2 as it is worn"};

/* The heights of profile k; NULL: that surface is smooth. */
static const double *heights_of(const ovr_wear *wear, int k)
{
    return k % 2 ? wear->now.z[k / 2] : wear->given->pair.z[k / 2];
}

/* OUT-profile-1-before.csv of OUT.h5 */
static void path_of(const ovr_run *run, int k, char *path, size_t capacity)
{
    const char *output = run->info.output, *dot = strrchr(output, '.');
    if (!dot || strchr(dot, '/'))
        dot = output + strlen(output);
    snprintf(path, capacity, "%.*s-profile-%d-%s.csv", (int)(dot - output),
             output, k / 2 + 1, k % 2 ? "after" : "before");
}

/* Before the solve: profiles that exist are replaced with --force only. */
static ovr_status make(const ovr_run *run, void **own, ovr_error *err)
{
    const ovr_wear *wear = ovr_wear_of(run->sim);
    *own = NULL;
    for (int k = 0; k < PROFILES && wear && run->info.output; k++) {
        char path[4500];
        path_of(run, k, path, sizeof path);
        if (!run->how.force && !run->restart && wear->given->pair.z[k / 2] &&
            access(path, F_OK) == 0)
            return ovr_fail(err, OVR_BAD_INPUT,
                            "%s: exists already; --force replaces it", path);
    }
    return OVR_OK;
}

/* Saves in metres. */
static ovr_status save(const ovr_run *run, const ovr_wear *wear,
                       const double *x, int k, ovr_error *err)
{
    const ovr_contact *c = run->setup->contact;
    char path[4500];
    ovr_profile *p = ovr_profile_create(wear->pair.n, x, heights_of(wear, k),
                                        false, &run->arena.allocator, err);
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

static ovr_status put_group(ovr_writer *writer, const ovr_wear *wear,
                            const double *x, ovr_error *err)
{
    ovr_group_array array[PROFILES];
    const ovr_group_axis along = {"profile_x", "place on the profiles",
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

static ovr_status finish(void *own, ovr_run *run, ovr_error *err)
{
    const ovr_wear *wear = ovr_wear_of(run->sim);
    (void)own;
    if (!wear || !run->info.output)
        return OVR_OK;
    double *x = places(run, &wear->pair, err);
    ovr_status status = x ? OVR_OK : OVR_NO_MEMORY;
    if (!status && run->writer)
        status = put_group(run->writer, wear, x, err);
    for (int k = 0; !status && k < PROFILES; k++)
        if (wear->now.z[k / 2])
            status = save(run, wear, x, k, err);
    return status;
}

static void foresee(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const ovr_boundary_form *f = ovr_setup_form(setup, "boundary");
    if (!f || !f->law || !ovr_boundary_is_weak(f, 1))
        return;
    ovr_warn(say, data,
             "contact share and friction of thin films will be wrong: the "
             "[boundary] law bears %.3g ph at no film, at most %.2g of the "
             "load; films below which it bears over half of that are refused. "
             "Use law = exponential with Rq and slope, or constants that bear "
             "ph at no film",
             f->at_no_film, f->share_at_no_film);
}

const ovr_companion ovr_wear_companion = {
    .foresee = foresee, .make = make, .finish = finish};
