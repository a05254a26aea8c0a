/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a run beside its result: before the solve, of a grid too
 * coarse for its features and the like; after it, of a starved inlet. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "case/resolve.h"
#include "run/internal.h"

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
    vsnprintf(text,
              kind == OVR_SAY_WARNING ? OVR_RUN_WARNING_SIZE : sizeof text,
              format, args);
    va_end(args);
    if (r->say)
        r->say(r->data, kind, text);
}

/* Second-order schemes carry a wave of eight meshes with a few per cent lost
 * (0.25 b at level 6 is 20 meshes, 3.6 %). */
static const double MESHES_A_WAVE = 10;

/* Films at the inlet above so many central films leave it fully flooded
 * (Wolveridge, Baglin & Archard 1971, rounded up). */
static const double FLOODED = 9;

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

/* A run from rest or from no load starts a little above either. */
static void warn_of_start(const review *r)
{
    if (ovr_history_value(r->setup->speed, 0) < OVR_LEAST_START)
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

static void before(const review *r, bool transient)
{
    say_moved(r);
    warn_of_start(r);
    if (r->setup->surfaces)
        warn_of_features(r, transient);
}

void ovr_setup_review(const ovr_setup *setup, ovr_listener *listener,
                      void *data)
{
    review r = {((const ovr_resolved *)setup)->c, setup, listener, data};
    before(&r, setup->transient);
}

void ovr_run_say(void *data, ovr_say kind, const char *text)
{
    ovr_run *run = data;
    ovr_run_info *info = &run->info;
    if (kind == OVR_SAY_WARNING && info->warnings == OVR_RUN_WARNINGS)
        return;
    if (kind == OVR_SAY_WARNING)
        snprintf(info->warning[info->warnings++], OVR_RUN_WARNING_SIZE, "%s",
                 text);
    if (run->how.say)
        run->how.say(run->how.data, kind, text);
}

void ovr_run_review_before(ovr_run *run)
{
    review r = {run->c, run->setup, ovr_run_say, run};
    say_assumed(&r);
    before(&r, run->info.transient);
}

/* The loss is a fit to small ones; a film cannot lose more than all of it. */
static void warn_of_inlet(const review *r, const ovr_simulation *sim, double X,
                          double films)
{
    double loss = ovr_simulation_starvation(sim);
    char share[40] = "most";
    if (loss < 0.5)
        snprintf(share, sizeof share, "some %.2g %%", 100 * loss);
    say(r, OVR_SAY_WARNING,
        "the inlet is numerically starved: the film at X = %.3g is only %.1f "
        "central films, which costs %s of the film; move the inlet out or let "
        "inlet = auto choose it",
        X, films, share);
}

/* Order four was taken or wanted, and is not what was reached. */
static void warn_of_order(const review *r)
{
    const ovr_block *domain = ovr_case_find_block(r->c, "domain", NULL);
    bool varies = ovr_history_varies(r->setup->load) ||
                  ovr_history_varies(r->setup->speed);
    if (varies && !ovr_block_get(domain, "order")->given)
        return;
    say(r, varies ? OVR_SAY_WARNING : OVR_SAY_NOTE,
        "the solution is of second order: %s",
        varies ? "corrections of fourth order hold for one load and speed"
               : "the corrections of fourth order did not converge on this "
                 "mesh");
}

void ovr_run_review_after(ovr_run *run)
{
    review r = {run->c, run->setup, ovr_run_say, run};
    const ovr_simulation *sim = run->sim;
    const ovr_state *state = ovr_simulation_state(sim);
    double H_cen = ovr_simulation_observation(sim)->H_cen;
    const char *strategy = ovr_simulation_strategy(sim);
    if (run->setup->options->order == 4 && ovr_simulation_order(sim) != 4)
        warn_of_order(&r);
    if (*strategy)
        say(&r, OVR_SAY_NOTE, "the steady solution took another way: %s",
            strategy);
    if (state->n && H_cen > 0 && state->H[0] < FLOODED * H_cen)
        warn_of_inlet(&r, sim, state->X[0], state->H[0] / H_cen);
}
