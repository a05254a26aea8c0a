/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every value that a case accepts for a key is written into its text and read
 * again unchanged. Values are random for every key, most of them with
 * separators, quotes and comment signs. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "overroll/case.h"

enum { TRIES = 60, CAPACITY = 400 };

static uint64_t seed = 15;

static int below(int n)
{
    return (int)test_random(&seed, 0, n);
}

static bool of_type(const ovr_parameter_info *p, const char *type)
{
    return strstr(p->type, type) != NULL;
}

static void add(char *text, const char *more)
{
    size_t used = strlen(text);
    snprintf(text + used, CAPACITY - used, "%s", more);
}

/* A number within the range, long or short, with its unit. */
static void put_number(const ovr_parameter_info *p, char *text)
{
    static const char *const forms[] = {"%.3g", "%.17g", "%.60f", "%g"};
    double minimum = fmax(p->minimum, -1e3);
    double maximum = fmin(p->maximum, fmax(1e3, 2 * minimum));
    double value = minimum + (maximum - minimum) * test_random(&seed, 0, 1);
    char number[120];
    if (of_type(p, "whole"))
        value = floor(value);
    snprintf(number, sizeof number, forms[below(4)], value);
    add(text, number);
    if (*p->units && (!*p->bare || below(2))) {
        char unit[20];
        snprintf(unit, sizeof unit, "%s%.*s", below(2) ? " " : "",
                 (int)strcspn(p->units, ","), p->units);
        add(text, unit);
    }
}

static void put_word(const ovr_parameter_info *p, char *text)
{
    int n = 0;
    while (p->choices[n])
        n++;
    add(text, n ? p->choices[below(n)] : "yes");
}

static void put_noise(char *text)
{
    static const char *const pieces[] = {
        "\"", "'", ";", " ;", "\t;", "#",  " ",  "a",  "b.h5", "/", ",", "]",
        "[",  "=", ":", "\\", "%",   "\t", "\n", "\r", "\x01", "µ", "1", "-"};
    for (int k = below(9) + 1; k > 0; k--)
        add(text, pieces[below(sizeof pieces / sizeof pieces[0])]);
}

static void put_right(const ovr_parameter_info *p, char *text)
{
    int items = of_type(p, "numbers") ? below(12) + 1 : 1;
    if (of_type(p, "text") || of_type(p, "path"))
        add(text, below(2) ? "\"dent 3.h5\"" : "it's; all");
    else if (isnan(p->minimum) || (p->choices[0] && below(2)))
        put_word(p, text);
    else
        for (int k = 0; k < items; k++) {
            if (k)
                add(text, ", ");
            put_number(p, text);
        }
}

static ovr_case_entry entry_of(const ovr_case *c, const ovr_parameter_info *p)
{
    ovr_case_entry entry = {0};
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry e = ovr_case_entry_at(c, k);
        if (!strcmp(e.section, p->section) && !strcmp(e.key, p->key))
            entry = e;
    }
    return entry;
}

static bool same_number(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

static void check_survives(ovr_case *c, const ovr_parameter_info *p,
                           const char *given)
{
    ovr_error err = {0};
    const char *text = ovr_case_text(c, &err);
    ovr_case *d = ovr_case_read_text(text, "again.ini", NULL, NULL, &err);
    ovr_case_entry before = entry_of(c, p), after;
    if (!d)
        fail_msg("[%s] %s took '%s' but: %s\n%s", p->section, p->key, given,
                 err.message, text);
    after = entry_of(d, p);
    if (!after.text || strcmp(before.text, after.text) != 0 ||
        !same_number(before.number, after.number))
        fail_msg("[%s] %s took '%s' as '%s', read again as '%s'", p->section,
                 p->key, given, before.text, after.text ? after.text : "");
    assert_string_equal(ovr_case_text(d, &err), text);
    ovr_case_free(d);
}

static bool try_setting(const ovr_parameter_info *p, const char *value)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_create(NULL, &err);
    char where[100];
    bool taken;
    snprintf(where, sizeof where, "%s%s.%s", p->section,
             test_block_name(p->section), p->key);
    taken = !ovr_case_set(c, where, value, "--set", &err);
    if (taken)
        check_survives(c, p, value);
    ovr_case_free(c);
    return taken;
}

