/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of snapshots: selected times, their data and the chart. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "pictures/picture.h"
#include "pictures/snapshot.h"

enum { CHOSEN = 4 };

/* Returns the position of the roughness: its mean position weighted with S^4,
 * so that a dent outweighs surrounding texture; NAN for a smooth surface. */
static double centre_of(const ovr_snapshot *snapshot)
{
    double sum = 0, moment = 0;
    for (size_t i = 0; snapshot->S && i < snapshot->run->info->nodes; i++) {
        double weight = pow(snapshot->S[i], 4);
        sum += weight;
        moment += weight * snapshot->run->x[i];
    }
    return sum > 0 ? moment / sum : NAN;
}

/* Times of maximum pressure and minimum film thickness over all results, and
 * the results' names. */
typedef struct extremes {
    double P, H;
    double T_P, T_H; /* NAN: field not stored */
    const char *name_P, *name_H;
} extremes;

static void note_extremes(extremes *e, const ovr_snapshot *snapshot)
{
    for (size_t i = 0; i < snapshot->run->info->nodes; i++) {
        if (snapshot->P && snapshot->P[i] > e->P)
            e->P = snapshot->P[i], e->T_P = snapshot->T,
            e->name_P = snapshot->run->name;
        if (snapshot->H && snapshot->H[i] < e->H)
            e->H = snapshot->H[i], e->T_H = snapshot->T,
            e->name_H = snapshot->run->name;
    }
}

/* Chooses times at which the features are upstream of the contact, twice within
 * it, and at its outlet; equally spaced times if they do not pass it. */
static ovr_status choose_passage(const ovr_stored *run, ovr_snapshot *snapshot,
                                 double *times, extremes *e, ovr_error *err)
{
    static const double target[CHOSEN] = {-1.1, -0.5, 0.15, 0.8};
    double best[CHOSEN] = {INFINITY, INFINITY, INFINITY, INFINITY};
    size_t found[CHOSEN] = {0}, last = run->info->snapshots - 1;
    for (size_t k = 0; k <= last; k++) {
        ovr_status status = ovr_snapshot_read(snapshot, k, err);
        double centre = status == OVR_OK ? centre_of(snapshot) : NAN;
        if (status != OVR_OK)
            return status;
        note_extremes(e, snapshot);
        for (int j = 0; j < CHOSEN; j++)
            if (fabs(centre - target[j]) < best[j]) {
                best[j] = fabs(centre - target[j]);
                found[j] = k;
            }
    }
    bool passes = last >= CHOSEN;
    for (int j = 0; j < CHOSEN; j++)
        passes &= best[j] <= 0.2 && (j == 0 || found[j] > found[j - 1]);
    for (size_t j = 0; j < CHOSEN; j++)
        times[j] = run->times[passes          ? found[j]
                              : last < CHOSEN ? (j < last ? j : last)
                                              : last * (j + 1) / CHOSEN];
    return OVR_OK;
}

static ovr_status scan_snapshots(const ovr_drawing *drawing, double *times,
                                 extremes *e, ovr_error *err)
{
    ovr_status status = OVR_OK;
    *e = (extremes){-INFINITY, INFINITY, NAN, NAN, "", ""};
    for (size_t j = 0; status == OVR_OK && j < drawing->count; j++) {
        const ovr_stored *run = &drawing->runs[j];
        ovr_snapshot snapshot;
        status = ovr_snapshot_make(&snapshot, run, drawing->arena, err);
        if (status == OVR_OK && j == 0)
            status = choose_passage(run, &snapshot, times, e, err);
        for (size_t k = 0; status == OVR_OK && j && k < run->info->snapshots;
             k++) {
            status = ovr_snapshot_read(&snapshot, k, err);
            if (status == OVR_OK)
                note_extremes(e, &snapshot);
        }
    }
    return status;
}

/* Replaces the nearest time that is not `kept` by T. */
static void replace_nearest(double *times, double T, double kept)
{
    size_t best = CHOSEN;
    for (size_t j = 0; j < CHOSEN; j++) {
        if (times[j] == T)
            return;
        if (times[j] != kept &&
            (best == CHOSEN || fabs(times[j] - T) < fabs(times[best] - T)))
            best = j;
    }
    if (best < CHOSEN && !isnan(T))
        times[best] = T;
}

static int in_time(const void *a, const void *b)
{
    double s = *(const double *)a, t = *(const double *)b;
    return (s > t) - (s < t);
}

/* Returns the extreme at T as text, ": p max", with the result's name if there
 * are several. */
