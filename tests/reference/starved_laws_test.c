/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass-conserving cavitation with the first-order scheme and with shear-
 * thinning films: general properties, and limits with known solutions. */
#include <math.h>

#include "contact/contact.h"
#include "physics/supply/supply.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"

enum { LEVEL = 6 };

/* The scheme; Eyring's stress at a slide-to-roll ratio, or infinite. */
typedef struct oil_law {
    ovr_scheme scheme;
    ovr_cavitation cavitation;
    double Sigma0, S;
} oil_law;

static ovr_simulation *make(const oil_law *law, int level)
{
    test_contact c = test_contact_make(20, 10);
    ovr_flow_form form = ovr_flow_form_default();
    ovr_options o = test_options();
    ovr_error err = {0};
    o.level = level;
    o.scheme = law->scheme;
    o.cavitation = law->cavitation;
    c.contact.u1_ratio = 1 + law->S / 2;
    c.contact.u2_ratio = 1 - law->S / 2;
    if (isfinite(law->Sigma0)) {
        form.rheology = OVR_EYRING;
        form.number = law->Sigma0;
        CHECK_OK(ovr_lubricant_flow(&c.contact, &form, &c.lubricant, &err),
                 &err);
    }
    ovr_simulation *sim = ovr_simulation_create(&c.contact, &c.lubricant, &o,
                                                NULL, &err);
    assert_non_null(sim);
    return sim;
}

static double constant(void *data, double T)
{
    (void)T;
    return *(double *)data;
}

static ovr_observation solve(const oil_law *law, int level, double *q)
{
    ovr_error err = {0};
    ovr_simulation *sim = make(law, level);
    if (q)
        ovr_simulation_supply(sim, constant, q, 0);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_observation o = *ovr_simulation_observation(sim);
    ovr_simulation_free(sim);
    return o;
}

static const oil_law first = {OVR_UPSTREAM1, OVR_CAVITATION_CONSERVING,
                              INFINITY, 0};
static const oil_law second = {OVR_UPSTREAM2, OVR_CAVITATION_CONSERVING,
                               INFINITY, 0};
static const oil_law thin = {OVR_UPSTREAM2, OVR_CAVITATION_CONSERVING, 0.1,
                             0.2};

/* What arrives passes, and is the film's share of the flooded one. */
static void passes(const oil_law *law, double share)
{
    double q = share * solve(law, LEVEL, NULL).outflow;
    ovr_observation o = solve(law, LEVEL, &q);
    assert_true(o.converged);
    CHECK_CLOSE(o.outflow, q, 1e-8);
    CHECK_NEAR(o.inflow_ratio, share, 1e-8);
    CHECK_NEAR(o.starvation_factor, share, 2e-3);
}

TEST(supply_passes_through)
{
    for (int k = 1; k < 4; k++) {
        passes(&first, 0.25 * k);
        passes(&thin, 0.25 * k);
    }
}

/* The distance from the meniscus of the second-order scheme halves with the
 * mesh. */
TEST(first_order)
{
    double q = 0.0504192, off[3];
    for (int l = 0; l < 3; l++)
        off[l] = solve(&first, 6 + l, &q).meniscus -
                 solve(&second, 6 + l, &q).meniscus;
    print_message("    meniscus off by %.2e %.2e %.2e\n", off[0], off[1],
                  off[2]);
    for (int l = 0; l < 2; l++)
        CHECK_NEAR(off[l] / off[l + 1], 2, 0.4);
}

/* A flooded contact is that of the Reynolds equation, which has truths of its
 * own (friction_test). */
TEST(flooded_is_reynolds)
{
    const oil_law *const laws[] = {&first, &thin};
    for (int k = 0; k < 2; k++) {
        oil_law plain = *laws[k];
        plain.cavitation = OVR_CAVITATION_REYNOLDS;
        ovr_observation a = solve(laws[k], LEVEL, NULL);
        ovr_observation b = solve(&plain, LEVEL, NULL);
        CHECK_CLOSE(a.H_cen, b.H_cen, 1e-8);
        CHECK_CLOSE(a.H_min, b.H_min, 1e-8);
        CHECK_NEAR(a.P_max, b.P_max, 1e-8);
        CHECK_NEAR(a.F_slide, b.F_slide, 1e-6 * (1 + fabs(b.F_slide)));
    }
}

/* Oil in the cells of the rows. */
static double stored(const ovr_state *s)
{
    double sum = 0;
    for (size_t i = 1; i + 1 < s->n; i++)
        sum += s->q[i];
    return sum * s->D;
}

/* A dent through a starved contact: every step converges, and (by backward
 * Euler, whose content is that of the nodes) what flows in less what flows out
 * is what is stored, by the fluxes that are observed. */
static void dent(const oil_law *law, double share, bool balanced)
{
    double q = share * solve(law, LEVEL, NULL).outflow, flow = 0;
    test_feature d = {.kind = 'l',
                      .A = -0.1,
                      .width = 0.5,
                      .start = -2.5,
                      .u = 1 + law->S / 2};
    ovr_error err = {0};
    ovr_simulation *sim = make(law, LEVEL);
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    ovr_simulation_supply(sim, constant, &q, 0);
    ovr_simulation_surface(sim, test_feature_heights, &d);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    double before = stored(s), minimum = INFINITY;
    for (int k = 0; k < 320; k++) {
        CHECK_OK(ovr_simulation_step(sim, s->D, &err), &err);
        assert_true(o->converged);
        assert_true(fabs(o->mass_defect) < 1e-3);
        flow += s->D * (o->inflow - o->outflow);
        minimum = fmin(minimum, o->H_cen);
    }
    assert_true(minimum < 0.95 * share * solve(law, LEVEL, NULL).H_cen);
    if (balanced)
        CHECK_NEAR(flow, stored(s) - before, 1e-4 * q);
    ovr_simulation_free(sim);
}

TEST(dents_pass)
{
    dent(&first, 0.5, true);
    dent(&thin, 0.5, false);
}
