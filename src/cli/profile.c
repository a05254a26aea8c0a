/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll profile FILE: what a surface profile holds. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/cli.h"
#include "cli/json.h"
#include "cli/profile_plot.h"
#include "surface/text.h"

enum { WAVES = 5 };

typedef struct report {
    const char *file;
    ovr_profile *profile;
    const ovr_profile_view *view;
    ovr_profile_numbers numbers;
    ovr_profile_wave wave[WAVES];
    size_t waves;
    size_t missing;             /* heights, as read */
    const ovr_contact *contact; /* of --case, or NULL */
} report;

/* -------------------------------------------------------------- arguments */

/* "12 um" in metres, a bare number as it is (for profiles in b). */
static int take_length(const cli_call *call, const char *name, double *value)
{
    const char *text = cli_value(call, name);
    ovr_line rest, number, unit;
    double metres;
    if (!text)
        return CLI_DONE;
    rest = (ovr_line){text, strlen(text), 0};
    number = (ovr_line){text, strspn(text, "+-0123456789.eE"), 0};
    rest.text += number.size;
    rest.size -= number.size;
    unit = ovr_trim(rest);
    metres = unit.size ? ovr_length_unit(unit, true) : 1;
    if (!ovr_number(ovr_trim(number), false, value) || !(metres > 0))
        return cli_usage(call,
                         "--%s %s: a length with its unit is wanted, like "
                         "'12 um'",
                         name, text);
    *value *= metres;
    return CLI_DONE;
}

static int take_number(const cli_call *call, const char *name, double *value)
{
    const char *text = cli_value(call, name);
    if (!text)
        return CLI_DONE;
    if (ovr_number((ovr_line){text, strlen(text), 0}, false, value))
        return CLI_DONE;
    return cli_usage(call, "--%s %s: a number is wanted", name, text);
}

static int take_whole(const cli_call *call, const char *name, int *value)
{
    double number = *value;
    int code = take_number(call, name, &number);
    if (code)
        return code;
    if (!(number >= 0 && number <= 1e9) || number != floor(number))
        return cli_usage(call, "--%s %s: a whole number is wanted", name,
                         cli_value(call, name));
    *value = (int)number;
    return CLI_DONE;
}

static int take_level(const cli_call *call, ovr_levelling *level)
{
    static const char *const words[] = {"none", "mean", "line", "polynomial",
                                        "ends"};
    const char *text = cli_value(call, "level");
    for (int k = 0; text && k < 5; k++)
        if (strcmp(text, words[k]) == 0) {
            *level = (ovr_levelling)k;
            return CLI_DONE;
        }
    return text ? cli_usage(call,
                            "--level %s: none, mean, line, polynomial or ends "
                            "is wanted",
                            text)
                : CLI_DONE;
}

static int take_source(const cli_call *call, ovr_profile_source *source)
{
    int code = take_length(call, "spacing", &source->spacing);
    source->file = call->argument[0];
    source->unit_x = cli_value(call, "unit-x");
    source->unit_z = cli_value(call, "unit-z");
    source->spacing_scaled = source->unit_x && !strcmp(source->unit_x, "b");
    if (!code)
        code = take_whole(call, "column-x", &source->column_x);
    if (!code)
        code = take_whole(call, "column-z", &source->column_z);
    return code ? code : take_whole(call, "line", &source->line);
}

static int take_conditioning(const cli_call *call, ovr_conditioning *how)
{
    const struct {
        const char *name;
        double *value;
    } lengths[] = {{"from", &how->from},         {"to", &how->to},
                   {"lambda-c", &how->lambda_c}, {"lambda-s", &how->lambda_s},
                   {"max-gap", &how->max_gap},   {"offset", &how->offset}};
    int code = take_level(call, &how->level);
    for (size_t k = 0; !code && k < sizeof lengths / sizeof lengths[0]; k++)
        code = take_length(call, lengths[k].name, lengths[k].value);
    if (!code)
        code = take_whole(call, "degree", &how->degree);
    if (!code)
        code = take_number(call, "outliers", &how->outliers);
    if (!code)
        code = take_number(call, "scale", &how->scale);
    if (!code)
        code = take_number(call, "max-missing", &how->max_missing);
    how->invert = cli_flag(call, "invert");
    how->reverse = cli_flag(call, "reverse");
    return code;
}

