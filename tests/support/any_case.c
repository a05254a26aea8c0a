/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "any_case.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "case/parameters.h"
#include "contact/film_formula.h"
#include "run/cost.h"
#include "run/internal.h"
#include "run/run.h"
#include "simulation/simulation.h"
#include "test.h"

enum { MAX_KEYS = 12, CAPACITY = 200, MAX_STEPS = 40, WIDE_STEPS = 2000 };

typedef struct draw {
    uint64_t state;
    char base[2000];
    char key[MAX_KEYS][CAPACITY], value[MAX_KEYS][CAPACITY];
    int keys, most; /* number of keys; maximum number of steps or cycles */
    double width, height; /* width of a strip; height of the highest feature
                             relative to the film thickness */
} draw;

static double between(draw *d, double low, double high)
{
    return low * pow(high / low, test_random(&d->state, 0, 1));
}

static bool chance(draw *d, double share)
{
    return test_random(&d->state, 0, 1) < share;
}

static void contact(draw *d)
{
    double wide = chance(d, 0.2) ? 30 : 1; /* factor on the ranges */
    if (chance(d, 0.4))
        snprintf(d->base, sizeof d->base, "[contact]\nM = %.5g\nL = %.5g\n",
                 between(d, 3 / wide, 200 * wide),
                 between(d, 1 / wide, 14 * sqrt(wide)));
    else
        snprintf(d->base, sizeof d->base,
                 "[contact]\nload = %.5g N/m\nradius = %.5g mm\n"
                 "modulus = %.5g GPa\nmean_speed = %.5g m/s\n"
                 "viscosity = %.5g Pa.s\nalpha = %.5g 1/GPa\n",
                 between(d, 3e4 / wide, 1e6 * wide), between(d, 5, 50),
                 between(d, 150 / wide, 300), between(d, 0.2 / wide, 10 * wide),
                 between(d, 0.005 / wide, 0.2 * wide), between(d, 10, 25));
    strcat(d->base, "slide_to_roll = 0.3\n[domain]\nlevel = 5\n");
    if (chance(d, 0.6))
        strcat(d->base, "[time]\nend = 0.5\n");
    if (chance(d, 0.5))
        strcat(d->base, "[feature f]\nshape = dent\ndepth = 0.01\n"
                        "width = 0.6\nstart = -2\n");
    if (chance(d, 0.3))
        strcat(d->base, "[cavitation]\nmodel = conserving\n");
    if (chance(d, 0.2))
        strcat(d->base, "[stress]\n");
}

/* ------------------------------------------------------------ wide contacts */

static void add(draw *d, const char *format, ...)
{
    size_t used = strlen(d->base);
    va_list list;
    va_start(list, format);
    vsnprintf(d->base + used, sizeof d->base - used, format, list);
    va_end(list);
}

static int whole(draw *d, int from, int to)
{
    return from + (int)test_random(&d->state, 0, to - from + 1);
}

/* Returns the central film thickness of the smooth contact by the film
 * thickness formula, b^2/R; NAN: the case is rejected. */
static double film_of(const draw *d)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(d->base, "case", NULL, NULL, &err);
    ovr_setup *s = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    double H = s ? ovr_film_central_moes(s->contact->M, s->contact->L) : NAN;
    ovr_setup_free(s);
    ovr_case_free(c);
    return H;
}

/* Draws bodies of rubber to ceramics whose p_h is 3e-4 to 0.02 of the modulus,
 * or numbers M and L. */
