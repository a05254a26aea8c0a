/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run is made of this; shared by the files of this floor only. */
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
    bool force; /* as in the options given; passes replace their own files */
    ovr_case *c;
    ovr_setup *setup;
    ovr_simulation *sim;
    ovr_writer *writer; /* NULL: nothing is stored */
    ovr_accompanied company[OVR_MAX_PHYSICS + 1];
    ovr_restart *restart;     /* of a run resumed */
    ovr_passes *passes;       /* NULL: one */
    bool resumed;             /* the case is its own */
    const char *title;        /* of a resumed run's file; NULL: by its case */
    bool going, gone;         /* ovr_run_execute is under way, was called */
    bool restored;            /* the state is a checkpoint's: no steady start */
    ovr_case_value *recorded; /* of a resumed run: what its file says */
    size_t recorded_count;
    const char **warning; /* space for so many */
    size_t warnings_capacity;
    ovr_run_errors error;
    ovr_rough_film predicted;
    ovr_run_info info;
};

/* An empty run with the options; NULL: they are not ones. */
ovr_run *ovr_run_make(const ovr_run_options *options,
                      const ovr_allocator *allocator, ovr_error *err);

/* Heights of the user, where there are any, in place of the features. */
void ovr_run_surface(const ovr_run *run, ovr_simulation *sim);

/* The simulation of its case, which is resolved if it was not. */
ovr_status ovr_run_set_up(ovr_run *run, ovr_error *err);

/* Seconds, from any moment on. */
double ovr_run_clock(void);

/* Solves what is set up to its end, and closes its file. */
ovr_status ovr_run_once(ovr_run *run, ovr_error *err);

/* The discretization errors, from the same case one level coarser. */
ovr_status ovr_run_estimate(ovr_run *run, ovr_error *err);

/* Warns of it: "pass 2: " and so on, where there are several. */
void ovr_run_warn(ovr_run *run, const char *format, ...) OVR_PRINTF(2, 3);

/* Forwards messages of a run and stores the first warnings. */
ovr_listener ovr_run_message;

/* Restores the warnings of the run before it was stopped, one per line. */
void ovr_run_recall(ovr_run *run, const char *warnings);

/* Sums up a gear pair, cam or bearing as a part of the run's summary. */
void ovr_element_summary(const ovr_run_info *run, ovr_summary_taker *take,
                         void *data);

/* The numbers of its summary into its file. */
ovr_status ovr_run_keep_summary(ovr_run *run, ovr_error *err);

/* Keeps in the group `element` what a gear pair's or cam's contact goes
 * through. */
ovr_status ovr_run_keep_element(ovr_run *run, ovr_error *err);

/* Estimates the errors on a level that was chosen for an accuracy, and warns if
 * they are larger or unknown; fails only if stopped. */
ovr_status ovr_run_confirm(ovr_run *run, ovr_error *err);

/* Report the warnings before and after the solution. */
void ovr_run_review_before(ovr_run *run);
void ovr_run_review_after(ovr_run *run);

/* Size of lubricant molecules, m: thinner films are no continuum. */
#define OVR_MOLECULE 1e-9

/* Sliding friction coefficient that no lubricant bears: powers of a run that
 * reaches it are not given. */
#define OVR_IMPOSSIBLE_FRICTION 1.0

/* Fails unless the file can be made; said before anything is solved. */
ovr_status ovr_output_check(const char *path, const ovr_case *c, bool force,
                            ovr_error *err);

/* The writer of a new file; its checkpoints will hold the simulation's state.
 */
ovr_status ovr_output_open(ovr_run *run, ovr_error *err);

/* Every parameter of a case with a value, as files record them. */
ovr_case_value *ovr_run_values(const ovr_case *c, ovr_arena *arena,
                               size_t *count);

/* The file of an earlier run, resumed: first what may be refused (another
 * physics), then the checkpoint's state into the simulation, then, to write,
 * the file. */
ovr_status ovr_output_reopen(ovr_run *run, bool write, ovr_error *err);

#endif
