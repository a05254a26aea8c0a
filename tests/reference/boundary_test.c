/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady mixed lubrication, P = P_f + A(H). Reference: dense Newton's method on
 * the same discrete equations with P as unknown and its own active set, in
 * another language; residual below 1e-11; copied from truth/contact.json of the
 * project's shared folder. M, L, domain [-4, 1.5], A = exp(-H/s), arithmetic
 * means. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <gsl/gsl_linalg.h>

#include "support/test.h"

#include "overroll/overroll.h"

typedef struct touching {
    double H0, H_cen, H_min, P_max, share, area, load;
    double mu, mu_film, mu_boundary;
    int cycles;
} touching;

enum { SHARE, AREA, A_MAX, H_CONTACT, MU_FILM, MU_BOUNDARY };

static const char *const paper[] = {
    "lubricant.alpha=17 1/GPa", "lubricant.p0=198 MPa",
    "lubricant.z=0.68",         "domain.inlet=-4",
    "domain.outlet=1.5",        "domain.order=2",
    "time.scheme=upstream2",    "domain.faces=arithmetic",
    "solver.tolerance=1e-9",    NULL};

/* 1 GPa, Eyring's oil, both surfaces ground. */
static const char *const gear[] = {"contact.hertz_pressure=1 GPa",
                                   "contact.radius=6.84 mm",
                                   "contact.modulus=227 GPa",
                                   "contact.slide_to_roll=0.3",
                                   "contact.viscosity=10 mPa.s",
                                   "contact.alpha=20 1/GPa",
                                   "lubricant.rheology=eyring",
                                   "lubricant.eyring_stress=5 MPa",
                                   "domain.level=5",
                                   "domain.order=2",
                                   NULL};

static const char *const newtonian[] = {
    "contact.hertz_pressure=1 GPa", "contact.radius=6.84 mm",
    "contact.modulus=227 GPa",      "contact.mean_speed=3 m/s",
    "contact.slide_to_roll=0.3",    "contact.viscosity=10 mPa.s",
    "contact.alpha=20 1/GPa",       NULL};

static void assign(ovr_case *c, const char *setting)
{
    ovr_error err = {0};
    CHECK_OK(ovr_case_assign(c, setting, "test", &err), &err);
}

static void assignf(ovr_case *c, const char *form, ...)
{
    char text[100];
    va_list values;
    va_start(values, form);
    vsnprintf(text, sizeof text, form, values);
    va_end(values);
    assign(c, text);
}

static ovr_case *begin(const char *const *settings)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_create(NULL, &err);
    assert_non_null(c);
    for (; *settings; settings++)
        assign(c, *settings);
    return c;
}

static touching seen(const ovr_run *run)
{
    const ovr_simulation *sim = ovr_run_get_info(run)->sim;
    const ovr_observation *o = ovr_simulation_observation(sim);
    assert_true(o->converged);
    return (touching){.H0 = o->H0,
                      .H_cen = o->H_cen,
                      .H_min = o->H_min,
                      .P_max = o->P_max,
                      .share = o->more[SHARE],
                      .area = o->more[AREA],
                      .load = o->load,
                      .mu = o->mu_slide,
                      .mu_film = o->more[MU_FILM],
                      .mu_boundary = o->more[MU_BOUNDARY],
                      .cycles = o->cycles};
}

/* Frees the case. */
static touching solved(ovr_case *c)
{
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    CHECK_OK(run ? OVR_OK : err.status, &err);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    touching t = seen(run);
    ovr_run_free(run);
    ovr_case_free(c);
    return t;
}

static ovr_case *by_moes(double M, double L, int level)
{
    ovr_case *c = begin(paper);
    assignf(c, "contact.M=%g", M);
    assignf(c, "contact.L=%g", L);
    assignf(c, "domain.level=%d", level);
    return c;
}

static void bears(ovr_case *c, double amplitude, double decay)
{
    assign(c, "boundary.law=exponential");
    assignf(c, "boundary.amplitude=%g", amplitude);
    assignf(c, "boundary.decay=%g", decay);
}

/* At its last node, where A is A(H) and not zero, the truth has half a weight
 * of it, the program none: what is allowed beside 1e-8 is that node's A, some
 * 0.3 long of it pressing from there. */
