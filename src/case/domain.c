/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/domain.h"

#include <math.h>

#include "contact/contact.h"
#include "contact/curvature.h"
#include "contact/history.h"
#include "contact/starvation.h"
#include "simulation/internal.h"
#include "surface/surfaces.h"

/* LOOKS: times at which the operating conditions of a run are sampled before it
 * is solved. INSTANTS: times used to find jumps. */
enum { LOOKS = 256, INSTANTS = 1 << 14 };

bool ovr_setup_varies(const ovr_setup *s)
{
    return ovr_history_varies(s->load) || ovr_history_varies(s->speed) ||
           ovr_history_varies(s->radius) || ovr_history_varies(s->radius_1);
}

bool ovr_setup_corrected(const ovr_setup *s)
{
    if (s->options->order != 4)
        return false;
    if (s->options->cavitation == OVR_CAVITATION_CONSERVING)
        return s->options->scheme == OVR_CHARACTERISTIC;
    return !s->transient || !ovr_setup_varies(s) ||
           s->options->scheme == OVR_CHARACTERISTIC;
}

double ovr_setup_end(const ovr_setup *s)
{
    double end = s->march->end;
    if (isinf(end)) /* end = auto */
        end = fmax(ovr_history_end(s->load), ovr_history_end(s->speed));
    if (isinf(s->march->end) && isfinite(ovr_history_end(s->radius)))
        end = fmax(end, ovr_history_end(s->radius));
    return end;
}

/* -------------------------------------------------------------- curvature */

static bool varies_in_radius(const ovr_setup *s)
{
    return ovr_history_varies(s->radius) || ovr_history_varies(s->radius_1);
}

/* Returns the gap at T if its curvature is convected with the material. */
static ovr_smooth smooth_of(const ovr_setup *s, double T)
{
    const ovr_contact *c = s->contact;
    const ovr_curving g = {s->radius,
                           s->radius_1,
                           s->speed,
                           s->sliding,
                           {c->u1_ratio, c->u2_ratio},
                           true};
    return ovr_smooth_of(&g, T);
}

/* Returns the first time at which its cubic closes the gap within |X| < far;
 * NAN if it never does. */
static double first_closure(const ovr_setup *s, double far)
{
    double end = ovr_setup_end(s);
    for (int k = 0; k <= 4 * LOOKS; k++) {
        double T = end * k / (4 * LOOKS);
        ovr_smooth smooth = smooth_of(s, T);
        if (!ovr_smooth_opens(&smooth, far))
            return T;
    }
    return NAN;
}

static double mean_size_of_speeds(const ovr_setup *s, double T)
{
    const double ratio[] = {s->contact->u1_ratio, s->contact->u2_ratio};
    double sum = 0;
    for (int k = 0; k < 2; k++)
        sum += fabs(
            ovr_surface_speed(s->speed, s->sliding, ratio[k], k + 1, T));
    return sum / 2;
}

/* True if the cubic changes so fast that the gap at |X| = far opens or closes
 * by more than twice the change due to entrainment. The cubic describes the
 * material in the contact. If its curvature has a kink (a cam law whose jerk
 * jumps), the cubic changes in the whole domain at once and squeezes lubricant
 * unphysically. (Gear pairs reached 1.4; cams of law 345, some of which failed
 * for this reason, 5 and more.) */
static bool changes_abruptly(const ovr_setup *s, double far)
{
    const double share = 2;
    double end = ovr_setup_end(s), dT = end / (4 * LOOKS);
    ovr_smooth before = smooth_of(s, 0);
    for (int k = 1; k <= 4 * LOOKS; k++) {
        double T = end * k / (4 * LOOKS);
        ovr_smooth now = smooth_of(s, T);
        double wedge = 2 * now.half * mean_size_of_speeds(s, T) * dT;
        if (fabs(now.cubic - before.cubic) * far * far > share * wedge)
            return true;
        before = now;
    }
    return false;
}

/* ------------------------------------------------------------------ extent */

/* Range of the passes' loads relative to the load of the setup's pass. A single
 * pass has no load of its own. */
