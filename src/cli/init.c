/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll init [KIND]: prints a commented case. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/output.h"

/* Lubricants. Viscosities of the ISO VG grades are the mid-point values of ISO
 * 3448 at 40 C, with a density of 0.86 g/cm3. alpha follows from Roelands'
 * relation alpha = z (ln eta0 + 9.67)/p0 with z = 0.68 and p0 = 198 MPa,
 * typical of paraffinic mineral oils. `paper` is the oil of Venner, ten Napel &
 * Bosma 1990, with a viscosity of its class. */
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

/* A shear-thinning lubricant: the pressure of a Newtonian film at a surface
 * feature grows without limit on finer grids, and its friction in a sliding
 * contact exceeds that of real lubricants. */
#define THINS_ABOVE(STRESS)                                                    \
    "rheology = eyring            # shear thinning\n"                          \
    "eyring_stress = " STRESS " MPa\n"                                         \
    "limiting_shear = 0.08        # limiting shear stress / pressure\n"
#define THINS THINS_ABOVE("5")
#define THINS_BY_NUMBER                                                        \
    "rheology = eyring            # shear thinning\n"                          \
    "eyring_number = 0.2          # Eyring stress / (p_h b/R)\n"

static const char roller[] =
    "# Roller bearing: a small dent with a raised rim on the ring passes.\n"
    "# overroll check THIS.ini prints predictions, overroll run THIS.ini runs "
    "it.\n"
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
    "end = 13                     # in b/u_m; or with a unit: 0.5 ms\n"
    "\n"
    "[feature dent]\n"
    "surface = 1\n"
    "shape = indent\n"
    "depth = 0.4 um               # without a unit: in b^2/R\n"
    "width = 0.6                  # in b\n"
    "shoulder = 0.05 um\n"
    "start = -9                   # upstream of the inlet, see check\n"
    "\n"
    "[output]\n"
    "file = roller.h5             # in the folder of this case\n"
    "every = 8                    # steps\n";

static const char gear[] =
    "# Gear pair with a ground flank, from the start to the end of contact.\n"
    "# overroll check THIS.ini prints the contact positions A to E.\n"
    "\n"
    "[gear]\n"
    "teeth_1 = 25                 # gear 1 is surface 1\n"
    "teeth_2 = 57                 # negative: an internal gear\n"
    "module = 2.5 mm              # normal\n"
    "face = 20 mm\n"
    "speed = 3000 rpm             # of gear 1\n"
    "torque = 80 N.m              # on gear 1; or power = 25 kW\n"
    "# centre = 103 mm            # determines one shift\n"
    "# shift_1 = 0.2              # in modules\n"
    "# helix_angle = 15 deg\n"
    "\n"
    "[contact]\n"
    "modulus = 226 GPa            # reduced E' of steel on steel\n";

static const char gear_end[] =
    "\n"
    "[domain]\n"
    "level = 7\n"
    "\n"
    "[time]                       # default end: end of contact\n"
    "scheme = characteristic      # most accurate for short waves\n"
    "\n"
    "[feature grinding]\n"
    "surface = 1\n"
    "shape = roughness\n"
    "Rq = 0.03 um\n"
    "length = 20                  # in b\n"
    "shortest = 0.25\n"
    "seed = 1                     # another seed, another surface\n"
    "start = 6                    # position of its leading end\n"
    "grow = 1                     # grows in place at the start of contact\n"
    "\n"
    "[output]\n"
    "file = gear.h5\n"
    "every = 8\n";

static const char cam[] =
    "# Cam and flat follower.  The entrainment speed passes through zero at\n"
    "# the reversals that overroll check THIS.ini prints.\n"
    "\n"
    "[cam]\n"
    "follower = flat              # or roller, with roller_radius\n"
    "base_radius = 26 mm\n"
    "face = 12 mm\n"
    "speed = 1000 rpm             # of the cam, surface 1\n"
    "law = 4567                   # or 345, cycloidal, harmonic, table\n"
    "lift = 6 mm\n"
    "rise = 70 deg                # default of fall\n"
    "spring = 30 N/mm\n"
    "preload = 250 N\n"
    "mass = 100 g                 # moving mass of the follower\n"
    "\n"
    "[contact]\n"
    "modulus = 226 GPa\n";

