/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic layers (contact/layers.h, physics/coating/images.h): compliance,
 * kernel and dry contact compared with another solution, limits, sums without
 * multigrid, and film thicknesses compared with the kernel by quadrature,
 * without images. */
#include "support/test.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contact/layers.h"
#include "overroll/case.h"
#include "physics/coating/images.h"
#include "physics/heat/solids.h"
#include "reference/layers_truth.h"
#include "simulation/internal.h"
#include "support/memory.h"

enum { CASES = sizeof truth_cases / sizeof *truth_cases };
static const double pi = 3.14159265358979323846;

static void bodies_of(const layers_truth *t, ovr_layered body[2])
{
    memset(body, 0, 2 * sizeof *body);
    body[0].layers = t->layers;
    for (int j = 0; j < t->layers; j++) {
        body[0].thickness[j] = t->thickness[j];
        body[0].layer[j] = (ovr_elastic){t->E[j], t->nu[j]};
    }
    body[0].below = (ovr_elastic){t->below[0], t->below[1]};
    body[1].below = (ovr_elastic){t->other[0], t->other[1]};
}

TEST(softness)
{
    for (int c = 0; c < CASES; c++) {
        const layers_truth *t = &truth_cases[c];
        ovr_layered body[2];
        bodies_of(t, body);
        for (int i = 0; i < TRUTH_WAVES; i++)
            CHECK_CLOSE(t->A0 * ovr_layers_softness(body, truth_k[i]), t->A[i],
                        1e-12);
    }
}

/* Kernel by the images, whose fit error is reported, near a node and far from
 * it, in the limit D = 0. */
TEST(kernel)
{
    for (int c = 0; c < CASES; c++) {
        const layers_truth *t = &truth_cases[c];
        ovr_layered body[2];
        ovr_images images;
        bodies_of(t, body);
        ovr_images_fit(body, &images);
        assert_true(images.error < 1e-8);
        CHECK_CLOSE(t->A0 * images.top, t->top, 1e-12);
        for (int i = 0; i < TRUTH_WAVES; i++)
            CHECK_CLOSE(t->A0 * ovr_images_softness(&images, truth_k[i]),
                        t->A[i], 1e-8);
        for (int i = 0; i < TRUTH_POINTS; i++) {
            double X = truth_X[i], K = images.top * log(X);
            for (int m = 0; m < images.count; m++)
                K += images.weight[m] * log(hypot(X, images.depth[m]));
            CHECK_NEAR(t->A0 * K, t->K[i], 1e-6 * fmax(1, t->top));
        }
    }
}

TEST(dry_contact)
{
    for (int c = 0; c < CASES; c++) {
        const layers_truth *t = &truth_cases[c];
        ovr_layered body[2];
        ovr_images images;
        bodies_of(t, body);
        ovr_images_fit(body, &images);
        double a = t->dry ? 1 : ovr_images_half_width(&images, 1);
        ovr_layered_hertz dry = ovr_images_dry(&images, a);
        CHECK_CLOSE(a, t->half_width, 1e-6);
        CHECK_CLOSE(dry.pressure / a, t->P0, 1e-6);
        if (t->dry)
            CHECK_CLOSE(dry.stiffness, t->A0, 1e-6);
    }
}

/* Different layers on both bodies. */
TEST(dry_contact_of_two)
{
    const ovr_layered body[2] = {
        {1, {0.1}, {{0.5, 0.3}}, {1, 0.3}, {0}, {0}, {0}},
        {1, {0.05}, {{2, 0.25}}, {1, 0.3}, {0}, {0}, {0}}};
    ovr_images images;
    ovr_images_fit(body, &images);
    double a = ovr_images_half_width(&images, 1);
    CHECK_CLOSE(a, 1.0228925262612, 1e-6);
    CHECK_CLOSE(ovr_images_dry(&images, a).pressure / a, 0.9892346362, 1e-6);
}

/* A layer on a substrate 1e5 times as stiff, against an equally stiff body.
 * The contact of a thin layer approaches its own limit, w = 2/3 m a^3/(t R),
 * to first order in t/a: half the thickness halves the difference. */
