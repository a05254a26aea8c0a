/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Several passes: each is a run with its own file that starts with the
 * lubricant layers left by the preceding one (pass_layers.c). The file of all
 * passes, OUT.h5, has a row for each (passes_file.c). Rows and layers are
 * computed only from the files OUT-1.h5, ..., so that a continued run equals an
 * uninterrupted one.
 */
#ifndef OVR_RUN_PASS_SERIES_H
#define OVR_RUN_PASS_SERIES_H

#include "run/internal.h"
#include "surface/layer.h"

/* --------------------------------------------------- Columns (passes_file.c)
 */

/* Columns of the file of all passes: first the quantities with a PASS in their
 * row, then the OVR_PASS_BESIDE other numbers of a pass. */
enum { OVR_PASS_MAX = 64 };

/* Columns that are no quantities, by number. */
typedef enum ovr_pass_beside {
    OVR_PASS_LOST,
    OVR_PASS_STEPS,
    OVR_PASS_FILM_ERROR, /* this and the following only if known */
    OVR_PASS_MIN_ERROR,
    OVR_PASS_PRESSURE_ERROR,
    OVR_PASS_MENISCUS_ERROR,
    OVR_PASS_LENGTH, /* equivalent length, from the stresses below a surface */
    OVR_PASS_RISK,
    OVR_PASS_RATIO,
    OVR_PASS_TOGETHER,
    OVR_PASS_BESIDE
} ovr_pass_beside;

typedef struct ovr_pass_column {
    char name[64], long_name[160];
    ovr_unit_kind kind;
    const ovr_observable *of; /* NULL: not one of the quantities */
    unsigned how;             /* statistic of the quantity: one of
                               * OVR_PASS_MEAN, ... */
    /* Position in the printed table (0: not printed), heading there, and the
     * physical models without which the column is omitted, as in the rows of
     * quantities. */
    int place;
    const char *head;
    unsigned with;
} ovr_pass_column;

/* Fills *to with column k; false past the end. The first OVR_PASS_BESIDE
 * columns are those that are no quantities. */
bool ovr_pass_column_at(size_t k, ovr_pass_column *to);

/* Returns the number of the column with this name, which must exist. */
size_t ovr_pass_column_named(const char *name);

/* ---------------------------------- History at the outlet (pass_layers.c) */

typedef enum ovr_pass_quantity {
    OVR_SEEN_TIME,
    OVR_SEEN_SUPPLY,
    OVR_SEEN_INFLOW_RATIO,
    OVR_SEEN_OUTFLOW,
    OVR_SEEN_RESERVOIR,
    OVR_SEEN_SPEED,
    OVR_PASS_QUANTITIES
} ovr_pass_quantity;

enum { OVR_SEEN_MAX = OVR_PASS_QUANTITIES + OVR_PASS_MAX };

/* After the quantities above: the quantity of each column, at
 * OVR_PASS_QUANTITIES + k. Columns that are no quantities are empty. */
typedef struct ovr_pass_history {
    ovr_arena arena;
    size_t n, capacity;
    double *of[OVR_SEEN_MAX];
    const ovr_observable *which[OVR_SEEN_MAX]; /* NULL: empty */
} ovr_pass_history;

/* Returns an empty history; ovr_arena_release(&h.arena) frees it. */
ovr_pass_history ovr_pass_history_make(const ovr_allocator *allocator);

/* Stores a row at the start and at each step. */
ovr_observer ovr_pass_history_observer(ovr_pass_history *h);

/* -------------------------------------------------------------------- Passes
 */

typedef struct ovr_pass_row {
    double value[OVR_PASS_MAX]; /* by column, dimensionless; NAN: unknown */
    const char *status;         /* status of the result file; "waiting": no file
                                 * yet */
} ovr_pass_row;

/* Result of a pass: the two lubricant layers that enter the next pass, the
 * volume in its inlet reservoir, and the row of this pass. */
typedef struct ovr_pass_end {
    ovr_layer *layer[2];
    double reservoir;
    double flooded; /* flow rate rho H of the flooded contact; NAN: unknown */
    ovr_pass_row row;
} ovr_pass_end;

/* Computes the result of a pass from its recorded history. `setup` is prepared;
 * `flooded` is the flooded flow rate known from earlier passes. */
