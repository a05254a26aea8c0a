/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/coated.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/case.h"
#include "overroll/simulation.h"
#include "support/test.h"

static double spread(uint64_t *seed, double minimum, double maximum)
{
    return minimum * pow(maximum / minimum, test_random(seed, 0, 1));
}

static size_t put_layer(uint64_t *seed, const char *name, char *text,
                        size_t capacity)
{
    double t = spread(seed, 0.003, 1), E = spread(seed, 0.01, 5);
    return (size_t)snprintf(text, capacity,
                            "[coating %s]\nthickness = %.6g\nmodulus = %.6g "
                            "GPa\npoisson = %.3f\n",
                            name, t, 200 * E, test_random(seed, 0.1, 0.49));
}

/* Draws layers of 0.01 to 5 times the modulus of the bodies, 0.003 to 1 b
 * thick. In one of three cases there are two layers, and in one of three cases
 * both bodies have a layer. */
static void put_layers(uint64_t *seed, char *text, size_t capacity)
{
    size_t used = put_layer(seed, "1", text, capacity);
    if (test_random(seed, 0, 3) < 1)
        used += put_layer(seed, "1b", text + used, capacity - used);
    if (test_random(seed, 0, 3) < 1)
        put_layer(seed, "2", text + used, capacity - used);
}

/* Writes a contact of p_h = 0.1 GPa, whose strains are small with any layer. */
static void put_contact(double M, double L, double slide, int order, char *text,
                        size_t capacity)
{
    snprintf(text, capacity,
             "[contact]\nM = %.6g\nL = %.6g\nhertz_pressure = 0.1 GPa\n"
             "slide_to_roll = %g\n[domain]\nlevel = 7\norder = %d\n"
             "[body 1]\nmodulus = 200 GPa\n[body 2]\nmodulus = 200 GPa\n",
             M, L, slide, order);
}

typedef struct solved {
    ovr_case *c;
    ovr_setup *setup;
    ovr_simulation *sim;
} solved;

static solved make(const char *text)
{
    ovr_error err = {0};
    solved s = {.c = ovr_case_read_text(text, "case", NULL, NULL, &err)};
    if (s.c)
        s.setup = ovr_case_resolve(s.c, NULL, &err);
    if (s.setup)
        s.sim = ovr_setup_simulation(s.setup, NULL, &err);
    if (!s.sim || ovr_simulation_steady(s.sim, &err)) {
        print_message("%s\n%s\n", err.message, text);
        fail();
    }
    return s;
}

static void release(solved *s)
{
    ovr_simulation_free(s->sim);
    ovr_setup_free(s->setup);
    ovr_case_free(s->c);
}

/* All contacts are solved in at most 150 cycles. At most one in a hundred, with
 * a layer as thin as one mesh size, needs more than 120, a second strategy. */
void test_coated_steady(int contacts)
{
    uint64_t seed = 20;
    int many = 0, maximum = 0;
    for (int k = 0; k < contacts; k++) {
        char text[1200];
        double M = spread(&seed, 5, 200), L = test_random(&seed, 0, 12);
        put_contact(M, L, 0, 4, text, sizeof text);
        put_layers(&seed, text + strlen(text), sizeof text - strlen(text));
        solved s = make(text);
        int cycles = ovr_simulation_observation(s.sim)->cycles;
        maximum = cycles > maximum ? cycles : maximum;
        many += cycles >= 120;
        release(&s);
    }
    print_message("%d contacts, at most %d cycles, %d above 120\n", contacts,
                  maximum, many);
    assert_true(many <= contacts / 100 && maximum < 150);
}

/* Returns the number of cycles per step of a dent that passes the contact. */
static double march(const char *text, int *marked)
{
    ovr_error err = {0};
    solved s = make(text);
    CHECK_OK(ovr_simulation_march(s.sim, s.setup->march, &err), &err);
    const ovr_statistics *all = ovr_simulation_statistics(s.sim);
    double rate = (double)all->cycles / (double)all->steps;
    *marked = (int)all->marked;
    release(&s);
    return rate;
}

/* Rolling and sliding dents: no more flagged steps than without layers, and at
 * most 10 % more cycles. At second order this holds for each dent. At fourth
 * order two of sixty need more: one in its steady start, one in steps that fail
 * at a spike of one mesh size. Steps of two mesh sizes that fail are halved,
 * which at most doubles the cycles of a step. Therefore each may need twice as
 * many.
 */
void test_coated_dents(int dents, int order)
{
    static const double slides[] = {0, 0, 0.5, -1};
    const double limit = order == 2 ? 1.1 : 2;
    uint64_t seed = 7;
    double all = 0;
    int off = 0;
    for (int k = 0; k < dents; k++) {
        char text[1500], dent[300];
        int marked = 0, bare_marked = 0;
        put_contact(spread(&seed, 10, 100), test_random(&seed, 2, 10),
                    slides[k % 4], order, text, sizeof text);
        snprintf(dent, sizeof dent,
                 "[time]\nend = auto\n[feature dent]\nshape = dent\ndepth = "
                 "%.3f\nwidth = %.3f\n",
                 test_random(&seed, 0.02, 0.15), test_random(&seed, 0.3, 0.8));
        strcat(text, dent);
        double bare = march(text, &bare_marked);
        put_layers(&seed, text + strlen(text), sizeof text - strlen(text));
        double coated = march(text, &marked);
        off += coated > 1.1 * bare;
        all += coated / bare / dents;
        if (marked > bare_marked || coated > limit * bare) {
            print_message("%d marked, %.3f of the cycles\n%s\n", marked,
                          coated / bare, text);
            fail();
        }
    }
    print_message("%d dents of order %d, %.3f of the cycles, %d above by a "
                  "tenth\n",
                  dents, order, all, off);
    assert_true(off <= dents / 20 && all < 1.1);
}
