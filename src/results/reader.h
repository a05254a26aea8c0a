/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reader's insides, for the files that make it up. */
#ifndef OVR_RESULTS_READER_H
#define OVR_RESULTS_READER_H

#include <hdf5.h>

#include "base/arena.h"
#include "overroll/results.h"
#include "results/layout.h"

enum { OVR_READ_ATTEMPTS = 5 };

struct ovr_result {
    ovr_arena arena;
    char *path;
    hid_t file;
    ovr_result_info info;
    ovr_variable x, time;
    ovr_variable field[OVR_FIELD_COUNT];
    ovr_variable *column;
    size_t fields, columns;
    bool starved; /* a text did not fit into memory */
};

/* Opens the file (again); the counts and lists of `r` stay. */
ovr_status ovr_reader_file(ovr_result *result, ovr_error *err);
void ovr_reader_close_file(ovr_result *result);

/* A turn between the writer's commits; a negative number: nobody writes. */
int ovr_reader_enter(const ovr_result *result);
void ovr_reader_leave(int turn);

/* Before the next attempt: the writer's bursts take milliseconds. */
void ovr_reader_pause(int attempt);

/* A dataset by its path, or -1: no links out of the file are followed. */
hid_t ovr_reader_dataset(hid_t file, const char *path);

/* Reads `count` elements from row `row` on of a one-dimensional dataset, or
 * row `row` of a two-dimensional one that is `count` wide. */
bool ovr_reader_part(hid_t set, hsize_t row, hsize_t count, double *values);

#endif
