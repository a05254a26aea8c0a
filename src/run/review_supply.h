/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of the oil that arrives. */
#ifndef OVR_RUN_REVIEW_SUPPLY_H
#define OVR_RUN_REVIEW_SUPPLY_H

#include "overroll/run.h"

/* Before the solve: more than a flooded contact takes, by the film formula. */
void ovr_review_supply(const ovr_setup *setup, ovr_listener *say, void *data);

/* After it: a film that begins too close to the inlet. */
void ovr_review_meniscus(const ovr_simulation *sim, ovr_listener *say,
                         void *data);

#endif
