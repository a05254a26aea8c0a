/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The section [boundary]: choice and parameters of the asperity contact model.
 * The exponential form is Persson's (u0 of about Rq/2).  Its constants are for
 * dry contact of self-affine profiles in plane strain.  At pressures of 0.003
 * to 0.2 of E* slope the error of the gap is less than 0.2 Rq.
 *
 *     s = Rq/2.15,  a1 = 0.38 (E'/2) slope/ph
 *
 * The real contact area fraction, 2.5 A p_h/(E* slope), is 0.95 A/a1. For
 * profiles the model is computed (surface/rough_pair.h).
 */
#include "physics/mixed/mixed.h"

#include <math.h>
#include <stdio.h>

#include "base/error.h"
#include "base/rows.h"
#include "contact/contact.h"
#include "contact/film_formula.h"
#include "contact/flow_law.h"

static const ovr_word laws[] = {
    {"exponential", OVR_BOUNDARY_EXPONENTIAL},
    {"layer", OVR_BOUNDARY_LAYER},
    {"greenwood-tripp", OVR_BOUNDARY_GREENWOOD_TRIPP},
    {"table", OVR_BOUNDARY_TABLE},
    {"profile", OVR_BOUNDARY_PROFILE},
    {NULL, 0}};

static const ovr_word of_what[] = {{"all", 0}, {"unresolved", 1}, {NULL, 0}};
static const ovr_word factors[] = {{"none", OVR_RIDGES_NONE},
                                   {"isotropic", OVR_RIDGES_ISOTROPIC},
                                   {"transverse", OVR_RIDGES_TRANSVERSE},
                                   {"longitudinal", OVR_RIDGES_LONGITUDINAL},
                                   {NULL, 0}};
static const ovr_word no_wear[] = {{"none", 0}, {NULL, 0}};
static const ovr_word auto_zero[] = {{"auto", 0}, {NULL, 0}};
static const ovr_word none[] = {{"none", NAN}, {NULL, 0}};

static const char rough[] = "law = exponential";
static const char with_Rq[] = "law = exponential | greenwood-tripp | table";
static const char by_profile[] = "law = profile";
static const char summits[] = "law = greenwood-tripp";

static const ovr_parameter keys[] = {
    {"law", CHOICE(laws), NULL, offsetof(ovr_boundary_form, law), true, ALWAYS,
     "asperity contact model (pressure against mean gap): profile, computed "
     "from features of type profile or roughness in dry contact; exponential, "
     "from Rq and slope; greenwood-tripp, from summits and sharpness; table; "
     "each also with a boundary layer; or layer only"},
    {"of", CHOICE(of_what), "all", offsetof(ovr_boundary_form, unresolved),
     true, "law; of = unresolved => [feature]",
     "all: the model describes all roughness, none is on the grid, and H is "
     "the mean film thickness; unresolved: the model describes only roughness "
     "finer than the grid"},
    {"flow_factor", CHOICE(factors), "none",
     offsetof(ovr_boundary_form, ridges), true, "law; of = all",
     "pressure flow factor of Patir and Cheng: isotropic roughness, or "
     "ridges across or along the flow that are 9 times as long as wide"},
    {"Rq", HEIGHT, "0", offsetof(ovr_boundary_form, Rq), true, with_Rq,
     "composite root mean square height of both surfaces"},
    {"slope", PLAIN(0, 1), "0", offsetof(ovr_boundary_form, slope), true, rough,
     "composite root mean square slope of both surfaces, dimensionless"},
    {"amplitude", STRESS(none, 0, 1e6), "none",
     offsetof(ovr_boundary_form, amplitude), true, rough,
     "pressure at zero gap, instead of the value computed from slope"},
    {"decay", OVR_NUMBER, OVR_LENGTH, OVR_IN_HEIGHT, 0, 1e3, false,
     .words = none, "none", offsetof(ovr_boundary_form, decay), true, rough,
     "gap over which the pressure falls by a factor e, instead of Rq/2.15"},
    {"layer", HEIGHT, "0", offsetof(ovr_boundary_form, layer), true, "law",
     "film thickness at which a layer of boundary lubricant carries p_h; 0: "
     "no layer"},
    {"layer_decay", HEIGHT, "0", offsetof(ovr_boundary_form, layer_decay), true,
     "layer > 0",
     "film thickness over which that pressure falls by a factor "
     "e; 0: a third of layer"},
    {"friction", PLAIN_OR(none, 0, 2), "none",
     offsetof(ovr_boundary_form, friction), true, "law",
     "boundary friction coefficient"},
    {"summits", PLAIN(0, 1), "0.05", offsetof(ovr_boundary_form, summits), true,
     summits,
     "summit density times summit radius times Rq, n beta sigma; measured: "
     "0.03 to 0.06"},
    {"sharpness", PLAIN(0, 1), "0.01", offsetof(ovr_boundary_form, sharpness),
     true, summits,
     "Rq divided by the summit radius, sigma/beta; usual: 0.0001 to 0.01"},
    {"wear_1", OVR_NUMBER, OVR_PER_PRESSURE, OVR_NOT_HERTZIAN, 0, 1, false,
     .words = no_wear, "none", offsetof(ovr_boundary_form, wear[0]), true,
     by_profile,
     "wear coefficient of surface 1: volume per load and sliding distance, for "
     "example 1e-8 mm3/Nm (mild)"},
    {"wear_2", OVR_NUMBER, OVR_PER_PRESSURE, OVR_NOT_HERTZIAN, 0, 1, false,
     .words = no_wear, "none", offsetof(ovr_boundary_form, wear[1]), true,
     by_profile, "wear coefficient of surface 2"},
    {"passes", PLAIN(0, 1e15), "0", offsetof(ovr_boundary_form, passes), true,
     by_profile,
     "running-in: number of passes of both surfaces, at constant operating "
     "conditions, with wear; 0: no wear"},
    {"jump", PLAIN_OR(auto_zero, 0, 1e15), "auto",
     offsetof(ovr_boundary_form, jump), true, "passes > 0",
     "number of passes represented by each computed pass (cycle jump); auto: "
     "at most 2 % of Rq wears off anywhere"},
    {"settled", PLAIN(0, 1), "0", offsetof(ovr_boundary_form, settled), true,
     "passes > 0",
     "running-in ends when a jump changes the asperity load share by less than "
     "this relative amount; 0: all passes are computed"},
    {"file", PATH, NULL, offsetof(ovr_boundary_form, file), true, "law = table",
     "file of pressure against mean gap, two columns with a header such as "
     "'gap [nm], pressure [MPa]'"}};

const ovr_section ovr_boundary_section = {
    .name = "boundary",
    .on = "law",
    .help = "mixed lubrication: asperities carry part of the load",
    ROWS(keys)};

/* Reads the roughness of the contact model. */
static ovr_status resolve_exponential(const ovr_physics_case *of,
                                      ovr_boundary_form *f, ovr_error *err)
{
    double kappa = of->contact->kappa;
    if (isnan(f->decay))
        f->decay = f->Rq / 2.15;
    if (!(f->decay > 0))
        return ovr_fail_about(err, "Rq",
                              "law = exponential needs Rq (composite of both "
                              "surfaces) or decay, above 0");
    if (!isnan(f->amplitude))
        return OVR_OK;
    if (!(f->slope > 0))
        return ovr_fail_about(err, "slope",
                              "law = exponential needs slope (root mean "
                              "square) or amplitude, above 0");
    if (!(kappa > 0))
        return ovr_fail_about(err, "slope",
                              "slope needs the modulus, which is unknown; "
                              "set contact.modulus, or amplitude in p_h");
    f->amplitude = 0.38 * f->slope * 2 / kappa;
    return OVR_OK;
}

/* E* = E'/2 in ph is 2/kappa. */
static ovr_status resolve_summits(const ovr_physics_case *of,
                                  ovr_boundary_form *f, ovr_error *err)
{
    double kappa = of->contact->kappa;
    if (!(f->Rq > 0))
        return ovr_fail_about(err, "Rq",
                              "law = greenwood-tripp needs Rq (composite of "
                              "both surfaces), above 0");
    if (!(f->summits > 0 && f->sharpness > 0))
        return ovr_fail_about(err, f->summits > 0 ? "sharpness" : "summits",
                              "law = greenwood-tripp needs a value above 0");
    if (!(kappa > 0))
        return ovr_fail_about(err, "law",
                              "law = greenwood-tripp needs the modulus, "
                              "which is unknown; set contact.modulus");
    return ovr_asperity_greenwood_tripp(&f->bears.table, f->Rq, f->summits,
                                        f->sharpness, 2 / kappa, of->arena,
                                        err);
}

/* At the pressure of zero gap the contact area fraction is 1, as in the
 * exponential model. */
static ovr_status set_points(const ovr_physics_case *of,
                             const ovr_two_columns *c, ovr_boundary_form *f,
                             ovr_error *err)
{
    ovr_asperity_table *t = &f->bears.table;
    double maximum, slope;
    for (size_t k = 0; k < c->count; k++)
        if (!(c->y[k] > 0) || (k && !(c->y[k] < c->y[k - 1])))
            return ovr_fail_at(err, OVR_BAD_INPUT, f->file, c->line[k],
                               "pressures must decrease and be above 0");
    if (c->count < 2)
        return ovr_fail_at(err, OVR_BAD_INPUT, f->file, 0,
                           "has %zu points, but needs at least two", c->count);
    if (ovr_asperity_table_take(t, c->count, of->arena, err))
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < c->count; k++) {
        t->H[k] = c->x[k] / of->contact->height;
        t->ln_A[k] = log(c->y[k] / of->contact->ph);
    }
    ovr_asperity_table_slopes(t);
    ovr_asperity_law_at(&f->bears, 0, &maximum, &slope);
    for (size_t k = 0; k < c->count; k++)
        t->area[k] = fmin(1, 0.95 * exp(t->ln_A[k]) / maximum);
    return OVR_OK;
}

