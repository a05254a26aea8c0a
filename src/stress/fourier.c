/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "stress/fourier.h"

#include "mathematics/transform.h"

static bool plan_all(ovr_fourier *f)
{
    f->forward = fftw_plan_dft_r2c_1d((int)f->N, f->real, f->spectrum,
                                      FFTW_ESTIMATE);
    bool whole = f->forward != NULL;
    for (int c = 0; c < OVR_STRESS_LEVELS; c++) {
        f->back[c] = fftwf_plan_dft_1d((int)(f->N >> c), f->waves, f->values,
                                       FFTW_BACKWARD, FFTW_ESTIMATE);
        whole = whole && f->back[c];
    }
    return whole;
}

ovr_status ovr_fourier_plan(ovr_fourier *f, ovr_error *err)
{
    ovr_planning_begin();
    bool whole = plan_all(f);
    ovr_planning_end();
    if (!whole)
        return ovr_fail(err, OVR_NO_MEMORY, "no memory to plan transforms");
    return OVR_OK;
}

ovr_status ovr_fourier_real(size_t n, fftw_complex *bins, double *values,
                            fftw_plan *plan, ovr_error *err)
{
    ovr_planning_begin();
    *plan = fftw_plan_dft_c2r_1d((int)n, bins, values, FFTW_ESTIMATE);
    ovr_planning_end();
    return *plan ? OVR_OK
                 : ovr_fail(err, OVR_NO_MEMORY, "no memory to plan transforms");
}

ovr_status ovr_fourier_bins(size_t n, double *values, fftw_complex *bins,
                            fftw_plan *plan, ovr_error *err)
{
    ovr_planning_begin();
    *plan = fftw_plan_dft_r2c_1d((int)n, values, bins, FFTW_ESTIMATE);
    ovr_planning_end();
    return *plan ? OVR_OK
                 : ovr_fail(err, OVR_NO_MEMORY, "no memory to plan transforms");
}

void ovr_fourier_forget(fftw_plan plan)
{
    if (!plan)
        return;
    ovr_planning_begin();
    fftw_destroy_plan(plan);
    ovr_planning_end();
}

void ovr_fourier_drop(ovr_fourier *f)
{
    ovr_planning_begin();
    if (f->forward)
        fftw_destroy_plan(f->forward);
    for (int c = 0; c < OVR_STRESS_LEVELS; c++)
        if (f->back[c])
            fftwf_destroy_plan(f->back[c]);
    ovr_planning_end();
}

void ovr_fourier_back(ovr_fourier *f, int c, float *values)
{
    fftwf_execute_dft(f->back[c], f->waves, (fftwf_complex *)values);
}
