/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourth-order corrections of the steady solution and of a run.
 *
 * With the characteristic scheme, the corrections of a step are computed from
 * the previous solution: the spatial corrections of Poiseuille flow and film,
 * recomputed after each step (multigrid/fourth_order.h), and the correction of
 * BDF2 in time along the characteristic,
 *     F_i = -m_i dN_Poiseuille + dT (dT + dT_old) q[t, t-1, t-2, t-3],
 * with the third divided difference of q along the path of a particle: with
 * equal steps (q - 3 q_1 + 3 q_2 - q_3)/(3 dT), the term by which BDF3 differs.
 * It is zero for convected contents, and equals the error of the steady wedge
 * for stationary films, for any step and speed.  Poiseuille's m_i is 1 where P
 * > 0 at i - 3..i + 3, and decreases to 0 over eight nodes to the film end,
 * whose position is interpolated between nodes, so that it does not jump when
 * the end crosses a node: a spike close to the end would respond with a jump.
 * The third difference and R below do not decrease: the minimum film thickness
 * lies in these last nodes, and with steps of two mesh sizes its error would be
 * up to ten times larger.  Both are 0 near ridges where the film thickness
 * halves within a mesh size. Later attempts of a step (step.c) omit F. With
 * temperatures, the corrections of the steady film are recomputed after each
 * outer iteration; if this does not converge, the solution is of second order.
 *
 * Where load, speed and radius are constant, the steady start also satisfies
 * the equations of a step of any length: F includes the residual of the steady
 * film q_s,
 *     R_i = F_s + Cu (1.5 q_i - 2 q_{i-1} + 0.5 q_{i-2})/D - BDF2(q_s) -
 * F(q_s), its own correction F_s and wedge minus those of a step. With
 * mass-conserving cavitation R is a difference of flows (fourth_content.h).
 *
 * With upstream2 a run adds the corrections of its steady start to the
 * right-hand sides of every step: they remove the second-order error of the
 * background, but not that of moving features. The corrections must not include
 * moving features: they are computed for the smooth surfaces with stationary
 * features of full height. They are valid for constant load, speed and radius
 * (with a rheological model also constant sliding speed); if these vary, start
 * and run are of second order.
 */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "multigrid/content.h"
#include "multigrid/starved.h"
#include "simulation/fourth.h"
#include "simulation/fourth_content.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"
#include "simulation/steady.h"

extern const ovr_physics ovr_physics_fourth;

typedef struct fourth {
    ovr_correction correction;
    double *F, *gap; /* corrections kept for a run, by nodes */
    size_t n; /* nodes of the finest grid of the whole domain, without patches
               */
    /* characteristic scheme: corrections follow the solution; third divided
     * difference and its weight in a step; the later attempts of a step omit F
     */
    int follows;
    double *third, factor;
    bool without;
    double *next; /* correction of the gap for the next step; `gap` is that of
                   * the last step, with which its film was solved */
    bool ahead;   /* the next step is being solved */
    /* For constant operating conditions: q_s, and the part of R that is
     * independent of the step. `mask` is m, negative where R is omitted; with
     * mass-conserving cavitation it contains the flows psi. `rest` is R of a
     * step of length rest_dT. */
    int rests;
    double *start, *constant, *mask, *rest, rest_dT;
    ovr_fourth_content content; /* with mass-conserving cavitation */
} fourth;

static bool chosen(const ovr_options *o)
{
    return o->order == 4;
}

static ovr_status create(ovr_simulation *sim, const void *form, void **own,
                         ovr_error *err)
{
    fourth *f = ovr_arena_take(&sim->arena, 1, sizeof *f, err);
    (void)form;
    if (!f)
        return OVR_NO_MEMORY;
    *own = f;
    f->n = sim->finest->grid.n;
    ovr_correction_prepare(&sim->grids, &f->correction, &sim->arena, err);
    if (OVR_TAKE_NODES(sim, err, &f->F, &f->gap, &f->third, &f->next, &f->start,
                       &f->constant, &f->mask, &f->rest))
        return OVR_NO_MEMORY;
    return ovr_conserves(sim) ? ovr_fourth_content_take(sim, &f->content, err)
                              : OVR_OK;
}

