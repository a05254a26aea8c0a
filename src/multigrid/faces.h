/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Means at half nodes, over `num` too (reynolds_row.h).
 *
 * Arithmetic: eps_i + eps_j is 2 E of a half node, as in the paper.  At a
 * constriction that is narrower than a mesh the wide node rules this sum, and
 * the film leaks through as if it were open.
 *
 * By the gap: what flows through a mesh flows through all of it, so that
 * resistances 1/eps are summed, but of the gap alone.  With eps = phi H^3,
 * a = H_i^3, b = H_j^3
 *     2 E = (phi_i + phi_j) 2 a b/(a + b) = p eps_i + (2 - p) eps_j,
 *     p = 2 b/(a + b)
 *     d(2 E)/dP_i = p d eps_i/dP
 *     d(2 E)/dH_i = p d eps_i/dH - (3/2) p (2 - p) (eps_i - eps_j)/H_i
 * The harmonic mean of phi too is not elliptic: phi falls as exp(-alpha P), and
 * such a face's flow as x/(1 + e^x) from x = alpha (P_j - P_i) = 1.28 on.
 * rho H^2 of flow laws (flow.h) alike, with squares.
 *
 * The stress of sliding (friction.h) is no resistance: rho H^2/eps is the mean
 * of rho psi_c over that of phi, times the mean of 1/H over a gap that is
 * linear between the nodes, ln(H_i/H_j)/(H_i - H_j), whose inverse is within
 * 6 % for a ratio of 50 (2 G + A)/3, of their geometric and arithmetic means.
 * phi falls as exp(-alphabar P), so between two nodes with pressure its mean is
 * the geometric one: the arithmetic one makes the oil of steep pressures too
 * thin, and friction five times less exact.  Beside a node without pressure,
 * where phi stands for the share of the gap that is filled, it is arithmetic.
 */
#ifndef OVR_MULTIGRID_FACES_H
#define OVR_MULTIGRID_FACES_H

#include <stddef.h>

#ifdef VEC /* vector.h came before */
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

/* A film, for what divides by it: iterates may touch. */
static inline num face_film(num H)
{
    return larger(H, all(1e-30));
}

/* p of H^3 and of H^2. */
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

/* Its change by the film H of x, which changes it by `slope`: by
 * p slope - power/2 p (2 - p) (x - y)/H. */
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
