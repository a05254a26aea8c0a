/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses of a run: what is followed, by whom, and where it goes. */
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
    int surfaces; /* 1, 2, 3: both; 0: no stresses are asked for */
    double poisson[2];
    double depth_min, depth_max, per_octave; /* depth_min 0: 4 D */
    int every;                               /* snapshots; 0: no fields */
    unsigned fields; /* bits in the order of the parameter's choices */
    ovr_list window;
    double from, to; /* about the first feature's centre; NAN: about all */
    bool fatigue;
    ovr_criterion criterion;      /* its row writes an int, as wide */
    double alpha, limit_pressure; /* 0: none */
    ovr_life_options life;        /* its limit follows from limit_pressure */
    const char *limit_table;
    double raceway, count; /* raceway 0: not given */
    double residual_x, residual_y;
    const char *residual_table;
    size_t residuals; /* by depth in place of both: depths, stresses */
    const double *residual_z, *residual_s;
    int loads;               /* as given: whether it shall be one */
    bool traction;           /* the film's shear stress is a load too */
    const char *no_traction; /* why not; NULL where it is */
    double yield[2];         /* of each body, von Mises, p_h; 0: unknown */
} ovr_stress_setup;

extern const ovr_section ovr_stress_sections[2];

/* The ends of a window that the key `about` gives; NAN where it gives none. */
ovr_status ovr_window_resolve(const ovr_list *window, const char *about,
                              double *from, double *to, ovr_error *err);

/* These are functions of a physics (simulation/physics.h). */
ovr_status ovr_stress_resolve(const ovr_physics_case *of, void *form, bool *on,
                              ovr_error *err);
void ovr_stress_state(const void *form, ovr_physics_statement *says);

/* Stresses, surfaces = 0: there are none. */
const ovr_stress_setup *ovr_setup_stress(const ovr_setup *setup);

/* -------------------------------------------------------------------- plan */

/* The plan that follows from a case for one surface. */
typedef struct ovr_stress_plan {
    int surface;   /* 1 or 2 */
    double ratio;  /* u_k/um by slide_to_roll */
    int direction; /* of its motion: 1, -1; 0: both ways */
    ovr_stress_options options;
    ovr_material_range range;
    const char *feature; /* xi counts from its centre; NULL: there is none */
    double every;        /* steps from one moment to the next */
    double coarsest;     /* way between the two, as far as it is known */
    double traction;     /* Q over the film's shear stress at this surface */
    const char *no_traction; /* why it is left out; NULL: it is not */
} ovr_stress_plan;

/* The pressure is seen at nodes of one mesh size from the inlet, every so many
 * steps. */
typedef struct ovr_stress_sight {
    double inlet, mesh;
    size_t nodes;
    double every;
} ovr_stress_sight;

/* Returns that of a run, which sees each step. */
ovr_stress_sight ovr_stress_sight_of(const ovr_setup *setup);

/* Fails when depths are asked for that such moments cannot give. */
ovr_status ovr_stress_planned(const ovr_setup *setup, int surface,
                              ovr_stress_sight seen, ovr_stress_plan *plan,
                              ovr_error *err);

/* Way of the plan's surface since T = 0; 1, -1, or 0 where it goes both ways;
 * whether that may be; largest speed of either surface or the film, over um. */
double ovr_stress_distance(const ovr_setup *setup, const ovr_stress_plan *plan,
                           double T);
bool ovr_stress_wanders(const ovr_setup *setup);
int ovr_stress_direction(const ovr_setup *setup, const ovr_stress_plan *plan);
double ovr_stress_fastest(const ovr_setup *setup);

/* X at T = 0 of the material under which the other surface's feature is at
 * X = 0. */
double ovr_stress_struck(const ovr_setup *setup, const ovr_stress_plan *plan,
                         size_t feature);

/* The moment T of a surface; `before` the T of the one before. */
ovr_moment ovr_stress_moment(const ovr_setup *setup,
                             const ovr_stress_plan *plan, double T,
                             double before);

/* Bytes of the material histories of a prepared setup. */
double ovr_material_histories_memory(const ovr_setup *setup);

/* ---------------------------------------------------------------- traction */

/* Q of a moment at the plan's nodes: of the state, or of snapshot k of a file.
 * NULL where the plan is without; `workspace` has a value for each node. */
const double *ovr_traction_now(const ovr_stress_plan *plan,
                               const ovr_simulation *sim, double *workspace);
ovr_status ovr_traction_stored(const ovr_stress_plan *plan, ovr_result *result,
                               size_t k, double *workspace, ovr_error *err);
bool ovr_traction_is_stored(const ovr_stress_plan *plan,
                            const ovr_result *result);

/* ---------------------------------------------------------------- follower */

/* A material history in a thread of its own: moments are posted, and taken in
 * order. */
typedef struct ovr_follower ovr_follower;
ovr_follower *ovr_follower_create(const ovr_stress_plan *plan,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_follower_free(ovr_follower *f);

typedef enum ovr_post { OVR_POST_BEGIN, OVR_POST_STEP, OVR_POST_END } ovr_post;
void ovr_follower_post(ovr_follower *f, ovr_post part, const double *P,
                       const double *Q, const ovr_moment *moment);

/* Waits until all that was posted is taken; then the material history may be
 * looked at. */
ovr_material_history *ovr_follower_wait(ovr_follower *f);

/* ------------------------------------------------------------------ report */

/* The run that a report is of, and its file, which holds the pressure of all
 * moments; NULL: there is none. */
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

/* Parts of a report: of the body, of its layers, of a body
 * that yields, of the circle round a path. */
typedef enum ovr_stress_part {
    OVR_STRESS_BODY,
    OVR_STRESS_LAYERS,
    OVR_STRESS_YIELD,
    OVR_STRESS_CIRCLE
} ovr_stress_part;

/* The form of a number decides what is put next to it in a summary. */
typedef enum ovr_figure_form {
    OVR_FIGURE_NUMBER,
    OVR_FIGURE_SHARE, /* of a limit, the larger of both surfaces; NAN: none */
    OVR_FIGURE_PRESSURE, /* in Pa too */
    OVR_FIGURE_LENGTH,   /* in metres too */
    OVR_FIGURE_MOMENT,   /* with place and time, without a unit */
    OVR_FIGURE_STRIP,    /* the same, its width in place of the depth */
    OVR_FIGURE_STRESS,   /* with place and time, in Pa too */
    OVR_FIGURE_TENSION   /* such a stress, which may be absent */
} ovr_figure_form;

/* A number of a report, by its key. */
typedef struct ovr_stress_figure {
    ovr_stress_part part;
    ovr_figure_form form;
    const char *key;
    size_t offset;
    const char *label, *words; /* in reports; NULL: not line by line */
} ovr_stress_figure;

/* The k-th; NULL behind the last.  Its value, the place NAN where it has none.
 */
const ovr_stress_figure *ovr_stress_figure_at(size_t k);
ovr_stress_extreme ovr_stress_figure_of(const ovr_stress_figure *figure,
                                        const ovr_stress_report *report);

/* The group fatigue/surface_N of the file. */
ovr_status ovr_stress_store(ovr_writer *writer, const ovr_setup *setup,
                            const ovr_stress_report *report, ovr_error *err);

#endif