static ovr_status resolve_table(const ovr_physics_case *of,
                                ovr_boundary_form *f, ovr_error *err)
{
    ovr_two_columns c = {.name = {"gap", "pressure"},
                         .header = {OVR_LENGTH, OVR_PRESSURE},
                         .example = "gap [nm], pressure [MPa]"};
    if (!f->file)
        return ovr_fail_about(err, "file",
                              "law = table needs a file of gaps and pressures");
    if (!(of->contact->height > 0 && of->contact->ph > 0))
        return ovr_fail_about(err, "file",
                              "a table in metres and pascals needs a contact "
                              "with dimensions; set radius, modulus and alpha");
    if (of->read(of->data, "file", f->file, &c, err))
        return err->status;
    return set_points(of, &c, f, err);
}

static bool is_rough(const ovr_feature_form *feature)
{
    return feature->shape == OVR_PROFILE || feature->shape == OVR_ROUGHNESS;
}

/* The profile of each surface; at most one per surface. */
static ovr_status profiles_of(const ovr_physics_case *of,
                              const ovr_feature_form *form[2], ovr_error *err)
{
    form[0] = form[1] = NULL;
    for (size_t k = 0; k < of->features; k++) {
        const ovr_feature_form **place = &form[of->feature[k]->surface == 2];
        if (!is_rough(of->feature[k]))
            continue;
        if (*place)
            return ovr_fail_about(err, "law",
                                  "law = profile accepts one profile per "
                                  "surface, but '%s' and '%s' are on the "
                                  "same surface",
                                  (*place)->name, of->feature[k]->name);
        *place = of->feature[k];
    }
    if (!form[0] && !form[1])
        return ovr_fail_about(err, "law",
                              "law = profile needs a [feature] with shape = "
                              "profile or roughness");
    return OVR_OK;
}

