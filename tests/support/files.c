/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/test.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_SIZE = 4096 };

int test_make_folder(void **state)
{
    const char *tmp = getenv("TMPDIR");
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%s/overroll.XXXXXX", tmp ? tmp : "/tmp");
    if (!mkdtemp(path))
        return -1;
    *state = strdup(path);
    return *state ? 0 : -1;
}

static void remove_tree(const char *path)
{
    DIR *folder = opendir(path);
    struct dirent *entry;
    while (folder && (entry = readdir(folder))) {
        char name[PATH_SIZE];
        struct stat about;
        if (!strcmp(entry->d_name, ".") || !strcmp(entry->d_name, ".."))
            continue;
        snprintf(name, sizeof name, "%s/%s", path, entry->d_name);
        if (!lstat(name, &about) && S_ISDIR(about.st_mode))
            remove_tree(name);
        else
            unlink(name);
    }
    if (folder)
        closedir(folder);
    rmdir(path);
}

int test_remove_folder(void **state)
{
    remove_tree(*state);
    free(*state);
    return 0;
}

const char *test_path(const char *folder, const char *name)
{
    static char paths[4][PATH_SIZE];
    static unsigned turn;
    char *path = paths[turn++ % 4];
    snprintf(path, PATH_SIZE, "%s/%s", folder, name);
    return path;
}

char *test_read(const char *path, size_t *bytes)
{
    FILE *file = fopen(path, "rb");
    size_t used = 0, size = 4096, got = 1;
    char *data = malloc(size + 1);
    if (!file)
        fail_msg("cannot open %s", path);
    while (data && got) {
        got = fread(data + used, 1, size - used, file);
        used += got;
        if (used == size) {
            char *more = realloc(data, (size *= 2) + 1);
            assert_non_null(more);
            data = more;
        }
    }
    assert_non_null(data);
    assert_false(ferror(file));
    fclose(file);
    data[used] = '\0';
    if (bytes)
        *bytes = used;
    return data;
}

void test_write(const char *path, const void *data, size_t bytes)
{
    FILE *file = fopen(path, "wb");
    if (!file)
        fail_msg("cannot create %s", path);
    assert_int_equal(fwrite(data, 1, bytes, file), bytes);
    assert_int_equal(fclose(file), 0);
}

void test_write_text(const char *path, const char *text)
{
    test_write(path, text, strlen(text));
}
