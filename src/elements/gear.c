/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Involute gears on parallel axes: the contact along the line of action.
 *
 *   tan at = tan an/cos b,  mt = m/cos b,  d_k = z_k mt,  rb_k = d_k cos(at)/2
 *   sin bb = sin b cos an
 *   inv aw = inv at + 2 (x1 + x2) tan an/(z1 + z2),  a = a_d cos at/cos aw
 *   L = a sin aw,  p = pi mt cos at,  s = sign z2
 *   R1_A = L - s sqrt(da2^2/4 - rb2^2),  R1_E = sqrt(da1^2/4 - rb1^2)
 *
 * z2 < 0 is an internal gear. At the distance R1 from the base circle of gear 1
 * the flanks have the radii R1 and L - R1 and the speeds omega_k R_k.
 *
 * Helical teeth touch along lines that lie in the plane of action at the angle
 * bb to the axes. The speed across such a line is the transverse speed. Radii
 * across it are the transverse radii divided by cos bb.
 *
 * Source: Niemann & Winter, Maschinenelemente 2; ISO 21771.
 */
#include <math.h>
#include <stdlib.h>

#include "base/arena.h"
#include "base/error.h"
#include "elements/elements.h"

/* ------------------------------------------------------ Sharing of the load */

/*
 * Load sharing among pairs of teeth. xi: position in base pitches from A; e:
 * contact ratio. The pairs in contact are at xi + j with integer j, within
 * 0..e.
 *
 *     rule       from 1/3 at A to 2/3 at B, 1, 2/3 at D to 1/3 at E
 *     elastic    minimum potential energy, all pairs of the unit stiffness
 *                v(xi) = cos(b0 (xi - e/2)),
 *                b0 = ((1 + e/2)^2/2 - 1)^(-1/2)
 *                spur:    w_i = w v(xi_i)/sum_j v(xi_j)
 *                helical: w = F_n v(xi)/S, S the integral of v along all
 *                contact lines (Pedrero et al., Mech. Mach. Theory 45 (2010)
 *                780)
 *     stiffness  springs c' v(xi_j) with clearances e_j of tip relief: the
 *                deflection d solves sum_j c' v_j (d - e_j)+ = w
 *
 * At B and D the load share would jump. With `blend` it changes by the quintic
 * smoothstep around B and D.
 */

enum { PAIRS = 64 }; /* more than any gear pair has in contact */

/* Tolerance for times computed at the ends of the path: rounding must not
 * separate a pair. */
static const double slack = 1e-12;

static double unit_stiffness(double e, double xi)
{
    double b0 = 1 / sqrt(0.5 * (1 + e / 2) * (1 + e / 2) - 1);
    return cos(b0 * (xi - e / 2));
}

/* Returns the stiffness of a pair relative to that in the middle of the path: 1
 * there, less elsewhere (Pedrero, Pleguezuelos, Artes & Antona, Mech. Mach.
 * Theory 45 (2010) 780). */
static double stiffness_at(const ovr_gear_geometry *g, double xi)
{
    double e = g->contact_ratio;
    return xi < -slack || xi > e + slack ? 0 : unit_stiffness(e, xi);
}

/* Returns c' of ISO 6336-1 in N/m2; *applies: the profile shifts are in the
 * range of the standard. */
static double iso_stiffness(const ovr_gear_form *form,
                            const ovr_gear_geometry *g, bool *applies)
{
    double cosine = cos(form->helix_angle), base = cos(g->base_helix);
    double c = base * base * cosine;
    double zn1 = fabs(form->teeth_1 / c), zn2 = fabs(form->teeth_2 / c);
    double x1 = g->shift_1, x2 = g->shift_2;
    /* A ring gear has infinitely many teeth in this formula. */
    double one = form->teeth_1 > 0 ? 1 / zn1 : 0;
    double two = form->teeth_2 > 0 ? 1 / zn2 : 0;
    double q = 0.04723 + 0.15551 * one + 0.25791 * two - 0.00635 * x1 -
               0.11654 * x1 * one - 0.00193 * x2 - 0.24188 * x2 * two +
               0.00529 * x1 * x1 + 0.00182 * x2 * x2;
    *applies = form->teeth_1 > 0 && form->teeth_2 > 0 && zn1 <= zn2 &&
               x1 >= x2 && x1 + x2 >= -0.5 && x1 + x2 <= 2;
    return 0.8 * cosine / q * 1e9; /* N/(mm um) is 1e9 N/m2 */
}

