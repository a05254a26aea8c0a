/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A whole case, with every parameter that counts and its value. */
#ifndef OVR_CLI_CASE_PRINT_H
#define OVR_CLI_CASE_PRINT_H

#include "cli/cli.h"
#include "cli/json.h"

/* Prints it as a case: whoever reads that reads the same case. */
void cli_put_case(const ovr_case *c);

/* Prints the parameters of the case and their meaning. */
void cli_json_case(json_writer *json, const ovr_case *c);

#endif
