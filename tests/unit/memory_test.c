/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory of a simulation: allocated once, small, and as announced. */
#include <math.h>

#include "physics/heat/heat.h"
#include "simulation/internal.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/hot.h"
#include "support/test.h"
#include "surface/surfaces.h"

typedef struct kind {
    int level;
    ovr_scheme scheme;
    ovr_smoother smoother;
    bool adaptive;
} kind;

static ovr_simulation *create(const kind *k, const ovr_allocator *allocator)
{
    ovr_error err;
    ovr_options options = test_options();
    test_contact t = test_contact_make(20, 10);
    options.level = k->level;
    options.scheme = k->scheme;
    options.smoother = k->smoother;
    ovr_simulation *sim = ovr_simulation_create(&t.contact, &t.lubricant,
                                                &options, allocator, &err);
    assert_non_null(sim);
    return sim;
}

/* A dent on one surface and roughness on the other. */
static ovr_surfaces *rough(const ovr_simulation *sim,
                           const ovr_allocator *allocator)
{
    ovr_error err;
    ovr_feature_form dent = ovr_feature_form_default();
    ovr_feature_form roughness = ovr_feature_form_default();
    ovr_roughness random = ovr_roughness_default();
    ovr_surfaces *s = ovr_surfaces_create(&sim->contact, NULL,
                                          sim->finest->grid.D, allocator, &err);
    assert_non_null(s);
    dent.shape = OVR_DENT;
    dent.depth = 0.05, dent.width = 0.5, dent.start = -1.5;
    roughness.shape = OVR_ROUGHNESS;
    roughness.surface = 2, roughness.start = 2;
    roughness.roughness = &random;
    random.Rq = 0.004, random.length = 8;
    random.rolloff = 1, random.shortest = 0.2;
    CHECK_OK(ovr_surfaces_add(s, &dent, &err), &err);
    CHECK_OK(ovr_surfaces_add(s, &roughness, &err), &err);
    return s;
}

/* A rough steady solution and a run allocate nothing. */
TEST(nothing_is_allocated_after_set_up)
{
    static const kind kinds[] = {{6, OVR_UPSTREAM1, OVR_LINE, false},
                                 {6, OVR_CHARACTERISTIC, OVR_LINE, false},
                                 {6, OVR_UPSTREAM2, OVR_HYBRID, false},
                                 {8, OVR_UPSTREAM2, OVR_LINE, false},
                                 {8, OVR_UPSTREAM2, OVR_LINE, true},
                                 {10, OVR_UPSTREAM2, OVR_LINE, false},
                                 {10, OVR_CHARACTERISTIC, OVR_LINE, true}};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        ovr_error err;
        test_faults faults;
        test_faults_init(&faults);
        ovr_simulation *sim = create(&kinds[k], &faults.hook);
        ovr_surfaces *surfaces = rough(sim, &faults.hook);
        ovr_march march = {.end = 30 * sim->finest->grid.D,
                           .adaptive = kinds[k].adaptive};
        long calls = faults.calls;
        ovr_simulation_surface(sim, ovr_surfaces_heights, surfaces);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        if (kinds[k].smoother == OVR_LINE) /* the others are for steady ones */
            CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
        assert_int_equal(faults.calls, calls);
        assert_true(kinds[k].smoother != OVR_LINE ||
                    ovr_simulation_statistics(sim)->steps > 1);
        ovr_simulation_free(sim);
        ovr_surfaces_free(surfaces);
        assert_int_equal(faults.live, 0);
    }
}

/* Bytes per node in overroll-theory(7), COST. */
static void is_as_stated(int level, double bytes)
{
    static const struct {
        int level;
        double bytes;
    } stated[] = {{8, 954}, {10, 653}, {14, 504}};
    for (size_t k = 0; k < sizeof stated / sizeof *stated; k++)
        if (level == stated[k].level)
            CHECK_CLOSE(bytes, stated[k].bytes, 0.01);
}

/* All levels and the past of a run together, as the allocator sees it; what
 * small grids take besides is the dense matrix and some pages.  Four work
 * arrays of the time loop are 32 bytes a node of it. */
TEST(a_node_takes_less_than_a_kilobyte)
{
    static const struct {
        ovr_scheme scheme;
        ovr_smoother smoother;
        double limit; /* bytes a node at level 8, and from level 10 on */
        double finer;
    } kinds[] = {{OVR_UPSTREAM2, OVR_LINE, 1000, 670},
                 {OVR_CHARACTERISTIC, OVR_LINE, 1050, 670},
                 {OVR_UPSTREAM2, OVR_HYBRID, 1100, 740}};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        for (int level = 8; level <= 14; level++) {
            test_faults faults;
            test_faults_init(&faults);
            ovr_simulation *sim = create(
                &(kind){level, kinds[k].scheme, kinds[k].smoother, false},
                &faults.hook);
            double n = (double)ovr_simulation_state(sim)->n;
            double announced = ovr_simulation_memory(&sim->options);
            print_message("level %d: %.0f bytes a node, %.0f announced\n",
                          level, faults.bytes / n, announced / n);
            assert_true(faults.bytes / n <
                        (level < 10 ? kinds[k].limit : kinds[k].finer));
            assert_true(announced == faults.bytes);
            if (kinds[k].scheme == OVR_CHARACTERISTIC)
                is_as_stated(level, faults.bytes / n);
            ovr_simulation_free(sim);
        }
}

/* What heat takes is counted, too. */
TEST(heat_is_announced)
{
    for (int points = 5; points <= 7; points += 2) {
        test_faults faults;
        ovr_error err = {0};
        ovr_heat_form form = test_heat_form();
        form.points = points;
        form.density_expands = points == 7;
        test_hot hot = test_hot_make(20, 10, 0.5, 5e6, &form);
        test_faults_init(&faults);
        ovr_simulation *sim = create(
            &(kind){10, OVR_UPSTREAM2, OVR_LINE, false}, &faults.hook);
        const ovr_options *options = ovr_simulation_options(sim);
        double before = faults.bytes;
        CHECK_OK(ovr_physics_add(sim, &ovr_physics_heat, &hot.heat, &err),
                 &err);
        ovr_simulation *counted = ovr_simulation_counted(options);
        double announced = -(double)counted->arena.bytes;
        CHECK_OK(ovr_physics_add(counted, &ovr_physics_heat, &hot.heat, &err),
                 &err);
        announced += (double)counted->arena.bytes;
        ovr_simulation_free(counted);
        print_message("%d points: %.0f bytes a node\n", points,
                      announced / (double)ovr_simulation_state(sim)->n);
        assert_true(announced == faults.bytes - before);
        CHECK_CLOSE(announced / (double)ovr_simulation_state(sim)->n,
                    points == 5 ? 1535 : 1735, 0.02);
        ovr_simulation_free(sim);
    }
}

/* Of levels that no machine here has memory for: counted, not taken. */
TEST(finer_levels_need_twice_the_memory)
{
    double before = 0;
    for (int level = 15; level < 24; level++) {
        ovr_options options = ovr_options_default();
        options.level = level;
        double bytes = ovr_simulation_memory(&options);
        if (before > 0 && isfinite(bytes))
            CHECK_CLOSE(bytes / before, 2, 0.05);
        before = bytes;
        if (level == 17)
            assert_true(isfinite(bytes));
    }
    assert_true(isinf(ovr_simulation_memory(&(ovr_options){.level = 99})));
}
