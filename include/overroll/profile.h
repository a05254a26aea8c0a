/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Profiles: measured surfaces read from files, conditioned, and synthetic
 * roughness.
 *
 * A profile is n points (x, z), x increasing, heights positive out of the
 * surface; missing heights are NAN until ovr_profile_condition fills them.
 * Both are in metres, or in units of the contact (b and b^2/R) if the file
 * specifies them.  Formats (overroll-profile(5)) are recognized by content.
 * Assumptions of the reader are listed in `notes`.  Missing information, such
 * as a unit, is an error whose message names what to add.
 */
#ifndef OVERROLL_PROFILE_H
#define OVERROLL_PROFILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "overroll/error.h"
#include "overroll/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ovr_profile ovr_profile;

/* Current state of a profile, owned by it and valid until it is conditioned. */
typedef struct ovr_profile_view {
    size_t n;
    const double *x, *z; /* x increasing; z NAN where missing */
    bool scaled_x;       /* x in b, otherwise in metres */
    bool scaled_z;       /* z in b^2/R, otherwise in metres */
    const char *format;  /* "text", "SDF (binary)", ... */
    const char *notes;   /* assumptions and conditioning steps, lines that end
                            with '\n' */
    size_t missing;      /* points without a height in the file */
    size_t filled;       /* points that were interpolated */
    bool uniform;        /* equal distances within 1 % */
    double lambda_c; /* cut-off of the applied high-pass filter; NAN: none */
    size_t rows, columns; /* size of the areal grid of which it is a line; 0:
                             the file holds lines only */
    double line[4];       /* x, y of that line's first and last point on the
                             grid, in the unit of x */
} ovr_profile_view;

/* The file and information that it may lack. */
typedef struct ovr_profile_source {
    const char *file;
    const char *unit_x; /* "um", "mm", ..., "b"; NULL: specified in the file */
    const char
        *unit_z;    /* "um", "nm", ..., "b^2/R"; NULL: specified in the file */
    double spacing; /* distance between points of a single column z, metres;
                       NAN: none */
    double spacing_across; /* between the rows of a map without spacings,
                              metres; NAN: spacing */
    bool spacing_scaled;   /* both spacings are in b, not metres */
    int column_x;          /* counted from 1; 0: by the header */
    int column_z;
    /* The line of an areal file: at most one of the first four; default: the
     * middle line across the lay, or the middle row if there is no lay. */
    int row, column;  /* from 1; 0: not given */
    double y;         /* the row nearest to this y; metres, from the first row;
                         NAN: not given */
    double direction; /* angle to the x axis of a line through the centre,
                         degrees; NAN: not given */
    double band;      /* width of the band over which heights are averaged,
                         metres; NAN: a single line */
    bool options; /* messages name options of the program (--unit-x) in place
                     of keys of a case (unit_x) */
} ovr_profile_source;

OVR_API ovr_profile_source ovr_profile_source_default(void);

/* Reads source->file. */
OVR_API ovr_profile *ovr_profile_read(const ovr_profile_source *source,
                                      const ovr_allocator *allocator,
                                      ovr_error *err);
/* Releases a profile; NULL is allowed. */
OVR_API void ovr_profile_free(ovr_profile *profile);
OVR_API const ovr_profile_view *
ovr_profile_get_view(const ovr_profile *profile);

/* Writes a profile in metres as X3P or SDF (binary, f64) if the path ends in
 * .x3p or .sdf. Otherwise writes text: two columns "x in m, z in m" (or in b,
 * b^2/R) of 17 digits, which read back to the same numbers. */
OVR_API ovr_status ovr_profile_save(const ovr_profile *profile,
                                    const char *path, ovr_error *err);

typedef enum ovr_levelling {
    OVR_LEVEL_NONE,
    OVR_LEVEL_MEAN,
    OVR_LEVEL_LINE,
    OVR_LEVEL_POLYNOMIAL,
    OVR_LEVEL_ENDS,   /* line through the mean heights of the outer tenths */
    OVR_LEVEL_CIRCLE, /* arc of a roller, of least squares in height */
    OVR_LEVEL_AUTO /* line, circle, or polynomial of degree 4 or 6: the next one
                      if it leaves less than half the Rq; the choice is in the
                      notes */
} ovr_levelling;

