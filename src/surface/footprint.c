/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heights of features on a strip of width W.
 *
 *     s = X - X_d(T),   t = Y - across + m W,   a the angle from the y axis
 *
 *     u = s cos a + t sin a,   v = t cos a - s sin a
 *     S = f(r),  r^2 = u^2 + (v/kappa)^2            round, elliptical
 *     S = f(u)                                      endless
 *     S = f(u) sigma((length/2 - |v|)/fade + 1/2)   finite
 *     wave                  A cos(2 pi u/lambda), crossed: times
 *                           cos(2 pi v/lambda_a)
 *     texture               A (1 + cos(2 pi r/width))/2 about the points of a
 *                           lattice, every second row shifted by `stagger`
 *
 * Line contacts have the same formula f (shape.c).
 *
 * The ratio kappa is the width across relative to that along x, and sigma the
 * smoothstep.
 *
 * A wave closes if W sin a/lambda is a whole number, a texture if W/lambda_a is
 * one.  An endless groove or ridge at an angle repeats along x.  Its repeat is
 * W tan a divided by a whole number.
 */
#include "surface/footprint.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/text.h"

static const double TWO_PI = 6.283185307179586476925;
static const double CLOSES = 1e-6; /* largest accepted distance from an
                                    * integer */

static bool may_be_round(ovr_shape shape)
{
    return shape == OVR_DENT || shape == OVR_BUMP || shape == OVR_INDENT ||
           shape == OVR_RIDGE || shape == OVR_GROOVE || shape == OVR_TEXTURE;
}

static bool is_usually_round(ovr_shape shape)
{
    return may_be_round(shape) && shape != OVR_RIDGE && shape != OVR_GROOVE;
}

static double or_else(double value, double otherwise)
{
    return isnan(value) ? otherwise : value;
}

/* Returns the width along x given in the form. */
static double given_width(const ovr_feature_form *form)
{
    return or_else(form->width,
                   or_else(or_else(form->width_half, form->diameter),
                           or_else(2 * form->half_width, form->rim_diameter)));
}

static bool is_whole(double x)
{
    return fabs(x - round(x)) < CLOSES;
}

/* Fails if a length does not divide `whole`, with a message that contains the
 * nearest lengths that do. */
static ovr_status does_not_close(const ovr_feature *f, const char *key,
                                 double value, double whole, ovr_error *err)
{
    double k = floor(whole / value);
    if (k < 1)
        return ovr_fail_about(err, key,
                              "feature '%s': %s = %g is not periodic in the "
                              "width of the strip; must be at most %.9g",
                              f->name, key, value, whole);
    return ovr_fail_about(err, key,
                          "feature '%s': %s = %g is not periodic in the width "
                          "of the strip; the nearest values are %.9g and %.9g",
                          f->name, key, value, whole / (k + 1), whole / k);
}

static ovr_status check_wave(const ovr_feature *f, double W, ovr_error *err)
{
    const ovr_footprint *g = &f->footprint;
    double along = W * fabs(g->sine) / f->wavelength;
    double across = W * fabs(g->cosine) / g->wavelength;
    if (isnan(g->wavelength)) {
        if (is_whole(along))
            return OVR_OK;
        return does_not_close(f, "wavelength", f->wavelength, W * fabs(g->sine),
                              err);
    }
    if (is_whole(across + along) && is_whole(across - along))
        return OVR_OK;
    if (!is_whole(2 * along))
        return does_not_close(f, "wavelength", f->wavelength, W * fabs(g->sine),
                              err);
    return does_not_close(f, "wavelength_across", g->wavelength,
                          W * fabs(g->cosine), err);
}

static bool is_oblique(const ovr_footprint *g)
{
    return fabs(g->sine) > CLOSES && fabs(g->cosine) > CLOSES;
}

