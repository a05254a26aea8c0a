/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Stress fields of a snapshot at all depths.
 *
 *     f(X_m, z) = sum_j K_f(X_m - X_j, z) P_j,   f = h, d, tau
 *
 * is a convolution on the mesh: a forward transform of P, a product for each
 * field and depth, and a backward transform. The kernels are sampled, and their
 * Fourier transform is computed: with space for all lags there are no periodic
 * images, and the mean is correct. Deep fields are smooth: for a field whose
 * node spacing can be 2^c D (depths.h), only the first N/2^(c+1) waves are
 * needed. A transform of N/2^c values yields the field at every 2^c-th node; a
 * transform of N values with the same waves yields it at every node
 * (interpolation between nodes with spacing 2^c D would have an error of 2e-3
 * p_h if linear, 3e-4 if cubic).  Two real fields make one complex transform: d
 * + i tau, and h of two depths.
 *
 * Shifted nodes: the factor exp(2 pi i k s/N) shifts the nodes by s in units of
 * D, exactly for all waves on the grid.
 *
 * Cost O(N ln N): about two transforms of full length, for any number of
 * octaves.  Accuracy: 5e-7 p_h of the sums, including floats.
 */
#include "stress/field.h"

#include <math.h>
#include <string.h>

#include "base/given.h"
#include "multigrid/kernels.h"
#include "stress/element.h"
#include "stress/layered.h"
#include "stress/stress.h"

static const double two_pi = 6.28318530717958647693;

/* --------------------------------------------------- instruction sets */

extern const ovr_stress_loops ovr_stress_loops_base, ovr_stress_loops_plain;
#if defined __x86_64__ && !defined OVR_NO_AVX2
extern const ovr_stress_loops ovr_stress_loops_avx2;
#ifndef OVR_NO_AVX512
extern const ovr_stress_loops ovr_stress_loops_avx512;
#endif
#endif

const ovr_stress_loops *ovr_stress_loops_choose(const char *name)
{
    static const ovr_stress_loops *const all[] = {
#if defined __x86_64__ && !defined OVR_NO_AVX2
#ifndef OVR_NO_AVX512
        &ovr_stress_loops_avx512,
#endif
        &ovr_stress_loops_avx2,
#endif
        &ovr_stress_loops_base,
        &ovr_stress_loops_plain
    };
    const ovr_kernels *kernels = ovr_kernels_choose(name);
    for (size_t k = 0; kernels && k < sizeof all / sizeof *all; k++)
        if (!strcmp(all[k]->name, kernels->name))
            return all[k];
    return NULL;
}

/* ------------------------------------------------------------- the tables */

/* Stores a table of N/2^(c+1) + 1 bins from the kernel samples in f->real. */
static ovr_status keep_spectrum(ovr_stress *s, size_t bins, ovr_bins *kept,
                                ovr_error *err)
{
    ovr_fourier *f = &s->fourier;
    float *re = ovr_arena_take(&s->arena, bins + 1, sizeof *re, err);
    float *im = ovr_arena_take(&s->arena, bins + 1, sizeof *im, err);
    if (ovr_arena_status(&s->arena))
        return OVR_NO_MEMORY;
    fftw_execute(f->forward);
    for (size_t k = 0; k <= bins; k++) {
        re[k] = (float)(f->spectrum[k][0] / (double)f->N);
        im[k] = (float)(f->spectrum[k][1] / (double)f->N);
    }
    *kept = (ovr_bins){re, im};
    return OVR_OK;
}

/* Samples at lags that no field needs. They connect the last lag smoothly with
 * the first: a jump would be truncated with the waves and cause oscillations in
 * the field. */
static double seamed(const ovr_stress *s, const double *lag, size_t k)
{
    size_t before = s->capacity - s->seam;
    if (k < before)
        return lag[k];
    double t = ((double)(k - before) + 0.5) / (double)s->seam;
    double first = pow(sin(two_pi / 4 * t), 2);
    return (1 - first) * lag[k] +
           first * lag[(ptrdiff_t)k - (ptrdiff_t)s->capacity];
}

/* The three kernels of a density at a line of lags, stored one after the other.
 */
