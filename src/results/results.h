/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The writer of result files, their checkpoints, and what only the library
 * reads. */
#ifndef OVR_RESULTS_RESULTS_H
#define OVR_RESULTS_RESULTS_H

#include "overroll/results.h"
#include "results/checkpoint.h"

/* A file that the case names, kept in the result if it is not larger than
 * OVR_INPUT_MAX bytes. */
enum { OVR_INPUT_MAX = 4 << 20 };
typedef struct ovr_input {
    const char *key;  /* "feature scratch.file" */
    const char *name; /* as the case gives it */
    const char *path; /* from the working directory */
    size_t first;     /* the first input of the list with this path: itself, or
                         one before it */
} ovr_input;

/* Options of a writer: what is written, and when.  A snapshot is stored at
 * every moment that any of the three schedules names; `times` (and multiples of
 * every_time) are hit exactly when the march asks ovr_writer_next_time. */
typedef struct ovr_write_options {
    const char *path;  /* OUT.h5 */
    bool force;        /* replace an existing file */
    long every_steps;  /* 0: not by steps */
    double every_time; /* b/um; 0: not by time */
    size_t time_count; /* given times, any order, b/um; copied */
    const double *times;
    unsigned fields;            /* of ovr_field_bit */
    bool single;                /* f32 instead of f64 */
    double x_from, x_to;        /* window in X; NAN: the whole domain */
    size_t stride;              /* every so many nodes; 1 */
    int deflate;                /* 0 (no filters) to 9; 1 */
    double flush_interval;      /* s between flushes at least; 0.5 */
    double checkpoint_interval; /* s; <= 0: none on the way; 30 */
    bool no_thread;             /* compress and write in the caller's thread */
    double end;                 /* when the run will end, b/um; NAN unknown */
    const char *title;          /* NULL: a general one */
    const char *case_text;      /* NULL: none */
    const char *case_path;      /* where the case's relative paths start */
    size_t value_count;
    const ovr_case_value *values;
    size_t input_count; /* files that the case names; read when the file is
                           made, or opened again */
    const ovr_input *inputs;
    unsigned physics; /* of ovr_setup_physics: columns of the history */
    size_t lines;     /* of a strip; 0 or 1 of a line contact */
    const double *Y;  /* of the lines, b */
    size_t shown;     /* line that readers show by default */
    double width;     /* of a strip, b */
} ovr_write_options;

/* A frame is what a writer records.  `field` is asked at snapshots only, for
 * the fields that are stored: values as in ovr_observable, where they lie or in
 * `workspace`. */
typedef struct ovr_frame {
    const ovr_state *state;
    const ovr_observation *seen;
    const double *(*field)(const void *source, const ovr_observable *which,
                           double *workspace);
    const void *source;
    /* Makes `field` give the values of one line of a strip; of the shown line
     * if it is beyond the last. */
    void (*show)(void *shown, size_t line);
    void *shown;
    const ovr_statistics *total; /* extremes of the run; or NULL */
} ovr_frame;

typedef struct ovr_group {
    const char *path;
    size_t axes, arrays, attributes;
    const ovr_group_axis *axis;
    const ovr_group_array *array;
    const ovr_group_attribute *attribute;
} ovr_group;

/* The fields that a snapshot holds: a bit for each field of the observables,
 * ored; 0 for a name that is none. */
unsigned ovr_field_bit(const char *name);

/* Computes the steps between snapshots for a run to `end`.  The run has about
 * 250 snapshots, fewer above 64 MB in memory (a strip: 256 MB). */
long ovr_write_every(const ovr_write_options *options, double end, double dT,
                     size_t nodes);

/* Creates the file (under a temporary name until its headers are on disk) for
 * a run on the nodes X[0..n-1].  Everything is allocated here.  An existing
 * file without `force`, an unwritable place or a file that another process
 * writes give OVR_BAD_INPUT. */
ovr_writer *ovr_writer_create(const ovr_write_options *options,
                              const ovr_contact *contact, size_t n,
                              const double *X, const ovr_allocator *allocator,
                              ovr_error *err);

/* Records a moment. */
ovr_status ovr_writer_record(ovr_writer *writer, const ovr_frame *given,
                             ovr_error *err);

/* The writer as an observer of a march, and what it does. */
ovr_observer ovr_writer_observer(ovr_writer *writer);
ovr_status ovr_writer_observe(void *writer, const ovr_simulation *sim,
                              ovr_error *err);
/* True if the state of this step at T will be stored. */
bool ovr_writer_stores(const ovr_writer *writer, long step, double T);
double ovr_writer_next_time(void *writer, double T);

