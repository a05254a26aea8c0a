/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A table row that defines a quantity with all its names and labels. For
 * example,
 *
 *     OVR_NUMBER_ROW("max_pressure", "P_max", "max_pressure_Pa", PRESSURE,
 *                    P_max, 0, "maximum pressure",
 *                    LABEL("maximum pressure"), PLACE(X_P_max),
 *                    LARGEST("P_max_overall"),
 *                    EXTREME_REPORTED, PASS(LARGEST))
 *
 * defines a column of the history, two JSON keys, a report line with position,
 * the maximum over a run with its place and time (JSON, reports, attributes,
 * checkpoints), and a column in the file of several passes.
 */
#ifndef OVR_SIMULATION_QUANTITY_ROW_H
#define OVR_SIMULATION_QUANTITY_ROW_H

#include "overroll/simulation.h"

/* A quantity per step that requires the physical models `bits` (0: none). The
 * JSON key and its SI variant may be NULL. The last arguments are its name for
 * users and further members: how reports, extremes, means and passes show it.
 */
#define OVR_NUMBER_ROW(in_files, in_json, in_si, of_kind, member, bits, ...)   \
    {                                                                          \
        .name = (in_files), .key = (in_json), .key_si = (in_si),               \
        .kind = OVR_KIND_##of_kind, .axes = OVR_AT_STEPS,                      \
        .offset = offsetof(ovr_observation, member), .needs = (bits),          \
        .long_name = __VA_ARGS__                                               \
    }
#define NUMBER(name, key, si, kind, member, ...)                               \
    OVR_NUMBER_ROW(name, key, si, kind, member, 0, __VA_ARGS__)

/* Optional members of a row. */
#define LABEL(text) .label = (text)
#define NOTE(text) .note = (text)
#define COMMENT(text) .comment = (text)
#define DIGITS(count) .digits = (count)
#define PLACE(member) .place = offsetof(ovr_observation, member)
#define SMALLEST(key) .extreme = OVR_SMALLEST, .extreme_key = (key)
#define LARGEST(key) .extreme = OVR_LARGEST, .extreme_key = (key)
#define OF_MAGNITUDE(key) .extreme = OVR_OF_MAGNITUDE, .extreme_key = (key)
#define EXTREME_REPORTED .extreme_reported = true
#define MEAN(key) .mean_key = (key)
#define MEAN_REPORTED .mean_reported = true
#define STEADY_TOO .steady = true
#define PASS(column) .pass = OVR_PASS_##column
#define PASS_HEAD(place, text) .pass_place = (place), .pass_head = (text)
#define PASS_WITH(physics) .pass_with = OVR_PHYSICS_##physics
#define FRICTION .friction = true
#define TOTAL(key, text) .total_key = (key), .total_label = (text)

#endif
