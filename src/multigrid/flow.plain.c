/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flow of a film that shears thin (equations in flow.h). */
#include <math.h>

#include "multigrid/plain.h"

#include "contact/flow_law.h"
#include "multigrid/flow.h"

typedef struct half {
    double flow, tangent, R; /* 2 E, 2 T, R */
    double by_c;             /* dE/dc */
} half;

/* 3 (x cosh x - sinh x)/x^3 */
static double poiseuille(double x)
{
    double s = x * x;
    if (x < 0.25)
        return 1 + s / 10 * (1 + s / 28 * (1 + s / 54 * (1 + s / 88)));
    return 3 * (cosh(x) - sinh(x) / x) / s;
}

/* eps, c: of both nodes, summed */
static half eyring(double g, double eps, double c)
{
    double x = fmin(fabs(g), 200), A = poiseuille(x);
    double shc = x > 0 ? sinh(x) / x : 1, bc = c / shc;
    double W = sqrt(eps * eps + bc * bc + 1e-290);
    double bend = A * A / shc * x * x / 3 * bc * bc;
    return (half){A * W, (3 * shc - 2 * A) * W - bend / W, A * eps / W,
                  A / shc * bc / W};
}

/* psi_c q */
static double dragged(const ovr_fields *f, ptrdiff_t i)
{
    return f->drag ? f->drag[i] * f->q[i] : f->q[i];
}

/* The spline of a table, and its slopes by ln s_N and ln g. */
static double spline(const double *table, double s_N, double g, double slope[2])
{
    const int most[2] = {OVR_LAW_SLIDES, OVR_LAW_GRADIENTS};
    double x[2] = {s_N, fmin(fabs(g), 300)}, b[2][4], d[2][4], past = 0;
    double value = 0, by[2] = {0, 0};
    int k[2];
    for (int m = 0; m < 2; m++) {
        double at = OVR_LAW_PER * asinh(x[m]);
        k[m] = at < most[m] - 1 ? (int)at : most[m] - 1;
        double t = fmin(at - k[m], 1);
        past = m ? past : at - k[m] - t;
        ovr_law_weights(t, b[m], d[m]);
    }
    const double *corner = table + k[0] * OVR_LAW_ROW + k[1];
    for (int m = 0; m < 4; m++)
        for (int l = 0; l < 4; l++) {
            double c = corner[m * OVR_LAW_ROW + l];
            value += b[0][m] * b[1][l] * c;
            by[0] += d[0][m] * b[1][l] * c;
            by[1] += b[0][m] * d[1][l] * c;
        }
    for (int m = 0; m < 2; m++)
        slope[m] = OVR_LAW_PER * by[m] * x[m] / hypot(1, x[m]);
    return value + by[0] * past;
}

static half by_table(const ovr_flow_law *law, double g, double eps, double c)
{
    double slope[2], s_N;
    eps = fmax(eps, 1e-290);
    s_N = fmin(fmax(c / eps, 1e-4), 1e280);
    double Phi = exp(spline(law->flow, s_N, g, slope)), flow = Phi * eps;
    return (half){flow, flow * (1 + slope[1]), Phi * (1 - slope[0]),
                  Phi * slope[0] / s_N};
}

static half half_of(const ovr_fluid *fluid, double g, double eps, double c)
{
    if (fluid->lubricant.rheology == OVR_EYRING)
        return eyring(g, eps, c);
    return by_table(fluid->lubricant.flow_law, g, eps, c);
}

double ovr_flow_stress(const ovr_flow_law *law, double s_N, double g)
{
    double unused[2], s = fmin(fmax(s_N, 1e-4), 1e280);
    return s_N * exp(spline(law->stress, s, g, unused));
}

static double drag(const ovr_fields *f, ptrdiff_t i)
{
    return dragged(f, i) * f->H[i] + dragged(f, i + 1) * f->H[i + 1];
}

void ovr_flow_plain(const ovr_fluid *fluid, double D, const ovr_lanes *g,
                    const ovr_fields *f)
{
    double slide = ovr_flow_slide(fluid);
    double gradient = ovr_flow_gradient(fluid, D);
    for (ptrdiff_t i = 0; i + 1 < (ptrdiff_t)g->n; i++) {
        double H = f->H[i] + f->H[i + 1];
        half h = half_of(fluid, gradient * H * (f->P[i + 1] - f->P[i]),
                         f->eps[i] + f->eps[i + 1], slide * drag(f, i));
        f->flow[i] = h.flow;
        f->tangent[i] = h.tangent;
        f->by_eps[i] = h.R;
        if (!f->by_left)
            continue;
        double by_g = (h.tangent - h.flow) / H, by_c = 2 * slide * h.by_c;
        f->by_left[i] = h.R * f->deps_dH[i] + by_c * dragged(f, i) + by_g;
        f->by_right[i] = h.R * f->deps_dH[i + 1] + by_c * dragged(f, i + 1) +
                         by_g;
    }
}

double ovr_flow_between(const ovr_fluid *fluid, double dX,
                        const ovr_pair *nodes)
{
    const double *H = nodes->H, *q = nodes->q, *eps = nodes->eps;
    double twice_eps = eps[0] + eps[1];
    if (!ovr_flow_thins(fluid))
        return 0.5 * twice_eps;
    double g = ovr_flow_gradient(fluid, dX) * (H[0] + H[1]) *
               (nodes->P[1] - nodes->P[0]);
    double c = ovr_flow_slide(fluid) * (q[0] * H[0] + q[1] * H[1]);
    return 0.5 * half_of(fluid, g, twice_eps, c).flow;
}
