/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [domain], [solver] and [paper]. */
#include "case/keys/keys.h"

#include <math.h>

#include "multigrid/hierarchy.h"
#include "simulation/limits.h"
#include "simulation/refined.h"

static const ovr_word smoothers[] = {{"line", OVR_LINE},
                                     {"hybrid", OVR_HYBRID},
                                     {"gauss-seidel", OVR_GAUSS_SEIDEL},
                                     {"dipole", OVR_DIPOLE},
                                     {NULL, 0}};
static const ovr_word orders[] = {{"auto", 0}, {"2", 2}, {"4", 4}, {NULL, 0}};
static const ovr_word faces[] = {{"logarithmic", OVR_FACES_LOGARITHMIC},
                                 {"gap", OVR_FACES_GAP},
                                 {"arithmetic", OVR_FACES_ARITHMETIC},
                                 {NULL, 0}};
static const ovr_word refines[] = {
    {"none", OVR_REFINE_NONE}, {"spike", OVR_REFINE_SPIKE}, {NULL, 0}};
static const ovr_word accuracies[] = {{"H_cen", OVR_ACCURACY_H_CEN},
                                      {"H_min", OVR_ACCURACY_H_MIN},
                                      {"features", OVR_ACCURACY_FEATURES},
                                      {"all", OVR_ACCURACY_ALL},
                                      {NULL, 0}};
static const ovr_word cycles[] = {{"V", 1}, {"W", 2}, {NULL, 0}};
static const ovr_word stops[] = {{"negligible", OVR_STOP_NEGLIGIBLE},
                                 {"truncation", OVR_STOP_TRUNCATION},
                                 {"fixed", OVR_STOP_FIXED},
                                 {NULL, 0}};
static const ovr_word ends[] = {{"usual", 0}, {"auto", NAN}, {NULL, 0}};
static const ovr_word levels[] = {
    {"usual", OVR_GRID_USUAL}, {"auto", OVR_GRID_AUTO}, {NULL, 0}};
static const ovr_word auto_zero[] = {{"auto", 0}, {NULL, 0}};

static const ovr_parameter domain_keys[] = {
    {"inlet", LENGTH_OR(ends, -1e6, -1.05), "usual", AT(options.inlet), true,
     ALWAYS,
     "X of the first node; usual: -4 (-2 for steady contacts without features "
     "above M = 3000), or further upstream if the central film thickness would "
     "be more than 0.5 % too low (5e-4 if load, speed or radius vary in time); "
     "auto: at an error of 1e-4"},
    {"outlet", LENGTH_OR(ends, 1.05, 1e6), "usual", AT(options.outlet), true,
     ALWAYS,
     "X of the last node; usual: 1.5 (1.1 above M = 3000, as for the inlet) at "
     "the largest load and radius of the run and its passes, or further "
     "downstream where the film ends later, up to "
     "4.5 if load or radius jump and up to 3 if high features pass; auto: "
     "twice the film end of rigid bodies, "
     "if that is further"},
    {"level", WHOLE_OR(levels, 1, OVR_LEVELS - 1), "usual", AT(options.level),
     true, ALWAYS,
     "finest grid: 7 2^level + 1 nodes; usual: 8 for a steady contact (9 where "
     "the mesh exceeds a tenth of H^(2/3), up to 12 above M = 700); in time "
     "and with [boundary] the "
     "first level with a likely error of 1e-3 in central and minimum film "
     "thickness and friction, 8 at most; auto: the first level at which "
     "accuracy_of reaches accuracy, 14 at most, confirmed after the run"},
    {"accuracy", PLAIN(1e-9, 0.5), "1e-3", AT(accuracy), true, "level = auto",
     "target of the relative discretization error"},
    {"accuracy_of", CHOICE(accuracies), "all", AT(accuracy_of), true,
     "level = auto",
     "quantity of the target: central film thickness, minimum film thickness, "
     "both and friction, or the effect of the features on the film thickness"},
    {"nodes", WHOLE(15, (7 << (OVR_LEVELS - 1)) + 1), NULL, AT(nodes), true,
     ALWAYS, "instead of level: 7 2^k + 1"},
    {"order", CHOICE(orders), "auto", AT(options.order), true, ALWAYS,
     "order of the discretization: 4 corrects film thickness, Poiseuille flow "
     "and wedge term on the finest grid, again after each step along the "
     "characteristic (with upstream2 a run keeps the corrections of its start, "
     "for constant load, speed and radius and without mass-conserving "
     "cavitation); auto: 4 where it applies"},
    {"faces", CHOICE(faces), "logarithmic", AT(options.faces), true, ALWAYS,
     "average of rho H^3/eta between two nodes: harmonic in H^3, and of "
     "1/eta logarithmic, exact for a viscosity exponential in pressure, or "
     "arithmetic (gap, as in 0.3.0: a minimum film thickness up to ten times "
     "less accurate); arithmetic in the whole, as in the paper, which leaks "
     "through constrictions narrower than the mesh size"},
    {"refine", CHOICE(refines), "none", AT(options.refine), true, ALWAYS,
     "spike: nested patches of finer grids around the pressure spike, the "
     "first three extending downstream of film rupture; steady contacts only"},
    {"refine_level", WHOLE(OVR_MIN_REFINED + 1, OVR_MAX_REFINED), NULL,
     AT(options.refine_level), true, "refine = spike",
     "level of the finest patch; default: as many patches as refine_change "
     "needs"},
    {"refine_change", PLAIN(1e-9, OVR_REFINE_CHANGE_MAX), "1e-3",
     AT(options.refine_change), true, "refine = spike; no refine_level",
     "patches are added until two consecutive levels change the spike height "
     "by less"},
};

