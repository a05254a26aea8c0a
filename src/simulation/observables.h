/* SPDX-License-Identifier: GPL-3.0-or-later */
/* List of the fields among the quantities, for the quantity table and for the
 * words of a case: ROW(name and function, kind, axes, long name). Bit k in a
 * set of fields represents field k. */
#ifndef OVR_SIMULATION_OBSERVABLES_H
#define OVR_SIMULATION_OBSERVABLES_H

#include "overroll/simulation.h"

#define OVR_FIELD_ROWS(ROW)                                                    \
    ROW(pressure, PRESSURE, NODES, "pressure")                                 \
    ROW(film_thickness, HEIGHT, NODES, "film thickness")                       \
    ROW(roughness, HEIGHT, NODES, "surface height")                            \
    ROW(density, NUMBER, NODES, "density relative to ambient")                 \
    ROW(viscosity, VISCOSITY, NODES, "viscosity")                              \
    ROW(mass_flow, FLOW, HALVES,                                               \
        "mass flow rate per unit width and ambient density")                   \
    ROW(cavitated, FLAG, NODES, "flag: cavitated (zero pressure)")             \
    ROW(shear_stress_1, SHEAR, HALVES, "shear stress on surface 1")            \
    ROW(shear_stress_2, SHEAR, HALVES,                                         \
        "shear stress in the film at surface 2")                               \
    ROW(temperature_1, TEMPERATURE, NODES, "temperature of surface 1")         \
    ROW(temperature_2, TEMPERATURE, NODES, "temperature of surface 2")         \
    ROW(temperature_mean, TEMPERATURE, NODES, "mean temperature of the film")  \
    ROW(temperature_middle, TEMPERATURE, NODES,                                \
        "temperature in the middle of the film")                               \
    ROW(heat_flux_1, HEAT, NODES, "heat flux into surface 1")                  \
    ROW(heat_flux_2, HEAT, NODES, "heat flux into surface 2")                  \
    ROW(filling, NUMBER, NODES, "film fraction")                               \
    ROW(oil_content, HEIGHT, NODES, "lubricant mass content rho h theta")      \
    ROW(contact_pressure, PRESSURE, NODES, "asperity contact pressure")        \
    ROW(fluid_pressure, PRESSURE, NODES, "fluid pressure")

#endif
