/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/copied.h"

#include <stdlib.h>
#include <string.h>

#include "simulation/simulation.h"
#include "support/test.h"

typedef struct pieces {
    char *at[256];
    size_t bytes[256], count;
    bool write;
} pieces;

static ovr_status visit(void *context, const char *name, void *memory,
                        size_t bytes, ovr_error *err)
{
    pieces *p = context;
    size_t k = p->count++;
    (void)name, (void)err;
    assert_true(k < sizeof p->at / sizeof *p->at);
    if (p->write) {
        assert_int_equal(bytes, p->bytes[k]);
        memcpy(memory, p->at[k], bytes);
        free(p->at[k]);
    } else {
        p->at[k] = malloc(bytes);
        assert_non_null(p->at[k]);
        p->bytes[k] = bytes;
        memcpy(p->at[k], memory, bytes);
    }
    return OVR_OK;
}

void test_copy_state(ovr_simulation *from, ovr_simulation *to)
{
    pieces p = {.count = 0};
    assert_int_equal(ovr_simulation_visit(from, visit, &p, NULL), OVR_OK);
    p.count = 0;
    p.write = true;
    assert_int_equal(ovr_simulation_visit(to, visit, &p, NULL), OVR_OK);
    ovr_simulation_restored(to);
}
