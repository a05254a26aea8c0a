/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Table of the stress quantities in summaries, reports and the group
 * fatigue/surface_N of result files. */
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "physics/stress/stress.h"
#include "run/summary_lines.h"
#include "stress/stress.h"

/* ------------------------------------------------------------- for programs */

static void add_named(const ovr_report_sink *to, const char *format,
                      const char *name, double value)
{
    char key[64];
    snprintf(key, sizeof key, format, name);
    ovr_put_number(to, key, value);
}

static void add_resolved(const ovr_report_sink *to, const char *key, double Z,
                         const ovr_stress_report *r)
{
    char name[64];
    snprintf(name, sizeof name, "%s_resolved", key);
    ovr_put(to, name, OVR_SUMMARY_FLAG, !(Z < r->unresolved_depth));
}

static void add_row(const ovr_report_sink *to, const ovr_stress_figure *row,
                    const ovr_stress_report *r, const ovr_contact *c)
{
    const ovr_stress_extreme e = ovr_stress_figure_of(row, r);
    if (row->form == OVR_FIGURE_SHARE && isnan(e.value))
        return;
    ovr_put_number(to, row->key, e.value);
    if (row->form >= OVR_FIGURE_MOMENT) {
        add_named(to, "X_%s", row->key, e.X);
        add_named(to, row->form == OVR_FIGURE_STRIP ? "width_%s" : "Z_%s",
                  row->key, e.Z);
        add_named(to, "T_%s", row->key, e.T);
    }
    if (row->form >= OVR_FIGURE_STRESS)
        add_resolved(to, row->key, e.Z, r);
    if (row->form == OVR_FIGURE_PRESSURE || row->form >= OVR_FIGURE_STRESS)
        add_named(to, "%s_Pa", row->key, e.value * c->ph);
    if (row->form == OVR_FIGURE_LENGTH)
        add_named(to, "%s_m", row->key, e.value * c->b);
}

static void add_part(const ovr_report_sink *to, ovr_stress_part part,
                     const ovr_stress_report *r, const ovr_contact *c)
{
    const ovr_stress_figure *row;
    for (size_t k = 0; (row = ovr_stress_figure_at(k)); k++)
        if (row->part == part)
            add_row(to, row, r, c);
}

/* Adds the numbers of the surface with the higher utilization of its layers. */
static void add_layers(const ovr_report_sink *to, const ovr_stress_report *a,
                       const ovr_stress_report *b, const ovr_contact *c)
{
    ovr_stress_report worse;
    if (a && b)
        worse = a->layer_von_mises.value > b->layer_von_mises.value ||
                        isnan(b->layer_von_mises.value)
                    ? *a
                    : *b;
    else if (a)
        worse = *a;
    else if (b)
        worse = *b;
    else
        return;
    if (isnan(worse.layer_von_mises.value))
        return;
    if (a && b) {
        worse.layer_utilisation = fmax(a->layer_utilisation,
                                       b->layer_utilisation);
        worse.layer_fatigue = fmax(a->layer_fatigue, b->layer_fatigue);
        worse.interface_utilisation = fmax(a->interface_utilisation,
                                           b->interface_utilisation);
    }
    add_part(to, OVR_STRESS_LAYERS, &worse, c);
}

/* Adds the numbers of the surface that exceeds its yield stress more, if one is
 * given. */
static void add_yield(const ovr_report_sink *to, const ovr_stress_report *a,
                      const ovr_stress_report *b, const ovr_contact *c)
{
    const ovr_stress_report *of = a ? a : b;
    if (a && b && !(a->yield_ratio.value > b->yield_ratio.value))
        of = isnan(b->yield) ? a : b;
    if (isnan(of->yield))
        return;
    ovr_put_count(to, "surface_yield", of->surface);
    add_part(to, OVR_STRESS_YIELD, of, c);
}

static void add_life(const ovr_report_sink *to, const ovr_stress_report *r,
                     const ovr_setup *setup)
{
    ovr_put_text(to, "criterion",
                 ovr_criterion_name(ovr_setup_stress(setup)->criterion));
    ovr_put_number(to, "limit", r->limit);
    ovr_put_both(to, "equivalent_length", "equivalent_length_m",
                 r->life->equivalent_length, setup->contact->b);
    ovr_put_number(to, "utilisation", r->life->utilisation);
    ovr_put_number(to, "life_ratio", r->ratio);
    ovr_put_number(to, "risk_smooth", r->life->smooth_risk);
}

