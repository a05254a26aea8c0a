/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Attributes of the groups of a result file. */
#include "results/reader.h"
#include "results/results.h"

/* Copies what is found, as the file's own memory goes with each look. */
static ovr_group_attribute *copy(ovr_result *r, const ovr_named_number *from,
                                 size_t count)
{
    ovr_group_attribute *to = ovr_arena_take(&r->arena, count, sizeof *to,
                                             NULL);
    for (size_t k = 0; to && k < count; k++) {
        to[k] = (ovr_group_attribute){
            .name = ovr_arena_text(&r->arena, from[k].name, NULL),
            .number = from[k].value};
        if (!to[k].name)
            return NULL;
    }
    return to;
}

static ovr_group_attribute *list(ovr_result *r, const char *path, size_t *count)
{
    ovr_container *c = &r->container;
    uint64_t group;
    const ovr_named_number *found = ovr_reader_object(r, path, &group)
                                        ? ovr_container_numbers(c, group, count)
                                        : NULL;
    ovr_group_attribute *copied = found ? copy(r, found, *count) : NULL;
    ovr_arena_release(&r->work);
    return copied;
}

const ovr_group_attribute *
ovr_result_attributes(ovr_result *r, const char *path, size_t *count)
{
    if (!r || !path || !count)
        return NULL;
    int lock = ovr_reader_lock(r);
    ovr_group_attribute *found = NULL;
    *count = 0;
    if (lock >= 0)
        ovr_reader_close_file(r);
    if (r->fd >= 0 || ovr_reader_file(r, lock, NULL) == OVR_OK)
        found = list(r, path, count);
    ovr_reader_unlock(lock);
    if (!found)
        *count = 0;
    return found;
}
