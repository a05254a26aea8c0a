/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll check CASE: what a case means, nothing solved. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "cli/case_args.h"
#include "cli/report.h"
#include "cli/stations.h"

/* Measured at level 8 on one core: time of a node in a cycle, and cycles of a
 * step. */
static const double SECONDS_A_NODE = 2e-7, CYCLES_A_STEP = 3;
static const double CYCLES_STEADY = 12;

typedef struct estimate {
    double nodes, mesh, steps, passes, seconds, bytes;
    ovr_storage stored;
} estimate;

static void hear(void *data, ovr_say kind, const char *text)
{
    const cli_call *call = data;
    if (call->verbosity >= 0)
        fprintf(stderr, "overroll: %s%s\n",
                kind == OVR_SAY_WARNING ? "warning: " : "", text);
}

static void hear_json(void *data, ovr_say kind, const char *text)
{
    if (kind == OVR_SAY_WARNING)
        json_text(data, NULL, text);
}

/* Memory that counts itself: each piece is behind its size. */
enum { HEAD = sizeof(max_align_t) };

static void *take(void *live, size_t bytes)
{
    unsigned char *piece = malloc(HEAD + bytes);
    if (!piece)
        return NULL;
    memcpy(piece, &bytes, sizeof bytes);
    *(double *)live += (double)bytes;
    return piece + HEAD;
}

static void give(void *live, void *memory)
{
    unsigned char *piece = (unsigned char *)memory - HEAD;
    size_t bytes;
    memcpy(&bytes, piece, sizeof bytes);
    *(double *)live -= (double)bytes;
    free(piece);
}

/* One cycle a patch down to the grid of the level, some more at the end; of
 * patches that go on until the spike changes little, eight. */
static double refine_seconds(const ovr_options *o, double nodes)
{
    const double nodes_a_patch = 300, usual = 8, last = 4;
    double levels = o->refine_level ? o->refine_level - o->level : usual;
    if (!o->refine)
        return 0;
    return 2 * SECONDS_A_NODE * (levels + last) *
           (nodes + levels * nodes_a_patch);
}

/* `live`: bytes of the set-up, its surfaces included. */
static estimate estimate_cost(const ovr_setup *setup, double live)
{
    const ovr_march *march = setup->march;
    double dT = march->dT > 0 ? march->dT : setup->mesh;
    estimate cost = {0};
    cost.nodes = (double)setup->nodes;
    cost.mesh = setup->mesh;
    cost.bytes = live + ovr_setup_memory(setup) +
                 ovr_setup_output_memory(setup);
    if (setup->transient)
        cost.steps = ceil(march->end / dT);
    cost.passes = setup->passes->number;
    cost.stored = ovr_setup_storage(setup);
    cost.stored.bytes *= cost.passes;
    cost.seconds = cost.passes * cost.nodes * SECONDS_A_NODE *
                   (2 * CYCLES_STEADY + cost.steps * CYCLES_A_STEP);
    cost.seconds += refine_seconds(setup->options, cost.nodes);
    return cost;
}

/* ------------------------------------------------------------------ table */

static void put_header(const ovr_case_entry *entry)
{
    if (entry->name)
        printf("\n[%s %s]\n", entry->section, entry->name);
    else
        printf("\n[%s]\n", entry->section);
}

static bool has_nodes(const ovr_case *c)
{
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (!strcmp(entry.key, "nodes"))
            return entry.given;
    }
    return false;
}

/* The default level does not count beside nodes. */
static bool is_shown(const ovr_case *c, const ovr_setup *setup,
                     const ovr_case_entry *entry)
{
    if (!entry->text || (!entry->given && !entry->applies) ||
        (!strcmp(entry->section, "stress") && !setup->stress->surfaces) ||
        (!strcmp(entry->section, "fatigue") && !setup->stress->fatigue))
        return false;
    return entry->given || strcmp(entry->section, "domain") != 0 ||
           strcmp(entry->key, "level") != 0 || !has_nodes(c);
}

