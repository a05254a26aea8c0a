/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "overroll/text.h"

/* ------------------------------------------------------------------- locale */

locale_t ovr_plain_begin(void)
{
    locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    return plain ? uselocale(plain) : (locale_t)0;
}

void ovr_plain_end(locale_t before)
{
    if (before)
        freelocale(uselocale(before));
}

int ovr_utf8_sequence(const unsigned char *s)
{
    if (!s)
        return 0;
    int n = s[0] < 0x80 ? 1 : s[0] < 0xe0 ? 2 : s[0] < 0xf0 ? 3 : 4;
    if (n > 1 && (s[0] < 0xc2 || s[0] > 0xf4))
        return 0;
    for (int i = 1; i < n; i++)
        if ((s[i] & 0xc0) != 0x80)
            return 0;
    if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] > 0x9f) ||
        (s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] > 0x8f))
        return 0; /* overlong, surrogates, beyond U+10FFFF */
    return n;
}

/* -------------------------------------------------------------- encoding */

static unsigned unit16(const unsigned char *p, bool big)
{
    return big ? (unsigned)(p[0] << 8 | p[1]) : (unsigned)(p[1] << 8 | p[0]);
}

static size_t encode_utf8(char *out, unsigned c)
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
    out[0] = (char)(0xE0 | c >> 12); /* halves of surrogate pairs are kept: */
    out[1] = (char)(0x80 | (c >> 6 & 0x3F)); /* they are only used in
                                              * quotations */
    out[2] = (char)(0x80 | (c & 0x3F));
    return 3;
}

static ovr_status from_utf16(ovr_bytes *content, bool big, const char *file,
                             ovr_arena *arena, ovr_error *err)
{
    size_t units = (content->size - 2) / 2, used = 0;
    const unsigned char *in = (const unsigned char *)content->data + 2;
    char *out = ovr_arena_take(arena, units, 3, err);
    if (!out)
        return OVR_NO_MEMORY;
    if (content->size % 2)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "UTF-16 text has an odd number of bytes (%zu): "
                           "the file is truncated",
                           content->size);
    for (size_t i = 0; i < units; i++)
        used += encode_utf8(out + used, unit16(in + 2 * i, big));
    *content = (ovr_bytes){out, used};
    return OVR_OK;
}

ovr_status ovr_decode(ovr_bytes *content, const char *file, ovr_arena *arena,
                      const char **encoding, ovr_error *err)
{
    const unsigned char *p = (const unsigned char *)content->data;
    *encoding = "";
    if (content->size >= 2 &&
        ((p[0] == 0xFF && p[1] == 0xFE) || (p[0] == 0xFE && p[1] == 0xFF))) {
        *encoding = "UTF-16";
        return from_utf16(content, p[0] == 0xFE, file, arena, err);
    }
    if (content->size >= 3 && p[0] == 0xEF && p[1] == 0xBB && p[2] == 0xBF) {
        *encoding = "UTF-8 with mark";
        content->data += 3;
        content->size -= 3;
    }
    return OVR_OK;
}

/* ----------------------------------------------------------------- lines */

ovr_lines ovr_lines_of(ovr_bytes content)
{
    return (ovr_lines){content.data, content.data + content.size, 0};
}

/* Returns the position after the line end at p: CR...CR LF is one line end, and
 * so is a single CR. */
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

static const char *skip_digits(const char *s, const char *end)
{
    while (s < end && *s >= '0' && *s <= '9')
        s++;
    return s;
}

/* Returns the end of [+-] digits [. digits] [e [+-] digits], or NULL. */
static const char *number_end(const char *s, const char *end, char point,
                              const char *exponents)
{
    const char *from, *after, *digits;
    s += s < end && (*s == '+' || *s == '-');
    from = s;
    s = after = skip_digits(s, end);
    if (s < end && (*s == '.' || *s == point))
        s = skip_digits(s + 1, end);
    if (s - from == (s > after)) /* no digits on either side */
        return NULL;
    if (s == end || !*s || !strchr(exponents, *s))
        return s;
    digits = s + 1;
    digits += digits < end && (*digits == '+' || *digits == '-');
    return skip_digits(digits, end) > digits ? skip_digits(digits, end) : s;
}

/* Converts like strtod, with a decimal point in every locale. */
static bool convert(const char *from, const char *end, double *value)
{
    char copy[128];
    size_t length = (size_t)(end - from);
    locale_t before;
    if (length >= sizeof copy)
        return false;
    for (size_t k = 0; k < length; k++)
        copy[k] = from[k] == ',' ? '.' : lower(from[k]) == 'd' ? 'e' : from[k];
    copy[length] = '\0';
    before = ovr_plain_begin();
    *value = strtod(copy, NULL);
    ovr_plain_end(before);
    return isfinite(*value);
}

static bool is_zero(const char *s, const char *end)
{
    for (; s < end && *s != 'e' && *s != 'E'; s++)
        if (*s >= '1' && *s <= '9')
            return false;
    return true;
}

bool ovr_read_number(const char **text, double *value)
{
    const char *from = *text, *stop = from + strlen(from);
    const char *end = number_end(from, stop, '.', "eE");
    if (!end || !convert(from, end, value) ||
        (*value == 0 && !is_zero(from, end)))
        return false;
    *text = end;
    return true;
}

