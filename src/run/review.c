/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a run beside its result: before the solve, of a grid too
 * coarse for its features and the like; after it, of a starved inlet. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "case/domain.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/curvature.h"
#include "contact/starvation.h"
#include "run/internal.h"
#include "run/review_element.h"
#include "run/review_plausible.h"
#include "simulation/internal.h"
#include "simulation/simulation.h"
#include "surface/surfaces.h"

typedef struct review {
    const ovr_case *c;
    const ovr_setup *setup;
    ovr_listener *say;
    void *data;
} review;

static void say(const review *r, ovr_say kind, const char *format, ...)
    OVR_PRINTF(3, 4);
static void say(const review *r, ovr_say kind, const char *format, ...)
{
    char text[OVR_MESSAGE_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (r->say)
        r->say(r->data, kind, text);
}

/* Second-order schemes carry a wave of eight meshes with a few per cent lost
 * (0.25 b at level 6 is 20 meshes, 3.6 %). */
static const double MESHES_A_WAVE = 10;

/* What was understood of profiles and done to them. */
static void say_assumed(const review *r)
{
    const ovr_surfaces *surfaces = r->setup->surfaces;
    size_t n = surfaces ? ovr_surfaces_count(surfaces) : 0;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(surfaces, k);
        for (const char *s = info.assumed; *s;) {
            int size = (int)strcspn(s, "\n");
            say(r, OVR_SAY_NOTE, "feature '%s': %.*s", info.name, size, s);
            s += size + (s[size] == '\n');
        }
    }
}

/* Estimated from the viscosity: films go with its square root or so. */
static void say_estimated(const review *r)
{
    const ovr_resolved *resolved = (const ovr_resolved *)r->setup;
    if (!resolved->values.oil.mineral || !resolved->alpha_estimated)
        return;
    say(r, OVR_SAY_NOTE,
        "alpha = %.3g 1/GPa is an estimate from the viscosity (Roelands' "
        "relation, z = 0.68): measured ones are 0.6 to 1 times that, the less "
        "for synthetic oils, and films go with about the square root",
        1e9 * r->setup->contact->alpha);
}

/* Keys given where they once belonged. */
static void say_moved(const review *r)
{
    for (size_t k = 0; k < ovr_case_entries(r->c); k++) {
        ovr_case_entry e = ovr_case_entry_at(r->c, k);
        if (e.before && e.line)
            say(r, OVR_SAY_NOTE,
                "%s:%ld: '%s' belongs in [%s] now, not in "
                "[%s]; it is taken",
                e.file, e.line, e.key, e.section, e.before);
        else if (e.before)
            say(r, OVR_SAY_NOTE, "%s: '%s.%s' is '%s.%s' now; it is taken",
                e.file, e.before, e.key, e.section, e.key);
    }
}

/* Keys without effect that are no reason to refuse the case. */
static void say_idle(const review *r)
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
            say(r, OVR_SAY_NOTE, "%s%s: %s %s", slot->file, line, slot->key,
                idle.text);
        }
}

/* A run from rest or from no load starts a little above either. */
static void warn_of_start(const review *r)
{
    if (fabs(ovr_history_value(r->setup->speed, 0)) < OVR_LEAST_START)
        say(r, OVR_SAY_WARNING,
            "the run starts from rest, where there is no film: the film at T "
            "= 0 is that of %g of the nominal speed",
            OVR_LEAST_START);
    if (ovr_history_value(r->setup->load, 0) < OVR_LEAST_START)
        say(r, OVR_SAY_WARNING,
            "the run starts without load, where the film has no bound: the "
            "film at T = 0 is that of %g of the nominal load",
            OVR_LEAST_START);
}

/* Upstream schemes smear out what moves on few nodes; below so many a width
 * the characteristic scheme is clearly better (at 160 hardly, at 130 in P). */
static void warn_of_smearing(const review *r)
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
        say(r, OVR_SAY_WARNING,
            "feature '%s' moves on %.0f nodes a width, on which an upstream "
            "scheme smears it out: take scheme = characteristic with step = "
            "grid, or level %d",
            info.name, nodes,
            s->options->level + (int)ceil(log2(enough / nodes)));
        return;
    }
}

static void warn_of_features(const review *r, bool transient)
{
    const ovr_surfaces *surfaces = r->setup->surfaces;
    const ovr_options *options = r->setup->options;
    double D = r->setup->mesh, wave = ovr_surfaces_wavelength(surfaces);
    const char *inside;
    if (wave < MESHES_A_WAVE * D)
        say(r, OVR_SAY_WARNING,
            "the grid is too coarse: the shortest wavelength %.3g has only "
            "%.1f meshes; level %d would resolve it",
            wave, wave / D,
            options->level + (int)ceil(log2(MESHES_A_WAVE * D / wave)));
    warn_of_smearing(r);
    inside = ovr_surfaces_inside(surfaces, options->inlet, options->outlet);
    if (inside && transient)
        say(r, OVR_SAY_WARNING,
            "feature '%s' starts inside the domain, in the steady solution; "
            "start it left of the inlet X = %.3g, or let it grow",
            inside, options->inlet);
}

