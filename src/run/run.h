/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Summaries and cases of studies, for the layer above. */
#ifndef OVR_RUN_RUN_H
#define OVR_RUN_RUN_H

#include "overroll/run.h"

/* Like ovr_run_answers, but from the summary of a result file. */
void ovr_result_answers(ovr_result *result, ovr_answer *put, void *data);

/* Predicts the film thickness of rough surfaces for a prepared setup; takes
 * milliseconds. */
ovr_status ovr_setup_rough_film(const ovr_setup *setup,
                                const ovr_allocator *allocator,
                                ovr_rough_film *to, ovr_error *err);

/* Predicted output of a prepared setup. The number of snapshots excludes those
 * at maximum pressure and minimum film thickness. The bytes on disk are an
 * upper bound, without compression. */
typedef struct ovr_storage {
    double snapshots, bytes;
} ovr_storage;
ovr_storage ovr_setup_storage(const ovr_setup *setup);

#endif
