/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/profile_report.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include "cli/json.h"
#include "overroll/run.h"

/* ------------------------------------------------------------------- text */

/* Remarks on a number of a profile. */
typedef enum remark_kind {
    NOTHING,
    SECTIONS,   /* mean over the sampling lengths */
    EVALUATION, /* over all sampling lengths */
    GAUSSIAN,
    SLOPE,
    PEAKS,
    VALLEYS
} remark_kind;

/* Parameters of both kinds with their names (ISO 21920-2). The symbol is
 * preceded by 'P' or 'R'. */
#define OF(member) offsetof(ovr_profile_numbers, member)
static const struct row {
    const char *symbol;
    size_t offset;
    bool is_height;
    const char *name; /* NULL: in JSON only */
    remark_kind remark;
} rows[] = {
    {"a", OF(a), true, "arithmetic mean height", NOTHING},
    {"q", OF(q), true, "root mean square height", NOTHING},
    {"z", OF(z), true, "maximum height", SECTIONS},
    {"p", OF(p), true, "peak height", SECTIONS},
    {"v", OF(v), true, "valley depth", SECTIONS},
    {"t", OF(t), true, "total height", EVALUATION},
    {"sk", OF(sk), false, "skewness", NOTHING},
    {"ku", OF(ku), false, "kurtosis", GAUSSIAN},
    {"dq", OF(dq), false, "root mean square slope", SLOPE},
    {"k", OF(k), true, "core height", NOTHING},
    {"pk", OF(pk), true, "reduced peak height", PEAKS},
    {"vk", OF(vk), true, "reduced valley depth", VALLEYS},
    {"mrk1", OF(mr1), false, NULL, NOTHING},
    {"mrk2", OF(mr2), false, NULL, NOTHING},
};
enum { ROWS = sizeof rows / sizeof *rows };

static double value_of(const struct row *row, const ovr_profile_numbers *n)
{
    double value;
    memcpy(&value, (const char *)n + row->offset, sizeof value);
    return value;
}

static ovr_piece along(const profile_report *r, double value)
{
    return ovr_along(r->profile, value);
}

static ovr_piece across(const profile_report *r, double value)
{
    return ovr_across(r->profile, value);
}

static ovr_piece map_length(const ovr_areal *map, double value)
{
    ovr_piece piece;
    if (!map->scaled_x)
        return ovr_metres(value);
    snprintf(piece.text, sizeof piece.text, "%.4g b", value);
    return piece;
}

static ovr_piece map_height(const ovr_areal *map, double value)
{
    ovr_piece piece;
    if (!map->scaled_z)
        return ovr_metres(value);
    snprintf(piece.text, sizeof piece.text, "%.4g b^2/R", value);
    return piece;
}

/* Prints a line with its label. */
__attribute__((format(printf, 2, 3))) static void
print_line(const char *label, const char *format, ...)
{
    va_list arguments;
    printf("%-*s ", OVR_LABEL_WIDTH, label);
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    putchar('\n');
}

static void print_heading(const char *title)
{
    printf("\n%-*s value\n", OVR_LABEL_WIDTH, title);
}

static void print_map(const profile_report *r)
{
    const ovr_areal *map = r->map;
    const ovr_areal_numbers *n = &r->areal;
    print_heading("areal surface (ISO 25178-2)");
    print_line("points", "%zu x %zu, spacing %s x %s", map->nx, map->ny,
               map_length(map, map->dx).text, map_length(map, map->dy).text);
    print_line("size", "%s x %s",
               map_length(map, map->dx * (double)map->nx).text,
               map_length(map, map->dy * (double)map->ny).text);
    if (map->missing)
        print_line("missing heights", "%zu", map->missing);
    print_line("arithmetic mean height Sa", "%-14s (about the mean plane)",
               map_height(map, n->Sa).text);
    print_line("root mean square height Sq", "%s", map_height(map, n->Sq).text);
    if (!isnan(n->Ssk)) {
        print_line("skewness Ssk", "%.3g", n->Ssk);
        print_line("kurtosis Sku", "%-14.3g (Gaussian: 3)", n->Sku);
    }
    if (!isnan(n->Str))
        print_line("texture aspect ratio Str", "%s%-*.3g (isotropic: 1)",
                   n->Str_is_bound ? "< " : "", n->Str_is_bound ? 12 : 14,
                   n->Str);
    if (!isnan(n->lay))
        print_line("lay", "%-14.3g (degrees to the x axis)",
                   fabs(n->lay) < 5e-4 ? 0 : n->lay);
    else
        print_line("lay", "none");
}

