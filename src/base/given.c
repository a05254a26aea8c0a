/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/given.h"

#include <string.h>

ovr_status ovr_given(void *to, size_t size, const void *from, const char *name,
                     ovr_error *err)
{
    if (!from)
        return ovr_fail(err, OVR_BAD_INPUT, "no %s is given", name);
    memcpy(to, from, size);
    return OVR_OK;
}

ovr_status ovr_fillable(const void *to, const char *name, ovr_error *err)
{
    return to ? OVR_OK
              : ovr_fail(err, OVR_BAD_INPUT, "no %s to fill is given", name);
}
