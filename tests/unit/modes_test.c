/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat along a surface: convected and diffused modes compared with the full
 * solution of moving sources, of a source that starts on a stationary surface,
 * and with themselves. */
#include <gsl/gsl_integration.h>
#include <math.h>
#include <string.h>

#include "multigrid/modes.h"
#include "physics/heat/solids.h"
#include "support/kernels.h"
#include "support/test.h"

static const double PI = 3.14159265358979323846;

/* ------------------------------------------------------------ the sources */

typedef enum form { ELLIPTIC, UNIFORM, SPIKE } form;

/* Largest temperatures by quadrature of Carslaw and Jaeger's solution, in q
 * b/k, of an independent program. */
static const struct truth {
    form shape;
    double Pe, T_max;
} truths[] = {
    {ELLIPTIC, 0.1, 2.1567452521363593}, {ELLIPTIC, 0.2, 1.8175389555810824},
    {ELLIPTIC, 0.5, 1.3861989852301668}, {ELLIPTIC, 1, 1.0858291932016795},
    {ELLIPTIC, 2, 0.8216391310373968},   {ELLIPTIC, 5, 0.5435116013624219},
    {ELLIPTIC, 10, 0.3888355523316297},  {ELLIPTIC, 20, 0.2758193935675056},
    {ELLIPTIC, 50, 0.17457784646522825}, {ELLIPTIC, 100, 0.12345774222604584},
    {UNIFORM, 0.1, 2.6268287220188102},  {UNIFORM, 0.2, 2.2003300726728896},
    {UNIFORM, 0.5, 1.666806334182795},   {UNIFORM, 1, 1.3041722551317068},
    {UNIFORM, 2, 0.9918504030512187},    {UNIFORM, 5, 0.6668827680915405},
    {UNIFORM, 10, 0.4846402469076371},   {UNIFORM, 20, 0.3484997291420237},
    {UNIFORM, 50, 0.22313716798636543},  {UNIFORM, 100, 0.1585611605694537},
    {SPIKE, 0.1, 2.4092209813382386},    {SPIKE, 0.2, 2.05879922494005},
    {SPIKE, 0.5, 1.621129611453372},     {SPIKE, 1, 1.3162801385556977},
    {SPIKE, 2, 1.0402810662378081},      {SPIKE, 5, 0.7299001977641353},
    {SPIKE, 10, 0.5430878575126115},     {SPIKE, 20, 0.39794706640485744},
    {SPIKE, 50, 0.25921179534310773},    {SPIKE, 100, 0.18527701781739342},
};

static double flux(form s, double X)
{
    double spike = exp(-(X - 0.6) * (X - 0.6) / (0.03 * 0.03));
    if (s == UNIFORM)
        return fabs(X) < 1 - 1e-9 ? 1 : fabs(X) < 1 + 1e-9 ? 0.5 : 0;
    return sqrt(fmax(0, 1 - X * X)) + (s == SPIKE ? 3 * spike : 0);
}

/* ----------------------------------------------------------- the surface */

enum { MAX = 1409 };

typedef struct surface {
    size_t n;
    double D, kappa, u, dT, X0;
    ovr_memory memory;
    ovr_departures departures;
    ovr_spread spread;
    double q[MAX], before[MAX], psi[MAX * OVR_MODES], T[MAX];
} surface;

/* From X0 to X1 in steps of dT, cold. */
static void make(surface *s, form shape, double kappa, double u, double X0,
                 double X1, double D, double dT)
{
    const ovr_heat numbers = {.diffusion = {kappa, kappa}};
    double longest = fmax(11 / fmax(fabs(u), 0.1),
                          ovr_solid_reach(&numbers, 0, u));
    *s = (surface){.n = (size_t)((X1 - X0) / D + 1.5),
                   .D = D,
                   .kappa = kappa,
                   .u = u,
                   .dT = dT,
                   .X0 = X0};
    for (size_t i = 0; i < s->n; i++)
        s->q[i] = flux(shape, X0 + (double)i * D);
    ovr_memory_rates(D / 8, longest, &s->memory);
    ovr_memory_fit(dT, longest, &s->memory);
    s->departures = ovr_departures_of(s->n, u * dT / D);
    if (ovr_solid_conducts(&numbers, 0, u))
        s->spread = ovr_spread_of(kappa, u, dT, D, s->memory.rate);
}

