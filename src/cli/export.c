/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll export OUT.h5: tables of numbers for other programs. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/output.h"
#include "cli/picture_options.h"
#include "cli/table.h"

typedef struct job {
    const cli_call *call;
    ovr_result *result;
    const ovr_result_info *about;
    ovr_units units;
    cli_table_form form;
    FILE *to;
    cli_table *table;
    ovr_error *err;
} job;

/* ---------------------------------------------------------------- columns */

/* Returns the unit of a variable in the requested units. */
static const char *unit_in(const job *j, const ovr_variable *v)
{
    const ovr_kind_info *kind = ovr_kind_about(v->kind);
    bool stored_si = strcmp(v->unit, "1") != 0;
    const char *unit = j->units == OVR_SI ? kind->si : kind->hertzian;
    if (stored_si && j->units != OVR_HERTZIAN)
        unit = v->unit;
    return unit;
}

/* Adds a column and returns its values. */
static double *add_column(job *j, const char *name, const ovr_variable *v)
{
    return cli_table_add(j->table, name, unit_in(j, v), j->err);
}

/* --------------------------------------------------------- requested data */

/* Returns the k-th field given by --field, or of all; NULL past the end. */
static const ovr_variable *target_field(const job *j, size_t k)
{
    const char *name = cli_value_at(j->call, "field", (int)k);
    if (!cli_value(j->call, "field"))
        return ovr_result_field(j->result, k);
    for (size_t f = 0; name && f < ovr_result_fields(j->result); f++)
        if (strcmp(ovr_result_field(j->result, f)->name, name) == 0)
            return ovr_result_field(j->result, f);
    return NULL;
}

static ovr_status no_field(const job *j, const char *name)
{
    enum { MAX = 64 };
    const char *names[MAX], *meant;
    char there[700];
    size_t n = 0;
    for (; n < MAX && n < ovr_result_fields(j->result); n++)
        names[n] = ovr_result_field(j->result, n)->name;
    cli_join(names, n, there, sizeof there);
    meant = ovr_suggest(name, names, n);
    if (meant)
        return ovr_fail(j->err, OVR_BAD_INPUT,
                        "%s: has no field '%s'; did you mean '%s'?",
                        j->call->argument[0], name, meant);
    return ovr_fail(j->err, OVR_BAD_INPUT,
                    "%s: has no field '%s'; the fields are %s",
                    j->call->argument[0], name, there);
}

static ovr_status check_fields(const job *j)
{
    const char *name;
    for (int k = 0; (name = cli_value_at(j->call, "field", k)); k++)
        if (!target_field(j, (size_t)k))
            return no_field(j, name);
    return OVR_OK;
}

static ovr_status add_snapshot(job *j, size_t k)
{
    const ovr_variable *field;
    double *x;
    j->table->rows = j->about->nodes;
    x = add_column(j, "x", ovr_result_find(j->result, "x"));
    if (!x || ovr_result_x(j->result, j->units, x, j->err))
        return j->err->status;
    for (size_t f = 0; (field = target_field(j, f)); f++) {
        double *values = add_column(j, field->name, field);
        if (!values || ovr_result_snapshot(j->result, field->name, k, j->units,
                                           values, j->err))
            return j->err->status;
    }
    return OVR_OK;
}

/* Adds a row for each node of a strip, line by line. */
static ovr_status add_areal(job *j, size_t k)
{
    const ovr_variable *field;
    size_t n = j->about->nodes, lines = j->about->lines;
    double *x, *y;
    j->table->rows = n * lines;
    x = add_column(j, "x", ovr_result_find(j->result, "x"));
    y = x ? add_column(j, "y", ovr_result_find(j->result, "x")) : NULL;
    if (!y || ovr_result_x(j->result, j->units, x, j->err) ||
        ovr_result_y(j->result, j->units, y, j->err))
        return j->err->status;
    for (size_t i = n * lines; i-- > 0;) {
        y[i] = y[i / n];
        x[i] = x[i % n];
    }
    for (size_t f = 0; (field = target_field(j, f)); f++) {
        double *values = add_column(j, field->name, field);
        if (!values || ovr_result_areal(j->result, field->name, k, j->units,
                                        values, j->err))
            return j->err->status;
    }
    return OVR_OK;
}

static ovr_status add_history(job *j)
{
    const ovr_variable *v;
    j->table->rows = j->about->steps;
    for (size_t k = 0; (v = ovr_result_column(j->result, k)); k++) {
        double *values = add_column(j, v->name, v);
        if (!values ||
            ovr_result_history(j->result, v->name, j->units, values, j->err))
            return j->err->status;
    }
    return OVR_OK;
}

