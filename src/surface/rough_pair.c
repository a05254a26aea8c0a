/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/rough_pair.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "surface/dry_contact.h"
#include "surface/measured.h"
#include "surface/profile.h"
#include "surface/resample.h"

enum { MIN = 256, MAX = 2048, PLACES = 6, A_DECADE = 4, DECADES = 5 };

/* ------------------------------------------------------------------ heights
 */

typedef struct source {
    const ovr_profile *profile;
    ovr_profile *own; /* the same profile, if read for this contact */
    ovr_ends ends;
} source;

static double length_of(const ovr_profile *p)
{
    return p->x[p->view.n - 1] - p->x[0];
}

static ovr_status read(const ovr_feature_form *form, const ovr_contact *contact,
                       const ovr_allocator *allocator, source *s,
                       ovr_error *err)
{
    ovr_conditioning how = ovr_conditioning_default();
    if (form->conditioning &&
        OVR_TAKE(ovr_conditioning, &how, form->conditioning, err))
        return OVR_BAD_INPUT;
    s->profile = s->own = ovr_measured_profile(form, contact, allocator, err);
    s->ends = (ovr_ends){how.taper,
                         how.extend == OVR_EXTEND_MIRROR ? OVR_EXTEND_MIRROR
                                                         : OVR_EXTEND_PERIODIC,
                         true, form->shape == OVR_ROUGHNESS};
    return s->profile ? OVR_OK : err->status;
}

/* Shortens both profiles to the length of the shorter one. Profiles are not
 * treated as closed if one is shortened, or if the ends of the other are
 * blended. */
static void make_alike(source s[2], ovr_rough_pair *pair)
{
    const double rounding = 1e-6;
    double length = INFINITY;
    bool closed = true, mirror = true;
    for (int k = 0; k < 2; k++)
        if (s[k].profile) {
            length = fmin(length, length_of(s[k].profile));
            closed = closed && s[k].ends.closed;
            mirror = mirror && s[k].ends.extend == OVR_EXTEND_MIRROR;
        }
    for (int k = 0; k < 2; k++) {
        ovr_profile *p = s[k].own;
        if (!p)
            continue;
        if (length_of(p) > length * (1 + rounding))
            pair->cut = true;
        while (p->view.n > 2 && length_of(p) > length * (1 + rounding))
            p->view.n--;
        s[k].ends.closed = closed && !pair->cut;
        s[k].ends.extend = mirror ? OVR_EXTEND_MIRROR : OVR_EXTEND_PERIODIC;
    }
}

static size_t nodes_of(const source s[2])
{
    size_t maximum = MIN, n = MIN;
    for (int k = 0; k < 2; k++)
        if (s[k].profile && s[k].profile->view.n > maximum)
            maximum = s[k].profile->view.n;
    while (n < maximum && n < MAX)
        n *= 2;
    return n;
}

/* Adds `part` times the heights that a grid with this mesh size represents. */
static ovr_status add(const source *s, double mesh, double part,
                      ovr_rough_pair *pair, double *z, ovr_error *err)
{
    const ovr_profile *p = s->profile;
    ovr_arena scratch = ovr_arena_make(&p->arena.allocator);
    ovr_table table = {0};
    ovr_points points = {p->view.n, p->x, p->z};
    ovr_status status = ovr_resample(&points, mesh, &s->ends, &table, &scratch,
                                     err);
    if (!status && part > 0)
        pair->length = ovr_table_length(&table);
    for (size_t i = 0; !status && i < pair->n; i++)
        z[i] += part * ovr_table_height(&table, pair->length * (double)i /
                                                    (double)pair->n);
    ovr_arena_release(&scratch);
    return status;
}

/* Samples the heights. If left_by > 0, subtracts the heights that a grid with
 * this mesh size represents. */
static ovr_status sample(const source *s, double left_by, ovr_rough_pair *pair,
                         double *z, ovr_error *err)
{
    double mesh = length_of(s->profile) / (double)pair->n;
    ovr_status status;
    for (size_t i = 0; i < pair->n; i++)
        z[i] = 0;
    pair->length = length_of(s->profile);
    if (left_by > 0 && left_by <= mesh)
        return OVR_OK; /* the grid represents all heights */
    status = add(s, mesh, 1, pair, z, err);
    if (status || left_by == 0)
        return status;
    return add(s, left_by, -1, pair, z, err);
}

