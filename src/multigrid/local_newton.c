/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/local_newton.h"

#include <math.h>
#include <string.h>

#include "multigrid/flow.h"
#include "multigrid/reynolds_row.h"

enum {
    WINDOWS = 8,
    HALF = 8, /* unknowns to each side of the centre */
    UNKNOWNS = 2 * HALF + 1,
    MARGIN = 3, /* additional nodes on each side that rows read */
    NODES = UNKNOWNS + 2 * MARGIN,
    REACH = 40, /* range of the influence of other windows, in mesh sizes */
    ASIDE = 3,  /* neighbours that define the usual value */
    STRIDE = UNKNOWNS + 2,
    HEATED = 4 /* arrays of a film with temperatures */
};

/* Centres of the windows, in descending order of the pressure error. */
typedef struct windows {
    ptrdiff_t at[WINDOWS];
    double size[WINDOWS];
    size_t count;
} windows;

/* Nodes first - MARGIN to first + UNKNOWNS + MARGIN, in one lane. */
typedef struct window {
    const ovr_hierarchy *grids;
    const ovr_kernels *plain; /* in one lane */
    ovr_fluid fluid;          /* with secants, because the pressures are far
                               * from the solution */
    const double
        *k; /* elastic influence at distances of -REACH..REACH mesh sizes */
    double D;
    row_weights weights;
    ovr_fields f;
    double values[OVR_FIELD_COUNT][NODES], heat[HEATED][NODES];
    double gap[NODES];       /* film thickness without this window's changes */
    double change[UNKNOWNS]; /* change of P */
    double matrix[UNKNOWNS * STRIDE], solution[UNKNOWNS];
} window;

/* ----------------------------------------------------- selection of nodes */

/* Inserts node i if it is among the largest, more than HALF nodes from the
 * others; i increases from call to call. */
static void insert(windows *s, ptrdiff_t i, double size)
{
    size_t k = 0;
    while (k < s->count && i - s->at[k] > HALF)
        k++;
    if (k == s->count && s->count < WINDOWS)
        s->size[s->count++] = 0;
    if (k == WINDOWS)
        k--;
    if (s->size[k] >= size)
        return;
    for (; k > 0 && s->size[k - 1] < size; k--) {
        s->at[k] = s->at[k - 1];
        s->size[k] = s->size[k - 1];
    }
    s->at[k] = i;
    s->size[k] = size;
}

/* d_i of reynolds.h for a present film: `flow` contains 2 E of half nodes, or
 * eps of nodes. */
static double outflow(const ovr_level *level, const double *flow, ptrdiff_t i)
{
    double sum = level->f.flow ? flow[i - 1] + flow[i]
                               : flow[i - 1] + 2 * flow[i] + flow[i + 1];
    return fmax(0, level->weights.half * sum);
}

static void find(const ovr_hierarchy *grids, const ovr_level *level, windows *s)
{
    const double minimum = 0.1; /* relative to p_h */
    double *r = grids->band.b[0], *flow = grids->band.b[1];
    double stiff = level->weights.a[0] * fabs(level->k[0]);
    ptrdiff_t edge = HALF + MARGIN + 1, n = (ptrdiff_t)level->grid.n;
    ovr_level_read(grids, level, level->f.r, r);
    ovr_level_read(grids, level, level->f.flow ? level->f.flow : level->f.eps,
                   flow);
    for (ptrdiff_t i = edge; i < n - edge; i++) {
        double usual = 0.5 * (r[i - ASIDE] + r[i + ASIDE]);
        double lacks = fabs(r[i] - usual);
        if (lacks > minimum * stiff &&
            lacks > minimum * (stiff + outflow(level, flow, i)))
            insert(s, i, lacks / (stiff + outflow(level, flow, i)));
    }
}

/* ------------------------------------------------------------- one window */

static void read_nodes(const ovr_level *level, const double *from,
                       ptrdiff_t first, double *to)
{
    for (ptrdiff_t i = 0; i < NODES; i++)
        to[i] =
            from[ovr_lanes_place(&level->lanes, (size_t)(first - MARGIN + i))];
}

/* True if the window is in the full film and no limiter is active
 * (mass-conserving cavitation). */
static bool is_full(const ovr_level *level, ptrdiff_t first)
{
    const ovr_fields *f = &level->f;
    for (ptrdiff_t i = first - MARGIN; i < first + UNKNOWNS + MARGIN; i++)
        if (!ovr_lanes_has(&level->lanes, f->wet, (size_t)i) ||
            ovr_lanes_has(&level->lanes, f->limited, (size_t)i) ||
            ovr_lanes_has(&level->lanes, f->spent, (size_t)i))
            return false;
    return true;
}

static void enter(window *w, const ovr_level *level, ptrdiff_t first)
{
    const ovr_fields *f = &level->f;
    double *const heat[HEATED] = {f->th, f->shift, f->drag, f->swell};
    double **const own[HEATED] = {&w->f.th, &w->f.shift, &w->f.drag,
                                  &w->f.swell};
    memset(w->change, 0, sizeof w->change);
    read_nodes(level, f->P, first, w->f.P);
    read_nodes(level, f->F, first, w->f.F);
    read_nodes(level, f->H, first, w->gap);
    if (f->skew) {
        read_nodes(level, f->skew, first, w->f.skew);
        read_nodes(level, f->skew_by_P, first, w->f.skew_by_P);
    }
    for (size_t k = 0; k < HEATED; k++)
        if (heat[k]) {
            *own[k] = w->heat[k];
            read_nodes(level, heat[k], first, w->heat[k]);
        }
}

/* Changes the film thickness by the pressure changes of a window that begins
 * `away` nodes further. */
