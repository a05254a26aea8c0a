/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/kernels.h"

#include <math.h>
#include <string.h>

#include "multigrid/field.h"
#include "multigrid/flow.h"
#include "support/contact.h"
#include "support/test.h"

enum { BAND = 6, ARRAYS = OVR_FIELD_COUNT + BAND };

const ovr_kernels *test_kernels(int k)
{
    static const char *const names[] = {"plain", "base", "avx2", "avx512"};
    for (int i = 0; i < 4; i++) {
        const ovr_kernels *here = ovr_kernels_choose(names[i]);
        if (here && k-- == 0)
            return here;
    }
    return NULL;
}

static double *take(test_grid *grid)
{
    ovr_error err = {0};
    double *field = ovr_mlmi_field(&grid->mlmi, &grid->arena, &err);
    assert_non_null(field);
    return field;
}

static bool at_half_nodes(ovr_field_memory memory)
{
    return memory == OVR_FLOW || memory == OVR_SENSITIVE;
}

static void take_fields(test_grid *grid)
{
    double *band[BAND];
    ovr_error err = {0};
    for (int k = 0; k < OVR_FIELD_COUNT; k++) {
        ovr_field_memory memory = ovr_field_rows[k].memory;
        if (!at_half_nodes(memory) && memory != OVR_SKEWED &&
            memory != OVR_FLUIDITY)
            grid->f.all[k] = take(grid);
    }
    ovr_fields *f = &grid->f;
    unsigned char **const sets[] = {&f->wet,   &f->held, &f->dried, &f->limited,
                                    &f->spent, &f->left, &f->right};
    for (size_t k = 0; k < sizeof sets / sizeof *sets; k++) {
        *sets[k] = ovr_set(&grid->arena, grid->n, &err);
        assert_non_null(*sets[k]);
    }
    for (int k = 0; k < BAND; k++)
        band[k] = take(grid);
    grid->band = (ovr_band){.b = {band[0], band[1], band[2], band[3], band[4]},
                            .delta = band[5]};
    grid->gap = grid->f.gap;
    grid->w = grid->f.w;
    grid->ordered = take(grid);
}

test_grid test_grid_make(const ovr_kernels *run, size_t n)
{
    ovr_error err;
    test_contact contact = test_contact_make(20, 10);
    double D = 5.5 / (double)(n - 1);
    test_grid grid = {.arena = ovr_arena_make(NULL),
                      .run = run,
                      .n = n,
                      .D = D,
                      .fluid = {.lubricant = contact.lubricant,
                                .lambda = contact.contact.lambda},
                      .weights = {{1.5 / D + 2, -2 / D, 0.5 / D},
                                  {1 / D + 2, -1 / D, 0},
                                  0.5 / (D * D),
                                  .closed = {0}}};
    CHECK_OK(ovr_mlmi_plan(&grid.mlmi, n, (ovr_mlmi_form){10, 10}, &grid.arena,
                           &err),
             &err);
    ovr_mlmi_fill(&grid.mlmi, D, NULL);
    grid.lanes = (ovr_lanes){n, ovr_mlmi_lane(&grid.mlmi, run->lanes),
                             run->lanes};
    take_fields(&grid);
    for (int d = 0; d < 6; d++)
        grid.k[d] = ovr_deformation_kernel(d, D);
    return grid;
}

static void take_half_nodes(test_grid *grid)
{
    for (int k = 0; k < OVR_FIELD_COUNT; k++) {
        ovr_field_memory memory = ovr_field_rows[k].memory;
        if (!grid->f.all[k] && at_half_nodes(memory))
            grid->f.all[k] = take(grid);
    }
}

void test_grid_gap(test_grid *grid)
{
    take_half_nodes(grid);
    grid->fluid.by_gap = true;
}

void test_grid_logarithmic(test_grid *grid)
{
    test_grid_gap(grid);
    grid->f.log_fluidity = take(grid);
    grid->f.log_slope = take(grid);
    grid->fluid.logarithmic = true;
}

void test_grid_thin(test_grid *grid, double Sigma0, double sliding)
{
    take_half_nodes(grid);
    grid->fluid.lubricant.rheology = OVR_EYRING;
    grid->fluid.lubricant.Sigma0 = Sigma0;
    grid->fluid.sliding = sliding;
}

void test_grid_skew(test_grid *grid)
{
    static const double b[] = {1.5, -2, 0.5}, first[] = {1, -1, 0};
    grid->f.skew = take(grid);
    grid->f.skew_by_P = take(grid);
    for (int m = 0; m < 3; m++) {
        grid->weights.skew[m] = b[m] / grid->D;
        grid->weights.skew_first[m] = first[m] / grid->D;
    }
}

void test_grid_film(const test_grid *grid, const ovr_fields *f)
{
    grid->run->film(&grid->fluid, 0, &grid->lanes, grid->gap, grid->w, f);
    ovr_flow_store(grid->run, &grid->fluid, grid->D, &grid->lanes, f);
}

void test_grid_fill(const test_grid *grid, uint64_t seed)
{
    const ovr_fields *f = &grid->f;
    size_t n = grid->n;
    assert_true(grid->lanes.V == 1);
    for (size_t i = 0; i < n; i++) {
        double X = -4 + 5.5 * (double)i / (double)(n - 1);
        double P = X * X < 1 ? sqrt(1 - X * X) : X < 0 ? 0.01 / (X * X) : 0;
        f->P[i] = P > 0 ? P * test_random(&seed, 0.99, 1.01) : 0;
        grid->gap[i] = 0.08 + (X * X > 1 ? 0.4 * (fabs(X) - 1) : 0) +
                       test_random(&seed, 0, 0.001);
        grid->w[i] = 0;
        f->F[i] = test_random(&seed, -1, 1);
    }
    for (size_t i = 0; f->skew && i < n; i++) {
        f->skew[i] = test_random(&seed, -0.9, 2);
        f->skew_by_P[i] = test_random(&seed, 0, 0.5);
    }
    f->P[0] = f->P[n - 1] = 0;
    test_grid_film(grid, f);
    grid->run->residual(&grid->lanes, &grid->weights, f);
    grid->run->phase(&grid->lanes, &grid->weights, f);
}

static void list(const test_grid *g, double *all[ARRAYS])
{
    double *const band[BAND] = {g->band.b[0], g->band.b[1], g->band.b[2],
                                g->band.b[3], g->band.b[4], g->band.delta};
    memcpy(all, g->f.all, sizeof g->f.all);
    memcpy(all + OVR_FIELD_COUNT, band, sizeof band);
}

void test_grid_copy(const test_grid *plain, const test_grid *to)
{
    double *from[ARRAYS], *here[ARRAYS];
    assert_true(plain->lanes.V == 1 && plain->n == to->n);
    list(plain, from);
    list(to, here);
    for (int k = 0; k < ARRAYS; k++)
        if (from[k])
            to->run->pack(&to->lanes, from[k], here[k]);
    to->run->phase(&to->lanes, &to->weights, &to->f);
}

const double *test_grid_read(const test_grid *grid, const double *x)
{
    grid->run->unpack(&grid->lanes, x, grid->ordered);
    return grid->ordered;
}
