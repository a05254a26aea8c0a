/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces as the library puts them together and asks them. */
#ifndef OVR_SURFACE_SURFACES_H
#define OVR_SURFACE_SURFACES_H

#include "overroll/surface.h"

typedef struct ovr_feature_info {
    const char *name;
    int surface;
    ovr_shape shape;
    double speed;      /* u_k/um */
    double amplitude;  /* largest |S| */
    double raised;     /* largest S, at least 0; the amplitude of areal maps */
    double wavelength; /* the shortest that matters, b: a grid needs several
                          nodes in it; of local shapes the feature's width,
                          of tables of heights 2 pi Rq/Rdq */
    const char *wavelength_is; /* "shortest" or "mean" */
    double diameter;           /* full width at half depth or height, b; NAN of
                                  shapes without a width */
    double behind, ahead; /* extent about its centre, b (may be infinite) */
    bool grows;           /* starts from nothing */
    double Rq;            /* of what is rough (profiles, roughness, wave,
                             chirp), b^2/R; 0: a single shape */
    double last;          /* its last copy is so far behind it, b; 0 without
                             copies, infinite when they have no end */
    const char *assumed;  /* profiles: what the reader assumed and what was
                             done, lines ended by '\n'; else "" */
} ovr_feature_info;

/* Two smooth surfaces of a contact; `speed` (may be NULL: constant) is
 * borrowed; mesh is the grid's D, for anti-alias filtering of profiles. */
ovr_surfaces *ovr_surfaces_create(const ovr_contact *contact,
                                  const ovr_history *speed, double mesh,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_surfaces_free(ovr_surfaces *surfaces);

/* V = (u1 - u2)/um0 in time, borrowed: surfaces then move at Cu +- V/2.  Before
 * features are put on. */
void ovr_surfaces_sliding(ovr_surfaces *surfaces, const ovr_history *sliding);

/* Sets the width of a strip, b, and the number of its lines.  The function is
 * called before features are added. */
void ovr_surfaces_strip(ovr_surfaces *surfaces, double width, size_t lines);

/* Heights of surface 1 or 2, or of both (0), on a strip: an
 * ovr_heights_across of simulation.h. */
void ovr_surfaces_across(void *data, int surface, double T, size_t n,
                         const double *X, size_t lines, const double *Y,
                         size_t stride, double *S);

/* Sets the ends of the film: a feature without a place starts just
 * outside, on the side that it comes from. */
void ovr_surfaces_domain(ovr_surfaces *surfaces, double inlet, double outlet);

/* Adds a feature; reads its file if it has one.  On failure the
 * surfaces are as before. */
ovr_status ovr_surfaces_add(ovr_surfaces *surfaces,
                            const ovr_feature_form *form, ovr_error *err);

/* Compute the part of S on surface 1 or 2; returns true if a surface has
 * features. */
void ovr_surfaces_heights_1(void *data, double T, size_t n, const double *X,
                            double *S);
void ovr_surfaces_heights_2(void *data, double T, size_t n, const double *X,
                            double *S);
bool ovr_surfaces_has(const ovr_surfaces *surfaces, int surface);

/* Shortest wavelength of all features, b; INFINITY on smooth surfaces. */
double ovr_surfaces_wavelength(const ovr_surfaces *surfaces);

/* Composite roughness Rq of both surfaces, b^2/R, before the grid's filter: the
 * root of the sum of the squares, of each feature the root mean square of what
 * is left where the mean is taken out of windows of 2 b; 0 without any that is
 * rough. */
double ovr_surfaces_roughness(const ovr_surfaces *surfaces);

/* Name of the first feature that is in inlet < X < outlet at T = 0 with more
 * than a trace of its height, or NULL; those that grow, or that are endless,
 * do not count. */
const char *ovr_surfaces_inside(const ovr_surfaces *surfaces, double inlet,
                                double outlet);

/* X of a feature's centre (wave: of the crest first at `origin`) at T. */
double ovr_surfaces_centre(const ovr_surfaces *surfaces, size_t feature,
                           double T);

/* First T >= 0 at which a feature's centre, or that of one of its copies
 * when `copies` is set, reaches X after time `after`; INFINITY: never
 * (searched up to `until`). */
double ovr_surfaces_arrival(const ovr_surfaces *surfaces, size_t feature,
                            double X, double after, double until);

ovr_feature_form ovr_feature_form_default(void);

ovr_roughness ovr_roughness_default(void);

size_t ovr_surfaces_count(const ovr_surfaces *surfaces);
ovr_feature_info ovr_surfaces_info(const ovr_surfaces *surfaces,
                                   size_t feature);

/* Times at which the leading end of a feature enters the domain, at which the
 * centre of its first copy is at X = 0, and at which the trailing end of its
 * last copy leaves the domain. 0: before T = 0; INFINITY: not before `until`.
 */
typedef struct ovr_feature_times {
    double enters, centre, leaves;
} ovr_feature_times;
ovr_feature_times ovr_surfaces_times(const ovr_surfaces *surfaces,
                                     size_t feature, double inlet,
                                     double outlet, double until);

#endif
