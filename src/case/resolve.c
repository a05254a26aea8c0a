/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Evaluates a case to a setup of a run: first the contact, which determines the
 * scales, then options, times, features, physical models and output in its
 * units. Conflicts are checked last.
 */
#include "case/resolve.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "contact/contact.h"
#include "contact/flow_law.h"
#include "contact/history.h"
#include "contact/oil.h"
#include "elements/case_element.h"
#include "multigrid/hierarchy.h"
#include "results/layout.h"
#include "simulation/conflicts.h"
#include "simulation/physics.h"
#include "surface/surfaces.h"

/* ------------------------------------------------------------------ Options */

static int nodes_of(int level)
{
    return (int)ovr_level_nodes(level);
}

static ovr_status resolve_level(ovr_resolved *r, ovr_error *err)
{
    const ovr_slot *nodes = ovr_slot_of(r, "domain", "nodes");
    const ovr_slot *level = ovr_slot_of(r, "domain", "level");
    int k = 1, target = r->values.nodes;
    if (!nodes->given)
        return OVR_OK;
    if (level->given)
        return ovr_fail_slot(err, nodes,
                             "domain.level is also set; remove "
                             "one of the two");
    while (k < OVR_LEVELS - 1 && nodes_of(k) < target)
        k++;
    if (k > 1 && nodes_of(k) - target > target - nodes_of(k - 1))
        k--;
    if (nodes_of(k) != target)
        return ovr_fail_slot(err, nodes,
                             "%d must be 7 2^k + 1; the nearest such number "
                             "is %d (level %d)",
                             target, nodes_of(k), k);
    r->values.options.level = k;
    return OVR_OK;
}

static ovr_status check_solver(const ovr_resolved *r, ovr_error *err)
{
    const ovr_options *o = &r->values.options;
    if (o->mlmi_order % 2 || o->mlmi_range % 2) {
        const char *key = o->mlmi_order % 2 ? "mlmi_order" : "mlmi_range";
        const ovr_slot *slot = ovr_slot_of(r, "paper", key);
        return ovr_fail_slot(err, slot, "%s must be even", slot->text);
    }
    if (o->level > 0 && o->coarsest_level > o->level)
        return ovr_fail_slot(err, ovr_slot_of(r, "solver", "coarsest_level"),
                             "%d must not be above the level "
                             "%d",
                             o->coarsest_level, o->level);
    return OVR_OK;
}

/* Sets the usual sweeps on one side of the coarse-grid correction if the case
 * has a number for the other side only. */
static void fill_sweeps(ovr_resolved *r)
{
    ovr_options *o = &r->values.options;
    bool before = !ovr_slot_of(r, "solver", "sweeps_before")->word;
    bool after = !ovr_slot_of(r, "solver", "sweeps_after")->word;
    int usual = o->smoother == OVR_LINE ? 1 : 2;
    if (after && !before)
        o->sweeps_before = usual;
    if (before && !after)
        o->sweeps_after = usual;
}

static ovr_status resolve_options(ovr_resolved *r, ovr_error *err)
{
    ovr_status status;
    r->values.options = ovr_options_default();
    if (ovr_section_fill(r, "domain", err) ||
        ovr_section_fill(r, "solver", err) ||
        ovr_section_fill(r, "paper", err) || ovr_section_fill(r, "time", err))
        return OVR_BAD_INPUT;
    fill_sweeps(r);
    r->values.passes.side_flow = NAN;
    r->values.passes.spacing = r->values.passes.recovery = NAN;
    if (ovr_section_fill(r, "passes", err))
        return OVR_BAD_INPUT;
    status = ovr_resolve_forms(r, err);
    if (!status)
        status = resolve_level(r, err);
    if (!status)
        status = check_solver(r, err);
    r->setup.confirm = r->values.options.level == OVR_GRID_AUTO;
    r->setup.accuracy_of = (ovr_accuracy)r->values.accuracy_of;
    r->setup.accuracy = r->setup.confirm ? r->values.accuracy : 0;
    return status;
}

/* ----------------------------------------------------------------- Features */

static ovr_status fill_feature(ovr_resolved *r, const ovr_block *block,
                               ovr_feature_settings *to, ovr_error *err)
{
    ovr_feature_form *form = &to->form;
    ovr_status status;
    *to = (ovr_feature_settings){.form = ovr_feature_form_default(),
                                 .source = ovr_profile_source_default(),
                                 .conditioning = ovr_conditioning_default(),
                                 .roughness = ovr_roughness_default()};
    form->name = block->name;
    form->source = &to->source;
    form->conditioning = &to->conditioning;
    form->roughness = &to->roughness;
    if (!ovr_block_get(block, "shape")->given) {
        ovr_error why = {0};
        ovr_fail_about(&why, "shape", "[feature %s] needs a shape",
                       block->name);
        return ovr_fail_in(err, r->c, block, NULL, &why);
    }
    status = ovr_block_fill(r, block, to, err);
    to->source.spacing_scaled = true; /* lengths are in b here */
    if (form->shape == OVR_ROUGHNESS) {
        to->roughness.length = form->length;
        form->length = NAN;
    }
    return status;
}

