/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal data of a stress history of the material. */
#ifndef OVR_STRESS_MATERIAL_HISTORY_H
#define OVR_STRESS_MATERIAL_HISTORY_H

#include "stress/circle.h"
#include "stress/field.h"
#include "stress/layered.h"
#include "stress/stress.h"
#include "stress/yield.h"

/* Rows stored for the paths of the material points at a depth. */
enum {
    OVR_ROW_HIGH,                      /* extents along u_m */
    OVR_ROW_LOW = OVR_HALF_DIRECTIONS, /* extents in the opposite directions */
    OVR_ROW_VON_MISES = 2 * OVR_HALF_DIRECTIONS, /* square of the stress */
    OVR_ROW_TRESCA,
    OVR_ROW_H_MAX,
    OVR_ROW_H_MIN,
    OVR_ROWS
};

/* Extremes in layers over a run: maximum von Mises stress of each, shear and
 * tension at interfaces, tension along the surface. */
typedef struct ovr_layer_extremes {
    ovr_stress_extreme von_mises[OVR_LAYERS_MAX];
    ovr_stress_extreme shear[OVR_LAYERS_MAX]; /* shear stress at the interface
                                                 below each layer */
    ovr_stress_extreme tension, surface;
} ovr_layer_extremes;

/* Positions of the material points of a level: xi = (first + k) 2^c D. */
typedef struct ovr_material_grid {
    long first;
    size_t points;
    double top; /* shallowest depth of the level; 0: it has none */
} ovr_material_grid;

/* Numbers of the state. */
typedef struct ovr_material_history_numbers {
    double distance[OVR_STRESS_LEVELS]; /* distance moved since the last time of
                                         * the level */
    double widest;
    ovr_stress_extreme shear, von_mises; /* extremes of squared stresses */
} ovr_material_history_numbers;

struct ovr_material_history {
    ovr_arena arena;
    ovr_stress *stress;
    ovr_material_range range;
    /* constants of each layer, and of the body below the layers */
    ovr_state_constants constants[OVR_LAYERS_MAX + 1];
    float rest[OVR_LAYERS_MAX + 1][OVR_ROWS]; /* values before the material has
                                               * been loaded */
    ovr_material_grid grid[OVR_STRESS_LEVELS];
    int finest; /* level of the shallowest depth */
    long first; /* first of the finest material points, without margins */
    size_t points;
    float **row; /* rows of a depth: OVR_ROWS values for each point */
    float cosine[OVR_HALF_DIRECTIONS], sine[OVR_HALF_DIRECTIONS];
    float *smooth; /* OVR_ROWS of each depth */
    unsigned char *complete;
    ovr_material_history_numbers numbers;
    ovr_layer_extremes layers;
    ovr_stress_extreme
        strip; /* largest excess of the mean pressure of a strip */
    ovr_pressure_sums sums;
    /* Stresses at one depth. */
    float *d, *tau, *h, *in_plane, *von_mises, *tresca;
    ovr_memory_piece piece[7];
    size_t pieces;
};

/* Returns the extremes of a stress history with layers. */
ovr_layer_extremes ovr_material_history_layers(const ovr_material_history *p);

/* Layer of a depth, counted from 0; the number of layers below them, or 0
 * without layers. */
static inline int ovr_material_history_layer(const ovr_material_history *p,
                                             double z)
{
    const ovr_layered *layers = p->stress->options.layers;
    return layers ? ovr_layered_at(layers, z) : 0;
}

#endif
