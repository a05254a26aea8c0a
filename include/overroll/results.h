/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Result files: HDF5 that is also netCDF-4, written as the run goes, readable
 * while it is written.  Layout: see overroll-result(5) in the tree.
 */
#ifndef OVERROLL_RESULTS_H
#define OVERROLL_RESULTS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/contact.h"
#include "overroll/error.h"
#include "overroll/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- reader */

typedef struct ovr_result ovr_result;

/* What is in a file.  Texts are owned by the result. */
typedef struct ovr_result_info {
    const char *title, *status; /* running, complete, stopped, failed */
    const char *case_text;      /* the case file the run was made from */
    bool physical;              /* stored in SI; else dimensionless */
    double b, ph, height, time; /* scales, SI; NAN where unknown */
    double M, L, alphabar, lambda;
    size_t nodes;     /* stored nodes */
    size_t snapshots; /* complete rows */
    size_t steps;     /* rows of history */
} ovr_result_info;

OVR_API ovr_result *ovr_result_open(const char *path,
                                    const ovr_allocator *allocator,
                                    ovr_error *err);
OVR_API void ovr_result_close(ovr_result *result);
OVR_API const ovr_result_info *ovr_result_about(const ovr_result *result);

/* Fields stored for each snapshot: names "pressure", "film_thickness", ...;
 * returns the count, and the k-th name, long name and unit (or NULL). */
OVR_API size_t ovr_result_fields(const ovr_result *result);
OVR_API const char *ovr_result_field_name(const ovr_result *result, size_t k);
OVR_API const char *ovr_result_field_unit(const ovr_result *result, size_t k);

/* Units of a read: as stored, dimensionless, or SI (which fails with
 * OVR_BAD_INPUT when the file does not know the scale). */
typedef enum ovr_units { OVR_AS_STORED, OVR_HERTZIAN, OVR_SI } ovr_units;

/* x[0..nodes-1]; the snapshot times; one field of snapshot k; one column of
 * the history ("time", "min_film_thickness", ...), steps values. */
OVR_API ovr_status ovr_result_x(ovr_result *result, ovr_units units, double *x,
                                ovr_error *err);
OVR_API ovr_status ovr_result_times(ovr_result *result, ovr_units units,
                                    double *times, ovr_error *err);
OVR_API ovr_status ovr_result_snapshot(ovr_result *result, const char *field,
                                       size_t k, ovr_units units,
                                       double *values, ovr_error *err);
OVR_API ovr_status ovr_result_history(ovr_result *result, const char *name,
                                      ovr_units units, double *values,
                                      ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
