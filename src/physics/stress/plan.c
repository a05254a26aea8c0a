/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plan of the stress histories of a case: depths, material, times. */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/history.h"
#include "physics/stress/stress.h"
#include "simulation/simulation.h"
#include "stress/layered.h"
#include "stress/stress.h"
#include "surface/surfaces.h"

/* --------------------------------------------------- Motion of the material */

/*
 * Distance moved by the material of a surface:
 *
 *     U_k = u_k/um int Cu dT;  with [sliding] V:  U_k = int (Cu +- V/2) dT
 *
 * integrated exactly, so that material is followed through speed changes, stops
 * and reversals.
 */

/* Number of times at which a motion is sampled. */
enum { LOOKS = 2000 };

double ovr_stress_distance(const ovr_setup *setup, const ovr_stress_plan *plan,
                           double T)
{
    return ovr_surface_distance(setup->speed, setup->sliding, plan->ratio,
                                plan->surface, T);
}

static double speed_of(const ovr_setup *setup, const ovr_stress_plan *plan,
                       double T)
{
    double Cu = ovr_history_value(setup->speed, T);
    if (!setup->sliding)
        return plan->ratio * Cu;
    return Cu + (plan->surface == 1 ? 0.5 : -0.5) *
                    ovr_history_value(setup->sliding, T);
}

/* Direction of motion; a surface at rest has that of slide_to_roll. */
static int direction_at(const ovr_setup *setup, const ovr_stress_plan *plan,
                        double T)
{
    double u = speed_of(setup, plan, T);
    return u < 0 || (u == 0 && plan->ratio < 0) ? -1 : 1;
}

/* True if the direction of motion can reverse. */
static bool stress_wanders(const ovr_setup *setup)
{
    return setup->sliding || ovr_history_reverses(setup->speed);
}

/* Direction of motion: 1, -1 or 0 for both. */
static int stress_direction(const ovr_setup *setup, const ovr_stress_plan *plan)
{
    bool forward = false, backward = false;
    if (!stress_wanders(setup))
        return plan->ratio < 0 ? -1 : 1;
    for (int k = 0; k <= LOOKS; k++) {
        double u = speed_of(setup, plan, setup->march->end * k / LOOKS);
        forward = forward || u > 0;
        backward = backward || u < 0;
    }
    return forward == backward ? 0 : forward ? 1 : -1;
}

/* Maximum speed of either surface or the film, relative to um. */
static double stress_fastest(const ovr_setup *setup)
{
    const ovr_contact *c = setup->contact;
    double fastest = fmax(1, fmax(fabs(c->u1_ratio), fabs(c->u2_ratio)));
    for (int k = 0; setup->sliding && k <= LOOKS; k++) {
        double T = setup->march->end * k / LOOKS;
        fastest = fmax(fastest,
                       fabs(ovr_history_value(setup->speed, T)) +
                           fabs(ovr_history_value(setup->sliding, T)) / 2);
    }
    return fastest;
}

/* Largest distance moved by the film or a surface. */
static double largest_distance(const ovr_setup *setup, double before, double T)
{
    double film = ovr_history_integral(setup->speed, T) -
                  ovr_history_integral(setup->speed, before);
    double half;
    if (!setup->sliding)
        return stress_fastest(setup) * fabs(film);
    half = (ovr_history_integral(setup->sliding, T) -
            ovr_history_integral(setup->sliding, before)) /
           2;
    return fabs(film) + fabs(half);
}

/* A feature that never reaches X = 0 is still moving at the end. */
static double struck_in_sliding(const ovr_setup *setup,
                                const ovr_stress_plan *plan, size_t feature)
{
    const ovr_options *o = setup->options;
    double end = setup->march->end;
    double T = ovr_surfaces_times(setup->surfaces, feature, o->inlet, o->outlet,
                                  end)
                   .centre;
    return -ovr_stress_distance(setup, plan, fmin(T, end));
}

