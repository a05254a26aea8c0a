/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A case: the text that describes a run, read from a file and single
 * settings, and what it resolves to.
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

/* One parameter as people see it. */
typedef struct ovr_parameter_info {
    const char *section, *key;
    const char *type;    /* "number", "whole number", "choice", ... */
    const char *units;   /* allowed units, "" for none */
    const char *bare;    /* what a number without a unit is in: "b", "b^2/R",
                            "b/um"; "" when there is no such thing */
    const char *initial; /* default as in a case file, or NULL */
    double minimum, maximum; /* allowed, in SI or bare; NAN: not a number */
    bool above;              /* `minimum` itself is not allowed */
    const char *choices[24]; /* words allowed, ends with NULL */
    bool physics;            /* another value is another solution */
    const char *help;
    char when[240]; /* "history = ramp or step": what must be for it to have an
                       effect; "" where it always has one */
} ovr_parameter_info;

OVR_API size_t ovr_parameter_count(void);
OVR_API ovr_parameter_info ovr_parameter_at(size_t k);

/* Returns the "section.key" that a usual symbol or name of a quantity ("E",
 * "eta0", "SRR") stands for, or NULL if the symbol is unknown. */
OVR_API const char *ovr_parameter_by_symbol(const char *symbol);

/* Sections in order: name and a line of help, NULL behind the last; and
 * whether there may be several, each with a name of its own: [feature NAME]. */
OVR_API const char *ovr_section_name(size_t k);
OVR_API bool ovr_section_named(size_t k);
OVR_API const char *ovr_section_help(size_t k);

/* ------------------------------------------------------------- listeners */

typedef enum ovr_message_kind {
    OVR_MESSAGE_WARNING, /* the result may not be what was meant */
    OVR_MESSAGE_NOTE,    /* what was assumed or done beyond the ordinary */
    OVR_MESSAGE_FILE     /* of the file resumed; begins with its name */
} ovr_message_kind;

/* One line of text, without end of line. */
typedef void ovr_listener(void *data, ovr_message_kind kind, const char *text);

/* --------------------------------------------------------------- the case */

typedef struct ovr_case ovr_case;

/* A case in which nothing is given yet. */
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

/* One setting, `where` = "section.key" ("feature dent.depth" or
 * "feature.dent.depth"), through the same code as the file; the last one
 * counts.  Messages give `origin` in place of file and line. */
OVR_API ovr_status ovr_case_set(ovr_case *c, const char *where,
                                const char *value, const char *origin,
                                ovr_error *err);

/* The same from "section.key=value". */
OVR_API ovr_status ovr_case_assign(ovr_case *c, const char *assignment,
                                   const char *origin, ovr_error *err);

/* Resets a setting to its default; unknown settings are ignored. */
OVR_API void ovr_case_unset(ovr_case *c, const char *where);

/* The text of the case with later settings worked in; reading it in the same
 * directory gives this case again.  Owned by the case. */
OVR_API const char *ovr_case_text(ovr_case *c, ovr_error *err);

OVR_API const char *ovr_case_name(const ovr_case *c);
OVR_API const char *ovr_case_directory(const ovr_case *c);

/* Every parameter of every section present, in the order of the table. */
typedef struct ovr_case_entry {
    const char *section; /* "contact", "feature" */
    const char *name;    /* of a feature, else NULL */
    const char *key;
    const char *text; /* as given, else the default, else NULL */
    bool given;       /* by the file or a setting */
    const char *file; /* or origin; NULL when not given */
    long line;        /* 0: no line */
    double number;    /* SI, or bare; NAN: no number */
    const char *unit; /* SI unit of the number when it is physical */
    size_t parameter; /* its row in the table */
    bool applies;     /* has a meaning beside the others: not that of a
                         profile where there is none */
} ovr_case_entry;
OVR_API size_t ovr_case_entries(const ovr_case *c);
OVR_API ovr_case_entry ovr_case_entry_at(const ovr_case *c, size_t k);

/* ---------------------------------------------------- what it resolves to */

typedef struct ovr_list {
    size_t count;
    const double *values;
} ovr_list;

/* Selects the results that are stored; times are in b/u_m, lengths in b. */
typedef struct ovr_output {
    const char *file;    /* relative to the working directory; or NULL */
    const char *title;   /* or NULL */
    long every;          /* steps; 0: not by steps */
    double interval;     /* 0: not by time */
    ovr_list at;         /* given times */
    ovr_list feature_at; /* X at which features' centres are stored */
    unsigned fields;     /* bits in the order of the parameter's choices */
    bool single;         /* f32 */
    double from, to;     /* window in X; NAN: the whole domain */
    int stride;
    int compression;
    double checkpoint; /* s of wall-clock time */
} ovr_output;

/* The quantity whose error level = auto brings down. */
typedef enum ovr_accuracy {
    OVR_ACCURACY_H_CEN,
    OVR_ACCURACY_H_MIN,
    OVR_ACCURACY_FEATURES, /* of what the features do to the film */
    OVR_ACCURACY_ALL       /* of both films and of the friction; in a run the
                              root mean square over time */
} ovr_accuracy;

