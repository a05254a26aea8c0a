/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads datasets: types, dimensions, layouts and values. */
#include "results/hdf5read/elements.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "base/pack.h"

/* Types of messages in an object's header. */
enum {
    SPACE = 0x01,
    TYPE = 0x03,
    OTHER_FILES = 0x07,
    LAYOUT = 0x08,
    FILTERS = 0x0b
};

/* -------------------------------------------------------------------- types */

/* True for little-endian signed integers without padding bits. */
static bool is_integer(const ovr_datatype *e, uint64_t bits, ovr_piece rest)
{
    uint64_t offset = ovr_take(&rest, 2), precision = ovr_take(&rest, 2);
    return (e->size == 1 || e->size == 4) && (bits & 0x09) == 0x08 &&
           offset == 0 && precision == 8 * e->size;
}

/* True for little-endian IEEE 754 numbers. */
static bool is_real(const ovr_datatype *e, uint64_t bits, ovr_piece rest)
{
    static const unsigned char form[2][12] = {
        {0, 0, 32, 0, 23, 8, 0, 23, 127, 0, 0, 0},
        {0, 0, 64, 0, 52, 11, 0, 52, 255, 3, 0, 0}};
    bool wide = e->size == sizeof(double);
    ovr_piece found = ovr_cut(&rest, sizeof form[0]);
    return (wide || e->size == sizeof(float)) && found.good &&
           bits == (wide ? 0x3f20u : 0x1f20u) &&
           memcmp(found.at, form[wide], sizeof form[0]) == 0;
}

bool ovr_element_read(ovr_piece type, ovr_datatype *e)
{
    enum { INTEGER = 0, REAL = 1, CHARACTERS = 3, VARIABLE = 9 };
    uint64_t kind = ovr_take(&type, 1) & 0x0f, bits = ovr_take(&type, 3);
    e->size = (size_t)ovr_take(&type, 4);
    if (!type.good || e->size == 0)
        return false;
    switch (kind) {
    case INTEGER: e->kind = 'i'; return is_integer(e, bits, type);
    case REAL: e->kind = 'f'; return is_real(e, bits, type);
    case CHARACTERS: e->kind = 's'; return true;
    case VARIABLE: e->kind = 'v'; return (bits & 0x0f) == 1 && e->size == 16;
    default: return false;
    }
}

/* Reads rank and shape of a dataset. Returns false if a row has more values
 * than eight-byte values fit into INT_MAX bytes. */
bool ovr_shape_read(ovr_piece space, ovr_dataset *set)
{
    enum { WIDEST = INT_MAX / 8 };
    uint64_t version = ovr_take(&space, 1), rank = ovr_take(&space, 1);
    ovr_take(&space, 1);
    ovr_cut(&space, version == 1 ? 5 : 1);
    if ((version != 1 && version != 2) || rank > OVR_DIMENSIONS)
        return false;
    set->rank = (int)rank;
    set->shape[0] = set->width = 1;
    for (uint64_t k = 0; k < rank; k++) {
        set->shape[k] = ovr_take(&space, 8);
        if (k > 0 &&
            (set->shape[k] > WIDEST || (set->width *= set->shape[k]) > WIDEST))
            return false;
    }
    return space.good;
}

static double one_value(const ovr_datatype *e, const unsigned char *from)
{
    ovr_piece b = {from, e->size, true};
    uint64_t bits = ovr_take(&b, e->size);
    uint32_t low = (uint32_t)bits;
    double wide;
    float narrow;
    if (e->kind == 'i' && e->size == 1)
        return (double)(int8_t)(uint8_t)low;
    if (e->kind == 'i')
        return (double)(int32_t)low;
    if (e->size == sizeof narrow) {
        memcpy(&narrow, &low, sizeof narrow);
        return (double)narrow;
    }
    memcpy(&wide, &bits, sizeof wide);
    return wide;
}

void ovr_element_values(const ovr_datatype *e, const unsigned char *from,
                        size_t count, double *values)
{
    for (size_t k = 0; k < count; k++)
        values[k] = one_value(e, from + k * e->size);
}

/* ----------------------------------------------------------------- datasets */

/* Returns the identifier of the next filter. In version 1 filters have names,
 * and their size is rounded up to 8 bytes. */
static uint64_t read_filter(ovr_piece *b, bool first)
{
    uint64_t filter = ovr_take(b, 2), name = ovr_take(b, first ? 2 : 0);
    uint64_t values;
    ovr_take(b, 2);
    values = ovr_take(b, 2);
    ovr_cut(b, name + 4 * (values + (first && values % 2)));
    return filter;
}

