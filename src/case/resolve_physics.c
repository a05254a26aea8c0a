/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Physical models of a case (simulation/physics.h): their sections fill their
 * forms, whose values determine the active models. */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "case/when.h"
#include "elements/elements.h"
#include "results/results.h"

/* Data for a physical model's queries about the case. */
typedef struct asker {
    ovr_resolved *r;
    const ovr_physics_in_case *physics;
} asker;

/* Returns the case functions of physical model k; empty if it has none. */
static const ovr_physics_in_case *in_case(int k)
{
    static const ovr_physics_in_case none;
    const ovr_physics_in_case *part = ovr_physics_list[k]->in_case;
    return part ? part : &none;
}

static bool is_on(const ovr_resolved *r, int k)
{
    const ovr_physics_in_solve *solve = ovr_physics_list[k]->in_solve;
    return r->physics[k].on ||
           (solve && solve->chosen && solve->chosen(r->setup.options));
}

/* Returns the statements of the form of physics k, defaults where it is off. */
static ovr_physics_effects effects_of(const ovr_resolved *r, int k)
{
    ovr_physics_effects effects = {.arrives = INFINITY};
    if (in_case(k)->effects && is_on(r, k))
        in_case(k)->effects(r->physics[k].form, &effects);
    return effects;
}

/* Returns the slot of a key in one of the model's sections. */
static const ovr_slot *own_slot(const asker *a, const char *key)
{
    const ovr_section *of = a->physics->section;
    while (!ovr_parameter_find(of, key))
        of++;
    return ovr_slot_of(a->r, of->name, key);
}

static ovr_status read_columns(void *data, const char *key, const char *file,
                               ovr_two_columns *to, ovr_error *err)
{
    const asker *a = data;
    ovr_status status = ovr_slot_columns(own_slot(a, key), file, to,
                                         &a->r->arena, err);
    if (status)
        err->about = OVR_HAS_PLACE;
    return status;
}

static bool is_given(void *data, const char *section, const char *key)
{
    const ovr_resolved *r = ((asker *)data)->r;
    return key ? ovr_slot_of(r, section, key)->given
               : ovr_block_is_there(ovr_block_of(r, section));
}

static ovr_status make_history(void *data, const char *section,
                               const ovr_change *change, ovr_history **history,
                               ovr_error *err)
{
    const asker *a = data;
    ovr_status status = ovr_resolve_history(a->r, section, change, history,
                                            err);
    if (status)
        err->about = OVR_HAS_PLACE;
    return status;
}

/* Returns the physical models that are turned on by a key; available before any
 * is resolved. */
static unsigned switched_on(const ovr_resolved *r)
{
    unsigned bits = 0;
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_physics_in_case *p = in_case(k);
        for (size_t j = 0; j < p->sections; j++) {
            const ovr_section *s = &p->section[j];
            if (s->on && ovr_slot_of(r, s->name, s->on)->number > 0)
                bits |= ovr_physics_list[k]->bit;
        }
    }
    return bits;
}

static ovr_physics_case about(ovr_resolved *r)
{
    const ovr_bearing_geometry *g = ovr_bearing_of(r->element.bearing);
    ovr_physics_case of = {
        .setup = &r->setup,
        .contact = &r->contact,
        .lubricant = &r->lubricant,
        .options = &r->values.options,
        .passes = &r->values.passes,
        .transient = r->setup.transient,
        .end = r->setup.transient && isfinite(r->values.march.end)
                   ? r->values.march.end
                   : 0,
        .speed = r->setup.speed,
        .sliding = r->setup.sliding,
        .oil = &r->values.oil,
        .raceway = g ? g->spacing * r->values.element.bearing.rollers /
                           r->contact.b
                     : NAN,
        .physics = switched_on(r),
        .substrate = r->substrate,
        .by_substrate = r->values.scale == OVR_SCALE_SUBSTRATE,
        .arena = &r->arena,
        .features = r->features,
        .feature = r->feature};
    for (int k = 0; k < 2; k++)
        of.body[k] = (ovr_physics_body){r->body[k].modulus, r->body[k].poisson,
                                        r->body[k].yield, r->body[k].thermal};
    return of;
}

