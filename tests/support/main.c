/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Main program of all tests: runs the tests of the file given by its program
 * name (build/tests/unit/arena_test) or its argument. */
#include "test.h"

#include <stdio.h>
#include <string.h>

static test_listed *listed;

/* Adds a test to the list, which is sorted by file (in the order of linking)
 * and line. Compilers call this function in any order. */
void test_list(test_listed *one)
{
    test_listed **at = &listed;
    while (*at && strcmp((*at)->file, one->file) != 0)
        at = &(*at)->next;
    while (*at && !strcmp((*at)->file, one->file) && (*at)->line < one->line)
        at = &(*at)->next;
    one->next = *at;
    *at = one;
}

/* True if a program name such as "build/tests/unit/arena_test" is that of a
 * file such as "tests/unit/arena_test.c". */
static bool is_of(const char *file, const char *called)
{
    const char *name = strstr(file, "tests/") + strlen("tests/");
    size_t bytes = strlen(name) - strlen(".c"), all = strlen(called);
    return all >= bytes && !strncmp(called + all - bytes, name, bytes);
}

int main(int count, char **argument)
{
    enum { MOST = 200 };
    static struct CMUnitTest tests[MOST];
    const char *called = count > 1 ? argument[1] : argument[0];
    CMFixtureFunction begins = NULL, ends = NULL;
    size_t found = 0;
    for (const test_listed *t = listed; t && found < MOST; t = t->next) {
        if (!is_of(t->file, called))
            continue;
        if (t->test.test_func) {
            tests[found++] = t->test;
        } else {
            begins = t->begins;
            ends = t->ends;
        }
    }
    if (!found) {
        fprintf(stderr,
                "%s: no test of this name; usage: tests KIND/NAME_test\n",
                called);
        return 2;
    }
    setvbuf(stdout, NULL, _IOLBF, 0);
    return _cmocka_run_group_tests("tests", tests, found, begins, ends);
}
