/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Flow of a shear-thinning film at half nodes, from the exact integrals over
 * the film.
 *
 *     gamma = (tau0/eta) f(tau/tau0)        tau(s) = t + s H P_X/2, s = -1..1
 *     flux = E P_X                          Sigma0 = tau0/(ph b/R)
 *
 * Stresses relative to tau0: a = t/Sigma0 for the mean, g = H P_X/(2 Sigma0)
 * for the difference. Sliding velocity and flow are integrals over the film,
 *     (1/2) int f(a + g s) ds = -sgn(V) c/eps,   c = |V| rho H^2/(12 Sigma0)
 *     E = eps (3/(2 g)) int s f(a + g s) ds
 * Eyring, f = sinh (after Conry, Wang, Cusano 1987):
 *     E = A(g) W,  W = sqrt(eps^2 + (B(g) c)^2)
 *     A = 3 (g cosh g - sinh g)/g^3,  B = g/sinh g,  a = -sgn(V) asinh(B c/eps)
 * c does not depend on the viscosity, and there is no division by eps.
 *
 * At i + 1/2, eps and rho H^2 the means of the two nodes (faces.h), g by the
 * difference of P over D and the mean of H.  Rows of the discrete equation and
 * Newton's method need
 *     T = d(E g)/dg at fixed eps, c: E with its change by the gradient
 *       = (3 sinh g/g - 2 A) W - (A^2 B g^2/3) (B c)^2/W
 *     R = dE/d eps = A eps/W
 *     dE/dH_i = R d eps/dH_i + (A B^2 c/W) dc/dH_i
 *               + (T - E)/(H_i + H_{i+1})
 *     -d(2 E dP)/dP_i = 2 T - R dP d(2 eps)/dP_i,  dP = P_{i+1} - P_i, and
 *      d(2 E dP)/dP_{i+1} = 2 T + R dP d(2 eps)/dP_{i+1}
 * The last two are stored as out_left and out_right, for rows.
 *
 * For |g| > 200, A and B are those at 200. Without T, iterations diverge at
 * steep pressure gradients. With temperatures c has psi_c rho H^2 (drag in
 * fields.h).  Sigma0 infinite: E = T = eps, R = 1.
 *
 * Other laws by the table of Phi = E/eps (contact/flow_law.h), m_s and m_g its
 * logarithmic slopes by s_N = c/eps and g:
 *     T = (1 + m_g) E,  R = Phi (1 - m_s),  dE/dc = Phi m_s/s_N
 */
#ifndef OVR_MULTIGRID_FLOW_H
#define OVR_MULTIGRID_FLOW_H

#include <stdbool.h>

#include "multigrid/kernels.h"

/* Factors |V|/(12 Sigma0) from rho H^2 to c, and 1/(4 D Sigma0) from (H_i +
 * H_{i+1}) (P_{i+1} - P_i) to g. */
static inline double ovr_flow_slide(const ovr_fluid *fluid)
{
    double V = fluid->sliding;
    return (V < 0 ? -V : V) / (12 * fluid->lubricant.Sigma0);
}

static inline double ovr_flow_gradient(const ovr_fluid *fluid, double D)
{
    return 0.25 / (D * fluid->lubricant.Sigma0);
}

/* True if the fluid has a rheological model. */
static inline bool ovr_flow_is_shear_thinning(const ovr_fluid *fluid)
{
    return fluid->lubricant.rheology != OVR_NEWTONIAN;
}

/* Multiplies the flow by the flow factor of rough surfaces
 * (contact/flow_factor.h) for the mean gap at the half node, phi. 2 E and its
 * derivatives change:
 *     E <- phi E,  dE/dH_i <- phi dE/dH_i + phi' E/2
 * Stresses and lubricant properties do not include the factor. */
void ovr_apply_flow_factor(const ovr_fluid *fluid, const ovr_lanes *g,
                           const ovr_fields *f);

/* Computes the stored values at half nodes that a level, or a part of one,
 * needs. Film and properties must be up to date. */
static inline void ovr_flow_store(const ovr_kernels *run,
                                  const ovr_fluid *fluid, double D,
                                  const ovr_lanes *g, const ovr_fields *f)
{
    if (ovr_flow_is_shear_thinning(fluid))
        run->flow(fluid, D, g, f);
    else if (f->flow)
        run->faces(fluid, g, f);
    if (fluid->factor)
        ovr_apply_flow_factor(fluid, g, f);
}

/* Computes E between two nodes that are dX apart. */
typedef struct ovr_pair {
    double P[2], H[2], q[2], eps[2];
} ovr_pair;
/* a of a tabulated law, for V < 0. */
double ovr_flow_stress(const ovr_flow_law *law, double s_N, double g);

double ovr_flow_between(const ovr_fluid *fluid, double dX,
                        const ovr_pair *nodes);

#endif
