/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/review_plausible.h"
#include "run/review.h"

#include <math.h>
#include <stdio.h>

#include "case/resolve.h"

typedef struct usual {
    const char *what, *unit;
    double value, scale;     /* of the unit */
    double minimum, maximum; /* in it */
} usual;

static void judge(const usual *u, ovr_listener *say, void *data)
{
    double value = u->value / u->scale;
    if (!isfinite(value) || (value >= u->minimum && value <= u->maximum))
        return;
    ovr_warn(say, data,
             "%s %.4g %s: usual are %g to %g %s; is the unit the one that was "
             "meant?",
             u->what, value, u->unit, u->minimum, u->maximum, u->unit);
}

/* Rubber to tungsten carbide on diamond; wires to rolls of mills; oils from
 * refrigerants to greases' base. */
static void review_contact(const ovr_setup *s, ovr_listener *say, void *data)
{
    const ovr_contact *c = s->contact;
    bool stiffens = s->lubricant->viscosity_law != OVR_ISOVISCOUS;
    const usual all[] = {
        {"modulus", "GPa", c->modulus, 1e9, 1, 1000},
        {"radius", "mm", c->radius, 1e-3, 0.1, 2000},
        {"load", "kN/m", c->load, 1e3, 1, 20000},
        {"viscosity", "Pa.s", c->viscosity, 1, 1e-4, 20},
        {"alpha", "1/GPa", stiffens ? c->alpha : NAN, 1e-9, 3, 60}};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        judge(&all[k], say, data);
}

/* Bodies are parabolas and half-spaces where they touch, which cylinders are
 * only near the line of contact. */
static void review_width(const ovr_setup *s, ovr_listener *say, void *data)
{
    const double widest = 0.3;
    const ovr_resolved *r = (const ovr_resolved *)s;
    const ovr_contact *c = s->contact;
    double radius = c->radius;
    for (int k = 0; k < 2; k++)
        if (isfinite(r->body[k].radius))
            radius = fmin(radius, fabs(r->body[k].radius));
    if (c->b > widest * radius)
        ovr_warn(
            say, data,
            "the contact is %.4g mm wide on a radius of %.4g mm: parabolic "
            "gaps and elastic half-spaces hold up to a half width of 0.3 "
            "radii",
            2e3 * c->b, 1e3 * radius);
}

static void review_feature(const ovr_setup *s, const ovr_feature_form *f,
                           ovr_listener *say, void *data)
{
    const double steepest = 0.25;
    char what[80];
    double size = isfinite(f->width) ? f->width : f->width_half;
    double width = size * s->contact->b;
    double depth = f->depth * s->contact->height;
    snprintf(what, sizeof what, "feature '%.40s': width", f->name);
    judge(&(usual){what, "um", width, 1e-6, 0.1, 1e5}, say, data);
    if (f->shape != OVR_INDENT || !(depth > steepest * width))
        return;
    ovr_warn(say, data,
             "feature '%.40s': %.3g um deep and %.3g um wide: indents are less "
             "deep than a quarter of their width, 0.001 to 0.1 of it as a rule",
             f->name, depth * 1e6, width * 1e6);
}

void ovr_review_plausible(const ovr_setup *setup, ovr_listener *say, void *data)
{
    if (!say)
        return;
    review_contact(setup, say, data);
    review_width(setup, say, data);
    for (size_t k = 0; k < setup->features; k++)
        review_feature(setup, setup->feature[k], say, data);
}
