/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The features of both surfaces in the order in which they were added, and the
 * distance that each has moved. */
#ifndef OVR_SURFACE_FEATURES_H
#define OVR_SURFACE_FEATURES_H

#include <math.h>
#include <stddef.h>

#include "base/arena.h"
#include "contact/contact.h"
#include "overroll/surface.h"
#include "surface/feature.h"

typedef struct ovr_placed_feature {
    ovr_feature feature;
    struct ovr_placed_feature *next;
} ovr_placed_feature;

struct ovr_surfaces {
    ovr_arena arena;
    ovr_contact contact;
    const ovr_history *speed, *sliding;
    double mesh;
    double width;         /* width of a strip, b; 0: line contact */
    double mesh_across;   /* distance between the lines of a strip, b */
    double inlet, outlet; /* NAN: unknown */
    size_t count;
    ovr_placed_feature *first, **last;
};

/* Returns the k-th feature, or NULL. */
static inline const ovr_feature *
ovr_surfaces_feature(const ovr_surfaces *surfaces, size_t k)
{
    const ovr_placed_feature *l = surfaces->first;
    while (l && k--)
        l = l->next;
    return l ? &l->feature : NULL;
}

/* Returns the distance in b that a feature has moved between 0 and T. */
double ovr_feature_moved(const ovr_surfaces *surfaces,
                         const ovr_feature *feature, double T);

/* Returns X of the feature's centre. */
static inline double ovr_feature_centre(const ovr_surfaces *surfaces,
                                        const ovr_feature *feature, double T)
{
    return feature->start + ovr_feature_moved(surfaces, feature, T);
}

/* Returns the distance in b between a feature and its last copy: 0 without
 * copies, INFINITY if they are endless. */
static inline double ovr_feature_last_copy(const ovr_feature *feature)
{
    if (isnan(feature->repeat))
        return 0;
    return feature->copies ? feature->repeat * (double)(feature->copies - 1)
                           : INFINITY;
}

#endif
