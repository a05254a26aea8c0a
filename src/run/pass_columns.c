/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/pass_columns.h"

#include <stdio.h>
#include <string.h>

static const ovr_pass_column beside[OVR_PASS_BESIDE] = {
    [OVR_PASS_LOST] = {"oil_lost",
                       "of the outflow, what does not come to the next pass",
                       OVR_KIND_FLOW, NULL, 0},
    [OVR_PASS_STEPS] = {"steps", "time steps", OVR_KIND_COUNT, NULL, 0},
    [OVR_PASS_FILM_ERROR] =
        {"central_film_thickness_error",
         "estimated error of discretization of the mean central film",
         OVR_KIND_HEIGHT, NULL, 0},
    [OVR_PASS_MIN_ERROR] =
        {"min_film_thickness_error",
         "estimated error of discretization of the smallest film",
         OVR_KIND_HEIGHT, NULL, 0},
    [OVR_PASS_PRESSURE_ERROR] =
        {"max_pressure_error",
         "estimated error of discretization of the largest pressure",
         OVR_KIND_PRESSURE, NULL, 0},
    [OVR_PASS_MENISCUS_ERROR] =
        {"meniscus_error", "estimated error of discretization of the meniscus",
         OVR_KIND_LENGTH, NULL, 0},
    [OVR_PASS_LENGTH] = {"equivalent_length",
                         "length of smooth raceway with the risk that is added",
                         OVR_KIND_LENGTH, NULL, 0},
    [OVR_PASS_RISK] = {"risk_smooth", "risk of a length of smooth raceway",
                       OVR_KIND_NUMBER, NULL, 0},
    [OVR_PASS_RATIO] = {"life_ratio",
                        "life over that of the smooth raceway, of passes like "
                        "this one alone",
                        OVR_KIND_NUMBER, NULL, 0},
    [OVR_PASS_TOGETHER] = {"life_ratio_together",
                           "the same of all passes up to this one, again and "
                           "again",
                           OVR_KIND_NUMBER, NULL, 0}};

/* A mean, or the value at the end, has the name of the quantity, and so has
 * what is alone. */
static void name(const ovr_observable *row, unsigned how, ovr_pass_column *to)
{
    bool second = row->pass & OVR_PASS_MEAN;
    const char *before = "", *behind = "mean over the pass";
    if (how == OVR_PASS_SMALLEST) {
        before = second ? "least_" : "";
        behind = "smallest of the pass";
    } else if (how == OVR_PASS_LARGEST) {
        before = second ? "largest_" : "";
        behind = "largest of the pass";
    } else if (how == OVR_PASS_END)
        behind = "at the end of the pass";
    snprintf(to->name, sizeof to->name, "%s%s", before, row->name);
    snprintf(to->long_name, sizeof to->long_name, "%s, %s", row->long_name,
             behind);
}

bool ovr_pass_column_at(size_t k, ovr_pass_column *to)
{
    const ovr_observable *row;
    if (k < OVR_PASS_BESIDE) {
        *to = beside[k];
        return true;
    }
    k -= OVR_PASS_BESIDE;
    for (size_t r = 0; (row = ovr_observable_at(r)); r++)
        for (unsigned how = OVR_PASS_MEAN; how <= OVR_PASS_END; how *= 2)
            if (row->pass & how && k-- == 0) {
                *to = (ovr_pass_column){
                    .kind = row->kind, .of = row, .how = how};
                name(row, how, to);
                return true;
            }
    return false;
}

size_t ovr_pass_column_named(const char *name)
{
    ovr_pass_column c;
    size_t k = 0;
    while (ovr_pass_column_at(k, &c) && strcmp(c.name, name) != 0)
        k++;
    return k;
}
