/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A physics is a file and a row. This program is the library and its command
 * line with another list of physics that contains a soft layer (layer.c). No
 * other code refers to the layer, but its keys are read, rejected and
 * explained, it is solved in steady contacts and runs, its quantities are
 * observed and summarized, `check` includes it, and a killed run continues with
 * the same bits. */
#include "support/deformation.h"
#include "support/test.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "overroll/case.h"
#include "overroll/overroll.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"

extern const ovr_physics test_layer, ovr_physics_reversal, ovr_physics_fourth,
    ovr_physics_heat, ovr_physics_stress, ovr_physics_conserving,
    ovr_physics_patches;

const ovr_physics *const ovr_physics_list[] = {&ovr_physics_reversal,
                                               &ovr_physics_fourth,
                                               &ovr_physics_conserving,
                                               &ovr_physics_heat,
                                               &ovr_physics_patches,
                                               &ovr_physics_stress,
                                               &test_layer,
                                               NULL};

/* main of the program under another name (Makefile). */
int overroll_main(int argc, char **argv);

static const char contact[] = "[contact]\nM = 20\nL = 10\n"
                              "[domain]\nlevel = 6\norder = 2\n";
static const char soft[] = "[layer]\ncompliance = 0.5\n";

/* ------------------------------------------------------------- the program */

enum { WORDS = 16 };

/* A process of its own: "overroll" and these words, what it prints in the file
 * `said` of the folder. */
static pid_t begin(const char *folder, const char *const words[])
{
    char *argv[WORDS] = {(char *)"overroll"};
    int count = 1;
    for (; words[count - 1]; count++)
        argv[count] = (char *)words[count - 1];
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        if (chdir(folder) || !freopen("said", "w", stdout) ||
            dup2(STDOUT_FILENO, STDERR_FILENO) < 0)
            _exit(99);
        exit(overroll_main(count, argv));
    }
    assert_true(child > 0);
    return child;
}

static int end_of(pid_t child)
{
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    return status;
}

#define RUN(folder, ...) run(folder, (const char *const[]){__VA_ARGS__, NULL})
static char *run(const char *folder, const char *const words[])
{
    int status = end_of(begin(folder, words));
    char *said = test_read(test_path(folder, "said"), NULL);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        print_message("%s\n", said);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    return said;
}

/* The number of a key of JSON. */
static double number(const char *json, const char *key)
{
    char quoted[60];
    snprintf(quoted, sizeof quoted, "\"%s\": ", key);
    const char *at = strstr(json, quoted);
    if (!at)
        print_message("no %s in:\n%s\n", key, json);
    assert_non_null(at);
    return strtod(at + strlen(quoted), NULL);
}

static void write_case(const char *folder, const char *name, const char *more)
{
    char text[1000];
    snprintf(text, sizeof text, "%s%s", contact, more);
    test_write_text(test_path(folder, name), text);
}

/* -------------------------------------------------------------- its equations
 */

typedef struct solution {
    ovr_case *c;
    ovr_setup *setup;
    ovr_simulation *sim;
    const ovr_state *state;
    const ovr_observation *seen;
} solution;

static solution solve_case(const char *text)
{
    ovr_error err = {0};
    solution s;
    s.c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    assert_non_null(s.c);
    s.setup = ovr_case_resolve(s.c, NULL, &err);
    assert_non_null(s.setup);
    s.sim = ovr_setup_simulation(s.setup, NULL, &err);
    assert_non_null(s.sim);
    CHECK_OK(ovr_simulation_steady(s.sim, &err), &err);
    s.state = ovr_simulation_state(s.sim);
    s.seen = ovr_simulation_observation(s.sim);
    return s;
}

static solution solve(const char *more)
{
    char text[1000];
    snprintf(text, sizeof text, "%s%s", contact, more);
    return solve_case(text);
}

static void release(const solution *s)
{
    ovr_simulation_free(s->sim);
    ovr_setup_free(s->setup);
    ovr_case_free(s->c);
}

/* Half-width of the dry contact if its pressure stays a semi-ellipse, 1/a high,
 * and flattens the gap at X = 0: 1/a^2 + c/a^3 = 1. */
static double wider(double c)
{
    double a = 1;
    for (int k = 0; k < 50; k++)
        a = cbrt(a + c);
    return a;
}

/* The film is that of half-spaces, summed directly, and c P; the pressure
 * carries the load, and is lower by what the contact is wider, as far as it is
 * a semi-ellipse: with the layer it is a little towards a parabola. */
TEST(layer_deforms_under_pressure)
{
    solution hard = solve(""), s = solve(soft);
    size_t n = s.state->n;
    double *w = malloc(n * sizeof *w);
    test_deform_directly(n, s.state->D, s.state->P, w);
    for (size_t i = 0; i < n; i++) {
        double X = s.state->X[i], P = s.state->P[i];
        CHECK_NEAR(s.state->H[i], s.state->H0 + X * X / 2 - w[i] + 0.5 * P,
                   1e-7);
    }
    CHECK_NEAR(s.seen->load_error, 0, 1e-7);
    CHECK_CLOSE(s.seen->P_cen / hard.seen->P_cen, 1 / wider(0.5), 0.06);
    free(w);
    release(&hard);
    release(&s);
}