bool ovr_number(ovr_line piece, bool comma, double *value)
{
    const char *end = piece.text + piece.size;
    return number_end(piece.text, end, comma ? ',' : '.', "eEdD") == end &&
           convert(piece.text, end, value);
}

bool ovr_is_missing(ovr_line piece)
{
    static const char *const words[] = {
        "",        "nan",      "-nan",    "+nan",    "nan(ind)", "-nan(ind)",
        "1.#QNAN", "-1.#QNAN", "1.#IND",  "-1.#IND", "1.#INF",   "-1.#INF",
        "1.#SNAN", "-1.#SNAN", "bad",     "na",      "n/a",      "#n/a",
        "#na",     "#value!",  "#div/0!", "#num!",   "null",     "missing",
        "inf",     "-inf",     "+inf",    "invalid", "none"};
    size_t same = 0; /* the same character repeated: "-", "--", "*****" */
    while (same < piece.size && piece.text[same] == piece.text[0] &&
           (piece.text[0] == '-' || piece.text[0] == '*'))
        same++;
    if (same && same == piece.size)
        return true;
    for (size_t k = 0; k < sizeof words / sizeof words[0]; k++)
        if (ovr_line_is(piece, words[k]))
            return true;
    return false;
}

/* ----------------------------------------------------------------- units */

/* Returns the bytes of a micro sign at the start: UTF-8 (micro or Greek mu),
 * Latin-1. */
static size_t micro(ovr_line piece)
{
    if (ovr_line_starts(piece, "\xC2\xB5") ||
        ovr_line_starts(piece, "\xCE\xBC"))
        return 2;
    return ovr_line_starts(piece, "\xB5") ? 1 : 0;
}

ovr_line ovr_spelled(ovr_line unit, char buffer[16])
{
    size_t sign = micro(unit), rest = unit.size - sign;
    if (!sign || rest >= 15)
        return unit;
    buffer[0] = 'u';
    memcpy(buffer + 1, unit.text + sign, rest);
    return (ovr_line){buffer, rest + 1, unit.number};
}

/* Writes the first character of a piece to `to` as UTF-8. Returns its bytes
 * there; *taken becomes its bytes in the piece. Bytes from 0xA0 on that are not
 * UTF-8 are read as Latin-1. Control characters become '?'. */
static size_t copy_character(ovr_line piece, char to[4], size_t *taken)
{
    unsigned char s[5] = {0};
    memcpy(s, piece.text, piece.size < 4 ? piece.size : 4);
    int n = ovr_utf8_sequence(s);
    bool control = n == 2 && s[0] == 0xc2 && s[1] < 0xa0;
    *taken = n > 1 ? (size_t)n : 1;
    if (n > 1 && !control) {
        memcpy(to, s, (size_t)n);
        return (size_t)n;
    }
    if (n == 0 && s[0] >= 0xa0) {
        to[0] = (char)(s[0] < 0xc0 ? 0xc2 : 0xc3);
        to[1] = (char)(0x80 | (s[0] & 0x3f));
        return 2;
    }
    to[0] = n == 1 && s[0] >= 32 && s[0] < 127 ? (char)s[0] : '?';
    return 1;
}

int ovr_control_bytes(const char *s, bool has_lines)
{
    unsigned char c = (unsigned char)s[0], next = c ? (unsigned char)s[1] : 0;
    if (!c || (has_lines && (c == '\n' || c == '\t' || c == '\r')))
        return 0;
    if (c < 0x20 || c == 0x7f)
        return 1;
    return c == 0xc2 && next >= 0x80 && next < 0xa0 ? 2 : 0;
}

char *ovr_escaped(const char *text, bool has_lines, ovr_arena *arena)
{
    static const char digits[] = "0123456789abcdef";
    const unsigned char *s = (const unsigned char *)text;
    char *copy, *to;
    size_t size = 1;
    for (const char *c = text; *c; c++)
        size += ovr_control_bytes(c, has_lines) ? 8 : 1;
    to = copy = ovr_arena_take(arena, size, 1, NULL);
    while (copy && *s) {
        int control = ovr_control_bytes((const char *)s, has_lines);
        if (!control)
            *to++ = (char)*s++;
        for (; control > 0; control--, s++) {
            *to++ = '\\';
            *to++ = 'x';
            *to++ = digits[*s >> 4];
            *to++ = digits[*s & 15];
        }
    }
    if (copy)
        *to = 0;
    return copy;
}

ovr_quoted ovr_quote(ovr_line piece)
{
    ovr_quoted quoted;
    size_t capacity = sizeof quoted.text - 4, used = 0;
    while (piece.size && used < capacity) {
        char character[4] = {'u'};
        size_t sign = micro(piece), taken = sign, bytes = 1;
        if (!sign)
            bytes = copy_character(piece, character, &taken);
        if (used + bytes > capacity)
            break;
        memcpy(quoted.text + used, character, bytes);
        used += bytes;
        piece.text += taken;
        piece.size -= taken;
    }
    if (piece.size)
        memcpy(quoted.text + used, "...", 3), used += 3;
    quoted.text[used] = 0;
    return quoted;
}

const char *ovr_article(const char *word)
{
    return *word && strchr("aeiou", *word) ? "an" : "a";
}
