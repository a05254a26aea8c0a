/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The option --live of overroll view: the page of the program (make web) with
 * the case and the player of a result.
 */
#define _GNU_SOURCE /* readlink */
#include "cli/view_live.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char MARK[] = "<script type=\"application/json\" id=\"given\">";
static const char NONE[] = "null";

/* The content of a file, to be freed; NULL with errno. */
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

/* The page of the program: in the build folder, or where it is installed. */
static char *template(void)
{
    static const char *const places[] = {"web/overroll.html",
                                         "../share/overroll/overroll.html"};
    char self[4000], path[4100];
    ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
    char *text = NULL;
    if (n <= 0)
        return NULL;
    self[n] = '\0';
    *(strrchr(self, '/') + 1) = '\0';
    for (size_t k = 0; k < 2 && !text; k++) {
        snprintf(path, sizeof path, "%s%s", self, places[k]);
        text = content(path);
    }
    return text;
}

/* Writes a JSON string in which nothing ends a script element. */
static void put_text(FILE *to, const char *text)
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
    put_text(to, case_text ? case_text : "");
    fputs(",\"page\":", to);
    put_text(to, player);
    putc('}', to);
    fputs(at + strlen(NONE), to);
    written = !ferror(to);
    return fclose(to) == 0 && written;
}

int cli_make_live(const cli_call *call, const char *path, const char *case_text)
{
    char *program = template();
    const char *at = program ? strstr(program, MARK) : NULL;
    char *player = content(path);
    int code = CLI_DONE;
    if (!at) {
        code = cli_usage(call, "--live needs the page that make web builds");
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
