/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads superblock, object headers, links and attributes. */

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "results/hdf5read/elements.h"

/* Types of messages in an object's header. */
enum { LINK_INFO = 0x02, CONTINUATION = 0x10, ATTRIBUTE_INFO = 0x15 };

/* -------------------------------------------------------------- superblock */

static const char signature[8] = "\211HDF\r\n\032\n";

/* Parses version and sizes of the superblock. Version 0 has more fields and no
 * checksum, and the address of the root group is last. */
static bool read_form(ovr_source *source, ovr_piece *b, size_t size)
{
    bool first = b->at[sizeof signature] == 0;
    uint64_t version, address, length;
    if (first && !ovr_load(source, 0, size, b))
        return false;
    ovr_cut(b, sizeof signature);
    version = ovr_take(b, 1);
    ovr_cut(b, first ? 4 : 0);
    address = ovr_take(b, 1);
    length = ovr_take(b, 1);
    ovr_cut(b, first ? 9 : 1);
    return (first || version == 2 || version == 3) && address == 8 &&
           length == 8;
}

/* Reads a superblock with addresses and lengths of 8 bytes and without a user
 * block. */
static ovr_found read_superblock(ovr_container *c)
{
    enum { SIZE = 48, SIZE_0 = 72 };
    ovr_piece b, whole;
    uint64_t end;
    bool checked;
    if (!ovr_load(&c->source, 0, sizeof signature, &b) ||
        memcmp(b.at, signature, sizeof signature) != 0)
        return OVR_FOUND_NO_HDF5;
    if (!ovr_load(&c->source, 0, SIZE, &b))
        return OVR_FOUND_TRUNCATED;
    checked = b.at[sizeof signature] != 0;
    if (!read_form(&c->source, &b, SIZE_0) || ovr_take(&b, 8) != 0)
        return OVR_FOUND_OTHER_HDF5;
    ovr_take(&b, 8);
    end = ovr_take(&b, 8);
    ovr_cut(&b, checked ? 0 : 16);
    c->root = ovr_take(&b, 8);
    if (end > c->source.bytes || !b.good ||
        (checked && !ovr_load_block(&c->source, 0, SIZE, "\211HDF", &whole)))
        return OVR_FOUND_TRUNCATED;
    c->source.bytes = end;
    return OVR_FOUND_CONTAINER;
}

ovr_found ovr_container_open(ovr_container *c, int fd, ovr_arena *arena)
{
    struct stat about;
    ovr_found found;
    memset(c, 0, sizeof *c);
    if (fstat(fd, &about) != 0 || about.st_size < 0)
        return OVR_FOUND_NO_HDF5;
    c->source = (ovr_source){
        .fd = fd, .bytes = (uint64_t)about.st_size, .arena = arena};
    found = read_superblock(c);
    return c->source.starved ? OVR_FOUND_NO_MEMORY : found;
}

/* ------------------------------------------------------- headers of objects */

enum { MAX_BLOCKS = 32 };

/* Iterator over the messages of a header and its continuation blocks. */
typedef struct header {
    ovr_source *source;
    ovr_piece block;
    bool first;   /* version 1: no signature, no checksum */
    bool ordered; /* messages have creation order numbers */
    size_t order; /* creation order of the last message */
    bool damaged;
    uint64_t at[MAX_BLOCKS], size[MAX_BLOCKS];
    size_t blocks, read;
} header;

/* Opens a header of version 1: version, reserved byte, number of messages,
 * reference count, size. */
static void open_first(header *h, uint64_t at)
{
    enum { PREFIX = 16 };
    ovr_piece b;
    h->first = ovr_load(h->source, at, PREFIX, &b) && b.at[0] == 1;
    ovr_cut(&b, 8);
    h->damaged = !h->first ||
                 !ovr_load(h->source, at + PREFIX, ovr_take(&b, 4), &h->block);
}

