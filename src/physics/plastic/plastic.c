/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plastic bodies in a run: before the step to T, plastic flow is computed for
 * the film of the last completed time (yielding.c), and its surface
 * displacement is added to the gap of the step:
 *
 *     S = ... - w E'/(4 E*),  at xi = X - X_0 - U(T)
 *
 * The coupling is explicit: film and strains of a step are solved one after the
 * other. Stresses at material points are computed by shifting the nodes, as in
 * stress histories (stress/field.c); the profile between points is interpolated
 * by cubics. All points of a layer are evaluated only if the window is in the
 * contact and the layer's stress on a coarse set of nodes is close to yield.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "case/setup.h"
#include "physics/companion.h"
#include "physics/plastic/bodies.h"
#include "physics/plastic/plastic.h"
#include "simulation/quantity_row.h"
#include "stress/cubic.h"
#include "stress/field.h"
#include "stress/stress.h"
#include "surface/surfaces.h"

/* -------------------------------------------------------- Numbers of a body */

/* Numbers that summarize the plastic deformation of a body. */

/* Maximum of numbers other than NAN; inlined because fmax is a function call.
 */
static double larger(double a, double b)
{
    return a > b ? a : b;
}

double ovr_plastic_max(const ovr_plastic *p, const ovr_yielding_body *b)
{
    double maximum = 0;
    for (size_t j = 0; j < b->layers; j++)
        for (size_t i = 0; i < b->points; i++)
            maximum = larger(
                maximum,
                b->kept[(OVR_PLASTIC_STATE * (j + 1) - 1) * b->points + i]);
    return maximum * p->how->body[b == p->body ? 0 : 1].strain;
}

double ovr_plastic_deepest(const ovr_yielding_body *b)
{
    double maximum = 0;
    for (size_t i = 0; i < b->points; i++)
        maximum = larger(maximum, b->shown[i]);
    return maximum;
}

double ovr_plastic_shoulder(const ovr_yielding_body *b, int side, bool yielded)
{
    double maximum = -INFINITY, direction = b->plan.direction < 0 ? -1 : 1;
    for (size_t i = 0; i < b->points; i++) {
        double xi = b->first + (double)i * b->mesh;
        if (xi * direction * side >= 0)
            maximum = larger(maximum,
                             b->shape[i] - (yielded ? b->shown[i] : 0));
    }
    return maximum;
}

/* ------------------------------------------------------------------- Bodies */

enum { BODIES = 2, STATE = OVR_PLASTIC_STATE };

/* ------------------------------------------------------------------ window */

/* Reads the shape of the features before they enter the contact, at full
 * height. */
static void find_shape(const ovr_plastic *p, ovr_yielding_body *b, double *X)
{
    const ovr_setup *s = p->setup;
    size_t count = s->surfaces ? ovr_surfaces_count(s->surfaces) : 0;
    double T = 0;
    for (size_t k = 0; k < count; k++)
        if (ovr_surfaces_info(s->surfaces, k).grows)
            T = s->march->end;
    double at = b->plan.range.reference + ovr_stress_distance(s, &b->plan, T);
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
    if (ovr_plastic_planned(p->setup, k, &plan, err))
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
    ovr_plastic_edges(p->how, &plan, b->edge);
    for (size_t j = 0; j < layers; j++)
        b->z[j] = (b->edge[j] + b->edge[j + 1]) / 2;
    ovr_stress_options o = b->plan.options;
    o.from = -OVR_PLASTIC_REACH;
    o.to = OVR_PLASTIC_REACH;
    o.depth_min = b->z[0];
    o.depth_max = b->z[layers - 1];
    o.layers = NULL;
    b->field = ovr_stress_create_at(&o, layers, b->z, allocator, err);
    if (!b->field)
        return OVR_NO_MEMORY;
    find_shape(p, b, X);
    const ovr_yielding_options y = ovr_plastic_options(p->how, k, &plan,
                                                       b->edge);
    b->y = ovr_yielding_create(&y, allocator, err);
    return b->y ? OVR_OK : OVR_NO_MEMORY;
}