static bool try_line(const ovr_parameter_info *p, const char *value)
{
    ovr_error err = {0};
    char text[CAPACITY + 200];
    ovr_case *c;
    snprintf(text, sizeof text, "[%s%s]\n%s = %s\n[time]\n", p->section,
             test_block_name(p->section), p->key, value);
    if (!strcmp(p->section, "time"))
        text[strlen(text) - strlen("[time]\n")] = '\0';
    c = ovr_case_read_text(text, "it.ini", NULL, NULL, &err);
    if (!c)
        return false;
    if (strcmp(p->section, "contact") != 0) /* another key set later */
        CHECK_OK(ovr_case_set(c, "contact.M", "7", "--set", &err), &err);
    check_survives(c, p, value);
    ovr_case_free(c);
    return true;
}

TEST(accepted_values_are_kept)
{
    int taken_in_all = 0;
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        int taken = 0;
        for (int i = 0; i < TRIES; i++) {
            char value[CAPACITY] = "";
            if (i % 2)
                put_right(&p, value);
            if (i % 4 != 1)
                put_noise(value);
            taken += try_setting(&p, value);
            taken += try_line(&p, value);
        }
        if (!taken)
            fail_msg("[%s] %s took nothing", p.section, p.key);
        taken_in_all += taken;
    }
    print_message("seed 15: %d values taken of %zu keys\n", taken_in_all,
                  ovr_parameter_count());
}

TEST(names_of_sections_survive)
{
    static const char *const names[] = {"a",   "a b", "a.b", "a;b", "a]",
                                        "a#b", "a ;", "a ",  "[a",  "a\nb"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
        ovr_error err = {0};
        ovr_case *c = ovr_case_create(NULL, &err), *d;
        char where[100];
        snprintf(where, sizeof where, "feature.%s.depth", names[k]);
        if (!ovr_case_set(c, where, "0.1", "--set", &err)) {
            d = ovr_case_read_text(ovr_case_text(c, &err), "t.ini", NULL, NULL,
                                   &err);
            if (!d)
                fail_msg("[feature %s]: %s", names[k], err.message);
            assert_string_equal(ovr_case_text(d, &err), ovr_case_text(c, &err));
            ovr_case_free(d);
        } else {
            assert_int_equal(err.status, OVR_BAD_INPUT);
        }
        ovr_case_free(c);
    }
}

/* Sixty digits and more than sixty characters are not cut. */
TEST(long_items_are_whole)
{
    const char *item = "0.12345678901234567890123456789012345678901234567890"
                       "1234567890 ms";
    char value[150];
    ovr_error err = {0};
    ovr_case *c = ovr_case_create(NULL, &err);
    snprintf(value, sizeof value, "%s, %s", item, "1 s");
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        char where[100];
        if (!of_type(&p, "numbers") || !strstr(p.units, "ms"))
            continue;
        snprintf(where, sizeof where, "%s.%s", p.section, p.key);
        CHECK_OK(ovr_case_set(c, where, value, "--set", &err), &err);
    }
    ovr_case_free(c);
}

TEST(quotes_are_no_part_of_a_name)
{
    ovr_error err = {0};
    ovr_parameter_info p = {.section = "output", .key = "file"};
    ovr_case *c = ovr_case_read_text("[output]\nfile = \"b.h5\"\n", "t.ini",
                                     NULL, NULL, &err);
    assert_non_null(c);
    assert_string_equal(entry_of(c, &p).text, "b.h5");
    CHECK_STATUS(ovr_case_set(c, "output.file", "\"b.h5", "--set", &err),
                 OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "quote");
    CHECK_STATUS(ovr_case_set(c, "output.title", "a ;b", "--set", &err),
                 OVR_BAD_INPUT, &err);
    CHECK_OK(ovr_case_set(c, "output.title", "a;b", "--set", &err), &err);
    ovr_case_free(c);
}
