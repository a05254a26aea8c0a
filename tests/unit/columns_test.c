/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cross-film columns of nodes: the kernels of every instruction set compared
 * with the plain ones of across.c (heat_test.c), and all of them with closed
 * forms. */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/flow_law.h"
#include "contact/laws/law.h"
#include "multigrid/cross_film.h"
#include "multigrid/departures.h"
#include "support/contact.h"
#include "support/kernels.h"
#include "support/test.h"

enum {
    MAX = 70,
    IN = 2 * OVR_CROSS_FILM_MAX + 8,
    OUT = 4 * OVR_CROSS_FILM_MAX + 8
};

/* Random films with cavitated nodes, and space for the results. */
typedef struct films {
    ovr_cross_film cross_film;
    ovr_heat heat;
    ovr_columns c;
    double in[IN][MAX], out[OUT][MAX];
    int count;
} films;

static const double *input(films *f, int k, double from, double to,
                           uint64_t *seed)
{
    for (size_t i = 0; i < f->c.n; i++)
        f->in[k][i] = test_random(seed, from, to);
    return f->in[k];
}

static void put_places(films *f)
{
    ovr_columns *c = &f->c;
    double **const all[] = {&c->t,       &c->fall,    &c->th,    &c->shift,
                            &c->drag,    &c->skewed,  &c->swell, &c->mean,
                            &c->into[0], &c->into[1], &c->even};
    f->count = 0;
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        *all[k] = f->out[f->count++];
    for (int j = 0; j < f->cross_film.n; j++) {
        c->u[j] = f->out[f->count++];
        c->heating[j] = f->out[f->count++];
        c->T[j] = f->out[f->count++];
    }
}

static void fill(films *f, size_t n, int points, uint64_t *seed)
{
    ovr_columns *c = &f->c;
    ovr_cross_film_make(points, &f->cross_film);
    *c = (ovr_columns){.cross_film = &f->cross_film, .heat = &f->heat, .n = n};
    f->heat = (ovr_heat){.points = points,
                         .T0 = test_random(seed, 280, 400),
                         .theta = test_random(seed, 100, 1000),
                         .conduction = pow(10, test_random(seed, -1, 1.5)),
                         .solid = {test_random(seed, 0.01, 0.1), 0.05},
                         .bulk = {test_random(seed, -30, 30), 0},
                         .expansion = 6e-4,
                         .density_expands = points == 5,
                         .S0 = test_random(seed, 0.5, 1.5),
                         .beta = 0.03,
                         .C = 6.5,
                         .A = test_random(seed, 0.3, 1)};
    c->lambda = test_random(seed, 1e-3, 1);
    c->V = test_random(seed, -2, 2);
    c->u1 = 1 + c->V / 2;
    c->limit = INFINITY;
    c->Sigma0 = INFINITY;
    c->dT = 0.02;
    c->X = input(f, 0, 0, 0.3, seed);
    c->P = input(f, 1, -0.2, 1.2, seed);
    for (size_t i = 0; i < n; i++) {
        f->in[0][i] += (double)i;
        f->in[1][i] = fmax(0, f->in[1][i]);
    }
    c->H = input(f, 2, 0.03, 1.5, seed);
    c->q = input(f, 3, 0.03, 1.8, seed);
    c->log_eta = input(f, 4, -1, 25, seed);
    c->P_T = input(f, 5, -1, 1, seed);
    for (int k = 0; k < 2; k++) {
        c->past[k] = input(f, 6 + k, -100, 500, seed);
        c->resistance[k] = test_random(seed, 1e-3, 1e-2);
    }
    for (int j = 0; j < points; j++) {
        c->used[j] = input(f, 8 + j, -20, 150, seed);
        c->departure[j] = input(f, 8 + OVR_CROSS_FILM_MAX + j, -20, 150, seed);
    }
    put_places(f);
}

/* Compares values relative to the largest one. */
static void agree(const films *here, const films *plain, double tolerance)
{
    for (int k = 0; k < here->count; k++) {
        double maximum = 0;
        for (size_t i = 1; i < plain->c.n; i++)
            maximum = fmax(maximum, fabs(plain->out[k][i]));
        for (size_t i = 1; i < plain->c.n; i++) {
            double size = fabs(plain->out[k][i]) + 1e-6 * maximum;
            CHECK_NEAR(here->out[k][i], plain->out[k][i], tolerance * size);
        }
    }
}

