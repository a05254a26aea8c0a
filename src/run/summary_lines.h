/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines of summaries and reports: a key and a value for programs, or a label
 * and text for people.  Rows of reports have the columns quantity, value, unit,
 * position, time and a remark in parentheses. */
#ifndef OVR_RUN_SUMMARY_LINES_H
#define OVR_RUN_SUMMARY_LINES_H

#include "base/given.h"
#include "overroll/run.h"

/* The receiver of the lines. */
typedef struct ovr_report_sink {
    ovr_summary_taker *take;
    void *data;
} ovr_report_sink;

void ovr_put(const ovr_report_sink *to, const char *key, ovr_summary_form form,
             double value);
void ovr_put_number(const ovr_report_sink *to, const char *key, double value);
void ovr_put_count(const ovr_report_sink *to, const char *key, double value);
void ovr_put_text(const ovr_report_sink *to, const char *key, const char *text);

/* Forwards lines that have a key to the ovr_report_sink in `data`. */
ovr_summary_taker ovr_put_keyed;

/* Adds a number, and its SI value under `key_si` unless that is NULL. */
void ovr_put_both(const ovr_report_sink *to, const char *key,
                  const char *key_si, double value, double scale);

/* Print lines of reports: a label and text (ovr_report_detail: in complete
 * lists only), a title, and a number with `digits` digits (0: 6) followed by
 * text. */
void ovr_report_line(const ovr_report_sink *to, const char *label,
                     const char *format, ...) OVR_PRINTF(3, 4);
void ovr_report_detail(const ovr_report_sink *to, const char *label,
                       const char *format, ...) OVR_PRINTF(3, 4);
void ovr_report_title(const ovr_report_sink *to, const char *format, ...)
    OVR_PRINTF(2, 3);
void ovr_report_number(const ovr_report_sink *to, const char *label, int digits,
                       double value, const char *format, ...) OVR_PRINTF(5, 6);

/* Writes an empty line and a title over the columns of the rows that follow. */
void ovr_report_heading(const ovr_report_sink *to, bool times,
                        const char *title);

/* Adds the numbers of a contact (with printed text if `before` the solution),
 * and the predictions for rough surfaces by key. */
void ovr_put_contact(const ovr_report_sink *to, const ovr_contact *contact,
                     bool before);
void ovr_put_rough_film(const ovr_report_sink *to, const ovr_rough_film *film,
                        const ovr_contact *contact);

/* Passes the lines of ovr_stress_summary that a run of this case can have;
 * their values have no meaning. */
void ovr_stress_keys(const ovr_setup *setup, ovr_summary_taker *take,
                     void *data);

/* Text buffer for appending. */
typedef struct ovr_words {
    char text[400];
} ovr_words;
void ovr_words_add(ovr_words *to, const char *format, ...) OVR_PRINTF(2, 3);

/* Appends "X = 0.4 (12.3 um)". */
void ovr_words_place(ovr_words *to, const char *name, double value,
                     ovr_unit_kind kind, const ovr_contact *contact);

/* Returns the columns after the value of a quantity.  X and T may be NAN; the
 * remark contains the numbers in SI, the note of the row and `more`. */
ovr_words ovr_words_columns(double value, const ovr_observable *row, double X,
                            double T, const ovr_contact *contact,
                            const char *more);

/* Returns the same columns for a number without a row. */
ovr_words ovr_words_unit(const char *unit, const char *format, ...)
    OVR_PRINTF(2, 3);

/* The label of a number of ovr_put_contact; NULL: no such number. */
const char *ovr_contact_label(const char *key);

#endif
