/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Chooses the window and the layers of a plastic body and reports their cost
 * before a run. */
#include <math.h>
#include <stdio.h>

#include "base/error.h"
#include "case/setup.h"
#include "physics/plastic/bodies.h"
#include "physics/plastic/plastic.h"
#include "stress/stress.h"

static const double margin = 1, min_window = 3, max_points = 65536;

/* Window in b, relative to the reference point of the material. */
typedef struct window {
    double from, to;
} window;

/* Finds the window of the case, or that of the features, and checks the number
 * of its points. */
static ovr_status find_window(const ovr_setup *setup,
                              const ovr_material_range *range, window *found,
                              ovr_error *err)
{
    const ovr_plastic_setup *how = ovr_setup_plastic(setup);
    const bool given = !isnan(how->from);
    *found = given ? (window){how->from, how->to}
                   : (window){range->from + margin, range->to - margin};
    double length = found->to - found->from, largest = max_points * setup->mesh;
    if (length <= largest)
        return OVR_OK;
    if (given)
        return ovr_fail_about(err, "plastic.window",
                              "window: %g to %g b has too many points of the "
                              "mesh size %.4g b: must be %.4g b long at most "
                              "(%.0f points)",
                              found->from, found->to, setup->mesh, largest,
                              max_points);
    return ovr_fail_about(err, "plastic",
                          "[plastic]: the features need a window of %.4g b, "
                          "which is too long for the mesh size %.4g b; set "
                          "plastic.window = FROM, TO, at most %.4g b long",
                          length, setup->mesh, largest);
}

ovr_status ovr_plastic_check(const ovr_setup *setup, ovr_error *err)
{
    const ovr_plastic_setup *how = ovr_setup_plastic(setup);
    for (int k = 0; k < 2; k++) {
        ovr_stress_plan plan;
        window found;
        if (how->surfaces >> k & 1 &&
            !ovr_stress_planned(setup, k + 1, ovr_stress_sight_of(setup), &plan,
                                NULL) &&
            find_window(setup, &plan.range, &found, err))
            return OVR_BAD_INPUT;
    }
    return OVR_OK;
}

ovr_status ovr_plastic_planned(const ovr_setup *setup, int k,
                               ovr_plastic_plan *plan, ovr_error *err)
{
    const ovr_plastic_setup *how = ovr_setup_plastic(setup);
    ovr_stress_plan *s = &plan->stress;
    window of;
    if (ovr_stress_planned(setup, k + 1, ovr_stress_sight_of(setup), s, err) ||
        find_window(setup, &s->range, &of, err))
        return OVR_BAD_INPUT;
    double middle = (of.from + of.to) / 2, D = setup->mesh;
    double length = fmax(of.to - of.from, min_window);
    plan->points = 256;
    while ((double)plan->points * D < length)
        plan->points *= 2;
    plan->mesh = D;
    plan->layers = (size_t)fmax(1, fmin(how->layers, floor(how->depth / D)));
    plan->first = (round(middle / D) - 0.5 * (double)plan->points) * D;
    return OVR_OK;
}

ovr_yielding_options ovr_plastic_options(const ovr_plastic_setup *how, int k,
                                         const ovr_plastic_plan *plan,
                                         const double *edge)
{
    return (ovr_yielding_options){.points = plan->points,
                                  .mesh = plan->mesh,
                                  .layers = plan->layers,
                                  .edge = edge,
                                  .poisson = plan->stress.range.poisson,
                                  .hardening = how->body[k].hardening,
                                  .iterations = how->iterations};
}

void ovr_plastic_edges(const ovr_plastic_setup *how,
                       const ovr_plastic_plan *plan, double *edge)
{
    double first = fmin(plan->mesh, how->depth / (double)plan->layers);
    ovr_yielding_layers(plan->layers, first, how->depth, edge);
}

/* ------------------------------------------------------- cost and report */

