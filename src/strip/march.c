/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A time step of the strip: right-hand side, initial guess, attempts. Guesses
 * are formulas in E and S (guess.c).  E is one step back.  S is a shift by the
 * distance that a feature moves in a step.
 *
 *     (1 - E) P = 0
 *     (1 - E)^3 P = 0
 *     (1 - E)^2 (1 - S E)^2 P = 0
 *     (1 - E) (1 - S E) P = 0
 *     (1 - E) (1 - S E)^2 P = 0
 *
 * After every fourth step the errors of all guesses are computed. The next step
 * uses the formula with the smallest mean error.
 *
 * Attempts: no coupling of lines is best for all films. For rough sliding at M
 * = 20 zebra coupling needs half the cycles of Jacobi coupling. At M = 5 it
 * stalls. If cycles stall at few nodes, spots.c solves these. Later attempts
 * start from the last film.
 */
#include "strip/march.h"

#include <math.h>
#include <string.h>

#include "multigrid/field.h"
#include "strip/across.h"
#include "strip/kernels.h"

typedef struct term {
    double weight;
    int ago, shifts;
} term;

enum { MAX_TERMS = 8, MAX_ROWS = 4 * MAX_TERMS };

typedef struct formula {
    size_t needs, count; /* number of known times required */
    term term[MAX_TERMS];
    double H0[OVR_STRIP_PAST];
} formula;

static const formula formulas[OVR_STRIP_GUESSES] = {
    {1, 1, {{1, 0, 0}}, {1}},
    {3, 3, {{3, 0, 0}, {-3, 1, 0}, {1, 2, 0}}, {3, -3, 1}},
    {4,
     8,
     {{2, 0, 0},
      {2, 0, 1},
      {-1, 1, 0},
      {-4, 1, 1},
      {-1, 1, 2},
      {2, 2, 1},
      {2, 2, 2},
      {-1, 3, 2}},
     {4, -6, 4, -1}},
    {2, 3, {{1, 0, 0}, {1, 0, 1}, {-1, 1, 1}}, {2, -1}},
    {3,
     5,
     {{1, 0, 0}, {2, 0, 1}, {-2, 1, 1}, {-1, 1, 2}, {1, 2, 2}},
     {3, -3, 1}},
};

ovr_status ovr_strip_march_create(ovr_strip_march *march, ovr_strip *strip,
                                  double longest, ovr_arena *arena,
                                  ovr_error *err)
{
    const ovr_strip_grid *g = &strip->level[strip->finest].grid;
    size_t n = ovr_strip_size(g);
    *march = (ovr_strip_march){
        .strip = strip, .speed = 1, .travel = {NAN, NAN}, .carried = NAN};
    march->ghosts = (size_t)ceil(2 * longest) + 2;
    for (size_t k = 0; k < OVR_STRIP_PAST; k++)
        march->P[k] = ovr_strip_field(n, arena, err);
    for (size_t k = 0; k < 2; k++)
        march->q[k] = ovr_strip_field(n + march->ghosts * g->stride, arena,
                                      err);
    return ovr_arena_status(arena);
}

static ovr_strip_level *finest_of(const ovr_strip_march *march)
{
    return &march->strip->level[march->strip->finest];
}

/* Computes q of all rows at time T, including rows upstream of the inlet. */
static void keep_content(ovr_strip_march *march, double T, double *q)
{
    const ovr_strip_level *level = finest_of(march);
    const ovr_strip_grid *g = &level->grid;
    const ovr_strip_fields *f = &level->f;
    const size_t s = g->stride, ghosts = march->ghosts;
    march->gap(march->data, T, g, -(ptrdiff_t)ghosts, ghosts, q);
    for (size_t i = 0; i < ghosts; i++)
        for (size_t j = 0; j < g->lines; j++) {
            double x = (double)i - (double)ghosts, e[3];
            for (size_t k = 0; k < 3; k++)
                e[k] = f->H[k * s + j] - f->gap[k * s + j];
            q[i * s + j] += e[0] + x * (e[1] - e[0]) +
                            0.5 * x * (x - 1) * (e[2] - 2 * e[1] + e[0]);
        }
    memcpy(q + ghosts * s, f->q, ovr_strip_size(g) * sizeof *q);
}

