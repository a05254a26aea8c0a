/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of an element's stations. */
#ifndef OVR_CLI_STATIONS_H
#define OVR_CLI_STATIONS_H

#include "cli/json.h"
#include "overroll/case.h"

/* Lines that begin with "#"; nothing without an element. */
void cli_put_stations(const ovr_setup *setup);
void cli_json_stations(json_writer *json, const ovr_setup *setup);

#endif
