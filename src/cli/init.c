/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll init [KIND]: a commented case to start from. */
#include <stdio.h>
#include <string.h>

#include "cli/output.h"

/*
 * Oils.  Viscosities of the ISO VG grades are those of ISO 3448 at 40 C, the
 * middle of the grade, times a density of 0.86 g/cm3; alpha follows by
 * Roelands' relation alpha = z (ln eta0 + 9.67)/p0 with z = 0.68 and
 * p0 = 198 MPa, typical of paraffinic mineral oils.  `paper` is the oil of
 * Venner, ten Napel & Bosma 1990, with a viscosity of its class.
 */
static const struct oil {
    const char *name, *what, *viscosity, *alpha;
} oils[] = {
    {"paper", "as in Venner, ten Napel & Bosma 1990", "40 mPa.s", "17 1/GPa"},
    {"vg32", "mineral oil ISO VG 32 at 40 C", "27.5 mPa.s", "20.9 1/GPa"},
    {"vg68", "mineral oil ISO VG 68 at 40 C", "58.5 mPa.s", "23.5 1/GPa"},
    {"vg100", "mineral oil ISO VG 100 at 40 C", "86 mPa.s", "24.8 1/GPa"},
    {"vg220", "mineral oil ISO VG 220 at 40 C", "189 mPa.s", "27.5 1/GPa"},
};
enum { OILS = sizeof oils / sizeof oils[0] };

/* ------------------------------------------------------------------ cases */

static const char roller[] =
    "# Roller bearing: a small dent with shoulders on the ring rolls through.\n"
    "# overroll check THIS.ini says what it means; overroll run THIS.ini.\n"
    "\n"
    "[contact]\n"
    "load = 300 kN/m              # per unit length of the roller\n"
    "radius = 8 mm                # reduced: 1/R = 1/R1 + 1/R2\n"
    "modulus = 226 GPa            # reduced E' of steel on steel\n"
    "speed_1 = 3.0 m/s            # the dented surface\n"
    "speed_2 = 3.0 m/s\n";

static const char roller_end[] =
    "\n"
    "[domain]\n"
    "level = 8                    # 7 2^8 + 1 = 1793 nodes\n"
    "\n"
    "[time]\n"
    "end = 13                     # in b/um; or with a unit: 0.5 ms\n"
    "\n"
    "[feature dent]\n"
    "surface = 1\n"
    "shape = indent\n"
    "depth = 0.4 um               # a bare number would be in b^2/R\n"
    "width = 0.6                  # in b\n"
    "shoulder = 0.05 um\n"
    "start = -9                   # left of the inlet, as check tells it\n"
    "\n"
    "[output]\n"
    "file = roller.h5             # beside this case\n"
    "every = 8                    # steps\n";

static const char gear[] =
    "# Gear tooth: load comes on while a ground flank slides through.\n"
    "\n"
    "[contact]\n"
    "load = 250 N/mm              # along the face\n"
    "radius = 12 mm\n"
    "modulus = 226 GPa\n"
    "mean_speed = 6 m/s\n"
    "slide_to_roll = 0.3          # (u1 - u2)/um\n";

static const char gear_end[] =
    "\n"
    "[domain]\n"
    "level = 8\n"
    "\n"
    "[time]\n"
    "end = 17\n"
    "scheme = characteristic      # carries short waves best\n"
    "\n"
    "[load]                       # relative to the load above\n"
    "history = ramp\n"
    "from = 0.5\n"
    "to = 1\n"
    "duration = 3\n"
    "\n"
    "[feature grinding]\n"
    "surface = 1\n"
    "shape = roughness\n"
    "Rq = 0.03 um\n"
    "length = 4                   # in b\n"
    "shortest = 0.25\n"
    "seed = 1                     # another seed, another surface\n"
    "start = -12                  # its leading end, left of the inlet\n"
    "\n"
    "[output]\n"
    "file = gear.h5\n"
    "every = 8\n";