TEST(films_are_those_of_the_dense_newton)
{
    static const struct {
        double M, L, s;
        int level;
        double H0, H_min, share, at_end;
    } of[] = {{20, 10, 0.021, 6, -0.5045047684956058, 0.07383886806124174,
               0.023200437491556335, 0},
              {20, 10, 0.042, 6, -0.4979971444670354, 0.07789693551756383,
               0.1637149445174704, 2.1e-5},
              {20, 10, 0.084, 6, -0.4749623175222994, 0.08710472173439182,
               0.42143755674029904, 3.3e-3},
              {20, 10, 0.042, 7, -0.4978047374747527, 0.07808855724845748,
               0.16290654848066233, 2.1e-5},
              {5, 5, 0.1, 6, -0.2493603147602965, 0.24742928350999083,
               0.07200559119284872, 7e-4},
              {50, 10, 0.012, 7, -0.5632758996973974, 0.027529062043276015,
               0.10064704662698547, 0}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        ovr_case *c = by_moes(of[k].M, of[k].L, of[k].level);
        double D = 5.5 / (7 << of[k].level), end = of[k].at_end * D;
        bears(c, 1, of[k].s);
        touching t = solved(c);
        print_message("s %g: H0 %+.1e, H_min %+.1e, share %+.1e, %d cycles\n",
                      of[k].s, t.H0 - of[k].H0, t.H_min - of[k].H_min,
                      t.share - of[k].share, t.cycles);
        CHECK_NEAR(t.H0, of[k].H0, 1e-8 + end);
        CHECK_NEAR(t.H_min, of[k].H_min, 1e-8 + end);
        CHECK_NEAR(t.share, of[k].share, 1e-8 + end);
        CHECK_NEAR(t.load, acos(-1.0) / 2, 1e-9);
    }
}

static void put_wave(ovr_case *c, double amplitude)
{
    assign(c, "feature wave.shape=wave");
    assignf(c, "feature wave.amplitude=%g", amplitude);
    assign(c, "feature wave.wavelength=0.5");
    assign(c, "feature wave.origin=0");
}

/* Stationary waves with a crest at X = 0. */
TEST(standing_waves_are_those_of_the_dense_newton)
{
    static const double of[][4] = {
        {0.05, -0.5112078327275613, 0.05557424626283938, 0.04095970848015097},
        {0.1, -0.5042865262088885, 0.04464866001993048, 0.061058162322976416}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        ovr_case *c = by_moes(20, 10, 6);
        bears(c, 1, 0.02);
        put_wave(c, of[k][0]);
        touching t = solved(c);
        CHECK_NEAR(t.H0, of[k][1], 1e-8);
        CHECK_NEAR(t.H_min, of[k][2], 1e-8);
        CHECK_NEAR(t.share, of[k][3], 1e-8);
    }
}

/* A wave that grows in place over T = 0..1 and moves with the film or faster,
 * by slip, on its way and after 102 steps dT = D.  What is left is how the two
 * continue the film before the inlet; the truth's solves it to 1e-10, at the
 * first step it is 4e-8. */
TEST(films_in_time_are_those_of_the_dense_newton)
{
    static const struct {
        double amplitude, slide, end, H0, H_min, share;
    } of[] = {{0.08, 0, 0.491071429, -0.5020285845952587, 0.05871986518653372,
               0.021247010506427046},
              {0.08, 0, 1.473214286, -0.4885248512352524, 0.03583352652737186,
               0.03681678059519263},
              {0.08, 0, 2.504464286, -0.4828065376888093, 0.035249492563756896,
               0.05188013198307721},
              {0.06, 0.5, 1.473214286, -0.4939915027585089,
               0.049905753828227296, 0.02057691685369753},
              {0.06, 0.5, 2.504464286, -0.4890709228354468, 0.0571637279755794,
               0.01561286572274158}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        ovr_case *c = by_moes(20, 10, 5);
        bears(c, 1, 0.02);
        assign(c, "time.scheme=characteristic");
        assignf(c, "time.end=%.10g", of[k].end);
        assignf(c, "contact.slide_to_roll=%g", of[k].slide);
        assign(c, "lubricant.rheology=eyring"); /* hardly: it may slide */
        assign(c, "lubricant.eyring_stress=1000 GPa");
        assign(c, "contact.modulus=227 GPa");
        put_wave(c, of[k].amplitude);
        assign(c, "feature wave.grow=1");
        touching t = solved(c);
        print_message("T %.3f: H0 %+.1e, H_min %+.1e, share %+.1e\n", of[k].end,
                      t.H0 - of[k].H0, t.H_min - of[k].H_min,
                      t.share - of[k].share);
        CHECK_NEAR(t.H0, of[k].H0, 2e-7);
        CHECK_NEAR(t.H_min, of[k].H_min, 2e-7);
        CHECK_NEAR(t.share, of[k].share, 2e-7);
    }
}

