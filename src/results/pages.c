/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/pages.h"

#include <string.h>

enum { FIRST_CAPACITY = 16 };

void ovr_pages_init(ovr_pages *p, ovr_arena *arena)
{
    memset(p, 0, sizeof *p);
    p->arena = arena;
}

/* Place of the first page whose number is not smaller. */
static size_t place_of(const ovr_pages *p, uint64_t number)
{
    size_t low = 0, high = p->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (p->page[middle].number < number)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

ovr_page *ovr_pages_find(const ovr_pages *p, uint64_t number)
{
    size_t at = place_of(p, number);
    if (at < p->count && p->page[at].number == number)
        return &p->page[at];
    return NULL;
}

/* Twice the list, and as many new pages in one piece. */
static bool reserve(ovr_pages *p)
{
    size_t more = p->capacity ? p->capacity : FIRST_CAPACITY;
    ovr_page *list = ovr_arena_take(p->arena, p->capacity + more, sizeof *list,
                                    NULL);
    bool blank = p->arena->blank;
    p->arena->blank = true; /* pages are read from the file, not cleared */
    unsigned char *data = ovr_arena_take(p->arena, 2 * more, OVR_PAGE, NULL);
    p->arena->blank = blank;
    if (!list || !data)
        return false;
    if (p->capacity)
        memcpy(list, p->page, p->capacity * sizeof *list);
    for (size_t k = 0; k < more; k++) {
        list[p->capacity + k].data = data + 2 * k * OVR_PAGE;
        list[p->capacity + k].was = data + (2 * k + 1) * OVR_PAGE;
    }
    p->page = list;
    p->capacity += more;
    return true;
}

ovr_page *ovr_pages_add(ovr_pages *p, uint64_t number)
{
    size_t at = place_of(p, number);
    ovr_page added;
    if (p->count == p->capacity && !reserve(p))
        return NULL;
    added = p->page[p->count];
    added.number = number;
    memmove(&p->page[at + 1], &p->page[at], (p->count - at) * sizeof added);
    p->page[at] = added;
    p->count++;
    return &p->page[at];
}

void ovr_pages_clear(ovr_pages *p)
{
    p->count = 0;
}
