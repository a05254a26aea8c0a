/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the argument at which a function of one variable has a given value.
 * Each value is the result of a long computation that may fail and scatters a
 * little. First a scan with several points at a time; then Brent's method in
 * the scan's bracket (R. P. Brent, Algorithms for Minimization without
 * Derivatives, 1973, ch. 4); at the end a parabola through the values near the
 * answer, for slope and scatter.
 *
 * GSL's gsl_root_fsolver_brent is not used: it evaluates the ends again, aborts
 * the program if a value is missing, and reduces its bracket only to rounding
 * error, whereas the answer to an inequality is the end of a reduced bracket.
 */
#ifndef OVR_MATHEMATICS_SEARCH_H
#define OVR_MATHEMATICS_SEARCH_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/error.h"

enum { OVR_SEARCH_PLACES = 16, OVR_SEARCH_SCAN = 5, OVR_SEARCH_MAX = 1024 };

typedef struct ovr_search {
    double from, to; /* from < to, both finite */
    double target;
    int sense;        /* 0: equal to the target; 1: at least; -1: at most */
    int which;        /* for an inequality: 1 the largest x, -1 the smallest */
    double tolerance; /* relative tolerance of x */
    size_t scan;      /* points of the scan; 0: OVR_SEARCH_SCAN */
    bool exact;       /* values have rounding errors only, no scatter */
    /* Fills q[k] with the value at x[k], NAN if there is none. A status other
     * than OVR_OK ends the search. */
    ovr_status (*evaluate)(void *data, size_t n, const double *x, double *q,
                           ovr_error *err);
    void *data;
} ovr_search;

typedef enum ovr_search_end {
    OVR_SEARCH_FOUND,
    OVR_SEARCH_MISSED,  /* no change of side between the ends */
    OVR_SEARCH_BEYOND,  /* the inequality still holds at the end of the range */
    OVR_SEARCH_SEVERAL, /* the target is reached at several x */
    OVR_SEARCH_BROKEN,  /* values near the answer are missing */
    OVR_SEARCH_NOTHING  /* no values at all */
} ovr_search_end;

typedef struct ovr_search_result {
    ovr_search_end end;
    double value, at_value; /* the answer and its value; an inequality holds
                             * there */
    double low, high;       /* bracket that contains the answer */
    double slope;           /* d value/dx at the answer; NAN: unknown */
    double scatter;         /* scatter of values about a parabola; NAN:
                             * unknown */
    bool scatters;          /* the scatter exceeds the tolerance, so the search
                             * stopped */
    bool monotone;          /* monotone according to the scan */
    bool rises;
    double minimum, maximum; /* range of the values of the scan */
    double from, to;         /* range of x with values */
    size_t places;           /* number of brackets found by the scan */
    double place[OVR_SEARCH_PLACES][2];
} ovr_search_result;

/* Runs the search and returns the status of `evaluate`. result->end is the
 * reason why the search ended. */
ovr_status ovr_search_run(const ovr_search *search, ovr_search_result *result,
                          ovr_error *err);

#endif
