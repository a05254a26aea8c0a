/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/deformation.h"

#include "support/test.h"

test_deformation test_deformation_plan(const char *kernels, size_t n, double D,
                                       int order, int range, ovr_arena *arena)
{
    ovr_error err = {0};
    test_deformation d = {.kernels = ovr_kernels_choose(kernels)};
    CHECK_OK(
        ovr_mlmi_plan(&d.plan, n, (ovr_mlmi_form){order, range}, arena, &err),
        &err);
    ovr_mlmi_fill(&d.plan, D, NULL);
    d.lanes = (ovr_lanes){n, ovr_mlmi_lane(&d.plan, d.kernels->lanes),
                          d.kernels->lanes};
    d.P = ovr_mlmi_field(&d.plan, arena, &err);
    d.w = ovr_mlmi_field(&d.plan, arena, &err);
    assert_non_null(d.P);
    assert_non_null(d.w);
    return d;
}

void test_deform(const test_deformation *plan, const double *P, double *w)
{
    plan->kernels->pack(&plan->lanes, P, plan->P);
    plan->kernels->deformation(&plan->plan, plan->P, plan->w);
    plan->kernels->unpack(&plan->lanes, plan->w, w);
}

void test_deform_directly(size_t n, double D, const double *P, double *w)
{
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (size_t j = 0; j < n; j++)
            sum += ovr_deformation_kernel((double)i - (double)j, D) * P[j];
        w[i] = sum;
    }
}
