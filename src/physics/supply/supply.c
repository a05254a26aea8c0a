/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lubricant supply at the inlet, and volume V in the inlet reservoir.
 *
 *     dV/dT = Cu q_f - f,   q_f = q_s where the face of the first cell was
 *                           half a mesh of travel ago, f the inflow
 *
 * A flooded contact draws in f. When V is used up, the first node becomes
 * cavitated and the inflow is the supply, f = Cu q_f, until that node becomes
 * full again. V may remain slightly negative; no mass is lost.
 */
#include <math.h>
#include <stdio.h>

#include "contact/contact.h"
#include "contact/curvature.h"
#include "contact/film_formula.h"
#include "multigrid/content.h"
#include "physics/companion.h"
#include "physics/supply/supply.h"
#include "simulation/fourth.h"
#include "simulation/observe.h"
#include "simulation/physics.h"
#include "simulation/quantity_row.h"
#include "simulation/simulation.h"

void ovr_simulation_supply(ovr_simulation *sim, ovr_supply *supply, void *data,
                           double reservoir)
{
    if (!sim)
        return;
    ovr_arrival *a = &sim->arrival;
    *a = (ovr_arrival){.supply = supply,
                       .data = data,
                       .before = reservoir,
                       .reservoir = reservoir,
                       .kept = a->kept,
                       .carriage = a->carriage};
}

/* ------------------------------------------------------------------- a step */

/* Time at which the lubricant that is at X_a + D/2 at time T was at X_a: the
 * distance is the integral of Cu. Before T = 0 the supply is that at T = 0. */
static double time_of_entry(const ovr_simulation *sim, double T)
{
    enum { HALVINGS = 60 };
    double distance = sim->now.weights[0];
    double from = ovr_history_integral(sim->histories.speed, T) - distance;
    double low = 0, high = T;
    if (from <= 0)
        return 0;
    for (int k = 0; k < HALVINGS; k++) {
        double middle = 0.5 * (low + high);
        *(ovr_history_integral(sim->histories.speed, middle) < from
              ? &low
              : &high) = middle;
    }
    return 0.5 * (low + high);
}

static void step(ovr_simulation *sim, void *own, double dT)
{
    ovr_arrival *a = own;
    double T = sim->past.T[0] + dT;
    if (!a->supply)
        return;
    a->q = a->supply(a->data, T);
    a->face = a->supply(a->data, time_of_entry(sim, T));
}

/* Source term of the inlet row; zero along the characteristic, where the
 * history term contains the supply. */
static double source(const ovr_simulation *sim, const ovr_arrival *a)
{
    const ovr_operator *op = &sim->grids.op;
    return op->characteristic ? 0 : op->speed * a->face / sim->now.weights[1];
}

/* Restores contents, phases and inlet of a solution from its pressure. */
static void restore(ovr_simulation *sim, const ovr_arrival *a, const double *P,
                    const double *q, bool closed)
{
    ovr_level *level = sim->finest;
    sim->grids.conserving = level->leads = true;
    sim->grids.supplied = a->supply != NULL;
    ovr_level_write(&sim->grids, level, q, level->f.q);
    ovr_content_wet(level, P);
    if (closed)
        ovr_content_close(level, source(sim, a), a->q);
    else
        ovr_content_open(level);
}

/* Restores contents, phases and inlet at the start of an attempt. */
static void begin_attempt(ovr_simulation *sim, void *own)
{
    const ovr_arrival *a = own;
    ovr_level *level = sim->finest;
    bool closing = a->supply && !a->closed && a->reservoir < 0;
    restore(sim, a, sim->past.P[0], sim->past.q[0], ovr_arrival_closes(sim));
    if (closing) {
        ovr_content_mark(level, level->f.wet, 1, false);
        ovr_content_mark(level, level->f.dried, 1, true);
        level->f.P[ovr_lanes_place(&level->lanes, 1)] = 0;
    }
}

static void attempt(ovr_simulation *sim, void *own, bool corrected)
{
    (void)corrected;
    begin_attempt(sim, own);
}

