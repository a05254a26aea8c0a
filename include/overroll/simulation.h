/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The simulation: a contact on a grid hierarchy, solved steady or marched in
 * time.  All quantities are dimensionless in the contact's scaling.
 *
 *     ovr_options options = ovr_options_default();
 *     ovr_simulation *sim =
 *         ovr_simulation_create(&contact, &lubricant, &options, NULL, &err);
 *     ovr_simulation_surface(sim, my_heights, my_data);
 *     ovr_simulation_steady(sim, &err);            start of every run
 *     while (ovr_simulation_state(sim)->T < 6)
 *         if (ovr_simulation_step(sim, dT, &err)) ...
 *     ovr_simulation_free(sim);
 */
#ifndef OVERROLL_SIMULATION_H
#define OVERROLL_SIMULATION_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/contact.h"
#include "overroll/error.h"
#include "overroll/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum ovr_scheme {
    OVR_UPSTREAM1,     /* first-order wedge, backward Euler */
    OVR_UPSTREAM2,     /* second-order upstream wedge, BDF2 */
    OVR_CHARACTERISTIC /* narrow second order along the characteristic */
} ovr_scheme;

/* Returns the value of time.scheme ("upstream1", ...), or NULL for an unknown
 * scheme. */
OVR_API const char *ovr_scheme_name(ovr_scheme scheme);

typedef enum ovr_smoother {
    OVR_LINE,   /* distributive line relaxation */
    OVR_HYBRID, /* smoother of the paper: Gauss-Seidel and Jacobi dipole */
    OVR_GAUSS_SEIDEL, /* Gauss-Seidel part of the paper's smoother only */
    OVR_DIPOLE
} ovr_smoother;

typedef enum ovr_stop {
    OVR_STOP_NEGLIGIBLE, /* algebraic error well below 1e-6 of H */
    OVR_STOP_TRUNCATION, /* algebraic error below a fraction of the
                            discretization error */
    OVR_STOP_FIXED /* exactly `cycles` cycles per refinement, as in the paper.
                      The solution counts as converged if the algebraic error is
                      below the difference from the next coarser level */
} ovr_stop;

/* Mean of rho H^3/eta between two nodes. */
typedef enum ovr_faces {
    OVR_FACES_LOGARITHMIC, /* harmonic in H^3, logarithmic in 1/eta */
    OVR_FACES_GAP,         /* harmonic in H^3, arithmetic in rho/eta: 0.3.0 */
    OVR_FACES_ARITHMETIC   /* arithmetic in rho H^3/eta, as in the paper */
} ovr_faces;

/* Cavitation model downstream of film rupture. */
typedef enum ovr_cavitation {
    OVR_CAVITATION_REYNOLDS,  /* only P >= 0: cavitated gaps are full of
                                 lubricant */
    OVR_CAVITATION_CONSERVING /* mass-conserving; only with the line smoother
                                 and cycles to a tolerance */
} ovr_cavitation;

/* Nested patches of finer grids where the grid of the domain is too coarse
 * (overroll-theory(7)). They need a steady, Newtonian, isothermal contact,
 * a second-order scheme, the line smoother, cycles to a tolerance and at least
 * level 6. The pressure is then linear between nodes. */
typedef enum ovr_refine {
    OVR_REFINE_NONE,
    OVR_REFINE_SPIKE /* around the pressure spike and across the film rupture */
} ovr_refine;

