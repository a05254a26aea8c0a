/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Text of a case including later settings. A replaced line keeps its position,
 * a new key follows the header of its section, new sections are at the end. The
 * text stored in a result file can thus be read as a case.
 */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/given.h"
#include "case/case.h"
#include "case/inputs.h"

enum {
    COMMENT_COLUMN = 28
}; /* column of the comments in cases of `overroll init` */

typedef struct growing {
    char *text;
    size_t length, capacity;
    bool moved; /* the case's folder is not the working directory */
} growing;

static void append(growing *g, const char *text, size_t length)
{
    if (g->length + length + 1 > g->capacity)
        return; /* cannot happen: the space was counted before */
    memcpy(g->text + g->length, text, length);
    g->length += length;
    g->text[g->length] = '\0';
}

static void append_text(growing *g, const char *text)
{
    append(g, text, strlen(text));
}

static bool is_later(const ovr_slot *slot)
{
    return slot->given && slot->line == 0;
}

/* Writes a path. A path that was set later is relative to the working
 * directory, and one in the text to the folder of the case. It is made absolute
 * if the line is long enough. */
static void append_path(growing *g, const char *path)
{
    enum { LONGEST = OVR_LINE_MAX - OVR_NAME_MAX };
    char folder[LONGEST + 1];
    if (g->moved && path[0] != '/' && getcwd(folder, sizeof folder) &&
        strlen(folder) + 1 + strlen(path) <= LONGEST) {
        append_text(g, folder);
        append_text(g, "/");
    }
    append_text(g, path);
}

static void append_setting(growing *g, const ovr_block *b, size_t k)
{
    const ovr_parameter *row = &b->section->rows[k];
    append_text(g, row->key);
    append_text(g, " = ");
    if (ovr_key_is_input(row))
        append_path(g, b->slots[k].text);
    else
        append_text(g, b->slots[k].text);
    append_text(g, "\n");
}

/* Writes the settings of the block that replace no line of the file. */
static void append_new_settings(growing *g, const ovr_block *b)
{
    for (size_t k = 0; k < b->count; k++)
        if (is_later(&b->slots[k]) && !b->slots[k].replaces)
            append_setting(g, b, k);
}

/* Writes a setting in place of the line `line` and keeps that line's comment in
 * its column. */
static void append_replacement(growing *g, const ovr_block *b, size_t k,
                               const char *line)
{
    const char *comment = line + strcspn(line, "#;\n");
    size_t from = g->length;
    append_setting(g, b, k);
    if (*comment != '#' && *comment != ';')
        return;
    for (g->length--; g->length < from + COMMENT_COLUMN;)
        append_text(g, " ");
    append_text(g, " ");
    append(g, comment, strcspn(comment, "\n"));
    append_text(g, "\n");
}

/* Writes the replacement of a line, which may be empty. Returns false if the
 * line is kept. */
static bool append_replaced_line(growing *g, const ovr_case *c, long line,
                                 const char *at)
{
    for (const ovr_block *b = c->blocks; b; b = b->next)
        for (size_t k = 0; k < b->count; k++)
            if (b->slots[k].replaces == line) {
                if (is_later(&b->slots[k]))
                    append_replacement(g, b, k, at);
                return true;
            }
    return false;
}

static void append_source(growing *g, const ovr_case *c)
{
    const char *at = c->source;
    for (long line = 1; *at; line++) {
        size_t length = strcspn(at, "\n");
        length += at[length] == '\n';
        if (!append_replaced_line(g, c, line, at)) {
            append(g, at, length);
            if (at[length - 1] != '\n')
                append_text(g, "\n");
        }
        for (const ovr_block *b = c->blocks; b; b = b->next)
            if (b->line == line)
                append_new_settings(g, b);
        at += length;
    }
}

static bool has_new(const ovr_block *b)
{
    for (size_t k = 0; k < b->count; k++)
        if (is_later(&b->slots[k]) && !b->slots[k].replaces)
            return true;
    return false;
}

static void append_new_sections(growing *g, const ovr_case *c)
{
    for (const ovr_block *b = c->blocks; b; b = b->next)
        if (!b->line && has_new(b)) {
            append_text(g, "[");
            append_text(g, b->section->name);
            if (b->name) {
                append_text(g, " ");
                append_text(g, b->name);
            }
            append_text(g, "]\n");
            append_new_settings(g, b);
        }
}

static size_t capacity_needed(const ovr_case *c)
{
    size_t capacity = (c->source ? strlen(c->source) : 0) + 2;
    for (const ovr_block *b = c->blocks; b; b = b->next) {
        capacity += 2 * OVR_NAME_MAX;
        for (size_t k = 0; k < b->count; k++)
            if (is_later(&b->slots[k]))
                capacity += OVR_NAME_MAX + strlen(b->slots[k].text) +
                            OVR_LINE_MAX + COMMENT_COLUMN + 12;
    }
    return capacity;
}

const char *ovr_case_text(ovr_case *c, ovr_error *err)
{
    if (!c)
        return ovr_null(err, __func__);
    growing g = {NULL, 0, capacity_needed(c), c->directory != NULL};
    g.text = ovr_arena_take(&c->arena, g.capacity, 1, err);
    if (!g.text)
        return NULL;
    if (c->source)
        append_source(&g, c);
    append_new_sections(&g, c);
    return g.text;
}
