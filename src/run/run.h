/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Summaries and cases of studies, for the floor above. */
#ifndef OVR_RUN_RUN_H
#define OVR_RUN_RUN_H

#include "overroll/run.h"

/* As ovr_run_answers, from the summary of a file. */
void ovr_result_answers(ovr_result *result, ovr_answer *put, void *data);

#endif
