/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The section [strip].
 *
 * Lines: 4, 5, 6 or 7 times a power of two, so that grids can be halved.  The
 * smoother converges best for mesh sizes across of 1 to 1.6 times that along x
 * and works from 0.9 to 5 (measured at M = 5 to 100).
 */
#include "physics/strip/strip.h"

#include <math.h>
#include <stdio.h>

#include "base/error.h"
#include "base/rows.h"
#include "base/team.h"
#include "multigrid/hierarchy.h"
#include "overroll/surface.h"
#include "simulation/conflicts.h"
#include "strip/across.h"
#include "strip/strip.h"
#include "surface/measured.h"

#define AT(field) offsetof(ovr_strip_form, field)

static const double USUAL_WIDTH = 2, LEAST_RATIO = 0.9, USUAL_RATIO = 1.6,
                    LARGEST_RATIO = 5;

static const ovr_word automatic[] = {{"auto", 0}, {NULL, 0}};
static const ovr_word ends[] = {{"periodic", 1}, {NULL, 0}};

static const ovr_parameter keys[] = {
    {"width", LENGTH_OR(automatic, 0.1, 1e3), "auto", AT(width), true, ALWAYS,
     "period across rolling, after which film and features repeat; auto: that "
     "of the first areal surface, otherwise 2 b"},
    {"lines", WHOLE_OR(automatic, 4, 16384), "auto", AT(lines), true, ALWAYS,
     "lines of nodes across the width, 4, 5, 6 or 7 times a power of two; "
     "auto: a mesh size up to 1.6 times that along x"},
    {"ends", CHOICE(ends), "periodic", AT(ends), true, ALWAYS,
     "periodic: the strip repeats across rolling"},
    {"threads", WHOLE(1, OVR_TEAM_MOST), "1", AT(threads), false, ALWAYS,
     "number of threads for the film; the result is the same to the bit"},
    {"shown", LENGTH(-1e3, 1e3), NULL, AT(shown), false, ALWAYS,
     "Y of the line along x that tables and pictures show; default: centre of "
     "the first feature"},
};

const ovr_section ovr_strip_section = {
    .name = "strip",
    .help = "a film that varies across rolling, for features of finite length "
            "across; the section may be empty",
    ROWS(keys),
    .whole = true};

void ovr_strip_choose(const void *form, ovr_options *options)
{
    const ovr_strip_form *f = form;
    if (f->ends && !options->order)
        options->order = 2;
}

void ovr_strip_state(const void *form, ovr_physics_effects *effects)
{
    const ovr_strip_form *f = form;
    effects->features = ovr_model_feature_bit(OVR_MODEL_STRIP, f->ends != 0);
    effects->width_across = f->ends ? f->width : 0;
}

/* The largest allowed number of lines that is at most `lines`, and the next. */
static void neighbours(int lines, int allowed[2])
{
    int power = 1;
    while (8 * power <= lines)
        power *= 2;
    allowed[0] = lines / power * power;
    allowed[1] = allowed[0] + power;
}

static ovr_status check_lines(const ovr_strip_form *f, ovr_error *err)
{
    int allowed[2];
    if (!f->lines)
        return OVR_OK;
    neighbours(f->lines, allowed);
    if (allowed[0] == f->lines)
        return OVR_OK;
    return ovr_fail_about(err, "lines",
                          "lines: %d must be 4, 5, 6 or 7 times a power of "
                          "two; the nearest are %d and %d",
                          f->lines, allowed[0], allowed[1]);
}

/* The period of the first areal surface, or the usual width. */
static ovr_status choose_width(const ovr_physics_case *of, ovr_strip_form *f,
                               ovr_error *err)
{
    for (size_t k = 0; k < of->features && f->width == 0; k++) {
        const ovr_feature_form *form = of->feature[k];
        if (form->shape != OVR_AREAL)
            continue;
        ovr_error why = {0};
        if (ovr_areal_period(form, of->contact, &of->arena->allocator,
                             &f->width, &why))
            return ovr_fail_about(err, form->name, "feature '%s': %s",
                                  form->name, why.message);
    }
    if (f->width == 0)
        f->width = USUAL_WIDTH;
    return OVR_OK;
}

ovr_status ovr_strip_resolve(const ovr_physics_case *of, void *form, bool *on,
                             ovr_error *err)
{
    ovr_strip_form *f = form;
    *on = f->ends != 0;
    if (!*on)
        return OVR_OK;
    if (!of->given(of->data, "strip", "shown"))
        f->shown = of->features ? of->feature[0]->across : 0;
    if (f->width == 0 && choose_width(of, f, err))
        return OVR_BAD_INPUT;
    f->M = of->contact->M;
    return check_lines(f, err);
}

size_t ovr_strip_lines(const ovr_strip_form *f, double D)
{
    int allowed[2], least = (int)ceil(f->width / (USUAL_RATIO * D) - 1e-9);
    if (f->lines)
        return (size_t)f->lines;
    if (least <= 4)
        return 4;
    /* Powers of two have the smallest coarsest grid. */
    for (size_t power = 8; power <= 16; power *= 2)
        if (least > (int)power / 2 && least < (int)power &&
            f->width >= (double)power * LEAST_RATIO * D)
            return power;
    neighbours(least, allowed);
    return (size_t)(allowed[0] == least ? least : allowed[1]);
}

/* Seconds of a steady node and of a node in a step, and the part of them that
 * threads do not share.  Measured on one core with AVX-512: a moving dent takes
 * 0.16 us in a step, roughness two to four times as much. */
static const double STEADY_NODE = 1.2e-6, STEP_NODE = 3e-7, ALONE = 0.3;

static const double CYCLE_NODE = 1.3e-7; /* seconds of a cycle */

