/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of a run's summary, by key, for reports, the group `summary` of
 * result files and the tables of studies. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "case/setup.h"
#include "physics/heat/heat.h"
#include "physics/mixed/mixed.h"
#include "physics/plastic/plastic.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/report_words.h"
#include "run/run.h"
#include "run/summary_lines.h"
#include "simulation/observe.h"
#include "simulation/simulation.h"
#include "stress/stress.h"

/* ----------------------------------------------------- parts of the summary */

/* Keys with "foreseen" are those of version 0.3; they are written for one more
 * version. */
void ovr_put_rough_film(const ovr_report_sink *to, const ovr_rough_film *film,
                        const ovr_contact *contact)
{
    const char *note = film->why ? film->why : film->but;
    ovr_put_both(to, "surface_Rq", "surface_Rq_m", film->Rq, contact->height);
    ovr_put_both(to, "film_Rq_predicted", "film_Rq_predicted_m", film->film_Rq,
                 contact->height);
    ovr_put_both(to, "H_min_predicted", "H_min_predicted_m", film->H_min,
                 contact->height);
    ovr_put_text(to, "prediction_missing", note);
    ovr_put_both(to, "film_Rq_foreseen", "film_Rq_foreseen_m", film->film_Rq,
                 contact->height);
    ovr_put_both(to, "H_min_foreseen", "H_min_foreseen_m", film->H_min,
                 contact->height);
    ovr_put_text(to, "not_foreseen", note);
}

/* Prints the predictions made before the run. */
static void report_predicted(const ovr_report_sink *to,
                             const ovr_rough_film *film)
{
    if (film->why)
        return;
    ovr_report_number(
        to, "predicted film thickness roughness Rq", 4, film->film_Rq, "%s",
        ovr_words_unit("b^2/R", "largest in |X| < %g; surfaces: %.4g b^2/R",
                       OVR_ROUGH_WINDOW, film->Rq)
            .text);
    if (film->H_min > 0)
        ovr_report_number(
            to, "predicted minimum film thickness", 4, film->H_min, "%s",
            ovr_words_unit("b^2/R", "%s%s", film->but ? "less certain: " : "",
                           film->but ? film->but : "")
                .text);
}

/* True if row is the maximum temperature and the grid does not resolve it. */
static bool is_unresolved_rise(const ovr_observable *row,
                               const ovr_statistics *total)
{
    return row->offset == offsetof(ovr_observation, T_max_rise) &&
           !ovr_heat_maximum_is_resolved(total);
}

/* Returns the remark on a pressure that the mesh does not resolve. */
static const char *unresolved(const ovr_observable *row, bool maximum,
                              bool spike)
{
    bool is_maximum = row->offset == offsetof(ovr_observation, P_max);
    bool is_spike = row->offset == offsetof(ovr_observation, P_spike);
    return (is_maximum && !maximum) || (is_spike && !spike) ? "not resolved"
                                                            : "";
}

/* Prints the row of a quantity at the end, if it has one and is known. */
static void report_observed(const ovr_report_sink *to,
                            const ovr_observable *row, const ovr_run_info *s)
{
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    const ovr_contact *contact = s->setup->contact;
    double value = row->label ? ovr_observable_value(row, o) : NAN;
    double X = row->place ? *(const double *)(const void *)((const char *)o +
                                                            row->place)
                          : NAN;
    ovr_words more = ovr_words_of(row, s);
    ovr_words_add(&more, "%s",
                  unresolved(row, o->P_max_resolved, o->P_spike_resolved));
    if (!isnan(value))
        ovr_report_number(
            to, row->label, row->digits, value, "%s",
            ovr_words_columns(value, row, X, NAN, contact, more.text).text);
    else if (row->offset == offsetof(ovr_observation, residual))
        ovr_report_line(to, row->label, "not finite (%s)", more.text);
}

/* False for the lambda ratio of features if the ratio of the roughness that is
 * not on the grid replaces it. */
static bool is_reported(const ovr_extreme *e, const ovr_run_info *s)
{
    return !(s->setup->Rq > 0 && !strcmp(e->key, "lambda_ratio"));
}

