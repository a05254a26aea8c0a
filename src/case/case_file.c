/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The text of a case, through inih's stream reader.
 *
 * inih splits lines at 199 characters, cuts section names at 49, continues
 * the line before when one begins with a blank, and (as Debian builds it)
 * keeps `#` comments in values.  So each line is prepared before inih sees
 * it: counted, checked, comment and outer blanks cut off.  Section headers
 * are understood here too, since inih does not report one without keys.
 */
#include <ini.h>
#include <stdio.h>
#include <string.h>

#include "case/case.h"

typedef struct reading {
    ovr_case *c;
    const char *at; /* next line */
    long line;      /* the one read last */
    ovr_block *block;
    ovr_status status; /* of the first error, which *err tells */
    ovr_error *err;
} reading;

static void fail_line(reading *r, const char *message)
{
    r->status = ovr_fail_at(r->err, OVR_BAD_INPUT, r->c->name, r->line, "%s",
                            message);
}

static void fail_why(reading *r, const ovr_error *why)
{
    r->status = ovr_fail_from(r->err, why, r->c->name, r->line);
}

/* ------------------------------------------------------------------ lines */

static bool is_text(const char *from, const char *end)
{
    for (; from < end; from++)
        if ((unsigned char)*from < ' ' && *from != '\t')
            return false;
    return true;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

/* The next line without comment, outer blanks and line end. */
static void prepare(reading *r, char *line)
{
    const char *from = r->at, *end = from + strcspn(from, "\n"), *comment;
    r->at = *end ? end + 1 : end;
    r->line++;
    line[0] = '\0';
    if (r->line == 1 && !strncmp(from, "\357\273\277", 3))
        from += 3; /* byte order mark */
    while (end > from && end[-1] == '\r')
        end--;
    if (!is_text(from, end)) {
        fail_line(r, "is not text: it holds control characters");
        return;
    }
    comment = memchr(from, '#', (size_t)(end - from));
    if (comment)
        end = comment;
    while (from < end && is_blank(*from))
        from++;
    while (end > from && is_blank(end[-1]))
        end--;
    if (end - from > OVR_LINE_MOST) {
        fail_line(r, "the line is too long: at most 190 characters");
        return;
    }
    memcpy(line, from, (size_t)(end - from));
    line[end - from] = '\0';
}

static void open_section(reading *r, char *line)
{
    size_t length = strlen(line);
    char *header = line + 1 + strspn(line + 1, " \t");
    const char *name;
    const ovr_section *section;
    ovr_error why = {0};
    if (line[length - 1] != ']' || strchr(line, ']') != line + length - 1) {
        fail_line(r, "a section is [name] and nothing else on its line");
        return;
    }
    line[--length] = '\0';
    while (length && is_blank(line[length - 1]))
        line[--length] = '\0';
    section = ovr_section_parse(header, &name, &why);
    r->block = section ? ovr_case_block(r->c, section, name, &why) : NULL;
    if (!r->block) {
        fail_why(r, &why);
        return;
    }
    if (section->named && r->block->line) {
        ovr_fail(&why, OVR_BAD_INPUT,
                 "[%s %s] is there twice (first in line %ld)", section->name,
                 r->block->name, r->block->line);
        fail_why(r, &why);
    }
    if (!r->block->line)
        r->block->line = r->line;
    snprintf(line, OVR_NAME_MOST, "[%s]", section->name);
}

static void check_assignment(reading *r, const char *line)
{
    size_t key = strcspn(line, "=:");
    if (!line[key])
        fail_line(r, "must be 'key = value' or '[section]'");
    else if (key == 0)
        fail_line(r, "a key is missing before '='");
    else if (key > OVR_NAME_MOST)
        fail_line(r, "the key is too long: at most 48 characters");
    else if (!r->block)
        fail_line(r, "a [section] must come before the first key");
}

/* inih's reader: like fgets. */
static char *next_line(char *line, int room, void *stream)
{
    reading *r = stream;
    size_t length;
    if (!*r->at || r->status || room < OVR_LINE_MOST + 2)
        return NULL;
    prepare(r, line);
    if (!r->status && line[0] == '[')
        open_section(r, line);
    else if (!r->status && line[0] && line[0] != ';')
        check_assignment(r, line);
    if (r->status)
        return NULL;
    length = strlen(line);
    line[length] = '\n';
    line[length + 1] = '\0';
    return line;
}

/* ----------------------------------------------------------------- values */

static int take_value(void *user, const char *section, const char *key,
                      const char *value)
{
    reading *r = user;
    const ovr_parameter *row;
    ovr_error why = {0};
    ovr_slot *slot;
    (void)section;
    if (r->status)
        return 0;
    slot = ovr_block_slot(r->block, key, &row, &why);
    if (slot && slot->given) {
        ovr_fail_about(&why, slot->key,
                       "'%s' is given twice in [%s] (first in line %ld)", key,
                       r->block->section->name, slot->line);
        slot = NULL;
    }
    if (!slot || ovr_slot_read(row, value, &r->c->arena, slot, &why)) {
        fail_why(r, &why);
        return 0;
    }
    slot->given = true;
    slot->file = r->c->name;
    slot->line = r->line;
    return 1;
}

ovr_status ovr_case_parse(ovr_case *c, ovr_error *err)
{
    reading r = {c, c->source, 0, NULL, OVR_OK, err};
    int code = ini_parse_stream(next_line, &r, take_value, &r);
    if (r.status)
        return r.status;
    if (code == -2)
        return ovr_fail(err, OVR_NO_MEMORY, "out of memory: %s", c->name);
    if (code)
        return ovr_fail_at(err, OVR_BAD_INPUT, c->name, code,
                           "must be 'key = value' or '[section]'");
    return OVR_OK;
}