/* ------------------------------------------------------------------- steady */

/* Changes to second order. */
static void withdraw(ovr_simulation *sim, const fourth *f)
{
    size_t bytes = f->n * sizeof(double);
    sim->order = sim->scheme->order;
    memset(f->F, 0, bytes);
    memset(f->gap, 0, bytes);
    memset(f->third, 0, bytes);
}

static bool varies(const ovr_simulation *sim)
{
    return ovr_history_varies(sim->histories.load) ||
           ovr_history_varies(sim->histories.speed) ||
           ovr_history_varies(sim->histories.radius) ||
           ovr_history_varies(sim->histories.radius_1) ||
           (sim->lubricant.rheology != OVR_NEWTONIAN &&
            ovr_history_varies(sim->histories.sliding));
}

/* True if the corrections are valid for the whole run and for all elastic
 * parts. Another physical model may have changed to second order. */
static bool applies(const ovr_simulation *sim)
{
    bool fixed = !varies(sim) && !ovr_conserves(sim);
    return sim->options.order == 4 && (fixed || sim->scheme->characteristic) &&
           ovr_influence_corrected(&sim->grids.influence);
}

static void standing_heights(const ovr_simulation *sim, double *S)
{
    memset(S, 0, sim->now.n * sizeof *S);
    if (sim->shapes.standing)
        sim->shapes.standing(sim->shapes.standing_data, 0, sim->now.n,
                             sim->now.X, S);
}

/* True if a run has features at T = 0 that are not stationary. */
static bool has_moving_features(ovr_simulation *sim)
{
    size_t n = sim->now.n;
    if (!sim->shapes.standing_given || !sim->shapes.heights)
        return false;
    double *S = ovr_work_take(sim);
    ovr_surface_heights(sim, 0, n, sim->now.X, sim->shapes.S);
    standing_heights(sim, S);
    bool apart = sim->grids.kernels->difference(n, S, sim->shapes.S) > 0;
    ovr_work_give(sim, S);
    return apart;
}

/* Sets the finest gap of the stationary features alone. */
static void standing_gap(ovr_simulation *sim)
{
    const ovr_smooth smooth = ovr_simulation_smooth(sim, 0);
    double *gap = ovr_work_take(sim);
    standing_heights(sim, gap);
    for (size_t i = 0; i < sim->now.n; i++)
        gap[i] = ovr_smooth_at(&smooth, sim->now.X[i]) - gap[i];
    ovr_nodes_write(sim, sim->finest, gap, sim->finest->f.gap);
    ovr_work_give(sim, gap);
}

/* Tolerance of a solution that will be corrected: its discretization error. */
static double first_tolerance(const void *data, const ovr_level *level,
                              double H)
{
    const ovr_simulation *sim = data;
    double target = ovr_steady_tolerance(sim, level, H);
    if (sim->order == 4 && level == sim->finest)
        return fmax(target, ovr_truncation_tolerance(
                                sim, ovr_grid_mesh(&level->grid), H));
    return target;
}

static ovr_defect film(ovr_simulation *sim, const ovr_full *how, int *cycles)
{
    ovr_full first = *how;
    first.tolerance = first_tolerance;
    return ovr_steady_film(sim, &first, cycles);
}

/* A stored solution. */
typedef struct found {
    double *P, H0;
} found;

static found keep(const ovr_simulation *sim)
{
    const ovr_level *level = sim->finest;
    ovr_nodes_read(sim, level, level->f.P, sim->start.saved);
    return (found){sim->start.saved, sim->grids.H0};
}

