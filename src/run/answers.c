/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Answers about a gear pair, cam or roller bearing: drive data, power loss,
 * efficiency, minimum film thickness, lambda ratio, maximum pressure, maximum
 * temperature, stress and life.
 *
 * They are computed from the numbers of a summary only, so that a run and its
 * result file give the same answers.  Numbers that only one kind of element has
 * identify the kind.
 */
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "overroll/profile.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/run.h"

/* The numbers that the answers need, under their keys in the summary; NAN:
 * missing or unknown. */
typedef struct numbers {
    double H_min_located, min_film_located_m, max_pressure_Pa;
    double H_min_overall_m, way_H_min_m, angle_H_min_deg;
    double P_max_overall_Pa, way_P_max_m, angle_P_max_deg;
    double lambda_ratio, lambda_ratio_at_H_min;
    double contact_lambda, contact_lambda_mean, contact_share_mean;
    double speed_rpm, torque_N_m, power_W, contact_ratio, overlap_ratio;
    double bearing_load_N, rollers_loaded, heaviest_roller_N, pass;
    double power_loss_W, efficiency, mu_slide_max;
    double unbearable_share, shear_over_pressure;
    double T_supply_K, T_max_rise, T_1_max_rise, T_2_max_rise;
    double tau_max_Pa, von_mises_max_Pa, surface_tau_max;
    double utilisation, risk_smooth, life_ratio, life_ratio_together;
} numbers;

#define ROW(key)                                                               \
    {                                                                          \
#key, offsetof(numbers, key)                                           \
    }
static const struct number_row {
    const char *key;
    size_t offset;
} number_rows[] = {ROW(H_min_located),
                   ROW(min_film_located_m),
                   ROW(max_pressure_Pa),
                   ROW(H_min_overall_m),
                   ROW(way_H_min_m),
                   ROW(angle_H_min_deg),
                   ROW(P_max_overall_Pa),
                   ROW(way_P_max_m),
                   ROW(angle_P_max_deg),
                   ROW(lambda_ratio),
                   ROW(lambda_ratio_at_H_min),
                   ROW(contact_lambda),
                   ROW(contact_lambda_mean),
                   ROW(contact_share_mean),
                   ROW(speed_rpm),
                   ROW(torque_N_m),
                   ROW(power_W),
                   ROW(contact_ratio),
                   ROW(overlap_ratio),
                   ROW(bearing_load_N),
                   ROW(rollers_loaded),
                   ROW(heaviest_roller_N),
                   ROW(pass),
                   ROW(power_loss_W),
                   ROW(efficiency),
                   ROW(mu_slide_max),
                   ROW(unbearable_share),
                   ROW(shear_over_pressure),
                   ROW(T_supply_K),
                   ROW(T_max_rise),
                   ROW(T_1_max_rise),
                   ROW(T_2_max_rise),
                   ROW(tau_max_Pa),
                   ROW(von_mises_max_Pa),
                   ROW(surface_tau_max),
                   ROW(utilisation),
                   ROW(risk_smooth),
                   ROW(life_ratio),
                   ROW(life_ratio_together)};

enum { NUMBERS = sizeof number_rows / sizeof *number_rows };
_Static_assert(NUMBERS == sizeof(numbers) / sizeof(double),
               "each number has a row");

static double *number_at(numbers *n, size_t row)
{
    return (double *)(void *)((char *)n + number_rows[row].offset);
}

static numbers no_numbers(void)
{
    numbers n;
    for (size_t k = 0; k < NUMBERS; k++)
        *number_at(&n, k) = NAN;
    return n;
}

/* Stores a number of the summary if the answers need it. */
static void store_number(numbers *n, const char *key, double value)
{
    for (size_t k = 0; k < NUMBERS; k++)
        if (!strcmp(number_rows[k].key, key))
            *number_at(n, k) = value;
}

enum { LINE = 320 };

typedef struct page {
    numbers n;
    ovr_answer *put;
    void *data;
    char text[LINE];
    size_t used;
} page;

__attribute__((format(printf, 2, 3))) static void
append(page *p, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(p->text + p->used, LINE - p->used, format, arguments);
    va_end(arguments);
    if (n > 0)
        p->used += (size_t)n;
    if (p->used >= LINE)
        p->used = LINE - 1;
}

