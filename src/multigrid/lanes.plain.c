/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "multigrid/plain.h"

void ovr_pack_plain(const ovr_lanes *g, const double *from, double *to)
{
    memcpy(to, from, g->n * sizeof *to);
}

void ovr_unpack_plain(const ovr_lanes *g, const double *from, double *to)
{
    memcpy(to, from, g->n * sizeof *to);
}
