/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shear stress and friction of a film: the vector kernels compared with the
 * plain one, and the plain one with direct sums. */
#include <math.h>

#include "contact/contact.h"
#include "support/kernels.h"
#include "support/test.h"

enum { MAX = 90 };

/* Films with cavitated nodes. */
typedef struct film {
    double X[MAX], P[MAX], H[MAX], q[MAX], eps[MAX], flow[MAX];
} film;

static ovr_sheared make(film *f, size_t n, uint64_t *seed)
{
    for (size_t i = 0; i < n; i++) {
        f->X[i] = (double)i + test_random(seed, 0, 0.5);
        f->P[i] = fmax(0, test_random(seed, -1, 2));
        f->H[i] = test_random(seed, 0.1, 1);
        f->q[i] = f->H[i] * test_random(seed, 1, 1.3);
        f->eps[i] = exp(test_random(seed, -20, 2));
        f->flow[i] = exp(test_random(seed, -20, 2));
    }
    return (ovr_sheared){n, f->X, f->P, f->H, f->q, f->eps, NULL};
}

static void compare(const ovr_kernels *run, const ovr_sheared *f,
                    const ovr_fluid *fluid)
{
    const ovr_kernels *plain = test_kernels(0);
    double t[MAX], expected[MAX], limit = 0.7;
    plain->mean_stress(f, fluid, expected);
    run->mean_stress(f, fluid, t);
    for (size_t i = 0; i + 1 < f->n; i++)
        CHECK_NEAR(t[i], expected[i], 1e-13 * (fabs(expected[i]) + 1));
    ovr_friction a = plain->friction(f, expected), b = run->friction(f, t);
    CHECK_NEAR(b.slide, a.slide, 1e-12 * (fabs(a.slide) + 1));
    CHECK_NEAR(b.roll, a.roll, 1e-12);
    CHECK_CLOSE(b.poiseuille, a.poiseuille, 1e-12);
    CHECK_CLOSE(run->limit_stress(f, limit, t),
                plain->limit_stress(f, limit, expected), 1e-12);
    for (size_t i = 0; i + 1 < f->n; i++)
        CHECK_NEAR(t[i], expected[i], 1e-13 * (fabs(expected[i]) + 1));
}

TEST(kernels_agree)
{
    const ovr_kernels *run;
    uint64_t seed = 7;
    ovr_flow_form form = ovr_flow_form_default();
    form.rheology = OVR_CARREAU;
    ovr_flow_law *law = ovr_flow_law_create(&form, NULL, NULL);
    assert_non_null(law);
    for (int k = 1; (run = test_kernels(k)); k++)
        for (size_t n = 13; n < MAX; n++) {
            film f;
            ovr_sheared sheared = make(&f, n, &seed);
            ovr_fluid fluid = {.sliding = test_random(&seed, -3, 3),
                               .by_gap = n % 2};
            compare(run, &sheared, &fluid);
            sheared.flow = f.flow;
            fluid.lubricant.rheology = OVR_EYRING;
            fluid.lubricant.Sigma0 = test_random(&seed, 0.1, 1);
            compare(run, &sheared, &fluid);
            fluid.lubricant.rheology = OVR_CARREAU;
            fluid.lubricant.flow_law = law;
            compare(run, &sheared, &fluid);
            fluid.sliding = 0;
            compare(run, &sheared, &fluid);
        }
    ovr_flow_law_free(law);
}

/* P = 1 - X^2 dry from 1 on, rho = 1.2, H = 0.5, eta = 1: t = -lambda V/(12 H)
 * over the wet part, int H P_X/2 = 0, int eps P_X^2/rho by midpoints. */
TEST(plain_by_hand)
{
    enum { N = 301 };
    static double X[N], P[N], H[N], q[N], eps[N], t[N];
    const ovr_sheared f = {N, X, P, H, q, eps, NULL};
    const double lambda = 0.03, D = 0.01, V = -0.7;
    const ovr_fluid fluid = {.sliding = V};
    double flow = 0.5 * 0.5 * 0.5 / lambda, wet = 2;
    for (int i = 0; i < N; i++) {
        X[i] = (i - 150) * D;
        P[i] = fmax(0, 1 - X[i] * X[i]);
        H[i] = 0.5;
        q[i] = 1.2 * H[i];
        eps[i] = 1.2 * flow;
    }
    const ovr_kernels *plain = test_kernels(0);
    plain->mean_stress(&f, &fluid, t);
    CHECK_CLOSE(t[100], lambda * 0.7 / 12 / 0.5, 1e-12);
    assert_true(t[0] == 0 && t[N - 2] == 0);
    ovr_friction sum = plain->friction(&f, t);
    CHECK_CLOSE(sum.slide, t[100] * wet, 1e-12);
    CHECK_NEAR(sum.roll, 0, 1e-14);
    CHECK_CLOSE(sum.poiseuille, flow * 8 / 3, 1e-4); /* D^2 */
}

/* A gap that closes from 1 to 1/50 between two nodes, the same fluid all
 * along: the mean of 1/H, ln 50/(1 - 1/50), within 6 %; between near films
 * exactly. */
TEST(slopes_slide_by_their_mean)
{
    const double V = 2, ends[] = {0.02, 0.999}, maximum[] = {0.06, 1e-9};
    const ovr_fluid fluid = {.sliding = V, .by_gap = true};
    for (int k = 0; k < 2; k++) {
        double G = ends[k], X[] = {0, 1}, P[] = {1, 1}, H[] = {1, G}, t;
        double q[] = {1, G}, eps[] = {1, G * G * G};
        const ovr_sheared f = {2, X, P, H, q, eps, NULL};
        test_kernels(0)->mean_stress(&f, &fluid, &t);
        CHECK_CLOSE(t, -V / 12 * log(G) / (G - 1), maximum[k]);
    }
}

/* Films that were not solved overlap: stresses are numbers all the same. */
TEST(overlapping_films_have_stresses)
{
    const ovr_kernels *run;
    uint64_t seed = 8;
    ovr_flow_form form = ovr_flow_form_default();
    form.rheology = OVR_CARREAU;
    ovr_flow_law *law = ovr_flow_law_create(&form, NULL, NULL);
    assert_non_null(law);
    for (int k = 0; (run = test_kernels(k)); k++)
        for (int kind = 0; kind < 2; kind++) {
            film f;
            double t[MAX];
            ovr_sheared sheared = make(&f, MAX, &seed);
            ovr_fluid fluid = {.sliding = 1, .by_gap = true};
            fluid.lubricant.rheology = kind ? OVR_CARREAU : OVR_EYRING;
            fluid.lubricant.flow_law = law;
            fluid.lubricant.Sigma0 = 0.3;
            for (int i = 0; i < MAX; i += 3) {
                f.H[i] = -f.H[i];
                f.q[i] = -f.q[i];
                f.eps[i] = -f.eps[i];
            }
            run->mean_stress(&sheared, &fluid, t);
            for (int i = 0; i + 1 < MAX; i++)
                assert_true(isfinite(t[i]));
        }
    ovr_flow_law_free(law);
}
