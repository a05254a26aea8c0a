/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/report_words.h"
#include "physics/heat/heat.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* ---------------------------------------------------------------- the whole */

void ovr_say_contact(const ovr_told *to, const ovr_run_info *s)
{
    const ovr_contact *contact = s->setup->contact;
    const ovr_options *options = ovr_simulation_options(s->sim);
    ovr_words w = {""};
    if (isfinite(contact->ph))
        ovr_words_add(&w, ", ph = %.4g GPa", contact->ph * 1e-9);
    ovr_tell_title(
        to, "M = %.6g, L = %.6g%s; level %d (%zu nodes), %s, %s", contact->M,
        contact->L, w.text, options->level, ovr_simulation_state(s->sim)->n,
        ovr_scheme_name(options->scheme), ovr_smoother_name(options->smoother));
    if (s->passes)
        ovr_tell_title(to,
                       "pass %d of %d, all in %s; of this one, in %s:", s->pass,
                       s->passes, s->passes_file, s->output);
    if (s->transient)
        ovr_tell_title(to, "over the run:");
}

void ovr_say_steps(const ovr_told *to, const ovr_run_info *s)
{
    const ovr_statistics *total = ovr_simulation_statistics(s->sim);
    ovr_tell_number(to, "steps", 0, (double)total->steps,
                    "%ld cycles, %ld retries, %ld marked", total->cycles,
                    total->retries, total->marked);
    if (s->output)
        ovr_tell(to, "stored in", "%s, %zu snapshots", s->output, s->snapshots);
}

void ovr_say_end(const ovr_told *to, const ovr_run_info *s)
{
    ovr_words w = {""};
    ovr_words_place(&w, "at the end, T", ovr_simulation_state(s->sim)->T,
                    OVR_KIND_TIME, s->setup->contact);
    ovr_tell_title(to, "%s%s", w.text,
                   ovr_simulation_statistics(s->sim)->settled ? ", settled:"
                                                              : ":");
}

/* ---------------------------------------------------------- beside the rows */

/* The load in N/m. */
static void add_load(ovr_words *w, const ovr_observation *o,
                     const ovr_contact *contact)
{
    if (isfinite(contact->load))
        ovr_words_add(w, "%.4g kN/m; ",
                      o->load / acos(0) * contact->load * 1e-3);
}

/* The flow of oil at ambient density. */
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

bool ovr_absurd_friction(const ovr_run_info *s)
{
    return s->unbearable_share > 0 && !ovr_setup_heat(s->setup) &&
           s->setup->lubricant->rheology == OVR_NEWTONIAN;
}

/* Forces in ph b^2/R; coefficients where b/R is known. */
static void add_coefficients(ovr_words *w, const ovr_observation *o,
                             const ovr_contact *contact, int wide)
{
    if (isnan(o->mu_slide) && isfinite(o->mu_roll))
        ovr_words_add(w,
                      "not known (set boundary.friction); rolling of the film "
                      "%.4g",
                      o->mu_roll);
    else if (isnan(o->F_slide))
        ovr_words_add(w, "not known");
    else if (isfinite(contact->kappa))
        ovr_words_add(
            w, "%-*.4g sliding, %.4g rolling; on surface 1 %.4g, on 2 %.4g",
            wide, o->mu_slide, o->mu_roll, o->mu_1, o->mu_2);
    else
        ovr_words_add(w,
                      "%-*.4g sliding, %.4g rolling, in ph b^2/R; coefficients "
                      "need modulus or G",
                      wide, o->F_slide, o->F_roll);
}

/* Forces in N over a width. */
static void add_forces(ovr_words *w, const ovr_observation *o,
                       const ovr_contact *contact, int wide)
{
    double scale = ovr_kind_scale(OVR_KIND_FORCE, contact) * contact->width;
    if (isfinite(scale))
        ovr_words_add(w, "%-*.4g N on surface 1, %.4g N on 2, over the width",
                      wide, o->F_1 * scale, o->F_2 * scale);
}

static void say_friction(const ovr_told *to, const ovr_run_info *s)
{
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    const ovr_contact *contact = s->setup->contact;
    const char *label = isfinite(contact->kappa) ? "friction coeff."
                                                 : "friction";
    bool absurd = ovr_absurd_friction(s);
    int wide = absurd ? 0 : 12;
    ovr_words w = {""}, forces = {""};
    if (absurd)
        ovr_words_add(
            &w,
            "no oil has this friction, choose a rheology: a Newtonian "
            "film's stress is up to %.3g times the pressure, above a "
            "tenth of it in %.2g %% of the contact; ",
            s->shear_over_pressure, 100 * s->unbearable_share);
    add_coefficients(&w, o, contact, wide);
    add_forces(&forces, o, contact, wide);
    if (absurd && *forces.text)
        ovr_words_add(&w, "; %s", forces.text);
    ovr_tell(to, label, "%s", w.text);
    if (!absurd && *forces.text)
        ovr_tell(to, "friction force", "%s", forces.text);
}

