/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * end = auto: the time from which on nothing can change any more but the film
 * that still settles, and a last time for that.
 *
 * What a feature has done to the film moves on at the mean speed; behind a
 * fast surface it leaves later than the feature, at most one passage of the
 * domain.
 */
#include <math.h>

#include "case/resolve.h"
#include "contact/contact.h"
#include "surface/surfaces.h"

static const double LATEST = 1e5; /* b/um, as of a given end */

/* Pressure changes by less a b/um when the film is called steady again: a
 * hundred-thousandth of ph, far below the discretization error. */
static const double NEARLY = 1e-5;

static ovr_status refuse(const ovr_slot *end, const ovr_feature_info *f,
                         const char *why, ovr_error *err)
{
    return ovr_fail_slot(err, end, "auto: feature '%s' %s; give a time instead",
                         f->name, why);
}

static ovr_status wait_for(const ovr_setup *s, const ovr_slot *end, size_t k,
                           double *T, ovr_error *err)
{
    const ovr_options *o = s->options;
    ovr_feature_info f = ovr_surfaces_info(s->surfaces, k);
    ovr_feature_times times;
    if (f.speed == 0 && !s->sliding) { /* the film gets used to it */
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
                                 "auto: the history of [%s] never ends; give a "
                                 "time instead",
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
    if (!s->transient || r->values.end != OVR_END_AUTO)
        return OVR_OK;
    for (size_t k = 0; !status && k < n; k++)
        status = wait_for(s, end, k, &T, err);
    if (!status)
        status = wait_for_histories(s, end, &T, err);
    if (!status && !(T > 0))
        status = ovr_fail_slot(err, end,
                               "auto: nothing passes and nothing changes; "
                               "leave end out for a steady solution");
    r->march.until_steady = true;
    r->march.steady_from = T;
    r->march.steady_rate = NEARLY;
    r->march.end = T + 2 * passage;
    return status;
}
