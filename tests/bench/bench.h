/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Time, and what was measured as a JSON file.
 *
 * Pieces of work that are compared take turns, so that a machine that slows
 * down slows them all; each time is CPU time of this thread, the median over
 * the rounds.  No timing decides whether anything passes.
 */
#ifndef TESTS_BENCH_BENCH_H
#define TESTS_BENCH_BENCH_H

#include <stddef.h>

#include "support/contact.h"

typedef struct bench_work {
    void (*run)(void *data);
    void *data;
    double seconds; /* of one call: the result */
} bench_work;

/* Every round runs each piece of work for `least` seconds or once. */
void bench_measure(size_t count, bench_work work[], double least, int rounds);

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

/* One convolution with the deformation kernel of n nodes by FFTW (real
 * transforms, kernel transformed once, the best 2-3-5-7 size at least 2 n,
 * FFTW_MEASURE): what others pay for one evaluation of the deformation. */
typedef struct bench_fft bench_fft;
bench_fft *bench_fft_plan(size_t n, double D); /* NULL without FFTW */
void bench_fft_free(bench_fft *fft);
void bench_fft_run(void *fft);

#endif