TEST(rigid_base)
{
    const double E = 1e5;
    for (size_t k = 0; k < sizeof truth_rigid / sizeof *truth_rigid; k++) {
        double nu = truth_rigid[k].nu, a = truth_rigid[k].a_over_t;
        ovr_layered body[2] = {{1, {1}, {{1, nu}}, {E, 0.3}, {0}, {0}, {0}},
                               {0, {0}, {{0, 0}}, {E, 0.3}, {0}, {0}, {0}}};
        ovr_images images;
        if (nu == 0.5 && a > 10)
            continue; /* the substrate of 1e5 is not rigid for that one */
        ovr_images_fit(body, &images);
        double whole = E / (1 - 0.09), star = 1 / (1 - nu * nu);
        double load = pi * a * a * whole *
                      ovr_images_dry(&images, a).stiffness / (8 * star);
        CHECK_CLOSE(load, truth_rigid[k].load, nu == 0.5 ? 0.01 : 2e-3);
    }
}

static double over_thin_limit(double nu, double a)
{
    const double E = 1e5;
    ovr_layered body[2] = {{1, {1}, {{1, nu}}, {E, 0.3}, {0}, {0}, {0}},
                           {0, {0}, {{0, 0}}, {E, 0.3}, {0}, {0}, {0}}};
    ovr_images images;
    ovr_images_fit(body, &images);
    double m = (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    double load = pi * a * a * E / (1 - 0.09) *
                  ovr_images_dry(&images, a).stiffness / 8;
    return load / (2. / 3 * m * a * a * a);
}

TEST(thin_limit)
{
    double ten = over_thin_limit(0.3, 10) - 1,
           twenty = over_thin_limit(0.3, 20) - 1;
    CHECK_NEAR(twenty, 0, 0.02);
    CHECK_NEAR(twenty / ten, 0.5, 0.05);
}

/* The layer's moduli are the substrate's: no image, and in no number but
 * rounding. */
TEST(nothing_of_nothing)
{
    const ovr_layered body[2] = {
        {3,
         {0.1, 0.5, 0.2},
         {{1, 0.3}, {1, 0.3}, {1, 0.3}},
         {1, 0.3},
         {0},
         {0},
         {0}},
        {1, {0.02}, {{2.5, 0.22}}, {2.5, 0.22}, {0}, {0}, {0}}};
    ovr_images images;
    ovr_images_fit(body, &images);
    assert_int_equal(images.count, 0);
    CHECK_NEAR(images.top, 1, 1e-15);
    CHECK_NEAR(ovr_images_dry(&images, 3).stiffness, 1, 1e-13);
    CHECK_NEAR(ovr_images_half_width(&images, 2), 2, 1e-12);
}

/* ----------------------------------------------------------------- meshes */

typedef struct layered {
    ovr_images images;
    ovr_image_sum sum;
    ovr_influence influence;
} layered;

static void make(double E, double nu, double t, double D, layered *l)
{
    const ovr_layered body[2] = {{1, {t}, {{E, nu}}, {1, 0.3}, {0}, {0}, {0}},
                                 {0, {0}, {{0, 0}}, {1, 0.3}, {0}, {0}, {0}}};
    ovr_images_fit(body, &l->images);
    ovr_image_sum_make(&l->sum, &l->images, 1, 1, 60 * D, 24);
    l->influence = (ovr_influence){0};
    ovr_influence_add(&l->influence, ovr_image_part(&l->sum));
}

/* ------------------------------------------------- a node by quadrature */

typedef struct node {
    const ovr_images *of;
    double X, D;
    bool linear;
} node;

/* The logarithm and all images at X + s D, weighed as the pressure is. */
static double weighed(double s, void *data)
{
    const node *n = data;
    double x = n->X + s * n->D, K = n->of->top * log(fabs(x));
    for (int m = 0; m < n->of->count; m++)
        K += n->of->weight[m] * log(hypot(x, n->of->depth[m]));
    return n->linear ? (1 - fabs(s)) * K : K;
}

/* At a node, beside it, by the series, by the table. */
TEST(influence_by_quadrature)
{
    static const double at[] = {0, 1, 2, 5, 9, 20, 63, 64, 100, 333};
    const double D = 0.01;
    layered l;
    make(0.05, 0.4, 0.05, D, &l);
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(2000);
    for (int linear = 0; linear < 2; linear++)
        for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
            node n = {&l.images, at[i] * D, D, linear};
            gsl_function f = {weighed, &n};
            double end = linear ? 1 : 0.5, left, right, error;
            gsl_integration_qags(&f, -end, 0, 1e-11, 1e-10, 2000, w, &left,
                                 &error);
            gsl_integration_qags(&f, 0, end, 1e-11, 1e-10, 2000, w, &right,
                                 &error);
            l.influence.linear = linear;
            CHECK_NEAR(pi / D * ovr_influence_at(&l.influence, at[i], D),
                       left + right, 1e-8);
        }
    gsl_integration_workspace_free(w);
}

