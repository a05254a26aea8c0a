/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Interpolation weights for a logarithmic kernel: of all even weights at the
 * distances y_k = 1, 3, ..., 2h - 1 with sum 1 those that make
 *     max x^1.5 |e(x)|,
 *     e(x) = ln x - sum_k weight_k [ln(x + y_k) + ln(x - y_k)]
 * over x > range least.  (The errors of all distances add up: 1.5 was best of
 * 0, 0.5, ..., 2.)  Beside Lagrange's weights the deformation's error is 12
 * times smaller at p = 6, 60 at p = 8, 250 at p = 10.
 *
 * Lawson's method: least squares with weights lambda(x), lambda <- lambda
 * x^1.5 |e|, until the largest errors are level.  The unknowns are the weights
 * but the first, which the sum gives; their columns are nearly dependent,
 * hence orthogonalization in extended precision.
 */
#include "multigrid/deformation_weights.h"

#include <math.h>
#include <string.h>

#include "multigrid/deformation.h"

enum { POINTS = 120, ITERATIONS = 60 };

typedef struct fit {
    long double column[OVR_MLMI_MAX][POINTS]; /* the last is ln x */
    long double q[OVR_MLMI_MAX][POINTS];
    long double lambda[POINTS], importance[POINTS];
} fit;

/* Integers at first, then in growing steps: e changes slowly far out. */
static long double point(size_t j, size_t range)
{
    long double x = (long double)(range + 1 + j);
    return j < 64 ? x : x * powl(1.1L, (long double)(j - 64));
}

static void fill(fit *f, size_t h, size_t range)
{
    for (size_t j = 0; j < POINTS; j++) {
        long double x = point(j, range);
        /* ln(x^2 - y^2) - ln x^2: what all have in common is left out */
        long double first = log1pl(-1 / (x * x));
        f->column[h - 1][j] = -0.5L * first;
        f->lambda[j] = 1;
        f->importance[j] = powl(x, 1.5L);
        for (size_t k = 1; k < h; k++) {
            long double y = 2 * (long double)k + 1;
            f->column[k - 1][j] = log1pl(-y * y / (x * x)) - first;
        }
    }
}

static long double dot(const fit *f, const long double *a, const long double *b)
{
    long double sum = 0;
    for (size_t j = 0; j < POINTS; j++)
        sum += f->lambda[j] * a[j] * b[j];
    return sum;
}

/* Least squares by Gram-Schmidt on copies of the columns; the error is left
 * in the last of them. */
static void least_squares(fit *f, size_t unknowns, long double solution[])
{
    long double(*q)[POINTS] = f->q;
    long double R[OVR_MLMI_MAX][OVR_MLMI_MAX] = {{0}};
    for (size_t c = 0; c <= unknowns; c++) {
        for (size_t j = 0; j < POINTS; j++)
            q[c][j] = f->column[c][j];
        for (size_t b = 0; b < c; b++) {
            R[b][c] = dot(f, q[b], q[c]);
            for (size_t j = 0; j < POINTS; j++)
                q[c][j] -= R[b][c] * q[b][j];
        }
        if (c == unknowns)
            break;
        long double size = sqrtl(dot(f, q[c], q[c]));
        R[c][c] = size;
        for (size_t j = 0; j < POINTS; j++)
            q[c][j] /= size;
    }
    for (size_t c = unknowns; c-- > 0;) {
        long double sum = R[c][unknowns];
        for (size_t k = c + 1; k < unknowns; k++)
            sum -= R[c][k] * solution[k];
        solution[c] = sum / R[c][c];
    }
}

/* Weights best infinitely far away. */
static void lagrange(size_t h, double weight[])
{
    for (size_t k = 0; k < h; k++) {
        long double x = 2 * (long double)k + 1, value = 0.5L;
        for (size_t j = 0; j < h; j++)
            if (j != k) {
                long double y = 2 * (long double)j + 1;
                value *= y * y / (y * y - x * x);
            }
        weight[k] = (double)value;
    }
}

static void level_errors(fit *f, size_t unknowns)
{
    long double total = 0;
    for (size_t j = 0; j < POINTS; j++) {
        f->lambda[j] *= f->importance[j] * fabsl(f->q[unknowns][j]);
        total += f->lambda[j];
    }
    for (size_t j = 0; j < POINTS; j++)
        f->lambda[j] /= total;
}

void ovr_mlmi_fit_weights(size_t h, size_t range, double weight[])
{
    long double w[OVR_MLMI_MAX], first = 0.5L;
    fit f;
    if (range < 2 * h || h < 2 || h > 6) {
        lagrange(h, weight);
        return;
    }
    fill(&f, h, range);
    for (int iteration = 0; iteration < ITERATIONS; iteration++) {
        least_squares(&f, h - 1, w);
        level_errors(&f, h - 1);
    }
    for (size_t k = 1; k < h; k++) {
        weight[k] = (double)w[k - 1];
        first -= w[k - 1];
    }
    weight[0] = (double)first;
}

/* The fit's results for the pairs that ovr_mlmi_choose knows: it takes as long
 * as a fifth of a steady solution at level 8. */
static const struct {
    size_t h, range;
    double weight[6];
} fitted[] = {
    {3,
     10,
     {0x1.2a05b57d3b4b4p-1, -0x1.7870b71ffd4d4p-4, 0x1.421859b1179b9p-7}},
    {3,
     16,
     {0x1.2b310bf13ecb9p-1, -0x1.8653c476b5149p-4, 0x1.665b2765f5bfcp-7}},
    {5,
     10,
     {0x1.31455c5388257p-1, -0x1.dd50ed0ddac18p-4, 0x1.7421897129abep-6,
      -0x1.488b6d1ad393ep-9, 0x1.880df8971e39bp-14}},
    {5,
     12,
     {0x1.32b9ec9135f9fp-1, -0x1.f30f4376a559ap-4, 0x1.a9e47aa584488p-6,
      -0x1.bf06f46ad37dp-9, 0x1.7defcdd6275fdp-13}},
    {5,
     14,
     {0x1.339a1b475c2cbp-1, -0x1.0034e88835fddp-3, 0x1.cc6b610df2fcap-6,
      -0x1.08b0e293b3a1dp-8, 0x1.092cbb4911373p-12}},
    {6,
     16,
     {0x1.362b42e6b90d2p-1, -0x1.14e0313378dd7p-3, 0x1.22badda36c236p-5,
      -0x1.c059f581d3a69p-8, 0x1.9b247005a4ea5p-11, -0x1.3e6943d678cf8p-15}},
};

void ovr_mlmi_weights(size_t h, size_t range, double weight[])
{
    for (size_t i = 0; i < sizeof fitted / sizeof *fitted; i++)
        if (fitted[i].h == h && fitted[i].range == range) {
            memcpy(weight, fitted[i].weight, h * sizeof *weight);
            return;
        }
    ovr_mlmi_fit_weights(h, range, weight);
}
