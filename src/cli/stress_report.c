/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/stress_report.h"

void cli_json_lengths(json_writer *json,
                      const ovr_stress_report *const report[2])
{
    const ovr_stress_report *a = report[0], *b = report[1], *r = a ? a : b;
    if (a && b && b->R_max > a->R_max)
        r = b;
    if (!r || !r->fatigue)
        return;
    json_open_array(json, "equivalent_lengths");
    for (size_t j = 0; j < r->material.depths; j++) {
        json_open(json, NULL);
        json_number(json, "depth", r->material.z[j]);
        json_number(json, "equivalent_length", r->length[j]);
        json_close(json);
    }
    json_close_array(json);
}
