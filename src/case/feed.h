/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A pass takes this from the one before. */
#ifndef OVR_CASE_FEED_H
#define OVR_CASE_FEED_H

#include "overroll/case.h"

/* True if passes are fed so: those of [passes], not of [plastic] alone. */
bool ovr_setup_carries_oil(const ovr_setup *setup);

/* Bodies that yield begin with the strains of that file, borrowed; nothing
 * where none does. */
void ovr_setup_go_on(ovr_setup *setup, const char *file);

/* Takes the place of the load: that of a pass, times its history. */
ovr_status ovr_setup_load(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err);

#endif
