/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/domain.h"

#include <math.h>

#include "contact/curvature.h"
#include "contact/starvation.h"
#include "simulation/internal.h"

/* At which a run is looked at beforehand. */
enum { LOOKS = 256 };

bool ovr_setup_varies(const ovr_setup *s)
{
    return ovr_history_varies(s->load) || ovr_history_varies(s->speed) ||
           ovr_history_varies(s->radius) || ovr_history_varies(s->radius_1);
}

double ovr_setup_end(const ovr_setup *s)
{
    double end = s->march->end;
    if (isinf(end)) /* auto */
        end = fmax(ovr_history_end(s->load), ovr_history_end(s->speed));
    if (isinf(s->march->end) && isfinite(ovr_history_end(s->radius)))
        end = fmax(end, ovr_history_end(s->radius));
    return end;
}

/* Conditions of the thickest film between T = 0 and the end, in units of b^2/R
 * at nominal load; load and speed from where a run begins (OVR_LEAST_START).
 * The half width then, over b; where the radius varies the largest. */
static ovr_contact thickest(const ovr_setup *s, double *width)
{
    ovr_contact now = *s->contact, most = now;
    double thick = 0, end = ovr_setup_end(s), widest = 0;
    for (int k = 0; k <= LOOKS; k++) {
        double T = end * k / LOOKS;
        double w = fmax(ovr_history_value(s->load, T), OVR_LEAST_START);
        double u = fmax(fabs(ovr_history_value(s->speed, T)), OVR_LEAST_START);
        ovr_instant at = ovr_instant_of(s->contact, w, u,
                                        1 / ovr_history_value(s->radius, T));
        now.M = at.M;
        now.L = at.L;
        widest = fmax(widest, at.s);
        if (ovr_film_central_moes(now.M, now.L) * w > thick) {
            thick = ovr_film_central_moes(now.M, now.L) * w;
            most = now;
            *width = at.s;
        }
    }
    if (ovr_history_varies(s->radius))
        *width = widest;
    return most;
}

/* Neither by the case nor by the file of a run that goes on. */
static const double USUAL_OUTLET = 1.5;

static bool outlet_given(const ovr_setup *s)
{
    return ovr_slot_of((const ovr_resolved *)s, "domain", "outlet")->given;
}

/* An automatic domain is that of the thickest film: b grows as sqrt(Cw R). */
static void of_histories(ovr_setup *s)
{
    ovr_options *o = s->options, farthest = *o;
    double width = 1;
    ovr_contact most = thickest(s, &width);
    ovr_options_domain(&most, &farthest);
    if (isnan(o->inlet))
        o->inlet = fmin(width * farthest.inlet, -2);
    if (isnan(o->outlet))
        o->outlet = fmax(width * farthest.outlet, USUAL_OUTLET);
    if (!ovr_history_varies(s->radius))
        return;
    if (o->inlet == 0)
        o->inlet = fmin(width * farthest.inlet, OVR_USUAL_INLET);
    if (o->outlet == USUAL_OUTLET && !outlet_given(s))
        o->outlet = fmax(width, 1) * USUAL_OUTLET;
}

void ovr_setup_domain(ovr_setup *s)
{
    const ovr_options *o = s->options;
    bool chosen = isnan(o->inlet) || isnan(o->outlet) ||
                  ovr_history_varies(s->radius);
    if (s->transient && chosen && ovr_setup_varies(s))
        of_histories(s);
    ovr_options_domain(s->contact, s->options);
}

/* -------------------------------------------------------------- curvature */

/* The first time that the cubic would close the gap; NAN: never. */
static double closes(const ovr_setup *s)
{
    const ovr_contact *c = s->contact;
    const ovr_options *o = s->options;
    const ovr_curving g = {s->radius,
                           s->radius_1,
                           s->speed,
                           s->sliding,
                           {c->u1_ratio, c->u2_ratio},
                           true};
    double far = fmax(-o->inlet, o->outlet), end = ovr_setup_end(s);
    for (int k = 0; k <= 4 * LOOKS; k++) {
        double T = end * k / (4 * LOOKS);
        ovr_smooth smooth = ovr_smooth_of(&g, T);
        if (!ovr_smooth_opens(&smooth, far))
            return T;
    }
    return NAN;
}

ovr_status ovr_setup_curvature(ovr_resolved *r, ovr_error *err)
{
    ovr_setup *s = &r->setup;
    double T;
    if (!ovr_history_varies(s->radius) && !ovr_history_varies(s->radius_1))
        return OVR_OK;
    T = closes(s);
    s->rides = isnan(T) && r->values.curvature != OVR_CURVATURE_IMPOSED;
    if (isnan(T) || r->values.curvature != OVR_CURVATURE_RIDES)
        return OVR_OK;
    return ovr_fail_slot(
        err, ovr_slot_of(r, "radius", "curvature"),
        "rides: at T = %.4g the curvature changes too fast, or a surface moves "
        "too slowly, for it to ride with the material from X = %.3g to %.3g",
        T, s->options->inlet, s->options->outlet);
}
