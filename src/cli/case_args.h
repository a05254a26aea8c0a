/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options of commands that take a case, and opening of the case. */
#ifndef OVR_CLI_CASE_ARGS_H
#define OVR_CLI_CASE_ARGS_H

#include "cli/cli.h"
#include "cli/json.h"

/* Rows of the options of a command that takes a case. */
#define CLI_CASE_OPTIONS                                                       \
    {"set", "SECTION.KEY=VALUE", "any value of the case", true},               \
        {"M", "NUMBER", "short for --set contact.M=NUMBER", false},            \
        {"L", "NUMBER", "short for --set contact.L=NUMBER", false},            \
        {"level", "NUMBER", "short for --set domain.level=NUMBER", false},     \
        {"scheme", "NAME", "short for --set time.scheme=NAME", false},         \
    {                                                                          \
        "smoother", "NAME", "short for --set paper.smoother=NAME", false       \
    }

/* Opens the case of the first argument (none: an empty one) and applies the
 * options. Prints an error and returns NULL on failure. */
ovr_case *cli_open_case(const cli_call *call, int *code);

/* Applies the options of the call to a case. */
ovr_status cli_apply_options(const cli_call *call, ovr_case *c, ovr_error *err);

/* Prints a case as text that can be read again. */
void cli_put_case(const ovr_case *c);

/* Prints the parameters of the case and derived quantities. */
void cli_json_case(json_writer *json, const ovr_case *c);

#endif