/* Computes the asperity contact model of the complete profiles. If the mesh
 * resolves a part of them, this is an upper bound (on_mesh). */
static ovr_status resolve_profiles(const ovr_physics_case *of,
                                   ovr_boundary_form *f, ovr_error *err)
{
    const ovr_feature_form *form[2];
    if (profiles_of(of, form, err) ||
        ovr_rough_pair_make(&f->pair, form, of->contact, of->arena, err) ||
        ovr_rough_pair_law(&f->pair, &f->bears.table, of->arena, err))
        return err->status;
    f->Rq = f->pair.Rq;
    f->slope = f->pair.slope * of->contact->kappa;
    return OVR_OK;
}

static ovr_status resolve_layer(ovr_boundary_form *f, ovr_error *err)
{
    if (f->law == OVR_BOUNDARY_LAYER && !(f->layer > 0))
        return ovr_fail_about(err, "layer",
                              "law = layer needs boundary.layer, the film "
                              "thickness at which the layer carries p_h, "
                              "above 0");
    if (!(f->layer_decay > 0))
        f->layer_decay = f->layer / 3;
    f->bears.layer = f->layer;
    f->bears.layer_decay = f->layer_decay;
    return OVR_OK;
}

static ovr_status resolve_law(const ovr_physics_case *of, ovr_boundary_form *f,
                              ovr_error *err)
{
    f->bears = (ovr_asperity_law){0};
    if (f->law == OVR_BOUNDARY_EXPONENTIAL && resolve_exponential(of, f, err))
        return OVR_BAD_INPUT;
    if (f->law == OVR_BOUNDARY_EXPONENTIAL) {
        f->bears.amplitude = f->amplitude;
        f->bears.decay = f->decay;
    }
    if (f->law == OVR_BOUNDARY_GREENWOOD_TRIPP && resolve_summits(of, f, err))
        return err->status;
    if (f->law == OVR_BOUNDARY_TABLE && resolve_table(of, f, err))
        return err->status;
    if (f->law == OVR_BOUNDARY_PROFILE && resolve_profiles(of, f, err))
        return err->status;
    return resolve_layer(f, err);
}

