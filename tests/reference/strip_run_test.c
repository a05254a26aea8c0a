/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs of cases with [strip]: the film of the line contact if nothing varies
 * across, with every kind of history; stop and resume; rejected options. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/overroll.h"
#include "physics/strip/strip.h"
#include "simulation/solver.h"
#include "support/test.h"

/* The sums of the line contact are as exact as its mesh asks for, 1e-6. */
#define EXACT "[paper]\nmlmi_order = 12\nmlmi_range = 24\n"
#define CONTACT                                                                \
    "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 5\norder = 2\nfaces = gap\n" \
    "inlet = -4\noutlet = 1.5\n[solver]\ntolerance = 1e-9\n" EXACT
#define IN_TIME                                                                \
    "[time]\nend = 0.5\nscheme = characteristic\nstep = 0.02455357142857143\n"
#define RIDGE                                                                  \
    "[feature ridge]\nshape = ridge\nheight = 0.03\nwidth = 1\nstart = -1.2\n"
#define STRIP "[strip]\nwidth = 2\n"

static ovr_case *read_case(const char *text, const char *more)
{
    ovr_error err = {0};
    char whole[4000];
    snprintf(whole, sizeof whole, "%s%s", text, more);
    ovr_case *c = ovr_case_read_text(whole, "test", NULL, NULL, &err);
    if (!c)
        print_message("%s\n", err.message);
    assert_non_null(c);
    return c;
}

static ovr_run *run_at(ovr_case *c, const char *path, const char *at)
{
    ovr_error err = {0};
    ovr_run_options how = {0};
    how.output = path;
    how.steady = at != NULL;
    how.at = at;
    how.force = true;
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    if (!run)
        print_message("%s\n", err.message);
    assert_non_null(run);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    return run;
}

static ovr_run *run_of(ovr_case *c, const char *path)
{
    return run_at(c, path, NULL);
}

/* A strip and a line contact with the same case end in the same film.  The
 * steady film of a station is compared if `at` is not NULL.  Returns true if
 * the features of the strip had to grow. */
static bool same_at(const char *text, const char *at, double tolerance)
{
    ovr_case *line = read_case(text, ""), *strip = read_case(text, STRIP);
    ovr_run *one = run_at(line, NULL, at), *other = run_at(strip, NULL, at);
    const ovr_simulation *a = ovr_run_get_info(one)->sim;
    const ovr_simulation *b = ovr_run_get_info(other)->sim;
    const ovr_observation *o = ovr_simulation_observation(a);
    const ovr_observation *p = ovr_simulation_observation(b);
    const ovr_state *s = ovr_simulation_state(a), *t = ovr_simulation_state(b);
    assert_true(p->converged && s->n == t->n && s->T == t->T);
    for (size_t i = 0; i < s->n; i++) {
        CHECK_NEAR(t->P[i], s->P[i], 20 * tolerance);
        CHECK_NEAR(t->H[i], s->H[i], tolerance);
        CHECK_NEAR(t->S[i], s->S[i], 1e-12);
    }
    CHECK_NEAR(p->H_cen, o->H_cen, tolerance);
    CHECK_NEAR(p->load, o->load, 1e-7);
    CHECK_NEAR(p->F_slide, o->F_slide, 1e-5 * fabs(o->F_slide) + tolerance);
    CHECK_NEAR(p->F_roll, o->F_roll, tolerance);
    CHECK_NEAR(p->limiting_share, o->limiting_share, 1e-6);
    CHECK_NEAR(p->power_dissipated, o->power_dissipated,
               1e-5 * fabs(o->power_dissipated) + tolerance);
    CHECK_NEAR(p->mass_flow, o->mass_flow, 2e-4);
    CHECK_NEAR(p->mass_balance, 0, 0.03);
    CHECK_NEAR(p->more[OVR_STRIP_FILM_LOW], p->H_cen, tolerance);
    CHECK_NEAR(p->more[OVR_STRIP_FILM_HIGH], p->H_cen, tolerance);
    bool grown = *ovr_simulation_strategy(b);
    ovr_run_free(one);
    ovr_run_free(other);
    ovr_case_free(line);
    ovr_case_free(strip);
    return grown;
}

static void same_as_line(const char *text, double tolerance)
{
    same_at(text, NULL, tolerance);
}

/* The sums of MLMI are exact to 1e-8, of which films have a part. */
TEST(steady)
{
    same_as_line(CONTACT, 1e-8);
}

