/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data of a plastic body in a result file, which a later run can read: strains
 * (absolute if p_h/E* is known), residual stresses, profile before and after.
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/disk.h"
#include "base/error.h"
#include "physics/plastic/bodies.h"
#include "results/results.h"

enum { STATE = OVR_PLASTIC_STATE, STRESSES = 4, MAPS = STATE + STRESSES };
enum { DEPTH, MATERIAL };

static const char *const map_names[MAPS][2] = {
    {"plastic_strain_x", "plastic strain along the surface"},
    {"plastic_strain_z", "plastic strain across the surface"},
    {"plastic_strain_xz", "plastic shear strain (half the angle)"},
    {"cumulative", "accumulated plastic strain (von Mises)"},
    {"residual_x", "residual stress along the surface"},
    {"residual_y", "residual stress along the line of contact"},
    {"residual_z", "residual stress across the surface"},
    {"residual_xz", "residual shear stress"}};

static double unit_of(const ovr_plastic *p, const ovr_yielding_body *b)
{
    double strain = p->how->body[b == p->body ? 0 : 1].strain;
    return isnan(strain) ? 1 : strain;
}

static const char *group_of(const ovr_plastic *p, const ovr_yielding_body *b)
{
    return b == p->body ? "plastic/surface_1" : "plastic/surface_2";
}

static void fill_maps(const ovr_plastic *p, const ovr_yielding_body *b,
                      double *to)
{
    size_t layers = b->layers, n = b->points, all = layers * n;
    double unit = unit_of(p, b);
    for (size_t j = 0; j < layers; j++)
        for (size_t i = 0; i < n; i++) {
            ovr_stressed s = ovr_yielding_residual(b->y, j, i);
            const double stress[STRESSES] = {s.x, s.y, s.z, s.xz};
            for (size_t m = 0; m < STATE; m++)
                to[m * all + j * n + i] = unit *
                                          b->kept[(STATE * j + m) * n + i];
            for (size_t m = 0; m < STRESSES; m++)
                to[(STATE + m) * all + j * n + i] = stress[m];
        }
}

typedef struct storage {
    ovr_group group;
    ovr_group_axis axis[2];
    ovr_group_array array[MAPS + 2];
    ovr_group_attribute attribute[16];
} storage;

static void add_number(storage *s, const char *name, double value)
{
    s->attribute[s->group.attributes++] = (ovr_group_attribute){name, NULL,
                                                                value};
}

static void add_line(storage *s, const char *name, const char *text,
                     const double *values)
{
    s->array[s->group.arrays++] = (ovr_group_array){.name = name,
                                                    .long_name = text,
                                                    .kind = OVR_KIND_HEIGHT,
                                                    .rank = 1,
                                                    .along = {MATERIAL},
                                                    .doubles = values};
}

static void add_attributes(storage *s, const ovr_plastic *p,
                           const ovr_yielding_body *b)
{
    const ovr_plastic_body *of = &p->how->body[b == p->body ? 0 : 1];
    add_number(s, "yield", of->hardening.yield);
    add_number(s, "strain_unit", of->strain);
    add_number(s, "depth_max", p->how->depth);
    add_number(s, "work", b->work);
    add_number(s, "beyond_yield_left", b->left);
    add_number(s, "plastic_strain_max", ovr_plastic_max(p, b));
    add_number(s, "profile_change_max", ovr_plastic_deepest(b));
    add_number(s, "shoulder_before_leading", ovr_plastic_shoulder(b, 1, false));
    add_number(s, "shoulder_before_trailing",
               ovr_plastic_shoulder(b, -1, false));
    add_number(s, "shoulder_height_leading", ovr_plastic_shoulder(b, 1, true));
    add_number(s, "shoulder_height_trailing",
               ovr_plastic_shoulder(b, -1, true));
}

static ovr_status store_body(ovr_writer *writer, const ovr_plastic *p,
                             const ovr_yielding_body *b, ovr_error *err)
{
    size_t layers = b->layers, n = b->points;
    ovr_arena arena = ovr_arena_make(NULL);
    double *maps = ovr_arena_take(&arena, MAPS * layers * n, sizeof *maps, err);
    double *lines = ovr_arena_take(&arena, 2 * n, sizeof *lines, err);
    storage s = {.group = {.axes = 2}};
    ovr_status status = OVR_NO_MEMORY;
    if (maps && lines) {
        double *xi = lines, *after = lines + n;
        fill_maps(p, b, maps);
        for (size_t i = 0; i < n; i++) {
            xi[i] = b->first + (double)i * b->mesh;
            after[i] = b->shape[i] - b->shown[i];
        }
        s.group.path = group_of(p, b);
        s.group.axis = s.axis;
        s.group.array = s.array;
        s.group.attribute = s.attribute;
        s.axis[DEPTH] = (ovr_group_axis){"depth", "middle of the layer",
                                         OVR_KIND_LENGTH, layers, b->z};
        s.axis[MATERIAL] = (ovr_group_axis){
            "material", "position in the material", OVR_KIND_LENGTH, n, xi};
        for (size_t m = 0; m < MAPS; m++)
            s.array[s.group.arrays++] = (ovr_group_array){
                .name = map_names[m][0],
                .long_name = map_names[m][1],
                .kind = m < STATE ? OVR_KIND_NUMBER : OVR_KIND_PRESSURE,
                .rank = 2,
                .along = {DEPTH, MATERIAL},
                .doubles = maps + m * layers * n};
        add_line(&s, "profile_before",
                 "height of the features before "
                 "plastic deformation",
                 b->shape);
        add_line(&s, "profile_after",
                 "height of the features after plastic "
                 "deformation",
                 after);
        add_attributes(&s, p, b);
        status = ovr_writer_group(writer, &s.group, false, err);
    }
    ovr_arena_release(&arena);
    return status;
}

