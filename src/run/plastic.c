/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bodies that yield under a run: before the step to T their material flows by
 * the film of the last time reached (yielding.c), and the gap of the step has
 * what that did to the surface:
 *
 *     S = ... - w E'/(4 E*),  at xi = X - X_0 - U(T)
 *
 * explicit, so that a step's film and its strains are solved one after the
 * other; the stresses at the material points by the material history's shift of
 * the nodes (stress/field.c), the profile between points by Lagrange's cubic.
 * Only where the window is under the contact, and a layer's stress comes near
 * yield on the nodes that its depth needs, are all of its points looked at.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "case/setup.h"
#include "run/forms.h"
#include "run/internal.h"
#include "run/plastic.h"
#include "simulation/quantity_row.h"
#include "stress/cubic.h"
#include "stress/field.h"
#include "stress/stress.h"
#include "surface/surfaces.h"

enum { BODIES = 2, STATE = OVR_PLASTIC_STATE };

/* Elastic stresses are looked at so far from the middle of the contact. */
static const double reach = 2;

/* ------------------------------------------------------------------ window */

static const double margin = 1, min_window = 3, max_points = 65536;

static ovr_status make_plan(const ovr_setup *setup, int k,
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
                              "a window of %.3g b has more than %.0f points on "
                              "this mesh: give [plastic] window FROM, TO",
                              length, max_points);
    plan->mesh = D;
    plan->layers = (size_t)fmax(1, fmin(how->layers, floor(how->depth / D)));
    plan->first = (round(middle / D) - 0.5 * (double)plan->points) * D;
    return OVR_OK;
}

