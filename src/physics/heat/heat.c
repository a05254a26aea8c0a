/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat in a steady contact (equations in heated.h). */
#include "physics/heat/heat.h"
#include "base/given.h"
#include "base/larger.h"
#include "physics/heat/in_time.h"
#include "physics/heat/outer.h"
#include "physics/heat/skew.h"
#include "simulation/conflicts.h"
#include "simulation/fourth.h"
#include "simulation/mirror.h"
#include "simulation/observe.h"
#include "simulation/physics.h"
#include "simulation/quantity_row.h"
#include "simulation/steady.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "contact/contact.h"
#include "contact/heat_numbers.h"
#include "multigrid/content.h"
#include "multigrid/field.h"
#include "multigrid/flow.h"
#include "simulation/simulation.h"

enum { CROSS_FILM_MIN = 5 };

/* --------------------------------------------------------------- creation */

static ovr_status check(const ovr_simulation *sim, ovr_error *err)
{
    return ovr_conflict_check(ovr_model_features_of(&sim->options) |
                                  ovr_model_feature_bit(OVR_MODEL_HEAT, true),
                              err);
}

static ovr_status allocate_arrays(ovr_simulation *sim, ovr_heated *h,
                                  ovr_error *err)
{
    OVR_TAKE_NODES(sim, err, &h->q[0], &h->q[1], &h->mean, &h->t, &h->drag,
                   &h->th, &h->shift, &h->swell, &h->start_P, &h->start_q);
    for (int j = 0; j < h->cross_film.n; j++)
        OVR_TAKE_NODES(sim, err, &h->T[j], &h->used[j]);
    for (int l = sim->grids.coarsest; l <= sim->grids.finest; l++) {
        ovr_level *level = &sim->grids.level[l];
        size_t capacity = level->grid.n + OVR_MAX_LANES;
        level->f.th = ovr_field(&sim->arena, capacity, err);
        level->f.shift = ovr_field(&sim->arena, capacity, err);
        level->f.drag = ovr_field(&sim->arena, capacity, err);
        if (h->numbers.density_expands)
            level->f.swell = ovr_field(&sim->arena, capacity, err);
    }
    return ovr_arena_status(&sim->arena);
}

static ovr_status create_heat(ovr_simulation *sim, const void *form, void **own,
                              ovr_error *err)
{
    const ovr_heat *heat = form;
    const ovr_lubricant *oil = &sim->lubricant;
    ovr_heated *h;
    ovr_heat numbers;
    if (OVR_TAKE(ovr_heat, &numbers, heat, err) || check(sim, err))
        return OVR_BAD_INPUT;
    h = ovr_arena_take(&sim->arena, 1, sizeof *h, err);
    if (!h)
        return OVR_NO_MEMORY;
    h->numbers = numbers;
    h->Sigma0 = oil->rheology == OVR_NEWTONIAN ? INFINITY : oil->Sigma0;
    h->limit = oil->limiting_shear > 0
                   ? oil->limiting_shear / sim->contact.kappa
                   : INFINITY;
    h->chooses = numbers.points == 0;
    ovr_cross_film_make(h->chooses ? OVR_CROSS_FILM_MAX : numbers.points,
                        &h->cross_film);
    if (allocate_arrays(sim, h, err))
        return OVR_NO_MEMORY;
    *own = sim->heated = h;
    sim->physics.features |= ovr_model_feature_bit(OVR_MODEL_HEAT, true);
    if (ovr_heat_skew_take(sim, err) || ovr_heat_film_take(sim, err) ||
        ovr_heat_outer_take(sim, err) || ovr_heat_steps_take(sim, err))
        return OVR_NO_MEMORY;
    if (h->chooses)
        ovr_cross_film_make(CROSS_FILM_MIN, &h->cross_film);
    return OVR_OK;
}

/* -------------------------------------------------- effect on the film */

static void before_start(ovr_simulation *sim, void *own)
{
    ovr_heated *h = own;
    (void)sim;
    h->cycles = 0;
    h->change = 0;
}

