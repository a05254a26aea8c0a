/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the [output] of a case to a writer of its result file. */
#ifndef OVR_CLI_STORE_H
#define OVR_CLI_STORE_H

#include "cli/cli.h"

/* Whether the file can be made; said before anything is solved. */
bool cli_check_output(const char *path, bool force, ovr_error *err);

/* A new file; its checkpoints will hold the simulation's state. */
ovr_writer *cli_open_output(ovr_case *c, const ovr_setup *setup,
                            ovr_simulation *sim, const char *path, bool force,
                            ovr_error *err);

/* The file of an earlier run, gone on with: first what may be refused (another
 * physics), then the checkpoint's state into the simulation, then the file.
 * `restart` NULL or without a state: from the beginning. */
ovr_writer *cli_reopen_output(ovr_case *c, const ovr_setup *setup,
                              ovr_simulation *sim, const char *path,
                              const ovr_restart *restart, ovr_error *err);

/* Snapshots in a closed file, its last one included. */
size_t cli_count_snapshots(const char *path);

/* The attributes of the group `case`: every parameter with a value. Returns
 * how many; free() them. NULL when memory is out. */
ovr_case_value *cli_case_values(const ovr_case *c, size_t *count);
void cli_free_values(ovr_case_value *values, size_t count);

#endif
