/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * List of the fields of a level. It determines allocation, copies in the order
 * of the nodes, the visible solution, extrapolated guesses, stored time levels
 * and checkpoints.
 *
 *     memory   LANES: the nodes, in lanes; WIDE: with the deformation's halos;
 *              NEWTON: only on grids solved by Newton's method;
 *              FLOW, SENSITIVE: as LANES, NEWTON where the flow at half nodes
 *              is stored, with a flow law or means by the gap (faces.h);
 *              FLUIDITY: where these means are logarithmic;
 *              CONTENT: with mass-conserving cavitation only (content.h);
 *              SKEWED: with temperatures across the film only
 *     ordered  also stored in the order of the nodes, for code without lanes
 *     carried  restricted to all levels by full weighting in full multigrid
 *     shown    of the finest level: part of the solution, read after a solve
 *     past     number of previous times kept and saved in checkpoints
 *     guessed  extrapolated in time from all stored times
 */
#ifndef OVR_MULTIGRID_FIELDS_H
#define OVR_MULTIGRID_FIELDS_H

#include <stdbool.h>
#include <stddef.h>

/* clang-format off */
/*    name     memory ordered carried shown past guessed */
#define OVR_LEVEL_FIELDS(FIELD) \
    FIELD(P,       WIDE,   1, 0, 1, 4, 1) /* pressure */ \
    FIELD(H,       LANES,  1, 0, 1, 0, 0) /* film thickness */ \
    FIELD(rho,     LANES,  1, 0, 0, 0, 0) /* density */ \
    FIELD(dq,      LANES,  1, 0, 0, 0, 0) /* d q/dP at fixed H */ \
    FIELD(eps,     LANES,  1, 0, 1, 0, 0) /* rho H^3/(eta lambda) */ \
    FIELD(deps,    LANES,  1, 0, 0, 0, 0) /* d eps/dP at fixed H */ \
    FIELD(deps_dH, NEWTON, 1, 0, 0, 0, 0) /* d eps/dH at fixed P */ \
    FIELD(q,       LANES,  1, 0, 1, 3, 0) /* rho H */ \
    FIELD(F,       LANES,  1, 0, 0, 0, 0) /* right-hand side of Reynolds' */ \
    FIELD(r,       LANES,  1, 0, 0, 0, 0) /* residual F - N */ \
    FIELD(log_fluidity, FLUIDITY, 1, 0, 0, 0, 0) /* log2(1/eta) */ \
    FIELD(log_slope, FLUIDITY, 1, 0, 0, 0, 0) /* d ln(1/eta)/dP */ \
    FIELD(gap,     LANES,  0, 1, 0, 0, 0) /* undeformed gap (hierarchy.h) */ \
    FIELD(w,       WIDE,   0, 0, 0, 0, 0) /* deformation */ \
    FIELD(entry,   LANES,  0, 0, 0, 0, 0) /* P at the start of the cycle on this
                                           * level */ \
    FIELD(flow,    FLOW,   1, 0, 1, 0, 0) /* 2 E at i + 1/2 (flow.h) */ \
    FIELD(out_left, FLOW,  1, 0, 0, 0, 0) /* -d(2 E dP)/dP_i, see flow.h */ \
    FIELD(out_right, FLOW, 1, 0, 0, 0, 0) /* d(2 E dP)/dP_{i+1} */ \
    FIELD(by_left, SENSITIVE, 1, 0, 0, 0, 0) /* 2 dE/dH_i at fixed P */ \
    FIELD(by_right, SENSITIVE, 1, 0, 0, 0, 0) /* 2 dE/dH_{i+1} */ \
    FIELD(skew,    SKEWED, 1, 0, 0, 0, 0) /* s_0 of reynolds_row.h */ \
    FIELD(skew_by_P, SKEWED, 1, 0, 0, 0, 0) /* s_1 of reynolds_row.h */ \
    FIELD(full,    CONTENT, 0, 0, 0, 0, 0) /* rho H of a full gap */ \
    FIELD(kept,    CONTENT, 0, 0, 0, 0, 0) /* kappa q^{k-1}/dT (content.h) */
#define OVR_FIELD_INDEX(name, ...) OVR_FIELD_##name,
#define OVR_FIELD_POINTER(name, ...) double *restrict name;
/* clang-format on */

enum { OVR_LEVEL_FIELDS(OVR_FIELD_INDEX) OVR_FIELD_COUNT, OVR_PAST = 4 };

/* Arrays of one grid, accessible by name or by index. */
typedef struct ovr_fields {
    union {
        struct {
            OVR_LEVEL_FIELDS(OVR_FIELD_POINTER)
        };
        double *all[OVR_FIELD_COUNT];
    };
    /* phase of each node, as sets of nodes (lanes.h): wet, with P > 0, in halos
     * too; held: cavitated and constrained to P = 0, because the residual would
     * not make P positive (reynolds_row.h). Nodes in neither set are cavitated
     * and about to become pressurized. */
    unsigned char *wet, *held;
    /* set with temperatures in the film, in lanes, otherwise NULL: log2(1/eta)
     * = th times its value at the supply temperature + shift; drag: psi_c,
     * factor of rho H^2 in the sliding stress (flow.h); swell: divisor of the
     * density, or NULL */
    double *th, *shift, *drag, *swell;
    /* set with mass-conserving cavitation (content.h): nodes that became
     * cavitated in this sweep; limited outflow; limited time derivative;
     * pressurized nodes whose changes are distributed to the node before, and
     * after */
    unsigned char *dried, *limited, *spent, *left, *right;
} ovr_fields;

typedef enum ovr_field_memory {
    OVR_LANES,
    OVR_WIDE,
    OVR_NEWTON,
    OVR_FLOW,
    OVR_SENSITIVE,
    OVR_FLUIDITY,
    OVR_CONTENT,
    OVR_SKEWED
} ovr_field_memory;

typedef struct ovr_field_row {
    const char *name;
    ovr_field_memory memory;
    bool ordered, carried, shown;
    int past;
    bool guessed;
} ovr_field_row;

extern const ovr_field_row ovr_field_rows[OVR_FIELD_COUNT];

#endif
