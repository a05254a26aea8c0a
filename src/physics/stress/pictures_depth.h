/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stress field below the surface at a snapshot, from its pressure and, if the
 * case includes it, traction. */
#ifndef OVR_PHYSICS_STRESS_PICTURES_DEPTH_H
#define OVR_PHYSICS_STRESS_PICTURES_DEPTH_H

#include "contact/layers.h"
#include "overroll/case.h"
#include "pictures/chart.h"
#include "pictures/stored.h"
#include "stress/stress.h"

enum { OVR_CELLS_X = 360, OVR_CELLS_Z = 160 };

/* One colour scale and depth axis for the whole run. */
typedef struct ovr_depth_field {
    const ovr_stored *run;
    ovr_stress *stress;
    ovr_stress_field which;
    const char *name;
    double poisson, residual_x, residual_y;
    size_t residuals; /* number of depths with residual stresses, for both
                       * surfaces */
    const double *residual_z, *residual_s;
    ovr_coated coated; /* layers on the body; their number may be 0 */
    ovr_stress_options options;
    ovr_material_range range;
    double traction;   /* factor from the stored shear stress to Q; 0: no
                        * traction */
    const char *shear; /* name of the shear stress in the file */
    double *P, *Q;
    double *even; /* space for loads at equidistant nodes if those of the file
                   * are not equidistant; else NULL */
    size_t nodes; /* number of these nodes */
    bool logarithmic;
    double mesh, minimum; /* D; minimum depth for maxima */
    double x_from, x_to, z_to;
    double high;   /* upper end of the colour scale; `low` is its negative or 0
                    */
    double smooth; /* maximum of the first snapshot at depths of at least
                    * `minimum` */
    ovr_stress_extreme worst; /* maximum of the snapshot solved last */
    double *cells;            /* OVR_CELLS_Z rows, starting at the surface */
} ovr_depth_field;

/* Options of a stress picture. */
typedef struct ovr_depth_look {
    const char *field;   /* NULL: max_shear */
    bool logarithmic;    /* depths */
    int surface;         /* 0: the first surface with stresses */
    double x_from, x_to; /* b; NAN: -1.5 and 1.5 */
} ovr_depth_look;

/* Scans the run. */
ovr_status ovr_depth_field_make(ovr_depth_field *f, const ovr_stored *run,
                                const ovr_depth_look *look, ovr_arena *arena,
                                ovr_error *err);
void ovr_depth_field_free(ovr_depth_field *f);

/* Computes the field of snapshot k, and its maximum at depths of at least
 * `minimum`. */
ovr_status ovr_depth_field_solve(ovr_depth_field *f, size_t k, ovr_error *err);

/* Value of the snapshot solved last, at X and depth z. */
double ovr_depth_field_at(const ovr_depth_field *f, double X, double z);

/* True for normal stresses, which are negative below a contact. */
bool ovr_depth_field_is_pressed(const ovr_depth_field *f);

/* Panel of the snapshot solved last: colours, contours every 0.1 p_h, maximum
 * of the smooth contact, mark at the maximum. */
ovr_status ovr_depth_field_panel(ovr_depth_field *f, ovr_units units,
                                 ovr_panel *panel, ovr_arena *arena,
                                 ovr_error *err);

#endif
