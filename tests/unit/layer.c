/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A physics that exists only in this test and shows that one record is
 * sufficient: a soft thin layer on body 1 on a rigid foundation (Winkler),
 * which wears under its load.
 *
 *     w_i = ... - c P_i        compliance c, local or distributed over a
 *                              length l, as e^(-(X/l)^2)
 *     t_i = ... + f P_i        friction by hysteresis f, heated by the power
 *                              -V f P_i
 *     ds/dT = k P,  S = ... - s   wear
 *
 * Its keys are in [layer]; without this section the physics is off. The
 * observed quantity is the maximum of s; the state is s at the nodes. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/rows.h"
#include "simulation/physics.h"
#include "simulation/quantity_row.h"

typedef struct layer_form {
    double compliance, spread, hysteresis, wear;
} layer_form;

typedef struct layer {
    layer_form given;
    double *worn;   /* s of the gap as it is */
    double *before; /* of the last time reached */
} layer;

/* --------------------------------------------------------------- the case */

static const ovr_parameter keys[] = {
    {"compliance", PLAIN(0, 100), "0", offsetof(layer_form, compliance), true,
     ALWAYS, "by how much of b^2/R it is pressed in by ph; 0: no layer"},
    {"spread", PLAIN(0, 10), "0", offsetof(layer_form, spread), true, ALWAYS,
     "length in b over which it gives way about what presses it"},
    {"hysteresis", PLAIN(0, 1), "0", offsetof(layer_form, hysteresis), true,
     ALWAYS, "its drag over the pressure"},
    {"wear", PLAIN(0, 1), "0", offsetof(layer_form, wear), true, ALWAYS,
     "depth that ph wears in b/um"},
};

static const ovr_section section = {
    .name = "layer", .help = "a soft layer on body 1", ROWS(keys)};

static ovr_status resolve(const ovr_physics_case *of, void *form, bool *on,
                          ovr_error *err)
{
    const layer_form *given = form;
    *on = given->compliance > 0;
    if (*on && of->options->order == 4)
        return ovr_fail_about(err, "compliance",
                              "a layer is of second order: order = 2 does");
    if (*on)
        of->options->order = 2;
    return OVR_OK;
}

static void describe(const ovr_physics_case *of, const void *form,
                     ovr_physics_line *line, void *data)
{
    const layer_form *given = form;
    char text[80];
    (void)of;
    snprintf(text, sizeof text, "%g b^2/R at ph", given->compliance);
    line(data, "layer on body 1", text);
}

/* ----------------------------------------------------------- its simulation */

static ovr_status take(ovr_simulation *sim, const void *form, void **own,
                       ovr_error *err)
{
    layer *l = ovr_arena_take(&sim->arena, 1, sizeof *l, err);
    size_t n = sim->finest->grid.n;
    if (!l)
        return OVR_NO_MEMORY;
    *own = l;
    l->given = *(const layer_form *)form;
    l->worn = ovr_arena_take(&sim->arena, n, sizeof *l->worn, err);
    l->before = ovr_arena_take(&sim->arena, n, sizeof *l->before, err);
    return l->worn && l->before ? OVR_OK : OVR_NO_MEMORY;
}

/* Of nodes X apart. */
static double spread_out(const void *data, double X, double D)
{
    const layer_form *given = data;
    double l = given->spread, x = X / l;
    return -given->compliance * D * exp(-x * x) / (l * sqrt(acos(-1.0)));
}

static void influence(const ovr_simulation *sim, void *own, ovr_influence *of)
{
    const layer_form *given = &((const layer *)own)->given;
    (void)sim;
    if (given->spread > 0)
        ovr_influence_add(
            of, (ovr_influence_part){.at = spread_out, .data = given});
    else
        of->compliance += given->compliance;
}

/* Linear between the nodes, nothing beyond them; it wears where it is in the
 * contact, and moves with neither surface. */
static void heights(const ovr_simulation *sim, const void *own, int surface,
                    double T, size_t n, const double *X, double *S)
{
    const double *worn = ((const layer *)own)->worn;
    const ovr_solution *now = &sim->now;
    (void)T;
    for (size_t i = 0; !surface && i < n; i++) {
        size_t after = ovr_node_after(now, X[i]);
        double part = (X[i] - now->X[after - 1]) / ovr_spacing(now, after);
        if (part >= 0 && part <= 1)
            S[i] -= worn[after - 1] + part * (worn[after] - worn[after - 1]);
    }
}

