/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The physics of a case (simulation/physics.h): their sections fill their
 * forms, and what those mean says which are on. */
#include <math.h>

#include "case/coats.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "case/two_columns.h"
#include "simulation/heat_case.h"

/* A physics reads its files by this: its section. */
typedef struct reader {
    ovr_resolved *r;
    const ovr_physics *physics;
} reader;

static ovr_status read_columns(void *data, const char *key, const char *file,
                               ovr_physics_columns *to, ovr_error *err)
{
    const reader *from = data;
    const ovr_block *block = ovr_block_of(from->r,
                                          from->physics->section->name);
    ovr_two_columns c = {.name = {to->name[0], to->name[1]},
                         .header = {to->of[0], to->of[1]},
                         .example = to->example};
    ovr_status status = ovr_two_columns_read(
        &c, file, ovr_block_get(block, key), &from->r->arena, err);
    to->count = c.count;
    to->x = c.x;
    to->y = c.y;
    return status;
}

/* Physics before heat in the list want to know. */
static bool is_heated(const ovr_resolved *r)
{
    return ovr_slot_of(r, "heat", "model")->number > 0;
}

static ovr_physics_case about(ovr_resolved *r)
{
    ovr_physics_case of = {.contact = &r->contact,
                           .lubricant = &r->lubricant,
                           .options = &r->values.options,
                           .transient = r->setup.transient,
                           .oil = &r->values.oil,
                           .heat = is_heated(r),
                           .substrate = r->substrate,
                           .by_substrate = r->values.scale ==
                                           OVR_SCALE_SUBSTRATE,
                           .arena = &r->arena,
                           .features = r->features,
                           .feature = r->feature};
    for (int k = 0; k < 2; k++)
        of.body[k] = (ovr_physics_body){r->body[k].modulus, r->body[k].poisson,
                                        r->body[k].thermal};
    return of;
}

/* The block that an error is about: by its name, or the section's. */
static const ovr_block *blamed(const ovr_resolved *r, const ovr_physics *p,
                               const ovr_error *why)
{
    const ovr_block *named = p->section->named && why->about
                                 ? ovr_case_find_block(r->c, p->section->name,
                                                       why->about)
                                 : NULL;
    return named ? named : ovr_block_of(r, p->section->name);
}

/* All blocks of a section with names, each to its place in the form. */
static ovr_status fill_named(ovr_resolved *r, const ovr_physics *p, void *form,
                             ovr_error *err)
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

static ovr_status fill(ovr_resolved *r, const ovr_physics *p,
                       ovr_resolved_physics *to, ovr_error *err)
{
    if (!to->form)
        to->form = ovr_arena_take(&r->arena, 1, p->form, err);
    if (!to->form)
        return OVR_NO_MEMORY;
    return p->section->named
               ? fill_named(r, p, to->form, err)
               : ovr_block_fill(r, ovr_block_of(r, p->section->name), to->form,
                                err);
}

static ovr_status resolve(ovr_resolved *r, const ovr_physics *p,
                          ovr_resolved_physics *to, ovr_error *err)
{
    reader from = {r, p};
    ovr_physics_case of = about(r);
    ovr_error why = {0};
    of.read = read_columns;
    of.data = &from;
    if (fill(r, p, to, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (p->resolve(&of, to->form, &to->on, &why))
        return ovr_fail_in(err, r->c, blamed(r, p, &why),
                           ovr_block_of(r, "lubricant"), &why);
    return OVR_OK;
}

/* ------------------------------------------------------------ how stiff it is
 */

/* ln E' of what the physics says at a contact of the modulus E', less ln E'. */
static ovr_status stiffness_off(ovr_resolved *r, int k, double log_E,
                                double *off, ovr_error *err)
{
    const ovr_physics *p = ovr_physics_list[k];
    ovr_conditions *given = &r->values.contact;
    ovr_error why = {0};
    double ratio = 1;
    given->modulus = exp(log_E);
    if (ovr_contact_resolve(given, &r->contact, &why))
        return ovr_fail_in(err, r->c, ovr_block_of(r, "contact"),
                           ovr_block_of(r, "lubricant"), &why);
    if (fill(r, p, &r->physics[k], err))
        return err ? err->status : OVR_BAD_INPUT;
    const ovr_physics_case of = about(r);
    if (p->stiffness(&of, r->physics[k].form, &ratio, &why))
        return ovr_fail_in(err, r->c, blamed(r, p, &why), NULL, &why);
    *off = log(ratio * r->substrate) - log_E;
    return OVR_OK;
}

/* Settles the modulus by secants: the thicker the layer over b, the softer or
 * stiffer the contact, and the wider or narrower b. */
static ovr_status settle(ovr_resolved *r, int k, ovr_error *err)
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

static bool has_block(const ovr_resolved *r, const ovr_physics *p)
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
        if (ovr_physics_list[k]->stiffness && has_block(r, ovr_physics_list[k]))
            status = settle(r, k, err);
    return status;
}

/* -------------------------------------------------------------- all of them */

static bool is_kept(const ovr_resolved *r, const ovr_feature_form *feature)
{
    for (int k = 0; ovr_physics_list[k]; k++)
        if (r->physics[k].on && ovr_physics_list[k]->keeps &&
            ovr_physics_list[k]->keeps(r->physics[k].form, feature))
            return true;
    return false;
}

/* Those that no physics has for itself are on the mesh. */
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
        if (ovr_physics_list[k]->section)
            status = resolve(r, ovr_physics_list[k], &r->physics[k], err);
    return status ? status : choose_features(r, err);
}

