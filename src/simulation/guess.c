/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Initial guess of a time step: P and H0 at T + dT, extrapolated from the past.
 *
 * E is one step back and S_s a shift by s D downstream. 1 - E removes
 * stationary parts, and 1 - S_a E removes parts that move by a D per step, as
 * does 1 - S_2a E^2, whose shift may be a whole number.  For films and rolling
 * features a = Cu dT/D. If a = 1, the guess is the newest P in
 *     (1 - E)^2 (1 - S E)^2 P = 0,
 * linear in time for both parts; otherwise that in (1 - E)^3 P = 0 (parabola
 * through the past) or, for unequal steps, a line.
 *
 * For sliding features a = (u_k/um) Cu dT/D, if the speed is known. Several
 * formulas are then available, each the best in some cases: few terms for rough
 * surfaces and fractional shifts, many terms for whole shifts, and (1 - S_a
 * E)(1 - S E) P = 0 for sliding rough surfaces, whose film contains
 * disturbances that move with it. After every fourth step (earlier if a formula
 * is new) the errors of all formulas are compared, and the following steps use
 * the best one.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "multigrid/departures.h"
#include "simulation/mirror.h"

/* In steps longer than this number of mesh sizes, formulas for moving features
 * are worse than the last state. */
static const double longest_moved = 8.5;

typedef struct term {
    double weight;
    int ago, shifts; /* a past P: its age in steps, and the number of
                      * applications of S */
} term;

enum { MAX_TERMS = 8 };

/* Number of steps between comparisons of all formulas. A comparison costs half
 * a cycle, and the best formula rarely changes. */
enum { LEARN_EVERY = 4 };

typedef struct formula {
    size_t count;
    term term[MAX_TERMS]; /* the first is P[0] unchanged */
    double H0[4];
    double meshes; /* shift of S in mesh sizes */
    bool two_terms;
    ptrdiff_t film; /* shift of S' in whole mesh sizes, for the first and last
                     * term */
} formula;

static const formula last = {1, {{1, 0, 0}}, {1, 0, 0, 0}, 0, false, 0};

static const formula parabola = {
    3, {{3, 0, 0}, {-3, 1, 0}, {1, 2, 0}}, {3, -3, 1, 0}, 0, false, 0};

static const formula standing_and_moving = {8,
                                            {{2, 0, 0},
                                             {2, 0, 1},
                                             {-1, 1, 0},
                                             {-4, 1, 1},
                                             {-1, 1, 2},
                                             {2, 2, 1},
                                             {2, 2, 2},
                                             {-1, 3, 2}},
                                            {4, -6, 4, -1},
                                            1,
                                            false,
                                            0};

static const formula by_two_steps = {
    5,
    {{2, 0, 0}, {-1, 1, 0}, {1, 1, 1}, {-2, 2, 1}, {1, 3, 1}},
    {2, 0, -2, 1},
    1,
    false,
    0};

/* P_0 + S (P_k - P_{k+1}) */
static formula two_terms(int k, double meshes)
{
    return (formula){
        3, {{1, 0, 0}, {1, k, 1}, {-1, k + 1, 1}}, {2, -1, 0, 0}, meshes, true,
        0};
}

/* S' P_0 + S (P_0 - S' P_1): one part moves with the features, the other with
 * the film */
static formula each_moves(double meshes, double film)
{
    formula how = two_terms(0, meshes);
    how.film = (ptrdiff_t)nearbyint(film);
    return how;
}

static formula line(double s)
{
    return (formula){
        2, {{1 + s, 0, 0}, {-s, 1, 0}}, {1 + s, -s, 0, 0}, 0, false, 0};
}

/* True if the last `steps` steps and the next one have the same length. */
static bool equal_steps(const ovr_past *past, double dT, int steps)
{
    bool equal = past->steps >= steps;
    for (int k = 0; k < steps; k++)
        equal &= fabs(past->T[k] - past->T[k + 1] - dT) < 1e-9 * dT;
    return equal;
}

/* The accuracy of S need only be a fraction of the error of the guess. */
static bool is_whole(double meshes)
{
    return fabs(meshes - nearbyint(meshes)) < 0.01 && fabs(meshes) > 0.5;
}

