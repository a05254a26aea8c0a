/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The extremes over a whole run: kept step by step, and their list. */
#include <math.h>
#include <stddef.h>

#include "simulation/physics.h"

/* A value counts for the step that led to it, the start until there is one;
 * one that is observed again, of a run that goes on, does not. */
static void average(ovr_statistics *s, const ovr_observation *o, bool first)
{
    const double now[] = {o->H_mean,     o->mu_slide,     o->power_in,
                          o->T_max_rise, o->T_1_max_rise, o->T_2_max_rise};
    double *const mean[] = {&s->H_mean,        &s->mu_slide_mean,
                            &s->power_in_mean, &s->T_rise_mean,
                            &s->T_1_rise_mean, &s->T_2_rise_mean};
    double part = first ? 1 : (o->T - s->averaged) / o->T;
    for (size_t k = 0; k < sizeof now / sizeof *now; k++)
        if (part > 0)
            *mean[k] = part < 1 ? *mean[k] + part * (now[k] - *mean[k])
                                : now[k];
    s->averaged = o->T;
}

void ovr_statistics_take(ovr_statistics *s, const ovr_observation *o,
                         bool first)
{
    if (first || o->H_min_located < s->H_min) {
        s->H_min = o->H_min_located;
        s->X_H_min = o->X_min_located;
        s->T_H_min = o->T;
        s->H_mean_at_H_min = o->H_mean;
    }
    if (first || o->film_Rq > s->film_Rq)
        s->film_Rq = o->film_Rq;
    if (first || o->P_max > s->P_max) {
        s->P_max = o->P_max;
        s->X_P_max = o->X_P_max;
        s->T_P_max = o->T;
    }
    if (first || fabs(o->load_error) > fabs(s->load_error)) {
        s->load_error = o->load_error;
        s->T_load_error = o->T;
    }
    if (first || fabs(o->mu_slide) > fabs(s->mu_slide) ||
        (isnan(s->mu_slide) && !isnan(o->mu_slide))) {
        s->mu_slide = o->mu_slide;
        s->T_mu_slide = o->T;
    }
    average(s, o, first);
    for (int k = 0; ovr_physics_list[k]; k++)
        if (ovr_physics_list[k]->extremes)
            ovr_physics_list[k]->extremes(s, o, first);
}

#define ROW(key, si, kind, steady, member, text)                               \
    {                                                                          \
        sizeof(ovr_extreme), key, si, text, OVR_KIND_##kind, steady,           \
            offsetof(ovr_statistics, member), 0                                \
    }
/* Where there is heat. */
#define HEAT(key, kind, member, text)                                          \
    {                                                                          \
        sizeof(ovr_extreme), key, NULL, text, OVR_KIND_##kind, true,           \
            offsetof(ovr_statistics, member), OVR_PHYSICS_HEAT                 \
    }

static const ovr_extreme table[] = {
    ROW("H_min_overall", "H_min_overall_m", HEIGHT, false, H_min,
        "smallest film thickness over the run, located between nodes"),
    ROW("X_H_min_overall", "X_H_min_overall_m", LENGTH, false, X_H_min,
        "where that was"),
    ROW("T_H_min", "T_H_min_s", TIME, false, T_H_min, "when that was"),
    ROW("P_max_overall", "P_max_overall_Pa", PRESSURE, false, P_max,
        "largest pressure over the run"),
    ROW("X_P_max_overall", "X_P_max_overall_m", LENGTH, false, X_P_max,
        "where that was"),
    ROW("T_P_max", "T_P_max_s", TIME, false, T_P_max, "when that was"),
    {sizeof(ovr_extreme), "film_Rq_max", "film_Rq_max_m",
     "largest root mean square of the film about its mean in |x| < 3/4 b, over "
     "the run",
     OVR_KIND_HEIGHT, false, offsetof(ovr_statistics, film_Rq),
     OVR_PHYSICS_FEATURES},
    ROW("load_error_max", NULL, NUMBER, true, load_error,
        "load error of largest magnitude over the run, relative to the "
        "nominal load"),
    ROW("T_load_error_max", "T_load_error_max_s", TIME, true, T_load_error,
        "when that was"),
    ROW("mu_slide_max", NULL, NUMBER, false, mu_slide,
        "coefficient of sliding friction of largest magnitude over the run"),
    ROW("T_mu_slide_max", "T_mu_slide_max_s", TIME, false, T_mu_slide,
        "when that was"),
    ROW("H_mean", "H_mean_m", HEIGHT, true, H_mean,
        "mean film thickness in |x| < 3/4 b, over the run"),
    ROW("mu_slide_mean", NULL, NUMBER, false, mu_slide_mean,
        "mean coefficient of sliding friction over the run"),
    ROW("power_in_mean", "power_in_mean_W_per_m", POWER, false, power_in_mean,
        "mean power that the surfaces put in, over the run"),
    HEAT("T_max_rise_mean", TEMPERATURE, T_rise_mean,
         "mean over the run of the largest rise in the film"),
    HEAT("T_1_max_rise_mean", TEMPERATURE, T_1_rise_mean,
         "mean over the run of the largest rise on surface 1"),
    HEAT("T_2_max_rise_mean", TEMPERATURE, T_2_rise_mean,
         "mean over the run of the largest rise on surface 2"),
    HEAT("T_max_rise", TEMPERATURE, T_rise,
         "largest rise of temperature in the film above the supply's, over the "
         "run"),
    HEAT("T_1_max_rise", TEMPERATURE, T_1_rise,
         "largest rise of temperature on surface 1 over the run"),
    HEAT("T_2_max_rise", TEMPERATURE, T_2_rise,
         "largest rise of temperature on surface 2 over the run"),
    HEAT("energy_defect_max", NUMBER, energy_defect,
         "heat that neither surfaces nor oil carry away, over what is made: of "
         "largest magnitude over the run")};

const ovr_extreme *ovr_extreme_at(size_t k)
{
    return k < sizeof table / sizeof *table ? &table[k] : NULL;
}

double ovr_extreme_value(const ovr_extreme *which, const ovr_statistics *from)
{
    if (!which || !from)
        return NAN;
    const char *at = (const char *)from + which->offset;
    if (which->offset >= from->size)
        return NAN; /* of an older caller, or none */
    return *(const double *)(const void *)at;
}