static const char cam_end[] =
    "\n"
    "[domain]\n"
    "level = 9\n"
    "\n"
    "[time]\n"
    "step = adaptive              # the film changes fast at reversals only\n"
    "\n"
    "[output]\n"
    "file = cam.h5\n"
    "every = 40\n";

static const char bearing[] =
    "# Roller bearing 209 under 4450 N: a dent on the inner ring meets "
    "several\n"
    "# rollers in one crossing of the load zone.\n"
    "\n"
    "[roller_bearing]\n"
    "roller = 10 mm               # diameter\n"
    "rollers = 14\n"
    "length = 9.6 mm\n"
    "inner = 54.991 mm            # diameter of the raceway; or pitch\n"
    "clearance = 41 um\n"
    "load = 4450 N\n"
    "speed_inner = 1000 rpm\n"
    "contact = inner\n"
    "passes = zone                # determines [passes]\n"
    "\n"
    "[contact]\n"
    "modulus = 226 GPa\n";

static const char bearing_end[] =
    "\n"
    "[domain]\n"
    "level = 9\n"
    "\n"
    "[cavitation]\n"
    "model = conserving           # each pass uses the oil left by the last\n"
    "\n"
    "[time]\n"
    "end = 30\n"
    "\n"
    "[feature dent]\n"
    "surface = 1\n"
    "shape = indent\n"
    "depth = 0.4 um\n"
    "width = 2                    # in b\n"
    "shoulder = 0.05 um\n"
    "start = -26                  # upstream of the inlet, see check\n"
    "\n"
    "[output]\n"
    "file = bearing.h5\n";

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
    "[time]                       # remove this section for steady cases\n"
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
    "# Twin-disc machine: discs by radius, material and rotational speed, oil "
    "by\n"
    "# its data sheet.\n"
    "\n"
    "[contact]\n"
    "width = 10 mm                # of the track\n"
    "load = 2000 N                # over that width\n"
    "speed_1 = 1000 rpm           # of disc 1, surface speed along +x\n"
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
    "alpha = 20 1/GPa             # at that temperature\n" THINS "\n"
    "[domain]\n"
    "level = 8\n";

static const char starved[] =
    "# Starved: a smooth roller passes ten times, and a tenth of the oil is\n"
    "# lost between passes.  Remove [passes] for one pass.\n"
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
    "model = conserving           # mass-conserving\n"
    "\n"
    "[supply]\n"
    "model = film                 # of the first pass; or flooded\n"
    "thickness_1 = 0.2 um         # supplied on each surface\n"
    "thickness_2 = 0.2 um\n"
    "\n"
    "[passes]\n"
    "number = 10\n"
    "loss = 0.1                   # of each layer between two passes\n"
    "\n"
    "[output]\n"
    "file = starved.h5            # one row per pass; results: starved-1.h5 "
    "...\n";

/* A disc machine with sliding speed and load for which thermal effects
 * matter. */
static const char traction_hot[] =
    "# Two sliding steel discs: friction, film thickness and temperatures.\n"
    "[contact]\n"
    "load = 300 kN/m\n"
    "mean_speed = 5 m/s\n"
    "slide_to_roll = 0.2\n"
    "\n"
    "[body 1]\n"
    "material = steel             # also thermal properties\n"
    "radius = 35 mm\n"
    "\n"
    "[body 2]\n"
    "material = steel\n"
    "radius = 35 mm\n"
    "\n"
    "[lubricant]\n"
    "temperature = 60 degC        # of the supply, and of the bodies\n"
    "iso_vg = 68\n"
    "viscosity_index = 98         # viscosity against temperature\n"
    "density_15 = 880 kg/m3\n"
    "alpha = 20 1/GPa             # at that temperature\n" THINS "\n"
    "[heat]\n"
    "model = lobatto\n"
    "\n"
    "[domain]\n"
    "level = 8\n"
    "\n"
    "[output]\n"
    "fields = pressure, film_thickness, temperature_1, temperature_2, "
    "temperature_middle\n";

/* A disc machine with thermal effects and a hard coating of low thermal
 * conductivity. */
