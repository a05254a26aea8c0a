/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/growing_text.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "overroll/text.h"

enum { FIRST_CAPACITY = 4096, LONGEST = 400 };

ovr_text ovr_text_make(ovr_arena *arena)
{
    return (ovr_text){.arena = arena};
}

/* Enlarges the buffer by at least `bytes`; false if memory is insufficient. */
static bool grow(ovr_text *t, size_t bytes)
{
    size_t capacity = t->capacity ? t->capacity : FIRST_CAPACITY;
    char *data;
    if (t->failed || bytes <= t->capacity - t->length)
        return !t->failed;
    while (capacity - t->length < bytes)
        capacity *= 2;
    data = ovr_arena_take(t->arena, capacity, 1, &t->why);
    if (!data) {
        t->failed = true;
        return false;
    }
    if (t->length)
        memcpy(data, t->data, t->length);
    t->data = data;
    t->capacity = capacity;
    return true;
}

void ovr_text_add(ovr_text *t, const void *data, size_t bytes)
{
    if (bytes && grow(t, bytes)) {
        memcpy(t->data + t->length, data, bytes);
        t->length += bytes;
    }
}

void ovr_text_put(ovr_text *t, const char *string)
{
    ovr_text_add(t, string, strlen(string));
}

void ovr_text_print(ovr_text *t, const char *format, ...)
{
    char small[512];
    va_list args, again;
    int length;
    va_start(args, format);
    va_copy(again, args);
    length = vsnprintf(small, sizeof small, format, args);
    if (length < (int)sizeof small)
        ovr_text_add(t, small, length > 0 ? (size_t)length : 0);
    else if (grow(t, (size_t)length + 1)) {
        vsnprintf(t->data + t->length, (size_t)length + 1, format, again);
        t->length += (size_t)length;
    }
    va_end(again);
    va_end(args);
}

ovr_status ovr_text_status(const ovr_text *t, ovr_error *err)
{
    if (!t->failed)
        return OVR_OK;
    return ovr_fail(err, t->why.status, "%s", t->why.message);
}

/* --------------------------------------------------------- external text */

/* True for control characters, including C1 (U+0080 to U+009F) and line
 * separators. */
static bool is_control(const unsigned char *s)
{
    return s[0] < 0x20 || s[0] == 0x7f || (s[0] == 0xc2 && s[1] < 0xa0) ||
           (s[0] == 0xe2 && s[1] == 0x80 && (s[2] == 0xa8 || s[2] == 0xa9));
}

void ovr_text_foreign(ovr_text *t, const char *foreign, ovr_text_rule *put)
{
    const unsigned char *s = (const unsigned char *)foreign;
    for (int count = 0; *s && count < LONGEST; count++) {
        int bytes = ovr_utf8_sequence(s);
        if (bytes == 0)
            put(t, "?", 1);
        else if (is_control(s))
            put(t, " ", 1);
        else
            put(t, (const char *)s, bytes);
        s += bytes ? bytes : 1;
    }
}

/* Escapes a character for a single-quoted string of gnuplot, in which nothing
 * is expanded. A backtick, which runs a command elsewhere, is replaced as well.
 * So is "]]>", because the SVG terminal writes text as CDATA. */
static void append_gnuplot(ovr_text *t, const char *character, int bytes)
{
    bool ends = t->length > 1 && memcmp(t->data + t->length - 2, "]]", 2) == 0;
    if (*character == '\'')
        ovr_text_put(t, "''");
    else if (*character == '`')
        ovr_text_put(t, "\xe2\x80\x98");
    else if (*character == '>' && ends)
        ovr_text_put(t, " >");
    else
        ovr_text_add(t, character, (size_t)bytes);
}

void ovr_text_gnuplot(ovr_text *t, const char *foreign)
{
    ovr_text_put(t, "'");
    ovr_text_foreign(t, foreign, append_gnuplot);
    ovr_text_put(t, "'");
}

static ovr_status save(const ovr_text *t, const char *path, const char *mode,
                       ovr_error *err)
{
    FILE *file;
    bool ok;
    if (ovr_text_status(t, err) != OVR_OK)
        return t->why.status;
    file = fopen(path, mode);
    if (!file)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be created: %s", path,
                        strerror(errno));
    ok = fwrite(t->data, 1, t->length, file) == t->length;
    if (fclose(file) != 0 || !ok)
        return ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path,
                        strerror(errno));
    return OVR_OK;
}

ovr_status ovr_text_save(const ovr_text *t, const char *path, ovr_error *err)
{
    return save(t, path, "wb", err);
}

ovr_status ovr_text_save_anew(const ovr_text *t, const char *path,
                              ovr_error *err)
{
    unlink(path);
    return save(t, path, "wbx", err);
}
