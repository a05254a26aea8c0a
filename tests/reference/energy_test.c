/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conservation of energy: power of the surfaces, dissipation, stored energy. */
#include <math.h>
#include <stdlib.h>

#include "contact/contact.h"
#include "physics/supply/supply.h"
#include "simulation/internal.h"
#include "simulation/observables.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/hot.h"
#include "support/test.h"

static double *field(const ovr_simulation *sim, const char *name)
{
    const ovr_observable *row = ovr_observable_field(name);
    double *copy = calloc(sim->now.n, sizeof *copy);
    assert_non_null(row);
    const double *values = row->field(sim, copy);
    for (size_t i = 0; i < sim->now.n; i++)
        copy[i] = values[i];
    return copy;
}

/* Roelands' law at the pressure P and T0 + T, relative to T0 and P = 0. */
static double roelands(const test_hot *c, double P, double T)
{
    const double K = 138, C = c->oil.alphabar * c->oil.P0 / c->oil.z;
    double th = pow((c->heat.T0 + T - K) / (c->heat.T0 - K), -c->heat.S0);
    return exp(C * (pow(1 + P / c->oil.P0, c->oil.z) * th - 1));
}

/* Stored viscosities and densities belong to the stored mean temperature. */
TEST(oil_is_as_hot_as_the_film)
{
    test_hot c = test_hot_make(62, 14, 0.5, 8e6, NULL);
    ovr_simulation *sim = test_hot_simulation(&c, 6);
    ovr_error err = {0};
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    double *viscosity = field(sim, "viscosity"), *rho = field(sim, "density");
    double *T = field(sim, "temperature_mean"), thinner = 1;
    for (size_t i = 0; i < sim->now.n; i++) {
        double P = sim->now.P[i], rise = T[i] - c.heat.T0;
        CHECK_CLOSE(viscosity[i], roelands(&c, P, rise), 1e-9);
        thinner = fmin(thinner, viscosity[i] / roelands(&c, P, 0));
        if (P > 0)
            CHECK_CLOSE(rho[i] * sim->now.H[i], sim->now.q[i], 1e-9);
    }
    assert_true(thinner < 0.1);
    free(viscosity);
    free(rho);
    free(T);
    ovr_simulation_free(sim);
}

static ovr_simulation *steady(double M, double L, double S, double Sigma0,
                              const ovr_options *options)
{
    test_contact c = test_contact_make(M, L);
    ovr_flow_form form = ovr_flow_form_default();
    ovr_error err = {0};
    c.contact.u1_ratio = 1 + S / 2;
    c.contact.u2_ratio = 1 - S / 2;
    if (Sigma0 > 0) {
        form.rheology = OVR_EYRING;
        form.number = Sigma0;
        CHECK_OK(ovr_lubricant_flow(&c.contact, &form, &c.lubricant, &err),
                 &err);
    }
    ovr_simulation *sim = ovr_simulation_create(&c.contact, &c.lubricant,
                                                options, NULL, &err);
    assert_non_null(sim);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    return sim;
}

static double rolling(double M, double L, double S, double Sigma0,
                      const ovr_options *options)
{
    ovr_simulation *sim = steady(M, L, S, Sigma0, options);
    double F = ovr_simulation_observation(sim)->F_roll;
    ovr_simulation_free(sim);
    return F;
}

/* The usual inlet and one four times as far out, on the same mesh. */
TEST(rolling_friction_is_that_of_any_inlet)
{
    static const struct {
        double M, L, S, Sigma0, close;
    } of[] = {{1, 1, 0, 0, 2e-3},       {5, 5, 0, 0, 1e-3},
              {10, 2, 0, 0, 1e-3},      {20, 10, 0, 0, 1e-3},
              {50, 14, 0, 0, 1e-3},     {100, 10, 0, 0, 1e-3},
              {20, 10, 1, 0.334, 1e-3}, {8, 6, 0.5, 0.1, 1e-3}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        ovr_options o = ovr_options_default();
        o.level = 7;
        o.order = 2;
        ovr_simulation *sim = steady(of[k].M, of[k].L, of[k].S, of[k].Sigma0,
                                     &o);
        const ovr_options used = *ovr_simulation_options(sim);
        double usual = ovr_simulation_observation(sim)->F_roll;
        ovr_simulation_free(sim);
        o.level += 2;
        o.outlet = used.outlet;
        o.inlet = used.outlet - 4 * (used.outlet - used.inlet);
        double far = rolling(of[k].M, of[k].L, of[k].S, of[k].Sigma0, &o);
        print_message("    M %g L %g S %g: %.2e off\n", of[k].M, of[k].L,
                      of[k].S, usual / far - 1);
        CHECK_CLOSE(usual, far, of[k].close);
    }
}

/* Integral of H P_X/2 over the nodes. */
static double in_domain(const ovr_solution *s)
{
    double sum = 0;
    for (size_t i = 0; i + 1 < s->n; i++)
        sum += (s->H[i] + s->H[i + 1]) / 4 * (s->P[i + 1] - s->P[i]);
    return sum;
}

/* The part beyond a distant inlet: midpoint rule, with the deformation of the
 * computed pressure. */