/* Chooses the seed of random roughness without one, so that no two features
 * have the same heights: 1, 3, 5 ... on surface 1 and 2, 4, 6 ... on surface
 * 2. */
static void choose_seed(ovr_feature_settings *s, const ovr_block *block,
                        int count[2])
{
    int side = s->form.surface == 2;
    if (s->form.shape != OVR_ROUGHNESS)
        return;
    if (!ovr_block_get(block, "seed")->given)
        s->roughness.seed = 2 * count[side] + side + 1;
    count[side]++;
}

static ovr_status resolve_features(ovr_resolved *r, ovr_error *err)
{
    ovr_feature_settings *settings;
    const ovr_feature_form **form;
    size_t n = 0;
    int rough[2] = {0, 0};
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        n += ovr_block_is_feature(b);
    settings = ovr_arena_take(&r->arena, n, sizeof *settings, err);
    form = ovr_arena_take(&r->arena, n, sizeof *form, err);
    if (ovr_arena_status(&r->arena))
        return OVR_NO_MEMORY;
    r->feature = form;
    r->features = n;
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        if (ovr_block_is_feature(b)) {
            ovr_status status = fill_feature(r, b, settings, err);
            if (status)
                return status;
            choose_seed(settings, b, rough);
            *form++ = &settings++->form;
        }
    return OVR_OK;
}

/* ------------------------------------------------------------------- Output */

/* Rejects output fields without values. They are omitted with a note if the
 * case has the section of their physical model but turned off, because a study
 * may vary it. */
static ovr_status leave_out(ovr_resolved *r, const ovr_slot *slot,
                            ovr_error *err)
{
    ovr_output *out = &r->values.output;
    const ovr_physics *off = NULL;
    unsigned none = ovr_resolved_no_fields(r, &off);
    if (!none || slot->stored)
        return OVR_OK;
    const char *section = off->in_case->section->name;
    const ovr_observable *row[OVR_FIELDS_MAX];
    ovr_layout_fields(none, row);
    if (none == out->fields ||
        !ovr_block_is_there(ovr_case_find_block(r->c, section, NULL)))
        return ovr_fail_slot(err, slot,
                             "%s has no values without [%s]; remove it from "
                             "the list, or add that section",
                             row[0]->name, section);
    out->fields &= ~none;
    return OVR_OK;
}

static ovr_status resolve_output(ovr_resolved *r, ovr_error *err)
{
    ovr_output *out = &r->values.output;
    out->from = out->to = NAN;
    if (ovr_section_fill(r, "output", err))
        return OVR_BAD_INPUT;
    const ovr_slot *fields = ovr_slot_of(r, "output", "fields");
    if (!fields->given)
        out->fields |= ovr_resolved_fields(r);
    else if (leave_out(r, fields, err))
        return OVR_BAD_INPUT;
    out->single = r->values.precision == 1;
    if (ovr_resolved_width(r) > 0 &&
        !ovr_slot_of(r, "output", "precision")->given)
        out->single = true;
    if (out->from >= out->to)
        return ovr_fail_slot(err, ovr_slot_of(r, "output", "from"),
                             "%g must be below to = %g", out->from, out->to);
    return OVR_OK;
}

/* ---------------------------------------------------------------- Conflicts */

static bool is_given(const ovr_resolved *r, int feature)
{
    ovr_model_feature_info info = ovr_model_feature_at(feature);
    return ovr_slot_of(r, info.section, info.key)->given;
}

/* True if a feature on the grid is a profile, an areal surface or random
 * roughness. */
static bool has_roughness(const ovr_resolved *r)
{
    for (size_t k = 0; k < r->setup.features; k++)
        if (r->setup.feature[k]->shape == OVR_PROFILE ||
            r->setup.feature[k]->shape == OVR_AREAL ||
            r->setup.feature[k]->shape == OVR_ROUGHNESS)
            return true;
    return false;
}

/* Returns the set of model features that the case selects explicitly. Defaults
 * of solver options (stop, smoother, refine) do not count. */
#define BY_SETUP(NAME, words, section, key, whole, options, setup) setup,
static unsigned written(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    const bool by_setup[] = {OVR_MODEL_FEATURE_ROWS(BY_SETUP)};
    unsigned by_options = ovr_model_features_of(&r->values.options);
    unsigned on = ovr_resolved_features(r);
    for (int feature = 0; feature < OVR_MODEL_FEATURES; feature++)
        if (by_setup[feature] ||
            (by_options >> feature & 1 && is_given(r, feature)))
            on |= 1U << feature;
    return on;
}

