/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Deformation of two half-spaces by a pressure that is periodic in Y.
 *
 *     dH_i,q = sum_j k_q(|i - j|) P_j,q      q = 0..lines/2
 *     k_0(d) = -(1/pi) int ln|X| dX over the interval at d (line contact)
 *     k_q(0) = 2 I(k D/2)/(pi k),   k = 2 pi q/W
 *     k_q(d) = [I((d + 1/2) k D) - I((d - 1/2) k D)]/(pi k)
 *     I(z) = int_0^z K0 = pi/2 - J(z),  J = int_0^inf e^(-z cosh u)/cosh u du
 *
 * P_q is the discrete Fourier transform of P across.  Pressure is a
 * trigonometric polynomial across, and constant around each node along X.  The
 * kernel of a wave across is K0(k|X|)/pi.  The trapezoidal rule with step 0.2
 * computes J to 1e-16.  Values below 1e-22, which are those beyond z = 50, are
 * set to zero.
 *
 * The sums over j are circular convolutions of the length 2 (n - 1).  The first
 * and last rows have no pressure, so that no offset of n - 1 occurs.  The
 * transforms of FFTW are exact to rounding.  Cost: O(n lines log(n lines)).
 */
#include <math.h>
#include <string.h>

#include "mathematics/transform.h"
#include "multigrid/field.h"
#include "strip/across.h"
#include "strip/kernels.h"

/* Numbers of rows and columns per transform. FFTW's choice of an algorithm
 * depends on them, so they must not depend on the number of threads. */
enum { ROWS = 16, COLUMNS = 8 };

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

/* Integral of ln|x| over the interval of length D at d. */
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

/* dH/dP at a distance of d rows and e lines, from the modes of the influence.
 */
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
 * is real and even, like the table. */
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
    for (size_t m = 0; m < e->modes; m += COLUMNS) {
        bool part = m + COLUMNS > e->modes;
        fftw_execute_dft(e->to_waves[part], x + m, x + m);
    }
    for (size_t k = 0; k < e->n * e->modes; k++)
        e->table[k] = -factor * x[k][0]; /* H = H0 + gap - w */
}

/* Plans transforms of `rows` rows and `columns` columns (k = 0), or of the
 * remaining ones (k = 1). None may remain. */
static bool plan(ovr_strip_elastic *e, double *field, int k, int rows,
                 int columns)
{
    const int lines = (int)e->lines, length = (int)e->length;
    const int modes = (int)e->modes, stride = (int)e->stride;
    fftw_complex *x = e->spectrum;
    if (rows > 0) {
        e->to_modes[k] = fftw_plan_many_dft_r2c(1, &lines, rows, field, NULL, 1,
                                                stride, x, NULL, 1, modes,
                                                FFTW_ESTIMATE);
        e->from_modes[k] = fftw_plan_many_dft_c2r(1, &lines, rows, x, NULL, 1,
                                                  modes, field, NULL, 1, stride,
                                                  FFTW_ESTIMATE);
    }
    if (columns > 0) {
        e->to_waves[k] = fftw_plan_many_dft(1, &length, columns, x, NULL, modes,
                                            1, x, NULL, modes, 1, FFTW_FORWARD,
                                            FFTW_ESTIMATE);
        e->from_waves[k] = fftw_plan_many_dft(1, &length, columns, x, NULL,
                                              modes, 1, x, NULL, modes, 1,
                                              FFTW_BACKWARD, FFTW_ESTIMATE);
    }
    return (rows == 0 || (e->to_modes[k] && e->from_modes[k])) &&
           (columns == 0 || (e->to_waves[k] && e->from_waves[k]));
}

