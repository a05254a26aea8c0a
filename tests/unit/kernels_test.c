/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kernels of every instruction set against plain formulas and against
 * each other: they agree to rounding.  The film kernel is in film_test.c, the
 * dense solver in dense_test.c. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "multigrid/deformation.h"
#include "multigrid/field.h"
#include "multigrid/kernels.h"
#include "support/contact.h"
#include "support/test.h"

enum { N = 449, FIELDS = 9 };

static const char *const names[] = {"base", "avx2", "avx512"};
enum { NAMES = sizeof names / sizeof *names };

/* Fields in the order of the nodes, and the same in the lanes of a set. */
typedef struct bench {
    ovr_arena arena;
    ovr_fluid fluid;
    const ovr_kernels *run;
    ovr_lanes g;
    ovr_fields f, v;
    ovr_band band, vband;
    ovr_weights w;
    ovr_mlmi mlmi;
    double *deformation, *gap, *vw, *vgap, k[6];
} bench;

static double *take(bench *b)
{
    ovr_error err = {0};
    double *field = ovr_mlmi_field(&b->mlmi, &b->arena, &err);
    assert_non_null(field);
    return field;
}

static ovr_fields take_fields(bench *b)
{
    double *a[FIELDS];
    for (int k = 0; k < FIELDS; k++)
        a[k] = take(b);
    return (ovr_fields){a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]};
}

static ovr_band take_band(bench *b)
{
    double *a[7];
    for (int k = 0; k < 7; k++)
        a[k] = take(b);
    return (ovr_band){
        .b = {a[0], a[1], a[2], a[3], a[4]}, .delta = a[5], .moves = a[6]};
}

static void use(bench *b, const ovr_kernels *run)
{
    b->run = run;
    b->g = (ovr_lanes){b->mlmi.n, ovr_mlmi_lane(&b->mlmi, run->lanes),
                       run->lanes};
}

static bench make_of(const ovr_kernels *run, double M, double L, size_t n)
{
    ovr_error err;
    test_contact contact = test_contact_make(M, L);
    double D = 5.5 / (double)(n - 1);
    bench b = {.arena = ovr_arena_make(NULL)};
    CHECK_OK(ovr_mlmi_plan(&b.mlmi, n, D, 10, 10, NULL, &b.arena, &err), &err);
    b.f = take_fields(&b), b.v = take_fields(&b);
    b.band = take_band(&b), b.vband = take_band(&b);
    b.deformation = take(&b), b.vw = take(&b);
    b.gap = take(&b), b.vgap = take(&b);
    b.fluid = (ovr_fluid){contact.lubricant, contact.contact.lambda};
    b.w = (ovr_weights){1.5 / D + 2, -2 / D, 0.5 / D,
                        1 / D + 2,   -1 / D, 0.5 / (D * D)};
    for (int d = 0; d < 6; d++)
        b.k[d] = ovr_deformation_kernel(d, D);
    use(&b, run);
    return b;
}

static bench make(const ovr_kernels *run, double M, double L)
{
    return make_of(run, M, L, N);
}

static void pack(const bench *b, const double *from, double *to)
{
    b->run->pack(&b->g, from, to);
}

static void unpack(const bench *b, const double *from, double *to)
{
    b->run->unpack(&b->g, from, to);
}

/* A pressure with a wet part, a dry end and a small disturbance. */
static void fill(bench *b, uint64_t seed)
{
    size_t n = b->g.n;
    for (size_t i = 0; i < n; i++) {
        double X = -4 + 5.5 * (double)i / (double)(n - 1);
        double P = X * X < 1 ? sqrt(1 - X * X) : X < 0 ? 0.01 / (X * X) : 0;
        b->f.P[i] = P > 0 ? P * test_random(&seed, 0.99, 1.01) : 0;
        b->gap[i] = b->f.H[i] = 0.08 + (X * X > 1 ? 0.4 * (fabs(X) - 1) : 0) +
                                test_random(&seed, 0, 0.001);
        b->f.F[i] = test_random(&seed, -1, 1);
    }
    b->f.P[0] = b->f.P[n - 1] = 0;
    pack(b, b->f.P, b->v.P);
    pack(b, b->f.F, b->v.F);
    pack(b, b->f.H, b->v.H);
    pack(b, b->gap, b->vgap);
}

/* Properties for the film that it has, without deformation. */
static void film(const bench *b)
{
    const double *const from[] = {b->v.H,   b->v.rho,  b->v.dq,
                                  b->v.eps, b->v.deps, b->v.q};
    double *const to[] = {b->f.H,   b->f.rho,  b->f.dq,
                          b->f.eps, b->f.deps, b->f.q};
    b->run->film(&b->fluid, 0, &b->g, b->vgap, b->vw, &b->v);
    for (int k = 0; k < 6; k++)
        unpack(b, from[k], to[k]);
}