/* Interpolates linearly between nodes; x increases. */
static double interpolate(size_t n, const double *x, const double *v, double at)
{
    size_t low = 0, high = n - 1;
    double weight;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (x[middle] <= at)
            low = middle;
        else
            high = middle;
    }
    if (low == high)
        return v[low];
    weight = (at - x[low]) / (x[high] - x[low]);
    return weight == 0 ? v[low] : (1 - weight) * v[low] + weight * v[high];
}

/* Adds a field at one X (in b) for every snapshot. */
static ovr_status add_series(job *j, const ovr_variable *field, double X,
                             const double *x, double *row)
{
    char name[160];
    double *values;
    snprintf(name, sizeof name, "%s(X=%g)", field->name, X);
    values = add_column(j, name, field);
    if (!values)
        return j->err->status;
    for (size_t k = 0; k < j->about->snapshots; k++) {
        if (ovr_result_snapshot(j->result, field->name, k, j->units, row,
                                j->err))
            return j->err->status;
        values[k] = interpolate(j->about->nodes, x, row, X);
    }
    return OVR_OK;
}

static ovr_status check_position(const job *j, const char *text,
                                 const double *x, double *X)
{
    ovr_error why = {0};
    if (ovr_result_number(j->result, OVR_KIND_LENGTH, text, X, &why))
        return ovr_fail(j->err, OVR_BAD_INPUT, "--at %s", why.message);
    if (!(*X >= x[0] && *X <= x[j->about->nodes - 1]))
        return ovr_fail(j->err, OVR_BAD_INPUT,
                        "--at %s: must be a position in b from %g to %g", text,
                        x[0], x[j->about->nodes - 1]);
    return OVR_OK;
}

static ovr_status add_all_series(job *j, double *x, double *row)
{
    const ovr_variable *field;
    double *T, X;
    const char *text;
    j->table->rows = j->about->snapshots;
    T = add_column(j, "time", ovr_result_find(j->result, "time"));
    if (!T || ovr_result_times(j->result, j->units, T, j->err) ||
        ovr_result_x(j->result, OVR_HERTZIAN, x, j->err))
        return j->err->status;
    for (int k = 0; (text = cli_value_at(j->call, "at", k)); k++) {
        if (check_position(j, text, x, &X))
            return j->err->status;
        for (size_t f = 0; (field = target_field(j, f)); f++)
            if (add_series(j, field, X, x, row))
                return j->err->status;
    }
    return OVR_OK;
}

static ovr_status series(job *j)
{
    double *work = calloc(2 * j->about->nodes, sizeof *work);
    ovr_status status;
    if (!work)
        return ovr_fail(j->err, OVR_NO_MEMORY, "out of memory: %zu nodes",
                        j->about->nodes);
    status = add_all_series(j, work, work + j->about->nodes);
    free(work);
    if (status == OVR_OK)
        cli_table_print(j->table, j->form, j->to);
    return status;
}

/* Returns the times of all snapshots, to be freed; NULL with the error
 * filled. */
static double *times_in(const job *j, ovr_units units)
{
    double *times = calloc(j->about->snapshots + 1, sizeof *times);
    if (!times)
        ovr_fail(j->err, OVR_NO_MEMORY, "out of memory: %zu times",
                 j->about->snapshots);
    else if (ovr_result_times(j->result, units, times, j->err)) {
        free(times);
        times = NULL;
    }
    return times;
}

/* Finds the snapshot nearest to T. */
static ovr_status nearest(const job *j, double T, size_t *row)
{
    double *times = times_in(j, OVR_HERTZIAN);
    *row = 0;
    for (size_t k = 1; times && k < j->about->snapshots; k++)
        if (fabs(times[k] - T) < fabs(times[*row] - T))
            *row = k;
    free(times);
    return times ? OVR_OK : j->err->status;
}

static ovr_status chosen_row(const job *j, size_t *row)
{
    const char *index = cli_value(j->call, "snapshot");
    const char *text = index ? index : cli_value(j->call, "time");
    double value;
    if (index && strcmp(index, "last") == 0) {
        *row = j->about->snapshots - 1;
        return OVR_OK;
    }
    if (!index)
        return ovr_result_number(j->result, OVR_KIND_TIME, text, &value, j->err)
                   ? j->err->status
                   : nearest(j, value, row);
    if (!ovr_bare_number(text, &value))
        return ovr_fail(j->err, OVR_BAD_INPUT, "'%s' is not a number", text);
    if (value < 0 || value >= (double)j->about->snapshots ||
        value != floor(value))
        return ovr_fail(j->err, OVR_BAD_INPUT,
                        "no snapshot %s: must be 0 to %zu or 'last'", text,
                        j->about->snapshots - 1);
    *row = (size_t)value;
    return OVR_OK;
}

