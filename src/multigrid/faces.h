/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Means of the flow coefficient at half nodes, also for a number type `num`
 * (reynolds_row.h).
 *
 * Arithmetic: eps_i + eps_j is 2 E of a half node, as in the paper.  At a
 * constriction narrower than D the node with the larger gap dominates this sum,
 * and the computed flow is too large, as if there were no constriction.
 *
 * By the gap: the flow is the same in the whole grid interval, so that the
 * resistances 1/eps are added; only the factor H^3 is averaged in this way.
 * With eps = phi H^3, phi = rho m, m = 1/(eta lambda), a = H_i^3, b = H_j^3, h
 * = 2 a b/(a + b)
 *     2 E = (phi_i + phi_j) h = p eps_i + (2 - p) eps_j,   p = 2 b/(a + b)
 *     d(2 E)/dP_i = p d eps_i/dP
 *     d(2 E)/dH_i = p d eps_i/dH - (3/2) p (2 - p) (eps_i - eps_j)/H_i
 *
 * Logarithmic: the flow through the mesh is h times the integral of phi dP, and
 * ln m is nearly linear in P, so that the mean of m is
 *     (m_j - m_i)/d,   d = ln(m_j/m_i)
 *     2 E = h (rho_i + rho_j) (m_j - m_i)/d
 * The arithmetic mean exceeds it by the factor (d/2)/tanh(d/2): at the flank of
 * a pressure spike d is 1 to 7, and the minimum film thickness is ten times
 * less accurate.  With s_i = (d ln m/dP)_i (P_j - P_i) the flow 2 E (P_j - P_i)
 * has the derivatives
 *     -[2 E - (s_i/d) (2 E - 2 p eps_i)] by P_i,
 *       2 E - (s_j/d) (2 E - 2 (2 - p) eps_j) by P_j
 * and where ln m is linear in P, s_i = s_j = d, these are -2 p eps_i and 2 (2 -
 * p) eps_j: the discrete operator is elliptic for any pressure difference.  By
 * Roelands' law s_j/d reaches 2 where the pressure falls by several p_h in a
 * mesh size; with 1 in its place, corrections are too large by this factor. At
 * the peak of a spike m is smallest, and the flow to a neighbour hardly depends
 * on the pressure there.  Far from the solution Newton's step is then too
 * large, and relaxations oscillate about the spike.  The slopes are at least
 * the secant 2 E there (cycle.c).  A steady contact of 0.6 GPa with a wave of
 * half the film takes 12 cycles on level 7; without secants there was no
 * solution. The harmonic mean of phi is not elliptic: phi falls as exp(-alpha
 * P), and its flow as x/(1 + e^x) from x = alpha (P_j - P_i) = 1.28 on.  In a
 * film with temperatures m is the integral across the film divided by H^3
 * (cross_film.h).  P and ln m are nearly linear in X between the nodes, so ln m
 * is linear in P there too. The mean of rho H^2 in rheological models (flow.h)
 * is formed in the same way, with squares.
 *
 * The sliding stress (friction.h) is not a resistance: rho H^2/eps is the mean
 * of rho psi_c over that of phi, times the mean of 1/H over a gap that is
 * linear between the nodes, ln(H_i/H_j)/(H_i - H_j), whose inverse is within 6
 * % for a ratio of 50 (2 G + A)/3, of their geometric and arithmetic means. phi
 * falls as exp(-alphabar P), so between two nodes with pressure its mean is the
 * geometric one: the arithmetic mean underestimates the viscosity where the
 * pressure gradient is large and makes the friction error five times larger.
 * Next to a cavitated node, where phi represents the filled fraction of the
 * gap, the mean is arithmetic.
 */
#ifndef OVR_MULTIGRID_FACES_H
#define OVR_MULTIGRID_FACES_H

#include <stddef.h>

#include "multigrid/kernels.h"

#ifdef VEC /* vector.h is included */
static inline num face_root(num x)
{
    return x * inverse_root(x);
}
#else
#include "base/scalar.h"
static inline num face_root(num x)
{
    return sqrt(x);
}
#endif

/* A film thickness that can be a divisor: iterates may be 0. */
static inline num face_film(num H)
{
    return larger(H, all(1e-30));
}

/* 1/d; not used where d is near 0. */
static inline num face_inverse(num d)
{
    return 1 / choose(d * d < 1e-6, all(1), d);
}

/* The mean (y - x)/d of two numbers, with d = ln(y/x) and inverse = 1/d. Near d
 * = 0, computed as the arithmetic mean times the series of tanh(d/2)/(d/2),
 * with an error of 1e-13. */
static inline num face_log_mean(num x, num y, num d, num inverse)
{
    num square = 0.25 * d * d;
    num series = fused(square, fused(square, all(2. / 15), all(-1. / 3)),
                       all(1));
    return choose(square < 1e-4, 0.5 * (x + y) * series, (y - x) * inverse);
}

/* The flow between nodes i and j: 2 E; its derivatives -d(2 E (P_j - P_i))/dP_i
 * and d(2 E (P_j - P_i))/dP_j at fixed film; p. */
typedef struct face {
    num flow, left, right, share;
} face;

/* Values of one of the two nodes. deps is d eps/dP; cube = H^3, m = eps/(rho
 * H^3). */
typedef struct face_node {
    num P, H, rho, eps, deps, log_fluidity, log_slope, cube, m;
} face_node;

/* p for means of H^3 and of H^2. */
static inline num face_share(num H, num G)
{
    num h = face_film(H), g = face_film(G), a = h * h * h, b = g * g * g;
    return 2 * b / (a + b);
}

