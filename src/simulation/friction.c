/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Friction forces (ph b^2/R) and powers (um ph b^2/R), u1, u2 = Cu +- V/2.
 * F_slide and F_roll in the domain: multigrid/friction.h.
 *
 * Shear stress and pressure on the slopes of features act on the surfaces:
 *
 *     F_1 = F_slide - F_roll + G_1,   F_2 = -F_slide - F_roll + G_2
 *     G_k = int P dS_k/dX dX,  P the pressure on the solids, S_k outward
 *     mu_k = kappa F_k/int P dX,  kappa = b/R
 *     put in      -(F_1 u1 + F_2 u2) = -V F_slide + 2 Cu F_roll - sum u_k G_k
 *     dissipated  -V F_slide + int (Cu H - Q) P_X dX,  Q the volume flow
 *
 * Curvature has no G, since pressure on a cylinder acts through its axis.
 * Elastic deformation w has none: int P dw/dX = 0, as the influence of a
 * pressure is symmetric.  overroll-theory(7) derives the balance of both
 * powers.
 *
 * Upstream of the inlet X_a of a flooded contact, viscosity and density have
 * their values at P = 0:
 *
 *     P_X = (Cu H - M)/E,  M the mass flow,
 *     E = H^3/lambda or that of the rheological model
 *     H(X) = H(X_a) + h(X) - h(X_a),  h the gap outside a dry contact,
 *     h = Cw (x sqrt(x^2 - 1) - arcosh x)/2,  x = |X|/s, s = sqrt(Cw/c)
 *     dissipated there  int (Cu H - M) P_X dX = 2 Cu times its part of F_roll
 *
 * The part of F_roll is int H P_X/2 minus M P(X_a)/(2 Cu).  The second term
 * corrects the domain, whose pressure starts at 0 instead of P(X_a).  Gauss
 * quadrature in X_a/X with 8 points has an error of 1e-6.  The film in the
 * domain is also too thin: ovr_inlet_rolling_loss.
 */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/starvation.h"
#include "multigrid/flow.h"
#include "simulation/observe.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"

double ovr_sliding(const ovr_simulation *sim, double T)
{
    return ovr_slip_at(&sim->contact, sim->histories.speed,
                       sim->histories.sliding, T);
}

void ovr_simulation_sliding(ovr_simulation *sim, const ovr_history *sliding)
{
    if (!sim)
        return;
    sim->histories.sliding = sliding;
}

/* dS/dX at an inner node: fourth order if the nodes are equidistant. */
static double slope_at(const ovr_solution *now, const double *S, size_t i)
{
    const double even = 1e-6, *X = now->X;
    double left = X[i] - X[i - 1], right = X[i + 1] - X[i];
    bool inside = i > 1 && i + 2 < now->n;
    if (inside && fabs(X[i + 2] - X[i - 2] - 4 * left) < even * left &&
        fabs(right - left) < even * left)
        return (8 * (S[i + 1] - S[i - 1]) - (S[i + 2] - S[i - 2])) /
               (12 * left);
    return ((S[i + 1] - S[i]) * left / right +
            (S[i] - S[i - 1]) * right / left) /
           (left + right);
}

/* int P S_X dX */
static double slope_force(const ovr_solution *now, const double *P,
                          const double *S)
{
    double sum = 0;
    for (size_t i = 1; i + 1 < now->n; i++)
        if (P[i] > 0)
            sum += now->weights[i] * P[i] * slope_at(now, S, i);
    return sum;
}

static void observe_slopes(ovr_simulation *sim, ovr_observation *o)
{
    double *G[2] = {&o->F_slope_1, &o->F_slope_2};
    if (!ovr_has_heights(sim))
        return;
    double *S = ovr_work_take(sim), *solid = ovr_work_take(sim);
    const double *P = ovr_solid_pressure(sim, solid);
    for (int k = 0; k < 2; k++)
        if (ovr_heights_of(sim, k + 1, S))
            *G[k] = slope_force(&sim->now, P, S);
    ovr_work_give(sim, solid);
    ovr_work_give(sim, S);
}

/* Parameters of the gap outside a dry contact of the load and curvature at T.
 */
typedef struct dry_gap {
    double load, s;
} dry_gap;

static double dry_gap_at(const dry_gap *gap, double X)
{
    double x = fmax(fabs(X) / gap->s, 1);
    return gap->load * (x * sqrt(x * x - 1) - acosh(x)) / 2;
}

