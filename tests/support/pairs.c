/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/pairs.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/test.h"

#include "overroll/overroll.h"
#include "simulation/conflicts.h"

enum { SETTINGS = 11 };

/* Steel bodies on a coarse grid. */
static const char *const base[] = {"body 1.modulus=206 GPa",
                                   "body 2.modulus=206 GPa",
                                   "contact.viscosity=0.12 Pa.s",
                                   "contact.alpha=18 1/GPa",
                                   "domain.level=5",
                                   "domain.inlet=-5",
                                   "output.checkpoint=1 ms",
                                   "solver.tolerance=1e-9"};

/* A transient run of 20 steps with a moving dent. */
static const char *const moving[] = {
    "time.end=0.58", "feature dent.shape=dent", "feature dent.depth=0.02",
    "feature dent.width=2", "feature dent.start=-5"};

/* Contacts: two cylinders in rolling and sliding, or a machine element. */
static const struct contact {
    const char *name;
    unsigned determines; /* bits of features that the element determines */
    double first_order;  /* mass balance error at first order, check_balances */
    const char *set[SETTINGS];
} cylinders = {NULL,
               0,
               0.1,
               {"contact.load=60 kN/m", "contact.radius=10 mm",
                "contact.speed_1=5.2 m/s", "contact.speed_2=4.8 m/s"}};

#define HISTORIES                                                              \
    (1U << OVR_MODEL_TIME | 1U << OVR_MODEL_LOAD | 1U << OVR_MODEL_SPEED |     \
     1U << OVR_MODEL_SLIDING | 1U << OVR_MODEL_RADIUS)
static const struct contact elements[] = {
    {"gear",
     HISTORIES,
     0.2,
     {"gear.module=3 mm", "gear.teeth_1=20", "gear.teeth_2=40",
      "gear.centre=90 mm", "gear.face=20 mm", "gear.speed=3000 rpm",
      "gear.torque=100 N.m"}},
    /* Contact on flank and nose; the mean speed is negative on the nose. */
    {"cam",
     HISTORIES | 1U << OVR_MODEL_REVERSAL,
     0.02,
     {"cam.base_radius=34 mm", "cam.face=12 mm", "cam.speed=1500 rpm",
      "cam.lift=6 mm", "cam.rise=70 deg", "cam.spring=30 N/mm",
      "cam.preload=250 N", "cam.mass=100 g"}},
    {"roller_bearing",
     0,
     0.1,
     {"roller_bearing.roller=10 mm", "roller_bearing.rollers=14",
      "roller_bearing.length=9.6 mm", "roller_bearing.inner=54.991 mm",
      "roller_bearing.clearance=41 um", "roller_bearing.load=800 N",
      "roller_bearing.speed_inner=1000 rpm"}},
};
enum { ELEMENTS = sizeof elements / sizeof *elements };