/* The whole case: reading what is printed gives the same case. */
static void put_parameters(const ovr_case *c, const ovr_setup *setup)
{
    const char *section = "", *name = NULL;
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (!is_shown(c, setup, &entry))
            continue;
        if (strcmp(section, entry.section) != 0 || name != entry.name)
            put_header(&entry);
        section = entry.section;
        name = entry.name;
        printf("%s = %s%s\n", entry.key, entry.text,
               entry.given ? "" : "    # default");
    }
}

static void put_scale(const char *name, double value, double unit,
                      const char *symbol)
{
    if (isfinite(value))
        printf("# %-28s %.6g %s\n", name, value / unit, symbol);
}

static void put_contact(const ovr_contact *contact)
{
    put_scale("M", contact->M, 1, "");
    put_scale("L", contact->L, 1, "");
    put_scale("lambda", contact->lambda, 1, "");
    put_scale("alphabar", contact->alphabar, 1, "");
    put_scale("u1/um", contact->u1_ratio, 1, "");
    put_scale("u2/um", contact->u2_ratio, 1, "");
    put_scale("Hertzian pressure ph", contact->ph, 1e9, "GPa");
    put_scale("half width b", contact->b, 1e-6, "um");
    put_scale("film scale b^2/R", contact->height, 1e-6, "um");
    put_scale("time scale b/um", contact->time, 1e-6, "us");
    put_scale("load", contact->load, 1e3, "kN/m");
    put_scale("mean speed um", contact->um, 1, "m/s");
    put_scale("force over the width", contact->load * contact->width, 1, "N");
    put_scale("reduced radius R", contact->radius, 1e-3, "mm");
    put_scale("reduced modulus E'", contact->modulus, 1e9, "GPa");
    put_scale("viscosity eta0", contact->viscosity, 1e-3, "mPa.s");
}

static void put_film(const char *name, double H, const ovr_contact *contact)
{
    printf("# %-28s H = %.5g", name, H);
    if (isfinite(contact->height))
        printf(" (%.4g um)", H * contact->height * 1e6);
    putchar('\n');
}

/* NAN for other oils than it was fitted to. */
static ovr_film_fit fitted(const ovr_setup *setup)
{
    const ovr_contact *contact = setup->contact;
    const ovr_lubricant *oil = setup->lubricant;
    if (oil->viscosity_law != OVR_ROELANDS ||
        oil->density_law != OVR_DOWSON_HIGGINSON)
        return (ovr_film_fit){NAN, NAN};
    return ovr_film_fitted(contact->M, contact->L, ovr_density(oil, 1));
}

/* Reduced radius and half width over the run, where it says how long that is.
 */
static void put_radius(const ovr_setup *setup)
{
    enum { LOOKS = 1000 };
    const ovr_contact *contact = setup->contact;
    double R[2] = {INFINITY, 0}, b[2] = {INFINITY, 0};
    if (!ovr_history_varies(setup->radius) || !isfinite(setup->march->end))
        return;
    for (int k = 0; k <= LOOKS; k++) {
        double T = setup->march->end * k / LOOKS;
        double r = ovr_history_value(setup->radius, T);
        double half = sqrt(ovr_history_value(setup->load, T) * r);
        R[0] = fmin(R[0], r);
        R[1] = fmax(R[1], r);
        b[0] = fmin(b[0], half);
        b[1] = fmax(b[1], half);
    }
    printf("# %-28s %.4g to %.4g of the nominal one", "radius in time", R[0],
           R[1]);
    if (isfinite(contact->radius))
        printf(", %.4g to %.4g mm", R[0] * contact->radius * 1e3,
               R[1] * contact->radius * 1e3);
    printf("; half width %.3g to %.3g b\n", b[0], b[1]);
    printf("# %-28s %s\n", "its curvature",
           setup->rides ? "rides with the material" : "is imposed");
}

static void put_films(const ovr_contact *contact)
{
    ovr_film_asymptotes film = ovr_film_asymptotes_moes(contact->M, contact->L);
    put_film("central film (Moes)",
             ovr_film_central_moes(contact->M, contact->L), contact);
    puts("#   of an incompressible oil; asymptotes of it:");
    put_film("  rigid, isoviscous", film.rigid_iso, contact);
    put_film("  elastic, isoviscous", film.elastic_iso, contact);
    put_film("  rigid, piezoviscous", film.rigid_piezo, contact);
    put_film("  elastic, piezoviscous", film.elastic_piezo, contact);
}

