/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll info OUT.h5: contents of a result file. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/cli.h"
#include "cli/json.h"
#include "cli/table.h"

/* Minimum and maximum of a history column, and their times. */
typedef struct extremes {
    double minimum, T_min, maximum, T_max;
} extremes;

typedef struct report {
    ovr_result *result;
    const ovr_result_info *about;
    const char *path;
    double *T, *column; /* history columns; T in b/u_m */
    double bytes;       /* size of the file */
} report;

static extremes find_extremes(const report *r)
{
    extremes e = {NAN, NAN, NAN, NAN};
    for (size_t k = 0; k < r->about->steps; k++) {
        double value = r->column[k];
        if (isnan(value))
            continue;
        if (!(value >= e.minimum)) {
            e.minimum = value;
            e.T_min = r->T[k];
        }
        if (!(value <= e.maximum)) {
            e.maximum = value;
            e.T_max = r->T[k];
        }
    }
    return e;
}

static double last_time(const report *r)
{
    return r->about->steps ? r->T[r->about->steps - 1] : NAN;
}

/* Returns the completed fraction of the run time; NAN if unknown. */
static double progress(const report *r)
{
    if (strcmp(r->about->status, "complete") == 0)
        return 1;
    return fmin(1, last_time(r) / r->about->end);
}

/* Reads a column into r->column; false if it is missing. */
static bool read_column(report *r, const char *name, ovr_units units)
{
    return ovr_result_history(r->result, name, units, r->column, NULL) ==
           OVR_OK;
}

static double sum(const report *r)
{
    double total = 0;
    for (size_t k = 0; k < r->about->steps; k++)
        total += r->column[k];
    return total;
}

/* ------------------------------------------------------------------- text */

/* Width of the labels, as in the reports of runs. */
enum { LABEL = 31 };

static void print_label(const char *label)
{
    printf("%-*s ", LABEL, label);
}

/* Numbers of the contact. `si`: name of the SI unit; 0: dimensionless. */
#define OF(member) offsetof(ovr_result_info, member)
static const struct fact {
    const char *label;
    int digits;
    const char *unit;
    double si;
    const char *key;
    size_t offset;
} facts[] = {
    {"Moes' load number M", 6, "", 0, "M", OF(M)},
    {"Moes' lubricant number L", 6, "", 0, "L", OF(L)},
    {"alpha p_h", 5, "", 0, "alphabar", OF(alphabar)},
    {"dimensionless speed parameter", 5, "", 0, "lambda", OF(lambda)},
    {"speed of surface 1, u1/u_m", 6, "", 0, "u1_over_um", OF(u1_ratio)},
    {"speed of surface 2, u2/u_m", 6, "", 0, "u2_over_um", OF(u2_ratio)},
    {"Hertzian half-width b", 5, "um", 1e-6, "half_width_m", OF(b)},
    {"maximum Hertzian pressure p_h", 5, "GPa", 1e9, "hertz_pressure_Pa",
     OF(ph)},
    {"film thickness unit b^2/R", 5, "um", 1e-6, "film_scale_m", OF(height)},
    {"time unit b/u_m", 5, "us", 1e-6, "time_scale_s", OF(time)},
};
enum { FACTS = sizeof facts / sizeof *facts };

static double value_of(const struct fact *f, const ovr_result_info *a)
{
    double value;
    memcpy(&value, (const char *)a + f->offset, sizeof value);
    return value;
}

static void print_contact(const ovr_result_info *a)
{
    for (const struct fact *f = facts; f < facts + FACTS; f++) {
        if (f->si > 0 && !a->physical)
            continue;
        print_label(f->label);
        printf("%.*g%s%s\n", f->digits,
               value_of(f, a) / (f->si > 0 ? f->si : 1), *f->unit ? " " : "",
               f->unit);
    }
    if (!a->physical) {
        print_label("units");
        puts("dimensionless");
    }
}

static void print_history(const report *r)
{
    const ovr_result_info *a = r->about;
    print_label("history");
    printf("%zu step%s", a->steps, a->steps == 1 ? "" : "s");
    if (a->steps)
        printf(", T = %g to %g", r->T[0], last_time(r));
    if (!isnan(a->end))
        printf(" of %g (%.0f %%)", a->end, 100 * progress(r));
    if (a->steps && a->physical)
        printf(", t = %.4g to %.4g ms", r->T[0] * a->time * 1e3,
               last_time(r) * a->time * 1e3);
    putchar('\n');
}

static void print_sizes(report *r)
{
    const ovr_result_info *a = r->about;
    const ovr_observable *of;
    print_label("nodes");
    printf("%zu", a->nodes);
    if (a->lines > 1)
        printf(" x %zu lines, a strip %.6g b wide", a->lines, a->width);
    putchar('\n');
    print_label("fields");
    for (size_t k = 0; k < ovr_result_fields(r->result); k++)
        printf("%s%s [%s]", k ? ", " : "", ovr_result_field(r->result, k)->name,
               ovr_result_field(r->result, k)->unit);
    putchar('\n');
    print_label("snapshots");
    printf("%zu\n", a->snapshots);
    print_history(r);
    print_label("size");
    printf("%.3g MB\n", r->bytes / 1e6);
    for (size_t k = 0; (of = ovr_observable_at(k)); k++)
        if (of->total_label && read_column(r, of->name, OVR_AS_STORED)) {
            print_label(of->total_label);
            printf("%.0f%s\n", sum(r),
                   of->kind == OVR_KIND_FLAG ? " steps" : "");
        }
}

