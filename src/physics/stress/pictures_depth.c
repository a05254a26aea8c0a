/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Stress field below a snapshot, drawn with about one cell per pixel: linear in
 * x between the nodes of each depth and linear in ln z between depths, up to
 * D/2; from there linear to the surface value -p, or with traction constant as
 * at D/2.
 */
#include "physics/stress/pictures_depth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/case.h"
#include "case/setup.h"
#include "physics/stress/stress.h"
#include "pictures/chart.h"
#include "stress/layered.h"
#include "stress/stress.h"

static const double min_meshes = 8, deepest = 2.5, shown = 1.5;

/* ----------------------------------------------------------------- creation */

/* Copies the residual stress table of the case, whose lifetime is that of its
 * setup. */
static void copy_residuals(ovr_depth_field *f, const ovr_stress_setup *s,
                           ovr_arena *arena)
{
    size_t n = s->residuals;
    double *z = n ? ovr_arena_take(arena, 2 * n, sizeof *z, NULL) : NULL;
    if (!z)
        return;
    memcpy(z, s->residual_z, n * sizeof *z);
    memcpy(z + n, s->residual_s, n * sizeof *z);
    f->residuals = n;
    f->residual_z = z;
    f->residual_s = z + n;
}

/* Reads the material of the body from the case of the run. */
static void read_body(ovr_depth_field *f, int surface, ovr_arena *arena)
{
    ovr_case *c;
    ovr_setup *setup = ovr_stored_setup(f->run, &c, NULL);
    f->poisson = 0.3;
    if (setup) {
        const ovr_coated *coated = ovr_setup_layers(setup, surface - 1);
        if (coated)
            f->coated = *coated;
        f->poisson = ovr_setup_stress(setup)->poisson[surface - 1];
        f->residual_x = ovr_setup_stress(setup)->residual_x;
        f->residual_y = ovr_setup_stress(setup)->residual_y;
        copy_residuals(f, ovr_setup_stress(setup), arena);
        f->shear = surface == 1 ? "shear_stress_1" : "shear_stress_2";
        if (ovr_setup_stress(setup)->traction &&
            ovr_result_find(f->run->result, f->shear))
            f->traction = surface == 1 ? setup->contact->kappa
                                       : -setup->contact->kappa;
    }
    ovr_setup_free(setup);
    ovr_case_free(c);
}

static ovr_status find_field(ovr_depth_field *f, const char *field,
                             ovr_error *err)
{
    f->name = field ? field : "max_shear";
    for (int k = 0; k < OVR_STRESS_FIELDS; k++)
        if (!strcmp(ovr_stress_field_name((ovr_stress_field)k), f->name)) {
            f->which = (ovr_stress_field)k;
            return OVR_OK;
        }
    return ovr_fail(err, OVR_BAD_INPUT,
                    "no stress '%s'; must be sigma_x, sigma_z, tau_xz, "
                    "sigma_y, von_mises, max_shear, tresca or hydrostatic",
                    f->name);
}

static double value_at(const ovr_depth_field *f, const ovr_stress_row *row,
                       size_t i)
{
    ovr_in_plane s = {(double)row->mean[2 * i], (double)row->shear[2 * i],
                      (double)row->shear[2 * i + 1]};
    const ovr_at_rest at = ovr_layered_rest(&f->options, &f->range, row->z);
    return ovr_stress_value(f->which, s, at.poisson, at.x, at.y);
}

/* Chooses nodes with the first spacing of the file, without those of patches
 * (refine), whose contribution is negligible at the depths shown. */
static ovr_status choose_nodes(ovr_depth_field *f, ovr_arena *arena,
                               ovr_error *err)
{
    const double *x = f->run->x;
    size_t n = f->run->info->nodes;
    double length = x[n - 1] - x[0];
    f->nodes = n;
    f->mesh = length / (double)(n - 1);
    if (fabs(x[1] - x[0] - f->mesh) < 1e-6 * f->mesh)
        return OVR_OK;
    f->nodes = (size_t)(length / (x[1] - x[0]) + 0.5) + 1;
    f->mesh = length / (double)(f->nodes - 1);
    f->even = ovr_arena_take(arena, f->nodes, sizeof *f->even, err);
    return f->even ? OVR_OK : OVR_NO_MEMORY;
}

/* Interpolates values linearly from the file's nodes to the chosen nodes, in
 * place. */
static void interpolate_to_even(const ovr_depth_field *f, double *values)
{
    const double *x = f->run->x;
    size_t last = f->run->info->nodes - 1, i = 0;
    for (size_t k = 0; f->even && k < f->nodes; k++) {
        double at = x[0] + (double)k * f->mesh;
        while (i + 2 <= last && x[i + 1] <= at)
            i++;
        f->even[k] = values[i] + (values[i + 1] - values[i]) * (at - x[i]) /
                                     (x[i + 1] - x[i]);
    }
    if (f->even)
        memcpy(values, f->even, f->nodes * sizeof *values);
}

