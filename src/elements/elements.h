/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Machine elements as the library makes and asks them. */
#ifndef OVR_ELEMENTS_ELEMENTS_H
#define OVR_ELEMENTS_ELEMENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/elements.h"

/* Blok's flash temperature (K) above that of the bodies, for a half-elliptic
 * pressure over the width 2 b, friction mu, and thermal contact coefficients
 * B = sqrt(k rho c) in W s^(1/2)/(m2 K):
 *     T = 1.1115 mu w |u1 - u2|/((B_1 sqrt u1 + B_2 sqrt u2) sqrt(2 b))
 * Blok, Proc. Gen. Disc. Lubrication, IMechE, London 1937, vol. 2, p. 222; the
 * constant for the half ellipse is the largest value of its integral. */
double ovr_flash_temperature(const ovr_element_moment *moment, double b,
                             double mu, double B_1, double B_2);

/* Spur gears of 20 degrees by elastic sharing; numbers of teeth, module, face,
 * speed and torque are still missing. */
ovr_gear_form ovr_gear_form_default(void);

ovr_gear *ovr_gear_create(const ovr_gear_form *form,
                          const ovr_allocator *allocator, ovr_error *err);
void ovr_gear_free(ovr_gear *gear);
const ovr_gear_geometry *ovr_gear_of(const ovr_gear *gear);
const ovr_gear_form *ovr_gear_form_of(const ovr_gear *gear);

/* The contact t seconds after it began at A (driving 2: at E), from 0 to the
 * duration.  Helical teeth: at the slice across the face; the speeds are those
 * in the transverse plane, radii and load those across the contact line. */
ovr_element_moment ovr_gear_at(const ovr_gear *gear, double t);

/* The moment at which the contact passes the point R1 of the path. */
double ovr_gear_time(const ovr_gear *gear, double R1);

ovr_cam_form ovr_cam_form_default(void);

ovr_cam *ovr_cam_create(const ovr_cam_form *form,
                        const ovr_allocator *allocator, ovr_error *err);
void ovr_cam_free(ovr_cam *cam);

/* Its event, and the form that it was made from. */
const ovr_cam_event *ovr_cam_of(const ovr_cam *cam);
const ovr_cam_form *ovr_cam_form_of(const ovr_cam *cam);

/* The contact t seconds after `from`. */
ovr_element_moment ovr_cam_at(const ovr_cam *cam, double t);

/* Lift (m) and its first two derivatives by the angle at t. */
void ovr_cam_lift(const ovr_cam *cam, double t, double lift[3]);

ovr_bearing_form ovr_bearing_form_default(void);

ovr_bearing *ovr_bearing_create(const ovr_bearing_form *form,
                                const ovr_allocator *allocator, ovr_error *err);
void ovr_bearing_free(ovr_bearing *bearing);
const ovr_bearing_geometry *ovr_bearing_of(const ovr_bearing *bearing);
const ovr_bearing_form *ovr_bearing_form_of(const ovr_bearing *bearing);

/* Load (N) of roller k, counted from the first roller below the load or next to
 * it. */
double ovr_bearing_load(const ovr_bearing *bearing, int k);

/* The contact of a roller that carries `load` (N). */
ovr_element_moment ovr_bearing_contact(const ovr_bearing *bearing, double load);

/* The rollers that one point of the raceway meets in one crossing of the load
 * zone, one of them at the angle `phase` from the load: at most `capacity`
 * angles and loads (N), in the order in which they come; returns how many there
 * are. Loads below `minimum` times the largest are left out.  Of a ring that
 * stands still, one: it is met by every roller alike. */
size_t ovr_bearing_passes(const ovr_bearing *bearing, double phase,
                          double minimum, size_t capacity, double *angle,
                          double *load);

/* A number of a form that an element cannot do without. */
typedef struct ovr_needed {
    const char *about; /* the member of the form */
    double value;
    bool zero; /* may be zero */
} ovr_needed;

/* The first of `count` numbers that is not finite, or not positive. */
ovr_status ovr_check_needed(const ovr_needed *all, size_t count,
                            ovr_error *err);

#endif
