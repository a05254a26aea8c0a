/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dry contact of a rough surface. */
#include <math.h>
#include <string.h>

#include "support/test.h"

#include "surface/dry_contact.h"

enum { MAX = 512 };
static const double PI = 3.14159265358979323846;
static double z[MAX], p[MAX];
static ovr_arena arena;

static ovr_dry_contact begin(size_t n, double length, double modulus)
{
    ovr_error err = {0};
    ovr_dry_contact of = {.length = length, .modulus = modulus};
    arena = ovr_arena_make(NULL);
    CHECK_OK(ovr_dry_contact_take(&of, n, &arena, &err), &err);
    for (size_t i = 0; i < n; i++)
        p[i] = 1;
    return of;
}

/* A sine of the amplitude a and the wavelength l touches over (2/pi) asin
 * sqrt(p/p*) of it, p* = pi E* a/l, from where on it touches everywhere
 * (Westergaard, J. Appl. Mech. 6 (1939) A49): to a node on either side. */
TEST(sine_contact_agrees_with_westergaard)
{
    const double a = 3, l = 0.7, E = 5, full = PI * E * a / l;
    ovr_dry_contact of = begin(MAX, l, E);
    for (size_t i = 0; i < MAX; i++)
        z[i] = a * cos(2 * PI * (double)i / MAX);
    for (double part = 0.05; part < 1; part += 0.1) {
        ovr_dry_state s = ovr_dry_contact_solve(&of, z, part * full, p);
        assert_true(s.found);
        CHECK_NEAR(s.area, 2 / PI * asin(sqrt(part)), 2. / MAX);
    }
    ovr_dry_state s = ovr_dry_contact_solve(&of, z, 1.5 * full, p);
    assert_true(s.found);
    CHECK_CLOSE(s.area, 1, 1e-12);
    CHECK_NEAR(s.gap, 0, 1e-8);
    for (size_t i = 0; i < MAX; i++)
        CHECK_NEAR(p[i], full * (1.5 + z[i] / a), 1e-6 * full);
    ovr_arena_release(&arena);
}

/* Deformation by the sum over waves, of one node's pressure. */
static double influence(size_t n, double l, double E, size_t apart)
{
    double sum = 0;
    for (size_t k = 1; k <= n / 2; k++)
        sum += (2 * k == n ? 1 : 2) * 2 / (E * 2 * PI * (double)k / l) *
               cos(2 * PI * (double)(k * apart) / (double)n) / (double)n;
    return sum;
}

/* Park & Miller's. */
static double next(unsigned *seed)
{
    *seed = (unsigned)(48271ULL * *seed % 2147483647);
    return *seed / 2147483647.;
}

/* What is found is what the conditions ask, which no other pressure does:
 * random waves, gaps by sums over all nodes. */
TEST(pressures_and_gaps_exclude_each_other)
{
    enum { N = 256, WAVES = 40 };
    const double l = 2, E = 2;
    static double k[N];
    ovr_dry_contact of = begin(N, l, E);
    unsigned seed = 7;
    for (size_t i = 0; i < N; i++)
        k[i] = influence(N, l, E, i);
    for (int w = 4; w < WAVES; w++) {
        double phase = 2 * PI * next(&seed);
        for (size_t i = 0; i < N; i++)
            z[i] += pow(w, -1.3) * cos(2 * PI * w * (double)i / N + phase);
    }
    for (double mean = 30; mean > 1e-3; mean /= 4) {
        ovr_dry_state s = ovr_dry_contact_solve(&of, z, mean, p);
        double sum = 0, gaps = 0, minimum = INFINITY, gap[N];
        assert_true(s.found);
        for (size_t i = 0; i < N; i++) {
            gap[i] = -z[i];
            for (size_t j = 0; j < N; j++)
                gap[i] += k[i > j ? i - j : j - i] * p[j];
            minimum = fmin(minimum, gap[i]);
        }
        for (size_t i = 0; i < N; i++) {
            assert_true(p[i] >= 0);
            assert_true(p[i] == 0 || gap[i] - minimum < 1e-7);
            sum += p[i] / N;
            gaps += (gap[i] - minimum) / N;
        }
        CHECK_CLOSE(sum, mean, 1e-12);
        CHECK_NEAR(s.gap, gaps, 1e-7);
        print_message("p %g: %d steps, gap %.4f, area %.3f\n", mean, s.steps,
                      s.gap, s.area);
    }
    ovr_arena_release(&arena);
}

/* Wears the heights by their pressures under light loads, by `depth` at the
 * most worn node. */
static void wear(size_t n, const double *worn, double depth)
{
    double most = 0;
    for (size_t i = 0; i < n; i++)
        most = fmax(most, worn[i]);
    for (size_t i = 0; i < n; i++)
        z[i] -= depth * worn[i] / most;
}

/* Summits that are worn flat: their nodes touch and lift off with little change
 * of pressure. These waves made the search end in a cycle of three states. */
TEST(worn_summits_converge)
{
    enum { N = 256, WAVES = 100, PASSES = 30 };
    static double worn[N];
    ovr_dry_contact of = begin(N, 2, 2);
    unsigned seed = 22;
    double squares = 0;
    of.enough = 1e-6;
    memset(z, 0, sizeof z);
    for (int w = 4; w < WAVES; w++) {
        double phase = 2 * PI * next(&seed);
        for (size_t i = 0; i < N; i++)
            z[i] += pow(w, -1.3) * cos(2 * PI * w * (double)i / N + phase);
    }
    for (size_t i = 0; i < N; i++)
        squares += z[i] * z[i] / N;
    for (int pass = 0; pass < PASSES; pass++) {
        memset(worn, 0, sizeof worn);
        for (size_t i = 0; i < N; i++)
            p[i] = 1;
        for (double mean = 30; mean > 1e-3; mean /= pow(10, 0.25)) {
            ovr_dry_state s = ovr_dry_contact_solve(&of, z, mean, p);
            assert_true(s.found);
            for (size_t i = 0; i < N; i++) {
                assert_true(p[i] >= 0);
                worn[i] += mean < 3 ? p[i] / mean : 0;
            }
        }
        wear(N, worn, 0.04 * sqrt(squares));
    }
    ovr_arena_release(&arena);
}
