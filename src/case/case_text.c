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

static void put(growing *g, const char *text, size_t length)
{
    if (g->length + length + 1 > g->capacity)
        return; /* cannot happen: the space was counted before */
    memcpy(g->text + g->length, text, length);
    g->length += length;
    g->text[g->length] = '\0';
}

static void put_text(growing *g, const char *text)
{
    put(g, text, strlen(text));
}

static bool is_later(const ovr_slot *slot)
{
    return slot->given && slot->line == 0;
}

/* Writes a path. A path that was set later is relative to the working
 * directory, and one in the text to the folder of the case. It is made absolute
 * if the line is long enough. */
static void put_path(growing *g, const char *path)
{
    enum { LONGEST = OVR_LINE_MAX - OVR_NAME_MAX };
    char folder[LONGEST + 1];
    if (g->moved && path[0] != '/' && getcwd(folder, sizeof folder) &&
        strlen(folder) + 1 + strlen(path) <= LONGEST) {
        put_text(g, folder);
        put_text(g, "/");
    }
    put_text(g, path);
}

static void put_setting(growing *g, const ovr_block *b, size_t k)
{
    const ovr_parameter *row = &b->section->rows[k];
    put_text(g, row->key);
    put_text(g, " = ");
    if (ovr_key_is_input(row))
        put_path(g, b->slots[k].text);
    else
        put_text(g, b->slots[k].text);
    put_text(g, "\n");
}

/* Writes the settings of the block that replace no line of the file. */
static void put_new(growing *g, const ovr_block *b)
{
    for (size_t k = 0; k < b->count; k++)
        if (is_later(&b->slots[k]) && !b->slots[k].replaces)
            put_setting(g, b, k);
}

/* Writes a setting in place of the line `line` and keeps that line's comment in
 * its column. */
static void put_instead(growing *g, const ovr_block *b, size_t k,
                        const char *line)
{
    const char *comment = line + strcspn(line, "#;\n");
    size_t from = g->length;
    put_setting(g, b, k);
    if (*comment != '#' && *comment != ';')
        return;
    for (g->length--; g->length < from + COMMENT_COLUMN;)
        put_text(g, " ");
    put_text(g, " ");
    put(g, comment, strcspn(comment, "\n"));
    put_text(g, "\n");
}

/* Writes the replacement of a line, which may be empty. Returns false if the
 * line is kept. */
static bool put_replaced(growing *g, const ovr_case *c, long line,
                         const char *at)
{
    for (const ovr_block *b = c->blocks; b; b = b->next)
        for (size_t k = 0; k < b->count; k++)
            if (b->slots[k].replaces == line) {
                if (is_later(&b->slots[k]))
                    put_instead(g, b, k, at);
                return true;
            }
    return false;
}

static void put_source(growing *g, const ovr_case *c)
{
    const char *at = c->source;
    for (long line = 1; *at; line++) {
        size_t length = strcspn(at, "\n");
        length += at[length] == '\n';
        if (!put_replaced(g, c, line, at)) {
            put(g, at, length);
            if (at[length - 1] != '\n')
                put_text(g, "\n");
        }
        for (const ovr_block *b = c->blocks; b; b = b->next)
            if (b->line == line)
                put_new(g, b);
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

static void put_new_sections(growing *g, const ovr_case *c)
{
    for (const ovr_block *b = c->blocks; b; b = b->next)
        if (!b->line && has_new(b)) {
            put_text(g, "[");
            put_text(g, b->section->name);
            if (b->name) {
                put_text(g, " ");
                put_text(g, b->name);
            }
            put_text(g, "]\n");
            put_new(g, b);
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
        put_source(&g, c);
    put_new_sections(&g, c);
    return g.text;
}
