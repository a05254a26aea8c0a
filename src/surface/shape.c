/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Feature shapes of surface.h as functions of the distance s from their centre.
 *
 * Each shape is a row of a table with its sizes and a function that adds the
 * shape to the heights at n positions. Local shapes are set to zero below 1e-18
 * of their height.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/text.h"
#include "surface/feature.h"

/* ---------------------------------------------------- indentation of a ball */

/*
 * Indent left by a ball, or by a hard particle that stays whole, from its depth
 * d and its rim diameter 2 s_c, crest to crest.
 *
 * The bowl is a parabola, the rim a bell. A cubic rounds their
 * intersection over a height k = h. Slope and curvature are therefore
 * continuous, and the crest is exactly at s_c and h high:
 *
 *     bowl = -d + (d + h)(s/a)^2,          a^2 = s_c^2 (d + h)/(d + h + k)
 *     rim  = h exp(-((|s| - s_c)/l)^2)
 *     S    = min(bowl, rim) - k g^3/6,     g = max(1 - |bowl - rim|/k, 0)
 *
 * Without a rim_height h = (c^2 - 1) d. Here c^2 = 5 (2 - n)/(2 (4 + n)) is the
 * square of the contact radius relative to the radius without pile-up (Hill,
 * Storakers & Zdunek, Proc. R. Soc. Lond. A 423 (1989) 301). A hardening
 * exponent n = 0.1, as of hardened steel, gives h = 0.159 d. This value is
 * quoted at second hand. It assumes full plasticity and neglects springback; a
 * measured rim height can be set.
 *
 * The width l follows from the volume: the rim of the round indent contains the
 * displaced material,
 *
 *     a^2 (d - h)/4 = h ((s_c^2 - a^2)/2 + sqrt(pi)/2 l s_c + l^2/2).
 *
 * l is at least s_c/4, because higher rims have no solution. The line contact
 * uses the section through the middle of the indent.
 */

static const double PILED_UP = 0.158536585365853659; /* c^2 - 1 */
static const double HALF_ROOT_PI = 0.8862269254527580137;
static const double NARROWEST = 0.25; /* minimum of l/s_c */

/* Set the sizes of an indentation given by its rim and depth -A (rim_height
 * NAN: value for steel); return its height at s. */
static void ball_sizes(ovr_feature *f, double rim_diameter, double rim_height)
{
    double d = -f->A, h = isnan(rim_height) ? PILED_UP * d : rim_height;
    double crest = rim_diameter / 2, part = (d + h) / (d + 2 * h);
    double volume = part * (d - h) / (2 * h) - (1 - part);
    double wide = sqrt(fmax(HALF_ROOT_PI * HALF_ROOT_PI + volume, 0)) -
                  HALF_ROOT_PI;
    f->ball = true;
    f->shoulder = h;
    f->shoulder_at = crest;
    f->shoulder_width = crest * fmax(wide, NARROWEST);
    f->width = crest * sqrt(part);
}

static double ball_height(const ovr_feature *f, double s)
{
    double h = f->shoulder,
           out = (fabs(s) - f->shoulder_at) / f->shoulder_width;
    double part = s / f->width, bowl = f->A + (h - f->A) * part * part;
    double rim = h * exp(-out * out), gap = 1 - fabs(bowl - rim) / h;
    return fmin(bowl, rim) - (gap > 0 ? gap * gap * gap * h / 6 : 0);
}

static const double TWO_PI = 6.283185307179586476925;
static const double TEN_LN_10 = 23.02585092994045684018; /* 10^(-10 v^2) */
/* Limit of v, from 10^(-10 v^2) < 1e-18 */
static const double VANISHED = 1.35;
static const double STEEPEST = 5.773502691896257645; /* max |sigma''| */

static double bell(double v)
{
    return exp(-TEN_LN_10 * v * v);
}

/* ------------------------------------------------------------- formulas */

