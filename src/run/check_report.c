/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reports operating conditions, predicted film thickness, features, grid and
 * cost of a case before it is solved. */
#include <math.h>
#include <string.h>

#include "case/accuracy.h"
#include "case/domain.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/film_formula.h"
#include "contact/oil.h"
#include "contact/starvation.h"
#include "elements/run_element.h"
#include "overroll/profile.h"
#include "overroll/questions.h"
#include "physics/heat/heat.h"
#include "run/cost.h"
#include "run/run.h"
#include "run/summary_lines.h"
#include "simulation/simulation.h"
#include "surface/surfaces.h"

/* " (1.2 um)", or nothing if the scale is unknown. */
static ovr_piece in_metres(double value, double scale)
{
    ovr_piece piece = {""};
    if (isfinite(value) && isfinite(scale))
        snprintf(piece.text, sizeof piece.text, " (%.30s)",
                 ovr_metres(value * scale).text);
    return piece;
}

/* ------------------------------------------------------------------ radius */

/* Ranges of reduced radius and half-width over a run with a known end. */
static void report_radius(const ovr_report_sink *to, const ovr_setup *setup)
{
    enum { LOOKS = 1000 };
    const ovr_contact *contact = setup->contact;
    double R[2] = {INFINITY, 0}, b[2] = {INFINITY, 0};
    ovr_words mm = {""};
    if (!ovr_history_varies(setup->radius) || !isfinite(setup->march->end))
        return;
    for (int k = 0; k <= LOOKS; k++) {
        double T = setup->march->end * k / LOOKS;
        double r = ovr_history_value(setup->radius, T);
        double half = sqrt(ovr_history_value(setup->load, T) * r);
        R[0] = fmin(R[0], r);
        R[1] = fmax(R[1], r);
        b[0] = fmin(b[0], half);
        b[1] = fmax(b[1], half);
    }
    if (isfinite(contact->radius))
        ovr_words_add(&mm, ", %.4g to %.4g mm", R[0] * contact->radius * 1e3,
                      R[1] * contact->radius * 1e3);
    ovr_report_line(
        to, "radius over the run",
        "%.4g to %.4g of the reference%s; half-width %.3g to %.3g b", R[0],
        R[1], mm.text, b[0], b[1]);
    ovr_report_line(to, "curvature model", "%s",
                    setup->convected ? "convected with the material"
                                     : "imposed");
}

/* ------------------------------------------------------------------- films */

static ovr_words film_text(double H, const ovr_contact *contact)
{
    ovr_words w = {""};
    ovr_words_add(&w, "H = %.5g", H);
    if (isfinite(contact->height))
        ovr_words_add(&w, " (%s)", ovr_metres(H * contact->height).text);
    return w;
}

static void report_asymptote(const ovr_report_sink *to, const char *key,
                             const char *label, double H, const ovr_contact *c)
{
    ovr_put_number(to, key, H);
    if (!isnan(H))
        ovr_report_detail(to, label, "%s", film_text(H, c).text);
}

/* Prints the predicted film thicknesses. The summary contains Moes' formula
 * only if the fitted formula is not valid. */
static void report_films(const ovr_report_sink *to, const ovr_contact *c,
                         bool fitted)
{
    ovr_film_asymptotes film = ovr_film_asymptotes_moes(c->M, c->L);
    double central = ovr_film_central_moes(c->M, c->L);
    ovr_report_title(to, "Predicted film thickness (smooth, steady, fully "
                         "flooded)");
    ovr_put_number(to, "H_cen_moes", central);
    if (!isnan(central))
        (fitted ? ovr_report_detail : ovr_report_line)(
            to, "central film thickness, Moes", "%s, incompressible",
            film_text(central, c).text);
    report_asymptote(to, "H_rigid_isoviscous", "  rigid-isoviscous asymptote",
                     film.rigid_iso, c);
    report_asymptote(to, "H_elastic_isoviscous",
                     "  elastic-isoviscous asymptote", film.elastic_iso, c);
    report_asymptote(to, "H_rigid_piezoviscous",
                     "  rigid-piezoviscous asymptote", film.rigid_piezo, c);
    report_asymptote(to, "H_elastic_piezoviscous",
                     "  elastic-piezoviscous asymptote", film.elastic_piezo, c);
}

