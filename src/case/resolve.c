/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * From a case to what runs: first the contact, which gives the scales, then
 * everything else in its units.
 */
#include "case/resolve.h"
#include "case/domain.h"
#include "case/resolve_element.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "multigrid/hierarchy.h"
#include "overroll/results.h"
#include "surface/layer.h"

static const double ALPHA_PAPER = 1.7e-8; /* 1/Pa */

/* ----------------------------------------------------- where errors belong */

static const ovr_slot *given_slot(const ovr_block *block, const char *key)
{
    for (size_t k = 0; block && key && k < block->count; k++)
        if (block->slots[k].given && !strcmp(block->slots[k].key, key))
            return &block->slots[k];
    return NULL;
}

ovr_status ovr_fail_in(ovr_error *err, const ovr_case *c,
                       const ovr_block *block, const ovr_block *other,
                       const ovr_error *why)
{
    const ovr_slot *slot = given_slot(block, why->about);
    if (!slot)
        slot = given_slot(other, why->about);
    return slot ? ovr_fail_from(err, why, slot->file, slot->line)
                : ovr_fail_from(err, why, c->name, block->line);
}

/* --------------------------------------------------------------- scaling */

static double scale_of(const ovr_contact *contact, ovr_hertzian hertzian)
{
    switch (hertzian) {
    case OVR_NOT_HERTZIAN: break;
    case OVR_IN_B: return contact->b;
    case OVR_IN_HEIGHT: return contact->height;
    case OVR_IN_TIME: return contact->time;
    case OVR_IN_PRESSURE: return contact->ph;
    case OVR_IN_AREA: return contact->b * contact->height;
    }
    return 1;
}

static ovr_status no_scale(const ovr_parameter *row, const ovr_slot *slot,
                           ovr_error *err)
{
    const char *add = row->hertzian == OVR_IN_TIME
                          ? "radius, modulus and viscosity (or speeds)"
                          : "radius and modulus";
    return ovr_fail_slot(err, slot,
                         "%s needs a physical contact: add %s (and "
                         "alpha), or give it in %s without a unit",
                         slot->text, add, ovr_hertzian_name(row->hertzian));
}

/* Hertzian value of a number of the slot, checked against the range. */
static ovr_status scale(const ovr_resolved *r, const ovr_parameter *row,
                        const ovr_slot *slot, double *number, ovr_error *err)
{
    double unit = scale_of(&r->contact, row->hertzian);
    ovr_error why = {0};
    if (!slot->unit || !row->hertzian)
        return OVR_OK;
    if (isnan(unit))
        return no_scale(row, slot, err);
    *number /= unit;
    if (ovr_range_check(row, *number, slot->text, &why))
        return ovr_fail_slot(err, slot, "%.400s; it is %g %s", why.message,
                             *number, ovr_hertzian_name(row->hertzian));
    return OVR_OK;
}

static ovr_status fill_list(ovr_resolved *r, const ovr_parameter *row,
                            const ovr_slot *slot, ovr_list *list,
                            ovr_error *err)
{
    size_t n = slot->list.count;
    double *values = ovr_arena_take(&r->arena, n, sizeof *values, err);
    if (!values)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < n; i++) {
        values[i] = slot->list.values[i];
        if (scale(r, row, slot, &values[i], err))
            return OVR_BAD_INPUT;
    }
    *list = (ovr_list){n, values};
    return OVR_OK;
}

/* A path in a file starts where the file is. */
static const char *full_path(ovr_resolved *r, const ovr_slot *slot,
                             ovr_error *err)
{
    const char *folder = r->c->directory;
    size_t room;
    char *path;
    if (!folder || slot->text[0] == '/' || slot->line == 0)
        return ovr_arena_text(&r->arena, slot->text, err);
    room = strlen(folder) + strlen(slot->text) + 2;
    path = ovr_arena_take(&r->arena, room, 1, err);
    if (path)
        snprintf(path, room, "%s/%s", folder, slot->text);
    return path;
}

/* ---------------------------------------------------------------- filling */

