/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers that sum a run up, by key: once, for reports, the group
 * `summary` of result files and the tables of studies. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/sized.h"
#include "run/internal.h"

/* Who takes the lines. */
typedef struct taker {
    ovr_summary_taker *take;
    void *data;
} taker;

static void put(const taker *to, const char *key, ovr_summary_form form,
                double value)
{
    const ovr_summary_line line = {sizeof line, key, form, value, NULL};
    to->take(to->data, &line);
}

static void put_number(const taker *to, const char *key, double value)
{
    put(to, key, OVR_SUMMARY_NUMBER, value);
}

static void put_count(const taker *to, const char *key, double value)
{
    put(to, key, OVR_SUMMARY_COUNT, value);
}

static void put_text(const taker *to, const char *key, const char *text)
{
    const ovr_summary_line line = {sizeof line, key, OVR_SUMMARY_TEXT, NAN,
                                   text};
    to->take(to->data, &line);
}

/* A number, and in SI where there is a key for it. */
static void put_both(const taker *to, const char *key, const char *key_si,
                     double value, double scale)
{
    put_number(to, key, value);
    if (key_si)
        put_number(to, key_si, value * scale);
}

/* --------------------------------------------------------------- its parts */

void ovr_contact_summary(const ovr_contact *contact, ovr_summary_taker *take,
                         void *data)
{
    if (!take)
        return;
    const taker to = {take, data};
    ovr_contact own = ovr_contact_default();
    const ovr_contact *c = ovr_sized_whole(&own, sizeof own, contact);
    if (!c)
        return;
    put_number(&to, "M", c->M);
    put_number(&to, "L", c->L);
    put_number(&to, "alphabar", c->alphabar);
    put_number(&to, "lambda", c->lambda);
    put_number(&to, "hertz_pressure_Pa", c->ph);
    put_number(&to, "half_width_m", c->b);
    put_number(&to, "film_scale_m", c->height);
    put_number(&to, "time_scale_s", c->time);
    put_number(&to, "load_N_per_m", c->load);
    put_number(&to, "mean_speed_m_per_s", c->um);
}

void ovr_rough_film_summary(const ovr_rough_film *film,
                            const ovr_contact *contact, ovr_summary_taker *take,
                            void *data)
{
    if (!film || !take)
        return;
    const taker to = {take, data};
    ovr_contact own = ovr_contact_default();
    const ovr_contact *c = ovr_sized_whole(&own, sizeof own, contact);
    if (!c)
        return;
    put_both(&to, "surface_Rq", "surface_Rq_m", film->Rq, c->height);
    put_both(&to, "film_Rq_foreseen", "film_Rq_foreseen_m", film->film_Rq,
             c->height);
    put_both(&to, "H_min_foreseen", "H_min_foreseen_m", film->H_min, c->height);
    put_text(&to, "not_foreseen", film->why ? film->why : film->but);
}

/* All quantities that have a key, as they are at the end. */
static void put_observed(const taker *to, const ovr_run_info *s)
{
    const ovr_observation *seen = ovr_simulation_observation(s->sim);
    unsigned physics = ovr_setup_physics(s->setup);
    const ovr_observable *o;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++) {
        double value = o->key ? ovr_observable_value(o, seen) : NAN;
        if (o->needs & ~physics || !o->key)
            continue;
        if (o->kind == OVR_KIND_COUNT)
            put_count(to, o->key, value);
        else
            put_both(to, o->key, o->key_si, value,
                     ovr_kind_scale(o->kind, s->setup->contact));
    }
}

/* Times the width; the key as that of a unit width, without "_per_m". */
static void put_wide(const taker *to, const char *key_si, ovr_unit_kind kind,
                     double value, const ovr_contact *contact)
{
    double scale = ovr_kind_scale(kind, contact) * contact->width;
    char key[64];
    if (!*key_si || (kind != OVR_KIND_FORCE && kind != OVR_KIND_POWER))
        return;
    snprintf(key, sizeof key, "%.*s", (int)(strlen(key_si) - strlen("_per_m")),
             key_si);
    put_number(to, key, value * scale);
}

