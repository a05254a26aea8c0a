/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of plastic deformation in a pass: a dent of 1.5 um with rims of 0.25 um
 * in a contact of 1.16 GPa, level 8, steps of D, in alternation with the same
 * run with elastic stresses. CPU time of the solver's thread. Goals: 1.3 times
 * with the hardening of bearing steel, 1.8 times with steel of Y = 0.75 p_h. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "bench.h"
#include "overroll/run.h"
#include "support/test.h"

enum { KINDS = 3, ROUNDS = 3 };

static const struct kind {
    const char *name, *section;
} kinds[KINDS] = {{"elastic", ""},
                  {"swift", "[plastic]\nhardening = swift\n"},
                  {"soft", "[plastic]\nhardening = linear\nyield = 0.75\n"
                           "modulus = 4.5 GPa\niterations = 8\n"}};

static const char contact[] =
    "[contact]\nload = 300 kN/m\nradius = 8 mm\nspeed_1 = 3 m/s\n"
    "speed_2 = 3 m/s\n"
    "[body 1]\nmodulus = 206 GPa\n[body 2]\nmodulus = 206 GPa\n"
    "[lubricant]\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\np0 = 198 MPa\n"
    "z = 0.68\n"
    "[domain]\nlevel = 8\norder = 2\n[time]\nend = 12\nstep = grid\n"
    "[output]\nevery = 100\n"
    "[feature dent]\nshape = indent\ndepth = 1.5 um\nshoulder = 0.25 um\n"
    "width = 0.6\nstart = -9\n"
    "[stress]\nsurface = 1\n[fatigue]\nlimit_pressure = none\n";

static void roll(void *data)
{
    const struct kind *kind = data;
    char text[1200];
    ovr_error err;
    snprintf(text, sizeof text, "%s%s", contact, kind->section);
    ovr_case *c = ovr_case_read_text(text, kind->name, NULL, NULL, &err);
    /* Stress histories require a result file. */
    const ovr_run_options how = {.output = "plastic_bench.h5"};
    ovr_run *run = ovr_run_create(c, &how, NULL, &err);
    assert_non_null(run);
    CHECK_OK(ovr_run_execute(run, &err), &err);
    ovr_run_free(run);
    ovr_case_free(c);
    unlink("plastic_bench.h5");
    unlink("plastic_bench.h5.restart");
}

int main(int argc, char *argv[])
{
    bench_work work[KINDS];
    for (int k = 0; k < KINDS; k++)
        work[k] = (bench_work){roll, (void *)(uintptr_t)&kinds[k], 0};
    bench_open(argc, argv);
    char folder[] = "/tmp/plastic_bench.XXXXXX";
    if (!mkdtemp(folder) || chdir(folder))
        return 1;
    bench_list("plastic");
    puts("body          a pass   relative to the elastic one");
    bench_measure(KINDS, work, 0, ROUNDS);
    for (int k = 0; k < KINDS; k++) {
        double of = work[k].seconds / work[0].seconds;
        printf("%-9s %7.2f s %7.2f\n", kinds[k].name, work[k].seconds, of);
        bench_row();
        bench_text("body", kinds[k].name);
        bench_number("pass_s", work[k].seconds);
        bench_number("of_elastic", of);
        bench_end();
    }
    bench_end();
    bench_close();
    return rmdir(folder) != 0;
}
