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
 * shear thinning eps is the mobility for small gradients, eps f'(t/tau0). For a
 * surface at rest, u = 0, the equation is solved once for its heights.
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
    double *eps, *of_h, *of_p; /* coefficients of p', h and p in the flux */
    double *rho, *rho_p; /* coefficients of h and p in the lubricant content */
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

/* Computes d in x. p and d vanish at the upstream end, p at the downstream end.
 * The heights s of the nodes have positive wave numbers and change as
 * exp(-w T). */
static void deform(const smooth *at, size_t times, size_t n, double complex w,
                   const double complex *s, row *a, double complex *x)
{
    double D = at->D / (double)times;
    coefficients here = between(at, times, 1);
    flux in = flux_at(here, D, s[1]);
    for (size_t i = 0; i < n; i++) {
        x[i] = 0;
        for (int c = 0; c < BAND; c++)
            a[i][c] = 0;
    }
    a[0][BELOW] = a[1][BELOW] = a[n - 1][BELOW] = 1;
    a[1][BELOW - 1] = a[n - 1][BELOW - 1] = -1;
    for (size_t i = 1; i + 2 < n; i++) {
        coefficients next = between(at, times, i + 1);
        flux out = flux_at(next, D, s[i + 1]);
        double complex h = w * 0.25 * (here.rho + next.rho);
        double complex p = w * -I * 0.5 * (here.rho_p + next.rho_p) / D;
        double complex *r = a[i + 1];
        r[0] = -in.before / D;
        r[1] = (out.before - in.here) / D + h - p;
        r[2] = (out.here - in.after) / D + h + p;
        r[3] = out.after / D;
        x[i + 1] = h * (s[i] + s[i + 1]) - (out.wave - in.wave) / D;
        here = next;
        in = out;
    }
    solve(n, a, x);
}

/* Deviation of rho H at node i. */
static double complex content(const smooth *at, size_t times, size_t i,
                              const double complex *s, const double complex *x)
{
    double D = at->D / (double)times;
    coefficients c = between(at, times, i);
    double complex p = -I * (x[i + 1] - x[i - 1]) / (2 * D);
    return c.rho * (x[i] - s[i]) + c.rho_p * p;
}

/* Largest variance in the window of the real part of the content's wave, over
 * its period: of exp(i t) q it is (<|q|^2> + |<q^2>|)/2, q without its mean. */
static double variance(const smooth *at, size_t times, size_t n,
                       const double complex *s, const double complex *x)
{
    double D = at->D / (double)times, squares = 0, count = 0;
    double complex turned = 0, sum = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        if (fabs(BEGIN + D * (double)i) > WINDOW)
            continue;
        double complex q = content(at, times, i, s, x);
        squares += creal(q * conj(q));
        turned += q * q;
        sum += q;
        count++;
    }
    squares -= creal(sum * conj(sum)) / count;
    turned -= sum * sum / count;
    return (squares + cabs(turned)) / (2 * count);
}

