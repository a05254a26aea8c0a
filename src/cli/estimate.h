/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The discretization error on request: the same case one level coarser.
 * For a scheme of order p the error of the finer one is
 *     (fine - coarse)/(2^p - 1).
 */
#ifndef OVR_CLI_ESTIMATE_H
#define OVR_CLI_ESTIMATE_H

#include "cli/cli.h"

typedef struct cli_estimate {
    int level;                  /* of the coarser solution; 0: none was made */
    double H_min, H_cen, P_max; /* errors at the end */
    double H_min_overall;       /* of the smallest film in time */
} cli_estimate;

#define CLI_ESTIMATE_OPTION                                                    \
    {                                                                          \
        "estimate-error", NULL,                                                \
            "solve again one level coarser and say what that tells of the "    \
            "error",                                                           \
            false                                                              \
    }

/* Solves the case again, `steady` or through time, beside `sim`. */
ovr_status cli_estimate_error(const ovr_case *c, const ovr_simulation *sim,
                              bool steady, cli_estimate *estimate,
                              ovr_error *err);

#endif
