/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal data of the writer, shared by its files. */
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
    double *times; /* in increasing order */
} ovr_schedule;

ovr_status ovr_schedule_make(ovr_schedule *schedule,
                             const ovr_write_options *options, ovr_arena *arena,
                             ovr_error *err);

struct ovr_writer {
    ovr_arena arena;
    ovr_write_options options; /* texts and lists are not kept */

    ovr_scales scales;
    ovr_schedule schedule;
    size_t n;            /* nodes of the run along x */
    size_t lines;        /* lines of a strip; 1 for a line contact */
    size_t first, nodes; /* stored nodes: first + k * stride */
    double *workspace;   /* for fields that are computed */

    /* Used by the solver's thread. */
    ovr_queue queue;
    long last_step; /* last recorded step; -1: none yet */
    double last_T;
    bool last_stored; /* the last state is stored as a snapshot */
    size_t snapshots; /* stored snapshots, including queued ones */
    char reason[OVR_MESSAGE_SIZE];
    const char *warnings; /* owned by the caller; NULL: none */
    double started, last_flush, last_checkpoint, seconds_before;

    /* Checkpoints. */
    ovr_state_source source; /* visit_all NULL: no checkpoints */
    ovr_state_source more;   /* additional state */
    char *restart, *restart_part;
    char created[OVR_DATE_SIZE];

    /* Returns the present state as a frame; NULL: unknown. */
    ovr_frame (*frame_of)(ovr_writer *writer);
    const ovr_simulation *observed;
    ovr_simulation *saved; /* simulation saved in checkpoints */

    /* Used by the writing thread. */
    ovr_file file;
    size_t pending;        /* history rows not yet in the file */
    int *pending_step;     /* OVR_ROW_CHUNK elements */
    double *pending_value; /* column by column, OVR_ROW_CHUNK elements each */
};

/* Writes one parcel (an ovr_drain). */
ovr_status ovr_writer_drain(void *writer, const ovr_parcel *parcel,
                            ovr_error *err);

/* Sets the source of the state for further checkpoints. */
void ovr_writer_source(ovr_writer *writer, ovr_state_source source);

/* Return the seconds of a monotonic clock; the run's time so far. */
double ovr_now(void);
double ovr_writer_seconds(const ovr_writer *writer);

/* Appends a history row to the batch that is being filled. */
void ovr_writer_note(ovr_writer *writer, const ovr_frame *frame);

/* Appends a snapshot to the batch that is being filled. */
void ovr_writer_store(ovr_writer *writer, const ovr_frame *frame);

/* Writes a checkpoint with this number for the present contents of the file,
 * and syncs both. The queue must be empty. */
ovr_status ovr_writer_checkpoint(ovr_writer *writer, uint64_t number,
                                 ovr_error *err);

/* Flushes, syncs and writes a checkpoint. */
ovr_status ovr_writer_save(ovr_writer *writer, ovr_error *err);

/* Returns the memory in bytes of a writer and HDF5, counted during a real
 * setup; INFINITY if the setup fails. */
double ovr_writer_memory(const ovr_write_options *options,
                         const ovr_contact *contact, size_t n, const double *X);

#endif
