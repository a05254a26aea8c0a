/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The stresses below each snapshot, for the page: values at columns along x and
 * at depths that grow geometrically from D, with the scale of the whole run,
 * the largest value of a smooth contact, and where the largest of each is.
 */
#include "pictures/view_run.h"

#include <math.h>
#include <string.h>

#include "pictures/depth_field.h"
#include "pictures/pack_levels.h"
#include "stress/layered.h"

enum { ROWS = 40, MAX_COLUMNS = 180, MIN_COLUMNS = 60 };
enum { MAX_VALUES = 2000000, STEPS = 1000 };

static const double DEEPEST = 2.5;

typedef struct sheet {
    ovr_depth_field field;
    size_t columns, shots, every;
    double *worst, z[ROWS];
    uint16_t *level;
    ovr_levels levels;
} sheet;

static ovr_status prepare(sheet *s, ovr_arena *arena, ovr_error *err)
{
    size_t maximum = MAX_VALUES / ROWS / s->shots;
    s->columns = maximum > MAX_COLUMNS   ? MAX_COLUMNS
                 : maximum < MIN_COLUMNS ? MIN_COLUMNS
                                         : maximum;
    for (int r = 0; r < ROWS; r++)
        s->z[r] = s->field.mesh *
                  pow(DEEPEST / s->field.mesh, (double)r / (ROWS - 1));
    /* levels fine beside the colours, and far beyond them */
    s->levels = ovr_levels_even(0, 1);
    s->levels.step = s->field.high / STEPS;
    s->levels.from = -s->levels.step * OVR_PACKED_LEVELS / 2;
    s->worst = ovr_arena_take(arena, 3 * s->shots, sizeof *s->worst, err);
    s->level = ovr_arena_take(arena, ROWS * s->columns * s->shots,
                              sizeof *s->level, err);
    return s->worst && s->level ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status fill(sheet *s, size_t shot, ovr_error *err)
{
    ovr_depth_field *f = &s->field;
    uint16_t *level = s->level + shot * ROWS * s->columns;
    double *worst = s->worst + 3 * shot;
    if (ovr_depth_field_solve(f, shot * s->every, err))
        return OVR_BAD_INPUT;
    worst[0] = f->worst.X, worst[1] = f->worst.Z, worst[2] = f->worst.value;
    for (size_t r = 0; r < ROWS; r++)
        for (size_t c = 0; c < s->columns; c++) {
            double part = (double)c / (double)(s->columns - 1);
            double X = f->x_from + part * (f->x_to - f->x_from);
            double v = ovr_depth_field_at(f, X, s->z[r]);
            level[r * s->columns + c] = ovr_level_of(&s->levels, v);
        }
    return OVR_OK;
}

/* Depths of the interfaces, where the body has layers. */
static void put_layers(ovr_text *to, const ovr_layered *body)
{
    double bottom[OVR_LAYERS_MAX];
    for (int j = 0; j < body->layers; j++)
        bottom[j] = ovr_layered_bottom(body, j);
    if (body->layers)
        ovr_text_doubles(to, "layers", bottom, (size_t)body->layers);
}

static ovr_status put(ovr_text *to, const sheet *s, ovr_arena *arena,
                      ovr_error *err)
{
    const ovr_depth_field *f = &s->field;
    bool both = f->which == OVR_STRESS_TAU_XZ;
    bool pressed = ovr_depth_field_is_pressed(f);
    ovr_status status;
    ovr_text_print(to,
                   "\"stress\":{\"name\":\"%s\",\"columns\":%zu,\"rows\":%d,"
                   "\"x0\":%.17g,\"x1\":%.17g,\"low\":%.17g,\"high\":%.17g,"
                   "\"smooth\":%.17g,\"least\":%.17g,",
                   f->name, s->columns, ROWS, f->x_from, f->x_to,
                   both || pressed ? -f->high : 0, pressed ? 0 : f->high,
                   f->smooth, f->minimum);
    ovr_text_doubles(to, "z", s->z, ROWS);
    ovr_text_doubles(to, "worst", s->worst, 3 * s->shots);
    put_layers(to, &f->coated.body);
    ovr_text_print(to,
                   "\"levels\":%d,\"from\":%.17g,\"step\":%.17g,\"bend\":0,"
                   "\"data\":\"",
                   OVR_PACKED_LEVELS, s->levels.from, s->levels.step);
    status = ovr_pack_levels(to, s->level, ROWS * s->columns, s->shots, arena,
                             err);
    ovr_text_put(to, "\"},");
    return status;
}

ovr_status ovr_view_stress(const ovr_view_run *view, ovr_error *err)
{
    sheet s = {.shots = view->shots, .every = view->every};
    const ovr_depth_look look = {view->stress, false, 1, -1.8, 1.5};
    ovr_status status = ovr_depth_field_make(&s.field, view->run, &look,
                                             view->arena, err);
    if (!status)
        status = prepare(&s, view->arena, err);
    for (size_t k = 0; !status && k < s.shots; k++)
        status = fill(&s, k, err);
    if (!status)
        status = put(view->to, &s, view->arena, err);
    ovr_depth_field_free(&s.field);
    return status;
}
