/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kernels of every instruction set against plain formulas and against
 * each other: they agree to rounding. */
#include <math.h>
#include <string.h>

#include "multigrid/deformation.h"
#include "multigrid/field.h"
#include "multigrid/kernels.h"
#include "support/contact.h"
#include "support/test.h"

enum { N = 449, FIELDS = 9 };

static const char *const names[] = {"base", "avx2", "avx512"};
enum { NAMES = sizeof names / sizeof *names };

typedef struct bench {
    ovr_arena arena;
    ovr_fluid fluid;
    ovr_fields f;
    ovr_band band;
    ovr_weights w;
    ovr_mlmi mlmi;
    double *deformation, *none, *gap, k[6];
} bench;

static bench make(double M, double L)
{
    ovr_error err;
    test_contact contact = test_contact_make(M, L);
    bench b = {.arena = ovr_arena_make(NULL)};
    double *a[FIELDS], *c[9], D = 5.5 / (N - 1);
    for (int k = 0; k < FIELDS; k++)
        a[k] = ovr_field(&b.arena, N, &err);
    for (int k = 0; k < 9; k++)
        c[k] = ovr_field(&b.arena, N + OVR_BAND_PAD, &err);
    b.deformation = ovr_field(&b.arena, N, &err);
    b.none = ovr_field(&b.arena, N, &err);
    b.gap = ovr_field(&b.arena, N, &err);
    b.f = (ovr_fields){a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]};
    b.band = (ovr_band){.b = {c[0], c[1], c[2], c[3], c[4]},
                        .delta = c[5],
                        .minus = c[6],
                        .plus = c[7],
                        .moves = c[8]};
    b.fluid = (ovr_fluid){contact.lubricant, contact.contact.lambda};
    b.w = (ovr_weights){1.5 / D + 2, -2 / D, 0.5 / D,
                        1 / D + 2,   -1 / D, 0.5 / (D * D)};
    for (int d = 0; d < 6; d++)
        b.k[d] = ovr_deformation_kernel(d, D);
    CHECK_OK(ovr_mlmi_plan(&b.mlmi, N, D, 10, 10, &b.arena, &err), &err);
    return b;
}

/* A pressure with a wet part, a dry end and a small disturbance. */
static void fill(bench *b, uint64_t seed)
{
    for (size_t i = 0; i < N; i++) {
        double X = -4 + 5.5 * (double)i / (N - 1);
        double P = X * X < 1 ? sqrt(1 - X * X) : X < 0 ? 0.01 / (X * X) : 0;
        b->f.P[i] = P > 0 ? P * test_random(&seed, 0.99, 1.01) : 0;
        b->gap[i] = b->f.H[i] = 0.08 + (X * X > 1 ? 0.4 * (fabs(X) - 1) : 0) +
                                test_random(&seed, 0, 0.001);
        b->f.F[i] = test_random(&seed, -1, 1);
    }
    b->f.P[0] = b->f.P[N - 1] = 0;
}

/* Properties for the film that it has. */
static void film(const ovr_kernels *run, const bench *b)
{
    run->film(&b->fluid, 0, N, b->gap, b->none, &b->f);
}

static void properties_match_the_laws(void **state)
{
    const double loads[][2] = {{20, 10}, {1000, 15}, {5, 1}};
    (void)state;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < NAMES; k++) {
            const ovr_kernels *run = ovr_kernels_choose(names[k]);
            bench b = make(loads[c][0], loads[c][1]);
            fill(&b, 7);
            if (run)
                film(run, &b);
            for (size_t i = 0; run && i < N; i++) {
                double P = b.f.P[i], H = b.f.H[i];
                double rho = ovr_density(&b.fluid.lubricant, P);
                double eta = ovr_viscosity(&b.fluid.lubricant, P);
                CHECK_CLOSE(b.f.rho[i], rho, 1e-15);
                CHECK_CLOSE(b.f.q[i], rho * H, 1e-15);
                /* the exponent of eta, up to 60, is exact to a few ulp */
                CHECK_CLOSE(b.f.eps[i],
                            rho * H * H * H / (eta * b.fluid.lambda),
                            1e-15 * (10 + 8 * fabs(log(eta))));
            }
            ovr_arena_release(&b.arena);
        }
}

static double eps_at(const bench *b, double P, double H)
{
    const ovr_lubricant *law = &b->fluid.lubricant;
    return ovr_density(law, P) * H * H * H /
           (ovr_viscosity(law, P) * b->fluid.lambda);
}