/* ------------------------------------------------------------ at B and D */

static double smoothstep(double y)
{
    if (y <= 0)
        return 0;
    return y >= 1 ? 1 : y * y * y * (10 + y * (6 * y - 15));
}

/* Returns the share of a pair: `two` if two pairs are in contact, and 1 between
 * B and D. */
static double blended_share(const ovr_gear_form *form,
                            const ovr_gear_geometry *g, double xi, double two)
{
    double e = g->contact_ratio, B = e - 1, D = 1;
    if (form->blend > 0)
        two += (1 - two) * smoothstep((xi - B) / form->blend + 0.5) *
               smoothstep((D - xi) / form->blend + 0.5);
    else if (xi > B && xi < D)
        two = 1;
    return two;
}

static double by_rule(const ovr_gear_form *form, const ovr_gear_geometry *g,
                      double xi)
{
    double e = g->contact_ratio;
    double rise = fmin(1, fmin(xi, e - xi) / (e - 1));
    return blended_share(form, g, xi, (1 + fmax(rise, 0)) / 3);
}

static double by_energy(const ovr_gear_form *form, const ovr_gear_geometry *g,
                        double xi)
{
    double e = g->contact_ratio, own = unit_stiffness(e, xi);
    if (form->blend > 0) {
        /* Stiffness of the other tooth pair, continued beyond the end of its
         * path of contact. */
        double other = unit_stiffness(e, xi <= e / 2 ? xi + 1 : xi - 1);
        return blended_share(form, g, xi, own / (own + other));
    }
    double sum = 0;
    for (int j = -(int)xi - 1; xi + j <= e + slack; j++)
        sum += stiffness_at(g, xi + j);
    return own / sum;
}

/* -------------------------------------------------------------- springs */

static double relieved(double depth, double length, double distance)
{
    return depth > 0 && length > 0 ? depth * fmax(0, 1 - distance / length) : 0;
}

/* Returns the clearance of a pair at xi due to the tip reliefs of both
 * gears. */
static double clearance(const ovr_gear_form *form, const ovr_gear_geometry *g,
                        double xi)
{
    double long_relief = g->R1_B - g->R1_A;
    double length_1 = isnan(form->relief_length_1) ? long_relief
                                                   : form->relief_length_1;
    double length_2 = isnan(form->relief_length_2) ? long_relief
                                                   : form->relief_length_2;
    return relieved(form->relief_2, length_2, xi * g->base_pitch) +
           relieved(form->relief_1, length_1,
                    (g->contact_ratio - xi) * g->base_pitch);
}

static double by_springs(const ovr_gear_form *form, const ovr_gear_geometry *g,
                         double xi)
{
    double c = g->mesh_stiffness, whole = g->transverse_force / form->face;
    double own = clearance(form, g, xi), e = g->contact_ratio;
    double stiff[PAIRS], gap[PAIRS], deflection = 0;
    int pairs = 0;
    for (int j = -(int)xi - 1; xi + j <= e + slack && pairs < PAIRS; j++) {
        stiff[pairs] = c * stiffness_at(g, xi + j);
        gap[pairs] = clearance(form, g, xi + j);
        pairs += stiff[pairs] > 0;
    }
    /* The separated pair with the largest clearance is dropped until all
     * remaining pairs are in contact. */
    for (;;) {
        double load = whole, sum = 0;
        int last = 0;
        for (int k = 0; k < pairs; k++) {
            load += stiff[k] * gap[k];
            sum += stiff[k];
            last = gap[k] > gap[last] ? k : last;
        }
        deflection = load / sum;
        if (pairs <= 1 || deflection > gap[last])
            break;
        pairs--;
        stiff[last] = stiff[pairs];
        gap[last] = gap[pairs];
    }
    return c * stiffness_at(g, xi) * fmax(0, deflection - own) / whole;
}

