/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The list of all physical models. Functions of the models are called in this
 * order: materials of the bodies; orientation of the film; lubricant content
 * before temperatures; patches after all models that change the film; stresses
 * last.
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