/* ------------------------------------------------- stored and present state */

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

/* Restores the stored state; if the profile changes only between passes, that
 * of an earlier run is kept. */
static void restore(ovr_plastic *p, int k, bool profile)
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
        restore(p, k, true);
    }
    return OVR_OK;
}

/* -------------------------------------------------------------------- flow */

/* Node i of the stress field is point i - off of the window; nodes are shifted
 * by `shift` in units of D. */
typedef struct place {
    long off;
    double shift;
} place;

static place find_place(const ovr_plastic *p, const ovr_yielding_body *b,
                        double T)
{
    double X0 = b->plan.range.reference + b->first +
                ovr_stress_distance(p->setup, &b->plan, T);
    double t = (X0 - b->field->start) / b->mesh, whole = floor(t + 1e-9);
    return (place){(long)whole, fmax(0, t - whole)};
}

static ovr_in_plane at_node(const ovr_stress_row *row, size_t i)
{
    return (ovr_in_plane){(double)row->mean[2 * i], (double)row->shear[2 * i],
                          (double)row->shear[2 * i + 1]};
}

/* Range of nodes in a row that are points of the window. */
static bool nodes_within(const ovr_yielding_body *b, const ovr_stress_row *row,
                         place at, size_t *first, size_t *last)
{
    long step = 1L << row->level, n = (long)b->points;
    long from = at.off > 0 ? (at.off + step - 1) / step : 0;
    long to = at.off + n - 1 < 0 ? -1 : (at.off + n - 1) / step;
    long end = (long)floor((OVR_PLASTIC_REACH - row->start) / row->step);
    if (to > end)
        to = end;
    if (to > (long)row->count - 1)
        to = (long)row->count - 1;
    *first = (size_t)from;
    *last = to < 0 ? 0 : (size_t)to;
    return from <= to;
}

/* True if any point of the layer is close to yield. */
static bool is_near_yield(const ovr_yielding_body *b, size_t j, place at)
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

/* Upper bound of the von Mises stress: pressures between 0 and P_max without
 * traction cause at most a maximum shear stress in the plane of P_max/pi and a
 * mean stress of P_max, hence a von Mises stress of at most P_max sqrt(3/pi^2 +
 * (1 - 2 nu)^2). A residual stress increases it by at most its own von Mises
 * stress. */
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

