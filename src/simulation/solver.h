/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The solver of a simulation.  By default (no record) the film varies along x
 * only and is solved by multigrid/, steady.c and step.c. A physical model can
 * provide another solver (physics.h), for a film that also varies across the
 * rolling direction. Histories, time loop, statistics, files and studies are
 * the same.
 *
 * Such a solver copies one line along x to `now` and sim->shapes.S before it
 * returns. Tables, pictures and result files of the line contact show that
 * line.
 */
#ifndef OVR_SIMULATION_SOLVER_H
#define OVR_SIMULATION_SOLVER_H

#include "simulation/internal.h"

/* Work of a cycle at a node relative to that of a line contact. */
enum { OVR_SOLVER_WORK = 2 };

typedef struct ovr_solver {
    /* Solves the steady film at T = 0 for the conditions sim->target. Fills the
     * outcome and returns the tolerance of R. */
    double (*steady)(ovr_simulation *sim, void *own, ovr_outcome *outcome);

    /* Solves the film at `next` and updates sim->past. Returns false and stays
     * at the last time if no film was found. */
    bool (*attempt)(ovr_simulation *sim, void *own, double next,
                    ovr_outcome *outcome);

    /* Restores film and gap of the last time. */
    void (*step_back)(ovr_simulation *sim, void *own);

    /* Observes film, pressure, mass flow and friction of all lines. */
    void (*observe)(ovr_simulation *sim, void *own, ovr_observation *o);

    /* Copies a line to `now`: the given one, or the shown line if the number is
     * too large. */
    void (*show)(ovr_simulation *sim, void *own, size_t line);

    /* Returns the Y of all lines, b, their number and the shown line. */
    const double *(*lines)(const void *own, size_t *count, size_t *shown);
} ovr_solver;

#endif
