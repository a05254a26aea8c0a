/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case says this of bodies that yield (plastic.c). */
#ifndef OVR_PHYSICS_PLASTIC_PLASTIC_H
#define OVR_PHYSICS_PLASTIC_PLASTIC_H

#include "overroll/case.h"
#include "simulation/physics.h"
#include "stress/hardening.h"

/* A body that yields. */
typedef struct ovr_plastic_body {
    ovr_hardening hardening; /* in p_h, of strains over p_h/E* */
    double strain;           /* p_h/E*; NAN: not known */
    double softness;         /* b^2/R of the gap for a b p_h/E* that it sinks */
} ovr_plastic_body;

typedef struct ovr_plastic_setup {
    const ovr_setup *setup;
    int surfaces; /* as bits; 0: none */
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
} ovr_plastic_setup;

extern const ovr_physics ovr_physics_plastic;
extern const ovr_section ovr_plastic_section;

/* These are functions of a physics (simulation/physics.h). */
ovr_status ovr_plastic_resolve(const ovr_physics_case *of, void *form, bool *on,
                               ovr_error *err);
ovr_status ovr_plastic_on_mesh(const ovr_physics_case *of, void *form,
                               double mesh, ovr_error *err);
void ovr_plastic_state(const void *form, ovr_physics_statement *says);

/* NULL: nothing yields. */
ovr_plastic_setup *ovr_setup_plastic(const ovr_setup *setup);

#endif
