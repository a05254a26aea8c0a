/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Thermal memory of the surfaces (equations in surfaces.h). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "physics/heat/in_time.h"
#include "simulation/physics.h"

static double *allocate(ovr_simulation *sim, size_t count, ovr_error *err)
{
    return ovr_arena_take(&sim->arena, count, sizeof(double), err);
}

static double speed_of(const ovr_simulation *sim, int k)
{
    return k ? sim->contact.u2_ratio : sim->contact.u1_ratio;
}

/* Duration of two passages through the domain. */
static double passages(const ovr_simulation *sim, double u)
{
    double length = (double)(sim->now.n - 1) * ovr_mesh(sim);
    return 2 * length / fmax(fabs(u), 0.1);
}

/* Longest time of the memory: two passages, heat conduction along the slowest
 * surface, and the memory of a steady march (columns.c). Kernels are not
 * fitted beyond this time. */
static double longest(const ovr_simulation *sim, int k)
{
    const ovr_heat *numbers = &sim->heated->numbers;
    double slowest = numbers->slowest[k];
    double length = (double)(sim->now.n - 1) * ovr_mesh(sim);
    double march = length / ovr_solid_march_speed(numbers, k, slowest);
    return fmax(fmax(passages(sim, speed_of(sim, k)), fmin(march, OVR_OLDEST)),
                ovr_solid_reach(numbers, k, slowest));
}

static void set_rates(ovr_simulation *sim, int k)
{
    ovr_heated *h = sim->heated;
    double D = ovr_mesh(sim);
    h->longest[k] = longest(sim, k);
    ovr_warmth warmth = {NULL, NULL};
    ovr_memory_rates(D / 8, h->longest[k], &h->memory[k]);
    OVR_EACH_PHYSICS(sim, p, in_solve, warmth)
        p->is->in_solve->warmth(sim, p->own, k, &warmth);
    if (warmth.at)
        ovr_memory_layered(D / 8, h->longest[k], warmth, &h->memory[k]);
}

static int banks_of(const ovr_simulation *sim, int k)
{
    return sim->heated->memory[k].banks;
}

/* Uses only numbers that are known when memory is only counted. */
ovr_status ovr_heat_surface_take(ovr_simulation *sim, int k, ovr_error *err)
{
    const ovr_heat *heat = &sim->heated->numbers;
    ovr_heat_surface *s = &sim->heated->steps->surface[k];
    double D = ovr_mesh(sim), u = heat->peclet[k] * heat->diffusion[k];
    size_t n = sim->now.n, N;
    set_rates(sim, k);
    s->beyond = (size_t)fmin(ovr_solid_beyond(heat, k, u, D) / D, (double)n);
    N = n + 2 * s->beyond;
    for (int a = 0; a < OVR_HEAT_WORKSPACES; a++)
        s->workspace[a] = allocate(sim, N, err);
    for (int b = 0; b < banks_of(sim, k); b++)
        s->psi[b] = allocate(sim, N * OVR_MODES, err);
    if (banks_of(sim, k) > 1) {
        s->none = allocate(sim, N, err);
        s->bank = allocate(sim, N, err);
        s->unused = allocate(sim, N, err);
    }
    s->next = allocate(sim, N * OVR_MODES, err);
    s->before = allocate(sim, N, err);
    s->past = allocate(sim, n, err);
    s->along = allocate(sim, n, err);
    return ovr_arena_status(&sim->arena);
}

/* Psi_m at the nodes, for one bank. */
static double *modes_of(const ovr_simulation *sim, int k, int bank)
{
    const ovr_heat_surface *s = &sim->heated->steps->surface[k];
    return s->psi[bank] + s->beyond * OVR_MODES;
}

void ovr_heat_surface_reset(ovr_simulation *sim, int k)
{
    ovr_heat_surface *s = &sim->heated->steps->surface[k];
    size_t n = sim->now.n;
    for (int b = 0; b < banks_of(sim, k); b++)
        memset(s->psi[b], 0,
               (n + 2 * s->beyond) * OVR_MODES * sizeof *s->psi[b]);
    memset(s->past, 0, n * sizeof *s->past);
    memset(s->along, 0, n * sizeof *s->along);
}

