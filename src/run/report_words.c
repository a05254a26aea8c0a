/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/report_words.h"
#include "physics/heat/heat.h"
#include "run/comparison.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* --------------------------------------------------------- contact and grid */

/* Prints nodes, scheme and smoother; for a strip the lines across instead. */
static void report_grid(const ovr_report_sink *to, const ovr_simulation *sim)
{
    const ovr_options *options = ovr_simulation_options(sim);
    const size_t n = ovr_simulation_state(sim)->n;
    const char *scheme = ovr_scheme_name(options->scheme);
    size_t lines, shown;
    if (ovr_simulation_lines(sim, &lines, &shown))
        ovr_report_title(to, "Grid: level %d, %zu nodes x %zu lines; scheme %s",
                         options->level, n, lines, scheme);
    else
        ovr_report_title(
            to, "Grid: level %d, %zu nodes; scheme %s; smoother %s",
            options->level, n, scheme, ovr_smoother_name(options->smoother));
}

void ovr_report_contact(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_contact *contact = s->setup->contact;
    ovr_words w = {""};
    if (isfinite(contact->ph))
        ovr_words_add(&w, ", p_h = %.4g GPa", contact->ph * 1e-9);
    if (s->transient)
        ovr_words_add(&w, ", T = 0 to %.4g", ovr_simulation_state(s->sim)->T);
    ovr_report_title(to, "%s contact: M = %.6g, L = %.6g%s",
                     s->transient ? "Transient" : "Steady", contact->M,
                     contact->L, w.text);
    report_grid(to, s->sim);
    if (s->passes)
        ovr_report_title(
            to,
            "Pass %d of %d; all passes in %s; results of this pass "
            "in %s",
            s->pass, s->passes, s->passes_file, s->output);
    ovr_report_heading(to, s->transient,
                       s->transient ? "over the run" : "quantity");
}

void ovr_report_steps(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    ovr_words w = {""};
    ovr_words_add(&w, "%ld cycles, %ld repeated, %ld accepted above tolerance",
                  total->cycles, total->retries, total->marked);
    if (total->uncorrected)
        ovr_words_add(&w, ", %ld of order 2", total->uncorrected);
    ovr_report_number(to, "time steps", 0, (double)total->steps, "%s", w.text);
    if (s->output)
        ovr_report_line(to, "result file", "%s, %zu snapshots", s->output,
                        s->snapshots);
}

void ovr_report_end(const ovr_report_sink *to, const ovr_run_info *s)
{
    ovr_words w = {""};
    ovr_words_place(&w, "at the end, T", ovr_simulation_state(s->sim)->T,
                    OVR_KIND_TIME, s->setup->contact);
    if (ovr_simulation_statistics(s->sim)->settled)
        ovr_words_add(&w, ", settled");
    ovr_report_heading(to, false, w.text);
}

/* -------------------------------------------------------------- remarks */

/* Appends the load in N/m. */
static void add_load(ovr_words *w, const ovr_observation *o,
                     const ovr_contact *contact)
{
    if (isfinite(contact->load))
        ovr_words_add(w, "%.4g kN/m", o->load / acos(0) * contact->load * 1e-3);
}

/* Appends the volume flow rate at ambient density. */
static void add_flow(ovr_words *w, const ovr_observation *o,
                     const ovr_contact *contact)
{
    double flow = o->mass_flow * contact->um * contact->height;
    if (isfinite(flow))
        ovr_words_add(w, "%.4g mm2/s at ambient density", flow * 1e6);
}

static void add_convergence(ovr_words *w, const ovr_observation *o)
{
    ovr_words_add(w, "%s in %d cycle%s",
                  o->converged ? "converged" : "NOT CONVERGED", o->cycles,
                  o->cycles == 1 ? "" : "s");
}

ovr_words ovr_words_of(const ovr_observable *row, const ovr_run_info *s)
{
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    const ovr_contact *contact = s->setup->contact;
    ovr_words w = {""};
    switch (row->offset) {
    case offsetof(ovr_observation, load): add_load(&w, o, contact); break;
    case offsetof(ovr_observation, mass_flow): add_flow(&w, o, contact); break;
    case offsetof(ovr_observation, residual): add_convergence(&w, o); break;
    default: break;
    }
    return w;
}

