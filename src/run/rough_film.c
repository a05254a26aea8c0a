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
 *
 * Waves of surfaces that slide are reduced by the factors of sliding_waves.c.
 * Surfaces of different speeds, and the film of smooth surfaces, contribute to
 * film_Rq in squares.  reference/film_waves_slow_test.c has the errors.
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

/* A rough surface, or both at the same speed, on a uniform grid. The samples
 * before `first` and from `end` on are needed for the amplitude reduction but
 * do not pass the contact. */
typedef struct rolled {
    int surface; /* 1, 2; 0: both */
    size_t n, first, end;
    double step;
    double *X, *z;
} rolled;

static const double LEAD = 8; /* in b; longer than the inlet */
static const double AT_EXIT = 0.75;
/* Waves for whose flattening p_h is not large are not small. */
static const double STEEP = 0.15;
enum { MAX = 1 << 17, MIN_IN_WINDOW = 64 };

static bool slides(const ovr_setup *s)
{
    return fabs(s->contact->u1_ratio - s->contact->u2_ratio) > 1e-6;
}

static double speed(const ovr_setup *s, int surface)
{
    return surface == 2 ? s->contact->u2_ratio : s->contact->u1_ratio;
}

static ovr_film_fit smooth_film(const ovr_setup *s)
{
    return ovr_film_fitted(s->contact->M, s->contact->L,
                           ovr_density(s->lubricant, 1));
}

/* Distance in b that the rough surface moves during the run. */
static double distance(const ovr_setup *s, int surface)
{
    double end = s->march->end;
    if (!s->sliding)
        return speed(s, surface) * ovr_history_integral(s->speed, end);
    size_t k = 0, n = ovr_surfaces_count(s->surfaces);
    while (k + 1 < n && ovr_surfaces_info(s->surfaces, k).surface != surface)
        k++;
    return fabs(ovr_surfaces_centre(s->surfaces, k, end) -
                ovr_surfaces_centre(s->surfaces, k, 0));
}

static const char *refusal(const ovr_setup *s)
{
    const ovr_contact *c = s->contact;
    double slowest = INFINITY;
    for (int k = 1; k <= 2; k++)
        if (ovr_surfaces_has(s->surfaces, k))
            slowest = fmin(slowest, speed(s, k));
    if (ovr_setup_lines(s) > 1)
        return "the film varies across rolling";
    if (!s->transient && slowest > 0)
        return "no feature moves through a steady contact";
    if (slowest < 0)
        return "a rough surface moves against the entrainment speed";
    if (ovr_setup_supply(s)->film)
        return "the formula is valid for a flooded inlet";
    if (!(c->M >= 2 && c->M <= 1000 && c->L >= 2 && c->L <= 25) ||
        isnan(smooth_film(s).minimum))
        return "the formula is valid for 2 <= M <= 1000, 2 <= L <= 25";
    return NULL;
}

static void heights(const ovr_setup *s, int surface, size_t n, const double *X,
                    double *z)
{
    double T = s->transient ? s->march->end : 0;
    if (surface == 1)
        ovr_surfaces_heights_1(s->surfaces, T, n, X, z);
    else if (surface == 2)
        ovr_surfaces_heights_2(s->surfaces, T, n, X, z);
    else
        ovr_surfaces_heights(s->surfaces, T, n, X, z);
}

/* Samples the surface at the end of the run, over the distance that passes the
 * contact. */
static ovr_status lay_out(const ovr_setup *s, double passes, ovr_arena *arena,
                          rolled *r, ovr_error *err)
{
    double from = -OVR_ROUGH_WINDOW - LEAD;
    double length = passes + 2 * OVR_ROUGH_WINDOW + 2 * LEAD;
    r->step = fmin(s->mesh, OVR_ROUGH_WINDOW / MIN_IN_WINDOW);
    /* On fine grids every few nodes are sampled, so that windows fit. */
    r->step = fmax(r->step, (4 * LEAD + 8) / MAX);
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
    heights(s, r->surface, r->n, r->X, r->z);
    r->first = (size_t)(LEAD / r->step);
    r->end = (size_t)((length - LEAD) / r->step);
    return OVR_OK;
}

/* Returns the maximum Rq over all windows. The oil moves at um, so that the
 * waves of a surface are longer in the film by the factor `stretch`. */
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

/* Returns the amplitude of the slope of a wave with the same mean square. */
static double steepness(const rolled *r)
{
    double squares = 0;
    for (size_t i = r->first; i + 1 < r->end; i++) {
        double slope = (r->z[i + 1] - r->z[i]) / r->step;
        squares += slope * slope;
    }
    return sqrt(2 * squares / (double)(r->end - r->first));
}

static double highest(const rolled *r)
{
    double maximum = 0;
    for (size_t i = r->first; i < r->end; i++)
        maximum = fmax(maximum, r->z[i]);
    return maximum;
}

/* Returns the measured accuracy of the prediction.  The steepness of the rough
 * surfaces is the amplitude of the pressure that flattens a wave, p_h. */
static const char *sliding_error(const ovr_setup *s, double steepness)
{
    if (steepness > STEEP)
        return "the surfaces slide and are steep: Rq was predicted 0.2 to 5 "
               "times that of runs";
    if (s->lubricant->rheology != OVR_NEWTONIAN)
        return "the surfaces slide: Rq was predicted 0.25 to 1.4 times that of "
               "runs or within 0.02 of the film thickness";
    return "the surfaces slide: Rq was predicted 0.6 to 1.4 times that of runs "
           "or within 0.02 of the film thickness";
}

