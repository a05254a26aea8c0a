/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/measured.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "surface/areal.h"
#include "surface/local_roughness.h"
#include "surface/profile.h"
#include "surface/resample.h"
#include "surface/surfaces.h"

/* ---------------------------------------------- conversion to b and b^2/R */

static void divide(double *a, size_t n, double by)
{
    for (size_t i = 0; i < n; i++)
        a[i] /= by;
}

static ovr_status to_contact(ovr_profile *p, const ovr_contact *c,
                             ovr_error *err)
{
    bool metres = !p->view.scaled_x || !p->view.scaled_z;
    if (metres && !(c->b > 0 && c->height > 0))
        return ovr_fail_at(
            err, OVR_BAD_INPUT, p->file, 0,
            "a profile in metres needs a contact with dimensions (set radius, "
            "modulus and alpha), or unit_x = b and unit_z = b^2/R");
    if (!p->view.scaled_x)
        divide(p->x, p->view.n, c->b);
    if (!p->view.scaled_z)
        divide(p->z, p->view.n, c->height);
    p->view.scaled_x = p->view.scaled_z = true;
    p->b = c->b > 0 ? c->b : 0;
    p->height = c->height > 0 ? c->height : 0;
    return ovr_profile_finish(p, p->view.n, err);
}

/* Copies the source of the form, with lengths in metres if b is known. */
static ovr_status source_of(const ovr_feature_form *form, const ovr_contact *c,
                            ovr_profile_source *source, ovr_error *err)
{
    if (!form->source)
        return ovr_fail(err, OVR_BAD_INPUT, "a profile needs a file; set file");
    if (OVR_TAKE(ovr_profile_source, source, form->source, err))
        return OVR_BAD_INPUT;
    source->spacing_scaled = !(c->b > 0);
    if (c->b > 0) {
        source->spacing *= c->b;
        source->spacing_across *= c->b;
        source->y *= c->b;
        source->band *= c->b;
    }
    return OVR_OK;
}

static ovr_profile *read(const ovr_feature_form *form, const ovr_contact *c,
                         const ovr_allocator *allocator, ovr_error *err)
{
    ovr_profile_source source;
    ovr_profile *p;
    if (source_of(form, c, &source, err))
        return NULL;
    p = ovr_profile_read(&source, allocator, err);
    if (p && !to_contact(p, c, err))
        return p;
    ovr_profile_free(p);
    return NULL;
}

/* ------------------------------------------------------------------ table */

/* Returns the mean wavelength 2 pi Rq/Rdq. */
static double mean_wavelength(const ovr_table *t)
{
    double height = 0, slope = 0;
    for (size_t i = 0; i + 1 < t->n; i++) {
        double d = (t->z[i + 1] - t->z[i]) / t->h;
        height += t->z[i] * t->z[i];
        slope += d * d;
    }
    return slope > 0 ? 6.283185307179586 * sqrt(height / slope) : INFINITY;
}

static void describe(ovr_profile *p, const ovr_table *t, double mesh)
{
    const char *ends = !t->endless ? "tapered to zero at both ends"
                                   : "is endless";
    if (t->lost < 1e-6)
        ovr_profile_note(p, "fully resolved by the grid; %s", ends);
    else
        ovr_profile_note(p,
                         "on the grid: wavelengths above %.3g b, without "
                         "%.2g %% of the variance; %s",
                         2 * mesh, 100 * t->lost, ends);
}

static void set_extents(ovr_feature *f, const ovr_profile *p,
                        const ovr_table *t)
{
    double half = ovr_table_length(t) / 2;
    f->A = 0; /* the table contains the heights */
    f->shoulder = 0;
    f->behind = f->ahead = half;
    f->reach_behind = t->endless ? INFINITY : half;
    f->reach_ahead = t->both ? INFINITY : half;
    if (t->endless)
        f->behind = INFINITY;
    if (t->both)
        f->ahead = INFINITY;
    f->finest = mean_wavelength(t);
    f->table = t;
    f->work = p->work + t->work;
}

