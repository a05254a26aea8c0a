/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reports a material history: largest values, amplitudes, life. */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "case/setup.h"
#include "physics/stress/stress.h"
#include "stress/layered.h"
#include "stress/material_history.h"
#include "stress/stress.h"

static bool take_arrays(ovr_stress_report *r, ovr_arena *arena, ovr_error *err)
{
    size_t n = r->material.points, depths = r->material.depths;
    bool ok = true;
    for (int m = 0; ok && m < OVR_MEASURES; m++) {
        r->measure[m] = ovr_arena_take(arena, n * depths, sizeof(float), err);
        r->smooth[m] = ovr_arena_take(arena, depths, sizeof(double), err);
        ok = r->measure[m] && r->smooth[m];
    }
    if (!ok)
        return false;
    r->amplitude = ovr_arena_take(arena, n * depths, sizeof(float), err);
    r->amplitude_smooth = ovr_arena_take(arena, depths, sizeof(double), err);
    r->risk = ovr_arena_take(arena, n, sizeof(double), err);
    r->length = ovr_arena_take(arena, depths, sizeof(double), err);
    return r->amplitude && r->amplitude_smooth && r->risk && r->length;
}

/* Copies what the material history owns and frees with itself. */
static bool copy_material(ovr_stress_report *r, ovr_arena *arena,
                          ovr_error *err)
{
    ovr_material *m = &r->material;
    double *z = ovr_arena_take(arena, m->depths, sizeof *z, err);
    unsigned char *complete = ovr_arena_take(arena, m->points, 1, err);
    if (!z || !complete)
        return false;
    memcpy(z, m->z, m->depths * sizeof *z);
    memcpy(complete, m->complete, m->points);
    m->z = z;
    m->complete = complete;
    return true;
}

/* The largest circle of complete points from the smallest depth down. */
static void find_worst(ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    const float *R = r->measure[OVR_MEASURE_CIRCLE];
    r->R_max = r->incomplete < m->points ? 0 : NAN;
    for (size_t j = 0; j < m->depths; j++) {
        if (m->z[j] < r->least_depth * (1 - 1e-9))
            continue;
        r->R_smooth = fmax(r->R_smooth, r->smooth[OVR_MEASURE_CIRCLE][j]);
        for (size_t k = 0; k < m->points; k++)
            if (m->complete[k] && (double)R[j * m->points + k] > r->R_max) {
                r->R_max = R[j * m->points + k];
                r->xi_R_max = m->start + (double)k * m->step;
                r->Z_R_max = m->z[j];
            }
    }
}

/* The criterion's amplitude from what is measured already. */
static void combine(const ovr_stress_setup *s, ovr_stress_report *r)
{
    static const ovr_measure of[] = {
        [OVR_CRITERION_CIRCLE] = OVR_MEASURE_CIRCLE,
        [OVR_CRITERION_ORTHOGONAL] = OVR_MEASURE_ORTHOGONAL,
        [OVR_CRITERION_CRITICAL_PLANE] = OVR_MEASURE_CRITICAL,
        [OVR_CRITERION_DANG_VAN] = OVR_MEASURE_CIRCLE,
        [OVR_CRITERION_VON_MISES] = OVR_MEASURE_VON_MISES,
        [OVR_CRITERION_TRESCA] = OVR_MEASURE_TRESCA};
    size_t n = r->material.points, depths = r->material.depths;
    bool tension = s->criterion == OVR_CRITERION_CIRCLE;
    const float *hydro = r->measure[OVR_MEASURE_HYDRO_MAX];
    for (size_t k = 0; k < n * depths; k++)
        r->amplitude[k] = r->measure[of[s->criterion]][k] +
                          (tension && hydro[k] > 0 ? (float)s->alpha * hydro[k]
                                                   : 0);
    for (size_t j = 0; j < depths; j++)
        r->amplitude_smooth[j] =
            r->smooth[of[s->criterion]][j] +
            (tension ? s->alpha * fmax(r->smooth[OVR_MEASURE_HYDRO_MAX][j], 0)
                     : 0);
}

