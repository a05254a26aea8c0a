/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The two moving surfaces: positions of features and the sum of their heights.
 *
 *     X_k(T) = start + (u_k/um) I(T),   I(T) = integral of Cu from 0 to T
 * or, with a history of the sliding, start + integral of Cu +- V/2
 *
 * Copies of a repeated feature follow it upstream; a stationary feature has
 * copies on both sides.
 */
#include "surface/surfaces.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "base/text.h"
#include "contact/contact.h"
#include "contact/history.h"
#include "surface/feature.h"
#include "surface/features.h"
#include "surface/footprint.h"
#include "surface/measured.h"

/* -------------------------------------------------- position of a feature */

/* Finds where the centre is at T = 0. */

/* Finds where the centre is at T = 0 when the feature's reference point
 * (start), its centre, its leading edge or its arrival at X = 0 was given. */
static double centre_at_start(double distance, const ovr_feature_form *form,
                              const ovr_feature *f)
{
    bool tabulated = f->table || f->areal;
    if (!isnan(form->centre))
        return form->centre;
    if (!isnan(form->edge))
        return form->edge - f->ahead;
    if (!isnan(form->arrival))
        return -distance;
    return tabulated ? form->start - f->ahead : form->start;
}

/* Starts a feature just outside the film, on the side from which it enters. */
static ovr_status start_outside(ovr_feature *f, const ovr_feature_form *form,
                                double inlet, double outlet, ovr_error *err)
{
    const char *about = isnan(form->start) ? NULL : "start";
    if (isnan(inlet) || isnan(outlet))
        return ovr_fail_about(
            err, about,
            "feature '%s': %s %s needs its place at T = 0: start, "
            "centre or edge, or its arrival at X = 0",
            f->name, ovr_article(ovr_shape_name((int)f->shape)),
            ovr_shape_name((int)f->shape));
    if (f->ratio == 0)
        return ovr_fail_about(
            err, about,
            "feature '%s' cannot enter the contact, because surface %d does "
            "not move; set the X of its centre or edge",
            f->name, f->surface);
    f->start = !f->back ? inlet - f->ahead : outlet + f->behind;
    if (isfinite(f->start))
        return OVR_OK;
    return ovr_fail_about(err, about,
                          "feature '%s' has no end on its leading side; set "
                          "start to the X of its edge",
                          f->name);
}

/* Returns the key that gives the position; one of them if there are several. */
static const char *place_of(const ovr_feature_form *form)
{
    return !isnan(form->arrival)  ? "arrival"
           : !isnan(form->edge)   ? "edge"
           : !isnan(form->centre) ? "centre"
           : !isnan(form->start)  ? "start"
                                  : "origin";
}

/* Sets the position at T = 0 from start, centre, edge, arrival or origin;
 * without any of them the feature starts at the end of the film. `distance`:
 * distance that it moves until its arrival. The shape must be set. */
static ovr_status feature_place(ovr_feature *f, const ovr_feature_form *form,
                                double distance, double inlet, double outlet,
                                ovr_error *err)
{
    int given = !isnan(form->start) + !isnan(form->centre) +
                !isnan(form->edge) + !isnan(form->arrival);
    const char *shape = ovr_shape_name((int)f->shape);
    if (given > 1 || (given && !isnan(form->origin)))
        return ovr_fail_about(err, place_of(form),
                              "feature '%s': set only one of start, centre, "
                              "edge, arrival and origin",
                              f->name);
    if (ovr_is_endless(f)) {
        if (given)
            return ovr_fail_about(
                err, place_of(form),
                "feature '%s': %s %s is endless; set origin instead", f->name,
                ovr_article(shape), shape);
        f->start = isnan(form->origin) ? 0 : form->origin;
    } else if (!given || form->start == -INFINITY) {
        return start_outside(f, form, inlet, outlet, err);
    } else if (!isnan(form->arrival) && f->ratio == 0) {
        return ovr_fail_about(err, "arrival",
                              "feature '%s': never arrives, because surface "
                              "%d does not move; set start instead of arrival",
                              f->name, f->surface);
    } else {
        f->start = centre_at_start(distance, form, f);
    }
    if (!isfinite(f->start))
        return ovr_fail_about(err, place_of(form),
                              "feature '%s': its position must be a finite "
                              "number",
                              f->name);
    return OVR_OK;
}

