/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Included first by every cmocka test: cmocka, comparison of numbers with a
 * tolerance, files, and an allocator that counts and fails. */
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
 * TEST(what_holds) { ... } is a test of the program tests/KIND/NAME_test, which
 * runs those of its file from the first to the last.  TEST_WITH has a setup and
 * a teardown of cmocka's, either NULL; TEST_IN_FOLDER a new folder as *state.
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

/* A setup and a teardown, either NULL, of all tests of a file. */
#define TEST_GROUP(begin, end)                                                 \
    __attribute__((constructor)) static void register_group(void)              \
    {                                                                          \
        static test_listed listed_group = {                                    \
            .begins = begin, .ends = end, .file = __FILE__, .line = __LINE__}; \
        test_list(&listed_group);                                              \
    }

typedef struct test_listed {
    struct CMUnitTest test; /* without a function: a group */
    CMFixtureFunction begins, ends;
    const char *file;
    int line;
    struct test_listed *next;
} test_listed;

/* Called before main() by what these macros make. */
void test_list(test_listed *one);

/* --------------------------------------------------------------- numbers */

/* |actual - expected| <= tolerance, absolute.  A NaN is never near; equal
 * infinities are. */
#define CHECK_NEAR(actual, expected, tolerance)                                \
    test_near(actual, expected, tolerance, false, #actual, __FILE__, __LINE__)

/* |actual - expected| <= tolerance |expected|. */
#define CHECK_CLOSE(actual, expected, tolerance)                               \
    test_near(actual, expected, tolerance, true, #actual, __FILE__, __LINE__)

void test_near(double actual, double expected, double tolerance, bool relative,
               const char *what, const char *file, int line);

/* A status, with the error's message shown when it is another. */
#define CHECK_STATUS(actual, expected, err)                                    \
    test_status(actual, expected, err, #actual, __FILE__, __LINE__)
#define CHECK_OK(actual, err) CHECK_STATUS(actual, OVR_OK, err)

void test_status(ovr_status actual, ovr_status expected, const ovr_error *err,
                 const char *what, const char *file, int line);

/* The error is `status` and its message holds `part`, in one line. */
#define CHECK_ERROR(err, status, part)                                         \
    test_error(err, status, part, __FILE__, __LINE__)

void test_error(const ovr_error *err, ovr_status status, const char *part,
                const char *file, int line);

/* Random numbers, the same on every machine: uniform in [from, to). */
double test_random(uint64_t *state, double from, double to);

/* Returns the number of draws of a survey: `few` in make check, `many` in make
 * verify, or the number in OVERROLL_RUNS. */
int test_draws(int few, int many);

/* " f", " 1", ...: a name for sections that need one, else "". */
const char *test_block_name(const char *section);

/* ----------------------------------------------------------------- files */

/* A new empty folder, removed with its contents by test_remove_folder; both
 * in the form of cmocka's setup and teardown (the state is the path). */
int test_make_folder(void **state);
int test_remove_folder(void **state);

/* "folder/name" in a static buffer, one of four taken in turn. */
const char *test_path(const char *folder, const char *name);

/* Returns the contents of a file with a final NUL, to be freed by the caller;
 * fails the test if it cannot be read. `bytes` may be NULL. */
char *test_read(const char *path, size_t *bytes);

/* Writes the file, or fails the test; test_write_text takes a string. */
void test_write(const char *path, const void *data, size_t bytes);
void test_write_text(const char *path, const char *text);

/* A locale that writes 1,5; false: there is none here.  setlocale(LC_ALL, "C")
 * ends it. */
bool test_decimal_comma(void);

/* ------------------------------------------------------------ allocations */

/* Counts allocations through `hook` and makes them fail on demand: pass
 * &faults.hook. Memory is filled with 0xA5, so that code that assumes zeros
 * fails. */
typedef struct test_faults {
    ovr_allocator hook;
    long calls;   /* allocations asked for */
    double bytes; /* of all that were given */
    long live;    /* pieces not yet released */
    long fail;    /* the call that fails, from 1; 0: none */
    bool onward;  /* all calls after that one fail too */
} test_faults;

/* Faults cannot be copied: the hook points back at them. */
void test_faults_init(test_faults *faults);

/*
 * Fails the k-th allocation of `attempt` for k = 1, 2, ... until it succeeds
 * without a fault.  `attempt` uses the hook, frees what it made, and returns
 * its status with *err filled; each fault must give OVR_NO_MEMORY with a
 * message and leave nothing allocated.  Returns the number of allocations.
 */
typedef ovr_status test_attempt(void *data, const ovr_allocator *hook,
                                ovr_error *err);
long test_every_allocation(test_attempt *attempt, void *data);

#endif
