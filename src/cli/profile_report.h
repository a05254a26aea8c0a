/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints the report of `overroll profile`. */
#ifndef OVR_CLI_PROFILE_REPORT_H
#define OVR_CLI_PROFILE_REPORT_H

#include "overroll/overroll.h"

enum { PROFILE_WAVES = 5, PROFILE_POINTS = 64 };

typedef struct profile_report {
    const char *file;
    ovr_profile *profile;
    const ovr_profile_view *view;
    ovr_profile_numbers numbers;  /* before lambda_c */
    ovr_profile_numbers filtered; /* after it; kind 0: none */
    ovr_profile_wave wave[PROFILE_WAVES];
    size_t waves;
    ovr_dry_point bears[PROFILE_POINTS]; /* contact of --contact */
    size_t points;
    size_t missing;             /* number of missing heights in the file */
    ovr_areal *map;             /* map of an areal file; NULL: none */
    ovr_areal_numbers areal;    /* parameters of the map */
    const ovr_contact *contact; /* contact of --case, or NULL */
} profile_report;

/* Returns the parameters of the profile that is used for the dry contact. */
const ovr_profile_numbers *profile_pressed(const profile_report *report);

void profile_print_text(const profile_report *report);
void profile_print_json(const profile_report *report);

#endif
