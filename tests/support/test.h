/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Header of all cmocka tests: definition of tests, comparison of numbers,
 * files, and an allocator that counts and fails. */
#ifndef TESTS_SUPPORT_TEST_H
#define TESTS_SUPPORT_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "overroll/error.h"
#include "overroll/memory.h"

/* ----------------------------------------------------------------- tests */

/*
 * TEST(what_holds) { ... } defines a test. The program tests/KIND/NAME_test
 * runs the tests of its file in their order. TEST_WITH also has the setup and
 * teardown functions of cmocka (or NULL). The *state of TEST_IN_FOLDER is a new
 * folder.
 */
#define TEST(name) TEST_WITH(name, NULL, NULL)
#define TEST_IN_FOLDER(name)                                                   \
    TEST_WITH(name, test_make_folder, test_remove_folder)
#define TEST_WITH(name, setup, teardown)                                       \
    static void name(void **state);                                            \
    __attribute__((constructor)) static void register_##name(void)             \
    {                                                                          \
        static test_listed listed_##name = {                                   \
            .test = cmocka_unit_test_setup_teardown(name, setup, teardown),    \
            .file = __FILE__,                                                  \
            .line = __LINE__};                                                 \
        test_list(&listed_##name);                                             \
    }                                                                          \
    static void name(__attribute__((unused)) void **state)

/* Defines setup and teardown functions of a whole file (or NULL). */
#define TEST_GROUP(begin, end)                                                 \
    __attribute__((constructor)) static void register_group(void)              \
    {                                                                          \
        static test_listed listed_group = {                                    \
            .begins = begin, .ends = end, .file = __FILE__, .line = __LINE__}; \
        test_list(&listed_group);                                              \
    }

typedef struct test_listed {
    struct CMUnitTest test; /* if it has no function: TEST_GROUP */
    CMFixtureFunction begins, ends;
    const char *file;
    int line;
    struct test_listed *next;
} test_listed;

/* Adds a test. Called by the macros, before main(). */
void test_list(test_listed *one);

/* --------------------------------------------------------------- numbers */

/* Checks |actual - expected| <= tolerance. NaN fails, equal infinities do not.
 */
#define CHECK_NEAR(actual, expected, tolerance)                                \
    test_near(actual, expected, tolerance, false, #actual, __FILE__, __LINE__)

/* Checks |actual - expected| <= tolerance |expected|. */
#define CHECK_CLOSE(actual, expected, tolerance)                               \
    test_near(actual, expected, tolerance, true, #actual, __FILE__, __LINE__)

void test_near(double actual, double expected, double tolerance, bool relative,
               const char *what, const char *file, int line);

/* Checks a status. If it differs, the error message is printed. */
#define CHECK_STATUS(actual, expected, err)                                    \
    test_status(actual, expected, err, #actual, __FILE__, __LINE__)
#define CHECK_OK(actual, err) CHECK_STATUS(actual, OVR_OK, err)

void test_status(ovr_status actual, ovr_status expected, const ovr_error *err,
                 const char *what, const char *file, int line);

/* Checks that the error has this status and a message of one line that contains
 * `part`. */
#define CHECK_ERROR(err, status, part)                                         \
    test_error(err, status, part, __FILE__, __LINE__)

void test_error(const ovr_error *err, ovr_status status, const char *part,
                const char *file, int line);

/* Returns a random number, uniform in [from, to), the same on every machine. */
double test_random(uint64_t *state, double from, double to);

/* Returns the number of draws of a survey: `few` in make check, `many` in make
 * verify, or the number in OVERROLL_RUNS. */
int test_draws(int few, int many);

/* Returns a name (" f", " 1", ...) for sections that need one, otherwise "". */
const char *test_block_name(const char *section);

/* ----------------------------------------------------------------- files */

/* Make a new folder, and remove it with its contents, as setup and teardown of
 * cmocka. The state is the path. */
int test_make_folder(void **state);
int test_remove_folder(void **state);

/* Returns "folder/name" in one of four static buffers, used in turn. */
const char *test_path(const char *folder, const char *name);

/* Returns the contents of a file with a final NUL, to be freed by the caller;
 * fails the test if it cannot be read. `bytes` may be NULL. */
char *test_read(const char *path, size_t *bytes);

/* Writes the file, or fails the test; test_write_text takes a string. */
void test_write(const char *path, const void *data, size_t bytes);
void test_write_text(const char *path, const char *text);

/* Sets a locale with a decimal comma; false: this machine has none. Call
 * setlocale(LC_ALL, "C") afterwards. */
bool test_decimal_comma(void);

/* ------------------------------------------------------------ allocations */

/* Counts allocations through `hook` and makes them fail on demand: pass
 * &faults.hook. Memory is filled with 0xA5, so that code that assumes zeros
 * fails. */
typedef struct test_faults {
    ovr_allocator hook;
    long calls;   /* number of requests */
    double bytes; /* sum of all allocated bytes */
    long live;    /* number of allocations that were not released */
    long fail;    /* number of the call that fails, from 1; 0: none */
    bool onward;  /* all later calls fail, too */
} test_faults;

/* Initializes faults. They must not be copied, because the hook contains their
 * address. */
void test_faults_init(test_faults *faults);

/*
 * Fails allocation k of `attempt` for k = 1, 2, ... until no allocation fails.
 * `attempt` uses the hook, frees its memory and returns its status, with *err
 * filled. With each fault it must return OVR_NO_MEMORY and a message, and leave
 * nothing allocated. Returns the number of allocations.
 */
typedef ovr_status test_attempt(void *data, const ovr_allocator *hook,
                                ovr_error *err);
long test_every_allocation(test_attempt *attempt, void *data);

#endif
