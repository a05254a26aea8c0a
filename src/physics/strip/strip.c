/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Strips: solver of a film that varies across the rolling direction (solver.h).
 *
 * Steady films: start.c.
 * Steps are solved by strip/march.c, which tries several settings.
 * A step that fails is halved, up to OVR_HALVINGS times.
 * The last result is accepted and marked if R is below OVR_ACCEPTABLE.
 *
 * The tolerance of R in a step is half the discretization error of the mesh. If
 * larger, it is a thousandth of R of the initial guess. It is at most 1e-2. It
 * changes the film thickness of moving dents and of roughness by less than 1e-4
 * (lambda ratio 1 and 3).
 */
#include "physics/strip/strip.h"

#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/curvature.h"
#include "contact/film_formula.h"
#include "contact/history.h"
#include "multigrid/flow.h"
#include "simulation/conflicts.h"
#include "simulation/mirror.h"
#include "simulation/solver.h"
#include "simulation/steady.h"
#include "strip/across.h"
#include "strip/kernels.h"

static const double STEP_TOLERANCE = 0.5, GUESS_SHARE = 1e-3, LOOSEST = 1e-2,
                    LOAD_TOLERANCE = 1e-4;

ovr_strip_solver *ovr_strip_of(const ovr_simulation *sim)
{
    OVR_EACH_PHYSICS(sim, p, in_solve, solver)
        return p->own;
    return NULL;
}

/* ----------------------------------------------------------------- creation */

/* Maximum step length in mesh sizes. */
enum { LONGEST = 16 };

size_t ovr_strip_coarsest(double M)
{
    return M < 90 ? 29 : 57;
}

static ovr_status allocate_arrays(ovr_simulation *sim, ovr_strip_solver *s,
                                  ovr_error *err)
{
    ovr_arena *a = &sim->arena;
    size_t all = s->n * s->lines, most = s->n + 2 * LONGEST + 8;
    double **const to[] = {&s->S,          &s->S_before,  &s->X,
                           &s->along,      &s->across,    &s->Y,
                           &s->located[0], &s->located[1]};
    const size_t count[] = {all,  all,      s->n,     most,
                            most, s->lines, s->lines, s->lines};
    for (size_t k = 0; k < sizeof to / sizeof *to; k++)
        if (!(*to[k] = ovr_arena_take(a, count[k], sizeof **to[k], err)))
            return OVR_NO_MEMORY;
    return OVR_OK;
}

static void fill_places(ovr_simulation *sim, ovr_strip_solver *s)
{
    const ovr_strip_grid *g = &ovr_strip_finest(s)->grid;
    double W = s->form->width, best = INFINITY;
    for (size_t i = 0; i < s->n; i++) {
        s->X[i] = g->X_a + (double)i * g->D;
        if (s->X[i] <= 0)
            s->middle = i;
    }
    for (size_t j = 0; j < s->lines; j++) {
        s->Y[j] = ovr_across_Y(W, g->Dy, j);
        double apart = fabs(ovr_across_offset(W, s->Y[j] - s->form->shown));
        if (apart < best - 1e-9) {
            best = apart;
            s->shown = j;
        }
    }
    sim->shapes.Y = s->Y[s->shown];
}

/* Adds the cycles since the last call to the work of the step. */
static void count_work(ovr_simulation *sim, ovr_strip_solver *s)
{
    sim->grids.stopping.work += OVR_SOLVER_WORK * s->strip.cycled;
    s->strip.cycled = 0;
}

/* An ovr_strip_stop. */
static bool stops(void *data)
{
    ovr_simulation *sim = data;
    count_work(sim, ovr_strip_of(sim));
    return ovr_hierarchy_stops(&sim->grids);
}

