/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reads fractal heaps (FRHP, FHIB, FHDB), B-trees of version 2 (BTHD, BTIN,
 * BTLF) and global heaps (GCOL).
 *
 * Source: The HDF Group, HDF5 File Format Specification, Version 3.0, sections
 * III.A.2, III.E and III.G.
 */
#include "results/hdf5read/heap.h"

#include <string.h>

#include "base/disk.h"

/* --------------------------------------------------------------- checksum */

static uint32_t turn(uint32_t x, int bits)
{
    return x << bits | x >> (32 - bits);
}

static void mix(uint32_t w[3])
{
    static const int bits[] = {4, 6, 8, 16, 19, 4};
    for (int k = 0; k < 6; k++) {
        uint32_t *a = &w[k % 3], *b = &w[(k + 1) % 3], *c = &w[(k + 2) % 3];
        *a = (*a - *c) ^ turn(*c, bits[k]);
        *c += *b;
    }
}

static void finish(uint32_t w[3])
{
    static const int bits[] = {14, 11, 25, 16, 4, 14, 24};
    for (int k = 0; k < 7; k++) {
        uint32_t *to = &w[(k + 2) % 3], from = w[(k + 1) % 3];
        *to = (*to ^ from) - turn(from, bits[k]);
    }
}

static uint32_t word(const unsigned char *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 |
           (uint32_t)at[3] << 24;
}

static uint32_t checksum(const unsigned char *data, size_t size)
{
    uint32_t start = 0xdeadbeef + (uint32_t)size, w[3] = {start, start, start};
    unsigned char last[12] = {0};
    for (; size > sizeof last; size -= sizeof last, data += sizeof last) {
        for (size_t k = 0; k < 3; k++)
            w[k] += word(data + 4 * k);
        mix(w);
    }
    memcpy(last, data, size);
    for (size_t k = 0; k < 3; k++)
        w[k] += word(last + 4 * k);
    finish(w);
    return w[2];
}

/* True if the checksum of HDF5's metadata (lookup3 by Bob Jenkins, public
 * domain) is correct. Always true in builds for fuzzing, which would otherwise
 * not pass this check. */
static bool checksum_holds(const unsigned char *data, size_t size,
                           uint64_t found)
{
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
    (void)checksum(data, size);
    (void)found;
    return true;
#else
    return checksum(data, size) == found;
#endif
}

enum { ADDRESS = 8 };

/* ------------------------------------------------------------------- blocks */

uint64_t ovr_take(ovr_piece *b, size_t size)
{
    uint64_t value = 0;
    if (size > b->left) {
        b->good = false;
        b->left = 0;
    }
    if (!b->good)
        return 0;
    for (size_t k = size; k-- > 0;)
        value = value << 8 | b->at[k];
    b->at += size;
    b->left -= size;
    return value;
}

ovr_piece ovr_cut(ovr_piece *b, uint64_t size)
{
    ovr_piece piece = {b->at, (size_t)size, b->good && size <= b->left};
    if (!piece.good) {
        b->good = false;
        b->left = piece.left = 0;
        return piece;
    }
    b->at += piece.left;
    b->left -= piece.left;
    return piece;
}

/* True if far more bytes were read than the file has. A malicious file may
 * refer to the same bytes any number of times. */
static bool is_enough(const ovr_source *s)
{
    enum { BASE = 64 << 20, TIMES = 8 };
    size_t taken = s->arena->bytes;
    return taken > BASE && (taken - BASE) / TIMES > s->bytes;
}

bool ovr_load(ovr_source *s, uint64_t at, uint64_t size, ovr_piece *out)
{
    unsigned char *data;
    *out = (ovr_piece){NULL, 0, false};
    if (at > s->bytes || size > s->bytes - at || size > SIZE_MAX / 2 ||
        is_enough(s))
        return false;
    data = ovr_arena_take(s->arena, (size_t)size, 1, NULL);
    s->starved = s->starved || !data;
    if (!data || ovr_read_all(s->fd, data, (size_t)size, at) != 0)
        return false;
    *out = (ovr_piece){data, (size_t)size, true};
    return true;
}

/* Cache of blocks with correct checksums. The header of an object is read once
 * for each of its attributes. */
enum { KEPT_BLOCKS = 64 };
struct ovr_kept_block {
    uint64_t at;
    ovr_piece whole; /* empty: no block is cached here */
};

/* Returns the cache entry for an address; NULL if memory is insufficient. The
 * cache is freed with the arena. */
