/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plastic flow by von Mises, plane strain, associated:
 *
 *     f = sqrt(3/2) |dev s - a| - Y(e),  de_p = 3/2 de (dev s - a)/(f + Y)
 *
 *     none        Y                      a = 0
 *     linear      Y + h e
 *     kinematic   Y                      a = 2/3 h e_p   (W. Prager)
 *     swift       B (C + 1e6 e)^n        (H. W. Swift, J. Mech. Phys. Solids 1,
 *                                        1952)
 *
 * One step of the return mapping has de = f/(3G + Y' + h). The stress response
 * of the body to a plastic strain lies in [-2G, 0) times the strain
 * (plastic.c), so the alternation of steps and stress updates contracts.  In
 * the units of plastic.c 2G = 1 - nu.
 */
#include <math.h>

#include "stress/hardening.h"

double ovr_yield_stress(const ovr_hardening *h, double all, double *slope)
{
    double base;
    switch (h->law) {
    case OVR_HARDENS_LINEAR:
        *slope = h->modulus;
        return h->yield + h->modulus * all;
    case OVR_HARDENS_SWIFT:
        base = h->offset + h->microstrain * all;
        *slope = h->strength * h->power * h->microstrain *
                 pow(base, h->power - 1);
        return h->strength * pow(base, h->power);
    default: *slope = 0; return h->yield;
    }
}

static double along_strain(const ovr_hardening *h)
{
    return h->law == OVR_HARDENS_KINEMATIC ? h->modulus : 0;
}

/* Computes dev s - a; returns the square of its von Mises stress. */
static double driving(const ovr_hardening *h, ovr_strained e, ovr_stressed s,
                      ovr_stressed *by)
{
    double mean = (s.x + s.y + s.z) / 3, back = along_strain(h) * 2 / 3;
    *by = (ovr_stressed){s.x - mean - back * e.x,
                         s.y - mean + back * (e.x + e.z),
                         s.z - mean - back * e.z, s.xz - back * e.xz};
    return 1.5 * (by->x * by->x + by->y * by->y + by->z * by->z +
                  2 * by->xz * by->xz);
}

double ovr_beyond_yield(const ovr_hardening *h, ovr_strained e, ovr_stressed s)
{
    ovr_stressed by;
    double slope;
    return sqrt(driving(h, e, s, &by)) - ovr_yield_stress(h, e.all, &slope);
}

bool ovr_near_yield(const ovr_hardening *h, ovr_strained e, ovr_stressed s,
                    double share)
{
    ovr_stressed by;
    double square = driving(h, e, s, &by), minimum = share * h->yield, slope;
    if (square < minimum * minimum)
        return false;
    return sqrt(square) > share * ovr_yield_stress(h, e.all, &slope);
}

double ovr_plastic_flow(const ovr_hardening *h, double poisson, ovr_stressed s,
                        ovr_strained *e, double *work)
{
    const double minimum = 1e-6;
    ovr_stressed by;
    double slope, square = driving(h, *e, s, &by);
    if (!(square > h->yield * h->yield)) /* below the initial yield stress,
                                          * which flow can only increase */
        return 0;
    double Y = ovr_yield_stress(h, e->all, &slope);
    double mises = sqrt(square), f = mises - Y;
    if (!(f > minimum * Y))
        return 0;
    double flow = f / (1.5 * (1 - poisson) + slope + along_strain(h));
    double part = 1.5 * flow / mises;
    e->x += part * by.x;
    e->z += part * by.z;
    e->xz += part * by.xz;
    e->all += flow;
    *work += part * (s.x * by.x + s.y * by.y + s.z * by.z + 2 * s.xz * by.xz);
    return flow;
}