/* Where noted, zero or NAN selects the value from M, L and level. */
typedef struct ovr_options {
    double inlet, outlet; /* X_a < 0 < X_b; NAN: automatic; 0: default
                             (overroll-case(5)) */
    int level;            /* finest grid, n = 7 * 2^level + 1 nodes; 8 */
    int coarsest_level;   /* 0: automatic (3: 57 nodes); the paper's is 1 */
    ovr_scheme
        scheme; /* OVR_CHARACTERISTIC, or OVR_UPSTREAM2 for long steps and
                   varying load or speed; both have the same steady solution */
    int order;  /* 2, or 4: with corrections (overroll-theory(7)), which need a
                   second-order scheme, the line smoother and no fixed number of
                   cycles; 0: 4 if possible */
    ovr_smoother smoother;
    int cycle_index; /* 1: V, 2: W */
    int sweeps_before,
        sweeps_after; /* 0, 0: 1 and 1 (line) or 2 and 2 (hybrid) */
    int max_cycles; /* steady solutions: maximum per refinement; 0: automatic */
    int cycles;     /* number of cycles with OVR_STOP_FIXED; paper: 2 */
    ovr_stop stop;
    double tolerance; /* tolerance of the residual R and the load error; 0:
                         automatic */
    int mlmi_order;   /* even, 4 to 16; 0: chosen by the required accuracy */
    int mlmi_range;   /* range of corrections in mesh sizes; 0: as mlmi_order */
    double switch_value; /* hybrid: eps/D^2 above which Gauss-Seidel is used;
                            default 3 */
    double relax_seidel; /* under-relaxation, paper: 0.5 to 1; default 0.8 */
    double relax_dipole; /* paper: 0.3 to 0.6; default 0.5 */
    bool paper_balance;  /* H0 by the paper's relaxation on the coarsest grid
                            instead of a dense Newton step */
    ovr_cavitation cavitation;
    ovr_refine refine;
    int refine_level; /* level of the finest patch; 0: until the height of the
                         spike changes by less than refine_change on two
                         successive levels */
    double refine_change; /* relative; 0: 1e-3 */
    ovr_faces faces;
} ovr_options;

OVR_API ovr_options ovr_options_default(void);

typedef struct ovr_simulation ovr_simulation;

/* Writes the height of the features of both surfaces at time T at the n nodes
 * X to S[0..n-1], in b^2/R, positive outward. */
typedef void ovr_heights(void *data, double T, size_t n, const double *X,
                         double *S);

/* Resolves the automatic options and allocates all levels. Later calls
 * allocate nothing. The arguments are copied. */
OVR_API ovr_simulation *ovr_simulation_create(const ovr_contact *contact,
                                              const ovr_lubricant *lubricant,
                                              const ovr_options *options,
                                              const ovr_allocator *allocator,
                                              ovr_error *err);
OVR_API void ovr_simulation_free(ovr_simulation *sim);

/* The options after resolution (domain, coarsest level, tolerance, ...). */
OVR_API const ovr_options *ovr_simulation_options(const ovr_simulation *sim);

/* Sets the surface heights. `data` must outlive the simulation. Default:
 * smooth surfaces. */
OVR_API void ovr_simulation_surface(ovr_simulation *sim, ovr_heights *heights,
                                    void *data);

/* Sets u_k/u_m of the surface with the steepest features. Time steps then
 * extrapolate along the moving features and need fewer cycles. NAN (default):
 * unknown. ovr_surfaces_speed returns the value. */
OVR_API void ovr_simulation_moving(ovr_simulation *sim, double speed);

/* Sets the heights of stationary features (u_k = 0), fully grown, for
 * fourth-order corrections. NULL: the surfaces are smooth except for moving
 * features. The corrections of a run are computed for the steady
 * contact with these features only; without this call, for the surfaces at
 * T = 0. */
OVR_API void ovr_simulation_standing(ovr_simulation *sim, ovr_heights *standing,
                                     void *data);

/* Solves the steady problem at T = 0 by full multigrid; every run starts with
 * it. If speed or load are zero at T = 0, the start is the steady film at
 * OVR_MIN_START of the reference speed or load. The histories apply from the
 * first step on. */
#define OVR_MIN_START 0.01
OVR_API ovr_status ovr_simulation_steady(ovr_simulation *sim, ovr_error *err);

/* Advances by one implicit step of length dT > 0. If the step does not
 * converge, other strategies and then half steps are tried. If all fail, the
 * state remains that of the last time. A step that is accepted above
 * tolerance, or whose temperatures are inconsistent with the film, is flagged
 * in the observation and returns OVR_OK. */
