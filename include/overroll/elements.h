/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Machine elements: the line contact of two gear teeth, of a cam and its
 * follower, of a roller and its raceway, from the numbers of a drawing.
 *
 * Pure functions, SI units, angles in rad: an element is made from its form,
 * checked there, and asked where its contact is at a time t.  Surface 1 is gear
 * 1, the cam, or the raceway; +x is the way surface 1 moves.  NAN in a form
 * means "not given" where stated.  Each `create` returns NULL with the error
 * filled, about the member that is wrong; forms are copied, tables too.
 */
#ifndef OVERROLL_ELEMENTS_H
#define OVERROLL_ELEMENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/error.h"
#include "overroll/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The contact at one moment.  Radii are negative where a surface is concave;
 * 1/R = 1/R_1 + 1/R_2; a flat surface has the radius INFINITY. */
typedef struct ovr_element_moment {
    double t;           /* s */
    double R, R_1, R_2; /* m */
    double u1, u2;      /* m/s */
    double load;        /* N/m */
} ovr_element_moment;

/* ----------------------------------------------------------------- gears */

typedef enum ovr_gear_sharing {
    OVR_SHARING_RULE,      /* 1/3 to 2/3 where two pairs touch */
    OVR_SHARING_ELASTIC,   /* least elastic energy, Pedrero et al. 2010 */
    OVR_SHARING_STIFFNESS, /* springs of c' of ISO 6336-1, and tip relief */
    OVR_SHARING_TABLE      /* shares of the user's own */
} ovr_gear_sharing;

/* Involute gears on parallel axes, spur or helical; an internal gear has a
 * negative number of teeth. */
typedef struct ovr_gear_form {
    int teeth_1, teeth_2;
    double module;           /* normal, m */
    double pressure_angle;   /* normal, on the reference cylinder */
    double helix_angle;      /* there too; 0: spur */
    double shift_1, shift_2; /* profile shifts in modules; one of them NAN:
                                follows from the centre distance */
    double centre;           /* m; NAN: without backlash by the shifts */
    double addendum;         /* in modules */
    double tip_1, tip_2;     /* tip diameters, m; NAN: by the addendum, with
                                the clearance kept */
    double face;             /* common width, m */
    double speed;            /* of gear 1, rad/s */
    int driving;             /* gear 1 or 2: which way along the path */
    double torque;           /* on gear 1, N m */
    ovr_gear_sharing sharing;
    double blend;              /* base pitches over which a pair takes the whole
                                  load at B and leaves it at D; 0: at once */
    double relief_1, relief_2; /* at the tips, m (stiffness) */
    double relief_length_1,
        relief_length_2;       /* along the path, m; NAN: A to B */
    double mesh_stiffness;     /* c', N/m2; NAN: of ISO 6336-1 */
    double slice;              /* helical: where across the face, 0 to 1; 0 is
                                  the end that touches first */
    double min_share;          /* the way begins and ends where the share of the
                                    load passes it */
    double min_radius;         /* external: and where R_1 or R_2 passes this
                                    share of the line of action */
    size_t shares;             /* table: points of */
    const double *way, *share; /* base pitches from A, and the share */
} ovr_gear_form;

/* The geometry that follows from a form.  Ways R1_* are distances from the base
 * circle of gear 1 along the line of action, in the transverse plane: A where
 * contact begins with gear 1 driving, E where it ends, B and D where a second
 * pair leaves and comes, C the pitch point.  Of an internal gear, d_2, base_2
 * and line are negative. */
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
    double whole_load;       /* of one pair alone over the face, N/m */
    double mesh_stiffness;   /* c', N/m2 */
    bool iso_applies;        /* its shifts are in the range of ISO's c' */
    double stiffness_sum;    /* mean of c' over all pairs that touch over c' */
    double duration;         /* A to E, s */
    double begin, end;       /* s from the first touch: the way that is left by
                                min_share and min_radius */
} ovr_gear_geometry;

typedef struct ovr_gear ovr_gear;

/* ------------------------------------------------------------------ cams */

