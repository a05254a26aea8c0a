/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Warnings about a case before it is solved, such as a grid that is too coarse
 * for its features. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/domain.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/curvature.h"
#include "contact/starvation.h"
#include "elements/run_element.h"
#include "physics/stress/stress.h"
#include "physics/supply/supply.h"
#include "run/internal.h"
#include "run/review.h"
#include "run/summary_lines.h"
#include "surface/surfaces.h"

/* ------------------------------------------------------------------- Domain */

/* Warnings and notes about the ends of the domain. */

/* A loss as text, "some 0.54 %"; the formula for the loss is valid up to 20
 * %. */
typedef struct share {
    char text[40];
} share;

static share share_of(double loss)
{
    share s = {"more than a fifth"};
    if (loss < 0.2)
        snprintf(s.text, sizeof s.text, "some %.2g %%", 100 * loss);
    return s;
}

/* Rounds |X| up to four digits. */
static double rounded_out(double X)
{
    double digit = pow(10, floor(log10(fabs(X))) - 3);
    return copysign(ceil(fabs(X) / digit * (1 - 1e-12)) * digit, X);
}

static bool is_usual(const ovr_review *r, const char *key)
{
    const ovr_slot *slot = ovr_slot_of(r->setup->resolved, "domain", key);
    return slot->word && slot->number == 0;
}

static void warn_of_kept_inlet(const ovr_review *r,
                               const ovr_domain_needs *needs)
{
    ovr_review_add(r, OVR_MESSAGE_WARNING,
                   "a feature starts upstream of X = %.4g and keeps the inlet "
                   "boundary there, so that the central film thickness is %s "
                   "too low; start the feature upstream of X = %.4g",
                   r->setup->options->inlet, share_of(needs->loss).text,
                   r->setup->resolved->inlet_kept);
}

/* Warns if the given inlet boundary is too close. A starved inlet is judged by
 * the position of the meniscus (ovr_review_inlet). */
static void warn_of_near_inlet(const ovr_review *r,
                               const ovr_domain_needs *needs)
{
    if (!ovr_setup_supply(r->setup)->film &&
        needs->loss > 1.01 * OVR_USUAL_LOSS)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "film thickness is too low because the inlet boundary X = %.4g is "
            "too close (error %s); set domain.inlet = %.4g",
            r->setup->options->inlet, share_of(needs->loss).text,
            rounded_out(needs->inlet));
}

static void warn_of_near_outlet(const ovr_review *r,
                                const ovr_domain_needs *needs)
{
    const ovr_options *o = r->setup->options;
    if (!is_usual(r, "outlet") && o->outlet < needs->film_end)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "the outlet boundary X = %.4g cuts off part of the film, which "
            "extends to X = %.4g; set domain.outlet = %.4g",
            o->outlet, needs->film_end, rounded_out(needs->outlet));
}

static void review_domain(const ovr_review *r)
{
    ovr_domain_needs needs = ovr_setup_needs(r->setup);
    if (r->setup->resolved->inlet_kept < 0 && needs.loss > OVR_USUAL_LOSS)
        warn_of_kept_inlet(r, &needs);
    else if (!is_usual(r, "inlet"))
        warn_of_near_inlet(r, &needs);
    warn_of_near_outlet(r, &needs);
}

void ovr_review_inlet(const ovr_review *r, const ovr_state *state, double H_cen)
{
    ovr_domain_needs needs = ovr_setup_needs(r->setup);
    if (needs.loss <= 1.01 * OVR_USUAL_LOSS)
        return;
    ovr_review_add(r, OVR_MESSAGE_WARNING,
                   "film thickness is too low because the inlet boundary X = "
                   "%.3g is too close: the gap there is only %.1f times the "
                   "central film thickness (error %s); set domain.inlet = %.4g",
                   state->X[0], state->H[0] / H_cen, share_of(needs.loss).text,
                   rounded_out(needs.inlet));
}

/* -------------------------------------------------------- Plausible numbers */

typedef struct usual {
    const char *what, *unit;
    double value, scale;     /* in the unit */
    double minimum, maximum; /* usual range in the unit */
} usual;

