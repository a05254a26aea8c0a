/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Creates, continues and closes a result file.
 */
#include "results/writer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "results/h5.h"
#include "results/results.h"

ovr_write_options ovr_write_options_default(void)
{
    ovr_write_options o = {0};
    o.fields = OVR_FIELDS_DEFAULT;
    o.x_from = o.x_to = o.end = NAN;
    o.stride = 1;
    o.deflate = 1;
    o.flush_interval = 0.5;
    o.checkpoint_interval = 30;
    return o;
}

long ovr_write_every(const ovr_write_options *o, double end, double dT,
                     size_t nodes)
{
    if (!o)
        return 0;
    size_t stored = nodes / (o->stride ? o->stride : 1) + 1;
    bool strip = o->lines > 1;
    double row = (double)stored * (double)ovr_layout_fields(o->fields, NULL) *
                 (o->single ? 4 : 8) * (strip ? (double)o->lines : 1);
    double maximum = fmin(250,
                          strip ? fmax(25, 256e6 / row) : fmax(50, 64e6 / row));
    double every = ceil(end / dT / maximum);
    return every >= 1 && every < 1e9 ? (long)every : 1;
}

/* Returns the length of NAME if the name is NAME.unit, otherwise 0. */
static size_t length_before_unit(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot && strcmp(dot, ".unit") == 0 ? (size_t)(dot - name) : 0;
}

/* True if value k has the name of an earlier value, or the name of the unit of
 * any value. */
static bool is_name_taken(const ovr_write_options *o, size_t k)
{
    const char *name = o->values[k].name;
    size_t length = length_before_unit(name);
    bool taken = false;
    for (size_t i = 0; i < k && !taken; i++)
        taken = o->values[i].name[0] == name[0] &&
                strcmp(o->values[i].name, name) == 0;
    for (size_t i = 0; length && i < o->value_count && !taken; i++)
        taken = o->values[i].unit && strlen(o->values[i].name) == length &&
                memcmp(o->values[i].name, name, length) == 0;
    return taken;
}

/* Checks the names: they become attributes of the group `case`, whose attribute
 * `text` is the case itself. */
static ovr_status check_names(const ovr_write_options *o, ovr_error *err)
{
    for (size_t k = 0; k < o->value_count; k++)
        if (strcmp(o->values[k].name, "text") == 0 || is_name_taken(o, k))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "%s: the name '%s' of a case value is already "
                            "used",
                            o->path, o->values[k].name);
    return OVR_OK;
}

static ovr_status check_options(const ovr_write_options *o, ovr_error *err)
{
    if (!o->path || !o->path[0])
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the path of the result file is missing");
    if (o->deflate < 0 || o->deflate > 9)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: the deflate level %d must be 0 to 9", o->path,
                        o->deflate);
    if (o->stride < 1)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: the stride must be 1 or more",
                        o->path);
    if (ovr_layout_fields(o->fields, NULL) == 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: at least one field must be stored", o->path);
    return check_names(o, err);
}

/* Chooses the stored nodes: every stride-th node of the window. */
static ovr_status choose_nodes(ovr_writer *w, const double *X, ovr_error *err)
{
    const ovr_write_options *o = &w->options;
    size_t last = w->n;
    while (w->first < w->n && X[w->first] < o->x_from)
        w->first++;
    while (last > w->first && X[last - 1] > o->x_to)
        last--;
    w->nodes = (last - w->first + o->stride - 1) / o->stride;
    if (w->nodes == 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: no node lies in the window X = %g to %g; the "
                        "nodes of the domain X = %g to %g are %.4g apart",
                        o->path, isnan(o->x_from) ? X[0] : o->x_from,
                        isnan(o->x_to) ? X[w->n - 1] : o->x_to, X[0],
                        X[w->n - 1], X[1] - X[0]);
    return OVR_OK;
}

/* Returns the positions of the lines in the unit of the file; NULL for a line
 * contact. */
static double *line_positions(ovr_writer *w, ovr_error *err)
{
    double factor = ovr_factor(&w->scales, OVR_KIND_LENGTH);
    double *y = ovr_arena_take(&w->arena, w->lines, sizeof *y, err);
    for (size_t j = 0; y && j < w->lines; j++)
        y[j] = factor * w->options.Y[j];
    return y;
}

