/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help topics that are neither a command nor a key, and synonyms of topics. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "cli/cli.h"
#include "overroll/text.h"

static const struct {
    const char *name, *text;
} topics[] = {
    {"friction",
     "'steady' and 'run' print the friction coefficients mu_1 and mu_2 of the "
     "two\nsurfaces, their sliding part mu_slide and rolling part mu_roll, and "
     "the\nforces F_1 and F_2 (in N with contact.width, otherwise in N/m).  "
     "Coefficients\nneed b/R: set a modulus, or contact.G in addition to M and "
     "L.\n\n"
     "A sliding Newtonian film has more friction than any lubricant sustains.  "
     "Set a\nrheological model and a limiting shear stress:\n"
     "    [lubricant]\n    rheology = eyring\n    eyring_stress = 5 MPa\n"
     "    limiting_shear = 0.07\n"
     "and at high sliding speed also heat: [heat] model = lobatto.\n\n"
     "The friction power loss is power_dissipated.  Gear pairs, cams and "
     "bearings also\nprint the power loss of the element, and gear pairs the "
     "efficiency."},
    {"hertz",
     "The dry (Hertzian) contact of smooth bodies is the reference of all "
     "scales: its\nmaximum pressure\n"
     "    p_h = sqrt(w E'/(2 pi R))\nand half width\n"
     "    b = sqrt(8 w R/(pi E')),\n"
     "with the load per unit width w, the reduced radius R and the reduced "
     "modulus E'\n(2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2).  'overroll check' "
     "prints both.\n"
     "Set contact.hertz_pressure instead of contact.load if p_h is known."},
    {"rpm",
     "Speeds in [contact] may be rotational speeds if the bodies have radii:\n"
     "    [contact]\n    speed_1 = 1500 rpm\n    speed_2 = 1480 rpm\n"
     "    [body 1]\n    radius = 20 mm\n    [body 2]\n    radius = 25 mm\n"
     "The surface speed is the angular speed times the radius."},
    {"torque",
     "A friction torque is the friction force on a body times its radius.  "
     "With\ncontact.width, 'steady --json' and 'run --json' print the forces "
     "F_1_N and F_2_N\nin N; without it, F_1 and F_2 are in N/m.  The friction "
     "power loss is\npower_dissipated."},
    {"study",
     "A parameter study is many runs of one case.  The file for 'overroll "
     "sweep'\nnames the case and the parameters that vary:\n"
     "    [study]\n    case = dent.ini\n    [product]\n"
     "    contact.load = 50 kN/m, 100 kN/m\n"
     "    feature.dent.depth = linear 0.1 um to 0.4 um in 4\n"
     "    feature.rough.seed = 1..8\n"
     "All combinations of the keys in [product] are run; the keys of a [zip] "
     "vary\ntogether; [set] changes the case for all runs.  'overroll plot "
     "STUDY.ini' draws\nthe results.  See overroll-study(5)."},
    {"random",
     "A random study draws keys from probability distributions:\n"
     "    [study]\n    case = dent.ini\n    [random]\n    draws = 64\n"
     "    contact.mean_speed = normal 3 m/s sd 0.3 m/s\n"
     "    contact.load = normal 300 kN/m sd 10 %\n"
     "    feature.rough.seed = 1..64\n"
     "    [limits]\n    H_min_overall = at least 0.1 um\n"
     "'overroll sweep STUDY.ini' runs the samples; --statistics prints means, "
     "quantiles\nand the probability of each limit.  See overroll-study(5)."},
    {"film",
     "Results contain the minimum film thickness H_min_located and the\n"
     "central film thickness H_cen (at X = 0), in b^2/R and, for a case with "
     "dimensions, in\nmetres.  H_min is the minimum of the values at nodes, "
     "H_min_overall the minimum over\na run.  'overroll check' prints "
     "predictions by formulas before anything is solved;\n'overroll plot' "
     "draws the film thickness.  [output] fields selects what is stored.\n"
     "See also 'overroll help lambda-ratio'."},
    {"lambda-ratio",
     "The lambda ratio (specific film thickness) is a film thickness divided "
     "by the\ncomposite roughness sqrt(Rq_1^2 + Rq_2^2) of both surfaces:\n"
     "    roughness on the grid   mean film thickness in |X| < 3/4\n"
     "    other roughness         minimum film thickness\n"
     "Roughness on the grid is the roughness of the features; waves longer "
     "than the\ncontact are omitted.  Other roughness is set by "
     "contact.Rq_1, contact.Rq_2\nor boundary.Rq.  The key contact.lambda is "
     "something "
     "else: the dimensionless\nspeed parameter of Venner, ten Napel & Bosma "
     "(1990)."},
    {"roughness",
     "Roughness on the grid is a feature of the surfaces, measured or random:\n"
     "    [feature ground]\n    surface = 1\n    shape = profile\n"
     "    file = ground.csv\n"
     "    [feature rough]\n    surface = 2\n    shape = roughness\n"
     "    Rq = 0.1 um\n    length = 2 mm\n"
     "'overroll profile FILE' prints the roughness parameters of a measured "
     "profile.\n\n"
     "Roughness that is not on the grid: with [boundary], asperities carry "
     "part "
     "of the\nload (boundary.Rq: composite root mean square roughness).  "
     "contact.Rq_1 and\ncontact.Rq_2 only give the lambda ratio.  See also "
     "'overroll help lambda-ratio'."},
    {"areal",
     "A measured map of heights over x and y is a feature of a strip.\n"
     "    [strip]\n"
     "    [feature ground]\n    shape = areal\n    file = ground.x3p\n"
     "The file is X3P, SDF, SUR, NumPy or text (a matrix or points x y z).\n"
     "Operations, after the window, missing heights and outliers.\n"
     "    F-operation   level, degree   removes the plane or a polynomial\n"
     "    L-filter      lambda_c        removes waves longer than the nesting "
     "index\n"
     "    S-filter      lambda_s        removes waves shorter than the nesting "
     "index\n"
     "'overroll profile FILE' prints areal parameters of ISO 25178-2.\n"
     "    Sa, Sq     arithmetic and root mean square height\n"
     "    Ssk, Sku   skewness and kurtosis of the heights (Gaussian: 0 and "
     "3)\n"
     "    Str        texture aspect ratio, 0 (strong lay) to 1 (isotropic)\n"
     "    lay        direction of the lay, degrees from the x axis\n\n"
     "Random areal roughness is shape = roughness on a strip.  Rq is its Sq, "
     "and\npeklenik the ratio of its correlation lengths along and across "
     "rolling.  angle\nturns its lay.  See 'overroll help width_across' for "
     "features of finite length."},
    {"wear",
     "Running-in needs [boundary], constant operating conditions and a case "
     "without\n[time]:\n"
     "    [boundary]\n    law = profile\n    wear_1 = 1e-9 mm3/Nm\n"
     "    wear_2 = 1e-9 mm3/Nm\n    passes = 1e6\n"
     "wear_1 and wear_2 are Archard's wear coefficients divided by the "
     "hardness.\nSee overroll-case(5) and tools/examples/running-in.ini."},
    {"stribeck",
     "A Stribeck curve is a parameter study over the speed of a case with\n"
     "[boundary]:\n"
     "    [study]\n    case = rollers.ini\n    [product]\n"
     "    contact.mean_speed = log 0.01 to 100 m/s in 25\n"
     "'overroll sweep STUDY.ini' runs it and\n"
     "'overroll plot STUDY.ini --kind stribeck -o PICTURE' draws friction, "
     "asperity load share\n"
     "and film thickness.  overroll-recipes(7) has a complete example."},
    {"life",
     "Stresses below a surface and the fatigue risk of the material:\n"
     "    [stress]\n    surface = 1\n    [fatigue]\n    criterion = circle\n"
     "The report contains the risk relative to that of the smooth contact, the "
     "length\nof smooth raceway with the same risk and, with "
     "fatigue.raceway, the ratio of\nlives.  'overroll stress OUT.h5' repeats "
     "this for a stored run with other\nconstants.  See overroll-theory(7)."},
    {"grease",
     "There is no model of grease.  The film of a greased contact is formed by "
     "the base\noil, usually starved: set the viscosity and alpha of the base "
     "oil and a supply:\n"
     "    [cavitation]\n    model = conserving\n    [supply]\n"
     "    model = film\n    thickness_1 = 0.5 um\n"
     "    thickness_2 = 0.5 um"},
};
enum { COUNT = sizeof topics / sizeof *topics };

