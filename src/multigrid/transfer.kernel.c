/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transfers between a grid and the next coarser one (equations in fas.h), and
 * sums of arrays: plain loops that compilers turn into vectors. */
#include "multigrid/kernels.h"

/* Eight partial sums: the same result whatever the vector width. */
double OVR_KERNEL(sum)(size_t n, const double *x)
{
    double part[8] = {0}, sum = 0;
    size_t i = 0;
    for (; i + 8 <= n; i += 8)
        for (size_t l = 0; l < 8; l++)
            part[l] += x[i + l];
    for (; i < n; i++)
        sum += x[i];
    for (size_t l = 0; l < 8; l++)
        sum += part[l];
    return sum;
}

/* result = a x + b y */
void OVR_KERNEL(combine)(size_t n, double a, const double *restrict x, double b,
                         const double *restrict y, double *restrict result)
{
    for (size_t i = 0; i < n; i++)
        result[i] = a * x[i] + b * y[i];
}

/* gap = H - H0 + w, where the gap's place holds H. */
void OVR_KERNEL(coarse_gap)(size_t n, double H0, const double *restrict w,
                            double *restrict gap)
{
    for (size_t i = 0; i < n; i++)
        gap[i] = gap[i] - H0 + w[i];
}

/* P_c, H where the coarse nodes are, and the residual of wet nodes; zero at
 * both ends. */
void OVR_KERNEL(restrict_fields)(size_t nc, const double *restrict P,
                                 const double *restrict H,
                                 const double *restrict r, double *restrict Pc,
                                 double *restrict entry, double *restrict Hc,
                                 double *restrict rc)
{
    for (size_t I = 0; I < nc; I++)
        Hc[I] = H[2 * I];
    for (size_t I = 1; I + 1 < nc; I++) {
        double left = P[2 * I - 1], here = P[2 * I], right = P[2 * I + 1];
        double mean = 0.25 * (left + 2 * here + right);
        double wet = left > 0 ? mean : here;
        wet = right > 0 ? wet : here;
        Pc[I] = entry[I] = here > 0 ? wet : here;
    }
    for (size_t I = 1; I + 1 < nc; I++) {
        double left = P[2 * I - 1] > 0 ? r[2 * I - 1] : 0;
        double right = P[2 * I + 1] > 0 ? r[2 * I + 1] : 0;
        double mean = 0.25 * (left + 2 * r[2 * I] + right);
        rc[I] = P[2 * I] > 0 ? mean : 0;
    }
    Pc[0] = Pc[nc - 1] = entry[0] = entry[nc - 1] = rc[0] = rc[nc - 1] = 0;
}

/* F = N + residual, for r = -N; then r is the residual. */
void OVR_KERNEL(coarse_side)(size_t n, const double *restrict residual,
                             double *restrict F, double *restrict r)
{
    for (size_t i = 0; i < n; i++) {
        F[i] = residual[i] - r[i];
        r[i] = residual[i];
    }
}

static inline double lifted(double P, double change)
{
    double sum = P + change;
    sum = sum > 0 ? sum : 0;
    return P > 0 ? sum : 0;
}

void OVR_KERNEL(correct)(size_t nc, double factor, const double *restrict Pc,
                         const double *restrict entry, double *restrict P)
{
    for (size_t I = 0; I + 1 < nc; I++) {
        double left = factor * (Pc[I] - entry[I]);
        double right = factor * (Pc[I + 1] - entry[I + 1]);
        P[2 * I] = lifted(P[2 * I], left);
        P[2 * I + 1] = lifted(P[2 * I + 1], 0.5 * (left + right));
    }
}

/* Extrapolation in time where it is wet, clipped at zero. */
void OVR_KERNEL(extrapolate)(size_t n, const double e[3],
                             const double *restrict a, const double *restrict b,
                             const double *restrict c, double *restrict P)
{
    double e0 = e[0], e1 = e[1], e2 = e[2];
    for (size_t i = 0; i < n; i++) {
        double next = e0 * a[i] + e1 * b[i] + e2 * c[i];
        next = next > 0 ? next : 0;
        P[i] = a[i] > 0 ? next : a[i];
    }
}
