/* SPDX-License-Identifier: GPL-3.0-or-later */
/* This instruction set's table of kernels. */
#include "multigrid/kernels.h"

#define TEXT(x) #x
#define NAME(x) TEXT(x)

void OVR_KERNEL(film)(const ovr_fluid *, double, size_t, const double *,
                      const double *, const ovr_fields *);
void OVR_KERNEL(residual)(size_t, const ovr_weights *, const ovr_fields *);
double OVR_KERNEL(imbalance)(size_t, const ovr_weights *, const ovr_fields *);
void OVR_KERNEL(deformation)(const struct ovr_mlmi *, const double *, double *);
void OVR_KERNEL(band_assemble)(size_t, const ovr_weights *, const double[6],
                               double, double, bool, const ovr_fields *,
                               const ovr_band *);
void OVR_KERNEL(band_solve)(size_t, const ovr_band *);
void OVR_KERNEL(distribute)(size_t, double, const ovr_band *, double *);
double OVR_KERNEL(sum)(size_t, const double *);
void OVR_KERNEL(combine)(size_t, double, const double *, double, const double *,
                         double *);
void OVR_KERNEL(coarse_gap)(size_t, double, const double *, double *);
void OVR_KERNEL(restrict_fields)(size_t, const double *, const double *,
                                 const double *, double *, double *, double *,
                                 double *);
void OVR_KERNEL(coarse_side)(size_t, const double *, double *, double *);
void OVR_KERNEL(correct)(size_t, double, const double *, const double *,
                         double *);
void OVR_KERNEL(extrapolate)(size_t, const double[3], const double *,
                             const double *, const double *, double *);
void OVR_KERNEL(dense_row)(size_t, const double[4], const double *, double *);
bool OVR_KERNEL(dense_solve)(size_t, size_t, double *, double *);

extern const ovr_kernels OVR_KERNEL(kernels);
const ovr_kernels OVR_KERNEL(kernels) = {
    .name = NAME(OVR_ISA),
    .film = OVR_KERNEL(film),
    .residual = OVR_KERNEL(residual),
    .imbalance = OVR_KERNEL(imbalance),
    .deformation = OVR_KERNEL(deformation),
    .band_assemble = OVR_KERNEL(band_assemble),
    .band_solve = OVR_KERNEL(band_solve),
    .distribute = OVR_KERNEL(distribute),
    .sum = OVR_KERNEL(sum),
    .combine = OVR_KERNEL(combine),
    .coarse_gap = OVR_KERNEL(coarse_gap),
    .restrict_fields = OVR_KERNEL(restrict_fields),
    .coarse_side = OVR_KERNEL(coarse_side),
    .correct = OVR_KERNEL(correct),
    .extrapolate = OVR_KERNEL(extrapolate),
    .dense_row = OVR_KERNEL(dense_row),
    .dense_solve = OVR_KERNEL(dense_solve),
};