static ovr_status read_loads(ovr_depth_field *f, size_t k, ovr_error *err)
{
    ovr_result *result = f->run->result;
    ovr_status status = ovr_result_snapshot(result, "pressure", k, OVR_HERTZIAN,
                                            f->P, err);
    if (!status)
        interpolate_to_even(f, f->P);
    if (status || f->traction == 0)
        return status;
    status = ovr_result_snapshot(result, f->shear, k, OVR_HERTZIAN, f->Q, err);
    for (size_t i = 0; i < f->run->info->nodes; i++)
        f->Q[i] *= f->traction;
    interpolate_to_even(f, f->Q);
    return status;
}

static ovr_stress_extreme find_worst(const ovr_depth_field *f)
{
    ovr_stress_extreme worst = {0, 0, 0, 0};
    for (size_t j = 0; j < ovr_stress_depths(f->stress, NULL); j++) {
        ovr_stress_row row = ovr_stress_at(f->stress, j);
        if (row.z < f->minimum * (1 - 1e-9))
            continue;
        for (size_t i = 0; i < row.count; i++) {
            double v = value_at(f, &row, i);
            double X = row.start + (double)i * row.step;
            if (fabs(v) > fabs(worst.value) && X >= f->x_from && X <= f->x_to)
                worst = (ovr_stress_extreme){v, X, row.z, 0};
        }
    }
    return worst;
}

ovr_status ovr_depth_field_solve(ovr_depth_field *f, size_t k, ovr_error *err)
{
    ovr_status status = read_loads(f, k, err);
    if (status)
        return status;
    ovr_stress_solve(f->stress, f->P, f->traction == 0 ? NULL : f->Q, 0,
                     OVR_STRESS_ALL_LEVELS);
    f->worst = find_worst(f);
    return OVR_OK;
}

/* The colour scale ends at the maximum of the run, limited to a multiple of the
 * maximum of a smooth contact. A single instant therefore does not determine
 * the scale. */
static ovr_status scan_snapshots(ovr_depth_field *f, ovr_error *err)
{
    const ovr_result_info *info = f->run->info;
    double maximum = 0;
    size_t step = 1 + info->snapshots / 64;
    for (size_t k = 0; k < info->snapshots; k += step) {
        if (ovr_depth_field_solve(f, k, err))
            return OVR_BAD_INPUT;
        maximum = fmax(maximum, fabs(f->worst.value));
        if (k == 0)
            f->smooth = fabs(f->worst.value);
    }
    f->high = ceil(20 * fmin(maximum, 2 * f->smooth)) / 20;
    return OVR_OK;
}

ovr_status ovr_depth_field_make(ovr_depth_field *f, const ovr_stored *run,
                                const ovr_depth_look *look, ovr_arena *arena,
                                ovr_error *err)
{
    const ovr_result_info *info = run->info;
    ovr_stress_options o = ovr_stress_options_default();
    *f = (ovr_depth_field){.run = run, .logarithmic = look->logarithmic};
    if (find_field(f, look->field, err))
        return OVR_BAD_INPUT;
    if (!run->pressure || info->nodes < 3)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the file contains no pressure; run the case with "
                        "pressure in output.fields");
    read_body(f, look->surface ? look->surface : 1, arena);
    if (choose_nodes(f, arena, err))
        return OVR_NO_MEMORY;
    f->minimum = min_meshes * f->mesh;
    f->x_from = isnan(look->x_from) ? -1.5 : look->x_from;
    f->x_to = isnan(look->x_to) ? 1.5 : look->x_to;
    f->z_to = look->logarithmic ? deepest : shown;
    o.mesh = f->mesh;
    o.inlet = run->x[0];
    o.nodes = f->nodes;
    o.from = f->x_from - 0.1;
    o.to = f->x_to + 0.1;
    o.depth_min = f->mesh / 2;
    o.depth_max = deepest;
    o.traction = f->traction != 0;
    if (f->coated.body.layers)
        o.layers = &f->coated.body;
    f->options = o;
    f->range = ovr_material_range_default();
    f->range.poisson = f->poisson;
    f->range.residual_x = f->residual_x;
    f->range.residual_y = f->residual_y;
    f->range.residuals = f->residuals;
    f->range.residual_z = f->residual_z;
    f->range.residual_s = f->residual_s;
    f->range.layer_residual = f->coated.residual;
    size_t capacity = f->nodes > info->nodes ? f->nodes : info->nodes;
    f->P = ovr_arena_take(arena, capacity, sizeof *f->P, err);
    f->Q = ovr_arena_take(arena, capacity, sizeof *f->Q, err);
    f->cells = ovr_arena_take(arena, (size_t)OVR_CELLS_X * OVR_CELLS_Z,
                              sizeof *f->cells, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    f->stress = ovr_stress_create(&o, &arena->allocator, err);
    return f->stress ? scan_snapshots(f, err) : OVR_BAD_INPUT;
}

