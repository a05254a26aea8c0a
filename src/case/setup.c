/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Creates the simulation and the surfaces of a resolved case. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include "base/given.h"
#include "case/accuracy.h"
#include "case/domain.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/film_formula.h"
#include "contact/history.h"
#include "contact/starvation.h"
#include "simulation/conflicts.h"
#include "simulation/internal.h"
#include "simulation/refined.h"
#include "simulation/simulation.h"
#include "surface/surfaces.h"

static double memory_here(void)
{
    long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGE_SIZE);
    return pages > 0 && bytes > 0 ? (double)pages * (double)bytes : INFINITY;
}

/* Usable fraction of the memory; the rest is for the system and its file
 * cache. */
static const double SHARE = 0.8;

static void measure(ovr_setup *s)
{
    s->mesh = (s->options->outlet - s->options->inlet) /
              (double)(ovr_level_nodes(s->options->level) - 1);
}

/* Checks the required memory before it is allocated. The physics refuse first,
 * because a narrower strip may fit where a lower level does not help. */
static ovr_status check_memory(ovr_resolved *r, ovr_error *err)
{
    const ovr_block *domain = ovr_case_find_block(r->c, "domain", NULL);
    const ovr_slot *nodes = ovr_block_get(domain, "nodes");
    const ovr_slot *slot = nodes->given ? nodes
                                        : ovr_block_get(domain, "level");
    ovr_options *o = r->setup.options;
    double target = ovr_setup_memory(&r->setup);
    double here = SHARE * memory_here(), needed = target;
    int level = o->level;
    char takes[60] = "more memory than can be addressed";
    if (target <= here)
        return OVR_OK;
    measure(&r->setup);
    if (ovr_resolve_on_mesh(r, err))
        return OVR_BAD_INPUT;
    while (o->level > 1 && needed > here) {
        o->level--;
        needed = ovr_setup_memory(&r->setup);
    }
    int fits = needed <= here ? o->level : 0;
    o->level = level;
    if (isfinite(target))
        snprintf(takes, sizeof takes, "about %.1f GB of memory", target / 1e9);
    if (!fits)
        return ovr_fail_slot(err, slot,
                             "%s needs %s, but this machine has %.1f GB "
                             "free; no level fits",
                             slot->text, takes, here / 1e9);
    return ovr_fail_slot(err, slot,
                         "%s needs %s, but this machine has %.1f GB free; "
                         "level %d fits",
                         slot->text, takes, here / 1e9, fits);
}

static ovr_status add_features(ovr_resolved *r, ovr_error *err)
{
    for (size_t k = 0; k < r->setup.features; k++) {
        const ovr_feature_form *form = r->setup.feature[k];
        ovr_error why = {0};
        if (ovr_surfaces_add(r->setup.surfaces, form, &why))
            return ovr_fail_in(err, r->c,
                               ovr_case_find_block(r->c, "feature", form->name),
                               NULL, &why);
    }
    return OVR_OK;
}

static ovr_status make_surfaces(ovr_resolved *r, const ovr_allocator *allocator,
                                ovr_error *err)
{
    ovr_setup *s = &r->setup;
    ovr_status status;
    if (s->features == 0)
        return OVR_OK;
    s->surfaces = ovr_surfaces_create(s->contact, s->speed, s->mesh, allocator,
                                      err);
    if (!s->surfaces)
        return OVR_NO_MEMORY;
    ovr_surfaces_sliding(s->surfaces, s->sliding);
    ovr_surfaces_strip(s->surfaces, ovr_resolved_width(r),
                       ovr_resolved_lines(r, s->mesh));
    ovr_surfaces_domain(s->surfaces, s->options->inlet, s->options->outlet);
    status = add_features(r, err);
    if (status) {
        ovr_surfaces_free(s->surfaces);
        s->surfaces = NULL;
    }
    return status;
}

/* Returns the usual inlet, outside the contact at its largest width. */
static double nearest_inlet(const ovr_resolved *r)
{
    return fmin(OVR_USUAL_INLET, OVR_NEAREST_INLET * r->half_width);
}

/* True if a feature that starts upstream of the usual inlet would start inside
 * the lengthened domain. */
static bool is_overrun(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    const ovr_options *o = s->options;
    double kept = nearest_inlet(r);
    return s->transient && s->surfaces && o->inlet < kept &&
           ovr_surfaces_inside(s->surfaces, o->inlet, o->outlet) &&
           !ovr_surfaces_inside(s->surfaces, kept, o->outlet);
}