/* Films of light loads are hundreds of b^2/R thick and many b wide; strong
 * shear thinning makes one a seventh as thick. */
TEST(thick_films)
{
#define LIGHT                                                                  \
    "[domain]\nlevel = 5\norder = 2\nfaces = gap\ninlet = -60\n[solver]\n"     \
    "tolerance = 1e-8\n" EXACT
    same_as_line(LIGHT "[contact]\nM = 0.07\nL = 13\n", 1e-5);
    same_as_line(LIGHT "[contact]\nM = 0.15\nL = 0.015\n", 1e-5);
    same_as_line(LIGHT "[contact]\nM = 0.025\nL = 176\nslide_to_roll = 8.5\n"
                       "[lubricant]\nrheology = eyring\n"
                       "eyring_number = 0.1086\n",
                 1e-6);
}

/* A groove of five film thicknesses.  Steady cycles with growing features end
 * at a fifth of it, steps in time reach the whole. */
TEST(high_features_grow)
{
    assert_true(same_at(CONTACT "[feature d]\nshape = groove\ndepth = 0.4\n"
                                "width = 0.5\nstart = -0.3\n",
                        NULL, 1e-6));
}

/* Pressure spikes narrower than a mesh size, where the logarithmic mean fails:
 * the film is that of a line contact with faces = gap.  `way` is the start of
 * the strategy that found it. */
static void solved_by_gap(const char *contact, const char *way)
{
    const char *rest = "[domain]\nlevel = 6\norder = 2\n" EXACT;
    char text[500];
    snprintf(text, sizeof text, "[contact]\n%s%s", contact, rest);
    ovr_case *strip = read_case(text, "[strip]\nwidth = 1\n");
    ovr_case *line = read_case(text, "[domain]\nfaces = gap\n");
    ovr_run *one = run_at(line, NULL, NULL), *other = run_at(strip, NULL, NULL);
    const ovr_simulation *b = ovr_run_get_info(other)->sim;
    const ovr_state *s = ovr_simulation_state(ovr_run_get_info(one)->sim);
    const ovr_state *t = ovr_simulation_state(b);
    assert_true(ovr_simulation_observation(b)->converged);
    assert_string_equal(ovr_simulation_strategy(b), way);
    for (size_t i = 0; i < s->n; i++) {
        CHECK_NEAR(t->P[i], s->P[i], 1e-5);
        CHECK_NEAR(t->H[i], s->H[i], 1e-6);
    }
    ovr_run_free(one);
    ovr_run_free(other);
    ovr_case_free(line);
    ovr_case_free(strip);
}

TEST(spikes_narrower_than_a_mesh_size)
{
    solved_by_gap("M = 20\nL = 33\n",
                  "with the mean between nodes of domain.faces = gap");
    solved_by_gap("M = 9\nL = 45\n",
                  "implicit steps in time until the film was steady");
}

/* A plateau a thousand times as high as the film appears after T = 0. */
static void plateau(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data;
    for (size_t i = 0; i < n; i++)
        S[i] = T > 0 && X[i] > -0.5 && X[i] < 0.5 ? 100 : 0;
}

/* A step without a solution ends by its work, which a film that varies across
 * counts for all lines.  The next step begins from the last film. */
TEST(a_step_that_has_no_solution_ends_by_its_work)
{
    enum { MOST = 40 };
    ovr_error err = {0};
    ovr_case *c = read_case(CONTACT, STRIP);
    ovr_run *run = run_of(c, NULL);
    ovr_simulation *sim = (ovr_simulation *)ovr_run_get_info(run)->sim;
    const double nodes = (double)(ovr_strip_of(sim)->lines * sim->now.n);
    const double H = ovr_simulation_observation(sim)->H_cen;
    ovr_simulation_surface(sim, plateau, NULL);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    sim->limits.step_work = OVR_SOLVER_WORK * MOST * nodes;
    assert_int_equal(ovr_simulation_step(sim, 0.01, &err), OVR_NOT_CONVERGED);
    print_message("    %s\n", err.message);
    assert_non_null(strstr(err.message, "within 20 times the predicted work"));
    assert_in_range((int)(sim->limits.work_done / OVR_SOLVER_WORK / nodes),
                    MOST, MOST + 2);
    assert_true(ovr_simulation_state(sim)->T == 0);
    ovr_simulation_surface(sim, NULL, NULL);
    CHECK_OK(ovr_simulation_step(sim, 0.01, &err), &err);
    CHECK_NEAR(ovr_simulation_observation(sim)->H_cen, H, 1e-6);
    ovr_run_free(run);
    ovr_case_free(c);
}