static void evaluate(double z, bool traction, size_t lags,
                     const ovr_potential *line, double *lag)
{
    const ovr_potential none = {0, 0};
    for (size_t k = 0; k < lags; k++) {
        ovr_in_plane s = traction ? ovr_stress_of(z, none, line[k])
                                  : ovr_stress_of(z, line[k], none);
        lag[k] = s.h;
        lag[lags + k] = s.d;
        lag[2 * lags + k] = s.tau;
    }
}

/* Space for the additions by layers: a transform of four times the length, at
 * the end of which they have decayed. */
enum { WIDER = 4 };
typedef struct layer_capacity {
    size_t n;
    fftw_complex *bins[3];
    double *values;
    fftw_plan plan;
} layer_capacity;

static ovr_status allocate_layers(ovr_arena *scratch, size_t N,
                                  layer_capacity *r, ovr_error *err)
{
    r->n = WIDER * N;
    for (int w = 0; w < 3; w++) {
        r->bins[w] = ovr_arena_take(scratch, r->n / 2 + 1, sizeof **r->bins,
                                    err);
    }
    r->values = ovr_arena_take(scratch, r->n, sizeof *r->values, err);
    if (ovr_arena_status(scratch))
        return OVR_NO_MEMORY;
    return ovr_fourier_real(r->n, r->bins[0], r->values, &r->plan, err);
}

/* A line of lags at one depth, starting at lag `first`: stresses of half-space
 * and layers, three values per lag. */
typedef struct lag_line {
    long first;
    size_t lags;
    ovr_potential *potential;
    double *value;
    layer_capacity layers; /* with a plan if there are layers */
} lag_line;

/* Adds the contribution of layers to the lags at a depth. */
static void add_layers(const ovr_stress *s, const ovr_depth *depth,
                       bool traction, const lag_line *line)
{
    const layer_capacity *r = &line->layers;
    const size_t lags = line->lags;
    const long first = line->first;
    double *lag = line->value;
    const ovr_stress_options *o = &s->options;
    double D = o->mesh;
    const ovr_layered_depth of = ovr_layered_depth_of(
        o->layers, depth->z, D, traction, o->element == OVR_ELEMENT_HAT);
    for (size_t m = 0; m <= r->n / 2; m++) {
        double to[3][2];
        ovr_layered_bin(&of, m, r->n, D * (double)first, to);
        for (int w = 0; w < 3; w++)
            memcpy(r->bins[w][m], to[w], sizeof to[w]);
    }
    for (size_t which = 0; which < 3; which++) {
        fftw_execute_dft_c2r(r->plan, r->bins[which], r->values);
        for (size_t k = 0; k < lags; k++)
            lag[which * lags + k] += r->values[k];
    }
    for (size_t k = 0; k < lags; k++) {
        double to[3] = {0};
        ovr_layered_near(&of, D * (double)(first + (long)k), to);
        for (size_t which = 0; which < 3; which++)
            lag[which * lags + k] += to[which];
    }
}

/* Computes the three kernel spectra of a density at one depth from its line of
 * lags, which starts with those of the transition; lag k has the index k -
 * nodes + 1. */
static ovr_status tabulate(ovr_stress *s, const ovr_depth *depth, bool traction,
                           const lag_line *line, ovr_depth_table *table,
                           ovr_error *err)
{
    size_t N = s->capacity, before = s->options.nodes - 1;
    ovr_bins *kept[] = {&table->h, &table->d, &table->tau};
    evaluate(depth->z, traction, line->lags, line->potential, line->value);
    if (line->layers.plan)
        add_layers(s, depth, traction, line);
    for (size_t which = 0; which < 3; which++) {
        const double *own = line->value + which * line->lags + s->seam;
        for (size_t k = 0; k < N; k++)
            s->fourier.real[(k + N - before) % N] = seamed(s, own, k);
        ovr_status status = keep_spectrum(s, depth->bins, kept[which], err);
        if (status)
            return status;
    }
    return OVR_OK;
}

