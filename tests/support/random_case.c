/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "random_case.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "contact/film_formula.h"
#include "overroll/case.h"
#include "overroll/simulation.h"
#include "test.h"

static double draw(test_random_case *d, double low, double high)
{
    return test_random(&d->state, low, high);
}

static bool chance(test_random_case *d, double share)
{
    return draw(d, 0, 1) < share;
}

__attribute__((format(printf, 2, 3))) static void add(test_random_case *d,
                                                      const char *words, ...)
{
    va_list values;
    va_start(values, words);
    d->length += vsnprintf(d->text + d->length,
                           sizeof d->text - (size_t)d->length, words, values);
    va_end(values);
    assert_true((size_t)d->length < sizeof d->text);
}

/* Writes shear rates and stresses of a rheological model that is Newtonian
 * below 5 MPa and whose stress increases slowly above. */
void test_write_points(const char *path)
{
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fprintf(out, "rate [1/s], stress [MPa]\n");
    for (int k = 0; k < 40; k++) {
        double y = exp(-4 + 0.4 * k);
        fprintf(out, "%.9g, %.9g\n", 1e5 * y,
                5 * y * pow(1 + pow(y, 1.5), -0.6 / 1.5));
    }
    fclose(out);
}

static void lubricant(test_random_case *d)
{
    double stress = exp(draw(d, log(2), log(15))), n = draw(d, 0.3, 0.8);
    int law = (int)draw(d, 0, 4);
    add(d, "[lubricant]\nalpha = 17 1/GPa\np0 = 198 MPa\nz = 0.68\n");
    if (law == 0)
        add(d, "rheology = eyring\neyring_stress = %.6g MPa\n", stress);
    else if (law == 3)
        add(d, "rheology = table\nrheology_file = thinning.csv\n");
    else
        add(d,
            "rheology = carreau\ncarreau_form = %s\ncarreau_n = %.6g\n"
            "carreau_stress = %.6g MPa\n",
            law == 1 ? "rate" : "stress", n, stress);
}

static void feature(test_random_case *d, int surface, double H, double D)
{
    static const char *const shapes[] = {"dent", "bump", "ridge"};
    int shape = (int)draw(d, 0, 3);
    add(d,
        "[feature d%d]\nsurface = %d\nshape = %s\n%s = %.6g\nwidth = %.6g\n"
        "arrival = %.6g\n",
        surface, surface, shapes[shape], shape ? "height" : "depth",
        H * draw(d, 0.05, 0.35), fmax(12 * D, draw(d, 0.2, 1)),
        draw(d, 0.5, 4));
}

static void roughness(test_random_case *d, int surface, double H, double D)
{
    add(d,
        "[feature r%d]\nsurface = %d\nshape = roughness\nRq = %.6g\n"
        "rolloff = %.6g\nshortest = %.6g\nlength = %.6g\nseed = %d\n"
        "start = %.6g\n",
        surface, surface, H * draw(d, 0.01, 0.06), draw(d, 0.4, 1.2), 12 * D,
        draw(d, 2, 5), (int)draw(d, 1, 1e6), draw(d, -4, -1));
}

/* Adds [load], [speed] or [sliding] with a ramp, a sine or a step. */
static void history(test_random_case *d, const char *section, double minimum,
                    double maximum, double swing)
{
    int kind = (int)draw(d, 0, 3);
    add(d, "[%s]\n", section);
    if (kind == 0)
        add(d, "history = sine\namplitude = %.6g\nperiod = %.6g\n",
            draw(d, 0, swing), draw(d, 1, 4));
    else
        add(d, "history = %s\nto = %.6g\nstart = %.6g\n%s",
            kind == 1 ? "ramp" : "step", draw(d, minimum, maximum),
            draw(d, 0.2, 2), kind == 1 ? "duration = 1\n" : "");
}

static double mesh(int level)
{
    return 5.5 / (7 << level);
}

static void contact(test_random_case *d, const char *radius, double M, double L,
                    int level)
{
    add(d,
        "[contact]\n%sM = %.6g\nL = %.6g\nmodulus = 226 GPa\n"
        "slide_to_roll = %.6g\n[domain]\nlevel = %d\ninlet = -4\n"
        "outlet = 1.5\n",
        radius, M, L, draw(d, -2, 2), level);
}

static void surfaces(test_random_case *d, double H, double D)
{
    for (int surface = 1; surface <= 2; surface++) {
        if (chance(d, 0.7))
            feature(d, surface, H, D);
        if (chance(d, 0.6))
            roughness(d, surface, H, D);
    }
}

static void begin(test_random_case *d, uint64_t seed)
{
    d->state = seed;
    d->length = 0;
}

