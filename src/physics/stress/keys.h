/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case says this of stresses below its surfaces (stress.c). */
#ifndef OVR_PHYSICS_STRESS_KEYS_H
#define OVR_PHYSICS_STRESS_KEYS_H

#include "overroll/case.h"
#include "overroll/stress.h"
#include "simulation/physics.h"

/* Values of [stress] traction. */
enum { OVR_TRACTION_NO, OVR_TRACTION_YES, OVR_TRACTION_AUTO };

/* The settings of [stress] and [fatigue]: lengths in b, stresses in p_h. */
typedef struct ovr_stress_setup {
    const ovr_setup *setup;
    int surfaces; /* 1, 2, 3: both; 0: no stresses are asked for */
    double poisson[2];
    double depth_min, depth_max, per_octave; /* depth_min 0: 4 D */
    int every;                               /* snapshots; 0: no fields */
    unsigned fields; /* bits in the order of the parameter's choices */
    ovr_list window;
    double from, to; /* about the first feature's centre; NAN: about all */
    bool fatigue;
    ovr_criterion criterion;      /* its row writes an int, as wide */
    double alpha, limit_pressure; /* 0: none */
    ovr_life_options life;        /* its limit follows from limit_pressure */
    const char *limit_table;
    double raceway, count; /* raceway 0: not given */
    double residual_x, residual_y;
    const char *residual_table;
    size_t residuals; /* by depth in place of both: depths, stresses */
    const double *residual_z, *residual_s;
    int loads;               /* as given: whether it shall be one */
    bool traction;           /* the film's shear stress is a load too */
    const char *no_traction; /* why not; NULL where it is */
    double yield[2];         /* of each body, von Mises, p_h; 0: unknown */
} ovr_stress_setup;

extern const ovr_section ovr_stress_sections[2];

/* The ends of a window that the key `about` gives; NAN where it gives none. */
ovr_status ovr_window_resolve(const ovr_list *window, const char *about,
                              double *from, double *to, ovr_error *err);

/* These are functions of a physics (simulation/physics.h). */
ovr_status ovr_stress_resolve(const ovr_physics_case *of, void *form, bool *on,
                              ovr_error *err);
void ovr_stress_state(const void *form, ovr_physics_statement *says);

/* Stresses, surfaces = 0: there are none. */
const ovr_stress_setup *ovr_setup_stress(const ovr_setup *setup);

#endif
