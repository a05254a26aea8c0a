/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flow of shear-thinning films: the Eyring model compared with quadrature
 * across the film, derivatives with differences, and the kernels with the plain
 * one. */
#include <gsl/gsl_integration.h>
#include <math.h>

#include "contact/contact.h"
#include "multigrid/flow.h"
#include "support/kernels.h"
#include "support/test.h"

/* Gauss-Legendre on [-1, 1], by GSL's tables. */
enum { GAUSS = 48 };
static void gauss(double s[GAUSS], double w[GAUSS])
{
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(
        GAUSS);
    assert_non_null(table);
    for (size_t k = 0; k < GAUSS; k++)
        gsl_integration_glfixed_point(-1, 1, k, &s[k], &w[k], table);
    gsl_integration_glfixed_table_free(table);
}

/* int s^m sinh(a + g s) ds */
static double moment(double a, double g, int m)
{
    static double s[GAUSS], w[GAUSS];
    double sum = 0;
    if (w[0] == 0)
        gauss(s, w);
    for (int k = 0; k < GAUSS; k++)
        sum += w[k] * (m ? s[k] : 1) * sinh(a + g * s[k]);
    return sum;
}

/* One half node, of given eps, c and g for both nodes. */
static ovr_pair half_node(const ovr_fluid *fluid, double eps, double c,
                          double g)
{
    double H = 0.3;
    double q = fluid->sliding != 0 ? c / ovr_flow_slide(fluid) / H : 1;
    double dP = g / (ovr_flow_gradient(fluid, 0.01) * 2 * H);
    return (ovr_pair){{0.5, 0.5 + dP}, {H, H}, {q, q}, {eps, eps}};
}

static ovr_fluid eyring(double Sigma0, double sliding)
{
    return (ovr_fluid){.lubricant = {.rheology = OVR_EYRING, .Sigma0 = Sigma0},
                       .sliding = sliding};
}

/* The mean stress a is what makes half the integral of f equal to c/eps; the
 * flow is eps 3/(2 g) int s f ds. */
TEST(flow_is_the_integral)
{
    const double slides[] = {0, 1e-3, 1, 30, 3e3, 1e9};
    const double gradients[] = {1e-3, 0.2, 0.26, 1, 4, 9};
    const ovr_fluid fluid = eyring(0.3, 0.5);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++) {
            double eps = 1e-3, c = slides[i] * eps, g = gradients[j];
            double B = g / sinh(g), a = asinh(B * slides[i]);
            ovr_pair nodes = half_node(&fluid, eps, c, g);
            double E = ovr_flow_between(&fluid, 0.01, &nodes);
            CHECK_NEAR(moment(a, g, 0) / 2, slides[i],
                       1e-11 * slides[i] + 1e-12);
            CHECK_CLOSE(E, eps * 1.5 / g * moment(a, g, 1), 1e-9);
        }
}

/* Without a limit on Sigma0 the film is Newtonian to rounding; a lubricant
 * without a flow law is exactly. */
TEST(thick_films_are_newtonian)
{
    ovr_fluid fluid = eyring(1e12, 0.5), none = {.sliding = 0.5};
    ovr_pair nodes = {{0.5, 0.7}, {0.2, 0.1}, {0.25, 0.1}, {1e-3, 3e-3}};
    CHECK_CLOSE(ovr_flow_between(&fluid, 0.01, &nodes), 2e-3, 1e-14);
    fluid.lubricant.Sigma0 = INFINITY;
    CHECK_CLOSE(ovr_flow_between(&fluid, 0.01, &nodes), 2e-3, 1e-15);
    assert_true(ovr_flow_between(&none, 0.01, &nodes) == 2e-3);
}

/* Results of the plain kernel on a grid of two nodes. */
typedef struct pair {
    double P[2], H[2], rho[2], q[2], eps[2], deps[2], deps_dH[2], out[5][2];
    double alpha, log_fluidity[2],
        log_slope[2]; /* eps falls as exp(-alpha P) */
} pair;

