/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll frames OUT.h5 -o DIR: a picture of each snapshot, a
 * movie. */
#include <math.h>
#include <string.h>

#include "cli/picture_options.h"
#include "cli/signals.h"
#include "cli/watch.h"

static const cli_option options[] = {
    {"o", "DIR", "folder for the frames", false},
    {"movie", "MOVIE", "NAME.mp4, NAME.webm, NAME.gif or NAME.webp (ffmpeg)",
     false},
    {"rate", "N", "frames per second of the movie (25)", false},
    {"every", "N", "draw every Nth snapshot", false},
    {"form", "FORM", "png (default), svg or pdf", false},
    {"jobs", "N", "number of gnuplot processes (default: one per core)", false},
    {"stress", "FIELD",
     "also draw stresses below the surface: max_shear, "
     "tau_xz, ...",
     false},
    {"depth", "SCALE", "depth axis of the stresses: linear (default) or log",
     false},
    {"script", NULL, "also write the gnuplot script and data of each frame",
     false},
    CLI_RANGE_OPTIONS,
    {NULL, NULL, NULL, false},
};

typedef struct watcher {
    cli_progress progress;
} watcher;

static bool watch(void *data, size_t done, size_t count)
{
    watcher *w = data;
    char what[64];
    snprintf(what, sizeof what, "frame %zu of %zu", done, count);
    cli_progress_show(&w->progress, (double)done / (double)count, what);
    return cli_signal() == 0;
}

static int parse_count(const cli_call *call, const char *name, double maximum,
                       double *value)
{
    const char *text = cli_value(call, name);
    if (text && (!ovr_bare_number(text, value) || *value < 1 ||
                 *value > maximum || *value != floor(*value)))
        return cli_usage(call, "--%s '%s': must be a whole number from 1 to %g",
                         name, text, maximum);
    return CLI_DONE;
}

static int parse_options(const cli_call *call, ovr_frames_options *o,
                         ovr_picture_options *look)
{
    double every = 0, jobs = 0, rate = 0;
    int code = cli_picture_options(call, look);
    o->folder = cli_value(call, "o");
    o->movie = cli_value(call, "movie");
    o->form = cli_value(call, "form");
    o->scripts = cli_flag(call, "script");
    look->field = cli_value(call, "stress");
    if (look->field)
        look->kind = OVR_PICTURE_STRESS;
    look->log_depth = cli_value(call, "depth") &&
                      strcmp(cli_value(call, "depth"), "log") == 0;
    if (!code && !o->folder && !o->movie)
        code = cli_usage(call, "no output: set -o DIR or --movie NAME.mp4");
    if (!code && o->scripts && !o->folder)
        code = cli_usage(call, "--script needs a folder; set -o DIR");
    if (!code)
        code = parse_count(call, "every", 1e9, &every);
    if (!code)
        code = parse_count(call, "jobs", 32, &jobs);
    if (!code)
        code = parse_count(call, "rate", 240, &rate);
    o->every = (size_t)every;
    o->workers = (int)jobs;
    o->rate = rate;
    return code;
}

static void report(const cli_call *call, const ovr_frames_options *o,
                   const ovr_frames_made *made)
{
    if (call->verbosity < 0)
        return;
    if (o->folder)
        printf("%s: %zu frames drawn, %zu kept\n", o->folder, made->drawn,
               made->kept);
    if (o->movie)
        printf("%s\n", o->movie);
}

static int draw(const cli_call *call, const ovr_frames_options *given,
                ovr_picture_options *look)
{
    ovr_frames_options o = *given;
    ovr_result *results[CLI_RESULTS];
    ovr_error err = {0};
    ovr_frames_made made;
    watcher w;
    int code = cli_open_results(call, results);
    if (code)
        return code;
    code = cli_picture_ranges(call, results[0], look);
    if (code) {
        cli_close_results(call, results);
        return code;
    }
    cli_choose_areal(call, results[0], look);
    cli_say_units(call, results, look->units);
    cli_catch_signals();
    w.progress = cli_progress_begin(call->verbosity, 0);
    o.progress = watch;
    o.data = &w;
    ovr_frames(results, (size_t)call->arguments, &o, NULL, &made, &err);
    cli_progress_end(&w.progress);
    if (err.status != OVR_OK)
        code = cli_fail(&err);
    else
        report(call, &o, &made);
    if (cli_signal())
        code = CLI_SIGNAL + cli_signal();
    cli_close_results(call, results);
    return code;
}

static int run(cli_call *call)
{
    ovr_frames_options o = {0};
    ovr_picture_options look = ovr_picture_options_default();
    const char *names[CLI_RESULTS];
    int code = parse_options(call, &o, &look);
    look.names = cli_result_names(call, names);
    o.look = &look;
    return code ? code : draw(call, &o, &look);
}

const cli_verb cli_frames = {
    .name = "frames",
    .no_json = true,
    .arguments = "OUT.h5... -o DIR",
    .summary = "draw each snapshot, and make a movie",
    .help = "Pressure, film thickness and roughness against x, with the same "
            "axes in\nall frames: DIR/frame_0000.png and so on, numbered like "
            "the snapshots.\nA second call draws missing frames only. With "
            "--movie alone no frames\nare kept. Several results are drawn in "
            "the same axes.",
    .options = options,
    .minimum = 1,
    .maximum = CLI_RESULTS,
    .run = run,
};
