/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mean shear stress and friction (equations in friction.h).  Arrays in the
 * order of the nodes, n > VEC: the last vector overlaps the one before. */
#include "multigrid/eyring.h"
#include "multigrid/faces.h"
#include "multigrid/flow.h"
#include "multigrid/flow_table.h"

/* x_i + x_{i+1} */
static inline vec pair_at(const double *x, size_t i)
{
    return load(x + i) + load(x + i + 1);
}

static inline ivec wet_at(const ovr_sheared *f, size_t i)
{
    return larger(load(f->P + i), load(f->P + i + 1)) > 0;
}

/* rho H^2 of both nodes */
static inline vec drag_at(const ovr_sheared *f, size_t i)
{
    return fused(load(f->q + i), load(f->H + i),
                 load(f->q + i + 1) * load(f->H + i + 1));
}

/* Values at a half node: rho H^2 psi_c and eps, both up to a common factor. */
typedef struct slid {
    vec drag, eps;
} slid;

/* phi_i + phi_{i+1} of the half node's mean phi = eps/H^3 (faces.h). */
static inline vec phi_at(const ovr_sheared *f, vec H, vec G, size_t i)
{
    const vec minimum = all(1e-290);
    vec a = larger(load(f->eps + i) / (H * H * H), minimum);
    vec b = larger(load(f->eps + i + 1) / (G * G * G), minimum);
    ivec filled = smaller(load(f->P + i), load(f->P + i + 1)) > 0;
    return choose(filled, 2 * face_root(a) * face_root(b), a + b);
}

static inline slid slid_at(const ovr_sheared *f, bool gap, size_t i)
{
    if (!gap)
        return (slid){drag_at(f, i), pair_at(f->eps, i)};
    vec H = load(f->H + i), G = load(f->H + i + 1);
    vec h = face_film(H), g = face_film(G);
    vec drag = load(f->q + i) / h + load(f->q + i + 1) / g;
    /* films that were not solved may have H < 0 */
    return (slid){larger(drag, all(0)),
                  larger(face_sliding(H, G) * phi_at(f, h, g, i), all(1e-290))};
}

/* D P_X, or D */
static inline vec step_at(const double *x, size_t i)
{
    return load(x + i + 1) - load(x + i);
}

static void newtonian(const ovr_sheared *f, const ovr_fluid *fluid, double *t)
{
    double V = fluid->sliding;
    for (size_t k = 0; k < f->n - 1; k += VEC) {
        size_t i = start_of(k, f->n - 1);
        slid s = slid_at(f, fluid->by_gap, i);
        vec stress = (-V / 12) * s.drag / s.eps;
        store(t + i, choose(wet_at(f, i), stress, all(0)));
    }
}

static void eyring_stress(const ovr_sheared *f, const ovr_fluid *fluid,
                          double *t)
{
    const double ln2 = 0x1.62e42fefa39efp-1;
    double Sigma0 = fluid->lubricant.Sigma0, slide = ovr_flow_slide(fluid);
    double gradient = ovr_flow_gradient(fluid, 1);
    log_table ln;
    exp_table growth;
    double scale = fluid->sliding > 0 ? -Sigma0 : Sigma0;
    make_log_table(ln2 * scale, &ln);
    make_exp_table(1, &growth);
    for (size_t k = 0; k < f->n - 1; k += VEC) {
        size_t i = start_of(k, f->n - 1);
        vec g = gradient * pair_at(f->H, i) * step_at(f->P, i) /
                step_at(f->X, i);
        slid s = slid_at(f, fluid->by_gap, i);
        vec eps = larger(s.eps, all(1e-290));
        vec y = eyring_at(&growth, g).B * (slide * s.drag) / eps;
        store(t + i, choose(wet_at(f, i), arsinh(&ln, scale, y), all(0)));
    }
}

static void table_stress(const ovr_sheared *f, const ovr_fluid *fluid,
                         double *t)
{
    double Sigma0 = fluid->lubricant.Sigma0, slide = ovr_flow_slide(fluid);
    double gradient = ovr_flow_gradient(fluid, 1);
    double scale = fluid->sliding > 0 ? -Sigma0 : Sigma0;
    const double *table = fluid->lubricant.flow_law->stress;
    log_table log;
    exp_table growth;
    make_log_table(1, &log);
    make_exp_table(1, &growth);
    for (size_t k = 0; k < f->n - 1; k += VEC) {
        size_t i = start_of(k, f->n - 1);
        vec g = gradient * pair_at(f->H, i) * step_at(f->P, i) /
                step_at(f->X, i);
        slid s = slid_at(f, fluid->by_gap, i);
        vec eps = larger(s.eps, all(1e-290));
        vec s_N = smaller(slide * s.drag / eps, all(1e280));
        law_value v = law_at(table, s_N, g);
        vec a = s_N * law_power(&growth, &log, &v);
        store(t + i, choose(wet_at(f, i), scale * a, all(0)));
    }
}

/* t at half nodes 0..n-2; 0 where cavitated */
void OVR_KERNEL(mean_stress)(const ovr_sheared *f, const ovr_fluid *fluid,
                             double *t)
{
    if (fluid->lubricant.rheology == OVR_EYRING && fluid->sliding != 0)
        eyring_stress(f, fluid, t);
    else if (ovr_flow_is_shear_thinning(fluid) && fluid->sliding != 0)
        table_stress(f, fluid, t);
    else
        newtonian(f, fluid, t);
}

/* Limits |t| to limit P - |H P_X|/2. Returns the fraction of the load carried
 * where the limit is active. */
double OVR_KERNEL(limit_stress)(const ovr_sheared *f, double limit, double *t)
{
    vec load_all = all(0), load_cut = all(0);
    for (size_t k = 0; k < f->n - 1; k += VEC) {
        size_t i = start_of(k, f->n - 1);
        vec dX = step_at(f->X, i), P = pair_at(f->P, i), stress = load(t + i);
        vec slope = 0.25 * pair_at(f->H, i) * step_at(f->P, i) / dX;
        vec maximum = larger(all(0.5 * limit) * P - larger(slope, -slope),
                             all(0));
        ivec fresh = new_elements(k, f->n - 1);
        ivec cut = larger(stress, -stress) > maximum;
        P *= dX;
        load_all += choose(fresh, P, all(0));
        load_cut += choose(fresh & cut, P, all(0));
        /* elements of the overlap have been limited already and are not counted
         * again */
        store(t + i, smaller(larger(stress, -maximum), maximum));
    }
    double whole = sum_of_lanes(load_all);
    return whole > 0 ? sum_of_lanes(load_cut) / whole : 0;
}

ovr_friction OVR_KERNEL(friction)(const ovr_sheared *f, const double *t)
{
    vec slide = all(0), roll = all(0), poiseuille = all(0);
    for (size_t k = 0; k < f->n - 1; k += VEC) {
        size_t i = start_of(k, f->n - 1);
        ivec counts = wet_at(f, i) & new_elements(k, f->n - 1);
        vec dX = step_at(f->X, i), H = pair_at(f->H, i);
        vec dP = choose(counts, step_at(f->P, i), all(0));
        vec flow = H * (f->flow ? load(f->flow + i) : pair_at(f->eps, i));
        slide = fused(choose(counts, load(t + i), all(0)), dX, slide);
        roll = fused(H, dP, roll);
        poiseuille += flow * dP * dP / (dX * pair_at(f->q, i));
    }
    return (ovr_friction){sum_of_lanes(slide), 0.25 * sum_of_lanes(roll),
                          0.5 * sum_of_lanes(poiseuille)};
}
