/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/test.h"

#include <stdlib.h>
#include <string.h>

static void *allocate(void *context, size_t bytes)
{
    test_faults *faults = context;
    void *memory;
    faults->calls++;
    if (faults->fail && (faults->onward ? faults->calls >= faults->fail
                                        : faults->calls == faults->fail))
        return NULL;
    memory = malloc(bytes ? bytes : 1);
    if (!memory)
        return NULL;
    faults->live++;
    faults->bytes += (double)bytes;
    return memset(memory, 0xA5, bytes);
}

static void release(void *context, void *memory)
{
    test_faults *faults = context;
    if (memory)
        faults->live--;
    free(memory);
}

void test_faults_init(test_faults *faults)
{
    *faults = (test_faults){.hook = {allocate, release, faults}};
}

long test_every_allocation(test_attempt *attempt, void *data)
{
    test_faults faults;
    long k = 0;
    do {
        ovr_error err = {0};
        ovr_status status;
        test_faults_init(&faults);
        faults.fail = ++k;
        status = attempt(data, &faults.hook, &err);
        if (faults.live != 0)
            fail_msg("allocation %ld failed: %ld pieces left", k, faults.live);
        if (faults.calls < k) {
            CHECK_OK(status, &err);
        } else {
            CHECK_STATUS(status, OVR_NO_MEMORY, &err);
            CHECK_ERROR(&err, OVR_NO_MEMORY, "memory");
        }
    } while (faults.calls >= k);
    return faults.calls;
}