typedef struct loads {
    double minimum, maximum;
} loads;

static loads loads_of_passes(const ovr_setup *s)
{
    const ovr_list *given = &s->passes->loads;
    const ovr_resolved *r = s->resolved;
    double now = r->pass_load > 0 ? r->pass_load : 1;
    loads all = {1, 1};
    for (size_t k = 0; s->passes->number > 1 && k < given->count; k++) {
        double other = given->values[k] / now;
        all.minimum = k ? fmin(all.minimum, other) : other;
        all.maximum = k ? fmax(all.maximum, other) : other;
    }
    return all;
}

/* Operating conditions of a run with all its passes, at sampled times. `width`:
 * maximum dry half-width in b. */
typedef struct sampled_times {
    const ovr_setup *setup;
    loads loads;
    double width, outlet; /* `outlet`: position required by load jumps, b */
    int last;             /* last sample */
    bool convected; /* a varying curvature is convected with the material */
    bool strict;    /* film thickness varies in time, so that the inlet loss
                     * must be small at all times */
} sampled_times;

/* Returns sample time k: the first is 0, the last the end of the run. The
 * others are spaced so that no history's period coincides with theirs. */
static double sample_time(const sampled_times *m, int k)
{
    const double golden = 0.6180339887498949;
    double end = ovr_setup_end(m->setup);
    double shift = k && k < m->last ? fmod(golden * k, 1) - 0.5 : 0;
    return k && isfinite(end) ? end * (k + shift) / m->last : 0;
}

static ovr_instant instant_of(const sampled_times *m, int k, double load)
{
    const ovr_setup *s = m->setup;
    double T = sample_time(m, k);
    double w = fmax(load * ovr_history_value(s->load, T), OVR_MIN_START);
    double u = fmax(fabs(ovr_history_value(s->speed, T)), OVR_MIN_START);
    return ovr_instant_of(s->contact, w, u,
                          1 / ovr_history_value(s->radius, T));
}

/* Returns load times radius, the square of the dry half-width. */
static double squared_width(const ovr_setup *s, double T)
{
    return ovr_history_value(s->load, T) * ovr_history_value(s->radius, T);
}

/* Returns the largest increase of the squared dry half-width within a short
 * time, relative to its maximum; a decrease counts 0.7. */
static double jump_of(const ovr_setup *s)
{
    const double moment = 0.035, fall = 0.7;
    double end = ovr_setup_end(s), maximum = 0, jump = 0, last;
    if (!s->transient || !isfinite(end) ||
        !(ovr_history_varies(s->load) || ovr_history_varies(s->radius)))
        return 0;
    int count = end < moment * INSTANTS ? (int)ceil(end / moment) : INSTANTS;
    last = squared_width(s, 0);
    for (int k = 1; k <= count; k++) {
        double now = squared_width(s, end * k / count), change = now - last;
        maximum = fmax(maximum, fmax(now, last));
        jump = fmax(jump, change > 0 ? change : -fall * change);
        last = now;
    }
    return maximum > 0 ? jump / maximum : 0;
}

/* Returns the outlet position, in maximum half-widths, for a load jump. The
 * surfaces also squeeze lubricant downstream, where the gap is not full for a
 * short time and pressure extends as far as the domain. An outlet at X_b
 * reduces the central film thickness a little later by 1.2 j (1.5/X_b)^3.2 %.
 * Fitted within a factor of 2 to jumps and ramps of 0.1 to 0.5 b/u_m between
 * loads of 1 to 5, M = 5 to 100, L = 2 to 10. Slow ramps thus have the usual
 * outlet. A jump by half the load loses 1e-4 in addition to the inlet's
 * error. */
static double outlet_of_jump(double jump)
{
    return OVR_USUAL_OUTLET * pow(45 * jump, 0.4);
}

/* Returns the last sample. If only the loads of the passes differ, conditions
 * are the same at the beginning and the end of the run. */
static int last_sample(const ovr_setup *s)
{
    if (ovr_setup_varies(s))
        return LOOKS;
    return s->passes->number > 1 && s->passes->loads.count ? 1 : 0;
}