/* Terms and symbols of the field, without blanks, hyphens and underscores, and
 * the topic, section, key or command that explains each. */
static const struct {
    const char *term, *topic;
} synonyms[] = {
    {"hertzian", "hertz"},
    {"contactpressure", "hertz"},
    {"halfwidth", "hertz"},
    {"ph", "hertz"},
    {"b", "hertz"},
    {"filmthickness", "film"},
    {"hmin", "film"},
    {"hcen", "film"},
    {"hc", "film"},
    {"minimumfilmthickness", "film"},
    {"centralfilmthickness", "film"},
    {"oilfilm", "film"},
    {"lambda_ratio", "lambda-ratio"},
    {"specificfilmthickness", "lambda-ratio"},
    {"filmparameter", "lambda-ratio"},
    {"rough", "roughness"},
    {"rq", "roughness"},
    {"ra", "roughness"},
    {"rms", "roughness"},
    {"sigma", "roughness"},
    {"sq", "areal"},
    {"sa", "areal"},
    {"ssk", "areal"},
    {"sku", "areal"},
    {"str", "areal"},
    {"foperation", "areal"},
    {"sfilter", "areal"},
    {"lfilter", "areal"},
    {"nestingindex", "areal"},
    {"lay", "areal"},
    {"textureaspectratio", "areal"},
    {"isotropy", "areal"},
    {"isotropic", "areal"},
    {"topography", "areal"},
    {"map", "areal"},
    {"maps", "areal"},
    {"x3p", "areal"},
    {"sdf", "areal"},
    {"sur", "areal"},
    {"acrossrolling", "strip"},
    {"footprint", "width_across"},
    {"round", "width_across"},
    {"elliptical", "width_across"},
    {"scratch", "groove"},
    {"oblique", "angle"},
    {"longitudinal", "angle"},
    {"transverse", "angle"},
    {"rounddent", "indent"},
    {"surface", "roughness"},
    {"surfaceroughness", "roughness"},
    {"asperity", "boundary"},
    {"asperities", "boundary"},
    {"mixed", "boundary"},
    {"mixedlubrication", "boundary"},
    {"boundarylubrication", "boundary"},
    {"greenwoodtripp", "boundary"},
    {"greenwoodwilliamson", "boundary"},
    {"patircheng", "boundary.flow_factor"},
    {"flowfactors", "boundary.flow_factor"},
    {"stribeckcurve", "stribeck"},
    {"runningin", "wear"},
    {"archard", "wear"},
    {"traction", "friction"},
    {"frictioncoefficient", "friction"},
    {"cof", "friction"},
    {"mu", "friction"},
    {"efficiency", "friction"},
    {"losses", "friction"},
    {"powerloss", "friction"},
    {"fatigue", "life"},
    {"rcf", "life"},
    {"l10", "life"},
    {"dangvan", "fatigue"},
    {"subsurfacestress", "stress"},
    {"vonmises", "stress"},
    {"shakedown", "plastic"},
    {"yielding", "plastic"},
    {"plasticity", "plastic"},
    {"movie", "frames"},
    {"video", "frames"},
    {"animation", "frames"},
    {"mp4", "frames"},
    {"gif", "frames"},
    {"csv", "export"},
    {"paraview", "export"},
    {"vtk", "export"},
    {"html", "view"},
    {"png", "plot"},
    {"picture", "plot"},
    {"dlc", "coating"},
    {"coatings", "coating"},
    {"layer", "coating"},
    {"thinfilm", "coating"},
    {"bearing", "roller_bearing"},
    {"rollerbearing", "roller_bearing"},
    {"roller", "roller_bearing"},
    {"gears", "gear"},
    {"tappet", "cam"},
    {"dent", "indent"},
    {"indentation", "indent"},
    {"debris", "indent"},
    {"starvation", "supply"},
    {"starved", "supply"},
    {"thermal", "heat"},
    {"temperature", "heat"},
    {"grid", "domain"},
    {"mesh", "domain"},
    {"resolution", "level"},
    {"timestep", "step"},
    {"transient", "time"},
    {"squeeze", "speed"},
    {"montecarlo", "random"},
    {"uncertainty", "random"},
    {"doe", "study"},
    {"parameterstudy", "study"},
    {"optimization", "find"},
    {"optimize", "find"},
    {"pressure", "hertz"},
    {"maximumpressure", "hertz"},
    {"young", "body.modulus"},
    {"youngsmodulus", "body.modulus"},
    {"elasticmodulus", "body.modulus"},
    {"barus", "viscosity_law"},
    {"moes", "contact.M"},
    {"u", "contact.mean_speed"},
    {"entrainment", "contact.mean_speed"},
    {"nonnewtonian", "rheology"},
    {"rheologicalmodel", "rheology"},
    {"shearthinning", "rheology"},
    {"density", "lubricant"},
    {"compressibility", "density_law"},
    {"pressureviscosity", "viscosity_law"},
    {"piezoviscosity", "viscosity_law"},
    {"waviness", "wave"},
    {"psd", "roughness"},
    {"gaussian", "roughness"},
    {"cost", "check"},
    {"runtime", "check"},
    {"memory", "check"},
    {"spike", "level"},
    {"pressurespike", "level"},
    {"discretizationerror", "level"},
    {"accuracy", "level"},
    {"python", "export"},
    {"netcdf", "export"},
    {"hdf5", "export"},
    {"matlab", "export"},
    {"excel", "export"},
    {"pitting", "life"},
    {"micropitting", "life"},
    {"weibull", "life"},
    {"bump", "dent"},
    {"ridge", "dent"},
    {"slidingspeed", "sliding"},
    {"cutoff", "profile"},
    {"filter", "profile"},
    {"iso21920", "profile"},
    {"astm", "iso_vg"},
    {"walther", "iso_vg"},
    {"lubricant film", "film"},
    {"sensitivity", "run"},
    {"elasticity", "run"},
};

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

