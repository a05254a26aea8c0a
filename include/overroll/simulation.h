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
#include "overroll/heat.h"
#include "overroll/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum ovr_scheme {
    OVR_UPSTREAM1,     /* first-order wedge, backward Euler */
    OVR_UPSTREAM2,     /* second-order upstream wedge, BDF2 */
    OVR_CHARACTERISTIC /* narrow second order along the characteristic */
} ovr_scheme;

/* "upstream1", ...: the words of time.scheme; NULL if there is none. */
OVR_API const char *ovr_scheme_name(ovr_scheme scheme);

typedef enum ovr_smoother {
    OVR_LINE,         /* distributive line relaxation */
    OVR_HYBRID,       /* the paper: Gauss-Seidel and Jacobi dipole */
    OVR_GAUSS_SEIDEL, /* the paper's parts alone */
    OVR_DIPOLE
} ovr_smoother;

typedef enum ovr_stop {
    OVR_STOP_NEGLIGIBLE, /* algebraic error negligible beside 1e-6 of H */
    OVR_STOP_TRUNCATION, /* a fraction of the discretization error */
    OVR_STOP_FIXED       /* exactly `cycles` cycles per refinement: paper;
                            converged when the algebraic error is below the
                            difference from the next coarser level */
} ovr_stop;

/* Mean of rho H^3/eta between two nodes. */
typedef enum ovr_faces {
    OVR_FACES_LOGARITHMIC, /* harmonic in H^3, logarithmic in 1/eta */
    OVR_FACES_GAP,         /* harmonic in H^3, arithmetic in rho/eta: 0.3.0 */
    OVR_FACES_ARITHMETIC   /* of both nodes' rho H^3/eta: the paper's */
} ovr_faces;

/* The model of the film behind its rupture. */
typedef enum ovr_cavitation {
    OVR_CAVITATION_REYNOLDS,  /* P >= 0 alone: a gap without pressure is full */
    OVR_CAVITATION_CONSERVING /* it keeps the oil that came, and no more;
                                 upstream1 and upstream2, order 2, the line
                                 smoother and cycles to a tolerance only */
} ovr_cavitation;

/* Patches of ever finer mesh where the mesh of the whole domain is too coarse
 * (multigrid/composite.h).  Of steady solutions only: Newtonian, isothermal,
 * second-order schemes, the line smoother, cycles to a tolerance, level 6 at
 * least.  The pressure is then linear between nodes. */
typedef enum ovr_refine {
    OVR_REFINE_NONE,
    OVR_REFINE_SPIKE /* about the pressure spike, and to behind the rupture */
} ovr_refine;

/* Zero or NAN where noted means: the program chooses from M, L and level. */
typedef struct ovr_options {
    double inlet, outlet; /* X_a < 0 < X_b; NAN: automatic; 0: default
                             (overroll-case(5)) */
    int level;            /* finest grid, n = 7 * 2^level + 1 nodes; 8 */
    int coarsest_level;   /* 0: automatic (3: 57 nodes); the paper's is 1 */
    ovr_scheme scheme;    /* OVR_CHARACTERISTIC, for steps of one mesh; for
                             others, and where load or speed vary,
                             OVR_UPSTREAM2; steady solutions are the same */
    int order; /* 2; 4: corrected (fourth_order.h), with second-order schemes,
                  the line smoother and no fixed number of cycles only; 0: 4
                  where it applies, with a flow law too */
    ovr_smoother smoother;
    int cycle_index;                 /* 1: V, 2: W */
    int sweeps_before, sweeps_after; /* 0, 0: line 1, 1; hybrid 2, 2 */
    int max_cycles;                  /* steady: per refinement; 0: automatic */
    int cycles;                      /* with OVR_STOP_FIXED; the paper's 2 */
    ovr_stop stop;
    double tolerance;    /* on the residual R and load defect; 0: automatic */
    int mlmi_order;      /* even, 4..16; 0: from the accuracy needed */
    int mlmi_range;      /* corrections within so many mesh sizes; 0: same */
    double switch_value; /* hybrid: eps/D^2 above which Gauss-Seidel; 3 */
    double relax_seidel; /* under-relaxation, paper 0.5..1; 0.8 */
    double relax_dipole; /* paper 0.3..0.6; 0.5 */
    bool paper_balance;  /* H0 by the paper's relaxation on the coarsest
                            grid instead of the dense Newton step */
    ovr_cavitation cavitation;
    ovr_refine refine;
    int refine_level;     /* of the finest patch; 0: until the spike's height
                             has changed less on two levels running than by */
    double refine_change; /* so much, relative; 0: 1e-3 */
    ovr_faces faces;
} ovr_options;

