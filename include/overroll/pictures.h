/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pictures of result files, drawn by gnuplot, which runs as a child process
 * for as long as a picture, or all frames of a run, take.
 *
 *     ovr_picture_options o = ovr_picture_options_default();
 *     o.path = "dent.png";
 *     ovr_picture(&result, 1, &o, NULL, &err);
 */
#ifndef OVERROLL_PICTURES_H
#define OVERROLL_PICTURES_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/areal.h"
#include "overroll/error.h"
#include "overroll/memory.h"
#include "overroll/profile.h"
#include "overroll/results.h"
#include "overroll/run.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum ovr_picture_kind {
    OVR_PICTURE_SNAPSHOT, /* pressure, film thickness and surface height at some
                             times */
    OVR_PICTURE_HISTORY,  /* film and pressure against time */
    OVR_PICTURE_MAP,      /* colour over x and time */
    OVR_PICTURE_TRACE,    /* film thickness and surface height at x = 0 against
                             time */
    OVR_PICTURE_STRESS,   /* pressure, film thickness and stresses below the
                             surface at one time */
    OVR_PICTURE_RISK, /* shear path radius and fatigue risk against position and
                         depth */
    OVR_PICTURE_DEPTH, /* shear path radius and equivalent length against depth
                        */
    OVR_PICTURE_ELEMENT, /* gear pair, cam or bearing of the case, with its
                            load, radius and speeds */
    OVR_PICTURE_PLASTIC, /* plastic deformation: profile, plastic strain,
                            residual stress */
    OVR_PICTURE_AREAL    /* maps of a strip at one time, with cuts */
} ovr_picture_kind;

/* Lengths are in b, pressures in p_h, heights in b^2/R, times in b/u_m,
 * independent of the drawn units. NAN or 0: chosen from the data. */
typedef struct ovr_picture_options {
    ovr_picture_kind kind;
    const char *path; /* the suffix selects the format: .png, .svg or .pdf */
    bool force;       /* replace an existing file */
    ovr_units units;  /* units of the axes; default: as stored */
    double x_from, x_to;
    double P_to, H_to; /* upper ends of the axes */
    double T_from, T_to;
    size_t time_count; /* snapshot: number of times; 0: chosen automatically */
    const double *times;
    bool overlay;  /* snapshot: all times in one panel */
    bool no_hertz; /* without the Hertzian pressure */
    bool no_roughness;
    const char *field; /* map: any; "film_thickness" (NULL); stress:
                          "max_shear" (NULL) or another stress */
    int surface;       /* stress, risk, depth: 1 (0) or 2 */
    bool log_depth;    /* stress: depth logarithmic, from D */
    double along;      /* areal: X of the cut across; NAN: 0 */
    int width,
        height; /* pixels; 0: 1280 and the height of the kind of picture */
    const char *title; /* NULL: title of the file; "": none */
    const char *const
        *names; /* names of the results in the legend; NULL: their titles */
    const char *script; /* gnuplot script to write (.gp), with its data in the
                           same folder (.dat), or NULL */
    const char
        *template_path; /* gnuplot program as described in overroll-pictures(7);
                           NULL: the built-in one */
} ovr_picture_options;
OVR_API ovr_picture_options ovr_picture_options_default(void);

/* Draws one picture of `count` results, which are superimposed; maps need one
 * result. On errors no file is written. */
OVR_API ovr_status ovr_picture(ovr_result *const *results, size_t count,
                               const ovr_picture_options *options,
                               const ovr_allocator *allocator, ovr_error *err);

/* Draws the gear pair, cam or bearing of a case before its run; `kind` is
 * ignored. */
OVR_API ovr_status ovr_picture_element(const ovr_setup *setup,
                                       const ovr_picture_options *options,
                                       const ovr_allocator *allocator,
                                       ovr_error *err);

/* ---------------------------------------------------------------- studies */

/* A quantity of the cases of a study against a key, with one line per value of
 * a second key and one panel per value of the other keys. For several seeds
 * the mean is drawn with a band from minimum to maximum. Against a seed a
 * histogram with quantiles is drawn. A key may be the name of a [zip]. */
typedef struct ovr_figure_options {
    const char *path; /* .png, .svg or .pdf */
    bool force;
    const char *y; /* column; NULL: the first of H_min_overall_m, H_min_overall,
                      min_film_located_m and H_min_located */
    const char *x; /* key; NULL: the first numeric key */
    const char *by; /* key; NULL: the next key that is not a seed; "": none */
    bool log_x, log_y; /* logarithmic axes */
    int width, height;
    const char *title;
    const char *script;
    const char *template_path; /* as in ovr_picture_options */
    bool linear; /* x is logarithmic only if log_x is set; otherwise also if its
                    values form a geometric series over a decade or more */
    const char
        *panels; /* key; NULL: all other keys except for seeds; "": none */
} ovr_figure_options;

