/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Transfers between a grid and the next coarser one (equations in fas.h), and
 * sums of arrays.
 *
 * Coarsening stays within the lanes where the coarse grid's are half as long.
 * Where they are not (the smallest grids on the widest vectors) the transfer
 * goes node by node.
 */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

double OVR_KERNEL(sum)(const ovr_lanes *g, const double *x)
{
    vec part[4] = {all(0), all(0), all(0), all(0)};
    ptrdiff_t S = (ptrdiff_t)g->S, J = 0;
    for (; J + 4 <= S; J += 4)
        for (ptrdiff_t k = 0; k < 4; k++)
            part[k] += at(x, J + k);
    for (; J < S; J++)
        part[0] += at(x, J);
    return sum_of_lanes((part[0] + part[1]) + (part[2] + part[3]));
}

/* result = a x + b y */
void OVR_KERNEL(combine)(size_t n, double a, const double *restrict x, double b,
                         const double *restrict y, double *restrict result)
{
    for (size_t i = 0; i < n; i++)
        result[i] = a * x[i] + b * y[i];
}

/* gap = H - H0 + w, where the gap's place holds H. */
void OVR_KERNEL(coarse_gap)(const ovr_lanes *g, double H0, const double *w,
                            double *gap)
{
    for (ptrdiff_t J = -OVR_HALO; J <= (ptrdiff_t)g->S; J++)
        put(gap, J, at(gap, J) - H0 + at(w, J));
}

/* Full weighting of P where all three are wet, else injection. */
static inline vec weighted_pressure(vec left, vec here, vec right)
{
    ivec wet = (left > 0) & (here > 0) & (right > 0);
    return choose(wet, 0.25 * (left + (here + here) + right), here);
}

/* Full weighting of the residual of wet nodes, at wet nodes. */
static inline vec weighted_residual(const vec P[3], const vec r[3])
{
    vec left = choose(P[0] > 0, r[0], all(0));
    vec right = choose(P[2] > 0, r[2], all(0));
    return choose(P[1] > 0, 0.25 * (left + (r[1] + r[1]) + right), all(0));
}

static inline void restrict_vector(const vec P[3], const vec r[3], vec *Pc,
                                   vec *rc)
{
    *Pc = weighted_pressure(P[0], P[1], P[2]);
    *rc = weighted_residual(P, r);
}

static void restrict_lanes(ptrdiff_t S, const double *P, const double *H,
                           const double *r, double *Pc, double *entry,
                           double *Hc, double *rc)
{
    for (ptrdiff_t J = 0; J < S; J++) {
        vec p[3] = {at(P, 2 * J - 1), at(P, 2 * J), at(P, 2 * J + 1)};
        vec d[3] = {at(r, 2 * J - 1), at(r, 2 * J), at(r, 2 * J + 1)}, here,
            rest;
        restrict_vector(p, d, &here, &rest);
        put(Pc, J, here);
        put(entry, J, here);
        put(rc, J, rest);
        put(Hc, J, at(H, 2 * J));
    }
    put(Hc, S, at(H, 2 * S));
    for (ptrdiff_t J = -OVR_HALO; J < 0; J++)
        put(Hc, J, lanes_up(at(Hc, J), at(Hc, S + J)));
}

/* A node in every lane. */
static vec value_at(const ovr_lanes *g, const double *x, size_t i)
{
    return all(x[ovr_lanes_place(g, i)]);
}

static void restrict_nodes(const ovr_lanes *coarse, const ovr_lanes *fine,
                           const double *P, const double *H, const double *r,
                           double *Pc, double *entry, double *Hc, double *rc)
{
    for (size_t I = 0; I < coarse->n; I++) {
        size_t i = 2 * I, to = ovr_lanes_place(coarse, I);
        Hc[to] = H[ovr_lanes_place(fine, i)];
        if (I == 0 || I == coarse->n - 1)
            continue;
        vec p[3], d[3], here, rest;
        for (size_t k = 0; k < 3; k++) {
            p[k] = value_at(fine, P, i - 1 + k);
            d[k] = value_at(fine, r, i - 1 + k);
        }
        restrict_vector(p, d, &here, &rest);
        Pc[to] = entry[to] = here[0];
        rc[to] = rest[0];
    }
    repeat_ends(Hc, (ptrdiff_t)coarse->S, OVR_HALO);
}