static void keep(ovr_simulation *sim, void *own)
{
    ovr_arrival *a = own;
    ovr_level_read(&sim->grids, sim->finest, sim->finest->f.q, a->kept);
    a->closed_kept = sim->finest->closed;
}

static void restore_kept(ovr_simulation *sim, void *own, const double *P)
{
    const ovr_arrival *a = own;
    restore(sim, a, P, a->kept, a->closed_kept);
}

/* Flow through half node i + 1/2 of the first or last row at T, after a step;
 * along the characteristic, the content that crossed it. */
static double flow_at(const ovr_simulation *sim, size_t i, double T)
{
    const ovr_carriage *c = &sim->arrival.carriage;
    if (!sim->scheme->characteristic || !(T > 0))
        return ovr_flux(sim, ovr_history_value(sim->histories.speed, T), i);
    return ovr_flux(sim, 0, i) + c->flow[i > 0];
}

/* Updates the volume in the inlet reservoir. */
static void accepted(ovr_simulation *sim, void *own, double dT)
{
    ovr_arrival *a = own;
    double T = sim->past.T[0] + dT;
    bool along = sim->scheme->characteristic;
    if (along)
        ovr_carriage_taken(sim);
    if (!a->supply)
        return;
    double arrives = along
                         ? a->carriage.arrives
                         : ovr_history_value(sim->histories.speed, T) * a->face;
    a->reservoir += dT * (arrives - flow_at(sim, 0, T));
    a->closed = sim->finest->closed;
}

/* ------------------------------------------------------------------- steady */

/* Opens inlets that an attempt has closed: the next attempt starts from a
 * flooded film. */
static void forget(ovr_simulation *sim, void *own)
{
    ovr_hierarchy *grids = &sim->grids;
    (void)own;
    for (int l = grids->coarsest; l <= grids->finest; l++)
        if (grids->level[l].closed)
            ovr_content_open(&grids->level[l]);
    grids->conserving = false;
}

/* Computes the flooded film with mass-conserving cavitation from that of the
 * Reynolds equation. */
static ovr_defect complete(ovr_simulation *sim, void *own, const ovr_full *how,
                           int *cycles)
{
    ovr_arrival *a = own;
    a->reservoir = a->before;
    a->closed = false;
    ovr_level_clear(sim->finest, sim->finest->f.kept);
    ovr_defect d = ovr_flooded(&sim->grids, how, cycles);
    return ovr_fourth_conserved(sim, how, d, cycles);
}

/* True if the supply is less than the flooded flow rate. */
static bool lacks(ovr_simulation *sim, ovr_arrival *a)
{
    a->flooded = ovr_level_centre(sim->finest, sim->finest->f.H);
    a->flow = ovr_content_leaving(sim->finest);
    if (!a->supply)
        return false;
    a->q = a->face = a->supply(a->data, 0);
    return a->q < a->flow && !isinf(a->before);
}

/* Starves the film if necessary. The supply may exceed the flow rate of the hot
 * film but not the flow rate of the cold film; it is therefore compared after
 * everything else has converged. */
static bool starve(ovr_simulation *sim, void *own, const ovr_full *how,
                   ovr_outcome *outcome)
{
    ovr_arrival *a = own;
    if (!lacks(sim, a))
        return false;
    ovr_fourth_leave(sim);
    ovr_defect d = ovr_starve(&sim->grids, how, a->q, &outcome->cycles);
    outcome->defect = ovr_fourth_conserved(sim, how, d, &outcome->cycles);
    a->closed = sim->finest->closed;
    return true;
}

/* --------------------------------------------------------------- the equation
 */

/* With second-order schemes, outflow and time derivative are limited at
 * cavitated nodes; along the characteristic there is no outflow term. */
static void operate(const ovr_simulation *sim, const void *own, double dT,
                    ovr_operator *op)
{
    (void)own;
    if (sim->scheme->order != 2)
        return;
    if (!op->characteristic)
        op->limited[0] = op->speed;
    if (dT > 0)
        op->limited[1] = 0.5 / dT - op->cT;
}

