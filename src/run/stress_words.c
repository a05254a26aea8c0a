/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/stress_words.h"
#include "run/forms.h"
#include "stress/stress.h"

#include <math.h>

/* Hardened bearing steel yields about here: above it an elastic stress is one
 * that the steel does not bear. */
static const double YIELD = 1.7e9;

/* Says a stress with the words behind it. */
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

static void say_tension(const ovr_told *to, const char *label,
                        const ovr_stress_extreme *e, double ph)
{
    if (e->value > 0)
        say_extreme(to, label, e, ph);
    else
        ovr_tell(to, label, "none, it is pressed together everywhere");
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
             s->life.exponent, s->life.depth_exponent, s->life.weibull);
}

/* What counts is how deep the material yields, not how far above Y its largest
 * stress is: a skin thinner than this moves nanometres, hardened or not. */
static const double SKIN = 0.02;

static void say_whether(const ovr_told *to, const ovr_stress_report *r,
                        bool rough)
{
    if (r->of_shakedown > 1)
        ovr_tell(to, "",
                 "plastic strain matters: the smooth contact is above its "
                 "shakedown limit, and flows at every pass");
    else if (r->of_first_yield > 1)
        ovr_tell(to, "",
                 "plastic strain matters: the smooth contact yields by itself, "
                 "and shakes down in its first passes");
    else if (r->yielding_depth >= SKIN)
        ovr_tell(to, "",
                 "plastic strain matters: the material is beyond yield down to "
                 "Z = %.3g",
                 r->yielding_depth);
    else if (r->yielding_depth > 0)
        ovr_tell(to, "",
                 "plastic strain does not matter: only a skin of Z = %.3g is "
                 "beyond yield",
                 r->yielding_depth);
    else if (rough && r->material.z[0] > SKIN)
        ovr_tell(to, "",
                 "plastic strain matters in a skin at most, which a finer mesh "
                 "tells: nothing is beyond yield from Z = %.3g down",
                 r->material.z[0]);
    else
        ovr_tell(to, "",
                 "plastic strain does not matter: nothing is beyond yield from "
                 "Z = %.3g down",
                 r->material.z[0]);
}

static void say_yield(const ovr_told *to, const ovr_stress_report *r,
                      const ovr_setup *setup)
{
    double ph = setup->contact->ph;
    const ovr_stress_extreme *f = &r->yield_ratio, *strip = &r->strip;
    ovr_words Y = {""};
    ovr_words_add(&Y, "%.4g ph", r->yield);
    if (isfinite(ph))
        ovr_words_add(&Y, " = %.4g MPa", r->yield * ph * 1e-6);
    ovr_tell_number(to, "beyond yield", 4, f->value,
                    "f/Y: von Mises over Y = %s, less 1; at X = %.4g, "
                    "Z = %.4g, T = %.4g",
                    Y.text, f->X, f->Z, f->T);
    ovr_tell_number(to, "yielding", 3, 100 * r->yielding_share,
                    "%% of the material points from Z = %.4g down",
                    r->least_depth);
    ovr_tell_number(to, "strip of pressure", 4, strip->value,
                    "(P - P around)/(2.97 Y), %.3g b wide at X = %.4g, "
                    "T = %.4g",
                    strip->Z, strip->X, strip->T);
    ovr_tell_number(to, "smooth contact", 4, r->of_first_yield,
                    "of the ph of first yield, %.4g of that of shakedown",
                    r->of_shakedown);
    say_whether(to, r, setup->features > 0);
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
        say_tension(to, "tension across one", &r->interface_tension, ph);
        say_tension(to, "tension at the top", &r->surface_tension, ph);
        if (!isnan(r->layer_utilisation))
            ovr_tell_number(to, "layers use", 4, r->layer_utilisation,
                            "of their own yield, at most");
        if (!isnan(r->layer_fatigue))
            ovr_tell_number(to, "layers use", 4, r->layer_fatigue,
                            "of their own fatigue limit, at most");
        if (!isnan(r->interface_utilisation))
            ovr_tell_number(to, "interfaces use", 4, r->interface_utilisation,
                            "of their strength, at most");
    }
    say_circle(to, r, ph);
    ovr_tell(to, "traction", "%s%s",
             r->traction ? "the film's shear stress" : "none: ",
             r->traction ? "" : r->no_traction);
    if (r->fatigue)
        say_life(to, r, ovr_setup_stress(setup));
    if (!isnan(r->yield))
        say_yield(to, r, setup);
    else if (r->von_mises.value * ph > YIELD)
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
