/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The text of a case: its sections and keys, entry by entry. */
#include <string.h>

#include "base/entries.h"
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
                        "[%s %s] is there twice (first in line %ld)",
                        section->name, (*block)->name, (*block)->line);
    if (!(*block)->line)
        (*block)->line = entry->line;
    return OVR_OK;
}

static ovr_status take_value(ovr_case *c, const ovr_entry *entry,
                             const ovr_block *block, ovr_error *err)
{
    const ovr_section *section = ovr_section_now(block->section, entry->key);
    const ovr_block *home = section == block->section
                                ? block
                                : ovr_case_find_block(c, section->name, NULL);
    const ovr_parameter *row;
    ovr_slot *slot;
    ovr_status status;
    if (strlen(entry->key) > OVR_NAME_MOST)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the key is too long: at most %d characters",
                        OVR_NAME_MOST);
    slot = ovr_block_slot(home, entry->key, &row, err);
    if (!slot)
        return OVR_BAD_INPUT;
    if (slot->given)
        return ovr_fail_about(err, slot->key,
                              "'%s' is given twice in [%s] (first in line %ld)",
                              slot->key, section->name, slot->line);
    status = ovr_slot_read(row, entry->value, &c->arena, slot, err);
    slot->given = !status;
    slot->before = home == block ? NULL : block->section->name;
    slot->file = c->name;
    slot->line = entry->line;
    return status;
}

ovr_status ovr_case_parse(ovr_case *c, ovr_error *err)
{
    ovr_entries all;
    ovr_entry entry;
    ovr_block *block = NULL;
    ovr_status status = ovr_entries_open(&all, c->source, c->name,
                                         OVR_LINE_MOST, &c->arena, err);
    while (!status && !(status = ovr_entries_next(&all, &entry, err)) &&
           entry.line) {
        ovr_error why = {0};
        if (!entry.section && !block)
            return ovr_fail_at(err, OVR_BAD_INPUT, c->name, entry.line,
                               "a key stands before the first [section]");
        status = entry.section ? open_section(c, &entry, &block, &why)
                               : take_value(c, &entry, block, &why);
        if (status)
            return ovr_fail_from(err, &why, c->name, entry.line);
    }
    return status;
}
