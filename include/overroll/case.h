/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A case: the text that describes a run, read from a file and single settings,
 * and its resolution into a setup.
 *
 *     ovr_case *c = ovr_case_read("dent.ini", NULL, &err);
 *     ovr_case_set(c, "domain.level", "9", "--level", &err);
 *     ovr_setup *setup = ovr_case_resolve(c, NULL, &err);
 *     ovr_simulation *sim = ovr_setup_simulation(setup, NULL, &err);
 *     ovr_simulation_steady(sim, &err);
 *     ovr_march march = *setup->march;  march.observers = ...;
 *     ovr_simulation_march(sim, &march, &err);
 *     ovr_simulation_free(sim), ovr_setup_free(setup), ovr_case_free(c);
 *
 * The keys of a case are one table, listed by ovr_parameter_at and described in
 * overroll-case(5).
 */
#ifndef OVERROLL_CASE_H
#define OVERROLL_CASE_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/contact.h"
#include "overroll/elements.h"
#include "overroll/error.h"
#include "overroll/memory.h"
#include "overroll/simulation.h"
#include "overroll/stress.h"
#include "overroll/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------- the table */

/* A key of the case, as described in help and manual. */
typedef struct ovr_parameter_info {
    const char *section, *key;
    const char *type;  /* "number", "whole number", "choice", ... */
    const char *units; /* allowed units, "" for none */
    const char *
        bare; /* unit of a number without a unit: "b", "b^2/R", "b/um", or "" */
    const char *initial;     /* default as in a case file, or NULL */
    double minimum, maximum; /* allowed, in SI or bare; NAN: not a number */
    bool above;              /* `minimum` itself is not allowed */
    const char *limit_unit;  /* unit of the limits in help and messages, "" for
                                none; angles have "deg" */
    double limit_value;      /* value of 1 limit_unit in SI or bare */
    const char *choices[24]; /* allowed words, terminated by NULL */
    bool physics;            /* the value affects the solution */
    const char *help;
    char when[240]; /* condition under which the key has an effect ("history =
                       ramp or step"), or "" */
} ovr_parameter_info;

OVR_API size_t ovr_parameter_count(void);
OVR_API ovr_parameter_info ovr_parameter_at(size_t k);

/* Returns the "section.key" that a usual symbol or name of a quantity ("E",
 * "eta0", "SRR") stands for, or NULL if the symbol is unknown. */
OVR_API const char *ovr_parameter_by_symbol(const char *symbol);

/* Name and help text of section k, NULL past the last. The second function
 * returns true if there may be several such sections with names: [feature
 * NAME]. */
OVR_API const char *ovr_section_name(size_t k);
OVR_API bool ovr_section_named(size_t k);
OVR_API const char *ovr_section_help(size_t k);

/* ------------------------------------------------------------- listeners */

typedef enum ovr_message_kind {
    OVR_MESSAGE_WARNING, /* the result may not be the intended one */
    OVR_MESSAGE_NOTE,    /* an assumption or an automatic choice */
    OVR_MESSAGE_FILE     /* about a file; the text begins with its name */
} ovr_message_kind;

/* One line of text, without end of line. */
typedef void ovr_listener(void *data, ovr_message_kind kind, const char *text);

/* --------------------------------------------------------------- the case */

typedef struct ovr_case ovr_case;

/* Creates an empty case. */
OVR_API ovr_case *ovr_case_create(const ovr_allocator *allocator,
                                  ovr_error *err);

/* Reads a case from a file; relative paths inside it start at its directory. */
OVR_API ovr_case *ovr_case_read(const char *path,
                                const ovr_allocator *allocator, ovr_error *err);

/* Reads a case from text.  Messages give `name` as the file, and relative
 * paths start at `directory` (NULL: the working directory). */
OVR_API ovr_case *ovr_case_read_text(const char *text, const char *name,
                                     const char *directory,
                                     const ovr_allocator *allocator,
                                     ovr_error *err);
OVR_API void ovr_case_free(ovr_case *c);

