/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes the case and the input files stored in a result file to a folder.
 * Their names may be malicious, so each becomes the name of a file in the
 * folder itself, without path, control characters or a leading point. Different
 * files have different names, and the written case uses these names. Links are
 * not followed, and nothing is written if any of the files exists.
 */
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/disk.h"
#include "base/given.h"
#include "case/inputs.h"
#include "overroll/version.h"
#include "results/results.h"
#include "run/pass_series.h"
#include "run/unpack.h"

enum { NAME_SIZE = 112, PATH_SIZE = 4096 };

typedef struct target {
    size_t input; /* number of the input in the result */
    char name[NAME_SIZE];
} target;

typedef struct unpacking {
    ovr_arena arena;
    ovr_result *result;
    const char *path, *folder;
    bool force;
    ovr_case *c;
    ovr_inputs keys; /* keys of the case that name input files */
    target *to;      /* first the case file, then the inputs */
    size_t targets;
    ovr_listener *say;
    void *data;
} unpacking;

static void report(const unpacking *u, ovr_message_kind kind,
                   const char *format, ...) OVR_PRINTF(3, 4);
static void report(const unpacking *u, ovr_message_kind kind,
                   const char *format, ...)
{
    char text[OVR_MESSAGE_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (u->say)
        u->say(u->data, kind, text);
}

/* -------------------------------------------------------------------- Names */

static bool is_plain(unsigned char c)
{
    return isalnum(c) || c >= 0x80 || (c && strchr("._-+ ", c));
}

/* Copies the last part of a path as a plain name of at most 96 characters. */
static void make_name(const char *path, char name[NAME_SIZE])
{
    enum { LONGEST = 96 };
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    size_t length = strlen(base);
    if (length > LONGEST) { /* keep the end of the name, with its suffix */
        base += length - LONGEST;
        while ((*base & 0xc0) == 0x80) /* not at the start of a UTF-8
                                        * character */
            base++;
    }
    snprintf(name, NAME_SIZE, "%s", *base ? base : "input");
    for (char *c = name; *c; c++) {
        bool edge = c == name || !c[1];
        if (!is_plain((unsigned char)*c) || (edge && *c == ' ') ||
            (c == name && (*c == '.' || *c == '-')))
            *c = '_';
    }
}

static bool is_taken(const unpacking *u, const char *name)
{
    for (size_t k = 0; k < u->targets; k++)
        if (strcasecmp(u->to[k].name, name) == 0)
            return true;
    return false;
}

/* Adds a file: "scratch.csv", or "scratch-2.csv" if that name is used. */
static target *add_target(unpacking *u, size_t input, const char *path)
{
    target *to = &u->to[u->targets];
    char plain[NAME_SIZE];
    make_name(path, plain);
    const char *dot = strrchr(plain, '.');
    size_t stem = dot ? (size_t)(dot - plain) : strlen(plain);
    snprintf(to->name, sizeof to->name, "%s", plain);
    for (int k = 2; is_taken(u, to->name); k++)
        snprintf(to->name, sizeof to->name, "%.*s-%d%s", (int)stem, plain, k,
                 plain + stem);
    to->input = input;
    u->targets++;
    return to;
}

static target *find_target(unpacking *u, size_t input)
{
    for (size_t k = 1; k < u->targets; k++)
        if (u->to[k].input == input)
            return &u->to[k];
    return NULL;
}

/* Names the case file, "dent.ini" for a result "runs/dent.h5". */
static void name_case(unpacking *u)
{
    const char *slash = strrchr(u->path, '/');
    const char *base = slash ? slash + 1 : u->path, *dot = strrchr(base, '.');
    size_t stem = dot && dot != base ? (size_t)(dot - base) : strlen(base);
    char name[PATH_SIZE];
    snprintf(name, sizeof name, "%.*s.ini", (int)stem, base);
    add_target(u, SIZE_MAX, name);
}

/* Lists the files to write and sets their names in the case. */
static ovr_status choose_names(unpacking *u, ovr_error *err)
{
    ovr_status status = ovr_case_inputs(u->c, &u->arena, &u->keys, err);
    if (status)
        return status;
    u->to = ovr_arena_take(&u->arena, u->keys.count + 1, sizeof *u->to, err);
    if (!u->to)
        return OVR_NO_MEMORY;
    name_case(u);
    for (size_t k = 0; !status && k < u->keys.count; k++) {
        const ovr_input *key = &u->keys.input[k];
        size_t input = ovr_result_input_of(u->result, key->key);
        const ovr_result_input *of = ovr_result_input_at(u->result, input);
        if (!of) {
            report(u, OVR_MESSAGE_WARNING,
                   "%.200s: the file %.300s of %s is not in "
                   "the result file",
                   u->path, key->name, key->key);
            continue;
        }
        const target *to = find_target(u, input);
        if (!to)
            to = add_target(u, input, of->name);
        if (strcmp(to->name, key->name) != 0)
            status = ovr_case_set(u->c, key->key, to->name, u->path, err);
    }
    return status;
}

/* ------------------------------------------------------------------ Writing */

static ovr_status full_path(const unpacking *u, const target *to,
                            char path[PATH_SIZE], ovr_error *err)
{
    int n = snprintf(path, PATH_SIZE, "%s/%s", u->folder, to->name);
    return n > 0 && n < PATH_SIZE
               ? OVR_OK
               : ovr_fail(err, OVR_BAD_INPUT, "%.200s: the path is too long",
                          u->folder);
}

static ovr_status cannot(const char *path, int error, ovr_error *err)
{
    char text[128] = "";
    if (strerror_r(error, text, sizeof text) != 0)
        text[0] = '\0';
    return ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be written: %s", path,
                    text);
}