static void evaluate(const ovr_fluid *fluid, pair *p)
{
    ovr_fields f = {.P = p->P,
                    .H = p->H,
                    .rho = p->rho,
                    .q = p->q,
                    .eps = p->eps,
                    .deps = p->deps,
                    .deps_dH = p->deps_dH,
                    .flow = p->out[0],
                    .out_left = p->out[1],
                    .out_right = p->out[2],
                    .by_left = p->out[3],
                    .by_right = p->out[4]};
    for (int k = 0; k < 2; k++) {
        p->q[k] = p->rho[k] * p->H[k];
        p->deps[k] = -p->alpha * p->eps[k];
        p->deps_dH[k] = 3 * p->eps[k] / p->H[k];
        p->log_slope[k] = -p->alpha;
        p->log_fluidity[k] = log2(p->eps[k] / (p->rho[k] * pow(p->H[k], 3)));
    }
    if (fluid->logarithmic)
        f.log_fluidity = p->log_fluidity, f.log_slope = p->log_slope;
    const ovr_lanes nodes = {2, 2, 1};
    if (ovr_flow_is_shear_thinning(fluid))
        test_kernels(0)->flow(fluid, 0.01, &nodes, &f);
    else
        test_kernels(0)->faces(fluid, &nodes, &f);
}

/* 2 E and 2 E dP. */
typedef struct flows {
    double E, flux;
} flows;

/* eps follows pressure and film of the node that is nudged. */
static flows nudged(const ovr_fluid *fluid, pair p, int k, double dP, double dH)
{
    p.P[k] += dP;
    p.eps[k] *= exp(-p.alpha * dP) * pow(1 + dH / p.H[k], 3);
    p.H[k] += dH;
    evaluate(fluid, &p);
    return (flows){p.out[0][0], p.out[0][0] * (p.P[1] - p.P[0])};
}

static double by_film(const ovr_fluid *fluid, pair p, int k)
{
    const double h = 1e-6;
    return (nudged(fluid, p, k, 0, h).E - nudged(fluid, p, k, 0, -h).E) /
           (2 * h);
}

static double by_pressure(const ovr_fluid *fluid, pair p, int k)
{
    const double h = 1e-6;
    return (nudged(fluid, p, k, h, 0).flux - nudged(fluid, p, k, -h, 0).flux) /
           (2 * h);
}

/* The viscosity is exponential in pressure, of the same density in both nodes:
 * then the derivatives of the logarithmic mean are exact too. */
static void check_slopes(const ovr_fluid *fluid)
{
    const double slopes[] = {1e-5, 1e-3, 0.02, -0.05, 0.3, -0.6};
    for (int k = 0; k < 6; k++) {
        pair p = {.P = {0.5, 0.5 + slopes[k]},
                  .H = {0.2, 0.25},
                  .rho = {1.1, 1.1},
                  .alpha = 6};
        for (int m = 0; m < 2; m++)
            p.eps[m] = 1e-2 * pow(p.H[m], 3) * exp(-p.alpha * (p.P[m] - 0.5));
        evaluate(fluid, &p);
        CHECK_CLOSE(p.out[3][0], by_film(fluid, p, 0), 1e-6);
        CHECK_CLOSE(p.out[4][0], by_film(fluid, p, 1), 1e-6);
        CHECK_CLOSE(p.out[1][0], -by_pressure(fluid, p, 0), 1e-6);
        CHECK_CLOSE(p.out[2][0], by_pressure(fluid, p, 1), 1e-6);
    }
}

TEST(slopes_are_differences)
{
    ovr_fluid newtonian = {.by_gap = true}, thin = eyring(0.3, -0.5);
    check_slopes(&newtonian);
    check_slopes(&thin);
    newtonian.logarithmic = true;
    check_slopes(&newtonian);
    thin.by_gap = true;
    check_slopes(&thin);
    thin.logarithmic = true;
    check_slopes(&thin);
}

/* With secants the slope by the pressure of the thicker oil is at least 2 E.
 * The flow and the other slope are the same. */
