/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll profile FILE: parameters of a surface profile. */
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "cli/cli.h"
#include "cli/profile_report.h"

/* ------------------------------------------------------------------ options */

/* Conversion of the options of `overroll profile`. Functions print errors and
 * return the exit code. */

/* A number for an option; without unit only for a profile in b. */
typedef struct size {
    const char *name; /* name of the option */
    ovr_length length;
    bool given;
} size;

static int parse_size(const cli_call *call, const char *name, bool is_height,
                      size *given)
{
    const char *text = cli_value(call, name);
    ovr_error err = {0};
    *given = (size){name, {OVR_LENGTH_BARE, NAN}, text != NULL};
    if (text &&
        ovr_length_read(text, is_height ? "b^2/R" : "b", &given->length, &err))
        return cli_usage(call, "--%s %s: %s", name, text, err.message);
    return CLI_DONE;
}

static int no_unit(const cli_call *call, const char *name)
{
    const char *text = cli_value(call, name);
    return cli_usage(call,
                     "--%s %s: needs a unit, such as '%s mm' or '%s um'; "
                     "only profiles in b have lengths without a unit",
                     name, text, text, text);
}

/* Converts a length to the unit of the profile. `unit` is b (or b^2/R) in
 * metres, or 0 if unknown. */
static int convert_length(const cli_call *call, size given, bool scaled,
                          double unit, double *value)
{
    if (!given.given)
        return CLI_DONE;
    if (given.length.unit == OVR_LENGTH_BARE && !scaled)
        return no_unit(call, given.name);
    *value = given.length.value;
    if (given.length.unit == OVR_LENGTH_BARE ||
        (given.length.unit == OVR_LENGTH_SCALED) == scaled)
        return CLI_DONE;
    if (!(unit > 0))
        return cli_usage(call,
                         "--%s %s: the profile is in %s; use that unit, or a "
                         "--case with dimensions",
                         given.name, cli_value(call, given.name),
                         scaled ? "b" : "metres");
    *value = scaled ? given.length.value / unit : given.length.value * unit;
    return CLI_DONE;
}

static int parse_number(const cli_call *call, const char *name, double *value)
{
    const char *text = cli_value(call, name);
    ovr_length number;
    if (!text)
        return CLI_DONE;
    if (!ovr_length_read(text, "", &number, NULL) &&
        number.unit == OVR_LENGTH_BARE) {
        *value = number.value;
        return CLI_DONE;
    }
    return cli_usage(call, "--%s %s: must be a number", name, text);
}

static int parse_whole(const cli_call *call, const char *name, int *value)
{
    double number = *value;
    int code = parse_number(call, name, &number);
    if (code)
        return code;
    if (!(number >= 0 && number <= 1e9) || number != floor(number))
        return cli_usage(call, "--%s %s: must be a whole number", name,
                         cli_value(call, name));
    *value = (int)number;
    return CLI_DONE;
}

static int parse_level(const cli_call *call, ovr_levelling *level)
{
    static const char *const words[] = {"none", "mean",   "line", "polynomial",
                                        "ends", "circle", "auto", NULL};
    const char *text = cli_value(call, "level");
    int k = text ? cli_choice(text, words) : (int)*level;
    if (k < 0)
        return cli_usage(call,
                         "--level %s: must be none, mean, line, polynomial, "
                         "ends, circle or auto",
                         text);
    *level = (ovr_levelling)k;
    return CLI_DONE;
}

/* Reads the spacing. Without a unit it has the unit of x, which must be b. */
static int parse_spacing(const cli_call *call, const char *name,
                         double *spacing, ovr_profile_source *source)
{
    size given;
    int code = parse_size(call, name, false, &given);
    bool in_b = source->unit_x && !strcmp(source->unit_x, "b");
    if (code || !given.given)
        return code;
    if (given.length.unit == OVR_LENGTH_BARE && !in_b)
        return no_unit(call, name);
    *spacing = given.length.value;
    source->spacing_scaled = given.length.unit != OVR_LENGTH_METRES;
    return CLI_DONE;
}

static int parse_metres(const cli_call *call, const char *name, double *value)
{
    size given;
    int code = parse_size(call, name, false, &given);
    if (code || !given.given)
        return code;
    if (given.length.unit != OVR_LENGTH_METRES)
        return no_unit(call, name);
    *value = given.length.value;
    return CLI_DONE;
}

