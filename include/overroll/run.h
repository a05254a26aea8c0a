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
 * Messages and progress are passed to callbacks, each of which may be NULL and
 * receives `data`.
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
    const char *output; /* result file; NULL: output.file of the case, if set */
    bool force;         /* replace an existing file */
    bool steady; /* only the steady contact with fully grown features; [time]
                    and [output] of the case are ignored */
    bool estimate_error; /* repeat the run (each of several passes) on coarser
                            levels to estimate errors; not for resumed passes */
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
    /* Called when resuming; may change settings of the case, such as time.end
     * and [output]. */
    ovr_status (*change)(void *data, ovr_case *c, ovr_error *err);
    bool no_thread; /* compress and write in the caller's thread (default if the
                       process may use only one processor) */
    bool from_start; /* when resuming with `force`: start again if there is no
                        checkpoint; the contents of the file are replaced */
    ovr_heights
        *heights; /* surface heights that replace the features of the case; they
                     are not stored, so that they must be set again to resume */
    /* Called between two cycles of steady starts and error estimates. True
     * stops the run at once with OVR_STOPPED; a resumed run repeats the start.
     */
    bool (*interrupt)(void *data);
    /* Position of a steady run of a gear pair or cam: "A" to "E",
     * "nose", an angle or a time; NULL: pitch point, nose. */
    const char *at;
} ovr_run_options;

/* Checks the case and the options completely before anything is solved. A case
 * with several [passes] is one run; time starts at 0 in each pass. Its result
 * file has one row per pass, and the result files of the passes are OUT-1.h5
 * and so on. The case must outlive the run; a steady run removes the growth of
 * features from the case. */
OVR_API ovr_run *ovr_run_create(ovr_case *c, const ovr_run_options *options,
                                const ovr_allocator *allocator, ovr_error *err);

/* Continues the run of a result file from its checkpoint file. A run stopped
 * before its first checkpoint starts again. A complete file is not changed
 * unless time.end is later: the function then returns a finished run or,
 * without a checkpoint, NULL with err->status OVR_OK and a message. */
OVR_API ovr_run *ovr_run_resume(const char *path,
                                const ovr_run_options *options,
                                const ovr_allocator *allocator, ovr_error *err);

/* Solves to the end. The file is closed even if the run fails. */
OVR_API ovr_status ovr_run_execute(ovr_run *run, ovr_error *err);
OVR_API void ovr_run_free(ovr_run *run);

/* Discretization errors, estimated from the same case one and two levels
 * coarser. */
typedef struct ovr_run_error {
    const char *key; /* "H_cen", ..., "P_max_overall"; "H_min" is interpolated
                        between nodes */
    ovr_unit_kind kind;
    double value[3]; /* values on the finest level and the next coarser ones;
                        NAN: not solved */
    double error;    /* error of value[0], dimensionless; NAN: unknown */
    double order;    /* observed order of convergence; NAN: unknown */
    bool converges;  /* false: a warning is printed and the error is unknown */
} ovr_run_error;
enum { OVR_RUN_ERRORS = 8 };
typedef struct ovr_run_errors {
    int level;    /* first coarser level; 0: no estimate was made */
    size_t count; /* quantities at the end, then extremes over the run */
    ovr_run_error of[OVR_RUN_ERRORS];
} ovr_run_errors;

/* Prediction by amplitude reduction for rough surfaces, before the run. Heights
 * are in b^2/R; NAN: no prediction. Rq is the maximum over time of the
 * roughness in |X| < OVR_ROUGH_WINDOW. */
typedef struct ovr_rough_film {
    double Rq;      /* roughness of the undeformed surfaces */
    double film_Rq; /* roughness of the film thickness in the contact */
    double H_min;   /* minimum film thickness; also NAN if the reduced roughness
                       is as high as the film */
    const char *why; /* reason why there is no prediction, or NULL */
    const char *but; /* reason why it is less accurate than stated in
                        overroll(1), or NULL */
} ovr_rough_film;

