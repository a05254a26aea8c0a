/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Deformation of two half-spaces by a pressure that is periodic in Y.
 *
 *     dH_i,q = sum_j k_q(|i - j|) P_j,q      q = 0..lines/2
 *     k_0(d) = -(1/pi) int ln|X| dX over the mesh at d: of the line contact
 *     k_q(0) = 2 I(k D/2)/(pi k),   k = 2 pi q/W
 *     k_q(d) = [I((d + 1/2) k D) - I((d - 1/2) k D)]/(pi k)
 *     I(z) = int_0^z K0 = pi/2 - J(z),  J = int_0^inf e^(-z cosh u)/cosh u du
 *
 * P_q is the discrete Fourier transform of P across.  Pressure is a
 * trigonometric polynomial across and constant over a mesh along.  The kernel
 * of a wave across is K0(k|X|)/pi.  The trapezoidal rule with step 0.2 computes
 * J to 1e-16.  Values below 1e-22, which are those beyond z = 50, are set to
 * zero.
 *
 * The sums over j are circular convolutions of the length 2 (n - 1).  The first
 * and last rows have no pressure, so that no offset of n - 1 occurs.  The
 * transforms of FFTW are exact to rounding.  Cost: O(n lines log(n lines)).
 */
#include <math.h>
#include <string.h>

#include "mathematics/transform.h"
#include "multigrid/field.h"
#include "strip/kernels.h"

static double integral_beyond(double z)
{
    const double step = 0.2;
    if (z > 50)
        return 0;
    double sum = 0.5 * exp(-z), term = sum;
    for (int m = 1; m < 200 && term > 1e-19 * sum; m++) {
        double c = cosh(m * step);
        term = exp(-z * c) / c;
        sum += term;
    }
    return sum * step;
}

/* Integral of ln|x| over the mesh at d. */
static double logarithm(double d, double D)
{
    double a = (d + 0.5) * D, b = (d - 0.5) * D;
    return a * (log(fabs(a)) - 1) - b * (log(fabs(b)) - 1);
}

void ovr_strip_influence(double k, double D, size_t n, size_t step, double *to)
{
    const double pi = acos(-1);
    double before = 0;
    for (size_t d = 0; d < n; d++, to += step) {
        if (!(k > 0)) {
            *to = -logarithm((double)d, D) / pi;
            continue;
        }
        double rest = integral_beyond(((double)d + 0.5) * k * D);
        *to = (d ? before - rest : pi - 2 * rest) / (pi * k);
        before = rest;
    }
}

size_t ovr_strip_spectrum_size(const ovr_strip_grid *g)
{
    return 2 * (g->n - 1) * (g->lines / 2 + 1);
}

/* dH/dP at d rows and e lines of the influence by modes. */
static double at_lines(const ovr_strip_elastic *e, size_t d, size_t line)
{
    const double turn = 2 * acos(-1) / (double)e->lines;
    const double *k = e->table + d * e->modes;
    double sum = 0;
    for (size_t q = 0; q < e->lines; q++) {
        size_t mode = q < e->modes ? q : e->lines - q;
        sum += k[mode] * cos(turn * (double)(q * line % e->lines));
    }
    return sum / (double)e->lines;
}

/* Transforms the table along X, with the factors of all transforms.  The result
 * is real and even like the table. */
static void transform_table(ovr_strip_elastic *e)
{
    const double factor = 1 / ((double)e->length * (double)e->lines);
    fftw_complex *x = e->spectrum;
    memset(x, 0, e->length * e->modes * sizeof *x);
    for (size_t i = 0; i < e->length; i++) {
        size_t d = i < e->n ? i : e->length - i;
        for (size_t m = 0; m < e->modes; m++)
            x[i * e->modes + m][0] = e->table[d * e->modes + m];
    }
    fftw_execute(e->to_waves);
    for (size_t k = 0; k < e->n * e->modes; k++)
        e->table[k] = -factor * x[k][0]; /* H = H0 + gap - w */
}

