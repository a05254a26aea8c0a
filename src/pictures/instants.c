/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of snapshots: which instants, their data, the chart. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "pictures/picture.h"
#include "pictures/snapshot.h"

enum { CHOSEN = 4 };

/* Where the roughness is: the mean position weighted with S^4, so that a dent
 * outweighs the texture around it; NAN on a smooth surface. */
static double centre_of(const ovr_shot *shot)
{
    double sum = 0, moment = 0;
    for (size_t i = 0; shot->S && i < shot->run->info->nodes; i++) {
        double weight = pow(shot->S[i], 4);
        sum += weight;
        moment += weight * shot->run->x[i];
    }
    return sum > 0 ? moment / sum : NAN;
}

/* Spread over the run, when nothing better is known. */
static void choose_evenly(const ovr_stored *run, size_t *chosen)
{
    size_t last = run->info->snapshots - 1;
    for (size_t k = 0; k < CHOSEN; k++)
        chosen[k] = last * (k + 1) / CHOSEN;
}

/* The snapshots of largest pressure and smallest film. */
typedef struct extremes {
    double P, H;
    size_t at_P, at_H; /* NOWHERE: that field is not stored */
} extremes;

static const size_t NOWHERE = (size_t)-1;

static void note_extremes(extremes *e, const ovr_shot *shot)
{
    for (size_t i = 0; i < shot->run->info->nodes; i++) {
        if (shot->P && shot->P[i] > e->P)
            e->P = shot->P[i], e->at_P = shot->k;
        if (shot->H && shot->H[i] < e->H)
            e->H = shot->H[i], e->at_H = shot->k;
    }
}

/* The snapshots in which what is on the surface stands ahead of the contact,
 * in it twice, and at its exit; evenly when there is no such passage. */
static ovr_status choose_passage(const ovr_stored *run, ovr_shot *shot,
                                 size_t *chosen, extremes *e, ovr_error *err)
{
    static const double wanted[CHOSEN] = {-1.1, -0.5, 0.15, 0.8};
    double best[CHOSEN] = {INFINITY, INFINITY, INFINITY, INFINITY};
    size_t found[CHOSEN] = {0};
    choose_evenly(run, chosen);
    *e = (extremes){-INFINITY, INFINITY, NOWHERE, NOWHERE};
    for (size_t k = 0; k < run->info->snapshots; k++) {
        ovr_status status = ovr_shot_read(shot, k, err);
        double centre = status == OVR_OK ? centre_of(shot) : NAN;
        if (status != OVR_OK)
            return status;
        note_extremes(e, shot);
        for (int j = 0; j < CHOSEN; j++)
            if (fabs(centre - wanted[j]) < best[j]) {
                best[j] = fabs(centre - wanted[j]);
                found[j] = k;
            }
    }
    for (int j = 0; j < CHOSEN; j++)
        if (best[j] > 0.2 || (j > 0 && found[j] <= found[j - 1]))
            return OVR_OK;
    memcpy(chosen, found, sizeof found);
    return OVR_OK;
}

/* Row k takes the place of the nearest one that is not `kept`. */
static void put_among(size_t *chosen, size_t k, size_t kept)
{
    size_t best = CHOSEN;
    for (size_t j = 0; j < CHOSEN; j++) {
        size_t d = chosen[j] > k ? chosen[j] - k : k - chosen[j];
        size_t least = best == CHOSEN     ? 0
                       : chosen[best] > k ? chosen[best] - k
                                          : k - chosen[best];
        if (chosen[j] == k)
            return;
        if (chosen[j] != kept && (best == CHOSEN || d < least))
            best = j;
    }
    if (best < CHOSEN)
        chosen[best] = k;
}

static int in_time(const void *a, const void *b)
{
    size_t j = *(const size_t *)a, k = *(const size_t *)b;
    return (j > k) - (j < k);
}

static const char *what_is_there(const extremes *e, size_t k)
{
    if (k == e->at_P && k == e->at_H)
        return ": p max, h min";
    return k == e->at_P ? ": p max" : k == e->at_H ? ": h min" : "";
}