static ovr_status fill(ovr_resolved *r, const ovr_parameter *row,
                       const ovr_slot *slot, void *place, ovr_error *err)
{
    double number = slot->number;
    switch (row->kind) {
    case OVR_NUMBER:
        if (!slot->word && scale(r, row, slot, &number, err))
            return OVR_BAD_INPUT;
        *(double *)place = number;
        break;
    case OVR_INTEGER:
    case OVR_CHOICE: *(int *)place = (int)number; break;
    case OVR_FLAG: *(bool *)place = number != 0; break;
    case OVR_TEXT:
        *(const char **)place = ovr_arena_text(&r->arena, slot->text, err);
        return *(const char **)place ? OVR_OK : OVR_NO_MEMORY;
    case OVR_PATH:
        *(const char **)place = full_path(r, slot, err);
        return *(const char **)place ? OVR_OK : OVR_NO_MEMORY;
    case OVR_NUMBERS: return fill_list(r, row, slot, place, err);
    case OVR_WORDS: *(unsigned *)place = slot->bits; break;
    }
    return OVR_OK;
}

ovr_status ovr_block_fill(ovr_resolved *r, const ovr_block *block, void *into,
                          ovr_error *err)
{
    for (size_t k = 0; k < block->count; k++) {
        const ovr_parameter *row = &block->section->rows[k];
        const ovr_slot *slot = &block->slots[k];
        ovr_status status;
        if (!slot->text)
            continue;
        status = fill(r, row, slot, (char *)into + row->place, err);
        if (status)
            return status;
    }
    return OVR_OK;
}

const ovr_block *ovr_block_of(const ovr_resolved *r, const char *section)
{
    return ovr_case_find_block(r->c, section, NULL);
}

const ovr_slot *ovr_slot_of(const ovr_resolved *r, const char *section,
                            const char *key)
{
    return ovr_block_get(ovr_block_of(r, section), key);
}

static ovr_status fill_section(ovr_resolved *r, const char *section,
                               ovr_error *err)
{
    return ovr_block_fill(r, ovr_block_of(r, section), &r->values, err);
}

/* ---------------------------------------------------------------- contact */

/* viscosity and alpha may stand in [contact] or in [lubricant]. */
static ovr_status check_twice(const ovr_resolved *r, const char *key,
                              ovr_error *err)
{
    const ovr_slot *one = ovr_slot_of(r, "contact", key);
    const ovr_slot *other = ovr_slot_of(r, "lubricant", key);
    if (!one->given || !other->given)
        return OVR_OK;
    return ovr_fail_slot(err, other,
                         "is given in [contact] too: leave one out");
}