/* Computes the plastic flow under the pressure at time T. */
static void flow(ovr_plastic *p, int k, double T)
{
    ovr_yielding_body *b = &p->body[k];
    place at = find_place(p, b, T);
    double X0 = b->field->start + ((double)at.off + at.shift) * b->mesh;
    bool any = false;
    if (X0 > OVR_PLASTIC_REACH ||
        X0 + (double)b->points * b->mesh < -OVR_PLASTIC_REACH)
        return;
    ovr_stress_solve(b->field, p->P, b->Q, at.shift, OVR_STRESS_ALL_LEVELS);
    for (size_t j = 0; j < b->layers; j++) {
        ovr_layer_load *load = ovr_yielding_load(b->y, j);
        load->idle = !is_near_yield(b, j, at) || load_layer(b, j, at, load);
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

/* Computes the pressure on the solids at the last completed time. */
static void find_pressure(const ovr_simulation *sim, ovr_plastic *p)
{
    for (size_t i = 0; i < sim->now.n; i++)
        p->P[i] = sim->past.P[0][i] +
                  (sim->asperity_P ? sim->asperity_P[i] : 0);
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

static void accepted(ovr_simulation *sim, void *own, double dT)
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
        restore(p, k, !p->how->once);
    p->fresh = false;
}

/* ----------------------------------------------------------------- the gap */

/* Interpolates the surface displacement between points i and i + 1 at t; 0
 * outside the window. */
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

static void heights(const ovr_simulation *sim, const void *own, int surface,
                    double T, size_t n, const double *X, double *S)
{
    const ovr_plastic *p = own;
    (void)sim;
    EACH_BODY(p, k)
    {
        const ovr_yielding_body *b = &p->body[k];
        if (surface && surface != k + 1)
            continue;
        double X0 = b->plan.range.reference + b->first +
                    ovr_stress_distance(p->setup, &b->plan, T);
        for (size_t i = 0; i < n; i++) {
            double t = (X[i] - X0) / b->mesh;
            if (t <= -2 || t >= (double)b->points + 1)
                continue;
            double whole = floor(t + 1e-9);
            S[i] -= sunk_at(b, (long)whole, t > whole ? t - whole : 0);
        }
    }
}

/* ----------------------------------------------------- observed quantities */

/* The plastic model of a simulation; NULL: no plastic body. */
static const ovr_plastic *plastic_of(const ovr_simulation *sim)
{
    const ovr_plastic *found = NULL;
    for (const ovr_present *p = sim->physics.on; p->is; p++)
        if (p->is == &ovr_physics_plastic)
            found = p->own;
    return found;
}

static void unknown(ovr_observation *o)
{
    o->plastic_strain = o->profile_change = NAN;
    o->shoulder_leading = o->shoulder_trailing = NAN;
}

/* Raised rims are those of the first plastic body. */
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
                   "maximum plastic strain", LABEL("maximum plastic strain"),
                   LARGEST("plastic_strain_max"), EXTREME_REPORTED, PASS(END),
                   PASS_HEAD(10, "strain"), PASS_WITH(PLASTIC)),
    OVR_NUMBER_ROW("profile_change", "profile_change", "profile_change_m",
                   HEIGHT, profile_change, OVR_PHYSICS_PLASTIC,
                   "maximum profile change",
                   COMMENT("permanent depression of the profile"),
                   LABEL("maximum profile change"),
                   LARGEST("profile_change_max"), EXTREME_REPORTED, PASS(END),
                   PASS_HEAD(8, "profile"), PASS_WITH(PLASTIC)),
    OVR_NUMBER_ROW("shoulder_height_leading", "shoulder_height_leading",
                   "shoulder_height_leading_m", HEIGHT, shoulder_leading,
                   OVR_PHYSICS_PLASTIC, "leading rim height",
                   LABEL("leading rim height"), PASS(END),
                   PASS_HEAD(7, "leading"), PASS_WITH(PLASTIC)),
    OVR_NUMBER_ROW("shoulder_height_trailing", "shoulder_height_trailing",
                   "shoulder_height_trailing_m", HEIGHT, shoulder_trailing,
                   OVR_PHYSICS_PLASTIC, "trailing rim height",
                   LABEL("trailing rim height"), PASS(END),
                   PASS_HEAD(9, "trailing"), PASS_WITH(PLASTIC))};

static void review(const ovr_simulation *sim, const void *own,
                   ovr_physics_message *say, void *data)
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
                     "plastic strain of surface %d reaches %.2g %%, beyond the "
                     "small-strain model; rim heights remain valid, the strain "
                     "itself does not",
                     k + 1, 100 * maximum);
            say(data, true, text);
        }
        if (!(p->body[k].left > enough))
            continue;
        snprintf(text, sizeof text,
                 "stress below surface %d still exceeds yield by a relative "
                 "%.2g; increase plastic.iterations or use a hardening law",
                 k + 1, p->body[k].left);
        say(data, true, text);
    }
}

/* ------------------------------------------------------------------- state */

