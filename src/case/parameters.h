/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The table of all parameters: the sections of case/keys in order. It
 * determines parsing, defaults, ranges, help, the manual page, JSON and the
 * attributes in result files.
 */
#ifndef OVR_CASE_PARAMETERS_H
#define OVR_CASE_PARAMETERS_H

#include "base/parameter.h"

/* Returns row k of all sections, NULL past the end; *section (unless NULL)
 * becomes its section. */
const ovr_parameter *ovr_parameter_row(size_t k, const ovr_section **section);

/* Return sections in order; NULL past the end. */
const ovr_section *ovr_section_row(size_t k);
const ovr_section *ovr_section_find(const char *name);

/* Returns the number of rows in the sections before this one. */
size_t ovr_section_first(const ovr_section *section);

/* "b", "b^2/R", "b/um", "ph" or "". */
const char *ovr_hertzian_name(ovr_hertzian hertzian);

/* Returns the unit in which the limits of a number are stated, or "": angles
 * have "deg". *value becomes the value of 1 unit in the unit of the row. */
const char *ovr_limit_unit(const ovr_parameter *row, double *value);

/* Returns the row of a key in a section, or NULL. */
const ovr_parameter *ovr_parameter_find(const ovr_section *section,
                                        const char *key);

/* Quantity that a usual symbol or name ("E", "entrainment_speed") stands
 * for. */
typedef struct ovr_symbol {
    const char *section, *key;
    const char *name; /* name of the quantity */
    const char *path; /* "section.key" */
} ovr_symbol;

/* Returns NULL if the symbol is unknown. */
const ovr_symbol *ovr_symbol_find(const char *symbol);

/* Returns the header of the section ("body 1") that has `word` as a synonym, or
 * NULL. */
const char *ovr_section_by_synonym(const char *word);

#endif