/* Sets one key, `where` = "section.key" ("feature dent.depth" or
 * "feature.dent.depth"). The value is parsed like a line of the file and
 * replaces earlier values. Messages name `origin` instead of file and line. */
OVR_API ovr_status ovr_case_set(ovr_case *c, const char *where,
                                const char *value, const char *origin,
                                ovr_error *err);

/* Sets a key from the text "section.key=value". */
OVR_API ovr_status ovr_case_assign(ovr_case *c, const char *assignment,
                                   const char *origin, ovr_error *err);

/* Resets a setting to its default; unknown settings are ignored. */
OVR_API void ovr_case_unset(ovr_case *c, const char *where);

/* Returns the text of the case including later settings. Reading this text in
 * the same directory gives the same case. The text is owned by the case. */
OVR_API const char *ovr_case_text(ovr_case *c, ovr_error *err);

OVR_API const char *ovr_case_name(const ovr_case *c);
OVR_API const char *ovr_case_directory(const ovr_case *c);

/* Every parameter of every section present, in the order of the table. */
typedef struct ovr_case_entry {
    const char *section; /* "contact", "feature" */
    const char *name;    /* name of a feature, otherwise NULL */
    const char *key;
    const char *text; /* the given value, otherwise the default, or NULL */
    bool given;       /* set in the file or by ovr_case_set */
    const char *file; /* file or origin; NULL if not set */
    long line;        /* 0: no line */
    double number;    /* in SI or without a unit; NAN: not a number */
    const char *unit; /* SI unit of the number, if it has one */
    size_t parameter; /* index for ovr_parameter_at */
    bool applies;     /* has an effect together with the other keys */
} ovr_case_entry;
OVR_API size_t ovr_case_entries(const ovr_case *c);
OVR_API ovr_case_entry ovr_case_entry_at(const ovr_case *c, size_t k);

/* ---------------------------------------------------------- resolved case */

typedef struct ovr_list {
    size_t count;
    const double *values;
} ovr_list;

/* Selects the results that are stored; times are in b/u_m, lengths in b. */
typedef struct ovr_output {
    const char *file;  /* relative to the working directory, or NULL */
    const char *title; /* or NULL */
    int every;         /* number of steps between snapshots; 0: not by steps */
    double interval;   /* time between snapshots; 0: not by time */
    ovr_list at;       /* given times */
    ovr_list feature_at; /* X at which the centre of a feature is at the time of
                            a snapshot */
    unsigned fields;     /* bits in the order of the parameter's choices */
    bool single;         /* f32 */
    double from, to;     /* window in X; NAN: the whole domain */
    int stride;
    int compression;
    double checkpoint; /* wall-clock time between checkpoints, s */
} ovr_output;

/* Quantity whose error `level = auto` limits. */
typedef enum ovr_accuracy {
    OVR_ACCURACY_H_CEN,
    OVR_ACCURACY_H_MIN,
    OVR_ACCURACY_FEATURES, /* effect of the features on the film thickness */
    OVR_ACCURACY_ALL /* central and minimum film thickness and friction; in
                        transient runs root mean squares over time */
} ovr_accuracy;

/* Change of the lubricant layers between two passes; thicknesses in b^2/R. */
typedef struct ovr_passes_setup {
    int number;       /* 1: a single run */
    double split;     /* share of the thickness that stays on surface 1 */
    double loss;      /* share that is lost between passes */
    double side_flow; /* exponent of the side flow law; NAN: no side flow */
    double replenish; /* lubricant supplied to each surface between passes */
    int again; /* surfaces that pass again, as bits (1, 2, 3: both); the other
                  surface is that of another body in each pass */
    double spacing; /* distance between two rolling bodies, b; NAN: not given */
    double recovery; /* time constant of the replenishment towards the flooded
                        layer, b/u_m; NAN: no replenishment */
    ovr_list loads;  /* load of each pass relative to the reference load; empty:
                        all 1 */
} ovr_passes_setup;

struct ovr_resolved;