static void history(ovr_simulation *sim, void *own, double dT,
                    const double c[2])
{
    (void)own;
    ovr_content_history(sim, dT, c);
}

/* Content at the half node: the supply if the inlet is closed; limited at
 * cavitated nodes (multigrid/content.h). */
static double carried(const ovr_simulation *sim, const void *own, size_t i,
                      double q)
{
    const ovr_arrival *a = own;
    double half = 0.5 * sim->now.q[i];
    if (i == 0)
        return sim->finest->closed ? a->face : q;
    return !(sim->now.P[i] > 0) && q < half ? half : q;
}

/* --------------------------------------------------- observed quantities */

/* Position of the inlet meniscus: start of the pressurized region that contains
 * the maximum P. The cell before it is filled in part, on its downstream side,
 * so that the position is continuous when a node becomes pressurized. */
static double meniscus(const ovr_simulation *sim)
{
    const ovr_solution *s = &sim->now;
    size_t i = sim->grids.kernels->extreme(s->n, -1, s->P);
    while (i > 0 && s->P[i - 1] > 0)
        i--;
    if (i <= 1 || !(s->P[i] > 0))
        return NAN;
    double D = ovr_spacing(s, i - 1), before = s->q[i - 2];
    double part = (s->q[i - 1] - before) / (s->H[i - 1] - before);
    return s->X[i - 1] + D / 2 - D * part;
}

static double cavity_length(const ovr_solution *s)
{
    size_t first = 0, last = s->n - 1;
    double length = 0;
    while (first < last && !(s->P[first] > 0))
        first++;
    while (last > first && !(s->P[last] > 0))
        last--;
    for (size_t i = first; i < last; i++)
        if (!(s->P[i] > 0))
            length += s->weights[i];
    return length;
}

/* Mass error: inflow - outflow - stored change is the sum of residuals of the
 * rows. */
static double mass_defect(const ovr_simulation *sim)
{
    double *r = ovr_work_take(sim);
    ovr_level_read(&sim->grids, sim->finest, sim->finest->f.r, r);
    double total = ovr_integral(sim, r);
    ovr_work_give(sim, r);
    return -total / sim->observation.H_cen;
}

static void unknown(ovr_observation *o)
{
    o->starvation_factor = o->inflow_ratio = NAN;
    o->supply = o->meniscus = o->inflow = o->outflow = NAN;
    o->oil_inside = o->oil_reservoir = o->cavity_length = o->mass_defect = NAN;
}

/* Flooded film thickness by the formula, in units of the reference contact. */
static double formula(const ovr_simulation *sim, double T)
{
    double Cw = fmax(ovr_history_value(sim->histories.load, T), OVR_MIN_START);
    double Cu = fmax(fabs(ovr_history_value(sim->histories.speed, T)),
                     OVR_MIN_START);
    ovr_instant at = ovr_instant_of(
        &sim->contact, Cw, Cu, 1 / ovr_history_value(sim->histories.radius, T));
    return Cw * ovr_film_central_moes(at.M, at.L);
}

/* Ratio of the flooded film thickness at T to that of the start, which was
 * solved; NAN: the surfaces hardly move, and no lubricant is drawn in. */
static double flooded_since(const ovr_simulation *sim, double T)
{
    const double minimum = 0.01;
    if (!ovr_history_varies(sim->histories.load) &&
        !ovr_history_varies(sim->histories.speed) &&
        !ovr_history_varies(sim->histories.radius))
        return 1;
    return fabs(ovr_history_value(sim->histories.speed, T)) < minimum
               ? NAN
               : formula(sim, T) / formula(sim, 0);
}

static void observe(ovr_simulation *sim, void *own, ovr_observation *o)
{
    const ovr_solution *s = &sim->now;
    const ovr_arrival *a = own;
    o->supply = a->supply ? a->q : NAN;
    double now = flooded_since(sim, o->T);
    o->starvation_factor = o->H_cen / (a->flooded * now);
    o->inflow_ratio = a->flow > 0 ? o->supply / (a->flow * now) : NAN;
    o->meniscus = meniscus(sim);
    o->inflow = flow_at(sim, 0, o->T);
    o->outflow = flow_at(sim, s->n - 2, o->T);
    o->oil_inside = ovr_integral(sim, s->q);
    o->oil_reservoir = a->supply ? a->reservoir : NAN;
    o->cavity_length = cavity_length(s);
    o->mass_defect = mass_defect(sim);
}

