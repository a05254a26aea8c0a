/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sections [stress] and [fatigue] and their keys. */
#include "physics/stress/stress.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/rows.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "simulation/conflicts.h"
#include "stress/stress.h"

#define AT(field) offsetof(ovr_stress_setup, field)

static const ovr_word which_surface[] = {
    {"1", 1}, {"2", 2}, {"both", 3}, {NULL, 0}};
static const ovr_word tractions[] = {{"auto", OVR_TRACTION_AUTO},
                                     {"yes", OVR_TRACTION_YES},
                                     {"no", OVR_TRACTION_NO},
                                     {NULL, 0}};
static const ovr_word feature_window[] = {{"feature", 0}, {NULL, 0}};
static const ovr_word stress_fields[] = {
    {"sigma_x", 0}, {"sigma_z", 0},     {"tau_xz", 0},
    {"sigma_y", 0}, {"von_mises", 0},   {"max_shear", 0},
    {"tresca", 0},  {"hydrostatic", 0}, {NULL, 0}};
static const ovr_word criteria[] = {
    {"circle", OVR_CRITERION_CIRCLE},
    {"orthogonal", OVR_CRITERION_ORTHOGONAL},
    {"critical-plane", OVR_CRITERION_CRITICAL_PLANE},
    {"dang-van", OVR_CRITERION_DANG_VAN},
    {"von-mises", OVR_CRITERION_VON_MISES},
    {"tresca", OVR_CRITERION_TRESCA},
    {NULL, 0}};
static const ovr_word no_limit[] = {{"none", 0}, {NULL, 0}};
static const ovr_word risk_exponents[] = {{"31/3", 31. / 3}, {NULL, 0}};
static const ovr_word depth_exponents[] = {{"7/3", 7. / 3}, {NULL, 0}};
static const ovr_word weibull_slopes[] = {
    {"9/8", 9. / 8}, {"10/9", 10. / 9}, {NULL, 0}};
static const ovr_word auto_zero[] = {{"auto", 0}, {NULL, 0}};

static const ovr_parameter stress_keys[] = {
    {"surface", CHOICE(which_surface), NULL, AT(surfaces), true, ALWAYS,
     "surface below which stresses are computed; default with this section: 1"},
    {"depth_min", LENGTH_OR(auto_zero, 1e-9, 1e3), "auto", AT(depth_min), true,
     ALWAYS,
     "minimum depth of the stress history; auto: 4 D, in steady contacts "
     "at most half the outer layer"},
    {"depth_max", LENGTH(1e-6, 1e3), "2.5", AT(depth_max), true, ALWAYS,
     "largest depth"},
    {"depths_per_octave", PLAIN(1, 100), "5", AT(per_octave), true, ALWAYS,
     "depths, geometric"},
    {"every", WHOLE(0, 1000000000), "0", AT(every), true, ALWAYS,
     "store stress fields at every Nth snapshot; 0: none"},
    {"fields", WORDS(stress_fields), "sigma_x, sigma_z, tau_xz", AT(fields),
     true, "every > 0", "stress fields to store"},
    {"window", LIST(OVR_LENGTH, OVR_IN_B, -1e6, 1e6, feature_window), "feature",
     AT(window), true, ALWAYS,
     "range of material whose stress history is stored, FROM, TO relative to "
     "the centre of the first feature; feature: the features of the surface "
     "and 2 b beyond"},
    {"traction", CHOICE(tractions), "auto", AT(loads), true, ALWAYS,
     "shear stress of the film as a surface load in addition to the pressure; "
     "auto: with a rheological model or limiting_shear, if b/R is known"},
};

