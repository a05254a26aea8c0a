/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Layers on the bodies: [coating 1] is the topmost one of body 1, [coating 1b]
 * the one below it, and so on.
 *
 * Layers affect the film only by the elastic influence: images of the surface
 * (contact/layers.h), summed as in physics/coating/images.h. b, p_h, M and L
 * are those of homogeneous bodies with the same dry contact width at the same
 * load, so that the contact is [-1, 1] for any layers.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/rows.h"
#include "case/setup.h"
#include "physics/coating/images.h"
#include "physics/companion.h"
#include "results/results.h"
#include "simulation/conflicts.h"
#include "simulation/physics.h"

/* Limits of layers: error of the images of A(k), thickness in mesh sizes,
 * width of the contact relative to its scale, and strain. */
static const double FIT_MAX = 1e-5, MESH_MIN = 0.02, WIDTH_MAX = 3,
                    STRAIN_MAX = 0.1;

typedef struct coat {
    int material;
    double thickness; /* b */
    double modulus, poisson;
    ovr_thermal thermal;
    double residual[2]; /* ph */
    double yield;       /* ph; 0: unknown */
    double limit;       /* fatigue limit as a Hertzian pressure, in p_h */
    double strength;    /* strength of the interface below the layer, in the
                         * same unit */
} coat;

typedef struct coating_form {
    bool there[2][OVR_LAYERS_MAX];
    coat coat[2][OVR_LAYERS_MAX];
    ovr_layered body[2]; /* lengths in the first thickness */
    ovr_images images;
    ovr_warmed warmed[2]; /* times in b/um */
    ovr_coated coated[2]; /* lengths in b */
    double unit;          /* the first thickness, b */
    double stiffness;     /* E' relative to that of the substrates */
    double pressure;      /* maximum pressure of the dry contact, p_h */
    double width;         /* half-width of the dry contact, b */
} coating_form;

/* --------------------------------------------------------------- the case */

/*
 * Material data; NAN where no source is known.  DLC, hydrogenated (a-C:H, 20
 * at% H): modulus and density Nat. Commun. 12 (2021), s41467-021-24766-6, table
 * 1; conductivity 0.3 to 1 W/m.K, Morath et al., J. Appl. Phys. 1994
 * (picosecond optics), 1 of hard hydrogenated carbon, Shamsa et al., Appl.
 * Phys. Lett. 2006 (3 omega); capacity Moelle et al., Diamond Relat. Mater. 7
 * (1998) 499. Babbitt: MakeItFrom.com, Grade 1 (L13910) Tin-Base Babbitt Metal.
 * PTFE: NETZSCH Analyzing & Testing, Polymers: PTFE, the middles of its ranges.
 */
enum { DLC = 1, BABBITT, PTFE };

static const ovr_word material_words[] = {
    {"dlc", DLC}, {"babbitt", BABBITT}, {"ptfe", PTFE}, {NULL, 0}};

static const coat materials[] = {
    [DLC] = {.modulus = 259e9, .poisson = NAN, .thermal = {1, 1040, 2070}},
    [BABBITT] = {.modulus = 53e9, .poisson = 0.35, .thermal = {45, 230, 7300}},
    [PTFE] = {.modulus = 575e6, .poisson = NAN, .thermal = {0.24, 1000, 2180}},
};

static const ovr_word no_yield[] = {{"none", 0}, {NULL, 0}};

