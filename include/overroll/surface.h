/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces: features and profiles convected by the two moving surfaces, as a
 * case describes them in its sections [feature NAME].
 *
 *     S(X, T) = S1(X - X1(T)) + S2(X - X2(T)),  dXk/dT = Cu(T) u_k/um
 *
 * in units of b^2/R, positive out of the surface (a dent is negative).  Each
 * surface carries any number of features; they may overlap, repeat and
 * outlast the run.
 */
#ifndef OVERROLL_SURFACE_H
#define OVERROLL_SURFACE_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/contact.h"
#include "overroll/error.h"
#include "overroll/memory.h"
#include "overroll/profile.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Shapes. s = X - Xd(T) is the distance from the feature's centre, xi = s/width
 * and g(v) = 10^(-10 v^2). sigma is the quintic smoothstep 6v^5 - 15v^4 + 10v^3
 * for 0 < v < 1, with the constant values 0 and 1 outside:
 *
 *   dent     -depth  g(xi) cos(2 pi xi)        (with small rims)
 *   bump     +height g(xi) cos(2 pi xi)
 *   indent   -depth g(xi) + shoulder [g((s - a)/c) + g((s + a)/c)],
 *            a = shoulder_at (width/2), c = shoulder_width (width/2)
 *            or, by rim_diameter and rim_height, the bowl of a ball (or of a
 *            hard particle) with a raised rim: src/surface/shape.c
 *   ridge    +height g(xi)                     (or -depth g(xi))
 *   step     +height sigma(1/2 - s/flank): the surface is higher at s < 0;
 *            with a length it is low again at s < -length
 *   groove   -depth sigma((width/2 - |s|)/flank + 1/2): flat bottom, flanks
 *            centred at s = +-width/2
 *   wave     amplitude cos(2 pi (X - origin - u T)/wavelength), endless
 *   chirp    amplitude cos(2 pi [s'/w0 + (1/w1 - 1/w0) s'^2/(2 length)]),
 *            s' = s + length/2 in [0, length], w0 = wavelength at its rear,
 *            w1 = wavelength_end at its leading end, faded in and out by
 *            sigma over taper (default: the longer wavelength) at both ends
 *   texture  -depth (1 + cos(2 pi s/width))/2 for |s| < width/2, repeated
 *            every wavelength (>= width), endless
 *   profile  measured, from a file
 *   roughness random, from a seed and a spectrum
 *   areal    measured map of heights, from a file; only on a strip
 *
 * Instead of the width, width_half can be given (diameter is a synonym): the
 * full width at half the depth or height. It is 0.2478 width of a dent or bump,
 * 0.3470 width of a ridge or an indent without rims, 1/2 width of a texture's
 * dimple, and the width of a groove. half_width is half of width_half.
 *
 * Instead of the flank of a step or groove, the radius r of its edges can be
 * given. Then flank = sqrt(10/sqrt(3) height r) in metres, because the largest
 * curvature of sigma is 10/sqrt(3).
 */
typedef enum ovr_shape {
    OVR_DENT,
    OVR_BUMP,
    OVR_INDENT,
    OVR_RIDGE,
    OVR_STEP,
    OVR_GROOVE,
    OVR_WAVE,
    OVR_CHIRP,
    OVR_TEXTURE,
    OVR_PROFILE,
    OVR_ROUGHNESS,
    OVR_AREAL,
    OVR_SHAPES /* how many there are */
} ovr_shape;

/* Returns the name of a shape ("dent", "bump", ...), or NULL past the last. */
OVR_API const char *ovr_shape_name(int shape);

/* Writes a description of the keys of a shape, such as "needs depth, width;
 * ...", and returns the length of the complete text, like snprintf. */
OVR_API int ovr_shape_takes(int shape, char *text, size_t capacity);

/* Returns the width of a shape at half its height or depth divided by its
 * width (indent: without rim), or NAN if the shape has no width. */
OVR_API double ovr_shape_width_half(int shape);

/* All sizes of shapes, heights (may be zero) and lengths, with their help
 * text. src/surface/shape.c lists the sizes of each shape. */