static const ovr_parameter fatigue_keys[] = {
    {"criterion", CHOICE(criteria), "circle", AT(criterion), false, ALWAYS,
     "amplitude of the fatigue criterion: radius of the minimum circumscribed "
     "circle of the shear stress path, half range of the orthogonal shear "
     "stress, half range on the critical plane, Dang Van's criterion with one "
     "line, or static maxima"},
    {"alpha", PLAIN(0, 1), "0.3", AT(alpha), false,
     "criterion = circle | dang-van",
     "factor of the hydrostatic stress; circle: in tension only"},
    {"limit_pressure", STRESS(no_limit, 0, 1e9), "1.5 GPa", AT(limit_pressure),
     false, ALWAYS,
     "fatigue limit, as maximum Hertzian pressure of a smooth contact"},
    {"limit_table", PATH, NULL, AT(limit_table), true, ALWAYS,
     "file of depth and limiting amplitude, of hardened bodies, instead of "
     "limit_pressure; its first line names the units, 'depth [um], limit "
     "[MPa]'"},
    {"exponent", PLAIN_OR(risk_exponents, 1, 100), "31/3", AT(life.exponent),
     false, ALWAYS, "exponent c of the amplitude in the risk"},
    {"depth_exponent", PLAIN_OR(depth_exponents, 0, 10), "7/3",
     AT(life.depth_exponent), false, ALWAYS,
     "exponent h of the depth in the risk"},
    {"weibull", PLAIN_OR(weibull_slopes, 0.1, 10), "9/8", AT(life.weibull),
     false, ALWAYS, "Weibull slope e"},
    {"least_depth", LENGTH_OR(auto_zero, 1e-9, 1e3), "auto",
     AT(life.least_depth), true, ALWAYS,
     "minimum depth for risk and maxima; auto: 8 D"},
    {"raceway", OVR_NUMBER, OVR_LENGTH, OVR_IN_B, 0, 1e9, false, .words = NULL,
     "0", AT(raceway), false, ALWAYS,
     "length of the raceway, for the ratio of lives; 0: no ratio; default "
     "with [roller_bearing]: its circumference"},
    {"count", PLAIN(0, 1e9), "1", AT(count), false,
     "raceway or roller_bearing.rollers",
     "number of such groups of features on the raceway"},
    {"residual_x", STRESS(NULL, -10, 10), "0", AT(residual_x), true,
     "no residual_table",
     "residual stress along the surface, tension positive"},
    {"residual_y", STRESS(NULL, -10, 10), "0", AT(residual_y), true,
     "no residual_table", "residual stress across"},
    {"residual_table", PATH, NULL, AT(residual_table), true, ALWAYS,
     "file of depth and residual stress (equal along and across) of hardened "
     "bodies, below their layers; its first line names the units, 'depth "
     "[um], stress [MPa]'"},
};

const ovr_section ovr_stress_sections[2] = {
    {.name = "stress",
     .whole = true,
     .help = "stresses below a surface, computed if this section is present",
     ROWS(stress_keys)},
    {.name = "fatigue",
     .whole = true,
     .help = "fatigue of the material; needs [stress]",
     ROWS(fatigue_keys)}};

ovr_status ovr_window_resolve(const ovr_list *window, const char *about,
                              double *from, double *to, ovr_error *err)
{
    *from = *to = NAN;
    if (!window->count)
        return OVR_OK;
    if (window->count != 2 || !(window->values[0] < window->values[1]))
        return ovr_fail_about(err, about,
                              "window: must be FROM, TO with FROM below TO");
    *from = window->values[0];
    *to = window->values[1];
    return OVR_OK;
}

/* Checks that the surface moves: a stationary surface has no stress history. A
 * surface with variable speed may start moving later, but must not be at rest
 * at the start. */
static ovr_status check_motion(const ovr_physics_case *of,
                               const ovr_stress_setup *s, ovr_error *err)
{
    double ratio[] = {of->contact->u1_ratio, of->contact->u2_ratio};
    double Cu = ovr_history_value(of->speed, 0);
    bool given = of->given(of->data, "stress", "surface");
    for (int k = 0; of->sliding && Cu != 0 && k < 2; k++)
        ratio[k] = Cu + (k ? -0.5 : 0.5) * ovr_history_value(of->sliding, 0);
    for (int k = 0; k < 2; k++)
        if (s->surfaces >> k & 1 && ratio[k] == 0)
            return ovr_fail_about(
                err, given ? "stress.surface" : "stress",
                "%s: surface %d does not move, so that its material does not "
                "pass the contact; use the other surface",
                given ? "surface" : "[stress]", k + 1);
    return OVR_OK;
}

static ovr_status check_depths(const ovr_two_columns *c, const char *file,
                               bool limits, ovr_error *err)
{
    if (!c->count)
        ovr_fail_at(
            err, OVR_BAD_INPUT, file, 0,
            "has no points: it needs at least one line of depth and value");
    for (size_t k = 0; k < c->count; k++)
        if ((limits && !(c->y[k] > 0)) || !(c->x[k] >= 0)) {
            ovr_fail_at(err, OVR_BAD_INPUT, file, c->line[k],
                        "depths must be at least 0%s",
                        limits ? ", and limits must be above 0" : "");
            break;
        }
    if (err->status)
        err->about = OVR_HAS_PLACE;
    return err->status;
}

/* Reads a table over depth from the file given by a key, in p_h and b. */
static ovr_status read_depths(const ovr_physics_case *of, const char *key,
                              const char *file, ovr_two_columns *c,
                              ovr_error *err)
{
    const ovr_contact *contact = of->contact;
    bool limits = !strcmp(c->name[1], "limit");
    const char *qualified = limits ? "fatigue.limit_table"
                                   : "fatigue.residual_table";
    if (!isfinite(contact->b) || !isfinite(contact->ph))
        return ovr_fail_about(
            err, qualified,
            "%s: needs a case with dimensions, because b and p_h are unknown",
            key);
    ovr_status status = of->read(of->data, key, file, c, err);
    if (!status)
        status = check_depths(c, file, limits, err);
    for (size_t k = 0; !status && k < c->count; k++) {
        c->x[k] /= contact->b;
        c->y[k] /= contact->ph;
    }
    return status;
}

