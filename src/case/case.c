/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case as a store of values; reading its file is in case_file.c, what it
 * resolves to in resolve.c. */
#include "case/case.h"
#include "base/sized.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/entries.h"
#include "base/text.h"
#include "overroll/surface.h"
#include "overroll/text.h"

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

/* A section that a study has. */
static bool is_of_study(const char *word)
{
    static const char *const names[] = {"study", "set", "product", "zip"};
    for (int k = 0; k < 4; k++)
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
    enum { MOST = 64 };
    const char *names[MOST], *meant;
    size_t n = 0, length = strcspn(header, " \t."), used = 0;
    char word[OVR_NAME_MOST + 1], there[400] = "";
    for (; n < MOST && ovr_section_row(n); n++) {
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
                        "[%s] belongs in a study: this is one, not a case; "
                        "'overroll sweep' runs its cases",
                        word);
    if (is_shape(word)) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown section [%s]; did you mean [feature %s]?", word,
                 word);
        return ovr_fail_meant(err, OVR_BAD_INPUT, "feature");
    }
    meant = ovr_suggest(word, names, n);
    if (meant) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown section [%.*s]; did you mean [%s]?", OVR_NAME_MOST,
                 header, meant);
        return ovr_fail_meant(err, OVR_BAD_INPUT, meant);
    }
    return ovr_fail(err, OVR_BAD_INPUT, "unknown section [%.*s]; there are %s",
                    OVR_NAME_MOST, header, there);
}

/* A name that survives being written as [section NAME]. */
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
    char word[OVR_NAME_MOST + 1];
    if (strlen(header) > OVR_NAME_MOST) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "section name [%.20s...] is longer than %d characters", header,
                 OVR_NAME_MOST);
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
                 "[%s %s]: a name must not hold ] or #, a blank at its end, or "
                 "control characters",
                 word, *name);
        return NULL;
    }
    return section;
}

/* ------------------------------------------------------------------ slots */

static void no_key(const ovr_section *section, const char *key, ovr_error *err)
{
    const char *names[128], *meant;
    const ovr_section *home = NULL;
    const ovr_parameter *row;
    size_t n;
    for (n = 0; n < section->count && n < 128; n++)
        names[n] = section->rows[n].key;
    meant = ovr_suggest(key, names, n);
    for (n = 0; (row = ovr_parameter_row(n, &home)); n++)
        if (!strcmp(row->key, key) && (!meant || strlen(key) > 1))
            break;
    if (row)
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown key '%.48s' in [%s]; it belongs in [%s]", key,
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
    no_key(block->section, key, err);
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

/* ------------------------------------------------------ making and freeing */

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

static ovr_case *read_source(ovr_case *c, const char *text, const char *name,
                             const char *directory, ovr_error *err)
{
    c->name = ovr_arena_text(&c->arena, name, err);
    c->source = ovr_arena_text(&c->arena, text, err);
    if (directory)
        c->directory = ovr_arena_text(&c->arena, directory, err);
    if (c->name && c->source && (c->directory || !directory) &&
        ovr_case_parse(c, err) == OVR_OK)
        return c;
    ovr_case_free(c);
    return NULL;
}

ovr_case *ovr_case_read_text(const char *text, const char *name,
                             const char *directory,
                             const ovr_allocator *allocator, ovr_error *err)
{
    ovr_case *c = ovr_case_create(allocator, err);
    return c ? read_source(c, text, name, directory, err) : NULL;
}

ovr_case *ovr_case_read_stored(const char *text, const char *name,
                               const char *directory,
                               const ovr_allocator *allocator, ovr_error *err)
{
    ovr_case *c = ovr_case_read_text(text, name, directory, allocator, err);
    if (c)
        ovr_case_mark_stored(c);
    return c;
}

/* A result given in place of its case: what it is good for. */
static ovr_status refuse_result(const char *path, ovr_error *err)
{
    static const char magic[] = "\211HDF\r\n\032\n";
    char head[sizeof magic] = "";
    FILE *file = fopen(path, "rb");
    size_t got = file ? fread(head, 1, sizeof head - 1, file) : 0;
    if (file)
        fclose(file);
    if (got != sizeof magic - 1 || memcmp(head, magic, got) != 0)
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: is a result file, not a case: 'overroll resume' goes "
                    "on with it, 'overroll info -v' shows the case it was made "
                    "from",
                    path);
}

ovr_case *ovr_case_read(const char *path, const ovr_allocator *allocator,
                        ovr_error *err)
{
    ovr_arena scratch = ovr_arena_make(allocator);
    char *folder = ovr_arena_text(&scratch, path, err);
    const char *text;
    ovr_case *c = NULL;
    if (folder && !refuse_result(path, err) &&
        !ovr_text_file(path, "case", OVR_CASE_MOST, &scratch, &text, err)) {
        char *slash = strrchr(folder, '/');
        if (slash)
            slash[slash == folder] = '\0';
        c = ovr_case_read_text(text, path, slash ? folder : NULL, allocator,
                               err);
    }
    ovr_arena_release(&scratch);
    return c;
}

/* --------------------------------------------------------------- settings */

/* "section.key" taken apart at its last point. */
typedef struct place {
    ovr_slot *slot; /* NULL: there is none */
    const ovr_parameter *row;
    const char *before; /* section named, where the key no longer belongs */
} place;

