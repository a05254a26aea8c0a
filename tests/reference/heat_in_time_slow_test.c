/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Properties of transient thermal contacts: long runs end in the steady
 * contact, energy is conserved to the order of the scheme, surfaces may be
 * exchanged, a film without heat sources is isothermal, and a resumed run gives
 * the same result. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/heat_numbers.h"
#include "overroll/overroll.h"
#include "physics/heat/in_time.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/copied.h"
#include "support/hot.h"
#include "support/test.h"

static double D_of(const ovr_simulation *sim)
{
    return ovr_simulation_state(sim)->D;
}

static void step(ovr_simulation *sim, double dT)
{
    ovr_error err = {0};
    CHECK_OK(ovr_simulation_step(sim, dT, &err), &err);
}

static void steady(ovr_simulation *sim)
{
    ovr_error err = {0};
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
}

/* ------------------------------------------------------------------- ends */

/* Friction and largest temperatures of a run that began at another slip, over
 * those of the steady contact at its last slip: how far apart. */
static void apart(double M, double L, double S, int level, double off[2])
{
    test_hot hot = test_hot_make(M, L, S, 5e6, NULL);
    ovr_simulation *run = test_hot_simulation(&hot, level);
    ovr_simulation *still = test_hot_simulation(&hot, level);
    ovr_history_form form = ovr_history_form_default();
    const ovr_observation *a = ovr_simulation_observation(run),
                          *b = ovr_simulation_observation(still);
    ovr_error err = {0};
    assert_true(hot.heat.peclet[0] > 5 && hot.heat.peclet[1] > 5);
    form.kind = OVR_HISTORY_RAMP;
    form.from = S / 4, form.to = S;
    form.duration = 0.5;
    ovr_history *slip = ovr_history_create(&form, NULL, &err);
    assert_non_null(slip);
    ovr_simulation_sliding(run, slip);
    steady(run);
    steady(still);
    assert_true(fabs(a->T_max_rise / b->T_max_rise - 1) > 0.3);
    while (a->T < 10)
        step(run, D_of(run));
    off[0] = fabs(a->mu_slide / b->mu_slide - 1);
    off[1] = fmax(fabs(a->T_max_rise / b->T_max_rise - 1),
                  fmax(fabs(a->T_1_max_rise / b->T_1_max_rise - 1),
                       fabs(a->T_2_max_rise / b->T_2_max_rise - 1)));
    print_message("M %g S %g level %d: mu %.6f of %.6f, T_max %.4f of %.4f; "
                  "apart %.1e and %.1e\n",
                  M, S, level, a->mu_slide, b->mu_slide, a->T_max_rise,
                  b->T_max_rise, off[0], off[1]);
    ovr_simulation_free(run);
    ovr_simulation_free(still);
    ovr_history_free(slip);
}

/* The steady one is found to 3e-5. */
TEST(long_runs_end_steady)
{
    double off[2], finer[2];
    apart(50, 14, -0.4, 5, off);
    assert_true(off[0] < 1e-3 && off[1] < 5e-3);
    apart(20, 10, 0.5, 5, off);
    apart(20, 10, 0.5, 6, finer);
    assert_true(off[0] < 1e-3 && off[1] < 5e-3);
    /* mu, 1e-7 apart, is within what the turns of the steady contact leave:
     * they end where temperatures change by 3e-5 of the largest rise */
    assert_true(finer[0] < fmax(off[0], 1e-6) && finer[1] < off[1]);
}

/* ---------------------------------------------------------------- energy */

static ovr_simulation *with_dent(const test_hot *hot, int level,
                                 test_feature *f)
{
    ovr_simulation *sim = test_hot_simulation(hot, level);
    ovr_simulation_surface(sim, test_feature_heights, f);
    ovr_simulation_moving(sim, f->u);
    steady(sim);
    return sim;
}