typedef enum ovr_cam_law {
    OVR_CAM_4567,      /* 35 y^4 - 84 y^5 + 70 y^6 - 20 y^7 */
    OVR_CAM_345,       /* 10 y^3 - 15 y^4 + 6 y^5 */
    OVR_CAM_CYCLOIDAL, /* y - sin(2 pi y)/(2 pi) */
    OVR_CAM_HARMONIC,  /* (1 - cos(pi y))/2 */
    OVR_CAM_TABLE      /* lifts of the user's own, by a natural cubic spline */
} ovr_cam_law;

typedef enum ovr_cam_follower {
    OVR_FOLLOWER_FLAT,
    OVR_FOLLOWER_ROLLER
} ovr_cam_follower;

/* A cam that lifts a follower whose way goes through the cam's axis. */
typedef struct ovr_cam_form {
    ovr_cam_law law;
    ovr_cam_follower follower;
    double base_radius;           /* m */
    double roller_radius;         /* m; roller alone */
    double face;                  /* m */
    double speed;                 /* rad/s */
    double lift;                  /* m; laws */
    double rise, dwell, fall;     /* angles; laws; fall NAN: as the rise */
    double spring;                /* N/m */
    double preload;               /* N at no lift */
    double mass;                  /* all that moves, at the follower, kg */
    double slip;                  /* roller: (u1 - u2)/um */
    double from, to;              /* part of the event; NAN: all */
    size_t points;                /* table */
    const double *angle, *height; /* from the beginning of the rise, m */
    double rounding;              /* of the heights: their smallest decimal; 0:
                                     exact */
} ovr_cam_form;

typedef struct ovr_cam ovr_cam;

/* The motion of a cam over its event, or the part of it that was asked for. */
typedef struct ovr_cam_event {
    double from, to;     /* angles */
    double duration;     /* s */
    double nose;         /* angle of the largest lift */
    double joints[4];    /* angles at which rise, dwell and fall meet */
    size_t reversals;    /* where the mean speed passes zero, at most 16 */
    double reversal[16]; /* their angles */
    bool jumps;          /* the law's acceleration jumps at its ends */
    double min_force;    /* N */
} ovr_cam_event;

/* -------------------------------------------------------------- bearings */

typedef enum ovr_bearing_position {
    OVR_ROLLER_BELOW, /* a roller is below the load */
    OVR_GAP_BELOW,    /* a gap between two rollers does */
    OVR_ROLLER_AT     /* a roller is at `angle` from the load */
} ovr_bearing_position;

/* A cylindrical roller bearing under a radial load that stands still. */
typedef struct ovr_bearing_form {
    double roller; /* diameter, m */
    int rollers;
    double length;       /* effective, m */
    double inner, pitch; /* diameters, m; one of them, the other NAN */
    double clearance;    /* diametral, m; negative: preloaded */
    double load;         /* N */
    double speed_inner, speed_outer; /* rad/s */
    int contact;                     /* 1: inner raceway, 2: outer raceway */
    double slip; /* (u1 - u2)/um; the raceway's speed is kept */
    ovr_bearing_position position;
    double angle;
    double stiffness; /* K of both contacts of a roller together,
                         Q = K d^(10/9), N/m^(10/9); NAN: after Palmgren */
} ovr_bearing_form;

enum { OVR_ROLLERS_MAX = 1024 };

typedef struct ovr_bearing_geometry {
    double inner, outer, pitch; /* diameters, m */
    double stiffness;           /* N/m^(10/9) */
    double cage;                /* speed, rad/s */
    double spin;                /* of a roller in space, rad/s */
    double displacement;        /* of the inner ring, m */
    double heaviest;            /* load of a roller, N */
    int loaded;                 /* rollers that carry */
    double spacing;             /* of the rollers on the raceway, m */
    double period;              /* between two rollers at one point, s */
    double step;                /* in space between two rollers that one point
                                   of the raceway meets, with the sign of its
                                   turning; 0: it stands still */
} ovr_bearing_geometry;

typedef struct ovr_bearing ovr_bearing;

#ifdef __cplusplus
}
#endif

#endif