static const ovr_section *section_named(const ovr_physics_in_case *p,
                                        const char *name, size_t length)
{
    for (size_t j = 0; j < p->sections; j++)
        if (strlen(p->section[j].name) == length &&
            !strncmp(p->section[j].name, name, length))
            return &p->section[j];
    return NULL;
}

/* Adds the place of an error's subject: "section.key", a section, a block by
 * its name, or a key of the first section or of [lubricant]. */
static ovr_status fail(const ovr_resolved *r, const ovr_physics_in_case *p,
                       ovr_error *why, ovr_error *err)
{
    const char *about = why->about ? why->about : "";
    size_t length = strcspn(about, ".");
    if (why->about && !strcmp(why->about, OVR_HAS_PLACE))
        return ovr_fail_from(err, why, NULL, 0);
    const ovr_section *of = section_named(p, about, length);
    const ovr_block *block = of ? ovr_block_of(r, of->name) : NULL;
    if (of)
        why->about = about[length] ? about + length + 1 : NULL;
    if (of && why->about) {
        const ovr_slot *slot = ovr_block_get(block, why->about);
        return ovr_fail_from(err, why, slot->file, slot->line);
    }
    if (!block && p->section->named && why->about)
        block = ovr_case_find_block(r->c, p->section->name, about);
    if (!block)
        block = ovr_block_of(r, p->section->name);
    return ovr_fail_in(err, r->c, block, ovr_block_of(r, "lubricant"), why);
}

/* Fills the data of all named blocks of a section. */
static ovr_status fill_named(ovr_resolved *r, const ovr_physics_in_case *p,
                             void *form, ovr_error *err)
{
    ovr_error why = {0};
    for (const ovr_block *b = r->c->blocks; b; b = b->next) {
        void *into;
        if (b->section != p->section)
            continue;
        if (p->block(form, b->name, &into, &why))
            return ovr_fail_in(err, r->c, b, NULL, &why);
        if (ovr_block_fill(r, b, into, err))
            return OVR_BAD_INPUT;
    }
    return OVR_OK;
}

static ovr_status fill(ovr_resolved *r, int k, ovr_error *err)
{
    const ovr_physics_in_case *p = in_case(k);
    void **form = &r->physics[k].form;
    ovr_status status = OVR_OK;
    if (!*form)
        *form = ovr_arena_take(&r->arena, 1, p->form, err);
    if (!*form)
        return OVR_NO_MEMORY;
    if (p->section->named)
        return fill_named(r, p, *form, err);
    for (size_t j = 0; !status && j < p->sections; j++) {
        const ovr_block *block = ovr_block_of(r, p->section[j].name);
        if (!p->section[j].whole || ovr_block_is_there(block))
            status = ovr_block_fill(r, block, *form, err);
    }
    return status;
}

ovr_status ovr_resolve_forms(ovr_resolved *r, ovr_error *err)
{
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_physics_in_case *p = in_case(k);
        if (p->sections && fill(r, k, err))
            return err ? err->status : OVR_BAD_INPUT;
        if (p->choose)
            p->choose(r->physics[k].form, &r->values.options);
    }
    return OVR_OK;
}

bool ovr_resolved_march(ovr_resolved *r)
{
    bool makes = false;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (r->physics[k].form && in_case(k)->march)
            makes |= in_case(k)->march(r->physics[k].form, &r->values.march,
                                       &r->values.scheme);
    return makes;
}

static ovr_status resolve(ovr_resolved *r, int k, ovr_error *err)
{
    const ovr_physics_in_case *p = in_case(k);
    asker by = {r, p};
    ovr_physics_case of = about(r);
    ovr_error why = {0};
    of.read = read_columns;
    of.given = is_given;
    of.history = make_history;
    of.data = &by;
    if (!p->resolve(&of, r->physics[k].form, &r->physics[k].on, &why))
        return OVR_OK;
    return fail(r, p, &why, err);
}

