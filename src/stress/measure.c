/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Damage measures of a path, from its stored rows.
 *
 * tau on a plane at the angle phi to the surface is tau cos 2 phi - d sin 2 phi
 * = u . s, u = (-sin 2 phi, cos 2 phi): half the extent along u is the
 * amplitude on that plane and on the perpendicular one. tau_xz itself is exact;
 * the planes are 5.6 degrees apart, and the amplitude on the worst plane is too
 * low by at most 0.5 %, as is the radius of the circle (circle.c).
 */
#include <math.h>

#include "base/given.h"
#include "stress/cubic.h"
#include "stress/material_history.h"
#include "stress/stress.h"

/* ----------------------------------------------------------------- Measures */

/* Rows of one path; `pitch` apart. */
typedef struct path {
    const float *row;
    size_t pitch;
} path;

static double value(path p, int row)
{
    return p.row[(size_t)row * p.pitch];
}

static double half_range(path p, int m)
{
    return (value(p, OVR_ROW_HIGH + m) - value(p, OVR_ROW_LOW + m)) / 2;
}

static double circle(const ovr_material_history *p, path at)
{
    float radius;
    p->stress->loops->circles(1, at.row, at.pitch, &radius);
    return radius;
}

/* Direction of the largest half range; that of tau_xz if several are equal. */
static int direction_of_maximum_half_range(path p)
{
    int worst = OVR_HALF_DIRECTIONS / 2;
    for (int m = 0; m < OVR_HALF_DIRECTIONS; m++)
        if (half_range(p, m) > half_range(p, worst))
            worst = m;
    return worst;
}

/* Hydrostatic stress with the Poisson's ratio of the layer at this depth, or of
 * the body. */
static double hydrostatic(const ovr_material_history *p, size_t depth, double h)
{
    ovr_at_rest at = ovr_layered_rest(&p->stress->options, &p->range,
                                      p->stress->z[depth]);
    return (at.x + at.y) / 3 - 2. / 3 * (1 + at.poisson) * h;
}

static double measure(const ovr_material_history *p, ovr_measure which,
                      size_t depth, path at)
{
    switch (which) {
    case OVR_MEASURE_CIRCLE: return circle(p, at);
    case OVR_MEASURE_ORTHOGONAL: return half_range(at, OVR_HALF_DIRECTIONS / 2);
    case OVR_MEASURE_CRITICAL:
        return half_range(at, direction_of_maximum_half_range(at));
    case OVR_MEASURE_ANGLE:
        return 90. * direction_of_maximum_half_range(at) / OVR_HALF_DIRECTIONS -
               45;
    case OVR_MEASURE_VON_MISES: return sqrt(value(at, OVR_ROW_VON_MISES));
    case OVR_MEASURE_TRESCA: return value(at, OVR_ROW_TRESCA);
    case OVR_MEASURE_HYDRO_MAX:
        return hydrostatic(p, depth, value(at, OVR_ROW_H_MIN));
    default: return hydrostatic(p, depth, value(at, OVR_ROW_H_MAX));
    }
}

/* Interpolates between the points of level c: values by cubics through four
 * points, angles from the nearest point; `nodes` are values of the level. */
static double between(const ovr_material_history *p, const float *nodes, int c,
                      size_t k, bool nearest)
{
    long fine = p->first + (long)k, width = 1L << (c - p->finest);
    long floor_of = fine >= 0 ? fine / width : -((width - 1 - fine) / width);
    double t = (double)(fine - floor_of * width) / (double)width;
    const float *v = nodes + (floor_of - p->grid[c].first);
    if (nearest)
        return v[t > 0.5];
    return t == 0 ? v[0] : ovr_cubic(v, 1, t);
}

static void measure_depth(const ovr_material_history *p, ovr_measure which,
                          size_t depth, float *nodes, float *to)
{
    int c = p->stress->depth[depth].level;
    size_t points = p->grid[c].points;
    if (which == OVR_MEASURE_CIRCLE)
        p->stress->loops->circles(points, p->row[depth], points, nodes);
    for (size_t k = 0; k < points && which != OVR_MEASURE_CIRCLE; k++)
        nodes[k] = (float)measure(p, which, depth,
                                  (path){p->row[depth] + k, points});
    for (size_t k = 0; k < p->points; k++)
        to[k] = (float)between(p, nodes, c, k, which == OVR_MEASURE_ANGLE);
}

