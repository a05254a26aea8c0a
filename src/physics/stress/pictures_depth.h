/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The field below a snapshot, from its pressure and, where the case has it,
 * traction. */
#ifndef OVR_PHYSICS_STRESS_PICTURES_DEPTH_H
#define OVR_PHYSICS_STRESS_PICTURES_DEPTH_H

#include "contact/layers.h"
#include "overroll/case.h"
#include "pictures/chart.h"
#include "pictures/stored.h"
#include "stress/stress.h"

enum { OVR_CELLS_X = 360, OVR_CELLS_Z = 160 };

/* One scale and one depth axis for a whole run. */
typedef struct ovr_depth_field {
    const ovr_stored *run;
    ovr_stress *stress;
    ovr_stress_field which;
    const char *name;
    double poisson, residual_x, residual_y;
    size_t residuals; /* by depth, in place of both */
    const double *residual_z, *residual_s;
    ovr_coated coated; /* layers on the body; none: their number is 0 */
    ovr_stress_options options;
    ovr_material_range range;
    double traction;   /* Q over the stored shear stress; 0: there is none */
    const char *shear; /* its name in the file */
    double *P, *Q;
    double *even; /* space for loads on nodes at one distance, where those of
                     the file are at several; else NULL */
    size_t nodes; /* of P and Q then */
    bool logarithmic;
    double mesh, minimum; /* D; largest values are looked for from here down */
    double x_from, x_to, z_to;
    double high;   /* end of the colours; `low` its negative or 0 */
    double smooth; /* largest of the first snapshot, from `minimum` down */
    ovr_stress_extreme worst; /* that of the snapshot solved last */
    double *cells;            /* OVR_CELLS_Z rows, from the surface down */
} ovr_depth_field;

/* A field is looked at so. */
typedef struct ovr_depth_look {
    const char *field;   /* NULL: max_shear */
    bool logarithmic;    /* depths */
    int surface;         /* 0: the first */
    double x_from, x_to; /* b; NAN: -1.5 and 1.5 */
} ovr_depth_look;

/* Scans the run. */
ovr_status ovr_depth_field_make(ovr_depth_field *f, const ovr_stored *run,
                                const ovr_depth_look *look, ovr_arena *arena,
                                ovr_error *err);
void ovr_depth_field_free(ovr_depth_field *f);

/* The field of snapshot k, and its largest value from `minimum` down. */
ovr_status ovr_depth_field_solve(ovr_depth_field *f, size_t k, ovr_error *err);

/* Its value below X at a depth z, of the snapshot solved last. */
double ovr_depth_field_at(const ovr_depth_field *f, double X, double z);

/* True of those that are pressures: negative below a contact. */
bool ovr_depth_field_is_pressed(const ovr_depth_field *f);

/* The panel of the snapshot solved last: colours, contours every 0.1 ph, the
 * smooth maximum, a mark at the largest value. */
ovr_status ovr_depth_field_panel(ovr_depth_field *f, ovr_units units,
                                 ovr_panel *panel, ovr_arena *arena,
                                 ovr_error *err);

#endif