/* Extension of a profile beyond its ends. */
typedef enum ovr_extension {
    OVR_EXTEND_NONE,     /* smooth surface, blended over `taper` */
    OVR_EXTEND_PERIODIC, /* periodic, blended over `taper` */
    OVR_EXTEND_MIRROR    /* alternately mirrored */
} ovr_extension;

/* Conditioning steps, in this order: window, scale and invert, gaps, outliers,
 * level, lambda_c, lambda_s, offset, anti-aliasing, taper. Lengths are in the
 * x unit of the profile, heights in its z unit; NAN: omitted. */
typedef struct ovr_conditioning {
    double from, to;     /* window in x */
    double scale;        /* factor on heights; default 1 */
    bool invert;         /* change the sign of heights */
    double stretch;      /* factor on lengths; default 1 */
    bool reverse;        /* x runs the other way */
    double max_gap;      /* longest gap to fill; NAN: 5 % of the length */
    double max_missing;  /* largest missing fraction; default 0.2 */
    double outliers;     /* points further than this many robust standard
                            deviations from the median of their
                            neighbours are replaced */
    ovr_levelling level; /* by default a line */
    int degree;          /* degree of the fitted polynomial; default 2 */
    double lambda_c;     /* high-pass Gaussian cut-off (waviness removed) */
    double lambda_s;     /* low-pass Gaussian cut-off (noise removed) */
    double offset;       /* added after levelling */
    double taper; /* length of the blend into the smooth surface at each end;
                     NAN: 5 % of the length */
    ovr_extension extend; /* by default none */
    /* For areal surfaces only. */
    bool turn; /* exchange rows and columns, so that y is along rolling */
    double from_across, to_across; /* window in y */
    double taper_across;           /* NAN: 5 % of the width */
    ovr_extension extend_across;   /* periodic */
} ovr_conditioning;

OVR_API ovr_conditioning ovr_conditioning_default(void);

/* Conditions a profile, except for anti-aliasing, taper and extension, which
 * require a grid. The steps are listed in the notes. */
OVR_API ovr_status ovr_profile_condition(ovr_profile *profile,
                                         const ovr_conditioning *how,
                                         ovr_error *err);

/* ------------------------------------------------------------ statistics */

/*
 * Parameters of ISO 21920-2, equal to those of ISO 4287. P-parameters: of the
 * levelled profile, over its whole length. R-parameters: of the profile after
 * the high-pass filter lambda_c, over the middle five section lengths of
 * lambda_c each (fewer in a shorter profile). Heights are relative to their
 * mean, in the profile's z unit; each point is weighted by the length between
 * the midpoints to its neighbours, in the x unit. A profile with gaps has no
 * parameters.
 */
typedef struct ovr_profile_numbers {
    size_t n;
    double length, spacing, spacing_min, spacing_max;
    char kind;      /* 'P' or 'R': a is Pa or Ra, and so on */
    int sections;   /* number of section lengths: P 1, R up to 5 */
    double section; /* section length */
    double mean;
    double a, q;      /* mean of |z|, root mean square of z */
    double p, v;      /* peak height and valley depth (positive), means over the
                         sections */
    double z;         /* maximum height, mean over the sections: p + v */
    double t;         /* total height over all sections */
    double sk, ku;    /* skewness, kurtosis (3: Gaussian); NAN when q = 0 */
    double dq;        /* root mean square slope */
    double k, pk, vk; /* core height, reduced peak height and reduced valley
                         depth of the material ratio curve */
    double mr1, mr2;  /* material ratios at the upper and lower limit of the
                         core, 0 to 1 */
} ovr_profile_numbers;

OVR_API ovr_status ovr_profile_measure(const ovr_profile *profile,
                                       ovr_profile_numbers *numbers,
                                       ovr_error *err);

