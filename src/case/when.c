/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Evaluates the conditions under which a key has an effect (base/parameter.h).
 * A given key without effect is rejected as a user error.
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/case.h"
#include "case/when.h"
#include "surface/feature.h"

/* ------------------------------------------------------- Conditions as text */

bool ovr_condition_next(const char **text, const char *separator, char *piece,
                        size_t capacity)
{
    const char *end = strstr(*text, separator);
    size_t length = end ? (size_t)(end - *text) : strlen(*text);
    if (!**text)
        return false;
    snprintf(piece, capacity, "%.*s", (int)length, *text);
    *text += length + (end ? strlen(separator) : 0);
    return true;
}

/* Appends to a text. */
OVR_PRINTF(3, 4)
static void condition_add(char *text, size_t capacity, const char *format, ...)
{
    size_t used = strlen(text);
    va_list args;
    va_start(args, format);
    vsnprintf(text + used, capacity - used, format, args);
    va_end(args);
}

/* Writes "ramp | step | sine" as "ramp, step or sine". */
static void write_words(const char *words, char *text, size_t capacity)
{
    char word[OVR_CONDITION_MAX];
    for (int k = 0; ovr_condition_next(&words, " | ", word, sizeof word); k++)
        condition_add(text, capacity, "%s%s",
                      !k       ? ""
                      : *words ? ", "
                               : " or ",
                      word);
}

/* Writes a condition: "history = ramp, step or sine", "[heat] model = lobatto",
 * "every above 0". */
static void write_alternative(const char *from, char *text, size_t capacity)
{
    size_t key = *from == '[' ? strlen(from) : strcspn(from, " ");
    size_t section = strcspn(from, ". ");
    const char *rest = from + key + strspn(from + key, " ");
    if (section < key)
        condition_add(text, capacity, "[%.*s] %.*s", (int)section, from,
                      (int)(key - section - 1), from + section + 1);
    else
        condition_add(text, capacity, "%.*s", (int)key, from);
    if (*rest == '>')
        condition_add(text, capacity, " above%s", rest + 1);
    else if (*rest == '!')
        condition_add(text, capacity, " other than%s", rest + 2);
    else if (!strncmp(rest, "==", 2))
        condition_add(text, capacity, " =%s", rest + 2);
    else if (*rest == '=') {
        condition_add(text, capacity, " = ");
        write_words(rest + 2, text, capacity);
    }
}

/* Appends a condition as text, "[heat] model = lobatto or history = ramp, step
 * or sine". */
static void condition_text(const char *condition, char *text, size_t capacity)
{
    char from[OVR_CONDITION_MAX];
    for (int k = 0; ovr_condition_next(&condition, " or ", from, sizeof from);
         k++) {
        bool absent = !strncmp(from, "no ", 3);
        condition_add(text, capacity, "%s%s", k ? " or " : "",
                      absent ? "no " : "");
        write_alternative(from + 3 * absent, text, capacity);
    }
}

/* Writes "shape = dent | bump" with the shapes that have a size. */
static void write_shapes(const char *size, char *text, size_t capacity)
{
    condition_add(text, capacity, "shape = ");
    for (int k = 0; ovr_shape_name(k); k++)
        if (ovr_shape_has(k, size))
            condition_add(text, capacity, "%s%s",
                          text[strlen(text) - 1] == ' ' ? "" : " | ",
                          ovr_shape_name(k));
}

void ovr_when_text(const ovr_parameter *row, char *text, size_t capacity)
{
    const char *when = row->when ? row->when : "";
    char condition[OVR_CONDITION_MAX], shapes[OVR_CONDITION_MAX] = "";
    text[0] = '\0';
    if (!strcmp(when, OVR_BY_SHAPE)) {
        const char *of = ovr_size_of_what(row->key);
        write_shapes(row->key, shapes, sizeof shapes);
        condition_add(shapes, sizeof shapes, "%s%s", of ? "; " : "",
                      of ? of : "");
        when = shapes;
    }
    while (ovr_condition_next(&when, "; ", condition, sizeof condition)) {
        char *arrow = strstr(condition, OVR_ONLY_WHERE);
        const char *part = arrow ? arrow + strlen(OVR_ONLY_WHERE) : condition;
        condition_add(text, capacity, "%s", *text ? " and " : "");
        condition_text(part, text, capacity);
        if (!arrow)
            continue;
        *arrow = '\0';
        condition_add(text, capacity, " where ");
        condition_text(condition, text, capacity);
    }
}

