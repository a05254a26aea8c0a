/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Questions whose answer takes several runs: the value of a key for which a
 * number of the run has a value; see overroll(1).
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

/* Cases whose numbers are requested, counted from 0: run by processes forked
 * here, or by one's own `ovr_trial_runner`, which puts numbers in, by the keys
 * of ovr_run_summary, or says why there are none. */
typedef struct ovr_trials ovr_trials;
typedef ovr_status ovr_trial_runner(void *data, ovr_trials *trials,
                                    ovr_error *err);

/* NULL after the last. */
OVR_API ovr_case *ovr_trials_case(const ovr_trials *trials, size_t k);
/* These mean what those of ovr_run_options mean. */
OVR_API bool ovr_trials_steady(const ovr_trials *trials);
OVR_API bool ovr_trials_estimate(const ovr_trials *trials);
OVR_API void ovr_trials_put(ovr_trials *trials, size_t k, const char *key,
                            double number);
OVR_API void ovr_trials_fail(ovr_trials *trials, size_t k, const char *message);

/* These numbers follow from a case by formulas alone; keys of `check --json`.
 */
OVR_API void ovr_setup_scales(const ovr_setup *setup, ovr_summary_taker *take,
                              void *data);

/* ------------------------------------------------------------------- find */

typedef struct ovr_find_options {
    const char *key;        /* "contact.load" */
    const char *low, *high; /* "50 kN/m"; one unit may stand for both */
    const char *condition;  /* "H_min is 0.3", "P_max_overall at most 2 GPa" */
    const char *which;      /* of an inequality: "largest" or "smallest" */
    double tolerance;       /* of the key, relative; 0: 1e-3 */
    int workers;            /* at once in the scan; 0: 1 */
    bool steady;            /* the steady contact alone */
    const char *table;      /* CSV of the evaluations, as they come; or NULL */
    bool go_on;             /* those that it holds are not run again */
    bool force;             /* a table that is another program's is replaced */
    const char *results;    /* folder of the result files of all runs; one that
                               holds some of the same question resumes
                               them; NULL: none are written */
    void *data;
    ovr_listener *say;
    bool (*stop)(void *data);
    ovr_trial_runner *run; /* NULL: here */
} ovr_find_options;

typedef enum ovr_find_end {
    OVR_FIND_FOUND,
    OVR_FIND_SCATTERED, /* found as well as its scatter lets it be */
    OVR_FIND_MISSED,    /* no answer between the ends */
    OVR_FIND_SEVERAL, /* several, and neither largest nor smallest asked for */
    OVR_FIND_FAILED   /* runs failed where the answer lies */
} ovr_find_end;

typedef struct ovr_find ovr_find;