static void keep_pressure(ovr_strip_march *march, double *P)
{
    const ovr_strip_level *level = finest_of(march);
    memcpy(P, level->f.P, ovr_strip_size(&level->grid) * sizeof *P);
}

void ovr_strip_march_begin(ovr_strip_march *march, double T)
{
    march->known = 1;
    march->steps = 0;
    march->formula = 0;
    for (size_t k = 0; k < OVR_STRIP_GUESSES; k++)
        march->nearness[k] = 0;
    for (size_t k = 0; k < OVR_STRIP_PAST; k++) {
        keep_pressure(march, march->P[k]);
        march->H0[k] = march->strip->H0;
    }
    for (size_t k = 0; k <= OVR_STRIP_PAST; k++)
        march->T[k] = T;
    for (size_t k = 0; k < 2; k++)
        keep_content(march, T, march->q[k]);
}

/* A linear combination of rows. */
typedef struct rows {
    size_t count;
    double weight[MAX_ROWS];
    const double *from[MAX_ROWS];
} rows;

/* Adds weight times the value at position i - shift of x, interpolated between
 * rows. x has rows first .. first + n - 1; other rows are 0. */
static void add_shifted(rows *sum, const ovr_strip_grid *g, const double *x,
                        ptrdiff_t first, size_t n, ptrdiff_t i, double shift,
                        double weight)
{
    double place = floor((double)i - shift), u = (double)i - shift - place;
    ptrdiff_t base = (ptrdiff_t)place - first, end = (ptrdiff_t)n;
    bool whole = u < 1e-9 || u > 1 - 1e-9;
    base += u > 1 - 1e-9;
    double c[4] = {-u * (u - 1) * (u - 2) / 6, (u + 1) * (u - 1) * (u - 2) / 2,
                   -(u + 1) * u * (u - 2) / 2, (u + 1) * u * (u - 1) / 6};
    if (!whole && (base < 1 || base + 2 >= end)) {
        c[0] = c[3] = 0;
        c[1] = 1 - u;
        c[2] = u;
    }
    for (ptrdiff_t k = 0; k < 4; k++) {
        ptrdiff_t row = base + k - 1;
        double part = whole ? k == 1 : c[k];
        if (part == 0 || row < 0 || row >= end)
            continue;
        sum->weight[sum->count] = weight * part;
        sum->from[sum->count++] = x + (size_t)row * g->stride;
    }
}

/* Weights of BDF2. */
static void weigh(const ovr_strip_march *march, double a[3])
{
    double t1 = march->next - march->T[0], before = march->T[0] - march->T[1];
    double r = before > 0 ? t1 / before : 1;
    a[0] = (1 + 2 * r) / (1 + r) / t1;
    a[1] = -(1 + r) / t1;
    a[2] = r * r / (1 + r) / t1;
}

/* Right-hand side as a combination of past rows, shifted by `distance` mesh
 * sizes, with the weights a. */
typedef struct side {
    const ovr_strip_march *march;
    double distance[2], a[3];
} side;

static void fill_side(void *data, int member, size_t from, size_t to)
{
    const side *s = data;
    const ovr_strip_march *march = s->march;
    const ovr_strip_level *level = finest_of(march);
    const ovr_strip_grid *g = &level->grid;
    const ptrdiff_t first = -(ptrdiff_t)march->ghosts;
    const size_t n = g->n + march->ghosts;
    (void)member;
    for (size_t i = from ? from : 1; i < to && i + 1 < g->n; i++) {
        rows sum = {0};
        for (int k = 0; k < 2; k++)
            add_shifted(&sum, g, march->q[k], first, n, (ptrdiff_t)i,
                        s->distance[k], s->a[k + 1]);
        march->strip->run->blend(g->lines, sum.count, sum.weight, sum.from,
                                 level->f.F + ovr_strip_row(g, i));
    }
}

