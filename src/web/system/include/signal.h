/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Signals are never delivered. */
#ifndef OVR_WEB_SIGNAL_H
#define OVR_WEB_SIGNAL_H
#include_next <signal.h>
struct sigaction {
    void (*sa_handler)(int number);
    int sa_mask, sa_flags;
};
#define SA_RESETHAND 0u
#define SA_RESTART 0
#define sigaction(number, to, from) ((void)(to), (void)(from), -1)
#define sigemptyset(set) ((void)(set), 0)
#define sigfillset(set) ((void)(set), 0)
#endif
