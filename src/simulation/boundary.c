/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Mixed lubrication by the mean film: P = P_f + A(H), where A is what the
 * roughness of both surfaces, none of which is on the mesh, and layers of
 * boundary lubricant bear at the mean gap H (multigrid/touching.h).
 *
 *     a1 exp(-H/s),  s = Rq/2.15,  a1 = 0.38 (E'/2) slope/ph
 *
 * unless another law is given (contact/touch_law.h).  The form is Persson's (u0
 * of about Rq/2), his constants those of dry contact of self-affine profiles in
 * plane strain, pressed by 0.003 to 0.2 of E* slope: the gap is then off by
 * less than 0.2 Rq.  The share that is in contact, 2.5 A ph/(E* slope), is 0.95
 * A/a1.
 *
 * Boundary friction is mu_b A over the film's own shear stress, which acts on
 * the rest of the surface:
 *     t = (1 - phi) t_film - sgn(V) mu_b A/kappa
 * Its power mu_b A |V|/kappa is made in the film of its node, from where both
 * walls take it as they take the film's; flash temperatures of single summits
 * are not in it.  Without sliding it is nothing.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/rows.h"
#include "contact/touch_law.h"
#include "multigrid/friction.h"
#include "multigrid/touching.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/quantity_row.h"
#include "simulation/steady.h"

enum { EXPONENTIAL = 1, LAYER, GREENWOOD_TRIPP, TABLE };

typedef struct boundary_form {
    int law;
    double Rq, slope;        /* of both surfaces: b^2/R, a pure number */
    double amplitude, decay; /* a1, s; NAN: by those two */
    double layer, layer_decay;
    double friction;           /* NAN: not told */
    double summits, sharpness; /* n beta sigma, sigma/beta */
    const char *file;          /* of a table */
    ovr_touch_law bears;       /* what all this comes to */
} boundary_form;

typedef struct boundary {
    const boundary_form *given;
    double *A;             /* at the nodes, as observed last */
    double *saved, *bears; /* a film to go back to */
    double wet_force;      /* of boundary friction where there is a film */
} boundary;

/* ---------------------------------------------------------------- the case */

static const ovr_word laws[] = {{"exponential", EXPONENTIAL},
                                {"layer", LAYER},
                                {"greenwood-tripp", GREENWOOD_TRIPP},
                                {"table", TABLE},
                                {NULL, 0}};

static const ovr_word none[] = {{"none", NAN}, {NULL, 0}};

static const char rough[] = "law = exponential";
static const char with_Rq[] = "law = exponential | greenwood-tripp";
static const char summits[] = "law = greenwood-tripp";

static const ovr_parameter keys[] = {
    {"law", CHOICE(laws), NULL, offsetof(boundary_form, law), true, ALWAYS,
     "what surfaces bear where they touch, of the mean film: exponential, of "
     "roughness that is not on the mesh, greenwood-tripp, of its summits, or a "
     "table, each with a layer beside it; or a layer alone"},
    {"Rq", HEIGHT, "0", offsetof(boundary_form, Rq), true, with_Rq,
     "root mean square height of both surfaces together"},
    {"slope", PLAIN(0, 1), "0", offsetof(boundary_form, slope), true, rough,
     "root mean square slope of both together, a pure number"},
    {"amplitude", STRESS(none, 0, 1e6), "none",
     offsetof(boundary_form, amplitude), true, rough,
     "pressure at no gap, instead of one by the slope"},
    {"decay", OVR_NUMBER, OVR_LENGTH, OVR_IN_HEIGHT, 0, 1e3, false, none,
     "none", offsetof(boundary_form, decay), true, rough,
     "gap over which it falls by e, instead of Rq/2.15"},
    {"layer", HEIGHT, "0", offsetof(boundary_form, layer), true, "law",
     "film at which a layer of boundary lubricant bears ph; 0: none"},
    {"layer_decay", HEIGHT, "0", offsetof(boundary_form, layer_decay), true,
     "layer > 0", "film over which that falls by e; 0: a third of it"},
    {"friction", PLAIN_OR(none, 0, 2), "none",
     offsetof(boundary_form, friction), true, "law",
     "friction of what touches over the pressure it bears"},
    {"summits", PLAIN(0, 1), "0.05", offsetof(boundary_form, summits), true,
     summits,
     "summits an area times their radius times Rq, n beta sigma: measured "
     "0.03 to 0.06"},
    {"sharpness", PLAIN(0, 1), "0.01", offsetof(boundary_form, sharpness), true,
     summits, "Rq over the radius of summits, sigma/beta: 0.0001 to 0.01"},
    {"file", PATH, NULL, offsetof(boundary_form, file), true, "law = table",
     "pressure over the mean gap, two columns under a header like 'gap [nm], "
     "pressure [MPa]'"}};

