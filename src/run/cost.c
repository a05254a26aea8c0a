/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/cost.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "contact/film_formula.h"
#include "physics/heat/heat.h"
#include "run/run.h"
#include "surface/surfaces.h"

#include <math.h>

/* The program's start, a node in a step, one of a film that shears thin, the
 * steady start in steps, and a node in a cycle.  User CPU time of 140 random
 * cases of 20 kinds on an AMD EPYC.  The constants are geometric means of
 * kernels with AVX-512 and of the base instruction set, which takes 2 to 3
 * times as long: about those of AVX2. */
static const double START = 0.004, NODE_STEP = 1.8e-7, THINNING = 1.1e-7;
static const double STEADY_STEPS = 12, SECONDS_A_NODE = 5e-8;

/* A multiplication of the preparation of rough surfaces. */
static const double MULTIPLICATION = 8e-10;

/* Time of a run with adaptive steps relative to steps of one mesh size (cams,
 * levels 6 to 8: 0.04 to 0.13). */
static const double ADAPTIVE = 0.07;

/* Steps of a steady start.  With heat 60 to 100 cycles of slow sliding and 300
 * from a slide-to-roll ratio of 2 on. */
static double steady_steps(const ovr_setup *setup)
{
    const double slow = 37, sliding = 23, most = 140;
    double S = setup->contact->u1_ratio - setup->contact->u2_ratio;
    if (!ovr_setup_heat(setup))
        return STEADY_STEPS;
    return isfinite(S) ? fmin(slow + sliding * S * S, most) : most;
}

/* Time of a cycle with more than one sweep before and after, or a W-cycle,
 * relative to the usual one; 82 steps of a dent. */
static double cycle_work(const ovr_options *o)
{
    const double rest = 0.75, sweep = 0.125, twice = 2.5;
    int sweeps = o->sweeps_before + o->sweeps_after;
    return (sweeps ? rest + sweep * fmax(2, sweeps) : 1) *
           (o->cycle_index > 1 ? twice : 1);
}

/* Cycles of a step to a given tolerance relative to the usual ones: 1.7 to
 * 1e-4, 4.6 to 1e-10. */
static double tolerance_work(const ovr_options *o)
{
    const double a_decade = 0.3, usual = 1e-4;
    double tolerance = o->tolerance > 0 ? o->tolerance : usual;
    return 1 + a_decade * fmax(0, log10(usual / tolerance));
}

/*
 * Cycles of a steady film of thickness H with the paper's balance. Its 100
 * sweeps on the coarsest grid change H0 by 0.02 times the error of the load.
 * The load of a rigid film falls by a part 1/H with H0. A cycle thus reduces
 * the error by 3.1/H.  Measured: 2.5 H cycles.  From H = 24 on, 60 cycles are
 * too few, and steps in time take 12 H cycles. Thin films take 10 to 80 cycles.
 */
static double balance_cycles(double film)
{
    const double thin = 30, most = 24;
    return fmax(thin, (film > most ? 12 : 2.5) * film);
}

/* Time of the sweeps on the coarsest grid for the paper's balance. */
static double balance_seconds(const ovr_setup *setup, double steps)
{
    const double node = 1.3e-7, sweeps = 100, cycles = 3; /* of a step */
    const ovr_options *o = setup->options;
    double film = ovr_film_central_moes(setup->contact->M, setup->contact->L);
    if (!o->paper_balance)
        return 0;
    return (balance_cycles(film) + cycles * steps) * sweeps * node *
           (double)ovr_level_nodes(o->coarsest_level);
}

/* Time of local refinement: one cycle per patch down to the grid of the
 * refinement level and some more at the end. Patches that are refined until the
 * spike changes little take eight. */
static double refine_seconds(const ovr_options *o, double nodes)
{
    const double nodes_a_patch = 300, usual = 8, last = 4;
    double levels = o->refine_level ? o->refine_level - o->level : usual;
    if (!o->refine)
        return 0;
    return 2 * SECONDS_A_NODE * (levels + last) *
           (nodes + levels * nodes_a_patch);
}

/* True if feature k is part of the steady start: it lies in the domain at
 * T = 0, where a steady solution holds features that move. */
static bool starts_inside(const ovr_setup *setup, size_t k)
{
    const ovr_options *o = setup->options;
    ovr_feature_info f = ovr_surfaces_info(setup->surfaces, k);
    double centre = ovr_surfaces_centre(setup->surfaces, k, 0);
    if (f.grows)
        return false;
    return f.speed == 0 ||
           (centre + f.ahead > o->inlet && centre - f.behind < o->outlet);
}

/* Pseudo-time steps for a feature whose height is `relative` times the film
 * thickness. Stationary features: 20 to 1500 steps in 60 random contacts.
 * Moving features, 60 contacts: up to 500 `relative` for single shapes, 100 to
 * 1000 `relative` for waves and roughness of unlimited length. */
