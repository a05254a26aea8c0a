/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/influence.h"

#include <math.h>

#include "multigrid/hierarchy.h"

double ovr_influence_rest(const ovr_influence *influence, double d, double D)
{
    double R = 0;
    for (int k = 0; k < influence->parts; k++)
        R += ovr_influence_part_at(&influence->part[k], d * D, D,
                                   influence->linear);
    return R;
}

double ovr_influence_at(const ovr_influence *influence, double d, double D)
{
    double K = influence->linear ? ovr_deformation_linear(d, D)
                                 : ovr_deformation_kernel(d, D);
    if (influence->parts)
        K += ovr_influence_rest(influence, d, D);
    return d == 0 ? K - influence->compliance : K;
}

void ovr_influence_band(const ovr_influence *influence, double D, double k[6])
{
    static const double minimum[] = {0, 0.05, 0.3, 0.5, 0.6};
    double g[5];
    for (int d = 0; d < 6; d++)
        k[d] = ovr_influence_at(influence, d, D);
    if (!influence->parts)
        return;
    for (int d = 0; d < 5; d++) {
        g[d] = k[d + 1] - k[d];
        if (d)
            g[d] = fmax(g[d], minimum[d] * g[d - 1]);
    }
    for (int d = 0; d < 5; d++)
        k[d + 1] = k[d] + g[d];
}

bool ovr_influence_corrected(const ovr_influence *influence)
{
    for (int k = 0; k < influence->parts; k++)
        if (!influence->part[k].wave)
            return false;
    return influence->compliance == 0;
}

/* Aliases beyond the last summed one are assigned the A of the last one. */
static double local_of(const ovr_influence_part *part, double D, bool linear)
{
    enum { WAVES = 40 };
    const double pi = acos(-1.0);
    double maximum = part->wave(part->data, 2 * pi * WAVES / D), sum = 0;
    for (int n = 1; n < WAVES; n++) {
        double sign = linear || n % 2 ? 1 : -1;
        double A = part->wave(part->data, 2 * pi * n / D);
        sum += sign * (A - maximum) / ((double)n * n * n);
    }
    return maximum * (linear ? OVR_FOURTH_LINEAR : OVR_FOURTH_LOCAL) +
           sum / ((linear ? 4 : 2) * pi * pi * pi);
}

double ovr_influence_local(const ovr_influence *influence, double D)
{
    double C = influence->linear ? OVR_FOURTH_LINEAR : OVR_FOURTH_LOCAL;
    for (int k = 0; k < influence->parts; k++)
        if (influence->part[k].wave)
            C += local_of(&influence->part[k], D, influence->linear);
    return C;
}

bool ovr_influence_add(ovr_influence *influence, ovr_influence_part part)
{
    if (influence->parts == OVR_INFLUENCE_PARTS)
        return false;
    influence->part[influence->parts++] = part;
    return true;
}

void ovr_level_deform(const ovr_hierarchy *grids, const ovr_level *level,
                      double *P, double *w)
{
    const ovr_lanes *lanes = &level->lanes;
    double compliance = grids->influence.compliance;
    grids->kernels->deformation(&level->mlmi, P, w);
    if (compliance != 0) { /* vectors and their halo, as one array */
        size_t halo = OVR_HALO * lanes->V, n = lanes->S * lanes->V + 2 * halo;
        grids->kernels->combine(n, 1, w - halo, -compliance, P - halo,
                                w - halo);
    }
}
