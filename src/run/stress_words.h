/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stresses below a surface as reports tell them. */
#ifndef OVR_RUN_STRESS_WORDS_H
#define OVR_RUN_STRESS_WORDS_H

#include "run/lines.h"

void ovr_say_stress(const ovr_told *to, const ovr_stress_report *r,
                    const ovr_setup *setup);

#endif