/* clang-format off */
#define OVR_FEATURE_SIZES(HEIGHT, LENGTH)                                     \
    HEIGHT(depth, "depth, a positive number")                                 \
    HEIGHT(height, "height")                                                  \
    HEIGHT(amplitude, "amplitude")                                            \
    LENGTH(width,                                                             \
           "width in the formula of the shape; the width at half height is "  \
           "width_half")                                                      \
    LENGTH(width_half,                                                        \
           "width at half the depth or height, instead of width")             \
    LENGTH(diameter, "the same as width_half")                                \
    LENGTH(half_width, "half of width_half, instead of width")                \
    LENGTH(rim_diameter,                                                      \
           "diameter of the rim, crest to crest, instead of width and "       \
           "shoulder; for indents of balls or hard particles")                \
    HEIGHT(rim_height,                                                        \
           "height of the rim; default: 0.159 of the depth, as in hardened "  \
           "steel")                                                           \
    LENGTH(wavelength,                                                        \
           "wavelength (at the rear of a chirp), or distance of the dimples " \
           "of a texture")                                                    \
    LENGTH(wavelength_end, "wavelength at the leading end")                   \
    LENGTH(length, "length along x")                                          \
    HEIGHT(shoulder, "height of the raised rims")                             \
    LENGTH(shoulder_at,                                                       \
           "distance of the rims from the centre; default: half the "         \
           "width")                                                           \
    LENGTH(shoulder_width,                                                    \
           "width of the rims; default: half the width")                      \
    LENGTH(flank,                                                             \
           "width of the flank; chirp: length of the tapers at both ends")    \
    LENGTH(radius, "radius of the edges, instead of flank")
/* clang-format on */

/* Input of a feature. Lengths are in b, heights in b^2/R, times in b/u_m; NAN:
 * not set. Members that the shape does not use must be NAN. */
typedef struct ovr_feature_form {
    const char *name; /* name in messages: NAME of [feature NAME] */
    int surface;      /* 1: convected at u1, 2: at u2 */
    ovr_shape shape;

    /* Position, by at most one of these members (wave and texture: origin or
     * none). By default a feature starts just upstream of the inlet, as with
     * start = -INFINITY. */
    double start;   /* X of the centre at T = 0; step: of the edge; profile and
                       roughness: of the leading end (largest x) */
    double centre;  /* X of the centre at T = 0, for profiles as well */
    double edge;    /* X of the leading end (largest x) at T = 0 */
    double arrival; /* T at which the centre is at X = 0 */
    double origin;  /* wave, texture: X of a crest (dimple) at T = 0 */

    /* Sizes, named as in the formulas of the shapes. */
#define OVR_SIZE(name, help) double name;
    OVR_FEATURE_SIZES(OVR_SIZE, OVR_SIZE)
#undef OVR_SIZE

    /* Extent across rolling, for strips only. */
    double across;        /* Y of the centre */
    double width_across;  /* width across; 0: round, INFINITY: the same for all
                             Y, NAN: by shape */
    double length_across; /* length across; NAN: endless */
    double angle;         /* angle between length and y axis, radians */
    double
        wavelength_across; /* wavelength across of a crossing wave or texture */
    double stagger; /* texture: shift of every second row as a share of the
                       pitch across */

    /* Changes in time and along the surface. */
    double grow;      /* grows in height by sigma((T - grow_from)/grow) */
    double grow_from; /* default 0 */
    double repeat; /* distance of copies upstream (stationary features: in both
                      directions) */
    int copies;    /* total number of copies; 0: endless */

    /* Profiles and roughness; lengths in b, heights in b^2/R. */
    const ovr_profile_source *source;
    const ovr_conditioning *conditioning; /* NULL: defaults */
    const ovr_roughness *roughness;
} ovr_feature_form;

typedef struct ovr_surfaces ovr_surfaces;

/* Writes S at time T at the n increasing positions X. The function is an
 * ovr_heights (simulation.h) with the ovr_surfaces as data. It allocates
 * nothing. */
OVR_API void ovr_surfaces_heights(void *surfaces, double T, size_t n,
                                  const double *X, double *S);

/* Writes the height of the stationary features (u_k = 0), fully grown,
 * independent of T. */
OVR_API void ovr_surfaces_standing(void *surfaces, double T, size_t n,
                                   const double *X, double *S);

/* ------------------------------------------------- information on features */

/* Returns u_k/u_m of the surface with the steepest moving feature (height
 * divided by wavelength) for ovr_simulation_moving, or NAN if no feature
 * moves. */
OVR_API double ovr_surfaces_speed(const ovr_surfaces *surfaces);

#ifdef __cplusplus
}
#endif

#endif
