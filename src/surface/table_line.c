/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/table_line.h"
#include "base/quantity.h"

#include <string.h>

/* ---------------------------------------------------------------- fields */

static bool has(ovr_line line, char c)
{
    return line.size && memchr(line.text, c, line.size);
}

/* True if a comma is within quotation marks, as in "0,5","1,2". */
static bool has_quoted_comma(ovr_line line)
{
    bool inside = false;
    for (size_t k = 0; k < line.size; k++) {
        inside ^= line.text[k] == '"';
        if (inside && line.text[k] == ',')
            return true;
    }
    return false;
}

/* Determines separator and decimal point. A comma is a decimal point if another
 * character separates: always with semicolons, with tabs if no field has a
 * point, and in quotes. Next to points and tabs, a comma separates. */
ovr_layout ovr_layout_of(ovr_line line)
{
    line = ovr_trim(line);
    if (has(line, ';'))
        return (ovr_layout){';', true};
    if (has(line, '\t') && !(has(line, '.') && has(line, ',')))
        return (ovr_layout){'\t', !has(line, '.')};
    return (ovr_layout){has(line, ',') ? ',' : ' ', has_quoted_comma(line)};
}

static bool is_separator(char c, char separator)
{
    return separator == ' ' ? c == ' ' || c == '\t' : c == separator;
}

static ovr_line unquoted(ovr_line field)
{
    field = ovr_trim(field);
    if (field.size >= 2 && field.text[0] == '"' &&
        field.text[field.size - 1] == '"')
        field = ovr_trim(
            (ovr_line){field.text + 1, field.size - 2, field.number});
    return field;
}

bool ovr_next_field(ovr_line *rest, char separator, ovr_line *field)
{
    const char *p = rest->text, *end = p ? p + rest->size : NULL, *from = p;
    bool quoted;
    if (!p)
        return false;
    while (p < end && (*p == ' ' || (*p == '\t' && separator != '\t')))
        p++;
    quoted = p < end && *p == '"' && memchr(p + 1, '"', (size_t)(end - p - 1));
    if (quoted)
        p = (const char *)memchr(p + 1, '"', (size_t)(end - p - 1)) + 1;
    while (p < end && !is_separator(*p, separator))
        p++;
    *field = unquoted((ovr_line){from, (size_t)(p - from), rest->number});
    while (separator == ' ' && p + 1 < end && is_separator(p[1], ' '))
        p++;
    if (p >= end)
        rest->text = NULL;
    else
        *rest = (ovr_line){p + 1, (size_t)(end - p - 1), rest->number};
    return true;
}

bool ovr_split(ovr_line line, char separator, ovr_fields *fields)
{
    ovr_line rest = separator == ' ' ? ovr_trim(line) : line, field;
    fields->count = 0;
    while (ovr_next_field(&rest, separator, &field)) {
        if (fields->count == OVR_HEADER_FIELDS_MAX)
            return false;
        fields->field[fields->count++] = field;
    }
    fields->open = fields->count > 1 &&
                   fields->field[fields->count - 1].size == 0;
    fields->count -= fields->open;
    return true;
}

size_t ovr_count_numbers(ovr_line line, ovr_layout layout)
{
    ovr_line rest = layout.separator == ' ' ? ovr_trim(line) : line, field;
    size_t fields = 0, numbers = 0;
    bool open = false;
    double value;
    while (ovr_next_field(&rest, layout.separator, &field)) {
        if (ovr_number(field, layout.comma, &value))
            numbers++;
        else if (!ovr_is_missing(field))
            return 0;
        open = fields++ && !field.size;
    }
    return numbers ? fields - open : 0;
}

/* ----------------------------------------------------------------- words */

typedef struct words {
    ovr_line rest;
    const char *begin; /* start of the text that contains them */
} words;

static bool in_word(char c)
{
    unsigned char u = (unsigned char)c;
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z') || u >= 0x80 || c == '^' || c == '.';
}

static bool next_word(words *w, ovr_line *word)
{
    const char *p = w->rest.text, *end = p + w->rest.size, *from;
    while (p < end && !in_word(*p))
        p++;
    from = p;
    while (p < end && in_word(*p))
        p++;
    if (from == p)
        return false;
    *word = (ovr_line){from, (size_t)(p - from), w->rest.number};
    w->rest = (ovr_line){p, (size_t)(end - p), w->rest.number};
    return true;
}

static bool bracketed(const words *w, ovr_line word)
{
    return word.text > w->begin && strchr("[(", word.text[-1]) && word.text[-1];
}

