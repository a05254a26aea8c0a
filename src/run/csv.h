/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads and writes comma-separated tables (RFC 4180) of studies, searches and
 * lists of values. */
#ifndef OVR_RUN_CSV_H
#define OVR_RUN_CSV_H

#include <stdbool.h>
#include <stdio.h>

#include "overroll/error.h"

/* Write a cell: a text, in quotes if it contains a comma, quote or line end; a
 * number with `digits` significant digits, empty if NAN. */
void ovr_csv_text(FILE *to, const char *text);
void ovr_csv_number(FILE *to, double value, int digits);

/* Closes a table after writing; `to` is NULL if the table could not be
 * opened. */
ovr_status ovr_csv_end(FILE *to, const char *path, ovr_error *err);

/* Returns the cell at *at without the blanks and quotes around it, terminated
 * in place, and moves *at to the next; *last if its line ends with it. */
char *ovr_csv_cell(char **at, bool *last);

/* Returns the unit of a heading "load [N/m]" or "load (N/m)", "" if it has
 * none, and cuts the heading to its name. */
const char *ovr_csv_unit(char *head);

#endif