/* Settings that activate a model feature; some features have several rows. */
static const struct way {
    ovr_model_feature part;
    const char *set[SETTINGS];
} ways[] = {
    {OVR_MODEL_TIME, {"time.end=0.58"}},
    {OVR_MODEL_UPSTREAM1, {"time.scheme=upstream1"}},
    {OVR_MODEL_UPSTREAM2, {"time.scheme=upstream2"}},
    {OVR_MODEL_CHARACTERISTIC, {"time.scheme=characteristic"}},
    {OVR_MODEL_ORDER_2, {"domain.order=2"}},
    {OVR_MODEL_ORDER_4, {"domain.order=4"}},
    {OVR_MODEL_PAPER_SMOOTHER, {"paper.smoother=hybrid"}},
    {OVR_MODEL_PAPER_BALANCE, {"paper.paper_balance=yes"}},
    {OVR_MODEL_FIXED_CYCLES, {"solver.stop=fixed", "paper.cycles=20"}},
    {OVR_MODEL_ADAPTIVE, {"time.step=adaptive"}},
    {OVR_MODEL_LOAD,
     {"load.history=ramp", "load.from=1", "load.to=1.1", "load.duration=0.5"}},
    {OVR_MODEL_SPEED,
     {"speed.history=ramp", "speed.from=1", "speed.to=0.9",
      "speed.duration=0.5"}},
    {OVR_MODEL_REVERSAL,
     {"speed.history=ramp", "speed.from=0.2", "speed.to=-0.2",
      "speed.duration=0.5"}},
    {OVR_MODEL_SLIDING,
     {"sliding.history=ramp", "sliding.to=0.2", "sliding.duration=0.5"}},
    {OVR_MODEL_RADIUS,
     {"radius.history=ramp", "radius.to=1.01", "radius.duration=1"}},
    {OVR_MODEL_FLOW_LAW,
     {"lubricant.rheology=eyring", "lubricant.eyring_stress=5 MPa"}},
    {OVR_MODEL_FLOW_LAW,
     {"lubricant.rheology=carreau", "lubricant.carreau_stress=5 MPa",
      "lubricant.carreau_n=0.5", "lubricant.limiting_shear=0.06"}},
    {OVR_MODEL_HEAT, {"heat.model=lobatto", "heat.temperature=60 degC"}},
    {OVR_MODEL_CONSERVING, {"cavitation.model=conserving"}},
    {OVR_MODEL_SUPPLY,
     {"cavitation.model=conserving", "supply.model=film",
      "supply.thickness_1=1.5 um", "supply.thickness_2=1.5 um",
      "supply.history=ramp", "supply.to=0.9", "supply.duration=0.5"}},
    {OVR_MODEL_PASSES,
     {"cavitation.model=conserving", "passes.number=2", "passes.loss=0.1"}},
    {OVR_MODEL_STRESS, {"stress.surface=both"}},
    {OVR_MODEL_FATIGUE,
     {"stress.surface=1", "fatigue.criterion=circle", "fatigue.alpha=0.3"}},
    {OVR_MODEL_PLASTIC,
     {"stress.surface=1", "plastic.surface=1", "plastic.hardening=kinematic",
      "plastic.yield=0.45 GPa", "plastic.modulus=5 GPa", "plastic.layers=8",
      "plastic.depth_max=0.9"}},
    {OVR_MODEL_PATCHES, {"domain.refine=spike", "domain.level=6"}},
    {OVR_MODEL_COATING,
     {"coating 1.thickness=60 um", "coating 1.modulus=206 GPa",
      "coating 1.conductivity=2 W/m.K", "coating 1.heat_capacity=1000 J/kg.K",
      "coating 1.density=2000 kg/m3"}},
    {OVR_MODEL_OTHER_MODULI,
     {"coating 1.thickness=3 um", "coating 1.modulus=100 GPa",
      "coating 1.conductivity=2 W/m.K", "coating 1.heat_capacity=1000 J/kg.K",
      "coating 1.density=2000 kg/m3", "coating 2.thickness=20 um",
      "coating 2.modulus=20 GPa", "coating 2.conductivity=20 W/m.K",
      "coating 2.heat_capacity=500 J/kg.K", "coating 2.density=5000 kg/m3"}},
    {OVR_MODEL_BOUNDARY,
     {"boundary.law=exponential", "boundary.Rq=150 nm", "boundary.slope=0.03",
      "boundary.layer=3 nm", "boundary.friction=0.11", "boundary.of=unresolved",
      "feature dent.shape=dent", "feature dent.depth=0.02",
      "feature dent.width=2", "feature dent.start=-5"}},
    {OVR_MODEL_MEAN_FILM,
     {"boundary.law=exponential", "boundary.Rq=150 nm", "boundary.slope=0.03",
      "boundary.of=all"}},
    {OVR_MODEL_WEAR,
     {"boundary.law=profile", "feature rough.shape=roughness",
      "feature rough.Rq=150 nm", "feature rough.length=4",
      "boundary.wear_1=1e-7 mm3/Nm", "boundary.passes=8000",
      "boundary.jump=1000"}},
    {OVR_MODEL_STRIP, {"strip.width=1"}},
    {OVR_MODEL_ROUGHNESS,
     {"feature rough.shape=roughness", "feature rough.Rq=10 nm",
      "feature rough.length=4", "feature rough.start=-5"}},
};
enum { WAYS = sizeof ways / sizeof *ways };