static ovr_yielding_options options_of(const ovr_plastic_setup *how, int k,
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

static void fill_edges(const ovr_plastic_setup *how,
                       const ovr_plastic_plan *plan, double *edge)
{
    double first = fmin(plan->mesh, how->depth / (double)plan->layers);
    ovr_yielding_layers(plan->layers, first, how->depth, edge);
}

/* Takes the features as they come to the contact, fully grown. */
static void find_shape(const ovr_plastic *p, ovr_yielding_body *b, double *X)
{
    const ovr_setup *s = p->setup;
    size_t count = s->surfaces ? ovr_surfaces_count(s->surfaces) : 0;
    double T = 0;
    for (size_t k = 0; k < count; k++)
        if (ovr_surfaces_info(s->surfaces, k).grows)
            T = s->march->end;
    double at = b->plan.range.reference + ovr_stress_way(s, &b->plan, T);
    for (size_t i = 0; i < b->points; i++) {
        X[i] = at + b->first + (double)i * b->mesh;
        b->shape[i] = 0;
    }
    if (count)
        ovr_surfaces_heights(s->surfaces, T, b->points, X, b->shape);
}

static ovr_status make_body(ovr_plastic *p, int k, const ovr_simulation *sim,
                            ovr_error *err)
{
    ovr_yielding_body *b = &p->body[k];
    const ovr_allocator *allocator = &sim->arena.allocator;
    ovr_plastic_plan plan;
    if (make_plan(p->setup, k, &plan, err))
        return OVR_BAD_INPUT;
    size_t n = plan.points, layers = plan.layers;
    b->plan = plan.stress;
    b->points = n;
    b->layers = layers;
    b->first = plan.first;
    b->mesh = plan.mesh;
    b->edge = ovr_arena_take(&p->arena, layers + 1, sizeof(double), err);
    b->z = ovr_arena_take(&p->arena, layers, sizeof(double), err);
    b->kept = ovr_arena_take(&p->arena, STATE * n * layers, sizeof(double),
                             err);
    b->shown = ovr_arena_take(&p->arena, n, sizeof(double), err);
    b->shape = ovr_arena_take(&p->arena, n, sizeof(double), err);
    double *X = ovr_arena_take(&p->arena, n, sizeof(double), err);
    if (b->plan.options.traction)
        b->Q = ovr_arena_take(&p->arena, b->plan.options.nodes, sizeof(double),
                              err);
    if (!b->edge || !b->z || !b->kept || !b->shown || !b->shape || !X ||
        (b->plan.options.traction && !b->Q))
        return OVR_NO_MEMORY;
    fill_edges(p->how, &plan, b->edge);
    for (size_t j = 0; j < layers; j++)
        b->z[j] = (b->edge[j] + b->edge[j + 1]) / 2;
    ovr_stress_options o = b->plan.options;
    o.from = -reach;
    o.to = reach;
    o.depth_min = b->z[0];
    o.depth_max = b->z[layers - 1];
    o.layers = NULL;
    b->field = ovr_stress_create_at(&o, layers, b->z, allocator, err);
    if (!b->field)
        return OVR_NO_MEMORY;
    find_shape(p, b, X);
    const ovr_yielding_options y = options_of(p->how, k, &plan, b->edge);
    b->y = ovr_yielding_create(&y, allocator, err);
    return b->y ? OVR_OK : OVR_NO_MEMORY;
}

/* ----------------------------------------------------------- the two states */

static size_t bytes_of(const ovr_yielding_body *b)
{
    return STATE * b->points * b->layers * sizeof *b->kept;
}

static void keep(ovr_yielding_body *b)
{
    size_t a = STATE * b->points;
    for (size_t j = 0; b->changed && j < b->layers; j++)
        memcpy(b->kept + j * a, ovr_yielding_strains(b->y, j),
               a * sizeof *b->kept);
    b->work = b->work_now;
    b->left = b->left_now;
    b->changed = false;
}

static void show(const ovr_plastic *p, int k)
{
    const ovr_yielding_body *b = &p->body[k];
    const double *w = ovr_yielding_sinking(b->y);
    for (size_t i = 0; i < b->points; i++)
        b->shown[i] = p->how->body[k].softness * w[i];
}

/* Goes back to what is kept; the profile of an earlier run stays where it
 * changes between passes alone. */
static void go_back(ovr_plastic *p, int k, bool profile)
{
    ovr_yielding_body *b = &p->body[k];
    size_t a = STATE * b->points;
    for (size_t j = 0; j < b->layers; j++)
        memcpy(ovr_yielding_strains(b->y, j), b->kept + j * a,
               a * sizeof *b->kept);
    ovr_yielding_settle(b->y);
    b->work_now = b->work;
    b->left_now = b->left;
    b->changed = false;
    if (profile)
        show(p, k);
}

/* NOLINTBEGIN(bugprone-macro-parentheses): a name of a variable */
#define EACH_BODY(p, k)                                                        \
    for (int k = 0; k < BODIES; k++)                                           \
        if ((p)->body[k].y)
/* NOLINTEND(bugprone-macro-parentheses) */

static ovr_status make_ready(ovr_plastic *p, const ovr_simulation *sim,
                             ovr_error *err)
{
    p->P = ovr_arena_take(&p->arena, sim->maximum, sizeof *p->P, err);
    if (!p->P)
        return OVR_NO_MEMORY;
    for (int k = 0; k < BODIES; k++) {
        if (!(p->how->surfaces >> k & 1))
            continue;
        if (make_body(p, k, sim, err) ||
            (p->how->initial &&
             ovr_plastic_read(p->how->initial, p, &p->body[k], err)))
            return err ? err->status : OVR_BAD_INPUT;
        go_back(p, k, true);
    }
    return OVR_OK;
}

/* -------------------------------------------------------------------- flow */

/* Node i of the fields is point i - off of the window, the nodes being moved by
 * `shift` meshes. */
typedef struct place {
    long off;
    double shift;
} place;

static place find_place(const ovr_plastic *p, const ovr_yielding_body *b,
                        double T)
{
    double X0 = b->plan.range.reference + b->first +
                ovr_stress_way(p->setup, &b->plan, T);
    double t = (X0 - b->field->start) / b->mesh, whole = floor(t + 1e-9);
    return (place){(long)whole, fmax(0, t - whole)};
}

static ovr_in_plane at_node(const ovr_stress_row *row, size_t i)
{
    return (ovr_in_plane){(double)row->mean[2 * i], (double)row->shear[2 * i],
                          (double)row->shear[2 * i + 1]};
}

/* Nodes of a row that are points of the window. */
static bool nodes_within(const ovr_yielding_body *b, const ovr_stress_row *row,
                         place at, size_t *first, size_t *last)
{
    long step = 1L << row->level, n = (long)b->points;
    long from = at.off > 0 ? (at.off + step - 1) / step : 0;
    long to = at.off + n - 1 < 0 ? -1 : (at.off + n - 1) / step;
    long end = (long)floor((reach - row->start) / row->step);
    if (to > end)
        to = end;
    if (to > (long)row->count - 1)
        to = (long)row->count - 1;
    *first = (size_t)from;
    *last = to < 0 ? 0 : (size_t)to;
    return from <= to;
}

/* True if any point of the layer comes near yield. */
static bool comes_near(const ovr_yielding_body *b, size_t j, place at)
{
    const double near = 0.95;
    ovr_stress_row row = ovr_stress_at(b->field, j);
    size_t first, last;
    if (!nodes_within(b, &row, at, &first, &last))
        return false;
    for (size_t i = first; i <= last; i++) {
        size_t point = (size_t)((long)(i << row.level) - at.off);
        if (ovr_yielding_is_near(b->y, j, point, at_node(&row, i), near))
            return true;
    }
    return false;
}

static ovr_status load_layer(const ovr_yielding_body *b, size_t j, place at,
                             ovr_layer_load *load)
{
    ovr_stress_row row;
    size_t first, last, bytes = b->points * sizeof(float);
    if (ovr_stress_at_every_node(b->field, j, &row, NULL))
        return OVR_NO_MEMORY;
    memset(load->h, 0, bytes);
    memset(load->d, 0, bytes);
    memset(load->tau, 0, bytes);
    nodes_within(b, &row, at, &first, &last);
    for (size_t i = first; i <= last; i++) {
        size_t point = (size_t)((long)i - at.off);
        load->h[point] = row.mean[2 * i];
        load->d[point] = row.shear[2 * i];
        load->tau[point] = row.shear[2 * i + 1];
    }
    return OVR_OK;
}

/* Pressures between 0 and P_max without traction make no shear stress in the
 * plane above P_max/pi (theirs is a quarter turn of the half plane), no mean
 * stress above P_max, and so no von Mises stress above
 * P_max sqrt(3/pi^2 + (1 - 2 nu)^2); to a residual stress it adds its
 * own von Mises stress at most. */
static bool yields_by(const ovr_plastic *p, int k, double maximum)
{
    const ovr_yielding_body *b = &p->body[k];
    double nu = b->plan.range.poisson, pi = acos(-1.0);
    double bound = sqrt(3 / (pi * pi) + (1 - 2 * nu) * (1 - 2 * nu));
    return b->Q || maximum * bound > ovr_yielding_reserve(b->y);
}

static double largest(const ovr_plastic *p, size_t n)
{
    double maximum = 0;
    for (size_t i = 0; i < n; i++)
        maximum = p->P[i] > maximum ? p->P[i] : maximum;
    return maximum;
}

/* Lets the body flow under the pressure of the time T. */
static void flow(const ovr_plastic *p, int k, double T)
{
    ovr_yielding_body *b = &((ovr_plastic *)p)->body[k];
    place at = find_place(p, b, T);
    double X0 = b->field->start + ((double)at.off + at.shift) * b->mesh;
    bool any = false;
    if (X0 > reach || X0 + (double)b->points * b->mesh < -reach)
        return;
    ovr_stress_solve(b->field, p->P, b->Q, at.shift, OVR_STRESS_ALL_LEVELS);
    for (size_t j = 0; j < b->layers; j++) {
        ovr_layer_load *load = ovr_yielding_load(b->y, j);
        load->idle = !comes_near(b, j, at) || load_layer(b, j, at, load);
        any = any || !load->idle;
    }
    if (!any)
        return;
    ovr_flowed flowed = ovr_yielding_flow(b->y);
    if (!flowed.iterations)
        return;
    b->changed = true;
    b->work_now = b->work + flowed.work;
    b->left_now = fmax(b->left, flowed.left);
    if (!p->how->once)
        show(p, k);
}

/* Finds what the solids felt at the last time reached. */
static void find_pressure(const ovr_simulation *sim, ovr_plastic *p)
{
    for (size_t i = 0; i < sim->now.n; i++)
        p->P[i] = sim->past.P[0][i] + (sim->borne ? sim->borne[i] : 0);
}

static void before_step(ovr_simulation *sim, void *own, double T)
{
    ovr_plastic *p = own;
    (void)T;
    if (p->fresh || p->how->rests)
        return;
    find_pressure(sim, p);
    EACH_BODY(p, k)
    if (yields_by(p, k, largest(p, sim->now.n)))
        flow(p, k, sim->past.T[0]);
    p->fresh = true;
}

static void taken(ovr_simulation *sim, void *own, double dT)
{
    ovr_plastic *p = own;
    (void)sim;
    (void)dT;
    EACH_BODY(p, k)
    keep(&p->body[k]);
    p->fresh = false;
}

static void before_back(ovr_simulation *sim, void *own)
{
    ovr_plastic *p = own;
    (void)sim;
    EACH_BODY(p, k)
    if (p->body[k].changed)
        go_back(p, k, !p->how->once);
    p->fresh = false;
}

/* ----------------------------------------------------------------- the gap */

/* Interpolates between points i and i + 1 at t, nothing beyond the window. */
static double sunk_at(const ovr_yielding_body *b, long i, double t)
{
    float v[4];
    for (long m = 0; m < 4; m++) {
        long at = i - 1 + m;
        v[m] = at < 0 || at >= (long)b->points ? 0 : (float)b->shown[at];
    }
    if (t == 0)
        return i >= 0 && i < (long)b->points ? b->shown[i] : 0;
    return ovr_cubic(v + 1, 1, t);
}

static void heights(const ovr_simulation *sim, const void *own, double T,
                    size_t n, const double *X, double *S)
{
    const ovr_plastic *p = own;
    (void)sim;
    EACH_BODY(p, k)
    {
        const ovr_yielding_body *b = &p->body[k];
        double X0 = b->plan.range.reference + b->first +
                    ovr_stress_way(p->setup, &b->plan, T);
        for (size_t i = 0; i < n; i++) {
            double t = (X[i] - X0) / b->mesh;
            if (t <= -2 || t >= (double)b->points + 1)
                continue;
            double whole = floor(t + 1e-9);
            S[i] -= sunk_at(b, (long)whole, t > whole ? t - whole : 0);
        }
    }
}

/* ---------------------------------------------------------------- observed */

/* The plastic part of a simulation; NULL: nothing yields. */
static const ovr_plastic *plastic_of(const ovr_simulation *sim)
{
    const ovr_plastic *found = NULL;
    for (const ovr_present *p = sim->physics; p->is; p++)
        if (p->is == &ovr_physics_plastic)
            found = p->own;
    return found;
}

static void unknown(ovr_observation *o)
{
    o->plastic_strain = o->profile_change = NAN;
    o->shoulder_leading = o->shoulder_trailing = NAN;
}

/* Shoulders are those of the first body that yields. */
static void observe(ovr_simulation *sim, void *own, ovr_observation *o)
{
    ovr_plastic *p = own;
    EACH_BODY(p, k)
    {
        ovr_yielding_body *b = &p->body[k];
        if (b->Q)
            ovr_traction_now(&b->plan, sim, b->Q);
        o->plastic_strain = fmax(o->plastic_strain, ovr_plastic_max(p, b));
        o->profile_change = fmax(o->profile_change, ovr_plastic_deepest(b));
        if (!isnan(o->shoulder_leading))
            continue;
        o->shoulder_leading = ovr_plastic_shoulder(b, 1, true);
        o->shoulder_trailing = ovr_plastic_shoulder(b, -1, true);
    }
}

static const ovr_observable quantities[] = {
    OVR_NUMBER_ROW("plastic_strain", "plastic_strain", NULL, NUMBER,
                   plastic_strain, OVR_PHYSICS_PLASTIC,
                   "largest plastic strain of the material",
                   LABEL("plastic strain"), LARGEST("plastic_strain_max"),
                   EXTREME_LABEL("largest plastic strain"), PASS(END),
                   PASS_HEAD(10, "strain"), PASS_WITH(PLASTIC)),
    OVR_NUMBER_ROW("profile_change", "profile_change", "profile_change_m",
                   HEIGHT, profile_change, OVR_PHYSICS_PLASTIC,
                   "how far the profile was pressed down for good, at most",
                   LABEL("profile change"), LARGEST("profile_change_max"),
                   EXTREME_LABEL("largest profile change"), PASS(END),
                   PASS_HEAD(8, "change"), PASS_WITH(PLASTIC)),
    OVR_NUMBER_ROW("shoulder_height_leading", "shoulder_height_leading",
                   "shoulder_height_leading_m", HEIGHT, shoulder_leading,
                   OVR_PHYSICS_PLASTIC,
                   "highest point of the profile before the feature's middle",
                   LABEL("leading shoulder"), PASS(END),
                   PASS_HEAD(7, "leading"), PASS_WITH(PLASTIC)),
    OVR_NUMBER_ROW("shoulder_height_trailing", "shoulder_height_trailing",
                   "shoulder_height_trailing_m", HEIGHT, shoulder_trailing,
                   OVR_PHYSICS_PLASTIC,
                   "highest point of the profile behind the feature's middle",
                   LABEL("trailing shoulder"), PASS(END),
                   PASS_HEAD(9, "trailing"), PASS_WITH(PLASTIC))};

static void review(const ovr_simulation *sim, const void *own,
                   ovr_physics_say *say, void *data)
{
    const double enough = 0.02, small = 0.05;
    const ovr_plastic *p = own;
    char text[240];
    (void)sim;
    EACH_BODY(p, k)
    {
        double maximum = ovr_plastic_max(p, &p->body[k]);
        if (!isnan(p->how->body[k].strain) && maximum > small) {
            snprintf(text, sizeof text,
                     "plastic strain of surface %d reaches %.2g %%, the model "
                     "is of small strains: shoulder heights are trusted, the "
                     "strain itself is not",
                     k + 1, 100 * maximum);
            say(data, true, text);
        }
        if (!(p->body[k].left > enough))
            continue;
        snprintf(text, sizeof text,
                 "material of surface %d was left %.2g beyond its yield: more "
                 "[plastic] iterations, or hardening, would bring it to rest",
                 k + 1, p->body[k].left);
        say(data, true, text);
    }
}

/* ------------------------------------------------------------------- state */

static ovr_status visit(ovr_simulation *sim, void *own, ovr_visit *look,
                        void *context, ovr_error *err)
{
    ovr_plastic *p = own;
    ovr_status status = OVR_OK;
    (void)sim;
    for (int k = 0; !status && k < BODIES; k++) {
        ovr_yielding_body *b = &p->body[k];
        if (!b->y)
            continue;
        status = look(context, k ? "plastic strain 2" : "plastic strain 1",
                      b->kept, bytes_of(b), err);
        if (!status)
            status = look(context, k ? "plastic work 2" : "plastic work 1",
                          &b->work, sizeof b->work, err);
        if (!status)
            status = look(context, k ? "plastic left 2" : "plastic left 1",
                          &b->left, sizeof b->left, err);
        if (!status && b->Q)
            status = look(context,
                          k ? "plastic traction 2" : "plastic traction 1", b->Q,
                          b->plan.options.nodes * sizeof *b->Q, err);
    }
    return status;
}

static void restored(ovr_simulation *sim, void *own)
{
    ovr_plastic *p = own;
    (void)sim;
    EACH_BODY(p, k)
    go_back(p, k, !p->how->once);
    p->fresh = false;
}

/* ------------------------------------------------------------------ making */

static void release(void *own)
{
    ovr_plastic *p = own;
    for (int k = 0; k < BODIES; k++) {
        ovr_yielding_free(p->body[k].y);
        ovr_stress_free(p->body[k].field);
    }
    ovr_arena_release(&p->arena);
}

static ovr_status take(ovr_simulation *sim, const void *form, void **own,
                       ovr_error *err)
{
    ovr_plastic *p = ovr_arena_take(&sim->arena, 1, sizeof *p, err);
    if (!p)
        return OVR_NO_MEMORY;
    p->arena = ovr_arena_make(&sim->arena.allocator);
    p->how = form;
    p->setup = p->how->setup;
    *own = p;
    if (sim->arena.blank || !p->setup->nodes) /* it is counted alone */
        return OVR_OK;
    ovr_status status = make_ready(p, sim, err);
    if (status)
        release(p);
    return status;
}

static double memory_of(const ovr_setup *setup, int k)
{
    const ovr_plastic_setup *how = ovr_setup_plastic(setup);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_plastic_plan plan;
    double bytes = 0;
    double *edge = ovr_arena_take(&arena, (size_t)how->layers + 1, sizeof *edge,
                                  NULL);
    if (edge && !make_plan(setup, k, &plan, NULL)) {
        fill_edges(how, &plan, edge);
        const ovr_yielding_options o = options_of(how, k, &plan, edge);
        bytes = ovr_yielding_memory(&o) +
                8. * STATE * (double)(plan.points * plan.layers);
    }
    ovr_arena_release(&arena);
    return bytes;
}

static double memory(const void *form)
{
    const ovr_plastic_setup *how = form;
    double bytes = 0;
    for (int k = 0; k < BODIES; k++)
        if (how->surfaces >> k & 1)
            bytes += memory_of(how->setup, k);
    return bytes;
}

/* One iteration of flow and equilibrium, measured at 1024 points. */
static double iteration_seconds(const ovr_plastic_plan *plan)
{
    return 2.5e-3 * (double)plan->points / 1024 *
           pow((double)plan->layers / 24, 2);
}

/* Tables, stresses in the window while the contact is above it, and flow: of a
 * dent with shoulders in steel of .75 p_h some 6 of 100 of these steps flow,
 * four iterations each; in harder steel it is less. */
static double seconds(const void *form)
{
    const double flowing = 0.06, fields = 2e-4, tables = 60;
    const ovr_plastic_setup *how = form;
    const ovr_setup *setup = how->setup;
    double all = 0, dT = ovr_setup_step(setup);
    ovr_plastic_plan plan;
    for (int k = 0; k < BODIES; k++) {
        if (!(how->surfaces >> k & 1) || make_plan(setup, k, &plan, NULL))
            continue;
        double way = (double)plan.points * plan.mesh + 2 * reach;
        double steps = fmin(way, setup->march->end) / dT;
        double once = iteration_seconds(&plan);
        all += tables * once + steps * fields * (double)plan.layers / 24 +
               steps * flowing * fmin(how->iterations, 4) * once;
    }
    return all;
}

static void tell_body(const ovr_setup *setup, int k, ovr_physics_line *line,
                      void *data)
{
    const ovr_plastic_setup *how = ovr_setup_plastic(setup);
    double Y = how->body[k].hardening.yield, ph = setup->contact->ph * 1e-6;
    double nu = ovr_setup_stress(setup)->poisson[k];
    char text[240], megapascals[40] = "", strain[40] = "not known";
    ovr_plastic_plan plan;
    if (isfinite(ph))
        snprintf(megapascals, sizeof megapascals, " (%.4g MPa)", Y * ph);
    if (isfinite(how->body[k].strain))
        snprintf(strain, sizeof strain, "%.4g", 1 / how->body[k].strain);
    snprintf(text, sizeof text,
             "surface %d at Y = %.4g ph%s; smooth, first at %.4g ph, and no "
             "shakedown above %.4g ph; E*/ph %s",
             k + 1, Y, megapascals, ovr_first_yield(nu) * Y,
             ovr_shakedown_limit() * Y, strain);
    line(data, "yields", text);
    if (!setup->nodes || make_plan(setup, k, &plan, NULL))
        return;
    snprintf(
        text, sizeof text,
        "%zu points from %.3g to %.3g b about %s, %zu layers down to %.3g "
        "b; %.3g MB; some %.2g ms where it flows, an iteration",
        plan.points, plan.first, plan.first + (double)plan.points * plan.mesh,
        plan.stress.feature ? plan.stress.feature : "the middle", plan.layers,
        how->depth, memory_of(setup, k) / 1e6, 1e3 * iteration_seconds(&plan));
    line(data, "window", text);
}

static void tell(const ovr_physics_case *of, const void *form,
                 ovr_physics_line *line, void *data)
{
    const ovr_plastic_setup *how = form;
    (void)of;
    for (int k = 0; k < BODIES; k++)
        if (how->surfaces >> k & 1)
            tell_body(how->setup, k, line, data);
}

/* --------------------------------------------------------------- companion */

static ovr_status finish(void *own, ovr_run *run, ovr_error *err)
{
    const ovr_plastic *p = plastic_of(run->sim);
    (void)own;
    if (!p)
        return OVR_OK;
    EACH_BODY(p, k)
    show(p, k); /* what the next pass begins with */
    if (run->writer && ovr_plastic_store(run->writer, p, err))
        return err->status;
    return p->how->profiles ? ovr_plastic_write_profiles(p, err) : OVR_OK;
}

static const ovr_companion companion = {.finish = finish};

const ovr_physics ovr_physics_plastic = {.name = "a body that yields",
                                         .bit = OVR_PHYSICS_PLASTIC,
                                         .section = &ovr_plastic_section,
                                         .sections = 1,
                                         .behind = "paper",
                                         .form = sizeof(ovr_plastic_setup),
                                         .resolve = ovr_plastic_resolve,
                                         .on_mesh = ovr_plastic_on_mesh,
                                         .features = ovr_plastic_features,
                                         .one_mesh = "as strains grow from "
                                                     "step to step",
                                         .tell = tell,
                                         .memory = memory,
                                         .seconds = seconds,
                                         .companion = &companion,
                                         .take = take,
                                         .release = release,
                                         .before_step = before_step,
                                         .taken = taken,
                                         .before_back = before_back,
                                         .heights = heights,
                                         .unknown = unknown,
                                         .observe = observe,
                                         .quantity = quantities,
                                         .quantities = sizeof quantities /
                                                       sizeof *quantities,
                                         .review = review,
                                         .visit = visit,
                                         .restored = restored};
