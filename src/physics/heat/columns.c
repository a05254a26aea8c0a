/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Columns across the film, marching along x, and the coefficients for the
 * Reynolds equation. */
#include "physics/heat/columns.h"

#include <math.h>
#include <string.h>

#include "base/larger.h"
#include "contact/contact.h"
#include "multigrid/expansion.h"
#include "physics/heat/flow_power.h"
#include "physics/heat/heated.h"
#include "physics/heat/in_time.h"
#include "physics/heat/skew.h"
#include "simulation/mirror.h"
#include "simulation/observe.h"
#include "simulation/physics.h"

/* ------------------------------------------------------------------ Columns */

ovr_status ovr_heat_film_take(ovr_simulation *sim, ovr_error *err)
{
    ovr_heated *h = sim->heated;
    ovr_columns *c = &h->film;
    for (int j = 0; j < h->cross_film.n; j++)
        OVR_TAKE_NODES(sim, err, &c->u[j], &c->heating[j], &h->departure[j]);
    OVR_TAKE_NODES(sim, err, &h->log_eta, &h->oil, &h->content, &h->apart,
                   &c->fall);
    return ovr_heat_flow_power_take(sim, err);
}

/* Flow from a pressurized node to the cavitated node downstream, divided by the
 * speed. (The pressurized node's own content would jump by O(D) when the last
 * node changes, and the outer iteration could alternate between two nodes.) */
static double outflow_content(const ovr_simulation *sim, size_t wet)
{
    const double minimum = 0.5, maximum = 1.5;
    const ovr_heated *h = sim->heated;
    double q = sim->now.q[wet], Cu = h->u1 - h->V / 2, flow;
    if (wet == 0 || wet + 1 == sim->now.n || !(fabs(Cu) > OVR_MIN_START))
        return q;
    flow = ovr_flux(sim, Cu, sim->histories.backward ? wet - 1 : wet) / Cu;
    return ovr_larger(minimum * q, ovr_smaller(flow, maximum * q));
}

/* Computes thickness and content of the present lubricant. */
static void fill_oil(ovr_simulation *sim)
{
    const ovr_solution *now = &sim->now;
    ovr_heated *h = sim->heated;
    bool conserves = ovr_conserves(sim);
    size_t last = now->n - 1;
    double left = now->q[sim->histories.backward ? last : 0];
    for (size_t k = 0; k <= last; k++) {
        size_t i = sim->histories.backward ? last - k : k;
        size_t before = sim->histories.backward ? i + 1 : i - 1;
        h->oil[i] = now->H[i];
        h->content[i] = now->q[i];
        if (now->P[i] > 0)
            continue;
        if (k > 0 && now->P[before] > 0)
            left = outflow_content(sim, before);
        if (conserves) /* density 1 */
            h->content[i] = h->oil[i] = ovr_larger(1e-6, now->q[i]);
        else if (left < now->q[i]) {
            h->oil[i] *= ovr_larger(1e-6, left) / now->q[i];
            h->content[i] = ovr_larger(1e-6, left);
        }
    }
}

/* Sets all inputs of the columns. */
static void begin(ovr_simulation *sim)
{
    const ovr_solution *now = &sim->now;
    const ovr_lubricant *oil = &sim->lubricant;
    ovr_heated *h = sim->heated;
    ovr_columns *c = &h->film;
    c->cross_film = &h->cross_film;
    c->heat = &h->numbers;
    c->n = now->n;
    c->lambda = sim->contact.lambda;
    c->V = h->V;
    c->u1 = h->u1;
    c->Sigma0 = h->Sigma0;
    c->limit = h->limit;
    c->always_falls = h->always_falls;
    c->law = oil->rheology > OVR_EYRING ? oil->flow_law : NULL;
    c->X = now->X;
    c->P = now->P;
    c->H = h->oil;
    c->q = h->content;
    c->log_eta = h->log_eta;
    c->t = h->t;
    c->th = NULL;
    for (int j = 0; j < h->cross_film.n; j++)
        c->used[j] = h->used[j];
    sim->grids.kernels->log_viscosity(now->n, &sim->grids.fluid, now->P, now->H,
                                      h->log_eta);
}

/* Returns the factor of the heat source if fluid shear acts on a fraction of
 * the surface only. The power -V t is reduced, the power of the Poiseuille flow
 * is not. */