static bool in_time(const struct way *w)
{
    return w->part != OVR_MODEL_WEAR && w->part != OVR_MODEL_PATCHES &&
           w->part != OVR_MODEL_PAPER_SMOOTHER &&
           w->part != OVR_MODEL_PAPER_BALANCE;
}

static void set(ovr_case *c, const char *const *settings, size_t count)
{
    ovr_error err = {0};
    for (size_t k = 0; k < count && settings[k]; k++)
        CHECK_OK(ovr_case_assign(c, settings[k], "test", &err), &err);
}

/* Makes a case of both features: transient, unless one requires a steady
 * solution. */
static ovr_case *combine(const struct contact *contact, const struct way *a,
                         const struct way *b)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_create(NULL, &err);
    assert_non_null(c);
    set(c, base, sizeof base / sizeof *base);
    set(c, contact->set, SETTINGS);
    if (in_time(a) && in_time(b))
        set(c, moving, sizeof moving / sizeof *moving);
    set(c, a->set, SETTINGS);
    if (b != a)
        set(c, b->set, SETTINGS);
    return c;
}

/* ---------------------------------------------------------------- balances */

/* Solution at the end of a run, for bitwise comparison. */
typedef struct ending {
    size_t n;
    long step;
    double T, *P, *H;
} ending;

static ending keep(const ovr_run *run)
{
    const ovr_state *s = ovr_simulation_state(ovr_run_get_info(run)->sim);
    ending e = {.n = s->n, .step = s->step, .T = s->T};
    e.P = malloc(s->n * sizeof *e.P);
    e.H = malloc(s->n * sizeof *e.H);
    assert_true(e.P && e.H);
    memcpy(e.P, s->P, s->n * sizeof *e.P);
    memcpy(e.H, s->H, s->n * sizeof *e.H);
    return e;
}

static void drop(ending *e)
{
    free(e->P);
    free(e->H);
}

static void check_same(const ending *a, const ending *b)
{
    assert_true(a->n == b->n && a->step == b->step && a->T == b->T);
    assert_memory_equal(a->P, b->P, a->n * sizeof *a->P);
    assert_memory_equal(a->H, b->H, a->n * sizeof *a->H);
}

/* Checks the balances of load and mass. Mass-conserving cavitation conserves
 * mass within the algebraic tolerance. Otherwise the error is the
 * discretization error of this coarse grid. (The error of first order on levels
 * 5 to 8 is 0.153, 0.079, 0.040 and 0.020 of the flow of the gear.) */
static void check_balances(const ovr_run *run, double first_order)
{
    const ovr_run_info *info = ovr_run_get_info(run);
    const ovr_observation *o = ovr_simulation_observation(info->sim);
    bool first = info->setup->options->scheme == OVR_UPSTREAM1;
    assert_true(info->converged && o->converged && !o->marked);
    CHECK_NEAR(o->load_error, 0, 1e-6);
    if (info->setup->options->cavitation == OVR_CAVITATION_CONSERVING)
        CHECK_NEAR(o->mass_defect, 0, 1e-7);
    else
        CHECK_NEAR(o->mass_balance, 0, first ? first_order : 0.05);
}

/* ------------------------------------------------------------------ killed */

enum { KILLED_AT = 5 }; /* adaptive runs have 8 steps or more */

static bool is_late(void *calls)
{
    if (++*(int *)calls == KILLED_AT)
        raise(SIGKILL);
    return false;
}

/* Runs a case in a process that is killed before the end. */
static void run_killed(ovr_case *c, const char *path)
{
    pid_t child = fork();
    int how_it_ended = 0;
    if (child == 0) {
        int calls = 0;
        ovr_run_options how = {0};
        how.output = path;
        how.force = true;
        how.data = &calls;
        how.stop = is_late;
        ovr_run *run = ovr_run_create(c, &how, NULL, NULL);
        if (run)
            ovr_run_execute(run, NULL);
        _exit(1);
    }
    assert_true(child > 0 && waitpid(child, &how_it_ended, 0) == child);
    assert_true(WIFSIGNALED(how_it_ended) && WTERMSIG(how_it_ended) == SIGKILL);
}