void ovr_depth_field_free(ovr_depth_field *f)
{
    ovr_stress_free(f->stress);
    f->stress = NULL;
}

/* -------------------------------------------------------------------- cells */

static double along_row(const ovr_depth_field *f, size_t j, double X)
{
    ovr_stress_row row = ovr_stress_at(f->stress, j);
    double t = fmax((X - row.start) / row.step, 0);
    size_t i = (size_t)t;
    if (i + 2 > row.count)
        i = row.count - 2;
    double a = value_at(f, &row, i), b = value_at(f, &row, i + 1);
    return a + fmin(t - (double)i, 1) * (b - a);
}

/* Depth of a row of cells; row 0 is next to the surface. */
static double depth_of(const ovr_depth_field *f, double row)
{
    double part = row / OVR_CELLS_Z;
    if (!f->logarithmic)
        return part * f->z_to;
    return f->mesh * exp(part * log(f->z_to / f->mesh));
}

/* Stress at the surface: sigma_x = sigma_z = -p, no shear stress. */
static double at_surface(const ovr_depth_field *f, double X)
{
    ovr_stress_row row = ovr_stress_at(f->stress, 0);
    size_t i = (size_t)fmax((X - row.start) / row.step, 0);
    ovr_in_plane s = {(double)row.mean[2 * (i < row.count ? i : 0)], 0, 0};
    const ovr_at_rest at = ovr_layered_rest(&f->options, &f->range, 0);
    return ovr_stress_value(f->which, s, at.poisson, at.x, at.y);
}

double ovr_depth_field_at(const ovr_depth_field *f, double X, double z)
{
    const double *depth;
    size_t n = ovr_stress_depths(f->stress, &depth), j = 0;
    if (z < depth[0] && (f->traction != 0 || f->options.layers))
        return along_row(f, 0, X);
    if (z < depth[0]) {
        double top = at_surface(f, X);
        return top + z / depth[0] * (along_row(f, 0, X) - top);
    }
    while (j + 2 < n && depth[j + 1] <= z)
        j++;
    double t = fmin(log(z / depth[j]) / log(depth[j + 1] / depth[j]), 1);
    return (1 - t) * along_row(f, j, X) + t * along_row(f, j + 1, X);
}

static void fill_cells(ovr_depth_field *f)
{
    for (size_t r = 0; r < OVR_CELLS_Z; r++)
        for (size_t c = 0; c < OVR_CELLS_X; c++) {
            double X = f->x_from +
                       (f->x_to - f->x_from) * ((double)c + 0.5) / OVR_CELLS_X;
            f->cells[r * OVR_CELLS_X + c] = ovr_depth_field_at(
                f, X, depth_of(f, (double)r + 0.5));
        }
}

/* -------------------------------------------------------------------- panel */

static double drawn_depth(const ovr_depth_field *f, double z, double factor)
{
    return f->logarithmic ? log10(z * factor) : z * factor;
}

/* Contours every 0.1 or 0.2, and at the maximum of the smooth contact. */
static void write_contours(const ovr_depth_field *f, ovr_image *image,
                           char *thin, char *bold, size_t capacity)
{
    bool both = image->from < 0;
    double step = f->high > 0.6 ? 0.2 : 0.1;
    size_t used = 0;
    for (int k = both ? -6 : 1; k <= 12; k++)
        if (k != 0 && fabs(k * step) <= f->high)
            used += (size_t)snprintf(thin + used, capacity - used, "%s%.9g",
                                     used ? " " : "", k * step);
    snprintf(bold, capacity, both ? "%.9g -%.9g" : "%.9g", f->smooth,
             f->smooth);
    image->contours = thin;
    image->bold_contours = bold;
}

static void add_mark(ovr_panel *panel, ovr_arena *arena, double X, double z)
{
    if (X >= panel->x_from && X <= panel->x_to)
        ovr_panel_line(
            panel, arena, X, X, z, z,
            (ovr_series){
                .n = 1, .mark = OVR_MARK_CROSS, .colour = OVR_RED, .width = 3});
}

/* A line at a depth: dotted at the resolution limit of the mesh, otherwise at
 * an interface. */
static void add_line(ovr_panel *panel, ovr_arena *arena, double z,
                     ovr_mark mark)
{
    ovr_panel_line(
        panel, arena, panel->x_from, panel->x_to, z, z,
        (ovr_series){.mark = mark, .colour = OVR_WHITE, .width = 1.2});
}

