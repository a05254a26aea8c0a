/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/entries.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/text.h"

ovr_status ovr_entries_open(ovr_entries *e, ovr_arena *arena, ovr_error *err)
{
    bool marked = !strncmp(e->at, "\357\273\277", 3); /* byte order mark */
    e->at += 3 * marked;
    e->copy = ovr_arena_take(arena, e->maximum + 1, 1, err);
    return e->copy ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status fail(const ovr_entries *e, const char *what, ovr_error *err)
{
    return ovr_fail_at(err, OVR_BAD_INPUT, e->file, e->line, "%s", what);
}

/* Returns the length of a line without its comment. */
static size_t without_comment(const char *from, size_t length)
{
    for (size_t k = 0; k < length; k++)
        if (from[k] == '#' || (from[k] == ';' && (!k || from[k - 1] == ' ' ||
                                                  from[k - 1] == '\t')))
            return k;
    return length;
}

/* Copies the next line without comment, leading and trailing blanks and line
 * end. */
static ovr_status next_line(ovr_entries *e, ovr_error *err)
{
    size_t length = strcspn(e->at, "\n");
    ovr_line line = {e->at, length, ++e->line};
    e->at += length + (e->at[length] == '\n');
    while (line.size && line.text[line.size - 1] == '\r')
        line.size--;
    for (size_t k = 0; k < line.size; k++)
        if ((unsigned char)line.text[k] < ' ' && line.text[k] != '\t')
            return fail(e, "is not text: the line contains control characters",
                        err);
    line.size = without_comment(line.text, line.size);
    line = ovr_trim(line);
    if (line.size > e->maximum)
        return ovr_fail_at(err, OVR_BAD_INPUT, e->file, e->line,
                           "the line is too long: at most %zu characters",
                           e->maximum);
    memcpy(e->copy, line.text, line.size);
    e->copy[line.size] = '\0';
    return OVR_OK;
}

/* Removes leading and trailing blanks and terminates the text in place. */
static char *trimmed(char *text, size_t size)
{
    ovr_line line = ovr_trim((ovr_line){text, size, 0});
    text += line.text - text;
    text[line.size] = '\0';
    return text;
}

static ovr_status parse_section(ovr_entries *e, ovr_entry *entry,
                                ovr_error *err)
{
    char *line = e->copy, *end = strchr(line, ']');
    if (!end || end[1])
        return fail(e, "a section must be [name] with nothing else on its line",
                    err);
    entry->section = trimmed(line + 1, (size_t)(end - line) - 1);
    e->inside = true;
    return OVR_OK;
}

static ovr_status parse_pair(ovr_entries *e, ovr_entry *entry, ovr_error *err)
{
    char *line = e->copy;
    size_t size = strcspn(line, "=:");
    if (!line[size])
        return fail(e, "must be 'key = value' or '[section]'", err);
    if (!size)
        return fail(e, "a key is missing before '='", err);
    if (!e->inside)
        return fail(e, "a [section] must come before the first key", err);
    entry->value = trimmed(line + size + 1, strlen(line + size + 1));
    entry->key = trimmed(line, size);
    return OVR_OK;
}

ovr_status ovr_entries_next(ovr_entries *e, ovr_entry *entry, ovr_error *err)
{
    ovr_status status = OVR_OK;
    *entry = (ovr_entry){0};
    while (!status && *e->at && !entry->line) {
        status = next_line(e, err);
        if (status || !*e->copy)
            continue;
        entry->line = e->line;
        status = *e->copy == '[' ? parse_section(e, entry, err)
                                 : parse_pair(e, entry, err);
    }
    return status;
}

const char *ovr_text_file(const char *path, const char *what, size_t maximum,
                          ovr_arena *arena, ovr_error *err)
{
    char *content = ovr_arena_take(arena, maximum + 2, 1, err);
    FILE *file = content ? fopen(path, "rb") : NULL;
    size_t got = file ? fread(content, 1, maximum + 1, file) : 0;
    bool broken = !file || ferror(file);
    if (!content)
        return NULL;
    if (broken)
        ovr_fail(err, OVR_BAD_INPUT, "%s: cannot read the %s: %s", path, what,
                 strerror(errno));
    if (file)
        fclose(file);
    if (broken)
        return NULL;
    if (got <= maximum && strlen(content) == got)
        return content;
    if (got > maximum)
        ovr_fail(err, OVR_BAD_INPUT,
                 "%s: is too long for a %s (at most %zu bytes)", path, what,
                 maximum);
    else
        ovr_fail(err, OVR_BAD_INPUT, "%s: is not a %s file: it is not text",
                 path, what);
    return NULL;
}
