/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages of a file that were changed but not yet written: page number, content
 * and what the file has there until then, sorted by number. */
#ifndef OVR_RESULTS_PAGES_H
#define OVR_RESULTS_PAGES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

enum { OVR_PAGE = 4096 };

typedef struct ovr_page {
    uint64_t number;
    unsigned char *data, *was;
} ovr_page;

typedef struct ovr_pages {
    ovr_page *page; /* `count` in use; those behind keep their memory */
    size_t count, capacity;
    ovr_arena *arena;
} ovr_pages;

void ovr_pages_init(ovr_pages *pages, ovr_arena *arena);

/* The page of this number, or NULL. */
ovr_page *ovr_pages_find(const ovr_pages *pages, uint64_t number);

/* A new page of this number, its content undefined; NULL without memory. */
ovr_page *ovr_pages_add(ovr_pages *pages, uint64_t number);

/* Forgets all pages, keeping their memory for the next ones. */
void ovr_pages_clear(ovr_pages *pages);

#endif
