/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Several passes: each a run of its own, with a file of its own, that takes
 * in what the one before left on the surfaces (pass_layers.c).  The file of
 * all of them, OUT.h5, has a row for each (passes_file.c); rows and layers
 * follow from the files OUT-1.h5, ... alone, so that a continued run equals an
 * uninterrupted one.
 */
#ifndef OVR_RUN_PASS_SERIES_H
#define OVR_RUN_PASS_SERIES_H

#include "run/internal.h"
#include "surface/layer.h"

/* --------------------------------------------------- Columns (passes_file.c)
 */

/* The columns of the file of all passes: quantities with a PASS in their row,
 * and after these what is known of a pass in addition. */
enum { OVR_PASS_MAX = 64 };

/* Those beside the quantities, by their numbers. */
typedef enum ovr_pass_beside {
    OVR_PASS_LOST,
    OVR_PASS_STEPS,
    OVR_PASS_FILM_ERROR, /* from here on where they are known */
    OVR_PASS_MIN_ERROR,
    OVR_PASS_PRESSURE_ERROR,
    OVR_PASS_MENISCUS_ERROR,
    OVR_PASS_LENGTH, /* of the stresses below a surface */
    OVR_PASS_RISK,
    OVR_PASS_RATIO,
    OVR_PASS_TOGETHER,
    OVR_PASS_BESIDE
} ovr_pass_beside;

typedef struct ovr_pass_column {
    char name[64], long_name[160];
    ovr_unit_kind kind;
    const ovr_observable *of; /* NULL: none of the quantities */
    unsigned how;             /* of that: one of OVR_PASS_MEAN, ... */
    /* Its place in the table that people read, 0: none, its head there and the
     * physics without which it is left out, as rows of quantities have them. */
    int place;
    const char *head;
    unsigned with;
} ovr_pass_column;

/* Column k: first the OVR_PASS_BESIDE, then those of the quantities.  false
 * past the end. */
bool ovr_pass_column_at(size_t k, ovr_pass_column *to);

/* Finds a column by its name, which is one of them. */
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

/* Behind the ones above the quantity of each column, OVR_PASS_QUANTITIES + k;
 * those of columns beside the quantities are empty. */
typedef struct ovr_pass_history {
    ovr_arena arena;
    size_t n, capacity;
    double *of[OVR_SEEN_MAX];
    const ovr_observable *which[OVR_SEEN_MAX]; /* NULL: empty */
} ovr_pass_history;

/* Empty; ovr_arena_release(&h.arena) frees it. */
ovr_pass_history ovr_pass_history_make(const ovr_allocator *allocator);

/* All rows of a file. */
ovr_status ovr_pass_history_read(ovr_pass_history *h, ovr_result *result,
                                 ovr_error *err);

/* Stores a row at the start and at each step. */
ovr_observer ovr_pass_history_observer(ovr_pass_history *h);

/* -------------------------------------------------------------------- Passes
 */

typedef struct ovr_pass_row {
    double value[OVR_PASS_MAX]; /* by columns, dimensionless; NAN: not known
                                 */
    const char *status;         /* of its file; "waiting": none yet */
} ovr_pass_row;

/* The two layers that enter the next pass, and the oil in the inlet
 * reservoir before it; the row of this one. */
typedef struct ovr_pass_end {
    ovr_layer *layer[2];
    double reservoir;
    double flooded; /* rho H that a flooded contact takes; NAN: not known */
    ovr_pass_row row;
} ovr_pass_end;

/* Makes the end of a pass from what was seen of it, for a setup that is
 * prepared; `flooded` is what the passes before know. */
ovr_status ovr_pass_end_make(const ovr_setup *setup, ovr_pass_history *h,
                             ovr_pass_end *end, const ovr_allocator *allocator,
                             ovr_error *err);
void ovr_pass_end_free(ovr_pass_end *end);

