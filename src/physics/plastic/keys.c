/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The section [plastic] and its keys: hardening laws in units of the contact.
 */
#include "physics/plastic/plastic.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/rows.h"
#include "case/setup.h"
#include "physics/plastic/bodies.h"
#include "physics/stress/stress.h"
#include "simulation/conflicts.h"
#include "stress/stress.h"

#define AT(field) offsetof(ovr_plastic_setup, field)

static const ovr_word which_surface[] = {
    {"1", 1}, {"2", 2}, {"both", 3}, {NULL, 0}};
static const ovr_word by_body[] = {{"body", NAN}, {NULL, 0}};
static const ovr_word laws[] = {{"none", OVR_HARDENS_NOT},
                                {"linear", OVR_HARDENS_LINEAR},
                                {"kinematic", OVR_HARDENS_KINEMATIC},
                                {"swift", OVR_HARDENS_SWIFT},
                                {NULL, 0}};
static const ovr_word feature_window[] = {{"feature", 0}, {NULL, 0}};
static const ovr_word couplings[] = {{"step", 0}, {"pass", 1}, {NULL, 0}};

static const ovr_parameter plastic_keys[] = {
    {"surface", CHOICE(which_surface), NULL, AT(surfaces), true, ALWAYS,
     "surface whose material yields; default with this section: 1"},
    {"hardening", CHOICE(laws), "swift", AT(hardening), true, "[plastic]",
     "hardening of the von Mises yield stress: none; linear, by modulus; "
     "kinematic, by modulus (Prager); or a power of the accumulated plastic "
     "strain (Swift)"},
    {"yield", STRESS(by_body, 1e-3, 1e4), "body", AT(yield), true, "[plastic]",
     "initial von Mises yield stress, which replaces B C^n of swift; body: "
     "as in [body N]"},
    {"swift", TEXT, "945 MPa, 20, 0.121", AT(swift), true,
     "[plastic]; hardening = swift",
     "B, C, n of B (C + plastic strain in 1e-6)^n; default: bearing steel "
     "52100"},
    {"modulus", STRESS(NULL, 0, 1e9), "0", AT(modulus), true,
     "[plastic]; hardening = linear | kinematic",
     "hardening modulus, increase of the yield stress per plastic strain"},
    {"passes", WHOLE(1, 1000), "1", AT(passes), true, "[plastic]",
     "number of overrollings of the same material, each starting from the "
     "steady smooth contact; fewer if the material shakes down earlier"},
    {"window", LIST(OVR_LENGTH, OVR_IN_B, -1e6, 1e6, feature_window), "feature",
     AT(window), true, "[plastic]",
     "range of material that may yield, FROM, TO relative to the centre of "
     "the first feature; feature: the features of the surface and 1 b "
     "beyond, at least 3 b"},
    {"layers", WHOLE(4, 200), "24", AT(layers), true, "[plastic]",
     "maximum number of layers of constant plastic strain; the first layer "
     "is one mesh size thick"},
    {"depth_max", LENGTH(1e-3, 10), "0.5", AT(depth), true, "[plastic]",
     "depth of the lowest layer"},
    {"iterations", WHOLE(1, 10000), "8", AT(iterations), true, "[plastic]",
     "maximum number of iterations between plastic flow and equilibrium per "
     "step"},
    {"coupling", CHOICE(couplings), "step", AT(once), true, "[plastic]",
     "when the profile changes: after each step, or only between passes"},
    {"initial", PATH, NULL, AT(initial), true, "[plastic]",
     "result file of an earlier run whose plastic strains and hardening are "
     "the initial state"},
    {"profiles", PATH, NULL, AT(profiles), false, "[plastic]",
     "STEM: writes the profile before and after to STEM-before.csv and "
     "STEM-after.csv, which [feature] shape = profile can read"},
    {"elastic", FLAG, "no", AT(elastic), true, "[plastic]",
     "an additional first pass without plastic deformation; the report "
     "compares its equivalent length and life with those of the last pass"},
    {"anyway", FLAG, "no", AT(anyway), false, "[plastic]",
     "continue if the smooth contact never shakes down"},
};

const ovr_section ovr_plastic_section = {
    .name = "plastic",
    .whole = true,
    .help = "plastic deformation below a surface; needs [stress]",
    ROWS(plastic_keys)};