static sampled_times moments_of(const ovr_setup *s)
{
    sampled_times m = {.setup = s, .loads = {1, 1}};
    if (s->transient) {
        m.loads = loads_of_passes(s);
        m.last = last_sample(s);
        m.strict = m.last && !ovr_history_reverses(s->speed);
    }
    for (int k = 0; k <= m.last; k++)
        m.width = fmax(m.width, instant_of(&m, k, m.loads.maximum).s);
    m.outlet = m.width * outlet_of_jump(jump_of(s));
    return m;
}

/* Returns the allowed loss of film thickness due to the inlet at a time. It is
 * smaller if films vary in time and are compared with each other than in a
 * steady contact. It is not reduced at times of small load, or of reversed
 * speed if the domain is equally long on the other side. */
static double usual_loss(const sampled_times *m, const ovr_instant *at)
{
    const double little = 0.2;
    bool counts = at->s * at->s >= little * m->width * m->width;
    return (m->strict && counts ? OVR_VARYING_LOSS : OVR_USUAL_LOSS) /
           ovr_inlet_uncertainty(at->M);
}

static double automatic_outlet(const sampled_times *m, const ovr_instant *at)
{
    ovr_options own = {.inlet = OVR_USUAL_INLET, .outlet = NAN};
    ovr_contact now = *m->setup->contact;
    now.M = at->M;
    now.L = at->L;
    ovr_options_domain(&now, &own);
    return own.outlet;
}

/* Returns the factor by which varying load and radius increase the loss, to
 * first order. Far upstream a growing load squeezes the lubricant by the
 * approach of the bodies, 0.6 d(s^2)/dT (dry), and an imposed curvature c by c'
 * X^2/2. Relative to the entrainment Cu c X^2/2 these are 1.2 (s^2)'/(c Cu |X|)
 * and c' |X|/(3 c Cu). The first is less, the second more affected by an inlet
 * at X_a. If the curvature is convected with the material, the gap there is not
 * c X^2/2. */
static double lost_by_change(const sampled_times *m, int k, double load,
                             double X_a)
{
    const ovr_setup *s = m->setup;
    double T = sample_time(m, k), R = ovr_history_value(s->radius, T), part = 1;
    double u = fmax(fabs(ovr_history_value(s->speed, T)), OVR_MIN_START);
    double width = load * ovr_history_slope(s->load, T) * R; /* of s^2 */
    double more = 1 + 0.9 * R * fabs(width) / (u * fabs(X_a));
    if (!varies_in_radius(s))
        return more;
    if (!m->convected)
        return more -
               0.5 * X_a * fabs(ovr_history_slope(s->radius, T)) / (R * u);
    ovr_smooth smooth = smooth_of(s, T);
    part = smooth.half / (smooth.half - smooth.cubic * X_a);
    return more * fmax(1, part * part);
}

typedef struct extent {
    double inlet, outlet;
} extent;

/* A sampled time, the allowed loss of film thickness due to the inlet, and the
 * required outlet length in its own half-widths. */
typedef struct inlet_request {
    ovr_instant at;
    double loss, outlet;
} inlet_request;

/* Returns the inlet position needed at sample k, or `inlet` if that is further
 * upstream. */
static double widened(const sampled_times *m, int k, double load,
                      const inlet_request *w, double inlet)
{
    const double step = 1.05, farthest = 4;
    double s = w->at.s, M = w->at.M, L = w->at.L;
    double X_a = fmin(inlet, s * OVR_NEAREST_INLET), minimum;
    if (ovr_inlet_loss(M, L, X_a / s) > w->loss)
        X_a = s * ovr_inlet_of_loss(M, L, w->loss, OVR_NEAREST_INLET);
    minimum = farthest * X_a;
    while (m->strict && X_a > minimum &&
           lost_by_change(m, k, load, X_a) * ovr_inlet_loss(M, L, X_a / s) >
               1.001 * w->loss)
        X_a *= step;
    return X_a;
}