/* Returns the values in the unit of the key, as in `low` and `high`. */
typedef struct ovr_find_info {
    const char *key, *quantity;
    const char *name;          /* full name of the quantity */
    const char *quantity_unit; /* "b^2/R", "Pa" or "" */
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
OVR_API ovr_status ovr_find_execute(ovr_find *find, ovr_error *err);
OVR_API void ovr_find_free(ovr_find *find);
OVR_API const ovr_find_info *ovr_find_get_info(const ovr_find *find);

/* Evaluations in the order of the values. */
OVR_API ovr_find_evaluation ovr_find_evaluation_at(const ovr_find *find,
                                                   size_t k);

/* Lines about the search, or about its answer: the value under the name of the
 * key, and the numbers of the run there. */
OVR_API void ovr_find_summary(const ovr_find *find, bool answer,
                              ovr_summary_taker *take, void *data);

/* ------------------------------------------------------------ sensitivity */

/* The effect of a per cent of a key on a number of the run: elasticities,
 * d ln Q/d ln x, by central differences of 2 and of 1 %, whose difference is
 * their doubt.  Steps of this size move film rupture and spike over several
 * mesh sizes; smaller steps would measure grid effects. */
typedef struct ovr_sensitivity_options {
    const char *keys; /* "contact.load, feature.dent.depth"; NULL: the numbers
                         given of the contact, its oil, its bodies, and sizes of
                         features */
    int workers;      /* at once; 0: 1 */
    bool steady;      /* the steady contact alone */
    bool estimate;    /* the same one level coarser */
    void *data;
    ovr_listener *say;
    bool (*stop)(void *data);
    ovr_trial_runner *run; /* NULL: here */
} ovr_sensitivity_options;

typedef struct ovr_sensitivity_row {
    const char *key, *quantity;
    const char *unit;     /* of an absolute slope: per this; NULL: relative */
    double step;          /* the larger one, relative or in that unit */
    double slope;         /* by the smaller one */
    double doubt;         /* derivative by the larger step */
    double coarser;       /* one level coarser; NAN: not asked for */
    const char *why_none; /* it is not to be used; or NULL */
} ovr_sensitivity_row;

typedef struct ovr_sensitivity ovr_sensitivity;

/* Runs it all. */
OVR_API ovr_sensitivity *
ovr_sensitivity_create(ovr_case *c, const ovr_sensitivity_options *options,
                       ovr_error *err);
OVR_API void ovr_sensitivity_free(ovr_sensitivity *sensitivity);

/* Key by key, of each its quantities; NULL behind the last. */
OVR_API const ovr_sensitivity_row *
ovr_sensitivity_at(const ovr_sensitivity *sensitivity, size_t k);

/* ----------------------------------------------------------------- random */

/* The distribution of a quantity over a study with [random], for each
 * combination of its other keys. */
typedef struct ovr_sample ovr_sample;

enum { OVR_SAMPLE_QUANTILES = 7, OVR_SAMPLE_LIMITS = 4 };

typedef struct ovr_sample_row {
    const char *group; /* "slide_to_roll=0.5"; "": nothing else varies */
    const char *quantity;
    const char *name, *unit; /* full name and unit ("b^2/R", "m" or "") */
    size_t draws, finished, failed, marked;
    size_t known; /* finished, with a number: what follows is of these */
    int order[2], level[2]; /* minimum and maximum of their solutions */
    double mean, sd;
    double error;  /* standard error of the mean; NAN: the design tells none */
    double factor; /* of that for 95 % */
    /* 95 % intervals; NAN: there is no end */
    double p[OVR_SAMPLE_QUANTILES], quantile[OVR_SAMPLE_QUANTILES];
    double low[OVR_SAMPLE_QUANTILES], high[OVR_SAMPLE_QUANTILES];
    size_t limits;
    int sense[OVR_SAMPLE_LIMITS]; /* 1: at least; -1: at most */
    double limit[OVR_SAMPLE_LIMITS];
    /* The probability that the limit holds: its share, and 95 % bounds, in
     * which every failed draw may count as either. */
    double P[OVR_SAMPLE_LIMITS], P_low[OVR_SAMPLE_LIMITS];
    double P_high[OVR_SAMPLE_LIMITS];
    size_t inputs;
} ovr_sample_row;

/* A random key and a quantity; with 95 % intervals. */
typedef struct ovr_sample_input {
    const char *key;
    bool related; /* drawn together with others: no share of the variance */
    double share, share_low, share_high; /* of the variance, by it alone */
    double rho, rho_low, rho_high;       /* Spearman's, with its sign */
    double lowest, highest; /* mean of the quantity where the key is so */
} ovr_sample_input;

/* The sample is taken of the files as they stand.  Quantities separated by
 * commas; NULL: those of [limits], the key of [find], minimum film thickness
 * and maximum pressure. */
OVR_API ovr_sample *ovr_study_sample(const ovr_study *study,
                                     const char *quantities, ovr_error *err);
OVR_API void ovr_sample_free(ovr_sample *sample);
OVR_API const ovr_sample_row *ovr_sample_at(const ovr_sample *sample, size_t k);
OVR_API const ovr_sample_input *ovr_sample_input_at(const ovr_sample *sample,
                                                    size_t row, size_t k);

/* Writes CSV, a line for each row.  An existing file that is no such table is
 * replaced with `force` only. */
OVR_API ovr_status ovr_sample_write(const ovr_sample *sample, const char *path,
                                    bool force, ovr_error *err);

/* True of a study with [random]. */
OVR_API bool ovr_study_random(const ovr_study *study);

#ifdef __cplusplus
}
#endif

#endif