/* Writes the line collected so far under the name `name`, unless it is
 * empty. */
static void finish_line(page *p, const char *name)
{
    if (p->used)
        p->put(p->data, name, p->text);
    p->used = 0;
    p->text[0] = '\0';
}

static bool of_gear(const page *p)
{
    return isfinite(p->n.contact_ratio);
}

static bool of_bearing(const page *p)
{
    return isfinite(p->n.heaviest_roller_N);
}

/* Appends the position: " 0.31 mm before the pitch point", " at 41.2 deg" or
 * nothing. */
static void write_place(page *p, double way, double angle)
{
    if (fabs(way) < 5e-6)
        append(p, " at the pitch point");
    else if (isfinite(way))
        append(p, " %.3g mm %s the pitch point", 1e3 * fabs(way),
               way < 0 ? "before" : "after");
    if (isfinite(angle))
        append(p, " at %.4g deg", angle);
    if (of_bearing(p) && isfinite(p->n.pass))
        append(p, " under roller %.0f", p->n.pass);
}

static void write_drive(page *p)
{
    double speed = p->n.speed_rpm, torque = p->n.torque_N_m;
    if (of_gear(p)) {
        append(p, "%.4g N.m at %.4g rpm: %.4g kW; contact ratio %.4g", torque,
               speed, 1e-3 * p->n.power_W, p->n.contact_ratio);
        if (p->n.overlap_ratio > 0)
            append(p, ", overlap ratio %.4g", p->n.overlap_ratio);
        finish_line(p, "gear pair");
    } else if (of_bearing(p)) {
        append(
            p,
            "%.4g N at %.4g rpm; %.0f loaded rollers, the most heavily loaded "
            "carries %.4g N",
            p->n.bearing_load_N, speed, p->n.rollers_loaded,
            p->n.heaviest_roller_N);
        finish_line(p, "bearing");
    } else {
        append(p, "%.4g rpm; maximum drive torque of the lift %.4g N.m", speed,
               torque);
        finish_line(p, "cam");
    }
}

/* Writes the reason why the power loss of a run is unknown. */
static void write_no_loss(page *p)
{
    double mu = fabs(p->n.mu_slide_max);
    if (mu > OVR_IMPOSSIBLE_FRICTION)
        append(
            p,
            "not given: the sliding friction coefficient reaches %.2g, which "
            "no lubricant sustains; set lubricant.rheology",
            mu);
    else if (isfinite(p->n.contact_share_mean) && isnan(mu))
        append(p, "unknown: set boundary.friction");
    finish_line(p, "friction power loss");
}

/* Writes the power loss, with a remark if friction is unrealistically high. */
static void write_loss(page *p)
{
    const double much = 0.3; /* higher than lubricants and dry metal contacts
                              * have */
    if (!isfinite(p->n.power_loss_W)) {
        write_no_loss(p);
        return;
    }
    append(p, "%.4g W, ", p->n.power_loss_W);
    if (of_gear(p))
        append(
            p,
            "mean over one meshing cycle, full face width; efficiency %.4g %%",
            100 * p->n.efficiency);
    else if (of_bearing(p))
        append(p, "one roller%s on this raceway",
               isfinite(p->n.pass) ? "" : ", the most heavily loaded,");
    else
        append(p, "mean over one revolution of the cam");
    if (p->n.unbearable_share > 0 && !isfinite(p->n.T_max_rise))
        append(
            p,
            "; not realistic: the shear stress reaches %.2g of the pressure, "
            "set lubricant.rheology",
            p->n.shear_over_pressure);
    else if (fabs(p->n.mu_slide_max) > much)
        append(p,
               "; not realistic: the sliding friction coefficient reaches %.2g",
               fabs(p->n.mu_slide_max));
    finish_line(p, "friction power loss");
}

