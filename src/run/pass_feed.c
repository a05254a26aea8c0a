/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A pass leaves its row, and the layers that the next one begins with. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "results/results.h"
#include "run/forms.h"
#include "run/pass_series.h"

/* OUT.h5 -> OUT-3.h5. */
const char *ovr_passes_file_of(ovr_run *run, int pass, ovr_error *err)
{
    const char *path = run->passes->path, *dot = strrchr(path, '.');
    size_t stem, capacity = strlen(path) + 16;
    char *name = ovr_arena_take(&run->arena, capacity, 1, err);
    if (!dot || strchr(dot, '/'))
        dot = path + strlen(path);
    stem = (size_t)(dot - path);
    if (name)
        snprintf(name, capacity, "%.*s-%d%s", (int)stem, path, pass, dot);
    return name;
}

static void blank(ovr_pass_row *row)
{
    for (size_t k = 0; k < OVR_PASS_MAX; k++)
        row->value[k] = NAN;
    row->status = "waiting";
}

ovr_status ovr_passes_make_rows(ovr_run *run, int number, ovr_error *err)
{
    ovr_passes *p = run->passes;
    p->rows = number;
    p->file = ovr_arena_take(&run->arena, (size_t)number, sizeof *p->file, err);
    p->row = ovr_arena_take(&run->arena, (size_t)number, sizeof *p->row, err);
    if (!p->file || !p->row)
        return OVR_NO_MEMORY;
    for (int k = 0; k < number; k++) {
        blank(&p->row[k]);
        p->file[k] = ovr_passes_file_of(run, k + 1, err);
        if (!p->file[k])
            return OVR_NO_MEMORY;
    }
    return OVR_OK;
}

static void tell(ovr_run *run)
{
    run->info.pass = run->passes->now;
    run->info.passes = run->passes->rows;
    run->info.passes_file = run->passes->path;
    run->info.output = run->passes->file[run->passes->now - 1];
}

/*
 * Life of a raceway under all passes up to this one, again and again, over that
 * without features.  By the rule of Palmgren and Miner the shares of life add,
 * each pass's by its risk I of the whole raceway l, (I/ln(1/S))^(1/e) (life.c):
 *
 *     ratio = sum_k i_k^(1/e) / sum_k (i_k (1 + count lambda_k/l))^(1/e)
 *
 * i the smooth risk per length, lambda the equivalent length, of one surface.
 */
static double life_together(const ovr_run *run, int passes)
{
    const ovr_stress_setup *s = ovr_setup_stress(run->setup);
    double smooth = 0, real = 0;
    if (!(s->raceway > 0) || s->surfaces == 3)
        return NAN;
    for (int k = 0; k < passes; k++) {
        const double *v = run->passes->row[k].value;
        double part = pow(v[OVR_PASS_RISK], 1 / s->life.weibull);
        smooth += part;
        real += part / v[OVR_PASS_RATIO];
    }
    return smooth / real;
}

ovr_status ovr_passes_learn(ovr_run *run, int pass, ovr_pass_end *end,
                            ovr_error *err)
{
    ovr_passes *p = run->passes;
    end->flooded = p->oil_flooded;
    ovr_status status = ovr_pass_read(p->file[pass - 1], run->setup, end,
                                      &run->arena.allocator, err);
    if (status)
        return status;
    end->row.status = "complete";
    p->row[pass - 1] = end->row;
    run->info.life_together = life_together(run, pass);
    p->row[pass - 1].value[OVR_PASS_TOGETHER] = run->info.life_together;
    p->oil_flooded = end->flooded;
    const ovr_plastic_setup *plastic = ovr_setup_plastic(run->setup);
    if (plastic && plastic->elastic) {
        run->info.elastic_length = p->row[0].value[OVR_PASS_LENGTH];
        run->info.elastic_ratio = p->row[0].value[OVR_PASS_RATIO];
    }
    return OVR_OK;
}

