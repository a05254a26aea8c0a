/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The writer: what a run leaves on disk.
 *
 * Two sides with a queue between them.  The solver's side takes each state,
 * notes its observation, fills a snapshot when one is due, decides on
 * flushes.  The other side writes: snapshots at once, history in batches of
 * OVR_ROW_CHUNK rows or at a flush, since a write a step would cost more than
 * the step.
 */
#include "results/writer.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "results/h5.h"
#include "results/header.h"

ovr_write_options ovr_write_options_default(void)
{
    ovr_write_options o;
    memset(&o, 0, sizeof o);
    o.fields = OVR_FIELDS_DEFAULT;
    o.x_from = o.x_to = o.end = NAN;
    o.stride = 1;
    o.deflate = 1;
    o.flush_interval = 0.5;
    o.checkpoint_interval = 30;
    return o;
}

static size_t count_fields(unsigned fields)
{
    size_t count = 0;
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        count += fields & ovr_field_table[k].bit ? 1 : 0;
    return count;
}

long ovr_write_every(const ovr_write_options *o, double end, double dT,
                     size_t nodes)
{
    size_t stored = nodes / (o->stride ? o->stride : 1) + 1;
    double row = (double)stored * (double)count_fields(o->fields) *
                 (o->single ? 4 : 8);
    double most = fmin(250, fmax(50, 64e6 / row));
    double every = ceil(end / dT / most);
    return every >= 1 && every < 1e9 ? (long)every : 1;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ------------------------------------------------------- the file's side */

static ovr_status write_pending(ovr_writer *w, ovr_error *err)
{
    size_t count = w->pending;
    w->pending = 0;
    return ovr_file_add_steps(&w->file, count, w->pending_step,
                              w->pending_value, OVR_ROW_CHUNK, err);
}

static void take_step(ovr_writer *w, const ovr_parcel *parcel, size_t r)
{
    const double *row = parcel->values + r * w->file.columns;
    w->pending_step[w->pending] = parcel->step[r];
    for (size_t c = 0; c < w->file.columns; c++)
        w->pending_value[c * OVR_ROW_CHUNK + w->pending] = row[c];
    w->pending++;
}

static ovr_status take_steps(ovr_writer *w, const ovr_parcel *parcel,
                             ovr_error *err)
{
    for (size_t r = 0; r < parcel->steps; r++) {
        take_step(w, parcel, r);
        if (w->pending == OVR_ROW_CHUNK && write_pending(w, err) != OVR_OK)
            return OVR_IO;
    }
    return OVR_OK;
}

static ovr_status drain(ovr_writer *w, const ovr_parcel *parcel, ovr_error *err)
{
    ovr_status status = take_steps(w, parcel, err);
    if (status == OVR_OK && parcel->snapshot)
        status = ovr_file_add_snapshot(&w->file, parcel->time, parcel->rows,
                                       err);
    if (status == OVR_OK && parcel->flush)
        status = write_pending(w, err);
    if (status == OVR_OK && parcel->flush)
        status = ovr_file_flush(&w->file, err);
    return status;
}

ovr_status ovr_writer_drain(void *writer, const ovr_parcel *parcel,
                            ovr_error *err)
{
    ovr_h5_manners manners = ovr_h5_quiet();
    ovr_status status = drain(writer, parcel, err);
    ovr_h5_restore(manners);
    return status;
}

/* ----------------------------------------------------- the solver's side */

bool ovr_writer_due(const ovr_writer *w, long step, double T)
{
    return ovr_schedule_due(&w->schedule, step, w->last_T, T);
}

static void note(ovr_writer *w, const ovr_frame *frame)
{
    const ovr_observable *o = ovr_observables();
    ovr_parcel *parcel = ovr_queue_open(&w->queue);
    double *row = parcel->values + parcel->steps * w->file.columns;
    for (size_t c = 0; c < w->file.columns; c++)
        row[c] = ovr_observable_value(&o[c], frame->seen) *
                 ovr_factor(&w->scales, o[c].kind);
    parcel->step[parcel->steps++] = (int)frame->state->step;
}

static void store(ovr_writer *w, const ovr_frame *frame)
{
    ovr_parcel *parcel = ovr_queue_open(&w->queue);
    parcel->snapshot = true;
    parcel->time = frame->state->T * ovr_factor(&w->scales, 'T');
    ovr_writer_fill(w, frame, parcel->rows);
    w->snapshots++;
}

/* Readers see the newest snapshot half a second late at most; a run that
 * stores none for long still shows its history. */
static bool flush_due(const ovr_writer *w, bool stored)
{
    double wait = w->options.flush_interval * (stored ? 1 : 4);
    return now() - w->last_flush >= wait;
}

static ovr_status post(ovr_writer *w, bool flush, ovr_error *err)
{
    ovr_queue_open(&w->queue)->flush = flush;
    if (flush)
        w->last_flush = now();
    return ovr_queue_post(&w->queue, err);
}

static ovr_status check_frame(const ovr_writer *w, const ovr_frame *frame,
                              ovr_error *err)
{
    unsigned missing = w->options.fields;
    if (frame->state->n != w->n)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: made for %zu nodes, not %zu",
                        w->options.path, w->n, frame->state->n);
    missing &= (frame->rho ? 0u : OVR_FIELD_DENSITY) |
               (frame->eta ? 0u : OVR_FIELD_VISCOSITY) |
               (frame->flow ? 0u : OVR_FIELD_MASS_FLOW);
    if (missing)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: a snapshot is due but density, viscosity or mass "
                        "flow is not given",
                        w->options.path);
    return OVR_OK;
}

