/* SPDX-License-Identifier: GPL-3.0-or-later */

#include "run/summary_lines.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "overroll/profile.h"

/* -------------------------------------------------------------------- Lines */

enum { USUAL_DIGITS = 6 };

static void send(const ovr_report_sink *to, const ovr_summary_line *line)
{
    to->take(to->data, line);
}

void ovr_put(const ovr_report_sink *to, const char *key, ovr_summary_form form,
             double value)
{
    send(to, &(ovr_summary_line){.key = key, .form = form, .number = value});
}

void ovr_put_number(const ovr_report_sink *to, const char *key, double value)
{
    ovr_put(to, key, OVR_SUMMARY_NUMBER, value);
}

void ovr_put_count(const ovr_report_sink *to, const char *key, double value)
{
    ovr_put(to, key, OVR_SUMMARY_COUNT, value);
}

void ovr_put_text(const ovr_report_sink *to, const char *key, const char *text)
{
    send(to, &(ovr_summary_line){.key = key,
                                 .form = OVR_SUMMARY_TEXT,
                                 .number = NAN,
                                 .text = text});
}

void ovr_put_keyed(void *told, const ovr_summary_line *line)
{
    if (line->key)
        send(told, line);
}

void ovr_put_both(const ovr_report_sink *to, const char *key,
                  const char *key_si, double value, double scale)
{
    ovr_put_number(to, key, value);
    if (key_si)
        ovr_put_number(to, key_si, value * scale);
}

/* -------------------------------------------------------------- for people */