static double *stored_positions(ovr_writer *w, const double *X, ovr_error *err)
{
    double factor = ovr_factor(&w->scales, OVR_KIND_LENGTH);
    double *x = ovr_arena_take(&w->arena, w->nodes, sizeof *x, err);
    for (size_t k = 0; x && k < w->nodes; k++)
        x[k] = factor * X[w->first + k * w->options.stride];
    return x;
}

/* Computes weights of the trapezoidal rule if refinement makes the node spacing
 * nonuniform; otherwise NULL. */
static ovr_status set_weights(const ovr_writer *w, ovr_arena *arena,
                              ovr_file_plan *plan, ovr_error *err)
{
    if (!(w->options.physics & OVR_PHYSICS_REFINED))
        return OVR_OK;
    double *weights = ovr_arena_take(arena, w->nodes, sizeof *weights, err);
    for (size_t k = 1; weights && k < w->nodes; k++) {
        double half = 0.5 * (plan->x[k] - plan->x[k - 1]);
        weights[k - 1] += half;
        weights[k] += half;
    }
    plan->weights = weights;
    return weights ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status allocate_rows(ovr_writer *w, ovr_error *err)
{
    ovr_arena *a = &w->arena;
    w->pending_step = ovr_arena_take(a, OVR_ROW_CHUNK, sizeof *w->pending_step,
                                     err);
    w->pending_value = ovr_arena_take(a, OVR_ROW_CHUNK * w->file.columns,
                                      sizeof *w->pending_value, err);
    w->workspace = ovr_arena_take(a, w->n, sizeof *w->workspace, err);
    return ovr_arena_status(a);
}

static ovr_status make_names(ovr_writer *w, ovr_error *err)
{
    const char *path = w->options.path = w->file.store.path;
    w->restart = ovr_path_with(&w->arena, path, ".restart", err);
    w->restart_part = ovr_path_with(&w->arena, path, ".restart.part", err);
    return w->restart && w->restart_part ? OVR_OK : OVR_NO_MEMORY;
}

static const char *keep_text(ovr_writer *w, const char *text, bool *kept,
                             ovr_error *err)
{
    char *copy = ovr_arena_text(&w->arena, text ? text : "", err);
    *kept = *kept && copy;
    return copy;
}

/* Copies the case, which is part of every checkpoint. */
static ovr_status keep_case(ovr_writer *w, ovr_error *err)
{
    ovr_write_options *o = &w->options;
    ovr_case_value *values = ovr_arena_take(&w->arena, o->value_count,
                                            sizeof *values, err);
    bool kept = values != NULL;
    for (size_t k = 0; kept && k < o->value_count; k++) {
        values[k] = o->values[k];
        values[k].name = keep_text(w, values[k].name, &kept, err);
        values[k].text = keep_text(w, values[k].text, &kept, err);
        values[k].unit = keep_text(w, values[k].unit, &kept, err);
    }
    o->values = values;
    o->case_text = keep_text(w, o->case_text, &kept, err);
    o->case_path = keep_text(w, o->case_path, &kept, err);
    return kept ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status prepare(ovr_writer *w, const double *X, ovr_file_plan *plan,
                          ovr_error *err)
{
    ovr_status status = check_options(&w->options, err);
    if (!status)
        status = ovr_schedule_make(&w->schedule, &w->options, &w->arena, err);
    if (!status)
        status = choose_nodes(w, X, err);
    if (status)
        return status;
    ovr_date_now(w->created);
    *plan = (ovr_file_plan){.options = &w->options,
                            .scales = &w->scales,
                            .nodes = w->nodes,
                            .created = w->created};
    plan->lines = w->lines;
    plan->y = w->lines > 1 ? line_positions(w, err) : NULL;
    if (w->lines > 1 && !plan->y)
        return OVR_NO_MEMORY;
    plan->x = stored_positions(w, X, err);
    if (!plan->x || set_weights(w, &w->arena, plan, err))
        return OVR_NO_MEMORY;
    status = ovr_file_prepare(&w->file, plan, &w->arena, err);
    if (status)
        return status;
    if (make_names(w, err) || keep_case(w, err) || allocate_rows(w, err))
        return OVR_NO_MEMORY;
    return ovr_queue_prepare(&w->queue,
                             w->file.values * w->file.fields * w->file.element,
                             w->file.columns, &w->arena, err);
}

static void release(ovr_writer *w)
{
    ovr_arena arena = w->arena;
    ovr_packer_release(&w->file.packer);
    ovr_arena_release(&arena);
}

/* HDF5 aborts or crashes if memory is insufficient. The amount that it needs
 * for a file is therefore allocated and freed as a test. */
enum { HDF5_MEMORY = 4 << 20 };

/* With less memory HDF5 1.10 corrupts the heap instead of failing: 8 MB for a
 * file, and 16 MB for stack and heap of the writing thread. */
enum { HDF5_SPACE = 24 << 20 };

static ovr_status space_for_hdf5(const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena probe = ovr_arena_make(allocator);
    probe.blank = true; /* is never read, so needs no clearing */
    bool enough = ovr_arena_take(&probe, HDF5_SPACE, 1, err) != NULL;
    ovr_arena_release(&probe);
    return enough ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_writer *begin(const ovr_write_options *options,
                         const ovr_contact *contact, size_t n, ovr_arena arena,
                         ovr_error *err)
{
    ovr_writer *w = NULL;
    ovr_write_options known;
    ovr_contact of;
    if (!OVR_TAKE(ovr_write_options, &known, options, err) &&
        !OVR_TAKE(ovr_contact, &of, contact, err) &&
        space_for_hdf5(&arena.allocator, err) == OVR_OK)
        w = ovr_arena_take(&arena, 1, sizeof *w, err);
    if (!w)
        return NULL;
    w->arena = arena;
    w->options = known;
    w->scales = ovr_scales_of(&of);
    w->n = n;
    w->lines = known.lines ? known.lines : 1;
    w->file.file = w->file.store.fd = w->file.store.journal = -1;
    w->last_step = -1;
    w->last_T = -INFINITY;
    w->started = w->last_flush = w->last_checkpoint = ovr_now();
    return w;
}

/* Creates the file. A checkpoint, still without a state, is written before the
 * file gets its name. A run killed later can always be resumed. */
static ovr_status start_file(ovr_writer *w, const ovr_file_plan *plan,
                             ovr_error *err)
{
    ovr_status status = ovr_file_create(&w->file, plan, err);
    if (status == OVR_OK)
        status = ovr_store_sync(&w->file.store, err);
    if (status == OVR_OK)
        status = ovr_writer_checkpoint(w, 0, err);
    if (status == OVR_OK)
        status = ovr_store_publish(&w->file.store, w->options.force, err);
    if (status != OVR_IO)
        return status;
    if (err) /* reports an impossible output before the run */
        err->status = OVR_BAD_INPUT;
    return OVR_BAD_INPUT;
}

static ovr_writer *abandon(ovr_writer *w)
{
    ovr_file_close(&w->file, NULL);
    release(w);
    return NULL;
}

ovr_writer *ovr_writer_create(const ovr_write_options *options,
                              const ovr_contact *contact, size_t n,
                              const double *X, const ovr_allocator *allocator,
                              ovr_error *err)
{
    ovr_writer *w = begin(options, contact, n, ovr_arena_make(allocator), err);
    ovr_h5_handler handler;
    ovr_file_plan plan;
    if (!w)
        return NULL;
    handler = ovr_h5_quiet();
    if (prepare(w, X, &plan, err) || start_file(w, &plan, err))
        w = abandon(w);
    ovr_h5_restore(handler);
    if (w)
        ovr_queue_start(&w->queue, !w->options.no_thread, ovr_writer_drain, w);
    return w;
}

double ovr_writer_memory(const ovr_write_options *options,
                         const ovr_contact *contact, size_t n, const double *X)
{
    ovr_writer *w = begin(options, contact, n, ovr_arena_counting(), NULL);
    ovr_file_plan plan;
    double bytes = INFINITY;
    if (w && prepare(w, X, &plan, NULL) == OVR_OK)
        bytes = (double)w->arena.bytes + HDF5_MEMORY;
    if (w)
        release(w);
    return bytes;
}

/* Uses the counts of a checkpoint with a state; otherwise the run begins again
 * and overwrites the rows of the file. */
static void restore_counts(ovr_writer *w, const ovr_restart *restart,
                           ovr_file_plan *plan)
{
    const ovr_counts *counts = restart ? ovr_restart_counts(restart) : NULL;
    plan->created = restart ? ovr_restart_created(restart) : NULL;
    plan->number = restart ? ovr_restart_number(restart) : 0;
    if (!restart || !ovr_restart_get_info(restart)->has_state)
        return;
    w->last_step = (long)counts->step;
    w->last_T = counts->T;
    w->last_stored = counts->stored != 0;
    w->seconds_before = counts->seconds;
    w->snapshots = (size_t)counts->snapshots;
}

static ovr_status reopen_file(ovr_writer *w, const ovr_restart *restart,
                              ovr_file_plan *plan, ovr_error *err)
{
    size_t steps = w->last_step < 0 ? 0 : ovr_restart_get_info(restart)->steps;
    ovr_status status = ovr_file_open(&w->file, plan, w->snapshots, steps, err);
    if (status == OVR_OK)
        snprintf(w->created, sizeof w->created, "%s", w->file.created);
    return status;
}

ovr_writer *ovr_writer_resume(const ovr_write_options *options,
                              const ovr_contact *contact, size_t n,
                              const double *X, const ovr_restart *restart,
                              const ovr_allocator *allocator, ovr_error *err)
{
    ovr_writer *w = begin(options, contact, n, ovr_arena_make(allocator), err);
    ovr_h5_handler handler;
    ovr_file_plan plan;
    ovr_status status;
    if (!w)
        return NULL;
    handler = ovr_h5_quiet();
    status = prepare(w, X, &plan, err);
    if (status == OVR_OK) {
        restore_counts(w, restart, &plan);
        status = reopen_file(w, restart, &plan, err);
    }
    if (status != OVR_OK)
        w = abandon(w);
    ovr_h5_restore(handler);
    if (w)
        ovr_queue_start(&w->queue, !w->options.no_thread, ovr_writer_drain, w);
    return w;
}

/* True if there is a solved state with finite values. */
static bool is_storable(const ovr_frame *frame)
{
    const ovr_state *state = frame->state;
    bool finite = frame->seen->H_min != 0;
    for (size_t i = 0; finite && i < state->n; i++)
        finite = isfinite(state->P[i]) && isfinite(state->H[i]);
    return finite;
}

/* Stores the state at the end of a complete or failed run, unless it is stored
 * already. A resumed run with a later end time drops this snapshot, because the
 * checkpoint was written before it. */
static ovr_status store_last(ovr_writer *w, ovr_run_status run, ovr_error *err)
{
    bool asked = w->options.every_steps || w->options.every_time > 0;
    ovr_frame frame;
    if (w->last_stored || !w->frame_of || (run == OVR_RUN_COMPLETE && !asked))
        return OVR_OK;
    frame = w->frame_of(w);
    if (run == OVR_RUN_FAILED && !is_storable(&frame))
        return OVR_OK;
    if (w->last_step < 0)
        ovr_writer_note(w, &frame);
    ovr_writer_store(w, &frame);
    return ovr_writer_flush(w, err);
}

void ovr_writer_reason(ovr_writer *w, const char *reason)
{
    if (!w)
        return;
    snprintf(w->reason, sizeof w->reason, "%s", reason);
}

void ovr_writer_warnings(ovr_writer *w, const char *warnings)
{
    if (!w)
        return;
    w->warnings = warnings;
}

static ovr_status end_file(ovr_writer *w, ovr_run_status run, ovr_error *err)
{
    ovr_status status = ovr_file_status(&w->file, run, w->reason,
                                        ovr_writer_seconds(w), err);
    if (status == OVR_OK)
        status = ovr_file_warnings(&w->file, w->warnings ? w->warnings : "",
                                   err);
    if (status == OVR_OK && w->frame_of && w->last_step >= 0)
        status = ovr_file_extremes(&w->file, &w->scales, w->frame_of(w).total,
                                   err);
    return status == OVR_OK ? ovr_file_flush(&w->file, err) : status;
}

ovr_status ovr_writer_close(ovr_writer *w, ovr_run_status run,
                            size_t *snapshots, ovr_error *err)
{
    if (!w)
        return ovr_fail_null(err, __func__);
    ovr_status status = OVR_OK, closed;
    ovr_h5_handler handler;
    if (w->source.visit_all && w->last_step >= 0) /* otherwise no state was
                                                   * reached */
        status = ovr_writer_save(w, err);
    if (status == OVR_OK && run != OVR_RUN_STOPPED)
        status = store_last(w, run, err);
    if (status == OVR_OK)
        status = ovr_writer_flush(w, err);
    handler = ovr_h5_quiet();
    ovr_queue_stop(&w->queue);
    if (status == OVR_OK)
        status = end_file(w, run, err);
    closed = ovr_file_close(&w->file, status == OVR_OK ? err : NULL);
    if (snapshots)
        *snapshots = (size_t)w->file.shown;
    release(w);
    ovr_h5_restore(handler);
    return status == OVR_OK ? closed : status;
}