static place find_place(ovr_case *c, const char *where, ovr_error *err)
{
    const char *point = strrchr(where, '.'), *name;
    const ovr_section *named, *section;
    ovr_block *block;
    place at = {0};
    char header[OVR_NAME_MOST + 2];
    if (!point || point == where || !point[1]) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "'%.60s' must be section.key, such as contact.M", where);
        return at;
    }
    snprintf(header, sizeof header, "%.*s", (int)(point - where), where);
    named = ovr_section_parse(header, &name, err);
    if (!named)
        return at;
    section = ovr_section_now(named, point + 1);
    if (!ovr_parameter_find(section, point + 1)) {
        no_key(section, point + 1, err);
        return at;
    }
    block = ovr_case_block(c, section, name, err);
    if (block)
        at.slot = ovr_block_slot(block, point + 1, &at.row, err);
    at.before = section == named ? NULL : named->name;
    return at;
}

/* What is written into the text of a case is read from it again. */
static bool survives(const char *text)
{
    for (const char *p = text; *p; p++) {
        bool first = p == text || p[-1] == ' ' || p[-1] == '\t';
        if (*p == '#' || (*p == ';' && first) ||
            ((unsigned char)*p < ' ' && *p != '\t'))
            return false;
    }
    return true;
}

static const char *trimmed(const char *value, ovr_arena *arena, ovr_error *err)
{
    ovr_line line = ovr_trim((ovr_line){value, strlen(value), 0});
    char *copy = ovr_arena_take(arena, line.size + 1, 1, err);
    if (copy)
        memcpy(copy, line.text, line.size);
    return copy;
}

ovr_status ovr_case_set(ovr_case *c, const char *where, const char *value,
                        const char *origin, ovr_error *err)
{
    ovr_error why = {0};
    place at = find_place(c, where, &why);
    const ovr_parameter *row = at.row;
    ovr_slot fresh;
    if (!at.slot)
        return ovr_fail_from(err, &why, origin, 0);
    if (strlen(value) > OVR_LINE_MOST - OVR_NAME_MOST)
        return ovr_fail_about(err, row->key, "%s: %s: the value is too long",
                              origin, row->key);
    if (!survives(value))
        return ovr_fail_about(err, row->key,
                              "%s: %s: the value must not hold # or a ; behind "
                              "a blank (comments of a case), nor control "
                              "characters",
                              origin, row->key);
    value = trimmed(value, &c->arena, err);
    if (!value)
        return OVR_NO_MEMORY;
    if (ovr_slot_read(row, value, &c->arena, &fresh, &why))
        return ovr_fail_from(err, &why, origin, 0);
    fresh.given = true;
    fresh.before = at.before;
    fresh.line = 0;
    fresh.file = ovr_arena_text(&c->arena, origin, err);
    if (!fresh.file)
        return OVR_NO_MEMORY;
    fresh.replaces = at.slot->replaces ? at.slot->replaces : at.slot->line;
    *at.slot = fresh;
    return OVR_OK;
}

ovr_status ovr_case_assign(ovr_case *c, const char *assignment,
                           const char *origin, ovr_error *err)
{
    const char *equals = strchr(assignment, '=');
    char where[2 * OVR_NAME_MOST + 2], value[OVR_LINE_MOST + 1];
    ovr_line left, right;
    if (!equals)
        equals = assignment;
    left = ovr_trim((ovr_line){assignment, (size_t)(equals - assignment), 0});
    right = (ovr_line){equals + 1, *equals ? strlen(equals + 1) : 0, 0};
    right = ovr_trim(right);
    if (!left.size || left.size >= sizeof where || right.size >= sizeof value)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: '%.60s' must be section.key=value", origin,
                        assignment);
    snprintf(where, sizeof where, "%.*s", (int)left.size, left.text);
    snprintf(value, sizeof value, "%.*s", (int)right.size, right.text);
    return ovr_case_set(c, where, value, origin, err);
}

void ovr_case_unset(ovr_case *c, const char *where)
{
    place at = find_place(c, where, NULL);
    ovr_slot fresh;
    if (!at.slot)
        return;
    fresh = (ovr_slot){.key = at.row->key, .number = NAN};
    if (at.row->initial &&
        ovr_slot_read(at.row, at.row->initial, &c->arena, &fresh, NULL))
        return;
    fresh.replaces = at.slot->replaces ? at.slot->replaces : at.slot->line;
    *at.slot = fresh;
}

void ovr_case_mark_stored(ovr_case *c)
{
    for (ovr_block *b = c->blocks; b; b = b->next)
        for (size_t k = 0; k < b->count; k++)
            b->slots[k].stored = b->slots[k].given;
}

/* ---------------------------------------------------------------- looking */

const char *ovr_case_name(const ovr_case *c)
{
    return c->name;
}

const char *ovr_case_directory(const ovr_case *c)
{
    return c->directory;
}

size_t ovr_case_entries(const ovr_case *c)
{
    size_t n = 0;
    for (const ovr_block *b = c->blocks; b; b = b->next)
        n += b->count;
    return n;
}

void ovr_case_entry_into(const ovr_case *c, size_t k, ovr_case_entry *to)
{
    const ovr_block *b = c->blocks;
    ovr_case_entry entry = {0};
    while (b && k >= b->count) {
        k -= b->count;
        b = b->next;
    }
    if (b) {
        const ovr_slot *slot = &b->slots[k];
        const ovr_parameter *row = &b->section->rows[k];
        entry.section = b->section->name;
        entry.name = b->name;
        entry.key = row->key;
        entry.text = slot->text;
        entry.given = slot->given;
        entry.before = slot->before;
        entry.file = slot->file;
        entry.line = slot->line;
        entry.number = slot->number;
        if (slot->unit)
            entry.unit = ovr_unit_si(ovr_unit_dimension(slot->unit));
        entry.parameter = ovr_section_first(b->section) + k;
        entry.applies = ovr_key_applies(c, b, row);
    }
    ovr_sized_give(to, &entry, sizeof entry);
}
