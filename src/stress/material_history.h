/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The history of the material: the insides. */
#ifndef OVR_STRESS_MATERIAL_HISTORY_H
#define OVR_STRESS_MATERIAL_HISTORY_H

#include "stress/circle.h"
#include "stress/field.h"
#include "stress/layered.h"
#include "stress/stress.h"
#include "stress/yield.h"

/* These rows are kept of the path of a material point at a depth. */
enum {
    OVR_ROW_HIGH,                                /* extents along u_m */
    OVR_ROW_LOW = OVR_HALF_DIRECTIONS,           /* and against it */
    OVR_ROW_VON_MISES = 2 * OVR_HALF_DIRECTIONS, /* squared */
    OVR_ROW_TRESCA,
    OVR_ROW_H_MAX,
    OVR_ROW_H_MIN,
    OVR_ROWS
};

/* The extremes of layers over a run: the largest von Mises stress of each,
 * shear and tension on interfaces, tension along the surface. */
typedef struct ovr_layer_extremes {
    ovr_stress_extreme von_mises[OVR_LAYERS_MAX];
    ovr_stress_extreme shear[OVR_LAYERS_MAX]; /* below each */
    ovr_stress_extreme tension, surface;
} ovr_layer_extremes;

/* Material points of a level lie at these places: xi = (first + k) 2^c D. */
typedef struct ovr_material_grid {
    long first;
    size_t points;
    double top; /* shallowest depth of the level; 0: it has none */
} ovr_material_grid;

/* Single numbers of the state. */
typedef struct ovr_material_history_numbers {
    double way[OVR_STRESS_LEVELS]; /* since the level's last moment */
    double widest;
    ovr_stress_extreme shear, von_mises; /* of squares */
} ovr_material_history_numbers;

struct ovr_material_history {
    ovr_arena arena;
    ovr_stress *stress;
    ovr_material_range range;
    /* of each layer, and of the body below them */
    ovr_state_constants constants[OVR_LAYERS_MAX + 1];
    float rest[OVR_LAYERS_MAX + 1][OVR_ROWS]; /* of material before all */
    ovr_material_grid grid[OVR_STRESS_LEVELS];
    int finest; /* level of the shallowest depth */
    long first; /* finest material points, without margins */
    size_t points;
    float **row; /* of a depth: OVR_ROWS times its points */
    float cosine[OVR_HALF_DIRECTIONS], sine[OVR_HALF_DIRECTIONS];
    float *smooth; /* OVR_ROWS of each depth */
    unsigned char *complete;
    ovr_material_history_numbers numbers;
    ovr_layer_extremes layers;
    ovr_stress_extreme strip; /* of pressure above that around it */
    ovr_pressure_sums sums;
    float *d, *tau, *h, *in_plane, *von_mises, *tresca; /* one depth's */
    ovr_memory_piece piece[7];
    size_t pieces;
};

/* Returns the extremes of a stress history with layers. */
ovr_layer_extremes ovr_material_history_layers(const ovr_material_history *p);

/* The layer of a depth, from 0; their number below them, or 0 without any. */
static inline int ovr_material_history_layer(const ovr_material_history *p,
                                             double z)
{
    const ovr_layered *layers = p->stress->options.layers;
    return layers ? ovr_layered_at(layers, z) : 0;
}

#endif