typedef double formula(const ovr_feature *f, double s);

static double dent(const ovr_feature *f, double s)
{
    double xi = s / f->width;
    return f->A * bell(xi) * cos(TWO_PI * xi);
}

static double indent(const ovr_feature *f, double s)
{
    double a = f->shoulder_at, c = f->shoulder_width;
    if (f->ball)
        return ball_height(f, s);
    return f->A * bell(s / f->width) +
           f->shoulder * (bell((s - a) / c) + bell((s + a) / c));
}

static double ridge(const ovr_feature *f, double s)
{
    return f->A * bell(s / f->width);
}

static double step(const ovr_feature *f, double s)
{
    double down = isfinite(f->length)
                      ? ovr_smoothstep(0.5 - (s + f->length) / f->flank)
                      : 0;
    return f->A * (ovr_smoothstep(0.5 - s / f->flank) - down);
}

static double groove(const ovr_feature *f, double s)
{
    return f->A * ovr_smoothstep((f->width / 2 - fabs(s)) / f->flank + 0.5);
}

static double wave(const ovr_feature *f, double s)
{
    return f->A * cos(TWO_PI * s / f->wavelength);
}

static double chirp(const ovr_feature *f, double s)
{
    double r = s + f->length / 2, d = f->length / 2 - s;
    double k0 = 1 / f->wavelength, k1 = 1 / f->wavelength_end;
    double phase = r * k0 + (k1 - k0) * r * r / (2 * f->length);
    return f->A * cos(TWO_PI * phase) * ovr_smoothstep(r / f->flank) *
           ovr_smoothstep(d / f->flank);
}

static double texture(const ovr_feature *f, double s)
{
    double r = s - f->wavelength * round(s / f->wavelength);
    if (fabs(r) >= f->width / 2)
        return 0;
    return f->A * 0.5 * (1 + cos(TWO_PI * r / f->width));
}

static double tabulated(const ovr_feature *f, double s)
{
    if (!f->table) /* areal shapes: see footprint.c */
        return 0;
    return ovr_table_height(f->table, s + ovr_table_length(f->table) / 2);
}

/* -------------------------------------------------------- table of shapes */

/* Sizes of a shape, as numbers and as a set. */
#define NUMBER(name, help) SIZE_##name,
enum { OVR_FEATURE_SIZES(NUMBER, NUMBER) SIZES };
#define SET(name) (1U << SIZE_##name)

static const struct size {
    const char *name;
    size_t offset;
    bool zero; /* may be zero */
} sizes[] = {
#define ROW(field, zero) {#field, offsetof(ovr_feature_form, field), zero},
#define HEIGHT(field, help) ROW(field, true)
#define LENGTH(field, help) ROW(field, false)
    OVR_FEATURE_SIZES(HEIGHT, LENGTH)};

enum {
    HEIGHTS = SET(depth) | SET(height),
    WIDTHS = SET(width) | SET(width_half) | SET(diameter) | SET(half_width) |
             SET(rim_diameter),
    RIM = SET(rim_diameter) | SET(rim_height),
    EDGES = SET(flank) | SET(radius)
};

/* Full width at half depth over the width in the formula: of 10^(-10 v^2)
 * cos(2 pi v), and 2 sqrt(log10(2)/10). */
#define DENT_HALF 0.24779376112514412
#define BELL_HALF 0.3470043202405303

/* Rules of a shape. `tall`: alternatives for its height, exactly one of which
 * must be given. */