/* Adds the numbers of both surfaces (NULL: none). */
static void add_numbers(const ovr_report_sink *to, const ovr_stress_report *a,
                        const ovr_stress_report *b, const ovr_setup *setup)
{
    const ovr_contact *c = setup->contact;
    const ovr_stress_report *shear = a ? a : b, *circle = shear;
    if (!shear)
        return;
    if (a && b && b->max_shear.value > a->max_shear.value)
        shear = b;
    if (a && b && b->R_max > a->R_max)
        circle = b;
    add_part(to, OVR_STRESS_BODY, shear, c);
    add_layers(to, a, b, c);
    add_yield(to, a, b, c);
    ovr_put_count(to, "surface_tau_max", shear->surface);
    add_part(to, OVR_STRESS_CIRCLE, circle, c);
    ovr_put_number(to, "R_max_Pa", circle->R_max * c->ph);
    add_resolved(to, "R_max", circle->Z_R_max, circle);
    ovr_put_number(to, "R_smooth", circle->R_smooth);
    ovr_put_count(to, "surface_R_max", circle->surface);
    ovr_put_number(to, "least_depth", circle->least_depth);
    ovr_put(to, "traction", OVR_SUMMARY_FLAG, circle->traction);
    ovr_put_count(to, "material_points", (double)circle->material.points);
    ovr_put_count(to, "material_incomplete", (double)circle->incomplete);
    if (circle->fatigue)
        add_life(to, circle, setup);
}

/* --------------------------------------------------------------- for people */

/* Approximate yield stress of hardened bearing steel, Pa. */
static const double YIELD = 1.7e9;

/* Unit, position and remark of a number; an unknown X leaves its column empty.
 */
__attribute__((format(printf, 3, 4))) static ovr_words
columns(const char *unit, double X, const char *format, ...)
{
    ovr_words w = {""};
    char at[16] = "", remark[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(remark, sizeof remark, format, arguments);
    va_end(arguments);
    if (isfinite(X))
        snprintf(at, sizeof at, "%.4g", X);
    ovr_words_add(&w, "%-11s %-10s (%s)", unit, at, remark);
    return w;
}

/* Prints a stress in p_h, with its value in MPa and a remark. */
static void report_stress(const ovr_report_sink *to, const char *label,
                          double value, double ph, double X, const char *remark)
{
    ovr_words si = {""};
    if (isfinite(ph))
        ovr_words_add(&si, "%.4g MPa; ", value * ph * 1e-6);
    ovr_report_number(to, label, 4, value, "%s",
                      columns("p_h", X, "%s%s", si.text, remark).text);
}

/* Prints the rows of a part. */
static void report_part(const ovr_report_sink *to, ovr_stress_part part,
                        const ovr_stress_report *r, double ph)
{
    const ovr_stress_figure *row;
    for (size_t k = 0; (row = ovr_stress_figure_at(k)); k++) {
        const ovr_stress_extreme e = ovr_stress_figure_of(row, r);
        ovr_words at = {""};
        if (row->part != part)
            continue;
        ovr_words_add(&at, "Z = %.4g, T = %.4g%s", e.Z, e.T,
                      e.Z < r->unresolved_depth ? "; not resolved" : "");
        if (row->form == OVR_FIGURE_SHARE && !isnan(e.value))
            ovr_report_number(to, row->label, 4, e.value, "%s",
                              columns("", NAN, "%s", row->words).text);
        else if (row->form == OVR_FIGURE_TENSION && !(e.value > 0))
            ovr_report_line(to, row->label, "none (compressive everywhere)");
        else if (row->form != OVR_FIGURE_SHARE)
            report_stress(to, row->label, e.value, ph, e.X, at.text);
    }
}

/* Index of the first depth of at least `z`. */
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

static void report_circle(const ovr_report_sink *to, const ovr_stress_report *r,
                          double ph)
{
    ovr_words at = {""};
    ovr_words_add(&at, "at xi = %.4g%s, Z = %.4g; smooth %.4g%s", r->xi_R_max,
                  side_of(r, r->xi_R_max), r->Z_R_max, r->R_smooth,
                  r->Z_R_max < r->unresolved_depth ? "; not resolved" : "");
    report_stress(to, "shear path radius R", r->R_max, ph, NAN, at.text);
}

static void report_lengths(const ovr_report_sink *to,
                           const ovr_stress_report *r)
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
    ovr_report_line(to, "equivalent raceway length", "%s downward", w.text);
}