static char axis_of(ovr_line word)
{
    static const struct {
        const char *name;
        char axis;
    } names[] = {{"x", 'x'},        {"lateral", 'x'},   {"distance", 'x'},
                 {"position", 'x'}, {"pos", 'x'},       {"length", 'x'},
                 {"z", 'z'},        {"height", 'z'},    {"raw", 'z'},
                 {"profile", 'z'},  {"depth", 'z'},     {"amplitude", 'z'},
                 {"heights", 'z'},  {"roughness", 'z'}, {"y", 'y'},
                 {"y1", 'y'},       {"z1", 'z'},        {"x1", 'x'},
                 {"valid", 'v'},    {"validity", 'v'}};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++)
        if (ovr_line_is(word, names[k].name))
            return names[k].axis;
    return 0;
}

/* ---------------------------------------------------------------- header */

/* True for "in b" and "in b^2/R", the contact's own units as written by
 * ovr_profile_save. */
static bool scaled_unit(const words *w, ovr_line word)
{
    bool in = word.text - w->begin >= 3 && memcmp(word.text - 3, "in ", 3) == 0;
    if (!in && !bracketed(w, word))
        return false;
    if (ovr_line_is(word, "b^2"))
        return w->rest.size >= 2 && memcmp(w->rest.text, "/R", 2) == 0;
    return word.size == 1 && word.text[0] == 'b';
}

/* True for words in the name of an axis that are not units. */
static bool is_plain_word(ovr_line word)
{
    static const char *const plain[] = {"axis",      "coordinate", "data",
                                        "direction", "value",      "values"};
    for (size_t k = 0; k < sizeof plain / sizeof plain[0]; k++)
        if (ovr_line_is(word, plain[k]))
            return true;
    return false;
}

/* True for "[furlong]", "in furlong", or the single word after an axis. */
static bool looks_like_unit(const words *w, ovr_line word, char axis)
{
    const char *p = word.text;
    if (axis_of(word) || is_plain_word(word))
        return false;
    if (bracketed(w, word))
        return true;
    if (p - w->begin >= 3 && memcmp(p - 3, "in ", 3) == 0)
        return true;
    return axis && !ovr_trim(w->rest).size;
}

/* Reads the heading of a column: "Lateral um", "x in nm", "X_(microns)",
 * "[mm]". Uses the first word that names an axis and the last that is a unit. A
 * field with a number ("step 5 um") is no heading. */
static ovr_column read_field(ovr_line field)
{
    ovr_column column = {.from = field};
    words w = {field, field.text};
    ovr_line word;
    double number;
    if (ovr_line_is(field, "[1/0]") || ovr_line_is(field, "1/0"))
        return (ovr_column){.axis = 'v', .from = field};
    while (next_word(&w, &word)) {
        double metres = ovr_length_unit(word, bracketed(&w, word));
        bool scaled = scaled_unit(&w, word);
        if (ovr_number(word, false, &number))
            return (ovr_column){.from = field};
        if (metres > 0 || scaled) {
            column.metres = scaled ? 1 : metres;
            column.scaled = scaled;
        } else if (looks_like_unit(&w, word, column.axis)) {
            column.unknown = word;
        } else if (!column.axis) {
            column.axis = axis_of(word);
        }
    }
    return column;
}

static void learn(ovr_column *column, ovr_column now)
{
    if (now.axis)
        column->axis = now.axis;
    if (now.metres > 0) {
        column->metres = now.metres;
        column->scaled = now.scaled;
        column->from = now.from;
    } else if (!(column->metres > 0) &&
               (now.axis || now.unknown.size || !column->from.size)) {
        column->unknown = now.unknown;
        column->from = now.from;
    }
}

/* An assignment in a header: "unit_x = um", "Z unit: nm", "units mm" or
 * "spacing = 0.5 um". */
typedef struct statement {
    bool unit, spacing;
    char axis;
    double metres, number;
    ovr_line unknown; /* last unrecognized word after = or : */
} statement;

static bool behind_sign(ovr_line line, ovr_line word)
{
    const char *p = word.text;
    while (p > line.text && (p[-1] == ' ' || p[-1] == '\t'))
        p--;
    return p > line.text && (p[-1] == '=' || p[-1] == ':');
}

static statement understand(ovr_line line)
{
    statement s = {0};
    words w = {line, line.text};
    ovr_line word;
    while (next_word(&w, &word)) {
        double metres = ovr_length_unit(word, bracketed(&w, word)), value;
        s.unit |= ovr_line_is(word, "unit") || ovr_line_is(word, "units");
        s.spacing |= ovr_line_is(word, "spacing") || ovr_line_is(word, "dx") ||
                     ovr_line_is(word, "increment");
        if (axis_of(word))
            s.axis = axis_of(word);
        else if (ovr_number(word, false, &value))
            s.number = value;
        else if (metres > 0)
            s.metres = metres;
        else if (behind_sign(line, word))
            s.unknown = word;
    }
    return s;
}

