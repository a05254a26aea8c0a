/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [time], and the histories of load, speed, sliding and radii. */
#include <math.h>

#include "case/domain.h"
#include "case/resolve_element.h"

/* Steps of whole meshes along the characteristic carry what moves without
 * error, and there corrections of fourth order follow histories; with others
 * the separate terms do. */
static ovr_scheme choose_scheme(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    bool grid = s->transient && !s->march->adaptive && s->march->dT == 0;
    if (r->values.scheme >= 0)
        return (ovr_scheme)r->values.scheme;
    if (!s->transient &&
        r->values.options.cavitation == OVR_CAVITATION_CONSERVING)
        return OVR_CHARACTERISTIC; /* its order is 4 */
    return grid ? OVR_CHARACTERISTIC : OVR_UPSTREAM2;
}

static ovr_status resolve_radius(ovr_resolved *r, ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_setup *s = &r->setup;
    if (ovr_section_fill(r, "radius", err) ||
        ovr_section_fill(r, "radius_1", err))
        return OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "radius", &v->radius, &s->radius, err))
        return err ? err->status : OVR_BAD_INPUT;
    return ovr_resolve_history(r, "radius_1", &v->radius_1, &s->radius_1, err);
}

ovr_status ovr_resolve_time(ovr_resolved *r, ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_setup *s = &r->setup;
    s->transient = ovr_slot_of(r, "time", "end")->given || ovr_element_moves(r);
    r->march = (ovr_march){0};
    r->march.end = s->transient ? v->end : 0;
    r->march.adaptive = v->step == OVR_STEP_ADAPTIVE;
    r->march.dT = fmax(v->step, 0); /* of auto: once the mesh is known */
    r->march.error = v->error;
    r->march.until_steady = v->until_steady && s->transient;
    r->ran = !r->c->standing && ovr_resolved_march(r);
    if (r->ran) {
        s->transient = true;
        v->step = r->march.dT;
    }
    if (ovr_section_fill(r, "load", err) || ovr_section_fill(r, "speed", err))
        return OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "load", &v->load, &s->load, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "speed", &v->speed, &s->speed, err))
        return err ? err->status : OVR_BAD_INPUT;
    v->sliding.from = v->sliding.to = NAN;
    if (ovr_section_fill(r, "sliding", err))
        return OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "sliding", &v->sliding, &s->sliding, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (resolve_radius(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (ovr_resolve_element_histories(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    s->options->scheme = choose_scheme(r);
    return ovr_resolve_passes(r, err);
}
