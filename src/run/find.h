/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A search is asked by one file (find_question.c) and made by another. */
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
    char variant[40];   /* of result files: what differs from the case */
    bool checked;       /* the quantity is one of the runs' */
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

/* The first run determines the available numbers: fails unless the one asked
 * for is among them, and known. */
ovr_status ovr_find_check(ovr_find *f, const ovr_trial *t, ovr_error *err);

#endif
