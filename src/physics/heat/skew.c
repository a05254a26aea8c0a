/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Skewed flow by temperature differences (equations in skew.h). */
#include "physics/heat/skew.h"

#include <math.h>
#include <string.h>

#include "base/larger.h"
#include "contact/contact.h"
#include "physics/heat/in_time.h"
#include "simulation/fourth.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"

/* Pressure (p_h) below which s decreases to zero with mass-conserving
 * cavitation. */
static const double LOW = 0.005;

/* True if rows do not contain the upstream nodes. */
static bool is_explicit(const ovr_simulation *sim)
{
    return sim->histories.backward && !sim->histories.mirrored;
}

ovr_status ovr_heat_skew_take(ovr_simulation *sim, ovr_error *err)
{
    ovr_heated *h = sim->heated;
    OVR_TAKE_NODES(sim, err, &h->skewed, &h->skew, &h->skew_by_P,
                   &h->skewed_next, &h->unused);
    return ovr_hierarchy_skew(&sim->grids, sim->scheme->order == 2, &sim->arena,
                              err);
}

void ovr_heat_skew_forget(ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    size_t bytes = sim->now.n * sizeof(double);
    memset(h->skewed, 0, bytes);
    memset(h->skew, 0, bytes);
    memset(h->skew_by_P, 0, bytes);
}

/* ---------------------------------------------------------------- Film end */

bool ovr_heat_opposed(const ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    return h->u1 * (h->u1 - h->V) < 0;
}

double ovr_heat_film_end(const ovr_simulation *sim, ptrdiff_t *last)
{
    const double *P = sim->now.P;
    const ptrdiff_t n = (ptrdiff_t)sim->now.n,
                    out = sim->histories.backward ? -1 : 1;
    ptrdiff_t i = sim->histories.backward ? 0 : n - 1;
    while (i >= 0 && i < n && !(P[i] > 0))
        i -= out;
    *last = i;
    if (i <= 0 || i >= n - 1 || i - 2 * out < 0 || i - 2 * out >= n)
        return -1;
    double bend = P[i - out] - 2 * P[i];
    return bend > P[i] ? P[i] / bend : 1;
}

/* Sets s constant from 2 mesh sizes before the film end on. */
static void hold_end(const ovr_simulation *sim, double *s)
{
    const double before_end = 2;
    const ptrdiff_t n = (ptrdiff_t)sim->now.n,
                    out = sim->histories.backward ? -1 : 1;
    ptrdiff_t last;
    double share = ovr_heat_film_end(sim, &last);
    if (share < 0)
        return;
    double back = before_end - share, whole = floor(back);
    ptrdiff_t first = last - (ptrdiff_t)whole * out;
    double held = s[first] + (back - whole) * (s[first - out] - s[first]);
    for (ptrdiff_t i = first; i >= 0 && i < n; i += out)
        s[i] = held;
}

static void fade(const ovr_simulation *sim, double *s)
{
    for (size_t i = 0; i < sim->now.n; i++)
        s[i] *= ovr_larger(0, ovr_smaller(1, sim->now.P[i] / LOW));
}

/* ------------------------------------------------------ Filter and slope */

/* Applies means (1, 2, 1)/4 of neighbouring nodes with P > 0 `times` times to
 * v. */
static void mean(const ovr_simulation *sim, int times, double *v, double *work)
{
    const double *P = sim->now.P;
    size_t last = sim->now.n - 1;
    for (int k = 0; k < times; k++) {
        memcpy(work, v, (last + 1) * sizeof *v);
        for (size_t i = 1; i < last; i++) {
            double left = P[i - 1] > 0 ? work[i - 1] : work[i];
            double right = P[i + 1] > 0 ? work[i + 1] : work[i];
            double all = 0.25 * (left + right) + 0.5 * work[i];
            v[i] = P[i] > 0 ? all : work[i];
        }
    }
}

/* Filters by 2 M^4 - M^8. */
static void smooth(const ovr_simulation *sim, double *s)
{
    double *v = ovr_work_take(sim), *work = ovr_work_take(sim);
    size_t n = sim->now.n;
    mean(sim, 4, s, work);
    memcpy(v, s, n * sizeof *v);
    mean(sim, 4, v, work);
    for (size_t i = 0; i < n; i++)
        s[i] = 2 * s[i] - v[i];
    ovr_work_give(sim, work);
    ovr_work_give(sim, v);
}

/* Computes s_1 of the film for which s q was computed last, from s q with the
 * viscosities at P + dP. Slopes of small s are negligible. */