static void check_resumed(ovr_case *c, const char *path, const ending *whole)
{
    ovr_run_options how = {0};
    ovr_error err = {0};
    run_killed(c, path);
    ovr_run *run = ovr_run_resume(path, &how, NULL, &err);
    if (!run)
        print_message("%s\n", err.message);
    assert_non_null(run);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    ending resumed = keep(run);
    check_same(whole, &resumed);
    drop(&resumed);
    ovr_run_free(run);
}

/* -------------------------------------------------------------------- walk */

/* Returns the feature that a feature requires, or the feature itself. */
static ovr_model_feature required_by(ovr_model_feature part)
{
    if (part == OVR_MODEL_SUPPLY || part == OVR_MODEL_PASSES)
        return OVR_MODEL_CONSERVING;
    if (part == OVR_MODEL_MEAN_FILM || part == OVR_MODEL_WEAR)
        return OVR_MODEL_BOUNDARY;
    return part == OVR_MODEL_FATIGUE ? OVR_MODEL_STRESS : part;
}

static const ovr_conflict *together(ovr_model_feature a, ovr_model_feature b)
{
    return ovr_conflict_among(ovr_model_feature_bit(a, true) |
                              ovr_model_feature_bit(b, true));
}

/* Strips first refuse the feature that this one requires. */
static ovr_model_feature refused_first(const struct way *w)
{
    if (w->part == OVR_MODEL_FATIGUE || w->part == OVR_MODEL_PLASTIC)
        return OVR_MODEL_STRESS;
    return w->part == OVR_MODEL_OTHER_MODULI ? OVR_MODEL_COATING : w->part;
}

/* Returns the reason why two features cannot be combined; NULL: they can. */
static const ovr_conflict *refused(const struct way *a, const struct way *b)
{
    ovr_model_feature parts[4] = {a->part, b->part, OVR_MODEL_TIME,
                                  OVR_MODEL_TIME};
    size_t n = 2;
    if (in_time(a) && in_time(b))
        n = 3;
    if (b->part == OVR_MODEL_STRIP)
        parts[0] = refused_first(a);
    if (a->part == OVR_MODEL_STRIP)
        parts[1] = refused_first(b);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < i; j++)
            if (together(parts[i], parts[j]))
                return together(parts[i], parts[j]);
    const ovr_model_feature under[2] = {required_by(parts[0]),
                                        required_by(parts[1])};
    for (size_t i = 0; i < 2; i++)
        if (together(under[i], parts[1 - i]))
            return together(under[i], parts[1 - i]);
    for (size_t i = 0; i < 2; i++)
        parts[i] = under[i];
    return together(parts[0], parts[1]);
}

/* True if both features are values of the same key. */
static bool exclude_each_other(const struct way *a, const struct way *b)
{
    ovr_model_feature_info one = ovr_model_feature_at((int)a->part),
                           other = ovr_model_feature_at((int)b->part);
    bool same = !strcmp(one.section, other.section);
    if (a->part == OVR_MODEL_WEAR || b->part == OVR_MODEL_WEAR)
        return same; /* wear requires a law */
    return same && !strcmp(one.key, other.key);
}

static void check_refused(ovr_case *c, const ovr_conflict *why)
{
    ovr_error err = {0};
    ovr_setup *setup = ovr_case_resolve(c, NULL, &err);
    assert_null(setup);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "cannot be combined with");
    assert_non_null(strstr(err.message, why->instead));
    assert_string_equal(err.about, ovr_model_feature_at(why->feature).key);
}

