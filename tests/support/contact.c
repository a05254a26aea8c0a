/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact.h"

#include <math.h>

#include "test.h"

static const double pi = 3.14159265358979323846;

test_contact test_contact_make(double M, double L)
{
    test_contact t;
    ovr_error err;
    ovr_conditions given = ovr_conditions_default();
    given.M = M;
    given.L = L;
    given.alpha = 1.7e-8;
    CHECK_OK(ovr_contact_resolve(&given, &t.contact, &err), &err);
    CHECK_OK(ovr_lubricant_make(&t.contact, OVR_ROELANDS, OVR_DOWSON_HIGGINSON,
                                1.98e8, 0.68, &t.lubricant, &err),
             &err);
    return t;
}

ovr_simulation *test_simulation(double M, double L, const ovr_options *options)
{
    ovr_error err = {0};
    test_contact t = test_contact_make(M, L);
    ovr_simulation *sim = ovr_simulation_create(&t.contact, &t.lubricant,
                                                options, NULL, &err);
    CHECK_OK(err.status, &err);
    assert_non_null(sim);
    return sim;
}

static double smoothstep(double x)
{
    x = fmin(fmax(x, 0), 1);
    return x * x * x * (10 + x * (6 * x - 15));
}

static double height(const test_feature *f, double T, double X)
{
    double size = f->grow > 0 ? smoothstep(T / f->grow) : 1;
    if (f->kind == 'w')
        return f->A * size * cos(2 * pi * (X - f->u * T) / f->width);
    double xi = (X - f->start - f->u * T) / f->width;
    return f->A * size * pow(10, -10 * xi * xi) * cos(2 * pi * xi);
}

void test_feature_heights(void *feature, double T, size_t n, const double *X,
                          double *S)
{
    for (size_t i = 0; i < n; i++)
        S[i] = height(feature, T, X[i]);
}

ovr_options test_options(void)
{
    ovr_options o = ovr_options_default();
    o.inlet = -4, o.outlet = 1.5;
    o.order = 2;
    o.scheme = OVR_UPSTREAM2;
    o.faces = OVR_FACES_ARITHMETIC;
    return o;
}
