/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Mixed lubrication by the mean film: P = P_f + A(H), where A is the asperity
 * pressure at the mean gap H. It is carried by boundary layers and by roughness
 * that is not on the grid (multigrid/mixed_contact.h). The choice of model is
 * in keys.c.
 *
 * On the contact area fraction phi the boundary shear stress replaces the
 * film's shear stress:
 *
 *     t = (1 - phi) t_film - sgn(V) mu_b A/kappa
 *
 * The power mu_b A |V|/kappa heats the film of its node, together with the
 * power (1 - phi) t_film V and the dissipation of the Poiseuille flow. Flash
 * temperatures of single asperities are not included. Without sliding, boundary
 * friction is zero.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "multigrid/friction.h"
#include "multigrid/mixed_contact.h"
#include "physics/mixed/mixed.h"
#include "physics/mixed/nested.h"
#include "physics/mixed/wear.h"
#include "simulation/conflicts.h"
#include "simulation/mirror.h"
#include "simulation/observe.h"
#include "simulation/quantity_row.h"
#include "simulation/steady.h"

typedef struct boundary {
    const ovr_boundary_form *given;
    double *A; /* asperity pressure at the nodes when last observed */
    double *saved, *bears; /* a film that can be restored */
    double wet_force;      /* boundary friction force at pressurized nodes */
    const ovr_asperity_law *law; /* present asperity contact model */
    ovr_wear *wear;              /* NULL: none */
} boundary;

/* --------------------------------------------------------------- simulation */

static ovr_status create(ovr_simulation *sim, const void *form, void **own,
                         ovr_error *err)
{
    boundary *b = ovr_arena_take(&sim->arena, 1, sizeof *b, err);
    if (!b)
        return OVR_NO_MEMORY;
    *own = b;
    if (OVR_TAKE_NODES(sim, err, &b->A, &b->saved, &b->bears,
                       &sim->shear.film_stress) ||
        ovr_physics_take_asperity_pressure(sim, err) ||
        ovr_hierarchy_take_asperities(&sim->grids, &sim->arena, err) ||
        ovr_hierarchy_take_coarse_asperities(&sim->grids, OVR_NESTED_DEPTH,
                                             &sim->arena, err))
        return OVR_NO_MEMORY;
    b->given = form;
    if (b->given->ridges)
        sim->grids.fluid.factor = &b->given->factor;
    sim->target.fluid.factor = sim->grids.fluid.factor;
    b->law = &b->given->bears;
    if (b->given->passes > 0) {
        b->wear = ovr_arena_take(&sim->arena, 1, sizeof *b->wear, err);
        if (!b->wear ||
            ovr_wear_take(b->wear, b->given, &sim->contact, &sim->arena, err))
            return OVR_NO_MEMORY;
        b->law = &b->wear->bears;
    }
    sim->grids.touch.at = ovr_asperity_law_at;
    sim->grids.touch.law = b->law;
    sim->grids.touch.share = 1;
    return OVR_OK;
}

static void forget(ovr_simulation *sim, void *own)
{
    boundary *b = own;
    memset(b->A, 0, sim->now.n * sizeof *b->A);
    sim->grids.touch.share = 0;
    if (b->wear)
        ovr_wear_begin(b->wear);
}

/* Restores the saved film, for a fraction of the asperity pressure. */
static void restore(ovr_simulation *sim, const boundary *b, double H0,
                    double share)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_level *finest = sim->finest;
    grids->H0 = H0;
    grids->touch.share = share;
    ovr_asperity_settle(grids);
    ovr_level_write(grids, finest, b->saved, finest->f.P);
    ovr_level_write(grids, finest, b->bears, finest->asperity_P);
    ovr_level_refresh(grids, finest);
}

/* Solves for a fraction of the asperity pressure; restores the previous film if
 * there is no solution. */
static bool reach(ovr_simulation *sim, boundary *b, double share,
                  const ovr_full *how, ovr_defect *d, int *cycles)
{
    const double enough = 1e-4;
    ovr_hierarchy *grids = &sim->grids;
    ovr_level *finest = sim->finest;
    ovr_defect was = *d;
    ovr_asperity_settle(grids);
    double H0 = grids->H0, old = grids->touch.share;
    ovr_level_read(grids, finest, finest->f.P, b->saved);
    ovr_level_read(grids, finest, finest->asperity_P, b->bears);
    grids->touch.share = share;
    *d = ovr_steady_cycles(sim, how, cycles);
    if (ovr_below(*d, enough))
        return true;
    *d = was;
    restore(sim, b, H0, old);
    return false;
}