/* alpha, and alpha* beside it. */
static void put_alpha(const ovr_setup *setup)
{
    const ovr_contact *contact = setup->contact;
    double star = ovr_asymptotic_alphabar(setup->lubricant) / contact->ph;
    if (!(contact->alpha > 0) || !isfinite(star))
        return;
    printf("# %-28s %.5g 1/GPa, asymptotic alpha* = %.5g 1/GPa\n",
           "alpha at p = 0", contact->alpha * 1e9, star * 1e9);
}

/* Of the oil that it was fitted for alone. */
static void put_fit(const ovr_setup *setup)
{
    const ovr_contact *contact = setup->contact;
    const ovr_lubricant *oil = setup->lubricant;
    ovr_film_fit fit = fitted(setup);
    if (isnan(fit.central))
        return;
    put_film("central film (fit)", fit.central, contact);
    put_film("minimum film (fit)", fit.minimum, contact);
    printf("#   of a compressible oil, density %.4g at ph, flooded, steady: to "
           "2.6 and 1.7 %%\n",
           ovr_density(oil, 1));
}

static void put_lubricant(const ovr_lubricant *lubricant)
{
    static const char *const laws[] = {"", "Eyring", "Carreau", "Carreau",
                                       "flow law by table"};
    if (lubricant->viscosity_law == OVR_ROELANDS)
        printf("# %-28s z = %.6g, p0/ph = %.6g\n", "Roelands", lubricant->z,
               lubricant->P0);
    if (lubricant->rheology != OVR_NEWTONIAN)
        printf("# %-28s tau0/(ph b/R) = %.6g\n", laws[lubricant->rheology],
               lubricant->Sigma0);
}

/* " (1.2 um)", or nothing where the scale is not known. */
static ovr_piece in_metres(double value, double scale)
{
    ovr_piece piece = {""};
    if (isfinite(value) && isfinite(scale))
        snprintf(piece.text, sizeof piece.text, " (%.30s)",
                 ovr_metres(value * scale).text);
    return piece;
}

static ovr_piece at_time(double T, const ovr_contact *contact)
{
    const double rounding = 1e-12;
    ovr_piece piece;
    const char *text;
    if (fabs(T) < rounding)
        T = 0;
    const ovr_piece si = ovr_physical(T, OVR_KIND_TIME, contact);
    text = si.text;
    snprintf(piece.text, sizeof piece.text, "T = %.4g%s%.18s%s", T,
             *text ? " (" : "", text, *text ? ")" : "");
    return piece;
}

/* Where it comes in, passes and leaves, as far as that comes to pass. */
static void put_passage(const ovr_setup *setup, size_t k)
{
    const ovr_options *o = setup->options;
    double end = setup->march->end;
    ovr_feature_times t = ovr_surfaces_times(setup->surfaces, k, o->inlet,
                                             o->outlet, 1e5);
    const struct {
        const char *what;
        double T;
    } events[] = {{"enters", t.enters},
                  {"its centre passes X = 0", t.centre},
                  {"has left", t.leaves}};
    const char *before = "#   ";
    for (int i = 0; i < 3; i++)
        if (isfinite(events[i].T)) {
            printf("%s%s at %s%s", before, events[i].what,
                   at_time(events[i].T, setup->contact).text,
                   events[i].T > end ? " (after the end)" : "");
            before = ", ";
        }
    if (*before == ',')
        putchar('\n');
}

/* Speed over the mean one, in words. */
static const char *motion(double speed, char *text, size_t room)
{
    if (speed == 0)
        return "stands still";
    if (fabs(speed - 1) < 1e-6)
        return "moves with the mean speed";
    snprintf(text, room, "moves at %.4g of the mean speed", speed);
    return text;
}