/* --------------------------------------------------------------- checkpoint */

static void visit(ovr_simulation *sim, void *own, ovr_pieces *state)
{
    ovr_arrival *a = own;
    OVR_SHOW(state, "oil_waiting", a->reservoir);
    OVR_SHOW(state, "inlet_closed", a->closed);
    OVR_SHOW(state, "flooded_film", a->flooded);
    OVR_SHOW(state, "flooded_flow", a->flow);
    ovr_carriage_visit(sim, state);
    OVR_SHOW(state, "mass_defect", sim->observation.mass_defect);
}

static void restored(ovr_simulation *sim, void *own)
{
    step(sim, own, 0);
}

static void recalled(ovr_observation *o, const ovr_observation *saved)
{
    o->mass_defect = saved->mass_defect;
}

/* Warns about a film that begins too close to the inlet. */
static void review(const ovr_simulation *sim, const void *own,
                   ovr_physics_message *say, void *data)
{
    static const double meshes = 4;
    const ovr_options *o = &sim->options;
    double X = sim->observation.meniscus;
    double coarse = (o->outlet - o->inlet) /
                    (double)(ovr_level_nodes(o->coarsest_level) - 1);
    char text[240];
    (void)own;
    if (!(X < o->inlet + meshes * coarse))
        return;
    snprintf(text, sizeof text,
             "the inlet meniscus X = %.3g is closer to the inlet boundary X "
             "= %.3g than coarse grids resolve; set domain.inlet further "
             "upstream",
             X, o->inlet);
    say(data, true, text);
}

static bool chosen(const ovr_options *o)
{
    return o->cavitation == OVR_CAVITATION_CONSERVING;
}

/* Reports the limits of the model. */
static void report(const ovr_physics_case *of, const void *form,
                   ovr_physics_line *line, void *data)
{
    (void)of, (void)form;
    line(data, "cavitated lubricant",
         "moves at the entrainment speed; an infinitely long "
         "contact passes all supplied lubricant");
}

/* Supplied content; before T = 0 that of the steady start. */
static double arriving(void *data, double T)
{
    const ovr_supply_case *s = data;
    return T <= 0 && isfinite(s->start) ? s->start : ovr_supply_arriving(s, T);
}

static void equip(ovr_simulation *sim, void *form)
{
    const ovr_supply_case *s = form;
    if (s->film)
        ovr_simulation_supply(sim, arriving, form, s->reservoir);
}

static void prepare(ovr_hierarchy *grids)
{
    grids->content = true;
}

static ovr_status create(ovr_simulation *sim, const void *form, void **own,
                         ovr_error *err)
{
    ovr_arrival *a = &sim->arrival;
    (void)form;
    *own = a;
    return OVR_TAKE_NODES(sim, err, &a->kept) ? OVR_NO_MEMORY
                                              : ovr_carriage_take(sim, err);
}

#define OIL(name, key, kind, member, ...)                                      \
    OVR_NUMBER_ROW(name, key, NULL, kind, member, OVR_PHYSICS_CONTENT,         \
                   __VA_ARGS__)