static double feature_steps(const ovr_feature_info *f, double relative)
{
    const double at_rest = 300, single = 100, endless = 500, most = 3e4;
    if (!(relative > 1))
        return 0;
    if (!isfinite(f->behind) && f->Rq > 0)
        return fmin(endless * relative, most);
    return f->speed == 0 ? at_rest : fmin(single * relative, most);
}

static bool thins(const ovr_setup *setup)
{
    return setup->lubricant->rheology != OVR_NEWTONIAN;
}

/*
 * Cycles of a strip in which a feature grows out of the smooth surfaces. Nested
 * iteration finds the film in 20 to 150 cycles.  Where it does not, 300 to 6000
 * are needed.  The formula is between the two.  Measured with 310 random cases,
 * of which 67 have a feature higher than the film, and 65 strips at M = 0.3 to
 * 1.2.
 *
 * Waves of amplitude A are flattened by the pressure 2 pi A/lambda (A in b^2/R,
 * pressure in p_h).  Features that need much less than p_h hardly ever grow,
 * even if they are 20 times as high as the film.  Waves and protruding features
 * in thick films (M below 1) grow in two cases of three.
 */
static double strip_cycles(const ovr_feature_info *f, double film, bool thinned)
{
    const double two_pi = 6.283185307179586;
    const double one = 25, most = 400, recess = 0.6, thinning = 1.5;
    const double thick = 1, in_thick = 300;
    double pressure = two_pi * f->amplitude / f->wavelength;
    double relative = f->amplitude / film * pressure / (1 + pressure);
    bool raised = f->raised >= 0.5 * f->amplitude;
    if (thinned)
        relative *= thinning;
    if (!(relative > 1))
        return 0;
    if (!raised)
        relative *= recess;
    return fmin(
        fmax(raised && film > thick ? in_thick : 0, one * relative * relative),
        most);
}

/* Time in which features of a strip grow. */
static double strip_growth(const ovr_setup *setup)
{
    const double thinning = 1e-7; /* a node */
    const double lines = (double)ovr_setup_lines(setup);
    double film = ovr_film_central_moes(setup->contact->M, setup->contact->L);
    double cycles = 0;
    for (size_t k = 0, n = ovr_surfaces_count(setup->surfaces); k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
        if (starts_inside(setup, k))
            cycles = fmax(cycles, strip_cycles(&info, film, thins(setup)));
    }
    return cycles *
           (ovr_setup_strip_cycle(setup) +
            (thins(setup) ? thinning * (double)setup->nodes * lines : 0));
}

/* Pseudo-time steps of the steady start. Only features higher than the film
 * thickness need them. Grids that do not resolve the inlet need up to 4000
 * steps. */
static double growing_steps(const ovr_setup *setup)
{
    const double unresolved = 1000;
    double film = ovr_film_central_moes(setup->contact->M, setup->contact->L);
    double steps = 0;
    if (setup->mesh > ovr_resolving_mesh(setup->contact->M, film))
        steps = unresolved;
    for (size_t k = 0, n = ovr_surfaces_count(setup->surfaces); k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
        if (starts_inside(setup, k))
            steps = fmax(steps, feature_steps(&info, info.amplitude / film));
    }
    return steps;
}

ovr_cost ovr_setup_cost(const ovr_setup *setup, double live, double peak)
{
    const ovr_march *march = setup->march;
    double dT = ovr_setup_step(setup);
    ovr_cost cost = {0};
    cost.nodes = (double)setup->nodes;
    cost.mesh = setup->mesh;
    cost.bytes = fmax(peak, live + ovr_setup_memory(setup) +
                                ovr_setup_output_memory(setup));
    if (setup->transient)
        cost.steps = ceil(march->end / dT);
    cost.passes = setup->passes->number;
    cost.stored = ovr_setup_storage(setup);
    cost.stored.bytes *= cost.passes;
    double node_steps = cost.nodes *
                        (steady_steps(setup) +
                         (march->adaptive ? ADAPTIVE : 1) * cost.steps *
                             tolerance_work(setup->options));
    double node_step = (NODE_STEP + (thins(setup) ? THINNING : 0)) *
                       cycle_work(setup->options);
    double pass = node_steps * node_step +
                  ovr_setup_seconds_of_physics(setup, node_steps);
    pass += ovr_setup_lines(setup) > 1
                ? strip_growth(setup)
                : growing_steps(setup) * cost.nodes * node_step;
    pass += setup->resolved->prepared * MULTIPLICATION;
    pass += balance_seconds(setup, cost.steps);
    cost.seconds = START + cost.passes * pass;
    cost.seconds += refine_seconds(setup->options, cost.nodes);
    return cost;
}