/* ------------------------------------------------------ starvation and heat */

/* Says where the film begins, and how much of the flooded one it is; what a
 * flooded contact leaves of the supply. */
static void say_supply(const ovr_told *to, const ovr_run_info *s)
{
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    ovr_words w = {""};
    if (isnan(o->inflow))
        return;
    if (isfinite(o->starvation_factor))
        ovr_words_add(&w, "%-12.6g of the flooded film", o->starvation_factor);
    else
        ovr_words_add(&w, "%-12s the surfaces hardly move", "none:");
    if (isfinite(o->meniscus))
        ovr_words_place(&w, "; film begins at X", o->meniscus, OVR_KIND_LENGTH,
                        s->setup->contact);
    else if (o->supply > 1.01 * o->inflow && o->inflow > 0 &&
             isfinite(o->starvation_factor))
        ovr_words_add(&w, "; of what arrives it takes %.2g, the rest waits",
                      o->inflow / o->supply);
    ovr_tell(to, "starvation factor", "%s", w.text);
}

/* Largest temperatures, and how far the balance of energy is from closed. */
static void say_heat(const ovr_told *to, const ovr_run_info *s)
{
    const double zero = 273.15; /* degC in K */
    const ovr_observation *o = ovr_simulation_observation(s->sim);
    ovr_words w = {""};
    if (!ovr_setup_heat(s->setup))
        return;
    ovr_words_place(&w, " at X", o->X_T_film_max, OVR_KIND_LENGTH,
                    s->setup->contact);
    ovr_tell(to, "temperature", "%-12.4g degC in the film%s",
             o->T_film_max - zero, w.text);
    ovr_tell(to, "",
             "%.4g and %.4g degC on surfaces 1 and 2; energy closes to %.1e",
             o->T_1_max - zero, o->T_2_max - zero, o->energy_defect);
}

void ovr_say_conditions(const ovr_told *to, const ovr_run_info *s)
{
    say_supply(to, s);
    say_friction(to, s);
    say_heat(to, s);
}

/* ------------------------------------------------------------------ errors */

/* As the line is called that tells the number itself. */
static const char *label_of(const char *key)
{
    const ovr_observable *row;
    for (size_t k = 0; (row = ovr_observable_at(k)); k++) {
        if (row->key && row->label && !strcmp(row->key, key))
            return row->label;
        if (row->extreme_label && !strcmp(row->extreme_key, key))
            return row->extreme_label;
        if (row->mean_label && !strcmp(row->mean_key, key))
            return row->mean_label;
    }
    return key;
}

/* Relative, and in nm, um or MPa; of what does not converge only that. */
static void add_error(ovr_words *w, const ovr_run_error *e,
                      const ovr_contact *contact)
{
    const char *unit = e->kind == OVR_KIND_HEIGHT   ? "nm"
                       : e->kind == OVR_KIND_LENGTH ? "um"
                                                    : "MPa";
    double scale = ovr_kind_scale(e->kind, contact) * (*unit == 'n'   ? 1e9
                                                       : *unit == 'u' ? 1e6
                                                                      : 1e-6);
    const char *between = *w->text ? " " : "";
    if (!e->converges) {
        ovr_words_add(w, "%s%s does not converge with the level", between,
                      label_of(e->key));
        return;
    }
    ovr_words_add(w, "%s%s %.2g %%", between, label_of(e->key),
                  100 * e->error / fabs(e->value[0]));
    if (isfinite(scale))
        ovr_words_add(w, " (%.2g %s)", e->error * scale, unit);
}

/* Two a line. */
void ovr_say_errors(const ovr_told *to, const ovr_run_info *s)
{
    const ovr_run_errors *e = s->error;
    const char *label = "estimated errors";
    ovr_words w = {""};
    for (size_t k = 0; k < e->count; k++) {
        bool last = k + 1 == e->count;
        add_error(&w, &e->of[k], s->setup->contact);
        ovr_words_add(&w, last ? "" : ",");
        if (k % 2 || last) {
            ovr_tell(to, label, "%s", w.text);
            w.text[0] = '\0';
            label = "";
        }
    }
    bool steps = s->transient && !s->setup->march->adaptive;
    ovr_tell(to, label, "relative, from level %d%s%s", e->level,
             e->count && isfinite(e->of[0].value[2]) ? " and the one below it"
                                                     : "",
             steps ? ", steps longer with the mesh" : "");
}
