/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/json.h"

#include <math.h>

#include "overroll/text.h"

/* ------------------------------------------------------------------- text */

static void write_plain(FILE *to, unsigned char c)
{
    switch (c) {
    case '"': fputs("\\\"", to); break;
    case '\\': fputs("\\\\", to); break;
    case '\n': fputs("\\n", to); break;
    case '\t': fputs("\\t", to); break;
    case '\r': fputs("\\r", to); break;
    default:
        if (c < 0x20 || c == 0x7f)
            fprintf(to, "\\u%04x", c);
        else
            fputc(c, to);
    }
}

static void write_text(FILE *to, const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    fputc('"', to);
    while (*s) {
        int n = ovr_utf8_sequence(s);
        if (n == 0) {
            fputs("\\ufffd", to);
            s++;
        } else if (n == 1) {
            write_plain(to, *s++);
        } else {
            while (n--)
                fputc(*s++, to);
        }
    }
    fputc('"', to);
}

static void write_number(FILE *to, double value)
{
    if (isfinite(value))
        fprintf(to, "%.17g", value);
    else
        fputs("null", to);
}

/* -------------------------------------------------------------- structure */

static void key_of(json_writer *json, const char *key)
{
    if (!json->first)
        fputc(',', json->to);
    json->first = false;
    if (!key) {
        fputc(' ', json->to);
        return;
    }
    fputc('\n', json->to);
    for (int i = 0; i < json->depth; i++)
        fputs("  ", json->to);
    write_text(json->to, key);
    fputs(": ", json->to);
}

static void open_with(json_writer *json, const char *key, char bracket)
{
    key_of(json, key);
    fputc(bracket, json->to);
    json->depth++;
    json->first = true;
}

json_writer json_begin(FILE *to)
{
    json_writer json = {to, 1, true};
    fputc('{', to);
    return json;
}

void json_end(json_writer *json)
{
    fputs("\n}\n", json->to);
}

void json_number(json_writer *json, const char *key, double value)
{
    key_of(json, key);
    write_number(json->to, value);
}

void json_integer(json_writer *json, const char *key, long long value)
{
    key_of(json, key);
    fprintf(json->to, "%lld", value);
}

void json_flag(json_writer *json, const char *key, bool value)
{
    key_of(json, key);
    fputs(value ? "true" : "false", json->to);
}

void json_text(json_writer *json, const char *key, const char *value)
{
    key_of(json, key);
    if (value)
        write_text(json->to, value);
    else
        fputs("null", json->to);
}

void json_open(json_writer *json, const char *key)
{
    open_with(json, key, '{');
}

void json_close(json_writer *json)
{
    json->depth--;
    json->first = false;
    fputs(" }", json->to);
}

void json_open_array(json_writer *json, const char *key)
{
    open_with(json, key, '[');
}

void json_close_array(json_writer *json)
{
    json->depth--;
    json->first = false;
    fputs(" ]", json->to);
}