static void wide_conditions(draw *d)
{
    bool soft = chance(d, 0.4);
    double modulus = soft ? between(d, 1e6, 5e9) : between(d, 5e10, 4e11);
    if (chance(d, 0.4))
        add(d, "[contact]\nM = %.5g\nL = %.5g\n", between(d, 0.5, 2000),
            between(d, 0.3, 30));
    else
        add(d,
            "[contact]\nhertz_pressure = %.5g Pa\nradius = %.5g mm\n"
            "modulus = %.5g Pa\nmean_speed = %.5g m/s\n"
            "viscosity = %.5g Pa.s\nalpha = %.5g 1/GPa\n",
            modulus * between(d, 3e-4, 0.02), between(d, 1, 100), modulus,
            between(d, 0.01, 30), between(d, 0.001, 1), between(d, 5, 30));
    double slide = chance(d, 0.3) ? 0 : between(d, 0.01, 30);
    add(d, "slide_to_roll = %.4g\n", chance(d, 0.5) ? slide : -slide);
    if (chance(d, 0.3))
        add(d, "[lubricant]\nrheology = eyring\neyring_number = %.4g\n",
            between(d, 0.1, 50));
    add(d, "[domain]\nlevel = %d\n", whole(d, 4, 6));
    if (chance(d, 0.75))
        add(d, "[time]\nend = %.3g\n", test_random(&d->state, 0.1, 0.4));
}

/* Draws the position and width of a feature across a strip of width W. */
static void across(draw *d, double W)
{
    static const char *const extents[] = {"round", "endless", "0.3", "2"};
    add(d, "across = %.4g\nwidth_across = %s\n",
        test_random(&d->state, -W / 2, W / 2), extents[whole(d, 0, 3)]);
}

/* Draws a feature of a height on a strip of width W, or a line (W = 0). */
static void wide_feature(draw *d, int number, double height, double W)
{
    int shape = whole(d, 0, W > 0 ? 7 : 3);
    double angle = asin(whole(d, 1, 3) * 0.25);
    add(d, "[feature w%d]\nsurface = %d\n", number, whole(d, 1, 2));
    switch (shape) {
    case 0:
    case 1:
        add(d, "shape = %s\n%s = %.4g\nwidth = %.4g\nstart = %.4g\n",
            shape ? "bump" : "dent", shape ? "height" : "depth", height,
            between(d, 0.2, 2), test_random(&d->state, -3, 1));
        if (W > 0)
            across(d, W);
        break;
    case 2:
    case 3:
        add(d,
            "shape = roughness\nRq = %.4g\nlength = 12\nshortest = %.3g\n"
            "start = %.3g\n",
            height, between(d, 0.1, 1), test_random(&d->state, -6, 6));
        if (W > 0)
            add(d, "peklenik = %.3g\nangle = %.3g deg\n", between(d, 0.1, 10),
                test_random(&d->state, -90, 90));
        break;
    case 4:
        add(d,
            "shape = wave\namplitude = %.4g\nwavelength = %.15g\n"
            "angle = %.15g rad\n",
            height, W * sin(angle) / whole(d, 1, 4), angle);
        break;
    case 5:
        add(d,
            "shape = groove\ndepth = %.4g\nwidth = %.3g\nflank = 0.1\n"
            "length_across = %.3g\nangle = %.3g deg\nstart = %.3g\n",
            height, between(d, 0.1, 0.6), between(d, 0.3, W),
            test_random(&d->state, -80, 80), test_random(&d->state, -2, 1));
        break;
    case 6:
        add(d,
            "shape = texture\ndepth = %.4g\nwidth = 0.3\nwavelength = 0.7\n"
            "wavelength_across = %.15g\nstagger = %.2g\n",
            height, W / whole(d, 1, 3), test_random(&d->state, 0, 1));
        break;
    default:
        add(d,
            "shape = areal\nfile = any_map.csv\nunit_z = b^2/R\n"
            "spacing = %.15g\nscale = %.4g\nstart = %.3g\n"
            "extend = periodic\n",
            W / (0.95 * 39), height, test_random(&d->state, -6, 6));
    }
}

static void wide_contact(draw *d)
{
    wide_conditions(d);
    double H = film_of(d);
    if (chance(d, 0.5))
        add(d, "[strip]\nwidth = %.15g\n", d->width = between(d, 1, 3));
    if (!isfinite(H))
        H = 0.1;
    for (int k = chance(d, 0.85) ? whole(d, 1, 2) : 0; k > 0; k--) {
        double share = between(d, 0.01, 10);
        d->height = fmax(d->height, share);
        wide_feature(d, k, H * share, d->width);
    }
}