/* ------------------------------------------------------------------- text */

/* "12.3 um": three steps of a thousand below the metre. */
static const char *length(double value, bool scaled, const char *own)
{
    static char texts[4][40];
    static unsigned turn;
    static const char *const units[] = {"m", "mm", "um", "nm"};
    char *text = texts[turn++ % 4];
    int k = 0;
    for (double size = fabs(value); !scaled && size < 0.1 && size > 0 && k < 3;)
        size *= 1e3, value *= 1e3, k++;
    snprintf(text, sizeof texts[0], "%.4g %s", value,
             scaled       ? own
             : value == 0 ? "m"
                          : units[k]);
    return text;
}

static const char *along(const report *r, double value)
{
    return length(value, r->view->scaled_x, "b");
}

static const char *across(const report *r, double value)
{
    return length(value, r->view->scaled_z, "b^2/R");
}

static void print_points(const report *r)
{
    const ovr_profile_view *v = r->view;
    const ovr_profile_numbers *n = &r->numbers;
    printf("points     %zu, from x = %s to %s\n", v->n, along(r, v->x[0]),
           along(r, v->x[v->n - 1]));
    printf("length     %s\n", along(r, n->length));
    if (v->uniform)
        printf("spacing    %s, equal\n", along(r, n->spacing));
    else
        printf("spacing    %s in the mean, from %s to %s\n",
               along(r, n->spacing), along(r, n->spacing_least),
               along(r, n->spacing_most));
    printf("gaps       %zu heights missing, %zu filled\n", r->missing,
           v->filled);
}

static void print_heights(const report *r)
{
    const ovr_profile_numbers *n = &r->numbers;
    const struct {
        const char *name, *meaning;
        double value;
    } rows[] = {{"Ra", "mean deviation", n->Ra},
                {"Rq", "root mean square", n->Rq},
                {"Rz", "peak to valley, mean of five parts", n->Rz},
                {"Rp", "highest peak", n->Rp},
                {"Rv", "deepest valley", n->Rv}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++)
        printf("%-10s %-14s %s\n", rows[k].name, across(r, rows[k].value),
               rows[k].meaning);
    if (n->Rq > 0) {
        printf("%-10s %-14.4g skewness\n", "Rsk", n->Rsk);
        printf("%-10s %-14.4g kurtosis (3: Gaussian)\n", "Rku", n->Rku);
    }
    printf("%-10s %-14.4g root mean square slope%s\n", "Rdq", n->Rdq,
           r->view->scaled_x ? ", (b^2/R)/b" : "");
}

static double in_b(const report *r, double wavelength)
{
    return r->view->scaled_x ? wavelength : wavelength / r->contact->b;
}

static double reduction(const report *r, double wavelength)
{
    return ovr_wave_reduction(r->contact->M, r->contact->L,
                              in_b(r, wavelength));
}

static void print_waves(const report *r)
{
    if (!r->waves) {
        puts("\nwaves      none");
        return;
    }
    printf("\nwaves      %-14s %-14s %-10s", "wavelength", "amplitude",
           "variance");
    if (r->contact)
        printf(" %-12s %s", "wavelength/b", "amplitude in the contact");
    putchar('\n');
    for (size_t k = 0; k < r->waves; k++) {
        const ovr_profile_wave *w = &r->wave[k];
        printf("           %-14s %-14s %-4.1f %%    ", along(r, w->wavelength),
               across(r, w->amplitude), 100 * w->part);
        if (r->contact)
            printf(" %-12.4g %s (x %.3g)", in_b(r, w->wavelength),
                   across(r, w->amplitude * reduction(r, w->wavelength)),
                   reduction(r, w->wavelength));
        putchar('\n');
    }
}