/* P_X for film thickness H, where the flow `wedge` = Cu H - M at P = 0 is the
 * Poiseuille flow. */
static double gradient_at(const ovr_fluid *fluid, double H, double wedge)
{
    const double dX = 1;
    double eps = ovr_flow(fluid, 0, H), P_X = wedge / eps;
    ovr_pair nodes = {.H = {H, H}, .q = {H, H}, .eps = {eps, eps}};
    if (!ovr_flow_is_shear_thinning(fluid))
        return P_X;
    nodes.P[1] = P_X * dX;
    return wedge / ovr_flow_between(fluid, dX, &nodes);
}

/* Returns the power dissipated upstream of the inlet node `first` for mass flow
 * M. Divided by 2 Cu it is the contribution to F_roll. */
static double beyond_inlet(const ovr_simulation *sim, const ovr_fluid *fluid,
                           size_t first, double M)
{
    enum { POINTS = 4 };
    static const double point[POINTS] = {0.18343464249564980,
                                         0.52553240991632899,
                                         0.79666647741362674,
                                         0.96028985649753623},
                        weight[POINTS] = {
                            0.36268378337836198, 0.31370664587788729,
                            0.22238103445337447, 0.10122853629037626};
    double T = sim->state.T, Cu = ovr_history_value(sim->histories.speed, T);
    double Cw = ovr_history_value(sim->histories.load, T), sum = 0;
    dry_gap gap = {Cw, sqrt(Cw * ovr_history_value(sim->histories.radius, T))};
    double X_a = sim->now.X[first];
    double H = sim->now.H[first] - dry_gap_at(&gap, X_a);
    for (int k = 0; k < 2 * POINTS; k++) {
        double side = k < POINTS ? 1 : -1;
        double xi = (1 + side * point[k % POINTS]) / 2, X = X_a / xi;
        double film = H + dry_gap_at(&gap, X), wedge = Cu * film - M;
        sum += weight[k % POINTS] / 2 * wedge *
               gradient_at(fluid, film, wedge) * fabs(X_a) / (xi * xi);
    }
    return sum;
}

/* Returns the relative loss of rolling friction caused by the inlet, computed
 * only if load, speed or radius have changed. */
static double rolling_loss(ovr_simulation *sim, const ovr_instant *at,
                           double X_a)
{
    const double near = OVR_NEAREST_INLET;
    ovr_inlet_share *kept = &sim->shear.inlet_share;
    double X = fmin(-fabs(X_a) / at->s, near);
    if (kept->M != at->M || kept->L != at->L || kept->X != X)
        *kept = (ovr_inlet_share){at->M, at->L, X,
                                  ovr_inlet_rolling_loss(at->M, at->L, X), 0};
    return kept->loss;
}

/* Returns the rolling power missing in the domain, whose rolling friction is
 * F_roll. Returns 0 if the inlet is starved or the surfaces hardly move. */
static double inlet_power(ovr_simulation *sim, const ovr_fluid *fluid,
                          double Cu, double F_roll)
{
    const ovr_solution *now = &sim->now;
    size_t last = now->n - 1, first = sim->histories.backward ? last : 0;
    size_t half = sim->histories.backward ? last - 1 : 0;
    size_t inside = sim->histories.backward ? last - 1 : 1;
    double T = sim->state.T, Cw = ovr_history_value(sim->histories.load, T);
    if (!(now->P[inside] > 0) || sim->finest->closed ||
        !(Cw >= OVR_MIN_START) || !(fabs(Cu) >= OVR_MIN_START) ||
        (Cu < 0) != sim->histories.backward)
        return 0;
    double M = ovr_flux(sim, Cu, half), most = 0.5 * fabs(Cu) * now->H[first];
    double power = beyond_inlet(sim, fluid, first, fmax(-most, fmin(M, most)));
    ovr_instant at = ovr_instant_of(
        &sim->contact, Cw, fabs(Cu),
        1 / ovr_history_value(sim->histories.radius, T));
    return power +
           rolling_loss(sim, &at, now->X[first]) * (2 * Cu * F_roll + power);
}

/* Returns the power dissipated by flow other than Poiseuille flow, for example
 * the skewed flow of heat.c. */
