/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reader's insides, for the files that make it up. */
#ifndef OVR_RESULTS_READER_H
#define OVR_RESULTS_READER_H

#include "base/arena.h"
#include "overroll/results.h"
#include "results/hdf5read/hdf5read.h"
#include "results/layout.h"

struct ovr_result {
    ovr_arena arena;
    ovr_arena work; /* of one look into the file */
    char *path;
    int fd; /* -1: not open */
    ovr_container container;
    ovr_result_info info;
    ovr_variable *variable; /* all */
    ovr_dataset *set; /* where each is, in the file that was opened first */
    bool sets_hold;   /* that file is still open */
    ovr_result_input *input;
    const char **input_path; /* of its dataset */
    size_t inputs;
    const ovr_variable *x, *y, *time, **field, **column;
    size_t shown; /* line that snapshots are of */
    size_t variables, fields, columns, groups;
    double version; /* of the file's format */
    bool starved;   /* a text did not fit into memory */
    bool looked_at; /* the file is complete according to a journal that no
                       process writes */
};

/* Opens the file (again), with the lock held (a negative number: nobody
 * writes); the counts and lists of `r` stay.  OVR_IO: trying again may help,
 * when the file is being written. */
ovr_status ovr_reader_file(ovr_result *result, int lock, ovr_error *err);
void ovr_reader_close_file(ovr_result *result);

/* Keeps the writer's commits out; a negative number: nobody writes. */
int ovr_reader_lock(const ovr_result *result);
void ovr_reader_unlock(int lock);

/* Decides after the attempt of this number that failed, with the lock or
 * without: true to try again, after a pause, as the writer's bursts take
 * milliseconds.  Where nobody writes the file stays as it is. */
bool ovr_reader_again(const ovr_result *result, int attempt, bool locked);

/* Its datasets and attributes, of the file that is open; that it is none of
 * ours. */
ovr_status ovr_reader_content(ovr_result *result, ovr_error *err);
ovr_status ovr_reader_not_ours(ovr_result *result, ovr_error *err);

/* Reads what the group `inputs` holds, if there is one. */
ovr_status ovr_reader_inputs(ovr_result *result, ovr_error *err);

/* A text attribute without control characters, in the result's memory; NULL:
 * there is none. */
const char *ovr_reader_text(ovr_result *result, uint64_t object,
                            const char *name);

/* An object by its path, "stress/surface_1". */
bool ovr_reader_object(ovr_result *result, const char *path, uint64_t *object);

/* A dataset by its path, "x" or "history/time". */
bool ovr_reader_dataset(ovr_result *result, const char *path, ovr_dataset *set);

#endif
