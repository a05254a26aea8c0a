/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass-conserving cavitation in rigid gaps, with solutions known by quadrature:
 * a parabolic gap with film rupture and reformation, a starved roller, and
 * plates that are squeezed and separated. Only the plain kernels are used, in a
 * gap without deformation. Rupture position, meniscus and cavity content are of
 * second order. */
#include <math.h>
#include <string.h>

#include "support/kernels.h"
#include "support/test.h"

typedef double function(double x, double parameter);

static double integral(function *f, double parameter, double a, double b)
{
    enum { PIECES = 2000 };
    double D = (b - a) / PIECES, sum = f(a, parameter) + f(b, parameter);
    for (int k = 1; k < PIECES; k++)
        sum += (k % 2 ? 4 : 2) * f(a + k * D, parameter);
    return sum * D / 3;
}

/* ------------------------------------------------------------------ the grid
 */

/* Rows (h^3 p')' - C q' = 0 from x_a on, D apart; the gap h. */
static test_grid rigid(size_t n, double x_a, double D, double C, function *h)
{
    test_grid g = test_grid_make(test_kernels(0), n);
    double c = C / D;
    g.D = D;
    memset(g.k, 0, sizeof g.k);
    g.weights = (ovr_weights){.a = {1.5 * c, -2 * c, 0.5 * c},
                              .first = {c, -c, 0},
                              .half = 0.5 / (D * D),
                              .out = c};
    for (size_t i = 0; i < n; i++) {
        double full = h(x_a + (double)i * D, 0);
        g.f.H[i] = g.f.full[i] = g.f.q[i] = full;
        g.f.eps[i] = full * full * full;
        g.f.wet[i] = true;
        g.f.P[i] = 1e-6;
    }
    return g;
}

static double imbalance(const test_grid *g)
{
    g->run->content_settle(&g->lanes, &g->weights, true, &g->f);
    g->run->content_residual(&g->lanes, &g->weights, &g->f);
    return g->D * g->run->content_imbalance(&g->lanes, &g->f);
}

/* Beside fluxes of 1 to 10; rounding leaves 1e-11 of it on fine grids. */
static const double UNSOLVED = 1e-10;

/* Relaxes until the equations are solved, with given pressures at both ends.
 * Without elasticity a sweep is a Newton step except for the states of the
 * nodes. */
static void solve(const test_grid *g, double before, double behind)
{
    const ovr_shares none = {0};
    for (int sweep = 0; sweep < 4000; sweep++) {
        g->f.P[0] = before;
        g->f.P[g->n - 1] = behind;
        if (imbalance(g) < UNSOLVED)
            return;
        g->run->content_choose(&g->lanes, &g->weights, &g->f);
        g->run->content_assemble(&g->lanes, &g->weights, g->k, &none, &g->f,
                                 &g->band);
        g->run->band_solve(&g->lanes, &g->band);
        g->run->content_advance(&g->lanes, 1e3, &none, &g->band, &g->f);
    }
    fail_msg("not solved");
}

/* Where the film begins that ends at node i. */
static double formation(const test_grid *g, double x_a, size_t i)
{
    const ovr_fields *f = &g->f;
    while (i > 1 && f->P[i - 1] > 0)
        i--;
    return x_a + ((double)i - 0.5) * g->D -
           g->D * (f->q[i - 1] - f->q[i - 2]) / (f->full[i - 1] - f->q[i - 2]);
}

/* Returns the maximum pressure, by a parabola. */
static double highest(const test_grid *g)
{
    const double *P = g->f.P;
    size_t i = 1;
    double slope, bend;
    for (size_t k = 1; k + 1 < g->n; k++)
        if (P[k] > P[i])
            i = k;
    slope = (P[i + 1] - P[i - 1]) / 2;
    bend = P[i + 1] - 2 * P[i] + P[i - 1];
    return P[i] - slope * slope / (2 * bend);
}

/* From grid to grid by four, three at least where nodes are taken one by
 * one. */
static void second_order(const double *error, int grids, const char *what)
{
    for (int k = 0; k < grids; k++)
        print_message("%s: error %.3g\n", what, error[k]);
    for (int k = 1; k < grids; k++)
        assert_true(error[k] < error[k - 1] / 3);
}

/* -------------------------------------------------------- parabolic gap
 *
 * h = 1 + 3 x^2 on [-1, 1], h^3 p' = 6 (h - q), p(-1) = 0, p(1) = 1/4: q = h at
 * the rupture, before which and behind the formation p is an integral. */

static double parabola(double x, double unused)
{
    (void)unused;
    return 1 + 3 * x * x;
}