/* Shortens a profile so that MAX points suffice for its own spacing, or for an
 * eighth of the mesh size if that is larger. */
static void shorten_to(source *s, double mesh)
{
    ovr_profile *p = s->own;
    size_t n = p->view.n;
    double spacing = length_of(p) / (double)(n - 1);
    double maximum = fmax(spacing, mesh / 8) * MAX;
    while (p->view.n > 2 && length_of(p) > maximum)
        p->view.n--;
    if (p->view.n < n)
        s->ends.closed = false;
}

static ovr_status make(ovr_rough_pair *pair,
                       const ovr_feature_form *const form[2], double left_by,
                       const ovr_contact *contact, ovr_arena *arena,
                       ovr_error *err)
{
    source s[2] = {{0}, {0}};
    ovr_status status = OVR_OK;
    *pair = (ovr_rough_pair){.modulus = 2};
    for (int k = 0; !status && k < 2; k++)
        if (form[k]) {
            status = read(form[k], contact, &arena->allocator, &s[k], err);
            if (!status && left_by > 0)
                shorten_to(&s[k], left_by);
        }
    if (!status) {
        make_alike(s, pair);
        pair->n = left_by > 0 ? MAX : nodes_of(s);
    }
    for (int k = 0; !status && k < 2; k++) {
        if (!s[k].profile)
            continue;
        pair->z[k] = ovr_arena_take(arena, pair->n, sizeof **pair->z, err);
        status = pair->z[k] ? sample(&s[k], left_by, pair, pair->z[k], err)
                            : OVR_NO_MEMORY;
    }
    for (int k = 0; k < 2; k++)
        ovr_profile_free(s[k].own);
    return status;
}

ovr_status ovr_rough_pair_make(ovr_rough_pair *pair,
                               const ovr_feature_form *const form[2],
                               const ovr_contact *contact, ovr_arena *arena,
                               ovr_error *err)
{
    return make(pair, form, 0, contact, arena, err);
}

ovr_status ovr_rough_pair_rest(ovr_rough_pair *pair,
                               const ovr_feature_form *const form[2],
                               double mesh, const ovr_contact *contact,
                               ovr_arena *arena, ovr_error *err)
{
    return make(pair, form, mesh, contact, arena, err);
}

/* Makes the contact of one profile with a smooth surface, in metres and p/E*,
 * or in b, b^2/R and p_h. */
static ovr_status pair_of(ovr_rough_pair *pair, const ovr_profile *profile,
                          ovr_arena *arena, ovr_error *err)
{
    const ovr_profile_view *v = &profile->view;
    source s[2] = {
        {.profile = profile, .ends = {NAN, OVR_EXTEND_PERIODIC, true, false}},
        {0}};
    *pair = (ovr_rough_pair){.modulus = v->scaled_x ? 2 : 1, .n = nodes_of(s)};
    if (v->scaled_x != v->scaled_z)
        return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                           "x and z must both be in metres, or in b and b^2/R, "
                           "for a contact model");
    pair->z[0] = ovr_arena_take(arena, pair->n, sizeof **pair->z, err);
    return pair->z[0] ? sample(&s[0], 0, pair, pair->z[0], err) : OVR_NO_MEMORY;
}

ovr_status ovr_rough_pair_take(ovr_rough_pair *pair, size_t n, double length,
                               const double *const z[2], ovr_arena *arena,
                               ovr_error *err)
{
    *pair = (ovr_rough_pair){.n = n, .length = length, .modulus = 2};
    for (int k = 0; k < 2; k++) {
        if (!z[k])
            continue;
        pair->z[k] = ovr_arena_take(arena, n, sizeof **pair->z, err);
        if (!pair->z[k])
            return OVR_NO_MEMORY;
        memcpy(pair->z[k], z[k], n * sizeof *z[k]);
    }
    return OVR_OK;
}

/* ---------------------------------------------------------------------- law
 */