TEST(a_ridge_that_slides)
{
    same_as_line(CONTACT IN_TIME RIDGE "[contact]\nslide_to_roll = 0.4\n",
                 1e-7);
}

/* Along the characteristic a varying speed needs q between nodes.  Strips
 * interpolate it by cubics, line contacts by polynomials of degree five. */
TEST(histories_of_load_speed_and_radius)
{
    same_as_line(CONTACT "[time]\nend = 0.5\nscheme = upstream2\n"
                         "[load]\nhistory = ramp\nfrom = 0.8\nto = 1.1\n"
                         "duration = 0.4\n[speed]\nhistory = ramp\n"
                         "from = 0.9\nto = 1.2\nduration = 0.4\n"
                         "[radius]\nhistory = ramp\nto = 1.1\n"
                         "duration = 0.5\n",
                 1e-7);
}

TEST(shear_thinning_upstream)
{
    same_as_line("[contact]\nload = 3e5 N/m\nradius = 10 mm\n"
                 "modulus = 226 GPa\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\n"
                 "speed_1 = 1.4 m/s\nspeed_2 = 1.0 m/s\n[domain]\nlevel = 5\n"
                 "order = 2\nfaces = gap\n[solver]\ntolerance = "
                 "1e-9\n[time]\nend = 0.2\n"
                 "scheme = upstream2\n[lubricant]\nrheology = eyring\n"
                 "eyring_stress = 5 MPa\n" EXACT RIDGE,
                 1e-6);
}

#define OILED(speeds)                                                          \
    "[contact]\nload = 3e5 N/m\nradius = 10 mm\nmodulus = 226 GPa\n" speeds    \
    "[lubricant]\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\n[domain]\n"          \
    "level = 5\norder = 2\nfaces = gap\n[solver]\ntolerance = 1e-9\n" EXACT
#define UPSTREAM "[time]\nend = 0.2\nscheme = upstream2\n"
#define FASTER "speed_1 = 1.4 m/s\nspeed_2 = 1.0 m/s\n"

/* Strips integrate a flow law across the film by five points, line contacts of
 * Carreau's by a table. */
TEST(carreau)
{
    same_as_line(OILED(FASTER) UPSTREAM
                 "[lubricant]\nrheology = carreau\ncarreau_stress = 3 MPa\n"
                 "carreau_n = 0.5\n" RIDGE,
                 2e-5);
}

/* Carreau's law as a table of 400 rates gives the film of the formula.  The
 * error is a thousandth of the change by shear thinning. */
TEST(tabulated_flow_law)
{
    const char *const laws[] = {
        "rheology = carreau\ncarreau_stress = 3 MPa\ncarreau_n = 0.5\n",
        "rheology = table\nrheology_file = strip_thinning.csv\n",
        "rheology = newtonian\n"};
    double H[3];
    FILE *f = fopen("strip_thinning.csv", "w");
    assert_non_null(f);
    fprintf(f, "rate [1/s], stress [MPa]\n");
    for (int k = 0; k <= 400; k++) {
        double rate = 1e4 * exp(0.04 * k), s = 0.04 * rate / 3e6;
        fprintf(f, "%.10g, %.10g\n", rate, 3 * s * pow(1 + s * s, -0.25));
    }
    fclose(f);
    for (int k = 0; k < 3; k++) {
        char more[400];
        snprintf(more, sizeof more,
                 STRIP "[lubricant]\n%s[feature d]\nshape = dent\n"
                       "depth = 0.02\nwidth = 0.8\nstart = 0.1\n",
                 laws[k]);
        ovr_case *c = read_case(OILED(FASTER), more);
        ovr_run *run = run_of(c, NULL);
        H[k] = ovr_simulation_observation(ovr_run_get_info(run)->sim)->H_min;
        ovr_run_free(run);
        ovr_case_free(c);
    }
    remove("strip_thinning.csv");
    print_message("    H_min %.7f %.7f %.7f\n", H[0], H[1], H[2]);
    assert_true(H[0] < 0.99 * H[2]);
    CHECK_NEAR(H[1], H[0], 1e-3 * (H[2] - H[0]));
}

