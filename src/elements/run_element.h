/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conditions of a gear pair, cam or bearing, and warnings before and after its
 * run. */
#ifndef OVR_ELEMENTS_RUN_ELEMENT_H
#define OVR_ELEMENTS_RUN_ELEMENT_H

#include "overroll/run.h"

struct ovr_report_sink;

/* Prints what the reference contact of the element is, and that the load shares
 * of gears are blended, unless one position is solved. */
void ovr_report_element(const struct ovr_report_sink *to,
                        const ovr_setup *setup);

/* True if the run never has load, speeds and radius of the reference contact:
 * those of cams are extremes of different times. */
bool ovr_reference_is_scale(const ovr_setup *setup);

void ovr_review_element(const ovr_setup *setup, ovr_listener *say, void *data);

/* Warns according to the extremes of a run. */
void ovr_review_element_after(const ovr_setup *setup,
                              const ovr_statistics *total, ovr_listener *say,
                              void *data);

#endif
