/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Plastic strains of a window in layers, and the resulting residual stresses:
 *
 *     s^(k) = A(k) e^(k),  mean over the receiving layer   (plastic.c)
 *     w^(k) = B(k) e^(k),  k > 0
 *
 * A(k) is a matrix (3 stresses times layers by 3 strains times layers) for each
 * wave of the period, computed once. Stresses are always computed from the
 * total strains, not from increments, so that the strains define the state. The
 * influence between layers is neglected if the wave decays by e^-36 between
 * them.  sigma_y is local: sy = nu (sx + sz) + (1 - nu^2)(e_x + e_z).
 */
#include "stress/yielding.h"

#include <math.h>
#include <string.h>

#include "base/arena.h"
#include "stress/fourier.h"

/* --------------------------------------------- waves of the residual stress */

/*
 * Plane plastic strains e_x, e_z, e_xz = -i s, e_y = -e_x - e_z, of waves e^ikx
 * in a half plane z > 0 with a free surface, in units of p_h/E*.  With
 *
 *     X = (1 - nu) e_x - nu e_z,  Z = (1 - nu) e_z - nu e_x
 *     sx = -[G22 X - k^2 G20 Z + 2 k G21 s]
 *     sz = k^2 [G02 X - k^2 G00 Z + 2 k G01 s]
 *     t = k [G12 X - k^2 G10 Z + 2 k G11 s],  tau_xz = i t
 *     sy = nu (sx + sz) + (1 - nu^2)(e_x + e_z)
 *     Gmn = int d^m/dz^m d^n/dzeta^n G(z, zeta) dzeta
 *     G = g(z - zeta) - [1 + k(z + zeta) + 2 k^2 z zeta] e^-k(z+zeta)/4 k^3
 *     g(d) = (1 + a) e^-a/4 k^3,  a = k|d|
 *
 * G is the biharmonic Green's function of Airy's stress that vanishes with its
 * slope on the surface (T. Mura, Micromechanics of Defects in Solids, 1987,
 * defines eigenstrains).  All terms are derivatives or antiderivatives of g and
 * of (linear) e^-kz times (linear) e^-kzeta. Integrals over the strained layer
 * and means over the receiving layer are therefore exact differences at their
 * ends. With means the operator is symmetric, with eigenvalues in [-2G, 0);
 * with values at the middle of layers it has positive eigenvalues, and plastic
 * flow grows without bound.
 *
 * The surface displacement follows from reciprocity with a unit load on the
 * surface:
 *     w = int e^-kz [-(1 - kz) e_x - (1 + kz) e_z - 2 nu e_y - 2 kz s] dz
 */

/* Derivatives of g of order -2 ... 3 divided by k^(order - 3), at a = k d of
 * either sign. Linear terms of the antiderivatives are included, constants are
 * not. */
static double whole_space(int order, double a)
{
    double sign = a < 0 ? -1 : 1, m = fabs(a), e = exp(-m);
    switch (order) {
    case -2: return (2 * m + (3 + m) * e) / 4;
    case -1: return sign * (2 - (2 + m) * e) / 4;
    case 0: return (1 + m) * e / 4;
    case 1: return -a * e / 4;
    case 2: return -(1 - m) * e / 4;
    default: return sign * (2 - m) * e / 4;
    }
}

/* (c + d u) e^-u, its derivative of order -1 ... 2. */
static void derive(int order, double *c, double *d)
{
    for (; order > 0; order--) {
        *c = *d - *c;
        *d = -*d;
    }
    if (order < 0) {
        *c = -(*c + *d);
        *d = -*d;
    }
}

/* Derivatives of order p in u = kz and q in v = k zeta of
 * [1 + u + v + 2 u v] e^-(u + v). */
static double image(int p, int q, double u, double v)
{
    double c0 = 1, d0 = 1, c1 = 1, d1 = 2; /* (c0 + d0 u) + (c1 + d1 u) v */
    derive(p, &c0, &d0);
    derive(p, &c1, &d1);
    double c = c0 + d0 * u, d = c1 + d1 * u;
    derive(q, &c, &d);
    return (c + d * v) * exp(-u - v);
}

/* Gmn over k^(m + n - 4) at u, by its antiderivative in z where `less` is 1
 * (over k^(m + n - 5)). */