/* Resets to the isothermal state. */
static void forget(ovr_simulation *sim, void *own)
{
    ovr_heated *h = own;
    if (h->chooses)
        ovr_cross_film_make(CROSS_FILM_MIN, &h->cross_film);
    ovr_heat_march_begin(sim);
    ovr_heat_march_columns(sim);
    h->steps->trying = false;
    h->steps->dT = 0;
    h->skew_share = 1;
    ovr_heat_skew_forget(sim);
    for (int k = 0; k < 2; k++)
        ovr_heat_surface_reset(sim, k);
    for (size_t i = 0; i < sim->now.n; i++) {
        h->th[i] = 1;
        h->shift[i] = 0;
        h->drag[i] = h->swell[i] = 1;
        for (int j = 0; j < h->cross_film.n; j++)
            h->T[j][i] = h->used[j][i] = 0;
        h->q[0][i] = h->q[1][i] = 0;
    }
    ovr_heat_give(sim);
}

/* -------------------------------------------------- observed quantities */

/* Mean shear stress: that of the isothermal film with the present viscosities,
 * as in the Reynolds equation, plus the effect of the temperature profile
 * (cross_film.h). */
static void stress(ovr_simulation *sim, void *own, const ovr_sheared *film,
                   const ovr_fluid *fluid, double *t)
{
    ovr_heated *h = own;
    ovr_sheared dragged = *film;
    double *q = ovr_work_take(sim), *even = ovr_work_take(sim);
    for (size_t i = 0; i < sim->now.n; i++)
        q[i] = h->drag[i] * film->q[i];
    dragged.q = q;
    sim->grids.kernels->mean_stress(&dragged, fluid, t);
    h->film.even = even;
    ovr_heat_film(sim);
    h->film.even = NULL;
    h->film.P_T = h->steps->dT > 0 ? h->steps->P_T : NULL;
    h->made = ovr_heat_made(sim);
    for (size_t i = 0; i + 1 < sim->now.n; i++)
        t[i] += (h->t[i] - even[i] + h->t[i + 1] - even[i + 1]) / 2;
    ovr_work_give(sim, even);
    ovr_work_give(sim, q);
}

/* Finds the maximum and its position. */
static void largest(const ovr_simulation *sim, const double *T, double *value,
                    double *X)
{
    for (size_t i = 0; i < sim->now.n; i++)
        if (i == 0 || T[i] > *value) {
            *value = T[i];
            *X = sim->now.X[i];
        }
}

/* Returns the maximum that T may have on finer grids: the largest sum of T and
 * its excess over the mean of the adjacent nodes. */
static double largest_on_finer_grids(const ovr_simulation *sim, const double *T)
{
    double largest = 0;
    for (size_t i = 1; i + 1 < sim->now.n; i++)
        largest = ovr_larger(largest, 2 * T[i] - (T[i - 1] + T[i + 1]) / 2);
    return largest;
}

static void observe_temperatures(const ovr_simulation *sim, ovr_observation *o)
{
    const ovr_heated *h = sim->heated;
    double T0 = h->numbers.T0;
    o->T_max_finer = 0;
    for (int j = 0; j < h->cross_film.n; j++) {
        double T = NAN, X = NAN;
        largest(sim, h->T[j], &T, &X);
        if (!(T <= o->T_max_rise)) {
            o->T_max_rise = T;
            o->X_T_film_max = X;
        }
        o->T_max_finer = ovr_larger(o->T_max_finer,
                                    largest_on_finer_grids(sim, h->T[j]));
    }
    largest(sim, h->T[0], &o->T_1_max_rise, &o->X_T_1_max);
    largest(sim, h->T[h->cross_film.n - 1], &o->T_2_max_rise, &o->X_T_2_max);
    o->T_film_max = T0 + o->T_max_rise;
    o->T_1_max = T0 + o->T_1_max_rise;
    o->T_2_max = T0 + o->T_2_max_rise;
}

/* x of heated.h. */
static double last_cross_film(const ovr_simulation *sim, double rise)
{
    const ovr_heated *h = sim->heated;
    double maximum = 0;
    for (size_t i = 0; i < sim->now.n; i++) {
        double a = 0;
        for (int j = 0; j < h->cross_film.n; j++)
            a += h->cross_film.last[j] * h->T[j][i];
        maximum = ovr_larger(maximum, fabs(a));
    }
    return rise > 0 ? maximum / rise : 0;
}

