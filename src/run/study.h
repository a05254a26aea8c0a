/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A study: a base case and values of its keys, one case for each combination;
 * described in overroll-study(5).
 *
 *     [study]
 *     case = dent.ini
 *     [set]
 *     domain.level = 7
 *     [product]
 *     feature.dent.depth = linear 0.05 to 0.2 in 4
 *     contact.slide_to_roll = -0.5, 0, 0.5
 *     [zip loads]
 *     contact.M = 10, 20, 50
 *     contact.L = 5, 7, 9
 *     [random]
 *     draws = 200
 *     contact.load = normal 300 kN/m sd 10 %
 *     [limits]
 *     min_film_m >= 0.2 um
 *
 * Cases ("tasks") are counted from 1 in messages and on the command line,
 * from 0 in the code.  The last key of the file changes fastest.
 */
#ifndef OVR_RUN_STUDY_H
#define OVR_RUN_STUDY_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/entries.h"
#include "mathematics/draws.h"
#include "overroll/questions.h"
#include "run/comparison.h"

enum {
    OVR_STUDY_VALUE = 256, /* capacity for a value as text */
    OVR_STUDY_NAME = 160,  /* capacity for the name of a case */
    OVR_STUDY_MAX_KEYS = 64,
    OVR_STUDY_MAX_TASKS = 1000000,
    OVR_STUDY_MAX_LIMITS = 16
};

/* Values at equal distances or equal ratios. */
typedef struct ovr_study_range {
    double from, to;
    char unit[24]; /* " um", or "" */
    size_t count;
    bool log;
} ovr_study_range;

/* Distribution of a key of [random]. */
typedef enum ovr_study_law {
    OVR_DRAW_NUMBER, /* a number from a distribution */
    OVR_DRAW_WHOLE,  /* one of `whole` integers from `from` on */
    OVR_DRAW_CELL    /* a cell of a table */
} ovr_study_law;

typedef struct ovr_study_draw {
    ovr_study_law law;
    ovr_distribution distribution;
    char unit[48]; /* " kN/m", or "" */
    double from, whole;
    char **cell;
    size_t cells, dimension; /* cells of a table; dimension of the design (not
                              * for integers) */
} ovr_study_draw;

/* One parameter: task i has value number (i / stride) % count, which is
 * value[...] or, with value = NULL, computed from `draw` or `range`. */
typedef struct ovr_study_key {
    const char *where; /* "feature.dent.depth" */
    const char *shown; /* short name for file names and tables */
    char **value;
    ovr_study_range range;
    ovr_study_draw draw; /* used if `random` */
    size_t count, stride;
    long line;            /* line number in the study */
    int zip;              /* keys with the same number change together; 0:
                           * changes alone */
    const char *zip_name; /* "" for a [zip] without a name */
    bool fixed;           /* from [set]: constant, in no name or table */
    bool random;          /* from [random]: values are samples */
    bool related;         /* sampled jointly with others from the rows of a
                           * file */
} ovr_study_key;

/* [find]: search that each case performs instead of a run. */
typedef struct ovr_study_find {
    ovr_find_options how; /* key NULL: no [find] */
    long line;
} ovr_study_find;

/* Setting of [random] as written, before sampling. */
typedef struct ovr_study_chance {
    const char *where, *text;
    const char *file; /* file of [random file FILE]; or NULL */
    long line;
} ovr_study_chance;

typedef struct ovr_study_chances {
    ovr_sampling how; /* draws 0: no random keys */
    bool shifts_given;
    long line;
    ovr_study_chance key[OVR_STUDY_MAX_KEYS];
    size_t keys;
    const char *dimension[OVR_STUDY_MAX_KEYS]; /* names of the design's
                                                * dimensions */
} ovr_study_chances;

