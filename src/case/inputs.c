/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists the files that a run reads in addition to the case file: the values of
 * keys that are paths of inputs. */
#include "case/inputs.h"

#include <stdio.h>
#include <string.h>

#include "case/case.h"

const char *ovr_slot_path(const ovr_case *c, const ovr_slot *slot,
                          ovr_arena *arena, ovr_error *err)
{
    const char *folder = c->directory;
    size_t capacity;
    char *path;
    if (!folder || slot->text[0] == '/' || slot->line == 0)
        return ovr_arena_text(arena, slot->text, err);
    capacity = strlen(folder) + strlen(slot->text) + 2;
    path = ovr_arena_take(arena, capacity, 1, err);
    if (path)
        snprintf(path, capacity, "%s/%s", folder, slot->text);
    return path;
}

bool ovr_key_is_input(const ovr_parameter *row)
{
    return row->kind == OVR_PATH && row->physics;
}

static bool is_input(const ovr_case *c, const ovr_block *b, size_t k)
{
    const ovr_parameter *row = &b->section->rows[k];
    return ovr_key_is_input(row) && b->slots[k].given && b->slots[k].text &&
           ovr_key_applies(c, b, row);
}

static size_t count_inputs(const ovr_case *c)
{
    size_t n = 0;
    for (const ovr_block *b = c->blocks; b; b = b->next)
        for (size_t k = 0; k < b->count; k++)
            n += is_input(c, b, k);
    return n;
}

static ovr_status add_input(const ovr_case *c, const ovr_block *b, size_t k,
                            ovr_arena *arena, ovr_inputs *to, ovr_error *err)
{
    char key[2 * OVR_NAME_MAX + 2];
    ovr_input *input = &to->input[to->count];
    snprintf(key, sizeof key, "%s%s%s.%s", b->section->name, b->name ? " " : "",
             b->name ? b->name : "", b->slots[k].key);
    input->key = ovr_arena_text(arena, key, err);
    input->name = ovr_arena_text(arena, b->slots[k].text, err);
    input->path = ovr_slot_path(c, &b->slots[k], arena, err);
    if (!input->key || !input->name || !input->path)
        return OVR_NO_MEMORY;
    while (strcmp(to->input[input->first].path, input->path) != 0)
        input->first++;
    to->count++;
    return OVR_OK;
}

ovr_status ovr_case_inputs(const ovr_case *c, ovr_arena *arena, ovr_inputs *to,
                           ovr_error *err)
{
    ovr_status status = OVR_OK;
    *to = (ovr_inputs){NULL, 0};
    to->input = ovr_arena_take(arena, count_inputs(c), sizeof *to->input, err);
    if (!to->input)
        return OVR_NO_MEMORY;
    for (const ovr_block *b = c->blocks; b; b = b->next)
        for (size_t k = 0; !status && k < b->count; k++)
            if (is_input(c, b, k))
                status = add_input(c, b, k, arena, to, err);
    return status;
}