static const char coated[] =
    "# Two sliding steel discs, one with a DLC coating: friction, film\n"
    "# thickness, temperatures, and stresses in the coating and below.\n"
    "[contact]\n"
    "load = 300 kN/m\n"
    "mean_speed = 5 m/s\n"
    "slide_to_roll = 0.2\n"
    "\n"
    "[body 1]\n"
    "material = steel\n"
    "radius = 35 mm\n"
    "\n"
    "[body 2]\n"
    "material = steel\n"
    "radius = 35 mm\n"
    "\n"
    "[coating 1]                  # on body 1; [coating 1b] below it, "
    "[coating 2]\n"
    "material = dlc               # or modulus, poisson, conductivity, ...\n"
    "thickness = 3 um\n"
    "residual_x = -1 GPa          # residual stress along and across\n"
    "residual_y = -1 GPa\n"
    "\n"
    "[lubricant]\n"
    "temperature = 60 degC        # of the supply, and of the bodies\n"
    "iso_vg = 68\n"
    "viscosity_index = 98\n"
    "density_15 = 880 kg/m3\n"
    "alpha = 20 1/GPa             # at that temperature\n" THINS "\n"
    "[heat]\n"
    "model = lobatto\n"
    "\n"
    "[domain]\n"
    "level = 8\n"
    "\n"
    "[stress]\n"
    "surface = 1                  # in the coating and below\n";

/* The roller's raceway, softer than bearing steel, after a deep indentation. */
static const char indented_end[] =
    "\n"
    "[domain]\n"
    "level = 8\n"
    "order = 2                    # rim heights are more accurate than by "
    "order 4\n"
    "\n"
    "[time]\n"
    "end = 12                     # the dent has left the contact\n"
    "\n"
    "[feature dent]\n"
    "surface = 1\n"
    "shape = indent\n"
    "depth = 1.5 um\n"
    "width = 0.6                  # in b\n"
    "shoulder = 0.25 um           # rim that is rolled down\n"
    "start = -9                   # upstream of the inlet, see check\n"
    "\n"
    "[stress]                     # elastic stresses, needed by [plastic]\n"
    "surface = 1\n"
    "\n"
    "[fatigue]\n"
    "limit_pressure = none        # to compare the passes\n"
    "\n"
    "[plastic]\n"
    "surface = 1\n"
    "hardening = linear           # none, kinematic; swift: bearing steel\n"
    "yield = 0.87 GPa             # von Mises; 1.36 GPa: bearing steel\n"
    "modulus = 4.5 GPa            # hardening modulus\n"
    "passes = 3                   # fewer if it shakes down earlier\n"
    "elastic = yes                # an elastic pass first, to compare lives\n"
    "\n"
    "[output]\n"
    "file = indented.h5           # results of the passes: indented-1.h5 ...\n"
    "every = 8\n";

/* The roller with a film that varies across the rolling direction. */
static const char strip_end[] =
    "\n"
    "[strip]                      # the film varies along x and y\n"
    "width = 2                    # in b, the period across rolling\n"
    "\n"
    "[domain]\n"
    "level = 6                    # 449 nodes along x; 96 lines across\n"
    "\n"
    "[time]\n"
    "end = 8.2                    # in b/um: the dent has left\n"
    "\n"
    "[feature dent]\n"
    "surface = 1\n"
    "shape = indent               # round, as a hard particle makes it\n"
    "depth = 0.2 um\n"
    "width_half = 0.4             # diameter at half its depth, in b\n"
    "shoulder = 0.05 um           # the rim raised around it\n"
    "shoulder_at = 0.45           # radius of its crest\n"
    "shoulder_width = 0.4\n"
    "across = 0                   # y of its centre\n"
    "start = inlet                # enters the film at once\n"
    "\n"
    "[output]\n"
    "file = strip.h5              # fields are (time, y, x)\n"
    "every = 4                    # steps\n";