ovr_status ovr_writer_record(ovr_writer *w, const ovr_frame *frame,
                             ovr_error *err)
{
    const ovr_state *state = frame->state;
    bool due = ovr_writer_due(w, state->step, state->T), flush;
    if (state->step <= w->last_step) /* the state a resumed run starts from */
        return OVR_OK;
    if (due && check_frame(w, frame, err) != OVR_OK)
        return OVR_BAD_INPUT;
    note(w, frame);
    if (due)
        store(w, frame);
    w->last_step = state->step;
    w->last_T = state->T;
    w->last_stored = due;
    flush = flush_due(w, due);
    if (due || flush || ovr_queue_open(&w->queue)->steps == OVR_PARCEL_STEPS)
        return post(w, flush, err);
    return OVR_OK;
}

ovr_status ovr_writer_flush(ovr_writer *w, ovr_error *err)
{
    ovr_status status = post(w, true, err);
    return status == OVR_OK ? ovr_queue_wait(&w->queue, err) : status;
}

double ovr_writer_next_time(void *writer, double T)
{
    const ovr_writer *w = writer;
    return ovr_schedule_next(&w->schedule, T);
}

size_t ovr_writer_snapshots(const ovr_writer *w)
{
    return w->snapshots;
}

/* --------------------------------------------------------- start and end */

static ovr_status check_options(const ovr_write_options *o, ovr_error *err)
{
    if (!o->path || !o->path[0])
        return ovr_fail(err, OVR_BAD_INPUT, "the result file has no name");
    if (o->deflate < 0 || o->deflate > 9)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: deflate level %d; 0 to 9",
                        o->path, o->deflate);
    if (o->stride < 1)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: stride 0; 1 or more", o->path);
    if (count_fields(o->fields) == 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: no field to store", o->path);
    return OVR_OK;
}

/* The stored nodes: those in the window, from its first one on by strides. */
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
                        "%s: no node lies in the window "
                        "from %g to %g",
                        w->options.path, o->x_from, o->x_to);
    return OVR_OK;
}

static double *stored_positions(ovr_writer *w, const double *X, ovr_error *err)
{
    double factor = ovr_factor(&w->scales, 'X');
    double *x = ovr_arena_take(&w->arena, w->nodes, sizeof *x, err);
    for (size_t k = 0; x && k < w->nodes; k++)
        x[k] = factor * X[w->first + k * w->options.stride];
    return x;
}

