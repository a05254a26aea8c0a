/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Searches and sums over the nodes after each time step. Arrays in the order of
 * the nodes, n >= VEC: the last vector overlaps the one before.
 */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

static inline double min_lane(vec x)
{
    double minimum = x[0];
    for (int l = 1; l < VEC; l++)
        minimum = x[l] < minimum ? x[l] : minimum;
    return minimum;
}

/* Index of the first minimum of sign times x. */
size_t OVR_KERNEL(extreme)(size_t n, double sign, const double *x)
{
    vec best = sign * load(x);
    size_t i = 0;
    for (size_t k = VEC; k < n; k += VEC)
        best = smaller(best, sign * load(x + start_of(k, n)));
    double minimum = min_lane(best);
    while (i + 1 < n && !(sign * x[i] <= minimum))
        i++;
    return i;
}

/* True if all elements are positive; false if any is NaN. */
bool OVR_KERNEL(positive)(size_t n, const double *x)
{
    ivec failed = {0};
    for (size_t k = 0; k < n; k += VEC)
        failed |= ~(load(x + start_of(k, n)) > 0);
    return !any(failed);
}

/* max |a - b| */
double OVR_KERNEL(difference)(size_t n, const double *a, const double *b)
{
    vec maximum = all(0);
    for (size_t k = 0; k < n; k += VEC) {
        size_t i = start_of(k, n);
        vec d = load(a + i) - load(b + i);
        maximum = larger(larger(d, -d), maximum);
    }
    return -min_lane(-maximum);
}

/* Counts elements of x_1..x_{n-2} that are larger than the one before and not
 * smaller than the next; *last is the index of the last one. */
int OVR_KERNEL(peaks)(size_t n, const double *x, size_t *last)
{
    int count = 0;
    for (size_t k = 1; k < n - 1; k += VEC) {
        size_t i = 1 + start_of(k - 1, n - 2);
        vec here = load(x + i);
        ivec peak = (here > load(x + i - 1)) & (here >= load(x + i + 1)) &
                    new_elements(k - 1, n - 2);
        for (size_t l = 0; any(peak) && l < VEC; l++)
            if (peak[l]) {
                count++;
                *last = i + l;
            }
    }
    return count;
}

/* Mean over the half nodes i + 1/2, i = 1..n-3, between pressurized nodes of
 *     Cu (u_0 q_i + u_1 q_{i-1}) - (eps_i + eps_{i+1})/2 (P_{i+1} - P_i)/D
 * with 2 E of the half nodes, `flow_at`, if there is a rheological model. */
double OVR_KERNEL(mean_flow)(size_t n, const double u[2], const double *X,
                             const double *P, const double *q,
                             const double *eps, const double *flow_at)
{
    vec sum = all(0), count = all(0);
    for (size_t k = 1; k < n - 2; k += VEC) {
        size_t i = 1 + start_of(k - 1, n - 3);
        vec p = load(P + i), next = load(P + i + 1);
        vec twice = flow_at ? load(flow_at + i)
                            : load(eps + i) + load(eps + i + 1);
        vec flow = u[0] * load(q + i) + u[1] * load(q + i - 1) -
                   0.5 * twice * (next - p) / (load(X + i + 1) - load(X + i));
        ivec wet = (p > 0) & (next > 0) & new_elements(k - 1, n - 3);
        sum += choose(wet, flow, all(0));
        count += choose(wet, all(1), all(0));
    }
    double nodes = sum_of_lanes(count);
    return nodes > 0 ? sum_of_lanes(sum) / nodes : 0;
}

/* Integral of the absolute mass flow over the half nodes between n >= VEC + 1
 * nodes,
 *     |Cu (q_i + q_{i+1})/2 (X_{i+1} - X_i) - E (P_{i+1} - P_i)|,
 * 2 E as in mean_flow. */
double OVR_KERNEL(flow_size)(size_t n, double Cu, const double *X,
                             const double *P, const double *q,
                             const double *eps, const double *flow_at)
{
    vec sum = all(0);
    for (size_t k = 0; k < n - 1; k += VEC) {
        size_t i = start_of(k, n - 1);
        vec twice = flow_at ? load(flow_at + i)
                            : load(eps + i) + load(eps + i + 1);
        vec wedge = Cu * (load(q + i) + load(q + i + 1)) *
                    (load(X + i + 1) - load(X + i));
        vec flow = less(wedge, twice, load(P + i + 1) - load(P + i));
        flow = choose(flow < 0, -flow, flow);
        sum += choose(new_elements(k, n - 1), flow, all(0));
    }
    return sum_of_lanes(sum) / 2;
}

/* Integral of |q - sum_k e_k past_k| over pressurized nodes where q < maximum.
 */
double OVR_KERNEL(deviation)(size_t n, const double e[3], double maximum,
                             const double *weights, const double *P,
                             const double *q, double *const past[3])
{
    vec sum = all(0);
    for (size_t k = 0; k < n; k += VEC) {
        size_t i = start_of(k, n);
        vec film = load(q + i), off = film;
        for (size_t m = 0; m < 3; m++)
            off = less(off, all(e[m]), load(past[m] + i));
        off = choose(off < 0, -off, off);
        ivec wet = (load(P + i) > 0) & (film < maximum) & new_elements(k, n);
        sum += choose(wet, load(weights + i) * off, all(0));
    }
    return sum_of_lanes(sum);
}

/* Sum of weights (a - b), or of weights a if b is NULL; any n. */
double OVR_KERNEL(gain)(size_t n, const double *weights, const double *a,
                        const double *b)
{
    vec part = all(0);
    size_t i = 0;
    for (; i + VEC <= n; i += VEC)
        part += load(weights + i) *
                (b ? load(a + i) - load(b + i) : load(a + i));
    double sum = sum_of_lanes(part);
    for (; i < n; i++)
        sum += weights[i] * (b ? a[i] - b[i] : a[i]);
    return sum;
}

/* Sums for the mean and the roughness of the film, in one pass, any n: of the
 * weights w, w H, w q/H, w (q - q_0) and w (q - q_0)^2. */
void OVR_KERNEL(film_sums)(size_t n, const double *weights, const double *q,
                           const double *H, double sums[5])
{
    vec part[5] = {all(0), all(0), all(0), all(0), all(0)};
    size_t i = 0;
    for (; i + VEC <= n; i += VEC) {
        vec w = load(weights + i), content = load(q + i), film = load(H + i);
        vec off = content - q[0], moment = w * off;
        part[0] += w;
        part[1] = fused(w, film, part[1]);
        part[2] += w * content / film;
        part[3] += moment;
        part[4] = fused(moment, off, part[4]);
    }
    for (int k = 0; k < 5; k++)
        sums[k] = sum_of_lanes(part[k]);
    for (; i < n; i++) {
        double w = weights[i], off = q[i] - q[0];
        sums[0] += w;
        sums[1] += w * H[i];
        sums[2] += w * q[i] / H[i];
        sums[3] += w * off;
        sums[4] += w * off * off;
    }
}