ovr_status ovr_resolve_on_mesh(ovr_resolved *r, ovr_error *err)
{
    const ovr_physics_case of = about(r);
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_physics *p = ovr_physics_list[k];
        ovr_error why = {0};
        if (r->physics[k].on && p->on_mesh &&
            p->on_mesh(&of, r->physics[k].form, r->setup.mesh, &why))
            return ovr_fail_in(err, r->c, blamed(r, p, &why), NULL, &why);
    }
    return OVR_OK;
}

void ovr_resolved_turn_on(ovr_resolved *r, const ovr_physics *physics,
                          void *form)
{
    for (int k = 0; ovr_physics_list[k]; k++)
        if (ovr_physics_list[k] == physics)
            r->physics[k] = (ovr_resolved_physics){form, true};
}

ovr_heat *ovr_resolved_heat(const ovr_resolved *r)
{
    for (int k = 0; ovr_physics_list[k]; k++)
        if (ovr_physics_list[k] == &ovr_physics_heat && r->physics[k].on)
            return &((ovr_heat_case *)r->physics[k].form)->heat;
    return NULL;
}

static bool is_on(const ovr_resolved *r, int k)
{
    const ovr_physics *p = ovr_physics_list[k];
    return r->physics[k].on || (p->chosen && p->chosen(r->setup.options));
}

unsigned ovr_setup_physics(const ovr_setup *setup)
{
    if (!setup)
        return 0;
    const ovr_resolved *r = (const ovr_resolved *)setup;
    unsigned bits = setup->features ? OVR_PHYSICS_FEATURES : 0;
    for (int k = 0; ovr_physics_list[k]; k++) {
        const ovr_physics *p = ovr_physics_list[k];
        if (is_on(r, k))
            bits |= p->bit;
        if (r->physics[k].on && p->bits)
            bits |= p->bits(r->physics[k].form);
    }
    return bits;
}

ovr_status ovr_setup_add_physics(const ovr_setup *setup, ovr_simulation *sim,
                                 ovr_error *err)
{
    const ovr_resolved *r = (const ovr_resolved *)setup;
    for (int k = 0; ovr_physics_list[k]; k++)
        if (r->physics[k].on &&
            ovr_physics_add(sim, ovr_physics_list[k], r->physics[k].form, err))
            return err ? err->status : OVR_BAD_INPUT;
    return OVR_OK;
}

const ovr_coated *ovr_setup_layers(const ovr_setup *setup, int body)
{
    const ovr_resolved *r = (const ovr_resolved *)setup;
    const ovr_coated *layers = NULL;
    for (int k = 0; !layers && ovr_physics_list[k]; k++)
        if (r->physics[k].on && ovr_physics_list[k]->layers)
            layers = ovr_physics_list[k]->layers(r->physics[k].form, body);
    return layers;
}

bool ovr_setup_has(const ovr_setup *setup, int k)
{
    return is_on((const ovr_resolved *)setup, k);
}

const ovr_physics *ovr_setup_makes_nodes(const ovr_setup *setup)
{
    for (int k = 0; ovr_physics_list[k]; k++)
        if (ovr_physics_list[k]->makes_nodes && ovr_setup_has(setup, k))
            return ovr_physics_list[k];
    return NULL;
}

/* Once the grid is known, of what stands beside the simulation too. */
static double beside(const ovr_setup *setup)
{
    const ovr_resolved *r = (const ovr_resolved *)setup;
    double bytes = 0;
    for (int k = 0; setup->nodes && ovr_physics_list[k]; k++)
        if (r->physics[k].on && ovr_physics_list[k]->memory)
            bytes += ovr_physics_list[k]->memory(r->physics[k].form);
    return bytes;
}

double ovr_setup_seconds_beside(const ovr_setup *setup, double node_steps)
{
    const ovr_resolved *r = (const ovr_resolved *)setup;
    double seconds = 0;
    for (int k = 0; setup->nodes && ovr_physics_list[k]; k++)
        if (is_on(r, k)) {
            const ovr_physics *is = ovr_physics_list[k];
            seconds += node_steps * is->node_seconds;
            if (r->physics[k].on && is->seconds)
                seconds += is->seconds(r->physics[k].form);
        }
    return seconds;
}

double ovr_setup_memory(const ovr_setup *setup)
{
    if (!setup)
        return NAN;
    ovr_simulation *sim = ovr_simulation_counted(setup->options);
    double bytes = INFINITY;
    if (sim && !ovr_setup_add_physics(setup, sim, NULL))
        bytes = (double)sim->arena.bytes + beside(setup);
    ovr_simulation_free(sim);
    return bytes;
}

void ovr_setup_tell(const ovr_setup *setup, ovr_setup_line *line, void *data)
{
    if (!line)
        return;
    if (!setup)
        return;
    ovr_resolved *r = (ovr_resolved *)setup;
    const ovr_physics_case of = about(r);
    for (int k = 0; ovr_physics_list[k]; k++)
        if (is_on(r, k) && ovr_physics_list[k]->tell)
            ovr_physics_list[k]->tell(&of, r->physics[k].form, line, data);
}
