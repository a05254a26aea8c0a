/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steady solution of the strip by nested iteration.  The coarsest grid is
 * solved by Newton's method, starting from the Hertzian pressure, or from a
 * semi-ellipse as wide as the film if that is thicker than the deformation.
 * Shear thinning is applied to the Newtonian film.  Each finer grid starts from
 * the pressure of the next coarser one, interpolated by cubics in the film and
 * linearly at its ends.
 *
 * With two V(1,1) cycles per level the algebraic error is a fifth of the
 * discretization error at M = 5 and 20. M = 100 needs three cycles.
 */
#include <math.h>
#include <string.h>

#include "strip/across.h"
#include "strip/kernels.h"

static void begin_level(ovr_strip *strip, const ovr_strip_full *how,
                        ovr_strip_level *level)
{
    const ovr_strip_grid *g = &level->grid;
    how->gap(how->data, how->T, g, 0, g->n, level->f.gap);
    memset(level->f.F, 0, ovr_strip_size(g) * sizeof *level->f.F);
    level->force = how->force;
    ovr_strip_refresh(strip, level);
}

/* Initial guess: Hertzian pressure of the half-width s, and H0 = film + w(0)
 * with w(0) = force (ln(s/2) - 1/2)/pi. */
static void hertzian_start(ovr_strip *strip, const ovr_strip_full *how)
{
    const ovr_strip_level *level = &strip->level[0];
    const ovr_strip_grid *g = &level->grid;
    const double pi = acos(-1), s = how->half_width;
    const double largest = 2 * how->force / (pi * s);
    for (size_t i = 0; i < g->n; i++) {
        double x = (g->X_a + (double)i * g->D) / s;
        double P = i && i + 1 < g->n && x * x < 1 ? largest * sqrt(1 - x * x)
                                                  : 0;
        for (size_t j = 0; j < g->lines; j++)
            level->f.P[ovr_strip_row(g, i) + j] = P;
    }
    strip->H0 = how->film + how->force * (log(s / 2) - 0.5) / pi;
}

static bool iterate(ovr_strip *strip)
{
    enum { STEPS = 60 };
    const double enough = 1e-9;
    double change = 1;
    for (int step = 0; step < STEPS && change > enough; step++) {
        change = ovr_strip_stops(strip) ? -1 : ovr_strip_newton(strip, true);
        if (change < 0)
            return false;
    }
    return change < 1e-3;
}

/* Copies the pressure of the coarsest grid. */
static void copy_pressure(const ovr_strip_level *level, const double *from,
                          double *to)
{
    memcpy(to, from, ovr_strip_size(&level->grid) * sizeof *to);
}

/* Continuation from the Newtonian film to that of the rheological model: in one
 * step, or in several of tau0.  A step that fails is halved in ln tau0. */
static void thin_out(ovr_strip *strip)
{
    const double least = 1.05, tau0 = strip->fluid.lubricant.Sigma0;
    const ovr_strip_level *level = &strip->level[0];
    double from = 1e3, step = from; /* tau0 relative to that of the model */
    while (from > 1 && step > least && !ovr_strip_stops(strip)) {
        double to = fmax(from / step, 1), H0 = strip->H0;
        copy_pressure(level, level->f.P, level->f.entry);
        strip->fluid.lubricant.Sigma0 = to * tau0;
        ovr_strip_refresh(strip, &strip->level[0]);
        if (iterate(strip)) {
            from = to;
            continue;
        }
        step = sqrt(step);
        copy_pressure(level, level->f.entry, level->f.P);
        strip->H0 = H0;
    }
    strip->fluid.lubricant.Sigma0 = tau0;
}

/* Where the film ends between its few nodes, the coarsest grid may have no
 * solution. Then the next grid starts from the first guess, or from the film of
 * less shear thinning. */
static void solve_coarsest(ovr_strip *strip, const ovr_strip_full *how)
{
    const ovr_rheology law = strip->fluid.lubricant.rheology;
    strip->fluid.lubricant.rheology = OVR_NEWTONIAN;
    ovr_strip_refresh(strip, &strip->level[0]);
    bool found = iterate(strip);
    strip->fluid.lubricant.rheology = law;
    if (!found)
        hertzian_start(strip, how);
    else if (law != OVR_NEWTONIAN)
        thin_out(strip);
    ovr_strip_refresh(strip, &strip->level[0]);
}

/* Interpolates midway between b and c. */
static double midway(double a, double b, double c, double d)
{
    if (a > 0 && b > 0 && c > 0 && d > 0)
        return fmax(0, (9 * (b + c) - a - d) / 16);
    return 0.5 * (b + c);
}

/* Interpolates one row across: f has 2 lines values. */
static void refine_row(const ovr_strip_grid *coarse, const double *c, double *f)
{
    for (ptrdiff_t j = 0; j < (ptrdiff_t)coarse->lines; j++) {
        f[2 * j] = c[j];
        f[2 * j + 1] = midway(c[j - 1], c[j], c[j + 1], c[j + 2]);
    }
}

