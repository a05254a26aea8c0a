/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Projected relaxation at the film ends. Near the cavitation boundary the
 * Poiseuille flow dominates. The equation is then a Poisson equation with the
 * constraint P >= 0:
 *
 *     sum E_k (P_k - P) - a0 dq/dP (P - P_0)
 *         = F + a0 q_0 + a1 q_{i-1} + a2 q_{i-2}
 *
 * Flow coefficients, film thickness and upstream q are constant. Method:
 * two-colour Gauss-Seidel within a row and from row to row, in alternating
 * directions. The relaxation factor is 1.3, and negative pressures are set to
 * 0.
 *
 * A line relaxation sweep moves the cavitation boundary by one node. Jacobi
 * coupling transfers changes between lines slowly, and coarse grids do not
 * resolve the boundary.  Without these sweeps the boundary oscillates between
 * two states.  R is then not reduced at M = 5, and by 0.57 a cycle at M = 20
 * (513 x 128 nodes).  With 8 double sweeps R is reduced by 0.19 a cycle.
 *
 * The sweeps cover rows within 8 rows of a cavitated node.  Of these rows only
 * nodes with sum E > end_share a0 rho k(0,0) change.  end_share = 3 is unstable
 * in transient steps.
 */
#include "multigrid/vector.h"
#include "strip/across.h"
#include "strip/kernels.h"
#include "strip/vectors.h"

enum { REACH = 8, WET_REACH = 3 };

static size_t dry_nodes(const ovr_strip_grid *g, const double *P)
{
    size_t count = 0;
    for (size_t j = 0; j < g->lines; j++)
        count += P[j] <= 0;
    return count;
}

/* Finds the rows to be swept. dry[i] is the number of cavitated nodes of row i;
 * it is 0 for the inlet. */
static size_t find_rows(const ovr_strip_grid *g, const double *P, double *dry,
                        double *rows)
{
    size_t found = 0, n = g->n;
    dry[0] = 0;
    for (size_t i = 1; i < n; i++)
        dry[i] = (double)dry_nodes(g, P + ovr_strip_row(g, i));
    for (size_t i = 1; i + 1 < n; i++) {
        bool near_dry = false, near_wet = false;
        size_t from = i > REACH ? i - REACH : 1;
        for (size_t k = from; k <= i + REACH && k + 1 < n && !near_dry; k++)
            near_dry = dry[k] > 0;
        from = i > WET_REACH ? i - WET_REACH : 1;
        for (size_t k = from; k <= i + WET_REACH && k + 1 < n && !near_wet; k++)
            near_wet = dry[k] < (double)g->lines;
        if (near_dry && near_wet)
            rows[found++] = (double)i;
    }
    return found;
}

/* Derivatives of the four flows with respect to the pressure difference, for
 * constant phi. */
typedef struct tangents {
    vec west, east, south, north;
} tangents;

static inline tangents tangents_at(const ovr_strip_fields *f, size_t k,
                                   size_t s)
{
    const double *b = f->along_before, *a = f->along_after;
    tangents t = {.west = 0.5 * (load(b + k - s) + load(a + k - s)),
                  .east = 0.5 * (load(b + k) + load(a + k))};
    b = f->across_before;
    a = f->across_after;
    t.south = 0.5 * (load(b + k - 1) + load(a + k - 1));
    t.north = 0.5 * (load(b + k) + load(a + k));
    return t;
}

/* Stores the right-hand side of row i in delta and the inverse diagonal in
 * spread; 0 where the node does not change. */
static void freeze(const ovr_strip_grid *g, const double a[3], size_t i,
                   const ovr_strip_smoothing *how, double k00,
                   const ovr_strip_fields *f)
{
    const size_t s = g->stride, far = i >= 2 ? 2 * s : s;
    for (size_t j = 0; j < g->lines; j += VEC) {
        size_t k = ovr_strip_row(g, i) + j;
        tangents t = tangents_at(f, k, s);
        vec out = t.west + t.east + t.south + t.north;
        vec dq = a[0] * load(f->dq + k);
        vec right = fused(dq, load(f->P + k), -load(f->F + k));
        right = less(right, all(a[0]), load(f->q + k));
        right = less(right, all(a[1]), load(f->q + k - s));
        right = less(right, all(a[2]), load(f->q + k - far));
        vec P = load(f->P + k);
        right = fused(load(f->along + k - s) - t.west, load(f->P + k - s) - P,
                      right);
        right = fused(load(f->along + k) - t.east, load(f->P + k + s) - P,
                      right);
        right = fused(load(f->across + k - 1) - t.south, load(f->P + k - 1) - P,
                      right);
        right = fused(load(f->across + k) - t.north, load(f->P + k + 1) - P,
                      right);
        ivec part = out > how->end_share * a[0] * k00 * load(f->rho + k);
        store(f->delta + k, right);
        store(f->spread + k, choose(part, 1 / (out + dq), all(0)));
    }
}

static void sweep_row(const ovr_strip_grid *g, const ovr_strip_fields *f,
                      size_t i)
{
    const double relaxed = 1.3;
    const size_t s = g->stride, row = ovr_strip_row(g, i);
    ivec odd;
    for (int l = 0; l < VEC; l++)
        odd[l] = -(l & 1);
    ovr_across_close(g->lines, 1, f->P + row);
    for (int colour = 0; colour < 2; colour++) {
        for (size_t j = 0; j < g->lines; j += VEC) {
            const size_t k = row + j;
            double *P = f->P + k;
            vec p = load(P), inverse = load(f->spread + k);
            tangents t = tangents_at(f, k, s);
            vec v = fused(t.west, load(P - s), load(f->delta + k));
            v = fused(t.east, load(P + s), v);
            v = fused(t.south, load(P - 1), v);
            v = fused(t.north, load(P + 1), v);
            v = larger(all(0), fused(all(relaxed), less(-p, -v, inverse), p));
            ivec moves = (inverse > 0) & (colour ? odd : ~odd) &
                         lines_before(j, g->lines);
            store(P, choose(moves, v, p));
        }
        ovr_across_close(g->lines, 1, f->P + row);
    }
}

/* `work` has 2 n elements. */
void OVR_STRIP_KERNEL(sweep_ends)(const ovr_strip_grid *g,
                                  const ovr_strip_weights *w,
                                  const ovr_strip_smoothing *how, double k00,
                                  const ovr_strip_fields *own, double *work)
{
    const ovr_strip_fields f = *own;
    double *dry = work, *rows = work + g->n;
    size_t count = find_rows(g, f.P, dry, rows);
    for (size_t z = 0; z < count; z++) {
        size_t i = (size_t)rows[z];
        freeze(g, i == 1 ? w->first : w->a, i, how, k00, &f);
    }
    for (int sweep = 0; sweep < 2 * how->end_sweeps; sweep++)
        for (size_t z = 0; z < count; z++)
            sweep_row(g, &f, (size_t)rows[sweep & 1 ? count - 1 - z : z]);
}