/* The same over a length. MLMI sums this part of the influence with the
 * logarithm, and as exactly where it is several mesh sizes of the coarsest
 * transfer long. */
TEST(layer_deforms_over_a_length)
{
    solution s = solve("[layer]\ncompliance = 0.5\nspread = 1.5\n");
    size_t n = s.state->n;
    const double *X = s.state->X, *P = s.state->P;
    double *w = malloc(n * sizeof *w), D = s.state->D;
    test_deform_directly(n, D, P, w);
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++)
            w[i] -= 0.5 * D * P[j] * exp(-pow((X[i] - X[j]) / 1.5, 2)) /
                    (1.5 * sqrt(acos(-1.0)));
        CHECK_NEAR(s.state->H[i], s.state->H0 + X[i] * X[i] / 2 - w[i], 1e-7);
    }
    assert_string_equal(ovr_simulation_strategy(s.sim), "");
    free(w);
    release(&s);
}

/* The layer's drag warms the film, and the balance of energy closes with it. */
TEST(its_friction_heats_the_film)
{
    static const char hot[] =
        "alpha = 17 1/GPa\nradius = 20 mm\nmodulus = 226 GPa\n"
        "viscosity = 0.05 Pa.s\nhertz_pressure = 0.5 GPa\nmean_speed = 2 m/s\n"
        "slide_to_roll = -0.2\n"
        "[domain]\nlevel = 6\norder = 2\n[time]\nscheme = upstream2\n"
        "[heat]\nmodel = lobatto\ntemperature = 60 degC\n"
        "[layer]\ncompliance = 0.1\nhysteresis = ";
    double rise[2], defect[2];
    for (int k = 0; k < 2; k++) {
        char text[1000];
        snprintf(text, sizeof text, "[contact]\n%s%g\n", hot, k * 0.1);
        solution s = solve_case(text);
        rise[k] = s.seen->T_max_rise;
        defect[k] = s.seen->energy_defect;
        release(&s);
    }
    print_message("rise %.3g K, with the layer's heat %.3g K; defects %.1e, "
                  "%.1e\n",
                  rise[0], rise[1], defect[0], defect[1]);
    assert_true(rise[1] > 1.05 * rise[0]);
    CHECK_NEAR(defect[1], 0, 2 * fabs(defect[0]) + 1e-3);
}

static int cycles_on_the_finest(const solution *s)
{
    int count;
    const ovr_refinement *r = ovr_simulation_refinements(s->sim, &count);
    return count ? r[count - 1].cycles : 0;
}

/* Smoothers, coarse grids and Newton's method include its influence, so that
 * about as many cycles are needed as without it. Nested iteration needs more,
 * because the first guess is a contact of half-spaces, from which steps in load
 * lead to the film with faces = gap. */
TEST(cycles_stay_as_many)
{
    solution hard = solve(""), s = solve(soft);
    print_message("%d cycles, without the layer %d\n", cycles_on_the_finest(&s),
                  cycles_on_the_finest(&hard));
    assert_true(cycles_on_the_finest(&hard) > 0);
    assert_true(cycles_on_the_finest(&s) <= cycles_on_the_finest(&hard) + 2);
    assert_string_equal(ovr_simulation_strategy(s.sim), "");
    release(&hard);
    release(&s);
}

/* Without slip its drag is all of the sliding force: f times the load. */
TEST(drag_adds_to_friction)
{
    solution s = solve("[layer]\ncompliance = 0.1\nhysteresis = 0.01\n");
    CHECK_CLOSE(s.seen->F_slide, 0.01 * s.seen->load, 1e-6);
    release(&s);
}

/* ------------------------------------------------------------------- its case
 */

TEST(keys_are_read_and_refused)
{
    static const struct {
        const char *text, *what;
    } wrong[] = {
        {"[layer]\ncompliance = -1\n", "case:8: compliance"},
        {"[layer]\nstiffness = 1\n", "case:8: unknown key"},
        {"[domain]\norder = 4\n[layer]\ncompliance = 1\n", "order = 2 does"}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        char text[1000];
        ovr_error err = {0};
        snprintf(text, sizeof text, "%s%s%s", "[contact]\nM = 20\nL = 10\n",
                 k < 2 ? "[domain]\nlevel = 6\norder = 2\n" : "",
                 wrong[k].text);
        ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
        ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
        assert_null(setup);
        CHECK_ERROR(&err, OVR_BAD_INPUT, wrong[k].what);
        ovr_case_free(c);
    }
}

TEST_IN_FOLDER(help_explains_its_keys)
{
    char *said = RUN(*state, "help", "layer");
    assert_non_null(strstr(said, "compliance"));
    assert_non_null(strstr(said, "its drag over the pressure"));
    free(said);
}

