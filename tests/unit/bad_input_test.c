/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every parameter with every kind of invalid value, generated from the table of
 * parameters: the message is one line with file, line, key, value and allowed
 * values. New parameters are included automatically. */
#include "support/contact.h"
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "overroll/overroll.h"
#include "simulation/simulation.h"

static char text[65536];

/* Returns a case with `key = value` in its section, in line 2. */
static const char *case_with(const ovr_parameter_info *p, const char *value)
{
    const char *name = test_block_name(p->section);
    snprintf(text, sizeof text, "[%s%s]\n%s = %s\n", p->section, name, p->key,
             value);
    return text;
}

static bool of_type(const ovr_parameter_info *p, const char *type)
{
    return strcmp(p->type, type) == 0;
}

static bool is_text(const ovr_parameter_info *p)
{
    return of_type(p, "text") || of_type(p, "path");
}

static bool shows(const char *message, const char *format, double number)
{
    char target[40];
    snprintf(target, sizeof target, format, number);
    return strstr(message, target) != NULL;
}

/* The unit of messages in SI: angles are in degrees. */
static double unit_of(const ovr_parameter_info *p)
{
    bool angle = !strncmp(p->units, "rad,", 4);
    assert_true(angle == !strcmp(p->limit_unit, "deg"));
    return angle ? 0.017453292519943295 : 1;
}

/* All words; a number's largest value, or its units. */
static bool says_what_is_allowed(const ovr_parameter_info *p,
                                 const char *message)
{
    double most = p->maximum / unit_of(p);
    bool range = shows(message, "%.0f", most) || shows(message, "%g", most);
    if (is_text(p))
        return strstr(message, "; allowed: ") != NULL;
    if (of_type(p, "yes or no"))
        return strstr(message, "yes") && strstr(message, "no");
    for (size_t k = 0; isnan(p->minimum) && p->choices[k]; k++)
        if (!strstr(message, p->choices[k]))
            return false;
    return isnan(p->minimum) || range ||
           (*p->units && strstr(message, p->units)) ||
           strstr(message, "without a unit");
}

/* File, line, key, value, what is allowed; one line. */
static void check_message(const ovr_parameter_info *p, const char *value,
                          const char *place, const ovr_error *err)
{
    size_t length = strlen(place);
    bool listed = strpbrk(value,
                          of_type(p, "words") ? ", " : ","); /* part by part */
    if (strncmp(err->message, place, length) != 0 ||
        strncmp(err->message + length, p->key, strlen(p->key)) != 0 ||
        (!listed && *value != ' ' && !strstr(err->message, value)) ||
        strchr(err->message, '\n') || !err->about ||
        strcmp(err->about, p->key) != 0 ||
        !says_what_is_allowed(p, err->message))
        fail_msg("[%s] %s = '%s' says: %s", p->section, p->key, value,
                 err->message);
}

static void bad_value(const ovr_parameter_info *p, const char *value)
{
    ovr_error err = {0};
    char where[100];
    ovr_case *c = ovr_case_read_text(case_with(p, value), "t.ini", NULL, NULL,
                                     &err);
    if (c)
        fail_msg("[%s] %s = '%s' was taken", p->section, p->key, value);
    assert_int_equal(err.status, OVR_BAD_INPUT);
    check_message(p, value, "t.ini:2: ", &err);

    /* the same from the command line */
    snprintf(where, sizeof where, "%s%s.%s", p->section,
             test_block_name(p->section), p->key);
    c = ovr_case_create(NULL, &err);
    assert_non_null(c);
    assert_int_equal(
        ovr_case_set(c, where, *value == ' ' ? "" : value, "--set", &err),
        OVR_BAD_INPUT);
    check_message(p, value, "--set: ", &err);
    ovr_case_free(c);
}

/* The value in the SI unit, where a unit must be. */
static void put_number(const ovr_parameter_info *p, double value, char *number,
                       size_t capacity)
{
    bool unit = *p->units && !*p->bare;
    snprintf(number, capacity, "%.17g%s%.*s", value, unit ? " " : "",
             unit ? (int)strcspn(p->units, ",") : 0, p->units);
}

/* Taken or refused as the range says; and if taken, resolving ends well or
 * names the case. */
