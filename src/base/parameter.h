/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row of the table of parameters, and a section of a case: what a key is
 * called, what it may be, and where its value goes.  The rows of the case are
 * in case/keys, those of a physics in its record (simulation/physics.h), which
 * is why their type lies below both.
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
    OVR_PATH,    /* const char *, relative to the case */
    OVR_NUMBERS, /* ovr_list, separated by commas */
    OVR_WORDS    /* unsigned, bit k for the k-th word */
} ovr_kind;

/* The Hertzian quantity that a bare number is measured in. */
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
    ovr_dimension dimension; /* of numbers */
    ovr_hertzian hertzian;
    double minimum, maximum; /* SI or bare */
    bool above;              /* `minimum` itself is refused */
    const ovr_word *words;
    const char *initial; /* NULL: not given */
    size_t place;        /* in the form that its section fills */
    bool physics;        /* another value is another solution */
    const char *when;    /* it has an effect; NULL: always */
    const char *help;
} ovr_parameter;

/*
 * The conditions under which a key has an effect.  They are about other keys
 * and set apart by "; ", and all of them must hold; of the alternatives of one,
 * set apart by " or ", any suffices.  Each is about a key of the same section,
 * or section.key:
 *     "history = ramp | step"   its value is one of these words,
 *     "every > 0"               its number is above this one,
 *     "helix_angle == 0"        it is this one, "!= 0": another,
 *     "time.end"                it is given,
 *     "no refine_level"         it is not given,
 *     "[stress]"                that section is there.
 * "history = ramp => from or to" asks for what is behind the arrow only where
 * what is before it holds.
 * Of a size of a feature its shape decides, in surface/shape.c, where it is
 * refused too.
 */
#define OVR_BY_SHAPE "by shape"

/* A section with its rows: a table of parameters is a list of sections. */
typedef struct ovr_section {
    const char *name;
    bool named;     /* [feature NAME], any number */
    const char *on; /* the key that switches it, or NULL: while it is off, keys
                       that wait for it are noted, not refused */
    const char *help;
    const ovr_parameter *rows;
    size_t count;
    bool whole; /* a section without effect unless it is in the case */
} ovr_section;

#endif
