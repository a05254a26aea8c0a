/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Film kernel, plain and for every instruction set, compared with its formulas
 * in extended precision, node by node, at any position in a vector. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/oil.h"
#include "multigrid/field.h"
#include "support/kernels.h"
#include "support/test.h"

enum { N = 1600, PAD = 4 * OVR_MAX_LANES };

typedef struct oil {
    ovr_arena arena;
    ovr_fluid fluid;
    ovr_fields f;
    double H0, *gap, *w;
} oil;

static oil make(void)
{
    ovr_error err = {0};
    oil o = {.arena = ovr_arena_make(NULL), .H0 = -0.1};
    for (int k = 0; k < OVR_FIELD_COUNT; k++) {
        o.f.all[k] = ovr_field(&o.arena, N + 2 * PAD, &err);
        assert_non_null(o.f.all[k]);
        o.f.all[k] += PAD;
    }
    o.gap = o.f.gap, o.w = o.f.w;
    return o;
}

/* An oil at 0.2 to 3 GPa, z up to `max_z`, and a film. */
static void fill(oil *o, uint64_t *seed, double max_z)
{
    double ph = test_random(seed, 0.2, 3);
    o->fluid = (ovr_fluid){{OVR_ROELANDS, OVR_DOWSON_HIGGINSON,
                            .alphabar = test_random(seed, 8, 30) * ph,
                            .z = test_random(seed, 0.2, max_z),
                            .P0 = 0.198 / ph, .A = 0.59 / ph},
                           .lambda = test_random(seed, 1e-3, 1)};
    for (int i = 0; i < N; i++) {
        double small = pow(10, test_random(seed, -9, 0));
        o->f.P[i] = test_random(seed, 0, 2.5) * (i % 2 ? small : 1);
        o->gap[i] = test_random(seed, 0.2, 2);
        o->w[i] = test_random(seed, -1, 0.05);
    }
}

/* false behind the last set of this machine */
static bool run(const oil *o, int set)
{
    const ovr_kernels *kernels = test_kernels(set);
    if (kernels) {
        ovr_lanes g = {N, N / kernels->lanes, kernels->lanes};
        kernels->film(&o->fluid, o->H0, &g, o->gap, o->w, &o->f);
    }
    return kernels != NULL;
}

/* The laws at one pressure; `rounding` is what an error of an ulp in the
 * variable part of ln eta grows to. */
typedef struct laws {
    long double rho, rho_slope, log_eta, eta_slope, rounding;
} laws;

static laws laws_at(const ovr_lubricant *law, long double P)
{
    long double A = law->A, P0 = law->P0, z = law->z, alphabar = law->alphabar;
    long double t = 1 + P / P0, stiffness = alphabar * P0 / z;
    laws at = {.rho = 1};
    if (law->density_law == OVR_DOWSON_HIGGINSON) {
        at.rho = 1 + 0.34L * P / (A + P);
        at.rho_slope = 0.34L * A / ((A + P) * (A + P));
    }
    if (law->viscosity_law == OVR_ROELANDS) {
        at.log_eta = stiffness * expm1l(z * log1pl(P / P0));
        at.eta_slope = alphabar * powl(t, z) / t;
        at.rounding = stiffness * powl(t, z);
    } else if (law->viscosity_law == OVR_BARUS) {
        at.log_eta = at.rounding = alphabar * P;
        at.eta_slope = alphabar;
    }
    return at;
}

static void check_node(const oil *o, int i)
{
    const ovr_fields *f = &o->f;
    double P = f->P[i], H = o->H0 + o->gap[i] - o->w[i];
    laws at = laws_at(&o->fluid.lubricant, P);
    long double h = H, lambda = o->fluid.lambda;
    long double flow = h * h * h / (expl(at.log_eta) * lambda);
    long double eps = at.rho * flow;
    double bound = 1e-15 * (5 + 1.2 * (double)at.rounding);
    double deps = (double)(flow * at.rho_slope - eps * at.eta_slope);
    double slopes = (double)(flow * at.rho_slope + eps * at.eta_slope);
    if (at.log_eta > 600) /* held there, see the last test */
        return;
    CHECK_CLOSE(f->H[i], H, 0);
    CHECK_CLOSE(f->rho[i], (double)at.rho, 4 * DBL_EPSILON);
    CHECK_CLOSE(f->q[i], (double)(at.rho * h), 5 * DBL_EPSILON);
    CHECK_CLOSE(f->dq[i], (double)(at.rho_slope * h), 8 * DBL_EPSILON);
    CHECK_CLOSE(f->eps[i], (double)eps, bound);
    CHECK_NEAR(f->deps[i], deps, bound * slopes);
    CHECK_CLOSE(f->deps_dH[i], (double)(3 * at.rho * flow / h), bound);
    /* the library's own laws, one value at a time */
    CHECK_CLOSE(f->rho[i], ovr_density(&o->fluid.lubricant, P), 1e-15);
    CHECK_CLOSE(f->eps[i] * ovr_viscosity(&o->fluid.lubricant, P),
                (double)(at.rho * h * h * h / lambda), 3 * bound);
}

