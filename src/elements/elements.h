/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Machine elements: the line contact of two gear teeth, of a cam and its
 * follower, of a roller and its raceway, from the numbers of a drawing.
 *
 * SI units, angles in rad.  An element is created from its form, which is
 * checked, and returns its contact at a time t.  Where stated, NAN in a form
 * means "not set".  Each `create` function returns NULL on errors, which name
 * the member.  Forms and tables are copied.
 */
#ifndef OVR_ELEMENTS_ELEMENTS_H
#define OVR_ELEMENTS_ELEMENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/elements.h"
#include "overroll/error.h"
#include "overroll/memory.h"

/* ----------------------------------------------------------------- gears */

typedef enum ovr_gear_sharing {
    OVR_SHARING_RULE,      /* 1/3 to 2/3 where two pairs are in contact */
    OVR_SHARING_ELASTIC,   /* minimum elastic energy, Pedrero et al. 2010 */
    OVR_SHARING_STIFFNESS, /* springs with c' of ISO 6336-1, and tip relief */
    OVR_SHARING_TABLE      /* load shares from a table */
} ovr_gear_sharing;

/* Involute gears on parallel axes, spur or helical; an internal gear has a
 * negative number of teeth. */
typedef struct ovr_gear_form {
    int teeth_1, teeth_2;
    double module;         /* normal, m */
    double pressure_angle; /* normal pressure angle on the reference cylinder */
    double
        helix_angle; /* helix angle on the reference cylinder; 0: spur gears */
    double shift_1, shift_2; /* profile shift coefficients; one of them may be
                                NAN and then follows from the centre distance */
    double centre;   /* centre distance, m; NAN: without backlash for the given
                        profile shifts */
    double addendum; /* addendum in modules */
    double tip_1, tip_2; /* tip diameters, m; NAN: by the addendum with standard
                            clearance */
    double face;         /* common width, m */
    double speed;        /* angular speed of gear 1, rad/s */
    int driving;   /* driving gear, 1 or 2; determines the direction along the
                      path of contact */
    double torque; /* torque on gear 1, N m */
    ovr_gear_sharing sharing;
    double blend; /* length in base pitches over which the load of a pair
                     changes at B and D; 0: the load jumps */
    double relief_1, relief_2; /* tip relief, m (with OVR_SHARING_STIFFNESS) */
    double relief_length_1, relief_length_2; /* length of the relief along the
                                                path, m; NAN: A to B */
    double mesh_stiffness; /* mesh stiffness c' per unit width, N/m^2; NAN: by
                              ISO 6336-1 */
    double slice; /* helical gears: position across the face, 0 to 1, from the
                     end that enters contact first */
    double min_share; /* minimum load share at the start and end of the computed
                         part of the path */
    double min_radius; /* external gears: minimum R_1 and R_2 there, relative to
                          the length of the line of action */
    size_t shares;     /* number of points of the table */
    const double *distance,
        *share; /* distance from A in base pitches, and load share */
} ovr_gear_form;

/* Geometry of a gear pair. R1_* are distances from the base circle of gear 1
 * along the line of action in the transverse plane. With gear 1 driving, A is
 * the start of contact and E its end. One pair is in contact between B and D,
 * and C is the pitch point. For an internal gear d_2, base_2 and line are
 * negative. */
typedef struct ovr_gear_geometry {
    double centre, working_angle, shift_1, shift_2, shortening;
    double d_1, d_2;       /* reference diameters, m */
    double base_1, base_2; /* base radii, m */
    double tip_1, tip_2;   /* tip diameters, m */
    double line;           /* L = R_1 + R_2, transverse, m */
    double R1_A, R1_B, R1_C, R1_D, R1_E;
    double base_pitch; /* transverse, m */
    double base_helix; /* helix angle on the base cylinder */
    double contact_ratio, overlap_ratio;
    double omega_1, omega_2; /* rad/s, both positive */
    double transverse_force; /* N */
    double normal_force;     /* N */
    double whole_load;       /* load per unit width of a single pair, N/m */
    double mesh_stiffness;   /* c', N/m2 */
    bool iso_applies; /* the profile shifts are in the range of the formula for
                         c' of ISO 6336-1 */
    double stiffness_sum; /* mean total stiffness of all pairs in contact
                             divided by c' */
    double duration;      /* A to E, s */
    double begin, end; /* times from the start of contact, s: part of the path
                          limited by min_share and min_radius */
} ovr_gear_geometry;

