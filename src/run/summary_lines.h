/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lines of a summary, as those who make them put them: a key and a value
 * for programs, a label and words for people, or both. */
#ifndef OVR_RUN_SUMMARY_LINES_H
#define OVR_RUN_SUMMARY_LINES_H

#include "base/given.h"
#include "overroll/run.h"

/* Who takes the lines. */
typedef struct ovr_told {
    ovr_summary_taker *take;
    void *data;
} ovr_told;

void ovr_put(const ovr_told *to, const char *key, ovr_summary_form form,
             double value);
void ovr_put_number(const ovr_told *to, const char *key, double value);
void ovr_put_count(const ovr_told *to, const char *key, double value);
void ovr_put_text(const ovr_told *to, const char *key, const char *text);

/* Takes lines for an ovr_told, which has those with a key alone. */
ovr_summary_taker ovr_put_keyed;

/* A number, and in SI where there is a key for it. */
void ovr_put_both(const ovr_told *to, const char *key, const char *key_si,
                  double value, double scale);

/* These stand in reports alone: a label and words, a title, which has a line of
 * its own, and a number with so many digits and words behind it. */
void ovr_tell(const ovr_told *to, const char *label, const char *format, ...)
    OVR_PRINTF(3, 4);
void ovr_tell_title(const ovr_told *to, const char *format, ...)
    OVR_PRINTF(2, 3);
void ovr_tell_number(const ovr_told *to, const char *label, int digits,
                     double value, const char *format, ...) OVR_PRINTF(5, 6);

/* The numbers of a contact, before it is solved with words for people; what was
 * foreseen of a film of rough surfaces, by key. */
void ovr_put_contact(const ovr_told *to, const ovr_contact *contact,
                     bool before);
void ovr_put_rough_film(const ovr_told *to, const ovr_rough_film *film,
                        const ovr_contact *contact);

/* Words that grow. */
typedef struct ovr_words {
    char text[400];
} ovr_words;
void ovr_words_add(ovr_words *to, const char *format, ...) OVR_PRINTF(2, 3);

/* "X = 0.4 (12.3 um)" */
void ovr_words_place(ovr_words *to, const char *name, double value,
                     ovr_unit_kind kind, const ovr_contact *contact);

/* The words behind a number of a row: itself in SI, where it is known; where
 * and when that is, NAN: not told; its note. */
ovr_words ovr_words_behind(double value, const ovr_observable *row, double X,
                           double T, const ovr_contact *contact);

#endif
