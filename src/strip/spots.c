/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Newton's method on small patches of a grid, where cycles stall.
 *
 *     sum_c [A_rc + sum_m B_rm k(m - c)] dP_c = r_r,   B_rm = dN_r/dH_m
 *
 * Unknowns are the pressures of nodes that can change, at most 3 rows and 3
 * lines away from the centre of the patch. The influence k is complete within
 * the patch; all other pressures and H0 are constant. Negative results are set
 * to zero.  The derivative of the flow by the films is that of the gap's mean
 * (faces.kernel.c).
 *
 * The centres are the nodes with the largest contributions to R. In rough
 * sliding films, R stalls at few nodes. Most of them are in pockets near the
 * outlet that are about to cavitate or to become pressurized. Relaxation and
 * coarse-grid corrections change the pressure of such a node in opposite
 * directions.
 *
 * Cost: 0.05 ms for a patch of 49 unknowns, and a refresh of the level.
 */
#include <math.h>
#include <string.h>

#include "strip/across.h"
#include "strip/kernels.h"

enum { REACH = 3, SIDE = 2 * REACH + 1, MOST = OVR_STRIP_SPOT, PATCHES = 12 };

typedef struct place {
    size_t i, j;
} place;

/* Derivatives of row r with respect to the node, W, E, S, N and the second node
 * upstream. */
enum { SELF, WEST, EAST, SOUTH, NORTH, FAR, STENCIL };

typedef struct derivatives {
    place at[STENCIL];
    double by_pressure[STENCIL], by_film[STENCIL];
} derivatives;

static size_t element(const ovr_strip_grid *g, place p)
{
    return ovr_strip_row(g, p.i) + p.j;
}

/* Adds the derivatives of a flow with respect to the film thicknesses of its
 * nodes a and b. */
static void add_by_film(const ovr_strip_fields *f, size_t a, size_t b,
                        double flow, double *by_a, double *by_b)
{
    const double thinnest = 1e-6;
    double H = fmax(f->H[a], thinnest), G = fmax(f->H[b], thinnest);
    double h = H * H * H, g = G * G * G;
    *by_a += flow * 3 * g / ((h + g) * H);
    *by_b += flow * 3 * h / ((h + g) * G);
}

static derivatives derivatives_at(const ovr_strip_level *level, place p)
{
    const ovr_strip_grid *g = &level->grid;
    const ovr_strip_fields *f = &level->f;
    const double *a = p.i == 1 ? level->weights.first : level->weights.a;
    size_t far = p.i >= 2 ? p.i - 2 : p.i - 1;
    size_t south = ovr_across_line(g->lines, (ptrdiff_t)p.j - 1);
    size_t north = ovr_across_line(g->lines, (ptrdiff_t)p.j + 1);
    derivatives d = {.at = {p,
                            {p.i - 1, p.j},
                            {p.i + 1, p.j},
                            {p.i, south},
                            {p.i, north},
                            {far, p.j}}};
    size_t k[STENCIL];
    for (int m = 0; m < STENCIL; m++)
        k[m] = element(g, d.at[m]);
    double *by = d.by_pressure, *film = d.by_film;
    by[SELF] = -f->along_after[k[WEST]] - f->along_before[k[SELF]] -
               f->across_after[k[SOUTH]] - f->across_before[k[SELF]] -
               a[0] * f->dq[k[SELF]];
    by[WEST] = f->along_before[k[WEST]] - a[1] * f->dq[k[WEST]];
    by[EAST] = f->along_after[k[SELF]];
    by[SOUTH] = f->across_before[k[SOUTH]];
    by[NORTH] = f->across_after[k[SELF]];
    by[FAR] = -a[2] * f->dq[k[FAR]];
    const double *P = f->P;
    double in = f->along[k[WEST]] * (P[k[WEST]] - P[k[SELF]]);
    double out = f->along[k[SELF]] * (P[k[EAST]] - P[k[SELF]]);
    double below = f->across[k[SOUTH]] * (P[k[SOUTH]] - P[k[SELF]]);
    double above = f->across[k[SELF]] * (P[k[NORTH]] - P[k[SELF]]);
    add_by_film(f, k[SELF], k[WEST], in, &film[SELF], &film[WEST]);
    add_by_film(f, k[SELF], k[EAST], out, &film[SELF], &film[EAST]);
    add_by_film(f, k[SELF], k[SOUTH], below, &film[SELF], &film[SOUTH]);
    add_by_film(f, k[SELF], k[NORTH], above, &film[SELF], &film[NORTH]);
    film[SELF] -= a[0] * f->rho[k[SELF]];
    film[WEST] -= a[1] * f->rho[k[WEST]];
    film[FAR] -= a[2] * f->rho[k[FAR]];
    return d;
}