static ovr_status create(ovr_simulation *sim, const void *form, void **own,
                         ovr_error *err)
{
    const ovr_options *o = &sim->options;
    ovr_strip_solver *s = ovr_arena_take(&sim->arena, 1, sizeof *s, err);
    if (!s)
        return OVR_NO_MEMORY;
    s->form = form;
    s->grown = 1;
    s->n = ovr_level_nodes(o->level);
    s->lines = ovr_strip_lines(s->form,
                               (o->outlet - o->inlet) / (double)(s->n - 1));
    const ovr_strip_shape shape = {.n = s->n,
                                   .lines = s->lines,
                                   .coarsest = ovr_strip_coarsest(s->form->M),
                                   .X_a = o->inlet,
                                   .X_b = o->outlet,
                                   .width = s->form->width,
                                   .threads = s->form->threads};
    ovr_status status = ovr_strip_allocate(
        &s->strip, &shape, sim->grids.kernels, &sim->arena, err);
    if (!status)
        status = ovr_strip_march_create(&s->march, &s->strip, LONGEST,
                                        &sim->arena, err);
    if (!status)
        status = allocate_arrays(sim, s, err);
    if (status || sim->arena.blank)
        return status;
    *own = s;
    fill_places(sim, s);
    s->strip.stop = stops;
    s->strip.stop_data = sim;
    s->march.gap = ovr_strip_gap_of;
    s->march.data = sim;
    s->march.characteristic = sim->scheme->characteristic;
    s->strip.fluid = sim->grids.fluid;
    s->strip.logarithmic = sim->grids.fluid.logarithmic;
    status = ovr_strip_plan(&s->strip, err);
    if (status)
        ovr_strip_release(&s->strip);
    return status;
}

static void release(void *own)
{
    ovr_strip_solver *s = own;
    if (s)
        ovr_strip_release(&s->strip);
}

/* ---------------------------------------------------------------------- gap */

/* Arguments of loops shared by several threads. */
typedef struct shared {
    const ovr_simulation *sim;
    ovr_strip_solver *s;
    const ovr_strip_grid *grid;
    double T;
    ovr_smooth smooth;
    double *to;
} shared;

/* Runs a loop over the rows of the finest grid; returns the maximum of the
 * numbers stored for the rows. */
static double largest_of(ovr_strip_solver *s, ovr_team_work *work, shared *data)
{
    double largest = -INFINITY;
    ovr_strip_share(&s->strip, &ovr_strip_finest(s)->grid, s->n, work, data);
    for (size_t i = 0; i < s->n; i++)
        if (!(s->strip.sums[i] <= largest))
            largest = s->strip.sums[i];
    return largest;
}

static void add_heights(void *data, int member, size_t from, size_t to)
{
    const shared *d = data;
    const ovr_strip_solver *s = d->s;
    (void)member;
    d->sim->shapes.across(d->sim->shapes.data, 0, d->T, to - from,
                          s->along + from, d->grid->lines, s->located[0],
                          d->grid->stride, d->to + from * d->grid->stride);
}

/* Heights of both surfaces at the rows of a grid. */
static void heights_at(const ovr_simulation *sim, double T,
                       const ovr_strip_grid *g, size_t n, double *S)
{
    ovr_strip_solver *s = ovr_strip_of(sim);
    const size_t apart = ovr_across_spacing(s->lines, g->lines);
    if (sim->shapes.across) {
        /* Coarse grids have every second, fourth ... line of the finest. */
        double *Y = s->located[0];
        for (size_t j = 0; j < g->lines; j++)
            Y[j] = s->Y[j * apart];
        shared d = {.sim = sim, .s = s, .grid = g, .T = T, .to = S};
        ovr_strip_share(&s->strip, g, n, add_heights, &d);
        return;
    }
    ovr_surface_heights(sim, T, n, s->along, s->across);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < g->lines; j++)
            S[i * g->stride + j] = s->across[i];
}

void ovr_strip_gap_of(void *data, double T, const ovr_strip_grid *g,
                      ptrdiff_t from, size_t n, double *gap)
{
    const ovr_simulation *sim = data;
    const ovr_smooth smooth = ovr_simulation_smooth(sim, T);
    const double *X = ovr_strip_of(sim)->along;
    const double grown = ovr_strip_of(sim)->grown;
    for (size_t i = 0; i < n; i++)
        ovr_strip_of(sim)->along[i] = g->X_a +
                                      (double)(from + (ptrdiff_t)i) * g->D;
    heights_at(sim, T, g, n, gap);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < g->lines; j++) {
            double *at = gap + i * g->stride + j;
            *at = ovr_smooth_at(&smooth, X[i]) - grown * *at;
        }
}