/* Accepts either shuffle followed by deflate, or no filters. */
static bool read_filters(ovr_source *source, uint64_t object, bool *packed)
{
    enum { DEFLATE = 1, SHUFFLE = 2 };
    ovr_piece b;
    uint64_t version, count, first, second;
    *packed = ovr_object_message(source, object, FILTERS, &b);
    if (!*packed)
        return true;
    version = ovr_take(&b, 1);
    count = ovr_take(&b, 1);
    ovr_cut(&b, version == 1 ? 6 : 0);
    first = read_filter(&b, version == 1);
    second = read_filter(&b, version == 1);
    return b.good && (version == 1 || version == 2) && count == 2 &&
           first == SHUFFLE && second == DEFLATE;
}

static bool read_layout(ovr_piece b, ovr_dataset *set)
{
    enum { CONTIGUOUS = 1, CHUNKED = 2 };
    uint64_t version = ovr_take(&b, 1), kind = ovr_take(&b, 1);
    bool rows = true;
    set->chunked = kind == CHUNKED;
    if (version != 3 || (kind != CONTIGUOUS && kind != CHUNKED))
        return false;
    if (!set->chunked) {
        set->at = ovr_take(&b, 8);
        return b.good;
    }
    if (ovr_take(&b, 1) != (uint64_t)set->rank + 1)
        return false;
    set->at = ovr_take(&b, 8);
    set->chunk = ovr_take(&b, 4);
    for (int k = 1; k < set->rank; k++)
        rows = ovr_take(&b, 4) == set->shape[k] && set->chunk == 1 && rows;
    return ovr_take(&b, 4) == set->element.size && b.good && rows &&
           set->chunk > 0;
}

/* Checks sizes against the size of the file. Datasets without chunks are not
 * compressed. A one-dimensional dataset has at most as many rows as the file
 * has bytes, because other columns are as long; a compressed one (an input
 * file) at most LARGEST rows. With several dimensions a row is a chunk, and
 * deflate compresses at most by a factor of about 1000. */
static bool sizes_are_possible(const ovr_source *source, const ovr_dataset *set)
{
    enum { SMALLEST = 1032, LARGEST = 4 << 20 };
    uint64_t bytes = source->bytes, row = set->width * set->element.size;
    if (!set->chunked)
        return !set->packed && row > 0 && set->shape[0] <= bytes / row;
    if (set->packed && set->rank == 1 && bytes < LARGEST)
        bytes = LARGEST;
    if (set->rank == 1)
        return set->shape[0] <= bytes && set->chunk <= bytes;
    return set->width > 0 && set->width / SMALLEST <= bytes &&
           set->shape[0] <= SIZE_MAX / 16;
}

bool ovr_container_dataset(ovr_container *c, uint64_t object, ovr_dataset *set)
{
    ovr_piece type, space, layout, other;
    memset(set, 0, sizeof *set);
    if (ovr_object_message(&c->source, object, OTHER_FILES, &other) ||
        !ovr_object_message(&c->source, object, TYPE, &type) ||
        !ovr_object_message(&c->source, object, SPACE, &space) ||
        !ovr_object_message(&c->source, object, LAYOUT, &layout) ||
        !ovr_element_read(type, &set->element) ||
        (set->element.kind != 'f' && set->element.kind != 'i'))
        return false;
    return ovr_shape_read(space, set) && set->rank > 0 &&
           read_layout(layout, set) &&
           read_filters(&c->source, object, &set->packed) &&
           sizes_are_possible(&c->source, set);
}

ovr_object ovr_container_object(ovr_container *c, uint64_t object)
{
    enum { LINK_INFO = 0x02, OLD_GROUP = 0x11 };
    ovr_datatype element;
    ovr_piece body;
    if (ovr_object_message(&c->source, object, LINK_INFO, &body) ||
        ovr_object_message(&c->source, object, OLD_GROUP, &body))
        return OVR_OBJECT_GROUP;
    if (ovr_object_message(&c->source, object, TYPE, &body) &&
        ovr_element_read(body, &element) &&
        (element.kind == 's' || element.kind == 'v'))
        return OVR_OBJECT_TEXTS;
    return OVR_OBJECT_UNKNOWN;
}

/* ------------------------------------------------------------------- chunks */

typedef struct chunk {
    uint64_t from; /* first row of the chunk */
    uint64_t at, bytes,
        left_out; /* `left_out`: bits of filters that were not applied */
} chunk;

typedef enum search { FOUND, NOT_THERE, DAMAGED } search;

/* Loads a node of a version 1 B-tree: pairs of a key and a child. */
static bool load_node(ovr_source *source, uint64_t at, uint64_t pair,
                      uint64_t *level, ovr_piece *pairs)
{
    enum { HEAD = 24 };
    ovr_piece b;
    uint64_t count;
    if (!ovr_load(source, at, HEAD, &b) || memcmp(b.at, "TREE\1", 5) != 0)
        return false;
    ovr_cut(&b, 5);
    *level = ovr_take(&b, 1);
    count = ovr_take(&b, 2);
    return ovr_load(source, at + HEAD, count * pair, pairs);
}