/* A tenth of the load is at the limit. */
TEST(limiting_shear_stress)
{
    const char *text = OILED(FASTER) UPSTREAM
        "[lubricant]\nrheology = eyring\neyring_stress = 5 MPa\n"
        "limiting_shear = 0.03\n" RIDGE;
    same_as_line(text, 1e-6);
    ovr_case *c = read_case(text, STRIP);
    ovr_run *run = run_of(c, NULL);
    const ovr_simulation *sim = ovr_run_get_info(run)->sim;
    assert_true(ovr_simulation_observation(sim)->limiting_share > 0.1);
    ovr_run_free(run);
    ovr_case_free(c);
}

TEST(history_of_sliding)
{
    same_as_line(OILED(FASTER) UPSTREAM
                 "[lubricant]\nrheology = eyring\neyring_stress = 5 MPa\n"
                 "[sliding]\nhistory = ramp\nfrom = 0.1\nto = 0.8\n"
                 "duration = 0.15\n",
                 1e-6);
}

/* The ridge stands still, or moves against the film. */
TEST(standing_and_opposed_surfaces)
{
    same_as_line(OILED("speed_1 = 0 m/s\nspeed_2 = 2 m/s\n") UPSTREAM RIDGE
                 "grow = 0.1\n",
                 1e-6);
    same_as_line(OILED("speed_1 = -0.5 m/s\nspeed_2 = 2.5 m/s\n") UPSTREAM RIDGE
                 "grow = 0.1\n",
                 1e-6);
}

/* Both end where the film no longer changes, at 1e-6 of it. */
TEST(until_steady)
{
    const char *text = CONTACT "[time]\nend = 40\nuntil_steady = yes\n"
                               "scheme = upstream2\n[load]\nhistory = step\n"
                               "from = 0.9\nto = 1\nstart = 0.1\n";
    ovr_case *line = read_case(text, ""), *strip = read_case(text, STRIP);
    ovr_run *one = run_of(line, NULL), *other = run_of(strip, NULL);
    const ovr_simulation *a = ovr_run_get_info(one)->sim;
    const ovr_simulation *b = ovr_run_get_info(other)->sim;
    const ovr_state *s = ovr_simulation_state(a), *t = ovr_simulation_state(b);
    assert_in_range((int)s->T, 5, 20);
    CHECK_NEAR(t->T, s->T, 1);
    for (size_t i = 0; i < s->n; i++)
        CHECK_NEAR(t->H[i], s->H[i], 1e-6);
    ovr_run_free(one);
    ovr_run_free(other);
    ovr_case_free(line);
    ovr_case_free(strip);
}

#define ELEMENT                                                                \
    "[contact]\nmodulus = 226 GPa\n[lubricant]\nviscosity = 40 mPa.s\n"        \
    "alpha = 17 1/GPa\nrheology = eyring\neyring_stress = 5 MPa\n"             \
    "[domain]\nlevel = 5\norder = 2\nfaces = gap\n[solver]\n"                  \
    "tolerance = 1e-9\n" EXACT

#define GEAR                                                                   \
    "[gear]\nteeth_1 = 25\nteeth_2 = 57\nmodule = 2.5 mm\nface = 20 mm\n"      \
    "speed = 3000 rpm\ntorque = 80 N.m\n" ELEMENT

TEST(stations_of_elements)
{
    same_at(GEAR, "C", 1e-6);
    same_at(GEAR, "B", 1e-6);
    same_at("[cam]\nfollower = flat\nbase_radius = 26 mm\nface = 12 mm\n"
            "speed = 1000 rpm\nlaw = 4567\nlift = 6 mm\nrise = 70 deg\n"
            "spring = 30 N/mm\npreload = 250 N\nmass = 100 g\n" ELEMENT,
            "nose", 1e-6);
    same_as_line(
        "[roller_bearing]\nroller = 10 mm\nrollers = 14\n"
        "length = 9.6 mm\ninner = 54.991 mm\nclearance = 41 um\n"
        "load = 4450 N\nspeed_inner = 1000 rpm\ncontact = inner\n" ELEMENT,
        1e-6);
}

/* ---------------------------------------------------------------- features */

#define WAVE "[feature wave]\nshape = wave\namplitude = 0.004\nwavelength = "

/* Heights and pressure of a steady strip at node i and line j. */
typedef struct solved {
    ovr_case *c;
    ovr_run *run;
    const ovr_strip_solver *s;
} solved;

