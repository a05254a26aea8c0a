/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/influence.h"

double ovr_influence_at(const ovr_influence *influence, double d, double D)
{
    double K = influence->linear ? ovr_deformation_linear(d, D)
                                 : ovr_deformation_kernel(d, D);
    for (int k = 0; k < influence->parts; k++)
        K += influence->part[k].at(influence->part[k].data, d * D, D);
    return d == 0 ? K - influence->compliance : K;
}

bool ovr_influence_add(ovr_influence *influence, ovr_influence_part part)
{
    if (influence->parts == OVR_INFLUENCE_PARTS)
        return false;
    influence->part[influence->parts++] = part;
    return true;
}

bool ovr_influence_more(const ovr_influence *influence)
{
    return influence->parts > 0 || influence->compliance != 0;
}

/* Vectors and their halo, as one array. */
static void give_way(const ovr_influence *influence, const ovr_kernels *run,
                     const ovr_lanes *lanes, const double *P, double *w)
{
    size_t halo = OVR_HALO * lanes->V, n = lanes->S * lanes->V + 2 * halo;
    run->combine(n, 1, w - halo, -influence->compliance, P - halo, w - halo);
}

void ovr_influence_deform(const ovr_influence *influence,
                          const ovr_kernels *run, const ovr_lanes *lanes,
                          const ovr_mlmi *mlmi, double *P, double *w)
{
    run->deformation(mlmi, P, w);
    if (influence->compliance != 0)
        give_way(influence, run, lanes, P, w);
}