static const ovr_section section = {
    .name = "boundary",
    .on = "law",
    .help = "mixed lubrication: surfaces that touch through their film",
    ROWS(keys)};

/* What the roughness is given by. */
static ovr_status resolve_exponential(const ovr_physics_case *of,
                                      boundary_form *f, ovr_error *err)
{
    double kappa = of->contact->kappa;
    if (isnan(f->decay))
        f->decay = f->Rq / 2.15;
    if (!(f->decay > 0))
        return ovr_fail_about(err, "Rq",
                              "law = exponential wants Rq, of both surfaces "
                              "together, or decay; above 0");
    if (!isnan(f->amplitude))
        return OVR_OK;
    if (!(f->slope > 0))
        return ovr_fail_about(err, "slope",
                              "law = exponential wants slope, the root mean "
                              "square one, or amplitude; above 0");
    if (!(kappa > 0))
        return ovr_fail_about(err, "slope",
                              "slope becomes a pressure by the modulus, which "
                              "is not known; give amplitude in ph");
    f->amplitude = 0.38 * f->slope * 2 / kappa;
    return OVR_OK;
}

/* E* = E'/2 in ph is 2/kappa. */
static ovr_status resolve_summits(const ovr_physics_case *of, boundary_form *f,
                                  ovr_error *err)
{
    double kappa = of->contact->kappa;
    if (!(f->Rq > 0))
        return ovr_fail_about(err, "Rq",
                              "law = greenwood-tripp wants Rq, of both "
                              "surfaces together, above 0");
    if (!(f->summits > 0 && f->sharpness > 0))
        return ovr_fail_about(err, f->summits > 0 ? "sharpness" : "summits",
                              "law = greenwood-tripp wants it above 0");
    if (!(kappa > 0))
        return ovr_fail_about(err, "law",
                              "greenwood-tripp becomes a pressure by the "
                              "modulus, which is not known");
    return ovr_touch_greenwood_tripp(&f->bears.table, f->Rq, f->summits,
                                     f->sharpness, 2 / kappa, of->arena, err);
}

/* Where it bears what it bears at no gap, all is in contact, by the rule of the
 * exponential. */
static ovr_status take_points(const ovr_physics_case *of,
                              const ovr_physics_columns *c, boundary_form *f,
                              ovr_error *err)
{
    ovr_touch_table *t = &f->bears.table;
    double most, slope;
    for (size_t k = 0; k < c->count; k++)
        if (!(c->y[k] > 0) ||
            (k && !(c->x[k] > c->x[k - 1] && c->y[k] < c->y[k - 1])))
            return ovr_fail_at(err, OVR_BAD_INPUT, f->file, 0,
                               "point %zu: gaps must rise, pressures fall and "
                               "be above 0",
                               k + 1);
    if (c->count < 2)
        return ovr_fail_at(err, OVR_BAD_INPUT, f->file, 0,
                           "has %zu points: two are the least", c->count);
    if (ovr_touch_table_take(t, c->count, of->arena, err))
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < c->count; k++) {
        t->H[k] = c->x[k] / of->contact->height;
        t->ln_A[k] = log(c->y[k] / of->contact->ph);
    }
    ovr_touch_table_slopes(t);
    ovr_touch_law_at(&f->bears, 0, &most, &slope);
    for (size_t k = 0; k < c->count; k++)
        t->area[k] = fmin(1, 0.95 * exp(t->ln_A[k]) / most);
    return OVR_OK;
}

