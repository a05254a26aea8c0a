/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The correction to fourth order where a film shears thin (fourth_order.h): the
 * flux at a half node is E p, E by the flow law (flow.h) from eps, rho H^2, H
 * and the gradient there, each of fourth order:
 *     x_{i+1/2} = [9 (x_i + x_{i+1}) - x_{i-1} - x_{i+2}]/16
 * eps by its logarithms, held within 40 % of the mean of the two nodes that the
 * equation of second order has (faces.h).  A steady solution takes some ten of
 * these: node by node.
 */
#include <math.h>

#include "multigrid/flow.h"
#include "multigrid/fourth_order.h"

static double cubic(const double *x)
{
    return (9 * (x[0] + x[1]) - x[-1] - x[2]) / 16;
}

/* H and eps at x[0], x[1], and beside eps */
static double middle(const ovr_fluid *fluid, const double *H, const double *eps)
{
    const ovr_fluid newtonian = {.by_gap = fluid->by_gap};
    const ovr_pair nodes = {.H = {H[0], H[1]}, .eps = {eps[0], eps[1]}};
    double mean = ovr_flow_between(&newtonian, 1, &nodes);
    double power = 9 * (log(eps[0]) + log(eps[1])) - log(eps[-1]) - log(eps[2]);
    double value = exp(power / 16);
    return fmin(fmax(value, 0.6 * mean), 1.4 * mean);
}

/* E p between x[0] and x[1] of all arrays. */
static double flux_of_fourth(const ovr_fluid *fluid, double D, const double *P,
                             const double *H, const double *q,
                             const double *eps)
{
    double rise = (27 * (P[1] - P[0]) - (P[2] - P[-1])) / 24;
    double h = cubic(H), kept = cubic(q), e = middle(fluid, H, eps);
    const ovr_pair nodes = {{0, rise}, {h, h}, {kept, kept}, {e, e}};
    return ovr_flow_between(fluid, D, &nodes) * rise / D;
}

static double flux_of_second(const ovr_fluid *fluid, double D, const double *P,
                             const double *H, const double *q,
                             const double *eps)
{
    const ovr_pair nodes = {
        {P[0], P[1]}, {H[0], H[1]}, {q[0], q[1]}, {eps[0], eps[1]}};
    return ovr_flow_between(fluid, D, &nodes) * (P[1] - P[0]) / D;
}

/* The content as it counts where a film with temperatures slides (fields.h). */
static void drag(const ovr_hierarchy *grids, const ovr_level *level, double *q,
                 double *workspace)
{
    if (!level->f.drag)
        return;
    ovr_level_read(grids, level, level->f.drag, workspace);
    for (size_t i = 0; i < level->grid.n; i++)
        q[i] *= workspace[i];
}

void ovr_fourth_thinning(const ovr_hierarchy *grids, const ovr_level *level,
                         const ovr_correction *c, double Cu)
{
    const double *fields[] = {level->f.P, level->f.H, level->f.q, level->f.eps,
                              c->mask};
    const ovr_fluid *fluid = &grids->fluid;
    double *const *x = c->work, *fourth = x[5], *second = x[6], *F = x[1];
    double D = level->grid.D;
    size_t n = level->grid.n;
    for (int k = 0; k < 5; k++)
        ovr_level_read(grids, level, fields[k], x[k]);
    drag(grids, level, x[2], x[5]);
    for (size_t i = 1; i + 2 < n; i++) {
        fourth[i] = flux_of_fourth(fluid, D, x[0] + i, x[1] + i, x[2] + i,
                                   x[3] + i);
        second[i] = flux_of_second(fluid, D, x[0] + i, x[1] + i, x[2] + i,
                                   x[3] + i);
    }
    ovr_level_read(grids, level, level->f.q, x[2]);
    for (size_t i = 0; i < n; i++)
        F[i] = 0;
    for (size_t i = OVR_FOURTH_MARGIN; i + OVR_FOURTH_MARGIN < n; i++) {
        const double *f = fourth + i, *q = x[2] + i;
        double wedge = (3 * q[1] - 8 * q[0] + 6 * q[-1] - q[-3]) / 12;
        double diffusion = (27 * (f[0] - f[-1]) - (f[1] - f[-2])) / 24;
        if (x[4][i] > 0)
            F[i] = (second[i] - second[i - 1] - diffusion + Cu * wedge) / D;
    }
    ovr_level_write(grids, level, F, c->F);
}
