/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tells what a case means before it is solved: the numbers of its contact,
 * films by formula, its features, its grid and what it will cost. */
#include <math.h>
#include <string.h>

#include "case/setup.h"
#include "contact/contact.h"
#include "contact/film_formula.h"
#include "contact/oil.h"
#include "overroll/questions.h"
#include "run/cost.h"
#include "run/summary_lines.h"
#include "run/run.h"
#include "simulation/simulation.h"
#include "surface/surfaces.h"

/* " (1.2 um)", or nothing where the scale is not known. */
static ovr_piece in_metres(double value, double scale)
{
    ovr_piece piece = {""};
    if (isfinite(value) && isfinite(scale))
        snprintf(piece.text, sizeof piece.text, " (%.30s)",
                 ovr_metres(value * scale).text);
    return piece;
}

/* ------------------------------------------------------------------ radius */

/* Reduced radius and half width over the run, where it says how long that is.
 */
static void say_radius(const ovr_told *to, const ovr_setup *setup)
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
    ovr_tell(to, "radius in time",
             "%.4g to %.4g of the nominal one%s; half width %.3g to %.3g b",
             R[0], R[1], mm.text, b[0], b[1]);
    ovr_tell(to, "its curvature", "%s",
             setup->convected ? "is convected with the material"
                              : "is imposed");
}

/* ------------------------------------------------------------------- films */

static void say_film(const ovr_told *to, const char *label, double H,
                     const ovr_contact *contact)
{
    ovr_words um = {""};
    if (isfinite(contact->height))
        ovr_words_add(&um, " (%.4g um)", H * contact->height * 1e6);
    ovr_tell(to, label, "H = %.5g%s", H, um.text);
}

static void put_film(const ovr_told *to, const char *key, const char *label,
                     double H, const ovr_contact *contact)
{
    ovr_put_number(to, key, H);
    if (!isnan(H))
        say_film(to, label, H, contact);
}

static void put_films(const ovr_told *to, const ovr_contact *c)
{
    ovr_film_asymptotes film = ovr_film_asymptotes_moes(c->M, c->L);
    put_film(to, "H_cen_moes", "central film (Moes)",
             ovr_film_central_moes(c->M, c->L), c);
    ovr_tell_title(to, "of an incompressible oil; asymptotes of it:");
    put_film(to, "H_rigid_isoviscous", "  rigid, isoviscous", film.rigid_iso,
             c);
    put_film(to, "H_elastic_isoviscous", "  elastic, isoviscous",
             film.elastic_iso, c);
    put_film(to, "H_rigid_piezoviscous", "  rigid, piezoviscous",
             film.rigid_piezo, c);
    put_film(to, "H_elastic_piezoviscous", "  elastic, piezoviscous",
             film.elastic_piezo, c);
}

/* alpha, and alpha* beside it. */
static void put_alpha(const ovr_told *to, const ovr_setup *setup)
{
    double alpha = setup->contact->alpha;
    double star = ovr_asymptotic_alphabar(setup->lubricant) /
                  setup->contact->ph;
    ovr_put_number(to, "alpha_star_per_Pa", star);
    if (alpha > 0 && isfinite(star))
        ovr_tell(to, "alpha at p = 0",
                 "%.5g 1/GPa, asymptotic alpha* = %.5g 1/GPa", alpha * 1e9,
                 star * 1e9);
}

/* A fitted law speaks of the oil that it was fitted for alone. */
static void put_fit(const ovr_told *to, const ovr_setup *setup)
{
    const ovr_contact *c = setup->contact;
    const ovr_lubricant *oil = setup->lubricant;
    ovr_film_fit fit = {NAN, NAN};
    if (oil->viscosity_law == OVR_ROELANDS &&
        oil->density_law == OVR_DOWSON_HIGGINSON)
        fit = ovr_film_fitted(c->M, c->L, ovr_density(oil, 1));
    put_film(to, "H_cen_fit", "central film (fit)", fit.central, c);
    put_film(to, "H_min_fit", "minimum film (fit)", fit.minimum, c);
    if (!isnan(fit.central))
        ovr_tell_title(to,
                       "of a compressible oil, density %.4g at ph, flooded, "
                       "steady: to 2.6 and 1.7 %%",
                       ovr_density(oil, 1));
}