static ovr_status find_amplitude(const ovr_stress_source *of,
                                 const ovr_stress_plan *plan,
                                 ovr_stress_report *r, ovr_error *err)
{
    const ovr_stress_setup *s = ovr_setup_stress(of->setup);
    combine(s, r);
    if (s->criterion != OVR_CRITERION_DANG_VAN)
        return OVR_OK;
    if (!of->path)
        return ovr_fail_about(err, "criterion",
                              "criterion = dang-van needs the stored "
                              "pressure of all nodes; set output.file");
    return ovr_stress_second_pass(of, plan, r, err);
}

/* Points at both ends of the material, a tenth of it each, see little of a
 * feature: what their risk is off by is the method's, of all the others too. */
static double length_error(const ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    size_t ends = m->points / 10 + 1, counted = 0;
    double off = 0;
    for (size_t k = 0; k < m->points; k++)
        if ((k < ends || k + ends >= m->points) && m->complete[k]) {
            off += fabs(r->risk[k] / r->life->smooth_risk - 1);
            counted++;
        }
    return counted ? off / (double)counted * (double)m->points * m->step : NAN;
}

/* The von Mises stress below a smooth contact relative to its p_h, with a
 * margin for traction. */
static const double SMOOTH_VON_MISES = 0.6;

/* Returns why an elastic stress history has no life, or NULL. */
static const char *why_lifeless(const ovr_setup *setup,
                                const ovr_stress_report *r)
{
    double bearable = setup->bearable / setup->contact->ph;
    if (r->incomplete == r->material.points)
        return "no material point passes the whole contact within the run; "
               "set a later time.end";
    if (!(ovr_setup_physics(setup) & OVR_PHYSICS_PLASTIC) &&
        r->von_mises.value > SMOOTH_VON_MISES * bearable)
        return "the elastic stresses are those of a pressure above "
               "contact.bearable_pressure, at which the body yields";
    return NULL;
}

static ovr_status find_life(const ovr_setup *setup, ovr_stress_report *r,
                            ovr_life_result *result, ovr_error *err)
{
    const ovr_stress_setup *s = ovr_setup_stress(setup);
    ovr_life_options life = s->life;
    double z;
    r->hertz = ovr_hertz_criterion(s->criterion, s->alpha,
                                   s->poisson[r->surface - 1], &z);
    r->limit = r->hertz * s->limit_pressure;
    life.limit = r->limit;
    life.least_depth = r->least_depth;
    const ovr_amplitudes of = {&r->material, r->amplitude, r->amplitude_smooth};
    if (ovr_life(&life, &of, r->risk, r->length, result, err))
        return OVR_BAD_INPUT;
    if (life.limits)
        r->limit = result->used_limit;
    r->length_error = length_error(r);
    r->ratio = NAN;
    r->lifeless = why_lifeless(setup, r);
    if (r->lifeless)
        *result = (ovr_life_result){
            .equivalent_length = NAN, .utilisation = NAN, .smooth_risk = NAN};
    if (s->raceway > 0 && !r->lifeless)
        r->ratio = ovr_life_ratio(&life, r->life->equivalent_length, s->raceway,
                                  s->count);
    return OVR_OK;
}

/* Stresses that no body bears, whatever it is made of: those of a film whose
 * law has left what oils do (Newtonian, at large sliding and pressure). */
static bool is_beyond(const ovr_stress_report *r)
{
    const double maximum = 1e3;
    return !(r->max_shear.value < maximum && r->von_mises.value < maximum &&
             !(r->R_max >= maximum));
}

static const ovr_stress_extreme none = {NAN, NAN, NAN, NAN};