static ovr_status resolve_table(const ovr_physics_case *of, boundary_form *f,
                                ovr_error *err)
{
    ovr_physics_columns c = {.name = {"gap", "pressure"},
                             .of = {OVR_LENGTH, OVR_PRESSURE},
                             .example = "gap [nm], pressure [MPa]"};
    if (!f->file)
        return ovr_fail_about(err, "file", "law = table wants file");
    if (!(of->contact->height > 0 && of->contact->ph > 0))
        return ovr_fail_about(err, "file",
                              "a table in metres and pascals needs a physical "
                              "contact: radius and modulus beside alpha");
    if (of->read(of->data, "file", f->file, &c, err))
        return err->status;
    return take_points(of, &c, f, err);
}

static ovr_status resolve_layer(boundary_form *f, ovr_error *err)
{
    if (f->law == LAYER && !(f->layer > 0))
        return ovr_fail_about(err, "layer",
                              "law = layer wants layer, its film, above 0");
    if (!(f->layer_decay > 0))
        f->layer_decay = f->layer / 3;
    f->bears.layer = f->layer;
    f->bears.layer_decay = f->layer_decay;
    return OVR_OK;
}

static ovr_status resolve_law(const ovr_physics_case *of, boundary_form *f,
                              ovr_error *err)
{
    f->bears = (ovr_touch_law){0};
    if (f->law == EXPONENTIAL && resolve_exponential(of, f, err))
        return OVR_BAD_INPUT;
    if (f->law == EXPONENTIAL) {
        f->bears.amplitude = f->amplitude;
        f->bears.decay = f->decay;
    }
    if (f->law == GREENWOOD_TRIPP && resolve_summits(of, f, err))
        return err->status;
    if (f->law == TABLE && resolve_table(of, f, err))
        return err->status;
    return resolve_layer(f, err);
}

static bool bears(const boundary_form *f)
{
    return f->bears.amplitude > 0 || f->bears.layer > 0 || f->bears.table.n;
}

static double unloaded(double X)
{
    double root = sqrt(X * X - 1);
    return 0.5 * (X * root - log(X + root));
}

/* Beyond what |X| the gap of the dry contact bears less than this. */
static double ends_at(const boundary_form *f)
{
    const double enough = 1e-5, farthest = 20;
    double X = 1, A = 1, slope;
    while (A > enough && X < farthest) {
        X += 0.05;
        ovr_touch_law_at(&f->bears, unloaded(X), &A, &slope);
    }
    return X;
}

/* The domain goes out as far as surfaces touch, where it is not given; on one
 * grid, of second order. */
static ovr_status resolve_options(const ovr_physics_case *of,
                                  const boundary_form *f, ovr_error *err)
{
    enum { FINEST = 9 };
    ovr_options *o = of->options, with = *o;
    double end = ends_at(f);
    ovr_options_domain(of->contact, &with);
    if (o->outlet == 0 || isnan(o->outlet))
        o->outlet = fmax(with.outlet, end);
    if (o->inlet == 0 || isnan(o->inlet))
        o->inlet = fmin(with.inlet, -end);
    if (o->level > FINEST || o->level == 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "[boundary] is solved by Newton's method on one grid: "
                        "[domain] level = %d or less is possible",
                        FINEST);
    o->coarsest_level = o->level;
    if (!o->order) /* 4 is refused by the table of pairs */
        o->order = 2;
    return OVR_OK;
}

static ovr_status resolve(const ovr_physics_case *of, void *form, bool *on,
                          ovr_error *err)
{
    const double high = 0.7e9, slides = 0.05;
    boundary_form *f = form;
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
            "surfaces that touch at ph = %.2g GPa and slide by %.2g of the "
            "mean speed want an oil that shears thin: [lubricant] rheology = "
            "eyring does",
            of->contact->ph / 1e9, V);
    return resolve_options(of, f, err);
}