/* In a steady solution nothing passes. */
static void warn_of_left_out(const review *r)
{
    size_t n = ovr_surfaces_count(r->setup->surfaces);
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(r->setup->surfaces, k);
        if (info.speed == 0)
            continue;
        say(r, OVR_SAY_WARNING,
            "feature '%s' moves, and a steady solution leaves it out: an end "
            "in [time], such as end = auto, lets it pass",
            info.name);
    }
}

/* Nor does anything vary in it. */
static void warn_of_histories(const review *r)
{
    static const char *const sections[] = {"load",   "speed",    "sliding",
                                           "radius", "radius_1", "supply"};
    for (size_t k = 0; k < sizeof sections / sizeof *sections; k++) {
        const ovr_block *block = ovr_case_find_block(r->c, sections[k], NULL);
        const ovr_slot *how = block ? ovr_block_get(block, "history") : NULL;
        if (how && how->given && strcmp(how->text, "constant") != 0)
            say(r, OVR_SAY_WARNING,
                "[%s] history = %s: a steady solution takes its value at T = 0 "
                "alone; an end in [time] lets it vary",
                sections[k], how->text);
    }
}

/* A feature with all its copies from `low` to `high` at T. */
static void reach(const ovr_surfaces *surfaces, size_t k, double T, double *low,
                  double *high)
{
    ovr_feature_info f = ovr_surfaces_info(surfaces, k);
    double centre = ovr_surfaces_centre(surfaces, k, T);
    *low = centre - f.behind - (f.speed < 0 ? 0 : f.last);
    *high = centre + f.ahead + (f.speed < 0 ? f.last : 0);
}

/* What moves passes from `low` at T = 0 to `high` at the end and back. */
static void warn_of_passage(const review *r, size_t k)
{
    const ovr_options *o = r->setup->options;
    ovr_feature_info f = ovr_surfaces_info(r->setup->surfaces, k);
    double end = r->setup->march->end, low, high, a, b;
    reach(r->setup->surfaces, k, 0, &low, &high);
    reach(r->setup->surfaces, k, end, &a, &b);
    if (fmax(high, b) < o->inlet || fmin(low, a) > o->outlet)
        say(r, OVR_SAY_WARNING,
            "feature '%s' never arrives: it is at %.4g <= X <= %.4g when the "
            "run ends at T = %.4g, and the domain from %.4g to %.4g",
            f.name, a, b, end, o->inlet, o->outlet);
    else if (f.speed != 0 && isfinite(f.last) && isfinite(a) && isfinite(b) &&
             a < o->outlet && b > o->inlet)
        say(r, OVR_SAY_WARNING,
            "feature '%s' has not left when the run ends at T = %.4g: it is at "
            "%.4g <= X <= %.4g",
            f.name, end, a, b);
}

static void warn_of_time(const review *r)
{
    const ovr_march *march = r->setup->march;
    const ovr_surfaces *surfaces = r->setup->surfaces;
    double dT = ovr_setup_step(r->setup);
    size_t n = surfaces ? ovr_surfaces_count(surfaces) : 0;
    if (march->end < 0.999 * dT)
        say(r, OVR_SAY_WARNING,
            "the end T = %.3g is shorter than one step, %.3g", march->end, dT);
    for (size_t k = 0; k < n; k++)
        warn_of_passage(r, k);
}

static void warn_of_sliding(const review *r)
{
    const ovr_contact *contact = r->setup->contact;
    double slip = contact->u1_ratio - contact->u2_ratio;
    if (fabs(slip) > 2 * (1 + 1e-12))
        say(r, OVR_SAY_WARNING,
            "the surfaces move against each other: slide_to_roll %.4g is "
            "beyond +-2, where one of them stands still",
            slip);
}

/* "some 0.54 %": the loss is a fit to those up to a fifth. */
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

/* To four digits, farther out and not nearer. */
static double rounded_out(double X)
{
    double digit = pow(10, floor(log10(fabs(X))) - 3);
    return copysign(ceil(fabs(X) / digit * (1 - 1e-12)) * digit, X);
}

static bool is_usual(const review *r, const char *key)
{
    const ovr_slot *slot = ovr_slot_of((const ovr_resolved *)r->setup, "domain",
                                       key);
    return slot->word && slot->number == 0;
}

static void warn_of_kept_inlet(const review *r, const ovr_domain_needs *needs)
{
    say(r, OVR_SAY_WARNING,
        "a feature starts left of X = %.4g: the inlet stays there, which costs "
        "%s of the central film; start it left of %.4g to have the inlet there",
        r->setup->options->inlet, share_of(needs->loss).text,
        ((const ovr_resolved *)r->setup)->inlet_kept);
}