static void interpolate(ovr_strip *strip, ovr_strip_level *coarse,
                        ovr_strip_level *fine)
{
    const ovr_strip_grid *g = &coarse->grid, *h = &fine->grid;
    double *P = fine->f.P;
    ovr_strip_wrap(strip, coarse, coarse->f.P);
    for (size_t i = 0; i < g->n; i++)
        refine_row(g, coarse->f.P + ovr_strip_row(g, i),
                   P + ovr_strip_row(h, 2 * i));
    for (size_t i = 0; i + 1 < g->n; i++) {
        const double *b = P + ovr_strip_row(h, 2 * i);
        const double *c = b + 2 * h->stride;
        const double *a = i ? b - 2 * h->stride : b;
        const double *d = i + 2 < g->n ? c + 2 * h->stride : c;
        double *middle = P + ovr_strip_row(h, 2 * i + 1);
        for (size_t j = 0; j < h->lines; j++)
            middle[j] = midway(i ? a[j] : 0, b[j], c[j],
                               i + 2 < g->n ? d[j] : 0);
    }
}

/* Newton's method on patches where cycles on the finest grid stall; true if
 * that solves the film. */
static bool solve_spots(ovr_strip *strip, const ovr_strip_full *how,
                        ovr_strip_defect *d)
{
    enum { STEPS = 8 };
    const double part = 0.01;
    ovr_strip_level *level = &strip->level[strip->finest];
    const ovr_strip_grid *g = &level->grid;
    for (int k = 0; k < STEPS && d->imbalance < 1e6; k++) {
        double whole = d->imbalance * ovr_strip_centre(level, level->f.H) *
                       (double)ovr_across_intervals(g->lines) / g->D;
        if (!ovr_strip_spots(strip, level, &how->cycling.smoothing,
                             part * whole))
            return false;
        *d = ovr_strip_defect_of(strip, level);
        if (ovr_strip_below(*d, how->tolerance))
            return true;
    }
    return false;
}

/* Cycles on a level until done.  Corrections into this grid are halved, or made
 * whole again, where two cycles hardly reduce R.  Half corrections stop the end
 * of a film from alternating between two places.  Slopes are secants at least
 * (faces.kernel.c) far from the solution and after a slow cycle.  Where cycles
 * on the finest grid stall for long, patches are solved after each. */
static ovr_strip_defect cycle_until(ovr_strip *strip, const ovr_strip_full *how,
                                    int l, int *cycles)
{
    enum { PATIENCE = 5, LONG = 12 };
    const bool finest = l == strip->finest;
    const int most = finest ? how->max_cycles : how->cycles;
    const double near = 1e-3, slow = 0.5;
    ovr_strip_cycling cycling = how->cycling;
    ovr_strip_defect d = {INFINITY, INFINITY, 0};
    double last[2] = {INFINITY, INFINITY};
    *cycles = 0;
    for (int since = 1; *cycles < most && !ovr_strip_stops(strip); since++) {
        last[1] = last[0];
        last[0] = d.imbalance;
        ovr_strip_cycle(strip, l, &cycling);
        ++*cycles;
        d = ovr_strip_defect_of(strip, &strip->level[l]);
        strip->fluid.secants = !(d.imbalance < near &&
                                 d.imbalance < slow * last[0]);
        if (!(d.imbalance < 1e6) ||
            (finest && ovr_strip_below(d, how->tolerance)))
            break;
        if (finest && *cycles >= LONG && d.imbalance > slow * last[0] &&
            solve_spots(strip, how, &d))
            break;
        if (since > PATIENCE && d.imbalance > 0.7 * last[1]) {
            bool whole = cycling.correction == how->cycling.correction;
            cycling.correction = (whole ? 0.5 : 1) * how->cycling.correction;
            since = 0;
        }
    }
    return d;
}

ovr_strip_defect ovr_strip_solve(ovr_strip *strip, const ovr_strip_full *how,
                                 int *cycles)
{
    ovr_strip_defect d = {INFINITY, INFINITY, 0};
    *cycles = 0;
    ovr_strip_wedge(strip, how->speed, 0);
    hertzian_start(strip, how);
    begin_level(strip, how, &strip->level[0]);
    solve_coarsest(strip, how);
    d = ovr_strip_defect_of(strip, &strip->level[0]);
    for (int l = 1; l <= strip->finest; l++) {
        if (ovr_strip_stops(strip))
            return (ovr_strip_defect){INFINITY, INFINITY, 0};
        interpolate(strip, &strip->level[l - 1], &strip->level[l]);
        begin_level(strip, how, &strip->level[l]);
        d = cycle_until(strip, how, l, cycles);
        if (!(d.imbalance < 1e6))
            break;
    }
    return d;
}

ovr_strip_defect ovr_strip_continue(ovr_strip *strip, const ovr_strip_full *how,
                                    int *cycles)
{
    ovr_strip_level *level = &strip->level[strip->finest];
    begin_level(strip, how, level);
    ovr_strip_defect d = ovr_strip_defect_of(strip, level);
    *cycles = 0;
    if (!how->max_cycles || ovr_strip_below(d, how->tolerance))
        return d;
    return cycle_until(strip, how, strip->finest, cycles);
}
