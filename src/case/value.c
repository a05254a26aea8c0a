/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses the value of a key according to its row in the table. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "case/case.h"
#include "overroll/text.h"

/* ------------------------------------------------------------------ words */

static const ovr_word *find_word(const ovr_word *words, const char *text)
{
    for (; words && words->name; words++)
        if (!strcmp(words->name, text))
            return words;
    return NULL;
}

static const char *nearest_word(const ovr_word *words, const char *text)
{
    const char *names[32];
    size_t n = 0;
    for (; words && words->name && n < 32; words++)
        names[n++] = words->name;
    return ovr_suggest(text, names, n);
}

static void list_words(const ovr_word *words, char *list, size_t capacity)
{
    size_t used = 0;
    list[0] = '\0';
    for (; words && words->name && used < capacity; words++)
        used += (size_t)snprintf(list + used, capacity - used, "%s%s",
                                 used ? ", " : "", words->name);
}

static ovr_status unknown_word(const ovr_parameter *row, const char *text,
                               ovr_error *err)
{
    const char *meant = nearest_word(row->words, text);
    char list[300];
    list_words(row->words, list, sizeof list);
    if (meant) {
        ovr_fail(err, OVR_BAD_INPUT,
                 "unknown '%.40s'; did you mean '%s'? (allowed: %s)", text,
                 meant, list);
        return ovr_fail_meant(err, OVR_BAD_INPUT, meant);
    }
    return ovr_fail(err, OVR_BAD_INPUT, "unknown '%.40s'; allowed: %s", text,
                    list);
}

/* ---------------------------------------------------------------- numbers */

/* Writes a limit without an exponent: 1000000 instead of 1e+06. */
static void write_limit(char *text, size_t capacity, double limit)
{
    bool whole = limit == floor(limit) && fabs(limit) < 1e10;
    snprintf(text, capacity, whole ? "%.0f" : "%g", limit);
}

static void write_range(const ovr_parameter *row, char *text, size_t capacity)
{
    char minimum[32], maximum[32], words[200];
    double one;
    const char *unit = ovr_limit_unit(row, &one);
    write_limit(minimum, sizeof minimum, row->minimum / one);
    write_limit(maximum, sizeof maximum, row->maximum / one);
    list_words(row->words, words, sizeof words);
    snprintf(text, capacity, "%s%s %s %s%s%s%s%s", row->above ? "above " : "",
             minimum, row->above ? "and at most" : "to", maximum,
             *unit ? " " : "", unit, *words ? ", or " : "", words);
}

/* Describes the allowed values for messages. */
static void write_allowed(const ovr_parameter *row, char *text, size_t capacity)
{
    switch (row->kind) {
    case OVR_NUMBER:
    case OVR_INTEGER:
    case OVR_NUMBERS: write_range(row, text, capacity); break;
    case OVR_CHOICE:
    case OVR_WORDS: list_words(row->words, text, capacity); break;
    case OVR_FLAG: snprintf(text, capacity, "yes, no"); break;
    case OVR_TEXT: snprintf(text, capacity, "any text"); break;
    case OVR_PATH: snprintf(text, capacity, "the path of a file"); break;
    }
}

ovr_status ovr_range_check(const ovr_parameter *row, double number,
                           const char *text, ovr_error *err)
{
    bool low = row->above ? !(number > row->minimum)
                          : !(number >= row->minimum);
    char range[300];
    if (!low && number <= row->maximum)
        return OVR_OK;
    write_range(row, range, sizeof range);
    return ovr_fail(err, OVR_BAD_INPUT, "%s must be %s", text, range);
}

/* Checks the sign of a length, height or time with a unit; its range is checked
 * once the scales are known. */