/* MLMI of a rough pressure against the sum, for soft and stiff layers from a
 * third of a mesh to many. */
TEST(sums)
{
    static const double E[] = {0.0146, 0.1, 0.5, 5}, t[] = {0.3, 3, 30, 300};
    enum { N = 449 };
    const double D = 5.5 / (N - 1);
    uint64_t seed = 11;
    for (size_t e = 0; e < 4; e++)
        for (size_t k = 0; k < 4; k++) {
            layered l;
            ovr_error err = {0};
            ovr_arena arena = ovr_arena_make(NULL);
            const ovr_kernels *run = ovr_kernels_choose("plain");
            ovr_mlmi plan = {0};
            double P[N], maximum = 0;
            make(E[e], 0.4, t[k] * D, D, &l);
            CHECK_OK(
                ovr_mlmi_plan(&plan, N, (ovr_mlmi_form){12, 16}, &arena, &err),
                &err);
            plan.part = l.influence.part;
            plan.parts = l.influence.parts;
            ovr_mlmi_fill(&plan, D, NULL);
            double *in = ovr_mlmi_field(&plan, &arena, &err);
            double *out = ovr_mlmi_field(&plan, &arena, &err);
            for (int i = 0; i < N; i++) {
                double X = -4 + D * i;
                P[i] = X * X < 1 ? sqrt(1 - X * X) *
                                       (1 + test_random(&seed, -0.3, 0.3))
                                 : 0;
                in[i] = P[i];
            }
            run->deformation(&plan, in, out);
            for (int i = 0; i < N; i++) {
                double w = 0;
                for (int j = 0; j < N; j++)
                    w += ovr_influence_at(&l.influence, i - j, D) * P[j];
                maximum = fmax(maximum, fabs(w - out[i]));
            }
            CHECK_NEAR(maximum, 0, 1e-6);
            ovr_arena_release(&arena);
        }
}

/* ------------------------------------------------------------------- films */

typedef struct film {
    ovr_case *c;
    ovr_setup *setup;
    ovr_simulation *sim;
    const ovr_state *state;
    double H_cen;
} film;

static film solve(const char *text)
{
    ovr_error err = {0};
    film f;
    f.c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    if (!f.c)
        print_message("%s\n", err.message);
    assert_non_null(f.c);
    f.setup = ovr_case_resolve(f.c, NULL, &err);
    if (!f.setup)
        print_message("%s\n", err.message);
    assert_non_null(f.setup);
    f.sim = ovr_setup_simulation(f.setup, NULL, &err);
    if (!f.sim)
        print_message("%s\n", err.message);
    assert_non_null(f.sim);
    CHECK_OK(ovr_simulation_steady(f.sim, &err), &err);
    f.state = ovr_simulation_state(f.sim);
    f.H_cen = ovr_simulation_observation(f.sim)->H_cen;
    return f;
}

static void release(film *f)
{
    ovr_simulation_free(f->sim);
    ovr_setup_free(f->setup);
    ovr_case_free(f->c);
}