OVR_API ovr_status ovr_simulation_step(ovr_simulation *sim, double dT,
                                       ovr_error *err);

/* The current solution. The arrays have n values, are owned by the simulation
 * and are valid until the next call that changes it. */
typedef struct ovr_state {
    long step;
    double T;
    size_t n;
    double D; /* mesh size, the smallest */
    const double *X;
    const double *weights; /* integral of f: sum of weights f */
    const double *P;       /* pressure / ph */
    const double *H;       /* film thickness R/b^2 */
    const double *S;       /* feature height R/b^2 */
    const double *q;       /* rho H */
    const double *eps;     /* rho H^3/(eta lambda) */
    double H0;
    size_t lines;    /* number of lines across rolling with n nodes each; line
                        contact: 1 */
    size_t line;     /* line to which P, H, S, q and eps refer, from 0 */
    const double *Y; /* Y of the lines in b; NULL for a line contact */
} ovr_state;
OVR_API const ovr_state *ovr_simulation_state(const ovr_simulation *sim);

/* Selects the line of a strip to which the state refers; strip.shown if `line`
 * is beyond the last. It has no effect on line contacts. */
OVR_API void ovr_simulation_show(ovr_simulation *sim, size_t line);

/* Half-width in b of the window in which the roughness of the film is
 * measured. */
#define OVR_ROUGH_WINDOW 0.75

/* Number of quantities per step that have only a row in the list below. */
enum { OVR_MORE = 24 };

