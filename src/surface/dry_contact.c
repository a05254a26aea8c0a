/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/dry_contact.h"

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <math.h>
#include <string.h>

ovr_status ovr_dry_contact_take(ovr_dry_contact *of, size_t n, ovr_arena *arena,
                                ovr_error *err)
{
    of->n = n;
    of->workspace = ovr_arena_take(arena, 3 * n, sizeof *of->workspace, err);
    return of->workspace ? OVR_OK : OVR_NO_MEMORY;
}

/* Computes the elastic deformation w of the pressure p; the mean of w is
 * zero. */
static void deform(const ovr_dry_contact *of, const double *p, double *w)
{
    const double unit = 6.283185307179586 / of->length;
    size_t n = of->n, half = n / 2;
    memcpy(w, p, n * sizeof *w);
    gsl_fft_real_radix2_transform(w, 1, n);
    w[0] = 0;
    for (size_t k = 1; k < half; k++) {
        double soft = 2 / (of->modulus * unit * (double)k);
        w[k] *= soft;
        w[n - k] *= soft;
    }
    w[half] *= 2 / (of->modulus * unit * (double)half);
    gsl_fft_halfcomplex_radix2_inverse(w, 1, n);
}

/* Subtracts from a function its mean over the nodes in contact; returns the
 * mean. */
static double centre(size_t n, const double *p, double *f)
{
    double sum = 0, count = 0;
    for (size_t i = 0; i < n; i++)
        if (p[i] > 0) {
            sum += f[i];
            count++;
        }
    for (size_t i = 0; i < n; i++)
        f[i] -= sum / count;
    return sum / count;
}

static void scale_to(size_t n, double *p, double mean)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += p[i];
    for (size_t i = 0; i < n; i++)
        p[i] *= mean * (double)n / sum;
}

/* Computes the gap, with zero mean over the nodes in contact. */
static void find_gap(const ovr_dry_contact *of, const double *z,
                     const double *p, double *gap)
{
    deform(of, p, gap);
    for (size_t i = 0; i < of->n; i++)
        gap[i] -= z[i];
    centre(of->n, p, gap);
}

typedef struct search {
    double *gap, *along, *curve; /* gap, search direction, its deformation */
    double norm;                 /* squared norm of the gap at the last step; 0:
                                  * none */
} search;

/* Returns the step for a single node in contact, whose gap is always zero: its
 * pressure divided by its own deformation. */
static double single_node_step(const ovr_dry_contact *of)
{
    const double euler = 0.5772, pi = 3.14159265358979323846;
    double waves = log((double)of->n / 2) + euler;
    return of->modulus * pi * (double)of->n / (2 * of->length * waves);
}

/* Sets the search direction: the gap plus `keeps` times the last direction. */
static void set_direction(const ovr_dry_contact *of, const double *p,
                          const search *s, double keeps)
{
    for (size_t i = 0; i < of->n; i++)
        s->along[i] = p[i] > 0 ? s->gap[i] + keeps * s->along[i] : 0;
}

/* Returns the product of gap and search direction. */
static double descent(const ovr_dry_contact *of, const double *p,
                      const search *s)
{
    double falls = 0;
    for (size_t i = 0; i < of->n; i++)
        if (p[i] > 0)
            falls += s->gap[i] * s->along[i];
    return falls;
}

/* Computes the next conjugate direction; returns the step length. If the energy
 * increases in this direction, because nodes lost contact, the direction starts
 * again from the gap. A negative step would make pressures negative. */
static double next_direction(const ovr_dry_contact *of, const double *p,
                             search *s, bool begins)
{
    double norm = 0, bends = 0;
    for (size_t i = 0; i < of->n; i++)
        norm += p[i] > 0 ? s->gap[i] * s->gap[i] : 0;
    set_direction(of, p, s, begins || !(s->norm > 0) ? 0 : norm / s->norm);
    double falls = descent(of, p, s);
    if (!(falls > 0)) {
        set_direction(of, p, s, 0);
        falls = norm;
    }
    s->norm = norm;
    deform(of, s->along, s->curve);
    centre(of->n, p, s->curve);
    for (size_t i = 0; i < of->n; i++)
        if (p[i] > 0)
            bends += s->curve[i] * s->along[i];
    return bends > 0 ? falls / bends : single_node_step(of);
}

/* Applies the step, and `entry` times the step to nodes that come into contact.
 * Returns true if there are such nodes; the next direction then starts again
 * from the gap. */
static bool apply_step(const ovr_dry_contact *of, double far, double entry,
                       const search *s, double *p)
{
    bool grown = false;
    for (size_t i = 0; i < of->n; i++) {
        bool touched = p[i] > 0;
        if (touched)
            p[i] = fmax(p[i] - far * s->along[i], 0);
        if (p[i] == 0 && s->gap[i] < 0) {
            grown = true;
            p[i] -= entry * far * s->gap[i];
        }
    }
    return grown;
}

/* Returns the share of the step for nodes that come into contact. It is reduced
 * after many steps, because nodes can enter and leave in a cycle. */
static double entry_share(int steps)
{
    enum { MANY = 300 };
    const double reduced = 0.3;
    return steps < MANY ? 1 : reduced;
}

/* Returns the violation of complementarity of pressures and gaps, relative to
 * the range of heights. */
static double violation(const ovr_dry_contact *of, const double *z,
                        const double *p, const double *gap,
                        ovr_dry_state *state)
{
    double worst = 0, sum = 0, high = z[0], low = z[0];
    size_t count = 0;
    for (size_t i = 0; i < of->n; i++) {
        bool touches = p[i] > 0;
        worst = fmax(worst, touches ? fabs(gap[i]) : -gap[i]);
        sum += gap[i];
        count += touches;
        high = fmax(high, z[i]);
        low = fmin(low, z[i]);
    }
    state->gap = sum / (double)of->n;
    state->area = (double)count / (double)of->n;
    return high > low ? worst / (high - low) : 0;
}

ovr_dry_state ovr_dry_contact_solve(const ovr_dry_contact *of, const double *z,
                                    double mean, double *p)
{
    enum { MAX = 2000 };
    const double enough = of->enough > 0 ? of->enough : 1e-9;
    size_t n = of->n;
    search s = {of->workspace, of->workspace + n, of->workspace + 2 * n, 0};
    ovr_dry_state state = {0};
    bool begins = true;
    scale_to(n, p, mean);
    for (; state.steps < MAX; state.steps++) {
        find_gap(of, z, p, s.gap);
        state.found = violation(of, z, p, s.gap, &state) < enough;
        if (state.found)
            break;
        double far = next_direction(of, p, &s, begins);
        begins = apply_step(of, far, entry_share(state.steps), &s, p);
        scale_to(n, p, mean);
    }
    return state;
}
