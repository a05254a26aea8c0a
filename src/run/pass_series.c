/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/pass_series.h"
#include "case/setup.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/error.h"
#include "physics/plastic/plastic.h"
#include "physics/stress/stress.h"
#include "physics/supply/supply.h"
#include "results/results.h"

/* --------------------------------------------------------- Result of a pass */

const char *ovr_passes_name(const char *path, int pass, ovr_arena *arena,
                            ovr_error *err)
{
    const char *dot = strrchr(path, '.');
    size_t stem, capacity = strlen(path) + 16;
    char *name = ovr_arena_take(arena, capacity, 1, err);
    if (!dot || strchr(dot, '/'))
        dot = path + strlen(path);
    stem = (size_t)(dot - path);
    if (name)
        snprintf(name, capacity, "%.*s-%d%s", (int)stem, path, pass, dot);
    return name;
}

/* Returns the file name of a pass in the memory of the run. */
static const char *passes_file_of(ovr_run *run, int pass, ovr_error *err)
{
    return ovr_passes_name(run->passes->path, pass, &run->arena, err);
}

static void blank(ovr_pass_row *row)
{
    for (size_t k = 0; k < OVR_PASS_MAX; k++)
        row->value[k] = NAN;
    row->status = "waiting";
}

/* Allocates rows and names for the passes. */
static ovr_status passes_make_rows(ovr_run *run, int number, ovr_error *err)
{
    ovr_passes *p = run->passes;
    p->rows = number;
    p->file = ovr_arena_take(&run->arena, (size_t)number, sizeof *p->file, err);
    p->row = ovr_arena_take(&run->arena, (size_t)number, sizeof *p->row, err);
    if (ovr_arena_status(&run->arena))
        return OVR_NO_MEMORY;
    for (int k = 0; k < number; k++) {
        blank(&p->row[k]);
        p->file[k] = passes_file_of(run, k + 1, err);
        if (!p->file[k])
            return OVR_NO_MEMORY;
    }
    return OVR_OK;
}

static void update_info(ovr_run *run)
{
    run->info.pass = run->passes->now;
    run->info.passes = run->passes->rows;
    run->info.passes_file = run->passes->path;
    run->info.output = run->passes->file[run->passes->now - 1];
}

/*
 * Life of a raceway under all passes so far, repeated, relative to its life
 * without features. By the Palmgren-Miner rule, with the risk I of the whole
 * raceway of length l, the lives (I/ln(1/S))^(1/e) (life.c) of the passes
 * combine to
 *
 *     ratio = sum_k i_k^(1/e) / sum_k (i_k (1 + count lambda_k/l))^(1/e)
 *
 * i: smooth risk per length; lambda: equivalent length, of one surface.
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

/* Reads the row of a pass that ended from its file, together with the layers it
 * left. */
static ovr_status passes_update(ovr_run *run, int pass, ovr_pass_end *end,
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

/* Passes lubricant layers (unless the passes have [plastic] with flooded
 * contacts) and plastic strains to the setup of the next pass. */
static void feed_setup(const ovr_run *run, const char *file, ovr_pass_end *end)
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
        status = passes_make_rows(run, run->setup->passes->number, err);
    if (status)
        return status;
    update_info(run);
    for (int pass = 1; pass < p->now; pass++) {
        if (pass < p->now - 1 &&
            isfinite(p->row[pass - 1].value[OVR_PASS_STEPS]))
            continue;
        status = passes_update(run, pass, &end, err);
        if (status)
            return status;
        if (pass == p->now - 1)
            feed_setup(run, p->file[pass - 1], &end);
        ovr_pass_end_free(&end);
    }
    return OVR_OK;
}

/* --------------------------------------------------------------- Shakedown */

static bool is_near(const ovr_run *run, int pass, const char *column,
                    double maximum)
{
    size_t k = ovr_pass_column_named(column);
    const ovr_passes *p = run->passes;
    double now = p->row[pass - 1].value[k];
    double before = p->row[pass - 2].value[k];
    return isnan(now) || fabs(now - before) <= maximum * fabs(now);
}