static void keep_lines(void *data, int member, size_t from, size_t to)
{
    const shared *d = data;
    const ovr_strip_solver *s = d->s;
    const ovr_strip_level *finest = ovr_strip_finest(s);
    (void)member;
    for (size_t j = from; j < to; j++)
        for (size_t i = 0; i < s->n; i++)
            s->S[j * s->n + i] =
                ovr_smooth_at(&d->smooth, s->X[i]) -
                finest->f.gap[ovr_strip_row(&finest->grid, i) + j];
}

/* Stores the heights used in the gap at T. */
void ovr_strip_keep_heights(const ovr_simulation *sim, ovr_strip_solver *s,
                            double T)
{
    shared d = {.s = s, .smooth = ovr_simulation_smooth(sim, T)};
    if (ovr_has_heights(sim))
        ovr_strip_share(&s->strip, &ovr_strip_finest(s)->grid, s->lines,
                        keep_lines, &d);
}

/* --------------------------------------------------------------- the film */

/* Stores the maximum of -H for each row; INFINITY if it is not a number. */
static void find_thinnest(void *data, int member, size_t from, size_t to)
{
    const ovr_strip_solver *s = ((const shared *)data)->s;
    const ovr_strip_level *finest = ovr_strip_finest(s);
    (void)member;
    for (size_t i = from; i < to; i++) {
        const double *H = finest->f.H + ovr_strip_row(&finest->grid, i);
        double least = INFINITY;
        for (size_t j = 0; j < s->lines && least > -INFINITY; j++)
            if (!(H[j] >= least))
                least = isnan(H[j]) ? -INFINITY : H[j];
        s->strip.sums[i] = -least;
    }
}

double ovr_strip_smallest_film(ovr_strip_solver *s)
{
    return -largest_of(s, find_thinnest, &(shared){.s = s});
}

void ovr_strip_show(ovr_simulation *sim, const ovr_strip_solver *s, size_t j)
{
    const ovr_strip_level *finest = ovr_strip_finest(s);
    const ovr_strip_fields *f = &finest->f;
    const double D2 = sim->now.D * sim->now.D;
    ovr_solution *now = &sim->now;
    for (size_t i = 0; i < s->n; i++) {
        size_t at = ovr_strip_row(&finest->grid, i) + j;
        now->P[i] = f->P[at];
        now->H[i] = f->H[at];
        now->q[i] = f->q[at];
        now->eps[i] = f->eps[at];
        if (now->flow)
            now->flow[i] = 2 * D2 * f->along[at];
    }
    if (ovr_has_heights(sim))
        memcpy(sim->shapes.S, s->S + j * s->n, s->n * sizeof *sim->shapes.S);
    sim->shapes.Y = s->Y[j];
    sim->grids.H0 = s->strip.H0;
}

/* The fluid of the conditions at T. */
void ovr_strip_set_fluid(ovr_simulation *sim, ovr_strip_solver *s, double T)
{
    ovr_slide(sim, T);
    s->strip.fluid = sim->grids.fluid;
    s->strip.logarithmic = s->strip.fluid.logarithmic;
}

/* Mean of rho H over the width, integrated from the first half node to that
 * after `middle`. */
static double mass_of(const ovr_strip_solver *s)
{
    const ovr_strip_grid *g = &ovr_strip_finest(s)->grid;
    double sum = 0;
    for (size_t i = 1; i <= s->middle; i++) {
        const double *q = ovr_strip_finest(s)->f.q + ovr_strip_row(g, i);
        for (size_t j = 0; j < s->lines; j++)
            sum += q[j];
    }
    return sum * g->D / (double)ovr_across_intervals(s->lines);
}

static void begin(ovr_simulation *sim, void *own)
{
    ovr_strip_solver *s = own;
    ovr_strip_march_begin(&s->march, sim->state.T);
    s->least[0] = INFINITY;
    memcpy(s->S_before, s->S, s->n * s->lines * sizeof *s->S);
    for (size_t k = 0; k < 3; k++)
        s->mass[k] = mass_of(s);
}

/* ------------------------------------------------------------------- a step */

