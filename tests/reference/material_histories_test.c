/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Complete stress histories of material points for dents compared with an
 * independent sum along the exact paths (stress_truth.h). The cases are those
 * of the reference: inlet at -4, second order, the same scheme. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "overroll/case.h"
#include "reference/stress_truth.h"
#include "stress/stress.h"
#include "support/test.h"

static const char dent[] =
    "[contact]\nM = 20\nL = 10\n"
    "[domain]\nlevel = 8\ninlet = -4\noutlet = 1.5\norder = 2\n"
    "faces = gap\n"
    "[time]\nend = 7.4\nscheme = characteristic\n"
    "[feature dent]\nshape = dent\ndepth = 0.1\nwidth = 0.5\nstart = -4.6\n";

static const char roller[] =
    "[contact]\nload = 300 kN/m\nradius = 8 mm\nmodulus = 226 GPa\n"
    "speed_1 = 3 m/s\nspeed_2 = 3 m/s\n"
    "[lubricant]\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\np0 = 198 MPa\n"
    "z = 0.68\n"
    "[domain]\nlevel = 8\ninlet = -4\noutlet = 1.5\norder = 2\n"
    "faces = gap\n"
    "[time]\nend = 7.4\nscheme = upstream2\n"
    "[feature dent]\nshape = indent\ndepth = 1.5 um\nwidth = 0.6\n"
    "shoulder = 0.25 um\nstart = -5\n";

/* The material history of a case's surface 1 through its run, by the library
 * alone. */
typedef struct followed {
    ovr_material_history *history;
    double T;
} followed;

static ovr_status follow(void *data, const ovr_simulation *sim, ovr_error *err)
{
    followed *f = data;
    const ovr_state *s = ovr_simulation_state(sim);
    ovr_moment m = {s->T, s->T, s->T - f->T, 1, false};
    (void)err;
    if (s->step == 0)
        ovr_material_history_begin(f->history, s->P, NULL, &m);
    else
        ovr_material_history_step(f->history, s->P, NULL, &m);
    f->T = s->T;
    return OVR_OK;
}

static ovr_material_history *history_of(const char *text, double start,
                                        double z, ovr_element element)
{
    ovr_error err;
    ovr_case *c = ovr_case_read_text(text, "test", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    ovr_simulation *sim = setup ? ovr_setup_simulation(setup, NULL, &err)
                                : NULL;
    if (!sim)
        fail_msg("%s", err.message);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_state *s = ovr_simulation_state(sim);
    ovr_stress_options o = ovr_stress_options_default();
    o.mesh = s->D;
    o.inlet = s->X[0];
    o.nodes = s->n;
    o.depth_min = z;
    o.per_octave = 1;
    o.element = element;
    ovr_material_range range = ovr_material_range_default();
    range.reference = start;
    followed f = {ovr_material_history_create(&o, &range, NULL, &err), 0};
    if (!f.history)
        fail_msg("%s", err.message);
    ovr_march march = *setup->march;
    const ovr_observer look = {.observe = follow, .data = &f};
    march.count = 1;
    march.observers = &look;
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
    ovr_moment last = {s->T, s->T, 0, 1, false};
    ovr_material_history_end(f.history, s->P, NULL, &last);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return f.history;
}

static double at(const ovr_material *m, const float *v, double z, double xi)
{
    size_t j = 0;
    while (j + 1 < m->depths && fabs(m->z[j] - z) > 1e-6)
        j++;
    CHECK_NEAR(m->z[j], z, 1e-6);
    double k = (xi - m->start) / m->step, floor_of = floor(k);
    const float *row = v + j * m->points + (size_t)floor_of;
    return (double)row[0] + (k - floor_of) * ((double)row[1] - (double)row[0]);
}

static void compare(const char *text, double start, size_t rows,
                    const double (*truth)[5], ovr_element element,
                    double tolerance)
{
    ovr_material_history *p = history_of(text, start, truth[0][1], element);
    ovr_material m = ovr_material_history_points(p);
    const ovr_measure which[] = {OVR_MEASURE_CIRCLE, OVR_MEASURE_ORTHOGONAL,
                                 OVR_MEASURE_VON_MISES};
    float *v = calloc(m.points * m.depths, sizeof *v);
    double worst = 0;
    assert_non_null(v);
    for (int k = 0; k < 3; k++) {
        ovr_material_history_measure(p, which[k], v, NULL);
        for (size_t r = 0; r < rows; r++) {
            double value = at(&m, v, truth[r][1], truth[r][0]);
            worst = fmax(worst, fabs(value - truth[r][2 + k]));
            CHECK_NEAR(value, truth[r][2 + k], tolerance);
        }
    }
    print_message("worst difference %.1e p_h\n", worst);
    free(v);
    ovr_material_history_free(p);
}

TEST(a_smooth_dent_agrees_with_the_reference)
{
    compare(dent, -4.6, sizeof truth_dent / sizeof *truth_dent, truth_dent,
            OVR_ELEMENT_AUTO, 5e-3);
}

TEST(a_dent_with_shoulders_too)
{
    compare(roller, -5, sizeof truth_roller / sizeof *truth_roller,
            truth_roller, OVR_ELEMENT_AUTO, 5e-3);
}