/* The mesh is read off the shares alone, to levels that have no full matrix. */
TEST(share_is_of_second_order)
{
    enum { LEVELS = 5 };
    double share[LEVELS];
    for (int l = 0; l < LEVELS; l++) {
        ovr_case *c = by_moes(20, 10, 5 + l);
        bears(c, 1, 0.042);
        assign(c, "solver.tolerance=1e-7");
        share[l] = solved(c).share;
        if (l > 1)
            CHECK_NEAR((share[l - 2] - share[l - 1]) /
                           (share[l - 1] - share[l]),
                       4, 0.5);
    }
}

/* Summits that reach a sixth of the film bear nothing; an amplitude of zero is
 * no law at all. */
TEST(thick_films_are_not_affected)
{
    touching none = solved(by_moes(20, 10, 6)), thick;
    ovr_case *c = by_moes(20, 10, 6);
    bears(c, 1, 0.084 / 6 / 2.15);
    thick = solved(c);
    CHECK_NEAR(thick.H_cen, none.H_cen, 1e-6);
    c = by_moes(20, 10, 6);
    bears(c, 0, 0.042);
    touching off = solved(c);
    assert_true(off.H0 == none.H0 && off.H_min == none.H_min);
    assert_true(off.P_max == none.P_max);
}

static touching at_level(const char *const *contact, int level)
{
    ovr_case *c = begin(contact);
    assign(c, "contact.radius=12 mm");
    assign(c, "contact.modulus=226 GPa");
    assign(c, "contact.viscosity=30 mPa.s");
    assign(c, "contact.alpha=18 1/GPa");
    assign(c, "lubricant.rheology=eyring");
    assign(c, "lubricant.eyring_stress=5 MPa");
    assign(c, "lubricant.limiting_shear=0.08");
    assign(c, "boundary.law=exponential");
    assign(c, "boundary.friction=0.12");
    assignf(c, "domain.level=%d", level);
    return solved(c);
}

static void check_levels_agree(const char *const *contact, int coarse_level,
                               int fine_level)
{
    touching coarse = at_level(contact, coarse_level);
    touching fine = at_level(contact, fine_level);
    CHECK_NEAR(fine.H_cen / coarse.H_cen, 1, 1e-4);
    CHECK_NEAR(fine.share / coarse.share, 1, 1e-3);
    CHECK_NEAR(fine.mu / coarse.mu, 1, 1e-3);
}

/* On level 9 both need nested iteration, from a dry contact and from the full
 * film; on level 8 neither does. */
TEST(levels_next_to_each_other_agree)
{
    static const char *const drier[] = {"contact.hertz_pressure=1.295 GPa",
                                        "contact.mean_speed=0.2545 m/s",
                                        "contact.slide_to_roll=0.431",
                                        "boundary.Rq=0.229 um",
                                        "boundary.slope=0.0497",
                                        NULL};
    static const char *const wetter[] = {"contact.hertz_pressure=1.026 GPa",
                                         "contact.mean_speed=1.319 m/s",
                                         "contact.slide_to_roll=0.489",
                                         "boundary.Rq=0.209 um",
                                         "boundary.slope=0.0853",
                                         NULL};
    check_levels_agree(drier, 8, 9);
    check_levels_agree(wetter, 8, 9);
}

/* Contacts in whose Newton steps on level 10 GMRES hardly converges with the
 * elastic band: the local band has to take over. */
