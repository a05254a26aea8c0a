/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Storage of a case: its blocks and slots, and the messages about unknown
 * sections and keys. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "case/case.h"
#include "overroll/surface.h"
#include "overroll/text.h"
#include "surface/profile.h"

/* ----------------------------------------------------------------- blocks */

static ovr_block *add_block(ovr_case *c, const ovr_section *section,
                            const char *name, ovr_error *err)
{
    ovr_block **end = &c->blocks, *block;
    size_t n = section->count;
    while (*end)
        end = &(*end)->next;
    block = ovr_arena_take(&c->arena, 1, sizeof *block, err);
    if (!block)
        return NULL;
    block->section = section;
    block->first = ovr_section_first(section);
    block->count = n;
    block->slots = ovr_arena_take(&c->arena, n, sizeof *block->slots, err);
    block->name = name ? ovr_arena_text(&c->arena, name, err) : NULL;
    if (!block->slots || (name && !block->name))
        return NULL;
    for (size_t k = 0; k < n; k++) {
        const ovr_parameter *row = &section->rows[k];
        block->slots[k] = (ovr_slot){.key = row->key, .number = NAN};
        if (row->initial &&
            ovr_slot_read(row, row->initial, &c->arena, &block->slots[k], err))
            return NULL;
    }
    *end = block;
    return block;
}

const ovr_block *ovr_case_find_block(const ovr_case *c, const char *section,
                                     const char *name)
{
    const ovr_block *b;
    for (b = c->blocks; b; b = b->next)
        if (!strcmp(b->section->name, section) &&
            (!name || !strcmp(b->name, name)))
            return b;
    return NULL;
}

bool ovr_block_is_there(const ovr_block *block)
{
    bool there = block && block->line > 0;
    for (size_t k = 0; block && !there && k < block->count; k++)
        there = block->slots[k].given;
    return there;
}

ovr_block *ovr_case_block(ovr_case *c, const ovr_section *section,
                          const char *name, ovr_error *err)
{
    for (ovr_block *b = c->blocks; b; b = b->next)
        if (b->section == section && (!name || !strcmp(b->name, name)))
            return b;
    return add_block(c, section, name, err);
}

bool ovr_block_is_feature(const ovr_block *block)
{
    return !strcmp(block->section->name, "feature");
}

/* True if `word` is the name of a section of studies. */
static bool is_of_study(const char *word)
{
    static const char *const names[] = {"study", "set",    "product", "zip",
                                        "find",  "random", "limits"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (!strcmp(word, names[k]))
            return true;
    return false;
}

static bool is_shape(const char *word)
{
    int k = 0;
    while (ovr_shape_name(k) && strcmp(ovr_shape_name(k), word) != 0)
        k++;
    return ovr_shape_name(k) != NULL;
}

static ovr_status no_section(const char *header, ovr_error *err)
{
    enum { MAX = 64 };
    const char *names[MAX], *meant;
    size_t n = 0, length = strcspn(header, " \t."), used = 0;
    char word[OVR_NAME_MAX + 1], there[400] = "";
    for (; n < MAX && ovr_section_row(n); n++) {
        const ovr_section *s = ovr_section_row(n);
        names[n] = s->name;
        if (used < sizeof there)
            used += (size_t)snprintf(there + used, sizeof there - used,
                                     "%s%s%s", n ? ", " : "", s->name,
                                     s->named ? " NAME" : "");
    }
    snprintf(word, sizeof word, "%.*s", (int)length, header);
    if (is_of_study(word))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "[%s] is a section of a study: this file is a study, "
                        "not a case; 'overroll sweep' runs its cases",
                        word);
    if (is_shape(word)) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown section [%s]; did you mean [feature %s]?", word,
                 word);
        return ovr_fail_meant(err, OVR_BAD_INPUT, "feature");
    }
    meant = ovr_section_by_synonym(word);
    if (!meant)
        meant = ovr_suggest(word, names, n);
    if (meant) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown section [%.*s]; did you mean [%s]?", OVR_NAME_MAX,
                 header, meant);
        return ovr_fail_meant(err, OVR_BAD_INPUT, meant);
    }
    return ovr_fail(err, OVR_BAD_INPUT,
                    "unknown section [%.*s]; the "
                    "sections are %s",
                    OVR_NAME_MAX, header, there);
}

/* True if a name can be written as [section NAME] and read again. */
static bool may_name(const char *name)
{
    size_t size = strlen(name);
    for (const char *p = name; *p; p++)
        if (strchr("]#", *p) || (unsigned char)*p < ' ' ||
            (*p == ';' && (p == name || p[-1] == ' ')))
            return false;
    return name[size - 1] != ' ';
}