static void write_case(char *text, size_t capacity, double M, double L,
                       int level, const char *scale, const char *more)
{
    snprintf(text, capacity,
             "[contact]\nM = %g\nL = %g\n%s%s\n[domain]\nlevel = %d\n"
             "inlet = -4\noutlet = 1.5\n[body 1]\nmodulus = 200 GPa\n[body "
             "2]\nmodulus = 200 GPa\n%s",
             M, L, strstr(more, "coating") ? "scale = " : "",
             strstr(more, "coating") ? scale : "", level, more);
}

/* (1/pi) int K P with K by its waves, P linear between the nodes and corrected
 * for what that adds to its second moment, at some nodes; less the logarithm's
 * part, which the images leave alone:
 *     -(D/pi) int_0 (A - 1)/k (sin(kD/2)/(kD/2))^2 sum_j P_j cos(k (X - X_j))
 * dk
 */
enum { AT = 6 };

static void rest_by_waves(const ovr_layered body[2], const ovr_state *s,
                          const double *P, const size_t at[AT], double w[AT])
{
    const double wide = 0.5;
    size_t n = s->n;
    double D = s->X[1] - s->X[0];
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(
        8);
    memset(w, 0, AT * sizeof *w);
    for (int panel = 0; panel * wide < 2 * pi / D; panel++)
        for (size_t q = 0; q < 8; q++) {
            double k, share, re = 0, im = 0, c = 1, d = 0;
            gsl_integration_glfixed_point(panel * wide, (panel + 1) * wide, q,
                                          &k, &share, rule);
            double turn = cos(k * D), over = sin(k * D), next;
            for (size_t j = 0; j < n; j++) {
                re += P[j] * c;
                im += P[j] * d;
                next = c * turn - d * over;
                d = c * over + d * turn;
                c = next;
            }
            double sinc = sin(0.5 * k * D) / (0.5 * k * D);
            double part = -share * D / pi * sinc * sinc *
                          (ovr_layers_softness(body, k) - 1) / k;
            for (int i = 0; i < AT; i++) {
                double phase = k * D * (double)at[i];
                w[i] += part * (re * cos(phase) + im * sin(phase));
            }
        }
    gsl_integration_glfixed_table_free(rule);
}

static void put_coating(const char *name, const ovr_layered *body, char *text,
                        size_t capacity)
{
    if (!body->layers)
        return;
    size_t used = strlen(text);
    snprintf(text + used, capacity - used,
             "[coating %s]\nthickness = %.17g\nmodulus = %.17g GPa\npoisson = "
             "%g\n",
             name, body->thickness[0], 200 * body->layer[0].modulus,
             body->layer[0].poisson);
}

static ovr_layered one_layer(double t, double E, double nu)
{
    return (ovr_layered){1, {t}, {{E, nu}}, {1, 0.3}, {0}, {0}, {0}};
}

static const ovr_layered none = {0, {0}, {{0, 0}}, {1, 0.3}, {0}, {0}, {0}};

static void check_film(const char *scale, double M, double L, ovr_layered first,
                       ovr_layered second, double maximum)
{
    char text[800], more[400] = "";
    const ovr_layered body[2] = {first, second};
    put_coating("1", &first, more, sizeof more);
    put_coating("2", &second, more, sizeof more);
    write_case(text, sizeof text, M, L, 8, scale, more);
    film f = solve(text);
    const ovr_state *s = f.state;
    ovr_images images;
    ovr_images_fit(body, &images);
    double e = strcmp(scale, "dry") ? 1 : ovr_images_dry(&images, 1).stiffness;
    size_t n = s->n, at[AT];
    double D = s->X[1] - s->X[0], *P = calloc(n, sizeof *P), w[AT];
    for (size_t j = 1; j + 1 < n; j++)
        P[j] = s->P[j] - (s->P[j - 1] - 2 * s->P[j] + s->P[j + 1]) / 12;
    for (int i = 0; i < AT; i++)
        at[i] = (size_t)((-1.2 + 0.4 * i + 4) / D);
    rest_by_waves(body, s, P, at, w);
    for (int i = 0; i < AT; i++) {
        double X = s->X[at[i]];
        for (size_t j = 0; j < n; j++)
            w[i] += ovr_deformation_linear((double)at[i] - (double)j, D) * P[j];
        CHECK_NEAR(s->H[at[i]], s->H0 + 0.5 * X * X - e * w[i], maximum);
    }
    free(P);
    release(&f);
}