ovr_feature_form ovr_feature_form_default(void)
{
    const ovr_feature_form defaults = {.name = "",
                                       .surface = 1,
                                       .shape = OVR_DENT,
                                       .start = NAN,
                                       .centre = NAN,
                                       .edge = NAN,
                                       .arrival = NAN,
                                       .origin = NAN,
#define NOT_GIVEN(name, help) .name = NAN,
                                       OVR_FEATURE_SIZES(NOT_GIVEN, NOT_GIVEN)
#undef NOT_GIVEN
                                           .width_across = NAN,
                                       .length_across = NAN,
                                       .wavelength_across = NAN,
                                       .grow = NAN,
                                       .grow_from = 0,
                                       .repeat = NAN,
                                       .copies = 0};
    return defaults;
}

ovr_surfaces *ovr_surfaces_create(const ovr_contact *contact,
                                  const ovr_history *speed, double mesh,
                                  const ovr_allocator *allocator,
                                  ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_contact of;
    ovr_surfaces *surfaces;
    if (OVR_TAKE(ovr_contact, &of, contact, err))
        return NULL;
    if (!(mesh > 0)) {
        ovr_fail(err, OVR_BAD_INPUT, "mesh = %g: must be positive", mesh);
        return NULL;
    }
    surfaces = ovr_arena_take(&arena, 1, sizeof *surfaces, err);
    if (!surfaces)
        return NULL;
    surfaces->contact = of;
    surfaces->speed = speed;
    surfaces->mesh = mesh;
    surfaces->inlet = surfaces->outlet = NAN;
    surfaces->last = &surfaces->first;
    surfaces->arena = arena;
    return surfaces;
}

void ovr_surfaces_sliding(ovr_surfaces *surfaces, const ovr_history *sliding)
{
    if (!surfaces)
        return;
    surfaces->sliding = sliding;
}

void ovr_surfaces_strip(ovr_surfaces *surfaces, double width, size_t lines)
{
    if (!surfaces)
        return;
    surfaces->width = width;
    surfaces->mesh_across = lines ? width / (double)lines : surfaces->mesh;
}

void ovr_surfaces_free(ovr_surfaces *surfaces)
{
    if (surfaces) {
        ovr_arena arena = surfaces->arena;
        ovr_arena_release(&arena);
    }
}

void ovr_surfaces_domain(ovr_surfaces *surfaces, double inlet, double outlet)
{
    if (!surfaces)
        return;
    surfaces->inlet = inlet;
    surfaces->outlet = outlet;
}

double ovr_feature_moved(const ovr_surfaces *surfaces, const ovr_feature *f,
                         double T)
{
    if (f->ratio == 0 && !surfaces->sliding)
        return 0;
    return ovr_surface_distance(surfaces->speed, surfaces->sliding, f->ratio,
                                f->surface, T);
}

/* ---------------------------------------------------------------- adding */

static ovr_status check_common(const ovr_feature_form *form, ovr_error *err)
{
    const char *name = form->name;
    if (form->surface != 1 && form->surface != 2)
        return ovr_fail_about(err, "surface",
                              "feature '%s': surface = %d must be 1 or 2", name,
                              form->surface);
    if (!ovr_shape_name((int)form->shape))
        return ovr_fail_about(err, "shape",
                              "feature '%s': %d is not the number of a shape",
                              name, (int)form->shape);
    if (!isnan(form->grow) && !(form->grow >= 0 && isfinite(form->grow)))
        return ovr_fail_about(err, "grow",
                              "feature '%s': grow = %g must be a time >= 0",
                              name, form->grow);
    if (!isfinite(form->grow_from))
        return ovr_fail_about(err, "grow_from",
                              "feature '%s': grow_from must be a finite time",
                              name);
    if (form->copies < 0)
        return ovr_fail_about(err, "copies",
                              "feature '%s': copies = %d must not be negative",
                              name, form->copies);
    return OVR_OK;
}

/* Checks the distance between copies: they may overlap, but not by thousands at
 * one node. */