TEST(fine_levels_agree_with_coarse_ones)
{
    static const char *const contacts[][6] = {
        {"contact.hertz_pressure=1.013 GPa", "contact.mean_speed=0.968 m/s",
         "contact.slide_to_roll=0.0787", "boundary.Rq=0.17 um",
         "boundary.slope=0.0774", NULL},
        {"contact.hertz_pressure=0.7849 GPa", "contact.mean_speed=0.3645 m/s",
         "contact.slide_to_roll=0.469", "boundary.Rq=0.204 um",
         "boundary.slope=0.0352", NULL},
        {"contact.hertz_pressure=0.6243 GPa", "contact.mean_speed=0.8535 m/s",
         "contact.slide_to_roll=0.249", "boundary.Rq=0.192 um",
         "boundary.slope=0.0392", NULL},
        {"contact.hertz_pressure=1.183 GPa", "contact.mean_speed=0.1578 m/s",
         "contact.slide_to_roll=0.553", "boundary.Rq=0.0514 um",
         "boundary.slope=0.0316", NULL}};
    for (size_t k = 0; k < sizeof contacts / sizeof *contacts; k++)
        check_levels_agree(contacts[k], 9, 10);
}

/* From a film to bodies that touch dry: Stribeck's curve. */
TEST(asperities_carry_more_at_low_speed)
{
    static const double speed[] = {30, 10, 3, 1, 0.3, 0.1, 0.03, 0.01};
    enum { SPEEDS = sizeof speed / sizeof *speed };
    touching last = {0};
    for (int k = 0; k < SPEEDS; k++) {
        ovr_case *c = begin(gear);
        assignf(c, "contact.mean_speed=%g m/s", speed[k]);
        assign(c, "boundary.law=exponential");
        assign(c, "boundary.Rq=194 nm");
        assign(c, "boundary.slope=0.03");
        assign(c, "boundary.friction=0.11");
        touching t = solved(c);
        print_message("%5g m/s: share %.4f, mu %.4f = %.4f + %.4f, %d cycles\n",
                      speed[k], t.share, t.mu, t.mu_film, t.mu_boundary,
                      t.cycles);
        assert_true(t.share > last.share && t.share < 1);
        CHECK_NEAR(t.mu_film + t.mu_boundary, fabs(t.mu), 1e-12);
        CHECK_NEAR(t.mu_boundary, 0.11 * t.share, 1e-9);
        last = t;
    }
    assert_true(last.share > 0.99);
    CHECK_NEAR(fabs(last.mu), 0.11, 1e-3);
}

/* A user's own numbers: 200 kN/m, Rq 0.4 um. */
static const char *const users[] = {
    "contact.load=200 kN/m",     "contact.radius=10 mm",
    "contact.modulus=226 GPa",   "contact.viscosity=80 mPa.s",
    "contact.alpha=20 1/GPa",    "contact.slide_to_roll=0.2",
    "lubricant.rheology=eyring", "lubricant.eyring_stress=5 MPa",
    "boundary.law=exponential",  "boundary.Rq=0.4 um",
    "boundary.friction=0.11",    NULL};

/* The integral of ln|x| from a to b. */
static double logarithm_between(double a, double b)
{
    double at_a = a == 0 ? 0 : a * log(fabs(a)) - a;
    double at_b = b == 0 ? 0 : b * log(fabs(b)) - b;
    return at_b - at_a;
}

/*
 * Central gap of the dry contact P = a exp(-H/s) of two bodies, integral of P =
 * pi/2, without any oil: collocation with constant pressures and Newton's
 * method for the gaps, written down here from
 *     H = H0 + X^2/2 - (1/pi) int P ln|X - X'| dX'.
 */