static void print_text(const report *r)
{
    const char *note = r->view->notes;
    printf("file       %s\nformat     %s\n", r->file, r->view->format);
    while (*note) {
        int size = (int)strcspn(note, "\n");
        printf("%-10s %.*s\n", note == r->view->notes ? "understood" : "", size,
               note);
        note += size + (note[size] != 0);
    }
    print_points(r);
    print_heights(r);
    print_waves(r);
}

/* ------------------------------------------------------------------- JSON */

static void put(json_writer *json, const report *r, const char *name,
                double value, bool is_height)
{
    char key[64];
    bool scaled = is_height ? r->view->scaled_z : r->view->scaled_x;
    snprintf(key, sizeof key, "%s%s", name, scaled ? "" : "_m");
    json_number(json, key, value);
}

static void put_waves(json_writer *json, const report *r)
{
    json_open_array(json, "waves");
    for (size_t k = 0; k < r->waves; k++) {
        const ovr_profile_wave *w = &r->wave[k];
        json_open(json, NULL);
        put(json, r, "wavelength", w->wavelength, false);
        put(json, r, "amplitude", w->amplitude, true);
        json_number(json, "part_of_variance", w->part);
        if (r->contact) {
            json_number(json, "wavelength_over_b", in_b(r, w->wavelength));
            json_number(json, "amplitude_ratio", reduction(r, w->wavelength));
        }
        json_close(json);
    }
    json_close_array(json);
}

static void print_json(const report *r)
{
    const ovr_profile_numbers *n = &r->numbers;
    json_writer json = json_begin(stdout);
    json_text(&json, "file", r->file);
    json_text(&json, "format", r->view->format);
    json_text(&json, "understood", r->view->notes);
    json_integer(&json, "points", (long long)n->n);
    json_integer(&json, "missing", (long long)r->missing);
    json_integer(&json, "filled", (long long)r->view->filled);
    json_flag(&json, "uniform", r->view->uniform);
    put(&json, r, "length", n->length, false);
    put(&json, r, "spacing", n->spacing, false);
    put(&json, r, "spacing_least", n->spacing_least, false);
    put(&json, r, "spacing_most", n->spacing_most, false);
    put(&json, r, "Ra", n->Ra, true);
    put(&json, r, "Rq", n->Rq, true);
    put(&json, r, "Rz", n->Rz, true);
    put(&json, r, "Rp", n->Rp, true);
    put(&json, r, "Rv", n->Rv, true);
    json_number(&json, "Rsk", n->Rsk);
    json_number(&json, "Rku", n->Rku);
    json_number(&json, "Rdq", n->Rdq);
    put_waves(&json, r);
    json_end(&json);
}

/* ------------------------------------------------------------------- work */

static int check_output(const cli_call *call, const char *option)
{
    const char *path = cli_value(call, option);
    if (path && !cli_flag(call, "force") && access(path, F_OK) == 0)
        return cli_usage(call, "%s exists; --force overwrites it", path);
    return CLI_DONE;
}

static int write_outputs(const cli_call *call, const report *r)
{
    const char *copy = cli_value(call, "convert");
    const char *picture = cli_value(call, "plot");
    ovr_error err;
    if (copy && ovr_profile_save(r->profile, copy, &err))
        return cli_fail(&err);
    if (picture && cli_plot_profile(r->view, r->file, picture, &err))
        return cli_fail(&err);
    return CLI_DONE;
}

static int measure(const cli_call *call, report *r, const ovr_conditioning *how)
{
    ovr_error err;
    int code;
    r->missing = ovr_profile_look(r->profile)->missing;
    if (ovr_profile_condition(r->profile, how, &err) ||
        ovr_profile_measure(r->profile, &r->numbers, &err) ||
        ovr_profile_waves(r->profile, WAVES, r->wave, &r->waves, &err))
        return cli_fail(&err);
    r->view = ovr_profile_look(r->profile);
    code = write_outputs(call, r);
    if (!code && call->json)
        print_json(r);
    else if (!code)
        print_text(r);
    return code;
}

