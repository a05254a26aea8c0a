/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/review_supply.h"

#include <math.h>
#include <stdio.h>

#include "case/feed.h"
#include "multigrid/grid.h"

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

void ovr_review_supply(const ovr_setup *setup, ovr_listener *say, void *data)
{
    char text[240];
    double arrives, taken = flooded(setup);
    if (!say || !setup->supply->film || isinf(setup->supply->waiting))
        return;
    arrives = ovr_setup_arriving(setup, 0);
    if (!(arrives > SURE * taken))
        return;
    snprintf(text, sizeof text,
             "a film of %.3g arrives, of which the contact takes only some "
             "%.2g, being flooded then; the rest waits before it",
             arrives, taken / arrives);
    say(data, OVR_SAY_WARNING, text);
}

void ovr_review_meniscus(const ovr_simulation *sim, ovr_listener *say,
                         void *data)
{
    static const double meshes = 4;
    const ovr_options *o = ovr_simulation_options(sim);
    double X = ovr_simulation_observation(sim)->meniscus;
    double coarse = (o->outlet - o->inlet) /
                    (double)(ovr_level_nodes(o->coarsest_level) - 1);
    char text[240];
    if (!(X < o->inlet + meshes * coarse))
        return;
    snprintf(text, sizeof text,
             "the film begins at X = %.3g, closer to the inlet at %.3g than "
             "coarse grids resolve: move it out",
             X, o->inlet);
    say(data, OVR_SAY_WARNING, text);
}
