/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plastic strain and residual stress at the end of a run, for the page: values
 * at places in the material and at depths that grow geometrically from the
 * first layer, and where the material is at each snapshot.
 */
#include "pictures/view_run.h"

#include <math.h>
#include <stdio.h>

#include "overroll/case.h"
#include "pictures/material.h"
#include "pictures/pack_levels.h"
#include "surface/surfaces.h"

enum { ROWS = 40, MAX_COLUMNS = 400 };

typedef struct material {
    ovr_material_group in;
    int surface;
    size_t columns;
    double *cell, depth[ROWS];
} material;

static const struct {
    const char *array, *name;
    bool pure; /* a number without a unit */
} maps[] = {{"cumulative", "plastic strain", true},
            {"residual_x", "residual stress along x", false},
            {"residual_z", "residual stress along z", false},
            {"residual_xz", "residual shear stress", false}};

static bool find_group(material *m)
{
    for (m->surface = 1; m->surface <= 2; m->surface++)
        if (ovr_material_find(&m->in, "plastic", m->surface, "cumulative") &&
            m->in.depths > 1)
            return true;
    return false;
}

/* X of the reference, the centre of the surface's first feature. */
static bool find_places(const material *m, size_t shots, size_t every,
                        double *at)
{
    ovr_case *c = NULL;
    ovr_setup *setup = ovr_stored_setup(m->in.run, &c, NULL);
    bool made = setup && !ovr_setup_prepare(setup, NULL, NULL);
    size_t n = made ? ovr_surfaces_count(setup->surfaces) : 0;
    size_t k = 0;
    while (k < n && ovr_surfaces_info(setup->surfaces, k).surface != m->surface)
        k++;
    for (size_t shot = 0; k < n && shot < shots; shot++)
        at[shot] = ovr_surfaces_centre(setup->surfaces, k,
                                       m->in.run->times[shot * every]);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return k < n;
}

/* Values of the layer and of the point that a cell lies in. */
static ovr_status put_map(ovr_text *to, const material *m, size_t map,
                          ovr_error *err)
{
    const ovr_material_group *in = &m->in;
    const double *v = ovr_material_read(in, maps[map].array, in->depths,
                                        in->points, err);
    double low = 0, high = 0;
    if (!v)
        return OVR_BAD_INPUT;
    for (size_t r = 0, j = 0; r < ROWS; r++) {
        while (j + 1 < in->depths &&
               sqrt(in->z[j] * in->z[j + 1]) < m->depth[r])
            j++;
        for (size_t c = 0; c < m->columns; c++) {
            size_t i = c * (in->points - 1) / (m->columns - 1);
            double value = v[j * in->points + i];
            m->cell[r * m->columns + c] = value;
            low = fmin(low, value);
            high = fmax(high, value);
        }
    }
    ovr_text_put(to, map ? ",{" : "{");
    ovr_text_doubles(to, "data", m->cell, ROWS * m->columns);
    ovr_text_print(
        to, "\"name\":\"%s\",\"pure\":%d,\"low\":%.17g,\"high\":%.17g}",
        maps[map].name, maps[map].pure, low, high > low ? high : low + 1);
    return OVR_OK;
}

ovr_status ovr_view_material(const ovr_view_run *view, ovr_error *err)
{
    ovr_text *to = view->to;
    ovr_arena *arena = view->arena;
    const size_t shots = view->shots;
    material m = {.in = {.run = view->run, .arena = arena}};
    const ovr_material_group *in = &m.in;
    double *at = ovr_arena_take(arena, shots, sizeof *at, err);
    if (!at)
        return OVR_NO_MEMORY;
    if (!find_group(&m) || !find_places(&m, shots, view->every, at))
        return OVR_OK;
    m.columns = in->points > MAX_COLUMNS ? MAX_COLUMNS : in->points;
    m.cell = ovr_arena_take(arena, ROWS * m.columns, sizeof *m.cell, err);
    if (!m.cell || ovr_material_axes(&m.in, err))
        return OVR_BAD_INPUT;
    for (int r = 0; r < ROWS; r++)
        m.depth[r] = in->z[0] * pow(in->z[in->depths - 1] / in->z[0],
                                    (double)r / (ROWS - 1));
    ovr_text_print(to,
                   "\"material\":{\"columns\":%zu,\"rows\":%d,\"x0\":%.17g,"
                   "\"x1\":%.17g,",
                   m.columns, ROWS, in->xi[0], in->xi[in->points - 1]);
    ovr_text_doubles(to, "z", m.depth, ROWS);
    ovr_text_doubles(to, "place", at, shots);
    ovr_text_put(to, "\"fields\":[");
    ovr_status status = OVR_OK;
    for (size_t map = 0; !status && map < sizeof maps / sizeof *maps; map++)
        status = put_map(to, &m, map, err);
    ovr_text_put(to, "]},");
    return status;
}