static solved solve(const char *more)
{
    char text[2000];
    snprintf(text, sizeof text, "%s%s", STRIP "lines = 56\n", more);
    solved one = {.c = read_case(CONTACT, text)};
    one.run = run_of(one.c, NULL);
    one.s = ovr_strip_of(ovr_run_get_info(one.run)->sim);
    return one;
}

static void drop(solved *one)
{
    ovr_run_free(one->run);
    ovr_case_free(one->c);
}

static double pressure(const solved *one, size_t i, size_t j)
{
    const ovr_strip_level *finest = ovr_strip_finest(one->s);
    return finest->f.P[ovr_strip_row(&finest->grid, i) + j];
}

static double height(const solved *one, size_t i, size_t j)
{
    return one->s->S[j * one->s->n + i];
}

/* The round dent of the shape's formula at its distance, images included. */
TEST(a_round_dent)
{
    solved one = solve("[feature d]\nshape = dent\ndepth = 0.02\nwidth = 0.8\n"
                       "start = 0.1\nacross = 0.9\n");
    const double ten = log(10), turn = 2 * acos(-1);
    for (size_t j = 0; j < one.s->lines; j++)
        for (size_t i = 0; i < one.s->n; i += 3) {
            double S = 0;
            for (int m = -1; m <= 1; m++) {
                double v = hypot(one.s->X[i] - 0.1, one.s->Y[j] - 0.9 + 2 * m) /
                           0.8;
                S -= 0.02 * exp(-10 * ten * v * v) * cos(turn * v);
            }
            CHECK_NEAR(height(&one, i, j), S, 1e-12);
        }
    drop(&one);
}

/* Equal dents four lines apart make equal films four lines apart. */
TEST(shifted_across)
{
    const char *dent = "[feature d]\nshape = indent\ndepth = 0.03\n"
                       "width = 0.8\nwidth_across = 1.2\nangle = 30 deg\n"
                       "start = -0.2\nacross = ";
    char near[300], far[300];
    snprintf(near, sizeof near, "%s0\n", dent);
    snprintf(far, sizeof far, "%s%.17g\n", dent, 4 * 2. / 56);
    solved a = solve(near), b = solve(far);
    for (size_t j = 0; j < 56; j++)
        for (size_t i = 0; i < a.s->n; i++)
            CHECK_NEAR(pressure(&b, i, (j + 4) % 56), pressure(&a, i, j), 2e-8);
    drop(&a);
    drop(&b);
}

#define OVAL                                                                   \
    "shape = indent\ndepth = 0.03\nwidth = 0.8\nwidth_across = 1.2\n"          \
    "start = -0.2\n"

/* Line -j of the mirrored dent is line j of the other.  Line 0 is at -W/2. */
TEST(mirrored_across)
{
    solved a = solve("[feature d]\n" OVAL "angle = 30 deg\nacross = 0.3\n");
    solved b = solve("[feature d]\n" OVAL "angle = -30 deg\nacross = -0.3\n");
    for (size_t j = 0; j < 56; j++)
        for (size_t i = 0; i < a.s->n; i++)
            CHECK_NEAR(pressure(&b, i, (56 - j) % 56), pressure(&a, i, j),
                       2e-8);
    drop(&a);
    drop(&b);
}

/* Two dents on twice the width are the dent of one period, twice. */
TEST(two_periods)
{
    char text[1000];
    snprintf(text, sizeof text,
             "[strip]\nwidth = 4\nlines = 112\n[feature d]\n%s"
             "across = -0.7\n[feature e]\n%sacross = 1.3\n",
             OVAL, OVAL);
    solved a = solve("[feature d]\n" OVAL "across = 0.3\n");
    solved b = {.c = read_case(CONTACT, text)};
    b.run = run_of(b.c, NULL);
    b.s = ovr_strip_of(ovr_run_get_info(b.run)->sim);
    /* The lines of both begin at -W/2, where a is at 1 of the period of b. */
    for (size_t j = 0; j < 112; j++)
        for (size_t i = 0; i < a.s->n; i++)
            CHECK_NEAR(pressure(&b, i, j), pressure(&a, i, j % 56), 2e-8);
    drop(&a);
    drop(&b);
}