/* Prints alpha and the asymptotic alpha*. */
static void report_alpha(const ovr_report_sink *to, const ovr_setup *setup)
{
    double alpha = setup->contact->alpha;
    double star = ovr_asymptotic_alphabar(setup->lubricant) /
                  setup->contact->ph;
    ovr_put_number(to, "alpha_star_per_Pa", star);
    if (alpha > 0 && isfinite(star))
        ovr_report_detail(to, "alpha at p = 0",
                          "%.5g 1/GPa, asymptotic alpha* = %.5g 1/GPa",
                          alpha * 1e9, star * 1e9);
}

static void report_fit(const ovr_report_sink *to, const char *label, double H,
                       const char *accuracy, const ovr_contact *c)
{
    if (!isnan(H))
        ovr_report_line(to, label, "%s, within %s", film_text(H, c).text,
                        accuracy);
}

/* Prints the ratio of the predicted minimum film thickness to contact.Rq_1 and
 * Rq_2. */
static void report_lambda_ratio(const ovr_report_sink *to,
                                const ovr_setup *setup, double minimum)
{
    if (!(setup->Rq > 0))
        return;
    ovr_put_number(to, "lambda_ratio_predicted", minimum / setup->Rq);
    if (!isnan(minimum))
        ovr_report_line(to, "lambda ratio",
                        "%.3g (predicted minimum film thickness / Rq%s of "
                        "contact.Rq_1 and contact.Rq_2)",
                        minimum / setup->Rq,
                        in_metres(setup->Rq, setup->contact->height).text);
}

/* Returns the film thickness by the fitted formula, or none if the formula is
 * not valid for the lubricant's models. */
static ovr_film_fit fit_of(const ovr_setup *setup)
{
    const ovr_contact *c = setup->contact;
    const ovr_lubricant *oil = setup->lubricant;
    ovr_film_fit none = {NAN, NAN};
    return oil->viscosity_law == OVR_ROELANDS &&
                   oil->density_law == OVR_DOWSON_HIGGINSON
               ? ovr_film_fitted(c->M, c->L, ovr_density(oil, 1))
               : none;
}

static void report_fitted(const ovr_report_sink *to, const ovr_setup *setup,
                          ovr_film_fit fit)
{
    const ovr_contact *c = setup->contact;
    ovr_put_number(to, "H_cen_fit", fit.central);
    ovr_put_number(to, "H_min_fit", fit.minimum);
    report_fit(to, "central film thickness, overroll fit", fit.central, "2.6 %",
               c);
    report_fit(to, "minimum film thickness, overroll fit", fit.minimum, "1.7 %",
               c);
    if (!isnan(fit.central))
        ovr_report_detail(to, "  compressible lubricant",
                          "relative density %.4g at p_h",
                          ovr_density(setup->lubricant, 1));
    report_lambda_ratio(to, setup, fit.minimum);
}

static void report_lubricant(const ovr_report_sink *to,
                             const ovr_lubricant *lubricant)
{
    static const char *const laws[] = {"", "Eyring", "Carreau", "Carreau",
                                       "flow law by table"};
    if (lubricant->viscosity_law == OVR_ROELANDS)
        ovr_report_detail(to, "Roelands", "z = %.6g, p0/ph = %.6g",
                          lubricant->z, lubricant->P0);
    if (lubricant->rheology != OVR_NEWTONIAN)
        ovr_report_detail(to, laws[lubricant->rheology], "tau0/(ph b/R) = %.6g",
                          lubricant->Sigma0);
}

/* ---------------------------------------------------------------- features */

static ovr_words at_time(double T, const ovr_contact *contact)
{
    const double rounding = 1e-12;
    ovr_words w = {""};
    ovr_words_place(&w, "T", fabs(T) < rounding ? 0 : T, OVR_KIND_TIME,
                    contact);
    return w;
}

/* Prints when a feature passes X = 0; in the complete list also when it enters
 * the contact and leaves. */
static void report_times(const ovr_report_sink *to, const ovr_setup *setup,
                         size_t k)
{
    const ovr_options *o = setup->options;
    double end = setup->march->end;
    ovr_feature_times t = ovr_surfaces_times(setup->surfaces, k, o->inlet,
                                             o->outlet, 1e5);
    const struct {
        const char *what;
        double T;
    } events[] = {{"  enters the contact at", t.enters},
                  {"  centre at X = 0 at", t.centre},
                  {"  leaves the contact at", t.leaves}};
    for (int i = 0; i < 3; i++)
        if (isfinite(events[i].T))
            (i == 1 ? ovr_report_line : ovr_report_detail)(
                to, events[i].what, "%s%s",
                at_time(events[i].T, setup->contact).text,
                events[i].T > end ? " (after the end)" : "");
}