static void visit_nodes(ovr_simulation *sim, int k, int m, ovr_pieces *state)
{
    double *mode = sim->heated->steps->surface[k].workspace[0];
    double *psi = modes_of(sim, k, m / OVR_MODES) + m % OVR_MODES;
    size_t n = sim->now.n;
    char name[20];
    for (size_t i = 0; i < n; i++)
        mode[i] = psi[i * OVR_MODES];
    snprintf(name, sizeof name, "memory_%d", k + 1);
    ovr_show_nodes(sim, state, name, m + 1, mode);
    for (size_t i = 0; i < n; i++)
        psi[i * OVR_MODES] = mode[i];
}

/* Visits the memory beyond the ends of the domain. */
static void visit_ends(ovr_simulation *sim, int k, int bank, ovr_pieces *state)
{
    const ovr_heat_surface *s = &sim->heated->steps->surface[k];
    double *psi = s->psi[bank];
    size_t n = sim->now.n, bytes = s->beyond * OVR_MODES * sizeof *psi;
    const char *second = bank ? "_2" : "";
    char name[40];
    snprintf(name, sizeof name, "memory_%d_before%s", k + 1, second);
    ovr_show(state, name, psi, bytes);
    snprintf(name, sizeof name, "memory_%d_after%s", k + 1, second);
    ovr_show(state, name, psi + (s->beyond + n) * OVR_MODES, bytes);
}

void ovr_heat_surface_visit(ovr_simulation *sim, int k, ovr_pieces *state)
{
    for (int b = 0; b < banks_of(sim, k); b++) {
        for (int m = 0; m < OVR_MODES; m++)
            visit_nodes(sim, k, b * OVR_MODES + m, state);
        visit_ends(sim, k, b, state);
    }
}

/* Rounds a time step, so that steps that differ only by rounding errors are
 * equal. */
static double rounded(double dT)
{
    int exponent;
    double part = frexp(dT, &exponent);
    return ldexp(nearbyint(ldexp(part, 26)), exponent - 26);
}

/* Computes the weights for this step length, unless it equals that of the last
 * step. */
static void fit(const ovr_heated *h, int k, double length)
{
    ovr_memory *m = &h->steps->surface[k].memory;
    double dT = rounded(length);
    if (m->dT == dT)
        return;
    memcpy(m->rate, h->memory[k].rate, sizeof m->rate);
    m->warmth = h->memory[k].warmth;
    m->banks = h->memory[k].banks;
    ovr_memory_fit(dT, fmax(h->longest[k], 2 * dT), m);
}

void ovr_heat_surface_step(ovr_simulation *sim, int k, double dT, double meshes)
{
    const ovr_heated *h = sim->heated;
    ovr_heat_surface *s = &h->steps->surface[k];
    double D = ovr_mesh(sim), u = meshes * D / dT;
    s->meshes = meshes;
    for (int b = 0; b < banks_of(sim, k); b++)
        s->spread[b] = ovr_solid_conducts(&h->numbers, k, u)
                           ? ovr_spread_of(h->numbers.diffusion[k], u, dT, D,
                                           h->memory[k].rate + b * OVR_MODES)
                           : (ovr_spread){.on = false};
    fit(h, k, dT);
}

/* Extends q by zeros at the nodes beyond both ends. */
static const double *longer(const ovr_simulation *sim, ovr_heat_surface *s,
                            const double *q, double *workspace)
{
    size_t n = sim->now.n, beyond = s->beyond;
    memset(workspace, 0, beyond * sizeof *workspace);
    memcpy(workspace + beyond, q, n * sizeof *workspace);
    memset(workspace + beyond + n, 0, beyond * sizeof *workspace);
    return workspace;
}

static ovr_departures departures_of(const ovr_simulation *sim,
                                    const ovr_heat_surface *s)
{
    return ovr_departures_of(sim->now.n + 2 * s->beyond, s->meshes);
}

static void sum_modes_of(ovr_simulation *sim, ovr_heat_surface *s, int bank,
                         const double *q, double *past, double *before)
{
    const ovr_departures departures = departures_of(sim, s);
    const ovr_modes_look sum_past = {
        .run = sim->grids.kernels,
        .departures = &departures,
        .spread = &s->spread[bank],
        .dT = s->memory.dT,
        .more = {s->memory.more[0], s->memory.more[1]},
        .weight = s->memory.weight + bank * OVR_MODES,
        .psi = s->psi[bank],
        .q = q,
        .workspace = s->workspace[2],
        .fields = s->next,
        .past = past,
        .before = before};
    ovr_modes_past(&sum_past);
}

