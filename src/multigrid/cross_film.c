/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Temperature and velocity across the film (equations in cross_film.h). */
#include "multigrid/cross_film.h"

#include <math.h>

#include "base/larger.h"
#include "contact/flow_law.h"
#include "contact/heat_numbers.h"
#include "multigrid/expansion.h"
#include "multigrid/flow.h"

/* ---------------------------------------------------- points and matrices */

/* Legendre's polynomial of degree n. */
static double legendre(int n, double x)
{
    double before = 1, value = x;
    for (int k = 2; k <= n; k++) {
        double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return n ? value : 1;
}

/* Lagrange polynomial j at x. */
static double lagrange(const ovr_cross_film *a, int j, double x)
{
    double value = 1;
    for (int k = 0; k < a->n; k++)
        if (k != j)
            value *= (x - a->s[k]) / (a->s[j] - a->s[k]);
    return value;
}

/* d l_j/dzeta at point i. */
static double derivative(const ovr_cross_film *a, int i, int j)
{
    double sum = 0, up = 1, down = 1;
    if (i == j) {
        for (int k = 0; k < a->n; k++)
            if (k != i)
                sum += 1 / (a->s[i] - a->s[k]);
        return 2 * sum;
    }
    for (int k = 0; k < a->n; k++) {
        if (k != i && k != j)
            up *= a->s[i] - a->s[k];
        if (k != j)
            down *= a->s[j] - a->s[k];
    }
    return 2 * up / down;
}

/* Computes the points from the middle to surface 2; the others are symmetric.
 */
static void make_points(int points, ovr_cross_film *a)
{
    static const double five[4] = {0, 0.65465367070797714380, 1};
    static const double seven[4] = {0, 0.46884879347071421380,
                                    0.83022389627856692987, 1};
    const double *from = points == 5 ? five : seven;
    int half = points == 5 ? 2 : 3, n = 2 * half + 1;
    a->n = n;
    for (int k = 0; k <= half; k++) {
        double p = legendre(n - 1, from[k]);
        a->s[half + k] = from[k];
        a->s[half - k] = -from[k];
        a->w[half + k] = a->w[half - k] = 1 / (n * (n - 1) * p * p);
    }
}

void ovr_cross_film_make(int points, ovr_cross_film *a)
{
    double D[OVR_CROSS_FILM_MAX][OVR_CROSS_FILM_MAX] = {{0}};
    double squares = 0;
    make_points(points, a);
    for (int j = 0; j < points; j++) {
        double p = legendre(points - 1, a->s[j]);
        a->last[j] = a->w[j] * p;
        squares += a->w[j] * p * p;
    }
    for (int j = 0; j < points; j++)
        a->last[j] /= squares;
    for (int i = 0; i < points; i++)
        for (int j = 0; j < points; j++)
            D[i][j] = derivative(a, i, j);
    for (int i = 0; i < points; i++)
        for (int j = 0; j < points; j++) {
            a->K[i][j] = a->integral[i][j] = 0;
            for (int k = 0; k < points; k++) {
                /* quadrature points, mapped to the interval from -1 to s_i */
                double x = (a->s[i] + 1) * (a->s[k] + 1) / 2 - 1;
                a->K[i][j] += D[k][i] * a->w[k] * D[k][j];
                a->integral[i][j] += (a->s[i] + 1) / 2 * a->w[k] *
                                     lagrange(a, j, x);
            }
        }
}

void ovr_cross_film_move(const ovr_cross_film *from, const double *T,
                         const ovr_cross_film *to, double *moved)
{
    for (int i = 0; i < to->n; i++) {
        moved[i] = 0;
        for (int j = 0; j < from->n; j++)
            moved[i] += lagrange(from, j, to->s[i]) * T[j];
    }
}

/* ------------------------------------------------------------------- flow */

/* Flow at a cavitated node: the lubricant moves with the surfaces, with a
 * linear velocity profile. */
static void linear(const ovr_cross_film *a, const ovr_sheet *sheet,
                   ovr_cross_film_flow *flow)
{
    flow->t = flow->even = 0;
    for (int j = 0; j < a->n; j++) {
        flow->u[j] = sheet->u1 - sheet->V * (1 + a->s[j]) / 2;
        flow->heating[j] = 0;
    }
}

/* Pressurized film at the points of `a`: fluidity ratios r and their moments m,
 * with Y as in cross_film.h. */
typedef struct wet_film {
    const ovr_cross_film *a;
    const ovr_sheet *sheet;
    double Y;
    const double *r, *m;
} wet_film;

/* Returns the mean stress of a Newtonian film and computes u_z in `rate`. */
static double newtonian(const wet_film *f, double *rate)
{
    double G = f->sheet->H * f->sheet->P_X / 2;
    double t = (-f->sheet->V * f->Y - G * f->m[1]) / f->m[0];
    for (int j = 0; j < f->a->n; j++)
        rate[j] = f->r[j] * (t + G * f->a->s[j]) / f->Y;
    return t;
}

static double eyring(const wet_film *f, double *rate)
{
    const double maximum = 200; /* as a power of e */
    const ovr_cross_film *a = f->a;
    const double *r = f->r, Sigma0 = f->sheet->Sigma0;
    double g = f->sheet->H * f->sheet->P_X / (2 * Sigma0), A = 0, B = 0;
    double b = -f->sheet->V * f->Y / Sigma0, square, root, sinh_a, cosh_a;
    g = ovr_larger(-maximum, ovr_smaller(maximum, g));
    for (int j = 0; j < a->n; j++) {
        A += a->w[j] * r[j] * cosh(g * a->s[j]);
        B += a->w[j] * r[j] * sinh(g * a->s[j]);
    }
    square = (A - B) * (A + B);
    root = sqrt(square + b * b);
    sinh_a = (b * A - root * B) / square;
    cosh_a = (root * A - b * B) / square;
    for (int j = 0; j < a->n; j++)
        rate[j] = Sigma0 / f->Y * r[j] *
                  (sinh_a * cosh(g * a->s[j]) + cosh_a * sinh(g * a->s[j]));
    return Sigma0 * asinh(sinh_a);
}

/* Returns the velocity difference across the film for mean stress a, relative
 * to Sigma0/Y, and its derivative with respect to a. */
static double slid(const wet_film *f, double a, double g, double *by_a)
{
    double sum = 0, slope;
    *by_a = 0;
    for (int j = 0; j < f->a->n; j++) {
        double part = f->a->w[j] * f->r[j];
        sum += part *
               ovr_curve_at(&f->sheet->law->f, a + g * f->a->s[j], &slope);
        *by_a += part * slope;
    }
    return sum;
}

/* Computes the shear rate of a tabulated law by Newton's method between bounds.
 * The first guess is the stress of a film with the same mean fluidity: f(x) >=
 * x because the film is shear-thinning. */
static double by_law(const wet_film *f, double *rate)
{
    const ovr_sheet *sheet = f->sheet;
    double g = sheet->H * sheet->P_X / (2 * sheet->Sigma0), by_a;
    g = ovr_larger(-300, ovr_smaller(300, g)); /* limits of the tables */
    double b = -sheet->V * f->Y / sheet->Sigma0, uniform = fabs(b) / f->m[0];
    double high = fabs(g) + uniform, low = -high;
    double a = copysign(ovr_flow_stress(sheet->law, uniform, g), b);
    for (int k = 0; k < 60 && high > low; k++) {
        double off = slid(f, a, g, &by_a) - b;
        double step = off / by_a;
        *(off > 0 ? &high : &low) = a;
        a -= step;
        if (fabs(step) <= 1e-13 * (fabs(a) + fabs(g)))
            break;
        if (!(a > low && a < high))
            a = (low + high) / 2;
    }
    for (int j = 0; j < f->a->n; j++)
        rate[j] = sheet->Sigma0 / f->Y * f->r[j] *
                  ovr_curve_at(&sheet->law->f, a + g * f->a->s[j], &by_a);
    return sheet->Sigma0 * a;
}

static double stressed(const wet_film *f, double *rate)
{
    if (f->sheet->law)
        return by_law(f, rate);
    if (isfinite(f->sheet->Sigma0))
        return eyring(f, rate);
    return newtonian(f, rate);
}

/* Mean stress of a film with uniform fluidity m_0. */
static double uniform(const wet_film *of)
{
    double r[OVR_CROSS_FILM_MAX], rate[OVR_CROSS_FILM_MAX];
    const double m[3] = {of->m[0], 0, 0};
    if (of->sheet->V == 0)
        return 0;
    for (int j = 0; j < of->a->n; j++)
        r[j] = m[0];
    return stressed(&(wet_film){of->a, of->sheet, of->Y, r, m}, rate);
}

void ovr_cross_film_flow_of(const ovr_cross_film *a, const ovr_heat *heat,
                            const ovr_sheet *sheet, const double *T,
                            ovr_cross_film_flow *flow)
{
    double r[OVR_CROSS_FILM_MAX] = {0}, rate[OVR_CROSS_FILM_MAX] = {0}, maximum;
    double G = sheet->H * sheet->P_X / 2, *m = flow->m;
    flow->mean = m[0] = m[1] = m[2] = 0;
    for (int j = 0; j < a->n; j++) {
        flow->beta[j] = ovr_expansion(heat, sheet->P, T[j]);
        flow->mean += a->w[j] * T[j];
    }
    /* viscosity ratios eta(T_m)/eta(T_j) are limited to 1e43, and eta_m to
     * 1e130, whatever T */
    double log_eta = ovr_heat_log_viscosity(heat, sheet->log_eta, flow->mean);
    for (int j = 0; j < a->n; j++) {
        double ln = log_eta -
                    ovr_heat_log_viscosity(heat, sheet->log_eta, T[j]);
        r[j] = exp(ovr_larger(-100, ovr_smaller(100, ln)));
        double part = a->w[j] * r[j];
        m[0] += part;
        m[1] += part * a->s[j];
        m[2] += part * a->s[j] * a->s[j];
    }
    flow->log_eta = ovr_smaller(300, log_eta);
    if (!sheet->wet) {
        linear(a, sheet, flow);
        return;
    }
    const wet_film film = {
        a, sheet, sheet->lambda * exp(flow->log_eta) / (12 * sheet->H), r, m};
    flow->even = uniform(&film);
    flow->t = stressed(&film, rate);
    maximum = ovr_larger(sheet->limit - fabs(G), 0);
    flow->limited = fabs(flow->t) > maximum;
    flow->t = ovr_larger(-maximum, ovr_smaller(maximum, flow->t));
    flow->even = ovr_larger(-maximum, ovr_smaller(maximum, flow->even));
    for (int j = 0; j < a->n; j++) {
        flow->heating[j] = (flow->t + G * a->s[j]) * rate[j];
        flow->u[j] = sheet->u1;
        for (int k = 0; k < a->n; k++)
            flow->u[j] += a->integral[j][k] * rate[k];
    }
}

/* ------------------------------------------------------------------- heat */

double ovr_expansion(const ovr_heat *heat, double P, double T)
{
    double bT_f = expansion_at(heat, P);
    return bT_f * expansion_lightness(heat, bT_f, T);
}

/* Solves A x = b by elimination; A is nearly symmetric with a dominant
 * diagonal. */
static void eliminate(int n, double A[][OVR_CROSS_FILM_MAX], double *b)
{
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i < n; i++) {
            double factor = A[i][k] / A[k][k];
            for (int j = k + 1; j < n; j++)
                A[i][j] -= factor * A[k][j];
            b[i] -= factor * b[k];
        }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++)
            b[k] -= A[k][j] * b[j];
        b[k] /= A[k][k];
    }
}

