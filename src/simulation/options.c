/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options: defaults and automatic choices. */
#include <math.h>

#include "base/error.h"
#include "base/given.h"
#include "contact/contact.h"
#include "contact/film_formula.h"
#include "contact/starvation.h"
#include "multigrid/mixed_contact.h"
#include "simulation/conflicts.h"
#include "simulation/internal.h"
#include "simulation/limits.h"
#include "simulation/refined.h"
#include "simulation/simulation.h"

ovr_options ovr_options_default(void)
{
    const ovr_options defaults = {.level = 8,
                                  .scheme = OVR_CHARACTERISTIC,
                                  .smoother = OVR_LINE,
                                  .cycle_index = 1,
                                  .cycles = 2,
                                  .stop = OVR_STOP_NEGLIGIBLE,
                                  .switch_value = 3,
                                  .relax_seidel = 0.8,
                                  .relax_dipole = 0.5};
    return defaults;
}

/*
 * Rounding bounds R from below. eps P is about Cu X_a^4/24 for any load; its
 * second difference is divided by D^2 and R by H_cen. Measured: 4.3e-10/H_cen
 * at D = 5.5/7168, X_a = -4, M = 20 to 200; MARGIN times that is used. A
 * solution with R above 1e-3 is not accepted: from level 19 on there is none in
 * double precision.
 */
static const double NO_SOLUTION = 1e-3, MARGIN = 4;

static double rounding_floor(double inlet, double D, double Cu, double H)
{
    double meshes = 5.5 / 7168 / D;
    return 4.3e-10 * Cu * meshes * meshes * pow(inlet / 4, 4) / fabs(H);
}

static double whole_film_tolerance(const ovr_simulation *sim, double D,
                                   double H)
{
    double Cu = fmax(
        1, fabs(ovr_history_value(sim->histories.speed, sim->state.T)));
    double floor = MARGIN * rounding_floor(sim->options.inlet, D, Cu, H);
    return floor < 1e-9 ? 1e-9 : floor < NO_SOLUTION ? floor : NO_SOLUTION;
}

/* The mesh size of a level on the domain of the options. */
static double mesh_of(const ovr_options *o, int level)
{
    return (o->outlet - o->inlet) / (double)(ovr_level_nodes(level) - 1);
}

/* Rejects levels on which rounding of the residual makes a solution impossible.
 */
static ovr_status check_rounding(const ovr_contact *contact,
                                 const ovr_options *o, ovr_error *err)
{
    double H = ovr_film_central_moes(contact->M, contact->L);
    int most = o->level;
    while (most > 1 &&
           rounding_floor(o->inlet, mesh_of(o, most), 1, H) > NO_SOLUTION)
        most--;
    if (most == o->level || o->stop == OVR_STOP_FIXED)
        return OVR_OK;
    return ovr_fail_about(err, "level",
                          "level %d cannot be solved in double precision, "
                          "because rounding errors make a residual above %g; "
                          "use level %d or less",
                          o->level, NO_SOLUTION, most);
}

/*
 * In mixed lubrication asperities support part of the load: H is larger than
 * with fluid only, and the effect of rounding of P on the residual grows as
 * 1/share. R is the relative error of the fluid pressure, which is only a
 * fraction (share) of the total pressure that determines H. The tolerance
 * therefore bounds R times the share, up to 1e-5 (measured: R stalls at 4e-9 to
 * 3e-8 for shares of 8e-3 to 9e-4).
 */
double ovr_negligible_tolerance(const ovr_simulation *sim, double D, double H)
{
    const double largest = 1e-5;
    const double share = ovr_asperity_oil_share(&sim->grids, sim->finest);
    double whole = whole_film_tolerance(sim, D, H);
    if (share >= 1 || whole >= largest)
        return whole;
    return whole < largest * share ? whole / share : largest;
}

/* Tolerance that keeps the algebraic error below a tenth of the discretization
 * error (ten times the tolerance nearly suffices). It is bounded, so that the
 * result is close to a solution on any mesh. */
double ovr_truncation_tolerance(const ovr_simulation *sim, double D, double H)
{
    double meshes = D / (5.5 / 1792);
    double target = fmin(1e-4 * meshes * meshes, OVR_ACCEPTABLE);
    double minimum = ovr_negligible_tolerance(sim, D, H);
    return target > minimum ? target : minimum;
}

ovr_mlmi_form ovr_options_mlmi(const ovr_options *options, int level)
{
    /* error of H0 with the second-order wedge at M = 20, L = 10, measured:
     * 2.6e-5 at level 8, proportional to 4^-level */
    double target = 0.1 * 2.6e-5 * ldexp(1, 2 * (8 - level));
    if (level < options->level) /* coarser levels must not limit the accuracy of
                                 * finer ones */
        target = 1e-6;
    else if (target > 1e-8)
        target = 1e-8;
    ovr_mlmi_form form = ovr_mlmi_choose(target);
    if (options->mlmi_order)
        form.order = options->mlmi_order;
    if (options->mlmi_range)
        form.range = options->mlmi_range;
    else if (options->mlmi_order)
        form.range = form.order > 6 ? 24 : 16;
    return form;
}