/* Forces and powers of the whole width, where it is known. */
static void put_of_width(const taker *to, const ovr_run_info *s)
{
    const ovr_observation *seen = ovr_simulation_observation(s->sim);
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    const ovr_contact *contact = s->setup->contact;
    unsigned physics = ovr_setup_physics(s->setup);
    const ovr_observable *o;
    ovr_extreme e;
    if (isnan(contact->width))
        return;
    put_number(to, "load_N", seen->load_ratio * contact->load * contact->width);
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if (o->key_si && !(o->needs & ~physics))
            put_wide(to, o->key_si, o->kind, ovr_observable_value(o, seen),
                     contact);
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if ((s->transient || e.of->steady) && !(e.of->needs & ~physics))
            put_wide(to, e.key_si, e.kind, ovr_extreme_value(&e, total),
                     contact);
}

/* Extremes over the whole run. */
static void put_extremes(const taker *to, const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    unsigned physics = ovr_setup_physics(s->setup);
    ovr_extreme e;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if ((s->transient || e.of->steady) && !(e.of->needs & ~physics))
            put_both(to, e.key, *e.key_si ? e.key_si : NULL,
                     ovr_extreme_value(&e, total),
                     ovr_kind_scale(e.kind, s->setup->contact));
}

static void put_steps(const taker *to, const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    put_count(to, "steps", (double)total->steps);
    put_count(to, "steps_marked", (double)total->marked);
    put_count(to, "cycles_total", (double)total->cycles);
    put_count(to, "retries", (double)total->retries);
    put_count(to, "substeps", (double)total->substeps);
    put(to, "settled", OVR_SUMMARY_FLAG, total->settled);
    put_count(to, "snapshots", (double)s->snapshots);
    put_text(to, "output", s->passes ? s->passes_file : s->output);
    put_number(to, "T_end", ovr_simulation_state(s->sim)->T);
}

/* All that stands beside it is of the last one. */
static void put_passes(const taker *to, const ovr_run_info *s)
{
    put_count(to, "pass", s->pass);
    put_count(to, "passes", s->passes);
    put_text(to, "pass_output", s->output);
    if (isfinite(s->life_together))
        put_number(to, "life_ratio_together", s->life_together);
    if (!s->transient)
        put_text(to, "output", s->passes_file);
}

/* Estimated discretization errors, dimensionless and relative. */
static void put_errors(const taker *to, const ovr_run_errors *e)
{
    char key[64];
    put_count(to, "error_level", e->level);
    for (size_t k = 0; k < e->count; k++) {
        const ovr_run_error *of = &e->of[k];
        snprintf(key, sizeof key, "%s_error", of->key);
        put_number(to, key, of->error);
        snprintf(key, sizeof key, "%s_error_relative", of->key);
        put_number(to, key, of->error / fabs(of->value[0]));
    }
}

/* ---------------------------------------------------------------- stresses */

static void put_place(const taker *to, const char *name,
                      const ovr_stress_extreme *e, double ph)
{
    char key[64];
    put_number(to, name, e->value);
    snprintf(key, sizeof key, "X_%s", name);
    put_number(to, key, e->X);
    snprintf(key, sizeof key, "Z_%s", name);
    put_number(to, key, e->Z);
    snprintf(key, sizeof key, "T_%s", name);
    put_number(to, key, e->T);
    snprintf(key, sizeof key, "%s_Pa", name);
    put_number(to, key, e->value * ph);
}

static void put_life(const taker *to, const ovr_stress_report *r,
                     const ovr_setup *setup)
{
    put_text(to, "criterion", ovr_criterion_name(setup->stress->criterion));
    put_number(to, "limit", r->limit);
    put_both(to, "equivalent_length", "equivalent_length_m",
             r->life->equivalent_length, setup->contact->b);
    put_number(to, "utilisation", r->life->utilisation);
    put_number(to, "life_ratio", r->ratio);
    put_number(to, "risk_smooth", r->life->smooth_risk);
}

