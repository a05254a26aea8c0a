/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Summaries and cases of studies, for the floor above. */
#ifndef OVR_RUN_RUN_H
#define OVR_RUN_RUN_H

#include "overroll/run.h"

/* Sums a run up, line by line. */
void ovr_run_summary(const ovr_run_info *run, ovr_summary_taker *take,
                     void *data);

/* As ovr_run_answers, from the summary of a file. */
void ovr_result_answers(ovr_result *result, ovr_answer *put, void *data);

/* The k-th case, to be freed. */
ovr_case *ovr_study_case(const ovr_study *study, size_t k, ovr_error *err);

#endif
