/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/lines.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "overroll/profile.h"

enum { USUAL_DIGITS = 6 };

static void give(const ovr_told *to, const ovr_summary_line *line)
{
    to->take(to->data, line);
}

void ovr_put(const ovr_told *to, const char *key, ovr_summary_form form,
             double value)
{
    give(to, &(ovr_summary_line){.key = key, .form = form, .number = value});
}

void ovr_put_number(const ovr_told *to, const char *key, double value)
{
    ovr_put(to, key, OVR_SUMMARY_NUMBER, value);
}

void ovr_put_count(const ovr_told *to, const char *key, double value)
{
    ovr_put(to, key, OVR_SUMMARY_COUNT, value);
}

void ovr_put_text(const ovr_told *to, const char *key, const char *text)
{
    give(to, &(ovr_summary_line){.key = key,
                                 .form = OVR_SUMMARY_TEXT,
                                 .number = NAN,
                                 .text = text});
}

void ovr_put_keyed(void *told, const ovr_summary_line *line)
{
    if (line->key)
        give(told, line);
}

void ovr_put_both(const ovr_told *to, const char *key, const char *key_si,
                  double value, double scale)
{
    ovr_put_number(to, key, value);
    if (key_si)
        ovr_put_number(to, key_si, value * scale);
}

/* -------------------------------------------------------------- for people */

static void say(const ovr_told *to, const char *label, int digits, double value,
                const char *text)
{
    give(to, &(ovr_summary_line){.form = digits ? OVR_SUMMARY_WORDS_BEHIND
                                                : OVR_SUMMARY_WORDS,
                                 .number = value,
                                 .text = text,
                                 .label = label,
                                 .digits = digits});
}

#define FORMATTED(words, format)                                               \
    ovr_words words;                                                           \
    va_list args;                                                              \
    va_start(args, format);                                                    \
    vsnprintf((words).text, sizeof(words).text, format, args);                 \
    va_end(args)

void ovr_tell(const ovr_told *to, const char *label, const char *format, ...)
{
    FORMATTED(words, format);
    say(to, label, 0, NAN, words.text);
}

void ovr_tell_title(const ovr_told *to, const char *format, ...)
{
    FORMATTED(words, format);
    say(to, NULL, 0, NAN, words.text);
}

void ovr_tell_number(const ovr_told *to, const char *label, int digits,
                     double value, const char *format, ...)
{
    FORMATTED(words, format);
    say(to, label, digits ? digits : USUAL_DIGITS, value, words.text);
}

void ovr_words_add(ovr_words *to, const char *format, ...)
{
    size_t used = strlen(to->text);
    va_list args;
    va_start(args, format);
    vsnprintf(to->text + used, sizeof to->text - used, format, args);
    va_end(args);
}

/* ------------------------------------------------------------------ in SI */

/* "12.3 um": films in um, pressures in GPa, times in ms, lengths as they are;
 * "" where nothing is known in SI. */
static ovr_piece in_si(double value, ovr_unit_kind kind,
                       const ovr_contact *contact)
{
    double si = value * ovr_kind_scale(kind, contact);
    ovr_piece p = {""};
    if (!isfinite(si))
        return p;
    if (kind == OVR_KIND_HEIGHT)
        snprintf(p.text, sizeof p.text, "%.4g um", si * 1e6);
    else if (kind == OVR_KIND_PRESSURE)
        snprintf(p.text, sizeof p.text, "%.4g GPa", si * 1e-9);
    else if (kind == OVR_KIND_TIME)
        snprintf(p.text, sizeof p.text, "%.4g ms", si * 1e3);
    else if (kind == OVR_KIND_LENGTH)
        p = ovr_metres(si);
    else if (kind == OVR_KIND_FORCE)
        snprintf(p.text, sizeof p.text, "%.4g N/m", si);
    else if (kind == OVR_KIND_POWER)
        snprintf(p.text, sizeof p.text, "%.4g W/m", si);
    else if (kind == OVR_KIND_TEMPERATURE)
        snprintf(p.text, sizeof p.text, "K");
    return p;
}

void ovr_words_place(ovr_words *to, const char *name, double value,
                     ovr_unit_kind kind, const ovr_contact *contact)
{
    const double rounding = 1e-12; /* of a node's place at X = 0 */
    double shown = fabs(value) < rounding ? 0 : value;
    ovr_piece si = in_si(shown, kind, contact);
    ovr_words_add(to, "%s = %.4g", name, shown);
    if (*si.text)
        ovr_words_add(to, " (%s)", si.text);
}

ovr_words ovr_words_behind(double value, const ovr_observable *row, double X,
                           double T, const ovr_contact *contact)
{
    const char *note = row->note;
    ovr_words w = {""};
    ovr_piece si = in_si(value, row->kind, contact);
    bool placed = isfinite(X) || isfinite(T);
    ovr_words_add(&w, "%s%s", si.text,
                  *si.text && (placed || note) ? "  " : "");
    if (isfinite(X))
        ovr_words_place(&w, "at X", X, OVR_KIND_LENGTH, contact);
    if (isfinite(T))
        ovr_words_place(&w, isfinite(X) ? ", T" : "at T", T, OVR_KIND_TIME,
                        contact);
    if (note)
        ovr_words_add(&w, "%s%s", placed ? ", " : "", note);
    return w;
}