static double influence(int m, int n, int less, double u, const double v[2])
{
    double sum = 0, odd = n % 2 ? -1 : 1;
    for (int end = 0; end < 2; end++) {
        double side = end ? 1 : -1;
        sum -= side * (odd * whole_space(m + n - 1 - less, u - v[end]) +
                       image(m - less, n - 1, u, v[end]) / 4);
    }
    return sum;
}

typedef struct influences {
    double of[3][3];
} influences;

static ovr_residual_stress stress(const influences *g, double poisson,
                                  ovr_plastic_strain e)
{
    double X = (1 - poisson) * e.x - poisson * e.z;
    double Z = (1 - poisson) * e.z - poisson * e.x;
    ovr_residual_stress s;
    s.x = -(g->of[2][2] * X - g->of[2][0] * Z + 2 * g->of[2][1] * e.xz);
    s.z = g->of[0][2] * X - g->of[0][0] * Z + 2 * g->of[0][1] * e.xz;
    s.xz = g->of[1][2] * X - g->of[1][0] * Z + 2 * g->of[1][1] * e.xz;
    s.y = poisson * (s.x + s.z);
    return s;
}

/* Local change of stresses by a strain, which does not affect equilibrium along
 * x and z, over a fraction of the layer. */
static double across(double poisson, ovr_plastic_strain e, double share)
{
    return share * (1 - poisson * poisson) * (e.x + e.z);
}

/* k = 0: the strain is constrained along x only. */
static ovr_residual_stress uniform(double poisson, ovr_plastic_strain e,
                                   double share)
{
    ovr_residual_stress s = {0};
    s.x = -share * ((1 - poisson) * e.x - poisson * e.z);
    s.y = poisson * s.x + across(poisson, e, share);
    return s;
}

ovr_residual_stress ovr_residual_at(double k, double poisson,
                                    ovr_strained_layer source,
                                    ovr_plastic_strain strain, double z)
{
    double share = z > source.top && z < source.bottom;
    if (k == 0)
        return uniform(poisson, strain, share);
    const double v[] = {k * source.top, k * source.bottom};
    influences g;
    for (int m = 0; m < 3; m++)
        for (int n = 0; n < 3; n++)
            g.of[m][n] = influence(m, n, 0, k * z, v);
    ovr_residual_stress s = stress(&g, poisson, strain);
    s.y += across(poisson, strain, share);
    return s;
}

ovr_residual_stress ovr_residual_mean(double k, double poisson,
                                      ovr_strained_layer source,
                                      ovr_plastic_strain strain,
                                      ovr_strained_layer receiver)
{
    double height = receiver.bottom - receiver.top;
    double common = fmin(source.bottom, receiver.bottom) -
                    fmax(source.top, receiver.top);
    double share = fmax(common, 0) / height;
    if (k == 0)
        return uniform(poisson, strain, share);
    const double v[] = {k * source.top, k * source.bottom};
    influences g;
    for (int m = 0; m < 3; m++)
        for (int n = 0; n < 3; n++)
            g.of[m][n] = (influence(m, n, 1, k * receiver.bottom, v) -
                          influence(m, n, 1, k * receiver.top, v)) /
                         (k * height);
    ovr_residual_stress s = stress(&g, poisson, strain);
    s.y += across(poisson, strain, share);
    return s;
}

double ovr_plastic_sinking(double k, double poisson, ovr_strained_layer source,
                           ovr_plastic_strain strain)
{
    double u = k * source.top, v = k * source.bottom;
    double plain = (exp(-u) - exp(-v)) / k;                      /* e^-kz */
    double sloped = ((1 + u) * exp(-u) - (1 + v) * exp(-v)) / k; /* kz e^-kz */
    double y = -strain.x - strain.z;
    return -(plain - sloped) * strain.x - (plain + sloped) * strain.z -
           2 * poisson * plain * y - 2 * sloped * strain.xz;
}

enum { PARTS = 3, STATE = 4 };
static const double farthest = 36, enough = 1e-3;

struct ovr_yielding {
    ovr_arena arena;
    ovr_yielding_options options;
    size_t waves;      /* points/2 + 1 */
    double **table;    /* for each wave: source, its component, receiver, its
                        * component */
    double **sinking;  /* for each wave: source, its component */
    unsigned *reach;   /* for each wave and source: first receiver, and last + 1
                        */
    double **strain;   /* for each layer: x, z, xz, all */
    double **residual; /* for each layer: x, z, xz */
    bool *strained;
    double *w;
    ovr_layer_load *load;
    fftw_plan forward, back;
    double *values;      /* real values of one transform */
    fftw_complex *bins;  /* bins of one transform */
    fftw_complex *e, *s; /* strains and stresses of all layers */
    double *sum;         /* sum for one wave */
    double reserve;      /* value of ovr_yielding_reserve */
    bool reserve_known;
};

