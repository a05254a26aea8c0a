/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/profile_args.h"

#include <math.h>
#include <string.h>

/* A bare number only a profile in b may have. */
typedef struct size {
    const char *name; /* of the option */
    ovr_length length;
    bool given;
} size;

static int take_size(const cli_call *call, const char *name, bool is_height,
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

static int take_number(const cli_call *call, const char *name, double *value)
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

static int take_whole(const cli_call *call, const char *name, int *value)
{
    double number = *value;
    int code = take_number(call, name, &number);
    if (code)
        return code;
    if (!(number >= 0 && number <= 1e9) || number != floor(number))
        return cli_usage(call, "--%s %s: must be a whole number", name,
                         cli_value(call, name));
    *value = (int)number;
    return CLI_DONE;
}

static int take_level(const cli_call *call, ovr_levelling *level)
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

/* Its unit is that of x when bare: only b may be meant so. */
static int take_spacing(const cli_call *call, const char *name, double *spacing,
                        ovr_profile_source *source)
{
    size given;
    int code = take_size(call, name, false, &given);
    bool in_b = source->unit_x && !strcmp(source->unit_x, "b");
    if (code || !given.given)
        return code;
    if (given.length.unit == OVR_LENGTH_BARE && !in_b)
        return no_unit(call, name);
    *spacing = given.length.value;
    source->spacing_scaled = given.length.unit != OVR_LENGTH_METRES;
    return CLI_DONE;
}

static int take_metres(const cli_call *call, const char *name, double *value)
{
    size given;
    int code = take_size(call, name, false, &given);
    if (code || !given.given)
        return code;
    if (given.length.unit != OVR_LENGTH_METRES)
        return no_unit(call, name);
    *value = given.length.value;
    return CLI_DONE;
}

int profile_take_source(const cli_call *call, ovr_profile_source *source)
{
    int code;
    *source = ovr_profile_source_default();
    source->options = true;
    source->file = call->argument[0];
    source->unit_x = cli_value(call, "unit-x");
    source->unit_z = cli_value(call, "unit-z");
    code = take_spacing(call, "spacing-across", &source->spacing_across,
                        source);
    if (!code)
        code = take_spacing(call, "spacing", &source->spacing, source);
    if (!code)
        code = take_whole(call, "column-x", &source->column_x);
    if (!code)
        code = take_whole(call, "column-z", &source->column_z);
    if (!code)
        code = take_whole(call, "line", &source->row); /* its former name */
    if (!code)
        code = take_whole(call, "row", &source->row);
    if (!code)
        code = take_whole(call, "column", &source->column);
    if (!code)
        code = take_number(call, "direction", &source->direction);
    if (!code)
        code = take_metres(call, "y", &source->y);
    return code ? code : take_metres(call, "band", &source->band);
}

static int take_sizes(const cli_call *call, const ovr_profile_view *view,
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
        code = take_size(call, sizes[k].name, tall, &given);
        if (!code)
            code = convert_length(call, given,
                                  tall ? view->scaled_z : view->scaled_x,
                                  tall ? height : b, sizes[k].value);
    }
    return code;
}

int profile_take_conditioning(const cli_call *call,
                              const ovr_profile_view *view,
                              const ovr_contact *contact, ovr_conditioning *how)
{
    int code;
    *how = ovr_conditioning_default();
    code = take_level(call, &how->level);
    if (!code)
        code = take_sizes(call, view, contact, how);
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