OVR_API ovr_options ovr_options_default(void);

typedef struct ovr_simulation ovr_simulation;

/* Height of both surfaces' features at time T at the n nodes X, positive out
 * of the surface, in units of b^2/R; writes S[0..n-1]. */
typedef void ovr_heights(void *data, double T, size_t n, const double *X,
                         double *S);

/* Resolves the automatic options, allocates every level once.  Nothing is
 * allocated afterwards. Copies its arguments. */
OVR_API ovr_simulation *ovr_simulation_create(const ovr_contact *contact,
                                              const ovr_lubricant *lubricant,
                                              const ovr_options *options,
                                              const ovr_allocator *allocator,
                                              ovr_error *err);
OVR_API void ovr_simulation_free(ovr_simulation *sim);

/* The options after resolution (domain, coarsest level, tolerance, ...). */
OVR_API const ovr_options *ovr_simulation_options(const ovr_simulation *sim);

/* Roughness and histories; borrowed, must outlive the simulation.  Default:
 * smooth, constant. */
OVR_API void ovr_simulation_surface(ovr_simulation *sim, ovr_heights *heights,
                                    void *data);

/* The speed of what is on the surfaces, u_k/um of the surface whose features
 * are the steepest: the steps then begin from a guess that moves along, and
 * take fewer cycles.  Default: NAN, unknown; ovr_surfaces_speed returns it. */
OVR_API void ovr_simulation_moving(ovr_simulation *sim, double speed);

/* Sets the heights of stationary features (u_k = 0), fully grown, for
 * fourth-order corrections. NULL: the surfaces are smooth except for moving
 * features. The corrections of a run are computed for the steady
 * contact with these features only; without this call, for the surfaces at
 * T = 0. */
OVR_API void ovr_simulation_standing(ovr_simulation *sim, ovr_heights *standing,
                                     void *data);

/* Solves the steady problem at T = 0 (surface and histories as they are
 * there) by full multigrid; also the start of every run.  A contact at rest
 * has no film and one without load no end of it: a run from rest or from no
 * load starts from the steady film of OVR_MIN_START of the nominal speed or
 * load, and takes the histories as they are from there on. */
#define OVR_MIN_START 0.01
OVR_API ovr_status ovr_simulation_steady(ovr_simulation *sim, ovr_error *err);

/* One implicit step of length dT > 0.  If the step fails to converge, other
 * strategies and then half steps are tried; if all fail, the state is that of
 * the last time reached.  A step that had to be accepted above its tolerance,
 * or whose temperatures are not those of its film, is marked in the observation
 * and returns OVR_OK. */
OVR_API ovr_status ovr_simulation_step(ovr_simulation *sim, double dT,
                                       ovr_error *err);

/* The solution now.  Arrays of n values, owned by the simulation, valid until
 * the next call that changes it. */
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
    size_t lines;    /* across rolling, of n nodes each; of a line contact 1 */
    size_t line;     /* the one that P, H, S, q and eps are of, from 0 */
    const double *Y; /* of the lines, b; NULL of a line contact */
} ovr_state;
OVR_API const ovr_state *ovr_simulation_state(const ovr_simulation *sim);

/* Makes the state that of one line of a strip; of strip.shown if `line` is
 * beyond the last.  A line contact stays as it is. */
OVR_API void ovr_simulation_show(ovr_simulation *sim, size_t line);

/* Half the width, in b, of what the film's roughness is seen in. */
#define OVR_ROUGH_WINDOW 0.75

/* Numbers a step that have no names here, but a row in the list below. */
enum { OVR_MORE = 24 };

