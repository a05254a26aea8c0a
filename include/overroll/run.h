/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A run, from a case to a finished result file; and studies: many runs.
 *
 *     ovr_run_options how = {0};
 *     how.output = "dent.h5";
 *     ovr_case *c = ovr_case_read("dent.ini", NULL, &err);
 *     ovr_run *run = c ? ovr_run_create(c, &how, NULL, &err) : NULL;
 *     if (run && !ovr_run_execute(run, &err))
 *         ... ovr_run_get_info(run)->sim ...
 *     ovr_run_free(run), ovr_case_free(c);
 *
 * All that a run has to say goes through callbacks; each may be NULL, and all
 * get `data`.
 */
#ifndef OVERROLL_RUN_H
#define OVERROLL_RUN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "overroll/case.h"
#include "overroll/error.h"
#include "overroll/memory.h"
#include "overroll/results.h"
#include "overroll/simulation.h"
#include "overroll/stress.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------ a run */

typedef struct ovr_run ovr_run;

typedef struct ovr_run_options {
    const char *output; /* result file; NULL: where the case says, if it does */
    bool force;         /* replace an existing file */
    bool steady;        /* the steady contact alone, its features grown: time
                           and output of the case do not count */
    bool estimate_error; /* solve again, coarser, each of several passes; of
                            these not when resumed */
    void *data;
    ovr_listener *say;
    /* Called after each step; true stops the run with OVR_STOPPED and a file
     * that can be resumed. */
    bool (*stop)(void *data);
    /* Called after each step of a run in time. */
    void (*progress)(void *data, const ovr_run *run, double fraction);
    /* Called after the steady start and after each step, once the file is
     * written. */
    ovr_status (*observe)(void *data, const ovr_simulation *sim,
                          ovr_error *err);
    /* Resuming: settings for the case (its end, what is stored). */
    ovr_status (*change)(void *data, ovr_case *c, ovr_error *err);
    bool no_thread;  /* compress and write in the caller's thread, as is done
                        where this process may use one processor only */
    bool from_start; /* resuming, with `force`: begin again where there is no
                        checkpoint, which replaces what is in the file */
    ovr_heights *heights; /* surfaces of one's own, in place of the case's
                             features; no file holds them: resuming has to be
                             given them again */
    /* Asked within steady starts and estimates of errors, between two cycles;
     * true: stop at once, with OVR_STOPPED; a start is begun again later. */
    bool (*interrupt)(void *data);
    /* Position of a steady run of a gear pair or cam: "A" to "E",
     * "nose", an angle or a time; NULL: pitch point, nose. */
    const char *at;
} ovr_run_options;

/* All that can be refused is refused here, before anything is solved.  A case
 * with several [passes] is one run, whose time begins again with each; its
 * result file has a row for each, theirs are OUT-1.h5 and so on.  The case
 * must outlive the run; a steady run takes the growth out of it. */
OVR_API ovr_run *ovr_run_create(ovr_case *c, const ovr_run_options *options,
                                const ovr_allocator *allocator, ovr_error *err);

/* Continues the run of a result file from the checkpoint beside it.  A run
 * stopped before its first checkpoint starts again.  A complete file with no
 * later end is not changed: the result is a finished run, or, without a
 * checkpoint, NULL with err->status OVR_OK and a message. */
OVR_API ovr_run *ovr_run_resume(const char *path,
                                const ovr_run_options *options,
                                const ovr_allocator *allocator, ovr_error *err);

/* Solves to the end and closes the file, whatever happens. */
OVR_API ovr_status ovr_run_execute(ovr_run *run, ovr_error *err);
OVR_API void ovr_run_free(ovr_run *run);

/* Discretization errors, estimated from the same case one and two levels
 * coarser. */
typedef struct ovr_run_error {
    const char *key; /* "H_cen", ..., "P_max_overall" */
    ovr_unit_kind kind;
    double value[3]; /* on the finest level first; NAN: not solved */
    double error;    /* of the first, dimensionless as it; NAN: not known */
    double order;    /* seen between the levels; NAN: not known */
    bool converges;  /* otherwise a warning is given and the error is unknown */
} ovr_run_error;
enum { OVR_RUN_ERRORS = 8 };
typedef struct ovr_run_errors {
    int level;    /* one coarser; 0: none was made */
    size_t count; /* the end state first, then the extremes of a run */
    ovr_run_error of[OVR_RUN_ERRORS];
} ovr_run_errors;