static int profile_take_source(const cli_call *call, ovr_profile_source *source)
{
    int code;
    *source = ovr_profile_source_default();
    source->options = true;
    source->file = call->argument[0];
    source->unit_x = cli_value(call, "unit-x");
    source->unit_z = cli_value(call, "unit-z");
    code = parse_spacing(call, "spacing-across", &source->spacing_across,
                         source);
    if (!code)
        code = parse_spacing(call, "spacing", &source->spacing, source);
    if (!code)
        code = parse_whole(call, "column-x", &source->column_x);
    if (!code)
        code = parse_whole(call, "column-z", &source->column_z);
    if (!code)
        code = parse_whole(call, "line", &source->row); /* former name */
    if (!code)
        code = parse_whole(call, "row", &source->row);
    if (!code)
        code = parse_whole(call, "column", &source->column);
    if (!code)
        code = parse_number(call, "direction", &source->direction);
    if (!code)
        code = parse_metres(call, "y", &source->y);
    return code ? code : parse_metres(call, "band", &source->band);
}

static int parse_sizes(const cli_call *call, const ovr_profile_view *view,
                       const ovr_contact *contact, ovr_conditioning *how)
{
    const double b = contact ? contact->b : 0;
    const double height = contact ? contact->height : 0;
    const struct {
        const char *name;
        bool is_height;
        double *value;
    } sizes[] = {{"from", false, &how->from},
                 {"to", false, &how->to},
                 {"lambda-c", false, &how->lambda_c},
                 {"lambda-s", false, &how->lambda_s},
                 {"max-gap", false, &how->max_gap},
                 {"offset", true, &how->offset}};
    int code = CLI_DONE;
    for (size_t k = 0; !code && k < sizeof sizes / sizeof sizes[0]; k++) {
        bool tall = sizes[k].is_height;
        size given;
        code = parse_size(call, sizes[k].name, tall, &given);
        if (!code)
            code = convert_length(call, given,
                                  tall ? view->scaled_z : view->scaled_x,
                                  tall ? height : b, sizes[k].value);
    }
    return code;
}

/* Reads the conditioning of a profile. Lengths are in the profile's units,
 * converted with the contact if given (may be NULL). */
static int parse_conditioning(const cli_call *call,
                              const ovr_profile_view *view,
                              const ovr_contact *contact, ovr_conditioning *how)
{
    int code;
    *how = ovr_conditioning_default();
    code = parse_level(call, &how->level);
    if (!code)
        code = parse_sizes(call, view, contact, how);
    if (!code)
        code = parse_whole(call, "degree", &how->degree);
    if (!code)
        code = parse_number(call, "outliers", &how->outliers);
    if (!code)
        code = parse_number(call, "scale", &how->scale);
    if (!code)
        code = parse_number(call, "max-missing", &how->max_missing);
    how->invert = cli_flag(call, "invert");
    how->reverse = cli_flag(call, "reverse");
    return code;
}

static int check_output(const cli_call *call, const char *option)
{
    const char *path = cli_value(call, option);
    if (path && !cli_flag(call, "force") && access(path, F_OK) == 0)
        return cli_usage(call, "%s exists; --force overwrites it", path);
    return CLI_DONE;
}

/* Prints that the written file contains one line of the map. */
static void say_line(cli_call *call, const char *copy)
{
    char text[400];
    snprintf(text, sizeof text,
             "%.300s holds one line of the map; a case with shape = areal "
             "reads the map itself",
             copy);
    cli_say(call, OVR_MESSAGE_NOTE, text);
}

static int write_outputs(cli_call *call, const profile_report *r)
{
    const char *copy = cli_value(call, "convert");
    const char *picture = cli_value(call, "plot");
    ovr_error err;
    if (copy && ovr_profile_save(r->profile, copy, &err))
        return cli_fail(&err);
    if (copy && r->map)
        say_line(call, copy);
    if (picture && r->points &&
        ovr_picture_contact(r->view, profile_pressed(r), r->bears, r->points,
                            r->file, picture, &err))
        return cli_fail(&err);
    if (picture && !r->points && r->map &&
        ovr_picture_areal(r->map, r->view, r->file, picture, &err))
        return cli_fail(&err);
    if (picture && !r->points && !r->map &&
        ovr_picture_profile(r->view, r->file, picture, &err))
        return cli_fail(&err);
    return CLI_DONE;
}

