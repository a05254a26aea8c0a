/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mixed lubrication with a varying speed, which stops, starts from rest and
 * reverses, and a cam and a gear over the complete cycle. Reference at rest: P
 * = A(H), A = exp(-H/s) on [-1.5, 1.5], 449 nodes, without lubricant, by dense
 * Newton's method in another language; residual 2e-13; copied from
 * truth/contact.json of the project's shared folder. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "support/test.h"

#include "contact/film_formula.h"
#include "overroll/overroll.h"

enum { SHARE, AREA, A_MAX };

static const char *const rest[] = {"contact.M=100",
                                   "contact.L=1",
                                   "lubricant.alpha=17 1/GPa",
                                   "domain.inlet=-1.5",
                                   "domain.outlet=1.5",
                                   "domain.level=6",
                                   "time.end=20000",
                                   "time.step=20",
                                   "time.scheme=upstream2",
                                   "speed.history=ramp",
                                   "speed.from=1",
                                   "speed.to=0",
                                   "speed.duration=1",
                                   "boundary.amplitude=1",
                                   "output.every=100000",
                                   NULL};

/* 1 GPa, Eyring's oil; lambda 1 at its mean speed. */
static const char *const ground[] = {"contact.hertz_pressure=1 GPa",
                                     "contact.radius=6.84 mm",
                                     "contact.modulus=227 GPa",
                                     "contact.mean_speed=3.22 m/s",
                                     "contact.slide_to_roll=0.3",
                                     "contact.viscosity=10 mPa.s",
                                     "contact.alpha=20 1/GPa",
                                     "lubricant.rheology=eyring",
                                     "lubricant.eyring_stress=5 MPa",
                                     "domain.level=5",
                                     "domain.outlet=4",
                                     "domain.inlet=-4",
                                     "boundary.Rq=194 nm",
                                     "boundary.slope=0.03",
                                     "boundary.friction=0.11",
                                     NULL};

/* A whole event, its speed turning four times; of the pitch line. */
static const char *const cam[] = {"cam.follower=flat",
                                  "cam.base_radius=26 mm",
                                  "cam.face=12 mm",
                                  "cam.speed=1000 rpm",
                                  "cam.law=4567",
                                  "cam.lift=6 mm",
                                  "cam.rise=70 deg",
                                  "cam.spring=30 N/mm",
                                  "cam.preload=250 N",
                                  "cam.mass=100 g",
                                  "contact.modulus=226 GPa",
                                  "lubricant.viscosity=10 mPa.s",
                                  "lubricant.alpha=15 1/GPa",
                                  "lubricant.rheology=eyring",
                                  "domain.level=5",
                                  "lubricant.eyring_stress=5 MPa",
                                  "boundary.Rq=200 nm",
                                  "boundary.slope=0.03",
                                  "boundary.friction=0.1",
                                  NULL};

static const char *const gear[] = {"gear.module=3 mm",
                                   "gear.teeth_1=20",
                                   "gear.teeth_2=40",
                                   "gear.centre=90 mm",
                                   "gear.face=20 mm",
                                   "gear.speed=1000 rpm",
                                   "gear.sharing=rule",
                                   "gear.blend=0.0451651",
                                   "contact.modulus=226 GPa",
                                   "contact.hertz_pressure=1 GPa",
                                   "lubricant.viscosity=11 mPa.s",
                                   "lubricant.alpha=16 1/GPa",
                                   "domain.level=5",
                                   "lubricant.rheology=eyring",
                                   "lubricant.eyring_stress=5 MPa",
                                   "boundary.Rq=300 nm",
                                   "boundary.slope=0.03",
                                   "boundary.friction=0.1",
                                   NULL};

static void assign(ovr_case *c, const char *setting)
{
    ovr_error err = {0};
    CHECK_OK(ovr_case_assign(c, setting, "test", &err), &err);
}

static ovr_case *begin(const char *const *settings)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_create(NULL, &err);
    assert_non_null(c);
    for (; *settings; settings++)
        assign(c, *settings);
    assign(c, "boundary.law=exponential");
    return c;
}

/* To its end, and the case away. */
static ovr_run *gone(ovr_case *c)
{
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    CHECK_OK(run ? OVR_OK : err.status, &err);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    ovr_case_free(c);
    return run;
}

static const ovr_observation *end_of(const ovr_run *run)
{
    return ovr_simulation_observation(ovr_run_get_info(run)->sim);
}

/* Soft and stiff contact law. At the last node, where A is not zero, the
 * reference uses half a weight and the program none. The tolerance in addition
 * to 1e-8 is A at this node, by the gap of dry bodies (0.36) and of the law. */
TEST(asperities_carry_the_load_at_rest)
{
    static const struct {
        const char *decay;
        double H0, H_min, P_max, at_end;
    } of[] = {{"boundary.decay=0.05", -0.5610922412647029,
               0.0024836008987852987, 0.9515414618212708, 3.9e-4},
              {"boundary.decay=0.02", -0.5825764670328836,
               0.0003995540592388602, 0.9802205290775604, 0}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        ovr_case *c = begin(rest);
        assign(c, of[k].decay);
        ovr_run *run = gone(c);
        const ovr_observation *o = end_of(run);
        double near = 1e-8 + of[k].at_end * 3 / 448;
        print_message("at rest: H0 %+.1e, H_min %+.1e, P %+.1e, share 1 "
                      "%+.1e\n",
                      o->H0 - of[k].H0, o->H_min - of[k].H_min,
                      o->more[A_MAX] - of[k].P_max, o->more[SHARE] - 1);
        CHECK_NEAR(o->more[SHARE], 1, 1e-9);
        CHECK_NEAR(o->H0, of[k].H0, near);
        CHECK_NEAR(o->H_min, of[k].H_min, near);
        CHECK_NEAR(o->more[A_MAX], of[k].P_max, near);
        ovr_run_free(run);
    }
}

