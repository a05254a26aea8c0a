/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Questions whose answer takes several runs: the value of a key for which a
 * number of the run has a value; see overroll(1).
 *
 *     ovr_find_options how = ovr_find_options_default();
 *     how.key = "feature.dent.depth";
 *     how.low = "0.01", how.high = "0.5";
 *     how.condition = "H_min_overall at least 0.05";
 *     how.which = "largest";
 *     ovr_find *find = ovr_find_create(c, &how, &err);
 *     if (find && !ovr_find_go(find, &err))
 *         ... ovr_find_about(find)->value ...
 *     ovr_find_free(find);
 */
#ifndef OVERROLL_QUESTIONS_H
#define OVERROLL_QUESTIONS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/case.h"
#include "overroll/error.h"
#include "overroll/run.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ----------------------------------------------------------------- trials */

/* Cases whose numbers are wanted, counted from 0: run by processes forked here,
 * or by one's own `ovr_trial_runner`, which puts numbers in, by the keys of
 * ovr_run_summary, or says why there are none. */
typedef struct ovr_trials ovr_trials;
typedef ovr_status ovr_trial_runner(void *data, ovr_trials *trials,
                                    ovr_error *err);

OVR_API size_t ovr_trials_count(const ovr_trials *trials);
OVR_API ovr_case *ovr_trials_case(const ovr_trials *trials, size_t k);
/* As of ovr_run_options. */
OVR_API bool ovr_trials_steady(const ovr_trials *trials);
OVR_API bool ovr_trials_estimate(const ovr_trials *trials);
OVR_API void ovr_trials_put(ovr_trials *trials, size_t k, const char *key,
                            double number);
OVR_API void ovr_trials_fail(ovr_trials *trials, size_t k, const char *message);

/* What follows from a case by formulas alone, by the keys of `check --json`. */
OVR_API void ovr_setup_scales(const ovr_setup *setup, ovr_summary_taker *take,
                              void *data);

/* ------------------------------------------------------------------- find */

typedef struct ovr_find_options {
    size_t size;            /* of this struct, as its user knows it */
    const char *key;        /* "contact.load" */
    const char *low, *high; /* "50 kN/m"; one unit may stand for both */
    const char *condition;  /* "H_min is 0.3", "P_max_overall at most 2 GPa" */
    const char *which;      /* of an inequality: "largest" or "smallest" */
    double tolerance;       /* of the key, relative; 0: 1e-3 */
    int workers;            /* at once in the scan; 0: 1 */
    bool steady;            /* the steady contact alone */
    const char *table;      /* CSV of the evaluations, as they come; or NULL */
    bool go_on;             /* those that it holds are not run again */
    void *data;
    ovr_listener *say;
    bool (*stop)(void *data);
    ovr_trial_runner *run; /* NULL: here */
} ovr_find_options;
OVR_SIZED(ovr_find_options)

typedef enum ovr_find_end {
    OVR_FIND_FOUND,
    OVR_FIND_SCATTERED, /* found as well as its scatter lets it be */
    OVR_FIND_MISSED,    /* no answer between the ends */
    OVR_FIND_SEVERAL,   /* several, and neither largest nor smallest wanted */
    OVR_FIND_FAILED     /* runs failed where the answer lies */
} ovr_find_end;

typedef struct ovr_find ovr_find;

/* In the unit of the key as `low` and `high` have it. */
typedef struct ovr_find_info {
    size_t size; /* of this struct */
    const char *key, *quantity;
    const char *unit; /* of the values; of a bare number "b", ...; "" */
    const char *which;
    int sense; /* 0: is; 1: at least; -1: at most */
    double target;
    ovr_find_end end;
    const char *message; /* why there is none, or what is to be known; "" */
    double value, at_value, low, high;
    double slope;   /* of the quantity */
    double error;   /* of `value` by the quantity's discretization error */
    double scatter; /* relative, of the quantity; NAN: not known */
    bool monotone;
    bool marked; /* some runs have marked steps */
    bool exact;  /* by formulas, nothing was run */
    bool pinned; /* all again with order = 2, since orders differed */
    size_t evaluations;
} ovr_find_info;

typedef struct ovr_find_evaluation {
    size_t size;            /* of this struct */
    double value, quantity; /* NAN: it failed */
    int order, level;
    bool converged;
    long marked;
    double seconds;
    const char *message; /* of a failure; "" */
} ovr_find_evaluation;

/* All that can be refused is refused here.  The case is copied. */
OVR_API ovr_find *ovr_find_create(ovr_case *c, const ovr_find_options *options,
                                  ovr_error *err);

/* That there is no answer is a status too: OVR_BAD_INPUT (missed, several) or
 * OVR_NOT_CONVERGED (runs failed), with the evaluations to be looked at. */
OVR_API ovr_status ovr_find_go(ovr_find *find, ovr_error *err);
OVR_API void ovr_find_free(ovr_find *find);
OVR_API const ovr_find_info *ovr_find_about(const ovr_find *find);

/* Evaluations in the order of the values. */
OVR_API void ovr_find_evaluation_into(const ovr_find *find, size_t k,
                                      ovr_find_evaluation *evaluation);
static inline ovr_find_evaluation ovr_find_evaluation_at(const ovr_find *find,
                                                         size_t k)
{
    ovr_find_evaluation evaluation;
    evaluation.size = sizeof evaluation;
    ovr_find_evaluation_into(find, k, &evaluation);
    return evaluation;
}

/* The numbers of the run at the answer. */
OVR_API void ovr_find_summary(const ovr_find *find, ovr_summary_taker *take,
                              void *data);

#ifdef __cplusplus
}
#endif

#endif
