/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One case of a study on disk.  All that is known of it lies in the folder of
 * the results, so that workers on any number of hosts need nothing else:
 *
 *     NAME.ini     the case, written and locked (flock) while it runs
 *     NAME.h5      its result file, unless the study has `results = no`
 *     NAME.log     what it said
 *     NAME.json    its summary, once it has finished
 *     NAME.failed  exit code and message of a failure
 */
#ifndef OVR_RUN_TASK_H
#define OVR_RUN_TASK_H

#include "run/pool.h"
#include "run/study.h"

/* Runs or resumes a task in this process, whose standard output and error go
 * to its log meanwhile; returns the status it ended with. */
ovr_status ovr_task_work(const ovr_study *s, size_t task,
                         const ovr_sweep_options *how, ovr_shared shared);

/* Serves the parent of a worker that died of a signal without a word. */
void ovr_task_died(const ovr_study *s, size_t task, int number);

/* True if a file of somebody else has the name of the task's case. */
bool ovr_task_foreign(const ovr_study *s, size_t task);

#endif