/* X at T = 0 of the material under which the other surface's feature is at
 * X = 0. */
static double stress_struck(const ovr_setup *setup, const ovr_stress_plan *plan,
                            size_t feature)
{
    double speed = ovr_surfaces_info(setup->surfaces, feature).speed;
    double centre = ovr_surfaces_centre(setup->surfaces, feature, 0);
    double end = ovr_history_integral(setup->speed, setup->march->end);
    double distance = speed != 0 ? fmax(-centre / speed, 0) : end / 2;
    if (stress_wanders(setup))
        return struck_in_sliding(setup, plan, feature);
    return -plan->ratio * distance;
}

/* True if a feature is between 1 b upstream of the contact and its exit. */
static bool disturbed(const ovr_setup *setup, double T)
{
    const double inlet = -2, outlet = 1.25;
    size_t n = setup->surfaces ? ovr_surfaces_count(setup->surfaces) : 0;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
        double X = ovr_surfaces_centre(setup->surfaces, k, T);
        if (info.grows && T <= 0)
            continue;
        if (!isfinite(info.behind) || !isfinite(info.ahead) ||
            (X - info.behind < outlet && X + info.ahead > inlet))
            return true;
    }
    return false;
}

ovr_moment ovr_stress_moment(const ovr_setup *setup,
                             const ovr_stress_plan *plan, double T,
                             double before)
{
    return (ovr_moment){.T = T,
                        .U = ovr_stress_distance(setup, plan, T),
                        .dU = largest_distance(setup, before, T),
                        .direction = direction_at(setup, plan, T),
                        .disturbed = disturbed(setup, T)};
}

/* --------------------------------------------------------------------- Plan */

/* Minimum depth: in distances moved between two times (smaller depths are
 * partly missed), in mesh sizes, and in mesh sizes for the life. */
static const double DISTANCE_OF_DEPTH = 4, MESHES_OF_DEPTH = 4,
                    MESHES_OF_LIFE = 8;

static size_t features_of(const ovr_setup *setup)
{
    return setup->surfaces ? ovr_surfaces_count(setup->surfaces) : 0;
}

/* Sets xi = 0 at the first feature of the surface, of the other surface, or at
 * the material that is in the contact half-way through the run. */
static void find_material(const ovr_setup *setup, ovr_stress_plan *plan)
{
    double low = INFINITY, high = -INFINITY, end;
    bool own = false;
    end = ovr_history_integral(setup->speed, setup->march->end);
    plan->range.reference = stress_wanders(setup)
                                ? -ovr_stress_distance(setup, plan,
                                                       setup->march->end / 2)
                                : -plan->ratio * end / 2;
    for (size_t k = 0; k < features_of(setup); k++) {
        ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
        double centre = ovr_surfaces_centre(setup->surfaces, k, 0);
        bool local = isfinite(info.behind) && isfinite(info.ahead);
        bool mine = info.surface == plan->surface;
        if (own && !mine)
            continue;
        if (!mine)
            centre = stress_struck(setup, plan, k);
        if ((mine && !own) || !plan->feature) {
            plan->range.reference = centre;
            plan->feature = info.name;
            low = high = centre;
        }
        own = own || mine;
        low = fmin(low, centre - (local ? fmin(info.behind, 10) : 0));
        high = fmax(high, centre + (local ? fmin(info.ahead, 10) : 0));
    }
    if (!plan->feature)
        low = high = plan->range.reference;
    plan->range.from = low - plan->range.reference - 2;
    plan->range.to = high - plan->range.reference + 2;
    if (!isnan(ovr_setup_stress(setup)->from)) {
        plan->range.from = ovr_setup_stress(setup)->from;
        plan->range.to = ovr_setup_stress(setup)->to;
    }
}