static const struct rule {
    const char *name;
    formula *height;
    unsigned tall, needed, allowed;
    double half;      /* full width at half depth divided by the width */
    const char *made; /* other source of the shape than sizes, or NULL */
} rules[OVR_SHAPES] = {
    [OVR_DENT] = {"dent", dent, SET(depth), SET(width), 0, DENT_HALF, NULL},
    [OVR_BUMP] = {"bump", dent, SET(height), SET(width), 0, DENT_HALF, NULL},
    [OVR_INDENT] = {"indent", indent, SET(depth), SET(width),
                    SET(shoulder) | SET(shoulder_at) | SET(shoulder_width),
                    BELL_HALF, NULL},
    [OVR_RIDGE] = {"ridge", ridge, HEIGHTS, SET(width), 0, BELL_HALF, NULL},
    [OVR_STEP] = {"step", step, HEIGHTS, 0, SET(length) | EDGES, NAN, NULL},
    [OVR_GROOVE] = {"groove", groove, HEIGHTS, SET(width), EDGES, 1, NULL},
    [OVR_WAVE] = {"wave", wave, SET(amplitude), SET(wavelength), 0, NAN, NULL},
    [OVR_CHIRP] = {"chirp", chirp, SET(amplitude),
                   SET(wavelength) | SET(wavelength_end) | SET(length),
                   SET(flank), NAN, NULL},
    [OVR_TEXTURE] = {"texture", texture, HEIGHTS, SET(width) | SET(wavelength),
                     0, 0.5, NULL},
    [OVR_PROFILE] = {"profile", tabulated, 0, 0, 0, NAN, "file"},
    [OVR_ROUGHNESS] = {"roughness", tabulated, 0, 0, 0, NAN, "Rq, length"},
    [OVR_AREAL] = {"areal", tabulated, 0, 0, 0, NAN, "file"},
};

/* Returns the sizes that a shape can have. An indentation with a rim has no own
 * width or shoulders. */
static unsigned allowed_sizes(int shape, bool rim)
{
    const struct rule *rule = &rules[shape];
    unsigned allowed = rule->tall | rule->needed | rule->allowed;
    if (rim)
        allowed = SET(depth) | RIM;
    else if (shape == OVR_INDENT)
        allowed |= SET(rim_diameter);
    if (allowed & SET(width))
        allowed |= WIDTHS & ~(unsigned)RIM;
    return allowed;
}

bool ovr_shape_has(int shape, const char *size)
{
    unsigned allowed = allowed_sizes(shape, false);
    if (shape == OVR_INDENT)
        allowed |= RIM;
    if (shape == OVR_ROUGHNESS)
        allowed |= SET(length);
    for (int k = 0; k < SIZES; k++)
        if (!strcmp(sizes[k].name, size))
            return allowed >> k & 1;
    return false;
}

const char *ovr_size_of_what(const char *size)
{
    bool shoulder = !strcmp(size, "shoulder_at") ||
                    !strcmp(size, "shoulder_width");
    return shoulder ? "shoulder" : NULL;
}

double ovr_shape_width_half(int shape)
{
    return ovr_shape_name(shape) ? rules[shape].half : NAN;
}

const char *ovr_shape_name(int shape)
{
    return shape >= 0 && shape < OVR_SHAPES ? rules[shape].name : NULL;
}

/* ------------------------------------------------------- reading of sizes */

static double size_of(const ovr_feature_form *form, const struct size *size)
{
    double value;
    memcpy(&value, (const char *)form + size->offset, sizeof value);
    return value;
}

static ovr_status check_size(const ovr_feature_form *form,
                             const struct size *size, unsigned allowed,
                             ovr_error *err)
{
    double value = size_of(form, size);
    const char *shape = rules[form->shape].name;
    if (!(allowed >> (size - sizes) & 1))
        return ovr_fail_about(err, size->name, "feature '%s': %s %s has no %s",
                              form->name, ovr_article(shape), shape,
                              size->name);
    if (isfinite(value) && (value > 0 || (size->zero && value == 0)))
        return OVR_OK;
    return ovr_fail_about(err, size->name, "feature '%s': %s = %g must be %s",
                          form->name, size->name, value,
                          size->zero ? "zero or positive" : "positive");
}