static void friction(ovr_simulation *sim, void *own, double *t)
{
    const double *P = sim->now.P;
    double hysteresis = ((const layer *)own)->given.hysteresis;
    for (size_t i = 0; i + 1 < sim->now.n; i++)
        t[i] += hysteresis * (P[i] + P[i + 1]) / 2;
}

/* The power of the drag where one surface slides on the other. */
static void warm(ovr_simulation *sim, void *own, double *apart, double *power)
{
    (void)apart;
    double hysteresis = ((const layer *)own)->given.hysteresis;
    double V = ovr_sliding(sim, ovr_simulation_state(sim)->T);
    for (size_t i = 0; i < sim->now.n; i++)
        power[i] -= V * hysteresis * sim->now.P[i];
}

static void forget(ovr_simulation *sim, void *own)
{
    layer *l = own;
    memset(l->worn, 0, sim->now.n * sizeof *l->worn);
    memset(l->before, 0, sim->now.n * sizeof *l->before);
}

/* By the pressure of the last time reached: what is worn at T is known before
 * the step to it. */
static void before_step(ovr_simulation *sim, void *own, double T)
{
    layer *l = own;
    double wear = l->given.wear * (T - sim->past.T[0]);
    for (size_t i = 0; i < sim->now.n; i++)
        l->worn[i] = l->before[i] + wear * sim->past.P[0][i];
}

static void accepted(ovr_simulation *sim, void *own, double dT)
{
    layer *l = own;
    (void)dT;
    memcpy(l->before, l->worn, sim->now.n * sizeof *l->worn);
}

static void before_back(ovr_simulation *sim, void *own)
{
    layer *l = own;
    memcpy(l->worn, l->before, sim->now.n * sizeof *l->worn);
}

static double deepest(const ovr_simulation *sim, const layer *l)
{
    double maximum = 0;
    for (size_t i = 0; i < sim->now.n; i++)
        maximum = fmax(maximum, l->worn[i]);
    return maximum;
}

/* ----------------------------------------------------------------- observed */

static const ovr_observable quantities[] = {
    OVR_NUMBER_ROW("worn_depth", "worn_depth", "worn_depth_m", HEIGHT, more[0],
                   1u << 20, "largest depth that is worn of the layer",
                   LABEL("worn depth"), LARGEST("worn_depth_max"),
                   EXTREME_REPORTED, MEAN("worn_depth_mean"), PASS(END))};

static void unknown(ovr_observation *o)
{
    o->more[0] = NAN;
}

static void observe(ovr_simulation *sim, void *own, ovr_observation *o)
{
    o->more[0] = deepest(sim, own);
}

static void review(const ovr_simulation *sim, const void *own,
                   ovr_physics_message *say, void *data)
{
    double worn = deepest(sim, own);
    char text[100];
    if (!(worn > 0))
        return;
    snprintf(text, sizeof text, "the layer is worn by %.3g at T = %.3g", worn,
             sim->state.T);
    say(data, true, text);
}

static void visit(ovr_simulation *sim, void *own, ovr_pieces *state)
{
    const layer *l = own;
    ovr_show(state, "worn", l->before, sim->now.n * sizeof *l->before);
}

static const ovr_physics_in_case in_case = {.section = &section,
                                            .sections = 1,
                                            .form = sizeof(layer_form),
                                            .resolve = resolve,
                                            .describe = describe,
                                            .node_seconds = 1e-6};

static const ovr_physics_in_solve in_solve = {
    .take = take, .influence = influence, .forget = forget, .heights = heights};

static const ovr_physics_in_step in_step = {.before_step = before_step,
                                            .accepted = accepted,
                                            .before_back = before_back,
                                            .visit = visit};

static const ovr_physics_in_output in_output = {.heat = warm,
                                                .friction = friction,
                                                .unknown = unknown,
                                                .observe = observe,
                                                .quantity = quantities,
                                                .quantities = 1,
                                                .review = review};

const ovr_physics test_layer = {.name = "a layer on body 1",
                                .bit = 1u << 20,
                                .in_case = &in_case,
                                .in_solve = &in_solve,
                                .in_step = &in_step,
                                .in_output = &in_output};
