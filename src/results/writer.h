/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The writer's insides, for the files that make it up. */
#ifndef OVR_RESULTS_WRITER_H
#define OVR_RESULTS_WRITER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "overroll/results.h"
#include "results/checkpoint.h"
#include "results/file.h"
#include "results/header.h"
#include "results/queue.h"
#include "results/results.h"

/*
 * Decides when a snapshot is due.
 *
 * By steps: at every multiple of every_steps.  By time: at the first state
 * at or after each multiple of every_time and each given time.  The answer
 * depends only on this state and the one before it, so that a resumed run
 * stores what an uninterrupted one does.
 */

typedef struct ovr_schedule {
    long every_steps;
    double every_time;
    size_t count;
    double *times; /* increasing */
} ovr_schedule;

ovr_status ovr_schedule_make(ovr_schedule *schedule,
                             const ovr_write_options *options, ovr_arena *arena,
                             ovr_error *err);

struct ovr_writer {
    ovr_arena arena;
    ovr_write_options options; /* texts and lists not kept */

    ovr_scales scales;
    ovr_schedule schedule;
    size_t n;            /* nodes of the run along x */
    size_t lines;        /* of a strip; 1: a line contact */
    size_t first, nodes; /* the stored ones: first + k * stride */
    double *workspace;   /* for a field on its way */

    /* the solver's side */
    ovr_queue queue;
    long last_step; /* recorded; -1: none yet */
    double last_T;
    bool last_stored; /* the last state has its snapshot */
    size_t snapshots; /* stored, on their way included */
    char reason[OVR_MESSAGE_SIZE];
    const char *warnings; /* borrowed; NULL: none */
    double started, last_flush, last_checkpoint, seconds_before;

    /* checkpoints */
    ovr_state_source source; /* visit_all NULL: there are none */
    ovr_state_source more;   /* the same */
    char *restart, *restart_part;
    char created[OVR_DATE_SIZE];

    /* the state now, as a frame; NULL: not known */
    ovr_frame (*frame_of)(ovr_writer *writer);
    const ovr_simulation *observed;
    ovr_simulation *saved; /* in checkpoints */

    /* the other side of the queue */
    ovr_file file;
    size_t pending;        /* history rows not yet in the file */
    int *pending_step;     /* OVR_ROW_CHUNK of them */
    double *pending_value; /* column after column, OVR_ROW_CHUNK each */
};

/* An ovr_drain: writes one parcel. */
ovr_status ovr_writer_drain(void *writer, const ovr_parcel *parcel,
                            ovr_error *err);

/* Checkpoints hold this source's state from now on. */
void ovr_writer_source(ovr_writer *writer, ovr_state_source source);

/* Seconds of a clock that only goes forward; and those the run took so far. */
double ovr_now(void);
double ovr_writer_seconds(const ovr_writer *writer);

/* Appends a history row to the batch that is being filled. */
void ovr_writer_note(ovr_writer *writer, const ovr_frame *frame);

/* Appends a snapshot to the batch that is being filled. */
void ovr_writer_store(ovr_writer *writer, const ovr_frame *frame);

/* A checkpoint of what is in the file, by this number, synced as the file must
 * be; the queue must be empty. */
ovr_status ovr_writer_checkpoint(ovr_writer *writer, uint64_t number,
                                 ovr_error *err);

/* Flushes, syncs and writes a checkpoint. */
ovr_status ovr_writer_save(ovr_writer *writer, ovr_error *err);

/* Bytes that a writer and HDF5 take, counted through its real set-up;
 * INFINITY where it would be refused. */
double ovr_writer_memory(const ovr_write_options *options,
                         const ovr_contact *contact, size_t n, const double *X);

#endif
