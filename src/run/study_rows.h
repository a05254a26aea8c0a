/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Results of a study without result files (results = no, or [find]), for any
 * number of cases.  The folder of the results has
 *
 *     cases-N.csv   a row for each case that has ended: name, hash of its
 *                   values, status, message, time, numbers of its summary.
 *                   A process that runs cases locks one of these tables and
 *                   appends to it.
 *     cases-N.log   messages of the cases, locked in the same way
 *     cases.index   a record of fixed size for each case of the study: its
 *                   state and the place of its row.  The byte of a case is
 *                   locked while the case runs.
 *
 * The index is made again from the tables if it belongs to another version of
 * the study.  A row that was cut off by a crash is run again.
 */
#ifndef OVR_RUN_STUDY_ROWS_H
#define OVR_RUN_STUDY_ROWS_H

#include <stdio.h>

#include "run/study.h"

typedef struct ovr_rows ovr_rows;

/* Opens the index.  Without `whole` states are read one by one. */
ovr_rows *ovr_rows_open(const ovr_study *s, bool whole, ovr_error *err);
void ovr_rows_close(ovr_rows *r);

ovr_sweep_state ovr_rows_state(const ovr_rows *r, size_t task);

/* True if the results of a case are in files of its own (see run/task.h). */
bool ovr_rows_elsewhere(const ovr_rows *r, size_t task);

/* Locks a case until it is released: 0, or EWOULDBLOCK if another process runs
 * it, or another errno if the file system has no locks. */
int ovr_rows_claim(ovr_rows *r, size_t task);
void ovr_rows_release(ovr_rows *r, size_t task);

/* Names and values of the numbers of a row, as text. */
typedef struct ovr_row {
    FILE *to[2];
    char *text[2];
    size_t size[2];
} ovr_row;

ovr_status ovr_row_begin(ovr_row *row, ovr_error *err);
void ovr_row_free(ovr_row *row);

/* Adds a line to an ovr_row, an ovr_summary_taker: a number, 1 or 0 for a flag,
 * an empty cell for an unknown number.  Texts are left out. */
void ovr_row_add(void *data, const ovr_summary_line *line);

/* Appends the row of a finished case; of a failed one. */
ovr_status ovr_rows_finish(ovr_rows *r, size_t task, ovr_row *row,
                           ovr_error *err);
ovr_status ovr_rows_fail(ovr_rows *r, size_t task, const char *message,
                         ovr_error *err);

/* Opens this process's log for appending; -1 with errno. */
int ovr_rows_log(ovr_rows *r);

/* Calls `number` for each number in the row of a case. If a crash has destroyed
 * the row, returns false and marks the case as waiting. */
typedef void ovr_rows_number(void *data, const char *name, double value);
bool ovr_rows_read(ovr_rows *r, size_t task, ovr_rows_number *number,
                   void *data);

/* Writes the error message of a failed case, "" if there is none. */
void ovr_rows_message(ovr_rows *r, size_t task, char *text, size_t capacity);

/* Writes the name of the table that contains the case, "" if there is none. */
void ovr_rows_table(const ovr_rows *r, size_t task, char *text,
                    size_t capacity);

#endif
