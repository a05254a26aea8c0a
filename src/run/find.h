/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Search for the value of a key: shared by the files that check the question
 * (find_question.c, find_names.c) and that solve it. */
#ifndef OVR_RUN_FIND_H
#define OVR_RUN_FIND_H

#include "mathematics/search.h"
#include "run/comparison.h"
#include "run/find_table.h"
#include "run/trials.h"

enum { OVR_FIND_MAX = 2 * OVR_SEARCH_MAX, OVR_FIND_TEXT = 1000 };

struct ovr_find {
    ovr_arena arena;
    ovr_find_options how;
    ovr_case *base;
    ovr_find_info info;
    double from, to;
    const char *suffix; /* " kN/m", or "" */
    char variant[40]; /* difference from the case, for the names of result files
                       */
    bool checked;     /* the quantity is known to be a number of the runs */
    ovr_find_evaluation *made;
    ovr_trial answer;
    bool answered;
    ovr_find_table table;
    int lock; /* descriptor of the folder's lock plus one; 0: none */
    char message[OVR_FIND_TEXT];
};

/* Sets the key of a case to the value x. */
ovr_status ovr_find_set(const ovr_find *f, ovr_case *c, double x,
                        ovr_error *err);

/* Checks before the first run that the quantity is a number of formulas
 * (info.exact) or of the runs. If no run can be created, and with a runner of
 * the caller, the first run decides. */
ovr_status ovr_find_quantity(ovr_find *f, const char *quantity, ovr_error *err);

/* Checks after the first run that the requested quantity is one of its numbers
 * and is known. */
ovr_status ovr_find_check(ovr_find *f, const ovr_trial *t, ovr_error *err);

#endif