/* Rough surfaces close on the width, wherever on it they are. */
TEST(roughness_closes)
{
    const char *rough = "[feature r]\nshape = roughness\nRq = 0.004\n"
                        "length = 4\nshortest = 0.3\nrolloff = 0.6\n"
                        "peklenik = 0.5\nangle = 20 deg\nextend = periodic\n"
                        "origin = 0\nacross = ";
    char near[300], far[300];
    snprintf(near, sizeof near, "%s0\n", rough);
    snprintf(far, sizeof far, "%s%.17g\n", rough, 9 * 2. / 56);
    solved a = solve(near), b = solve(far);
    for (size_t j = 0; j < 56; j++)
        for (size_t i = 0; i < a.s->n; i++) {
            CHECK_NEAR(height(&b, i, (j + 9) % 56), height(&a, i, j), 1e-12);
            CHECK_NEAR(pressure(&b, i, (j + 9) % 56), pressure(&a, i, j), 2e-8);
        }
    drop(&a);
    drop(&b);
}

#define TEXTURE                                                                \
    "[contact]\nM = 9\nL = 12\nslide_to_roll = -2\n[domain]\nlevel = 5\n"      \
    "order = 2\n[strip]\nwidth = 4\nlines = 64\n[feature t]\n"                 \
    "shape = texture\ndepth = 0.3\nwidth = 0.4\nwavelength = 0.6\n"            \
    "wavelength_across = 0.4\nstagger = 0.5\n"

/* Dimples deeper than the film on few lines.  Between them the pressure is
 * three times the Hertzian one.  Dimples that appear in time end in the same
 * film. R of the steps is 5e-3. */
TEST(deep_texture_on_few_lines)
{
    ovr_case *a = read_case(TEXTURE, ""),
             *b = read_case(TEXTURE, "grow = 2\n[time]\nend = 10\n"
                                     "step = 0.1\nscheme = upstream2\n");
    ovr_run *steady = run_of(a, NULL), *in_time = run_of(b, NULL);
    const ovr_strip_solver *s = ovr_strip_of(ovr_run_get_info(steady)->sim);
    const ovr_strip_solver *t = ovr_strip_of(ovr_run_get_info(in_time)->sim);
    const ovr_observation *o = ovr_simulation_observation(
        ovr_run_get_info(steady)->sim);
    const ovr_strip_level *f = ovr_strip_finest(s), *g = ovr_strip_finest(t);
    assert_true(o->converged && o->P_max > 2.5);
    print_message("    %d cycles\n", o->cycles);
    assert_in_range(o->cycles, 1, 1500);
    for (size_t i = 0; i < s->n; i++)
        for (size_t j = 0; j < s->lines; j++) {
            size_t at = ovr_strip_row(&f->grid, i) + j;
            CHECK_NEAR(g->f.P[at], f->f.P[at], 1e-2);
            CHECK_NEAR(g->f.H[at], f->f.H[at], 2e-4);
        }
    ovr_run_free(steady);
    ovr_run_free(in_time);
    ovr_case_free(a);
    ovr_case_free(b);
}

/* Roughness of twice the film thickness that slides through a Newtonian
 * contact.  A step with retries in 100 is allowed, none may fail. */
TEST(roughness_of_twice_the_film)
{
    ovr_case *c = read_case(
        "[contact]\nM = 20\nL = 10\nslide_to_roll = 0.5\n[domain]\n"
        "level = 5\n[time]\nend = 5\n",
        STRIP "[feature r]\nshape = roughness\nRq = 0.168\nlength = 6\n"
              "shortest = 0.3\nrolloff = 0.6\nstart = -3.9\n");
    ovr_run *run = run_of(c, NULL);
    const ovr_statistics *s = ovr_simulation_statistics(
        ovr_run_get_info(run)->sim);
    printf("%ld steps, %ld cycles, %ld retries, %ld flagged\n", s->steps,
           s->cycles, s->retries, s->marked);
    assert_true(s->steps > 150 && s->retries * 100 <= s->steps);
    assert_int_equal(s->marked, 0);
    ovr_run_free(run);
    ovr_case_free(c);
}

/* A wave at 45 degrees is a sum of products of waves along and across. */
TEST(an_oblique_wave)
{
    solved one = solve(WAVE "0.7071067811865476\nangle = 45 deg\n");
    for (size_t j = 0; j < one.s->lines; j++)
        for (size_t i = 0; i < one.s->n; i += 3)
            CHECK_NEAR(height(&one, i, j),
                       0.004 * cos(2 * acos(-1) * (one.s->X[i] + one.s->Y[j])),
                       1e-12);
    drop(&one);
}

static bool stops(void *calls)
{
    return ++*(int *)calls == 9;
}

