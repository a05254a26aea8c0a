/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CLI_SENSITIVITY_H
#define OVR_CLI_SENSITIVITY_H

#include "cli/cli.h"

#define CLI_SENSITIVITY_OPTIONS                                                \
    {"sensitivity", "[KEY,...]",                                               \
     "what a per cent of a key makes of the film, the pressure, the friction", \
     false},                                                                   \
    {                                                                          \
        "j", "N", "with --sensitivity: so many runs at once", false            \
    }

/* --sensitivity of steady and run: a table of elasticities; the exit code. */
int cli_sensitivity(const cli_call *call, ovr_case *c, bool steady);

#endif
