/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Marching along x (equations in heat.h). */
#include <math.h>
#include <string.h>

#include "physics/heat/in_time.h"

/* Some layer between surfaces that move in opposite directions has no speed.  A
 * jump between the two smallest speeds would keep the iterations from ending.
 */
static const double MIN_SPEED = 0.02, MIN_SPEED_OPPOSED = 1e-9;

/* Speeds of the surfaces at T = 0, and their memories from node to node. */
void ovr_heat_march_begin(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    double D = ovr_mesh(sim), length = (double)(sim->now.n - 1) * D;
    ovr_heat_speeds(sim, 0);
    for (int k = 0; k < 2; k++) {
        double u = h->u1 - k * h->V;
        h->speed[k] = ovr_solid_march_speed(&h->numbers, k, u);
        h->way[k] = u < 0 || (!(u > 0) && sim->backward) ? -1 : 1;
        ovr_memory_fit(D / h->speed[k],
                       fmax(h->longest[k], length / h->speed[k]),
                       &h->memory[k]);
    }
}

static bool opposed(const ovr_heated *h)
{
    return h->way[0] != h->way[1];
}

/* A march carries this from node to node. */
typedef struct march {
    int way; /* along x, or against it */
    double psi[2][OVR_MAX_MODES], q[2];
} march;

/* A surface that moves the other way brings along what the last march found. */
static void solve_node(ovr_simulation *sim, size_t i, march *m)
{
    ovr_heated *h = sim->heated;
    ovr_heat_surface *s = h->steps->surface;
    for (int k = 0; k < 2; k++)
        if (h->way[k] == m->way)
            s[k].past[i] = ovr_memory_past(&h->memory[k], m->psi[k], m->q[k]) +
                           s[k].along[i];
    ovr_column_heat(&h->film, i);
    for (int j = 0; j < h->cross_film.n; j++)
        h->T[j][i] = ovr_heat_bounded(h, h->T[j][i]);
    for (int k = 0; k < 2; k++) {
        double q = h->q[k][i];
        if (h->way[k] != m->way)
            continue;
        ovr_memory_step(&h->memory[k], m->q[k], q, m->psi[k]);
        ovr_heat_steps_keep(sim, k, i, m->psi[k]);
        m->q[k] = q;
    }
}

/* All nodes but one, from node i on, along x or against it. */
static void march_from(ovr_simulation *sim, size_t i, int way)
{
    march m = {.way = way};
    for (size_t k = 1; k < sim->now.n; k++, i += (size_t)way)
        solve_node(sim, i, &m);
}

void ovr_heat_march_columns(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    ovr_columns *c = &h->film;
    c->P_T = NULL;
    c->min_u = opposed(h) ? MIN_SPEED_OPPOSED : MIN_SPEED;
    c->both_ways = opposed(h);
    c->back = !opposed(h) && h->way[0] < 0;
    c->mean = h->mean;
    for (int j = 0; j < h->cross_film.n; j++)
        c->departure[j] = c->T[j] = h->T[j];
    for (int k = 0; k < 2; k++) {
        c->past[k] = h->steps->surface[k].past;
        c->into[k] = h->q[k];
        c->resistance[k] = h->numbers.solid[k] * 4 / 3 * sqrt(h->memory[k].dT) *
                           (1 + h->memory[k].more[0]);
    }
}

void ovr_heat_march(ovr_simulation *sim)
{
    enum { PAIRS = 2 };
    size_t last = sim->now.n - 1;
    ovr_heat_film(sim);
    ovr_heat_march_columns(sim);
    if (opposed(sim->heated))
        for (int k = 0; k < PAIRS; k++) {
            march_from(sim, 1, 1);
            march_from(sim, last, -1);
        }
    else if (sim->heated->film.back)
        march_from(sim, last - 1, -1);
    else
        march_from(sim, 1, 1);
    for (int k = 0; k < 2; k++)
        if (ovr_solid_conducts(&sim->heated->numbers, k,
                               sim->heated->u1 - k * sim->heated->V))
            ovr_heat_surface_steady(sim, k);
}
