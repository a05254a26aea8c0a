/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of quantities, and the computation of the fields among them. */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "simulation/internal.h"
#include "simulation/mirror.h"
#include "simulation/observables.h"
#include "simulation/observe.h"
#include "simulation/physics.h"
#include "simulation/quantity_row.h"
#include "simulation/simulation.h"

/* ----------------------------------------------------------------- fields */

/* Values of a field of the active physical models; NAN if no model has it. */
static const double *field_of(const ovr_simulation *sim,
                              ovr_physics_field which, double *workspace)
{
    OVR_LAST_PHYSICS(sim, p, in_output, field);
    for (size_t i = 0; !p->is && i < sim->now.n; i++)
        workspace[i] = NAN;
    return p->is ? p->is->in_output->field(sim, p->own, which, workspace)
                 : workspace;
}

static void warm(const ovr_simulation *sim, double *viscosity, double *density)
{
    OVR_EACH_PHYSICS(sim, p, in_output, warm)
        p->is->in_output->warm(sim, p->own, viscosity, density);
}

/* Fields that are available or computed elsewhere. */
#define IS(name, values)                                                       \
    static const double *name(const ovr_simulation *sim, double *workspace)    \
    {                                                                          \
        (void)workspace;                                                       \
        return (values);                                                       \
    }
IS(pressure, sim->now.P)
IS(film_thickness, sim->now.H)
IS(roughness, sim->shapes.S)
IS(oil_content, sim->now.q)
/* `pressure` under its name in mixed lubrication */
IS(fluid_pressure, sim->now.P)
IS(shear_stress_1, ovr_wall_stress(sim, 1, workspace))
IS(shear_stress_2, ovr_wall_stress(sim, 2, workspace))
IS(temperature_1, field_of(sim, OVR_FIELD_TEMPERATURE_1, workspace))
IS(temperature_2, field_of(sim, OVR_FIELD_TEMPERATURE_2, workspace))
IS(temperature_mean, field_of(sim, OVR_FIELD_TEMPERATURE_MEAN, workspace))
IS(temperature_middle, field_of(sim, OVR_FIELD_TEMPERATURE_MIDDLE, workspace))
IS(heat_flux_1, field_of(sim, OVR_FIELD_HEAT_FLUX_1, workspace))
IS(heat_flux_2, field_of(sim, OVR_FIELD_HEAT_FLUX_2, workspace))

static const double *density(const ovr_simulation *sim, double *workspace)
{
    for (size_t i = 0; i < sim->state.n; i++)
        workspace[i] = ovr_density(&sim->lubricant, sim->now.P[i]);
    warm(sim, NULL, workspace);
    return workspace;
}

static const double *viscosity(const ovr_simulation *sim, double *workspace)
{
    for (size_t i = 0; i < sim->state.n; i++)
        workspace[i] = ovr_viscosity(&sim->lubricant, sim->now.P[i]);
    warm(sim, workspace, NULL);
    return workspace;
}

static const double *cavitated(const ovr_simulation *sim, double *workspace)
{
    for (size_t i = 0; i < sim->state.n; i++)
        workspace[i] = sim->now.P[i] <= 0;
    return workspace;
}

/* Film fraction; the density is that at the lubricant temperature and P = 0. */
static const double *filling(const ovr_simulation *sim, double *workspace)
{
    for (size_t i = 0; i < sim->state.n; i++) {
        double thinner = 1, lighter = 1;
        OVR_EACH_PHYSICS(sim, p, in_output, oil)
            p->is->in_output->oil(sim, p->own, i, &thinner, &lighter);
        double full = lighter * sim->now.H[i];
        workspace[i] = sim->now.P[i] > 0 ? 1 : sim->now.q[i] / full;
    }
    return workspace;
}

static const double *contact_pressure(const ovr_simulation *sim,
                                      double *workspace)
{
    const double *asperity_P = sim->finest->asperity_P;
    memset(workspace, 0, sim->state.n * sizeof *workspace);
    if (asperity_P)
        ovr_nodes_read(sim, sim->finest, asperity_P, workspace);
    return workspace;
}