void ovr_stress_summary(const ovr_stress_report *const report[2],
                        const ovr_setup *setup, ovr_summary_taker *take,
                        void *data)
{
    if (!report || !setup || !take)
        return;
    const taker to = {take, data};
    const ovr_stress_report *a = report[0], *b = report[1];
    const ovr_stress_report *shear = a ? a : b, *circle = shear;
    double ph = setup->contact->ph;
    if (!shear)
        return;
    if (a && b && b->max_shear.value > a->max_shear.value)
        shear = b;
    if (a && b && b->R_max > a->R_max)
        circle = b;
    put_place(&to, "tau_max", &shear->max_shear, ph);
    put_place(&to, "von_mises_max", &shear->von_mises, ph);
    put_count(&to, "surface_tau_max", shear->surface);
    put_number(&to, "R_max", circle->R_max);
    put_number(&to, "xi_R_max", circle->xi_R_max);
    put_number(&to, "Z_R_max", circle->Z_R_max);
    put_number(&to, "R_max_Pa", circle->R_max * ph);
    put_number(&to, "R_smooth", circle->R_smooth);
    put_count(&to, "surface_R_max", circle->surface);
    put_number(&to, "least_depth", circle->least_depth);
    put(&to, "traction", OVR_SUMMARY_FLAG, circle->traction);
    put_count(&to, "material_points", (double)circle->material.points);
    put_count(&to, "material_incomplete", (double)circle->incomplete);
    if (circle->fatigue)
        put_life(&to, circle, setup);
}

/* ------------------------------------------------------------------- whole */

void ovr_run_summary(const ovr_run_info *s, ovr_summary_taker *take, void *data)
{
    if (!s || !take)
        return;
    const taker to = {take, data};
    const ovr_options *options = ovr_simulation_options(s->sim);
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    put(&to, "converged", OVR_SUMMARY_FLAG, s->converged);
    put_text(&to, "way", ovr_simulation_strategy(s->sim));
    ovr_contact_summary(s->setup->contact, take, data);
    put_count(&to, "nodes", (double)ovr_simulation_state(s->sim)->n);
    put_count(&to, "level", options->level);
    put_text(&to, "scheme", ovr_scheme_name(options->scheme));
    put_text(&to, "smoother", ovr_smoother_name(options->smoother));
    put_number(&to, "inlet", options->inlet);
    put_number(&to, "outlet", options->outlet);
    if (s->setup->heat)
        put_count(&to, "heat_points", ovr_simulation_heat_points(s->sim));
    if (!s->setup->features)
        put_number(&to, "lambda_ratio", NAN);
    if (s->transient)
        put_number(&to, "lambda_ratio_at_H_min",
                   total->mean.lambda_ratio * total->H_mean_at_H_min /
                       total->mean.H_mean);
    put_number(&to, "shear_over_pressure", s->shear_over_pressure);
    put_number(&to, "unbearable_share", s->unbearable_share);
    if (s->passes)
        put_passes(&to, s);
    put_extremes(&to, s);
    if (s->setup->features)
        ovr_rough_film_summary(s->foreseen, s->setup->contact, take, data);
    if (s->transient)
        put_steps(&to, s);
    put_observed(&to, s);
    put_of_width(&to, s);
    ovr_stress_summary(s->stress, s->setup, take, data);
    ovr_element_summary(s, take, data);
    if (s->error->level)
        put_errors(&to, s->error);
    put_number(&to, "seconds", s->seconds);
}

/* ------------------------------------------------------------ in its file */

enum { MOST_LINES = 256 };

typedef struct kept {
    ovr_arena *arena;
    size_t count;
    ovr_group_attribute line[MOST_LINES];
} kept;

/* Numbers alone; how many snapshots there are and how long it took the file
 * says elsewhere. */
static void keep(void *data, const ovr_summary_line *line)
{
    kept *k = data;
    const char *key;
    if (line->form == OVR_SUMMARY_TEXT || !strcmp(line->key, "snapshots") ||
        !strcmp(line->key, "seconds") || k->count == MOST_LINES)
        return;
    key = ovr_arena_text(k->arena, line->key, NULL);
    if (key)
        k->line[k->count++] = (ovr_group_attribute){key, NULL, line->number};
}

ovr_status ovr_run_keep_summary(ovr_run *run, ovr_error *err)
{
    kept *k = ovr_arena_take(&run->arena, 1, sizeof *k, err);
    ovr_group group = {.size = sizeof group, .path = "summary"};
    if (!k)
        return OVR_NO_MEMORY;
    k->arena = &run->arena;
    ovr_run_summary(&run->info, keep, k);
    group.attributes = k->count;
    group.attribute = k->line;
    return ovr_writer_group(run->writer, &group, false, err);
}