/* The prediction of amplitude reduction for rough surfaces that roll through,
 * before anything is solved: heights in b^2/R, NAN where it says nothing.  Rq
 * is the largest in a window of |X| < OVR_ROUGH_WINDOW of all that comes
 * through. */
typedef struct ovr_rough_film {
    double Rq;      /* of the unloaded surfaces */
    double film_Rq; /* of the film under the contact */
    double H_min; /* minimum film thickness; 0: the reduced roughness is as high
                     as the film */
    const char *why; /* it says nothing; or NULL */
    const char *but; /* it is less sure than overroll(1) says; or NULL */
} ovr_rough_film;

/* The state of a run at any moment. */
typedef struct ovr_run_info {
    const ovr_setup *setup;
    const ovr_simulation *sim;
    const char *output; /* result file or NULL */
    bool transient;     /* marches in time */
    double fraction;    /* of its time that is done */
    bool converged;     /* all steps, to the end */
    double seconds;     /* of wall time, until its file is closed */
    size_t snapshots;   /* in the file, when it is closed */
    const ovr_run_errors *error;
    const ovr_stress_report *stress[2]; /* of surface 1, 2; NULL: none */
    int warnings;                       /* number of warnings, for reports */
    const char *const *warning;
    double lambda_ratio; /* mean film in |X| < 3/4 and over the run, over the
                            composite Rq of both surfaces; NAN: smooth */
    /* The prediction of its rough film. */
    const ovr_rough_film *predicted;

    double shear_over_pressure; /* the film's largest shear stress over its
                                   pressure, where that is 0.2 ph at least, at
                                   the end; NAN: b/R is not known */
    double unbearable_share;    /* of the nodes there: above 0.1, which no oil
                                   carries */
    int pass, passes;        /* of several: under way, all; 0: there are none;
                                what stands above is of this one */
    const char *passes_file; /* with a row for each, OUT.h5; output is that of
                                the pass, OUT-1.h5 */
    long marked; /* steps accepted above the tolerance, of all passes */
    double life_together; /* ratio of lives of a raceway that sees all passes
                             again and again; NAN: not known */
    double elastic_length, elastic_ratio; /* equivalent length, b, and life over
                             that of the smooth raceway of the pass in which
                             nothing yields; NAN: there is none */
    bool shaken_down; /* the last pass of bodies that yield changed nothing */
} ovr_run_info;
OVR_API const ovr_run_info *ovr_run_get_info(const ovr_run *run);

/* A run is summed up line by line: the keys of `--json`, of the group
 * `summary` of its file and of a study's table. */
typedef enum ovr_summary_form {
    OVR_SUMMARY_NUMBER, /* NAN: not known */
    OVR_SUMMARY_COUNT,
    OVR_SUMMARY_FLAG, /* 0 or 1 */
    OVR_SUMMARY_TEXT,
    OVR_SUMMARY_WORDS,       /* for people alone: a label, NULL: a title, and
                                a text */
    OVR_SUMMARY_WORDS_BEHIND /* the same with a number before the text */
} ovr_summary_form;
/* Characters of the column of labels in reports. */
enum { OVR_LABEL_WIDTH = 38 };

typedef struct ovr_summary_line {
    const char *key; /* NULL: for people alone */
    ovr_summary_form form;
    double number;
    const char *text;
    const char *label; /* for people */
    int digits;        /* of the number, for them */
    bool detail;       /* printed in complete lists only, not in summaries */
} ovr_summary_line;
typedef void ovr_summary_taker(void *data, const ovr_summary_line *line);

OVR_API void ovr_run_summary(const ovr_run_info *run, ovr_summary_taker *take,
                             void *data);

/* The same with lines for people in between, as reports have them. */
OVR_API void ovr_run_report(const ovr_run_info *run, ovr_summary_taker *take,
                            void *data);

/* The answers about the gear pair, cam or bearing that a case describes, as
 * lines for people, a name and a text each, from its summary.  Nothing without
 * an element. */
typedef void ovr_answer(void *data, const char *name, const char *text);
OVR_API void ovr_run_answers(const ovr_run_info *run, ovr_answer *put,
                             void *data);

/* About the stresses below both surfaces (either may be NULL); by key those of
 * the worse one. */