TEST(slopes_are_secants_at_least)
{
    ovr_fluid fluids[2] = {{.by_gap = true}, eyring(0.3, -0.5)};
    fluids[1].by_gap = true;
    for (int k = 0; k < 4; k++) {
        ovr_fluid fluid = fluids[k % 2];
        pair p = {.P = {0.5, k < 2 ? 0.9 : 0.1},
                  .H = {0.2, 0.25},
                  .rho = {1.1, 1.1},
                  .alpha = 6};
        for (int m = 0; m < 2; m++)
            p.eps[m] = 1e-2 * pow(p.H[m], 3) * exp(-p.alpha * (p.P[m] - 0.5));
        fluid.logarithmic = true;
        evaluate(&fluid, &p);
        pair far = p;
        fluid.secants = true;
        evaluate(&fluid, &far);
        int peak = k < 2 ? 2 : 1, foot = 3 - peak; /* its side of the face */
        assert_true(far.out[0][0] == p.out[0][0]);
        assert_true(far.out[foot][0] == p.out[foot][0]);
        assert_true(far.out[peak][0] > p.out[peak][0]);
        if (k % 2 == 0)
            assert_true(far.out[peak][0] == p.out[0][0]);
    }
}

/* Newtonian flow of a viscosity exp(alpha P) between two nodes of the same film
 * is the integral of H^3 exp(-alpha P) dP, for any difference: from the same
 * pressure to 4 and 40 times 1/alpha.  It grows with P_i and falls with P_j,
 * which the harmonic mean's does not. */
TEST(logarithmic_mean_is_the_integral)
{
    const double rises[] = {0, 1e-9, 1e-4, 0.05, 0.19, 0.21, 1, 4, 40};
    const ovr_fluid fluid = {.by_gap = true, .logarithmic = true};
    for (int k = 0; k < 9; k++) {
        double H = 0.3, dP = rises[k], E = 2 * pow(H, 3);
        if (dP > 0)
            E *= -expm1(-dP) / dP;
        pair p = {.P = {1, 1 + dP},
                  .H = {H, H},
                  .rho = {1, 1},
                  .eps = {pow(H, 3), pow(H, 3) * exp(-dP)},
                  .alpha = 1};
        evaluate(&fluid, &p);
        CHECK_CLOSE(p.out[0][0], E, 2e-12);
        assert_true(p.out[1][0] > 0 && p.out[2][0] > 0);
    }
}

/* A film with negative thickness, as in the first steps of Newton's method, has
 * no flow: neither the flow nor its derivatives by the film thickness exceed
 * those of the other node alone. */
TEST(crossed_films_let_nothing_through)
{
    const ovr_fluid fluid = {.by_gap = true, .logarithmic = true};
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        test_grid plain = test_grid_make(test_kernels(0), 225);
        test_grid g = test_grid_make(run, 225);
        test_grid_logarithmic(&plain);
        test_grid_logarithmic(&g);
        test_grid_fill(&plain, 9);
        test_grid_copy(&plain, &g);
        double *odd[] = {g.f.H, g.f.q, g.f.eps, g.f.deps};
        for (size_t i = 20; i < 200; i += 10)
            for (size_t m = 0; m < 4; m++)
                odd[m][ovr_lanes_place(&g.lanes, i)] *= -1;
        run->faces(&(ovr_fluid){0}, &g.lanes, &g.f);
        for (size_t i = 20; i < 200; i += 10)
            for (size_t j = ovr_lanes_place(&g.lanes, i), m = 0; m < 2; m++) {
                const double *by = m ? g.f.by_right : g.f.by_left;
                CHECK_NEAR(g.f.flow[j], 0, 1e-80);
                CHECK_NEAR(by[j], 0, 1e-20);
            }
        ovr_arena_release(&plain.arena);
        ovr_arena_release(&g.arena);
    }
    pair p = {.P = {0.5, 0.6}, .H = {-0.01, 0.02}, .rho = {1, 1}, .alpha = 6};
    for (int m = 0; m < 2; m++)
        p.eps[m] = 1e-2 * pow(p.H[m], 3);
    evaluate(&fluid, &p);
    for (int m = 0; m < 5; m++)
        CHECK_NEAR(p.out[m][0], 0, 1e-50);
}