static double dissipated_beside(const ovr_simulation *sim)
{
    const ovr_solution *now = &sim->now;
    OVR_LAST_PHYSICS(sim, beside, in_output, flow);
    double sum = 0;
    for (size_t i = 0; beside->is && i + 1 < now->n; i++)
        if (now->P[i] > 0 || now->P[i + 1] > 0)
            sum -= ovr_flow_of_physics(sim, i, true) *
                   (now->P[i + 1] - now->P[i]) * (now->H[i] + now->H[i + 1]) /
                   (now->q[i] + now->q[i + 1]);
    return sum;
}

double ovr_sliding_force(double force, double rolling)
{
    return fabs(force) <= 1e-12 * fabs(rolling) ? 0 : force;
}

void ovr_friction_forces(const ovr_simulation *sim, ovr_observation *o)
{
    double V = o->sliding, load = OVR_NOMINAL_LOAD * o->load_ratio;
    double coefficient = load > 0 ? sim->contact.kappa / load : NAN;
    o->F_slide = ovr_sliding_force(o->F_slide, o->F_roll);
    o->F_1 = o->F_slide - o->F_roll + o->F_slope_1;
    o->F_2 = -o->F_slide - o->F_roll + o->F_slope_2;
    o->mu_1 = coefficient * o->F_1;
    o->mu_2 = coefficient * o->F_2;
    o->mu_slide = coefficient * fabs(o->F_slide);
    if (o->F_slide != 0)
        o->mu_slide = copysign(coefficient * o->F_slide, V);
    o->mu_roll = coefficient * o->F_roll;
    o->power_in = 2 * o->speed_ratio * o->F_roll - V * o->F_slide -
                  (o->speed_ratio + V / 2) * o->F_slope_1 -
                  (o->speed_ratio - V / 2) * o->F_slope_2;
}

void ovr_observe_friction(ovr_simulation *sim, ovr_observation *o)
{
    const ovr_kernels *run = sim->grids.kernels;
    const ovr_solution *now = &sim->now;
    const ovr_sheared film = {now->n, now->X,   now->P,   now->H,
                              now->q, now->eps, now->flow};
    double V = ovr_sliding(sim, sim->state.T), Cu = o->speed_ratio;
    ovr_fluid fluid = sim->grids.fluid;
    OVR_LAST_PHYSICS(sim, own, in_output, stress);
    fluid.sliding = V;
    o->sliding = V;
    if (own->is)
        own->is->in_output->stress(sim, own->own, &film, &fluid,
                                   sim->shear.stress);
    else
        run->mean_stress(&film, &fluid, sim->shear.stress);
    if (sim->lubricant.limiting_shear > 0)
        o->limiting_share = run->limit_stress(
            &film, sim->lubricant.limiting_shear / sim->contact.kappa,
            sim->shear.stress);
    if (sim->shear.film_stress)
        memcpy(sim->shear.film_stress, sim->shear.stress,
               now->n * sizeof *sim->shear.film_stress);
    OVR_EACH_PHYSICS(sim, p, in_output, friction)
        p->is->in_output->friction(sim, p->own, sim->shear.stress);
    ovr_friction f = run->friction(&film, sim->shear.stress);
    double inlet = inlet_power(sim, &fluid, Cu, f.roll);
    sim->shear.inlet_share.power = inlet;
    observe_slopes(sim, o);
    o->F_slide = f.slide;
    o->F_roll = f.roll + (inlet != 0 ? inlet / (2 * Cu) : 0);
    o->power_dissipated = f.poiseuille + inlet + dissipated_beside(sim) -
                          V * f.slide;
    ovr_friction_forces(sim, o);
}

const double *ovr_film_stress(const ovr_simulation *sim)
{
    return sim->shear.film_stress ? sim->shear.film_stress : sim->shear.stress;
}

/* t -+ H P_X/2 */
const double *ovr_wall_stress(const ovr_simulation *sim, int surface,
                              double *workspace)
{
    const double *X = sim->now.X, *P = sim->now.P, *H = sim->now.H;
    double side = surface == 1 ? -0.25 : 0.25;
    for (size_t i = 0; i + 1 < sim->now.n; i++)
        workspace[i] = sim->shear.stress[i] + side * (H[i] + H[i + 1]) *
                                                  (P[i + 1] - P[i]) /
                                                  (X[i + 1] - X[i]);
    return workspace;
}