static ovr_defect fall_back(ovr_simulation *sim, const fourth *f,
                            const ovr_full *how, const found *second,
                            int *cycles)
{
    ovr_nodes_write(sim, sim->finest, second->P, sim->finest->f.P);
    sim->grids.H0 = second->H0;
    withdraw(sim, f);
    ovr_simulation_gap(sim, 0);
    ovr_level_clear(sim->finest, sim->finest->f.F);
    return ovr_steady_cycles(sim, how, cycles);
}

/* Solves the film and computes its corrections, for the present gap. If the
 * mesh is barely fine enough, this takes up to 160 cycles. */
static ovr_defect solve_and_correct(ovr_simulation *sim, const fourth *f,
                                    const ovr_full *how, int *cycles)
{
    const ovr_correction *c = &f->correction;
    ovr_full last = *how;
    last.max_cycles = ovr_steady_max_cycles(sim, 200);
    ovr_defect d = film(sim, how, cycles);
    if (sim->order != 4 ||
        !ovr_below(d, first_tolerance(sim, sim->finest, d.centre)))
        return d;
    found second = keep(sim);
    if (!ovr_fourth_solve(&sim->grids, c, &last, &d, cycles) &&
        !ovr_below_rounding(sim, &d))
        return fall_back(sim, f, how, &second, cycles);
    ovr_nodes_read(sim, sim->finest, c->F, f->F);
    ovr_nodes_read(sim, sim->finest, c->gap, f->gap);
    return d;
}

/* Solves the film, with corrections for stationary features. */
static ovr_defect solve_corrected(ovr_simulation *sim, const fourth *f,
                                  const ovr_full *how, int *cycles)
{
    ovr_defect d = film(sim, how, cycles);
    if (!ovr_below(d, first_tolerance(sim, sim->finest, d.centre)))
        return d;
    found second = keep(sim);
    ovr_nodes_write(sim, sim->finest, f->F, sim->finest->f.F);
    d = ovr_steady_cycles(sim, how, cycles);
    if (ovr_below(d, ovr_steady_tolerance(sim, sim->finest, d.centre)))
        return d;
    return fall_back(sim, f, how, &second, cycles);
}

/* ---------------------------------------------- steady and mass-conserving */

static void evaluate_content(ovr_simulation *sim, fourth *f)
{
    ovr_simulation_read(sim);
    ovr_fourth_content_evaluate(sim, &f->content, &f->correction,
                                sim->grids.op.speed, f->F, f->gap);
}

/* Replaces the corrections in F of the finest level by those of the present
 * film, and updates film and residual. */
static void correct_content(ovr_simulation *sim, fourth *f)
{
    const ovr_kernels *run = sim->grids.kernels;
    double *F = f->rest; /* array is unused here */
    ovr_nodes_read(sim, sim->finest, sim->finest->f.F, F);
    run->combine(f->n, 1, F, -1, f->F, F);
    evaluate_content(sim, f);
    run->combine(f->n, 1, F, 1, f->F, F);
    ovr_nodes_write(sim, sim->finest, F, sim->finest->f.F);
    ovr_simulation_gap(sim, 0);
    ovr_level_properties(&sim->grids, sim->finest);
    ovr_level_residual(&sim->grids, sim->finest);
}

typedef struct correcting {
    ovr_simulation *sim;
    fourth *own;
} correcting;

static bool correct_after(void *data, ovr_hierarchy *grids, ovr_level *level,
                          ovr_cycle_end end)
{
    correcting *c = data;
    (void)grids, (void)level;
    if (end == OVR_AFTER_CYCLE)
        correct_content(c->sim, c->own);
    return false; /* film and residual are up to date */
}

static fourth *fourth_of(const ovr_simulation *sim)
{
    for (const ovr_present *p = sim->physics.on; p->is; p++)
        if (p->is == &ovr_physics_fourth)
            return p->own;
    return NULL;
}

void ovr_fourth_leave(ovr_simulation *sim)
{
    fourth *f = fourth_of(sim);
    if (!f || sim->order != 4)
        return;
    double *F = ovr_work_take(sim);
    ovr_nodes_read(sim, sim->finest, sim->finest->f.F, F);
    sim->grids.kernels->combine(f->n, 1, F, -1, f->F, F);
    ovr_nodes_write(sim, sim->finest, F, sim->finest->f.F);
    ovr_work_give(sim, F);
    withdraw(sim, f);
    ovr_simulation_gap(sim, 0);
    ovr_level_refresh(&sim->grids, sim->finest);
}

