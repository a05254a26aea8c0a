/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The one table of parameters: the sections of case/keys, one behind the other.
 * It drives parsing, defaults, ranges, help, the manual page, JSON and the
 * attributes in result files.
 */
#ifndef OVR_CASE_PARAMETERS_H
#define OVR_CASE_PARAMETERS_H

#include "base/parameter.h"

/* The k-th row of all sections, NULL behind the last; *section (or NULL) is the
 * one it belongs to. */
const ovr_parameter *ovr_parameter_row(size_t k, const ovr_section **section);

/* Sections in order; NULL behind the last. */
const ovr_section *ovr_section_row(size_t k);
const ovr_section *ovr_section_find(const char *name);

/* The number of rows that the sections before it have. */
size_t ovr_section_first(const ovr_section *section);

/* "b", "b^2/R", "b/um", "ph" or "". */
const char *ovr_hertzian_name(ovr_hertzian hertzian);

/* The row of a key in a section, or NULL. */
const ovr_parameter *ovr_parameter_find(const ovr_section *section,
                                        const char *key);

/* The quantity that a usual symbol or name ("E", "entrainment_speed") means. */
typedef struct ovr_symbol {
    const char *section, *key;
    const char *name; /* of the quantity */
    const char *path; /* "section.key" */
} ovr_symbol;

/* Returns NULL if the symbol is unknown. */
const ovr_symbol *ovr_symbol_find(const char *symbol);

/* Returns the header of the section ("body 1") that `word` is another name of,
 * or NULL. */
const char *ovr_section_by_synonym(const char *word);

#endif
