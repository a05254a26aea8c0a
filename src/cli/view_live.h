/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CLI_VIEW_LIVE_H
#define OVR_CLI_VIEW_LIVE_H

#include "cli/cli.h"

/* Replaces the player at `path` by the page of the program with player and case
 * in it, and returns the exit code. */
int cli_make_live(const cli_call *call, const char *path,
                  const char *case_text);

#endif