/* Root mean square of the balance's defect while a dent passes. */
static double defect(double steps, double *temperature)
{
    test_hot hot = test_hot_make(20, 10, 0.5, 5e6, NULL);
    test_feature f = {'l', -0.05, 0.5, -2.5, 1.25, 0};
    ovr_simulation *sim = with_dent(&hot, 6, &f);
    const ovr_observation *o = ovr_simulation_observation(sim);
    double sum = 0, count = 0, dT = D_of(sim) * steps;
    while (o->T < 2 - dT / 2) {
        step(sim, dT);
        sum += o->energy_defect * o->energy_defect;
        count++;
    }
    *temperature = o->T_max_rise;
    ovr_simulation_free(sim);
    return sqrt(sum / count);
}

/* The film as it ends a step is that which was heated in it, to 3e-4 ph: of oil
 * that is pressed so by b/um/30 a thousandth of all power.  (Of the guess alone
 * it is off by O(dT): 1.6e-3 in steps of 4 D.) */
TEST(energy_is_conserved)
{
    double T[3], off[3];
    for (int k = 0; k < 3; k++)
        off[k] = defect(4. / (1 << k), &T[k]);
    print_message("steps of 4 D, 2 D, D: defect %.2e %.2e %.2e, T %.4f %.4f "
                  "%.4f\n",
                  off[0], off[1], off[2], T[0], T[1], T[2]);
    for (int k = 0; k < 3; k++)
        assert_true(off[k] < 3e-3); /* heat against the power of forces */
    assert_true(fabs(T[2] / T[1] - 1) < 0.03);
}

/* -------------------------------------------------------------- stability */

/* A contact at 1.65 GPa with a strongly skewed flow remains steady. In an
 * earlier version, which used the skewed flow of the initial guess, short
 * pressure waves doubled in each step up to 0.2 p_h. */
static void stays(int level)
{
    char text[700];
    ovr_error err = {0};
    snprintf(text, sizeof text,
             "[contact]\nradius = 12.7 mm\nM = 115.1\nL = 6.572\n"
             "modulus = 226 GPa\nslide_to_roll = 1.77\n"
             "[lubricant]\nviscosity = 8.915 mPa.s\nalpha = 17 1/GPa\n"
             "p0 = 198 MPa\nz = 0.68\nrheology = carreau\n"
             "carreau_form = stress\ncarreau_n = 0.642\n"
             "carreau_stress = 2.975 MPa\n"
             "[heat]\nmodel = lobatto\npoints = 5\ntemperature = 80 degC\n"
             "[domain]\nlevel = %d\ninlet = -4\noutlet = 1.5\n"
             "[time]\nend = 1\nscheme = characteristic\n",
             level);
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    ovr_simulation *sim = setup ? ovr_setup_simulation(setup, NULL, &err)
                                : NULL;
    CHECK_OK(sim ? OVR_OK : OVR_BAD_INPUT, &err);
    const ovr_observation *o = ovr_simulation_observation(sim);
    steady(sim);
    double P = o->P_max, H = o->H_min, T = o->T_max_rise, off = 0, left = 0;
    while (o->T < 1) {
        step(sim, D_of(sim));
        off = fmax(off, fabs(o->P_max / P - 1));
        off = fmax(off, fabs(o->H_min / H - 1));
        off = fmax(off, fabs(o->T_max_rise / T - 1));
        left = fmax(left, fabs(o->energy_defect));
    }
    const ovr_statistics *all = ovr_simulation_statistics(sim);
    print_message("level %d: P, H or T moved by %.1e, energy closes to %.1e; "
                  "%.2f cycles a step\n",
                  level, off, left, (double)all->cycles / (double)all->steps);
    assert_true(off < 3e-3);
    assert_true(left < 1e-3);
    assert_int_equal(all->retries, 0);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
}

TEST(sliding_films_stay_steady)
{
    for (int level = 6; level <= 8; level++)
        stays(level);
}

/* ---------------------------------------------------------------- mirrors */

