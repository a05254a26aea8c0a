/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/review_element.h"
#include "run/review.h"

#include <math.h>
#include <stdio.h>

#include "case/resolve.h"
#include "case/setup.h"
#include "elements/elements.h"
#include "surface/surfaces.h"

/* The load of spur gears comes on about B and leaves about D within the blend,
 * where shares are those of no rule. */
static bool blends(const ovr_gear_form *f, const ovr_gear_geometry *g)
{
    return f->blend > 0 && !(g->overlap_ratio > 0) &&
           (f->sharing == OVR_SHARING_RULE ||
            f->sharing == OVR_SHARING_ELASTIC);
}

static void review_blend(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const ovr_gear *gear = ovr_setup_gear(setup);
    const ovr_gear_form *f = ovr_gear_form_of(gear);
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    if (!gear || !blends(f, g) || f->blend <= (g->contact_ratio - 1) / 3)
        return;
    ovr_warn(
        say, data,
        "[gear] blend: the load comes on over %.3g base pitches, more than "
        "a third of the %.3g from A to B: shares there are the blend's",
        f->blend, g->contact_ratio - 1);
}

static void review_end(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const ovr_resolved *r = (const ovr_resolved *)setup;
    double way = r->element.end, end = setup->march->end;
    if (!(way > 0) || !setup->transient || end >= way * (1 - 1e-9))
        return;
    ovr_warn(say, data,
             "[time] end = %.4g: the run ends on its way, which goes to %.4g "
             "(%.4g ms)",
             end, way, 1e3 * way * setup->contact->time);
}

/* Reviews the film of the fit, where that is smallest. */
static void review_film(const ovr_setup *setup, ovr_listener *say, void *data)
{
    ovr_station station[OVR_STATIONS_MAX];
    size_t n = ovr_setup_stations(setup, station), minimum = 0;
    double Rq = setup->surfaces ? ovr_surfaces_roughness(setup->surfaces) *
                                      setup->contact->height
                                : 0;
    for (size_t k = 1; k < n; k++)
        if (station[k].minimum < station[minimum].minimum)
            minimum = k;
    if (n == 0 || !(station[minimum].minimum < Rq))
        return;
    ovr_warn(say, data,
             "at %s the smallest film is %.3g um by the fit, below the "
             "roughness of both surfaces, Rq = %.3g um: they would touch there",
             station[minimum].name, 1e6 * station[minimum].minimum, 1e6 * Rq);
}

void ovr_review_element(const ovr_setup *setup, ovr_listener *say, void *data)
{
    if (!say)
        return;
    review_blend(setup, say, data);
    review_end(setup, say, data);
    review_film(setup, say, data);
}

void ovr_review_element_after(const ovr_setup *setup,
                              const ovr_statistics *total, ovr_listener *say,
                              void *data)
{
    const ovr_gear *gear = ovr_setup_gear(setup);
    const ovr_gear_form *f = ovr_gear_form_of(gear);
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    if (!gear || !say || !blends(f, g) || !setup->transient)
        return;
    const double way[] = {g->R1_B, g->R1_D};
    double t = g->begin + total->when.P_max * setup->contact->time;
    double v = g->base_1 * g->omega_1, maximum = f->blend * g->base_pitch;
    for (int k = 0; k < 2; k++) {
        double off = fabs(t - ovr_gear_time(gear, way[k])) * v;
        if (!(off <= maximum))
            continue;
        ovr_warn(
            say, data,
            "the largest pressure, %.4g GPa, stands %.2g mm from %c, where "
            "the load comes on or leaves within %.2g mm: it is made by how "
            "suddenly it does ([gear] blend), more than by the contact",
            1e-9 * total->extreme.P_max * setup->contact->ph, 1e3 * off,
            "BD"[k], 1e3 * maximum);
        return;
    }
}
