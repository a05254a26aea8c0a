/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/picture_options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool cli_number(const char *text, double *value)
{
    char *end;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value);
}

static int take_number(const cli_call *call, const char *name, double *value)
{
    const char *text = cli_value(call, name);
    if (text && (!cli_number(text, value) || *value <= 0))
        return cli_usage(call, "--%s '%s': a positive number is needed", name,
                         text);
    return CLI_DONE;
}

/* FROM:TO, either of which may be left out. */
static int take_range(const cli_call *call, const char *name, double *from,
                      double *to)
{
    const char *text = cli_value(call, name);
    char low[64];
    const char *colon = text ? strchr(text, ':') : NULL;
    size_t length = colon ? (size_t)(colon - text) : 0;
    if (!text)
        return CLI_DONE;
    if (colon && length < sizeof low) {
        memcpy(low, text, length);
        low[length] = '\0';
        if ((length == 0 || cli_number(low, from)) &&
            (colon[1] == '\0' || cli_number(colon + 1, to)) && !(*from >= *to))
            return CLI_DONE;
    }
    return cli_usage(call, "--%s '%s': a range such as -1.5:1 is needed", name,
                     text);
}

/* WIDTHxHEIGHT */
static int take_size(const cli_call *call, int *width, int *height)
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
    int code = CLI_DONE;
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
    code = take_range(call, "x", &o->x_from, &o->x_to);
    if (!code)
        code = take_range(call, "time", &o->T_from, &o->T_to);
    if (!code)
        code = take_number(call, "p-max", &o->P_to);
    if (!code)
        code = take_number(call, "h-max", &o->H_to);
    if (!code)
        code = take_size(call, &o->width, &o->height);
    return code;
}

int cli_open_results(const cli_call *call, ovr_result **results)
{
    ovr_error err = {0};
    for (int k = 0; k < call->arguments; k++) {
        results[k] = ovr_result_open(call->argument[k], NULL, &err);
        if (!results[k]) {
            int code = cli_fail(&err);
            while (k--)
                ovr_result_close(results[k]);
            return code;
        }
    }
    return CLI_DONE;
}

/* One without scales among others: all axes are Hertzian, which is said. */
void cli_say_units(const cli_call *call, ovr_result *const *results,
                   ovr_units units)
{
    const char *without = NULL;
    bool any = false;
    for (int k = 0; k < call->arguments; k++) {
        const ovr_result_info *info = ovr_result_about(results[k]);
        any |= info->physical;
        if (!without && !info->physical && !(info->ph > 0 && info->b > 0))
            without = call->argument[k];
    }
    if (any && without && units == OVR_AS_STORED && call->verbosity >= 0)
        fprintf(stderr,
                "%s has no physical scales: all are drawn in Hertzian units, "
                "each its own\n",
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