static bool plan_all(ovr_strip_elastic *e, double *field)
{
    return plan(e, field, 0, e->n < ROWS ? 0 : ROWS,
                e->modes < COLUMNS ? 0 : COLUMNS) &&
           plan(e, field, 1, (int)(e->n % ROWS), (int)(e->modes % COLUMNS));
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

/* Sets the near-field dH/dP in `near`. If `real_space` is not NULL, also writes
 * dH/dP for all rows and 2 lines lines. They are shifted by a period: n rows of
 * 2 lines
 * + 8. */
ovr_status ovr_strip_elastic_plan(ovr_strip_elastic *e, const ovr_strip_grid *g,
                                  ovr_strip_level *near, double *real_space,
                                  ovr_error *err)
{
    const double wave = 2 * acos(-1) / ((double)g->lines * g->Dy);
    ovr_planning_begin();
    bool whole = plan_all(e, near->f.w);
    ovr_planning_end();
    if (!whole)
        return ovr_fail(err, OVR_NO_MEMORY, "no memory to plan transforms");
    for (size_t m = 0; m < e->modes; m++)
        ovr_strip_influence((double)m * wave, g->D, e->n, e->modes,
                            e->table + m);
    for (size_t d = 0; d < OVR_STRIP_NEAR && d < e->n; d++)
        for (size_t line = 0; line < OVR_STRIP_NEAR_LINES; line++)
            near->near[line][d] = at_lines(e, d, line);
    for (size_t d = 0; real_space && d < e->n; d++)
        for (size_t j = 0; j < 2 * e->lines; j++)
            real_space[d * (2 * e->lines + 8) + j] = at_lines(
                e, d, ovr_across_line(e->lines, (ptrdiff_t)j));
    transform_table(e);
    return OVR_OK;
}

void ovr_strip_elastic_release(ovr_strip_elastic *e)
{
    fftw_plan *const plans[] = {e->to_modes, e->to_waves, e->from_waves,
                                e->from_modes};
    ovr_planning_begin();
    for (size_t k = 0; k < 2 * sizeof plans / sizeof *plans; k++) {
        fftw_plan *p = &plans[k / 2][k % 2];
        if (*p)
            fftw_destroy_plan(*p);
        *p = NULL;
    }
    ovr_planning_end();
}

/* Arguments of the passes of a deformation. */
typedef struct deformation {
    ovr_strip *strip;
    const ovr_strip_elastic *e;
    double *P, *w;
} deformation;

static void to_modes(void *data, int member, size_t from, size_t to)
{
    const deformation *d = data;
    const ovr_strip_elastic *e = d->e;
    (void)member;
    for (size_t b = from; b < to; b++) {
        size_t i = b * ROWS;
        fftw_execute_dft_r2c(e->to_modes[i + ROWS > e->n], d->P + i * e->stride,
                             e->spectrum + i * e->modes);
    }
}

static void from_modes(void *data, int member, size_t from, size_t to)
{
    const deformation *d = data;
    const ovr_strip_elastic *e = d->e;
    (void)member;
    for (size_t b = from; b < to; b++) {
        size_t i = b * ROWS;
        fftw_execute_dft_c2r(e->from_modes[i + ROWS > e->n],
                             e->spectrum + i * e->modes, d->w + i * e->stride);
    }
}

/* Convolution along X of blocks of columns. */
static void convolve(void *data, int member, size_t from, size_t to)
{
    const deformation *d = data;
    const ovr_strip_elastic *e = d->e;
    (void)member;
    for (size_t b = from; b < to; b++) {
        size_t m = b * COLUMNS, rest = e->modes - m;
        fftw_complex *x = e->spectrum + m;
        const ovr_part columns = {m, m + (rest < COLUMNS ? rest : COLUMNS)};
        const size_t bytes = (columns.to - m) * sizeof *x;
        for (size_t i = e->n; i < e->length; i++)
            memset(x + i * e->modes, 0, bytes);
        fftw_execute_dft(e->to_waves[rest < COLUMNS], x, x);
        d->strip->run->multiply_modes(e->n, e->length, e->modes, columns,
                                      e->table, (double *)e->spectrum);
        fftw_execute_dft(e->from_waves[rest < COLUMNS], x, x);
    }
}

void ovr_strip_deform(ovr_strip *strip, ovr_strip_level *level, double *P,
                      double *w)
{
    const ovr_strip_elastic *e = &level->elastic;
    deformation d = {.strip = strip, .e = e, .P = P, .w = w};
    const ovr_strip_grid *g = &level->grid;
    size_t rows = (e->n + ROWS - 1) / ROWS;
    ovr_strip_share(strip, g, rows, to_modes, &d);
    ovr_strip_share(strip, g, (e->modes + COLUMNS - 1) / COLUMNS, convolve, &d);
    ovr_strip_share(strip, g, rows, from_modes, &d);
}
