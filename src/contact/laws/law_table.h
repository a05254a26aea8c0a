/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Table of a law (contact/oil.h): ln(eta/eta0) or rho/rho0 at pressures k h, k
 * = 0..cells, and one additional point that is never reached. */
#ifndef OVR_CONTACT_LAWS_LAW_TABLE_H
#define OVR_CONTACT_LAWS_LAW_TABLE_H

#include "base/arena.h"
#include "contact/oil.h"

struct ovr_law_table {
    size_t cells;
    double mesh;           /* h, Pa */
    double *value, *slope; /* y, h dy/dp */
    double ambient;        /* eta0 in Pa s, or rho0: value of the table at p = 0
                            */
    ovr_arena arena;
};

#endif