/* --------------------------------------------------------------------- keys */

/* True for keys that the survey sets because they determine the computing time.
 */
static bool is_left_out(const ovr_parameter *p, const char *section)
{
    static const char *const keys[] = {"level", "nodes", "end", "refine_level",
                                       "interval"};
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
        if (!strcmp(p->key, keys[k]))
            return true;
    return !strcmp(section, "output") && p->kind == OVR_PATH;
}

/* A table of two columns, a profile, and a file that does not exist. */
static const char *const files[] = {"any_table.csv", "any_profile.csv",
                                    "any_nothing.csv"};

static void write_files(void)
{
    for (int k = 0; k < 2; k++) {
        FILE *out = fopen(files[k], "w");
        assert_non_null(out);
        fprintf(out, k ? "x [um];z [um]\n" : "");
        for (int i = 0; i < 200; i++)
            fprintf(out, k ? "%g;%g\n" : "%g, %g\n", k ? 2. * i : 0.05 * i,
                    k ? 0.1 * sin(0.3 * i) : 1 + 0.3 * sin(0.1 * i));
        fclose(out);
    }
    FILE *map = fopen("any_map.csv", "w");
    assert_non_null(map);
    for (int j = 0; j < 40; j++)
        for (int i = 0; i < 120; i++)
            fprintf(map, "%g%c",
                    sin(0.4 * i) * cos(0.3 * j) + 0.5 * sin(1.1 * i + 0.8 * j),
                    i < 119 ? ';' : '\n');
    fclose(map);
}

/* Draws a usual number or, sometimes, any number in the range of the key. */
static double number_of(draw *d, const ovr_parameter *p)
{
    bool bare = p->dimension == OVR_PURE || p->hertzian != OVR_NOT_HERTZIAN;
    double low = fmax(p->minimum, p->minimum < 0 ? -3 : 1e-3);
    double high = fmin(p->maximum, 3);
    if (!strcmp(p->key, "tolerance") || !strcmp(p->key, "accuracy"))
        return between(d, fmax(p->minimum, 1e-10), fmin(p->maximum, 0.1));
    if (chance(d, 0.2))
        return chance(d, 0.5) ? p->minimum : fmin(p->maximum, 1e6);
    if (!bare) /* numbers in SI units have no usual range */
        return between(d, fmax(p->minimum, 1e-12), fmin(p->maximum, 1e12));
    return test_random(&d->state, low, fmax(low, high));
}

static void put_number(draw *d, const ovr_parameter *p, char *text)
{
    bool bare = p->dimension == OVR_PURE || p->hertzian != OVR_NOT_HERTZIAN;
    double value = number_of(d, p);
    if (p->kind == OVR_INTEGER)
        value = floor(fmin(value + test_random(&d->state, 0, 9), 50));
    snprintf(text, CAPACITY, "%.6g%s%s", value, bare ? "" : " ",
             bare ? "" : ovr_unit_si(p->dimension));
}

static void put_numbers(draw *d, const ovr_parameter *p, char *text)
{
    int count = (int)test_random(&d->state, 1, 5);
    text[0] = 0;
    for (int k = 0; k < count; k++) {
        char one[CAPACITY / 5];
        put_number(d, p, one);
        strcat(strcat(text, k ? ", " : ""), one);
    }
}

static void value_of(draw *d, const ovr_parameter *p, char *text)
{
    int words = 0;
    while (p->words && p->words[words].name)
        words++;
    if (words &&
        (p->kind == OVR_CHOICE || p->kind == OVR_WORDS || chance(d, 0.3)))
        snprintf(text, CAPACITY, "%s",
                 p->words[(int)test_random(&d->state, 0, words)].name);
    else if (p->kind == OVR_FLAG)
        snprintf(text, CAPACITY, "%s", chance(d, 0.5) ? "yes" : "no");
    else if (p->kind == OVR_TEXT)
        snprintf(text, CAPACITY, "a survey, 1 um");
    else if (p->kind == OVR_PATH)
        snprintf(text, CAPACITY, "%s",
                 files[(int)test_random(&d->state, 0, 3)]);
    else if (p->kind == OVR_NUMBERS)
        put_numbers(d, p, text);
    else
        put_number(d, p, text);
}

