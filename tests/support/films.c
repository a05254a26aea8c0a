/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/films.h"

#include <math.h>

#include "contact/contact.h"
#include "contact/film_formula.h"
#include "overroll/simulation.h"

/* Returns element i of van der Corput's sequence, 0 to 1. */
static double corput(size_t i, size_t base)
{
    double value = 0, part = 1;
    for (; i; i /= base) {
        part /= (double)base;
        value += part * (double)(i % base);
    }
    return value;
}

static test_film draw(size_t i)
{
    test_film f = {.M = 2 * pow(500, corput(i, 2)),
                   .L = 0.3 * pow(25 / 0.3, corput(i, 3)),
                   .alpha = (12 + 13 * corput(i, 5)) * 1e-9};
    f.ph = f.L * sqrt(f.M / 6.28318530717958647692) / f.alpha;
    return f;
}

/* Solves with the inlet at least 40 sqrt(2 H) upstream, where its effect on the
 * film thickness is below 1e-4. */
static int solve(int level, test_film *f)
{
    double width = sqrt(2 * ovr_film_central_moes(f->M, f->L));
    ovr_conditions given = ovr_conditions_default();
    ovr_options o = ovr_options_default();
    ovr_simulation *sim = NULL;
    ovr_contact contact;
    ovr_lubricant oil;
    int solved;
    given.M = f->M, given.L = f->L, given.alpha = f->alpha;
    o.level = level, o.order = 4;
    o.inlet = -fmax(4, 40 * width), o.outlet = fmax(1.5, 1 + width);
    if (!ovr_contact_resolve(&given, &contact, NULL) &&
        !ovr_lubricant_make(&contact, OVR_ROELANDS, OVR_DOWSON_HIGGINSON,
                            1.98e8, 0.68, &oil, NULL))
        sim = ovr_simulation_create(&contact, &oil, &o, NULL, NULL);
    solved = sim && !ovr_simulation_steady(sim, NULL);
    if (solved) {
        f->density = ovr_density(&oil, 1);
        f->central = ovr_simulation_observation(sim)->H_cen;
        f->minimum = ovr_simulation_observation(sim)->H_min_located;
    }
    ovr_simulation_free(sim);
    return solved;
}

size_t test_films(size_t count, int level, test_film *film)
{
    size_t solved = 0, drawn = 0;
    for (size_t i = 1; drawn < count; i++) {
        test_film f = draw(i);
        if (f.ph > 4e9)
            continue;
        drawn++;
        if (solve(level, &f))
            film[solved++] = f;
    }
    return solved;
}
