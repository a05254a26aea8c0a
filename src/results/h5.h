/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * HDF5 without its error messages, and frequent sequences of its calls.
 * Functions that can fail return false. Nothing is printed: every public
 * function of this layer is enclosed in ovr_h5_quiet and ovr_h5_restore, which
 * preserve the caller's error handler.
 */
#ifndef OVR_RESULTS_H5_H
#define OVR_RESULTS_H5_H

#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct ovr_h5_handler {
    H5E_auto2_t function;
    void *data;
} ovr_h5_handler;

/* Turns off automatic error printing in this thread; returns the previous
 * handler. */
ovr_h5_handler ovr_h5_quiet(void);
void ovr_h5_restore(ovr_h5_handler before);

/* Releases a reference to an identifier of any kind; negative ones are
 * skipped. */
void ovr_h5_drop(hid_t id);

/* Returns file access properties: format of HDF5 1.8, without HDF5's own
 * locks. */
hid_t ovr_h5_access(void);

/* Attributes. CF attributes are fixed-length characters as written by the
 * netCDF library, because old readers accept nothing else. Other texts are
 * variable-length strings, which h5py returns as str. */
bool ovr_h5_set_chars(hid_t object, const char *name, const char *text);
bool ovr_h5_set_string(hid_t object, const char *name, const char *text);
bool ovr_h5_set_number(hid_t object, const char *name, double value);
bool ovr_h5_set_integer(hid_t object, const char *name, int value);

/* Change the values of existing attributes. */
bool ovr_h5_change_string(hid_t object, const char *name, const char *text);
bool ovr_h5_change_number(hid_t object, const char *name, double value);

/* Write a text or number attribute, which may already exist. */
bool ovr_h5_put_string(hid_t object, const char *name, const char *text);
bool ovr_h5_put_number(hid_t object, const char *name, double value);

#endif