static double memory_of(const ovr_setup *setup, int k)
{
    const ovr_plastic_setup *how = ovr_setup_plastic(setup);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_plastic_plan plan;
    double bytes = 0;
    double *edge = ovr_arena_take(&arena, (size_t)how->layers + 1, sizeof *edge,
                                  NULL);
    if (edge && !ovr_plastic_planned(setup, k, &plan, NULL)) {
        ovr_plastic_edges(how, &plan, edge);
        const ovr_yielding_options o = ovr_plastic_options(how, k, &plan, edge);
        bytes = ovr_yielding_memory(&o) +
                8. * OVR_PLASTIC_STATE * (double)(plan.points * plan.layers);
    }
    ovr_arena_release(&arena);
    return bytes;
}

double ovr_plastic_memory(const void *form)
{
    const ovr_plastic_setup *how = form;
    double bytes = 0;
    for (int k = 0; k < 2; k++)
        if (how->surfaces >> k & 1)
            bytes += memory_of(how->setup, k);
    return bytes;
}

/* CPU time of one iteration of flow and equilibrium, measured at 1024 points.
 */
static double iteration_seconds(const ovr_plastic_plan *plan)
{
    return 2.5e-3 * (double)plan->points / 1024 *
           pow((double)plan->layers / 24, 2);
}

/* CPU time of tables, stresses in the window while it is in the contact, and
 * plastic flow. For a dent with raised rims in steel of .75 p_h about 6 % of
 * these steps have plastic flow, with four iterations each; fewer in harder
 * steel. */
double ovr_plastic_seconds(const void *form)
{
    const double flowing = 0.06, fields = 2e-4, tables = 60;
    const ovr_plastic_setup *how = form;
    const ovr_setup *setup = how->setup;
    double all = 0, dT = ovr_setup_step(setup);
    ovr_plastic_plan plan;
    for (int k = 0; k < 2; k++) {
        if (!(how->surfaces >> k & 1) ||
            ovr_plastic_planned(setup, k, &plan, NULL))
            continue;
        double distance = (double)plan.points * plan.mesh +
                          2 * OVR_PLASTIC_REACH;
        double steps = fmin(distance, setup->march->end) / dT;
        double once = iteration_seconds(&plan);
        all += tables * once + steps * fields * (double)plan.layers / 24 +
               steps * flowing * fmin(how->iterations, 4) * once;
    }
    return all;
}

static void describe_body(const ovr_setup *setup, int k, ovr_physics_line *line,
                          void *data)
{
    const ovr_plastic_setup *how = ovr_setup_plastic(setup);
    double Y = how->body[k].hardening.yield, ph = setup->contact->ph * 1e-6;
    double nu = ovr_setup_stress(setup)->poisson[k];
    char text[240], megapascals[40] = "", strain[40] = "unknown";
    ovr_plastic_plan plan;
    if (isfinite(ph))
        snprintf(megapascals, sizeof megapascals, " (%.4g MPa)", Y * ph);
    if (isfinite(how->body[k].strain))
        snprintf(strain, sizeof strain, "%.4g", 1 / how->body[k].strain);
    snprintf(
        text, sizeof text,
        "surface %d: yield stress Y = %.4g p_h%s, first yield of the smooth "
        "contact at %.4g p_h, shakedown limit %.4g p_h, E*/p_h %s",
        k + 1, Y, megapascals, ovr_first_yield(nu) * Y,
        ovr_shakedown_limit() * Y, strain);
    line(data, "plastic material", text);
    if (!setup->nodes || ovr_plastic_planned(setup, k, &plan, NULL))
        return;
    snprintf(
        text, sizeof text,
        "%zu points from %.3g to %.3g b about %s, %zu layers down to %.3g "
        "b; %.3g MB; about %.2g ms per iteration in plastic steps",
        plan.points, plan.first, plan.first + (double)plan.points * plan.mesh,
        plan.stress.feature ? plan.stress.feature : "X = 0", plan.layers,
        how->depth, memory_of(setup, k) / 1e6, 1e3 * iteration_seconds(&plan));
    line(data, "plastic window", text);
}

void ovr_plastic_describe(const ovr_physics_case *of, const void *form,
                          ovr_physics_line *line, void *data)
{
    const ovr_plastic_setup *how = form;
    (void)of;
    for (int k = 0; k < 2; k++)
        if (how->surfaces >> k & 1)
            describe_body(how->setup, k, line, data);
}
