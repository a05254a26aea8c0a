/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/table.h"

#include <math.h>
#include <stdlib.h>

double *cli_table_add(cli_table *t, const char *name, const char *unit,
                      ovr_error *err)
{
    cli_column *c = &t->column[t->columns];
    if (t->columns == CLI_MAX_COLUMNS) {
        ovr_fail(err, OVR_BAD_INPUT, "more than %d columns", CLI_MAX_COLUMNS);
        return NULL;
    }
    snprintf(c->name, sizeof c->name, "%s", name);
    c->unit = unit;
    c->values = calloc(t->rows + 1, sizeof *c->values);
    if (!c->values) {
        ovr_fail(err, OVR_NO_MEMORY, "out of memory: %zu rows", t->rows);
        return NULL;
    }
    t->columns++;
    return c->values;
}

void cli_table_clear(cli_table *t)
{
    for (size_t c = 0; c < t->columns; c++)
        free(t->column[c].values);
    t->columns = t->rows = 0;
}

/* One word: blanks would part the columns, and names come from a file. */
static void print_word(const char *text, FILE *to)
{
    for (; *text; text++)
        fputc(*text > ' ' && *text != ',' && *text != '"' ? *text : '.', to);
}

void cli_table_head(const char *name, const char *unit, cli_table_form form,
                    bool first, FILE *to)
{
    if (first && form != CLI_CSV)
        fputs(form == CLI_GNUPLOT ? "# " : "% ", to);
    if (!first)
        fputc(form == CLI_CSV ? ',' : ' ', to);
    print_word(name, to);
    fputs(form == CLI_CSV ? " [" : "_[", to);
    print_word(unit, to);
    fputc(']', to);
}

void cli_table_heads(const cli_table *t, cli_table_form form, FILE *to)
{
    for (size_t c = 0; c < t->columns; c++)
        cli_table_head(t->column[c].name, t->column[c].unit, form, c == 0, to);
    fputc('\n', to);
}

void cli_table_number(double value, cli_table_form form, bool first, bool last,
                      FILE *to)
{
    if (!first)
        fputc(form == CLI_CSV ? ',' : ' ', to);
    if (isnan(value))
        fputs("NaN", to);
    else
        fprintf(to, "%.17g", value);
    if (last)
        fputc('\n', to);
}

void cli_table_rows(const cli_table *t, cli_table_form form, FILE *to)
{
    for (size_t r = 0; r < t->rows; r++)
        for (size_t c = 0; c < t->columns; c++)
            cli_table_number(t->column[c].values[r], form, c == 0,
                             c + 1 == t->columns, to);
}

void cli_table_print(const cli_table *t, cli_table_form form, FILE *to)
{
    cli_table_heads(t, form, to);
    cli_table_rows(t, form, to);
}