static const ovr_observable quantities[] = {
    OIL("supply", NULL, HEIGHT, supply, "lubricant supply",
        COMMENT("rho h upstream of the inlet"), PASS(MEAN)),
    OIL("meniscus", "X_meniscus", LENGTH, meniscus, "inlet meniscus position",
        COMMENT("NaN: fully flooded"), PASS(MEAN), PASS_HEAD(3, "meniscus")),
    OIL("film_ratio", "film_ratio", NUMBER, starvation_factor,
        "starvation factor",
        COMMENT("central film thickness relative to the flooded contact"),
        PASS(MEAN)),
    OIL("supply_ratio", "supply_ratio", NUMBER, inflow_ratio, "supply ratio",
        COMMENT("supplied relative to flooded flow rate"), PASS(MEAN),
        PASS_HEAD(4, "supply")),
    OIL("inflow", NULL, FLOW, inflow, "mass flow rate at the inlet",
        PASS(MEAN)),
    OIL("outflow", NULL, FLOW, outflow, "mass flow rate at the outlet",
        PASS(MEAN)),
    OIL("oil_inside", NULL, AREA, oil_inside, "lubricant volume in the domain"),
    OIL("oil_waiting", NULL, AREA, oil_reservoir,
        "lubricant volume in the inlet reservoir", PASS(END)),
    OIL("cavity_length", NULL, LENGTH, cavity_length, "cavity length"),
    OIL("mass_defect", NULL, NUMBER, mass_defect,
        "mass balance error of the scheme",
        COMMENT("relative to the central film thickness"))};

/* ------------------------------------------------------- Companion of a run */

/* Tolerance of the film thickness formulas; also, the flow rate of
 * incompressible lubricant is proportional to its film thickness. */
static const double SURE = 1.1;

static double flooded(const ovr_setup *s)
{
    const ovr_contact *c = s->contact;
    double density = ovr_density(s->lubricant, 1);
    ovr_film_fit fit = ovr_film_fitted(c->M, c->L, density);
    if (s->lubricant->viscosity_law == OVR_ROELANDS &&
        s->lubricant->density_law == OVR_DOWSON_HIGGINSON &&
        isfinite(fit.central))
        return density * fit.central;
    return ovr_film_central_moes(c->M, c->L);
}

/* Warns if the supply exceeds the flooded flow rate by the film thickness
 * formula. */
static void warn_of_flooding(const ovr_setup *setup, ovr_listener *say,
                             void *data)
{
    const ovr_supply_case *supply = ovr_setup_supply(setup);
    double arrives, taken = flooded(setup);
    if (!supply->film || isinf(supply->reservoir))
        return;
    arrives = ovr_supply_arriving(supply, 0);
    if (!(arrives > SURE * taken))
        return;
    ovr_warn(say, data,
             "the supply of %.3g exceeds the flooded flow rate of about "
             "%.2g; the excess collects in the inlet reservoir",
             arrives, taken);
}

static const ovr_companion companion = {.review_before = warn_of_flooding};

static const ovr_physics_in_case in_case = {.node_seconds = 1e-7,
                                            .section = ovr_supply_sections,
                                            .sections = 2,
                                            .behind = "radius_1",
                                            .form = sizeof(ovr_supply_case),
                                            .choose = ovr_supply_choose,
                                            .resolve = ovr_supply_resolve,
                                            .drop = ovr_supply_drop,
                                            .effects = ovr_supply_state,
                                            .one_mesh = "as menisci move",
                                            .describe = report};

static const ovr_physics_in_solve in_solve = {.equip = equip,
                                              .chosen = chosen,
                                              .prepare = prepare,
                                              .take = create,
                                              .forget = forget,
                                              .complete = complete,
                                              .proceed = starve};

static const ovr_physics_in_step in_step = {.operate = operate,
                                            .history = history,
                                            .step = step,
                                            .attempt = attempt,
                                            .keep = keep,
                                            .go_back = restore_kept,
                                            .accepted = accepted,
                                            .step_back = begin_attempt,
                                            .visit = visit,
                                            .restored = restored,
                                            .recalled = recalled};

static const ovr_physics_in_output in_output = {.companion = &companion,
                                                .review = review,
                                                .carried = carried,
                                                .unknown = unknown,
                                                OVR_QUANTITIES(quantities),
                                                .observe = observe};

const ovr_physics ovr_physics_conserving = {.name = "oil conserved",
                                            .bit = OVR_PHYSICS_CONTENT,
                                            .in_case = &in_case,
                                            .in_solve = &in_solve,
                                            .in_step = &in_step,
                                            .in_output = &in_output};
