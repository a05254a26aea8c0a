/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Film roughness of sliding surfaces, relative to that of rolling ones, by the
 * linear theory of small waves.
 *
 * A wave s = exp(i (k X - w T)), w = k u, is on one surface. It changes the
 * film thickness by h = d - s with the deformation d. To first order
 *     (eps p' + a h + b p - rho h - rho_P H p)' + i w (rho h + rho_P H p) = 0
 * with a = P' d eps/dH, b = P' d eps/dP of the smooth contact. All waves have
 * positive wave numbers, so that d = p/k becomes p = -i d' and the equation is
 * local. Its solution contains the wave that moves with the surface and the
 * wave that comes from the inlet with the lubricant, at um. In the middle of
 * the contact the solution agrees with the theory in tools/validation. With
 * shear thinning eps is the mobility for small gradients, eps f'(t/tau0).
 *
 * Accuracy: with P and H of computed solutions the median error of 63 waves was
 * 2 %. Under heavy loads long waves were up to three times too large. The error
 * of rolling waves is nearly the same, so that the ratio of the two is used.
 *
 * Approximate P and H of the smooth contact:
 *     H = dry gap + (1 + excess) Hc
 * P is Hertzian, rounded at X = -1 in proportion to the inlet length l. At X =
 * -1 - l the dry gap is Hc. In the inlet P is at most the solution of the
 * Reynolds equation for this H, scaled to end at 1.5 P(-1).
 */
#include "run/sliding_waves.h"

#include <complex.h>
#include <math.h>

#include "contact/contact.h"
#include "contact/flow_law.h"
#include "overroll/simulation.h"

static const double BEGIN = -2.5, END = 0.99; /* b */
static const double WINDOW = OVR_ROUGH_WINDOW;
static const double SHORTEST = 0.05, LONGEST = 4; /* b */
static const double COARSEST = 0.01;              /* b */
/* Fitted to 225 runs: width of the rounding over l, pressure where the inlet
 * ends over that at X = -1. */
static const double ROUNDING = 0.25, INLET_END = 1.5;
enum { IN_INLET = 8, IN_WAVE = 30, PRESSURES = 2048, BAND = 6, BELOW = 2 };

/* The smooth contact, and the coefficients of the equation at its nodes. */
typedef struct smooth {
    size_t n;
    double D;
    double *P, *H;
    double *eps, *of_h, *of_p; /* of the flux: of p', h and p */
    double *rho, *rho_p;       /* of the content: of h and p */
} smooth;

/* Coefficients of one node. */
typedef struct coefficients {
    double eps, of_h, of_p, rho, rho_p;
} coefficients;

/* ------------------------------------------------------- the smooth contact */

static double dry_gap(double X)
{
    double x = fabs(X);
    return x > 1 ? 0.5 * (x * sqrt(x * x - 1) - acosh(x)) : 0;
}

/* Distance upstream of X = -1 at which the dry gap is H. */
static double inlet_length(double H)
{
    double low = 0, high = -BEGIN - 1;
    for (int k = 0; k < 60; k++) {
        double x = 0.5 * (low + high);
        if (dry_gap(1 + x) < H)
            low = x;
        else
            high = x;
    }
    return low;
}

/* H/Hc - 1 without the dry gap, at s = (X + 1)/l, as read from four computed
 * solutions. */
static double excess(double s)
{
    double t = (s + 0.4) / 2;
    return s < 0 ? 0.36 * exp(-t * t) : 0.345 / (1 + pow(s / 0.45, 1.6));
}

/* State of the inversion of q(P), the integral of dP/eta, for increasing q. */
typedef struct upwards {
    const ovr_lubricant *lubricant;
    double P, q, fluidity;
} upwards;

static double pressure_at(upwards *at, double q)
{
    const double step = 1.0 / PRESSURES;
    while (at->q < q && at->P < 1) {
        double next = 1 / ovr_viscosity(at->lubricant, at->P + step);
        at->q += 0.5 * step * (at->fluidity + next);
        at->fluidity = next;
        at->P += step;
    }
    return at->q < q ? INFINITY : at->P - fmax(0, at->q - q) / at->fluidity;
}

static double integral_to(const ovr_lubricant *lubricant, double P)
{
    double sum = 0, step = P / 256, last = 1;
    for (int k = 1; k <= 256; k++) {
        double next = 1 / ovr_viscosity(lubricant, k * step);
        sum += 0.5 * step * (last + next);
        last = next;
    }
    return sum;
}

static double place(const smooth *at, size_t i)
{
    return BEGIN + at->D * (double)i;
}

static void fill_smooth(const ovr_contact *c, const ovr_lubricant *lubricant,
                        double Hc, smooth *at)
{
    double length = inlet_length(Hc), width = ROUNDING * length;
    double q = 0, scale, last = 0;
    upwards up = {lubricant, 0, 0, 1};
    for (size_t i = 0; i < at->n; i++) {
        double X = place(at, i), more = Hc * excess((X + 1) / length);
        double gap = X < 0 ? dry_gap(X) : 0;
        double H = at->H[i] = gap + Hc + more;
        double slope = c->lambda * (gap + more) / (H * H * H);
        if (X < -1 && i > 0)
            q += 0.5 * at->D * (last + slope);
        last = slope;
        at->P[i] = q; /* for now */
    }
    scale = integral_to(lubricant, INLET_END * sqrt(width)) / q;
    for (size_t i = 0; i < at->n; i++) {
        double X = place(at, i), y = 1 - X * X;
        double P = sqrt(0.5 * (y + sqrt(y * y + 4 * width * width)));
        if (X < -1)
            P = fmin(P, pressure_at(&up, at->P[i] * scale));
        at->P[i] = P;
    }
}

/* ------------------------------------------------------------ coefficients */

/* Solves f(a) = s > 0; f(a) >= a increases. */
static double stress_of_rate(const ovr_curve *f, double s)
{
    double low = 0, high = s, by_a;
    for (int k = 0; k < 60; k++) {
        double a = 0.5 * (low + high);
        if (ovr_curve_at(f, a, &by_a) < s)
            low = a;
        else
            high = a;
    }
    return high;
}

/* Returns eps for small pressure gradients in the sheared film. */
static double mobility(const ovr_contact *c, const ovr_lubricant *lubricant,
                       double slip, double P, double H)
{
    double rho = ovr_density(lubricant, P), by_a = 1;
    double eps = rho * H * H * H / (ovr_viscosity(lubricant, P) * c->lambda);
    double shear = lubricant->rheology == OVR_NEWTONIAN
                       ? 0
                       : fabs(slip) * rho * H * H / (12 * lubricant->Sigma0);
    if (lubricant->rheology == OVR_EYRING)
        return sqrt(eps * eps + shear * shear);
    if (!(shear > 0 && eps > 0))
        return eps;
    ovr_curve_at(&lubricant->flow_law->f,
                 stress_of_rate(&lubricant->flow_law->f, shear / eps), &by_a);
    return eps * by_a;
}

static void fill_coefficients(const ovr_contact *c,
                              const ovr_lubricant *lubricant, double slip,
                              smooth *at)
{
    const double d = 1e-6;
    for (size_t i = 0; i < at->n; i++) {
        double P = at->P[i], H = at->H[i];
        double before = at->P[i > 0 ? i - 1 : 0];
        double after = at->P[i + 1 < at->n ? i + 1 : i];
        double P_X = (after - before) / (2 * at->D);
        double eps = mobility(c, lubricant, slip, P, H);
        double rho = ovr_density(lubricant, P);
        at->eps[i] = eps;
        at->rho[i] = rho;
        at->rho_p[i] = H * (ovr_density(lubricant, P + d) - rho) / d;
        at->of_h[i] = -rho +
                      P_X / (H * d) *
                          (mobility(c, lubricant, slip, P, H * (1 + d)) - eps);
        at->of_p[i] = -at->rho_p[i] +
                      P_X / d * (mobility(c, lubricant, slip, P + d, H) - eps);
    }
}

/* Linear between nodes: at node i of the mesh `times` as fine. */
static coefficients between(const smooth *at, size_t times, size_t i)
{
    size_t k = i / times, l = k + 1 < at->n ? k + 1 : k;
    double t = (double)(i % times) / (double)times, r = 1 - t;
    return (coefficients){
        r * at->eps[k] + t * at->eps[l], r * at->of_h[k] + t * at->of_h[l],
        r * at->of_p[k] + t * at->of_p[l], r * at->rho[k] + t * at->rho[l],
        r * at->rho_p[k] + t * at->rho_p[l]};
}

/* ---------------------------------------------------------------- equation */

typedef double complex row[BAND]; /* columns i - 2 to i + 3 */

/* Gauss with pivots among the rows that reach a column. */
static void solve(size_t n, row *a, double complex *x)
{
    for (size_t j = 0; j < n; j++) {
        size_t pivot = j, end = j + BELOW < n ? j + BELOW : n - 1;
        for (size_t i = j + 1; i <= end; i++)
            if (cabs(a[i][BELOW + j - i]) > cabs(a[pivot][BELOW + j - pivot]))
                pivot = i;
        for (size_t c = j; pivot > j && c < j + BAND - BELOW; c++) {
            double complex *p = &a[pivot][BELOW + c - pivot],
                           *q = &a[j][BELOW + c - j], t = *p;
            *p = *q;
            *q = t;
        }
        double complex y = x[pivot];
        x[pivot] = x[j];
        x[j] = y;
        for (size_t i = j + 1; i <= end; i++) {
            double complex m = a[i][BELOW + j - i] / a[j][BELOW];
            for (size_t c = j; c < j + BAND - BELOW; c++)
                a[i][BELOW + c - i] -= m * a[j][BELOW + c - j];
            x[i] -= m * x[j];
        }
    }
    for (size_t j = n; j-- > 0;) {
        for (size_t c = 1; c < BAND - BELOW && j + c < n; c++)
            x[j] -= a[j][BELOW + c] * x[j + c];
        x[j] /= a[j][BELOW];
    }
}

/* Coefficients of d[i - 1], d[i], d[i + 1] in the flux at node i. */
typedef struct flux {
    double complex before, here, after, wave;
} flux;

static flux flux_at(coefficients c, double D, double complex s)
{
    double complex p = -I * c.eps / (D * D), q = -I * c.of_p / (2 * D);
    return (flux){p - q, c.of_h - 2 * p, p + q, -c.of_h * s};
}

/* Computes d in x; p and d vanish at the upstream end, p at the downstream
 * end. */
static void deform(const smooth *at, size_t times, size_t n, double k, double u,
                   row *a, double complex *x)
{
    double D = at->D / (double)times;
    double complex turn = cexp(I * k * D), s = cexp(I * k * (BEGIN + D));
    double complex w = I * k * u;
    coefficients here = between(at, times, 1);
    flux in = flux_at(here, D, s);
    for (size_t i = 0; i < n; i++) {
        x[i] = 0;
        for (int c = 0; c < BAND; c++)
            a[i][c] = 0;
    }
    a[0][BELOW] = a[1][BELOW] = a[n - 1][BELOW] = 1;
    a[1][BELOW - 1] = a[n - 1][BELOW - 1] = -1;
    for (size_t i = 1; i + 2 < n; i++) {
        coefficients next = between(at, times, i + 1);
        double complex s_next = s * turn;
        flux out = flux_at(next, D, s_next);
        double complex h = w * 0.25 * (here.rho + next.rho);
        double complex p = w * -I * 0.5 * (here.rho_p + next.rho_p) / D;
        double complex *r = a[i + 1];
        r[0] = -in.before / D;
        r[1] = (out.before - in.here) / D + h - p;
        r[2] = (out.here - in.after) / D + h + p;
        r[3] = out.after / D;
        x[i + 1] = h * (s + s_next) - (out.wave - in.wave) / D;
        here = next;
        in = out;
        s = s_next;
    }
    solve(n, a, x);
}

/* Mean square over time and window of the content's wave. */
static double mean_square(const smooth *at, size_t times, size_t n, double k,
                          const double complex *x)
{
    double D = at->D / (double)times, squares = 0, count = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        double X = BEGIN + D * (double)i;
        if (fabs(X) > WINDOW)
            continue;
        coefficients c = between(at, times, i);
        double complex p = -I * (x[i + 1] - x[i - 1]) / (2 * D);
        double complex q = c.rho * (x[i] - cexp(I * k * X)) + c.rho_p * p;
        squares += creal(q * conj(q));
        count++;
    }
    return squares / count;
}

