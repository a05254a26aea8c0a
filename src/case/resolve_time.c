/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The times of a case: [time], the histories of load, speed, sliding and radii,
 * [passes], and automatic choice of end time and step.
 */
#include "case/resolve.h"

#include <math.h>
#include <string.h>

#include "case/accuracy.h"
#include "case/domain.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/curvature.h"
#include "elements/case_element.h"
#include "simulation/conflicts.h"
#include "surface/surfaces.h"

/* ---------------------------------------------------------------- Histories */

static ovr_status missing(ovr_resolved *r, const ovr_block *block,
                          const char *key, ovr_error *err)
{
    const ovr_slot *history = ovr_block_get(block, "history");
    (void)r;
    return ovr_fail_slot(err, history, "%s needs '%s' in [%s]", history->text,
                         key, block->section->name);
}

/* ----------------------------------------------------------------- Tables */

/* Returns the unit of the table's times in b/u_m. */
static ovr_status time_unit(const ovr_resolved *r, const ovr_block *block,
                            int unit, double *value, ovr_error *err)
{
    static const double seconds[] = {1, 1, 1e-3, 1e-6};
    *value = unit ? seconds[unit] / r->contact.time : 1;
    if (!isnan(*value))
        return OVR_OK;
    return ovr_fail_slot(err, ovr_block_get(block, "time_unit"),
                         "needs a contact with dimensions; set radius, "
                         "modulus and viscosity (or speeds)");
}

static ovr_status load_table(ovr_resolved *r, const ovr_block *block,
                             const ovr_change *change, ovr_history_form *form,
                             ovr_error *err)
{
    const ovr_parameter *to = ovr_parameter_find(block->section, "to");
    ovr_two_columns p = {.name = {"time", "value"},
                         .minimum = to->minimum,
                         .maximum = to->maximum,
                         .of = " (relative to the reference value)",
                         .unit = {1, 1}};
    ovr_status status;
    if (!change->file)
        return missing(r, block, "file", err);
    if (time_unit(r, block, change->time_unit, &p.unit[0], err))
        return OVR_BAD_INPUT;
    status = ovr_slot_columns(ovr_block_get(block, "file"), change->file, &p,
                              &r->arena, err);
    form->points = p.count;
    form->T = p.x;
    form->value = p.y;
    return status;
}

/* ---------------------------------------------------------- all histories */

/* Sets missing values of a sliding history from the contact's slide_to_roll:
 * mean, initial and final value. */
static void of_sliding(const ovr_resolved *r, ovr_history_form *form)
{
    form->mean = r->contact.u1_ratio - r->contact.u2_ratio;
    if (isnan(form->from))
        form->from = form->mean;
    if (isnan(form->to))
        form->to = form->mean;
}

ovr_status ovr_resolve_history(ovr_resolved *r, const char *section,
                               const ovr_change *change, ovr_history **history,
                               ovr_error *err)
{
    const ovr_block *block = ovr_case_find_block(r->c, section, NULL);
    ovr_history_form form = change->form;
    ovr_error why = {0};
    if (strcmp(section, "sliding") == 0)
        of_sliding(r, &form);
    else if (strcmp(section, "speed") != 0)
        form.mean = 1;
    if (form.kind == OVR_HISTORY_CONSTANT)
        return OVR_OK;
    if (form.kind == OVR_HISTORY_SINE && !ovr_block_get(block, "period")->given)
        return missing(r, block, "period", err);
    if (form.kind == OVR_HISTORY_TABLE) {
        ovr_status status = load_table(r, block, change, &form, err);
        if (status)
            return status;
    }
    *history = ovr_history_create(&form, &r->arena.allocator, &why);
    return *history ? OVR_OK : ovr_fail_in(err, r->c, block, NULL, &why);
}

/* ------------------------------------------------------------------- Passes */

