/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses from the pressure stored in a result file. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "overroll/run.h"
#include "physics/stress/stress.h"
#include "results/results.h"
#include "run/unpack.h"
#include "stress/stress.h"

struct ovr_stored_stress {
    ovr_arena arena;
    ovr_case *c;
    ovr_setup *setup;
    ovr_stress_report *report[2];
    double every; /* distance between two snapshots relative to that of a step
                   */
};

/* The stored snapshots: nodes, and the maximum distance moved between two of
 * them. */
typedef struct stored {
    const char *path;
    ovr_result *result;
    size_t nodes, snapshots;
    double *x, *T, *P, *Q;
    double mesh, longest;
    bool unresolved;
} stored;

static ovr_status read_axes(stored *f, ovr_arena *arena, ovr_error *err)
{
    const ovr_result_info *info = ovr_result_get_info(f->result);
    f->nodes = info->nodes;
    f->snapshots = info->snapshots;
    f->x = ovr_arena_take(arena, f->nodes, sizeof *f->x, err);
    f->P = ovr_arena_take(arena, f->nodes, sizeof *f->P, err);
    f->Q = ovr_arena_take(arena, f->nodes, sizeof *f->Q, err);
    f->T = ovr_arena_take(arena, f->snapshots + 1, sizeof *f->T, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    if (f->nodes < 3 || f->snapshots < 1)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: contains no snapshot of the pressure; run the "
                        "case with pressure in output.fields",
                        f->path);
    if (ovr_result_unresolved(f->result, arena, &f->unresolved, err))
        return OVR_BAD_INPUT;
    if (ovr_result_x(f->result, OVR_HERTZIAN, f->x, err) ||
        ovr_result_times(f->result, OVR_HERTZIAN, f->T, err))
        return OVR_BAD_INPUT;
    f->mesh = (f->x[f->nodes - 1] - f->x[0]) / (double)(f->nodes - 1);
    if (fabs(f->x[1] - f->x[0] - f->mesh) > 1e-6 * f->mesh)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: its nodes are not equidistant (domain.refine); "
                        "stresses need a run without patches",
                        f->path);
    if (f->x[0] > -1.05 || f->x[f->nodes - 1] < 1.05)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: contains X from %g to %g only; stresses need "
                        "the pressure of the whole contact",
                        f->path, f->x[0], f->x[f->nodes - 1]);
    for (size_t k = 1; k < f->snapshots; k++)
        f->longest = fmax(f->longest, f->T[k] - f->T[k - 1]);
    return OVR_OK;
}

static ovr_status follow(stored *f, const ovr_setup *setup,
                         const ovr_stress_plan *plan, ovr_material_history *p,
                         ovr_error *err)
{
    const double *Q = plan->options.traction ? f->Q : NULL;
    for (size_t k = 0; k < f->snapshots; k++) {
        ovr_moment m = ovr_stress_moment(setup, plan, f->T[k],
                                         f->T[k ? k - 1 : 0]);
        if (ovr_result_snapshot(f->result, "pressure", k, OVR_HERTZIAN, f->P,
                                err) ||
            ovr_traction_stored(plan, f->result, k, f->Q, err))
            return OVR_BAD_INPUT;
        if (k == 0)
            ovr_material_history_begin(p, f->P, Q, &m);
        else
            ovr_material_history_step(p, f->P, Q, &m);
        if (k + 1 == f->snapshots)
            ovr_material_history_end(p, f->P, Q, &m);
    }
    return OVR_OK;
}

/* If the file does not contain the shear stress, stresses are computed without
 * traction, unless the case requires it. */
static ovr_status check_traction(const stored *f, const ovr_setup *setup,
                                 ovr_stress_plan *plan, ovr_error *err)
{
    if (!plan->options.traction || ovr_traction_is_stored(plan, f->result))
        return OVR_OK;
    if (ovr_setup_stress(setup)->loads == OVR_TRACTION_YES)
        return ovr_fail_about(err, "traction",
                              "traction = yes: %s contains no "
                              "shear_stress_%d; add it to output.fields and "
                              "run the case again",
                              f->path, plan->surface);
    plan->options.traction = false;
    plan->no_traction = plan->surface == 1 ? "the file contains no "
                                             "shear_stress_1"
                                           : "the file contains no "
                                             "shear_stress_2";
    return OVR_OK;
}

