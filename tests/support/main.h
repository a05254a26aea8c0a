/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * main() of the program that holds all tests: it runs the one by whose name it
 * is called.  The Makefile declares them and defines TESTS, a row each of
 * "KIND/NAME" and the main() of that file under another name.
 */
#include <stdio.h>
#include <string.h>

typedef struct one_test {
    const char *name;
    int (*run)(void);
} one_test;

/* "build/tests/unit/arena_test" ends in "unit/arena_test". */
static int is_called(const char *path, const char *name)
{
    size_t path_bytes = strlen(path), bytes = strlen(name);
    return path_bytes >= bytes && strcmp(path + path_bytes - bytes, name) == 0;
}

int main(int count, char **argument)
{
    static const one_test tests[] = {TESTS};
    const char *called = count > 1 ? argument[1] : argument[0];
    for (size_t k = 0; k < sizeof tests / sizeof *tests; k++)
        if (is_called(called, tests[k].name))
            return tests[k].run();
    fprintf(stderr, "%s: no test of this name; usage: tests KIND/NAME_test\n",
            called);
    return 2;
}
