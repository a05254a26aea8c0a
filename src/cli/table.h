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
    const char *unit; /* borrowed */
    double *values;
} cli_column;

/* All zero: empty. */
typedef struct cli_table {
    cli_column column[CLI_MAX_COLUMNS];
    size_t columns, rows;
} cli_table;

/* The values of a new column of table->rows zeros, or NULL. */
double *cli_table_add(cli_table *table, const char *name, const char *unit,
                      ovr_error *err);
void cli_table_heads(const cli_table *table, cli_table_form form, FILE *to);
void cli_table_rows(const cli_table *table, cli_table_form form, FILE *to);
void cli_table_print(const cli_table *table, cli_table_form form, FILE *to);

/* One name, one number, for tables that are not held: `first` and `last` of
 * their line. */
void cli_table_head(const char *name, const char *unit, cli_table_form form,
                    bool first, FILE *to);
void cli_table_number(double value, cli_table_form form, bool first, bool last,
                      FILE *to);
void cli_table_clear(cli_table *table);

/* The file of several passes, for the commands that print what is in a file. */

/* Its rows; NULL: it is another file. */
ovr_table *cli_passes_open(const char *path);

/* Prints text or JSON on stdout. */
void cli_passes_print(const char *path, const ovr_table *passes, bool json);

/* The numbers, a row each pass. */
ovr_status cli_passes_export(const ovr_table *passes, cli_table_form form,
                             FILE *to, ovr_error *err);

#endif
