/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Potentials of elements, with the mesh D as unit of length (C is the same in
 * every unit, C' is proportional to 1/D) and ln w with its argument in (0, pi):
 *
 *     point    C = i/(pi w)
 *     hat      C = i/pi sum_j c_j (w - j) ln(w - j),      c = 1, -2, 1
 *     B-spline C = i/(6 pi) sum_j c_j (w - j)^3 ln(w - j), c = 1, -4, 6, -4, 1
 *
 * The cardinal spline, 1 at its node and 0 at all others, is sum_m a_m B(. -
 * m), a_m = sqrt 3 (sqrt 3 - 2)^|m|.  The sums suffer from cancellation at
 * large distances. They are therefore computed in long double; beyond 100 mesh
 * sizes the point element is used, which differs from the spline by O(w^-4).
 * Point elements are equivalent to the trapezoidal rule, whose error at depth z
 * is exp(-2 pi z/D): 1e-11 from 4 D downward, where splines are not better.
 * Above, the error of splines is O(D^4) and that of hat functions O(D^2); the
 * latter multiply every wave by sinc^2(k D/2).
 */
#include "stress/element.h"
#include "stress/stress.h"

#include <math.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;
enum { SPLINE_REACH = 100, SPLINE_TAIL = 40 };

typedef long double complex precise;

/* sum_j c_j (w - j)^power ln(w - j), j = -size/2 ... size/2 */
static precise differences(precise w, int size, const int *c, int power)
{
    precise sum = 0;
    const int middle = size / 2;
    for (int k = 0; k < size; k++) {
        precise v = w - (long double)(k - middle), term = clogl(v);
        for (int p = 0; p < power; p++)
            term *= v;
        sum += (long double)c[k] * term;
    }
    return sum;
}

/* Multiplies by conj(w)/|w|^2; |w| is far from overflow. */
static ovr_potential point(double complex w)
{
    double x = creal(w), z = cimag(w), scale = 1 / (x * x + z * z);
    double complex inverse = scale * x - I * (scale * z);
    return (ovr_potential){I / pi * inverse, -I / pi * (inverse * inverse)};
}

static double complex rounded(precise value, long double by)
{
    precise quotient = I * value / by;
    return (double)creall(quotient) + I * (double)cimagl(quotient);
}

static void hat(precise w, ovr_potential *one)
{
    static const int c[] = {1, -2, 1};
    one->C = rounded(differences(w, 3, c, 1), (long double)pi);
    one->dC = rounded(differences(w, 3, c, 0), (long double)pi);
}

static void b_spline(precise w, ovr_potential *one)
{
    static const int c[] = {1, -4, 6, -4, 1};
    one->C = rounded(differences(w, 5, c, 3), 6 * (long double)pi);
    one->dC = rounded(differences(w, 5, c, 2), 2 * (long double)pi);
}

/* a_m = sqrt 3 (sqrt 3 - 2)^|m| */
static double cardinal_weight(int m)
{
    return sqrt(3) * pow(sqrt(3) - 2, abs(m));
}

/* Sums the B-splines at w - m, m = -SPLINE_TAIL ... SPLINE_TAIL; the one at w -
 * m is `B[-m]`. */
static ovr_potential cardinal(const ovr_potential *B)
{
    ovr_potential sum = {0, 0};
    for (int m = -SPLINE_TAIL; m <= SPLINE_TAIL; m++) {
        double a = cardinal_weight(m);
        sum.C += a * B[-m].C;
        sum.dC += a * B[-m].dC;
    }
    return sum;
}

static ovr_potential spline(double x, double z)
{
    ovr_potential B[2 * SPLINE_TAIL + 1] = {{0, 0}};
    if (fabs(x) > SPLINE_REACH)
        return point(x + I * z);
    for (int m = -SPLINE_TAIL; m <= SPLINE_TAIL; m++)
        b_spline((long double)x + m + I * (long double)z, &B[m + SPLINE_TAIL]);
    return cardinal(B + SPLINE_TAIL);
}

/* Element type for a density at this depth. */
static ovr_element element_at(ovr_element element, double D, double z)
{
    if (element != OVR_ELEMENT_AUTO)
        return element;
    return z >= 4 * D * (1 - 1e-9) ? OVR_ELEMENT_POINT : OVR_ELEMENT_SPLINE;
}

/* Potential of one element of height 1 at x = 0; z > 0. */
static ovr_potential potential_of(ovr_element element, double D, double x,
                                  double z)
{
    ovr_potential result;
    x /= D, z /= D;
    switch (element_at(element, 1, z)) {
    case OVR_ELEMENT_HAT:
        hat((long double)x + I * (long double)z, &result);
        break;
    case OVR_ELEMENT_SPLINE: result = spline(x, z); break;
    default: result = point(x + I * z); break;
    }
    result.dC /= D;
    return result;
}

/* Cardinal splines at x = -SPLINE_REACH ... SPLINE_REACH; each B-spline is
 * evaluated once. */
static void spline_line(double z, ovr_potential *out)
{
    enum { REACH = SPLINE_REACH + SPLINE_TAIL };
    ovr_potential B[2 * REACH + 1] = {{0, 0}};
    for (int k = -REACH; k <= REACH; k++)
        b_spline((long double)k + I * (long double)z, &B[k + REACH]);
    for (int k = -SPLINE_REACH; k <= SPLINE_REACH; k++)
        out[k + SPLINE_REACH] = cardinal(B + REACH + k);
}

void ovr_element_line(ovr_element element, double D, double z, long first,
                      size_t count, ovr_potential *out)
{
    ovr_potential near[2 * SPLINE_REACH + 1] = {{0, 0}};
    bool splines = element_at(element, D, z) == OVR_ELEMENT_SPLINE;
    if (splines)
        spline_line(z / D, near);
    for (size_t k = 0; k < count; k++) {
        long lag = first + (long)k;
        if (splines && labs(lag) <= SPLINE_REACH) {
            out[k] = near[lag + SPLINE_REACH];
            out[k].dC /= D;
        } else {
            out[k] = potential_of(element, D, (double)lag * D, z);
        }
    }
}

ovr_in_plane ovr_stress_of(double z, ovr_potential p, ovr_potential q)
{
    double complex F = p.C - I * q.C;
    double complex shear = z * (p.dC - I * q.dC) - q.C;
    return (ovr_in_plane){creal(F), cimag(shear), creal(shear)};
}

ovr_in_plane ovr_stress_of_both(double z, ovr_potential one, double p, double q)
{
    double complex load = p - I * q;
    double complex F = load * one.C, shear = z * load * one.dC - q * one.C;
    return (ovr_in_plane){creal(F), cimag(shear), creal(shear)};
}

ovr_in_plane ovr_element_stress(ovr_element element, double D, double p,
                                double q, double x, double z)
{
    ovr_potential one = potential_of(element, D, x, z);
    return ovr_stress_of_both(z, one, p, q);
}
