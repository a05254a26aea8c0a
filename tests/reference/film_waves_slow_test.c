/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The predicted Rq of the film of surfaces that slide is compared with runs of
 * random waves, 5 per class, 40 in make verify. M is 8 to 300 (light: 2 to 8),
 * L 4 to 20, p_h up to 3.5 GPa. Wavelengths are 0.1 to 2 b, amplitudes 0.02 to
 * 0.3 of the minimum film thickness. The bounds are those of `check`.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "contact/film_formula.h"
#include "run/run.h"
#include "support/test.h"

typedef enum surfaces { ONE, BOTH, AT_REST } surfaces;

typedef struct wave_class {
    const char *name;
    surfaces which;
    bool thins, light;
    double low, high; /* of the ratio of Rq */
} wave_class;

enum { TEXT = 1000 };

static double geometric(uint64_t *state, double from, double to)
{
    return from * pow(to / from, test_random(state, 0, 1));
}

/* Returns the minimum film thickness of smooth surfaces. */
static double write_contact(const wave_class *of, uint64_t *state, char *text,
                            double *S)
{
    static const double slides[] = {-1.8, -1, -0.5, -0.2, 0.2, 0.5, 1, 1.8};
    double M, L, alpha, ph;
    do {
        M = of->light ? geometric(state, 2, 8) : geometric(state, 8, 300);
        L = geometric(state, 4, 20);
        alpha = test_random(state, 15, 25);
        ph = L * sqrt(M / 6.283185307179586) / alpha;
    } while (ph > 3.5);
    *S = slides[(int)test_random(state, 0, 7.99)];
    if (of->which == AT_REST)
        *S = *S < 0 ? -2 : 2;
    char law[200] = "rheology = newtonian\n";
    if (of->thins && test_random(state, 0, 1) < 0.5)
        snprintf(law, sizeof law, "rheology = eyring\neyring_stress = %g MPa\n",
                 test_random(state, 2, 10));
    else if (of->thins)
        snprintf(law, sizeof law,
                 "rheology = carreau\ncarreau_stress = %g MPa\n"
                 "carreau_n = %g\n",
                 test_random(state, 0.1, 10), test_random(state, 0.4, 0.8));
    snprintf(text, TEXT,
             "[contact]\nM = %g\nL = %g\nslide_to_roll = %g\n"
             "radius = 10 mm\nmodulus = 226 GPa\n"
             "[lubricant]\nalpha = %g 1/GPa\n%s[domain]\nlevel = %d\n%s",
             M, L, *S, alpha, law, M > 100 ? 8 : 7,
             of->which == AT_REST ? "" : "[time]\nend = 5\n");
    return ovr_film_fitted(M, L, 1).minimum;
}

static void add_wave(uint64_t *state, int surface, double H, char *text)
{
    size_t end = strlen(text);
    double length = geometric(state, 0.1, 2);
    snprintf(text + end, TEXT - end,
             "[feature w%d]\nshape = wave\nsurface = %d\namplitude = %g\n"
             "wavelength = %g\n",
             surface, surface, H * geometric(state, 0.02, 0.3), length);
}

/* Steep waves are no small ones: three times the bounds. */
static bool is_within(const wave_class *of, const ovr_rough_film *said,
                      double Rq, double H)
{
    double wider = said->but && strstr(said->but, "steep") ? 3 : 1;
    return fabs(said->film_Rq - Rq) < 0.02 * H ||
           (said->film_Rq > of->low / wider * Rq &&
            said->film_Rq < of->high * wider * Rq);
}

static bool predicts(const wave_class *of, uint64_t seed)
{
    uint64_t state = seed;
    char text[TEXT];
    double S, H = write_contact(of, &state, text, &S);
    int surface = of->which == AT_REST              ? S < 0 ? 1 : 2
                  : test_random(&state, 0, 1) < 0.5 ? 1
                                                    : 2;
    add_wave(&state, surface, H, text);
    if (of->which == BOTH)
        add_wave(&state, 3 - surface, H, text);
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_case *c = ovr_case_read_text(text, "waves.ini", NULL, NULL, &err);
    ovr_run *run = c ? ovr_run_create(c, &how, NULL, &err) : NULL;
    CHECK_OK(run ? ovr_run_execute(run, &err) : OVR_BAD_INPUT, &err);
    const ovr_run_info *info = ovr_run_get_info(run);
    double Rq = info->transient
                    ? ovr_simulation_statistics(info->sim)->extreme.film_Rq
                    : ovr_simulation_observation(info->sim)->film_Rq;
    bool within = is_within(of, info->predicted, Rq, H);
    if (!within)
        print_message("# seed %d, %s: predicted %.3g, run %.3g of H_min "
                      "(%s)\n%s\n",
                      (int)seed, of->name, info->predicted->film_Rq / H, Rq / H,
                      info->predicted->but, text);
    ovr_run_free(run);
    ovr_case_free(c);
    return within;
}

TEST(waves)
{
    static const wave_class classes[] = {
        {"one, Newtonian", ONE, false, false, 0.6, 1.4},
        {"one, shear thinning", ONE, true, false, 0.25, 1.4},
        {"two, Newtonian", BOTH, false, false, 0.6, 1.4},
        {"two, shear thinning", BOTH, true, false, 0.25, 1.4},
        {"at rest, Newtonian", AT_REST, false, false, 0.6, 1.4},
        {"at rest, shear thinning", AT_REST, true, false, 0.25, 1.4},
        {"light, Newtonian", ONE, false, true, 0.6, 1.4},
        {"light, shear thinning", ONE, true, true, 0.25, 1.4}};
    int draws = test_draws(5, 40);
    for (size_t k = 0; k < sizeof classes / sizeof *classes; k++) {
        int missed = 0;
        for (int i = 0; i < draws; i++)
            missed += !predicts(&classes[k], 5400 + 100 * k + (uint64_t)i);
        print_message("# seeds %d on: %d of %d %s outside\n",
                      (int)(5400 + 100 * k), missed, draws, classes[k].name);
        assert_true(missed == 0);
    }
}