/* ---------------------------------------------------------------- friction */

static bool is_newtonian(const ovr_run_info *s)
{
    return s->setup->lubricant->rheology == OVR_NEWTONIAN;
}

/* True if friction exceeds the load with a rheological model without limiting
 * shear stress: then it is as unrealistic as for a Newtonian film. */
bool ovr_absurd_friction(const ovr_run_info *s)
{
    const double load = 1;
    double mu = ovr_simulation_observation(s->sim)->mu_slide;
    return s->unbearable_share > 0 && !ovr_setup_heat(s->setup) &&
           (is_newtonian(s) || fabs(mu) > load);
}

static void report_force(const ovr_report_sink *to, const char *label, double F,
                         const ovr_contact *contact)
{
    double scale = ovr_kind_scale(OVR_KIND_FORCE, contact) * contact->width;
    ovr_words w = isfinite(scale)
                      ? ovr_words_unit("p_h b^2/R", "%.4g N over the width",
                                       F * scale)
                      : ovr_words_unit("p_h b^2/R", "%s", "");
    ovr_report_number(to, label, 4, F, "%s", w.text);
}

/* Coefficients need b/R; without it, forces in p_h b^2/R are printed. */
static void report_coefficients(const ovr_report_sink *to,
                                const ovr_run_info *s)
{
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    const ovr_contact *contact = s->setup->contact;
    if (isnan(o->mu_slide) && isfinite(o->mu_roll)) {
        ovr_report_line(to, "friction coefficient",
                        "unknown (set boundary.friction)");
        ovr_report_number(to, "rolling friction coefficient", 4, o->mu_roll,
                          "%s", ovr_words_unit("", "film").text);
        return;
    }
    if (isnan(o->F_slide)) {
        ovr_report_line(to, "friction coefficient", "unknown");
        return;
    }
    if (!isfinite(contact->kappa)) {
        report_force(to, "sliding friction force", o->F_slide, contact);
        report_force(to, "rolling friction force", o->F_roll, contact);
        ovr_report_line(to, "friction coefficient",
                        "unknown (set contact.modulus or contact.G)");
        return;
    }
    ovr_report_number(to, "sliding friction coefficient", 4, o->mu_slide, "%s",
                      "");
    ovr_report_number(
        to, "rolling friction coefficient", 4, o->mu_roll, "%s",
        ovr_words_unit("", "surface 1: %.4g, surface 2: %.4g", o->mu_1, o->mu_2)
            .text);
    if (isfinite(contact->width) &&
        isfinite(ovr_kind_scale(OVR_KIND_FORCE, contact))) {
        report_force(to, "friction force on surface 1", o->F_1, contact);
        report_force(to, "friction force on surface 2", o->F_2, contact);
    }
}

static void report_friction(const ovr_report_sink *to, const ovr_run_info *s)
{
    if (ovr_absurd_friction(s))
        ovr_report_line(
            to, "friction is not realistic",
            "the shear stress reaches %.3g of the pressure and exceeds a "
            "tenth of it in %.2g %% of the contact; set lubricant.%s",
            s->shear_over_pressure, 100 * s->unbearable_share,
            is_newtonian(s) ? "rheology" : "limiting_shear");
    report_coefficients(to, s);
}

/* ------------------------------------------------------ starvation and heat */

/* Prints the starvation factor and the position of the inlet meniscus, or the
 * fraction of the supply that a flooded contact accepts. */
static void report_supply(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    ovr_words w = {""};
    if (isnan(o->inflow))
        return;
    if (isfinite(o->meniscus))
        ovr_words_place(&w, "inlet meniscus at X", o->meniscus, OVR_KIND_LENGTH,
                        s->setup->contact);
    else if (o->supply > 1.01 * o->inflow && o->inflow > 0 &&
             isfinite(o->starvation_factor))
        ovr_words_add(&w,
                      "flooded flow is %.2g of the supply, the excess collects "
                      "at the inlet",
                      o->inflow / o->supply);
    if (isfinite(o->starvation_factor))
        ovr_report_number(to, "starvation factor", 0, o->starvation_factor,
                          "%s", ovr_words_unit("", "%s", w.text).text);
    else
        ovr_report_line(to, "starvation factor",
                        "undefined: the entrainment speed is nearly zero%s%s",
                        *w.text ? "; " : "", w.text);
}