/* Quantities observed after a solve or step; definitions in the manual. */
typedef struct ovr_observation {
    double T, dT;
    double H_min, X_min;                 /* nodal */
    double H_min_located, X_min_located; /* parabola through three nodes */
    double H_min_cavity, X_min_cavity;   /* where there is no pressure; NAN:
                                            not smaller */
    double H_cen;                        /* cubic about X = 0 */
    double film_Rq; /* of the film in |X| < OVR_ROUGH_WINDOW: rho H there about
                       its mean, over the mean density; NAN: smooth surfaces */
    double P_cen;   /* the same for pressure */
    double P_max, X_P_max; /* nodal */
    double P_max_located, X_P_max_located;
    bool P_max_resolved;     /* false: more than a third of P_max is lost, on
                                average, two nodes away from it */
    double P_spike, X_spike; /* nodal; the last maximum at X > 0 that stands
                                more than 1e-3 above the lowest P between it
                                and the maximum before it; NAN: none */
    double P_spike_located, X_spike_located;
    bool P_spike_resolved; /* as P_max_resolved, of the spike; true without */
    double H0;
    double load;         /* integral of P */
    double load_error;   /* relative to the nominal load */
    double load_ratio;   /* Cw */
    double speed_ratio;  /* Cu */
    double sliding;      /* V = (u1 - u2)/um0 */
    double radius_ratio; /* R over the nominal one */
    double mass_flow;    /* mean over wet half nodes of the scheme's flux */
    double mass_balance; /* inflow - outflow - stored change, relative to the
                            contact's own flow, the mean of its size: vanishes
                            with the discretization */
    double X_cavitation; /* first cavitated node downstream of the film */
    double F_1, F_2;     /* force on each surface, along +x; ph b^2/R */
    double F_slide;      /* integral of the mean shear stress */
    double F_roll; /* integral of H P_X/2 from before the inlet on, against
                      the motion of both */
    double F_slope_1, F_slope_2; /* of pressure on the slopes of features */
    double mu_1, mu_2, mu_slide, mu_roll; /* over the load; NAN without b/R */
    double power_in;         /* put in by the surfaces; um ph b^2/R */
    double power_dissipated; /* in the film */
    double limiting_share;   /* of the load, where shear stress is at its limit
                              */
    /* Heat, NAN without: largest temperatures of film and surfaces, in K, as
     * rises above the supply's and where; flows into the surfaces, um ph b^2/R;
     * defect of the energy balance over what is made or flows out. */
    double T_film_max, X_T_film_max, T_max_rise;
    double T_1_max, X_T_1_max, T_1_max_rise;
    double T_2_max, X_T_2_max, T_2_max_rise;
    double heat_flow_1, heat_flow_2, energy_defect;
    double residual; /* relative mass-flow imbalance R */
    int order;       /* ovr_simulation_order */
    int cycles;      /* multigrid cycles of this step */
    int retries;     /* attempts after the first one */
    int maxima;      /* maxima of P that stand out so */
    bool converged;  /* R and load below tolerance */
    bool marked;     /* accepted above tolerance, or with other temperatures */
    /* mass-conserving cavitation; without it NAN */
    double supply;            /* q that arrives at the inlet */
    double meniscus;          /* X where the film begins; NAN: flooded */
    double starvation_factor; /* H_cen over that of the flooded contact under
                          the conditions of the moment */
    double inflow_ratio;      /* supply over the flow of that */
    double inflow, outflow;   /* Cu q less what the pressure drives back */
    double oil_inside;        /* integral of q over the domain */
    double oil_reservoir;     /* in the inlet reservoir; may be a small debt */
    double cavity_length; /* length of the cavitated region inside the film */
    double mass_defect;   /* inflow - outflow - stored change by the scheme's
                             own fluxes, over H_cen */
    /* patches about the spike; without them 0 and NAN */
    int refined_level;   /* of the finest */
    double spike_change; /* of the spike's height by the last level, relative */
    double more[OVR_MORE]; /* of physics without members of their own */
    double H_mean;       /* in |X| < 3/4, less where the contact is narrower */
    double lambda_ratio; /* of that over the composite roughness of both
                            surfaces; NAN: not known, or nothing is rough */
    /* bodies that yield; without them NAN */
    double plastic_strain;   /* the largest so far */
    double profile_change;   /* the largest so far, into the body */
    double shoulder_leading; /* highest points before and behind the middle of
                                the feature, in the way it goes */
    double shoulder_trailing;
} ovr_observation;
OVR_API const ovr_observation *
ovr_simulation_observation(const ovr_simulation *sim);