/* The usual inlet lies farther out, or does not because of a feature. */
static void say_usual_inlet(const review *r, const ovr_domain_needs *needs)
{
    double inlet = r->setup->options->inlet;
    const ovr_contact *contact = r->setup->contact;
    double loss = ovr_inlet_loss(contact->M, contact->L, OVR_USUAL_INLET);
    if (inlet < OVR_USUAL_INLET && needs->varies)
        say(r, OVR_SAY_NOTE,
            "the inlet is at X = %.4g: that far for all films and contacts "
            "that load, speed and radius make",
            inlet);
    else if (inlet < OVR_USUAL_INLET)
        say(r, OVR_SAY_NOTE,
            "the inlet is at X = %.4g: at -4 it would cost %s of the central "
            "film",
            inlet, share_of(loss).text);
}

/* Ends that were given, where films are cut by them.  An inlet that oil does
 * not fill is judged by the meniscus, when there is one (warn_of_inlet). */
static void warn_of_near_inlet(const review *r, const ovr_domain_needs *needs)
{
    if (!r->setup->supply->film && needs->loss > 1.01 * OVR_USUAL_LOSS)
        say(r, OVR_SAY_WARNING,
            "the inlet is numerically starved: X = %.4g is so near that it "
            "costs %s of the film; inlet = %.4g would do",
            r->setup->options->inlet, share_of(needs->loss).text,
            rounded_out(needs->inlet));
}

static void warn_of_near_outlet(const review *r, const ovr_domain_needs *needs)
{
    const ovr_options *o = r->setup->options;
    if (!is_usual(r, "outlet") && o->outlet < needs->film_end)
        say(r, OVR_SAY_WARNING,
            "the outlet X = %.4g is too near: films end as far out as X = "
            "%.4g, and what is cut off carries load; outlet = %.4g would do",
            o->outlet, needs->film_end, rounded_out(needs->outlet));
}

static void say_domain(const review *r)
{
    ovr_domain_needs needs = ovr_setup_needs(r->setup);
    if (((const ovr_resolved *)r->setup)->inlet_kept < 0 &&
        needs.loss > OVR_USUAL_LOSS)
        warn_of_kept_inlet(r, &needs);
    else if (is_usual(r, "inlet"))
        say_usual_inlet(r, &needs);
    else
        warn_of_near_inlet(r, &needs);
    warn_of_near_outlet(r, &needs);
}

/* One that was chosen, where it is the finest that may be. */
static void say_level(const review *r)
{
    const ovr_setup *s = r->setup;
    if (s->accuracy > 0 && s->expected > s->accuracy)
        say(r, OVR_SAY_WARNING,
            "level = auto takes level %d at most, on which an error of %.2g is "
            "to be expected, not of %.2g",
            s->options->level, s->expected, s->accuracy);
}

static void before(const review *r, bool transient)
{
    say_moved(r);
    say_estimated(r);
    ovr_review_plausible(r->setup, r->say, r->data);
    ovr_review_element(r->setup, r->say, r->data);
    say_idle(r);
    warn_of_start(r);
    warn_of_sliding(r);
    say_domain(r);
    say_level(r);
    ovr_companions_foresee(r->setup, r->say, r->data);
    if (r->setup->surfaces)
        warn_of_features(r, transient);
    if (r->setup->surfaces && !r->setup->transient)
        warn_of_left_out(r);
    if (!r->setup->transient)
        warn_of_histories(r);
    if (transient)
        warn_of_time(r);
}

void ovr_setup_review(const ovr_setup *setup, ovr_listener *listener,
                      void *data)
{
    if (!setup)
        return;
    review r = {((const ovr_resolved *)setup)->c, setup, listener, data};
    before(&r, setup->transient);
}

void ovr_run_review_before(ovr_run *run)
{
    review r = {run->c, run->setup, ovr_run_message, run};
    say_assumed(&r);
    before(&r, run->info.transient);
}

/* Of oil that arrives as a film and fills the inlet all the same. */
static void warn_of_inlet(const review *r, const ovr_state *state, double H_cen)
{
    ovr_domain_needs needs = ovr_setup_needs(r->setup);
    if (needs.loss <= 1.01 * OVR_USUAL_LOSS)
        return;
    say(r, OVR_SAY_WARNING,
        "the inlet is numerically starved: the film at X = %.3g is only %.1f "
        "central films, which costs %s of the film; inlet = %.4g would do",
        state->X[0], state->H[0] / H_cen, share_of(needs.loss).text,
        rounded_out(needs.inlet));
}

