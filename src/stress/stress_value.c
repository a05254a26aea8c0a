/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses made of h, d and tau: plane strain, residual stresses added. */
#include <math.h>

#include "stress/stress.h"

const char *ovr_stress_field_name(ovr_stress_field field)
{
    static const char *const names[OVR_STRESS_FIELDS] = {
        "sigma_x",   "sigma_z",   "tau_xz", "sigma_y",
        "von_mises", "max_shear", "tresca", "hydrostatic"};
    return names[field];
}

double ovr_stress_value(ovr_stress_field field, ovr_in_plane s, double poisson,
                        double residual_x, double residual_y)
{
    double x = s.d - s.h + residual_x, z = -s.d - s.h;
    double y = -2 * poisson * s.h + residual_y, middle = (x + z) / 2;
    double shear = hypot((x - z) / 2, s.tau), across = middle - y;
    switch (field) {
    case OVR_STRESS_SIGMA_X: return x;
    case OVR_STRESS_SIGMA_Z: return z;
    case OVR_STRESS_TAU_XZ: return s.tau;
    case OVR_STRESS_SIGMA_Y: return y;
    case OVR_STRESS_VON_MISES: return sqrt(3 * shear * shear + across * across);
    case OVR_STRESS_MAX_SHEAR: return shear;
    case OVR_STRESS_TRESCA: return fmax(shear, (fabs(across) + shear) / 2);
    default: return (x + y + z) / 3;
    }
}