static const ovr_parameter keys[] = {
    {"material", CHOICE(material_words), NULL, offsetof(coat, material), true,
     ALWAYS,
     "material of the layer, which supplies the properties that are "
     "not set"},
    {"thickness", OVR_NUMBER, OVR_LENGTH, OVR_IN_B, 0, 1e4, true, .words = NULL,
     NULL, offsetof(coat, thickness), true, ALWAYS, "thickness of the layer"},
    {"modulus", WITH_UNIT(OVR_PRESSURE, 1e3, 1e13), NULL,
     offsetof(coat, modulus), true, ALWAYS, "Young's modulus of the layer"},
    {"poisson", PLAIN(0, 0.5), NULL, offsetof(coat, poisson), true, ALWAYS,
     "Poisson's ratio of the layer; default: that of the material, otherwise "
     "0.3"},
    {"conductivity", WITH_UNIT(OVR_CONDUCTIVITY, 1e-3, 1e4), NULL,
     offsetof(coat, thermal.conductivity), true, "heat.model = lobatto",
     "thermal conductivity of the layer"},
    {"heat_capacity", WITH_UNIT(OVR_HEAT_CAPACITY, 1, 1e30), NULL,
     offsetof(coat, thermal.heat_capacity), true, "heat.model = lobatto",
     "specific heat capacity of the layer"},
    {"density", WITH_UNIT(OVR_MASS_DENSITY, 100, 1e5), NULL,
     offsetof(coat, thermal.density), true, "heat.model = lobatto",
     "density of the layer"},
    {"residual_x", STRESS(NULL, -100, 100), "0", offsetof(coat, residual[0]),
     true, "[stress]",
     "residual stress in the layer along the surface, tension positive"},
    {"residual_y", STRESS(NULL, -100, 100), "0", offsetof(coat, residual[1]),
     true, "[stress]",
     "residual stress in the layer across rolling, tension positive"},
    {"yield", STRESS(no_yield, 0, 1e4), "none", offsetof(coat, yield), false,
     "[stress]",
     "yield stress (von Mises) of the layer; the utilization is reported"},
    {"limit_pressure", STRESS(no_yield, 0, 1e3), "none", offsetof(coat, limit),
     false, "[fatigue]",
     "fatigue limit of the layer, as maximum Hertzian pressure of a smooth "
     "contact; the utilization is reported"},
    {"interface_strength", STRESS(no_yield, 0, 1e4), "none",
     offsetof(coat, strength), false, "[stress]",
     "shear strength of the interface below the layer; the utilization is "
     "reported"},
};

static const ovr_section section = {
    .name = "coating",
    .named = true,
    .help = "[coating 1], [coating 1b], ... [coating 2], ...: layers on body 1 "
            "or 2 from the surface down, bonded; both bodies need a modulus",
    ROWS(keys)};

static ovr_status block(void *form, const char *name, void **into,
                        ovr_error *err)
{
    coating_form *f = form;
    int body = name[0] - '1';
    int layer = name[0] && name[1] ? name[1] - 'a' : 0;
    bool known = (body == 0 || body == 1) && layer >= 0 &&
                 layer < OVR_LAYERS_MAX && (!name[1] || layer > 0) &&
                 !(name[1] && name[2]);
    if (!known)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "[coating %.20s]: must be [coating 1], [coating 1b] "
                        "to [coating 1%c] for the layers of body 1 from the "
                        "surface down, or the same with 2 for body 2",
                        name, 'a' + OVR_LAYERS_MAX - 1);
    f->there[body][layer] = true;
    f->coat[body][layer] = (coat){.thickness = NAN,
                                  .modulus = NAN,
                                  .poisson = NAN,
                                  .thermal = {NAN, NAN, NAN}};
    *into = &f->coat[body][layer];
    return OVR_OK;
}

/* Name of a layer in error messages ("1", "1b"); static memory. */
static const char *name_of(int body, int layer)
{
    static const char *const names[2][OVR_LAYERS_MAX] = {
        {"1", "1b", "1c", "1d", "1e", "1f"},
        {"2", "2b", "2c", "2d", "2e", "2f"}};
    return names[body][layer];
}

static void fill(double *value, double otherwise)
{
    if (isnan(*value))
        *value = otherwise;
}

/* Sets missing properties from the material. */
static void complete(coat *c)
{
    const coat *of = &materials[c->material];
    if (c->material) {
        fill(&c->modulus, of->modulus);
        fill(&c->poisson, of->poisson);
        fill(&c->thermal.conductivity, of->thermal.conductivity);
        fill(&c->thermal.heat_capacity, of->thermal.heat_capacity);
        fill(&c->thermal.density, of->thermal.density);
    }
    fill(&c->poisson, 0.3);
}

static void complete_all(coating_form *f)
{
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < OVR_LAYERS_MAX; j++)
            if (f->there[k][j])
                complete(&f->coat[k][j]);
}

static ovr_status check_layer(const coating_form *f, int body, int layer,
                              ovr_error *err)
{
    const char *name = name_of(body, layer);
    const coat *c = &f->coat[body][layer];
    if (layer > 0 && !f->there[body][layer - 1])
        return ovr_fail_about(err, name,
                              "[coating %s] lies below [coating %s], which is "
                              "missing",
                              name, name_of(body, layer - 1));
    if (isnan(c->thickness) || isnan(c->modulus))
        return ovr_fail_about(err, name, "%s is missing in [coating %s]",
                              isnan(c->thickness) ? "thickness" : "modulus",
                              name);
    return OVR_OK;
}

static ovr_status check_case(const ovr_physics_case *of, coating_form *f,
                             ovr_error *err)
{
    complete_all(f);
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < OVR_LAYERS_MAX; j++)
            if (f->there[k][j] && check_layer(f, k, j, err))
                return OVR_BAD_INPUT;
    for (int k = 0; k < 2; k++)
        if (isnan(of->body[k].modulus))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "[coating] needs the modulus of both bodies; set "
                            "modulus or material in [body %d] (the reduced "
                            "modulus is not sufficient)",
                            k + 1);
    return OVR_OK;
}