static ovr_case *make(const draw *d, ovr_error *err)
{
    ovr_case *c = ovr_case_read_text(d->base, "case", NULL, NULL, err);
    for (int k = 0; c && k < d->keys; k++)
        if (ovr_case_set(c, d->key[k], d->value[k], "survey", err)) {
            ovr_case_free(c);
            return NULL;
        }
    return c;
}

/* Adds a random key, unless the case with this key is rejected. */
static void add_key(draw *d)
{
    const ovr_section *section;
    size_t k = (size_t)test_random(&d->state, 0, (double)ovr_parameter_count());
    const ovr_parameter *p = ovr_parameter_row(k, &section);
    ovr_error err = {0};
    if (is_left_out(p, section->name))
        return;
    value_of(d, p, d->value[d->keys]);
    snprintf(d->key[d->keys], CAPACITY, section->named ? "%s %s.%s" : "%s%s.%s",
             section->name, section->named ? "f" : "", p->key);
    d->keys++;
    ovr_case *c = make(d, &err);
    ovr_setup *s = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    if (!s || ovr_setup_prepare(s, NULL, &err))
        d->keys--;
    ovr_setup_free(s);
    ovr_case_free(c);
}

static void show(const draw *d)
{
    print_message("%s", d->base);
    for (int k = 0; k < d->keys; k++)
        print_message("--set %s=%s\n", d->key[k], d->value[k]);
}

typedef struct watch {
    int steps, most, words, infinite;
} watch;

static bool stop(void *data)
{
    watch *w = data;
    return ++w->steps > w->most;
}

static bool has_word(const char *text)
{
    static const char *const words[] = {" nan", " -nan", " inf ", " -inf"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strstr(text, words[k]))
            return true;
    return false;
}

static void listen(void *data, ovr_message_kind kind, const char *text)
{
    (void)kind;
    if (!has_word(text))
        return;
    ((watch *)data)->words++;
    print_message("    message: %s\n", text);
}

static void check_summary(void *data, const ovr_summary_line *line)
{
    if (line->form != OVR_SUMMARY_NUMBER || !isinf(line->number))
        return;
    ((watch *)data)->infinite++;
    print_message("    %s is infinite\n", line->key);
}

static int line_at_fault(const ovr_state *s, double Y)
{
    for (size_t i = 0; i < s->n; i++)
        if (!isfinite(s->P[i]) || !isfinite(s->H[i]) || s->P[i] < 0) {
            print_message("    P, H = %g, %g at X, Y = %g, %g\n", s->P[i],
                          s->H[i], s->X[i], Y);
            return 1;
        }
    return 0;
}

/* Returns 1 if a field of the contact, or of any line of a strip, is wrong. */
static int fields_at_fault(ovr_simulation *sim)
{
    size_t lines = 1, shown;
    const double *Y = ovr_simulation_lines(sim, &lines, &shown);
    if (!Y)
        return line_at_fault(ovr_simulation_state(sim), 0);
    int wrong = 0;
    for (size_t j = 0; j < lines && !wrong; j++) {
        ovr_simulation_show(sim, j);
        wrong = line_at_fault(ovr_simulation_state(sim), Y[j]);
    }
    ovr_simulation_show(sim, shown);
    return wrong;
}

static int closes(const ovr_run *run)
{
    const ovr_simulation *sim = ovr_run_get_info(run)->sim;
    const ovr_observation *o = ovr_simulation_observation(sim);
    const ovr_statistics *all = ovr_simulation_statistics(sim);
    double load = fabs(all->extreme.load_error) / fmax(1, o->load_ratio);
    bool oil = !isfinite(o->mass_defect) || fabs(o->mass_defect) < 1e-2;
    if (!ovr_run_get_info(run)->converged || (load < 1e-4 && oil))
        return 0;
    print_message("    load error %.2g, mass conservation error %.2g\n", load,
                  o->mass_defect);
    return 1;
}