static void visit(ovr_simulation *sim, void *own, ovr_pieces *state)
{
    ovr_plastic *p = own;
    (void)sim;
    EACH_BODY(p, k)
    {
        ovr_yielding_body *b = &p->body[k];
        ovr_show(state, k ? "plastic strain 2" : "plastic strain 1", b->kept,
                 bytes_of(b));
        OVR_SHOW(state, k ? "plastic work 2" : "plastic work 1", b->work);
        OVR_SHOW(state, k ? "plastic left 2" : "plastic left 1", b->left);
        if (b->Q)
            ovr_show(state, k ? "plastic traction 2" : "plastic traction 1",
                     b->Q, b->plan.options.nodes * sizeof *b->Q);
    }
}

static void restored(ovr_simulation *sim, void *own)
{
    ovr_plastic *p = own;
    (void)sim;
    EACH_BODY(p, k)
    restore(p, k, !p->how->once);
    p->fresh = false;
}

/* ---------------------------------------------------------------- creation */

static void release(void *own)
{
    ovr_plastic *p = own;
    for (int k = 0; k < BODIES; k++) {
        ovr_yielding_free(p->body[k].y);
        ovr_stress_free(p->body[k].field);
    }
    ovr_arena_release(&p->arena);
}

static ovr_status create(ovr_simulation *sim, const void *form, void **own,
                         ovr_error *err)
{
    ovr_plastic *p = ovr_arena_take(&sim->arena, 1, sizeof *p, err);
    if (!p)
        return OVR_NO_MEMORY;
    p->arena = ovr_arena_make(&sim->arena.allocator);
    p->how = form;
    p->setup = p->how->setup;
    *own = p;
    if (sim->arena.blank || !p->setup->nodes) /* memory is only counted */
        return OVR_OK;
    ovr_status status = make_ready(p, sim, err);
    if (status)
        release(p);
    return status;
}

/* --------------------------------------------------------------- companion */

static ovr_status finish(void *own, const ovr_accompanied_run *run,
                         ovr_error *err)
{
    const ovr_plastic *p = plastic_of(run->sim);
    (void)own;
    if (!p)
        return OVR_OK;
    EACH_BODY(p, k)
    show(p, k); /* initial state of the next pass */
    if (run->writer && ovr_plastic_store(run->writer, p, err))
        return err->status;
    return p->how->profiles ? ovr_plastic_write_profiles(p, err) : OVR_OK;
}

/* Before the solve: existing files are replaced only with --force. */
static ovr_status make_profiles(const ovr_accompanied_run *run, void **own,
                                ovr_error *err)
{
    const ovr_plastic *p = plastic_of(run->sim);
    *own = NULL;
    return p && p->how->profiles && !run->force && !run->resumed
               ? ovr_plastic_check_profiles(p, err)
               : OVR_OK;
}

static const ovr_companion companion = {.make = make_profiles,
                                        .finish = finish};

static const ovr_physics_in_case in_case = {.section = &ovr_plastic_section,
                                            .sections = 1,
                                            .behind = "paper",
                                            .form = sizeof(ovr_plastic_setup),
                                            .resolve = ovr_plastic_resolve,
                                            .on_mesh = ovr_plastic_on_mesh,
                                            .effects = ovr_plastic_state,
                                            .one_mesh = "as strains grow from "
                                                        "step to step",
                                            .describe = ovr_plastic_describe,
                                            .memory = ovr_plastic_memory,
                                            .seconds = ovr_plastic_seconds};

static const ovr_physics_in_solve in_solve = {
    .take = create, .release = release, .heights = heights};

static const ovr_physics_in_step in_step = {.before_step = before_step,
                                            .accepted = accepted,
                                            .before_back = before_back,
                                            .visit = visit,
                                            .restored = restored};

static const ovr_physics_in_output in_output = {.companion = &companion,
                                                .unknown = unknown,
                                                .observe = observe,
                                                OVR_QUANTITIES(quantities),
                                                .review = review};

const ovr_physics ovr_physics_plastic = {.name = "a body that yields",
                                         .bit = OVR_PHYSICS_PLASTIC,
                                         .in_case = &in_case,
                                         .in_solve = &in_solve,
                                         .in_step = &in_step,
                                         .in_output = &in_output};
