/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/pass_columns.h"

#include <stdio.h>
#include <string.h>

static const ovr_pass_column beside[OVR_PASS_BESIDE] = {
    [OVR_PASS_LOST] =
        {.name = "oil_lost",
         .long_name = "of the outflow, what does not come to the next pass",
         .kind = OVR_KIND_FLOW,
         .place = 5,
         .head = "lost"},
    [OVR_PASS_STEPS] = {.name = "steps",
                        .long_name = "time steps",
                        .kind = OVR_KIND_COUNT},
    [OVR_PASS_FILM_ERROR] =
        {.name = "central_film_thickness_error",
         .long_name =
             "estimated error of discretization of the mean central film",
         .kind = OVR_KIND_HEIGHT},
    [OVR_PASS_MIN_ERROR] =
        {.name = "min_film_thickness_error",
         .long_name = "estimated error of discretization of the smallest film",
         .kind = OVR_KIND_HEIGHT},
    [OVR_PASS_PRESSURE_ERROR] =
        {.name = "max_pressure_error",
         .long_name =
             "estimated error of discretization of the largest pressure",
         .kind = OVR_KIND_PRESSURE},
    [OVR_PASS_MENISCUS_ERROR] =
        {.name = "meniscus_error",
         .long_name = "estimated error of discretization of the meniscus",
         .kind = OVR_KIND_LENGTH},
    [OVR_PASS_LENGTH] =
        {.name = "equivalent_length",
         .long_name = "length of smooth raceway with the risk that is added",
         .kind = OVR_KIND_LENGTH,
         .place = 11,
         .head = "length",
         .with = OVR_PHYSICS_PLASTIC},
    [OVR_PASS_RISK] = {.name = "risk_smooth",
                       .long_name = "risk of a length of smooth raceway",
                       .kind = OVR_KIND_NUMBER},
    [OVR_PASS_RATIO] =
        {.name = "life_ratio",
         .long_name = "life over that of the smooth raceway, of passes like "
                      "this one alone",
         .kind = OVR_KIND_NUMBER},
    [OVR_PASS_TOGETHER] = {
        .name = "life_ratio_together",
        .long_name = "the same of all passes up to this one, again and "
                     "again",
        .kind = OVR_KIND_NUMBER}};

/* A mean, or the value at the end, has the name of the quantity, and so has
 * what is alone; the same holds for the head. */
static void name(const ovr_observable *row, unsigned how, ovr_pass_column *to)
{
    bool second = row->pass & OVR_PASS_MEAN;
    const char *before = "", *behind = "mean over the pass";
    to->place = row->pass_place;
    to->head = row->pass_head;
    to->with = row->pass_with;
    if (how == OVR_PASS_SMALLEST) {
        before = second ? "least_" : "";
        to->head = second ? "least" : to->head;
        behind = "smallest of the pass";
    } else if (how == OVR_PASS_LARGEST) {
        before = second ? "largest_" : "";
        to->head = second ? "largest" : to->head;
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