static double dry_gap(double a, double s)
{
    enum { STEPS = 200 };
    const size_t N = 201;
    const double pi = acos(-1.0), end = 3, D = 2 * end / (double)N;
    double *H = malloc(N * sizeof *H), H0 = -0.55, central, change = 1;
    gsl_matrix *J = gsl_matrix_alloc(N + 1, N + 1);
    gsl_vector *r = gsl_vector_alloc(N + 1);
    gsl_permutation *p = gsl_permutation_alloc(N + 1);
    assert_non_null(H);
    for (size_t i = 0; i < N; i++) {
        double X = -end + ((double)i + 0.5) * D;
        double P = sqrt(fmax(1 - X * X, 1e-2));
        H[i] = s * log(a / P) + fmax(0, X * X - 1) / 4;
    }
    for (int step = 0; step < STEPS && change > 1e-10; step++) {
        double force = 0;
        int sign;
        for (size_t i = 0; i < N; i++) {
            double X = -end + ((double)i + 0.5) * D, sum = 0;
            for (size_t j = 0; j < N; j++) {
                double away = ((double)j - (double)i) * D;
                double k = -logarithm_between(away - D / 2, away + D / 2) / pi;
                double P = a * exp(-H[j] / s);
                sum += k * P;
                gsl_matrix_set(J, i, j, (i == j) + k * P / s);
            }
            gsl_matrix_set(J, i, N, -1);
            gsl_vector_set(r, i, H0 + X * X / 2 + sum - H[i]);
            gsl_matrix_set(J, N, i, -D * a * exp(-H[i] / s) / s);
            force += D * a * exp(-H[i] / s);
        }
        gsl_matrix_set(J, N, N, 0);
        gsl_vector_set(r, N, pi / 2 - force);
        gsl_linalg_LU_decomp(J, p, &sign);
        gsl_linalg_LU_svx(J, p, r);
        change = 0;
        for (size_t i = 0; i < N; i++)
            change = fmax(change, fabs(gsl_vector_get(r, i)));
        for (size_t i = 0; i < N; i++)
            H[i] += gsl_vector_get(r, i) * fmin(1, s / change);
        H0 += gsl_vector_get(r, N) * fmin(1, s / change);
    }
    assert_true(change <= 1e-10);
    central = H[N / 2];
    free(H);
    gsl_matrix_free(J);
    gsl_vector_free(r);
    gsl_permutation_free(p);
    return central;
}

static touching of_user(double slope, double speed)
{
    ovr_case *c = begin(users);
    assignf(c, "boundary.slope=%g", slope);
    assignf(c, "contact.mean_speed=%g m/s", speed);
    return solved(c);
}

/*
 * At low speed the fluid carries a thousandth of the load or less, R ends at
 * the rounding error of the pressures, and the film is that of the dry
 * contact. The fluid's share is then proportional to the speed, since its
 * pressure does not change the gap, and remains between both limits. Lambda
 * ratio and ph: b = sqrt(8 w R/(pi E')), s = Rq/2.15 in b^2/R, a = 0.38 (E'/2)
 * slope/ph.
 */
TEST(slow_films_are_those_of_the_dry_contact)
{
    static const double slope[] = {0.03, 0.05, 0.08, 0.1, 0.15};
    const double E = 226e9, b2_R = 8 * 200e3 / (acos(-1.0) * E);
    const double ph = sqrt(200e3 * E / (2 * acos(-1.0) * 0.01));
    for (size_t k = 0; k < sizeof slope / sizeof *slope; k++) {
        double a = 0.38 * E / 2 * slope[k] / ph;
        double dry = dry_gap(a, 0.4e-6 / 2.15 / b2_R);
        touching slow = of_user(slope[k], 1e-4), middle, fast;
        middle = of_user(slope[k], 0.01);
        fast = of_user(slope[k], 0.1);
        print_message("slope %g: dry %.5f, slow %.5f, shares %.2e %.2e %.2e of "
                      "oil, %d cycles\n",
                      slope[k], dry, slow.H_cen, 1 - slow.share,
                      1 - middle.share, 1 - fast.share, slow.cycles);
        CHECK_NEAR(slow.H_cen / dry, 1, 1e-3);
        CHECK_NEAR(fabs(slow.mu), 0.11, 1e-4);
        CHECK_NEAR((1 - middle.share) / (1 - slow.share) / 100, 1, 0.2);
        assert_true(slow.share > middle.share && middle.share > fast.share);
        assert_true(slow.H_cen < middle.H_cen && middle.H_cen < fast.H_cen);
        assert_true(slow.cycles < 120 && middle.cycles < 120);
    }
}

/* A law that bears 0.097 ph at no film is warned of before the run; as long as
 * the film is thick it has an answer, and where the film is as thin as half of
 * that asks for none, so that no curve ends in the law's plateau. */
static void keep_warning(void *data, ovr_message_kind kind, const char *text)
{
    if (kind == OVR_MESSAGE_WARNING &&
        strstr(text, "p_h at zero film thickness"))
        (*(int *)data)++;
}

