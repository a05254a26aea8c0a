/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The drawing of an element for the page. */
#ifndef OVR_PICTURES_VIEW_ELEMENT_H
#define OVR_PICTURES_VIEW_ELEMENT_H

#include "pictures/growing_text.h"
#include "pictures/stored.h"

/* Appends "element":{...}, where the case of the run has one. */
void ovr_view_element(ovr_text *to, const ovr_stored *run, ovr_arena *arena);

#endif
