/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_BASE_PROCESSORS_H
#define OVR_BASE_PROCESSORS_H

/* The number of processors that this process may run on: what taskset, a batch
 * system or a container leaves of them. */
int ovr_processors(void);

#endif