static ovr_status resolve_contact(ovr_resolved *r, ovr_error *err)
{
    ovr_conditions *given = &r->values.contact;
    const ovr_block *contact = ovr_block_of(r, "contact");
    const ovr_block *lubricant = ovr_block_of(r, "lubricant");
    ovr_error why = {0};
    bool numbers;
    *given = ovr_conditions_default();
    r->values.flow = ovr_flow_form_default();
    r->values.carreau_stress = r->values.carreau_number = NAN;
    if (check_twice(r, "viscosity", err) || check_twice(r, "alpha", err))
        return OVR_BAD_INPUT;
    r->values.oil = ovr_oil_default();
    r->values.iso_vg = NAN;
    r->values.heat = ovr_heat_form_default();
    if (fill_section(r, "contact", err) || fill_section(r, "lubricant", err) ||
        fill_section(r, "heat", err))
        return OVR_BAD_INPUT;
    r->setup.bearable = r->values.bearable;
    if (ovr_resolve_element_keys(r, err) || ovr_resolve_bodies(r, err) ||
        ovr_resolve_element(r, err) || ovr_resolve_oil(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    numbers = !isnan(given->M) || !isnan(given->L) || !isnan(given->lambda) ||
              !isnan(given->alphabar);
    if (numbers && isnan(given->alpha) && isnan(given->hertz_pressure))
        given->alpha = ALPHA_PAPER;
    if (ovr_contact_resolve(given, &r->contact, &why))
        return ovr_fail_in(err, r->c, contact, lubricant, &why);
    if (ovr_oil_scale(&r->values.oil, &r->contact, &r->lubricant, &why))
        return ovr_fail_in(err, r->c, contact, lubricant, &why);
    return OVR_OK;
}

/* ------------------------------------------------------------------- grid */

static int nodes_of(int level)
{
    return (int)ovr_level_nodes(level);
}

static ovr_status resolve_level(ovr_resolved *r, ovr_error *err)
{
    const ovr_slot *nodes = ovr_slot_of(r, "domain", "nodes");
    const ovr_slot *level = ovr_slot_of(r, "domain", "level");
    int k = 1, wanted = r->values.nodes;
    if (!nodes->given)
        return OVR_OK;
    if (level->given)
        return ovr_fail_slot(err, nodes, "level is given too: leave one out");
    while (k < OVR_LEVELS - 1 && nodes_of(k) < wanted)
        k++;
    if (k > 1 && nodes_of(k) - wanted > wanted - nodes_of(k - 1))
        k--;
    if (nodes_of(k) != wanted)
        return ovr_fail_slot(err, nodes,
                             "%d must be 7 2^k + 1; the nearest is %d "
                             "(level %d)",
                             wanted, nodes_of(k), k);
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
    if (o->level && o->coarsest_level > o->level)
        return ovr_fail_slot(err, ovr_slot_of(r, "solver", "coarsest_level"),
                             "%d must not be above the level "
                             "%d",
                             o->coarsest_level, o->level);
    return OVR_OK;
}

static ovr_status resolve_options(ovr_resolved *r, ovr_error *err)
{
    ovr_status status;
    r->values.options = ovr_options_default();
    if (fill_section(r, "domain", err) || fill_section(r, "solver", err) ||
        fill_section(r, "paper", err) || fill_section(r, "time", err) ||
        fill_section(r, "cavitation", err) || fill_section(r, "supply", err))
        return OVR_BAD_INPUT;
    r->values.passes.side_flow = NAN;
    r->values.passes.spacing = r->values.passes.recovery = NAN;
    if (fill_section(r, "passes", err))
        return OVR_BAD_INPUT;
    status = resolve_level(r, err);
    if (!status)
        status = check_solver(r, err);
    r->setup.accuracy_of = (ovr_accuracy)r->values.accuracy_of;
    r->setup.accuracy = r->values.options.level ? 0 : r->values.accuracy;
    return status;
}

/* ------------------------------------------------------------------- time */

/* Steps of one mesh along the characteristic carry what moves without error;
 * with others, and under histories, the separate terms do better. */
static ovr_scheme choose_scheme(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    bool grid = s->transient && !s->march->adaptive && s->march->dT == 0;
    if (r->values.scheme >= 0)
        return (ovr_scheme)r->values.scheme;
    if (r->values.options.cavitation == OVR_CAVITATION_CONSERVING)
        return OVR_UPSTREAM2;
    return grid && !ovr_setup_varies(s) ? OVR_CHARACTERISTIC : OVR_UPSTREAM2;
}

static ovr_status resolve_radius(ovr_resolved *r,
                                 const ovr_allocator *allocator, ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_setup *s = &r->setup;
    if (fill_section(r, "radius", err) || fill_section(r, "radius_1", err))
        return OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "radius", &v->radius, allocator, &s->radius,
                            err))
        return err ? err->status : OVR_BAD_INPUT;
    return ovr_resolve_history(r, "radius_1", &v->radius_1, allocator,
                               &s->radius_1, err);
}

static ovr_status resolve_time(ovr_resolved *r, const ovr_allocator *allocator,
                               ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_setup *s = &r->setup;
    s->transient = ovr_slot_of(r, "time", "end")->given || ovr_element_moves(r);
    r->march = ovr_march_default();
    r->march.end = s->transient ? v->end : 0;
    r->march.adaptive = v->step == OVR_STEP_ADAPTIVE;
    r->march.dT = r->march.adaptive ? 0 : v->step;
    r->march.error = v->error;
    r->march.until_steady = v->until_steady && s->transient;
    if (fill_section(r, "load", err) || fill_section(r, "speed", err))
        return OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "load", &v->load, allocator, &s->load, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "speed", &v->speed, allocator, &s->speed, err))
        return err ? err->status : OVR_BAD_INPUT;
    v->sliding.from = v->sliding.to = NAN;
    if (fill_section(r, "sliding", err))
        return OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "sliding", &v->sliding, allocator, &s->sliding,
                            err))
        return err ? err->status : OVR_BAD_INPUT;
    if (resolve_radius(r, allocator, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (ovr_resolve_element_histories(r, allocator, err))
        return err ? err->status : OVR_BAD_INPUT;
    s->options->scheme = choose_scheme(r);
    return ovr_resolve_supply(r, allocator, err);
}

/* --------------------------------------------------------------- features */

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
    to->source.spacing_scaled = true; /* like all lengths here: in b */
    if (form->shape == OVR_ROUGHNESS) {
        to->roughness.length = form->length;
        form->length = NAN;
    }
    return status;
}

