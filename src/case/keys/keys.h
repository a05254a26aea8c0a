/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sections of a case with the rows of their keys: a file for what belongs
 * together.  Where the values go is ovr_settings; of a feature and a body their
 * own forms. */
#ifndef OVR_CASE_KEYS_H
#define OVR_CASE_KEYS_H

#include "base/rows.h"
#include "case/settings.h"

#define AT(field) offsetof(ovr_settings, field)

extern const ovr_section ovr_contact_section;
extern const ovr_section ovr_lubricant_section;
extern const ovr_section ovr_domain_section;
extern const ovr_section ovr_solver_section;
extern const ovr_section ovr_time_section;
extern const ovr_section ovr_load_section;
extern const ovr_section ovr_speed_section;
extern const ovr_section ovr_sliding_section;
extern const ovr_section ovr_radius_section;
extern const ovr_section ovr_radius_1_section;
extern const ovr_section ovr_passes_section;
extern const ovr_section ovr_feature_section;
extern const ovr_section ovr_output_section;
extern const ovr_section ovr_paper_section;
extern const ovr_section ovr_body_section;
extern const ovr_section ovr_gear_section;
extern const ovr_section ovr_cam_section;
extern const ovr_section ovr_roller_bearing_section;

/* Condition of a transient run: it has an end time, or a machine element that
 * determines the end. */
#define IN_TIME "time.end or gear.teeth_1 or cam.base_radius"

#endif