/* 57 nodes, or more if film or inlet would not be resolved: at least two mesh
 * sizes per film width. At M = 5000 (L = 5) cycles converge only from level 7
 * on. */
static int automatic_coarsest(const ovr_contact *contact, const ovr_options *o)
{
    double H = ovr_film_central_moes(contact->M, contact->L);
    double width = 2 * H > 1 ? sqrt(2 * H) : 1;
    int coarsest = contact->M >= 3000  ? 7
                   : contact->M >= 400 ? 5
                   : contact->M >= 90  ? 4
                                       : 3;
    while (coarsest < 6 &&
           o->outlet - o->inlet >
               0.5 * width * (double)(ovr_level_nodes(coarsest) - 1))
        coarsest++;
    return coarsest < o->level ? coarsest : o->level;
}

/* Checks numbers that no other check would reject. */
static ovr_status check_numbers(const ovr_options *o, ovr_error *err)
{
    const struct {
        const char *key;
        int value, minimum, maximum;
    } whole[] = {
        {"scheme", (int)o->scheme, 0, OVR_CHARACTERISTIC},
        {"smoother", (int)o->smoother, 0, OVR_DIPOLE},
        {"stop", (int)o->stop, 0, OVR_STOP_FIXED},
        {"cavitation", (int)o->cavitation, 0, OVR_CAVITATION_CONSERVING},
        {"cycle_index", o->cycle_index, 0, 8},
        {"sweeps_before", o->sweeps_before, 0, OVR_SWEEPS_MAX},
        {"sweeps_after", o->sweeps_after, 0, OVR_SWEEPS_MAX},
        {"max_cycles", o->max_cycles, 0, OVR_MAX_CYCLES_MAX},
        {"cycles", o->cycles, 1, OVR_CYCLES_MAX}};
    for (size_t k = 0; k < sizeof whole / sizeof *whole; k++)
        if (whole[k].value < whole[k].minimum ||
            whole[k].value > whole[k].maximum)
            return ovr_fail_about(err, whole[k].key, "%s %d: must be %d to %d",
                                  whole[k].key, whole[k].value,
                                  whole[k].minimum, whole[k].maximum);
    if (!(o->tolerance >= 0 && o->tolerance <= OVR_TOLERANCE_MAX))
        return ovr_fail_about(
            err, "tolerance",
            "tolerance %g: must be above 0 and at most %g, or 0 (automatic)",
            o->tolerance, OVR_TOLERANCE_MAX);
    if (isnan(o->switch_value))
        return ovr_fail_about(err, "switch_value",
                              "switch_value is not a number");
    return OVR_OK;
}

/* Checks that a value is even, or 0 (automatic). */
static ovr_status check_even(const char *key, int value, int minimum,
                             int maximum, ovr_error *err)
{
    if (!value || (value % 2 == 0 && value >= minimum && value <= maximum))
        return OVR_OK;
    return ovr_fail_about(err, key,
                          "%s %d: must be an even number from %d to %d", key,
                          value, minimum, maximum);
}

static ovr_status check(const ovr_options *o, ovr_error *err)
{
    if (!ovr_scheme_record(o->scheme))
        return ovr_fail_about(err, "scheme",
                              "scheme %d: is not the number of a scheme",
                              (int)o->scheme);
    if (o->level < 1 || o->level >= OVR_LEVELS)
        return ovr_fail_about(err, "level", "level %d: must be 1 to %d",
                              o->level, OVR_LEVELS - 1);
    if (o->coarsest_level < 0 || o->coarsest_level > o->level)
        return ovr_fail_about(err, "coarsest_level",
                              "coarsest level %d: must be 1 to the level (%d)",
                              o->coarsest_level, o->level);
    if (check_even("mlmi_order", o->mlmi_order, OVR_ORDER_MIN, OVR_ORDER_MAX,
                   err) ||
        check_even("mlmi_range", o->mlmi_range, OVR_RANGE_MIN, OVR_RANGE_MAX,
                   err))
        return OVR_BAD_INPUT;
    bool seidel = o->relax_seidel >= OVR_SEIDEL_MIN &&
                  o->relax_seidel <= OVR_SEIDEL_MAX;
    if (!seidel || !(o->relax_dipole >= OVR_DIPOLE_MIN &&
                     o->relax_dipole <= OVR_DIPOLE_MAX))
        return ovr_fail_about(
            err, seidel ? "relax_dipole" : "relax_seidel",
            "under-relaxation %g and %g: must be %g to %g (Gauss-Seidel) and "
            "%g to %g (dipole)",
            o->relax_seidel, o->relax_dipole, OVR_SEIDEL_MIN, OVR_SEIDEL_MAX,
            OVR_DIPOLE_MIN, OVR_DIPOLE_MAX);
    if (!(o->inlet < -1 && o->outlet > 1 && isfinite(o->inlet) &&
          isfinite(o->outlet)))
        return ovr_fail_about(
            err, o->inlet < -1 && isfinite(o->inlet) ? "outlet" : "inlet",
            "domain [%g, %g]: the contact [-1, 1] must lie inside", o->inlet,
            o->outlet);
    if (o->order != 0 && o->order != 2 && o->order != 4)
        return ovr_fail(err, OVR_BAD_INPUT, "order = %d: must be 2 or 4",
                        o->order);
    return OVR_OK;
}

