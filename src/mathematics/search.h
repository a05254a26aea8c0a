/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds where a function of one number has a value, when each of its values is
 * the outcome of a long computation that may fail and that scatters a little:
 * first comes a scan, several points at a time; then Brent's method in the
 * scan's bracket (R. P. Brent, Algorithms for Minimization without Derivatives,
 * 1973, ch. 4); at the end a parabola through what lies about the answer, for
 * slope and scatter.
 *
 * Brent's own form is written out here and not taken from GSL's
 * gsl_root_fsolver_brent: that one evaluates its ends again, ends the program
 * where a value is missing, and closes its bracket to rounding alone, while an
 * answer to an inequality is the end of a closed bracket.
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
    int sense;        /* 0: the value is the target; 1: at least; -1: at most */
    int which;        /* of an inequality: 1 the largest x, -1 the smallest */
    double tolerance; /* of x, relative */
    size_t scan;      /* points; 0: OVR_SEARCH_SCAN */
    bool exact;       /* values have rounding errors alone: none scatter */
    /* Fills q[k] with the value at x[k], NAN where there is none; what it
     * returns but OVR_OK ends the search. */
    ovr_status (*evaluate)(void *data, size_t n, const double *x, double *q,
                           ovr_error *err);
    void *data;
} ovr_search;

typedef enum ovr_search_end {
    OVR_SEARCH_FOUND,
    OVR_SEARCH_MISSED,  /* nothing changes between the ends */
    OVR_SEARCH_BEYOND,  /* an inequality still holds at the end asked for */
    OVR_SEARCH_SEVERAL, /* the value is met in several places */
    OVR_SEARCH_BROKEN,  /* values are missing where the answer lies */
    OVR_SEARCH_NOTHING  /* there is not one value */
} ovr_search_end;

typedef struct ovr_search_result {
    ovr_search_end end;
    double value, at_value; /* the answer, evaluated: an inequality holds */
    double low, high;       /* the bracket it lies in */
    double slope;           /* d value/dx there; NAN: not known */
    double scatter;         /* of values about a parabola; NAN: not known */
    bool scatters;          /* by more than the tolerance: stopped there */
    bool monotone;          /* as far as the scan tells */
    bool rises;
    double minimum, maximum; /* values of the scan */
    double from, to;         /* where there are values */
    size_t places;           /* brackets that the scan saw */
    double place[OVR_SEARCH_PLACES][2];
} ovr_search_result;

/* Runs the search and returns the status of `evaluate`. result->end is the
 * reason why the search ended. */
ovr_status ovr_search_run(const ovr_search *search, ovr_search_result *result,
                          ovr_error *err);

#endif