static void make_side(const ovr_strip_march *march)
{
    const ovr_strip_grid *g = &finest_of(march)->grid;
    double moved = march->characteristic ? 1 / g->D : 0;
    double distance[2] = {march->next - march->T[0], march->next - march->T[1]};
    side s = {.march = march};
    if (!(march->T[0] > march->T[1]))
        distance[1] = 2 * distance[0];
    for (size_t k = 0; k < 2; k++)
        if (!isnan(march->travel[k]))
            distance[k] = march->travel[k];
    for (size_t k = 0; k < 2; k++)
        s.distance[k] = distance[k] * moved;
    weigh(march, s.a);
    ovr_strip_share(march->strip, g, g->n, fill_side, &s);
    if (march->characteristic)
        ovr_strip_characteristic(march->strip, s.a[0]);
    else
        ovr_strip_wedge(march->strip, march->speed, s.a[0]);
}

static bool can_guess(const ovr_strip_march *march, int k)
{
    const formula *f = &formulas[k];
    bool shifts = false;
    for (size_t t = 0; t < f->count; t++)
        shifts = shifts || f->term[t].shifts;
    return march->known >= f->needs && (!shifts || isfinite(march->carried));
}

/* Pressure rows of the guess by a formula. */
typedef struct guess {
    const ovr_strip_march *march;
    const formula *formula;
    double *P;
} guess;

static void fill_guess(void *data, int member, size_t from, size_t to)
{
    const ovr_strip_march *march = ((const guess *)data)->march;
    const formula *f = ((const guess *)data)->formula;
    double *P = ((const guess *)data)->P;
    const ovr_strip_grid *g = &finest_of(march)->grid;
    double distance = march->carried * (march->next - march->T[0]) / g->D;
    (void)member;
    for (size_t i = from ? from : 1; i < to && i + 1 < g->n; i++) {
        rows sum = {0};
        for (size_t t = 0; t < f->count; t++)
            add_shifted(&sum, g, march->P[f->term[t].ago], 0, g->n,
                        (ptrdiff_t)i,
                        f->term[t].shifts ? f->term[t].shifts * distance : 0,
                        f->term[t].weight);
        size_t row = ovr_strip_row(g, i);
        march->strip->run->blend(g->lines, sum.count, sum.weight, sum.from,
                                 P + row);
        march->strip->run->hold(g->lines, march->P[0] + row, P + row);
    }
}

static void guess_pressure(const ovr_strip_march *march, int k, double *P)
{
    const ovr_strip_grid *g = &finest_of(march)->grid;
    guess of = {march, &formulas[k], P};
    memset(P, 0, g->lines * sizeof *P);
    memset(P + ovr_strip_row(g, g->n - 1), 0, g->lines * sizeof *P);
    ovr_strip_share(march->strip, g, g->n, fill_guess, &of);
}

/* Checks that all known steps are equal, as the formulas assume. */
static bool steps_are_equal(const ovr_strip_march *march)
{
    double step = march->next - march->T[0];
    for (size_t k = 0; k + 1 < march->known && k + 1 < OVR_STRIP_PAST; k++)
        if (fabs(march->T[k] - march->T[k + 1] - step) > 1e-6 * step)
            return false;
    return true;
}

static void make_guess(ovr_strip_march *march)
{
    int k = march->formula;
    if (!can_guess(march, k) || !steps_are_equal(march))
        k = 0;
    guess_pressure(march, k, finest_of(march)->f.P);
    march->strip->H0 = 0;
    for (size_t t = 0; t < OVR_STRIP_PAST; t++)
        march->strip->H0 += formulas[k].H0[t] * march->H0[t];
}

/* Compares all guesses with the solution, at every fourth step and while new
 * formulas become available. */
static void learn(ovr_strip_march *march)
{
    enum { EVERY = 4 };
    ovr_strip_level *level = finest_of(march);
    const double forgets = 0.7;
    double best = INFINITY;
    march->steps++;
    if (!steps_are_equal(march) ||
        (march->steps > OVR_STRIP_PAST + 1 && march->steps % EVERY))
        return;
    march->formula = 0;
    for (int k = 0; k < OVR_STRIP_GUESSES; k++) {
        if (!can_guess(march, k))
            continue;
        /* `entry` of the finest grid is not used in a cycle. */
        guess_pressure(march, k, level->f.entry);
        double apart = ovr_strip_distance(march->strip, level, level->f.entry,
                                          level->f.P);
        double *near = &march->nearness[k];
        *near = *near > 0 ? forgets * *near + (1 - forgets) * apart : apart;
        if (*near < best) {
            best = *near;
            march->formula = k;
        }
    }
}

