/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Passes of kernels over a whole grid.  The strip's threads share the rows, and
 * groups of lines where lines are solved.  Every element of a result is
 * computed by one thread from values that no other thread changes in the same
 * pass.  Sums over rows are added in the order of the rows.  The bits of a
 * result therefore do not depend on the number of threads.
 */
#include "multigrid/field.h"
#include "strip/kernels.h"

/* Minimum number of nodes for which several threads are faster than one. */
enum { LEAST_NODES = 3000 };

typedef struct pass {
    ovr_strip *strip;
    ovr_strip_level *level;
    const ovr_strip_smoothing *how;
    double *x;
    const double *a, *b;
    double factor;
    int colour;
} pass;

void ovr_strip_share(ovr_strip *strip, const ovr_strip_grid *g, size_t count,
                     ovr_team_work *work, void *data)
{
    if (g->n * g->lines < LEAST_NODES && count)
        work(data, 0, 0, count);
    else
        ovr_team_run(&strip->team, count, work, data);
}

static void over_rows(pass *p, ovr_team_work *work)
{
    const ovr_strip_grid *g = &p->level->grid;
    ovr_strip_share(p->strip, g, g->n, work, p);
}

double *ovr_strip_work_of(const ovr_strip *strip, int member)
{
    return strip->work + (size_t)member * strip->work_size;
}

/* Adds the sums of all rows. */
static double total(const ovr_strip *strip, const ovr_strip_grid *g)
{
    double sum = 0;
    for (size_t i = 0; i < g->n; i++)
        sum += strip->sums[i];
    return sum;
}

#define PASS(name)                                                             \
    static void name(void *data, int member, size_t from, size_t to)

PASS(residual)
{
    const pass *p = data;
    (void)member;
    p->strip->run->residual(&p->level->grid, (ovr_part){from, to},
                            &p->level->weights, &p->level->f);
    if (p->x)
        p->strip->run->wrap(&p->level->grid, (ovr_part){from, to}, p->x);
}

void ovr_strip_residual(ovr_strip *strip, ovr_strip_level *level, bool wrapped)
{
    over_rows(&(pass){.strip = strip,
                      .level = level,
                      .x = wrapped ? level->f.r : NULL},
              residual);
}

PASS(imbalance)
{
    const pass *p = data;
    residual(data, member, from, to);
    p->strip->run->imbalance(&p->level->grid, (ovr_part){from, to},
                             &p->level->f, p->strip->sums);
}

double ovr_strip_imbalance(ovr_strip *strip, ovr_strip_level *level)
{
    over_rows(&(pass){.strip = strip, .level = level}, imbalance);
    return total(strip, &level->grid);
}

PASS(sum)
{
    const pass *p = data;
    (void)member;
    p->strip->run->sum(&p->level->grid, (ovr_part){from, to}, p->a,
                       p->strip->sums);
}

double ovr_strip_sum(ovr_strip *strip, ovr_strip_level *level, const double *x)
{
    over_rows(&(pass){.strip = strip, .level = level, .a = x}, sum);
    return total(strip, &level->grid);
}

PASS(distance)
{
    const pass *p = data;
    (void)member;
    p->strip->run->distance(&p->level->grid, (ovr_part){from, to}, p->a, p->b,
                            p->strip->sums);
}

double ovr_strip_distance(ovr_strip *strip, ovr_strip_level *level,
                          const double *a, const double *b)
{
    over_rows(&(pass){.strip = strip, .level = level, .a = a, .b = b},
              distance);
    return total(strip, &level->grid);
}

PASS(wrap)
{
    const pass *p = data;
    (void)member;
    p->strip->run->wrap(&p->level->grid, (ovr_part){from, to}, p->x);
}

void ovr_strip_wrap(ovr_strip *strip, ovr_strip_level *level, double *x)
{
    over_rows(&(pass){.strip = strip, .level = level, .x = x}, wrap);
}

/* --------------------------------------------------------------- relaxation */

PASS(choose)
{
    const pass *p = data;
    const ovr_strip_kernels *run = p->strip->run;
    const ovr_strip_grid *g = &p->level->grid;
    const ovr_part rows = {from, to};
    (void)member;
    run->choose(g, rows, &p->level->weights, p->how, p->level->near[0][0],
                &p->level->f);
    run->wrap(g, rows, p->level->f.moves);
    run->wrap(g, rows, p->level->f.share);
}

PASS(solve)
{
    const pass *p = data;
    p->strip->run->solve_lines(
        &p->level->grid, (ovr_part){from, to}, &p->level->weights, p->how,
        p->level->near[0], &p->level->f, ovr_strip_work_of(p->strip, member));
}

PASS(damp)
{
    const pass *p = data;
    const ovr_strip_grid *g = &p->level->grid;
    (void)member;
    p->strip->run->damp(g, (ovr_part){from, to}, p->how, p->colour,
                        &p->level->f);
    p->strip->run->wrap(g, (ovr_part){from, to}, p->level->f.spread);
}

PASS(distribute)
{
    const pass *p = data;
    const ovr_strip_grid *g = &p->level->grid;
    (void)member;
    p->strip->run->distribute(g, (ovr_part){from, to}, p->how, &p->level->f);
    p->strip->run->wrap(g, (ovr_part){from, to}, p->level->f.P);
}

