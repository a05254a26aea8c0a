/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/report.h"

#include "cli/stress_report.h"

#include <math.h>
#include <string.h>

#include "cli/physical.h"

/* ------------------------------------------------------------------- JSON */

void cli_json_line(void *json, const ovr_summary_line *line)
{
    switch (line->form) {
    case OVR_SUMMARY_NUMBER: json_number(json, line->key, line->number); break;
    case OVR_SUMMARY_COUNT:
        json_integer(json, line->key, (long long)line->number);
        break;
    case OVR_SUMMARY_FLAG: json_flag(json, line->key, line->number > 0); break;
    case OVR_SUMMARY_TEXT: json_text(json, line->key, line->text); break;
    }
}

/* Full multigrid level by level. */
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

/* Quantities whose estimated errors say little. */
static void json_not_converging(json_writer *json, const ovr_run_errors *e)
{
    json_open_array(json, "not_converging");
    for (size_t k = 0; k < e->count; k++)
        if (!e->of[k].converges)
            json_text(json, NULL, e->of[k].key);
    json_close_array(json);
}

void cli_report_json(const ovr_run_info *s, FILE *to)
{
    json_writer json = json_begin(to);
    ovr_run_summary(s, cli_json_line, &json);
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

/* A number in Hertzian units, with what it is in SI where that is known. */
static void put_value(const char *name, double value, ovr_unit_kind kind,
                      const ovr_contact *contact)
{
    char text[CLI_PHYSICAL_SIZE];
    cli_physical(value, kind, contact, text);
    printf("%-17s %-12.6g %s%s", name, value, text, *text ? "  " : "");
}

static void put_at(const char *name, double value, ovr_unit_kind kind, double X,
                   const ovr_contact *contact)
{
    put_value(name, value, kind, contact);
    cli_put_place("at X", X, OVR_KIND_LENGTH, contact);
    putchar('\n');
}

static const char *convergence(const ovr_run_info *s)
{
    return ovr_simulation_observation(s->sim)->converged ? "converged"
                                                         : "NOT CONVERGED";
}

static const char *plural(long count)
{
    return count == 1 ? "" : "s";
}

/* The load in N/m, the flow of oil at ambient density. */
static void put_load_and_flow(const ovr_observation *o,
                              const ovr_contact *contact)
{
    double flow = o->mass_flow * contact->um * contact->height;
    printf("%-17s %-12.6g ", "load", o->load);
    if (isfinite(contact->load))
        printf("%.4g kN/m; ", o->load / acos(0) * contact->load * 1e-3);
    puts("pi/2 = 1.5708 at nominal load");
    printf("%-17s %-12.6g", "mass flow", o->mass_flow);
    if (isfinite(flow))
        printf(" %.4g mm2/s at ambient density", flow * 1e6);
    putchar('\n');
}

/* Forces in ph b^2/R; coefficients where b/R is known; forces in N over a
 * width. */
static void put_forces(const ovr_observation *o, const ovr_contact *contact,
                       int wide, const char *between)
{
    double scale = ovr_kind_scale(OVR_KIND_FORCE, contact) * contact->width;
    if (isfinite(contact->kappa))
        printf("%-*.4g sliding, %.4g rolling; on surface 1 %.4g, on 2 %.4g",
               wide, o->mu_slide, o->mu_roll, o->mu_1, o->mu_2);
    else
        printf("%-*.4g sliding, %.4g rolling, in ph b^2/R; coefficients need "
               "modulus or G",
               wide, o->F_slide, o->F_roll);
    if (isfinite(scale))
        printf("%s%-*.4g N on surface 1, %.4g N on 2, over the width", between,
               wide, o->F_1 * scale, o->F_2 * scale);
    putchar('\n');
}

/* A Newtonian isothermal film's may be no oil's, which is the first that is
 * said of it: the film is none the worse. */
static bool absurd_friction(const ovr_run_info *s)
{
    return s->unbearable_share > 0 && !s->setup->heat &&
           s->setup->lubricant->rheology == OVR_NEWTONIAN;
}

static void put_friction(const ovr_run_info *s)
{
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    const ovr_contact *contact = s->setup->contact;
    char between[40];
    bool absurd = absurd_friction(s);
    printf("%-17s ", isfinite(contact->kappa) ? "friction coeff." : "friction");
    if (absurd)
        printf("no oil has this friction, choose a rheology: a Newtonian "
               "film's stress is up to %.3g times the pressure, above a tenth "
               "of it in %.2g %% of the contact; ",
               s->shear_over_pressure, 100 * s->unbearable_share);
    snprintf(between, sizeof between, absurd ? "; " : "\n%-17s ",
             "friction force");
    put_forces(o, contact, absurd ? 0 : 12, between);
}

/* Where the film begins, and how much of the flooded one it is; what a flooded
 * contact leaves of the supply. */
static void put_supply(const ovr_observation *o, const ovr_contact *contact)
{
    if (isnan(o->inflow))
        return;
    if (isfinite(o->film_ratio))
        printf("%-17s %-12.6g of the flooded film", "film ratio",
               o->film_ratio);
    else
        printf("%-17s %-12s the surfaces hardly move", "film ratio", "none:");
    if (isfinite(o->meniscus))
        cli_put_place("; film begins at X", o->meniscus, OVR_KIND_LENGTH,
                      contact);
    else if (o->supply > 1.01 * o->inflow && o->inflow > 0 &&
             isfinite(o->film_ratio))
        printf("; of what arrives it takes %.2g, the rest waits",
               o->inflow / o->supply);
    putchar('\n');
}

/* Largest temperatures, and how far the balance of energy is from closed. */
static void put_heat(const ovr_run_info *s)
{
    const double zero = 273.15; /* degC in K */
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    if (!s->setup->heat)
        return;
    printf("%-17s %-12.4g degC in the film", "temperature",
           o->T_film_max - zero);
    cli_put_place(" at X", o->X_T_film_max, OVR_KIND_LENGTH, s->setup->contact);
    printf("\n%-17s %.4g and %.4g degC on surfaces 1 and 2; energy closes to "
           "%.1e\n",
           "", o->T_1_max - zero, o->T_2_max - zero, o->energy_defect);
}

static void table_observed(const ovr_run_info *s)
{
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    const ovr_contact *contact = s->setup->contact;
    put_at("minimum film", o->H_min, OVR_KIND_HEIGHT, o->X_min, contact);
    put_value("central film", o->H_cen, OVR_KIND_HEIGHT, contact);
    putchar('\n');
    put_at("maximum pressure", o->P_max, OVR_KIND_PRESSURE, o->X_P_max,
           contact);
    if (isfinite(o->P_spike))
        put_at("pressure spike", o->P_spike, OVR_KIND_PRESSURE, o->X_spike,
               contact);
    put_load_and_flow(o, contact);
    put_supply(o, contact);
    put_friction(s);
    put_heat(s);
    if (isfinite(s->lambda_ratio))
        printf("%-17s %-12.4g mean film in |X| < 3/4 and over the run, over "
               "the roughness of both surfaces\n",
               "lambda ratio", s->lambda_ratio);
    printf("%-17s %-12.3g %s in %d cycle%s\n", "residual", o->residual,
           convergence(s), o->cycles, plural(o->cycles));
}

static void put_extreme(const char *name, double value, ovr_unit_kind kind,
                        double X, double T, const ovr_contact *contact)
{
    put_value(name, value, kind, contact);
    if (isfinite(X)) {
        cli_put_place("at X", X, OVR_KIND_LENGTH, contact);
        fputs(", ", stdout);
    }
    cli_put_place(isfinite(X) ? "T" : "at T", T, OVR_KIND_TIME, contact);
    putchar('\n');
}

/* Beside what was said of it before it. */
static void put_rough_film(const ovr_run_info *s)
{
    const ovr_rough_film *said = s->foreseen;
    double film_Rq = ovr_simulation_statistics(s->sim)->extreme.film_Rq;
    if (!s->setup->features)
        return;
    put_value("film roughness", film_Rq, OVR_KIND_HEIGHT, s->setup->contact);
    fputs("at most, Rq in |X| < 3/4\n", stdout);
    if (said->why)
        return;
    printf("%-17s %-12.4g of %.4g on the surfaces, and a smallest film of "
           "%.4g%s%s\n",
           "  foreseen", said->film_Rq, said->Rq, said->H_min,
           said->but ? "; less sure here: " : "", said->but ? said->but : "");
}

/* Means, where they are of the film and not of what no oil has. */
static void put_means(const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    put_value("mean film", total->mean.H_mean, OVR_KIND_HEIGHT,
              s->setup->contact);
    fputs("in |X| < 3/4", stdout);
    if (fabs(total->mean.mu_slide) > 0 && !absurd_friction(s))
        printf("; mean friction coeff. %.4g", total->mean.mu_slide);
    if (s->setup->heat)
        printf("; mean of the largest rises %.4g K", total->mean.T_max_rise);
    putchar('\n');
}

/* The whole run: what was extreme in it, and what it took. */
static void table_run(const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    const ovr_contact *contact = s->setup->contact;
    puts("over the run:");
    put_extreme("largest pressure", total->extreme.P_max, OVR_KIND_PRESSURE,
                total->where.P_max, total->when.P_max, contact);
    put_extreme("smallest film", total->extreme.H_min_located, OVR_KIND_HEIGHT,
                total->where.H_min_located, total->when.H_min_located, contact);
    put_means(s);
    put_rough_film(s);
    put_extreme("load error", total->extreme.load_error, OVR_KIND_NUMBER, NAN,
                total->when.load_error, contact);
    printf("%-17s %-12ld %ld cycles, %ld retries, %ld marked\n", "steps",
           total->steps, total->cycles, total->retries, total->marked);
    if (s->output)
        printf("%-17s %s, %zu snapshots\n", "stored in", s->output,
               s->snapshots);
}

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

static const char *long_name(const char *key)
{
    static const char *const names[][2] = {
        {"H_min", "minimum film"},
        {"H_cen", "central film"},
        {"P_max", "maximum pressure"},
        {"H_min_overall", "smallest film"},
        {"P_max_overall", "largest pressure"},
        {"H_cen_mean", "mean central film"},
        {"X_meniscus_mean", "mean meniscus"}};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (!strcmp(names[k][0], key))
            return names[k][1];
    return key;
}

/* Relative, and in nm, um or MPa; of what does not converge only that. */
static void put_error(const ovr_run_error *e, const ovr_contact *contact)
{
    const char *unit = e->kind == OVR_KIND_HEIGHT   ? "nm"
                       : e->kind == OVR_KIND_LENGTH ? "um"
                                                    : "MPa";
    double scale = ovr_kind_scale(e->kind, contact) * (*unit == 'n'   ? 1e9
                                                       : *unit == 'u' ? 1e6
                                                                      : 1e-6);
    if (!e->converges) {
        printf(" %s does not converge with the level", long_name(e->key));
        return;
    }
    printf(" %s %.2g %%", long_name(e->key),
           100 * e->error / fabs(e->value[0]));
    if (isfinite(scale))
        printf(" (%.2g %s)", e->error * scale, unit);
}

static void table_error(const ovr_run_errors *e, const ovr_contact *contact)
{
    printf("%-17s", "estimated errors");
    for (size_t k = 0; k < e->count; k++) {
        put_error(&e->of[k], contact);
        fputs(k + 1 < e->count ? "," : "", stdout);
        if (k % 2 || k + 1 == e->count)
            printf("\n%-17s", "");
    }
    printf(" relative, from level %d%s\n", e->level,
           e->count && isfinite(e->of[0].value[2]) ? " and the one below it"
                                                   : "");
}

/* Of the whole run. */
static void table_stresses(const ovr_run_info *s)
{
    for (int k = 0; k < 2; k++)
        if (s->stress[k])
            cli_put_stress(s->stress[k], s->setup);
}

static void put_answer(void *begun, const char *name, const char *text)
{
    if (!*(bool *)begun)
        puts("answers:");
    *(bool *)begun = true;
    printf("%-17s %s\n", name, text);
}

/* Of a gear pair, cam or bearing: last, where it is looked for. */
static void table_answers(const ovr_run_info *s)
{
    bool begun = false;
    ovr_run_answers(s, put_answer, &begun);
}

static void report_table(const cli_call *call, const ovr_run_info *s)
{
    const ovr_contact *contact = s->setup->contact;
    const ovr_options *options = ovr_simulation_options(s->sim);
    const ovr_state *state = ovr_simulation_state(s->sim);
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    printf("M = %.6g, L = %.6g", contact->M, contact->L);
    if (isfinite(contact->ph))
        printf(", ph = %.4g GPa", contact->ph * 1e-9);
    printf("; level %d (%zu nodes), %s, %s\n", options->level, state->n,
           ovr_scheme_name(options->scheme),
           ovr_smoother_name(options->smoother));
    if (s->passes)
        printf("pass %d of %d, all in %s; of this one, in %s:\n", s->pass,
               s->passes, s->passes_file, s->output);
    if (s->transient) {
        table_run(s);
        table_stresses(s);
        cli_put_place("at the end, T", state->T, OVR_KIND_TIME, contact);
        puts(total->settled ? ", settled:" : ":");
    }
    table_observed(s);
    if (!s->transient)
        table_stresses(s);
    if (s->error->level)
        table_error(s->error, contact);
    printf("%-17s %.3g s\n", "time", s->seconds);
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