/* Memory limit of a case, 1 GB. Extreme cases request stresses at 1e9 points,
 * which malloc may grant although the machine has less memory. */
typedef struct budget {
    size_t left;
} budget;

static void *allocate(void *context, size_t bytes)
{
    budget *b = context;
    size_t *memory = bytes + 16 <= b->left ? malloc(bytes + 16) : NULL;
    if (!memory)
        return NULL;
    b->left -= bytes + 16;
    *memory = bytes + 16;
    return (char *)memory + 16;
}

static void release(void *context, void *memory)
{
    if (!memory)
        return;
    size_t *begin = (size_t *)(void *)((char *)memory - 16);
    ((budget *)context)->left += *begin;
    free(begin);
}

/* Returns H_cen on a level, the order of the solution and, if `error` is not
 * NULL, the estimated error. */
static double film_on(const draw *d, const char *level, int *order,
                      double *error)
{
    watch w = {.most = d->most};
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_case *c = make(d, &err);
    double film = NAN;
    how.data = &w;
    how.stop = stop;
    how.estimate_error = error != NULL;
    *order = 0;
    if (c && ovr_case_set(c, "domain.level", level, "survey", &err)) {
        ovr_case_free(c);
        c = NULL;
    }
    budget capacity = {(size_t)1 << 30};
    const ovr_allocator within = {allocate, release, &capacity};
    ovr_run *run = c ? ovr_run_create(c, &how, &within, &err) : NULL;
    if (run && !ovr_run_execute(run, &err)) {
        const ovr_run_info *about = ovr_run_get_info(run);
        film = ovr_simulation_observation(about->sim)->H_cen;
        *order = ovr_simulation_order(about->sim);
        for (size_t k = 0; error && about->error && k < about->error->count;
             k++)
            if (!strcmp(about->error->of[k].key, "H_cen"))
                *error = about->error->of[k].error;
    }
    ovr_run_free(run);
    ovr_case_free(c);
    return film;
}

/* True if the film thicknesses of levels 7 and 8 differ by more than the
 * estimate of level 7, for solutions of the same order (otherwise a warning is
 * printed). */
static bool misleads(const draw *d, int *compared)
{
    const double cycles = 1e-5; /* algebraic error */
    int order, order_finer;
    double error = NAN, film = film_on(d, "7", &order, &error), finer;
    if (!isfinite(film) || !isfinite(error))
        return false;
    finer = film_on(d, "8", &order_finer, NULL);
    if (order != order_finer)
        return false;
    ++*compared;
    if (!(fabs(finer - film) > fmax(fabs(error), cycles * film)))
        return false;
    print_message("    H_cen %g and %g on levels 7 and 8, estimate %.2g\n",
                  film, finer, error);
    return true;
}

/* Returns the CPU time of a finished run relative to the estimate of `check`;
 * NAN: both are shorter than the start of the program. */
static double cost_of(const draw *d, double seconds)
{
    const double start = 0.1;
    ovr_error err = {0};
    ovr_case *c = make(d, &err);
    ovr_setup *s = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    double estimate = NAN;
    if (s && !ovr_setup_prepare(s, NULL, &err))
        estimate = ovr_setup_cost(s, 0, 0).seconds;
    ovr_setup_free(s);
    ovr_case_free(c);
    return fmax(estimate, seconds) > start ? seconds / estimate : NAN;
}

typedef struct ending {
    bool solved, failed;
    double cost; /* NAN: not compared */
} ending;