/* State of a run, valid at any time. */
typedef struct ovr_run_info {
    const ovr_setup *setup;
    const ovr_simulation *sim;
    const char *output; /* result file or NULL */
    bool transient;     /* the run is transient */
    double fraction;    /* completed share of the simulated time */
    bool converged;     /* all steps converged */
    double seconds;     /* wall-clock time until the file is closed */
    size_t snapshots;   /* number of snapshots, known once the file is closed */
    const ovr_run_errors *error;
    const ovr_stress_report *stress[2]; /* surfaces 1 and 2; NULL: none */
    int warnings;                       /* number of warnings, for reports */
    const char *const *warning;
    double lambda_ratio; /* mean film thickness in |X| < 3/4 and over the run
                            divided by the composite Rq of both surfaces; NAN:
                            smooth */
    /* prediction of film roughness */
    const ovr_rough_film *predicted;

    double shear_over_pressure; /* maximum ratio of shear stress to pressure at
                                   the end, where the pressure is at least 0.2
                                   p_h; NAN: b/R is unknown */
    double unbearable_share; /* share of these nodes at which the ratio exceeds
                                0.1, the limit of lubricants */
    int pass, passes; /* number of the current pass, to which the members above
                         refer, and of all passes; 0: a single run */
    const char *passes_file; /* file with one row per pass, OUT.h5; `output` is
                                the file of the pass, OUT-1.h5 */
    long marked;             /* steps accepted above tolerance, in all passes */
    double life_together;    /* life ratio of a raceway on which all passes are
                                repeated; NAN: unknown */
    double elastic_length,
        elastic_ratio; /* equivalent length in b and life ratio of the pass
                          without plastic deformation; NAN: no such pass */
    bool shaken_down;  /* the last pass caused no further plastic deformation */
} ovr_run_info;
OVR_API const ovr_run_info *ovr_run_get_info(const ovr_run *run);

/* Form of a line of the summary. The keys of lines are those of `--json`, of
 * the group `summary` of result files and of tables of studies. */
typedef enum ovr_summary_form {
    OVR_SUMMARY_NUMBER, /* NAN: unknown */
    OVR_SUMMARY_COUNT,
    OVR_SUMMARY_FLAG, /* 0 or 1 */
    OVR_SUMMARY_TEXT,
    OVR_SUMMARY_WORDS, /* text for reports: a label (NULL: a title) and a text
                        */
    OVR_SUMMARY_WORDS_BEHIND /* as OVR_SUMMARY_WORDS, with a number before the
                                text */
} ovr_summary_form;
/* Width of the column of labels in reports. */
enum { OVR_LABEL_WIDTH = 38 };

typedef struct ovr_summary_line {
    const char *key; /* NULL: only in reports */
    ovr_summary_form form;
    double number;
    const char *text;
    const char *label; /* for reports */
    int digits;        /* significant digits of the number in reports */
    bool detail;       /* printed in complete lists only, not in summaries */
} ovr_summary_line;
typedef void ovr_summary_taker(void *data, const ovr_summary_line *line);

OVR_API void ovr_run_summary(const ovr_run_info *run, ovr_summary_taker *take,
                             void *data);

/* Passes the lines of the summary and, between them, the lines of reports. */
OVR_API void ovr_run_report(const ovr_run_info *run, ovr_summary_taker *take,
                            void *data);

/* Passes the results for the gear pair, cam or bearing of the case as lines of
 * a name and a text. Without a machine element no line is passed. */
typedef void ovr_answer(void *data, const char *name, const char *text);
OVR_API void ovr_run_answers(const ovr_run_info *run, ovr_answer *put,
                             void *data);

/* Passes the lines about stresses below both surfaces (either may be NULL).
 * Lines with keys refer to the surface with the higher stress. */
OVR_API void ovr_stress_summary(const ovr_stress_report *const report[2],
                                const ovr_setup *setup, ovr_summary_taker *take,
                                void *data);

/* Stresses from the stored pressure of a result file. [stress] and [fatigue]
 * are those of its case after `change` (may be NULL). Depths that the stored
 * times do not resolve are an error. */
