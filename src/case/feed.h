/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The supply of a pass is what the one before left on the surfaces. */
#ifndef OVR_CASE_FEED_H
#define OVR_CASE_FEED_H

#include "overroll/case.h"
#include "surface/layer.h"

/* Takes the place of what the case says of the supply; the layers are the
 * setup's from now on.  `reservoir`: oil in the inlet reservoir, b^3/R. */
void ovr_setup_feed(ovr_setup *setup, ovr_layer *layer[2], double reservoir);

/* True if passes are fed so: those of [passes], not of [plastic] alone. */
bool ovr_setup_carries_oil(const ovr_setup *setup);

/* Bodies that yield begin with the strains of that file, borrowed; nothing
 * where none does. */
void ovr_setup_go_on(ovr_setup *setup, const char *file);

/* Takes the place of the load: that of a pass, times its history. */
ovr_status ovr_setup_load(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err);

/* rho H that arrives at the inlet at T. */
double ovr_setup_arriving(const ovr_setup *setup, double T);

#endif