/* Lists the names of sizes: "depth or height", with `between` as separator. */
static const char *names_of(unsigned set, const char *between, char *text,
                            size_t capacity)
{
    size_t used = 0;
    text[0] = 0;
    for (int k = 0; k < SIZES; k++)
        if (set >> k & 1 && used < capacity) {
            int more = snprintf(text + used, capacity - used, "%s%s",
                                used ? between : "", sizes[k].name);
            used += more > 0 ? (size_t)more : capacity;
        }
    return text;
}

/* Joins the nonempty parts of a list. */
static void join(char *text, size_t capacity, const char *const *part,
                 size_t parts)
{
    size_t used = 0;
    text[0] = 0;
    for (size_t k = 0; k < parts; k++)
        if (part[k] && *part[k] && used < capacity) {
            int more = snprintf(text + used, capacity - used, "%s%s",
                                used ? ", " : "", part[k]);
            used += more > 0 ? (size_t)more : capacity;
        }
}

int ovr_shape_takes(int shape, char *text, size_t capacity)
{
    if (!text)
        return 0;
    const struct rule *rule = &rules[shape];
    unsigned allowed = rule->allowed, edge = EDGES;
    unsigned widths = WIDTHS &
                      ~(unsigned)(shape == OVR_INDENT ? SET(width)
                                                      : SET(width) | RIM);
    char tall[40], sizes_of[80], flank[40], needed[160], may[160];
    names_of(rule->tall, " or ", tall, sizeof tall);
    names_of(rule->needed, ", ", sizes_of, sizeof sizes_of);
    join(needed, sizeof needed, (const char *[]){tall, sizes_of, rule->made},
         3);
    names_of(allowed & ~edge, ", ", sizes_of, sizeof sizes_of);
    names_of(allowed & edge, " or ", flank, sizeof flank);
    join(may, sizeof may, (const char *[]){sizes_of, flank}, 2);
    int used = snprintf(text, capacity, "needs %s%s%s", needed,
                        *may ? "; may have " : "", may);
    if (!(rule->needed & SET(width)))
        return used;
    size_t left = (size_t)used < capacity ? capacity - (size_t)used : 0;
    return used + snprintf(left ? text + used : NULL, left,
                           ".  Instead of width: %s; at half its depth it is "
                           "%.3g of its width",
                           names_of(widths, " or ", sizes_of, sizeof sizes_of),
                           rule->half);
}

static const char *first_of(unsigned set)
{
    size_t k = 0;
    while (!(set >> k & 1))
        k++;
    return sizes[k].name;
}

/* Checks that exactly one size that determines the width is given. */
static ovr_status check_width(const ovr_feature_form *form, unsigned given,
                              ovr_error *err)
{
    unsigned widths = given & WIDTHS;
    char text[160];
    if (!(widths & (widths - 1)))
        return OVR_OK;
    return ovr_fail_about(err, first_of(widths & ~SET(width)),
                          "feature '%s': set only one of %s", form->name,
                          names_of(widths, " or ", text, sizeof text));
}

static ovr_status check_complete(const ovr_feature_form *form, unsigned given,
                                 ovr_error *err)
{
    const struct rule *rule = &rules[form->shape];
    unsigned missing = rule->needed & ~given, tall = rule->tall & given;
    char text[160];
    if (rule->tall && !tall)
        missing = rule->tall;
    else if (missing)
        missing &= ~(missing - 1); /* only the first */
    if (missing)
        return ovr_fail_about(err, first_of(missing),
                              "feature '%s': %s %s needs its %s", form->name,
                              ovr_article(rule->name), rule->name,
                              names_of(missing, " or ", text, sizeof text));
    if (tall & (tall - 1) || (given & EDGES) == EDGES)
        return ovr_fail_about(
            err, tall & (tall - 1) ? "height" : "radius",
            "feature '%s': set either %s, not both", form->name,
            tall & (tall - 1) ? "depth or height" : "flank or radius");
    return OVR_OK;
}