/* Settings of the attempts after the first. */
typedef struct setting {
    int zebra; /* -1: the other coupling of lines */
    int sweeps, cycles;
    double correction, limit, plain;
    bool afresh; /* start from the last film */
    double tau;  /* factor of tau */
} setting;

static const setting settings[OVR_STRIP_ATTEMPTS] = {
    {0, 1, 30, 1, 0.5, 0.7, false, 1},  {0, 1, 25, 1, 0.5, 0.7, true, 4},
    {-1, 1, 25, 1, 0.5, 0.7, true, 1},  {0, 2, 40, 0.7, 0.5, 0.7, true, 1},
    {0, 2, 40, 0.5, 0.2, 0.7, true, 1}, {0, 3, 80, 0.3, 0.1, 0.5, true, 1}};

static ovr_strip_cycling cycling_of(const ovr_strip_march *march, int attempt)
{
    const setting *s = &settings[attempt];
    ovr_strip_cycling how = ovr_strip_transient(&march->strip->fluid);
    bool zebra = attempt == 0 ? march->coupling
                              : s->zebra < 0 && !march->coupling;
    how.smoothing.zebra = zebra;
    how.smoothing.plain = zebra ? 1 : s->plain;
    if (zebra)
        how.smoothing.whole = 0.8;
    how.smoothing.limit = s->limit;
    how.smoothing.tau *= s->tau;
    how.correction = s->correction;
    how.sweeps_before = how.sweeps_after = s->sweeps;
    return how;
}

static void restore(ovr_strip_march *march)
{
    const ovr_strip_level *level = finest_of(march);
    memcpy(level->f.P, march->P[0],
           ovr_strip_size(&level->grid) * sizeof *level->f.P);
    march->strip->H0 = march->H0[0];
}

static void couple_otherwise(ovr_strip_smoothing *how)
{
    const double jacobi = settings[0].plain;
    how->zebra = !how->zebra;
    how->plain = how->zebra ? 1 : jacobi;
}

/* State of the cycles of an attempt. */
typedef struct progress {
    ovr_strip_march *march;
    ovr_strip_step *step;
    ovr_strip_cycling how;
    bool first;    /* first attempt */
    double enough; /* tolerance of R */
    double R, last[2];
    double begun; /* R when the coupling was selected, `since` cycles ago */
    int since;
    double rate[2]; /* reduction of R per cycle with each coupling; 0: unknown
                     */
} progress;

/* Computes R; returns true if the film is solved. */
static bool is_solved(progress *p)
{
    const double most = p->march->load;
    ovr_strip_level *level = finest_of(p->march);
    ovr_strip_defect d = ovr_strip_defect_of(p->march->strip, level);
    p->step->imbalance = p->R = d.imbalance;
    return ovr_strip_below(d, p->enough) && (!(most > 0) || d.load <= most);
}

/* Solves the nodes that contribute more than a hundredth of R by Newton's
 * method. Returns true if the film is then solved. */
static bool solve_spots(progress *p)
{
    enum { STEPS = 8 };
    const double part = 0.01;
    ovr_strip_level *level = finest_of(p->march);
    const ovr_strip_grid *g = &level->grid;
    for (int k = 0; k < STEPS; k++) {
        double whole = p->R * ovr_strip_centre(level, level->f.H) *
                       (double)ovr_across_intervals(g->lines) / g->D;
        if (!ovr_strip_spots(p->march->strip, level, &p->how.smoothing,
                             part * whole))
            return false;
        if (is_solved(p))
            return true;
    }
    return false;
}

/* Changes the coupling of lines if the other one reduces R faster or has not
 * been tried. Otherwise halves the corrections, or restores their full size. */
static void change_coupling(progress *p)
{
    const bool zebra = p->how.smoothing.zebra;
    p->rate[zebra] = pow(p->R / p->begun, 1. / p->since);
    if (p->rate[!zebra] < p->rate[zebra])
        couple_otherwise(&p->how.smoothing);
    else
        p->how.correction = 1.5 - p->how.correction;
    p->since = 0;
    p->begun = p->R;
}

