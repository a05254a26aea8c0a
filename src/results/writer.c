/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes the results of a run.
 *
 * The solver's thread records an observation of each state, fills a snapshot if
 * one is due, and decides on flushes. A queue passes them to the writing
 * thread. Snapshots are written at once, history in batches of OVR_ROW_CHUNK
 * rows or at a flush, because writing each step would cost more than the step.
 */
#include "results/writer.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/given.h"
#include "results/h5.h"
#include "results/results.h"

/* -------------------------------------------------- schedule of snapshots */

/* Returns the difference below which two times are equal. */
static double time_tolerance(double T)
{
    return 1e-10 * fmax(1, fabs(T));
}

ovr_status ovr_schedule_make(ovr_schedule *s, const ovr_write_options *o,
                             ovr_arena *arena, ovr_error *err)
{
    if (o->every_steps < 0 || !(o->every_time >= 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "snapshots every %ld steps or every %g b/u_m: must "
                        "not be negative",
                        o->every_steps, o->every_time);
    for (size_t k = 0; k < o->time_count; k++)
        if (!isfinite(o->times[k]))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "snapshots: the time %g is not finite",
                            o->times[k]);
    s->every_steps = o->every_steps;
    s->every_time = o->every_time;
    s->count = o->time_count;
    s->times = ovr_arena_take(arena, s->count, sizeof *s->times, err);
    if (!s->times)
        return OVR_NO_MEMORY;
    if (s->count) {
        memcpy(s->times, o->times, s->count * sizeof *s->times);
        gsl_sort(s->times, 1, s->count);
    }
    return OVR_OK;
}

