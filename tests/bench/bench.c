/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench.h"
#include "support/contact.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "multigrid/deformation.h"
#include "support/test.h"

#ifdef HAVE_fftw3
#include <complex.h>
#include <fftw3.h>
#endif

/* ------------------------------------------------------------------- time */

static double cpu_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double timed(const bench_work *work, long calls)
{
    double start = cpu_seconds();
    for (long k = 0; k < calls; k++)
        work->run(work->data);
    return (cpu_seconds() - start) / (double)calls;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_median(size_t count, double values[])
{
    qsort(values, count, sizeof *values, compare);
    return values[count / 2];
}

void bench_measure(size_t count, bench_work work[], double minimum, int rounds)
{
    enum { MAX = 101 };
    double *seconds = calloc(count * MAX, sizeof *seconds);
    long *calls = calloc(count, sizeof *calls);
    for (size_t k = 0; k < count; k++) {
        double once = timed(&work[k], 1);
        calls[k] = once > 0 && once < minimum ? (long)(minimum / once) + 1 : 1;
    }
    rounds = rounds < MAX ? rounds : MAX;
    for (int r = 0; r < rounds; r++)
        for (size_t k = 0; k < count; k++)
            seconds[k * MAX + (size_t)r] = timed(&work[k], calls[k]);
    for (size_t k = 0; k < count; k++)
        work[k].seconds = bench_median((size_t)rounds, seconds + k * MAX);
    free(seconds);
    free(calls);
}

/* ------------------------------------------------------------------- JSON */

static struct {
    FILE *file;
    int depth;
    char closing[8];
    bool filled[8]; /* an item was written at this depth */
} json;

static void begin_item(const char *name)
{
    if (!json.file)
        return;
    fputs(json.filled[json.depth] ? ",\n" : "\n", json.file);
    json.filled[json.depth] = true;
    fprintf(json.file, "%*s", 2 * json.depth, "");
    if (name)
        fprintf(json.file, "\"%s\": ", name);
}

static void begin(const char *name, char opening, char closing)
{
    begin_item(name);
    if (json.file)
        fputc(opening, json.file);
    json.depth++;
    json.closing[json.depth] = closing;
    json.filled[json.depth] = false;
}

void bench_open(int argc, char *argv[])
{
    json.file = argc > 1 ? fopen(argv[1], "w") : NULL;
    if (json.file)
        fputc('{', json.file);
    json.depth = 1;
}

void bench_list(const char *name)
{
    begin(name, '[', ']');
}

void bench_row(void)
{
    begin(NULL, '{', '}');
}

void bench_text(const char *name, const char *value)
{
    begin_item(name);
    if (json.file)
        fprintf(json.file, "\"%s\"", value);
}

void bench_number(const char *name, double value)
{
    begin_item(name);
    if (json.file)
        fprintf(json.file, isfinite(value) ? "%.6g" : "null", value);
}

void bench_end(void)
{
    if (json.file)
        fprintf(json.file, "\n%*s%c", 2 * (json.depth - 1), "",
                json.closing[json.depth]);
    json.depth--;
}

void bench_close(void)
{
    if (!json.file)
        return;
    fputs("\n}\n", json.file);
    fclose(json.file);
}

/* ------------------------------------------------------------------- case */

ovr_simulation *bench_contact(int level, ovr_scheme scheme, ovr_stop stop)
{
    ovr_options options = test_options();
    options.level = level;
    options.scheme = scheme;
    options.stop = stop;
    return test_simulation(20, 10, &options);
}

const char *const bench_sets[] = {"avx512", "avx2", "base", NULL};

/* depth 10^(-10 xi^2) cos(2 pi xi) */
void bench_dent_heights(void *data, double T, size_t n, const double *X,
                        double *S)
{
    const bench_dent *dent = data;
    for (size_t i = 0; i < n; i++) {
        double xi = (X[i] - dent->start - T) / 0.5;
        S[i] = xi * xi > 1.7 ? 0
                             : -0.1 * exp(-10 * log(10) * xi * xi) *
                                   cos(2 * acos(-1) * xi);
    }
}

/* -------------------------------------------------------------------- FFT */

#ifdef HAVE_fftw3

struct bench_fft {
    size_t size;
    double *values;
    fftw_complex *spectrum, *kernel;
    fftw_plan forward, backward;
};

/* Returns the smallest even number of at least n whose factors are 2, 3, 5 and
 * 7. */
static size_t smooth_size(size_t n)
{
    for (size_t size = n + n % 2;; size += 2) {
        size_t rest = size;
        for (size_t p = 2; p <= 7; p++)
            while (rest % p == 0)
                rest /= p;
        if (rest == 1)
            return size;
    }
}

bench_fft *bench_fft_plan(size_t n, double D)
{
    bench_fft *fft = calloc(1, sizeof *fft);
    size_t m = fft->size = smooth_size(2 * n);
    fft->values = fftw_alloc_real(m);
    fft->spectrum = fftw_alloc_complex(m / 2 + 1);
    fft->kernel = fftw_alloc_complex(m / 2 + 1);
    fft->forward = fftw_plan_dft_r2c_1d((int)m, fft->values, fft->spectrum,
                                        FFTW_MEASURE);
    fft->backward = fftw_plan_dft_c2r_1d((int)m, fft->spectrum, fft->values,
                                         FFTW_MEASURE);
    for (size_t i = 0; i < m; i++) {
        double d = (double)(i < m - i ? i : m - i);
        fft->values[i] = ovr_deformation_kernel(d, D) / (double)m;
    }
    fftw_execute(fft->forward);
    for (size_t k = 0; k <= m / 2; k++)
        fft->kernel[k] = fft->spectrum[k];
    for (size_t i = 0; i < m; i++)
        fft->values[i] = i < n ? 1 : 0;
    return fft;
}

void bench_fft_free(bench_fft *fft)
{
    if (!fft)
        return;
    fftw_destroy_plan(fft->forward);
    fftw_destroy_plan(fft->backward);
    fftw_free(fft->values);
    fftw_free(fft->spectrum);
    fftw_free(fft->kernel);
    free(fft);
}

void bench_fft_run(void *data)
{
    bench_fft *fft = data;
    double *restrict s = (double *)fft->spectrum;
    const double *restrict k = (const double *)fft->kernel;
    fftw_execute(fft->forward);
    for (size_t j = 0; j < fft->size + 2; j += 2) {
        double re = s[j] * k[j] - s[j + 1] * k[j + 1];
        s[j + 1] = s[j] * k[j + 1] + s[j + 1] * k[j];
        s[j] = re;
    }
    fftw_execute(fft->backward);
}

#else

bench_fft *bench_fft_plan(size_t n, double D)
{
    (void)n;
    (void)D;
    return NULL;
}

void bench_fft_free(bench_fft *fft)
{
    (void)fft;
}

void bench_fft_run(void *data)
{
    (void)data;
}

#endif
