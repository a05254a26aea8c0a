/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Searches that need several runs: the value of a key for which a result of the
 * run reaches a target; see overroll(1).
 *
 *     ovr_find_options how = {0};
 *     how.key = "feature.dent.depth";
 *     how.low = "0.01", how.high = "0.5";
 *     how.condition = "H_min_overall at least 0.05";
 *     how.which = "largest";
 *     ovr_find *find = ovr_find_create(c, &how, &err);
 *     if (find && !ovr_find_execute(find, &err))
 *         ... ovr_find_get_info(find)->value ...
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

/* Cases to be run, counted from 0, by forked processes or by an
 * `ovr_trial_runner` of the caller. The runner stores numbers with the keys of
 * ovr_run_summary, or the reason of a failure. */
typedef struct ovr_trials ovr_trials;
typedef ovr_status ovr_trial_runner(void *data, ovr_trials *trials,
                                    ovr_error *err);

/* NULL after the last. */
OVR_API ovr_case *ovr_trials_case(const ovr_trials *trials, size_t k);
/* As in ovr_run_options. */
OVR_API bool ovr_trials_steady(const ovr_trials *trials);
OVR_API bool ovr_trials_estimate(const ovr_trials *trials);
OVR_API void ovr_trials_put(ovr_trials *trials, size_t k, const char *key,
                            double number);
OVR_API void ovr_trials_fail(ovr_trials *trials, size_t k, const char *message);

/* Passes the numbers that follow from a case by formulas, with the keys of
 * `check --json`. */
OVR_API void ovr_setup_scales(const ovr_setup *setup, ovr_summary_taker *take,
                              void *data);

/* ------------------------------------------------------------------- find */

typedef struct ovr_find_options {
    const char *key;        /* "contact.load" */
    const char *low, *high; /* "50 kN/m"; a single unit applies to both */
    const char *condition;  /* "H_min is 0.3", "P_max_overall at most 2 GPa" */
    const char
        *which; /* "largest" or "smallest" value of the key, for inequalities */
    double tolerance; /* relative tolerance of the key; 0: 1e-3 */
    int workers;      /* simultaneous runs in the scan; 0: 1 */
    bool steady;      /* only the steady contact */
    const char
        *table; /* CSV table of the evaluations in their order, or NULL */
    bool go_on; /* do not repeat evaluations that the table contains */
    bool force; /* replace a table of another program */
    const char *
        results; /* folder for the result files of all runs, or NULL; results of
                    the same question in the folder are reused and resumed */
    void *data;
    ovr_listener *say;
    bool (*stop)(void *data);
    ovr_trial_runner *run; /* NULL: forked processes */
} ovr_find_options;

typedef enum ovr_find_end {
    OVR_FIND_FOUND,
    OVR_FIND_SCATTERED, /* found within the scatter of the quantity */
    OVR_FIND_MISSED,    /* no solution in the range */
    OVR_FIND_SEVERAL,   /* several solutions, and `which` is not set */
    OVR_FIND_FAILED     /* runs failed near the solution */
} ovr_find_end;

typedef struct ovr_find ovr_find;

/* Result of a search. Values of the key are in the unit of `low` and `high`. */
typedef struct ovr_find_info {
    const char *key, *quantity;
    const char *name;          /* full name of the quantity */
    const char *quantity_unit; /* "b^2/R", "Pa" or "" */
    const char *unit; /* unit of the values ("b" or similar for numbers without
                         a unit), or "" */
    const char *which;
    int sense; /* 0: is; 1: at least; -1: at most */
    double target;
    ovr_find_end end;
    const char *message; /* reason of a failure, or a remark, or "" */
    double value, at_value, low, high;
    double slope;   /* elasticity of the quantity with respect to the key */
    double error;   /* error of `value` due to the discretization error of the
                       quantity */
    double scatter; /* relative scatter of the quantity; NAN: unknown */
    bool monotone;
    bool marked; /* some runs have steps accepted above tolerance */
    bool exact;  /* computed by formulas, without runs */
    bool pinned; /* all runs were repeated with order = 2, because their orders
                    differed */
    size_t evaluations;
} ovr_find_info;

typedef struct ovr_find_evaluation {
    double value, quantity; /* NAN: the run failed */
    int order, level;
    bool converged;
    long marked;
    double seconds;
    const char *message; /* message of a failure, or "" */
} ovr_find_evaluation;

/* Checks the question completely and copies the case. */
OVR_API ovr_find *ovr_find_create(ovr_case *c, const ovr_find_options *options,
                                  ovr_error *err);

/* Runs the search. Without a unique solution the status is OVR_BAD_INPUT
 * (OVR_FIND_MISSED, OVR_FIND_SEVERAL) or OVR_NOT_CONVERGED (OVR_FIND_FAILED);
 * the evaluations are available in any case. */
OVR_API ovr_status ovr_find_execute(ovr_find *find, ovr_error *err);
OVR_API void ovr_find_free(ovr_find *find);
OVR_API const ovr_find_info *ovr_find_get_info(const ovr_find *find);

/* Returns evaluation k in the order of the values. */
OVR_API ovr_find_evaluation ovr_find_evaluation_at(const ovr_find *find,
                                                   size_t k);

/* Lines about the search, or about its answer: the value under the name of the
 * key, and the numbers of the run there. */