/* A dent on the one surface, then on the other that moves as fast: friction
 * turns its sign, temperatures change places. */
TEST(surfaces_swapped)
{
    test_hot hot[2] = {test_hot_make(20, 10, 0.8, 5e6, NULL),
                       test_hot_make(20, 10, -0.8, 5e6, NULL)};
    test_feature f = {'l', -0.05, 0.5, -2, 1.4, 0};
    ovr_simulation *sim[2];
    const ovr_observation *a, *b;
    for (int k = 0; k < 2; k++) {
        sim[k] = with_dent(&hot[k], 5, &f);
        for (int n = 0; n < 60; n++)
            step(sim[k], D_of(sim[k]));
    }
    a = ovr_simulation_observation(sim[0]);
    b = ovr_simulation_observation(sim[1]);
    CHECK_CLOSE(b->H_min, a->H_min, 1e-9);
    CHECK_CLOSE(b->F_slide, -a->F_slide, 1e-8);
    CHECK_CLOSE(b->F_1, a->F_2, 1e-8);
    CHECK_CLOSE(b->T_1_max_rise, a->T_2_max_rise, 1e-8);
    CHECK_CLOSE(b->T_2_max_rise, a->T_1_max_rise, 1e-8);
    CHECK_CLOSE(b->heat_flow_1, a->heat_flow_2, 1e-8);
    CHECK_CLOSE(b->heat_flow_2, a->heat_flow_1, 1e-8);
    assert_true(fabs(a->T_1_max_rise - a->T_2_max_rise) > 0.1);
    ovr_simulation_free(sim[0]);
    ovr_simulation_free(sim[1]);
}

/* ---------------------------------------------------------------- schemes */

/* Along the characteristic the film is another discretization of the same. */
TEST(schemes_agree)
{
    static const ovr_scheme schemes[] = {OVR_UPSTREAM2, OVR_CHARACTERISTIC};
    test_hot hot = test_hot_make(20, 10, 0.8, 5e6, NULL);
    test_feature f = {'l', -0.05, 1, -2, 1.4, 0};
    ovr_observation seen[2];
    for (int k = 0; k < 2; k++) {
        ovr_options options = test_options();
        options.level = 6;
        options.scheme = schemes[k];
        ovr_simulation *sim = test_hot_made(&hot, &options);
        ovr_simulation_surface(sim, test_feature_heights, &f);
        ovr_simulation_moving(sim, f.u);
        steady(sim);
        for (int n = 0; n < 120; n++)
            step(sim, D_of(sim));
        seen[k] = *ovr_simulation_observation(sim);
        ovr_simulation_free(sim);
    }
    print_message("H_min %.6f and %.6f, mu %.6f and %.6f, T %.4f and %.4f\n",
                  seen[0].H_min, seen[1].H_min, seen[0].mu_slide,
                  seen[1].mu_slide, seen[0].T_max_rise, seen[1].T_max_rise);
    CHECK_CLOSE(seen[1].H_min, seen[0].H_min, 1e-2);
    CHECK_CLOSE(seen[1].mu_slide, seen[0].mu_slide, 1e-3);
    CHECK_CLOSE(seen[1].T_max_rise, seen[0].T_max_rise, 2e-3);
}

/* Oil that is conserved in cavities leaves a flooded film and its temperatures
 * as they are, and is conserved with heat. */