static ovr_status take_scratch(ovr_writer *w, ovr_error *err)
{
    ovr_arena *a = &w->arena;
    w->pending_step = ovr_arena_take(a, OVR_ROW_CHUNK, sizeof *w->pending_step,
                                     err);
    w->pending_value = ovr_arena_take(a, OVR_ROW_CHUNK * w->file.columns,
                                      sizeof *w->pending_value, err);
    w->rho = ovr_arena_take(a, w->n, sizeof *w->rho, err);
    w->eta = ovr_arena_take(a, w->n, sizeof *w->eta, err);
    w->flow = ovr_arena_take(a, w->n, sizeof *w->flow, err);
    return w->pending_step && w->pending_value && w->rho && w->eta && w->flow
               ? OVR_OK
               : OVR_NO_MEMORY;
}

static ovr_status prepare(ovr_writer *w, const double *X, ovr_file_plan *plan,
                          ovr_error *err)
{
    ovr_arena *arena = &w->arena;
    if (check_options(&w->options, err) ||
        ovr_schedule_make(&w->schedule, &w->options, arena, err) ||
        choose_nodes(w, X, err))
        return OVR_BAD_INPUT;
    plan->options = &w->options;
    plan->scales = &w->scales;
    plan->nodes = w->nodes;
    plan->x = stored_positions(w, X, err);
    if (!plan->x || ovr_file_prepare(&w->file, plan, arena, err) ||
        take_scratch(w, err))
        return OVR_NO_MEMORY;
    return ovr_queue_prepare(&w->queue,
                             w->nodes * w->file.fields * w->file.element,
                             w->file.columns, arena, err);
}

static void release(ovr_writer *w)
{
    ovr_arena arena = w->arena;
    ovr_packer_release(&w->file.packer);
    ovr_arena_release(&arena);
}

static ovr_writer *begin(const ovr_write_options *options,
                         const ovr_contact *contact, size_t n,
                         const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_writer *w = ovr_arena_take(&arena, 1, sizeof *w, err);
    if (!w)
        return NULL;
    w->arena = arena;
    w->options = *options;
    w->scales = ovr_scales_of(contact);
    w->n = n;
    w->file.file = w->file.store.fd = w->file.store.journal = -1;
    w->last_step = -1;
    w->last_T = -INFINITY;
    w->started = w->last_flush = w->last_checkpoint = now();
    return w;
}

ovr_writer *ovr_writer_create(const ovr_write_options *options,
                              const ovr_contact *contact, size_t n,
                              const double *X, const ovr_allocator *allocator,
                              ovr_error *err)
{
    ovr_writer *w = begin(options, contact, n, allocator, err);
    ovr_h5_manners manners = ovr_h5_quiet();
    ovr_file_plan plan;
    if (w && (prepare(w, X, &plan, err) != OVR_OK ||
              ovr_file_create(&w->file, &plan, err) != OVR_OK)) {
        ovr_file_close(&w->file, NULL);
        release(w);
        w = NULL;
    }
    ovr_h5_restore(manners);
    if (w)
        ovr_queue_start(&w->queue, !w->options.no_thread, ovr_writer_drain, w);
    return w;
}

static ovr_status end_file(ovr_writer *w, ovr_run_status run, ovr_error *err)
{
    ovr_status status = ovr_file_status(&w->file, run, err);
    if (status == OVR_OK)
        ovr_h5_change_number(w->file.file, "date_seconds",
                             w->seconds_before + now() - w->started);
    if (status == OVR_OK)
        status = ovr_file_flush(&w->file, err);
    return status;
}

ovr_status ovr_writer_close(ovr_writer *w, ovr_run_status run, ovr_error *err)
{
    ovr_status status = ovr_writer_flush(w, err), closed;
    ovr_h5_manners manners = ovr_h5_quiet();
    ovr_queue_stop(&w->queue);
    if (status == OVR_OK)
        status = end_file(w, run, err);
    closed = ovr_file_close(&w->file, status == OVR_OK ? err : NULL);
    release(w);
    ovr_h5_restore(manners);
    return status == OVR_OK ? closed : status;
}
