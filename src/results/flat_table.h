/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A table as a netCDF-4 file: one dimension, numbered from one, and variables
 * of numbers or texts with this dimension. Functions that can fail return
 * false, and print nothing between ovr_h5_quiet and ovr_h5_restore.
 */
#ifndef OVR_RESULTS_FLAT_TABLE_H
#define OVR_RESULTS_FLAT_TABLE_H

#include "base/arena.h"
#include "results/h5.h"

typedef struct ovr_flat {
    size_t count;
    hid_t file, space, properties, text, scale;
} ovr_flat;

/* Creates a file with the dimension `name`. ovr_flat_end must be called even
 * after a failure. */
bool ovr_flat_begin(ovr_flat *rows, const char *path, const char *name,
                    const char *about, size_t count, ovr_arena *arena);

/* Write variables with one element per row; `unit` "1": dimensionless. */
bool ovr_flat_numbers(const ovr_flat *rows, const char *name, const char *unit,
                      const char *about, const double *values);
bool ovr_flat_texts(const ovr_flat *rows, const char *name, const char *about,
                    const char *const *texts);

/* Adds another attribute to a variable. */
bool ovr_flat_note(const ovr_flat *rows, const char *name, const char *key,
                   const char *text);

/* Writes the title, closes the file and syncs it to disk. `good`: no error so
 * far. */
bool ovr_flat_end(ovr_flat *rows, const char *path, const char *title,
                  bool good);

#endif