/* What the film that smooth surfaces have would bear, of Hertz's pressure. */
static double share_foreseen(const ovr_physics_case *of, const boundary_form *f)
{
    enum { NODES = 200 };
    double H = ovr_film_central_moes(of->contact->M, of->contact->L), A, slope;
    double sum = 0;
    ovr_touch_law_at(&f->bears, H, &A, &slope);
    for (int i = 0; i < NODES; i++) {
        double X = (i + 0.5) / NODES;
        sum += fmin(sqrt(1 - X * X), A) / NODES;
    }
    return sum * 4 / acos(-1.0);
}

static void tell(const ovr_physics_case *of, const void *form,
                 ovr_physics_line *line, void *data)
{
    const boundary_form *f = form;
    char text[160];
    if (f->bears.amplitude > 0) {
        snprintf(text, sizeof text,
                 "%.4g ph at no gap, falls by e in %.4g b^2/R", f->amplitude,
                 f->decay);
        line(data, "roughness bears", text);
    }
    if (f->bears.table.n) {
        double A, slope;
        ovr_touch_law_at(&f->bears, 0, &A, &slope);
        snprintf(text, sizeof text,
                 "%.4g ph at no gap, falls by e in %.4g b^2/R there", A,
                 A / slope);
        line(data, "roughness bears", text);
    }
    if (f->layer > 0) {
        snprintf(text, sizeof text,
                 "ph at a film of %.4g b^2/R, falls by e in %.4g", f->layer,
                 f->layer_decay);
        line(data, "a layer bears", text);
    }
    snprintf(text, sizeof text,
             "some %.2g of the load, by the film of smooth surfaces; no oil is "
             "trapped: an upper bound",
             share_foreseen(of, f));
    line(data, "surfaces that touch", text);
}

/* ----------------------------------------------------------- its simulation */

static ovr_status take(ovr_simulation *sim, const void *form, void **own,
                       ovr_error *err)
{
    boundary *b = ovr_arena_take(&sim->arena, 1, sizeof *b, err);
    size_t n = sim->finest->grid.n;
    if (!b)
        return OVR_NO_MEMORY;
    *own = b;
    double **const all[] = {&b->A, &b->saved, &b->bears};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (!(*all[k] = ovr_arena_take(&sim->arena, n, sizeof **all[k], err)))
            return OVR_NO_MEMORY;
    if (ovr_physics_take_borne(sim, err) ||
        ovr_hierarchy_touch(&sim->grids, &sim->arena, err))
        return OVR_NO_MEMORY;
    b->given = form;
    sim->grids.touch.at = ovr_touch_law_at;
    sim->grids.touch.law = &b->given->bears;
    sim->grids.touch.share = 1;
    return OVR_OK;
}

static void forget(ovr_simulation *sim, void *own)
{
    boundary *b = own;
    memset(b->A, 0, sim->now.n * sizeof *b->A);
    sim->grids.touch.share = 0;
}

/* The film by a share of the law; from where it was, if there is none. */
static bool reach(ovr_simulation *sim, boundary *b, double share,
                  const ovr_full *how, ovr_defect *d, int *cycles)
{
    const double enough = 1e-4;
    ovr_hierarchy *grids = &sim->grids;
    ovr_level *finest = sim->finest;
    ovr_defect was = *d;
    double H0 = grids->H0, old = grids->touch.share;
    ovr_level_read(grids, finest, finest->f.P, b->saved);
    ovr_level_read(grids, finest, finest->borne, b->bears);
    grids->touch.share = share;
    *d = ovr_steady_cycles(sim, how, cycles);
    if (ovr_below(*d, enough))
        return true;
    *d = was;
    grids->H0 = H0;
    grids->touch.share = old;
    ovr_level_write(grids, finest, b->saved, finest->f.P);
    ovr_level_write(grids, finest, b->bears, finest->borne);
    ovr_level_refresh(grids, finest);
    return false;
}

/* First the film of surfaces that do not touch; then of the law at once, or
 * share by share. */