static ovr_status resolve_residual(const ovr_physics_case *of,
                                   ovr_stress_setup *s, ovr_error *err)
{
    ovr_two_columns c = {.name = {"depth", "stress"},
                         .header = {OVR_LENGTH, OVR_PRESSURE},
                         .example = "depth [um], stress [MPa]"};
    if (!s->residual_table)
        return OVR_OK;
    ovr_status status = read_depths(of, "residual_table", s->residual_table, &c,
                                    err);
    s->residuals = c.count;
    s->residual_z = c.x;
    s->residual_s = c.y;
    return status;
}

static ovr_status resolve_limits(const ovr_physics_case *of,
                                 ovr_stress_setup *s, ovr_error *err)
{
    ovr_two_columns c = {.name = {"depth", "limit"},
                         .header = {OVR_LENGTH, OVR_PRESSURE},
                         .example = "depth [um], limit [MPa]"};
    if (!s->limit_table)
        return OVR_OK;
    if (of->given(of->data, "fatigue", "limit_pressure"))
        return ovr_fail_about(err, "fatigue.limit_table",
                              "limit_table: limit_pressure is also set; "
                              "remove one of the two");
    ovr_status status = read_depths(of, "limit_table", s->limit_table, &c, err);
    s->life.limits = c.count;
    s->life.limit_z = c.x;
    s->life.limit_A = c.y;
    return status;
}

static ovr_status resolve_fatigue(const ovr_physics_case *of,
                                  ovr_stress_setup *s, ovr_error *err)
{
    s->fatigue = of->given(of->data, "fatigue", NULL);
    if (!s->fatigue) {
        s->life = ovr_life_options_default();
        return OVR_OK;
    }
    if (!s->surfaces)
        return ovr_fail_about(err, "fatigue",
                              "[fatigue] needs [stress]; add that section");
    if (resolve_limits(of, s, err) || resolve_residual(of, s, err))
        return OVR_BAD_INPUT;
    if (isfinite(of->raceway) && !of->given(of->data, "fatigue", "raceway"))
        s->raceway = of->raceway;
    return OVR_OK;
}

/* Reason why traction is not applied by default: the shear stress of a
 * Newtonian film can greatly exceed that of real lubricants. */
static const char *no_traction(const ovr_physics_case *of, int loads)
{
    const ovr_lubricant *l = of->lubricant;
    if (loads == OVR_TRACTION_NO)
        return "[stress] traction = no";
    if (isnan(of->contact->kappa))
        return "b/R is unknown; set contact.modulus or contact.G";
    if (loads == OVR_TRACTION_AUTO && l->rheology == OVR_NEWTONIAN &&
        !(l->limiting_shear > 0))
        return "Newtonian film; its shear stress is included with a "
               "rheology, limiting_shear or stress.traction = yes";
    return NULL;
}

ovr_status ovr_stress_resolve(const ovr_physics_case *of, void *form, bool *on,
                              ovr_error *err)
{
    ovr_stress_setup *s = form;
    s->setup = of->setup;
    for (int k = 0; k < 2; k++) {
        s->poisson[k] = of->body[k].poisson;
        s->yield[k] = of->body[k].yield;
    }
    *on = of->given(of->data, "stress", NULL);
    if (*on) {
        if (!s->surfaces)
            s->surfaces = 1;
        s->no_traction = no_traction(of, s->loads);
        s->traction = !s->no_traction;
        if (ovr_window_resolve(&s->window, "stress.window", &s->from, &s->to,
                               err))
            return OVR_BAD_INPUT;
        if (!s->traction && s->loads == OVR_TRACTION_YES)
            return ovr_fail_about(err, "stress.traction", "traction: %s",
                                  s->no_traction);
    }
    ovr_status status = check_motion(of, s, err);
    return status ? status : resolve_fatigue(of, s, err);
}

/* Sets the model's features and the fields that it stores: the shear stresses,
 * which `overroll stress`, the second pass and the pictures use. */
void ovr_stress_state(const void *form, ovr_physics_effects *effects)
{
    static const char *const of[] = {"", "shear_stress_1", "shear_stress_2",
                                     "shear_stress_1, shear_stress_2"};
    const ovr_stress_setup *s = form;
    effects->features = ovr_model_feature_bit(OVR_MODEL_STRESS, true) |
                        ovr_model_feature_bit(OVR_MODEL_FATIGUE, s->fatigue);
    effects->fields = of[s->traction ? s->surfaces : 0];
}

const ovr_stress_setup *ovr_setup_stress(const ovr_setup *setup)
{
    return ovr_setup_form(setup, "stress");
}
