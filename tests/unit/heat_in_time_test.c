/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surface temperatures in time: convected fields, and temperatures under a
 * uniform source that starts at T = 0, compared with closed forms. */
#include <math.h>
#include <string.h>

#include "multigrid/departures.h"
#include "physics/heat/solids.h"
#include "support/test.h"

enum { N = 641 };

/* ------------------------------------------------------------------- departure
 * points */

static double bell(double x)
{
    return exp(-x * x / 200);
}

/* Computes the values at the departure points of all nodes. */
static void carry(const double *v, double meshes, double *to)
{
    const ovr_departures departures = ovr_departures_of(N, meshes);
    ovr_carry_along(&departures, v, to);
}

/* Exact for whole D, cubic for parts of D; inflow has the value zero, outflow
 * the value at the end. */
TEST(values_at_departures)
{
    double v[N], at[N];
    for (int i = 0; i < N; i++)
        v[i] = 1 + 1e-6 * i * i * i;
    for (double shift = -7.75; shift < 8; shift += 0.25) {
        carry(v, shift, at);
        for (int i = 10; i < N - 10; i++)
            CHECK_CLOSE(at[i], 1 + 1e-6 * pow(i - shift, 3), 1e-12);
    }
    carry(v, 3, at);
    assert_memory_equal(at + 3, v, (N - 3) * sizeof *v);
    for (int i = 0; i < 3; i++)
        assert_true(at[i] == 0);
    carry(v, -2, at);
    assert_memory_equal(at, v + 2, (N - 2) * sizeof *v);
    assert_true(at[N - 1] == 0 && at[N - 2] == 0);
    carry(v, 1e9, at);
    for (int i = 0; i < N; i++)
        assert_true(at[i] == 0);
}

/* There and back: cubic, and no drift. */
TEST(carried_far)
{
    double v[N], at[N], worst = 0;
    for (int i = 0; i < N; i++)
        v[i] = bell(i - 100);
    for (int k = 0; k < 1000; k++) {
        carry(v, 0.3, at);
        memcpy(v, at, sizeof v);
    }
    for (int i = 0; i < N; i++)
        worst = fmax(worst, fabs(v[i] - bell(i - 400)));
    print_message("300 meshes in 1000 steps: off by %.1e\n", worst);
    assert_true(worst < 1e-2);
}

/* --------------------------------------------------------------- surfaces */

typedef struct surface {
    ovr_memory memory;
    double psi[OVR_MODES][N], q[N], T[N], at[N], before[N];
} surface;

/* A step of dT at u, with the source at those nodes where q_now is. */
static void step(surface *s, double D, double u, double dT, const double *q_now)
{
    double meshes = u * dT / D;
    if (s->memory.dT != dT)
        ovr_memory_fit(dT, 20, &s->memory);
    for (int i = 0; i < N; i++) {
        double psi[OVR_MODES];
        for (int m = 0; m < OVR_MODES; m++)
            psi[m] = s->psi[m][i];
        s->at[i] = ovr_memory_past(&s->memory, psi, s->q[i]);
    }
    carry(s->at, meshes, s->T);
    for (int i = 0; i < N; i++)
        s->T[i] += 4. / 3 * sqrt(dT) * q_now[i];
    carry(s->q, meshes, s->before);
    for (int m = 0; m < OVR_MODES; m++) {
        carry(s->psi[m], meshes, s->at);
        for (int i = 0; i < N; i++)
            s->psi[m][i] = s->memory.fade[m] * s->at[i] +
                           s->memory.now[m] * q_now[i] +
                           s->memory.before[m] * s->before[i];
    }
    memcpy(s->q, q_now, sizeof s->q);
}

/* q = 1 over -1 < X < 1 from T = 0 on, on a surface that moves at u; T/N off
 * the closed form, over the largest, away from where the source ends. */
static double under_source(double u, double dT, double dT_other)
{
    static surface s;
    double D = 5. / (N - 1), q[N], T = 0, worst = 0;
    memset(&s, 0, sizeof s);
    ovr_memory_rates(D / 8, 20, &s.memory);
    for (int i = 0; i < N; i++) {
        double X = -2.5 + i * D;
        q[i] = fabs(X) < 1 - 1e-9 ? 1 : fabs(X) < 1 + 1e-9 ? 0.5 : 0;
    }
    for (int k = 0; T < 1.5; k++) {
        double h = k / 20 % 2 ? dT_other : dT;
        /* the source is there from the start: q is linear within steps */
        if (k == 0)
            memcpy(s.q, q, sizeof q);
        step(&s, D, u, h, q);
        T += h;
    }
    for (int i = 0; i < N; i++) {
        double X = -2.5 + i * D, way = u * T;
        double in = fmin(way, fmax(0, X + 1)) / u;
        double out = fmin(way, fmax(0, X - 1)) / u;
        double exact = 2 * (sqrt(in) - sqrt(out)), off = 0.3;
        if (fabs(X + 1) > off && fabs(X - 1) > off && fabs(X + 1 - way) > off &&
            fabs(X - 1 - way) > off)
            worst = fmax(worst, fabs(s.T[i] - exact));
    }
    return worst / (2 * sqrt(fmin(T, 2 / u)));
}

TEST(uniform_source_in_time)
{
    const double D = 5. / (N - 1);
    for (int k = 0; k < 4; k++) {
        static const double u[] = {1, 0.5, 1.3, 1e-9};
        double alike = under_source(u[k], D, D);
        double other = under_source(u[k], D, 2.5 * D);
        print_message("u = %g: off by %.1e, by steps of two lengths %.1e\n",
                      u[k], alike, other);
        assert_true(alike < 1e-3);
        assert_true(other < 2e-3);
    }
}