/* Checks the time between rolling bodies and their loads. */
static ovr_status check_bodies(const ovr_resolved *r, ovr_error *err)
{
    const ovr_passes_setup *p = &r->values.passes;
    const ovr_slot *recovery = ovr_slot_of(r, "passes", "recovery");
    const double speed[] = {r->contact.u1_ratio, r->contact.u2_ratio};
    if (recovery->given && !(p->spacing > 0))
        return ovr_fail_slot(err, recovery,
                             "needs passes.spacing, which determines the time "
                             "for replenishment");
    for (int k = 0; k < 2; k++)
        if (recovery->given && p->again & 1 << k && !(speed[k] > 0))
            return ovr_fail_slot(err, recovery,
                                 "surface %d does not move, so that its "
                                 "lubricant layer has no time for "
                                 "replenishment; remove passes.recovery",
                                 k + 1);
    if (p->loads.count && p->loads.count != (size_t)p->number)
        return ovr_fail_slot(
            err, ovr_slot_of(r, "passes", "loads"),
            "%zu loads are given for %d passes; give one load per pass",
            p->loads.count, p->number);
    return OVR_OK;
}

static ovr_status resolve_passes(ovr_resolved *r, ovr_error *err)
{
    const ovr_passes_setup *p = &r->values.passes;
    double left = p->split * fmax(0, r->contact.u1_ratio) +
                  (1 - p->split) * fmax(0, r->contact.u2_ratio);
    ovr_status status = ovr_resolve_element_passes(r, err);
    if (status || p->number == 1)
        return status;
    if (ovr_block_is_there(ovr_block_of(r, "strip")))
        return ovr_fail_slot(err, ovr_slot_of(r, "passes", "number"),
                             "several passes cannot be combined with a strip; "
                             "use one pass");
    if (r->values.options.cavitation != OVR_CAVITATION_CONSERVING)
        return ovr_fail_slot(err, ovr_slot_of(r, "passes", "number"),
                             "several passes need [cavitation] model = "
                             "conserving");
    if (ovr_slot_of(r, "passes", "loss")->given && isfinite(p->side_flow))
        return ovr_fail_slot(err, ovr_slot_of(r, "passes", "side_flow"),
                             "passes.loss is also set; remove one of the two");
    if (!(left > 0))
        return ovr_fail_slot(
            err, ovr_slot_of(r, "passes", "split"),
            "%g leaves all lubricant on a stationary surface, which carries "
            "none away; use a share between 0 and 1",
            p->split);
    return check_bodies(r, err);
}

/* ---------------------------------------------------------- Time and scheme */

/* True if the characteristic scheme is more accurate at the given step. A
 * rolling dent in steps of 0.032 b/u_m has errors of H_cen of 1.8e-4
 * (upstream2: 8.2e-3). A ramp of load and speed in steps of 0.107 b/u_m has
 * errors of 6.4e-3 (upstream2: 2.2e-3). At the meniscus of a starved contact
 * the error increases as M^2 dT^3. With a dent and M = 100 its mean is 7e-2 in
 * steps of 0.025 b/u_m (upstream2: 1e-2). In steps of 0.0125 b/u_m it is 8e-4
 * (upstream2: 6e-3). */
static bool is_short(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    const ovr_slot *film = ovr_slot_of(r, "supply", "model");
    bool varies = ovr_history_varies(s->load) || ovr_history_varies(s->speed) ||
                  ovr_history_varies(s->radius) ||
                  ovr_history_varies(s->radius_1);
    double longest = varies ? 0.02 : 0.05;
    if (film->given || r->values.passes.number > 1)
        longest *= fmin(1, pow(20 / s->contact->M, 2. / 3));
    return s->march->dT <= longest;
}

/* Chooses the scheme. Steps of whole mesh sizes along the characteristic
 * convect features without error, and fourth-order corrections include the
 * histories. In longer steps the separate terms are more accurate. */