/* Performs cycles with a correction each; if they do not converge, restores the
 * previous film. */
ovr_defect ovr_fourth_conserved(ovr_simulation *sim, const ovr_full *how,
                                ovr_defect solved, int *cycles)
{
    fourth *f = fourth_of(sim);
    ovr_level *level = sim->finest;
    if (!f || !applies(sim) ||
        !ovr_below(solved, ovr_steady_tolerance(sim, level, solved.centre)))
        return solved;
    correcting data = {sim, f};
    const ovr_attached attached = {correct_after, &data, how->cycling.attached};
    ovr_full own = *how;
    double H0 = sim->grids.H0;
    own.cycling.attached = &attached;
    ovr_nodes_read(sim, level, level->f.P, sim->start.saved);
    ovr_nodes_read(sim, level, level->f.q, f->start);
    withdraw(sim, f);
    sim->order = 4;
    correct_content(sim, f);
    ovr_defect d = ovr_content_cycles(&sim->grids, &own, level, cycles);
    if (ovr_below(d, ovr_steady_tolerance(sim, level, d.centre)))
        return d;
    ovr_fourth_leave(sim);
    sim->grids.H0 = H0;
    ovr_nodes_write(sim, level, sim->start.saved, level->f.P);
    ovr_nodes_write(sim, level, f->start, level->f.q);
    ovr_content_wet(level, sim->start.saved);
    ovr_content_mark(level, level->f.wet, 0, !level->closed);
    return ovr_content_cycles(&sim->grids, how, level, cycles);
}

/* Recomputes the corrections for changed temperatures. */
void ovr_fourth_renew(ovr_simulation *sim)
{
    fourth *f = fourth_of(sim);
    if (!f || sim->order != 4)
        return;
    const ovr_correction *c = &f->correction;
    if (ovr_conserves(sim)) {
        evaluate_content(sim, f);
        ovr_simulation_gap(sim, 0);
        return;
    }
    ovr_fourth_evaluate(&sim->grids, c, sim->grids.op.speed, false);
    ovr_nodes_read(sim, sim->finest, c->F, f->F);
    ovr_nodes_read(sim, sim->finest, c->gap, f->gap);
    ovr_simulation_gap(sim, 0);
}

bool ovr_fourth_give_up(ovr_simulation *sim)
{
    fourth *f = fourth_of(sim);
    if (!f || sim->order != 4)
        return false;
    withdraw(sim, f);
    ovr_simulation_gap(sim, 0);
    return true;
}

/* Solves for the surfaces at T = 0. */
static ovr_defect solve(ovr_simulation *sim, void *own, const ovr_full *how,
                        int *cycles)
{
    fourth *f = own;
    withdraw(sim, f);
    f->follows = f->rests = f->ahead = false;
    if (applies(sim) && !ovr_conserves(sim)) /* otherwise after mass-conserving
                                              * cavitation is enabled */
        sim->order = 4;
    if (sim->order == 4 && has_moving_features(sim)) {
        standing_gap(sim);
        solve_and_correct(sim, f, how, cycles);
        ovr_simulation_gap(sim, 0);
        sim->start.refinements = 0;
        if (sim->order == 4)
            return solve_corrected(sim, f, how, cycles);
    }
    ovr_simulation_gap(sim, 0);
    return solve_and_correct(sim, f, how, cycles);
}

/* ----------------------------------------------------------------- in a run */

/* True at a ridge that the mesh does not resolve, where a correction would
 * remove the remaining film. */
static bool jumps(double H, double next)
{
    return H > 2 * next || next > 2 * H;
}

/* Position of the film end in mesh sizes: from the last pressurized node e
 * onwards by P_e/(P_{e-1} - 2 P_e), from 0 when e becomes pressurized to 1 when
 * the next node does, whose second difference is then P_e. */
