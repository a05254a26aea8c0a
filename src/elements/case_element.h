/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [gear], [cam] and [roller_bearing]: what their contact says in place of
 * [contact] and of the histories. */
#ifndef OVR_ELEMENTS_CASE_ELEMENT_H
#define OVR_ELEMENTS_CASE_ELEMENT_H

#include "case/resolve.h"

/* Fills the section that speaks, and refuses what it says already; gives the
 * contact its width. */
ovr_status ovr_resolve_element_keys(ovr_resolved *r, ovr_error *err);

/* Makes the element, once modulus and load are known; its nominal contact:
 * radius, speeds and load. */
ovr_status ovr_resolve_element(ovr_resolved *r, ovr_error *err);

/* Its histories of load, speed, sliding and radii, once the contact is there.
 */
ovr_status ovr_resolve_element_histories(ovr_resolved *r, ovr_error *err);

/* The passes of a bearing's rollers, before those of the case are checked. */
ovr_status ovr_resolve_element_passes(ovr_resolved *r, ovr_error *err);

/* It has a way of its own, from beginning to end: a run in time. */
bool ovr_element_moves(const ovr_resolved *r);

void ovr_resolved_element_free(ovr_resolved *r);

#endif