/* Writes the name of a model feature, "[heat] model = lobatto". */
static void write_name(const ovr_resolved *r, int feature, size_t size,
                       char text[])
{
    ovr_model_feature_info info = ovr_model_feature_at(feature);
    const ovr_slot *slot = ovr_slot_of(r, info.section, info.key);
    if (slot->given && !info.whole && feature != OVR_MODEL_REVERSAL)
        snprintf(text, size, "[%s] %s = %s", info.section, info.key,
                 slot->text);
    else
        snprintf(text, size, "%s", info.name);
}

static ovr_status refuse(const ovr_resolved *r, const ovr_conflict *conflict,
                         ovr_error *err)
{
    const ovr_model_feature_info feature = ovr_model_feature_at(
        conflict->feature);
    const ovr_slot *slot = ovr_slot_of(r, feature.section, feature.key);
    char beside[100];
    write_name(r, conflict->other, sizeof beside, beside);
    return ovr_fail_slot(err, slot, "%s cannot be combined with %s; use %s",
                         slot->given && !feature.whole ? slot->text
                                                       : feature.name,
                         beside, conflict->instead);
}

/* Refuses what a strip does not support before inputs are checked that it would
 * need in a line contact. */
static ovr_status refuse_in_strip(const ovr_resolved *r, ovr_error *err)
{
    static const int needy[] = {OVR_MODEL_HEAT,    OVR_MODEL_SUPPLY,
                                OVR_MODEL_PASSES,  OVR_MODEL_BOUNDARY,
                                OVR_MODEL_COATING, OVR_MODEL_STRESS,
                                OVR_MODEL_PLASTIC, OVR_MODEL_FATIGUE};
    if (!ovr_block_is_there(ovr_case_find_block(r->c, "strip", NULL)))
        return OVR_OK;
    for (size_t k = 0; k < sizeof needy / sizeof *needy; k++) {
        ovr_model_feature_info feature = ovr_model_feature_at(needy[k]);
        const ovr_conflict *conflict = ovr_conflict_among(
            1U << needy[k] | 1U << OVR_MODEL_STRIP);
        const ovr_block *block = ovr_block_of(r, feature.section);
        const ovr_slot *slot = block ? ovr_block_get(block, feature.key) : NULL;
        bool whole = block && block->section->whole;
        bool on = whole ? ovr_block_is_there(block) : slot && slot->given;
        if (conflict && on &&
            (whole || strcmp(slot->text, conflict->instead) != 0))
            return refuse(r, conflict, err);
    }
    return OVR_OK;
}

static ovr_status resolve_conflicts(const ovr_resolved *r, ovr_error *err)
{
    const ovr_conflict *conflict = ovr_conflict_among(written(r));
    return conflict ? refuse(r, conflict, err) : OVR_OK;
}

/* ---------------------------------------------------------- complete case */

ovr_setup *ovr_case_resolve(const ovr_case *c, const ovr_allocator *allocator,
                            ovr_error *err)
{
    if (!c)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_resolved *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    ovr_status status;
    if (!r)
        return NULL;
    r->arena = arena;
    r->c = c;
    r->setup.resolved = r;
    r->setup.contact = &r->contact;
    r->setup.lubricant = &r->lubricant;
    r->setup.options = &r->values.options;
    r->setup.march = &r->values.march;
    r->setup.passes = &r->values.passes;
    r->setup.output = &r->values.output;
    status = ovr_case_check_ineffective(c, err);
    if (!status)
        status = refuse_in_strip(r, err);
    if (!status)
        status = ovr_resolve_contact(r, err);
    if (!status)
        status = ovr_resolve_flow(r, err);
    if (!status)
        status = resolve_options(r, err);
    if (!status)
        status = ovr_resolve_time(r, err);
    if (!status)
        status = resolve_features(r, err);
    if (!status)
        status = ovr_resolve_yield(r, err);
    if (!status)
        status = ovr_resolve_physics(r, err);
    if (!status)
        status = resolve_output(r, err);
    if (!status)
        status = resolve_conflicts(r, err);
    if (!status)
        return &r->setup;
    ovr_setup_free(&r->setup);
    return NULL;
}

void ovr_setup_free(ovr_setup *setup)
{
    ovr_arena arena;
    if (!setup)
        return;
    ovr_surfaces_free(setup->surfaces);
    ovr_history_free(setup->load);
    ovr_history_free(setup->radius);
    ovr_history_free(setup->radius_1);
    ovr_history_free(setup->speed);
    ovr_history_free(setup->sliding);
    ovr_flow_law_free(setup->resolved->flow_law);
    ovr_resolved_drop(setup->resolved);
    for (int k = 0; k < 2; k++)
        ovr_law_table_free(setup->resolved->tables[k]);
    ovr_resolved_element_free(setup->resolved);
    arena = setup->resolved->arena;
    ovr_arena_release(&arena);
}