/* All of it: flow, heat, and what Reynolds' equation gets. */
static void make(const ovr_kernels *run, films *f)
{
    double *th = f->c.th;
    f->c.th = NULL;
    run->flow_cross_film(&f->c);
    run->heat_cross_film(&f->c);
    f->c.th = th;
    run->flow_cross_film(&f->c);
}

static void compare(films *plain, double tolerance)
{
    static films here;
    const ovr_kernels *run;
    make(test_kernels(0), plain);
    for (int k = 1; (run = test_kernels(k)); k++) {
        here = *plain;
        here.c.cross_film = &here.cross_film;
        here.c.heat = &here.heat;
        memset(here.out, 0, sizeof here.out);
        put_places(&here);
        make(run, &here);
        agree(&here, plain, tolerance);
    }
}

static const size_t sizes[] = {15, 29, 57, 70};

static void films_by_law(double Sigma0, const ovr_flow_law *law, uint64_t seed)
{
    static films f;
    for (int k = 0; k < 16; k++) {
        fill(&f, sizes[k & 3], k & 1 ? 7 : 5, &seed);
        f.c.Sigma0 = Sigma0;
        f.c.law = law;
        if (k & 4)
            f.heat.C = 0;
        if (k & 8) {
            f.c.limit = 4;
            f.c.V = k & 1 ? 0 : f.c.V;
        }
        compare(&f, 1e-9);
    }
}

TEST(newtonian_films_agree)
{
    films_by_law(INFINITY, NULL, 5);
}

TEST(eyring_films_agree)
{
    films_by_law(0.05, NULL, 6);
    films_by_law(0.4, NULL, 7);
    films_by_law(1e4, NULL, 8);
}

TEST(films_by_table_agree)
{
    ovr_error err = {0};
    for (int rate = 0; rate < 2; rate++) {
        ovr_flow_form form = ovr_flow_form_default();
        form.rheology = rate ? OVR_CARREAU : OVR_CARREAU_STRESS;
        form.n = rate ? 0.35 : 0.6;
        ovr_flow_law *law = ovr_flow_law_create(&form, NULL, &err);
        assert_non_null(law);
        films_by_law(0.05, law, 9);
        films_by_law(0.6, law, 10);
        ovr_flow_law_free(law);
    }
}

/* What slides adds up, whatever the law: u_2 = u_1 - V; the film of uniform
 * temperature has a parabola. */
TEST(surfaces_move_as_prescribed)
{
    static films f;
    uint64_t seed = 11;
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        fill(&f, 57, 5, &seed);
        f.c.Sigma0 = 0.3;
        f.c.th = NULL;
        run->flow_cross_film(&f.c);
        for (size_t i = 0; i < 57; i++) {
            CHECK_NEAR(f.c.u[0][i], f.c.u1, 1e-12);
            CHECK_NEAR(f.c.u[4][i], f.c.u1 - f.c.V, 1e-9);
        }
    }
}

/* ------------------------------------------------- what must hold of them */

/* Wet films with flat pressure and viscosity, between surfaces of which each
 * has its own past. */
static void flat(films *f, int points, uint64_t *seed)
{
    fill(f, 57, points, seed);
    f->heat.C = f->heat.beta = f->heat.expansion = 0;
    f->c.th = NULL;
    f->c.P_T = NULL;
    f->c.dT = 1e30; /* as long as it takes */
    for (size_t i = 0; i < 57; i++) {
        f->in[1][i] = 0.5;
        f->in[4][i] = fmin(f->in[4][i], 3);
    }
}

/* T = T_bulk + N past of surface k */
static double told(const films *f, int k, size_t i)
{
    return f->heat.bulk[k] + f->heat.solid[k] * f->c.past[k][i];
}

/* Nothing slides: heat goes from the one to the other, q_1 = -q_2 = (T_2 -
 * T_1)/(H + R_1 + R_2) with the surfaces' resistances. */