static formula shifted(formula how, double meshes)
{
    how.meshes = nearbyint(meshes);
    return how;
}

/* Extrapolates a field from its past, with whole shifts. */
static void extrapolate(const ovr_simulation *sim, const formula *how,
                        ptrdiff_t margin, double *const past[OVR_PAST],
                        double *guess)
{
    const double *from[MAX_TERMS];
    double weight[MAX_TERMS];
    for (size_t k = 0; k < how->count; k++) {
        const term *t = &how->term[k];
        from[k] = past[t->ago] + margin - t->shifts * (ptrdiff_t)how->meshes;
        weight[k] = t->weight;
    }
    sim->grids.kernels->extrapolate(sim->now.n - 2 * (size_t)margin, how->count,
                                    weight, from, guess + margin);
}

/* Extrapolates with two terms and any shift. */
static void carry(const ovr_simulation *sim, const formula *how,
                  ptrdiff_t margin, double *const past[OVR_PAST], double *guess)
{
    double c[4], whole = floor(-how->meshes);
    ptrdiff_t first = margin + (ptrdiff_t)whole - 1;
    const double *const from[] = {past[0] + margin - how->film,
                                  past[how->term[1].ago] + first,
                                  past[how->term[2].ago] + first - how->film};
    size_t n = sim->now.n - 2 * (size_t)margin;
    ovr_cubic_weights(-how->meshes - whole, c);
    sim->grids.kernels->carry(n, c, from, guess + margin);
    if (how->film) { /* cavitated nodes stay cavitated */
        const double *const wet[] = {past[0] + margin, guess + margin};
        sim->grids.kernels->extrapolate(n, 2, (const double[]){0, 1}, wet,
                                        guess + margin);
    }
}

/* Number of nodes at both ends that keep their values, because the formula
 * would need nodes outside the grid. */
static ptrdiff_t margin_of(const formula *how)
{
    return 2 + 2 * (ptrdiff_t)ceil(fabs(how->meshes)) + labs(how->film);
}

static void guess_field(const ovr_simulation *sim, const formula *how,
                        double *const past[OVR_PAST], double *guess)
{
    size_t margin = (size_t)margin_of(how), rear = sim->now.n - margin;
    memcpy(guess, past[0], margin * sizeof *guess);
    memcpy(guess + rear, past[0] + rear, margin * sizeof *guess);
    (how->two_terms ? carry : extrapolate)(sim, how, (ptrdiff_t)margin, past,
                                           guess);
}

/* Distance that the film moves along x in a step dT, in mesh sizes. */
static double film_meshes(const ovr_simulation *sim, double dT)
{
    double Cu = sim->grids.op.speed;
    return (sim->histories.backward ? -Cu : Cu) * dT / ovr_mesh(sim);
}

/* Formula for features whose speed is unknown: they move at the entrainment
 * speed. */
static formula untold(const ovr_simulation *sim, double dT)
{
    const ovr_past *past = &sim->past;
    double a = film_meshes(sim, dT);
    if (dT > (ovr_longest_step(sim) + 0.5) * ovr_mesh(sim))
        return last;
    if (equal_steps(past, dT, 3) && fabs(fabs(a) - 1) < 0.01)
        return shifted(standing_and_moving, a);
    if (equal_steps(past, dT, 2))
        return parabola;
    return line(past->dT > 0 ? dT / past->dT : 0);
}

/* Writes the extrapolation formulas for features that move by `a` mesh sizes
 * per step and a film that moves by `film`, and returns their number. All
 * formulas are available only for equal steps. */
static size_t candidates(const ovr_simulation *sim, double a, double film,
                         bool three, formula found[OVR_GUESSES],
                         size_t number[OVR_GUESSES])
{
    enum { NODES = 64 }; /* grid too small for extrapolation */
    const formula all[OVR_GUESSES] = {shifted(standing_and_moving, a),
                                      shifted(by_two_steps, 2 * a),
                                      two_terms(0, a),
                                      two_terms(1, 2 * a),
                                      shifted(standing_and_moving, film),
                                      parabola,
                                      last,
                                      each_moves(a, film)};
    const bool can[OVR_GUESSES] = {three && is_whole(a),
                                   three && is_whole(2 * a),
                                   true,
                                   true,
                                   three && is_whole(film) && film != a,
                                   true,
                                   true,
                                   is_whole(film) && fabs(film - a) > 0.01};
    size_t count = 0;
    for (size_t k = 0; k < OVR_GUESSES; k++)
        if (can[k] && 2 * margin_of(&all[k]) + NODES < (ptrdiff_t)sim->now.n) {
            found[count] = all[k];
            number[count++] = k;
        }
    return count;
}

