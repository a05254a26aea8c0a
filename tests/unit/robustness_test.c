/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solutions that cannot converge are never reported as converged, and the
 * message names the reason. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/case.h"
#include "support/contact.h"
#include "support/mass.h"
#include "support/test.h"

static ovr_status steady(double M, double L, int level, int coarsest,
                         ovr_error *err)
{
    ovr_options o = test_options();
    o.level = level;
    o.coarsest_level = coarsest;
    ovr_simulation *sim = test_simulation(M, L, &o);
    ovr_status status = ovr_simulation_steady(sim, err);
    const ovr_observation *seen = ovr_simulation_observation(sim);
    assert_int_equal(seen->converged, status == OVR_OK);
    if (!status)
        assert_true(seen->H_min > 0 && seen->residual >= 0);
    ovr_simulation_free(sim);
    return status;
}

/* The level that the message names is enough. */
TEST(thin_films_name_a_level)
{
    static const double contacts[][2] = {{900, 5}, {650, 0.3}};
    for (size_t k = 0; k < 2; k++) {
        ovr_error err = {0};
        double M = contacts[k][0], L = contacts[k][1];
        CHECK_STATUS(steady(M, L, 6, 0, &err), OVR_IMPOSSIBLE, &err);
        CHECK_ERROR(&err, OVR_IMPOSSIBLE, "too thin for the grid");
        const char *level = strstr(err.message, "; level ");
        assert_non_null(level);
        CHECK_OK(steady(M, L, atoi(level + 8), 0, &err), &err);
    }
}

/* A spike of 5 p_h inside one mesh, which cycles with the logarithmic mean do
 * not find.  The film at X = 0 is that of the coarser level. */
TEST(steep_spikes_are_found_by_the_gap)
{
    double H[2];
    for (int k = 0; k < 2; k++) {
        ovr_error err = {0};
        ovr_options o = test_options();
        o.level = 9 + k;
        o.inlet = o.outlet = NAN;
        test_contact t = test_contact_make(5, 15);
        t.lubricant.density_law = OVR_INCOMPRESSIBLE;
        t.lubricant.viscosity_law = OVR_BARUS;
        ovr_simulation *sim = ovr_simulation_create(&t.contact, &t.lubricant,
                                                    &o, NULL, &err);
        assert_non_null(sim);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        H[k] = ovr_simulation_observation(sim)->H_cen;
        ovr_simulation_free(sim);
    }
    CHECK_CLOSE(H[1], H[0], 3e-4); /* the error of level 9 */
}

/* Newton alone once stopped at 1e-8, above what such a grid is to reach. */
TEST(one_grid_is_enough)
{
    for (int level = 1; level <= 3; level++)
        for (double M = 0.5; M < 6; M *= 1.01) {
            ovr_error err = {0};
            CHECK_OK(steady(M, 10, level, 0, &err), &err);
        }
}

/* The discrete equations have solutions with a negative film; a residual that
 * adds up to less than nothing once passed for converged. */
TEST(negative_film_is_no_solution)
{
    ovr_error err = {0};
    CHECK_STATUS(steady(937, 1.76, 6, 6, &err), OVR_IMPOSSIBLE, &err);
}

/* If the load was increased in steps, the reported levels are those with the
 * full load: each film thickness is near the last one. */
TEST(levels_are_of_the_whole_load)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    int count;
    o.level = 10;
    ovr_simulation *sim = test_simulation(300, 3, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_refinement *r = ovr_simulation_refinements(sim, &count);
    assert_true(count > 0 && r[count - 1].level == 10);
    for (int k = 0; k < count; k++)
        CHECK_CLOSE(r[k].H_cen, ovr_simulation_observation(sim)->H_cen, 0.15);
    ovr_simulation_free(sim);
}

static void wall(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data;
    for (size_t i = 0; i < n; i++)
        S[i] = T * 40 * exp(-100 * X[i] * X[i]);
}