static const double *mass_flow(const ovr_simulation *sim, double *workspace)
{
    double Cu = ovr_history_value(sim->histories.speed, sim->state.T);
    for (size_t i = 0; i + 1 < sim->state.n; i++)
        workspace[i] = ovr_flux(sim, Cu, i);
    return workspace;
}

/* ------------------------------------------------------------------- list */

#define FIELD(of, of_kind, along, text)                                        \
    {.name = #of,                                                              \
     .long_name = (text),                                                      \
     .kind = OVR_KIND_##of_kind,                                               \
     .axes = OVR_AT_##along,                                                   \
     .field = (of)},

/* Known if there are features on the surfaces. */
#define ROUGH(name, key, si, kind, member, ...)                                \
    OVR_NUMBER_ROW(name, key, si, kind, member, OVR_PHYSICS_FEATURES,          \
                   __VA_ARGS__)

/* Order of columns and fields in a file. */
static const ovr_observable table[] = {
    NUMBER("time", NULL, NULL, TIME, T, "time"),
    NUMBER("time_step", NULL, NULL, TIME, dT, "time step"),
    NUMBER(NULL, "H_min", "min_film_m", HEIGHT, H_min,
           "minimum film thickness at a node", PLACE(X_min)),
    NUMBER(NULL, "X_min", NULL, LENGTH, X_min,
           "position of the minimum film thickness at a node"),
    NUMBER("min_film_thickness", "H_min_located", "min_film_located_m", HEIGHT,
           H_min_located, "minimum film thickness",
           COMMENT("interpolated between nodes"),
           LABEL("minimum film thickness"), SMALLEST("H_min_overall"),
           EXTREME_REPORTED, PLACE(X_min_located), MEAN("H_min_mean"),
           PASS(SMALLEST), PASS_HEAD(2, "h_min")),
    NUMBER("x_min_film_thickness", "X_min_located", NULL, LENGTH, X_min_located,
           "position of the minimum film thickness"),
    NUMBER(NULL, "H_min_cavity", "min_cavity_m", HEIGHT, H_min_cavity,
           "minimum gap in the cavity",
           COMMENT("between nodes without pressure; NaN unless it is smaller "
                   "than the minimum film thickness"),
           LABEL("minimum gap in the cavity"), PLACE(X_min_cavity),
           SMALLEST("H_min_cavity_overall"), EXTREME_REPORTED),
    NUMBER("central_film_thickness", "H_cen", "central_film_m", HEIGHT, H_cen,
           "central film thickness", COMMENT("at x = 0"),
           LABEL("central film thickness"), NOTE("X = 0"), MEAN("H_cen_mean"),
           MEAN_REPORTED, .pass = OVR_PASS_MEAN | OVR_PASS_SMALLEST,
           PASS_HEAD(1, "h_cen")),
    NUMBER("central_pressure", "P_cen", NULL, PRESSURE, P_cen,
           "central pressure", COMMENT("at x = 0")),
    NUMBER("max_pressure", "P_max", "max_pressure_Pa", PRESSURE, P_max,
           "maximum pressure", LABEL("maximum pressure"), PLACE(X_P_max),
           LARGEST("P_max_overall"), EXTREME_REPORTED, PASS(LARGEST),
           PASS_HEAD(6, "pressure"), PASS_WITH(PLASTIC)),
    NUMBER("x_max_pressure", "X_P_max", NULL, LENGTH, X_P_max,
           "position of the maximum pressure"),
    NUMBER("max_pressure_resolved", NULL, NULL, FLAG, P_max_resolved,
           "flag: maximum pressure resolved by the grid"),
    NUMBER(NULL, "P_max_located", NULL, PRESSURE, P_max_located,
           "maximum pressure interpolated between nodes"),
    NUMBER(NULL, "X_P_max_located", NULL, LENGTH, X_P_max_located,
           "position of the interpolated maximum pressure"),
    NUMBER(NULL, "P_spike", NULL, PRESSURE, P_spike,
           "pressure spike height at a node", LABEL("pressure spike height"),
           PLACE(X_spike)),
    NUMBER(NULL, "X_spike", NULL, LENGTH, X_spike,
           "position of the pressure spike at a node"),
    NUMBER("spike_pressure", "P_spike_located", NULL, PRESSURE, P_spike_located,
           "pressure spike height", COMMENT("interpolated between nodes")),
    NUMBER("x_spike", "X_spike_located", NULL, LENGTH, X_spike_located,
           "position of the pressure spike"),
    NUMBER("pressure_maxima", "maxima", NULL, COUNT, maxima,
           "number of pressure maxima",
           COMMENT("maxima at least 1e-3 p_h above the preceding minimum")),
    NUMBER("rigid_approach", "H0", NULL, HEIGHT, H0, "rigid-body approach H0"),
    NUMBER("load", "load", NULL, NUMBER, load, "load integral",
           COMMENT("integral of P; pi/2 at the reference load"),
           LABEL("load integral"), NOTE("reference load: pi/2")),
    NUMBER("load_ratio", NULL, NULL, NUMBER, load_ratio,
           "load relative to the reference load", COMMENT("prescribed"),
           PASS(MEAN)),
    NUMBER("load_error", NULL, NULL, NUMBER, load_error, "force balance error",
           COMMENT("relative to the reference load"),
           OF_MAGNITUDE("load_error_max"), EXTREME_REPORTED, STEADY_TOO),
    NUMBER("speed_ratio", NULL, NULL, NUMBER, speed_ratio,
           "entrainment speed relative to reference speed"),
    NUMBER("sliding_speed", "sliding", NULL, NUMBER, sliding,
           "sliding speed relative to the reference speed",
           COMMENT("u1 - u2, relative to the reference entrainment speed")),
    NUMBER("radius_ratio", "radius_ratio", NULL, NUMBER, radius_ratio,
           "reduced radius relative to the reference radius"),
    NUMBER("mass_flow", "mass_flow", NULL, NUMBER, mass_flow, "mass flow rate",
           COMMENT("mean of rho H - eps dP/dX over the film"),
           LABEL("mass flow rate")),
    NUMBER("mass_balance", "mass_balance", NULL, NUMBER, mass_balance,
           "mass balance error",
           COMMENT("relative to the mean flow magnitude")),
    NUMBER("x_cavitation", "X_cavitation", NULL, LENGTH, X_cavitation,
           "position of film rupture",
           COMMENT("first cavitated node downstream"),
           OF_MAGNITUDE("X_cavitation_max")),
    NUMBER("friction_force_1", "F_1", "F_1_N_per_m", FORCE, F_1,
           "friction force on surface 1", COMMENT("positive along x")),
    NUMBER("friction_force_2", "F_2", "F_2_N_per_m", FORCE, F_2,
           "friction force on surface 2", COMMENT("positive along x")),
    NUMBER("sliding_force", "F_slide", "F_slide_N_per_m", FORCE, F_slide,
           "sliding friction force",
           COMMENT("on surface 1 along x, on surface 2 against it")),
    NUMBER("rolling_force", "F_roll", "F_roll_N_per_m", FORCE, F_roll,
           "rolling friction force",
           COMMENT("opposes the motion of both surfaces")),
    ROUGH("slope_force_1", "F_slope_1", "F_slope_1_N_per_m", FORCE, F_slope_1,
          "friction force of the slopes of surface 1",
          COMMENT("pressure times slope of its features; part of F_1")),
    ROUGH("slope_force_2", "F_slope_2", "F_slope_2_N_per_m", FORCE, F_slope_2,
          "friction force of the slopes of surface 2",
          COMMENT("pressure times slope of its features; part of F_2")),
    NUMBER("friction_coefficient_1", "mu_1", NULL, NUMBER, mu_1,
           "friction coefficient of surface 1"),
    NUMBER("friction_coefficient_2", "mu_2", NULL, NUMBER, mu_2,
           "friction coefficient of surface 2"),
    NUMBER("sliding_friction_coefficient", "mu_slide", NULL, NUMBER, mu_slide,
           "sliding friction coefficient", COMMENT("sign of u1 - u2"),
           NOTE("sign of u1 - u2"), OF_MAGNITUDE("mu_slide_max"),
           EXTREME_REPORTED, MEAN("mu_slide_mean"), MEAN_REPORTED, FRICTION),
    NUMBER("rolling_friction_coefficient", "mu_roll", NULL, NUMBER, mu_roll,
           "rolling friction coefficient"),
    NUMBER("power_in", "power_in", "power_in_W_per_m", POWER, power_in,
           "mechanical power input", OF_MAGNITUDE("power_in_max"),
           MEAN("power_in_mean")),
    NUMBER("power_dissipated", "power_dissipated", "power_dissipated_W_per_m",
           POWER, power_dissipated, "dissipated power",
           LARGEST("power_dissipated_max"), MEAN("power_dissipated_mean")),
    NUMBER("limiting_share", "limiting_share", NULL, NUMBER, limiting_share,
           "load share at the limiting shear stress"),
    NUMBER("mean_film_thickness", NULL, NULL, HEIGHT, H_mean,
           "mean film thickness", COMMENT("in |x| < 0.75 b"), MEAN("H_mean"),
           MEAN_REPORTED, NOTE("|X| < 0.75"), STEADY_TOO),
    ROUGH("film_roughness", "film_Rq", "film_Rq_m", HEIGHT, film_Rq,
          "film thickness roughness Rq", COMMENT("in |x| < 0.75 b"),
          LARGEST("film_Rq_max"), EXTREME_REPORTED, NOTE("|X| < 0.75")),
    ROUGH("lambda_ratio", NULL, NULL, NUMBER, lambda_ratio, "lambda ratio",
          COMMENT("mean film thickness in |x| < 0.75 b divided by the "
                  "composite roughness of both surfaces"),
          SMALLEST("lambda_ratio_min"), EXTREME_REPORTED, MEAN("lambda_ratio"),
          MEAN_REPORTED, DIGITS(4), NOTE("|X| < 0.75"), STEADY_TOO)};