static void check_works(ovr_case *c, const char *path, bool marches,
                        double first_order)
{
    ovr_run_options how = {0};
    ovr_error err = {0};
    how.output = path;
    how.force = true;
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    if (!run)
        print_message("%s\n", err.message);
    assert_non_null(run);
    if (!marches) {
        ovr_run_free(run);
        return;
    }
    CHECK_OK(ovr_run_execute(run, &err), &err);
    check_balances(run, first_order);
    bool transient = ovr_run_get_info(run)->transient;
    ending whole = keep(run);
    ovr_run_free(run);
    if (transient)
        check_resumed(c, path, &whole);
    drop(&whole);
}

static void print_pair(const char *one, const char *other, bool refused,
                       bool marches)
{
    print_message("%s, %s%s\n", one, other,
                  refused   ? ": refused"
                  : marches ? ": marches"
                            : "");
}

static const char *name_of(const struct way *w)
{
    return ovr_model_feature_at((int)w->part).name;
}

void test_walk_pairs(const char *folder, int every)
{
    char path[300];
    int pairs = 0, refusals = 0, marched = 0;
    snprintf(path, sizeof path, "%s/pair.h5", folder);
    for (int a = 0; a < WAYS; a++)
        for (int b = 0; b < a; b++) {
            const struct way *one = &ways[a], *other = &ways[b];
            const ovr_conflict *why = refused(one, other);
            if (exclude_each_other(one, other))
                continue;
            bool marches = !why && pairs % every == 0;
            ovr_case *c = combine(&cylinders, one, other);
            print_pair(name_of(one), name_of(other), why, marches);
            if (why)
                check_refused(c, why);
            else
                check_works(c, path, marches, cylinders.first_order);
            ovr_case_free(c);
            pairs++;
            refusals += why != NULL;
            marched += marches;
        }
    print_message("%d pairs, %d refused, %d of the others marched\n", pairs,
                  refusals, marched);
    assert_true(refusals > 0 && marched > 0);
}

/* ---------------------------------------------------------------- elements */

/* Returns the reason why an element cannot be combined with a feature; NULL: it
 * can. */
static const ovr_conflict *refused_by(const struct contact *element,
                                      const struct way *w)
{
    unsigned on = element->determines | 1U << w->part |
                  1U << required_by(w->part);
    if (in_time(w))
        on |= 1U << OVR_MODEL_TIME;
    return ovr_conflict_among(on);
}

/* Returns the section that the element rejects itself, or NULL: an element
 * determines load and motion, and a flat follower does not move along the film.
 */
static const char *own_refusal(const struct contact *element,
                               const struct way *w)
{
    if (w->part == OVR_MODEL_LOAD || w->part == OVR_MODEL_SPEED ||
        w->part == OVR_MODEL_REVERSAL || w->part == OVR_MODEL_SLIDING ||
        w->part == OVR_MODEL_RADIUS)
        return "] already determines the time ";
    if (!strcmp(element->name, "cam") && w->part == OVR_MODEL_STRESS)
        return "surface 2 does not move"; /* ways has stresses in both */
    return NULL;
}

static void check_own_refusal(ovr_case *c, const char *words)
{
    ovr_error err = {0};
    assert_null(ovr_case_resolve(c, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, words);
}

void test_walk_elements(const char *folder, int every)
{
    char path[300];
    int pairs = 0, refusals = 0, marched = 0;
    snprintf(path, sizeof path, "%s/element.h5", folder);
    for (int e = 0; e < ELEMENTS; e++)
        for (int a = 0; a < WAYS; a++) {
            const struct contact *element = &elements[e];
            const struct way *w = &ways[a];
            const ovr_conflict *why = refused_by(element, w);
            const char *own = own_refusal(element, w);
            bool marches = !why && !own && pairs % every == 0;
            ovr_case *c = combine(element, w, w);
            print_pair(element->name, name_of(w), why || own, marches);
            if (own)
                check_own_refusal(c, own);
            else if (why)
                check_refused(c, why);
            else
                check_works(c, path, marches, element->first_order);
            ovr_case_free(c);
            pairs++;
            refusals += why || own;
            marched += marches;
        }
    print_message("%d pairs, %d refused, %d of the others marched\n", pairs,
                  refusals, marched);
    assert_true(refusals > 0 && marched > 0);
}