/* Fails if a file to be written exists or is not a regular file. */
static ovr_status check_target(const unpacking *u, const target *to,
                               ovr_error *err)
{
    char path[PATH_SIZE];
    struct stat about;
    if (full_path(u, to, path, err))
        return OVR_BAD_INPUT;
    if (lstat(path, &about) != 0)
        return OVR_OK;
    if (!S_ISREG(about.st_mode))
        return ovr_fail(err, OVR_BAD_INPUT, "%s: is not an ordinary file",
                        path);
    if (!u->force)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: exists already; --force replaces it", path);
    struct stat result;
    if (stat(u->path, &result) == 0 && result.st_ino == about.st_ino &&
        result.st_dev == about.st_dev)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: is the result file itself",
                        path);
    return OVR_OK;
}

static ovr_status write_file(const unpacking *u, const target *to,
                             const void *bytes, size_t size, ovr_error *err)
{
    char path[PATH_SIZE];
    if (full_path(u, to, path, err))
        return OVR_BAD_INPUT;
    if (u->force && unlink(path) != 0 && errno != ENOENT)
        return cannot(path, errno, err);
    int fd = open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                  0666);
    if (fd < 0)
        return cannot(path, errno, err);
    int error = size ? ovr_write_all(fd, bytes, size, 0) : 0;
    if (close(fd) != 0 && !error)
        error = errno;
    if (error) {
        unlink(path);
        cannot(path, error, err);
        return OVR_IO;
    }
    report(u, OVR_MESSAGE_FILE, "%s", path);
    return OVR_OK;
}

static ovr_status write_input(const unpacking *u, const target *to,
                              ovr_error *err)
{
    const ovr_result_input *of = ovr_result_input_at(u->result, to->input);
    if (!of->kept) {
        report(u, OVR_MESSAGE_WARNING,
               "%.200s: contains only the SHA-256 of %s (%s); copy the file to "
               "%.300s",
               u->path, to->name, *of->sha256 ? of->sha256 : "unknown",
               u->folder);
        return OVR_OK;
    }
    ovr_arena arena = ovr_arena_make(&u->arena.allocator);
    size_t size = (size_t)of->bytes;
    unsigned char *bytes = ovr_arena_take(&arena, size + 1, 1, err);
    ovr_status status = bytes ? ovr_result_input_read(u->result, to->input,
                                                      bytes, err)
                              : OVR_NO_MEMORY;
    if (!status)
        status = write_file(u, to, bytes, size, err);
    ovr_arena_release(&arena);
    return status;
}

static ovr_status write_files(unpacking *u, ovr_error *err)
{
    ovr_status status = OVR_OK;
    const char *text = ovr_case_text(u->c, err);
    struct stat about;
    if (!text)
        return OVR_NO_MEMORY;
    if (mkdir(u->folder, 0777) != 0 &&
        (errno != EEXIST || stat(u->folder, &about) != 0 ||
         !S_ISDIR(about.st_mode)))
        return cannot(u->folder, errno, err);
    for (size_t k = 0; !status && k < u->targets; k++)
        status = check_target(u, &u->to[k], err);
    for (size_t k = 1; !status && k < u->targets; k++)
        status = write_input(u, &u->to[k], err);
    return status ? status : write_file(u, &u->to[0], text, strlen(text), err);
}

