/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Numerical starvation: a domain that begins at X_a neglects the pressure
 * build-up upstream of X_a.
 *
 * With the gap of the Hertzian contact
 *     g = [X sqrt(X^2 - 1) - ln(X + sqrt(X^2 - 1))]/2
 * and the central film thickness H (Moes), dP/dX = lambda g/(g + H)^3 there;
 * the relative loss of film thickness is
 *     c f + 0.4 e^(-L/3) (2 lambda/pi) int X g/(g + H)^3 dX,   X > |X_a|,
 *     f = int g/(g + H)^3 dX, X > |X_a|, divided by the same for X > 1,
 *     c = 0.7 L/(L + 1) M/(M + 0.6).
 * The first term applies if the viscosity increases with pressure: the pressure
 * missing at X_a is missing at the edge of the contact. The second term is the
 * load carried upstream of X_a by a film of constant viscosity.
 *
 * Accuracy, measured by moving the inlet upstream (M = 1 to 1000, L = 0 to 15,
 * X_a = -2 to -8, losses of 1e-5 to 20 %): within a factor of 1.5, in two
 * thirds of the cases within 1.15. Inlets chosen for an estimated loss of 0.5 %
 * were compared with inlets four times as far upstream (M = 1 to 30, L = 0 to
 * 18): the loss is at most 1.1 + 0.75/M times the estimate, with the largest
 * ratio at M = 1, where films change from rigid to elastic. For estimates of
 * 2e-2 to 1e-4 the ratio is at most 1.4.
 *
 * The rolling friction including the part upstream of X_a
 * (simulation/friction.c) is too low by 1.15 M^2/(M^2 + 4) times the first term
 * minus 0.6 times the second. The default inlet changes it by -3e-3 to 5e-3 (M
 * = 1 to 300, L = 0 to 15, compared with inlets four times as far upstream). An
 * error of 7e-4 remains, or of 2e-3 below M = 3.
 */
#include "contact/starvation.h"

#include <math.h>

#include "contact/film_formula.h"
#include "overroll/contact.h"

static const double pi = 3.14159265358979323846;

/* X = 1 + d; near 1 the two terms cancel, and a series is used. */
double ovr_hertz_gap(double d)
{
    double r = sqrt(d * (d + 2));
    if (d < 1e-4)
        return r * r * r * (1. / 3 - 0.1 * r * r);
    return 0.5 * ((1 + d) * r - log1p(d + r));
}

static double integrand(double H, double d, int power)
{
    double g = ovr_hertz_gap(d), h = g + H;
    return (power ? 1 + d : 1) * g / (h * h * h);
}

double ovr_inlet_integral(double H, double d, int power)
{
    const double step = 0.2;
    const int terms = 16; /* on both sides; further terms are negligible */
    double rise = H < 1 ? pow(H, 2. / 3) : sqrt(2 * H);
    double s = d > rise ? d : rise, sum = 0;
    for (int k = -terms; k <= terms; k++) {
        double t = step * k, x = s * exp(0.5 * pi * sinh(t));
        sum += integrand(H, d + x, power) * x * cosh(t);
    }
    return 0.5 * pi * step * sum;
}

/* The two terms of the loss. */
typedef struct losses {
    double viscous, carried;
} losses;

static losses losses_of(double M, double L, double X_a)
{
    double H = ovr_film_central_moes(M, L), d = -X_a - 1;
    double lambda = 3 * pi * pi / (8 * M * M);
    double c = 0.7 * L / (L + 1) * M / (M + 0.6);
    double f = ovr_inlet_integral(H, d, 0) / ovr_inlet_integral(H, 0, 0);
    double carried = 2 * lambda / pi * ovr_inlet_integral(H, d, 1);
    double share = 0.4 * exp(-L / 3);
    return (losses){c * f, share * carried};
}

double ovr_inlet_loss(double M, double L, double X_a)
{
    losses l = losses_of(M, L, X_a);
    return l.viscous + l.carried;
}

double ovr_inlet_rolling_loss(double M, double L, double X_a)
{
    losses l = losses_of(M, L, X_a);
    return 1.15 * M * M / (M * M + 4) * l.viscous - 0.6 * l.carried;
}

double ovr_inlet_uncertainty(double M)
{
    return 1.1 + 0.75 / fmax(M, 1);
}

/* Far upstream the loss is a power of X_a: secant method in logarithms from
 * both sides, with bisection in every third step. */
double ovr_inlet_of_loss(double M, double L, double loss, double minimum)
{
    double near = log(-minimum), far, above, below;
    above = log(ovr_inlet_loss(M, L, minimum) / loss);
    if (above <= 0)
        return minimum;
    for (far = near + 0.5;; far += 0.5) {
        below = log(ovr_inlet_loss(M, L, -exp(far)) / loss);
        if (below <= 0)
            break;
        near = far;
        above = below;
    }
    for (int k = 0; k < 60 && below < -1e-6; k++) {
        double part = k % 3 == 2 ? 0.5 : above / (above - below);
        double x = near + (far - near) * part;
        double y = log(ovr_inlet_loss(M, L, -exp(x)) / loss);
        *(y > 0 ? &near : &far) = x;
        *(y > 0 ? &above : &below) = y;
    }
    /* Interpolates once more; otherwise the inlet would depend on the number of
     * steps, and therefore on rounding of log and exp. */
    return -exp(near + (far - near) * above / (above - below));
}

/* A rigid film ends at 0.475 sqrt(2 H) (Martin), a dry contact at 1. Steady
 * films with M = 0.05 to 200 and L = 0 to 18 end at 0.79 to 1.11 times the root
 * of the sum of squares of both. */
double ovr_film_end_bound(double M, double L)
{
    const double rigid = 2 * 0.475 * 0.475;
    return 1.12 * sqrt(1 + rigid * ovr_film_central_moes(M, L));
}
