/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One case of a study on disk.  Workers on any number of hosts share the folder
 * of the results:
 *
 *     NAME.ini     the case, written and locked (flock) while it runs
 *     NAME.h5      its result file, unless the study has `results = no`
 *     NAME.log     its messages
 *     NAME.json    its summary, once it has finished
 *     NAME.failed  exit code and message of a failure
 *
 * A study with results = no has tables instead (run/study_rows.h), and so has a
 * study with [find]. Its cases have NAME.ini and NAME.find.csv, the evaluations
 * of the search, which remain unless results = no.
 */
#ifndef OVR_RUN_TASK_H
#define OVR_RUN_TASK_H

#include "run/pool.h"
#include "run/study.h"
#include "run/study_rows.h"

/* Runs or resumes a task in this process, whose standard output and error go
 * to its log meanwhile; returns the status it ended with.  `rows`: open for a
 * study with rows, otherwise NULL. */
ovr_status ovr_task_work(const ovr_study *s, size_t task,
                         const ovr_sweep_options *how, ovr_shared shared,
                         ovr_rows *rows);

/* Returns the state of a task; `rows` as in ovr_task_work. */
ovr_sweep_state ovr_task_state(const ovr_study *s, const ovr_rows *rows,
                               size_t task);

/* Records that a worker process was killed by a signal. */
void ovr_task_died(const ovr_study *s, size_t task, int number);

/* True if the file with the name of the task's case was not written by this
 * study. */
bool ovr_task_foreign(const ovr_study *s, size_t task);

#endif
