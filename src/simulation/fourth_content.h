/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourth-order corrections with mass-conserving cavitation. The thickness of a
 * starved film is determined by the supply, so the corrections must not create
 * or destroy lubricant: they are differences of corrections of flows and
 * contents.  With m = 1 inside the film, falling to 0 over eight mesh sizes
 * towards its beginning and over four towards its end,
 *
 *     F_i = -(phi_{i+1/2} - phi_{i-1/2})/D,
 *     phi_{i+1/2} = min(m_i, m_{i+1}) {(26 f_i - f_{i+1} - f_{i-1})/24 - f2_i
 *                   - Cu (3 q_{i+1} - 5 q_i + q_{i-1} + q_{i-2})/12},
 *
 * f the Poiseuille flow p E of fourth order at half nodes (fourth_order.h), f2
 * the flow of second order. The last term is the wedge of a steady film. The
 * sum of these terms equals the corrections of fourth_order.h.  Along the
 * characteristic the third divided difference is that of the second ones, G = m
 * q[t, t-1, t-2],
 *
 *     (G^k - G^{k-1}(X - a))/(t - t-3),
 *
 * so that lubricant removed in one step is returned in the next.
 *
 * R of fourth.c, with which a steady film remains steady, is a difference of
 * flows as well. The flow psi_{i-1/2} is -D times the sum of R_j for j >= i. It
 * is zero downstream of the film, where the content is uniform.
 *
 *     R_i = (m_{i+1/2} psi_{i+1/2} - m_{i-1/2} psi_{i-1/2})/D,
 *     m_{i+1/2} = min(m_i, m_{i+1}).
 *
 * Here m is that of the present film, without the decrease towards its end.
 */
#ifndef OVR_SIMULATION_FOURTH_CONTENT_H
#define OVR_SIMULATION_FOURTH_CONTENT_H

#include "simulation/internal.h"

typedef struct ovr_fourth_content {
    double *mask, *begun;  /* m, and m without the decrease at the end */
    double *flux, *excess; /* m, f, phi */
    double *bend;          /* G */
    double *workspace[2];
} ovr_fourth_content;

ovr_status ovr_fourth_content_take(ovr_simulation *sim, ovr_fourth_content *of,
                                   ovr_error *err);

/* Computes F and gap for the film last read, including the wedge if Cu > 0. */
void ovr_fourth_content_evaluate(ovr_simulation *sim, ovr_fourth_content *of,
                                 const ovr_correction *c, double Cu, double *F,
                                 double *gap);

/* Third divided difference for a step dT to T that is solved and not yet stored
 * as past. Before a first step, the past is the steady solution, dT earlier. */
void ovr_fourth_content_third(ovr_simulation *sim, ovr_fourth_content *of,
                              double T, double dT, double *third);
void ovr_fourth_content_begin(ovr_simulation *sim, ovr_fourth_content *of,
                              double dT, double *third);

/* Computes psi at half nodes for steps dT from the steady contents `start` and
 * the part of R that is independent of the step; then R at the nodes. */
void ovr_fourth_content_rest(ovr_simulation *sim, ovr_fourth_content *of,
                             double dT, const double *start,
                             const double *constant, double *psi);
void ovr_fourth_content_rows(const ovr_simulation *sim,
                             const ovr_fourth_content *of, const double *psi,
                             double *R);

#endif
