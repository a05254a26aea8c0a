/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of stresses per step in units of FFT convolutions of the same length
 * (one forward and one backward real transform in double precision), for
 * pressure only and with traction. */
#include <fftw3.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/bench.h"
#include "stress/stress.h"

typedef struct stage {
    size_t capacity;
    double *values;
    fftw_complex *spectrum;
    fftw_plan forward, back;
    double *P, *Q; /* Q = NULL: no traction */
    ovr_stress *stress;
    ovr_material_history *history;
    ovr_moment moment;
} stage;

static void convolve(void *data)
{
    stage *s = data;
    fftw_execute(s->forward);
    fftw_execute(s->back);
    for (size_t k = 0; k < s->capacity; k++)
        s->values[k] /= (double)s->capacity;
}

static void solve(void *data)
{
    stage *s = data;
    ovr_stress_solve(s->stress, s->P, s->Q, 0.3, OVR_STRESS_ALL_LEVELS);
}

/* Computes the stresses of a step. The material window is always below the
 * contact, which is the largest cost. */
static void step(void *data)
{
    stage *s = data;
    s->moment.U = fmod(s->moment.U + s->moment.dU, 0.5);
    ovr_material_history_step(s->history, s->P, s->Q, &s->moment);
}

static void open_stage(stage *s, int level, bool traction)
{
    ovr_error err;
    ovr_stress_options o = ovr_stress_options_default();
    ovr_material_range range = ovr_material_range_default();
    size_t n = (size_t)7 * ((size_t)1 << level) + 1;
    o.nodes = n;
    o.traction = traction;
    o.inlet = -4;
    o.mesh = 5.5 / (double)(n - 1);
    range.reference = -0.25;
    s->moment = (ovr_moment){.dU = o.mesh, .direction = 1};
    s->stress = ovr_stress_create(&o, NULL, &err);
    s->history = ovr_material_history_create(&o, &range, NULL, &err);
    s->P = calloc(n, sizeof *s->P);
    s->Q = traction ? calloc(n, sizeof *s->Q) : NULL;
    for (s->capacity = 256; s->capacity < 9 * (n - 1) / 4; s->capacity *= 2)
        ;
    s->values = fftw_malloc(s->capacity * sizeof *s->values);
    s->spectrum = fftw_malloc((s->capacity / 2 + 1) * sizeof *s->spectrum);
    if (!s->stress || !s->history || !s->P || (traction && !s->Q) ||
        !s->values || !s->spectrum) {
        fprintf(stderr, "no memory\n");
        exit(1);
    }
    for (size_t i = 0; i < n; i++) {
        double X = o.inlet + (double)i * o.mesh;
        s->P[i] = fabs(X) < 1 ? sqrt(1 - X * X) : 0;
        if (s->Q)
            s->Q[i] = 0.05 * s->P[i];
    }
    s->forward = fftw_plan_dft_r2c_1d((int)s->capacity, s->values, s->spectrum,
                                      FFTW_ESTIMATE);
    s->back = fftw_plan_dft_c2r_1d((int)s->capacity, s->spectrum, s->values,
                                   FFTW_ESTIMATE);
    memset(s->values, 0, s->capacity * sizeof *s->values);
}

static void close_stage(stage *s)
{
    fftw_destroy_plan(s->forward);
    fftw_destroy_plan(s->back);
    fftw_free(s->values);
    fftw_free(s->spectrum);
    ovr_stress_free(s->stress);
    ovr_material_history_free(s->history);
    free(s->P);
    free(s->Q);
}

static void measure(int level, bool traction)
{
    stage s;
    open_stage(&s, level, traction);
    bench_work work[] = {{convolve, &s, 0}, {solve, &s, 0}, {step, &s, 0}};
    bench_measure(3, work, 0.02, 15);
    double unit = work[0].seconds;
    printf("%5d %s %8.1f us  %8.1f us = %4.1f of these  %8.1f us = %4.1f\n",
           level, traction ? "P and Q" : "P      ", unit * 1e6,
           work[1].seconds * 1e6, work[1].seconds / unit, work[2].seconds * 1e6,
           work[2].seconds / unit);
    bench_row();
    bench_number("level", level);
    bench_number("traction", traction);
    bench_number("convolution_s", unit);
    bench_number("snapshot_s", work[1].seconds);
    bench_number("step_s", work[2].seconds);
    bench_end();
    close_stage(&s);
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    bench_list("stress");
    puts("level load    convolution     fields of a snapshot       fields and "
         "history");
    for (int level = 7; level <= 10; level++)
        for (int traction = 0; traction < 2; traction++)
            measure(level, traction);
    bench_end();
    bench_close();
    return 0;
}
