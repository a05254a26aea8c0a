/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A pass takes this from the one before. */
#ifndef OVR_CASE_FEED_H
#define OVR_CASE_FEED_H

#include "overroll/case.h"

/* Takes the place of the load: that of a pass, times its history. */
ovr_status ovr_setup_load(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err);

#endif