static void follow(const window *w, const double change[UNKNOWNS],
                   ptrdiff_t away, double *film)
{
    for (ptrdiff_t i = 0; i < NODES; i++)
        for (ptrdiff_t j = 0; j < UNKNOWNS; j++) {
            ptrdiff_t d = away + j + MARGIN - i;
            if (d >= -REACH && d <= REACH)
                film[i] -= w->k[d] * change[j];
        }
}

/* Computes film thickness, properties and flow from the present pressures. */
static void properties(window *w)
{
    const ovr_lanes one = {NODES, NODES, 1};
    double film[NODES], none[NODES] = {0};
    memcpy(film, w->gap, sizeof film);
    follow(w, w->change, 0, film);
    w->plain->film(&w->fluid, 0, &one, film, none, &w->f);
    ovr_flow_store(w->plain, &w->fluid, w->D, &one, &w->f);
}

static bool is_held(const window *w, ptrdiff_t J, double r)
{
    return w->f.P[J] <= 0 && r >= 0;
}

static double imbalance(const window *w)
{
    double sum = 0;
    for (ptrdiff_t J = MARGIN; J < MARGIN + UNKNOWNS; J++) {
        double r = row_residual(&w->f, &w->weights, J);
        if (!is_held(w, J, r))
            sum += fabs(r);
    }
    return sum;
}

static void assemble(window *w, ptrdiff_t i)
{
    ptrdiff_t J = i + MARGIN;
    double *row = w->matrix + i * STRIDE, e[4] = {0}, local[4] = {0};
    double r = row_residual(&w->f, &w->weights, J);
    memset(row, 0, STRIDE * sizeof *row);
    if (is_held(w, J, r)) {
        row[i] = 1;
        return;
    }
    row_by_film(&w->f, &w->weights, J, e);
    row_flow_by_film(&w->f, &w->weights, J, e);
    row_by_pressure(&w->f, &w->weights, J, local);
    w->plain->dense_row(UNKNOWNS, e, w->k - i, row);
    for (ptrdiff_t d = -2; d <= 1; d++)
        if (i + d >= 0 && i + d < UNKNOWNS)
            row[i + d] += local[d + 2];
    row[UNKNOWNS] = r;
}

/* Performs a Newton step; returns its largest change before limiting. */
static double newton_step(window *w)
{
    const double limit = 0.2;
    double largest = 0;
    for (ptrdiff_t i = 0; i < UNKNOWNS; i++)
        assemble(w, i);
    if (!w->plain->dense_solve(UNKNOWNS, STRIDE, w->matrix, w->solution))
        return INFINITY;
    for (ptrdiff_t i = 0; i < UNKNOWNS; i++) {
        double P = w->f.P[i + MARGIN], target = w->solution[i];
        double next = fmax(0, P + fmin(fmax(target, -limit), limit));
        largest = fmax(largest, fabs(target));
        w->change[i] += next - P;
        w->f.P[i + MARGIN] = next;
    }
    properties(w);
    return largest;
}

static bool has_film(const window *w)
{
    for (ptrdiff_t i = 0; i < NODES; i++)
        if (!(w->f.H[i] > 0))
            return false;
    return true;
}

static bool solve(window *w)
{
    enum { STEPS = 10 };
    const double enough = 0.03, hopeless = 10, better = 0.2;
    double change = 1, begin;
    properties(w);
    if (!has_film(w))
        return false;
    begin = imbalance(w);
    for (int step = 0; step < STEPS && change > enough; step++) {
        change = newton_step(w);
        if (!(change < hopeless))
            break;
    }
    return has_film(w) && imbalance(w) < better * begin;
}

/* -------------------------------------------------------------- the level */

/* True for fields that the window allocates because the level does not have
 * them. */
static bool has(const ovr_fields *f, size_t k)
{
    switch (ovr_field_rows[k].memory) {
    case OVR_NEWTON: return true;
    case OVR_SENSITIVE: return f->flow;
    case OVR_CONTENT: return false;
    default: return f->all[k];
    }
}

static void begin(window *w, const ovr_hierarchy *grids, const ovr_level *level,
                  double kernel[2 * REACH + 1])
{
    *w = (window){
        .grids = grids,
        .plain = ovr_kernels_choose("plain"),
        .fluid = grids->fluid,
        .k = kernel + REACH,
        .D = level->grid.D,
        .weights = row_inner(&level->weights, row_kind_of(&level->f))};
    w->fluid.secants = true;
    for (int d = 0; d <= REACH; d++)
        kernel[REACH - d] = kernel[REACH + d] = ovr_influence_at(
            &grids->influence, d, level->grid.D);
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++) {
        if (has(&level->f, k))
            w->f.all[k] = w->values[k];
    }
}

bool ovr_local_newton(const ovr_hierarchy *grids, ovr_level *level)
{
    double kernel[2 * REACH + 1], changes[WINDOWS][UNKNOWNS];
    ptrdiff_t solved[WINDOWS];
    size_t count = 0;
    windows s = {.count = 0};
    window w;
    find(grids, level, &s);
    if (!s.count)
        return false;
    begin(&w, grids, level, kernel);
    for (size_t k = 0; k < s.count; k++) {
        ptrdiff_t first = s.at[k] - HALF;
        if (grids->conserving && !is_full(level, first))
            continue;
        enter(&w, level, first);
        for (size_t j = 0; j < count; j++)
            follow(&w, changes[j], solved[j] - first, w.gap);
        if (!solve(&w))
            continue;
        for (ptrdiff_t i = 0; i < UNKNOWNS; i++)
            level->f.P[ovr_lanes_place(&level->lanes, (size_t)(first + i))] =
                w.f.P[i + MARGIN];
        memcpy(changes[count], w.change, sizeof w.change);
        solved[count++] = first;
    }
    if (count)
        ovr_level_refresh(grids, level);
    return count > 0;
}
