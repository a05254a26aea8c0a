/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/gnuplot.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char done[] = "overroll: drawn";

ovr_status ovr_gnuplot_start(ovr_gnuplot *g, ovr_error *err)
{
    /* -d: without anybody's start-up files. */
    static const char *const argv[] = {"gnuplot", "-d", NULL};
    g->path[0] = '\0';
    return ovr_process_start(&g->process, argv, "gnuplot-nox", err);
}

/* In gnuplot a name that begins with '|' is a command and one with '~' a home
 * folder; a line cannot hold its own end. */
ovr_status ovr_gnuplot_output(ovr_text *script, const char *path,
                              ovr_error *err)
{
    for (const char *c = path; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            return ovr_fail(err, OVR_BAD_INPUT,
                            "a picture's name cannot hold control characters");
    ovr_text_put(script, "set output '");
    if (*path == '|' || *path == '~' || *path == '-')
        ovr_text_put(script, "./");
    for (; *path; path++)
        ovr_text_add(script, *path == '\'' ? "''" : path,
                     *path == '\'' ? 2 : 1);
    ovr_text_put(script, "'\n");
    return OVR_OK;
}

/* FOLDER/.NAME.part: the same file system, and no picture by its suffix. */
static bool name_part(char *part, size_t size, const char *path)
{
    const char *slash = strrchr(path, '/');
    int folder = slash ? (int)(slash - path) + 1 : 0;
    int length = snprintf(part, size, "%.*s.%s.part", folder, path,
                          path + folder);
    return length > 0 && (size_t)length < size;
}

/* Better known now: gnuplot would go on, and draw to its standard output. */
static ovr_status can_create(const char *part, const char *path, ovr_error *err)
{
    int file = open(part, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%.500s: cannot be created: %s",
                        path, strerror(errno));
    close(file);
    return OVR_OK;
}

ovr_status ovr_gnuplot_ask(ovr_gnuplot *g, const ovr_text *script,
                           const char *path, ovr_error *err)
{
    char room[80];
    ovr_arena arena = ovr_arena_make(&script->arena->allocator);
    ovr_text output = ovr_text_make(&arena);
    ovr_status status = ovr_text_status(script, err);
    if (status == OVR_OK && (strlen(path) >= sizeof g->path ||
                             !name_part(g->made, sizeof g->made, path)))
        status = ovr_fail(err, OVR_BAD_INPUT, "%.60s...: too long a name",
                          path);
    if (status == OVR_OK)
        status = ovr_gnuplot_output(&output, g->made, err);
    if (status == OVR_OK)
        status = can_create(g->made, path, err);
    if (status == OVR_OK)
        status = ovr_text_status(&output, err);
    if (status == OVR_OK) {
        snprintf(g->path, sizeof g->path, "%s", path);
        /* An empty line first: should a picture have gone here, it is over. */
        snprintf(room, sizeof room, "\nunset output\nprint ''\nprint '%s'\n",
                 done);
        /* When it does not listen, waiting for it tells why. */
        if (ovr_process_send(&g->process, output.data, output.length) &&
            ovr_process_send(&g->process, script->data, script->length))
            ovr_process_send(&g->process, room, strlen(room));
    }
    ovr_arena_release(&arena);
    return status;
}

/* It writes an echo of the line, a caret and then what is wrong. */
static void keep_reason(char *why, size_t size, const char *line)
{
    line += strspn(line, " ");
    if (*line && *line != '^')
        snprintf(why, size, "%s", line);
}

static ovr_status appear(ovr_gnuplot *g, const char *why, ovr_error *err)
{
    struct stat about;
    int code = stat(g->made, &about);
    if (code == 0 && about.st_size == 0) {
        unlink(g->made);
        ovr_fail(err, OVR_IO, "%.500s: gnuplot: %s", g->path, why);
        g->path[0] = '\0';
        return OVR_IO;
    }
    code = rename(g->made, g->path);
    if (code != 0)
        ovr_fail(err, OVR_IO, "%s: cannot be written: %s", g->path,
                 strerror(errno));
    g->path[0] = '\0';
    return code == 0 ? OVR_OK : OVR_IO;
}

ovr_status ovr_gnuplot_wait(ovr_gnuplot *g, ovr_error *err)
{
    char line[600], why[600] = "nothing was drawn";
    if (g->path[0] == '\0')
        return OVR_OK;
    while (ovr_process_line(&g->process, line, sizeof line)) {
        if (strcmp(line, done) == 0)
            return appear(g, why, err);
        keep_reason(why, sizeof why, line);
    }
    unlink(g->made);
    ovr_fail(err, OVR_IO, "%.300s: gnuplot: %s", g->path, why);
    g->path[0] = '\0';
    return OVR_IO;
}

void ovr_gnuplot_stop(ovr_gnuplot *g)
{
    if (g->path[0]) {
        ovr_process_kill(&g->process);
        unlink(g->made);
        g->path[0] = '\0';
    }
    ovr_process_end(&g->process, NULL, 0);
}
