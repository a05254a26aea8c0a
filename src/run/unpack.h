/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inputs that a result file holds, as files of a temporary folder. */
#ifndef OVR_RUN_UNPACK_H
#define OVR_RUN_UNPACK_H

#include "base/arena.h"
#include "case/case.h"
#include "results/results.h"

typedef struct ovr_lent {
    ovr_arena arena;
    char folder[48]; /* "": there is none */
    size_t files;
    const char **file;
} ovr_lent;

/* Writes copies of the inputs that the result holds, and sets the keys of the
 * case to their paths.  The caller must remove them by ovr_inputs_remove,
 * also after an error.  Without a place for temporary files, and for inputs
 * that are not kept, the case stays as it is. */
ovr_status ovr_inputs_lend(ovr_result *result, const char *path, ovr_case *c,
                           ovr_lent *to, ovr_error *err);

/* Removes the copies. */
void ovr_inputs_remove(ovr_lent *lent);

#endif