bool ovr_boundary_keeps(const void *form, const ovr_feature_form *feature)
{
    const ovr_boundary_form *f = form;
    return f->law == OVR_BOUNDARY_PROFILE && !f->unresolved &&
           is_rough(feature);
}

static ovr_status resolve_factor(const ovr_physics_case *of,
                                 ovr_boundary_form *f, ovr_error *err)
{
    f->factor = (ovr_flow_factor){(ovr_ridges)f->ridges, f->Rq};
    if (f->Rq == 0 && f->decay > 0)
        f->factor.sigma = 2.15 * f->decay;
    if (f->ridges && !(f->factor.sigma > 0))
        return ovr_fail_about(err, "flow_factor",
                              "flow_factor needs Rq (composite of both "
                              "surfaces), above 0");
    if (f->ridges && of->options->faces == OVR_FACES_ARITHMETIC)
        return ovr_fail_about(err, "flow_factor",
                              "flow_factor needs domain.faces = logarithmic "
                              "or gap");
    return OVR_OK;
}

/* A stationary surface has no passes. */
static ovr_status resolve_wear(const ovr_physics_case *of,
                               const ovr_boundary_form *f, ovr_error *err)
{
    const double u[2] = {of->contact->u1_ratio, of->contact->u2_ratio};
    if (!(f->passes > 0))
        return f->wear[0] > 0 || f->wear[1] > 0
                   ? ovr_fail_about(err, "passes",
                                    "wear needs boundary.passes, for example "
                                    "passes = 1e6")
                   : OVR_OK;
    if (f->unresolved)
        return ovr_fail_about(err, "passes",
                              "running-in requires boundary.of = all");
    if (!(of->contact->ph > 0 && of->contact->kappa > 0))
        return ovr_fail_about(err, "passes",
                              "wear needs a contact with dimensions; set "
                              "radius, modulus and alpha");
    for (int k = 0; k < 2; k++)
        if (f->wear[k] > 0 && !(fabs(u[k]) > 1e-9))
            return ovr_fail_about(
                err, k ? "wear_2" : "wear_1",
                "surface %d does not move, so that its wear per pass is "
                "undefined; remove this key",
                k + 1);
    return OVR_OK;
}

