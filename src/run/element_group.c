/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The group `element` of a result file: what the contact of a gear pair or cam
 * goes through, as its element says it and not as the run's splines have it. */
#include <math.h>

#include "case/setup.h"
#include "elements/elements.h"
#include "results/results.h"
#include "run/internal.h"

enum { LOOKS = 401, ARRAYS = 7 };

/* Lengths in b, speeds and load over the nominal ones; a flat is NAN. */
static void look(const ovr_setup *setup, double *const column[ARRAYS + 1])
{
    const ovr_gear *gear = ovr_setup_gear(setup);
    const ovr_cam *cam = ovr_setup_cam(setup);
    const ovr_gear_geometry *g = ovr_gear_of(gear);
    const ovr_contact *c = setup->contact;
    double begin = gear ? g->begin : 0;
    double end = gear ? g->end : ovr_cam_of(cam)->duration;
    double v = gear ? g->base_1 * g->omega_1 : ovr_cam_form_of(cam)->speed;
    for (size_t k = 0; k < LOOKS; k++) {
        double t = begin + (end - begin) * (double)k / (LOOKS - 1);
        ovr_element_moment m = gear ? ovr_gear_at(gear, t) : ovr_cam_at(cam, t);
        double way = gear ? (t - ovr_gear_time(gear, g->R1_C)) * v / c->b
                          : (ovr_cam_of(cam)->from + v * t) * 180 / acos(-1);
        const double values[] = {(t - begin) / c->time,
                                 way,
                                 m.R / c->b,
                                 m.R_1 / c->b,
                                 m.R_2 / c->b,
                                 m.u1 / c->um,
                                 m.u2 / c->um,
                                 m.load / c->load};
        for (int i = 0; i <= ARRAYS; i++)
            column[i][k] = isfinite(values[i]) ? values[i] : NAN;
    }
}

ovr_status ovr_run_keep_element(ovr_run *run, ovr_error *err)
{
    static const struct {
        const char *name, *long_name;
        ovr_unit_kind kind;
    } of[ARRAYS] = {
        {"path", "way of the contact: from the pitch point, positive behind it",
         OVR_KIND_LENGTH},
        {"radius", "reduced radius", OVR_KIND_LENGTH},
        {"radius_1", "radius of surface 1", OVR_KIND_LENGTH},
        {"radius_2", "radius of surface 2", OVR_KIND_LENGTH},
        {"speed_1", "speed of surface 1 over the nominal mean speed",
         OVR_KIND_NUMBER},
        {"speed_2", "speed of surface 2 over the nominal mean speed",
         OVR_KIND_NUMBER},
        {"load", "load over the nominal load", OVR_KIND_NUMBER}};
    const ovr_setup *setup = run->setup;
    bool cam = ovr_setup_cam(setup) != NULL;
    double *column[ARRAYS + 1];
    ovr_group_array array[ARRAYS];
    if (!cam && !ovr_setup_gear(setup))
        return OVR_OK;
    column[0] = ovr_arena_take(&run->arena, (ARRAYS + 1) * LOOKS,
                               sizeof *column[0], err);
    if (!column[0])
        return OVR_NO_MEMORY;
    for (int i = 1; i <= ARRAYS; i++)
        column[i] = column[0] + (size_t)i * LOOKS;
    look(setup, column);
    for (int i = 0; i < ARRAYS; i++)
        array[i] = (ovr_group_array){.name = of[i].name,
                                     .long_name = of[i].long_name,
                                     .kind = of[i].kind,
                                     .rank = 1,
                                     .doubles = column[i + 1]};
    if (cam) {
        array[0].name = "angle";
        array[0].long_name = "angle of the cam, degrees";
        array[0].kind = OVR_KIND_NUMBER;
    }
    const ovr_group_axis axis = {"moment", "time from the beginning of the way",
                                 OVR_KIND_TIME, LOOKS, column[0]};
    const ovr_group group = {.path = "element",
                             .axes = 1,
                             .arrays = ARRAYS,
                             .axis = &axis,
                             .array = array};
    return ovr_writer_group(run->writer, &group, false, err);
}