void ovr_yielding_layers(size_t layers, double first, double depth,
                         double *edge)
{
    double low = 1, high = 4, n = (double)layers;
    for (int step = 0; step < 40; step++) {
        double r = (low + high) / 2;
        double whole = first * (pow(r, n) - 1) / (r - 1);
        *(whole < depth ? &low : &high) = r;
    }
    edge[0] = 0;
    for (size_t j = 0; j < layers; j++)
        edge[j + 1] = edge[j] + first * pow(low, (double)j);
    for (size_t j = 1; j <= layers; j++)
        edge[j] *= depth / edge[layers];
}

static double wave_number(const ovr_yielding_options *o, size_t m)
{
    return 2 * acos(-1.0) * (double)m / ((double)o->points * o->mesh);
}

static ovr_strained_layer layer_at(const ovr_yielding_options *o, size_t j)
{
    return (ovr_strained_layer){o->edge[j], o->edge[j + 1]};
}

/* First layer affected by a strain of layer j, and last + 1. */
static void find_reach(const ovr_yielding_options *o, double k, size_t j,
                       unsigned reach[2])
{
    size_t from = j, to = j + 1;
    while (from > 0 && k * (o->edge[j] - o->edge[from]) < farthest)
        from--;
    while (to < o->layers && k * (o->edge[to] - o->edge[j + 1]) < farthest)
        to++;
    reach[0] = (unsigned)from;
    reach[1] = (unsigned)to;
}

/* ------------------------------------------------------------------ tables */

static const ovr_plastic_strain unit[PARTS] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* Stores the rows of a source one after the other, for the affected layers
 * only. */
static ovr_status make_wave(ovr_yielding *y, size_t m, ovr_error *err)
{
    const ovr_yielding_options *o = &y->options;
    unsigned *reach = y->reach + 2 * m * o->layers;
    double k = wave_number(o, m), *to;
    size_t values = 0;
    for (size_t j = 0; j < o->layers; j++) {
        find_reach(o, k, j, reach + 2 * j);
        values += PARTS * PARTS * (reach[2 * j + 1] - reach[2 * j]);
    }
    y->table[m] = to = ovr_arena_take(&y->arena, values, sizeof *to, err);
    y->sinking[m] = ovr_arena_take(&y->arena, PARTS * o->layers,
                                   sizeof **y->sinking, err);
    if (ovr_arena_status(&y->arena))
        return OVR_NO_MEMORY;
    for (size_t j = 0; j < o->layers; j++) {
        ovr_strained_layer source = layer_at(o, j);
        for (int c = 0; c < PARTS; c++) {
            y->sinking[m][PARTS * j + (size_t)c] =
                m == 0 ? 0
                       : ovr_plastic_sinking(k, o->poisson, source, unit[c]);
            for (size_t r = reach[2 * j]; r < reach[2 * j + 1]; r++) {
                ovr_residual_stress s = ovr_residual_mean(
                    k, o->poisson, source, unit[c], layer_at(o, r));
                *to++ = s.x;
                *to++ = s.z;
                *to++ = s.xz;
            }
        }
    }
    return OVR_OK;
}

static ovr_status make_tables(ovr_yielding *y, ovr_error *err)
{
    size_t layers = y->options.layers;
    y->table = ovr_arena_take(&y->arena, y->waves, sizeof *y->table, err);
    y->sinking = ovr_arena_take(&y->arena, y->waves, sizeof *y->sinking, err);
    y->reach = ovr_arena_take(&y->arena, 2 * layers * y->waves,
                              sizeof *y->reach, err);
    ovr_status status = ovr_arena_status(&y->arena);
    for (size_t m = 0; !status && m < y->waves; m++)
        status = make_wave(y, m, err);
    return status;
}

/* --------------------------------------------------------------- creation */