/* ---------------------------------------------------------------- table */

static double by_table(const ovr_gear_form *form, double xi)
{
    const double *x = form->distance;
    size_t k = 1;
    if (xi <= x[0])
        return form->share[0];
    if (xi >= x[form->shares - 1])
        return form->share[form->shares - 1];
    while (x[k] < xi)
        k++;
    double part = (xi - x[k - 1]) / (x[k] - x[k - 1]);
    return form->share[k - 1] + part * (form->share[k] - form->share[k - 1]);
}

/* -------------------------------------------------------------- helical */

/* Returns the integral of v over the contact lines of all pairs, in m. */
static double along_lines(const ovr_gear_form *form, const ovr_gear_geometry *g,
                          double xi)
{
    double e = g->contact_ratio, overlap = g->overlap_ratio, sum = 0;
    double b0 = 1 / sqrt(0.5 * (1 + e / 2) * (1 + e / 2) - 1);
    int reach = (int)ceil(e + overlap) + 1;
    for (int j = -reach; j <= reach; j++) {
        double low = fmax(0, xi + j - overlap * (1 - form->slice));
        double high = fmin(e, xi + j + overlap * form->slice);
        if (high > low)
            sum += (sin(b0 * (high - e / 2)) - sin(b0 * (low - e / 2))) / b0;
    }
    return sum * form->face / (overlap * cos(g->base_helix));
}

/* Returns the load per length of the contact line, N/m, at xi base pitches from
 * A.  The unit load of spur gears is the whole load per face width. */
static double gear_load(const ovr_gear_form *form, const ovr_gear_geometry *g,
                        double xi)
{
    double whole = g->transverse_force / form->face;
    xi = fmin(fmax(xi, 0), g->contact_ratio);
    if (g->overlap_ratio > 0)
        return g->normal_force * stiffness_at(g, xi) / along_lines(form, g, xi);
    switch (form->sharing) {
    case OVR_SHARING_RULE: return whole * by_rule(form, g, xi);
    case OVR_SHARING_ELASTIC: return whole * by_energy(form, g, xi);
    case OVR_SHARING_STIFFNESS: return whole * by_springs(form, g, xi);
    case OVR_SHARING_TABLE: break;
    }
    return whole * by_table(form, xi);
}

/* ---------------------------------------------------------------- Gear pair */

static const double pi = 3.14159265358979323846;

struct ovr_gear {
    ovr_gear_form form;
    ovr_gear_geometry g;
    ovr_arena arena;
};

ovr_gear_form ovr_gear_form_default(void)
{
    return (ovr_gear_form){.module = NAN,
                           .pressure_angle = 20 * pi / 180,
                           .centre = NAN,
                           .addendum = 1,
                           .tip_1 = NAN,
                           .tip_2 = NAN,
                           .face = NAN,
                           .speed = NAN,
                           .driving = 1,
                           .torque = NAN,
                           .sharing = OVR_SHARING_ELASTIC,
                           .blend = 0.05,
                           .relief_length_1 = NAN,
                           .relief_length_2 = NAN,
                           .mesh_stiffness = NAN,
                           .slice = 0.5,
                           .min_share = 0.02,
                           .min_radius = 0.05};
}

static double involute(double angle)
{
    return tan(angle) - angle;
}

/* Returns the angle whose involute function is `value`. Newton's iteration
 * starts from above, where it always converges because inv is convex. */
static double inverse_involute(double value)
{
    double angle = fmin(1.5, cbrt(3 * value) + 0.1);
    for (int k = 0; k < 60; k++) {
        double slope = tan(angle) * tan(angle);
        double change = (involute(angle) - value) / slope;
        angle -= change;
        if (fabs(change) < 1e-16)
            break;
    }
    return angle;
}

/* --------------------------------------------------------------- checks */

