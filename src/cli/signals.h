/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SIGINT and SIGTERM request that the run stops after its present step. A
 * second signal ends the program immediately. */
#ifndef OVR_CLI_SIGNALS_H
#define OVR_CLI_SIGNALS_H

#include <stdbool.h>

/* Installs handlers that only record a signal. */
void cli_catch_signals(void);

/* Returns the recorded signal, or 0. */
int cli_signal(void);

/* True if a signal was recorded; for the library's `stop`. */
bool cli_stop(void *nothing);

#endif