static double film_end(const double *P, size_t n)
{
    size_t dry = n - 1;
    while (dry > 2 && !(P[dry - 1] > 0))
        dry--;
    double last = P[dry - 1], bend = P[dry - 2] - 2 * last;
    return (double)dry - 1 + (bend > last ? last / bend : 1);
}

/* True if H, or q, does not jump three nodes downstream. The third difference
 * is valid after more than six such nodes. */
enum { WET = 3 };
static bool is_smooth_ahead(const double *H, size_t i, size_t n)
{
    return i + WET < n && !jumps(H[i + WET - 1], H[i + WET]);
}

static bool carries_at(size_t i, size_t smooth, size_t n)
{
    return i >= OVR_FOURTH_MARGIN && i + OVR_FOURTH_MARGIN < n &&
           smooth > 2 * WET;
}

/* Multiplies F by m, and keeps the third difference where the film thickness
 * does not jump, because convected contents are smooth at the film end.
 * `carried` (may be NULL) is 1 there, else -1. If the speed is reversed, the
 * film ends on the left. */
static void fade(const ovr_simulation *sim, fourth *f, double *carried)
{
    enum { OVER = 8 };
    const double sharp = 3.5;
    const double *P = sim->now.P, *H = sim->now.H;
    size_t n = f->n, wet = 0, smooth = 0;
    double *image = ovr_work_take(sim);
    if (sim->histories.backward)
        ovr_mirror(n, P, image);
    const double end = film_end(sim->histories.backward ? image : P, n);
    ovr_work_give(sim, image);
    /* nodes upstream of this one, almost all, keep their values */
    const double fades = end - sharp - OVER - 1;
    for (size_t i = 0; i < n; i++) {
        bool inside = i >= OVR_FOURTH_MARGIN && i + OVR_FOURTH_MARGIN < n;
        size_t along = sim->histories.backward ? n - 1 - i : i, ahead = i + WET;
        bool jump = !is_smooth_ahead(H, i, n);
        smooth = jump ? 0 : smooth + 1;
        wet = jump || !(P[ahead] > 0) ? 0 : wet + 1;
        bool carries = carries_at(i, smooth, n);
        double m = inside && wet > 2 * WET ? 1 : 0;
        if (m > 0 && (double)along > fades)
            m = fmin(fmax((end - (double)along - sharp) / OVER, 0), 1);
        f->F[i] *= m;
        if (!carries)
            f->third[i] = 0;
        if (carried)
            carried[i] = carries ? 1 : -1;
    }
}

/* Computes the corrections from the newest solution at T; dT is the step before
 * it. */
static void evaluate(ovr_simulation *sim, fourth *f, double T, double dT,
                     double *mask)
{
    const ovr_correction *c = &f->correction;
    if (ovr_conserves(sim)) {
        ovr_fourth_content_evaluate(sim, &f->content, c, 0, f->F, f->next);
        if (T > 0)
            ovr_fourth_content_third(sim, &f->content, T, dT, f->third);
        return;
    }
    ovr_fourth_evaluate(&sim->grids, c, 0,
                        sim->histories.backward && !sim->histories.mirrored);
    ovr_nodes_read(sim, sim->finest, c->F, f->F);
    ovr_nodes_read(sim, sim->finest, c->gap, f->next);
    if (!ovr_inflow_third(sim, sim->now.q, T, dT, f->third))
        memset(f->third, 0, f->n * sizeof *f->third);
    fade(sim, f, mask);
}

/* Before the first step the state was steady: values for steps of one mesh
 * size. */