static bool bears(const ovr_boundary_form *f)
{
    return f->bears.amplitude > 0 || f->bears.layer > 0 || f->bears.table.n;
}

static double unloaded(double X)
{
    double root = sqrt(X * X - 1);
    return 0.5 * (X * root - log(X + root));
}

/* |X| beyond which the asperity pressure at the gap of the dry contact is
 * negligible. */
static double ends_at(const ovr_boundary_form *f)
{
    const double enough = 1e-5, farthest = 20;
    double X = 1, A = 1, slope;
    while (A > enough && X < farthest) {
        X += 0.05;
        ovr_asperity_law_at(&f->bears, unloaded(X), &A, &slope);
    }
    return X;
}

/* The default domain extends to the region without asperity contact; the order
 * is 2. */
static void resolve_options(const ovr_physics_case *of,
                            const ovr_boundary_form *f)
{
    ovr_options *o = of->options, with = *o;
    double end = ends_at(f);
    ovr_options_domain(of->contact, &with);
    if (o->outlet == 0 || isnan(o->outlet))
        o->outlet = fmax(with.outlet, end);
    if (o->inlet == 0 || isnan(o->inlet))
        o->inlet = fmin(with.inlet, -end);
    if (!o->order) /* order 4 is rejected as a conflict */
        o->order = 2;
}

/* Film thickness of smooth surfaces, from the film thickness formula within its
 * range. */
static double smooth_film(const ovr_physics_case *of)
{
    const ovr_contact *c = of->contact;
    double fit =
        ovr_film_fitted(c->M, c->L, ovr_density(of->lubricant, 1)).central;
    return isnan(fit) ? ovr_film_central_moes(c->M, c->L) : fit;
}

/* Asperity pressure at a film thickness, as a fraction of the Hertzian
 * pressure. */
static double share_of(const ovr_asperity_law *law, double H)
{
    enum { NODES = 200 };
    double A, slope, sum = 0, load = 0;
    ovr_asperity_law_at(law, H, &A, &slope);
    for (int i = 0; i < NODES; i++) {
        double X = (i + 0.5) / NODES, P = sqrt(1 - X * X);
        sum += fmin(P, A);
        load += P;
    }
    return sum / load;
}

/* Film thickness with flow factor; NAN if Rq is unknown. */
static double film_with(const ovr_boundary_form *f, double H, ovr_ridges ridges)
{
    ovr_flow_factor factor = {ridges, f->factor.sigma};
    if (!(factor.sigma > 0))
        return ridges ? NAN : H;
    return H * ovr_flow_factor_film(&factor, H / factor.sigma);
}

static double share_with(const ovr_boundary_form *f, double H,
                         ovr_ridges ridges)
{
    return share_of(&f->bears, film_with(f, H, ridges));
}

/* Mean shear stress relative to tau0 of a film without pressure gradient, whose
 * Newtonian value is x: f(y) = x, solved by bisection of ln y if there is no
 * closed form. */