/* -------------------------------------------------------------- stiffness */

/* Computes ln E' of the coated bodies minus ln E', for a contact with the
 * modulus E'. */
static ovr_status stiffness_off(ovr_resolved *r, int k, double log_E,
                                double *off, ovr_error *err)
{
    const ovr_physics_in_case *p = in_case(k);
    ovr_conditions *given = &r->values.contact;
    ovr_error why = {0};
    double ratio = 1;
    given->modulus = exp(log_E);
    if (ovr_contact_resolve(given, &r->contact, &why))
        return ovr_fail_in(err, r->c, ovr_block_of(r, "contact"),
                           ovr_block_of(r, "lubricant"), &why);
    if (fill(r, k, err))
        return err ? err->status : OVR_BAD_INPUT;
    const ovr_physics_case of = about(r);
    if (p->stiffness(&of, r->physics[k].form, &ratio, &why))
        return fail(r, p, &why, err);
    *off = log(ratio * r->substrate) - log_E;
    return OVR_OK;
}

/* Finds the modulus by the secant method, because the stiffness depends on the
 * layer thickness relative to b and b depends on the modulus. */
static ovr_status find_modulus(ovr_resolved *r, int k, ovr_error *err)
{
    enum { STEPS = 40 };
    const double enough = 1e-11;
    double x[2] = {log(r->substrate)}, y[2] = {0, 0};
    ovr_status status = stiffness_off(r, k, x[0], &y[0], err);
    if (status || y[0] == 0)
        return status;
    x[1] = x[0] + y[0];
    status = stiffness_off(r, k, x[1], &y[1], err);
    for (int step = 0; !status && fabs(y[1]) > enough && step < STEPS; step++) {
        double slope = y[1] != y[0] ? (y[1] - y[0]) / (x[1] - x[0]) : -1;
        double to = slope < 0 ? -y[1] / slope : y[1];
        x[0] = x[1];
        y[0] = y[1];
        x[1] += fmin(fmax(to, -1), 1);
        status = stiffness_off(r, k, x[1], &y[1], err);
    }
    return status;
}

static bool has_block(const ovr_resolved *r, const ovr_physics_in_case *p)
{
    for (const ovr_block *b = r->c->blocks; b; b = b->next)
        if (b->section == p->section)
            return true;
    return false;
}

ovr_status ovr_resolve_stiffness(ovr_resolved *r, ovr_error *err)
{
    ovr_status status = OVR_OK;
    r->substrate = r->values.contact.modulus;
    for (int k = 0; !status && ovr_physics_list[k]; k++)
        if (in_case(k)->stiffness && has_block(r, in_case(k)))
            status = find_modulus(r, k, err);
    return status;
}

/* ------------------------------------------------------------- all models */

static bool is_kept(const ovr_resolved *r, const ovr_feature_form *feature)
{
    for (int k = 0; ovr_physics_list[k]; k++)
        if (r->physics[k].on && in_case(k)->keeps &&
            in_case(k)->keeps(r->physics[k].form, feature))
            return true;
    return false;
}

/* Selects the features on the grid: those that no physical model uses alone. */
static ovr_status choose_features(ovr_resolved *r, ovr_error *err)
{
    const ovr_feature_form **on_mesh = ovr_arena_take(&r->arena, r->features,
                                                      sizeof *on_mesh, err);
    if (!on_mesh)
        return OVR_NO_MEMORY;
    r->setup.feature = on_mesh;
    r->setup.features = 0;
    for (size_t k = 0; k < r->features; k++)
        if (!is_kept(r, r->feature[k]))
            on_mesh[r->setup.features++] = r->feature[k];
    return OVR_OK;
}

ovr_status ovr_resolve_physics(ovr_resolved *r, ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (int k = 0; !status && ovr_physics_list[k]; k++)
        if (in_case(k)->sections)
            status = resolve(r, k, err);
    return status ? status : choose_features(r, err);
}