/* Returns the inlet of the paper or, if load, speed or radius vary (it may then
 * be far too close), the furthest one for which no feature starts inside. */
static double kept_inlet(const ovr_resolved *r)
{
    enum { HALVINGS = 20 };
    const ovr_setup *s = &r->setup;
    double near = nearest_inlet(r), far = s->options->inlet;
    for (int k = 0; ovr_setup_varies(s) && k < HALVINGS; k++) {
        double middle = 0.5 * (near + far);
        bool inside = ovr_surfaces_inside(s->surfaces, middle,
                                          s->options->outlet);
        *(inside ? &far : &near) = middle;
    }
    return near;
}

static ovr_status make_anew(ovr_resolved *r, const ovr_allocator *allocator,
                            ovr_error *err)
{
    ovr_surfaces_free(r->setup.surfaces);
    r->setup.surfaces = NULL;
    measure(&r->setup);
    if (make_surfaces(r, allocator, err))
        return err ? err->status : OVR_BAD_INPUT;
    r->prepared += ovr_surfaces_work(r->setup.surfaces);
    return OVR_OK;
}

/* True if the outlet may move to make room for the film of high features.  All
 * passes have the same domain. */
static bool may_move_outlet(const ovr_resolved *r)
{
    const ovr_slot *slot = ovr_slot_of(r, "domain", "outlet");
    bool usual = !slot->given || (slot->word && !isnan(slot->number));
    return usual && !r->recorded && r->setup.passes->number == 1 &&
           !ovr_history_reverses(r->setup.speed);
}

static ovr_status place_surfaces(ovr_resolved *r, bool usual,
                                 const ovr_allocator *allocator, ovr_error *err)
{
    ovr_setup *s = &r->setup;
    ovr_status status = make_anew(r, allocator, err);
    double outlet = status ? 0 : ovr_setup_feature_outlet(s);
    if (outlet > s->options->outlet && may_move_outlet(r)) {
        s->options->outlet = outlet;
        status = make_anew(r, allocator, err);
    }
    if (status || !usual || ovr_history_reverses(s->speed) || !is_overrun(r))
        return status;
    double kept = kept_inlet(r);
    r->inlet_kept = s->options->inlet;
    s->options->inlet = kept;
    return make_anew(r, allocator, err);
}

static ovr_status resolve_options(ovr_resolved *r, ovr_error *err)
{
    const ovr_block *domain = ovr_case_find_block(r->c, "domain", NULL);
    const ovr_block *solver = ovr_case_find_block(r->c, "solver", NULL);
    const ovr_block *paper = ovr_case_find_block(r->c, "paper", NULL);
    ovr_error why = {0};
    if (!ovr_options_resolve(r->setup.contact, r->setup.options, &why))
        return OVR_OK;
    bool of_paper = why.about && ovr_parameter_find(paper->section, why.about);
    return ovr_fail_in(err, r->c, of_paper ? paper : domain, solver, &why);
}

