/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Returns heights, wavelengths, roughness and extents of the features. */
#include <math.h>

#include "surface/features.h"
#include "surface/local_roughness.h"
#include "surface/surfaces.h"

size_t ovr_surfaces_count(const ovr_surfaces *surfaces)
{
    if (!surfaces)
        return 0;
    return surfaces->count;
}

static double amplitude(const ovr_feature *f)
{
    double maximum = fmax(fabs(f->A), f->shoulder);
    for (size_t i = 0; f->table && i < f->table->n; i++)
        maximum = fmax(maximum, fabs(f->table->z[i]));
    return f->areal ? f->areal->largest : maximum;
}

/* Returns the maximum height above the smooth surface. */
static double maximum_height(const ovr_feature *f)
{
    bool both = f->shape == OVR_WAVE || f->shape == OVR_CHIRP;
    double maximum = fmax(both ? fabs(f->A) : f->A, f->shoulder);
    for (size_t i = 0; f->table && i < f->table->n; i++)
        maximum = fmax(maximum, f->table->z[i]);
    return f->areal ? f->areal->largest : fmax(maximum, 0);
}

static double roughness(const ovr_feature *f)
{
    size_t n = f->table ? f->table->n : 0;
    double mean = 0, squares = 0;
    if (f->shape == OVR_WAVE || f->shape == OVR_CHIRP)
        return fabs(f->A) / sqrt(2);
    if (f->areal)
        return f->areal->Sq;
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

/* True for an endless longitudinal feature of a strip. */
static bool is_uniform(const ovr_feature *f)
{
    const ovr_footprint *g = &f->footprint;
    return g->cosine == 0 && !g->round && isinf(g->length) &&
           isnan(g->wavelength);
}

static ovr_feature_info info_of(const ovr_feature *f)
{
    return (ovr_feature_info){
        .name = f->name,
        .surface = f->surface,
        .shape = f->shape,
        .speed = f->ratio,
        .amplitude = amplitude(f),
        .raised = maximum_height(f),
        .wavelength = f->finest,
        .wavelength_is = f->table || f->areal ? "mean" : "shortest",
        .diameter = ovr_shape_diameter(f),
        .behind = f->behind,
        .ahead = f->ahead,
        .grows = !isnan(f->grow) && f->grow > 0,
        .uniform = is_uniform(f),
        .Rq = roughness(f),
        .last = ovr_feature_last_copy(f),
        .assumed = f->assumed};
}

ovr_feature_info ovr_surfaces_info(const ovr_surfaces *surfaces, size_t feature)
{
    const ovr_feature_info none = {
        .name = NULL, .wavelength_is = "", .assumed = ""};
    const ovr_feature *f = surfaces ? ovr_surfaces_feature(surfaces, feature)
                                    : NULL;
    return f ? info_of(f) : none;
}

double ovr_surfaces_work(const ovr_surfaces *surfaces)
{
    double work = 0;
    for (size_t k = 0; k < ovr_surfaces_count(surfaces); k++)
        work += ovr_surfaces_feature(surfaces, k)->work;
    return work;
}

/* Returns height divided by wavelength of a moving feature; -1 if it does not
 * move. */
static double slope(const ovr_feature *f)
{
    return f->ratio != 0 ? amplitude(f) / f->finest : -1;
}

double ovr_surfaces_speed(const ovr_surfaces *surfaces)
{
    if (!surfaces)
        return NAN;
    double maximum = -1, speed = NAN;
    if (surfaces->sliding) /* sliding varies: not a single speed */
        return NAN;
    for (const ovr_placed_feature *l = surfaces->first; l; l = l->next)
        if (slope(&l->feature) > maximum) {
            maximum = slope(&l->feature);
            speed = l->feature.ratio;
        }
    return speed;
}

double ovr_surfaces_roughness(const ovr_surfaces *surfaces)
{
    if (!surfaces)
        return NAN;
    double Rq = 0;
    for (const ovr_placed_feature *l = surfaces->first; l; l = l->next)
        Rq = hypot(Rq, local_roughness(&l->feature));
    return Rq;
}

const char *ovr_surfaces_inside(const ovr_surfaces *surfaces, double inlet,
                                double outlet)
{
    if (!surfaces)
        return NULL;
    const double trace = 1e-9; /* a feature that starts at the boundary is
                                * outside */
    for (const ovr_placed_feature *l = surfaces->first; l; l = l->next) {
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
