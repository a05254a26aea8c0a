/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Running-in: wear of surfaces in asperity contact. */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/test.h"

#include "overroll/overroll.h"
#include "physics/mixed/wear.h"
#include "simulation/simulation.h"

/* Two rough flanks at lambda 1, short of places so that laws cost little. */
static const char *const flanks[] = {
    "contact.hertz_pressure=1 GPa",  "contact.radius=6.84 mm",
    "contact.modulus=227 GPa",       "contact.slide_to_roll=0.3",
    "contact.mean_speed=2 m/s",      "contact.viscosity=10 mPa.s",
    "contact.alpha=20 1/GPa",        "lubricant.rheology=eyring",
    "lubricant.eyring_stress=5 MPa", "domain.level=5",
    "boundary.law=profile",          "boundary.friction=0.11",
    "boundary.wear_1=1e-8 mm3/Nm",   "boundary.wear_2=3e-8 mm3/Nm",
    "feature one.shape=roughness",   "feature one.Rq=150 nm",
    "feature one.length=0.4 mm",     "feature one.shortest=20 um",
    "feature two.shape=roughness",   "feature two.surface=2",
    "feature two.Rq=120 nm",         "feature two.length=0.4 mm",
    "feature two.shortest=20 um",    "feature two.seed=2"};

static ovr_case *begin(void)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_create(NULL, &err);
    assert_non_null(c);
    for (size_t k = 0; k < sizeof flanks / sizeof *flanks; k++)
        CHECK_OK(ovr_case_assign(c, flanks[k], "test", &err), &err);
    return c;
}

static void assign(ovr_case *c, const char *setting)
{
    ovr_error err = {0};
    CHECK_OK(ovr_case_assign(c, setting, "test", &err), &err);
}

/* What is seen of each state of a run. */
typedef struct seen {
    int count;
    double share[100], mu[100], peaks[100], passes[100], worn[2][100];
    double lost[2][100]; /* of the profiles themselves, in the mean */
} seen;

enum { SHARE = 0, PASSES = 8, WEAR_1, WEAR_2, PEAKS_1 };

static double mean(size_t n, const double *z)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += z[i] / (double)n;
    return sum;
}

static ovr_status look(void *data, const ovr_simulation *sim, ovr_error *err)
{
    seen *s = data;
    const ovr_observation *o = ovr_simulation_observation(sim);
    const ovr_wear *w = ovr_wear_of(sim);
    int k = s->count++;
    (void)err;
    assert_true(k < 100);
    s->share[k] = o->more[SHARE];
    s->mu[k] = fabs(o->mu_slide);
    s->peaks[k] = o->more[PEAKS_1];
    s->passes[k] = o->more[PASSES];
    for (int m = 0; m < 2; m++) {
        s->worn[m][k] = o->more[WEAR_1 + m];
        s->lost[m][k] = mean(w->pair.n, w->given->pair.z[m]) -
                        mean(w->pair.n, w->now.z[m]);
    }
    return OVR_OK;
}

static seen run(ovr_case *c, const char *path)
{
    ovr_run_options how = {0};
    ovr_error err = {0};
    seen s = {0};
    how.observe = look;
    how.data = &s;
    how.output = path;
    how.force = true;
    ovr_run *r = ovr_run_create(c, &how, NULL, &err);
    CHECK_OK(r ? OVR_OK : err.status, &err);
    CHECK_OK(ovr_run_execute(r, &err), &err);
    assert_true(ovr_run_get_info(r)->converged);
    ovr_run_free(r);
    return s;
}

/* By Archard: of each surface c_s times what was borne, summed over the jumps;
 * the profiles have lost just that, whatever the law has become.  Surface 2,
 * three times as soft, is slower by 0.85/1.15: each of its places is under load
 * for longer. */
TEST(asperity_load_causes_wear)
{
    ovr_case *c = begin();
    assign(c, "boundary.passes=2e5");
    assign(c, "boundary.jump=2e4");
    seen s = run(c, NULL);
    /* k ph R/b |V|/u, 1e-17 m^2/N; b = 120.5 um */
    double c_1 = 1e-17 * 1e9 * 6.84e-3 / 120.529e-6 * 0.3 / 1.15, depth = 0;
    assert_int_equal(s.count, 11);
    for (int k = 1; k < s.count; k++) {
        depth += 2e4 * c_1 * s.share[k - 1] * acos(-1.0) / 2;
        CHECK_CLOSE(s.worn[0][k], depth, 1e-5);
        CHECK_CLOSE(s.worn[1][k], depth * 3 * 1.15 / 0.85, 1e-5);
        CHECK_NEAR(s.lost[0][k], s.worn[0][k], 1e-14);
        CHECK_NEAR(s.lost[1][k], s.worn[1][k], 1e-14);
        CHECK_CLOSE(s.passes[k], 2e4 * k, 1e-12);
        assert_true(s.share[k] < s.share[k - 1]);
    }
    assert_true(s.peaks[s.count - 1] < 0.9 * s.peaks[0]);
    print_message("share %.4f to %.4f, mu %.4f to %.4f, Rpk %.4f to %.4f\n",
                  s.share[0], s.share[s.count - 1], s.mu[0], s.mu[s.count - 1],
                  s.peaks[0], s.peaks[s.count - 1]);
    ovr_case_free(c);
}