/* True if fourth-order corrections apply. */
static bool corrects(const ovr_options *o)
{
    ovr_options with = *o;
    with.order = 4;
    with.refine = OVR_REFINE_NONE;
    if (o->cavitation == OVR_CAVITATION_CONSERVING &&
        o->scheme != OVR_CHARACTERISTIC)
        return false;
    return !ovr_conflict_among(ovr_model_features_of(&with));
}

static ovr_status check_refine(const ovr_options *o, ovr_error *err)
{
    if (o->refine == OVR_REFINE_NONE)
        return OVR_OK;
    if (o->refine != OVR_REFINE_SPIKE)
        return ovr_fail_about(err, "refine", "refine %d: must be 0 or 1",
                              (int)o->refine);
    if (o->level < OVR_MIN_REFINED || o->level >= OVR_MAX_REFINED)
        return ovr_fail_about(err, "level",
                              "level %d: refine needs levels %d to %d",
                              o->level, OVR_MIN_REFINED, OVR_MAX_REFINED - 1);
    if (o->refine_level &&
        (o->refine_level <= o->level || o->refine_level > OVR_MAX_REFINED))
        return ovr_fail_about(err, "refine_level",
                              "refine_level %d: must be above the level, %d, "
                              "and at most %d",
                              o->refine_level, o->level, OVR_MAX_REFINED);
    if (!(o->refine_change >= 0 && o->refine_change <= OVR_REFINE_CHANGE_MAX))
        return ovr_fail_about(
            err, "refine_change",
            "refine_change %g: must be above 0 and at most %g, or 0 "
            "(default: %g)",
            o->refine_change, OVR_REFINE_CHANGE_MAX, OVR_REFINE_CHANGE);
    return OVR_OK;
}

/* Default domain. Inlet: the inlet of the paper if it causes an error of at
 * most half a per cent, otherwise a longer one. Outlet: the film must end
 * before it; the automatic outlet is twice the distance at which a rigid film
 * ends, 0.475 sqrt(2 H) (Martin). */
void ovr_options_domain(const ovr_contact *contact, ovr_options *o)
{
    const double M = contact->M, L = contact->L;
    if (isnan(o->inlet))
        o->inlet = ovr_inlet_of_loss(M, L, OVR_AUTO_LOSS, OVR_NEAREST_INLET);
    if (o->inlet == 0)
        o->inlet = ovr_inlet_of_loss(
            M, L, OVR_USUAL_LOSS / ovr_inlet_uncertainty(M), OVR_USUAL_INLET);
    if (isnan(o->outlet))
        o->outlet = fmax(1 + sqrt(2 * ovr_film_central_moes(M, L)),
                         OVR_USUAL_OUTLET);
    if (o->outlet == 0)
        o->outlet = fmax(ovr_film_end_bound(M, L), OVR_USUAL_OUTLET);
}

ovr_status ovr_options_resolve(const ovr_contact *contact, ovr_options *o,
                               ovr_error *err)
{
    ovr_options_domain(contact, o);
    if (check_numbers(o, err) || check(o, err) ||
        ovr_conflict_check(ovr_model_features_of(o), err) ||
        check_refine(o, err))
        return OVR_BAD_INPUT;
    if (check_rounding(contact, o, err))
        return OVR_BAD_INPUT;
    if (!o->order)
        o->order = corrects(o) ? 4 : 2;
    if (!o->coarsest_level)
        o->coarsest_level = automatic_coarsest(contact, o);
    if (!o->sweeps_before && !o->sweeps_after) {
        o->sweeps_before = o->smoother == OVR_LINE ? 1 : 2;
        o->sweeps_after = o->sweeps_before;
    }
    if (!o->cycle_index)
        o->cycle_index = 1;
    return OVR_OK;
}
