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
    OVR_PICTURE_SNAPSHOT, /* pressure, film and roughness at instants */
    OVR_PICTURE_HISTORY,  /* film and pressure against time */
    OVR_PICTURE_MAP,      /* colour over x and time */
    OVR_PICTURE_TRACE,    /* film in the middle of the contact, with the
                           roughness that passes there, against time */
    OVR_PICTURE_STRESS,  /* pressure, film and the stresses below, at an instant
                          */
    OVR_PICTURE_RISK,    /* what the material went through, place by depth */
    OVR_PICTURE_DEPTH,   /* the same over depth: worst, smooth, length */
    OVR_PICTURE_ELEMENT, /* the gear pair, cam or bearing of its case, and what
                           its contact goes through */
    OVR_PICTURE_PLASTIC, /* what has yielded: profile, strain, stresses left */
    OVR_PICTURE_AREAL    /* maps of a strip at an instant, with cuts */
} ovr_picture_kind;

/* Lengths in b, pressures in ph, heights in b^2/R, times in b/um, whatever
 * the units drawn; NAN or 0: chosen from the data. */
typedef struct ovr_picture_options {
    ovr_picture_kind kind;
    const char *path; /* its suffix is the form: .png, .svg or .pdf */
    bool force;       /* replace an existing file */
    ovr_units units;  /* of the axes; as stored */
    double x_from, x_to;
    double P_to, H_to; /* upper ends of the axes */
    double T_from, T_to;
    size_t time_count; /* snapshot: instants; 0: a few are chosen */
    const double *times;
    bool overlay;  /* snapshot: all instants in one panel */
    bool no_hertz; /* without the Hertzian pressure */
    bool no_roughness;
    const char *field;        /* map: any; "film_thickness" (NULL); stress:
                                 "max_shear" (NULL) or another stress */
    int surface;              /* stress, risk, depth: 1 (0) or 2 */
    bool log_depth;           /* stress: depth logarithmic, from D */
    double along;             /* areal: X of the cut across; NAN: 0 */
    int width, height;        /* pixels; 0: 1280 by what the kind needs */
    const char *title;        /* NULL: the file's own; "": none */
    const char *const *names; /* of each result, for the legend; NULL: their
                                 titles */
    const char *script; /* also write PATH (suffix .gp) and its data beside it
                           (.dat); NULL: no */
    const char *template_path; /* gnuplot's program, as overroll-pictures(7) has
                             it; NULL: the one that is built in */
} ovr_picture_options;
OVR_API ovr_picture_options ovr_picture_options_default(void);

/* Draws one picture of `count` results (more than one: laid over each other;
 * a map takes one).  The file appears whole or not at all. */
OVR_API ovr_status ovr_picture(ovr_result *const *results, size_t count,
                               const ovr_picture_options *options,
                               const ovr_allocator *allocator, ovr_error *err);

/* The gear pair, cam or bearing of a case that need not have run; `kind` does
 * not count. */
OVR_API ovr_status ovr_picture_element(const ovr_setup *setup,
                                       const ovr_picture_options *options,
                                       const ovr_allocator *allocator,
                                       ovr_error *err);

/* ---------------------------------------------------------------- studies */

/* A quantity of a study's cases against one of its keys: a line for each value
 * of a second key, a panel for each of what else varies; over seeds the mean,
 * in a band from the smallest to the largest.  Against a seed: a histogram of
 * the quantity, with its quantiles.  A key may be the name of a [zip]. */
typedef struct ovr_figure_options {
    const char *path; /* .png, .svg or .pdf */
    bool force;
    const char *y;  /* column; NULL: H_min_overall_m, else H_min_overall,
                       min_film_m, H_min */
    const char *x;  /* key; NULL: the first with numbers */
    const char *by; /* key; NULL: the next that is not a seed; "": none */
    bool log_x, log_y;
    int width, height;
    const char *title;
    const char *script;
    const char *template_path; /* as of a picture */
    const char *panels; /* key; NULL: all that else varies, except for seeds;
                           "": none */
} ovr_figure_options;

