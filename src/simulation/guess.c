/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a step begins from: P and H0 at T + dT, extrapolated from the past.
 *
 * With E one step back and S one mesh downstream, 1 - E takes away what
 * stands still, 1 - S E what moves by a mesh a step: films and rolling
 * features, at the mean speed of the surfaces, when Cu dT = D.  The guess is
 *     (1 - E)^2 (1 - S E)^2 P = 0
 * solved for the newest P: linear in time for both.  When Cu dT is something
 * else it is (1 - E)^3 P = 0, the parabola through the past, or for unequal
 * steps the line.
 */
#include <math.h>
#include <string.h>

#include "simulation/internal.h"

/* Steps beyond this many meshes begin better from the last state. */
static const double longest = 7.9;

typedef struct term {
    double weight;
    int ago, meshes; /* of a past P: its age in steps; how far upstream */
} term;

/* UPSTREAM: most meshes of a term. */
enum { MOST_TERMS = 8, UPSTREAM = 2 };

typedef struct formula {
    size_t count;
    term term[MOST_TERMS]; /* the first is P[0] as it is */
    double H0[4];
} formula;

static const formula last = {1, {{1, 0, 0}}, {1, 0, 0, 0}};

static const formula parabola = {
    3, {{3, 0, 0}, {-3, 1, 0}, {1, 2, 0}}, {3, -3, 1, 0}};

static const formula standing_and_moving = {8,
                                            {{2, 0, 0},
                                             {2, 0, 1},
                                             {-1, 1, 0},
                                             {-4, 1, 1},
                                             {-1, 1, 2},
                                             {2, 2, 1},
                                             {2, 2, 2},
                                             {-1, 3, 2}},
                                            {4, -6, 4, -1}};

static formula line(double s)
{
    return (formula){2, {{1 + s, 0, 0}, {-s, 1, 0}}, {1 + s, -s, 0, 0}};
}

/* The last so many steps, and the one to come, are equally long. */
static bool equal_steps(const ovr_past *past, double dT, int steps)
{
    bool equal = past->steps >= steps;
    for (int k = 0; k < steps; k++)
        equal &= fabs(past->T[k] - past->T[k + 1] - dT) < 1e-9 * dT;
    return equal;
}

/* S need only be right to a part of the guess's own error. */
static bool moves_a_mesh(const ovr_simulation *sim, double dT)
{
    return fabs(sim->grids.op.speed * dT / sim->finest->grid.D - 1) < 0.01;
}

/* A field from its past.  The first nodes, of which nothing lies upstream, stay
 * what they are. */
static void extrapolate(const ovr_simulation *sim, const formula *how,
                        double *const past[OVR_PAST], double *guess)
{
    const double *from[MOST_TERMS];
    double weight[MOST_TERMS];
    size_t moved = sim->finest->grid.n - UPSTREAM;
    for (size_t k = 0; k < how->count; k++) {
        const term *t = &how->term[k];
        from[k] = past[t->ago] + UPSTREAM - t->meshes;
        weight[k] = t->weight;
    }
    memcpy(guess, past[0], UPSTREAM * sizeof *guess);
    sim->grids.kernels->extrapolate(moved, how->count, weight, from,
                                    guess + UPSTREAM);
}

static formula formula_for(const ovr_simulation *sim, double dT)
{
    const ovr_past *past = &sim->past;
    if (past->steps < 1 || dT > longest * sim->finest->grid.D)
        return last;
    if (equal_steps(past, dT, 3) && moves_a_mesh(sim, dT))
        return standing_and_moving;
    if (equal_steps(past, dT, 2))
        return parabola;
    return line(past->dT > 0 ? dT / past->dT : 0);
}

bool ovr_guess(ovr_simulation *sim, double dT, bool extrapolated)
{
    const ovr_past *past = &sim->past;
    formula how = extrapolated ? formula_for(sim, dT) : last;
    double *guess = sim->grids.scratch[0];
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (ovr_field_rows[k].guessed) {
            extrapolate(sim, &how, past->all[k], guess);
            ovr_level_write(&sim->grids, sim->finest, guess,
                            sim->finest->f.all[k]);
        }
    sim->grids.H0 = 0;
    for (int k = 0; k < OVR_PAST; k++)
        sim->grids.H0 += how.H0[k] * past->H0[k];
    return how.count == standing_and_moving.count;
}
