/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal data of the reader, shared by its files. */
#ifndef OVR_RESULTS_READER_H
#define OVR_RESULTS_READER_H

#include "base/arena.h"
#include "overroll/results.h"
#include "results/hdf5read/hdf5read.h"
#include "results/layout.h"

struct ovr_result {
    ovr_arena arena;
    ovr_arena work; /* memory of one access to the file */
    char *path;
    int fd; /* -1: not open */
    ovr_container container;
    ovr_result_info info;
    ovr_variable *variable; /* all variables */
    ovr_dataset *set;       /* positions of the datasets in the file as first
                             * opened */
    bool sets_hold; /* the file with the positions in `set` is still open */
    ovr_result_input *input;
    const char **input_path; /* path of each input's dataset */
    size_t inputs;
    const ovr_variable *x, *y, *time, **field, **column;
    size_t shown; /* line shown by snapshots */
    size_t variables, fields, columns, groups;
    double version; /* format version */
    bool starved;   /* memory was insufficient for a text */
    bool looked_at; /* the file is complete, according to a journal without a
                     * writer */
};

/* Opens the file (again) with the lock held (negative: no writer); counts and
 * lists of `r` do not change. OVR_IO: while the file is being written, a retry
 * may succeed. */
ovr_status ovr_reader_file(ovr_result *result, int lock, ovr_error *err);
void ovr_reader_close_file(ovr_result *result);

/* Blocks the writer's commits; returns a negative number if there is no
 * writer. */
int ovr_reader_lock(const ovr_result *result);
void ovr_reader_unlock(int lock);

/* Reads the datasets and attributes of the open file. The second function fails
 * with a message that the file is no result file. */
ovr_status ovr_reader_content(ovr_result *result, ovr_error *err);
ovr_status ovr_reader_not_ours(ovr_result *result, ovr_error *err);

/* Reads the list of the group `inputs`, if it exists. */
ovr_status ovr_reader_inputs(ovr_result *result, ovr_error *err);

/* Returns a text attribute without control characters, in the result's memory;
 * NULL if it is missing. */
const char *ovr_reader_text(ovr_result *result, uint64_t object,
                            const char *name);

/* Finds an object by its path, "stress/surface_1". */
bool ovr_reader_object(ovr_result *result, const char *path, uint64_t *object);

/* Finds a dataset by its path, "x" or "history/time". */
bool ovr_reader_dataset(ovr_result *result, const char *path, ovr_dataset *set);

#endif