TEST(weak_laws_fail_for_thin_films)
{
    static const double speed[] = {2, 0.002};
    ovr_error err = {0};
    for (int k = 0; k < 2; k++) {
        int warned = 0;
        ovr_run_options how = {.say = keep_warning, .data = &warned};
        ovr_case *c = begin(users);
        assign(c, "boundary.law=greenwood-tripp");
        assign(c, "domain.level=6");
        assignf(c, "contact.mean_speed=%g m/s", speed[k]);
        ovr_run *run = ovr_run_create(c, &how, NULL, &err);
        CHECK_OK(run ? OVR_OK : err.status, &err);
        ovr_status status = ovr_run_execute(run, &err);
        assert_int_equal(warned, 1);
        assert_int_equal(status, k ? OVR_IMPOSSIBLE : OVR_OK);
        if (k)
            assert_non_null(strstr(err.message, "asperity law is exhausted"));
        ovr_run_free(run);
        ovr_case_free(c);
    }
}

/* With temperatures: what summits drag warms film and bodies, and all of it is
 * found again. */
TEST(energy_balance_with_asperity_friction)
{
    static const char *const warm[] = {"contact.load=60 kN/m",
                                       "contact.radius=10 mm",
                                       "contact.speed_1=1.2 m/s",
                                       "contact.speed_2=0.8 m/s",
                                       "contact.viscosity=20 mPa.s",
                                       "contact.alpha=18 1/GPa",
                                       "body 1.modulus=206 GPa",
                                       "body 2.modulus=206 GPa",
                                       "heat.model=lobatto",
                                       "heat.temperature=60 degC",
                                       "domain.level=6",
                                       "boundary.law=exponential",
                                       "boundary.Rq=150 nm",
                                       "boundary.slope=0.03",
                                       NULL};
    ovr_error err = {0};
    double flow[2];
    for (int k = 0; k < 2; k++) {
        ovr_case *c = begin(warm);
        assign(c, k ? "boundary.friction=0.11" : "boundary.friction=0");
        ovr_run *run = ovr_run_create(c, NULL, NULL, &err);
        CHECK_OK(run ? OVR_OK : err.status, &err);
        CHECK_OK(ovr_run_execute(run, &err), &err);
        const ovr_observation *o = ovr_simulation_observation(
            ovr_run_get_info(run)->sim);
        CHECK_NEAR(o->energy_defect, 0, 1e-3);
        flow[k] = o->heat_flow_1 + o->heat_flow_2;
        if (k) {
            double made = fabs(o->sliding * o->more[MU_BOUNDARY]) * o->load /
                          ovr_run_get_info(run)->setup->contact->kappa;
            print_message("summits make %.4f, the bodies take %.4f more\n",
                          made, flow[1] - flow[0]);
            /* a warmer film drags less */
            assert_true(flow[1] - flow[0] > 0.8 * made);
            assert_true(flow[1] - flow[0] < 1.02 * made);
        }
        ovr_run_free(run);
        ovr_case_free(c);
    }
}

/* Rough surfaces without boundary friction, of which asperities carry most of
 * the load: the heat of the film is reduced as its friction is.  */
TEST(heat_of_mixed_friction_is_its_power)
{
    static const char *const mixed[] = {"contact.load=250 kN/m",
                                        "contact.radius=10 mm",
                                        "contact.mean_speed=1.5 m/s",
                                        "contact.slide_to_roll=0.4",
                                        "lubricant.viscosity=30 mPa.s",
                                        "lubricant.alpha=18 1/GPa",
                                        "lubricant.rheology=eyring",
                                        "lubricant.eyring_stress=6 MPa",
                                        "body 1.material=steel",
                                        "body 2.material=steel",
                                        "heat.model=lobatto",
                                        "heat.temperature=60 degC",
                                        "boundary.law=exponential",
                                        "boundary.Rq=0.5 um",
                                        "boundary.slope=0.03",
                                        "boundary.friction=0",
                                        NULL};
    const char *const levels[] = {"domain.level=6", "domain.level=7"};
    ovr_error err = {0};
    double off[2];
    for (int k = 0; k < 2; k++) {
        ovr_case *c = begin(mixed);
        assign(c, levels[k]);
        ovr_run *run = ovr_run_create(c, NULL, NULL, &err);
        CHECK_OK(run ? OVR_OK : err.status, &err);
        CHECK_OK(ovr_run_execute(run, &err), &err);
        const ovr_observation *o = ovr_simulation_observation(
            ovr_run_get_info(run)->sim);
        double heat = o->heat_flow_1 + o->heat_flow_2;
        off[k] = o->energy_defect;
        print_message("    power %.5f, into the surfaces %.5f, defect %.1e\n",
                      o->power_in, heat, off[k]);
        CHECK_CLOSE(heat, o->power_in, 0.03); /* the oil leaves hotter */
        ovr_run_free(run);
        ovr_case_free(c);
    }
    /* second order: the wall heat against the power of forces */
    CHECK_NEAR(off[0], 0, 5e-4);
    CHECK_NEAR(off[1], 0, 5e-4 / 4);
}

