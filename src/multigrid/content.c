/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/content.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------ sets of nodes */

void ovr_content_mark(const ovr_level *level, unsigned char *set, size_t i,
                      bool in)
{
    size_t V = level->lanes.V, place = ovr_lanes_place(&level->lanes, i);
    unsigned bit = 1U << place % V, rest = set[place / V] & ~bit;
    set[place / V] = (unsigned char)(rest | (in ? bit : 0));
}

static unsigned last_lane(const ovr_lanes *g)
{
    return (1U << g->V) >> 1;
}

/* Copies lane by lane, to avoid a division per node. */
void ovr_content_read(const ovr_level *level, const unsigned char *set,
                      unsigned char *ordered)
{
    const ovr_lanes *g = &level->lanes;
    size_t i = 0;
    for (size_t lane = 0; lane < g->V; lane++)
        for (size_t J = 0; J < g->S && i < g->n; J++)
            ordered[i++] = set[J] >> lane & 1;
    if (i < g->n) /* node n - 1, in the halo */
        ordered[i] = (set[g->S] & last_lane(g)) != 0;
}

void ovr_content_wet(ovr_level *level, const double *P)
{
    const ovr_lanes *g = &level->lanes;
    unsigned char *wet = level->f.wet;
    size_t i = 0;
    memset(wet, 0, g->S);
    memset(level->f.dried, 0, g->S);
    for (size_t lane = 0; lane < g->V; lane++)
        for (size_t J = 0; J < g->S && i < g->n; J++)
            wet[J] |= (unsigned char)((P[i++] > 0) << lane);
    if (i < g->n) /* at node n - 1 too, where P = 0 */
        wet[g->S] &= (unsigned char)~last_lane(g);
}

/* -------------------------------------------------------------------- inlet */

void ovr_content_open(ovr_level *level)
{
    ovr_weights *w = &level->weights;
    level->closed = false;
    for (int m = 0; m < 3; m++)
        w->first[m] = level->opened[m];
    w->source = 0;
    ovr_content_mark(level, level->f.wet, 0, true);
}

void ovr_content_close(ovr_level *level, double source, double supply)
{
    ovr_weights *w = &level->weights;
    level->closed = true;
    for (int m = 0; m < 3; m++)
        w->first[m] = w->closed[m];
    w->source = source;
    ovr_content_mark(level, level->f.wet, 0, false);
    level->f.q[ovr_lanes_place(&level->lanes, 0)] = supply;
}

/* ---------------------------------------------------------- states of nodes */

void ovr_content_by_pressure(const ovr_hierarchy *grids, ovr_level *level)
{
    const ovr_lanes *g = &level->lanes;
    (void)grids;
    for (size_t i = 1; i + 1 < level->grid.n; i++) {
        bool wet = level->f.P[ovr_lanes_place(g, i)] > 0;
        ovr_content_mark(level, level->f.wet, i, wet);
        ovr_content_mark(level, level->f.dried, i, false);
    }
}

/* Extrapolates the content beyond the last node, which no equation determines:
 * the flow is constant, limited by the gap. */
static void extend_content(const ovr_level *level)
{
    size_t last = level->grid.n - 1;
    const ovr_lanes *g = &level->lanes;
    size_t here = ovr_lanes_place(g, last),
           before = ovr_lanes_place(g, last - 1);
    level->f.q[here] = fmin(level->f.q[before], level->f.full[here]);
}

static void settle(const ovr_hierarchy *grids, const ovr_level *level)
{
    grids->kernels->content_settle(&level->lanes, &level->weights, level->leads,
                                   &level->f);
}

/* Removes the Poiseuille flow between nodes 0 and 1. */
static void close_face(const ovr_level *level)
{
    const ovr_fields *f = &level->f;
    double *const halves[] = {f->flow, f->out_left, f->out_right, f->by_left,
                              f->by_right};
    f->eps[0] = -f->eps[ovr_lanes_place(&level->lanes, 1)];
    for (size_t k = 0; k < sizeof halves / sizeof *halves; k++)
        if (halves[k])
            halves[k][0] = 0;
}

void ovr_content_settle(const ovr_hierarchy *grids, ovr_level *level)
{
    const ovr_fields *f = &level->f;
    settle(grids, level);
    if (level->leads && grids->op.transient && level->closed &&
        ovr_lanes_has(&level->lanes, f->wet, 1)) {
        ovr_content_open(level);
        settle(grids, level);
    }
    extend_content(level);
    if (level->closed)
        close_face(level);
}

/* ------------------------------------------------------------ between grids */

void ovr_content_restrict(ovr_hierarchy *grids, const ovr_level *fine,
                          ovr_level *coarse, double *residual)
{
    const ovr_fields *to = &coarse->f;
    double supply;
    coarse->leads = false;
    grids->kernels->content_restrict(&coarse->lanes, &fine->lanes, &fine->f, to,
                                     residual);
    supply = to->q[ovr_lanes_place(&coarse->lanes, 0)];
    if (grids->supplied && !ovr_lanes_has(&coarse->lanes, to->wet, 1))
        ovr_content_close(coarse, 0, supply);
    else
        ovr_content_open(coarse);
}

/* Values at a node between two coarse nodes: cavitated if either is, with the
 * content of the cavitated ones. */
static double between(const double q[2], const bool wet[2])
{
    if (wet[0] == wet[1])
        return 0.5 * (q[0] + q[1]);
    return wet[0] ? q[1] : q[0];
}

void ovr_content_refine(ovr_hierarchy *grids, const ovr_level *coarse,
                        ovr_level *fine)
{
    const ovr_fields *c = &coarse->f, *f = &fine->f;
    for (size_t i = 1; i + 1 < fine->grid.n; i++) {
        double q[2];
        bool wet[2];
        size_t place = ovr_lanes_place(&fine->lanes, i);
        for (size_t k = 0; k < 2; k++) {
            size_t I = (i + k) / 2;
            q[k] = c->q[ovr_lanes_place(&coarse->lanes, I)];
            wet[k] = ovr_lanes_has(&coarse->lanes, c->wet, I);
        }
        f->q[place] = between(q, wet);
        ovr_content_mark(fine, f->wet, i, wet[0] && wet[1]);
        ovr_content_mark(fine, f->dried, i, false);
        if (!wet[0] || !wet[1])
            f->P[place] = 0;
    }
    fine->leads = true;
    (void)grids;
}

void ovr_content_relax(ovr_hierarchy *grids, ovr_level *level, double limit)
{
    const ovr_kernels *run = grids->kernels;
    run->content_choose(&level->lanes, &level->weights, &level->f);
    run->content_assemble(&level->lanes, &level->weights, level->k,
                          &level->shares, &level->f, &grids->band);
    run->band_solve(&level->lanes, &grids->band);
    run->content_advance(&level->lanes, limit, &level->shares, &grids->band,
                         &level->f);
}
