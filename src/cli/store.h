/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the [output] of a case to a writer of its result file. */
#ifndef OVR_CLI_STORE_H
#define OVR_CLI_STORE_H

#include "cli/cli.h"

/* Whether the file can be made; said before anything is solved. */
bool cli_check_output(const char *path, bool force, ovr_error *err);

ovr_writer *cli_open_output(ovr_case *c, const ovr_setup *setup,
                            const ovr_simulation *sim, const char *path,
                            bool force, ovr_error *err);

/* Snapshots in a closed file, its last one included. */
size_t cli_count_snapshots(const char *path);

/* The attributes of the group `case`: every parameter with a value. Returns
 * how many; free() them. NULL when memory is out. */
ovr_case_value *cli_case_values(const ovr_case *c, size_t *count);
void cli_free_values(ovr_case_value *values, size_t count);

#endif
