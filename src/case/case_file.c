/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a case from a text or a file, entry by entry. */
#include <stdio.h>
#include <string.h>

#include "base/entries.h"
#include "base/error.h"
#include "base/given.h"
#include "case/case.h"

static ovr_status open_section(ovr_case *c, const ovr_entry *entry,
                               ovr_block **block, ovr_error *err)
{
    const char *name;
    const ovr_section *section = ovr_section_parse(entry->section, &name, err);
    *block = section ? ovr_case_block(c, section, name, err) : NULL;
    if (!*block)
        return OVR_BAD_INPUT;
    if (section->named && (*block)->line)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "[%s %s] is given twice (first in line %ld)",
                        section->name, (*block)->name, (*block)->line);
    if (!(*block)->line)
        (*block)->line = entry->line;
    return OVR_OK;
}

static ovr_status store_value(ovr_case *c, const ovr_entry *entry,
                              const ovr_block *block, ovr_error *err)
{
    const ovr_parameter *row;
    ovr_slot *slot;
    ovr_status status;
    if (strlen(entry->key) > OVR_NAME_MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the key is too long: at most %d characters",
                        OVR_NAME_MAX);
    slot = ovr_block_slot(block, entry->key, &row, err);
    if (!slot)
        return OVR_BAD_INPUT;
    if (slot->given)
        return ovr_fail_about(err, slot->key,
                              "'%s' is given twice in [%s] (first in line "
                              "%ld)",
                              entry->key, block->section->name, slot->line);
    status = ovr_slot_read(row, entry->value, &c->arena, slot, err);
    slot->given = !status;
    slot->file = c->name;
    slot->line = entry->line;
    return status;
}

static ovr_status parse(ovr_case *c, ovr_error *err)
{
    ovr_entries all = {
        .file = c->name, .at = c->source, .maximum = OVR_LINE_MAX};
    ovr_entry entry;
    ovr_block *block = NULL;
    ovr_status status = ovr_entries_open(&all, &c->arena, err);
    while (!status && !(status = ovr_entries_next(&all, &entry, err)) &&
           entry.line) {
        ovr_error why = {0};
        if (!entry.section && !block)
            return ovr_fail_at(err, OVR_BAD_INPUT, c->name, entry.line,
                               "a key comes before the first [section]");
        status = entry.section ? open_section(c, &entry, &block, &why)
                               : store_value(c, &entry, block, &why);
        if (status)
            return ovr_fail_from(err, &why, c->name, entry.line);
    }
    return status;
}

static ovr_case *read_source(ovr_case *c, const char *text, const char *name,
                             const char *directory, ovr_error *err)
{
    c->name = ovr_arena_text(&c->arena, name, err);
    c->source = ovr_arena_text(&c->arena, text, err);
    if (directory)
        c->directory = ovr_arena_text(&c->arena, directory, err);
    if (c->name && c->source && (c->directory || !directory) &&
        parse(c, err) == OVR_OK)
        return c;
    ovr_case_free(c);
    return NULL;
}

ovr_case *ovr_case_read_text(const char *text, const char *name,
                             const char *directory,
                             const ovr_allocator *allocator, ovr_error *err)
{
    if (!text || !name)
        return ovr_null(err, __func__);
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

/* Rejects a result file given as a case, with advice. */
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
                    "%s: is a result file, not a case; 'overroll resume' "
                    "continues its run, 'overroll info -v' prints its case",
                    path);
}

ovr_case *ovr_case_read(const char *path, const ovr_allocator *allocator,
                        ovr_error *err)
{
    if (!path)
        return ovr_null(err, __func__);
    ovr_arena scratch = ovr_arena_make(allocator);
    char *folder = ovr_arena_text(&scratch, path, err);
    const char *text;
    ovr_case *c = NULL;
    if (folder && !refuse_result(path, err) &&
        (text = ovr_text_file(path, "case", OVR_CASE_MAX, &scratch, err))) {
        char *slash = strrchr(folder, '/');
        if (slash)
            slash[slash == folder] = '\0';
        c = ovr_case_read_text(text, path, slash ? folder : NULL, allocator,
                               err);
    }
    ovr_arena_release(&scratch);
    return c;
}