/* P_c, H where the coarse nodes are, and the residual of wet nodes; zero at
 * both ends. */
void OVR_KERNEL(restrict_fields)(const ovr_lanes *coarse, const ovr_lanes *fine,
                                 const double *P, const double *H,
                                 const double *r, double *Pc, double *entry,
                                 double *Hc, double *rc)
{
    if (fine->S == 2 * coarse->S)
        restrict_lanes((ptrdiff_t)coarse->S, P, H, r, Pc, entry, Hc, rc);
    else
        restrict_nodes(coarse, fine, P, H, r, Pc, entry, Hc, rc);
    Pc[0] = entry[0] = rc[0] = 0;
}

/* F = N + residual, for r = -N; then r is the residual. */
void OVR_KERNEL(coarse_side)(const ovr_lanes *g, const double *residual,
                             double *F, double *r)
{
    for (ptrdiff_t J = 0; J < (ptrdiff_t)g->S; J++) {
        vec here = at(residual, J);
        put(F, J, here - at(r, J));
        put(r, J, here);
    }
}

static inline vec lifted(vec P, vec change)
{
    return choose(P > 0, larger(P + change, all(0)), P);
}

static inline void correct_vector(double *P, ptrdiff_t J, vec left, vec right)
{
    put(P, 2 * J, lifted(at(P, 2 * J), left));
    put(P, 2 * J + 1, lifted(at(P, 2 * J + 1), 0.5 * (left + right)));
}

static void correct_lanes(ptrdiff_t S, double factor, const double *Pc,
                          const double *entry, double *P)
{
    vec first = factor * (at(Pc, 0) - at(entry, 0)), left = first, right;
    for (ptrdiff_t J = 0; J < S - 1; J++) {
        right = factor * (at(Pc, J + 1) - at(entry, J + 1));
        correct_vector(P, J, left, right);
        left = right;
    }
    correct_vector(P, S - 1, left, lanes_down(first, all(0)));
}

static void correct_nodes(const ovr_lanes *coarse, const ovr_lanes *fine,
                          double factor, const double *Pc, const double *entry,
                          double *P)
{
    for (size_t i = 1; i + 1 < fine->n; i++) {
        size_t left = ovr_lanes_place(coarse, i / 2);
        size_t right = ovr_lanes_place(coarse, (i + 1) / 2);
        double *here = P + ovr_lanes_place(fine, i);
        double change = 0.5 * factor *
                        (Pc[left] - entry[left] + Pc[right] - entry[right]);
        *here = lifted(all(*here), all(change))[0];
    }
}

void OVR_KERNEL(correct)(const ovr_lanes *coarse, const ovr_lanes *fine,
                         double factor, const double *Pc, const double *entry,
                         double *P)
{
    if (fine->S == 2 * coarse->S)
        correct_lanes((ptrdiff_t)coarse->S, factor, Pc, entry, P);
    else
        correct_nodes(coarse, fine, factor, Pc, entry, P);
}

/* Extrapolation in time: the weighted sum where the first, which is the
 * newest, is wet, clipped at zero.  In the order of the nodes, n >= VEC: the
 * last vector overlaps. */
void OVR_KERNEL(extrapolate)(size_t n, size_t count, const double weight[],
                             const double *const from[], double *P)
{
    for (size_t next = 0; next < n; next += VEC) {
        size_t i = next + VEC <= n ? next : n - VEC;
        vec newest = load(from[0] + i), sum = weight[0] * newest;
        for (size_t k = 1; k < count; k++)
            sum = fused(all(weight[k]), load(from[k] + i), sum);
        store(P + i, choose(newest > 0, larger(sum, all(0)), newest));
    }
}