/* A wall grows through the film: whatever happens, no NaN, and the state of
 * before the step. */
TEST(what_cannot_be_is_taken_back)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    ovr_march march = {.end = 4};
    o.level = 5;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    ovr_simulation_surface(sim, wall, NULL);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_status status = ovr_simulation_march(sim, &march, &err);
    const ovr_state *s = ovr_simulation_state(sim);
    assert_true(status == OVR_IMPOSSIBLE || status == OVR_NOT_CONVERGED);
    assert_true(strstr(err.message, " T = ") != NULL);
    for (size_t i = 0; i < s->n; i++)
        assert_true(isfinite(s->P[i]) && s->H[i] > 0);
    assert_true(s->T < 4);
    ovr_simulation_free(sim);
}

/* A small sample of make verify's mass test. */
TEST(random_cases)
{
    test_statistics s = test_mass("steady", test_steady_case, 1, 40);
    assert_int_equal(s.unnamed + s.not_numbers, 0);
    s = test_mass("transient", test_transient_case, 1, 2);
    assert_int_equal(s.gave_up + s.not_numbers, 0);
    assert_true(s.worst_marked <= 1);
}

/* Two steps of each kind of memory that a simulation takes. */
#define SHORT "[domain]\nlevel = 4\n[time]\nend = 0.2\nstep = 0.1\n"
#define DENT                                                                   \
    "[feature dent]\nshape = dent\ndepth = 0.05\nwidth = 0.5\nstart = -1\n"
#define METAL                                                                  \
    "[contact]\nhertz_pressure = 0.7 GPa\nradius = 12 mm\n"                    \
    "mean_speed = 3 m/s\nslide_to_roll = 0.2\nmodulus = 226 GPa\n"             \
    "[lubricant]\nviscosity = 40 mPa.s\nalpha = 18 1/GPa\n"

static const char *const kinds[] = {
    "[contact]\nM = 20\nL = 10\n" SHORT "scheme = characteristic\n" DENT
    "[load]\nhistory = ramp\nto = 1.1\n"
    "[speed]\nhistory = table\nfile = speed.txt\n",
    "[contact]\nM = 20\nL = 10\n" SHORT DENT,
    "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 6\nrefine = spike\n",
    METAL SHORT "[heat]\nmodel = lobatto\ntemperature = 80 degC\n",
    METAL SHORT "[cavitation]\nmodel = conserving\n[supply]\nmodel = film\n"
                "thickness_1 = 1 um\nthickness_2 = 1 um\n",
    METAL SHORT "[boundary]\nlaw = exponential\nRq = 0.1 um\nslope = 0.05\n"
                "friction = 0.12\n",
    METAL SHORT "[strip]\nwidth = 1\n" DENT};

/* From the case to the end of the run. */
typedef struct attempted {
    const char *folder, *text;
} attempted;

static ovr_status run_with(void *data, const ovr_allocator *hook,
                           ovr_error *err)
{
    const attempted *a = data;
    ovr_simulation *sim = NULL;
    ovr_setup *setup = NULL;
    ovr_case *c = ovr_case_read_text(a->text, "dent.ini", a->folder, hook, err);
    if (c)
        setup = ovr_case_resolve(c, hook, err);
    if (setup)
        sim = ovr_setup_simulation(setup, hook, err);
    ovr_status status = sim ? ovr_simulation_steady(sim, err) : err->status;
    if (!status)
        status = ovr_simulation_march(sim, setup->march, err);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return status;
}

TEST_IN_FOLDER(runs_survive_failing_allocations)
{
    test_write_text(test_path(*state, "speed.txt"), "0 1\n1 1.2\n2 1\n");
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        attempted a = {*state, kinds[k]};
        long taken = test_every_allocation(run_with, &a);
        print_message("    %zu: %ld allocations\n", k, taken);
        assert_true(taken >= 8);
    }
}