/* Reads the parameters of Swift's law, such as "945 MPa, 20, 0.121". */
static ovr_status read_swift(const ovr_physics_case *of, const char *text,
                             ovr_hardening *h, ovr_error *err)
{
    ovr_quantity value[3];
    ovr_error why = {0};
    for (int k = 0; k < 3; k++) {
        char item[80];
        size_t length = strcspn(text, ",");
        bool last = text[length] == '\0';
        if (length >= sizeof item || last != (k == 2))
            return ovr_fail_about(
                err, "plastic.swift",
                "swift: must be B, C, n: '945 MPa, 20, 0.121'");
        memcpy(item, text + strspn(text, " "), length);
        item[length - strspn(text, " ")] = '\0';
        while (*item && item[strlen(item) - 1] == ' ')
            item[strlen(item) - 1] = '\0';
        if (ovr_quantity_read(item, k ? OVR_PURE : OVR_PRESSURE, true,
                              &value[k], &why))
            return ovr_fail_about(err, "plastic.swift", "swift: %s",
                                  why.message);
        text += length + !last;
    }
    if (value[0].unit && !isfinite(of->contact->ph))
        return ovr_fail_about(
            err, "plastic.swift",
            "swift: B in pascals needs p_h, which is unknown; use B relative "
            "to p_h, without a unit");
    h->strength = value[0].unit ? value[0].value / of->contact->ph
                                : value[0].value;
    h->offset = value[1].value;
    h->power = value[2].value;
    if (!(h->strength > 0) || !(h->offset > 0) ||
        !(h->power > 0 && h->power < 1))
        return ovr_fail_about(
            err, "plastic.swift",
            "swift: needs B and C above 0 and n between 0 and 1");
    return OVR_OK;
}

/* Yield stress: from the section, from Swift's law, or from the body. */
static ovr_status resolve_law(const ovr_physics_case *of, ovr_plastic_setup *p,
                              int k, ovr_error *err)
{
    ovr_plastic_body *body = &p->body[k];
    ovr_hardening *h = &body->hardening;
    h->law = p->hardening;
    if (isnan(body->strain) && h->law != OVR_HARDENS_NOT)
        return ovr_fail_about(
            err, "plastic.hardening",
            "hardening: depends on the strain, which needs b/R; set a modulus "
            "in [contact] or [body N], or hardening = none");
    h->yield = p->yield;
    if (h->law == OVR_HARDENS_SWIFT) {
        double slope;
        if (read_swift(of, p->swift, h, err))
            return OVR_BAD_INPUT;
        h->microstrain = 1e6 * body->strain;
        if (!isnan(p->yield))
            h->strength *= p->yield / ovr_yield_stress(h, 0, &slope);
        h->yield = ovr_yield_stress(h, 0, &slope);
        return OVR_OK;
    }
    if (isnan(h->yield))
        h->yield = of->body[k].yield;
    if (!(h->yield > 0))
        return ovr_fail_about(
            err, "plastic.yield",
            "yield: the yield stress of surface %d is missing; set it here "
            "or in [body %d]",
            k + 1, k + 1);
    h->modulus = h->law == OVR_HARDENS_NOT ? 0 : p->modulus * body->strain;
    if (h->law != OVR_HARDENS_NOT && !(p->modulus > 0))
        return ovr_fail_about(err, "plastic.modulus",
                              "modulus: %s hardening needs a modulus above 0",
                              h->law == OVR_HARDENS_LINEAR ? "linear"
                                                           : "kinematic");
    return OVR_OK;
}

/* E* of a body relative to E' of both; 1 for equal or unknown bodies. */
static double stiffness(const ovr_physics_case *of, int k)
{
    const ovr_physics_body *b = &of->body[k];
    double reduced = of->substrate > 0 ? of->contact->modulus : NAN;
    double own = b->modulus / (1 - b->poisson * b->poisson);
    return own > 0 && reduced > 0 ? own / reduced : 1;
}

