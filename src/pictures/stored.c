/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/stored.h"
#include "case/case.h"
#include "case/setup.h"
#include "results/results.h"
#include "stress/stress.h"

#include <math.h>
#include <string.h>

static const char *const temperatures[3] = {"temperature_1", "temperature_2",
                                            "temperature_middle"};
static const double ZERO_DEGC = 273.15; /* in K */

/* Reads a column of the history; NULL if it is missing. */
static double *column(ovr_stored *run, const char *path, ovr_arena *arena)
{
    double *v = NULL;
    if (run->info->steps && ovr_result_find(run->result, path))
        v = ovr_arena_take(arena, run->info->steps, sizeof *v, NULL);
    if (v && ovr_result_read(run->result, path, 0, OVR_HERTZIAN, v, NULL))
        return NULL;
    return v;
}

static bool varies(const double *v, size_t n)
{
    for (size_t i = 0; v && i < n; i++)
        if (v[i] != 1)
            return true;
    return false;
}

/* Computes the Hertzian contact of each snapshot: b is proportional to sqrt(w
 * R), p_h to sqrt(w/R). */
static void find_hertz(ovr_stored *run, ovr_arena *arena)
{
    size_t steps = run->info->steps, snapshots = run->info->snapshots, i = 0;
    double *T = column(run, "history/time", arena);
    double *load = column(run, "history/load_ratio", arena);
    double *radius = column(run, "history/radius_ratio", arena);
    if (!T || !load || (!varies(load, steps) && !varies(radius, steps)))
        return;
    double *width = ovr_arena_take(arena, snapshots, sizeof *width, NULL);
    double *P = ovr_arena_take(arena, snapshots, sizeof *P, NULL);
    for (size_t k = 0; width && P && k < snapshots; k++) {
        while (i + 1 < steps && T[i] < run->times[k])
            i++;
        double R = radius ? radius[i] : 1;
        width[k] = sqrt(load[i] * R);
        P[k] = sqrt(load[i] / R);
    }
    run->hertz_width = P ? width : NULL;
    run->hertz_P = width ? P : NULL;
}

/* Returns the remedy for a maximum pressure not resolved by the mesh; a
 * shear-thinning lubricant limits the pressure. */
static const char *remedy(const ovr_stored *run)
{
    ovr_case *c;
    ovr_setup *setup = ovr_stored_setup(run, &c, NULL);
    bool thins = setup && setup->lubricant->rheology != OVR_NEWTONIAN;
    ovr_setup_free(setup);
    ovr_case_free(c);
    return thins ? "use a higher domain.level"
                 : "set lubricant.rheology = eyring";
}

/* Finds the snapshots whose maximum pressure is resolved by the mesh. */
static ovr_status find_resolved(ovr_stored *run, ovr_arena *arena,
                                ovr_error *err)
{
    size_t steps = run->info->steps, snapshots = run->info->snapshots, i = 0;
    bool unresolved;
    ovr_status status = ovr_result_unresolved(run->result, arena, &unresolved,
                                              err);
    if (status || !unresolved)
        return status;
    run->unresolved = remedy(run);
    run->resolved = ovr_arena_take(arena, snapshots + 1, sizeof(bool), err);
    double *T = column(run, "history/time", arena);
    double *flag = column(run, "history/max_pressure_resolved", arena);
    if (!run->resolved || !T || !flag)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < snapshots; k++) {
        while (i + 1 < steps && T[i] < run->times[k])
            i++;
        run->resolved[k] = flag[i] != 0;
    }
    return OVR_OK;
}

/* Counts the flagged steps of the history. */
static ovr_status count_flagged(ovr_stored *run, ovr_arena *arena)
{
    const double *flag = column(run, "history/marked", arena);
    for (size_t k = 0; flag && k < run->info->steps; k++)
        run->flagged += flag[k] > 0;
    return ovr_arena_status(arena);
}

const char *ovr_stored_unresolved(const ovr_stored *run, ptrdiff_t k, double z)
{
    double deepest = ovr_unresolved_depth(run->x[1] - run->x[0]);
    if (!run->unresolved || (k >= 0 && run->resolved[k]) || !(z < deepest))
        return NULL;
    return run->unresolved;
}

double ovr_stored_hertz_width(const ovr_stored *run, size_t k)
{
    return run->hertz_width ? run->hertz_width[k] : 1;
}

double ovr_stored_hertz_pressure(const ovr_stored *run, size_t k)
{
    return run->hertz_P ? run->hertz_P[k] : 1;
}

