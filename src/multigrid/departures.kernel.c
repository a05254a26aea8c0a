/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Carries values along with surfaces and film (departures.h).  Arrays in the
 * order of the nodes, of more than VEC; near the ends node by node. */
#include "multigrid/departures.h"
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

void OVR_KERNEL(carry_along)(const ovr_departures *f, const double *from,
                             double *to)
{
    const double *v = from + f->first;
    const double c[4] = {f->c[0], f->c[1], f->c[2], f->c[3]};
    size_t i = 0, end = f->to, n = f->n;
    for (; i < f->from; i++)
        to[i] = ovr_departures_at(f, from, i);
    for (; i + VEC <= end; i += VEC) {
        vec sum = c[0] * load(v + i);
        sum = fused(all(c[1]), load(v + i + 1), sum);
        sum = fused(all(c[2]), load(v + i + 2), sum);
        store(to + i, fused(all(c[3]), load(v + i + 3), sum));
    }
    for (; i < n; i++)
        to[i] = ovr_departures_at(f, from, i);
}

/* The number of a node that may be outside, from 0 on. */
static INLINE vec held(vec whole, double last)
{
    return larger(smaller(whole, all(last)), all(0));
}

/* v at i - meshes u_i, in layers that enter with nothing */
void OVR_KERNEL(film_departures)(size_t n, double meshes, const double *u,
                                 const double *v, double *at_departures)
{
    double last = (double)(n - 1);
    vec lane;
    for (int l = 0; l < VEC; l++)
        lane[l] = l;
    for (size_t k = 0; k < n; k += VEC) {
        size_t i = k + VEC <= n ? k : n - VEC;
        vec at = less((double)i + lane, all(meshes), load(u + i));
        at = larger(smaller(at, all(last + 1)), all(-1));
        vec first = from_whole(whole_part(at + 2)) - 2, s = at - first;
        vec a = gather(v, whole_part(held(first, last)));
        vec b = gather(v, whole_part(held(first + 1, last)));
        ivec in_a = (first >= 0) & (first <= last);
        ivec in_b = (first + 1 >= 0) & (first + 1 <= last);
        a = choose(in_a, a, all(0));
        b = choose(in_b, b, all(0));
        store(at_departures + i, fused(s, b - a, a));
    }
}