static double thinned(const ovr_lubricant *oil, double x)
{
    double low = log(1e-6), high = log(fmax(x, 1e-6)), slope;
    if (oil->rheology == OVR_EYRING || !oil->flow_law)
        return asinh(x);
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        if (ovr_curve_at(&oil->flow_law->f, exp(middle), &slope) > x)
            high = middle;
        else
            low = middle;
    }
    return exp(high);
}

/* Friction coefficient of this film at the fluid part of the Hertzian pressure
 * and the supply temperature. */
static double film_friction(const ovr_physics_case *of,
                            const ovr_boundary_form *f, double H)
{
    enum { NODES = 200 };
    const ovr_lubricant *oil = of->lubricant;
    const ovr_contact *c = of->contact;
    double V = fabs(c->u1_ratio - c->u2_ratio), A, slope, sum = 0;
    ovr_asperity_law_at(&f->bears, H, &A, &slope);
    for (int i = 0; i < NODES; i++) {
        double X = (i + 0.5) / NODES, P = fmax(sqrt(1 - X * X) - A, 0);
        double t = c->lambda / 12 * V * ovr_viscosity(oil, P) / H;
        t = oil->Sigma0 * thinned(oil, t / oil->Sigma0);
        if (oil->limiting_shear > 0)
            t = fmin(t, oil->limiting_shear * P / c->kappa);
        sum += t / NODES;
    }
    return (1 - ovr_asperity_law_area(&f->bears, H)) * c->kappa * sum * 4 /
           acos(-1.0);
}

bool ovr_boundary_is_weak(const ovr_boundary_form *f, double load)
{
    const double enough = 0.9; /* carries 0.96 of the load */
    return f->at_no_film < enough * sqrt(load);
}

/* Finds the strength of the model. A model of the unresolved roughness is not
 * compared with the Hertzian pressure, because it must carry the pressure of
 * single crests. */
static void find_strength(ovr_boundary_form *f)
{
    double slope;
    f->at_no_film = INFINITY;
    f->share_at_no_film = 1;
    if (f->unresolved)
        return;
    ovr_asperity_law_at(&f->bears, 0, &f->at_no_film, &slope);
    f->share_at_no_film = share_of(&f->bears, 0);
}

ovr_status ovr_boundary_resolve(const ovr_physics_case *of, void *form,
                                bool *on, ovr_error *err)
{
    const double high = 0.7e9, slides = 0.05;
    ovr_boundary_form *f = form;
    double V = fabs(of->contact->u1_ratio - of->contact->u2_ratio);
    *on = f->law != 0;
    if (!*on)
        return OVR_OK;
    if (resolve_law(of, f, err))
        return err->status;
    *on = bears(f);
    if (!*on)
        return OVR_OK;
    if (of->contact->ph > high && V > slides &&
        of->lubricant->rheology == OVR_NEWTONIAN)
        return ovr_fail_about(
            err, "law",
            "asperity contact at p_h = %.2g GPa with a sliding speed of %.2g "
            "u_m needs a shear-thinning lubricant; set lubricant.rheology = "
            "eyring",
            of->contact->ph / 1e9, V);
    if (resolve_factor(of, f, err) || resolve_wear(of, f, err))
        return OVR_BAD_INPUT;
    f->estimate = share_with(f, smooth_film(of), f->factor.ridges);
    find_strength(f);
    resolve_options(of, f);
    return OVR_OK;
}

ovr_status ovr_boundary_on_mesh(const ovr_physics_case *of, void *form,
                                double mesh, ovr_error *err)
{
    ovr_boundary_form *f = form;
    const ovr_feature_form *profile[2];
    if (f->law != OVR_BOUNDARY_PROFILE || !f->unresolved)
        return OVR_OK;
    if (profiles_of(of, profile, err) ||
        ovr_rough_pair_rest(&f->pair, profile, mesh, of->contact, of->arena,
                            err))
        return err->status;
    f->bears.table = (ovr_asperity_table){0};
    if (ovr_rough_pair_law(&f->pair, &f->bears.table, of->arena, err)) {
        f->bears.table.n = 0;
        if (!(f->layer > 0))
            return ovr_fail_about(
                err, "of",
                "the grid resolves the profiles completely, so that no "
                "asperities are left for [boundary]; set boundary.layer or use "
                "a lower level");
    }
    f->Rq = f->pair.Rq;
    f->slope = f->pair.slope * of->contact->kappa;
    f->factor.sigma = 0; /* H is not a mean gap of the profiles */
    f->estimate = share_with(f, smooth_film(of), OVR_RIDGES_NONE);
    return OVR_OK;
}