static void residual(const bench *b)
{
    b->run->residual(&b->g, &b->w, &b->v);
    unpack(b, b->v.r, b->f.r);
}

static void unpack_band(const bench *b)
{
    for (int d = 0; d < 5; d++)
        unpack(b, b->vband.b[d], b->band.b[d]);
    unpack(b, b->vband.delta, b->band.delta);
    unpack(b, b->vband.moves, b->band.moves);
}

/* Every node where lanes.h says, what the neighbours hold in the halos, and
 * back again; lanes that divide the grid or do not. */
static void lanes_hold_the_nodes(void **state)
{
    static const size_t nodes[] = {15, 29, 57, 113, 449};
    (void)state;
    for (int k = 0; k < NAMES; k++)
        for (size_t m = 0; ovr_kernels_choose(names[k]) && m < 5; m++) {
            bench b = make_of(ovr_kernels_choose(names[k]), 20, 10, nodes[m]);
            size_t S = b.g.S, V = b.g.V, n = b.g.n;
            for (size_t i = 0; i < n; i++)
                b.f.F[i] = 1 + (double)i;
            pack(&b, b.f.F, b.v.F);
            for (size_t i = 0; i + 1 < n; i++)
                assert_true(b.v.F[i % S * V + i / S] == 1 + (double)i);
            assert_true(b.v.F[ovr_lanes_place(&b.g, n - 1)] == (double)n);
            for (size_t i = S; i + 1 < n; i += S) {
                assert_true((b.v.F - V)[i / S] == (double)i);
                assert_true((b.v.F - 2 * V)[i / S] == (double)i - 1);
                assert_true((b.v.F + S * V)[i / S - 1] == 1 + (double)i);
            }
            unpack(&b, b.v.F, b.f.r);
            assert_memory_equal(b.f.F, b.f.r, n * sizeof(double));
            ovr_arena_release(&b.arena);
        }
}