struct ovr_study {
    ovr_arena arena;
    const char *path;
    const char *folder; /* folder of the study; "." for the working directory */
    const char *case_path; /* NULL: an empty case */
    const char *output;    /* folder of the results */
    bool results;          /* a result file for each case */
    ovr_study_key key[OVR_STUDY_MAX_KEYS];
    size_t keys, tasks;
    ovr_study_find find;
    ovr_study_chances random;
    ovr_comparison limit[OVR_STUDY_MAX_LIMITS];
    size_t limits;
    uint64_t signature; /* hash of the study, its base case and its files */
    uint64_t base;      /* hash of everything that the cases have in common */
};

/* True if the numbers of the cases are rows of tables (run/study_rows.h): of
 * searches and without result files. */
bool ovr_study_in_rows(const ovr_study *s);

/* Returns the value of a key in a task. A computed value is written to `text`
 * (OVR_STUDY_VALUE characters). */
const char *ovr_study_value(const ovr_study *s, const ovr_study_key *key,
                            size_t task, char *text);

/* Writes draw i of a key of [random], as ovr_study_value does. */
const char *ovr_study_draw_at(const ovr_study *s, const ovr_study_key *key,
                              size_t i, char *text);

/* Writes value i of a range, ends as given. */
void ovr_study_range_at(const ovr_study_range *range, size_t i, char *text);

/* Writes the path of a task's file in the results' folder: the name of the task
 * followed by `ending`. */
void ovr_study_file(const ovr_study *s, size_t task, const char *ending,
                    char *path, size_t capacity);

/* Returns a path of the study, which is relative to its folder. */
const char *ovr_study_path(ovr_study *s, const char *path, ovr_error *err);

/* Adds a key; fails if it was already given. */
ovr_study_key *ovr_study_new_key(ovr_study *s, const char *where, long line,
                                 ovr_error *err);

/* Allowed words, for the error message about an unknown one. */
typedef struct ovr_study_words {
    const char *in; /* " in [find]", or "" */
    const char *const *word;
    size_t count;
    const char *more; /* ", and others", or "" */
} ovr_study_words;
ovr_status ovr_study_unknown(const ovr_study *s, const ovr_study_words *words,
                             const char *given, long line, ovr_error *err);

/* Stores a setting or a key of [random] (`file`: FILE of [random file FILE], or
 * NULL).  After the last line the random keys are added as one zip. */
ovr_status ovr_study_take_random(ovr_study *s, const ovr_entry *entry,
                                 const char *file, ovr_error *err);
ovr_status ovr_study_add_random(ovr_study *s, int zip, ovr_error *err);

/* Steps of reading a study: choose short names of keys; set every value of a
 * list and the first draw in the base case, which reports errors early. */
ovr_status ovr_study_name_keys(ovr_study *s, ovr_error *err);
ovr_status ovr_study_try_values(const ovr_study *s, ovr_error *err);
ovr_status ovr_study_try_find(const ovr_study *s, ovr_error *err);

/* Checks the draws of the tasks first..last in the same way. */
ovr_status ovr_study_try_draws(const ovr_study *s, size_t first, size_t last,
                               ovr_error *err);

/* Sets a key of a case to its value in a task. */
ovr_status ovr_study_put(const ovr_study *s, const ovr_study_key *key,
                         size_t task, ovr_case *c, ovr_error *err);

/* Computes the hashes of a study that has been read. */
ovr_status ovr_study_hash(ovr_study *s, ovr_error *err);

/* Hash of the base case and the values of a task. */
uint64_t ovr_study_identity(const ovr_study *s, size_t task);

/* Returns the case of a task as text. Tasks with equal texts are equal. */
char *ovr_study_text(const ovr_study *s, ovr_case *c, ovr_arena *arena,
                     ovr_error *err);

/* Expands "1, 2, 5", "a, b | c, d", "1..8", "linear 1 to 5 in 3" or "log 0.1 um
 * to 10 um in 5" to a list of values. */
ovr_status ovr_study_values(const char *text, ovr_arena *arena, char ***values,
                            size_t *count, ovr_error *err);

#endif
