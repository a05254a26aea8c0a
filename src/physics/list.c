/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * All physics.  What one of them does after another is in this order: what the
 * bodies are made of; the side that the film comes from before all else; the
 * oil that is there before the temperatures of its film; patches over what all
 * others have found; stresses look on.
 */
#include "simulation/physics.h"

extern const ovr_physics ovr_physics_heat, ovr_physics_stress,
    ovr_physics_reversal, ovr_physics_fourth, ovr_physics_conserving,
    ovr_physics_patches, ovr_physics_coating, ovr_physics_boundary,
    ovr_physics_plastic, ovr_physics_strip;

const ovr_physics *const ovr_physics_list[] = {&ovr_physics_coating,
                                               &ovr_physics_boundary,
                                               &ovr_physics_reversal,
                                               &ovr_physics_fourth,
                                               &ovr_physics_conserving,
                                               &ovr_physics_heat,
                                               &ovr_physics_patches,
                                               &ovr_physics_stress,
                                               &ovr_physics_plastic,
                                               &ovr_physics_strip,
                                               NULL};