static void write_film(page *p)
{
    bool run = isfinite(p->n.H_min_overall_m);
    double h = run ? p->n.H_min_overall_m : p->n.min_film_located_m;
    if (isnan(h))
        return; /* no solution */
    append(p, "%s", ovr_metres(h).text);
    write_place(p, p->n.way_H_min_m, p->n.angle_H_min_deg);
    if (h < OVR_MOLECULE)
        append(p, ", thinner than molecules of lubricants");
    if (isfinite(p->n.lambda_ratio_at_H_min))
        append(p, "; lambda ratio at this position %.3g, over the run %.3g",
               p->n.lambda_ratio_at_H_min, p->n.lambda_ratio);
    else if (isfinite(p->n.lambda_ratio))
        append(p, "; lambda ratio %.3g", p->n.lambda_ratio);
    else if (isfinite(p->n.contact_lambda_mean))
        append(p, "; lambda ratio %.3g", p->n.contact_lambda_mean);
    else if (isfinite(p->n.contact_lambda))
        append(p, "; lambda ratio %.3g", p->n.contact_lambda);
    else
        append(p, "; lambda ratio unknown (set contact.Rq_1 and contact.Rq_2)");
    finish_line(p, "minimum film thickness");
}

static void write_pressure(page *p)
{
    bool run = isfinite(p->n.P_max_overall_Pa);
    if (!run && !isfinite(p->n.max_pressure_Pa))
        return;
    append(p, "%.4g GPa",
           1e-9 * (run ? p->n.P_max_overall_Pa : p->n.max_pressure_Pa));
    write_place(p, p->n.way_P_max_m, p->n.angle_P_max_deg);
    finish_line(p, "maximum pressure");
}

static void write_heat(page *p)
{
    double T = p->n.T_supply_K - 273.15;
    if (!isfinite(p->n.T_max_rise))
        return;
    append(p, "%.4g degC in the film, %.4g and %.4g degC on surfaces 1 and 2",
           T + p->n.T_max_rise, T + p->n.T_1_max_rise, T + p->n.T_2_max_rise);
    finish_line(p, "maximum temperature");
}

/* Writes the results of a run with [stress] and [fatigue]. */
static void write_stress(page *p)
{
    if (!isfinite(p->n.tau_max_Pa))
        return;
    append(p, "%.4g GPa (von Mises stress %.4g GPa) below surface %.0f",
           1e-9 * p->n.tau_max_Pa, 1e-9 * p->n.von_mises_max_Pa,
           p->n.surface_tau_max);
    finish_line(p, "maximum shear stress");
    if (isfinite(p->n.utilisation))
        append(p, "utilization of the fatigue limit %.3g", p->n.utilisation);
    if (isfinite(p->n.risk_smooth))
        append(p, "%srisk of the smooth contact %.3g", p->used ? "; " : "",
               p->n.risk_smooth);
    finish_line(p, "fatigue");
    if (!isfinite(p->n.life_ratio))
        return;
    append(p, "%.3g relative to smooth surfaces", p->n.life_ratio);
    if (isfinite(p->n.life_ratio_together))
        append(p, ", %.3g for all passes together", p->n.life_ratio_together);
    finish_line(p, "life ratio");
}

static void write_answers(page *p)
{
    if (!isfinite(p->n.speed_rpm) || !isfinite(p->n.H_min_located))
        return;
    write_drive(p);
    write_loss(p);
    write_film(p);
    write_pressure(p);
    write_heat(p);
    write_stress(p);
}

static void store_line(void *data, const ovr_summary_line *line)
{
    if (line->form != OVR_SUMMARY_TEXT)
        store_number(data, line->key, line->number);
}

void ovr_run_answers(const ovr_run_info *run, ovr_answer *put, void *data)
{
    if (!run || !put)
        return;
    page p = {.n = no_numbers(), .put = put, .data = data};
    ovr_run_summary(run, store_line, &p.n);
    write_answers(&p);
}

void ovr_result_answers(ovr_result *result, ovr_answer *put, void *data)
{
    size_t count = 0;
    const ovr_group_attribute *of;
    if (!result || !put)
        return;
    page p = {.n = no_numbers(), .put = put, .data = data};
    of = ovr_result_attributes(result, "summary", &count);
    for (size_t k = 0; k < count; k++)
        if (!of[k].text)
            store_number(&p.n, of[k].name, of[k].number);
    write_answers(&p);
}