static ovr_defect solve(ovr_simulation *sim, void *own, const ovr_full *how,
                        int *cycles)
{
    const double begins = 1e-8, smallest = 1.05;
    boundary *b = own;
    ovr_defect d;
    double factor = 1 / begins, from = begins;
    ovr_simulation_gap(sim, 0);
    d = ovr_steady_film(sim, how, cycles);
    while (from < 1 && factor > smallest) {
        double to = fmin(from * factor, 1);
        if (reach(sim, b, to, how, &d, cycles))
            from = to;
        else
            factor = sqrt(factor);
    }
    if (from < 1)
        d.imbalance = INFINITY;
    return d;
}

/* Each attempt begins with what was borne at the last time reached, the
 * grids' side of it where the speed has turned since. */
static void attempt(ovr_simulation *sim, void *own, bool first)
{
    (void)own;
    (void)first;
    ovr_physics_borne_back(sim);
}

/* ---------------------------------------------------------------- observed */

static void read_borne(ovr_simulation *sim, boundary *b)
{
    ovr_nodes_read(sim, sim->finest, sim->finest->borne, b->A);
}

/* -sgn(V) mu_b A/kappa at the half node i + 1/2. */
static double drag_at(const ovr_simulation *sim, const boundary *b, size_t i)
{
    double V = ovr_sliding(sim, sim->state.T), mu = b->given->friction;
    double side = V > 0 ? -1 : V < 0 ? 1 : 0;
    if (isnan(mu) || side == 0)
        return 0;
    return side * mu * 0.5 * (b->A[i] + b->A[i + 1]) / sim->contact.kappa;
}

static void friction(const ovr_simulation *sim, const void *own, double *t)
{
    boundary *b = (boundary *)own;
    const double *P = sim->now.P, *X = sim->now.X;
    read_borne((ovr_simulation *)sim, b);
    b->wet_force = 0;
    for (size_t i = 0; i + 1 < sim->now.n; i++) {
        double drag = drag_at(sim, b, i);
        double H = 0.5 * (sim->now.H[i] + sim->now.H[i + 1]);
        t[i] = (1 - ovr_touch_law_area(&b->given->bears, H)) * t[i] + drag;
        if (P[i] > 0 || P[i + 1] > 0)
            b->wet_force += drag * (X[i + 1] - X[i]);
    }
}

static void heat(const ovr_simulation *sim, const void *own, double *power)
{
    boundary *b = (boundary *)own;
    double V = fabs(ovr_sliding(sim, sim->state.T)), mu = b->given->friction;
    if (isnan(mu) || V == 0)
        return;
    read_borne((ovr_simulation *)sim, b);
    for (size_t i = 0; i < sim->now.n; i++)
        power[i] += mu * b->A[i] * V / sim->contact.kappa;
}

enum { SHARE, AREA, A_MAX, H_CONTACT, MU_FILM, MU_BOUNDARY };

static const ovr_observable quantities[] = {
    OVR_NUMBER_ROW("contact_share", "contact_share", NULL, NUMBER, more[SHARE],
                   OVR_PHYSICS_BOUNDARY,
                   "share of the load that surfaces bear where they touch",
                   LABEL("contact share"), LARGEST("contact_share_max"),
                   EXTREME_LABEL("largest contact share"),
                   MEAN("contact_share_mean"), PASS(MEAN)),
    OVR_NUMBER_ROW("contact_area", "contact_area", "contact_area_m", LENGTH,
                   more[AREA], OVR_PHYSICS_BOUNDARY,
                   "length along x that is in contact, summed over its summits",
                   LABEL("length in contact")),
    OVR_NUMBER_ROW("max_contact_pressure", "A_max", "max_contact_pressure_Pa",
                   PRESSURE, more[A_MAX], OVR_PHYSICS_BOUNDARY,
                   "largest pressure of surfaces that touch",
                   LABEL("largest contact pressure"), LARGEST("A_max_overall"),
                   EXTREME_LABEL("largest contact pressure")),
    OVR_NUMBER_ROW("contact_film", "H_contact", "contact_film_m", HEIGHT,
                   more[H_CONTACT], OVR_PHYSICS_BOUNDARY,
                   "smallest film where surfaces touch",
                   LABEL("film of contact")),
    OVR_NUMBER_ROW("mu_film", "mu_film", NULL, NUMBER, more[MU_FILM],
                   OVR_PHYSICS_BOUNDARY,
                   "coefficient of friction of the film's share",
                   LABEL("friction of the film"), MEAN("mu_film_mean")),
    OVR_NUMBER_ROW("mu_boundary", "mu_boundary", NULL, NUMBER,
                   more[MU_BOUNDARY], OVR_PHYSICS_BOUNDARY,
                   "coefficient of friction of the surfaces' share",
                   LABEL("boundary friction"), MEAN("mu_boundary_mean"))};

