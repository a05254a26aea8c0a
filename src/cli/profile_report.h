/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints what `overroll profile` tells. */
#ifndef OVR_CLI_PROFILE_REPORT_H
#define OVR_CLI_PROFILE_REPORT_H

#include "overroll/overroll.h"

enum { PROFILE_WAVES = 5, PROFILE_POINTS = 64 };

typedef struct profile_report {
    const char *file;
    ovr_profile *profile;
    const ovr_profile_view *view;
    ovr_profile_numbers numbers;  /* before lambda_c */
    ovr_profile_numbers filtered; /* after it; kind 0: there is none */
    ovr_profile_wave wave[PROFILE_WAVES];
    size_t waves;
    ovr_dry_point bears[PROFILE_POINTS]; /* --contact */
    size_t points;
    size_t missing;             /* heights, as read */
    ovr_areal *map;             /* of an areal file; NULL: it holds lines */
    ovr_areal_numbers areal;    /* of map */
    const ovr_contact *contact; /* of --case, or NULL */
} profile_report;

/* The numbers of the profile as it is pressed. */
const ovr_profile_numbers *profile_pressed(const profile_report *report);

void profile_print_text(const profile_report *report);
void profile_print_json(const profile_report *report);

#endif