static ovr_status tabulate_all(ovr_stress *s, ovr_arena *scratch,
                               ovr_error *err)
{
    const ovr_stress_options *o = &s->options;
    lag_line line = {.lags = s->capacity + s->seam};
    line.potential = ovr_arena_take(scratch, line.lags, sizeof *line.potential,
                                    err);
    line.value = ovr_arena_take(scratch, 3 * line.lags, sizeof *line.value,
                                err);
    if (!line.potential || !line.value ||
        (o->layers && allocate_layers(scratch, s->capacity, &line.layers, err)))
        return OVR_NO_MEMORY;
    line.first = lround((s->start - o->inlet) / o->mesh) -
                 (long)(o->nodes - 1 + s->seam);
    ovr_status status = OVR_OK;
    for (size_t j = 0; !status && j < s->depths; j++) {
        ovr_depth *depth = &s->depth[j];
        ovr_element_line(o->element, o->mesh, depth->z, line.first, line.lags,
                         line.potential);
        status = tabulate(s, depth, false, &line, &depth->p, err);
        if (!status && o->traction)
            status = tabulate(s, depth, true, &line, &depth->q, err);
    }
    ovr_fourier_forget(line.layers.plan);
    return status;
}

/* --------------------------------------------------------------- creation */

static ovr_status allocate_depth(ovr_stress *s, size_t j, ovr_error *err)
{
    ovr_depth *depth = &s->depth[j];
    depth->z = s->z[j];
    depth->level = ovr_depth_level(&s->options, depth->z);
    size_t n = s->capacity >> depth->level;
    depth->bins = n / 2;
    depth->shear = ovr_arena_take(&s->arena, 2 * n, sizeof(float), err);
    if (!depth->shear)
        return OVR_NO_MEMORY;
    if (j > 0 && s->depth[j - 1].pair && s->depth[j - 1].other == j - 1 &&
        s->depth[j - 1].level == depth->level) {
        s->depth[j - 1].other = j;
        depth->mean = s->depth[j - 1].mean + 1;
        return OVR_OK;
    }
    depth->pair = ovr_arena_take(&s->arena, 2 * n, sizeof(float), err);
    depth->mean = depth->pair;
    depth->other = j;
    return depth->pair ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status allocate_arrays(ovr_stress *s, ovr_error *err)
{
    ovr_fourier *f = &s->fourier;
    size_t N = s->capacity;
    f->N = N;
    f->real = ovr_arena_take(&s->arena, N, sizeof *f->real, err);
    f->spectrum = ovr_arena_take(&s->arena, N / 2 + 1, sizeof *f->spectrum,
                                 err);
    f->waves = ovr_arena_take(&s->arena, N, sizeof *f->waves, err);
    f->values = ovr_arena_take(&s->arena, N, sizeof *f->values, err);
    s->z = ovr_arena_take(&s->arena, s->depths, sizeof *s->z, err);
    s->depth = ovr_arena_take(&s->arena, s->depths, sizeof *s->depth, err);
    for (int part = 0; part < 2; part++) {
        s->p[part] = ovr_arena_take(&s->arena, N / 2 + 1, sizeof(float), err);
        s->q[part] = ovr_arena_take(&s->arena, N / 2 + 1, sizeof(float), err);
    }
    return ovr_arena_status(&s->arena);
}

/* Uses the given depths, or (z NULL) those of the options. */
static ovr_status prepare(ovr_stress *s, size_t depths, const double *z,
                          ovr_error *err)
{
    const ovr_stress_options *o = &s->options;
    s->capacity = ovr_stress_capacity(o);
    s->depths = z ? depths : ovr_depths(o, NULL);
    s->start = o->inlet + ceil((o->from - o->inlet) / o->mesh - 1e-9) * o->mesh;
    s->seam = s->capacity - o->nodes - ovr_stress_nodes(o);
    s->loops = ovr_stress_loops_choose(NULL);
    if (allocate_arrays(s, err))
        return OVR_NO_MEMORY;
    if (z)
        memcpy(s->z, z, depths * sizeof *z);
    else
        ovr_depths(o, s->z);
    ovr_status status = ovr_fourier_plan(&s->fourier, err);
    for (size_t j = 0; !status && j < s->depths; j++)
        status = allocate_depth(s, j, err);
    if (status)
        return status;
    ovr_arena scratch = ovr_arena_make(&s->arena.allocator);
    status = tabulate_all(s, &scratch, err);
    ovr_arena_release(&scratch);
    return status;
}

ovr_stress *ovr_stress_create(const ovr_stress_options *options,
                              const ovr_allocator *allocator, ovr_error *err)
{
    return ovr_stress_create_at(options, 0, NULL, allocator, err);
}

ovr_stress *ovr_stress_create_at(const ovr_stress_options *options,
                                 size_t depths, const double *z,
                                 const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_stress_options own;
    if (OVR_TAKE(ovr_stress_options, &own, options, err) ||
        ovr_stress_check(&own, err))
        return NULL;
    ovr_stress *s = ovr_arena_take(&arena, 1, sizeof *s, err);
    if (!s)
        return NULL;
    s->arena = arena;
    s->options = own;
    if (prepare(s, depths, z, err)) {
        ovr_stress_free(s);
        return NULL;
    }
    return s;
}

void ovr_stress_free(ovr_stress *s)
{
    if (!s)
        return;
    ovr_fourier_drop(&s->fourier);
    ovr_arena arena = s->arena;
    ovr_arena_release(&arena);
}

double ovr_stress_memory(const ovr_stress_options *given)
{
    ovr_stress_options own, *o = &own;
    if (OVR_TAKE(ovr_stress_options, o, given, NULL) ||
        ovr_stress_check(o, NULL))
        return NAN;
    double N = (double)ovr_stress_capacity(o),
           bytes = N * (8 + 8 + 8 + 8 + 8 + 8);
    size_t depths = ovr_depths(o, NULL);
    double minimum = o->depth_min > 0 ? o->depth_min : 4 * o->mesh;
    for (size_t j = 0; j < depths; j++) {
        double z = minimum * exp2((double)j / o->per_octave);
        double n = ldexp(N, -ovr_depth_level(o, z));
        bytes += n * (8 + 8) + (o->traction ? 2 : 1) * 3 * 4 * n;
    }
    return bytes;
}

size_t ovr_stress_depths(const ovr_stress *s, const double **z)
{
    if (!s)
        return 0;
    if (z)
        *z = s->z;
    return s->depths;
}

/* -------------------------------------------------------------- the solve */

/* Computes the spectrum of v, shifted by `shift` in units of D, in floats. The
 * phase factor is obtained by multiplication for 64 bins and then computed
 * again. */
static void transform(ovr_stress *s, const double *v, double shift, float **to)
{
    ovr_fourier *f = &s->fourier;
    size_t n = s->options.nodes, half = f->N / 2;
    memcpy(f->real, v, n * sizeof *v);
    memset(f->real + n, 0, (f->N - n) * sizeof *v);
    fftw_execute(f->forward);
    double angle = two_pi * shift / (double)f->N;
    double c1 = cos(angle), s1 = sin(angle), c = 1, t = 0;
    for (size_t k = 0; k <= half; k++) {
        if (k % 64 == 0) {
            c = cos(angle * (double)k);
            t = sin(angle * (double)k);
        }
        double re = f->spectrum[k][0], im = f->spectrum[k][1], next;
        to[0][k] = (float)(c * re - t * im);
        to[1][k] = (float)(c * im + t * re);
        next = c * c1 - t * s1;
        t = c * s1 + t * c1;
        c = next;
    }
    to[1][half] = 0; /* wave with the Nyquist frequency of the mesh */
}

/* Wave 0 and the last wave, which are real. */
static void spread_ends(const ovr_depth *depth, const ovr_load_bins *load,
                        size_t loads, float *waves)
{
    size_t last = depth->bins, ends[] = {0, last};
    for (size_t k = 0; k < 2; k++) {
        float a = 0, b = 0;
        bool cut = k == 1 && depth->level > 0;
        for (size_t l = 0; l < loads && !cut; l++) {
            a += load[l].A.re[ends[k]] * load[l].P.re[ends[k]];
            b += load[l].B.re[ends[k]] * load[l].P.re[ends[k]];
        }
        waves[2 * ends[k]] = a;
        waves[2 * ends[k] + 1] = b;
    }
}

/* Writes the waves of a depth for a transform of n values; other waves are
 * zero. */
static void spread(ovr_stress *s, const ovr_depth *depth, size_t n,
                   const ovr_load_bins *load, size_t loads)
{
    float *waves = (float *)s->fourier.waves;
    size_t bins = depth->bins;
    memset(waves + 2 * bins, 0, 2 * (n - 2 * bins) * sizeof *waves);
    spread_ends(depth, load, loads, waves);
    s->loops->spread(bins, n, load, loads, waves);
}

/* Computes two real fields from the tables of each density. */
static void solve_pair(ovr_stress *s, const ovr_depth *depth, int level,
                       const ovr_load_bins load[2], float *to)
{
    spread(s, depth, s->capacity >> level, load, s->loads);
    ovr_fourier_back(&s->fourier, level, to);
}

static void solve_shear(ovr_stress *s, const ovr_depth *depth, int level,
                        float *to)
{
    const ovr_bins p = {s->p[0], s->p[1]}, q = {s->q[0], s->q[1]};
    solve_pair(s, depth, level,
               (ovr_load_bins[]){{p, depth->p.d, depth->p.tau},
                                 {q, depth->q.d, depth->q.tau}},
               to);
}

static void solve_mean(ovr_stress *s, const ovr_depth *depth,
                       const ovr_depth *other, int level, float *to)
{
    const ovr_bins p = {s->p[0], s->p[1]}, q = {s->q[0], s->q[1]};
    solve_pair(s, depth, level,
               (ovr_load_bins[]){{p, depth->p.h, other->p.h},
                                 {q, depth->q.h, other->q.h}},
               to);
}

static void solve_depth(ovr_stress *s, const ovr_depth *depth)
{
    solve_shear(s, depth, depth->level, depth->shear);
    if (depth->pair)
        solve_mean(s, depth, &s->depth[depth->other], depth->level,
                   depth->pair);
}

void ovr_stress_solve(ovr_stress *s, const double *P, const double *Q,
                      double shift, unsigned levels)
{
    if (!s || !P)
        return;
    s->loads = Q && s->options.traction ? 2 : 1;
    s->shift = shift;
    transform(s, P, shift, s->p);
    if (s->loads > 1)
        transform(s, Q, shift, s->q);
    for (size_t j = 0; j < s->depths; j++)
        if (levels >> s->depth[j].level & 1)
            solve_depth(s, &s->depth[j]);
}

/* Row of a depth's nodes with spacing 2^level D, as far as needed for a shift.
 */
static ovr_stress_row row_of(const ovr_stress *s, const ovr_depth *depth,
                             int level, const float *shear, const float *mean)
{
    double D = s->options.mesh;
    double last = (double)(ovr_stress_nodes(&s->options) - 1);
    double step = ldexp(1, level);
    return (ovr_stress_row){depth->z,
                            level,
                            s->start + s->shift * D,
                            step * D,
                            1 + (size_t)floor(last / step),
                            shear,
                            mean};
}

ovr_stress_row ovr_stress_at(const ovr_stress *s, size_t j)
{
    if (!s)
        return (ovr_stress_row){0};
    const ovr_depth *depth = &s->depth[j];
    return row_of(s, depth, depth->level, depth->shear, depth->mean);
}

ovr_status ovr_stress_at_every_node(ovr_stress *s, size_t j,
                                    ovr_stress_row *row, ovr_error *err)
{
    if (!s || !row)
        return ovr_fail_null(err, __func__);
    const ovr_depth *depth = &s->depth[j];
    for (size_t k = 0; k < 2 && depth->level > 0; k++)
        if (!s->fine[k] &&
            !(s->fine[k] = ovr_arena_take(&s->arena, 2 * s->capacity,
                                          sizeof(float), err)))
            return OVR_NO_MEMORY;
    if (depth->level > 0) {
        solve_shear(s, depth, 0, s->fine[0]);
        solve_mean(s, depth, depth, 0, s->fine[1]);
        *row = row_of(s, depth, 0, s->fine[0], s->fine[1]);
    } else
        *row = ovr_stress_at(s, j);
    return OVR_OK;
}