static void check_range(const usual *u, ovr_listener *say, void *data)
{
    double value = u->value / u->scale;
    if (!isfinite(value) || (value >= u->minimum && value <= u->maximum))
        return;
    ovr_warn(say, data,
             "%s = %.4g %s is outside the usual range of %g to %g %s; check "
             "the unit",
             u->what, value, u->unit, u->minimum, u->maximum, u->unit);
}

/* Warns of unusual values. The ranges include rubber and tungsten carbide on
 * diamond, wires and mill rolls, refrigerants and grease base oils. */
static void review_contact(const ovr_setup *s, ovr_listener *say, void *data)
{
    const ovr_contact *c = s->contact;
    bool stiffens = s->lubricant->viscosity_law != OVR_ISOVISCOUS;
    const usual all[] = {
        {"modulus", "GPa", c->modulus, 1e9, 1, 1000},
        {"radius", "mm", c->radius, 1e-3, 0.1, 2000},
        {"load", "kN/m", c->load, 1e3, 1, 20000},
        {"viscosity", "Pa.s", c->viscosity, 1, 1e-4, 20},
        {"alpha", "1/GPa", stiffens ? c->alpha : NAN, 1e-9, 3, 60}};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        check_range(&all[k], say, data);
}

/* Warns if the half-width is not small compared with the radius: the parabola
 * and half-space approximations then fail. */
static void review_width(const ovr_setup *s, ovr_listener *say, void *data)
{
    const double widest = 0.3;
    const ovr_resolved *r = s->resolved;
    const ovr_contact *c = s->contact;
    double radius = c->radius;
    for (int k = 0; k < 2; k++)
        if (isfinite(r->body[k].radius))
            radius = fmin(radius, fabs(r->body[k].radius));
    if (c->b > widest * radius)
        ovr_warn(say, data,
                 "the contact is %.4g mm wide at a radius of %.4g mm, which is "
                 "beyond the model: parabolic gaps and elastic half-spaces are "
                 "valid up to a half-width of 0.3 radii",
                 2e3 * c->b, 1e3 * radius);
}

static void review_feature(const ovr_setup *s, const ovr_feature_form *f,
                           ovr_listener *say, void *data)
{
    const double steepest = 0.25;
    char what[80];
    double size = isfinite(f->width) ? f->width : f->width_half;
    double width = size * s->contact->b;
    double depth = f->depth * s->contact->height;
    snprintf(what, sizeof what, "feature '%.40s': width", f->name);
    check_range(&(usual){what, "um", width, 1e-6, 0.1, 1e5}, say, data);
    if (f->shape != OVR_INDENT || !(depth > steepest * width))
        return;
    ovr_warn(say, data,
             "feature '%.40s': %.3g um deep and %.3g um wide is implausible; "
             "depths of indents are usually 0.001 to 0.1 of their width and "
             "below 0.25 of it",
             f->name, depth * 1e6, width * 1e6);
}

static void review_plausible(const ovr_setup *setup, ovr_listener *say,
                             void *data)
{
    if (!say)
        return;
    review_contact(setup, say, data);
    review_width(setup, say, data);
    for (size_t k = 0; k < setup->features; k++)
        review_feature(setup, setup->feature[k], say, data);
}

/* ------------------------------------------------------------------- Review */

/* Nodes per wavelength with little damping: second-order schemes damp a wave of
 * eight mesh sizes by a few per cent (0.25 b at level 6 is 20 mesh sizes: 3.6
 * %). */
static const double MESHES_A_WAVE = 10;

/* Prints notes on how profiles were read and filtered. */
static void note_assumptions(const ovr_review *r)
{
    const ovr_surfaces *surfaces = r->setup->surfaces;
    size_t n = surfaces ? ovr_surfaces_count(surfaces) : 0;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(surfaces, k);
        for (const char *s = info.assumed; *s;) {
            int size = (int)strcspn(s, "\n");
            ovr_review_add(r, OVR_MESSAGE_NOTE, "feature '%s': %.*s", info.name,
                           size, s);
            s += size + (s[size] == '\n');
        }
    }
}

/* Notes properties that were estimated from the viscosity. Film thickness
 * varies with about the square root of alpha. */
