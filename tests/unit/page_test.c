/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program of the web page (src/web/page.c), compiled for this machine with
 * replacements of the functions that it imports from the page. */
#include "support/test.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int page_main(int argc, char **argv);
void *page_alloc(size_t bytes);
void page_free(void *memory);
int page_stop(void);
int page_wants(void);
void page_field(int k, size_t n, const double *values);
void page_state(double T, double fraction, double b, double p);
int overroll_main(int argc, char **argv);

enum { FIELDS = 9, NODES = 2000, X = 0, P, H, S, FILM, T1, T2, T3, TOUCH };

/* The last state, and after how many the page asks for an end. */
static struct {
    size_t n[FIELDS];
    double value[FIELDS][NODES];
    double T, fraction, b, p;
    int states, stop_after;
} page;

int page_stop(void)
{
    return page.stop_after && page.states >= page.stop_after;
}

int page_wants(void)
{
    return 1;
}

void page_field(int k, size_t n, const double *values)
{
    assert_in_range(k, 0, FIELDS - 1);
    assert_in_range(n, 3, NODES);
    if (k == 0)
        memset(page.n, 0, sizeof page.n);
    page.n[k] = n;
    memcpy(page.value[k], values, n * sizeof *values);
}

void page_state(double T, double fraction, double b, double p)
{
    assert_true(fraction >= page.fraction);
    page.T = T;
    page.fraction = fraction;
    page.b = b;
    page.p = p;
    page.states++;
}

/* Runs words separated by spaces, after "overroll", with standard output in the
 * file "out". */
static int call(const char *words)
{
    enum { MOST = 16 };
    char *text = strdup(words), *argv[MOST] = {(char *)"overroll"};
    int argc = 1, code, out, before;
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " "))
        argv[argc++] = word;
    fflush(stdout);
    before = dup(STDOUT_FILENO);
    out = open("out", O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(out, STDOUT_FILENO);
    page.fraction = page.states = 0;
    code = page_main(argc, argv);
    fflush(stdout);
    dup2(before, STDOUT_FILENO);
    close(out);
    close(before);
    free(text);
    return code;
}

static void write_text(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static bool printed(const char *what)
{
    static char text[1 << 20];
    FILE *file = fopen("out", "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    return strstr(text, what) != NULL;
}

static double integral_of_pressure(void)
{
    double sum = 0;
    for (size_t i = 1; i < page.n[X]; i++)
        sum += (page.value[X][i] - page.value[X][i - 1]) *
               (page.value[P][i] + page.value[P][i - 1]) / 2;
    return sum;
}

static const char steady[] = "[contact]\nM = 20\nL = 10\n"
                             "[domain]\nlevel = 5\n";
static const char dent[] = "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 5\n"
                           "[time]\nend = 2\n[feature a]\nshape = dent\n"
                           "depth = 0.1\nwidth = 0.5\nstart = -1\n";

TEST_IN_FOLDER(the_steady_film_comes_with_the_fields_that_it_has)
{
    assert_int_equal(chdir(*state), 0);
    write_text("case.ini", steady);
    assert_int_equal(call("solve case.ini --steady --json"), 0);
    assert_true(printed("\"H_cen\""));
    assert_int_equal(page.states, 1);
    assert_int_equal(page.n[P], 7 * 32 + 1);
    assert_int_equal(page.n[H], page.n[X]);
    assert_int_equal(page.n[S] + page.n[FILM] + page.n[T1] + page.n[TOUCH], 0);
    assert_true(fabs(integral_of_pressure() - acos(-1) / 2) < 1e-5);
    assert_true(page.b == 1 && page.p == 1);
}

TEST_IN_FOLDER(temperatures_are_passed_of_a_hot_film)
{
    assert_int_equal(chdir(*state), 0);
    assert_int_equal(call("init hot --set domain.level=5 -o case.ini --force"),
                     0);
    assert_int_equal(call("solve case.ini --steady --json"), 0);
    assert_int_equal(page.n[T1], page.n[X]);
    assert_int_equal(page.n[T3], page.n[X]);
    /* The supply has 60 degC; a film that slips is the warmer in its middle. */
    assert_true(page.value[T1][0] > 332 && page.value[T1][0] < 335);
    assert_true(page.value[T3][page.n[X] / 2] > page.value[T1][page.n[X] / 2]);
}

TEST_IN_FOLDER(a_stopped_run_resumes_to_the_same_film)
{
    static double whole[NODES];
    assert_int_equal(chdir(*state), 0);
    write_text("case.ini", dent);
    assert_int_equal(call("solve case.ini -o whole.h5 --json"), 0);
    assert_true(page.n[S] > 0);
    assert_in_range(page.states, 10, 1000);
    assert_true(page.fraction >= 1); /* the last step may end beyond */
    memcpy(whole, page.value[H], sizeof whole);
    page.stop_after = 5;
    assert_int_not_equal(call("solve case.ini -o part.h5 --json"), 0);
    assert_true(page.fraction < 1);
    page.stop_after = 0;
    assert_int_equal(call("solve part.h5 --resume --json"), 0);
    assert_true(page.fraction >= 1);
    assert_memory_equal(whole, page.value[H], page.n[H] * sizeof *whole);
}

TEST_IN_FOLDER(keys_entries_and_mistakes_are_printed)
{
    assert_int_equal(chdir(*state), 0);
    assert_int_equal(call("keys"), 0);
    assert_true(printed("\"section\": \"strip\"") && printed("\"units\""));
    write_text("case.ini", steady);
    assert_int_equal(call("entries case.ini"), 0);
    assert_true(printed("\"given\": true") && printed("\"applies\": false"));
    write_text("case.ini", "[contact]\nload = 3 kg\n");
    assert_int_not_equal(call("entries case.ini"), 0);
    assert_int_not_equal(call("solve case.ini --steady"), 0);
    assert_int_not_equal(call("solve"), 0);
    void *memory = page_alloc(64);
    assert_non_null(memory);
    page_free(memory);
}
