/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flow of a shear-thinning film (equations in flow.h). */
#include <math.h>

#include "multigrid/plain.h"

#include "contact/flow_factor.h"
#include "contact/flow_law.h"
#include "multigrid/faces.h"
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

/* eps and c are sums over both nodes */
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

/* A table cell along s_N or g: cubic interpolation between its ends, where
 * value and slope are known. Weights of these four values; and for the
 * derivative. */
typedef struct part {
    int number;
    double b[4], d[4];
} part;

static part part_of(double x)
{
    int octave;
    double place = 8 * frexp(x, &octave) - 4, w = ldexp(0.25, octave - 1);
    double t = place - floor(place);
    return (part){4 * (octave - 1) + (int)place,
                  {(1 + 2 * t) * (1 - t) * (1 - t), w * t * (1 - t) * (1 - t),
                   t * t * (3 - 2 * t), w * t * t * (t - 1)},
                  {6 * t * (t - 1) / w, (1 - t) * (1 - 3 * t),
                   6 * t * (1 - t) / w, t * (3 * t - 2)}};
}

/* A table value, its derivatives with respect to s_N and g, and the arguments
 * limited to the table; `beyond` is the excess of s_N. */
typedef struct value {
    double ln, by_s, by_g, s, g, beyond;
} value;

static value value_at(const double *table, double s_N, double g)
{
    /* limits the argument to the table, also if it is NaN (films of failed or
     * crossing iterates) */
    double x = fmin(1 + fmax(s_N, 0), OVR_LAW_MAX_SLIDE);
    double y = fmin(1 + fabs(g), OVR_LAW_MAX_GRADIENT);
    part s = part_of(x), along = part_of(y);
    double beyond = fmax(s_N / (OVR_LAW_MAX_SLIDE - 1), 1);
    value v = {.s = x - 1, .g = y - 1, .beyond = beyond};
    for (int m = 0; m < 2; m++)
        for (int l = 0; l < 2; l++) {
            int node = (s.number + m) * OVR_LAW_ROW + along.number + l;
            for (int k = 0; k < 4; k++) {
                int i = 2 * m + k % 2, j = 2 * l + k / 2;
                double c = table[4 * node + k];
                v.ln += s.b[i] * along.b[j] * c;
                v.by_s += s.d[i] * along.b[j] * c;
                v.by_g += s.b[i] * along.d[j] * c;
            }
        }
    v.ln += v.s * v.by_s * log(beyond);
    return v;
}

static half by_table(const ovr_flow_law *law, double g, double eps, double c)
{
    eps = fmax(eps, 1e-290);
    double s_N = fmin(c / eps, 1e280);
    value v = value_at(law->flow, s_N, g);
    double Phi = exp(v.ln), flow = Phi * eps;
    return (half){flow, flow * (1 + v.g * v.by_g), Phi * (1 - v.s * v.by_s),
                  Phi * v.by_s / v.beyond};
}

static half half_of(const ovr_fluid *fluid, double g, double eps, double c)
{
    if (fluid->lubricant.rheology == OVR_EYRING)
        return eyring(g, eps, c);
    return by_table(fluid->lubricant.flow_law, g, eps, c);
}

double ovr_flow_stress(const ovr_flow_law *law, double s_N, double g)
{
    double s = fmin(s_N, 1e280);
    return s_N * exp(value_at(law->stress, s, g).ln);
}

/* Sum over two nodes: eps or psi_c rho H^2, the power of H in it (3 or 2), and
 * its derivatives with respect to the film thicknesses. */
typedef struct sum {
    double value, share, by_film[2];
} sum;

static sum sum_of(bool gap, double power, const double *H, const double *x,
                  const double *slope)
{
    double p = !gap ? 1
                    : (power > 2 ? face_share : face_square_share)(H[0], H[1]);
    sum s = {p * x[0] + (2 - p) * x[1], p, {slope[0], slope[1]}};
    if (!gap)
        return s;
    s.value = fmax(s.value, 0);
    s.by_film[0] = face_by_film(power, p, H[0], slope[0], x[0], x[1]);
    s.by_film[1] = face_by_film(power, 2 - p, H[1], slope[1], x[1], x[0]);
    return s;
}