static ovr_status check_numbers(const ovr_gear_form *f, ovr_error *err)
{
    const ovr_needed all[] = {{"module", f->module, false},
                              {"face", f->face, false},
                              {"speed", fabs(f->speed), false},
                              {"torque", fabs(f->torque), false},
                              {"addendum", f->addendum, false}};
    if (ovr_check_needed(all, sizeof all / sizeof *all, err))
        return OVR_BAD_INPUT;
    if (!(f->pressure_angle > 0 && f->pressure_angle < pi / 3))
        return ovr_fail_about(err, "pressure_angle",
                              "pressure_angle: must be between 0 and 60 deg");
    if (!(fabs(f->helix_angle) < pi / 2.2))
        return ovr_fail_about(err, "helix_angle",
                              "helix_angle: must be below 80 deg");
    if (!(f->slice >= 0 && f->slice <= 1))
        return ovr_fail_about(err, "slice", "slice = %g: must be 0 to 1",
                              f->slice);
    if (f->driving != 1 && f->driving != 2)
        return ovr_fail_about(err, "driving", "driving = %d: must be 1 or 2",
                              f->driving);
    return OVR_OK;
}

static ovr_status check_teeth(const ovr_gear_form *f, ovr_error *err)
{
    int one = f->teeth_1, two = f->teeth_2, fewer = abs(one), more = abs(two);
    if (abs(one) < 5 || abs(two) < 5)
        return ovr_fail_about(err, abs(one) < 5 ? "teeth_1" : "teeth_2",
                              "teeth_%d = %d: must be 5 or more",
                              abs(one) < 5 ? 1 : 2, abs(one) < 5 ? one : two);
    if (one < 0)
        return ovr_fail_about(
            err, "teeth_1",
            two < 0 ? "teeth_1 = %d, teeth_2 = %d: at most one gear can be "
                      "internal (negative number of teeth)"
                    : "teeth_1 = %d, teeth_2 = %d: the internal gear must be "
                      "gear 2; driving = 1 or 2 selects the driving gear",
            one, two);
    if (two < 0 && more - fewer < 8)
        return ovr_fail_about(err, "teeth_2",
                              "teeth_2 = %d, teeth_1 = %d: an internal gear "
                              "needs at least 8 teeth more than its pinion",
                              two, one);
    return OVR_OK;
}

static ovr_status check_sharing(const ovr_gear_form *f, ovr_error *err)
{
    bool helical = f->helix_angle != 0;
    bool relieved = f->relief_1 > 0 || f->relief_2 > 0;
    if (helical && f->sharing != OVR_SHARING_ELASTIC)
        return ovr_fail_about(err, "sharing",
                              "sharing: must be elastic for helical teeth");
    if (relieved && f->sharing != OVR_SHARING_STIFFNESS)
        return ovr_fail_about(err, f->relief_1 > 0 ? "relief_1" : "relief_2",
                              "tip relief needs sharing = stiffness");
    if (!(f->blend >= 0 && f->blend <= 0.5))
        return ovr_fail_about(err, "blend", "blend = %g: must be 0 to 0.5",
                              f->blend);
    if (f->sharing != OVR_SHARING_TABLE)
        return OVR_OK;
    if (f->shares < 2)
        return ovr_fail_about(err, "file",
                              "sharing = table needs at least two points");
    for (size_t k = 0; k < f->shares; k++) {
        if (!(f->share[k] >= 0 && f->share[k] <= 1))
            return ovr_fail_about(err, "file",
                                  "point %zu: a share of %g, must be 0 to 1",
                                  k + 1, f->share[k]);
        if (!isfinite(f->distance[k]) ||
            (k && !(f->distance[k] > f->distance[k - 1])))
            return ovr_fail_about(err, "file",
                                  "point %zu: positions must "
                                  "increase",
                                  k + 1);
    }
    return OVR_OK;
}

/* ------------------------------------------------------------- geometry */

/* Computes profile shifts and centre distance, one of which follows from the
 * others. */
