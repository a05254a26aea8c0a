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
#include "overroll/simulation.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- writer */

enum { OVR_MAX_RANK = 4 }; /* dimensions of what is in a file */

/* The fields of a snapshot unless others are asked for, as bits: pressure, film
 * thickness and roughness. */
enum { OVR_FIELDS_DEFAULT = 7 };

/* One parameter of the case, stored as an attribute of the group `case`. */
typedef struct ovr_case_value {
    const char *name; /* "contact.M" */
    const char *text; /* as in a case file: "20", "22 1/GPa" */
    double number;    /* value in SI, or bare; NAN: the text is stored */
    const char *unit; /* SI unit of the number, or NULL */
    bool physics;     /* another value is another solution: resume refuses */
} ovr_case_value;

typedef struct ovr_writer ovr_writer;

/* The end of a run: the file's attribute `status`. */
typedef enum ovr_run_status {
    OVR_RUN_RUNNING,
    OVR_RUN_COMPLETE,
    OVR_RUN_STOPPED,
    OVR_RUN_FAILED
} ovr_run_status;

/* A group of its own below the root, "fatigue/surface_1": what is not along
 * the nodes of the film.  Dimensionless values; the file has them in its units.
 * An axis without values is the time of rows that are appended. */
typedef struct ovr_group_axis {
    const char *name, *long_name;
    ovr_unit_kind kind;
    size_t count;
    const double *values;
} ovr_group_axis;

/* An array along some of the axes; flags, floats, doubles, or rows to come. */
typedef struct ovr_group_array {
    const char *name, *long_name;
    ovr_unit_kind kind;
    int rank, along[OVR_MAX_RANK];
    const unsigned char *flags;
    const float *singles;
    const double *doubles;
} ovr_group_array;

/* An attribute: a text, or (text NULL) a number. */
typedef struct ovr_group_attribute {
    const char *name, *text;
    double number;
} ovr_group_attribute;

/* Visits the state of an object, for checkpoints. */
typedef ovr_status ovr_visited(void *object, ovr_visit *visit, void *context,
                               ovr_error *err);

/* ---------------------------------------------------------------- reader */

/*
 * A file may be read while it is written: what is counted at the time of
 * opening is complete and can be read; to see more, open again.  A read that
 * meets the writer half-way is repeated by the library, a few times.
 */
typedef struct ovr_result ovr_result;

/* The contents of a file.  Texts are owned by the result. */
typedef struct ovr_result_info {
    const char *title, *status;     /* running, complete, stopped, failed */
    const char *reason;             /* why it failed, or "" */
    const char *source;             /* program and version */
    const char *created, *modified; /* dates, ISO 8601 */
    const char *case_text;          /* the case file the run was made from */
    bool physical;                  /* stored in SI; else dimensionless */
    double b, ph, height, time;     /* scales, SI; NAN where unknown */
    double M, L, alphabar, lambda;
    double u1_ratio, u2_ratio;
    double end;           /* time the run is to reach, b/um; NAN unknown */
    double seconds;       /* of wall time, as far as the run has ended */
    size_t nodes;         /* stored nodes along x */
    size_t lines;         /* lines of a strip; 1: a line contact */
    double width;         /* of a strip, b; 0: a line contact */
    size_t snapshots;     /* complete rows */
    size_t steps;         /* rows of history */
    const char *warnings; /* what was warned of, a line each, or "" */
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
    const char *unit;   /* as stored; "1": dimensionless */
    double scale;       /* SI value of the dimensionless 1; NAN unknown */
    ovr_unit_kind kind; /* OVR_KINDS: one that this version does not know */
    const char *path;   /* "pressure", "history/load" */
    int rank;           /* numbers of dimensions, and their lengths; */
    size_t shape[OVR_MAX_RANK]; /* first those rows that are complete */
} ovr_variable;

/* A variable by its path; NULL: there is none. */
OVR_API const ovr_variable *ovr_result_find(const ovr_result *result,
                                            const char *path);

/* A number as people write it, a length, height, pressure or time, in the
 * result's Hertzian units: "0.2 ms", "-0.1mm"; a bare one is Hertzian. */
OVR_API ovr_status ovr_result_number(const ovr_result *result,
                                     ovr_unit_kind kind, const char *text,
                                     double *value, ovr_error *err);

/* A number alone, with a point in every locale; false: the text is not one. */
OVR_API bool ovr_bare_number(const char *text, double *value);

/* The fields of each snapshot ("pressure", ...) and the columns of the
 * history ("time", "min_film_thickness", ...): the count, and the k-th; NULL
 * past the end. */
OVR_API size_t ovr_result_fields(const ovr_result *result);
OVR_API const ovr_variable *ovr_result_field(const ovr_result *result,
                                             size_t k);
OVR_API const ovr_variable *ovr_result_column(const ovr_result *result,
                                              size_t k);

/* An input file of the run, which the case names; several keys of a case may
 * name the same. */
typedef struct ovr_result_input {
    const char *key;  /* that names it first: "feature scratch.file" */
    const char *name; /* as the case gives it */
    const char
        *sha256;  /* hexadecimal; "" unless the file was an ordinary one */
    double bytes; /* its size; NAN: unknown */
    bool kept;    /* the result file holds its bytes */
} ovr_result_input;

/* The k-th input; NULL past the end. */
OVR_API const ovr_result_input *ovr_result_input_at(const ovr_result *result,
                                                    size_t k);

/* Units of a read: as stored, dimensionless, or SI (which fails with
 * OVR_BAD_INPUT when the file does not know the scale). */
typedef enum ovr_units { OVR_AS_STORED, OVR_HERTZIAN, OVR_SI } ovr_units;

/* x[0..nodes-1]; the snapshot times; one field of snapshot k; one column of
 * the history, steps values.  OVR_BAD_INPUT: there is no such thing; OVR_IO:
 * the file is damaged there. */
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

/* Chooses the line nearest to *Y (b), whose values ovr_result_snapshot returns,
 * and sets *Y to its place.  NAN: the line that [strip] shown names. */
OVR_API ovr_status ovr_result_across(ovr_result *result, double *Y,
                                     ovr_error *err);

OVR_API ovr_status ovr_result_history(ovr_result *result, const char *name,
                                      ovr_units units, double *values,
                                      ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