static void report_feature(const ovr_report_sink *to, const ovr_setup *setup,
                           size_t k)
{
    ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
    const ovr_contact *c = setup->contact;
    ovr_words w = {""};
    if (info.speed == 0)
        ovr_words_add(&w, "stationary");
    else
        ovr_words_add(&w, "u = %.4g u_m", info.speed);
    ovr_report_title(to, "Feature %.100s: %s on surface %d, %s", info.name,
                     ovr_shape_name((int)info.shape), info.surface, w.text);
    ovr_report_line(to, info.diameter > 0 ? "  depth" : "  height", "%.4g%s",
                    info.amplitude, in_metres(info.amplitude, c->height).text);
    if (info.diameter > 0)
        ovr_report_detail(to, "  diameter at half depth", "%.4g%s",
                          info.diameter, in_metres(info.diameter, c->b).text);
    ovr_words label = {""};
    ovr_words_add(&label, "  %s wavelength", info.wavelength_is);
    ovr_report_line(to, label.text, "%.4g%s, %.4g nodes", info.wavelength,
                    in_metres(info.wavelength, c->b).text,
                    info.wavelength / setup->mesh);
    if (setup->transient)
        report_times(to, setup, k);
    for (const char *s = info.assumed; s && *s;) {
        size_t length = strcspn(s, "\n");
        ovr_report_line(to, "  assumed", "%.*s", (int)length, s);
        s += length + (s[length] == '\n');
    }
}

/* Prints the film thickness of rough surfaces as predicted by amplitude
 * reduction. */
static void report_rough_film(const ovr_report_sink *to, const ovr_setup *setup,
                              const ovr_rough_film *film)
{
    const ovr_contact *c = setup->contact;
    if (!setup->features)
        return;
    ovr_put_rough_film(to, film, c);
    ovr_report_title(to, "Predicted film of the rough surfaces (amplitude "
                         "reduction)");
    if (film->why) {
        ovr_report_line(to, "film thickness roughness Rq", "no prediction: %s",
                        film->why);
        return;
    }
    double composite = ovr_surfaces_roughness(setup->surfaces);
    ovr_report_line(to, "film thickness roughness Rq",
                    "%.4g%s; surfaces: %.4g%s, largest in |X| < %g",
                    film->film_Rq, in_metres(film->film_Rq, c->height).text,
                    film->Rq, in_metres(film->Rq, c->height).text,
                    OVR_ROUGH_WINDOW);
    if (composite > 0)
        ovr_report_line(to, "composite Rq of the surfaces",
                        "%.4g%s, over their whole length", composite,
                        in_metres(composite, c->height).text);
    if (film->H_min > 0)
        ovr_report_line(to, "minimum film thickness", "%s%s%s",
                        film_text(film->H_min, c).text,
                        film->but ? "; less certain: " : "",
                        film->but ? film->but : "");
    else
        ovr_report_line(to, "minimum film thickness",
                        "no prediction: the predicted roughness is as high as "
                        "the film thickness");
    if (!film->but)
        ovr_report_detail(to, "accuracy",
                          "within 2 %% (half the cases), 12 %% at most");
}

/* ----------------------------------------------------------- grid and cost */

/* Spacing, loads and replenishment of successive rolling bodies. */
static void report_bodies(const ovr_report_sink *to, const ovr_setup *setup)
{
    const ovr_passes_setup *p = setup->passes;
    const ovr_contact *c = setup->contact;
    const double speed = p->again == 2 ? c->u2_ratio : c->u1_ratio;
    double period = p->spacing / speed, maximum = 0;
    for (size_t k = 0; k < p->loads.count; k++)
        maximum = fmax(maximum, p->loads.values[k]);
    if (maximum > 0)
        ovr_report_line(to, "load zone", "%.4g of the reference load at most",
                        maximum);
    if (isfinite(period))
        ovr_report_line(to, "roller spacing", "%.4g%s, %s", p->spacing,
                        in_metres(p->spacing, c->b).text,
                        at_time(period, c).text);
    if (isfinite(p->recovery))
        ovr_report_line(
            to, "replenishment",
            "%.3g %% of the missing layer is replenished between two "
            "rollers",
            100 * -expm1(-period / p->recovery));
}

