/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Short forms for rows of parameters (base/parameter.h): each stands for kind,
 * dimension, unit of a bare number, minimum and maximum, whether the minimum
 * itself is rejected, and words. Words are designated initializers, because
 * compilers then do not warn about omitted members. Included only by files that
 * hold rows.
 */
#ifndef OVR_BASE_ROWS_H
#define OVR_BASE_ROWS_H

#include <math.h>

#include "base/parameter.h"

#define PLAIN(minimum, maximum)                                                \
    OVR_NUMBER, OVR_PURE, OVR_NOT_HERTZIAN, minimum, maximum, false,           \
        .words = NULL
#define PLAIN_OR(list, minimum, maximum)                                       \
    OVR_NUMBER, OVR_PURE, OVR_NOT_HERTZIAN, minimum, maximum, false,           \
        .words = list
#define POSITIVE(maximum)                                                      \
    OVR_NUMBER, OVR_PURE, OVR_NOT_HERTZIAN, 0, maximum, true, .words = NULL
#define WITH_UNIT(dimension, minimum, maximum)                                 \
    OVR_NUMBER, dimension, OVR_NOT_HERTZIAN, minimum, maximum, false,          \
        .words = NULL
#define LENGTH(minimum, maximum)                                               \
    OVR_NUMBER, OVR_LENGTH, OVR_IN_B, minimum, maximum, false, .words = NULL
#define LENGTH_OR(list, minimum, maximum)                                      \
    OVR_NUMBER, OVR_LENGTH, OVR_IN_B, minimum, maximum, false, .words = list
#define SIZE OVR_NUMBER, OVR_LENGTH, OVR_IN_B, 1e-6, 1e4, false, .words = NULL
#define HEIGHT                                                                 \
    OVR_NUMBER, OVR_LENGTH, OVR_IN_HEIGHT, 0, 1e3, false, .words = NULL
#define SHIFT                                                                  \
    OVR_NUMBER, OVR_LENGTH, OVR_IN_HEIGHT, -1e3, 1e3, false, .words = NULL
#define TIME(minimum, maximum)                                                 \
    OVR_NUMBER, OVR_DURATION, OVR_IN_TIME, minimum, maximum, false,            \
        .words = NULL
#define SPAN(list, maximum)                                                    \
    OVR_NUMBER, OVR_DURATION, OVR_IN_TIME, 1e-6, maximum, false, .words = list
#define STRESS(list, minimum, maximum)                                         \
    OVR_NUMBER, OVR_PRESSURE, OVR_IN_PRESSURE, minimum, maximum, false,        \
        .words = list
#define AREA_OR(list, maximum)                                                 \
    OVR_NUMBER, OVR_AREA, OVR_IN_AREA, 0, maximum, false, .words = list
#define WHOLE(minimum, maximum)                                                \
    OVR_INTEGER, OVR_PURE, OVR_NOT_HERTZIAN, minimum, maximum, false,          \
        .words = NULL
#define WHOLE_OR(list, minimum, maximum)                                       \
    OVR_INTEGER, OVR_PURE, OVR_NOT_HERTZIAN, minimum, maximum, false,          \
        .words = list
#define CHOICE(list)                                                           \
    OVR_CHOICE, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, .words = list
#define WORDS(list)                                                            \
    OVR_WORDS, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, .words = list
#define FLAG                                                                   \
    OVR_FLAG, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, .words = NULL
#define TEXT                                                                   \
    OVR_TEXT, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, .words = NULL
#define PATH                                                                   \
    OVR_PATH, OVR_PURE, OVR_NOT_HERTZIAN, NAN, NAN, false, .words = NULL
#define LIST(dimension, hertzian, minimum, maximum, list)                      \
    OVR_NUMBERS, dimension, hertzian, minimum, maximum, false, .words = list

/* The key always has an effect. */
#define ALWAYS NULL

/* Rows of a section and their number. */
#define ROWS(table) .rows = (table), .count = sizeof(table) / sizeof *(table)

#endif