static void find_layers(const ovr_stress_plan *plan,
                        const ovr_material_history *history,
                        ovr_stress_report *r)
{
    const ovr_layer_extremes of = ovr_material_history_layers(history);
    const ovr_layered *layers = plan->options.layers;
    r->layer_von_mises = r->interface_shear = r->interface_tension = none;
    r->surface_tension = none;
    r->layer_utilisation = r->interface_utilisation = r->layer_fatigue = NAN;
    /* times too far apart resolve no depth in the topmost layer */
    if (!layers || plan->options.depth_min >= layers->thickness[0])
        return;
    r->layer_von_mises = of.von_mises[0];
    for (int j = 1; j < layers->layers; j++)
        if (of.von_mises[j].value > r->layer_von_mises.value)
            r->layer_von_mises = of.von_mises[j];
    for (int j = 0; j < layers->layers; j++) {
        if (layers->yield[j] > 0)
            r->layer_utilisation = fmax(
                r->layer_utilisation, of.von_mises[j].value / layers->yield[j]);
        if (layers->strength[j] > 0)
            r->interface_utilisation = fmax(r->interface_utilisation,
                                            of.shear[j].value /
                                                layers->strength[j]);
    }
    r->interface_shear = of.shear[0];
    for (int j = 1; j < layers->layers; j++)
        if (of.shear[j].value > r->interface_shear.value)
            r->interface_shear = of.shear[j];
    r->interface_tension = of.tension;
    r->surface_tension = of.surface;
}

/* The largest amplitude of complete points at the depths of a layer. */
static double layer_amplitude(const ovr_layered *layers, int layer,
                              const ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    double maximum = 0;
    for (size_t j = 0; j < m->depths; j++)
        for (size_t k = 0;
             ovr_layered_at(layers, m->z[j]) == layer && k < m->points; k++)
            if (m->complete[k])
                maximum = fmax(maximum,
                               (double)r->amplitude[j * m->points + k]);
    return maximum;
}

/* The share of layers' own limits that is used: the amplitude over that of a
 * smooth dry contact of their material at the limiting pressure. */
static void find_layer_fatigue(const ovr_setup *setup,
                               const ovr_stress_plan *plan,
                               ovr_stress_report *r)
{
    const ovr_layered *layers = plan->options.layers;
    const ovr_stress_setup *s = ovr_setup_stress(setup);
    if (isnan(r->layer_von_mises.value))
        return;
    for (int j = 0; j < layers->layers; j++) {
        double z, hertz = ovr_hertz_criterion(s->criterion, s->alpha,
                                              layers->layer[j].poisson, &z);
        if (layers->limit[j] > 0)
            r->layer_fatigue = fmax(r->layer_fatigue,
                                    layer_amplitude(layers, j, r) /
                                        (hertz * layers->limit[j]));
    }
}

/* Points beyond yield: how many of those from the smallest depth down, and how
 * deep any are. */
static void count_yielding(ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    const float *von_mises = r->measure[OVR_MEASURE_VON_MISES];
    size_t counted = 0, beyond = 0;
    r->yielding_depth = 0;
    for (size_t j = 0; j < m->depths; j++) {
        bool counts = m->z[j] >= r->least_depth * (1 - 1e-9);
        for (size_t k = 0; k < m->points; k++) {
            if (!m->complete[k])
                continue;
            bool yields = (double)von_mises[j * m->points + k] > r->yield;
            counted += counts;
            beyond += counts && yields;
            if (yields)
                r->yielding_depth = m->z[j];
        }
    }
    r->yielding_share = counted ? (double)beyond / (double)counted : NAN;
}

static void find_yield(const ovr_stress_plan *plan,
                       const ovr_material_history *history,
                       ovr_stress_report *r)
{
    double Y = plan->range.yield > 0 ? plan->range.yield : NAN;
    r->yield = Y;
    r->yield_ratio = r->von_mises;
    r->yield_ratio.value = r->von_mises.value / Y - 1;
    r->strip = ovr_material_history_strip(history);
    r->strip.value /= ovr_strip_collapse() * Y;
    r->of_first_yield = 1 / (ovr_first_yield(plan->range.poisson) * Y);
    r->of_shakedown = 1 / (ovr_shakedown_limit() * Y);
    r->yielding_share = r->yielding_depth = NAN;
    if (!isnan(Y))
        count_yielding(r);
}

