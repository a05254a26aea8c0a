/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/parameters.h"

#include <string.h>

#include "base/given.h"
#include "case/keys/keys.h"
#include "case/when.h"
#include "simulation/physics.h"

/* Order of sections in help and files. */
static const ovr_section *const sections[] = {
    &ovr_contact_section,  &ovr_lubricant_section, &ovr_domain_section,
    &ovr_solver_section,   &ovr_time_section,      &ovr_load_section,
    &ovr_speed_section,    &ovr_sliding_section,   &ovr_radius_section,
    &ovr_radius_1_section, &ovr_passes_section,    &ovr_feature_section,
    &ovr_output_section,   &ovr_paper_section,     &ovr_body_section,
    &ovr_gear_section,     &ovr_cam_section,       &ovr_roller_bearing_section};
enum { SECTIONS = sizeof sections / sizeof sections[0] };

/* Iterates over all keys: after each section of the case the keys of physical
 * models that belong there, and at the end the remaining ones. */
typedef struct walk {
    size_t at;   /* index in the table; SECTIONS: past its end */
    bool inside; /* section `at` has been visited; physical models' keys
                  * follow */
    const ovr_physics *const *physics;
    size_t own; /* index within that physical model */
} walk;

static bool follows_section(const ovr_physics_in_case *p, const walk *w)
{
    if (!p || w->own >= p->sections)
        return false;
    if (w->at == SECTIONS)
        return !p->behind;
    return p->behind && !strcmp(p->behind, sections[w->at]->name);
}

/* Returns the next section; NULL at the end. */
static const ovr_section *next(walk *w)
{
    for (; w->at <= SECTIONS; w->at++, w->inside = false) {
        if (!w->inside) {
            w->inside = true;
            w->physics = ovr_physics_list;
            w->own = 0;
            if (w->at < SECTIONS)
                return sections[w->at];
        }
        for (; *w->physics; w->physics++, w->own = 0)
            if (follows_section((*w->physics)->in_case, w))
                return &(*w->physics)->in_case->section[w->own++];
    }
    return NULL;
}

const ovr_section *ovr_section_row(size_t k)
{
    walk w = {0};
    while (k-- > 0 && next(&w))
        continue;
    return next(&w);
}

const ovr_section *ovr_section_find(const char *name)
{
    walk w = {0};
    const ovr_section *s;
    while ((s = next(&w)) && strcmp(s->name, name) != 0)
        continue;
    return s;
}

size_t ovr_section_first(const ovr_section *section)
{
    walk w = {0};
    const ovr_section *s;
    size_t n = 0;
    while ((s = next(&w)) && s != section)
        n += s->count;
    return n;
}

const ovr_parameter *ovr_parameter_row(size_t k, const ovr_section **section)
{
    walk w = {0};
    const ovr_section *s;
    while ((s = next(&w))) {
        if (k < s->count) {
            if (section)
                *section = s;
            return &s->rows[k];
        }
        k -= s->count;
    }
    return NULL;
}

const ovr_parameter *ovr_parameter_find(const ovr_section *section,
                                        const char *key)
{
    for (size_t k = 0; k < section->count; k++)
        if (!strcmp(section->rows[k].key, key))
            return &section->rows[k];
    return NULL;
}

/* --------------------------------------------------------------- for help */

size_t ovr_parameter_count(void)
{
    return ovr_section_first(NULL);
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

const char *ovr_limit_unit(const ovr_parameter *row, double *value)
{
    *value = 1;
    if (row->hertzian)
        return ovr_hertzian_name(row->hertzian);
    if (row->dimension != OVR_ANGLE)
        return ovr_unit_si(row->dimension);
    *value = ovr_unit_value("deg", OVR_ANGLE);
    return "deg";
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
    info.limit_unit = ovr_limit_unit(row, &info.limit_value);
    ovr_when_text(row, info.when, sizeof info.when);
    return info;
}
