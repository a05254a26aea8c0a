/* SPDX-License-Identifier: GPL-3.0-or-later */

#include "run/summary_lines.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "overroll/profile.h"

/* -------------------------------------------------------------------- Lines */

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

/* ------------------------------------------------------------------ Contact */

typedef struct scale {
    const char *key, *label; /* NULL: not for people */
    double value, unit;      /* of the line for people */
    const char *symbol;
    bool before; /* told before a case is solved, not of what came out */
} scale;

static void put_scale(const ovr_told *to, const scale *s, bool before)
{
    if (before && s->label && isfinite(s->value))
        ovr_tell(to, s->label, "%.6g %s", s->value / s->unit, s->symbol);
    if (before || !s->before)
        ovr_put_number(to, s->key, s->value);
}

void ovr_put_contact(const ovr_told *to, const ovr_contact *c, bool before)
{
    const scale rows[] = {
        {"M", "M", c->M, 1, "", false},
        {"L", "L", c->L, 1, "", false},
        {"lambda", "lambda", c->lambda, 1, "", false},
        {"alphabar", "alphabar", c->alphabar, 1, "", false},
        {"u1_ratio", "u1/um", c->u1_ratio, 1, "", true},
        {"u2_ratio", "u2/um", c->u2_ratio, 1, "", true},
        {"hertz_pressure_Pa", "Hertzian pressure ph", c->ph, 1e9, "GPa", false},
        {"half_width_m", "half width b", c->b, 1e-6, "um", false},
        {"film_scale_m", "film scale b^2/R", c->height, 1e-6, "um", false},
        {"time_scale_s", "time scale b/um", c->time, 1e-6, "us", false},
        {"load_N_per_m", "load", c->load, 1e3, "kN/m", false},
        {"mean_speed_m_per_s", "mean speed um", c->um, 1, "m/s", false},
        {"load_N", "force over the width", c->load * c->width, 1, "N", true},
        {"radius_m", "reduced radius R", c->radius, 1e-3, "mm", true},
        {"modulus_Pa", "reduced modulus E'", c->modulus, 1e9, "GPa", true},
        {"viscosity_Pa_s", "viscosity eta0", c->viscosity, 1e-3, "mPa.s", true},
        {"alpha_per_Pa", NULL, c->alpha, 1, "", true}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        put_scale(to, &rows[k], before);
}