static void find_slopes(ovr_simulation *sim)
{
    const double little = 0.02, dP = 1e-4,
                 direction = sim->histories.mirrored ? -1 : 1;
    const double lowest = ovr_conserves(sim) ? LOW : 0;
    const double *q = sim->now.q;
    ovr_heated *h = sim->heated;
    size_t n = sim->now.n;
    memset(h->skew_by_P, 0, n * sizeof *h->skew_by_P);
    if (!(h->numbers.C > 0) || is_explicit(sim))
        return;
    double *P = ovr_work_take(sim), *log_eta = ovr_work_take(sim);
    for (size_t i = 0; i < n; i++)
        P[i] = sim->now.P[i] + dP;
    sim->grids.kernels->log_viscosity(n, &sim->grids.fluid, P, sim->now.H,
                                      log_eta);
    ovr_columns next = h->film;
    next.log_eta = log_eta;
    next.skewed = h->skewed_next;
    next.th = next.shift = next.drag = next.swell = h->unused;
    memcpy(next.skewed, h->skewed, n * sizeof *next.skewed);
    sim->grids.kernels->flow_cross_film(&next);
    for (size_t i = 0; i < n; i++) {
        double rise = next.skewed[i] - h->skewed[i];
        if (sim->now.P[i] > lowest && fabs(h->skewed[i]) > little * q[i])
            h->skew_by_P[i] = direction * h->skew_share *
                              ovr_larger(0, direction * rise / (q[i] * dP));
    }
    ovr_work_give(sim, log_eta);
    ovr_work_give(sim, P);
}

void ovr_heat_skew_find(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    const double *P = sim->now.P, *q = sim->now.q;
    size_t n = sim->now.n;
    find_slopes(sim);
    for (size_t i = 0; i < n; i++)
        h->skew[i] = q[i] > 0 ? h->skew_share * h->skewed[i] / q[i] : 0;
    if (ovr_conserves(sim))
        fade(sim, h->skew);
    else if (ovr_heat_opposed(sim))
        hold_end(sim, h->skew);
    smooth(sim, h->skew);
    for (size_t i = 0; i < n; i++) {
        h->skewed[i] = h->skew[i] * q[i];
        h->skew[i] -= h->skew_by_P[i] * P[i];
    }
}

/* ------------------------------------------------------------ On the grids */

/* Computes F without the skewed flow. */
static void sides(const ovr_simulation *sim, double *F)
{
    const ovr_heat_steps *s = sim->heated->steps;
    size_t n = sim->now.n;
    if (s->dT > 0) {
        memcpy(F, s->F, n * sizeof *F);
        return;
    }
    memset(F, 0, n * sizeof *F);
    ovr_fourth_sides(sim, F);
}

/* Adds the wedge of q s for flow from the right. */
static void add_wedge_from_right(const ovr_simulation *sim, double *F)
{
    const double *v = sim->heated->skewed;
    const ovr_weights *w = &sim->finest->weights;
    size_t last = sim->now.n - 1;
    for (size_t i = 0; i <= last; i++) {
        const double *b = i + 1 == last ? w->skew_first : w->skew;
        for (size_t m = 0; m < 3 && i + m <= last; m++)
            F[i] -= b[m] * v[i + m];
    }
}

static void set_right_side(ovr_simulation *sim)
{
    double *F = ovr_work_take(sim);
    sides(sim, F);
    if (is_explicit(sim))
        add_wedge_from_right(sim, F);
    ovr_nodes_write(sim, sim->finest, F, sim->finest->f.F);
    ovr_work_give(sim, F);
}

/* Transfers s to all grids by injection, with the sign of a wedge along the
 * grid. */
static void set_rows(ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    const double sign = is_explicit(sim) ? 0 : sim->histories.mirrored ? -1 : 1;
    double *workspace = ovr_work_take(sim);
    for (int l = sim->grids.finest; l >= sim->grids.coarsest; l--) {
        ovr_level *level = &sim->grids.level[l];
        size_t every = (size_t)1 << (sim->grids.finest - l);
        for (int k = 0; k < 2; k++) {
            const double *from = k ? h->skew_by_P : h->skew;
            for (size_t i = 0; i < level->grid.n; i++)
                workspace[i] = sign * from[i * every];
            ovr_nodes_write(sim, level, workspace,
                            k ? level->f.skew_by_P : level->f.skew);
        }
    }
    ovr_work_give(sim, workspace);
}

void ovr_heat_skew_give(ovr_simulation *sim)
{
    set_rows(sim);
    set_right_side(sim);
}

/* With the wedge of s q' on the right-hand side, a stiff film responds with a
 * change of q that is -s times the change of q'. Applying the fraction 1/(1 +
 * s) of the change solves both equations at once. */
bool ovr_heat_skew_follow(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    const double *P = sim->now.P, *q = sim->now.q;
    bool on_right = is_explicit(sim);
    for (size_t i = 0; i < sim->now.n; i++) {
        double s = h->skew[i] + h->skew_by_P[i] * P[i];
        double change = s * q[i] - h->skewed[i];
        h->skewed[i] += on_right ? change / (1 + ovr_larger(s, 0)) : change;
    }
    if (on_right)
        set_right_side(sim);
    return on_right;
}
