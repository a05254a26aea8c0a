/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_BASE_PROCESSORS_H
#define OVR_BASE_PROCESSORS_H

/* Returns the number of processors that this process may use, within the limits
 * of taskset, a batch system or a container. */
int ovr_processors(void);

#endif
