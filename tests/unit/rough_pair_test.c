/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dry contact and wear of two rough profiles: pressure against mean gap, and
 * worn profiles. */
#include <math.h>
#include <string.h>

#include "support/test.h"

#include "surface/rough_pair.h"

enum { N = 512 };
static const double PI = 3.14159265358979323846;
static double one[N], other[N], w[64];
static ovr_arena arena;
static ovr_rough_pair pair;
static ovr_asperity_table table;

static void take(bool both)
{
    const double *const z[2] = {one, both ? other : NULL};
    ovr_error err = {0};
    arena = ovr_arena_make(NULL);
    CHECK_OK(ovr_rough_pair_take(&pair, N, 3, z, &arena, &err), &err);
    CHECK_OK(ovr_rough_pair_law(&pair, &table, &arena, &err), &err);
}

static void waves(double *z, int from, double phase)
{
    memset(z, 0, N * sizeof *z);
    for (int k = from; k < 10 * from; k++)
        for (size_t i = 0; i < N; i++)
            z[i] += 0.1 * pow(k, -1.3) *
                    cos(2 * PI * k * (double)i / N + phase * k * k);
}

/* A sine in b and b^2/R: full at p* = 2 pi a/l ph; the area by Westergaard, a
 * node on either side, at all pressures of the table. */
TEST(law_of_a_sine_is_westergaards)
{
    const double a = 0.2, full = 2 * PI * a / 3;
    for (size_t i = 0; i < N; i++)
        one[i] = 7 + a * cos(2 * PI * (double)i / N);
    take(false);
    CHECK_CLOSE(pair.Rq, a / sqrt(2), 1e-12);
    CHECK_CLOSE(pair.slope, full / sqrt(2), 1e-4);
    for (size_t i = 0; i < table.n; i++) {
        double part = exp(table.ln_A[i]) / full;
        assert_true(part < 1);
        CHECK_NEAR(table.area[i], 2 / PI * asin(sqrt(part)), 2. / N);
    }
    assert_true(table.H[table.n - 1] < a);
    ovr_arena_release(&arena);
}

/* A decade of pressure over the slope about where self-affine profiles have
 * theirs, p/(E* slope) = 0.35 to 0.41 exp(-2 to -2.3 g), g = H/Rq, found of two
 * others by another method: the gap is off by less than 0.4 Rq. */
TEST(rough_profiles_follow_the_exponential_law)
{
    waves(one, 4, 1.7);
    waves(other, 4, 0.9);
    for (int both = 0; both < 2; both++) {
        take(both);
        for (size_t i = 0; i < table.n; i++) {
            double p = exp(table.ln_A[i]) / (2 * pair.slope);
            double g = table.H[i] / pair.Rq;
            if (p < 0.01 || p > 0.2)
                continue;
            print_message("p %.4f: gap %.3f Rq, area %.3f = %.2f p\n", p, g,
                          table.area[i], table.area[i] / p);
            CHECK_NEAR(g, log(0.38 / p) / 2.15, 0.4);
            assert_true(table.area[i] / p > 1.7 && table.area[i] / p < 4.2);
        }
        ovr_arena_release(&arena);
    }
}

static double sum_of(const double *z)
{
    double sum = 0;
    for (size_t i = 0; i < N; i++)
        sum += z[i] * pair.length / N;
    return sum;
}

/* What a contact takes is what the profiles have lost, to rounding; the
 * highest peak goes first. */
TEST(volume_is_kept)
{
    const double c[2] = {1e-3, 3e-4};
    double A[] = {0, 1e-9, 0.003, 0.2, 0.9, 4}, borne = 0, before[2], high = 0;
    waves(one, 4, 1.7);
    waves(other, 4, 0.9);
    take(true);
    memset(w, 0, sizeof w);
    assert_true(pair.points <= 64);
    for (size_t k = 0; k < sizeof A / sizeof *A; k++) {
        ovr_rough_pair_weigh(&pair, A[k], 0.1, w);
        borne += 0.1 * A[k];
    }
    for (int k = 0; k < 2; k++)
        before[k] = sum_of(pair.z[k]);
    for (size_t i = 0; i < N; i++)
        high = fmax(high, pair.z[0][i]);
    double deepest = ovr_rough_pair_deepest(&pair, c, w), maximum = 0;
    ovr_rough_pair_wear(&pair, c, w);
    for (int k = 0; k < 2; k++)
        CHECK_NEAR(before[k] - sum_of(pair.z[k]), c[k] * borne * pair.length,
                   1e-15);
    for (size_t i = 0; i < N; i++) {
        maximum = fmax(maximum, one[i] - pair.z[0][i]);
        assert_true(pair.z[0][i] < high);
    }
    CHECK_CLOSE(maximum, deepest, 1e-9);
    ovr_arena_release(&arena);
}

/* Wear at one pressure: peaks vanish, the contact area grows and the gap
 * closes. Another program: a wear volume of 0.066 Rq lowers the highest peak
 * from 2.94 to 1.83 Rq, doubles the contact area and closes 27 % of it. */
TEST(running_in_removes_the_peaks)
{
    const double load = 0.03;
    double high[2] = {0, 0}, A, slope, area[2], volume = 0, Rq;
    ovr_error err = {0};
    ovr_asperity_law law = {0};
    waves(one, 4, 1.7);
    take(false);
    Rq = pair.Rq;
    for (int jump = 0; jump <= 60; jump++) {
        double mean = 0, p = load * 2 * pair.slope, H = 3 * Rq;
        law.table = table;
        for (ovr_asperity_law_at(&law, H, &A, &slope); A < p;
             ovr_asperity_law_at(&law, H -= 1e-3 * Rq, &A, &slope))
            ;
        area[jump > 0] = ovr_asperity_law_area(&law, H);
        for (size_t i = 0; i < N; i++)
            mean += pair.z[0][i] / N;
        high[jump > 0] = 0;
        for (size_t i = 0; i < N; i++)
            high[jump > 0] = fmax(high[jump > 0], pair.z[0][i] - mean);
        if (jump == 60)
            break;
        memset(w, 0, sizeof w);
        ovr_rough_pair_weigh(&pair, p, 1, w);
        const double c[2] = {0.0011 * Rq / p, 0};
        volume += 0.0011;
        ovr_rough_pair_wear(&pair, c, w);
        CHECK_OK(ovr_rough_pair_law(&pair, &table, &arena, &err), &err);
    }
    print_message("%.3f Rq worn: peak %.2f to %.2f Rq, area %.3f to %.3f\n",
                  volume, high[0] / Rq, high[1] / Rq, area[0], area[1]);
    assert_true(high[1] < 0.8 * high[0]);
    assert_true(area[1] > 1.3 * area[0]);
    assert_true(pair.Rq < Rq);
    ovr_arena_release(&arena);
}