/* Computes the parameters before lambda_c from the same profile, which is read
 * again. */
static ovr_status measure_primary(const ovr_profile_source *source,
                                  const ovr_conditioning *how,
                                  ovr_profile_numbers *numbers, ovr_error *err)
{
    ovr_conditioning primary = *how;
    ovr_profile *p = ovr_profile_read(source, NULL, err);
    ovr_status status = OVR_NO_MEMORY;
    primary.lambda_c = NAN;
    if (p)
        status = ovr_profile_condition(p, &primary, err);
    if (p && !status)
        status = ovr_profile_measure(p, numbers, err);
    ovr_profile_free(p);
    return status;
}

static ovr_status measure(const ovr_profile_source *source,
                          const ovr_conditioning *how, profile_report *r,
                          ovr_error *err)
{
    ovr_profile_numbers now = {.kind = 'P'};
    ovr_status status;
    r->missing = ovr_profile_get_view(r->profile)->missing;
    status = ovr_profile_condition(r->profile, how, err);
    if (!status)
        status = ovr_profile_measure(r->profile, &now, err);
    if (!status)
        status = ovr_profile_waves(r->profile, PROFILE_WAVES, r->wave,
                                   &r->waves, err);
    r->view = ovr_profile_get_view(r->profile);
    if (status || now.kind == 'P') {
        r->numbers = now;
        return status;
    }
    r->filtered = now;
    return measure_primary(source, how, &r->numbers, err);
}

/* Resolves the case of --case; NULL without one. */
static int resolve_case(const cli_call *call, ovr_setup **setup)
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

/* Computes the parameters of the map after the form removal and filters given
 * for the profile. */
static ovr_status filter_map(const ovr_conditioning *line, profile_report *r,
                             ovr_error *err)
{
    ovr_conditioning how = ovr_conditioning_default();
    if (isnan(line->lambda_c) && isnan(line->lambda_s) &&
        isnan(line->outliers) && line->level != OVR_LEVEL_POLYNOMIAL)
        return OVR_OK;
    if (line->level <= OVR_LEVEL_POLYNOMIAL)
        how.level = line->level;
    how.degree = line->degree;
    how.outliers = line->outliers;
    how.lambda_c = line->lambda_c;
    how.lambda_s = line->lambda_s;
    how.max_missing = 1;
    if (ovr_areal_condition(r->map, &how, err))
        return OVR_BAD_INPUT;
    return ovr_areal_measure(r->map, &r->areal, err);
}

static int report_profile(cli_call *call, const ovr_profile_source *source,
                          profile_report *r)
{
    ovr_conditioning how;
    ovr_error err;
    int code = parse_conditioning(call, ovr_profile_get_view(r->profile),
                                  r->contact, &how);
    if (code)
        return code;
    if (r->map && filter_map(&how, r, &err))
        return cli_fail(&err);
    if (measure(source, &how, r, &err) ||
        (cli_flag(call, "contact") &&
         ovr_profile_contact(r->profile, PROFILE_POINTS, r->bears, &r->points,
                             &err)))
        return cli_fail(&err);
    code = write_outputs(call, r);
    if (!code && call->json)
        profile_print_json(r);
    else if (!code)
        profile_print_text(r);
    return code;
}

static int report_on(cli_call *call, const ovr_profile_source *source,
                     const ovr_contact *contact)
{
    profile_report r = {.file = call->argument[0], .contact = contact};
    ovr_error err;
    int code;
    r.profile = ovr_profile_read(source, NULL, &err);
    if (!r.profile)
        return cli_fail(&err);
    if (ovr_profile_get_view(r.profile)->rows > 1) {
        r.map = ovr_areal_read(source, NULL, &err);
        if (!r.map || ovr_areal_measure(r.map, &r.areal, &err)) {
            ovr_areal_free(r.map);
            ovr_profile_free(r.profile);
            return cli_fail(&err);
        }
    }
    if (contact && !(contact->b > 0) &&
        !ovr_profile_get_view(r.profile)->scaled_x)
        code = cli_usage(call,
                         "%s has no physical scales; set contact.radius and "
                         "contact.modulus for a profile in metres",
                         cli_value(call, "case"));
    else
        code = report_profile(call, source, &r);
    ovr_areal_free(r.map);
    ovr_profile_free(r.profile);
    return code;
}