/* Returns the number of given times up to T. */
static size_t times_up_to(const ovr_schedule *s, double T)
{
    size_t low = 0, high = s->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (s->times[middle] <= T)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Returns the last multiple of every_time up to T; there is none below 0. */
static double multiple(const ovr_schedule *s, double T)
{
    return T < 0 ? -1 : floor(T / s->every_time);
}

/* True if the state of this step at T is due. T_before: time of the preceding
 * state; -INFINITY: none. */
static bool schedule_due(const ovr_schedule *s, long step, double T_before,
                         double T)
{
    double from = T_before + time_tolerance(T), to = T + time_tolerance(T);
    if (s->every_steps && step % s->every_steps == 0)
        return true;
    if (s->every_time > 0 && multiple(s, to) > multiple(s, from))
        return true;
    return times_up_to(s, to) > times_up_to(s, from);
}

/* Returns the next scheduled time after T, or INFINITY. */
static double schedule_next(const ovr_schedule *s, double T)
{
    double from = T + time_tolerance(T), next = INFINITY;
    size_t k = times_up_to(s, from);
    if (s->every_time > 0)
        next = (multiple(s, from) + 1) * s->every_time;
    return k < s->count ? fmin(next, s->times[k]) : next;
}

/* --------------------------------------------------------------------- Rows */

/* Conversion of a state to a snapshot row: scaling, window, stride. */

/* Returns the stored value of node k; for values at half nodes the mean of both
 * neighbours. */
static double value_at(const ovr_writer *w, const ovr_observable *which,
                       const double *values, size_t k)
{
    size_t i = w->first + k * w->options.stride, last = w->n - 1;
    if (which->axes != OVR_AT_HALVES)
        return values[i];
    return (values[i > 0 ? i - 1 : 0] + values[i < last ? i : last - 1]) / 2;
}

/* Fills one line of each field; `rows` are those of the snapshot. */
static void fill_line(const ovr_writer *w, const ovr_frame *frame, size_t line,
                      unsigned char *rows)
{
    for (size_t f = 0; f < w->file.fields; f++) {
        const ovr_observable *which = w->file.which[f];
        const double *from = frame->field(frame->source, which, w->workspace);
        double factor = ovr_factor(&w->scales, which->kind);
        size_t element = ovr_file_element(&w->file, which);
        unsigned char *after = rows + w->file.values * element;
        rows += line * w->nodes * element;
        for (size_t k = 0; k < w->nodes; k++, rows += element) {
            double value = factor * value_at(w, which, from, k);
            if (element == sizeof(double))
                *(double *)(void *)rows = value;
            else if (element == sizeof(float))
                *(float *)(void *)rows = (float)value;
            else
                *(signed char *)rows = (signed char)value;
        }
        rows = after;
    }
}

/* Writes the fields of a frame to rows, scaled and windowed as stored. */
static void writer_fill(const ovr_writer *w, const ovr_frame *frame,
                        unsigned char *rows)
{
    for (size_t line = 0; line < w->lines; line++) {
        if (frame->show)
            frame->show(frame->shown, line);
        fill_line(w, frame, line, rows);
    }
    if (frame->show)
        frame->show(frame->shown, w->lines);
}

/* ------------------------------------------------------------------- Writer */

double ovr_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* --------------------------------------------------------- writing thread */

static ovr_status write_pending(ovr_writer *w, ovr_error *err)
{
    size_t count = w->pending;
    w->pending = 0;
    return ovr_file_add_steps(&w->file, count, w->pending_step,
                              w->pending_value, OVR_ROW_CHUNK, err);
}

static ovr_status copy_steps(ovr_writer *w, const ovr_parcel *parcel,
                             ovr_error *err)
{
    for (size_t r = 0; r < parcel->steps; r++) {
        const double *row = parcel->values + r * w->file.columns;
        for (size_t c = 0; c < w->file.columns; c++)
            w->pending_value[c * OVR_ROW_CHUNK + w->pending] = row[c];
        w->pending_step[w->pending++] = parcel->step[r];
        if (w->pending == OVR_ROW_CHUNK && write_pending(w, err) != OVR_OK)
            return OVR_IO;
    }
    return OVR_OK;
}

static ovr_status drain(ovr_writer *w, const ovr_parcel *parcel, ovr_error *err)
{
    ovr_status status = copy_steps(w, parcel, err);
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
    ovr_h5_handler handler = ovr_h5_quiet();
    ovr_status status = drain(writer, parcel, err);
    ovr_h5_restore(handler);
    return status;
}

/* -------------------------------------------------------- solver's thread */

/* True if the state of this step at T will be stored. */
static bool is_due(const ovr_writer *w, long step, double T)
{
    return schedule_due(&w->schedule, step, w->last_T, T);
}

bool ovr_writer_stores(const ovr_writer *w, long step, double T)
{
    if (!w)
        return false;
    return step > w->last_step && is_due(w, step, T);
}

void ovr_writer_note(ovr_writer *w, const ovr_frame *frame)
{
    ovr_parcel *parcel = ovr_queue_open(&w->queue);
    double *row = parcel->values + parcel->steps * w->file.columns;
    for (size_t c = 0; c < w->file.columns; c++)
        row[c] = ovr_observable_value(w->file.row[c], frame->seen) *
                 ovr_factor(&w->scales, w->file.row[c]->kind);
    parcel->step[parcel->steps++] = (int)frame->state->step;
}

void ovr_writer_store(ovr_writer *w, const ovr_frame *frame)
{
    ovr_parcel *parcel = ovr_queue_open(&w->queue);
    parcel->snapshot = true;
    parcel->time = frame->state->T * ovr_factor(&w->scales, OVR_KIND_TIME);
    writer_fill(w, frame, parcel->rows);
    w->snapshots++;
}

/* True if a flush is due. Readers see the newest snapshot at most half a second
 * late; a run without snapshots for a long time still shows its history. */
static bool flush_due(const ovr_writer *w, bool stored)
{
    double wait = w->options.flush_interval * (stored ? 1 : 4);
    return ovr_now() - w->last_flush >= wait;
}

static ovr_status post(ovr_writer *w, bool flush, ovr_error *err)
{
    ovr_queue_open(&w->queue)->flush = flush;
    if (flush)
        w->last_flush = ovr_now();
    return ovr_queue_post(&w->queue, err);
}

static bool checkpoint_due(const ovr_writer *w)
{
    double interval = w->options.checkpoint_interval;
    return w->source.visit_all && interval > 0 &&
           ovr_now() - w->last_checkpoint >= interval;
}

ovr_status ovr_writer_record(ovr_writer *w, const ovr_frame *given,
                             ovr_error *err)
{
    if (!w)
        return ovr_fail_null(err, __func__);
    ovr_frame own, *frame = &own;
    const ovr_state *state;
    bool due, flush;
    if (OVR_TAKE(ovr_frame, frame, given, err))
        return OVR_BAD_INPUT;
    state = frame->state;
    due = is_due(w, state->step, state->T);
    if (state->step <= w->last_step) /* initial state of a resumed run */
        return OVR_OK;
    if (due && state->n != w->n)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: was made for %zu nodes, not for %zu",
                        w->options.path, w->n, state->n);
    ovr_writer_note(w, frame);
    if (due)
        ovr_writer_store(w, frame);
    w->last_step = state->step;
    w->last_T = state->T;
    w->last_stored = due;
    if (checkpoint_due(w))
        return ovr_writer_save(w, err);
    flush = flush_due(w, due);
    if (due || flush || ovr_queue_open(&w->queue)->steps == OVR_PARCEL_STEPS)
        return post(w, flush, err);
    return OVR_OK;
}