OVR_API ovr_status ovr_figure(const ovr_table *table,
                              const ovr_figure_options *options,
                              const ovr_allocator *allocator, ovr_error *err);

/* Film and meniscus against the number of the pass, from the file of several
 * passes; y, x, by and the logarithms do not count. */
OVR_API ovr_status ovr_figure_passes(const ovr_table *passes,
                                     const ovr_figure_options *options,
                                     const ovr_allocator *allocator,
                                     ovr_error *err);

/* Stribeck curve of a study over contact.mean_speed (or x) whose case has
 * [boundary]: friction coefficient, fluid friction and asperity load share; a
 * line for each value of `by`, or of the next key; y and panels do not count.
 */
OVR_API ovr_status ovr_figure_stribeck(const ovr_table *table,
                                       const ovr_figure_options *options,
                                       const ovr_allocator *allocator,
                                       ovr_error *err);

/* Draws the distribution of `y` over a study with [random] (default: the first
 * quantity of ovr_study_sample): histogram, distribution, and the effect of
 * each input; x, by, panels and the logarithms do not count. */
OVR_API ovr_status ovr_figure_distribution(const ovr_study *study,
                                           const ovr_figure_options *options,
                                           const ovr_allocator *allocator,
                                           ovr_error *err);

/* ------------------------------------------------------ frames and movies */

typedef struct ovr_frames_options {
    const ovr_picture_options *look; /* of each; NULL: the defaults; path and
                                        times are not used; kind:
                                        OVR_PICTURE_STRESS, OVR_PICTURE_AREAL,
                                        else a snapshot */
    const char *folder; /* where the frames go; NULL: only the movie */
    const char *form;   /* "png" (NULL), "svg", "pdf" */
    size_t every;       /* every so many snapshots; 0: all */
    int workers;        /* gnuplots at once; 0: one a core */
    bool scripts;       /* write each one's script and data too */
    const char *movie;  /* NAME.mp4, .webm, .gif or .webp; NULL: none */
    double rate;        /* of the movie, frames a second; 0: 25 */
    /* Told after each frame; false stops with OVR_STOPPED.  May be NULL. */
    bool (*progress)(void *data, size_t done, size_t count);
    void *data;
} ovr_frames_options;

typedef struct ovr_frames_made {
    size_t drawn, kept; /* kept: were there from a run before */
} ovr_frames_made;

/*
 * A picture for each snapshot, FOLDER/frame_0000.png and so on, the number
 * being the snapshot's; the axes are the same in all of them.  Several
 * results are laid over each other, at the times of the first.
 *
 * A second call with the same options draws the missing frames:
 * FOLDER/frames.txt stores the options of the frames.  Frames made with
 * something else are an error, or with look->force replaced.
 */
OVR_API ovr_status ovr_frames(ovr_result *const *results, size_t count,
                              const ovr_frames_options *options,
                              const ovr_allocator *allocator,
                              ovr_frames_made *made, ovr_error *err);

/* -------------------------------------------------------------------- page */

typedef struct ovr_view_options {
    const char *path;         /* PAGE.html */
    bool force;               /* replace an existing file */
    const char *title;        /* NULL: the first file's own */
    const char *const *names; /* of each result; NULL: their titles */
    const char *stress; /* the stresses below the film: "max_shear", ...; NULL:
                           max_shear of runs whose case has [stress] */
} ovr_view_options;

/* One HTML page, with all it needs in it, that plays one run, or two side by
 * side. */
OVR_API ovr_status ovr_view(ovr_result *const *results, size_t count,
                            const ovr_view_options *options,
                            const ovr_allocator *allocator, ovr_error *err);

/* Draws a profile; `path` as above.  An existing file is replaced. */
OVR_API ovr_status ovr_picture_profile(const ovr_profile_view *view,
                                       const char *title, const char *path,
                                       ovr_error *err);

/* Draws an areal surface, with a profile that is a line of it below. */
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
