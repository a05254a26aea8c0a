/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Predicts the film thickness of rough surfaces before the solution by
 * amplitude reduction (surface/local_roughness.c).
 *
 * The part of the surface that passes the contact during the run is
 * Fourier-transformed, the amplitude of each wave is reduced, and the inverse
 * transform is the film thickness roughness s. Then
 *
 *     film_Rq = largest root mean square of s in a window
 *     H_min = smooth minimum film thickness - 0.75 max s
 *
 * The factor 0.75 represents the outlet constriction, where the waves of the
 * film are lower, long waves most. It is the mean of a dozen runs. In 20 other
 * runs, from which the stated errors follow, it was 0.55 to 0.87
 * (verify/rough_film_test.c).
 */
#include <math.h>

#include "base/arena.h"
#include "base/given.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/film_formula.h"
#include "overroll/run.h"
#include "physics/supply/supply.h"
#include "run/run.h"
#include "run/sliding_waves.h"
#include "surface/local_roughness.h"
#include "surface/surfaces.h"

/* Rough surface on a uniform grid. The samples before `first` and from `end` on
 * are needed for the amplitude reduction but do not pass the contact. */
typedef struct rolled {
    size_t n, first, end;
    double step;
    double *X, *z;
} rolled;

static const double LEAD = 8; /* in b; longer than the inlet */
static const double AT_EXIT = 0.75;
enum { MAX = 1 << 17, MIN_IN_WINDOW = 64 };

static bool slides(const ovr_setup *s)
{
    return fabs(s->contact->u1_ratio - s->contact->u2_ratio) > 1e-6;
}

/* Returns u/u_m of the rough surface; NAN if both are rough and their speeds
 * differ. */
static double speed(const ovr_setup *s)
{
    size_t n = ovr_surfaces_count(s->surfaces);
    double u = ovr_surfaces_info(s->surfaces, 0).speed;
    for (size_t k = 1; k < n; k++)
        if (fabs(ovr_surfaces_info(s->surfaces, k).speed - u) > 1e-6)
            return NAN;
    return u;
}

static ovr_film_fit smooth_film(const ovr_setup *s)
{
    return ovr_film_fitted(s->contact->M, s->contact->L,
                           ovr_density(s->lubricant, 1));
}

/* Distance in b that the rough surface moves during the run. */
static double distance(const ovr_setup *s)
{
    double end = s->march->end;
    if (!s->sliding)
        return speed(s) * ovr_history_integral(s->speed, end);
    return fabs(ovr_surfaces_centre(s->surfaces, 0, end) -
                ovr_surfaces_centre(s->surfaces, 0, 0));
}

static const char *refusal(const ovr_setup *s)
{
    const ovr_contact *c = s->contact;
    if (!s->transient)
        return "no feature moves through a steady contact";
    if (ovr_setup_lines(s) > 1)
        return "the film varies across rolling";
    if (isnan(speed(s)) || (s->sliding && ovr_surfaces_has(s->surfaces, 1) &&
                            ovr_surfaces_has(s->surfaces, 2)))
        return "the surfaces slide, and both are rough";
    if (!(speed(s) > 0))
        return "the rough surface does not move at the entrainment speed";
    if (ovr_setup_supply(s)->film)
        return "the formula is valid for a flooded inlet";
    if (!(c->M >= 2 && c->M <= 1000 && c->L >= 2 && c->L <= 25) ||
        isnan(smooth_film(s).minimum))
        return "the formula is valid for 2 <= M <= 1000, 2 <= L <= 25";
    return NULL;
}

/* Samples the surface at the end of the run, over the distance that passes the
 * contact. */
static ovr_status lay_out(const ovr_setup *s, ovr_arena *arena, rolled *r,
                          ovr_error *err)
{
    double from = -OVR_ROUGH_WINDOW - LEAD;
    double length = distance(s) + 2 * OVR_ROUGH_WINDOW + 2 * LEAD;
    r->step = fmin(s->mesh, OVR_ROUGH_WINDOW / MIN_IN_WINDOW);
    if (length > MAX * r->step)
        length = MAX * r->step;
    for (r->n = 64; (double)r->n * r->step < length;)
        r->n *= 2;
    r->X = ovr_arena_take(arena, r->n, sizeof *r->X, err);
    r->z = ovr_arena_take(arena, r->n, sizeof *r->z, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < r->n; i++)
        r->X[i] = from + (double)i * r->step;
    ovr_surfaces_heights(s->surfaces, s->march->end, r->n, r->X, r->z);
    r->first = (size_t)(LEAD / r->step);
    r->end = (size_t)((length - LEAD) / r->step);
    return OVR_OK;
}

