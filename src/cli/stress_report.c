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

/* Features add to the risk: where it is less than the smooth contact's, what
 * they do is lost in the error. */
static bool has_effect(const ovr_stress_report *r)
{
    return !(r->life->equivalent_length < 0) && !(r->ratio > 1);
}

static void put_life(const ovr_stress_report *r, const ovr_setup *setup)
{
    const ovr_stress_setup *s = setup->stress;
    if (!has_effect(r))
        printf("%-17s no effect beyond the error of the method, %.2g b from "
               "Z = %.3g down\n",
               "equivalent length",
               fmax(r->length_error, -r->life->equivalent_length),
               r->least_depth);
    else if (isfinite(r->life->equivalent_length))
        put_lengths(r);
    else
        printf("%-17s none: the smooth contact stays below the limit from Z = "
               "%.3g down\n",
               "equivalent length", r->least_depth);
    if (isfinite(r->life->utilisation))
        printf("%-17s %-12.4g of the limit %.4g ph (%s), from Z = %.3g down\n",
               "utilisation", r->life->utilisation, r->limit,
               ovr_criterion_name(s->criterion), r->least_depth);
    if (isfinite(r->ratio) && has_effect(r))
        printf("%-17s %-12.4g of the smooth raceway's, counted from Z = %.3g\n",
               "life", r->ratio, r->least_depth);
    printf("%-17s exponents %.4g, %.4g, %.4g and limit are conventions; "
           "elastic, a groove\n",
           "", s->life->exponent, s->life->depth_exponent, s->life->weibull);
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
    if (r->none) {
        printf("%-17s not told: %s\n", "stresses", r->none);
        return;
    }
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

void cli_json_lengths(json_writer *json,
                      const ovr_stress_report *const report[2])
{
    const ovr_stress_report *a = report[0], *b = report[1], *r = a ? a : b;
    if (a && b && b->R_max > a->R_max)
        r = b;
    if (!r || !r->fatigue)
        return;
    json_open_array(json, "equivalent_lengths");
    for (size_t j = 0; j < r->material.depths; j++) {
        json_open(json, NULL);
        json_number(json, "depth", r->material.z[j]);
        json_number(json, "equivalent_length", r->length[j]);
        json_close(json);
    }
    json_close_array(json);
}