static ovr_status snapshot(job *j)
{
    size_t row = 0;
    if (chosen_row(j, &row))
        return j->err->status;
    if (cli_flag(j->call, "areal") ? add_areal(j, row) : add_snapshot(j, row))
        return j->err->status;
    cli_table_print(j->table, j->form, j->to);
    return OVR_OK;
}

/* Adds the time of a snapshot to all its rows. */
static ovr_status add_time(job *j, double T)
{
    double *times;
    j->table->rows = j->about->nodes;
    times = add_column(j, "time", ovr_result_find(j->result, "time"));
    for (size_t i = 0; times && i < j->about->nodes; i++)
        times[i] = T;
    return times ? OVR_OK : j->err->status;
}

/* Writes the snapshots as blocks separated by two empty lines (gnuplot's
 * `index`). */
static ovr_status long_table(job *j, const double *times)
{
    for (size_t k = 0; k < j->about->snapshots; k++) {
        cli_table_clear(j->table);
        if (add_time(j, times[k]) || add_snapshot(j, k))
            return j->err->status;
        if (k == 0)
            cli_table_heads(j->table, j->form, j->to);
        else if (j->form == CLI_GNUPLOT)
            fputs("\n\n", j->to);
        cli_table_rows(j->table, j->form, j->to);
    }
    return OVR_OK;
}

/* Adds the headings of a table with a row for each x and a column for each
 * field and snapshot: pressure(t=0.0012). */
static ovr_status wide_heads(job *j, const double *times)
{
    const ovr_variable *field;
    const char *unit = unit_in(j, ovr_result_find(j->result, "time"));
    cli_table_head("x", unit_in(j, ovr_result_find(j->result, "x")), j->form,
                   true, j->to);
    for (size_t k = 0; k < j->about->snapshots; k++)
        for (size_t f = 0; (field = target_field(j, f)); f++) {
            char name[200];
            snprintf(name, sizeof name, "%s(t=%.9g%s)", field->name, times[k],
                     strcmp(unit, "s") == 0 ? "s" : "");
            cli_table_head(name, unit_in(j, field), j->form, false, j->to);
        }
    fputc('\n', j->to);
    return OVR_OK;
}

static ovr_status fill_wide(job *j, double *values, size_t fields)
{
    size_t n = j->about->nodes, columns = 1 + fields * j->about->snapshots;
    const ovr_variable *field;
    if (ovr_result_x(j->result, j->units, values, j->err))
        return j->err->status;
    for (size_t k = 0; k < j->about->snapshots; k++)
        for (size_t f = 0; (field = target_field(j, f)); f++)
            if (ovr_result_snapshot(j->result, field->name, k, j->units,
                                    values + n * (1 + k * fields + f), j->err))
                return j->err->status;
    for (size_t i = 0; i < n; i++)
        for (size_t c = 0; c < columns; c++)
            cli_table_number(values[c * n + i], j->form, c == 0,
                             c + 1 == columns, j->to);
    return OVR_OK;
}

static ovr_status wide_table(job *j, const double *times)
{
    size_t fields = 0;
    double *values;
    ovr_status status;
    while (target_field(j, fields))
        fields++;
    values = calloc(1 + fields * j->about->snapshots,
                    j->about->nodes * sizeof *values);
    if (!values)
        return ovr_fail(j->err, OVR_NO_MEMORY,
                        "out of memory: %zu snapshots side by side",
                        j->about->snapshots);
    status = wide_heads(j, times);
    if (status == OVR_OK)
        status = fill_wide(j, values, fields);
    free(values);
    return status;
}

static ovr_status all_snapshots(job *j)
{
    double *times = times_in(j, j->units);
    ovr_status status = !times                      ? j->err->status
                        : cli_flag(j->call, "wide") ? wide_table(j, times)
                                                    : long_table(j, times);
    free(times);
    return status;
}

static ovr_status history(job *j)
{
    if (add_history(j))
        return j->err->status;
    cli_table_print(j->table, j->form, j->to);
    return OVR_OK;
}

static bool has_all(const job *j)
{
    return cli_flag(j->call, "all") || cli_flag(j->call, "long") ||
           cli_flag(j->call, "wide");
}

static ovr_status write_table(job *j)
{
    bool at = cli_value(j->call, "at") != NULL;
    bool one = cli_value(j->call, "snapshot") || cli_value(j->call, "time");
    if (check_fields(j))
        return j->err->status;
    if (!at && !one && !has_all(j))
        return history(j);
    if (j->about->snapshots == 0)
        return ovr_fail(j->err, OVR_BAD_INPUT,
                        "%s: contains no snapshot; only its history of %zu "
                        "steps can be exported",
                        j->call->argument[0], j->about->steps);
    return at ? series(j) : one ? snapshot(j) : all_snapshots(j);
}