/* Prints the row of an extreme or mean. */
static void report_extreme(const ovr_report_sink *to, const ovr_extreme *e,
                           const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    const ovr_contact *contact = s->setup->contact;
    const ovr_observable *row = e->of;
    bool mean = e->part == OVR_KEPT_MEAN;
    bool reported = mean ? row->mean_reported : row->extreme_reported;
    double value = ovr_extreme_value(e, total), X = NAN, T = NAN;
    ovr_words behind;
    if (!reported || isnan(value) || (!mean && e->part != OVR_KEPT_EXTREME) ||
        (row->friction && (!(fabs(value) > 0) || ovr_absurd_friction(s))))
        return;
    if (!mean) {
        ovr_extreme at = *e;
        at.part = OVR_KEPT_TIME;
        T = ovr_extreme_value(&at, total);
        at.part = OVR_KEPT_PLACE;
        if (row->place) /* checkpoints contain no other positions */
            X = ovr_extreme_value(&at, total);
    }
    ovr_words remark = {""};
    ovr_words_add(&remark, "%s",
                  unresolved(row, mean || !total->P_max_unresolved, true));
    if (!mean && is_unresolved_rise(row, total))
        ovr_words_add(&remark, "not resolved");
    if (ovr_extreme_is_flagged(e, total))
        ovr_words_add(&remark, "%sflagged step", *remark.text ? "; " : "");
    behind = ovr_words_columns(value, row, X, T, contact, remark.text);
    ovr_report_number(to, e->label, row->digits, value, "%s", behind.text);
}

/* Prints the mean of a quantity that has no row for its value, in a steady
 * solution, where both are equal. */
static void report_mean(const ovr_report_sink *to, const ovr_observable *row,
                        const ovr_run_info *s)
{
    ovr_extreme e;
    if (s->transient || row->label || !row->name || row->friction)
        return;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if (e.of == row && e.part == OVR_KEPT_MEAN && is_reported(&e, s))
            report_extreme(to, &e, s);
}

/* Prints the values of all quantities at the end. */
static void report_all_observed(const ovr_report_sink *to,
                                const ovr_run_info *s)
{
    const ovr_observation *seen = ovr_simulation_observation(s->sim);
    unsigned physics = ovr_setup_physics(s->setup);
    const ovr_observable *o;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++) {
        double value = o->key ? ovr_observable_value(o, seen) : NAN;
        if (o->needs & ~physics)
            continue;
        if (o->offset == offsetof(ovr_observation, residual))
            ovr_report_conditions(to, s);
        report_observed(to, o, s);
        report_mean(to, o, s);
        if (!o->key)
            continue;
        if (o->kind == OVR_KIND_COUNT)
            ovr_put_count(to, o->key, value);
        else
            ovr_put_both(to, o->key, o->key_si, value,
                         ovr_kind_scale(o->kind, s->setup->contact));
    }
}

/* Adds a force or power multiplied by the width, under the key without
 * "_per_m". */
static void add_wide(const ovr_report_sink *to, const char *key_si,
                     ovr_unit_kind kind, double value,
                     const ovr_contact *contact)
{
    double scale = ovr_kind_scale(kind, contact) * contact->width;
    char key[64];
    if (!*key_si || (kind != OVR_KIND_FORCE && kind != OVR_KIND_POWER))
        return;
    snprintf(key, sizeof key, "%.*s", (int)(strlen(key_si) - strlen("_per_m")),
             key_si);
    ovr_put_number(to, key, value * scale);
}

/* Adds forces and powers for the whole width, if it is known. */
static void add_of_width(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_observation *seen = ovr_simulation_observation(s->sim);
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    const ovr_contact *contact = s->setup->contact;
    unsigned physics = ovr_setup_physics(s->setup);
    const ovr_observable *o;
    ovr_extreme e;
    if (isnan(contact->width))
        return;
    ovr_put_number(to, "load_N",
                   seen->load_ratio * contact->load * contact->width);
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if (o->key_si && !(o->needs & ~physics))
            add_wide(to, o->key_si, o->kind, ovr_observable_value(o, seen),
                     contact);
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if ((s->transient || e.of->steady) && !(e.of->needs & ~physics))
            add_wide(to, e.key_si, e.kind, ovr_extreme_value(&e, total),
                     contact);
}

