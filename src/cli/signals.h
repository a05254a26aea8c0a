/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SIGINT and SIGTERM ask the run to stop behind its step; a second one ends
 * the program at once. */
#ifndef OVR_CLI_SIGNALS_H
#define OVR_CLI_SIGNALS_H

#include <stdbool.h>

/* Signals only ask from now on. */
void cli_catch_signals(void);

/* The signal that asked, or 0. */
int cli_signal(void);

/* The same as an answer to the library's `stop`. */
bool cli_stop(void *nothing);

#endif