static ovr_status resolve_features(ovr_resolved *r, ovr_error *err)
{
    ovr_feature_settings *settings;
    const ovr_feature_form **form;
    size_t n = 0;
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        n += ovr_block_is_feature(b);
    settings = ovr_arena_take(&r->arena, n, sizeof *settings, err);
    form = ovr_arena_take(&r->arena, n, sizeof *form, err);
    if (!settings || !form)
        return OVR_NO_MEMORY;
    r->setup.feature = form;
    r->setup.features = n;
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        if (ovr_block_is_feature(b)) {
            ovr_status status = fill_feature(r, b, settings, err);
            if (status)
                return status;
            *form++ = &settings++->form;
        }
    return OVR_OK;
}

/* ----------------------------------------------------------------- output */

/* What the physics that is on adds to the fields where none are given. */
static unsigned fields_of_physics(const ovr_resolved *r)
{
    unsigned fields = 0;
    if (r->values.options.cavitation == OVR_CAVITATION_CONSERVING)
        fields |= ovr_field_bit("filling") | ovr_field_bit("oil_content");
    if (r->setup.heat)
        fields |= ovr_field_bit("temperature_1") |
                  ovr_field_bit("temperature_2") |
                  ovr_field_bit("temperature_middle");
    return fields;
}

static ovr_status resolve_output(ovr_resolved *r, ovr_error *err)
{
    ovr_output *out = &r->values.output;
    out->from = out->to = NAN;
    if (fill_section(r, "output", err))
        return OVR_BAD_INPUT;
    if (!ovr_slot_of(r, "output", "fields")->given)
        out->fields |= fields_of_physics(r);
    out->every = r->values.every;
    out->single = r->values.precision == 1;
    if (out->from >= out->to)
        return ovr_fail_slot(err, ovr_slot_of(r, "output", "from"),
                             "%g must be below to = %g", out->from, out->to);
    return OVR_OK;
}

/* -------------------------------------------------------------- all of it */

static void set_sizes(ovr_resolved *r)
{
    r->setup.size = sizeof r->setup;
    r->supply.size = sizeof r->supply;
    r->values.passes.size = sizeof r->values.passes;
    r->values.output.size = sizeof r->values.output;
    r->values.stress.size = sizeof r->values.stress;
}

ovr_setup *ovr_case_resolve(const ovr_case *c, const ovr_allocator *allocator,
                            ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_resolved *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    ovr_status status;
    if (!r)
        return NULL;
    r->arena = arena;
    r->c = c;
    set_sizes(r);
    r->setup.contact = &r->contact;
    r->setup.lubricant = &r->lubricant;
    r->setup.options = &r->values.options;
    r->setup.march = &r->march;
    r->setup.supply = &r->supply;
    r->setup.passes = &r->values.passes;
    r->setup.output = &r->values.output;
    r->setup.stress = &r->values.stress;
    status = ovr_case_check_idle(c, err);
    if (!status)
        status = resolve_contact(r, err);
    if (!status)
        status = ovr_resolve_flow(r, allocator, err);
    if (!status)
        status = resolve_options(r, err);
    if (!status)
        status = resolve_time(r, allocator, err);
    if (!status)
        status = ovr_resolve_heat(r, err);
    if (!status)
        status = ovr_resolve_physics(r, err);
    if (!status)
        status = resolve_features(r, err);
    if (!status)
        status = resolve_output(r, err);
    if (!status)
        status = ovr_resolve_stress(r, err);
    if (!status)
        status = ovr_resolve_parts(r, err);
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
    ovr_flow_law_free(((ovr_resolved *)setup)->flow_law);
    ovr_history_free(setup->supply->history);
    for (int k = 0; k < 2; k++)
        ovr_layer_free(setup->supply->layer[k]);
    for (int k = 0; k < 2; k++)
        ovr_law_table_free(((ovr_resolved *)setup)->tables[k]);
    ovr_resolved_element_free((ovr_resolved *)setup);
    arena = ((ovr_resolved *)setup)->arena;
    ovr_arena_release(&arena);
}
