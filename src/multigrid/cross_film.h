/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Temperature and velocity across the film at one node, by collocation in the
 * points s_j of Lobatto's quadrature (5, or 7 as a check), s = -1 at surface 1,
 * zeta = (1 + s)/2; temperatures are rises above the supply temperature T0:
 *
 *     rho H (T_T + u T_X) = Kf T_zz/H
 *                           + Theta (tau u_z + beta (T0 + T) H (P_T + u P_X))
 *
 * in the weak form, whose wall fluxes are conservative: with w_j the weights,
 * of sum 1, K = D^T w D of the derivative D by zeta, T_j' at the departure
 * point of the path a time t_j ago,
 *
 *     w_j rho H (T_j - T_j')/t_j + (Kf/H) sum_l K_jl T_l
 *         - w_j Theta beta_j H (P_T + u_j P_X) (T0 + T_j)
 *         + [j a wall] G (T_j - h) = w_j Theta tau_j u_z,j
 *     G = Kf/(N (4/3) sqrt(dT)),  q = (T_j - h)/(N (4/3) sqrt(dT))
 *
 * with h and q of solids.h.  With r_j = eta(T_m)/eta(T_j), T_m = sum w_j T_j,
 * m_k = sum w_j r_j s_j^k and tau = t + s G_P, G_P = H P_X/2,
 *
 *     u_z,j = r_j tau_j/Y,  Y = lambda eta_m/(12 H)
 *     t = (-V Y - G_P m_1)/m_0
 *
 * so that the velocity difference across the film is V = u1 - u2. With Eyring's
 * law, g = G_P/Sigma0, a = t/Sigma0, A = sum w_j r_j cosh(g s_j), B = sum w_j
 * r_j sinh(g s_j), b = -V Y/Sigma0, n^2 = A^2 - B^2,
 *
 *     u_z,j = Sigma0 r_j sinh(a + g s_j)/Y
 *     sinh a = (b A - sqrt(n^2 + b^2) B)/n^2
 *     cosh a = (sqrt(n^2 + b^2) A - b B)/n^2
 *
 * and with any other law f, where Newton's method yields a and its derivative,
 *
 *     sum w_j r_j f(a + g s_j) = b,  u_z,j = Sigma0 r_j f(a + g s_j)/Y
 *
 * A film with the same P_X and the uniform fluidity m_0 has the mean stress
 * t_0; the temperature profile changes it by t - t_0.
 *
 * A limiting shear stress limits tau in the heat source only, not in the flow.
 * The terms of Reynolds' equation are modified as follows:
 *
 *     eps <- psi_e eps,  psi_e = 3 (m_2 - m_1^2/m_0),  eps with eta_m
 *     psi_c = psi_e/m_0:  t = -(V/12) psi_c rho H^2/eps without pressure flow
 *     wedge of q <- wedge of q (1 + D),  D = (V/2) m_1/m_0
 *     rho <- rho/(1 + bT f T_m), where density expands
 *
 * with the expansion beta of expansion.h at T_used.  If bT did not depend on
 * pressure, the thermal expansion due to compression heating would exceed the
 * compression at a few GPa. Such films have no stable solution; temperatures of
 * thousands of kelvins were computed.
 *
 * Gravity, heat conduction along x and flow across the film are neglected;
 * their effect is below 0.2 % of the film thickness.
 */
#ifndef OVR_MULTIGRID_CROSS_FILM_H
#define OVR_MULTIGRID_CROSS_FILM_H

#include <stdbool.h>
#include <stddef.h>

#include "contact/heat_numbers.h"

enum { OVR_CROSS_FILM_MAX = 7 };

typedef struct ovr_cross_film {
    int n;
    double s[OVR_CROSS_FILM_MAX], w[OVR_CROSS_FILM_MAX]; /* sum w = 1 */
    double K[OVR_CROSS_FILM_MAX][OVR_CROSS_FILM_MAX];
    double integral[OVR_CROSS_FILM_MAX]
                   [OVR_CROSS_FILM_MAX]; /* from 0 to zeta_j */
    double last[OVR_CROSS_FILM_MAX]; /* sum last_j T_j is the coefficient of the
                                      * highest Legendre polynomial of T */
} ovr_cross_film;

/* Computes points, weights and matrices for 5 or 7 points. */
void ovr_cross_film_make(int points, ovr_cross_film *a);

/* Evaluates the interpolation polynomial of T at the points of `to`. */
void ovr_cross_film_move(const ovr_cross_film *from, const double *T,
                         const ovr_cross_film *to, double *moved);

/* Values of the film at a node. */
typedef struct ovr_sheet {
    double H, rho, P, P_X, P_T;
    double log_eta; /* ln eta at T0 */
    double lambda, V, u1;
    double Sigma0; /* reference stress of Eyring's or another law; INFINITY:
                      Newtonian */
    double limit;  /* maximum of |t| + |G_P|; INFINITY: none */
    bool wet;
    const ovr_flow_law *law; /* tabulated law; NULL: Newtonian or Eyring */
} ovr_sheet;

/* Flow in the film for given temperatures T. */
typedef struct ovr_cross_film_flow {
    double m[3], mean;                  /* m_k; T_m */
    double log_eta;                     /* ln eta at T_m */
    double t;                           /* mean shear stress */
    bool limited;                       /* t is at its limit */
    double even;                        /* t_0, mean stress of a film with
                                         * uniform fluidity */
    double u[OVR_CROSS_FILM_MAX];       /* velocity */
    double heating[OVR_CROSS_FILM_MAX]; /* tau u_z */
    double beta[OVR_CROSS_FILM_MAX];    /* expansion */
} ovr_cross_film_flow;

void ovr_cross_film_flow_of(const ovr_cross_film *a, const ovr_heat *heat,
                            const ovr_sheet *sheet, const double *T,
                            ovr_cross_film_flow *flow);

/* Boundary condition at a surface: T = h + resistance q. */
typedef struct ovr_wall {
    double h, resistance; /* N (4/3) sqrt(dT) */
} ovr_wall;

/* Computes T. `departure` and `travel` are T_j' and t_j. */
void ovr_cross_film_solve(const ovr_cross_film *a, const ovr_heat *heat,
                          const ovr_sheet *sheet,
                          const ovr_cross_film_flow *flow,
                          const double *departure, const double *travel,
                          const ovr_wall wall[2], double *T);

/*
 * Film, flow and a time step of the temperatures at n nodes in their order, as
 * input of kernels. A node is pressurized if P > 0 and it is not an end node.
 * P_X is computed by central differences. The heat source decreases with the
 * temperature during a step, so that the step cannot overshoot:
 *
 *     tau u_z <- tau u_z (1 - gamma (T - T_used))
 *     gamma = -(d ln eta/dT) tanh(a)/a,  a = |t|/Sigma0.
 *
 * This is gamma of Eyring's law; other laws have f/(a f') in place of
 * tanh(a)/a. Where the stress is at its limit, the power does not depend on the
 * viscosity: gamma = 0.
 */
typedef struct ovr_columns {
    const ovr_cross_film *cross_film;
    const ovr_heat *heat;
    size_t n;
    double lambda, V, u1, Sigma0;
    double limit;      /* maximum of (|t| + |G_P|)/P */
    bool always_falls; /* compute gamma as if the stress were not limited */
    const ovr_flow_law *law;
    const double *X, *P, *H, *q;            /* H without solid layers: q = rho H
                                             */
    const double *log_eta;                  /* ln eta at T0 */
    const double *used[OVR_CROSS_FILM_MAX]; /* T for which the flow was computed
                                             */
    /* results: flow, and gamma */
    double *u[OVR_CROSS_FILM_MAX], *heating[OVR_CROSS_FILM_MAX], *t, *fall;
    double *even; /* t_0; NULL: not computed */
    /* coefficients of Reynolds' equation (fields.h); V/2 m_1/m_0 q. If these
     * arrays are present, only they are computed. */
    double *th, *shift, *drag, *swell, *skewed;
    /* a step dT from T at the departure points with P_T (NULL: 0); `past` is (h
     * - T_bulk)/N of both surfaces */
    double dT;
    double min_u;   /* steady: a node's values come from the node upstream, with
                     * at least this speed (plain only); 0: transient */
    bool both_ways; /* steady: layers that move against x take their values from
                     * the next node */
    bool back;      /* steady: all layers take their values from the next node,
                     * with speed -u */
    const double *P_T, *departure[OVR_CROSS_FILM_MAX], *past[2];
    double resistance[2];
    double *T[OVR_CROSS_FILM_MAX], *mean, *into[2]; /* T, T_m, q */
} ovr_columns;

/* Temperature of layer j at the departure point of its path to node i, and the
 * time of travel from there. */
double ovr_column_departure(const ovr_columns *columns, int j, size_t i);
double ovr_column_travel(const ovr_columns *columns, int j, size_t i);

/* Expansion coefficient beta at pressure P and temperature rise T. */
double ovr_expansion(const ovr_heat *heat, double P, double T);

/* Computes the flow, or the heat source, of node i alone. */
void ovr_column_flow(const ovr_columns *columns, size_t i);
void ovr_column_heat(const ovr_columns *columns, size_t i);

#endif