TEST(film_follows_the_laws)
{
    static const ovr_viscosity_law viscosity[] = {OVR_ROELANDS, OVR_BARUS,
                                                  OVR_ISOVISCOUS};
    static const ovr_density_law density[] = {OVR_DOWSON_HIGGINSON,
                                              OVR_INCOMPRESSIBLE};
    oil o = make();
    uint64_t seed = 21;
    for (int turn = 0; turn < 60; turn++) {
        fill(&o, &seed, 1);
        o.fluid.lubricant.viscosity_law = viscosity[turn % 3];
        o.fluid.lubricant.density_law = density[turn / 3 % 2];
        for (int k = 0; run(&o, k); k++)
            for (int i = 0; i < N; i++)
                check_node(&o, i);
    }
    ovr_arena_release(&o.arena);
}

/* No pressure, or no effect of it: eta = 1 to the last bit. */
TEST(viscosity_starts_at_one)
{
    oil o = make();
    uint64_t seed = 22;
    for (int turn = 0; turn < 60; turn++) {
        fill(&o, &seed, 2);
        o.fluid.lambda = 1;
        for (int i = 0; i < N; i++)
            o.f.P[i] = turn % 2 ? o.f.P[i] : 0;
        if (turn % 2)
            o.fluid.lubricant.alphabar = turn % 4 == 1 ? 0 : 1e-300;
        for (int k = 0; run(&o, k); k++)
            for (int i = 0; i < N; i++) {
                double H2 = o.f.H[i] * o.f.H[i];
                assert_true(o.f.eps[i] == o.f.q[i] * H2);
                if (turn % 2)
                    CHECK_CLOSE(o.f.deps[i], o.f.dq[i] * H2, 1e-15);
            }
    }
    ovr_arena_release(&o.arena);
}

/* Pressures that no oil stands, as a solver may try them: finite numbers, and
 * never an oil that flows
 * more easily, down to where it is solid (the exponent is held). */
TEST(any_pressure_gives_finite_numbers)
{
    oil o = make();
    uint64_t seed = 23;
    for (int turn = 0; turn < 20; turn++) {
        fill(&o, &seed, 2);
        o.fluid.lubricant.viscosity_law = turn % 2 ? OVR_BARUS : OVR_ROELANDS;
        for (int i = 0; i < N; i++)
            o.f.P[i] = pow(10, 150.0 * i / N), o.gap[i] = 1, o.w[i] = 0;
        for (int k = 0; run(&o, k); k++)
            for (int i = 0; i < N; i++) {
                assert_true(o.f.eps[i] >= 0 && o.f.rho[i] < 1.3400001);
                assert_true(isfinite(o.f.deps[i]) && o.f.deps[i] <= 0);
                if (i > 0 && o.f.eps[i] > 1e-200)
                    assert_true(o.f.eps[i] <= o.f.eps[i - 1]);
            }
    }
    ovr_arena_release(&o.arena);
}

/* Laws in one stage, their film by every set against the plain one and the
 * library's value; slopes against differences. */
static void fill_direct(oil *o, uint64_t *seed, int turn, const double *points,
                        const ovr_law_table *const table[2])
{
    ovr_lubricant *law = &o->fluid.lubricant;
    fill(o, seed, 1);
    law->viscosity_law = (ovr_viscosity_law[]){
        OVR_DOOLITTLE, OVR_YASUTOMI, OVR_VISCOSITY_TABLE, OVR_ROELANDS,
        OVR_BARUS}[turn % 5];
    law->density_law = (ovr_density_law[]){OVR_TAIT, OVR_DENSITY_TABLE,
                                           OVR_DOWSON_HIGGINSON}[turn % 3];
    law->tait_K = test_random(seed, 0.8, 3);
    law->tait_K_slope = test_random(seed, 9, 12);
    law->doolittle_B = test_random(seed, 2, 5);
    law->doolittle_R0 = test_random(seed, 0.5, 0.7);
    law->yasutomi = (ovr_yasutomi){.C1 = 16,
                                   .C2 = 26,
                                   .Tg0 = 200,
                                   .T = test_random(seed, 300, 400),
                                   .A1 = 190,
                                   .A2 = test_random(seed, .2, .9),
                                   .b1 = 6,
                                   .b2 = -0.5};
    law->viscosity_table = table[0];
    law->density_table = table[1];
    law->table_ph = test_random(seed, 0.3e9, 1.5e9);
    for (int i = 0; i < N; i++) /* some beyond the tables' end */
        o->f.P[i] = fmin(o->f.P[i], points[1] * 1.2 / law->table_ph);
}

static double slope_of(double (*value)(const ovr_lubricant *, double),
                       const ovr_lubricant *lubricant, double P)
{
    double h = 1e-5;
    return (log(value(lubricant, P + h)) - log(value(lubricant, P - h))) /
           (2 * h);
}

