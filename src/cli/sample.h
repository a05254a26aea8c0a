/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CLI_SAMPLE_H
#define OVR_CLI_SAMPLE_H

#include "cli/cli.h"
#include "cli/json.h"

/* Prints what the draws of a study say, as tables on standard output. */
void cli_put_sample(const ovr_sample *sample);

/* The same as an array of objects. */
void cli_json_sample(json_writer *json, const ovr_sample *sample);

#endif