/* Solves by nested iteration after a failure; restores the film that `reach`
 * saved if there is no solution. */
static bool solve_coarser(ovr_simulation *sim, boundary *b, const ovr_full *how,
                          ovr_defect *d, int *cycles)
{
    const ovr_defect was = *d;
    double H0 = sim->grids.H0, share = sim->grids.touch.share;
    if (ovr_mixed_nested(sim, b->law, false, how, d, cycles))
        return true;
    *d = was;
    restore(sim, b, H0, share);
    return false;
}

/* Solves the full film without asperity contact: by full multigrid, or by
 * Newton's method on the finest level only, starting from the Hertzian
 * pressure. */
static ovr_defect solve_apart(ovr_simulation *sim, boundary *b, bool by_levels,
                              const ovr_full *how, int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_full on_finest = *how;
    ovr_defect d;
    on_finest.cycling.bottom = grids->finest;
    grids->touch.share = 0;
    ovr_asperity_settle(grids);
    memset(b->A, 0, sim->now.n * sizeof *b->A);
    if (by_levels)
        grids->touch.at = NULL;
    ovr_level_set_asperity_pressure(grids, sim->finest, b->A);
    d = ovr_steady_film(sim, by_levels ? how : &on_finest, cycles);
    grids->touch.at = ovr_asperity_law_at;
    sim->start.refinements = 0; /* refinements of another film */
    return d;
}

/* Above this predicted asperity load share, the full film is not a useful
 * initial guess. */
static const double mostly_dry = 0.9;

static bool is_mostly_dry(const boundary *b)
{
    return b->given->estimate > mostly_dry && !b->given->unresolved;
}

/* Starts with the full film, and applies the asperity contact model at once, or
 * else on coarser levels first, or else in fractions. */
static ovr_defect solve_from(ovr_simulation *sim, boundary *b, bool by_levels,
                             const ovr_full *how, int *cycles)
{
    const double begins = 1e-8, smallest = 1.05, found = 1e-2;
    double factor = 1 / begins, from = begins;
    ovr_defect d;
    ovr_simulation_gap(sim, 0);
    d = solve_apart(sim, b, by_levels, how, cycles);
    if (by_levels && !ovr_below(d, found))
        from = 1;
    while (from < 1 && factor > smallest) {
        double to = fmin(from * factor, 1);
        if (reach(sim, b, to, how, &d, cycles))
            from = to;
        else if (by_levels && to == 1 && !is_mostly_dry(b) &&
                 solve_coarser(sim, b, how, &d, cycles))
            from = 1;
        else
            factor = sqrt(factor);
    }
    if (sim->grids.touch.share < 1)
        d.imbalance = INFINITY;
    return d;
}

static ovr_defect solve(ovr_simulation *sim, void *own, const ovr_full *how,
                        int *cycles)
{
    const boundary *b = own;
    ovr_defect d = {.imbalance = INFINITY};
    if (is_mostly_dry(b)) {
        if (ovr_mixed_from_dry(sim, b->law, how, &d, cycles) ||
            ovr_mixed_nested(sim, b->law, true, how, &d, cycles))
            return d;
    }
    d = solve_from(sim, own, true, how, cycles);
    if (d.imbalance == INFINITY)
        d = solve_from(sim, own, false, how, cycles);
    return d;
}

/* Each attempt starts with the asperity pressure of the last completed time, in
 * the present orientation of the grids. */
static void attempt(ovr_simulation *sim, void *own, bool corrected)
{
    (void)own;
    (void)corrected;
    ovr_asperity_settle(&sim->grids);
    ovr_physics_restore_asperity_pressure(sim);
}

/* ---------------------------------------------------------------- running-in
 */

static void read_asperity_P(ovr_simulation *sim, boundary *b)
{
    ovr_nodes_read(sim, sim->finest, sim->finest->asperity_P, b->A);
}

static void record_film(ovr_simulation *sim, boundary *b)
{
    double asperity_load = 0;
    read_asperity_P(sim, b);
    for (size_t i = 0; i < sim->now.n; i++)
        asperity_load += sim->now.weights[i] * b->A[i];
    ovr_wear_see(b->wear, sim->now.n, b->A, sim->now.weights,
                 asperity_load / OVR_NOMINAL_LOAD);
}

static void begin(ovr_simulation *sim, void *own)
{
    boundary *b = own;
    if (b->wear)
        record_film(sim, b);
}

