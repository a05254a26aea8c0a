/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sections [cavitation] and [supply] and their keys. */
#include "physics/supply/supply.h"

#include <math.h>

#include "base/error.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/history_keys.h"
#include "simulation/conflicts.h"

#define AT(field) offsetof(ovr_supply_case, field)

static const ovr_word cavitations[] = {
    {"reynolds", OVR_CAVITATION_REYNOLDS},
    {"conserving", OVR_CAVITATION_CONSERVING},
    {NULL, 0}};
static const ovr_word supplies[] = {{"flooded", 0}, {"film", 1}, {NULL, 0}};
static const ovr_word endless_oil[] = {{"endless", INFINITY}, {NULL, 0}};

static const ovr_parameter cavitation_keys[] = {
    {"model", CHOICE(cavitations), "reynolds", AT(cavitation), true, ALWAYS,
     "reynolds: not mass-conserving; conserving: mass-conserving "
     "(Elrod-Adams, JFO), with a film fraction in the cavitated region; "
     "order 4 only along the characteristic"},
};

static const ovr_parameter supply_keys[] = {
    {"model", CHOICE(supplies), "flooded", AT(film), true, ALWAYS,
     "flooded, or film: lubricant layers on the surfaces; needs "
     "cavitation.model = conserving"},
    {"thickness_1", HEIGHT, "0", AT(thickness[0]), true, "model = film",
     "thickness of the supplied layer on surface 1"},
    {"thickness_2", HEIGHT, "0", AT(thickness[1]), true, "model = film",
     "thickness of the supplied layer on surface 2"},
    {"profile_1", PATH, NULL, AT(profile[0]), true, "model = film",
     "file of layer thickness along surface 1, instead of thickness_1; its "
     "largest x enters at T = 0"},
    {"profile_2", PATH, NULL, AT(profile[1]), true, "model = film",
     "file of layer thickness along surface 2, instead of thickness_2"},
    {"waiting", AREA_OR(endless_oil, 1e9), "0.1", AT(reservoir), true,
     "model = film",
     "oil volume in the inlet reservoir at the start, if the contact is "
     "flooded then"},
    HISTORY(AT(change), "1", 0, 100, 1, "model = film; " CHANGES),
};

const ovr_section ovr_supply_sections[2] = {
    {"cavitation", false, NULL, "cavitation model downstream of film rupture",
     ROWS(cavitation_keys)},
    {"supply", false, "model",
     "lubricant supply; its history is relative to the thicknesses",
     ROWS(supply_keys)}};

void ovr_supply_choose(const void *form, ovr_options *options)
{
    options->cavitation =
        (ovr_cavitation)((const ovr_supply_case *)form)->cavitation;
}

static const char *const thickness[] = {"thickness_1", "thickness_2"};

static ovr_status check_film(const ovr_physics_case *of,
                             const ovr_supply_case *s, ovr_error *err)
{
    bool any = false;
    if (s->cavitation != OVR_CAVITATION_CONSERVING)
        return ovr_fail_about(
            err, "supply.model",
            "model: film needs cavitation.model = conserving");
    for (int k = 0; k < 2; k++)
        any = any || s->profile[k] ||
              of->given(of->data, "supply", thickness[k]);
    return any ? OVR_OK
               : ovr_fail_about(err, "supply.model",
                                "model: film needs thickness_1, thickness_2 or "
                                "both in [supply], or a profile");
}

static ovr_status read_layers(const ovr_physics_case *of, ovr_supply_case *s,
                              ovr_error *err)
{
    static const char *const key[] = {"supply.profile_1", "supply.profile_2"};
    for (int k = 0; k < 2; k++) {
        ovr_error why = {0};
        if (!s->profile[k])
            continue;
        if (of->given(of->data, "supply", thickness[k]))
            return ovr_fail_about(err, key[k],
                                  "profile_%d: %s is also set; remove one of "
                                  "the two",
                                  k + 1, thickness[k]);
        s->layer[k] = ovr_layer_read(s->profile[k], of->contact,
                                     &of->arena->allocator, &why);
        if (!s->layer[k])
            return ovr_fail_about(err, key[k], "profile_%d: %s", k + 1,
                                  why.message);
    }
    return OVR_OK;
}

/* The options switch the model on. */
ovr_status ovr_supply_resolve(const ovr_physics_case *of, void *form, bool *on,
                              ovr_error *err)
{
    ovr_supply_case *s = form;
    (void)on;
    s->start = NAN;
    s->contact = of->contact;
    s->options = of->options;
    s->speed = of->speed;
    s->sliding = of->sliding;
    ovr_status status = s->film ? check_film(of, s, err) : OVR_OK;
    if (!status)
        status = of->history(of->data, "supply", &s->change, &s->history, err);
    return status ? status : read_layers(of, s, err);
}

void ovr_supply_drop(void *form)
{
    ovr_supply_case *s = form;
    ovr_history_free(s->history);
    for (int k = 0; k < 2; k++)
        ovr_layer_free(s->layer[k]);
}

/* Supplied content at P = 0 on both surfaces; a layer moves with its surface.
 * At nearly zero entrainment speed the supply is zero, whatever the sliding
 * speed. */
double ovr_supply_arriving(const ovr_supply_case *s, double T)
{
    static const double minimum = 1e-3;
    const double ratio[2] = {s->contact->u1_ratio, s->contact->u2_ratio};
    double Cu = fmax(ovr_history_value(s->speed, T), minimum), both = 0;
    for (int k = 0; k < 2; k++) {
        const ovr_layer *layer = s->layer[k];
        double distance = layer ? ovr_surface_distance(s->speed, s->sliding,
                                                       ratio[k], k + 1, T)
                                : 0;
        double h = layer ? ovr_layer_thickness(layer, distance)
                         : s->thickness[k];
        double u = s->sliding ? ovr_surface_speed(s->speed, s->sliding,
                                                  ratio[k], k + 1, T) /
                                    Cu
                              : ratio[k];
        both += fmax(0, u) * h;
    }
    return both * ovr_history_value(s->history, T);
}

void ovr_supply_state(const void *form, ovr_physics_effects *effects)
{
    const ovr_supply_case *s = form;
    double film = s->film ? ovr_supply_arriving(s, 0) : 0;
    effects->features = ovr_model_feature_bit(OVR_MODEL_SUPPLY, s->film);
    effects->fields = "filling, oil_content";
    if (film > 0)
        effects->arrives = film;
}

/* Lubricant on the surfaces between inlet and outlet at T = 0, as a supply. */
static double lying(const ovr_supply_case *s)
{
    const double ratio[2] = {s->contact->u1_ratio, s->contact->u2_ratio};
    double length = s->options->outlet - s->options->inlet, both = 0;
    for (int k = 0; k < 2; k++)
        both += fmax(0, ratio[k]) * ovr_layer_mean(s->layer[k], 0, length);
    return both;
}

void ovr_supply_feed(ovr_supply_case *s, ovr_layer *layer[2], double reservoir)
{
    ovr_supply_drop(s);
    s->history = NULL;
    s->film = true;
    s->reservoir = reservoir;
    for (int k = 0; k < 2; k++)
        s->layer[k] = layer[k];
    s->start = lying(s);
}

ovr_supply_case *ovr_setup_supply(const ovr_setup *setup)
{
    return ovr_setup_form(setup, "supply");
}