/*
 * Returns the shortest usual domain.  Films of steady contacts above M = 3000
 * build up and end within 0.01 b of the contact.  The nodes of a shorter domain
 * are closer there.  M = 5000, L = 1.3 and 1.8 have no solution on the usual
 * domain on levels 11 to 13.  Here level 11 solves them.  An inlet at -1.5 has
 * the same film to 1e-5.
 */
static extent shortest_usual(const sampled_times *m)
{
    const double heavy = 3000;
    const ovr_setup *s = m->setup;
    if (!s->transient && !m->last && !s->surfaces && s->contact->M > heavy)
        return (extent){OVR_NEAREST_INLET, 1.1};
    return (extent){OVR_USUAL_INLET, OVR_USUAL_OUTLET};
}

static inlet_request usual_request(const sampled_times *m,
                                   const ovr_instant *at)
{
    return (inlet_request){
        *at, usual_loss(m, at),
        fmax(ovr_film_end_bound(at->M, at->L), shortest_usual(m).outlet)};
}

static inlet_request automatic_request(const sampled_times *m,
                                       const ovr_instant *at)
{
    return (inlet_request){*at, OVR_AUTO_LOSS, automatic_outlet(m, at)};
}

/* Returns the domain needed at all sampled times, with the smallest and the
 * largest load. */
static extent domain_of(const sampled_times *m, extent e,
                        inlet_request (*request_of)(const sampled_times *,
                                                    const ovr_instant *))
{
    for (int k = 0; k <= 2 * m->last + 1; k++) {
        double load = k % 2 ? m->loads.maximum : m->loads.minimum;
        ovr_instant at = instant_of(m, k / 2, load);
        inlet_request w = request_of(m, &at);
        e.inlet = widened(m, k / 2, load, &w, e.inlet);
        e.outlet = fmax(e.outlet, at.s * w.outlet);
    }
    return e;
}

static extent usual_domain(const sampled_times *m)
{
    extent nearest = shortest_usual(m);
    nearest.outlet = fmax(nearest.outlet, m->outlet);
    return domain_of(m, nearest, usual_request);
}

static extent automatic_domain(const sampled_times *m)
{
    extent nearest = {0, fmax(OVR_USUAL_OUTLET, m->outlet)};
    return domain_of(m, nearest, automatic_request);
}

static bool opens(const ovr_setup *s, extent e)
{
    double far = fmax(-e.inlet, e.outlet);
    return isnan(first_closure(s, far)) && !changes_abruptly(s, far);
}

/* Chooses the domain. Curvature is convected only if it opens the gap up to
 * both ends without jumps. If that holds only on a shorter domain, the longest
 * such domain is used. */
static extent chosen_domain(sampled_times *m)
{
    enum { HALVINGS = 12 };
    extent near, far;
    bool strict = m->strict;
    if (!varies_in_radius(m->setup))
        return usual_domain(m);
    m->strict = false;
    near = usual_domain(m);
    m->convected = opens(m->setup, near);
    m->strict = strict;
    far = usual_domain(m);
    if (!m->convected || opens(m->setup, far))
        return far;
    for (int k = 0; k < HALVINGS; k++) {
        extent middle = far;
        middle.inlet = 0.5 * (near.inlet + far.inlet);
        *(opens(m->setup, middle) ? &near : &far) = middle;
    }
    return near;
}

/* -------------------------------------------------------- Outlet by features
 */

/* Returns the height of the surfaces at the end of the film: the sum of all
 * rough features and the highest single shape. */
static double raised_by_features(const ovr_surfaces *surfaces)
{
    double rough = 0, single = 0;
    for (size_t k = 0; k < ovr_surfaces_count(surfaces); k++) {
        ovr_feature_info f = ovr_surfaces_info(surfaces, k);
        if (f.Rq > 0)
            rough += f.raised;
        else
            single = fmax(single, f.raised);
    }
    return rough + single;
}

/* Returns the outlet beyond the end of the film with features. At the end of
 * the film the Hertzian gap grows by at most 1.2 times the height of the
 * features (M = 3 to 90, L = 7 to 22, rough surfaces, waves and ridges of up to
 * 0.7 b^2/R). Sliding bumps increase it by 1.3 times their height, dents by
 * 0.15 times their depth, and other features by 0.9 times their height. */
