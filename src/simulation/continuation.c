/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A time step by continuation. If the load jumps or the film fills the outlet,
 * the new pressure differs from the last by tenths of p_h. Cycles converge only
 * for initial errors up to about 1/alphabar. The two are connected by a path
 * (Keller's global homotopy)
 *
 *     N(P) = F - (1 - s) r(P^k),   D sum P = w_s,   s = 0..1
 *
 * where r(P^k) is the residual of the last solution P^k in the equations of the
 * step, and w_s is interpolated between the last load and the new one. At s = 0
 * the solution is P^k; at s = 1 it is that of the step. With mass-conserving
 * cavitation the rows of cavitated nodes and their contents q are part of the
 * path.  The initial guess on the path is extrapolated linearly from the two
 * previous solutions. A step of s that fails is halved, after restoring
 * pressure, contents and inlet of the last solution.
 */
#include <math.h>
#include <string.h>

#include "contact/film_formula.h"
#include "multigrid/film_end.h"
#include "multigrid/local_newton.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/steady.h"
#include "simulation/step_cycles.h"

typedef struct path {
    ovr_simulation *sim;
    double load[2];
    double s;          /* s for which the equations are set */
    double at, before; /* s of the last two solutions */
    double H0, H0_before;
} path;

/* Sets the equations for s. */
static void set_equations(path *p, double s)
{
    ovr_simulation *sim = p->sim;
    ovr_level *finest = sim->finest;
    double *F = ovr_work_take(sim);
    ovr_nodes_read(sim, finest, finest->f.F, F);
    sim->grids.kernels->combine(finest->grid.n, 1, F, s - p->s,
                                sim->start.lacking, F);
    ovr_nodes_write(sim, finest, F, finest->f.F);
    ovr_work_give(sim, F);
    finest->force = p->load[0] + s * (p->load[1] - p->load[0]);
    if (s == 1)
        finest->force = p->load[1];
    p->s = s;
}

/* Extrapolates P and H0 for s from the last two solutions, at pressurized
 * nodes. */
static void begin_from(const path *p, double s)
{
    ovr_simulation *sim = p->sim;
    double stretch = p->at - p->before;
    double factor = stretch > 0 ? (s - p->at) / stretch : 0;
    const double weight[] = {1 + factor, -factor};
    const double *const from[] = {sim->start.saved, sim->start.saved_before};
    double *P = ovr_work_take(sim);
    sim->grids.kernels->extrapolate(sim->finest->grid.n, 2, weight, from, P);
    ovr_nodes_write(sim, sim->finest, P, sim->finest->f.P);
    ovr_work_give(sim, P);
    OVR_EACH_PHYSICS(sim, each, in_step, go_back)
        each->is->in_step->go_back(sim, each->own, sim->start.saved);
    sim->grids.H0 = p->H0 + factor * (p->H0 - p->H0_before);
}

static void keep(path *p)
{
    ovr_simulation *sim = p->sim;
    size_t bytes = sim->now.n * sizeof(double);
    memcpy(sim->start.saved_before, sim->start.saved, bytes);
    memcpy(sim->start.saved, sim->now.P, bytes);
    OVR_EACH_PHYSICS(sim, each, in_step, keep)
        each->is->in_step->keep(sim, each->own);
    p->before = p->at;
    p->H0_before = p->H0;
    p->at = p->s;
    p->H0 = sim->grids.H0;
}

static path begin(ovr_simulation *sim)
{
    ovr_level *finest = sim->finest;
    double H0 = sim->past.H0[0];
    path p = {sim, {0, finest->force}, 1, 0, 0, H0, H0};
    ovr_level_refresh(&sim->grids, finest);
    ovr_nodes_read(sim, finest, finest->f.P, sim->start.saved);
    OVR_EACH_PHYSICS(sim, each, in_step, keep)
        each->is->in_step->keep(sim, each->own);
    ovr_nodes_read(sim, finest, finest->f.r, sim->start.lacking);
    p.load[0] = ovr_level_load(&sim->grids, finest);
    return p;
}

bool ovr_step_continued(ovr_simulation *sim, const ovr_cycling *cycle,
                        ovr_outcome *outcome)
{
    enum { MAX = 400, A_POINT = 10, THE_LAST = 40 };
    const double minimum = 1. / 256, loose = 1e-3, hopeless = 1e5;
    int maximum = outcome->cycles + MAX;
    bool failed = false;
    double ds = 0.25;
    path p = begin(sim);
    while (p.at < 1 && ds >= minimum && outcome->cycles < maximum) {
        double s = fmin(1, p.at + ds);
        ovr_step_cycling how = {*cycle, false, s < 1 ? A_POINT : THE_LAST,
                                hopeless, s < 1 ? loose : 0};
        begin_from(&p, s);
        set_equations(&p, s);
        bool found = ovr_step_cycles(sim, how, outcome);
        if (found)
            keep(&p);
        ds *= !found ? 0.5 : failed ? 1 : 2;
        failed = !found;
    }
    set_equations(&p, 1);
    return p.at == 1;
}

/* ------------------------------------ steady solution with growing features */

/*
 * Pseudo-transient continuation for steady contacts of rough surfaces, in which
 * full multigrid fails: the film approaches the steady state in a pseudo-time t
 * ( Kelley and Keyes, SIAM J. Numer. Anal. 35 (1998) 508):
 *
 *     N(P) - (q - q_before)/dt = F,  q = rho H
 *     gap(t) = smooth gap - min(1, t) S
 *
 * The surfaces do not move and grow from smooth ones. In backward Euler steps
 * pressure spikes and film ends move by a fraction of D, which local solves
 * handle as in time (local_newton.h, film_end.h).  Initial errors leave the
 * domain until about t = 6. Steps of increasing length then approach the steady
 * film; each of the last steps reduces the error by a factor of hundreds. A
 * step that fails is repeated with smaller changes and half corrections, then
 * by Newton's method (step.c), and then halved.
 */

typedef struct settling {
    ovr_simulation *sim;
    const ovr_full *how;
    double *gap, *F;  /* gap and history term of the steady problem */
    double *S;        /* difference of the gap from the smooth one */
    double *q, *P;    /* lubricant content and pressure of the last step */
    double H0;        /* H0 of the last step */
    double t, dt;     /* time of the last step; length of the next step */
    bool grown;       /* features have their full height from the beginning */
    double tolerance; /* tolerance of the steady film */
    int cycles;
    int hard; /* successive steps for which the first method failed */
} settling;

/* Sets the operator with the time derivative of a step; dt = INFINITY: steady.
 */
static void set_operator(ovr_simulation *sim, double dt)
{
    ovr_operator op = {.speed = sim->target.Cu, .cT = 1 / dt};
    op.transient = dt < INFINITY;
    ovr_reynolds_wedge(&op, sim->scheme->order == 2, op.speed);
    OVR_EACH_PHYSICS(sim, p, in_step, operate)
        p->is->in_step->operate(sim, p->own, op.transient ? dt : 0, &op);
    ovr_hierarchy_operator(&sim->grids, &op);
}

/* Sets the equations of a step dt, or of the steady film. */
static void set_grown(const settling *s, double dt)
{
    ovr_simulation *sim = s->sim;
    double *side = ovr_work_take(sim);
    set_operator(sim, dt);
    sim->grids.kernels->combine(sim->now.n, 1, s->F, -1 / dt, s->q, side);
    ovr_nodes_write(sim, sim->finest, side, sim->finest->f.F);
    ovr_work_give(sim, side);
}

static void set_gap(const settling *s, double t)
{
    ovr_simulation *sim = s->sim;
    double *gap = ovr_work_take(sim), missing = s->grown ? 0 : fmax(0, 1 - t);
    sim->grids.kernels->combine(sim->now.n, 1, s->gap, missing, s->S, gap);
    ovr_nodes_write(sim, sim->finest, gap, sim->finest->f.gap);
    ovr_work_give(sim, gap);
}

static void keep_film(settling *s)
{
    ovr_simulation *sim = s->sim;
    ovr_nodes_read(sim, sim->finest, sim->finest->f.q, s->q);
    ovr_nodes_read(sim, sim->finest, sim->finest->f.P, s->P);
    s->H0 = sim->grids.H0;
}

static void restore(const settling *s)
{
    ovr_nodes_write(s->sim, s->sim->finest, s->P, s->sim->finest->f.P);
    s->sim->grids.H0 = s->H0;
}

static void settle_spots(const settling *s, int times)
{
    const ovr_hierarchy *grids = &s->sim->grids;
    while (!grids->touch.at && times-- > 0 &&
           ovr_local_newton(grids, s->sim->finest))
        continue;
}

static void settle_ends(const settling *s)
{
    if (!s->sim->grids.conserving)
        ovr_move_cavitation_boundary(&s->sim->grids, s->sim->finest);
}

/* Performs cycles on the equations of a step. The residual need not fall below
 * a fraction of its initial value, because the next step corrects the remaining
 * error. */
static bool relaxed(settling *s, const ovr_cycling *cycling, int maximum)
{
    const double share = 0.02, hopeless = 1e6, load_share = 0.1, load = 1e-6;
    ovr_hierarchy *grids = &s->sim->grids;
    ovr_level *finest = s->sim->finest;
    double enough = 0;
    ovr_level_refresh(grids, finest);
    settle_spots(s, 2);
    settle_ends(s);
    for (int k = 0;; k++) {
        ovr_defect d = ovr_cycle_defect(grids, finest);
        if (!k)
            enough = fmax(s->tolerance, share * d.imbalance);
        else if (d.imbalance < enough &&
                 d.load < fmax(load, load_share * d.imbalance))
            return true;
        if (!(d.imbalance < hopeless) || k == maximum ||
            ovr_hierarchy_stops(grids))
            return false;
        ovr_cycle(grids, finest, *cycling);
        s->cycles++;
        if (!k)
            settle_spots(s, 1);
        settle_ends(s);
    }
}

/* Solves a step on the finest grid only, with positive film thicknesses. */
static bool stepped_by_newton(settling *s)
{
    ovr_cycling c = s->how->cycling;
    ovr_outcome outcome = {0};
    c.newton_limit = 1;
    restore(s);
    set_gap(s, s->t + s->dt);
    set_grown(s, s->dt);
    bool found = ovr_step_newton(s->sim, &c, &outcome);
    s->cycles += outcome.cycles;
    return found;
}

/* Solves a step by one of three methods of increasing cost and robustness.
 * *hard is set if the first one failed. */
static bool stepped_by_cycles(settling *s, bool *hard)
{
    static const struct {
        int sweeps, maximum;
        double limit, correction;
    } methods[] = {{1, 15, 0.2, 1}, {2, 40, 0.05, 1}, {2, 40, 0.05, 0.5}};
    for (int k = 0; k < 3; k++) {
        ovr_cycling c = s->how->cycling;
        c.sweeps_before = c.sweeps_after = methods[k].sweeps;
        c.smoothing.limit = methods[k].limit;
        c.correction = methods[k].correction;
        restore(s);
        set_gap(s, s->t + s->dt);
        set_grown(s, s->dt);
        *hard = k > 0;
        if (relaxed(s, &c, methods[k].maximum))
            return true;
    }
    return false;
}

/* Solves a step by cycles, then by Newton's method. After several hard steps
 * Newton's method is first, which takes 2 or 3 steps for 20 to 100 cycles. */
static bool stepped(settling *s)
{
    enum { PATIENCE = 3 };
    const bool newton_first = s->hard >= PATIENCE;
    bool hard;
    if (newton_first && stepped_by_newton(s))
        return true;
    if (stepped_by_cycles(s, &hard)) {
        s->hard = hard && !newton_first ? s->hard + 1 : 0;
        return true;
    }
    s->hard = newton_first ? 0 : s->hard + 1;
    return !newton_first && stepped_by_newton(s);
}

static ovr_defect steady_defect(const settling *s)
{
    ovr_simulation *sim = s->sim;
    set_operator(sim, INFINITY);
    ovr_nodes_write(sim, sim->finest, s->F, sim->finest->f.F);
    set_gap(s, 1);
    ovr_level_refresh(&sim->grids, sim->finest);
    return ovr_cycle_defect(&sim->grids, sim->finest);
}

/* True if the total work of this solve exceeds that of successful starts (5e7
 * node cycles). */
static bool is_spent(const settling *s)
{
    const double largest = 1e8, dense = 5e3;
    const ovr_hierarchy *grids = &s->sim->grids;
    double bottom = (double)grids->level[s->how->cycling.bottom].grid.n;
    double cost = (double)s->sim->now.n + bottom * bottom * bottom / dense;
    return (double)(s->sim->start.settling + s->cycles) * cost > largest;
}

/* Performs steps until the film is steady, a step fails, or the maximum work is
 * reached. */
static ovr_defect settle(settling *s)
{
    enum { MAX = 60000, QUICK = 6 };
    const double D = ovr_mesh(s->sim), longer = 1.5, minimum = D / 512;
    ovr_defect d = {.imbalance = INFINITY};
    s->tolerance = s->how->tolerance(s->how->data, s->sim->finest,
                                     s->sim->observation.H_cen);
    keep_film(s);
    while (s->cycles < MAX && s->dt >= minimum && !is_spent(s) &&
           !ovr_hierarchy_stops(&s->sim->grids)) {
        int before = s->cycles;
        if (!stepped(s)) {
            restore(s);
            s->dt /= 2;
            continue;
        }
        s->t += s->dt;
        if (s->cycles - before <= QUICK)
            s->dt *= longer;
        keep_film(s);
        if (!s->grown && s->t < 1)
            continue;
        d = steady_defect(s);
        s->tolerance = s->how->tolerance(s->how->data, s->sim->finest,
                                         d.centre);
        if (ovr_below(d, s->tolerance))
            return d;
    }
    return steady_defect(s);
}

static settling begin_settling(ovr_simulation *sim, const ovr_full *how)
{
    settling s = {.sim = sim,
                  .how = how,
                  .gap = sim->start.lacking,
                  .F = sim->past.q[1],
                  .S = sim->start.saved_before,
                  .q = sim->past.q[0],
                  .P = sim->start.saved};
    const ovr_smooth smooth = ovr_simulation_smooth(sim, 0);
    ovr_nodes_read(sim, sim->finest, sim->finest->f.gap, s.gap);
    for (size_t i = 0; i < sim->now.n; i++)
        s.S[i] = ovr_smooth_at(&smooth, sim->now.X[i]) - s.gap[i];
    return s;
}

ovr_defect ovr_steady_grown(ovr_simulation *sim, const ovr_full *how,
                            int *cycles)
{
    ovr_full own = *how;
    settling s = begin_settling(sim, how);
    s.dt = ovr_mesh(sim);
    own.watch = NULL;
    set_gap(&s, 0);
    ovr_full_multigrid(&sim->grids, &sim->target, own, cycles);
    ovr_nodes_read(sim, sim->finest, sim->finest->f.F, s.F);
    ovr_defect d = settle(&s);
    *cycles += s.cycles;
    sim->start.settling += s.cycles;
    return d;
}

ovr_defect ovr_steady_settled(ovr_simulation *sim, const ovr_full *how,
                              int *cycles)
{
    settling s = begin_settling(sim, how);
    s.dt = 1;
    s.grown = true;
    ovr_nodes_read(sim, sim->finest, sim->finest->f.F, s.F);
    ovr_level_refresh(&sim->grids, sim->finest);
    ovr_defect d = settle(&s);
    *cycles += s.cycles;
    sim->start.settling += s.cycles;
    return d;
}
