/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several cases and the numbers of their runs, computed by forked processes, in
 * this process, by formulas, or by a function of the caller. */
#ifndef OVR_RUN_TRIALS_H
#define OVR_RUN_TRIALS_H

#include "base/arena.h"
#include "overroll/questions.h"

enum { OVR_TRIAL_LINES = 288, OVR_TRIAL_KEY = 48, OVR_TRIAL_MESSAGE = 400 };

/* Outcome of a trial; without pointers, because it may be in shared memory. */
typedef struct ovr_trial {
    bool done, failed;
    size_t lines;
    char key[OVR_TRIAL_LINES][OVR_TRIAL_KEY];
    double number[OVR_TRIAL_LINES];
    char message[OVR_TRIAL_MESSAGE];
} ovr_trial;

/* Options of the runs. */
typedef struct ovr_trial_plan {
    int workers;
    bool steady, estimate, formulas;
    const char *const *files; /* result file of each trial, which is resumed, or
                               * read if complete; NULL: none */
    void *data;
    bool (*stop)(void *data);
    ovr_trial_runner *run;
} ovr_trial_plan;

/* Creates `count` trials, to be freed by ovr_trials_free; they own the
 * cases. */
ovr_trials *ovr_trials_create(size_t count, ovr_case *const *cases,
                              const ovr_trial_plan *plan, ovr_error *err);
void ovr_trials_free(ovr_trials *trials);

/* Solves all trials. Returns OVR_STOPPED or the error of a callback; a failed
 * run is recorded in its trial only. */
ovr_status ovr_trials_execute(ovr_trials *trials, ovr_error *err);

size_t ovr_trials_count(const ovr_trials *trials);
const ovr_trial *ovr_trials_at(const ovr_trials *trials, size_t k);

/* Returns the number of a key, or NAN. `known` (may be NULL) is false if there
 * is no such key. */
double ovr_trial_number(const ovr_trial *trial, const char *key, bool *known);

/* Finds the entry of a key, "contact.load" or "feature.dent.depth"; false if
 * there is none. */
bool ovr_case_entry_of(const ovr_case *c, const char *where, size_t length,
                       ovr_case_entry *e);

/* Returns a copy of the case without an output file. */
ovr_case *ovr_case_apart(ovr_case *c, ovr_error *err);

#endif