static ovr_status check_oblique(ovr_feature *f, double W, ovr_error *err)
{
    const ovr_footprint *g = &f->footprint;
    const char *shape = ovr_shape_name((int)f->shape);
    double whole = W * fabs(g->sine / g->cosine);
    if (f->shape != OVR_RIDGE && f->shape != OVR_GROOVE &&
        f->shape != OVR_DENT && f->shape != OVR_BUMP && f->shape != OVR_INDENT)
        return ovr_fail_about(err, "angle",
                              "feature '%s': %s %s at an angle is not "
                              "periodic in the width of the strip; set "
                              "length_across",
                              f->name, ovr_article(shape), shape);
    if (isnan(f->repeat))
        return ovr_fail_about(err, "angle",
                              "feature '%s': an endless %s at an angle repeats "
                              "along x; set repeat = %.9g or %.9g, or "
                              "length_across",
                              f->name, shape, whole, whole / 2);
    if (is_whole(whole / f->repeat))
        return OVR_OK;
    return does_not_close(f, "repeat", f->repeat, whole, err);
}

static ovr_status check_texture(const ovr_feature *f, double W, ovr_error *err)
{
    const ovr_footprint *g = &f->footprint;
    if (g->ratio * f->width > g->wavelength * (1 + CLOSES))
        return ovr_fail_about(err, "wavelength_across",
                              "feature '%s': wavelength_across = %g must not "
                              "be below the width across, %g",
                              f->name, g->wavelength, g->ratio * f->width);
    if (is_whole(W / g->wavelength))
        return OVR_OK;
    return does_not_close(f, "wavelength_across", g->wavelength, W, err);
}

/* Rejects sizes that the shape does not have. */
static ovr_status check_sizes(const ovr_feature *f,
                              const ovr_feature_form *form, ovr_error *err)
{
    const char *shape = ovr_shape_name((int)f->shape), *key = NULL;
    bool areal = f->shape == OVR_WAVE || f->shape == OVR_TEXTURE;
    if (!isnan(form->width_across) && !may_be_round(f->shape))
        key = "width_across";
    else if (!isnan(form->length_across) && (areal || f->footprint.round))
        key = "length_across";
    else if (!isnan(form->wavelength_across) && !areal)
        key = "wavelength_across";
    else if (form->stagger != 0 && f->shape != OVR_TEXTURE)
        key = "stagger";
    else if (form->angle != 0 && f->shape == OVR_TEXTURE)
        key = "angle";
    if (!key)
        return OVR_OK;
    return ovr_fail_about(err, key, "feature '%s': %s%s %s has no %s", f->name,
                          f->footprint.round ? "a round " : ovr_article(shape),
                          "", shape, key);
}

/* Enlarges the extent along x if the feature's length is inclined to y. */
static void widen(ovr_feature *f)
{
    const ovr_footprint *g = &f->footprint;
    double half = g->round ? (g->ratio - 1) * g->reach : g->length / 2;
    double more = fabs(g->sine) * half;
    if (!(more > 0) || !isfinite(more))
        return;
    f->behind += more;
    f->ahead += more;
    f->reach_behind += more + g->fade;
    f->reach_ahead += more + g->fade;
}

/* Checks areal shapes: an areal surface includes its extent across, and areal
 * roughness the angle of its lay. */
static ovr_status make_areal(ovr_feature *f, const ovr_feature_form *form,
                             ovr_error *err)
{
    const char *shape = ovr_shape_name((int)f->shape), *key = NULL;
    if (!isnan(form->width_across))
        key = "width_across";
    else if (!isnan(form->length_across))
        key = "length_across";
    else if (!isnan(form->wavelength_across))
        key = "wavelength_across";
    else if (form->stagger != 0)
        key = "stagger";
    else if (form->angle != 0 && f->shape == OVR_AREAL)
        key = "angle";
    f->footprint = (ovr_footprint){.across = form->across,
                                   .ratio = 1,
                                   .length = INFINITY,
                                   .cosine = 1,
                                   .wavelength = NAN,
                                   .reach = f->reach_behind};
    return key ? ovr_fail_about(err, key, "feature '%s': shape = %s has no %s",
                                f->name, shape, key)
               : OVR_OK;
}