TEST(conserved_oil)
{
    test_hot hot = test_hot_make(20, 10, 0.8, 5e6, NULL);
    test_feature f = {'l', -0.05, 1, -2, 1.4, 0};
    ovr_observation seen[2];
    for (int k = 0; k < 2; k++) {
        ovr_options options = test_options();
        options.level = 5;
        options.cavitation = k ? OVR_CAVITATION_CONSERVING
                               : OVR_CAVITATION_REYNOLDS;
        ovr_simulation *sim = test_hot_made(&hot, &options);
        ovr_simulation_surface(sim, test_feature_heights, &f);
        ovr_simulation_moving(sim, f.u);
        steady(sim);
        for (int n = 0; n < 60; n++) {
            step(sim, D_of(sim));
            seen[k] = *ovr_simulation_observation(sim);
            assert_true(!k || fabs(seen[k].mass_defect) < 1e-3);
        }
        ovr_simulation_free(sim);
    }
    CHECK_CLOSE(seen[1].H_min, seen[0].H_min, 1e-4);
    CHECK_CLOSE(seen[1].F_slide, seen[0].F_slide, 1e-4);
    CHECK_CLOSE(seen[1].T_max_rise, seen[0].T_max_rise, 1e-4);
    CHECK_CLOSE(seen[1].starvation_factor, 1, 0.2);
}

/* -------------------------------------------------------------- isothermal */

TEST(isothermal_limit)
{
    ovr_heat_form form = test_heat_form();
    test_feature f = {'l', -0.05, 0.5, -2, 1.25, 0};
    ovr_options options = test_options();
    ovr_error err = {0};
    form.oil.heat_capacity = 1e30;
    test_hot hot = test_hot_make(20, 10, 0.5, 5e6, &form);
    ovr_simulation *sim = with_dent(&hot, 5, &f);
    options.level = 5;
    ovr_simulation *cold = ovr_simulation_create(&hot.contact, &hot.oil,
                                                 &options, NULL, &err);
    ovr_simulation_surface(cold, test_feature_heights, &f);
    ovr_simulation_moving(cold, f.u);
    steady(cold);
    for (int k = 0; k < 60; k++) {
        step(sim, D_of(sim));
        step(cold, D_of(sim));
    }
    const ovr_observation *a = ovr_simulation_observation(sim),
                          *b = ovr_simulation_observation(cold);
    CHECK_CLOSE(a->H_min, b->H_min, 1e-9);
    CHECK_CLOSE(a->H_cen, b->H_cen, 1e-9);
    CHECK_CLOSE(a->F_roll, b->F_roll, 1e-9);
    CHECK_CLOSE(a->mass_flow, b->mass_flow, 1e-9);
    CHECK_NEAR(a->mass_balance, b->mass_balance, 1e-9);
    CHECK_NEAR(a->T_max_rise, 0, 1e-12);
    ovr_simulation_free(sim);
    ovr_simulation_free(cold);
}

/* --------------------------------------------------------------- restored */

static void same_bits(ovr_simulation *a, ovr_simulation *b)
{
    ovr_observation x = *ovr_simulation_observation(a),
                    y = *ovr_simulation_observation(b);
    size_t n = ovr_simulation_state(a)->n;
    assert_memory_equal(&x, &y, sizeof x);
    assert_memory_equal(ovr_simulation_state(a)->H, ovr_simulation_state(b)->H,
                        n * sizeof(double));
    for (int j = 0; j < 5; j++)
        assert_memory_equal(a->heated->T[j], b->heated->T[j],
                            n * sizeof(double));
}

TEST(resumes_alike)
{
    test_hot hot = test_hot_make(20, 10, 0.5, 5e6, NULL);
    test_feature f = {'l', -0.05, 0.5, -2, 1.25, 0};
    ovr_simulation *sim = with_dent(&hot, 5, &f);
    ovr_simulation *other = test_hot_simulation(&hot, 5);
    for (int k = 0; k < 40; k++)
        step(sim, D_of(sim) * (k % 7 ? 1 : 0.5));
    ovr_simulation_surface(other, test_feature_heights, &f);
    ovr_simulation_moving(other, f.u);
    test_copy_state(sim, other);
    same_bits(sim, other);
    for (int k = 0; k < 20; k++) {
        step(sim, D_of(sim));
        step(other, D_of(sim));
        same_bits(sim, other);
    }
    ovr_simulation_free(sim);
    ovr_simulation_free(other);
}
