/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/text.h"

#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* -------------------------------------------------------------- encoding */

static unsigned unit16(const unsigned char *p, bool big)
{
    return big ? (unsigned)(p[0] << 8 | p[1]) : (unsigned)(p[1] << 8 | p[0]);
}

static size_t put_utf8(char *out, unsigned c)
{
    if (c < 0x80) {
        out[0] = (char)c;
        return 1;
    }
    if (c < 0x800) {
        out[0] = (char)(0xC0 | c >> 6);
        out[1] = (char)(0x80 | (c & 0x3F));
        return 2;
    }
    out[0] = (char)(0xE0 | c >> 12); /* halves of surrogate pairs stay so: */
    out[1] = (char)(0x80 | (c >> 6 & 0x3F)); /* they are only quoted */
    out[2] = (char)(0x80 | (c & 0x3F));
    return 3;
}

static ovr_status from_utf16(ovr_bytes content, bool big, const char *file,
                             ovr_arena *arena, ovr_bytes *decoded,
                             ovr_error *err)
{
    size_t units = (content.size - 2) / 2, used = 0;
    const unsigned char *in = (const unsigned char *)content.data + 2;
    char *out = ovr_arena_take(arena, units, 3, err);
    if (!out)
        return OVR_NO_MEMORY;
    if (content.size % 2)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "UTF-16 text of an odd number of bytes (%zu): the "
                           "file is cut off",
                           content.size);
    for (size_t i = 0; i < units; i++)
        used += put_utf8(out + used, unit16(in + 2 * i, big));
    *decoded = (ovr_bytes){out, used};
    return OVR_OK;
}

ovr_status ovr_decode(ovr_bytes content, const char *file, ovr_arena *arena,
                      ovr_bytes *decoded, const char **encoding, ovr_error *err)
{
    const unsigned char *p = (const unsigned char *)content.data;
    *decoded = content;
    *encoding = "";
    if (content.size >= 2 &&
        ((p[0] == 0xFF && p[1] == 0xFE) || (p[0] == 0xFE && p[1] == 0xFF))) {
        *encoding = "UTF-16";
        return from_utf16(content, p[0] == 0xFE, file, arena, decoded, err);
    }
    if (content.size >= 3 && p[0] == 0xEF && p[1] == 0xBB && p[2] == 0xBF) {
        *encoding = "UTF-8 with mark";
        decoded->data += 3;
        decoded->size -= 3;
    }
    return OVR_OK;
}

/* ----------------------------------------------------------------- lines */

ovr_lines ovr_lines_of(ovr_bytes content)
{
    return (ovr_lines){content.data, content.data + content.size, 0};
}

/* Behind the line end at p: CR...CR LF is one, a lone CR too. */
static const char *behind_end(const char *p, const char *end)
{
    const char *q = p;
    while (q < end && *q == '\r')
        q++;
    if (q < end && *q == '\n')
        return q + 1;
    return p + 1;
}