static bool read_statement(ovr_header *header, ovr_line line)
{
    statement s = understand(line);
    ovr_column said = {.metres = s.metres, .from = line, .unknown = s.unknown};
    if (s.spacing && s.number > 0) {
        header->spacing = s.number;
        header->spacing_metres = s.metres;
    }
    for (size_t k = 0; s.unit && k < header->columns; k++) {
        char own = header->column[k].axis;
        if (!own && header->columns <= 2)
            own = k + 1 < header->columns ? 'x' : 'z';
        if (!s.axis || s.axis == own || (s.axis == 'y' && own == 'z'))
            learn(&header->column[k], said);
    }
    return s.unit || s.spacing;
}

/* Reads the size of a map as written by Gwyddion: "Width: 40 um", "Height: 20
 * um", "Value units: m". */
static bool read_map_size(ovr_header *header, ovr_line line)
{
    const struct {
        const char *name;
        double *metres;
    } sizes[] = {{"Width:", &header->width},
                 {"Height:", &header->height},
                 {"Value units:", &header->value_metres}};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        size_t length = strlen(sizes[k].name);
        bool unit = sizes[k].metres == &header->value_metres;
        double number = 1, metres;
        ovr_line rest, word;
        if (!ovr_line_starts(line, sizes[k].name))
            continue;
        rest = ovr_trim(
            (ovr_line){line.text + length, line.size - length, line.number});
        if (!unit && (!ovr_next_piece(&rest, &word) ||
                      !ovr_number(word, false, &number)))
            return false;
        metres = ovr_length_unit(ovr_trim(rest), true);
        if (!(metres > 0) || !(number > 0))
            return false;
        *sizes[k].metres = number * metres;
        return true;
    }
    return false;
}

/* Reads headings in words, "x [mm]   z [um]": the line must have as many units
 * or axes as columns. */
static void read_words(ovr_header *header, ovr_line line)
{
    size_t units = 0, axes = 0;
    ovr_column found[OVR_HEADER_FIELDS_MAX];
    words w = {line, line.text};
    ovr_line word;
    double number;
    memset(found, 0, sizeof found);
    while (next_word(&w, &word)) {
        double metres = ovr_length_unit(word, bracketed(&w, word));
        char axis = axis_of(word);
        if (ovr_number(word, false, &number))
            return;
        if (metres > 0 && units++ < header->columns)
            found[units - 1].metres = metres, found[units - 1].from = line;
        else if (axis && axes++ < header->columns)
            found[axes - 1].axis = axis;
    }
    for (size_t k = 0; k < header->columns; k++) {
        if (axes != header->columns)
            found[k].axis = 0;
        if (units != header->columns)
            found[k].metres = 0;
        learn(&header->column[k], found[k]);
    }
}

/* True if the number of fields matches that of columns. Fewer are accepted if
 * the line ends with a separator (the last columns have no name), more if they
 * are empty. */
static bool fits(const ovr_fields *fields, size_t columns)
{
    size_t named = fields->count;
    while (named && !fields->field[named - 1].size)
        named--;
    if (fields->count == columns)
        return true;
    return named > 1 && named <= columns &&
           (fields->open || named < fields->count);
}

static bool split_as(const ovr_header *header, ovr_line line, char separator,
                     ovr_fields *fields)
{
    const char tried[] = {separator, ',', ';', '\t'};
    for (size_t k = 0; k < sizeof tried; k++)
        if (tried[k] != ' ' && ovr_split(line, tried[k], fields) &&
            fits(fields, header->columns))
            return true;
    return false;
}

static size_t count_quotes(ovr_line line)
{
    size_t count = 0;
    for (size_t k = 0; k < line.size; k++)
        count += line.text[k] == '"';
    return count;
}

/* Removes characters that begin a comment, and the quotation marks around a
 * whole line, but not those around its first field. */
static ovr_line uncommented(ovr_line line)
{
    line = ovr_trim(line);
    while (line.size && line.text[0] && strchr("#%\"*", line.text[0])) {
        const size_t quotes = *line.text == '"' ? count_quotes(line) : 1;
        const ovr_line inside = unquoted(line);
        if (quotes == 2 && inside.size < line.size)
            line = inside;
        else if (quotes % 2 == 0)
            break;
        else
            line = ovr_trim(
                (ovr_line){line.text + 1, line.size - 1, line.number});
    }
    return line;
}

void ovr_header_line(ovr_header *header, ovr_line line, char separator)
{
    ovr_fields fields;
    line = uncommented(line);
    if (!line.size)
        return;
    if (read_map_size(header, line) || header->columns > OVR_HEADER_FIELDS_MAX)
        return;
    if (header->columns == 1) { /* name just above the data */
        if (read_statement(header, line))
            header->stated |= header->column[0].metres > 0;
        else if (!header->stated)
            header->column[0] = read_field(line);
    } else if (split_as(header, line, separator, &fields)) {
        for (size_t k = 0; k < header->columns && k < fields.count; k++)
            learn(&header->column[k], read_field(fields.field[k]));
    } else if (!read_statement(header, line)) {
        read_words(header, line);
    }
}