/* Computes roughness and slope as root sums of squares of both surfaces. */
static void measure(ovr_rough_pair *pair)
{
    size_t n = pair->n;
    double heights = 0, slopes = 0, step = pair->length / (double)n;
    for (int k = 0; k < 2; k++) {
        const double *z = pair->z[k];
        double mean = 0;
        for (size_t i = 0; z && i < n; i++)
            mean += z[i] / (double)n;
        for (size_t i = 0; z && i < n; i++) {
            double rise = (z[(i + 1) % n] - z[i]) / step;
            heights += (z[i] - mean) * (z[i] - mean) / (double)n;
            slopes += rise * rise / (double)n;
        }
    }
    pair->Rq = sqrt(heights);
    pair->slope = sqrt(slopes);
}

static int places_of(const ovr_rough_pair *pair)
{
    return pair->z[0] && pair->z[1] ? PLACES : 1;
}

/* Returns the shift of the second surface, in nodes, for relative position
 * k. */
static size_t place(const ovr_rough_pair *pair, int k)
{
    return places_of(pair) == 1 ? 0
                                : pair->n * (2 * (size_t)k + 1) / (2 * PLACES);
}

static void lay_over(const ovr_rough_pair *pair, size_t shift, double *z)
{
    double mean = 0;
    for (size_t i = 0; i < pair->n; i++) {
        z[i] = pair->z[0] ? pair->z[0][i] : 0;
        if (pair->z[1])
            z[i] += pair->z[1][(i + shift) % pair->n];
        mean += z[i] / (double)pair->n;
    }
    for (size_t i = 0; i < pair->n; i++)
        z[i] -= mean;
}

/* Adds the pressures of one relative position, weighted with `part`, to each
 * surface at its own x. */
static void add_pressures(ovr_rough_pair *pair, size_t j, size_t shift,
                          double part, const double *p)
{
    size_t n = pair->n;
    for (size_t i = 0; i < n; i++) {
        if (pair->z[0])
            pair->pressure[0][j * n + i] += part * p[i];
        if (pair->z[1])
            pair->pressure[1][j * n + (i + shift) % n] += part * p[i];
    }
}

/* Solves for all mean pressures of one relative position, from the highest
 * down. *minimum becomes the first index below which some did not converge. */
static void solve_pressures(ovr_rough_pair *pair, const ovr_dry_contact *dry,
                            int k, double *z, ovr_asperity_table *t,
                            size_t *minimum)
{
    size_t n = pair->n, shift = place(pair, k);
    double part = 1. / places_of(pair), *p = z + n;
    lay_over(pair, shift, z);
    for (size_t i = 0; i < n; i++)
        p[i] = 1;
    for (size_t j = pair->points; j-- > 0;) {
        size_t i = pair->points - 1 - j; /* in the order of increasing gaps */
        ovr_dry_state s = ovr_dry_contact_solve(dry, z, pair->p[j], p);
        if (!s.found && j >= *minimum)
            *minimum = j + 1;
        t->H[i] += part * s.gap;
        t->area[i] += part * s.area;
        add_pressures(pair, j, shift, part, p);
    }
}

ovr_status ovr_rough_pair_reserve(ovr_rough_pair *pair, ovr_asperity_table *t,
                                  ovr_arena *arena, ovr_error *err)
{
    if (pair->p)
        return ovr_arena_status(arena);
    pair->points = A_DECADE * DECADES + A_DECADE / 2;
    pair->p = ovr_arena_take(arena, pair->points, sizeof *pair->p, err);
    pair->workspace = ovr_arena_take(arena, 5 * pair->n,
                                     sizeof *pair->workspace, err);
    ovr_asperity_table_take(t, pair->points, arena, err);
    for (int k = 0; k < 2; k++)
        if (pair->z[k])
            pair->pressure[k] = ovr_arena_take(arena, pair->points * pair->n,
                                               sizeof **pair->pressure, err);
    return ovr_arena_status(arena);
}

static void clear(ovr_rough_pair *pair, ovr_asperity_table *t)
{
    t->n = pair->points;
    memset(t->H, 0, t->n * sizeof *t->H);
    memset(t->area, 0, t->n * sizeof *t->area);
    for (int k = 0; k < 2; k++)
        if (pair->z[k])
            memset(pair->pressure[k], 0,
                   pair->points * pair->n * sizeof *pair->pressure[k]);
}

/* Removes points of full contact, whose gap is zero, and points that did not
 * converge from the table. */
