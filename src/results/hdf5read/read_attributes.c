/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads attributes of an object, numbers and texts, by name. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "results/hdf5read/elements.h"

/* Parts of an attribute message. */
typedef struct attribute {
    ovr_piece name, type, space, value;
} attribute;

/* Splits an attribute message into name, data type, dataspace and value. In
 * version 1 the first three are padded to multiples of 8 bytes. */
static bool read_attribute(ovr_piece b, attribute *to)
{
    uint64_t version = ovr_take(&b, 1), shared = ovr_take(&b, 1);
    uint64_t size[3], unit = version == 1 ? 8 : 1;
    ovr_piece part[3];
    for (size_t k = 0; k < 3; k++)
        size[k] = ovr_take(&b, 2);
    ovr_take(&b, version == 3 ? 1 : 0);
    for (size_t k = 0; k < 3; k++) {
        part[k] = ovr_cut(&b, size[k]);
        ovr_cut(&b, -size[k] % unit);
    }
    *to = (attribute){part[0], part[1], part[2], b};
    return version >= 1 && version <= 3 && !shared && b.good && size[0] > 0 &&
           part[0].at[size[0] - 1] == '\0';
}

/* Reads an attribute that is one element. */
static bool one_element(const attribute *a, ovr_datatype *element)
{
    ovr_dataset set;
    return ovr_element_read(a->type, element) &&
           ovr_shape_read(a->space, &set) && set.shape[0] == 1 &&
           set.width == 1 && a->value.left >= element->size;
}

static bool find_attribute(ovr_container *c, uint64_t object, const char *name,
                           ovr_datatype *element, ovr_piece *value)
{
    ovr_items items;
    attribute a;
    if (!ovr_object_items(&c->source, object, OVR_ITEM_ATTRIBUTE, &items))
        return false;
    for (size_t k = 0; k < items.count; k++)
        if (read_attribute(items.item[k], &a) &&
            a.name.left == strlen(name) + 1 &&
            memcmp(a.name.at, name, a.name.left) == 0) {
            *value = a.value;
            return one_element(&a, element);
        }
    return false;
}

static char *copy(ovr_container *c, ovr_piece text)
{
    char *made = ovr_arena_take(c->source.arena, text.left + 1, 1, NULL);
    c->source.starved = c->source.starved || !made;
    if (made && text.left)
        memcpy(made, text.at, text.left);
    return made;
}

char *ovr_container_text(ovr_container *c, uint64_t object, const char *name)
{
    ovr_datatype element;
    ovr_piece value, text;
    uint64_t length, heap, index;
    if (!find_attribute(c, object, name, &element, &value))
        return NULL;
    if (element.kind == 's')
        return copy(c, ovr_cut(&value, element.size));
    if (element.kind != 'v')
        return NULL;
    length = ovr_take(&value, 4);
    heap = ovr_take(&value, 8);
    index = ovr_take(&value, 4);
    if (length == 0)
        return copy(c, (ovr_piece){NULL, 0, true});
    if (!ovr_heap_text(&c->source, heap, index, &text))
        return NULL;
    text = ovr_cut(&text, length);
    return text.good ? copy(c, text) : NULL;
}

double ovr_container_number(ovr_container *c, uint64_t object, const char *name)
{
    ovr_datatype element;
    ovr_piece bytes;
    double value;
    if (!find_attribute(c, object, name, &element, &bytes) ||
        (element.kind != 'f' && element.kind != 'i'))
        return NAN;
    ovr_element_values(&element, bytes.at, 1, &value);
    return value;
}

static int by_order(const void *a, const void *b)
{
    const ovr_named_number *first = a, *second = b;
    return (first->order > second->order) - (first->order < second->order);
}

/* Sorts by creation order. The position of a message is not significant,
 * because HDF5 moves messages when headers grow. */
ovr_named_number *ovr_container_numbers(ovr_container *c, uint64_t object,
                                        size_t *count)
{
    ovr_items items;
    ovr_named_number *found;
    *count = 0;
    if (!ovr_object_items(&c->source, object, OVR_ITEM_ATTRIBUTE, &items))
        return NULL;
    found = ovr_arena_take(c->source.arena, items.count, sizeof *found, NULL);
    c->source.starved = c->source.starved || !found;
    for (size_t k = 0; found && k < items.count; k++) {
        ovr_named_number *to = &found[*count];
        ovr_datatype element;
        attribute a;
        if (!read_attribute(items.item[k], &a) || !one_element(&a, &element) ||
            (element.kind != 'f' && element.kind != 'i') ||
            !ovr_plain_name(a.name.at, a.name.left - 1) ||
            a.name.left > sizeof to->name)
            continue;
        memcpy(to->name, a.name.at, a.name.left);
        to->order = items.order ? items.order[k] : k;
        ovr_element_values(&element, a.value.at, 1, &to->value);
        (*count)++;
    }
    if (found)
        qsort(found, *count, sizeof *found, by_order);
    return found;
}

/* ---------------------------------------------------------- tables of texts */

/* Datasets of texts. Each element refers to an object of a global heap. */

/* Finds the elements of a one-dimensional, contiguous dataset of texts. */
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

static char *read_text(ovr_source *source, ovr_piece *elements)
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
        if (!(texts[k] = read_text(source, &b)))
            return NULL;
    *count = (size_t)n;
    return texts;
}
