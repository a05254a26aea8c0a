/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The group fatigue/surface_N of a result file, with the results of a stress
 * history. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "physics/stress/stress.h"
#include "results/results.h"
#include "stress/stress.h"

/* ---------------------------------------------------------------- numbers */

#define TOLD(part, form, key, member, label, words)                            \
    {                                                                          \
        OVR_STRESS_##part, OVR_FIGURE_##form, key,                             \
            offsetof(ovr_stress_report, member), label, words                  \
    }
#define ROW(part, form, key, member) TOLD(part, form, key, member, NULL, NULL)
static const ovr_stress_figure figures[] = {
    TOLD(BODY, STRESS, "tau_max", max_shear, "maximum shear stress", NULL),
    TOLD(BODY, STRESS, "von_mises_max", von_mises, "maximum von Mises stress",
         NULL),
    TOLD(LAYERS, STRESS, "layer_von_mises_max", layer_von_mises,
         "von Mises stress in a layer", NULL),
    TOLD(LAYERS, STRESS, "interface_shear_max", interface_shear,
         "shear stress at an interface", NULL),
    TOLD(LAYERS, TENSION, "interface_tension_max", interface_tension,
         "tension across an interface", NULL),
    TOLD(LAYERS, TENSION, "surface_tension_max", surface_tension,
         "tension at the surface", NULL),
    TOLD(LAYERS, SHARE, "layer_utilisation", layer_utilisation,
         "layer stress / yield stress", "maximum"),
    TOLD(LAYERS, SHARE, "layer_fatigue", layer_fatigue,
         "layer stress / fatigue limit", "maximum"),
    TOLD(LAYERS, SHARE, "interface_utilisation", interface_utilisation,
         "interface stress / strength", "maximum"),
    ROW(YIELD, PRESSURE, "yield", yield),
    ROW(YIELD, MOMENT, "yield_ratio_max", yield_ratio),
    ROW(YIELD, NUMBER, "yielding_share", yielding_share),
    ROW(YIELD, LENGTH, "yielding_depth", yielding_depth),
    ROW(YIELD, STRIP, "strip_pressure_max", strip),
    ROW(YIELD, NUMBER, "ph_over_first_yield", of_first_yield),
    ROW(YIELD, NUMBER, "ph_over_shakedown", of_shakedown),
    ROW(CIRCLE, NUMBER, "R_max", R_max),
    ROW(CIRCLE, NUMBER, "xi_R_max", xi_R_max),
    ROW(CIRCLE, NUMBER, "Z_R_max", Z_R_max)};

const ovr_stress_figure *ovr_stress_figure_at(size_t k)
{
    return k < sizeof figures / sizeof *figures ? &figures[k] : NULL;
}

/* Returns the value of a number; the position is NAN if the number has none. */
ovr_stress_extreme ovr_stress_figure_of(const ovr_stress_figure *figure,
                                        const ovr_stress_report *report)
{
    ovr_stress_extreme e = {NAN, NAN, NAN, NAN};
    memcpy(&e, (const char *)report + figure->offset,
           figure->form >= OVR_FIGURE_MOMENT ? sizeof e : sizeof e.value);
    return e;
}

/* ------------------------------------------------------------------- file */

typedef struct storage {
    ovr_group group;
    ovr_group_axis axis[2];
    ovr_group_array array[OVR_MEASURES + 8];
    ovr_group_attribute attribute[57];
} storage;

enum { DEPTH, MATERIAL };

static void add_map(storage *s, const char *name, const char *text,
                    ovr_unit_kind kind, const float *values)
{
    s->array[s->group.arrays++] = (ovr_group_array){.name = name,
                                                    .long_name = text,
                                                    .kind = kind,
                                                    .rank = 2,
                                                    .along = {DEPTH, MATERIAL},
                                                    .singles = values};
}

static ovr_group_array *add_line(storage *s, int along, const char *name,
                                 const char *text, ovr_unit_kind kind)
{
    ovr_group_array *a = &s->array[s->group.arrays++];
    *a = (ovr_group_array){.name = name,
                           .long_name = text,
                           .kind = kind,
                           .rank = 1,
                           .along = {along}};
    return a;
}

static void add_number(storage *s, const char *name, double value)
{
    s->attribute[s->group.attributes++] = (ovr_group_attribute){name, NULL,
                                                                value};
}

static void add_text(storage *s, const char *name, const char *text)
{
    s->attribute[s->group.attributes++] = (ovr_group_attribute){name, text,
                                                                NAN};
}

static void add_measures(storage *s, const ovr_stress_report *r)
{
    static const char *const names[OVR_MEASURES][2] = {
        {"circle_radius", "radius of the minimum circumscribed circle of the "
                          "shear stress path"},
        {"orthogonal_amplitude", "half range of the orthogonal shear stress"},
        {"critical_plane_amplitude", "half range of shear stress on the "
                                     "critical plane"},
        {"critical_plane_angle", "angle of the critical plane, degrees"},
        {"max_von_mises", "maximum von Mises stress"},
        {"max_tresca", "maximum shear stress on any plane"},
        {"max_hydrostatic", "largest hydrostatic stress"},
        {"min_hydrostatic", "smallest hydrostatic stress"}};
    for (int m = 0; m < OVR_MEASURES; m++)
        add_map(s, names[m][0], names[m][1],
                m == OVR_MEASURE_ANGLE ? OVR_KIND_NUMBER : OVR_KIND_PRESSURE,
                r->measure[m]);
    add_line(s, DEPTH, "circle_radius_smooth",
             "value in the steady contact at the start", OVR_KIND_PRESSURE)
        ->doubles = r->smooth[OVR_MEASURE_CIRCLE];
    add_line(s, MATERIAL, "complete",
             "flag: stress history not cut by an "
             "end of the run",
             OVR_KIND_FLAG)
        ->flags = r->material.complete;
}