static inline num face_square_share(num H, num G)
{
    num h = face_film(H), g = face_film(G), a = h * h, b = g * g;
    return 2 * b / (a + b);
}

/* p x + (2 - p) y */
static inline num face_sum(num p, num x, num y)
{
    return fused(p, x, (2 - p) * y);
}

/* The mean with weights p and 2 - p: p = 1 for the arithmetic mean, or p from
 * the gap. */
static inline face face_by_shares(num p, const face_node *i, const face_node *j)
{
    num rise = j->P - i->P, flow = face_sum(p, i->eps, j->eps);
    return (face){.flow = flow,
                  .left = less(flow, p * i->deps, rise),
                  .right = fused((2 - p) * j->deps, rise, flow),
                  .share = p};
}

/* Derivative of the flow with respect to a node's pressure, flow - s ratio.
 * Arguments: s = (d ln m/dP)_i (P_j - P_i), bound = 2 p eps_i, and ratio =
 * (flow - bound)/d. The result is bounded below by the smaller of flow and
 * bound, so that the rows stay elliptic, and by `least`, a fraction of the
 * flow. */
static inline num face_by_pressure(num flow, num bound, num s, num ratio,
                                   num least)
{
    return larger(less(flow, s, ratio), larger(smaller(flow, bound), least));
}

/* The logarithmic mean: h (rho_i + rho_j) (m_j - m_i)/d, h = 2 a b/(a + b). */
static inline face face_logarithmic(const face_node *i, const face_node *j,
                                    double secant)
{
    const double ln2 = 0x1.62e42fefa39efp-1;
    num rise = j->P - i->P, d = ln2 * (j->log_fluidity - i->log_fluidity);
    num inverse = face_inverse(d), h = 2 * i->cube / (i->cube + j->cube);
    num share = h * j->cube, twice = 2 * share;
    num flow = share * (i->rho + j->rho) *
               face_log_mean(i->m, j->m, d, inverse);
    flow = larger(flow, all(0));
    num left = twice * (i->rho * i->m), right = twice * (j->rho * j->m);
    num least = secant * flow, half = 0.5 * flow;
    truth is_near = d * d < 1e-6;
    return (face){.flow = flow,
                  .left = face_by_pressure(
                      flow, left, rise * i->log_slope,
                      choose(is_near, half, (flow - left) * inverse), least),
                  .right = face_by_pressure(
                      flow, right, -rise * j->log_slope,
                      choose(is_near, half, (right - flow) * inverse), least),
                  .share = 2 - h};
}

/* Kind of mean; a compile-time constant. */
typedef enum face_kind { FACE_SUMS, FACE_BY_GAP, FACE_LOGARITHMIC } face_kind;

static inline face_kind face_kind_of(const ovr_fluid *fluid)
{
    if (fluid->logarithmic)
        return FACE_LOGARITHMIC;
    return fluid->by_gap ? FACE_BY_GAP : FACE_SUMS;
}

/* Loads the values of a node, except those for the logarithmic mean. */
static INLINE face_node face_loaded(const ovr_fields *f, face_kind kind,
                                    ptrdiff_t J)
{
    face_node n = {.P = at(f->P, J),
                   .H = at(f->H, J),
                   .eps = at(f->eps, J),
                   .deps = at(f->deps, J)};
    if (kind == FACE_LOGARITHMIC) {
        n.rho = at(f->rho, J);
        n.log_fluidity = at(f->log_fluidity, J);
        n.log_slope = at(f->log_slope, J);
    }
    return n;
}

static INLINE face_node face_node_at(const ovr_fields *f, face_kind kind,
                                     ptrdiff_t J)
{
    face_node n = face_loaded(f, kind, J);
    if (kind == FACE_LOGARITHMIC) {
        num h = face_film(n.H);
        n.cube = h * h * h;
        n.m = larger(n.eps, all(0)) / (n.rho * n.cube);
    }
    return n;
}

static INLINE face face_between(face_kind kind, double secant,
                                const face_node *left, const face_node *right)
{
    if (kind == FACE_LOGARITHMIC)
        return face_logarithmic(left, right, secant);
    if (kind == FACE_SUMS)
        return face_by_shares(all(1), left, right);
    face s = face_by_shares(face_share(left->H, right->H), left, right);
    s.flow = larger(s.flow, all(0));
    return s;
}

/* The flow coefficient between J and J + 1. */
static INLINE face face_at(const ovr_fields *f, face_kind kind, double secant,
                           ptrdiff_t J)
{
    face_node left = face_node_at(f, kind, J);
    face_node right = face_node_at(f, kind, J + 1);
    return face_between(kind, secant, &left, &right);
}

/* d(2 E)/dH_i of the logarithmic mean: 3/2 p 2 E/H_i plus the effect of the
 * film thickness on the viscosity, weighted by p. */
static inline num face_logarithmic_by_film(num flow, num p, num H, num slope,
                                           num eps)
{
    num inverse = 1 / face_film(H), viscous = less(slope, 3 * eps, inverse);
    return p * fused(1.5 * flow, inverse, choose(H > 0, viscous, all(0)));
}

/* Derivative of the mean with respect to the film thickness H at the node with
 * value x, where dx/dH = `slope`: p slope - power/2 p (2 - p) (x - y)/H. */
static inline num face_by_film(double power, num p, num H, num slope, num x,
                               num y)
{
    num shift = 0.5 * power * (2 - p) * (x - y) / face_film(H);
    return p * (slope - shift);
}

/* (2 G + A)/3 */
static inline num face_sliding(num H, num G)
{
    num h = face_film(H), g = face_film(G);
    return (1. / 6) * (4 * face_root(h * g) + h + g);
}

#endif
