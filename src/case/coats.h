/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case lays coats on its bodies. */
#ifndef OVR_CASE_COATS_H
#define OVR_CASE_COATS_H

#include "contact/layers.h"
#include "overroll/case.h"

/* Layers on a body, 0 or 1, or NULL. */
const ovr_coated *ovr_setup_layers(const ovr_setup *setup, int body);

#endif
