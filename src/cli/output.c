/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _XOPEN_SOURCE 700 /* realpath */
#include "cli/output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Returns FOLDER/.NAME.part. */
static char *name_beside(const char *path)
{
    const char *slash = strrchr(path, '/');
    size_t folder = slash ? (size_t)(slash - path) + 1 : 0;
    size_t capacity = strlen(path) + sizeof "..part";
    char *part = malloc(capacity);
    if (part)
        snprintf(part, capacity, "%.*s.%s.part", (int)folder, path,
                 path + folder);
    return part;
}

/* True for a regular file. Other files, and links without target, are written
 * directly. */
static bool is_plain(const char *path)
{
    struct stat about;
    return lstat(path, &about) != 0 ||
           (stat(path, &about) == 0 && S_ISREG(about.st_mode));
}

static FILE *open_beside(cli_output *out)
{
    out->target = realpath(out->path, NULL);
    if (!out->target)
        out->target = strdup(out->path);
    out->part = out->target ? name_beside(out->target) : NULL;
    if (!out->part)
        return NULL;
    unlink(out->part); /* a remainder of an earlier run */
    return fopen(out->part, "wx");
}

static void forget(cli_output *out)
{
    free(out->target);
    free(out->part);
    out->target = out->part = NULL;
}

int cli_output_open(const cli_call *call, const char *path, cli_output *out)
{
    *out = (cli_output){.to = stdout, .path = path};
    if (!path)
        return CLI_DONE;
    if (access(path, F_OK) == 0 && !cli_flag(call, "force"))
        return cli_usage(call, "%s: exists already; --force replaces it", path);
    out->to = is_plain(path) ? open_beside(out) : fopen(path, "w");
    if (out->to)
        return CLI_DONE;
    cli_usage(call, "%s: cannot be written: %s", path, strerror(errno));
    forget(out);
    return CLI_USAGE;
}

int cli_output_close(cli_output *out, int code)
{
    bool whole;
    if (out->to == stdout)
        return code;
    whole = !ferror(out->to);
    whole = fclose(out->to) == 0 && whole;
    if (whole && code == CLI_DONE && out->part)
        whole = rename(out->part, out->target) == 0;
    else if (out->part)
        unlink(out->part);
    if (!whole && code == CLI_DONE) {
        fprintf(stderr, "%s: cannot be written: %s\n", out->path,
                strerror(errno));
        code = CLI_FAILED;
    }
    forget(out);
    return code;
}