ovr_status ovr_pass_end_make(const ovr_setup *setup, ovr_pass_history *h,
                             ovr_pass_end *end, const ovr_allocator *allocator,
                             ovr_error *err);
void ovr_pass_end_free(ovr_pass_end *end);

/* Computes the result of a pass from its file. */
ovr_status ovr_pass_read(const char *file, const ovr_setup *setup,
                         ovr_pass_end *end, const ovr_allocator *allocator,
                         ovr_error *err);

/* State of a pass on one level, for the error estimate: element 0 is the run
 * itself, element k the same passes k levels coarser. Each level uses the
 * layers of its own preceding pass. */
enum { OVR_PASS_LEVELS = 3 };
typedef struct ovr_pass_level {
    bool lost; /* a pass failed on this level: no estimate from there on */
    ovr_pass_history seen;
    ovr_pass_end end; /* result of the last recorded pass */
} ovr_pass_level;

struct ovr_passes {
    const char *path;  /* OUT.h5 */
    int now;           /* current pass, from 1 */
    int rows;          /* passes that have a name and a row so far */
    const char **file; /* result file of each pass */
    ovr_pass_row *row;
    double oil_flooded; /* flow rate of the flooded contact; NAN: not known
                         * yet */
    bool converged;     /* all passes so far have converged */
    bool whole;         /* the file of all passes is complete and is not
                         * rewritten */
    struct ovr_result *before; /* last complete pass of a resumed series, not
                                * reported yet */
    ovr_pass_level level[OVR_PASS_LEVELS];
};

/* Returns the name of the result file of a pass: OUT-3.h5 for OUT.h5. */
const char *ovr_passes_name(const char *path, int pass, ovr_arena *arena,
                            ovr_error *err);

/* Functions of a pass on a coarser level: feed adds the layers of the preceding
 * pass to the setup, begin clears the recorded history, end evaluates it. */
void ovr_pass_level_feed(ovr_pass_level *of, ovr_setup *setup);
void ovr_pass_level_begin(ovr_pass_level *of, const ovr_allocator *allocator);
ovr_status ovr_pass_level_end(ovr_pass_level *of, const ovr_setup *setup,
                              ovr_error *err);
void ovr_passes_free(ovr_passes *passes);

/* Writes the whole file of all passes. The second function writes the case as
 * text. */
ovr_status ovr_passes_write(const ovr_run *run, const char *status,
                            ovr_error *err);
bool ovr_passes_file_is(const char *path);
bool ovr_passes_file_complete(const char *path); /* true if the file has all
                                                  * rows */

/* Returns the numbers of the summary of all passes; NULL if the file has none.
 * Owned by the arena. */
const struct ovr_named_number *
ovr_passes_numbers(const char *path, ovr_arena *arena, size_t *count);

ovr_case *ovr_passes_case(const char *path, const ovr_allocator *allocator,
                          ovr_error *err);

/* Creates the file of all passes and begins the first pass. */
ovr_status ovr_passes_begin(ovr_run *run, ovr_error *err);

/* Adds the layers and strains of the preceding pass to the setup of a pass. */
ovr_status ovr_passes_feed(ovr_run *run, ovr_error *err);

/* Solves the passes from the prepared one to the last. */
ovr_status ovr_passes_execute(ovr_run *run, ovr_error *err);

/* Reads the passes of a file to be resumed; `now` is the first incomplete
 * pass. */
ovr_status ovr_passes_reopen(ovr_run *run, const char *path, ovr_error *err);

/* Reports the last complete pass; closes its file. */
void ovr_passes_recall(ovr_run *run);

/* Writes the rows of all passes, whose files are complete, to the file of all
 * passes. The second function makes the run that of the last pass. */
ovr_status ovr_passes_finish(ovr_run *run, int last, ovr_error *err);
ovr_status ovr_passes_go_back(ovr_run *run, int last, ovr_error *err);

/* True if plastic bodies have shaken down with this pass. */
bool ovr_passes_at_rest(const ovr_run *run, int pass);

/* Sets the load of a pass; returns whether bodies deform plastically in it. */
ovr_status ovr_setup_pass(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err);

#endif