OVR_API void ovr_stress_summary(const ovr_stress_report *const report[2],
                                const ovr_setup *setup, ovr_summary_taker *take,
                                void *data);

/* Stresses from the pressure that a result file holds, with its own [stress]
 * and [fatigue] as `change` (may be NULL) leaves them.  Depths are refused that
 * the stored moments cannot give. */
typedef struct ovr_stored_stress ovr_stored_stress;
OVR_API ovr_stored_stress *ovr_stored_stress_create(
    const char *path,
    ovr_status (*change)(void *data, ovr_case *c, ovr_error *err), void *data,
    ovr_error *err);
OVR_API void ovr_stored_stress_free(ovr_stored_stress *stress);
OVR_API const ovr_setup *
ovr_stored_stress_setup(const ovr_stored_stress *stress);
/* The report on surface 1 or 2; NULL: not asked for. */
OVR_API const ovr_stress_report *
ovr_stored_stress_report(const ovr_stored_stress *stress, int surface);

/* Writes the case of a result file and its input files into a folder, made if
 * necessary.  The run of that case computes the result again.  Files are
 * written into the folder itself, whatever their names were, and the case names
 * them so.  Existing ones are replaced with `force` only.  The listener gets
 * the path of each file (OVR_MESSAGE_FILE), and warnings about inputs that the
 * result file does not hold. */
OVR_API ovr_status ovr_result_unpack(const char *path, const char *folder,
                                     bool force, ovr_listener *listener,
                                     void *data, ovr_error *err);

/* A prepared setup is described before it is solved by lines of a summary: its
 * contact, films by formula, features, grid and cost.  `live`: bytes that the
 * setup itself has taken, which count as memory of the run. */
OVR_API ovr_status ovr_setup_report(const ovr_setup *setup, double live,
                                    ovr_summary_taker *take, void *data,
                                    ovr_error *err);

/* A prepared setup is reviewed before it is solved: a grid too coarse
 * for its features, one of them inside from the start or never in the contact,
 * a start from rest, an end within the first step, too much sliding. */
OVR_API void ovr_setup_review(const ovr_setup *setup, ovr_listener *say,
                              void *data);

/* ---------------------------------------------------------------- studies */

/*
 * A base case and lists of values: a run for each combination, see
 * overroll-study(5).  Cases are counted from 0.
 *
 *     ovr_study *study = ovr_study_read("loads.ini", NULL, &err);
 *     ovr_sweep_options how = {0};
 *     ovr_sweep_totals totals = {0};
 *     if (study && !ovr_sweep(study, &how, &err))
 *         ovr_sweep_collect(study, "loads.csv", false, &totals, &err);
 *     ovr_study_free(study);
 */
typedef struct ovr_study ovr_study;
struct ovr_find; /* overroll/questions.h */

/* Every key and value is tried on the base case; of [random] the first draw,
 * the others by ovr_sweep. */
