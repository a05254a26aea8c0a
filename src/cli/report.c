/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/report.h"

#include <math.h>

/* ---------------------------------------------------------- output of lines */

static void write_line(json_writer *json, const ovr_summary_line *line)
{
    switch (line->form) {
    case OVR_SUMMARY_NUMBER: json_number(json, line->key, line->number); break;
    case OVR_SUMMARY_COUNT:
        json_integer(json, line->key, (long long)line->number);
        break;
    case OVR_SUMMARY_FLAG: json_flag(json, line->key, line->number > 0); break;
    default: json_text(json, line->key, line->text); break;
    }
}

static void print_words(const ovr_summary_line *line)
{
    if (!line->label)
        puts(line->text);
    else if (line->form == OVR_SUMMARY_WORDS)
        printf("%-*s %s\n", OVR_LABEL_WIDTH, line->label, line->text);
    else if (*line->text)
        printf("%-*s %-12.*g %s\n", OVR_LABEL_WIDTH, line->label, line->digits,
               line->number, line->text);
    else
        printf("%-*s %.*g\n", OVR_LABEL_WIDTH, line->label, line->digits,
               line->number);
}

void cli_put_line(void *json, const ovr_summary_line *line)
{
    if (json && line->key)
        write_line(json, line);
    else if (!json && !line->key)
        print_words(line);
}

/* --------------------------------------------------------------------- JSON */

/* Writes the levels of full multigrid. */
static void json_refinements(json_writer *json, const ovr_run_info *s)
{
    int count;
    const ovr_refinement *r = ovr_simulation_refinements(s->sim, &count);
    json_open_array(json, "refinements");
    for (int k = 0; k < count; k++) {
        json_open(json, NULL);
        json_integer(json, "level", r[k].level);
        json_integer(json, "nodes", (long long)r[k].nodes);
        json_integer(json, "cycles", r[k].cycles);
        json_number(json, "residual", r[k].residual);
        json_number(json, "factor", r[k].factor);
        json_number(json, "H_min", r[k].H_min);
        json_number(json, "H_cen", r[k].H_cen);
        json_number(json, "change", r[k].change);
        json_number(json, "algebraic", r[k].algebraic);
        json_number(json, "difference", r[k].difference);
        json_close(json);
    }
    json_close_array(json);
}

/* Lists the quantities whose error estimates do not converge. */
static void json_not_converging(json_writer *json, const ovr_run_errors *e)
{
    json_open_array(json, "not_converging");
    for (size_t k = 0; k < e->count; k++)
        if (!e->of[k].converges)
            json_text(json, NULL, e->of[k].key);
    json_close_array(json);
}

void cli_json_lengths(json_writer *json,
                      const ovr_stress_report *const report[2])
{
    const ovr_stress_report *a = report[0], *b = report[1], *r = a ? a : b;
    if (a && b && b->R_max > a->R_max)
        r = b;
    if (!r || !r->fatigue)
        return;
    json_open_array(json, "equivalent_lengths");
    for (size_t j = 0; j < r->material.depths; j++) {
        json_open(json, NULL);
        json_number(json, "depth", r->material.z[j]);
        json_number(json, "equivalent_length", r->length[j]);
        json_close(json);
    }
    json_close_array(json);
}

void cli_report_json(const ovr_run_info *s, FILE *to)
{
    json_writer json = json_begin(to);
    ovr_run_report(s, cli_put_line, &json);
    if (!s->transient)
        json_refinements(&json, s);
    cli_json_lengths(&json, s->stress);
    if (s->error->level)
        json_not_converging(&json, s->error);
    json_open_array(&json, "warnings");
    for (int i = 0; i < s->warnings; i++)
        json_text(&json, NULL, s->warning[i]);
    json_close_array(&json);
    json_end(&json);
}

/* ------------------------------------------------------------------ table */

static void table_refinements(const ovr_run_info *s)
{
    double height = s->setup->contact->height;
    int count;
    const ovr_refinement *r = ovr_simulation_refinements(s->sim, &count);
    if (count == 0)
        return;
    printf("\nlevel   nodes cycles residual  H_min        H_cen        "
           "algebraic to level below%s\n",
           isfinite(height) ? "  h_min, um  h_cen, um" : "");
    for (int k = 0; k < count; k++) {
        printf("%5d %7zu %6d %-9.2e %-12.7g %-12.7g %-9.2e %-14.2e", r[k].level,
               r[k].nodes, r[k].cycles, r[k].residual, r[k].H_min, r[k].H_cen,
               r[k].algebraic, r[k].difference);
        if (isfinite(height))
            printf("  %-9.5g  %.5g", r[k].H_min * height * 1e6,
                   r[k].H_cen * height * 1e6);
        putchar('\n');
    }
}

static void print_answer(void *begun, const char *name, const char *text)
{
    if (!*(bool *)begun)
        puts("\nMachine element");
    *(bool *)begun = true;
    printf("%-*s %s\n", OVR_LABEL_WIDTH, name, text);
}

/* Prints the answers of a gear pair, cam or bearing at the end of the
 * report. */
static void table_answers(const ovr_run_info *s)
{
    bool begun = false;
    ovr_run_answers(s, print_answer, &begun);
}

static void report_table(const cli_call *call, const ovr_run_info *s)
{
    ovr_run_report(s, cli_put_line, NULL);
    table_answers(s);
    if (call->verbosity > 0 && !s->transient)
        table_refinements(s);
}

void cli_report(const cli_call *call, const ovr_run_info *run)
{
    if (call->json)
        cli_report_json(run, stdout);
    else if (call->verbosity >= 0)
        report_table(call, run);
}