/* True if the temperatures require more than 5 points across the film: by x of
 * heated.h and the maximum rise. */
static bool is_uneven(double x, double rise)
{
    const double much = 0.05, hot = 20; /* K */
    return x > much && rise > hot;
}

/* True if temperature profiles can become less uniform in time than in the
 * steady start: with time histories or moving features. */
static bool may_grow_uneven(const ovr_simulation *sim)
{
    bool passes = sim->shapes.heights && sim->shapes.moving != 0;
    return passes || sim->histories.sliding ||
           ovr_history_varies(sim->histories.load) ||
           ovr_history_varies(sim->histories.speed) ||
           ovr_history_varies(sim->histories.radius);
}

/* Records the maximum x, if the film is hot enough for it to matter. */
static void observe_points(ovr_simulation *sim, const ovr_observation *o)
{
    ovr_statistics *s = &sim->statistics;
    double x = last_cross_film(sim, o->T_max_rise);
    if (is_uneven(x, o->T_max_rise))
        s->last_cross_film = ovr_larger(s->last_cross_film, x);
}

int ovr_simulation_heat_points(const ovr_simulation *sim)
{
    if (!sim)
        return 0;
    return sim->heated ? sim->heated->cross_film.n : 0;
}

static double flow_into(const ovr_simulation *sim, int k)
{
    const ovr_heated *h = sim->heated;
    double sum = 0;
    for (size_t i = 1; i < sim->now.n; i++)
        if (ovr_heat_counts(sim, i))
            sum += sim->now.weights[i] * h->q[k][i];
    return sum * h->numbers.conduction / h->numbers.theta;
}

static void unknown(ovr_observation *o)
{
    o->T_film_max = o->X_T_film_max = NAN;
    o->T_max_rise = o->T_max_finer = NAN;
    o->T_1_max = o->X_T_1_max = o->T_1_max_rise = NAN;
    o->T_2_max = o->X_T_2_max = o->T_2_max_rise = NAN;
    o->heat_flow_1 = o->heat_flow_2 = o->energy_defect = NAN;
}

/* Returns the power that becomes heat, by forces, speeds and flow alone: in a
 * steady film -V F_slide + 2 Cu F_roll - M int dP/rho.  In a time step, in
 * which lubricant and solids store energy, the dissipated power. Both exclude
 * the region upstream of the inlet, which does not heat the film in the domain.
 */
static double power_of_forces(const ovr_simulation *sim,
                              const ovr_observation *o)
{
    const ovr_solution *now = &sim->now;
    double worked = 0;
    if (sim->heated->steps->dT > 0)
        return o->power_dissipated - sim->shear.inlet_share.power;
    for (size_t i = 0; i + 1 < now->n; i++)
        if (now->P[i] > 0 || now->P[i + 1] > 0)
            worked += (now->P[i + 1] - now->P[i]) *
                      (now->H[i] + now->H[i + 1]) / (now->q[i] + now->q[i + 1]);
    return 2 * o->speed_ratio * o->F_roll - o->sliding * o->F_slide -
           sim->shear.inlet_share.power - o->mass_flow * worked;
}

/* Observes maximum rises, heat flows into the surfaces and the balance error.
 */
static void observe(ovr_simulation *sim, void *own, ovr_observation *o)
{
    ovr_heated *h = own;
    double stored, taken;
    o->energy_defect = 0;
    observe_temperatures(sim, o);
    observe_points(sim, o);
    o->heat_flow_1 = flow_into(sim, 0);
    o->heat_flow_2 = flow_into(sim, 1);
    stored = h->steps->dT > 0 ? h->steps->stored : ovr_heat_stored(sim);
    h->balanced = ovr_larger(h->made.size,
                             fabs(o->heat_flow_1) + fabs(o->heat_flow_2));
    taken = stored + o->heat_flow_1 + o->heat_flow_2 - h->made.pressed;
    h->left = h->made.sheared - taken;
    if (h->balanced > 0)
        o->energy_defect = (power_of_forces(sim, o) - taken) / h->balanced;
}