TEST(film_of_the_waves)
{
    check_film("substrate", 20, 10, one_layer(0.05, 0.5, 0.3), none, 2e-6);
    check_film("substrate", 20, 10, one_layer(0.1, 5, 0.3), none, 2e-6);
    check_film("substrate", 20, 10, one_layer(0.1, 0.5, 0.3),
               one_layer(0.05, 2, 0.25), 2e-6);
    check_film("dry", 20, 2, one_layer(0.2, 0.0146, 0.4), none, 2e-6);
    check_film("dry", 20, 2, one_layer(0.5, 0.0146, 0.4), none, 2e-6);
    check_film("dry", 20, 2, one_layer(0.5, 0.0146, 0.4),
               one_layer(0.1, 3, 0.2), 2e-6);
}

static double central(double M, double L, int level, const char *scale,
                      const char *more)
{
    char text[800];
    write_case(text, sizeof text, M, L, level, scale, more);
    film f = solve(text);
    double H = f.H_cen;
    release(&f);
    return H;
}

/* A layer of the substrate's moduli, whatever else is solved otherwise with
 * it; one that is nearly nothing; both bodies nothing but layer. */
TEST(limits)
{
    const char *plain = "[paper]\nmlmi_order = 12\nmlmi_range = 16\n";
    double bare = central(20, 10, 7, "dry", plain);
    CHECK_CLOSE(central(20, 10, 7, "dry",
                        "[coating 1]\nthickness = 0.1\nmodulus = 200 GPa\n"
                        "[coating 1b]\nthickness = 0.2\nmodulus = 200 GPa\n"
                        "[coating 2]\nthickness = 1\nmodulus = 200 GPa\n"),
                bare, 1e-12);
    CHECK_CLOSE(central(20, 10, 8, "dry",
                        "[coating 1]\nthickness = 1e-4\nmodulus = 400 GPa\n"),
                central(20, 10, 8, "dry", plain), 1e-3);
    CHECK_CLOSE(central(20, 10, 7, "dry",
                        "[coating 1]\nthickness = 30\nmodulus = 100 GPa\n"
                        "[coating 2]\nthickness = 30\nmodulus = 100 GPa\n"),
                bare, 3e-4);
}

/* Corrected with the layers' own constant; of second order they differ by
 * some 1e-3. */
TEST(fourth_order)
{
    const char *layer = "[coating 1]\nthickness = 0.5\nmodulus = 2.92 GPa\n"
                        "poisson = 0.4\n";
    const char *hard = "[coating 1]\nthickness = 0.017\nmodulus = 1000 GPa\n";
    CHECK_CLOSE(central(20, 2, 7, "dry", layer),
                central(20, 2, 9, "dry", layer), 1e-5);
    CHECK_CLOSE(central(50, 10, 8, "dry", hard),
                central(50, 10, 10, "dry", hard), 1e-5);
}

/* Films of the same equations with another program's images and, on every
 * grid, MLMI of order 10 alone, which is off by 2e-5 of w for a soft layer. */
TEST(films)
{
    CHECK_CLOSE(central(20, 10, 8, "substrate",
                        "[coating 1]\nthickness = 0.05\nmodulus = 100 GPa\n"),
                0.08373309779498081, 1e-6);
    CHECK_CLOSE(central(100, 10, 9, "substrate",
                        "[coating 1]\nthickness = 0.05\nmodulus = 300 GPa\n"),
                0.01345738592175169, 2e-6);
    CHECK_CLOSE(central(50, 2, 8, "dry",
                        "[coating 1]\nthickness = 0.2\nmodulus = 2.92 GPa\n"
                        "poisson = 0.4\n"),
                0.012558621025164272, 3e-5);
}

