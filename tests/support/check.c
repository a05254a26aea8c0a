/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void test_near(double actual, double expected, double tolerance, bool relative,
               const char *what, const char *file, int line)
{
    double error = fabs(actual - expected);
    double allowed = relative ? tolerance * fabs(expected) : tolerance;
    /* Equality first: the difference of equal infinities is NaN. */
    if (actual == expected || error <= allowed)
        return;
    print_error("%s is %.17g, expected %.17g within %g%s: off by %g\n", what,
                actual, expected, tolerance, relative ? " relative" : "",
                relative ? error / fabs(expected) : error);
    _fail(file, line);
}

void test_status(ovr_status actual, ovr_status expected, const ovr_error *err,
                 const char *what, const char *file, int line)
{
    if (actual == expected)
        return;
    print_error("%s: %s, expected %s%s%s\n", what, ovr_status_name(actual),
                ovr_status_name(expected), err && actual ? ": " : "",
                err && actual ? err->message : "");
    _fail(file, line);
}

void test_error(const ovr_error *err, ovr_status status, const char *part,
                const char *file, int line)
{
    if (err->status != status)
        print_error("error is %s, expected %s: %s\n",
                    ovr_status_name(err->status), ovr_status_name(status),
                    err->message);
    else if (!strstr(err->message, part))
        print_error("message '%s' lacks '%s'\n", err->message, part);
    else if (strchr(err->message, '\n'))
        print_error("message '%s' is more than one line\n", err->message);
    else
        return;
    _fail(file, line);
}

/* splitmix64 (Steele, Lea & Flood 2014): every seed is a good one. */
double test_random(uint64_t *state, double from, double to)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return from + (to - from) * ((double)(z >> 11) * 0x1p-53);
}

const char *test_block_name(const char *section)
{
    if (!strcmp(section, "feature"))
        return " f";
    bool of_body = !strcmp(section, "body") || !strcmp(section, "coating");
    return of_body ? " 1" : "";
}

int test_draws(int few, int many)
{
    const char *runs = getenv("OVERROLL_RUNS");
    if (runs)
        return atoi(runs);
    return getenv("OVERROLL_VERIFY") ? many : few;
}
