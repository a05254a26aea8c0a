/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll plot OUT.h5 -o PICTURE: one picture. */
#include <string.h>

#include "cli/picture_options.h"

enum { TIMES = 8 };

static const cli_option options[] = {
    {"o", "PICTURE", "where to: NAME.png, NAME.svg or NAME.pdf", false},
    {"kind", "KIND", "snapshot (default), history, map or trace", false},
    {"at", "T", "snapshot: an instant, like 0.2ms or, in b/um, 1.5", true},
    {"overlay", NULL, "snapshot: all instants in one panel", false},
    {"field", "FIELD", "map: film_thickness (default) or another of the file",
     false},
    {"script", "FILE.gp", "also write the gnuplot script, and its data beside",
     false},
    CLI_RANGE_OPTIONS,
    {NULL, NULL, NULL, false},
};

static int take_kind(const cli_call *call, ovr_picture_options *o)
{
    static const char *const kinds[] = {"snapshot", "history", "map", "trace"};
    const char *text = cli_value(call, "kind");
    if (!text)
        return CLI_DONE;
    for (int k = 0; k < 4; k++)
        if (strcmp(text, kinds[k]) == 0) {
            o->kind = (ovr_picture_kind)k;
            return CLI_DONE;
        }
    return cli_usage(
        call, "--kind '%s': there are snapshot, history, map and trace", text);
}

static int take_instants(const cli_call *call, const ovr_result *result,
                         ovr_picture_options *o, double *times)
{
    const char *text;
    o->times = times;
    for (int k = 0; (text = cli_value_at(call, "at", k)); k++) {
        ovr_error err = {0};
        if (k >= TIMES)
            return cli_usage(call, "at most %d instants fit into a picture",
                             TIMES);
        if (ovr_result_number(result, OVR_KIND_TIME, text,
                              &times[o->time_count++], &err))
            return cli_usage(call, "--at %s", err.message);
    }
    return CLI_DONE;
}

static int draw(const cli_call *call, ovr_result *const *results,
                ovr_picture_options *o)
{
    double times[TIMES];
    ovr_error err = {0};
    int code = cli_picture_ranges(call, results[0], o);
    if (!code)
        code = take_instants(call, results[0], o, times);
    if (code)
        return code;
    cli_say_units(call, results, o->units);
    if (ovr_picture(results, (size_t)call->arguments, o, NULL, &err) != OVR_OK)
        return cli_fail(&err);
    if (call->verbosity >= 0)
        printf("%s\n", o->path);
    return CLI_DONE;
}

static int run(cli_call *call)
{
    ovr_picture_options o = ovr_picture_options_default();
    ovr_result *results[CLI_RESULTS];
    const char *names[CLI_RESULTS];
    int code;
    o.path = cli_value(call, "o");
    if (!o.path)
        return cli_usage(call, "where to? -o PICTURE.png");
    o.overlay = cli_flag(call, "overlay");
    o.field = cli_value(call, "field");
    o.script = cli_value(call, "script");
    o.names = cli_result_names(call, names);
    code = cli_picture_options(call, &o);
    if (!code)
        code = take_kind(call, &o);
    if (!code)
        code = cli_open_results(call, results);
    if (code)
        return code;
    code = draw(call, results, &o);
    cli_close_results(call, results);
    return code;
}

const cli_verb cli_plot = {
    .name = "plot",
    .arguments = "OUT.h5... -o PICTURE",
    .summary = "one picture: snapshot, history, space-time map, trace",
    .help =
        "  snapshot  pressure, film and roughness at a few instants\n"
        "  history   minimum and central film and maximum pressure in time\n"
        "  map       position against time, the colour is film or pressure\n"
        "  trace     film at x = 0, and the roughness that passes there\n"
        "\n"
        "Several result files are drawn over each other (but for a map).",
    .options = options,
    .least = 1,
    .most = CLI_RESULTS,
    .run = run,
};