/* Converts the layers to units of the first thickness; returns true if anything
 * has changed. */
static bool lay(const ovr_physics_case *of, coating_form *f)
{
    ovr_layered now[2] = {{0}};
    bool other = false;
    f->unit = f->there[0][0] ? f->coat[0][0].thickness
                             : f->coat[1][0].thickness;
    for (int k = 0; k < 2; k++) {
        const ovr_physics_body *body = &of->body[k];
        now[k].below = (ovr_elastic){body->modulus, body->poisson};
        for (int j = 0; j < OVR_LAYERS_MAX && f->there[k][j]; j++) {
            const coat *c = &f->coat[k][j];
            now[k].thickness[j] = c->thickness / f->unit;
            now[k].layer[j] = (ovr_elastic){c->modulus, c->poisson};
            other |= fabs(now[k].thickness[j] - f->body[k].thickness[j]) >
                     1e-9 * now[k].thickness[j];
            now[k].layers++;
        }
    }
    if (other)
        memcpy(f->body, now, sizeof now);
    return other;
}

/* Computes the dry contact and the quantities that depend on it. */
static void scale(coating_form *f, bool by_substrate)
{
    double a = by_substrate ? ovr_images_half_width(&f->images, 1 / f->unit)
                            : 1 / f->unit;
    ovr_layered_hertz dry = ovr_images_dry(&f->images, a);
    f->width = a * f->unit;
    f->stiffness = by_substrate ? 1 : dry.stiffness;
    f->pressure = dry.pressure / f->width;
}

static ovr_status stiffness(const ovr_physics_case *of, void *form,
                            double *ratio, ovr_error *err)
{
    coating_form *f = form;
    double before = f->unit;
    bool other;
    if (check_case(of, f, err))
        return OVR_BAD_INPUT;
    other = lay(of, f);
    if (other)
        ovr_images_fit(f->body, &f->images);
    if (f->images.error > FIT_MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "[coating]: the compliance of these layers is "
                        "approximated only to a relative error of %.1g, "
                        "because moduli or thicknesses differ too much from "
                        "one layer to the next",
                        f->images.error);
    if (other || f->unit != before)
        scale(f, of->by_substrate);
    *ratio = f->stiffness;
    return OVR_OK;
}

/* Returns the compression of a layer relative to its thickness: the approach
 * b^2/2R of the surfaces divided by the thickness, limited by the modulus of
 * the layer. */
static double strain(const ovr_physics_case *of, const coating_form *f, int k,
                     int j)
{
    const coat *c = &f->coat[k][j];
    const ovr_contact *contact = of->contact;
    return fmin(contact->kappa / (2 * c->thickness),
                f->pressure * contact->ph / c->modulus);
}

/* Reads the thermal properties of every layer. */
static ovr_status warm(const ovr_physics_case *of, coating_form *f,
                       ovr_error *err)
{
    for (int k = 0; k < 2; k++) {
        ovr_thermal all[OVR_LAYERS_MAX];
        double thickness[OVR_LAYERS_MAX];
        int layers = f->body[k].layers;
        for (int j = 0; j < layers; j++) {
            const ovr_thermal *of_layer = &f->coat[k][j].thermal;
            const char *name = name_of(k, j);
            if (isnan(of_layer->conductivity) || isnan(of_layer->density) ||
                isnan(of_layer->heat_capacity))
                return ovr_fail_about(
                    err, name,
                    "[coating %s] needs conductivity, heat_capacity and "
                    "density, because [heat] is on",
                    name);
            all[j] = *of_layer;
            thickness[j] = f->coat[k][j].thickness * of->contact->b;
        }
        f->warmed[k] = ovr_warmed_of(layers, thickness, all,
                                     &of->body[k].thermal);
        for (int j = 0; j < layers; j++)
            f->warmed[k].tau[j] /= of->contact->time;
    }
    return OVR_OK;
}

static double largest_strain(const ovr_physics_case *of, const coating_form *f)
{
    double maximum = 0;
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < f->body[k].layers; j++)
            maximum = fmax(maximum, strain(of, f, k, j));
    return maximum;
}

