/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * time.step = auto.  Along the characteristic, with corrections of fourth order
 * that follow the solution, steps of two meshes keep central films to 1e-4 and
 * smallest ones to 1e-3 (rms of a run, level 7: dents .5 b wide, ramps of load
 * and speed), and cost .6 of steps of one.  They lose more where the film's
 * inlet is short beside the mesh (M = 100: H_cen a factor 6 to 9), where a
 * feature is narrow or a change quick (they pass in few steps), where a
 * meniscus moves (a starved dent: a factor 3), in hot contacts whose surfaces
 * move in opposite directions (S = -4, 1.45 GPa, level 7: H_cen of a steady
 * contact off by 1.2e-3), and where no correction takes the wedge of the step
 * away: there a step is a mesh.  So it is on coarse
 * meshes, whose runs take no time.  Steps of four meshes have the errors of two
 * a level coarser, which cost .6 of them (overroll-theory(7), Time).
 */
#include <math.h>

#include "case/domain.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/curvature.h"
#include "simulation/conflicts.h"
#include "surface/surfaces.h"

static const double HEAVY = 100;   /* M from which on inlets are short */
static const double NARROW = 30;   /* meshes of a feature, or of a change */
static const double COARSE = 0.01; /* b: level 6 and below, as a rule */
enum { LONG_STEP = 2, LOOKS = 64, INSTANTS = 1 << 14 };

/* The largest M that the run goes through. */
static double heaviest(const ovr_setup *s)
{
    double maximum = s->contact->M, end = ovr_setup_end(s);
    if (!ovr_setup_varies(s) || !isfinite(end))
        return maximum;
    for (int k = 0; k <= LOOKS; k++) {
        double T = end * k / LOOKS;
        double w = fmax(ovr_history_value(s->load, T), OVR_MIN_START);
        double u = fmax(fabs(ovr_history_value(s->speed, T)), OVR_MIN_START);
        double c = 1 / ovr_history_value(s->radius, T);
        maximum = fmax(maximum, ovr_instant_of(s->contact, w, u, c).M);
    }
    return maximum;
}

static bool has_narrow(const ovr_setup *s)
{
    size_t n = s->surfaces ? ovr_surfaces_count(s->surfaces) : 0;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info f = ovr_surfaces_info(s->surfaces, k);
        bool moves = f.speed != 0 || s->sliding;
        if (f.Rq == 0 && moves && f.wavelength < NARROW * s->mesh)
            return true;
    }
    return false;
}

/* True if the second difference of a table over long steps, which is what a
 * step takes for a straight line, is ever more than 1e-3 of the nominal value.
 */
static bool swings(const ovr_history *history, double end, double h)
{
    const double maximum = 1e-3;
    double before = ovr_history_value(history, 0), now = before;
    double count = isfinite(end) ? fmin(ceil(end / h), INSTANTS) : 0;
    for (int k = 1; k <= (int)count; k++) {
        double next = ovr_history_value(history, k * h);
        if (fabs(next - 2 * now + before) > maximum)
            return true;
        before = now;
        now = next;
    }
    return false;
}

static bool tables_swing(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    const ovr_settings *v = &r->values;
    const ovr_history *const all[] = {s->load, s->speed, s->sliding, s->radius,
                                      s->radius_1};
    const ovr_change *const of[] = {&v->load, &v->speed, &v->sliding,
                                    &v->radius, &v->radius_1};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (of[k]->history == OVR_HISTORY_TABLE &&
            swings(all[k], ovr_setup_end(s), LONG_STEP * s->mesh))
            return true;
    return false;
}

/* True if it changes within so little time that steps see few moments of it. */
static bool is_quick(const ovr_change *c, double minimum)
{
    switch (c->history) {
    case OVR_HISTORY_STEP: return true;
    case OVR_HISTORY_RAMP: return c->duration < minimum;
    case OVR_HISTORY_SINE: return c->period < minimum;
    default: return false;
    }
}

static bool changes_quickly(const ovr_resolved *r)
{
    const ovr_settings *v = &r->values;
    const ovr_change *const all[] = {&v->load, &v->speed, &v->sliding,
                                     &v->radius, &v->radius_1};
    bool quick = tables_swing(r);
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        quick = quick || is_quick(all[k], NARROW * r->setup.mesh);
    return quick;
}

/* Returns true for a hot film with surfaces that move in opposite directions at
 * any time. */
static bool has_hot_opposed(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    double end = ovr_setup_end(s);
    bool varies = ovr_setup_varies(s) && isfinite(end);
    if (!(ovr_resolved_features(r) &
          ovr_model_feature_bit(OVR_MODEL_HEAT, true)))
        return false;
    for (int k = 0; k <= (varies ? LOOKS : 0); k++) {
        double T = varies ? end * k / LOOKS : 0;
        double Cu = fabs(ovr_history_value(s->speed, T));
        if (fabs(ovr_slip_at(s->contact, s->speed, s->sliding, T)) > 2 * Cu)
            return true;
    }
    return false;
}

/* Why a step is one mesh; NULL: it may be longer. */
static const char *reason_of(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    if (s->options->scheme != OVR_CHARACTERISTIC)
        return "as upstream schemes take it";
    if (!ovr_setup_corrected(s))
        return "without corrections of fourth order";
    if (ovr_resolved_one_mesh(r))
        return ovr_resolved_one_mesh(r);
    if (s->mesh > COARSE)
        return "on a mesh above 0.01 b";
    if (changes_quickly(r))
        return "for a change within 30 meshes";
    if (has_hot_opposed(r))
        return "for hot surfaces that move in opposite directions";
    if (heaviest(s) >= HEAVY)
        return "for M of 100 and more";
    return has_narrow(s) ? "for a feature narrower than 30 meshes" : NULL;
}

void ovr_resolve_step(ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    if (!s->transient || r->values.step != OVR_STEP_AUTO)
        return;
    r->step_reason = reason_of(r);
    r->march.dT = r->step_reason ? 0 : LONG_STEP * s->mesh;
}

double ovr_setup_step(const ovr_setup *setup)
{
    return setup->march->dT > 0 ? setup->march->dT : setup->mesh;
}

const char *ovr_setup_step_reason(const ovr_setup *setup)
{
    return ((const ovr_resolved *)setup)->step_reason;
}
