/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fitted films, for those who fit them (film_fit.c). */
#ifndef OVR_CONTACT_FILM_FIT_H
#define OVR_CONTACT_FILM_FIT_H

#include "overroll/contact.h"

typedef struct ovr_film_constants {
    double a[11];
} ovr_film_constants;

extern const ovr_film_constants ovr_central_film, ovr_minimum_film;

/* H of these constants, the density left out. */
double ovr_film_blend(const ovr_film_constants *constants, double M, double L);

#endif
