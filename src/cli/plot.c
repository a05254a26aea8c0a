/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll plot OUT.h5 -o PICTURE: one picture. */
#include <stdlib.h>
#include <string.h>

#include "cli/picture_options.h"

enum { TIMES = 8 };

static const cli_option options[] = {
    {"o", "PICTURE", "output file: NAME.png, NAME.svg or NAME.pdf", false},
    {"kind", "KIND",
     "snapshot (default), areal (default of a strip), history, map, trace, "
     "stress, risk, depth, plastic, passes or element; of a study stribeck",
     false},
    {"at", "T", "snapshot: time, such as 0.2ms or, in b/u_m, 1.5", true},
    {"overlay", NULL, "snapshot: all times in one panel", false},
    {"field", "FIELD",
     "field of a map (default: film_thickness) or stress (default: max_shear)",
     false},
    {"surface", "N", "stress, risk, depth: below surface 1 (default) or 2",
     false},
    {"depth", "SCALE", "stress: linear (default) or log", false},
    {"script", "FILE.gp", "also write the gnuplot script and its data", false},
    {"quantity", "NAME",
     "quantity of a study to draw (default: minimum film thickness)", false},
    {"against", "KEY", "study: key on the x axis (default: its first key)",
     false},
    {"lines", "KEY",
     "study: key with one line per value, or none (default: "
     "the next key)",
     false},
    {"panels", "KEY",
     "study: key with one panel per value, or none (default: the remaining "
     "key)",
     false},
    {"log", "AXES",
     "of a study: x, y or xy logarithmic, or none (default: x if its values "
     "form a geometric series over a decade or more)",
     false},
    CLI_RANGE_OPTIONS,
    {NULL, NULL, NULL, false},
};

static int parse_kind(const cli_call *call, ovr_picture_options *o)
{
    static const char *const kinds[] = {
        "snapshot", "history", "map",     "trace", "stress", "risk",
        "depth",    "element", "plastic", "areal", NULL};
    const char *text = cli_value(call, "kind");
    int k = text ? cli_choice(text, kinds) : (int)o->kind;
    if (k >= 0) {
        o->kind = (ovr_picture_kind)k;
        return CLI_DONE;
    }
    if (strcmp(text, "passes") == 0)
        return cli_usage(call,
                         "%s: contains one run; --kind passes needs the file "
                         "of several passes, OUT.h5 for OUT-1.h5, ...",
                         call->argument[0]);
    return cli_usage(
        call,
        "--kind '%s': must be snapshot, areal, history, map, trace, stress, "
        "risk, depth, element, plastic or passes",
        text);
}

static int parse_depth(const cli_call *call, ovr_picture_options *o)
{
    const char *surface = cli_value(call, "surface");
    const char *depth = cli_value(call, "depth");
    if (surface && strcmp(surface, "1") != 0 && strcmp(surface, "2") != 0)
        return cli_usage(call, "--surface '%s': must be 1 or 2", surface);
    if (depth && strcmp(depth, "log") != 0 && strcmp(depth, "linear") != 0)
        return cli_usage(call, "--depth '%s': must be linear or log", depth);
    o->surface = surface && *surface == '2' ? 2 : 1;
    o->log_depth = depth && *depth == 'l' && depth[1] == 'o';
    return CLI_DONE;
}

/* Rejects a time outside the snapshots by more than half their spacing, because
 * the drawn time would differ. */
static ovr_status check_instant(ovr_result *result, const char *text, double T,
                                ovr_error *err)
{
    size_t count = ovr_result_get_info(result)->snapshots;
    double *t = calloc(count + 1, sizeof *t);
    ovr_status status;
    if (!t)
        return ovr_fail(err, OVR_NO_MEMORY, "out of memory: %zu times", count);
    status = ovr_result_times(result, OVR_HERTZIAN, t, err);
    double before = count > 1 ? t[1] - t[0] : 0;
    double after = count > 1 ? t[count - 1] - t[count - 2] : 0;
    if (!status && count &&
        (T < t[0] - before / 2 - 1e-9 || T > t[count - 1] + after / 2 + 1e-9))
        status = ovr_fail(err, OVR_BAD_INPUT,
                          "%s: snapshots exist only from %.6g to %.6g b/u_m",
                          text, t[0], t[count - 1]);
    free(t);
    return status;
}

static int parse_instants(const cli_call *call, ovr_result *result,
                          ovr_picture_options *o, double *times)
{
    const char *text;
    o->times = times;
    for (int k = 0; (text = cli_value_at(call, "at", k)); k++) {
        ovr_error err = {0};
        if (k >= TIMES)
            return cli_usage(call, "a picture shows at most %d times", TIMES);
        if (ovr_result_number(result, OVR_KIND_TIME, text, &times[k], &err) ||
            check_instant(result, text, times[k], &err))
            return cli_usage(call, "--at %s", err.message);
        o->time_count++;
    }
    return CLI_DONE;
}