static struct ovr_kept_block *kept_place(ovr_source *s, uint64_t at)
{
    if (!s->kept || s->kept_since != s->arena->releases) {
        s->kept = ovr_arena_take(s->arena, KEPT_BLOCKS, sizeof *s->kept, NULL);
        s->kept_since = s->arena->releases;
    }
    /* Fibonacci hashing: the factor is 2^64 divided by the golden ratio. */
    return s->kept ? &s->kept[at * UINT64_C(0x9e3779b97f4a7c15) >> 58] : NULL;
}

enum { LETTERS = 4, SUM = 4 };

/* Loads a block including signature and checksum. */
static bool load_whole(ovr_source *s, uint64_t at, uint64_t size,
                       ovr_piece *whole)
{
    ovr_piece sum;
    if (size < LETTERS + SUM)
        return false;
    struct ovr_kept_block *place = kept_place(s, at);
    if (place && place->at == at && place->whole.left == size) {
        *whole = place->whole;
        return true;
    }
    if (!ovr_load(s, at, size, whole))
        return false;
    sum = (ovr_piece){whole->at + whole->left - SUM, SUM, true};
    if (!checksum_holds(whole->at, whole->left - SUM, ovr_take(&sum, SUM)))
        return false;
    if (place)
        *place = (struct ovr_kept_block){at, *whole};
    return true;
}

bool ovr_load_block(ovr_source *s, uint64_t at, uint64_t size,
                    const char *letters, ovr_piece *out)
{
    if (!load_whole(s, at, size, out) || memcmp(out->at, letters, LETTERS) != 0)
        return false;
    out->at += LETTERS;
    out->left -= LETTERS + SUM;
    return true;
}

/* ------------------------------------------------------------------ B-tree */

enum { ID_CAPACITY = 8, DEEPEST = 6, MAX_NODES = 1024 };

/* B-tree whose records contain identifiers of objects in a heap. */
typedef struct tree {
    ovr_source *source;
    size_t node, record;   /* size of a node and of a record in bytes */
    size_t id_at, id_size; /* offset and size of the identifier in a record */
    size_t count_size;     /* size of the record count of a node */
    size_t total_size[DEEPEST]; /* size of the total record count of a node and
                                   its descendants, by depth */
    unsigned char *id;          /* ID_CAPACITY bytes each */
    size_t count, maximum, nodes;
} tree;

/* Returns the number of bytes of integers up to `maximum`. */
static size_t bytes_for(uint64_t maximum)
{
    size_t bytes = 1;
    while (maximum >>= 8)
        bytes++;
    return bytes;
}

static size_t pointer_size(const tree *t, size_t depth)
{
    return ADDRESS + t->count_size + t->total_size[depth - 1];
}

static void find_sizes(tree *t)
{
    const size_t frame = 4 + 2 + 4; /* signature, version and type, checksum */
    uint64_t all = (t->node - frame) / t->record;
    t->count_size = bytes_for(all);
    t->total_size[0] = 0;
    for (size_t d = 1; d < DEEPEST; d++) {
        uint64_t pointer = pointer_size(t, d), maximum = 0;
        if (t->node > frame + pointer)
            maximum = (t->node - frame - pointer) / (t->record + pointer);
        all = (maximum + 1) * all + maximum;
        t->total_size[d] = bytes_for(all);
    }
}

/* Appends the identifiers in the records of a node, without those of its
 * children. */
static bool add_records(tree *t, ovr_piece *node, uint64_t count)
{
    for (uint64_t k = 0; k < count && node->good; k++) {
        ovr_piece record = ovr_cut(node, t->record);
        if (t->count == t->maximum || !record.good)
            return false;
        memcpy(t->id + ID_CAPACITY * t->count++, record.at + t->id_at,
               t->id_size);
    }
    return node->good;
}

static bool add_node(tree *t, uint64_t at, uint64_t count, size_t depth)
{
    size_t pointer = depth ? pointer_size(t, depth) : 0;
    uint64_t used = 10 + count * t->record + (depth ? count + 1 : 0) * pointer;
    ovr_piece node;
    bool good;
    if (++t->nodes > MAX_NODES || used > t->node ||
        !ovr_load_block(t->source, at, used, depth ? "BTIN" : "BTLF", &node))
        return false;
    ovr_take(&node, 2); /* version, kind */
    good = add_records(t, &node, count);
    for (uint64_t k = 0; good && depth && k <= count; k++) {
        uint64_t child = ovr_take(&node, ADDRESS);
        uint64_t records = ovr_take(&node, t->count_size);
        ovr_take(&node, t->total_size[depth - 1]);
        good = node.good && add_node(t, child, records, depth - 1);
    }
    return good;
}

