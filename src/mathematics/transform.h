/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The lock under which FFTW's plans are made and destroyed: its planner is the
 * one part of it that is not reentrant, and there is one in a process.
 *
 * Plans are made with FFTW_ESTIMATE, without measuring, so that equal inputs
 * give equal bits in every run.
 */
#ifndef OVR_MATHEMATICS_TRANSFORM_H
#define OVR_MATHEMATICS_TRANSFORM_H

void ovr_planning_begin(void);
void ovr_planning_end(void);

#endif