/* Rejects more points than the stress history of the material can have. */
static ovr_status check_material(const ovr_stress_plan *plan, ovr_error *err)
{
    const ovr_material_range *m = &plan->range;
    double points = (m->to - m->from) / plan->options.mesh;
    if (points <= OVR_MATERIAL_POINTS_MAX)
        return OVR_OK;
    return ovr_fail_about(err, "window",
                          "a window of %g to %g b has %.2g points on this "
                          "grid, which is more than %.2g; set stress.window "
                          "= FROM, TO",
                          m->from, m->to, points,
                          (double)OVR_MATERIAL_POINTS_MAX);
}

/* Rounds to three digits, downwards. */
static double round_down(double value)
{
    double digit = pow(10, floor(log10(value)) - 2);
    return floor(value / digit * (1 + 1e-12)) * digit;
}

/* Returns an error: with these sample times, requested depths are missed. It
 * names the step of a run, or `every` if stored snapshots are used. */
static ovr_status refuse(const ovr_setup *setup, const char *key, double depth,
                         const ovr_stress_plan *plan, ovr_error *err)
{
    double dT = ovr_setup_step(setup);
    double distance = plan->coarsest,
           share = depth / DISTANCE_OF_DEPTH / distance;
    double target = floor(share * plan->every + 1e-9);
    if (target >= 1)
        return ovr_fail_about(
            err, key,
            "%s = %g: the stored times are %g b of travel apart and resolve "
            "depths from %.3g only; set every = %.0f",
            key, depth, distance, DISTANCE_OF_DEPTH * distance, target);
    return ovr_fail_about(
        err, "step",
        "step: %.3g b/u_m is %.3g b of travel, which resolves depths from "
        "%.3g b only, but %s.%s = %g; use a step of %.3g",
        dT, distance, DISTANCE_OF_DEPTH * distance,
        *key == 'l' ? "fatigue" : "stress", key, depth,
        round_down(share * dT * plan->every));
}

/* Minimum depth to which exponents and limits of the body apply: just below its
 * layers. */
static double below_layers(const ovr_stress_plan *plan)
{
    const ovr_layered *layers = plan->options.layers;
    return layers ? ovr_layered_bottom(layers, layers->layers - 1) *
                        (1 + OVR_BESIDE / 2)
                  : 0;
}

/* Rejects depths that the mesh cannot resolve. */
static ovr_status check_depths(const ovr_stress_setup *s,
                               const ovr_stress_plan *plan, ovr_error *err)
{
    double least = plan->options.depth_min, half = plan->options.mesh / 2;
    if (least < half * (1 - 1e-9))
        return ovr_fail_about(err, "depth_min",
                              "depth_min = %.4g b is less than half a mesh "
                              "size: must be at least %.4g b",
                              least, half);
    if (least > s->depth_max)
        return ovr_fail_about(err, "depth_max",
                              "depth_max = %.4g b is below the minimum depth, "
                              "%.4g b (%s); increase stress.depth_max or "
                              "use a finer domain.level",
                              s->depth_max, least,
                              s->depth_min > 0 ? "stress.depth_min"
                                               : "4 mesh sizes");
    return OVR_OK;
}

/* Default minimum depth: 4 mesh sizes or, if smaller, half the thickness of the
 * top layer, but at least D/2. */
static double usual_depth(const ovr_stress_plan *plan)
{
    const ovr_layered *layers = plan->options.layers;
    double D = plan->options.mesh, usual = MESHES_OF_DEPTH * D;
    return layers ? fmax(D / 2, fmin(usual, layers->thickness[0] / 2)) : usual;
}