/* Writes out what is buffered and makes it visible to readers. */
ovr_status ovr_writer_flush(ovr_writer *writer, ovr_error *err);

/* Why the run failed, for the file's attribute `reason`; copied. */
void ovr_writer_reason(ovr_writer *writer, const char *reason);

/* Sets the warnings, lines ended by '\n', for the attribute `warnings`;
 * borrowed until the writer is closed. */
void ovr_writer_warnings(ovr_writer *writer, const char *warnings);

/* Ends the file and frees the writer, also when it returns an error.  A
 * complete run gets its last state as a snapshot, whatever the schedule.  A
 * failed run gets the state of the last time reached, or the last iterate of a
 * steady start (its row of the history has converged 0).  Stores the number of
 * snapshots in the file in *snapshots, which may be NULL. */
ovr_status ovr_writer_close(ovr_writer *writer, ovr_run_status run,
                            size_t *snapshots, ovr_error *err);

/* The checkpoint beside a result file; one that belongs to another run, is
 * damaged or was written by another version is OVR_BAD_INPUT. */
ovr_restart *ovr_restart_open(const char *result_path,
                              const ovr_allocator *allocator, ovr_error *err);
void ovr_restart_close(ovr_restart *restart);
const ovr_restart_info *ovr_restart_get_info(const ovr_restart *restart);

/* Loads the state into a simulation created with the same options. */
ovr_status ovr_restart_load(ovr_restart *restart, ovr_simulation *sim,
                            ovr_error *err);

/* The simulation whose state the writer's checkpoints hold: from now on
 * every checkpoint_interval, and at the end.  Borrowed. */
void ovr_writer_checkpoints(ovr_writer *writer, ovr_simulation *sim);

/* Resumes options->path: a cut last write is finished, rows behind the
 * checkpoint are dropped and will be written again.  `restart` NULL, or one
 * without a state: all rows are dropped.  What is stored may be chosen again,
 * except for precision and nodes, which the file has already. */
ovr_writer *ovr_writer_resume(const ovr_write_options *options,
                              const ovr_contact *contact, size_t n,
                              const double *X, const ovr_restart *restart,
                              const ovr_allocator *allocator, ovr_error *err);

/* True if resuming had to finish a cut write. */
bool ovr_writer_repaired(const ovr_writer *writer);

/* True if its file system has no locks: nothing keeps a second writer out. */
bool ovr_writer_unlocked(const ovr_writer *writer);

/* Makes the group, in place of one that is there; `keep`: that one stays. */
ovr_status ovr_writer_group(ovr_writer *writer, const ovr_group *given,
                            bool keep, ovr_error *err);

/* Row k of the arrays along time: each `count` floats, one array after the
 * other.  Rows behind it are dropped. */
ovr_status ovr_writer_append(ovr_writer *writer, const ovr_group *given,
                             size_t k, double T, const float *values,
                             size_t count, ovr_error *err);

/* More state for checkpoints, and back from one. */
void ovr_writer_more(ovr_writer *writer, ovr_visited *more, void *object);
ovr_status ovr_restart_more(ovr_restart *restart, ovr_visited *more,
                            void *object, ovr_error *err);

/* The k-th variable of all; NULL behind the last. */
const ovr_variable *ovr_result_variable(const ovr_result *result, size_t k);

/* Its scale of a kind of b, b^2/R, ph or b/um; NAN where it has none. */
double ovr_result_scale(const ovr_result_info *info, ovr_unit_kind kind);

/* Attributes of a group that are numbers, in their order: "summary".  Owned by
 * the result; NULL: no such group. */
const ovr_group_attribute *
ovr_result_attributes(ovr_result *result, const char *path, size_t *count);

/* Any variable by its path: all of it when it has one dimension, else row
 * `row`, the product of the other lengths. */
ovr_status ovr_result_read(ovr_result *result, const char *path, size_t row,
                           ovr_units units, double *values, ovr_error *err);

/* Reads whether the history flags its maximum pressure as not resolved by the
 * grid; versions before 0.4.0 flag none.  `arena` holds two columns
 * meanwhile. */
ovr_status ovr_result_unresolved(ovr_result *result, ovr_arena *arena,
                                 bool *unresolved, ovr_error *err);

/* Reads the bytes of an input that is kept into `bytes`, of input->bytes; fails
 * if they do not have its SHA-256.  NULL: the k-th input. */
ovr_status ovr_result_input_read(ovr_result *result, size_t k,
                                 unsigned char *bytes, ovr_error *err);

/* The number of the input that a key names, "feature scratch.file"; `count` of
 * inputs where it names none. */
size_t ovr_result_input_of(ovr_result *result, const char *key);

ovr_write_options ovr_write_options_default(void);

#endif
