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
#include "contact/film_formula.h"
#include "overroll/contact.h"

#include <math.h>

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