static void before_step(ovr_simulation *sim, void *own, double T)
{
    boundary *b = own;
    if (b->wear)
        ovr_wear_step(b->wear, (T - sim->past.T[0]) / OVR_WEAR_STEP);
}

static void accepted(ovr_simulation *sim, void *own, double dT)
{
    boundary *b = own;
    (void)dT;
    if (!b->wear)
        return;
    ovr_wear_taken(b->wear);
    record_film(sim, b);
}

static bool over(const ovr_simulation *sim, const void *own)
{
    const boundary *b = own;
    (void)sim;
    return b->wear && ovr_wear_over(b->wear);
}

static void before_back(ovr_simulation *sim, void *own)
{
    boundary *b = own;
    ovr_asperity_settle(&sim->grids);
    if (b->wear)
        ovr_wear_back(b->wear);
}

static void visit(ovr_simulation *sim, void *own, ovr_pieces *state)
{
    boundary *b = own;
    (void)sim;
    if (b->wear)
        ovr_wear_visit(b->wear, state);
}

static void restored(ovr_simulation *sim, void *own)
{
    boundary *b = own;
    (void)sim;
    if (!b->wear)
        return;
    b->wear->now.passes = NAN; /* the state has changed */
    ovr_wear_back(b->wear);
}

const ovr_wear *ovr_wear_of(const ovr_simulation *sim)
{
    OVR_EACH_PHYSICS(sim, p, in_step, visit)
        if (p->is->bit == OVR_PHYSICS_BOUNDARY)
            return ((const boundary *)p->own)->wear;
    return NULL;
}

/* ----------------------------------------------------- observed quantities */

/* Boundary friction -sgn(V) mu_b A/kappa at half node i + 1/2. */
static double drag_at(const ovr_simulation *sim, const boundary *b, size_t i)
{
    double pressure = 0.5 * (b->A[i] + b->A[i + 1]), mu = b->given->friction;
    if (isnan(mu) || !(pressure > 0))
        return 0;
    double V = ovr_sliding(sim, sim->state.T);
    double side = V > 0 ? -1 : V < 0 ? 1 : 0;
    return side * mu * pressure / sim->contact.kappa;
}

/* True if the asperity pressure is negligible even at the minimum film
 * thickness. */
static bool has_no_asperity_contact(const ovr_simulation *sim,
                                    const boundary *b)
{
    const double nothing = 1e-17, *H = sim->now.H;
    double A, slope;
    size_t low = sim->grids.kernels->extreme(sim->now.n, 1, H);
    ovr_asperity_law_at(b->law, H[low], &A, &slope);
    return A < nothing && ovr_asperity_law_area(b->law, H[low]) < nothing;
}

static void friction(ovr_simulation *sim, void *own, double *t)
{
    boundary *b = own;
    const double *P = sim->now.P, *X = sim->now.X;
    b->wet_force = 0;
    if (has_no_asperity_contact(sim, b))
        return;
    read_asperity_P(sim, b);
    for (size_t i = 0; i + 1 < sim->now.n; i++) {
        double drag = drag_at(sim, b, i);
        double H = 0.5 * (sim->now.H[i] + sim->now.H[i + 1]);
        t[i] = (1 - ovr_asperity_law_area(b->law, H)) * t[i] + drag;
        if (P[i] > 0 || P[i + 1] > 0)
            b->wet_force += drag * (X[i + 1] - X[i]);
    }
}

static void heat(ovr_simulation *sim, void *own, double *apart, double *power)
{
    boundary *b = own;
    double V = fabs(ovr_sliding(sim, sim->state.T)), mu = b->given->friction;
    if (V == 0 || has_no_asperity_contact(sim, b))
        return;
    for (size_t i = 0; i < sim->now.n; i++)
        apart[i] *= 1 - ovr_asperity_law_area(b->law, sim->now.H[i]);
    if (isnan(mu))
        return;
    read_asperity_P(sim, b);
    for (size_t i = 0; i < sim->now.n; i++)
        power[i] += mu * b->A[i] * V / sim->contact.kappa;
}

enum {
    SHARE,
    AREA,
    A_MAX,
    H_CONTACT,
    MU_FILM,
    MU_BOUNDARY,
    LAMBDA,
    ESTIMATE,
    PASSES,
    WEAR_1,
    WEAR_2,
    PEAKS_1,
    PEAKS_2,
    VALLEYS_1,
    VALLEYS_2
};