static const char *reservation(const ovr_setup *s, double steepness,
                               const ovr_rough_film *film)
{
    size_t n = ovr_surfaces_count(s->surfaces);
    if (isnan(film->H_min))
        return "the remaining roughness is as high as the film thickness";
    for (size_t k = 0; k < n; k++)
        if (!(ovr_surfaces_info(s->surfaces, k).Rq > 0))
            return "the theory describes waves, not single features";
    if (s->sliding)
        return "the sliding speed varies";
    if (s->transient &&
        (ovr_history_varies(s->load) || ovr_history_varies(s->speed) ||
         ovr_history_varies(s->radius) || s->passes->loads.count))
        return "load, speed or radius vary; the prediction is for the "
               "reference contact";
    if (slides(s))
        return sliding_error(s, steepness);
    const ovr_contact *c = s->contact;
    return c->M >= 20 && c->M <= 200 && c->L >= 4 && c->L <= 14
               ? NULL
               : "M or L is outside 20 to 200, 4 to 14: Rq was predicted 0.6 "
                 "to 1.4 times that of runs";
}

/* State of a prediction. */
typedef struct prediction {
    const ovr_setup *setup;
    double H; /* central film thickness of smooth surfaces */
    ovr_arena *arena;
    double steepness; /* combined steepness of all surfaces */
    ovr_rough_film film;
} prediction;

static ovr_status add_standing(prediction *to, int surface, ovr_error *err)
{
    const ovr_setup *s = to->setup;
    rolled r = {.surface = surface};
    ovr_standing_film standing;
    ovr_status status = lay_out(s, 0, to->arena, &r, err);
    double *turned = ovr_arena_take(to->arena, r.n, sizeof *turned, err);
    if (status || !turned)
        return OVR_NO_MEMORY;
    to->film.Rq = hypot(to->film.Rq, largest_Rq(&r, 1));
    to->steepness += steepness(&r);
    ovr_waves_turn(r.n, r.z, turned);
    status = ovr_standing_film_make(s->contact, s->lubricant, to->H,
                                    &(ovr_still){r.X[0], r.step, r.z, turned},
                                    to->arena, &standing, err);
    if (status)
        return status;
    to->film.film_Rq = hypot(to->film.film_Rq, standing.Rq);
    to->film.H_min += standing.lowest;
    return OVR_OK;
}

/* Surface 0: both, at the same speed. */
static ovr_status add_moving(prediction *to, int surface, ovr_error *err)
{
    const ovr_setup *s = to->setup;
    const ovr_contact *c = s->contact;
    rolled r = {.surface = surface};
    double u = speed(s, surface);
    ovr_wave_factors sliding;
    ovr_status status = lay_out(s, distance(s, surface), to->arena, &r, err);
    if (status)
        return status;
    to->film.Rq = hypot(to->film.Rq, largest_Rq(&r, 1));
    to->steepness += steepness(&r);
    if (slides(s))
        status = ovr_sliding_waves_make(c, s->lubricant, to->H, u, to->arena,
                                        &sliding, err);
    if (status)
        return status;
    ovr_waves_reduce(c->M, c->L, slides(s) ? &sliding : NULL, r.step, r.n, r.z);
    to->film.film_Rq = hypot(to->film.film_Rq,
                             largest_Rq(&r, ovr_film_wave_stretch(u)));
    to->film.H_min -= AT_EXIT * highest(&r);
    return OVR_OK;
}

/* The waves of surfaces at different speeds are independent. */
static ovr_status predict(prediction *to, ovr_error *err)
{
    const ovr_setup *s = to->setup;
    bool rough[] = {ovr_surfaces_has(s->surfaces, 1),
                    ovr_surfaces_has(s->surfaces, 2)};
    bool together = rough[0] && rough[1] && !slides(s);
    ovr_film_fit fit = smooth_film(s);
    ovr_smooth_film smooth;
    ovr_status status = ovr_smooth_film_make(
        s->contact, s->lubricant, fit.central, to->arena, &smooth, err);
    if (status)
        return status;
    to->H = fit.central * smooth.ratio;
    to->film.Rq = 0;
    to->film.film_Rq = smooth.Rq;
    to->film.H_min = fit.minimum * smooth.ratio;
    for (int k = 1; k <= 2 && !status; k++)
        if (rough[k - 1] && !(together && k == 2))
            status = speed(s, k) > 0 ? add_moving(to, together ? 0 : k, err)
                                     : add_standing(to, k, err);
    if (!(to->film.H_min > 0))
        to->film.H_min = NAN;
    to->film.but = reservation(s, to->steepness, &to->film);
    return status;
}

ovr_status ovr_setup_rough_film(const ovr_setup *setup,
                                const ovr_allocator *allocator,
                                ovr_rough_film *to, ovr_error *err)
{
    if (!setup)
        return ovr_fail_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    prediction p = {.setup = setup,
                    .arena = &arena,
                    .film = {.Rq = NAN,
                             .film_Rq = NAN,
                             .H_min = NAN,
                             .why = "the surfaces are smooth"}};
    ovr_status status = ovr_check_output_argument(to, "ovr_rough_film", err);
    if (setup->surfaces)
        p.film.why = refusal(setup);
    if (!status && !p.film.why)
        status = predict(&p, err);
    if (!status)
        *to = p.film;
    ovr_arena_release(&arena);
    return status;
}