static const char *extreme_at(const ovr_drawing *drawing, const extremes *e,
                              double T, ovr_error *err)
{
    const bool is[] = {T == e->T_P, T == e->T_H};
    const char *const what[] = {"p max", "h min"};
    const char *const name[] = {e->name_P, e->name_H};
    bool several = drawing->count > 1;
    char text[160] = "";
    for (int k = 0; k < 2; k++)
        if (is[k])
            snprintf(text + strlen(text), sizeof text - strlen(text),
                     "%s %s%s%.40s", *text ? "," : ":", what[k],
                     several ? " of " : "", several ? name[k] : "");
    return ovr_arena_text(drawing->arena, text, err);
}

/* Chooses up to four times, fewer if several results share the picture,
 * starting with the maximum pressure. */
static ovr_status choose(const ovr_drawing *drawing, double *times,
                         const char **about, size_t *count, ovr_error *err)
{
    size_t fit = OVR_SNAPSHOTS / drawing->count, n = 0;
    size_t capacity = fit < 1 ? 1 : fit < CHOSEN ? fit : CHOSEN;
    extremes e;
    ovr_status status = scan_snapshots(drawing, times, &e, err);
    if (status != OVR_OK)
        return status;
    replace_nearest(times, e.T_P, e.T_P);
    replace_nearest(times, e.T_H, e.T_P);
    if (capacity < CHOSEN) { /* only the extremes, as far as they fit */
        times[0] = isnan(e.T_P) ? e.T_H : e.T_P;
        times[1] = isnan(e.T_H) ? e.T_P : e.T_H;
        for (int j = 0; j < 2; j++)
            if (isnan(times[j]))
                times[j] = times[CHOSEN - 1];
    }
    qsort(times, capacity, sizeof *times, in_time);
    for (size_t k = 0; k < capacity; k++) {
        if (n > 0 && times[k] == times[n - 1])
            continue;
        times[n] = times[k];
        about[n] = extreme_at(drawing, &e, times[n], err);
        if (!about[n++])
            return OVR_NO_MEMORY;
    }
    *count = n;
    return OVR_OK;
}

static ovr_status read_snapshots(const ovr_drawing *drawing,
                                 const double *times, size_t count,
                                 ovr_snapshot *snapshots, ovr_extent *extent,
                                 ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (size_t k = 0; status == OVR_OK && k < count * drawing->count; k++) {
        const ovr_stored *run = &drawing->runs[k % drawing->count];
        status = ovr_snapshot_make(&snapshots[k], run, drawing->arena, err);
        if (status == OVR_OK)
            status = ovr_snapshot_read(
                &snapshots[k],
                ovr_stored_nearest(run, times[k / drawing->count]), err);
        if (status == OVR_OK)
            ovr_extent_add(extent, &snapshots[k]);
    }
    return status;
}

ovr_status ovr_draw_snapshots(const ovr_drawing *drawing, ovr_chart *chart,
                              ovr_error *err)
{
    const ovr_picture_options *o = drawing->options;
    ovr_extent extent = ovr_extent_make(o->x_from, o->x_to, drawing->runs,
                                        drawing->count);
    double chosen[CHOSEN];
    const char *about[OVR_SNAPSHOTS] = {"", "", "", "", "", "", "", ""};
    const double *times = o->time_count ? o->times : chosen;
    size_t count = o->time_count;
    ovr_snapshot snapshots[OVR_SNAPSHOTS];
    ovr_snapshot_chart *to = ovr_arena_take(drawing->arena, 1, sizeof *to, err);
    ovr_snapshot_style *look = ovr_arena_take(drawing->arena, 1, sizeof *look,
                                              err);
    ovr_status status = to && look ? OVR_OK : OVR_NO_MEMORY;
    if (status == OVR_OK && count == 0)
        status = choose(drawing, chosen, about, &count, err);
    if (status == OVR_OK && count * drawing->count > OVR_SNAPSHOTS)
        status = ovr_fail(err, OVR_BAD_INPUT,
                          "a picture shows at most %d snapshots; %zu times "
                          "of %zu results were requested",
                          OVR_SNAPSHOTS, count, drawing->count);
    if (status == OVR_OK)
        status = read_snapshots(drawing, times, count, snapshots, &extent, err);
    if (status == OVR_OK)
        status = ovr_snapshot_style_make(look, o, &extent, drawing->runs,
                                         drawing->count, err);
    if (status == OVR_OK) {
        ovr_snapshot_draw(to, look, snapshots, count, drawing->count, about);
        *chart = to->chart;
    }
    return status;
}
