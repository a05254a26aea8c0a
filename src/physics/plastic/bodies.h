/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plastic bodies of a run; shared by the files of this folder. */
#ifndef OVR_PHYSICS_PLASTIC_BODIES_H
#define OVR_PHYSICS_PLASTIC_BODIES_H

#include "base/arena.h"
#include "physics/plastic/plastic.h"
#include "physics/stress/stress.h"
#include "simulation/physics.h"
#include "stress/yielding.h"

/* Number of state variables of a material point. */
enum { OVR_PLASTIC_STATE = 4 };

/* Elastic stresses are computed up to this distance from the middle of the
 * contact, b. */
enum { OVR_PLASTIC_REACH = 2 };

/* A plastic body. Its window is a part of the material of its surface. */
typedef struct ovr_yielding_body {
    ovr_yielding *y; /* NULL: the body is elastic */
    ovr_stress_plan plan;
    ovr_stress *field;     /* elastic stresses in the middle of the layers */
    size_t points, layers; /* size of the window */
    double first, mesh;    /* xi of the first point, and spacing */
    double *edge, *z;      /* boundaries of the layers, and their middles */
    double *kept;          /* strains at the last completed time */
    double *shown;     /* decrease of the profile height at the points, b^2/R */
    double *shape;     /* shape of the features before the contact */
    double *Q;         /* traction at the last completed time; NULL: none */
    bool changed;      /* the state has changed since then */
    double work, left; /* plastic work and residual at the last completed time
                        */
    double work_now, left_now;
} ovr_yielding_body;

typedef struct ovr_plastic {
    ovr_arena arena;
    const ovr_setup *setup;
    const ovr_plastic_setup *how;
    bool fresh; /* the flow by the film of the last completed time has been
                 * computed */
    double *P;  /* pressure on the solids */
    ovr_yielding_body body[2];
} ovr_plastic;

/* Window of a body and its layers, for a prepared setup. */
typedef struct ovr_plastic_plan {
    ovr_stress_plan stress;
    size_t points, layers;
    double first, mesh;
} ovr_plastic_plan;
ovr_status ovr_plastic_planned(const ovr_setup *setup, int k,
                               ovr_plastic_plan *plan, ovr_error *err);

/* Rejects windows that are too long for the mesh size of the setup. */
ovr_status ovr_plastic_check(const ovr_setup *setup, ovr_error *err);
void ovr_plastic_edges(const ovr_plastic_setup *how,
                       const ovr_plastic_plan *plan, double *edge);
ovr_yielding_options ovr_plastic_options(const ovr_plastic_setup *how, int k,
                                         const ovr_plastic_plan *plan,
                                         const double *edge);

/* Memory, time and report lines of a case, for the record of the model. */
double ovr_plastic_memory(const void *form);
double ovr_plastic_seconds(const void *form);
void ovr_plastic_describe(const ovr_physics_case *of, const void *form,
                          ovr_physics_line *line, void *data);

/* Height of the raised rim: highest point of the profile before (side = 1) or
 * after (-1) the middle of the features in their direction of motion, with or
 * without plastic deformation. */
double ovr_plastic_shoulder(const ovr_yielding_body *b, int side, bool yielded);

/* Maximum plastic strain, NAN if its unit is unknown; maximum decrease of the
 * profile height. */
double ovr_plastic_max(const ovr_plastic *p, const ovr_yielding_body *b);
double ovr_plastic_deepest(const ovr_yielding_body *b);

/* Writes the group plastic/surface_N of the file; reads a group. */
ovr_status ovr_plastic_store(ovr_writer *writer, const ovr_plastic *p,
                             ovr_error *err);

/* Checks, and writes, text files of both profiles of the first plastic body. */
ovr_status ovr_plastic_check_profiles(const ovr_plastic *p, ovr_error *err);
ovr_status ovr_plastic_write_profiles(const ovr_plastic *p, ovr_error *err);

ovr_status ovr_plastic_read(const char *file, const ovr_plastic *p,
                            ovr_yielding_body *b, ovr_error *err);

#endif