/* Layers of oil, but where passes are those of [plastic] alone; strains. */
static void feed(const ovr_run *run, const char *file, ovr_pass_end *end)
{
    ovr_plastic_setup *plastic = ovr_setup_plastic(run->setup);
    if (!plastic || !plastic->flooded) {
        ovr_supply_feed(ovr_setup_supply(run->setup), end->layer,
                        end->reservoir);
        end->layer[0] = end->layer[1] = NULL;
    }
    if (plastic)
        plastic->initial = file;
}

ovr_status ovr_passes_feed(ovr_run *run, ovr_error *err)
{
    ovr_passes *p = run->passes;
    ovr_pass_end end;
    const ovr_allocator *allocator = &run->arena.allocator;
    ovr_status status = ovr_setup_pass(run->setup, p->now, allocator, err);
    if (!status)
        status = ovr_setup_prepare(run->setup, allocator, err);
    if (!status && !p->file)
        status = ovr_passes_make_rows(run, run->setup->passes->number, err);
    if (status)
        return status;
    tell(run);
    for (int pass = 1; pass < p->now; pass++) {
        if (pass < p->now - 1 &&
            isfinite(p->row[pass - 1].value[OVR_PASS_STEPS]))
            continue;
        status = ovr_passes_learn(run, pass, &end, err);
        if (status)
            return status;
        if (pass == p->now - 1)
            feed(run, p->file[pass - 1], &end);
        ovr_pass_end_free(&end);
    }
    return OVR_OK;
}

/* ----------------------------------------------------------------- at rest */

static bool is_near(const ovr_run *run, int pass, const char *column,
                    double maximum)
{
    size_t k = ovr_pass_column_named(column);
    const ovr_passes *p = run->passes;
    double now = p->row[pass - 1].value[k];
    double before = p->row[pass - 2].value[k];
    return isnan(now) || fabs(now - before) <= maximum * fabs(now);
}

/* True if bodies that yield have shaken down, by what is left of the shoulders
 * and by the risk: a spike that the mesh does not resolve goes on and on. */
bool ovr_passes_at_rest(const ovr_run *run, int pass)
{
    const double height = 1e-4, risk = 1e-3;
    return ovr_setup_plastic(run->setup) && pass > 1 &&
           is_near(run, pass, "shoulder_height_leading", height) &&
           is_near(run, pass, "shoulder_height_trailing", height) &&
           is_near(run, pass, "equivalent_length", risk);
}

void ovr_pass_level_feed(ovr_pass_level *of, ovr_setup *setup)
{
    if (of->end.layer[0])
        ovr_supply_feed(ovr_setup_supply(setup), of->end.layer,
                        of->end.reservoir);
    of->end.layer[0] = of->end.layer[1] = NULL;
}

void ovr_pass_level_begin(ovr_pass_level *of, const ovr_allocator *allocator)
{
    ovr_arena_release(&of->seen.arena);
    of->seen = ovr_pass_history_make(allocator);
}

ovr_status ovr_pass_level_end(ovr_pass_level *of, const ovr_setup *setup,
                              ovr_error *err)
{
    if (!of->end.row.status)
        of->end.flooded = NAN;
    ovr_pass_end_free(&of->end);
    ovr_status status = ovr_pass_end_make(setup, &of->seen, &of->end,
                                          &of->seen.arena.allocator, err);
    of->end.row.status = "complete";
    return status;
}

void ovr_passes_close(ovr_passes *passes)
{
    ovr_result_close(passes->before);
    passes->before = NULL;
}

void ovr_passes_free(ovr_passes *passes)
{
    if (passes)
        ovr_passes_close(passes);
    for (int k = 0; passes && k < OVR_PASS_LEVELS; k++) {
        ovr_pass_end_free(&passes->level[k].end);
        ovr_arena_release(&passes->level[k].seen.arena);
    }
}