/* Quantities observed after a solve or step; definitions in the manual. */
typedef struct ovr_observation {
    double T, dT;
    double H_min, X_min; /* nodal */
    double H_min_located,
        X_min_located; /* interpolated by a parabola through three nodes */
    double H_min_cavity,
        X_min_cavity; /* in cavitated regions; NAN: not smaller than H_min */
    double H_cen;     /* film thickness at X = 0, by cubic interpolation */
    double film_Rq;   /* root mean square of rho H about its mean in |X| <
                         OVR_ROUGH_WINDOW, relative to the mean density; NAN:
                         smooth surfaces */
    double P_cen;     /* pressure at X = 0 */
    double P_max, X_P_max; /* nodal */
    double P_max_located, X_P_max_located;
    bool P_max_resolved; /* false: P_unresolved is more than 2 % above P_max */
    double P_unresolved, X_unresolved; /* height on finer grids, and position,
                                          of the highest spike that the grid
                                          does not resolve; 0: no spike */
    double P_spike,
        X_spike; /* nodal; last maximum at X > 0 that exceeds the preceding
                    minimum by more than 1e-3; NAN: none */
    double P_spike_located, X_spike_located;
    bool P_spike_resolved; /* the mean pressure of the adjacent nodes is at
                              least 90 % of the spike; true without a spike */
    double H0;
    double load;         /* integral of P */
    double load_error;   /* load error relative to the reference load */
    double load_ratio;   /* Cw */
    double speed_ratio;  /* Cu */
    double sliding;      /* V = (u1 - u2)/um0 */
    double radius_ratio; /* R relative to the reference radius */
    double mass_flow;    /* mean of the discrete flux over the pressurized half
                            nodes */
    double mass_balance; /* inflow - outflow - stored change, relative to the
                            mean flow magnitude; a discretization error */
    double X_cavitation; /* first cavitated node downstream of the film */
    double F_1, F_2;     /* force on each surface along +x, p_h b^2/R */
    double F_slide;      /* integral of the mean shear stress */
    double F_roll; /* integral of H P_X/2 from upstream of the inlet on; opposes
                      the motion of both surfaces */
    double F_slope_1,
        F_slope_2; /* force of the pressure on the slopes of features */
    double mu_1, mu_2, mu_slide,
        mu_roll;     /* relative to the load; NAN if b/R is unknown */
    double power_in; /* mechanical power input by the surfaces, u_m p_h b^2/R */
    double power_dissipated; /* power dissipated in the film */
    double limiting_share;   /* load share carried where the shear stress is at
                                its limit */
    /* Heat; NAN without [heat]. Maximum temperatures of film and surfaces in
     * K, their positions, and their rises above the supply temperature; heat
     * flows into the surfaces in u_m p_h b^2/R; error of the energy balance
     * relative to the dissipated power. */
    double T_film_max, X_T_film_max, T_max_rise;
    double T_1_max, X_T_1_max, T_1_max_rise;
    double T_2_max, X_T_2_max, T_2_max_rise;
    double heat_flow_1, heat_flow_2, energy_defect;
    double T_max_finer; /* T_max_rise expected on finer grids: the largest sum
                           of a temperature and its excess over the mean of the
                           adjacent nodes */
    double residual;    /* relative mass-flow imbalance R */
    int order;  /* order of the step: as in the run, or 2 without corrections */
    int cycles; /* multigrid cycles of this step */
    int retries;    /* number of repeated attempts */
    int maxima;     /* number of maxima of P, as defined at P_spike */
    bool converged; /* R and load error below tolerance */
    bool
        marked; /* accepted above tolerance or with inconsistent temperatures */
    /* mass-conserving cavitation, otherwise NAN */
    double supply;            /* lubricant supply: q upstream of the inlet */
    double meniscus;          /* X of the inlet meniscus; NAN: flooded */
    double starvation_factor; /* H_cen relative to the flooded contact under the
                                 current conditions */
    double inflow_ratio;      /* supply relative to the flow rate of the flooded
                                 contact */
    double inflow, outflow;   /* Cu q minus the pressure-driven backflow */
    double oil_inside;        /* integral of q over the domain */
    double oil_reservoir;     /* lubricant volume in the inlet reservoir; may be
                                 slightly negative */
    double cavity_length; /* length of the cavitated region inside the film */
    double mass_defect;   /* inflow - outflow - stored change by the discrete
                             fluxes, relative to H_cen */
    /* patches around the spike; otherwise 0 and NAN */
    int refined_level;     /* level of the finest patch */
    double spike_change;   /* relative change of the spike height by the last
                              level */
    double more[OVR_MORE]; /* quantities of physical models without named
                              members */
    double H_mean; /* mean film thickness in |X| < 3/4, or in a narrower window
                      if the contact is narrower */
    double lambda_ratio; /* H_mean divided by the composite roughness of both
                            surfaces; NAN: unknown or smooth */
    /* plastic bodies, otherwise NAN */
    double plastic_strain;   /* maximum so far */
    double profile_change;   /* maximum so far, positive into the body */
    double shoulder_leading; /* maximum height on the leading and trailing side
                                of the feature */
    double shoulder_trailing;
} ovr_observation;
OVR_API const ovr_observation *
ovr_simulation_observation(const ovr_simulation *sim);

/* Convergence on one level of full multigrid in the last steady solution, and
 * the difference from the next coarser level as an estimate of the
 * discretization error. Levels on which the load was still increased are
 * omitted. Pressure differences are D sum |dP| / (pi/2). */
typedef struct ovr_refinement {
    int level;
    size_t nodes;
    int cycles;
    double residual; /* R after the last cycle */
    double factor;   /* reduction of R by the last cycle */
    double H_min, H_cen;
    double change;     /* change of P by the last cycle */
    double algebraic;  /* estimate of what further cycles would change */
    double difference; /* difference of P from the solution on the next coarser
                          level */
} ovr_refinement;
OVR_API const ovr_refinement *
ovr_simulation_refinements(const ovr_simulation *sim, int *count);

/* ----------------------------------------------------------- quantities */

/* Axes along which a quantity varies. */
typedef enum ovr_axes {
    OVR_AT_STEPS,   /* one number per step: a column of the history */
    OVR_AT_NODES,   /* one number per node */
    OVR_AT_HALVES,  /* at the half nodes; files contain means at the nodes */
    OVR_AT_DEPTHS,  /* along x, for each depth */
    OVR_AT_MATERIAL /* along a moving surface, for each depth */
} ovr_axes;