void test_thinning_case(test_random_case *d, uint64_t seed, int level)
{
    begin(d, seed);
    double M = 5 * pow(40, draw(d, 0, 1)), L = draw(d, 2.5, 14);
    contact(d, "", M, L, level);
    add(d, "[time]\nend = 4\n");
    lubricant(d);
    surfaces(d, ovr_film_central_moes(M, L), mesh(level));
    if (chance(d, 0.4)) /* larger jumps fail also in Newtonian films */
        history(d, "load", 0.9, 1.1, 0.3);
    if (chance(d, 0.4))
        history(d, "speed", 0.5, 2, 0.3);
    if (chance(d, 0.5))
        history(d, "sliding", -2, 2, 2);
}

/* -------------------------------------------------- all models in combination
 */

/* True if p_h is 0.4 to 2 GPa, as is usual for heat and rheological models. */
static bool has_usual_pressure(const char *text)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_setup *s = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    assert_non_null(s);
    bool usual = s->contact->ph > 0.4e9 && s->contact->ph < 2e9;
    ovr_setup_free(s);
    ovr_case_free(c);
    return usual;
}

/* Adds mass-conserving cavitation and a starved supply, or nothing. */
static void supply(test_random_case *d, double H)
{
    int kind = (int)draw(d, 0, 3);
    if (kind)
        add(d, "[cavitation]\nmodel = conserving\n");
    if (kind == 2)
        add(d,
            "[supply]\nmodel = film\nthickness_1 = %.6g\n"
            "thickness_2 = %.6g\n",
            H * draw(d, 0.2, 0.9), H * draw(d, 0.2, 0.9));
}

static void steps(test_random_case *d)
{
    int kind = (int)draw(d, 0, 3);
    add(d, "[time]\nend = 3\n");
    if (kind)
        add(d, "step = %s\n", kind == 1 ? "adaptive" : "0.02");
}

void test_mixed_case(test_random_case *d, uint64_t seed, int level)
{
    double M, L, H;
    begin(d, seed);
    do {
        d->length = 0;
        M = 5 * pow(40, draw(d, 0, 1)), L = draw(d, 2.5, 14);
        contact(d, "radius = 12.7 mm\nviscosity = 8.9152 mPa.s\n", M, L, level);
    } while (!has_usual_pressure(d->text));
    H = ovr_film_central_moes(M, L);
    steps(d);
    if (chance(d, 0.75))
        lubricant(d);
    if (chance(d, 0.5))
        add(d, "[heat]\nmodel = lobatto\ntemperature = 80 degC\n");
    supply(d, H);
    if (chance(d, 0.2))
        add(d, "[stress]\nsurface = both\n");
    surfaces(d, H, mesh(level));
    if (chance(d, 0.4))
        history(d, "load", 0.7, 1.4, 0.3);
    if (chance(d, 0.4))
        history(d, "speed", 0.5, 2, 0.3);
    if (chance(d, 0.5))
        history(d, "sliding", -2, 2, 2);
}

void test_jump_case(test_random_case *d, uint64_t seed, double *share)
{
    double M, L, H;
    int level;
    begin(d, seed);
    level = (int)draw(d, 6, 9);
    do {
        d->length = 0;
        M = 5 * pow(40, draw(d, 0, 1)), L = draw(d, 2.5, 14);
        contact(d, "radius = 12.7 mm\nviscosity = 8.9152 mPa.s\n", M, L, level);
    } while (!has_usual_pressure(d->text));
    H = ovr_film_central_moes(M, L);
    *share = draw(d, 0.3, 1.2);
    add(d, "[time]\nend = 0.8\nstep = %.6g\n",
        mesh(level) * 0.5 * pow(8, draw(d, 0, 1)));
    add(d, "[load]\nhistory = step\nto = %.6g\nstart = 0.2\n",
        draw(d, 0.5, 1.5));
    add(d, "[cavitation]\nmodel = conserving\n");
    if (chance(d, 0.5))
        lubricant(d);
    if (chance(d, 0.3))
        add(d, "[heat]\nmodel = lobatto\ntemperature = 80 degC\n");
    if (chance(d, 0.5))
        surfaces(d, H, mesh(level));
}

static double logarithmic(test_random_case *d, double low, double high)
{
    return low * pow(high / low, draw(d, 0, 1));
}

static double slip(test_random_case *d)
{
    static const double low[] = {0, 0, 0.3, 1.5, 2},
                        high[] = {0, 0.3, 1.9, 2, 3};
    int k = (int)draw(d, 0, 6) % 5;
    double S = draw(d, low[k], high[k]);
    return draw(d, 0, 2) < 1 ? S : -S;
}