#define TOUCH(name, key, si, kind, place, ...)                                 \
    OVR_NUMBER_ROW(name, key, si, kind, more[place], OVR_PHYSICS_BOUNDARY,     \
                   __VA_ARGS__)

/* A quantity of a surface that wear changes. */
#define WORN(name, place, text, definition)                                    \
    OVR_NUMBER_ROW(name, name, name "_m", HEIGHT, more[place],                 \
                   OVR_PHYSICS_WEAR, text, COMMENT(definition), LABEL(text))

static const ovr_observable quantities[] = {
    TOUCH("contact_share", "contact_share", NULL, NUMBER, SHARE,
          "asperity load share", LABEL("asperity load share"),
          LARGEST("contact_share_max"), EXTREME_REPORTED,
          MEAN("contact_share_mean"), PASS(MEAN)),
    TOUCH("contact_area", "contact_area", "contact_area_m", LENGTH, AREA,
          "real contact length", COMMENT("along x, summed over the asperities"),
          LABEL("real contact length")),
    TOUCH("max_contact_pressure", "A_max", "max_contact_pressure_Pa", PRESSURE,
          A_MAX, "maximum asperity pressure",
          LABEL("maximum asperity pressure"), LARGEST("A_max_overall"),
          EXTREME_REPORTED),
    TOUCH("contact_film", "H_contact", "contact_film_m", HEIGHT, H_CONTACT,
          "minimum gap in asperity contact",
          LABEL("minimum gap in asperity contact")),
    TOUCH("mu_film", "mu_film", NULL, NUMBER, MU_FILM,
          "fluid friction coefficient", LABEL("fluid friction coefficient"),
          MEAN("mu_film_mean")),
    TOUCH("mu_boundary", "mu_boundary", NULL, NUMBER, MU_BOUNDARY,
          "boundary friction coefficient",
          LABEL("boundary friction coefficient"), MEAN("mu_boundary_mean")),
    TOUCH("contact_lambda", "contact_lambda", NULL, NUMBER, LAMBDA,
          "lambda ratio (mean gap)",
          COMMENT("central mean gap divided by the composite Rq"),
          LABEL("lambda ratio (mean gap)"), NOTE("central mean gap / Rq"),
          MEAN("contact_lambda_mean")),
    TOUCH("contact_share_estimate", "contact_share_estimate", NULL, NUMBER,
          ESTIMATE, "predicted asperity load share",
          COMMENT("by the film thickness formula of smooth surfaces"),
          LABEL("predicted asperity load share")),
    OVR_NUMBER_ROW("passes", "passes", NULL, NUMBER, more[PASSES],
                   OVR_PHYSICS_WEAR, "number of passes",
                   LABEL("number of passes")),
    WORN("wear_1", WEAR_1, "mean wear depth of surface 1",
         "mean over the profile"),
    WORN("wear_2", WEAR_2, "mean wear depth of surface 2",
         "mean over the profile"),
    WORN("Rpk_1", PEAKS_1, "reduced peak height Rpk of surface 1",
         "of the worn profile"),
    WORN("Rpk_2", PEAKS_2, "reduced peak height Rpk of surface 2",
         "of the worn profile"),
    WORN("Rvk_1", VALLEYS_1, "reduced valley depth Rvk of surface 1",
         "of the worn profile"),
    WORN("Rvk_2", VALLEYS_2, "reduced valley depth Rvk of surface 2",
         "of the worn profile")};

/* Observes both friction forces; the film's integral must already contain those
 * at pressurized nodes. */
static void observe_friction(const ovr_simulation *sim, const boundary *b,
                             ovr_observation *o)
{
    const double *X = sim->now.X;
    double load = OVR_NOMINAL_LOAD * o->load_ratio, drag = 0;
    double coefficient = load > 0 ? sim->contact.kappa / load : NAN;
    for (size_t i = 0; i + 1 < sim->now.n && o->more[A_MAX] > 0; i++)
        drag += drag_at(sim, b, i) * (X[i + 1] - X[i]);
    double film = ovr_sliding_force(o->F_slide - b->wet_force, o->F_roll);
    o->more[MU_FILM] = coefficient * fabs(film);
    o->more[MU_BOUNDARY] = coefficient * fabs(drag);
    o->F_slide += drag - b->wet_force;
    o->power_dissipated -= o->sliding * (drag - b->wet_force);
    ovr_friction_forces(sim, o);
    if (isnan(b->given->friction)) {
        o->more[MU_BOUNDARY] = o->mu_1 = o->mu_2 = o->mu_slide = NAN;
        o->F_1 = o->F_2 = o->F_slide = NAN;
        o->power_in = o->power_dissipated = NAN;
    }
}

