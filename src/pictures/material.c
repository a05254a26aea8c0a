/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/material.h"

#include <math.h>
#include <stdio.h>

#include "results/results.h"

enum { CELLS_X = 420 };

const char ovr_material_place[] =
    "position in the material, {/Symbol x} ({/:Italic b}), trailing side at "
    "the left";

bool ovr_material_find(ovr_material_group *m, const char *group, int surface,
                       const char *array)
{
    char path[64];
    snprintf(m->group, sizeof m->group, "%s/surface_%d", group, surface);
    snprintf(path, sizeof path, "%s/%s", m->group, array);
    const ovr_variable *v = ovr_result_find(m->run->result, path);
    if (!v || v->rank != 2 || v->shape[1] < 2)
        return false;
    m->depths = v->shape[0];
    m->points = v->shape[1];
    return true;
}

double *ovr_material_read(const ovr_material_group *m, const char *name,
                          size_t rows, size_t n, ovr_error *err)
{
    char path[96];
    double *v = ovr_arena_take(m->arena, rows * n, sizeof *v, err);
    snprintf(path, sizeof path, "%s/%s", m->group, name);
    for (size_t r = 0; v && r < rows; r++)
        if (ovr_result_read(m->run->result, path, r, OVR_HERTZIAN, v + r * n,
                            err))
            return NULL;
    return v;
}

ovr_status ovr_material_axes(ovr_material_group *m, ovr_error *err)
{
    m->z = ovr_material_read(m, "depth", 1, m->depths, err);
    m->xi = ovr_material_read(m, "material", 1, m->points, err);
    return m->z && m->xi ? OVR_OK : OVR_BAD_INPUT;
}

ovr_status ovr_material_map(const ovr_material_group *m, const double *field,
                            ovr_material_at *at, ovr_panel *p, ovr_error *err)
{
    size_t rows = p->image.ny;
    double *v = ovr_arena_take(m->arena, CELLS_X * rows, sizeof *v, err);
    if (!v)
        return OVR_NO_MEMORY;
    p->x_label = ovr_material_place;
    p->y_label = "log_{10} of depth, {/:Italic z} ({/:Italic b})";
    p->y_from = log10(m->z[m->depths - 1]);
    p->y_to = log10(m->z[0]);
    p->image.nx = CELLS_X;
    p->image.values = v;
    for (size_t r = 0; r < rows; r++)
        for (size_t c = 0; c < CELLS_X; c++) {
            double xi = p->x_from +
                        (p->x_to - p->x_from) * ((double)c + 0.5) / CELLS_X;
            double z = p->y_from +
                       (p->y_to - p->y_from) * ((double)r + 0.5) / (double)rows;
            v[r * CELLS_X + c] = at(m, field, xi, pow(10, z));
        }
    return OVR_OK;
}