static const char liner[] = "[coating 1]\nthickness = 0.5\nmodulus = 2.92 "
                            "GPa\npoisson = 0.4\n";

static ovr_observation observed(double M, double L, const char *scale,
                                int level, const char *more)
{
    char text[800];
    write_case(text, sizeof text, M, L, level, scale, more);
    film f = solve(text);
    ovr_observation seen = *ovr_simulation_observation(f.sim);
    release(&f);
    return seen;
}

/* At high load the contact is the dry one except for the film thickness. */
TEST(nearly_dry)
{
    const layers_truth *t = &truth_cases[3];
    assert_string_equal(t->name, "liner");
    double at_100 = t->P0 - observed(100, 2, "dry", 8, liner).P_max;
    double at_400 = t->P0 - observed(400, 2, "dry", 8, liner).P_max;
    CHECK_NEAR(at_400 / t->P0, 0, 3e-4);
    assert_true(at_100 > 0 && at_400 < at_100 / 4);
}

/* The band of the line smoother is corrected for layers. The smoother of the
 * paper has no band and solves the same equations of second order. */
TEST(by_another_smoother)
{
    static const char *const name[] = {"line", "hybrid"};
    double H[2], P[2];
    for (int k = 0; k < 2; k++) {
        char more[400];
        snprintf(more, sizeof more,
                 "%s[domain]\norder = 2\n[paper]\nsmoother = "
                 "%s\n[solver]\ntolerance = "
                 "1e-9\nstop = negligible\n",
                 liner, name[k]);
        ovr_observation o = observed(20, 2, "dry", 7, more);
        H[k] = o.H_cen;
        P[k] = o.P_max;
    }
    CHECK_CLOSE(H[1], H[0], 1e-8);
    CHECK_CLOSE(P[1], P[0], 1e-8);
}

/* Patches around the spike, of second order, compared with the uniform grid of
 * the finest patch. */
TEST(patches)
{
    const char *layer = "[coating 1]\nthickness = 0.017\nmodulus = 1000 GPa\n";
    char more[400];
    snprintf(more, sizeof more,
             "%s[domain]\nrefine = spike\nrefine_level = 14\n", layer);
    ovr_observation patched = observed(20, 10, "substrate", 8, more);
    snprintf(more, sizeof more, "%s[domain]\norder = 2\n", layer);
    ovr_observation uniform = observed(20, 10, "substrate", 14, more);
    CHECK_CLOSE(patched.P_spike, uniform.P_spike, 1e-4);
    CHECK_CLOSE(patched.H_cen, uniform.H_cen, 1e-6);
    CHECK_NEAR(patched.X_spike, uniform.X_spike, 1e-5);
}

/* -------------------------------------------------------------------- heat */

/* M(t) over that of the layer itself, by the series of one layer; DLC and TiN
 * of 3 um on steel. */
TEST(warmth)
{
    static const struct {
        double k, rho_c, t, M;
    } truth[] = {{1.5, 2e6, 1e-7, 1},
                 {1.5, 2e6, 1e-6, 0.9999906038314934},
                 {1.5, 2e6, 1e-5, 0.5489973918246815},
                 {1.5, 2e6, 7.08e-5, 0.14694298733793898},
                 {1.5, 2e6, 1e-3, 0.13417376125696123},
                 {20, 3.12e6, 1e-7, 0.9999996108444138},
                 {20, 3.12e6, 1e-6, 0.8807938525316727},
                 {20, 3.12e6, 1e-5, 0.6368907062089288},
                 {20, 3.12e6, 7.08e-5, 0.6121323411765089}};
    const ovr_thermal steel = {46, 1000, 3666};
    for (size_t i = 0; i < sizeof truth / sizeof *truth; i++) {
        const ovr_thermal one = {truth[i].k, 1000, truth[i].rho_c / 1000};
        const ovr_thermal three[] = {one, one, one};
        const double d = 3e-6, split[] = {1e-6, 1.5e-6, 0.5e-6};
        ovr_warmed w = ovr_warmed_of(1, &d, &one, &steel);
        ovr_warmed w3 = ovr_warmed_of(3, split, three, &steel);
        double M = ovr_warmed_at(&w, truth[i].t);
        CHECK_NEAR(M * w.effusivity[0] / w.effusivity[1], truth[i].M, 1e-9);
        CHECK_CLOSE(ovr_warmed_at(&w3, truth[i].t), M, 1e-9);
    }
}