static void say_lubricant(const ovr_told *to, const ovr_lubricant *lubricant)
{
    static const char *const laws[] = {"", "Eyring", "Carreau", "Carreau",
                                       "flow law by table"};
    if (lubricant->viscosity_law == OVR_ROELANDS)
        ovr_tell(to, "Roelands", "z = %.6g, p0/ph = %.6g", lubricant->z,
                 lubricant->P0);
    if (lubricant->rheology != OVR_NEWTONIAN)
        ovr_tell(to, laws[lubricant->rheology], "tau0/(ph b/R) = %.6g",
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

/* Says where it comes in, passes and leaves, as far as that comes to pass. */
static void say_material_history(const ovr_told *to, const ovr_setup *setup,
                                 size_t k)
{
    const ovr_options *o = setup->options;
    double end = setup->march->end;
    ovr_feature_times t = ovr_surfaces_times(setup->surfaces, k, o->inlet,
                                             o->outlet, 1e5);
    const struct {
        const char *what;
        double T;
    } events[] = {{"enters", t.enters},
                  {"its centre passes X = 0", t.centre},
                  {"has left", t.leaves}};
    ovr_words w = {""};
    for (int i = 0; i < 3; i++)
        if (isfinite(events[i].T))
            ovr_words_add(&w, "%s%s at %s%s", *w.text ? ", " : "",
                          events[i].what,
                          at_time(events[i].T, setup->contact).text,
                          events[i].T > end ? " (after the end)" : "");
    if (*w.text)
        ovr_tell_title(to, "%s", w.text);
}

/* Speed over the mean one. */
static ovr_words motion(double speed)
{
    ovr_words w = {""};
    if (speed == 0)
        ovr_words_add(&w, "stands still");
    else if (fabs(speed - 1) < 1e-6)
        ovr_words_add(&w, "moves with the mean speed");
    else
        ovr_words_add(&w, "moves at %.4g of the mean speed", speed);
    return w;
}

static void say_feature(const ovr_told *to, const ovr_setup *setup, size_t k)
{
    ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
    const ovr_contact *c = setup->contact;
    ovr_words w = {""};
    ovr_words_add(&w, "feature %.100s: %s on surface %d, %s, height %.4g%s, ",
                  info.name, ovr_shape_name((int)info.shape), info.surface,
                  motion(info.speed).text, info.amplitude,
                  in_metres(info.amplitude, c->height).text);
    if (info.diameter > 0)
        ovr_words_add(&w, "diameter at half depth %.4g%s, ", info.diameter,
                      in_metres(info.diameter, c->b).text);
    ovr_words_add(&w, "%s wavelength %.4g%s, on %.4g nodes", info.wavelength_is,
                  info.wavelength, in_metres(info.wavelength, c->b).text,
                  info.wavelength / setup->mesh);
    ovr_tell(to, w.text, "%s", "");
    if (setup->transient)
        say_material_history(to, setup, k);
    for (const char *s = info.assumed; s && *s;) {
        size_t length = strcspn(s, "\n");
        ovr_tell_title(to, "%.*s", (int)length, s);
        s += length + (s[length] == '\n');
    }
}

/* What amplitude reduction says of them before they are run. */
static void put_rough_film(const ovr_told *to, const ovr_setup *setup,
                           const ovr_rough_film *film)
{
    const ovr_contact *c = setup->contact;
    if (!setup->features)
        return;
    ovr_put_rough_film(to, film, c);
    if (film->why) {
        ovr_tell(to, "film of rough surfaces", "no estimate: %s", film->why);
        return;
    }
    ovr_tell(to, "roughness of the film",
             "Rq = %.4g%s of %.4g%s on the surfaces", film->film_Rq,
             in_metres(film->film_Rq, c->height).text, film->Rq,
             in_metres(film->Rq, c->height).text);
    say_film(to, "smallest film", film->H_min, c);
    ovr_tell_title(to, "foreseen by amplitude reduction, of rolling waves: "
                       "both to 2 %%, seldom 12 %%, of Rq");
    ovr_tell_title(to, "and of the smooth minimum film");
    if (film->but)
        ovr_tell_title(to, "less sure here: %s", film->but);
}

/* ----------------------------------------------------------- grid and cost */

/* Bodies that roll one behind the other. */
static void say_bodies(const ovr_told *to, const ovr_setup *setup)
{
    const ovr_passes_setup *p = setup->passes;
    const ovr_contact *c = setup->contact;
    const double speed = p->again == 2 ? c->u2_ratio : c->u1_ratio;
    double way = p->spacing / speed, maximum = 0;
    for (size_t k = 0; k < p->loads.count; k++)
        maximum = fmax(maximum, p->loads.values[k]);
    if (maximum > 0)
        ovr_tell(to, "load zone", "%.4g of the nominal load at most", maximum);
    if (isfinite(way))
        ovr_tell(to, "rolling bodies", "%.4g%s behind each other, %s",
                 p->spacing, in_metres(p->spacing, c->b).text,
                 at_time(way, c).text);
    if (isfinite(p->recovery))
        ovr_tell(to, "oil that flows back",
                 "%.3g %% of what lacks to a flooded layer, in that time",
                 100 * -expm1(-way / p->recovery));
}

static void say_grid(const ovr_told *to, const ovr_setup *setup,
                     const ovr_cost *cost)
{
    const char *const of[] = {"H_cen", "H_min", "what the features do",
                              "both films and the friction"};
    const ovr_options *o = setup->options;
    ovr_tell(to, "grid", "level %d, %.0f nodes, mesh D = %.6g%s, X = %g to %g",
             o->level, cost->nodes, cost->mesh,
             in_metres(cost->mesh, setup->contact->b).text, o->inlet,
             o->outlet);
    if (o->refine && o->refine_level)
        ovr_tell(to, "patches", "about the spike, to level %d, mesh %.3g",
                 o->refine_level,
                 ldexp(cost->mesh, o->level - o->refine_level));
    else if (o->refine)
        ovr_tell(to, "patches",
                 "about the spike, until its height changes by less than %g",
                 o->refine_change);
    ovr_tell(to, "error of discretization", "%.1g of %s is to be expected",
             setup->expected, of[setup->accuracy_of]);
    if (setup->expected <= setup->accuracy)
        ovr_tell(to, "level", "%d is the first on which that is below %g%s",
                 o->level, setup->accuracy,
                 setup->confirm ? ", confirmed after the run" : "");
}

/* Its length, and where the program chose it, why. */
static void say_step(const ovr_told *to, const ovr_setup *setup)
{
    double dT = ovr_setup_step(setup), meshes = dT / setup->mesh;
    const char *why = ovr_setup_step_reason(setup);
    if (setup->march->adaptive)
        ovr_tell(to, "time step", "by the error of the steps, %g is the target",
                 setup->march->error);
    else
        ovr_tell(to, "time step", "%.6g, %.3g %s%s%s", dT, meshes,
                 meshes == 1 ? "mesh" : "meshes", why ? ": " : "",
                 why ? why : "");
}

static void say_cost(const ovr_told *to, const ovr_setup *setup,
                     const ovr_cost *cost)
{
    if (cost->passes > 1) {
        ovr_tell(to, "passes",
                 "%.0f, a run and a result file each; all below is of one but "
                 "for the disk and the seconds",
                 cost->passes);
        say_bodies(to, setup);
    }
    if (cost->steps > 0) {
        say_step(to, setup);
        ovr_tell(to, "steps", "%s%.0f",
                 setup->march->until_steady || setup->march->adaptive
                     ? "at most "
                     : "",
                 cost->steps);
        ovr_tell(to, "snapshots", "%.0f, at most %.3g MB on the disk",
                 cost->stored.snapshots, cost->stored.bytes / 1e6);
    }
    ovr_tell(to, "cost", "about %.2g s and %.3g MB of memory", cost->seconds,
             cost->bytes / 1e6);
}

static void put_cost(const ovr_told *to, const ovr_setup *setup,
                     const ovr_cost *cost)
{
    const ovr_options *options = setup->options;
    ovr_put_count(to, "level", options->level);
    ovr_put_number(to, "nodes", cost->nodes);
    ovr_put_number(to, "mesh", cost->mesh);
    ovr_put_number(to, "expected_error", setup->expected);
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

static void put_formulas(const ovr_told *to, const ovr_setup *setup)
{
    ovr_put_contact(to, setup->contact, true);
    say_radius(to, setup);
    put_films(to, setup->contact);
    put_alpha(to, setup);
    put_fit(to, setup);
    say_lubricant(to, setup->lubricant);
}

void ovr_setup_scales(const ovr_setup *setup, ovr_summary_taker *take,
                      void *data)
{
    ovr_told all = {take, data};
    const ovr_told keyed = {ovr_put_keyed, &all};
    if (setup && take)
        put_formulas(&keyed, setup);
}

ovr_status ovr_setup_report(const ovr_setup *setup, double live,
                            ovr_summary_taker *take, void *data, ovr_error *err)
{
    const ovr_told to = {take, data};
    ovr_rough_film film;
    if (!setup || !take)
        return ovr_fail_null(err, __func__);
    if (!(live >= 0) || isinf(live))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "ovr_setup_report: live = %g is no "
                        "number of bytes",
                        live);
    const ovr_cost cost = ovr_setup_cost(setup, live);
    ovr_status status = ovr_setup_rough_film(setup, NULL, &film, err);
    if (status)
        return status;
    put_formulas(&to, setup);
    for (size_t k = 0, n = ovr_surfaces_count(setup->surfaces); k < n; k++)
        say_feature(&to, setup, k);
    put_rough_film(&to, setup, &film);
    say_grid(&to, setup, &cost);
    say_cost(&to, setup, &cost);
    put_cost(&to, setup, &cost);
    return OVR_OK;
}
