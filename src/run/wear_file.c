/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The file of a run keeps this of surfaces that wear: both profiles before and
 * after, in the group `wear`, and beside it as OUT-profile-1.csv and the like,
 * for `overroll profile`. */
#include <stdio.h>
#include <string.h>

#include "case/setup.h"
#include "results/results.h"
#include "run/internal.h"
#include "simulation/wear.h"
#include "surface/profile.h"

typedef struct worn {
    ovr_arena arena;
    const ovr_setup *setup;
    const char *output;
    ovr_writer *writer;
} worn;

static bool wears(const ovr_setup *setup)
{
    return ovr_setup_physics(setup) & OVR_PHYSICS_WEAR;
}

static ovr_status make(const ovr_setup *setup, const ovr_state *state,
                       const char *output, const ovr_allocator *allocator,
                       void **own, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    worn *w;
    (void)state;
    if (!wears(setup))
        return OVR_OK;
    w = ovr_arena_take(&arena, 1, sizeof *w, err);
    if (!w)
        return OVR_NO_MEMORY;
    w->setup = setup;
    w->output = output;
    w->arena = arena;
    *own = w;
    return OVR_OK;
}

static void release(void *own)
{
    worn *w = own;
    if (!w)
        return;
    ovr_arena arena = w->arena;
    ovr_arena_release(&arena);
}

static ovr_status open_file(void *own, ovr_writer *writer, const char *path,
                            ovr_error *err)
{
    worn *w = own;
    (void)path;
    (void)err;
    if (w)
        w->writer = writer;
    return OVR_OK;
}

/* x of the period's n places, in b. */
static double *places(worn *w, const ovr_rough_pair *pair, ovr_error *err)
{
    double *x = ovr_arena_take(&w->arena, pair->n, sizeof *x, err);
    for (size_t i = 0; x && i < pair->n; i++)
        x[i] = pair->length * (double)i / (double)pair->n;
    return x;
}

/* Saves in metres, beside OUT.h5 as OUT-profile-1-before.csv. */
static ovr_status save(const worn *w, const ovr_rough_pair *pair,
                       const double *x, const double *z, int surface,
                       const char *when, ovr_error *err)
{
    const ovr_contact *c = w->setup->contact;
    const char *dot = strrchr(w->output, '.');
    char path[4500];
    ovr_profile *p = ovr_profile_create(pair->n, x, z, false,
                                        &w->arena.allocator, err);
    ovr_status status = OVR_NO_MEMORY;
    if (!p)
        return status;
    for (size_t i = 0; i < pair->n; i++) {
        p->x[i] *= c->b;
        p->z[i] *= c->height;
    }
    if (!dot || strchr(dot, '/'))
        dot = w->output + strlen(w->output);
    snprintf(path, sizeof path, "%.*s-profile-%d-%s.csv",
             (int)(dot - w->output), w->output, surface, when);
    status = ovr_profile_save(p, path, err);
    ovr_profile_free(p);
    return status;
}

enum { PROFILES = 4 };
static const char *const names[PROFILES] = {
    "profile_1_before", "profile_1_after", "profile_2_before",
    "profile_2_after"};
static const char *const meanings[PROFILES] = {
    "surface 1 before it wore", "surface 1 as it is worn",
    "surface 2 before it wore", "surface 2 as it is worn"};

static ovr_status put_group(worn *w, const ovr_wear *wear, const double *x,
                            ovr_error *err)
{
    ovr_group_array array[PROFILES];
    const ovr_group_axis along = {"profile_x", "place on the profiles",
                                  OVR_KIND_LENGTH, wear->pair.n, x};
    size_t count = 0;
    for (int k = 0; k < PROFILES; k++) {
        const double *z = k % 2 ? wear->now.z[k / 2]
                                : wear->given->pair.z[k / 2];
        if (z)
            array[count++] = (ovr_group_array){.name = names[k],
                                               .long_name = meanings[k],
                                               .kind = OVR_KIND_HEIGHT,
                                               .rank = 1,
                                               .along = {0},
                                               .doubles = z};
    }
    const ovr_group group = {"wear", 1, count, 0, &along, array, NULL};
    return ovr_writer_group(w->writer, &group, true, err);
}

static ovr_status finish(void *own, const ovr_simulation *sim,
                         ovr_run_info *info, ovr_error *err)
{
    worn *w = own;
    const ovr_wear *wear = w ? ovr_wear_of(sim) : NULL;
    (void)info;
    if (!wear || !w->output)
        return OVR_OK;
    double *x = places(w, &wear->pair, err);
    ovr_status status = x ? OVR_OK : OVR_NO_MEMORY;
    if (!status && w->writer)
        status = put_group(w, wear, x, err);
    for (int k = 0; !status && k < 2; k++) {
        if (!wear->now.z[k])
            continue;
        status = save(w, &wear->pair, x, wear->given->pair.z[k], k + 1,
                      "before", err);
        if (!status)
            status = save(w, &wear->pair, x, wear->now.z[k], k + 1, "after",
                          err);
    }
    return status;
}

const ovr_companion ovr_wear_companion = {
    .make = make, .release = release, .open = open_file, .finish = finish};
