/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/measured.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "surface/local_roughness.h"
#include "surface/profile.h"
#include "surface/resample.h"
#include "surface/surfaces.h"

/* --------------------------------------------------------- into b, b^2/R */

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

static ovr_profile *read(const ovr_feature_form *form, const ovr_contact *c,
                         const ovr_allocator *allocator, ovr_error *err)
{
    ovr_profile_source source;
    ovr_profile *p;
    if (!form->source) {
        ovr_fail(err, OVR_BAD_INPUT, "a profile needs its file: give file");
        return NULL;
    }
    if (OVR_TAKE(ovr_profile_source, &source, form->source, err))
        return NULL;
    source.spacing_scaled = !(c->b > 0);
    if (c->b > 0) {
        source.spacing *= c->b;
        source.y *= c->b;
        source.band *= c->b;
    }
    p = ovr_profile_read(&source, allocator, err);
    if (p && !to_contact(p, c, err))
        return p;
    ovr_profile_free(p);
    return NULL;
}

/* -------------------------------------------------------------- the table */

/* Mean wavelength from root mean square height and slope, 2 pi Rq/Rdq. */
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
    const char *ends = !t->endless ? "blended into the smooth surface"
                                   : "is endless";
    if (t->lost < 1e-6)
        ovr_profile_note(p, "on the grid: nothing filtered out; %s", ends);
    else
        ovr_profile_note(p,
                         "on the grid: wavelengths above %.3g b, %.2g %% of "
                         "the variance filtered out; %s",
                         2 * mesh, 100 * t->lost, ends);
}

static void set_extents(ovr_feature *f, const ovr_table *t)
{
    double half = ovr_table_length(t) / 2;
    f->A = 0; /* its heights are the table's */
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
}

/* As it was read and conditioned; roughness is as it was asked for. */
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
    set_extents(f, table);
    f->assumed = ovr_arena_text(arena, p->notes, err);
    return f->assumed ? OVR_OK : OVR_NO_MEMORY;
}

ovr_status ovr_measured_make(ovr_feature *feature, const ovr_feature_form *form,
                             const ovr_contact *contact, double mesh,
                             ovr_arena *arena, ovr_error *err)
{
    ovr_profile *p;
    ovr_status status;
    ovr_error local; /* the status is asked for even if the caller's is NULL */
    if (!(mesh > 0) || !isfinite(mesh))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "feature '%s': a profile needs the mesh size",
                        feature->name);
    if (!err)
        err = &local;
    p = ovr_measured_profile(form, contact, &arena->allocator, err);
    status = p ? fit(feature, form, p, mesh, arena, err) : err->status;
    if (status && !err->about && form->shape == OVR_PROFILE)
        err->about = "file"; /* what is wrong stands in it */
    ovr_profile_free(p);
    return status;
}