static void observe_wear(const boundary *b, ovr_observation *o)
{
    for (int k = PASSES; k <= VALLEYS_2; k++)
        o->more[k] = NAN;
    if (!b->wear)
        return;
    o->more[PASSES] = b->wear->now.passes;
    for (int k = 0; k < 2; k++) {
        o->more[WEAR_1 + k] = b->wear->now.depth[k];
        ovr_core core = ovr_wear_core(b->wear, k, false);
        o->more[PEAKS_1 + k] = core.pk;
        o->more[VALLEYS_1 + k] = core.vk;
    }
}

static void observe(ovr_simulation *sim, void *own, ovr_observation *o)
{
    const double touches = 1e-3;
    boundary *b = own;
    double asperity_load = 0, area = 0, maximum = 0, minimum = NAN;
    size_t n = has_no_asperity_contact(sim, b) ? 0 : sim->now.n;
    read_asperity_P(sim, b);
    for (size_t i = 0; i < n; i++) {
        double w = sim->now.weights[i], A = b->A[i];
        asperity_load += w * A;
        area += w * ovr_asperity_law_area(b->law, sim->now.H[i]);
        maximum = fmax(maximum, A);
        if (A > touches)
            minimum = fmin(minimum, sim->now.H[i]);
    }
    o->more[SHARE] = o->load > 0 ? asperity_load / o->load : NAN;
    o->more[AREA] = area;
    o->more[A_MAX] = maximum;
    o->more[H_CONTACT] = minimum;
    observe_wear(b, o);
    o->more[ESTIMATE] = b->given->estimate;
    o->more[LAMBDA] = b->given->factor.sigma > 0
                          ? o->H_cen / b->given->factor.sigma
                          : NAN;
    observe_friction(sim, b, o);
}

/* Reports both quantities, before and after. */
static void review_wear(const ovr_simulation *sim, const ovr_wear *wear,
                        ovr_physics_message *say, void *data)
{
    const double nm = sim->contact.height * 1e9;
    char text[240];
    for (int k = 0; k < 2; k++) {
        ovr_core was = ovr_wear_core(wear, k, true);
        ovr_core is = ovr_wear_core(wear, k, false);
        if (isnan(is.pk))
            continue;
        snprintf(text, sizeof text,
                 "surface %d: Rpk %.3g nm, Rk %.3g nm, Rvk %.3g nm before; "
                 "%.3g, %.3g, %.3g nm after %.3g passes",
                 k + 1, nm * was.pk, nm * was.k, nm * was.vk, nm * is.pk,
                 nm * is.k, nm * is.vk, wear->now.passes);
        say(data, false, text);
    }
    if (wear->lost)
        say(data, true,
            "the contact model of the worn profiles could not be computed in "
            "some jumps; the previous model was used there");
    if (!ovr_wear_over(wear)) {
        snprintf(text, sizeof text,
                 "only %.3g of %.3g passes were computed; set a longer "
                 "boundary.jump",
                 wear->now.passes, wear->given->passes);
        say(data, true, text);
    }
}

/*
 * A weak law (less than the Hertzian pressure at zero film thickness) is
 * exhausted if the pressure at the minimum film thickness exceeds half of that
 * at zero. Then A(H) does not increase enough with the load: the fluid carries
 * the remaining load on a film that asperities should keep open, and the
 * asperity load share in a Stribeck curve ends in a plateau that is determined
 * by the model's constants.
 */
static bool is_exhausted(const ovr_simulation *sim, const void *own)
{
    const double used_up = 0.5;
    const boundary *b = own;
    double A, slope, load = sim->observation.load_ratio;
    size_t low = sim->grids.kernels->extreme(sim->now.n, 1, sim->now.H);
    if (!ovr_boundary_is_weak(b->given, load))
        return false;
    ovr_asperity_law_at(b->law, sim->now.H[low], &A, &slope);
    return A > used_up * b->given->at_no_film;
}

static bool marks(ovr_simulation *sim, void *own)
{
    return is_exhausted(sim, own);
}