/* q D at half node i + 1/2: as in F, or the mean of both nodes. */
static double skewed(const ovr_simulation *sim, const void *own, size_t i,
                     bool mean)
{
    const double *v = ((const ovr_heated *)own)->skewed;
    if (mean)
        return (v[i] + v[i + 1]) / 2;
    if (i == 0 && !sim->histories.backward)
        return v[0];
    return ovr_upstream(sim, v, i);
}

/* Changes of the flow coefficient at a node by the temperature, and of the
 * density if it expands. */
static void apply_temperature_to_viscosity(const ovr_simulation *sim,
                                           const void *own, size_t i,
                                           double *eps, double *rho)
{
    const ovr_heated *h = own;
    const ovr_solution *now = &sim->now;
    *eps *= now->eps[i] / ovr_flow(&sim->grids.fluid, now->P[i], now->H[i]);
    if (h->numbers.density_expands)
        *rho *= h->swell[i];
}

/* Temperature rises of a field; NULL if the field is not a temperature. */
static const double *rises(const ovr_heated *h, ovr_physics_field which)
{
    switch (which) {
    case OVR_FIELD_TEMPERATURE_1: return h->T[0];
    case OVR_FIELD_TEMPERATURE_2: return h->T[h->cross_film.n - 1];
    case OVR_FIELD_TEMPERATURE_MIDDLE: return h->T[h->cross_film.n / 2];
    case OVR_FIELD_TEMPERATURE_MEAN: return h->mean;
    default: return NULL;
    }
}

static const double *field(const ovr_simulation *sim, const void *own,
                           ovr_physics_field which, double *workspace)
{
    const ovr_heated *h = own;
    const double *T = rises(h, which);
    const double *q = h->q[which == OVR_FIELD_HEAT_FLUX_1 ? 0 : 1];
    for (size_t i = 0; i < sim->now.n; i++)
        workspace[i] = T ? h->numbers.T0 + T[i]
                         : q[i] * h->numbers.conduction / h->numbers.theta;
    return workspace;
}

static void warm(const ovr_simulation *sim, const void *own, double *viscosity,
                 double *density)
{
    const ovr_heated *h = own;
    for (size_t i = 0; viscosity && i < sim->now.n; i++)
        viscosity[i] = exp(
            ovr_heat_log_viscosity(&h->numbers, log(viscosity[i]), h->mean[i]));
    for (size_t i = 0; density && i < sim->now.n; i++)
        density[i] *= h->swell[i];
}

/* ----------------------------------------------------------------- physics */

static void describe(const ovr_physics_case *of, const void *form,
                     ovr_physics_line *line, void *data)
{
    const ovr_heat *heat = form;
    char text[120], points[20] = "5 or 7";
    (void)of;
    if (heat->points)
        snprintf(points, sizeof points, "%d", heat->points);
    snprintf(text, sizeof text,
             "Theta = %.5g K, Kf = %.5g; %s points across the film",
             heat->theta, heat->conduction, points);
    line(data, "thermal parameters", text);
    snprintf(text, sizeof text, "%.4g and %.4g", heat->peclet[0],
             heat->peclet[1]);
    line(data, "Peclet numbers of the surfaces", text);
    snprintf(text, sizeof text, "S0 = %.4g, beta = %.4g 1/K at p = 0", heat->S0,
             heat->beta);
    line(data, "viscosity-temperature relation", text);
}

/* ------------------------------------------- Iteration of film and heat */

static void keep_start(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    memcpy(h->start_P, sim->now.P, sim->now.n * sizeof *h->start_P);
    memcpy(h->start_q, sim->now.q, sim->now.n * sizeof *h->start_q);
    h->start_H0 = sim->grids.H0;
}

/* Restores the isothermal film, the initial state of the iteration. */
static void return_to_start(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    const ovr_cross_film points = h->cross_film;
    ovr_level *level = sim->finest;
    ovr_nodes_write(sim, level, h->start_P, level->f.P);
    sim->grids.H0 = h->start_H0;
    if (ovr_conserves(sim)) {
        ovr_nodes_write(sim, level, h->start_q, level->f.q);
        ovr_content_wet(level, h->start_P);
        ovr_content_mark(level, level->f.wet, 0, !level->closed);
    }
    forget(sim, h);
    h->cross_film = points;
    /* Gap corrections depend on P; flow corrections depend on the film with the
     * corrected gap */
    for (int pass = 0; pass < 2; pass++) {
        ovr_level_refresh(&sim->grids, level);
        ovr_simulation_read(sim);
        ovr_fourth_renew(sim);
    }
    ovr_level_refresh(&sim->grids, level);
    ovr_simulation_read(sim);
}