const ovr_section ovr_domain_section = {
    "domain", false, NULL,
    "the part of the film that is computed, and its grid", ROWS(domain_keys)};

static const ovr_parameter solver_keys[] = {
    {"cycle", CHOICE(cycles), "V", AT(options.cycle_index), true, "no [strip]",
     "multigrid cycle"},
    {"sweeps_before", WHOLE_OR(auto_zero, 0, OVR_SWEEPS_MAX), "auto",
     AT(options.sweeps_before), true, "no [strip]",
     "relaxation sweeps before the coarse-grid correction"},
    {"sweeps_after", WHOLE_OR(auto_zero, 0, OVR_SWEEPS_MAX), "auto",
     AT(options.sweeps_after), true, "no [strip]",
     "relaxation sweeps after the coarse-grid correction"},
    {"coarsest_level", WHOLE_OR(auto_zero, 1, 7), "auto",
     AT(options.coarsest_level), true, "no [strip]",
     "coarsest grid; the paper's is 1"},
    {"stop", CHOICE(stops), "negligible", AT(options.stop), true, ALWAYS,
     "end of the steady solution: negligible algebraic error, a fraction of "
     "the discretization error, or a fixed number of cycles"},
    {"max_cycles", WHOLE_OR(auto_zero, 1, OVR_MAX_CYCLES_MAX), "auto",
     AT(options.max_cycles), true, ALWAYS,
     "maximum number of cycles on each level (steady)"},
    {"tolerance", PLAIN_OR(auto_zero, 1e-16, OVR_TOLERANCE_MAX), "auto",
     AT(options.tolerance), true, ALWAYS,
     "tolerance of the relative mass-flow imbalance"},
};

const ovr_section ovr_solver_section = {
    "solver", false, NULL,
    "multigrid solver; the defaults suit nearly every "
    "case",
    ROWS(solver_keys)};

static const ovr_parameter paper_keys[] = {
    {"smoother", CHOICE(smoothers), "line", AT(options.smoother), true, ALWAYS,
     "line: distributive line relaxation; hybrid: the paper's, for steady "
     "solutions"},
    {"switch", PLAIN(1e-9, 1e9), "3", AT(options.switch_value), true,
     "smoother = hybrid", "eps/D^2 above which Gauss-Seidel is used"},
    {"relax_seidel", PLAIN(OVR_SEIDEL_MIN, OVR_SEIDEL_MAX), "0.8",
     AT(options.relax_seidel), true, "smoother = hybrid | gauss-seidel",
     "under-relaxation, Gauss-Seidel"},
    {"relax_dipole", PLAIN(OVR_DIPOLE_MIN, OVR_DIPOLE_MAX), "0.5",
     AT(options.relax_dipole), true, "smoother = hybrid | dipole",
     "under-relaxation, dipole"},
    {"paper_balance", FLAG, "no", AT(options.paper_balance), true, ALWAYS,
     "force balance by the paper's relaxation of H0 on the coarsest grid "
     "instead of dense Newton steps"},
    {"cycles", WHOLE(1, OVR_CYCLES_MAX), "2", AT(options.cycles), true,
     "solver.stop = fixed", "number of cycles on each level"},
    {"mlmi_order", WHOLE_OR(auto_zero, OVR_ORDER_MIN, OVR_ORDER_MAX), "auto",
     AT(options.mlmi_order), true, ALWAYS,
     "order of restriction and prolongation in the deformation integrals, "
     "even"},
    {"mlmi_range", WHOLE_OR(auto_zero, OVR_RANGE_MIN, OVR_RANGE_MAX), "auto",
     AT(options.mlmi_range), true, ALWAYS,
     "local corrections within this number of mesh sizes of the singularity"},
};

const ovr_section ovr_paper_section = {
    "paper", false, NULL,
    "the algorithm of Venner, ten Napel & Bosma (1990), for their tables",
    ROWS(paper_keys)};
