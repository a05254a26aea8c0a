/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/reynolds.h"

void ovr_reynolds_wedge(ovr_operator *op, bool second_order, double Cu)
{
    op->w[0] = second_order ? 1.5 * Cu : Cu;
    op->w[1] = second_order ? -2 * Cu : -Cu;
    op->w[2] = second_order ? 0.5 * Cu : 0;
    op->w_first[0] = Cu;
    op->w_first[1] = -Cu;
}

ovr_weights ovr_reynolds_weights(const ovr_operator *op, double D)
{
    ovr_weights w;
    for (int m = 0; m < 3; m++) {
        double cT = m == 0 ? op->cT : 0;
        w.a[m] = op->w[m] / D + cT;
        w.first[m] = m < 2 ? op->w_first[m] / D + cT : 0;
        w.skew[m] = w.skew_first[m] = 0;
    }
    w.half = 0.5 / (D * D);
    w.hold = 1e-12 * w.a[0];
    w.closed[0] = w.a[0];
    w.closed[1] = -w.a[2];
    w.closed[2] = 0;
    w.out = op->limited[0] / D;
    w.time = op->limited[1];
    w.source = 0;
    return w;
}

ovr_shares ovr_reynolds_shares(const ovr_operator *op, double D)
{
    double theta = 1;
    if (op->characteristic) {
        theta = 0;
    } else if (op->transient) {
        /* Cu = 0: tau is infinite */
        double tau = op->cT * D, scale = 0.2 * op->speed;
        theta = scale * scale / (scale * scale + tau * tau);
    }
    return (ovr_shares){-0.5 * (1 + theta), -0.5 * (1 - theta), op->transient};
}