/* Checks that a rim is not higher than the indentation's depth and that a depth
 * is given. */
static ovr_status check_rim(const ovr_feature_form *form, ovr_error *err)
{
    if (isnan(form->rim_diameter) ||
        !(form->rim_height > form->depth || form->depth == 0))
        return OVR_OK;
    return ovr_fail_about(err, form->depth == 0 ? "depth" : "rim_height",
                          "feature '%s': depth = %g of an indent with a rim "
                          "must be positive and at least its rim_height",
                          form->name, form->depth);
}

static ovr_status check_form(const ovr_feature_form *form, ovr_error *err)
{
    bool rim = form->shape == OVR_INDENT && !isnan(form->rim_diameter);
    unsigned allowed = allowed_sizes((int)form->shape, rim), given = 0;
    ovr_status status = OVR_OK;
    for (int k = 0; k < SIZES; k++)
        if (!isnan(size_of(form, &sizes[k]))) {
            status = check_size(form, &sizes[k], allowed, err);
            if (status)
                return status;
            given |= 1U << k;
        }
    status = check_width(form, given, err);
    if (given & WIDTHS)
        given |= SET(width);
    if (!status)
        status = check_rim(form, err);
    return status ? status : check_complete(form, given, err);
}

static double or_else(double value, double otherwise)
{
    return isnan(value) ? otherwise : value;
}

/* Curvature in units of 1/R is d2S/dX2, so edges of radius r (in b) have
 * |A| max|sigma''|/flank^2 = R/r = 1/(r per_radius). */
static ovr_status find_flank(ovr_feature *f, const ovr_feature_form *form,
                             double per_radius, ovr_error *err)
{
    double otherwise = f->shape == OVR_GROOVE ? f->width / 4 : 0.25;
    if (f->shape == OVR_CHIRP)
        otherwise = fmax(f->wavelength, f->wavelength_end);
    f->flank = or_else(form->flank, otherwise);
    if (isnan(form->radius))
        return OVR_OK;
    if (!(per_radius > 0))
        return ovr_fail_about(
            err, "radius",
            "feature '%s': edge_radius needs a contact with dimensions "
            "(contact.radius and contact.modulus); set flank instead",
            f->name);
    f->flank = sqrt(STEEPEST * fabs(f->A) * form->radius * per_radius);
    if (!(f->flank > 0))
        f->flank = otherwise; /* arbitrary without a height */
    return OVR_OK;
}

static void set_sizes(ovr_feature *f, const ovr_feature_form *form)
{
    f->A = or_else(form->amplitude, or_else(form->height, -form->depth));
    f->width = or_else(form->width,
                       or_else(or_else(form->width_half, form->diameter),
                               2 * form->half_width) /
                           rules[form->shape].half);
    f->wavelength = form->wavelength;
    f->wavelength_end = form->wavelength_end;
    f->length = form->length;
    f->shoulder = or_else(form->shoulder, 0);
    f->shoulder_at = or_else(form->shoulder_at, f->width / 2);
    f->shoulder_width = or_else(form->shoulder_width, f->width / 2);
    if (!isnan(form->rim_diameter))
        ball_sizes(f, form->rim_diameter, form->rim_height);
}

/* Uses bisection for an indentation with shoulders, because they overlap its
 * flanks. */
double ovr_shape_diameter(const ovr_feature *f)
{
    double low = 0, high = f->ball ? f->shoulder_at : f->width;
    if (f->shape != OVR_INDENT || !(f->shoulder > 0))
        return f->width * rules[f->shape].half;
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        if (indent(f, middle) < 0.5 * indent(f, 0))
            low = middle;
        else
            high = middle;
    }
    return low + high;
}

/* -------------------------------------------------------------- extents */