ovr_status ovr_stored_make(ovr_stored *run, ovr_result *result,
                           const char *name, ovr_arena *arena, ovr_error *err)
{
    const ovr_result_info *info = ovr_result_get_info(result);
    ovr_status status;
    *run = (ovr_stored){.result = result, .info = info, .by = {1, 1, 1, 1}};
    run->name = name ? name : info->title;
    run->x = ovr_arena_take(arena, info->nodes, sizeof *run->x, err);
    run->times = ovr_arena_take(arena, info->snapshots + 1, sizeof *run->times,
                                err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    run->pressure = ovr_result_find(result, "pressure") != NULL;
    run->film = ovr_result_find(result, "film_thickness") != NULL;
    run->touches = ovr_result_find(result, "contact_pressure") != NULL;
    run->filling = run->film && ovr_result_find(result, "filling") != NULL;
    run->roughness = ovr_result_find(result, "roughness") != NULL;
    for (int k = 0; k < 3; k++)
        run->hot[k] = ovr_result_find(result, temperatures[k]) != NULL;
    status = ovr_result_x(result, OVR_HERTZIAN, run->x, err);
    if (status == OVR_OK)
        status = ovr_result_times(result, OVR_HERTZIAN, run->times, err);
    if (status == OVR_OK)
        status = find_resolved(run, arena, err);
    if (status == OVR_OK)
        status = count_flagged(run, arena);
    if (status == OVR_OK)
        find_hertz(run, arena);
    return status;
}

const char *ovr_stored_title(const ovr_stored *runs, size_t count,
                             const char *given)
{
    for (size_t k = 1; !given && k < count; k++)
        if (strcmp(runs[k].info->title, runs->info->title) != 0)
            return "";
    return given ? given : runs->info->title;
}

bool ovr_stored_is_steady(const ovr_stored *run)
{
    const ovr_result_info *info = run->info;
    return info->snapshots == 1 && info->steps <= 1 &&
           strcmp(info->status, "complete") == 0;
}

ovr_status ovr_stored_need_snapshots(const ovr_stored *run, ovr_error *err)
{
    if (run->info->snapshots > 0)
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: contains no snapshot; only its history of %zu steps "
                    "can be drawn and exported",
                    run->name, run->info->steps);
}

ovr_setup *ovr_stored_setup(const ovr_stored *run, ovr_case **c, ovr_error *err)
{
    ovr_setup *setup;
    *c = ovr_case_read_stored(run->info->case_text, "case", NULL, NULL, err);
    setup = *c ? ovr_case_resolve(*c, NULL, err) : NULL;
    if (!setup) {
        ovr_case_free(*c);
        *c = NULL;
    }
    return setup;
}

/* ------------------------------------------------------------ common units */

static bool has_scales(const ovr_result_info *i)
{
    return i->b > 0 && i->height > 0 && i->ph > 0 && i->time > 0 &&
           isfinite(i->b * i->height * i->ph * i->time);
}

ovr_status ovr_common_units(const ovr_stored *runs, size_t count,
                            ovr_units *units, ovr_error *err)
{
    bool any = false, all = true;
    const ovr_stored *without = NULL;
    for (size_t k = 0; k < count; k++) {
        any |= runs[k].info->physical;
        all &= runs[k].info->physical;
        if (!without && !has_scales(runs[k].info))
            without = &runs[k];
    }
    if (*units == OVR_SI && without)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: SI units are not available, because the contact "
                        "has no physical scales",
                        without->name);
    if (*units == OVR_AS_STORED && any && !all)
        *units = without ? OVR_HERTZIAN : OVR_SI;
    return OVR_OK;
}

static void multiply(double *a, size_t n, double by)
{
    for (size_t i = 0; by != 1 && i < n; i++)
        a[i] *= by;
}

void ovr_stored_relate(ovr_stored *runs, size_t count, ovr_units units)
{
    const ovr_result_info *one = runs->info;
    bool physical = units == OVR_SI ||
                    (units == OVR_AS_STORED && one->physical);
    for (size_t k = 1; physical && k < count; k++) {
        const ovr_result_info *own = runs[k].info;
        runs[k].by.x = own->b / one->b;
        runs[k].by.film = own->height / one->height;
        runs[k].by.pressure = own->ph / one->ph;
        runs[k].by.time = own->time / one->time;
        multiply(runs[k].x, own->nodes, runs[k].by.x);
        multiply(runs[k].times, own->snapshots, runs[k].by.time);
    }
}

bool ovr_stored_differs(const ovr_stored *run)
{
    return run->by.x != 1 || run->by.film != 1 || run->by.pressure != 1 ||
           run->by.time != 1;
}

/* --------------------------------------------------------------- snapshots */

ovr_status ovr_snapshot_make(ovr_snapshot *snapshot, const ovr_stored *run,
                             ovr_arena *arena, ovr_error *err)
{
    size_t n = run->info->nodes;
    double *block = ovr_arena_take(arena, 9 * n, sizeof *block, err);
    if (!block)
        return OVR_NO_MEMORY;
    *snapshot = (ovr_snapshot){.run = run};
    snapshot->P = run->pressure ? block : NULL;
    snapshot->H = run->film ? block + n : NULL;
    snapshot->S = run->roughness ? block + 2 * n : NULL;
    snapshot->oil = run->filling ? block + 3 * n : NULL;
    snapshot->hung = block + 4 * n;
    snapshot->wall = block + 5 * n;
    for (size_t k = 0; k < 3; k++)
        snapshot->hot[k] = run->hot[k] ? block + (6 + k) * n : NULL;
    return OVR_OK;
}