/* Determines whether moving features are followed in a step dT, and the
 * formulas for it. */
static size_t follow(const ovr_simulation *sim, double dT,
                     formula found[OVR_GUESSES], size_t number[OVR_GUESSES])
{
    const ovr_past *past = &sim->past;
    double film = film_meshes(sim, dT);
    double a = sim->shapes.moving * film;
    bool moves = isfinite(a) && a != 0;
    if (!moves || dT > longest_moved * ovr_mesh(sim) ||
        !equal_steps(past, dT, 2))
        return 0;
    return candidates(sim, a, film, equal_steps(past, dT, 3), found, number);
}

/* Index of the formula with the smallest recent error; OVR_GUESSES if none is
 * known. */
static size_t nearest_of(const double *off, size_t count, const size_t number[])
{
    size_t best = OVR_GUESSES;
    for (size_t k = 0; k < count; k++)
        if (off[number[k]] > 0 &&
            (best == OVR_GUESSES || off[number[k]] < off[number[best]]))
            best = k;
    return best;
}

/* In rolling contacts, formulas with stationary and moving parts are preferred
 * if their error (in p_h) is below this: cycles then need no sweeps after the
 * coarse-grid correction. */
static const double near_enough = 1e-5;

static bool rolls_closely(const ovr_simulation *sim, size_t count,
                          const size_t number[])
{
    const double *off = sim->past.guess_error;
    return sim->shapes.moving == 1 && count && number[0] == 0 && off[0] > 0 &&
           off[0] < near_enough;
}

static formula formula_for(const ovr_simulation *sim, double dT)
{
    formula found[OVR_GUESSES];
    size_t number[OVR_GUESSES], count, best;
    if (sim->past.steps < 1)
        return last;
    count = follow(sim, dT, found, number);
    if (rolls_closely(sim, count, number))
        return found[0];
    best = nearest_of(sim->past.guess_error, count, number);
    return best < OVR_GUESSES ? found[best] : untold(sim, dT);
}

static bool all_known(const double *off, size_t count, const size_t number[])
{
    bool known = true;
    for (size_t k = 0; k < count; k++)
        known &= off[number[k]] > 0;
    return known;
}

void ovr_guess_update(ovr_simulation *sim, double dT)
{
    formula found[OVR_GUESSES];
    size_t number[OVR_GUESSES], count = follow(sim, dT, found, number);
    double *off = sim->past.guess_error;
    if (sim->state.step % LEARN_EVERY && all_known(off, count, number))
        return;
    double *guess = ovr_work_take(sim);
    for (size_t k = 0; k < count; k++) {
        double *mean = &off[number[k]], error;
        guess_field(sim, &found[k], sim->past.P, guess);
        error = sim->grids.kernels->difference(sim->now.n, guess, sim->now.P);
        *mean = *mean > 0 ? (*mean + error) / 2 : error;
    }
    ovr_work_give(sim, guess);
}

bool ovr_guess(ovr_simulation *sim, double dT, bool extrapolated)
{
    const ovr_past *past = &sim->past;
    formula how = extrapolated ? formula_for(sim, dT) : last;
    double *guess = ovr_work_take(sim);
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (ovr_field_rows[k].guessed) {
            guess_field(sim, &how, past->all[k], guess);
            ovr_nodes_write(sim, sim->finest, guess, sim->finest->f.all[k]);
        }
    ovr_work_give(sim, guess);
    sim->grids.H0 = 0;
    for (int k = 0; k < OVR_PAST; k++)
        sim->grids.H0 += how.H0[k] * past->H0[k];
    return how.count == standing_and_moving.count &&
           (sim->shapes.moving == 1 || isnan(sim->shapes.moving));
}

void ovr_simulation_moving(ovr_simulation *sim, double speed)
{
    if (!sim)
        return;
    sim->shapes.moving = speed;
}