bool ovr_next_line(ovr_lines *lines, ovr_line *line)
{
    const char *p = lines->at;
    if (p >= lines->end)
        return false;
    while (p < lines->end && *p != '\n' && *p != '\r')
        p++;
    *line = (ovr_line){lines->at, (size_t)(p - lines->at), ++lines->number};
    lines->at = p < lines->end ? behind_end(p, lines->end) : p;
    return true;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

ovr_line ovr_trim(ovr_line line)
{
    while (line.size && is_blank(line.text[0]))
        line.text++, line.size--;
    while (line.size && is_blank(line.text[line.size - 1]))
        line.size--;
    return line;
}

bool ovr_line_starts(ovr_line line, const char *word)
{
    size_t n = strlen(word);
    return line.size >= n && memcmp(line.text, word, n) == 0;
}

static bool is_space(char c)
{
    return is_blank(c) || c == 0;
}

bool ovr_next_piece(ovr_line *rest, ovr_line *piece)
{
    size_t from = 0, to;
    while (from < rest->size && is_space(rest->text[from]))
        from++;
    for (to = from; to < rest->size && !is_space(rest->text[to]);)
        to++;
    *piece = (ovr_line){rest->text + from, to - from, rest->number};
    rest->text += to;
    rest->size -= to;
    return piece->size > 0;
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool ovr_line_is(ovr_line line, const char *word)
{
    if (strlen(word) != line.size)
        return false;
    for (size_t i = 0; i < line.size; i++)
        if (lower(line.text[i]) != lower(word[i]))
            return false;
    return true;
}

/* --------------------------------------------------------------- numbers */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Copies [sign] digits [point digits] [exponent] into `out` with the
 * locale's point; false if the piece is anything else. */
static bool canonical(ovr_line piece, bool comma, char *out, size_t room)
{
    const char *p = piece.text, *end = p + piece.size;
    char point = localeconv()->decimal_point[0];
    size_t digits = 0, used = 0;
    if (piece.size + 1 > room)
        return false;
    if (p < end && (*p == '+' || *p == '-'))
        out[used++] = *p++;
    for (; p < end && is_digit(*p); digits++)
        out[used++] = *p++;
    if (p < end && (*p == '.' || (comma && *p == ',')))
        for (out[used++] = point, p++; p < end && is_digit(*p); digits++)
            out[used++] = *p++;
    if (!digits)
        return false;
    if (p < end && (lower(*p) == 'e' || lower(*p) == 'd')) {
        out[used++] = 'e', p++;
        if (p < end && (*p == '+' || *p == '-'))
            out[used++] = *p++;
        if (p == end)
            return false;
        while (p < end && is_digit(*p))
            out[used++] = *p++;
    }
    out[used] = 0;
    return p == end;
}

/* strtod follows the program's locale, files do not. */
bool ovr_number(ovr_line piece, bool comma, double *value)
{
    char text[128];
    if (!canonical(piece, comma, text, sizeof text))
        return false;
    *value = strtod(text, NULL);
    return isfinite(*value);
}

bool ovr_is_missing(ovr_line piece)
{
    static const char *const words[] = {"",    "nan",  "-nan",    "+nan",
                                        "bad", "---",  "***",     "na",
                                        "n/a", "null", "missing", "-"};
    for (size_t k = 0; k < sizeof words / sizeof words[0]; k++)
        if (ovr_line_is(piece, words[k]))
            return true;
    return false;
}

/* ----------------------------------------------------------------- units */

static const struct unit {
    const char *name;
    double metres;
} units[] = {
    {"m", 1},
    {"metre", 1},
    {"metres", 1},
    {"meter", 1},
    {"meters", 1},
    {"cm", 1e-2},
    {"mm", 1e-3},
    {"millimetre", 1e-3},
    {"millimetres", 1e-3},
    {"millimeter", 1e-3},
    {"millimeters", 1e-3},
    {"um", 1e-6},
    {"mum", 1e-6},
    {"micron", 1e-6},
    {"microns", 1e-6},
    {"micrometre", 1e-6},
    {"micrometres", 1e-6},
    {"micrometer", 1e-6},
    {"micrometers", 1e-6},
    {"nm", 1e-9},
    {"nanometre", 1e-9},
    {"nanometres", 1e-9},
    {"nanometer", 1e-9},
    {"nanometers", 1e-9},
    {"pm", 1e-12},
    {"angstrom", 1e-10},
    {"angstroms", 1e-10},
    {"inch", 0.0254},
    {"inches", 0.0254},
    {"mil", 2.54e-5},
    {"mils", 2.54e-5},
    {"uin", 2.54e-8},
    {"microinch", 2.54e-8},
    {"microinches", 2.54e-8},
};

/* Bytes of a micro sign at the start: UTF-8 (micro or Greek mu), Latin-1. */
static size_t micro(ovr_line piece)
{
    if (ovr_line_starts(piece, "\xC2\xB5") ||
        ovr_line_starts(piece, "\xCE\xBC"))
        return 2;
    return ovr_line_starts(piece, "\xB5") ? 1 : 0;
}

double ovr_length_unit(ovr_line piece, bool bracketed)
{
    char spelled[16];
    size_t sign = micro(piece);
    if (sign && piece.size - sign + 2 < sizeof spelled) {
        spelled[0] = 'u';
        memcpy(spelled + 1, piece.text + sign, piece.size - sign);
        piece = (ovr_line){spelled, piece.size - sign + 1, 0};
    }
    if (piece.size == 1 && piece.text[0] != 'm')
        return 0; /* M is mega */
    if (bracketed && ovr_line_is(piece, "in"))
        return 0.0254;
    for (size_t k = 0; k < sizeof units / sizeof units[0]; k++)
        if (ovr_line_is(piece, units[k].name))
            return units[k].metres;
    return 0;
}

const char *ovr_length_unit_name(double metres)
{
    for (size_t k = 0; k < sizeof units / sizeof units[0]; k++)
        if (units[k].metres == metres)
            return units[k].name;
    return "?";
}

ovr_quoted ovr_quote(ovr_line piece)
{
    ovr_quoted quoted;
    size_t room = sizeof quoted.text - 4, used = 0;
    while (piece.size && used < room) {
        size_t sign = micro(piece), taken = sign ? sign : 1;
        char c = sign ? 'u' : piece.text[0];
        quoted.text[used++] = c >= 32 && c < 127 ? c : '?';
        piece.text += taken;
        piece.size -= taken;
    }
    if (piece.size)
        memcpy(quoted.text + used, "...", 3), used += 3;
    quoted.text[used] = 0;
    return quoted;
}

static bool is_scaled(const char *unit, const char *scaled)
{
    return !strcmp(unit, scaled) ||
           (!strcmp(scaled, "b^2/R") && !strcmp(unit, "b2/R"));
}

ovr_status ovr_length_read(const char *text, const char *scaled,
                           ovr_length *length, ovr_error *err)
{
    size_t digits = strspn(text, " +-0123456789.");
    ovr_line unit;
    double metres;
    if (text[digits] == 'e' || text[digits] == 'E')
        digits += strspn(text + digits, "eE+-0123456789");
    unit = ovr_trim((ovr_line){text + digits, strlen(text + digits), 0});
    metres = ovr_length_unit(unit, true);
    if (!ovr_number(ovr_trim((ovr_line){text, digits, 0}), false,
                    &length->value))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a length with its unit is wanted, like '12 um'");
    length->unit = !unit.size                     ? OVR_LENGTH_BARE
                   : is_scaled(unit.text, scaled) ? OVR_LENGTH_SCALED
                                                  : OVR_LENGTH_METRES;
    if (length->unit == OVR_LENGTH_METRES && !(metres > 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "unknown unit '%s'; m, mm, um, nm, inch, ..., or %s is "
                        "wanted",
                        ovr_quote(unit).text, scaled);
    if (length->unit == OVR_LENGTH_METRES)
        length->value *= metres;
    return OVR_OK;
}
