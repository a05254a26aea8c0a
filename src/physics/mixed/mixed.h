/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parameters of the asperity contact model of a case (keys.c). */
#ifndef OVR_PHYSICS_MIXED_MIXED_H
#define OVR_PHYSICS_MIXED_MIXED_H

#include "contact/flow_factor.h"
#include "contact/touch_law.h"
#include "simulation/physics.h"
#include "surface/rough_pair.h"

typedef enum ovr_boundary_law {
    OVR_BOUNDARY_NONE,
    OVR_BOUNDARY_EXPONENTIAL,
    OVR_BOUNDARY_LAYER,
    OVR_BOUNDARY_GREENWOOD_TRIPP,
    OVR_BOUNDARY_TABLE,
    OVR_BOUNDARY_PROFILE
} ovr_boundary_law;

typedef struct ovr_boundary_form {
    int law;
    int ridges;              /* orientation of the roughness, ovr_ridges */
    int unresolved;          /* the model describes only the roughness not
                              * resolved by the mesh */
    double Rq, slope;        /* combined roughness in b^2/R; combined slope */
    double amplitude, decay; /* a1, s; NAN: computed from Rq and slope */
    double layer, layer_decay;
    double friction;           /* boundary friction coefficient; NAN: unknown */
    double summits, sharpness; /* n beta sigma, sigma/beta */
    const char *file;          /* file of a tabulated contact model */
    double wear[2];            /* wear coefficient divided by hardness, 1/Pa */
    double passes;             /* 0: no wear */
    double jump;               /* passes per step; 0: automatic */
    double settled;            /* change of the asperity load share at which
                                * wear stops; 0: none */
    ovr_flow_factor factor;    /* flow factor of the mean film */
    double estimate;           /* predicted asperity load share */
    double at_no_film;         /* asperity pressure of the model at H = 0 in
                                * p_h; INFINITY: unlimited */
    double share_at_no_film;   /* maximum asperity load share of the model */
    ovr_rough_pair pair;       /* measured profiles of both surfaces */
    ovr_asperity_law bears;    /* the resulting contact model */
} ovr_boundary_form;

extern const ovr_section ovr_boundary_section;

/* The following are functions of a physical model (physics.h). */
ovr_status ovr_boundary_resolve(const ovr_physics_case *of, void *form,
                                bool *on, ovr_error *err);
ovr_status ovr_boundary_on_mesh(const ovr_physics_case *of, void *form,
                                double mesh, ovr_error *err);
bool ovr_boundary_keeps(const void *form, const ovr_feature_form *feature);
void ovr_boundary_describe(const ovr_physics_case *of, const void *form,
                           ovr_physics_line *line, void *data);

/* True if the asperity pressure at H = 0 is clearly below the Hertzian
 * pressure, at a load relative to the reference load. */
bool ovr_boundary_is_weak(const ovr_boundary_form *f, double load);

/* Writes advice if the roughness S on the grid is too high for the film
 * thickness H with an asperity contact model: the lambda ratio, its usual
 * minimum, and the alternative of a mean film. Without roughness the text is
 * empty. */
void ovr_boundary_instead(const ovr_asperity_law *law, double H, size_t n,
                          const double *X, const double *S, size_t size,
                          char *text);

#endif