/* Up to four, fewer where several results share the picture: the largest
 * pressure first. */
static size_t room_for(const ovr_drawing *drawing)
{
    size_t room = OVR_SHOTS / drawing->count;
    return room < 1 ? 1 : room < CHOSEN ? room : CHOSEN;
}

static ovr_status choose(const ovr_drawing *drawing, double *times,
                         const char **about, size_t *count, ovr_error *err)
{
    const ovr_stored *run = drawing->runs;
    size_t chosen[CHOSEN], snapshots = run->info->snapshots,
                           room = room_for(drawing);
    extremes e;
    ovr_shot shot;
    ovr_status status = ovr_shot_make(&shot, run, drawing->arena, err);
    if (status == OVR_OK)
        status = choose_passage(run, &shot, chosen, &e, err);
    if (status != OVR_OK)
        return status;
    if (e.at_P != NOWHERE)
        put_among(chosen, e.at_P, e.at_P);
    if (e.at_H != NOWHERE)
        put_among(chosen, e.at_H, e.at_P);
    if (room < CHOSEN) { /* the extremes alone, as far as there is room */
        chosen[0] = e.at_P != NOWHERE ? e.at_P : e.at_H;
        chosen[1] = e.at_H != NOWHERE ? e.at_H : e.at_P;
        if (chosen[0] == NOWHERE)
            chosen[0] = chosen[1] = snapshots - 1;
    }
    qsort(chosen, room, sizeof *chosen, in_time);
    *count = 0;
    for (size_t k = 0; k < CHOSEN && *count < room; k++) {
        size_t row = snapshots < CHOSEN ? k : chosen[k];
        if (row >= snapshots ||
            (k > 0 && snapshots >= CHOSEN && chosen[k] == chosen[k - 1]))
            continue;
        about[*count] = what_is_there(&e, row);
        times[(*count)++] = run->times[row];
    }
    return OVR_OK;
}

static ovr_status read_shots(const ovr_drawing *drawing, const double *times,
                             size_t count, ovr_shot *shots, ovr_extent *extent,
                             ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (size_t k = 0; status == OVR_OK && k < count * drawing->count; k++) {
        const ovr_stored *run = &drawing->runs[k % drawing->count];
        status = ovr_shot_make(&shots[k], run, drawing->arena, err);
        if (status == OVR_OK)
            status = ovr_shot_read(
                &shots[k], ovr_stored_nearest(run, times[k / drawing->count]),
                err);
        if (status == OVR_OK)
            ovr_extent_add(extent, &shots[k]);
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
    const char *about[OVR_SHOTS] = {"", "", "", "", "", "", "", ""};
    const double *times = o->time_count ? o->times : chosen;
    size_t count = o->time_count;
    ovr_shot shots[OVR_SHOTS];
    ovr_snapshot_chart *to = ovr_arena_take(drawing->arena, 1, sizeof *to, err);
    ovr_snapshot_style *look = ovr_arena_take(drawing->arena, 1, sizeof *look,
                                              err);
    ovr_status status = to && look ? OVR_OK : OVR_NO_MEMORY;
    if (status == OVR_OK && count == 0)
        status = choose(drawing, chosen, about, &count, err);
    if (status == OVR_OK && count * drawing->count > OVR_SHOTS)
        status = ovr_fail(err, OVR_BAD_INPUT,
                          "at most %d snapshots fit into a picture; %zu "
                          "instants of %zu results were asked for",
                          OVR_SHOTS, count, drawing->count);
    if (status == OVR_OK)
        status = read_shots(drawing, times, count, shots, &extent, err);
    if (status == OVR_OK)
        status = ovr_snapshot_style_make(look, o, &extent, drawing->runs,
                                         drawing->count, err);
    if (status == OVR_OK) {
        ovr_snapshot_draw(to, look, shots, count, drawing->count, about);
        *chart = to->chart;
    }
    return status;
}