static void print_points(const profile_report *r)
{
    const ovr_profile_view *v = r->view;
    const ovr_profile_numbers *n = &r->numbers;
    if (r->map)
        print_heading("line");
    print_line("points", "%zu, from x = %s to %s", v->n, along(r, v->x[0]).text,
               along(r, v->x[v->n - 1]).text);
    print_line("length", "%s", along(r, n->length).text);
    if (v->uniform)
        print_line("spacing", "%s, equal", along(r, n->spacing).text);
    else
        print_line("spacing", "%-14s (mean; %s to %s)",
                   along(r, n->spacing).text, along(r, n->spacing_min).text,
                   along(r, n->spacing_max).text);
    print_line("missing heights", "%-14zu (filled: %zu)", r->missing,
               v->filled);
}

/* False for parameters of all sampling lengths if there is only one, and for
 * skewness and kurtosis of a flat profile. */
static bool is_printed(const struct row *row, const ovr_profile_numbers *n)
{
    bool of_all = row->offset == OF(t);
    bool of_shape = row->offset == OF(sk) || row->offset == OF(ku);
    return row->name && !(of_all && n->sections <= 1) &&
           !(of_shape && !(n->q > 0));
}

/* Returns "(mean of 5 sections)", or "". */
static ovr_piece remark_on(const struct row *row, const profile_report *r,
                           const ovr_profile_numbers *n)
{
    ovr_piece p = {""};
    if (row->remark == SECTIONS && n->sections > 1)
        snprintf(p.text, sizeof p.text, "(mean of %d sections)", n->sections);
    else if (row->remark == EVALUATION)
        snprintf(p.text, sizeof p.text, "(all %d sections)", n->sections);
    else if (row->remark == GAUSSIAN)
        snprintf(p.text, sizeof p.text, "(Gaussian: 3)");
    else if (row->remark == SLOPE && r->view->scaled_x)
        snprintf(p.text, sizeof p.text, "((b^2/R)/b)");
    else if (row->remark == PEAKS)
        snprintf(p.text, sizeof p.text, "(%.1f %% of the length)",
                 100 * n->mr1);
    else if (row->remark == VALLEYS)
        snprintf(p.text, sizeof p.text, "(%.1f %% of the length)",
                 100 * (1 - n->mr2));
    return p;
}

static void print_kind(const profile_report *r, const ovr_profile_numbers *n)
{
    for (const struct row *row = rows; row < rows + ROWS; row++) {
        double value = value_of(row, n);
        char label[64];
        ovr_piece remark, height;
        if (!is_printed(row, n))
            continue;
        /* Rounding error of heights of this size, or of numbers of order 1. */
        if (fabs(value) < 1e-12 * (row->is_height ? n->t + fabs(n->mean) : 1))
            value = 0;
        remark = remark_on(row, r, n);
        snprintf(label, sizeof label, "%s %c%s", row->name, n->kind,
                 row->symbol);
        if (row->is_height)
            height = across(r, value);
        else
            snprintf(height.text, sizeof height.text, "%.4g", value);
        print_line(label, "%-*s%s%s", *remark.text ? 14 : 0, height.text,
                   *remark.text ? " " : "", remark.text);
    }
}

static void print_sections(const profile_report *r)
{
    const ovr_profile_numbers *n = &r->filtered;
    double lc = r->view->lambda_c;
    print_heading("roughness profile (ISO 21920-2)");
    print_line("cut-off lambda_c", "%s%s", along(r, lc).text,
               lc > n->length + n->spacing ? " (longer than the profile)" : "");
    if (lc <= n->length + n->spacing)
        print_line("sections", "%d of %s%s", n->sections,
                   along(r, n->section).text,
                   n->sections < 5 ? " (usual: 5)" : "");
}

/* Returns a suggested cut-off in metres; NAN if there is none or the unit is
 * unknown. */
static double profile_cutoff(const profile_report *r)
{
    const ovr_profile_numbers *n = &r->numbers;
    return r->view->scaled_x ? NAN : ovr_profile_cutoff(n->length + n->spacing);
}