static double warmed_at(const void *data, double t)
{
    return ovr_warmed_at(data, t);
}

/* The modes against M(t)/sqrt(t), of thin layers that a step sees through and
 * of thick ones. */
TEST(memory_of_layers)
{
    for (double tau = 1e-3; tau < 4; tau *= 3)
        for (double dT = 0.003; dT < 0.05; dT *= 3) {
            ovr_warmed w = {1, {1732, 12986}, {tau}};
            ovr_memory m = {0};
            const ovr_warmth warm = {warmed_at, &w};
            ovr_memory_layered(dT / 8, 11, warm, &m);
            ovr_memory_fit(dT, 11, &m);
            CHECK_NEAR(test_memory_error(&m, 11), 0, 1e-4);
        }
}

typedef struct heated {
    double rise, mu, H;
} heated;

static heated hot(const char *bodies, const char *coating)
{
    char text[1500];
    snprintf(text, sizeof text,
             "[contact]\nhertz_pressure = 1 GPa\nradius = 12 mm\nmean_speed = "
             "3 m/s\nslide_to_roll = 0.2\n[lubricant]\nviscosity = 20 mPa.s\n"
             "alpha = 18 1/GPa\nrheology = eyring\neyring_stress = 5 MPa\n"
             "[heat]\nmodel = lobatto\ntemperature = 80 degC\n[domain]\nlevel "
             "= 6\n[paper]\nmlmi_order = 12\nmlmi_range = 16\n"
             "[body 1]\n%s[body 2]\n%s%s",
             bodies, bodies, coating);
    film f = solve(text);
    const ovr_observation *o = ovr_simulation_observation(f.sim);
    heated result = {o->T_1_max_rise, o->mu_slide, o->H_cen};
    release(&f);
    return result;
}

#define STEEL "modulus = 206 GPa\n"
#define CARBON                                                                 \
    "conductivity = 1.5 W/m.K\nheat_capacity = 1000 J/kg.K\ndensity = 2000 "   \
    "kg/m3\n"
#define SAME                                                                   \
    "conductivity = 46 W/m.K\nheat_capacity = 460 J/kg.K\ndensity = 7850 "     \
    "kg/m3\n"

/* A layer of the body's own constants is none; one that no heat passes in time
 * is the body; one between is between, and the film the more sheared thin. */
TEST(hot_layers)
{
    heated bare = hot(STEEL, ""), all = hot(STEEL CARBON, "");
    heated same = hot(STEEL, "[coating 1]\nthickness = 3 um\n" STEEL SAME
                             "[coating 2]\nthickness = 20 um\n" STEEL SAME);
    CHECK_CLOSE(same.rise, bare.rise, 1e-4);
    CHECK_CLOSE(same.H, bare.H, 1e-5);
    heated thick = hot(STEEL, "[coating 1]\nthickness = 300 um\n" STEEL CARBON
                              "[coating 2]\nthickness = 300 um\n" STEEL CARBON);
    CHECK_CLOSE(thick.rise, all.rise, 2e-3);
    CHECK_CLOSE(thick.mu, all.mu, 1e-3);
    heated thin = hot(STEEL, "[coating 1]\nthickness = 3 um\n" STEEL CARBON
                             "[coating 2]\nthickness = 3 um\n" STEEL CARBON);
    assert_true(thin.rise > 2 * bare.rise && thin.rise < all.rise);
    assert_true(fabs(thin.mu) < 0.95 * fabs(bare.mu) &&
                fabs(thin.mu) > fabs(all.mu));
}
