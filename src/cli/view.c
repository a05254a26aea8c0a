/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll view OUT.h5 [OTHER.h5] -o PAGE.html: a page that plays the run. */
#include <string.h>

#include "cli/picture_options.h"
#include "cli/view_live.h"

static const cli_option options[] = {
    {"o", "PAGE.html", "where to", false},
    {"title", "TEXT", "title instead of that of the file", false},
    {"stress", "FIELD",
     "also draw stresses below the surface: max_shear, tau_xz, ... (default "
     "with [stress]: max_shear)",
     false},
    {"live", NULL,
     "include the program: inputs can be changed and solved in the page",
     false},
    {"force", NULL, "replace what exists", false},
    {NULL, NULL, NULL, false},
};

/* False for the name of a picture, film or table. */
static bool is_page(const char *path)
{
    static const char *const others[] = {".png", ".svg", ".pdf",  ".gif",
                                         ".mp4", ".csv", ".json", ".txt"};
    const char *dot = strrchr(path, '.');
    for (size_t k = 0; dot && k < sizeof others / sizeof *others; k++)
        if (!strcmp(dot, others[k]))
            return false;
    return true;
}

static int run(cli_call *call)
{
    ovr_view_options o = {0};
    ovr_result *results[CLI_RESULTS];
    const char *names[CLI_RESULTS];
    ovr_error err = {0};
    int code;
    o.path = cli_value(call, "o");
    o.force = cli_flag(call, "force");
    o.stress = cli_value(call, "stress");
    o.title = cli_value(call, "title");
    o.names = cli_result_names(call, names);
    if (!o.path)
        return cli_usage(call, "no output: set -o PAGE.html");
    if (!is_page(o.path))
        return cli_usage(call, "-o %s: must be an HTML page, NAME.html",
                         o.path);
    code = cli_open_results(call, results);
    if (code)
        return code;
    if (ovr_view(results, (size_t)call->arguments, &o, NULL, &err) != OVR_OK)
        code = cli_fail(&err);
    else if (cli_flag(call, "live"))
        code = cli_make_live(call, o.path,
                             ovr_result_about(results[0])->case_text);
    if (code == CLI_DONE && call->verbosity >= 0)
        printf("%s\n", o.path);
    cli_close_results(call, results);
    return code;
}

const cli_verb cli_view = {
    .name = "view",
    .arguments = "OUT.h5 [OTHER.h5] -o PAGE.html",
    .summary = "make a web page that plays the run",
    .help =
        "The page holds everything it needs: no network, nothing to\n"
        "install. Two files are played side by side. With --live it is the\n"
        "page of the program (make web) with this result and its case.",
    .options = options,
    .minimum = 1,
    .maximum = 2,
    .run = run,
};