static ovr_status check_repeat(const ovr_feature *f, ovr_error *err)
{
    double size = f->reach_behind + f->reach_ahead;
    if (isnan(f->repeat))
        return OVR_OK;
    if (!isfinite(size))
        return ovr_fail_about(
            err, "repeat", "feature '%s': %s %s is endless; remove repeat",
            f->name, ovr_article(ovr_shape_name((int)f->shape)),
            ovr_shape_name((int)f->shape));
    if (!isfinite(f->repeat) || !(f->repeat > size / 100))
        return ovr_fail_about(
            err, "repeat",
            "feature '%s': repeat = %g must be a distance above "
            "1/100 of its extent %g",
            f->name, f->repeat, size);
    return OVR_OK;
}

/* Creates the table of heights for shapes without a formula. */
static ovr_status make_table(ovr_surfaces *surfaces,
                             const ovr_feature_form *form, ovr_feature *f,
                             ovr_error *err)
{
    const ovr_contact *c = &surfaces->contact;
    ovr_arena *arena = &surfaces->arena;
    if (f->shape == OVR_AREAL && !(surfaces->width > 0))
        return ovr_fail_about(
            err, "shape",
            "feature '%s': an areal surface needs [strip]; in a line "
            "contact use shape = profile, one line of the surface",
            f->name);
    if (f->shape == OVR_AREAL ||
        (f->shape == OVR_ROUGHNESS && surfaces->width > 0)) {
        const ovr_strip_mesh mesh = {surfaces->mesh, surfaces->mesh_across,
                                     surfaces->width};
        return ovr_measured_areal(f, form, c, &mesh, arena, err);
    }
    if (f->shape == OVR_PROFILE || f->shape == OVR_ROUGHNESS)
        return ovr_measured_make(f, form, c, surfaces->mesh, arena, err);
    return OVR_OK;
}

/* Creates a feature. All errors are detected here, before the feature is
 * added. */
static ovr_status make(ovr_surfaces *surfaces, const ovr_feature_form *form,
                       ovr_feature *f, ovr_error *err)
{
    const ovr_contact *c = &surfaces->contact;
    ovr_status status = check_common(form, err);
    if (status)
        return status;
    f->name = ovr_arena_text(&surfaces->arena, form->name ? form->name : "",
                             err);
    if (!f->name)
        return OVR_NO_MEMORY;
    f->assumed = "";
    f->surface = form->surface;
    f->ratio = form->surface == 1 ? c->u1_ratio : c->u2_ratio;
    f->back = f->ratio != 0 &&
              (f->ratio < 0) != ovr_history_begins_backward(surfaces->speed);
    f->grow = form->grow;
    f->grow_from = form->grow_from;
    f->repeat = form->repeat;
    f->copies = form->copies;
    status = ovr_shape_make(f, form, c->height / c->b, err);
    if (!status)
        status = make_table(surfaces, form, f, err);
    if (!status)
        status = check_repeat(f, err);
    if (!status && surfaces->width > 0)
        status = ovr_footprint_make(f, form, surfaces->width, err);
    if (!status)
        status = feature_place(
            f, form,
            isnan(form->arrival)
                ? 0
                : ovr_feature_moved(surfaces, f, form->arrival),
            surfaces->inlet, surfaces->outlet, err);
    return status;
}

ovr_status ovr_surfaces_add(ovr_surfaces *surfaces,
                            const ovr_feature_form *form, ovr_error *err)
{
    if (!surfaces)
        return ovr_fail_null(err, __func__);
    ovr_placed_feature *added = ovr_arena_take(&surfaces->arena, 1,
                                               sizeof *added, err);
    ovr_feature_form own;
    ovr_status status;
    if (!added)
        return OVR_NO_MEMORY;
    status = OVR_TAKE(ovr_feature_form, &own, form, err);
    if (!status)
        status = make(surfaces, &own, &added->feature, err);
    if (status)
        return status;
    *surfaces->last = added;
    surfaces->last = &added->next;
    surfaces->count++;
    return OVR_OK;
}

/* ------------------------------------------------------------ evaluation */

static double grown(const ovr_feature *f, double T)
{
    return isnan(f->grow) || T >= f->grow_from + f->grow
               ? 1
               : ovr_smoothstep((T - f->grow_from) / f->grow);
}