static const char cam[] =
    "# Cam and tappet: the mean speed swings and reverses, a scratch stands on "
    "the\n"
    "# tappet.\n"
    "\n"
    "[contact]\n"
    "load = 80 N/mm\n"
    "radius = 20 mm\n"
    "modulus = 226 GPa\n"
    "mean_speed = 2 m/s           # nominal; see [speed]\n"
    "slide_to_roll = 2            # surface 1 moves, surface 2 stands still\n";

static const char cam_end[] =
    "\n"
    "[domain]\n"
    "level = 8\n"
    "\n"
    "[time]\n"
    "end = 12\n"
    "\n"
    "[speed]                      # relative to mean_speed\n"
    "history = sine\n"
    "mean = 0.5\n"
    "amplitude = 1                # below zero it runs towards -x\n"
    "period = 6\n"
    "\n"
    "[feature scratch]\n"
    "surface = 2\n"
    "shape = groove\n"
    "depth = 0.05 um\n"
    "width = 0.5\n"
    "start = 0\n"
    "grow = 1                     # grows in place from the smooth start\n"
    "\n"
    "[output]\n"
    "file = cam.h5\n"
    "every = 8\n";

static const char numbers[] =
    "# A contact given by Moes' numbers: everything is dimensionless.\n"
    "\n"
    "[contact]\n"
    "M = 20\n"
    "L = 10\n";

static const char numbers_end[] =
    "\n"
    "[domain]\n"
    "level = 8\n"
    "\n"
    "[time]                       # leave this section out for steady cases\n"
    "end = 7\n"
    "\n"
    "[feature wave]\n"
    "surface = 1\n"
    "shape = wave\n"
    "amplitude = 0.01\n"
    "wavelength = 0.5\n"
    "grow = 1\n"
    "\n"
    "[output]\n"
    "file = numbers.h5\n"
    "every = 8\n";

static const char discs[] =
    "# Twin-disc machine: two discs by radius, material and turning speed, "
    "the\n"
    "# oil by its data sheet.\n"
    "\n"
    "[contact]\n"
    "width = 10 mm                # of the track\n"
    "load = 2000 N                # over that width\n"
    "speed_1 = 1000 rpm           # of disc 1, whose surface runs along +x\n"
    "speed_2 = 950 rpm\n"
    "\n"
    "[body 1]\n"
    "material = steel\n"
    "radius = 35 mm               # negative: concave; or flat\n"
    "\n"
    "[body 2]\n"
    "material = steel\n"
    "radius = 35 mm\n"
    "\n"
    "[lubricant]\n"
    "temperature = 60 degC\n"
    "iso_vg = 68\n"
    "viscosity_index = 98\n"
    "density_15 = 880 kg/m3\n"
    "alpha = 20 1/GPa             # at that temperature\n"
    "\n"
    "[domain]\n"
    "level = 8\n";

static const char starved[] =
    "# Starved: a smooth roller passes ten times, a tenth of the oil is lost "
    "in "
    "\n"
    "# between.  Drop [passes] for one pass.\n"
    "\n"
    "[contact]\n"
    "load = 300 kN/m              # per unit length of the roller\n"
    "radius = 8 mm\n"
    "modulus = 226 GPa\n"
    "mean_speed = 3 m/s\n";

static const char starved_end[] =
    "\n"
    "[domain]\n"
    "level = 8\n"
    "\n"
    "[cavitation]\n"
    "model = conserving           # oil in cavities, and no more than arrives\n"
    "\n"
    "[supply]\n"
    "model = film                 # of the first pass; or flooded\n"
    "thickness_1 = 0.2 um         # on each surface, as it arrives\n"
    "thickness_2 = 0.2 um\n"
    "\n"
    "[passes]\n"
    "number = 10\n"
    "loss = 0.1                   # of each layer, between two passes\n"
    "\n"
    "[output]\n"
    "file = starved.h5            # a row each; starved-1.h5, ... the passes\n";

