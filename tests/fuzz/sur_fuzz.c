/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/profile.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    return fuzz_reader(ovr_read_sur, data, size);
}