/* Returns the maximum Rq over all windows. The oil moves at um, so that the
 * waves of a surface at u are longer in the film by the factor `stretch` =
 * um/u. */
static double largest_Rq(const rolled *r, double stretch)
{
    size_t width = (size_t)(2 * OVR_ROUGH_WINDOW / (r->step * stretch));
    double sum = 0, squares = 0, maximum = 0, n = (double)width;
    for (size_t i = r->first; i < r->end; i++) {
        double in = r->z[i], out = i < r->first + width ? 0 : r->z[i - width];
        sum += in - out;
        squares += in * in - out * out;
        if (i + 1 >= r->first + width)
            maximum = fmax(maximum, squares / n - sum / n * (sum / n));
    }
    return sqrt(maximum);
}

static double highest(const rolled *r)
{
    double maximum = 0;
    for (size_t i = r->first; i < r->end; i++)
        maximum = fmax(maximum, r->z[i]);
    return maximum;
}

/* Returns the range of predicted Rq over film_Rq_max of runs.  The fit has not
 * used these 110 single waves of 0.1 to 2 b. */
static const char *sliding_error(bool thins, bool is_faster)
{
    if (thins)
        return "the surfaces slide: Rq was predicted 0.5 to 1.4 times that of "
               "runs";
    return is_faster
               ? "the surfaces slide: Rq was predicted 0.8 to 1.3 times that "
                 "of runs"
               : "the surfaces slide: Rq was predicted 0.7 to 1.9 times that "
                 "of runs";
}

static const char *reservation(const ovr_setup *s, const ovr_rough_film *film)
{
    size_t n = ovr_surfaces_count(s->surfaces);
    if (isnan(film->H_min))
        return "the remaining roughness is as high as the film thickness";
    if (slides(s))
        return sliding_error(s->lubricant->rheology != OVR_NEWTONIAN,
                             speed(s) > 1);
    if (s->sliding)
        return "the sliding speed varies";
    if (ovr_history_varies(s->load) || ovr_history_varies(s->speed) ||
        ovr_history_varies(s->radius) || s->passes->loads.count)
        return "load, speed or radius vary; the prediction is for the "
               "reference contact";
    for (size_t k = 0; k < n; k++)
        if (!(ovr_surfaces_info(s->surfaces, k).Rq > 0))
            return "the theory describes waves, not single features";
    return NULL;
}

static ovr_status predict(const ovr_setup *s, ovr_arena *arena,
                          ovr_rough_film *film, ovr_error *err)
{
    const ovr_contact *c = s->contact;
    rolled r;
    ovr_sliding_waves sliding = {.smooth_Rq = 0};
    ovr_status status = lay_out(s, arena, &r, err);
    if (status)
        return status;
    film->Rq = largest_Rq(&r, 1);
    if (slides(s))
        status = ovr_sliding_waves_make(c, s->lubricant, smooth_film(s).central,
                                        speed(s), arena, &sliding, err);
    if (status)
        return status;
    ovr_waves_reduce(c->M, c->L, slides(s) ? &sliding.factors : NULL, r.step,
                     r.n, r.z);
    film->film_Rq = hypot(largest_Rq(&r, 1 / speed(s)), sliding.smooth_Rq);
    film->H_min = smooth_film(s).minimum - AT_EXIT * highest(&r);
    if (!(film->H_min > 0))
        film->H_min = NAN;
    film->but = reservation(s, film);
    return OVR_OK;
}

ovr_status ovr_setup_rough_film(const ovr_setup *setup,
                                const ovr_allocator *allocator,
                                ovr_rough_film *to, ovr_error *err)
{
    if (!setup)
        return ovr_fail_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_rough_film film = {.Rq = NAN,
                           .film_Rq = NAN,
                           .H_min = NAN,
                           .why = "the surfaces are smooth"};
    ovr_status status = ovr_check_output_argument(to, "ovr_rough_film", err);
    if (setup->surfaces)
        film.why = refusal(setup);
    if (!status && !film.why)
        status = predict(setup, &arena, &film, err);
    if (!status)
        *to = film;
    ovr_arena_release(&arena);
    return status;
}