ovr_status ovr_resolve_on_mesh(ovr_resolved *r, ovr_error *err)
{
    const ovr_physics_case of = about(r);
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_physics_in_case *p = in_case(k);
        ovr_error why = {0};
        if (r->physics[k].on && p->on_mesh &&
            p->on_mesh(&of, r->physics[k].form, r->setup.mesh, &why))
            return fail(r, p, &why, err);
    }
    return OVR_OK;
}

unsigned ovr_setup_physics(const ovr_setup *setup)
{
    if (!setup)
        return 0;
    const ovr_resolved *r = setup->resolved;
    unsigned bits = setup->features ? OVR_PHYSICS_FEATURES : 0;
    for (int k = 0; ovr_physics_list[k]; k++) {
        if (is_on(r, k))
            bits |= ovr_physics_list[k]->bit | effects_of(r, k).bits;
    }
    return bits;
}

ovr_status ovr_setup_add_physics(const ovr_setup *setup, ovr_simulation *sim,
                                 ovr_error *err)
{
    const ovr_resolved *r = setup->resolved;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (r->physics[k].on &&
            ovr_physics_add(sim, ovr_physics_list[k], r->physics[k].form, err))
            return err ? err->status : OVR_BAD_INPUT;
    return OVR_OK;
}

const ovr_coated *ovr_setup_layers(const ovr_setup *setup, int body)
{
    const ovr_resolved *r = setup->resolved;
    const ovr_coated *layers = NULL;
    for (int k = 0; !layers && ovr_physics_list[k]; k++)
        if (r->physics[k].on && in_case(k)->layers)
            layers = in_case(k)->layers(r->physics[k].form, body);
    return layers;
}

void *ovr_setup_form(const ovr_setup *setup, const char *section)
{
    const ovr_resolved *r = setup->resolved;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (section_named(in_case(k), section, strlen(section)))
            return r->physics[k].form;
    return NULL;
}

bool ovr_setup_has(const ovr_setup *setup, int k)
{
    return is_on(setup->resolved, k);
}

const ovr_physics *ovr_setup_makes_nodes(const ovr_setup *setup)
{
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_physics_in_solve *solve = ovr_physics_list[k]->in_solve;
        if (solve && solve->makes_nodes && ovr_setup_has(setup, k))
            return ovr_physics_list[k];
    }
    return NULL;
}

/* Returns the memory of physical models in bytes, also of companions of the
 * simulation. The grid must be known. */
static double physics_memory(const ovr_setup *setup)
{
    const ovr_resolved *r = setup->resolved;
    double bytes = 0;
    for (int k = 0; setup->nodes && ovr_physics_list[k]; k++)
        if (r->physics[k].on && in_case(k)->memory)
            bytes += in_case(k)->memory(r->physics[k].form);
    return bytes;
}

double ovr_setup_seconds_of_physics(const ovr_setup *setup, double node_steps)
{
    const ovr_resolved *r = setup->resolved;
    double seconds = 0;
    for (int k = 0; setup->nodes && ovr_physics_list[k]; k++)
        if (is_on(r, k)) {
            const ovr_physics_in_case *is = in_case(k);
            seconds += node_steps * is->node_seconds;
            if (r->physics[k].on && is->seconds)
                seconds += is->seconds(r->physics[k].form);
        }
    return seconds;
}

double ovr_setup_strip_cycle(const ovr_setup *setup)
{
    const ovr_resolved *r = setup->resolved;
    double seconds = 0;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (is_on(r, k) && in_case(k)->cycle_seconds)
            seconds = in_case(k)->cycle_seconds(r->physics[k].form);
    return seconds;
}

unsigned ovr_resolved_features(const ovr_resolved *r)
{
    unsigned on = 0;
    for (int k = 0; ovr_physics_list[k]; k++)
        on |= effects_of(r, k).features;
    return on;
}

/* Returns the bits of the fields listed in `names`, separated by ", "; NULL:
 * none. */