/* A layer of a few nm has a pole at no gap: the film stays open. */
TEST(layer_keeps_the_film_open)
{
    ovr_case *c = begin(gear);
    assign(c, "contact.mean_speed=5 mm/s");
    assign(c, "boundary.law=layer");
    assign(c, "boundary.layer=3 nm");
    assign(c, "boundary.layer_decay=1 nm");
    touching t = solved(c);
    assert_true(t.H_min > 0 && t.share > 0.1 && t.share < 1);
}

/* A table of what an exponential bears, in nm and MPa, is that exponential. */
TEST(table_is_the_law_that_it_was_made_of)
{
    touching t[2];
    char path[] = "/tmp/overroll-table-XXXXXX";
    FILE *f = fdopen(mkstemp(path), "w");
    assert_non_null(f);
    fputs("gap [nm], pressure [MPa]\n", f);
    for (double gap = 0; gap < 900; gap += 45)
        fprintf(f, "%.17g, %.17g\n", gap, 1288 * exp(-gap / 90));
    fclose(f);
    for (int k = 0; k < 2; k++) {
        ovr_case *c = begin(gear);
        assign(c, "contact.mean_speed=3.22 m/s");
        assign(c, "boundary.friction=0.1");
        assign(c, k ? "boundary.law=table" : "boundary.law=exponential");
        if (k) {
            assignf(c, "boundary.file=%s", path);
        } else {
            assign(c, "boundary.amplitude=1.288 GPa");
            assign(c, "boundary.decay=90 nm");
        }
        t[k] = solved(c);
    }
    unlink(path);
    CHECK_NEAR(t[1].share, t[0].share, 1e-9);
    CHECK_NEAR(t[1].H_min, t[0].H_min, 1e-9);
    CHECK_NEAR(t[1].area, t[0].area, 1e-4);
    CHECK_NEAR(t[1].mu, t[0].mu, 1e-5);
}

/* The usual constants of Greenwood and Tripp carry 1.9 % of the load at W =
 * 1e-4, U = 1e-11, G = 4500, s/R = 2e-5, by the dense Newton solution. Two
 * digits of the reference are known, and its lubricant is unknown except for G.
 */
TEST(summits_carry_little)
{
    static const char *const by_W_U_G[] = {"contact.load=226 kN/m",
                                           "contact.radius=10 mm",
                                           "contact.modulus=226 GPa",
                                           "contact.viscosity=10 mPa.s",
                                           "contact.alpha=19.912 1/GPa",
                                           "contact.mean_speed=2.26 m/s",
                                           "domain.level=6",
                                           "domain.order=2",
                                           NULL};
    ovr_case *c = begin(by_W_U_G);
    assign(c, "boundary.law=greenwood-tripp");
    assign(c, "boundary.Rq=200 nm");
    touching t = solved(c);
    print_message("share %.4f\n", t.share);
    CHECK_NEAR(t.share, 0.019, 1e-3);
}

static void put_roughness(ovr_case *c, int surface)
{
    assignf(c, "feature rough %d.shape=roughness", surface);
    assignf(c, "feature rough %d.surface=%d", surface, surface);
    assignf(c, "feature rough %d.Rq=137 nm", surface);
    assignf(c, "feature rough %d.length=1 mm", surface);
    assignf(c, "feature rough %d.shortest=8 um", surface);
    assignf(c, "feature rough %d.seed=%d", surface, surface);
}

