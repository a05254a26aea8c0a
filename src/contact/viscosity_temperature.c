/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Viscosity as a function of temperature from data sheets, nu in mm2/s.
 *
 * ASTM D341, Walther's form (nu above 2 mm2/s):
 *     log10 log10(nu + 0.7) = A - B log10 T
 *
 * ASTM D2270, ISO 2909: an oil has the viscosity U at 40 degC and Y at 100
 * degC; L and H are the viscosities at 40 degC of oils with index 0 and 100 and
 * the same Y, piecewise quadratic (annex of the standard; within 0.2 % of its
 * table),
 *     L = a Y^2 + b Y + c,  H = d Y^2 + e Y + f
 *     VI = 100 (L - U)/(L - H),  up to 100
 *     VI = 100 + (10^N - 1)/0.00715,  Y^N = H/U, above
 */
#include <math.h>

#include "contact/oil.h"

static const double CELSIUS = 273.15, MM2 = 1e-6, MAX = 2000; /* mm2/s */

static double w_of(double nu)
{
    return log(log(nu / MM2 + 0.7));
}

double ovr_walther(double nu_40, double nu_100, double T)
{
    double x40 = log(CELSIUS + 40), x100 = log(CELSIUS + 100);
    double slope = (w_of(nu_40) - w_of(nu_100)) / (x100 - x40);
    return MM2 * (exp(exp(w_of(nu_40) - slope * (log(T) - x40))) - 0.7);
}

static const struct part {
    double upto, a, b, c, d, e, f; /* Y */
} parts[] = {
    {3.8, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077},
    {4.4, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183},
    {5.0, 2.5000, -7.2143, 13.812, 0.82143, 1.5679, 0.119},
    {6.4, 0.10100, 16.6350, -45.469, 0.04985, 9.1613, -18.557},
    {7.0, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656},
    {7.7, 0.01191, 21.4750, -72.870, 0.79762, -0.7321, 14.610},
    {9.0, 0.41858, 16.1558, -56.040, 0.05794, 10.5156, -28.240},
    {12, 0.88779, 7.5527, -16.600, 0.26665, 6.7015, -10.810},
    {15, 0.76720, 10.7972, -38.180, 0.20073, 8.4658, -22.490},
    {18, 0.97305, 5.3135, -2.200, 0.28889, 5.9741, -4.930},
    {22, 0.97256, 5.2500, -0.980, 0.24504, 7.4160, -16.730},
    {28, 0.91413, 7.4759, -21.820, 0.20323, 9.1267, -34.230},
    {40, 0.87031, 9.7157, -50.770, 0.18411, 10.1015, -46.750},
    {55, 0.84703, 12.6752, -133.310, 0.17029, 11.4866, -80.620},
    {70, 0.85921, 11.1009, -83.190, 0.17130, 11.3680, -76.940},
    {INFINITY, 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947},
};

double ovr_viscosity_index(double nu_40, double nu_100)
{
    double U = nu_40 / MM2, Y = nu_100 / MM2, L, H;
    const struct part *p = parts;
    if (!(Y >= 2 && U > Y))
        return NAN;
    while (Y > p->upto)
        p++;
    L = (p->a * Y + p->b) * Y + p->c;
    H = (p->d * Y + p->e) * Y + p->f;
    if (U >= H)
        return 100 * (L - U) / (L - H);
    return 100 + (pow(10, log(H / U) / log(Y)) - 1) / 0.00715;
}

/* The index increases with Y for given U: bisection. */
double ovr_viscosity_at_100(double nu_40, double index)
{
    double low = 2 * MM2, high = fmin(nu_40, MAX * MM2) * (1 - 1e-9);
    if (!(high > low) || !(ovr_viscosity_index(nu_40, low) <= index) ||
        !(ovr_viscosity_index(nu_40, high) >= index))
        return NAN;
    for (int k = 0; k < 60; k++) {
        double middle = (low + high) / 2;
        if (ovr_viscosity_index(nu_40, middle) < index)
            low = middle;
        else
            high = middle;
    }
    return (low + high) / 2;
}