static double slope(double x, double q)
{
    double h = parabola(x, 0);
    return 6 * (h - q) / (h * h * h);
}

static double find(double low, double high, bool (*beyond)(double x, double q),
                   double q)
{
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        *(beyond(middle, q) ? &high : &low) = middle;
    }
    return 0.5 * (low + high);
}

static bool ruptured(double x, double unused)
{
    (void)unused;
    return integral(slope, parabola(x, 0), -1, x) < 0;
}

static bool formed(double x, double q)
{
    return integral(slope, q, x, 1) < 0.25;
}

TEST(parabolic_gap)
{
    double x_r = find(0.05, 0.6, ruptured, 0), q = parabola(x_r, 0);
    double x_f = find(x_r, 1, formed, q), p = integral(slope, q, -1, -x_r);
    double place[3], pressure[3], flow[3];
    CHECK_NEAR(x_r, 0.2499575, 1e-7);
    CHECK_NEAR(x_f, 0.4695798, 1e-7);
    for (int k = 0; k < 3; k++) {
        size_t n = ((size_t)100 << k) + 1;
        test_grid g = rigid(n, -1, 2 / (double)(n - 1), 6, parabola);
        solve(&g, 0, 0.25);
        place[k] = fabs(formation(&g, -1, n - 2) - x_f);
        pressure[k] = fabs(highest(&g) - p);
        flow[k] = fabs(g.f.q[(size_t)(0.68 * (double)n)] - q);
        ovr_arena_release(&g.arena);
    }
    assert_true(place[0] < 4e-3);
    second_order(place, 3, "formation");
    second_order(pressure, 3, "pressure");
    second_order(flow, 3, "flow");
}

/* -------------------------------------------------------- starved roller
 *
 * h = 1 + x^2/2, q_s arrives: rupture where h = q_s, meniscus where the
 * integral of (h - q_s)/h^3 up to there vanishes. */

static double roller(double x, double unused)
{
    (void)unused;
    return 1 + x * x / 2;
}

static double roller_slope(double x, double q)
{
    double h = roller(x, 0);
    return (h - q) / (h * h * h);
}

static bool has_begun(double x, double q)
{
    return integral(roller_slope, q, x, sqrt(2 * (q - 1))) < 0;
}

static void starved_roller(double q, double known)
{
    double x_m = find(-8, -sqrt(2 * (q - 1)), has_begun, q), error[3];
    CHECK_NEAR(x_m, known, 1e-6);
    for (int k = 0; k < 3; k++) {
        size_t n = ((size_t)220 << k) + 1, middle;
        double D = 11 / (double)(n - 1);
        test_grid g = rigid(n, -8, D, 1, roller);
        ovr_weights *w = &g.weights;
        w->first[0] = 1.5 * w->out;
        w->first[1] = -0.5 * w->out;
        w->source = w->out * q;
        for (size_t i = 0; i < n; i++) {
            double x = -8 + (double)i * D;
            bool wet = x > -1 && roller(x, 0) < 2 * q && x < 0.3;
            g.f.wet[i] = wet;
            g.f.P[i] = wet ? 1e-6 : 0;
            g.f.q[i] = wet ? g.f.full[i] : q;
        }
        g.f.eps[0] = -g.f.eps[1];
        solve(&g, 0, 0);
        middle = (size_t)(8 / D + 0.5);
        error[k] = fabs(formation(&g, -8, middle) - x_m);
        CHECK_NEAR(g.f.q[n - 2], q, 1e-10);
        ovr_arena_release(&g.arena);
    }
    second_order(error, 3, "meniscus");
}

TEST(starved_rollers)
{
    starved_roller(1.1, -1.131255);
    starved_roller(1.2, -2.933597);
}

/* --------------------------------------------------------- squeezed plates
 *
 * h = 1 + 0.3 (1 - cos 2 pi t), (h^3 p')' = 12 d(theta h)/dt on [0, 1], p = 0.3
 * at both ends.  Drawn apart, the film ruptures from the middle out to f =
 * sqrt(p h^3/(6 h')), behind which the content stays what the gap was; squeezed
 * again it fills: the oil of one half, h f + what lies behind, grows by what
 * flows in, -h^3 p'(0)/12. */

enum { FINE = 400000 };

static double gap_at(double t)
{
    return 1 + 0.3 * (1 - cos(2 * acos(-1) * t));
}

static double opening(double t)
{
    return 0.6 * acos(-1) * sin(2 * acos(-1) * t);
}

static double front_at(double t)
{
    double h = gap_at(t);
    return fmin(0.5, sqrt(0.3 * h * h * h / (6 * opening(t))));
}

