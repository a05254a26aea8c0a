/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Features of a model, and pairs of features that cannot be combined.
 *
 * A simulation with such a pair is rejected. Every other pair can be marched in
 * time, is resumed to the same bits and conserves mass and load
 * (tests/verify/pairs_test.c checks all of them).
 */
#ifndef OVERROLL_CONFLICTS_H
#define OVERROLL_CONFLICTS_H

#include <stdbool.h>

#include "overroll/error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A feature and its place in a case, such as "heat", "heat", "model". */
typedef struct ovr_model_feature_info {
    const char *name, *section, *key;
    bool whole; /* the presence of the section selects the feature */
} ovr_model_feature_info;

/* Two features that cannot be combined. */
typedef struct ovr_conflict {
    int feature, other;  /* numbers of features */
    const char *instead; /* alternative to `feature` */
    const char *why;
} ovr_conflict;

/* Returns conflict k; NULL after the last. */
OVR_API const ovr_conflict *ovr_conflict_at(size_t k);
OVR_API ovr_model_feature_info ovr_model_feature_at(int feature);

#ifdef __cplusplus
}
#endif

#endif
