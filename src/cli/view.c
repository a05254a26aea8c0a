/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll view OUT.h5 [OTHER.h5] -o PAGE.html: a page that plays
 * the run. */
#define _GNU_SOURCE /* readlink */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/cli.h"
#include "cli/picture_options.h"

/* --------------------------------------------------- the page with the case */

/* The option --live of overroll view: the program's page (make web) with the
 * case and the player of a result. */

static const char MARK[] = "<script type=\"application/json\" id=\"given\">";
static const char NONE[] = "null";

/* Returns the content of a file, to be freed; NULL with errno. */
static char *content(const char *path)
{
    FILE *from = fopen(path, "rb");
    char *text = NULL;
    long size = -1;
    if (!from)
        return NULL;
    if (!fseek(from, 0, SEEK_END) && (size = ftell(from)) >= 0 &&
        !fseek(from, 0, SEEK_SET) && (text = malloc((size_t)size + 1))) {
        text[fread(text, 1, (size_t)size, from)] = '\0';
    }
    fclose(from);
    return text;
}

/* Places of the program's page relative to the program: in the build folder,
 * and installed. */
static const char *const places[] = {"web/overroll.html",
                                     "../share/overroll/overroll.html"};

/* Writes the folder of the program with a slash at the end; false if it is not
 * known. */
static bool find_folder(char self[4000])
{
    ssize_t n = readlink("/proc/self/exe", self, 3999);
    self[n > 0 ? n : 0] = '\0';
    if (n > 0)
        *(strrchr(self, '/') + 1) = '\0';
    return n > 0;
}

/* Returns the program's page from the build folder or the installed one. */
static char *template(const char *self)
{
    char path[4100];
    char *text = NULL;
    for (size_t k = 0; k < 2 && !text; k++) {
        snprintf(path, sizeof path, "%s%s", self, places[k]);
        text = content(path);
    }
    return text;
}

/* Writes a JSON string that cannot close a script element. */
static void write_text(FILE *to, const char *text)
{
    putc('"', to);
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        if (c < 0x20 || c == '"' || c == '\\' || c == '<')
            fprintf(to, "\\u%04x", c);
        else
            putc(c, to);
    }
    putc('"', to);
}

static bool write_page(const char *path, const char *program, const char *at,
                       const char *case_text, const char *player)
{
    FILE *to = fopen(path, "wb");
    bool written;
    if (!to)
        return false;
    at += strlen(MARK);
    fwrite(program, 1, (size_t)(at - program), to);
    fputs("{\"case\":", to);
    write_text(to, case_text ? case_text : "");
    fputs(",\"page\":", to);
    write_text(to, player);
    putc('}', to);
    fputs(at + strlen(NONE), to);
    written = !ferror(to);
    return fclose(to) == 0 && written;
}

/* Replaces the player at `path` by the program's page that contains player and
 * case; returns the exit code. */
static int make_live(const cli_call *call, const char *path,
                     const char *case_text)
{
    char self[4000];
    char *program = find_folder(self) ? template(self) : NULL;
    const char *at = program ? strstr(program, MARK) : NULL;
    char *player = content(path);
    int code = CLI_DONE;
    if (!at) {
        code = cli_usage(call,
                         "--live needs %s%s or %s%s: run make web; for an "
                         "installed program, then make install again",
                         self, places[0], self, places[1]);
        unlink(path);
    } else if (!player || !write_page(path, program, at, case_text, player)) {
        fprintf(stderr, "overroll: cannot write %s (%s)\n", path,
                strerror(errno));
        code = CLI_FAILED;
    }
    free(player);
    free(program);
    return code;
}

static const cli_option options[] = {
    {"o", "PAGE.html", "web page to be written", false},
    {"title", "TEXT", "title instead of that of the file", false},
    {"stress", "FIELD",
     "also draw stresses below the surface: max_shear, tau_xz, ... (default "
     "with [stress]: max_shear)",
     false},
    {"live", NULL,
     "include the program: inputs can be changed and solved in the page",
     false},
    {"force", NULL, "replace existing files", false},
    {NULL, NULL, NULL, false},
};

/* False for names of pictures, movies and tables. */
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
        code = make_live(call, o.path,
                         ovr_result_get_info(results[0])->case_text);
    if (code == CLI_DONE && call->verbosity >= 0)
        printf("%s\n", o.path);
    cli_close_results(call, results);
    return code;
}

const cli_verb cli_view = {
    .name = "view",
    .no_json = true,
    .arguments = "OUT.h5 [OTHER.h5] -o PAGE.html",
    .summary = "make a web page that plays the run",
    .help = "The page needs no network and no installation. Two files are\n"
            "played side by side. With --live the page also contains the\n"
            "program (make web) and the case of the result.",
    .options = options,
    .minimum = 1,
    .maximum = 2,
    .run = run,
};
