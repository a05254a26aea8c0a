/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Thermal memory of moving half-spaces (equations in solids.h). */
#include "physics/heat/solids.h"

#include <math.h>
#include <stdbool.h>

static const double FAST = 50; /* Peclet number */

bool ovr_solid_conducts(const ovr_heat *numbers, int k, double u)
{
    double kappa = numbers->diffusion[k];
    return kappa > 0 && fabs(u) <= FAST * kappa;
}

double ovr_solid_reach(const ovr_heat *numbers, int k, double u)
{
    const double wide = 100; /* b */
    double kappa = numbers->diffusion[k];
    if (!ovr_solid_conducts(numbers, k, u))
        return 0;
    return fmin(OVR_OLDEST, fmin(20 * kappa / (u * u), wide * wide / kappa));
}

double ovr_solid_march_speed(const ovr_heat *numbers, int k, double u)
{
    const double without = 0.02; /* heat conduction along the surface is
                                  * neglected above this */
    double minimum = numbers->min_peclet * numbers->diffusion[k];
    return fmax(fabs(u), minimum > 0 ? minimum : without);
}

double ovr_solid_beyond(const ovr_heat *numbers, int k, double u, double D)
{
    const double maximum = 2;
    double kappa = numbers->diffusion[k], step = 4 * sqrt(kappa * D) + 4 * D;
    if (!ovr_solid_conducts(numbers, k, u))
        return step;
    return step + fmin(maximum, 2 * kappa / fabs(u));
}

enum { SAMPLES = 400 };

typedef struct fit {
    long double matrix[SAMPLES][OVR_MAX_MODES], right[SAMPLES];
    int modes;
} fit;

static void set_rates(double shortest, double longest, int banks,
                      ovr_memory *memory)
{
    int modes = banks * OVR_MODES;
    double first = 0.3 / longest, last = 8 / shortest;
    double ratio = pow(last / first, 1.0 / (modes - 1));
    for (int m = 0; m < modes; m++)
        memory->rate[m] = first * pow(ratio, m);
    memory->banks = banks;
}

void ovr_memory_rates(double shortest, double longest, ovr_memory *memory)
{
    set_rates(shortest, longest, 1, memory);
    memory->warmth = (ovr_warmth){NULL, NULL};
}

void ovr_memory_layered(double shortest, double longest, ovr_warmth warmth,
                        ovr_memory *memory)
{
    set_rates(shortest, longest, OVR_BANKS, memory);
    memory->warmth = warmth;
}

static int modes_of(const ovr_memory *memory)
{
    return memory->banks * OVR_MODES;
}

static double warmth(const ovr_memory *memory, double t)
{
    return memory->warmth.at ? memory->warmth.at(memory->warmth.data, t) : 1;
}

/* Integrates by Simpson's rule; M is evaluated as a limit at v = 0. */
static void fit_step(ovr_memory *memory)
{
    enum { PARTS = 64 };
    double own = 0, last = 0;
    memory->more[0] = memory->more[1] = 0;
    if (!memory->warmth.at)
        return;
    for (int k = 0; k <= PARTS; k++) {
        double v = fmax((double)k / PARTS, 1e-4);
        double share = k == 0 || k == PARTS ? 1 : k % 2 ? 4 : 2;
        double M = share / (3 * PARTS) * warmth(memory, memory->dT * v * v);
        own += 1.5 * (1 - v * v) * M;
        last += 3 * v * v * M;
    }
    memory->more[0] = own - 1;
    memory->more[1] = last - 1;
}

/* Rows sqrt(t) e^(-s t), right-hand side 1, at geometrically spaced times. */
static void fill(fit *f, const ovr_memory *memory, double dT, double longest)
{
    long double ratio = powl((long double)longest / dT, 1.0L / (SAMPLES - 1));
    long double t = dT;
    f->modes = modes_of(memory);
    for (int k = 0; k < SAMPLES; k++, t *= ratio) {
        long double over = sqrtl(t) / warmth(memory, (double)t);
        for (int m = 0; m < f->modes; m++)
            f->matrix[k][m] = over * expl(-memory->rate[m] * t);
        f->right[k] = 1;
    }
}

/* Subtracts from the later columns and the right-hand side their projection on
 * column m. */
static long double orthogonalize(fit *f, int m, long double part[])
{
    long double norm = 0;
    for (int k = 0; k < SAMPLES; k++)
        norm += f->matrix[k][m] * f->matrix[k][m];
    for (int c = m + 1; c <= f->modes; c++) {
        part[c] = 0;
        for (int k = 0; k < SAMPLES; k++)
            part[c] += f->matrix[k][m] *
                       (c < f->modes ? f->matrix[k][c] : f->right[k]);
        part[c] /= norm;
        for (int k = 0; k < SAMPLES; k++)
            *(c < f->modes ? &f->matrix[k][c]
                           : &f->right[k]) -= part[c] * f->matrix[k][m];
    }
    return norm;
}

/* Number of modes that have not decayed after a step; the others get no weight.
 */
static int modes_alive(const ovr_memory *memory, double dT)
{
    const double forgotten = 36; /* e^-36 is below rounding */
    int alive = modes_of(memory);
    while (alive > 1 && memory->rate[alive - 1] * dT > forgotten)
        alive--;
    return alive;
}

/* Least squares by modified Gram and Schmidt. */
static void solve(fit *f, int modes, double weight[])
{
    long double part[OVR_MAX_MODES][OVR_MAX_MODES + 1];
    for (int m = 0; m < modes; m++)
        orthogonalize(f, m, part[m]);
    for (int m = modes - 1; m >= 0; m--) {
        long double w = part[m][f->modes];
        for (int c = m + 1; c < modes; c++)
            w -= part[m][c] * weight[c];
        weight[m] = (double)w;
    }
}

void ovr_memory_fit(double dT, double longest, ovr_memory *memory)
{
    double weight[OVR_MAX_MODES] = {0};
    fit f;
    fill(&f, memory, dT, longest);
    solve(&f, modes_alive(memory, dT), weight);
    memory->dT = dT;
    fit_step(memory);
    for (int m = 0; m < modes_of(memory); m += OVR_MODES)
        ovr_modes_integrals(dT, memory->rate + m, memory->fade + m,
                            memory->now + m, memory->before + m);
    for (int m = 0; m < modes_of(memory); m++)
        memory->weight[m] = weight[m] * memory->fade[m];
}

double ovr_memory_past(const ovr_memory *memory, const double *psi, double q)
{
    double sum = 2.0 / 3 * sqrt(memory->dT) * q * (1 + memory->more[1]);
    for (int m = 0; m < modes_of(memory); m++)
        sum += memory->weight[m] * psi[m];
    return sum;
}

void ovr_memory_step(const ovr_memory *memory, double q_before, double q,
                     double *psi)
{
    for (int m = 0; m < modes_of(memory); m++)
        psi[m] = memory->fade[m] * psi[m] + memory->now[m] * q +
                 memory->before[m] * q_before;
}
