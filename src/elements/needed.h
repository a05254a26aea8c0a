/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of a form that an element cannot do without. */
#ifndef OVR_ELEMENTS_NEEDED_H
#define OVR_ELEMENTS_NEEDED_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/error.h"

typedef struct ovr_needed {
    const char *about; /* the member of the form */
    double value;
    bool zero; /* may be zero */
} ovr_needed;

/* The first of `count` numbers that is not finite, or not positive. */
ovr_status ovr_check_needed(const ovr_needed *all, size_t count,
                            ovr_error *err);

#endif