TEST(slab_conducts)
{
    static films f;
    uint64_t seed = 14;
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        flat(&f, k & 1 ? 7 : 5, &seed);
        f.c.V = 0;
        run->flow_cross_film(&f.c);
        run->heat_cross_film(&f.c);
        for (size_t i = 1; i + 1 < 57; i++) {
            double a = told(&f, 0, i), b = told(&f, 1, i);
            double all = f.c.H[i] + f.c.resistance[0] + f.c.resistance[1];
            double q = (b - a) / all;
            CHECK_NEAR(f.c.into[0][i], q, 1e-9 * (1 + fabs(q)));
            CHECK_NEAR(f.c.into[1][i], -q, 1e-9 * (1 + fabs(q)));
            for (int j = 0; j < f.cross_film.n; j++) {
                double zeta = (1 + f.cross_film.s[j]) / 2;
                double T = a + q * (f.c.resistance[0] + zeta * f.c.H[i]);
                CHECK_NEAR(f.c.T[j][i], T, 1e-9 * (1 + fabs(T)));
            }
        }
    }
}

/* A Newtonian film that slides between surfaces of the same temperature: T =
 * T_wall + (4 zeta (1 - zeta)) Theta lambda eta V^2/(96 Kf), whatever H. */
TEST(couette_heats)
{
    static films f;
    uint64_t seed = 15;
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        flat(&f, k & 1 ? 7 : 5, &seed);
        f.heat.bulk[0] = f.heat.bulk[1];
        f.heat.solid[0] = f.heat.solid[1];
        f.c.past[0] = f.c.past[1];
        f.c.resistance[0] = f.c.resistance[1];
        run->flow_cross_film(&f.c);
        run->heat_cross_film(&f.c);
        for (size_t i = 1; i + 1 < 57; i++) {
            double eta = exp(f.c.log_eta[i]), V = f.c.V;
            double maximum = f.heat.theta * f.c.lambda * eta * V * V /
                             (96 * f.heat.conduction);
            CHECK_NEAR(f.c.t[i], -f.c.lambda * eta * V / (12 * f.c.H[i]),
                       1e-9 * fabs(f.c.t[i]));
            CHECK_NEAR(f.c.even[i], f.c.t[i], 1e-12 * fabs(f.c.t[i]));
            for (int j = 0; j < f.cross_film.n; j++) {
                double s = f.cross_film.s[j], T = maximum * (1 - s * s);
                CHECK_NEAR(f.c.T[j][i] - f.c.T[0][i], T,
                           1e-9 * (maximum + fabs(f.c.T[0][i])));
            }
        }
    }
}

static void turn_over(films *f)
{
    int last = f->cross_film.n - 1;
    for (int j = 0; j < last - j; j++)
        for (size_t i = 0; i < f->c.n; i++) {
            double *rows[2][2] = {{f->in[8 + j], f->in[8 + last - j]},
                                  {f->in[8 + OVR_CROSS_FILM_MAX + j],
                                   f->in[8 + OVR_CROSS_FILM_MAX + last - j]}};
            for (int r = 0; r < 2; r++) {
                double kept = rows[r][0][i];
                rows[r][0][i] = rows[r][1][i];
                rows[r][1][i] = kept;
            }
        }
    double bulk = f->heat.bulk[0], solid = f->heat.solid[0];
    double resistance = f->c.resistance[0];
    const double *past = f->c.past[0];
    f->c.u1 -= f->c.V;
    f->c.V = -f->c.V;
    f->heat.bulk[0] = f->heat.bulk[1], f->heat.bulk[1] = bulk;
    f->heat.solid[0] = f->heat.solid[1], f->heat.solid[1] = solid;
    f->c.resistance[0] = f->c.resistance[1], f->c.resistance[1] = resistance;
    f->c.past[0] = f->c.past[1], f->c.past[1] = past;
}