/* Sets the record form: type 5 indexes links, type 8 attributes, both by a hash
 * of the name. Returns false for other forms. */
static bool find_form(tree *t, uint64_t kind)
{
    t->id_at = kind == 5 ? 4 : 0;
    t->id_size = kind == 5 ? 7 : 8;
    return t->node >= 64 && t->node <= 1 << 16 &&
           ((kind == 5 && t->record == 11) || (kind == 8 && t->record == 17));
}

static bool list(tree *t, uint64_t at)
{
    enum { HEADER = 38 };
    ovr_piece b;
    uint64_t kind, depth, root, count, all;
    if (!ovr_load_block(t->source, at, HEADER, "BTHD", &b))
        return false;
    ovr_take(&b, 1);
    kind = ovr_take(&b, 1);
    t->node = (size_t)ovr_take(&b, 4);
    t->record = (size_t)ovr_take(&b, 2);
    depth = ovr_take(&b, 2);
    ovr_take(&b, 2);
    root = ovr_take(&b, ADDRESS);
    count = ovr_take(&b, 2);
    all = ovr_take(&b, 8);
    if (!find_form(t, kind) || depth >= DEEPEST || all > OVR_MAX_ITEMS)
        return false;
    t->maximum = (size_t)all;
    t->id = ovr_arena_take(t->source->arena, t->maximum, ID_CAPACITY, NULL);
    t->source->starved = t->source->starved || !t->id;
    find_sizes(t);
    return t->id &&
           (root == OVR_NOWHERE || add_node(t, root, count, (size_t)depth));
}

/* ------------------------------------------------------------ fractal heap */

/* A fractal heap. Its doubling table has rows of `width` blocks of equal size.
 * The blocks of rows 0 and 1 have `start` bytes, and the size doubles with each
 * further row. Blocks larger than `largest` are indirect: tables of smaller
 * blocks. */
typedef struct heap {
    ovr_source *source;
    uint64_t at, width, start, largest, root, rows;
    size_t id_size, offset_size, length_size;
    bool summed;
    ovr_piece
        block; /* direct block read last, which starts at heap offset `from` */
    uint64_t from;
} heap;

static bool power_of_two(uint64_t n)
{
    return n && !(n & (n - 1));
}

static uint64_t log_two(uint64_t n)
{
    uint64_t log = 0;
    while (n >>= 1)
        log++;
    return log;
}

static bool open_heap(heap *h)
{
    enum { HEADER = 146 };
    ovr_piece b;
    uint64_t filters, flags, managed, bits;
    if (!ovr_load_block(h->source, h->at, HEADER, "FRHP", &b))
        return false;
    ovr_take(&b, 1);
    h->id_size = (size_t)ovr_take(&b, 2);
    filters = ovr_take(&b, 2);
    flags = ovr_take(&b, 1);
    managed = ovr_take(&b, 4);
    ovr_cut(&b, 96); /* huge and tiny objects, free space */
    h->width = ovr_take(&b, 2);
    h->start = ovr_take(&b, 8);
    h->largest = ovr_take(&b, 8);
    bits = ovr_take(&b, 2);
    ovr_take(&b, 2);
    h->root = ovr_take(&b, ADDRESS);
    h->rows = ovr_take(&b, 2);
    h->summed = flags & 2;
    h->offset_size = (size_t)(bits + 7) / 8;
    h->length_size = (size_t)(log_two(h->largest) + 7) / 8;
    if (bytes_for(managed) < h->length_size)
        h->length_size = bytes_for(managed);
    h->from = OVR_NOWHERE;
    return b.good && !filters && power_of_two(h->width) && h->width <= 64 &&
           power_of_two(h->start) && power_of_two(h->largest) &&
           h->start <= h->largest && h->largest <= 1u << 20 && bits <= 40 &&
           h->rows <= 40 && h->id_size <= ID_CAPACITY &&
           1 + h->offset_size + h->length_size <= h->id_size;
}

/* True if the checksum of the direct block is correct. Its field in the block's
 * header counts as zero. */
static bool direct_holds(heap *h, size_t at)
{
    ovr_piece sum = h->block;
    unsigned char *copy = ovr_arena_take(h->source->arena, h->block.left, 1,
                                         NULL);
    h->source->starved = h->source->starved || !copy;
    if (!copy)
        return false;
    memcpy(copy, h->block.at, h->block.left);
    memset(copy + at, 0, 4);
    ovr_cut(&sum, at);
    return checksum_holds(copy, h->block.left, ovr_take(&sum, 4));
}

