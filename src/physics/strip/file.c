/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The group `strip` of a result file: pressure, film thickness and heights of
 * the features at all nodes (time, y, x), in single precision, one chunk for a
 * snapshot.  Snapshots are stored at the times of the fields (time, x).
 */
#include <stdlib.h>

#include "physics/companion.h"
#include "physics/strip/strip.h"

enum { TIME, ACROSS, ALONG, AXES, ARRAYS = 3 };

typedef struct strip_file {
    ovr_arena arena;
    ovr_writer *writer;
    ovr_group_axis axis[AXES];
    ovr_group_array array[ARRAYS];
    ovr_group_attribute attribute[2];
    ovr_group group;
    float *values;
    double rows; /* snapshots stored; part of checkpoints */
} strip_file;

static void release(void *own)
{
    strip_file *f = own;
    ovr_arena arena = f->arena;
    ovr_arena_release(&arena);
}

static void name_arrays(strip_file *f)
{
    static const ovr_group_array all[ARRAYS] = {
        {.name = "pressure",
         .long_name = "pressure",
         .kind = OVR_KIND_PRESSURE},
        {.name = "film_thickness",
         .long_name = "film thickness",
         .kind = OVR_KIND_HEIGHT},
        {.name = "roughness",
         .long_name = "height of the features of both surfaces",
         .kind = OVR_KIND_HEIGHT}};
    for (int k = 0; k < ARRAYS; k++) {
        f->array[k] = all[k];
        f->array[k].rank = AXES;
        for (int axis = 0; axis < AXES; axis++)
            f->array[k].along[axis] = axis;
    }
}

static ovr_status make(const ovr_accompanied_run *run, void **own,
                       ovr_error *err)
{
    const ovr_strip_solver *s = ovr_strip_of(run->sim);
    ovr_arena arena = ovr_arena_make(&run->arena->allocator);
    strip_file *f = ovr_arena_take(&arena, 1, sizeof *f, err);
    if (!f)
        return OVR_NO_MEMORY;
    f->values = ovr_arena_take(&arena, ARRAYS * s->n * s->lines,
                               sizeof *f->values, err);
    if (!f->values) {
        ovr_arena_release(&arena);
        return OVR_NO_MEMORY;
    }
    f->arena = arena;
    f->axis[TIME] = (ovr_group_axis){"time", "time", OVR_KIND_TIME, 0, NULL};
    f->axis[ACROSS] = (ovr_group_axis){"y", "position across rolling",
                                       OVR_KIND_LENGTH, s->lines, s->Y};
    f->axis[ALONG] = (ovr_group_axis){"x", "position along the contact",
                                      OVR_KIND_LENGTH, s->n, s->X};
    name_arrays(f);
    f->attribute[0] = (ovr_group_attribute){"width_over_b", NULL,
                                            s->form->width};
    f->attribute[1] = (ovr_group_attribute){"shown_over_b", NULL,
                                            s->Y[s->shown]};
    f->group = (ovr_group){"strip", AXES,     ARRAYS,      2,
                           f->axis, f->array, f->attribute};
    *own = f;
    return OVR_OK;
}

static ovr_status open_file(void *own, const ovr_accompanied_run *run,
                            ovr_error *err)
{
    strip_file *f = own;
    f->writer = run->writer;
    return ovr_writer_group(f->writer, &f->group, true, err);
}

static ovr_status observe(void *own, const ovr_simulation *sim, ovr_error *err)
{
    strip_file *f = own;
    const ovr_state *state = ovr_simulation_state(sim);
    const ovr_strip_solver *s = ovr_strip_of(sim);
    const ovr_strip_level *finest = ovr_strip_finest(s);
    if (!f->writer || !ovr_writer_stores(f->writer, state->step, state->T))
        return OVR_OK;
    size_t all = s->n * s->lines;
    for (size_t j = 0; j < s->lines; j++)
        for (size_t i = 0; i < s->n; i++) {
            size_t at = ovr_strip_row(&finest->grid, i) + j;
            f->values[j * s->n + i] = (float)finest->f.P[at];
            f->values[all + j * s->n + i] = (float)finest->f.H[at];
            f->values[2 * all + j * s->n + i] = (float)s->S[j * s->n + i];
        }
    ovr_status status = ovr_writer_append(f->writer, &f->group, (size_t)f->rows,
                                          state->T, f->values, all, err);
    f->rows++;
    return status;
}

static ovr_status visit(void *own, ovr_visit *call, void *context,
                        ovr_error *err)
{
    strip_file *f = own;
    return call(context, "strip rows", &f->rows, sizeof f->rows, err);
}

const ovr_companion ovr_strip_companion = {.make = make,
                                           .release = release,
                                           .open = open_file,
                                           .observe = observe,
                                           .visit = visit};
