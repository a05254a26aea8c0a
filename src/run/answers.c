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
#include <stdio.h>
#include <string.h>

#include "overroll/profile.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/run.h"

enum { LINE = 320 };

typedef struct page {
    const ovr_group_attribute *number;
    size_t count;
    ovr_answer *put;
    void *data;
    char text[LINE];
    size_t used;
} page;

/* Returns the number of a key; NAN if the key is missing or unknown. */
static double of(const page *p, const char *key)
{
    for (size_t k = 0; k < p->count; k++)
        if (!p->number[k].text && !strcmp(p->number[k].name, key))
            return p->number[k].number;
    return NAN;
}

static bool has(const page *p, const char *key)
{
    return isfinite(of(p, key));
}

__attribute__((format(printf, 2, 3))) static void say(page *p,
                                                      const char *format, ...)
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
    return has(p, "contact_ratio");
}

static bool of_bearing(const page *p)
{
    return has(p, "heaviest_roller_N");
}

/* Appends the position: " 0.31 mm before the pitch point", " at 41.2 deg" or
 * nothing. */
static void write_place(page *p, const char *what)
{
    char way[40], angle[40];
    snprintf(way, sizeof way, "way_%s_m", what);
    snprintf(angle, sizeof angle, "angle_%s_deg", what);
    double at = of(p, way);
    if (fabs(at) < 5e-6)
        say(p, " at the pitch point");
    else if (isfinite(at))
        say(p, " %.3g mm %s the pitch point", 1e3 * fabs(at),
            at < 0 ? "before" : "after");
    if (has(p, angle))
        say(p, " at %.4g deg", of(p, angle));
    if (of_bearing(p) && has(p, "pass"))
        say(p, " under roller %.0f", of(p, "pass"));
}

static void write_drive(page *p)
{
    double speed = of(p, "speed_rpm"), torque = of(p, "torque_N_m");
    if (of_gear(p)) {
        say(p, "%.4g N.m at %.4g rpm: %.4g kW; contact ratio %.4g", torque,
            speed, 1e-3 * of(p, "power_W"), of(p, "contact_ratio"));
        if (of(p, "overlap_ratio") > 0)
            say(p, ", overlap ratio %.4g", of(p, "overlap_ratio"));
        finish_line(p, "gear pair");
    } else if (of_bearing(p)) {
        say(p,
            "%.4g N at %.4g rpm; %.0f loaded rollers, the most heavily loaded "
            "carries %.4g N",
            of(p, "bearing_load_N"), speed, of(p, "rollers_loaded"),
            of(p, "heaviest_roller_N"));
        finish_line(p, "bearing");
    } else {
        say(p, "%.4g rpm; maximum drive torque of the lift %.4g N.m", speed,
            torque);
        finish_line(p, "cam");
    }
}

/* Writes the reason why the power loss of a run is unknown. */
static void write_no_loss(page *p)
{
    double mu = fabs(of(p, "mu_slide_max"));
    if (mu > OVR_IMPOSSIBLE_FRICTION)
        say(p,
            "not given: the sliding friction coefficient reaches %.2g, which "
            "no lubricant sustains; set lubricant.rheology",
            mu);
    else if (has(p, "contact_share_mean") && isnan(mu))
        say(p, "unknown: set boundary.friction");
    finish_line(p, "friction power loss");
}

/* Writes the power loss, with a remark if friction is unrealistically high. */
static void write_loss(page *p)
{
    const double much = 0.3; /* higher than lubricants and dry metal contacts
                              * have */
    if (!has(p, "power_loss_W")) {
        write_no_loss(p);
        return;
    }
    say(p, "%.4g W, ", of(p, "power_loss_W"));
    if (of_gear(p))
        say(p,
            "mean over one meshing cycle, full face width; efficiency %.4g %%",
            100 * of(p, "efficiency"));
    else if (of_bearing(p))
        say(p, "one roller%s on this raceway",
            has(p, "pass") ? "" : ", the most heavily loaded,");
    else
        say(p, "mean over one revolution of the cam");
    if (of(p, "unbearable_share") > 0 && !has(p, "T_max_rise"))
        say(p,
            "; not realistic: the shear stress reaches %.2g of the pressure, "
            "set lubricant.rheology",
            of(p, "shear_over_pressure"));
    else if (fabs(of(p, "mu_slide_max")) > much)
        say(p, "; not realistic: the sliding friction coefficient reaches %.2g",
            fabs(of(p, "mu_slide_max")));
    finish_line(p, "friction power loss");
}

