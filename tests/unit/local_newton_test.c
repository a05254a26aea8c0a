/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Local Newton windows (multigrid/local_newton.h): a solution perturbed at
 * single nodes is restored. */
#include <math.h>
#include <stdlib.h>

#include "multigrid/local_newton.h"
#include "overroll/case.h"
#include "simulation/internal.h"
#include "support/test.h"

static const char contact[] = "[contact]\nM = 100\nL = 10\n"
                              "[domain]\ninlet = -4\noutlet = 1.5\nlevel = 8\n"
                              "order = 2\n";
static const char slides[] =
    "[contact]\nload = 1e5 N/m\nradius = 10 mm\nmodulus = 226 GPa\n"
    "mean_speed = 2 m/s\nslide_to_roll = 0.1\n"
    "[lubricant]\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\n"
    "rheology = eyring\neyring_stress = 5 MPa\n"
    "[domain]\ninlet = -4\noutlet = 1.5\nlevel = 8\norder = 2\n";

typedef struct solved {
    ovr_case *c;
    ovr_setup *setup;
    ovr_simulation *sim;
    size_t n;
    double *P;
} solved;

static void solve(solved *s, const char *text, const char *more)
{
    char all[800];
    ovr_error err = {0};
    snprintf(all, sizeof all, "%s%s", text, more);
    s->c = ovr_case_read_text(all, "spot.ini", NULL, NULL, &err);
    s->setup = s->c ? ovr_case_resolve(s->c, NULL, &err) : NULL;
    CHECK_OK(s->setup ? OVR_OK : OVR_BAD_INPUT, &err);
    s->sim = ovr_setup_simulation(s->setup, NULL, &err);
    CHECK_OK(s->sim ? OVR_OK : OVR_BAD_INPUT, &err);
    CHECK_OK(ovr_simulation_steady(s->sim, &err), &err);
    s->n = s->sim->finest->grid.n;
    s->P = malloc(s->n * sizeof *s->P);
    assert_non_null(s->P);
    ovr_level_read(&s->sim->grids, s->sim->finest, s->sim->finest->f.P, s->P);
}

static void let_go(solved *s)
{
    free(s->P);
    ovr_simulation_free(s->sim);
    ovr_setup_free(s->setup);
    ovr_case_free(s->c);
}

static double *node(const solved *s, size_t i)
{
    const ovr_level *level = s->sim->finest;
    return &level->f.P[ovr_lanes_place(&level->lanes, i)];
}

static double imbalance(const solved *s)
{
    return ovr_level_imbalance(&s->sim->grids, s->sim->finest);
}

/* The last node of the flank behind the spike, where oil flows. */
static size_t flank(const solved *s)
{
    size_t i = s->n - 1;
    while (s->P[i] < 0.1)
        i--;
    return i;
}

/* The largest distance from the solution, of P. */
static double off(const solved *s)
{
    double maximum = 0;
    for (size_t i = 0; i < s->n - 1; i++)
        maximum = fmax(maximum, fabs(*node(s, i) - s->P[i]));
    return maximum;
}

/* Newton's method in windows stops at steps of 0.03, whose squares are 1e-3;
 * R falls by as much. */
static void comes_back(const char *text, const char *more)
{
    solved s;
    solve(&s, text, more);
    size_t i = flank(&s);
    for (int d = -5; d <= 5; d++)
        *node(&s, (size_t)((int)i + d)) += 0.2 * exp(-d * d / 2.0);
    ovr_level_refresh(&s.sim->grids, s.sim->finest);
    double before = imbalance(&s);
    assert_true(ovr_local_newton(&s.sim->grids, s.sim->finest));
    assert_true(off(&s) < 3e-3);
    assert_true(imbalance(&s) < 0.03 * before);
    let_go(&s);
}

TEST(newtonian)
{
    comes_back(contact, "");
}

TEST(thinning)
{
    comes_back(slides, "");
}

TEST(hot)
{
    comes_back(slides, "[heat]\nmodel = lobatto\ntemperature = 60 degC\n");
}

TEST(conserved)
{
    comes_back(contact, "[cavitation]\nmodel = conserving\n");
}

/* What is solved stays, to the bit. */
TEST(leaves_solutions)
{
    solved s;
    solve(&s, contact, "");
    assert_false(ovr_local_newton(&s.sim->grids, s.sim->finest));
    assert_true(off(&s) == 0);
    let_go(&s);
}

/* Neither crossed surfaces nor numbers that are none lead outside the film. */
TEST(survives_random_bytes)
{
    static const double worst[] = {-1e3, 1e3, 1e300, INFINITY, NAN};
    for (size_t k = 0; k < sizeof worst / sizeof *worst; k++) {
        solved s;
        solve(&s, contact, "");
        for (size_t i = 20; i < s.n - 20; i += 31)
            *node(&s, i) += worst[k];
        ovr_level_refresh(&s.sim->grids, s.sim->finest);
        ovr_local_newton(&s.sim->grids, s.sim->finest);
        let_go(&s);
    }
}