static ovr_status mesh(const ovr_gear_form *f, ovr_gear_geometry *g, double at,
                       ovr_error *err)
{
    double teeth = f->teeth_1 + f->teeth_2, tangent = tan(f->pressure_angle);
    double reference = (g->d_1 + g->d_2) / 2; /* a_d, signed */
    g->shift_1 = f->shift_1;
    g->shift_2 = f->shift_2;
    if (isnan(f->centre)) {
        double sum, value;
        if (isnan(f->shift_1) || isnan(f->shift_2))
            return ovr_fail_about(err,
                                  isnan(f->shift_1) ? "shift_1" : "shift_2",
                                  "shift_1 and shift_2 must both be set "
                                  "without centre");
        sum = f->shift_1 + f->shift_2;
        value = involute(at) + 2 * sum * tangent / teeth;
        if (!(value > 0))
            return ovr_fail_about(err, "shift_1",
                                  "shift_1 + shift_2 = %g: gears do not mesh "
                                  "with this sum of profile shifts",
                                  sum);
        g->working_angle = inverse_involute(value);
        g->centre = fabs(reference * cos(at) / cos(g->working_angle));
        return OVR_OK;
    }
    if (!isnan(f->shift_1) && !isnan(f->shift_2))
        return ovr_fail_about(err, "centre",
                              "shift_1, shift_2 and centre determine each "
                              "other; remove one of them");
    double cosine = fabs(reference) * cos(at) / f->centre;
    if (!(cosine < 1))
        return ovr_fail_about(err, "centre",
                              "cos(working pressure angle) = %.4g: centre must "
                              "be above %.6g mm",
                              cosine, 1e3 * fabs(reference) * cos(at));
    g->centre = f->centre;
    g->working_angle = acos(cosine);
    double sum = (involute(g->working_angle) - involute(at)) * teeth /
                 (2 * tangent);
    if (isnan(f->shift_1) && isnan(f->shift_2))
        return ovr_fail_about(err, "shift_1",
                              "centre: set shift_1 or shift_2, whose sum is "
                              "%.6g",
                              sum);
    if (isnan(f->shift_2))
        g->shift_2 = sum - f->shift_1;
    else
        g->shift_1 = sum - f->shift_2;
    return OVR_OK;
}

static ovr_status tips(const ovr_gear_form *f, ovr_gear_geometry *g,
                       ovr_error *err)
{
    double m = f->module, s = f->teeth_2 < 0 ? -1 : 1;
    double reference = (g->d_1 + g->d_2) / 2;
    g->shortening = (s * g->centre - reference) / m - g->shift_1 - g->shift_2;
    double height = f->addendum + g->shortening;
    g->tip_1 = isnan(f->tip_1) ? g->d_1 + 2 * m * (height + g->shift_1)
                               : f->tip_1;
    g->tip_2 = isnan(f->tip_2)
                   ? fabs(g->d_2) + 2 * s * m * (height + g->shift_2)
                   : f->tip_2;
    if (!(g->tip_1 > 2 * g->base_1))
        return ovr_fail_about(err, "tip_1",
                              "tip_1 = %.6g mm is inside the base circle of "
                              "%.6g mm",
                              1e3 * g->tip_1, 2e3 * g->base_1);
    if (!(g->tip_2 > 2 * fabs(g->base_2)))
        return ovr_fail_about(err, "tip_2",
                              "tip_2 = %.6g mm is inside the base circle of "
                              "%.6g mm",
                              1e3 * g->tip_2, 2e3 * fabs(g->base_2));
    return OVR_OK;
}