/* Physical models that a quantity requires, as bits. */
enum {
    OVR_PHYSICS_CONTENT = 1,   /* mass-conserving cavitation */
    OVR_PHYSICS_HEAT = 2,      /* heat */
    OVR_PHYSICS_REFINED = 4,   /* patches of finer grids */
    OVR_PHYSICS_FEATURES = 8,  /* surface features */
    OVR_PHYSICS_BOUNDARY = 16, /* mixed lubrication */
    OVR_PHYSICS_PLASTIC = 32,  /* plastic bodies */
    OVR_PHYSICS_WEAR = 64,     /* running-in */
    OVR_PHYSICS_STRIP = 128    /* strip: the film varies across rolling */
};

/* Extreme of a quantity over a run. */
typedef enum ovr_sense {
    OVR_NO_EXTREME,
    OVR_SMALLEST,
    OVR_LARGEST,
    OVR_OF_MAGNITUDE /* the value of largest magnitude */
} ovr_sense;

/* Columns of a quantity in the file of several passes, as bits. */
enum {
    OVR_PASS_MEAN = 1,
    OVR_PASS_SMALLEST = 2,
    OVR_PASS_LARGEST = 4,
    OVR_PASS_END = 8 /* value at the end of the pass */
};

/* A row of the list of quantities, from which result files, JSON, reports,
 * tables of passes and studies, checkpoints and help are generated. A number
 * per step is a member of ovr_observation; the values of a field are computed
 * on request. */
typedef struct ovr_observable {
    const char *name;      /* "min_film_thickness"; NULL: not in files */
    const char *key;       /* "H_min_located", key in JSON; NULL: not in JSON */
    const char *key_si;    /* key of the value in SI; NULL: none */
    const char *long_name; /* the name of the quantity */
    const char *comment;   /* definition in result files (CF), or NULL */
    ovr_unit_kind kind;
    ovr_axes axes;
    size_t offset; /* offset of a number in ovr_observation */
    /* Returns the current values of a field at all nodes (one less at half
     * nodes), either stored elsewhere or in `workspace`, which has space for
     * them. */
    const double *(*field)(const ovr_simulation *sim, double *workspace);
    unsigned needs; /* physical models without which it is unknown; 0: none */
    const char *label; /* label in reports; NULL: not reported */
    const char *note;  /* remark in reports, or NULL; a note that begins with
                          "|X|" or "X = " is the position */
    int digits;        /* significant digits in reports; 0: 6 */
    size_t place;      /* offset of the member with its position; 0: none */
    /* Extreme over a run, with position and time, and mean, of a number of
     * type double; their JSON keys, NULL: not computed. */
    ovr_sense extreme;
    const char *extreme_key, *mean_key;
    bool extreme_reported,
        mean_reported; /* reports have a line for the extreme, the mean */
    bool steady;       /* also reported for steady solutions */
    unsigned pass;     /* columns in the file of several passes */
    /* Position in the table of passes in reports from the left (0: none),
     * short name there, and physical models without which it is omitted. */
    int pass_place;
    const char *pass_head;
    unsigned pass_with;
    /* JSON key and label of the sum over a run, for a count or flag; NULL: no
     * sum. */
    const char *total_key, *total_label;
    bool friction; /* a friction coefficient: reports omit its extreme and mean
                      if they are 0 or not realistic */
} ovr_observable;

/* Returns NULL past the end. */
OVR_API const ovr_observable *ovr_observable_at(size_t k);

OVR_API double ovr_observable_value(const ovr_observable *which,
                                    const ovr_observation *from);

/* Sums, extremes and means over the run, including the steady start. The
 * member of a quantity in an observation contains its extreme in `extreme`,
 * the position of the extreme in `where`, the time in `when`, and its mean in
 * `mean`; 0: not computed. */