const ovr_section *ovr_section_parse(const char *header, const char **name,
                                     ovr_error *err)
{
    const ovr_section *section;
    size_t length = strcspn(header, " \t.");
    char word[OVR_NAME_MAX + 1];
    if (strlen(header) > OVR_NAME_MAX) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "section name [%.20s...] is longer than %d characters", header,
                 OVR_NAME_MAX);
        return NULL;
    }
    memcpy(word, header, length);
    word[length] = '\0';
    *name = header + length + strspn(header + length, " \t.");
    section = ovr_section_find(word);
    if (!section || (!section->named && header[length])) {
        no_section(header, err);
        return NULL;
    }
    if (!section->named)
        *name = NULL;
    else if (!**name) {
        ovr_fail(err, OVR_BAD_INPUT, "[%s] needs a name: [%s dent]", word,
                 word);
        return NULL;
    } else if (!may_name(*name)) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "[%s %s]: a name must not contain ], # or control "
                 "characters, or end with a blank",
                 word, *name);
        return NULL;
    }
    return section;
}

/* ------------------------------------------------------------------ slots */

/* Reports an unknown key that is a usual symbol ("E"), with the key that holds
 * the quantity. */
static void fail_symbol(const ovr_section *section, const char *key,
                        const ovr_symbol *symbol, ovr_error *err)
{
    bool body = !strcmp(symbol->section, "body");
    if (!strcmp(symbol->section, section->name))
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown key '%.48s' in [%s]; did you mean '%s' (%s)?", key,
                 section->name, symbol->key, symbol->name);
    else
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown key '%.48s' in [%s]; did you mean '%s' in [%s%s] "
                 "(%s)%s?",
                 key, section->name, symbol->key, symbol->section,
                 body ? " 1" : "", symbol->name,
                 !strcmp(symbol->key, "modulus")
                     ? ", or 'modulus' in [contact] (reduced modulus E')"
                     : "");
    ovr_fail_meant(err, OVR_BAD_INPUT, symbol->key);
}

void ovr_no_key(const ovr_section *section, const char *key, ovr_error *err)
{
    const char *names[128], *meant;
    const ovr_symbol *symbol = ovr_symbol_find(key);
    const ovr_section *home = NULL;
    const ovr_parameter *row;
    size_t n;
    for (n = 0; n < section->count && n < 128; n++)
        names[n] = section->rows[n].key;
    meant = ovr_suggest(key, names, n);
    for (n = 0; (row = ovr_parameter_row(n, &home)); n++)
        if (!strcmp(row->key, key) && (!meant || strlen(key) > 1))
            break;
    if (symbol)
        fail_symbol(section, key, symbol, err);
    else if (row)
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown key '%.48s' in [%s]; it is a key of [%s]", key,
                 section->name, home->name);
    else if (meant) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown key '%.48s' in [%s]; did you mean '%s'?", key,
                 section->name, meant);
        ovr_fail_meant(err, OVR_BAD_INPUT, meant);
    } else
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown key '%.48s' in [%s]; 'overroll help %s' lists them",
                 key, section->name, section->name);
}

ovr_slot *ovr_block_slot(const ovr_block *block, const char *key,
                         const ovr_parameter **row, ovr_error *err)
{
    *row = ovr_parameter_find(block->section, key);
    if (*row)
        return &block->slots[*row - block->section->rows];
    ovr_no_key(block->section, key, err);
    return NULL;
}

const ovr_slot *ovr_block_get(const ovr_block *block, const char *key)
{
    const ovr_parameter *row = ovr_parameter_find(block->section, key);
    return &block->slots[row - block->section->rows];
}

ovr_status ovr_fail_slot(ovr_error *err, const ovr_slot *slot,
                         const char *format, ...)
{
    char message[OVR_MESSAGE_SIZE - 200];
    ovr_error why;
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    ovr_fail_about(&why, slot->key, "%s: %s", slot->key, message);
    return ovr_fail_from(err, &why, slot->file, slot->line);
}

ovr_status ovr_slot_columns(const ovr_slot *slot, const char *file,
                            ovr_two_columns *columns, ovr_arena *arena,
                            ovr_error *err)
{
    ovr_arena scratch = ovr_arena_make(&arena->allocator);
    ovr_bytes content;
    ovr_error why = {0};
    ovr_status status = ovr_file_bytes(file, &scratch, &content, &why);
    if (status == OVR_BAD_INPUT)
        ovr_fail_slot(err, slot, "%s", why.message);
    else if (status)
        ovr_fail_from(err, &why, NULL, 0);
    else
        status = ovr_two_columns_read(columns, file, content, arena, err);
    ovr_arena_release(&scratch);
    return status;
}

/* ---------------------------------------------------- creation and release */

ovr_case *ovr_case_create(const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_case *c = ovr_arena_take(&arena, 1, sizeof *c, err);
    if (!c)
        return NULL;
    c->arena = arena;
    for (size_t k = 0; ovr_section_row(k); k++) {
        const ovr_section *section = ovr_section_row(k);
        if (!section->named && !add_block(c, section, NULL, err)) {
            ovr_case_free(c);
            return NULL;
        }
    }
    return c;
}

void ovr_case_free(ovr_case *c)
{
    if (c) {
        ovr_arena arena = c->arena;
        ovr_arena_release(&arena);
    }
}

void ovr_case_mark_stored(ovr_case *c)
{
    for (ovr_block *b = c->blocks; b; b = b->next)
        for (size_t k = 0; k < b->count; k++)
            b->slots[k].stored = b->slots[k].given;
}
