/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether a key has an effect: the conditions of its row (base/parameter.h). */
#include <stdio.h>
#include <string.h>

#include "case/case.h"

static const ovr_slot *slot_of(const ovr_case *c, const ovr_block *block,
                               const char *where)
{
    const char *point = strchr(where, '.');
    char section[OVR_NAME_MOST + 1];
    if (!point)
        return ovr_block_get(block, where);
    snprintf(section, sizeof section, "%.*s", (int)(point - where), where);
    return ovr_block_get(ovr_case_find_block(c, section, NULL), point + 1);
}

/* `words` are set apart by " | ". */
static bool is_one_of(const char *text, const char *words, size_t size)
{
    const char *end = words + size;
    while (words < end) {
        size_t length = strcspn(words, " ;");
        if (length == strlen(text) && !memcmp(words, text, length))
            return true;
        words += length;
        words += strspn(words, " |");
    }
    return false;
}

/* One condition, `size` characters long. */
static bool holds(const ovr_case *c, const ovr_block *block, const char *when,
                  size_t size)
{
    size_t length = strcspn(when, " ;");
    const char *words = when + length + strspn(when + length, " =");
    char where[2 * OVR_NAME_MOST];
    const ovr_slot *slot;
    snprintf(where, sizeof where, "%.*s", (int)length, when);
    slot = slot_of(c, block, where);
    if (length == size)
        return slot->given;
    return slot->text &&
           is_one_of(slot->text, words, (size_t)(when + size - words));
}

bool ovr_key_applies(const ovr_case *c, const ovr_block *block,
                     const ovr_parameter *row)
{
    const char *when = row->when;
    while (when && *when) {
        size_t size = strcspn(when, ";");
        if (!holds(c, block, when, size))
            return false;
        when += size;
        when += strspn(when, "; ");
    }
    return true;
}
