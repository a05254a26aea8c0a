/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that take a case share this: its options, and opening it. */
#ifndef OVR_CLI_CASE_ARGS_H
#define OVR_CLI_CASE_ARGS_H

#include "cli/cli.h"
#include "cli/json.h"

/* Rows for the options of a verb that takes a case. */
#define CLI_CASE_OPTIONS                                                       \
    {"set", "SECTION.KEY=VALUE", "any value of the case", true},               \
        {"M", "NUMBER", "short for --set contact.M=NUMBER", false},            \
        {"L", "NUMBER", "short for --set contact.L=NUMBER", false},            \
        {"level", "NUMBER", "short for --set domain.level=NUMBER", false},     \
        {"scheme", "NAME", "short for --set time.scheme=NAME", false},         \
    {                                                                          \
        "smoother", "NAME", "short for --set paper.smoother=NAME", false       \
    }

/* The case of the first argument (none: an empty one) with what the options
 * set; NULL after having printed why not. */
ovr_case *cli_open_case(const cli_call *call, int *code);

/* Sets in a case what the options of the call say. */
ovr_status cli_apply_options(const cli_call *call, ovr_case *c, ovr_error *err);

/* Prints it as a case: whoever reads that reads the same case. */
void cli_put_case(const ovr_case *c);

/* Prints the parameters of the case and their meaning. */
void cli_json_case(json_writer *json, const ovr_case *c);

#endif