static void number(const ovr_parameter_info *p, double value)
{
    char with_unit[80];
    ovr_error err = {0};
    bool inside = (p->above ? value > p->minimum : value >= p->minimum) &&
                  value <= p->maximum;
    bool whole = of_type(p, "whole number") && value != floor(value);
    ovr_case *c;
    put_number(p, value, with_unit, sizeof with_unit);
    c = ovr_case_read_text(case_with(p, with_unit), "t.ini", NULL, NULL, &err);
    if ((c != NULL) != (inside && !whole))
        fail_msg("[%s] %s = %s: %s", p->section, p->key, with_unit,
                 c ? "was taken" : err.message);
    if (!c) {
        check_message(p, with_unit, "t.ini:2: ", &err);
        return;
    }
    ovr_setup *s = ovr_case_resolve(c, NULL, &err);
    bool about = !s && err.about && !strcmp(err.about, p->key);
    if (!s &&
        strncmp(err.message, about ? "t.ini:2: " : "t.ini:", about ? 9 : 6))
        fail_msg("[%s] %s = %s says: %s", p->section, p->key, with_unit,
                 err.message);
    ovr_setup_free(s);
    ovr_case_free(c);
}

/* Missing, no number, infinite, of another unit, huge, tiny, negative, zero. */
TEST(every_parameter_refuses_nonsense)
{
    static const char *const words[] = {"nan",   "inf",     "-inf",
                                        "1e999", "quux",    "3 furlong",
                                        "1,5;2", "\303\244"};
    static const double values[] = {0,     -1,  1e300, -1e300, 1e-300,
                                    1e-20, 0.5, 1e9,   1,      -1e-9};
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        assert_true(p.help && *p.help);
        bad_value(&p, "");
        bad_value(&p, " # only a comment");
        for (size_t i = 0; !is_text(&p) && i < sizeof words / sizeof *words;
             i++)
            bad_value(&p, words[i]);
        if (isnan(p.minimum))
            continue;
        assert_true(p.minimum <= p.maximum);
        if (*p.units && !*p.bare)
            bad_value(&p, "1"); /* a unit is needed */
        bad_value(&p, *p.units && strstr(p.units, "m/s") ? "1 Pa" : "1 m/s");
        for (size_t i = 0; i < sizeof values / sizeof *values; i++)
            number(&p, values[i]);
    }
}

static const char *some_value(const ovr_parameter_info *p)
{
    static char value[80];
    if (p->initial)
        return p->initial;
    if (isnan(p->minimum))
        return p->choices[0] ? p->choices[0] : "yes";
    put_number(p, p->minimum > 1 || p->maximum < 1 ? p->maximum : 1, value,
               sizeof value);
    return value;
}

static void refused(const char *format, const ovr_parameter_info *p)
{
    char target[200];
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "t.ini", NULL, NULL, &err);
    if (c)
        fail_msg("was taken:\n%s", text);
    snprintf(target, sizeof target, format, p->key);
    CHECK_ERROR(&err, OVR_BAD_INPUT, target);
}

/* Given twice; with a letter too many; in a section that is not its own. */
TEST(every_key_has_one_place)
{
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        const char *value = some_value(&p);
        size_t length = strlen(case_with(&p, value));
        snprintf(text + length, sizeof text - length, "%s = %s\n", p.key,
                 value);
        refused("t.ini:3: '%s' is given twice in [", &p);
        ovr_parameter_info wrong = p;
        char key[80];
        snprintf(key, sizeof key, "%sx", p.key);
        wrong.key = key;
        case_with(&wrong, value);
        refused("t.ini:2: unknown key '%s' in [", &wrong);
        if (strlen(p.key) > 3)
            refused("did you mean '", &wrong);
        snprintf(text, sizeof text, "%s = %s\n", p.key, value);
        refused("t.ini:1: a [section] must come before", &p);
    }
}

TEST(every_default_is_allowed)
{
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        if (!p.initial)
            continue;
        ovr_case *c = ovr_case_read_text(case_with(&p, p.initial), "t.ini",
                                         NULL, NULL, NULL);
        if (!c)
            fail_msg("[%s] %s = %s", p.section, p.key, p.initial);
        ovr_case_free(c);
    }
}

/* ---------------------------------------------------------------- missing */

static ovr_status resolve(const char *source, ovr_error *err)
{
    ovr_case *c = ovr_case_read_text(source, "t.ini", NULL, NULL, err);
    ovr_setup *s = c ? ovr_case_resolve(c, NULL, err) : NULL;
    ovr_status status = s ? ovr_setup_prepare(s, NULL, err) : err->status;
    ovr_setup_free(s);
    ovr_case_free(c);
    return status;
}

static const ovr_parameter_info *find(const char *section, const char *key)
{
    static ovr_parameter_info p;
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        p = ovr_parameter_at(k);
        if (!strcmp(p.section, section) && !strcmp(p.key, key))
            return &p;
    }
    fail_msg("no [%s] %s", section, key);
    return NULL;
}