static double share_left(const ovr_heated *h, size_t i)
{
    double made = 0, slides = -h->V * h->film.t[i];
    for (int j = 0; j < h->cross_film.n; j++)
        made += h->cross_film.w[j] * h->film.heating[j][i];
    if (!(made > 0))
        return 1;
    return ovr_larger(0, 1 - (1 - h->apart[i]) * ovr_smaller(slides / made, 1));
}

/* Adds the power dissipated by other models, uniformly across the film, and
 * reduces the film's own heat source. */
static void add_power(ovr_simulation *sim)
{
    OVR_LAST_PHYSICS(sim, any, in_output, heat);
    const ovr_heated *h = sim->heated;
    if (!any->is)
        return;
    double *power = ovr_work_take(sim);
    for (size_t i = 0; i < sim->now.n; i++) {
        power[i] = 0;
        h->apart[i] = 1;
    }
    OVR_EACH_PHYSICS(sim, p, in_output, heat)
        p->is->in_output->heat(sim, p->own, h->apart, power);
    for (size_t i = 0; i < sim->now.n; i++) {
        double share = h->apart[i] < 1 ? share_left(h, i) : 1;
        for (int j = 0; j < h->cross_film.n; j++)
            h->film.heating[j][i] = share * h->film.heating[j][i] + power[i];
    }
    ovr_work_give(sim, power);
}

bool ovr_heat_counts(const ovr_simulation *sim, size_t i)
{
    const ovr_columns *c = &sim->heated->film;
    return c->P[i] > 0 || c->heating[0][i] != 0;
}

/* Multiplies flow and heat source of the last pressurized node by the fraction
 * of its downstream grid interval that contains lubricant (skew.h). */
static void cover_end(const ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    ptrdiff_t last;
    double share = ovr_heat_film_end(sim, &last);
    if (share < 0)
        return;
    for (int j = 0; j < h->cross_film.n; j++) {
        double dry = h->u1 - h->V * (1 + h->cross_film.s[j]) / 2;
        double *u = h->film.u[j] + last;
        *u = dry + share * (*u - dry);
        h->film.heating[j][last] *= share;
    }
}

void ovr_heat_film(ovr_simulation *sim)
{
    begin(sim);
    fill_oil(sim);
    sim->grids.kernels->flow_cross_film(&sim->heated->film);
    ovr_heat_flow_power(sim);
    if (ovr_heat_opposed(sim) && !ovr_conserves(sim))
        cover_end(sim);
    add_power(sim);
}

/* Computes th, shift, drag and skewed of the film. */
static void heat_film_fields(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    ovr_columns *c = &h->film;
    begin(sim);
    c->q = sim->now.q; /* content of the full gap, as in the wedge */
    c->th = h->th;
    c->shift = h->shift;
    c->drag = h->drag;
    c->swell = h->swell;
    c->skewed = h->skewed;
    sim->grids.kernels->flow_cross_film(c);
}

ovr_heat_power ovr_heat_made(const ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    const ovr_columns *c = &h->film;
    const double *X = c->X, *P = c->P;
    ovr_heat_power sum = {0};
    for (size_t i = 1; i + 1 < c->n; i++) {
        double P_X = (P[i + 1] - P[i - 1]) / (X[i + 1] - X[i - 1]);
        double P_T = c->P_T ? c->P_T[i] : 0, sheared = 0, pressed = 0;
        double bT_f = expansion_at(&h->numbers, P[i]), w = sim->now.weights[i];
        for (int j = 0; ovr_heat_counts(sim, i) && j < h->cross_film.n; j++) {
            double beta = bT_f *
                          expansion_lightness(&h->numbers, bT_f, h->used[j][i]);
            sheared += h->cross_film.w[j] * c->heating[j][i];
            if (P[i] > 0)
                pressed += h->cross_film.w[j] * beta * c->H[i] *
                           (h->numbers.T0 + h->T[j][i]) *
                           (P_T + c->u[j][i] * P_X);
        }
        sum.sheared += w * sheared;
        sum.pressed += w * pressed;
        sum.size += w * fabs(sheared + pressed);
    }
    return sum;
}

