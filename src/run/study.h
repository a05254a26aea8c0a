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
 *
 * Cases ("tasks") are counted from 1 in messages and on the command line,
 * from 0 in the code.  The last key of the file changes fastest.
 */
#ifndef OVR_RUN_STUDY_H
#define OVR_RUN_STUDY_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "overroll/run.h"

enum { OVR_STUDY_MOST_KEYS = 64, OVR_STUDY_MOST_TASKS = 1000000 };

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
} ovr_study_key;

struct ovr_study {
    ovr_arena arena;
    const char *path;
    const char *folder;    /* of the study; "." for the working directory */
    const char *case_path; /* NULL: an empty case */
    const char *output;    /* folder of the results */
    bool results;          /* a result file for each case */
    ovr_study_key key[OVR_STUDY_MOST_KEYS];
    size_t keys, tasks;
    char **name; /* of each task: "depth=0.1_slide_to_roll=0.5" */
};

const char *ovr_study_value(const ovr_study *s, const ovr_study_key *key,
                            size_t task);

/* A path in the folder of the results: NAME of the task, then `ending`. */
void ovr_study_file(const ovr_study *s, size_t task, const char *ending,
                    char *path, size_t room);

/* Steps of reading: names of all tasks; every value once into the base
 * case, so that what is wrong is known before anything runs. */
ovr_status ovr_study_name_tasks(ovr_study *s, ovr_error *err);
ovr_status ovr_study_try_values(const ovr_study *s, ovr_error *err);

/* "1, 2, 5", "a, b | c, d", "1..8", "linear 1 to 5 in 3", "log 0.1 um to
 * 10 um in 5": the values one by one. */
ovr_status ovr_study_values(const char *text, ovr_arena *arena, char ***values,
                            size_t *count, ovr_error *err);

#endif
