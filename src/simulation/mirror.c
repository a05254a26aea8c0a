/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/mirror.h"

#include <math.h>

#include "base/error.h"
#include "contact/contact.h"
#include "contact/history.h"
#include "simulation/conflicts.h"
#include "simulation/physics.h"

static bool always(const ovr_options *o)
{
    (void)o;
    return true;
}

static void before_step(ovr_simulation *sim, void *own, double T)
{
    (void)own;
    double Cu = ovr_history_value(sim->histories.speed, T);
    sim->histories.backward = Cu < 0 || (sim->past.backward && !(Cu > 0));
    sim->histories.mirrored = sim->histories.backward &&
                              !sim->scheme->characteristic;
}

static void before_back(ovr_simulation *sim, void *own)
{
    (void)own;
    sim->histories.backward = sim->past.backward;
    sim->histories.mirrored = sim->histories.backward &&
                              !sim->scheme->characteristic;
}

/* The steady start has a wedge in every scheme. */
static void before_start(ovr_simulation *sim, void *own)
{
    (void)own;
    sim->histories.backward = ovr_history_begins_backward(sim->histories.speed);
    sim->histories.mirrored = sim->histories.backward;
}

/* The orientation of the solution becomes that of the past. */
static void begin(ovr_simulation *sim, void *own)
{
    (void)own;
    sim->past.backward = sim->histories.backward;
}

static void accepted(ovr_simulation *sim, void *own, double dT)
{
    (void)dT;
    begin(sim, own);
}

static void visit(ovr_simulation *sim, void *own, ovr_pieces *state)
{
    (void)own;
    OVR_SHOW(state, "backward", sim->past.backward);
}

void ovr_slide(ovr_simulation *sim, double T)
{
    double V = ovr_sliding(sim, T);
    sim->grids.fluid.sliding = sim->histories.mirrored ? -V : V;
}

static ovr_status check(const ovr_simulation *sim, const void *own,
                        ovr_error *err)
{
    const double X_a = sim->options.inlet, X_b = sim->options.outlet;
    (void)own;
    if (!ovr_history_reverses(sim->histories.speed))
        return OVR_OK;
    if (ovr_conflict_check(ovr_model_features_of(&sim->options) |
                               sim->physics.features |
                               ovr_model_feature_bit(OVR_MODEL_REVERSAL, true),
                           err))
        return OVR_BAD_INPUT;
    if (fabs(X_a + X_b) > 1e-12 * X_b)
        return ovr_fail_about(err, "outlet",
                              "domain [%g, %g]: a mean speed that reverses "
                              "needs a symmetric domain, for example [%g, %g]",
                              X_a, X_b, -fmax(-X_a, X_b), fmax(-X_a, X_b));
    return OVR_OK;
}

static const ovr_physics_in_solve in_solve = {
    .chosen = always, .begin = begin, .before_start = before_start};

static const ovr_physics_in_step in_step = {.check = check,
                                            .before_step = before_step,
                                            .accepted = accepted,
                                            .before_back = before_back,
                                            .visit = visit};

const ovr_physics ovr_physics_reversal = {
    .name = "reversal", .in_solve = &in_solve, .in_step = &in_step};

void ovr_mirror(size_t n, const double *from, double *to)
{
    for (size_t i = 0; i < n; i++)
        to[i] = from[n - 1 - i];
}

void ovr_nodes_read(const ovr_simulation *sim, const ovr_level *level,
                    const double *values, double *along_x)
{
    ovr_level_read(&sim->grids, level, values, along_x);
    if (!sim->histories.mirrored)
        return;
    /* values at half nodes, between i and i + 1 */
    bool between = values == level->f.flow && values;
    for (size_t i = 0, j = level->grid.n - 1 - between; i < j; i++, j--) {
        double left = along_x[i];
        along_x[i] = along_x[j];
        along_x[j] = left;
    }
}

void ovr_nodes_write(const ovr_simulation *sim, const ovr_level *level,
                     const double *along_x, double *values)
{
    double *image = ovr_work_take(sim);
    if (sim->histories.mirrored)
        ovr_mirror(level->grid.n, along_x, image);
    ovr_level_write(&sim->grids, level,
                    sim->histories.mirrored ? image : along_x, values);
    ovr_work_give(sim, image);
}
