/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/fields.h"

#define ROW(name, memory, ...) {#name, OVR_##memory, __VA_ARGS__},

const ovr_field_row ovr_field_rows[OVR_FIELD_COUNT] = {OVR_LEVEL_FIELDS(ROW)};