/* Layers of oil change between two passes by these rules; in b^2/R. */
typedef struct ovr_passes_setup {
    int number;       /* 1: the ordinary run */
    double split;     /* share of the thickness that is surface 1's */
    double loss;      /* share that is lost */
    double side_flow; /* exponent of its law; NAN: none */
    double replenish; /* oil supplied to each surface */
    int again;        /* surfaces that come back, as bits: 1, 2, 3 both; the
                         other is each time another body of its kind */
    double spacing;   /* between two rolling bodies, b; NAN: not given */
    double recovery;  /* b/um, in which a layer regains 1 - 1/e of what lacks
                         to that of a flooded contact; NAN: never */
    ovr_list loads;   /* of each pass over the nominal one; none: all 1 */
} ovr_passes_setup;

/* All that a case describes, ready to be run. */

struct ovr_resolved;
typedef struct ovr_setup {
    const ovr_contact *contact;
    const ovr_lubricant *lubricant;
    ovr_options *options;
    ovr_history *load, *speed; /* NULL: constant */
    ovr_history *sliding;      /* NULL: as slide_to_roll and speed say */
    ovr_history *radius;       /* NULL: constant */
    ovr_history *radius_1;     /* NULL: not known */
    bool convected;            /* the curvature, by ovr_setup_prepare */
    bool transient;            /* has an end of time */
    ovr_march *march;          /* without observer */
    const ovr_passes_setup *passes;
    const ovr_output *output;
    size_t features;
    const ovr_feature_form *const *feature;
    size_t nodes;           /* the three below by ovr_setup_prepare */
    double mesh;            /* D */
    ovr_surfaces *surfaces; /* NULL: smooth */
    double Rq;              /* composite roughness by contact.Rq_1 and Rq_2,
                               b^2/R; NAN: neither is given */
    double bearable;        /* pressure that the material bears, Pa */
    ovr_accuracy accuracy_of;
    double accuracy; /* asked for: options->level is 0 or below until it is
                        chosen by ovr_setup_prepare; 0: the level was given */
    bool confirm;    /* the errors of the level chosen are estimated after the
                        run: level = auto */
    double expected; /* relative error of accuracy_of on this mesh, as far as
                        it is known before anything is solved; by
                        ovr_setup_prepare */
    struct ovr_resolved *resolved; /* for the library alone */
} ovr_setup;

/* A moment of an element of a machine that check and people look at: A to E of
 * a gear, nose, joints and reversals of a cam, each roller that carries of a
 * bearing. */
typedef struct ovr_station {
    char name[24];
    double T;                  /* b/um from the beginning; NAN: of a bearing */
    ovr_element_moment moment; /* t: from the beginning of the run */
    double pressure;           /* Hertzian, Pa */
    double half_width;         /* m */
    double central, minimum;   /* film by the fit, m; NAN: beyond it */
    double flash;              /* K, after Blok with OVR_STATION_FRICTION */
} ovr_station;
#define OVR_STATION_FRICTION 0.05
enum { OVR_STATIONS_MAX = 64 };

/* Fills in the moments in the order of time (of rollers: from below the load
 * on), at most OVR_STATIONS_MAX; returns how many there are: 0 without an
 * element. */
OVR_API size_t ovr_setup_stations(const ovr_setup *setup,
                                  ovr_station station[OVR_STATIONS_MAX]);

/* Fails with OVR_BAD_INPUT naming file, line and key; nothing of the size of
 * the grid is allocated. */
OVR_API ovr_setup *ovr_case_resolve(const ovr_case *c,
                                    const ovr_allocator *allocator,
                                    ovr_error *err);
OVR_API void ovr_setup_free(ovr_setup *setup);

/* Resolves automatic options, compares the memory needed with what the
 * machine has, reads the features' files; fails with OVR_BAD_INPUT.  Still
 * nothing of the size of the grid is allocated. */
OVR_API ovr_status ovr_setup_prepare(ovr_setup *setup,
                                     const ovr_allocator *allocator,
                                     ovr_error *err);

/* The simulation with surfaces and histories in place, which the setup keeps:
 * setup and case must live as long.  Prepares what is not prepared. */

/* Reports the numbers of each physical model of the case, one line per
 * number. */
typedef void ovr_setup_line(void *data, const char *name, const char *text);
OVR_API void ovr_setup_describe(const ovr_setup *setup, ovr_setup_line *line,
                                void *data);

OVR_API ovr_simulation *ovr_setup_simulation(ovr_setup *setup,
                                             const ovr_allocator *allocator,
                                             ovr_error *err);

/* The least depth of the histories that a prepared setup asks for; refused
 * where its steps cannot give the depths.  NAN: it asks for none. */
OVR_API ovr_status ovr_setup_stress_depth(const ovr_setup *setup,
                                          double *minimum, ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