/* The two surfaces swapped. */
TEST(swapped_films_mirror)
{
    static films f, g;
    uint64_t seed = 16;
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        uint64_t same = seed;
        fill(&f, 57, k & 1 ? 7 : 5, &seed);
        fill(&g, 57, k & 1 ? 7 : 5, &same);
        f.c.Sigma0 = g.c.Sigma0 = 0.4;
        turn_over(&g);
        make(run, &f);
        make(run, &g);
        int last = f.cross_film.n - 1;
        for (size_t i = 1; i < 57; i++) {
            double t = fabs(f.c.t[i]);
            CHECK_NEAR(g.c.t[i], -f.c.t[i], 1e-9 * (1 + t));
            CHECK_NEAR(g.c.skewed[i], f.c.skewed[i], 1e-9);
            CHECK_NEAR(g.c.into[1][i], f.c.into[0][i],
                       1e-7 * (1 + fabs(f.c.into[0][i])));
            for (int j = 0; j <= last; j++)
                CHECK_NEAR(g.c.T[last - j][i], f.c.T[j][i],
                           1e-9 * (1 + fabs(f.c.T[j][i])));
        }
    }
}

/* Returns v at a place between two nodes, 0 beyond both ends. */
static double linear_at(double place, const double *v)
{
    double sum = 0;
    for (int i = 0; i < MAX; i++)
        sum += v[i] * fmax(0, 1 - fabs(place - i));
    return sum;
}

/* Values that surfaces and film carry by any number of mesh sizes: whole arrays
 * and single nodes agree. */
TEST(departures_agree)
{
    double v[MAX], u[MAX], at[MAX];
    uint64_t seed = 13;
    for (double meshes = -90; meshes < 90; meshes += 3.3) {
        const ovr_departures departures = ovr_departures_of(MAX, meshes);
        for (size_t i = 0; i < MAX; i++) {
            v[i] = test_random(&seed, -1, 2);
            u[i] = test_random(&seed, -0.5, 2);
        }
        ovr_carry_along(&departures, v, at);
        for (size_t i = 0; i < MAX; i++)
            CHECK_NEAR(at[i], ovr_departures_at(&departures, v, i), 1e-14);
        ovr_film_departures(MAX, meshes / 4, u, v, at);
        for (size_t i = 0; i < MAX; i++)
            CHECK_NEAR(at[i], linear_at((double)i - meshes / 4 * u[i], v),
                       1e-12);
    }
}

/* Laws of viscosity, and one that is an object. */
static void half_of_barus(const ovr_law *law, const ovr_law_nodes *nodes)
{
    (void)law;
    for (size_t i = 0; i < nodes->count; i++) {
        nodes->log2_fluidity[i] = -5 * nodes->P[i] - nodes->H[i];
        nodes->by_pressure[i] = nodes->by_film[i] = 0;
    }
}

TEST(viscosities_agree)
{
    static const ovr_law own = {half_of_barus};
    double P[MAX], H[MAX], plain[MAX], here[MAX];
    uint64_t seed = 12;
    const ovr_kernels *run;
    for (size_t i = 0; i < MAX; i++) {
        P[i] = fmax(0, test_random(&seed, -0.2, 1.5));
        H[i] = test_random(&seed, 0.1, 1);
    }
    for (int law = 0; law < 3; law++) {
        test_contact contact = test_contact_make(20, 10);
        ovr_fluid fluid = {.lubricant = contact.lubricant, .lambda = 1};
        if (law == 1)
            fluid.lubricant.viscosity_law = OVR_BARUS;
        if (law == 2)
            fluid.law = &own;
        test_kernels(0)->log_viscosity(MAX, &fluid, P, H, plain);
        for (size_t i = 0; law < 2 && i < MAX; i++)
            CHECK_NEAR(plain[i], log(ovr_viscosity(&fluid.lubricant, P[i])),
                       1e-12 * (1 + fabs(plain[i])));
        for (int k = 1; (run = test_kernels(k)); k++) {
            run->log_viscosity(MAX, &fluid, P, H, here);
            for (size_t i = 0; i < MAX; i++)
                CHECK_NEAR(here[i], plain[i], 1e-12 * (1 + fabs(plain[i])));
        }
    }
}

/* Films of the pressures P, at one rise all over. */
static void fill_at(films *f, double T, const double *P)
{
    uint64_t seed = 11;
    fill(f, MAX, 5, &seed);
    f->heat.density_expands = true;
    f->heat.A = 0.59;
    f->heat.expansion = 6.5e-4;
    f->heat.theta = 1e9 / (870 * 2000.0); /* ph = 1 GPa */
    f->heat.T0 = 353;
    for (size_t i = 0; i < MAX; i++) {
        f->in[1][i] = P[i];
        for (int j = 0; j < 5; j++)
            f->in[8 + j][i] = f->in[8 + OVR_CROSS_FILM_MAX + j][i] = T;
    }
}