ovr_status ovr_footprint_make(ovr_feature *f, const ovr_feature_form *form,
                              double W, ovr_error *err)
{
    ovr_footprint *g = &f->footprint;
    double width = given_width(form);
    if (f->areal)
        return make_areal(f, form, err);
    *g = (ovr_footprint){
        .round = isnan(form->width_across) ? is_usually_round(f->shape)
                                           : isfinite(form->width_across),
        .across = form->across,
        .ratio = form->width_across > 0 && isfinite(form->width_across)
                     ? form->width_across / width
                     : 1,
        .length = or_else(form->length_across, INFINITY),
        .sine = sin(form->angle),
        .cosine = cos(form->angle),
        .wavelength = form->wavelength_across,
        .stagger = form->stagger,
        .reach = fmax(f->reach_behind, f->reach_ahead)};
    if (fabs(g->cosine) < 1e-12)
        g->cosine = 0;
    if (!isnan(form->length_across) && isnan(form->width_across))
        g->round = false;
    ovr_status status = check_sizes(f, form, err);
    if (status)
        return status;
    if (f->shape == OVR_TEXTURE) {
        g->wavelength = or_else(g->wavelength, f->wavelength);
        return check_texture(f, W, err);
    }
    if (f->shape == OVR_WAVE)
        return check_wave(f, W, err);
    g->fade = fmin(g->length / 2, f->width > 0 ? f->width / 2 : 0.25);
    widen(f);
    if (!g->round && isinf(g->length) && is_oblique(g))
        return check_oblique(f, W, err);
    return OVR_OK;
}

bool ovr_footprint_repeats(const ovr_feature *f)
{
    const ovr_footprint *g = &f->footprint;
    return !g->round && f->shape != OVR_WAVE && isinf(g->length) &&
           is_oblique(g);
}

/* ----------------------------------------------------------- evaluation */

/* Returns the height at s, t from the centre of one image. */
static double at_place(const ovr_feature *f, double s, double t)
{
    const ovr_footprint *g = &f->footprint;
    double u = s * g->cosine + t * g->sine, v = t * g->cosine - s * g->sine;
    if (g->round) {
        double r = hypot(u, v / g->ratio);
        return r <= g->reach ? ovr_shape_height(f, r) : 0;
    }
    double fading = ovr_smoothstep((g->length / 2 - fabs(v)) / g->fade + 0.5);
    if (!(fading > 0) || fabs(u) > g->reach)
        return 0;
    return fading * ovr_shape_height(f, u);
}

/* Returns the sum of all images of a local feature. */
static double of_images(const ovr_feature *f, double s, double t, double W,
                        double reach)
{
    double nearest = t - W * round(t / W), sum = 0;
    for (double m = -floor((reach + nearest) / W); nearest + m * W <= reach;
         m++)
        sum += at_place(f, s, nearest + m * W);
    return sum;
}

static double of_texture(const ovr_feature *f, double s, double t)
{
    const ovr_footprint *g = &f->footprint;
    double row = round(s / f->wavelength);
    bool odd = fmod(row, 2) != 0;
    s -= row * f->wavelength;
    t -= odd ? g->stagger * g->wavelength : 0;
    t -= g->wavelength * round(t / g->wavelength);
    double r = hypot(s, t / g->ratio);
    return r < f->width / 2 ? f->A * 0.5 * (1 + cos(TWO_PI * r / f->width)) : 0;
}

static double of_wave(const ovr_feature *f, double s, double t)
{
    const ovr_footprint *g = &f->footprint;
    double u = s * g->cosine + t * g->sine, v = t * g->cosine - s * g->sine;
    double crossed = isnan(g->wavelength) ? 1 : cos(TWO_PI * v / g->wavelength);
    return f->A * cos(TWO_PI * u / f->wavelength) * crossed;
}

