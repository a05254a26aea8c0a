/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_WEB_SCHED_H
#define OVR_WEB_SCHED_H
typedef int cpu_set_t;
#define CPU_ZERO(set) (*(set) = 0)
#define sched_yield() 0
#define CPU_COUNT(set) (*(set))
#define sched_getaffinity(process, size, set) (*(set) = 1, 0)
#endif