/* Ends of the domain; a detail unless the inlet was chosen automatically and is
 * further upstream than usual. */
static void report_domain(const ovr_report_sink *to, const ovr_setup *setup)
{
    const ovr_options *o = setup->options;
    const ovr_contact *c = setup->contact;
    const ovr_slot *inlet = ovr_slot_of(setup->resolved, "domain", "inlet");
    double loss = ovr_inlet_loss(c->M, c->L, OVR_USUAL_INLET);
    if (!inlet->word || inlet->number != 0 || o->inlet >= OVR_USUAL_INLET)
        ovr_report_detail(to, "domain", "X = %.4g to %.4g", o->inlet,
                          o->outlet);
    else if (ovr_setup_needs(setup).varies)
        ovr_report_line(to, "domain",
                        "X = %.4g to %.4g; inlet upstream of X = %g for all "
                        "film thicknesses and half-widths of the histories",
                        o->inlet, o->outlet, OVR_USUAL_INLET);
    else
        ovr_report_line(to, "domain",
                        "X = %.4g to %.4g; an inlet at X = %g would reduce the "
                        "central film thickness by %s%.2g %%",
                        o->inlet, o->outlet, OVR_USUAL_INLET,
                        loss < 0.2 ? "" : "more than ", 100 * fmin(loss, 0.2));
}

static void report_grid(const ovr_report_sink *to, const ovr_setup *setup,
                        const ovr_cost *cost)
{
    const char *const of[] = {
        "central film thickness", "minimum film thickness",
        "effect of the features", "central and minimum film thickness"};
    const ovr_options *o = setup->options;
    const char *friction = setup->accuracy_of != OVR_ACCURACY_ALL ? ""
                           : ovr_expects_friction(setup)
                               ? ", friction"
                               : "; not the friction of a Newtonian lubricant, "
                                 "which depends on the pressure spike";
    ovr_report_title(to, "Numerics");
    ovr_report_line(to, "grid", "level %d, %.0f nodes, mesh size D = %.6g%s",
                    o->level, cost->nodes, cost->mesh,
                    in_metres(cost->mesh, setup->contact->b).text);
    report_domain(to, setup);
    if (o->refine && o->refine_level)
        ovr_report_line(to, "local refinement",
                        "at the pressure spike, to level %d, mesh size %.3g",
                        o->refine_level,
                        ldexp(cost->mesh, o->level - o->refine_level));
    else if (o->refine)
        ovr_report_line(
            to, "local refinement",
            "at the pressure spike, until its height changes by less than "
            "%g",
            o->refine_change);
    ovr_report_line(
        to, "expected discretization error", "%.1g at most (%s%s%s)",
        ovr_expected_at_most(setup), of[setup->accuracy_of], friction,
        ovr_setup_heat(setup) ? "; 0.01 of the maximum film temperature rise"
                              : "");
    if (setup->expected <= setup->accuracy)
        ovr_report_line(to, "level",
                        "%d, the first with a likely error below %g%s",
                        o->level, setup->accuracy,
                        setup->confirm ? ", confirmed after the run" : "");
}

/* The time step, with the reason if it was chosen automatically. */
static void report_step(const ovr_report_sink *to, const ovr_setup *setup)
{
    double dT = ovr_setup_step(setup), meshes = dT / setup->mesh;
    const char *why = ovr_setup_step_reason(setup);
    if (setup->march->adaptive)
        ovr_report_line(to, "time step", "adaptive, target error %g",
                        setup->march->error);
    else
        ovr_report_detail(to, "time step", "%.6g = %.3g D%s%s", dT, meshes,
                          why ? ": " : "", why ? why : "");
}

