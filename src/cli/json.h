/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes one JSON object, a key at a time:
 *     json_writer j = json_begin(stdout);
 *     json_number(&j, "H_min", 0.4);
 *     json_open(&j, "history");  ...  json_close(&j);
 *     json_end(&j);
 * Numbers have 17 significant digits, so that reading them gives the same
 * double; NaN and infinities become null.  Text must be UTF-8; bytes that are
 * not are written as the replacement character.
 */
#ifndef OVR_CLI_JSON_H
#define OVR_CLI_JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct json_writer {
    FILE *to;
    int depth;
    bool first; /* nothing written yet at this level */
} json_writer;

json_writer json_begin(FILE *to);
void json_end(json_writer *json);

/* With a NULL key an element of an array is written. */
void json_number(json_writer *json, const char *key, double value);
void json_integer(json_writer *json, const char *key, long long value);
void json_flag(json_writer *json, const char *key, bool value);
/* NULL becomes null. */
void json_text(json_writer *json, const char *key, const char *value);

/* Write a nested object. */
void json_open(json_writer *json, const char *key);
void json_close(json_writer *json);

/* Write a nested array, whose elements have NULL keys. */
void json_open_array(json_writer *json, const char *key);
void json_close_array(json_writer *json);

#endif