/* Opens a header: signature, version, flags, optional fields, size of the first
 * block. */
static void open_header(header *h, ovr_source *source, uint64_t at)
{
    enum { MIN = 6, MAX = MIN + 16 + 4 + 8 };
    ovr_piece b;
    uint64_t left = at < source->bytes ? source->bytes - at : 0, flags, size;
    size_t prefix;
    *h = (header){.source = source, .damaged = true};
    if (!ovr_load(source, at, left < MAX ? left : MAX, &b) || b.left < MIN ||
        memcmp(b.at, "OHDR\2", 5) != 0) {
        open_first(h, at);
        return;
    }
    ovr_cut(&b, 5);
    flags = ovr_take(&b, 1);
    prefix = MIN + (flags & 0x20 ? 16u : 0u) + (flags & 0x10 ? 4u : 0u);
    ovr_cut(&b, prefix - MIN);
    size = ovr_take(&b, (size_t)1 << (flags & 3));
    prefix += (size_t)1 << (flags & 3);
    if (!b.good || size > source->bytes ||
        !ovr_load_block(source, at, prefix + size + 4, "OHDR", &h->block))
        return;
    ovr_cut(&h->block, prefix - 4);
    h->ordered = flags & 0x04;
    h->damaged = false;
}

static bool next_block(header *h)
{
    if (h->read == h->blocks)
        return false;
    h->damaged = h->first
                     ? !ovr_load(h->source, h->at[h->read], h->size[h->read],
                                 &h->block)
                     : !ovr_load_block(h->source, h->at[h->read],
                                       h->size[h->read], "OCHK", &h->block);
    h->read++;
    return !h->damaged;
}

static void note_block(header *h, ovr_piece message)
{
    uint64_t at = ovr_take(&message, 8), size = ovr_take(&message, 8);
    h->damaged = !message.good || h->blocks == MAX_BLOCKS;
    if (h->damaged)
        return;
    h->at[h->blocks] = at;
    h->size[h->blocks++] = size;
}

/* Reads the next message; false at the end or if the header is damaged. Shared
 * messages, which the writer does not use, count as damage. */
static bool next_message(header *h, unsigned *kind, ovr_piece *body)
{
    size_t minimum = h->first ? 8 : h->ordered ? 6 : 4;
    while (!h->damaged && (h->block.left >= minimum || next_block(h))) {
        uint64_t size, flags;
        if (h->block.left < minimum)
            continue;
        *kind = (unsigned)ovr_take(&h->block, h->first ? 2 : 1);
        size = ovr_take(&h->block, 2);
        flags = ovr_take(&h->block, 1);
        h->order = (size_t)ovr_take(&h->block, minimum - (h->first ? 5 : 4));
        *body = ovr_cut(&h->block, size);
        h->damaged = !body->good || flags & 0x02;
        if (!h->damaged && *kind == CONTINUATION)
            note_block(h, *body);
        else
            return !h->damaged;
    }
    return false;
}

bool ovr_object_message(ovr_source *source, uint64_t object, unsigned target,
                        ovr_piece *body)
{
    header h;
    unsigned kind;
    open_header(&h, source, object);
    while (next_message(&h, &kind, body))
        if (kind == target)
            return true;
    return false;
}

/* ------------------------------------------------------------------- links
 */

/* Reads items from a heap, given the message with the addresses of heap and
 * index. */
static bool stored_apart(ovr_source *source, unsigned kind, ovr_piece info,
                         ovr_items *items)
{
    uint64_t flags, heap, tree;
    ovr_take(&info, 1);
    flags = ovr_take(&info, 1);
    if (flags & 1)
        ovr_take(&info, kind == LINK_INFO ? 8 : 2);
    heap = ovr_take(&info, 8);
    tree = ovr_take(&info, 8);
    items->count = 0;
    if (!info.good)
        return false;
    return heap == OVR_NOWHERE || ovr_heap_items(source, heap, tree, items);
}

