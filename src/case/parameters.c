/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/parameters.h"

#include <string.h>

#include "base/given.h"
#include "case/condition.h"
#include "case/keys/keys.h"
#include "simulation/heat_case.h"
#include "simulation/physics.h"

/* Help and files have them in this order. */
static const ovr_section *const sections[] = {
    &ovr_contact_section, &ovr_lubricant_section, &ovr_heat_section,
    &ovr_domain_section,  &ovr_solver_section,    &ovr_time_section,
    &ovr_load_section,    &ovr_speed_section,     &ovr_sliding_section,
    &ovr_radius_section,  &ovr_radius_1_section,  &ovr_cavitation_section,
    &ovr_supply_section,  &ovr_passes_section,    &ovr_feature_section,
    &ovr_output_section,  &ovr_paper_section,     &ovr_stress_section,
    &ovr_fatigue_section, &ovr_plastic_section,   &ovr_body_section,
    &ovr_gear_section,    &ovr_cam_section,       &ovr_roller_bearing_section};
enum { SECTIONS = sizeof sections / sizeof sections[0] };

static bool is_among(const ovr_section *section)
{
    for (size_t k = 0; k < SECTIONS; k++)
        if (sections[k] == section)
            return true;
    return false;
}

/* Behind them the sections of physics that are not among them. */
const ovr_section *ovr_section_row(size_t k)
{
    if (k < SECTIONS)
        return sections[k];
    k -= SECTIONS;
    for (int p = 0; ovr_physics_list[p]; p++) {
        const ovr_section *own = ovr_physics_list[p]->section;
        if (own && !is_among(own) && k-- == 0)
            return own;
    }
    return NULL;
}

const ovr_section *ovr_section_find(const char *name)
{
    const ovr_section *s;
    for (size_t k = 0; (s = ovr_section_row(k)); k++)
        if (!strcmp(s->name, name))
            break;
    return s;
}

size_t ovr_section_first(const ovr_section *section)
{
    const ovr_section *s;
    size_t n = 0;
    for (size_t k = 0; (s = ovr_section_row(k)) && s != section; k++)
        n += s->count;
    return n;
}

const ovr_parameter *ovr_parameter_row(size_t k, const ovr_section **section)
{
    const ovr_section *s;
    for (size_t j = 0; (s = ovr_section_row(j)); j++) {
        if (k < s->count) {
            if (section)
                *section = s;
            return &s->rows[k];
        }
        k -= s->count;
    }
    return NULL;
}

/* Sections, and where keys that they once had are now. */
static const struct {
    const char *before, *now;
} moved[] = {{"solver", "paper"}};

const ovr_section *ovr_section_now(const ovr_section *before, const char *key)
{
    for (size_t k = 0; k < sizeof moved / sizeof *moved; k++) {
        const ovr_section *now = ovr_section_find(moved[k].now);
        if (now && !strcmp(before->name, moved[k].before) &&
            !ovr_parameter_find(before, key) && ovr_parameter_find(now, key))
            return now;
    }
    return before;
}

bool ovr_parameter_is(const ovr_parameter *row, const char *key)
{
    return !strcmp(row->key, key) || (row->once && !strcmp(row->once, key));
}

const ovr_parameter *ovr_parameter_find(const ovr_section *section,
                                        const char *key)
{
    for (size_t k = 0; k < section->count; k++)
        if (ovr_parameter_is(&section->rows[k], key))
            return &section->rows[k];
    return NULL;
}

/* ------------------------------------------------------------- for people */

size_t ovr_parameter_count(void)
{
    size_t n = 0;
    for (size_t k = 0; ovr_section_row(k); k++)
        n += ovr_section_row(k)->count;
    return n;
}

const char *ovr_section_name(size_t k)
{
    const ovr_section *section = ovr_section_row(k);
    return section ? section->name : NULL;
}

bool ovr_section_named(size_t k)
{
    const ovr_section *section = ovr_section_row(k);
    return section && section->named;
}

const char *ovr_section_help(size_t k)
{
    const ovr_section *section = ovr_section_row(k);
    return section ? section->help : NULL;
}

static const char *type_name(ovr_kind kind)
{
    switch (kind) {
    case OVR_NUMBER: return "number";
    case OVR_INTEGER: return "whole number";
    case OVR_CHOICE: return "choice";
    case OVR_FLAG: return "yes or no";
    case OVR_TEXT: return "text";
    case OVR_PATH: return "path";
    case OVR_NUMBERS: return "numbers";
    case OVR_WORDS: return "words";
    }
    return "";
}

const char *ovr_hertzian_name(ovr_hertzian hertzian)
{
    switch (hertzian) {
    case OVR_NOT_HERTZIAN: break;
    case OVR_IN_B: return "b";
    case OVR_IN_HEIGHT: return "b^2/R";
    case OVR_IN_TIME: return "b/um";
    case OVR_IN_PRESSURE: return "ph";
    case OVR_IN_AREA: return "b^3/R";
    }
    return "";
}

ovr_parameter_info ovr_parameter_at(size_t k)
{
    const ovr_section *section = sections[0];
    const ovr_parameter *found = ovr_parameter_row(k, &section);
    const ovr_parameter *row = found ? found : section->rows;
    ovr_parameter_info info = {
        .section = section->name,
        .key = row->key,
        .type = type_name(row->kind),
        .units = ovr_units_allowed(row->dimension),
        .bare = ovr_hertzian_name(row->hertzian),
        .initial = row->initial,
        .minimum = row->minimum,
        .maximum = row->maximum,
        .above = row->above,
        .physics = row->physics,
        .help = row->help,
    };
    for (size_t i = 0; row->words && row->words[i].name && i < 23; i++)
        info.choices[i] = row->words[i].name;
    ovr_when_text(row, info.when, sizeof info.when);
    return info;
}
