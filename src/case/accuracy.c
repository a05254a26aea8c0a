/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Errors of discretization that are to be expected, relative to the film.
 * With x = D/H^(2/3), the mesh over the length of the inlet's rise (H after
 * Moes), and for spike and exit k = (L/15)^2 (M/25)^(1/2), both factors at
 * most 1:
 *
 *   order   H_cen                   H_min: besides
 *     4     0.035 x^2 + 0.2 x^4     0.4 k x^1.3 + 2 x^3
 *     2     1.5 x^2                 0.55 k x^1.3
 *     1     0.6 x
 *
 * which bounds what was measured on random contacts, M = 5 to 1000, L = 1 to
 * 16, levels 4 to 10, beside level 13; where L is below 10 errors of order 4
 * are 5 to 20 times smaller.  A feature of height A on N meshes a width or
 * wavelength adds K (A/H)/N^2,  K = 2.5 along the characteristic, 30 by
 * upstream2, or 3 (A/H)/N by upstream1, measured on dents of 0.05 to 0.5 b and
 * waves of 0.1 b, rolling and sliding; what stands still, or is rough (A = Rq),
 * likewise.
 */
#include "case/accuracy.h"

#include <math.h>

#include "case/domain.h"
#include "contact/contact.h"
#include "contact/curvature.h"
#include "contact/film_formula.h"
#include "simulation/scheme.h"
#include "surface/surfaces.h"

/* The order that a solution reaches where nothing goes wrong. */
static int order_of(const ovr_setup *s)
{
    if (ovr_setup_corrected(s))
        return 4;
    return ovr_scheme_record(s->options->scheme)->order;
}

/* The accuracy of a contact of these M and L, its own half width b. */
static double of_mesh(const ovr_setup *s, double M, double L, double mesh)
{
    double x = mesh / pow(ovr_film_central_moes(M, L), 2. / 3);
    double spike = fmin(L * L / 225, 1) * fmin(sqrt(M / 25), 1) * pow(x, 1.3);
    bool least = s->accuracy_of == OVR_ACCURACY_H_MIN;
    int order = order_of(s);
    if (order == 4)
        return x * x * (0.035 + 0.2 * x * x) +
               (least ? 0.4 * spike + 2 * x * x * x : 0);
    return order == 2 ? 1.5 * x * x + (least ? 0.55 * spike : 0) : 0.6 * x;
}

/* The largest over the run counts, where the radius varies. */
double ovr_expected_of_mesh(const ovr_setup *s)
{
    enum { LOOKS = 64 };
    double most = of_mesh(s, s->contact->M, s->contact->L, s->mesh);
    if (!s->transient || !ovr_history_varies(s->radius))
        return most;
    for (int k = 0; k <= LOOKS; k++) {
        double T = ovr_setup_end(s) * k / LOOKS;
        double w = fmax(ovr_history_value(s->load, T), OVR_LEAST_START);
        double u = fmax(fabs(ovr_history_value(s->speed, T)), OVR_LEAST_START);
        ovr_instant at = ovr_instant_of(s->contact, w, u,
                                        1 / ovr_history_value(s->radius, T));
        most = fmax(most, of_mesh(s, at.M, at.L, s->mesh / at.s));
    }
    return most;
}

static double of_feature(const ovr_setup *s, const ovr_feature_info *f)
{
    const ovr_contact *c = s->contact;
    double A = f->Rq > 0 ? f->Rq : f->amplitude, N = f->wavelength / s->mesh;
    double part = A / ovr_film_central_moes(c->M, c->L);
    ovr_scheme scheme = f->speed != 0 ? s->options->scheme : OVR_CHARACTERISTIC;
    if (s->accuracy_of == OVR_ACCURACY_FEATURES)
        part = 1; /* of what they do to the film, whatever that is */
    if (scheme == OVR_UPSTREAM1)
        return 3 * part / N;
    return (scheme == OVR_UPSTREAM2 ? 100 : 8) * part / (N * N);
}

double ovr_expected_of_features(const ovr_setup *s)
{
    size_t n = s->surfaces ? ovr_surfaces_count(s->surfaces) : 0;
    double worst = 0;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info f = ovr_surfaces_info(s->surfaces, k);
        worst = fmax(worst, of_feature(s, &f));
    }
    return worst;
}