static void note_estimates(const ovr_review *r)
{
    const ovr_resolved *resolved = r->setup->resolved;
    if (!resolved->values.oil.mineral || !resolved->alpha_estimated)
        return;
    ovr_review_add(r, OVR_MESSAGE_NOTE,
                   "alpha = %.3g 1/GPa is an estimate from the viscosity "
                   "(Roelands' relation, z = 0.68); measured values are 0.6 to "
                   "1 times this, lower for synthetic oils, and film thickness "
                   "is about proportional to sqrt(alpha)",
                   1e9 * r->setup->contact->alpha);
}

/* Notes keys that have no effect but are allowed. */
static void note_ineffective(const ovr_review *r)
{
    ovr_idle idle;
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        for (size_t k = 0; k < b->count; k++) {
            const ovr_slot *slot = &b->slots[k];
            char line[24] = "";
            if (!ovr_key_idle(r->c, b, slot, &idle) ||
                (slot->stored && !slot->line))
                continue;
            if (slot->line)
                snprintf(line, sizeof line, ":%ld", slot->line);
            ovr_review_add(r, OVR_MESSAGE_NOTE, "%s%s: %s %s", slot->file, line,
                           slot->key, idle.text);
        }
}

/* Notes requested fields that are not stored. */
static void note_omitted_fields(const ovr_review *r)
{
    const ovr_physics *off = NULL;
    unsigned none = ovr_resolved_no_fields(r->setup->resolved, &off);
    if (none & ~r->setup->output->fields)
        ovr_review_add(r, OVR_MESSAGE_NOTE,
                       "output.fields: %s are not stored, because [%s] "
                       "is off",
                       off->in_case->own_fields->are,
                       off->in_case->section->name);
}

/* Warns that a run from rest or without load starts at a small speed or
 * load. */
static void warn_of_start(const ovr_review *r)
{
    if (fabs(ovr_history_value(r->setup->speed, 0)) < OVR_MIN_START)
        ovr_review_add(r, OVR_MESSAGE_WARNING,
                       "the run starts from rest without a film; the initial "
                       "film thickness is that of %g of the reference speed",
                       OVR_MIN_START);
    if (ovr_history_value(r->setup->load, 0) < OVR_MIN_START)
        ovr_review_add(r, OVR_MESSAGE_WARNING,
                       "the run starts without load; the initial film "
                       "thickness is that of %g of the reference load",
                       OVR_MIN_START);
}

/* Warns if upstream schemes smear out moving features with few nodes. Below
 * this number of nodes per width the characteristic scheme is clearly better
 * (at 160 hardly, at 130 in P). */
static void warn_of_smearing(const ovr_review *r)
{
    const double enough = 150;
    const ovr_setup *s = r->setup;
    size_t n = ovr_surfaces_count(s->surfaces);
    if (!s->transient || s->options->scheme == OVR_CHARACTERISTIC)
        return;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(s->surfaces, k);
        double nodes = info.wavelength / s->mesh;
        if (info.speed == 0 || !(nodes < enough))
            continue;
        ovr_review_add(r, OVR_MESSAGE_WARNING,
                       "feature '%s' has only %.0f nodes per width; upstream "
                       "schemes smear it out. Use scheme = characteristic with "
                       "step = grid, or level %d",
                       info.name, nodes,
                       s->options->level + (int)ceil(log2(enough / nodes)));
        return;
    }
}

static ovr_feature_info finest_feature(const ovr_surfaces *surfaces)
{
    size_t n = ovr_surfaces_count(surfaces);
    ovr_feature_info finest = ovr_surfaces_info(surfaces, 0);
    for (size_t k = 1; k < n; k++)
        if (ovr_surfaces_info(surfaces, k).wavelength < finest.wavelength)
            finest = ovr_surfaces_info(surfaces, k);
    return finest;
}

