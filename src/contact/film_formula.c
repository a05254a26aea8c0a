/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Central film thickness of a line contact after Moes (1992), in the Moes
 * number h/R (2U)^(-1/2) = H 8 M/pi:
 *     H_RI = 3/M            H_EI = 2.621 M^(-1/5)
 *     H_RP = 1.287 L^(2/3)  H_EP = 1.311 M^(-1/8) L^(3/4)
 *     s = (7 + 8 exp(-2 H_EI/H_RI))/5
 *     H = [(H_RI^(7/3) + H_EI^(7/3))^(3s/7)
 *          + (H_RP^(-7/2) + H_EP^(-7/2))^(-2s/7)]^(1/s)
 */
#include <math.h>

#include "contact/film_formula.h"
#include "overroll/contact.h"

/* ----------------------------------------------------------------- Formulas */

static double hertzian(double moes, double M)
{
    return moes * 3.14159265358979323846 / (8 * M);
}

static ovr_film_asymptotes asymptotes(double M, double L)
{
    ovr_film_asymptotes film = {3 / M, 2.621 * pow(M, -0.2),
                                1.287 * pow(L, 2.0 / 3),
                                1.311 * pow(M, -0.125) * pow(L, 0.75)};
    return film;
}

double ovr_film_central_moes(double M, double L)
{
    ovr_film_asymptotes film = asymptotes(M, L);
    double s = (7 + 8 * exp(-2 * film.elastic_iso / film.rigid_iso)) / 5;
    double iso = pow(film.rigid_iso, 7.0 / 3) + pow(film.elastic_iso, 7.0 / 3);
    double piezo = 0;
    if (L > 0)
        piezo = pow(pow(film.rigid_piezo, -3.5) + pow(film.elastic_piezo, -3.5),
                    -2 * s / 7);
    return hertzian(pow(pow(iso, 3 * s / 7) + piezo, 1 / s), M);
}

ovr_film_asymptotes ovr_film_asymptotes_moes(double M, double L)
{
    ovr_film_asymptotes film = asymptotes(M, L);
    film.rigid_iso = hertzian(film.rigid_iso, M);
    film.elastic_iso = hertzian(film.elastic_iso, M);
    film.rigid_piezo = hertzian(film.rigid_piezo, M);
    film.elastic_piezo = hertzian(film.elastic_piezo, M);
    return film;
}

/* --------------------------------------------------------- Fit to solutions */

/*
 * Central and minimum film thickness with a compressible lubricant, fitted to
 * this program's own solutions.  Moes' asymptotes are blended with constants a
 * to k:
 *
 *     H_RI = 3/M                H_EI = a M^b
 *     H_RP = c L^(2/3)          H_EP = d M^e L^f
 *     iso   = (H_RI^g + H_EI^g)^(1/g)
 *     piezo = (H_RP^-h + H_EP^-h)^(-1/h)
 *     s     = i + j exp(-k H_EI/H_RI)
 *     H     = (iso^s + piezo^s)^(1/s)
 *
 * The central film thickness is divided by the relative density at ph, because
 * the lubricant is compressed between inlet and centre.
 *
 * Error over 260 contacts of 2 <= M <= 1000 and 0.3 <= L <= 25 with ph below 4
 * GPa:
 *     central film thickness   median 0.21 %, largest 2.6 %
 *     minimum film   median 0.28 %, largest 1.7 %
 * The oils have Roelands' viscosity with z = 0.68, p0 = 198 MPa and alpha of 12
 * to 25 1/GPa.  The solutions have order 4, level 10 and an inlet at 40 film
 * widths.  tests/verify/film_fit_test.c repeats the survey and the fit.
 */

const ovr_film_constants ovr_central_film = {{2.691, -0.2099, 1.321, 1.254,
                                              -0.1201, 0.7429, 2.013, 5.559,
                                              1.434, 112.7, 3.904}};
const ovr_film_constants ovr_minimum_film = {{2.123, -0.2092, 1.033, 0.8305,
                                              -0.1181, 0.7566, 2.495, 4.639,
                                              1.378, 3.281, 2.277}};

double ovr_film_blend(const ovr_film_constants *constants, double M, double L)
{
    const double *a = constants->a;
    double rigid_iso = 3 / M, elastic_iso = a[0] * pow(M, a[1]);
    double rigid_piezo = a[2] * pow(L, 2. / 3);
    double elastic_piezo = a[3] * pow(M, a[4]) * pow(L, a[5]);
    double iso = pow(pow(rigid_iso, a[6]) + pow(elastic_iso, a[6]), 1 / a[6]);
    double piezo = pow(pow(rigid_piezo, -a[7]) + pow(elastic_piezo, -a[7]),
                       -1 / a[7]);
    double s = a[8] + a[9] * exp(-a[10] * elastic_iso / rigid_iso);
    return pow(pow(iso, s) + pow(piezo, s), 1 / s) * 3.14159265358979323846 /
           (8 * M);
}

ovr_film_fit ovr_film_fitted(double M, double L, double density)
{
    ovr_film_fit fit = {NAN, NAN};
    if (!(M >= 2 && M <= 1000 && L >= 0.3 && L <= 25))
        return fit;
    fit.central = ovr_film_blend(&ovr_central_film, M, L) / density;
    fit.minimum = ovr_film_blend(&ovr_minimum_film, M, L);
    return fit;
}

double ovr_resolving_mesh(double M, double H)
{
    const double share = 0.2, heavy = 3000, heavy_share = 0.15;
    return (M > heavy ? heavy_share : share) * pow(H, 2. / 3);
}
