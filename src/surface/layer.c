/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/layer.h"

#include <math.h>
#include <string.h>

#include "base/arena.h"

struct ovr_layer {
    ovr_arena arena;
    ovr_profile *profile;
    size_t n;
    const double *x, *z;
    double length, height; /* units of x and thickness in b and b^2/R */
    double first;          /* x that enters the contact first */
};

static ovr_status check(const ovr_layer *l, const char *file, ovr_error *err)
{
    if (!isfinite(l->length) || !isfinite(l->height))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%s' is in metres, which needs contact.radius and "
                        "contact.modulus",
                        file);
    for (size_t i = 0; i < l->n; i++)
        if (!(l->z[i] >= 0) || !isfinite(l->z[i]))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "'%s': the thickness %g at x = %g must be 0 or "
                            "more, without gaps",
                            file, l->z[i], l->x[i]);
    return OVR_OK;
}

ovr_layer *ovr_layer_read(const char *file, const ovr_contact *contact,
                          const ovr_allocator *allocator, ovr_error *err)
{
    ovr_profile_source source = ovr_profile_source_default();
    source.file = file;
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_layer *l = ovr_arena_take(&arena, 1, sizeof *l, err);
    if (!l)
        return NULL;
    l->arena = arena;
    l->profile = ovr_profile_read(&source, allocator, err);
    if (l->profile) {
        const ovr_profile_view *view = ovr_profile_get_view(l->profile);
        l->n = view->n;
        l->x = view->x;
        l->z = view->z;
        l->first = l->x[l->n - 1];
        l->length = view->scaled_x ? 1 : 1 / contact->b;
        l->height = view->scaled_z ? 1 : 1 / contact->height;
        if (!check(l, file, err))
            return l;
    }
    ovr_layer_free(l);
    return NULL;
}

ovr_layer *ovr_layer_make(size_t n, const double *x, const double *thickness,
                          double first, const ovr_allocator *allocator,
                          ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_layer *l = ovr_arena_take(&arena, 1, sizeof *l, err);
    double *copy = l ? ovr_arena_take(&arena, 2 * n, sizeof *copy, err) : NULL;
    if (!copy) {
        ovr_arena_release(&arena);
        return NULL;
    }
    memcpy(copy, x, n * sizeof *copy);
    memcpy(copy + n, thickness, n * sizeof *copy);
    *l = (ovr_layer){.arena = arena,
                     .n = n,
                     .x = copy,
                     .z = copy + n,
                     .length = 1,
                     .height = 1,
                     .first = first};
    return l;
}

void ovr_layer_free(ovr_layer *layer)
{
    if (!layer)
        return;
    ovr_arena arena = layer->arena;
    ovr_profile_free(layer->profile);
    ovr_arena_release(&arena);
}

double ovr_layer_thickness(const ovr_layer *l, double travelled)
{
    double x = l->first - travelled / l->length, s;
    size_t low = 0, high = l->n - 1;
    if (x <= l->x[0])
        return l->height * l->z[0];
    if (x >= l->x[high])
        return l->height * l->z[high];
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        *(l->x[middle] <= x ? &low : &high) = middle;
    }
    s = (x - l->x[low]) / (l->x[high] - l->x[low]);
    return l->height * (l->z[low] + s * (l->z[high] - l->z[low]));
}

double ovr_layer_mean(const ovr_layer *l, double travelled, double length)
{
    double x = l->first - travelled / l->length, to = x + length / l->length;
    double before = ovr_layer_thickness(l, travelled), sum = 0;
    for (size_t i = 0; i <= l->n && x < to; i++) {
        double next = i < l->n ? fmin(l->x[i], to) : to;
        if (next <= x)
            continue;
        double h = ovr_layer_thickness(l, (l->first - next) * l->length);
        sum += 0.5 * (before + h) * (next - x);
        x = next;
        before = h;
    }
    return sum * l->length / length;
}
