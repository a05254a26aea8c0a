/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds where a feature is at T = 0. */
#include <math.h>

#include "base/error.h"
#include "base/text.h"
#include "surface/feature.h"

/* Finds where the centre is at T = 0 when the feature's reference point
 * (start), its centre, its leading edge or its arrival at X = 0 was given. */
static double centre_at_start(double way, const ovr_feature_form *form,
                              const ovr_feature *f)
{
    bool tabulated = f->table || f->areal;
    if (!isnan(form->centre))
        return form->centre;
    if (!isnan(form->edge))
        return form->edge - f->ahead;
    if (!isnan(form->arrival))
        return -way;
    return tabulated ? form->start - f->ahead : form->start;
}

/* Just outside of the film, on the side that it comes from. */
static ovr_status start_outside(ovr_feature *f, const ovr_feature_form *form,
                                double inlet, double outlet, ovr_error *err)
{
    const char *about = isnan(form->start) ? NULL : "start";
    if (isnan(inlet) || isnan(outlet))
        return ovr_fail_about(
            err, about,
            "feature '%s': %s %s needs its place at T = 0: start, "
            "centre or edge, or its arrival at X = 0",
            f->name, ovr_article(ovr_shape_name((int)f->shape)),
            ovr_shape_name((int)f->shape));
    if (f->ratio == 0)
        return ovr_fail_about(
            err, about,
            "feature '%s' cannot enter the contact, because surface %d does "
            "not move; set the X of its centre or edge",
            f->name, f->surface);
    f->start = !f->back ? inlet - f->ahead : outlet + f->behind;
    if (isfinite(f->start))
        return OVR_OK;
    return ovr_fail_about(err, about,
                          "feature '%s' has no end on its leading side; set "
                          "start to the X of its edge",
                          f->name);
}

/* The key of the position, one of them if there are several. */
static const char *place_of(const ovr_feature_form *form)
{
    return !isnan(form->arrival)  ? "arrival"
           : !isnan(form->edge)   ? "edge"
           : !isnan(form->centre) ? "centre"
           : !isnan(form->start)  ? "start"
                                  : "origin";
}

ovr_status ovr_feature_place(ovr_feature *f, const ovr_feature_form *form,
                             double way, double inlet, double outlet,
                             ovr_error *err)
{
    int given = !isnan(form->start) + !isnan(form->centre) +
                !isnan(form->edge) + !isnan(form->arrival);
    const char *shape = ovr_shape_name((int)f->shape);
    if (given > 1 || (given && !isnan(form->origin)))
        return ovr_fail_about(err, place_of(form),
                              "feature '%s': set only one of start, centre, "
                              "edge, arrival and origin",
                              f->name);
    if (ovr_is_endless(f)) {
        if (given)
            return ovr_fail_about(
                err, place_of(form),
                "feature '%s': %s %s is endless; set origin instead", f->name,
                ovr_article(shape), shape);
        f->start = isnan(form->origin) ? 0 : form->origin;
    } else if (!given || form->start == -INFINITY) {
        return start_outside(f, form, inlet, outlet, err);
    } else if (!isnan(form->arrival) && f->ratio == 0) {
        return ovr_fail_about(err, "arrival",
                              "feature '%s': never arrives, because surface "
                              "%d does not move; set start instead of arrival",
                              f->name, f->surface);
    } else {
        f->start = centre_at_start(way, form, f);
    }
    if (!isfinite(f->start))
        return ovr_fail_about(err, place_of(form),
                              "feature '%s': its position must be a finite "
                              "number",
                              f->name);
    return OVR_OK;
}