static ovr_status path(const ovr_gear_form *f, ovr_gear_geometry *g,
                       ovr_error *err)
{
    double s = f->teeth_2 < 0 ? -1 : 1;
    g->line = s * g->centre * sin(g->working_angle);
    g->R1_A = g->line -
              s * sqrt(g->tip_2 * g->tip_2 / 4 - g->base_2 * g->base_2);
    g->R1_E = sqrt(g->tip_1 * g->tip_1 / 4 - g->base_1 * g->base_1);
    g->R1_B = g->R1_E - g->base_pitch;
    g->R1_D = g->R1_A + g->base_pitch;
    g->R1_C = g->base_1 * tan(g->working_angle);
    g->contact_ratio = (g->R1_E - g->R1_A) / g->base_pitch;
    g->overlap_ratio = f->face * sin(fabs(f->helix_angle)) / (pi * f->module);
    if (g->R1_A <= 0)
        return ovr_fail_about(
            err, "tip_2",
            "the tip of gear 2 reaches below the base circle of gear 1 by "
            "%.3g mm (interference); use a smaller tip_2, a larger shift_1 "
            "or more teeth_1",
            -1e3 * g->R1_A);
    if (s > 0 && g->R1_E >= g->line)
        return ovr_fail_about(
            err, "tip_1",
            "the tip of gear 1 reaches below the base circle of gear 2 by "
            "%.3g mm (interference); use a smaller tip_1, a larger shift_2 "
            "or more teeth_2",
            1e3 * (g->R1_E - g->line));
    if (!(g->contact_ratio > 1) &&
        !(f->helix_angle != 0 && g->contact_ratio > 0 &&
          g->contact_ratio + g->overlap_ratio > 1))
        return ovr_fail_about(err, "teeth_1",
                              "contact ratio %.4g is below 1: at times no "
                              "tooth pair is in contact",
                              g->contact_ratio);
    if (f->helix_angle == 0 && g->contact_ratio > 2 &&
        (f->sharing == OVR_SHARING_RULE ||
         (f->sharing == OVR_SHARING_ELASTIC && f->blend > 0)))
        return ovr_fail_about(err, "sharing",
                              "contact ratio %.4g: above 2, where two or "
                              "more pairs are always in contact, sharing "
                              "must be stiffness (with tip relief) or table",
                              g->contact_ratio);
    return OVR_OK;
}

static void move(const ovr_gear_form *f, ovr_gear_geometry *g)
{
    g->omega_1 = fabs(f->speed);
    g->omega_2 = g->omega_1 * f->teeth_1 / abs(f->teeth_2);
    g->transverse_force = fabs(f->torque) / g->base_1;
    g->normal_force = g->transverse_force / cos(g->base_helix);
    g->whole_load = g->normal_force * cos(g->base_helix) / f->face;
    g->duration = (g->R1_E - g->R1_A) / (g->base_1 * g->omega_1);
    double iso = iso_stiffness(f, g, &g->iso_applies);
    g->mesh_stiffness = isnan(f->mesh_stiffness) ? iso : f->mesh_stiffness;
    double b0 = 1 / sqrt(0.5 * pow(1 + g->contact_ratio / 2, 2) - 1);
    /* The integral of v over the path is the mean over a base pitch of the sum
     * over all pairs. */
    g->stiffness_sum = 2 * sin(b0 * g->contact_ratio / 2) / b0;
}

/* -------------------------------------------- part of the path in contact */

static double xi_at(const ovr_gear *gear, double t)
{
    const ovr_gear_geometry *g = &gear->g;
    double distance = t * g->base_1 * g->omega_1 / g->base_pitch;
    return gear->form.driving == 1 ? distance : g->contact_ratio - distance;
}

/* True if the load and the radius of curvature of the flanks are large
 * enough. */
static bool runs(const ovr_gear *gear, double t)
{
    const ovr_gear_form *f = &gear->form;
    const ovr_gear_geometry *g = &gear->g;
    double xi = xi_at(gear, t), whole = g->transverse_force / f->face;
    double R1 = g->R1_A + xi * g->base_pitch, minimum = f->min_radius * g->line;
    if (f->teeth_2 > 0 && (R1 < minimum || g->line - R1 < minimum))
        return false;
    return gear_load(f, g, xi) > f->min_share * whole;
}

/* Bisects for the time at which the tooth pair enters or leaves contact, given
 * one time in contact and one out of contact. */
static double find_contact_limit(const ovr_gear *gear, double in, double out)
{
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (in + out);
        if (runs(gear, middle))
            in = middle;
        else
            out = middle;
    }
    return in;
}

static ovr_status clip(ovr_gear *gear, ovr_error *err)
{
    enum { LOOKS = 4000 };
    ovr_gear_geometry *g = &gear->g;
    int first = 0, last = LOOKS;
    while (first < LOOKS && !runs(gear, first * g->duration / LOOKS))
        first++;
    while (last > first && !runs(gear, last * g->duration / LOOKS))
        last--;
    if (last <= first)
        return ovr_fail_about(err, "min_share",
                              "no part of the path carries more than "
                              "min_share = %g of the load",
                              gear->form.min_share);
    g->begin = first ? find_contact_limit(gear, first * g->duration / LOOKS,
                                          (first - 1) * g->duration / LOOKS)
                     : 0;
    g->end = last < LOOKS ? find_contact_limit(gear, last * g->duration / LOOKS,
                                               (last + 1) * g->duration / LOOKS)
                          : g->duration;
    return OVR_OK;
}