static void set_step(ovr_simulation *sim, ovr_strip_solver *s, double next)
{
    ovr_strip_march *m = &s->march;
    double D = sim->now.D, given = sim->options.tolerance;
    double tolerance = STEP_TOLERANCE *
                       ovr_truncation_tolerance(sim, D, sim->observation.H_cen);
    ovr_strip_set_fluid(sim, s, next);
    m->speed = ovr_history_value(sim->histories.speed, next);
    m->force = OVR_NOMINAL_LOAD * ovr_history_value(sim->histories.load, next);
    m->carried = sim->shapes.moving * m->speed;
    for (int k = 0; k < 2; k++)
        m->travel[k] = ovr_travel_since(sim, k, next);
    m->tolerance = given > 0 ? given : tolerance;
    m->share = given > 0 ? 0 : GUESS_SHARE;
    m->loosest = LOOSEST;
    m->load = fmax(given, LOAD_TOLERANCE) /
              fmin(1, m->force / OVR_NOMINAL_LOAD);
}

/* Makes the attempt the last completed time. */
static void accept(ovr_simulation *sim, ovr_strip_solver *s, double next)
{
    ovr_past *past = &sim->past;
    double *heights = s->S;
    past->dT = next - past->T[0];
    for (int k = OVR_PAST - 1; k > 0; k--) {
        past->H0[k] = past->H0[k - 1];
        past->T[k] = past->T[k - 1];
    }
    past->H0[0] = s->strip.H0;
    past->T[0] = next;
    past->steps += past->steps < 3;
    s->S = s->S_before;
    s->S_before = heights;
    ovr_strip_keep_heights(sim, s, next);
    ovr_strip_march_accept(&s->march);
    s->mass[2] = s->mass[1];
    s->mass[1] = s->mass[0];
    s->mass[0] = mass_of(s);
}

static double largest_difference(size_t n, const double *a, const double *b)
{
    double largest = 0;
    for (size_t k = 0; k < n; k++) {
        double d = fabs(a[k] - b[k]);
        largest = d > largest ? d : largest;
    }
    return largest;
}

static void find_changes(void *data, int member, size_t from, size_t to)
{
    const shared *d = data;
    const ovr_strip_solver *s = d->s;
    const ovr_strip_grid *g = &ovr_strip_finest(s)->grid;
    (void)member;
    for (size_t i = from; i < to; i++) {
        size_t row = ovr_strip_row(g, i);
        double *largest = &s->strip.sums[i];
        *largest = largest_difference(s->lines, s->march.P[0] + row,
                                      s->march.P[1] + row);
        if (!d->sim)
            continue;
        /* Difference of the heights; both arrays have the same order */
        size_t k = i * s->lines;
        double change = largest_difference(s->lines, s->S + k, s->S_before + k);
        *largest = change > *largest ? change : *largest;
    }
}

/* Maximum change of pressure and heights in the last step. */
static double change_of(const ovr_simulation *sim, ovr_strip_solver *s)
{
    return largest_of(
        s, find_changes,
        &(shared){.s = s, .sim = ovr_has_heights(sim) ? sim : NULL});
}

static bool advance(ovr_simulation *sim, ovr_strip_solver *s, double next,
                    int halvings, ovr_outcome *outcome)
{
    const double last = sim->past.T[0];
    set_step(sim, s, next);
    ovr_strip_step step = ovr_strip_march_attempt(&s->march, next);
    outcome->cycles += step.cycles;
    outcome->retries += step.attempts - 1;
    outcome->defect.imbalance = step.imbalance;
    bool open = ovr_strip_smallest_film(s) > 0;
    if (step.solved && open) {
        accept(sim, s, next);
        return true;
    }
    if (ovr_strip_stops(&s->strip)) {
        outcome->marked = outcome->spent = true;
        return false;
    }
    if (halvings < OVR_HALVINGS) {
        sim->statistics.substeps++;
        return advance(sim, s, last + (next - last) / 2, halvings + 1,
                       outcome) &&
               advance(sim, s, next, halvings + 1, outcome);
    }
    outcome->marked = true;
    if (!open || !(step.imbalance <= OVR_ACCEPTABLE))
        return false;
    accept(sim, s, next);
    return true;
}

static bool attempt(ovr_simulation *sim, void *own, double next,
                    ovr_outcome *outcome)
{
    ovr_strip_solver *s = own;
    s->strip.cycled = 0;
    bool taken = advance(sim, s, next, 0, outcome);
    count_work(sim, s);
    if (taken)
        sim->past.change = change_of(sim, s);
    ovr_strip_show(sim, s, s->shown);
    return taken;
}

