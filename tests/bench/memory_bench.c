/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory per node of the finest grid: bytes that a simulation allocates for all
 * levels when it is created. It allocates nothing later. The value is the same
 * for steady solutions and runs. */
#include <stdio.h>

#include "bench.h"
#include "support/contact.h"
#include "support/test.h"

static double bytes_a_node(int level, ovr_scheme scheme, ovr_smoother smoother)
{
    ovr_error err = {0};
    test_faults hook;
    ovr_options options = test_options();
    test_contact t = test_contact_make(20, 10);
    options.level = level;
    options.scheme = scheme;
    options.smoother = smoother;
    test_faults_init(&hook);
    ovr_simulation *sim = ovr_simulation_create(&t.contact, &t.lubricant,
                                                &options, &hook.hook, &err);
    CHECK_OK(err.status, &err);
    double n = (double)ovr_simulation_state(sim)->n;
    ovr_simulation_free(sim);
    return hook.bytes / n;
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("\nbytes per node, steady or transient\n%5s %10s %12s %16s %10s\n",
           "level", "nodes", "upstream", "characteristic", "hybrid");
    bench_list("memory");
    for (int level = 6; level <= 14; level++) {
        double line = bytes_a_node(level, OVR_UPSTREAM2, OVR_LINE);
        double departures = bytes_a_node(level, OVR_CHARACTERISTIC, OVR_LINE);
        double hybrid = bytes_a_node(level, OVR_UPSTREAM2, OVR_HYBRID);
        printf("%5d %10d %12.0f %16.0f %10.0f\n", level, (7 << level) + 1, line,
               departures, hybrid);
        bench_row();
        bench_number("level", level);
        bench_number("upstream", line);
        bench_number("characteristic", departures);
        bench_number("hybrid", hybrid);
        bench_end();
    }
    bench_end();
    bench_close();
    return 0;
}
