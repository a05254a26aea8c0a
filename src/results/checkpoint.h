/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The checkpoint file OUT.h5.restart.
 *
 *   magic   16 bytes "overroll restart"
 *   order   64-bit 0x0102030405060708 in the machine's byte order
 *   pieces  each: length of its name and of its content (64 bits each), name
 *           and content without terminators
 *   end     a piece without a name that contains the crc32 of all preceding
 *           bytes (64 bits)
 *
 * Pieces before the first checkpoint:
 *
 *   "format"         64-bit number
 *   "version"        of the program
 *   "created"        date_created of the result file, which identifies it
 *   "case path", "case text"
 *   "value +NAME"    text of a parameter of the physics, or
 *   "value -NAME"    of another parameter
 *   "counts"         checkpoint_counts
 *
 * Pieces of a checkpoint, in any order:
 *
 *   "base"           number of the checkpoint (64 bits, store.h); default: 0
 *   "state NAME"     each part of the state (ovr_simulation_visit)
 *   "state S"        the surface at that time
 *
 * Readers find pieces by name. Unknown pieces are ignored. A missing number (at
 * most 8 bytes) keeps its previous value; a missing array is an error.
 *
 * The file is written as OUT.h5.restart.part, synced and renamed to replace the
 * preceding checkpoint, and the folder is synced. A complete checkpoint thus
 * always exists. The result file is flushed and synced first, so that it
 * contains the rows that the checkpoint counts.
 */
#ifndef OVR_RESULTS_CHECKPOINT_H
#define OVR_RESULTS_CHECKPOINT_H

#include <stdint.h>

#include "base/arena.h"
#include "simulation/simulation.h"

#define OVR_RESTART_MAGIC "overroll restart"
#define OVR_RESTART_ORDER UINT64_C(0x0102030405060708)
enum { OVR_RESTART_MAGIC_SIZE = 16, OVR_RESTART_FORMAT = 2 };

/* One parameter of the case, stored as an attribute of the group `case`. */
typedef struct ovr_case_value {
    const char *name; /* "contact.M" */
    const char *text; /* value as in a case file: "20", "22 1/GPa" */
    double number; /* value in SI or without a unit; NAN: the text is stored */
    const char *unit; /* SI unit of the number, or NULL */
    bool physics;     /* the value affects the solution, so that resuming with
                         another value is an error */
} ovr_case_value;

/*
 * The checkpoint of a run, with its case. It exists together with OUT.h5 from
 * the beginning and is always replaced as a whole.
 *
 *     ovr_restart *restart = ovr_restart_open("OUT.h5", NULL, &err);
 *     ... case from ovr_restart_get_info(restart), simulation as for a new run
 *     if (about->has_state)
 *         ovr_restart_load(restart, sim, &err);
 *     else
 *         ovr_simulation_steady(sim, &err);
 *     w = ovr_writer_resume(&options, &contact, n, X, restart, NULL, &err);
 *     ovr_writer_checkpoints(w, sim);
 *     ... march with the writer as its observer
 */
typedef struct ovr_restart ovr_restart;

typedef struct ovr_restart_info {
    bool has_state; /* false: the run ended before its first checkpoint */
    long step;      /* step number and time of the checkpoint */
    double T;
    size_t snapshots, steps; /* rows in the file at the checkpoint */
    double inlet, outlet;    /* domain; NAN: not recorded */
    int level;               /* 0: not recorded */
    const char *case_text, *case_path;
    size_t value_count; /* parameters of the run; name, text, physics */
    const ovr_case_value *values;
} ovr_restart_info;

typedef struct ovr_counts {
    int64_t step, snapshots, steps;
    int64_t stored; /* nonzero: the state is stored as a snapshot */
    double T, seconds;
} ovr_counts;

/* Source of the saved state: `visit_all` visits every part of `object`. */
typedef struct ovr_state_source {
    ovr_status (*visit_all)(void *object, ovr_visit *visit, void *context,
                            ovr_error *err);
    void *object;
} ovr_state_source;

typedef struct ovr_checkpoint {
    const char *path, *part; /* final and temporary path */
    const char *created, *case_text, *case_path;
    size_t value_count;
    const ovr_case_value *values;
    ovr_counts counts;
    uint64_t number;         /* number of the checkpoint in the store */
    ovr_state_source source; /* visit_all NULL: no state yet */
    bool sync;
} ovr_checkpoint;

ovr_status ovr_checkpoint_write(const ovr_checkpoint *checkpoint,
                                ovr_error *err);

/* Loads the state of a checkpoint into any source. */
ovr_status ovr_restart_load_into(ovr_restart *restart,
                                 const ovr_state_source *source,
                                 ovr_error *err);

/* True if the state has a record with this name and content. */
bool ovr_restart_holds(const ovr_restart *restart, const char *name,
                       const void *memory, size_t bytes);

/* Returns the date_created that the result file must have. */
const char *ovr_restart_created(const ovr_restart *restart);
const ovr_counts *ovr_restart_counts(const ovr_restart *restart);
uint64_t ovr_restart_number(const ovr_restart *restart);

/* Fails with OVR_BAD_INPUT if a parameter of physics differs; the message names
 * the first. */
ovr_status ovr_values_same(size_t were, const ovr_case_value *was, size_t count,
                           const ovr_case_value *values, ovr_error *err);

#endif