/* A resolved case. */
typedef struct ovr_setup {
    const ovr_contact *contact;
    const ovr_lubricant *lubricant;
    ovr_options *options;
    ovr_history *load, *speed; /* NULL: constant */
    ovr_history *sliding;      /* NULL: determined by slide_to_roll and speed */
    ovr_history *radius;       /* NULL: constant */
    ovr_history *radius_1;     /* NULL: unknown */
    bool convected;   /* the curvature is convected; set by ovr_setup_prepare */
    bool transient;   /* time.end is set */
    ovr_march *march; /* without observer */
    const ovr_passes_setup *passes;
    const ovr_output *output;
    size_t features;
    const ovr_feature_form *const *feature;
    size_t nodes; /* nodes, mesh and surfaces are set by ovr_setup_prepare */
    double mesh;  /* D */
    ovr_surfaces *surfaces; /* NULL: smooth */
    double Rq; /* composite roughness of contact.Rq_1 and Rq_2, b^2/R; NAN:
                  neither is set */
    double bearable; /* contact.bearable_pressure, Pa */
    ovr_accuracy accuracy_of;
    double accuracy; /* requested accuracy. ovr_setup_prepare then chooses
                        options->level, which is 0 or below before; 0: the level
                        is set in the case */
    bool confirm;    /* level = auto: the error of the chosen level is estimated
                        after the run */
    double expected; /* expected relative error of accuracy_of on this grid,
                        before the run; set by ovr_setup_prepare */
    struct ovr_resolved *resolved; /* internal */
} ovr_setup;

/* A contact position of interest: points A to E of a gear, nose, joints and
 * reversals of a cam, each loaded roller of a bearing. */
typedef struct ovr_station {
    char name[24];
    double T; /* time from the start in b/u_m; NAN for bearings */
    ovr_element_moment moment; /* state of the contact; time t is relative to
                                  the start of the run */
    double pressure;           /* maximum Hertzian pressure, Pa */
    double half_width;         /* m */
    double central, minimum;   /* film thickness by the fitted formula, m; NAN:
                                  outside its range */
    double flash;              /* flash temperature by Blok's formula with
                                  OVR_STATION_FRICTION, K */
} ovr_station;
#define OVR_STATION_FRICTION 0.05
enum { OVR_STATIONS_MAX = 64 };

/* Writes the contact positions in the order of time (rollers: by their angle
 * from the load), at most OVR_STATIONS_MAX, and returns their number. Without
 * a machine element it returns 0. */
OVR_API size_t ovr_setup_stations(const ovr_setup *setup,
                                  ovr_station station[OVR_STATIONS_MAX]);

/* Resolves a case. Errors (OVR_BAD_INPUT) name file, line and key. No memory
 * of the size of the grid is allocated. */
OVR_API ovr_setup *ovr_case_resolve(const ovr_case *c,
                                    const ovr_allocator *allocator,
                                    ovr_error *err);
OVR_API void ovr_setup_free(ovr_setup *setup);

/* Resolves automatic options, compares the required memory with that of the
 * machine and reads the files of features. Errors are OVR_BAD_INPUT. No memory
 * of the size of the grid is allocated. */
OVR_API ovr_status ovr_setup_prepare(ovr_setup *setup,
                                     const ovr_allocator *allocator,
                                     ovr_error *err);

/* Reports the numbers of each physical model of the case, one line per
 * number. */
typedef void ovr_setup_line(void *data, const char *name, const char *text);
OVR_API void ovr_setup_describe(const ovr_setup *setup, ovr_setup_line *line,
                                void *data);

/* Creates the simulation with surfaces and histories, which the setup owns:
 * setup and case must outlive the simulation. Calls ovr_setup_prepare if
 * necessary. */
OVR_API ovr_simulation *ovr_setup_simulation(ovr_setup *setup,
                                             const ovr_allocator *allocator,
                                             ovr_error *err);

/* Returns the minimum depth of the stress histories of a prepared setup, or
 * NAN without [stress]. It is an error if the time steps do not resolve the
 * depths. */
OVR_API ovr_status ovr_setup_stress_depth(const ovr_setup *setup,
                                          double *minimum, ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