static void print_suggestion(double metres)
{
    if (isnan(metres))
        puts("\nroughness parameters R: set --lambda-c (the profile is shorter "
             "than five times\n80 um, the smallest cut-off of ISO 21920-3)");
    else
        printf("\nroughness parameters R: set --lambda-c '%s', the cut-off of "
               "ISO 21920-3 for this\nlength\n",
               ovr_metres(metres).text);
}

/* Prints P parameters, and R parameters or a suggested cut-off. */
static void print_heights(const profile_report *r)
{
    print_heading("primary profile (ISO 21920-2)");
    print_kind(r, &r->numbers);
    if (r->filtered.kind) {
        print_sections(r);
        print_kind(r, &r->filtered);
    } else {
        print_suggestion(profile_cutoff(r));
    }
}

static double in_b(const profile_report *r, double wavelength)
{
    return r->view->scaled_x ? wavelength : wavelength / r->contact->b;
}

static double reduction(const profile_report *r, double wavelength)
{
    return ovr_wave_reduction(r->contact->M, r->contact->L,
                              in_b(r, wavelength));
}

static void print_waves(const profile_report *r)
{
    if (!r->waves) {
        puts("\nstrongest waves: none");
        return;
    }
    puts("\nstrongest waves");
    printf("%-14s %-14s %-*s", "wavelength", "amplitude", r->contact ? 10 : 0,
           "variance");
    if (r->contact)
        printf(" %-12s %-14s %s", "wavelength/b", "in the contact",
               "amplitude ratio");
    putchar('\n');
    for (size_t k = 0; k < r->waves; k++) {
        const ovr_profile_wave *w = &r->wave[k];
        char variance[16];
        snprintf(variance, sizeof variance, "%.1f %%", 100 * w->part);
        printf("%-14s %-14s %-*s", along(r, w->wavelength).text,
               across(r, w->amplitude).text, r->contact ? 10 : 0, variance);
        if (r->contact)
            printf(" %-12.4g %-14s %.3g", in_b(r, w->wavelength),
                   across(r, w->amplitude * reduction(r, w->wavelength)).text,
                   reduction(r, w->wavelength));
        putchar('\n');
    }
}

/* Returns E* in the unit of the pressures, for the printed p/E*. */
static double modulus(const profile_report *r)
{
    return r->view->scaled_x ? 2 : 1;
}

const ovr_profile_numbers *profile_pressed(const profile_report *r)
{
    return r->filtered.kind ? &r->filtered : &r->numbers;
}

/* Returns E* of the case in Pa; NAN without a case. */
static double E_star(const profile_report *r)
{
    return r->contact && r->contact->kappa > 0 && !r->view->scaled_x
               ? 2 * r->contact->ph / r->contact->kappa
               : NAN;
}

static void print_contact(const profile_report *r)
{
    const ovr_profile_numbers *n = profile_pressed(r);
    double E = E_star(r);
    puts("\ndry contact with a smooth surface (elastic, plane strain; E* = "
         "E'/2; exponential law:\n0.38 exp(-2.15 gap/Rq))");
    printf("%-14s %-14s %-16s %-16s%s\n", "p/(E* slope)", "mean gap",
           "contact fraction", "exponential law", isnan(E) ? "" : " p");
    for (size_t k = 0; k < r->points; k += 2) {
        const ovr_dry_point *at = &r->bears[k];
        printf("%-14.4g %-14s %-16.4g %-16.4g",
               at->pressure / modulus(r) / n->dq, across(r, at->gap).text,
               at->area, 0.38 * exp(-2.15 * at->gap / n->q));
        if (!isnan(E))
            printf(" %.4g MPa", at->pressure * E * 1e-6);
        putchar('\n');
    }
}

void profile_print_text(const profile_report *r)
{
    const char *note = r->view->notes;
    print_line("file", "%s", r->file);
    print_line("format", "%s", r->view->format);
    while (*note) {
        int size = (int)strcspn(note, "\n");
        print_line(note == r->view->notes ? "interpretation" : "", "%.*s", size,
                   note);
        note += size + (note[size] != 0);
    }
    if (r->map)
        print_map(r);
    print_points(r);
    print_heights(r);
    print_waves(r);
    if (r->points)
        print_contact(r);
}