static void flow_law(test_random_case *d)
{
    int k = (int)draw(d, 0, 4);
    if (k == 1 || k == 2) {
        add(d, "rheology = eyring\neyring_stress = %.6g MPa\n",
            logarithmic(d, 2, 20));
    } else if (k == 3) {
        add(d, "rheology = carreau\ncarreau_form = stress\n");
        add(d, "carreau_n = %.6g\n", draw(d, 0.3, 0.8));
        add(d, "carreau_stress = %.6g MPa\n", logarithmic(d, 0.5, 8));
    }
    if (draw(d, 0, 4) < 1)
        add(d, "limiting_shear = %.6g\n", draw(d, 0.03, 0.1));
}

void test_stays_case(test_random_case *d, uint64_t seed)
{
    *d = (test_random_case){.state = seed};
    add(d, "[contact]\nmodulus = 226 GPa\n");
    add(d, "hertz_pressure = %.6g GPa\n", draw(d, 0.4, 2));
    add(d, "radius = %.6g mm\n", logarithmic(d, 3, 30));
    add(d, "mean_speed = %.6g m/s\n", logarithmic(d, 0.1, 20));
    add(d, "slide_to_roll = %.6g\n", slip(d));
    add(d, "[lubricant]\nviscosity = %.6g mPa.s\n", logarithmic(d, 3, 100));
    add(d, "alpha = %.6g 1/GPa\n", draw(d, 12, 24));
    flow_law(d);
    add(d, "[domain]\nlevel = %d\n", draw(d, 0, 3) < 1 ? 6 : 7);
    add(d, "[time]\nend = 3\nscheme = %s\n",
        draw(d, 0, 3) < 1 ? "upstream2" : "characteristic");
    if (draw(d, 0, 4) >= 1)
        add(d, "[heat]\nmodel = lobatto\ntemperature = %.6g degC\n",
            draw(d, 20, 120));
    if (draw(d, 0, 5) >= 2)
        return;
    add(d, "[cavitation]\nmodel = conserving\n");
    if (draw(d, 0, 5) >= 2)
        return;
    add(d, "[supply]\nmodel = film\nthickness_1 = %.6g um\n",
        logarithmic(d, 0.025, 1));
    add(d, "thickness_2 = %.6g um\n", logarithmic(d, 0.025, 1));
}

/* ---------------------------------------------- Hot contacts that slide */

/* Returns a word of rheology from the table of keys. */
static const char *any_flow_law(test_random_case *d)
{
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info key = ovr_parameter_at(k);
        size_t words = 0;
        if (strcmp(key.section, "lubricant") || strcmp(key.key, "rheology"))
            continue;
        while (key.choices[words])
            words++;
        return key.choices[(size_t)draw(d, 0, (double)words)];
    }
    assert_true(false);
    return NULL;
}

static void any_rheology(test_random_case *d)
{
    const char *law = any_flow_law(d);
    add(d, "rheology = %s\n", law);
    if (!strcmp(law, "eyring"))
        add(d, "eyring_stress = %.6g MPa\n", logarithmic(d, 2, 20));
    else if (!strcmp(law, "carreau"))
        add(d,
            "carreau_form = %s\ncarreau_n = %.6g\ncarreau_stress = %.6g MPa\n",
            chance(d, 0.5) ? "rate" : "stress", draw(d, 0.3, 0.8),
            logarithmic(d, 0.5, 8));
    else if (!strcmp(law, "table"))
        add(d, "rheology_file = thinning.csv\n");
    if (chance(d, 0.4))
        add(d, "limiting_shear = %.6g\n", draw(d, 0.03, 0.1));
}

void test_hot_start_case(test_random_case *d, uint64_t seed)
{
    begin(d, seed);
    double S = draw(d, 2, 6);
    add(d, "[contact]\nmodulus = 226 GPa\n");
    add(d, "hertz_pressure = %.6g GPa\n", draw(d, 0.4, 1.6));
    add(d, "radius = %.6g mm\n", logarithmic(d, 3, 30));
    add(d, "mean_speed = %.6g m/s\n", logarithmic(d, 0.5, 20));
    add(d, "slide_to_roll = %.6g\n", chance(d, 0.5) ? S : -S);
    add(d, "[lubricant]\nviscosity = %.6g mPa.s\n", logarithmic(d, 3, 100));
    add(d, "alpha = %.6g 1/GPa\n", draw(d, 12, 24));
    any_rheology(d);
    add(d, "[heat]\nmodel = lobatto\ntemperature = %.6g degC\n",
        draw(d, 20, 120));
    if (chance(d, 0.2))
        add(d, "[cavitation]\nmodel = conserving\n");
    add(d, "[domain]\nlevel = %d\n", (int)draw(d, 6, 10));
}