static void add_life(storage *s, const ovr_stress_report *r)
{
    add_map(s, "amplitude", "amplitude of the criterion", OVR_KIND_PRESSURE,
            r->amplitude);
    add_line(s, DEPTH, "amplitude_smooth",
             "value in the steady contact at the start", OVR_KIND_PRESSURE)
        ->doubles = r->amplitude_smooth;
    add_line(s, MATERIAL, "risk",
             "risk per unit length, from the minimum "
             "depth downward",
             OVR_KIND_NUMBER)
        ->doubles = r->risk;
    add_line(s, DEPTH, "equivalent_length",
             "length of smooth raceway with the same risk as the features, "
             "from this depth downward",
             OVR_KIND_LENGTH)
        ->doubles = r->length;
}

static void add_part(storage *s, ovr_stress_part part,
                     const ovr_stress_report *r)
{
    const ovr_stress_figure *figure;
    for (size_t k = 0; (figure = ovr_stress_figure_at(k)); k++)
        if (figure->part == part)
            add_number(s, figure->key, ovr_stress_figure_of(figure, r).value);
}

static void add_attributes(storage *s, const ovr_setup *setup,
                           const ovr_stress_report *r)
{
    const ovr_stress_setup *o = ovr_setup_stress(setup);
    add_text(s, "moving_with", r->surface == 1 ? "surface 1" : "surface 2");
    add_text(s, "reference", r->feature ? r->feature : "");
    add_number(s, "poisson", o->poisson[r->surface - 1]);
    add_number(s, "traction", r->traction ? 1 : 0);
    add_number(s, "residual_x", o->residual_x);
    add_number(s, "residual_y", o->residual_y);
    add_number(s, "least_depth", r->least_depth);
    if (!isnan(r->layer_von_mises.value))
        add_part(s, OVR_STRESS_LAYERS, r);
    if (!isnan(r->yield))
        add_part(s, OVR_STRESS_YIELD, r);
    add_part(s, OVR_STRESS_BODY, r);
    add_part(s, OVR_STRESS_CIRCLE, r);
    if (!r->fatigue)
        return;
    add_text(s, "note",
             "elastic, plane strain; exponents and limit are conventions, "
             "and lengths and lives are valid only from their depth downward");
    add_text(s, "criterion", ovr_criterion_name(o->criterion));
    add_number(s, "alpha", o->alpha);
    add_number(s, "limit", r->limit);
    add_number(s, "limit_pressure", o->limit_pressure);
    add_number(s, "exponent", o->life.exponent);
    add_number(s, "depth_exponent", o->life.depth_exponent);
    add_number(s, "weibull", o->life.weibull);
    add_number(s, "risk_smooth", r->life->smooth_risk);
    add_number(s, "worst_amplitude", r->life->worst_amplitude);
    add_number(s, "worst_xi", r->life->worst_xi);
    add_number(s, "worst_depth", r->life->worst_z);
    add_number(s, "utilisation", r->life->utilisation);
    add_number(s, "used_xi", r->life->used_xi);
    add_number(s, "used_depth", r->life->used_z);
    add_number(s, "raceway", o->raceway);
    add_number(s, "count", o->count);
    add_number(s, "life_ratio", r->ratio);
}

ovr_status ovr_stress_store(ovr_writer *writer, const ovr_setup *setup,
                            const ovr_stress_report *r, ovr_error *err)
{
    storage s = {.group = {.axes = 2}};
    const ovr_material *m = &r->material;
    ovr_arena arena = ovr_arena_make(NULL);
    double *xi = ovr_arena_take(&arena, m->points, sizeof *xi, err);
    ovr_status status = OVR_NO_MEMORY;
    for (size_t k = 0; xi && k < m->points; k++)
        xi[k] = m->start + (double)k * m->step;
    s.group.path = r->surface == 1 ? "fatigue/surface_1" : "fatigue/surface_2";
    s.group.axis = s.axis;
    s.group.array = s.array;
    s.group.attribute = s.attribute;
    s.axis[DEPTH] = (ovr_group_axis){"depth", "depth below the surface",
                                     OVR_KIND_LENGTH, m->depths, m->z};
    s.axis[MATERIAL] = (ovr_group_axis){"material", "position in the material",
                                        OVR_KIND_LENGTH, m->points, xi};
    add_measures(&s, r);
    if (r->fatigue)
        add_life(&s, r);
    add_attributes(&s, setup, r);
    if (xi)
        status = ovr_writer_group(writer, &s.group, false, err);
    ovr_arena_release(&arena);
    return status;
}