/* True for columns with a row in the table of extremes. */
static bool has_extremes(report *r, const ovr_variable *v)
{
    return strcmp(v->name, "step") != 0 && strcmp(v->name, "time") != 0 &&
           read_column(r, v->name, OVR_AS_STORED);
}

/* Returns the full name; the name of the dataset for files of earlier versions,
 * which contain a sentence instead. */
static const char *name_of(const ovr_variable *v)
{
    enum { LONGEST = 48 };
    return strlen(v->long_name) <= LONGEST ? v->long_name : v->name;
}

/* Prints a number; "-" for NaN (unknown). */
static void print_number(double value, int width, int digits)
{
    if (isnan(value))
        printf(" %*s", width, "-");
    else
        printf(" %*.*g", width, digits, value);
}

static void print_extremes(report *r)
{
    const ovr_result_info *about = r->about;
    double ms = about->physical ? about->time * 1e3 : 1;
    const char *at = about->physical ? "at t, ms" : "at T";
    int width = LABEL;
    const ovr_variable *v;
    for (size_t k = 0; (v = ovr_result_column(r->result, k)); k++)
        if (has_extremes(r, v) && (int)strlen(name_of(v)) > width)
            width = (int)strlen(name_of(v));
    printf("\n%-*s %13s %9s %13s %9s  %-7s %s\n", width, "quantity", "minimum",
           at, "maximum", at, "unit", "dataset");
    for (size_t k = 0; (v = ovr_result_column(r->result, k)); k++) {
        extremes e;
        cli_unit as;
        if (!has_extremes(r, v))
            continue;
        e = find_extremes(r);
        cli_put_foreign(name_of(v));
        printf("%*s", width - (int)strlen(name_of(v)), "");
        as = cli_choose_unit(v->unit, fmax(fabs(e.minimum), fabs(e.maximum)));
        print_number(e.minimum * as.factor, 13, 6);
        print_number(e.T_min * ms, 9, 4);
        print_number(e.maximum * as.factor, 13, 6);
        print_number(e.T_max * ms, 9, 4);
        printf("  %-7s %s\n", as.name, v->name);
    }
}

static void print_foreign(const char *before, const char *text);

static void print_inputs(const report *r)
{
    const ovr_result_input *input;
    for (size_t k = 0; (input = ovr_result_input_at(r->result, k)); k++) {
        print_label("input");
        print_foreign("", input->name);
        print_foreign(" (", input->key);
        printf(")");
        if (input->bytes >= 0)
            printf(", %.0f bytes", input->bytes);
        if (*input->sha256)
            print_foreign(", SHA-256 ", input->sha256);
        printf("%s\n", input->kept ? "" : ", not in the file");
    }
}

static void print_foreign(const char *before, const char *text)
{
    fputs(before, stdout);
    cli_put_foreign(text);
}

static void print_text(report *r, bool verbose)
{
    const ovr_result_info *a = r->about;
    print_foreign("", r->path);
    print_foreign(": ", a->title);
    putchar('\n');
    print_label("status");
    print_foreign("", a->status);
    if (*a->reason)
        print_foreign(": ", a->reason);
    putchar('\n');
    print_label("written");
    print_foreign("", a->created);
    print_foreign(" to ", a->modified);
    print_foreign(" by ", a->source);
    putchar('\n');
    if (a->seconds > 0) {
        print_label("computing time");
        printf("%.3g s\n", a->seconds);
    }
    print_contact(a);
    print_sizes(r);
    print_inputs(r);
    if (a->steps)
        print_extremes(r);
    if (verbose)
        printf("\n%s", a->case_text);
}

/* ------------------------------------------------------------------- JSON */

static void json_contact(json_writer *j, const ovr_result_info *a)
{
    for (const struct fact *f = facts; f < facts + FACTS; f++) {
        if (f->si > 0 && !(f[-1].si > 0))
            json_flag(j, "physical", a->physical);
        json_number(j, f->key, value_of(f, a));
    }
}

static void json_sizes(json_writer *j, const report *r)
{
    json_integer(j, "nodes", (long long)r->about->nodes);
    if (r->about->lines > 1) {
        json_integer(j, "lines", (long long)r->about->lines);
        json_number(j, "width_over_b", r->about->width);
    }
    json_integer(j, "snapshots", (long long)r->about->snapshots);
    json_integer(j, "steps", (long long)r->about->steps);
    json_number(j, "T", last_time(r));
    json_number(j, "T_end", r->about->end);
    json_number(j, "progress", progress(r));
    json_number(j, "bytes", r->bytes);
    json_open_array(j, "fields");
    for (size_t k = 0; k < ovr_result_fields(r->result); k++)
        json_text(j, NULL, ovr_result_field(r->result, k)->name);
    json_close_array(j);
}