/* Returns the sum of copies that are `step` apart along u. */
static double of_copies(const ovr_feature *f, double u, double step)
{
    const double reach = f->footprint.reach;
    double nearest = u - step * round(u / step), sum = 0;
    for (double m = -floor((reach + nearest) / step);
         nearest + m * step <= reach; m++)
        sum += ovr_shape_height(f, nearest + m * step);
    return sum;
}

/* Returns the height of a feature with endless length. */
static double of_endless(const ovr_feature *f, double s, double t, double W)
{
    const ovr_footprint *g = &f->footprint;
    double u = s * g->cosine + t * g->sine;
    if (is_oblique(g))
        return of_copies(f, u, fabs(f->repeat * g->cosine));
    return g->cosine == 0 ? of_copies(f, u, W) : ovr_shape_height(f, u);
}

/* Adds a map with its centre at `across`. Outside a map without repeat, the
 * strip is smooth. */
static void add_areal(const ovr_feature *f, double factor, double centre,
                      const ovr_places *at, double *S)
{
    const ovr_areal_table *t = f->areal;
    double half = ovr_areal_extent(&t->x) / 2;
    double low = f->footprint.across - ovr_areal_extent(&t->y) / 2;
    for (size_t i = 0; i < at->n; i++) {
        double s = at->X[i] - centre + half;
        double *to = S + i * at->stride;
        if (t->y.endless) {
            ovr_areal_add(t, factor, s, -low, at->lines, at->Y, to);
            continue;
        }
        for (size_t j = 0; j < at->lines; j++) {
            double y = at->Y[j] - low;
            y -= at->width * floor(y / at->width);
            ovr_areal_add(t, factor, s, 0, 1, &y, to + j);
        }
    }
}

/* Adds a shape given by a formula. */
static void add_shape(const ovr_feature *f, double factor, double centre,
                      const ovr_places *at, double *S)
{
    const double *X = at->X, *Y = at->Y, W = at->width;
    size_t n = at->n, lines = at->lines, stride = at->stride;
    const ovr_footprint *g = &f->footprint;
    bool local = g->round || isfinite(g->length);
    bool straight = !local && fabs(g->sine) < CLOSES &&
                    (f->shape != OVR_WAVE || isnan(g->wavelength));
    double reach = g->round ? g->reach * fmax(1, g->ratio)
                            : hypot(g->reach, g->length / 2 + g->fade);
    for (size_t i = 0; i < n; i++) {
        double s = X[i] - centre;
        if (f->shape == OVR_TEXTURE && g->round) {
            for (size_t j = 0; j < lines; j++)
                S[i * stride + j] += factor *
                                     of_texture(f, s, Y[j] - g->across);
        } else if (local && fabs(s) <= reach) {
            for (size_t j = 0; j < lines; j++)
                S[i * stride + j] += factor * of_images(f, s, Y[j] - g->across,
                                                        W, reach);
        } else if (straight && -s <= f->reach_behind && s <= f->reach_ahead) {
            double height = factor * ovr_shape_height(f, s);
            for (size_t j = 0; j < lines; j++)
                S[i * stride + j] += height;
        } else if (!local && !straight) {
            for (size_t j = 0; j < lines; j++) {
                double t = Y[j] - g->across;
                S[i * stride + j] += factor * (f->shape == OVR_WAVE
                                                   ? of_wave(f, s, t)
                                                   : of_endless(f, s, t, W));
            }
        }
    }
}

void ovr_footprint_add(const ovr_feature *f, double factor, double centre,
                       const ovr_places *at, double *S)
{
    if (f->areal)
        add_areal(f, factor, centre, at, S);
    else
        add_shape(f, factor, centre, at, S);
}
