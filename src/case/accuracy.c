/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Predicts discretization errors relative to the film thickness.
 *
 * H is the central film thickness by Moes. x = D/H^(2/3) is the mesh size
 * relative to the length over which pressure builds up in the inlet. k = min(1,
 * (L/15)^2) min(1, (M/25)^(1/2)) is a factor of pressure spike and
 * constriction.
 *
 * Bounds of one film thickness:
 *
 *   order              H_cen                   H_min, in addition
 *     4                0.035 x^2 + 0.2 x^4     0.1 k x^1.3 + 3 x^3
 *     4, means by gap  the same                0.4 k x^1.3 + 2 x^3
 *     2                1.5 x^2                 0.55 k x^1.3
 *     1                0.6 x
 *
 * A feature of height A with a width or wavelength of N D adds 8 (A/H)/N^2 with
 * the characteristic scheme, 100 (A/H)/N^2 with upstream2, or 3 (A/H)/N with
 * upstream1. Stationary features always add 8 (A/H)/N^2.
 * Tables of heights have A = Rq.
 *
 * These bounds exceed all measured errors. Random contacts had M = 5 to 1000, L
 * = 1 to 16, and levels 4 to 10 were compared with level 13. Features were
 * dents of 0.05 to 0.5 b and waves of 0.1 b in rolling and sliding. With L
 * below 10, errors of order 4 are 5 to 20 times smaller.
 *
 * Likely error of all quantities: the error of H_min, the least accurate film
 * thickness, or that of the friction if larger. For a run the film error is its
 * root mean square over time.
 *
 *   films of order 4    3e-5 + 0.035 x^2 + v (2 + l^4) x^3, l = min(L, 25)/17.
 *                       v = 0.7. In runs with varying load, speed or radius,
 *                       with waves, or with dents of a > 1, v = 2.8.
 *   the same, by gap    3e-5 + 0.035 x^2 + (1.5 + 7 l^4) x^3; if the speed
 *                       varies, the cubic term is doubled.
 *   steady, of order 2  (0.2 + 0.8 l^4) x^2; by gap (0.12 + 2.9 l^4) x^2
 *   starved films       the film errors times min(f^-2.5, 6), for a supply of
 *                       f = 0.38 to 1 central film thicknesses
 *   features            k/N^2, and 2.5 k/N^2 with time steps of 2 D.
 *     raised by r = S/H   k = 0.8 r/(1 - r): the minimum film thickness is
 *                         smaller by about S. 1 - r is at least 0.05.
 *     waves, starved      The same, but 1 - r is at least 0.02.
 *     short waves         The same times 1 + (0.3 b/wavelength)^2.
 *     dents, a = A/H      k = 0.15 a or 0.5 a^2/(1 + a), the larger one; 4
 *                         times that in a texture; 6 a in starved films.
 *     tables of heights   k = 13 r/(1 - r)^2, r = Rq/H. Ridges are higher than
 *                         Rq and a quarter of the mean wavelength long.
 *     upstream2           12.5 k/N^2; upstream1 3 a/N.
 *   temperatures        0.05 dT, because they are of first order in time
 *   friction            (1 + 0.3/V) D^2 for the sliding speed V, at most 12
 * D^2: at small V the stress is proportional to viscosity. With waves and
 * roughness 0.6 replaces 0.3. 2.5 D^2 if the sliding speed passes zero. 4 D^2
 * for steady films.
 *
 * In nine of ten cases the error is below twice the likely error
 * (ovr_expected_at_most).
 *
 * The formulas are fitted to 193 random cases with common conditions and were
 * tested on 147 others. Reference solutions were one or two levels finer, with
 * steps of D. Films thinner than about a third of the features' height are less
 * accurate on any usual level. Errors of steady films of second order were
 * measured on random mixed contacts at 0.5 to 1.5 GPa. Asperity load shares
 * above one half make the error smaller.
 */
#include "case/accuracy.h"

#include <math.h>
#include <string.h>

