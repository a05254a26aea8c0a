/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses of a run: parameters, plan, follower thread and report. */
#ifndef OVR_PHYSICS_STRESS_STRESS_H
#define OVR_PHYSICS_STRESS_STRESS_H

#include "base/arena.h"
#include "overroll/case.h"
#include "overroll/results.h"
#include "overroll/stress.h"
#include "results/results.h"
#include "simulation/physics.h"
#include "stress/stress.h"

/* -------------------------------------------------------------------- case */

/* Values of [stress] traction. */
enum { OVR_TRACTION_NO, OVR_TRACTION_YES, OVR_TRACTION_AUTO };

/* The settings of [stress] and [fatigue]: lengths in b, stresses in p_h. */
typedef struct ovr_stress_setup {
    const ovr_setup *setup;
    int surfaces; /* 1, 2, 3: both; 0: no stresses */
    double poisson[2];
    double depth_min, depth_max, per_octave; /* depth_min 0: 4 D */
    int every;                               /* snapshots; 0: no fields */
    unsigned fields; /* bits in the order of the parameter's choices */
    ovr_list window;
    double from, to; /* range of xi around the first feature's centre; NAN:
                      * around all features */
    bool fatigue;
    ovr_criterion criterion;      /* stored as an int by its row, of the same
                                   * size */
    double alpha, limit_pressure; /* 0: none */
    ovr_life_options life;        /* with the limit from limit_pressure */
    const char *limit_table;
    double raceway, count; /* raceway 0: unknown */
    double residual_x, residual_y;
    const char *residual_table;
    size_t residuals; /* number of depths with residual stresses, for both
                       * surfaces: depths, stresses */
    const double *residual_z, *residual_s;
    int loads;               /* value of `traction` in the case */
    bool traction;           /* the shear stress of the film is applied as
                              * traction */
    const char *no_traction; /* reason why traction is not applied; else NULL */
    double yield[2]; /* yield stress of each body, von Mises, p_h; 0: unknown */
} ovr_stress_setup;

extern const ovr_section ovr_stress_sections[2];

/* Ends of the window given by the key `about`; NAN if it is not given. */
ovr_status ovr_window_resolve(const ovr_list *window, const char *about,
                              double *from, double *to, ovr_error *err);

/* The following are functions of a physical model (simulation/physics.h). */
ovr_status ovr_stress_resolve(const ovr_physics_case *of, void *form, bool *on,
                              ovr_error *err);
void ovr_stress_state(const void *form, ovr_physics_effects *effects);

/* Stress parameters; surfaces = 0: no stresses. */
const ovr_stress_setup *ovr_setup_stress(const ovr_setup *setup);

/* -------------------------------------------------------------------- plan */

/* The stress history of one surface that follows from a case. */
typedef struct ovr_stress_plan {
    int surface;   /* 1 or 2 */
    double ratio;  /* u_k/um from slide_to_roll */
    int direction; /* direction of motion: 1, -1; 0: both */
    ovr_stress_options options;
    ovr_material_range range;
    const char *feature; /* feature at xi = 0; NULL: none */
    double every;        /* steps between two times */
    double coarsest;     /* maximum distance moved between two times, as far as
                          * known */
    double traction;     /* factor from the film's shear stress at this surface
                          * to Q */
    const char *no_traction; /* reason why traction is not applied; NULL: it is
                              */
} ovr_stress_plan;

/* Pressure samples: nodes with one mesh size from the inlet, every `every`
 * steps. */
typedef struct ovr_stress_sight {
    double inlet, mesh;
    size_t nodes;
    double every;
} ovr_stress_sight;

/* Returns the samples of a run, which observes each step. */
ovr_stress_sight ovr_stress_sight_of(const ovr_setup *setup);

/* Fails if the requested depths cannot be resolved with these samples. */
ovr_status ovr_stress_planned(const ovr_setup *setup, int surface,
                              ovr_stress_sight seen, ovr_stress_plan *plan,
                              ovr_error *err);

/* Distance moved by the plan's surface since T = 0. */
double ovr_stress_distance(const ovr_setup *setup, const ovr_stress_plan *plan,
                           double T);