static int run(cli_call *call)
{
    ovr_profile_source source;
    ovr_setup *setup = NULL;
    int code = profile_take_source(call, &source);
    if (!code)
        code = check_output(call, "convert");
    if (!code)
        code = check_output(call, "plot");
    if (!code)
        code = resolve_case(call, &setup);
    if (!code)
        code = report_on(call, &source, setup ? setup->contact : NULL);
    ovr_setup_free(setup);
    return code;
}

static const cli_option options[] = {
    {"unit-x", "UNIT", "unit of x if the file does not specify it (um, mm, b)",
     false},
    {"unit-z", "UNIT", "unit of z if the file does not specify it", false},
    {"spacing", "LENGTH", "spacing of the heights of a single column", false},
    {"spacing-across", "LENGTH",
     "distance of the rows of a map if it is not the spacing", false},
    {"column-x", "N", "column of x, from 1", false},
    {"column-z", "N", "column of z, from 1", false},
    {"row", "N",
     "row of an areal file, from 1; default: middle line across the lay",
     false},
    {"column", "N", "column of an areal file, from 1", false},
    {"y", "LENGTH", "row of an areal file nearest to this y", false},
    {"direction", "DEGREES",
     "line through the centre of an areal file at this angle to its x axis",
     false},
    {"band", "LENGTH", "average the heights of an areal file over this width",
     false},
    {"line", "N", "former name of --row", false},
    {"from", "LENGTH", "start of the used range of x", false},
    {"to", "LENGTH", "end of the used range of x", false},
    {"level", "HOW",
     "none, mean, line (default), polynomial, ends, circle, auto", false},
    {"degree", "N", "degree of the polynomial (default: 2)", false},
    {"lambda-c", "LENGTH", "remove longer waves (Gaussian cut-off)", false},
    {"lambda-s", "LENGTH", "remove shorter waves (Gaussian cut-off)", false},
    {"outliers", "K",
     "replace points that deviate by more than K robust "
     "standard deviations",
     false},
    {"max-gap", "LENGTH", "longest gap to fill (default: 5 % of the length)",
     false},
    {"max-missing", "PART",
     "largest missing share of the heights (default: "
     "0.2)",
     false},
    {"scale", "FACTOR", "factor of the heights", false},
    {"offset", "LENGTH", "offset added to the heights", false},
    {"invert", NULL, "change the sign of the heights", false},
    {"reverse", NULL, "reverse x", false},
    {"case", "CASE",
     "predict the deformation of its waves in the contact of "
     "this case",
     false},
    {"contact", NULL,
     "dry contact with a smooth surface: pressure, mean gap, contact length",
     false},
    {"convert", "OUT",
     "write the conditioned profile, of a map the line used: X3P (.x3p), SDF "
     "(.sdf), otherwise text",
     false},
    {"plot", "OUT.png",
     "draw the profile, of an areal file the map and the line used, or with "
     "--contact the contact pressure (png, svg or pdf; needs gnuplot)",
     false},
    {"force", NULL, "replace existing files", false},
    {NULL, NULL, NULL, false}};

const cli_verb cli_profile = {
    .name = "profile",
    .arguments = "FILE",
    .summary = "read, measure, convert and plot a surface profile",
    .help =
        "Reads text (also gzipped), SDF, SMD, X3P, SUR, PRO and NumPy files, "
        "recognized by their content. Prints the assumptions of the reader, "
        "size and lay of an areal file, the P-parameters of the levelled "
        "profile, with --lambda-c its R-parameters (ISO 21920-2), "
        "and its strongest waves. Missing information (units, spacing, "
        "columns) is an error, not guessed.\nA LENGTH has its unit, like '80 "
        "um' or '0.3 b'; numbers without a unit are accepted only for a "
        "profile in b.",
    .options = options,
    .minimum = 1,
    .maximum = 1,
    .run = run};