/* Oil of one half at times k/FINE up to where the cavity closes, and that time.
 */
static double oil_of_half(double oil[FINE + 1])
{
    static double left[FINE + 1]; /* content where the front was last */
    static double at[FINE + 1];   /* and where, from the middle out */
    size_t count = 0;
    bool turned = false;
    double f = 0.5, behind = 0;
    oil[0] = 0.5;
    for (size_t k = 1; k <= FINE; k++) {
        double t = (double)k / FINE, h = gap_at(t), D = 1. / FINE;
        double now = front_at(t);
        if (!turned && now <= f) { /* ruptures */
            behind += 0.5 * (f - now) * (gap_at(t - D) + h);
            f = now;
            at[count] = f;
            left[count++] = h;
            oil[k] = h * f + behind;
            continue;
        }
        turned = true;
        double middle = gap_at(t - 0.5 * D);
        double slope0 = -(0.3 + 6 * opening(t - 0.5 * D) * f * f /
                                    (middle * middle * middle)) /
                        f;
        oil[k] = oil[k - 1] - D * middle * middle * middle * slope0 / 12;
        while (count > 1 && h * at[count - 2] + behind -
                                    0.5 * (at[count - 2] - at[count - 1]) *
                                        (left[count - 2] + left[count - 1]) <=
                                oil[k]) {
            behind -= 0.5 * (at[count - 2] - at[count - 1]) *
                      (left[count - 2] + left[count - 1]);
            count--;
        }
        f = fmin(0.5, (oil[k] - behind) / h);
        if (count <= 1)
            return t;
    }
    return NAN;
}

static double plates(double x, double unused)
{
    (void)x, (void)unused;
    return 1;
}

/* Stores the history for the next step; B is limited where a cavitated node
 * lost content. */
static void remember(const test_grid *g, double dT, double *q1, double *q2,
                     bool *dry)
{
    const double c = 12 / dT;
    for (size_t i = 0; i < g->n; i++) {
        double B = 1.5 * q1[i] - 0.5 * q2[i];
        if (dry[i])
            B = fmax(B, 0.5 * q1[i]);
        g->f.F[i] = -c * (B + 0.5 * q1[i]);
        g->f.kept[i] = c * 0.5 * q1[i];
    }
}

static double half_of(const test_grid *g)
{
    double sum = 0.5 * g->f.q[0];
    for (size_t i = 1; i < g->n / 2; i++)
        sum += g->f.q[i];
    return g->D * (sum + 0.5 * g->f.q[g->n / 2]);
}

/* Largest error of the oil of one half while there is a cavity; when it
 * closes. */
static double squeeze(size_t n, const double *oil, double *closes)
{
    enum { MAX = 401 };
    double q1[MAX], q2[MAX], dT = 1 / (double)(n - 1), error = 0;
    bool dry[MAX] = {false};
    test_grid g = rigid(n, 0, dT, 0, plates);
    g.weights.a[0] = g.weights.first[0] = 18 / dT;
    g.weights.time = -12 / dT;
    for (size_t i = 0; i < n; i++) {
        q1[i] = 1;
        q2[i] = gap_at(-dT);
        g.f.P[i] = 0.3;
    }
    *closes = NAN;
    for (size_t k = 1; k < n; k++) {
        double t = (double)k * dT, h = gap_at(t);
        size_t holes = 0;
        remember(&g, dT, q1, q2, dry);
        for (size_t i = 0; i < n; i++) {
            g.f.full[i] = g.f.H[i] = h;
            g.f.eps[i] = h * h * h;
        }
        g.f.q[0] = g.f.q[n - 1] = h;
        solve(&g, 0.3, 0.3);
        for (size_t i = 0; i < n; i++) {
            q2[i] = q1[i];
            q1[i] = i + 1 < n ? g.f.q[i] : h;
            dry[i] = !(g.f.P[i] > 0);
            holes += dry[i];
        }
        if (holes)
            error = fmax(error, fabs(half_of(&g) - oil[k * FINE / (n - 1)]));
        else if (t > 0.3 && isnan(*closes))
            *closes = t;
    }
    ovr_arena_release(&g.arena);
    return error;
}

TEST(squeezed_plates)
{
    static double oil[FINE + 1];
    double close = oil_of_half(oil), error[3], closes;
    CHECK_NEAR(close, 0.70592, 2e-4);
    for (int k = 0; k < 3; k++) {
        size_t n = ((size_t)100 << k) + 1;
        error[k] = squeeze(n, oil, &closes);
        CHECK_NEAR(closes, close, 1.5 / (double)(n - 1));
    }
    second_order(error, 3, "oil of a half");
}