/* Writes the extremes, dimensionless like all JSON of this program. */
static void json_extremes(json_writer *j, report *r)
{
    json_open(j, "extremes");
    const ovr_variable *v;
    for (size_t k = 0; (v = ovr_result_column(r->result, k)); k++) {
        extremes e;
        if (!strcmp(v->name, "step") || !read_column(r, v->name, OVR_HERTZIAN))
            continue;
        e = find_extremes(r);
        json_open(j, v->name);
        json_number(j, "min", e.minimum);
        json_number(j, "T_min", e.T_min);
        json_number(j, "max", e.maximum);
        json_number(j, "T_max", e.T_max);
        json_close(j);
    }
    json_close(j);
}

static void json_inputs(json_writer *j, const report *r)
{
    const ovr_result_input *input;
    json_open_array(j, "inputs");
    for (size_t k = 0; (input = ovr_result_input_at(r->result, k)); k++) {
        json_open(j, NULL);
        json_text(j, "key", input->key);
        json_text(j, "name", input->name);
        json_text(j, "sha256", input->sha256);
        json_number(j, "bytes", input->bytes);
        json_flag(j, "kept", input->kept);
        json_close(j);
    }
    json_close_array(j);
}

static void print_json(report *r)
{
    const ovr_result_info *a = r->about;
    const ovr_observable *of;
    json_writer j = json_begin(stdout);
    json_text(&j, "file", r->path);
    json_text(&j, "title", a->title);
    json_text(&j, "status", a->status);
    json_text(&j, "reason", a->reason);
    json_text(&j, "source", a->source);
    json_text(&j, "created", a->created);
    json_text(&j, "modified", a->modified);
    json_number(&j, "seconds", a->seconds);
    json_contact(&j, a);
    json_sizes(&j, r);
    json_inputs(&j, r);
    for (size_t k = 0; (of = ovr_observable_at(k)); k++)
        if (of->total_key && read_column(r, of->name, OVR_AS_STORED))
            json_integer(&j, of->total_key, (long long)sum(r));
    json_extremes(&j, r);
    json_text(&j, "case", a->case_text);
    json_end(&j);
}

/* ---------------------------------------------------------------- command */

static ovr_status read_times(report *r, ovr_error *err)
{
    struct stat about;
    size_t steps = r->about->steps;
    r->bytes = stat(r->path, &about) == 0 ? (double)about.st_size : NAN;
    r->T = calloc(steps + 1, sizeof *r->T);
    r->column = calloc(steps + 1, sizeof *r->column);
    if (!r->T || !r->column) {
        ovr_fail(err, OVR_NO_MEMORY, "out of memory: a history of %zu steps",
                 steps);
        return OVR_NO_MEMORY;
    }
    return ovr_result_history(r->result, "time", OVR_HERTZIAN, r->T, err);
}

/* Prints the written files; warnings are forwarded. */
static void list_file(void *call, ovr_message_kind kind, const char *text)
{
    if (kind == OVR_MESSAGE_FILE)
        printf("%s\n", text);
    else
        cli_say(call, kind, text);
}

static int run(cli_call *call)
{
    ovr_error err = {0};
    const char *folder = cli_value(call, "inputs");
    if (folder)
        return ovr_result_unpack(call->argument[0], folder,
                                 cli_flag(call, "force"), list_file, call, &err)
                   ? cli_fail(&err)
                   : CLI_DONE;
    report r = {NULL, NULL, call->argument[0], NULL, NULL, 0};
    int code = CLI_DONE;
    ovr_table *passes = cli_passes_open(r.path);
    if (passes) {
        cli_passes_print(r.path, passes, call->json);
        ovr_table_free(passes);
        return CLI_DONE;
    }
    r.result = ovr_result_open(r.path, NULL, &err);
    if (!r.result)
        return cli_fail(&err);
    r.about = ovr_result_get_info(r.result);
    if (read_times(&r, &err) != OVR_OK)
        code = cli_fail(&err);
    else if (call->json)
        print_json(&r);
    else
        print_text(&r, call->verbosity > 0);
    free(r.column);
    free(r.T);
    ovr_result_close(r.result);
    return code;
}

static const cli_option options[] = {
    {"inputs", "DIR", "write the case and its input files into a folder",
     false},
    {"force", NULL, "replace files there", false},
    {NULL, NULL, NULL, false}};

const cli_verb cli_info = {
    .name = "info",
    .arguments = "OUT.h5 [--inputs DIR]",
    .options = options,
    .summary = "print the contents of a result file",
    .help = "For the table of several passes, its rows are printed.\nWorks "
            "while the file is "
            "being written. With -v the case is "
            "printed too.\nWith --inputs DIR the case and the files that it "
            "names are written into DIR; running that case computes the "
            "result again.\nLengths are printed in mm, um or nm, pressures in "
            "GPa or MPa, times in ms or us; --json is dimensionless.",
    .minimum = 1,
    .maximum = 1,
    .run = run,
};