/* The flow coefficient between two nodes; its derivatives with respect to
 * pressure and film thickness. */
typedef struct between {
    double value, left, right, by_film[2];
} between;

/* h (rho_i + rho_j) times the logarithmic mean of m = eps/(rho H^3). */
static between logarithmic(const ovr_pair *n, double d, const double s[2],
                           const double slope[2], bool secants)
{
    double a = pow(face_film(n->H[0]), 3), b = pow(face_film(n->H[1]), 3);
    double rho[2] = {n->q[0] / n->H[0], n->q[1] / n->H[1]},
           h = 2 * a * b / (a + b);
    double m[2] = {fmax(n->eps[0], 0) / (a * rho[0]),
                   fmax(n->eps[1], 0) / (b * rho[1])};
    double x = d / 2, mean = (m[0] + m[1]) / 2 * (x != 0 ? tanh(x) / x : 1);
    double flow = h * (rho[0] + rho[1]) * mean;
    double bound[2] = {2 * h * rho[0] * m[0], 2 * h * rho[1] * m[1]}, by[2];
    for (int k = 0; k < 2; k++) {
        double sign = k ? -1 : 1, exact = flow - s[k] * (flow - bound[k]) / d;
        if (fabs(d) < 1e-3)
            exact = flow - sign * s[k] * flow / 2;
        by[k] = fmax(exact, secants ? flow : fmin(flow, bound[k]));
    }
    between of = {.value = flow, .left = by[0], .right = by[1]};
    for (int k = 0; k < 2; k++) {
        double p = 2 * (k ? a : b) / (a + b), H = face_film(n->H[k]);
        double viscous = n->H[k] > 0 ? slope[k] - 3 * n->eps[k] / H : 0;
        of.by_film[k] = p * (1.5 * flow / H + viscous);
    }
    return of;
}

static between eps_at(const ovr_fluid *fluid, const ovr_fields *f, ptrdiff_t i)
{
    double none[2] = {0}, *slope = f->deps_dH ? f->deps_dH + i : none;
    if (fluid->logarithmic) {
        const ovr_pair n = {
            .H = {f->H[i], f->H[i + 1]},
            .q = {f->rho[i] * f->H[i], f->rho[i + 1] * f->H[i + 1]},
            .eps = {f->eps[i], f->eps[i + 1]}};
        double d = log(2) * (f->log_fluidity[i + 1] - f->log_fluidity[i]);
        double rise = f->P[i + 1] - f->P[i];
        const double s[2] = {f->log_slope[i] * rise,
                             f->log_slope[i + 1] * rise};
        return logarithmic(&n, d, s, slope, fluid->secants);
    }
    sum s = sum_of(fluid->by_gap, 3, f->H + i, f->eps + i, slope);
    double rise = f->P[i + 1] - f->P[i];
    return (between){s.value,
                     s.value - s.share * f->deps[i] * rise,
                     s.value + (2 - s.share) * f->deps[i + 1] * rise,
                     {s.by_film[0], s.by_film[1]}};
}

static sum drag_at(const ovr_fluid *fluid, const ovr_fields *f, ptrdiff_t i)
{
    const double q[2] = {dragged(f, i), dragged(f, i + 1)};
    const double slope[2] = {2 * q[0], 2 * q[1]};
    const double drag[2] = {q[0] * f->H[i], q[1] * f->H[i + 1]};
    return sum_of(fluid->by_gap, 2, f->H + i, drag, slope);
}

