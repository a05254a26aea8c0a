/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll help TOPIC: words that are neither a command nor a key. */
#include <stdio.h>
#include <string.h>

#include "cli/cli.h"
#include "overroll/text.h"

static const struct {
    const char *name, *text;
} topics[] = {
    {"friction",
     "Friction is reported by 'steady' and 'run': mu_1 and mu_2 on the two\n"
     "surfaces, their sliding part mu_slide and rolling part mu_roll, and the\n"
     "forces F_1, F_2 (with [contact] width in N).  The coefficients need "
     "b/R:\n"
     "a modulus, or contact.G beside M and L.\n\n"
     "A Newtonian film that slides has more friction than any oil carries.  "
     "Give\n[lubricant] a flow law and a limit:\n"
     "    rheology = eyring\n    eyring_stress = 5 MPa\n"
     "    limiting_shear = 0.07\n"
     "and heat, where it slides much: [heat] model = lobatto."},
    {"Hertz",
     "The dry contact is the scale of everything: its largest pressure\n"
     "    ph = sqrt(w E'/(2 pi R)),\nits half width\n"
     "    b = sqrt(8 w R/(pi E')),\n"
     "w the load per unit width, R the reduced radius, E' the reduced modulus\n"
     "(2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2).  'overroll check' prints both.\n"
     "hertz_pressure in [contact] may stand in place of the load."},
    {"rpm",
     "Speeds in [contact] may be rotations, where the bodies have radii:\n"
     "    [contact]\n    speed_1 = 1500 rpm\n    speed_2 = 1480 rpm\n"
     "    [body 1]\n    radius = 20 mm\n    [body 2]\n    radius = 25 mm\n"
     "Their surfaces move at the angular speed times the radius."},
    {"torque",
     "A torque is not an output of its own: it is the friction force on a "
     "body\ntimes its radius.  With [contact] width the forces F_1_N and F_2_N "
     "are in\n'steady --json' and 'run --json'; without it F_1 and F_2 are in "
     "N/m.\nThe power that is lost stands there as power_dissipated."},
    {"study",
     "A study is many runs of one case: a file for 'overroll sweep' that names "
     "the\ncase and what varies.\n"
     "    [study]\n    case = dent.ini\n    [product]\n"
     "    contact.load = 50 kN/m, 100 kN/m\n"
     "    feature.dent.depth = linear 0.1 um to 0.4 um in 4\n"
     "    feature.rough.seed = 1..8\n"
     "Each key of [product] is an axis; those of a [zip] go together; [set] "
     "changes\nthe case for all.  'overroll plot STUDY.ini' draws what came "
     "out.  More in\noverroll-study(5)."},
    {"random",
     "Random draws are a section of a study: keys with a distribution each.\n"
     "    [study]\n    case = dent.ini\n    [random]\n    draws = 64\n"
     "    contact.mean_speed = normal 3 m/s sd 0.3 m/s\n"
     "    feature.rough.seed = 1..64\n"
     "    [limits]\n    H_min_overall = at least 0.1 um\n"
     "'overroll sweep STUDY.ini' runs them, with --statistics it tells means,\n"
     "quantiles and the probability of each limit.  More in "
     "overroll-study(5)."},
    {"film",
     "The film is reported as H_min (the smallest) and H_cen (at X = 0), in\n"
     "b^2/R and, where the case is physical, in metres; H_min_overall is the "
     "smallest\nof a whole run.  'overroll check' gives it by formulas before "
     "anything is solved.\nWith roughness, lambda_ratio is the mean film in "
     "|X| < 3/4, and over the run,\nover the composite Rq of both surfaces, "
     "what is longer than "
     "the contact left\nout; lambda_ratio_min is the smallest.  What is stored "
     "of it: [output] fields;\n'overroll plot' draws it."},
    {"life",
     "Stresses below a surface and what they do to the material:\n"
     "    [stress]\n    surface = 1\n    [fatigue]\n    criterion = circle\n"
     "gives the risk of this material history against that of the smooth "
     "contact, the "
     "length of\nsmooth raceway that it is worth, and with a raceway the ratio "
     "of lives.\n'overroll stress OUT.h5' does it again for a stored run with "
     "other constants.\nMore in overroll-theory(7)."},
    {"grease",
     "There is no law of grease.  What forms the film in a greased contact is "
     "its base\noil, starved: take the base oil's viscosity and alpha, and a "
     "supply that is a film:\n"
     "    [cavitation]\n    model = conserving\n    [supply]\n"
     "    model = film\n    thickness_1 = 0.5 um\n"
     "    thickness_2 = 0.5 um"},
};
enum { COUNT = sizeof topics / sizeof *topics };

const char *cli_topic_name(size_t k)
{
    return k < COUNT ? topics[k].name : NULL;
}

bool cli_help_topic(const char *topic)
{
    for (size_t k = 0; k < COUNT; k++)
        if (!strcmp(topics[k].name, topic)) {
            puts(topics[k].text);
            return true;
        }
    return false;
}

/* ------------------------------------------------------------------ units */

/* Those of a quantity in a line, after its SI unit. */
static void put_units(void)
{
    const char *name, *si, *before = "";
    int column = 0;
    for (size_t k = 0; (name = ovr_unit_name(k, &si)); k++) {
        if (strcmp(si, before) != 0)
            column = printf("%s  %-7s", *before ? "\n" : "", si);
        else if (column + (int)strlen(name) > 76)
            column = printf("\n%9s", "");
        if (strcmp(name, si) != 0)
            column += printf("  %s", name);
        before = si;
    }
    putchar('\n');
}

void cli_help_units(void)
{
    puts(
        "Numbers are written with a point; a unit follows its number:\n"
        "    viscosity = 40 mPa.s    alpha = 22 1/GPa    depth = 1.2 um\n\n"
        "A length, height or time without a unit is in the contact's own "
        "units:\n"
        "    lengths along x in b, heights and films in b^2/R, times in b/um,\n"
        "    b = sqrt(8 w R/(pi E')) the half width of the dry contact, um the "
        "mean speed;\n"
        "'0.6 b' is the same as 0.6.\n"
        "With a unit it is physical and needs a physical contact, or, beside "
        "M and L,\n"
        "radius and modulus (and viscosity or speeds for times).  Load, "
        "radius, modulus,\n"
        "viscosity, alpha, speeds and pressures always carry their unit.  "
        "slide_to_roll\nis bare or in %.\n\n"
        "All units, by what they measure:\n");
    put_units();
}