/* Reports boundary, fluid and total friction coefficients for the bounds of the
 * asperity load share. */
static void describe_friction(const ovr_physics_case *of,
                              const ovr_boundary_form *f, double H,
                              const double share[3], ovr_physics_line *line,
                              void *data)
{
    double minimum[3] = {NAN, NAN, NAN}, maximum[3] = {NAN, NAN, NAN};
    bool known = of->lubricant->rheology != OVR_NEWTONIAN &&
                 of->contact->kappa > 0;
    char text[240];
    for (int k = 0; k < 3; k++) {
        double film = film_friction(of, f, film_with(f, H, (ovr_ridges)k));
        const double part[3] = {f->friction * share[k], film,
                                f->friction * share[k] + film};
        for (int j = 0; j < 3; j++) {
            minimum[j] = fmin(minimum[j], part[j]);
            maximum[j] = fmax(maximum[j], part[j]);
        }
    }
    if (known)
        snprintf(text, sizeof text,
                 "%.2g to %.2g for this range of load shares: boundary "
                 "friction %.2g to %.2g, fluid friction %.2g to %.2g at the "
                 "supply temperature",
                 minimum[2], maximum[2], minimum[0], maximum[0], minimum[1],
                 maximum[1]);
    else
        snprintf(text, sizeof text,
                 "boundary friction %.2g to %.2g for this range of load "
                 "shares; fluid friction needs a rheological model",
                 minimum[0], maximum[0]);
    line(data, "predicted friction coefficient", text);
}

/* Exponential model for the roughness on the mesh in |X| < 1 and the boundary
 * layer. A slope dH/dX corresponds to a real slope of kappa dH/dX. */
static ovr_asperity_law mean_law(const ovr_asperity_law *law, size_t n,
                                 const double *X, const double *S, double *Rq)
{
    ovr_asperity_law all = {.layer = law->layer,
                            .layer_decay = law->layer_decay};
    double count = 0, sum = 0, squares = 0, slopes = 0;
    for (size_t i = 1; i < n; i++) {
        double slope = (S[i] - S[i - 1]) / (X[i] - X[i - 1]);
        if (!(fabs(X[i]) < 1))
            continue;
        count++;
        sum += S[i];
        squares += S[i] * S[i];
        slopes += slope * slope;
    }
    *Rq = sqrt(fmax(squares / count - sum / count * (sum / count), 0));
    all.amplitude = 0.38 * 2 * sqrt(slopes / count);
    all.decay = *Rq / 2.15;
    return all;
}

void ovr_boundary_instead(const ovr_asperity_law *law, double H, size_t n,
                          const double *X, const double *S, size_t size,
                          char *text)
{
    double Rq;
    ovr_asperity_law all = mean_law(law, n, X, S, &Rq);
    text[0] = '\0';
    if (Rq > 0)
        snprintf(
            text, size,
            ". The lambda ratio is %.2g: with a contact model, all of 100 "
            "random pairs of ground surfaces were solved down to a ratio of "
            "0.7 and 96 down to 0.3, which need %.2g and %.2g times this "
            "speed. The mean film thickness, boundary.of = all, can be "
            "computed at any ratio; asperities would carry about %.2g of the "
            "load",
            H / Rq, pow(0.7 * Rq / H, 1 / 0.7), pow(0.3 * Rq / H, 1 / 0.7),
            share_of(&all, H));
}