OVR_API ovr_status ovr_figure(const ovr_table *table,
                              const ovr_figure_options *options,
                              const ovr_allocator *allocator, ovr_error *err);

/* Draws film thickness and inlet meniscus position, or rim heights, against
 * the pass number; y, x, by and the logarithms are ignored. */
OVR_API ovr_status ovr_figure_passes(const ovr_table *passes,
                                     const ovr_figure_options *options,
                                     const ovr_allocator *allocator,
                                     ovr_error *err);

/* Draws the Stribeck curve of a study with [boundary]: friction coefficient,
 * fluid friction and asperity load share as functions of contact.mean_speed (or
 * x). There is one line per value of `by` or of the next key; y and panels are
 * ignored. */
OVR_API ovr_status ovr_figure_stribeck(const ovr_table *table,
                                       const ovr_figure_options *options,
                                       const ovr_allocator *allocator,
                                       ovr_error *err);

/* Draws the distribution of `y` (default: first quantity of ovr_study_sample)
 * over a study with [random]: histogram, cumulative distribution and effect of
 * each input; x, by, panels and the logarithms are ignored. */
OVR_API ovr_status ovr_figure_distribution(const ovr_study *study,
                                           const ovr_figure_options *options,
                                           const ovr_allocator *allocator,
                                           ovr_error *err);

/* ------------------------------------------------------ frames and movies */

typedef struct ovr_frames_options {
    const ovr_picture_options
        *look; /* options of each frame, or NULL; path and times are ignored;
                  kinds other than OVR_PICTURE_STRESS and OVR_PICTURE_AREAL are
                  drawn as snapshots */
    const char *folder; /* folder of the frames; NULL: only the movie */
    const char *form;   /* "png" (NULL), "svg", "pdf" */
    size_t every;       /* interval of snapshots; 0: all snapshots */
    int workers;        /* number of gnuplot processes; 0: one per core */
    bool scripts;       /* script and data of each frame are written */
    const char *movie;  /* NAME.mp4, .webm, .gif or .webp; NULL: none */
    double rate;        /* frames per second of the movie; 0: 25 */
    /* Called after each frame; false stops with OVR_STOPPED. May be NULL. */
    bool (*progress)(void *data, size_t done, size_t count);
    void *data;
} ovr_frames_options;

typedef struct ovr_frames_made {
    size_t drawn, kept; /* kept: from an earlier call */
} ovr_frames_made;

/*
 * Draws a picture of each snapshot: FOLDER/frame_0000.png and so on, with the
 * number of the snapshot. All pictures have the same axes. Several results are
 * drawn in the same picture, at the times of the first result.
 *
 * A second call with the same options draws the missing frames:
 * FOLDER/frames.txt stores the options of the frames. Frames made with other
 * options are an error; with look->force they are replaced.
 */
OVR_API ovr_status ovr_frames(ovr_result *const *results, size_t count,
                              const ovr_frames_options *options,
                              const ovr_allocator *allocator,
                              ovr_frames_made *made, ovr_error *err);

/* -------------------------------------------------------------------- page */

typedef struct ovr_view_options {
    const char *path;         /* PAGE.html */
    bool force;               /* replace an existing file */
    const char *title;        /* NULL: title of the first file */
    const char *const *names; /* names of the results; NULL: their titles */
    const char *stress; /* stresses below the surface: "max_shear", ...; NULL:
                           max_shear for cases with [stress] */
} ovr_view_options;

/* Writes a self-contained HTML page that plays one run, or two side by side. */
OVR_API ovr_status ovr_view(ovr_result *const *results, size_t count,
                            const ovr_view_options *options,
                            const ovr_allocator *allocator, ovr_error *err);

/* Draws a profile; `path` as in ovr_picture_options. An existing file is
 * replaced. */
OVR_API ovr_status ovr_picture_profile(const ovr_profile_view *view,
                                       const char *title, const char *path,
                                       ovr_error *err);

/* Draws an areal surface and, below, a profile taken from it. */
OVR_API ovr_status ovr_picture_areal(const ovr_areal *areal,
                                     const ovr_profile_view *view,
                                     const char *title, const char *path,
                                     ovr_error *err);

/* Draws the dry contact (ovr_profile_contact): pressure against mean gap, with
 * the exponential of Rq and slope, and contact length against pressure. */
OVR_API ovr_status ovr_picture_contact(const ovr_profile_view *view,
                                       const ovr_profile_numbers *numbers,
                                       const ovr_dry_point *points,
                                       size_t count, const char *title,
                                       const char *path, ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