/* H^3 goes from 1 to 1/8 with the same fluid: resistances 1 and 8 in line, a
 * conductance of 2/9; what slides by squares, 2/5; a wide node beside a closed
 * one lets nothing through. */
TEST(gaps_are_in_line)
{
    const double f = 1e-3, rho = 1.2;
    ovr_fluid none = {.by_gap = true}, thin = eyring(1, 12e6);
    ovr_pair nodes = {{0.5, 0.5}, {1, 0.5}, {rho, rho / 2}, {f, f / 8}};
    thin.by_gap = true;
    CHECK_CLOSE(ovr_flow_between(&none, 0.01, &nodes), f * 2 / 9, 1e-14);
    CHECK_CLOSE(ovr_flow_between(&thin, 0.01, &nodes), 1e6 * rho * 2 / 5,
                1e-12);
    nodes.H[1] = 1e-4;
    nodes.eps[1] = f * 1e-12;
    CHECK_CLOSE(ovr_flow_between(&none, 0.01, &nodes), 2e-12 * f, 1e-11);
}

static void agree(const test_grid *plain, const test_grid *other)
{
    for (int k = OVR_FIELD_flow; k <= OVR_FIELD_by_right; k++) {
        const double *a = plain->f.all[k];
        if (!a)
            continue;
        other->run->flow(&other->fluid, other->D, &other->lanes, &other->f);
        const double *b = test_grid_read(other, other->f.all[k]);
        for (size_t i = 0; i + 1 < plain->n; i++)
            CHECK_NEAR(b[i], a[i], 1e-11 * fabs(a[i]));
    }
}

/* For gradients from those of an inlet to those that are capped. */
TEST(kernels_agree)
{
    const double stresses[] = {1e-3, 0.05, 0.3, 10};
    const ovr_kernels *run;
    for (int k = 1; (run = test_kernels(k)); k++)
        for (int j = 0; j < 4; j++) {
            test_grid plain = test_grid_make(test_kernels(0), 225);
            test_grid other = test_grid_make(run, 225);
            if (j == 1) {
                test_grid_gap(&plain);
                test_grid_gap(&other);
            } else if (j == 3) {
                test_grid_logarithmic(&plain);
                test_grid_logarithmic(&other);
            }
            plain.fluid.secants = other.fluid.secants = j > 1;
            test_grid_thin(&plain, stresses[j], j % 2);
            test_grid_thin(&other, stresses[j], j % 2);
            if (j > 1) { /* any positive factor on what slides */
                plain.f.drag = plain.f.rho;
                other.f.drag = other.f.rho;
            }
            test_grid_fill(&plain, 9);
            test_grid_copy(&plain, &other);
            agree(&plain, &other);
            ovr_arena_release(&plain.arena);
            ovr_arena_release(&other.arena);
        }
}

/* The same for a table, where it is straight beyond its end too. */
TEST(tables_agree)
{
    const double stresses[] = {1e-7, 0.01, 0.3, 10};
    const ovr_kernels *run;
    ovr_flow_form form = ovr_flow_form_default();
    ovr_error err = {0};
    form.rheology = OVR_CARREAU;
    ovr_flow_law *law = ovr_flow_law_create(&form, NULL, &err);
    CHECK_OK(err.status, &err);
    for (int k = 1; (run = test_kernels(k)); k++)
        for (int j = 0; j < 4; j++) {
            test_grid plain = test_grid_make(test_kernels(0), 225);
            test_grid other = test_grid_make(run, 225);
            if (j == 1) {
                test_grid_gap(&plain);
                test_grid_gap(&other);
            } else if (j == 3) {
                test_grid_logarithmic(&plain);
                test_grid_logarithmic(&other);
            }
            test_grid_thin(&plain, stresses[j], j % 2);
            test_grid_thin(&other, stresses[j], j % 2);
            plain.fluid.lubricant.rheology = OVR_CARREAU;
            plain.fluid.lubricant.flow_law = law;
            other.fluid = plain.fluid;
            test_grid_fill(&plain, 9);
            test_grid_copy(&plain, &other);
            agree(&plain, &other);
            ovr_arena_release(&plain.arena);
            ovr_arena_release(&other.arena);
        }
    ovr_flow_law_free(law);
}

