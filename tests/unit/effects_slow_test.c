/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A key without effect is rejected or causes a note. Each key of the table is
 * set in several cases to several values. Values accepted without a note must
 * change the case or the summary of its run. The condition in the row of the
 * key (`when`) is not used. In make check each case has every eighth key,
 * consecutive cases different ones; in make verify all. */
#include "support/test.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/setup.h"
#include "overroll/overroll.h"

#define CONTACT                                                                \
    "[contact]\nload = 3e5 N/m\nradius = 10 mm\nmodulus = 226 GPa\n"           \
    "viscosity = 40 mPa.s\nalpha = 17 1/GPa\nspeed_1 = 1.4 m/s\n"              \
    "speed_2 = 1.2 m/s\n[domain]\nlevel = 4\n"
#define THINS "[lubricant]\nrheology = eyring\neyring_stress = 5 MPa\n"
#define INDENT                                                                 \
    "[time]\nend = 0.2\n[feature d]\nshape = indent\ndepth = 0.2 um\n"         \
    "width = 0.5\nstart = -0.5\n"

#define GEAR                                                                   \
    "[contact]\nmodulus = 226 GPa\n[lubricant]\nviscosity = 40 mPa.s\n"        \
    "alpha = 17 1/GPa\n[domain]\nlevel = 4\n[gear]\nteeth_1 = 25\n"            \
    "teeth_2 = 57\nmodule = 2.5 mm\nface = 20 mm\nspeed = 3000 rpm\n"          \
    "torque = 80 N.m\n"

static const struct {
    const char *name, *text;
    const char *only; /* keys of this section; NULL: all */
} cases[] = {
    {"steady", CONTACT, NULL},
    {"numbers", "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 4\n", NULL},
    {"indent", CONTACT INDENT, NULL},
    {"stress",
     CONTACT INDENT "[stress]\nsurface = 1\n"
                    "[fatigue]\nlimit_pressure = none\n",
     NULL},
    {"heat",
     CONTACT THINS INDENT "[heat]\nmodel = lobatto\n"
                          "temperature = 80 degC\n",
     NULL},
    {"ramp",
     CONTACT INDENT "[load]\nhistory = ramp\nto = 1.2\n"
                    "duration = 0.1\n",
     NULL},
    {"touching",
     CONTACT THINS "[boundary]\nlaw = exponential\nRq = 0.3 um\n"
                   "slope = 0.1\nfriction = 0.1\n",
     NULL},
    {"film",
     CONTACT "[cavitation]\nmodel = conserving\n[supply]\nmodel = film\n"
             "thickness_1 = 0.05\nthickness_2 = 0.05\n",
     "supply"},
    {"passes",
     CONTACT INDENT "[cavitation]\nmodel = conserving\n"
                    "[passes]\nnumber = 3\nloss = 0.1\n[output]\nfile = p.h5\n",
     "passes"},
    {"recovering",
     CONTACT INDENT "[cavitation]\nmodel = conserving\n"
                    "[passes]\nnumber = 3\nloss = 0.1\nspacing = 10\n"
                    "recovery = 100\n[output]\nfile = p.h5\n",
     "passes"},
    {"spur", GEAR, "gear"},
    {"relieved", GEAR "sharing = stiffness\nrelief_1 = 20 um\n", "gear"},
    {"helical", GEAR "helix_angle = 20 deg\n", "gear"},
};

/* Taken in silence, and why: what they set is of files that none of these runs
 * writes; comes later than their ends (a steady film, the whole material
 * history of the indent, its yielding, layers that are not even); is of
 * finer grids; or shares the work without changing a bit. */
static const char *const later[] = {"output.",
                                    "stress.every",
                                    "stress.fields",
                                    "time.until_steady",
                                    "fatigue.alpha",
                                    "fatigue.exponent",
                                    "fatigue.depth_exponent",
                                    "fatigue.weibull",
                                    "fatigue.raceway",
                                    "plastic.",
                                    "paper.mlmi_",
                                    "passes.again",
                                    "strip.threads",
                                    NULL};

static bool is_later(const char *where)
{
    for (size_t k = 0; later[k]; k++)
        if (!strncmp(where, later[k], strlen(later[k])))
            return true;
    return false;
}

/* ------------------------------------------------------ results of a case */

typedef struct record {
    uint64_t sum; /* FNV-1a of all printed text */
    bool noted;   /* that a key has no effect */
} record;

static void add(record *t, const char *text)
{
    for (; text && *text; text++)
        t->sum = (t->sum ^ (unsigned char)*text) * UINT64_C(1099511628211);
}

static void hear(void *data, ovr_message_kind kind, const char *text)
{
    record *t = data;
    (void)kind;
    t->noted = t->noted || strstr(text, "no effect");
    add(t, text);
}

/* Adds a line to the hash, except for values that differ between two runs of
 * one case. */
static void take(void *data, const ovr_summary_line *line)
{
    char number[40];
    if (!line->key || strstr(line->key, "seconds") ||
        strstr(line->key, "memory"))
        return;
    snprintf(number, sizeof number, "%.17g", line->number);
    add(data, line->key);
    add(data, number);
    add(data, line->text);
}

static void take_answer(void *data, const char *name, const char *text)
{
    add(data, name);
    add(data, text);
}

