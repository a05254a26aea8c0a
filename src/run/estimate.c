/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The discretization error on request: the same case one level coarser.  For a
 * scheme of order p the error of the finer one is (fine - coarse)/(2^p - 1).
 */
#include <math.h>

#include "run/internal.h"
#include "simulation/scheme.h"

/* The coarser run at the time the finer one ended: its steps are twice as
 * long, so two of its steps are kept. */
typedef struct two_steps {
    double T[2], H_min[2], H_cen[2], P_max[2];
} two_steps;

static ovr_status keep(void *data, const ovr_simulation *sim, ovr_error *err)
{
    two_steps *k = data;
    const ovr_observation *o = ovr_simulation_observation(sim);
    (void)err;
    k->T[0] = k->T[1];
    k->H_min[0] = k->H_min[1];
    k->H_cen[0] = k->H_cen[1];
    k->P_max[0] = k->P_max[1];
    k->T[1] = o->T;
    k->H_min[1] = o->H_min_located;
    k->H_cen[1] = o->H_cen;
    k->P_max[1] = o->P_max;
    return OVR_OK;
}

static double at(const two_steps *k, double T, const double v[2])
{
    double span = k->T[1] - k->T[0];
    double s = span > 0 ? (T - k->T[0]) / span : 1;
    return v[0] + s * (v[1] - v[0]);
}

static ovr_status solve(ovr_setup *setup, ovr_simulation *coarse, bool steady,
                        two_steps *kept, ovr_error *err)
{
    ovr_march march = *setup->march;
    ovr_status status = ovr_simulation_steady(coarse, err);
    march.count = 1;
    march.observers = &(ovr_observer){keep, NULL, kept};
    if (!status && !steady)
        return ovr_simulation_march(coarse, &march, err);
    return status ? status : keep(kept, coarse, err);
}

static void compare(const ovr_simulation *fine, const ovr_simulation *coarse,
                    const two_steps *k, ovr_run_errors *e)
{
    const ovr_observation *o = ovr_simulation_observation(fine);
    const ovr_options *options = ovr_simulation_options(coarse);
    int order = ovr_scheme_record(options->scheme)->order;
    double part = 1 / (ldexp(1, order) - 1);
    e->level = options->level;
    e->H_min = part * fabs(o->H_min_located - at(k, o->T, k->H_min));
    e->H_cen = part * fabs(o->H_cen - at(k, o->T, k->H_cen));
    e->P_max = part * fabs(o->P_max - at(k, o->T, k->P_max));
    e->H_min_overall = part * fabs(ovr_simulation_statistics(fine)->H_min -
                                   ovr_simulation_statistics(coarse)->H_min);
}

ovr_status ovr_run_estimate(const ovr_run *run, ovr_run_errors *errors,
                            ovr_error *err)
{
    const ovr_allocator *allocator = &run->arena.allocator;
    ovr_setup *setup = ovr_case_resolve(run->c, allocator, err);
    ovr_simulation *coarse = NULL;
    ovr_status status = OVR_BAD_INPUT;
    two_steps kept = {{0}, {0}, {0}, {0}};
    if (setup) {
        setup->options->level = ovr_simulation_options(run->sim)->level - 1;
        coarse = ovr_setup_simulation(setup, allocator, err);
    }
    if (coarse) {
        ovr_run_surface(run, coarse);
        status = solve(setup, coarse, !run->info.transient, &kept, err);
    }
    if (!status)
        compare(run->sim, coarse, &kept, errors);
    ovr_simulation_free(coarse);
    ovr_setup_free(setup);
    return status;
}