OVR_API void ovr_find_summary(const ovr_find *find, bool answer,
                              ovr_summary_taker *take, void *data);

/* ------------------------------------------------------------ sensitivity */

/* Elasticities d ln Q/d ln x of numbers of a run with respect to keys, by
 * central differences of 2 % and 1 %. The difference of both is the
 * uncertainty. Steps of this size move film rupture and pressure spike by
 * several mesh sizes; smaller steps would measure grid effects. */
typedef struct ovr_sensitivity_options {
    const char *keys; /* "contact.load, feature.dent.depth"; NULL: all numbers
                         that the case sets for contact, lubricant, bodies and
                         sizes of features */
    int workers;      /* simultaneous runs; 0: 1 */
    bool steady;      /* only the steady contact */
    bool estimate;    /* repeat on the next coarser level for comparison */
    void *data;
    ovr_listener *say;
    bool (*stop)(void *data);
    ovr_trial_runner *run; /* NULL: forked processes */
} ovr_sensitivity_options;

typedef struct ovr_sensitivity_row {
    const char *key, *quantity;
    const char *name; /* full name of the quantity */
    const char *unit; /* unit of the key of an absolute slope; NULL: the slope
                         is relative */
    double step;      /* the larger difference step, relative or in that unit */
    double slope;     /* derivative by the smaller step */
    double doubt;     /* difference of the derivatives by both steps */
    double coarser;   /* derivative one level coarser; NAN: not requested */
    const char *why_none; /* reason why the row is not reliable, or NULL */
} ovr_sensitivity_row;

typedef struct ovr_sensitivity ovr_sensitivity;

/* Makes all runs. */
OVR_API ovr_sensitivity *
ovr_sensitivity_create(ovr_case *c, const ovr_sensitivity_options *options,
                       ovr_error *err);
OVR_API void ovr_sensitivity_free(ovr_sensitivity *sensitivity);

/* Returns row k, ordered by keys and then quantities; NULL past the last. */
OVR_API const ovr_sensitivity_row *
ovr_sensitivity_at(const ovr_sensitivity *sensitivity, size_t k);

/* ----------------------------------------------------------------- random */

/* Statistics of the samples of a study with [random], for each combination of
 * its other keys. */
typedef struct ovr_sample ovr_sample;

enum { OVR_SAMPLE_QUANTILES = 7, OVR_SAMPLE_LIMITS = 4 };

typedef struct ovr_sample_row {
    /* Values of the other keys as in file names, "slide_to_roll=0.5", and for
     * people, "slide_to_roll = 0.5"; "" if no other key varies. */
    const char *group, *label;
    const char *quantity;
    const char *name, *unit; /* full name and unit ("b^2/R", "m" or "") */
    size_t draws, finished, failed, marked;
    size_t known; /* finished samples with a value; the following members refer
                     to these */
    int order[2], level[2]; /* minimum and maximum over the samples */
    double mean, sd;
    double error; /* standard error of the mean; NAN: unknown for this design */
    double factor; /* factor on `error` for 95 % confidence */
    /* quantiles with 95 % confidence intervals; NAN: no bound */
    double p[OVR_SAMPLE_QUANTILES], quantile[OVR_SAMPLE_QUANTILES];
    double low[OVR_SAMPLE_QUANTILES], high[OVR_SAMPLE_QUANTILES];
    size_t limits;
    int sense[OVR_SAMPLE_LIMITS]; /* 1: at least; -1: at most */
    double limit[OVR_SAMPLE_LIMITS];
    /* Probability that the limit is satisfied, and its 95 % confidence
     * interval, in which failed samples may count either way. */
    double P[OVR_SAMPLE_LIMITS], P_low[OVR_SAMPLE_LIMITS];
    double P_high[OVR_SAMPLE_LIMITS];
    size_t inputs;
} ovr_sample_row;

/* Effect of a random key on a quantity, with 95 % confidence intervals. */
typedef struct ovr_sample_input {
    const char *key;
    bool related; /* sampled together with other keys: no share of the variance
                   */
    double share, share_low,
        share_high; /* share of the variance due to this key alone */
    double rho, rho_low, rho_high; /* Spearman's rank correlation */
    double lowest, highest; /* mean of the quantity at the lowest and highest
                               values of the key */
} ovr_sample_input;

/* Computes the statistics from the current files of the study. `quantities`
 * are separated by commas; NULL: those of [limits], the key of [find], minimum
 * film thickness and maximum pressure. */
OVR_API ovr_sample *ovr_study_sample(const ovr_study *study,
                                     const char *quantities, ovr_error *err);
OVR_API void ovr_sample_free(ovr_sample *sample);
OVR_API const ovr_sample_row *ovr_sample_at(const ovr_sample *sample, size_t k);
OVR_API const ovr_sample_input *ovr_sample_input_at(const ovr_sample *sample,
                                                    size_t row, size_t k);

/* Writes the rows as CSV. An existing file of another program is replaced only
 * with `force`. */
OVR_API ovr_status ovr_sample_write(const ovr_sample *sample, const char *path,
                                    bool force, ovr_error *err);

/* True if the study has [random]. */
OVR_API bool ovr_study_random(const ovr_study *study);

#ifdef __cplusplus
}
#endif

#endif
