/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces of a contact, for the other parts of the library. */

/*
 *     ovr_feature_form form = ovr_feature_form_default();
 *     form.shape = OVR_DENT, form.depth = 0.1, form.width = 0.5;
 *     form.start = -4.6;
 *     ovr_surfaces *s = ovr_surfaces_create(&contact, NULL, D, NULL, &err);
 *     ovr_surfaces_add(s, &form, &err);
 *     ovr_simulation_surface(sim, ovr_surfaces_heights, s);
 */
#ifndef OVR_SURFACE_SURFACES_H
#define OVR_SURFACE_SURFACES_H

#include "overroll/surface.h"

typedef struct ovr_feature_info {
    const char *name;
    int surface;
    ovr_shape shape;
    double speed;      /* u_k/um */
    double amplitude;  /* maximum |S| */
    double raised;     /* maximum of S, at least 0; the amplitude for areal
                        * maps */
    double wavelength; /* shortest significant wavelength, b; a grid needs
                        * several nodes in it. Local shapes: the width; tables
                        * of heights: 2 pi Rq/Rdq */
    const char *wavelength_is; /* "shortest" or "mean" */
    double diameter;           /* full width at half depth or height, b; NAN for
                                * shapes without a width */
    double behind, ahead; /* extent about the centre, b (may be infinite) */
    bool grows;           /* grows from zero height */
    bool uniform;         /* the same for all x, so that motion has no effect */
    double Rq;            /* Rq of rough features (profiles, roughness, wave,
                           * chirp), b^2/R; 0: single shape */
    double last;          /* distance to its last copy, b; 0 without copies,
                           * infinite if they are endless */
    const char *assumed;  /* profiles: assumptions of the reader and
                           * conditioning, as lines ended by '\n'; otherwise
                           * "" */
} ovr_feature_info;

/* Creates the two smooth surfaces of a contact. `speed` (may be NULL: constant)
 * must remain valid. `mesh`: the grid's D, for anti-alias filtering of
 * profiles. */
ovr_surfaces *ovr_surfaces_create(const ovr_contact *contact,
                                  const ovr_history *speed, double mesh,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_surfaces_free(ovr_surfaces *surfaces);

/* Sets the history of V = (u1 - u2)/u_m0, which must remain valid; surfaces
 * then move with Cu +- V/2. Must be called before features are added. */
void ovr_surfaces_sliding(ovr_surfaces *surfaces, const ovr_history *sliding);

/* Sets the width of a strip in b and the number of its lines. Must be called
 * before features are added. */
void ovr_surfaces_strip(ovr_surfaces *surfaces, double width, size_t lines);

/* Computes heights of surface 1 or 2, or of both (0), on a strip: an
 * ovr_heights_across of simulation.h. */
void ovr_surfaces_across(void *data, int surface, double T, size_t n,
                         const double *X, size_t lines, const double *Y,
                         size_t stride, double *S);

/* Sets the ends of the film. A feature without a position starts just outside,
 * on the side from which it enters. */
void ovr_surfaces_domain(ovr_surfaces *surfaces, double inlet, double outlet);

/* Adds a feature and reads its file, if any. On failure the surfaces do not
 * change. */
ovr_status ovr_surfaces_add(ovr_surfaces *surfaces,
                            const ovr_feature_form *form, ovr_error *err);

/* Compute the heights S of one surface at n positions X. The third function
 * returns true if a surface has features. */
void ovr_surfaces_heights_1(void *data, double T, size_t n, const double *X,
                            double *S);
void ovr_surfaces_heights_2(void *data, double T, size_t n, const double *X,
                            double *S);
bool ovr_surfaces_has(const ovr_surfaces *surfaces, int surface);

/* Returns the composite roughness Rq of both surfaces in b^2/R, before the
 * grid's filter: the root sum of squares of all features' root mean square
 * heights. The mean over windows of 2 b is subtracted first. 0 without rough
 * features. */
double ovr_surfaces_roughness(const ovr_surfaces *surfaces);

/* Returns the name of the first feature that lies in inlet < X < outlet at T =
 * 0 and has more than a trace of its height; NULL if there is none. Growing and
 * endless features are ignored. */
const char *ovr_surfaces_inside(const ovr_surfaces *surfaces, double inlet,
                                double outlet);

/* Returns X of a feature's centre at T (wave: of the crest that was at
 * `origin`). */
double ovr_surfaces_centre(const ovr_surfaces *surfaces, size_t feature,
                           double T);

/* Returns the first T >= 0 after `after` at which the centre of a feature, or
 * of a copy of it if `copies` is set, reaches X; INFINITY if it does not before
 * `until`. */
double ovr_surfaces_arrival(const ovr_surfaces *surfaces, size_t feature,
                            double X, double after, double until);

ovr_feature_form ovr_feature_form_default(void);

ovr_roughness ovr_roughness_default(void);

size_t ovr_surfaces_count(const ovr_surfaces *surfaces);

/* Returns the multiplications, about, by which the heights of profiles and
 * roughness were prepared. */
double ovr_surfaces_work(const ovr_surfaces *surfaces);
ovr_feature_info ovr_surfaces_info(const ovr_surfaces *surfaces,
                                   size_t feature);

/* Times at which the leading end of a feature enters the domain, the centre of
 * its first copy is at X = 0, and its last copy has left the domain. 0 means
 * before T = 0; INFINITY means not before `until`. */
typedef struct ovr_feature_times {
    double enters, centre, leaves;
} ovr_feature_times;
ovr_feature_times ovr_surfaces_times(const ovr_surfaces *surfaces,
                                     size_t feature, double inlet,
                                     double outlet, double until);

#endif