static void unknown(ovr_observation *o)
{
    (void)o;
}

/* Both forces, once the film's integral has those where it is wet. */
static void observe_friction(const ovr_simulation *sim, const boundary *b,
                             ovr_observation *o)
{
    const double *X = sim->now.X;
    double load = OVR_NOMINAL_LOAD * o->load_ratio, V = o->sliding, drag = 0;
    double coefficient = load > 0 ? sim->contact.kappa / load : NAN;
    for (size_t i = 0; i + 1 < sim->now.n; i++)
        drag += drag_at(sim, b, i) * (X[i + 1] - X[i]);
    o->more[MU_FILM] = coefficient * fabs(o->F_slide - b->wet_force);
    o->more[MU_BOUNDARY] = coefficient * fabs(drag);
    o->F_slide += drag - b->wet_force;
    o->F_1 = o->F_slide - o->F_roll;
    o->F_2 = -o->F_slide - o->F_roll;
    o->mu_1 = coefficient * o->F_1;
    o->mu_2 = coefficient * o->F_2;
    o->mu_slide = copysign(coefficient * o->F_slide, V);
    o->power_in -= V * (drag - b->wet_force);
    o->power_dissipated -= V * (drag - b->wet_force);
    if (isnan(b->given->friction))
        o->more[MU_BOUNDARY] = o->mu_1 = o->mu_2 = o->mu_slide = NAN;
}

static void observe(ovr_simulation *sim, void *own, ovr_observation *o)
{
    const double touches = 1e-3;
    boundary *b = own;
    double borne = 0, area = 0, most = 0, least = NAN;
    read_borne(sim, b);
    for (size_t i = 0; i < sim->now.n; i++) {
        double w = sim->now.weights[i], A = b->A[i];
        borne += w * A;
        area += w * ovr_touch_law_area(&b->given->bears, sim->now.H[i]);
        most = fmax(most, A);
        if (A > touches)
            least = fmin(least, sim->now.H[i]);
    }
    o->more[SHARE] = o->load > 0 ? borne / o->load : NAN;
    o->more[AREA] = area;
    o->more[A_MAX] = most;
    o->more[H_CONTACT] = least;
    observe_friction(sim, b, o);
}

static void review(const ovr_simulation *sim, const void *own,
                   ovr_physics_say *say, void *data)
{
    const double enough = 1e-5;
    const boundary *b = own;
    const ovr_solution *now = &sim->now;
    double A, slope;
    char text[160];
    ovr_touch_law_at(&b->given->bears, now->H[now->n - 1], &A, &slope);
    if (A > enough) {
        snprintf(text, sizeof text,
                 "surfaces touch at the outlet, with %.2g ph: a larger "
                 "[domain] outlet takes that in",
                 A);
        say(data, true, text);
    }
    if (sim->observation.more[SHARE] > 0.01 && isnan(b->given->friction))
        say(data, false,
            "friction is not known where surfaces touch, until [boundary] "
            "friction says what theirs is");
}

const ovr_physics ovr_physics_boundary = {.name = "surfaces that touch",
                                          .bit = OVR_PHYSICS_BOUNDARY,
                                          .section = &section,
                                          .form = sizeof(boundary_form),
                                          .resolve = resolve,
                                          .tell = tell,
                                          .take = take,
                                          .forget = forget,
                                          .solve = solve,
                                          .attempt = attempt,
                                          .friction = friction,
                                          .heat = heat,
                                          .unknown = unknown,
                                          .observe = observe,
                                          .quantity = quantities,
                                          .quantities = sizeof quantities /
                                                        sizeof *quantities,
                                          .review = review};
