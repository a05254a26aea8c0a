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
    double seconds; /* of one call: the result */
} bench_work;

/* Sorts the values. */
double bench_median(size_t count, double values[]);

/* Every round runs each piece of work for `minimum` seconds or once. */
void bench_measure(size_t count, bench_work work[], double minimum, int rounds);

/* JSON: one document, written to the path that the program was given. */
void bench_open(int argc, char *argv[]);
void bench_list(const char *name); /* "name": [ */
void bench_row(void);              /* { */
void bench_text(const char *name, const char *value);
void bench_number(const char *name, double value); /* null when not finite */
void bench_end(void); /* closes the innermost list or row */
void bench_close(void);

/* M = 20, L = 10 on [-4, 1.5], the second-order scheme. */
ovr_simulation *bench_contact(int level, ovr_scheme scheme, ovr_stop stop);

/* The reference dent of the simulation: depth 0.1, width 0.5, rolling from
 * X = `start`; its wings end at 1e-18. */
typedef struct bench_dent {
    double start;
} bench_dent;
void bench_dent_heights(void *dent, double T, size_t n, const double *X,
                        double *S);

/* Instruction sets by name, best first, NULL at the end; those that this
 * machine lacks are to be passed over. */
extern const char *const bench_sets[];

/* Flops a second of multiply-adds from registers, and bytes a second of a
 * triad over so many bytes (two arrays read, one written), on this core. */
double bench_lanes(const char *set); /* doubles of a vector */
double bench_peak_flops(const char *set);
double bench_bandwidth(size_t bytes);

/* One convolution with the deformation kernel of n nodes by FFTW (real
 * transforms, kernel transformed once, the best 2-3-5-7 size at least 2 n,
 * FFTW_MEASURE): what others pay for one evaluation of the deformation. */
typedef struct bench_fft bench_fft;
bench_fft *bench_fft_plan(size_t n, double D); /* NULL without FFTW */
void bench_fft_free(bench_fft *fft);
void bench_fft_run(void *fft);

#endif
