/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/picture_options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int parse_number(const cli_call *call, const ovr_result *result,
                        ovr_unit_kind kind, const char *name, double *value)
{
    const char *text = cli_value(call, name);
    ovr_error err = {0};
    if (!text)
        return CLI_DONE;
    if (ovr_result_number(result, kind, text, value, &err))
        return cli_usage(call, "--%s %s", name, err.message);
    if (*value > 0)
        return CLI_DONE;
    return cli_usage(call, "--%s '%s': must be a positive number", name, text);
}

/* A requested range of numbers that may have units. */
typedef struct asked {
    const cli_call *call;
    const ovr_result *result;
    ovr_unit_kind kind;
    const char *name; /* name of the option */
} asked;

/* Parses one end of the range, which may be omitted. */
static int parse_end(const asked *of, const char *text, size_t size,
                     double *value)
{
    char end[64];
    ovr_error err = {0};
    if (size == 0)
        return CLI_DONE;
    snprintf(end, sizeof end, "%.*s", (int)size, text);
    if (ovr_result_number(of->result, of->kind, end, value, &err))
        return cli_usage(of->call, "--%s %s: %s", of->name,
                         cli_value(of->call, of->name), err.message);
    return CLI_DONE;
}

/* Parses FROM:TO, each with or without unit. */
static int parse_range(const asked *of, double *from, double *to)
{
    const char *text = cli_value(of->call, of->name);
    const char *colon = text ? strchr(text, ':') : NULL;
    int code = CLI_DONE;
    if (!text)
        return CLI_DONE;
    if (colon && strlen(text) <= 60) {
        code = parse_end(of, text, (size_t)(colon - text), from);
        if (!code)
            code = parse_end(of, colon + 1, strlen(colon + 1), to);
        if (code || !(*from >= *to))
            return code;
    }
    return cli_usage(of->call, "--%s '%s': must be a range, such as -1.5:1",
                     of->name, text);
}

/* Parses WIDTHxHEIGHT. */
static int parse_size(const cli_call *call, int *width, int *height)
{
    const char *text = cli_value(call, "size");
    char *end;
    long w, h;
    if (!text)
        return CLI_DONE;
    w = strtol(text, &end, 10);
    h = *end == 'x' ? strtol(end + 1, &end, 10) : 0;
    if (*end || w < 200 || w > 8000 || h < 150 || h > 8000)
        return cli_usage(call,
                         "--size '%s': WIDTHxHEIGHT from 200x150 to 8000x8000 "
                         "is needed",
                         text);
    *width = (int)w;
    *height = (int)h;
    return CLI_DONE;
}

int cli_picture_options(const cli_call *call, ovr_picture_options *o)
{
    if (cli_flag(call, "hertzian") && cli_flag(call, "si"))
        return cli_usage(call, "--hertzian and --si exclude each other");
    if (cli_flag(call, "hertzian"))
        o->units = OVR_HERTZIAN;
    if (cli_flag(call, "si"))
        o->units = OVR_SI;
    o->force = cli_flag(call, "force");
    o->no_hertz = cli_flag(call, "no-hertz");
    o->no_roughness = cli_flag(call, "no-roughness");
    o->title = cli_value(call, "title");
    o->template_path = cli_value(call, "template");
    return parse_size(call, &o->width, &o->height);
}

int cli_picture_ranges(const cli_call *call, const ovr_result *result,
                       ovr_picture_options *o)
{
    const asked x = {call, result, OVR_KIND_LENGTH, "x"};
    const asked T = {call, result, OVR_KIND_TIME, "time"};
    int code = parse_range(&x, &o->x_from, &o->x_to);
    if (!code)
        code = parse_range(&T, &o->T_from, &o->T_to);
    if (!code)
        code = parse_number(call, result, OVR_KIND_PRESSURE, "p-max", &o->P_to);
    if (!code)
        code = parse_number(call, result, OVR_KIND_HEIGHT, "h-max", &o->H_to);
    const char *along = cli_value(call, "along");
    ovr_error err = {0};
    if (!code && along &&
        ovr_result_number(result, OVR_KIND_LENGTH, along, &o->along, &err))
        code = cli_usage(call, "--along %s", err.message);
    return code;
}

int cli_choose_across(const cli_call *call, ovr_result *result)
{
    const char *text = cli_value(call, "across");
    ovr_error err = {0};
    double Y;
    if (!text)
        return CLI_DONE;
    if (ovr_result_number(result, OVR_KIND_LENGTH, text, &Y, &err))
        return cli_usage(call, "--across %s", err.message);
    return ovr_result_across(result, &Y, &err) ? cli_fail(&err) : CLI_DONE;
}

void cli_choose_areal(const cli_call *call, const ovr_result *result,
                      ovr_picture_options *o)
{
    if (ovr_result_get_info(result)->lines > 1 && call->arguments == 1 &&
        o->kind == OVR_PICTURE_SNAPSHOT && !cli_value(call, "kind") &&
        !cli_value(call, "across"))
        o->kind = OVR_PICTURE_AREAL;
}

static int open_result(const cli_call *call, const char *path,
                       ovr_result **result)
{
    ovr_error err = {0};
    *result = ovr_result_open(path, NULL, &err);
    if (!*result)
        return cli_fail(&err);
    int code = cli_choose_across(call, *result);
    if (code)
        ovr_result_close(*result);
    return code;
}

int cli_open_results(const cli_call *call, ovr_result **results)
{
    for (int k = 0; k < call->arguments; k++) {
        int code = open_result(call, call->argument[k], &results[k]);
        if (code) {
            while (k--)
                ovr_result_close(results[k]);
            return code;
        }
    }
    return CLI_DONE;
}

/* Prints a note if a result without scales makes all axes Hertzian. */
void cli_say_units(const cli_call *call, ovr_result *const *results,
                   ovr_units units)
{
    const char *without = NULL;
    bool any = false;
    for (int k = 0; k < call->arguments; k++) {
        const ovr_result_info *info = ovr_result_get_info(results[k]);
        any |= info->physical;
        if (!without && !info->physical && !(info->ph > 0 && info->b > 0))
            without = call->argument[k];
    }
    if (any && without && units == OVR_AS_STORED && call->verbosity >= 0)
        fprintf(stderr,
                "%s has no physical scales: each result is drawn in its own "
                "Hertzian units\n",
                without);
}

void cli_close_results(const cli_call *call, ovr_result **results)
{
    for (int k = 0; k < call->arguments; k++)
        ovr_result_close(results[k]);
}

const char *const *cli_result_names(const cli_call *call, const char **names)
{
    for (int k = 0; k < call->arguments; k++) {
        const char *slash = strrchr(call->argument[k], '/');
        names[k] = slash ? slash + 1 : call->argument[k];
    }
    return call->arguments > 1 ? names : NULL;
}