/* After the quantities of the physical models: solver statistics and fields. */
static const ovr_observable last[] = {
    NUMBER("residual", "residual", NULL, NUMBER, residual, "residual",
           COMMENT("relative mass flow imbalance"), LABEL("residual"),
           DIGITS(3)),
    NUMBER("order", "order", NULL, COUNT, order, "discretization order"),
    NUMBER("cycles", "cycles", NULL, COUNT, cycles,
           "multigrid cycles of the step", TOTAL("cycles_total", "cycles")),
    NUMBER("retries", NULL, NULL, COUNT, retries,
           "number of repeated attempts"),
    NUMBER("converged", NULL, NULL, FLAG, converged, "convergence flag"),
    NUMBER("marked", NULL, NULL, FLAG, marked,
           "flag: step accepted above tolerance",
           COMMENT("or with temperatures that are not those of the film"),
           TOTAL("steps_marked", "accepted above tolerance")),
    OVR_FIELD_ROWS(FIELD)};

const ovr_observable *ovr_observable_at(size_t k)
{
    const size_t rows = sizeof table / sizeof *table;
    if (k < rows)
        return &table[k];
    k -= rows;
    for (int p = 0; ovr_physics_list[p]; p++) {
        const ovr_physics_in_output *of = ovr_physics_list[p]->in_output;
        if (of && k < of->quantities)
            return &of->quantity[k];
        k -= of ? of->quantities : 0;
    }
    return k < sizeof last / sizeof *last ? &last[k] : NULL;
}

const ovr_observable *ovr_observable_field(const char *name)
{
    if (!name)
        return NULL;
    const ovr_observable *o;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if (o->field && strcmp(o->name, name) == 0)
            break;
    return o;
}

double ovr_observable_value(const ovr_observable *which,
                            const ovr_observation *from)
{
    if (!which || !from)
        return NAN;
    const char *at = (const char *)from + which->offset;
    switch (which->kind) {
    case OVR_KIND_COUNT: return *(const int *)(const void *)at;
    case OVR_KIND_FLAG: return *(const bool *)(const void *)at;
    default: return *(const double *)(const void *)at;
    }
}