/* True if plastic bodies have shaken down, judged by the rim heights and the
 * fatigue risk. Pressure spikes that the grid cannot resolve prevent
 * shakedown. */
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

static void passes_close(ovr_passes *passes)
{
    ovr_result_close(passes->before);
    passes->before = NULL;
}

void ovr_passes_free(ovr_passes *passes)
{
    if (passes)
        passes_close(passes);
    for (int k = 0; passes && k < OVR_PASS_LEVELS; k++) {
        ovr_pass_end_free(&passes->level[k].end);
        ovr_arena_release(&passes->level[k].seen.arena);
    }
}

/* --------------------------------------------------------- Series of passes */

static ovr_status make(ovr_run *run, const char *path, ovr_error *err)
{
    ovr_passes *p = ovr_arena_take(&run->arena, 1, sizeof *p, err);
    run->passes = p;
    if (!p)
        return OVR_NO_MEMORY;
    p->now = 1;
    p->oil_flooded = NAN;
    p->converged = true;
    p->path = ovr_arena_text(&run->arena, path, err);
    return p->path ? OVR_OK : OVR_NO_MEMORY;
}

/* ---------------------------------------------------------------- A new run */

/* Removes result files of earlier passes, which would otherwise be resumed. */
static ovr_status clear(ovr_run *run, ovr_error *err)
{
    static const char *const endings[] = {"", ".restart", ".journal"};
    const ovr_passes *p = run->passes;
    for (int k = 0; k < p->rows; k++) {
        ovr_status status = ovr_output_check(p->file[k], run->c, run->how.force,
                                             err);
        if (status)
            return status;
    }
    for (int k = 0; k < p->rows; k++)
        for (size_t e = 0; e < sizeof endings / sizeof *endings; e++) {
            char path[4500];
            snprintf(path, sizeof path, "%.4400s%s", p->file[k], endings[e]);
            unlink(path);
        }
    run->how.force = true;
    return OVR_OK;
}

ovr_status ovr_passes_begin(ovr_run *run, ovr_error *err)
{
    ovr_status status;
    if (!run->info.output)
        return ovr_fail_about(err, "number",
                              "several passes need a result file; set -o "
                              "OUT.h5 or output.file (find: --results "
                              "FOLDER; study: results = yes). --sensitivity "
                              "has no result files; use a study of the key");
    status = make(run, run->info.output, err);
    if (!status)
        status = passes_make_rows(run, run->setup->passes->number, err);
    if (!status)
        status = clear(run, err);
    if (!status)
        status = ovr_run_set_up(run, err);
    if (!status)
        status = ovr_passes_write(run, "running", err);
    return status ? status : ovr_output_open(run, err);
}

/* ------------------------------------------------ Solution of the passes */

/* Frees everything that belongs to the last pass. */
static void free_pass(ovr_run *run)
{
    ovr_companions_release(run);
    ovr_simulation_free(run->sim);
    ovr_setup_free(run->setup);
    ovr_restart_close(run->restart);
    run->sim = NULL;
    run->setup = NULL;
    run->restart = NULL;
    run->restored = false;
    run->info.sim = NULL;
    run->info.setup = NULL;
    run->info.stress[0] = run->info.stress[1] = NULL;
}

static ovr_status next(ovr_run *run, ovr_error *err)
{
    ovr_status status;
    free_pass(run);
    run->passes->now++;
    status = ovr_run_set_up(run, err);
    return status ? status : ovr_output_open(run, err);
}

/* Adds the row of a pass that ended. */
static ovr_status end_pass(ovr_run *run, ovr_error *err)
{
    ovr_pass_end end;
    ovr_status status = passes_update(run, run->passes->now, &end, err);
    if (!status)
        ovr_pass_end_free(&end);
    return status;
}

static ovr_status write_rows(ovr_run *run, const char *how, ovr_error *err)
{
    return run->passes->whole ? OVR_OK : ovr_passes_write(run, how, err);
}