/* After a stop the film is squeezed out: the asperity load share increases, and
 * the load is conserved. */
TEST(a_stop_squeezes_the_film_out)
{
    double last = 0;
    for (int k = 0; k < 3; k++) {
        static const char *const ends[] = {"time.end=4", "time.end=12",
                                           "time.end=36"};
        ovr_case *c = begin(ground);
        assign(c, "speed.history=ramp");
        assign(c, "speed.from=1");
        assign(c, "speed.to=0");
        assign(c, "speed.duration=4");
        assign(c, ends[k]);
        ovr_run *run = gone(c);
        const ovr_observation *o = end_of(run);
        print_message("%s: share %.4f\n", ends[k], o->more[SHARE]);
        CHECK_NEAR(o->load, acos(-1.0) / 2, 1e-7);
        assert_true(o->more[SHARE] > last + 0.02 && o->more[SHARE] < 1);
        last = o->more[SHARE];
        ovr_run_free(run);
    }
}

/* Started from rest, or turned, the film becomes the steady one, after a turn
 * its mirror image. */
TEST(after_a_reversal_it_is_the_steady_film)
{
    ovr_run *run = gone(begin(ground));
    double share = end_of(run)->more[SHARE], H = end_of(run)->H_cen;
    ovr_run_free(run);
    for (int turns = 0; turns < 2; turns++) {
        ovr_case *c = begin(ground);
        assign(c, "speed.history=ramp");
        assign(c, turns ? "speed.from=1" : "speed.from=0");
        assign(c, turns ? "speed.to=-1" : "speed.to=1");
        assign(c, "speed.duration=4");
        assign(c, "time.end=20");
        run = gone(c);
        const ovr_observation *o = end_of(run);
        double maximum = ovr_simulation_statistics(ovr_run_get_info(run)->sim)
                             ->extreme.more[SHARE];
        print_message("%s: share %.4f at most, %.6f at the end, %.6f steady\n",
                      turns ? "turned" : "from rest", maximum, o->more[SHARE],
                      share);
        assert_true(maximum > 1.2 * share);
        CHECK_CLOSE(o->more[SHARE], share, 1e-4);
        CHECK_CLOSE(o->H_cen, H, 1e-5);
        ovr_run_free(run);
    }
}

static void go_through(const char *const *settings, const char *name)
{
    ovr_run *run = gone(begin(settings));
    const ovr_statistics *s = ovr_simulation_statistics(
        ovr_run_get_info(run)->sim);
    print_message("%s: %ld steps, %.2f of Newton's method each, %ld retries, "
                  "share %.4f in the mean, %.4f at most\n",
                  name, s->steps, (double)s->cycles / (double)s->steps,
                  s->retries, s->mean.more[SHARE], s->extreme.more[SHARE]);
    assert_int_equal(s->marked, 0);
    assert_true(s->mean.more[SHARE] > 0.01);
    assert_true(s->extreme.more[SHARE] < 1);
    ovr_run_free(run);
}

TEST(cams_and_gears_go_through)
{
    go_through(cam, "cam");
    go_through(gear, "gear");
}

/* A layer that is a wall, under ridges that slide, at lambda 0.08. */
static const char *const sealed[] = {"contact.hertz_pressure=0.69 GPa",
                                     "contact.radius=6.84 mm",
                                     "contact.modulus=226 GPa",
                                     "contact.mean_speed=0.05 m/s",
                                     "contact.slide_to_roll=1.9",
                                     "contact.viscosity=11 mPa.s",
                                     "contact.alpha=16 1/GPa",
                                     "domain.level=5",
                                     "domain.outlet=2.5",
                                     "time.end=3",
                                     "time.scheme=characteristic",
                                     "time.step=grid",
                                     "boundary.of=unresolved",
                                     "boundary.layer=3 nm",
                                     "boundary.layer_decay=0.05 nm",
                                     "feature f.shape=roughness",
                                     "feature f.Rq=0.2 um",
                                     "feature f.length=12",
                                     "feature f.shortest=8 um",
                                     "feature f.rolloff=40 um",
                                     "feature f.seed=3",
                                     "feature f.start=inlet",
                                     NULL};

static double film_over(const ovr_run *run, double Rq)
{
    const ovr_contact *of = ovr_run_get_info(run)->setup->contact;
    return of->height * ovr_film_central_moes(of->M, of->L) / Rq;
}

/* Failed runs report their lambda ratio, the ratio that can be solved, and the
 * asperity load share of the mean film thickness. */
TEST(failed_runs_suggest_a_lambda_ratio)
{
    ovr_error err = {0};
    ovr_run_options how = {0};
    double lambda = NAN;
    ovr_case *c = begin(sealed);
    assign(c, "boundary.law=layer");
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    CHECK_OK(run ? OVR_OK : err.status, &err);
    assert_int_equal(ovr_run_execute(run, &err), OVR_NOT_CONVERGED);
    print_message("%s\n", err.message);
    const char *told = strstr(err.message, "lambda ratio is ");
    assert_non_null(told);
    assert_int_equal(sscanf(told, "lambda ratio is %lf", &lambda), 1);
    /* Predicted film thickness divided by the Rq of the profile in the contact
     * at the time of failure; with a dozen waves it differs by twice 1/sqrt(2 x
     * 12) from that of the whole profile. */
    CHECK_CLOSE(lambda, film_over(run, 0.2e-6), 0.4);
    assert_non_null(strstr(err.message, "0.3"));
    assert_non_null(strstr(err.message, "of = all"));
    ovr_run_free(run);
    ovr_case_free(c);
}