void ovr_strip_choose_nodes(ovr_strip *strip, ovr_strip_level *level,
                            const ovr_strip_smoothing *how)
{
    over_rows(&(pass){.strip = strip, .level = level, .how = how}, choose);
}

void ovr_strip_relax_lines(ovr_strip *strip, ovr_strip_level *level,
                           const ovr_strip_smoothing *how, int colour)
{
    const ovr_strip_grid *g = &level->grid;
    pass p = {.strip = strip, .level = level, .how = how, .colour = colour};
    ovr_strip_share(strip, g, ovr_strip_groups(g), solve, &p);
    over_rows(&p, damp);
    over_rows(&p, distribute);
}

/* --------------------------------------------------------------- properties */

/* Computes the film thickness of whole rows with their halos, which the kernel
 * processes as one array of nodes. The kernel adds OVR_HALO vectors at the
 * beginning and one at the end. */
static void film_of(const pass *p, size_t from, size_t to)
{
    const ovr_strip *strip = p->strip;
    const ovr_strip_fields *f = &p->level->f;
    const size_t V = strip->kernels->lanes;
    ptrdiff_t first = (ptrdiff_t)ovr_strip_row(&p->level->grid, from);
    size_t count = ovr_strip_row(&p->level->grid, to - from);
    ovr_lanes nodes = {.n = count, .S = count / V, .V = V};
    first -= OVR_STRIP_HALO;
    if (V > 1) {
        first += OVR_HALO * (ptrdiff_t)V;
        nodes.S -= OVR_HALO + 1;
    }
    const ovr_fields film = {
        .P = f->P + first,
        .H = f->H + first,
        .rho = f->rho + first,
        .dq = f->dq + first,
        .eps = f->eps + first,
        .deps = f->deps + first,
        .q = f->q + first,
        .deps_dH = p->level->number ? NULL : strip->deps_dH + first};
    strip->kernels->film(&strip->fluid, strip->H0, &nodes, f->gap + first,
                         f->w + first, &film);
}

PASS(film)
{
    const pass *p = data;
    const ovr_strip_grid *g = &p->level->grid;
    const ovr_part rows = {from, to};
    (void)member;
    p->strip->run->wrap(g, rows, p->level->f.P);
    p->strip->run->wrap(g, rows, p->level->f.w);
    p->strip->run->wrap(g, rows, p->level->f.gap);
    film_of(p, from, to);
}

PASS(faces)
{
    const pass *p = data;
    p->strip->run->faces(&p->level->grid, (ovr_part){from, to},
                         &p->strip->fluid, p->strip->logarithmic, &p->level->f,
                         ovr_strip_work_of(p->strip, member));
}

void ovr_strip_properties(ovr_strip *strip, ovr_strip_level *level)
{
    pass p = {.strip = strip, .level = level};
    over_rows(&p, film);
    over_rows(&p, faces);
}

/* ---------------------------------------------------------------- transfers */

PASS(restrict_rows)
{
    const pass *p = data;
    (void)member;
    p->strip->run->restrict_fields(&p->level->grid, (ovr_part){from, to},
                                   &p->level[1].grid, &p->level[1].f,
                                   p->strip->H0, &p->level->f);
}

void ovr_strip_restrict(ovr_strip *strip, ovr_strip_level *coarse)
{
    over_rows(&(pass){.strip = strip, .level = coarse}, restrict_rows);
}

PASS(coarse_gap)
{
    const pass *p = data;
    (void)member;
    p->strip->run->coarse_gap(&p->level->grid, (ovr_part){from, to},
                              p->level->f.w, p->level->f.gap);
}

void ovr_strip_coarse_gap(ovr_strip *strip, ovr_strip_level *coarse)
{
    over_rows(&(pass){.strip = strip, .level = coarse}, coarse_gap);
}

PASS(coarse_side)
{
    const pass *p = data;
    const ovr_strip_fields *f = &p->level->f;
    const ovr_strip_grid *g = &p->level->grid;
    (void)member;
    p->strip->run->wrap(g, (ovr_part){from, to}, f->entry);
    for (size_t k = ovr_strip_row(g, from); k < ovr_strip_row(g, to); k++)
        f->F[k] = 0;
    residual(data, member, from, to);
    p->strip->run->coarse_side(g, (ovr_part){from, to}, f->spread, f->r, f->F);
}

void ovr_strip_coarse_side(ovr_strip *strip, ovr_strip_level *coarse)
{
    over_rows(&(pass){.strip = strip, .level = coarse}, coarse_side);
}

PASS(correct)
{
    const pass *p = data;
    (void)member;
    const ovr_strip_level *coarse = p->level - 1;
    p->strip->run->correct(&coarse->grid, &p->level->grid, (ovr_part){from, to},
                           p->factor, &coarse->f, p->level->f.P);
}

void ovr_strip_correct(ovr_strip *strip, ovr_strip_level *fine, double factor)
{
    ovr_strip_wrap(strip, fine - 1, fine[-1].f.P);
    over_rows(&(pass){.strip = strip, .level = fine, .factor = factor},
              correct);
}