static void begin_steady(surface *s)
{
    ovr_modes_steady(s->n, s->D, s->kappa, s->u, s->memory.rate, s->q, s->psi);
}

/* T in q b/k, N = sqrt(kappa/pi) at um = 1, a step on; the largest. */
static double look(surface *s)
{
    static double workspace[MAX], fields[MAX * OVR_SWEPT];
    const ovr_modes_look l = {.run = ovr_kernels_choose(NULL),
                              .departures = &s->departures,
                              .spread = &s->spread,
                              .dT = s->dT,
                              .weight = s->memory.weight,
                              .psi = s->psi,
                              .q = s->q,
                              .workspace = workspace,
                              .fields = fields,
                              .past = s->T,
                              .before = s->before};
    double maximum = 0, N = sqrt(s->kappa / PI);
    ovr_modes_past(&l);
    for (size_t i = 0; i < s->n; i++) {
        s->T[i] = N * (s->T[i] + 4. / 3 * sqrt(s->dT) * s->q[i]);
        maximum = fmax(maximum, s->T[i]);
    }
    return maximum;
}

static ovr_modes_step step_of(const surface *s)
{
    return (ovr_modes_step){.departures = &s->departures,
                            .spread = &s->spread,
                            .fade = s->memory.fade,
                            .now = s->memory.now,
                            .before = s->memory.before,
                            .q = s->q,
                            .q_before = s->before};
}

static double step(surface *s)
{
    static double next[MAX * OVR_MODES];
    double T = look(s);
    const ovr_modes_step w = step_of(s);
    ovr_kernels_choose(NULL)->step_modes(&w, s->psi, next);
    memcpy(s->psi, next, s->n * OVR_MODES * sizeof *next);
    return T;
}

static double run(surface *s, double time)
{
    double T = 0;
    for (double t = 0; t < time; t += s->dT)
        T = step(s);
    return T;
}

/* -------------------------------------------------------------- the tests */

/* Steady as it begins, and as it is after having moved on for so long that all
 * has changed; a surface of Pe = 100 by the march of steps alone. */
TEST(moving_sources)
{
    static surface s;
    const double D = 1. / 128;
    for (size_t k = 0; k < sizeof truths / sizeof *truths; k++) {
        const struct truth *t = &truths[k];
        double begins, stays;
        make(&s, t->shape, 1 / t->Pe, 1, -4, 1.5, D, D);
        begin_steady(&s);
        begins = s.spread.on ? look(&s) : NAN;
        stays = run(&s, 12);
        print_message("shape %d, Pe %g: begins %+.1e, stays %+.1e\n", t->shape,
                      t->Pe, begins / t->T_max - 1, stays / t->T_max - 1);
        if (s.spread.on)
            CHECK_CLOSE(begins, t->T_max, 2e-3);
        CHECK_CLOSE(stays, t->T_max, t->Pe > 50 ? 1e-2 : 3e-3);
    }
}

/* T of a uniform source that begins at t = 0, at the middle of what is X = 0 in
 * the end: at the age t the material was at -u t. */
typedef struct place {
    double X, u, kappa;
} place;

static double seen(double root, void *data) /* dt/sqrt(t) = 2 d sqrt(t) */
{
    const place *p = data;
    double t = root * root, wide = sqrt(4 * p->kappa * t), at = p->X - p->u * t;
    if (wide < 1e-12)
        return 2;
    return erf((at + 1) / wide) - erf((at - 1) / wide);
}

static double exact(double X, double u, double kappa, double t)
{
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(2000);
    place p = {X, u, kappa};
    gsl_function f = {seen, &p};
    double value, error;
    gsl_integration_qag(&f, 0, sqrt(t), 1e-12, 1e-9, 2000, 6, w, &value,
                        &error);
    gsl_integration_workspace_free(w);
    return sqrt(kappa / PI) * value;
}

