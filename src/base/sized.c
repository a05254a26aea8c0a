/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/sized.h"

#include <string.h>

/* No struct is as long: one was never set. */
enum { SIZE_LARGEST = 1 << 16 };

static size_t size_of(const void *any)
{
    size_t size;
    memcpy(&size, any, sizeof size);
    return size;
}

void ovr_sized_fill(void *to, const void *defaults, size_t size)
{
    if (!to)
        return;
    size_t known = size_of(to);
    memset(to, 0, known);
    memcpy(to, defaults, known < size ? known : size);
    memcpy(to, &known, sizeof known);
}

const void *ovr_sized_whole(void *to, size_t size, const void *from)
{
    size_t known = from ? size_of(from) : 0;
    if (known == size)
        return from;
    if (known < sizeof known || known > size)
        return NULL;
    memcpy(to, from, known);
    memcpy(to, &size, sizeof size);
    return to;
}

ovr_status ovr_sized_check(const void *to, const char *name, ovr_error *err)
{
    size_t known = to ? size_of(to) : 0;
    if (!to)
        return ovr_fail(err, OVR_BAD_INPUT, "no %s to fill is given", name);
    if (known >= sizeof known && known < SIZE_LARGEST)
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s has size %zu: it must be set to that of the struct",
                    name, known);
}

void ovr_sized_give(void *to, void *made, size_t size)
{
    if (!to)
        return;
    size_t known = size_of(to);
    if (known > size) {
        memset((char *)to + size, 0, known - size);
        known = size;
    }
    memcpy(made, &known, sizeof known);
    memcpy(to, made, known);
}

ovr_status ovr_sized_take(void *to, size_t size, const void *from,
                          const char *name, ovr_error *err)
{
    if (!from)
        return ovr_fail(err, OVR_BAD_INPUT, "no %s is given", name);
    size_t known = size_of(from);
    if (known < sizeof known || known > size)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s has size %zu where this library knows %zu: it "
                        "must begin as %s_default() gives it",
                        name, known, size, name);
    memcpy(to, from, known);
    memcpy(to, &size, sizeof size);
    return OVR_OK;
}
