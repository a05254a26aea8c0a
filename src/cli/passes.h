/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The file of several passes, for the commands that print what is in a file. */
#ifndef OVR_CLI_PASSES_H
#define OVR_CLI_PASSES_H

#include "cli/table.h"
#include "overroll/overroll.h"

/* Its rows; NULL: it is another file. */
ovr_table *cli_passes_open(const char *path);

/* Prints text or JSON on stdout. */
void cli_passes_print(const char *path, const ovr_table *passes, bool json);

/* The numbers, a row each pass. */
ovr_status cli_passes_export(const ovr_table *passes, cli_table_form form,
                             FILE *to, ovr_error *err);

#endif