/* The contact of --case; NULL without one. */
static int take_case(const cli_call *call, ovr_setup **setup)
{
    const char *path = cli_value(call, "case");
    ovr_error err;
    ovr_case *c;
    *setup = NULL;
    if (!path)
        return CLI_DONE;
    c = ovr_case_read(path, NULL, &err);
    *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    ovr_case_free(c);
    return *setup ? CLI_DONE : cli_fail(&err);
}

static int report_on(const cli_call *call, const ovr_profile_source *source,
                     const ovr_conditioning *how, const ovr_contact *contact)
{
    report r = {.file = call->argument[0], .contact = contact};
    ovr_error err;
    int code;
    r.profile = ovr_profile_read(source, NULL, &err);
    if (!r.profile)
        return cli_fail(&err);
    if (contact && !(contact->b > 0) && !ovr_profile_look(r.profile)->scaled_x)
        code = cli_usage(call,
                         "%s has no physical scale: it needs radius and "
                         "modulus for a profile in metres",
                         cli_value(call, "case"));
    else
        code = measure(call, &r, how);
    ovr_profile_free(r.profile);
    return code;
}

static int run(cli_call *call)
{
    ovr_profile_source source = ovr_profile_source_default();
    ovr_conditioning how = ovr_conditioning_default();
    ovr_setup *setup = NULL;
    int code = take_source(call, &source);
    if (!code)
        code = take_conditioning(call, &how);
    if (!code)
        code = check_output(call, "convert");
    if (!code)
        code = check_output(call, "plot");
    if (!code)
        code = take_case(call, &setup);
    if (!code)
        code = report_on(call, &source, &how, setup ? &setup->contact : NULL);
    ovr_setup_free(setup);
    return code;
}

static const cli_option options[] = {
    {"unit-x", "UNIT", "unit of x where the file does not say it (um, mm, b)",
     false},
    {"unit-z", "UNIT", "unit of z where the file does not say it", false},
    {"spacing", "LENGTH", "distance of the heights of a single column", false},
    {"column-x", "N", "column of x, from 1", false},
    {"column-z", "N", "column of z, from 1", false},
    {"line", "N", "line of an areal file, from 1", false},
    {"from", "LENGTH", "start of the part of x that is used", false},
    {"to", "LENGTH", "end of that part", false},
    {"level", "HOW", "none, mean, line (default), polynomial, ends", false},
    {"degree", "N", "of the polynomial, 2", false},
    {"lambda-c", "LENGTH", "take longer waves out (Gaussian cut-off)", false},
    {"lambda-s", "LENGTH", "take shorter waves out (Gaussian cut-off)", false},
    {"outliers", "K", "replace points K robust deviations off", false},
    {"max-gap", "LENGTH", "longest gap to fill; else 5 % of the length", false},
    {"max-missing", "PART", "largest missing part, 0.2", false},
    {"scale", "FACTOR", "heights times this", false},
    {"offset", "LENGTH", "added to the heights", false},
    {"invert", NULL, "peaks become valleys", false},
    {"reverse", NULL, "x runs the other way", false},
    {"case", "CASE", "how its waves fare in the contact of this case", false},
    {"convert", "OUT.csv", "write it, conditioned, as clean text", false},
    {"plot", "OUT.png", "draw it (png, svg or pdf; gnuplot)", false},
    {"force", NULL, "overwrite what is there", false},
    {NULL, NULL, NULL, false}};

const cli_verb cli_profile = {
    .name = "profile",
    .arguments = "FILE",
    .summary = "read a surface profile, measure, convert, plot",
    .help = "Reads text (also gzipped), SDF, SMD and X3P files, told apart by "
            "content, and prints what was understood, the roughness numbers "
            "of the levelled profile and its strongest waves. What the file "
            "does not say (units, spacing, columns) is asked for, not "
            "guessed.",
    .options = options,
    .least = 1,
    .most = 1,
    .run = run};
