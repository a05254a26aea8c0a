/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourth order over 80 random contacts, M 5 to 1000 (logarithmic), L 1 to 16,
 * levels 8 and 9 on [-4, 1.5]: all that are not too thin for the mesh converge,
 * and at most 2 % of them (two cases, of 160) by falling back to second order.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../support/contact.h"
#include "../support/steady.h"
#include "../support/test.h"

enum { CASES = 80, SEED = 20261122 };

static void random_contacts(void **state)
{
    uint64_t seed = SEED;
    int solved = 0, fallen = 0, thin = 0;
    (void)state;
    printf("seed %d\n", SEED);
    for (int k = 0; k < CASES; k++) {
        double M = 5 * pow(200, test_random(&seed, 0, 1));
        double L = test_random(&seed, 1, 16);
        for (int level = 8; level < 10; level++) {
            ovr_options o = test_options();
            o.order = 4;
            o.level = level;
            test_solution s = test_steady(M, L, &o);
            bool too_thin = s.status && strstr(s.message, "too thin");
            if (s.status || s.o.order != 4)
                printf("M = %g, L = %g, level %d: %s\n", M, L, level,
                       s.status ? s.message : "second order");
            assert_true(s.status == OVR_OK || too_thin);
            thin += too_thin;
            solved += s.status == OVR_OK;
            fallen += s.status == OVR_OK && s.o.order != 4;
        }
    }
    printf("%d solved, %d by falling back, %d too thin for the mesh\n", solved,
           fallen, thin);
    assert_true(50 * fallen <= solved);
    assert_true(thin <= 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_contacts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
