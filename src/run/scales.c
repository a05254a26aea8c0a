/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What follows from a case by formulas alone: scales of the contact, films of
 * regimes and fits. */
#include <math.h>

#include "overroll/oil.h"
#include "overroll/questions.h"

/* NAN for other oils than it was fitted to. */
static ovr_film_fit fitted(const ovr_setup *setup)
{
    const ovr_contact *contact = setup->contact;
    const ovr_lubricant *oil = setup->lubricant;
    if (oil->viscosity_law != OVR_ROELANDS ||
        oil->density_law != OVR_DOWSON_HIGGINSON)
        return (ovr_film_fit){NAN, NAN};
    return ovr_film_fitted(contact->M, contact->L, ovr_density(oil, 1));
}

void ovr_setup_scales(const ovr_setup *setup, ovr_summary_taker *take,
                      void *data)
{
    if (!setup || !take)
        return;
    const ovr_contact *c = setup->contact;
    const ovr_film_asymptotes film = ovr_film_asymptotes_moes(c->M, c->L);
    const ovr_film_fit fit = fitted(setup);
    const struct {
        const char *key;
        double number;
    } rows[] = {{"radius_m", c->radius},
                {"modulus_Pa", c->modulus},
                {"viscosity_Pa_s", c->viscosity},
                {"alpha_per_Pa", c->alpha},
                {"alpha_star_per_Pa",
                 ovr_asymptotic_alphabar(setup->lubricant) / c->ph},
                {"load_N", c->load * c->width},
                {"u1_ratio", c->u1_ratio},
                {"u2_ratio", c->u2_ratio},
                {"H_cen_moes", ovr_film_central_moes(c->M, c->L)},
                {"H_cen_fit", fit.central},
                {"H_min_fit", fit.minimum},
                {"H_rigid_isoviscous", film.rigid_iso},
                {"H_elastic_isoviscous", film.elastic_iso},
                {"H_rigid_piezoviscous", film.rigid_piezo},
                {"H_elastic_piezoviscous", film.elastic_piezo}};
    ovr_contact_summary(c, take, data);
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const ovr_summary_line line = {
            .size = sizeof line, .key = rows[k].key, .number = rows[k].number};
        take(data, &line);
    }
}
