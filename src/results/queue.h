/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parcels: blocks of data that the solver's thread passes to the writing
 * thread.
 *
 * The solver's thread fills a parcel and posts it. The writing thread processes
 * parcels in order, so that compression and disk access cost the solver only a
 * copy. Without that thread a posted parcel is written at once. This also
 * applies to the first parcels, so that short runs have no thread. After a
 * failure later parcels are dropped, and every later call returns the failure.
 */
#ifndef OVR_RESULTS_QUEUE_H
#define OVR_RESULTS_QUEUE_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

enum { OVR_PARCELS = 6, OVR_PARCEL_STEPS = 64, OVR_ALONE = 12 };

typedef struct ovr_parcel {
    bool snapshot; /* the parcel contains a snapshot */
    double time;   /* time of the snapshot in the file's unit */
    unsigned char *rows;
    size_t steps;   /* rows of history */
    int *step;      /* step numbers */
    double *values; /* values, row by row */
    bool flush;
} ovr_parcel;

typedef ovr_status ovr_drain(void *context, const ovr_parcel *parcel,
                             ovr_error *err);

typedef struct ovr_queue {
    ovr_parcel parcel[OVR_PARCELS];
    size_t first, posted; /* posted parcels */
    size_t filling;       /* parcel that the solver's thread fills */
    ovr_drain *drain;
    void *context;
    int alone; /* remaining posts until the thread starts; 0: no thread */
    bool threaded, closing;
    ovr_error error; /* first failure */
    pthread_t thread;
    pthread_mutex_t mutex;
    pthread_cond_t changed;
} ovr_queue;

/* Allocates the queue. row_bytes: bytes of a snapshot; columns: of the
 * history. */
ovr_status ovr_queue_prepare(ovr_queue *queue, size_t row_bytes, size_t columns,
                             ovr_arena *arena, ovr_error *err);

/* Starts a thread at the OVR_ALONE-th post, if `threaded` and possible. */
void ovr_queue_start(ovr_queue *queue, bool threaded, ovr_drain *drain,
                     void *context);

/* Returns the parcel to fill, which is empty after a post; posts it. */
ovr_parcel *ovr_queue_open(ovr_queue *queue);
ovr_status ovr_queue_post(ovr_queue *queue, ovr_error *err);

/* Waits until all posted parcels are written. */
ovr_status ovr_queue_wait(ovr_queue *queue, ovr_error *err);

/* Waits, then ends the thread. */
void ovr_queue_stop(ovr_queue *queue);

#endif