/* The law of two self-affine surfaces by their own dry contact beside the
 * exponential of their Rq and slope, 0.0184 by their spectrum, off by 0.2 Rq in
 * the gap: by exp(0.2 2.15) = 1.5 in what is borne; none of them is on the
 * mesh. */
TEST(profile_law_agrees_with_dry_contact)
{
    touching t[2];
    for (int k = 0; k < 2; k++) {
        ovr_case *c = begin(gear);
        assign(c, "contact.mean_speed=3.22 m/s");
        assign(c, k ? "boundary.law=profile" : "boundary.law=exponential");
        if (k) {
            put_roughness(c, 1);
            put_roughness(c, 2);
        } else {
            assign(c, "boundary.Rq=194 nm");
            assign(c, "boundary.slope=0.0184");
        }
        t[k] = solved(c);
        print_message("share %.4f, H_min %.4f\n", t[k].share, t[k].H_min);
    }
    assert_true(t[1].share > t[0].share / 1.5);
    assert_true(t[1].share < t[0].share * 1.5);
}

/* What flow factors do to film and share at lambda 1, by another program's
 * dense Newton: H_cen of smooth surfaces times 1.052, 1.203, 1.457, shares
 * 0.177, 0.127, 0.073 for none, isotropic roughness and ridges across, of an
 * oil that is about this one: quotients to 3 %. */
TEST(flow_factors_make_the_film_thicker)
{
    static const struct {
        const char *name;
        double H, share;
    } of[] = {{"none", 1.052, 0.177},
              {"isotropic", 1.203, 0.127},
              {"transverse", 1.457, 0.073}};
    touching t[3];
    for (int k = 0; k < 3; k++) {
        ovr_case *c = begin(gear);
        assign(c, "domain.level=6");
        assign(c, "contact.mean_speed=2.95 m/s");
        assign(c, "boundary.law=exponential");
        assign(c, "boundary.amplitude=1.288 GPa");
        assign(c, "boundary.decay=90 nm");
        assignf(c, "boundary.flow_factor=%s", of[k].name);
        t[k] = solved(c);
        print_message("%s: H_cen %.4f, share %.4f, %d cycles\n", of[k].name,
                      t[k].H_cen, t[k].share, t[k].cycles);
        CHECK_CLOSE(t[k].H_cen / t[0].H_cen, of[k].H / of[0].H, 0.03);
        CHECK_CLOSE(t[k].share / t[0].share, of[k].share / of[0].share, 0.03);
    }
}

/* A case that is refused, and by what. */
static void check_refused(ovr_case *c, const char *words)
{
    ovr_error err = {0};
    assert_null(ovr_run_create(c, NULL, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, words);
    ovr_case_free(c);
}

TEST(searches_without_answer_are_rejected)
{
    ovr_case *c = begin(gear);
    assign(c, "boundary.law=exponential");
    check_refused(c, "mean_speed");
    c = begin(gear);
    assign(c, "contact.mean_speed=3 m/s");
    assign(c, "boundary.law=exponential");
    check_refused(c, "needs Rq");
    c = begin(gear);
    assign(c, "contact.mean_speed=3 m/s");
    assign(c, "boundary.law=layer");
    check_refused(c, "needs boundary.layer");
    c = begin(newtonian);
    assign(c, "boundary.law=exponential");
    assign(c, "boundary.Rq=194 nm");
    assign(c, "boundary.slope=0.03");
    check_refused(c, "shear-thinning");
    c = begin(gear);
    assign(c, "contact.mean_speed=3 m/s");
    assign(c, "boundary.law=profile");
    check_refused(c, "needs a [feature]");
    c = begin(gear);
    assign(c, "contact.mean_speed=3 m/s");
    assign(c, "boundary.law=profile");
    put_roughness(c, 1);
    put_roughness(c, 2);
    assign(c, "feature rough 2.surface=1");
    check_refused(c, "one profile per surface");
    c = begin(gear);
    assign(c, "contact.mean_speed=3 m/s");
    assign(c, "boundary.law=exponential");
    assign(c, "boundary.Rq=194 nm");
    assign(c, "boundary.slope=0.03");
    put_roughness(c, 1);
    check_refused(c, "unresolved");
}
