/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arguments for the calls written by arguments.py: a valid value of each type,
 * created again if a call may free it, and the child processes that make the
 * calls. */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <overroll/overroll.h>

enum { REFUSED = 10, TAKEN, SURVIVED, NONE };

typedef struct row {
    const char *function, *bad;
    int (*call)(void);
    int optional; /* NULL or NaN is a value there */
} row;

/* ------------------------------------------------------------ good values */

enum { NODES = 113, CAPACITY = 1 << 16 };

static void *fresh(void)
{
    return calloc(CAPACITY, 1);
}

static void *copied(const void *value, size_t size)
{
    return memcpy(fresh(), value, size);
}

static const char dent[] = "[contact]\nradius = 10 mm\nviscosity = 40 mPa.s\n"
                           "M = 20\nL = 10\nmodulus = 226 GPa\n"
                           "slide_to_roll = 0.1\n[domain]\nlevel = 4\n"
                           "order = 2\n[time]\nend = 0.2\nscheme = upstream2\n"
                           "[lubricant]\nalpha = 17 1/GPa\n"
                           "[stress]\nsurface = both\n"
                           "[feature dent]\nshape = dent\ndepth = 0.1\n"
                           "width = 0.5\nstart = -1\n";
static const char study[] = "[study]\ncase = dent.ini\noutput = out\n"
                            "[product]\ncontact.M = 20, 21\n";

static struct {
    ovr_case *c;
    ovr_setup *setup;
    ovr_simulation *sim;
    ovr_run *run;
    ovr_result *result;
    ovr_study *study;
    ovr_table *table;
    ovr_find *find;
    ovr_stored_stress *stored;
    ovr_profile *profile;
    ovr_error err;
    ovr_extreme extreme;
    double numbers[4096];
    float singles[4096];
    ovr_result *results[3];
    const ovr_stress_report *reports[2];
} own;

static void write_file(const char *path, const char *text)
{
    FILE *to = fopen(path, "w");
    if (to)
        fputs(text, to);
    if (!to || fclose(to)) {
        printf("%s cannot be written\n", path);
        exit(1);
    }
}

static void *made(void *object, const char *what)
{
    if (!object) {
        printf("%s: %s\n", what, own.err.message);
        exit(1);
    }
    return object;
}

static ovr_extreme *extreme(void)
{
    ovr_extreme_at(0, &own.extreme);
    return &own.extreme;
}

static ovr_run *new_run(const char *path)
{
    ovr_run_options how = {0};
    how.output = path;
    how.force = true;
    return ovr_run_create(own.c, &how, NULL, &own.err);
}

static ovr_find *new_find(void)
{
    ovr_find_options how = {0};
    how.key = "contact.L";
    how.low = "5", how.high = "15";
    how.condition = "H_cen_moes is 0.2";
    return ovr_find_create(own.c, &how, &own.err);
}

static void make_files(void)
{
    write_file("dent.ini", dent);
    write_file("study.ini", study);
    own.c = made(ovr_case_read("dent.ini", NULL, &own.err), "case");
    own.run = made(new_run("made.h5"), "run");
    if (ovr_run_execute(own.run, &own.err))
        made(NULL, "run");
    own.result = made(ovr_result_open("made.h5", NULL, &own.err), "result");
    own.results[0] = own.results[1] = own.results[2] = own.result;
    own.study = made(ovr_study_read("study.ini", NULL, &own.err), "study");
    own.table = made(ovr_study_table(own.study, &own.err), "table");
    own.find = made(new_find(), "search");
    own.stored = made(ovr_stored_stress_create("made.h5", NULL, NULL, &own.err),
                      "stored stress");
    own.reports[0] = own.reports[1] = ovr_stored_stress_report(own.stored, 1);
}

static void make_objects(void)
{
    ovr_profile_source source = ovr_profile_source_default();
    for (int i = 0; i < 4096; i++) {
        own.numbers[i] = 1 + 0.01 * i;
        own.singles[i] = (float)own.numbers[i];
    }
    own.setup = made(ovr_case_resolve(own.c, NULL, &own.err), "setup");
    if (ovr_setup_prepare(own.setup, NULL, &own.err))
        made(NULL, "setup");
    own.sim = made(ovr_setup_simulation(own.setup, NULL, &own.err), "sim");
    if (ovr_simulation_steady(own.sim, &own.err))
        made(NULL, "steady");
    source.file = "dent.csv", source.unit_x = "mm", source.unit_z = "um";
    write_file("dent.csv", "0 0\n1 0\n2 1\n3 0\n4 0\n5 0\n");
    own.profile = made(ovr_profile_read(&source, NULL, &own.err), "profile");
}