static ovr_status read_field(const ovr_snapshot *snapshot, const char *name,
                             double by, double *values, ovr_error *err)
{
    ovr_status status;
    if (!values)
        return OVR_OK;
    status = ovr_result_snapshot(snapshot->run->result, name, snapshot->k,
                                 OVR_HERTZIAN, values, err);
    if (status == OVR_OK)
        multiply(values, snapshot->run->info->nodes, by);
    return status;
}

/* Computes the lubricant on each wall. Lubricant that fills the gap is drawn on
 * the lower wall only, because a line is visible between two areas. */
static void split_lubricant(double H, double *oil, double *hung)
{
    const double full = 1 - 1e-6;
    bool fills = *oil > full;
    *oil *= fills ? H : 0.5 * H;
    *hung = fills ? H : H - *oil;
}

ovr_status ovr_snapshot_read(ovr_snapshot *snapshot, size_t k, ovr_error *err)
{
    ovr_status status;
    snapshot->k = k;
    snapshot->T = snapshot->run->times[k];
    status = read_field(snapshot, "pressure", snapshot->run->by.pressure,
                        snapshot->P, err);
    if (status == OVR_OK)
        status = read_field(snapshot, "film_thickness", snapshot->run->by.film,
                            snapshot->H, err);
    if (status == OVR_OK)
        status = read_field(snapshot, "roughness", snapshot->run->by.film,
                            snapshot->S, err);
    if (status == OVR_OK)
        status = read_field(snapshot, "filling", 1, snapshot->oil, err);
    for (size_t i = 0; snapshot->oil && i < snapshot->run->info->nodes; i++)
        split_lubricant(snapshot->H[i], &snapshot->oil[i], &snapshot->hung[i]);
    for (int j = 0; status == OVR_OK && j < 3; j++) {
        status = read_field(snapshot, temperatures[j], 1, snapshot->hot[j],
                            err);
        for (size_t i = 0; snapshot->hot[j] && i < snapshot->run->info->nodes;
             i++)
            snapshot->hot[j][i] -= ZERO_DEGC;
    }
    return status;
}

size_t ovr_stored_nearest(const ovr_stored *run, double T)
{
    size_t best = 0;
    for (size_t k = 1; k < run->info->snapshots; k++)
        if (fabs(run->times[k] - T) < fabs(run->times[best] - T))
            best = k;
    return best;
}

double *ovr_stored_history(const ovr_stored *run, const char *name, double by,
                           ovr_arena *arena, ovr_error *err)
{
    double *values = ovr_arena_take(arena, run->info->steps, sizeof *values,
                                    err);
    if (values && ovr_result_history(run->result, name, OVR_HERTZIAN, values,
                                     err) != OVR_OK)
        return NULL;
    if (values)
        multiply(values, run->info->steps, by);
    return values;
}

/* ----------------------------------------------------------------- extent */

/* Returns the right end of the picture. If the speed reverses, lubricant enters
 * on both sides, and domain and picture are symmetric. */
static double right_end(const ovr_stored *run)
{
    double last = run->x[run->info->nodes - 1];
    bool both = last > -run->x[0] * (1 - 1e-9);
    return fmin(last, (both ? 2 : 1.5) * run->by.x);
}

ovr_extent ovr_extent_make(double x_from, double x_to, const ovr_stored *runs,
                           size_t count)
{
    ovr_extent e = {.x_from = INFINITY,
                    .x_to = -INFINITY,
                    .hot_low = INFINITY,
                    .hot_high = -INFINITY};
    for (size_t k = 0; k < count; k++) {
        const double *x = runs[k].x, b = runs[k].by.x;
        e.x_from = fmin(e.x_from, fmax(x[0], -2 * b));
        e.x_to = fmax(e.x_to, right_end(&runs[k]));
    }
    if (!isnan(x_from))
        e.x_from = x_from;
    if (!isnan(x_to))
        e.x_to = x_to;
    return e;
}

void ovr_extent_nodes(const ovr_extent *e, const ovr_stored *run, size_t *a,
                      size_t *b)
{
    size_t n = run->info->nodes;
    for (*a = 0; *a + 2 < n && run->x[*a + 1] <= e->x_from;)
        ++*a;
    for (*b = n; *b > *a + 2 && run->x[*b - 2] >= e->x_to;)
        --*b;
}

void ovr_extent_add(ovr_extent *e, const ovr_snapshot *snapshot)
{
    const double *x = snapshot->run->x;
    size_t a, b;
    ovr_extent_nodes(e, snapshot->run, &a, &b);
    for (size_t i = a; i < b; i++) {
        if (snapshot->P)
            e->P_high = fmax(e->P_high, snapshot->P[i]);
        if (snapshot->H && fabs(x[i]) < 0.9 * snapshot->run->by.x)
            e->H_high = fmax(e->H_high, snapshot->H[i]);
        for (int j = 0; j < 3; j++)
            if (snapshot->hot[j]) {
                e->hot_low = fmin(e->hot_low, snapshot->hot[j][i]);
                e->hot_high = fmax(e->hot_high, snapshot->hot[j][i]);
            }
        if (snapshot->S) {
            e->S_low = fmin(e->S_low, snapshot->S[i]);
            e->S_high = fmax(e->S_high, snapshot->S[i]);
        }
    }
}
