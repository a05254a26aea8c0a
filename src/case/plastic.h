/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case's [plastic] comes to this. */
#ifndef OVR_CASE_PLASTIC_H
#define OVR_CASE_PLASTIC_H

#include "overroll/case.h"
#include "stress/hardening.h"

/* A body that yields. */
typedef struct ovr_plastic_body {
    ovr_hardening hardening; /* in p_h, of strains over p_h/E* */
    double strain;           /* p_h/E*; NAN: not known */
    double softness;         /* b^2/R of the gap for a b p_h/E* that it sinks */
} ovr_plastic_body;

typedef struct ovr_plastic_setup {
    unsigned surfaces; /* as bits; 0: none */
    ovr_plastic_body body[2];
    int hardening;  /* ovr_hardening_law */
    double yield;   /* as given, p_h; NAN: that of the body, or by swift */
    double modulus; /* of hardening, p_h */
    const char *swift;
    int passes;
    ovr_list window;
    double from, to; /* b; NAN: about the features */
    int layers, iterations;
    double depth;
    int once;             /* the profile changes between passes alone */
    const char *initial;  /* a result file; NULL: none */
    const char *profiles; /* NULL: no files of them */
    bool anyway;
    bool elastic; /* nothing yields in the first pass, to compare with */
    bool rests;   /* this is that pass */
    bool flooded; /* passes are its own: no oil goes from one to the next */
    int surface;  /* as given */
} ovr_plastic_setup;

/* NULL: nothing yields. */
const ovr_plastic_setup *ovr_setup_plastic(const ovr_setup *setup);

#endif
