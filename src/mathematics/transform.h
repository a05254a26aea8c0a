/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lock for creating and destroying FFTW plans: the planner is the only part of
 * FFTW that is not reentrant, and a process has one planner.
 *
 * Plans are made with FFTW_ESTIMATE, without measuring, so that equal inputs
 * give equal bits in every run.
 */
#ifndef OVR_MATHEMATICS_TRANSFORM_H
#define OVR_MATHEMATICS_TRANSFORM_H

void ovr_planning_begin(void);
void ovr_planning_end(void);

#endif