/* ------------------------------------------------------------------- JSON */

static void write_number(json_writer *json, const profile_report *r,
                         const char *name, double value, bool is_height)
{
    char key[64];
    bool scaled = is_height ? r->view->scaled_z : r->view->scaled_x;
    snprintf(key, sizeof key, "%s%s", name, scaled ? "" : "_m");
    json_number(json, key, value);
}

static void write_map(json_writer *json, const profile_report *r)
{
    const ovr_areal *map = r->map;
    json_open(json, "map");
    json_integer(json, "columns", (long long)map->nx);
    json_integer(json, "rows", (long long)map->ny);
    write_number(json, r, "dx", map->dx, false);
    write_number(json, r, "dy", map->dy, false);
    json_integer(json, "missing", (long long)map->missing);
    write_number(json, r, "Sa", r->areal.Sa, true);
    write_number(json, r, "Sq", r->areal.Sq, true);
    json_number(json, "Ssk", r->areal.Ssk);
    json_number(json, "Sku", r->areal.Sku);
    json_number(json, "Str", r->areal.Str);
    json_flag(json, "Str_is_upper_bound", r->areal.Str_is_bound);
    json_number(json, "lay_degrees", r->areal.lay);
    json_close(json);
}

/* Writes the parameters of a kind; null if it does not exist. */
static void write_kind(json_writer *json, const profile_report *r, char kind,
                       const ovr_profile_numbers *n)
{
    for (const struct row *row = rows; row < rows + ROWS; row++) {
        double value = n->kind ? value_of(row, n) : NAN;
        char name[8];
        snprintf(name, sizeof name, "%c%s", kind, row->symbol);
        if (row->is_height)
            write_number(json, r, name, value, true);
        else
            json_number(json, name, value);
    }
}

static void write_waves(json_writer *json, const profile_report *r)
{
    json_open_array(json, "waves");
    for (size_t k = 0; k < r->waves; k++) {
        const ovr_profile_wave *w = &r->wave[k];
        json_open(json, NULL);
        write_number(json, r, "wavelength", w->wavelength, false);
        write_number(json, r, "amplitude", w->amplitude, true);
        json_number(json, "part_of_variance", w->part);
        if (r->contact) {
            json_number(json, "wavelength_over_b", in_b(r, w->wavelength));
            json_number(json, "amplitude_ratio", reduction(r, w->wavelength));
        }
        json_close(json);
    }
    json_close_array(json);
}

static void write_contact(json_writer *json, const profile_report *r)
{
    json_open_array(json, "contact");
    for (size_t k = 0; k < r->points; k++) {
        const ovr_dry_point *at = &r->bears[k];
        json_open(json, NULL);
        json_number(json,
                    r->view->scaled_x ? "pressure" : "pressure_over_E_star",
                    at->pressure);
        write_number(json, r, "mean_gap", at->gap, true);
        json_number(json, "area", at->area);
        if (!isnan(E_star(r)))
            json_number(json, "pressure_Pa", at->pressure * E_star(r));
        json_close(json);
    }
    json_close_array(json);
}

void profile_print_json(const profile_report *r)
{
    const ovr_profile_numbers *n = &r->numbers;
    json_writer json = json_begin(stdout);
    json_text(&json, "file", r->file);
    json_text(&json, "format", r->view->format);
    json_text(&json, "understood", r->view->notes);
    if (r->map)
        write_map(&json, r);
    json_integer(&json, "points", (long long)n->n);
    json_integer(&json, "missing", (long long)r->missing);
    json_integer(&json, "filled", (long long)r->view->filled);
    json_flag(&json, "uniform", r->view->uniform);
    write_number(&json, r, "length", n->length, false);
    write_number(&json, r, "spacing", n->spacing, false);
    write_number(&json, r, "spacing_least", n->spacing_min, false);
    write_number(&json, r, "spacing_most", n->spacing_max, false);
    write_number(&json, r, "lambda_c", r->view->lambda_c, false);
    json_number(&json, "lambda_c_suggested_m", profile_cutoff(r));
    json_integer(&json, "sections", r->filtered.sections);
    write_kind(&json, r, 'P', &r->numbers);
    write_kind(&json, r, 'R', &r->filtered);
    write_waves(&json, r);
    if (r->points)
        write_contact(&json, r);
    json_end(&json);
}