ovr_status ovr_passes_execute(ovr_run *run, ovr_error *err)
{
    static const char *const names[] = {"complete", "stopped", "failed"};
    ovr_passes *p = run->passes;
    ovr_status status = OVR_OK;
    for (bool more = true; !status && more;) {
        status = write_rows(run, "running", err);
        if (!status)
            status = ovr_run_once(run, err);
        p->converged = p->converged && (status || run->info.converged);
        if (!status)
            status = end_pass(run, err);
        run->info.shaken_down = !status && ovr_passes_at_rest(run, p->now);
        if (run->info.shaken_down)
            run->info.passes = p->rows = p->now; /* no further passes */
        more = p->now < p->rows;
        if (!status && more)
            status = next(run, err);
    }
    const char *how = names[!status ? 0 : status == OVR_STOPPED ? 1 : 2];
    ovr_error late = {0};
    if (status)
        p->row[p->now - 1].status = how;
    run->info.converged = run->info.converged && p->converged;
    if (run->setup && write_rows(run, how, &late) && !status) {
        *err = late;
        status = late.status;
    }
    return status;
}

/* ---------------------------------------------------------------- Resuming */

static void recall_pass(ovr_run *run, ovr_result *result)
{
    size_t count = 0;
    const ovr_group_attribute *line = ovr_result_attributes(result, "summary",
                                                            &count);
    for (size_t k = 0; k < count; k++) {
        if (strcmp(line[k].name, "converged") == 0 && line[k].number == 0)
            run->passes->converged = false;
        if (strcmp(line[k].name, "steps_marked") == 0)
            run->info.marked += (long)line[k].number;
    }
    ovr_run_recall(run, ovr_result_get_info(result)->warnings);
}

void ovr_passes_recall(ovr_run *run)
{
    if (run->passes->before)
        recall_pass(run, run->passes->before);
    passes_close(run->passes);
}

/* Opens the result file of a complete pass. Returns NULL if it does not exist
 * or is incomplete. */
static ovr_result *open_complete(const char *path)
{
    ovr_result *result = access(path, F_OK) == 0
                             ? ovr_result_open(path, NULL, NULL)
                             : NULL;
    if (result && strcmp(ovr_result_get_info(result)->status, "complete") == 0)
        return result;
    ovr_result_close(result);
    return NULL;
}

ovr_status ovr_passes_reopen(ovr_run *run, const char *path, ovr_error *err)
{
    ovr_status status = make(run, path, err);
    const char *file = NULL;
    if (status)
        return status;
    for (run->passes->now = 1;; run->passes->now++) {
        file = passes_file_of(run, run->passes->now, err);
        if (!file)
            return OVR_NO_MEMORY;
        ovr_result *complete = open_complete(file);
        if (!complete)
            break;
        ovr_passes_recall(run);
        run->title = ovr_arena_text(&run->arena,
                                    ovr_result_get_info(complete)->title, NULL);
        run->passes->before = complete;
    }
    run->info.output = file;
    run->how.force = true;
    return OVR_OK;
}

ovr_status ovr_passes_finish(ovr_run *run, int last, ovr_error *err)
{
    run->passes->now = last;
    ovr_status status = ovr_passes_feed(run, err);
    if (!status)
        status = end_pass(run, err);
    run->passes->rows = last;
    return status ? status : ovr_passes_write(run, "complete", err);
}

ovr_status ovr_passes_go_back(ovr_run *run, int last, ovr_error *err)
{
    free_pass(run);
    run->passes->now = last;
    run->passes->whole = true;
    passes_close(run->passes);
    run->info.output = passes_file_of(run, last, err);
    return run->info.output ? OVR_OK : OVR_NO_MEMORY;
}

ovr_status ovr_setup_pass(ovr_setup *setup, int pass,
                          const ovr_allocator *allocator, ovr_error *err)
{
    ovr_plastic_setup *plastic = ovr_setup_plastic(setup);
    if (plastic)
        plastic->rests = plastic->elastic && pass == 1;
    return ovr_setup_load(setup, pass, allocator, err);
}