static ovr_scheme choose_scheme(const ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    bool characteristic = s->transient && !s->march->adaptive &&
                          is_short(r); /* step = grid: dT = 0 */
    if (r->values.scheme >= 0)
        return (ovr_scheme)r->values.scheme;
    if (!s->transient &&
        r->values.options.cavitation == OVR_CAVITATION_CONSERVING)
        return OVR_CHARACTERISTIC; /* fourth order */
    return characteristic ? OVR_CHARACTERISTIC : OVR_UPSTREAM2;
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
    if (!s->transient)
        v->march.end = 0;
    v->march.adaptive = v->step == OVR_STEP_ADAPTIVE;
    v->march.dT = fmax(v->step, 0); /* step = auto: set when the mesh size is
                                     * known */
    v->march.until_steady &= s->transient;
    r->ran = !r->c->standing && ovr_resolved_march(r);
    if (r->ran) {
        s->transient = true;
        v->step = v->march.dT;
    }
    if (ovr_section_fill(r, "load", err) || ovr_section_fill(r, "speed", err))
        return OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "load", &v->load, &s->load, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "speed", &v->speed, &s->speed, err))
        return err ? err->status : OVR_BAD_INPUT;
    v->sliding.form.from = v->sliding.form.to = NAN;
    if (ovr_section_fill(r, "sliding", err))
        return OVR_BAD_INPUT;
    if (ovr_resolve_history(r, "sliding", &v->sliding, &s->sliding, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (resolve_radius(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (ovr_resolve_element_histories(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    s->options->scheme = choose_scheme(r);
    return resolve_passes(r, err);
}

/* --------------------------------------------------------------- End = auto */

/* With end = auto the run ends after the last change, plus the time in which
 * the film becomes steady. Changes of the film move at the mean speed. On a
 * fast surface they leave the domain later than their feature, by at most one
 * passage of the domain. */

static const double LATEST = 1e5; /* b/u_m, limit as for a given end */

/* Maximum pressure change of a steady film per b/u_m, relative to p_h; far
 * below the discretization error. */
static const double NEARLY = 1e-5;

static ovr_status refuse(const ovr_slot *end, const ovr_feature_info *f,
                         const char *why, ovr_error *err)
{
    return ovr_fail_slot(err, end,
                         "auto: feature '%s' %s; set time.end to a "
                         "time",
                         f->name, why);
}

static ovr_status wait_for(const ovr_setup *s, const ovr_slot *end, size_t k,
                           double *T, ovr_error *err)
{
    const ovr_options *o = s->options;
    ovr_feature_info f = ovr_surfaces_info(s->surfaces, k);
    ovr_feature_times times;
    if (f.speed == 0 && !s->sliding) { /* the film becomes steady with the
                                        * feature in place */
        if (f.grows)
            *T = fmax(*T, s->feature[k]->grow_from + s->feature[k]->grow);
        return OVR_OK;
    }
    if (!isfinite(f.behind) || !isfinite(f.ahead) || !isfinite(f.last))
        return refuse(end, &f, "is endless and never leaves", err);
    times = ovr_surfaces_times(s->surfaces, k, o->inlet, o->outlet, LATEST);
    if (!isfinite(times.leaves))
        return refuse(end, &f, "never leaves", err);
    *T = fmax(*T, times.leaves);
    return OVR_OK;
}

static ovr_status wait_for_histories(const ovr_setup *s, const ovr_slot *end,
                                     double *T, ovr_error *err)
{
    const struct {
        const char *section;
        const ovr_history *is;
    } all[] = {{"load", s->load},
               {"speed", s->speed},
               {"sliding", s->sliding},
               {"radius", s->radius},
               {"radius_1", s->radius_1}};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        double over = ovr_history_end(all[k].is);
        if (!isfinite(over))
            return ovr_fail_slot(err, end,
                                 "auto: the history of [%s] never ends; set "
                                 "time.end to a time",
                                 all[k].section);
        *T = fmax(*T, over);
    }
    return OVR_OK;
}

ovr_status ovr_resolve_end(ovr_resolved *r, ovr_error *err)
{
    ovr_setup *s = &r->setup;
    const ovr_slot *end = ovr_block_get(ovr_block_of(r, "time"), "end");
    size_t n = s->surfaces ? ovr_surfaces_count(s->surfaces) : 0;
    double T = 0, passage = s->options->outlet - s->options->inlet;
    ovr_status status = OVR_OK;
    if (!s->transient || s->march->end != OVR_END_AUTO)
        return OVR_OK;
    for (size_t k = 0; !status && k < n; k++)
        status = wait_for(s, end, k, &T, err);
    if (!status)
        status = wait_for_histories(s, end, &T, err);
    if (!status && !(T > 0))
        status = ovr_fail_slot(err, end,
                               "auto: nothing passes and nothing changes; "
                               "remove time.end for a steady solution");
    r->values.march.until_steady = true;
    r->values.march.steady_from = T;
    r->values.march.steady_rate = NEARLY;
    r->values.march.end = T + 2 * passage;
    return status;
}

/* -------------------------------------------------------------- Step = auto */

/*
 * Along the characteristic, corrections of fourth order follow the solution.
 * Steps of two mesh sizes D then keep the central film thickness to 1e-4 and
 * the minimum to 1e-3, at 0.6 of the cost of D (rms of a run at level 7 with
 * dents 0.5 b wide and ramps).  Errors are larger with a short inlet, a
 * narrow feature, a quick change or a moving meniscus.  For M = 100 the
 * error of H_cen grows by a factor of 6 to 9, for a starved dent by 3.  In a
 * hot contact with surfaces that move in opposite directions H_cen is off by
 * 1.2e-3 (S = -4, 1.45 GPa, level 7). In these cases, without corrections,
 * and on coarse grids the step is D.  Steps of 4D have the errors of 2D on
 * the next coarser level, at 0.6 of the cost (overroll-theory(7), Time).
 */

static const double HEAVY = 100;   /* inlets are short above this M */
static const double NARROW = 30;   /* shortest length of a feature or change, in
                                    * D */
static const double COARSE = 0.01; /* mesh size in b; usually level 6 and
                                    * below */
enum { LONG_STEP = 2, LOOKS = 64, INSTANTS = 1 << 14 };

/* Returns the maximum M over the run. */
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

/* True if the second difference of a table over long steps exceeds 1e-3 of the
 * reference value, since a step assumes linear variation. */
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
        if (of[k]->form.kind == OVR_HISTORY_TABLE &&
            swings(all[k], ovr_setup_end(s), LONG_STEP * s->mesh))
            return true;
    return false;
}

/* True if a change is so fast that only few steps resolve it. */
static bool is_quick(const ovr_change *c, double minimum)
{
    switch (c->form.kind) {
    case OVR_HISTORY_STEP: return true;
    case OVR_HISTORY_RAMP: return c->form.duration < minimum;
    case OVR_HISTORY_SINE: return c->form.period < minimum;
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

/* True if the likely error is below the usual target with steps of one mesh
 * size, but not with longer ones. */
static bool is_closer(ovr_resolved *r)
{
    const double target = 1e-3;
    double arriving = ovr_resolved_supply(r), longer;
    if (r->setup.accuracy_of != OVR_ACCURACY_ALL)
        return false;
    r->values.march.dT = LONG_STEP * r->setup.mesh;
    longer = ovr_expected(&r->setup, arriving);
    r->values.march.dT = 0;
    return longer > target && ovr_expected(&r->setup, arriving) <= target;
}

/* Returns the reason for steps of one mesh size; NULL if they may be longer. */
static const char *reason_of(ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    if (s->options->scheme != OVR_CHARACTERISTIC)
        return "as upstream schemes use it";
    if (!ovr_setup_corrected(s))
        return "without corrections of fourth order";
    if (ovr_resolved_one_mesh(r))
        return ovr_resolved_one_mesh(r);
    if (s->mesh > COARSE)
        return "on a mesh above 0.01 b";
    if (changes_quickly(r))
        return "for a change within 30 D";
    if (ovr_history_varies(s->speed))
        return "for a speed that varies";
    if (has_hot_opposed(r))
        return "for hot surfaces that move in opposite directions";
    if (heaviest(s) >= HEAVY)
        return "for M of 100 and more";
    if (is_closer(r))
        return "to keep the likely error below 0.001";
    return has_narrow(s) ? "for a feature narrower than 30 D" : NULL;
}

void ovr_resolve_step(ovr_resolved *r)
{
    const ovr_setup *s = &r->setup;
    if (!s->transient || r->values.step != OVR_STEP_AUTO)
        return;
    r->step_reason = reason_of(r);
    r->values.march.dT = r->step_reason ? 0 : LONG_STEP * s->mesh;
}

void ovr_setup_step_reached(ovr_setup *setup, int order)
{
    ovr_resolved *r = setup->resolved;
    if (!setup->transient || r->values.step != OVR_STEP_AUTO ||
        setup->options->order == order || r->step_reason)
        return;
    r->step_reason = "without corrections of fourth order";
    r->values.march.dT = 0;
}

double ovr_setup_step(const ovr_setup *setup)
{
    return setup->march->dT > 0 ? setup->march->dT : setup->mesh;
}

const char *ovr_setup_step_reason(const ovr_setup *setup)
{
    return setup->resolved->step_reason;
}