static int draw(const cli_call *call, ovr_result *const *results,
                const ovr_picture_options *given)
{
    double times[TIMES];
    ovr_picture_options own = *given, *o = &own;
    ovr_error err = {0};
    int code = cli_picture_ranges(call, results[0], o);
    if (!code)
        code = parse_instants(call, results[0], o, times);
    if (code)
        return code;
    cli_choose_areal(call, results[0], o);
    cli_say_units(call, results, o->units);
    if (ovr_picture(results, (size_t)call->arguments, o, NULL, &err) != OVR_OK)
        return cli_fail(&err);
    if (call->verbosity >= 0)
        printf("%s\n", o->path);
    return CLI_DONE;
}

/* ---------------------------------------------------------------- studies */

static bool ends_with(const char *text, const char *ending)
{
    size_t n = strlen(text), m = strlen(ending);
    return n >= m && strcmp(text + n - m, ending) == 0;
}

/* True for a netCDF table; a netCDF file may also be a result. */
static bool is_netcdf_table(const char *path)
{
    ovr_table *table = ovr_table_read(path, NULL);
    ovr_table_free(table);
    return table != NULL;
}

static bool is_study(const cli_call *call)
{
    return ends_with(call->argument[0], ".ini") ||
           ends_with(call->argument[0], ".csv") ||
           is_netcdf_table(call->argument[0]);
}

/* True for the default figure of a pass table: no quantity is requested. */
static bool of_passes(const cli_call *call, const ovr_table *table)
{
    const ovr_table_column *first = ovr_table_at(table, 0);
    return first && strcmp(first->name, "pass") == 0 &&
           !cli_value(call, "quantity");
}

static ovr_table *open_table(const char *path, ovr_error *err)
{
    ovr_study *study;
    ovr_table *table;
    if (!ends_with(path, ".ini"))
        return ovr_table_read(path, err);
    study = ovr_study_read(path, NULL, err);
    table = study ? ovr_study_table(study, err) : NULL;
    ovr_study_free(study);
    return table;
}

static int parse_figure(const cli_call *call, ovr_figure_options *f)
{
    ovr_picture_options shared = ovr_picture_options_default();
    const char *log = cli_value(call, "log");
    int code = cli_picture_options(call, &shared);
    *f = (ovr_figure_options){0};
    f->path = cli_value(call, "o");
    f->force = cli_flag(call, "force");
    f->script = cli_value(call, "script");
    f->title = cli_value(call, "title");
    f->template_path = shared.template_path;
    f->width = shared.width;
    f->height = shared.height;
    f->y = cli_value(call, "quantity");
    f->x = cli_value(call, "against");
    f->by = cli_value(call, "lines");
    f->panels = cli_value(call, "panels");
    if (f->by && !strcmp(f->by, "none"))
        f->by = "";
    if (f->panels && !strcmp(f->panels, "none"))
        f->panels = "";
    bool none = log && !strcmp(log, "none");
    if (log && !none && strspn(log, "xy") != strlen(log))
        return cli_usage(call, "--log %s: must be x, y, xy or none", log);
    f->linear = log != NULL;
    f->log_x = log && strchr(log, 'x');
    f->log_y = log && strchr(log, 'y');
    return code;
}

/* Returns "study" for "studies/study.ini". */
static const char *name_of(const char *path, char *buffer, size_t size)
{
    const char *slash = strrchr(path, '/');
    snprintf(buffer, size, "%s", slash ? slash + 1 : path);
    char *dot = strrchr(buffer, '.');
    if (dot && dot > buffer)
        *dot = '\0';
    return buffer;
}

/* Rejects options of studies, which have no effect on a result file. */
static int refuse_study_options(const cli_call *call)
{
    static const char *const names[] = {"quantity", "against", "lines", "log"};
    for (int k = 0; k < 4; k++)
        if (cli_value(call, names[k]))
            return cli_usage(call,
                             "--%s draws studies, but %s is the result of "
                             "one run; use STUDY.ini or its table",
                             names[k], call->argument[0]);
    return CLI_DONE;
}

/* Draws distributions from the study file, because its table has neither limits
 * nor distributions. */
static int draw_distribution(const cli_call *call, const ovr_figure_options *f)
{
    ovr_error err = {0};
    int code = CLI_DONE;
    if (!ends_with(call->argument[0], ".ini"))
        return cli_usage(call,
                         "--kind distribution draws a study; use STUDY.ini");
    ovr_study *study = ovr_study_read(call->argument[0], NULL, &err);
    if (!study || ovr_figure_distribution(study, f, NULL, &err))
        code = cli_fail(&err);
    else if (call->verbosity >= 0)
        printf("%s\n", f->path);
    ovr_study_free(study);
    return code;
}

