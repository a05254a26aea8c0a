/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Temperatures change the film: the fields of Reynolds' equation (heat.h), and
 * how far they move on at once. */
#include <math.h>
#include <string.h>

#include "base/larger.h"
#include "contact/contact.h"
#include "physics/heat/in_time.h"
#include "physics/heat/skew.h"
#include "simulation/mirror.h"

void ovr_heat_speeds(ovr_simulation *sim, double T)
{
    ovr_heated *h = sim->heated;
    h->V = ovr_sliding(sim, T);
    h->u1 = ovr_history_value(sim->speed, T) + h->V / 2;
}

/* Injection of all to all grids. */
static void restrict_all(ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    const double *const from[] = {h->th, h->shift, h->drag, h->swell};
    double *workspace = sim->scratch[0];
    for (int l = sim->grids.finest; l >= sim->grids.coarsest; l--) {
        ovr_level *level = &sim->grids.level[l];
        double *const to[] = {level->f.th, level->f.shift, level->f.drag,
                              level->f.swell};
        size_t every = (size_t)1 << (sim->grids.finest - l);
        for (int k = 0; k < 4 && to[k]; k++) {
            for (size_t i = 0; i < level->grid.n; i++)
                workspace[i] = from[k][i * every];
            ovr_nodes_write(sim, level, workspace, to[k]);
        }
    }
}

void ovr_heat_give(ovr_simulation *sim)
{
    restrict_all(sim);
    ovr_heat_skew_give(sim);
}

void ovr_heat_apply(ovr_simulation *sim)
{
    ovr_heat_film_fields(sim);
    ovr_heat_skew_find(sim);
    ovr_heat_give(sim);
}

double ovr_heat_pressed(const ovr_simulation *sim)
{
    const double share = 0.1, *P = sim->now.P;
    return share *
           ovr_smaller(1, P[sim->grids.kernels->extreme(sim->now.n, -1, P)]);
}

double ovr_heat_bounded(const ovr_heated *heated, double rise)
{
    const double hottest = 5000 /* K */;
    const double coldest = (OVR_ROELANDS_T - heated->numbers.T0) / 2;
    return ovr_larger(coldest, ovr_smaller(rise, hottest));
}

/* No temperature moves on by more than this share of itself and some kelvins:
 * the first are those of an isothermal film, which may be absurd. */
void ovr_heat_relax(ovr_simulation *sim, double share)
{
    const double maximum = 0.5, minimum = 10;
    ovr_heated *h = sim->heated;
    for (int j = 0; j < h->cross_film.n; j++)
        for (size_t i = 0; i < sim->now.n; i++) {
            double d = h->T[j][i] - h->used[j][i];
            double limit = maximum * fabs(h->used[j][i]) + minimum;
            h->used[j][i] += ovr_larger(-limit, ovr_smaller(share * d, limit));
        }
}
