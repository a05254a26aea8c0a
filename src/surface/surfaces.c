/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The two moving surfaces: where each feature is, and the sum of them all.
 *
 *     X_k(T) = start + (u_k/um) I(T),   I(T) = integral of Cu from 0 to T
 * or, with a history of the sliding, start + integral of Cu +- V/2
 *
 * Copies of a repeated feature follow it: they are on the side it comes from,
 * and on both sides when it stands still.
 */
#include "base/given.h"
#include "base/text.h"
#include "surface/feature.h"
#include "surface/local_roughness.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "contact/contact.h"
#include "contact/turning.h"
#include "surface/measured.h"
#include "surface/surfaces.h"

typedef struct entry {
    ovr_feature feature;
    struct entry *next;
} entry;

struct ovr_surfaces {
    ovr_arena arena;
    ovr_contact contact;
    const ovr_history *speed, *sliding;
    double mesh;
    double inlet, outlet; /* NAN: not known */
    size_t count;
    entry *first, **last;
};

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

/* How far a feature has come. */
static double moved(const ovr_surfaces *surfaces, const ovr_feature *f,
                    double T)
{
    if (f->ratio == 0 && !surfaces->sliding)
        return 0;
    return ovr_surface_way(surfaces->speed, surfaces->sliding, f->ratio,
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
                              "feature '%s': no shape has the number %d", name,
                              (int)form->shape);
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

/* Copies may overlap, but not so that thousands meet at one node. */
static ovr_status check_repeat(const ovr_feature *f, ovr_error *err)
{
    double size = f->reach_behind + f->reach_ahead;
    if (isnan(f->repeat))
        return OVR_OK;
    if (!isfinite(size))
        return ovr_fail_about(
            err, "repeat", "feature '%s': %s %s is endless, it needs no repeat",
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

/* Everything that can fail happens here, before the feature is linked in. */
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
    if (!status && (f->shape == OVR_PROFILE || f->shape == OVR_ROUGHNESS))
        status = ovr_measured_make(f, form, c, surfaces->mesh, &surfaces->arena,
                                   err);
    if (!status)
        status = check_repeat(f, err);
    if (!status)
        status = ovr_feature_place(
            f, form,
            isnan(form->arrival) ? 0 : moved(surfaces, f, form->arrival),
            surfaces->inlet, surfaces->outlet, err);
    return status;
}

ovr_status ovr_surfaces_add(ovr_surfaces *surfaces,
                            const ovr_feature_form *form, ovr_error *err)
{
    if (!surfaces)
        return ovr_fail_null(err, __func__);
    entry *added = ovr_arena_take(&surfaces->arena, 1, sizeof *added, err);
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

static double centre_at(const ovr_surfaces *surfaces, const ovr_feature *f,
                        double T)
{
    return f->start + moved(surfaces, f, T);
}

static double grown(const ovr_feature *f, double T)
{
    return isnan(f->grow) || T >= f->grow_from + f->grow
               ? 1
               : ovr_smoothstep((T - f->grow_from) / f->grow);
}

/* The copies k = low..high that touch [X_a, X_b]; copy k is at
 * centre - k * p. */
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

void ovr_surfaces_heights(void *data, double T, size_t n, const double *X,
                          double *S)
{
    if (!data || !S)
        return;
    const ovr_surfaces *surfaces = data;
    for (size_t i = 0; i < n; i++)
        S[i] = 0;
    for (const entry *l = surfaces->first; l && n; l = l->next) {
        double factor = grown(&l->feature, T);
        if (factor > 0)
            add_feature(&l->feature, factor,
                        centre_at(surfaces, &l->feature, T), n, X, S);
    }
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
    for (const entry *l = surfaces->first; l && n; l = l->next)
        if (l->feature.ratio == 0 && !surfaces->sliding)
            add_feature(&l->feature, 1, l->feature.start, n, X, S);
}

/* --------------------------------------------------- what is on them */

size_t ovr_surfaces_count(const ovr_surfaces *surfaces)
{
    if (!surfaces)
        return 0;
    return surfaces->count;
}

static const ovr_feature *nth(const ovr_surfaces *surfaces, size_t k)
{
    const entry *l = surfaces->first;
    while (l && k--)
        l = l->next;
    return l ? &l->feature : NULL;
}

static double amplitude(const ovr_feature *f)
{
    double most = fmax(fabs(f->A), f->shoulder);
    for (size_t i = 0; f->table && i < f->table->n; i++)
        most = fmax(most, fabs(f->table->z[i]));
    return most;
}

static double roughness(const ovr_feature *f)
{
    size_t n = f->table ? f->table->n : 0;
    double mean = 0, squares = 0;
    if (f->shape == OVR_WAVE || f->shape == OVR_CHIRP)
        return fabs(f->A) / sqrt(2);
    for (size_t i = 0; i < n; i++)
        mean += f->table->z[i] / (double)n;
    for (size_t i = 0; i < n; i++)
        squares += (f->table->z[i] - mean) * (f->table->z[i] - mean);
    return n ? sqrt(squares / (double)n) : 0;
}

static double local_roughness(const ovr_feature *f)
{
    double to = f->shape == OVR_CHIRP ? f->wavelength_end : f->wavelength;
    if (f->shape != OVR_WAVE && f->shape != OVR_CHIRP)
        return f->local_Rq;
    double a = ovr_local_roughness_of_wave(f->A, f->wavelength,
                                           OVR_CONTACT_WIDTH);
    double b = ovr_local_roughness_of_wave(f->A, to, OVR_CONTACT_WIDTH);
    return sqrt((a * a + b * b) / 2);
}

static double last_copy(const ovr_feature *f)
{
    if (isnan(f->repeat))
        return 0;
    return f->copies ? f->repeat * (double)(f->copies - 1) : INFINITY;
}

static ovr_feature_info info_of(const ovr_feature *f)
{
    return (ovr_feature_info){.name = f->name,
                              .surface = f->surface,
                              .shape = f->shape,
                              .speed = f->ratio,
                              .amplitude = amplitude(f),
                              .wavelength = f->finest,
                              .diameter = ovr_shape_diameter(f),
                              .behind = f->behind,
                              .ahead = f->ahead,
                              .grows = !isnan(f->grow) && f->grow > 0,
                              .Rq = roughness(f),
                              .last = last_copy(f),
                              .assumed = f->assumed};
}

ovr_feature_info ovr_surfaces_info(const ovr_surfaces *surfaces, size_t feature)
{
    const ovr_feature_info none = {.name = NULL, .assumed = ""};
    const ovr_feature *f = surfaces ? nth(surfaces, feature) : NULL;
    return f ? info_of(f) : none;
}

double ovr_surfaces_wavelength(const ovr_surfaces *surfaces)
{
    if (!surfaces)
        return NAN;
    double shortest = INFINITY;
    for (const entry *l = surfaces->first; l; l = l->next)
        shortest = fmin(shortest, l->feature.finest);
    return shortest;
}

/* Of what moves. */
static double slope(const ovr_feature *f)
{
    return f->ratio != 0 ? amplitude(f) / f->finest : -1;
}

double ovr_surfaces_speed(const ovr_surfaces *surfaces)
{
    if (!surfaces)
        return NAN;
    double most = -1, speed = NAN;
    if (surfaces->sliding) /* not one */
        return NAN;
    for (const entry *l = surfaces->first; l; l = l->next)
        if (slope(&l->feature) > most) {
            most = slope(&l->feature);
            speed = l->feature.ratio;
        }
    return speed;
}

double ovr_surfaces_roughness(const ovr_surfaces *surfaces)
{
    if (!surfaces)
        return NAN;
    double Rq = 0;
    for (const entry *l = surfaces->first; l; l = l->next)
        Rq = hypot(Rq, local_roughness(&l->feature));
    return Rq;
}

const char *ovr_surfaces_inside(const ovr_surfaces *surfaces, double inlet,
                                double outlet)
{
    if (!surfaces)
        return NULL;
    const double trace = 1e-9; /* one that begins at the end is outside */
    for (const entry *l = surfaces->first; l; l = l->next) {
        const ovr_feature *f = &l->feature;
        if (ovr_is_endless(f) || (f->grow > 0 && f->grow_from >= 0) ||
            f->ratio == 0)
            continue;
        if (f->start + f->ahead > inlet + trace &&
            f->start - f->behind < outlet - trace)
            return f->name;
    }
    return NULL;
}

double ovr_surfaces_centre(const ovr_surfaces *surfaces, size_t feature,
                           double T)
{
    if (!surfaces)
        return NAN;
    const ovr_feature *f = nth(surfaces, feature);
    return f ? centre_at(surfaces, f, T) : NAN;
}

/* Whether what has come may go back. */
static bool wanders(const ovr_surfaces *surfaces)
{
    return surfaces->sliding || ovr_history_turns(surfaces->speed);
}

/* The first T in [after, until] at which a feature has come as far as `far`,
 * where it may go back; to a twentieth of b/um, then by halving. */
static double wandering_time_of(const ovr_surfaces *surfaces,
                                const ovr_feature *f, double far, double after,
                                double until)
{
    const double step = 0.05;
    enum { MOST = 100000 };
    bool above = moved(surfaces, f, after) > far;
    double low = after;
    for (int k = 0; k < MOST && low < until; k++) {
        double high = fmin(low + step, until);
        if ((moved(surfaces, f, high) > far) == above) {
            low = high;
            continue;
        }
        for (int m = 0; m < 60; m++) {
            double middle = 0.5 * (low + high);
            if ((moved(surfaces, f, middle) > far) == above)
                low = middle;
            else
                high = middle;
        }
        return high;
    }
    return INFINITY;
}

/* T in [after, until] with I(T) = way: I does not decrease. */
static double time_of(const ovr_surfaces *surfaces, const ovr_feature *f,
                      double way, double after, double until)
{
    const ovr_history *speed = surfaces->speed;
    double low = after, high = until;
    if (wanders(surfaces))
        return wandering_time_of(surfaces, f, f->ratio * way, after, until);
    if (!speed)
        return way > after && way <= until ? way : INFINITY;
    if (!(ovr_history_integral(speed, low) < way) ||
        ovr_history_integral(speed, high) < way)
        return INFINITY;
    for (int k = 0; k < 200 && high - low > 1e-15 * high; k++) {
        double middle = low + 0.5 * (high - low);
        if (ovr_history_integral(speed, middle) < way)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* When all within `offset` of the centre has come to X. */
static double time_at(const ovr_surfaces *surfaces, const ovr_feature *f,
                      double offset, double X, double until)
{
    double far = X - f->start - offset, way = far / f->ratio;
    if (wanders(surfaces) && !isnan(far))
        return (f->back ? far >= 0 : far <= 0)
                   ? 0
                   : wandering_time_of(surfaces, f, far, 0, until);
    if (f->ratio == 0 || isnan(way))
        return INFINITY;
    return way <= 0 ? 0 : time_of(surfaces, f, way, 0, until);
}

ovr_feature_times ovr_surfaces_times(const ovr_surfaces *surfaces,
                                     size_t feature, double inlet,
                                     double outlet, double until)
{
    if (!surfaces)
        return (ovr_feature_times){0};
    const ovr_feature *f = nth(surfaces, feature);
    ovr_feature_times never = {INFINITY, INFINITY, INFINITY}, times;
    double first, last;
    bool back;
    if (!f)
        return never;
    back = f->back;
    first = back ? -f->behind : f->ahead;
    last = back ? f->ahead + last_copy(f) : -f->behind - last_copy(f);
    times.enters = time_at(surfaces, f, first, back ? outlet : inlet, until);
    times.centre = time_at(surfaces, f, 0, 0, until);
    times.leaves = time_at(surfaces, f, last, back ? inlet : outlet, until);
    return times;
}

/* Of the copies beside X, of which the film's turns bring either; all there
 * are if it is one. */
static double wandering_arrival(const ovr_surfaces *surfaces,
                                const ovr_feature *f, double X, double after,
                                double until)
{
    bool both = ovr_is_endless(f) && f->wavelength > 0;
    double p = both ? f->wavelength : f->back ? -f->repeat : f->repeat;
    double far = X - f->start, here = moved(surfaces, f, after), T = INFINITY;
    if (isnan(p))
        return wandering_time_of(surfaces, f, far, after, until);
    double next = floor((here - far) / p);
    for (double k = next - 1; k <= next + 2; k++)
        if (both || (k >= 0 && (!f->copies || k < (double)f->copies)))
            T = fmin(T,
                     wandering_time_of(surfaces, f, far + k * p, after, until));
    return T;
}

double ovr_surfaces_arrival(const ovr_surfaces *surfaces, size_t feature,
                            double X, double after, double until)
{
    if (!surfaces)
        return NAN;
    const ovr_feature *f = nth(surfaces, feature);
    double way, apart, k, gone;
    bool both;
    if (!f || f->ratio == 0)
        return INFINITY;
    if (ovr_history_turns(surfaces->speed))
        return wandering_arrival(surfaces, f, X, after, until);
    way = (X - f->start) / f->ratio;
    both = ovr_is_endless(f) && f->wavelength > 0;
    apart = (both ? f->wavelength : f->repeat) / fabs(f->ratio);
    gone = moved(surfaces, f, after) / f->ratio;
    if (apart > 0) { /* the first copy that has not gone by */
        k = floor((gone - way) / apart + 1e-9) + 1;
        if (!both && k < 0)
            k = 0;
        if (f->copies && k > (double)(f->copies - 1))
            return INFINITY;
        way += k * apart;
    }
    return time_of(surfaces, f, way, after, until);
}
