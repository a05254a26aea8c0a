/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Histories decide about the grid: the domain, and the gap on it. */
#ifndef OVR_CASE_DOMAIN_H
#define OVR_CASE_DOMAIN_H

#include "case/resolve.h"

/* Load, speed or radius vary: other films at other times. */
bool ovr_setup_varies(const ovr_setup *setup);

/* True if it is of fourth order where nothing goes wrong: along the
 * characteristic corrections follow what varies (simulation/fourth.c). */
bool ovr_setup_corrected(const ovr_setup *setup);

/* The end, as far as it is known before the domain is. */
double ovr_setup_end(const ovr_setup *setup);

/* The domain, where it is left to the program; refused where it was given and
 * cuts the contact. */
ovr_status ovr_setup_domain(ovr_resolved *r, ovr_error *err);

/* The domain that films of a run, of all its moments and passes, ask for. */
typedef struct ovr_domain_needs {
    double width;         /* largest dry half width, in b */
    double inlet, outlet; /* the usual ones, which do */
    double film_end;      /* no steady film ends further downstream */
    double loss;          /* the largest share of the film that its own inlet
                             costs */
    bool varies;          /* there is more than one moment */
} ovr_domain_needs;
ovr_domain_needs ovr_setup_needs(const ovr_setup *setup);

/* The outlet that the film does not reach while the features pass, at most
 * twice that of smooth surfaces.  The features must have been made. */
double ovr_setup_feature_outlet(const ovr_setup *setup);

/* Decides if the curvature is convected with the material, on that domain. */
ovr_status ovr_setup_curvature(ovr_resolved *r, ovr_error *err);

#endif
