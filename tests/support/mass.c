/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/mass.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "contact/film_formula.h"
#include "support/contact.h"
#include "support/test.h"
#include "surface/surfaces.h"

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool all_finite(size_t n, const double *values)
{
    for (size_t i = 0; i < n; i++)
        if (!isfinite(values[i]))
            return false;
    return true;
}

/* True for quantities that may be NAN, which means "not defined": friction
 * coefficients without b/R, quantities of heat in isothermal films, and the
 * minimum gap in the cavity if it is not smaller than the film thickness. */
static bool may_be_undefined(const ovr_observable *row)
{
    const char *name = row->name ? row->name : "";
    return strstr(name, "friction_coefficient") ||
           (row->key && strcmp(row->key, "H_min_cavity") == 0) ||
           row->kind == OVR_KIND_TEMPERATURE || strstr(name, "temperature") ||
           strstr(name, "heat_flow") || strstr(name, "energy_defect");
}

static bool observed_numbers(const ovr_observation *o)
{
    const ovr_observable *row;
    for (size_t k = 0; (row = ovr_observable_at(k)); k++)
        if (row->axes == OVR_AT_STEPS && !may_be_undefined(row) &&
            !row->needs && !isfinite(ovr_observable_value(row, o)) &&
            isfinite(o->P_spike + o->P_spike_located))
            return false;
    return isfinite(o->H_min + o->H_min_located + o->H_cen + o->P_max +
                    o->load + o->residual + o->mass_flow);
}

static bool numbers(const ovr_simulation *sim)
{
    const ovr_state *s = ovr_simulation_state(sim);
    return all_finite(s->n, s->P) && all_finite(s->n, s->H) &&
           isfinite(s->H0) && observed_numbers(ovr_simulation_observation(sim));
}

static ovr_simulation *create(const test_contact *t, const ovr_options *o,
                              test_ending *end)
{
    return ovr_simulation_create(&t->contact, &t->lubricant, o, NULL,
                                 &end->err);
}

test_ending test_steady_case(uint64_t seed)
{
    uint64_t random = seed;
    test_ending end = {.number = true};
    ovr_options o = test_options();
    double M = exp(test_random(&random, log(2), log(1000)));
    double L = test_random(&random, 0, 15), began = now();
    o.level = (int)test_random(&random, 6, 11);
    if (test_random(&random, 0, 1) < 0.5)
        o.inlet = o.outlet = NAN;
    test_contact t = test_contact_make(M, L);
    snprintf(end.what, sizeof end.what, "M %.4g L %.4g level %d %s", M, L,
             o.level, isnan(o.inlet) ? "auto" : "-4");
    ovr_simulation *sim = create(&t, &o, &end);
    if (!sim)
        return end;
    end.err.status = ovr_simulation_steady(sim, &end.err);
    end.number = numbers(sim);
    end.cycles = ovr_simulation_observation(sim)->cycles;
    end.retries = ovr_simulation_observation(sim)->retries;
    ovr_simulation_free(sim);
    end.seconds = now() - began;
    return end;
}

/* Draws a local feature, up to `deep` high. It starts upstream of the inlet if
 * its surface is fast enough, and otherwise grows in place. */
static ovr_feature_form random_feature(uint64_t *random, double deep,
                                       double u[2], double inlet)
{
    static const ovr_shape shapes[] = {OVR_DENT,  OVR_BUMP,   OVR_INDENT,
                                       OVR_RIDGE, OVR_GROOVE, OVR_TEXTURE};
    ovr_feature_form f = ovr_feature_form_default();
    double size = deep * test_random(random, 0.05, 1);
    f.shape = shapes[(int)test_random(random, 0, 6)];
    f.width = exp(test_random(random, log(0.1), log(2)));
    f.surface = test_random(random, 0, 1) < 0.5 ? 1 : 2;
    if (f.shape == OVR_BUMP || f.shape == OVR_RIDGE)
        f.height = size;
    else
        f.depth = size;
    if (f.shape == OVR_INDENT)
        f.shoulder = size * test_random(random, 0, 0.5);
    if (f.shape == OVR_GROOVE)
        f.flank = f.width * test_random(random, 0.3, 1);
    if (f.shape == OVR_TEXTURE) {
        f.wavelength = f.width * test_random(random, 1.2, 3);
        f.grow = 1;
        f.origin = 0;
    } else if (u[f.surface - 1] < 0.2) {
        f.grow = 1;
        f.start = test_random(random, -1.5, 1);
    } else {
        f.start = inlet - (f.shape == OVR_GROOVE ? 1 : 2) * f.width;
    }
    return f;
}

static double end_of(const ovr_feature_form *f, double speed, double outlet)
{
    if (speed < 0.2)
        return 4;
    if (f->shape == OVR_TEXTURE)
        return 5;
    return fmin((outlet + f->width - f->start) / speed, 20);
}