static size_t count_messages(ovr_source *source, uint64_t object,
                             unsigned target)
{
    header h;
    unsigned kind;
    ovr_piece body;
    size_t count = 0;
    open_header(&h, source, object);
    while (next_message(&h, &kind, &body))
        count += kind == target;
    return count;
}

bool ovr_object_items(ovr_source *source, uint64_t object, unsigned target,
                      ovr_items *items)
{
    unsigned info = target == OVR_ITEM_LINK ? LINK_INFO : ATTRIBUTE_INFO, kind;
    size_t capacity = count_messages(source, object, target), count = 0;
    ovr_items apart = {NULL, NULL, 0};
    ovr_piece body;
    header h;
    items->item = ovr_arena_take(source->arena, capacity, sizeof body, NULL);
    items->order = ovr_arena_take(source->arena, capacity, sizeof capacity,
                                  NULL);
    source->starved = source->starved || !items->item || !items->order;
    if (!items->item || !items->order)
        return false;
    open_header(&h, source, object);
    while (next_message(&h, &kind, &body))
        if (kind == target && count < capacity) {
            items->order[count] = h.ordered ? h.order : count;
            items->item[count++] = body;
        } else if (kind == info && !stored_apart(source, info, body, &apart))
            return false;
    items->count = count;
    if (count == 0)
        *items = apart;
    return !h.damaged;
}

bool ovr_plain_name(const unsigned char *name, size_t length)
{
    for (size_t k = 0; k < length; k++)
        if (!(name[k] == '_' || (name[k] >= '0' && name[k] <= '9') ||
              (name[k] >= 'A' && name[k] <= 'Z') ||
              (name[k] >= 'a' && name[k] <= 'z')))
            return false;
    return length > 0;
}

/* True for a hard link with a plain name. */
static bool read_link(ovr_piece b, ovr_link *link)
{
    uint64_t version = ovr_take(&b, 1), flags = ovr_take(&b, 1), length;
    uint64_t kind = flags & 0x08 ? ovr_take(&b, 1) : 0;
    ovr_piece name;
    link->order = flags & 0x04 ? ovr_take(&b, 8) : 0;
    ovr_take(&b, flags & 0x10 ? 1 : 0);
    length = ovr_take(&b, (size_t)1 << (flags & 3));
    name = ovr_cut(&b, length);
    link->object = ovr_take(&b, 8);
    if (version != 1 || kind != 0 || !b.good || length == 0 ||
        length >= sizeof link->name)
        return false;
    if (!ovr_plain_name(name.at, length))
        return false;
    memcpy(link->name, name.at, length);
    link->name[length] = '\0';
    return true;
}

bool ovr_container_find(ovr_container *c, uint64_t group, const char *name,
                        uint64_t *object)
{
    ovr_items items;
    ovr_link link;
    if (!ovr_object_items(&c->source, group, OVR_ITEM_LINK, &items))
        return false;
    for (size_t k = 0; k < items.count; k++)
        if (read_link(items.item[k], &link) && strcmp(link.name, name) == 0) {
            *object = link.object;
            return true;
        }
    return false;
}

static int by_order(const void *a, const void *b)
{
    const ovr_link *first = a, *second = b;
    return (first->order > second->order) - (first->order < second->order);
}

ovr_link *ovr_container_links(ovr_container *c, uint64_t group, size_t *count)
{
    ovr_items items;
    ovr_link *links;
    *count = 0;
    if (!ovr_object_items(&c->source, group, OVR_ITEM_LINK, &items))
        return NULL;
    links = ovr_arena_take(c->source.arena, items.count, sizeof *links, NULL);
    c->source.starved = c->source.starved || !links;
    for (size_t k = 0; links && k < items.count; k++)
        *count += read_link(items.item[k], &links[*count]);
    if (links)
        qsort(links, *count, sizeof *links, by_order);
    return links;
}