static void send_words(const ovr_report_sink *to, const char *label, int digits,
                       double value, const char *text)
{
    send(to, &(ovr_summary_line){.form = digits ? OVR_SUMMARY_WORDS_BEHIND
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

void ovr_report_detail(const ovr_report_sink *to, const char *label,
                       const char *format, ...)
{
    FORMATTED(words, format);
    send(to, &(ovr_summary_line){.form = OVR_SUMMARY_WORDS,
                                 .number = NAN,
                                 .text = words.text,
                                 .label = label,
                                 .detail = true});
}

void ovr_report_line(const ovr_report_sink *to, const char *label,
                     const char *format, ...)
{
    FORMATTED(words, format);
    send_words(to, label, 0, NAN, words.text);
}

void ovr_report_title(const ovr_report_sink *to, const char *format, ...)
{
    FORMATTED(words, format);
    send_words(to, NULL, 0, NAN, words.text);
}

void ovr_report_number(const ovr_report_sink *to, const char *label, int digits,
                       double value, const char *format, ...)
{
    FORMATTED(words, format);
    send_words(to, label, digits ? digits : USUAL_DIGITS, value, words.text);
}

void ovr_report_heading(const ovr_report_sink *to, bool times,
                        const char *title)
{
    ovr_report_title(to, "%s", "");
    ovr_report_title(to, "%-*s %-12s %-11s %-10s%s", OVR_LABEL_WIDTH, title,
                     "value", "in units", "at X = x/b", times ? " at T" : "");
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

/* Returns a number in SI, "12.3 um": lengths with a prefix, pressures in GPa,
 * times in ms; "" if the SI value is unknown. */
static ovr_piece in_si(double value, ovr_unit_kind kind,
                       const ovr_contact *contact)
{
    double si = value * ovr_kind_scale(kind, contact);
    ovr_piece p = {""};
    if (!isfinite(si))
        return p;
    if (kind == OVR_KIND_HEIGHT || kind == OVR_KIND_LENGTH)
        p = ovr_metres(si);
    else if (kind == OVR_KIND_PRESSURE)
        snprintf(p.text, sizeof p.text, "%.4g GPa", si * 1e-9);
    else if (kind == OVR_KIND_TIME)
        snprintf(p.text, sizeof p.text, "%.4g ms", si * 1e3);
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
    const double rounding = 1e-12; /* of the coordinate X = 0 of a node */
    double shown = fabs(value) < rounding ? 0 : value;
    ovr_piece si = in_si(shown, kind, contact);
    ovr_words_add(to, "%s = %.4g", name, shown);
    if (*si.text)
        ovr_words_add(to, " (%s)", si.text);
}

/* Returns the symbol of a quantity's dimensionless unit. */
static const char *unit_of(const ovr_observable *row)
{
    switch (row->offset) {
    case offsetof(ovr_observation, load): return "p_h b";
    case offsetof(ovr_observation, mass_flow): return "u_m b^2/R";
    default: break;
    }
    switch (row->kind) {
    case OVR_KIND_LENGTH: return "b";
    case OVR_KIND_HEIGHT: return "b^2/R";
    case OVR_KIND_PRESSURE: return "p_h";
    case OVR_KIND_TIME: return "b/u_m";
    case OVR_KIND_FLOW: return "u_m b^2/R";
    case OVR_KIND_FORCE: return "p_h b^2/R";
    case OVR_KIND_POWER: return "u_m p_h b^2/R";
    case OVR_KIND_TEMPERATURE: return "K";
    default: return "";
    }
}

/* Appends "1.041 GPa at 12.3 um, 0.2 ms". */
static void add_si(ovr_words *remark, double value, const ovr_observable *row,
                   double X, double T, const ovr_contact *contact)
{
    ovr_piece si = in_si(value, row->kind, contact);
    ovr_piece x = in_si(X, OVR_KIND_LENGTH, contact);
    ovr_piece t = in_si(T, OVR_KIND_TIME, contact);
    if (*si.text && row->kind != OVR_KIND_TEMPERATURE)
        ovr_words_add(remark, "%s", si.text);
    if (*x.text || *t.text)
        ovr_words_add(remark, "%sat %s%s%s", *remark->text ? " " : "", x.text,
                      *x.text && *t.text ? ", " : "", t.text);
}

static void add_remark(ovr_words *remark, const char *text)
{
    if (text && *text)
        ovr_words_add(remark, "%s%s", *remark->text ? "; " : "", text);
}

static void trim(ovr_words *w)
{
    size_t n = strlen(w->text);
    while (n && w->text[n - 1] == ' ')
        w->text[--n] = '\0';
}

ovr_words ovr_words_columns(double value, const ovr_observable *row, double X,
                            double T, const ovr_contact *contact,
                            const char *more)
{
    const double rounding = 1e-12; /* of the coordinate X = 0 of a node */
    bool range = row->note && (!strncmp(row->note, "|X|", 3) ||
                               !strncmp(row->note, "X = ", 4));
    char at[16] = "", when[16] = "";
    ovr_words w = {""}, remark = {""};
    if (fabs(X) < rounding)
        X = 0;
    if (isfinite(X))
        snprintf(at, sizeof at, "%.4g", X);
    else if (range)
        snprintf(at, sizeof at, "%.15s", row->note + 4 * (*row->note == 'X'));
    if (isfinite(T))
        snprintf(when, sizeof when, " %-8.4g", T);
    add_si(&remark, value, row, X, T, contact);
    add_remark(&remark, range ? NULL : row->note);
    add_remark(&remark, more);
    ovr_words_add(&w, "%-11s %-10s%s", unit_of(row), at, when);
    if (*remark.text)
        ovr_words_add(&w, " (%.300s)", remark.text);
    trim(&w);
    return w;
}

ovr_words ovr_words_unit(const char *unit, const char *format, ...)
{
    FORMATTED(remark, format);
    ovr_words w = {""};
    ovr_words_add(&w, "%-11s %-10s", unit, "");
    if (*remark.text)
        ovr_words_add(&w, " (%.300s)", remark.text);
    trim(&w);
    return w;
}

/* ------------------------------------------------------------------ Contact */

typedef struct scale {
    const char *key, *label; /* label NULL: not printed */
    double value, unit;      /* in the unit of the printed line */
    const char *symbol;
    bool before; /* printed before the solve only */
    bool detail; /* not part of the summary */
} scale;

static void add_scale(const ovr_report_sink *to, const scale *s, bool before)
{
    if (before && s->label && isfinite(s->value)) {
        if (s->detail)
            ovr_report_detail(to, s->label, "%.6g%s%s", s->value / s->unit,
                              *s->symbol ? " " : "", s->symbol);
        else
            ovr_report_line(to, s->label, "%.6g%s%s", s->value / s->unit,
                            *s->symbol ? " " : "", s->symbol);
    }
    if (before || !s->before)
        ovr_put_number(to, s->key, s->value);
}

enum { SCALES = 17 };

static void contact_scales(const ovr_contact *c, scale rows[SCALES])
{
    const scale all[SCALES] = {
        {"M", "Moes' load number M", c->M, 1, "", false, false},
        {"L", "Moes' lubricant number L", c->L, 1, "", false, false},
        {"lambda", "dimensionless speed parameter", c->lambda, 1, "", false,
         true},
        {"alphabar", "alpha p_h", c->alphabar, 1, "", false, true},
        {"u1_ratio", "speed of surface 1, u1/u_m", c->u1_ratio, 1, "", true,
         false},
        {"u2_ratio", "speed of surface 2, u2/u_m", c->u2_ratio, 1, "", true,
         false},
        {"hertz_pressure_Pa", "maximum Hertzian pressure p_h", c->ph, 1e9,
         "GPa", false, false},
        {"half_width_m", "Hertzian half-width b", c->b, 1e-6, "um", false,
         false},
        {"film_scale_m", "film thickness unit b^2/R", c->height, 1e-6, "um",
         false, true},
        {"time_scale_s", "time unit b/u_m", c->time, 1e-6, "us", false, true},
        {"load_N_per_m", "load per unit width", c->load, 1e3, "kN/m", false,
         false},
        {"mean_speed_m_per_s", "entrainment speed u_m", c->um, 1, "m/s", false,
         false},
        {"load_N", "force over the width", c->load * c->width, 1, "N", true,
         false},
        {"radius_m", "reduced radius R", c->radius, 1e-3, "mm", true, true},
        {"modulus_Pa", "reduced modulus E'", c->modulus, 1e9, "GPa", true,
         true},
        {"viscosity_Pa_s", "viscosity eta0", c->viscosity, 1e-3, "mPa.s", true,
         true},
        {"alpha_per_Pa", NULL, c->alpha, 1, "", true, false}};
    memcpy(rows, all, sizeof all);
}

void ovr_put_contact(const ovr_report_sink *to, const ovr_contact *c,
                     bool before)
{
    scale rows[SCALES];
    contact_scales(c, rows);
    for (size_t k = 0; k < SCALES; k++)
        add_scale(to, &rows[k], before);
}

const char *ovr_contact_label(const char *key)
{
    const ovr_contact none = {0};
    scale rows[SCALES];
    contact_scales(&none, rows);
    for (size_t k = 0; k < SCALES; k++)
        if (!strcmp(rows[k].key, key))
            return rows[k].label;
    return NULL;
}
