/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Smallest enclosing circles.
 *
 * From extents H_m = max over the path of u_m . s, in M = 32 directions: the
 * smallest R with H_m - u_m . c <= R for all m and some centre c.  The dual
 * problem maximizes sum lambda_m H_m over lambda >= 0 with sum lambda_m u_m = 0
 * and sum lambda_m = 1. Its corners have two opposite directions or three that
 * span the plane. R is therefore the maximum of (H_m + H_m')/2 and of the 1120
 * triples, with lambda_a : lambda_b : lambda_c = the sines of the angles
 * between the other two.  The result is at most the radius of the path's
 * circle, and at least cos(pi/32) times it. For points: the circle around a few
 * of them is computed; the farthest point outside is added to these until there
 * is none. The circle of the few is computed by Welzl's algorithm (Smallest
 * enclosing disks, 1991), without its shuffle.
 */
#include "stress/circle.h"

#include <math.h>

#include "stress/stress.h"

enum { M = 2 * OVR_HALF_DIRECTIONS };
static const double pi = 3.14159265358979323846;

/* Exact values for 0 and 1. */
double ovr_direction_cos(int m)
{
    return 2 * m == OVR_HALF_DIRECTIONS ? 0 : cos(pi * m / OVR_HALF_DIRECTIONS);
}

double ovr_direction_sin(int m)
{
    return 2 * m == OVR_HALF_DIRECTIONS ? 1 : sin(pi * m / OVR_HALF_DIRECTIONS);
}

/* sin(2 pi g / 32) */
static const double sine[M / 2] = {0,
                                   0.19509032201612825,
                                   0.38268343236508977,
                                   0.55557023301960218,
                                   0.70710678118654752,
                                   0.83146961230254524,
                                   0.92387953251128674,
                                   0.98078528040323043,
                                   1,
                                   0.98078528040323043,
                                   0.92387953251128674,
                                   0.83146961230254524,
                                   0.70710678118654752,
                                   0.55557023301960218,
                                   0.38268343236508977,
                                   0.19509032201612825};

static double of_triples(const double *H)
{
    double best = -INFINITY;
    for (int a = 0; a < M; a++)
        for (int b = a + 1; b < M && b - a < M / 2; b++)
            for (int c = a + M / 2 + 1; c < M && c - b < M / 2; c++) {
                double la = sine[c - b], lb = sine[M - c + a];
                double lc = sine[b - a];
                double R = (la * H[a] + lb * H[b] + lc * H[c]) / (la + lb + lc);
                best = R > best ? R : best;
            }
    return best;
}

double ovr_circle_of_extents(const double *high, const double *low)
{
    double H[M], best = 0;
    for (int m = 0; m < M / 2; m++) {
        H[m] = high[m];
        H[m + M / 2] = -low[m];
        best = fmax(best, (high[m] - low[m]) / 2);
    }
    return fmax(best, of_triples(H));
}

static bool holds(ovr_circle c, const float *p)
{
    return hypot(p[0] - c.d, p[1] - c.tau) <= c.radius * (1 + 1e-12);
}

static ovr_circle of_two(const float *a, const float *b)
{
    double d = ((double)a[0] + b[0]) / 2, t = ((double)a[1] + b[1]) / 2;
    return (ovr_circle){d, t, hypot(a[0] - d, a[1] - t)};
}

/* Circle through three points; for collinear points, around the outermost two.
 */
static ovr_circle of_three(const float *a, const float *b, const float *c)
{
    double bx = (double)b[0] - a[0], by = (double)b[1] - a[1];
    double cx = (double)c[0] - a[0], cy = (double)c[1] - a[1];
    double area = 2 * (bx * cy - by * cx), bb = bx * bx + by * by;
    double cc = cx * cx + cy * cy;
    if (fabs(area) <= 1e-14 * (bb + cc)) {
        ovr_circle ab = of_two(a, b), ac = of_two(a, c), bc = of_two(b, c);
        ovr_circle maximum = ab.radius > ac.radius ? ab : ac;
        return bc.radius > maximum.radius ? bc : maximum;
    }
    double x = (cy * bb - by * cc) / area, y = (bx * cc - cx * bb) / area;
    return (ovr_circle){a[0] + x, a[1] + y, hypot(x, y)};
}

/* Smallest circle around the first n points, with a and b on it. */
static ovr_circle with_two(size_t n, const float *p, const float *a,
                           const float *b)
{
    ovr_circle c = of_two(a, b);
    for (size_t k = 0; k < n; k++)
        if (!holds(c, p + 2 * k))
            c = of_three(a, b, p + 2 * k);
    return c;
}

/* Smallest circle around the first n points, with a on it. */
static ovr_circle with_one(size_t n, const float *p, const float *a)
{
    ovr_circle c = {a[0], a[1], 0};
    for (size_t k = 0; k < n; k++)
        if (!holds(c, p + 2 * k))
            c = with_two(k, p, a, p + 2 * k);
    return c;
}

ovr_circle ovr_minimum_circle(size_t n, const float *points)
{
    if (!points)
        return (ovr_circle){0};
    ovr_circle c = {0, 0, 0};
    if (n == 0)
        return c;
    enum { ROUNDS = 60 };
    float rim[2 * ROUNDS];
    size_t count = 0;
    c = (ovr_circle){points[0], points[1], 0};
    for (int round = 0; round < ROUNDS; round++) {
        size_t farthest = 0;
        double maximum = 0;
        for (size_t k = 0; k < n; k++) {
            double r = hypot(points[2 * k] - c.d, points[2 * k + 1] - c.tau);
            if (r > maximum)
                maximum = r, farthest = k;
        }
        if (maximum <= c.radius * (1 + 1e-12))
            return c;
        rim[2 * count] = points[2 * farthest];
        rim[2 * count + 1] = points[2 * farthest + 1];
        count++;
        for (size_t k = 0; k < count; k++)
            if (k == 0)
                c = (ovr_circle){rim[0], rim[1], 0};
            else if (!holds(c, rim + 2 * k))
                c = with_one(k, rim, rim + 2 * k);
    }
    return c;
}

double ovr_dang_van(size_t n, const float *points, const float *hydrostatic,
                    double alpha)
{
    if (!points || !hydrostatic)
        return NAN;
    ovr_circle c = ovr_minimum_circle(n, points);
    double maximum = -INFINITY;
    for (size_t k = 0; k < n; k++) {
        double r = hypot(points[2 * k] - c.d, points[2 * k + 1] - c.tau);
        maximum = fmax(maximum, r + alpha * hydrostatic[k]);
    }
    return maximum;
}
