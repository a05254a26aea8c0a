/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row of the table of parameters, and a section of a case: name of a key,
 * allowed values, and where its value is stored. The rows of the case are in
 * case/keys, those of a physical model in its record (simulation/physics.h);
 * both layers need this type.
 */
#ifndef OVR_BASE_PARAMETER_H
#define OVR_BASE_PARAMETER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/quantity.h"

typedef enum ovr_kind {
    OVR_NUMBER,  /* double; words stand for numbers */
    OVR_INTEGER, /* int; words stand for numbers */
    OVR_CHOICE,  /* int; one of the words */
    OVR_FLAG,    /* bool */
    OVR_TEXT,    /* const char * */
    OVR_PATH,    /* const char *, path relative to the case */
    OVR_NUMBERS, /* ovr_list, separated by commas */
    OVR_WORDS    /* unsigned, bit k for the k-th word */
} ovr_kind;

/* Hertzian unit of a number without a unit. */
typedef enum ovr_hertzian {
    OVR_NOT_HERTZIAN,
    OVR_IN_B,        /* length along x */
    OVR_IN_HEIGHT,   /* b^2/R */
    OVR_IN_TIME,     /* b/um */
    OVR_IN_PRESSURE, /* ph */
    OVR_IN_AREA      /* b^3/R */
} ovr_hertzian;

typedef struct ovr_word {
    const char *name; /* NULL ends a list */
    double value;
} ovr_word;

typedef struct ovr_parameter {
    const char *key;
    ovr_kind kind;
    ovr_dimension dimension; /* dimension of numbers */
    ovr_hertzian hertzian;
    double minimum, maximum; /* range in SI, or in the Hertzian unit */
    bool above;              /* `minimum` itself is not allowed */
    const ovr_word *words;
    const char *initial; /* default; NULL: not given */
    size_t place;        /* offset in the struct that its section fills */
    bool physics;        /* affects the solution */
    const char *when;    /* conditions under which it has an effect; NULL:
                          * always */
    const char *help;
} ovr_parameter;

/*
 * Conditions under which a key has an effect. They refer to other keys and are
 * separated by "; "; all must hold. Alternatives of a condition are separated
 * by " or "; one suffices. Each refers to a key of the same section, or to
 * section.key:
 *
 *     "history = ramp | step"  its value is one of these words
 *     "every > 0"              its number is larger
 *     "helix_angle == 0"       it is equal; "!= 0": it differs
 *     "time.end"               it is given
 *     "no refine_level"        it is not given
 *     "[stress]"               the section is in the case
 *     "no [strip]"             it is not
 *
 * "history = ramp => from or to" requires the condition after the arrow only if
 * the one before it holds. The sizes of a feature depend on its shape;
 * surface/shape.c checks them.
 */
#define OVR_BY_SHAPE "by shape"

/* A section with its rows; the table of parameters is a list of sections. */
typedef struct ovr_section {
    const char *name;
    bool named;     /* [feature NAME]: any number of them */
    const char *on; /* key that turns the section on, or NULL. While it is off,
                     * keys that depend on it cause a note, not an error */
    const char *help;
    const ovr_parameter *rows;
    size_t count;
    bool whole; /* has no effect unless it is in the case */
} ovr_section;

#endif