static ovr_status check_limit(const ovr_plastic_setup *p, int k, ovr_error *err)
{
    const double close = 0.9;
    double Y = p->body[k].hardening.yield;
    double limit = ovr_shakedown_limit() * Y;
    if (p->anyway)
        return OVR_OK;
    if (limit < 1)
        return ovr_fail_about(
            err, "plastic.yield",
            "yield: Y = %.4g ph: p_h exceeds the shakedown limit of the smooth "
            "contact, %.4g ph, so that surface %d deforms plastically in every "
            "pass; set plastic.anyway = yes to continue",
            Y, limit, k + 1);
    if (p->hardening == OVR_HARDENS_NOT && close * limit < 1)
        return ovr_fail_about(
            err, "plastic.hardening",
            "hardening: none: a contact at %.2g of its shakedown limit shakes "
            "down too slowly without hardening; set hardening = linear with "
            "modulus = 1 %% of Young's modulus, or anyway = yes",
            1 / limit);
    return OVR_OK;
}

static ovr_status check_run(const ovr_plastic_setup *p, ovr_error *err)
{
    static const char *const called[] = {"", "1", "2", "both"};
    int lacking = p->surfaces & ~ovr_setup_stress(p->setup)->surfaces;
    return lacking
               ? ovr_fail_about(err, "plastic",
                                "[plastic]: plastic deformation of surface "
                                "%s needs its stresses; set stress.surface = "
                                "%s",
                                lacking & 1 ? "1" : "2", called[p->surfaces])
               : OVR_OK;
}

ovr_status ovr_plastic_on_mesh(const ovr_physics_case *of, void *form,
                               double mesh, ovr_error *err)
{
    (void)form;
    (void)mesh;
    if (!of->transient)
        return ovr_fail_about(err, "plastic",
                              "[plastic]: a steady contact has no stress "
                              "history of the material; set time.end");
    return ovr_plastic_check(of->setup, err);
}

/* Number of passes: that of the case, or larger. */
static ovr_status resolve_passes(ovr_plastic_setup *p, ovr_passes_setup *passes,
                                 ovr_error *err)
{
    p->flooded = passes->number == 1;
    if (passes->number < p->passes)
        passes->number = p->passes;
    if (p->elastic && passes->loads.count)
        return ovr_fail_about(err, "plastic.elastic",
                              "elastic: the elastic pass would use the first "
                              "of passes.loads; compare with a run without "
                              "[plastic] instead");
    passes->number += p->elastic;
    return OVR_OK;
}

ovr_status ovr_plastic_resolve(const ovr_physics_case *of, void *form, bool *on,
                               ovr_error *err)
{
    ovr_plastic_setup *p = form;
    *on = of->given(of->data, "plastic", NULL);
    if (!*on)
        return OVR_OK;
    p->setup = of->setup;
    if (!p->surfaces)
        p->surfaces = 1;
    if (ovr_window_resolve(&p->window, "plastic.window", &p->from, &p->to,
                           err) ||
        check_run(p, err))
        return OVR_BAD_INPUT;
    for (int k = 0; k < 2; k++) {
        if (!(p->surfaces >> k & 1))
            continue;
        p->body[k].softness = 1 / (4 * stiffness(of, k));
        p->body[k].strain = of->contact->kappa * p->body[k].softness;
        if (resolve_law(of, p, k, err) || check_limit(p, k, err))
            return OVR_BAD_INPUT;
    }
    return resolve_passes(p, of->passes, err);
}

/* True if a plastic body has a layer with elastic moduli different from its
 * own. */
static bool yields_below_others(const ovr_plastic_setup *p)
{
    const double same = 1e-9;
    for (int k = 0; k < 2; k++) {
        const ovr_coated *on = ovr_setup_layers(p->setup, k);
        if (!on || !(p->surfaces >> k & 1))
            continue;
        const ovr_elastic *below = &on->body.below;
        for (int j = 0; j < on->body.layers; j++)
            if (fabs(on->body.layer[j].modulus / below->modulus - 1) > same ||
                fabs(on->body.layer[j].poisson - below->poisson) > same)
                return true;
    }
    return false;
}

void ovr_plastic_state(const void *form, ovr_physics_effects *effects)
{
    effects->features = ovr_model_feature_bit(OVR_MODEL_PLASTIC, true) |
                        ovr_model_feature_bit(OVR_MODEL_OTHER_MODULI,
                                              yields_below_others(form));
}

ovr_plastic_setup *ovr_setup_plastic(const ovr_setup *setup)
{
    ovr_plastic_setup *form = ovr_setup_form(setup, "plastic");
    return form && form->surfaces ? form : NULL;
}