static int draw_study(const cli_call *call)
{
    const char *kind = cli_value(call, "kind");
    ovr_figure_options f;
    ovr_error err = {0};
    char name[200];
    ovr_table *table;
    int code = parse_figure(call, &f);
    if (!code && call->arguments > 1)
        code = cli_usage(call, "a picture shows one study only");
    if (code)
        return code;
    if (!f.title)
        f.title = name_of(call->argument[0], name, sizeof name);
    if (kind && !strcmp(kind, "distribution"))
        return draw_distribution(call, &f);
    table = open_table(call->argument[0], &err);
    bool stribeck = kind && !strcmp(kind, "stribeck");
    if (!table || (stribeck ? ovr_figure_stribeck
                   : of_passes(call, table)
                       ? ovr_figure_passes
                       : ovr_figure)(table, &f, NULL, &err) != OVR_OK)
        code = cli_fail(&err);
    else if (call->verbosity >= 0)
        printf("%s\n", f.path);
    ovr_table_free(table);
    return code;
}

/* ---------------------------------------------------------------- elements */

static bool of_element(const cli_call *call)
{
    const char *kind = cli_value(call, "kind");
    return kind && strcmp(kind, "element") == 0 &&
           ends_with(call->argument[0], ".ini");
}

/* Draws the machine element of a case before a run. */
static int draw_element(const cli_call *call, ovr_picture_options *o)
{
    ovr_error err = {0};
    int code = cli_picture_options(call, o);
    if (!code && call->arguments > 1)
        code = cli_usage(call, "a picture shows one case only");
    if (code)
        return code;
    ovr_case *c = ovr_case_read(call->argument[0], NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    if (!setup || ovr_picture_element(setup, o, NULL, &err))
        code = cli_fail(&err);
    else if (call->verbosity >= 0)
        printf("%s\n", o->path);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return code;
}

static int run(cli_call *call)
{
    ovr_picture_options o = ovr_picture_options_default();
    ovr_result *results[CLI_RESULTS];
    const char *names[CLI_RESULTS];
    int code;
    o.path = cli_value(call, "o");
    if (!o.path)
        return cli_usage(call, "no output: set -o PICTURE.png");
    o.script = cli_value(call, "script");
    if (of_element(call))
        return draw_element(call, &o);
    if (is_study(call))
        return draw_study(call);
    code = refuse_study_options(call);
    if (code)
        return code;
    o.overlay = cli_flag(call, "overlay");
    o.field = cli_value(call, "field");
    if (parse_depth(call, &o))
        return CLI_USAGE;
    o.names = cli_result_names(call, names);
    code = cli_picture_options(call, &o);
    if (!code)
        code = parse_kind(call, &o);
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
    .no_json = true,
    .arguments = "OUT.h5... | STUDY.ini | TABLE.csv | TABLE.nc -o PICTURE",
    .summary = "draw one picture: snapshot, history, space-time map, trace, "
               "study",
    .help =
        "  snapshot  pressure, film thickness and surface height at some "
        "times\n"
        "  areal     maps of pressure and film thickness of a strip, with "
        "cuts\n"
        "            along x (--across Y) and across rolling (--along X)\n"
        "  history   minimum and central film thickness and maximum pressure "
        "against\n"
        "            time\n"
        "  map       film thickness or pressure over position and time\n"
        "  trace     film thickness and surface height at x = 0 against time\n"
        "  stress    pressure, film thickness and stresses below, at one time\n"
        "  risk      fatigue risk over position and depth (with [stress])\n"
        "  depth     fatigue risk against depth, with the equivalent length\n"
        "  plastic   profile before and after, plastic strain, residual "
        "stress\n"
        "  element   gear pair, cam or bearing to scale, with its time "
        "histories;\n"
        "            also for a CASE.ini that has not run\n"
        "  passes    film thickness and inlet meniscus against pass number\n"
        "\n"
        "Several result files are drawn in the same axes (except maps).\n"
        "A study or its table is drawn as a quantity against a key or the "
        "name\n"
        "of a [zip], with a line per value of a second key and a panel per "
        "value\n"
        "of the others.  Over seeds the mean is drawn in a band; against a "
        "seed,\n"
        "a histogram with quantiles.  With --kind distribution, a study with\n"
        "[random] gives histogram, distribution and the effect of each input.",
    .options = options,
    .minimum = 1,
    .maximum = CLI_RESULTS,
    .run = run,
};
