/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Temperatures change the film: the fields of Reynolds' equation (heat.h), and
 * how far they move on at once. */
#include <math.h>
#include <string.h>

#include "base/larger.h"
#include "contact/contact.h"
#include "simulation/heat_in_time.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"

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

/* Upstream difference of v along x, the flow coming from the right. */
static double wedge_from_right(const ovr_simulation *sim, const ovr_weights *w,
                               const double *v, size_t i)
{
    size_t last = sim->now.n - 1;
    const double *a = i + 1 == last ? w->first : w->a;
    double sum = 0;
    for (size_t m = 0; m < 3 && i + m <= last; m++)
        sum -= a[m] * v[i + m];
    return sum;
}

/* Adds what others give, and in time the past. */
static void sides(const ovr_simulation *sim, double *F)
{
    const ovr_heat_steps *s = sim->heated->steps;
    size_t n = sim->now.n;
    if (s->dT > 0) {
        memcpy(F, s->F, n * sizeof *F);
        return;
    }
    memset(F, 0, n * sizeof *F);
    OVR_EACH_PHYSICS(sim, p, sides)
        p->is->sides(sim, p->own, F);
}

/* F of N = F: that, and the wedge of q D. */
static void put_skewed(ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    const double *v = h->skewed, D = ovr_mesh(sim);
    double *F = sim->scratch[0];
    ovr_operator op = {0};
    ovr_weights w;
    ovr_reynolds_wedge(&op, sim->scheme->order == 2, 1);
    w = ovr_reynolds_weights(&op, D);
    sides(sim, F);
    for (size_t i = 0; i < sim->now.n; i++) {
        const double *a = i == 1 ? w.first : w.a;
        if (sim->backward) {
            F[i] += wedge_from_right(sim, &w, v, i);
            continue;
        }
        if (i > 0)
            F[i] += a[0] * v[i] + a[1] * v[i - 1];
        if (i > 1)
            F[i] += a[2] * v[i - 2];
    }
    ovr_nodes_write(sim, sim->finest, F, sim->finest->f.F);
}

void ovr_heat_give(ovr_simulation *sim)
{
    restrict_all(sim);
    put_skewed(sim);
}

/* What a cavity holds moves with the surfaces.  The flow that temperatures skew
 * fades out over the last pressures before it: a node that is wet in one turn
 * and dry in the next then changes nothing. */
static void fade(const ovr_simulation *sim, double *skewed)
{
    const double low = 0.005; /* p_h */
    for (size_t i = 0; i < sim->now.n; i++)
        skewed[i] *= ovr_larger(0, ovr_smaller(1, sim->now.P[i] / low));
}

/* Means (1, 2, 1)/4 of neighbours, `times` in a row, those of wet nodes alone;
 * in `v`, with a workspace. */
static void mean(const ovr_simulation *sim, int times, double *v, double *work)
{
    const double *P = sim->now.P;
    size_t last = sim->now.n - 1;
    for (int k = 0; k < times; k++) {
        memcpy(work, v, (last + 1) * sizeof *v);
        for (size_t i = 1; i < last; i++) {
            double left = P[i - 1] > 0 ? work[i - 1] : work[i];
            double right = P[i + 1] > 0 ? work[i + 1] : work[i];
            double all = 0.25 * (left + right) + 0.5 * work[i];
            v[i] = P[i] > 0 ? all : work[i];
        }
    }
}

/*
 * Waves of few meshes leave the skewed flow, by 2 M^4 - M^8 with M the mean of
 * neighbours: of those of 4, 8, 16 and 32 meshes .12, .78, .98 and .999 are
 * left, O(D^4) is lost.  D falls with P at once, by its viscosities, and P
 * answers to D the more the shorter a wave is: along the characteristic, in
 * whose steps nothing else damps them, a cycle made waves of four or five
 * meshes larger in sliding contacts (a slip of 1.55 at 1.2 GPa: 31 cycles a
 * step and 2.2 GPa, now 5 and 1.18).
 */
static void smooth(const ovr_simulation *sim, double *skewed)
{
    double *v = sim->scratch[0], *work = sim->scratch[1];
    size_t n = sim->now.n;
    mean(sim, 4, skewed, work);
    memcpy(v, skewed, n * sizeof *v);
    mean(sim, 4, v, work);
    for (size_t i = 0; i < n; i++)
        skewed[i] = 2 * skewed[i] - v[i];
}

void ovr_heat_apply(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    ovr_heat_film_fields(sim);
    if (ovr_conserves(sim))
        fade(sim, h->skewed);
    smooth(sim, h->skewed);
    for (size_t i = 0; i < sim->now.n; i++)
        h->skew[i] = sim->now.q[i] > 0 ? h->skewed[i] / sim->now.q[i] : 0;
    ovr_heat_give(sim);
}

void ovr_heat_follow(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    const double *q = sim->now.q;
    for (size_t i = 0; i < sim->now.n; i++)
        if (q[i] > 0)
            h->skewed[i] += (h->skew[i] * q[i] - h->skewed[i]) /
                            (1 + ovr_larger(h->skew[i], 0));
    put_skewed(sim);
}

double ovr_heat_pressed(const ovr_simulation *sim)
{
    const double share = 0.1, *P = sim->now.P;
    return share *
           ovr_smaller(1, P[sim->grids.kernels->extreme(sim->now.n, -1, P)]);
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