/* Returns the profile as read and conditioned; roughness as specified. */
ovr_profile *ovr_measured_profile(const ovr_feature_form *form,
                                  const ovr_contact *contact,
                                  const ovr_allocator *allocator,
                                  ovr_error *err)
{
    const ovr_roughness none = ovr_roughness_default();
    bool random = form->shape == OVR_ROUGHNESS;
    ovr_conditioning how = ovr_conditioning_default();
    ovr_profile *p;
    if (form->conditioning &&
        OVR_TAKE(ovr_conditioning, &how, form->conditioning, err))
        return NULL;
    p = random ? ovr_profile_random(form->roughness ? form->roughness : &none,
                                    allocator, err)
               : read(form, contact, allocator, err);
    if (p && !random && ovr_profile_condition(p, &how, err)) {
        ovr_profile_free(p);
        return NULL;
    }
    return p;
}

static ovr_status fit(ovr_feature *f, const ovr_feature_form *form,
                      ovr_profile *p, double mesh, ovr_arena *arena,
                      ovr_error *err)
{
    ovr_table *table = ovr_arena_take(arena, 1, sizeof *table, err);
    ovr_conditioning how = ovr_conditioning_default();
    bool random = form->shape == OVR_ROUGHNESS;
    ovr_status status = table ? OVR_OK : OVR_NO_MEMORY;
    if (!status && form->conditioning)
        status = OVR_TAKE(ovr_conditioning, &how, form->conditioning, err);
    ovr_ends ends = {how.taper, how.extend, !isnan(form->origin), random};
    if (!status) {
        f->local_Rq = ovr_local_roughness(p->view.n, p->x, p->z,
                                          OVR_CONTACT_WIDTH);
        ovr_points points = {p->view.n, p->x, p->z};
        status = ovr_resample(&points, mesh, &ends, table, arena, err);
    }
    if (status)
        return status;
    describe(p, table, mesh);
    set_extents(f, p, table);
    f->assumed = ovr_arena_text(arena, p->notes, err);
    return f->assumed ? OVR_OK : OVR_NO_MEMORY;
}

ovr_status ovr_measured_make(ovr_feature *feature, const ovr_feature_form *form,
                             const ovr_contact *contact, double mesh,
                             ovr_arena *arena, ovr_error *err)
{
    ovr_profile *p;
    ovr_status status;
    ovr_error local; /* the status is needed even if the caller's `err` is
                      * NULL */
    if (!(mesh > 0) || !isfinite(mesh))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "feature '%s': a profile needs the mesh size",
                        feature->name);
    if (!err)
        err = &local;
    p = ovr_measured_profile(form, contact, &arena->allocator, err);
    status = p ? fit(feature, form, p, mesh, arena, err) : err->status;
    if (status && !err->about && form->shape == OVR_PROFILE)
        err->about = "file"; /* contains the error */
    ovr_profile_free(p);
    return status;
}

/* ---------------------------------------------------------- areal surfaces */

/* Converts a map to b and b^2/R. */
static ovr_status map_to_contact(ovr_areal *map, const ovr_contact *c,
                                 ovr_error *err)
{
    ovr_profile *p = map->owner;
    bool metres = !map->scaled_x || !map->scaled_z;
    if (metres && !(c->b > 0 && c->height > 0))
        return ovr_fail_at(
            err, OVR_BAD_INPUT, p->file, 0,
            "a map in metres needs a contact with dimensions (set radius, "
            "modulus and alpha), or unit_x = b and unit_z = b^2/R");
    if (!map->scaled_x) {
        map->dx /= c->b;
        map->dy /= c->b;
    }
    if (!map->scaled_z)
        divide(map->z, map->nx * map->ny, c->height);
    map->scaled_x = map->scaled_z = true;
    p->view.scaled_x = p->view.scaled_z = true;
    p->b = c->b > 0 ? c->b : 0;
    p->height = c->height > 0 ? c->height : 0;
    return OVR_OK;
}

