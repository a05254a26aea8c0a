/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual and mass-flow imbalance of the equation stated in reynolds.h. */
#include "multigrid/reynolds.h"
#include "multigrid/vector.h"

/* N_i of one row, with its own weights */
static double row(const ovr_fields *f, size_t i, double half, double a0,
                  double a1, double a2)
{
    const double *P = f->P, *eps = f->eps, *q = f->q;
    return half * ((eps[i - 1] + eps[i]) * (P[i - 1] - P[i]) +
                   (eps[i] + eps[i + 1]) * (P[i + 1] - P[i])) -
           a0 * q[i] - a1 * q[i - 1] - a2 * q[i - 2];
}

/* r = F - N in rows 1..n-2, zero at both ends. */
void OVR_KERNEL(residual)(size_t n, const ovr_weights *w, const ovr_fields *f)
{
    const double *P = f->P, *eps = f->eps, *q = f->q;
    for (size_t i = 0; i < n; i += VEC) {
        vec P0 = load(P + i), e0 = load(eps + i);
        vec up = (load(eps + i - 1) + e0) * (load(P + i - 1) - P0);
        vec down = (e0 + load(eps + i + 1)) * (load(P + i + 1) - P0);
        vec N = w->half * (up + down) - w->a0 * load(q + i) -
                w->a1 * load(q + i - 1) - w->a2 * load(q + i - 2);
        store(f->r + i, load(f->F + i) - N);
    }
    f->r[1] = f->F[1] - row(f, 1, w->half, w->a0_first, w->a1_first, 0);
    f->r[0] = f->r[n - 1] = 0;
}

/* sum rho_i over rows 1..n-2 of the residual in f->r; always in the same
 * order whatever the vector width: eight partial sums. */
double OVR_KERNEL(imbalance)(size_t n, const ovr_weights *w,
                             const ovr_fields *f)
{
    double part[8] = {0}, sum = 0;
    const double *restrict P = f->P, *restrict eps = f->eps, *restrict r = f->r;
    size_t i = 1;
    for (; i + 8 <= n - 1; i += 8)
        for (size_t l = 0; l < 8; l++) {
            size_t j = i + l;
            double d = w->half * (eps[j - 1] + 2 * eps[j] + eps[j + 1]);
            double fall = P[j] * d < r[j] ? P[j] * d : r[j];
            part[l] += r[j] < 0 ? -r[j] : fall;
        }
    for (; i < n - 1; i++) {
        double d = w->half * (eps[i - 1] + 2 * eps[i] + eps[i + 1]);
        double fall = P[i] * d < r[i] ? P[i] * d : r[i];
        part[0] += r[i] < 0 ? -r[i] : fall;
    }
    for (size_t l = 0; l < 8; l++)
        sum += part[l];
    return sum;
}