static double influence(const ovr_strip_level *level, place a, place b)
{
    size_t d = a.i > b.i ? a.i - b.i : b.i - a.i;
    return level->near[ovr_across_apart(level->grid.lines, a.j, b.j)][d];
}

/* Finds the nodes of a patch that can change. */
static size_t find_nodes(const ovr_strip_level *level, place centre,
                         place node[MOST])
{
    const ovr_strip_grid *g = &level->grid;
    const size_t side = g->lines < SIDE ? g->lines : SIDE;
    size_t count = 0;
    for (size_t i = centre.i > REACH ? centre.i - REACH : 1;
         i <= centre.i + REACH && i + 1 < g->n; i++)
        for (size_t k = 0; k < side; k++) {
            ptrdiff_t j = (ptrdiff_t)(centre.j + k) - (ptrdiff_t)(side / 2);
            place p = {i, ovr_across_line(g->lines, j)};
            if (level->f.moves[element(g, p)] > 0)
                node[count++] = p;
        }
    return count;
}

/* Solves a patch by one Newton step. */
static void solve_patch(ovr_strip *strip, ovr_strip_level *level, place centre,
                        double limit)
{
    const ovr_strip_grid *g = &level->grid;
    place node[MOST];
    size_t count = find_nodes(level, centre, node);
    size_t stride = (count + 8 + 7) / 8 * 8;
    for (size_t r = 0; r < count; r++) {
        const derivatives d = derivatives_at(level, node[r]);
        double *row = strip->matrix + r * stride;
        for (size_t c = 0; c < count; c++) {
            row[c] = 0;
            for (int m = 0; m < STENCIL; m++) {
                bool same = d.at[m].i == node[c].i && d.at[m].j == node[c].j;
                row[c] += d.by_film[m] * influence(level, d.at[m], node[c]) +
                          (same ? d.by_pressure[m] : 0);
            }
        }
        row[count] = level->f.r[element(g, node[r])];
    }
    if (!count || !strip->kernels->dense_solve(count, stride, strip->matrix,
                                               strip->solution))
        return;
    for (size_t c = 0; c < count; c++) {
        double *P = &level->f.P[element(g, node[c])];
        double change = fmax(-limit, fmin(limit, strip->solution[c]));
        *P = fmax(0, *P + change);
    }
}

/* Contribution of a node to the imbalance (relax.kernel.c). */
static double part_of(const ovr_strip_level *level, size_t k)
{
    const ovr_strip_fields *f = &level->f;
    double r = f->r[k], falls = f->along[k - level->grid.stride] + f->along[k] +
                                f->across[k - 1] + f->across[k];
    falls *= f->P[k];
    return r < 0 ? -r : falls < r ? falls : r;
}

/* True if the patches of two centres have no common neighbour. */
static bool has_no_asperity_contact(const ovr_strip_grid *g, place a, place b)
{
    size_t d = a.i > b.i ? a.i - b.i : b.i - a.i;
    return d > SIDE || ovr_across_apart(g->lines, a.j, b.j) > SIDE;
}

/* Inserts a centre into the list, which is ordered by the parts. */
static void insert(place p, double part, size_t *count, place *centre,
                   double *parts)
{
    size_t k = *count < PATCHES ? (*count)++ : PATCHES - 1;
    for (; k > 0 && parts[k - 1] < part; k--) {
        centre[k] = centre[k - 1];
        parts[k] = parts[k - 1];
    }
    centre[k] = p;
    parts[k] = part;
}

size_t ovr_strip_spots(ovr_strip *strip, ovr_strip_level *level,
                       const ovr_strip_smoothing *how, double least)
{
    const ovr_strip_grid *g = &level->grid;
    place centre[PATCHES];
    double parts[PATCHES] = {0};
    size_t count = 0, solved = 0;
    ovr_strip_choose_nodes(strip, level, how);
    for (size_t i = 1; i + 1 < g->n; i++)
        for (size_t j = 0; j < g->lines; j++) {
            double part = part_of(level, ovr_strip_row(g, i) + j);
            if (part > least && (count < PATCHES || part > parts[PATCHES - 1]))
                insert((place){i, j}, part, &count, centre, parts);
        }
    for (size_t k = 0; k < count; k++) {
        bool apart = true;
        for (size_t m = 0; m < k && apart; m++)
            apart = has_no_asperity_contact(g, centre[k], centre[m]);
        if (!apart)
            continue;
        solve_patch(strip, level, centre[k], how->limit);
        solved++;
    }
    if (solved)
        ovr_strip_refresh(strip, level);
    return solved;
}