static void warn_of_features(const ovr_review *r, bool transient)
{
    const ovr_surfaces *surfaces = r->setup->surfaces;
    const ovr_options *options = r->setup->options;
    double D = r->setup->mesh;
    ovr_feature_info finest = finest_feature(surfaces);
    double wave = finest.wavelength;
    const char *inside;
    if (wave < MESHES_A_WAVE * D)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "the grid is too coarse: the %s wavelength %.3g of feature '%s' "
            "has only %.1f mesh sizes; use level %d",
            finest.wavelength_is, wave, finest.name, wave / D,
            options->level + (int)ceil(log2(MESHES_A_WAVE * D / wave)));
    warn_of_smearing(r);
    inside = ovr_surfaces_inside(surfaces, options->inlet, options->outlet);
    if (inside && transient)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "feature '%s' starts inside the domain and is part of the steady "
            "solution; start it upstream of the inlet X = %.3g, or set "
            "feature.grow",
            inside, options->inlet);
}

/* Warns of random features with the same seed, which have the same heights up
 * to a factor. */
static void warn_of_seeds(const ovr_review *r)
{
    const ovr_resolved *resolved = r->setup->resolved;
    for (size_t j = 0; j < resolved->features; j++)
        for (size_t k = 0; k < j; k++) {
            const ovr_feature_form *a = resolved->feature[k];
            const ovr_feature_form *b = resolved->feature[j];
            if (a->shape != OVR_ROUGHNESS || b->shape != OVR_ROUGHNESS ||
                a->surface == b->surface ||
                a->roughness->seed != b->roughness->seed)
                continue;
            ovr_review_add(
                r, OVR_MESSAGE_WARNING,
                "surfaces 1 and 2 have the same roughness heights: features "
                "'%s' and '%s' both have seed = %d; set feature.%s.seed to "
                "another number or remove it",
                a->name, b->name, a->roughness->seed, b->name);
            return;
        }
}

/* Warns of time histories in a steady solution. */
static void warn_of_histories(const ovr_review *r)
{
    static const char *const sections[] = {"load",   "speed",    "sliding",
                                           "radius", "radius_1", "supply"};
    for (size_t k = 0; k < sizeof sections / sizeof *sections; k++) {
        const ovr_block *block = ovr_case_find_block(r->c, sections[k], NULL);
        const ovr_slot *how = block ? ovr_block_get(block, "history") : NULL;
        if (how && how->given && strcmp(how->text, "constant") != 0)
            ovr_review_add(
                r, OVR_MESSAGE_WARNING,
                "[%s] history = %s has no effect in a steady solution, which "
                "uses the value at T = 0; set time.end for a transient run",
                sections[k], how->text);
    }
}

/* Computes the range low..high of a feature and its copies at T. */
static void reach(const ovr_surfaces *surfaces, size_t k, double T, double *low,
                  double *high)
{
    ovr_feature_info f = ovr_surfaces_info(surfaces, k);
    double centre = ovr_surfaces_centre(surfaces, k, T);
    *low = centre - f.behind - (f.speed < 0 ? 0 : f.last);
    *high = centre + f.ahead + (f.speed < 0 ? f.last : 0);
}

/* Warns of moving features. A steady solution omits them, or holds those that
 * are inside the domain at T = 0. */
static void warn_of_left_out(const ovr_review *r)
{
    const ovr_options *o = r->setup->options;
    size_t n = ovr_surfaces_count(r->setup->surfaces);
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(r->setup->surfaces, k);
        double low, high;
        if (info.speed == 0 || info.uniform)
            continue;
        reach(r->setup->surfaces, k, 0, &low, &high);
        bool inside = !info.grows && high > o->inlet + 1e-9 &&
                      low < o->outlet - 1e-9;
        ovr_review_add(
            r, OVR_MESSAGE_WARNING, "feature '%s' moves and %s; %s", info.name,
            inside ? "is held where it is at T = 0 in a steady solution"
                   : "is left out of a steady solution",
            r->setup->transient ? "use overroll run"
                                : "set time.end, for example to auto");
    }
}

/* Returns "-2 <= X <= 1.5", or one inequality if the other end is infinite. */
static ovr_words range_of(double low, double high)
{
    ovr_words w = {""};
    if (isfinite(low) && isfinite(high))
        ovr_words_add(&w, "%.4g <= X <= %.4g", low, high);
    else if (isfinite(high))
        ovr_words_add(&w, "X <= %.4g", high);
    else
        ovr_words_add(&w, "X >= %.4g", low);
    return w;
}

