/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A viscosity law defined by functions: evaluated for blocks of nodes, with any
 * dependence of eta. The film kernel uses it in place of the lubricant's law;
 * the remaining code makes no assumption about how eps depends on pressure or
 * film thickness. For laws with other arguments (temperature, sliding speed),
 * members are added.
 */
#ifndef OVR_CONTACT_LAWS_LAW_H
#define OVR_CONTACT_LAWS_LAW_H

#include <stddef.h>

/* Nodes in any order: arguments and results of the law. */
typedef struct ovr_law_nodes {
    size_t count;
    const double *P, *H;
    double *log2_fluidity; /* log2(1/eta) */
    double *by_pressure;   /* d ln eta/dP */
    double *by_film;       /* d ln eta/dH */
} ovr_law_nodes;

typedef struct ovr_law {
    void (*at)(const struct ovr_law *law, const ovr_law_nodes *nodes);
} ovr_law;

#endif