typedef struct ovr_statistics {
    long steps, cycles, retries, substeps, marked;
    bool settled;           /* the run ended because the film became steady */
    long lagging;           /* steps flagged for inconsistent temperatures */
    double last_cross_film; /* heat: maximum coefficient of the highest Legendre
                               polynomial across the film, relative to the
                               temperature rise; 0: less than 0.05 */
    double averaged;        /* time up to which means are computed */
    bool P_max_unresolved;  /* the maximum of P_max is not resolved */
    double P_unresolved, X_unresolved,
        T_unresolved; /* largest P_unresolved, its position and time */
    double T_max_finer, T_T_max_finer; /* heat: largest T_max_finer, its time */
    double defect_at_T_max; /* energy_defect at the time of the maximum of
                               T_max_rise */
    ovr_observation extreme, where, when, mean;
    double H_mean_at_H_min; /* mean film thickness in |X| < 3/4 at the time of
                               the minimum of H_min_located */
    long uncorrected; /* steps of a run of order 4 solved without corrections */
    /* Bit k: the extreme of the k-th quantity with an extreme is from a flagged
     * step, which did not converge */
    unsigned long long flagged_extremes;
} ovr_statistics;
OVR_API const ovr_statistics *
ovr_simulation_statistics(const ovr_simulation *sim);

/* A number computed over a run, derived from the row of a quantity. Attributes
 * of result files, JSON and tables contain these numbers. */
typedef enum ovr_kept_part {
    OVR_KEPT_EXTREME,
    OVR_KEPT_PLACE,
    OVR_KEPT_TIME,
    OVR_KEPT_MEAN
} ovr_kept_part;
typedef struct ovr_extreme {
    char key[48];        /* "P_max_overall", key in JSON and attribute */
    char key_si[64];     /* key of the value in SI, or "" */
    char label[96];      /* "mean central film thickness" */
    char long_name[160]; /* "mean central film thickness over the run" */
    ovr_unit_kind kind;
    ovr_kept_part part;
    const ovr_observable *of;
} ovr_extreme;

/* Returns false past the end or if `to` is NULL. */
OVR_API bool ovr_extreme_at(size_t k, ovr_extreme *to);
OVR_API double ovr_extreme_value(const ovr_extreme *which,
                                 const ovr_statistics *from);

/* ---------------------------------------------------------- time loop */

/* An observer of a run, such as a result file, stresses or a progress display.
 */
typedef struct ovr_observer {
    /* Called after the steady start and after each step; anything but OVR_OK
     * ends the run with that status. */
    ovr_status (*observe)(void *data, const ovr_simulation *sim,
                          ovr_error *err);
    /* Returns the next time after T that a step must reach exactly, or
     * INFINITY; may be NULL. */
    double (*next_time)(void *data, double T);
    void *data;
} ovr_observer;

typedef struct ovr_march {
    double end;    /* end time */
    double dT;     /* time step; 0: the mesh size */
    bool adaptive; /* time step by the error estimate of the scheme */
    double error; /* adaptive: relative error of H added by the steps during one
                     passage of the contact; default 1e-3 */
    bool until_steady; /* stop when the film is steady */
    size_t count;      /* number of observers, called in this order */
    const ovr_observer *observers;
    double steady_from; /* until_steady: earliest end */
    double steady_rate; /* until_steady: largest change of P and S per b/u_m; 0:
                           1e-8 */
} ovr_march;

/* Runs from the current state (steady start or restored) to the end. With a
 * fixed dT the time of step k is exactly k dT. */
OVR_API ovr_status ovr_simulation_march(ovr_simulation *sim,
                                        const ovr_march *march, ovr_error *err);

/* Makes one step of such a run (none at its end) and calls the observers.
 * *more: further steps remain. */
OVR_API ovr_status ovr_simulation_advance(ovr_simulation *sim,
                                          const ovr_march *march, bool *more,
                                          ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