bool ovr_depth_field_is_pressed(const ovr_depth_field *f)
{
    return f->which == OVR_STRESS_SIGMA_X || f->which == OVR_STRESS_SIGMA_Z ||
           f->which == OVR_STRESS_SIGMA_Y || f->which == OVR_STRESS_HYDROSTATIC;
}

/* Reverses the order of rows: image rows go upwards, starting at the greatest
 * depth. */
static void turn_over(double *cells)
{
    for (size_t r = 0; r < OVR_CELLS_Z / 2; r++)
        for (size_t c = 0; c < OVR_CELLS_X; c++) {
            double *low = &cells[r * OVR_CELLS_X + c];
            double *high = &cells[(OVR_CELLS_Z - 1 - r) * OVR_CELLS_X + c];
            double value = *low;
            *low = *high;
            *high = value;
        }
}

/* Label such as "normal stress, sigma_x (p_h)", with the markup of gnuplot. */
static void write_label(const ovr_depth_field *f, char *label, size_t capacity)
{
    static const char *const names[][2] = {
        {"max_shear", "maximum shear stress"},
        {"von_mises", "von Mises stress"},
        {"tresca", "Tresca stress"},
        {"hydrostatic", "hydrostatic stress"},
        {"sigma_x", "normal stress, {/Symbol s}_x"},
        {"sigma_y", "normal stress, {/Symbol s}_y"},
        {"sigma_z", "normal stress, {/Symbol s}_z"},
        {"tau_xz", "shear stress, {/Symbol t}_{xz}"}};
    const char *name = f->name;
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (!strcmp(f->name, names[k][0]))
            name = names[k][1];
    snprintf(label, capacity, "%s ({/:Italic p}_h)", name);
}

static ovr_image image_of(const ovr_depth_field *f, double worst,
                          const char *label)
{
    bool both = f->which == OVR_STRESS_TAU_XZ;
    bool pressed = ovr_depth_field_is_pressed(f);
    ovr_image image = {.nx = OVR_CELLS_X,
                       .ny = OVR_CELLS_Z,
                       .values = f->cells,
                       .from = both || pressed ? -f->high : 0,
                       .to = pressed ? 0 : f->high,
                       .label = label};
    image.above = fabs(worst) > f->high * (1 + 1e-9);
    return image;
}

/* Sets the axes. `x` and `buffer`, which contains the depth label, must outlive
 * the panel. */
static void set_axes(const ovr_depth_field *f, const ovr_axis *x, char *buffer,
                     size_t size, ovr_panel *panel)
{
    double top = f->logarithmic ? f->mesh : 0;
    snprintf(buffer, size, "%s, {/:Italic z} (%s)",
             f->logarithmic ? "log_{10} of depth" : "depth",
             *x->unit ? x->unit : "b");
    panel->x_label = x->label;
    panel->y_label = buffer;
    panel->x_from = f->x_from * x->factor;
    panel->x_to = f->x_to * x->factor;
    panel->y_from = drawn_depth(f, f->z_to, x->factor);
    panel->y_to = drawn_depth(f, top, x->factor);
    panel->height = 1.5;
}

ovr_status ovr_depth_field_panel(ovr_depth_field *f, ovr_units units,
                                 ovr_panel *panel, ovr_arena *arena,
                                 ovr_error *err)
{
    enum { CAPACITY = 400 };
    char *label = ovr_arena_take(arena, 80, 1, err);
    char *depth = ovr_arena_take(arena, 80, 1, err);
    char *levels = ovr_arena_take(arena, 2 * CAPACITY, 1, err);
    ovr_axis x;
    if (!label || !depth || !levels ||
        ovr_axis_make(OVR_KIND_LENGTH, f->run->result, units, f->x_to, &x, err))
        return OVR_BAD_INPUT;
    fill_cells(f);
    turn_over(f->cells);
    *panel = (ovr_panel){0};
    set_axes(f, &x, depth, 80, panel);
    write_label(f, label, 80);
    panel->image = image_of(f, f->worst.value, label);
    write_contours(f, &panel->image, levels, levels + CAPACITY, CAPACITY);
    add_line(panel, arena, drawn_depth(f, f->minimum, x.factor),
             OVR_MARK_DOTTED);
    for (int j = 0; j < f->coated.body.layers; j++) {
        double z = ovr_layered_bottom(&f->coated.body, j);
        if (z < f->z_to && !(f->logarithmic && z < f->mesh))
            add_line(panel, arena, drawn_depth(f, z, x.factor), OVR_MARK_LINE);
    }
    add_mark(panel, arena, f->worst.X * x.factor,
             drawn_depth(f, f->worst.Z, x.factor));
    return OVR_OK;
}