static void begin(ovr_simulation *sim, void *own)
{
    fourth *f = own;
    double D = ovr_mesh(sim),
           Cu = fabs(ovr_history_value(sim->histories.speed, 0));
    const double *q = sim->now.q;
    f->follows = sim->order == 4 && sim->scheme->characteristic;
    f->ahead = false;
    f->rests = f->follows && !varies(sim) && !has_moving_features(sim);
    f->rest_dT = 0;
    if (!f->follows)
        return;
    memcpy(f->start, q, f->n * sizeof *q);
    for (size_t i = 2; i < f->n; i++)
        f->constant[i] = f->F[i] +
                         Cu * (1.5 * q[i] - 2 * q[i - 1] + 0.5 * q[i - 2]) / D;
    evaluate(sim, f, 0, D / fmax(Cu, OVR_MIN_START), f->mask);
    for (size_t i = 2; i < f->n; i++)
        f->constant[i] -= f->F[i];
}

/* Computes R for a step dT. */
static void rest(ovr_simulation *sim, fourth *f, double dT)
{
    if (ovr_conserves(sim)) {
        ovr_fourth_content_rest(sim, &f->content, dT, f->start, f->constant,
                                f->mask);
        f->rest_dT = dT;
        return;
    }
    static const double bdf2[] = {1.5, -2, 0.5, 0},
                        third[] = {1. / 3, -1, 1, -1. / 3};
    double a = fabs(ovr_history_value(sim->histories.speed, 0)) * dT;
    double *more = ovr_work_take(sim);
    size_t from = 0, n = f->n;
    memset(more, 0, n * sizeof *more);
    memcpy(f->rest, f->constant, n * sizeof *more);
    for (int k = 0; k < 4; k++) {
        ovr_inflow_departure(sim, f->start, -bdf2[k] / dT, k * a, f->rest);
        from = ovr_inflow_departure(sim, f->start, -third[k] / dT, k * a, more);
    }
    for (size_t i = 0; i < n; i++) {
        bool used = i >= from && f->mask[i] >= 0;
        f->rest[i] = used ? f->rest[i] + f->mask[i] * more[i] : 0;
    }
    f->rest_dT = dT;
    ovr_work_give(sim, more);
}

/* Computes the third difference for a first step dT, from stored contents, so
 * that a resumed run has the same. begin() has assumed one mesh size. */
static void third_at_start(ovr_simulation *sim, fourth *f, double dT)
{
    double D = ovr_mesh(sim),
           Cu = fabs(ovr_history_value(sim->histories.speed, 0));
    const double *q = sim->past.q[0];
    if (fabs(Cu * dT - D) < 1e-9 * D)
        return;
    if (!ovr_inflow_third(sim, q, sim->past.T[0], dT, f->third))
        memset(f->third, 0, f->n * sizeof *f->third);
    for (size_t i = 0, smooth = 0; i < f->n; i++) {
        smooth = is_smooth_ahead(q, i, f->n) ? smooth + 1 : 0;
        if (!carries_at(i, smooth, f->n))
            f->third[i] = 0;
    }
}

static void before_step(ovr_simulation *sim, void *own, double T)
{
    fourth *f = own;
    double dT = T - sim->past.T[0], old = sim->past.dT;
    bool reaches = ovr_inflow_reaches(sim, 3 * dT);
    f->without = false;
    f->ahead = f->follows;
    f->factor = dT * (dT + (old > 0 ? old : dT));
    if (f->follows && ovr_conserves(sim) && !(old > 0))
        ovr_fourth_content_begin(sim, &f->content, dT, f->third);
    else if (f->follows && !(old > 0))
        third_at_start(sim, f, dT);
    if (f->rests && reaches && fabs(dT - f->rest_dT) > 1e-9 * dT)
        rest(sim, f, dT);
    else if (f->rests && !reaches)
        memset(f->rest, 0, f->n * sizeof *f->rest);
    if (f->rests && reaches && ovr_conserves(sim))
        ovr_fourth_content_rows(sim, &f->content, f->mask, f->rest);
}

static void accepted(ovr_simulation *sim, void *own, double dT)
{
    fourth *f = own;
    if (!f->follows)
        return;
    memcpy(f->gap, f->next, f->n * sizeof *f->gap);
    f->ahead = false;
    evaluate(sim, f, sim->past.T[0] + dT, dT, NULL);
}