/* Finds the last pair whose first row is at most `row`. */
static bool pick(ovr_piece pairs, uint64_t pair, uint64_t row, chunk *picked)
{
    bool any = false;
    while (pairs.left >= pair) {
        chunk c = {0, 0, 0, 0};
        c.bytes = ovr_take(&pairs, 4);
        c.left_out = ovr_take(&pairs, 4);
        c.from = ovr_take(&pairs, 8);
        ovr_cut(&pairs, pair - 24);
        c.at = ovr_take(&pairs, 8);
        if (c.from > row)
            break;
        *picked = c;
        any = true;
    }
    return any;
}

/* Finds the chunk that starts at `row`. Each level must be one below the
 * preceding one, so that the search terminates. */
static search find_chunk(ovr_source *source, const ovr_dataset *set,
                         uint64_t row, chunk *c)
{
    const uint64_t pair = 16 + 8 * ((uint64_t)set->rank + 1);
    uint64_t level, above = 0;
    ovr_piece pairs;
    c->at = set->at;
    for (bool first = true; c->at != OVR_NOWHERE; first = false) {
        if (!load_node(source, c->at, pair, &level, &pairs) ||
            (!first && level + 1 != above))
            return DAMAGED;
        if (!pick(pairs, pair, row, c))
            return NOT_THERE;
        if (level == 0)
            return c->from == row ? FOUND : NOT_THERE;
        above = level;
    }
    return NOT_THERE;
}

static void fill(const ovr_datatype *e, uint64_t count, double *values)
{
    for (uint64_t k = 0; k < count; k++)
        values[k] = e->kind == 'f' ? NAN : -1;
}

/* Reads `count` uncompressed values. */
static bool plain(ovr_source *source, const ovr_datatype *e, uint64_t at,
                  uint64_t count, double *values)
{
    ovr_piece b;
    if (!ovr_load(source, at, count * e->size, &b))
        return false;
    ovr_element_values(e, b.at, (size_t)count, values);
    return true;
}

/* Reads `count` values of a chunk from value `first` on. */
static bool part_of(ovr_source *source, const ovr_dataset *set, const chunk *c,
                    uint64_t first, uint64_t count, double *values)
{
    const ovr_datatype *e = &set->element;
    const uint64_t all = set->chunk * set->width;
    unsigned char *data = NULL;
    ovr_piece b;
    if (!set->packed)
        return c->bytes == all * e->size &&
               plain(source, e, c->at + first * e->size, count, values);
    if (ovr_load(source, c->at, c->bytes, &b))
        data = ovr_unpack(b.at, b.left, (unsigned)c->left_out, (size_t)all,
                          e->size, source->arena, &source->starved);
    if (data)
        ovr_element_values(e, data + first * e->size, (size_t)count, values);
    return data != NULL;
}

/* Reads the requested parts of chunks one after another. The memory of a chunk
 * is released before the next one is read. With several dimensions a chunk is a
 * row. */
static bool chunks(ovr_source *source, const ovr_dataset *set, uint64_t row,
                   uint64_t count, double *values)
{
    ovr_arena arena = ovr_arena_make(&source->arena->allocator);
    ovr_source scratch = *source;
    search found = FOUND;
    scratch.arena = &arena;
    while (count > 0 && found != DAMAGED) {
        uint64_t from = row - row % set->chunk;
        uint64_t first = (row - from) * set->width;
        uint64_t part = set->chunk * set->width - first;
        chunk c;
        if (part > count)
            part = count;
        found = find_chunk(&scratch, set, from, &c);
        if (found == NOT_THERE)
            fill(&set->element, part, values);
        else if (found == FOUND &&
                 !part_of(&scratch, set, &c, first, part, values))
            found = DAMAGED;
        ovr_arena_release(&arena);
        row = from + set->chunk;
        count -= part;
        values += part;
    }
    source->starved = source->starved || scratch.starved;
    return found != DAMAGED;
}

bool ovr_container_values(ovr_container *c, const ovr_dataset *set,
                          uint64_t row, uint64_t count, double *values)
{
    const ovr_datatype *e = &set->element;
    bool inside = set->rank > 1
                      ? row < set->shape[0] && count == set->width
                      : row <= set->shape[0] && count <= set->shape[0] - row;
    if (!inside)
        return false;
    if (set->chunked)
        return chunks(&c->source, set, row, count, values);
    return plain(&c->source, e, set->at + row * set->width * e->size, count,
                 values);
}