ovr_status ovr_writer_flush(ovr_writer *w, ovr_error *err)
{
    if (!w)
        return ovr_fail_null(err, __func__);
    ovr_status status = post(w, true, err);
    return status == OVR_OK ? ovr_queue_wait(&w->queue, err) : status;
}

double ovr_writer_next_time(void *writer, double T)
{
    if (!writer)
        return NAN;
    const ovr_writer *w = writer;
    return schedule_next(&w->schedule, T);
}

/* ------------------------------------------------------------ checkpoints */

void ovr_writer_source(ovr_writer *w, ovr_state_source source)
{
    w->source = source;
}

double ovr_writer_seconds(const ovr_writer *w)
{
    return w->seconds_before + ovr_now() - w->started;
}

ovr_status ovr_writer_checkpoint(ovr_writer *w, uint64_t number, ovr_error *err)
{
    const ovr_write_options *o = &w->options;
    ovr_checkpoint c = {.path = w->restart,
                        .part = w->restart_part,
                        .created = w->created,
                        .case_text = o->case_text,
                        .case_path = o->case_path,
                        .value_count = o->value_count,
                        .values = o->values,
                        .number = number,
                        .sync = true};
    if (w->last_step >= 0) /* the run has begun */
        c.source = w->source;
    c.counts = (ovr_counts){.step = w->last_step,
                            .snapshots = (int64_t)w->file.snapshots,
                            .steps = (int64_t)w->file.steps,
                            .stored = w->last_stored,
                            .T = w->last_T,
                            .seconds = ovr_writer_seconds(w)};
    return ovr_checkpoint_write(&c, err);
}

ovr_status ovr_writer_save(ovr_writer *w, ovr_error *err)
{
    ovr_store *store = &w->file.store;
    uint64_t number = store->kept.number + 1;
    ovr_status status = ovr_writer_flush(w, err);
    if (status == OVR_OK)
        status = ovr_store_sync(store, err);
    if (status == OVR_OK)
        status = ovr_writer_checkpoint(w, number, err);
    if (status == OVR_OK)
        ovr_store_keep(store, number);
    w->last_checkpoint = ovr_now();
    return status;
}

bool ovr_writer_repaired(const ovr_writer *w)
{
    if (!w)
        return false;
    return w->file.store.repaired;
}

bool ovr_writer_unlocked(const ovr_writer *w)
{
    if (!w)
        return false;
    return w->file.store.unlocked;
}