/* A disc machine again, at a slip and a load where oils get hot. */
static const char traction_hot[] =
    "# Two discs of steel that slip: friction, film and temperatures.\n"
    "[contact]\n"
    "load = 300 kN/m\n"
    "mean_speed = 5 m/s\n"
    "slide_to_roll = 0.2\n"
    "\n"
    "[body 1]\n"
    "material = steel             # conducts and stores heat as steel does\n"
    "radius = 35 mm\n"
    "\n"
    "[body 2]\n"
    "material = steel\n"
    "radius = 35 mm\n"
    "\n"
    "[lubricant]\n"
    "temperature = 60 degC        # of the supply, and of the bodies\n"
    "iso_vg = 68\n"
    "viscosity_index = 98         # and so how viscosity falls with "
    "temperature\n"
    "density_15 = 880 kg/m3\n"
    "alpha = 20 1/GPa             # at that temperature\n"
    "rheology = eyring\n"
    "eyring_stress = 5 MPa\n"
    "\n"
    "[heat]\n"
    "model = lobatto\n"
    "\n"
    "[domain]\n"
    "level = 8\n"
    "\n"
    "[output]\n"
    "fields = pressure, film_thickness, temperature_1, temperature_2, "
    "temperature_middle\n";

static const struct kind {
    const char *name, *head, *tail;
    bool physical;
} kinds[] = {
    {"roller", roller, roller_end, true},
    {"gear", gear, gear_end, true},
    {"cam", cam, cam_end, true},
    {"numbers", numbers, numbers_end, false},
    {"starved", starved, starved_end, true},
    {"discs", discs, NULL, true}, /* with oils of their own */
    {"hot", traction_hot, NULL, true},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* ---------------------------------------------------------------- writing */

static void put_case(const struct kind *kind, const struct oil *oil, FILE *to)
{
    fputs(kind->head, to);
    if (!kind->tail)
        return;
    fprintf(to, "\n[lubricant]                  # %s\n", oil->what);
    if (kind->physical)
        fprintf(to, "viscosity = %s\n", oil->viscosity);
    fprintf(to, "alpha = %s\np0 = 198 MPa\nz = 0.68\n", oil->alpha);
    fputs(kind->tail, to);
}

static const struct kind *find_kind(const cli_call *call, const char *name)
{
    const char *names[KINDS], *meant;
    for (int i = 0; i < KINDS; i++) {
        names[i] = kinds[i].name;
        if (!strcmp(names[i], name))
            return &kinds[i];
    }
    meant = ovr_suggest(name, names, KINDS);
    cli_usage(call,
              "no case '%s'%s%s; there are roller, gear, cam, numbers, "
              "starved, discs, hot",
              name, meant ? "; did you mean " : "", meant ? meant : "");
    return NULL;
}

static const struct oil *find_oil(const cli_call *call, const char *name)
{
    for (int i = 0; i < OILS; i++)
        if (!strcmp(oils[i].name, name))
            return &oils[i];
    cli_usage(call, "no oil '%s'; there are paper, vg32, vg68, vg100, vg220",
              name);
    return NULL;
}

static int run(cli_call *call)
{
    const char *oil_name = cli_value(call, "oil"), *path = cli_value(call, "o");
    const struct kind *kind = find_kind(
        call, call->arguments ? call->argument[0] : "roller");
    const struct oil *oil = kind ? find_oil(call, oil_name ? oil_name : "paper")
                                 : NULL;
    cli_output out;
    int code;
    if (!oil)
        return CLI_USAGE;
    if (oil_name && !kind->tail) {
        cli_usage(call, "'%s' has an oil of its own, by its data sheet",
                  kind->name);
        return CLI_USAGE;
    }
    code = cli_output_open(call, path, &out);
    if (code != CLI_DONE)
        return code;
    put_case(kind, oil, out.to);
    return cli_output_close(&out, code);
}

static const cli_option options[] = {
    {"oil", "NAME", "paper, vg32, vg68, vg100, vg220", false},
    {"o", "FILE", "write it there, not on standard output", false},
    {"force", NULL, "replace an existing file", false},
    {0}};

const cli_verb cli_init = {
    .name = "init",
    .arguments = "[KIND] [-o FILE]",
    .summary = "write a commented case to start from",
    .help =
        "Kinds: roller (a dented bearing), gear (a tooth with ground flank "
        "and load\nhistory), cam (a speed that reverses), numbers (M and L), "
        "starved (several passes "
        "with little oil), discs (a twin-disc machine).",
    .options = options,
    .least = 0,
    .most = 1,
    .run = run,
};
