/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several cases and the numbers of their runs, made by forked processes, in
 * this one, by formulas, or by somebody else's function. */
#ifndef OVR_RUN_TRIALS_H
#define OVR_RUN_TRIALS_H

#include "base/arena.h"
#include "overroll/questions.h"

enum { OVR_TRIAL_LINES = 288, OVR_TRIAL_KEY = 48, OVR_TRIAL_MESSAGE = 400 };

/* The outcome of one; flat, since it may lie in shared memory. */
typedef struct ovr_trial {
    bool done, failed;
    size_t lines;
    char key[OVR_TRIAL_LINES][OVR_TRIAL_KEY];
    double number[OVR_TRIAL_LINES];
    char message[OVR_TRIAL_MESSAGE];
} ovr_trial;

/* Options of how they are to be run. */
typedef struct ovr_trial_plan {
    int workers;
    bool steady, estimate, formulas;
    const char *const *files; /* results of each: what lies there is resumed, or
                                 read where it is complete; NULL: none */
    void *data;
    bool (*stop)(void *data);
    ovr_trial_runner *run;
} ovr_trial_plan;

/* `count` trials to be freed by ovr_trials_free; the cases become theirs. */
ovr_trials *ovr_trials_create(size_t count, ovr_case *const *cases,
                              const ovr_trial_plan *plan, ovr_error *err);
void ovr_trials_free(ovr_trials *trials);

/* OVR_STOPPED, or what somebody else's function returned; a failed run is no
 * failure of them all. */
ovr_status ovr_trials_execute(ovr_trials *trials, ovr_error *err);

size_t ovr_trials_count(const ovr_trials *trials);
const ovr_trial *ovr_trials_at(const ovr_trials *trials, size_t k);

/* The number of a key; NAN: there is none, which `known` (may be NULL) tells
 * from one that is not known. */
double ovr_trial_number(const ovr_trial *trial, const char *key, bool *known);

/* The entry of a key, "contact.load" or "feature.dent.depth"; false: there is
 * none. */
bool ovr_case_entry_of(const ovr_case *c, const char *where, size_t length,
                       ovr_case_entry *e);

/* A copy of the case without an output file. */
ovr_case *ovr_case_apart(ovr_case *c, ovr_error *err);

#endif
