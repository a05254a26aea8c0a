/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that are possible and hardly meant. */
#ifndef OVR_RUN_REVIEW_PLAUSIBLE_H
#define OVR_RUN_REVIEW_PLAUSIBLE_H

#include "overroll/run.h"

/* Says each that lies outside of what is usual, with that range. */
void ovr_review_plausible(const ovr_setup *setup, ovr_listener *say,
                          void *data);

#endif