static double decades_below(double usual, double tolerance)
{
    return tolerance > 0 ? fmax(0, log10(usual / tolerance)) : 0;
}

/* Cycles of a step to a given tolerance relative to the usual 2.3: 3.9 to 1e-4,
 * 15 to 1e-10. */
static double step_work(double tolerance)
{
    return 1 + 0.8 * decades_below(1e-3, tolerance);
}

/* Additional cycles of a steady film to a given tolerance. */
static double steady_cycles(double tolerance)
{
    return 2 * decades_below(1e-7, tolerance);
}

/* One elimination on a coarsest grid, for each node to the third power; those
 * of a steady film. */
static const double ELIMINATION = 8e-11, STEADY_ELIMINATIONS = 8;

/* Elimination relative to that of all nodes: some have no pressure. */
static const double PRESSURIZED = 0.35;

/* Cycles of growing features on a single grid, which are Newton's method,
 * relative to those on several grids. Of 11 such strips with features higher
 * than the film, two took 100 and 150, the others below 10. */
static const double SINGLE = 0.25;

static double coarsest_nodes(const ovr_strip_form *f, double length, double D,
                             size_t *n, size_t *lines)
{
    *n = (size_t)lround(length / D) + 1;
    *lines = ovr_strip_lines(f, D);
    ovr_strip_halvings(ovr_strip_coarsest(f->M), n, lines);
    return (double)*n * (double)*lines;
}

/* The coarsest grid is solved by elimination. */
static ovr_status check_coarsest(const ovr_strip_form *f, double length,
                                 double D, ovr_error *err)
{
    const double most = 3000;
    size_t n, lines;
    double nodes = coarsest_nodes(f, length, D, &n, &lines);
    if (nodes <= most)
        return OVR_OK;
    return ovr_fail_about(err, "width",
                          "width: a strip %.4g b wide has a coarsest grid of "
                          "%zu x %zu nodes, which may have %.0f; set a width "
                          "of at most %.3g b",
                          f->width, n, lines, most, f->width * most / nodes);
}

ovr_status ovr_strip_on_mesh(const ovr_physics_case *of, void *form, double D,
                             ovr_error *err)
{
    ovr_strip_form *f = form;
    const ovr_options *o = of->options;
    double lines = (double)ovr_strip_lines(f, D), length = o->outlet - o->inlet;
    double ratio = f->width / lines / D, fewest = 4, least, most;
    int allowed[2], first;
    size_t n, rows;
    double steps = of->end > 0 ? of->end / D : 0;
    double node = STEADY_NODE + steady_cycles(o->tolerance) * CYCLE_NODE +
                  steps * STEP_NODE * step_work(o->tolerance);
    double threads = fmin(f->threads, ovr_processors());
    double nodes = (length / D + 1) * lines *
                   (ALONE + (1 - ALONE) / fmax(1, threads));
    double elimination = pow(coarsest_nodes(f, length, D, &n, &rows), 3) *
                         ELIMINATION;
    f->seconds = nodes * node + elimination * (STEADY_ELIMINATIONS + steps);
    f->cycle_seconds = nodes * CYCLE_NODE + PRESSURIZED * elimination;
    if ((double)rows == lines)
        f->cycle_seconds *= SINGLE;
    if (ratio >= LEAST_RATIO && ratio <= LARGEST_RATIO)
        return check_coarsest(f, length, D, err);
    if (f->width < fewest * LEAST_RATIO * D)
        return ovr_fail_about(err, "width",
                              "width: a strip %.4g b wide is too narrow for "
                              "mesh sizes of %.3g b along x, which are long "
                              "because the film begins at X = %.4g; set a "
                              "width of at least %.3g b, or a higher "
                              "domain.level",
                              f->width, D, o->inlet, fewest * LEAST_RATIO * D);
    least = ceil(f->width / (LARGEST_RATIO * D) - 1e-9);
    most = floor(f->width / (LEAST_RATIO * D) + 1e-9);
    neighbours((int)fmax(4, least), allowed);
    first = allowed[0] < (int)least ? allowed[1] : allowed[0];
    neighbours((int)most, allowed);
    return ovr_fail_about(err, "lines",
                          "lines: %.0f have a mesh size across of %.2g times "
                          "that along x, which must be %.1f to %.0f times; set "
                          "%d to %d lines, or another domain.level",
                          lines, ratio, LEAST_RATIO, LARGEST_RATIO, first,
                          allowed[0]);
}

size_t ovr_strip_lines_across(const void *form, double D)
{
    const ovr_strip_form *f = form;
    return f->ends ? ovr_strip_lines(f, D) : 1;
}

double ovr_strip_seconds(const void *form)
{
    return ((const ovr_strip_form *)form)->seconds;
}

double ovr_strip_cycle_seconds(const void *form)
{
    return ((const ovr_strip_form *)form)->cycle_seconds;
}

void ovr_strip_describe(const ovr_physics_case *of, const void *form,
                        ovr_physics_line *line, void *data)
{
    const ovr_strip_form *f = form;
    const ovr_options *o = of->options;
    char text[160];
    int used = snprintf(text, sizeof text, "%.4g b wide, periodic", f->width);
    if (o->level > 0 && o->outlet > o->inlet) {
        size_t n = ovr_level_nodes(o->level);
        double D = (o->outlet - o->inlet) / (double)(n - 1);
        size_t lines = ovr_strip_lines(f, D);
        snprintf(text + used, sizeof text - (size_t)used,
                 "; %zu x %zu nodes, mesh sizes %.3g x %.3g b", n, lines, D,
                 ovr_across_mesh(f->width, lines));
    }
    line(data, "strip", text);
}