static void heights(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data, (void)T, (void)X;
    memset(S, 0, n * sizeof *S);
}

static void listener(void *data, ovr_message_kind kind, const char *text)
{
    (void)data, (void)kind, (void)text;
}

static ovr_picture_options picture(void)
{
    ovr_picture_options made = ovr_picture_options_default();
    made.path = "picture.svg";
    return made;
}

static void line(void *data, const char *name, const char *text)
{
    (void)data, (void)name, (void)text;
}

static void written(void *data, const char *text)
{
    (void)data, (void)text;
}

static void taker(void *data, const ovr_summary_line *one)
{
    (void)data, (void)one;
}

static ovr_status change(void *data, ovr_case *c, ovr_error *err)
{
    (void)data, (void)c, (void)err;
    return OVR_OK;
}

static const char *const words[] = {"dent", "bump", NULL};

#define GOOD_char_to "dent"
#define GOOD_char_to_const_to words
#define GOOD_char_to_to words
#define GOOD_double_to own.numbers
#define GOOD_float_to own.singles
#define GOOD_size_t 3
#define GOOD_void_to fresh()
#define GOOD_unsigned_char_to (const unsigned char *)"dent"
#define GOOD_ovr_allocator_to NULL
#define GOOD_ovr_status OVR_IO
#define GOOD_ovr_error_to (&own.err)
#define GOOD_ovr_case_to own.c
#define GOOD_ovr_setup_to own.setup
#define GOOD_ovr_simulation_to own.sim
#define GOOD_ovr_run_to own.run
#define GOOD_ovr_run_info_to ovr_run_get_info(own.run)
#define GOOD_ovr_result_to own.result
#define GOOD_ovr_result_to_const_to own.results
#define GOOD_ovr_result_to_to own.results
#define GOOD_ovr_study_to own.study
#define GOOD_ovr_table_to own.table
#define GOOD_ovr_find_to own.find
#define GOOD_ovr_sample_to NULL
#define GOOD_ovr_sensitivity_to NULL
#define GOOD_ovr_trials_to NULL
#define GOOD_ovr_stored_stress_to own.stored
#define GOOD_ovr_stress_report_to_const_to own.reports
#define GOOD_ovr_stress_report_to_to own.reports
#define GOOD_ovr_profile_to own.profile
#define GOOD_ovr_profile_view_to ovr_profile_get_view(own.profile)
#define GOOD_ovr_history_to own.setup->speed
#define GOOD_ovr_surfaces_to own.setup->surfaces
#define GOOD_ovr_contact_to own.setup->contact
#define GOOD_ovr_lubricant_to own.setup->lubricant
#define GOOD_ovr_observation_to ovr_simulation_observation(own.sim)
#define GOOD_ovr_statistics_to ovr_simulation_statistics(own.sim)
#define GOOD_ovr_observable_to ovr_observable_at(3)
#define GOOD_ovr_extreme_to extreme()
#define GOOD_ovr_in_plane ((ovr_in_plane){0})
#define GOOD_ovr_heights_to heights
#define GOOD_ovr_listener_to listener
#define GOOD_ovr_setup_line_to line
#define GOOD_ovr_case_line_to written
#define GOOD_ovr_summary_taker_to taker
#define GOOD_ovr_status_to_void_to_data_ovr_case_to_c_ovr_error_to_err change
#define GOOD_ovr_picture_options_to                                            \
    copied(&(ovr_picture_options[]){picture()}, sizeof(ovr_picture_options))

/* ------------------------------------------------------------------- calls */

/* How the child ended; above 100: by that signal. */
static int try_one(const row *r)
{
    int how = 0;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        alarm(10);
        own.err = (ovr_error){0};
        _exit(r->call());
    }
    if (child < 0 || waitpid(child, &how, 0) != child)
        return NONE;
    return WIFSIGNALED(how) ? 100 + WTERMSIG(how) : WEXITSTATUS(how);
}

static int try_all(const row *rows, size_t count)
{
    int bad = 0;
    make_files();
    make_objects();
    for (size_t k = 0; k < count; k++) {
        const row *r = &rows[k];
        int end = try_one(r);
        int fails = end > SURVIVED || end < REFUSED ||
                    (end == TAKEN && !r->optional);
        if (fails)
            printf("%s with %s: %s %d\n", r->function, r->bad,
                   end == TAKEN ? "says that all is well"
                   : end > 100  ? "crashes with signal"
                                : "ends",
                   end > 100 ? end - 100 : end);
        bad += fails;
    }
    printf("%zu calls, %d of them go wrong\n", count, bad);
    return bad > 0;
}
