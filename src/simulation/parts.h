/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Refusing what does not go together (overroll/parts.h). */
#ifndef OVR_SIMULATION_PARTS_H
#define OVR_SIMULATION_PARTS_H

#include <stdbool.h>

#include "overroll/parts.h"
#include "overroll/simulation.h"

static inline unsigned ovr_part_bit(ovr_part part, bool on)
{
    return on ? 1U << part : 0;
}

/* Those of the options; order 4 where it is written. */
unsigned ovr_parts_of(const ovr_options *o);

/* The first pair of the table of which both are on, or NULL. */
const ovr_refusal *ovr_parts_conflict(unsigned on);

/* Fails with it, about its key. */
ovr_status ovr_parts_check(unsigned on, ovr_error *err);

#endif