static bool load_direct(heap *h, uint64_t at, uint64_t from, uint64_t size)
{
    ovr_piece b;
    uint64_t owner, offset;
    if (h->from == from)
        return true;
    h->from = OVR_NOWHERE;
    if (!ovr_load(h->source, at, size, &h->block) || size < 32 ||
        memcmp(h->block.at, "FHDB", 4) != 0)
        return false;
    b = h->block;
    ovr_take(&b, 5);
    owner = ovr_take(&b, ADDRESS);
    offset = ovr_take(&b, h->offset_size);
    if (owner != h->at || offset != from ||
        (h->summed && !direct_holds(h, 5 + ADDRESS + h->offset_size)))
        return false;
    h->from = from;
    return true;
}

/* Position of a heap offset in the doubling table. */
typedef struct place {
    uint64_t row, column, from, size;
} place;

static place place_of(const heap *h, uint64_t offset)
{
    place p = {0, 0, 0, h->start};
    uint64_t row_size = h->start * h->width;
    while (offset >= p.from + row_size) {
        p.from += row_size;
        if (p.row++ > 0) {
            p.size *= 2;
            row_size *= 2;
        }
    }
    p.column = (offset - p.from) / p.size;
    p.from += p.column * p.size;
    return p;
}

/* Reads the address of entry `number` of an indirect block. */
static bool find_child(const heap *h, uint64_t at, uint64_t rows,
                       uint64_t number, uint64_t *child)
{
    uint64_t entries = rows * h->width;
    ovr_piece b;
    if (rows > 40 || number >= entries ||
        !ovr_load_block(h->source, at,
                        4 + 1 + ADDRESS + h->offset_size + ADDRESS * entries +
                            4,
                        "FHIB", &b))
        return false;
    ovr_cut(&b, 1 + ADDRESS + h->offset_size + ADDRESS * number);
    *child = ovr_take(&b, ADDRESS);
    return b.good && *child != OVR_NOWHERE;
}

/* Loads the direct block that contains `offset`. */
static bool find_block(heap *h, uint64_t offset)
{
    uint64_t at = h->root, rows = h->rows, base = 0;
    if (rows == 0)
        return offset < h->start && load_direct(h, at, 0, h->start);
    for (;;) {
        place p = place_of(h, offset - base);
        if (p.row >= rows ||
            !find_child(h, at, rows, p.row * h->width + p.column, &at))
            return false;
        base += p.from;
        if (p.size <= h->largest)
            return load_direct(h, at, base, p.size);
        rows = log_two(p.size) - log_two(h->start * h->width) + 1;
    }
}

static bool find_object(heap *h, const unsigned char *id, ovr_piece *out)
{
    ovr_piece b = {id, h->id_size, true};
    uint64_t kind = ovr_take(&b, 1);
    uint64_t offset = ovr_take(&b, h->offset_size);
    uint64_t length = ovr_take(&b, h->length_size);
    if (kind != 0 || !find_block(h, offset)) /* managed objects only */
        return false;
    *out = h->block;
    ovr_cut(out, offset - h->from);
    *out = ovr_cut(out, length);
    return out->good;
}

bool ovr_heap_items(ovr_source *source, uint64_t at, uint64_t tree_at,
                    ovr_items *items)
{
    heap h = {.source = source, .at = at};
    tree t = {.source = source};
    items->count = 0;
    if (!list(&t, tree_at) || !open_heap(&h))
        return false;
    items->item = ovr_arena_take(source->arena, t.count, sizeof *items->item,
                                 NULL);
    source->starved = source->starved || !items->item;
    if (!items->item)
        return false;
    for (; items->count < t.count; items->count++)
        if (!find_object(&h, t.id + ID_CAPACITY * items->count,
                         &items->item[items->count]))
            return false;
    return true;
}

/* ------------------------------------------------------------- global heap */

bool ovr_heap_text(ovr_source *source, uint64_t at, uint64_t index,
                   ovr_piece *out)
{
    enum { HEADER = 16 };
    ovr_piece b;
    uint64_t size;
    if (!ovr_load(source, at, HEADER, &b) || memcmp(b.at, "GCOL", 4) != 0)
        return false;
    ovr_take(&b, 8);
    size = ovr_take(&b, 8);
    if (!ovr_load(source, at, size, &b))
        return false;
    ovr_cut(&b, HEADER);
    while (b.left >= HEADER && b.good) {
        uint64_t number = ovr_take(&b, 2);
        uint64_t length;
        ovr_take(&b, 6);
        length = ovr_take(&b, 8);
        if (number == 0) /* free space */
            return false;
        *out = ovr_cut(&b, length);
        if (number == index)
            return out->good;
        ovr_cut(&b, -length % 8);
    }
    return false;
}