static void put_features(const ovr_setup *setup)
{
    char moves[60];
    size_t n = setup->surfaces ? ovr_surfaces_count(setup->surfaces) : 0;
    for (size_t k = 0; k < n; k++) {
        ovr_feature_info info = ovr_surfaces_info(setup->surfaces, k);
        printf("# feature %s: %s on surface %d, %s, height %.4g%s, ", info.name,
               ovr_shape_name((int)info.shape), info.surface,
               motion(info.speed, moves, sizeof moves), info.amplitude,
               in_metres(info.amplitude, setup->contact->height).text);
        if (info.diameter > 0)
            printf("diameter at half depth %.4g%s, ", info.diameter,
                   in_metres(info.diameter, setup->contact->b).text);
        printf("shortest wavelength %.4g%s, on %.4g nodes\n", info.wavelength,
               in_metres(info.wavelength, setup->contact->b).text,
               info.wavelength / setup->mesh);
        if (setup->transient)
            put_passage(setup, k);
        for (const char *s = info.assumed; s && *s;) {
            size_t length = strcspn(s, "\n");
            printf("#   %.*s\n", (int)length, s);
            s += length + (s[length] == '\n');
        }
    }
}

/* What amplitude reduction says of them before they are run. */
static void put_rough_film(const ovr_setup *setup, const ovr_rough_film *film)
{
    const ovr_contact *c = setup->contact;
    if (!setup->features)
        return;
    if (film->why) {
        printf("# %-28s no estimate: %s\n", "film of rough surfaces",
               film->why);
        return;
    }
    printf("# %-28s Rq = %.4g%s", "roughness of the film", film->film_Rq,
           in_metres(film->film_Rq, c->height).text);
    printf(" of %.4g%s on the surfaces\n", film->Rq,
           in_metres(film->Rq, c->height).text);
    put_film("smallest film", film->H_min, c);
    puts("#   foreseen by amplitude reduction, of rolling waves: both to 2 %, "
         "seldom 12 %, of Rq\n#   and of the smooth minimum film");
    if (film->but)
        printf("#   less sure here: %s\n", film->but);
}

/* Bodies that roll one behind the other. */
static void put_bodies(const ovr_setup *setup)
{
    const ovr_passes_setup *p = setup->passes;
    const ovr_contact *c = setup->contact;
    const double speed = p->again == 2 ? c->u2_ratio : c->u1_ratio;
    double way = p->spacing / speed, most = 0;
    for (size_t k = 0; k < p->loads.count; k++)
        most = fmax(most, p->loads.values[k]);
    if (most > 0)
        printf("# %-28s %.4g of the nominal load at most\n", "load zone", most);
    if (isfinite(way))
        printf("# %-28s %.4g%s behind each other, %s\n", "rolling bodies",
               p->spacing, in_metres(p->spacing, c->b).text,
               at_time(way, c).text);
    if (isfinite(p->recovery))
        printf("# %-28s %.3g %% of what lacks to a flooded layer, in that "
               "time\n",
               "oil that flows back", 100 * -expm1(-way / p->recovery));
}

/* `ends`: at a given time, whatever happens. */
static void put_cost(const estimate *cost, const ovr_setup *setup, bool ends)
{
    const char *const of[] = {"H_cen", "H_min", "what the features do"};
    printf("# %-28s level %d, %.0f nodes, mesh D = %.6g%s, X = %g to %g\n",
           "grid", setup->options->level, cost->nodes, cost->mesh,
           in_metres(cost->mesh, setup->contact->b).text, setup->options->inlet,
           setup->options->outlet);
    if (setup->options->refine && setup->options->refine_level)
        printf("# %-28s about the spike, to level %d, mesh %.3g\n", "patches",
               setup->options->refine_level,
               ldexp(cost->mesh,
                     setup->options->level - setup->options->refine_level));
    else if (setup->options->refine)
        printf("# %-28s about the spike, until its height changes by less than "
               "%g\n",
               "patches", setup->options->refine_change);
    printf("# %-28s %.1g of %s is to be expected\n", "error of discretization",
           setup->expected, of[setup->accuracy_of]);
    if (cost->passes > 1)
        printf("# %-28s %.0f, a run and a result file each; all below is of "
               "one but for the disk and the seconds\n",
               "passes", cost->passes);
    if (cost->passes > 1)
        put_bodies(setup);
    if (cost->steps > 0)
        printf("# %-28s %s%.0f\n", "steps", ends ? "" : "at most ",
               cost->steps);
    if (cost->steps > 0)
        printf("# %-28s %.0f, at most %.3g MB on the disk\n", "snapshots",
               cost->stored.snapshots, cost->stored.bytes / 1e6);
    printf("# %-28s about %.2g s and %.3g MB of memory\n", "cost",
           cost->seconds, cost->bytes / 1e6);
}

