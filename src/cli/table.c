/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "cli/json.h"

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

/* Prints external text as one word, because blanks would separate columns. */
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

/* ----------------------------------------------- the file of several passes */

ovr_table *cli_passes_open(const char *path)
{
    ovr_table *table = ovr_table_read(path, NULL);
    const ovr_table_column *first = table ? ovr_table_at(table, 0) : NULL;
    if (first && strcmp(first->name, "pass") == 0)
        return table;
    ovr_table_free(table);
    return NULL;
}

static const ovr_table_column *named(const ovr_table *t, const char *name)
{
    const ovr_table_column *c;
    for (size_t k = 0; (c = ovr_table_at(t, k)); k++)
        if (strcmp(c->name, name) == 0)
            break;
    return c;
}

/* ------------------------------------------------------------------- print */

static void print_text(const ovr_table_column *c, size_t row)
{
    cli_put_foreign(c && c->text ? c->text[row] : NULL);
}

/* Finds the next column from `*at` on that has values; false past the end. */
static bool next_known(const ovr_table *t, size_t *at, ovr_pass_head *head)
{
    while (ovr_table_pass_head(t, (*at)++, head))
        for (size_t i = 0; head->of && i < ovr_table_rows(t); i++)
            if (isfinite(head->of->number[i]))
                return true;
    return false;
}

/* Returns the unit of a column: that of its largest value. */
static cli_unit unit_of(const ovr_table_column *c, size_t rows)
{
    double largest = 0;
    for (size_t i = 0; i < rows; i++)
        if (fabs(c->number[i]) > largest)
            largest = fabs(c->number[i]);
    return cli_choose_unit(*c->unit ? c->unit : "1", largest);
}

/* Prints the rows, and the full names of the columns. */
static void print_table(const char *path, const ovr_table *t)
{
    ovr_pass_head head;
    printf("%s: %zu passes\n\n%4s", path, ovr_table_rows(t), "pass");
    for (size_t k = 0; next_known(t, &k, &head);)
        printf(" %11s", head.text);
    printf("  file\n%4s", "");
    for (size_t k = 0; next_known(t, &k, &head);)
        printf(" %11s", unit_of(head.of, ovr_table_rows(t)).name);
    putchar('\n');
    for (size_t i = 0; i < ovr_table_rows(t); i++) {
        printf("%4zu", i + 1);
        for (size_t k = 0; next_known(t, &k, &head);)
            if (isfinite(head.of->number[i]))
                printf(" %11.5g",
                       head.of->number[i] *
                           unit_of(head.of, ovr_table_rows(t)).factor);
            else
                printf(" %11s", "-");
        fputs("  ", stdout);
        print_text(named(t, "file"), i);
        fputs(", ", stdout);
        print_text(named(t, "status"), i);
        putchar('\n');
    }
    putchar('\n');
    for (size_t k = 0; next_known(t, &k, &head);)
        printf("%-11s %s\n", head.text, head.name);
}

static void print_json(const char *path, const ovr_table *t)
{
    const ovr_table_column *c;
    json_writer json = json_begin(stdout);
    json_text(&json, "path", path);
    json_integer(&json, "passes", (long long)ovr_table_rows(t));
    for (size_t k = 0; (c = ovr_table_at(t, k)); k++) {
        json_open_array(&json, c->name);
        for (size_t i = 0; i < ovr_table_rows(t); i++)
            if (c->text)
                json_text(&json, NULL, c->text[i]);
            else
                json_number(&json, NULL, c->number[i]);
        json_close_array(&json);
    }
    json_end(&json);
}

void cli_passes_print(const char *path, const ovr_table *passes, bool json)
{
    if (json)
        print_json(path, passes);
    else
        print_table(path, passes);
}

/* ------------------------------------------------------------------ export */

ovr_status cli_passes_export(const ovr_table *passes, cli_table_form form,
                             FILE *to, ovr_error *err)
{
    cli_table *table = calloc(1, sizeof *table);
    const ovr_table_column *c;
    ovr_status status = OVR_OK;
    if (!table) {
        ovr_fail(err, OVR_NO_MEMORY, "out of memory");
        return OVR_NO_MEMORY;
    }
    table->rows = ovr_table_rows(passes);
    for (size_t k = 0; !status && (c = ovr_table_at(passes, k)); k++) {
        double *values = c->text ? NULL
                                 : cli_table_add(table, c->name,
                                                 *c->unit ? c->unit : "1", err);
        if (values)
            memcpy(values, c->number, table->rows * sizeof *values);
        else if (!c->text)
            status = OVR_NO_MEMORY;
    }
    if (!status)
        cli_table_print(table, form, to);
    cli_table_clear(table);
    free(table);
    return status;
}