/* True if the cycles ended close to a solution. */
static bool is_film(const ovr_outcome *outcome)
{
    const double imbalance = 1e-3, load = 1e-2;
    const ovr_defect *d = &outcome->defect;
    return d->imbalance >= 0 && d->imbalance < imbalance && d->load < load &&
           d->centre > 0;
}

/* Increases the fraction of the skewed flow by a quarter if temperatures have
 * converged sufficiently. Returns true if it was increased. */
static bool add_skew(ovr_heated *h, double change)
{
    const double calm = 0.1, part = 0.25;
    if (h->skew_share >= 1 || !(change < calm))
        return false;
    h->skew_share += part;
    ovr_heat_outer_forget(h->outer);
    return true;
}

/* Reports a start for which the isothermal film was found, but not the
 * temperatures. */
static ovr_status explain(const ovr_simulation *sim, const void *own,
                          const ovr_outcome *outcome, ovr_error *err)
{
    const ovr_heated *h = own;
    const double meaningless = 1;
    char film[60] = "the film diverges";
    if (!h->cycles)
        return OVR_OK;
    if (outcome->defect.imbalance < meaningless)
        snprintf(film, sizeof film, "relative mass-flow imbalance %.1e",
                 outcome->defect.imbalance);
    return ovr_fail(
        err, OVR_NOT_CONVERGED,
        "the steady solution converged without heat, but not with heat: "
        "after %d cycles and %d strateg%s temperatures still change by %.1e "
        "of the maximum rise (target %.0e), %s; %sless sliding, a finer "
        "domain.level or a limiting shear stress may help",
        outcome->cycles, outcome->retries + 1, outcome->retries ? "ies" : "y",
        h->change, OVR_HEAT_CHANGE, film,
        sim->shapes.heights ? "lower features, " : "");
}

/* Returns true if corrections of fourth order are computed again.  If they were
 * fixed before the temperatures converge, the result would depend on the
 * iteration path. If they were recomputed later, they could oscillate with the
 * iteration. */
static bool are_renewed(int iteration, double change)
{
    enum { ALWAYS = 30 };
    const double settled = 1e-3;
    return iteration < ALWAYS || change > settled;
}

/* Solves the film with the present temperatures.  Returns false if a film of
 * rough surfaces with corrections of fourth order took a twentieth of the work
 * of the start.  Films of second order take less. */
static bool film_found(ovr_simulation *sim, const ovr_full *how,
                       ovr_outcome *outcome)
{
    const double share = 0.05;
    bool rough = sim->start.grown && sim->order == 4;
    double limit = ovr_hierarchy_narrow(&sim->grids, rough ? share : 1);
    outcome->defect = ovr_steady_cycles(sim, how, &outcome->cycles);
    bool ended = ovr_hierarchy_widen(&sim->grids, limit);
    ovr_simulation_read(sim);
    return !ended;
}

/* Solves temperatures and film alternately until both converge. `slowly`: the
 * skewed flow is added in quarters, and gamma is not zero where the stress is
 * limited. */