/* Position and motion of a surface at time T; `before` is the previous T. */
ovr_moment ovr_stress_moment(const ovr_setup *setup,
                             const ovr_stress_plan *plan, double T,
                             double before);

/* Memory in bytes of the stress histories of a prepared setup. */
double ovr_material_histories_memory(const ovr_setup *setup);

/* ---------------------------------------------------------------- traction */

/* Traction Q at the plan's nodes: of the present state, or of snapshot k of a
 * file. NULL without traction; `workspace` has a value per node. */
const double *ovr_traction_now(const ovr_stress_plan *plan,
                               const ovr_simulation *sim, double *workspace);
ovr_status ovr_traction_stored(const ovr_stress_plan *plan, ovr_result *result,
                               size_t k, double *workspace, ovr_error *err);
bool ovr_traction_is_stored(const ovr_stress_plan *plan,
                            const ovr_result *result);

/* ---------------------------------------------------------------- follower */

/* A stress history computed in a separate thread: samples are queued and
 * processed in order. */
typedef struct ovr_follower ovr_follower;
ovr_follower *ovr_follower_create(const ovr_stress_plan *plan,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_follower_free(ovr_follower *f);

typedef enum ovr_post { OVR_POST_BEGIN, OVR_POST_STEP, OVR_POST_END } ovr_post;
void ovr_follower_post(ovr_follower *f, ovr_post part, const double *P,
                       const double *Q, const ovr_moment *moment);

/* Waits until all queued samples are processed; then the stress history may be
 * read. */
ovr_material_history *ovr_follower_wait(ovr_follower *f);

/* ------------------------------------------------------------------ report */

/* The run of a report, and its file, which contains the pressure at all times;
 * NULL: none. */
typedef struct ovr_stress_source {
    const ovr_setup *setup;
    const char *path;
    bool unresolved; /* the mesh does not resolve the maximum pressure */
} ovr_stress_source;

/* Results of a stress history of the material; the arrays are in the arena. */
ovr_stress_report *ovr_stress_report_make(const ovr_stress_source *of,
                                          const ovr_stress_plan *plan,
                                          const ovr_material_history *history,
                                          ovr_arena *arena, ovr_error *err);

/* Parts of a report: body, layers, plastic body, circumscribed circle of a
 * shear stress path. */
typedef enum ovr_stress_part {
    OVR_STRESS_BODY,
    OVR_STRESS_LAYERS,
    OVR_STRESS_YIELD,
    OVR_STRESS_CIRCLE
} ovr_stress_part;

/* Kind of a number; it determines the additional values in a summary. */
typedef enum ovr_figure_form {
    OVR_FIGURE_NUMBER,
    OVR_FIGURE_SHARE, /* fraction of a limit, the larger of both surfaces; NAN:
                       * none */
    OVR_FIGURE_PRESSURE, /* also in Pa */
    OVR_FIGURE_LENGTH,   /* also in metres */
    OVR_FIGURE_MOMENT,   /* with position and time, without a unit */
    OVR_FIGURE_STRIP,    /* with position and time, width in place of depth */
    OVR_FIGURE_STRESS,   /* with position and time, also in Pa */
    OVR_FIGURE_TENSION /* as OVR_FIGURE_STRESS, but the stress may be absent */
} ovr_figure_form;

/* A number of a report, with its key. */
typedef struct ovr_stress_figure {
    ovr_stress_part part;
    ovr_figure_form form;
    const char *key;
    size_t offset;
    const char *label, *words; /* in reports; NULL: not in the list */
} ovr_stress_figure;

/* Returns number k, or NULL after the last. Its value; the position is NAN if
 * it has none. */
const ovr_stress_figure *ovr_stress_figure_at(size_t k);
ovr_stress_extreme ovr_stress_figure_of(const ovr_stress_figure *figure,
                                        const ovr_stress_report *report);

/* Writes the group fatigue/surface_N of the file. */
ovr_status ovr_stress_store(ovr_writer *writer, const ovr_setup *setup,
                            const ovr_stress_report *report, ovr_error *err);

#endif