static ovr_status refuse(const ovr_simulation *sim, const void *own,
                         ovr_error *err)
{
    const boundary *b = own;
    if (!is_exhausted(sim, own))
        return OVR_OK;
    return ovr_fail(
        err, OVR_IMPOSSIBLE,
        "asperity load share and friction would be wrong, because the "
        "asperity law is exhausted: at the minimum film "
        "thickness H = %.3g its pressure exceeds half of its "
        "maximum, %.3g p_h, which is less than the contact "
        "pressure. Set boundary.law = exponential with Rq and "
        "slope, or constants that carry p_h at zero film "
        "thickness",
        sim->observation.H_min, b->given->at_no_film);
}

static void review(const ovr_simulation *sim, const void *own,
                   ovr_physics_message *say, void *data)
{
    const double enough = 1e-5;
    const boundary *b = own;
    const ovr_solution *now = &sim->now;
    double A, slope;
    char text[160];
    ovr_asperity_law_at(b->law, now->H[now->n - 1], &A, &slope);
    if (A > enough) {
        snprintf(text, sizeof text,
                 "asperities are in contact at the outlet boundary (%.2g "
                 "p_h); set domain.outlet further downstream",
                 A);
        say(data, true, text);
    }
    if (sim->observation.more[SHARE] > 0.01 && isnan(b->given->friction))
        say(data, false,
            "the friction coefficient is unknown, because asperities are in "
            "contact; set boundary.friction");
    if (sim->state.step > 0 && is_exhausted(sim, b))
        say(data, true,
            "asperity load share and friction are wrong in steps flagged as "
            "not "
            "converged, because the asperity law is exhausted at the end of "
            "the run; set boundary.law = exponential with Rq and slope");
    if (b->wear && sim->state.step > 0)
        review_wear(sim, b->wear, say, data);
}

static void effects(const void *form, ovr_physics_effects *effects)
{
    const ovr_boundary_form *f = form;
    bool wears = f->passes > 0;
    effects->bits = wears ? OVR_PHYSICS_WEAR : 0;
    effects->features = ovr_model_feature_bit(OVR_MODEL_BOUNDARY, true) |
                        ovr_model_feature_bit(OVR_MODEL_MEAN_FILM,
                                              !f->unresolved) |
                        ovr_model_feature_bit(OVR_MODEL_WEAR, wears);
    effects->fields = "contact_pressure, fluid_pressure";
}

/* Running-in uses long steps in a separate time variable (wear.h). */
static bool march_for(const void *form, ovr_march *march, int *scheme)
{
    const ovr_boundary_form *f = form;
    if (f->law != OVR_BOUNDARY_PROFILE || !(f->passes > 0))
        return false;
    march->end = OVR_WEAR_STEP * OVR_WEAR_MAX;
    march->dT = OVR_WEAR_STEP;
    if (*scheme < 0)
        *scheme = OVR_UPSTREAM2;
    return true;
}

static void advise(const ovr_simulation *sim, double H, size_t size, char *text)
{
    if (sim->grids.touch.at && sim->shapes.heights)
        ovr_boundary_instead(sim->grids.touch.law, H, sim->now.n, sim->now.X,
                             sim->shapes.S, size, text);
}

static const ovr_physics_in_case in_case = {.node_seconds = 7e-7,
                                            .section = &ovr_boundary_section,
                                            .sections = 1,
                                            .form = sizeof(ovr_boundary_form),
                                            .resolve = ovr_boundary_resolve,
                                            .on_mesh = ovr_boundary_on_mesh,
                                            .effects = effects,
                                            .march = march_for,
                                            .keeps = ovr_boundary_keeps,
                                            .describe = ovr_boundary_describe};

static const ovr_physics_in_solve in_solve = {.take = create,
                                              .forget = forget,
                                              .solve = solve,
                                              .begin = begin,
                                              .refuse = refuse};

static const ovr_physics_in_step in_step = {.attempt = attempt,
                                            .advise = advise,
                                            .before_step = before_step,
                                            .accepted = accepted,
                                            .over = over,
                                            .before_back = before_back,
                                            .visit = visit,
                                            .restored = restored};

static const ovr_physics_in_output in_output = {
    .companion = &ovr_wear_companion,
    .friction = friction,
    .heat = heat,
    .observe = observe,
    .marks = marks,
    OVR_QUANTITIES(quantities),
    .review = review};

const ovr_physics ovr_physics_boundary = {.name = "surfaces that touch",
                                          .bit = OVR_PHYSICS_BOUNDARY,
                                          .in_case = &in_case,
                                          .in_solve = &in_solve,
                                          .in_step = &in_step,
                                          .in_output = &in_output};