static void describe_estimate(const ovr_physics_case *of,
                              const ovr_boundary_form *f,
                              ovr_physics_line *line, void *data)
{
    double H = smooth_film(of), share[3];
    char text[240];
    if (f->factor.sigma > 0) {
        snprintf(text, sizeof text,
                 "%.3g: central film thickness of smooth surfaces (film "
                 "thickness formula) divided by the composite Rq",
                 H / f->factor.sigma);
        line(data, "lambda ratio", text);
    }
    for (int k = 0; k < 3; k++)
        share[k] = share_with(f, H, (ovr_ridges)k);
    snprintf(text, sizeof text,
             "about %.2g (smooth film thickness, no trapped lubricant); runs "
             "have 0.7 to 1.7 times this share at lambda ratios below 3",
             share[0]);
    line(data, "predicted asperity load share", text);
    if (isfinite(share[1])) {
        snprintf(text, sizeof text,
                 "%.2g with the flow factor of isotropic roughness, %.2g "
                 "with the factor of transverse ridges; less if the grid "
                 "resolves the ridges, because they trap lubricant",
                 share[1], share[2]);
        line(data, "  with a flow factor", text);
    }
    if (!isnan(f->friction))
        describe_friction(of, f, H, share, line, data);
}

static void describe_wear(const ovr_boundary_form *f, ovr_physics_line *line,
                          void *data)
{
    char text[160];
    if (f->jump > 0)
        snprintf(text, sizeof text,
                 "%.4g passes in jumps of %.4g; each recomputes the contact "
                 "model of the profiles, in about a second",
                 f->passes, f->jump);
    else
        snprintf(text, sizeof text,
                 "%.4g passes in jumps of at most 2 %% of Rq; each recomputes "
                 "the contact model of the profiles, in about a second",
                 f->passes);
    line(data, "running-in", text);
}

void ovr_boundary_describe(const ovr_physics_case *of, const void *form,
                           ovr_physics_line *line, void *data)
{
    const ovr_boundary_form *f = form;
    char text[160];
    if (f->bears.amplitude > 0) {
        snprintf(text, sizeof text,
                 "%.4g p_h at zero gap, falls by a factor e in %.4g b^2/R",
                 f->amplitude, f->decay);
        line(data, "asperity contact model", text);
    }
    if (f->bears.table.n) {
        double A, slope;
        ovr_asperity_law_at(&f->bears, 0, &A, &slope);
        snprintf(text, sizeof text,
                 "%.4g p_h at zero gap, falls by a factor e in %.4g b^2/R "
                 "there",
                 A, A / slope);
        line(data, "asperity contact model", text);
    }
    if (f->law == OVR_BOUNDARY_PROFILE && !f->bears.table.n)
        line(data, "asperity contact model",
             "none: the grid resolves both profiles completely");
    if (f->law == OVR_BOUNDARY_PROFILE && f->bears.table.n) {
        snprintf(text, sizeof text,
                 "composite Rq %.4g b^2/R, slope %.4g; asperity pressure "
                 "tabulated at %d gaps, at most %.4g p_h%s",
                 f->Rq, f->slope, (int)f->bears.table.n,
                 exp(f->bears.table.ln_A[0]),
                 f->unresolved ? "; only roughness finer than the grid"
                 : f->pair.cut ? "; the longer profile is cut to the shorter"
                               : "");
        line(data, "profiles of both surfaces", text);
    }
    if (f->layer > 0) {
        snprintf(text, sizeof text,
                 "p_h at a film thickness of %.4g b^2/R, falls by a factor e "
                 "in %.4g",
                 f->layer, f->layer_decay);
        line(data, "boundary layer", text);
    }
    describe_estimate(of, f, line, data);
    if (f->passes > 0)
        describe_wear(f, line, data);
}
