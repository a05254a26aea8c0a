/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Says before the solve what there is to say of the oil that arrives. */
#include <math.h>
#include <stdio.h>

#include "contact/contact.h"
#include "contact/film_formula.h"
#include "run/companion.h"
#include "run/forms.h"
#include "run/review.h"
#include "simulation/physics.h"

/* The formulas are not better; incompressible oil flows as its film is thick.
 */
static const double SURE = 1.1;

static double flooded(const ovr_setup *s)
{
    const ovr_contact *c = s->contact;
    double density = ovr_density(s->lubricant, 1);
    ovr_film_fit fit = ovr_film_fitted(c->M, c->L, density);
    if (s->lubricant->viscosity_law == OVR_ROELANDS &&
        s->lubricant->density_law == OVR_DOWSON_HIGGINSON &&
        isfinite(fit.central))
        return density * fit.central;
    return ovr_film_central_moes(c->M, c->L);
}

/* More than a flooded contact takes, by the film formula. */
static void foresee(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const ovr_supply_case *supply = ovr_setup_supply(setup);
    double arrives, taken = flooded(setup);
    if (!supply->film || isinf(supply->reservoir))
        return;
    arrives = ovr_supply_arriving(supply, 0);
    if (!(arrives > SURE * taken))
        return;
    ovr_warn(say, data,
             "a film of %.3g arrives, of which the contact takes only some "
             "%.2g, being flooded then; the rest waits in the inlet reservoir",
             arrives, taken / arrives);
}

const ovr_companion ovr_supply_companion = {.foresee = foresee};