/* ------------------------------------------------------------- creation */

static ovr_status make(ovr_gear *gear, ovr_error *err)
{
    const ovr_gear_form *f = &gear->form;
    ovr_gear_geometry *g = &gear->g;
    ovr_status status;
    if ((status = check_numbers(f, err)) || (status = check_teeth(f, err)) ||
        (status = check_sharing(f, err)))
        return status;
    double cosine = cos(f->helix_angle), mt = f->module / cosine;
    double at = atan(tan(f->pressure_angle) / cosine);
    g->d_1 = f->teeth_1 * mt;
    g->d_2 = f->teeth_2 * mt;
    g->base_1 = g->d_1 * cos(at) / 2;
    g->base_2 = g->d_2 * cos(at) / 2;
    g->base_pitch = pi * mt * cos(at);
    g->base_helix = asin(sin(fabs(f->helix_angle)) * cos(f->pressure_angle));
    if ((status = mesh(f, g, at, err)) || (status = tips(f, g, err)) ||
        (status = path(f, g, err)))
        return status;
    move(f, g);
    return clip(gear, err);
}

static ovr_status copy_table(ovr_gear_form *form, ovr_arena *arena,
                             ovr_error *err)
{
    size_t n = form->sharing == OVR_SHARING_TABLE ? form->shares : 0;
    double *distance = ovr_arena_take(arena, n, sizeof *distance, err);
    double *share = ovr_arena_take(arena, n, sizeof *share, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < n; k++) {
        distance[k] = form->distance[k];
        share[k] = form->share[k];
    }
    form->distance = distance;
    form->share = share;
    return OVR_OK;
}

ovr_gear *ovr_gear_create(const ovr_gear_form *form,
                          const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_gear *gear;
    if (!form) {
        ovr_fail(err, OVR_BAD_INPUT, "the input argument (gear) is NULL");
        return NULL;
    }
    gear = ovr_arena_take(&arena, 1, sizeof *gear, err);
    if (gear) {
        gear->form = *form;
        if (!copy_table(&gear->form, &arena, err) && !make(gear, err)) {
            gear->arena = arena;
            return gear;
        }
    }
    ovr_arena_release(&arena);
    return NULL;
}

void ovr_gear_free(ovr_gear *gear)
{
    if (gear) {
        ovr_arena arena = gear->arena;
        ovr_arena_release(&arena);
    }
}

const ovr_gear_geometry *ovr_gear_of(const ovr_gear *gear)
{
    return gear ? &gear->g : NULL;
}

const ovr_gear_form *ovr_gear_form_of(const ovr_gear *gear)
{
    return gear ? &gear->form : NULL;
}

/* -------------------------------------------------------------- the contact */

ovr_element_moment ovr_gear_at(const ovr_gear *gear, double t)
{
    if (!gear)
        return (ovr_element_moment){0};
    const ovr_gear_geometry *g = &gear->g;
    double xi = xi_at(gear, t), along = cos(g->base_helix);
    double R1 = g->R1_A + xi * g->base_pitch, R2 = g->line - R1;
    return (ovr_element_moment){.t = t,
                                .R = R1 * R2 / (g->line * along),
                                .R_1 = R1 / along,
                                .R_2 = R2 / along,
                                .u1 = g->omega_1 * R1,
                                .u2 = g->omega_2 * fabs(R2),
                                .load = gear_load(&gear->form, g, xi)};
}

double ovr_gear_time(const ovr_gear *gear, double R1)
{
    if (!gear)
        return NAN;
    const ovr_gear_geometry *g = &gear->g;
    double distance = gear->form.driving == 1 ? R1 - g->R1_A : g->R1_E - R1;
    return distance / (g->base_1 * g->omega_1);
}