/* Below the Peclet number of 0.1, by the same quadrature over a long time. */
TEST(slower_sources)
{
    static surface s;
    const double D = 1. / 64;
    for (double Pe = 0.05; Pe < 0.1; Pe += 0.02)
        for (double u = 0.1; u < 2; u *= 10) {
            double T = 0;
            make(&s, UNIFORM, u / Pe, u, -4, 1.5, D, D);
            begin_steady(&s);
            for (double X = -0.5; X < 0.8; X += 0.05)
                T = fmax(T, exact(X, u, s.kappa, 200 * s.kappa / (u * u)));
            print_message("u %g, Pe %g: %+.1e\n", u, Pe, look(&s) / T - 1);
            CHECK_CLOSE(look(&s), T, 0.03);
        }
}

/* How far from the full solution T is, under the source and beside it, that
 * begins at T = 0. */
static double cold_start(double u, double kappa, double time)
{
    static surface s;
    static const double at[] = {-1.25, -0.5, 0.5};
    const double D = 1. / 64;
    const ovr_heat numbers = {.diffusion = {kappa, kappa}};
    double beyond = D * floor(ovr_solid_beyond(&numbers, 0, u, D) / D);
    double X0 = -4 - beyond, off = 0, T;
    make(&s, UNIFORM, kappa, u, X0, 1.5 + beyond, D, D);
    T = run(&s, time - D / 2); /* all of q from the first step on */
    for (int a = 0; a < 3; a++) {
        double here = s.T[(size_t)((at[a] - X0) / D + 0.5)];
        off = fmax(off, fabs(here - exact(at[a], u, kappa, time)));
    }
    print_message("u %g, kappa %g, after %g: %.1e of %.3f off\n", u, kappa,
                  time, off, T);
    return off / T;
}

/* If the state beyond the ends is assumed to have existed forever, heat
 * returns from there too warm where a surface is slow. */
TEST(cold_starts)
{
    static const struct slow {
        double u, kappa, off;
    } slow[] = {{-1, 0.1, 5e-4}, {-0.5, 0.1, 5e-4}, {0.5, 0.1, 5e-4},
                {1, 0.1, 5e-4},  {1.5, 0.1, 5e-4},  {1, 0.5, 5e-4},
                {-1, 0.5, 5e-4}, {0.5, 0.5, 1e-3},  {1, 1, 1e-3},
                {-0.6, 1, 5e-3}, {1, 2.5, 1.5e-2}};
    for (size_t k = 0; k < sizeof slow / sizeof *slow; k++)
        for (double t = 0.5; t < 40; t *= 4)
            assert_true(cold_start(slow[k].u, slow[k].kappa, t) < slow[k].off);
    assert_true(cold_start(0, 0.1, 8) < 5e-4);
}

/* A domain that ends where no heat is absorbed but the surface is still warm,
 * compared with a longer one. */
TEST(ends_are_not_felt)
{
    static surface wide, narrow;
    const double D = 1. / 64;
    for (double u = -1; u <= 1; u += 1)
        for (double kappa = 0.1; kappa < 2; kappa *= 3) {
            make(&wide, ELLIPTIC, kappa, u, -7, 1.5, D, D);
            make(&narrow, ELLIPTIC, kappa, u, -2.5, 1.5, D, D);
            begin_steady(&wide);
            begin_steady(&narrow);
            double off = 0, T = run(&wide, 6);
            run(&narrow, 6);
            for (size_t i = 0; i < narrow.n; i++)
                off = fmax(off,
                           fabs(narrow.T[i] - wide.T[i + wide.n - narrow.n]));
            print_message("u %g, kappa %g: %.1e off\n", u, kappa, off / T);
            assert_true(off < 1e-3 * T);
        }
}

