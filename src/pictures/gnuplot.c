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

/* In gnuplot a name that begins with '|' or '<' is a command and one with '~'
 * a home folder; a line cannot hold its own end. */
ovr_status ovr_gnuplot_path(ovr_text *script, const char *path, ovr_error *err)
{
    for (const char *c = path; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            return ovr_fail(err, OVR_BAD_INPUT,
                            "the name of a picture must not contain control "
                            "characters");
    ovr_text_put(script, *path == '/' ? "'" : "'./");
    for (; *path; path++)
        ovr_text_add(script, *path == '\'' ? "''" : path,
                     *path == '\'' ? 2 : 1);
    ovr_text_put(script, "'");
    return OVR_OK;
}

/* FOLDER/.NAMEsuffix, OVR_PATH_SIZE bytes. */
static ovr_status name_beside(char *name, const char *path, const char *suffix,
                              ovr_error *err)
{
    const char *slash = strrchr(path, '/');
    int folder = slash ? (int)(slash - path) + 1 : 0;
    int length = snprintf(name, OVR_PATH_SIZE, "%.*s.%s%s", folder, path,
                          path + folder, suffix);
    if (length > 0 && length < OVR_PATH_SIZE)
        return OVR_OK;
    name[0] = '\0';
    return ovr_fail(err, OVR_BAD_INPUT, "%.60s...: the name is too long", path);
}

/* A new, empty file of this name and of our own: a link that somebody has put
 * there is not followed. */
static bool make_anew(const char *path)
{
    int file;
    unlink(path);
    file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return file >= 0 && close(file) == 0;
}

/* The part lies on the same file system as the path, and has no picture's
 * suffix.  That it cannot be created is better known now: gnuplot would go on,
 * and draw to its standard output. */
ovr_status ovr_part_make(char *part, const char *path, ovr_error *err)
{
    if (name_beside(part, path, ".part", err) != OVR_OK)
        return OVR_BAD_INPUT;
    if (make_anew(part))
        return OVR_OK;
    part[0] = '\0';
    return ovr_fail(err, OVR_BAD_INPUT, "%.500s: cannot be created: %s", path,
                    strerror(errno));
}

/* gnuplot reads its standard input a byte at a time, 100,000 system calls for
 * a picture; a file it reads in blocks. */
static ovr_status send_script(ovr_gnuplot *g, const ovr_text *script,
                              ovr_arena *arena, ovr_error *err)
{
    ovr_text file = ovr_text_make(arena), line = ovr_text_make(arena);
    ovr_status status;
    ovr_text_put(&file, "set output ");
    ovr_text_put(&line, "load ");
    status = ovr_gnuplot_path(&file, g->made, err);
    if (status == OVR_OK)
        status = ovr_gnuplot_path(&line, g->script, err);
    if (status != OVR_OK)
        return status;
    ovr_text_put(&file, "\n");
    ovr_text_add(&file, script->data, script->length);
    ovr_text_put(&file, "unset output\n");
    /* An empty line first: should a picture have gone here, it is over; and
     * a template may have had its own words printed elsewhere. */
    ovr_text_print(&line, "\nset print\nprint ''\nprint '%s'\n", done);
    status = ovr_text_save_anew(&file, g->script, err);
    if (status == OVR_OK)
        status = ovr_text_status(&line, err);
    /* If writing to gnuplot fails, waiting for it returns the reason. */
    if (status == OVR_OK)
        ovr_process_send(&g->process, line.data, line.length);
    return status;
}

static void clear_away(ovr_gnuplot *g)
{
    unlink(g->made);
    unlink(g->script);
    g->path[0] = '\0';
}

ovr_status ovr_gnuplot_ask(ovr_gnuplot *g, const ovr_text *script,
                           const char *path, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&script->arena->allocator);
    ovr_status status = ovr_text_status(script, err);
    if (status == OVR_OK)
        status = name_beside(g->script, path, ".gp", err);
    if (status == OVR_OK)
        status = ovr_part_make(g->made, path, err);
    if (status != OVR_OK)
        return status;
    snprintf(g->path, sizeof g->path, "%s", path);
    status = send_script(g, script, &arena, err);
    if (status != OVR_OK)
        clear_away(g);
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
    ovr_status status = OVR_OK;
    if (stat(g->made, &about) == 0 && about.st_size == 0)
        status = ovr_fail(err, OVR_IO, "%.500s: gnuplot: %s", g->path, why);
    else if (rename(g->made, g->path) != 0)
        status = ovr_fail(err, OVR_IO, "%.500s: cannot be written: %s", g->path,
                          strerror(errno));
    clear_away(g);
    return status;
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
    ovr_fail(err, OVR_IO, "%.300s: gnuplot: %s", g->path, why);
    clear_away(g);
    return OVR_IO;
}

void ovr_gnuplot_stop(ovr_gnuplot *g)
{
    if (g->path[0]) {
        ovr_process_kill(&g->process);
        clear_away(g);
    }
    ovr_process_end(&g->process, NULL, 0);
}
