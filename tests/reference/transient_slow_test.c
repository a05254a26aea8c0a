/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs compared with the exact discrete series of level 7 and with the
 * extrapolated histories at level 8. */
#include <math.h>

#include "contact/contact.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"
#include "truth.h"

typedef struct run {
    const char *name;
    test_feature feature;
    bool load; /* ramp to 1.2 over 2 */
    double end;
    ovr_scheme scheme;
    const truth_series *truth;
} run;

static const run discrete[] = {
    {"dent",
     {'l', -0.1, 0.5, -4.6, 1, 0},
     false,
     6.4,
     OVR_UPSTREAM2,
     &truth_dent_bdf2},
    {"dent",
     {'l', -0.1, 0.5, -4.6, 1, 0},
     false,
     6.4,
     OVR_CHARACTERISTIC,
     &truth_dent_characteristic},
    {"load", {'w', 0, 1, 0, 0, 0}, true, 6, OVR_UPSTREAM2, &truth_load_bdf2},
    {"wave",
     {'w', 0.02105, 0.5, 0, 1, 1},
     false,
     7,
     OVR_UPSTREAM2,
     &truth_wave_bdf2}};

static const run converged[] = {
    {"dent",
     {'l', -0.1, 0.5, -4.6, 1, 0},
     false,
     6.4,
     OVR_UPSTREAM2,
     &truth_dent_u1},
    {"load", {'w', 0, 1, 0, 0, 0}, true, 6, OVR_UPSTREAM2, &truth_load},
    {"standing dent",
     {'l', -0.06, 0.5, 0.2, 0, 1},
     false,
     8,
     OVR_UPSTREAM2,
     &truth_stat_dent}};

/* Compares as the run goes; keeps worst and summed relative errors. */
typedef struct watch {
    const truth_series *truth;
    size_t next;
    double T, H_min, H_cen; /* of the step before */
    double worst, sum_min, sum_cen;
} watch;

static void note(watch *w, double H_min, double H_cen)
{
    double a = fabs(H_min / w->truth->H_min[w->next] - 1);
    double b = fabs(H_cen / w->truth->H_cen[w->next] - 1);
    w->worst = fmax(w->worst, fmax(a, b));
    w->sum_min += a;
    w->sum_cen += b;
    w->next++;
}

static ovr_status every_16_steps(void *data, const ovr_simulation *sim,
                                 ovr_error *err)
{
    watch *w = data;
    const ovr_observation *o = ovr_simulation_observation(sim);
    (void)err;
    assert_false(o->marked);
    if (ovr_simulation_state(sim)->step % 16 == 0 && w->next < w->truth->count)
        note(w, o->H_min_located, o->H_cen);
    return OVR_OK;
}

static ovr_status at_given_times(void *data, const ovr_simulation *sim,
                                 ovr_error *err)
{
    watch *w = data;
    const ovr_observation *o = ovr_simulation_observation(sim);
    (void)err;
    assert_false(o->marked);
    while (w->next < w->truth->count && w->truth->T[w->next] <= o->T + 1e-12) {
        double s = o->T > w->T ? (w->truth->T[w->next] - w->T) / (o->T - w->T)
                               : 1;
        note(w, w->H_min + s * (o->H_min_located - w->H_min),
             w->H_cen + s * (o->H_cen - w->H_cen));
    }
    w->T = o->T;
    w->H_min = o->H_min_located;
    w->H_cen = o->H_cen;
    return OVR_OK;
}

static watch march(const run *r, int level, double tolerance,
                   ovr_status observe(void *, const ovr_simulation *,
                                      ovr_error *))
{
    ovr_error err;
    ovr_options o = test_options();
    ovr_history_form form = ovr_history_form_default();
    ovr_history *load = NULL;
    test_feature feature = r->feature;
    watch w = {.truth = r->truth};
    ovr_observer look = {observe, NULL, &w};
    ovr_march m = {.end = r->end, .count = 1, .observers = &look};
    o.level = level;
    o.scheme = r->scheme;
    o.tolerance = tolerance;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    if (r->load) {
        form.kind = OVR_HISTORY_RAMP;
        form.from = 1;
        form.to = 1.2;
        form.duration = 2;
        load = ovr_history_create(&form, NULL, &err);
        assert_non_null(load);
    }
    ovr_simulation_surface(sim, test_feature_heights, &feature);
    ovr_simulation_histories(sim, load, NULL);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    CHECK_OK(ovr_simulation_march(sim, &m, &err), &err);
    assert_true(w.next + 1 >= w.truth->count);
    ovr_history_free(load);
    ovr_simulation_free(sim);
    return w;
}

TEST(discrete_series_as_it_comes)
{
    for (size_t k = 0; k < sizeof discrete / sizeof *discrete; k++)
        CHECK_NEAR(march(&discrete[k], 7, 0, every_16_steps).worst, 0, 2e-6);
}

TEST(discrete_series_to_the_digits)
{
    for (size_t k = 0; k < sizeof discrete / sizeof *discrete; k++)
        CHECK_NEAR(march(&discrete[k], 7, 1e-8, every_16_steps).worst, 0, 1e-6);
}

/* 1 % at every time, 0.3 % in the mean. */
TEST(histories_at_level_8)
{
    for (size_t k = 0; k < sizeof converged / sizeof *converged; k++) {
        watch w = march(&converged[k], 8, 0, at_given_times);
        double count = (double)w.truth->count;
        CHECK_NEAR(w.worst, 0, 1e-2);
        CHECK_NEAR(w.sum_min / count, 0, 3e-3);
        CHECK_NEAR(w.sum_cen / count, 0, 3e-3);
    }
}