/* Runs a case and returns the number of its faults. */
static int try(const draw *d, ending *e)
{
    watch w = {.most = d->most};
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_case *c = make(d, &err);
    how.data = &w;
    how.stop = stop;
    how.say = listen;
    budget capacity = {(size_t)1 << 30};
    const ovr_allocator within = {allocate, release, &capacity};
    clock_t begun = clock();
    ovr_run *run = c ? ovr_run_create(c, &how, &within, &err) : NULL;
    int wrong = 0;
    *e = (ending){.failed = !run, .cost = NAN};
    if (run) {
        ovr_status status = ovr_run_execute(run, &err);
        double seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
        e->solved = !status || status == OVR_STOPPED;
        e->failed = !e->solved;
        if (!status)
            e->cost = cost_of(d, seconds);
        if (e->solved) {
            ovr_run_summary(ovr_run_get_info(run), check_summary, &w);
            wrong += fields_at_fault(run->sim) + closes(run);
        }
    }
    if (has_word(err.message) || (e->failed && !*err.message)) {
        print_message("    failed: %s\n", err.message);
        wrong++;
    }
    if (getenv("OVERROLL_RUNS"))
        print_message("    %s, heights %.2g: %s%s, cost %.2g of the estimate\n",
                      d->width > 0 ? "strip" : "line", d->height,
                      e->failed ? "failed: " : "solved",
                      e->failed ? err.message : "", e->cost);
    ovr_run_free(run);
    ovr_case_free(c);
    return wrong + w.words + w.infinite;
}

static void print_seed(const draw *d, uint64_t seed, int k, bool wrong)
{
    if (wrong || getenv("OVERROLL_RUNS"))
        print_message("  seed %llu\n", (unsigned long long)seed + (unsigned)k);
    if (wrong)
        show(d);
}

void test_any_case_survey(uint64_t seed, int runs)
{
    int wrong = 0, solved = 0, compared = 0, misled = 0;
    write_files();
    for (int k = 0; k < runs; k++) {
        static draw d;
        ending e;
        d = (draw){.state = seed + (uint64_t)k, .most = MAX_STEPS};
        contact(&d);
        for (int tries = 0; tries < 40 && d.keys < MAX_KEYS; tries++)
            add_key(&d);
        bool fails = try(&d, &e), steady = !strstr(d.base, "[time]");
        bool misled_by = !fails && steady && misleads(&d, &compared);
        misled += misled_by;
        wrong += fails;
        solved += e.solved;
        print_seed(&d, seed, k, fails || misled_by);
    }
    print_message("    %d cases, %d solved, %d with faults; in %d of %d steady "
                  "ones the estimate is below the difference of levels 7 and "
                  "8\n",
                  runs, solved, wrong, misled, compared);
    assert_int_equal(wrong, 0);
    /* One is allowed in any case; 30 of 100 cases are compared. */
    assert_true(100 * (misled - 1) <= 3 * compared);
}

/* Writes the case with its added keys to SEED.ini. */
static void write_case(const draw *d, const char *folder, uint64_t seed)
{
    ovr_error err = {0};
    ovr_case *c = make(d, &err);
    char path[CAPACITY];
    snprintf(path, sizeof path, "%s/%llu.ini", folder,
             (unsigned long long)seed);
    test_write_text(path, c ? ovr_case_text(c, &err) : d->base);
    ovr_case_free(c);
}

void test_wide_case_survey(uint64_t seed, int runs)
{
    const char *folder = getenv("OVERROLL_CASES");
    int wrong = 0, solved = 0, compared = 0, dear = 0, cheap = 0;
    write_files();
    for (int k = 0; k < runs; k++) {
        static draw d;
        ending e;
        d = (draw){.state = seed + (uint64_t)k, .most = WIDE_STEPS};
        wide_contact(&d);
        for (int tries = 0; tries < 12 && d.keys < MAX_KEYS / 2; tries++)
            add_key(&d);
        if (folder) {
            write_case(&d, folder, seed + (uint64_t)k);
            continue;
        }
        if (runs == 1)
            show(&d);
        bool fails = try(&d, &e);
        wrong += fails;
        solved += e.solved;
        compared += !isnan(e.cost);
        dear += e.cost > 10;
        cheap += e.cost < 0.1;
        print_seed(&d, seed, k, fails || e.cost > 10);
    }
    print_message("    %d cases, %d solved, %d with faults; of %d that were "
                  "timed %d took more than ten times the estimate, %d less "
                  "than a tenth\n",
                  runs, solved, wrong, compared, dear, cheap);
    assert_int_equal(wrong, 0);
    /* Times are checked in large surveys only. */
    assert_true(runs < 200 || 20 * dear <= compared);
}