void ovr_cross_film_solve(const ovr_cross_film *a, const ovr_heat *heat,
                          const ovr_sheet *sheet,
                          const ovr_cross_film_flow *flow,
                          const double *departure, const double *travel,
                          const ovr_wall wall[2], double *T)
{
    double A[OVR_CROSS_FILM_MAX][OVR_CROSS_FILM_MAX] = {{0}};
    double conduction = heat->conduction / sheet->H;
    int last = a->n - 1;
    for (int j = 0; j < a->n; j++) {
        double stored = a->w[j] * sheet->rho * sheet->H / travel[j];
        double pressing = sheet->wet
                              ? a->w[j] * heat->theta * flow->beta[j] *
                                    sheet->H *
                                    (sheet->P_T + flow->u[j] * sheet->P_X)
                              : 0;
        for (int l = 0; l < a->n; l++)
            A[j][l] = conduction * a->K[j][l];
        A[j][j] += stored - pressing;
        T[j] = stored * departure[j] + pressing * heat->T0 +
               a->w[j] * heat->theta * flow->heating[j];
        if (j == 0 || j == last) {
            const ovr_wall *side = &wall[j == last];
            double G = heat->conduction / side->resistance;
            A[j][j] += G;
            T[j] += G * side->h;
        }
    }
    eliminate(a->n, A, T);
}
