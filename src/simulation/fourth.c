/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourth order of the steady solution, and what a run keeps of it.
 *
 * A run adds the corrections of its steady start to the right-hand sides of
 * every step: they take the background's error of second order away, that of
 * what moves stays.  So they must not hold what moves: they are those of the
 * smooth surfaces with what stands still, fully grown.  They are right for
 * one load, speed and radius, with a flow law one sliding speed; where these
 * vary, start and run are of second order.
 */
#include <math.h>
#include <string.h>

#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/steady.h"

typedef struct fourth {
    ovr_correction correction;
    double *F, *gap; /* what a run keeps of it, by nodes */
    size_t n; /* of the finest grid of the whole domain, without patches */
} fourth;

static bool chosen(const ovr_options *o)
{
    return o->order == 4;
}

static ovr_status take(ovr_simulation *sim, const void *form, void **own,
                       ovr_error *err)
{
    fourth *f = ovr_arena_take(&sim->arena, 1, sizeof *f, err);
    size_t n = sim->finest->grid.n;
    (void)form;
    if (!f ||
        ovr_correction_prepare(&sim->grids, &f->correction, &sim->arena, err))
        return OVR_NO_MEMORY;
    *own = f;
    f->n = n;
    f->F = ovr_arena_take(&sim->arena, n, sizeof *f->F, err);
    f->gap = ovr_arena_take(&sim->arena, n, sizeof *f->gap, err);
    return f->F && f->gap ? OVR_OK : OVR_NO_MEMORY;
}

/* ------------------------------------------------------------------- steady */

/* Second order after all. */
static void withdraw(ovr_simulation *sim, const fourth *f)
{
    size_t bytes = f->n * sizeof(double);
    sim->order = sim->scheme->order;
    memset(f->F, 0, bytes);
    memset(f->gap, 0, bytes);
}

/* Whether one correction holds for the whole run, and all that deforms is known
 * to it.  Another physics may have taken fourth order back. */
static bool applies(const ovr_simulation *sim)
{
    bool varies = ovr_history_varies(sim->load) ||
                  ovr_history_varies(sim->speed) ||
                  ovr_history_varies(sim->radius) ||
                  ovr_history_varies(sim->radius_1) ||
                  (sim->lubricant.rheology != OVR_NEWTONIAN &&
                   ovr_history_varies(sim->sliding));
    return sim->options.order == 4 && !varies &&
           ovr_influence_corrected(&sim->grids.influence);
}

static void standing_heights(const ovr_simulation *sim, double *S)
{
    memset(S, 0, sim->now.n * sizeof *S);
    if (sim->standing)
        sim->standing(sim->standing_data, 0, sim->now.n, sim->now.X, S);
}

/* Whether a run has surfaces at T = 0 other than those that stand still. */
static bool stands_apart(ovr_simulation *sim)
{
    size_t n = sim->now.n;
    double *S = sim->scratch[0];
    if (!sim->standing_given || !sim->heights)
        return false;
    ovr_surface_heights(sim, 0, n, sim->now.X, sim->S);
    standing_heights(sim, S);
    return sim->grids.kernels->difference(n, S, sim->S) > 0;
}

/* The finest gap of those alone. */
static void standing_gap(ovr_simulation *sim)
{
    const ovr_smooth smooth = ovr_simulation_smooth(sim, 0);
    double *gap = sim->scratch[0];
    standing_heights(sim, gap);
    for (size_t i = 0; i < sim->now.n; i++)
        gap[i] = ovr_smooth_at(&smooth, sim->now.X[i]) - gap[i];
    ovr_nodes_write(sim, sim->finest, gap, sim->finest->f.gap);
}

/* A solution to be corrected need not be better than its discretization error.
 */
static double first_tolerance(const void *data, const ovr_level *level,
                              double H)
{
    const ovr_simulation *sim = data;
    double wanted = ovr_steady_tolerance(sim, level, H);
    if (sim->order == 4 && level == sim->finest)
        return fmax(wanted, ovr_truncation_tolerance(
                                sim, ovr_grid_mesh(&level->grid), H));
    return wanted;
}