#include "case/domain.h"
#include "case/setup.h"
#include "contact/contact.h"
#include "contact/curvature.h"
#include "contact/film_formula.h"
#include "simulation/scheme.h"
#include "surface/surfaces.h"

/* Returns the order of the discretization that a solution normally reaches. */
static int order_of(const ovr_setup *s)
{
    if (ovr_setup_corrected(s))
        return 4;
    return ovr_scheme_record(s->options->scheme)->order;
}

/* Returns the factor of x^3; l is the fourth power of min(L, 25)/17. */
static double by_gap(const ovr_setup *s, double l)
{
    return (ovr_history_varies(s->speed) ? 2 : 1) * (1.5 + 7 * l);
}

/* True if there are rough features of one kind: waves, or tables of heights. */
static bool has_rough(const ovr_setup *s, bool tables)
{
    size_t n = s->surfaces ? ovr_surfaces_count(s->surfaces) : 0;
    bool found = false;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info f = ovr_surfaces_info(s->surfaces, k);
        bool table = strcmp(f.wavelength_is, "mean") == 0;
        found = found || (f.Rq > 0 && table == tables);
    }
    return found;
}

/* True if a dent is deeper than the film: pressure spikes form at its edges. */
static bool has_deep(const ovr_setup *s)
{
    double H = ovr_film_central_moes(s->contact->M, s->contact->L);
    size_t n = s->surfaces ? ovr_surfaces_count(s->surfaces) : 0;
    bool found = false;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info f = ovr_surfaces_info(s->surfaces, k);
        bool table = strcmp(f.wavelength_is, "mean") == 0;
        found = found || (!table && f.amplitude - f.raised > H);
    }
    return found;
}

static double by_logarithms(const ovr_setup *s, double l)
{
    const double constant = 0.7, varying = 2.8;
    bool varies = ovr_setup_varies(s) || has_rough(s, false) || has_deep(s);
    return (s->transient && varies ? varying : constant) * (2 + l);
}

/* Returns the error of the film thickness of a contact with these M and L and
 * with the mesh size relative to its own half-width. */
static double of_film(const ovr_setup *s, double M, double L, double mesh)
{
    double x = mesh / pow(ovr_film_central_moes(M, L), 2. / 3);
    double k = fmin(L * L / 225, 1) * fmin(sqrt(M / 25), 1);
    double l = fmin(L, 25) / 17;
    bool likely = s->accuracy_of == OVR_ACCURACY_ALL;
    bool minimum = likely || s->accuracy_of == OVR_ACCURACY_H_MIN;
    int order = order_of(s);
    const double between_nodes = 3e-5; /* error of a minimum between coarse
                                        * nodes */
    double spike = k * pow(x, 1.3), cube = x * x * x;
    bool gap = s->options->faces != OVR_FACES_LOGARITHMIC;
    l *= l * l * l;
    if (order == 4 && likely)
        return between_nodes + x * x * 0.035 +
               (gap ? by_gap(s, l) : by_logarithms(s, l)) * cube;
    if (order == 2 && likely && !s->transient &&
        s->options->faces != OVR_FACES_ARITHMETIC)
        return x * x * (gap ? 0.12 + 2.9 * l : 0.2 + 0.8 * l);
    if (order == 4)
        return x * x * (0.035 + 0.2 * x * x) +
               (minimum
                    ? (gap ? 0.4 * spike + 2 * cube : 0.1 * spike + 3 * cube)
                    : 0);
    return order == 2 ? 1.5 * x * x + (minimum ? 0.55 * spike : 0) : 0.6 * x;
}

/* Returns the contact at time T, and its curvature relative to the reference
 * curvature. */
static ovr_instant instant(const ovr_setup *s, double T, double *curvature)
{
    double w = fmax(ovr_history_value(s->load, T), OVR_MIN_START);
    double u = fmax(fabs(ovr_history_value(s->speed, T)), OVR_MIN_START);
    *curvature = 1 / ovr_history_value(s->radius, T);
    return ovr_instant_of(s->contact, w, u, *curvature);
}

