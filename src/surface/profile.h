/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Internal structure of a profile, and its file readers. Each reader receives
 * the complete content of a file, whose size is limited, and checks all counts
 * in it.
 */
#ifndef OVR_SURFACE_PROFILE_H
#define OVR_SURFACE_PROFILE_H

#include "base/text.h"
#include "overroll/areal.h"
#include "overroll/profile.h"

enum {
    OVR_POINTS_MAX = 1 << 24,  /* points of a profile */
    OVR_CONTENT_MAX = 1 << 28, /* bytes of an uncompressed file */
    OVR_NOTES_SIZE = 4096
};

struct ovr_profile {
    ovr_arena arena;
    ovr_profile_view view;
    double *x, *z; /* data of the view */
    const char *file;
    bool questioned;     /* the size of the profile has been checked */
    bool options;        /* messages name command-line options instead of
                          * keys */
    double b, height;    /* b and b^2/R in metres, for a profile in these units;
                          * 0: unknown */
    ovr_areal map;       /* areal map, while its file is read */
    ovr_arena map_arena; /* memory of map.z */
    double offset;       /* x of the first point of a row of the map */
    bool map_only;       /* the caller needs the map only, without a line */
    double work;         /* multiplications to make it, about */
    char notes[OVR_NOTES_SIZE];
};

typedef ovr_status ovr_reader(ovr_profile *profile,
                              const ovr_profile_source *source,
                              ovr_bytes content, ovr_error *err);
ovr_reader ovr_read_text, ovr_read_sdf, ovr_read_smd, ovr_read_x3p,
    ovr_read_sur, ovr_read_npy;

/* Creates an empty profile with space for n points. */
ovr_profile *ovr_profile_new(const char *file, const ovr_allocator *allocator,
                             ovr_error *err);
ovr_status ovr_profile_reserve(ovr_profile *profile, size_t n, ovr_error *err);

/* Adds a line to the notes; lines that do not fit are omitted. */
void ovr_profile_note(ovr_profile *profile, const char *format, ...)
    OVR_PRINTF(2, 3);

/* Returns the name of an option: "unit_x", or "--unit-x" on the command
 * line. */
ovr_piece ovr_named(const ovr_profile *profile, const char *key);

/* Sets the key that the failure `status` is about. */
static inline ovr_status ovr_about(ovr_error *err, const char *key,
                                   ovr_status status)
{
    if (err)
        err->about = key;
    return status;
}

/* Sets the number of points and derived values; the last step of every reader
 * and of conditioning. */
ovr_status ovr_profile_finish(ovr_profile *profile, size_t n, ovr_error *err);

/* Sets heights to NAN that are instrument codes for missing values (-9999,
 * 1e30, -32768 ...) if they are far from all other heights, and adds a note. */
void ovr_profile_drop_codes(ovr_profile *profile, double *z, size_t n);

/* Sets x_i = first + i spacing. */
void ovr_profile_regular(ovr_profile *profile, size_t n, double first,
                         double spacing);

/* The content of a file, decompressed if it is a gzip stream. */
ovr_status ovr_file_bytes(const char *file, ovr_arena *arena,
                          ovr_bytes *content, ovr_error *err);

/* Like ovr_profile_read, from memory; source->file is used in messages only. */
ovr_profile *ovr_profile_parse(const ovr_profile_source *source,
                               const void *data, size_t size,
                               const ovr_allocator *allocator, ovr_error *err);

/* Like ovr_profile_read. With `map_only`, only the map is read, and no line of
 * it is selected. */
ovr_profile *ovr_profile_read_file(const ovr_profile_source *source,
                                   bool map_only,
                                   const ovr_allocator *allocator,
                                   ovr_error *err);

ovr_profile *ovr_profile_create(size_t n, const double *x, const double *z,
                                bool scaled, const ovr_allocator *allocator,
                                ovr_error *err);

/* Creates one period of a random profile in b and b^2/R; the last point equals
 * the first. */
ovr_profile *ovr_profile_random(const ovr_roughness *form,
                                const ovr_allocator *allocator, ovr_error *err);

#endif