static void iterate(ovr_simulation *sim, const ovr_full *how, bool slowly,
                    ovr_outcome *outcome)
{
    enum { ITERATIONS = 200, MAX_LOST = 8 };
    const double enough = OVR_HEAT_CHANGE, far = 0.1;
    ovr_heated *h = sim->heated;
    double change = INFINITY;
    int lost = 0; /* number of consecutive solves without a film */
    bool found = true;
    ovr_heat_outer_begin(sim);
    h->skew_share = slowly ? 0 : 1;
    h->always_falls = slowly && isfinite(h->Sigma0);
    for (int k = 0; k < ITERATIONS && !(change < enough); k++) {
        int before = outcome->cycles;
        ovr_heat_march(sim);
        change = ovr_heat_iterate(sim);
        if (add_skew(h, change))
            change = 1;
        if (are_renewed(k, change))
            ovr_fourth_renew(sim);
        ovr_heat_apply(sim);
        found = film_found(sim, how, outcome);
        h->cycles += outcome->cycles - before;
        lost = is_film(outcome) ? 0 : lost + 1;
        if (!found || lost == MAX_LOST || !(outcome->defect.imbalance < 1e6) ||
            ovr_hierarchy_stops(&sim->grids))
            break;
    }
    h->change = change;
    ovr_heat_skew_follow(sim);
    h->strayed = !found || !is_film(outcome) || change > far;
    h->too_slow = !found;
    h->always_falls = false;
    if (!(change < enough) || h->skew_share < 1)
        outcome->defect.imbalance = ovr_larger(outcome->defect.imbalance,
                                               change);
}

/* Iterates again, starting from the isothermal film if the last iteration
 * diverged from it. */
static void iterate_again(ovr_simulation *sim, const ovr_full *how,
                          ovr_outcome *outcome)
{
    const ovr_heated *h = sim->heated;
    bool slowly = h->strayed && !h->too_slow;
    if (h->strayed)
        return_to_start(sim);
    iterate(sim, how, slowly, outcome);
}

static bool is_over(ovr_simulation *sim, const ovr_outcome *outcome)
{
    return ovr_steady_found(sim, outcome) || ovr_hierarchy_stops(&sim->grids);
}

static void outer(ovr_simulation *sim, const ovr_full *how,
                  ovr_outcome *outcome)
{
    keep_start(sim);
    iterate(sim, how, false, outcome);
    if (is_over(sim, outcome))
        return;
    if (sim->heated->strayed && !sim->heated->too_slow) {
        iterate_again(sim, how, outcome);
        if (is_over(sim, outcome))
            return;
    }
    if (ovr_fourth_give_up(sim))
        iterate_again(sim, how, outcome);
}

/* Interpolates the temperatures to more points across the film. */
static void refine_cross_film(ovr_simulation *sim)
{
    ovr_heated *h = sim->heated;
    const ovr_cross_film few = h->cross_film;
    ovr_cross_film_make(OVR_CROSS_FILM_MAX, &h->cross_film);
    for (int field = 0; field < 2; field++) {
        double **v = field ? h->used : h->T;
        for (size_t i = 0; i < sim->now.n; i++) {
            double at[OVR_CROSS_FILM_MAX], moved[OVR_CROSS_FILM_MAX];
            for (int j = 0; j < few.n; j++)
                at[j] = v[j][i];
            ovr_cross_film_move(&few, at, &h->cross_film, moved);
            for (int j = 0; j < h->cross_film.n; j++)
                v[j][i] = moved[j];
        }
    }
}

static double largest_rise(const ovr_simulation *sim)
{
    const ovr_heated *h = sim->heated;
    double rise = 0;
    for (int j = 0; j < h->cross_film.n; j++)
        for (size_t i = 0; i < sim->now.n; i++)
            rise = ovr_larger(rise, h->T[j][i]);
    return rise;
}

/* An outer iteration that oscillates with 5 points may converge with 7. */
static void couple(ovr_simulation *sim, void *own, const ovr_full *how,
                   ovr_outcome *outcome)
{
    ovr_heated *h = own;
    double rise;
    outer(sim, how, outcome);
    if (!h->chooses || h->cross_film.n > CROSS_FILM_MIN ||
        !(outcome->defect.imbalance < 1))
        return;
    rise = largest_rise(sim);
    if (!may_grow_uneven(sim) && !is_uneven(last_cross_film(sim, rise), rise))
        return;
    refine_cross_film(sim);
    outer(sim, how, outcome);
}

#define HEAT(name, key, si, kind, member, ...)                                 \
    OVR_NUMBER_ROW(name, key, si, kind, member, OVR_PHYSICS_HEAT, __VA_ARGS__)

/* Maximum temperature rise over the run so far. */
#define RISE(member, at, key, mean, ...)                                       \
    HEAT(NULL, NULL, NULL, TEMPERATURE, member, __VA_ARGS__, LARGEST(key),     \
         PLACE(at), MEAN(mean), STEADY_TOO)