static void measure(const ovr_physics_case *of, coating_form *f)
{
    double maximum = largest_strain(of, f);
    for (int k = 0; k < 2; k++) {
        f->coated[k] = (ovr_coated){.body = f->body[k],
                                    .images = f->images,
                                    .stiffness = f->stiffness,
                                    .width = f->width,
                                    .pressure = f->pressure,
                                    .strain = maximum};
        ovr_images_scale(&f->coated[k].images, f->stiffness, f->unit);
        for (int j = 0; j < f->body[k].layers; j++) {
            f->coated[k].body.thickness[j] = f->coat[k][j].thickness;
            f->coated[k].body.yield[j] = f->coat[k][j].yield;
            f->coated[k].body.limit[j] = f->coat[k][j].limit;
            f->coated[k].body.strength[j] = f->coat[k][j].strength;
            for (int along = 0; along < 2; along++)
                f->coated[k].residual[2 * j + along] =
                    f->coat[k][j].residual[along];
        }
    }
}

/* A stiff layer on a soft one distributes its load like a plate. The
 * corresponding errors are long waves, which only a finer coarsest grid
 * corrects. */
static void refine_coarsest(const ovr_physics_case *of, const coating_form *f)
{
    const double like_a_plate = 3, highly_loaded = 90;
    ovr_options *o = of->options;
    int finer = of->contact->M >= highly_loaded ? 6 : 5;
    double maximum = 0;
    for (double k = 1e-2; k < 1e2; k *= 1.3)
        maximum = fmax(maximum, ovr_images_softness(&f->images, k));
    if (maximum > like_a_plate * f->images.top && !o->coarsest_level)
        o->coarsest_level = o->level && o->level < finer ? o->level : finer;
}

static ovr_status resolve(const ovr_physics_case *of, void *form, bool *on,
                          ovr_error *err)
{
    coating_form *f = form;
    *on = f->images.top > 0;
    if (!*on)
        return OVR_OK;
    complete_all(f);
    measure(of, f);
    if (of->physics & OVR_PHYSICS_HEAT && warm(of, f, err))
        return OVR_BAD_INPUT;
    if (f->width > WIDTH_MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "[coating]: contact.scale = substrate is not suitable, "
                        "because the contact is %.3g times as wide as that of "
                        "the substrates; set contact.scale = dry",
                        f->width);
    if (of->contact->kappa / 4 > STRAIN_MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "[coating]: p_h is %.2g of the modulus E', which is "
                        "beyond the small-strain model; reduce the load",
                        of->contact->kappa / 4);
    /* Interpolation of lower order would be less accurate than the fit of the
     * images */
    if (!of->options->mlmi_order)
        of->options->mlmi_order = 12;
    if (!of->options->mlmi_range)
        of->options->mlmi_range = 16;
    refine_coarsest(of, f);
    return OVR_OK;
}

/* Rejects layers that the mesh does not resolve. */
static ovr_status on_mesh(const ovr_physics_case *of, void *form, double mesh,
                          ovr_error *err)
{
    const coating_form *f = form;
    (void)of;
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < f->body[k].layers; j++)
            if (f->coat[k][j].thickness < MESH_MIN * mesh)
                return ovr_fail_about(
                    err, name_of(k, j),
                    "[coating %s] is %.2g mesh sizes thick, must be at least "
                    "%g: use a finer domain.level, or remove the section",
                    name_of(k, j), f->coat[k][j].thickness / mesh, MESH_MIN);
    return OVR_OK;
}

static void report_layer(const ovr_physics_case *of, const coating_form *f,
                         int k, int j, ovr_physics_line *line, void *data)
{
    double t = f->coat[k][j].thickness;
    const ovr_options *o = of->options;
    double D = (o->outlet - o->inlet) / (double)(ovr_level_nodes(o->level) - 1);
    char name[40], text[160];
    size_t used;
    snprintf(name, sizeof name, "coating %s", name_of(k, j));
    used = (size_t)snprintf(text, sizeof text, "thickness %.3g b", t);
    if (o->level > 0 && o->outlet > o->inlet)
        used += (size_t)snprintf(text + used, sizeof text - used, " = %.3g D",
                                 t / D);
    if (strain(of, f, k, j) > STRAIN_MAX)
        snprintf(text + used, sizeof text - used,
                 "; strains of %.2g are not small", strain(of, f, k, j));
    line(data, name, text);
}

static void report(const ovr_physics_case *of, const void *form,
                   ovr_physics_line *line, void *data)
{
    const coating_form *f = form;
    char text[200];
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < f->body[k].layers; j++)
            report_layer(of, f, k, j, line, data);
    snprintf(text, sizeof text,
             "E' %.4g GPa, substrates %.4g GPa; relative error of the "
             "compliance %.1g",
             of->contact->modulus / 1e9, of->substrate / 1e9, f->images.error);
    line(data, "effective modulus", text);
    snprintf(text, sizeof text, "half-width %.4g b, maximum pressure %.4g p_h",
             f->width, f->pressure);
    line(data, "dry contact with coating", text);
}

