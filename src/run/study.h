/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A study: a base case and the values to put into it, one case for each
 * combination; described in overroll-study(5).
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
    OVR_STUDY_MAX_KEYS = 64,
    OVR_STUDY_MAX_TASKS = 1000000,
    OVR_STUDY_MAX_LIMITS = 16
};

/* One parameter: the value in task i is value[(i / stride) % count]. */
typedef struct ovr_study_key {
    const char *where; /* "feature.dent.depth" */
    const char *shown; /* what it is called in names and tables */
    char **value;
    size_t count, stride;
    long line;            /* in the study */
    int zip;              /* keys of one number change together; 0: alone */
    const char *zip_name; /* "" for a [zip] without one */
    bool fixed;           /* of [set]: in no name and no table */
    bool random;          /* of [random]: values are draws */
    bool related;         /* drawn together with others, from rows of a file */
} ovr_study_key;

/* [find]: what each case is to find, in place of a run. */
typedef struct ovr_study_find {
    ovr_find_options how; /* key NULL: there is none */
    long line;
} ovr_study_find;

/* [random]: a key as it is written, before it is drawn. */
typedef struct ovr_study_chance {
    const char *where, *text;
    const char *file; /* of [random file FILE]; or NULL */
    long line;
} ovr_study_chance;

typedef struct ovr_study_chances {
    ovr_sampling how; /* draws 0: nothing is random */
    bool grows;       /* shifts were given or are used */
    long line;
    ovr_study_chance key[OVR_STUDY_MAX_KEYS];
    size_t keys;
} ovr_study_chances;

struct ovr_study {
    ovr_arena arena;
    const char *path;
    const char *folder;    /* of the study; "." for the working directory */
    const char *case_path; /* NULL: an empty case */
    const char *output;    /* folder of the results */
    bool results;          /* a result file for each case */
    ovr_study_key key[OVR_STUDY_MAX_KEYS];
    size_t keys, tasks;
    ovr_study_find find;
    ovr_study_chances random;
    ovr_comparison limit[OVR_STUDY_MAX_LIMITS];
    size_t limits;
    char **name; /* of each task: "depth=0.1_slide_to_roll=0.5" */
};

const char *ovr_study_value(const ovr_study *s, const ovr_study_key *key,
                            size_t task);

/* A path in the folder of the results: NAME of the task, then `ending`. */
void ovr_study_file(const ovr_study *s, size_t task, const char *ending,
                    char *path, size_t capacity);

/* A path in the study, which starts at its folder. */
const char *ovr_study_path(ovr_study *s, const char *path, ovr_error *err);

/* A key that is given for the first time. */
ovr_study_key *ovr_study_new_key(ovr_study *s, const char *where, long line,
                                 ovr_error *err);

/* The words of a section, or the sections. */
typedef struct ovr_study_words {
    const char *in; /* " in [find]", or "" */
    const char *const *word;
    size_t count;
    const char *more; /* ", and others", or "" */
} ovr_study_words;
ovr_status ovr_study_unknown(const ovr_study *s, const ovr_study_words *words,
                             const char *given, long line, ovr_error *err);

/* A setting or a key of [random], and after all lines the values of its keys,
 * as one zip behind all others; `file`: of [random file FILE], or NULL. */
ovr_status ovr_study_take_random(ovr_study *s, const ovr_entry *entry,
                                 const char *file, ovr_error *err);
ovr_status ovr_study_draw_all(ovr_study *s, int zip, ovr_error *err);

/* Steps of reading: names of all tasks; every value once into the base
 * case, so that what is wrong is known before anything runs. */
ovr_status ovr_study_name_tasks(ovr_study *s, ovr_error *err);
ovr_status ovr_study_try_values(const ovr_study *s, ovr_error *err);
ovr_status ovr_study_try_find(const ovr_study *s, ovr_error *err);

/* The work of a task, as text: two that say the same are the same. */
char *ovr_study_text(const ovr_study *s, ovr_case *c, ovr_arena *arena,
                     ovr_error *err);

/* "1, 2, 5", "a, b | c, d", "1..8", "linear 1 to 5 in 3", "log 0.1 um to
 * 10 um in 5": the values one by one. */
ovr_status ovr_study_values(const char *text, ovr_arena *arena, char ***values,
                            size_t *count, ovr_error *err);

#endif