/* Maximum temperatures, and the error of the energy balance. */
static void report_heat(const ovr_report_sink *to, const ovr_run_info *s)
{
    const double zero = 273.15; /* degC in K */
    const double no_heat = 0.5; /* error of the energy balance */
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    if (!ovr_setup_heat(s->setup) || isnan(o->T_film_max))
        return;
    if (!o->converged && fabs(o->energy_defect) > no_heat) {
        ovr_report_line(to, "maximum film temperature",
                        "unknown (the film is not that of its heat)");
        return;
    }
    ovr_report_number(to, "maximum film temperature", 4, o->T_film_max - zero,
                      ovr_heat_is_resolved(o) ? "%-11s %.4g"
                                              : "%-11s %-10.4g (not resolved)",
                      "degC", o->X_T_film_max);
    ovr_report_number(to, "maximum temperature of surface 1", 4,
                      o->T_1_max - zero, "degC");
    ovr_report_number(to, "maximum temperature of surface 2", 4,
                      o->T_2_max - zero, "degC");
    if (isnan(o->energy_defect))
        ovr_report_line(to, "energy balance error",
                        "unknown (set boundary.friction)");
    else
        ovr_report_number(to, "energy balance error", 2, o->energy_defect, "%s",
                          "");
}

void ovr_report_conditions(const ovr_report_sink *to, const ovr_run_info *s)
{
    report_supply(to, s);
    report_friction(to, s);
    report_heat(to, s);
}

/* ------------------------------------------------------------------ errors */

/* Returns the name without " over the run", which does not fit into the
 * column. */
static ovr_words short_name(const char *name, const char **when)
{
    const char *over = strstr(name, " over the run");
    ovr_words w = {""};
    *when = over ? "over the run" : "";
    ovr_words_add(&w, "%.*s",
                  (int)(over ? (size_t)(over - name) : strlen(name)), name);
    return w;
}

/* Prints the relative error of a quantity and its error in nm, um or MPa, or
 * that the quantity does not converge. */
static void report_error(const ovr_report_sink *to, const ovr_run_error *e,
                         const ovr_contact *contact)
{
    /* The key of the interpolated minimum has its short form here. */
    const ovr_quantity_name name = ovr_quantity_named(
        strcmp(e->key, "H_min") ? e->key : "H_min_located");
    const char *unit = e->kind == OVR_KIND_HEIGHT   ? "nm"
                       : e->kind == OVR_KIND_LENGTH ? "um"
                                                    : "MPa";
    double scale = ovr_kind_scale(e->kind, contact) * (*unit == 'n'   ? 1e9
                                                       : *unit == 'u' ? 1e6
                                                                      : 1e-6);
    const char *when;
    ovr_words label = short_name(name.text, &when), w = {""};
    if (!e->converges) {
        ovr_report_line(to, label.text, "%s%sdoes not converge with the level",
                        when, *when ? ": " : "");
        return;
    }
    if (isfinite(scale))
        ovr_words_add(&w, "%.2g %s%s%s", e->error * scale, unit,
                      *when ? ", " : "", when);
    else
        ovr_words_add(&w, "%s", when);
    ovr_report_number(to, label.text, 2, 100 * e->error / fabs(e->value[0]),
                      "%s", ovr_words_unit("%", "%s", w.text).text);
}

void ovr_report_errors(const ovr_report_sink *to, const ovr_run_info *s)
{
    const ovr_run_errors *e = s->error;
    bool three = e->count && isfinite(e->of[0].value[2]);
    bool steps = s->transient && !s->setup->march->adaptive;
    ovr_report_title(to, "%s", "");
    ovr_report_title(to, "estimated discretization errors (from level %d%s%s)",
                     e->level, three ? " and the next coarser" : "",
                     steps ? ", time steps proportional to D" : "");
    for (size_t k = 0; k < e->count; k++)
        report_error(to, &e->of[k], s->setup->contact);
}