typedef struct ovr_stored_stress ovr_stored_stress;
OVR_API ovr_stored_stress *ovr_stored_stress_create(
    const char *path,
    ovr_status (*change)(void *data, ovr_case *c, ovr_error *err), void *data,
    ovr_error *err);
OVR_API void ovr_stored_stress_free(ovr_stored_stress *stress);
OVR_API const ovr_setup *
ovr_stored_stress_setup(const ovr_stored_stress *stress);
/* Returns the report on surface 1 or 2, or NULL if it was not requested. */
OVR_API const ovr_stress_report *
ovr_stored_stress_report(const ovr_stored_stress *stress, int surface);

/* Writes the case of a result file and its input files into a folder, which is
 * created if necessary. Running this case computes the result again. All files
 * are written into the folder itself, and the case refers to them by these
 * names. Existing files are replaced only with `force`. The listener receives
 * the path of each file (OVR_MESSAGE_FILE) and warnings about inputs that the
 * result file does not contain. */
OVR_API ovr_status ovr_result_unpack(const char *path, const char *folder,
                                     bool force, ovr_listener *listener,
                                     void *data, ovr_error *err);

/* Passes lines about an unsolved setup to `take`: contact, film thickness
 * formulas, features, grid and cost. `live` is the memory of the setup in
 * bytes, which is added to the memory of the run. `peak` is the maximum memory
 * while the setup was prepared (0: unknown), which may exceed this sum. */
OVR_API ovr_status ovr_setup_report(const ovr_setup *setup, double live,
                                    double peak, ovr_summary_taker *take,
                                    void *data, ovr_error *err);

/* Warns about a prepared setup before it is solved: features that the grid
 * does not resolve, that start inside the domain or never enter it, a start
 * from rest, an end within the first step, opposite sliding. */
OVR_API void ovr_setup_review(const ovr_setup *setup, ovr_listener *say,
                              void *data);

/* ---------------------------------------------------------------- studies */

/*
 * A study runs a base case for each combination of listed values, see
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

/* Reads a study and sets every key and value in the base case, so that errors
 * are reported here. Only the first sample of [random] is checked; ovr_sweep
 * checks the others. */