/* Prints extremes and means over the whole run. */
static void report_extremes(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    unsigned physics = ovr_setup_physics(s->setup);
    ovr_extreme e;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if ((s->transient || e.of->steady) && !(e.of->needs & ~physics)) {
            if (!is_reported(&e, s))
                continue;
            if (s->transient)
                report_extreme(to, &e, s);
            ovr_put_both(to, e.key, *e.key_si ? e.key_si : NULL,
                         ovr_extreme_value(&e, total),
                         ovr_kind_scale(e.kind, s->setup->contact));
        }
}

/* Adds the keys of the extremes that are from flagged steps. */
static void add_flagged(const ovr_report_sink *to, const ovr_statistics *total)
{
    char keys[1600] = "";
    size_t used = 0;
    ovr_extreme e;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if (ovr_extreme_is_flagged(&e, total) && used + 60 < sizeof keys)
            used += (size_t)snprintf(keys + used, sizeof keys - used, "%s%s",
                                     used ? ", " : "", e.key);
    ovr_put_text(to, "extremes_flagged", used ? keys : NULL);
}

static void add_steps(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    ovr_put_count(to, "steps", (double)total->steps);
    ovr_put_count(to, "steps_marked", (double)total->marked);
    add_flagged(to, total);
    ovr_put_count(to, "cycles_total", (double)total->cycles);
    ovr_put_count(to, "retries", (double)total->retries);
    ovr_put_count(to, "substeps", (double)total->substeps);
    ovr_put_count(to, "steps_uncorrected", (double)total->uncorrected);
    ovr_put(to, "settled", OVR_SUMMARY_FLAG, total->settled);
    ovr_put_count(to, "snapshots", (double)s->snapshots);
    ovr_put_text(to, "output", s->passes ? s->passes_file : s->output);
    ovr_put_number(to, "T_end", ovr_simulation_state(s->sim)->T);
    ovr_report_steps(to, s);
}

/* Prints the numbers of all passes. The other numbers of the summary are those
 * of the last pass. */
static void add_passes(const ovr_report_sink *to, const ovr_run_info *s)
{
    ovr_put_count(to, "pass", s->pass);
    ovr_put_count(to, "passes", s->passes);
    ovr_put_text(to, "pass_output", s->output);
    if (isfinite(s->life_together))
        ovr_put_number(to, "life_ratio_together", s->life_together);
    if (isfinite(s->elastic_length)) {
        ovr_put_both(to, "equivalent_length_elastic",
                     "equivalent_length_elastic_m", s->elastic_length,
                     s->setup->contact->b);
        ovr_put_number(to, "life_ratio_elastic", s->elastic_ratio);
    }
    if (ovr_setup_plastic(s->setup))
        ovr_put(to, "shaken_down", OVR_SUMMARY_FLAG, s->shaken_down);
    if (!s->transient)
        ovr_put_text(to, "output", s->passes_file);
}

/* Prints the equivalent length by elastic stresses (pass 1) for comparison with
 * that of the last pass. */
static void report_elastic(const ovr_report_sink *to, const ovr_run_info *s)
{
    ovr_words life = {""};
    if (!isfinite(s->elastic_length))
        return;
    if (isfinite(s->elastic_ratio))
        ovr_words_add(&life, ", life ratio %.4g", s->elastic_ratio);
    ovr_report_line(
        to, "elastic reference",
        "equivalent raceway length %.4g b%s (pass 1, without plastic "
        "deformation)",
        s->elastic_length, life.text);
}