/* rho H varies where the smooth film's pressure has a gradient.  Shear thins
 * the film, of five Eyring films to H/(1 + 4.5 Rq/H), Rq that of H. */
static double smooth_roughness(const smooth *at, double H)
{
    double squares = 0, sum = 0, rho = 0, count = 0;
    for (size_t i = 1; i + 1 < at->n; i++)
        if (fabs(place(at, i)) <= WINDOW) {
            double q = at->eps[i] * (at->P[i + 1] - at->P[i - 1]) / (2 * at->D);
            squares += q * q;
            sum += q;
            rho += at->rho[i];
            count++;
        }
    sum /= count;
    double Rq = sqrt(fmax(0, squares / count - sum * sum)) * count / rho;
    double thinner = 1 / (1 + 4.5 * Rq / H);
    return Rq * thinner * thinner;
}

static ovr_status allocate(smooth *at, ovr_arena *arena, ovr_error *err)
{
    double **const arrays[] = {&at->P,    &at->H,   &at->eps,  &at->of_h,
                               &at->of_p, &at->rho, &at->rho_p};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++) {
        *arrays[k] = ovr_arena_take(arena, at->n, sizeof **arrays[k], err);
        if (!*arrays[k])
            return OVR_NO_MEMORY;
    }
    return OVR_OK;
}

