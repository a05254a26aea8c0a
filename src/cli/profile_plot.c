/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A picture of a profile by gnuplot.
 *
 * gnuplot gets a script from us on its standard input.  Names go into it
 * between single quotes, where gnuplot replaces nothing, with quotes doubled
 * and control characters left out: a file's name cannot become a command.
 */
#include "cli/profile_plot.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

static void quote(FILE *to, const char *text)
{
    fputc('\'', to);
    for (; *text; text++) {
        if (*text == '\'')
            fputc('\'', to);
        if ((unsigned char)*text >= 32 && *text != 127)
            fputc(*text, to);
    }
    fputc('\'', to);
}

static const char *terminal(const char *path)
{
    const char *dot = strrchr(path, '.');
    if (dot && strcmp(dot, ".svg") == 0)
        return "svg size 900,400 noenhanced";
    if (dot && strcmp(dot, ".pdf") == 0)
        return "pdfcairo size 18cm,8cm noenhanced";
    return "pngcairo size 1200,500 noenhanced";
}

static void write_script(FILE *to, const ovr_profile_view *view,
                         const char *title, const char *path)
{
    double x = view->scaled_x ? 1 : 1e6, z = view->scaled_z ? 1 : 1e6;
    fprintf(to, "set terminal %s\nset output ", terminal(path));
    quote(to, path);
    fputs("\nset title ", to);
    quote(to, title);
    fprintf(to, "\nset xlabel '%s'\nset ylabel '%s'\nset grid\n",
            view->scaled_x ? "x/b" : "x, um",
            view->scaled_z ? "z R/b^2" : "z, um");
    fputs("plot '-' with lines notitle\n", to);
    for (size_t i = 0; i < view->n; i++)
        if (isnan(view->z[i]))
            fputs("\n", to);
        else
            fprintf(to, "%.9g %.9g\n", view->x[i] * x, view->z[i] * z);
    fputs("e\n", to);
}

/* A path that cannot be written is known before gnuplot is asked. */
static ovr_status check_path(const char *path, ovr_error *err)
{
    FILE *out = fopen(path, "ab");
    if (!out)
        return ovr_fail_at(err, OVR_BAD_INPUT, path, 0, "cannot be written");
    fclose(out);
    return OVR_OK;
}

ovr_status cli_plot_profile(const ovr_profile_view *view, const char *title,
                            const char *path, ovr_error *err)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    ovr_status status = check_path(path, err);
    FILE *to;
    int code;
    if (status)
        return status;
    sigaction(SIGPIPE, &ignore, &before); /* gnuplot may end early */
    to = popen("gnuplot 2>/dev/null", "w");
    if (to)
        write_script(to, view, title, path);
    code = to ? pclose(to) : -1;
    sigaction(SIGPIPE, &before, NULL);
    if (code == 0)
        return OVR_OK;
    remove(path);
    return code != -1 && WIFEXITED(code) && WEXITSTATUS(code) == 127
               ? ovr_fail(err, OVR_IO, "no gnuplot: install gnuplot-nox")
               : ovr_fail_at(err, OVR_IO, path, 0, "gnuplot failed");
}