static void report_cost(const ovr_report_sink *to, const ovr_setup *setup,
                        const ovr_cost *cost)
{
    ovr_words disk = {""};
    if (cost->passes > 1) {
        ovr_report_line(
            to, "passes",
            "%.0f, a run and a result file each; time steps are counted "
            "per pass, the cost includes all passes",
            cost->passes);
        report_bodies(to, setup);
    }
    if (cost->steps > 0) {
        report_step(to, setup);
        ovr_report_line(to, "time steps", "%s%.0f",
                        setup->march->until_steady || setup->march->adaptive
                            ? "at most "
                            : "",
                        cost->steps);
        ovr_report_detail(to, "snapshots", "%.0f, up to %.3g MB on disk",
                          cost->stored.snapshots, cost->stored.bytes / 1e6);
        ovr_words_add(&disk, ", up to %.3g MB on disk",
                      cost->stored.bytes / 1e6);
    }
    ovr_report_line(to, "estimated cost", "%.2g s, %.3g MB of memory%s",
                    cost->seconds, cost->bytes / 1e6, disk.text);
}

static void report_grid_cost(const ovr_report_sink *to, const ovr_setup *setup,
                             const ovr_cost *cost)
{
    const ovr_options *options = setup->options;
    ovr_put_count(to, "level", options->level);
    ovr_put_number(to, "nodes", cost->nodes);
    ovr_put_number(to, "mesh", cost->mesh);
    ovr_put_number(to, "expected_error", ovr_expected_at_most(setup));
    ovr_put_number(to, "likely_error", setup->expected);
    ovr_put_number(to, "inlet", options->inlet);
    ovr_put_number(to, "outlet", options->outlet);
    ovr_put_text(to, "scheme", ovr_scheme_name(options->scheme));
    ovr_put_text(to, "smoother", ovr_smoother_name(options->smoother));
    ovr_put(to, "transient", OVR_SUMMARY_FLAG, setup->transient);
    ovr_put_number(to, "passes", cost->passes);
    ovr_put_number(to, "time_step",
                   setup->transient && !setup->march->adaptive
                       ? ovr_setup_step(setup)
                       : NAN);
    ovr_put_number(to, "steps", cost->steps);
    ovr_put_number(to, "snapshots", cost->stored.snapshots);
    ovr_put_number(to, "disk_bytes", cost->stored.bytes);
    ovr_put_number(to, "memory_bytes", cost->bytes);
    ovr_put_number(to, "estimated_seconds", cost->seconds);
}

static void report_formulas(const ovr_report_sink *to, const ovr_setup *setup)
{
    const ovr_film_fit fit = fit_of(setup);
    ovr_report_title(to, "Operating conditions");
    ovr_put_contact(to, setup->contact, true);
    report_alpha(to, setup);
    report_lubricant(to, setup->lubricant);
    report_radius(to, setup);
    ovr_report_element(to, setup);
    /* Films of a contact that never occurs are not printed. */
    ovr_report_sink all = *to;
    const ovr_report_sink keyed = {ovr_put_keyed, &all};
    const ovr_report_sink *films = ovr_reference_is_scale(setup) ? &keyed : to;
    report_films(films, setup->contact, !isnan(fit.central));
    report_fitted(films, setup, fit);
}

void ovr_setup_scales(const ovr_setup *setup, ovr_summary_taker *take,
                      void *data)
{
    ovr_report_sink all = {take, data};
    const ovr_report_sink keyed = {ovr_put_keyed, &all};
    if (setup && take)
        report_formulas(&keyed, setup);
}

ovr_status ovr_setup_report(const ovr_setup *setup, double live, double peak,
                            ovr_summary_taker *take, void *data, ovr_error *err)
{
    const ovr_report_sink to = {take, data};
    ovr_rough_film film;
    if (!setup || !take)
        return ovr_fail_null(err, __func__);
    if (!(live >= 0) || isinf(live))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "ovr_setup_report: live = %g must be a number of "
                        "bytes",
                        live);
    if (!(peak >= 0) || isinf(peak))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "ovr_setup_report: peak = %g must be a number of "
                        "bytes",
                        peak);
    const ovr_cost cost = ovr_setup_cost(setup, live, peak);
    ovr_status status = ovr_setup_rough_film(setup, NULL, &film, err);
    if (status)
        return status;
    report_formulas(&to, setup);
    for (size_t k = 0, n = ovr_surfaces_count(setup->surfaces); k < n; k++)
        report_feature(&to, setup, k);
    report_rough_film(&to, setup, &film);
    report_grid(&to, setup, &cost);
    report_cost(&to, setup, &cost);
    report_grid_cost(&to, setup, &cost);
    return OVR_OK;
}