/* ------------------------------------------------------ Complete unpacking */

/* Notes that another version of the program may compute different numbers. */
static void compare_versions(const unpacking *u)
{
    const char *source = ovr_result_get_info(u->result)->source;
    if (strcmp(source, "overroll " OVERROLL_VERSION) != 0)
        report(u, OVR_MESSAGE_NOTE,
               "%.200s was computed by %.40s and this is overroll %s, whose "
               "numbers may differ",
               u->path, source, OVERROLL_VERSION);
}

static ovr_status unpack(unpacking *u, ovr_error *err)
{
    const char *path = u->path;
    if (ovr_passes_file_is(path)) /* each pass has its own file with the case */
        path = ovr_passes_name(path, 1, &u->arena, err);
    u->result = path ? ovr_result_open(path, &u->arena.allocator, err) : NULL;
    if (!u->result)
        return OVR_BAD_INPUT;
    const char *text = ovr_result_get_info(u->result)->case_text;
    if (!*text)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: contains no case", u->path);
    u->c = ovr_case_read_stored(text, u->path, NULL, &u->arena.allocator, err);
    if (!u->c || choose_names(u, err))
        return OVR_BAD_INPUT;
    compare_versions(u);
    return write_files(u, err);
}

ovr_status ovr_result_unpack(const char *path, const char *folder, bool force,
                             ovr_listener *listener, void *data, ovr_error *err)
{
    if (!path || !folder)
        return ovr_fail_null(err, __func__);
    unpacking u = {.arena = ovr_arena_make(NULL),
                   .path = path,
                   .folder = folder,
                   .force = force,
                   .say = listener,
                   .data = data};
    ovr_status status = unpack(&u, err);
    ovr_case_free(u.c);
    ovr_result_close(u.result);
    ovr_arena_release(&u.arena);
    return status;
}

/* ------------------------------------------------------ temporary copies */

/* Lists and writes the inputs that the result holds, and sets their keys to the
 * paths. */
static ovr_status lend(unpacking *u, ovr_error *err)
{
    ovr_status status = ovr_case_inputs(u->c, &u->arena, &u->keys, err);
    if (!status)
        u->to = ovr_arena_take(&u->arena, u->keys.count + 1, sizeof *u->to,
                               err);
    if (status || !u->to)
        return OVR_NO_MEMORY;
    name_case(u); /* reserves the case's name before inputs get names */
    for (size_t k = 0; !status && k < u->keys.count; k++) {
        const ovr_input *key = &u->keys.input[k];
        size_t input = ovr_result_input_of(u->result, key->key);
        const ovr_result_input *of = ovr_result_input_at(u->result, input);
        const target *to = of ? find_target(u, input) : NULL;
        char path[PATH_SIZE];
        if (!of || !of->kept)
            continue;
        if (!to) {
            to = add_target(u, input, of->name);
            status = write_input(u, to, err);
        }
        if (!status)
            status = full_path(u, to, path, err);
        if (!status)
            status = ovr_case_set(u->c, key->key, path, u->path, err);
    }
    return status;
}

ovr_status ovr_inputs_lend(ovr_result *result, const char *path, ovr_case *c,
                           ovr_lent *to, ovr_error *err)
{
    *to = (ovr_lent){.arena = ovr_arena_make(NULL)};
    if (!ovr_result_input_at(result, 0))
        return OVR_OK;
    snprintf(to->folder, sizeof to->folder, "/tmp/overroll-XXXXXX");
    if (!mkdtemp(to->folder)) { /* the inputs remain paths of the case */
        to->folder[0] = '\0';
        return OVR_OK;
    }
    unpacking u = {.arena = to->arena,
                   .result = result,
                   .path = path,
                   .folder = to->folder,
                   .c = c};
    ovr_status status = lend(&u, err);
    to->arena = u.arena;
    to->file = ovr_arena_take(&to->arena, u.targets + 1, sizeof *to->file,
                              NULL);
    for (size_t k = 1; to->file && k < u.targets; k++)
        to->file[to->files++] = u.to[k].name;
    return status;
}

void ovr_inputs_remove(ovr_lent *lent)
{
    char path[PATH_SIZE];
    for (size_t k = 0; k < lent->files; k++) {
        snprintf(path, sizeof path, "%s/%s", lent->folder, lent->file[k]);
        unlink(path);
    }
    if (lent->folder[0])
        rmdir(lent->folder);
    ovr_arena_release(&lent->arena);
}
