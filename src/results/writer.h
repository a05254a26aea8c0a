/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The writer's insides, for the files that make it up. */
#ifndef OVR_RESULTS_WRITER_H
#define OVR_RESULTS_WRITER_H

#include "results/file.h"
#include "results/queue.h"
#include "results/schedule.h"

struct ovr_writer {
    ovr_arena arena;
    ovr_write_options options; /* texts and lists not kept */

    ovr_scales scales;
    ovr_schedule schedule;
    size_t n;                 /* nodes of the run */
    size_t first, nodes;      /* the stored ones: first + k * stride */
    double *rho, *eta, *flow; /* scratch of ovr_writer_observe */

    /* the solver's side */
    ovr_queue queue;
    long last_step; /* recorded; -1: none yet */
    double last_T;
    bool last_stored; /* the last state has its snapshot */
    size_t snapshots; /* stored, on their way included */
    double started, last_flush, last_checkpoint, seconds_before;
    const ovr_frame *frame;

    /* the other side of the queue */
    ovr_file file;
    size_t pending;        /* history rows not yet in the file */
    int *pending_step;     /* OVR_ROW_CHUNK of them */
    double *pending_value; /* column after column, OVR_ROW_CHUNK each */
};

/* An ovr_drain: writes one parcel. */
ovr_status ovr_writer_drain(void *writer, const ovr_parcel *parcel,
                            ovr_error *err);

/* Will the state of this step at T be stored? */
bool ovr_writer_due(const ovr_writer *writer, long step, double T);

/* Puts the frame's fields into rows, scaled, windowed, as they are stored. */
void ovr_writer_fill(const ovr_writer *writer, const ovr_frame *frame,
                     unsigned char *rows);

#endif