static void add(const ovr_simulation *sim, size_t n, double *to, double factor,
                const double *what)
{
    if (sim->order == 4)
        sim->grids.kernels->combine(n, 1, to, factor, what, to);
}

static void add_all(const ovr_simulation *sim, const fourth *f, double sign,
                    double *F)
{
    add(sim, f->n, F, sign, f->F);
    if (f->follows)
        add(sim, f->n, F, sign * f->factor, f->third);
    if (f->rests)
        add(sim, f->n, F, sign, f->rest);
}

bool ovr_fourth_follows(const ovr_simulation *sim)
{
    const fourth *f = fourth_of(sim);
    return f && f->follows;
}

void ovr_fourth_sides(const ovr_simulation *sim, double *F)
{
    const fourth *f = fourth_of(sim);
    if (f)
        add_all(sim, f, 1, F);
}

/* A step can fail because of its corrections, which were computed from the
 * previous film. */
static void attempt(ovr_simulation *sim, void *own, bool corrected)
{
    fourth *f = own;
    if (corrected || f->without || !f->follows)
        return;
    double *F = ovr_work_take(sim);
    f->without = true;
    ovr_nodes_read(sim, sim->finest, sim->finest->f.F, F);
    add_all(sim, f, -1, F);
    ovr_nodes_write(sim, sim->finest, F, sim->finest->f.F);
    ovr_work_give(sim, F);
    if (sim->F_before_heat)
        add_all(sim, f, -1, sim->F_before_heat);
}

static void before_back(ovr_simulation *sim, void *own)
{
    fourth *f = own;
    (void)sim;
    f->ahead = false;
}

void ovr_fourth_gap(const ovr_simulation *sim, double *gap)
{
    const fourth *f = fourth_of(sim);
    if (f)
        add(sim, f->n, gap, 1, f->ahead ? f->next : f->gap);
}

static void visit(ovr_simulation *sim, void *own, ovr_pieces *state)
{
    fourth *f = own;
    size_t bytes = f->n * sizeof(double);
    if (sim->order != 4)
        return;
    ovr_show(state, "F_fourth", f->F, bytes);
    ovr_show(state, "gap_fourth", f->gap, bytes);
    OVR_SHOW(state, "follows_fourth", f->follows);
    if (f->follows) {
        ovr_show(state, "third_fourth", f->third, bytes);
        ovr_show(state, "gap_next", f->next, bytes);
        if (ovr_conserves(sim))
            ovr_show(state, "bend_fourth", f->content.bend, bytes);
    }
    OVR_SHOW(state, "rests_fourth", f->rests);
    if (f->rests) {
        ovr_show(state, "rest_start", f->start, bytes);
        ovr_show(state, "rest_constant", f->constant, bytes);
        ovr_show(state, "rest_mask", f->mask, bytes);
        /* valid if the step length is the same except for rounding */
        ovr_show(state, "rest", f->rest, bytes);
        OVR_SHOW(state, "rest_dT", f->rest_dT);
        if (ovr_conserves(sim))
            ovr_show(state, "rest_begun", f->content.begun, bytes);
    }
}

static const ovr_physics_in_solve in_solve = {
    .chosen = chosen, .take = create, .solve = solve, .begin = begin};

static const ovr_physics_in_step in_step = {.before_step = before_step,
                                            .attempt = attempt,
                                            .accepted = accepted,
                                            .before_back = before_back,
                                            .visit = visit};

const ovr_physics ovr_physics_fourth = {
    .name = "fourth order", .in_solve = &in_solve, .in_step = &in_step};

void ovr_simulation_standing(ovr_simulation *sim, ovr_heights *standing,
                             void *data)
{
    if (!sim)
        return;
    sim->shapes.standing = standing;
    sim->shapes.standing_data = data;
    sim->shapes.standing_given = true;
}

int ovr_simulation_order(const ovr_simulation *sim)
{
    if (!sim)
        return 0;
    return sim->order;
}
