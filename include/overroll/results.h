/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reading result files: HDF5 that is also netCDF-4, written during the run and
 * readable at the same time. Layout: see overroll-result(5).
 */
#ifndef OVERROLL_RESULTS_H
#define OVERROLL_RESULTS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/contact.h"
#include "overroll/error.h"
#include "overroll/memory.h"
#include "overroll/simulation.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { OVR_MAX_RANK = 4 }; /* maximum number of dimensions of a dataset */

/*
 * A file may be read while it is written.  The rows counted when the file was
 * opened are complete and can be read; open the file again for later rows.  A
 * read that collides with the writer is repeated a few times.
 */
typedef struct ovr_result ovr_result;

/* The contents of a file.  Texts are owned by the result. */
typedef struct ovr_result_info {
    const char *title, *status;     /* running, complete, stopped, failed */
    const char *reason;             /* reason of a failure, or "" */
    const char *source;             /* program and version */
    const char *created, *modified; /* dates, ISO 8601 */
    const char *case_text;          /* the case file the run was made from */
    bool physical;                  /* stored in SI, otherwise dimensionless */
    double b, ph, height, time;     /* scales in SI; NAN: unknown */
    double M, L, alphabar, lambda;
    double u1_ratio, u2_ratio;
    double end;           /* end time of the run, b/u_m; NAN: unknown */
    double seconds;       /* wall-clock time, once the run has ended */
    size_t nodes;         /* stored nodes along x */
    size_t lines;         /* lines of a strip; 1: a line contact */
    double width;         /* width of a strip, b; 0: line contact */
    size_t snapshots;     /* complete rows */
    size_t steps;         /* rows of history */
    const char *warnings; /* warnings, one per line, or "" */
} ovr_result_info;

OVR_API ovr_result *ovr_result_open(const char *path,
                                    const ovr_allocator *allocator,
                                    ovr_error *err);
OVR_API void ovr_result_close(ovr_result *result);
OVR_API const ovr_result_info *ovr_result_get_info(const ovr_result *result);

/* A variable of the file: x, time, a field of the snapshots, a column of the
 * history, or what another program version stores in groups of its own. */
typedef struct ovr_variable {
    const char *name, *long_name;
    const char *unit;   /* unit as stored; dimensionless: "1" */
    double scale;       /* SI value of a dimensionless 1; NAN: unknown */
    ovr_unit_kind kind; /* OVR_KINDS: unknown to this version */
    const char *path;   /* "pressure", "history/load" */
    int rank;           /* number of dimensions */
    /* Lengths of the dimensions; the first is the number of complete rows. */
    size_t shape[OVR_MAX_RANK];
} ovr_variable;

/* Returns a variable by its path, or NULL. */
OVR_API const ovr_variable *ovr_result_find(const ovr_result *result,
                                            const char *path);

/* Converts a length, height, pressure or time such as "0.2 ms" or "-0.1mm" to
 * the Hertzian units of the result. A number without a unit is in Hertzian
 * units. */
OVR_API ovr_status ovr_result_number(const ovr_result *result,
                                     ovr_unit_kind kind, const char *text,
                                     double *value, ovr_error *err);

/* Parses a number without a unit; the decimal separator is a point in every
 * locale. Returns false if the text is not a number. */
OVR_API bool ovr_bare_number(const char *text, double *value);

/* Number of fields of each snapshot ("pressure", ...), field k, and column k
 * of the history ("time", "min_film_thickness", ...); NULL past the end. */
OVR_API size_t ovr_result_fields(const ovr_result *result);
OVR_API const ovr_variable *ovr_result_field(const ovr_result *result,
                                             size_t k);
OVR_API const ovr_variable *ovr_result_column(const ovr_result *result,
                                              size_t k);

/* An input file named in the case; several keys may name the same file. */
typedef struct ovr_result_input {
    const char *key;    /* first key that names it: "feature scratch.file" */
    const char *name;   /* file name as written in the case */
    const char *sha256; /* hexadecimal; "" if it was not an ordinary file */
    double bytes;       /* size; NAN: unknown */
    bool kept;          /* the result file contains a copy */
} ovr_result_input;

/* Returns input k, or NULL past the end. */
OVR_API const ovr_result_input *ovr_result_input_at(const ovr_result *result,
                                                    size_t k);

/* Units of returned values: as stored, dimensionless, or SI, which fails with
 * OVR_BAD_INPUT if the scales are unknown. */
typedef enum ovr_units { OVR_AS_STORED, OVR_HERTZIAN, OVR_SI } ovr_units;

/* Read x[0..nodes-1], the times of the snapshots, one field of snapshot k, and
 * one column of the history (`steps` values). OVR_BAD_INPUT: no such field,
 * snapshot or column; OVR_IO: the file is damaged. */
OVR_API ovr_status ovr_result_x(ovr_result *result, ovr_units units, double *x,
                                ovr_error *err);
OVR_API ovr_status ovr_result_times(ovr_result *result, ovr_units units,
                                    double *times, ovr_error *err);
OVR_API ovr_status ovr_result_snapshot(ovr_result *result, const char *field,
                                       size_t k, ovr_units units,
                                       double *values, ovr_error *err);
/* Read y[0..lines-1] of a strip, and one field of snapshot k, line after line
 * of `nodes` values.  A line contact has one line at y = 0. */
OVR_API ovr_status ovr_result_y(ovr_result *result, ovr_units units, double *y,
                                ovr_error *err);
OVR_API ovr_status ovr_result_areal(ovr_result *result, const char *field,
                                    size_t k, ovr_units units, double *values,
                                    ovr_error *err);

/* Selects the line nearest to *Y (b) for ovr_result_snapshot and sets *Y to
 * its position. NAN: the line of strip.shown. */
OVR_API ovr_status ovr_result_across(ovr_result *result, double *Y,
                                     ovr_error *err);

OVR_API ovr_status ovr_result_history(ovr_result *result, const char *name,
                                      ovr_units units, double *values,
                                      ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