static void slopes_match_differences(void **state)
{
    const double h = 1e-5;
    bench b = make(20, 10);
    (void)state;
    fill(&b, 8);
    film(ovr_kernels_choose(NULL), &b);
    for (size_t i = 0; i < N; i++) {
        double P = b.f.P[i] + h, H = b.f.H[i];
        const ovr_lubricant *law = &b.fluid.lubricant;
        b.f.P[i] = P;
        double rho = (ovr_density(law, P + h) - ovr_density(law, P - h)) /
                     (2 * h);
        double eps = (eps_at(&b, P + h, H) - eps_at(&b, P - h, H)) / (2 * h);
        double dq = b.f.dq[i], deps = b.f.deps[i];
        /* second-order differences, and the shift of P by h */
        CHECK_NEAR(dq, rho * H, 1e-4 * (fabs(rho * H) + 1));
        CHECK_NEAR(deps, eps, 2e-3 * fabs(eps) + 1e-9);
    }
    ovr_arena_release(&b.arena);
}

static void residual_is_the_equation(void **state)
{
    (void)state;
    for (int k = 0; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        if (!run)
            continue;
        bench b = make(20, 10);
        const ovr_fields *f = &b.f;
        fill(&b, 9);
        film(run, &b);
        run->residual(N, &b.w, f);
        for (size_t i = 1; i < N - 1; i++) {
            double a0 = i > 1 ? b.w.a0 : b.w.a0_first;
            double a1 = i > 1 ? b.w.a1 : b.w.a1_first;
            double a2 = i > 1 ? b.w.a2 * f->q[i - 2] : 0;
            double flow = (f->eps[i - 1] + f->eps[i]) *
                              (f->P[i - 1] - f->P[i]) +
                          (f->eps[i] + f->eps[i + 1]) * (f->P[i + 1] - f->P[i]);
            double N_i = b.w.half * flow - a0 * f->q[i] - a1 * f->q[i - 1] - a2;
            CHECK_NEAR(f->r[i], f->F[i] - N_i, 1e-13 * (fabs(N_i) + 1));
        }
        assert_true(f->r[0] == 0 && f->r[N - 1] == 0);
        ovr_arena_release(&b.arena);
    }
}

/* The band solver against a dense elimination of the same rows. */
static void band_solver_solves_the_band(void **state)
{
    (void)state;
    for (int k = 0; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        static double row[5][N], rhs[N];
        if (!run)
            continue;
        bench b = make(20, 10);
        fill(&b, 10);
        film(run, &b);
        run->residual(N, &b.w, &b.f);
        run->band_assemble(N, &b.w, b.k, -0.7, -0.3, true, &b.f, &b.band);
        for (int d = 0; d < 5; d++)
            memcpy(row[d], b.band.b[d], sizeof row[d]);
        memcpy(rhs, b.band.delta, sizeof rhs);
        run->band_solve(N, &b.band);
        for (size_t i = 0; i < N; i++) {
            double sum = -rhs[i], size = fabs(rhs[i]);
            for (size_t d = 0; d < 5; d++)
                if (i + d >= 2 && i + d - 2 < N) {
                    double term = row[d][i] * b.band.delta[i + d - 2];
                    sum += term;
                    size += fabs(term);
                }
            CHECK_NEAR(sum, 0, 1e-12 * size + 1e-300);
        }
        ovr_arena_release(&b.arena);
    }
}

/* Elimination in panels against the matrix it was given, at every size about
 * that of a panel, with rows that need exchanging. */
static void dense_solver_solves(void **state)
{
    enum { MOST = 67, STRIDE = 80 };
    static double A[MOST * STRIDE], kept[MOST * STRIDE], x[MOST + 8];
    uint64_t seed = 12;
    (void)state;
    for (int k = 0; k < NAMES; k++)
        for (size_t m = 1; ovr_kernels_choose(names[k]) && m <= MOST; m++) {
            for (size_t i = 0; i < MOST * STRIDE; i++)
                A[i] = test_random(&seed, -1, 1);
            memcpy(kept, A, sizeof A);
            assert_true(
                ovr_kernels_choose(names[k])->dense_solve(m, STRIDE, A, x));
            for (size_t i = 0; i < m; i++) {
                const double *row = kept + i * STRIDE;
                double sum = -row[m], size = 1;
                for (size_t j = 0; j < m; j++) {
                    sum += row[j] * x[j];
                    size = fmax(size, fabs(x[j]));
                }
                CHECK_NEAR(sum, 0, 1e-12 * size);
            }
        }
    memset(A, 0, sizeof A);
    assert_false(ovr_kernels_choose(NULL)->dense_solve(5, STRIDE, A, x));
}