void ovr_material_history_measure(const ovr_material_history *history,
                                  ovr_measure which, float *to, double *smooth)
{
    if (!history)
        return;
    for (size_t j = 0; j < history->stress->depths; j++) {
        if (to)
            measure_depth(history, which, j, history->in_plane,
                          to + j * history->points);
        if (smooth)
            smooth[j] = measure(history, which, j,
                                (path){history->smooth + j * OVR_ROWS, 1});
    }
}

const char *ovr_criterion_name(ovr_criterion criterion)
{
    static const char *const names[] = {"circle",         "orthogonal",
                                        "critical-plane", "dang-van",
                                        "von-mises",      "tresca"};
    return names[criterion];
}

static ovr_measure measure_of(ovr_criterion criterion)
{
    switch (criterion) {
    case OVR_CRITERION_ORTHOGONAL: return OVR_MEASURE_ORTHOGONAL;
    case OVR_CRITERION_CRITICAL_PLANE: return OVR_MEASURE_CRITICAL;
    case OVR_CRITERION_VON_MISES: return OVR_MEASURE_VON_MISES;
    case OVR_CRITERION_TRESCA: return OVR_MEASURE_TRESCA;
    default: return OVR_MEASURE_CIRCLE;
    }
}

/* Adds alpha times the maximum tension of a path, if positive. */
static void add_tension(const ovr_material_history *p, double alpha, float *A,
                        double *smooth)
{
    for (size_t j = 0; j < p->stress->depths; j++) {
        int c = p->stress->depth[j].level;
        const float *h = p->row[j] + OVR_ROW_H_MIN * p->grid[c].points;
        for (size_t k = 0; A && k < p->points; k++) {
            double tension = hydrostatic(p, j, between(p, h, c, k, false));
            A[j * p->points + k] += (float)(alpha * fmax(tension, 0));
        }
        double h_min = p->smooth[j * OVR_ROWS + OVR_ROW_H_MIN];
        if (smooth)
            smooth[j] += alpha * fmax(hydrostatic(p, j, h_min), 0);
    }
}

ovr_status ovr_material_history_amplitude(const ovr_material_history *history,
                                          ovr_criterion criterion, double alpha,
                                          float *A, double *smooth,
                                          ovr_error *err)
{
    if (!history || !A || !smooth)
        return ovr_fail_null(err, __func__);
    if (isnan(alpha))
        return ovr_fail(err, OVR_BAD_INPUT, "alpha must be a number");
    if (criterion == OVR_CRITERION_DANG_VAN)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "Dang Van's criterion needs complete stress paths, "
                        "not their extents");
    ovr_material_history_measure(history, measure_of(criterion), A, smooth);
    if (criterion == OVR_CRITERION_CIRCLE && alpha > 0)
        add_tension(history, alpha, A, smooth);
    return OVR_OK;
}

/* ------------------------------------------------------------------- Values */

/* Stresses computed from h, d and tau: plane strain plus residual stresses. */

const char *ovr_stress_field_name(ovr_stress_field field)
{
    static const char *const names[OVR_STRESS_FIELDS] = {
        "sigma_x",   "sigma_z",   "tau_xz", "sigma_y",
        "von_mises", "max_shear", "tresca", "hydrostatic"};
    return names[field];
}

double ovr_stress_value(ovr_stress_field field, ovr_in_plane s, double poisson,
                        double residual_x, double residual_y)
{
    double x = s.d - s.h + residual_x, z = -s.d - s.h;
    double y = -2 * poisson * s.h + residual_y, middle = (x + z) / 2;
    double shear = hypot((x - z) / 2, s.tau), across = middle - y;
    switch (field) {
    case OVR_STRESS_SIGMA_X: return x;
    case OVR_STRESS_SIGMA_Z: return z;
    case OVR_STRESS_TAU_XZ: return s.tau;
    case OVR_STRESS_SIGMA_Y: return y;
    case OVR_STRESS_VON_MISES: return sqrt(3 * shear * shear + across * across);
    case OVR_STRESS_MAX_SHEAR: return shear;
    case OVR_STRESS_TRESCA: return fmax(shear, (fabs(across) + shear) / 2);
    default: return (x + y + z) / 3;
    }
}

/* Depth in mesh sizes D above which an unresolved pressure spike changes the
 * stresses.  The unresolved part of the load acts over a width of about D; its
 * stress at depth z is proportional to D/z (line load on a half plane). Below
 * 16 D it is less than a twentieth of the spike height. */
static const double SPIKE_DEPTH = 16;

double ovr_unresolved_depth(double mesh)
{
    return SPIKE_DEPTH * mesh;
}