OVR_API ovr_study *ovr_study_read(const char *path,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
OVR_API void ovr_study_free(ovr_study *study);

/* The number of cases; the name of one (at most 159 characters); its case, to
 * be freed. */
OVR_API size_t ovr_study_cases(const ovr_study *study);
OVR_API void ovr_study_name(const ovr_study *study, size_t k, char *text,
                            size_t capacity);
OVR_API ovr_case *ovr_study_case(const ovr_study *study, size_t k,
                                 ovr_error *err);

/* The folder of the results; another one, copied. */
OVR_API const char *ovr_study_output(const ovr_study *study);
OVR_API ovr_status ovr_study_output_set(ovr_study *study, const char *folder,
                                        ovr_error *err);

/* The state of a case, told by the files in the folder alone. */
typedef enum ovr_sweep_state {
    OVR_SWEEP_WAITING,  /* nothing there */
    OVR_SWEEP_STOPPED,  /* began; its result file can be resumed */
    OVR_SWEEP_RUNNING,  /* another process has it */
    OVR_SWEEP_FINISHED, /* with its summary */
    OVR_SWEEP_FAILED,
    OVR_SWEEP_CHANGED, /* finished, stopped or failed as another case */
    OVR_SWEEP_STATES
} ovr_sweep_state;
OVR_API const char *ovr_sweep_state_name(ovr_sweep_state state);
OVR_API ovr_sweep_state ovr_sweep_state_of(const ovr_study *study, size_t k);

/* First line of the message of a failure, or "". */
OVR_API void ovr_sweep_message(const ovr_study *study, size_t k, char *text,
                               size_t capacity);

enum { OVR_SWEEP_MAX_WORKERS = 1024 };

/* Every case is run by a process of its own, forked here, whose standard
 * output and error are its NAME.log: the callbacks of `run` and `report` are
 * called there. */
typedef struct ovr_sweep_options {
    int workers; /* at once; 0: one a processor */
    bool retry;  /* failed cases again */
    bool redo;   /* all again, from their beginning */
    bool force;  /* files of others that have the names of cases or of the
                    manifest are replaced */
    bool one;    /* only the case `only` and the `more` cases after it */
    size_t only;
    const ovr_run_options
        *run; /* output, force, steady do not count; or NULL */
    void *data;
    /* Called at the end of a run with its status in `err`; `run` is NULL if it
     * could not begin.  The text written to `summary` becomes NAME.json.
     * Without `report` the file has the numbers of ovr_run_summary.  A run
     * that failed has no file.  `summary` is NULL in studies without result
     * files, whose rows have the numbers of ovr_run_report. */
    void (*report)(void *data, const ovr_run *run, const ovr_error *err,
                   FILE *summary);
    /* A few times a second, here: how many of how many ended, how many run,
     * how many failed, and the part of all that is done. */
    void (*progress)(void *data, size_t ended, size_t cases, int running,
                     size_t failed, double fraction);
    bool (*stop)(void *data); /* asked as often */
    /* Like `report`, for a study with [find]. */
    void (*report_find)(void *data, const struct ovr_find *find,
                        const ovr_error *err, FILE *summary);
    size_t more; /* with `one` */
} ovr_sweep_options;

/* True of a state in which a case is one to work on. */
OVR_API bool ovr_sweep_is_due(const ovr_sweep_options *options,
                              ovr_sweep_state state);

/* Runs the cases that are asked for and free.  A failed case is no failure of
 * the sweep.  OVR_STOPPED: what runs was asked to stop at its next step. */
OVR_API ovr_status ovr_sweep(const ovr_study *study,
                             const ovr_sweep_options *options, ovr_error *err);

typedef struct ovr_sweep_totals {
    size_t count[8]; /* by state */
    size_t marked;   /* cases with steps accepted above the tolerance */
} ovr_sweep_totals;

/* Writes manifest.csv in the folder and, unless NULL, the table of all cases
 * to `path`, which ends with .csv, .nc or .h5.  Existing files that are no such
 * tables are replaced with `force` only. */
OVR_API ovr_status ovr_sweep_collect(const ovr_study *study, const char *path,
                                     bool force, ovr_sweep_totals *totals,
                                     ovr_error *err);

/* The table of a study's cases: its keys, then what their summaries hold. */
typedef struct ovr_table ovr_table;

typedef struct ovr_table_column {
    const char *name;
    const char *unit;        /* SI; "": none, or not known */
    bool varied;             /* a key of the study */
    const double *number;    /* of each case; NAN: none */
    const char *const *text; /* as written; NULL: numbers alone */
    const char *zip;         /* of a key of [zip NAME]: NAME; else NULL */
} ovr_table_column;

/* Reads the files in the folder of the study in their present state; or from
 * what ovr_sweep_collect wrote, .csv or .nc; or the rows of several passes,
 * OUT.h5: its first column is `pass`, and the only one varied. */
OVR_API ovr_table *ovr_study_table(const ovr_study *study, ovr_error *err);
OVR_API ovr_table *ovr_table_read(const char *path, ovr_error *err);
OVR_API void ovr_table_free(ovr_table *table);
OVR_API size_t ovr_table_rows(const ovr_table *table);
OVR_API const ovr_table_column *ovr_table_at(const ovr_table *table, size_t k);

/* A column of several passes that people read; these go from left to right. */
typedef struct ovr_pass_head {
    const char *text; /* "central" */
    char name[160];   /* "central film thickness, mean over the pass" */
    const ovr_table_column *of; /* NULL: not known of these passes */
} ovr_pass_head;

/* false past the end. */
OVR_API bool ovr_table_pass_head(const ovr_table *table, size_t k,
                                 ovr_pass_head *to);

#ifdef __cplusplus
}
#endif

#endif