/* Estimated discretization errors, dimensionless and relative. */
static void add_errors(const ovr_report_sink *to, const ovr_run_errors *e)
{
    char key[64];
    ovr_put_count(to, "error_level", e->level);
    for (size_t k = 0; k < e->count; k++) {
        const ovr_run_error *of = &e->of[k];
        snprintf(key, sizeof key, "%s_error", of->key);
        ovr_put_number(to, key, of->error);
        snprintf(key, sizeof key, "%s_error_relative", of->key);
        ovr_put_number(to, key, of->error / fabs(of->value[0]));
    }
}

/* -------------------------------------------------------- complete summary */

/* Adds level, scheme and cost of the run. */
static void add_options(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_options *options = ovr_simulation_options(s->sim);
    ovr_put_count(to, "nodes", (double)ovr_simulation_state(s->sim)->n);
    ovr_put_count(to, "level", options->level);
    ovr_put_text(to, "scheme", ovr_scheme_name(options->scheme));
    ovr_put_text(to, "smoother", ovr_smoother_name(options->smoother));
    ovr_put_number(to, "inlet", options->inlet);
    ovr_put_number(to, "outlet", options->outlet);
    if (ovr_setup_heat(s->setup))
        ovr_put_count(to, "heat_points", ovr_simulation_heat_points(s->sim));
}

/* Composite roughness that is not on the grid, b^2/R: of contact.Rq_1 and Rq_2,
 * otherwise of boundary.Rq; 0: none. */
static double subgrid_roughness(const ovr_run_info *s, const char **from)
{
    const ovr_boundary_form *law = ovr_setup_form(s->setup, "boundary");
    *from = "contact.Rq_1 and contact.Rq_2";
    if (s->setup->Rq > 0)
        return s->setup->Rq;
    *from = "[boundary]";
    return !s->setup->features && law && law->law && law->factor.sigma > 0
               ? law->factor.sigma
               : 0;
}

/* Adds the lambda ratio of roughness that is not on the grid, minimum film
 * thickness / Rq. That of features is a row of the quantities: mean film
 * thickness in |X| < 3/4 / Rq. */
static void add_lambda_ratio(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    const char *from;
    double Rq = subgrid_roughness(s, &from);
    double H = s->transient ? total->extreme.H_min_located : o->H_min_located;
    bool known = Rq > 0 && isfinite(H);
    if (Rq > 0 || !s->setup->features)
        ovr_put_number(to, "lambda_ratio", known ? H / Rq : NAN);
    ovr_put_text(to, "lambda_ratio_from",
                 known                ? from
                 : Rq > 0             ? NULL
                 : s->setup->features ? "features"
                                      : NULL);
    if (known)
        ovr_report_number(
            to, "lambda ratio", 4, H / Rq, "%s",
            ovr_words_unit("",
                           "minimum film thickness / composite Rq "
                           "of %s",
                           from)
                .text);
    if (s->transient)
        ovr_put_number(to, "lambda_ratio_at_H_min",
                       known ? H / Rq
                             : total->mean.lambda_ratio *
                                   total->H_mean_at_H_min / total->mean.H_mean);
}

static void add_rough_film(const ovr_report_sink *to, const ovr_run_info *s)
{
    double film_Rq = ovr_simulation_observation(s->sim)->film_Rq;
    add_lambda_ratio(to, s);
    if (s->setup->features) {
        if (!s->setup->transient && isfinite(film_Rq)) /* nodes are inside */
            ovr_report_number(to, "film thickness roughness Rq", 4, film_Rq,
                              "%s", ovr_words_unit("b^2/R", "|X| < 0.75").text);
        ovr_put_rough_film(to, s->predicted, s->setup->contact);
        if (s->transient || !s->setup->transient) /* not left out */
            report_predicted(to, s->predicted);
    }
}