static void allocate_layer(ovr_yielding *y, size_t j, ovr_error *err)
{
    size_t n = y->options.points;
    ovr_layer_load *load = &y->load[j];
    y->strain[j] = ovr_arena_take(&y->arena, STATE * n, sizeof(double), err);
    y->residual[j] = ovr_arena_take(&y->arena, PARTS * n, sizeof(double), err);
    load->h = ovr_arena_take(&y->arena, n, sizeof(float), err);
    load->d = ovr_arena_take(&y->arena, n, sizeof(float), err);
    load->tau = ovr_arena_take(&y->arena, n, sizeof(float), err);
}

static ovr_status allocate_arrays(ovr_yielding *y, ovr_error *err)
{
    size_t layers = y->options.layers, n = y->options.points;
    size_t bins = PARTS * layers * y->waves;
    y->strain = ovr_arena_take(&y->arena, layers, sizeof *y->strain, err);
    y->residual = ovr_arena_take(&y->arena, layers, sizeof *y->residual, err);
    y->strained = ovr_arena_take(&y->arena, layers, sizeof *y->strained, err);
    y->load = ovr_arena_take(&y->arena, layers, sizeof *y->load, err);
    y->w = ovr_arena_take(&y->arena, n, sizeof *y->w, err);
    y->values = ovr_arena_take(&y->arena, n, sizeof *y->values, err);
    y->bins = ovr_arena_take(&y->arena, y->waves, sizeof *y->bins, err);
    y->e = ovr_arena_take(&y->arena, bins, sizeof *y->e, err);
    y->s = ovr_arena_take(&y->arena, bins, sizeof *y->s, err);
    y->sum = ovr_arena_take(&y->arena, 2 * PARTS * layers, sizeof *y->sum, err);
    for (size_t j = 0; !ovr_arena_status(&y->arena) && j < layers; j++)
        allocate_layer(y, j, err);
    return ovr_arena_status(&y->arena);
}

ovr_yielding *ovr_yielding_create(const ovr_yielding_options *options,
                                  const ovr_allocator *allocator,
                                  ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_yielding *y = ovr_arena_take(&arena, 1, sizeof *y, err);
    if (!y)
        return NULL;
    y->arena = arena;
    y->options = *options;
    if (!(options->enough > 0))
        y->options.enough = enough;
    y->waves = options->points / 2 + 1;
    double *edge = ovr_arena_take(&y->arena, options->layers + 1, sizeof *edge,
                                  err);
    if (edge)
        memcpy(edge, options->edge, (options->layers + 1) * sizeof *edge);
    y->options.edge = edge;
    if (edge && !allocate_arrays(y, err) &&
        !ovr_fourier_real(options->points, y->bins, y->values, &y->back, err) &&
        !ovr_fourier_bins(options->points, y->values, y->bins, &y->forward,
                          err) &&
        !make_tables(y, err))
        return y;
    ovr_yielding_free(y);
    return NULL;
}

void ovr_yielding_free(ovr_yielding *y)
{
    if (!y)
        return;
    ovr_fourier_forget(y->forward);
    ovr_fourier_forget(y->back);
    ovr_arena arena = y->arena;
    ovr_arena_release(&arena);
}

double ovr_yielding_memory(const ovr_yielding_options *o)
{
    double n = (double)o->points, layers = (double)o->layers, bytes = 0;
    bytes += layers * n * ((STATE + PARTS) * 8 + 3 * 4);
    bytes += 2 * PARTS * layers * (n / 2 + 1) * 16;
    for (size_t m = 0; m <= o->points / 2; m++)
        for (size_t j = 0; j < o->layers; j++) {
            unsigned reach[2];
            find_reach(o, wave_number(o, m), j, reach);
            bytes += PARTS * PARTS * 8. * (reach[1] - reach[0]);
        }
    return bytes;
}

/* ------------------------------------------------------------ equilibrium */

/* Computes the waves of a layer's strains, divided by the number of points. */
static void transform_layer(ovr_yielding *y, size_t j)
{
    size_t n = y->options.points;
    double share = 1 / (double)n;
    for (size_t c = 0; c < PARTS; c++) {
        fftw_complex *to = y->e + (PARTS * j + c) * y->waves;
        memcpy(y->values, y->strain[j] + c * n, n * sizeof *y->values);
        fftw_execute_dft_r2c(y->forward, y->values, y->bins);
        for (size_t m = 0; m < y->waves; m++) {
            to[m][0] = share * y->bins[m][0];
            to[m][1] = share * y->bins[m][1];
        }
    }
}

