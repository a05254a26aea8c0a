/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourier transforms by FFTW: real doubles forward, complex floats backward for
 * all lengths N / 2^c.
 *
 * In a run with fatigue (1.5 um dent, level 6, including output) FFTW takes 9 %
 * of the instructions, so own transforms could make it at most 1.1 times
 * faster.
 *
 * Plans are FFTW_ESTIMATE, chosen without measuring, so that equal inputs give
 * equal bits in every run; they are made and freed under the lock of
 * mathematics/transform.h.
 */
#ifndef OVR_STRESS_FOURIER_H
#define OVR_STRESS_FOURIER_H

#include <fftw3.h>

#include "stress/depths.h"

typedef struct ovr_fourier {
    size_t N;
    double *real;                       /* N */
    fftw_complex *spectrum;             /* N/2 + 1 */
    fftwf_complex *waves;               /* N */
    fftwf_complex *values;              /* N */
    fftw_plan forward;                  /* real -> spectrum */
    fftwf_plan back[OVR_STRESS_LEVELS]; /* waves -> values, N / 2^c */
} ovr_fourier;

/* The arrays are provided by the caller, aligned to 64 bytes. */
ovr_status ovr_fourier_plan(ovr_fourier *f, ovr_error *err);
void ovr_fourier_drop(ovr_fourier *f);

/* Plans a transform from n/2 + 1 bins to n real values, without the factor 1/n.
 */
ovr_status ovr_fourier_real(size_t n, fftw_complex *bins, double *values,
                            fftw_plan *plan, ovr_error *err);

/* Plans the inverse of it. */
ovr_status ovr_fourier_bins(size_t n, double *values, fftw_complex *bins,
                            fftw_plan *plan, ovr_error *err);

/* Destroys either plan. */
void ovr_fourier_forget(fftw_plan plan);

/* Transforms waves[] backward into another array of N / 2^c complex values with
 * the same alignment. */
void ovr_fourier_back(ovr_fourier *f, int c, float *values);

#endif