TEST(beyond_the_inlet_by_quadrature)
{
    enum { CELLS = 4000 };
    ovr_options o = test_options();
    o.level = 8;
    o.inlet = -20;
    ovr_simulation *sim = steady(20, 10, 0, 0, &o);
    const ovr_solution *s = &sim->now;
    const double pi = acos(-1), lambda = sim->contact.lambda, X_a = s->X[0];
    double M = ovr_simulation_observation(sim)->mass_flow, roll = 0;
    for (int k = 0; k < CELLS; k++) {
        double xi = (k + 0.5) / CELLS, X = X_a / xi, w = 0;
        for (size_t i = 1; i < s->n; i++)
            w -= s->weights[i] * s->P[i] / pi *
                 log((s->X[i] - X) / (s->X[i] - X_a));
        double H = s->H[0] + (X * X - X_a * X_a) / 2 + w;
        roll += (H - M) * lambda * (H - M) / (H * H * H) / 2 * -X_a /
                (xi * xi) / CELLS;
    }
    double part = ovr_simulation_observation(sim)->F_roll - in_domain(s);
    print_message("    beyond the inlet %.6e, %.6e\n", part, roll);
    CHECK_CLOSE(part, roll, 5e-3); /* the film is still too thin */
    ovr_simulation_free(sim);
}

static double thin_film(void *data, double T)
{
    (void)T;
    return *(const double *)data;
}

/* Nothing is added beyond the inlet where only a thin film arrives. */
TEST(starved_inlet_has_no_friction_beyond_it)
{
    double arrives = 0.1;
    ovr_options o = test_options();
    test_contact c = test_contact_make(5, 5);
    ovr_error err = {0};
    o.level = 7;
    o.cavitation = OVR_CAVITATION_CONSERVING;
    ovr_simulation *sim = ovr_simulation_create(&c.contact, &c.lubricant, &o,
                                                NULL, &err);
    assert_non_null(sim);
    ovr_simulation_supply(sim, thin_film, &arrives, 0);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation *seen = ovr_simulation_observation(sim);
    assert_true(sim->now.P[1] == 0);
    CHECK_CLOSE(seen->F_roll, in_domain(&sim->now), 1e-12);
    ovr_simulation_free(sim);
}

/* Elastic energy of the oil (per mass int P drho/rho^2) and of the solids, and
 * the load times H0. */
static double stored(const ovr_simulation *sim)
{
    enum { PARTS = 64 };
    const ovr_solution *s = &sim->now;
    double sum = OVR_NOMINAL_LOAD * sim->grids.H0;
    for (size_t i = 0; i < s->n; i++) {
        double P = s->P[i], e = 0;
        for (int k = 0; k < PARTS && P > 0; k++) {
            double a = P * k / PARTS, b = P * (k + 1) / PARTS;
            double ra = ovr_density(&sim->lubricant, a);
            double rb = ovr_density(&sim->lubricant, b);
            e += (a + b) / 2 * (1 / ra - 1 / rb);
        }
        double w = s->H[i] - sim->grids.H0 - s->X[i] * s->X[i] / 2 +
                   sim->shapes.S[i];
        sum += s->weights[i] * (s->q[i] * e + P * w / 2);
    }
    return sum;
}

typedef struct passage {
    double in, dissipated, stored, slopes;
} passage;

/* Integrals in time while a bump on the surface of speed u moves into the
 * contact or through it. */
static passage pass(int level, double u, double S, double until)
{
    test_feature bump = {'l', 0.05, 1.0, -1 - 3.2 * u, u, 0};
    ovr_options o = test_options();
    test_contact c = test_contact_make(5, 5);
    ovr_error err = {0};
    passage sum = {0};
    o.level = level;
    o.order = 2;
    c.contact.u1_ratio = 1 + S / 2;
    c.contact.u2_ratio = 1 - S / 2;
    ovr_simulation *sim = ovr_simulation_create(&c.contact, &c.lubricant, &o,
                                                NULL, &err);
    assert_non_null(sim);
    ovr_simulation_surface(sim, test_feature_heights, &bump);
    ovr_simulation_moving(sim, u);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation *at = ovr_simulation_observation(sim);
    double D = ovr_simulation_state(sim)->D, before = stored(sim);
    double in = at->power_in, lost = at->power_dissipated;
    int steps = (int)lround(until / D);
    for (int k = 0; k < steps; k++) {
        CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
        sum.in += D * (in + at->power_in) / 2;
        sum.slopes -= D * u * at->F_slope_1;
        sum.dissipated += D * (lost + at->power_dissipated) / 2;
        in = at->power_in, lost = at->power_dissipated;
    }
    sum.stored = stored(sim) - before;
    ovr_simulation_free(sim);
    return sum;
}

/* Power put in by a feature is dissipated or stored, to second order. */
static void check_passage(double u, double S, double until)
{
    double off[3];
    for (int k = 0; k < 3; k++) {
        passage p = pass(5 + k, u, S, until);
        assert_true(fabs(p.slopes) > 3e-4 * p.in);
        off[k] = (p.in - p.dissipated - p.stored) / p.dissipated;
        print_message("    u %g, T %g, level %d: in %.6f, dissipated %.6f, "
                      "stored %+.6f, on slopes %+.6f, "
                      "%.2e off\n",
                      u, until, 5 + k, p.in, p.dissipated, p.stored, p.slopes,
                      off[k]);
    }
    assert_true(fabs(off[2]) < 1e-5);
    assert_true(fabs(off[1]) < fabs(off[0]) / 4 &&
                fabs(off[2]) < fabs(off[1]) / 4);
}

TEST(power_of_a_feature_is_conserved)
{
    check_passage(1, 0, 3.2);    /* in the contact */
    check_passage(1, 0, 7);      /* gone */
    check_passage(1.25, 0.5, 3); /* on the faster surface */
}