enum { LOOKS = 64 };

/* Returns the maximum over the run, for a varying radius. */
static double largest_of_film(const ovr_setup *s)
{
    double maximum = of_film(s, s->contact->M, s->contact->L, s->mesh);
    if (!s->transient || !ovr_history_varies(s->radius))
        return maximum;
    for (int k = 0; k <= LOOKS; k++) {
        double c;
        ovr_instant at = instant(s, ovr_setup_end(s) * k / LOOKS, &c);
        maximum = fmax(maximum, of_film(s, at.M, at.L, s->mesh / at.s));
    }
    return maximum;
}

/* Returns the root mean square over a run relative to the mean film thickness,
 * in units of the reference contact. If the entrainment speed becomes zero,
 * the error is at most the film thickness itself. */
static double mean_of_film(const ovr_setup *s)
{
    double squares = 0, films = 0, end = ovr_setup_end(s);
    if (!s->transient || !ovr_setup_varies(s) || !(end > 0 && isfinite(end)))
        return of_film(s, s->contact->M, s->contact->L, s->mesh);
    for (int k = 0; k <= LOOKS; k++) {
        double c;
        ovr_instant at = instant(s, end * k / LOOKS, &c);
        double H = ovr_film_central_moes(at.M, at.L) * at.s * at.s * c;
        double off = fmin(of_film(s, at.M, at.L, s->mesh / at.s), 1) * H;
        squares += off * off;
        films += H;
    }
    return sqrt(squares * (LOOKS + 1)) / films;
}

/* Returns minimum and maximum of the sliding speed over the run. */
static void range_of_sliding(const ovr_setup *s, double *least, double *most)
{
    double end = ovr_setup_end(s);
    bool varies = s->transient && isfinite(end);
    *least = INFINITY;
    *most = -INFINITY;
    for (int k = 0; k <= (varies ? LOOKS : 0); k++) {
        double T = varies ? end * k / LOOKS : 0;
        double V = ovr_slip_at(s->contact, s->speed, s->sliding, T);
        *least = fmin(*least, V);
        *most = fmax(*most, V);
    }
}

bool ovr_expects_friction(const ovr_setup *s)
{
    const ovr_lubricant *oil = s->lubricant;
    return oil->rheology != OVR_NEWTONIAN || oil->limiting_shear > 0;
}

/* Error of the friction, or 0. */
static double of_friction(const ovr_setup *s)
{
    const double steady = 4, through_zero = 2.5, most_of_all = 12;
    const double nothing = 1e-9;
    double least, most, square = s->mesh * s->mesh;
    if (!ovr_expects_friction(s))
        return 0;
    range_of_sliding(s, &least, &most);
    if (fmax(most, -least) < nothing)
        return 0;
    if (!s->transient)
        return steady * square;
    if (!(least * most > 0))
        return through_zero * square;
    double slowest = fmin(fabs(least), fabs(most));
    bool rough = has_rough(s, false) || has_rough(s, true);
    double little = (rough ? 0.6 : 0.3) / slowest;
    return fmin(1 + little, most_of_all) * square;
}

double ovr_expected_of_mesh(const ovr_setup *s)
{
    if (s->accuracy_of == OVR_ACCURACY_ALL)
        return fmax(mean_of_film(s), of_friction(s));
    return largest_of_film(s);
}

/* Estimates the likely error caused by a dent that is a = A/H deep, times N^2.
 * Dents deeper than the film have steep pressure gradients at their edges.  A
 * texture always has a dent in the contact, a single one passes. */
static double sunk(const ovr_feature_info *f, double a, bool starved)
{
    const double shallow = 0.15, deep = 0.5, always = 4, dry = 6;
    double part = fmax(shallow * a, deep * a * a / (1 + a));
    part *= f->shape == OVR_TEXTURE ? always : 1;
    return starved ? fmax(part, dry * a) : part;
}

/* Returns the factor of short waves: the pressure of a wave grows as 1/length,
 * and film thickness and viscosity depend on it. */
