/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plastic strain and residual stress at the end of a run, for the page: values
 * at places in the material and at depths that grow geometrically from the
 * first layer, and where the material is at each snapshot.
 */
#include "pictures/view_material.h"

#include <math.h>
#include <stdio.h>

#include "overroll/case.h"
#include "pictures/draw_element.h"
#include "pictures/pack_levels.h"
#include "results/results.h"
#include "surface/surfaces.h"

enum { ROWS = 40, MAX_COLUMNS = 400 };

typedef struct material {
    const ovr_stored *run;
    ovr_arena *arena;
    char group[40];
    int surface;
    size_t depths, points, columns;
    double *z, *xi, *cell;
    double depth[ROWS];
} material;

static const struct {
    const char *array, *name;
    bool pure; /* a number without a unit */
} maps[] = {{"cumulative", "plastic strain", true},
            {"residual_x", "residual stress along x", false},
            {"residual_z", "residual stress along z", false},
            {"residual_xz", "residual shear stress", false}};

static double *read_rows(const material *m, const char *what, size_t rows,
                         size_t n, ovr_error *err)
{
    char path[64];
    double *v = ovr_arena_take(m->arena, rows * n, sizeof *v, err);
    snprintf(path, sizeof path, "%s/%s", m->group, what);
    for (size_t r = 0; v && r < rows; r++)
        if (ovr_result_read(m->run->result, path, r, OVR_HERTZIAN, v + r * n,
                            err))
            return NULL;
    return v;
}

static bool find_group(material *m)
{
    for (m->surface = 1; m->surface <= 2; m->surface++) {
        char path[64];
        snprintf(m->group, sizeof m->group, "plastic/surface_%d", m->surface);
        snprintf(path, sizeof path, "%s/cumulative", m->group);
        const ovr_variable *v = ovr_result_find(m->run->result, path);
        if (v && v->rank == 2 && v->shape[0] > 1 && v->shape[1] > 1) {
            m->depths = v->shape[0];
            m->points = v->shape[1];
            return true;
        }
    }
    return false;
}

/* X of the reference, the centre of the surface's first feature. */
static bool find_places(const material *m, size_t shots, size_t every,
                        double *at)
{
    ovr_case *c = NULL;
    ovr_setup *setup = ovr_stored_setup(m->run, &c, NULL);
    bool made = setup && !ovr_setup_prepare(setup, NULL, NULL);
    size_t n = made ? ovr_surfaces_count(setup->surfaces) : 0;
    size_t k = 0;
    while (k < n && ovr_surfaces_info(setup->surfaces, k).surface != m->surface)
        k++;
    for (size_t shot = 0; k < n && shot < shots; shot++)
        at[shot] = ovr_surfaces_centre(setup->surfaces, k,
                                       m->run->times[shot * every]);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return k < n;
}

static void put_doubles(ovr_text *to, const char *key, const double *values,
                        size_t n, const char *behind)
{
    ovr_text_print(to, "\"%s\":\"", key);
    ovr_text_base64(to, values, n * sizeof *values);
    ovr_text_print(to, "\"%s", behind);
}

/* Values of the layer and of the point that a cell lies in. */
static ovr_status put_map(ovr_text *to, const material *m, size_t map,
                          ovr_error *err)
{
    const double *v = read_rows(m, maps[map].array, m->depths, m->points, err);
    double low = 0, high = 0;
    if (!v)
        return OVR_BAD_INPUT;
    for (size_t r = 0, j = 0; r < ROWS; r++) {
        while (j + 1 < m->depths && sqrt(m->z[j] * m->z[j + 1]) < m->depth[r])
            j++;
        for (size_t c = 0; c < m->columns; c++) {
            size_t i = c * (m->points - 1) / (m->columns - 1);
            double value = v[j * m->points + i];
            m->cell[r * m->columns + c] = value;
            low = fmin(low, value);
            high = fmax(high, value);
        }
    }
    ovr_text_print(to,
                   "%s{\"name\":\"%s\",\"pure\":%d,\"low\":%.17g,"
                   "\"high\":%.17g,",
                   map ? "," : "", maps[map].name, maps[map].pure, low,
                   high > low ? high : low + 1);
    put_doubles(to, "data", m->cell, ROWS * m->columns, "}");
    return OVR_OK;
}

ovr_status ovr_view_material(ovr_text *to, const ovr_stored *run, size_t shots,
                             size_t every, ovr_arena *arena, ovr_error *err)
{
    material m = {.run = run, .arena = arena};
    double *at = ovr_arena_take(arena, shots, sizeof *at, err);
    if (!at)
        return OVR_NO_MEMORY;
    if (!find_group(&m) || !find_places(&m, shots, every, at))
        return OVR_OK;
    m.columns = m.points > MAX_COLUMNS ? MAX_COLUMNS : m.points;
    m.z = read_rows(&m, "depth", 1, m.depths, err);
    m.xi = read_rows(&m, "material", 1, m.points, err);
    m.cell = ovr_arena_take(arena, ROWS * m.columns, sizeof *m.cell, err);
    if (!m.z || !m.xi || !m.cell)
        return OVR_BAD_INPUT;
    for (int r = 0; r < ROWS; r++)
        m.depth[r] = m.z[0] *
                     pow(m.z[m.depths - 1] / m.z[0], (double)r / (ROWS - 1));
    ovr_text_print(to,
                   "\"material\":{\"columns\":%zu,\"rows\":%d,\"x0\":%.17g,"
                   "\"x1\":%.17g,",
                   m.columns, ROWS, m.xi[0], m.xi[m.points - 1]);
    put_doubles(to, "z", m.depth, ROWS, ",");
    put_doubles(to, "place", at, shots, ",\"fields\":[");
    ovr_status status = OVR_OK;
    for (size_t map = 0; !status && map < sizeof maps / sizeof *maps; map++)
        status = put_map(to, &m, map, err);
    ovr_text_put(to, "]},");
    return status;
}