/* Jumps of 2 % of Rq that are chosen go as far as a tenth of them do: of first
 * order in the jump, by which the share falls. */
TEST(jumps_are_short_enough)
{
    double share[3];
    for (int k = 0; k < 3; k++) {
        static const char *const jump[] = {
            "boundary.jump=auto", "boundary.jump=2e3", "boundary.jump=1e3"};
        ovr_case *c = begin();
        assign(c, "boundary.passes=2e4");
        assign(c, jump[k]);
        seen s = run(c, NULL);
        share[k] = s.share[s.count - 1];
        print_message("%s: %d states, share %.5f\n", jump[k], s.count,
                      share[k]);
        ovr_case_free(c);
    }
    double limit = 2 * share[2] - share[1];
    CHECK_CLOSE(share[0], limit, 0.05);
    CHECK_CLOSE(share[1], share[2], 0.02);
}

TEST(it_stops_when_it_has_settled)
{
    ovr_case *c = begin();
    assign(c, "boundary.passes=1e9");
    assign(c, "boundary.jump=1e4");
    assign(c, "boundary.settled=0.05");
    seen s = run(c, NULL);
    int last = s.count - 1;
    assert_true(last > 1 && s.passes[last] < 1e9);
    assert_true(1 - s.share[last] / s.share[last - 1] < 0.05);
    assert_true(1 - s.share[last - 1] / s.share[last - 2] >= 0.05);
    ovr_case_free(c);
}

enum { KILLED_AT = 4 };

static bool is_late(void *calls)
{
    if (++*(int *)calls == KILLED_AT)
        raise(SIGKILL);
    return false;
}

static void run_killed(ovr_case *c, const char *path)
{
    pid_t child = fork();
    int ended = 0;
    if (child == 0) {
        int calls = 0;
        ovr_run_options how = {0};
        how.output = path;
        how.force = true;
        how.data = &calls;
        how.stop = is_late;
        ovr_run *r = ovr_run_create(c, &how, NULL, NULL);
        if (r)
            ovr_run_execute(r, NULL);
        _exit(1);
    }
    assert_true(child > 0 && waitpid(child, &ended, 0) == child);
    assert_true(WIFSIGNALED(ended) && WTERMSIG(ended) == SIGKILL);
}

/* A run killed between two jumps and resumed has the same final state to the
 * bit; the profiles before and after are stored in the file and next to it. */
TEST(killed_runs_go_on)
{
    char folder[] = "/tmp/overroll-wear-XXXXXX", path[100], profile[120];
    ovr_error err = {0};
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/out.h5", folder);
    ovr_case *c = begin();
    assign(c, "boundary.passes=8e4");
    assign(c, "boundary.jump=1e4");
    assign(c, "output.checkpoint=1 ms");
    seen whole = run(c, NULL), rest = {0};
    run_killed(c, path);
    ovr_run_options how = {0};
    how.observe = look;
    how.data = &rest;
    ovr_run *r = ovr_run_resume(path, &how, NULL, &err);
    CHECK_OK(r ? OVR_OK : err.status, &err);
    CHECK_OK(ovr_run_execute(r, &err), &err);
    ovr_run_free(r);
    assert_true(rest.count > 0 && rest.count < whole.count);
    for (int k = 1; k <= rest.count; k++) {
        int one = whole.count - k, other = rest.count - k;
        assert_true(whole.share[one] == rest.share[other]);
        assert_true(whole.mu[one] == rest.mu[other]);
        assert_true(whole.worn[1][one] == rest.worn[1][other]);
        assert_true(whole.peaks[one] == rest.peaks[other]);
    }
    for (int k = 0; k < 4; k++) {
        snprintf(profile, sizeof profile, "%s/out-profile-%d-%s.csv", folder,
                 1 + k / 2, k % 2 ? "after" : "before");
        assert_int_equal(access(profile, R_OK), 0);
        unlink(profile);
    }
    ovr_result *result = ovr_result_open(path, NULL, &err);
    assert_non_null(result);
    assert_non_null(ovr_result_find(result, "wear/profile_1_after"));
    ovr_result_close(result);
    ovr_case_free(c);
    unlink(path);
    strcat(path, ".restart");
    unlink(path);
    rmdir(folder);
}

/* A case that is refused, and by what. */
static void check_refused(ovr_case *c, const char *words)
{
    ovr_error err = {0};
    assert_null(ovr_run_create(c, NULL, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, words);
    ovr_case_free(c);
}

TEST(cases_without_passes_are_rejected)
{
    ovr_case *c = begin();
    check_refused(c, "needs boundary.passes");
    c = begin();
    assign(c, "boundary.passes=10");
    assign(c, "contact.slide_to_roll=2");
    check_refused(c, "surface 2 does not move");
    c = begin();
    assign(c, "boundary.passes=10");
    assign(c, "time.end=3");
    check_refused(c, "cannot be combined with");
}