static const ovr_observable quantities[] = {
    HEAT("max_film_temperature", NULL, NULL, TEMPERATURE, T_film_max,
         "maximum film temperature"),
    HEAT("x_max_film_temperature", "X_T_max", NULL, LENGTH, X_T_film_max,
         "position of the maximum film temperature"),
    HEAT("max_surface_temperature_1", NULL, NULL, TEMPERATURE, T_1_max,
         "maximum temperature of surface 1"),
    HEAT("x_max_surface_temperature_1", "X_T_1_max", NULL, LENGTH, X_T_1_max,
         "position of the maximum temperature of surface 1"),
    HEAT("max_surface_temperature_2", NULL, NULL, TEMPERATURE, T_2_max,
         "maximum temperature of surface 2"),
    HEAT("x_max_surface_temperature_2", "X_T_2_max", NULL, LENGTH, X_T_2_max,
         "position of the maximum temperature of surface 2"),
    RISE(T_max_rise, X_T_film_max, "T_max_rise", "T_max_rise_mean",
         "maximum film temperature rise",
         COMMENT("above the supply temperature"), EXTREME_REPORTED,
         MEAN_REPORTED),
    RISE(T_1_max_rise, X_T_1_max, "T_1_max_rise", "T_1_max_rise_mean",
         "maximum temperature rise of surface 1"),
    RISE(T_2_max_rise, X_T_2_max, "T_2_max_rise", "T_2_max_rise_mean",
         "maximum temperature rise of surface 2"),
    HEAT("heat_flow_1", "heat_flow_1", "heat_flow_1_W_per_m", POWER,
         heat_flow_1, "heat flow into surface 1"),
    HEAT("heat_flow_2", "heat_flow_2", "heat_flow_2_W_per_m", POWER,
         heat_flow_2, "heat flow into surface 2"),
    HEAT("energy_defect", "energy_defect", NULL, NUMBER, energy_defect,
         "energy balance error", COMMENT("relative to the dissipated power"),
         OF_MAGNITUDE("energy_defect_max"), STEADY_TOO)};

static void effects(const void *form, ovr_physics_effects *effects)
{
    (void)form;
    effects->features = ovr_model_feature_bit(OVR_MODEL_HEAT, true);
    effects->fields = "temperature_1, temperature_2, temperature_middle";
}

static const ovr_own_fields own_fields = {
    "temperatures and fluxes",
    "temperature_1, temperature_2, temperature_mean, temperature_middle, "
    "heat_flux_1, heat_flux_2"};

static const ovr_physics_in_case in_case = {.node_seconds = 5e-7,
                                            .section = &ovr_heat_section,
                                            .sections = 1,
                                            .behind = "lubricant",
                                            .form = sizeof(ovr_heat_case),
                                            .resolve = ovr_heat_resolve,
                                            .effects = effects,
                                            .own_fields = &own_fields,
                                            .lag = 0.05,
                                            .describe = describe};

static const ovr_physics_in_solve in_solve = {.take = create_heat,
                                              .before_start = before_start,
                                              .forget = forget,
                                              .couple = couple,
                                              .begin = ovr_heat_begin,
                                              .explain = explain};

static const ovr_physics_in_step in_step = {.step = ovr_heat_step,
                                            .attempt = ovr_heat_try,
                                            .update = ovr_heat_update,
                                            .accepted = ovr_heat_accepted,
                                            .step_back = ovr_heat_step_back,
                                            .visit = ovr_heat_visit,
                                            .restored = ovr_heat_restored};

static const ovr_physics_in_output in_output = {
    .companion = &ovr_heat_companion,
    .flow = skewed,
    .oil = apply_temperature_to_viscosity,
    .stress = stress,
    .warm = warm,
    .field = field,
    .unknown = unknown,
    OVR_QUANTITIES(quantities),
    .observe = observe,
    .marks = ovr_heat_is_stale};

const ovr_physics ovr_physics_heat = {.name = "heat",
                                      .bit = OVR_PHYSICS_HEAT,
                                      .in_case = &in_case,
                                      .in_solve = &in_solve,
                                      .in_step = &in_step,
                                      .in_output = &in_output};