double ovr_setup_feature_outlet(const ovr_setup *setup)
{
    const double growth = 1.2, longest = 2, tenths = 10;
    ovr_domain_needs needs = ovr_setup_needs(setup);
    double gap = ovr_hertz_gap(fmax(needs.film_end, 1) - 1);
    double X = needs.outlet, last = longest * X;
    if (setup->surfaces)
        gap += growth * raised_by_features(setup->surfaces);
    while (X < last && ovr_hertz_gap(X - 1) < gap)
        X = (floor(X * tenths + 1e-6) + 1) / tenths;
    return fmin(X, last);
}

ovr_domain_needs ovr_setup_needs(const ovr_setup *s)
{
    sampled_times m = moments_of(s);
    extent usual = chosen_domain(&m);
    ovr_domain_needs needs = {.width = m.width,
                              .inlet = usual.inlet,
                              .outlet = usual.outlet,
                              .varies = m.last > 0};
    for (int k = 0; k <= 2 * m.last + 1; k++) {
        double load = k % 2 ? m.loads.maximum : m.loads.minimum;
        ovr_instant at = instant_of(&m, k / 2, load);
        double X_a = fmin(s->options->inlet / at.s, -1);
        needs.loss = fmax(needs.loss, ovr_inlet_loss(at.M, at.L, X_a));
        needs.film_end = fmax(needs.film_end,
                              at.s * ovr_film_end_bound(at.M, at.L));
    }
    return needs;
}

/* Rejects a given end of the domain that lies inside the dry contact at its
 * largest width. */
static ovr_status reject_end(const ovr_resolved *r, const char *key, double end,
                             double enough, ovr_error *err)
{
    double width = r->half_width;
    const ovr_slot *slot = ovr_slot_of(r, "domain", key);
    if (!slot->given || slot->word || r->recorded || fabs(end) > width)
        return OVR_OK;
    return ovr_fail_slot(
        err, slot,
        "%.4g lies inside the contact, whose half-width reaches %.4g b at the "
        "largest load times radius; use %.4g or further out",
        end, width, enough);
}

ovr_status ovr_setup_domain(ovr_resolved *r, ovr_error *err)
{
    ovr_options *o = r->setup.options;
    sampled_times m = moments_of(&r->setup);
    extent usual = chosen_domain(&m);
    extent automatic = isnan(o->inlet) || isnan(o->outlet)
                           ? automatic_domain(&m)
                           : usual;
    r->half_width = m.width;
    if (o->inlet == 0 || isnan(o->inlet))
        o->inlet = isnan(o->inlet) ? automatic.inlet : usual.inlet;
    if (o->outlet == 0 || isnan(o->outlet))
        o->outlet = isnan(o->outlet) ? automatic.outlet : usual.outlet;
    if (reject_end(r, "inlet", o->inlet, usual.inlet, err) ||
        reject_end(r, "outlet", o->outlet, usual.outlet, err))
        return OVR_BAD_INPUT;
    return OVR_OK;
}

ovr_status ovr_setup_curvature(ovr_resolved *r, ovr_error *err)
{
    ovr_setup *s = &r->setup;
    double far = fmax(-s->options->inlet, s->options->outlet), T;
    if (!varies_in_radius(s))
        return OVR_OK;
    T = first_closure(s, far);
    s->convected = isnan(T) && r->values.curvature != OVR_CURVATURE_IMPOSED &&
                   (r->values.curvature == OVR_CURVATURE_CONVECTED ||
                    !changes_abruptly(s, far));
    if (isnan(T) || r->values.curvature != OVR_CURVATURE_CONVECTED)
        return OVR_OK;
    return ovr_fail_slot(
        err, ovr_slot_of(r, "radius", "curvature"),
        "the curvature cannot be convected with the material from X = %.3g to "
        "%.3g, because at T = %.4g it changes too fast or a surface moves too "
        "slowly; use radius.curvature = imposed",
        s->options->inlet, s->options->outlet, T);
}