/* ---------------------------------------------------------------- command */

static int read_choices(job *j)
{
    static const char *const units[] = {"stored", "hertzian", "si", NULL};
    static const char *const forms[] = {"csv", "gnuplot", "matlab", NULL};
    const char *unit = cli_value(j->call, "units");
    const char *form_name = cli_value(j->call, "format");
    int k = unit ? cli_choice(unit, units) : 0;
    int f = form_name ? cli_choice(form_name, forms) : 0;
    if (k < 0)
        return cli_usage(j->call, "--units %s: must be stored, hertzian or si",
                         unit);
    if (f < 0)
        return cli_usage(j->call, "--format %s: must be csv, gnuplot or matlab",
                         form_name);
    if (cli_flag(j->call, "long") && cli_flag(j->call, "wide"))
        return cli_usage(j->call, "--long and --wide exclude each other");
    if (cli_flag(j->call, "areal") && !cli_value(j->call, "snapshot") &&
        !cli_value(j->call, "time"))
        return cli_usage(j->call, "--areal needs --snapshot or --time");
    j->units = (ovr_units)k;
    j->form = (cli_table_form)f;
    return CLI_DONE;
}

static int write_all(job *j)
{
    cli_output out;
    int code = cli_output_open(j->call, cli_value(j->call, "o"), &out);
    if (code != CLI_DONE)
        return code;
    j->to = out.to;
    if (write_table(j) != OVR_OK)
        code = cli_fail(j->err);
    return cli_output_close(&out, code);
}

static int write_passes(job *j, const ovr_table *passes)
{
    cli_output out;
    int code;
    if (j->units != OVR_AS_STORED)
        return cli_usage(j->call, "rows of passes are exported as they are "
                                  "stored; remove this option");
    code = cli_output_open(j->call, cli_value(j->call, "o"), &out);
    if (code != CLI_DONE)
        return code;
    if (cli_passes_export(passes, j->form, out.to, j->err))
        code = cli_fail(j->err);
    return cli_output_close(&out, code);
}

static int run(cli_call *call)
{
    ovr_error err = {0};
    job j = {.call = call, .err = &err};
    int code = read_choices(&j);
    if (code != CLI_DONE)
        return code;
    ovr_table *passes = cli_passes_open(call->argument[0]);
    if (passes) {
        code = write_passes(&j, passes);
        ovr_table_free(passes);
        return code;
    }
    j.result = ovr_result_open(call->argument[0], NULL, &err);
    if (!j.result)
        return cli_fail(&err);
    j.about = ovr_result_get_info(j.result);
    code = cli_choose_across(call, j.result);
    if (code) {
        ovr_result_close(j.result);
        return code;
    }
    j.table = calloc(1, sizeof *j.table);
    if (j.table) {
        code = write_all(&j);
        cli_table_clear(j.table);
    } else {
        ovr_fail(&err, OVR_NO_MEMORY, "out of memory");
        code = cli_fail(&err);
    }
    free(j.table);
    ovr_result_close(j.result);
    return code;
}

static const cli_option options[] = {
    {"snapshot", "K", "fields along x of snapshot K (from 0) or 'last'", false},
    {"time", "T",
     "fields along x of the snapshot nearest to T (0.2ms, or without a unit "
     "in b/u_m)",
     false},
    {"all", NULL, "fields along x of all snapshots", false},
    {"long", NULL,
     "with --all: snapshots one below the other, with a column "
     "of time",
     false},
    {"wide", NULL, "with --all: snapshots side by side, one row per x", false},
    {"at", "X", "fields at X (0.1mm, or without a unit in b) against time",
     true},
    {"across", "Y", "line of a strip (0.1mm, or without a unit in b)", false},
    {"areal", NULL, "strip: all lines, one row per x and y", false},
    {"field", "NAME", "this field only (pressure, film_thickness, ...)", true},
    {"units", "NAME", "stored, hertzian or si", false},
    {"format", "NAME", "csv, gnuplot (# before names) or matlab (%)", false},
    {"o", "FILE", "write to a file", false},
    {"force", NULL, "replace an existing file", false},
    {NULL, NULL, NULL, false},
};

const cli_verb cli_export = {
    .name = "export",
    .no_json = true,
    .arguments = "OUT.h5 [-o FILE]",
    .summary = "export tables for other programs",
    .help = "Without a choice of snapshots: the history, one row per time "
            "step.\n"
            "For a file of several passes, one row per pass is exported.",
    .options = options,
    .minimum = 1,
    .maximum = 1,
    .run = run,
};
