/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "orders.h"

#include <math.h>
#include <stdio.h>

#include "contact.h"
#include "contact/contact.h"
#include "contact/film_formula.h"
#include "test.h"

typedef struct draw {
    double M, L, Sigma0, slip;
    int level;
} draw;

typedef struct tally {
    int solved, fallen, failed, wrong;
    long cycles;
    double finest; /* minimum D/H^(2/3) of solutions of second order */
} tally;

static ovr_simulation *simulation(const draw *d, const ovr_options *o)
{
    ovr_error err = {0};
    test_contact t = test_contact_make(d->M, d->L);
    ovr_flow_form form = ovr_flow_form_default();
    t.contact.u1_ratio = 1 + d->slip / 2;
    t.contact.u2_ratio = 1 - d->slip / 2;
    if (isfinite(d->Sigma0)) {
        form.rheology = OVR_EYRING;
        form.number = d->Sigma0;
    }
    CHECK_OK(ovr_lubricant_flow(&t.contact, &form, &t.lubricant, &err), &err);
    ovr_simulation *sim = ovr_simulation_create(&t.contact, &t.lubricant, o,
                                                NULL, &err);
    CHECK_OK(err.status, &err);
    return sim;
}

static void count(tally *t, const draw *d, const ovr_observation *o,
                  const ovr_error *err, double share)
{
    const double resolved = 0.29;
    bool failed = err->status != OVR_OK, second = !failed && o->order != 4;
    t->solved += !failed;
    t->failed += failed;
    t->fallen += second;
    t->cycles += failed ? 0 : o->cycles;
    t->wrong += share < resolved && (failed || second);
    if (second)
        t->finest = fmin(t->finest, share);
    if (failed || second)
        print_message("    M = %.17g, L = %.17g, Sigma0 = %.17g, slip = %.17g, "
                      "level %d, D/H^(2/3) = %.2f: %s\n",
                      d->M, d->L, d->Sigma0, d->slip, d->level, share,
                      failed ? err->message : "second order");
}

static void try(tally *t, const draw *d)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.order = 0;
    o.level = d->level;
    double D = (o.outlet - o.inlet) / (7 << d->level);
    double share = D / pow(ovr_film_central_moes(d->M, d->L), 2. / 3);
    ovr_simulation *sim = simulation(d, &o);
    ovr_simulation_steady(sim, &err);
    count(t, d, ovr_simulation_observation(sim), &err, share);
    ovr_simulation_free(sim);
}

static void report(const tally *t, uint64_t seed)
{
    print_message("    seed %llu: %d failed, %d of second order, the finest "
                  "with D/H^(2/3) = %.2f; %.1f cycles each\n",
                  (unsigned long long)seed, t->failed, t->fallen, t->finest,
                  (double)t->cycles / (double)t->solved);
    assert_int_equal(t->wrong, 0);
}

static void survey(uint64_t seed, int contacts, double range, bool eyring)
{
    tally t = {.finest = INFINITY};
    uint64_t state = seed;
    for (int k = 0; k < contacts; k++) {
        draw d = {.level = 7 + k % 3, .Sigma0 = INFINITY};
        d.M = 5 * pow(range, test_random(&state, 0, 1));
        d.L = test_random(&state, 0, 15);
        if (eyring) {
            d.Sigma0 = pow(10, test_random(&state, -1.5, 0));
            d.slip = test_random(&state, 0, 1);
        }
        try(&t, &d);
    }
    report(&t, seed);
}

void test_order_survey(uint64_t seed, int contacts)
{
    survey(seed, contacts, 200, false);
}

void test_order_survey_eyring(uint64_t seed, int contacts)
{
    survey(seed, contacts, 20, true);
}