/* Films of a diverged solution, with negative thickness or NaN. The result is
 * meaningless, but the kernel returns. */
TEST(nonsense_stays_in_the_table)
{
    static const double worst[] = {-1, -1e-300, 1e300, INFINITY, NAN};
    ovr_flow_form form = ovr_flow_form_default();
    ovr_error err = {0};
    const ovr_kernels *run;
    form.rheology = OVR_CARREAU;
    ovr_flow_law *law = ovr_flow_law_create(&form, NULL, &err);
    CHECK_OK(err.status, &err);
    for (int k = 0; (run = test_kernels(k)); k++)
        for (size_t j = 0; j < 5; j++) {
            test_grid plain = test_grid_make(test_kernels(0), 225);
            test_grid g = test_grid_make(run, 225);
            test_grid_thin(&plain, 0.3, false);
            test_grid_thin(&g, 0.3, false);
            plain.fluid.lubricant.rheology = OVR_CARREAU;
            plain.fluid.lubricant.flow_law = law;
            g.fluid = plain.fluid;
            test_grid_fill(&plain, 9);
            test_grid_copy(&plain, &g);
            for (size_t i = 10; i < 200; i++)
                g.f.q[i] *= worst[j];
            run->flow(&g.fluid, 0.01, &g.lanes, &g.f);
            ovr_arena_release(&plain.arena);
            ovr_arena_release(&g.arena);
        }
    ovr_flow_law_free(law);
}

/* x (1 + x^2)^(1/2), n = 1/2, a = 2; moments over the film with it. */
static double carreau_moment(double a, double g, int m)
{
    static double s[GAUSS], w[GAUSS];
    double sum = 0;
    if (w[0] == 0)
        gauss(s, w);
    for (int k = 0; k < GAUSS; k++) {
        double x = a + g * s[k];
        sum += w[k] * (m ? s[k] : 1) * x * sqrt(1 + x * x);
    }
    return sum;
}

/* Phi by bisection for the mean stress and quadrature over the film. */
static double carreau_flow(double s_N, double g)
{
    double low = 0, high = s_N;
    for (int k = 0; k < 100; k++) {
        double a = low > 0 ? sqrt(low * high) : high * 1e-3;
        if (carreau_moment(a, g, 0) / 2 > s_N)
            high = a;
        else
            low = a;
    }
    return 1.5 / g * carreau_moment(high, g, 1);
}

/* 400 points of the law itself; largest error and root of the mean square. */
TEST(table_is_the_law)
{
    ovr_fluid fluid = {.sliding = 0.5};
    ovr_flow_form form = ovr_flow_form_default();
    ovr_error err = {0};
    uint64_t seed = 20260923;
    double worst = 0, squares = 0;
    form.rheology = OVR_CARREAU_STRESS;
    ovr_flow_law *law = ovr_flow_law_create(&form, NULL, &err);
    CHECK_OK(err.status, &err);
    fluid.lubricant = (ovr_lubricant){
        .rheology = OVR_CARREAU_STRESS, .Sigma0 = 0.3, .flow_law = law};
    for (int k = 0; k < 400; k++) {
        double s_N = exp(test_random(&seed, log(1e-3), log(3e8)));
        double g = exp(test_random(&seed, log(1e-2), log(200)));
        ovr_pair nodes = half_node(&fluid, 1e-3, 1e-3 * s_N, g);
        double E = ovr_flow_between(&fluid, 0.01, &nodes);
        double off = E / (1e-3 * carreau_flow(s_N, g)) - 1;
        worst = fmax(worst, fabs(off));
        squares += off * off / 400;
    }
    print_message("    flow factor: error %.2g at most, %.2g in the mean\n",
                  worst, sqrt(squares));
    assert_true(worst < 1e-3 && squares < 2e-4 * 2e-4);
    ovr_flow_law_free(law);
}