/* Returns the copies k = low..high that overlap [X_a, X_b]; copy k is centred
 * at centre - k p. */
static void copies_within(const ovr_feature *f, double centre, double X_a,
                          double X_b, double *low, double *high)
{
    double p = f->back ? -f->repeat : f->repeat;
    double one = (centre - f->reach_behind - X_b) / p;
    double other = (centre + f->reach_ahead - X_a) / p;
    *low = ceil(fmin(one, other));
    *high = floor(fmax(one, other));
    if (f->ratio != 0 || f->copies)
        *low = fmax(*low, 0);
    if (f->copies)
        *high = fmin(*high, (double)(f->copies - 1));
}

static void add_feature(const ovr_feature *f, double factor, double centre,
                        size_t n, const double *X, double *S)
{
    double low = 0, high = 0, p = f->back ? -f->repeat : f->repeat;
    if (isnan(f->repeat)) {
        ovr_shape_add(f, factor, centre, n, X, S);
        return;
    }
    copies_within(f, centre, X[0], X[n - 1], &low, &high);
    for (double k = low; k <= high; k++)
        ovr_shape_add(f, factor, centre - k * p, n, X, S);
}

/* Computes S of surface 1 or 2, or of both (0). */
static void heights_of(const ovr_surfaces *surfaces, int surface, double T,
                       size_t n, const double *X, double *S)
{
    for (size_t i = 0; i < n; i++)
        S[i] = 0;
    for (const ovr_placed_feature *l = surfaces->first; l && n; l = l->next) {
        double factor = grown(&l->feature, T);
        if (factor > 0 && (!surface || l->feature.surface == surface))
            add_feature(&l->feature, factor,
                        ovr_feature_centre(surfaces, &l->feature, T), n, X, S);
    }
}

static void add_across(const ovr_feature *f, double factor, double centre,
                       const ovr_places *at, double *S)
{
    double low = 0, high = 0, p = f->back ? -f->repeat : f->repeat;
    bool once = isnan(f->repeat) || ovr_footprint_repeats(f);
    if (!once)
        copies_within(f, centre, at->X[0], at->X[at->n - 1], &low, &high);
    for (double k = low; k <= high; k++)
        ovr_footprint_add(f, factor, once ? centre : centre - k * p, at, S);
}

void ovr_surfaces_across(void *data, int surface, double T, size_t n,
                         const double *X, size_t lines, const double *Y,
                         size_t stride, double *S)
{
    const ovr_surfaces *surfaces = data;
    const ovr_places at = {n, lines, stride, X, Y, surfaces->width};
    for (size_t i = 0; i < n; i++)
        memset(S + i * stride, 0, lines * sizeof *S);
    for (const ovr_placed_feature *l = surfaces->first; l && n; l = l->next) {
        double factor = grown(&l->feature, T);
        if (factor > 0 && (!surface || l->feature.surface == surface))
            add_across(&l->feature, factor,
                       ovr_feature_centre(surfaces, &l->feature, T), &at, S);
    }
}

void ovr_surfaces_heights(void *data, double T, size_t n, const double *X,
                          double *S)
{
    if (data && S)
        heights_of(data, 0, T, n, X, S);
}

void ovr_surfaces_heights_1(void *data, double T, size_t n, const double *X,
                            double *S)
{
    if (data && S)
        heights_of(data, 1, T, n, X, S);
}

void ovr_surfaces_heights_2(void *data, double T, size_t n, const double *X,
                            double *S)
{
    if (data && S)
        heights_of(data, 2, T, n, X, S);
}

bool ovr_surfaces_has(const ovr_surfaces *surfaces, int surface)
{
    for (const ovr_placed_feature *l = surfaces->first; l; l = l->next)
        if (l->feature.surface == surface)
            return true;
    return false;
}

void ovr_surfaces_standing(void *data, double T, size_t n, const double *X,
                           double *S)
{
    if (!data || !S)
        return;
    const ovr_surfaces *surfaces = data;
    (void)T;
    for (size_t i = 0; i < n; i++)
        S[i] = 0;
    for (const ovr_placed_feature *l = surfaces->first; l && n; l = l->next)
        if (l->feature.ratio == 0 && !surfaces->sliding)
            add_feature(&l->feature, 1, l->feature.start, n, X, S);
}