ovr_status ovr_plastic_store(ovr_writer *writer, const ovr_plastic *p,
                             ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (int k = 0; !status && k < 2; k++)
        if (p->body[k].y)
            status = store_body(writer, p, &p->body[k], err);
    return status;
}

/* ---------------------------------------------------------------- profiles */

static void profile_path(const ovr_plastic *p, const char *end, char *path,
                         size_t capacity)
{
    snprintf(path, capacity, "%.4400s-%s.csv", p->how->profiles, end);
}

static const char *profile_head(const ovr_plastic *p)
{
    const ovr_contact *c = p->setup->contact;
    return isfinite(c->b) && isfinite(c->height) ? "x [um], z [um]\n"
                                                 : "# x in b, z in b^2/R\n";
}

ovr_status ovr_plastic_check_profiles(const ovr_plastic *p, ovr_error *err)
{
    char path[4500];
    ovr_status status = OVR_OK;
    for (int k = 0; !status && k < 2; k++) {
        profile_path(p, k ? "after" : "before", path, sizeof path);
        status = ovr_file_ours(path, profile_head(p), err);
    }
    return status;
}

/* Writes a profile; x is relative to the reference, in um if b is known. */
static ovr_status write_profile(const ovr_plastic *p,
                                const ovr_yielding_body *b, const char *end,
                                bool after, ovr_error *err)
{
    const ovr_contact *c = p->setup->contact;
    bool metres = isfinite(c->b) && isfinite(c->height);
    double length = metres ? c->b * 1e6 : 1;
    double height = metres ? c->height * 1e6 : 1;
    char path[4500];
    profile_path(p, end, path, sizeof path);
    FILE *to = fopen(path, "w");
    if (!to)
        return ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path,
                        strerror(errno));
    fputs(profile_head(p), to);
    for (size_t i = 0; i < b->points; i++)
        fprintf(to, "%.9g, %.9g\n", length * (b->first + (double)i * b->mesh),
                height * (b->shape[i] - (after ? b->shown[i] : 0)));
    bool good = !ferror(to);
    if (fclose(to) == 0 && good)
        return OVR_OK;
    return ovr_fail(err, OVR_IO, "%s: cannot be written", path);
}

ovr_status ovr_plastic_write_profiles(const ovr_plastic *p, ovr_error *err)
{
    const ovr_yielding_body *b = &p->body[p->body[0].y ? 0 : 1];
    ovr_status status = write_profile(p, b, "before", false, err);
    return status ? status : write_profile(p, b, "after", true, err);
}

/* ----------------------------------------------------------------- reading */

/* Checks that the file has the same window and layers. */
static ovr_status check_file(ovr_result *result, const char *file,
                             const ovr_plastic *p, const ovr_yielding_body *b,
                             ovr_error *err)
{
    char path[80];
    size_t layers = b->layers, n = b->points;
    double *axis = NULL;
    bool same = false;
    ovr_arena arena = ovr_arena_make(NULL);
    snprintf(path, sizeof path, "%s/%s", group_of(p, b), map_names[0][0]);
    const ovr_variable *v = ovr_result_find(result, path);
    if (!v) {
        ovr_arena_release(&arena);
        return ovr_fail_about(err, "initial",
                              "%s: contains no plastic strains of surface %d",
                              file, b == p->body ? 1 : 2);
    }
    if (v->rank == 2 && v->shape[0] == layers && v->shape[1] == n)
        axis = ovr_arena_take(&arena, layers > n ? layers : n, sizeof *axis,
                              err);
    if (axis) {
        snprintf(path, sizeof path, "%s/material", group_of(p, b));
        same = !ovr_result_read(result, path, 0, OVR_HERTZIAN, axis, err) &&
               fabs(axis[0] - b->first) < 0.01 * b->mesh &&
               fabs(axis[1] - axis[0] - b->mesh) < 1e-6 * b->mesh;
        snprintf(path, sizeof path, "%s/depth", group_of(p, b));
        same = same &&
               !ovr_result_read(result, path, 0, OVR_HERTZIAN, axis, err) &&
               fabs(axis[layers - 1] - b->z[layers - 1]) <
                   1e-6 * b->z[layers - 1];
    }
    ovr_arena_release(&arena);
    if (same)
        return OVR_OK;
    return ovr_fail_about(
        err, "initial",
        "%s: its window or layers differ; use the same domain.level, "
        "plastic.window, plastic.layers and plastic.depth_max",
        file);
}

ovr_status ovr_plastic_read(const char *file, const ovr_plastic *p,
                            ovr_yielding_body *b, ovr_error *err)
{
    ovr_result *result = ovr_result_open(file, NULL, err);
    size_t layers = b->layers, n = b->points;
    double unit = unit_of(p, b);
    ovr_status status = result ? check_file(result, file, p, b, err) : OVR_IO;
    for (size_t m = 0; !status && m < STATE; m++) {
        char path[80];
        snprintf(path, sizeof path, "%s/%s", group_of(p, b), map_names[m][0]);
        for (size_t j = 0; !status && j < layers; j++) {
            double *to = b->kept + (STATE * j + m) * n;
            status = ovr_result_read(result, path, j, OVR_HERTZIAN, to, err);
            for (size_t i = 0; !status && i < n; i++)
                to[i] /= unit;
        }
    }
    ovr_result_close(result);
    return status;
}