/* In the order of reports: values over the run, then at its end. */
void ovr_run_report(const ovr_run_info *s, ovr_summary_taker *take, void *data)
{
    if (!s || !take)
        return;
    const ovr_report_sink to = {take, data};
    ovr_put(&to, "converged", OVR_SUMMARY_FLAG, s->converged);
    ovr_put_text(&to, "way", ovr_simulation_strategy(s->sim));
    ovr_put_contact(&to, s->setup->contact, false);
    add_options(&to, s);
    ovr_put(&to, "P_max_resolved", OVR_SUMMARY_FLAG,
            !ovr_simulation_statistics(s->sim)->P_max_unresolved);
    ovr_put(&to, "P_spike_resolved", OVR_SUMMARY_FLAG,
            ovr_simulation_observation(s->sim)->P_spike_resolved);
    if (ovr_setup_heat(s->setup))
        ovr_put(&to, "T_max_resolved", OVR_SUMMARY_FLAG,
                s->converged &&
                    ovr_heat_is_resolved(ovr_simulation_observation(s->sim)) &&
                    ovr_heat_maximum_is_resolved(
                        ovr_simulation_statistics(s->sim)));
    ovr_put_number(&to, "shear_over_pressure", s->shear_over_pressure);
    ovr_put_number(&to, "unbearable_share", s->unbearable_share);
    if (s->passes)
        add_passes(&to, s);
    ovr_report_contact(&to, s);
    if (s->transient) {
        report_extremes(&to, s);
        add_rough_film(&to, s);
        add_steps(&to, s);
        ovr_stress_summary(s->stress, s->setup, take, data);
        report_elastic(&to, s);
        ovr_report_end(&to, s);
    }
    report_all_observed(&to, s);
    add_of_width(&to, s);
    if (!s->transient) {
        add_rough_film(&to, s);
        report_extremes(&to, s);
        ovr_stress_summary(s->stress, s->setup, take, data);
    }
    ovr_element_summary(s, take, data);
    if (s->error->level)
        add_errors(&to, s->error);
    if (s->error->level)
        ovr_report_errors(&to, s);
    ovr_put_number(&to, "seconds", s->seconds);
    ovr_report_number(&to, "computing time", 3, s->seconds, "s");
}

void ovr_run_summary(const ovr_run_info *s, ovr_summary_taker *take, void *data)
{
    ovr_report_sink to = {take, data};
    if (take)
        ovr_run_report(s, ovr_put_keyed, &to);
}

/* A run has its stresses and the numbers of passes only after its solution. */
void ovr_run_keys(const ovr_run_info *run, ovr_summary_taker *take, void *data)
{
    const ovr_report_sink to = {take, data};
    ovr_run_info info = *run;
    info.life_together = info.elastic_length = info.elastic_ratio = 0;
    if (run->setup->passes->number > 1)
        add_passes(&to, &info);
    ovr_stress_keys(run->setup, take, data);
    ovr_run_summary(run, take, data);
}

/* --------------------------------------------- storage in the result file */

enum { MAX_LINES = 256 };

typedef struct kept {
    ovr_arena *arena;
    size_t count;
    ovr_group_attribute line[MAX_LINES];
} kept;

/* Stores finite numbers. A result file contains the number of snapshots and the
 * computing time elsewhere. */
static void keep(void *data, const ovr_summary_line *line)
{
    kept *k = data;
    const char *key;
    if (line->form == OVR_SUMMARY_TEXT || !isfinite(line->number) ||
        !strcmp(line->key, "snapshots") || !strcmp(line->key, "seconds") ||
        k->count == MAX_LINES)
        return;
    key = ovr_arena_text(k->arena, line->key, NULL);
    if (key)
        k->line[k->count++] = (ovr_group_attribute){key, NULL, line->number};
}

const ovr_group_attribute *ovr_run_numbers(const ovr_run *run, ovr_arena *arena,
                                           size_t *count, ovr_error *err)
{
    kept *k = ovr_arena_take(arena, 1, sizeof *k, err);
    *count = 0;
    if (!k)
        return NULL;
    k->arena = arena;
    ovr_run_summary(&run->info, keep, k);
    *count = k->count;
    return k->line;
}

ovr_status ovr_run_keep_summary(ovr_run *run, ovr_error *err)
{
    ovr_group group = {.path = "summary"};
    group.attribute = ovr_run_numbers(run, &run->arena, &group.attributes, err);
    return group.attribute ? ovr_writer_group(run->writer, &group, false, err)
                           : OVR_NO_MEMORY;
}