static ovr_areal *read_map(const ovr_feature_form *form, const ovr_contact *c,
                           const ovr_conditioning *how,
                           const ovr_allocator *allocator, ovr_error *err)
{
    ovr_profile_source source;
    if (source_of(form, c, &source, err))
        return NULL;
    ovr_areal *map = ovr_areal_read(&source, allocator, err);
    if (map && !map_to_contact(map, c, err) &&
        !ovr_areal_condition(map, how, err))
        return map;
    ovr_areal_free(map);
    return NULL;
}

/* Returns the width after which `map` repeats; 0 if it does not. */
static double period_of(const ovr_areal *map, const ovr_conditioning *how)
{
    double width = (double)(map->ny - 1) * map->dy;
    double taper = isnan(how->taper_across) ? 0.05 * width : how->taper_across;
    if (how->extend_across == OVR_EXTEND_MIRROR)
        return 2 * width;
    return how->extend_across == OVR_EXTEND_PERIODIC ? width - taper : 0;
}

ovr_status ovr_areal_period(const ovr_feature_form *form,
                            const ovr_contact *contact,
                            const ovr_allocator *allocator, double *width,
                            ovr_error *err)
{
    ovr_conditioning how = *form->conditioning;
    how.level = OVR_LEVEL_NONE; /* only the size is needed */
    how.lambda_c = how.lambda_s = NAN;
    ovr_areal *map = read_map(form, contact, &how, allocator, err);
    if (!map)
        return OVR_BAD_INPUT;
    *width = period_of(map, &how);
    double whole = (double)(map->ny - 1) * map->dy;
    ovr_areal_free(map);
    if (*width >= 0.5 * whole || how.extend_across == OVR_EXTEND_NONE)
        return OVR_OK;
    return ovr_fail_about(err, "taper_across",
                          "taper_across = %g b must be at most half the width "
                          "of the map, %g b",
                          how.taper_across, whole);
}

/* Checks that the table repeats on the width of the strip, or fits into it.
 * Stretches it to a width given with few digits. */
static ovr_status close_across(const ovr_feature *f, ovr_areal_table *t,
                               double width, ovr_error *err)
{
    const double closes = 1e-4;
    double period = ovr_areal_extent(&t->y), k = width / period;
    if (!t->y.endless && period <= width * (1 + 1e-9))
        return OVR_OK;
    if (!t->y.endless)
        return ovr_fail_about(err, "to_across",
                              "feature '%s': a map %.6g b wide does not fit "
                              "into a strip %.6g b wide; set strip.width to at "
                              "least %.6g, or a window by from_across and "
                              "to_across",
                              f->name, period, width, period);
    if (k >= 1 - closes && fabs(k - round(k)) < closes * k) {
        t->y.h *= k / round(k);
        return OVR_OK;
    }
    double below = fmax(1, floor(k));
    return ovr_fail_about(err, "extend_across",
                          "feature '%s': a map with a period of %.6g b "
                          "across is not periodic in a strip %.6g b wide; set "
                          "strip.width to %.6g or %.6g, or extend_across = "
                          "none",
                          f->name, period, width, below * period,
                          (below + 1) * period);
}

/* Returns the root mean square of the local roughness of up to 32 rows. */
static double rows_roughness(const ovr_areal *map, double *x)
{
    enum { ROWS = 32 };
    size_t step = map->ny / ROWS + 1;
    double squares = 0, count = 0;
    for (size_t i = 0; i < map->nx; i++)
        x[i] = (double)i * map->dx;
    for (size_t j = 0; j < map->ny; j += step, count++) {
        double Rq = ovr_local_roughness(map->nx, x, map->z + j * map->nx,
                                        OVR_CONTACT_WIDTH);
        squares += Rq * Rq;
    }
    return sqrt(squares / count);
}

