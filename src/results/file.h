/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A result file that grows: its headers, one row at a time, its flushes. This
 * layer uses HDF5 and the layout. It is independent of the schedule, of threads
 * and of the simulation.
 */
#ifndef OVR_RESULTS_FILE_H
#define OVR_RESULTS_FILE_H

#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/pack.h"
#include "overroll/results.h"
#include "results/layout.h"
#include "results/results.h"
#include "results/store.h"

/* Rows per chunk of a history column or of `time`. These chunks have no filter
 * and are filled row by row. */
enum { OVR_ROW_CHUNK = 256 };

/* Holds a date like 2026-01-31T12:00:00.123456Z. */
enum { OVR_DATE_SIZE = 32 };

typedef struct ovr_file {
    ovr_store store;
    hid_t file;
    hid_t time, field[OVR_FIELDS_MAX];
    hid_t step, *column;
    size_t fields, columns;
    const ovr_observable *which[OVR_FIELDS_MAX], **row; /* in the same order */
    size_t nodes, lines; /* size of a snapshot; a line contact has one line */
    size_t values;       /* values of a snapshot: nodes times lines */
    size_t element;      /* bytes per value */
    int deflate;
    char created[OVR_DATE_SIZE]; /* date_created of an existing file */
    hsize_t snapshots, steps;    /* rows written */
    hsize_t shown;               /* snapshots visible to readers */
    hid_t transfer;              /* transfer properties of columns; -1: not
                                  * open */
    ovr_packer packer;
} ovr_file;

typedef struct ovr_file_plan {
    const ovr_write_options *options;
    const ovr_scales *scales;
    const double *x; /* stored positions in the file's unit */
    size_t nodes;
    size_t lines;          /* 1 for a line contact */
    const double *y;       /* positions of the lines, in the file's unit */
    const char *created;   /* date_created */
    uint64_t number;       /* number of the checkpoint to resume from */
    const double *weights; /* integration weights along x; NULL: not stored */
} ovr_file_plan;

/* Returns the bytes per value of a field. */
size_t ovr_file_element(const ovr_file *file, const ovr_observable *which);

/* Allocates the memory of the file and derives sizes from the plan; no disk
 * access. */
ovr_status ovr_file_prepare(ovr_file *file, const ovr_file_plan *plan,
                            ovr_arena *arena, ovr_error *err);

/* Creates the file with all headers under its temporary name. */
ovr_status ovr_file_create(ovr_file *file, const ovr_file_plan *plan,
                           ovr_error *err);

/* Opens a file to be resumed and restores its last checkpoint. The file must
 * have plan->created, these positions and this precision. Rows after the
 * counted ones are dropped. */
ovr_status ovr_file_open(ovr_file *file, const ovr_file_plan *plan,
                         size_t snapshots, size_t steps, ovr_error *err);

/* Appends a snapshot: its time, and its fields in the format of the file. */
ovr_status ovr_file_add_snapshot(ovr_file *file, double time, const void *rows,
                                 ovr_error *err);

/* Appends `count` rows of history: step numbers, and columns that are `stride`
 * elements apart. */
ovr_status ovr_file_add_steps(ovr_file *file, size_t count, const int *steps,
                              const double *columns, size_t stride,
                              ovr_error *err);

/* Makes all data so far visible to readers. */
ovr_status ovr_file_flush(ovr_file *file, ovr_error *err);
/* Writes the final status of the run and its wall time in seconds. */
ovr_status ovr_file_status(ovr_file *file, ovr_run_status status,
                           const char *reason, double seconds, ovr_error *err);
/* Writes the warnings as an attribute. */
ovr_status ovr_file_warnings(ovr_file *file, const char *text, ovr_error *err);
/* Writes the extremes of the run as attributes. */
ovr_status ovr_file_extremes(ovr_file *file, const ovr_scales *scales,
                             const ovr_statistics *total, ovr_error *err);
ovr_status ovr_file_close(ovr_file *file, ovr_error *err);

#endif