ovr_status ovr_sliding_waves_make(const ovr_contact *contact,
                                  const ovr_lubricant *lubricant, double H,
                                  double u, ovr_arena *arena,
                                  ovr_sliding_waves *to, ovr_error *err)
{
    double mesh = fmin(COARSEST, inlet_length(H) / IN_INLET);
    smooth rolls = {.n = (size_t)((END - BEGIN) / mesh) + 1}, slides;
    double fastest = fmax(1, u), shortest = SHORTEST / fastest / IN_WAVE;
    size_t finest = (size_t)ceil(mesh / shortest);
    size_t most = (rolls.n - 1) * finest + 1;
    ovr_wave_factors *f = &to->factors;
    rolls.D = (END - BEGIN) / (double)(rolls.n - 1);
    slides = rolls;
    row *a = ovr_arena_take(arena, most, sizeof *a, err);
    double complex *x = ovr_arena_take(arena, most, sizeof *x, err);
    if (!a || !x || allocate(&rolls, arena, err) ||
        allocate(&slides, arena, err))
        return OVR_NO_MEMORY;
    fill_smooth(contact, lubricant, H, &rolls);
    fill_smooth(contact, lubricant, H, &slides);
    fill_coefficients(contact, lubricant, 0, &rolls);
    fill_coefficients(contact, lubricant, contact->u1_ratio - contact->u2_ratio,
                      &slides);
    to->smooth_Rq = smooth_roughness(&slides, H);
    f->first = SHORTEST;
    f->step = log(LONGEST / SHORTEST) / (OVR_WAVE_FACTORS - 1);
    for (int j = 0; j < OVR_WAVE_FACTORS; j++) {
        double length = SHORTEST * exp(f->step * j);
        double k = 2 * 3.14159265358979323846 / length;
        size_t times = (size_t)ceil(mesh / (length / fastest / IN_WAVE));
        size_t n = (rolls.n - 1) * times + 1;
        if (n > most)
            n = most;
        deform(&slides, times, n, k, u, a, x);
        double moved = mean_square(&slides, times, n, k, x);
        deform(&rolls, times, n, k, 1, a, x);
        f->value[j] = sqrt(moved / mean_square(&rolls, times, n, k, x));
    }
    return OVR_OK;
}