static void withhold(ovr_stress_report *r, ovr_life_result *life)
{
    size_t n = r->material.points, depths = r->material.depths;
    r->none = "the shear stress of the film is far above what lubricants "
              "sustain; set lubricant.rheology, or stress.traction = no";
    r->max_shear = r->von_mises = r->layer_von_mises = none;
    r->interface_shear = r->interface_tension = r->surface_tension = none;
    r->layer_utilisation = r->interface_utilisation = r->layer_fatigue = NAN;
    r->yielding_share = r->yielding_depth = NAN;
    r->yield_ratio = none;
    r->R_max = r->xi_R_max = r->Z_R_max = r->R_smooth = NAN;
    for (int m = 0; m < OVR_MEASURES; m++) {
        for (size_t k = 0; k < n * depths; k++)
            r->measure[m][k] = NAN;
        for (size_t j = 0; j < depths; j++)
            r->smooth[m][j] = NAN;
    }
    r->fatigue = false;
    *life = (ovr_life_result){.equivalent_length = NAN, .utilisation = NAN};
}

/* Depth in mesh sizes D above which an unresolved pressure spike changes the
 * stresses.  The load that the mesh misses, spread over about D, makes a stress
 * in proportion to D/z at the depth z (line load on a half plane): below 16 D
 * it is less than a twentieth of the spike's height. */
static const double SPIKE_DEPTH = 16;

double ovr_unresolved_depth(double mesh)
{
    return SPIKE_DEPTH * mesh;
}

/* A maximum at the least depth is one of the chosen depths only. */
static double unresolved_depth(const ovr_stress_source *of, double least)
{
    double spike = ovr_unresolved_depth(of->setup->mesh);
    return of->unresolved ? fmax(spike, (1 + 1e-6) * least) : 0;
}

ovr_stress_report *ovr_stress_report_make(const ovr_stress_source *of,
                                          const ovr_stress_plan *plan,
                                          const ovr_material_history *history,
                                          ovr_arena *arena, ovr_error *err)
{
    const ovr_setup *setup = of->setup;
    ovr_stress_report *r = ovr_arena_take(arena, 1, sizeof *r, err);
    ovr_life_result *life = ovr_arena_take(arena, 1, sizeof *life, err);
    if (!r || !life)
        return NULL;
    life->equivalent_length = NAN;
    r->life = life;
    r->surface = plan->surface;
    r->feature = plan->feature;
    r->fatigue = ovr_setup_stress(setup)->fatigue;
    r->direction = plan->direction;
    r->traction = plan->options.traction;
    r->no_traction = plan->no_traction;
    r->material = ovr_material_history_points(history);
    r->least_depth = plan->range.least_depth;
    if (!copy_material(r, arena, err))
        return NULL;
    r->ratio = r->limit = NAN;
    if (ovr_material_history_widest(history) * 4 > r->least_depth * (1 + 1e-6))
        r->least_depth = 4 * ovr_material_history_widest(
                                 history); /* adaptive steps */
    r->unresolved_depth = unresolved_depth(of, r->least_depth);
    if (!take_arrays(r, arena, err))
        return NULL;
    for (int m = 0; m < OVR_MEASURES; m++)
        ovr_material_history_measure(history, (ovr_measure)m, r->measure[m],
                                     r->smooth[m]);
    r->max_shear = ovr_material_history_max_shear(history);
    r->von_mises = ovr_material_history_von_mises(history);
    find_layers(plan, history, r);
    find_yield(plan, history, r);
    for (size_t k = 0; k < r->material.points; k++)
        r->incomplete += !r->material.complete[k];
    find_worst(r);
    if (is_beyond(r))
        withhold(r, life);
    if (r->fatigue &&
        (find_amplitude(of, plan, r, err) || find_life(setup, r, life, err)))
        return NULL;
    if (r->fatigue)
        find_layer_fatigue(setup, plan, r);
    return r;
}
