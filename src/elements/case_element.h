/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [gear], [cam] and [roller_bearing]: contact data that they determine instead
 * of [contact] and the time histories. */
#ifndef OVR_ELEMENTS_CASE_ELEMENT_H
#define OVR_ELEMENTS_CASE_ELEMENT_H

#include "case/resolve.h"

/* Fills the section of the machine element and rejects keys that it determines;
 * sets the contact's width. */
ovr_status ovr_resolve_element_keys(ovr_resolved *r, ovr_error *err);

/* Creates the machine element once modulus and load are known, and sets its
 * reference contact: radius, speeds and load. */
ovr_status ovr_resolve_element(ovr_resolved *r, ovr_error *err);

/* Creates its histories of load, speed, sliding and radii once the contact is
 * known. */
ovr_status ovr_resolve_element_histories(ovr_resolved *r, ovr_error *err);

/* Sets the passes of a bearing's rollers, before those of the case are
 * checked. */
ovr_status ovr_resolve_element_passes(ovr_resolved *r, ovr_error *err);

/* True if the element moves along a path from beginning to end: a transient
 * run. */
bool ovr_element_moves(const ovr_resolved *r);

void ovr_resolved_element_free(ovr_resolved *r);

#endif
