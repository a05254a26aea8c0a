/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writer of result files, their checkpoints, and functions for reading used
 * only within the library. */
#ifndef OVR_RESULTS_RESULTS_H
#define OVR_RESULTS_RESULTS_H

#include "overroll/results.h"
#include "results/checkpoint.h"

/* Default fields of a snapshot, as bits: pressure, film thickness and surface
 * height. */
enum { OVR_FIELDS_DEFAULT = 7 };

typedef struct ovr_writer ovr_writer;

/* The end of a run: the file's attribute `status`. */
typedef enum ovr_run_status {
    OVR_RUN_RUNNING,
    OVR_RUN_COMPLETE,
    OVR_RUN_STOPPED,
    OVR_RUN_FAILED
} ovr_run_status;

/* A file used by the case, stored in the result if it has at most OVR_INPUT_MAX
 * bytes. */
enum { OVR_INPUT_MAX = 4 << 20 };
typedef struct ovr_input {
    const char *key;  /* "feature scratch.file" */
    const char *name; /* path as given in the case */
    const char *path; /* path relative to the working directory */
    size_t first;     /* index of the first input with this path */
} ovr_input;

/* Options of a writer. A snapshot is stored whenever one of three schedules
 * requires it. `times` and multiples of every_time are reached exactly if the
 * march uses ovr_writer_next_time. */
typedef struct ovr_write_options {
    const char *path;  /* OUT.h5 */
    bool force;        /* replace an existing file */
    long every_steps;  /* steps between snapshots; 0: not by steps */
    double every_time; /* time between snapshots, b/u_m; 0: not by time */
    size_t time_count; /* times of snapshots in any order, b/u_m; copied */
    const double *times;
    unsigned fields;            /* bits from ovr_field_bit */
    bool single;                /* single precision instead of double */
    double x_from, x_to;        /* window in X; NAN: the whole domain */
    size_t stride;              /* stores every stride-th node; default 1 */
    int deflate;                /* compression level, 0 (none) to 9; default
                                 * 1 */
    double flush_interval;      /* minimum time between flushes in s; default
                                 * 0.5 */
    double checkpoint_interval; /* time between checkpoints in s; default 30; <=
                                 * 0: only at the end */
    bool no_thread;             /* compress and write in the calling thread */
    double end;                 /* end time of the run, b/u_m; NAN: unknown */
    const char *title;          /* NULL: a default title */
    const char *case_text;      /* NULL: none */
    const char *case_path;      /* folder of the case's relative paths */
    size_t value_count;
    const ovr_case_value *values;
    size_t input_count; /* input files of the case, read when the file is
                         * created or reopened */
    const ovr_input *inputs;
    unsigned physics; /* from ovr_setup_physics; selects the history columns */
    size_t lines;     /* lines of a strip; 0 or 1 for a line contact */
    const double *Y;  /* positions of the lines, b */
    size_t shown;     /* line shown by readers by default */
    double width;     /* width of a strip, b */
} ovr_write_options;

/* State of a simulation at one time. `field` is called at snapshots for stored
 * fields only; it returns values as in ovr_observable, either existing or
 * computed in `workspace`. */
typedef struct ovr_frame {
    const ovr_state *state;
    const ovr_observation *seen;
    const double *(*field)(const void *source, const ovr_observable *which,
                           double *workspace);
    const void *source;
    /* Selects the line of a strip for which `field` returns values; the shown
     * line if the number is beyond the last. */
    void (*show)(void *shown, size_t line);
    void *shown;
    const ovr_statistics *total; /* extremes of the run; or NULL */
} ovr_frame;

/* A separate group such as "fatigue/surface_1" for data that are not given at
 * the nodes of the film. Values are dimensionless; the file stores them in its
 * units. An axis without values is the time of appended rows. */
typedef struct ovr_group_axis {
    const char *name, *long_name;
    ovr_unit_kind kind;
    size_t count;
    const double *values;
} ovr_group_axis;

/* An array along some of the axes: flags, floats, doubles, or rows that are
 * appended later. */
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

typedef struct ovr_group {
    const char *path;
    size_t axes, arrays, attributes;
    const ovr_group_axis *axis;
    const ovr_group_array *array;
    const ovr_group_attribute *attribute;
} ovr_group;

/* Returns the bit of a field in a set of stored fields; 0 for an unknown
 * name. */
unsigned ovr_field_bit(const char *name);

/* Computes the steps between snapshots for a run to `end`.  The run has about
 * 250 snapshots, fewer above 64 MB in memory (a strip: 256 MB). */
long ovr_write_every(const ovr_write_options *options, double end, double dT,
                     size_t nodes);

/* Creates the file (under a temporary name until its headers are on disk) for a
 * run with the nodes X[0..n-1] and allocates all memory. Fails with
 * OVR_BAD_INPUT for an existing file without `force`, an unwritable folder or a
 * file written by another process. */
ovr_writer *ovr_writer_create(const ovr_write_options *options,
                              const ovr_contact *contact, size_t n,
                              const double *X, const ovr_allocator *allocator,
                              ovr_error *err);

/* Records a state: a history row, and a snapshot if due. */
ovr_status ovr_writer_record(ovr_writer *writer, const ovr_frame *given,
                             ovr_error *err);