static unsigned bits_of(const char *names)
{
    char name[OVR_CONDITION_MAX];
    unsigned fields = 0;
    while (names && ovr_condition_next(&names, ", ", name, sizeof name))
        fields |= ovr_field_bit(name);
    return fields;
}

unsigned ovr_resolved_fields(const ovr_resolved *r)
{
    unsigned fields = 0;
    for (int k = 0; ovr_physics_list[k]; k++)
        fields |= bits_of(effects_of(r, k).fields);
    return fields;
}

unsigned ovr_resolved_no_fields(const ovr_resolved *r, const ovr_physics **off)
{
    unsigned asked = ovr_slot_of(r, "output", "fields")->bits, none = 0;
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_physics_in_case *p = in_case(k);
        const ovr_own_fields *its = is_on(r, k) ? NULL : p->own_fields;
        unsigned own = asked & bits_of(its ? its->names : NULL);
        if (own && !none)
            *off = ovr_physics_list[k];
        none |= own;
    }
    return none;
}

const char *ovr_resolved_one_mesh(const ovr_resolved *r)
{
    const char *why = NULL;
    for (int k = 0; !why && ovr_physics_list[k]; k++)
        why = is_on(r, k) ? in_case(k)->one_mesh : NULL;
    return why;
}

double ovr_setup_lag(const ovr_setup *setup)
{
    const ovr_resolved *r = setup->resolved;
    double lag = 0;
    for (int k = 0; ovr_physics_list[k]; k++)
        lag += is_on(r, k) ? in_case(k)->lag : 0;
    return lag;
}

double ovr_resolved_width(const ovr_resolved *r)
{
    double width = 0;
    for (int k = 0; ovr_physics_list[k]; k++)
        width = fmax(width, effects_of(r, k).width_across);
    return width;
}

size_t ovr_resolved_lines(const ovr_resolved *r, double D)
{
    size_t lines = 1;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (is_on(r, k) && in_case(k)->lines_across)
            lines = in_case(k)->lines_across(r->physics[k].form, D);
    return lines;
}

size_t ovr_setup_lines(const ovr_setup *setup)
{
    return ovr_resolved_lines(setup->resolved, setup->mesh);
}

double ovr_setup_width(const ovr_setup *setup)
{
    return ovr_resolved_width(setup->resolved);
}

double ovr_resolved_supply(const ovr_resolved *r)
{
    double film = INFINITY;
    for (int k = 0; ovr_physics_list[k]; k++)
        film = fmin(film, effects_of(r, k).arrives);
    return film;
}

void ovr_resolved_drop(ovr_resolved *r)
{
    for (int k = 0; ovr_physics_list[k]; k++)
        if (r->physics[k].form && in_case(k)->drop)
            in_case(k)->drop(r->physics[k].form);
}

void ovr_setup_equip(const ovr_setup *setup, ovr_simulation *sim)
{
    const ovr_resolved *r = setup->resolved;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (is_on(r, k) && ovr_physics_list[k]->in_solve &&
            ovr_physics_list[k]->in_solve->equip)
            ovr_physics_list[k]->in_solve->equip(sim, r->physics[k].form);
}

double ovr_setup_memory(const ovr_setup *setup)
{
    if (!setup)
        return NAN;
    ovr_simulation *sim = ovr_simulation_counted(setup->options);
    double bytes = INFINITY;
    if (sim && !ovr_setup_add_physics(setup, sim, NULL))
        bytes = (double)sim->arena.bytes + physics_memory(setup);
    ovr_simulation_free(sim);
    return bytes;
}

void ovr_setup_describe(const ovr_setup *setup, ovr_setup_line *line,
                        void *data)
{
    if (!line)
        return;
    if (!setup)
        return;
    ovr_resolved *r = setup->resolved;
    const ovr_physics_case of = about(r);
    for (int k = 0; ovr_physics_list[k]; k++)
        if (is_on(r, k) && in_case(k)->describe)
            in_case(k)->describe(&of, r->physics[k].form, line, data);
}
