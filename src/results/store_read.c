/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reading from a store: the file, and over it the pages that are changed. */
#include <string.h>

#include "base/disk.h"
#include "results/store.h"

static uint64_t minimum(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

bool ovr_store_note(ovr_store *s, int error)
{
    if (error && !s->failed)
        s->failed = error;
    return error == 0;
}

uint64_t ovr_store_guarded(const ovr_store *s)
{
    return s->failed ? UINT64_MAX : s->committed;
}

size_t ovr_in_page(uint64_t at, uint64_t bytes)
{
    return (size_t)minimum(bytes, OVR_PAGE - at % OVR_PAGE);
}

bool ovr_store_read(ovr_store *s, uint64_t at, size_t bytes, void *to)
{
    unsigned char *next = to;
    if (!ovr_store_note(s, ovr_read_all(s->fd, to, bytes, at)))
        return false;
    while (bytes > 0) {
        size_t n = ovr_in_page(at, bytes);
        const ovr_page *page = ovr_pages_find(&s->changed, at / OVR_PAGE);
        uint64_t guard = ovr_store_guarded(s);
        if (page && at < guard)
            memcpy(next, page->data + at % OVR_PAGE,
                   (size_t)minimum(n, guard - at));
        at += n;
        next += n;
        bytes -= n;
    }
    return true;
}
