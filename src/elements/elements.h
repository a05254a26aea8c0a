/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Machine elements: creation and queries within the library. */
#ifndef OVR_ELEMENTS_ELEMENTS_H
#define OVR_ELEMENTS_ELEMENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/elements.h"

/*
 * Returns Blok's flash temperature rise (K) for a half-elliptic pressure over
 * the width 2 b, friction coefficient mu, and thermal effusivities B = sqrt(k
 * rho c) in W s^(1/2)/(m2 K):
 *
 *     T = 1.1115 mu w |u1 - u2|/((B_1 sqrt u1 + B_2 sqrt u2) sqrt(2 b))
 *
 * Blok, Proc. Gen. Disc. Lubrication, IMechE, London 1937, vol. 2, p. 222; the
 * constant for the half ellipse is the maximum of its integral.
 */
double ovr_flash_temperature(const ovr_element_moment *moment, double b,
                             double mu, double B_1, double B_2);

/* Returns spur gears with 20 degrees and elastic load sharing; numbers of
 * teeth, module, face width, speed and torque must be set. */
ovr_gear_form ovr_gear_form_default(void);

ovr_gear *ovr_gear_create(const ovr_gear_form *form,
                          const ovr_allocator *allocator, ovr_error *err);
void ovr_gear_free(ovr_gear *gear);
const ovr_gear_geometry *ovr_gear_of(const ovr_gear *gear);
const ovr_gear_form *ovr_gear_form_of(const ovr_gear *gear);

/* Returns the contact t seconds after it began at A (driving 2: at E), from 0
 * to the duration. Helical teeth: in the slice across the face width. Speeds
 * are those in the transverse plane; radii and load are perpendicular to the
 * contact line. */
ovr_element_moment ovr_gear_at(const ovr_gear *gear, double t);

/* Returns the time at which the contact is at the point R1 of the path. */
double ovr_gear_time(const ovr_gear *gear, double R1);

ovr_cam_form ovr_cam_form_default(void);

ovr_cam *ovr_cam_create(const ovr_cam_form *form,
                        const ovr_allocator *allocator, ovr_error *err);
void ovr_cam_free(ovr_cam *cam);

/* Return the lift event of a cam and the form that it was made from. */
const ovr_cam_event *ovr_cam_of(const ovr_cam *cam);
const ovr_cam_form *ovr_cam_form_of(const ovr_cam *cam);

/* Returns the contact t seconds after `from`. */
ovr_element_moment ovr_cam_at(const ovr_cam *cam, double t);

/* Computes the lift (m) and its first two derivatives with respect to the angle
 * at t. */
void ovr_cam_lift(const ovr_cam *cam, double t, double lift[3]);

ovr_bearing_form ovr_bearing_form_default(void);

ovr_bearing *ovr_bearing_create(const ovr_bearing_form *form,
                                const ovr_allocator *allocator, ovr_error *err);
void ovr_bearing_free(ovr_bearing *bearing);
const ovr_bearing_geometry *ovr_bearing_of(const ovr_bearing *bearing);
const ovr_bearing_form *ovr_bearing_form_of(const ovr_bearing *bearing);

/* Returns the load (N) of roller k, counted from the first roller at or after
 * the load direction. */
double ovr_bearing_load(const ovr_bearing *bearing, int k);

/* Returns the contact of a roller that carries `load` (N). */
ovr_element_moment ovr_bearing_contact(const ovr_bearing *bearing, double load);

/* Finds the rollers that a point of the raceway meets while it crosses the load
 * zone once, one of them at the angle `phase` from the load. Stores at most
 * `capacity` angles and loads (N) in order and returns their number. Loads
 * below `minimum` times the largest are omitted. For a stationary ring it is
 * one, since every roller meets the point with the same load. */
size_t ovr_bearing_passes(const ovr_bearing *bearing, double phase,
                          double minimum, size_t capacity, double *angle,
                          double *load);

/* A required number of a form. */
typedef struct ovr_needed {
    const char *about; /* name of the member */
    double value;
    bool zero; /* may be zero */
} ovr_needed;

/* Fails for the first of `count` numbers that is not finite or not positive. */
ovr_status ovr_check_needed(const ovr_needed *all, size_t count,
                            ovr_error *err);

#endif