/* True if a cycle has reduced R too little or increased it. */
static bool is_slow(const progress *p, int cycles)
{
    enum { PATIENCE = 4 };
    return (p->since >= PATIENCE && p->R > 0.3 * p->last[1]) ||
           (p->since >= 2 && cycles > 3 && p->R > 1.5 * p->last[0]);
}

/* Performs cycles until R is below the tolerance; returns false if they do not
 * converge. After the third cycle, Newton's method is applied to patches where
 * R stalls. The first attempt changes the coupling of lines if cycles are slow.
 * Later attempts end if eight cycles gain little. */
static bool cycle_until(ovr_strip_march *march, int attempt,
                        ovr_strip_step *step)
{
    enum { LONG = 8, FROM = 4 };
    const double hopeless = 1e7, slow = 0.5;
    progress p = {.march = march,
                  .step = step,
                  .how = cycling_of(march, attempt),
                  .first = !attempt};
    is_solved(&p);
    p.enough = fmax(march->tolerance, fmin(march->share * p.R, march->loosest));
    p.last[0] = p.last[1] = p.begun = p.R;
    double before = p.R;
    for (int c = 1; c <= settings[attempt].cycles; c++) {
        if (ovr_strip_stops(march->strip))
            return false;
        ovr_strip_cycle(march->strip, march->strip->finest, &p.how);
        step->cycles++;
        p.since++;
        bool solved = is_solved(&p), stalls = !(p.R < slow * p.last[0]);
        march->strip->fluid.secants = attempt || stalls;
        if (!solved && !(p.R < hopeless))
            return false;
        if (p.first && !solved && is_slow(&p, c))
            change_coupling(&p);
        p.last[1] = p.last[0];
        p.last[0] = p.R;
        if (solved || (c >= FROM && stalls && solve_spots(&p))) {
            if (attempt < 3)
                march->coupling = p.how.smoothing.zebra;
            return true;
        }
        if (attempt && c % LONG == 0) {
            if (p.R > before * 2 / 3)
                return false;
            before = p.R;
        }
    }
    return false;
}

ovr_strip_step ovr_strip_march_attempt(ovr_strip_march *march, double next)
{
    ovr_strip_step step = {0};
    ovr_strip_level *level = finest_of(march);
    march->next = next;
    march->gap(march->data, next, &level->grid, 0, level->grid.n, level->f.gap);
    make_side(march);
    level->force = march->force;
    make_guess(march);
    for (int k = march->first;
         !step.solved && k < OVR_STRIP_ATTEMPTS &&
         !(step.attempts && ovr_strip_stops(march->strip));
         k++) {
        if (settings[k].afresh)
            restore(march);
        march->strip->fluid.secants = k > 0;
        ovr_strip_refresh(march->strip, level);
        step.solved = cycle_until(march, k, &step);
        step.attempts++;
        step.last = k;
    }
    return step;
}

void ovr_strip_march_accept(ovr_strip_march *march)
{
    const size_t last = OVR_STRIP_PAST - 1;
    double *P = march->P[last], *q = march->q[1];
    learn(march);
    for (size_t k = last; k > 0; k--) {
        march->P[k] = march->P[k - 1];
        march->H0[k] = march->H0[k - 1];
    }
    for (size_t k = OVR_STRIP_PAST; k > 0; k--)
        march->T[k] = march->T[k - 1];
    march->T[0] = march->next;
    march->P[0] = P;
    march->H0[0] = march->strip->H0;
    march->q[1] = march->q[0];
    march->q[0] = q;
    keep_pressure(march, P);
    keep_content(march, march->next, q);
    if (march->known < OVR_STRIP_PAST)
        march->known++;
}

void ovr_strip_march_back(ovr_strip_march *march)
{
    ovr_strip_level *level = finest_of(march);
    restore(march);
    march->gap(march->data, march->T[0], &level->grid, 0, level->grid.n,
               level->f.gap);
    ovr_strip_refresh(march->strip, level);
}