/* ------------------------------------------------------ Keys without effect */

/* One alternative of a condition, parsed. */
typedef struct alternative {
    const ovr_section *section;
    const ovr_slot *slot;
    const char *rest; /* after the key: "= words", "> number" or "" */
    bool absent;      /* the key must not be given */
} alternative;

/* Parses "[stress]" (without "no"): a section as a key that is given or not. */
static alternative parse_section(const ovr_case *c, const ovr_block *own,
                                 const char *text, bool absent)
{
    static const ovr_slot there = {.given = true}, missing = {.number = NAN};
    char name[OVR_NAME_MAX];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(text + 1, "]"), text + 1);
    const ovr_block *block = ovr_case_find_block(c, name, NULL);
    return (alternative){.section = own->section,
                         .slot = ovr_block_is_there(block) ? &there : &missing,
                         .rest = "",
                         .absent = absent};
}

static alternative parse_alternative(const ovr_case *c, const ovr_block *own,
                                     const char *text)
{
    /* for a section with names that has no block */
    static const ovr_slot nothing = {.number = NAN};
    const ovr_block *block = own;
    bool absent = !strncmp(text, "no ", 3);
    const char *where = text + 3 * absent;
    if (*where == '[')
        return parse_section(c, own, where, absent);
    char name[2 * OVR_NAME_MAX], *key = name;
    size_t length = strcspn(where, " ");
    snprintf(name, sizeof name, "%.*s", (int)length, where);
    if (strchr(name, '.')) {
        key = strchr(name, '.');
        *key++ = '\0';
        block = ovr_case_find_block(c, name, NULL);
    }
    return (alternative){.section = block ? block->section : own->section,
                         .slot = block ? ovr_block_get(block, key) : &nothing,
                         .rest = where + length + strspn(where + length, " "),
                         .absent = absent};
}

static bool is_one_of(const char *text, const char *words)
{
    char word[OVR_NAME_MAX];
    while (ovr_condition_next(&words, " | ", word, sizeof word))
        if (!strcmp(word, text))
            return true;
    return false;
}

static bool holds(const alternative *a)
{
    if (*a->rest == '>')
        return a->slot->number > strtod(a->rest + 1, NULL);
    if (!strncmp(a->rest, "==", 2))
        return a->slot->number == strtod(a->rest + 2, NULL);
    if (*a->rest == '!')
        return a->slot->number != strtod(a->rest + 2, NULL);
    if (*a->rest == '=')
        return a->slot->text && is_one_of(a->slot->text, a->rest + 2);
    return a->slot->given != a->absent;
}

/* True if any alternative of a condition holds. *off is set if a false
 * alternative is the switch of its section. */
static bool any_holds(const ovr_case *c, const ovr_block *block,
                      const char *condition, bool *off)
{
    char text[OVR_CONDITION_MAX];
    *off = false;
    while (ovr_condition_next(&condition, " or ", text, sizeof text)) {
        alternative a = parse_alternative(c, block, text);
        if (holds(&a))
            return true;
        *off = *off || (a.section->on && a.slot->key &&
                        !strcmp(a.section->on, a.slot->key));
    }
    return false;
}

/* Returns the required condition: of "A => B" B if A holds; NULL if nothing is
 * required. */