static bool plan(ovr_strip_elastic *e, double *field)
{
    const int lines = (int)e->lines, length = (int)e->length;
    const int modes = (int)e->modes, rows = (int)e->n, stride = (int)e->stride;
    fftw_complex *x = e->spectrum;
    e->to_modes = fftw_plan_many_dft_r2c(1, &lines, rows, field, NULL, 1,
                                         stride, x, NULL, 1, modes,
                                         FFTW_ESTIMATE);
    e->from_modes = fftw_plan_many_dft_c2r(1, &lines, rows, x, NULL, 1, modes,
                                           field, NULL, 1, stride,
                                           FFTW_ESTIMATE);
    e->to_waves = fftw_plan_many_dft(1, &length, modes, x, NULL, modes, 1, x,
                                     NULL, modes, 1, FFTW_FORWARD,
                                     FFTW_ESTIMATE);
    e->from_waves = fftw_plan_many_dft(1, &length, modes, x, NULL, modes, 1, x,
                                       NULL, modes, 1, FFTW_BACKWARD,
                                       FFTW_ESTIMATE);
    return e->to_modes && e->from_modes && e->to_waves && e->from_waves;
}

ovr_status ovr_strip_elastic_allocate(ovr_strip_elastic *e,
                                      const ovr_strip_grid *g,
                                      fftw_complex *spectrum, ovr_arena *arena,
                                      ovr_error *err)
{
    e->n = g->n;
    e->lines = g->lines;
    e->stride = g->stride;
    e->modes = g->lines / 2 + 1;
    e->length = 2 * (g->n - 1);
    e->spectrum = spectrum;
    e->table = ovr_field(arena, e->n * e->modes, err);
    return e->table ? OVR_OK : OVR_NO_MEMORY;
}

/* `near` gets dH/dP close by, real_space, unless it is NULL, that of all rows
 * and of 2 lines lines, shifted by a period: n rows of 2 lines + 8. */
ovr_status ovr_strip_elastic_plan(ovr_strip_elastic *e, const ovr_strip_grid *g,
                                  ovr_strip_level *near, double *real_space,
                                  ovr_error *err)
{
    const double wave = 2 * acos(-1) / ((double)g->lines * g->Dy);
    ovr_planning_begin();
    bool whole = plan(e, near->f.w);
    ovr_planning_end();
    if (!whole)
        return ovr_fail(err, OVR_NO_MEMORY, "no memory to plan transforms");
    for (size_t m = 0; m < e->modes; m++)
        ovr_strip_influence((double)m * wave, g->D, e->n, e->modes,
                            e->table + m);
    for (size_t d = 0; d < OVR_STRIP_NEAR && d < e->n; d++)
        for (size_t line = 0; line < 2; line++)
            near->near[line][d] = at_lines(e, d, line);
    for (size_t d = 0; real_space && d < e->n; d++)
        for (size_t j = 0; j < 2 * e->lines; j++)
            real_space[d * (2 * e->lines + 8) + j] = at_lines(e, d,
                                                              j % e->lines);
    transform_table(e);
    return OVR_OK;
}

void ovr_strip_elastic_release(ovr_strip_elastic *e)
{
    fftw_plan *const plans[] = {&e->to_modes, &e->to_waves, &e->from_waves,
                                &e->from_modes};
    ovr_planning_begin();
    for (size_t k = 0; k < sizeof plans / sizeof *plans; k++) {
        if (*plans[k])
            fftw_destroy_plan(*plans[k]);
        *plans[k] = NULL;
    }
    ovr_planning_end();
}

void ovr_strip_deform(ovr_strip *strip, ovr_strip_level *level, double *P,
                      double *w)
{
    const ovr_strip_elastic *e = &level->elastic;
    size_t filled = e->n * e->modes;
    fftw_execute_dft_r2c(e->to_modes, P, e->spectrum);
    memset(e->spectrum + filled, 0,
           (e->length * e->modes - filled) * sizeof *e->spectrum);
    fftw_execute(e->to_waves);
    strip->run->multiply_modes(e->n, e->length, e->modes, e->table,
                               (double *)e->spectrum);
    fftw_execute(e->from_waves);
    fftw_execute_dft_c2r(e->from_modes, e->spectrum, w);
}
