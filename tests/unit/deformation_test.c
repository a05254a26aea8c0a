/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Multilevel multi-integration against the direct sum and by identities. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "multigrid/deformation.h"
#include "multigrid/field.h"
#include "support/deformation.h"
#include "support/test.h"

typedef struct bench {
    ovr_arena arena;
    test_deformation plan;
    size_t n;
    double D, *P, *w, *direct;
} bench;

/* For the named kernels, NULL: the best. */
static bench make_on(const char *kernels, size_t n, double D, int order,
                     int range)
{
    ovr_error err;
    bench b = {.n = n, .D = D, .arena = ovr_arena_make(NULL)};
    b.plan = test_deformation_plan(kernels, n, D, order, range, &b.arena);
    b.P = ovr_field(&b.arena, n, &err);
    b.w = ovr_field(&b.arena, n, &err);
    b.direct = ovr_field(&b.arena, n, &err);
    return b;
}

static bench make(size_t n, double D, int order, int range)
{
    return make_on(NULL, n, D, order, range);
}

static void apply(bench *b)
{
    test_deform(&b->plan, b->P, b->w);
}

/* max |w - direct| / max |direct| */
static double error_of(bench *b)
{
    double worst = 0, size = 0;
    apply(b);
    test_deform_directly(b->n, b->D, b->P, b->direct);
    for (size_t i = 0; i < b->n; i++) {
        worst = fmax(worst, fabs(b->w[i] - b->direct[i]));
        size = fmax(size, fabs(b->direct[i]));
    }
    return worst / size;
}

static void randomize(bench *b, uint64_t *seed)
{
    for (size_t i = 0; i < b->n; i++)
        b->P[i] = test_random(seed, 0, 1);
}

TEST(agrees_with_direct_sum)
{
    static const struct {
        int order, range;
        double error;
    } table[] = {{6, 10, 8e-7},   {6, 16, 6e-8},     {6, 24, 1e-8},
                 {8, 12, 1e-8},   {10, 10, 1e-8},    {10, 12, 2e-9},
                 {10, 16, 1e-10}, {12, 16, 1.5e-11}, {12, 24, 1e-12}};
    uint64_t seed = 1;
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        for (int trial = 0; trial < 4; trial++) {
            size_t n = 100 + (size_t)test_random(&seed, 0, 1900);
            bench b = make_on(trial < 3 ? NULL : "plain", n,
                              5.5 / (double)(n - 1), table[k].order,
                              table[k].range);
            randomize(&b, &seed);
            CHECK_NEAR(error_of(&b), 0, table[k].error);
            ovr_arena_release(&b.arena);
        }
}

/* A rougher plan must be worse: the bounds above are not vacuous. */
TEST(error_falls_with_order_and_range)
{
    uint64_t seed = 2;
    double error[3];
    const int order[] = {4, 6, 10}, range[] = {8, 16, 16};
    for (int k = 0; k < 3; k++) {
        bench b = make(1793, 5.5 / 1792, order[k], range[k]);
        randomize(&b, &seed);
        error[k] = error_of(&b);
        ovr_arena_release(&b.arena);
    }
    assert_true(error[0] > 10 * error[1]);
    assert_true(error[1] > 10 * error[2]);
    assert_true(error[2] > 0);
}

TEST(is_linear)
{
    uint64_t seed = 3;
    bench b = make(1793, 5.5 / 1792, 10, 16);
    double *first = malloc(b.n * sizeof *first);
    double *second = malloc(b.n * sizeof *second);
    double *kept = malloc(b.n * sizeof *kept);
    randomize(&b, &seed);
    memcpy(kept, b.P, b.n * sizeof *kept);
    apply(&b);
    memcpy(first, b.w, b.n * sizeof *first);
    randomize(&b, &seed);
    apply(&b);
    memcpy(second, b.w, b.n * sizeof *second);
    for (size_t i = 0; i < b.n; i++)
        b.P[i] = 2 * kept[i] - 3 * b.P[i];
    apply(&b);
    for (size_t i = 0; i < b.n; i++)
        CHECK_NEAR(b.w[i], 2 * first[i] - 3 * second[i], 1e-13);
    free(first);
    free(second);
    free(kept);
    ovr_arena_release(&b.arena);
}

