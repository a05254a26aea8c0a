/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Sharing of the load among pairs of teeth; xi in base pitches from A, e the
 * contact ratio.  Pairs stand at xi + j, j whole, within 0..e.
 *
 * rule       from 1/3 at A to 2/3 at B, 1, 2/3 at D to 1/3 at E
 * elastic    least potential energy, all pairs of the unit stiffness
 *                v(xi) = cos(b0 (xi - e/2)),  b0 = ((1 + e/2)^2/2 - 1)^(-1/2)
 *            spur     w_i = w v(xi_i)/sum_j v(xi_j)
 *            helical  w = F_n v(xi)/S, S the integral of v along all contact
 *                     lines (Pedrero et al., Mech. Mach. Theory 45 (2010) 780)
 * stiffness  springs c' v(xi_j) behind clearances e_j of tip relief: the
 *            deflection d solves sum_j c' v_j (d - e_j)+ = w
 *
 * Where one pair takes over the whole load its share would jump: with `blend`
 * it goes over by the quintic smoothstep about B and D.
 */
#include "elements/gear_sharing.h"

#include <math.h>

enum { PAIRS = 64 }; /* more than any gear pair has in contact */

/* Ends of the path are met by times that were computed: rounding must not let
 * a pair out. */
static const double slack = 1e-12;

static double unit_stiffness(double e, double xi)
{
    double b0 = 1 / sqrt(0.5 * (1 + e / 2) * (1 + e / 2) - 1);
    return cos(b0 * (xi - e / 2));
}

/* Compliance of a pair in the middle over that at xi: 1 there, less elsewhere
 * (Pedrero, Pleguezuelos, Artes & Antona, Mech. Mach. Theory 45 (2010) 780). */
static double stiffness_at(const ovr_gear_geometry *g, double xi)
{
    double e = g->contact_ratio;
    return xi < -slack || xi > e + slack ? 0 : unit_stiffness(e, xi);
}

double ovr_iso_stiffness(const ovr_gear_form *form, const ovr_gear_geometry *g,
                         bool *applies)
{
    double cosine = cos(form->helix_angle), base = cos(g->base_helix);
    double c = base * base * cosine;
    double zn1 = fabs(form->teeth_1 / c), zn2 = fabs(form->teeth_2 / c);
    double x1 = g->shift_1, x2 = g->shift_2;
    /* A ring gear has no finite number of teeth in this formula. */
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

/* The share `two` of a pair that is not alone, and 1 between B and D. */
static double alone(const ovr_gear_form *form, const ovr_gear_geometry *g,
                    double xi, double two)
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
    return alone(form, g, xi, (1 + fmax(rise, 0)) / 3);
}

static double by_energy(const ovr_gear_form *form, const ovr_gear_geometry *g,
                        double xi)
{
    double e = g->contact_ratio, own = unit_stiffness(e, xi);
    if (form->blend > 0) {
        /* The other pair of two, as if it touched on beyond its end. */
        double other = unit_stiffness(e, xi <= e / 2 ? xi + 1 : xi - 1);
        return alone(form, g, xi, own / (own + other));
    }
    double sum = 0;
    for (int j = -(int)xi - 1; xi + j <= e + slack; j++)
        sum += stiffness_at(g, xi + j);
    return own / sum;
}

/* -------------------------------------------------------------- springs */

static double relieved(double depth, double length, double way)
{
    return depth > 0 && length > 0 ? depth * fmax(0, 1 - way / length) : 0;
}

/* Clearance of a pair at xi, by the reliefs of both tips. */
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
    /* The pair of the largest clearance that does not touch is dropped, until
     * all that are left do. */
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
    const double *x = form->way;
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

/* Integral of v over the contact lines of all pairs, m. */
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

double ovr_gear_load(const ovr_gear_form *form, const ovr_gear_geometry *g,
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
