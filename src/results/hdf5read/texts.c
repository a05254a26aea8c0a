/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Datasets of texts: each element names a piece of a global heap. */
#include <string.h>

#include "results/hdf5read/elements.h"

/* Reads `count` texts of one dimension that lie as they are. */
static bool find_texts(ovr_source *source, uint64_t object, uint64_t *at,
                       uint64_t *count)
{
    enum { SPACE = 0x01, TYPE = 0x03, LAYOUT = 0x08, CONTIGUOUS = 1 };
    ovr_piece type, space, layout;
    ovr_datatype element;
    ovr_dataset set;
    if (!ovr_object_message(source, object, TYPE, &type) ||
        !ovr_object_message(source, object, SPACE, &space) ||
        !ovr_object_message(source, object, LAYOUT, &layout) ||
        !ovr_element_read(type, &element) || element.kind != 'v' ||
        !ovr_shape_read(space, &set) || set.rank != 1 ||
        ovr_take(&layout, 1) != 3 || ovr_take(&layout, 1) != CONTIGUOUS)
        return false;
    *at = ovr_take(&layout, 8);
    *count = set.shape[0];
    return layout.good;
}

static char *copy_text(ovr_source *source, ovr_piece text)
{
    char *made = ovr_arena_take(source->arena, text.left + 1, 1, NULL);
    source->starved = source->starved || !made;
    if (made && text.left)
        memcpy(made, text.at, text.left);
    return made;
}

static char *take_text(ovr_source *source, ovr_piece *elements)
{
    uint64_t length = ovr_take(elements, 4), heap = ovr_take(elements, 8);
    uint64_t index = ovr_take(elements, 4);
    ovr_piece text = {NULL, 0, true};
    if (!elements->good ||
        (length > 0 && !ovr_heap_text(source, heap, index, &text)))
        return NULL;
    if (length > 0)
        text = ovr_cut(&text, length);
    return text.good ? copy_text(source, text) : NULL;
}

const char **ovr_container_texts(ovr_container *c, uint64_t object,
                                 size_t *count)
{
    enum { ELEMENT = 16 };
    ovr_source *source = &c->source;
    const char **texts;
    uint64_t at, n;
    ovr_piece b;
    if (!find_texts(source, object, &at, &n) || n > source->bytes / ELEMENT ||
        !ovr_load(source, at, n * ELEMENT, &b))
        return NULL;
    texts = ovr_arena_take(source->arena, (size_t)n, sizeof *texts, NULL);
    source->starved = source->starved || !texts;
    for (size_t k = 0; texts && k < n; k++)
        if (!(texts[k] = take_text(source, &b)))
            return NULL;
    *count = (size_t)n;
    return texts;
}
