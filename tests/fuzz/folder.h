/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Temporary folder for files of fuzz targets that read files by name; removed
 * at the end of the process. */
#ifndef TESTS_FUZZ_FOLDER_H
#define TESTS_FUZZ_FOLDER_H

#include <dirent.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "overroll/error.h"

static inline void fuzz_fail_unless(int good)
{
    if (!good)
        abort();
}

static inline bool fuzz_is_line(const ovr_error *err)
{
    return err->status && err->message[0] && !strpbrk(err->message, "\n\r");
}

static char fuzz_folder[] = "/tmp/overroll-fuzz-XXXXXX";

static inline void fuzz_leave(void)
{
    DIR *here = opendir(".");
    for (struct dirent *e = here ? readdir(here) : NULL; e; e = readdir(here))
        if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0)
            remove(e->d_name);
    if (here)
        closedir(here);
    (void)!chdir("/");
    rmdir(fuzz_folder);
}

/* Enters a temporary folder at the first call; the folder is removed at the end
 * of the process. */
static inline void fuzz_enter(void)
{
    static bool inside;
    if (inside)
        return;
    fuzz_fail_unless(mkdtemp(fuzz_folder) && chdir(fuzz_folder) == 0);
    atexit(fuzz_leave);
    inside = true;
}

static inline void fuzz_put(const char *name, const void *data, size_t size)
{
    fuzz_enter();
    FILE *file = fopen(name, "wb");
    fuzz_fail_unless(file && fwrite(data, 1, size, file) == size);
    fuzz_fail_unless(fclose(file) == 0);
}

#endif
