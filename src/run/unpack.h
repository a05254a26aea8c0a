/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Copies the inputs stored in a result file to a temporary folder. */
#ifndef OVR_RUN_UNPACK_H
#define OVR_RUN_UNPACK_H

#include "base/arena.h"
#include "case/case.h"
#include "results/results.h"

typedef struct ovr_lent {
    ovr_arena arena;
    char folder[48]; /* "": no folder */
    size_t files;
    const char **file;
} ovr_lent;

/* Writes copies of the inputs stored in the result and sets the keys of the
 * case to their paths. The caller must remove them by ovr_inputs_remove, also
 * after an error. The case does not change for inputs that are not stored, or
 * if there is no temporary folder. */
ovr_status ovr_inputs_lend(ovr_result *result, const char *path, ovr_case *c,
                           ovr_lent *to, ovr_error *err);

/* Removes the copies. */
void ovr_inputs_remove(ovr_lent *lent);

#endif
