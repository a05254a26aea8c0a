/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/stress_report.h"

#include <math.h>
#include <stdio.h>

/* Hardened bearing steel yields about here: above it an elastic stress is one
 * that the steel does not bear. */
static const double YIELD = 1.7e9;

static void put_stress(const char *name, double value, double ph)
{
    printf("%-17s %-12.4g", name, value);
    if (isfinite(ph))
        printf(" %.4g MPa", value * ph * 1e-6);
}

static void put_extreme(const char *name, const ovr_stress_extreme *e,
                        double ph)
{
    put_stress(name, e->value, ph);
    printf("  at X = %.4g, Z = %.4g, T = %.4g\n", e->X, e->Z, e->T);
}

/* The row from which at least `z` is counted. */
static size_t row_from(const ovr_material *m, double z)
{
    size_t j = 0;
    while (j + 1 < m->depths && m->z[j] < z * (1 - 1e-9))
        j++;
    return j;
}

static const char *side_of(const ovr_stress_report *r, double xi)
{
    if (!r->feature || xi == 0 || r->direction == 0)
        return "";
    return (xi < 0) == (r->direction > 0) ? ", trailing side"
                                          : ", leading side";
}

static void put_lengths(const ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    const double depths[] = {r->least_depth, 0.05, 0.1};
    double last = 0;
    printf("%-17s", "equivalent length");
    for (size_t k = 0; k < 3; k++) {
        size_t j = row_from(m, depths[k]);
        if (m->z[j] <= last)
            continue;
        printf("%s %.4g b from Z = %.3g", last > 0 ? "," : "", r->length[j],
               m->z[j]);
        last = m->z[j];
    }
    puts(" down");
}

static void put_life(const ovr_stress_report *r, const ovr_setup *setup)
{
    const ovr_stress_setup *s = setup->stress;
    if (isfinite(r->life.equivalent_length))
        put_lengths(r);
    else
        printf("%-17s none: the smooth contact stays below the limit from Z = "
               "%.3g down\n",
               "equivalent length", r->least_depth);
    if (isfinite(r->life.utilisation))
        printf("%-17s %-12.4g of the limit %.4g ph (%s), from Z = %.3g down\n",
               "utilisation", r->life.utilisation, r->limit,
               ovr_criterion_name(s->criterion), r->least_depth);
    if (isfinite(r->ratio))
        printf("%-17s %-12.4g of the smooth raceway's, counted from Z = %.3g\n",
               "life", r->ratio, r->least_depth);
    printf("%-17s exponents %.4g, %.4g, %.4g and limit are conventions; "
           "elastic, a groove\n",
           "", s->life.exponent, s->life.depth_exponent, s->life.weibull);
}

static void put_traction(const ovr_stress_report *r)
{
    printf("%-17s %s%s\n", "traction",
           r->traction ? "the film's shear stress" : "none: ",
           r->traction ? "" : r->no_traction);
}

void cli_put_stress(const ovr_stress_report *r, const ovr_setup *setup)
{
    double ph = setup->contact->ph;
    printf("below surface %d, from Z = %.4g (%.3g meshes) down:\n", r->surface,
           r->least_depth, r->least_depth / setup->mesh);
    put_extreme("largest shear", &r->max_shear, ph);
    put_extreme("von Mises", &r->von_mises, ph);
    put_stress("shear circle R", r->R_max, ph);
    printf("  at xi = %.4g%s, Z = %.4g; smooth %.4g\n", r->xi_R_max,
           side_of(r, r->xi_R_max), r->Z_R_max, r->R_smooth);
    put_traction(r);
    if (r->fatigue)
        put_life(r, setup);
    if (r->von_mises.value * ph > YIELD)
        printf("%-17s von Mises above %.2g GPa is beyond yield of bearing "
               "steel: it would flatten\n",
               "", YIELD * 1e-9);
    if (r->incomplete)
        printf("%-17s %zu of %zu material points are cut by an end of the run "
               "and not counted\n",
               "", r->incomplete, r->material.points);
}

/* ------------------------------------------------------------------- JSON */

static void json_extreme(json_writer *json, const char *name,
                         const ovr_stress_extreme *e, double ph)
{
    char key[64];
    json_number(json, name, e->value);
    snprintf(key, sizeof key, "X_%s", name);
    json_number(json, key, e->X);
    snprintf(key, sizeof key, "Z_%s", name);
    json_number(json, key, e->Z);
    snprintf(key, sizeof key, "T_%s", name);
    json_number(json, key, e->T);
    snprintf(key, sizeof key, "%s_Pa", name);
    json_number(json, key, e->value * ph);
}

static void json_life(json_writer *json, const ovr_stress_report *r,
                      const ovr_setup *setup)
{
    const ovr_material *m = &r->material;
    json_text(json, "criterion", ovr_criterion_name(setup->stress->criterion));
    json_number(json, "limit", r->limit);
    json_number(json, "equivalent_length", r->life.equivalent_length);
    json_number(json, "equivalent_length_m",
                r->life.equivalent_length * setup->contact->b);
    json_number(json, "utilisation", r->life.utilisation);
    json_number(json, "life_ratio", r->ratio);
    json_number(json, "risk_smooth", r->life.smooth_risk);
    json_open_array(json, "equivalent_lengths");
    for (size_t j = 0; j < m->depths; j++) {
        json_open(json, NULL);
        json_number(json, "depth", m->z[j]);
        json_number(json, "equivalent_length", r->length[j]);
        json_close(json);
    }
    json_close_array(json);
}

void cli_json_stress(json_writer *json,
                     const ovr_stress_report *const report[2],
                     const ovr_setup *setup)
{
    const ovr_stress_report *a = report[0], *b = report[1];
    const ovr_stress_report *shear = a ? a : b, *circle = shear;
    double ph = setup->contact->ph;
    if (!shear)
        return;
    if (a && b && b->max_shear.value > a->max_shear.value)
        shear = b;
    if (a && b && b->R_max > a->R_max)
        circle = b;
    json_extreme(json, "tau_max", &shear->max_shear, ph);
    json_extreme(json, "von_mises_max", &shear->von_mises, ph);
    json_integer(json, "surface_tau_max", shear->surface);
    json_number(json, "R_max", circle->R_max);
    json_number(json, "xi_R_max", circle->xi_R_max);
    json_number(json, "Z_R_max", circle->Z_R_max);
    json_number(json, "R_max_Pa", circle->R_max * ph);
    json_number(json, "R_smooth", circle->R_smooth);
    json_integer(json, "surface_R_max", circle->surface);
    json_number(json, "least_depth", circle->least_depth);
    json_flag(json, "traction", circle->traction);
    json_integer(json, "material_points", (long long)circle->material.points);
    json_integer(json, "material_incomplete", (long long)circle->incomplete);
    if (circle->fatigue)
        json_life(json, circle, setup);
}
