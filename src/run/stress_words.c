/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/stress_words.h"
#include "stress/stress.h"

#include <math.h>

/* Hardened bearing steel yields about here: above it an elastic stress is one
 * that the steel does not bear. */
static const double YIELD = 1.7e9;

/* With what stands behind it. */
static void say_stress(const ovr_told *to, const char *label, double value,
                       double ph, const char *behind)
{
    ovr_words si = {""};
    if (isfinite(ph))
        ovr_words_add(&si, "%.4g MPa", value * ph * 1e-6);
    ovr_tell_number(to, label, 4, value, "%s  %s", si.text, behind);
}

static void say_extreme(const ovr_told *to, const char *label,
                        const ovr_stress_extreme *e, double ph)
{
    ovr_words at = {""};
    ovr_words_add(&at, "at X = %.4g, Z = %.4g, T = %.4g", e->X, e->Z, e->T);
    say_stress(to, label, e->value, ph, at.text);
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

static void say_circle(const ovr_told *to, const ovr_stress_report *r,
                       double ph)
{
    ovr_words at = {""};
    ovr_words_add(&at, "at xi = %.4g%s, Z = %.4g; smooth %.4g", r->xi_R_max,
                  side_of(r, r->xi_R_max), r->Z_R_max, r->R_smooth);
    say_stress(to, "shear circle R", r->R_max, ph, at.text);
}

static void say_lengths(const ovr_told *to, const ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    const double depths[] = {r->least_depth, 0.05, 0.1};
    ovr_words w = {""};
    double last = 0;
    for (size_t k = 0; k < 3; k++) {
        size_t j = row_from(m, depths[k]);
        if (m->z[j] <= last)
            continue;
        ovr_words_add(&w, "%s%.4g b from Z = %.3g", last > 0 ? ", " : "",
                      r->length[j], m->z[j]);
        last = m->z[j];
    }
    ovr_tell(to, "equivalent length", "%s down", w.text);
}

/* Features add to the risk: where it is less than the smooth contact's, what
 * they do is lost in the error. */
static bool has_effect(const ovr_stress_report *r)
{
    return !(r->life->equivalent_length < 0) && !(r->ratio > 1);
}

static void say_life(const ovr_told *to, const ovr_stress_report *r,
                     const ovr_stress_setup *s)
{
    if (!has_effect(r))
        ovr_tell(to, "equivalent length",
                 "no effect beyond the error of the method, %.2g b from Z = "
                 "%.3g down",
                 fmax(r->length_error, -r->life->equivalent_length),
                 r->least_depth);
    else if (isfinite(r->life->equivalent_length))
        say_lengths(to, r);
    else
        ovr_tell(to, "equivalent length",
                 "none: the smooth contact stays below the limit from Z = %.3g "
                 "down",
                 r->least_depth);
    if (isfinite(r->life->utilisation))
        ovr_tell_number(to, "utilisation", 4, r->life->utilisation,
                        "of the limit %.4g ph (%s), from Z = %.3g down; at "
                        "Z = %.3g",
                        r->limit, ovr_criterion_name(s->criterion),
                        r->least_depth, r->life->used_z);
    if (isfinite(r->ratio) && has_effect(r))
        ovr_tell_number(to, "life", 4, r->ratio,
                        "of the smooth raceway's, counted from Z = %.3g",
                        r->least_depth);
    ovr_tell(to, "",
             "exponents %.4g, %.4g, %.4g and limit are conventions; elastic, a "
             "groove",
             s->life->exponent, s->life->depth_exponent, s->life->weibull);
}

void ovr_say_stress(const ovr_told *to, const ovr_stress_report *r,
                    const ovr_setup *setup)
{
    double ph = setup->contact->ph;
    ovr_tell_title(to, "below surface %d, from Z = %.4g (%.3g meshes) down:",
                   r->surface, r->least_depth, r->least_depth / setup->mesh);
    if (r->none) {
        ovr_tell(to, "stresses", "not told: %s", r->none);
        return;
    }
    say_extreme(to, "largest shear", &r->max_shear, ph);
    say_extreme(to, "von Mises", &r->von_mises, ph);
    if (!isnan(r->layer_von_mises.value)) {
        say_extreme(to, "von Mises in a layer", &r->layer_von_mises, ph);
        say_extreme(to, "shear of an interface", &r->interface_shear, ph);
        say_extreme(to, "tension across one", &r->interface_tension, ph);
        say_extreme(to, "tension at the top", &r->surface_tension, ph);
        if (!isnan(r->layer_utilisation))
            ovr_tell_number(to, "layers use", 4, r->layer_utilisation,
                            "of their own yield, at most");
    }
    say_circle(to, r, ph);
    ovr_tell(to, "traction", "%s%s",
             r->traction ? "the film's shear stress" : "none: ",
             r->traction ? "" : r->no_traction);
    if (r->fatigue)
        say_life(to, r, setup->stress);
    if (r->von_mises.value * ph > YIELD)
        ovr_tell(
            to, "",
            "von Mises above %.2g GPa is beyond yield of bearing steel: it "
            "would flatten",
            YIELD * 1e-9);
    if (r->incomplete)
        ovr_tell(to, "",
                 "%zu of %zu material points are cut by an end of the run and "
                 "not counted",
                 r->incomplete, r->material.points);
}