/* Adds the product of a table row and an amplitude. */
static void join(size_t n, const double *row, double re, double im,
                 double *restrict sum_re, double *restrict sum_im)
{
    for (size_t i = 0; i < n; i++) {
        sum_re[i] += row[i] * re;
        sum_im[i] += row[i] * im;
    }
}

/* One wave: e_xz = -i s, tau = i t. */
static void solve_wave(ovr_yielding *y, size_t m, size_t layers)
{
    const ovr_yielding_options *o = &y->options;
    const unsigned *reach = y->reach + 2 * m * o->layers;
    const double *table = y->table[m], *sinks = y->sinking[m];
    size_t rows = PARTS * o->layers;
    double *re = y->sum, *im = y->sum + rows, w[2] = {0, 0};
    memset(y->sum, 0, 2 * rows * sizeof *y->sum);
    for (size_t j = 0; j < o->layers; j++) {
        size_t n = PARTS * (reach[2 * j + 1] - reach[2 * j]);
        size_t at = PARTS * (size_t)reach[2 * j], maximum = PARTS * layers;
        size_t some = at >= maximum ? 0 : at + n > maximum ? maximum - at : n;
        for (size_t c = 0; y->strained[j] && c < PARTS; c++) {
            const double *e = y->e[(PARTS * j + c) * y->waves + m];
            double a = c == 2 ? -e[1] : e[0], b = c == 2 ? e[0] : e[1];
            join(some, table + c * n, a, b, re + at, im + at);
            w[0] += sinks[PARTS * j + c] * a;
            w[1] += sinks[PARTS * j + c] * b;
        }
        table += PARTS * n;
    }
    for (size_t r = 0; r < PARTS * layers; r++) {
        double *s = y->s[r * y->waves + m];
        s[0] = r % PARTS == 2 ? -im[r] : re[r];
        s[1] = r % PARTS == 2 ? re[r] : im[r];
    }
    y->bins[m][0] = w[0];
    y->bins[m][1] = w[1];
}

/* Computes the surface displacement, which is zero at the ends of the window.
 */
static void sink(ovr_yielding *y)
{
    fftw_execute_dft_c2r(y->back, y->bins, y->values);
    for (size_t i = 0; i < y->options.points; i++)
        y->w[i] = y->values[i] - y->values[0];
}

/* Computes equilibrium and the stresses of the first `layers` layers. */
static void equilibrate(ovr_yielding *y, size_t layers)
{
    size_t n = y->options.points;
    for (size_t j = 0; j < y->options.layers; j++)
        if (y->strained[j])
            transform_layer(y, j);
    for (size_t m = 0; m < y->waves; m++)
        solve_wave(y, m, layers);
    sink(y);
    for (size_t r = 0; r < PARTS * layers; r++) {
        memcpy(y->bins, y->s + r * y->waves, y->waves * sizeof *y->bins);
        fftw_execute_dft_c2r(y->back, y->bins, y->values);
        memcpy(y->residual[r / PARTS] + r % PARTS * n, y->values,
               n * sizeof *y->values);
    }
}

/* -------------------------------------------------------------------- flow */

ovr_layer_load *ovr_yielding_load(ovr_yielding *y, size_t layer)
{
    return &y->load[layer];
}

ovr_strained ovr_yielding_strain(const ovr_yielding *y, size_t layer, size_t i)
{
    size_t n = y->options.points;
    const double *e = y->strain[layer] + i;
    return (ovr_strained){e[0], e[n], e[2 * n], e[3 * n]};
}

ovr_stressed ovr_yielding_residual(const ovr_yielding *y, size_t layer,
                                   size_t i)
{
    size_t n = y->options.points;
    double nu = y->options.poisson;
    const double *s = y->residual[layer] + i, *e = y->strain[layer] + i;
    return (ovr_stressed){s[0],
                          nu * (s[0] + s[n]) + (1 - nu * nu) * (e[0] + e[n]),
                          s[n], s[2 * n]};
}

const double *ovr_yielding_sinking(const ovr_yielding *y)
{
    return y->w;
}

static ovr_stressed loaded(const ovr_yielding *y, size_t layer, size_t i,
                           ovr_in_plane elastic)
{
    ovr_stressed s = ovr_yielding_residual(y, layer, i);
    s.x += elastic.d - elastic.h;
    s.y -= 2 * y->options.poisson * elastic.h;
    s.z -= elastic.d + elastic.h;
    s.xz += elastic.tau;
    return s;
}

