/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A file that a command writes: beside its name and renamed when it is whole,
 * so that a failure leaves neither half a file nor harms the one before.  A
 * link that the user named stays one; what is no file (a pipe, a device) is
 * written to as it is.
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
