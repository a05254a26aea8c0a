/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The history of the material: the insides. */
#ifndef OVR_STRESS_PASSAGE_H
#define OVR_STRESS_PASSAGE_H

#include "stress/circle.h"
#include "stress/field.h"

/* What is kept of the path of a material point at a depth. */
enum {
    OVR_ROW_HIGH,                                /* extents along u_m */
    OVR_ROW_LOW = OVR_HALF_DIRECTIONS,           /* and against it */
    OVR_ROW_VON_MISES = 2 * OVR_HALF_DIRECTIONS, /* squared */
    OVR_ROW_TRESCA,
    OVR_ROW_H_MAX,
    OVR_ROW_H_MIN,
    OVR_ROWS
};

/* Where the material points of a level lie: xi = (first + k) 2^c D. */
typedef struct ovr_material_grid {
    long first;
    size_t points;
    double top; /* shallowest depth of the level; 0: it has none */
} ovr_material_grid;

/* Single numbers of the state. */
typedef struct ovr_passage_numbers {
    double way[OVR_STRESS_LEVELS]; /* since the level's last moment */
    double widest;
    ovr_stress_extreme shear, von_mises; /* of squares */
} ovr_passage_numbers;

struct ovr_passage {
    ovr_arena arena;
    ovr_stress *stress;
    ovr_material_range range;
    ovr_state_constants constants;
    ovr_material_grid grid[OVR_STRESS_LEVELS];
    int finest; /* level of the shallowest depth */
    long first; /* finest material points, without margins */
    size_t points;
    float **row; /* of a depth: OVR_ROWS times its points */
    float cosine[OVR_HALF_DIRECTIONS], sine[OVR_HALF_DIRECTIONS];
    float rest[OVR_ROWS]; /* of the material before all */
    float *smooth;        /* OVR_ROWS of each depth */
    unsigned char *complete;
    ovr_passage_numbers numbers;
    float *d, *tau, *h, *in_plane, *von_mises, *tresca; /* one depth's */
    ovr_memory_piece piece[4];
};

#endif
