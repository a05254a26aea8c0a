/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kernels of one table, whose name is OVR_ISA. */
#ifndef OVR_MULTIGRID_TABLE_H
#define OVR_MULTIGRID_TABLE_H

#include "multigrid/kernels.h"

void OVR_KERNEL(pack)(const ovr_lanes *, const double *, double *);
void OVR_KERNEL(unpack)(const ovr_lanes *, const double *, double *);
void OVR_KERNEL(deformation)(const struct ovr_mlmi *, double *, double *);
void OVR_KERNEL(film)(const ovr_fluid *, double, const ovr_lanes *,
                      const double *, const double *, const ovr_fields *);
void OVR_KERNEL(residual)(const ovr_lanes *, const ovr_weights *,
                          const ovr_fields *);
double OVR_KERNEL(imbalance)(const ovr_lanes *, const ovr_weights *,
                             const ovr_fields *);
void OVR_KERNEL(band_assemble)(const ovr_lanes *, const ovr_weights *,
                               const double[6], const ovr_shares *,
                               const ovr_fields *, const ovr_band *);
void OVR_KERNEL(band_solve)(const ovr_lanes *, const ovr_band *);
void OVR_KERNEL(distribute)(const ovr_lanes *, double, const ovr_shares *,
                            const ovr_band *, double *);
double OVR_KERNEL(sum)(const ovr_lanes *, const double *);
void OVR_KERNEL(coarse_gap)(const ovr_lanes *, double, const double *,
                            double *);
void OVR_KERNEL(restrict_fields)(const ovr_lanes *, const ovr_lanes *,
                                 const double *, const double *, const double *,
                                 double *, double *, double *, double *);
void OVR_KERNEL(coarse_side)(const ovr_lanes *, const double *, double *,
                             double *);
void OVR_KERNEL(correct)(const ovr_lanes *, const ovr_lanes *, double,
                         const double *, const double *, double *);
void OVR_KERNEL(combine)(size_t, double, const double *, double, const double *,
                         double *);
void OVR_KERNEL(extrapolate)(size_t, size_t, const double[],
                             const double *const[], double *);
size_t OVR_KERNEL(extreme)(size_t, double, const double *);
bool OVR_KERNEL(positive)(size_t, const double *);
double OVR_KERNEL(difference)(size_t, const double *, const double *);
double OVR_KERNEL(gain)(size_t, const double *, const double *);
int OVR_KERNEL(peaks)(size_t, const double *, size_t *);
double OVR_KERNEL(mean_flow)(size_t, const double[2], double, const double *,
                             const double *, const double *);
double OVR_KERNEL(deviation)(size_t, const double[3], const double *,
                             const double *, double *const[3]);
void OVR_KERNEL(dense_row)(size_t, const double[4], const double *, double *);
bool OVR_KERNEL(dense_solve)(size_t, size_t, double *, double *);

#define OVR_TEXT(x) #x
#define OVR_NAME(x) OVR_TEXT(x)

/* clang-format off */
#define OVR_KERNELS(number_of_lanes) { \
    .name = OVR_NAME(OVR_ISA), \
    .lanes = (number_of_lanes), \
    .pack = OVR_KERNEL(pack), \
    .unpack = OVR_KERNEL(unpack), \
    .film = OVR_KERNEL(film), \
    .residual = OVR_KERNEL(residual), \
    .imbalance = OVR_KERNEL(imbalance), \
    .deformation = OVR_KERNEL(deformation), \
    .band_assemble = OVR_KERNEL(band_assemble), \
    .band_solve = OVR_KERNEL(band_solve), \
    .distribute = OVR_KERNEL(distribute), \
    .sum = OVR_KERNEL(sum), \
    .combine = OVR_KERNEL(combine), \
    .coarse_gap = OVR_KERNEL(coarse_gap), \
    .restrict_fields = OVR_KERNEL(restrict_fields), \
    .coarse_side = OVR_KERNEL(coarse_side), \
    .correct = OVR_KERNEL(correct), \
    .extrapolate = OVR_KERNEL(extrapolate), \
    .extreme = OVR_KERNEL(extreme), \
    .positive = OVR_KERNEL(positive), \
    .difference = OVR_KERNEL(difference), \
    .gain = OVR_KERNEL(gain), \
    .peaks = OVR_KERNEL(peaks), \
    .mean_flow = OVR_KERNEL(mean_flow), \
    .deviation = OVR_KERNEL(deviation), \
    .dense_row = OVR_KERNEL(dense_row), \
    .dense_solve = OVR_KERNEL(dense_solve), \
}
/* clang-format on */

extern const ovr_kernels OVR_KERNEL(kernels);

#endif