/* Returns the largest cut-off lambda_c of ISO 21920-3 (0.08, 0.25, 0.8, 2.5, 8
 * mm) of which five fit into `length` in metres, or NAN if the trace is too
 * short. */
OVR_API double ovr_profile_cutoff(double length);

/* A wave in the spectrum of the Hann-windowed profile. */
typedef struct ovr_profile_wave {
    double wavelength; /* in the x unit */
    double amplitude;  /* amplitude of the equivalent cosine */
    double part;       /* share of the variance */
} ovr_profile_wave;

/* Finds up to `maximum` waves above 0.1 % of the variance, strongest first;
 * *found is their number. */
OVR_API ovr_status ovr_profile_waves(const ovr_profile *profile, size_t maximum,
                                     ovr_profile_wave *waves, size_t *found,
                                     ovr_error *err);

/* Returns the amplitude of a wave in the film divided by its undeformed
 * amplitude, in pure rolling; the wavelength is in b
 * (src/surface/local_roughness.c). 0 for L = 0. */
OVR_API double ovr_wave_reduction(double M, double L, double wavelength);

/* Dry elastic contact of a profile with a smooth surface, in plane strain:
 * mean pressure divided by E* = E'/2 (profile in b and b^2/R: in p_h), mean
 * gap, and share of the length in contact. */
typedef struct ovr_dry_point {
    double pressure, gap, area;
} ovr_dry_point;

/* Computes up to `maximum` points, the smallest pressure first; *found is their
 * number. */
OVR_API ovr_status ovr_profile_contact(const ovr_profile *profile,
                                       size_t maximum, ovr_dry_point *points,
                                       size_t *found, ovr_error *err);

/* Parses a length such as "12 um", "0.3 b" or "5". `scaled` is the
 * dimensionless unit, "b" or "b^2/R". The caller adds the name of the length
 * to the message. */
typedef struct ovr_length {
    enum { OVR_LENGTH_BARE, OVR_LENGTH_METRES, OVR_LENGTH_SCALED } unit;
    double value;
} ovr_length;
OVR_API ovr_status ovr_length_read(const char *text, const char *scaled,
                                   ovr_length *length, ovr_error *err);

/* Format a length in metres, and a length or height of the profile with its
 * unit: "80 um", "0.3 b". */
typedef struct ovr_piece {
    char text[40];
} ovr_piece;
OVR_API ovr_piece ovr_metres(double metres);
OVR_API ovr_piece ovr_along(const ovr_profile *profile, double x);
OVR_API ovr_piece ovr_across(const ovr_profile *profile, double z);

/* ------------------------------------------------------ random roughness */

typedef enum ovr_spectrum { OVR_SELF_AFFINE, OVR_EXPONENTIAL } ovr_spectrum;

/*
 * Random roughness with power spectrum C(q), q = 2 pi/wavelength:
 *   self-affine  C ~ 1 for q < 2 pi/rolloff, (q rolloff/2 pi)^(-1 - 2 hurst)
 *                beyond, up to 2 pi/shortest
 *   exponential  autocorrelation exp(-|s|/correlation)
 * and heights of the given skewness and kurtosis.
 */
typedef struct ovr_roughness {
    double Rq;     /* root mean square height */
    double length; /* period of a realization */
    ovr_spectrum spectrum;
    double hurst;    /* 0.8 */
    double rolloff;  /* roll-off wavelength; NAN: length/8 */
    double shortest; /* shortest wavelength; NAN: length/256 */
    double
        correlation; /* correlation length of OVR_EXPONENTIAL; NAN: length/32 */
    double skewness; /* NAN: 0 */
    double kurtosis; /* NAN: 3 + 1.5 skewness^2; both NAN: Gaussian */
    int seed;        /* 1 */
    double peklenik; /* strips: correlation length along rolling divided by that
                        across; default 1 */
} ovr_roughness;

#ifdef __cplusplus
}
#endif

#endif
