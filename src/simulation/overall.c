/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The extremes over a whole run: kept step by step, and their list. */
#include <math.h>
#include <stddef.h>

#include "simulation/physics.h"

void ovr_statistics_take(ovr_statistics *s, const ovr_observation *o,
                         bool first)
{
    if (first || o->H_min_located < s->H_min) {
        s->H_min = o->H_min_located;
        s->X_H_min = o->X_min_located;
        s->T_H_min = o->T;
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