static ovr_status check_sign(const ovr_parameter *row, double number,
                             const char *text, ovr_error *err)
{
    if (row->maximum < 0 && number >= 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s must be below 0", text);
    if ((row->minimum > 0 || (row->minimum == 0 && row->above)) && number <= 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s must be above 0", text);
    if (row->minimum == 0 && number < 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s must not be negative", text);
    return OVR_OK;
}

/* Removes a Hertzian unit: "0.6 b" is equal to 0.6. */
static const char *without_hertzian(const ovr_parameter *row, const char *text,
                                    char *buffer, size_t size)
{
    const char *unit = ovr_hertzian_name(row->hertzian), *at = text;
    double value;
    if (!*unit || !ovr_read_number(&at, &value))
        return text;
    size_t number = (size_t)(at - text);
    at += strspn(at, " \t");
    if (strcmp(at, unit) != 0 || number >= size)
        return text;
    snprintf(buffer, size, "%.*s", (int)number, text);
    return buffer;
}

static ovr_status read_quantity(const ovr_parameter *row, const char *text,
                                ovr_quantity *quantity, ovr_error *err)
{
    ovr_error why = {0};
    const char *meant;
    char range[300], number[80];
    text = without_hertzian(row, text, number, sizeof number);
    if (!ovr_quantity_read(text, row->dimension, row->hertzian, quantity, &why))
        return quantity->unit && row->hertzian
                   ? check_sign(row, quantity->value, text, err)
                   : ovr_range_check(row, quantity->value, text, err);
    meant = nearest_word(row->words, text);
    if (row->words && meant)
        return unknown_word(row, text, err);
    if (why.about) /* the unit is wrong: the message lists allowed ones */
        return ovr_fail_from(err, &why, NULL, 0);
    write_range(row, range, sizeof range);
    return ovr_fail(err, why.status, "%.500s; allowed: %s", why.message, range);
}

static ovr_status no_whole_number(const ovr_parameter *row, const char *text,
                                  ovr_error *err)
{
    char range[300];
    write_range(row, range, sizeof range);
    return ovr_fail(err, OVR_BAD_INPUT, "%s must be a whole number, %s", text,
                    range);
}

static ovr_status read_number(const ovr_parameter *row, const char *text,
                              ovr_slot *slot, ovr_error *err)
{
    const ovr_word *word = find_word(row->words, text);
    ovr_quantity quantity;
    slot->word = word != NULL;
    if (word) {
        slot->number = word->value;
        return OVR_OK;
    }
    if (read_quantity(row, text, &quantity, err))
        return OVR_BAD_INPUT;
    if (row->kind == OVR_INTEGER && quantity.value != floor(quantity.value))
        return no_whole_number(row, text, err);
    slot->number = quantity.value;
    slot->unit = quantity.unit;
    return OVR_OK;
}

static size_t count_items(const char *text)
{
    size_t n = 1;
    for (; *text; text++)
        n += *text == ',';
    return n;
}

/* Copies the next item without leading and trailing blanks and moves past
 * it. */
static void next_item(const char **text, const char *stops, char *item,
                      size_t capacity)
{
    size_t length = strcspn(*text, stops);
    ovr_line line = ovr_trim((ovr_line){*text, length, 0});
    *text += length + ((*text)[length] != '\0');
    snprintf(item, capacity, "%.*s", (int)line.size, line.text);
}

static ovr_status read_list(const ovr_parameter *row, const char *text,
                            ovr_arena *arena, ovr_slot *slot, ovr_error *err)
{
    size_t n = count_items(text);
    double *values = ovr_arena_take(arena, n, sizeof *values, err);
    if (!values)
        return OVR_NO_MEMORY;
    if (find_word(row->words, text)) /* a word instead of numbers */
        return OVR_OK;
    for (size_t i = 0; i < n; i++) {
        ovr_quantity quantity;
        char item[OVR_LINE_MAX + 2];
        next_item(&text, ",", item, sizeof item);
        if (read_quantity(row, item, &quantity, err))
            return OVR_BAD_INPUT;
        if (i && !quantity.unit != !slot->unit)
            return ovr_fail(err, OVR_BAD_INPUT,
                            "'%s': either all numbers of a list must have a "
                            "unit, or none",
                            item);
        slot->unit = quantity.unit;
        values[i] = quantity.value;
    }
    slot->list = (ovr_list){n, values};
    return OVR_OK;
}

/* ----------------------------------------------------------- other kinds */

static ovr_status read_words(const ovr_parameter *row, const char *text,
                             ovr_slot *slot, ovr_error *err)
{
    while (*text) {
        char item[OVR_LINE_MAX + 2];
        const ovr_word *word;
        next_item(&text, ", \t", item, sizeof item);
        if (!item[0])
            continue;
        word = find_word(row->words, item);
        if (!word)
            return unknown_word(row, item, err);
        slot->bits |= 1u << (word - row->words);
    }
    if (slot->bits)
        return OVR_OK;
    return unknown_word(row, text, err);
}

static ovr_status read_flag(const char *text, ovr_slot *slot, ovr_error *err)
{
    static const char *const words[] = {"no",   "yes", "false",
                                        "true", "off", "on"};
    for (int i = 0; i < 6; i++)
        if (!strcmp(words[i], text)) {
            slot->number = i % 2;
            return OVR_OK;
        }
    return ovr_fail(err, OVR_BAD_INPUT, "'%.40s' must be yes or no", text);
}

static ovr_status read_choice(const ovr_parameter *row, const char *text,
                              ovr_slot *slot, ovr_error *err)
{
    const ovr_word *word = find_word(row->words, text);
    if (!word)
        return unknown_word(row, text, err);
    slot->number = word->value;
    slot->word = true;
    return OVR_OK;
}

static ovr_status no_value(const ovr_parameter *row, ovr_error *err)
{
    char allowed[300];
    write_allowed(row, allowed, sizeof allowed);
    return ovr_fail(err, OVR_BAD_INPUT, "the value is missing; allowed: %s",
                    allowed);
}

/* Removes quotation marks: "b.h5" in quotes is b.h5. A single quotation mark at
 * the start is rejected, because it could not be written and read again. */
static ovr_status unquote(const char **text, ovr_arena *arena, ovr_error *err)
{
    size_t size = strlen(*text);
    char quote = **text, *inner;
    ovr_line line;
    if (quote != '"' && quote != '\'')
        return OVR_OK;
    line = ovr_trim((ovr_line){*text + 1, size > 1 ? size - 2 : 0, 0});
    if (size < 2 || (*text)[size - 1] != quote || !line.size ||
        *line.text == '"' || *line.text == '\'')
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s begins with a quote; allowed: text in a pair of "
                        "quotes, or without quotes",
                        *text);
    inner = ovr_arena_take(arena, line.size + 1, 1, err);
    if (!inner)
        return OVR_NO_MEMORY;
    memcpy(inner, line.text, line.size);
    *text = inner;
    return OVR_OK;
}

static ovr_status read_value(const ovr_parameter *row, const char *text,
                             ovr_arena *arena, ovr_slot *slot, ovr_error *err)
{
    if (!*text)
        return no_value(row, err);
    switch (row->kind) {
    case OVR_NUMBER:
    case OVR_INTEGER: return read_number(row, text, slot, err);
    case OVR_CHOICE: return read_choice(row, text, slot, err);
    case OVR_FLAG: return read_flag(text, slot, err);
    case OVR_NUMBERS: return read_list(row, text, arena, slot, err);
    case OVR_WORDS: return read_words(row, text, slot, err);
    case OVR_TEXT:
    case OVR_PATH: break;
    }
    return OVR_OK;
}

ovr_status ovr_slot_read(const ovr_parameter *row, const char *text,
                         ovr_arena *arena, ovr_slot *slot, ovr_error *err)
{
    ovr_slot fresh = {.key = row->key, .number = NAN};
    ovr_error why = {0};
    ovr_status status = OVR_OK;
    if (row->kind == OVR_TEXT || row->kind == OVR_PATH)
        status = unquote(&text, arena, &why);
    if (!status)
        status = read_value(row, text, arena, &fresh, &why);
    if (status == OVR_NO_MEMORY)
        return ovr_fail_from(err, &why, NULL, 0);
    if (status) {
        ovr_fail_about(err, row->key, "%s: %.900s", row->key, why.message);
        return ovr_fail_meant(err, status, why.meant);
    }
    fresh.text = ovr_arena_text(arena, text, err);
    if (!fresh.text)
        return OVR_NO_MEMORY;
    *slot = fresh;
    return OVR_OK;
}