TEST_IN_FOLDER(stopped_and_resumed_to_the_bit)
{
    char path[300];
    ovr_error err = {0};
    int calls = 0;
    snprintf(path, sizeof path, "%s/strip.h5", (const char *)*state);
    ovr_case *c = read_case(CONTACT IN_TIME RIDGE, STRIP);
    ovr_run *whole = run_of(c, NULL);
    ovr_run_options how = {
        .output = path, .force = true, .stop = stops, .data = &calls};
    ovr_run *part = ovr_run_create(c, &how, NULL, &err);
    assert_non_null(part);
    CHECK_STATUS(ovr_run_execute(part, &err), OVR_STOPPED, &err);
    ovr_run_free(part);
    how = (ovr_run_options){0};
    ovr_run *rest = ovr_run_resume(path, &how, NULL, &err);
    if (!rest)
        print_message("%s\n", err.message);
    assert_non_null(rest);
    CHECK_OK(ovr_run_execute(rest, &err), &err);
    const ovr_strip_level *a = ovr_strip_finest(
        ovr_strip_of(ovr_run_get_info(whole)->sim));
    const ovr_strip_level *b = ovr_strip_finest(
        ovr_strip_of(ovr_run_get_info(rest)->sim));
    size_t bytes = ovr_strip_size(&a->grid) * sizeof(double);
    assert_memory_equal(a->f.P, b->f.P, bytes);
    assert_memory_equal(a->f.H, b->f.H, bytes);
    ovr_run_free(whole);
    ovr_run_free(rest);
    ovr_case_free(c);
}

static void refused(const char *strip, const char *words)
{
    ovr_error err = {0};
    ovr_case *c = read_case(CONTACT, strip);
    ovr_setup *setup = ovr_case_resolve(c, NULL, &err);
    ovr_status status = setup ? ovr_setup_prepare(setup, NULL, &err)
                              : err.status;
    CHECK_STATUS(status, OVR_BAD_INPUT, &err);
    if (!strstr(err.message, words))
        print_message("%s\n", err.message);
    assert_non_null(strstr(err.message, words));
    ovr_setup_free(setup);
    ovr_case_free(c);
}

TEST(lines_that_cannot_be_halved_or_are_too_close)
{
    refused("[strip]\nlines = 100\n", "the nearest are 96 and 112");
    refused("[strip]\nlines = 256\n", "mesh size across");
}

/* Six lines are not halved to three. */
TEST(few_lines)
{
    ovr_case *c = read_case("[contact]\nM = 20\nL = 10\n[domain]\nlevel = 4\n",
                            "[strip]\nwidth = 0.6\nlines = 12\n");
    ovr_run *run = run_of(c, NULL);
    assert_true(
        ovr_simulation_observation(ovr_run_get_info(run)->sim)->converged);
    ovr_run_free(run);
    ovr_case_free(c);
}

TEST(features_that_do_not_close)
{
    refused(STRIP WAVE "0.7\nangle = 45 deg\n",
            "the nearest values are 0.471404521 and 0.707106781");
    refused(STRIP "[feature g]\nshape = groove\ndepth = 0.01\nwidth = 0.3\n"
                  "start = 0\nangle = 45 deg\n",
            "set repeat = 2 or 1");
    refused(STRIP "[feature t]\nshape = texture\ndepth = 0.01\nwidth = 0.3\n"
                  "wavelength = 0.45\n",
            "the nearest values are 0.4 and 0.5");
    refused(STRIP "[feature s]\nshape = step\nheight = 0.01\nstart = 0\n"
                  "width_across = 0.3\n",
            "has no width_across");
}

TEST(what_has_no_strip)
{
    refused("[strip]\n[paper]\nsmoother = hybrid\n",
            "cannot be combined with a strip; use line");
    refused("[strip]\n[cavitation]\nmodel = conserving\n",
            "cannot be combined with a strip; use reynolds");
    refused("[strip]\n[stress]\n", "with a strip; use no [stress]");
    refused("[strip]\n[time]\nend = 1\nscheme = upstream1\n",
            "with a strip; use upstream2");
    refused("[strip]\n[time]\nend = 1\nstep = adaptive\n",
            "with a strip; use auto");
    refused("[strip]\n[time]\nend = 1\n[speed]\nhistory = ramp\nfrom = 1\n"
            "to = -1\nduration = 0.5\n",
            "with a strip; use a speed that keeps its direction");
}