bool ovr_yielding_is_near(const ovr_yielding *y, size_t layer, size_t i,
                          ovr_in_plane elastic, double share)
{
    return ovr_near_yield(&y->options.hardening,
                          ovr_yielding_strain(y, layer, i),
                          loaded(y, layer, i, elastic), share);
}

double ovr_yielding_reserve(ovr_yielding *y)
{
    if (y->reserve_known)
        return y->reserve;
    double maximum = -INFINITY;
    for (size_t j = 0; j < y->options.layers; j++)
        for (size_t i = 0; i < y->options.points; i++) {
            double f = ovr_beyond_yield(&y->options.hardening,
                                        ovr_yielding_strain(y, j, i),
                                        ovr_yielding_residual(y, j, i));
            maximum = f > maximum ? f : maximum;
        }
    y->reserve = -maximum;
    y->reserve_known = true;
    return y->reserve;
}

static bool flow_layer(ovr_yielding *y, size_t j, ovr_flowed *flowed)
{
    const ovr_yielding_options *o = &y->options;
    const ovr_layer_load *load = &y->load[j];
    double *to = y->strain[j], area = o->mesh * (o->edge[j + 1] - o->edge[j]);
    size_t n = o->points;
    double work = 0, slope;
    bool any = false;
    for (size_t i = 0; i < n; i++) {
        const ovr_in_plane elastic = {(double)load->h[i], (double)load->d[i],
                                      (double)load->tau[i]};
        ovr_strained e = ovr_yielding_strain(y, j, i), was = e;
        ovr_stressed s = loaded(y, j, i, elastic);
        double flow = ovr_plastic_flow(&o->hardening, o->poisson, s, &e, &work);
        if (!(flow > 0))
            continue;
        double Y = ovr_yield_stress(&o->hardening, was.all, &slope);
        double f = ovr_beyond_yield(&o->hardening, was, s);
        to[i] = e.x;
        to[n + i] = e.z;
        to[2 * n + i] = e.xz;
        to[3 * n + i] = e.all;
        flowed->left = fmax(flowed->left, f / Y);
        flowed->maximum = fmax(flowed->maximum, flow);
        flowed->points += flowed->iterations == 0;
        any = true;
    }
    flowed->work += work * area;
    y->strained[j] = y->strained[j] || any;
    return any;
}

/* Number of layers that may flow; deeper layers are needed only at the end. */
static size_t layers_loaded(const ovr_yielding *y)
{
    size_t layers = y->options.layers;
    while (layers > 0 && y->load[layers - 1].idle)
        layers--;
    return layers;
}

ovr_flowed ovr_yielding_flow(ovr_yielding *y)
{
    ovr_flowed flowed = {0};
    size_t some = layers_loaded(y);
    for (int k = 0; k < y->options.iterations; k++) {
        bool any = false;
        flowed.left = 0;
        for (size_t j = 0; j < y->options.layers; j++)
            if (!y->load[j].idle)
                any = flow_layer(y, j, &flowed) || any;
        if (!any)
            break;
        flowed.iterations++;
        if (flowed.left < y->options.enough)
            break;
        if (k + 1 < y->options.iterations)
            equilibrate(y, some);
    }
    if (flowed.iterations)
        equilibrate(y, y->options.layers);
    y->reserve_known = y->reserve_known && !flowed.iterations;
    return flowed;
}

double *ovr_yielding_strains(ovr_yielding *y, size_t layer)
{
    return y->strain[layer];
}

void ovr_yielding_settle(ovr_yielding *y)
{
    size_t n = y->options.points;
    bool any = false;
    y->reserve_known = false;
    for (size_t j = 0; j < y->options.layers; j++) {
        y->strained[j] = false;
        for (size_t i = 0; i < PARTS * n && !y->strained[j]; i++)
            y->strained[j] = y->strain[j][i] != 0;
        any = any || y->strained[j];
    }
    if (any) {
        equilibrate(y, y->options.layers);
        return;
    }
    memset(y->w, 0, n * sizeof *y->w);
    for (size_t j = 0; j < y->options.layers; j++)
        memset(y->residual[j], 0, PARTS * n * sizeof **y->residual);
}