/* Features increase the risk. If the risk is lower than the risk of the smooth
 * contact, their effect is smaller than the error. */
static bool has_effect(const ovr_stress_report *r)
{
    return !(r->life->equivalent_length < 0) && !(r->ratio > 1);
}

static void report_life(const ovr_report_sink *to, const ovr_stress_report *r,
                        const ovr_stress_setup *s)
{
    if (r->lifeless) {
        ovr_report_line(to, "life", "not given: %s", r->lifeless);
        return;
    }
    if (!has_effect(r))
        ovr_report_line(
            to, "equivalent raceway length",
            "below the error of the method, %.2g b from Z = %.3g downward",
            fmax(r->length_error, -r->life->equivalent_length), r->least_depth);
    else if (isfinite(r->life->equivalent_length))
        report_lengths(to, r);
    else
        ovr_report_line(
            to, "equivalent raceway length",
            "undefined: the smooth contact is below the fatigue limit from "
            "Z = %.3g downward",
            r->least_depth);
    if (isfinite(r->life->utilisation))
        ovr_report_number(to, "utilization of the fatigue limit", 4,
                          r->life->utilisation, "%s",
                          columns("", NAN,
                                  "limit %.4g p_h, %s; from Z = %.3g downward, "
                                  "at Z = %.3g",
                                  r->limit, ovr_criterion_name(s->criterion),
                                  r->least_depth, r->life->used_z)
                              .text);
    if (isfinite(r->ratio) && has_effect(r))
        ovr_report_number(
            to, "life ratio", 4, r->ratio, "%s",
            columns("", NAN,
                    "relative to the smooth raceway, from Z = %.3g downward",
                    r->least_depth)
                .text);
    ovr_report_line(
        to, "",
        "exponents %.4g, %.4g, %.4g and limit are conventions; elastic, "
        "plane strain",
        s->life.exponent, s->life.depth_exponent, s->life.weibull);
}

/* The depth to which the material yields counts, not the amount by which the
 * stress exceeds Y: a thinner layer deforms by nanometres only. */
static const double SKIN = 0.02;

static void report_shakedown(const ovr_report_sink *to,
                             const ovr_stress_report *r, bool rough)
{
    if (r->of_shakedown > 1)
        ovr_report_line(
            to, "",
            "plastic strain matters: the smooth contact exceeds its shakedown "
            "limit and deforms plastically in every pass");
    else if (r->of_first_yield > 1)
        ovr_report_line(
            to, "",
            "plastic strain matters: the smooth contact yields and shakes down "
            "in its first passes");
    else if (r->yielding_depth >= SKIN)
        ovr_report_line(
            to, "",
            "plastic strain matters: the stress exceeds yield down to Z = %.3g",
            r->yielding_depth);
    else if (r->yielding_depth > 0)
        ovr_report_line(
            to, "",
            "plastic strain is negligible: only a near-surface layer of "
            "Z = %.3g exceeds yield",
            r->yielding_depth);
    else if (rough && r->material.z[0] > SKIN)
        ovr_report_line(
            to, "",
            "plastic strain matters at most in a near-surface layer, which "
            "needs a finer grid: below yield from Z = %.3g downward",
            r->material.z[0]);
    else
        ovr_report_line(
            to, "",
            "plastic strain is negligible: below yield from Z = %.3g "
            "downward",
            r->material.z[0]);
}