/* The same from its file. */
ovr_status ovr_pass_read(const char *file, const ovr_setup *setup,
                         ovr_pass_end *end, const ovr_allocator *allocator,
                         ovr_error *err);

/* A pass on a level, as the estimate of errors needs it: 0 the run's own, k
 * that of the same passes k levels coarser, fed by its own pass before. */
enum { OVR_PASS_LEVELS = 3 };
typedef struct ovr_pass_level {
    bool lost; /* a pass failed on it: it has none from there on */
    ovr_pass_history seen;
    ovr_pass_end end; /* of the pass that was seen last */
} ovr_pass_level;

struct ovr_passes {
    const char *path;  /* OUT.h5 */
    int now;           /* under way, from 1 */
    int rows;          /* with a name and a row so far */
    const char **file; /* of each */
    ovr_pass_row *row;
    double oil_flooded; /* flow of the flooded contact; NAN: not known yet */
    bool converged;     /* all so far */
    bool whole;         /* the file of all has every row: it stays as it is */
    struct ovr_result *before; /* resumed: complete, not reported yet */
    ovr_pass_level level[OVR_PASS_LEVELS];
};

/* The result file of a pass: OUT-3.h5 of OUT.h5. */
const char *ovr_passes_name(const char *path, int pass, ovr_arena *arena,
                            ovr_error *err);

/* Returns that name in the memory of a run; makes rows and names for so many.
 */
const char *ovr_passes_file_of(ovr_run *run, int pass, ovr_error *err);
ovr_status ovr_passes_make_rows(ovr_run *run, int number, ovr_error *err);

/* The row of a pass that ended, from its file, and what it left. */
ovr_status ovr_passes_update(ovr_run *run, int pass, ovr_pass_end *end,
                             ovr_error *err);

/* Hands on to the setup of this pass what the one before left, a level coarser;
 * what was seen of it, before it begins and when it ended. */
void ovr_pass_level_feed(ovr_pass_level *of, ovr_setup *setup);
void ovr_pass_level_begin(ovr_pass_level *of, const ovr_allocator *allocator);
ovr_status ovr_pass_level_end(ovr_pass_level *of, const ovr_setup *setup,
                              ovr_error *err);
void ovr_passes_free(ovr_passes *passes);

/* The file of all passes, written whole; its case, as it was written. */
ovr_status ovr_passes_write(const ovr_run *run, const char *status,
                            ovr_error *err);
bool ovr_passes_file_is(const char *path);
bool ovr_passes_file_complete(const char *path); /* every row is in it */
ovr_case *ovr_passes_case(const char *path, const ovr_allocator *allocator,
                          ovr_error *err);

/* A new run: its file and the first pass. */
ovr_status ovr_passes_begin(ovr_run *run, ovr_error *err);

/* Adds the layers and strains of the preceding pass to the setup of a pass. */
ovr_status ovr_passes_feed(ovr_run *run, ovr_error *err);

/* Runs the passes from the one that is set up to the last. */
ovr_status ovr_passes_execute(ovr_run *run, ovr_error *err);

/* The passes of a file that is resumed: `now` is the first that is not
 * complete. */
ovr_status ovr_passes_reopen(ovr_run *run, const char *path, ovr_error *err);

/* Reports the preceding pass to the whole run and closes its file. */
void ovr_passes_recall(ovr_run *run);
void ovr_passes_close(ovr_passes *passes);

/* The rows of all passes, whose files are complete, into the file of them; then
 * the run is that of the last one. */
ovr_status ovr_passes_finish(ovr_run *run, int last, ovr_error *err);
ovr_status ovr_passes_go_back(ovr_run *run, int last, ovr_error *err);

/* True if bodies that yield have shaken down with this pass. */
bool ovr_passes_at_rest(const ovr_run *run, int pass);

/* Sets the load of a pass; returns whether bodies deform plastically in it. */
ovr_status ovr_setup_pass(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err);

#endif
