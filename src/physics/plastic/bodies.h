/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies of a run that yield: what its files share. */
#ifndef OVR_PHYSICS_PLASTIC_BODIES_H
#define OVR_PHYSICS_PLASTIC_BODIES_H

#include "base/arena.h"
#include "physics/plastic/plastic.h"
#include "physics/stress/stress.h"
#include "simulation/physics.h"
#include "stress/yielding.h"

/* Numbers of a material point. */
enum { OVR_PLASTIC_STATE = 4 };

/* Elastic stresses are looked at so far from the middle of the contact, b. */
enum { OVR_PLASTIC_REACH = 2 };

/* One of them; its window is material of its surface. */
typedef struct ovr_yielding_body {
    ovr_yielding *y; /* NULL: this body does not yield */
    ovr_stress_plan plan;
    ovr_stress *field;     /* elastic, in the middle of the layers */
    size_t points, layers; /* of the window */
    double first, mesh;    /* xi of the first, and between them */
    double *edge, *z;      /* of the layers, and their middles */
    double *kept;          /* strains of the last time reached */
    double *shown;     /* at the points, b^2/R: the profile lies so much lower
                        */
    double *shape;     /* of the features there, as they come */
    double *Q;         /* traction at the last time reached; NULL: none */
    bool changed;      /* since then */
    double work, left; /* of the last time reached */
    double work_now, left_now;
} ovr_yielding_body;

typedef struct ovr_plastic {
    ovr_arena arena;
    const ovr_setup *setup;
    const ovr_plastic_setup *how;
    bool fresh; /* has flowed by the film of the last time reached */
    double *P;  /* what the solids feel */
    ovr_yielding_body body[2];
} ovr_plastic;

/* The window of a body and its layers, of a setup that is prepared. */
typedef struct ovr_plastic_plan {
    ovr_stress_plan stress;
    size_t points, layers;
    double first, mesh;
} ovr_plastic_plan;
ovr_status ovr_plastic_planned(const ovr_setup *setup, int k,
                               ovr_plastic_plan *plan, ovr_error *err);
void ovr_plastic_edges(const ovr_plastic_setup *how,
                       const ovr_plastic_plan *plan, double *edge);
ovr_yielding_options ovr_plastic_options(const ovr_plastic_setup *how, int k,
                                         const ovr_plastic_plan *plan,
                                         const double *edge);

/* The record of the physics has these of a case: memory, time, lines. */
double ovr_plastic_memory(const void *form);
double ovr_plastic_seconds(const void *form);
void ovr_plastic_describe(const ovr_physics_case *of, const void *form,
                          ovr_physics_line *line, void *data);

/* Highest points of the profile as it is, before (1) or behind (-1) the middle
 * of the features, in the way that they go; as it came, without what yielded.
 */
double ovr_plastic_shoulder(const ovr_yielding_body *b, int side, bool yielded);

/* Largest plastic strain, NAN where its unit is not known; how far the profile
 * went down at most. */
double ovr_plastic_max(const ovr_plastic *p, const ovr_yielding_body *b);
double ovr_plastic_deepest(const ovr_yielding_body *b);

/* Stores into the group plastic/surface_N of the file, and reads from one. */
ovr_status ovr_plastic_store(ovr_writer *writer, const ovr_plastic *p,
                             ovr_error *err);

/* Both profiles as files of text, of the first body that yields. */
ovr_status ovr_plastic_check_profiles(const ovr_plastic *p, ovr_error *err);
ovr_status ovr_plastic_write_profiles(const ovr_plastic *p, ovr_error *err);

ovr_status ovr_plastic_read(const char *file, const ovr_plastic *p,
                            ovr_yielding_body *b, ovr_error *err);

#endif