static void put_line(void *data, const char *name, const char *text)
{
    (void)data;
    printf("# %-28s %s\n", name, text);
}

/* ------------------------------------------------------------------- JSON */

static void json_parameters(json_writer *json, const ovr_case *c)
{
    json_open_array(json, "parameters");
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (!entry.text)
            continue;
        json_open(json, NULL);
        json_text(json, "section", entry.section);
        if (entry.name)
            json_text(json, "name", entry.name);
        json_text(json, "key", entry.key);
        json_text(json, "text", entry.text);
        json_number(json, "value", entry.number);
        json_text(json, "unit", entry.unit);
        json_flag(json, "given", entry.given);
        json_close(json);
    }
    json_close_array(json);
}

static void report_json(const ovr_case *c, const ovr_setup *setup,
                        const ovr_rough_film *film, const estimate *cost)
{
    const ovr_options *options = setup->options;
    json_writer json = json_begin(stdout);
    ovr_setup_scales(setup, cli_put_line, &json);
    if (setup->features)
        ovr_rough_film_summary(film, setup->contact, cli_put_line, &json);
    json_integer(&json, "level", options->level);
    json_number(&json, "nodes", cost->nodes);
    json_number(&json, "mesh", cost->mesh);
    json_number(&json, "expected_error", setup->expected);
    json_number(&json, "inlet", options->inlet);
    json_number(&json, "outlet", options->outlet);
    json_text(&json, "scheme", ovr_scheme_name(options->scheme));
    json_text(&json, "smoother", ovr_smoother_name(options->smoother));
    json_flag(&json, "transient", setup->transient);
    json_number(&json, "passes", cost->passes);
    json_number(&json, "steps", cost->steps);
    json_number(&json, "snapshots", cost->stored.snapshots);
    json_number(&json, "disk_bytes", cost->stored.bytes);
    json_number(&json, "memory_bytes", cost->bytes);
    json_number(&json, "estimated_seconds", cost->seconds);
    cli_json_stations(&json, setup);
    json_open_array(&json, "warnings");
    ovr_setup_review(setup, hear_json, &json);
    json_close_array(&json);
    json_parameters(&json, c);
    json_end(&json);
}

static void report(const cli_call *call, const ovr_case *c,
                   const ovr_setup *setup, const ovr_rough_film *film,
                   double live)
{
    estimate cost = estimate_cost(setup, live);
    if (call->json) {
        report_json(c, setup, film, &cost);
        return;
    }
    put_contact(setup->contact);
    put_radius(setup);
    cli_put_stations(setup);
    put_films(setup->contact);
    put_alpha(setup);
    put_fit(setup);
    put_lubricant(setup->lubricant);
    put_features(setup);
    put_rough_film(setup, film);
    put_cost(&cost, setup, !setup->march->until_steady);
    ovr_setup_tell(setup, put_line, NULL);
    put_parameters(c, setup);
}

static int run(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    ovr_setup *setup;
    ovr_error err = {0};
    ovr_rough_film film;
    double live = 0, depth;
    const ovr_allocator counted = {take, give, &live};
    if (!c)
        return code;
    setup = ovr_case_resolve(c, &counted, &err);
    if (setup && !ovr_setup_prepare(setup, &counted, &err) &&
        !ovr_setup_stress_depth(setup, &depth, &err) &&
        !ovr_setup_rough_film(setup, NULL, &film, &err)) {
        ovr_setup_review(setup, hear, call);
        report(call, c, setup, &film, live);
    } else {
        code = cli_fail(&err);
    }
    ovr_setup_free(setup);
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {CLI_CASE_OPTIONS, {0}};

const cli_verb cli_check = {
    .name = "check",
    .arguments = "[CASE]",
    .summary = "print what a case means; solve nothing",
    .help = "Prints the contact's numbers, film formulas and cost as comments "
            "and every\nparameter with its value; what is printed is itself a "
            "case.",
    .options = options,
    .least = 0,
    .most = 1,
    .run = run,
};