static void write_film(page *p)
{
    bool run = has(p, "H_min_overall_m");
    double h = of(p, run ? "H_min_overall_m" : "min_film_m");
    if (isnan(h))
        return; /* no solution */
    say(p, "%s", ovr_metres(h).text);
    write_place(p, "H_min");
    if (h < OVR_MOLECULE)
        say(p, ", thinner than molecules of lubricants");
    if (has(p, "lambda_ratio_at_H_min"))
        say(p, "; lambda ratio at this position %.3g, over the run %.3g",
            of(p, "lambda_ratio_at_H_min"), of(p, "lambda_ratio"));
    else if (has(p, "lambda_ratio"))
        say(p, "; lambda ratio %.3g", of(p, "lambda_ratio"));
    else if (has(p, "contact_lambda_mean"))
        say(p, "; lambda ratio %.3g", of(p, "contact_lambda_mean"));
    else if (has(p, "contact_lambda"))
        say(p, "; lambda ratio %.3g", of(p, "contact_lambda"));
    else
        say(p, "; lambda ratio unknown (set contact.Rq_1 and contact.Rq_2)");
    finish_line(p, "minimum film thickness");
}

static void write_pressure(page *p)
{
    bool run = has(p, "P_max_overall_Pa");
    if (!run && !has(p, "max_pressure_Pa"))
        return;
    say(p, "%.4g GPa",
        1e-9 * of(p, run ? "P_max_overall_Pa" : "max_pressure_Pa"));
    write_place(p, "P_max");
    finish_line(p, "maximum pressure");
}

static void write_heat(page *p)
{
    double T = of(p, "T_supply_K") - 273.15;
    if (!has(p, "T_max_rise"))
        return;
    say(p, "%.4g degC in the film, %.4g and %.4g degC on surfaces 1 and 2",
        T + of(p, "T_max_rise"), T + of(p, "T_1_max_rise"),
        T + of(p, "T_2_max_rise"));
    finish_line(p, "maximum temperature");
}

/* Writes the results of a run with [stress] and [fatigue]. */
static void write_stress(page *p)
{
    if (!has(p, "tau_max_Pa"))
        return;
    say(p, "%.4g GPa (von Mises stress %.4g GPa) below surface %.0f",
        1e-9 * of(p, "tau_max_Pa"), 1e-9 * of(p, "von_mises_max_Pa"),
        of(p, "surface_tau_max"));
    finish_line(p, "maximum shear stress");
    if (has(p, "utilisation"))
        say(p, "utilization of the fatigue limit %.3g", of(p, "utilisation"));
    if (has(p, "risk_smooth"))
        say(p, "%srisk of the smooth contact %.3g", p->used ? "; " : "",
            of(p, "risk_smooth"));
    finish_line(p, "fatigue");
    if (!has(p, "life_ratio"))
        return;
    say(p, "%.3g relative to smooth surfaces", of(p, "life_ratio"));
    if (has(p, "life_ratio_together"))
        say(p, ", %.3g for all passes together", of(p, "life_ratio_together"));
    finish_line(p, "life ratio");
}

static void tell(page *p)
{
    if (!has(p, "speed_rpm") || !has(p, "H_min"))
        return;
    write_drive(p);
    write_loss(p);
    write_film(p);
    write_pressure(p);
    write_heat(p);
    write_stress(p);
}

/* ------------------------------------------------------------ from a run */

enum { MAX = 256 };

typedef struct numbers {
    ovr_arena arena;
    size_t count;
    ovr_group_attribute of[MAX];
} numbers;

/* Stores a line of the summary. The key's text must remain valid during the
 * call. */
static void collect(void *data, const ovr_summary_line *line)
{
    numbers *n = data;
    const char *key = line->form != OVR_SUMMARY_TEXT && n->count < MAX
                          ? ovr_arena_text(&n->arena, line->key, NULL)
                          : NULL;
    if (key)
        n->of[n->count++] = (ovr_group_attribute){key, NULL, line->number};
}

void ovr_run_answers(const ovr_run_info *run, ovr_answer *put, void *data)
{
    if (!run || !put)
        return;
    numbers n = {.arena = ovr_arena_make(NULL)};
    ovr_run_summary(run, collect, &n);
    tell(&(page){.number = n.of, .count = n.count, .put = put, .data = data});
    ovr_arena_release(&n.arena);
}

void ovr_result_answers(ovr_result *result, ovr_answer *put, void *data)
{
    size_t count = 0;
    const ovr_group_attribute *number;
    if (!result || !put)
        return;
    number = ovr_result_attributes(result, "summary", &count);
    tell(&(page){.number = number, .count = count, .put = put, .data = data});
}