static ovr_status one_surface(ovr_stored_stress *s, stored *f, int k,
                              ovr_error *err)
{
    ovr_stress_plan plan;
    const ovr_stress_source of = {s->setup, f->path, f->unresolved};
    ovr_material_history *p;
    ovr_stress_sight seen = {f->x[0], f->mesh, f->nodes, s->every};
    ovr_status status = ovr_stress_planned(s->setup, k + 1, seen, &plan, err);
    if (!status)
        status = check_traction(f, s->setup, &plan, err);
    if (status)
        return status;
    p = ovr_material_history_create(&plan.options, &plan.range, NULL, err);
    if (!p)
        return OVR_NO_MEMORY;
    status = follow(f, s->setup, &plan, p, err);
    if (!status)
        s->report[k] = ovr_stress_report_make(&of, &plan, p, &s->arena, err);
    ovr_material_history_free(p);
    return status ? status : s->report[k] ? OVR_OK : OVR_BAD_INPUT;
}

static ovr_status set_up(ovr_stored_stress *s,
                         ovr_status (*change)(void *data, ovr_case *c,
                                              ovr_error *err),
                         void *data, ovr_error *err)
{
    if (change && change(data, s->c, err))
        return OVR_BAD_INPUT;
    s->setup = ovr_case_resolve(s->c, NULL, err);
    if (s->setup && !ovr_setup_stress(s->setup)->surfaces) {
        ovr_setup_free(s->setup);
        s->setup = NULL;
        if (ovr_case_set(s->c, "stress.surface", "1", "overroll stress", err))
            return OVR_BAD_INPUT;
        s->setup = ovr_case_resolve(s->c, NULL, err);
    }
    if (!s->setup || ovr_setup_prepare(s->setup, NULL, err))
        return OVR_BAD_INPUT;
    return OVR_OK;
}

/* Reads profiles and other inputs from the result file if it holds them. */
static ovr_status read_case(ovr_stored_stress *s, const stored *f,
                            ovr_status (*change)(void *data, ovr_case *c,
                                                 ovr_error *err),
                            void *data, ovr_error *err)
{
    const char *text = ovr_result_get_info(f->result)->case_text;
    ovr_lent lent;
    s->c = ovr_case_read_stored(text, f->path, NULL, NULL, err);
    if (!s->c)
        return OVR_BAD_INPUT;
    ovr_status status = ovr_inputs_lend(f->result, f->path, s->c, &lent, err);
    if (!status)
        status = set_up(s, change, data, err);
    ovr_inputs_remove(&lent);
    return status;
}

static ovr_status work(ovr_stored_stress *s, stored *f,
                       ovr_status (*change)(void *data, ovr_case *c,
                                            ovr_error *err),
                       void *data, ovr_error *err)
{
    double dT;
    ovr_status status = read_axes(f, &s->arena, err);
    if (!status)
        status = read_case(s, f, change, data, err);
    if (status)
        return status;
    dT = ovr_setup_step(s->setup);
    s->every = f->longest > 0 ? f->longest / dT : 1;
    for (int k = 0; !status && k < 2; k++)
        if (ovr_setup_stress(s->setup)->surfaces >> k & 1)
            status = one_surface(s, f, k, err);
    return status;
}

ovr_stored_stress *ovr_stored_stress_create(
    const char *path,
    ovr_status (*change)(void *data, ovr_case *c, ovr_error *err), void *data,
    ovr_error *err)
{
    if (!path)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_stored_stress *s = ovr_arena_take(&arena, 1, sizeof *s, err);
    stored f = {.path = path};
    if (!s)
        return NULL;
    s->arena = arena;
    f.result = ovr_result_open(path, NULL, err);
    if (!f.result || work(s, &f, change, data, err)) {
        ovr_result_close(f.result);
        ovr_stored_stress_free(s);
        return NULL;
    }
    ovr_result_close(f.result);
    return s;
}

const ovr_stress_report *ovr_stored_stress_report(const ovr_stored_stress *s,
                                                  int surface)
{
    if (!s)
        return NULL;
    return surface == 1 || surface == 2 ? s->report[surface - 1] : NULL;
}

const ovr_setup *ovr_stored_stress_setup(const ovr_stored_stress *s)
{
    return s ? s->setup : NULL;
}

void ovr_stored_stress_free(ovr_stored_stress *s)
{
    if (!s)
        return;
    ovr_setup_free(s->setup);
    ovr_case_free(s->c);
    ovr_arena arena = s->arena;
    ovr_arena_release(&arena);
}