static double shortness(const ovr_feature_info *f)
{
    const double length = 0.3;
    double ratio = f->shape == OVR_WAVE ? length / f->wavelength : 0;
    return 1 + ratio * ratio;
}

/* Estimates the likely error of the minimum film thickness H caused by a
 * feature, times N^2. */
static double likely_of_feature(const ovr_setup *s, const ovr_feature_info *f,
                                double H, bool starved)
{
    const double thinnest = 0.05, thinnest_of_all = 0.02, raised = 0.8;
    const double ridges = 13, longer = 2.5;
    bool mean = strcmp(f->wavelength_is, "mean") == 0;
    bool thin = starved || (f->Rq > 0 && !mean);
    double r = (mean ? f->Rq : f->raised) / H, part;
    double left = fmax(1 - r, thin ? thinnest_of_all : thinnest);
    double steps = ovr_setup_step(s) / s->mesh;
    bool twice = s->transient && steps > 1.5;
    if (mean)
        part = ridges * r / (left * left);
    else
        part = fmax(shortness(f) * raised * r / left,
                    sunk(f, (f->amplitude - f->raised) / H, starved));
    return (twice ? longer : 1) * part;
}

static double of_feature(const ovr_setup *s, const ovr_feature_info *f,
                         double arriving)
{
    bool mean = strcmp(f->wavelength_is, "mean") == 0;
    double A = mean ? f->Rq : f->amplitude, N = f->wavelength / s->mesh;
    double H = ovr_film_central_moes(s->contact->M, s->contact->L);
    bool likely = s->accuracy_of == OVR_ACCURACY_ALL;
    double thinner = fmin(H, arriving), part = A / (likely ? thinner : H);
    if (s->accuracy_of == OVR_ACCURACY_FEATURES)
        part = 1; /* relative to the effect of the features */
    double square = likely ? likely_of_feature(s, f, thinner, arriving < H)
                           : 8 * part;
    ovr_scheme scheme = f->speed != 0 ? s->options->scheme : OVR_CHARACTERISTIC;
    if (scheme == OVR_UPSTREAM1)
        return 3 * part / N;
    return (scheme == OVR_UPSTREAM2 ? 12.5 : 1) * square / (N * N);
}

/* The largest part of a feature that the solution contains. */
static double of_features(const ovr_setup *s, double arriving)
{
    size_t n = s->surfaces ? ovr_surfaces_count(s->surfaces) : 0;
    double worst = 0;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info f = ovr_surfaces_info(s->surfaces, k);
        if (s->transient || f.speed == 0)
            worst = fmax(worst, of_feature(s, &f, arriving));
    }
    return worst;
}

/* Returns the factor of the error of H_min in a film that is supplied with f
 * times the central film thickness. The constriction becomes narrower and less
 * deep with decreasing f, and vanishes at f = 0.33 to 0.55. */
static double of_starvation(const ovr_setup *s, double arriving)
{
    const double vanished = 0.38, maximum = 6, power = -2.5;
    double f = arriving / ovr_film_central_moes(s->contact->M, s->contact->L);
    if (!(f < 1) || f < vanished || s->accuracy_of == OVR_ACCURACY_H_CEN)
        return 1;
    return fmin(pow(f, power), maximum);
}

double ovr_expected(const ovr_setup *s, double arriving)
{
    double warming = s->transient ? ovr_setup_lag(s) * ovr_setup_step(s) : 0;
    double starved = of_starvation(s, arriving);
    if (s->accuracy_of != OVR_ACCURACY_ALL)
        return starved * largest_of_film(s) + of_features(s, arriving);
    return fmax(starved * mean_of_film(s) + of_features(s, arriving) + warming,
                of_friction(s));
}

double ovr_expected_at_most(const ovr_setup *s)
{
    const double spread = 2; /* bounds have no spread */
    return (s->accuracy_of == OVR_ACCURACY_ALL ? spread : 1) * s->expected;
}