typedef struct ovr_gear ovr_gear;

/* ------------------------------------------------------------------ cams */

typedef enum ovr_cam_law {
    OVR_CAM_4567,      /* 35 y^4 - 84 y^5 + 70 y^6 - 20 y^7 */
    OVR_CAM_345,       /* 10 y^3 - 15 y^4 + 6 y^5 */
    OVR_CAM_CYCLOIDAL, /* y - sin(2 pi y)/(2 pi) */
    OVR_CAM_HARMONIC,  /* (1 - cos(pi y))/2 */
    OVR_CAM_TABLE      /* lifts from a table, by a natural cubic spline */
} ovr_cam_law;

typedef enum ovr_cam_follower {
    OVR_FOLLOWER_FLAT,
    OVR_FOLLOWER_ROLLER
} ovr_cam_follower;

/* A cam with a translating follower whose axis passes through the cam axis. */
typedef struct ovr_cam_form {
    ovr_cam_law law;
    ovr_cam_follower follower;
    double base_radius;   /* m */
    double roller_radius; /* m; roller follower only */
    double face;          /* m */
    double speed;         /* rad/s */
    double lift;          /* m; not for tables */
    double rise, dwell,
        fall; /* angles, not for tables, the fall NAN if equal to the rise */
    double spring;   /* N/m */
    double preload;  /* force at zero lift, N */
    double mass;     /* moving mass at the follower, kg */
    double slip;     /* roller follower: (u1 - u2)/u_m */
    double from, to; /* part of the event; NAN: the whole event */
    size_t points;   /* number of points of the table */
    const double *angle,
        *height;     /* angle from the start of the rise, and lift in m */
    double rounding; /* resolution of the lifts; 0: exact */
} ovr_cam_form;

typedef struct ovr_cam ovr_cam;

/* Motion of a cam during its event or the requested part of it. */
typedef struct ovr_cam_event {
    double from, to;  /* angles */
    double duration;  /* s */
    double nose;      /* angle of maximum lift */
    double joints[4]; /* angles at which rise, dwell and fall meet */
    size_t reversals; /* number of reversals of the entrainment speed, at most
                         16 */
    double reversal[16]; /* angles of the reversals */
    bool jumps;          /* the acceleration jumps at the ends of the rise */
    double min_force;    /* N */
} ovr_cam_event;

/* -------------------------------------------------------------- bearings */

typedef enum ovr_bearing_position {
    OVR_ROLLER_BELOW, /* a roller is at the angle of the load */
    OVR_GAP_BELOW, /* the middle between two rollers is at the angle of the load
                    */
    OVR_ROLLER_AT  /* a roller is at the angle `angle` from the load */
} ovr_bearing_position;

/* A cylindrical roller bearing under a stationary radial load. */
typedef struct ovr_bearing_form {
    double roller; /* diameter, m */
    int rollers;
    double length;       /* effective, m */
    double inner, pitch; /* diameters, m; one of both, the other is NAN */
    double clearance;    /* diametral clearance, m, negative if preloaded */
    double load;         /* N */
    double speed_inner, speed_outer; /* rad/s */
    int contact;                     /* 1: inner raceway, 2: outer raceway */
    double slip; /* (u1 - u2)/u_m at constant raceway speed */
    ovr_bearing_position position;
    double angle;
    double stiffness; /* stiffness K of both contacts of a roller, Q = K
                         d^(10/9), N/m^(10/9); NAN: by Palmgren */
} ovr_bearing_form;

enum { OVR_ROLLERS_MAX = 1024 };

typedef struct ovr_bearing_geometry {
    double inner, outer, pitch; /* diameters, m */
    double stiffness;           /* N/m^(10/9) */
    double cage;                /* cage speed, rad/s */
    double spin;                /* speed of a roller about its axis, rad/s */
    double displacement;        /* displacement of the inner ring, m */
    double heaviest;            /* load of the most heavily loaded roller, N */
    int loaded;                 /* number of loaded rollers */
    double spacing; /* distance between rollers along the raceway, m */
    double period;  /* time between two rollers at a fixed point, s */
    double step; /* angle in space between successive rollers met by a raceway
                    point, with the sign of the rotation; 0: the ring does not
                    rotate */
} ovr_bearing_geometry;

typedef struct ovr_bearing ovr_bearing;

/* ------------------------------------------------------------- functions */

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