void ovr_flow_plain(const ovr_fluid *fluid, double D, const ovr_lanes *g,
                    const ovr_fields *f)
{
    double slide = ovr_flow_slide(fluid);
    double gradient = ovr_flow_gradient(fluid, D);
    for (ptrdiff_t i = 0; i + 1 < (ptrdiff_t)g->n; i++) {
        double H = f->H[i] + f->H[i + 1];
        between eps = eps_at(fluid, f, i);
        sum drag = drag_at(fluid, f, i);
        half h = half_of(fluid, gradient * H * (f->P[i + 1] - f->P[i]),
                         eps.value, slide * drag.value);
        f->flow[i] = h.flow;
        f->out_left[i] = h.tangent - h.R * (eps.value - eps.left);
        f->out_right[i] = h.tangent + h.R * (eps.right - eps.value);
        if (!f->by_left)
            continue;
        double by_g = (h.tangent - h.flow) / H, by_c = slide * h.by_c;
        f->by_left[i] = h.R * eps.by_film[0] + by_c * drag.by_film[0] + by_g;
        f->by_right[i] = h.R * eps.by_film[1] + by_c * drag.by_film[1] + by_g;
    }
}

void ovr_faces_plain(const ovr_fluid *of, const ovr_lanes *g,
                     const ovr_fields *f)
{
    const ovr_fluid fluid = {
        .by_gap = true, .logarithmic = f->log_fluidity, .secants = of->secants};
    for (ptrdiff_t i = 0; i + 1 < (ptrdiff_t)g->n; i++) {
        between eps = eps_at(&fluid, f, i);
        f->flow[i] = eps.value;
        f->out_left[i] = eps.left;
        f->out_right[i] = eps.right;
        if (!f->by_left)
            continue;
        f->by_left[i] = eps.by_film[0];
        f->by_right[i] = eps.by_film[1];
    }
}

void ovr_apply_flow_factor(const ovr_fluid *fluid, const ovr_lanes *g,
                           const ovr_fields *f)
{
    bool lanes = g->V > 1; /* without lanes there are no halos */
    ptrdiff_t V = (ptrdiff_t)g->V, first = lanes ? -OVR_HALO * V : 0;
    ptrdiff_t end = lanes ? (ptrdiff_t)g->S * V : (ptrdiff_t)g->n - 1;
    for (ptrdiff_t m = first; m < end; m++) {
        double H = 0.5 * (f->H[m] + f->H[m + V]), slope, flow = f->flow[m];
        double phi = ovr_flow_factor_at(fluid->factor, H, &slope);
        f->flow[m] = phi * flow;
        f->out_left[m] *= phi;
        f->out_right[m] *= phi;
        if (f->by_left) {
            f->by_left[m] = phi * f->by_left[m] + 0.5 * slope * flow;
            f->by_right[m] = phi * f->by_right[m] + 0.5 * slope * flow;
        }
    }
}

/* ln(m_j/m_i), m = eps/(q H^2) */
static double log_ratio(const ovr_pair *n)
{
    double x[2];
    for (int k = 0; k < 2; k++) {
        double H = face_film(n->H[k]);
        x[k] = fmax(n->eps[k], 1e-280) / (n->q[k] * H * H);
    }
    return log(x[1] / x[0]);
}

double ovr_flow_between(const ovr_fluid *fluid, double dX,
                        const ovr_pair *nodes)
{
    const double *H = nodes->H, *q = nodes->q, none[2] = {0};
    const double drag[2] = {q[0] * H[0], q[1] * H[1]};
    bool gap = fluid->by_gap;
    double twice_eps =
        fluid->logarithmic
            ? logarithmic(nodes, log_ratio(nodes), none, none, false).value
            : sum_of(gap, 3, H, nodes->eps, none).value;
    double slope, phi = fluid->factor
                            ? ovr_flow_factor_at(fluid->factor,
                                                 0.5 * (H[0] + H[1]), &slope)
                            : 1;
    if (!ovr_flow_is_shear_thinning(fluid))
        return 0.5 * phi * twice_eps;
    double g = ovr_flow_gradient(fluid, dX) * (H[0] + H[1]) *
               (nodes->P[1] - nodes->P[0]);
    double c = ovr_flow_slide(fluid) * sum_of(gap, 2, H, drag, none).value;
    return 0.5 * phi * half_of(fluid, g, twice_eps, c).flow;
}