/* Runs the case as it was set; false where it is refused, or breaks off. */
static bool run(ovr_case *c, record *t)
{
    ovr_error err = {0};
    ovr_run_options how = {.say = hear, .data = t, .force = true};
    *t = (record){.sum = UINT64_C(14695981039346656037)};
    ovr_run *r = ovr_run_create(c, &how, NULL, &err);
    bool good = r && !ovr_run_execute(r, &err);
    if (good) {
        const ovr_run_info *info = ovr_run_get_info(r);
        ovr_run_summary(info, take, t);
        ovr_setup_describe(info->setup, take_answer, t);
        good = !ovr_setup_report(info->setup, 0, 0, take, t, &err);
    }
    ovr_run_free(r);
    return good;
}

/* ------------------------------------------------------------- one key each */

static const char *name_of(const char *section)
{
    return !strcmp(section, "feature")                               ? ".d"
           : !strcmp(section, "body") || !strcmp(section, "coating") ? ".1"
                                                                     : "";
}

/* The k-th value to try; NULL behind the last.  Two from the middle of the
 * range come first: an answer is soonest there, where a bare 1 Pa of shear
 * stress is beyond every film. */
static const char *value_of(const ovr_parameter_info *p, size_t k,
                            char text[80])
{
    static const double tried[] = {0.05, 1, 1e-6, 2, 0.1, 0.5, 0.3, 3,
                                   4,    8, 0.9,  9, -1,  20,  1.1};
    static const double within[] = {0.5, 0.75, 0.25};
    enum { TRIED = sizeof tried / sizeof *tried, FIRST = 2 };
    bool number = isfinite(p->minimum);
    size_t words = 0;
    while (p->choices[words])
        words++;
    if (k < words)
        return p->choices[k];
    k -= words;
    if (!number)
        return words || k > 1 ? NULL : k ? "yes" : "no";
    if (k > FIRST + TRIED)
        return NULL;
    double v, minimum = p->minimum, maximum = p->maximum;
    bool inside = k < FIRST || k == FIRST + TRIED;
    double part = within[k < FIRST ? k : FIRST];
    if (!inside)
        v = tried[k - FIRST];
    else
        v = minimum > 0 ? minimum * pow(maximum / minimum, part)
                        : minimum + (maximum - minimum) * part;
    for (size_t i = 0; i < TRIED && inside; i++)
        if (fabs(v - tried[i]) < 1e-9 * fabs(v)) /* no value twice */
            v *= 1.02;
    const char *unit = *p->units && !*p->bare ? p->units : "";
    snprintf(text, 80, "%.6g %.*s", v, (int)strcspn(unit, ", "), unit);
    return text;
}

static bool is_pair(const ovr_parameter_info *p)
{
    bool flag = p->initial &&
                (!strcmp(p->initial, "no") || !strcmp(p->initial, "yes"));
    return flag || (p->initial && p->choices[1] && !p->choices[2]);
}

static bool is_given(const char *source, const char *where)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(source, "t.ini", NULL, NULL, &err);
    bool given = false;
    for (size_t k = 0; k < ovr_case_entries(c) && !given; k++) {
        ovr_case_entry e = ovr_case_entry_at(c, k);
        char name[120];
        snprintf(name, sizeof name, "%s%s%s.%s", e.section, e.name ? "." : "",
                 e.name ? e.name : "", e.key);
        given = e.given && !strcmp(name, where);
    }
    ovr_case_free(c);
    return given;
}

/* Whether a key is taken in silence, and nothing comes of it.  Of two words one
 * is the default, which counts too. */
static bool is_idle(const char *source, const ovr_parameter_info *p,
                    const record *base)
{
    char where[120], text[80];
    const char *value;
    int same = 0, other = 0;
    record first = *base;
    snprintf(where, sizeof where, "%s%s.%s", p->section, name_of(p->section),
             p->key);
    if (is_later(where))
        return false;
    same = is_pair(p) && !is_given(source, where);
    for (size_t k = 0; same < 6 && (value = value_of(p, k, text)); k++) {
        ovr_error err = {0};
        record now;
        if (p->initial && !strcmp(value, p->initial))
            continue;
        ovr_case *c = ovr_case_read_text(source, "t.ini", NULL, NULL, &err);
        bool taken = c && !ovr_case_set(c, where, value, "--set", &err) &&
                     run(c, &now);
        ovr_case_free(c);
        if (!taken)
            continue;
        if (now.noted)
            return false;
        other += now.sum != first.sum && same + other > 0;
        if (other)
            return false;
        first = now;
        same++;
    }
    return same > 1;
}

TEST(keys_have_effects_or_are_refused)
{
    const size_t every = (size_t)test_draws(8, 1);
    size_t idle = 0;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        ovr_error err = {0};
        record base;
        ovr_case *c = ovr_case_read_text(cases[k].text, "t.ini", NULL, NULL,
                                         &err);
        assert_non_null(c);
        if (!run(c, &base))
            fail_msg("%s does not run", cases[k].name);
        ovr_case_free(c);
        for (size_t i = 0; i < ovr_parameter_count(); i++) {
            ovr_parameter_info p = ovr_parameter_at(i);
            if (cases[k].only && strcmp(p.section, cases[k].only) != 0)
                continue;
            if ((i + k) % every)
                continue;
            if (!is_idle(cases[k].text, &p, &base))
                continue;
            fprintf(stderr, "%s: [%s] %s is taken and has no effect\n",
                    cases[k].name, p.section, p.key);
            idle++;
        }
    }
    assert_int_equal(idle, 0);
}