static void march(ovr_simulation *sim, double T, test_ending *end)
{
    ovr_march march = {.end = T};
    end->err.status = ovr_simulation_steady(sim, &end->err);
    if (!end->err.status)
        end->err.status = ovr_simulation_march(sim, &march, &end->err);
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    end->number = numbers(sim);
    end->cycles = (int)s->cycles;
    end->retries = (int)s->retries;
    end->steps = s->steps;
    end->marked = s->marked;
}

/* Adds one to three features and returns the time at which they have left. */
static double add_features(uint64_t *random, const test_contact *t,
                           ovr_surfaces *surfaces, test_ending *end)
{
    double deep = 1.5 * ovr_film_central_moes(t->contact.M, t->contact.L);
    double u[2] = {t->contact.u1_ratio, t->contact.u2_ratio}, T = 0;
    int count = (int)test_random(random, 1, 4);
    size_t used = strlen(end->what);
    for (int k = 0; k < count && !end->err.status; k++) {
        ovr_feature_form f = random_feature(random, deep / count, u, -4);
        double speed = u[f.surface - 1], last = end_of(&f, speed, 1.5);
        T = last > T ? last : T;
        used += (size_t)snprintf(
            end->what + used, sizeof end->what - used,
            "; %s %.3g x %.3g u %.2g", ovr_shape_name((int)f.shape),
            (isnan(f.depth) ? f.height : f.depth) / deep * 1.5, f.width, speed);
        end->err.status = ovr_surfaces_add(surfaces, &f, &end->err);
    }
    return T;
}

test_ending test_transient_case(uint64_t seed)
{
    uint64_t random = seed;
    test_ending end = {.number = true};
    ovr_options o = test_options();
    double M = exp(test_random(&random, log(5), log(200)));
    double L = test_random(&random, 2, 15), began = now();
    test_contact t = test_contact_make(M, L);
    o.level = 7;
    t.contact.u1_ratio = test_random(&random, 0, 2);
    t.contact.u2_ratio = 2 - t.contact.u1_ratio;
    snprintf(end.what, sizeof end.what, "M %.4g L %.4g", M, L);
    ovr_surfaces *surfaces = ovr_surfaces_create(&t.contact, NULL, 5.5 / 896,
                                                 NULL, &end.err);
    assert_non_null(surfaces);
    double T = add_features(&random, &t, surfaces, &end);
    ovr_simulation *sim = end.err.status ? NULL : create(&t, &o, &end);
    if (sim) {
        ovr_simulation_surface(sim, ovr_surfaces_heights, surfaces);
        march(sim, T, &end);
    }
    ovr_simulation_free(sim);
    ovr_surfaces_free(surfaces);
    end.seconds = now() - began;
    return end;
}

/* True if a failure has a status other than bad input and a message of one
 * line. */
static bool named(const ovr_error *err)
{
    return (err->status == OVR_NOT_CONVERGED ||
            err->status == OVR_IMPOSSIBLE) &&
           strlen(err->message) > 20 && !strchr(err->message, '\n');
}

static void add(test_statistics *s, const test_ending *end)
{
    s->cases++;
    s->converged += !end->err.status;
    s->retried += !end->err.status && end->retries > 0;
    s->gave_up += end->err.status != OVR_OK;
    s->impossible += end->err.status == OVR_IMPOSSIBLE;
    s->unnamed += end->err.status && !named(&end->err);
    s->not_numbers += !end->number;
    s->steps += end->steps;
    s->marked += end->marked;
    s->worst_marked = end->marked > s->worst_marked ? end->marked
                                                    : s->worst_marked;
    s->cycles += end->cycles;
    s->seconds += end->seconds;
    s->slowest = fmax(s->slowest, end->seconds);
}

test_statistics test_mass(const char *name, test_ending (*run)(uint64_t seed),
                          uint64_t first, long count)
{
    test_statistics s = {0};
    for (long k = 0; k < count; k++) {
        test_ending end = run(first + (uint64_t)k);
        add(&s, &end);
        if (end.err.status || end.marked || !end.number)
            printf("%s %ld: %s: %ld marked of %ld%s %s\n", name,
                   (long)first + k, end.what, end.marked, end.steps,
                   end.number ? "" : ", NOT NUMBERS",
                   end.err.status ? end.err.message : "");
    }
    printf("%s: %ld cases, %ld converged (%ld after retries), %ld gave up "
           "(%ld impossible, %ld unnamed), %ld with NaN; %ld steps, %ld marked "
           "(%ld in one), "
           "%ld cycles; %.1f s, slowest %.2f s\n",
           name, s.cases, s.converged, s.retried, s.gave_up, s.impossible,
           s.unnamed, s.not_numbers, s.steps, s.marked, s.worst_marked,
           s.cycles, s.seconds, s.slowest);
    return s;
}
