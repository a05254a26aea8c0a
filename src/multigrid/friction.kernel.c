/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mean shear stress and friction (equations in friction.h).  Arrays in the
 * order of the nodes, n > VEC: the last vector overlaps the one before. */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* Where the vector of half nodes at i begins. */
static inline size_t start_of(size_t i, size_t halves)
{
    return i + VEC <= halves ? i : halves - VEC;
}

static inline ivec new_elements(size_t i, size_t halves)
{
    ivec lane;
    for (int l = 0; l < VEC; l++)
        lane[l] = l;
    return lane >= (int64_t)(i - start_of(i, halves)) - (ivec){0};
}

/* x_i + x_{i+1} */
static inline vec pair_at(const double *x, size_t i)
{
    return load(x + i) + load(x + i + 1);
}

static inline ivec wet_at(const ovr_sheared *f, size_t i)
{
    return larger(load(f->P + i), load(f->P + i + 1)) > 0;
}

/* t at the half nodes 0..n-2, 0 where it is dry */
void OVR_KERNEL(mean_stress)(const ovr_sheared *f, double V, double *t)
{
    for (size_t k = 0; k < f->n - 1; k += VEC) {
        size_t i = start_of(k, f->n - 1);
        vec drag = fused(load(f->q + i), load(f->H + i),
                         load(f->q + i + 1) * load(f->H + i + 1));
        vec stress = (-V / 12) * drag / pair_at(f->eps, i);
        store(t + i, choose(wet_at(f, i), stress, all(0)));
    }
}

ovr_friction OVR_KERNEL(friction)(const ovr_sheared *f, const double *t)
{
    vec slide = all(0), roll = all(0), poiseuille = all(0);
    for (size_t k = 0; k < f->n - 1; k += VEC) {
        size_t i = start_of(k, f->n - 1);
        ivec counts = wet_at(f, i) & new_elements(k, f->n - 1);
        vec dX = load(f->X + i + 1) - load(f->X + i);
        vec dP = choose(counts, load(f->P + i + 1) - load(f->P + i), all(0));
        vec H = pair_at(f->H, i), flow = pair_at(f->eps, i) * H;
        slide = fused(choose(counts, load(t + i), all(0)), dX, slide);
        roll = fused(H, dP, roll);
        poiseuille += flow * dP * dP / (dX * pair_at(f->q, i));
    }
    return (ovr_friction){sum_of_lanes(slide), 0.25 * sum_of_lanes(roll),
                          0.5 * sum_of_lanes(poiseuille)};
}
