/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Chooses the domain, and the gap on it, from the time histories. */
#ifndef OVR_CASE_DOMAIN_H
#define OVR_CASE_DOMAIN_H

#include "case/resolve.h"

/* True if load, speed or radius vary, so that the film thickness varies in
 * time. */
bool ovr_setup_varies(const ovr_setup *setup);

/* True if the solution normally is of fourth order: with the characteristic
 * scheme, corrections include time-dependent terms (simulation/fourth.c). */
bool ovr_setup_corrected(const ovr_setup *setup);

/* Returns the end time, as far as it is known before the domain is chosen. */
double ovr_setup_end(const ovr_setup *setup);

/* Chooses the ends of the domain that are not given; rejects given ends inside
 * the contact. */
ovr_status ovr_setup_domain(ovr_resolved *r, ovr_error *err);

/* Domain needed by the films of a run at all times and in all passes. */
typedef struct ovr_domain_needs {
    double width;         /* maximum dry half-width, in b */
    double inlet, outlet; /* usual ends, which suffice */
    double film_end;      /* upper limit of X at which steady films end */
    double loss;          /* largest relative loss of film thickness due to its
                           * inlet */
    bool varies;          /* conditions vary */
} ovr_domain_needs;
ovr_domain_needs ovr_setup_needs(const ovr_setup *setup);

/* Returns an outlet that the film does not reach while features pass, at most
 * twice that for smooth surfaces. The features must have been created. */
double ovr_setup_feature_outlet(const ovr_setup *setup);

/* Decides whether the curvature is convected with the material on this
 * domain. */
ovr_status ovr_setup_curvature(ovr_resolved *r, ovr_error *err);

#endif
