/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions attached to a cycle are called at its ends in the order of
 * attachment, and values that they freeze in the equations of the finest level
 * are solved for. */
#include "support/test.h"

#include <math.h>
#include <string.h>

#include "simulation/internal.h"
#include "support/contact.h"

enum { LEVEL = 6, MAX = 64 };

typedef struct watcher {
    int count, level[MAX];
    ovr_cycle_end end[MAX];
    bool changes;
    double *shift; /* of the finest gap, in lanes */
} watcher;

static bool watch(void *data, ovr_hierarchy *grids, ovr_level *level,
                  ovr_cycle_end end)
{
    watcher *w = data;
    w->level[w->count] = level->number;
    w->end[w->count++] = end;
    if (end != OVR_AFTER_CYCLE || !w->changes)
        return false;
    w->changes = false;
    double *gap = grids->scratch[0];
    ovr_level_read(grids, level, level->f.gap, gap);
    for (size_t i = 0; i < level->grid.n; i++)
        gap[i] += 1e-3 * cos(0.1 * (double)i);
    ovr_level_write(grids, level, gap, level->f.gap);
    return true;
}

static ovr_simulation *solved(void)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.level = LEVEL;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    return sim;
}

/* V-cycle: down to the bottom, up again, once at the end. */
TEST(ends_come_in_order)
{
    watcher w = {0};
    ovr_attached attached = {watch, &w, NULL};
    ovr_simulation *sim = solved();
    ovr_cycling how = ovr_simulation_cycling(sim, 0);
    int depth = LEVEL - how.bottom;
    how.attached = &attached;
    ovr_cycle(&sim->grids, sim->finest, how);
    assert_int_equal(w.count, 2 * depth + 1);
    for (int k = 0; k < depth; k++) {
        assert_int_equal(w.level[k], LEVEL - k);
        assert_int_equal(w.end[k], OVR_BEFORE_RESTRICTION);
        assert_int_equal(w.level[depth + k], how.bottom + 1 + k);
        assert_int_equal(w.end[depth + k], OVR_AFTER_CORRECTION);
    }
    assert_int_equal(w.level[2 * depth], LEVEL);
    assert_int_equal(w.end[2 * depth], OVR_AFTER_CYCLE);
    ovr_simulation_free(sim);
}

/* A cycle with an observer that changes nothing gives the same bits as without.
 */
TEST(watching_changes_nothing)
{
    watcher w = {0};
    ovr_attached attached = {watch, &w, NULL};
    ovr_simulation *a = solved(), *b = solved();
    ovr_cycling how = ovr_simulation_cycling(a, 0);
    ovr_cycle(&a->grids, a->finest, how);
    how.attached = &attached;
    ovr_cycle(&b->grids, b->finest, how);
    ovr_simulation_read(a);
    ovr_simulation_read(b);
    assert_memory_equal(a->now.P, b->now.P, a->finest->grid.n * sizeof(double));
    assert_memory_equal(a->now.H, b->now.H, a->finest->grid.n * sizeof(double));
    ovr_simulation_free(b);
    ovr_simulation_free(a);
}

static void heights(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data, (void)T, (void)X;
    for (size_t i = 0; i < n; i++)
        S[i] = -1e-3 * cos(0.1 * (double)i);
}

/* A gap that is changed at the end of a cycle: film and residual are those of
 * the new gap, and the cycles that follow end in the solution of a surface
 * that is formed so from the start. */
TEST(attached_functions_are_solved_for)
{
    watcher w = {.changes = true};
    ovr_attached attached = {watch, &w, NULL};
    ovr_error err = {0};
    ovr_simulation *sim = solved();
    ovr_cycling how = ovr_simulation_cycling(sim, 0);
    ovr_options o = *ovr_simulation_options(sim);
    ovr_simulation *formed = test_simulation(20, 10, &o);
    how.attached = &attached;
    ovr_cycle(&sim->grids, sim->finest, how);
    assert_true(ovr_cycle_defect(&sim->grids, sim->finest).imbalance > 1e-4);
    for (int k = 0; k < 12; k++) {
        w.count = 0;
        ovr_cycle(&sim->grids, sim->finest, how);
    }
    assert_true(ovr_cycle_defect(&sim->grids, sim->finest).imbalance < 1e-9);
    ovr_simulation_surface(formed, heights, NULL);
    CHECK_OK(ovr_simulation_steady(formed, &err), &err);
    ovr_simulation_read(sim);
    for (size_t i = 0; i < sim->finest->grid.n; i++) {
        CHECK_NEAR(sim->now.P[i], formed->now.P[i], 1e-6);
        CHECK_NEAR(sim->now.H[i], formed->now.H[i], 1e-8);
    }
    ovr_simulation_free(formed);
    ovr_simulation_free(sim);
}