/* Computes the contribution of the past at the nodes; copies the previous q to
 * `before`. */
static const double *sum_past(ovr_simulation *sim, ovr_heat_surface *s,
                              const double *q)
{
    double *past = s->workspace[1];
    size_t N = sim->now.n + 2 * s->beyond;
    sum_modes_of(sim, s, 0, longer(sim, s, q, s->workspace[0]), past,
                 s->before);
    if (s->memory.banks > 1) {
        sum_modes_of(sim, s, 1, s->none, s->bank, s->unused);
        for (size_t i = 0; i < N; i++)
            past[i] += s->bank[i];
    }
    return past + s->beyond;
}

void ovr_heat_surface_predict(ovr_simulation *sim, int k, const double *q)
{
    ovr_heat_surface *s = &sim->heated->steps->surface[k];
    memcpy(s->past, sum_past(sim, s, q), sim->now.n * sizeof *q);
}

void ovr_heat_surface_store(ovr_simulation *sim, int k, const double *q)
{
    ovr_heat_surface *s = &sim->heated->steps->surface[k];
    const ovr_departures departures = departures_of(sim, s);
    const ovr_memory *m = &s->memory;
    longer(sim, s, q, s->workspace[0]);
    for (int b = 0; b < m->banks; b++) {
        double *psi = s->psi[b];
        const ovr_modes_step step = {.departures = &departures,
                                     .spread = &s->spread[b],
                                     .fade = m->fade + b * OVR_MODES,
                                     .now = m->now + b * OVR_MODES,
                                     .before = m->before + b * OVR_MODES,
                                     .q = s->workspace[0],
                                     .q_before = s->before};
        sim->grids.kernels->step_modes(&step, psi, s->next);
        s->psi[b] = s->next;
        s->next = psi;
    }
}

/* ------------------------------------------------------------------ steady */

/* along <- K q - K_march q; `past` contains K q except for the instantaneous
 * part. */
static void set_along(ovr_simulation *sim, int k, const double *past)
{
    const ovr_heated *h = sim->heated;
    const ovr_heat_surface *s = &h->steps->surface[k];
    const ovr_memory *march = &h->memory[k];
    const double *q = h->q[k];
    double psi[OVR_MAX_MODES] = {0}, before = 0;
    double own = 4.0 / 3 *
                 (sqrt(s->memory.dT) * (1 + s->memory.more[0]) -
                  sqrt(march->dT) * (1 + march->more[0]));
    size_t n = sim->now.n;
    for (size_t j = 0; j < n; j++) {
        size_t i = h->direction[k] > 0 ? j : n - 1 - j;
        s->along[i] = past[i] + own * q[i] -
                      ovr_memory_past(march, psi, before);
        ovr_memory_step(march, before, q[i], psi);
        before = q[i];
    }
}

void ovr_heat_surface_steady(ovr_simulation *sim, int k)
{
    const ovr_heated *h = sim->heated;
    ovr_heat_surface *s = &h->steps->surface[k];
    double D = ovr_mesh(sim), u = h->u1 - k * h->V;
    longer(sim, s, h->q[k], s->workspace[0]);
    for (int b = 0; b < banks_of(sim, k); b++)
        ovr_modes_steady(sim->now.n + 2 * s->beyond, D, h->numbers.diffusion[k],
                         h->direction[k] * fabs(u),
                         h->memory[k].rate + b * OVR_MODES, s->workspace[0],
                         s->psi[b]);
    ovr_heat_surface_step(sim, k, D, u);
    set_along(sim, k, sum_past(sim, s, h->q[k]));
}

void ovr_heat_steps_keep(const ovr_simulation *sim, int surface, size_t i,
                         const double *psi)
{
    for (int b = 0; b < sim->heated->memory[surface].banks; b++)
        memcpy(modes_of(sim, surface, b) + i * OVR_MODES, psi + b * OVR_MODES,
               OVR_MODES * sizeof *psi);
}