/* Makes the grid on the level of the options. */
static ovr_status make_grid(ovr_resolved *r, bool usual,
                            const ovr_allocator *allocator, ovr_error *err)
{
    ovr_setup *s = &r->setup;
    if (resolve_options(r, err) || check_memory(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    ovr_status status = place_surfaces(r, usual, allocator, err);
    if (!status) {
        ovr_resolve_step(r);
        s->expected = ovr_expected(s, ovr_resolved_supply(r));
    }
    return status;
}

/* True for expensive cases: transient runs, and asperity contact, whose films
 * are solved on the finest grid only. */
static bool takes_time(const ovr_resolved *r)
{
    return r->setup.transient ||
           ovr_resolved_features(r) &
               ovr_model_feature_bit(OVR_MODEL_BOUNDARY, true);
}

/* Returns the first level from `least` on whose mesh size is at most `part` of
 * the one that resolves the inlet of the reference contact. Films with asperity
 * contact need no finer grid. */
static int resolving_level(const ovr_resolved *r, int least, double part)
{
    enum { MAX = 14 };
    const ovr_setup *s = &r->setup;
    const ovr_options *o = s->options;
    double H = ovr_film_central_moes(s->contact->M, s->contact->L);
    double largest = part * ovr_resolving_mesh(s->contact->M, H);
    double length = o->outlet - o->inlet;
    int level = least;
    if (ovr_resolved_features(r) &
        ovr_model_feature_bit(OVR_MODEL_BOUNDARY, true))
        return least;
    while (level < MAX &&
           length / (double)(ovr_level_nodes(level) - 1) > largest)
        level++;
    return level;
}

/* Returns the default level of transient runs: finer than 8 only if level 8 has
 * no solution. */
static int largest_usual_level(const ovr_resolved *r)
{
    int level = resolving_level(r, OVR_USUAL_LEVEL, 1);
    return level > OVR_USUAL_LEVEL + 1 ? level : OVR_USUAL_LEVEL;
}

/* Returns the default level of a steady contact: one more than usual if the
 * constriction at the outlet needs it. */
static int steady_level(const ovr_resolved *r)
{
    const double half = 0.5;
    int inlet = resolving_level(r, OVR_USUAL_LEVEL, 1);
    int outlet = resolving_level(r, OVR_USUAL_LEVEL, half);
    int most = OVR_USUAL_LEVEL + 1;
    return inlet > OVR_USUAL_LEVEL || outlet < most ? inlet : most;
}

/* Resolves level = usual. For expensive cases the level is chosen for a likely
 * error of 1e-3 of film thickness and friction. Other steady contacts use
 * steady_level. */
static void usual_level(ovr_resolved *r)
{
    static const double unseen = 1e-3;
    ovr_setup *s = &r->setup;
    bool chosen = takes_time(r);
    bool strip = ovr_resolved_features(r) &
                 ovr_model_feature_bit(OVR_MODEL_STRIP, true);
    if (s->options->level != OVR_GRID_USUAL)
        return;
    if (strip) { /* a time step of a strip costs hundreds of times that of a
                    line contact */
        s->options->level = resolving_level(r, OVR_USUAL_STRIP, 1);
        s->accuracy = 0;
        return;
    }
    s->options->level = chosen ? OVR_GRID_AUTO : steady_level(r);
    s->accuracy_of = OVR_ACCURACY_ALL;
    s->accuracy = chosen ? unseen : 0;
}

/* True if the error of the film may be below the target, on the shorter domain
 * if features prevent a longer one (place_surfaces). */
static bool may_reach(ovr_resolved *r, bool usual)
{
    ovr_setup *s = &r->setup;
    double inlet = s->options->inlet;
    if (usual && s->features > 0 && s->transient)
        s->options->inlet = fmax(inlet, nearest_inlet(r));
    measure(s);
    bool reached = ovr_expected_of_mesh(s) < s->accuracy;
    s->options->inlet = inlet;
    measure(s);
    return reached;
}

/* Returns the first level with the requested expected error; the effect of
 * features is evaluated only on levels whose grid error is small enough. */
static ovr_status choose_level(ovr_resolved *r, bool usual,
                               const ovr_allocator *allocator, ovr_error *err)
{
    enum { MIN = 4, MAX = 14 };
    ovr_setup *s = &r->setup;
    const ovr_options target = *s->options;
    ovr_status status = OVR_OK;
    int minimum = target.refine ? OVR_MIN_REFINED : MIN;
    int maximum = s->confirm ? MAX : largest_usual_level(r);
    int level = target.coarsest_level > minimum ? target.coarsest_level
                                                : minimum;
    s->expected = INFINITY;
    for (; !status && s->expected > s->accuracy && level <= maximum; level++) {
        double inlet = s->options->inlet;
        *s->options = target;
        s->options->inlet = inlet;
        s->options->level = level;
        status = resolve_options(r, err);
        if (!status && (level == maximum || may_reach(r, usual)))
            status = make_grid(r, usual, allocator, err);
    }
    return status;
}

/* Makes the domain symmetric if the mean speed reverses (simulation/mirror.h),
 * since inlet and outlet are then exchanged. */
static ovr_status make_symmetric(ovr_resolved *r, bool inlet, bool outlet,
                                 ovr_error *err)
{
    ovr_options *o = r->setup.options;
    double far = inlet ? -o->inlet : fmax(-o->inlet, o->outlet);
    if (!ovr_history_reverses(r->setup.speed))
        return OVR_OK;
    if (outlet && o->outlet != -o->inlet)
        return ovr_fail_slot(
            err, ovr_slot_of(r, "domain", "outlet"),
            "%g: inlet and outlet are exchanged where [speed] reverses; "
            "remove this key, or set inlet and outlet to the same distance, "
            "%g",
            o->outlet, far);
    o->inlet = -far;
    o->outlet = far;
    return OVR_OK;
}

/* Rejects a window of stored nodes that is outside the domain or between two
 * nodes. */
static ovr_status check_window(const ovr_resolved *r, ovr_error *err)
{
    const ovr_options *o = r->setup.options;
    const ovr_output *out = r->setup.output;
    double D = (o->outlet - o->inlet) / (double)(ovr_level_nodes(o->level) - 1);
    double next = o->inlet + ceil((out->from - o->inlet) / D - 1e-9) * D;
    bool downstream = out->from > o->outlet;
    if (downstream || out->to < o->inlet)
        return ovr_fail_slot(
            err, ovr_slot_of(r, "output", downstream ? "from" : "to"),
            "%g b is outside the domain X = %.4g to %.4g, so that nothing "
            "would be stored",
            downstream ? out->from : out->to, o->inlet, o->outlet);
    if (next > out->to + 1e-9 * D)
        return ovr_fail_slot(err, ovr_slot_of(r, "output", "to"),
                             "no node lies between %g b and %g b; the mesh "
                             "size is %.4g b",
                             out->from, out->to, D);
    return OVR_OK;
}

ovr_status ovr_setup_prepare(ovr_setup *setup, const ovr_allocator *allocator,
                             ovr_error *err)
{
    if (!setup)
        return ovr_fail_null(err, __func__);
    ovr_resolved *r = setup->resolved;
    const ovr_options *o = setup->options;
    bool inlet = o->inlet < 0, usual = o->inlet == 0;
    bool outlet = ovr_slot_of(r, "domain", "outlet")->given &&
                  isfinite(o->outlet) && o->outlet != 0;
    ovr_status status;
    if (setup->nodes)
        return OVR_OK;
    if (ovr_setup_domain(r, err) || make_symmetric(r, inlet, outlet, err) ||
        ovr_setup_curvature(r, err))
        return OVR_BAD_INPUT;
    usual_level(r);
    status = setup->options->level ? make_grid(r, usual, allocator, err)
                                   : choose_level(r, usual, allocator, err);
    if (!status)
        status = ovr_resolve_end(r, err);
    if (!status)
        status = ovr_resolve_on_mesh(r, err);
    if (!status)
        status = check_window(r, err);
    if (!status)
        setup->nodes = ovr_level_nodes(setup->options->level);
    return status;
}

ovr_status ovr_setup_load(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err)
{
    const ovr_list *loads = &setup->passes->loads;
    if ((size_t)pass > loads->count)
        return OVR_OK;
    double load = loads->values[pass - 1];
    setup->resolved->pass_load = load;
    return ovr_history_scale(&setup->load, load, allocator, err);
}

ovr_simulation *ovr_setup_simulation(ovr_setup *setup,
                                     const ovr_allocator *allocator,
                                     ovr_error *err)
{
    if (!setup)
        return ovr_null(err, __func__);
    ovr_simulation *sim;
    if (ovr_setup_prepare(setup, allocator, err))
        return NULL;
    sim = ovr_simulation_create(setup->contact, setup->lubricant,
                                setup->options, allocator, err);
    if (!sim)
        return NULL;
    if (ovr_setup_add_physics(setup, sim, err)) {
        ovr_simulation_free(sim);
        return NULL;
    }
    ovr_simulation_histories(sim, setup->load, setup->speed);
    ovr_simulation_sliding(sim, setup->sliding);
    ovr_simulation_radius(sim, setup->radius, setup->radius_1,
                          setup->convected);
    ovr_setup_equip(setup, sim);
    if (setup->surfaces) {
        ovr_simulation_surface(sim, ovr_surfaces_heights, setup->surfaces);
        ovr_simulation_moving(sim, ovr_surfaces_speed(setup->surfaces));
        ovr_simulation_sides(
            sim,
            ovr_surfaces_has(setup->surfaces, 1) ? ovr_surfaces_heights_1
                                                 : NULL,
            ovr_surfaces_has(setup->surfaces, 2) ? ovr_surfaces_heights_2
                                                 : NULL);
        if (ovr_resolved_width(setup->resolved) > 0)
            ovr_simulation_across(sim, ovr_surfaces_across);
        sim->shapes.roughness = ovr_surfaces_roughness(setup->surfaces);
    }
    if (setup->transient)
        ovr_simulation_standing(sim,
                                setup->surfaces ? ovr_surfaces_standing : NULL,
                                setup->surfaces);
    return sim;
}

void ovr_warn(ovr_listener *say, void *data, const char *format, ...)
{
    char text[OVR_MESSAGE_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (say)
        say(data, OVR_MESSAGE_WARNING, text);
}