static const char *required_condition(const ovr_case *c, const ovr_block *block,
                                      const char *condition)
{
    const char *arrow = strstr(condition, OVR_ONLY_WHERE);
    char where[OVR_CONDITION_MAX];
    bool off;
    if (!arrow)
        return condition;
    snprintf(where, sizeof where, "%.*s", (int)(arrow - condition), condition);
    return any_holds(c, block, where, &off) ? arrow + strlen(OVR_ONLY_WHERE)
                                            : NULL;
}

/* A condition that is false. */
typedef struct failing {
    char condition[OVR_CONDITION_MAX];
    bool off; /* about the switch of a section */
} failing;

/* Returns the first false condition; false if all are true. */
static bool first_failing(const ovr_case *c, const ovr_block *block,
                          const char *when, failing *first)
{
    char whole[OVR_CONDITION_MAX];
    while (when && ovr_condition_next(&when, "; ", whole, sizeof whole)) {
        const char *part = required_condition(c, block, whole);
        if (!part || any_holds(c, block, part, &first->off))
            continue;
        snprintf(first->condition, sizeof first->condition, "%s", part);
        return true;
    }
    return false;
}

/* True if the conditions hold, written as in a row. */
static bool conditions_hold(const ovr_case *c, const ovr_block *block,
                            const char *when)
{
    failing first;
    return !first_failing(c, block, when, &first);
}

/* Returns the conditions of a row. Sizes of a shape are checked by the shape's
 * own table. */
static const char *conditions_of(const ovr_parameter *row)
{
    bool shape = row->when && !strcmp(row->when, OVR_BY_SHAPE);
    return shape ? ovr_size_of_what(row->key) : row->when;
}

bool ovr_key_applies(const ovr_case *c, const ovr_block *block,
                     const ovr_parameter *row)
{
    return (!block->section->whole || ovr_block_is_there(block)) &&
           conditions_hold(c, block, conditions_of(row));
}

/* Writes the explanation: "has no effect with history = constant; it needs
 * history = ramp or step", "has no effect together with [contact] modulus
 * without [stress]". */
static void write_idle(const ovr_case *c, const ovr_block *block,
                       const char *condition, char *text, size_t capacity)
{
    alternative a = parse_alternative(c, block, condition);
    bool one = !strstr(condition, " or "), other = a.section != block->section;
    text[0] = '\0';
    condition_add(text, capacity, "has no effect");
    if (a.absent && !a.slot->key) /* a section */
        condition_add(text, capacity, " beside %.*s",
                      (int)strcspn(condition + 3, " "), condition + 3);
    else if (a.absent)
        condition_add(text, capacity, " beside %s%s%s%s", other ? "[" : "",
                      other ? a.section->name : "", other ? "] " : "",
                      a.slot->key);
    if (a.absent && !one)
        condition = strstr(condition, " or ") + 4;
    if (a.absent && one)
        return;
    if (one && *a.rest && a.slot->text)
        condition_add(text, capacity, " with %s%s%s%s = %.40s; it needs ",
                      other ? "[" : "", other ? a.section->name : "",
                      other ? "] " : "", a.slot->key, a.slot->text);
    else
        condition_add(text, capacity, " without ");
    condition_text(condition, text, capacity);
}

bool ovr_key_idle(const ovr_case *c, const ovr_block *block,
                  const ovr_slot *slot, ovr_idle *idle)
{
    const ovr_parameter *row = &block->section->rows[slot - block->slots];
    failing first;
    if (!slot->given || !first_failing(c, block, conditions_of(row), &first))
        return false;
    idle->said = first.off || slot->stored;
    write_idle(c, block, first.condition, idle->text, sizeof idle->text);
    return true;
}

ovr_status ovr_case_check_ineffective(const ovr_case *c, ovr_error *err)
{
    ovr_idle idle;
    for (const ovr_block *b = c->blocks; b; b = b->next)
        for (size_t k = 0; k < b->count; k++)
            if (ovr_key_idle(c, b, &b->slots[k], &idle) && !idle.said)
                return ovr_fail_slot(err, &b->slots[k], "%s", idle.text);
    return OVR_OK;
}