static const struct kind {
    const char *name, *head, *tail;
    bool physical;
    const char *flow; /* lines of the rheological model; NULL: Newtonian, or in
                       * the first part */
} kinds[] = {
    {"roller", roller, roller_end, true, THINS},
    {"gear", gear, gear_end, true, THINS},
    {"cam", cam, cam_end, true, THINS},
    {"bearing", bearing, bearing_end, true, THINS},
    {"indented", roller, indented_end, true, THINS_ABOVE("3")},
    {"numbers", numbers, numbers_end, false, THINS_BY_NUMBER},
    {"starved", starved, starved_end, true, NULL},
    {"discs", discs, NULL, true, NULL}, /* with lubricants of their own */
    {"hot", traction_hot, NULL, true, NULL},
    {"coated", coated, NULL, true, NULL},
    {"strip", roller, strip_end, true, THINS},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* ---------------------------------------------------------------- writing */

static void write_case(const struct kind *kind, const struct oil *oil, FILE *to)
{
    fputs(kind->head, to);
    if (!kind->tail)
        return;
    fprintf(to, "\n[lubricant]                  # %s\n", oil->what);
    if (kind->physical)
        fprintf(to, "viscosity = %s\n", oil->viscosity);
    fprintf(to, "alpha = %s\np0 = 198 MPa\nz = 0.68\n", oil->alpha);
    if (kind->flow)
        fputs(kind->flow, to);
    fputs(kind->tail, to);
}

static const struct kind *find_kind(const cli_call *call, const char *name)
{
    const char *names[KINDS], *meant;
    char there[200];
    for (int i = 0; i < KINDS; i++) {
        names[i] = kinds[i].name;
        if (!strcmp(names[i], name))
            return &kinds[i];
    }
    meant = ovr_suggest(name, names, KINDS);
    cli_join(names, KINDS, there, sizeof there);
    cli_usage(call, "no case '%s'%s%s; there are %s", name,
              meant ? "; did you mean " : "", meant ? meant : "", there);
    return NULL;
}

static const struct oil *find_oil(const cli_call *call, const char *name)
{
    const char *names[OILS];
    char there[200];
    for (int i = 0; i < OILS; i++) {
        names[i] = oils[i].name;
        if (!strcmp(names[i], name))
            return &oils[i];
    }
    cli_join(names, OILS, there, sizeof there);
    cli_usage(call, "no oil '%s'; there are %s", name, there);
    return NULL;
}

/* Reads the template as a case and applies --set, so that wrong keys or values
 * are rejected as in other commands. `text` belongs to the case `c`. */
static int make_text(cli_call *call, const struct kind *kind,
                     const struct oil *oil, ovr_case **c, const char **text)
{
    ovr_error err = {0};
    char *whole = NULL;
    size_t bytes;
    FILE *to = open_memstream(&whole, &bytes);
    const char *setting;
    int code = CLI_DONE;
    if (!to)
        return CLI_FAILED;
    write_case(kind, oil, to);
    if (fclose(to))
        return CLI_FAILED;
    *c = ovr_case_read_text(whole, "init", NULL, NULL, &err);
    free(whole);
    for (int k = 0;
         !code && *c && (setting = cli_value_at(call, "set", k)) != NULL; k++)
        if (ovr_case_assign(*c, setting, "--set", &err))
            code = cli_fail(&err);
    *text = *c && !code ? ovr_case_text(*c, &err) : NULL;
    return code || *text ? code : cli_fail(&err);
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
    ovr_case *c = NULL;
    const char *text = NULL;
    code = make_text(call, kind, oil, &c, &text);
    if (code == CLI_DONE)
        code = cli_output_open(call, path, &out);
    if (code == CLI_DONE) {
        fputs(text, out.to);
        code = cli_output_close(&out, code);
    }
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {
    {"oil", "NAME", "paper, vg32, vg68, vg100, vg220", false},
    {"o", "FILE", "output file (default: standard output)", false},
    {"set", "KEY=VALUE", "change a value of the case, e.g. gear.module=3mm",
     true},
    {"force", NULL, "replace an existing file", false},
    {0}};

const cli_verb cli_init = {
    .name = "init",
    .no_json = true,
    .arguments = "[KIND] [--set KEY=VALUE]... [-o FILE]",
    .summary = "write a commented case to start from",
    .help =
        "Kinds of cases:\n"
        "  roller     raceway with a dent (default)\n"
        "  gear       tooth pair of a spur gear, from the drawing\n"
        "  cam        cam with a flat follower\n"
        "  bearing    roller positions met by a raceway point\n"
        "  indented   raceway with plastic deformation below a dent\n"
        "  coated     discs, one of them coated\n"
        "  numbers    Moes' numbers M and L\n"
        "  starved    several passes with a limited lubricant supply\n"
        "  discs      twin-disc machine\n"
        "  hot        twin-disc machine with heat\n"
        "  strip      round dent, film that varies across rolling\n"
        "--set changes a value of the case: init gear --set gear.module=3mm.",
    .options = options,
    .minimum = 0,
    .maximum = 1,
    .run = run,
};