/* One level of the last steady solution's full multigrid: how far its cycles
 * brought it, and the discretization error that the next coarser level shows.
 * Levels where the load was still being raised are left out.  Differences of
 * pressure as D sum |dP| / (pi/2). */
typedef struct ovr_refinement {
    int level;
    size_t nodes;
    int cycles;
    double residual; /* R after the last cycle */
    double factor;   /* of the last cycle on R */
    double H_min, H_cen;
    double change;     /* of P by the last cycle */
    double algebraic;  /* estimate of what further cycles would change */
    double difference; /* of P from the solution of the level below */
} ovr_refinement;
OVR_API const ovr_refinement *
ovr_simulation_refinements(const ovr_simulation *sim, int *count);

/* ----------------------------------------------------------- quantities */

/* The axes that a quantity is spread over. */
typedef enum ovr_axes {
    OVR_AT_STEPS,   /* one number a step: a column of the history */
    OVR_AT_NODES,   /* along x */
    OVR_AT_HALVES,  /* at the half nodes; files hold the means at the nodes */
    OVR_AT_DEPTHS,  /* along x, depth by depth */
    OVR_AT_MATERIAL /* along a surface that moves, depth by depth */
} ovr_axes;

/* Physics that a quantity belongs to, as bits. */
enum {
    OVR_PHYSICS_CONTENT = 1,   /* mass-conserving cavitation */
    OVR_PHYSICS_HEAT = 2,      /* there are temperatures */
    OVR_PHYSICS_REFINED = 4,   /* there are patches of finer mesh */
    OVR_PHYSICS_FEATURES = 8,  /* there is something on the surfaces */
    OVR_PHYSICS_BOUNDARY = 16, /* surfaces touch through their film */
    OVR_PHYSICS_PLASTIC = 32,  /* a body yields */
    OVR_PHYSICS_WEAR = 64,     /* surfaces in asperity contact wear */
    OVR_PHYSICS_STRIP = 128    /* the film varies across rolling */
};

/* The extreme of a number that is kept over a run. */
typedef enum ovr_sense {
    OVR_NO_EXTREME,
    OVR_SMALLEST,
    OVR_LARGEST,
    OVR_OF_MAGNITUDE /* the value farthest from zero */
} ovr_sense;

/* Columns that a number has in the file of several passes, as bits. */
enum {
    OVR_PASS_MEAN = 1,
    OVR_PASS_SMALLEST = 2,
    OVR_PASS_LARGEST = 4,
    OVR_PASS_END = 8 /* its value at the end */
};

/* One row a quantity: result files, JSON, reports, tables of passes and
 * studies, checkpoints and help are made from this list.  A number a step is a
 * member of ovr_observation; the values of a field are made when they are asked
 * for. */
typedef struct ovr_observable {
    const char *name;      /* "min_film_thickness"; NULL: not in files */
    const char *key;       /* "H_min_located", of JSON; NULL: not there */
    const char *key_si;    /* the same in SI; NULL: not there */
    const char *long_name; /* the name of the quantity */
    const char *comment;   /* its definition, in files (CF); or NULL */
    ovr_unit_kind kind;
    ovr_axes axes;
    size_t offset; /* of a number: in ovr_observation */
    /* The values of a field now, at all nodes (half nodes: one less); where
     * they lie already, or in `workspace` for as many values. */
    const double *(*field)(const ovr_simulation *sim, double *workspace);
    unsigned needs;    /* physics without which it is not known; 0: none */
    const char *label; /* of its line in reports; NULL: it has none */
    const char *note;  /* remark there, or NULL; a note that begins with
                          "|X|" or "X = " is where the number is taken */
    int digits;        /* of the number there; 0: 6 */
    size_t place;      /* where it is: another member's offset; 0: nowhere */
    /* Kept over a run, of a number that is a double: its extreme, with where
     * and when that was, and its mean; their JSON keys, NULL: not kept. */
    ovr_sense extreme;
    const char *extreme_key, *mean_key;
    bool extreme_reported, mean_reported; /* reports have a line for it */
    bool steady;   /* also reported for steady solutions */
    unsigned pass; /* columns in the file of several passes */
    /* Its place from the left in the table of passes that people read, 0: none,
     * the short name there, and the physics without which it is left out. */
    int pass_place;
    const char *pass_head;
    unsigned pass_with;
    /* The sum over a run, of a count or a flag: its JSON key and its label in
     * what is told of a file; NULL: unknown. */
    const char *total_key, *total_label;
    bool friction; /* of the film: reports leave out its extreme and mean where
                      they are 0, or what no oil carries */
} ovr_observable;