static void residual_is_the_equation(void **state)
{
    (void)state;
    for (int k = 0; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        if (!run)
            continue;
        bench b = make(run, 20, 10);
        const ovr_fields *f = &b.f;
        fill(&b, 9);
        film(&b);
        residual(&b);
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

/* R of reynolds.h, node by node. */
static void imbalance_is_as_defined(void **state)
{
    (void)state;
    for (int k = 0; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        double sum = 0;
        if (!run)
            continue;
        bench b = make(run, 20, 10);
        fill(&b, 9);
        film(&b);
        residual(&b);
        for (size_t i = 1; i < N - 1; i++) {
            const double *e = b.f.eps + i;
            double d = b.w.half * (e[-1] + 2 * e[0] + e[1]), r = b.f.r[i];
            sum += r < 0 ? -r : fmin(r, b.f.P[i] * d);
        }
        CHECK_CLOSE(run->imbalance(&b.g, &b.w, &b.v), sum, 1e-12);
        ovr_arena_release(&b.arena);
    }
}

/* dN_i/dP_{i+d} of line.h, and the size of its terms. */
static double jacobian(const bench *b, size_t i, int d, double *size)
{
    const ovr_fields *f = &b->f;
    const double *P = f->P + i, *eps = f->eps + i, *deps = f->deps + i;
    bool first = i == 1;
    const double a[3] = {first ? b->w.a0_first : b->w.a0,
                         first ? b->w.a1_first : b->w.a1, first ? 0 : b->w.a2};
    double sum = 0;
    for (int m = 0; m < 3 && a[m] != 0; m++) {
        double elastic = a[m] * f->rho[i - (size_t)m] * b->k[abs(d + m)];
        double local = d == -m ? -a[m] * f->dq[i - (size_t)m] : 0;
        sum += elastic + local;
        *size += fabs(elastic) + fabs(local);
    }
    double flow = d == -1  ? eps[-1] + eps[0] + deps[-1] * (P[-1] - P[0])
                  : d == 0 ? deps[0] * (P[-1] - 2 * P[0] + P[1]) - eps[-1] -
                                 2 * eps[0] - eps[1]
                  : d == 1 ? eps[0] + eps[1] + deps[1] * (P[1] - P[0])
                           : 0;
    *size += fabs(b->w.half * flow) + 4 * b->w.half * fabs(eps[0]);
    return sum + b->w.half * flow;
}

/* A share of what changes at node j; node 1 and, when steady, a dry node give
 * nothing away. */
static double share(const bench *b, double value, bool transient, size_t j)
{
    bool gives = j > 1 && j < N - 1 && (transient || b->f.P[j] > 0);
    return gives ? value : 0;
}

/* Row i of the line relaxation, and what becomes of P_i. */
static void check_row(const bench *b, const ovr_shares *s, size_t i)
{
    double size = 1, r = b->f.r[i], diagonal = jacobian(b, i, 0, &size);
    bool held = b->f.P[i] <= 0 && r >= OVR_DRY_TOLERANCE * diagonal;
    CHECK_NEAR(b->band.delta[i], held ? 0 : r, 0);
    for (int d = -2; d <= 2; d++) {
        size_t j = i + (size_t)(d + 2) - 2;
        if (i + (size_t)(d + 2) < 3 || j >= N - 1)
            continue; /* delta is zero there */
        double minus = share(b, s->minus, s->transient, j);
        double plus = share(b, s->plus, s->transient, j), row;
        if (held)
            row = d == 0          ? 1
                  : !s->transient ? 0
                  : d == -1       ? plus
                  : d == 1        ? minus
                                  : 0;
        else
            row = jacobian(b, i, d, &size) +
                  minus * jacobian(b, i, d - 1, &size) +
                  plus * jacobian(b, i, d + 1, &size);
        CHECK_NEAR(b->band.b[d + 2][i], row, 1e-14 * size);
    }
}

static void check_change(const bench *b, const ovr_shares *s, double limit,
                         const double *P, size_t i)
{
    const double *delta = b->band.delta;
    double change = delta[i] +
                    share(b, s->minus, s->transient, i + 1) * delta[i + 1] +
                    share(b, s->plus, s->transient, i - 1) * delta[i - 1];
    double moves = b->band.moves[i];
    change = fmax(-limit, fmin(limit, change));
    CHECK_NEAR(P[i], moves * fmax(0, b->f.P[i] + change), 1e-15);
    if (!s->transient || b->f.P[i] > 0)
        assert_true(moves == 1);
}

/* The rows of the system and the use of its solution, as line.h has them. */
static void line_is_as_defined(void **state)
{
    static const ovr_shares shares[] = {
        {-1, 0, false}, {-0.7, -0.3, true}, {-0.5, -0.5, true}};
    static double P[N];
    (void)state;
    for (int k = 0; k < 3 * NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k / 3]);
        const ovr_shares *s = &shares[k % 3];
        if (!run)
            continue;
        bench b = make(run, 20, 10);
        fill(&b, 10);
        film(&b);
        residual(&b);
        run->band_assemble(&b.g, &b.w, b.k, s, &b.v, &b.vband);
        unpack_band(&b);
        for (size_t i = 1; i < N - 1; i++)
            check_row(&b, s, i);
        run->band_solve(&b.g, &b.vband);
        unpack_band(&b);
        run->distribute(&b.g, 0.05, s, &b.vband, b.v.P);
        unpack(&b, b.v.P, P);
        for (size_t i = 1; i < N - 1; i++)
            check_change(&b, s, 0.05, P, i);
        assert_true(P[0] == 0 && P[N - 1] == 0);
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
        const ovr_shares shares = {-0.7, -0.3, true};
        if (!run)
            continue;
        bench b = make(run, 20, 10);
        fill(&b, 10);
        film(&b);
        residual(&b);
        run->band_assemble(&b.g, &b.w, b.k, &shares, &b.v, &b.vband);
        unpack_band(&b);
        for (int d = 0; d < 5; d++)
            memcpy(row[d], b.band.b[d], sizeof row[d]);
        memcpy(rhs, b.band.delta, sizeof rhs);
        run->band_solve(&b.g, &b.vband);
        unpack_band(&b);
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

/* On a grid so fine that the rows where lanes meet are solved once more. */
static void band_solver_solves_long_lanes(void **state)
{
    const size_t n = ((size_t)7 << 15) + 1;
    uint64_t seed = 14;
    (void)state;
    for (int k = 0; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        if (!run)
            continue;
        bench w = make_of(run, 20, 10, n);
        double *row[5] = {w.f.P, w.f.H, w.f.rho, w.f.dq, w.f.eps};
        double *rhs = w.f.F, *x = w.f.r;
        for (size_t i = 0; i < n; i++) {
            bool end = i == 0 || i == n - 1;
            for (int d = 0; d < 5; d++)
                row[d][i] = end      ? d == 2
                            : d == 2 ? 4
                                     : test_random(&seed, -1, 1);
            rhs[i] = end ? 0 : test_random(&seed, -1, 1);
        }
        for (int d = 0; d < 5; d++)
            pack(&w, row[d], w.vband.b[d]);
        pack(&w, rhs, w.vband.delta);
        run->band_solve(&w.g, &w.vband);
        unpack(&w, w.vband.delta, x);
        for (size_t i = 2; i + 2 < n; i++) {
            double sum = 0;
            for (size_t d = 0; d < 5; d++)
                sum += row[d][i] * x[i + d - 2];
            CHECK_NEAR(sum, rhs[i], 1e-14);
        }
        ovr_arena_release(&w.arena);
    }
}

/* The definitions of fas.h, node by node. */
static void transfer_as_defined(const ovr_kernels *run, size_t n)
{
    bench b = make_of(run, 20, 10, n), c = make_of(run, 20, 10, n / 2 + 1);
    size_t nc = n / 2 + 1;
    double *P = b.f.q, *Pc = c.f.P, *entry = c.f.q, *rc = c.f.r, *Hc = c.f.H;
    fill(&b, 13);
    memcpy(b.f.r, b.f.F, n * sizeof(double));
    b.f.r[0] = b.f.r[n - 1] = 0;
    pack(&b, b.f.r, b.v.r);
    run->restrict_fields(&c.g, &b.g, b.v.P, b.v.H, b.v.r, c.v.P, c.v.q, c.v.H,
                         c.v.r);
    unpack(&c, c.v.P, Pc), unpack(&c, c.v.q, entry);
    unpack(&c, c.v.H, Hc), unpack(&c, c.v.r, rc);
    for (size_t I = 1; I + 1 < nc; I++) {
        const double *p = b.f.P + 2 * I, *r = b.f.r + 2 * I;
        bool wet = p[-1] > 0 && p[0] > 0 && p[1] > 0;
        double sum = 2 * r[0] + (p[-1] > 0 ? r[-1] : 0) + (p[1] > 0 ? r[1] : 0);
        CHECK_NEAR(Pc[I], wet ? (p[-1] + 2 * p[0] + p[1]) / 4 : p[0], 1e-15);
        CHECK_NEAR(rc[I], p[0] > 0 ? sum / 4 : 0, 1e-15);
        assert_true(entry[I] == Pc[I] && Hc[I] == b.f.H[2 * I]);
        Pc[I] += 0.01 * sin((double)I);
    }
    assert_true(Pc[0] == 0 && Pc[nc - 1] == 0 && rc[0] == 0);
    assert_true(Hc[0] == b.f.H[0] && Hc[nc - 1] == b.f.H[n - 1]);
    pack(&c, Pc, c.v.P);
    run->correct(&c.g, &b.g, 0.5, c.v.P, c.v.q, b.v.P);
    unpack(&b, b.v.P, P);
    for (size_t i = 1; i + 1 < n; i++) {
        size_t I = i / 2, J = (i + 1) / 2;
        double change = 0.25 * (Pc[I] - entry[I] + Pc[J] - entry[J]);
        double p = b.f.P[i] > 0 ? fmax(b.f.P[i] + change, 0) : 0;
        CHECK_NEAR(P[i], p, 1e-15);
    }
    ovr_arena_release(&b.arena);
    ovr_arena_release(&c.arena);
}

static void transfers_are_as_defined(void **state)
{
    static const size_t nodes[] = {29, 57, 113, N};
    (void)state;
    for (int k = 0; k < NAMES; k++)
        for (size_t m = 0; ovr_kernels_choose(names[k]) && m < 4; m++)
            transfer_as_defined(ovr_kernels_choose(names[k]), nodes[m]);
}

/* A sweep: what comes out of every kernel, in the order of the nodes. */
static double sweep(bench *b)
{
    const ovr_shares shares = {-1, 0, false};
    fill(b, 11);
    b->run->deformation(&b->mlmi, b->v.P, b->vw);
    unpack(b, b->vw, b->deformation);
    memset(b->f.q, 0, N * sizeof(double));
    pack(b, b->f.q, b->vw);
    film(b);
    residual(b);
    double imbalance = b->run->imbalance(&b->g, &b->w, &b->v);
    b->run->band_assemble(&b->g, &b->w, b->k, &shares, &b->v, &b->vband);
    b->run->band_solve(&b->g, &b->vband);
    b->run->distribute(&b->g, 0.1, &shares, &b->vband, b->v.P);
    unpack(b, b->v.P, b->f.P);
    return imbalance;
}

/* Plain loops, AVX2 and AVX-512 differ by rounding only. */
static void instruction_sets_agree(void **state)
{
    bench first = make(ovr_kernels_choose("base"), 20, 10);
    double imbalance = sweep(&first);
    (void)state;
    for (int k = 1; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        if (!run)
            continue;
        bench b = make(run, 20, 10);
        CHECK_CLOSE(sweep(&b), imbalance, 1e-12);
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
        cmocka_unit_test(lanes_hold_the_nodes),
        cmocka_unit_test(residual_is_the_equation),
        cmocka_unit_test(imbalance_is_as_defined),
        cmocka_unit_test(line_is_as_defined),
        cmocka_unit_test(band_solver_solves_the_band),
        cmocka_unit_test(band_solver_solves_long_lanes),
        cmocka_unit_test(transfers_are_as_defined),
        cmocka_unit_test(instruction_sets_agree),
        cmocka_unit_test(unknown_set_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
