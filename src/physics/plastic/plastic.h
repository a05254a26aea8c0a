/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parameters of plastic bodies in a case (plastic.c). */
#ifndef OVR_PHYSICS_PLASTIC_PLASTIC_H
#define OVR_PHYSICS_PLASTIC_PLASTIC_H

#include "overroll/case.h"
#include "simulation/physics.h"
#include "stress/hardening.h"

/* A plastic body. */
typedef struct ovr_plastic_body {
    ovr_hardening hardening; /* stresses in p_h, strains in p_h/E* */
    double strain;           /* p_h/E*; NAN: unknown */
    double softness;         /* change of the gap in b^2/R per plastic
                              * displacement of b p_h/E* */
} ovr_plastic_body;

typedef struct ovr_plastic_setup {
    const ovr_setup *setup;
    int surfaces; /* plastic surfaces as bits; 0: none */
    ovr_plastic_body body[2];
    int hardening;  /* ovr_hardening_law */
    double yield;   /* as given, p_h; NAN: that of the body, or from Swift's law
                     */
    double modulus; /* hardening modulus, p_h */
    const char *swift;
    int passes;
    ovr_list window;
    double from, to; /* window in b; NAN: around the features */
    int layers, iterations;
    double depth;
    int once;             /* the profile changes only between passes */
    const char *initial;  /* result file with the initial state; NULL: none */
    const char *profiles; /* name of the profile files; NULL: none */
    bool anyway;
    bool elastic; /* an elastic first pass for comparison */
    bool rests;   /* the current pass is the elastic one */
    bool flooded; /* passes belong to this model: lubricant is not transferred
                   * between them */
} ovr_plastic_setup;

extern const ovr_physics ovr_physics_plastic;
extern const ovr_section ovr_plastic_section;

/* The following are functions of a physical model (simulation/physics.h). */
ovr_status ovr_plastic_resolve(const ovr_physics_case *of, void *form, bool *on,
                               ovr_error *err);
ovr_status ovr_plastic_on_mesh(const ovr_physics_case *of, void *form,
                               double mesh, ovr_error *err);
void ovr_plastic_state(const void *form, ovr_physics_effects *effects);

/* NULL: no plastic body. */
ovr_plastic_setup *ovr_setup_plastic(const ovr_setup *setup);

#endif