static void report_yielding_share(const ovr_report_sink *to,
                                  const ovr_stress_report *r)
{
    if (isnan(r->yielding_share))
        ovr_report_line(
            to, "yielding volume share",
            "unknown: no material point passed the contact; use a later "
            "time.end");
    else
        ovr_report_number(
            to, "yielding volume share", 3, 100 * r->yielding_share, "%s",
            columns("%", NAN, "of the material points from Z = %.4g downward",
                    r->least_depth)
                .text);
}

static void report_yield(const ovr_report_sink *to, const ovr_stress_report *r,
                         const ovr_setup *setup)
{
    double ph = setup->contact->ph;
    const ovr_stress_extreme *f = &r->yield_ratio, *strip = &r->strip;
    ovr_words Y = {""};
    ovr_words_add(&Y, "%.4g ph", r->yield);
    if (isfinite(ph))
        ovr_words_add(&Y, " = %.4g MPa", r->yield * ph * 1e-6);
    ovr_report_number(to, "stress above yield, f/Y", 4, f->value, "%s",
                      columns("", f->X,
                              "von Mises stress / Y - 1, Y = %s; Z = %.4g, "
                              "T = %.4g",
                              Y.text, f->Z, f->T)
                          .text);
    report_yielding_share(to, r);
    ovr_report_number(to, "strip pressure ratio", 4, strip->value, "%s",
                      columns("", strip->X,
                              "(P - P around)/(2.97 Y); %.3g b wide, T = %.4g",
                              strip->Z, strip->T)
                          .text);
    ovr_report_number(
        to, "p_h / p_h at first yield", 4, r->of_first_yield, "%s",
        columns("", NAN,
                "smooth contact; %.4g of the p_h at the shakedown "
                "limit",
                r->of_shakedown)
            .text);
    report_shakedown(to, r, setup->features > 0);
}

static void report_surface(const ovr_report_sink *to,
                           const ovr_stress_report *r, const ovr_setup *setup)
{
    double ph = setup->contact->ph;
    ovr_report_title(to, "%s", "");
    ovr_report_title(
        to, "Stresses below surface %d, from Z = %.4g (%.3g D) downward",
        r->surface, r->least_depth, r->least_depth / setup->mesh);
    if (r->none) {
        ovr_report_line(to, "stresses", "not available: %s", r->none);
        return;
    }
    ovr_report_title(to, "%-*s %-12s %-11s %s", OVR_LABEL_WIDTH, "quantity",
                     "value", "in units", "at X = x/b");
    report_part(to, OVR_STRESS_BODY, r, ph);
    if (!isnan(r->layer_von_mises.value))
        report_part(to, OVR_STRESS_LAYERS, r, ph);
    if (!isnan(r->R_max))
        report_circle(to, r, ph);
    ovr_report_line(to, "traction", "%s%s",
                    r->traction ? "shear stress of the film" : "none: ",
                    r->traction ? "" : r->no_traction);
    if (r->fatigue)
        report_life(to, r, ovr_setup_stress(setup));
    if (!isnan(r->yield))
        report_yield(to, r, setup);
    else if (r->von_mises.value * ph > YIELD)
        ovr_report_line(
            to, "",
            "von Mises stress above %.2g GPa: bearing steel would deform "
            "plastically",
            YIELD * 1e-9);
    if (r->incomplete)
        ovr_report_line(
            to, "",
            "%zu of %zu material points are ignored, because the start or "
            "end of the run cuts their stress history",
            r->incomplete, r->material.points);
}

/* ---------------------------------------------------------- complete report */

void ovr_stress_summary(const ovr_stress_report *const report[2],
                        const ovr_setup *setup, ovr_summary_taker *take,
                        void *data)
{
    if (!report || !setup || !take)
        return;
    const ovr_report_sink to = {take, data};
    for (int k = 0; k < 2; k++)
        if (report[k])
            report_surface(&to, report[k], setup);
    add_numbers(&to, report[0], report[1], setup);
}

void ovr_stress_keys(const ovr_setup *setup, ovr_summary_taker *take,
                     void *data)
{
    const ovr_life_result life = {0};
    const ovr_stress_report report = {.fatigue = true, .life = &life};
    const ovr_report_sink to = {take, data};
    if (ovr_setup_stress(setup)->surfaces)
        add_numbers(&to, &report, NULL, setup);
}