TEST_IN_FOLDER(check_counts_it)
{
    static const double n = 7 * 4096 + 1; /* of level 12 */
    write_case(*state, "soft.ini", soft);
    char *said = RUN(*state, "check", "-v", "soft.ini");
    assert_non_null(strstr(said, "layer on body 1"));
    assert_non_null(strstr(said, "[layer]\ncompliance = 0.5"));
    free(said);
    said = RUN(*state, "check", "soft.ini", "--json", "--level", "12", "--set",
               "time.end=1");
    double bytes = number(said, "memory_bytes");
    double seconds = number(said, "estimated_seconds");
    double node_steps = n * number(said, "steps");
    free(said);
    said = RUN(*state, "check", "soft.ini", "--json", "--level", "12", "--set",
               "time.end=1", "--set", "layer.compliance=0");
    bytes -= number(said, "memory_bytes");
    seconds -= number(said, "estimated_seconds");
    free(said);
    /* a steady start needs some more steps */
    assert_true(seconds >= test_layer.in_case->node_seconds * node_steps);
    assert_true(seconds < 2 * test_layer.in_case->node_seconds * node_steps);
    /* worn depth, now and kept */
    assert_true(bytes >= 2 * n * sizeof(double));
    assert_true(bytes < 2.2 * n * sizeof(double));
}

/* -------------------------------------------------------------------- its run
 */

static const char worn[] = "[time]\nend = 4\n"
                           "[layer]\ncompliance = 0.5\nwear = 0.02\n"
                           "hysteresis = 0.01\nspread = 0.4\n"
                           "[output]\nevery = 20\ncheckpoint = 5 ms\n";

/* What is worn at the end is P's integral in time: k T P_max within the change
 * of P on the way. */
TEST_IN_FOLDER(wears_and_reports)
{
    write_case(*state, "worn.ini", worn);
    char *said = RUN(*state, "run", "worn.ini", "--json", "-o", "worn.h5");
    double depth = number(said, "worn_depth"), P = number(said, "P_max");
    assert_true(depth > 0.02 * 4 * 0.9 * P && depth < 0.02 * 4 * 1.3 * P);
    assert_non_null(strstr(said, "the layer is worn by"));
    /* its row is all that the extreme and the mean over the run need */
    assert_true(number(said, "worn_depth_max") == depth);
    assert_true(number(said, "T_worn_depth_max") >= 4);
    assert_true(number(said, "worn_depth_mean") > 0.4 * depth &&
                number(said, "worn_depth_mean") < 0.6 * depth);
    free(said);
    said = RUN(*state, "run", "worn.ini", "--force", "-o", "worn.h5");
    assert_non_null(strstr(said, "\nworn depth "));
    free(said);
    said = RUN(*state, "info", "worn.h5");
    assert_non_null(strstr(said, "worn_depth"));
    free(said);
}

static void wait_ms(long ms)
{
    nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000}, NULL);
}

/* Some time after its files are there; false when it had ended by then. */
static bool killed(const char *folder, long after_ms)
{
    static const char *const words[] = {"run",      "worn.ini", "-o",
                                        "again.h5", "--force",  NULL};
    const char *checkpoint = test_path(folder, "again.h5.restart");
    remove(checkpoint);
    pid_t child = begin(folder, words);
    for (int k = 0; k < 4000 && access(checkpoint, F_OK); k++)
        wait_ms(5);
    for (int k = 0; k < 4000 && access(test_path(folder, "again.h5"), F_OK);
         k++)
        wait_ms(5);
    wait_ms(after_ms);
    kill(child, SIGKILL);
    return WIFSIGNALED(end_of(child));
}

static char *exported(const char *folder, const char *file, const char *what)
{
    const char *const words[] = {"export", file, what, "--long", NULL};
    if (what)
        return run(folder, words);
    return RUN(folder, "export", file);
}

/* Before the first checkpoint there is nothing to go on with, and after the end
 * nothing left: killed again, later or sooner, until it is between. */
static bool goes_on(const char *folder)
{
    bool found = false;
    long ms = 20;
    for (int k = 0; k < 20 && !found; k++) {
        bool was = killed(folder, ms);
        char *said = was ? RUN(folder, "resume", "again.h5") : NULL;
        found = said && strstr(said, "continuing from T");
        ms = was ? 3 * ms / 2 + 1 : ms / 2;
        free(said);
    }
    return found;
}

TEST_IN_FOLDER(resumes_after_a_kill)
{
    char text[600];
    /* Much longer than the wait: however busy the machine, some wait ends
     * before the run does. */
    snprintf(text, sizeof text, "%s[time]\nend = 30\n", strchr(worn, '[') + 15);
    write_case(*state, "worn.ini", text);
    free(RUN(*state, "run", "worn.ini", "-o", "worn.h5", "--force"));
    assert_true(goes_on(*state));
    for (int k = 0; k < 2; k++) {
        char *whole = exported(*state, "worn.h5", k ? "--all" : NULL);
        char *again = exported(*state, "again.h5", k ? "--all" : NULL);
        assert_string_equal(whole, again);
        assert_true(k || strstr(whole, "worn_depth"));
        free(whole);
        free(again);
    }
}