static ovr_status find_depths(const ovr_setup *setup, ovr_stress_plan *plan,
                              ovr_error *err)
{
    const ovr_stress_setup *s = ovr_setup_stress(setup);
    double D = plan->options.mesh,
           possible = DISTANCE_OF_DEPTH * plan->coarsest;
    double allowed = possible * (1 - 1e-6);
    plan->options.depth_min = s->depth_min;
    if (s->depth_max < allowed)
        return refuse(setup, "depth_max", s->depth_max, plan, err);
    if (s->depth_min > 0 && s->depth_min < allowed)
        return refuse(setup, "depth_min", s->depth_min, plan, err);
    if (!(s->depth_min > 0))
        plan->options.depth_min = fmax(usual_depth(plan), possible);
    plan->range.least_depth = s->life.least_depth;
    if (s->life.least_depth > 0 && s->life.least_depth < allowed)
        return refuse(setup, "least_depth", s->life.least_depth, plan, err);
    if (!(s->life.least_depth > 0))
        plan->range.least_depth = fmax(fmax(MESHES_OF_LIFE * D, possible),
                                       plan->options.depth_min);
    plan->range.least_depth = fmax(plan->range.least_depth, below_layers(plan));
    return check_depths(s, plan, err);
}

/* Adds depths, moduli and residual stresses of the layers on the surface. */
static void add_layers(const ovr_setup *setup, ovr_stress_plan *plan)
{
    const ovr_coated *coated = ovr_setup_layers(setup, plan->surface - 1);
    if (!coated)
        return;
    plan->options.layers = &coated->body;
    plan->range.layer_residual = coated->residual;
}

static ovr_status make_plan(const ovr_setup *setup, int surface,
                            ovr_stress_sight seen, ovr_stress_plan *plan,
                            ovr_error *err)
{
    const ovr_stress_setup *s = ovr_setup_stress(setup);
    const ovr_contact *c = setup->contact;
    double dT = ovr_setup_step(setup);
    bool dang_van = s->fatigue && s->criterion == OVR_CRITERION_DANG_VAN;
    if (dang_van && !setup->transient)
        return ovr_fail_about(err, "criterion",
                              "criterion = dang-van needs a run in time; set "
                              "time.end");
    *plan = (ovr_stress_plan){.surface = surface};
    plan->ratio = surface == 1 ? c->u1_ratio : c->u2_ratio;
    plan->options = ovr_stress_options_default();
    plan->range = ovr_material_range_default();
    plan->options.mesh = seen.mesh;
    plan->options.inlet = seen.inlet;
    plan->every = seen.every;
    plan->options.nodes = seen.nodes;
    plan->options.depth_max = s->depth_max;
    plan->options.per_octave = s->per_octave;
    plan->options.traction = s->traction;
    add_layers(setup, plan);
    plan->traction = surface == 1 ? c->kappa : -c->kappa;
    plan->no_traction = s->no_traction;
    plan->range.poisson = s->poisson[surface - 1];
    plan->range.residual_x = s->residual_x;
    plan->range.residual_y = s->residual_y;
    plan->range.residuals = s->residuals;
    plan->range.residual_z = s->residual_z;
    plan->range.residual_s = s->residual_s;
    plan->range.yield = s->yield[surface - 1];
    if (dang_van && (double)setup->output->every > plan->every)
        /* paths are computed from stored snapshots */
        plan->every = (double)setup->output->every;
    plan->coarsest = setup->transient ? stress_fastest(setup) * dT * plan->every
                                      : 0;
    plan->direction = stress_direction(setup, plan);
    find_material(setup, plan);
    ovr_status status = check_material(plan, err);
    return status ? status : find_depths(setup, plan, err);
}

ovr_stress_sight ovr_stress_sight_of(const ovr_setup *setup)
{
    return (ovr_stress_sight){setup->options->inlet, setup->mesh, setup->nodes,
                              1};
}

/* Errors name the line of the key concerned. */
ovr_status ovr_stress_planned(const ovr_setup *setup, int surface,
                              ovr_stress_sight seen, ovr_stress_plan *plan,
                              ovr_error *err)
{
    const ovr_resolved *r = setup->resolved;
    ovr_error why = {0};
    if (!make_plan(setup, surface, seen, plan, &why))
        return OVR_OK;
    return ovr_fail_in(err, r->c, ovr_block_of(r, "stress"),
                       ovr_block_of(r, why.about && !strcmp(why.about, "step")
                                           ? "time"
                                           : "fatigue"),
                       &why);
}