/* The sweeps are the inverse of 1 + x + x^2/2, x = r (2 - E - 1/E). */
TEST(sweeps_invert)
{
    static surface s;
    static double v[MAX], w[MAX];
    make(&s, ELLIPTIC, 0.7, 1, -4, 1.5, 1. / 64, 1. / 50);
    double r = s.kappa * s.dT / (s.D * s.D);
    for (int k = 0; k < OVR_MODES; k++)
        s.memory.fade[k] = 1, s.memory.now[k] = s.memory.before[k] = 0;
    s.departures = ovr_departures_of(s.n, 0);
    for (size_t i = 0; i < s.n; i++)
        for (int m = 0; m < OVR_MODES; m++)
            s.psi[i * OVR_MODES + (size_t)m] = s.q[i];
    step(&s);
    for (size_t i = 0; i < s.n; i++)
        v[i] = s.psi[i * OVR_MODES + OVR_MODES - 1];
    for (size_t i = 1; i + 1 < s.n; i++)
        w[i] = r * (2 * v[i] - v[i - 1] - v[i + 1]);
    for (size_t i = 2; i + 2 < s.n; i++)
        CHECK_NEAR(v[i] + w[i] + r / 2 * (2 * w[i] - w[i - 1] - w[i + 1]),
                   s.q[i], 1e-9);
}

/* --------------------------------------------------------------- kernels */

TEST(kernels_agree)
{
    static surface s;
    static double plain[MAX * OVR_MODES], here[MAX * OVR_MODES];
    const ovr_kernels *by_nodes = test_kernels(0), *other;
    uint64_t seed = 3;
    for (double u = -3.3; u < 4; u += 1.1)
        for (int conducts = 0; conducts < 2; conducts++) {
            make(&s, SPIKE, conducts ? 0.4 : 0, u, -1, 1.5, 0.04, 0.05);
            for (size_t i = 0; i < s.n; i++) {
                s.q[i] = test_random(&seed, -1, 1);
                s.before[i] = test_random(&seed, -1, 1);
            }
            for (size_t i = 0; i < s.n * OVR_MODES; i++)
                s.psi[i] = test_random(&seed, -1, 1);
            const ovr_modes_step w = step_of(&s);
            assert_true(s.spread.on == (conducts == 1));
            for (int k = 1; (other = test_kernels(k)); k++) {
                by_nodes->step_modes(&w, s.psi, plain);
                other->step_modes(&w, s.psi, here);
                for (size_t i = 0; i < s.n * OVR_MODES; i++)
                    CHECK_NEAR(here[i], plain[i], 1e-12);
                by_nodes->sum_modes(s.n, s.memory.weight, s.psi, 2, s.q, plain);
                other->sum_modes(s.n, s.memory.weight, s.psi, 2, s.q, here);
                for (size_t i = 0; i < s.n; i++)
                    CHECK_NEAR(here[i], plain[i], 1e-11);
            }
        }
}

/* Any sweeps that are stable. */
TEST(sweeps_agree)
{
    enum { N = 61 };
    double start[N * OVR_SWEPT], plain[N * OVR_SWEPT], here[N * OVR_SWEPT];
    const ovr_kernels *by_nodes = test_kernels(0), *other;
    uint64_t seed = 4;
    ovr_swept set;
    for (int l = 0; l < OVR_SWEPT; l++) {
        double size = test_random(&seed, 0, 0.95);
        set.c[l] = test_random(&seed, 0, 1);
        set.b[0][l] = 2 * size * cos(test_random(&seed, 0, 1));
        set.b[1][l] = size * size;
        for (int k = 0; k < 2; k++) {
            set.begin[k][l] = test_random(&seed, -1, 1);
            set.after[k][l] = test_random(&seed, -1, 1);
            for (int j = 0; j < 2; j++)
                set.end[k][j][l] = test_random(&seed, -1, 1);
        }
    }
    for (int i = 0; i < N * OVR_SWEPT; i++)
        start[i] = test_random(&seed, -1, 1);
    for (int k = 1; (other = test_kernels(k)); k++) {
        memcpy(plain, start, sizeof start);
        memcpy(here, start, sizeof start);
        by_nodes->sweep_fields(N, &set, plain);
        other->sweep_fields(N, &set, here);
        for (int i = 0; i < N * OVR_SWEPT; i++)
            CHECK_NEAR(here[i], plain[i], 1e-9);
    }
}