double ovr_heat_stored(const ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    const ovr_columns *c = &h->film;
    double stored = 0;
    for (size_t i = 1; i + 1 < c->n; i++) {
        double part = 0;
        for (int j = 0; ovr_heat_counts(sim, i) && j < h->cross_film.n; j++)
            part += h->cross_film.w[j] *
                    (h->T[j][i] - ovr_column_departure(c, j, i)) /
                    ovr_column_travel(c, j, i);
        stored += sim->now.weights[i] * c->q[i] * part;
    }
    return stored / h->numbers.theta;
}

/* -------------------------------------------------------------------- March */

/* Marching along x (equations in heated.h). */

/* Minimum speed of a layer: with opposite sliding, some layer has nearly zero
 * speed. A jump between the two smallest speeds would prevent convergence. */
static const double MIN_SPEED = 0.02, MIN_SPEED_OPPOSED = 1e-9;

/* Sets the speeds of the surfaces at T = 0 and their memories for steps from
 * node to node. */
void ovr_heat_march_begin(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    double D = ovr_mesh(sim), length = (double)(sim->now.n - 1) * D;
    ovr_heat_speeds(sim, 0);
    for (int k = 0; k < 2; k++) {
        double u = h->u1 - k * h->V;
        h->speed[k] = ovr_solid_march_speed(&h->numbers, k, u);
        h->direction[k] = u < 0 || (!(u > 0) && sim->histories.backward) ? -1
                                                                         : 1;
        ovr_memory_fit(D / h->speed[k],
                       fmax(h->longest[k], length / h->speed[k]),
                       &h->memory[k]);
    }
}

static bool opposed(const ovr_heated *h)
{
    return h->direction[0] != h->direction[1];
}

/* State of a march, passed from node to node. */
typedef struct march {
    int direction; /* along x, or against it */
    double psi[2][OVR_MAX_MODES], q[2];
} march;

/* Solves node i. A surface that moves in the opposite direction has the
 * temperatures of the last march. */
static void solve_node(ovr_simulation *sim, size_t i, march *m)
{
    ovr_heated *h = sim->heated;
    ovr_heat_surface *s = h->steps->surface;
    for (int k = 0; k < 2; k++)
        if (h->direction[k] == m->direction)
            s[k].past[i] = ovr_memory_past(&h->memory[k], m->psi[k], m->q[k]) +
                           s[k].along[i];
    ovr_column_heat(&h->film, i);
    for (int j = 0; j < h->cross_film.n; j++)
        h->T[j][i] = ovr_heat_bounded(h, h->T[j][i]);
    for (int k = 0; k < 2; k++) {
        double q = h->q[k][i];
        if (h->direction[k] != m->direction)
            continue;
        ovr_memory_step(&h->memory[k], m->q[k], q, m->psi[k]);
        ovr_heat_steps_keep(sim, k, i, m->psi[k]);
        m->q[k] = q;
    }
}

/* Solves all nodes except one, starting at node i, along x or against it. */
static void march_from(ovr_simulation *sim, size_t i, int direction)
{
    march m = {.direction = direction};
    for (size_t k = 1; k < sim->now.n; k++, i += (size_t)direction)
        solve_node(sim, i, &m);
}

void ovr_heat_march_columns(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    ovr_columns *c = &h->film;
    c->P_T = NULL;
    c->min_u = opposed(h) ? MIN_SPEED_OPPOSED : MIN_SPEED;
    c->both_ways = opposed(h);
    c->back = !opposed(h) && h->direction[0] < 0;
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

/* ------------------------------------------------------------- Coefficients */

/* Effect of temperatures on the film: coefficients of the Reynolds equation
 * (heated.h), and the maximum change per iteration. */

void ovr_heat_speeds(ovr_simulation *sim, double T)
{
    ovr_heated *h = sim->heated;
    h->V = ovr_sliding(sim, T);
    h->u1 = ovr_history_value(sim->histories.speed, T) + h->V / 2;
}

/* Transfers all coefficients to all grids by injection. */
static void restrict_all(ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    const double *const from[] = {h->th, h->shift, h->drag, h->swell};
    double *workspace = ovr_work_take(sim);
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
    ovr_work_give(sim, workspace);
}

void ovr_heat_give(ovr_simulation *sim)
{
    restrict_all(sim);
    ovr_heat_skew_give(sim);
}

void ovr_heat_apply(ovr_simulation *sim)
{
    heat_film_fields(sim);
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

/* A temperature rise changes by at most this fraction of itself plus some
 * kelvins: the first temperatures, those of the isothermal film, may be
 * extremely high. */
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
