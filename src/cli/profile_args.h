/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The options of `overroll profile` as the library takes them.  Each returns
 * the exit code after having printed why. */
#ifndef OVR_CLI_PROFILE_ARGS_H
#define OVR_CLI_PROFILE_ARGS_H

#include "cli/cli.h"

int profile_take_source(const cli_call *call, ovr_profile_source *source);

/* For a profile that has been read: lengths are in its units, turned into them
 * with the contact's where these are known (contact may be NULL). */
int profile_take_conditioning(const cli_call *call,
                              const ovr_profile_view *view,
                              const ovr_contact *contact,
                              ovr_conditioning *how);

#endif