/* NULL past the end. */
OVR_API const ovr_observable *ovr_observable_at(size_t k);

OVR_API double ovr_observable_value(const ovr_observable *which,
                                    const ovr_observation *from);

/* Totals, extremes and means since the steady start, which counts.  Of an
 * extreme the member that the quantity has in an observation is its value in
 * `extreme`, its place in `where`, its time in `when`; its mean is in `mean`.
 * What is not kept is 0. */
typedef struct ovr_statistics {
    long steps, cycles, retries, substeps, marked;
    bool settled;           /* a march until steady ended because it was */
    long lagging;           /* steps marked for temperatures not their film's */
    double last_cross_film; /* heat: largest Legendre coefficient of the highest
                           degree across, over the rise; 0: less than 0.05 */
    double averaged;        /* until when there are means */
    bool P_max_unresolved;  /* the extreme of P_max was not P_max_resolved */
    ovr_observation extreme, where, when, mean;
    double
        H_mean_at_H_min; /* the film in |X| < 3/4 when H_min_located was least
                          */
} ovr_statistics;
OVR_API const ovr_statistics *
ovr_simulation_statistics(const ovr_simulation *sim);

/* A number that is kept over a run: attributes of result files, JSON and tables
 * are made from these.  They follow from the rows of the quantities. */
typedef enum ovr_kept_part {
    OVR_KEPT_EXTREME,
    OVR_KEPT_PLACE,
    OVR_KEPT_TIME,
    OVR_KEPT_MEAN
} ovr_kept_part;
typedef struct ovr_extreme {
    char key[48];        /* "P_max_overall"; of JSON, and an attribute */
    char key_si[64];     /* the same in SI; "": a pure number */
    char label[96];      /* "mean central film thickness" */
    char long_name[160]; /* "mean central film thickness over the run" */
    ovr_unit_kind kind;
    ovr_kept_part part;
    const ovr_observable *of;
} ovr_extreme;

/* false past the end, or without `to`. */
OVR_API bool ovr_extreme_at(size_t k, ovr_extreme *to);
OVR_API double ovr_extreme_value(const ovr_extreme *which,
                                 const ovr_statistics *from);

/* A piece of memory that is part of a state: its name, address and bytes. */
typedef ovr_status ovr_visit(void *context, const char *name, void *memory,
                             size_t bytes, ovr_error *err);

/* ---------------------------------------------------------- time loop */

/* One that looks on: a result file, stresses, progress, yourself. */
typedef struct ovr_observer {
    /* Called after the steady start and after each step; anything but OVR_OK
     * ends the run with that status. */
    ovr_status (*observe)(void *data, const ovr_simulation *sim,
                          ovr_error *err);
    /* Next time after T that must be hit exactly, or INFINITY; may be NULL. */
    double (*next_time)(void *data, double T);
    void *data;
} ovr_observer;

typedef struct ovr_march {
    double end;        /* last time */
    double dT;         /* step; 0: the mesh size */
    bool adaptive;     /* step from the scheme's own error estimate */
    double error;      /* adaptive: relative error of H that the steps add on
                          its way through the contact, 1e-3 */
    bool until_steady; /* stop when nothing changes any more */
    size_t count;      /* observers, asked in this order */
    const ovr_observer *observers;
    double steady_from; /* until_steady: not before this time */
    double steady_rate; /* and when P and S change less a b/um; 0: 1e-8 */
} ovr_march;

/* Runs from the state now (steady start or restored) to the end.  With a fixed
 * dT the k-th time is exactly k dT. */
OVR_API ovr_status ovr_simulation_march(ovr_simulation *sim,
                                        const ovr_march *march, ovr_error *err);

/* One step of that march (none at its end), for a loop of one's own, and
 * whether there are more.  Its observers are asked after it. */
OVR_API ovr_status ovr_simulation_advance(ovr_simulation *sim,
                                          const ovr_march *march, bool *more,
                                          ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