/* The contact of numbers with units, each line in turn left out: what is
 * missing is named by its key, unless a default takes its place. */
TEST(missing_parts_are_named)
{
    static const char *const lines[][2] = {
        {"load", "307 kN/m"},      {"radius", "10 mm"},
        {"modulus", "226 GPa"},    {"mean_speed", "1.3 m/s"},
        {"viscosity", "40 mPa.s"}, {"alpha", "17 1/GPa"}};
    enum { LINES = sizeof lines / sizeof *lines };
    for (int without = -1; without < LINES; without++) {
        size_t used = (size_t)snprintf(text, sizeof text, "[contact]\n");
        ovr_error err = {0};
        for (int i = 0; i < LINES; i++)
            if (i != without)
                used += (size_t)snprintf(text + used, sizeof text - used,
                                         "%s = %s\n", lines[i][0], lines[i][1]);
        if (without < 0) {
            CHECK_OK(resolve(text, &err), &err);
            continue;
        }
        if (resolve(text, &err) == OVR_OK)
            fail_msg("not missed: %s", lines[without][0]);
        CHECK_ERROR(&err, OVR_BAD_INPUT, lines[without][0]);
        CHECK_ERROR(&err, OVR_BAD_INPUT, " is missing");
    }
}

/* From a bare shape on: what is asked for is given, until it is enough. */
TEST(every_shape_requires_its_sizes)
{
    const ovr_parameter_info shape = *find("feature", "shape");
    int asked = 0;
    for (size_t k = 0; shape.choices[k]; k++) {
        size_t used = (size_t)snprintf(text, sizeof text,
                                       "[contact]\nM = 20\nL = 10\n"
                                       "[domain]\nlevel = 9\n"
                                       "[feature f]\nshape = %s\n",
                                       shape.choices[k]);
        ovr_error err = {0};
        while (resolve(text, &err)) {
            char key[40];
            if (strstr(err.message, "a profile needs a file"))
                break;
            const char *needs = strstr(err.message, "needs ");
            if (!needs)
                fail_msg("%s: %s", shape.choices[k], err.message);
            needs += strncmp(needs, "needs its ", 10) ? 6 : 10;
            if (*needs == '[') /* a strip */
                break;
            assert_memory_equal(err.message, "t.ini:", 6);
            snprintf(key, sizeof key, "%.*s", (int)strcspn(needs, " ,;"),
                     needs);
            if (!strcmp(key, "place"))
                snprintf(key, sizeof key, "start");
            used += (size_t)snprintf(text + used, sizeof text - used,
                                     "%s = %s\n", key,
                                     !strcmp(key, "start")    ? "-6"
                                     : !strcmp(key, "length") ? "4"
                                                              : "0.5");
            assert_true(++asked < 100);
        }
    }
    assert_true(asked > 15);
}

/* ------------------------------------------------------- found out late */

/* A valid case; a setting below replaces one of these lines or follows its
 * section. */
static const char *const good[][3] = {{"contact", "load", "307 kN/m"},
                                      {"contact", "radius", "10 mm"},
                                      {"contact", "modulus", "226 GPa"},
                                      {"contact", "mean_speed", "1.3 m/s"},
                                      {"contact", "viscosity", "40 mPa.s"},
                                      {"contact", "alpha", "17 1/GPa"},
                                      {"time", "end", "1"},
                                      {"load", "history", "ramp"},
                                      {"load", "to", "1.2"},
                                      {"feature", "shape", "dent"},
                                      {"feature", "start", "-2"},
                                      {"feature", "depth", "0.1"},
                                      {"feature", "width", "0.5"}};
enum { GOOD = sizeof good / sizeof *good };

/* Writes it with the setting; returns its line. */
static int with(const char *section, const char *key, const char *value)
{
    static const char *const sections[] = {"contact", "domain", "solver",
                                           "paper",   "time",   "load",
                                           "feature", "output"};
    size_t used = 0;
    int line = 0, found = 0;
    for (size_t s = 0; s < sizeof sections / sizeof *sections; s++) {
        bool here = !strcmp(sections[s], section);
        used += (size_t)snprintf(text + used, sizeof text - used, "[%s%s]\n",
                                 sections[s], test_block_name(sections[s]));
        line++;
        for (size_t i = 0; i < GOOD; i++) {
            bool same = here && !strcmp(good[i][1], key);
            if (strcmp(good[i][0], sections[s]) != 0 || same)
                continue;
            used += (size_t)snprintf(text + used, sizeof text - used,
                                     "%s = %s\n", good[i][1], good[i][2]);
            line++;
        }
        if (!here)
            continue;
        used += (size_t)snprintf(text + used, sizeof text - used, "%s = %s\n",
                                 key, value);
        found = ++line;
    }
    return found;
}

