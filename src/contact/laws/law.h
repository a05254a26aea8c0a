/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A law of viscosity that is an object: evaluated at blocks of nodes, whatever
 * eta depends on.  The film kernel takes it in place of the lubricant's own;
 * nothing behind it assumes how eps depends on pressure or film.  A law that
 * needs more of a node (temperature, sliding) gets it as further members.
 */
#ifndef OVR_CONTACT_LAWS_LAW_H
#define OVR_CONTACT_LAWS_LAW_H

#include <stddef.h>

/* Nodes in any order: what is known, and what the law says. */
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