/* Warns of features that do not move from `low` at T = 0 to `high` at the end,
 * so that stress histories are incomplete. */
static void warn_of_material_history(const ovr_review *r, size_t k)
{
    const ovr_options *o = r->setup->options;
    ovr_feature_info f = ovr_surfaces_info(r->setup->surfaces, k);
    double end = r->setup->march->end, low, high, a, b;
    reach(r->setup->surfaces, k, 0, &low, &high);
    reach(r->setup->surfaces, k, end, &a, &b);
    if (fmax(high, b) < o->inlet || fmin(low, a) > o->outlet)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "feature '%s' is at %s when the run ends at T = %.4g and never "
            "reaches the domain, X = %.4g to %.4g",
            f.name, range_of(a, b).text, end, o->inlet, o->outlet);
    else if (f.speed != 0 && isfinite(f.last) && isfinite(a) && isfinite(b) &&
             a < o->outlet && b > o->inlet)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "feature '%s' has not left when the run ends at T = %.4g: it is at "
            "%.4g <= X <= %.4g",
            f.name, end, a, b);
}

static void warn_of_time(const ovr_review *r)
{
    const ovr_march *march = r->setup->march;
    const ovr_surfaces *surfaces = r->setup->surfaces;
    double dT = ovr_setup_step(r->setup);
    size_t n = surfaces ? ovr_surfaces_count(surfaces) : 0;
    if (march->end < 0.999 * dT)
        ovr_review_add(r, OVR_MESSAGE_WARNING,
                       "the end T = %.3g is shorter than one step, %.3g",
                       march->end, dT);
    for (size_t k = 0; k < n; k++)
        warn_of_material_history(r, k);
}

static void warn_of_sliding(const ovr_review *r)
{
    const ovr_contact *contact = r->setup->contact;
    double slip = contact->u1_ratio - contact->u2_ratio;
    if (fabs(slip) > 2 * (1 + 1e-12))
        ovr_review_add(r, OVR_MESSAGE_WARNING,
                       "opposite sliding: the surfaces move in opposite "
                       "directions, because slide_to_roll %.4g is beyond +-2",
                       slip);
}

/* Notes an automatically chosen level if it is the finest allowed. */
static void note_level(const ovr_review *r)
{
    const ovr_setup *s = r->setup;
    const double rounding = 1.05; /* printed numbers are rounded */
    if (s->accuracy > 0 && s->expected > rounding * s->accuracy)
        ovr_review_add(
            r, OVR_MESSAGE_WARNING,
            "level = %s uses at most level %d, whose expected error is %.2g "
            "instead of %.2g",
            s->confirm ? "auto" : "usual", s->options->level, s->expected,
            s->accuracy);
}

static void before(const ovr_review *r, bool transient)
{
    note_estimates(r);
    review_plausible(r->setup, r->say, r->data);
    ovr_review_element(r->setup, r->say, r->data);
    note_ineffective(r);
    note_omitted_fields(r);
    warn_of_start(r);
    warn_of_sliding(r);
    review_domain(r);
    note_level(r);
    ovr_companions_predict(r->setup, r->say, r->data);
    warn_of_seeds(r);
    if (r->setup->surfaces)
        warn_of_features(r, transient);
    if (r->setup->surfaces && !transient)
        warn_of_left_out(r);
    if (!transient)
        warn_of_histories(r);
    if (transient)
        warn_of_time(r);
}

void ovr_setup_review(const ovr_setup *setup, ovr_listener *listener,
                      void *data)
{
    if (!setup)
        return;
    ovr_review r = {setup->resolved->c, setup, listener, data};
    before(&r, setup->transient);
}

void ovr_run_review_before(ovr_run *run)
{
    ovr_review r = {run->c, run->setup, ovr_run_message, run};
    note_assumptions(&r);
    before(&r, run->info.transient);
    if (run->how.steady && ovr_setup_stress(run->setup)->surfaces)
        ovr_review_add(&r, OVR_MESSAGE_NOTE,
                       "[stress] is ignored by a steady solution; 'overroll "
                       "run' prints the stresses");
}
