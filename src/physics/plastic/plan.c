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

ovr_status ovr_plastic_planned(const ovr_setup *setup, int k,
                               ovr_plastic_plan *plan, ovr_error *err)
{
    const ovr_plastic_setup *how = ovr_setup_plastic(setup);
    ovr_stress_plan *s = &plan->stress;
    if (ovr_stress_planned(setup, k + 1, ovr_stress_sight_of(setup), s, err))
        return OVR_BAD_INPUT;
    double from = s->range.from + margin, to = s->range.to - margin;
    if (!isnan(how->from)) {
        from = how->from;
        to = how->to;
    }
    double middle = (from + to) / 2, length = fmax(to - from, min_window);
    double D = setup->mesh;
    plan->points = 256;
    while ((double)plan->points * D < length &&
           (double)plan->points < max_points)
        plan->points *= 2;
    if ((double)plan->points * D < length)
        return ovr_fail_about(err, "window",
                              "a window of %.3g b has more than %.0f points "
                              "on this grid; set plastic.window = FROM, TO",
                              length, max_points);
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