/* --------------------------------------------------------------- simulation */

typedef struct coating {
    const coating_form *given;
    ovr_physics_case of;
    ovr_image_sum sum;
} coating;

static ovr_status create(ovr_simulation *sim, const void *form, void **own,
                         ovr_error *err)
{
    coating *c = ovr_arena_take(&sim->arena, 1, sizeof *c, err);
    if (!c)
        return OVR_NO_MEMORY;
    *own = c;
    c->given = form;
    return OVR_OK;
}

/* The table starts at a distance that is large on the finest grid and ends
 * beyond the largest distance. Ghost nodes of the coarsest grids are up to a
 * domain length outside. */
static void influence(const ovr_simulation *sim, void *own, ovr_influence *of)
{
    coating *c = own;
    const coating_form *f = c->given;
    double whole = sim->options.outlet - sim->options.inlet;
    double D = whole / (double)(sim->finest->grid.n - 1);
    if (sim->arena.blank)
        return;
    ovr_image_sum_make(&c->sum, &f->images, f->stiffness, f->unit, 60 * D,
                       4 * whole);
    ovr_influence_add(of, ovr_image_part(&c->sum));
}

static double warmth_at(const void *data, double t)
{
    return ovr_warmed_at(data, t);
}

static void warmth(const ovr_simulation *sim, const void *own, int k,
                   ovr_warmth *to)
{
    const coating_form *f = ((const coating *)own)->given;
    (void)sim;
    if (f->body[k].layers)
        *to = (ovr_warmth){warmth_at, &f->warmed[k]};
}

static const ovr_coated *layers(const void *form, int body)
{
    const ovr_coated *coated = &((const coating_form *)form)->coated[body];
    return coated->body.layers ? coated : NULL;
}

static void effects(const void *form, ovr_physics_effects *effects)
{
    (void)form;
    effects->features = ovr_model_feature_bit(OVR_MODEL_COATING, true);
}

/* ------------------------------------------------------- Companion of a run */

static const ovr_coated *coated_of(const ovr_setup *setup)
{
    const ovr_coated *first = ovr_setup_layers(setup, 0);
    return first ? first : ovr_setup_layers(setup, 1);
}

static void review_before(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const double small = 0.1;
    const ovr_coated *of = coated_of(setup);
    if (!of || !(of->strain > small))
        return;
    ovr_warn(say, data,
             "strain of a layer reaches about %.2g; the model holds for small "
             "strains only",
             of->strain);
}

/* Writes the data of the layers: A_top, and depths and weights of the images
 * that sum up to the compliance A(k). */
static ovr_status open_file(void *own, const ovr_accompanied_run *run,
                            ovr_error *err)
{
    const ovr_coated *of = coated_of(run->setup);
    const ovr_images *images = &of->images;
    const ovr_group_axis depth = {"image_depth", "depth of an image",
                                  OVR_KIND_LENGTH, (size_t)images->count,
                                  images->depth};
    const ovr_group_array weight = {.name = "image_weight",
                                    .long_name = "weight of an image",
                                    .kind = OVR_KIND_NUMBER,
                                    .rank = 1,
                                    .along = {0},
                                    .doubles = images->weight};
    const ovr_group_attribute about[] = {
        {"softness_top", NULL, images->top},
        {"image_error", NULL, images->error},
        {"modulus_over_substrates", NULL, of->stiffness},
        {"dry_half_width", NULL, of->width},
        {"dry_pressure", NULL, of->pressure}};
    size_t some = images->count > 0;
    const ovr_group group = {
        "coating", some,    some, sizeof about / sizeof *about,
        &depth,    &weight, about};
    (void)own;
    return ovr_writer_group(run->writer, &group, true, err);
}

static const ovr_companion companion = {.review_before = review_before,
                                        .open = open_file};

static const ovr_physics_in_case in_case = {.node_seconds = 5e-8,
                                            .section = &section,
                                            .sections = 1,
                                            .form = sizeof(coating_form),
                                            .block = block,
                                            .stiffness = stiffness,
                                            .resolve = resolve,
                                            .layers = layers,
                                            .effects = effects,
                                            .describe = report,
                                            .on_mesh = on_mesh};

static const ovr_physics_in_solve in_solve = {
    .take = create, .influence = influence, .warmth = warmth};

static const ovr_physics_in_output in_output = {.companion = &companion};

const ovr_physics ovr_physics_coating = {.name = "layers on the bodies",
                                         .in_case = &in_case,
                                         .in_solve = &in_solve,
                                         .in_output = &in_output};
