/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data and functions of a run, shared by the files of this layer only. */
#ifndef OVR_RUN_INTERNAL_H
#define OVR_RUN_INTERNAL_H

#include "base/arena.h"
#include "overroll/run.h"
#include "results/results.h"
#include "run/companion.h"
#include "simulation/physics.h"

typedef struct ovr_passes ovr_passes; /* pass_series.h */

struct ovr_run {
    ovr_arena arena;
    ovr_run_options how;
    bool force; /* option `force`; passes replace their own files */
    ovr_case *c;
    ovr_setup *setup;
    ovr_simulation *sim;
    ovr_writer *writer; /* NULL: no result file */
    ovr_accompanied company[OVR_MAX_PHYSICS + 1];
    ovr_restart *restart; /* the resumed run; otherwise NULL */
    ovr_passes *passes;   /* NULL: a single run */
    bool resumed;         /* the case belongs to the run */
    const char *title;    /* from a resumed file; NULL: derived from the case */
    bool going, gone;     /* ovr_run_execute is active; has been called */
    bool restored;        /* state read from a checkpoint: no steady
                           * start */
    ovr_case_value *recorded; /* parameters recorded in the file of a resumed
                               * run */
    size_t recorded_count;
    const char **warning; /* `warnings_capacity` elements */
    size_t warnings_capacity;
    ovr_run_errors error;
    ovr_rough_film predicted;
    ovr_run_info info;
};

/* Creates a run with these options but without a case. Returns NULL if an
 * option is invalid. */
ovr_run *ovr_run_make(const ovr_run_options *options,
                      const ovr_allocator *allocator, ovr_error *err);

/* Creates a run without files that is not executed, for the keys of its
 * summary; of several passes, the first. */
ovr_run *ovr_run_unsolved(ovr_case *c, const ovr_run_options *options,
                          ovr_error *err);

/* Passes the lines of ovr_run_summary for a run that is not solved; their
 * values have no meaning. */
void ovr_run_keys(const ovr_run_info *run, ovr_summary_taker *take, void *data);

/* Sets the surface heights supplied by the caller, if any, instead of the
 * features. */
void ovr_run_surface(const ovr_run *run, ovr_simulation *sim);

/* Creates the simulation of the run's case and resolves the case if
 * necessary. */
ovr_status ovr_run_set_up(ovr_run *run, ovr_error *err);

/* Returns the time in seconds since an arbitrary moment. */
double ovr_run_clock(void);

/* Solves a prepared run to its end and closes its file. */
ovr_status ovr_run_once(ovr_run *run, ovr_error *err);

/* Estimates discretization errors from the same case on coarser levels. */
ovr_status ovr_run_estimate(ovr_run *run, ovr_error *err);

/* Issues a warning, prefixed with the pass ("pass 2: ") if there are
 * several. */
void ovr_run_warn(ovr_run *run, const char *format, ...) OVR_PRINTF(2, 3);

/* Forwards messages of a run and stores the first warnings. */
ovr_listener ovr_run_message;

/* Restores the warnings of the run before it was stopped, one per line. */
void ovr_run_recall(ovr_run *run, const char *warnings);

/* Adds the results of a gear pair, cam or bearing to the run's summary. */
void ovr_element_summary(const ovr_run_info *run, ovr_summary_taker *take,
                         void *data);

/* Returns the finite numbers of the summary except the number of snapshots and
 * the computing time, or NULL without memory. */
const ovr_group_attribute *ovr_run_numbers(const ovr_run *run, ovr_arena *arena,
                                           size_t *count, ovr_error *err);

/* Stores the numbers of the summary in the result file. */
ovr_status ovr_run_keep_summary(ovr_run *run, ovr_error *err);

/* Stores the operating conditions along the path of contact of a gear pair or
 * cam in the group `element`. */
ovr_status ovr_run_keep_element(ovr_run *run, ovr_error *err);

/* Estimates the errors on a level that was chosen for an accuracy, and warns if
 * they are larger or unknown; fails only if stopped. */
ovr_status ovr_run_confirm(ovr_run *run, ovr_error *err);

/* Report the warnings before and after the solution. */
void ovr_run_review_before(ovr_run *run);
void ovr_run_review_after(ovr_run *run);

/* Size of lubricant molecules in metres. Thinner films are not a continuum. */
#define OVR_MOLECULE 1e-9

/* Sliding friction coefficient that no lubricant reaches. Powers are not
 * reported if the computed coefficient is larger. */
#define OVR_IMPOSSIBLE_FRICTION 1.0

/* Fails if the result file cannot be created; called before anything is
 * solved. */
ovr_status ovr_output_check(const char *path, const ovr_case *c, bool force,
                            ovr_error *err);

/* Creates the result file and its writer. Checkpoints will contain the state of
 * the simulation. */
ovr_status ovr_output_open(ovr_run *run, ovr_error *err);

/* Returns all parameters of a case that have a value, as recorded in result
 * files. */
ovr_case_value *ovr_run_values(const ovr_case *c, ovr_arena *arena,
                               size_t *count);

/* Reopens the file of an earlier run to resume it. Checks that the physics is
 * the same, reads the checkpoint into the simulation and, if `write`, opens the
 * file for writing. */
ovr_status ovr_output_reopen(ovr_run *run, bool write, ovr_error *err);

#endif
