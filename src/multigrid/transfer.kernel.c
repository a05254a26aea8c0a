/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Transfers between a grid and the next coarser one (equations in fas.h), and
 * sums of arrays.
 *
 * Coarsening stays within a lane if the coarse grid's lanes are half as long.
 * Otherwise (smallest grids, widest vectors) the transfer works node by node.
 */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

double OVR_KERNEL(sum)(const ovr_lanes *g, const double *x)
{
    vec part[4] = {all(0), all(0), all(0), all(0)};
    ptrdiff_t S = (ptrdiff_t)g->S, J = 0;
    for (; J + 4 <= S; J += 4)
        for (ptrdiff_t k = 0; k < 4; k++)
            part[k] += at(x, J + k);
    for (; J < S; J++)
        part[0] += at(x, J);
    return sum_of_lanes((part[0] + part[1]) + (part[2] + part[3]));
}

/* result = a x + b y for any n; result may be x or y */
void OVR_KERNEL(combine)(size_t n, double a, const double *x, double b,
                         const double *y, double *result)
{
    size_t i = 0;
    for (; i + VEC <= n; i += VEC)
        store(result + i, a * load(x + i) + b * load(y + i));
    for (; i < n; i++)
        result[i] = a * x[i] + b * y[i];
}

/* gap = H - H0 + w; on entry gap contains H. */
void OVR_KERNEL(coarse_gap)(const ovr_lanes *g, double H0, const double *w,
                            double *gap)
{
    for (ptrdiff_t J = -OVR_HALO; J <= (ptrdiff_t)g->S; J++)
        put(gap, J, at(gap, J) - H0 + at(w, J));
}

/* Full weighting of P if all three nodes are pressurized, else injection. */
static inline vec weighted_pressure(const vec P[3], const ivec wet[3])
{
    return choose(wet[0] & wet[1] & wet[2],
                  0.25 * (P[0] + (P[1] + P[1]) + P[2]), P[1]);
}

/* Full weighting of the residual of pressurized nodes, at pressurized nodes. */
static inline vec weighted_residual(const vec r[3], const ivec wet[3])
{
    vec left = choose(wet[0], r[0], all(0));
    vec right = choose(wet[2], r[2], all(0));
    return choose(wet[1], 0.25 * (left + (r[1] + r[1]) + right), all(0));
}

static void restrict_lanes(ptrdiff_t S, const ovr_fields *f, double *Pc,
                           double *entry, double *Hc, double *rc)
{
    const double *fine_P = f->P, *fine_r = f->r, *H = f->H;
    const unsigned char *set = f->wet;
    vec P[3] = {at(fine_P, -1)}, r[3] = {at(fine_r, -1)};
    ivec wet[3] = {in_set(set, -1)};
    for (ptrdiff_t J = 0; J < S; J++) {
        for (ptrdiff_t k = 1; k < 3; k++) {
            P[k] = at(fine_P, 2 * J - 1 + k);
            r[k] = at(fine_r, 2 * J - 1 + k);
            wet[k] = in_set(set, 2 * J - 1 + k);
        }
        vec here = weighted_pressure(P, wet);
        put(Pc, J, here);
        put(entry, J, here);
        put(rc, J, weighted_residual(r, wet));
        put(Hc, J, at(H, 2 * J));
        P[0] = P[2];
        r[0] = r[2];
        wet[0] = wet[2];
    }
    put(Hc, S, at(H, 2 * S));
    for (ptrdiff_t J = -OVR_HALO; J < 0; J++)
        put(Hc, J, lanes_up(at(Hc, J), at(Hc, S + J)));
}

/* Restricts node by node. */
static void restrict_nodes(const ovr_lanes *coarse, const ovr_lanes *fine,
                           const ovr_fields *f, double *Pc, double *entry,
                           double *Hc, double *rc)
{
    for (size_t I = 0; I < coarse->n; I++) {
        size_t i = 2 * I, to = ovr_lanes_place(coarse, I);
        Hc[to] = f->H[ovr_lanes_place(fine, i)];
        if (I == 0 || I == coarse->n - 1)
            continue;
        vec P[3], r[3];
        ivec wet[3];
        for (size_t k = 0; k < 3; k++) {
            size_t from = ovr_lanes_place(fine, i - 1 + k);
            P[k] = all(f->P[from]);
            r[k] = all(f->r[from]);
            wet[k] = all(ovr_lanes_has(fine, f->wet, i - 1 + k)) > 0;
        }
        Pc[to] = entry[to] = weighted_pressure(P, wet)[0];
        rc[to] = weighted_residual(r, wet)[0];
    }
    repeat_ends(Hc, (ptrdiff_t)coarse->S, OVR_HALO);
}

/* Computes P_c, H at coarse nodes, and the restricted residual of pressurized
 * nodes; zero at both ends. */
void OVR_KERNEL(restrict_fields)(const ovr_lanes *coarse, const ovr_lanes *fine,
                                 const ovr_fields *f, double *Pc, double *entry,
                                 double *Hc, double *rc)
{
    if (fine->S == 2 * coarse->S)
        restrict_lanes((ptrdiff_t)coarse->S, f, Pc, entry, Hc, rc);
    else
        restrict_nodes(coarse, fine, f, Pc, entry, Hc, rc);
    Pc[0] = entry[0] = rc[0] = 0;
}