static void step_back(ovr_simulation *sim, void *own)
{
    ovr_strip_solver *s = own;
    ovr_strip_set_fluid(sim, s, sim->past.T[0]);
    ovr_strip_march_back(&s->march);
    ovr_strip_keep_heights(sim, s, sim->past.T[0]);
    ovr_strip_show(sim, s, s->shown);
}

static void show(ovr_simulation *sim, void *own, size_t line)
{
    const ovr_strip_solver *s = own;
    ovr_strip_show(sim, s, line < s->lines ? line : s->shown);
}

static const double *lines_of(const void *own, size_t *count, size_t *shown)
{
    const ovr_strip_solver *s = own;
    *count = s->lines;
    *shown = s->shown;
    return s->Y;
}

static ovr_status check(const ovr_simulation *sim, const void *own,
                        ovr_error *err)
{
    (void)own;
    return ovr_conflict_check(
        sim->physics.features | ovr_model_features_of(&sim->options) |
            ovr_model_feature_bit(OVR_MODEL_REVERSAL,
                                  ovr_history_reverses(sim->histories.speed)) |
            ovr_model_feature_bit(OVR_MODEL_STRIP, true),
        err);
}

/* --------------------------------------------------------------- checkpoint */

static void visit(ovr_simulation *sim, void *own, ovr_pieces *state)
{
    ovr_strip_solver *s = own;
    ovr_strip_march *m = &s->march;
    const ovr_strip_grid *g = &ovr_strip_finest(s)->grid;
    size_t bytes = ovr_strip_size(g) * sizeof(double);
    size_t more = m->ghosts * g->stride * sizeof(double);
    static const char *const P[] = {"strip_P_1", "strip_P_2", "strip_P_3",
                                    "strip_P_4"};
    static const char *const q[] = {"strip_q_1", "strip_q_2"};
    (void)sim;
    for (size_t k = 0; k < OVR_STRIP_PAST; k++)
        ovr_show(state, P[k], m->P[k], bytes);
    for (size_t k = 0; k < 2; k++)
        ovr_show(state, q[k], m->q[k], bytes + more);
    ovr_show(state, "strip_H0", m->H0, sizeof m->H0);
    ovr_show(state, "strip_T", m->T, sizeof m->T);
    OVR_SHOW(state, "strip_known", m->known);
    OVR_SHOW(state, "strip_steps", m->steps);
    OVR_SHOW(state, "strip_formula", m->formula);
    OVR_SHOW(state, "strip_coupling", m->coupling);
    ovr_show(state, "strip_nearness", m->nearness, sizeof m->nearness);
    ovr_show(state, "strip_mass", s->mass, sizeof s->mass);
    ovr_show(state, "strip_least", s->least, sizeof s->least);
}

static const ovr_physics_in_case in_case = {
    .section = &ovr_strip_section,
    .sections = 1,
    .behind = "domain",
    .form = sizeof(ovr_strip_form),
    .choose = ovr_strip_choose,
    .resolve = ovr_strip_resolve,
    .on_mesh = ovr_strip_on_mesh,
    .effects = ovr_strip_state,
    .describe = ovr_strip_describe,
    .seconds = ovr_strip_seconds,
    .cycle_seconds = ovr_strip_cycle_seconds,
    .lines_across = ovr_strip_lines_across,
    .one_mesh = "of a strip"};

static const ovr_physics_in_solve in_solve = {
    .take = create,
    .release = release,
    .solver = &(const ovr_solver){ovr_strip_steady_film, attempt, step_back,
                                  ovr_strip_observe, show, lines_of},
    .explain = ovr_strip_explain,
    .begin = begin};

static const ovr_physics_in_step in_step = {.check = check, .visit = visit};

static const ovr_physics_in_output in_output = {
    .unknown = ovr_strip_unknown,
    .quantity = ovr_strip_quantities,
    .quantities = OVR_STRIP_QUANTITIES};

const ovr_physics ovr_physics_strip = {.name = "strip",
                                       .bit = OVR_PHYSICS_STRIP,
                                       .in_case = &in_case,
                                       .in_solve = &in_solve,
                                       .in_step = &in_step,
                                       .in_output = &in_output};
