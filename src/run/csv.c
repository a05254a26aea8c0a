/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/csv.h"

#include <errno.h>
#include <math.h>
#include <string.h>

void ovr_csv_text(FILE *to, const char *text)
{
    if (!text[strcspn(text, ",\"\n")]) {
        fputs(text, to);
        return;
    }
    fputc('"', to);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', to);
        fputc(*text, to);
    }
    fputc('"', to);
}

void ovr_csv_number(FILE *to, double value, int digits)
{
    if (!isnan(value))
        fprintf(to, "%.*g", digits, value);
}

ovr_status ovr_csv_end(FILE *to, const char *path, ovr_error *err)
{
    bool good = to && !ferror(to);
    if (to && fclose(to) != 0)
        good = false;
    return good ? OVR_OK
                : ovr_fail(err, to ? OVR_IO : OVR_BAD_INPUT,
                           "%s: cannot be written: %s", path, strerror(errno));
}

char *ovr_csv_cell(char **at, bool *last)
{
    char *from = *at + strspn(*at, " \t"), *to = from, *p = from;
    bool quoted = *p == '"';
    if (quoted)
        p++;
    for (; *p; p++) {
        if (quoted && p[0] == '"' && p[1] == '"')
            p++;
        else if (quoted && *p == '"') {
            quoted = false;
            continue;
        } else if (!quoted && (*p == ',' || *p == '\n' || *p == '\r'))
            break;
        *to++ = *p;
    }
    *last = *p != ',';
    while (*p == '\r')
        p++;
    *at = *p ? p + 1 : p;
    while (to > from && (to[-1] == ' ' || to[-1] == '\t'))
        to--;
    *to = '\0';
    return from;
}

const char *ovr_csv_unit(char *head)
{
    char *unit = strpbrk(head, "[("), *end = unit;
    if (!unit || !strchr("])", head[strlen(head) - 1]))
        return "";
    while (end > head && end[-1] == ' ')
        end--;
    *end = '\0';
    unit++;
    unit[strcspn(unit, "])")] = '\0';
    return unit;
}