ovr_status ovr_setup_stress_depth(const ovr_setup *setup, double *minimum,
                                  ovr_error *err)
{
    if (!setup || !minimum)
        return ovr_fail_null(err, __func__);
    *minimum = NAN;
    for (int k = 1; k <= 2; k++) {
        ovr_stress_plan plan;
        if (!(ovr_setup_stress(setup)->surfaces >> (k - 1) & 1))
            continue;
        if (ovr_stress_planned(setup, k, ovr_stress_sight_of(setup), &plan,
                               err))
            return OVR_BAD_INPUT;
        *minimum = plan.options.depth_min;
    }
    return OVR_OK;
}

double ovr_material_histories_memory(const ovr_setup *setup)
{
    if (!setup)
        return NAN;
    double bytes = 0;
    for (int k = 1; k <= 2; k++) {
        ovr_stress_plan plan;
        if (!(ovr_setup_stress(setup)->surfaces >> (k - 1) & 1) ||
            ovr_stress_planned(setup, k, ovr_stress_sight_of(setup), &plan,
                               NULL))
            continue;
        bytes += ovr_material_history_memory(&plan.options, &plan.range);
        /* Ring buffer of the follower */
        bytes += (plan.options.traction ? 2 : 1) * 32. * 8 *
                 (double)setup->nodes;
    }
    return bytes;
}

/* ----------------------------------------------------------------- Traction */

/*
 * Traction on each body by the shear stress of the film, along +X:
 *
 *     Q_1 = kappa tau_1,   Q_2 = -kappa tau_2      (p_h; kappa = b/R)
 *
 * tau_1, tau_2 being tau_xz in the film at the surfaces, z from 1 to 2: the
 * film lies above body 1 and below body 2, whose outward normals are z and -z.
 * In each body x goes along the surface and depth into it, so that the stresses
 * follow from P and Q in the same way.  The value at a node is the mean of the
 * two neighbouring half nodes, as in result files (second order).
 *
 * The effect of tangential loads on the gap is neglected; it is zero for two
 * bodies of the same material (K. L. Johnson, Contact Mechanics, 1985, section
 * 7.1).
 */

static const char *name_of(const ovr_stress_plan *plan)
{
    return plan->surface == 1 ? "shear_stress_1" : "shear_stress_2";
}

const double *ovr_traction_now(const ovr_stress_plan *plan,
                               const ovr_simulation *sim, double *workspace)
{
    const ovr_observable *shear = ovr_observable_field(name_of(plan));
    size_t last = plan->options.nodes - 1;
    double before, *Q = workspace;
    if (!plan->options.traction)
        return NULL;
    /* may be in the workspace */
    const double *tau = shear->field(sim, workspace);
    before = tau[0];
    for (size_t i = 0; i <= last; i++) {
        double behind = i < last ? tau[i] : before;
        Q[i] = plan->traction * (before + behind) / 2;
        before = behind;
    }
    return Q;
}

ovr_status ovr_traction_stored(const ovr_stress_plan *plan, ovr_result *result,
                               size_t k, double *workspace, ovr_error *err)
{
    ovr_status status;
    if (!plan->options.traction)
        return OVR_OK;
    status = ovr_result_snapshot(result, name_of(plan), k, OVR_HERTZIAN,
                                 workspace, err);
    for (size_t i = 0; !status && i < plan->options.nodes; i++)
        workspace[i] *= plan->traction;
    return status;
}

bool ovr_traction_is_stored(const ovr_stress_plan *plan,
                            const ovr_result *result)
{
    return ovr_result_find(result, name_of(plan)) != NULL;
}