static void set_extent(ovr_feature *f, double behind, double ahead, double cut,
                       double finest)
{
    f->behind = behind;
    f->ahead = ahead;
    f->reach_behind = cut * behind;
    f->reach_ahead = cut * ahead;
    f->finest = finest;
}

static void find_extent(ovr_feature *f)
{
    double half, w = f->width, l = f->flank;
    switch (f->shape) {
    case OVR_DENT:
    case OVR_BUMP:
    case OVR_RIDGE: set_extent(f, w, w, VANISHED, w); break;
    case OVR_INDENT:
        if (f->ball) { /* the inner flank of the rim counts as a quarter
                        * wavelength */
            double level = w * sqrt(-f->A / (f->shoulder - f->A));
            half = f->shoulder_at + sqrt(TEN_LN_10) * f->shoulder_width;
            set_extent(f, half, half, VANISHED, 4 * (f->shoulder_at - level));
            break;
        }
        half = fmax(w,
                    f->shoulder > 0 ? f->shoulder_at + f->shoulder_width : 0);
        set_extent(f, half, half, VANISHED,
                   f->shoulder > 0 ? fmin(w, f->shoulder_width) : w);
        break;
    case OVR_STEP:
        set_extent(f, or_else(f->length, INFINITY) + l / 2, l / 2, 1, 2 * l);
        break;
    case OVR_GROOVE:
        half = (w + l) / 2;
        set_extent(f, half, half, 1, 2 * l);
        break;
    case OVR_WAVE: set_extent(f, INFINITY, INFINITY, 1, f->wavelength); break;
    case OVR_CHIRP:
        set_extent(f, f->length / 2, f->length / 2, 1,
                   fmin(f->wavelength, f->wavelength_end));
        break;
    case OVR_TEXTURE: set_extent(f, INFINITY, INFINITY, 1, w); break;
    default: break; /* tabulated: set with the table */
    }
}

static ovr_status check_proportions(const ovr_feature *f, ovr_error *err)
{
    if (f->shape == OVR_TEXTURE && f->width > f->wavelength)
        return ovr_fail_about(err, "width",
                              "feature '%s': width = %g must not exceed the "
                              "wavelength = %g, the distance between two "
                              "dimples",
                              f->name, f->width, f->wavelength);
    if (f->shape == OVR_GROOVE && f->flank > f->width)
        return ovr_fail_about(
            err, "flank",
            "feature '%s': flank = %g must not exceed the width = %g, "
            "otherwise the bottom is never reached",
            f->name, f->flank, f->width);
    if (f->shape == OVR_CHIRP && 2 * f->flank > f->length)
        return ovr_fail_about(
            err, "length",
            "feature '%s': length = %g leaves no space for its two "
            "flanks of %g",
            f->name, f->length, f->flank);
    return OVR_OK;
}

ovr_status ovr_shape_make(ovr_feature *feature, const ovr_feature_form *form,
                          double per_radius, ovr_error *err)
{
    ovr_status status = check_form(form, err);
    if (status)
        return status;
    feature->shape = form->shape;
    set_sizes(feature, form);
    status = find_flank(feature, form, per_radius, err);
    if (!status)
        status = check_proportions(feature, err);
    if (!status)
        find_extent(feature);
    return status;
}

/* ----------------------------------------------------------- evaluation */

/* Returns the first index with X[i] >= limit; X increases. */
static size_t first_from(size_t n, const double *X, double limit)
{
    size_t low = 0, high = n;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (X[middle] < limit)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

double ovr_shape_height(const ovr_feature *f, double s)
{
    return rules[f->shape].height(f, s);
}

void ovr_shape_add(const ovr_feature *feature, double factor, double centre,
                   size_t n, const double *X, double *S)
{
    formula *height = rules[feature->shape].height;
    double end = centre + feature->reach_ahead;
    size_t i = first_from(n, X, centre - feature->reach_behind);
    for (; i < n && X[i] <= end; i++)
        S[i] += factor * height(feature, X[i] - centre);
}
