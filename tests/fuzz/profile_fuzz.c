/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: profile files of any format, including the recognition of the
 * format. */
#include "fuzz/profile.h"
#include "surface/profile.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ovr_profile_source source = fuzz_source(data, size);
    ovr_error err;
    ovr_profile *p = ovr_profile_parse(&source, data, size, NULL, &err);
    if (p)
        fuzz_use(p);
    ovr_profile_free(p);
    return 0;
}