static void describe_map(const ovr_areal *map, const ovr_areal_table *t,
                         const ovr_strip_mesh *mesh)
{
    ovr_profile *p = map->owner;
    ovr_areal_numbers n;
    p->view.scaled_x = p->view.scaled_z = true;
    if (!ovr_areal_measure(map, &n, NULL)) {
        char Str[32] = "";
        if (!isnan(n.Str))
            snprintf(Str, sizeof Str, ", Str %.2g", n.Str);
        ovr_profile_note(p,
                         "%zu x %zu points, %s x %s: Sq %s, Sa %s, Ssk %.3g, "
                         "Sku %.3g%s",
                         map->nx, map->ny,
                         ovr_along(p, (double)(map->nx - 1) * map->dx).text,
                         ovr_along(p, (double)(map->ny - 1) * map->dy).text,
                         ovr_across(p, n.Sq).text, ovr_across(p, n.Sa).text,
                         n.Ssk, n.Sku, Str);
    }
    ovr_profile_note(p,
                     "on the grid: wavelengths above %.3g b along x and %.3g b "
                     "across, %.2g %% of the variance filtered out",
                     2 * mesh->D, 2 * mesh->Dy, 100 * t->lost);
}

/* Adds the name of the feature to a message. */
static ovr_status add_name(const ovr_feature *f, ovr_status status,
                           ovr_error *err)
{
    char text[OVR_MESSAGE_SIZE];
    const char *about = err->about;
    snprintf(text, sizeof text, "%s", err->message);
    ovr_fail_about(err, about, "feature '%s': %s", f->name, text);
    err->status = status;
    return status;
}

static ovr_status tabulate(ovr_feature *f, const ovr_feature_form *form,
                           const ovr_conditioning *how, const ovr_areal *map,
                           const ovr_strip_mesh *mesh, ovr_arena *arena,
                           ovr_error *err)
{
    ovr_areal_table *t = ovr_arena_take(arena, 1, sizeof *t, err);
    double *x = ovr_arena_take(arena, map->nx, sizeof *x, err);
    bool random = form->shape == OVR_ROUGHNESS;
    const ovr_areal_fit fit = {
        .mesh = {mesh->D, mesh->Dy},
        .taper = {how->taper, how->taper_across},
        .extend = {(int)how->extend,
                   random ? (int)OVR_EXTEND_PERIODIC : (int)how->extend_across},
        .both = !isnan(form->origin),
        .closed = random};
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    ovr_status status = ovr_areal_tabulate(map, &fit, t, arena, err);
    if (status)
        return add_name(f, status, err);
    status = close_across(f, t, mesh->width, err);
    if (status)
        return status;
    double half = ovr_areal_extent(&t->x) / 2;
    f->local_Rq = rows_roughness(map, x);
    f->A = f->shoulder = 0;
    f->behind = t->x.endless ? INFINITY : half;
    f->ahead = t->both ? INFINITY : half;
    f->reach_behind = f->behind;
    f->reach_ahead = f->ahead;
    f->finest = t->wavelength;
    f->areal = t;
    f->work = ((ovr_profile *)map->owner)->work + t->work +
              ovr_areal_measure_work(map);
    describe_map(map, t, mesh);
    return OVR_OK;
}

ovr_status ovr_measured_areal(ovr_feature *f, const ovr_feature_form *form,
                              const ovr_contact *contact,
                              const ovr_strip_mesh *mesh, ovr_arena *arena,
                              ovr_error *err)
{
    const ovr_roughness none = ovr_roughness_default();
    bool random = form->shape == OVR_ROUGHNESS;
    ovr_conditioning how = ovr_conditioning_default();
    ovr_status status = OVR_OK;
    ovr_error local;
    if (!err)
        err = &local;
    if (form->conditioning &&
        OVR_TAKE(ovr_conditioning, &how, form->conditioning, err))
        return OVR_BAD_INPUT;
    ovr_areal *map =
        random
            ? ovr_areal_random(form->roughness ? form->roughness : &none,
                               mesh->width, form->angle, &arena->allocator, err)
            : read_map(form, contact, &how, &arena->allocator, err);
    if (!map) {
        if (!err->about && !random)
            err->about = "file";
        return err->status ? err->status : OVR_BAD_INPUT;
    }
    status = tabulate(f, form, &how, map, mesh, arena, err);
    if (!status) {
        f->assumed = ovr_arena_text(arena, ((ovr_profile *)map->owner)->notes,
                                    err);
        status = f->assumed ? OVR_OK : OVR_NO_MEMORY;
    }
    if (status && !err->about && !random)
        err->about = "file";
    ovr_areal_free(map);
    return status;
}