/* Oil of 5 GPa and 1000 K, heated by being pressed, gets denser by it:
 * (1/rho) d rho/dP > beta dT/dP, dT/dP = Theta beta (T0 + T). */
TEST(pressed_oil_gets_denser)
{
    static films f;
    ovr_lubricant dh = {.density_law = OVR_DOWSON_HIGGINSON, .A = 0.59};
    const double h = 1e-4, T = 50;
    double P[MAX];
    for (size_t i = 0; i < MAX; i++)
        P[i] = 5.0 * (double)(i + 1) / MAX;
    fill_at(&f, T, P);
    for (int k = 0; test_kernels(k); k++) {
        test_kernels(k)->flow_cross_film(&f.c);
        for (size_t i = 1; i + 1 < f.c.n; i++) {
            double swells = (1 / f.c.swell[i] - 1) / T; /* of v_0 */
            double dense = log(ovr_density(&dh, P[i] + h) /
                               ovr_density(&dh, P[i] - h)) /
                           (2 * h);
            double at_0 = 0.34 / dh.A, bT = f.heat.expansion;
            CHECK_CLOSE(swells / dense, bT / at_0, 1e-5);
            assert_true(swells * f.heat.theta * bT * 1000 < dense);
        }
    }
}

/* Volumes of a mass, and beta as it heats the oil: walls that take nothing and
 * P that rises all over, in a step too short for conduction. */
static void expand(const ovr_kernels *run, double T, const double *P, double *v,
                   double *beta)
{
    static films f;
    double pressed[MAX];
    ovr_lubricant dh = {.density_law = OVR_DOWSON_HIGGINSON, .A = 0.59};
    fill_at(&f, T, P);
    f.heat.conduction = 1e-20;
    f.c.V = 0;
    f.c.u1 = 0;
    f.c.Sigma0 = INFINITY;
    f.c.lambda = 1e30; /* what P_X does to the film */
    f.c.P_T = pressed;
    for (size_t i = 0; i < MAX; i++)
        pressed[i] = 1e-3;
    make(run, &f);
    for (size_t i = 1; i + 1 < MAX; i++) {
        v[i] = 1 / (ovr_density(&dh, P[i]) * f.c.swell[i]);
        beta[i] = (f.c.mean[i] - T) * f.c.q[i] /
                  (f.heat.theta * f.c.H[i] * f.c.dT * pressed[i] *
                   (f.heat.T0 + f.c.mean[i]));
    }
}

/* Oil is pressed at T1, warmed, relieved at T2 and cooled: heat, T v beta dP
 * along the two isotherms, is work, P dv around.  Both per density and ph. */
static void a_cycle_closes(const ovr_kernels *run, double maximum)
{
    enum { INTERVALS = MAX - 4 };
    double P[MAX], v[2][MAX], beta[2][MAX], heat = 0, work = 0;
    const double T[2] = {0, 50};
    for (size_t i = 0; i < MAX; i++)
        P[i] = fmax(maximum * ((double)i - 1) / INTERVALS, 1e-12);
    for (int k = 0; k < 2; k++)
        expand(run, T[k], P, v[k], beta[k]);
    for (size_t i = 1; i <= 1 + INTERVALS; i++) {
        double w = i == 1 || i == 1 + INTERVALS ? 1 : i % 2 ? 2 : 4;
        double dP = w / 3 * maximum / INTERVALS; /* Simpson's rule */
        heat += dP * ((353 + T[1]) * v[1][i] * beta[1][i] -
                      (353 + T[0]) * v[0][i] * beta[0][i]);
        work += dP * (v[1][i] - v[0][i]);
    }
    print_message("cycle to %g GPa: heat over work %.8f\n", maximum,
                  heat / work);
    CHECK_CLOSE(heat / work, 1, 1e-6);
}

TEST(closed_cycles_close)
{
    static const double maximum[] = {0.5, 1, 2};
    for (int k = 0; test_kernels(k); k++)
        for (int m = 0; m < 3; m++)
            a_cycle_closes(test_kernels(k), maximum[m]);
}
