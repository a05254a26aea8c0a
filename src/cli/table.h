/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A table of numbers for other programs: columns with name and unit.
 *
 * Three forms: CSV with one line of names; columns with blanks between and a
 * # line before (gnuplot); the same with % (MATLAB's load).  Numbers have 17
 * digits: reading them gives the same double.
 */
#ifndef OVR_CLI_TABLE_H
#define OVR_CLI_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "overroll/error.h"
#include "overroll/overroll.h"

enum { CLI_MAX_COLUMNS = 256 };

typedef enum cli_table_form { CLI_CSV, CLI_GNUPLOT, CLI_MATLAB } cli_table_form;

typedef struct cli_column {
    char name[160];
    const char *unit; /* owned by the caller */
    double *values;
} cli_column;

/* All zeros: an empty table. */
typedef struct cli_table {
    cli_column column[CLI_MAX_COLUMNS];
    size_t columns, rows;
} cli_table;

/* Adds a column of table->rows zeros and returns it; NULL without memory. */
double *cli_table_add(cli_table *table, const char *name, const char *unit,
                      ovr_error *err);
void cli_table_heads(const cli_table *table, cli_table_form form, FILE *to);
void cli_table_rows(const cli_table *table, cli_table_form form, FILE *to);
void cli_table_print(const cli_table *table, cli_table_form form, FILE *to);

/* Write a heading and a number of a table that is not stored. `first`, `last`:
 * position in their line. */
void cli_table_head(const char *name, const char *unit, cli_table_form form,
                    bool first, FILE *to);
void cli_table_number(double value, cli_table_form form, bool first, bool last,
                      FILE *to);
void cli_table_clear(cli_table *table);

/* Tables of several passes, for commands that print the contents of a file. */

/* Reads the rows; NULL if it is another kind of file. */
ovr_table *cli_passes_open(const char *path);

/* Prints text or JSON on stdout. */
void cli_passes_print(const char *path, const ovr_table *passes, bool json);

/* Writes the numbers, one row per pass. */
ovr_status cli_passes_export(const ovr_table *passes, cli_table_form form,
                             FILE *to, ovr_error *err);

#endif
