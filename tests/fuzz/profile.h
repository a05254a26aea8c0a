/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Common part of the fuzz targets of profile readers. */
#ifndef TESTS_FUZZ_PROFILE_H
#define TESTS_FUZZ_PROFILE_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/overroll.h"
#include "surface/profile.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Selects the arguments of the reader by the last byte. */
static inline ovr_profile_source fuzz_source(const uint8_t *data, size_t size)
{
    ovr_profile_source source = ovr_profile_source_default();
    unsigned flags = size ? data[size - 1] : 0;
    source.file = "fuzz";
    if (flags & 1)
        source.unit_x = "um", source.unit_z = "nm";
    if (flags & 2)
        source.spacing = 1e-6;
    if (flags & 4)
        source.column_x = 1, source.column_z = 2;
    if (flags & 16)
        source.row = (int)(flags >> 5);
    return source;
}

static inline void fuzz_fail_unless(int good)
{
    if (!good)
        abort();
}

/* Points increase, notes end, and what follows reading bears them. */
static inline void fuzz_use(ovr_profile *p)
{
    const ovr_profile_view *v = ovr_profile_get_view(p);
    ovr_conditioning how = ovr_conditioning_default();
    ovr_profile_numbers numbers;
    ovr_profile_wave wave[3];
    ovr_error err;
    size_t found;
    fuzz_fail_unless(v->n >= 2 && strlen(v->notes) < OVR_NOTES_SIZE);
    for (size_t i = 0; i < v->n; i++)
        fuzz_fail_unless(isfinite(v->x[i]) && !isinf(v->z[i]) &&
                         (!i || v->x[i] > v->x[i - 1]));
    if (v->n > 2000 || ovr_profile_condition(p, &how, &err) ||
        ovr_profile_measure(p, &numbers, &err))
        return;
    fuzz_fail_unless(!isnan(numbers.a));
    (void)ovr_profile_waves(p, 3, wave, &found, &err);
}

static inline int fuzz_reader(ovr_reader *reader, const uint8_t *data,
                              size_t size)
{
    ovr_profile_source source = fuzz_source(data, size);
    ovr_error err;
    ovr_profile *p = ovr_profile_new("fuzz", NULL, &err);
    ovr_bytes content = {(const char *)data, size};
    if (!p || !size) {
        ovr_profile_free(p);
        return 0;
    }
    if (!reader(p, &source, content, &err))
        fuzz_use(p);
    else
        fuzz_fail_unless(!strchr(err.message, '\n') && *err.message);
    ovr_profile_free(p);
    return 0;
}

#endif