static ovr_defect film(ovr_simulation *sim, const ovr_full *how, int *cycles)
{
    ovr_full first = *how;
    first.tolerance = first_tolerance;
    return ovr_steady_film(sim, &first, cycles);
}

/* The solution found, to go back to. */
typedef struct found {
    double *P, H0;
} found;

static found keep(const ovr_simulation *sim)
{
    const ovr_level *level = sim->finest;
    ovr_nodes_read(sim, level, level->f.P, sim->saved);
    return (found){sim->saved, sim->grids.H0};
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

/* The film and its own corrections, for the gap as it is.  On a mesh that is
 * hardly fine enough they take up to 160 cycles. */
static ovr_defect solve_and_correct(ovr_simulation *sim, const fourth *f,
                                    const ovr_full *how, int *cycles)
{
    const ovr_correction *c = &f->correction;
    ovr_full last = *how;
    last.most_cycles = ovr_steady_most_cycles(sim, 200);
    ovr_defect d = film(sim, how, cycles);
    if (sim->order != 4 ||
        !ovr_below(d, first_tolerance(sim, sim->finest, d.centre)))
        return d;
    found second = keep(sim);
    if (!ovr_fourth_solve(&sim->grids, c, &last, &d, cycles))
        return fall_back(sim, f, how, &second, cycles);
    ovr_nodes_read(sim, sim->finest, c->F, f->F);
    ovr_nodes_read(sim, sim->finest, c->gap, f->gap);
    return d;
}

/* The film, and the corrections of what stands still. */
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

/* Of the surfaces as they are at T = 0. */
static ovr_defect solve(ovr_simulation *sim, void *own, const ovr_full *how,
                        int *cycles)
{
    const fourth *f = own;
    withdraw(sim, f);
    if (applies(sim))
        sim->order = 4;
    if (sim->order == 4 && stands_apart(sim)) {
        standing_gap(sim);
        solve_and_correct(sim, f, how, cycles);
        ovr_simulation_gap(sim, 0);
        sim->refinements = 0;
        if (sim->order == 4)
            return solve_corrected(sim, f, how, cycles);
    }
    ovr_simulation_gap(sim, 0);
    return solve_and_correct(sim, f, how, cycles);
}

/* ----------------------------------------------------------------- in a run */

static void add(const ovr_simulation *sim, size_t n, double *to,
                const double *what)
{
    if (sim->order == 4)
        sim->grids.kernels->combine(n, 1, to, 1, what, to);
}

static void add_sides(const ovr_simulation *sim, const void *own, double *F)
{
    const fourth *f = own;
    add(sim, f->n, F, f->F);
}

static void add_gap(const ovr_simulation *sim, const void *own, double *to)
{
    const fourth *f = own;
    add(sim, f->n, to, f->gap);
}

static ovr_status visit(ovr_simulation *sim, void *own, ovr_visit *show,
                        void *context, ovr_error *err)
{
    const fourth *f = own;
    size_t bytes = f->n * sizeof(double);
    if (sim->order != 4)
        return OVR_OK;
    ovr_status status = show(context, "F_fourth", f->F, bytes, err);
    return status ? status : show(context, "gap_fourth", f->gap, bytes, err);
}

const ovr_physics ovr_physics_fourth = {.name = "fourth order",
                                        .chosen = chosen,
                                        .take = take,
                                        .solve = solve,
                                        .sides = add_sides,
                                        .gap = add_gap,
                                        .visit = visit};

void ovr_simulation_standing(ovr_simulation *sim, ovr_heights *standing,
                             void *data)
{
    if (!sim)
        return;
    sim->standing = standing;
    sim->standing_data = data;
    sim->standing_given = true;
}

int ovr_simulation_order(const ovr_simulation *sim)
{
    if (!sim)
        return 0;
    return sim->order;
}