/* Order four was taken or wanted, and is not what was reached. */
static void warn_of_order(const review *r, const ovr_simulation *sim)
{
    const ovr_block *domain = ovr_case_find_block(r->c, "domain", NULL);
    int most = r->setup->options->max_cycles;
    if (ovr_setup_corrected(r->setup))
        say(r, OVR_SAY_WARNING,
            "the solution is of second order: the corrections of fourth order "
            "did not converge on this mesh%s; level = %d would do",
            most ? " in the max_cycles given" : "", ovr_level_resolving(sim));
    else if (ovr_block_get(domain, "order")->given)
        say(r, OVR_SAY_WARNING,
            "the solution is of second order: corrections of fourth order hold "
            "for one load, speed and radius of a film by Reynolds, or with "
            "scheme = characteristic where the speed does not reverse");
}

/* Of a steady solution the first of these is the only state. */
static void warn_of_pressure(const review *r, const ovr_statistics *total)
{
    double ph = r->setup->contact->ph, bearable = r->setup->bearable;
    if (total->extreme.P_max * ph > bearable)
        say(r, OVR_SAY_WARNING,
            "the pressure of %.3g GPa at X = %.4g, T = %.4g is above what the "
            "material bears (bearable_pressure = %.3g GPa): it would yield, "
            "which is not modelled",
            total->extreme.P_max * ph * 1e-9, total->where.P_max,
            total->when.P_max, bearable * 1e-9);
}

static void warn_of_roughness(const review *r, const ovr_statistics *total)
{
    double Rq = r->setup->surfaces ? ovr_surfaces_roughness(r->setup->surfaces)
                                   : 0;
    if (total->extreme.H_min_located < Rq)
        say(r, OVR_SAY_WARNING,
            "the smallest film H = %.3g, at X = %.4g, T = %.4g, is below the "
            "roughness Rq = %.3g of both surfaces: they would touch",
            total->extreme.H_min_located, total->where.H_min_located,
            total->when.H_min_located, Rq);
}

/* The ordinary is 3 cycles a step; the steady start has its own. */
static void warn_of_cycles(const review *r, const ovr_statistics *total)
{
    const long far = 20, start = 500;
    if (total->steps > 0 && total->cycles > far * total->steps + start)
        say(r, OVR_SAY_WARNING,
            "%ld cycles for %ld steps, where 3 a step are ordinary: the run is "
            "at the border of what can be solved on this mesh",
            total->cycles, total->steps);
}

static void warn_of_extremes(const review *r, const ovr_statistics *total)
{
    if (!(total->extreme.H_min_located > 0)) /* nothing was solved */
        return;
    warn_of_pressure(r, total);
    warn_of_roughness(r, total);
    warn_of_cycles(r, total);
}

/* end = auto gives up some time after the last has left. */
static void warn_of_unrest(const review *r, double T, bool settled)
{
    const ovr_march *march = r->setup->march;
    if (march->steady_from > 0 && !settled && T > 0.999 * march->end)
        say(r, OVR_SAY_WARNING,
            "all that passes had left at T = %.4g, but the film is not steady "
            "again at T = %.4g, where end = auto gives up",
            march->steady_from, march->end);
}

void ovr_run_review_after(ovr_run *run)
{
    review r = {run->c, run->setup, ovr_run_message, run};
    const ovr_simulation *sim = run->sim;
    const ovr_state *state = ovr_simulation_state(sim);
    double H_cen = ovr_simulation_observation(sim)->H_cen;
    const char *strategy = ovr_simulation_strategy(sim);
    if (run->setup->options->order == 4 && ovr_simulation_order(sim) != 4)
        warn_of_order(&r, sim);
    if (ovr_mesh_too_coarse(sim))
        say(&r, OVR_SAY_WARNING,
            "the film is too thin for the mesh: the pressure builds up within "
            "a mesh or two, and the film may be off by tens of per cent; level "
            "= %d would do",
            ovr_level_resolving(sim));
    if (*strategy)
        say(&r, OVR_SAY_NOTE, "the steady solution took another way: %s",
            strategy);
    if (state->n && H_cen > 0 && r.setup->supply->film &&
        isnan(ovr_simulation_observation(sim)->meniscus) &&
        ((const ovr_resolved *)r.setup)->inlet_kept >= 0)
        warn_of_inlet(&r, state, H_cen);
    ovr_companions_review(run);
    warn_of_extremes(&r, ovr_simulation_statistics(sim));
    if (run->info.transient && ovr_simulation_statistics(sim)->steps > 0)
        ovr_review_element_after(r.setup, ovr_simulation_statistics(sim),
                                 ovr_run_message, run);
    warn_of_unrest(&r, state->T, ovr_simulation_statistics(sim)->settled);
    run->info.lambda_ratio = ovr_simulation_statistics(sim)->mean.lambda_ratio;
    if (state->n && H_cen > 0)
        ovr_run_shear(run);
}
