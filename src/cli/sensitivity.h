/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CLI_SENSITIVITY_H
#define OVR_CLI_SENSITIVITY_H

#include "cli/cli.h"

#define CLI_SENSITIVITY_OPTIONS                                                \
    {"sensitivity", "[KEY,...]",                                               \
     "elasticities: relative change of film thickness, pressure and friction " \
     "per relative change of each key",                                        \
     false},                                                                   \
    {                                                                          \
        "j", "N", "with --sensitivity: number of runs at the same time", false \
    }

/* --sensitivity of steady and run: a table of elasticities; the exit code. */
int cli_sensitivity(cli_call *call, ovr_case *c, bool steady);

#endif