/* Errors that depend on other keys, the units of the contact or the grid also
 * have the line of their key. */
TEST(late_errors_have_their_line)
{
    static const char *const late[][3] = {{"contact", "slide_to_roll", "1e999"},
                                          {"contact", "speed_2", "1 m/s"},
                                          {"domain", "inlet", "-1 um"},
                                          {"domain", "outlet", "1 um"},
                                          {"domain", "nodes", "100"},
                                          {"paper", "mlmi_order", "5"},
                                          {"paper", "mlmi_range", "5"},
                                          {"time", "end", "1e6 s"},
                                          {"load", "period", "2"},
                                          {"load", "file", "nowhere.csv"},
                                          {"load", "amplitude", "0.5"},
                                          {"feature", "wavelength", "1"},
                                          {"feature", "arrival", "2"},
                                          {"feature", "repeat", "1e-5"},
                                          {"feature", "depth", "10 mm"},
                                          {"feature", "width", "1e6 mm"},
                                          {"feature", "height", "0.1"},
                                          {"feature", "radius", "1"},
                                          {"output", "interval", "1e9 s"}};
    for (size_t k = 0; k < sizeof late / sizeof *late; k++) {
        int line = with(late[k][0], late[k][1], late[k][2]);
        char place[40];
        ovr_error err = {0};
        if (resolve(text, &err) == OVR_OK)
            fail_msg("[%s] %s = %s was taken", late[k][0], late[k][1],
                     late[k][2]);
        snprintf(place, sizeof place, "t.ini:%d: ", line);
        if (strncmp(err.message, place, strlen(place)) != 0 || !err.about)
            fail_msg("%s expected: %s (about %s)", place, err.message,
                     err.about ? err.about : "nothing");
    }
}

/* --------------------------------------------------------- beyond memory */

static size_t largest; /* piece asked for */

static void *take(void *context, size_t bytes)
{
    (void)context;
    largest = bytes > largest ? bytes : largest;
    return calloc(1, bytes);
}

static void give(void *context, void *memory)
{
    (void)context;
    free(memory);
}

/* Level 18 ends at a residual of 3.6e-4, which is rounding; on level 19 it
 * would be four times as large, and no cycle would end the solve. */
TEST(levels_beyond_double_precision_are_refused)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text("[contact]\nM = 20\nL = 10\n"
                                     "[domain]\nlevel = 19\norder = 2\n",
                                     "t.ini", NULL, NULL, &err);
    assert_non_null(c);
    ovr_setup *s = ovr_case_resolve(c, NULL, &err);
    if (s)
        assert_int_equal(ovr_setup_prepare(s, NULL, &err), OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "t.ini:5: level 19 cannot be");
    CHECK_ERROR(&err, OVR_BAD_INPUT, "use level 18 or less");
    ovr_setup_free(s);
    ovr_case_free(c);
}

/* The largest level, on a machine with too little memory for it: the message
 * contains the required memory, and nothing of this size is allocated. */
TEST(memory_is_estimated_first)
{
    const ovr_parameter_info level = *find("domain", "level");
    const ovr_allocator hook = {take, give, NULL};
    ovr_options o = test_options();
    double here = (double)sysconf(_SC_PHYS_PAGES) *
                  (double)sysconf(_SC_PAGE_SIZE);
    ovr_error err = {0};
    o.level = (int)level.maximum;
    if (ovr_simulation_memory(&o) < 0.8 * here)
        skip();
    snprintf(text, sizeof text,
             "[contact]\nM = 20\nL = 10\n[domain]\n"
             "level = %d\n[solver]\nstop = fixed\n",
             o.level);
    ovr_case *c = ovr_case_read_text(text, "t.ini", NULL, &hook, &err);
    assert_non_null(c);
    ovr_setup *s = ovr_case_resolve(c, &hook, &err);
    if (s)
        assert_int_equal(ovr_setup_prepare(s, &hook, &err), OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "t.ini:5: level: ");
    CHECK_ERROR(&err, OVR_BAD_INPUT, " GB of memory, but this machine ");
    assert_true(largest < 1000000);
    ovr_setup_free(s);
    ovr_case_free(c);
}