/* F = N + residual, where r contains -N; afterwards r is the residual. */
void OVR_KERNEL(coarse_side)(const ovr_lanes *g, const double *residual,
                             double *F, double *r)
{
    for (ptrdiff_t J = 0; J < (ptrdiff_t)g->S; J++) {
        vec here = at(residual, J);
        put(F, J, here - at(r, J));
        put(r, J, here);
    }
}

static inline void correct_vector(double *P, const unsigned char *wet,
                                  ptrdiff_t J, vec change)
{
    vec here = at(P, J);
    put(P, J, choose(in_set(wet, J), larger(here + change, all(0)), here));
}

static void correct_lanes(ptrdiff_t S, double factor, const double *Pc,
                          const double *entry, double *P,
                          const unsigned char *wet)
{
    vec first = factor * (at(Pc, 0) - at(entry, 0)), left = first, right;
    for (ptrdiff_t J = 0; J < S - 1; J++) {
        right = factor * (at(Pc, J + 1) - at(entry, J + 1));
        correct_vector(P, wet, 2 * J, left);
        correct_vector(P, wet, 2 * J + 1, 0.5 * (left + right));
        left = right;
    }
    right = lanes_down(first, all(0));
    correct_vector(P, wet, 2 * S - 2, left);
    correct_vector(P, wet, 2 * S - 1, 0.5 * (left + right));
}

static void correct_nodes(const ovr_lanes *coarse, const ovr_lanes *fine,
                          double factor, const double *Pc, const double *entry,
                          const ovr_fields *f)
{
    for (size_t i = 1; i + 1 < fine->n; i++) {
        size_t left = ovr_lanes_place(coarse, i / 2);
        size_t right = ovr_lanes_place(coarse, (i + 1) / 2);
        double *here = f->P + ovr_lanes_place(fine, i);
        double change = 0.5 * factor *
                        (Pc[left] - entry[left] + Pc[right] - entry[right]);
        if (ovr_lanes_has(fine, f->wet, i))
            *here = larger(all(*here + change), all(0))[0];
    }
}

/* Corrects P at pressurized nodes. */
void OVR_KERNEL(correct)(const ovr_lanes *coarse, const ovr_lanes *fine,
                         double factor, const double *Pc, const double *entry,
                         const ovr_fields *f)
{
    if (fine->S == 2 * coarse->S)
        correct_lanes((ptrdiff_t)coarse->S, factor, Pc, entry, f->P, f->wet);
    else
        correct_nodes(coarse, fine, factor, Pc, entry, f);
}

/* Extrapolation in time: weighted sum at nodes that are pressurized in the
 * newest state (the first), at least zero. In the order of the nodes, n >= VEC:
 * the last vector overlaps. */
void OVR_KERNEL(extrapolate)(size_t n, size_t count, const double weight[],
                             const double *const from[], double *P)
{
    for (size_t next = 0; next < n; next += VEC) {
        size_t i = next + VEC <= n ? next : n - VEC;
        vec newest = load(from[0] + i), sum = weight[0] * newest;
        for (size_t k = 1; k < count; k++)
            sum = fused(all(weight[k]), load(from[k] + i), sum);
        store(P + i, choose(newest > 0, larger(sum, all(0)), newest));
    }
}

static inline vec within(vec x, vec low, vec high)
{
    return smaller(larger(x, low), high);
}

/* Cubic interpolation between four nodes, limited to their range. */
static inline vec shifted(const double c[4], const double *x)
{
    vec v = load(x), sum = c[0] * v, low = v, high = v;
    for (int k = 1; k < 4; k++) {
        v = load(x + k);
        sum = fused(all(c[k]), v, sum);
        low = smaller(low, v);
        high = larger(high, v);
    }
    return within(sum, low, high);
}

/*
 * Extrapolation along moving surfaces that moved by a fraction of D: from[0] +
 * S from[1] - S from[2] where from[0] > 0, at least zero; (S x)_i is the cubic
 * c through x_i..x_{i+3}. The result is limited to [low - r, high + r], where
 * low and high are those of the first two, r = 0.1 (high - low) + 0.02, to
 * avoid oscillating pairs of spikes. In the order of the nodes, n >= VEC.
 */
void OVR_KERNEL(carry)(size_t n, const double c[4], const double *const from[3],
                       double *P)
{
    for (size_t next = 0; next < n; next += VEC) {
        size_t i = next + VEC <= n ? next : n - VEC;
        vec here = load(from[0] + i), moved = shifted(c, from[1] + i);
        vec low = smaller(here, moved), high = larger(here, moved);
        vec beyond = 0.1 * (high - low) + 0.02;
        vec sum = here + moved - shifted(c, from[2] + i);
        sum = within(sum, low - beyond, high + beyond);
        store(P + i, choose(here > 0, larger(sum, all(0)), here));
    }
}
