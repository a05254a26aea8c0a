/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Timing, and measured values as a JSON file. Compared pieces of work are run
 * alternately, so that a machine that slows down affects all of them. A time is
 * CPU time of this thread, the median over the rounds. No test passes or fails
 * because of a time. */
#ifndef TESTS_BENCH_BENCH_H
#define TESTS_BENCH_BENCH_H

#include <stddef.h>

#include "support/contact.h"

typedef struct bench_work {
    void (*run)(void *data);
    void *data;
    double seconds; /* result: time of one call */
} bench_work;

/* Returns the median and sorts the values. */
double bench_median(size_t count, double values[]);

/* Runs each piece of work in every round, for `minimum` seconds or once. */
void bench_measure(size_t count, bench_work work[], double minimum, int rounds);

/* Write one JSON document to the path in the program's argument. */
void bench_open(int argc, char *argv[]);
void bench_list(const char *name); /* "name": [ */
void bench_row(void);              /* { */
void bench_text(const char *name, const char *value);
void bench_number(const char *name, double value); /* null if not finite */
void bench_end(void); /* closes the innermost list or row */
void bench_close(void);

/* Creates a simulation with M = 20, L = 10 on [-4, 1.5] of second order. */
ovr_simulation *bench_contact(int level, ovr_scheme scheme, ovr_stop stop);

/* Reference dent: depth 0.1, width 0.5, rolling from X = `start`. Heights below
 * 1e-18 are 0. */
typedef struct bench_dent {
    double start;
} bench_dent;
void bench_dent_heights(void *dent, double T, size_t n, const double *X,
                        double *S);

/* Names of instruction sets, fastest first, NULL at the end. Callers must omit
 * those that this machine does not have. */
extern const char *const bench_sets[];

/* Measure the peak performance of this core: multiply-adds in registers (flops
 * per second), and a triad on arrays of `bytes` in total (bytes per second).
 * bench_lanes returns the number of doubles in a vector. */
double bench_lanes(const char *set);
double bench_peak_flops(const char *set);
double bench_bandwidth(size_t bytes);

/* Convolution with the deformation kernel of n nodes by FFTW, the usual cost of
 * a deformation in other programs. Transforms are real, and the kernel is
 * transformed once. The size is the smallest of at least 2 n with factors 2, 3,
 * 5 and 7; FFTW_MEASURE. */
typedef struct bench_fft bench_fft;
bench_fft *bench_fft_plan(size_t n, double D); /* NULL without FFTW */
void bench_fft_free(bench_fft *fft);
void bench_fft_run(void *fft);

#endif