static void drop_invalid(const ovr_rough_pair *pair, size_t lightest,
                         ovr_asperity_table *t)
{
    const double minimum = 1e-3 * pair->Rq;
    size_t kept = 0;
    for (size_t i = 0; i + lightest < pair->points; i++) {
        if (t->H[i] < minimum || (kept && !(t->H[i] > t->H[kept - 1])))
            continue;
        t->H[kept] = t->H[i];
        t->area[kept] = t->area[i];
        t->ln_A[kept++] = log(pair->p[pair->points - 1 - i]);
    }
    t->n = kept;
}

ovr_status ovr_rough_pair_law(ovr_rough_pair *pair, ovr_asperity_table *t,
                              ovr_arena *arena, ovr_error *err)
{
    size_t lightest = 0;
    ovr_status status = ovr_rough_pair_reserve(pair, t, arena, err);
    if (status)
        return status;
    const ovr_dry_contact dry = {.n = pair->n,
                                 .length = pair->length,
                                 .modulus = pair->modulus,
                                 .enough = 1e-6,
                                 .workspace = pair->workspace + 2 * pair->n};
    measure(pair);
    if (!(pair->slope > 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the profiles are smooth; a contact model needs "
                        "roughness");
    clear(pair, t);
    for (size_t j = 0; j < pair->points; j++)
        pair->p[j] = pair->modulus * pair->slope *
                     pow(10, (double)j / A_DECADE - DECADES);
    for (int k = 0; k < places_of(pair); k++)
        solve_pressures(pair, &dry, k, pair->workspace, t, &lightest);
    if (2 * lightest > pair->points)
        return ovr_fail(err, OVR_NOT_CONVERGED,
                        "the dry contact of the profiles did not converge "
                        "below %.3g p_h",
                        pair->p[lightest - 1]);
    drop_invalid(pair, lightest, t);
    ovr_asperity_table_slopes(t);
    return OVR_OK;
}

ovr_status ovr_profile_contact(const ovr_profile *profile, size_t maximum,
                               ovr_dry_point *points, size_t *found,
                               ovr_error *err)
{
    if (!profile || !points || !found)
        return ovr_fail_null(err, __func__);
    ovr_arena arena = ovr_arena_make(&profile->arena.allocator);
    ovr_rough_pair pair;
    ovr_asperity_table t = {0};
    ovr_status status = pair_of(&pair, profile, &arena, err);
    if (!status)
        status = ovr_rough_pair_law(&pair, &t, &arena, err);
    *found = 0;
    for (size_t k = t.n; !status && k-- > 0 && *found < maximum;)
        points[(*found)++] = (ovr_dry_point){exp(t.ln_A[k]), t.H[k], t.area[k]};
    ovr_arena_release(&arena);
    return status;
}

/* --------------------------------------------------------------------- wear
 */

void ovr_rough_pair_weigh(const ovr_rough_pair *pair, double A, double dX,
                          double *w)
{
    const double *p = pair->p;
    size_t last = pair->points - 1, j = 0;
    if (A <= p[0]) {
        w[0] += dX * A / p[0];
        return;
    }
    if (A >= p[last]) {
        w[last] += dX * A / p[last];
        return;
    }
    while (p[j + 1] < A)
        j++;
    double v = (A - p[j]) / (p[j + 1] - p[j]);
    w[j] += dX * (1 - v);
    w[j + 1] += dX * v;
}

static double depth(const ovr_rough_pair *pair, int k, const double *w,
                    size_t i)
{
    double sum = 0;
    for (size_t j = 0; j < pair->points; j++)
        sum += w[j] * pair->pressure[k][j * pair->n + i];
    return sum;
}

void ovr_rough_pair_wear(ovr_rough_pair *pair, const double c[2],
                         const double *w)
{
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; pair->z[k] && c[k] > 0 && i < pair->n; i++)
            pair->z[k][i] -= c[k] * depth(pair, k, w, i);
}

double ovr_rough_pair_deepest(const ovr_rough_pair *pair, const double c[2],
                              const double *w)
{
    double maximum = 0;
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; pair->z[k] && c[k] > 0 && i < pair->n; i++)
            maximum = fmax(maximum, c[k] * depth(pair, k, w, i));
    return maximum;
}
