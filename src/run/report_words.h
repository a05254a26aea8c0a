/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Says in words what reports have to say of a run beside the rows of the
 * quantities. */
#ifndef OVR_RUN_REPORT_WORDS_H
#define OVR_RUN_REPORT_WORDS_H

#include "run/summary_lines.h"

/* A Newtonian isothermal film's may be no oil's, which is the first that is
 * said of it: the film is none the worse. */
bool ovr_absurd_friction(const ovr_run_info *s);

/* The first lines. */
void ovr_say_contact(const ovr_told *to, const ovr_run_info *s);

/* The words behind a quantity that has more to say than its row. */
ovr_words ovr_words_of(const ovr_observable *row, const ovr_run_info *s);

/* Starvation, friction and temperatures. */
void ovr_say_conditions(const ovr_told *to, const ovr_run_info *s);

/* Steps and file of a run; where it ends. */
void ovr_say_steps(const ovr_told *to, const ovr_run_info *s);
void ovr_say_end(const ovr_told *to, const ovr_run_info *s);

/* Estimated errors. */
void ovr_say_errors(const ovr_told *to, const ovr_run_info *s);

#endif