/* Largest variance in the window of the real part of exp(i k X). */
static double variance_of_wave(double k)
{
    double a = k * WINDOW, mean = sin(a) / a;
    return (1 - mean * mean + fabs(sin(2 * a) / (2 * a) - mean * mean)) / 2;
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

/* The waves that the oil carries are um/u as long as those of the surface.
 * Below u = um/2 those that ride with the surface are the shorter ones by far.
 */
double ovr_film_wave_stretch(double u)
{
    return 1 / fmax(0.5, u);
}

/* Memory of one solution with at most `most` nodes. */
typedef struct workspace {
    size_t most;
    row *a;
    double complex *x, *s;
} workspace;

static ovr_status allocate_workspace(ovr_arena *arena, size_t most,
                                     workspace *w, ovr_error *err)
{
    w->most = most;
    w->a = ovr_arena_take(arena, most, sizeof *w->a, err);
    w->x = ovr_arena_take(arena, most, sizeof *w->x, err);
    w->s = ovr_arena_take(arena, most, sizeof *w->s, err);
    return w->a && w->x && w->s ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status make_smooth(const ovr_contact *contact,
                              const ovr_lubricant *lubricant, double H,
                              double slip, ovr_arena *arena, smooth *to,
                              ovr_error *err)
{
    double mesh = fmin(COARSEST, inlet_length(H) / IN_INLET);
    to->n = (size_t)((END - BEGIN) / mesh) + 1;
    to->D = (END - BEGIN) / (double)(to->n - 1);
    ovr_status status = allocate(to, arena, err);
    if (status)
        return status;
    fill_smooth(contact, lubricant, H, to);
    fill_coefficients(contact, lubricant, slip, to);
    return OVR_OK;
}

/* Rq of q = eps P', the part of the flow that the pressure drives. */
static double driven_roughness(const smooth *at)
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
    return sqrt(fmax(0, squares / count - sum * sum)) * count / rho;
}

/* Viscosity for small pressure gradients over that without sliding, where the
 * pressure has raised the viscosity nearly e^2 times. */
static double thinned_viscosity(const ovr_contact *c,
                                const ovr_lubricant *lubricant, double slip,
                                double H)
{
    double P = 2 / c->alphabar;
    return mobility(c, lubricant, 0, P, H) / mobility(c, lubricant, slip, P, H);
}

/* Accuracy: 220 smooth contacts that slide (Eyring, Carreau, tables) have M = 5
 * to 300, L = 3 to 21 and slide-to-roll ratios of up to 2. The root mean square
 * error of the minimum film thickness is 0.02, at most 0.11, that of Rq/H is
 * 0.005. Without sliding, 103 solutions with M = 2 to 30 and L = 2 to 25 have a
 * root mean square error of 0.006 in Rq/H, at most 0.017. */
ovr_status ovr_smooth_film_make(const ovr_contact *contact,
                                const ovr_lubricant *lubricant, double H,
                                ovr_arena *arena, ovr_smooth_film *to,
                                ovr_error *err)
{
    double M = contact->M, slip = contact->u1_ratio - contact->u2_ratio;
    double thick = 0.309 * pow(M, -0.72) * pow(contact->L, -0.101 * M) * H;
    smooth slides;
    *to = (ovr_smooth_film){.ratio = 1, .Rq = thick};
    ovr_status status = make_smooth(contact, lubricant, H, slip, arena, &slides,
                                    err);
    if (status || !(fabs(slip) > 0))
        return status;
    double Rq = driven_roughness(&slides);
    to->ratio = pow(thinned_viscosity(contact, lubricant, slip, H), 0.42) /
                (1 + 2 * Rq / H);
    to->Rq = hypot(thick * to->ratio, Rq * to->ratio * to->ratio);
    return OVR_OK;
}

/* Largest variance of the content's wave exp(i k (X - u T)). */
static double of_wave(const smooth *at, size_t times, double k, double u,
                      workspace *w)
{
    size_t n = (at->n - 1) * times + 1;
    if (n > w->most)
        n = w->most;
    double D = at->D / (double)times;
    double complex turn = cexp(I * k * D);
    w->s[0] = cexp(I * k * BEGIN);
    for (size_t i = 1; i < n; i++)
        w->s[i] = w->s[i - 1] * turn;
    deform(at, times, n, I * k * u, w->s, w->a, w->x);
    return variance(at, times, n, w->s, w->x);
}

/* Nodes of a wave per mesh size of the smooth contact. */
static size_t refinement(const smooth *at, double length, double fastest)
{
    return (size_t)ceil(at->D * IN_WAVE * fastest / length);
}

ovr_status ovr_sliding_waves_make(const ovr_contact *contact,
                                  const ovr_lubricant *lubricant, double H,
                                  double u, ovr_arena *arena,
                                  ovr_wave_factors *to, ovr_error *err)
{
    double slip = contact->u1_ratio - contact->u2_ratio;
    double fastest = fmax(1, fabs(u));
    smooth rolls, slides;
    workspace w;
    ovr_status status = make_smooth(contact, lubricant, H, 0, arena, &rolls,
                                    err);
    if (!status)
        status = make_smooth(contact, lubricant, H, slip, arena, &slides, err);
    if (!status)
        status = allocate_workspace(
            arena, (rolls.n - 1) * refinement(&rolls, SHORTEST, fastest) + 1,
            &w, err);
    if (status)
        return status;
    to->first = SHORTEST;
    to->step = log(LONGEST / SHORTEST) / (OVR_WAVE_FACTORS - 1);
    for (int j = 0; j < OVR_WAVE_FACTORS; j++) {
        double length = SHORTEST * exp(to->step * j);
        double k = 2 * 3.14159265358979323846 / length;
        size_t times = refinement(&rolls, length, fastest);
        double moved = of_wave(&slides, times, k, u, &w);
        double same = of_wave(&rolls, times, k, 1, &w);
        double in_film = k / ovr_film_wave_stretch(u);
        to->value[j] = sqrt(moved / same * variance_of_wave(k) /
                            variance_of_wave(in_film));
    }
    return OVR_OK;
}

ovr_status ovr_standing_film_make(const ovr_contact *contact,
                                  const ovr_lubricant *lubricant, double H,
                                  const ovr_still *surface, ovr_arena *arena,
                                  ovr_standing_film *to, ovr_error *err)
{
    smooth slides;
    workspace w;
    ovr_status status = make_smooth(contact, lubricant, H,
                                    contact->u1_ratio - contact->u2_ratio,
                                    arena, &slides, err);
    size_t times = (size_t)ceil(slides.D * IN_WAVE / SHORTEST);
    if (!status)
        status = allocate_workspace(arena, (slides.n - 1) * times + 1, &w, err);
    if (status)
        return status;
    size_t n = w.most;
    double D = slides.D / (double)times;
    for (size_t i = 0; i < n; i++) {
        double at = (BEGIN + D * (double)i - surface->X) / surface->step;
        size_t k = (size_t)at;
        double t = at - (double)k;
        const double *z = surface->z + k, *y = surface->turned + k;
        w.s[i] = (1 - t) * (z[0] + I * y[0]) + t * (z[1] + I * y[1]);
    }
    deform(&slides, times, n, 0, w.s, w.a, w.x);
    double squares = 0, sum = 0, count = 0, lowest = INFINITY;
    for (size_t i = 1; i + 1 < n; i++) {
        double X = BEGIN + D * (double)i;
        if (X > WINDOW)
            lowest = fmin(lowest, creal(w.x[i] - w.s[i]));
        if (fabs(X) > WINDOW)
            continue;
        double q = creal(content(&slides, times, i, w.s, w.x));
        squares += q * q;
        sum += q;
        count++;
    }
    squares = squares / count - sum / count * (sum / count);
    to->Rq = sqrt(fmax(0, squares)) / slides.rho[slides.n / 2];
    to->lowest = lowest;
    return OVR_OK;
}
