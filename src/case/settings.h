/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values of a case, which the rows of its keys refer to. */
#ifndef OVR_CASE_SETTINGS_H
#define OVR_CASE_SETTINGS_H

#include "contact/contact.h"
#include "contact/heat_numbers.h"
#include "contact/history.h"
#include "contact/oil.h"
#include "elements/elements.h"
#include "overroll/case.h"

/* Levels that are chosen automatically (case/setup.c). */
enum {
    OVR_GRID_AUTO = 0,
    OVR_GRID_USUAL = -1,
    OVR_USUAL_LEVEL = 8,
    OVR_USUAL_STRIP = 6
};

/* Values of a feature; the form refers to the others. */
typedef struct ovr_feature_settings {
    ovr_feature_form form;
    ovr_profile_source source;
    ovr_conditioning conditioning;
    ovr_roughness roughness;
} ovr_feature_settings;

/* Values of [gear], [cam] and [roller_bearing]. */
typedef struct ovr_element_settings {
    ovr_gear_form gear;
    double power; /* in W; NAN: not given */
    const char *sharing_file;
    ovr_cam_form cam;
    const char *lift_file;
    ovr_bearing_form bearing;
    int passes;
} ovr_element_settings;

/* Values of [roller_bearing] passes. */
enum {
    OVR_ROLLER_PASSES_NONE,
    OVR_ROLLER_PASSES_ZONE,
    OVR_ROLLER_PASSES_TURNS
};

/* Values of a case except those of its features. */
typedef struct ovr_settings {
    ovr_conditions contact; /* viscosity and alpha are keys of `oil` */
    double bearable;
    double Rq[2]; /* roughness that is not on the grid, m; NAN: unknown */
    int scale;
    ovr_oil oil;
    double iso_vg;
    const char *viscosity_file, *density_file;
    ovr_flow_form flow;
    int carreau_form;
    const char *rheology_file;
    ovr_options options;
    int scheme; /* -1: chosen from steps and histories */
    int nodes;
    double accuracy; /* target with level = auto */
    int accuracy_of;
    ovr_march march;
    double step; /* time step set in [time] */
    ovr_change load, speed, sliding, radius, radius_1;
    int curvature; /* value of `curvature` in [radius], see below */
    ovr_passes_setup passes;
    ovr_output output;
    int precision;
    ovr_element_settings element;
} ovr_settings;

/* Values of [contact] scale. */
enum { OVR_SCALE_DRY, OVR_SCALE_SUBSTRATE };

/* Values of [radius] curvature. */
enum { OVR_CURVATURE_AUTO, OVR_CURVATURE_CONVECTED, OVR_CURVATURE_IMPOSED };

/* Materials with names in [body 1] and [body 2]; values and sources are in
 * resolve_contact.c. */
typedef enum ovr_material_name {
    OVR_STEEL = 1,
    OVR_SILICON_NITRIDE,
    OVR_TUNGSTEN_CARBIDE,
    OVR_BRONZE,
    OVR_GLASS,
    OVR_SAPPHIRE
} ovr_material_name;

/* Values of [body 1] and [body 2]; NAN, 0: not given. */
typedef struct ovr_body_form {
    int material; /* ovr_material_name */
    double modulus, poisson, radius;
    double yield; /* von Mises yield stress; in p_h once the contact is known;
                   * 0: none */
    ovr_thermal thermal;
} ovr_body_form;

/* Value of `end = auto`. */
#define OVR_END_AUTO INFINITY

/* Values of `step = adaptive` and `step = auto`. */
#define OVR_STEP_ADAPTIVE (-1.0)
#define OVR_STEP_AUTO (-2.0)

#endif