bool cli_same_term(const char *a, const char *b)
{
    for (;; a++, b++) {
        a += strspn(a, " -_'");
        b += strspn(b, " -_'");
        if (tolower((unsigned char)*a) != tolower((unsigned char)*b))
            return false;
        if (!*a)
            return true;
    }
}

const char *cli_synonym(const char *term)
{
    for (size_t k = 0; k < sizeof synonyms / sizeof *synonyms; k++)
        if (cli_same_term(synonyms[k].term, term))
            return synonyms[k].topic;
    return NULL;
}

/* ------------------------------------------------------------------ units */

/* Prints the units of each quantity in a line, the SI unit first. */
static void print_units(void)
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
        "Numbers use a decimal point; a unit follows its number:\n"
        "    viscosity = 40 mPa.s    alpha = 22 1/GPa    depth = 1.2 um\n\n"
        "A length, height or time without a unit is in the contact's own "
        "units:\n"
        "    lengths along x in b, heights and film thicknesses in b^2/R, "
        "times in b/u_m,\n"
        "    b = sqrt(8 w R/(pi E')) the half width of the Hertzian contact,\n"
        "    u_m the entrainment speed;\n"
        "'0.6 b' is the same as 0.6.\n"
        "A value with a unit needs a contact with dimensions or, with M and L, "
        "radius and\nmodulus (for times also viscosity or speeds).  Load, "
        "radius, modulus, viscosity,\nalpha, speeds and pressures always need "
        "a unit.  slide_to_roll is a bare number or\nin %.\n\n"
        "All units, by quantity:\n");
    print_units();
}