/* The definitions of fas.h, node by node. */
static void transfers_are_as_defined(void **state)
{
    enum { NC = N / 2 + 1 };
    static double Pc[NC], entry[NC], Hc[NC], rc[NC], P[N];
    (void)state;
    for (int k = 0; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        if (!run)
            continue;
        bench b = make(20, 10);
        fill(&b, 13);
        memcpy(b.f.r, b.f.F, N * sizeof(double));
        run->restrict_fields(NC, b.f.P, b.f.H, b.f.r, Pc, entry, Hc, rc);
        for (size_t I = 1; I + 1 < NC; I++) {
            const double *p = b.f.P + 2 * I, *r = b.f.r + 2 * I;
            bool wet = p[-1] > 0 && p[0] > 0 && p[1] > 0;
            double sum = 2 * r[0] + (p[-1] > 0 ? r[-1] : 0) +
                         (p[1] > 0 ? r[1] : 0);
            CHECK_NEAR(Pc[I], wet ? (p[-1] + 2 * p[0] + p[1]) / 4 : p[0],
                       1e-15);
            CHECK_NEAR(rc[I], p[0] > 0 ? sum / 4 : 0, 1e-15);
            assert_true(entry[I] == Pc[I] && Hc[I] == b.f.H[2 * I]);
            Pc[I] += 0.01 * sin((double)I);
        }
        memcpy(P, b.f.P, sizeof P);
        run->correct(NC, 0.5, Pc, entry, P);
        for (size_t i = 1; i + 1 < N; i++) {
            size_t I = i / 2, J = (i + 1) / 2;
            double change = 0.25 * (Pc[I] - entry[I] + Pc[J] - entry[J]);
            double p = b.f.P[i] > 0 ? fmax(b.f.P[i] + change, 0) : 0;
            CHECK_NEAR(P[i], p, 1e-15);
        }
        ovr_arena_release(&b.arena);
    }
}

static void run_all(const ovr_kernels *run, bench *b)
{
    fill(b, 11);
    run->deformation(&b->mlmi, b->f.P, b->deformation);
    film(run, b);
    run->residual(N, &b->w, &b->f);
    run->band_assemble(N, &b->w, b->k, -1, 0, false, &b->f, &b->band);
    run->band_solve(N, &b->band);
    run->distribute(N, 0.1, &b->band, b->f.P);
}

/* Plain loops, AVX2 and AVX-512 differ by rounding only. */
static void instruction_sets_agree(void **state)
{
    bench first = make(20, 10);
    double imbalance;
    (void)state;
    run_all(ovr_kernels_choose("base"), &first);
    imbalance = ovr_kernels_choose("base")->imbalance(N, &first.w, &first.f);
    for (int k = 1; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        if (!run)
            continue;
        bench b = make(20, 10);
        run_all(run, &b);
        CHECK_CLOSE(run->imbalance(N, &b.w, &b.f), imbalance, 1e-12);
        for (size_t i = 0; i < N; i++) {
            CHECK_NEAR(b.deformation[i], first.deformation[i], 1e-14);
            CHECK_NEAR(b.f.P[i], first.f.P[i], 1e-9);
            CHECK_CLOSE(b.f.eps[i], first.f.eps[i], 1e-14);
        }
        ovr_arena_release(&b.arena);
    }
    ovr_arena_release(&first.arena);
}

static void unknown_set_is_refused(void **state)
{
    (void)state;
    assert_null(ovr_kernels_choose("mmx"));
    assert_non_null(ovr_kernels_choose("base"));
    assert_non_null(ovr_kernels_choose(NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(properties_match_the_laws),
        cmocka_unit_test(slopes_match_differences),
        cmocka_unit_test(residual_is_the_equation),
        cmocka_unit_test(band_solver_solves_the_band),
        cmocka_unit_test(dense_solver_solves),
        cmocka_unit_test(transfers_are_as_defined),
        cmocka_unit_test(instruction_sets_agree),
        cmocka_unit_test(unknown_set_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