OVR_API ovr_study *ovr_study_read(const char *path,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
OVR_API void ovr_study_free(ovr_study *study);

/* Number of cases, name of case k (at most 159 characters), and case k, which
 * the caller must free. */
OVR_API size_t ovr_study_cases(const ovr_study *study);
OVR_API void ovr_study_name(const ovr_study *study, size_t k, char *text,
                            size_t capacity);
OVR_API ovr_case *ovr_study_case(const ovr_study *study, size_t k,
                                 ovr_error *err);

/* Returns and sets the folder of the results; the name is copied. */
OVR_API const char *ovr_study_output(const ovr_study *study);
OVR_API ovr_status ovr_study_output_set(ovr_study *study, const char *folder,
                                        ovr_error *err);

/* State of a case, determined only from the files in the folder. */
typedef enum ovr_sweep_state {
    OVR_SWEEP_WAITING,  /* no files */
    OVR_SWEEP_STOPPED,  /* started; the result file can be resumed */
    OVR_SWEEP_RUNNING,  /* another process runs it */
    OVR_SWEEP_FINISHED, /* finished, the summary is available */
    OVR_SWEEP_FAILED,
    OVR_SWEEP_CHANGED, /* the existing files belong to another case */
    OVR_SWEEP_STATES
} ovr_sweep_state;
OVR_API const char *ovr_sweep_state_name(ovr_sweep_state state);
OVR_API ovr_sweep_state ovr_sweep_state_of(const ovr_study *study, size_t k);

/* First line of the message of a failure, or "". */
OVR_API void ovr_sweep_message(const ovr_study *study, size_t k, char *text,
                               size_t capacity);

enum { OVR_SWEEP_MAX_WORKERS = 1024 };

/* Every case is run by a forked process, which writes standard output and
 * error to NAME.log. The callbacks in `run` and `report` are called in that
 * process. */
typedef struct ovr_sweep_options {
    int workers; /* number of simultaneous processes; 0: one per processor */
    bool retry;  /* repeat failed cases */
    bool redo;   /* repeat all cases from the start */
    bool force;  /* replace files of other programs that have the names of cases
                    or of the manifest */
    bool one;    /* run only the case `only` and the following `more` cases */
    size_t only;
    const ovr_run_options *run; /* options of each run, or NULL; output, force
                                   and steady are ignored */
    void *data;
    /* Called at the end of a run with its status in `err`; `run` is NULL if
     * the run could not start. The text written to `summary` becomes
     * NAME.json. Without `report` the file contains the numbers of
     * ovr_run_summary. A failed run has no such file. `summary` is NULL in
     * studies without result files, whose rows contain the numbers of
     * ovr_run_report. */
    void (*report)(void *data, const ovr_run *run, const ovr_error *err,
                   FILE *summary);
    /* Called a few times per second in the calling process: number of
     * completed, all, running and failed cases, and the completed share. */
    void (*progress)(void *data, size_t ended, size_t cases, int running,
                     size_t failed, double fraction);
    bool (*stop)(void *data); /* called as often as `progress` */
    /* Like `report`, for studies with [find], whose rows contain the numbers of
     * ovr_find_summary. */
    void (*report_find)(void *data, const struct ovr_find *find,
                        const ovr_error *err);
    size_t more; /* see `one` */
} ovr_sweep_options;

/* True if a case in this state is to be run. */
OVR_API bool ovr_sweep_is_due(const ovr_sweep_options *options,
                              ovr_sweep_state state);

/* Runs the selected cases that no other process runs. A failed case is not an
 * error of the sweep. OVR_STOPPED: running cases were stopped after their
 * current step. */
OVR_API ovr_status ovr_sweep(const ovr_study *study,
                             const ovr_sweep_options *options, ovr_error *err);

typedef struct ovr_sweep_totals {
    size_t count[8]; /* by state */
    size_t marked;   /* cases with steps accepted above the tolerance */
} ovr_sweep_totals;

/* Writes manifest.csv in the folder and the table of all cases to `path`
 * (.csv, .nc or .h5), unless it is NULL. Existing files of other programs are
 * replaced only with `force`. */
OVR_API ovr_status ovr_sweep_collect(const ovr_study *study, const char *path,
                                     bool force, ovr_sweep_totals *totals,
                                     ovr_error *err);

/* Table of the cases of a study: its keys, then the numbers of the summaries.
 */
typedef struct ovr_table ovr_table;

typedef struct ovr_table_column {
    const char *name;
    const char *unit;     /* SI unit; "": none or unknown */
    bool varied;          /* a key of the study */
    const double *number; /* one number per case; NAN: none */
    const char *const
        *text; /* the values as written, or NULL if there are only numbers */
    const char *zip; /* NAME of the [zip NAME] with this key, or NULL */
} ovr_table_column;

/* Reads the table from the files in the folder of the study, or from a table
 * of ovr_sweep_collect (.csv, .nc), or from the file of several passes
 * (OUT.h5). The first column of the latter, `pass`, is the only varied one. */
OVR_API ovr_table *ovr_study_table(const ovr_study *study, ovr_error *err);
OVR_API ovr_table *ovr_table_read(const char *path, ovr_error *err);
OVR_API void ovr_table_free(ovr_table *table);
OVR_API size_t ovr_table_rows(const ovr_table *table);
OVR_API const ovr_table_column *ovr_table_at(const ovr_table *table, size_t k);

/* A column of the table of passes in reports, from left to right. */
typedef struct ovr_pass_head {
    const char *text; /* "central" */
    char name[160];   /* "central film thickness, mean over the pass" */
    const ovr_table_column *of; /* NULL: unknown for these passes */
} ovr_pass_head;

/* Returns false past the end. */
OVR_API bool ovr_table_pass_head(const ovr_table *table, size_t k,
                                 ovr_pass_head *to);

#ifdef __cplusplus
}
#endif

#endif