/* The writer as an observer of a march; the function that it calls. */
ovr_observer ovr_writer_observer(ovr_writer *writer);
ovr_status ovr_writer_observe(void *writer, const ovr_simulation *sim,
                              ovr_error *err);
/* True if the state of this step at T will be stored. The second function
 * returns the next time to be reached exactly. */
bool ovr_writer_stores(const ovr_writer *writer, long step, double T);
double ovr_writer_next_time(void *writer, double T);

/* Writes all buffered data and makes them visible to readers. */
ovr_status ovr_writer_flush(ovr_writer *writer, ovr_error *err);

/* Sets the reason of a failure for the attribute `reason`; copied. */
void ovr_writer_reason(ovr_writer *writer, const char *reason);

/* Sets the warnings, one per line, for the attribute `warnings`; the text must
 * remain valid until the writer is closed. */
void ovr_writer_warnings(ovr_writer *writer, const char *warnings);

/* Closes the file and frees the writer, also if it returns an error. A complete
 * run stores its last state as a snapshot. A failed run stores the state of the
 * last time, or the last iterate of a steady start (converged = 0 in its
 * history row). *snapshots, unless NULL, becomes the number of snapshots in the
 * file. */
ovr_status ovr_writer_close(ovr_writer *writer, ovr_run_status run,
                            size_t *snapshots, ovr_error *err);

/* Opens the checkpoint of a result file. Fails with OVR_BAD_INPUT if it belongs
 * to another run, is damaged or was written by another version. */
ovr_restart *ovr_restart_open(const char *result_path,
                              const ovr_allocator *allocator, ovr_error *err);
void ovr_restart_close(ovr_restart *restart);
const ovr_restart_info *ovr_restart_get_info(const ovr_restart *restart);

/* Loads the state into a simulation created with the same options. */
ovr_status ovr_restart_load(ovr_restart *restart, ovr_simulation *sim,
                            ovr_error *err);

/* Sets the simulation saved in checkpoints, every checkpoint_interval and at
 * the end; it must remain valid. */
void ovr_writer_checkpoints(ovr_writer *writer, ovr_simulation *sim);

/* Resumes options->path. An interrupted last write is completed; rows after the
 * checkpoint are dropped and written again. If `restart` is NULL or has no
 * state, all rows are dropped. The stored fields may change, but not precision
 * and nodes. */
ovr_writer *ovr_writer_resume(const ovr_write_options *options,
                              const ovr_contact *contact, size_t n,
                              const double *X, const ovr_restart *restart,
                              const ovr_allocator *allocator, ovr_error *err);

/* True if an interrupted write had to be completed. */
bool ovr_writer_repaired(const ovr_writer *writer);

/* True if the file system has no locks, so that a second writer is not
 * prevented. */
bool ovr_writer_unlocked(const ovr_writer *writer);

/* Writes a group and replaces an existing one, unless `keep`. */
ovr_status ovr_writer_group(ovr_writer *writer, const ovr_group *given,
                            bool keep, ovr_error *err);

/* Writes row k of the time-dependent arrays, `count` floats each, one array
 * after the other. Later rows are dropped. */
ovr_status ovr_writer_append(ovr_writer *writer, const ovr_group *given,
                             size_t k, double T, const float *values,
                             size_t count, ovr_error *err);

/* Visits the state of an object, for checkpoints. */
typedef ovr_status ovr_visited(void *object, ovr_visit *visit, void *context,
                               ovr_error *err);

/* Adds further state to checkpoints. */
void ovr_writer_more(ovr_writer *writer, ovr_visited *more, void *object);
ovr_status ovr_restart_more(ovr_restart *restart, ovr_visited *more,
                            void *object, ovr_error *err);

/* Returns the result's scale of a kind: b, b^2/R, p_h or b/u_m; NAN if
 * unknown. */
double ovr_result_scale(const ovr_result_info *info, ovr_unit_kind kind);

/* Returns the numeric attributes of a group ("summary") in order; owned by the
 * result. NULL if there is no such group. */
const ovr_group_attribute *
ovr_result_attributes(ovr_result *result, const char *path, size_t *count);

/* Reads any variable by its path: one-dimensional ones completely, others row
 * `row`, whose size is the product of the other lengths. */
ovr_status ovr_result_read(ovr_result *result, const char *path, size_t row,
                           ovr_units units, double *values, ovr_error *err);

/* Reads whether the maximum pressure is flagged as not resolved by the grid: in
 * the summary, or without one in the history at that maximum. Versions before
 * 0.4.0 flag none. `arena` temporarily stores two columns. */
ovr_status ovr_result_unresolved(ovr_result *result, ovr_arena *arena,
                                 bool *unresolved, ovr_error *err);

/* Reads a stored input into `bytes`, which has input->bytes bytes; fails if its
 * SHA-256 differs. */
ovr_status ovr_result_input_read(ovr_result *result, size_t k,
                                 unsigned char *bytes, ovr_error *err);

/* Returns the index of the input of a key, "feature scratch.file"; the number
 * of inputs if there is none. */
size_t ovr_result_input_of(ovr_result *result, const char *key);

ovr_write_options ovr_write_options_default(void);

#endif
