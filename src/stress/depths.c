/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "stress/depths.h"
#include "base/given.h"
#include "stress/layered.h"
#include "stress/stress.h"

#include <math.h>

/* Additional nodes for a shift, and minimum length of the transition between
 * lags. */
enum { SHIFT_CAPACITY = 2 << (OVR_STRESS_LEVELS - 1), MIN_SEAM = 128 };

ovr_stress_options ovr_stress_options_default(void)
{
    const ovr_stress_options defaults = {.from = -2.6,
                                         .to = 2.6,
                                         .depth_max = 2.5,
                                         .per_octave = 5,
                                         .element = OVR_ELEMENT_AUTO};
    return defaults;
}

static double minimum(const ovr_stress_options *o)
{
    return o->depth_min > 0 ? o->depth_min : 4 * o->mesh;
}

/* Inserts z into the sorted depths, if requested. */
static size_t insert_depth(const ovr_stress_options *o, double depth,
                           size_t count, double *z)
{
    size_t j = count;
    if (depth <= minimum(o) || depth >= o->depth_max)
        return count;
    for (; z && j > 0 && z[j - 1] > depth; j--)
        z[j] = z[j - 1];
    if (z)
        z[j] = depth;
    return count + 1;
}

/* Inserts both sides of each interface and some depths inside each layer. */
static size_t insert_layers(const ovr_stress_options *o, size_t count,
                            double *z)
{
    enum { INSIDE = 4 };
    double top = 0;
    for (int k = 0; o->layers && k < o->layers->layers; k++) {
        double bottom = ovr_layered_bottom(o->layers, k);
        for (int i = 1; i < INSIDE; i++)
            count = insert_depth(o, top + (bottom - top) * i / INSIDE * 1.0001,
                                 count, z);
        count = insert_depth(o, bottom * (1 - OVR_BESIDE), count, z);
        count = insert_depth(o, bottom * (1 + OVR_BESIDE), count, z);
        top = bottom;
    }
    return count;
}

size_t ovr_depths(const ovr_stress_options *o, double *z)
{
    double octaves = log2(o->depth_max / minimum(o));
    size_t count = 1 + (size_t)floor(octaves * o->per_octave + 1e-9);
    for (size_t j = 0; z && j < count; j++)
        z[j] = minimum(o) * exp2((double)j / o->per_octave);
    return insert_layers(o, count, z);
}

int ovr_depth_level(const ovr_stress_options *o, double z)
{
    int c = (int)floor(log2(z / (4 * o->mesh)) + 1e-9);
    return c < 0 ? 0 : c < OVR_STRESS_LEVELS ? c : OVR_STRESS_LEVELS - 1;
}

size_t ovr_stress_nodes(const ovr_stress_options *o)
{
    return (size_t)ceil((o->to - o->from) / o->mesh) + SHIFT_CAPACITY + 2;
}

size_t ovr_stress_capacity(const ovr_stress_options *o)
{
    size_t capacity = 256, target = o->nodes + ovr_stress_nodes(o) + MIN_SEAM;
    while (capacity < target)
        capacity *= 2;
    return capacity;
}

ovr_status ovr_stress_check(const ovr_stress_options *o, ovr_error *err)
{
    if (!(o->mesh > 0) || o->nodes < 2 || o->nodes > 1u << 26)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "stresses need a mesh size above 0 and 2 to 2^26 "
                        "nodes");
    if (!(o->to > o->from) || (o->to - o->from) / o->mesh > 1u << 26)
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "stresses from X = %g to %g: the lower limit must be below the "
            "upper limit",
            o->from, o->to);
    if (!(minimum(o) >= 0.5 * o->mesh * (1 - 1e-9)))
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "stress.depth_min = %g is less than D/2; set it to at least %g",
            o->depth_min, o->mesh / 2);
    if (!(o->depth_max >= minimum(o)) || !(o->depth_max <= 1000))
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "stress.depth_max = %g: must be between depth_min, %g, and 1000",
            o->depth_max, minimum(o));
    if (!(o->per_octave >= 1 && o->per_octave <= 100))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "depths_per_octave = %g: must be between 1 and 100",
                        o->per_octave);
    return OVR_OK;
}