static void check_direct(const oil *o, int i)
{
    const ovr_fields *f = &o->f;
    const ovr_lubricant *law = &o->fluid.lubricant;
    double P = f->P[i], H = f->H[i], lambda = o->fluid.lambda;
    double eta = ovr_viscosity(law, P), rho = ovr_density(law, P);
    double eps = rho * H * H * H / (eta * lambda), by_eta, by_rho;
    if (!(eta < 1e150) || P < 1e-4)
        return;
    by_eta = slope_of(ovr_viscosity, law, P);
    by_rho = slope_of(ovr_density, law, P);
    CHECK_CLOSE(f->rho[i], rho, 1e-13);
    CHECK_CLOSE(f->eps[i], eps, 1e-11);
    CHECK_NEAR(f->dq[i], f->q[i] * by_rho, 1e-5 * fabs(f->q[i]));
    /* a table's second derivative jumps at points */
    CHECK_NEAR(f->deps[i], eps * (by_rho - by_eta),
               (law->viscosity_law == OVR_VISCOSITY_TABLE ? 1e-3 : 1e-5) *
                   fabs(eps) * (1 + by_eta));
}

TEST(laws_in_one_stage)
{
    static const double p[] = {0, 2e9};
    static const double eta[] = {0.01, 1e6}, rho[] = {850, 1100};
    ovr_law_table *table[] = {
        ovr_law_table_create(
            &(ovr_law_points){OVR_TABLE_OF_VISCOSITY, 2, p, eta}, NULL, NULL),
        ovr_law_table_create(&(ovr_law_points){OVR_TABLE_OF_DENSITY, 2, p, rho},
                             NULL, NULL)};
    const ovr_law_table *tables[] = {table[0], table[1]};
    oil o = make();
    uint64_t seed = 24;
    for (int turn = 0; turn < 30; turn++) {
        fill_direct(&o, &seed, turn, p, tables);
        for (int k = 0; run(&o, k); k++)
            for (int i = 0; i < N; i += 3)
                check_direct(&o, i);
        for (int i = 0; i < N; i++)
            o.f.P[i] = pow(10, 150.0 * i / N), o.gap[i] = 1, o.w[i] = 0;
        for (int k = 0; run(&o, k); k++)
            for (int i = 0; i < N; i++)
                assert_true(o.f.eps[i] >= 0 && isfinite(o.f.deps[i]));
    }
    for (int k = 0; k < 2; k++)
        ovr_law_table_free(table[k]);
    ovr_arena_release(&o.arena);
}

/* With temperatures log2(1/eta) is th times the isothermal one, plus shift, and
 * its slope th times. */
TEST(temperatures_shift_the_logarithm)
{
    ovr_error err = {0};
    oil o = make();
    uint64_t seed = 25;
    double *th = ovr_field(&o.arena, N + 2 * PAD, &err);
    double *shift = ovr_field(&o.arena, N + 2 * PAD, &err);
    fill(&o, &seed, 1);
    o.fluid.lubricant.alphabar = 10;
    for (int i = -PAD; i < N + PAD; i++) {
        th[PAD + i] = test_random(&seed, 0.5, 1.1);
        shift[PAD + i] = test_random(&seed, 0, 30);
    }
    for (int k = 0; test_kernels(k); k++) {
        double eps[N], deps[N];
        o.f.th = o.f.shift = NULL;
        run(&o, k);
        for (int i = 0; i < N; i++)
            eps[i] = o.f.eps[i], deps[i] = o.f.deps[i];
        o.f.th = th + PAD;
        o.f.shift = shift + PAD;
        run(&o, k);
        for (int i = 0; i < N; i++) {
            double q = o.f.q[i], H2 = o.f.H[i] * o.f.H[i];
            double scale = o.fluid.lambda / H2, cold = eps[i] * scale / q;
            double hot = exp2(o.f.th[i] * log2(cold) + o.f.shift[i]);
            double slope = (o.f.dq[i] - deps[i] * scale / cold) / q;
            CHECK_CLOSE(o.f.eps[i] * scale / q, hot, 1e-12);
            CHECK_NEAR(o.f.deps[i] * scale / hot,
                       o.f.dq[i] - q * o.f.th[i] * slope,
                       1e-11 * q * (1 + slope));
        }
    }
    ovr_arena_release(&o.arena);
}

/* Density falls with it: rho, q and d q/dP, and eps as rho. */
TEST(temperatures_swell_the_oil)
{
    ovr_error err = {0};
    oil o = make();
    uint64_t seed = 26;
    double *swell = ovr_field(&o.arena, N + 2 * PAD, &err);
    fill(&o, &seed, 1);
    for (int i = -PAD; i < N + PAD; i++)
        swell[PAD + i] = test_random(&seed, 0.9, 1.02);
    for (int k = 0; test_kernels(k); k++) {
        double cold[5][N];
        o.f.swell = NULL;
        run(&o, k);
        double *const all[] = {o.f.rho, o.f.q, o.f.dq, o.f.eps, o.f.deps};
        for (int m = 0; m < 5; m++)
            memcpy(cold[m], all[m], sizeof cold[m]);
        o.f.swell = swell + PAD;
        run(&o, k);
        for (int m = 0; m < 5; m++)
            for (int i = 0; i < N; i++)
                CHECK_CLOSE(all[m][i], o.f.swell[i] * cold[m][i], 1e-13);
    }
    ovr_arena_release(&o.arena);
}
