/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Warnings about a gear pair, cam or bearing before and after its run. */
#ifndef OVR_ELEMENTS_RUN_ELEMENT_H
#define OVR_ELEMENTS_RUN_ELEMENT_H

#include "overroll/run.h"

void ovr_review_element(const ovr_setup *setup, ovr_listener *say, void *data);

/* Warns according to the extremes of a run. */
void ovr_review_element_after(const ovr_setup *setup,
                              const ovr_statistics *total, ovr_listener *say,
                              void *data);

#endif