TEST(impulse_gives_the_kernel)
{
    bench b = make(897, 5.5 / 896, 12, 24);
    const size_t at[] = {0, 1, 2, 447, 448, 895, 896};
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        memset(b.P, 0, b.n * sizeof *b.P);
        b.P[at[k]] = 1;
        apply(&b);
        for (size_t i = 0; i < b.n; i++)
            CHECK_NEAR(b.w[i],
                       ovr_deformation_kernel((double)i - (double)at[k], b.D),
                       1e-12);
    }
    ovr_arena_release(&b.arena);
}

/* A mirrored pressure gives the mirrored deformation, to the method's error:
 * on a coarse grid of even n even and odd nodes trade places. */
TEST(is_symmetric)
{
    uint64_t seed = 4;
    bench b = make(1793, 5.5 / 1792, 10, 16),
          m = make(1793, 5.5 / 1792, 10, 16);
    randomize(&b, &seed);
    for (size_t i = 0; i < b.n; i++)
        m.P[i] = b.P[b.n - 1 - i];
    apply(&b);
    apply(&m);
    for (size_t i = 0; i < b.n; i++)
        CHECK_NEAR(b.w[i], m.w[b.n - 1 - i], 2e-8);
    ovr_arena_release(&b.arena);
    ovr_arena_release(&m.arena);
}

/* The kernel integrates ln|x| over a mesh: far away it is D ln(dD). */
TEST(kernel_is_the_integral)
{
    const double D = 1e-3, pi = acos(-1);
    CHECK_CLOSE(ovr_deformation_kernel(0, D), D * (log(D / 2) - 1) / pi, 1e-15);
    for (double d = 40; d < 1e7; d *= 1.7) {
        double h = 0.25 / (d * d);
        CHECK_CLOSE(ovr_deformation_kernel(d, D),
                    D * (log(d * D) - h / 6 - h * h / 20) / pi, 1e-11);
        CHECK_CLOSE(ovr_deformation_kernel(-d, D), ovr_deformation_kernel(d, D),
                    1e-15);
    }
}

/* Hertz: P = sqrt(1 - X^2) makes X^2/2 + (its deformation) flat inside the
 * contact, H0 = -(1/2 ln 2 + 1/4).  The pressure's ends are square roots
 * anywhere between two nodes: the error is below 0.15 D^1.5. */
TEST(flattens_the_hertzian_contact)
{
    for (int level = 6; level < 12; level++) {
        size_t n = ((size_t)7 << level) + 1;
        double error = 0;
        bench b = make(n, 5.5 / (double)(n - 1), 10, 24);
        for (size_t i = 0; i < n; i++) {
            double X = -4 + (double)i * b.D;
            b.P[i] = X * X < 1 ? sqrt(1 - X * X) : 0;
        }
        apply(&b);
        for (size_t i = 0; i < n; i++) {
            double X = -4 + (double)i * b.D;
            if (fabs(X) < 0.9)
                error = fmax(error,
                             fabs(0.5 * X * X - b.w[i] - 0.5 * log(2) - 0.25));
        }
        CHECK_NEAR(error, 0, 0.15 * pow(b.D, 1.5));
        ovr_arena_release(&b.arena);
    }
}

/* The table holds what the fit gives, whatever is chosen (a machine's long
 * double may be longer). */
TEST(table_is_the_fit)
{
    for (double target = 1e-6; target > 1e-11; target /= 2) {
        double table[OVR_MLMI_MAX], fit[OVR_MLMI_MAX];
        ovr_mlmi_form form = ovr_mlmi_choose(target);
        size_t half = (size_t)form.order / 2, range = (size_t)form.range;
        ovr_mlmi_weights(half, range, table);
        ovr_mlmi_fit_weights(half, range, fit);
        for (size_t k = 0; k < half; k++)
            assert_true(fabs(table[k] - fit[k]) <= 1e-13);
    }
}
