/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * An output file of a command. It is written under a temporary name and renamed
 * when complete, so that a failure neither leaves an incomplete file nor
 * damages an existing one. A link given by the user is followed; pipes and
 * devices are written directly.
 */
#ifndef OVR_CLI_OUTPUT_H
#define OVR_CLI_OUTPUT_H

#include <stdio.h>

#include "cli/cli.h"

typedef struct cli_output {
    FILE *to;
    const char *path;
    char *target, *part; /* NULL: written directly */
} cli_output;

/* Opens an output; `path` NULL: standard output. An existing file is replaced
 * only with --force. */
int cli_output_open(const cli_call *call, const char *path, cli_output *out);

/* Keeps the file if `code` is CLI_DONE; returns that or CLI_FAILED. */
int cli_output_close(cli_output *out, int code);

#endif
