/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines of a run's report in addition to the rows of the quantities: headings,
 * friction, starvation, temperatures, steps, estimated errors. */
#ifndef OVR_RUN_REPORT_WORDS_H
#define OVR_RUN_REPORT_WORDS_H

#include "run/summary_lines.h"

/* True if the shear stress of a Newtonian isothermal film exceeds the stress
 * that lubricants sustain.  Friction is then not realistic. */
bool ovr_absurd_friction(const ovr_run_info *s);

/* The first lines and the heading of the rows. */
void ovr_report_contact(const ovr_report_sink *to, const ovr_run_info *s);

/* Returns the remark on a quantity: load and flow rate in SI, convergence. */
ovr_words ovr_words_of(const ovr_observable *row, const ovr_run_info *s);

/* Starvation, friction and temperatures. */
void ovr_report_conditions(const ovr_report_sink *to, const ovr_run_info *s);

/* Steps and file of a run; the heading of the values at its end. */
void ovr_report_steps(const ovr_report_sink *to, const ovr_run_info *s);
void ovr_report_end(const ovr_report_sink *to, const ovr_run_info *s);

/* Estimated errors. */
void ovr_report_errors(const ovr_report_sink *to, const ovr_run_info *s);

#endif
