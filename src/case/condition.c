/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/condition.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "surface/feature.h"

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

void ovr_condition_add(char *text, size_t capacity, const char *format, ...)
{
    size_t used = strlen(text);
    va_list args;
    va_start(args, format);
    vsnprintf(text + used, capacity - used, format, args);
    va_end(args);
}

/* "ramp | step | sine" as "ramp, step or sine". */
static void put_words(const char *words, char *text, size_t capacity)
{
    char word[OVR_CONDITION_MAX];
    for (int k = 0; ovr_condition_next(&words, " | ", word, sizeof word); k++)
        ovr_condition_add(text, capacity, "%s%s",
                          !k       ? ""
                          : *words ? ", "
                                   : " or ",
                          word);
}

/* "history = ramp, step or sine", "[heat] model = lobatto", "every above 0". */
static void put_alternative(const char *from, char *text, size_t capacity)
{
    size_t key = *from == '[' ? strlen(from) : strcspn(from, " ");
    size_t section = strcspn(from, ". ");
    const char *rest = from + key + strspn(from + key, " ");
    if (section < key)
        ovr_condition_add(text, capacity, "[%.*s] %.*s", (int)section, from,
                          (int)(key - section - 1), from + section + 1);
    else
        ovr_condition_add(text, capacity, "%.*s", (int)key, from);
    if (*rest == '>')
        ovr_condition_add(text, capacity, " above%s", rest + 1);
    else if (*rest == '!')
        ovr_condition_add(text, capacity, " other than%s", rest + 2);
    else if (!strncmp(rest, "==", 2))
        ovr_condition_add(text, capacity, " =%s", rest + 2);
    else if (*rest == '=') {
        ovr_condition_add(text, capacity, " = ");
        put_words(rest + 2, text, capacity);
    }
}

void ovr_condition_text(const char *condition, char *text, size_t capacity)
{
    char from[OVR_CONDITION_MAX];
    for (int k = 0; ovr_condition_next(&condition, " or ", from, sizeof from);
         k++) {
        bool absent = !strncmp(from, "no ", 3);
        ovr_condition_add(text, capacity, "%s%s", k ? " or " : "",
                          absent ? "no " : "");
        put_alternative(from + 3 * absent, text, capacity);
    }
}

/* "shape = dent | bump": those that have a size. */
static void put_shapes(const char *size, char *text, size_t capacity)
{
    ovr_condition_add(text, capacity, "shape = ");
    for (int k = 0; ovr_shape_name(k); k++)
        if (ovr_shape_has(k, size))
            ovr_condition_add(text, capacity, "%s%s",
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
        put_shapes(row->key, shapes, sizeof shapes);
        ovr_condition_add(shapes, sizeof shapes, "%s%s", of ? "; " : "",
                          of ? of : "");
        when = shapes;
    }
    while (ovr_condition_next(&when, "; ", condition, sizeof condition)) {
        char *arrow = strstr(condition, OVR_ONLY_WHERE);
        const char *part = arrow ? arrow + strlen(OVR_ONLY_WHERE) : condition;
        ovr_condition_add(text, capacity, "%s", *text ? " and " : "");
        ovr_condition_text(part, text, capacity);
        if (!arrow)
            continue;
        *arrow = '\0';
        ovr_condition_add(text, capacity, " where ");
        ovr_condition_text(condition, text, capacity);
    }
}
